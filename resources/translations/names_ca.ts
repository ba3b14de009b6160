<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ca" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>%1 triangles instead of %2; the old surface lies %3 mm from the new one on average, %4 mm at most</source>
        <translation>%1 triangles en lloc de %2; la superfície antiga dista de la nova %3 mm de mitjana i %4 mm com a màxim</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>%1 and %2 are at one place: %3 from each other</source>
        <translation>%1 i %2 són al mateix lloc: a %3 l’un de l’altre</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 i %2 més</translation>
    </message>
    <message>
        <source>%1 at %2 % of the cycle: %3</source>
        <translation>%1 al %2 % del cicle: %3</translation>
    </message>
    <message>
        <source>%1 gives another surface than the one that was saved</source>
        <translation>%1 dona una superfície diferent de la desada</translation>
    </message>
    <message>
        <source>%1 has changed since the session was saved</source>
        <translation>%1 ha canviat des que es va desar la sessió</translation>
    </message>
    <message>
        <source>%1 has no volume in %2</source>
        <translation>%1 no té volum a la %2</translation>
    </message>
    <message>
        <source>%1 has no voxels any more</source>
        <translation>%1 ja no té vòxels</translation>
    </message>
    <message>
        <source>%1 has other triangles in %2 than in the first: surfaces are fitted by their distances, which do not see motion along the wall</source>
        <translation>%1 té a la %2 altres triangles que a la primera: les superfícies s’ajusten per les seves distàncies, que no veuen el moviment al llarg de la paret</translation>
    </message>
    <message>
        <source>%1 ml cannot be reached</source>
        <translation>no es poden assolir %1 ml</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates</source>
        <translation>%1 de %2 vèrtexs no tenen coordenades</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates in the cage</source>
        <translation>%1 de %2 vèrtexs no tenen coordenades a la gàbia</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie in no group's region</source>
        <translation>%1 de %2 vèrtexs no són a la regió de cap grup</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 de més d’1 GB no cap en un fitxer de sessió</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm around %7, %8, %9</source>
        <translation>%1 x %2 x %3 vòxels de %4 x %5 x %6 mm al voltant de %7; %8; %9</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2 and not in others, so that its volumes would be cut off</source>
        <translation>%1 toca la vora de la imatge a la %2 i no en d’altres, de manera que els seus volums quedarien retallats</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2: what lies beyond is not in its volume</source>
        <translation>%1 toca la vora de la imatge a la %2: el que queda fora no és al seu volum</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in every phase: what lies beyond is not in its volume</source>
        <translation>%1 toca la vora de la imatge en totes les fases: el que queda fora no és al seu volum</translation>
    </message>
    <message numerus="yes">
        <source>%2, %n of them {is a small fragment|are small fragments} of less than 2 % of its area</source>
        <translation>
            <numerusform>%2, %n de les quals és un petit fragment de menys del 2 % de la seva àrea</numerusform>
            <numerusform>%2, %n de les quals són petits fragments de menys del 2 % de la seva àrea</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modificat</translation>
    </message>
    <message>
        <source>%1, handle %2</source>
        <translation>%1, tirador %2</translation>
    </message>
    <message>
        <source>%1, handles %2 and %3</source>
        <translation>%1, tiradors %2 i %3</translation>
    </message>
    <message>
        <source>%1, key at %2 s</source>
        <translation>%1, clau a %2 s</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línia %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 lie outside the handles' hull, by up to %3 mm</source>
        <translation>%1: %2 són fora de l’envolupant dels tiradors, fins a %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n {hole|holes} closed by {a flat cap|flat caps}</source>
        <translation>
            <numerusform>%1: %n forat tancat amb una tapa plana</numerusform>
            <numerusform>%1: %n forats tancats amb tapes planes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1: «%2» és desconegut i no es tornarà a desar</translation>
    </message>
    <message>
        <source>%1: points that coincide in the first phase separate by up to %2 mm; Viscera keeps them together</source>
        <translation>%1: punts que coincideixen a la primera fase se separen fins a %2 mm; Viscera els manté junts</translation>
    </message>
    <message>
        <source>%1; it looks like %2</source>
        <translation>%1; sembla %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices were read, slices %3 to %4, which are even; the others, or all of them resampled, can be chosen as a series</source>
        <translation>s’han llegit %1 de %2 talls, del %3 al %4, que són regulars; els altres, o tots remostrejats, es poden triar com a sèrie</translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest</source>
        <translation>
            <numerusform>%2 peces, %n vòxel a part del més gran</numerusform>
            <numerusform>%2 peces, %n vòxels a part del més gran</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest left out</source>
        <translation>
            <numerusform>%2 peces, s’omet %n vòxel a part del més gran</numerusform>
            <numerusform>%2 peces, s’ometen %n vòxels a part del més gran</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; check whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
        <translation>
            <numerusform>%2 queda fora de l’exploració; comproveu que tots dos són del mateix pacient i fan servir els mateixos eixos (RAS o LPS)</numerusform>
            <numerusform>%2 queden fora de l’exploració; comproveu que tots són del mateix pacient i fan servir els mateixos eixos (RAS o LPS)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary {edge|edges}: the surface is open and has no volume</source>
        <translation>
            <numerusform>%n aresta de vora: la superfície és oberta i no té volum</numerusform>
            <numerusform>%n arestes de vora: la superfície és oberta i no té volum</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the end ignored</source>
        <translation>
            <numerusform>s’ignora %n byte després del final</numerusform>
            <numerusform>s’ignoren %n bytes després del final</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the last triangle ignored</source>
        <translation>
            <numerusform>s’ignora %n byte després de l’últim triangle</numerusform>
            <numerusform>s’ignoren %n bytes després de l’últim triangle</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge joins|edges join} more than two triangles</source>
        <translation>
            <numerusform>%n aresta uneix més de dos triangles</numerusform>
            <numerusform>%n arestes uneixen més de dos triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge lies|edges lie} between triangles of opposite orientation</source>
        <translation>
            <numerusform>%n aresta és entre triangles d’orientació oposada</numerusform>
            <numerusform>%n arestes són entre triangles d’orientació oposada</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {file is a copy|files are copies} of another one and left out</source>
        <translation>
            <numerusform>%n fitxer és còpia d’un altre i s’omet</numerusform>
            <numerusform>%n fitxers són còpies d’un altre i s’ometen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {file is|files are} damaged and left out (%2: %3)</source>
        <translation>
            <numerusform>%n fitxer està malmès i s’omet (%2: %3)</numerusform>
            <numerusform>%n fitxers estan malmesos i s’ometen (%2: %3)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is in no group and moves|handles are in no group and move} nothing</source>
        <translation>
            <numerusform>%n tirador no és en cap grup i no mou res</numerusform>
            <numerusform>%n tiradors no són en cap grup i no mouen res</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is|handles are} too few</source>
        <translation>
            <numerusform>%n tirador és massa poc</numerusform>
            <numerusform>%n tiradors són massa pocs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles}</source>
        <translation>
            <numerusform>%n tirador</numerusform>
            <numerusform>%n tiradors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} cannot form %2 groups</source>
        <translation>
            <numerusform>%n tirador no pot formar %2 grups</numerusform>
            <numerusform>%n tiradors no poden formar %2 grups</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} whose label another one has got a new one</source>
        <translation>
            <numerusform>%n tirador amb l’etiqueta d’un altre n’ha rebut una de nova</numerusform>
            <numerusform>%n tiradors amb l’etiqueta d’un altre n’han rebut una de nova</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} without a label got one</source>
        <translation>
            <numerusform>%n tirador sense etiqueta n’ha rebut una</numerusform>
            <numerusform>%n tiradors sense etiqueta n’han rebut una</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line or point cell|line or point cells} ignored</source>
        <translation>
            <numerusform>%n cel·la de línia o punt omesa</numerusform>
            <numerusform>%n cel·les de línia o punt omeses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line|lines} with points, curves or free-form surfaces ignored</source>
        <translation>
            <numerusform>s’ignora %n línia amb punts, corbes o superfícies de forma lliure</numerusform>
            <numerusform>s’ignoren %n línies amb punts, corbes o superfícies de forma lliure</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {mask is|masks are} empty (%2)</source>
        <translation>
            <numerusform>%n màscara és buida (%2)</numerusform>
            <numerusform>%n màscares són buides (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to repair the surface first</source>
        <translation>
            <numerusform>%n parell de triangles es travessa: el mode de tensió potser haurà de reparar abans la superfície</numerusform>
            <numerusform>%n parells de triangles es travessen: el mode de tensió potser haurà de reparar abans la superfície</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series of another echo left out</source>
        <translation>
            <numerusform>s’omet %n imatge de la sèrie d’un altre eco</numerusform>
            <numerusform>s’ometen %n imatges de la sèrie d’un altre eco</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series that {lies|lie} in another direction left out</source>
        <translation>
            <numerusform>s’omet %n imatge de la sèrie que és en una altra direcció</numerusform>
            <numerusform>s’ometen %n imatges de la sèrie que són en una altra direcció</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {place has|places have} more than one slice (%2); the one with the lowest number was read</source>
        <translation>
            <numerusform>%n posició té més d’un tall (%2); s’ha llegit el de número més baix</numerusform>
            <numerusform>%n posicions tenen més d’un tall (%2); s’ha llegit el de número més baix</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that repeats|points that repeat} another merged</source>
        <translation>
            <numerusform>%n punt que en repeteix un altre fusionat</numerusform>
            <numerusform>%n punts que en repeteixen d’altres fusionats</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point|points} without a triangle dropped</source>
        <translation>
            <numerusform>%n punt sense triangle omès</numerusform>
            <numerusform>%n punts sense triangle omesos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} no voxels (%2)</source>
        <translation>
            <numerusform>%n segment no té vòxels (%2)</numerusform>
            <numerusform>%n segments no tenen vòxels (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {set|sets} of points or lines ignored</source>
        <translation>
            <numerusform>s’ignora %n conjunt de punts o línies</numerusform>
            <numerusform>s’ignoren %n conjunts de punts o línies</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice is|slices are} missing between slice %2 (%3) and the next, which are %4 mm apart in place of %5 mm</source>
        <translation>
            <numerusform>falta %n tall entre el tall %2 (%3) i el següent, que disten %4 mm en lloc de %5 mm</numerusform>
            <numerusform>falten %n talls entre el tall %2 (%3) i el següent, que disten %4 mm en lloc de %5 mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle has|triangles have} no area</source>
        <translation>
            <numerusform>%n triangle no té àrea</numerusform>
            <numerusform>%n triangles no tenen àrea</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle was|triangles were} turned around to face outward.</source>
        <translation>
            <numerusform>%n triangle s’ha girat cap enfora.</numerusform>
            <numerusform>%n triangles s’han girat cap enfora.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle without area or that came twice is|triangles without area or that came twice are} left out.</source>
        <translation>
            <numerusform>S’omet %n triangle sense àrea o repetit.</numerusform>
            <numerusform>S’ometen %n triangles sense àrea o repetits.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} with a repeated corner dropped</source>
        <translation>
            <numerusform>%n triangle amb un vèrtex repetit omès</numerusform>
            <numerusform>%n triangles amb un vèrtex repetit omesos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex lies|vertices lie} outside the hull of the sequence's handles</source>
        <translation>
            <numerusform>%n vèrtex és fora de l’envolupant dels tiradors de la seqüència</numerusform>
            <numerusform>%n vèrtexs són fora de l’envolupant dels tiradors de la seqüència</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex|vertices} cannot be divided among %2 groups</source>
        <translation>
            <numerusform>%n vèrtex no es pot repartir entre %2 grups</numerusform>
            <numerusform>%n vèrtexs no es poden repartir entre %2 grups</numerusform>
        </translation>
    </message>
    <message>
        <source>0 starts from all ones, others from random numbers</source>
        <translation>0 parteix de pesos tots iguals a 1, els altres de nombres aleatoris</translation>
    </message>
    <message>
        <source>19 of 20 adults have %1 to %2 ml</source>
        <translation>19 de cada 20 adults tenen de %1 a %2 ml</translation>
    </message>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adult sa estirat.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Es perd una quarta part del volum de sang estressat; no respon cap reflex, de manera que les pressions baixen més que a la realitat.</translation>
    </message>
    <message>
        <source>A session cannot be opened beside another</source>
        <translation>Una sessió no es pot obrir al costat d’una altra</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Una sessió s’obre sola</translation>
    </message>
    <message>
        <source>A slice cannot be read, so the series is not opened: %1</source>
        <translation>No es pot llegir un tall, així que la sèrie no s’obre: %1</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Un ventricle esquerre rígid que es relaxa lentament: es buida bé i només s’omple a una pressió alta.</translation>
    </message>
    <message>
        <source>A ventricle's volume is not positive</source>
        <translation>El volum d’un ventricle no és positiu</translation>
    </message>
    <message>
        <source>A weak, dilated left ventricle and retained fluid: the loop lies far to the right, blood backs up to the lungs. Its wall has more muscle and is no thicker.</source>
        <translation>Un ventricle esquerre feble i dilatat i líquid retingut: el bucle és molt a la dreta, la sang s’acumula cap als pulmons. La paret té més múscul i no és més gruixuda.</translation>
    </message>
    <message>
        <source>A wire in the space of balanced vectors; for many points it has no answer</source>
        <translation>Un fil en l’espai dels vectors equilibrats; per a molts punts no té resposta</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Afegeix %1</translation>
    </message>
    <message numerus="yes">
        <source>Add %n {organ|organs}</source>
        <translation>
            <numerusform>Afegeix %n òrgan</numerusform>
            <numerusform>Afegeix %n òrgans</numerusform>
        </translation>
    </message>
    <message>
        <source>Add enclosing group</source>
        <translation>Afegeix un grup envoltant</translation>
    </message>
    <message>
        <source>Add enclosing handles</source>
        <translation>Afegeix tiradors envoltants</translation>
    </message>
    <message>
        <source>Add group %1</source>
        <translation>Afegeix el grup %1</translation>
    </message>
    <message>
        <source>Add to group</source>
        <translation>Afegeix al grup</translation>
    </message>
    <message numerus="yes">
        <source>Add {handle|%n handles}</source>
        <translation>
            <numerusform>Afegeix un tirador</numerusform>
            <numerusform>Afegeix %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Afterload: pulmonary resistance</source>
        <translation>Postcàrrega: resistència pulmonar</translation>
    </message>
    <message>
        <source>Afterload: systemic resistance</source>
        <translation>Postcàrrega: resistència sistèmica</translation>
    </message>
    <message>
        <source>An ejection fraction of %1 is out of range</source>
        <translation>Una fracció d’ejecció de %1 és fora de l’interval</translation>
    </message>
    <message>
        <source>An organ needs at least four handles around it: add %1 more</source>
        <translation>Un òrgan necessita almenys quatre tiradors al voltant: afegiu-ne %1 més</translation>
    </message>
    <message>
        <source>An organ needs handles around it</source>
        <translation>Un òrgan necessita tiradors al seu voltant</translation>
    </message>
    <message>
        <source>Antrum</source>
        <translation>Antre</translation>
    </message>
    <message>
        <source>Any point on the side of the right ventricle</source>
        <translation>Qualsevol punt del costat del ventricle dret</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorta</translation>
    </message>
    <message>
        <source>Aorta, characteristic impedance</source>
        <translation>Aorta, impedància característica</translation>
    </message>
    <message>
        <source>Aorta, diastolic</source>
        <translation>Aorta, diastòlica</translation>
    </message>
    <message>
        <source>Aorta, mean</source>
        <translation>Aorta, mitjana</translation>
    </message>
    <message>
        <source>Aorta, systolic</source>
        <translation>Aorta, sistòlica</translation>
    </message>
    <message>
        <source>Aortic arch</source>
        <translation>Arc aòrtic</translation>
    </message>
    <message>
        <source>Aortic gradient, mean</source>
        <translation>Gradient aòrtic, mitjà</translation>
    </message>
    <message>
        <source>Aortic stenosis</source>
        <translation>Estenosi aòrtica</translation>
    </message>
    <message>
        <source>Aortic valve</source>
        <translation>Vàlvula aòrtica</translation>
    </message>
    <message>
        <source>Aortic valve, leak</source>
        <translation>Vàlvula aòrtica, fuita</translation>
    </message>
    <message>
        <source>Aortic valve, open</source>
        <translation>Vàlvula aòrtica, oberta</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Àpex</translation>
    </message>
    <message>
        <source>Appendix</source>
        <translation>Apèndix</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Àrea</translation>
    </message>
    <message>
        <source>Arterial elastance Ea</source>
        <translation>Elastància arterial Ea</translation>
    </message>
    <message>
        <source>Arteries</source>
        <translation>Artèries</translation>
    </message>
    <message>
        <source>Ascending aorta</source>
        <translation>Aorta ascendent</translation>
    </message>
    <message>
        <source>Ascending colon</source>
        <translation>Còlon ascendent</translation>
    </message>
    <message>
        <source>Atria</source>
        <translation>Aurícules</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Balanced weights nearest to a target; a parameter says how negative weights are treated</source>
        <translation>Pesos en equilibri, els més propers a un objectiu; un paràmetre indica com es tracten els pesos negatius</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Warping the image</source>
        <translation>Es deforma la imatge</translation>
    </message>
    <message>
        <source>Warping the scan</source>
        <translation>Es deforma l’exploració</translation>
    </message>
    <message>
        <source>Warped</source>
        <translation>Deformat</translation>
    </message>
    <message>
        <source>Beyond the data: people were measured from 50 to 171 beats a minute</source>
        <translation>Més enllà de les dades: es va mesurar persones de 50 a 171 batecs per minut</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Conducte biliar</translation>
    </message>
    <message>
        <source>Binding %1</source>
        <translation>Vinculació de %1</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Heartbeat: %1</source>
        <translation>Batec: %1</translation>
    </message>
    <message>
        <source>LV (ml)</source>
        <translation>VE (ml)</translation>
    </message>
    <message>
        <source>Preparing the volume lock</source>
        <translation>Preparació del bloqueig del volum</translation>
    </message>
    <message>
        <source>Binding the space between the handles</source>
        <translation>Es vincula l’espai entre els tiradors</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mescla</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>De blau a vermell</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cos</translation>
    </message>
    <message>
        <source>Body of the stomach</source>
        <translation>Cos de l’estómac</translation>
    </message>
    <message>
        <source>Bones and joints</source>
        <translation>Ossos i articulacions</translation>
    </message>
    <message>
        <source>Bounded biharmonic weights</source>
        <translation>Pesos biharmònics acotats</translation>
    </message>
    <message>
        <source>Bradygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Bradigàstria: les persones sanes tenen de 2 a 4 ones per minut.</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Respiració</translation>
    </message>
    <message>
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not interpolate its handles</source>
        <translation>Amb els cantons i les normals d’una gàbia de qualsevol forma; gairebé manté els angles, i no interpola els tiradors</translation>
    </message>
    <message>
        <source>C-Celestial</source>
        <translation>C-Celestial</translation>
    </message>
    <message>
        <source>Caecum</source>
        <translation>Cec</translation>
    </message>
    <message>
        <source>Cardia</source>
        <translation>Càrdies</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Cabal cardíac</translation>
    </message>
    <message>
        <source>Catalogue of layers</source>
        <translation>Catàleg de capes</translation>
    </message>
    <message>
        <source>Caudate lobe</source>
        <translation>Lòbul caudat</translation>
    </message>
    <message>
        <source>Centreline</source>
        <translation>Línia central</translation>
    </message>
    <message>
        <source>Centroid of all positive solutions, estimated by sampling; more samples are more accurate</source>
        <translation>Centroide de totes les solucions positives, estimat per mostreig; més mostres donen més exactitud</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Canvia el grup</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Canvia l’aspecte</translation>
    </message>
    <message>
        <source>Change key sequence</source>
        <translation>Canvia la seqüència de claus</translation>
    </message>
    <message>
        <source>Checking %1</source>
        <translation>Comprovació de %1</translation>
    </message>
    <message>
        <source>Circulation: %1</source>
        <translation>Circulació: %1</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Tanca els forats</translation>
    </message>
    <message>
        <source>Close scan</source>
        <translation>Tanca l’exploració</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Acoloreix el grup</translation>
    </message>
    <message numerus="yes">
        <source>Compensate with {handle|%n handles}</source>
        <translation>
            <numerusform>Compensa amb aquest tirador</numerusform>
            <numerusform>Compensa amb %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Connexió</translation>
    </message>
    <message>
        <source>Contractility of the left ventricle</source>
        <translation>Contractilitat del ventricle esquerre</translation>
    </message>
    <message>
        <source>Contractility of the right ventricle</source>
        <translation>Contractilitat del ventricle dret</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordenades</translation>
    </message>
    <message>
        <source>Coordinates %1</source>
        <translation>Coordenades %1</translation>
    </message>
    <message>
        <source>Coupling Ea/Ees</source>
        <translation>Acoblament Ea/Ees</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>Interior</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivell</translation>
    </message>
    <message>
        <source>Locality</source>
        <translation>Localitat</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desfasament</translation>
    </message>
    <message>
        <source>Partitions</source>
        <translation>Particions</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punts</translation>
    </message>
    <message>
        <source>Polyhedra</source>
        <translation>Políedres</translation>
    </message>
    <message>
        <source>Positivity</source>
        <translation>Positivitat</translation>
    </message>
    <message>
        <source>RV (ml)</source>
        <translation>VD (ml)</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolució</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Mostres</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Mostreig</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Llavor</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplaçament</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavitat</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Aturada</translation>
    </message>
    <message>
        <source>Stress over the cycle</source>
        <translation>Tensió durant el cicle</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objectiu</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transferència</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Delaunay triangulation approach</source>
        <translation>Mètode de la triangulació de Delaunay</translation>
    </message>
    <message>
        <source>Descending colon</source>
        <translation>Còlon descendent</translation>
    </message>
    <message numerus="yes">
        <source>Describe {handle|%n handles}</source>
        <translation>
            <numerusform>Descriu el tirador</numerusform>
            <numerusform>Descriu %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Determinants approach</source>
        <translation>Mètode dels determinants</translation>
    </message>
    <message>
        <source>Digestive system</source>
        <translation>Aparell digestiu</translation>
    </message>
    <message>
        <source>Distance from a zone within which its super-region still counts: smoothness against locality</source>
        <translation>Distància a una zona en què la seva superregió encara compta: suavitat contra localitat</translation>
    </message>
    <message>
        <source>Distance over which the pull of a handle is rounded; 0 passes through the handles</source>
        <translation>Distància en què s’arrodoneix l’estirada d’un tirador; 0 passa pels tiradors</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^level rays</source>
        <translation>Divisions de l’icosàedre: 20 * 4^nivell raigs</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^samples directions</source>
        <translation>Divisions de l’icosàedre: 20 * 4^mostres direccions</translation>
    </message>
    <message>
        <source>Dome under the diaphragm</source>
        <translation>Cúpula sota el diafragma</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Duodè</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>ECG</translation>
    </message>
    <message>
        <source>Easing %1</source>
        <translation>Transició %1</translation>
    </message>
    <message>
        <source>Edges of tetrahedra across the handles; more are finer and slower</source>
        <translation>Arestes de tetràedre entre els tiradors; més és més fi i més lent</translation>
    </message>
    <message>
        <source>Ejection fraction</source>
        <translation>Fracció d’ejecció</translation>
    </message>
    <message>
        <source>Enclosing</source>
        <translation>Envoltants</translation>
    </message>
    <message>
        <source>ESPVR and EDPVR</source>
        <translation>ESPVR i EDPVR</translation>
    </message>
    <message>
        <source>Endocrine glands</source>
        <translation>Glàndules endocrines</translation>
    </message>
    <message>
        <source>Epicardium</source>
        <translation>Epicardi</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Exercici</translation>
    </message>
    <message>
        <source>Far corners</source>
        <translation>Cantons llunyans</translation>
    </message>
    <message>
        <source>Added volume that multiplies pericardial pressure by e</source>
        <translation>Volum que multiplica per e la pressió pericardíaca</translation>
    </message>
    <message>
        <source>Fitted circulation</source>
        <translation>Circulació ajustada</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fixos</translation>
    </message>
    <message>
        <source>Fluid in the pericardium</source>
        <translation>Líquid al pericardi</translation>
    </message>
    <message>
        <source>Fluid in the pericardium presses on all chambers: they fill little, and all filling pressures are the same.</source>
        <translation>El líquid del pericardi comprimeix totes les cavitats: s’omplen poc, i totes les pressions d’ompliment són iguals.</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Plegats</translation>
    </message>
    <message>
        <source>Folded tissue</source>
        <translation>Teixit plegat</translation>
    </message>
    <message>
        <source>Discard kept circulation</source>
        <translation>Descarta la circulació guardada</translation>
    </message>
    <message>
        <source>From atrial to ventricular contraction</source>
        <translation>De la contracció auricular a la ventricular</translation>
    </message>
    <message>
        <source>Fundus</source>
        <translation>Fundus</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vesícula biliar</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Peristalsi gàstrica</translation>
    </message>
    <message>
        <source>Gradient method</source>
        <translation>Mètode del gradient</translation>
    </message>
    <message>
        <source>Great vessels</source>
        <translation>Grans vasos</translation>
    </message>
    <message>
        <source>Greater curvature</source>
        <translation>Curvatura major</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Green</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grup</translation>
    </message>
    <message>
        <source>Group automatically</source>
        <translation>Agrupa automàticament</translation>
    </message>
    <message>
        <source>Groups of handles move only their own region of the organ; neighbouring regions blend smoothly.</source>
        <translation>Els grups de tiradors mouen només la seva regió de l’òrgan; les regions veïnes es fusionen suaument.</translation>
    </message>
    <message>
        <source>Haemorrhage</source>
        <translation>Hemorràgia</translation>
    </message>
    <message>
        <source>Hard upright work: a fast and strong heart, open muscle vessels, veins that give blood back.</source>
        <translation>Esforç intens dempeus: un cor ràpid i fort, vasos musculars oberts, venes que retornen sang.</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>Harmòniques</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Heart failure, preserved EF</source>
        <translation>Insuficiència cardíaca, FE preservada</translation>
    </message>
    <message>
        <source>Heart failure, reduced EF</source>
        <translation>Insuficiència cardíaca, FE reduïda</translation>
    </message>
    <message>
        <source>Heart follows the circulation</source>
        <translation>El cor segueix la circulació</translation>
    </message>
    <message>
        <source>Heart follows the textbook</source>
        <translation>El cor segueix el llibre</translation>
    </message>
    <message>
        <source>Heart rate</source>
        <translation>Freqüència cardíaca</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Batec</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Amaga</translation>
    </message>
    <message numerus="yes">
        <source>Hide {handle|%n handles}</source>
        <translation>
            <numerusform>Amaga el tirador</numerusform>
            <numerusform>Amaga %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>How far beyond the handles' hull the weights are computed</source>
        <translation>Fins on es calculen els pesos més enllà de l’envolupant dels tiradors</translation>
    </message>
    <message>
        <source>How much nearer handles count more; 0 as in the thesis</source>
        <translation>Quant més compten els tiradors més propers; 0 com a la tesi</translation>
    </message>
    <message>
        <source>How near to a flip the two triangulations are blended; 0 for not</source>
        <translation>Com de prop d’un gir es fusionen les dues triangulacions; 0 per no fer-ho</translation>
    </message>
    <message>
        <source>Method that finds positive balanced vectors</source>
        <translation>Mètode que troba vectors equilibrats positius</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Com arriben als tiradors els pesos dels vèrtexs de Voronoi</translation>
    </message>
    <message>
        <source>Order in which the wire connects the points</source>
        <translation>Ordre en què el fil uneix els punts</translation>
    </message>
    <message>
        <source>Hypertension</source>
        <translation>Hipertensió</translation>
    </message>
    <message>
        <source>Incremental approach</source>
        <translation>Mètode incremental</translation>
    </message>
    <message>
        <source>Inferior vena cava</source>
        <translation>Vena cava inferior</translation>
    </message>
    <message>
        <source>Inferno</source>
        <translation>Inferno</translation>
    </message>
    <message>
        <source>Influence of %1</source>
        <translation>Influència de %1</translation>
    </message>
    <message>
        <source>Inner handles of each layer</source>
        <translation>Tiradors interns de cada capa</translation>
    </message>
    <message>
        <source>Internal error of an unknown kind</source>
        <translation>Error intern de tipus desconegut</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Error intern: %1</translation>
    </message>
    <message>
        <source>It cannot be opened: %1</source>
        <translation>No es pot obrir: %1</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>No es pot llegir</translation>
    </message>
    <message>
        <source>It cannot be read to its end</source>
        <translation>No es pot llegir fins al final</translation>
    </message>
    <message>
        <source>It cannot be written: %1</source>
        <translation>No es pot escriure: %1</translation>
    </message>
    <message>
        <source>It cannot be written: it is a folder</source>
        <translation>No es pot escriure: és una carpeta</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Es travessa ella mateixa, en %n parell de triangles</numerusform>
            <numerusform>Es travessa ella mateixa, en %n parells de triangles</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not fit into memory</source>
        <translation>no cap a la memòria</translation>
    </message>
    <message>
        <source>The duration of one cycle is unknown</source>
        <translation>La durada d’un cicle és desconeguda</translation>
    </message>
    <message numerus="yes">
        <source>It does not say the times of its %n {phase|phases}; they are numbered</source>
        <translation>
            <numerusform>No indica el temps de la seva %n fase; es numera</numerusform>
            <numerusform>No indica els temps de les seves %n fases; es numeren</numerusform>
        </translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as milliseconds</source>
        <translation>No indica la unitat dels seus temps; es prenen com a mil·lisegons</translation>
    </message>
    <message>
        <source>It has %1 labels; a mask in a folder has one</source>
        <translation>Té %1 etiquetes; una màscara d’una carpeta en té una</translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a region needs at least 4</source>
        <translation>
            <numerusform>Té %n tirador; una regió en necessita almenys 4</numerusform>
            <numerusform>Té %n tiradors; una regió en necessita almenys 4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a sequence needs four at least</source>
        <translation>
            <numerusform>Té %n tirador; una seqüència en necessita almenys quatre</numerusform>
            <numerusform>Té %n tiradors; una seqüència en necessita almenys quatre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {phase|phases}; a motion needs four at least</source>
        <translation>
            <numerusform>Té %n fase; un moviment en necessita almenys quatre</numerusform>
            <numerusform>Té %n fases; un moviment en necessita almenys quatre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {vertex|vertices}</source>
        <translation>
            <numerusform>Té %n vèrtex</numerusform>
            <numerusform>Té %n vèrtexs</numerusform>
        </translation>
    </message>
    <message>
        <source>It has a label above 2147483647</source>
        <translation>Té una etiqueta superior a 2147483647</translation>
    </message>
    <message>
        <source>It has more than %1 files</source>
        <translation>Té més de %1 fitxers</translation>
    </message>
    <message>
        <source>It has more than 32767 voxels along a side, which NIfTI cannot hold</source>
        <translation>Té més de 32767 vòxels al llarg d’un costat, cosa que NIfTI no admet</translation>
    </message>
    <message>
        <source>It has no DICOM files with images</source>
        <translation>No té fitxers DICOM amb imatges</translation>
    </message>
    <message>
        <source>It has no labelled voxel: all are 0</source>
        <translation>No té cap vòxel etiquetat: tots són 0</translation>
    </message>
    <message>
        <source>It has no phase %1; it has %2</source>
        <translation>No té la fase %1; en té %2</translation>
    </message>
    <message>
        <source>It has no slices of a scan</source>
        <translation>No té talls d’una exploració</translation>
    </message>
    <message>
        <source>It has no slices of a scan: &quot;%1&quot; %2</source>
        <translation>No té talls d’una exploració: «%1» %2</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>No té la superfície «%1»</translation>
    </message>
    <message>
        <source>It has no triangles</source>
        <translation>No té triangles</translation>
    </message>
    <message>
        <source>It does not have three dimensions</source>
        <translation>No té tres dimensions</translation>
    </message>
    <message>
        <source>It has several axes that are not of space</source>
        <translation>Té diversos eixos que no són de l’espai</translation>
    </message>
    <message>
        <source>It has several labels: %1</source>
        <translation>Hi ha diverses etiquetes: %1</translation>
    </message>
    <message>
        <source>It has several values per voxel</source>
        <translation>Té diversos valors per vòxel</translation>
    </message>
    <message>
        <source>It has several values per voxel (%1)</source>
        <translation>Té diversos valors per vòxel (%1)</translation>
    </message>
    <message>
        <source>It has to be positive</source>
        <translation>Ha de ser positiu</translation>
    </message>
    <message>
        <source>It holds an image, not labels: it has more than %1 different values</source>
        <translation>Conté una imatge, no etiquetes: té més de %1 valors diferents</translation>
    </message>
    <message>
        <source>It holds an image, not labels: one of its values is %1</source>
        <translation>Conté una imatge, no etiquetes: un dels valors és %1</translation>
    </message>
    <message>
        <source>It holds more than %1 masks</source>
        <translation>Conté més de %1 màscares</translation>
    </message>
    <message>
        <source>It holds neither surfaces nor label maps</source>
        <translation>No conté ni superfícies ni mapes d’etiquetes</translation>
    </message>
    <message>
        <source>It holds no PolyData</source>
        <translation>No conté PolyData</translation>
    </message>
    <message>
        <source>It holds no label map</source>
        <translation>No conté cap mapa d’etiquetes</translation>
    </message>
    <message>
        <source>It holds no triangles</source>
        <translation>No conté triangles</translation>
    </message>
    <message>
        <source>It holds no triangles, only points</source>
        <translation>No conté triangles, només punts</translation>
    </message>
    <message>
        <source>It holds only empty masks</source>
        <translation>Només conté màscares buides</translation>
    </message>
    <message>
        <source>It holds points, but no faces</source>
        <translation>Conté punts, però no cares</translation>
    </message>
    <message>
        <source>It is a DICOM file without an image</source>
        <translation>És un fitxer DICOM sense imatge</translation>
    </message>
    <message>
        <source>It is a DICOM file, but no segmentation (%1)</source>
        <translation>És un fitxer DICOM, però no una segmentació (%1)</translation>
    </message>
    <message>
        <source>It is a binary OFF file, which Viscera does not read</source>
        <translation>És un fitxer OFF binari, que Viscera no llegeix</translation>
    </message>
    <message>
        <source>It is a folder, not a file</source>
        <translation>És una carpeta, no un fitxer</translation>
    </message>
    <message>
        <source>It is a scan, not an organ</source>
        <translation>És una exploració, no un òrgan</translation>
    </message>
    <message>
        <source>It is glTF version %1, but only 2 can be read</source>
        <translation>És glTF versió %1, però només es pot llegir la 2</translation>
    </message>
    <message>
        <source>It is named %1 but looks like %2</source>
        <translation>Es diu %1, però sembla %2</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>No és un fitxer de tipus %1: el seu «format» no és «%2»</translation>
    </message>
    <message>
        <source>It is not a file with several phases</source>
        <translation>No és un fitxer amb diverses fases</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>No és un fitxer que es pugui llegir</translation>
    </message>
    <message>
        <source>It is not a handle file</source>
        <translation>No és un fitxer de tiradors</translation>
    </message>
    <message>
        <source>It is not a regular file</source>
        <translation>No és un fitxer normal</translation>
    </message>
    <message>
        <source>It is not a scan in a known format</source>
        <translation>No és una exploració en un format conegut</translation>
    </message>
    <message>
        <source>It is not a slice of a scan</source>
        <translation>No és un tall d’una exploració</translation>
    </message>
    <message>
        <source>It is not a slice of a scan: it %1</source>
        <translation>No és un tall d’una exploració: %1</translation>
    </message>
    <message>
        <source>It is not convex at its triangle %1</source>
        <translation>No és convexa al triangle %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>És de la versió %1; aquest programa llegeix fins a la %2</translation>
    </message>
    <message>
        <source>It is too large: %1 points</source>
        <translation>És massa gran: %1 punts</translation>
    </message>
    <message>
        <source>The displacement field would have more than 20 million points</source>
        <translation>El camp de desplaçaments tindria més de 20 milions de punts</translation>
    </message>
    <message>
        <source>It mixes surfaces and label maps</source>
        <translation>Barreja superfícies i mapes d’etiquetes</translation>
    </message>
    <message>
        <source>It needs the glTF extension %1, which Viscera does not know</source>
        <translation>Necessita l’extensió de glTF %1, que Viscera no coneix</translation>
    </message>
    <message>
        <source>It seems to be in RAS where %1 is in LPS, or the other way round: it lies on the opposite side of the patient's middle</source>
        <translation>Sembla que és en RAS mentre que %1 és en LPS, o al revés: és a l’altra banda del centre del pacient</translation>
    </message>
    <message>
        <source>Its grid is sheared: its axes are not at right angles</source>
        <translation>La seva quadrícula està cisallada: els eixos no formen angles rectes</translation>
    </message>
    <message>
        <source>Keep circulation for comparison</source>
        <translation>Guarda la circulació per comparar</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Ronyó</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Ronyó esquerre</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Ronyó dret</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>Cav. AE</translation>
    </message>
    <message>
        <source>LV cavity</source>
        <translation>Cav. VE</translation>
    </message>
    <message>
        <source>LV dP/dt, largest</source>
        <translation>dP/dt del VE, màxima</translation>
    </message>
    <message>
        <source>LV end-diastolic</source>
        <translation>VE telediastòlic</translation>
    </message>
    <message>
        <source>LV end-diastolic pressure</source>
        <translation>Pressió telediastòlica del VE</translation>
    </message>
    <message>
        <source>LV end-systolic</source>
        <translation>VE telesistòlic</translation>
    </message>
    <message>
        <source>LV endocardium</source>
        <translation>Endocardi del VE</translation>
    </message>
    <message>
        <source>LV stroke work</source>
        <translation>Treball sistòlic del VE</translation>
    </message>
    <message>
        <source>Lagrange minimisation</source>
        <translation>Minimització de Lagrange</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Estirament màxim</translation>
    </message>
    <message>
        <source>Lateral border</source>
        <translation>Vora lateral</translation>
    </message>
    <message>
        <source>Left anterior descending artery</source>
        <translation>Artèria descendent anterior</translation>
    </message>
    <message>
        <source>Left atrium</source>
        <translation>Aurícula esquerra</translation>
    </message>
    <message>
        <source>Left atrium, contractility</source>
        <translation>Aurícula esquerra, contractilitat</translation>
    </message>
    <message>
        <source>Left atrium, mean</source>
        <translation>Aurícula esquerra, mitjana</translation>
    </message>
    <message>
        <source>Left atrium, relaxation</source>
        <translation>Aurícula esquerra, relaxació</translation>
    </message>
    <message>
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Aurícula esquerra, escala de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
        <translation>Aurícula esquerra, pendent de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Left atrium, volume without pressure</source>
        <translation>Aurícula esquerra, volum sense pressió</translation>
    </message>
    <message>
        <source>Left auricle</source>
        <translation>Orelleta esquerra</translation>
    </message>
    <message>
        <source>Left colic flexure</source>
        <translation>Flexura còlica esquerra</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Ronyó esquerre</translation>
    </message>
    <message>
        <source>Vertebra</source>
        <translation>Vèrtebra</translation>
    </message>
    <message>
        <source>Left rib</source>
        <translation>Costella esquerra</translation>
    </message>
    <message>
        <source>Right rib</source>
        <translation>Costella dreta</translation>
    </message>
    <message>
        <source>Upper lobe of the left lung</source>
        <translation>Lòbul superior del pulmó esquerre</translation>
    </message>
    <message>
        <source>Lower lobe of the left lung</source>
        <translation>Lòbul inferior del pulmó esquerre</translation>
    </message>
    <message>
        <source>Upper lobe of the right lung</source>
        <translation>Lòbul superior del pulmó dret</translation>
    </message>
    <message>
        <source>Middle lobe of the right lung</source>
        <translation>Lòbul mitjà del pulmó dret</translation>
    </message>
    <message>
        <source>Lower lobe of the right lung</source>
        <translation>Lòbul inferior del pulmó dret</translation>
    </message>
    <message>
        <source>Left deep back muscles</source>
        <translation>Músculs profunds de l’esquena esquerres</translation>
    </message>
    <message>
        <source>Right deep back muscles</source>
        <translation>Músculs profunds de l’esquena drets</translation>
    </message>
    <message>
        <source>Left iliopsoas muscle</source>
        <translation>Múscul iliopsoes esquerre</translation>
    </message>
    <message>
        <source>Right iliopsoas muscle</source>
        <translation>Múscul iliopsoes dret</translation>
    </message>
    <message>
        <source>Left lobe</source>
        <translation>Lòbul esquerre</translation>
    </message>
    <message>
        <source>Left pulmonary artery</source>
        <translation>Artèria pulmonar esquerra</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Ventricle esquerre</translation>
    </message>
    <message>
        <source>Left ventricle, relaxation</source>
        <translation>Ventricle esquerre, relaxació</translation>
    </message>
    <message>
        <source>Left ventricle, scale of the passive filling curve</source>
        <translation>Ventricle esquerre, escala de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Left ventricle, volume without pressure</source>
        <translation>Ventricle esquerre, volum sense pressió</translation>
    </message>
    <message>
        <source>Left ventricular</source>
        <translation>Ventricle esquerre</translation>
    </message>
    <message>
        <source>Lesser curvature</source>
        <translation>Curvatura menor</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Fetge</translation>
    </message>
    <message>
        <source>Localised S-Celestial</source>
        <translation>S-Celestial localitzades</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloqueja</translation>
    </message>
    <message>
        <source>Lock volume</source>
        <translation>Bloqueja el volum</translation>
    </message>
    <message numerus="yes">
        <source>Lock {handle|%n handles}</source>
        <translation>
            <numerusform>Bloqueja el tirador</numerusform>
            <numerusform>Bloqueja %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Lower pole</source>
        <translation>Pol inferior</translation>
    </message>
    <message>
        <source>Lymphatic system</source>
        <translation>Sistema limfàtic</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Màxim</translation>
    </message>
    <message>
        <source>Maximum of %1 mm</source>
        <translation>Màxim de %1 mm</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mitjana</translation>
    </message>
    <message>
        <source>Mean of %1 mm</source>
        <translation>Mitjana de %1 mm</translation>
    </message>
    <message>
        <source>Mean value</source>
        <translation>Valor mitjà</translation>
    </message>
    <message>
        <source>Mean value of a cage with flat polygons, whose diagonals play no part</source>
        <translation>Valor mitjà d’una gàbia amb polígons plans, sense que hi intervinguin les diagonals</translation>
    </message>
    <message>
        <source>Mean value of what can be seen of a cage, by rays; positive in any cage</source>
        <translation>Valor mitjà del que es pot veure d’una gàbia, amb raigs; positives en qualsevol gàbia</translation>
    </message>
    <message>
        <source>Mean value on the hull, inner handles added one by one; they may make some negative</source>
        <translation>Valor mitjà a l’envolupant, amb els tiradors interns afegits un a un; alguns poden resultar negatius</translation>
    </message>
    <message>
        <source>Mean value over all tetrahedra of the handles at once, by directions; positive, with many maxima</source>
        <translation>Valor mitjà sobre tots els tetràedres dels tiradors alhora, per direccions; positives, amb molts màxims</translation>
    </message>
    <message>
        <source>Mean value over the Delaunay triangles of the handles as each point sees them; jumps where triangles flip, which blending reduces</source>
        <translation>Valor mitjà sobre els triangles de Delaunay dels tiradors tal com els veu cada punt; salts on els triangles canvien, que la fusió redueix</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Valor mitjà sobre les regions de Voronoi dels tiradors tal com els veu cada punt; salts, o lentes</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Mesura: %1</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurada</translation>
    </message>
    <message>
        <source>Middle of the body</source>
        <translation>Mig del cos gàstric</translation>
    </message>
    <message>
        <source>Mitral regurgitation</source>
        <translation>Insuficiència mitral</translation>
    </message>
    <message>
        <source>Mitral valve</source>
        <translation>Vàlvula mitral</translation>
    </message>
    <message>
        <source>Mitral valve, leak</source>
        <translation>Vàlvula mitral, fuita</translation>
    </message>
    <message>
        <source>Mitral valve, open</source>
        <translation>Vàlvula mitral, oberta</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Mou la clau</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Mou un punt mesurat</translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles}</source>
        <translation>
            <numerusform>Mou el tirador</numerusform>
            <numerusform>Mou %n tiradors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles} at rest</source>
        <translation>
            <numerusform>Mou el tirador en repòs</numerusform>
            <numerusform>Mou %n tiradors en repòs</numerusform>
        </translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Músculs</translation>
    </message>
    <message>
        <source>Narrow small arteries and stiff large ones, against which a stronger, stiffer, thicker ventricle works.</source>
        <translation>Artèries petites estretes i grans rígides, contra les quals treballa un ventricle més fort, més rígid i més gruixut.</translation>
    </message>
    <message>
        <source>Natural neighbours</source>
        <translation>Veïns naturals</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Coll</translation>
    </message>
    <message>
        <source>Nervous system</source>
        <translation>Sistema nerviós</translation>
    </message>
    <message>
        <source>No cavity is a ventricle by its name</source>
        <translation>Cap cavitat és un ventricle pel seu nom</translation>
    </message>
    <message>
        <source>No surface is chosen</source>
        <translation>No hi ha cap superfície triada</translation>
    </message>
    <message>
        <source>No voxel has a label in %1</source>
        <translation>Cap vòxel té etiqueta a la %1</translation>
    </message>
    <message>
        <source>The key sequence has no key</source>
        <translation>La seqüència de claus no té cap clau</translation>
    </message>
    <message>
        <source>Numerical integration approach</source>
        <translation>Mètode d’integració numèrica</translation>
    </message>
    <message>
        <source>Oesophagus</source>
        <translation>Esòfag</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Llavor dels nombres aleatoris</translation>
    </message>
    <message>
        <source>Only label maps have labels</source>
        <translation>Només els mapes d’etiquetes tenen etiquetes</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Obre</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Obre %1</translation>
    </message>
    <message numerus="yes">
        <source>Open %n {file|files}</source>
        <translation>
            <numerusform>Obre %n fitxer</numerusform>
            <numerusform>Obre %n fitxers</numerusform>
        </translation>
    </message>
    <message>
        <source>Open scan %1</source>
        <translation>Obre l’exploració %1</translation>
    </message>
    <message>
        <source>Open sequence %1</source>
        <translation>Obre la seqüència %1</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Òrgan</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Altres</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pàncrees</translation>
    </message>
    <message>
        <source>Tissue folded at any instant</source>
        <translation>Teixit plegat en algun instant</translation>
    </message>
    <message>
        <source>Maximum of largest stretch</source>
        <translation>Màxim de l’estirament màxim</translation>
    </message>
    <message>
        <source>Maximum rotational stress</source>
        <translation>Tensió rotacional màxima</translation>
    </message>
    <message>
        <source>Minimum of smallest stretch</source>
        <translation>Mínim de l’estirament mínim</translation>
    </message>
    <message>
        <source>Extreme volume ratio</source>
        <translation>Raó de volums extrema</translation>
    </message>
    <message>
        <source>Points along the middle of the stomach, from the fundus down</source>
        <translation>Punts al llarg del mig de l’estómac, del fundus cap avall</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Vena porta</translation>
    </message>
    <message>
        <source>Positive mean value</source>
        <translation>Valor mitjà positiu</translation>
    </message>
    <message>
        <source>Preload: stressed blood volume</source>
        <translation>Precàrrega: volum de sang estressat</translation>
    </message>
    <message>
        <source>Pressure (mmHg)</source>
        <translation>Pressió (mmHg)</translation>
    </message>
    <message>
        <source>Pulmonary arteries, compliance</source>
        <translation>Artèries pulmonars, distensibilitat</translation>
    </message>
    <message>
        <source>Pulmonary artery</source>
        <translation>Artèria pulmonar</translation>
    </message>
    <message>
        <source>Pulmonary artery, characteristic impedance</source>
        <translation>Artèria pulmonar, impedància característica</translation>
    </message>
    <message>
        <source>Pulmonary artery, mean</source>
        <translation>Artèria pulmonar, mitjana</translation>
    </message>
    <message>
        <source>Pulmonary artery, systolic</source>
        <translation>Artèria pulmonar, sistòlica</translation>
    </message>
    <message>
        <source>Pulmonary trunk</source>
        <translation>Tronc pulmonar</translation>
    </message>
    <message>
        <source>Pulmonary valve, leak</source>
        <translation>Vàlvula pulmonar, fuita</translation>
    </message>
    <message>
        <source>Pulmonary valve, open</source>
        <translation>Vàlvula pulmonar, oberta</translation>
    </message>
    <message>
        <source>Pulmonary vein</source>
        <translation>Vena pulmonar</translation>
    </message>
    <message>
        <source>Pulmonary veins, compliance</source>
        <translation>Venes pulmonars, distensibilitat</translation>
    </message>
    <message>
        <source>Pulmonary veins, resistance</source>
        <translation>Venes pulmonars, resistència</translation>
    </message>
    <message>
        <source>Pylorus</source>
        <translation>Pílor</translation>
    </message>
    <message>
        <source>RA cavity</source>
        <translation>Cav. AD</translation>
    </message>
    <message>
        <source>RV cavity</source>
        <translation>Cav. VD</translation>
    </message>
    <message>
        <source>RV ejection fraction</source>
        <translation>Fracció d’ejecció del VD</translation>
    </message>
    <message>
        <source>RV end-diastolic</source>
        <translation>VD telediastòlic</translation>
    </message>
    <message>
        <source>RV end-systolic</source>
        <translation>VD telesistòlic</translation>
    </message>
    <message>
        <source>RV free wall</source>
        <translation>Paret lliure del VD</translation>
    </message>
    <message>
        <source>RV stroke work</source>
        <translation>Treball sistòlic del VD</translation>
    </message>
    <message>
        <source>Rational coordinates of a convex cage; positive and smooth inside</source>
        <translation>Coordenades racionals d’una gàbia convexa; positives i suaus a l’interior</translation>
    </message>
    <message>
        <source>Record key</source>
        <translation>Enregistra una clau</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistrada</translation>
    </message>
    <message>
        <source>Rectum</source>
        <translation>Recte</translation>
    </message>
    <message>
        <source>Remove all measurements</source>
        <translation>Elimina totes les mesures</translation>
    </message>
    <message>
        <source>Remove all organs</source>
        <translation>Elimina tots els òrgans</translation>
    </message>
    <message>
        <source>Take out of group</source>
        <translation>Treu del grup</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Elimina el grup</translation>
    </message>
    <message numerus="yes">
        <source>Remove {handle|%n handles}</source>
        <translation>
            <numerusform>Elimina el tirador</numerusform>
            <numerusform>Elimina %n tiradors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {key|%n keys}</source>
        <translation>
            <numerusform>Elimina la clau</numerusform>
            <numerusform>Elimina %n claus</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Elimina la mesura</numerusform>
            <numerusform>Elimina %n mesures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {organ|%n organs}</source>
        <translation>
            <numerusform>Elimina l’òrgan</numerusform>
            <numerusform>Elimina %n òrgans</numerusform>
        </translation>
    </message>
    <message>
        <source>Renal artery</source>
        <translation>Artèria renal</translation>
    </message>
    <message>
        <source>Renal pelvis</source>
        <translation>Pelvis renal</translation>
    </message>
    <message>
        <source>Renal vein</source>
        <translation>Vena renal</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Canvia el nom del grup</translation>
    </message>
    <message>
        <source>Rename handle</source>
        <translation>Canvia el nom del tirador</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>Canvia el nom de la mesura</translation>
    </message>
    <message>
        <source>Rename organ</source>
        <translation>Canvia el nom de l’òrgan</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>Reparació de %1</translation>
    </message>
    <message>
        <source>Replace handles</source>
        <translation>Substitueix els tiradors</translation>
    </message>
    <message>
        <source>Replace pose of key</source>
        <translation>Substitueix la postura de la clau</translation>
    </message>
    <message>
        <source>Replace key sequence</source>
        <translation>Substitueix la seqüència de claus</translation>
    </message>
    <message>
        <source>Reproductive system</source>
        <translation>Aparell reproductor</translation>
    </message>
    <message>
        <source>Reset pose</source>
        <translation>Restableix la postura</translation>
    </message>
    <message>
        <source>Respiratory system</source>
        <translation>Aparell respiratori</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Repòs</translation>
    </message>
    <message>
        <source>Right atrium</source>
        <translation>Aurícula dreta</translation>
    </message>
    <message>
        <source>Right atrium, contractility</source>
        <translation>Aurícula dreta, contractilitat</translation>
    </message>
    <message>
        <source>Right atrium, mean</source>
        <translation>Aurícula dreta, mitjana</translation>
    </message>
    <message>
        <source>Right atrium, relaxation</source>
        <translation>Aurícula dreta, relaxació</translation>
    </message>
    <message>
        <source>Right atrium, scale of the passive filling curve</source>
        <translation>Aurícula dreta, escala de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
        <translation>Aurícula dreta, pendent de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Right atrium, volume without pressure</source>
        <translation>Aurícula dreta, volum sense pressió</translation>
    </message>
    <message>
        <source>Right colic flexure</source>
        <translation>Flexura còlica dreta</translation>
    </message>
    <message>
        <source>Right coronary artery</source>
        <translation>Artèria coronària dreta</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Ronyó dret</translation>
    </message>
    <message>
        <source>Right lobe</source>
        <translation>Lòbul dret</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Ventricle dret</translation>
    </message>
    <message>
        <source>Right ventricle, relaxation</source>
        <translation>Ventricle dret, relaxació</translation>
    </message>
    <message>
        <source>Right ventricle, scale of the passive filling curve</source>
        <translation>Ventricle dret, escala de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
        <translation>Ventricle dret, pendent de la corba d’ompliment passiu</translation>
    </message>
    <message>
        <source>Right ventricle, volume without pressure</source>
        <translation>Ventricle dret, volum sense pressió</translation>
    </message>
    <message>
        <source>Right ventricular</source>
        <translation>Ventricle dret</translation>
    </message>
    <message>
        <source>Rotational stress</source>
        <translation>Tensió rotacional</translation>
    </message>
    <message>
        <source>S-Celestial</source>
        <translation>S-Celestial</translation>
    </message>
    <message>
        <source>Number of samples for each point</source>
        <translation>Nombre de mostres per a cada punt</translation>
    </message>
    <message>
        <source>Septum</source>
        <translation>Envà</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Ajusta %1</translation>
    </message>
    <message>
        <source>Set pose</source>
        <translation>Fixa la postura</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message numerus="yes">
        <source>Show {handle|%n handles}</source>
        <translation>
            <numerusform>Mostra el tirador</numerusform>
            <numerusform>Mostra %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Sibson's coordinates: what a point takes from its neighbours' Voronoi cells; positive and local</source>
        <translation>Coordenades de Sibson: el que un punt pren de les cel·les de Voronoi dels veïns; positives i locals</translation>
    </message>
    <message>
        <source>Sigmoid colon</source>
        <translation>Còlon sigmoide</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Pell i greix</translation>
    </message>
    <message>
        <source>Slice %1 (%2) is shifted sideways against those below it</source>
        <translation>El tall %1 (%2) està desplaçat lateralment respecte als inferiors</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Intestí prim</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Estirament mínim</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; maximum entropy over directions</source>
        <translation>Suaus i positives, només a partir de punts; entropia màxima sobre les direccions</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; the thesis's choice for organs</source>
        <translation>Suaus i positives, només a partir de punts; l’elecció de la tesi per als òrgans</translation>
    </message>
    <message>
        <source>Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes</source>
        <translation>Solucions de l’equació de Laplace en una gàbia de qualsevol forma; locals, i sense lòbuls negatius</translation>
    </message>
    <message>
        <source>Some of its values need more than 32 bits as a whole number; they are kept as fractions of seven digits</source>
        <translation>Alguns dels seus valors necessiten més de 32 bits com a nombre enter; es conserven com a decimals de set xifres</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Soroll</translation>
    </message>
    <message>
        <source>Spherical mean value</source>
        <translation>Valor mitjà esfèric</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Melsa</translation>
    </message>
    <message>
        <source>Stiffness of the left ventricle</source>
        <translation>Rigidesa del ventricle esquerre</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómac</translation>
    </message>
    <message>
        <source>Stomach and bowel</source>
        <translation>Estómac i intestí</translation>
    </message>
    <message numerus="yes">
        <source>Stop compensating with {handle|%n handles}</source>
        <translation>
            <numerusform>No compensis més amb aquest tirador</numerusform>
            <numerusform>No compensis més amb %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Stress at the witness points</source>
        <translation>Tensió als punts testimoni</translation>
    </message>
    <message>
        <source>Stroke volume</source>
        <translation>Volum sistòlic</translation>
    </message>
    <message>
        <source>Superior vena cava</source>
        <translation>Vena cava superior</translation>
    </message>
    <message>
        <source>System used inside each region</source>
        <translation>Sistema usat dins de cada regió</translation>
    </message>
    <message>
        <source>Systemic arteries, compliance</source>
        <translation>Artèries sistèmiques, distensibilitat</translation>
    </message>
    <message>
        <source>Systemic veins, compliance</source>
        <translation>Venes sistèmiques, distensibilitat</translation>
    </message>
    <message>
        <source>Systemic veins, resistance</source>
        <translation>Venes sistèmiques, resistència</translation>
    </message>
    <message>
        <source>T-Celestial</source>
        <translation>T-Celestial</translation>
    </message>
    <message>
        <source>Tachygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Taquigàstria: les persones sanes tenen de 2 a 4 ones per minut.</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Cua</translation>
    </message>
    <message>
        <source>Take handles of %1</source>
        <translation>Pren els tiradors de %1</translation>
    </message>
    <message>
        <source>Take the cage %1</source>
        <translation>Pren la gàbia %1</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponament</translation>
    </message>
    <message>
        <source>TetGen cannot fill this surface (%1)</source>
        <translation>TetGen no pot omplir aquesta superfície (%1)</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen no ha posat cap punt dins de la superfície</translation>
    </message>
    <message>
        <source>TetGen wanted more than %1 MB of memory</source>
        <translation>TetGen ha demanat més de %1 MB de memòria</translation>
    </message>
    <message>
        <source>TetGen was not done after %1 s</source>
        <translation>TetGen no havia acabat després de %1 s</translation>
    </message>
    <message>
        <source>TetGen's program %1 cannot be started: %2</source>
        <translation>no es pot iniciar el programa %1 de TetGen: %2</translation>
    </message>
    <message>
        <source>TetGen&apos;s result does not fill this surface: %1</source>
        <translation>el resultat de TetGen no omple aquesta superfície: %1</translation>
    </message>
    <message>
        <source>Textbook heartbeat</source>
        <translation>Batec del llibre de text</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle is far higher than that of the aorta.</source>
        <translation>La vàlvula aòrtica s’obre fins a 0,8 cm2: la pressió del ventricle hipertròfic supera de molt la de l’aorta.</translation>
    </message>
    <message>
        <source>The cavity %1 is not inside the outer surface %2: %3 % of it lie outside</source>
        <translation>La cavitat %1 no és dins de la superfície exterior %2: el %3 % en queda fora</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Les coordenades clàssiques d’una gàbia tancada; positives on la gàbia és convexa</translation>
    </message>
    <message>
        <source>The files' names are not in the order of the slices; they were put in order by position</source>
        <translation>Els noms dels fitxers no segueixen l’ordre dels talls; s’han ordenat per posició</translation>
    </message>
    <message>
        <source>The grid of %1 is another one than that of the first phase</source>
        <translation>La quadrícula de la %1 no és la de la primera fase</translation>
    </message>
    <message>
        <source>The label &quot;%1&quot; is missing in %2</source>
        <translation>Falta l’etiqueta «%1» a la %2</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>El mapa d’etiquetes de %1 té una altra quadrícula (%2) que l’exploració (%3); cadascun és on diu el seu fitxer, i res no es remostreja</translation>
    </message>
    <message>
        <source>The last phase does not lead back to the first: they lie %1 mm apart on average, neighbours %2 mm at most</source>
        <translation>L’última fase no torna a la primera: disten %1 mm de mitjana, les veïnes %2 mm com a màxim</translation>
    </message>
    <message>
        <source>The mean over all tetrahedra of handles around a point; jumps where their number changes</source>
        <translation>La mitjana sobre tots els tetràedres de tiradors al voltant d’un punt; salts on en canvia el nombre</translation>
    </message>
    <message>
        <source>The mean over the hull and partitions of it by the inner handles; kinks at their faces</source>
        <translation>La mitjana sobre l’envolupant i les seves particions pels tiradors interns; plecs a les cares</translation>
    </message>
    <message>
        <source>The middle of the mitral valve, inside the heart</source>
        <translation>El centre de la vàlvula mitral, dins del cor</translation>
    </message>
    <message>
        <source>The mitral valve leaks through 0.45 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>La vàlvula mitral té una fuita de 0,45 cm2: la meitat del que ejecta el ventricle torna a l’aurícula.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>El nombre de punts testimoni ha de ser de %1 a %2</translation>
    </message>
    <message>
        <source>Target weights</source>
        <translation>Pesos objectiu</translation>
    </message>
    <message>
        <source>The organ that this cavity is in is not there any more</source>
        <translation>L’òrgan on és aquesta cavitat ja no hi és</translation>
    </message>
    <message>
        <source>The outlet of the stomach</source>
        <translation>La sortida de l’estómac</translation>
    </message>
    <message>
        <source>The period is not a positive time</source>
        <translation>El període no és un temps positiu</translation>
    </message>
    <message>
        <source>The points of n-space that the wire connects</source>
        <translation>Els punts de l’espai n-dimensional que uneix el fil</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>La postura té una posició que no és un nombre finit o és massa lluny</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie</source>
        <translation>El programa ffmpeg no ha pogut escriure la pel·lícula</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie: %1</source>
        <translation>El programa ffmpeg no ha pogut escriure la pel·lícula: %1</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>La seqüència mou %1 tiradors, però n’hi ha %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>La seqüència es va fer per a una altra posició d’un tirador</translation>
    </message>
    <message numerus="yes">
        <source>The series has images of several sizes: %n {image|images} of %2 left out, those of %3 read</source>
        <translation>
            <numerusform>La sèrie té imatges de diverses mides: s’omet %n imatge de %2 i es llegeixen les de %3</numerusform>
            <numerusform>La sèrie té imatges de diverses mides: s’ometen %n imatges de %2 i es llegeixen les de %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The series has pixels of several sizes: %n {image|images} of %2 mm left out, those of %3 mm read</source>
        <translation>
            <numerusform>La sèrie té píxels de diverses mides: s’omet %n imatge de %2 mm i es llegeixen les de %3 mm</numerusform>
            <numerusform>La sèrie té píxels de diverses mides: s’ometen %n imatges de %2 mm i es llegeixen les de %3 mm</numerusform>
        </translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the way they are stacked (a tilted gantry); the shear is kept</source>
        <translation>Els talls estan inclinats %1 graus respecte a l’apilament (gantry inclinat); es conserva la cisalla</translation>
    </message>
    <message>
        <source>Maximises the smallest weight; positive, with kinks</source>
        <translation>Maximitza el pes més petit; positives, amb plecs</translation>
    </message>
    <message>
        <source>The spacing is uneven between slice %1 (%2) and the next, which are %3 mm apart in place of %4 mm (%5 %)</source>
        <translation>La separació és desigual entre el tall %1 (%2) i el següent, que disten %3 mm en lloc de %4 mm (%5 %)</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>La superfície no té cap triangle</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled. %1. Details smaller than %2 mm are lost.</source>
        <translation>La superfície s’ha reparat abans d’omplir-la. %1. Es perden els detalls de menys de %2 mm.</translation>
    </message>
    <message>
        <source>The thesis's radius; it cancels in the coordinates and changes nothing</source>
        <translation>El radi de la tesi; es cancel·la en les coordenades i no canvia res</translation>
    </message>
    <message>
        <source>The times of the phases do not ascend within one period of %1 ms: %2 is at %3 ms</source>
        <translation>Els temps de les fases no augmenten dins d’un període de %1 ms: la %2 és a %3 ms</translation>
    </message>
    <message>
        <source>The tip of the heart</source>
        <translation>La punta del cor</translation>
    </message>
    <message>
        <source>The top of the fundus</source>
        <translation>El punt més alt del fundus</translation>
    </message>
    <message>
        <source>The volume of %1 jumps from %2 to %3 ml between %4 and %5</source>
        <translation>El volum de %1 salta de %2 a %3 ml entre la %4 i la %5</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Els punts testimoni són en una quadrícula regular dins de la superfície. %1.</translation>
    </message>
    <message>
        <source>There are %1 witness points; %2 do not fit this shape or the limits of time and memory.</source>
        <translation>Hi ha %1 punts testimoni; %2 no caben en aquesta forma o en els límits de temps i memòria.</translation>
    </message>
    <message>
        <source>There are no handles to group</source>
        <translation>No hi ha tiradors per agrupar</translation>
    </message>
    <message>
        <source>There are no handles whose pose could be recorded</source>
        <translation>No hi ha tiradors dels quals es pugui enregistrar la postura</translation>
    </message>
    <message>
        <source>There is no %1</source>
        <translation>No existeix la %1</translation>
    </message>
    <message>
        <source>There is no file to open</source>
        <translation>No hi ha cap fitxer per obrir</translation>
    </message>
    <message>
        <source>There is no organ to enclose</source>
        <translation>No hi ha cap òrgan per envoltar</translation>
    </message>
    <message>
        <source>There is no organ to make groups for</source>
        <translation>No hi ha cap òrgan per al qual fer grups</translation>
    </message>
    <message>
        <source>There is no scan to close</source>
        <translation>No hi ha cap exploració per tancar</translation>
    </message>
    <message>
        <source>There is no stress map yet</source>
        <translation>Encara no hi ha mapa de tensió</translation>
    </message>
    <message>
        <source>There is no such %1 any more</source>
        <translation>Ja no existeix: %1</translation>
    </message>
    <message>
        <source>There is no such handle any more</source>
        <translation>Aquest tirador ja no existeix</translation>
    </message>
    <message>
        <source>There is no such organ any more</source>
        <translation>Aquest òrgan ja no existeix</translation>
    </message>
    <message>
        <source>There is no surface &quot;%1&quot;</source>
        <translation>No hi ha cap superfície «%1»</translation>
    </message>
    <message>
        <source>There is no volume in it</source>
        <translation>No conté cap volum</translation>
    </message>
    <message>
        <source>There is not enough memory</source>
        <translation>No hi ha prou memòria</translation>
    </message>
    <message numerus="yes">
        <source>There {is|are} %n {time|times} for %2 phases</source>
        <translation>
            <numerusform>Hi ha %n temps per a %2 fases</numerusform>
            <numerusform>Hi ha %n temps per a %2 fases</numerusform>
        </translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Engruiximent</translation>
    </message>
    <message>
        <source>This file does not state its axes, but other files of the series are in RAS</source>
        <translation>Aquest fitxer no indica els seus eixos, però altres fitxers de la sèrie són en RAS</translation>
    </message>
    <message>
        <source>This kind of file is not supported</source>
        <translation>Aquest tipus de fitxer no s’admet</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Tracing the displacement field</source>
        <translation>Es calcula el camp de desplaçaments</translation>
    </message>
    <message>
        <source>Transverse colon</source>
        <translation>Còlon transvers</translation>
    </message>
    <message>
        <source>Tricuspid valve, leak</source>
        <translation>Vàlvula tricúspide, fuita</translation>
    </message>
    <message>
        <source>Tricuspid valve, open</source>
        <translation>Vàlvula tricúspide, oberta</translation>
    </message>
    <message>
        <source>Turns the directions at random; 0 leaves the icosahedron upright</source>
        <translation>Gira les direccions a l’atzar; 0 deixa l’icosàedre dret</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsió</translation>
    </message>
    <message>
        <source>Two handle files cannot be opened at a time</source>
        <translation>No es poden obrir dos fitxers de tiradors alhora</translation>
    </message>
    <message>
        <source>two handles are at one place</source>
        <translation>dos tiradors són al mateix lloc</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Procés uncinat</translation>
    </message>
    <message>
        <source>Unlock volume</source>
        <translation>Desbloqueja el volum</translation>
    </message>
    <message numerus="yes">
        <source>Unlock {handle|%n handles}</source>
        <translation>
            <numerusform>Desbloqueja el tirador</numerusform>
            <numerusform>Desbloqueja %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Upper pole</source>
        <translation>Pol superior</translation>
    </message>
    <message>
        <source>Ureter</source>
        <translation>Urèter</translation>
    </message>
    <message>
        <source>Urinary system</source>
        <translation>Aparell urinari</translation>
    </message>
    <message>
        <source>Use the hull as the cage</source>
        <translation>Fes servir l’envolupant com a gàbia</translation>
    </message>
    <message>
        <source>VTK could not write the surface: %1</source>
        <translation>VTK no ha pogut escriure la superfície: %1</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Venes</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Raó de volums</translation>
    </message>
    <message>
        <source>Voronoi regions triangulation</source>
        <translation>Triangulació de regions de Voronoi</translation>
    </message>
    <message>
        <source>Wachspress</source>
        <translation>Wachspress</translation>
    </message>
    <message>
        <source>Weights of least bending between 0 and 1; smooth and local, and follow translations only</source>
        <translation>Pesos de flexió mínima entre 0 i 1; suaus i locals, i només segueixen translacions</translation>
    </message>
    <message>
        <source>Amount added to each weight when a handle is inserted</source>
        <translation>Quantitat que se suma a cada pes quan s’insereix un tirador</translation>
    </message>
    <message>
        <source>Treatment of negative weights</source>
        <translation>Tractament dels pesos negatius</translation>
    </message>
    <message>
        <source>Pieces of the hull</source>
        <translation>Peces de l’envolupant</translation>
    </message>
    <message>
        <source>Volume that the pericardium holds without pressure</source>
        <translation>Volum que el pericardi conté sense pressió</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Quan acaba l’ascens del nombre més petit</translation>
    </message>
    <message>
        <source>Direction in which 'iterative' moves the target</source>
        <translation>Direcció en què «iterative» mou l’objectiu</translation>
    </message>
    <message>
        <source>Where waves arise, about a third of the way down</source>
        <translation>On neixen les ones, aproximadament a un terç del recorregut</translation>
    </message>
    <message>
        <source>Wire approach</source>
        <translation>Mètode del fil</translation>
    </message>
    <message>
        <source>Witness</source>
        <translation>Punt testimoni</translation>
    </message>
    <message>
        <source>Witness points of %1</source>
        <translation>Punts testimoni de %1</translation>
    </message>
    <message>
        <source>%1 of %2 ml is not life-sized: %3</source>
        <translation>%1 de %2 ml no és de mida natural: %3</translation>
    </message>
    <message>
        <source>Two of its segments have the label %1, which NIfTI cannot tell apart</source>
        <translation>Dos dels seus segments tenen l’etiqueta %1, que NIfTI no pot distingir</translation>
    </message>
    <message>
        <source>a .fcsv file is one list: the %1 groups and their colours are not kept (.mrk.json keeps them)</source>
        <translation>un fitxer .fcsv és una sola llista: els %1 grups i els seus colors no es conserven (.mrk.json els conserva)</translation>
    </message>
    <message>
        <source>a 3D Slicer fiducial table</source>
        <translation>una taula de fiducials de 3D Slicer</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>un fitxer JSON</translation>
    </message>
    <message>
        <source>a VTK XML file that holds no surface</source>
        <translation>un fitxer VTK XML sense superfície</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>un arxiu ZIP</translation>
    </message>
    <message>
        <source>a buffer is at %1, but only files beside it are read</source>
        <translation>una memòria intermèdia és a %1, però només es llegeixen fitxers del costat</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>una gàbia és una superfície basta: preneu-ne una de %1 vèrtexs com a màxim</translation>
    </message>
    <message>
        <source>a gallbladder</source>
        <translation>una vesícula biliar</translation>
    </message>
    <message>
        <source>a gzip-compressed file</source>
        <translation>un fitxer comprimit amb gzip</translation>
    </message>
    <message>
        <source>a heart</source>
        <translation>un cor</translation>
    </message>
    <message>
        <source>a kidney</source>
        <translation>un ronyó</translation>
    </message>
    <message>
        <source>a liver</source>
        <translation>un fetge</translation>
    </message>
    <message>
        <source>a locked volume must be positive</source>
        <translation>un volum bloquejat ha de ser positiu</translation>
    </message>
    <message>
        <source>a myocardium</source>
        <translation>un miocardi</translation>
    </message>
    <message>
        <source>a pancreas</source>
        <translation>un pàncrees</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>una imatge</translation>
    </message>
    <message>
        <source>a point of the centreline lies %1 outside the organ</source>
        <translation>un punt de la línia central és %1 fora de l’òrgan</translation>
    </message>
    <message>
        <source>a scan</source>
        <translation>una exploració</translation>
    </message>
    <message>
        <source>a spleen</source>
        <translation>una melsa</translation>
    </message>
    <message>
        <source>a stomach</source>
        <translation>un estómac</translation>
    </message>
    <message>
        <source>a surface</source>
        <translation>una superfície</translation>
    </message>
    <message>
        <source>a surface of %1 vertices and %2 triangles is too small for handles</source>
        <translation>una superfície de %1 vèrtexs i %2 triangles és massa petita per a tiradors</translation>
    </message>
    <message>
        <source>add a group that encloses them, or put handles around them into a group</source>
        <translation>afegiu un grup que els envolti, o poseu en un grup tiradors que els envoltin</translation>
    </message>
    <message>
        <source>add a handle off that plane</source>
        <translation>afegiu un tirador fora d’aquest pla</translation>
    </message>
    <message>
        <source>add handles to it</source>
        <translation>afegiu-hi tiradors</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>afegiu tiradors, o col·loqueu-los automàticament</translation>
    </message>
    <message>
        <source>add its file, or remove those of the other surfaces in that phase</source>
        <translation>afegiu-ne el fitxer, o traieu els de les altres superfícies d’aquella fase</translation>
    </message>
    <message>
        <source>add the enclosing handles, or move handles outward until they surround the organ</source>
        <translation>afegiu els tiradors envoltants, o moveu tiradors cap enfora fins que envoltin l’òrgan</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>afegit per l’agrupació automàtica</translation>
    </message>
    <message>
        <source>all handles</source>
        <translation>tots els tiradors</translation>
    </message>
    <message>
        <source>all handles lie in one plane</source>
        <translation>tots els tiradors són en un pla</translation>
    </message>
    <message>
        <source>all handles lie on one line</source>
        <translation>tots els tiradors són en una recta</translation>
    </message>
    <message>
        <source>all its handles lie in one plane, so its region is flat</source>
        <translation>tots els seus tiradors són en un pla, de manera que la seva regió és plana</translation>
    </message>
    <message>
        <source>all of it is a cavity</source>
        <translation>tot és cavitat</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>tots els punts són en un pla</translation>
    </message>
    <message>
        <source>an error without a message</source>
        <translation>un error sense missatge</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>antrum</source>
        <translation>antre</translation>
    </message>
    <message>
        <source>as in --period-ms 829</source>
        <translation>com a --period-ms 829</translation>
    </message>
    <message>
        <source>ask for a volume nearer to that at rest, or let more handles compensate</source>
        <translation>demaneu un volum més proper al de repòs, o deixeu que compensin més tiradors</translation>
    </message>
    <message>
        <source>ask for at least %1</source>
        <translation>demaneu-ne almenys %1</translation>
    </message>
    <message>
        <source>ask for fewer groups</source>
        <translation>demaneu menys grups</translation>
    </message>
    <message>
        <source>ask for fewer witness points</source>
        <translation>demaneu menys punts testimoni</translation>
    </message>
    <message>
        <source>ask for fewer, or put them nearer to the surface</source>
        <translation>demaneu-ne menys, o poseu-los més a prop de la superfície</translation>
    </message>
    <message>
        <source>at least %1 are needed</source>
        <translation>se’n necessiten almenys %1</translation>
    </message>
    <message>
        <source>atrial systole</source>
        <translation>sístole auricular</translation>
    </message>
    <message>
        <source>bind it first</source>
        <translation>vinculeu-lo primer</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cos</translation>
    </message>
    <message>
        <source>bounded biharmonic weights</source>
        <translation>pesos biharmònics acotats</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's left, but it lies on the right (x = %1 mm): %2</source>
        <translation>pel nom va a l’esquerra del pacient, però és a la dreta (x = %1 mm): %2</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's right, but it lies on the left (x = %1 mm): %2</source>
        <translation>pel nom va a la dreta del pacient, però és a l’esquerra (x = %1 mm): %2</translation>
    </message>
    <message>
        <source>call the left ventricle's cavity LV and the right one's RV</source>
        <translation>anomeneu LV la cavitat del ventricle esquerre i RV la del dret</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>no es pot obrir: %1</translation>
    </message>
    <message>
        <source>cannot place %1 witness points</source>
        <translation>no es poden col·locar %1 punts testimoni</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>cabal cardíac</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetres</translation>
    </message>
    <message>
        <source>check its ending</source>
        <translation>comproveu-ne l’extensió</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>comproveu-ne els permisos</translation>
    </message>
    <message>
        <source>check its scale and its number format</source>
        <translation>comproveu-ne l’escala i el format dels nombres</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>comproveu-ne la unitat; les coordenades són en mm</translation>
    </message>
    <message>
        <source>check that its surface is closed and outward</source>
        <translation>comproveu que la seva superfície és tancada i orientada cap enfora</translation>
    </message>
    <message>
        <source>check that its triangles face outward and that its holes are small</source>
        <translation>comproveu que els seus triangles miren cap enfora i que els seus forats són petits</translation>
    </message>
    <message>
        <source>check that the segmentation was saved</source>
        <translation>comproveu que la segmentació es va desar</translation>
    </message>
    <message>
        <source>check that there is room on the disk</source>
        <translation>comproveu que hi ha espai al disc</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>comproveu que teniu permís de lectura</translation>
    </message>
    <message>
        <source>check the disk or the connection</source>
        <translation>comproveu el disc o la connexió</translation>
    </message>
    <message>
        <source>check the name and the folder</source>
        <translation>comproveu el nom i la carpeta</translation>
    </message>
    <message>
        <source>check the space left on the disk</source>
        <translation>comproveu l’espai lliure al disc</translation>
    </message>
    <message>
        <source>check their order, and the period</source>
        <translation>comproveu-ne l’ordre i el període</translation>
    </message>
    <message>
        <source>check this phase, or leave it out</source>
        <translation>comproveu aquesta fase, o ometeu-la</translation>
    </message>
    <message>
        <source>check what the file is and where it came from</source>
        <translation>comproveu què és el fitxer i d’on ve</translation>
    </message>
    <message>
        <source>check whether one of them is mislabelled, or leave it out</source>
        <translation>comproveu si una d’elles està mal etiquetada, o ometeu-la</translation>
    </message>
    <message>
        <source>choose %1 to %2</source>
        <translation>trieu de %1 a %2</translation>
    </message>
    <message>
        <source>choose a closed surface</source>
        <translation>trieu una superfície tancada</translation>
    </message>
    <message>
        <source>choose a file that Viscera has saved as .sequence.json</source>
        <translation>trieu un fitxer que Viscera hagi desat com a .sequence.json</translation>
    </message>
    <message>
        <source>choose a file that Viscera has saved as .viscera</source>
        <translation>trieu un fitxer que Viscera hagi desat com a .viscera</translation>
    </message>
    <message>
        <source>choose a file with a triangle surface</source>
        <translation>trieu un fitxer amb una superfície de triangles</translation>
    </message>
    <message>
        <source>choose a folder that exists, may be written to and has room</source>
        <translation>trieu una carpeta que existeixi, on es pugui escriure i que tingui espai</translation>
    </message>
    <message>
        <source>choose a surface that has some</source>
        <translation>trieu una superfície que en tingui</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>trieu-ne un altre</translation>
    </message>
    <message>
        <source>choose at least one</source>
        <translation>trieu-ne almenys una</translation>
    </message>
    <message>
        <source>choose it again in Play mode</source>
        <translation>torneu-lo a triar en el mode Reprodueix</translation>
    </message>
    <message>
        <source>choose it on the organ; check the axes (RAS or LPS) too</source>
        <translation>trieu-lo sobre l’òrgan; comproveu també els eixos (RAS o LPS)</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>trieu-ne un</translation>
    </message>
    <message>
        <source>choose the two ends of the organ</source>
        <translation>trieu els dos extrems de l’òrgan</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>trieu dos extrems d’una superfície</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>tanqueu-ne primer els forats</translation>
    </message>
    <message>
        <source>close its holes, as viscera convert IN OUT --fill-holes does; an open surface has no volume to keep</source>
        <translation>tanqueu-ne els forats, per exemple amb viscera convert ENTRADA SORTIDA --fill-holes; una superfície oberta no té volum per conservar</translation>
    </message>
    <message>
        <source>close other programs, or use fewer handles or smaller organs</source>
        <translation>tanqueu altres programes, o feu servir menys tiradors o òrgans més petits</translation>
    </message>
    <message>
        <source>compensating handles</source>
        <translation>tiradors que compensen</translation>
    </message>
    <message>
        <source>convert it to .seg.nrrd</source>
        <translation>convertiu-lo a .seg.nrrd</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>les coordenades necessiten almenys quatre tiradors, n’hi ha %1</translation>
    </message>
    <message>
        <source>copy its contents to a file first</source>
        <translation>copieu-ne primer el contingut en un fitxer</translation>
    </message>
    <message>
        <source>copy the file anew, or take it out of the folder to read the others</source>
        <translation>torneu a copiar el fitxer, o traieu-lo de la carpeta per llegir els altres</translation>
    </message>
    <message>
        <source>crop the image to the organs</source>
        <translation>retalleu la imatge als òrgans</translation>
    </message>
    <message>
        <source>deeper ones would push folds of the surface into one another</source>
        <translation>unes de més profundes empenyerien els plecs de la superfície els uns contra els altres</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>graus</translation>
    </message>
    <message>
        <source>derivatives at the witness points</source>
        <translation>derivades als punts testimoni</translation>
    </message>
    <message>
        <source>diastasis</source>
        <translation>diàstasi</translation>
    </message>
    <message>
        <source>diastole</source>
        <translation>diàstole</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distància</translation>
    </message>
    <message>
        <source>does not say how large its pixels are</source>
        <translation>no indica la mida dels seus píxels</translation>
    </message>
    <message>
        <source>does not say where in the patient it lies</source>
        <translation>no indica on és en el pacient</translation>
    </message>
    <message>
        <source>does not say where its frames lie</source>
        <translation>no indica on són els seus fotogrames</translation>
    </message>
    <message>
        <source>ejection</source>
        <translation>ejecció</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>fracció d’ejecció</translation>
    </message>
    <message>
        <source>end-diastolic volume</source>
        <translation>volum telediastòlic</translation>
    </message>
    <message>
        <source>end-systolic volume</source>
        <translation>volum telesistòlic</translation>
    </message>
    <message>
        <source>even so, folds of the surface meet when they pass</source>
        <translation>tot i així, els plecs de la superfície es toquen quan passen</translation>
    </message>
    <message>
        <source>exchanges left and right</source>
        <translation>intercanvia esquerra i dreta</translation>
    </message>
    <message>
        <source>expiration</source>
        <translation>espiració</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same axes</source>
        <translation>exporteu totes les superfícies d’un pacient amb els mateixos eixos</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same way (viscera convert --space LPS)</source>
        <translation>exporteu totes les superfícies d’un pacient de la mateixa manera (viscera convert --space LPS)</translation>
    </message>
    <message>
        <source>export it as a surface of triangles</source>
        <translation>exporteu-la com a superfície de triangles</translation>
    </message>
    <message>
        <source>export it as glTF 2.0</source>
        <translation>exporteu-lo com a glTF 2.0</translation>
    </message>
    <message>
        <source>export it as pixels of 16 bits</source>
        <translation>exporteu-lo amb píxels de 16 bits</translation>
    </message>
    <message>
        <source>export it little-endian</source>
        <translation>exporteu-lo en ordre little-endian</translation>
    </message>
    <message>
        <source>export it without compression</source>
        <translation>exporteu-lo sense compressió</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>torneu a exportar o copiar el fitxer</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>torneu a exportar la superfície</translation>
    </message>
    <message>
        <source>extract its surface first</source>
        <translation>extraieu-ne primer la superfície</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>ompliment</translation>
    </message>
    <message>
        <source>filling the handles with tetrahedra</source>
        <translation>ompliment dels tiradors amb tetràedres</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>ompliment de l’òrgan amb tetràedres</translation>
    </message>
    <message>
        <source>fills every hole with a cap</source>
        <translation>tanca cada forat amb una tapa</translation>
    </message>
    <message>
        <source>finding landmarks</source>
        <translation>cerca de punts de referència</translation>
    </message>
    <message>
        <source>folded where it is hatched</source>
        <translation>plegat on és ratllat</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>fundus</translation>
    </message>
    <message>
        <source>fundus, centreline from the fundus down, body in between, pylorus</source>
        <translation>fundus, línia central des del fundus avall, cos al mig, pílor</translation>
    </message>
    <message>
        <source>give apex and base too</source>
        <translation>indiqueu també apex i base</translation>
    </message>
    <message>
        <source>give both, or none to have them computed</source>
        <translation>indiqueu-los tots dos, o cap perquè es calculin</translation>
    </message>
    <message>
        <source>give every handle a label of its own</source>
        <translation>doneu a cada tirador una etiqueta pròpia</translation>
    </message>
    <message>
        <source>give fundus and pylorus too</source>
        <translation>indiqueu també fundus i pylorus</translation>
    </message>
    <message>
        <source>give it another one</source>
        <translation>doneu-n’hi un altre</translation>
    </message>
    <message>
        <source>give it one</source>
        <translation>doneu-n’hi un</translation>
    </message>
    <message>
        <source>give its labels smaller numbers</source>
        <translation>doneu nombres més petits a les etiquetes</translation>
    </message>
    <message>
        <source>give one between 0.1 and 0.8</source>
        <translation>indiqueu-ne una entre 0,1 i 0,8</translation>
    </message>
    <message>
        <source>give one for each phase</source>
        <translation>indiqueu-ne un per a cada fase</translation>
    </message>
    <message>
        <source>give points of the centreline yourself</source>
        <translation>indiqueu vós mateix punts de la línia central</translation>
    </message>
    <message>
        <source>give the outer surface the labels of its cavities too, as in EPI=1,2,3</source>
        <translation>doneu a la superfície exterior també les etiquetes de les seves cavitats, com a EPI=1,2,3</translation>
    </message>
    <message>
        <source>glTF does not say which axes a patient&apos;s are: its numbers are taken as LPS millimetres, though the format&apos;s convention is metres with y up</source>
        <translation>glTF no diu quins són els eixos del pacient: els nombres es prenen com a mil·límetres LPS, tot i que el format preveu metres amb y cap amunt</translation>
    </message>
    <message>
        <source>grid inside the surface</source>
        <translation>quadrícula dins de la superfície</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grup</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>grup %1</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;</source>
        <translation>grup «%1»</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>tirador</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>tirador %1</translation>
    </message>
    <message>
        <source>handles %1 and %2</source>
        <translation>tiradors %1 i %2</translation>
    </message>
    <message>
        <source>harmonic coordinates</source>
        <translation>coordenades harmòniques</translation>
    </message>
    <message numerus="yes">
        <source>has %n {column|columns}</source>
        <translation>
            <numerusform>té %n columna</numerusform>
            <numerusform>té %n columnes</numerusform>
        </translation>
    </message>
    <message>
        <source>has a heading that does not say what the instants are</source>
        <translation>té un encapçalament que no diu què són els instants</translation>
    </message>
    <message>
        <source>has a volume that is not positive</source>
        <translation>té un volum que no és positiu</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>no té píxels</translation>
    </message>
    <message>
        <source>has pixels that are fractions (Float Pixel Data), which Viscera does not read; export it as whole numbers, or as NIfTI</source>
        <translation>té píxels decimals (Float Pixel Data), que Viscera no llegeix; exporteu-lo amb nombres enters o com a NIfTI</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>manté</translation>
    </message>
    <message>
        <source>holds something that is not a number</source>
        <translation>conté alguna cosa que no és un nombre</translation>
    </message>
    <message>
        <source>if it is not a whole cycle, say that it is to be played once (--once); else add the phases that are missing</source>
        <translation>si no és un cicle sencer, indiqueu que es reprodueixi un cop (--once); si ho és, afegiu les fases que falten</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>polzades</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>inspiració</translation>
    </message>
    <message>
        <source>install Viscera again, or name it in VISCERA_TETGEN_WORKER</source>
        <translation>torneu a instal·lar Viscera, o indiqueu-lo a VISCERA_TETGEN_WORKER</translation>
    </message>
    <message>
        <source>install ffmpeg, or write an .ogv</source>
        <translation>instal·leu ffmpeg, o escriviu un .ogv</translation>
    </message>
    <message>
        <source>is a colour image</source>
        <translation>és una imatge en color</translation>
    </message>
    <message>
        <source>is a mosaic of many slices in one image, as Siemens writes them, which Viscera does not take apart; convert it to NIfTI (dcm2niix does)</source>
        <translation>és un mosaic de molts talls en una imatge, com els escriu Siemens, que Viscera no separa; convertiu-lo a NIfTI (dcm2niix ho fa)</translation>
    </message>
    <message>
        <source>is not a file that can be read</source>
        <translation>no és un fitxer que es pugui llegir</translation>
    </message>
    <message>
        <source>is not later than the line before</source>
        <translation>no és posterior a la línia anterior</translation>
    </message>
    <message numerus="yes">
        <source>is not manifold at %n {edge|edges}</source>
        <translation>
            <numerusform>no és una varietat en %n aresta</numerusform>
            <numerusform>no és una varietat en %n arestes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>is open at %n {edge|edges}</source>
        <translation>
            <numerusform>és oberta en %n aresta</numerusform>
            <numerusform>és oberta en %n arestes</numerusform>
        </translation>
    </message>
    <message>
        <source>is too thin in places for a surface with the volume of its voxels</source>
        <translation>és en alguns llocs massa prim per a una superfície amb el volum dels seus vòxels</translation>
    </message>
    <message>
        <source>isovolumic contraction</source>
        <translation>contracció isovolumètrica</translation>
    </message>
    <message>
        <source>isovolumic relaxation</source>
        <translation>relaxació isovolumètrica</translation>
    </message>
    <message>
        <source>it does not lie within the period</source>
        <translation>no és dins del període</translation>
    </message>
    <message>
        <source>it does not say how large its voxels are; 1 mm is assumed</source>
        <translation>no indica la mida dels vòxels; se suposa 1 mm</translation>
    </message>
    <message>
        <source>it does not say where the patient's sides are; axes are taken as right, front and up</source>
        <translation>no indica on són els costats del pacient; els eixos es prenen com a dreta, davant i amunt</translation>
    </message>
    <message>
        <source>it follows no handles, so nothing can change its volume</source>
        <translation>no segueix cap tirador, així que res no pot canviar el seu volum</translation>
    </message>
    <message>
        <source>it has %1 triangles</source>
        <translation>té %1 triangles</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>no té nom</translation>
    </message>
    <message>
        <source>it is not a millisecond at least behind the key before it</source>
        <translation>no és almenys un mil·lisegon després de la clau anterior</translation>
    </message>
    <message>
        <source>it may be mirrored</source>
        <translation>potser és reflectit</translation>
    </message>
    <message>
        <source>its axes %1 are unknown; LPS is assumed</source>
        <translation>els seus eixos %1 no es coneixen; se suposa LPS</translation>
    </message>
    <message>
        <source>its encoding %1 is not supported</source>
        <translation>la seva codificació %1 no s’admet</translation>
    </message>
    <message>
        <source>its file %1 is not there any more (put it beside the session and open that again)</source>
        <translation>el seu fitxer %1 ja no hi és (poseu-lo al costat de la sessió i torneu-la a obrir)</translation>
    </message>
    <message>
        <source>its file was found as %1</source>
        <translation>el seu fitxer s’ha trobat com a %1</translation>
    </message>
    <message>
        <source>its frames lie in different directions</source>
        <translation>els seus fotogrames són en direccions diferents</translation>
    </message>
    <message>
        <source>its labels are those of a heart: muscle and chambers are its outer surface, each chamber is a cavity</source>
        <translation>les seves etiquetes són les d’un cor: el múscul i les cavitats cardíaques en formen la superfície exterior, cadascuna d’aquestes és una cavitat</translation>
    </message>
    <message>
        <source>its pixels of %1 bits in %2, up to bit %3, are not supported</source>
        <translation>els seus píxels de %1 bits en %2, fins al bit %3, no s’admeten</translation>
    </message>
    <message>
        <source>its sform and qform place the image differently; the sform is used</source>
        <translation>la sform i la qform col·loquen la imatge de manera diferent; es fa servir sform</translation>
    </message>
    <message>
        <source>its sform is singular or not finite and is not used</source>
        <translation>la sform és singular o no és finita i no es fa servir</translation>
    </message>
    <message>
        <source>its slices are not equally far from each other (frame %1)</source>
        <translation>els seus talls no són a la mateixa distància els uns dels altres (fotograma %1)</translation>
    </message>
    <message>
        <source>its surface has changed: measured points were moved to the nearest places on the new surface</source>
        <translation>la seva superfície ha canviat: els punts mesurats s’han mogut als llocs més propers de la superfície nova</translation>
    </message>
    <message>
        <source>its surface is open, so it has no volume that could be locked</source>
        <translation>la seva superfície és oberta, així que no té volum per bloquejar</translation>
    </message>
    <message numerus="yes">
        <source>its surface was closed by %n {cap|caps}</source>
        <translation>
            <numerusform>la seva superfície s’ha tancat amb %n tapa</numerusform>
            <numerusform>la seva superfície s’ha tancat amb %n tapes</numerusform>
        </translation>
    </message>
    <message>
        <source>its triangles were turned around to face outward</source>
        <translation>els seus triangles s’han girat cap enfora</translation>
    </message>
    <message>
        <source>its two ends are at one place</source>
        <translation>els seus dos extrems són al mateix lloc</translation>
    </message>
    <message>
        <source>its two ends are on separate pieces</source>
        <translation>els seus dos extrems són en peces separades</translation>
    </message>
    <message>
        <source>its volume can be kept only after it is bound to the present handles</source>
        <translation>el seu volum només es pot mantenir després de vincular-lo als tiradors presents</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>el seu volum ja no està bloquejat: ara la superfície és oberta</translation>
    </message>
    <message>
        <source>its voxels lie elsewhere than those of the other masks</source>
        <translation>els seus vòxels són en un altre lloc que els de les altres màscares</translation>
    </message>
    <message>
        <source>keep the largest, as viscera convert IN OUT --keep-largest does</source>
        <translation>conserveu la més gran, per exemple amb viscera convert ENTRADA SORTIDA --keep-largest</translation>
    </message>
    <message>
        <source>keeps the piece with the largest area and drops the others</source>
        <translation>conserva la peça d’àrea més gran i descarta les altres</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clau</translation>
    </message>
    <message>
        <source>mmHg</source>
        <translation>mmHg</translation>
    </message>
    <message>
        <source>start</source>
        <translation>inici</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>clau %1</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>quilòmetres</translation>
    </message>
    <message>
        <source>known endings: %1</source>
        <translation>extensions conegudes: %1</translation>
    </message>
    <message>
        <source>label it in every phase, or leave this phase out</source>
        <translation>etiqueteu-lo en totes les fases, o ometeu aquesta fase</translation>
    </message>
    <message>
        <source>label the points %1</source>
        <translation>anomeneu els punts %1</translation>
    </message>
    <message>
        <source>leave it out for surfaces</source>
        <translation>ometeu-ho per a superfícies</translation>
    </message>
    <message>
        <source>leave the landmarks out</source>
        <translation>ometeu els punts de referència</translation>
    </message>
    <message>
        <source>leave two: the instant, and the volume in ml</source>
        <translation>deixeu-ne dues: l’instant i el volum en ml</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>allargueu primer el període</translation>
    </message>
    <message>
        <source>let it begin with &quot;time_s&quot; for seconds, or with &quot;fraction&quot; for parts of the cycle</source>
        <translation>que comenci per «time_s» per a segons, o per «fraction» per a parts del cicle</translation>
    </message>
    <message>
        <source>let more handles compensate, or ask for a volume nearer to the present one</source>
        <translation>deixeu que compensin més tiradors, o demaneu un volum més proper a l’actual</translation>
    </message>
    <message>
        <source>let the last volume be the first one</source>
        <translation>feu que l’últim volum sigui igual al primer</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineal</translation>
    </message>
    <message>
        <source>load a closed surface</source>
        <translation>carregueu una superfície tancada</translation>
    </message>
    <message>
        <source>localised coordinates</source>
        <translation>coordenades localitzades</translation>
    </message>
    <message>
        <source>looking for folds</source>
        <translation>cerca de plecs</translation>
    </message>
    <message>
        <source>make the handles from this cage: viscera handles ORGAN --cage FILE</source>
        <translation>feu els tiradors amb aquesta gàbia: viscera handles ÒRGAN --cage FITXER</translation>
    </message>
    <message>
        <source>makes a closed surface without intersections near this one; colours are lost</source>
        <translation>fa una superfície tancada sense interseccions a prop d’aquesta; els colors es perden</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>mesura</translation>
    </message>
    <message>
        <source>measurement %1</source>
        <translation>mesura %1</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metres</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micròmetres</translation>
    </message>
    <message>
        <source>centreline</source>
        <translation>línia central</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>mil·límetres</translation>
    </message>
    <message>
        <source>move it elsewhere, or remove one of the two</source>
        <translation>moveu-la, o traieu-ne una de les dues</translation>
    </message>
    <message>
        <source>move one out of the plane</source>
        <translation>moveu-ne un fora del pla</translation>
    </message>
    <message>
        <source>move or delete one of them</source>
        <translation>moveu o suprimiu-ne un</translation>
    </message>
    <message>
        <source>move or remove one of them</source>
        <translation>moveu-ne o traieu-ne un</translation>
    </message>
    <message>
        <source>move some off the line</source>
        <translation>traieu-ne alguns de la recta</translation>
    </message>
    <message>
        <source>move some off the plane, or add enclosing handles</source>
        <translation>traieu-ne alguns del pla, o afegiu tiradors envoltants</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>separeu-hi els vèrtexs, o preneu una altra gàbia</translation>
    </message>
    <message>
        <source>movies of this kind cannot be written</source>
        <translation>no es poden escriure pel·lícules d’aquest tipus</translation>
    </message>
    <message>
        <source>name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase</source>
        <translation>indiqueu un NIfTI 4D, un .seq.nrrd de 3D Slicer o un fitxer per a cada fase</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>indiqueu un fitxer que hi hagi</translation>
    </message>
    <message>
        <source>name a folder with one file for each phase</source>
        <translation>indiqueu una carpeta amb un fitxer per a cada fase</translation>
    </message>
    <message>
        <source>name a folder with one mask for each organ, such as liver.nii.gz</source>
        <translation>indiqueu una carpeta amb una màscara per a cada òrgan, com liver.nii.gz</translation>
    </message>
    <message>
        <source>name all phases of the cycle</source>
        <translation>indiqueu totes les fases del cicle</translation>
    </message>
    <message>
        <source>name all phases of the cycle; a single image of a heart with cavities can beat as the textbook's (--textbook, in the window Fit a sequence to an organ)</source>
        <translation>indiqueu totes les fases del cicle; una sola imatge d’un cor amb cavitats pot bategar com al llibre de text (--textbook; a la finestra, ajustar una seqüència a un òrgan)</translation>
    </message>
    <message>
        <source>name compensating handles</source>
        <translation>indiqueu tiradors que compensin</translation>
    </message>
    <message>
        <source>name instants from 0 to 1</source>
        <translation>indiqueu instants de 0 a 1</translation>
    </message>
    <message>
        <source>name instants from 0 to 1, or write &quot;time_s&quot; above them for seconds</source>
        <translation>indiqueu instants de 0 a 1, o escriviu «time_s» a sobre per a segons</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>anomeneu-lo %1</translation>
    </message>
    <message>
        <source>name its files, a folder, or a file with several phases</source>
        <translation>indiqueu-ne els fitxers, una carpeta o un fitxer amb diverses fases</translation>
    </message>
    <message>
        <source>name the folder of a CT or MR series</source>
        <translation>indiqueu la carpeta d’una sèrie de TC o RM</translation>
    </message>
    <message>
        <source>name the folder of one patient</source>
        <translation>indiqueu la carpeta d’un sol pacient</translation>
    </message>
    <message>
        <source>name the folder, or another file in it</source>
        <translation>indiqueu la carpeta, o un altre fitxer que hi hagi</translation>
    </message>
    <message>
        <source>names an instant outside the cycle</source>
        <translation>anomena un instant fora del cicle</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>nanòmetres</translation>
    </message>
    <message>
        <source>no compensation within %1 mm restores the volume</source>
        <translation>cap compensació dins de %1 mm restableix el volum</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>cap aresta uneix més de dos triangles</translation>
    </message>
    <message>
        <source>no handle is left to compensate the change of volume</source>
        <translation>no queda cap tirador que compensi el canvi de volum</translation>
    </message>
    <message>
        <source>no harmonic function can be found on the surface</source>
        <translation>no es troba cap funció harmònica a la superfície</translation>
    </message>
    <message>
        <source>no motion near to this one keeps the volume</source>
        <translation>cap moviment proper a aquest manté el volum</translation>
    </message>
    <message>
        <source>no witness point lies inside</source>
        <translation>cap punt testimoni és a dins</translation>
    </message>
    <message>
        <source>node %1 is moved by bones, which are ignored</source>
        <translation>el node %1 es mou per ossos, que s’ignoren</translation>
    </message>
    <message>
        <source>of an unknown kind</source>
        <translation>de tipus desconegut</translation>
    </message>
    <message numerus="yes">
        <source>only %n {handle|handles}</source>
        <translation>
            <numerusform>només %n tirador</numerusform>
            <numerusform>només %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>obriu-la al costat dels òrgans (Fitxer &gt; Obre una exploració), o feu-ne primer un mapa d’etiquetes, amb 3D Slicer o TotalSegmentator</translation>
    </message>
    <message>
        <source>open it by itself, or remove it from the folder</source>
        <translation>obriu-lo tot sol, o traieu-lo de la carpeta</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>obriu-ne un primer</translation>
    </message>
    <message>
        <source>open it by itself, and the other files after it</source>
        <translation>obriu-la sola, i els altres fitxers després</translation>
    </message>
    <message>
        <source>open it with File &gt; Open</source>
        <translation>obriu-la amb Fitxer &gt; Obre</translation>
    </message>
    <message>
        <source>open the segmentation that was made from it</source>
        <translation>obriu la segmentació que se n’ha fet</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>òrgan</translation>
    </message>
    <message>
        <source>organ %1</source>
        <translation>òrgan %1</translation>
    </message>
    <message>
        <source>out</source>
        <translation>sortida</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pausa</translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation>fase %1</translation>
    </message>
    <message>
        <source>phase %1 fits much worse than its neighbours (%2 against %3 mm): look at its data, or leave it out</source>
        <translation>la fase %1 s’ajusta molt pitjor que les veïnes (%2 contra %3 mm): reviseu-ne les dades, o ometeu-la</translation>
    </message>
    <message>
        <source>phase %1: %2</source>
        <translation>fase %1: %2</translation>
    </message>
    <message>
        <source>pick the point on the surface again</source>
        <translation>torneu a triar el punt de la superfície</translation>
    </message>
    <message>
        <source>place handles around it</source>
        <translation>col·loqueu tiradors al voltant</translation>
    </message>
    <message>
        <source>place more handles</source>
        <translation>col·loqueu més tiradors</translation>
    </message>
    <message>
        <source>place some first</source>
        <translation>col·loqueu-ne primer</translation>
    </message>
    <message>
        <source>place some points and save them again</source>
        <translation>poseu alguns punts i torneu-los a desar</translation>
    </message>
    <message>
        <source>place the handle again</source>
        <translation>torneu a col·locar el tirador</translation>
    </message>
    <message>
        <source>placing handles</source>
        <translation>col·locació de tiradors</translation>
    </message>
    <message>
        <source>play at the rate that the times are for</source>
        <translation>reproduïu a la freqüència per a la qual valen els temps</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>ho causen punts que coincideixen o gairebé plans</translation>
    </message>
    <message>
        <source>put both files into one folder</source>
        <translation>poseu els dos fitxers en una carpeta</translation>
    </message>
    <message>
        <source>put it into the middle of the stomach</source>
        <translation>poseu-lo al mig de l’estómac</translation>
    </message>
    <message>
        <source>put masks of one image into a folder of their own</source>
        <translation>poseu les màscares d’una mateixa imatge en una carpeta pròpia</translation>
    </message>
    <message>
        <source>put those of one kind into a folder of their own</source>
        <translation>poseu els d’un tipus en una carpeta pròpia</translation>
    </message>
    <message>
        <source>pylorus</source>
        <translation>pílor</translation>
    </message>
    <message>
        <source>rapid ejection</source>
        <translation>ejecció ràpida</translation>
    </message>
    <message>
        <source>rapid filling</source>
        <translation>ompliment ràpid</translation>
    </message>
    <message>
        <source>reaches the edge of the image, which may cut it off</source>
        <translation>arriba a la vora de la imatge, que potser el retalla</translation>
    </message>
    <message>
        <source>add a key first</source>
        <translation>afegiu primer una clau</translation>
    </message>
    <message>
        <source>record and save the sequence again</source>
        <translation>torneu a enregistrar i desar la seqüència</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>reduce the surface first</source>
        <translation>reduïu primer la superfície</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>ejecció reduïda</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>traieu-ne un dels dos</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>traieu-ne un</translation>
    </message>
    <message>
        <source>remove one of them from the file</source>
        <translation>traieu-ne un del fitxer</translation>
    </message>
    <message>
        <source>repair the surface</source>
        <translation>repareu la superfície</translation>
    </message>
    <message>
        <source>repair the surface in another program first</source>
        <translation>repareu primer la superfície en un altre programa</translation>
    </message>
    <message>
        <source>repaired on import: %1</source>
        <translation>reparat en importar: %1</translation>
    </message>
    <message>
        <source>repairing the surface</source>
        <translation>reparació de la superfície</translation>
    </message>
    <message>
        <source>resample all phases to one grid, in the same axes</source>
        <translation>remostregeu totes les fases en una mateixa quadrícula, amb els mateixos eixos</translation>
    </message>
    <message>
        <source>resample the images to an upright grid</source>
        <translation>remostregeu les imatges en una quadrícula recta</translation>
    </message>
    <message>
        <source>resample the segmentation, for example by saving it as .seg.nrrd</source>
        <translation>remostregeu la segmentació, per exemple desant-la com a .seg.nrrd</translation>
    </message>
    <message>
        <source>reset the pose</source>
        <translation>restabliu la postura</translation>
    </message>
    <message>
        <source>restoring the volume would move a handle by %1 mm</source>
        <translation>restablir el volum mouria un tirador %1 mm</translation>
    </message>
    <message>
        <source>right and left are exchanged, and so are front and back: the files seem to be in RAS</source>
        <translation>dreta i esquerra estan canviades, i també davant i darrere: els fitxers semblen ser en RAS</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>dreta i esquerra estan intercanviades, davant i darrere no: emmirallat</translation>
    </message>
    <message>
        <source>right and left are exchanged: the files may be in RAS, or mirrored</source>
        <translation>dreta i esquerra estan canviades: potser els fitxers són en RAS o reflectits</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>deseu-lo primer en un fitxer propi</translation>
    </message>
    <message>
        <source>save it as a segmentation</source>
        <translation>deseu-lo com a segmentació</translation>
    </message>
    <message>
        <source>save it as a 3D image</source>
        <translation>deseu-la com a imatge 3D</translation>
    </message>
    <message>
        <source>save it with gzip or raw encoding</source>
        <translation>deseu-lo amb la codificació gzip o raw</translation>
    </message>
    <message>
        <source>save it with one value per voxel</source>
        <translation>deseu-la amb un valor per vòxel</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>deseu sovint, o feu-hi lloc</translation>
    </message>
    <message>
        <source>save the points from Slicer as .mrk.json</source>
        <translation>deseu els punts des de Slicer com a .mrk.json</translation>
    </message>
    <message>
        <source>save the points from Slicer in LPS</source>
        <translation>deseu els punts des de Slicer en LPS</translation>
    </message>
    <message>
        <source>give it with --period-ms, or the rate with --rate</source>
        <translation>indiqueu-la amb --period-ms, o la freqüència amb --rate</translation>
    </message>
    <message>
        <source>say which surfaces they make, as in --surface LV=1 --surface RV=2 --surface EPI=1,2,3 with all labels within the outer one</source>
        <translation>indiqueu quines superfícies formen, com a --surface LV=1 --surface RV=2 --surface EPI=1,2,3, amb totes les etiquetes dins de l’exterior</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suau</translation>
    </message>
    <message>
        <source>sort the lines by their instants</source>
        <translation>ordeneu les línies pels instants</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>esfera</translation>
    </message>
    <message>
        <source>stress over the sequence</source>
        <translation>tensió al llarg de la seqüència</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>volum sistòlic</translation>
    </message>
    <message>
        <source>surfaces at rest</source>
        <translation>superfícies en repòs</translation>
    </message>
    <message>
        <source>system parameters</source>
        <translation>paràmetres del sistema</translation>
    </message>
    <message>
        <source>systole</source>
        <translation>sístole</translation>
    </message>
    <message>
        <source>take a backup of the file, or begin a new session with the organs' own files</source>
        <translation>preneu una còpia de seguretat del fitxer, o comenceu una sessió nova amb els fitxers dels òrgans</translation>
    </message>
    <message>
        <source>take a cage that surrounds the organ, or the handles' convex hull as the cage</source>
        <translation>preneu una gàbia que envolti l’òrgan, o l’envolupant convexa dels tiradors com a gàbia</translation>
    </message>
    <message>
        <source>take a closed cage, or none: then the convex hull of the handles is the cage</source>
        <translation>preneu una gàbia tancada o cap: aleshores l’envolupant convexa dels tiradors és la gàbia</translation>
    </message>
    <message>
        <source>take a convex cage, or none: then the convex hull of the handles is the cage</source>
        <translation>preneu una gàbia convexa o cap: aleshores l’envolupant convexa dels tiradors és la gàbia</translation>
    </message>
    <message>
        <source>take a larger one</source>
        <translation>preneu-ne un de més gran</translation>
    </message>
    <message>
        <source>take another positivity</source>
        <translation>trieu una altra positivitat</translation>
    </message>
    <message>
        <source>take the sequence's own handles</source>
        <translation>preneu els tiradors propis de la seqüència</translation>
    </message>
    <message>
        <source>takes the coordinates as %1</source>
        <translation>pren les coordenades com a %1</translation>
    </message>
    <message>
        <source>terminal antral contraction</source>
        <translation>contracció antral terminal</translation>
    </message>
    <message>
        <source>the Delaunay tetrahedra of %1 points cannot be computed</source>
        <translation>no es poden calcular els tetràedres de Delaunay de %1 punts</translation>
    </message>
    <message>
        <source>the cage</source>
        <translation>la gàbia</translation>
    </message>
    <message>
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>no es pot calcular l’envolupant convexa de %1 punts</translation>
    </message>
    <message>
        <source>the coordinates are kept in single precision: they would take %1 MiB otherwise</source>
        <translation>les coordenades es guarden en precisió simple; si no, ocuparien %1 MiB</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>el fitxer no indica els seus eixos: se suposa LPS</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el fitxer és buit</translation>
    </message>
    <message>
        <source>the file may be in RAS, or mirrored</source>
        <translation>potser el fitxer és en RAS o reflectit</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>el fitxer indica els seus eixos: %1</translation>
    </message>
    <message>
        <source>the file with its voxels, %1, cannot be read: %2</source>
        <translation>el fitxer amb els seus vòxels, %1, no es pot llegir: %2</translation>
    </message>
    <message>
        <source>the first one is 0</source>
        <translation>la primera és 0</translation>
    </message>
    <message>
        <source>the first one is: &quot;%1&quot;</source>
        <translation>la primera és: «%1»</translation>
    </message>
    <message>
        <source>the first phase</source>
        <translation>la primera fase</translation>
    </message>
    <message>
        <source>the folder for the frames cannot be written</source>
        <translation>no es pot escriure a la carpeta dels fotogrames</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>els tiradors no envolten res: %1</translation>
    </message>
    <message>
        <source>the handles that may compensate cannot restore the volume</source>
        <translation>els tiradors que poden compensar no poden restablir el volum</translation>
    </message>
    <message>
        <source>the handles' tetrahedra</source>
        <translation>els tetràedres dels tiradors</translation>
    </message>
    <message>
        <source>the label &quot;%1&quot; is not a landmark of the sequence %2</source>
        <translation>l’etiqueta «%1» no és un punt de referència de la seqüència %2</translation>
    </message>
    <message>
        <source>the landmark &quot;%1&quot; comes twice</source>
        <translation>el punt de referència «%1» apareix dues vegades</translation>
    </message>
    <message>
        <source>the landmark lies %1 outside the organ</source>
        <translation>el punt de referència és %1 fora de l’òrgan</translation>
    </message>
    <message>
        <source>the landmark's position is not a finite number</source>
        <translation>la posició del punt de referència no és un nombre finit</translation>
    </message>
    <message>
        <source>the landmarks are not in order along the stomach</source>
        <translation>els punts de referència no estan en ordre al llarg de l’estómac</translation>
    </message>
    <message>
        <source>the last phase equals the first and is left out: phase %1 would be phase 1 again</source>
        <translation>l’última fase és igual a la primera i s’omet: la fase %1 tornaria a ser la fase 1</translation>
    </message>
    <message>
        <source>the locked volumes cannot be kept</source>
        <translation>els volums bloquejats no es poden conservar</translation>
    </message>
    <message>
        <source>the markup %1 of type %2 is not a list of points and was left out</source>
        <translation>la marca %1 de tipus %2 no és una llista de punts i s’omet</translation>
    </message>
    <message>
        <source>the computed centreline leaves the organ</source>
        <translation>la línia central calculada surt de l’òrgan</translation>
    </message>
    <message>
        <source>the motion is the textbook's, fitted to one image: it is not this patient's own</source>
        <translation>el moviment és el del llibre de text, ajustat a una imatge: no és el propi d’aquest pacient</translation>
    </message>
    <message>
        <source>the motion of an organ cannot be made again: nothing is known of how it was made</source>
        <translation>el moviment d’un òrgan no es pot refer: no se sap com es va fer</translation>
    </message>
    <message>
        <source>the movie cannot be written</source>
        <translation>no es pot escriure la pel·lícula</translation>
    </message>
    <message>
        <source>the movie has no frame</source>
        <translation>la pel·lícula no té cap fotograma</translation>
    </message>
    <message>
        <source>the name of a sequence file ends in .sequence.json</source>
        <translation>el nom d’un fitxer de seqüència acaba en .sequence.json</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>el nom d’un fitxer de sessió acaba en .viscera</translation>
    </message>
    <message>
        <source>the names of its labels are those of %1</source>
        <translation>els noms de les seves etiquetes són els de %1</translation>
    </message>
    <message>
        <source>the offset of region &apos;%1&apos; is cut to %2 mm, the distance of its nearest handle from a zone</source>
        <translation>el desplaçament de la regió «%1» es retalla a %2 mm, la distància del seu tirador més proper a una zona</translation>
    </message>
    <message>
        <source>the organ is %1 times as long as that of an adult; check its unit</source>
        <translation>l’òrgan és %1 vegades tan llarg com el d’un adult; comproveu-ne la unitat</translation>
    </message>
    <message>
        <source>the organ is in %1 pieces</source>
        <translation>l’òrgan és en %1 peces</translation>
    </message>
    <message>
        <source>the organ is inside out or flat</source>
        <translation>l’òrgan és girat de dins enfora o pla</translation>
    </message>
    <message numerus="yes">
        <source>the organ is open: %n boundary {edge|edges}</source>
        <translation>
            <numerusform>l’òrgan és obert: %n aresta de vora</numerusform>
            <numerusform>l’òrgan és obert: %n arestes de vora</numerusform>
        </translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>no es pot escriure la imatge</translation>
    </message>
    <message>
        <source>the position is not finite</source>
        <translation>la posició no és finita</translation>
    </message>
    <message>
        <source>the position of the handle %1 in %2 is not finite</source>
        <translation>la posició del tirador %1 a %2 no és finita</translation>
    </message>
    <message>
        <source>the program ffmpeg is needed for this kind of movie and is not installed</source>
        <translation>aquest tipus de pel·lícula necessita el programa ffmpeg, que no està instal·lat</translation>
    </message>
    <message>
        <source>the right ventricle is too small to eject as much as the left one</source>
        <translation>el ventricle dret és massa petit per ejectar tant com l’esquerre</translation>
    </message>
    <message>
        <source>the scan %1 is not there any more (put it beside the session and open that again)</source>
        <translation>l’exploració %1 ja no hi és (poseu-la al costat de la sessió i torneu-la a obrir)</translation>
    </message>
    <message>
        <source>the scan cannot be opened: %1</source>
        <translation>l’exploració no es pot obrir: %1</translation>
    </message>
    <message>
        <source>the size is plausible: %1</source>
        <translation>la mida és plausible: %1</translation>
    </message>
    <message>
        <source>the solid could not be written</source>
        <translation>no s’ha pogut escriure el sòlid</translation>
    </message>
    <message>
        <source>the solid could not be written: %1</source>
        <translation>no s’ha pogut escriure el sòlid: %1</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; has two files of one phase</source>
        <translation>la superfície «%1» té dos fitxers d’una mateixa fase</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; is missing in phase number %2</source>
        <translation>falta la superfície «%1» a la fase número %2</translation>
    </message>
    <message>
        <source>the surface consists of %1 separate pieces</source>
        <translation>la superfície consta de %1 peces separades</translation>
    </message>
    <message>
        <source>the surface does not cross itself</source>
        <translation>la superfície no es travessa ella mateixa</translation>
    </message>
    <message>
        <source>every piece of the surface is smaller than the %1 mm that remeshing resolves</source>
        <translation>totes les peces de la superfície són més petites que els %1 mm que distingeix el remallat</translation>
    </message>
    <message>
        <source>keep the largest piece first</source>
        <translation>conserveu primer la peça més gran</translation>
    </message>
    <message>
        <source>the surface encloses nothing</source>
        <translation>la superfície no tanca res</translation>
    </message>
    <message>
        <source>the surface encloses nothing that witness points could lie in</source>
        <translation>la superfície no tanca res on hi pugui haver punts testimoni</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>la superfície té %1 triangles utilitzables, així que no tanca res</translation>
    </message>
    <message>
        <source>the surface has no triangles or is flat, so it encloses nothing</source>
        <translation>la superfície no té triangles o és plana, així que no tanca res</translation>
    </message>
    <message>
        <source>the surface has no triangles or no size</source>
        <translation>la superfície no té triangles o no té mida</translation>
    </message>
    <message>
        <source>the surface has room for %1 of %2 handles</source>
        <translation>la superfície té lloc per a %1 de %2 tiradors</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres</source>
        <translation>la mida de %1 mm no és plausible per a un òrgan; se suposa que les coordenades són en mil·límetres</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres, they may be in %2</source>
        <translation>la mida de %1 mm no és plausible per a un òrgan; se suposa que les coordenades són en mil·límetres, però poden ser en %2</translation>
    </message>
    <message>
        <source>the surface is closed</source>
        <translation>la superfície és tancada</translation>
    </message>
    <message>
        <source>the surface is inside out</source>
        <translation>la superfície està del revés</translation>
    </message>
    <message>
        <source>the surface is of one piece</source>
        <translation>la superfície és d’una peça</translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges})</source>
        <translation>
            <numerusform>la superfície és oberta (%n aresta de vora)</numerusform>
            <numerusform>la superfície és oberta (%n arestes de vora)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked</source>
        <translation>
            <numerusform>la superfície és oberta (%n aresta de vora), així que no té volum per bloquejar</numerusform>
            <numerusform>la superfície és oberta (%n arestes de vora), així que no té volum per bloquejar</numerusform>
        </translation>
    </message>
    <message>
        <source>the surface is too large for GLB, which ends at 4 GB</source>
        <translation>la superfície és massa gran per a GLB, que acaba a 4 GB</translation>
    </message>
    <message>
        <source>the triangles beside a hole do not all run the same way round, so it cannot be closed</source>
        <translation>els triangles al voltant d’un forat no giren tots en el mateix sentit, així que no es pot tancar</translation>
    </message>
    <message>
        <source>the triangles face outward</source>
        <translation>els triangles miren cap enfora</translation>
    </message>
    <message>
        <source>the volume at the end of the cycle differs from the volume at its start</source>
        <translation>el volum al final del cicle difereix del volum al començament</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>el volum no es pot mantenir aquí: %1</translation>
    </message>
    <message>
        <source>the waves are %1 % as deep as in an adult: %2</source>
        <translation>les ones tenen el %1 % de la profunditat que en un adult: %2</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>n’hi ha %1</translation>
    </message>
    <message>
        <source>there are no tetrahedra in it; the surface may be open</source>
        <translation>no conté tetràedres; potser la superfície és oberta</translation>
    </message>
    <message>
        <source>there is no coordinate system &quot;%1&quot;</source>
        <translation>no hi ha cap sistema de coordenades «%1»</translation>
    </message>
    <message>
        <source>there is no handle at vertex %1</source>
        <translation>no hi ha cap tirador al vèrtex %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existeix aquest fitxer</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>no existeix aquest fitxer ni aquesta carpeta</translation>
    </message>
    <message>
        <source>there is no surface to write</source>
        <translation>no hi ha cap superfície per escriure</translation>
    </message>
    <message>
        <source>there is no triangle to write</source>
        <translation>no hi ha cap triangle per escriure</translation>
    </message>
    <message>
        <source>simplifying the surface</source>
        <translation>simplificació de la superfície</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>és un error del programa; si us plau, comuniqueu-lo</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but neither fundus nor pylorus</source>
        <translation>falten punts de referència: hi ha %1, però ni fundus ni pylorus</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but no %2</source>
        <translation>falten punts de referència: hi ha %1, però no %2</translation>
    </message>
    <message>
        <source>too few landmarks: there is right but neither apex nor base</source>
        <translation>falten punts de referència: hi ha right, però ni apex ni base</translation>
    </message>
    <message>
        <source>track surfaces that are not within each other one by one</source>
        <translation>seguiu d’una en una les superfícies que no són les unes dins de les altres</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>triangle %1</translation>
    </message>
    <message>
        <source>try another resolution</source>
        <translation>proveu una altra resolució</translation>
    </message>
    <message>
        <source>try another resolution, or a cage without needle-like triangles</source>
        <translation>proveu una altra resolució, o una gàbia sense triangles en forma d’agulla</translation>
    </message>
    <message>
        <source>turn its triangles around, as viscera convert IN OUT --orient does</source>
        <translation>gireu-ne els triangles, per exemple amb viscera convert ENTRADA SORTIDA --orient</translation>
    </message>
    <message>
        <source>turn the surface outward, or choose a target above 0 ml</source>
        <translation>orienteu la superfície cap enfora, o trieu un objectiu més gran que 0 ml</translation>
    </message>
    <message>
        <source>turns the surface by a quarter turn, from a model whose y axis points to the head</source>
        <translation>gira la superfície un quart de volta, d’un model amb l’eix y cap al cap</translation>
    </message>
    <message>
        <source>turns the surface by half a turn, as from RAS to LPS</source>
        <translation>gira la superfície mitja volta, com de RAS a LPS</translation>
    </message>
    <message>
        <source>turns triangles around so that all of them face outward</source>
        <translation>gira triangles perquè tots mirin cap enfora</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>dos grups tenen aquest nom</translation>
    </message>
    <message>
        <source>two handles have this label</source>
        <translation>dos tiradors tenen aquest nom</translation>
    </message>
    <message>
        <source>unlock it, or let more handles compensate</source>
        <translation>desbloquegeu-lo, o deixeu compensar més tiradors</translation>
    </message>
    <message>
        <source>unsaved work cannot be kept safe: the folder cannot be written to</source>
        <translation>la feina sense desar no es pot protegir: no es pot escriure a la carpeta</translation>
    </message>
    <message>
        <source>update Viscera</source>
        <translation>actualitzeu Viscera</translation>
    </message>
    <message>
        <source>use .ogv, .mp4, .gif, or a folder for PNG frames</source>
        <translation>feu servir .ogv, .mp4, .gif o una carpeta per a fotogrames PNG</translation>
    </message>
    <message>
        <source>use images that show all of it in every phase</source>
        <translation>feu servir imatges que el mostrin sencer en totes les fases</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>feu servir un de: %1</translation>
    </message>
    <message>
        <source>values from the section %1 on were not understood and ignored</source>
        <translation>els valors a partir de la secció %1 no s’han entès i s’ignoren</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>vèrtex %1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volum</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volum després de menjar</translation>
    </message>
    <message>
        <source>volume of the muscle</source>
        <translation>volum del múscul</translation>
    </message>
    <message>
        <source>volume with its blood</source>
        <translation>volum amb la seva sang</translation>
    </message>
    <message>
        <source>wait a moment</source>
        <translation>espereu un moment</translation>
    </message>
    <message>
        <source>wait until the witness points are computed</source>
        <translation>espereu que s’hagin calculat els punts testimoni</translation>
    </message>
    <message>
        <source>wave fades at the pylorus</source>
        <translation>l’ona s’apaga al pílor</translation>
    </message>
    <message>
        <source>wave in the antrum</source>
        <translation>ona a l’antre</translation>
    </message>
    <message>
        <source>wave in the body</source>
        <translation>ona al cos gàstric</translation>
    </message>
    <message>
        <source>witness points</source>
        <translation>punts testimoni</translation>
    </message>
    <message>
        <source>Pin stress probe</source>
        <translation>Fixa una sonda de tensió</translation>
    </message>
    <message>
        <source>Draw stress profile</source>
        <translation>Dibuixa un perfil de tensió</translation>
    </message>
    <message>
        <source>Remove stress profile</source>
        <translation>Elimina un perfil de tensió</translation>
    </message>
    <message>
        <source>Remove all stress probes</source>
        <translation>Elimina totes les sondes de tensió</translation>
    </message>
    <message numerus="yes">
        <source>Remove {stress probe|%n stress probes}</source>
        <translation>
            <numerusform>Elimina una sonda de tensió</numerusform>
            <numerusform>Elimina %n sondes de tensió</numerusform>
        </translation>
    </message>
    <message>
        <source>stress probe %1</source>
        <translation>sonda de tensió %1</translation>
    </message>
    <message>
        <source>stress profile %1</source>
        <translation>perfil de tensió %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>sonda de tensió</translation>
    </message>
    <message>
        <source>stress profile</source>
        <translation>perfil de tensió</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Un perfil necessita dues sondes d’un òrgan</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Aquestes dues sondes ja tenen un perfil</translation>
    </message>
    <message>
        <source>witness points on a grid</source>
        <translation>punts testimoni en una quadrícula</translation>
    </message>
    <message>
        <source>women and men have on average %1 to %2 ml</source>
        <translation>dones i homes tenen de mitjana de %1 a %2 ml</translation>
    </message>
    <message>
        <source>write an .ogv instead</source>
        <translation>escriviu un .ogv en lloc seu</translation>
    </message>
    <message>
        <source>write lines of the instant and the volume in ml</source>
        <translation>escriviu línies amb l’instant i el volum en ml</translation>
    </message>
    <message>
        <source>write the instant and the volume in ml, as in 0.25,98.5</source>
        <translation>escriviu l’instant i el volum en ml, com a 0.25,98.5</translation>
    </message>
    <message>
        <source>write volumes in ml</source>
        <translation>escriviu els volums en ml</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>escriptura de la pel·lícula</translation>
    </message>
    <message>
        <source>the organ has no extent</source>
        <translation>l’òrgan no té extensió</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right</source>
        <translation>cor amb %1 ml a l’esquerra i %2 ml a la dreta</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right, atria with %3 ml left and %4 ml right</source>
        <translation>cor amb %1 ml a l’esquerra i %2 ml a la dreta, aurícules amb %3 ml a l’esquerra i %4 ml a la dreta</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml; atria: left off by %3 ml, right by %4 ml</source>
        <translation>Els ventricles no poden assolir els seus volums: a l’esquerre li falten %1 ml, al dret %2 ml; aurícules: a l’esquerra %3 ml, a la dreta %4 ml</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml</source>
        <translation>Els ventricles no poden assolir els seus volums: a l’esquerre li falten %1 ml, al dret %2 ml</translation>
    </message>
    <message>
        <source>check that the cavities lie inside the handles of their walls</source>
        <translation>comproveu que les cavitats són dins dels tiradors de les seves parets</translation>
    </message>
    <message>
        <source>a centreline needs at least two points</source>
        <translation>una línia central necessita almenys dos punts</translation>
    </message>
    <message>
        <source>centreline point %1</source>
        <translation>punt %1 de la línia central</translation>
    </message>
    <message>
        <source>the point is not finite</source>
        <translation>el punt no és finit</translation>
    </message>
    <message>
        <source>the point is where the one before it is</source>
        <translation>el punt és on és l’anterior</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>elimineu-lo</translation>
    </message>
    <message>
        <source>calibrating the heartbeat</source>
        <translation>calibratge del batec</translation>
    </message>
    <message>
        <source>curve key %1</source>
        <translation>clau %1 de la corba</translation>
    </message>
    <message>
        <source>the pylorus does not lie beyond the middle of the body</source>
        <translation>el pílor no és més enllà de la meitat del cos</translation>
    </message>
    <message>
        <source>gastric waves</source>
        <translation>ones gàstriques</translation>
    </message>
    <message>
        <source>choose the landmarks from the fundus downwards</source>
        <translation>trieu els punts de referència del fundus cap avall</translation>
    </message>
    <message>
        <source>the surface has no inside</source>
        <translation>la superfície no té interior</translation>
    </message>
    <message>
        <source>heart landmarks</source>
        <translation>punts de referència del cor</translation>
    </message>
    <message>
        <source>give apex and base yourself</source>
        <translation>indiqueu vosaltres l’àpex i la base</translation>
    </message>
    <message>
        <source>the base does not lie inside the heart</source>
        <translation>la base no és dins del cor</translation>
    </message>
    <message>
        <source>put it on the middle of the mitral valve</source>
        <translation>poseu-la al centre de la vàlvula mitral</translation>
    </message>
    <message>
        <source>the directions to the right ventricle and to the apex do not span a frame</source>
        <translation>les direccions al ventricle dret i a l’àpex no formen un sistema d’eixos</translation>
    </message>
    <message>
        <source>heart frame</source>
        <translation>eixos del cor</translation>
    </message>
    <message>
        <source>choose landmarks that do not lie on one line</source>
        <translation>trieu punts de referència que no siguin en una recta</translation>
    </message>
    <message numerus="yes">
        <source>a ventricle is not where its frame says: only %n {handle meets|handles meet} its wall</source>
        <translation>
            <numerusform>un ventricle no és on indiquen els seus eixos: només %n tirador en toca la paret</numerusform>
            <numerusform>un ventricle no és on indiquen els seus eixos: només %n tiradors en toquen la paret</numerusform>
        </translation>
    </message>
    <message>
        <source>heart rig</source>
        <translation>tiradors del cor</translation>
    </message>
    <message>
        <source>check the landmarks of base, apex and right ventricle</source>
        <translation>comproveu els punts de referència de la base, l’àpex i el ventricle dret</translation>
    </message>
    <message>
        <source>move it, or lengthen the period</source>
        <translation>moveu-la o allargueu el període</translation>
    </message>
    <message>
        <source>there is no key</source>
        <translation>no hi ha cap clau</translation>
    </message>
    <message>
        <source>the heart cannot be brought to the volume that it has to hold</source>
        <translation>el cor no pot assolir el volum que ha de tenir</translation>
    </message>
    <message>
        <source>heartbeat at %1 s</source>
        <translation>batec a %1 s</translation>
    </message>
    <message>
        <source>check the landmarks of apex and base</source>
        <translation>comproveu els punts de referència de l’àpex i la base</translation>
    </message>
    <message>
        <source>the upper stomach cannot take in what the waves press out</source>
        <translation>l’estómac superior no pot acollir el que les ones desplacen</translation>
    </message>
    <message>
        <source>peristalsis after %1 s</source>
        <translation>peristalsi després de %1 s</translation>
    </message>
    <message>
        <source>check the landmarks</source>
        <translation>comproveu els punts de referència</translation>
    </message>
    <message>
        <source>the centreline leaves the stomach %1 mm below the top of the fundus</source>
        <translation>la línia central surt de l’estómac %1 mm per sota del cim del fundus</translation>
    </message>
    <message>
        <source>stomach rig</source>
        <translation>tiradors de l’estómac</translation>
    </message>
    <message>
        <source>move its points into the stomach</source>
        <translation>moveu els seus punts dins de l’estómac</translation>
    </message>
    <message>
        <source>the centreline ends before the pylorus</source>
        <translation>la línia central acaba abans del pílor</translation>
    </message>
    <message>
        <source>lead it into the duodenum</source>
        <translation>allargueu-la fins al duodè</translation>
    </message>
    <message numerus="yes">
        <source>Only %n {vertex|vertices} of the surface {lies|lie} there</source>
        <translation>
            <numerusform>Només hi ha %n vèrtex de la superfície</numerusform>
            <numerusform>Només hi ha %n vèrtexs de la superfície</numerusform>
        </translation>
    </message>
    <message>
        <source>take a finer surface</source>
        <translation>feu servir una superfície més fina</translation>
    </message>
    <message>
        <source>base of the left ventricle</source>
        <translation>base del ventricle esquerre</translation>
    </message>
    <message>
        <source>apex of the left ventricle</source>
        <translation>àpex del ventricle esquerre</translation>
    </message>
    <message>
        <source>base of the right ventricle</source>
        <translation>base del ventricle dret</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, inside</source>
        <translation>paret lliure del ventricle esquerre, per dins</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, outside</source>
        <translation>paret lliure del ventricle esquerre, per fora</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus towards the apex</source>
        <translation>excursió de l’anell mitral cap a l’àpex</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus at the free wall</source>
        <translation>excursió de l’anell tricúspide a la paret lliure</translation>
    </message>
    <message>
        <source>turn of the apex against the base</source>
        <translation>gir de l’àpex respecte a la base</translation>
    </message>
    <message>
        <source>of the left ventricle's free wall in systole</source>
        <translation>de la paret lliure del ventricle esquerre a la sístole</translation>
    </message>
    <message>
        <source>effective areas of normal valves: doi 10.1016/j.echo.2017.02.009</source>
        <translation>àrees efectives de vàlvules normals: doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.1 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>una regurgitació lleu està per sota de 0,1 cm²: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.2 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>una regurgitació lleu està per sota de 0,2 cm²: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>20 % around the healthy adult at rest</source>
        <translation>20 % al voltant de l’adult sa en repòs</translation>
    </message>
    <message>
        <source>sinus rhythm at rest</source>
        <translation>ritme sinusal en repòs</translation>
    </message>
    <message>
        <source>800 to 1600 dyn s cm^-5, customary at the bedside</source>
        <translation>800 a 1600 dyn s cm^-5, habitual a la clínica</translation>
    </message>
    <message>
        <source>up to 2 Wood units</source>
        <translation>fins a 2 unitats Wood</translation>
    </message>
    <message>
        <source>the amount in a healthy heart</source>
        <translation>la quantitat en un cor sa</translation>
    </message>
    <message>
        <source>%1 is out of its range</source>
        <translation>%1 és fora del seu interval</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>from %1 to %2 %3</source>
        <translation>de %1 a %2 %3</translation>
    </message>
    <message>
        <source>the leak area must be smaller than the area of the open valve</source>
        <translation>l’àrea de la fuita ha de ser més petita que la de la vàlvula oberta</translation>
    </message>
    <message>
        <source>choose a %1 below its %2</source>
        <translation>trieu %1 més petit que %2</translation>
    </message>
    <message>
        <source>%1 lies between %2 and %3</source>
        <translation>%1 és entre %2 i %3</translation>
    </message>
    <message>
        <source>An end-diastolic volume in ml</source>
        <translation>Un volum telediastòlic en ml</translation>
    </message>
    <message>
        <source>give the largest volume of the left ventricle</source>
        <translation>indiqueu el volum més gran del ventricle esquerre</translation>
    </message>
    <message>
        <source>An ejection fraction</source>
        <translation>Una fracció d’ejecció</translation>
    </message>
    <message>
        <source>give 55 % as 0.55</source>
        <translation>indiqueu 55 % com a 0,55</translation>
    </message>
    <message>
        <source>A mean aortic pressure in mmHg</source>
        <translation>Una pressió aòrtica mitjana en mmHg</translation>
    </message>
    <message>
        <source>about a third of the way from the diastolic to the systolic one</source>
        <translation>al voltant d’un terç del camí de la diastòlica a la sistòlica</translation>
    </message>
    <message>
        <source>fitting the circulation</source>
        <translation>ajust de la circulació</translation>
    </message>
    <message>
        <source>the circulation of that heart</source>
        <translation>la circulació d’aquest cor</translation>
    </message>
    <message>
        <source>The circulation has the measured ventricle: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>La circulació té el ventricle mesurat: %1 ml, fracció d’ejecció %2, pressió aòrtica mitjana %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>Cap circulació té exactament aquest ventricle; la més propera: %1 ml, fracció d’ejecció %2, pressió aòrtica mitjana %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg; at the limit of its range: %4</source>
        <translation>Cap circulació té exactament aquest ventricle; la més propera: %1 ml, fracció d’ejecció %2, pressió aòrtica mitjana %3 mmHg; al límit del seu interval: %4</translation>
    </message>
    <message>
        <source>the circulation to start with</source>
        <translation>la circulació de partida</translation>
    </message>
    <message numerus="yes">
        <source>After %n {beat|beats} the volumes still change by %2 ml from beat to beat: strong and weak beats alternate, or the circulation fails; try a lower rate or a larger stressed volume</source>
        <translation>
            <numerusform>Després de %n batec els volums encara canvien %2 ml de batec a batec: s’alternen batecs forts i febles, o la circulació falla; proveu una freqüència més baixa o un volum estressat més gran</numerusform>
            <numerusform>Després de %n batecs els volums encara canvien %2 ml de batec a batec: s’alternen batecs forts i febles, o la circulació falla; proveu una freqüència més baixa o un volum estressat més gran</numerusform>
        </translation>
    </message>
    <message>
        <source>the circulation breaks down: its pressures grow without bounds</source>
        <translation>la circulació s’ensorra: les seves pressions creixen sense límit</translation>
    </message>
    <message>
        <source>beat %1</source>
        <translation>batec %1</translation>
    </message>
    <message>
        <source>bring the parameters nearer to those at rest, a few at a time</source>
        <translation>acosteu els paràmetres als de repòs, uns quants cada vegada</translation>
    </message>
    <message>
        <source>fitting phase %1</source>
        <translation>ajust de la fase %1</translation>
    </message>
    <message>
        <source>smoothing phase %1</source>
        <translation>suavitzat de la fase %1</translation>
    </message>
    <message>
        <source>%1 is %2 mm away on average</source>
        <translation>%1 és a %2 mm de mitjana</translation>
    </message>
    <message>
        <source>a twentieth of %1 is more than %2 mm away</source>
        <translation>una vintena part de %1 és a més de %2 mm</translation>
    </message>
    <message>
        <source>%1 had to be changed by %2 % to get its volume</source>
        <translation>%1 s’ha hagut de canviar un %2 % per tenir el seu volum</translation>
    </message>
    <message>
        <source>%1 agrees with its voxels by a Dice of %2 only</source>
        <translation>%1 coincideix amb els seus vòxels només amb un Dice de %2</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} of %2 {is|are} turned over</source>
        <translation>
            <numerusform>%n triangle de %2 està girat</numerusform>
            <numerusform>%n triangles de %2 estan girats</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the tissue is folded at %n {place|places}</source>
        <translation>
            <numerusform>el teixit està plegat en %n lloc</numerusform>
            <numerusform>el teixit està plegat en %n llocs</numerusform>
        </translation>
    </message>
    <message>
        <source>the measured volumes cannot be met</source>
        <translation>els volums mesurats no es poden assolir</translation>
    </message>
    <message numerus="yes">
        <source>%2 handles are too few for %n {surface|surfaces}</source>
        <translation>
            <numerusform>%2 tiradors són pocs per a %n superfície</numerusform>
            <numerusform>%2 tiradors són pocs per a %n superfícies</numerusform>
        </translation>
    </message>
    <message>
        <source>ask for fewer</source>
        <translation>demaneu-ne menys</translation>
    </message>
    <message>
        <source>keeping volumes</source>
        <translation>conservació dels volums</translation>
    </message>
    <message>
        <source>Phase %1 has %2 points and the first has %3</source>
        <translation>La fase %1 té %2 punts i la primera en té %3</translation>
    </message>
    <message>
        <source>export all phases with the same triangles</source>
        <translation>exporteu totes les fases amb els mateixos triangles</translation>
    </message>
    <message>
        <source>%1, phase %2</source>
        <translation>%1, fase %2</translation>
    </message>
    <message>
        <source>It has no triangle with three different corners</source>
        <translation>No té cap triangle amb tres vèrtexs diferents</translation>
    </message>
    <message>
        <source>It is not a closed surface, even with its holes filled: %1</source>
        <translation>No és una superfície tancada, ni amb els forats tapats: %1</translation>
    </message>
    <message>
        <source>repair the surfaces in the program that made them</source>
        <translation>repareu les superfícies al programa que les va fer</translation>
    </message>
    <message>
        <source>the volume cannot be kept throughout the cycle: %1</source>
        <translation>el volum no es pot conservar durant tot el cicle: %1</translation>
    </message>
    <message>
        <source>unlock it, or prescribe a volume nearer to that at rest</source>
        <translation>desbloquegeu-lo o prescriviu un volum més proper al de repòs</translation>
    </message>
    <message>
        <source>No organ is shown</source>
        <translation>No es mostra cap òrgan</translation>
    </message>
    <message>
        <source>the lesson</source>
        <translation>la lliçó</translation>
    </message>
    <message>
        <source>show those that the lesson is about</source>
        <translation>mostreu aquells de què tracta la lliçó</translation>
    </message>
    <message>
        <source>check the size of the organ, and its motion</source>
        <translation>comproveu la mida de l’òrgan i el seu moviment</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; returned no binding of the right size</source>
        <translation>el sistema «%1» no ha tornat cap vinculació de la mida correcta</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed: %2</source>
        <translation>el sistema «%1» ha fallat: %2</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed</source>
        <translation>el sistema «%1» ha fallat</translation>
    </message>
    <message>
        <source>choose another system</source>
        <translation>trieu un altre sistema</translation>
    </message>
    <message>
        <source>it was made for version %1 of the plugin interface, this program has %2</source>
        <translation>es va fer per a la versió %1 de la interfície de connectors, aquest programa té la %2</translation>
    </message>
    <message>
        <source>plugin %1: %2</source>
        <translation>connector %1: %2</translation>
    </message>
    <message>
        <source>There is already a coordinate system &quot;%1&quot; (%2)</source>
        <translation>Ja hi ha un sistema de coordenades «%1» (%2)</translation>
    </message>
    <message>
        <source>remove one of the two, or give one another id</source>
        <translation>elimineu-ne un dels dos o doneu a un un altre identificador</translation>
    </message>
    <message>
        <source>There is no coordinate system &quot;%1&quot;</source>
        <translation>No existeix el sistema de coordenades «%1»</translation>
    </message>
    <message>
        <source>none is loaded</source>
        <translation>no n’hi ha cap de carregat</translation>
    </message>
    <message>
        <source>none: the organs are as in their files</source>
        <translation>cap: els òrgans són com als seus fitxers</translation>
    </message>
    <message>
        <source>in %1 groups</source>
        <translation>en %1 grups</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en repòs</translation>
    </message>
    <message>
        <source>%1 of them moved</source>
        <translation>%1 d’ells moguts</translation>
    </message>
    <message>
        <source>%1 of them shown</source>
        <translation>%1 d’ells visibles</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fitxer</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Òrgans</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Tiradors</translation>
    </message>
    <message>
        <source>Instant</source>
        <translation>Instant</translation>
    </message>
    <message>
        <source>%1, at %2 of its cycle</source>
        <translation>%1, al %2 del seu cicle</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(amagat)</translation>
    </message>
    <message>
        <source>open</source>
        <translation>obert</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloquejat</translation>
    </message>
    <message>
        <source>Rest shape (ml)</source>
        <translation>Forma en repòs (ml)</translation>
    </message>
    <message>
        <source>Now (ml)</source>
        <translation>Ara (ml)</translation>
    </message>
    <message>
        <source>Change (ml)</source>
        <translation>Canvi (ml)</translation>
    </message>
    <message>
        <source>Change (%)</source>
        <translation>Canvi (%)</translation>
    </message>
    <message>
        <source>Surface (cm²)</source>
        <translation>Superfície (cm²)</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volums</translation>
    </message>
    <message>
        <source>Open: the surface has holes and holds no volume.</source>
        <translation>Obert: la superfície té forats i no tanca cap volum.</translation>
    </message>
    <message>
        <source>mean in a rectangle</source>
        <translation>mitjana en un rectangle</translation>
    </message>
    <message>
        <source>mean in a sphere</source>
        <translation>mitjana en una esfera</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipus</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Mesurat a</translation>
    </message>
    <message>
        <source>Rest shape</source>
        <translation>Forma en repòs</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ara</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Canvi</translation>
    </message>
    <message>
        <source>the scan</source>
        <translation>l’exploració</translation>
    </message>
    <message>
        <source>sample organ &quot;%1&quot;, %2 resolution</source>
        <translation>òrgan de mostra «%1», resolució %2</translation>
    </message>
    <message>
        <source>low</source>
        <translation>baixa</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mitjana</translation>
    </message>
    <message>
        <source>high</source>
        <translation>alta</translation>
    </message>
    <message>
        <source>made in the program</source>
        <translation>fet al programa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>cap</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Findings and repairs</source>
        <translation>Troballes i reparacions</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vèrtexs</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Files and what was done to them</source>
        <translation>Fitxers i què se n’ha fet</translation>
    </message>
    <message>
        <source>All lengths are in millimetres, all volumes in millilitres; positions are in the patient's axes LPS (to the left, to the back, to the head). Viscera is a program for teaching and research, not a medical device.</source>
        <translation>Totes les longituds són en mil·límetres, tots els volums en mil·lilitres; les posicions són en els eixos LPS del pacient (a l’esquerra, enrere, cap al cap). Viscera és un programa per a la docència i la recerca, no un producte sanitari.</translation>
    </message>
    <message>
        <source>There is no organ to report on</source>
        <translation>No hi ha cap òrgan sobre el qual informar</translation>
    </message>
    <message>
        <source>Made by Viscera %1 on %2</source>
        <translation>Fet per Viscera %1 el %2</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dibuix</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>mesura</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fet</translation>
    </message>
    <message>
        <source>going through the cycle</source>
        <translation>recorregut del cicle</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volum (ml)</translation>
    </message>
    <message>
        <source>Volumes over one cycle, each instant computed</source>
        <translation>Volums durant un cicle, cada instant calculat</translation>
    </message>
    <message>
        <source>the first %1 of %2 organs</source>
        <translation>els primers %1 de %2 òrgans</translation>
    </message>
    <message>
        <source>Smallest (ml)</source>
        <translation>Mínim (ml)</translation>
    </message>
    <message>
        <source>Largest (ml)</source>
        <translation>Màxim (ml)</translation>
    </message>
    <message>
        <source>Ventricle</source>
        <translation>Ventricle</translation>
    </message>
    <message>
        <source>EDV (ml)</source>
        <translation>VTD (ml)</translation>
    </message>
    <message>
        <source>ESV (ml)</source>
        <translation>VTS (ml)</translation>
    </message>
    <message>
        <source>Stroke volume (ml)</source>
        <translation>Volum sistòlic (ml)</translation>
    </message>
    <message>
        <source>EF (%)</source>
        <translation>FE (%)</translation>
    </message>
    <message>
        <source>EF of healthy people</source>
        <translation>FE de persones sanes</translation>
    </message>
    <message>
        <source>Output (l/min)</source>
        <translation>Cabal (l/min)</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Moviment</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Seqüència</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Freqüència</translation>
    </message>
    <message>
        <source>%1 a minute, one cycle takes %2 s</source>
        <translation>%1 per minut, un cicle dura %2 s</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Fases</translation>
    </message>
    <message>
        <source>Prescribed</source>
        <translation>Prescrit</translation>
    </message>
    <message>
        <source>the volume of %1</source>
        <translation>el volum de %1</translation>
    </message>
    <message>
        <source>A volume could not be kept: %1</source>
        <translation>No s’ha pogut conservar un volum: %1</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De cara</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Des de l’esquerra</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Des de dalt</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Des de darrere</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Des de la dreta</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Des de sota</translation>
    </message>
    <message>
        <source>The map as the session shows it</source>
        <translation>El mapa tal com el mostra la sessió</translation>
    </message>
    <message>
        <source>There is no font to write with</source>
        <translation>No hi ha cap tipus de lletra per escriure</translation>
    </message>
    <message>
        <source>install one, such as the package fonts-dejavu-core</source>
        <translation>instal·leu-ne un, com el paquet fonts-dejavu-core</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Pàgina %1 de %2</translation>
    </message>
    <message>
        <source>A report cannot be written to this kind of file</source>
        <translation>No es pot escriure un informe en aquest tipus de fitxer</translation>
    </message>
    <message>
        <source>let it end in .pdf or .html</source>
        <translation>feu que acabi en .pdf o .html</translation>
    </message>
    <message>
        <source>by TetGen</source>
        <translation>per TetGen</translation>
    </message>
    <message>
        <source>by TetGen, from a repaired copy of the surface</source>
        <translation>per TetGen, d’una còpia reparada de la superfície</translation>
    </message>
    <message>
        <source>by a regular grid</source>
        <translation>per una quadrícula regular</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínim</translation>
    </message>
    <message>
        <source>5th percentile</source>
        <translation>Percentil 5</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>Percentil 95</translation>
    </message>
    <message>
        <source>%1, extreme over a cycle</source>
        <translation>%1, valor extrem d’un cicle</translation>
    </message>
    <message>
        <source>Points (%)</source>
        <translation>Punts (%)</translation>
    </message>
    <message>
        <source>%1 over the witness points</source>
        <translation>%1 als punts testimoni</translation>
    </message>
    <message>
        <source>Rotational stress (deg)</source>
        <translation>Tensió rotacional (graus)</translation>
    </message>
    <message>
        <source>Over one cycle of the sequence</source>
        <translation>Durant un cicle de la seqüència</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>Place (mm)</source>
        <translation>Lloc (mm)</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>sense teixit</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>plegat</translation>
    </message>
    <message>
        <source>Distance at rest (mm)</source>
        <translation>Distància en repòs (mm)</translation>
    </message>
    <message>
        <source>Along the straight lines at rest between probes</source>
        <translation>Al llarg de les rectes en repòs entre sondes</translation>
    </message>
    <message>
        <source>Tissue distortion (rotational stress)</source>
        <translation>Distorsió del teixit (tensió rotacional)</translation>
    </message>
    <message>
        <source>Witness points</source>
        <translation>Punts testimoni</translation>
    </message>
    <message>
        <source>%1 in %2 tetrahedra</source>
        <translation>%1 en %2 tetràedres</translation>
    </message>
    <message>
        <source>Derivatives</source>
        <translation>Derivades</translation>
    </message>
    <message>
        <source>in closed form (analytic)</source>
        <translation>en forma tancada (analítica)</translation>
    </message>
    <message>
        <source>by central differences</source>
        <translation>per diferències centrals</translation>
    </message>
    <message>
        <source>no point: the tissue is turned inside out nowhere</source>
        <translation>cap punt: el teixit no està invertit enlloc</translation>
    </message>
    <message>
        <source>%1 of %2 points are turned inside out</source>
        <translation>%1 de %2 punts estan invertits</translation>
    </message>
    <message>
        <source>Rotational stress is the largest angle by which a direction is turned when the tissue is stretched. It measures distortion and is not a pressure.</source>
        <translation>La tensió rotacional és l’angle més gran que gira una direcció quan el teixit s’estira. Mesura la distorsió i no és una pressió.</translation>
    </message>
    <message>
        <source>± %1, %2 to %3, %4, %5 voxels</source>
        <translation>± %1; de %2 a %3; %4; %5 vòxels</translation>
    </message>
    <message>
        <source>The view cannot be restored completely</source>
        <translation>La vista no es pot restaurar del tot</translation>
    </message>
    <message>
        <source>the session's view</source>
        <translation>la vista de la sessió</translation>
    </message>
    <message>
        <source>the organs and the handles are complete; save the session anew</source>
        <translation>els òrgans i els tiradors són complets; deseu de nou la sessió</translation>
    </message>
    <message>
        <source>women</source>
        <translation>dones</translation>
    </message>
    <message>
        <source>men</source>
        <translation>homes</translation>
    </message>
    <message>
        <source>women and men</source>
        <translation>dones i homes</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations</source>
        <translation>%1, mitjana ± 2 desviacions típiques</translation>
    </message>
    <message>
        <source>%1, on average</source>
        <translation>%1, de mitjana</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations, for %2 m2 of body surface</source>
        <translation>%1, mitjana ± 2 desviacions típiques, per a %2 m² de superfície corporal</translation>
    </message>
    <message>
        <source>%1, on average, for %2 m2 of body surface</source>
        <translation>%1, de mitjana, per a %2 m² de superfície corporal</translation>
    </message>
    <message>
        <source>800 healthy people of 45 to 74 years, by magnetic resonance, papillary muscles counted as cavity</source>
        <translation>800 persones sanes de 45 a 74 anys, per ressonància magnètica, músculs papil·lars comptats com a cavitat</translation>
    </message>
    <message>
        <source>ICRP publication 89, doi 10.1016/S0146-6453(03)00002-2</source>
        <translation>ICRP, publicació 89, doi 10.1016/S0146-6453(03)00002-2</translation>
    </message>
    <message>
        <source>1815 people without kidney disease, by magnetic resonance; the deviation is that of the quartiles</source>
        <translation>1815 persones sense malaltia renal, per ressonància magnètica; la desviació és la dels quartils</translation>
    </message>
    <message>
        <source>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (spread), and &quot;Simplifying the measurement of gastric accommodation using SPECT&quot; (mean)</source>
        <translation>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (dispersió), i «Simplifying the measurement of gastric accommodation using SPECT» (mitjana)</translation>
    </message>
    <message>
        <source>customary at the bedside</source>
        <translation>habitual a la clínica</translation>
    </message>
    <message>
        <source>Whelton 2018, doi 10.1161/HYP.0000000000000065: normal is below 120/80; the lower bound is customary</source>
        <translation>Whelton 2018, doi 10.1161/HYP.0000000000000065: el normal és per sota de 120/80; el límit inferior és l’habitual</translation>
    </message>
    <message>
        <source>mass of the muscle</source>
        <translation>massa del múscul</translation>
    </message>
    <message>
        <source>1969 healthy people at rest, by tissue Doppler</source>
        <translation>1969 persones sanes en repòs, per Doppler tissular</translation>
    </message>
    <message>
        <source>ejection time</source>
        <translation>temps d’ejecció</translation>
    </message>
    <message>
        <source>healthy adults, by magnetic resonance and ultrasound</source>
        <translation>adults sans, per ressonància magnètica i ecografia</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus (MAPSE)</source>
        <translation>excursió de l’anell mitral (MAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 16.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); ultrasound finds less, 12 to 15 mm</source>
        <translation>ressonància magnètica: 16,4 mm (Carlsson i altres 2007, doi 10.1152/ajpheart.01376.2006); l’ecografia dona menys, de 12 a 15 mm</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus (TAPSE)</source>
        <translation>excursió de l’anell tricúspide (TAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 23.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); below 17 mm is abnormal in ultrasound (Lang and others 2015, doi 10.1016/j.echo.2014.10.003)</source>
        <translation>ressonància magnètica: 23,4 mm (Carlsson i altres 2007, doi 10.1152/ajpheart.01376.2006); en ecografia, menys de 17 mm és anormal (Lang i altres 2015, doi 10.1016/j.echo.2014.10.003)</translation>
    </message>
    <message>
        <source>twist of the apex against the base</source>
        <translation>torsió de l’àpex respecte a la base</translation>
    </message>
    <message>
        <source>magnetic resonance: apex about 10, base about 3 degrees the other way (Young and Cowan 2012, doi 10.1186/1532-429X-14-49)</source>
        <translation>ressonància magnètica: àpex uns 10 graus, base uns 3 en sentit contrari (Young i Cowan 2012, doi 10.1186/1532-429X-14-49)</translation>
    </message>
    <message>
        <source>thickening of the free wall</source>
        <translation>engruiximent de la paret lliure</translation>
    </message>
    <message>
        <source>magnetic resonance: 4.4 +- 1.4 mm in the middle slices (Ubachs and others 2009, doi 10.1186/1532-429X-11-S1-P61)</source>
        <translation>ressonància magnètica: 4,4 ± 1,4 mm als talls mitjans (Ubachs i altres 2009, doi 10.1186/1532-429X-11-S1-P61)</translation>
    </message>
    <message>
        <source>healthy adults at rest</source>
        <translation>adults sans en repòs</translation>
    </message>
    <message>
        <source>systolic pressure</source>
        <translation>pressió sistòlica</translation>
    </message>
    <message>
        <source>diastolic pressure</source>
        <translation>pressió diastòlica</translation>
    </message>
    <message>
        <source>mean pressure</source>
        <translation>pressió mitjana</translation>
    </message>
    <message>
        <source>end-diastolic pressure</source>
        <translation>pressió telediastòlica</translation>
    </message>
    <message>
        <source>fastest rise of pressure</source>
        <translation>ascens més ràpid de la pressió</translation>
    </message>
    <message>
        <source>coupling Ea/Ees</source>
        <translation>acoblament Ea/Ees</translation>
    </message>
    <message>
        <source>mean gradient</source>
        <translation>gradient mitjà</translation>
    </message>
    <message>
        <source>regurgitant fraction</source>
        <translation>fracció de regurgitació</translation>
    </message>
    <message>
        <source>Kovacs 2009, doi 10.1183/09031936.00145608: mean +- 2 standard deviations</source>
        <translation>Kovacs 2009, doi 10.1183/09031936.00145608: mitjana ± 2 desviacions típiques</translation>
    </message>
    <message>
        <source>between the most efficient (0.5) and the most powerful coupling (1): Burkhoff and Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</source>
        <translation>entre l’acoblament més eficient (0,5) i el més potent (1): Burkhoff i Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</translation>
    </message>
    <message>
        <source>reference woman and man; no spread is given</source>
        <translation>dona i home de referència; no s’indica la dispersió</translation>
    </message>
    <message>
        <source>1248 people without liver disease, by magnetic resonance</source>
        <translation>1248 persones sense malaltia hepàtica, per ressonància magnètica</translation>
    </message>
    <message>
        <source>212 adults, by CT</source>
        <translation>212 adults, per TC</translation>
    </message>
    <message>
        <source>adults of 20 to 60 years, by CT</source>
        <translation>adults de 20 a 60 anys, per TC</translation>
    </message>
    <message>
        <source>contents after a meal</source>
        <translation>contingut després de menjar</translation>
    </message>
    <message>
        <source>443 people after a meal, by single-photon tomography</source>
        <translation>443 persones després de menjar, per tomografia de fotó únic</translation>
    </message>
    <message>
        <source>contents of 443 people after a meal, by single-photon tomography, and 138 ml of wall (ICRP publication 89)</source>
        <translation>contingut de 443 persones després de menjar, per tomografia de fotó únic, i 138 ml de paret (publicació 89 de la ICRP)</translation>
    </message>
    <message>
        <source>adults, by electrogastrography</source>
        <translation>adults, per electrogastrografia</translation>
    </message>
    <message>
        <source>Yin and Chen 2013, doi 10.5056/jnm.2013.19.1.5</source>
        <translation>Yin i Chen 2013, doi 10.5056/jnm.2013.19.1.5</translation>
    </message>
    <message>
        <source>speed of the waves</source>
        <translation>velocitat de les ones</translation>
    </message>
    <message>
        <source>occlusion of the antrum by a wave</source>
        <translation>oclusió de l’antre per una ona</translation>
    </message>
    <message>
        <source>28 healthy people, by magnetic resonance</source>
        <translation>28 persones sanes, per ressonància magnètica</translation>
    </message>
    <message>
        <source>adults at rest</source>
        <translation>adults en repòs</translation>
    </message>
    <message>
        <source>part that is inspiration</source>
        <translation>part que és inspiració</translation>
    </message>
    <message>
        <source>adults at rest, from 1 : 2 to 1 : 1</source>
        <translation>adults en repòs, d’1 : 2 a 1 : 1</translation>
    </message>
    <message>
        <source>way down in quiet breathing</source>
        <translation>descens en la respiració tranquil·la</translation>
    </message>
    <message>
        <source>what several studies measured</source>
        <translation>el que van mesurar diversos estudis</translation>
    </message>
    <message>
        <source>there are no handles to save</source>
        <translation>no hi ha tiradors per desar</translation>
    </message>
    <message>
        <source>There is no scan to export</source>
        <translation>No hi ha cap exploració per exportar</translation>
    </message>
    <message>
        <source>There are no handles that could warp the scan</source>
        <translation>No hi ha tiradors que puguin deformar l’exploració</translation>
    </message>
    <message>
        <source>Writing the scan</source>
        <translation>S’escriu l’exploració</translation>
    </message>
    <message>
        <source>9 healthy people, by magnetic resonance; 28 people of doi 10.1046/j.1365-2982.2001.00285.x have 1.6 +- 0.2</source>
        <translation>9 persones sanes, per ressonància magnètica; 28 persones de doi 10.1046/j.1365-2982.2001.00285.x tenen 1,6 ± 0,2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>des de %1</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>fins a %1</translation>
    </message>
    <message>
        <source>the sample organs cannot be listed: %1</source>
        <translation>no es poden enumerar els òrgans de mostra: %1</translation>
    </message>
    <message>
        <source>set VISCERA_SAMPLE_ORGANS to the folder of the definitions</source>
        <translation>poseu a VISCERA_SAMPLE_ORGANS la carpeta de les definicions</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>No es pot llegir el fitxer: %1</translation>
    </message>
    <message>
        <source>its segment %1 has no valid value or layer</source>
        <translation>el seu segment %1 no té un valor o una capa vàlids</translation>
    </message>
    <message>
        <source>the table of names in it cannot be read</source>
        <translation>no es pot llegir la taula de noms que conté</translation>
    </message>
    <message>
        <source>its voxels are no plain numbers (%1)</source>
        <translation>els seus vòxels no són nombres simples (%1)</translation>
    </message>
    <message>
        <source>It is not a surface</source>
        <translation>No és una superfície</translation>
    </message>
    <message>
        <source>It is not a label map</source>
        <translation>No és un mapa d’etiquetes</translation>
    </message>
    <message>
        <source>an archive</source>
        <translation>un arxiu comprimit</translation>
    </message>
    <message>
        <source>a CAD model</source>
        <translation>un model de CAD</translation>
    </message>
    <message>
        <source>a scene of a 3D program</source>
        <translation>una escena d’un programa 3D</translation>
    </message>
    <message>
        <source>a scene of 3D Slicer</source>
        <translation>una escena de 3D Slicer</translation>
    </message>
    <message>
        <source>a document</source>
        <translation>un document</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>una taula</translation>
    </message>
    <message>
        <source>export it as STL, OBJ, PLY or GLB</source>
        <translation>exporteu-lo com a STL, OBJ, PLY o GLB</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>descomprimiu-lo primer</translation>
    </message>
    <message>
        <source>open the images that it was made from: a DICOM series, NIfTI, NRRD or MetaImage</source>
        <translation>obriu les imatges de què procedeix: una sèrie DICOM, NIfTI, NRRD o MetaImage</translation>
    </message>
    <message>
        <source>save its surface as .vtp, or its image as .mha, in ParaView or 3D Slicer</source>
        <translation>deseu-ne la superfície com a .vtp o la imatge com a .mha, al ParaView o al 3D Slicer</translation>
    </message>
    <message>
        <source>open a file of organs, handles or a sequence</source>
        <translation>obriu un fitxer d’òrgans, de tiradors o d’una seqüència</translation>
    </message>
    <message>
        <source>save its segmentation and its models in 3D Slicer, and open these</source>
        <translation>deseu-ne la segmentació i els models al 3D Slicer i obriu-los</translation>
    </message>
    <message>
        <source>open the files of the organs</source>
        <translation>obriu els fitxers dels òrgans</translation>
    </message>
    <message>
        <source>divide its polygons into triangles in the program that made it, and export it again</source>
        <translation>dividiu els seus polígons en triangles en el programa que el va crear i exporteu-lo de nou</translation>
    </message>
    <message numerus="yes">
        <source>%n {polygon that is not flat was|polygons that are not flat were} cut into triangles that overlap</source>
        <translation>
            <numerusform>%n polígon que no és pla s’ha dividit en triangles que se superposen</numerusform>
            <numerusform>%n polígons que no són plans s’han dividit en triangles que se superposen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face|faces} of fewer than three corners left out</source>
        <translation>
            <numerusform>%n cara de menys de tres vèrtexs omesa</numerusform>
            <numerusform>%n cares de menys de tres vèrtexs omeses</numerusform>
        </translation>
    </message>
    <message>
        <source>the colours in %1 are missing: %2</source>
        <translation>falten els colors de %1: %2</translation>
    </message>
    <message>
        <source>Its geometry is compressed (%1), which Viscera does not read</source>
        <translation>La seva geometria està comprimida (%1), cosa que Viscera no llegeix</translation>
    </message>
    <message>
        <source>export it without compression (in Blender: leave out Data &gt; Compression), or as STL or PLY</source>
        <translation>exporteu-lo sense compressió (a Blender: sense Data &gt; Compression), o com a STL o PLY</translation>
    </message>
    <message>
        <source>save the surfaces as .vtp</source>
        <translation>deseu les superfícies com a .vtp</translation>
    </message>
    <message>
        <source>It names no surface files</source>
        <translation>No anomena cap fitxer de superfície</translation>
    </message>
    <message numerus="yes">
        <source>%n {block|blocks} without a surface ignored</source>
        <translation>
            <numerusform>%n bloc sense superfície ignorat</numerusform>
            <numerusform>%n blocs sense superfície ignorats</numerusform>
        </translation>
    </message>
    <message>
        <source>a block is at %1, but only files beside it are read</source>
        <translation>un bloc és a %1, però només es llegeixen fitxers al costat</translation>
    </message>
    <message>
        <source>the block %1 is no surface and was left out</source>
        <translation>el bloc %1 no és una superfície i s’ha omès</translation>
    </message>
    <message>
        <source>its block %1 holds blocks of its own in another file</source>
        <translation>el seu bloc %1 conté alhora blocs en un altre fitxer</translation>
    </message>
    <message>
        <source>its block %1 cannot be read: %2</source>
        <translation>el seu bloc %1 no es pot llegir: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>i %1 més</translation>
    </message>
    <message numerus="yes">
        <source>%n {open part|open parts} that share points were joined to one organ: %2</source>
        <translation>
            <numerusform>%n part oberta amb punts comuns s’han unit en un òrgan: %2</numerusform>
            <numerusform>%n parts obertes amb punts comuns s’han unit en un òrgan: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It holds %n {organ|organs}: %2</source>
        <translation>
            <numerusform>Conté %n òrgan: %2</numerusform>
            <numerusform>Conté %n òrgans: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>name one of them behind a slash: %1</source>
        <translation>anomeneu-ne un darrere d’una barra: %1</translation>
    </message>
    <message>
        <source>%1 lies inside %2, whose volume contains its volume</source>
        <translation>%1 és dins de %2, el volum del qual conté el seu</translation>
    </message>
    <message>
        <source>the commas in its numbers may be decimal marks or separate thousands or numbers</source>
        <translation>les comes dels seus nombres poden ser decimals o separar milers o nombres</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>exporteu-lo amb punts decimals</translation>
    </message>
    <message>
        <source>the commas in its numbers were read as decimal marks</source>
        <translation>les comes dels seus nombres s’han llegit com a decimals</translation>
    </message>
    <message>
        <source>It holds several organs</source>
        <translation>Conté diversos òrgans</translation>
    </message>
    <message>
        <source>its voxels are in another folder (%1)</source>
        <translation>els seus vòxels són en una altra carpeta (%1)</translation>
    </message>
    <message>
        <source>it is an Analyze 7.5 image, which does not say where it lies: its axes are taken as %1, and left and right may be exchanged</source>
        <translation>és una imatge Analyze 7.5, que no diu on és: els seus eixos es prenen com a %1, i l’esquerra i la dreta poden estar intercanviades</translation>
    </message>
    <message>
        <source>it does not say where it lies; coronal slices of 1 mm are assumed, as FreeSurfer does</source>
        <translation>no diu on és; se suposen talls coronals d’1 mm, com fa FreeSurfer</translation>
    </message>
    <message>
        <source>one of its labels in group %1 has no valid number or image</source>
        <translation>una de les seves etiquetes del grup %1 no té número o imatge vàlids</translation>
    </message>
    <message>
        <source>its values are not exactly whole numbers; they were rounded to labels, by at most %1</source>
        <translation>els seus valors no són exactament nombres enters; s’han arrodonit a etiquetes, en %1 com a màxim</translation>
    </message>
    <message>
        <source>It has %1 label maps over time, of which one is needed here</source>
        <translation>Conté %1 mapes d’etiquetes al llarg del temps, dels quals aquí en cal un</translation>
    </message>
    <message>
        <source>It has %1 label maps over time (at %2 ms), of which one is needed here</source>
        <translation>Conté %1 mapes d’etiquetes al llarg del temps (als %2 ms), dels quals aquí en cal un</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or choose one with --phase, from 0 to %2</source>
        <translation>seguiu el moviment per tots amb viscera track %1, o trieu-ne un amb --phase, de 0 a %2</translation>
    </message>
    <message>
        <source>its segments %1 have the same voxels (label %2 in one layer); they are one organ, %3</source>
        <translation>els seus segments %1 tenen els mateixos vòxels (etiqueta %2 en una capa); són un sol òrgan, %3</translation>
    </message>
    <message>
        <source>the names of its labels are those of FreeSurfer's colour table</source>
        <translation>els noms de les seves etiquetes són els de la taula de colors de FreeSurfer</translation>
    </message>
    <message>
        <source>It has several layers of one label map, not several phases</source>
        <translation>Conté diverses capes d’un mapa d’etiquetes, no diverses fases</translation>
    </message>
    <message>
        <source>write a .nhdr or .mhd header for it, which says its size</source>
        <translation>escriviu-li una capçalera .nhdr o .mhd, que digui la mida</translation>
    </message>
    <message>
        <source>a segmentation</source>
        <translation>una segmentació</translation>
    </message>
    <message>
        <source>open the images or the segmentation of the same patient, which are other files</source>
        <translation>obriu les imatges o la segmentació del mateix pacient, que són altres fitxers</translation>
    </message>
    <message>
        <source>It is the table of contents of a DICOM medium (DICOMDIR)</source>
        <translation>És l’índex d’un suport DICOM (DICOMDIR)</translation>
    </message>
    <message>
        <source>open the folder that it lists, %1</source>
        <translation>obriu la carpeta que descriu, %1</translation>
    </message>
    <message>
        <source>open it as a label map</source>
        <translation>obriu-la com a mapa d’etiquetes</translation>
    </message>
    <message>
        <source>open it as a surface</source>
        <translation>obriu-la com a superfície</translation>
    </message>
    <message>
        <source>It is a DICOM file that holds no scan, label map or surface: %1</source>
        <translation>És un fitxer DICOM sense exploració, mapa d’etiquetes ni superfície: %1</translation>
    </message>
    <message>
        <source>an object of an unknown kind</source>
        <translation>un objecte d’un tipus desconegut</translation>
    </message>
    <message>
        <source>its pixels are packed in a way that is not supported</source>
        <translation>els seus píxels estan comprimits d’una manera no admesa</translation>
    </message>
    <message>
        <source>save it without compression</source>
        <translation>deseu-lo sense compressió</translation>
    </message>
    <message>
        <source>It is a segmentation that %1</source>
        <translation>És una segmentació que %1</translation>
    </message>
    <message>
        <source>its segment 0 (%1) has got the label %2</source>
        <translation>el seu segment 0 (%1) ha rebut l’etiqueta %2</translation>
    </message>
    <message>
        <source>its fractions are all 0 or 1 of a larger whole; 1 was read as inside</source>
        <translation>les seves fraccions són totes 0 o 1 d’un total més gran; 1 s’ha llegit com a interior</translation>
    </message>
    <message>
        <source>its pixels of one bit are packed in a way that is not supported (%1)</source>
        <translation>els seus píxels d’un bit estan comprimits d’una manera no admesa (%1)</translation>
    </message>
    <message>
        <source>It is a DICOM image, not a surface</source>
        <translation>És una imatge DICOM, no una superfície</translation>
    </message>
    <message>
        <source>make a label map of it first, or open it as one</source>
        <translation>feu-ne primer un mapa d’etiquetes, o obriu-la com a tal</translation>
    </message>
    <message>
        <source>the file does not state its axes: RAS is assumed, as 3D Slicer does</source>
        <translation>el fitxer no indica els seus eixos: se suposa RAS, com fa 3D Slicer</translation>
    </message>
    <message numerus="yes">
        <source>%2 and %n more</source>
        <translation>
            <numerusform>%2 i %n més</numerusform>
            <numerusform>%2 i %n més</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point was|points were} never placed (%2), and there is no other</source>
        <translation>
            <numerusform>%n punt no s’ha col·locat mai (%2), i no n’hi ha cap altre</numerusform>
            <numerusform>%n punts no s’han col·locat mai (%2), i no n’hi ha cap altre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that was never placed is|points that were never placed are} left out: %2</source>
        <translation>
            <numerusform>%n punt que no s’ha col·locat mai s’omet: %2</numerusform>
            <numerusform>%n punts que no s’han col·locat mai s’ometen: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds no points, but %1</source>
        <translation>El fitxer no conté punts, sinó %1</translation>
    </message>
    <message>
        <source>copy its control points into a point list in Slicer's module Markups, and save the list</source>
        <translation>copieu els seus punts de control en una llista de punts del mòdul Markups de Slicer i deseu la llista</translation>
    </message>
    <message numerus="yes">
        <source>%n {object that the file does not place is|objects that the file does not place are} left out</source>
        <translation>
            <numerusform>%n objecte que el fitxer no col·loca s’omet</numerusform>
            <numerusform>%n objectes que el fitxer no col·loca s’ometen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {object that only supports a print is|objects that only support a print are} left out</source>
        <translation>
            <numerusform>%n objecte que només sosté una impressió s’omet</numerusform>
            <numerusform>%n objectes que només sostenen una impressió s’ometen</numerusform>
        </translation>
    </message>
    <message>
        <source>colours that come from pictures or mixtures are left out</source>
        <translation>els colors que vénen d’imatges o mescles s’ometen</translation>
    </message>
    <message>
        <source>beams and other shapes that are no triangles are left out</source>
        <translation>les bigues i altres formes que no són triangles s’ometen</translation>
    </message>
    <message>
        <source>export it without a password</source>
        <translation>exporteu-lo sense contrasenya</translation>
    </message>
    <message>
        <source>It is a ZIP archive without a 3D model</source>
        <translation>És un arxiu ZIP sense model 3D</translation>
    </message>
    <message>
        <source>unpack it and open the files in it</source>
        <translation>descomprimiu-lo i obriu els fitxers que conté</translation>
    </message>
    <message>
        <source>the surface is too large for 3MF, whose parts end at 4 GB</source>
        <translation>la superfície és massa gran per a 3MF, les parts del qual acaben a 4 GB</translation>
    </message>
    <message>
        <source>zlib cannot pack it</source>
        <translation>zlib no la pot comprimir</translation>
    </message>
    <message>
        <source>tetrahedra are written as .inp or .vtu only</source>
        <translation>els tetraedres només s’escriuen com a .inp o .vtu</translation>
    </message>
    <message>
        <source>the surface %1 is open (%2 boundary edges)</source>
        <translation>la superfície %1 és oberta (%2 arestes de vora)</translation>
    </message>
    <message>
        <source>the surfaces %1 and %2 share points</source>
        <translation>les superfícies %1 i %2 comparteixen punts</translation>
    </message>
    <message>
        <source>move them apart: there is no tissue between them</source>
        <translation>separeu-les: no hi ha teixit entre elles</translation>
    </message>
    <message>
        <source>a cavity is not wholly inside the organ, or inside another cavity</source>
        <translation>una cavitat no és del tot dins de l’òrgan, o és dins d’una altra</translation>
    </message>
    <message>
        <source>leave it out, or make it smaller</source>
        <translation>ometeu-la o feu-la més petita</translation>
    </message>
    <message>
        <source>It is of gmsh's format %1, which Viscera does not read</source>
        <translation>És del format %1 de gmsh, que Viscera no llegeix</translation>
    </message>
    <message>
        <source>open it with gmsh and save it as version 2 or 4</source>
        <translation>obriu-lo amb gmsh i deseu-lo com a versió 2 o 4</translation>
    </message>
    <message>
        <source>It is a plane mesh, of two dimensions</source>
        <translation>És una malla plana, de dues dimensions</translation>
    </message>
    <message>
        <source>export a mesh of three dimensions</source>
        <translation>exporteu una malla de tres dimensions</translation>
    </message>
    <message>
        <source>openCARP states points in micrometres: its numbers were divided by 1,000</source>
        <translation>openCARP indica els punts en micròmetres: els seus nombres s’han dividit per 1000</translation>
    </message>
    <message>
        <source>%1 has more lines than the %2 points that it states; they were left out</source>
        <translation>%1 té més línies que els %2 punts que indica; s’han omès</translation>
    </message>
    <message>
        <source>It has elements of the type %1, which Viscera does not read</source>
        <translation>Té elements del tipus %1, que Viscera no llegeix</translation>
    </message>
    <message>
        <source>save the mesh as tetrahedra</source>
        <translation>deseu la malla com a tetraedres</translation>
    </message>
    <message>
        <source>reduce the mesh first</source>
        <translation>reduïu primer la malla</translation>
    </message>
    <message>
        <source>its %1 regions (%2) were joined to one surface around all of them</source>
        <translation>les seves %1 regions (%2) s’han unit en una superfície al voltant de totes</translation>
    </message>
    <message numerus="yes">
        <source>%n {cell that repeats|cells that repeat} another left out</source>
        <translation>
            <numerusform>%n cel·la que en repeteix una altra omesa</numerusform>
            <numerusform>%n cel·les que en repeteixen d’altres omeses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face belongs|faces belong} to more than two cells, which overlap</source>
        <translation>
            <numerusform>%n cara pertany a més de dues cel·les, que se superposen</numerusform>
            <numerusform>%n cares pertanyen a més de dues cel·les, que se superposen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {flat cell that bounds|flat cells that bound} no cell with a volume left out</source>
        <translation>
            <numerusform>%n cel·la plana que no limita cap cel·la amb volum omesa</numerusform>
            <numerusform>%n cel·les planes que no limiten cap cel·la amb volum omeses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curved {cell was|cells were} read as straight between {its|their} corners</source>
        <translation>
            <numerusform>%n cel·la corba s’ha llegit com a recta entre els seus vèrtexs</numerusform>
            <numerusform>%n cel·les corbes s’han llegit com a rectes entre els seus vèrtexs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has %n {cavity|cavities}: its volume is that of the wall around {it|them}</source>
        <translation>
            <numerusform>té %n cavitat: el seu volum és el de la paret que l’envolta</numerusform>
            <numerusform>té %n cavitats: el seu volum és el de la paret que les envolta</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n small {gap|gaps} between its cells filled</source>
        <translation>
            <numerusform>%n petit buit omplert entre les seves cel·les</numerusform>
            <numerusform>%n petits buits omplerts entre les seves cel·les</numerusform>
        </translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Cavitat</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} that CARTO's user has cut away left out</source>
        <translation>
            <numerusform>%n triangle retallat a CARTO omès</numerusform>
            <numerusform>%n triangles retallats a CARTO omesos</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not say where its scan is: its points stay in FreeSurfer's own coordinates, which may be some millimetres beside the scan</source>
        <translation>no diu on és la seva exploració: els seus punts queden en les coordenades pròpies de FreeSurfer, que poden ser a uns mil·límetres de l’exploració</translation>
    </message>
    <message>
        <source>It holds values at the points of a surface, such as curvature or thickness, not a surface</source>
        <translation>Conté valors als punts d’una superfície, com ara curvatura o gruix, no una superfície</translation>
    </message>
    <message>
        <source>open the surface to which they belong, such as lh.white or lh.pial</source>
        <translation>obriu la superfície a la qual pertanyen, com ara lh.white o lh.pial</translation>
    </message>
    <message>
        <source>its points were moved from FreeSurfer's own coordinates to those of its scan</source>
        <translation>els seus punts s’han mogut de les coordenades pròpies de FreeSurfer a les de la seva exploració</translation>
    </message>
    <message numerus="yes">
        <source>%n further {surface|surfaces} of the file left out</source>
        <translation>
            <numerusform>%n superfície més del fitxer omesa</numerusform>
            <numerusform>%n superfícies més del fitxer omeses</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds values at the points of a surface (%1), not a surface</source>
        <translation>Conté valors als punts d’una superfície (%1), no una superfície</translation>
    </message>
    <message>
        <source>open the surface to which they belong, which usually ends in .surf.gii</source>
        <translation>obriu la superfície a la qual pertanyen, que sol acabar en .surf.gii</translation>
    </message>
    <message>
        <source>It holds no surface of triangles</source>
        <translation>No conté cap superfície de triangles</translation>
    </message>
    <message>
        <source>Its values are in another file, %1, which Viscera does not read</source>
        <translation>Els seus valors són en un altre fitxer, %1, que Viscera no llegeix</translation>
    </message>
    <message>
        <source>save it with its values inside (GZipBase64Binary)</source>
        <translation>deseu-lo amb els seus valors a dins (GZipBase64Binary)</translation>
    </message>
    <message>
        <source>its points were moved to the scan by the matrix that the file states</source>
        <translation>els seus punts s’han mogut a l’exploració amb la matriu que indica el fitxer</translation>
    </message>
    <message>
        <source>its matrix from %1 to %2 was not applied</source>
        <translation>la seva matriu de %1 a %2 no s’ha aplicat</translation>
    </message>
    <message>
        <source>save it as %1 with %2</source>
        <translation>deseu-lo com a %1 amb %2</translation>
    </message>
    <message>
        <source>load it in 3D Slicer with its images, convert it to a segmentation there, and save that as .seg.nrrd</source>
        <translation>carregueu-lo al 3D Slicer amb les seves imatges, convertiu-lo allà en una segmentació i deseu-la com a .seg.nrrd</translation>
    </message>
    <message>
        <source>It holds %1, not %2</source>
        <translation>El fitxer conté %1, no %2</translation>
    </message>
    <message>
        <source>its unit %1 is not known; mm are assumed</source>
        <translation>la seva unitat %1 és desconeguda; se suposen mm</translation>
    </message>
    <message>
        <source>converted from %1 to mm</source>
        <translation>convertit de %1 a mm</translation>
    </message>
    <message>
        <source>the other file that belongs to it, %1, is not beside it</source>
        <translation>l’altre fitxer que li correspon, %1, no és al seu costat</translation>
    </message>
    <message>
        <source>this cannot be written as %1</source>
        <translation>això no es pot escriure com a %1</translation>
    </message>
    <message>
        <source>several surfaces cannot be written as %1</source>
        <translation>diverses superfícies no es poden escriure com a %1</translation>
    </message>
    <message>
        <source>let its name end in %1</source>
        <translation>feu que el seu nom acabi en %1</translation>
    </message>
    <message>
        <source>rename it to end in %1</source>
        <translation>canvieu-li el nom perquè acabi en %1</translation>
    </message>
    <message>
        <source>a line</source>
        <translation>una línia</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un angle</translation>
    </message>
    <message>
        <source>a curve</source>
        <translation>una corba</translation>
    </message>
    <message>
        <source>a closed curve</source>
        <translation>una corba tancada</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>un pla</translation>
    </message>
    <message>
        <source>a box (ROI)</source>
        <translation>una caixa (ROI)</translation>
    </message>
    <message>
        <source>a markup of another kind</source>
        <translation>una marca d’un altre tipus</translation>
    </message>
    <message>
        <source>%1 is made for another organ (%2) than this one (%3): its numbers say nothing about it</source>
        <translation>%1 està fet per a un altre òrgan (%2) i no per a aquest (%3): les seves xifres no en diuen res</translation>
    </message>
    <message>
        <source>The motion was recorded of another organ (%1) than this one (%2): its numbers say nothing about it</source>
        <translation>El moviment es va enregistrar en un altre òrgan (%1) i no en aquest (%2): les seves xifres no en diuen res</translation>
    </message>
    <message>
        <source>right and left, front and back, head and feet are exchanged: mirrored</source>
        <translation>dreta i esquerra, davant i darrere, cap i peus estan intercanviats: emmirallat</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are right and left: the patient is upside down</source>
        <translation>cap i peus estan intercanviats, i també dreta i esquerra: el pacient està cap per avall</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, unless head and feet are exchanged too</source>
        <translation>dreta i esquerra estan intercanviades, davant i darrere no: emmirallat, tret que també ho estiguin cap i peus</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, or situs inversus</source>
        <translation>dreta i esquerra estan intercanviades, davant i darrere no: emmirallat, o situs inversus</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are front and back: the patient is upside down</source>
        <translation>cap i peus estan intercanviats, i també davant i darrere: el pacient està cap per avall</translation>
    </message>
    <message>
        <source>head and feet are exchanged: the patient is upside down, or mirrored</source>
        <translation>cap i peus estan intercanviats: el pacient està cap per avall o emmirallat</translation>
    </message>
    <message>
        <source>head and feet are exchanged, front and back are not: the slices seem to be in the opposite order, which mirrors the patient</source>
        <translation>cap i peus estan intercanviats, davant i darrere no: els talls semblen en ordre invers, cosa que emmiralla el pacient</translation>
    </message>
    <message>
        <source>front and back are exchanged: the files may be in RAS, mirrored, or upside down</source>
        <translation>davant i darrere estan intercanviats: potser els fitxers són en RAS, emmirallats o cap per avall</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored, unless head and feet are exchanged too</source>
        <translation>davant i darrere estan intercanviats, dreta i esquerra no: emmirallat, tret que també ho estiguin cap i peus</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored</source>
        <translation>davant i darrere estan intercanviats, dreta i esquerra no: emmirallat</translation>
    </message>
    <message>
        <source>the head lies along the y axis: the files seem to come from a program in which y is up</source>
        <translation>el cap és al llarg de l’eix y: els fitxers semblen venir d’un programa en què y apunta cap amunt</translation>
    </message>
    <message>
        <source>the organs do not lie as in a body whose axes are LPS: other axes, or not of one patient</source>
        <translation>els òrgans no estan com en un cos amb els eixos LPS: altres eixos, o no són d’un mateix pacient</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on that side, but the others lie on the side opposite to the usual one: situs inversus, or wrong names</source>
        <translation>els òrgans el nom dels quals diu esquerra o dreta són en aquest costat, però els altres són al costat oposat a l’habitual: situs inversus, o noms equivocats</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on the opposite side, but the others lie as usual: left and right seem to be exchanged in the names</source>
        <translation>els òrgans el nom dels quals diu esquerra o dreta són al costat oposat, però els altres són com és habitual: esquerra i dreta semblen intercanviades en els noms</translation>
    </message>
    <message numerus="yes">
        <source>by the other organs, %n {organ lies|organs lie} on the opposite side of the patient: %2</source>
        <translation>
            <numerusform>segons els altres òrgans, %n òrgan és al costat oposat del pacient: %2</numerusform>
            <numerusform>segons els altres òrgans, %n òrgans són al costat oposat del pacient: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: the coordinates seem to be in %2</source>
        <translation>pels seus volums, tots els òrgans són %1 vegades la mida natural: les coordenades semblen ser en %2</translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: a child, an atlas that is not life-sized, or another unit</source>
        <translation>pels seus volums, tots els òrgans són %1 vegades la mida natural: un infant, un atles que no és de mida natural, o una altra unitat</translation>
    </message>
    <message>
        <source>among the other organs it lies on the side that its name says</source>
        <translation>entre els altres òrgans és al costat que diu el seu nom</translation>
    </message>
    <message>
        <source>turns the surface by a quarter and a half turn, from a model in RAS whose y axis points to the head</source>
        <translation>gira la superfície un quart i mitja volta, des d’un model en RAS l’eix y del qual apunta al cap</translation>
    </message>
    <message>
        <source>exchanges front and back, which mirrors the surface</source>
        <translation>intercanvia davant i darrere, cosa que emmiralla la superfície</translation>
    </message>
    <message>
        <source>exchanges head and feet, which mirrors the surface</source>
        <translation>intercanvia cap i peus, cosa que emmiralla la superfície</translation>
    </message>
    <message>
        <source>exchanges head and feet, and front and back, by half a turn</source>
        <translation>intercanvia cap i peus, i davant i darrere, amb mitja volta</translation>
    </message>
    <message>
        <source>exchanges head and feet, and right and left, by half a turn</source>
        <translation>intercanvia cap i peus, i dreta i esquerra, amb mitja volta</translation>
    </message>
    <message>
        <source>exchanges all three directions, which mirrors the surface</source>
        <translation>intercanvia les tres direccions, cosa que emmiralla la superfície</translation>
    </message>
    <message>
        <source>Convert from Y up and RAS to LPS</source>
        <translation>Converteix de Y amunt i RAS a LPS</translation>
    </message>
    <message>
        <source>Mirror front and back</source>
        <translation>Emmiralla davant i darrere</translation>
    </message>
    <message>
        <source>Mirror head and feet</source>
        <translation>Emmiralla cap i peus</translation>
    </message>
    <message>
        <source>Turn head and feet, front and back</source>
        <translation>Gira cap i peus, davant i darrere</translation>
    </message>
    <message>
        <source>Turn head and feet, right and left</source>
        <translation>Gira cap i peus, dreta i esquerra</translation>
    </message>
    <message>
        <source>Mirror all three directions</source>
        <translation>Emmiralla les tres direccions</translation>
    </message>
    <message numerus="yes">
        <source>is cut by {the %2 edge|%n edges (%2)} of the image: its volume is too small</source>
        <translation>
            <numerusform>està tallat per la vora %2 de la imatge: el seu volum és massa petit</numerusform>
            <numerusform>està tallat per %n vores (%2) de la imatge: el seu volum és massa petit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reaches {the %2 edge|%n edges (%2)} of the image, which may cut it off</source>
        <translation>
            <numerusform>arriba a la vora %2 de la imatge, que el pot tallar</numerusform>
            <numerusform>arriba a %n vores (%2) de la imatge, que el pot tallar</numerusform>
        </translation>
    </message>
    <message>
        <source>right</source>
        <translation>dret</translation>
    </message>
    <message>
        <source>left</source>
        <translation>esquerre</translation>
    </message>
    <message>
        <source>front</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>back</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>There are no organs whose coordinates could be converted</source>
        <translation>No hi ha òrgans les coordenades dels quals es puguin convertir</translation>
    </message>
    <message>
        <source>open some first</source>
        <translation>obriu-ne algun primer</translation>
    </message>
    <message>
        <source>Convert between RAS and LPS</source>
        <translation>Converteix entre RAS i LPS</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Emmiralla esquerra i dreta</translation>
    </message>
    <message>
        <source>Convert the unit</source>
        <translation>Converteix la unitat</translation>
    </message>
    <message>
        <source>Convert the axes</source>
        <translation>Converteix els eixos</translation>
    </message>
    <message>
        <source>converted after the import: %1</source>
        <translation>convertit després d’importar: %1</translation>
    </message>
    <message>
        <source>Scale by %1</source>
        <translation>Escala per %1</translation>
    </message>
    <message>
        <source>scaled after the import by %1</source>
        <translation>escalat després d’importar per %1</translation>
    </message>
    <message>
        <source>All organs together: %1.</source>
        <translation>Tots els òrgans junts: %1.</translation>
    </message>
    <message>
        <source>RAS or mirrored</source>
        <translation>RAS o emmirallat</translation>
    </message>
    <message>
        <source>head and feet exchanged</source>
        <translation>cap i peus intercanviats</translation>
    </message>
    <message>
        <source>Only partly possible: %1</source>
        <translation>Només és possible en part: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancel·la</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Llengua</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Seqüències</translation>
    </message>
    <message>
        <source>All %1 slices were resampled to a distance of %2 mm; values between two slices are mixed from both</source>
        <translation>Els %1 talls s’han remostrejat a una distància de %2 mm; els valors entre dos talls són una barreja de tots dos</translation>
    </message>
    <message>
        <source>It does not say how thick its slice is; 1 mm is assumed, so volumes in it are not measured</source>
        <translation>No diu quin gruix té el tall; se suposa 1 mm, de manera que els volums no hi són mesurats</translation>
    </message>
    <message>
        <source>It does not say how large its pixels are; %1 mm were taken from its field of view, so check a length that you know</source>
        <translation>No diu quina mida tenen els píxels; s’han pres %1 mm del camp de visió, comproveu doncs una longitud coneguda</translation>
    </message>
    <message>
        <source>none of the %1 pieces is as small as that</source>
        <translation>cap dels %1 trossos no és tan petit</translation>
    </message>
    <message numerus="yes">
        <source>%n of %2 pieces {goes|go}, of %3 mm and %4 ml at most</source>
        <translation>
            <numerusform>desapareix %n de %2 trossos, de %3 mm i %4 ml com a màxim</numerusform>
            <numerusform>desapareixen %n de %2 trossos, de %3 mm i %4 ml com a màxim</numerusform>
        </translation>
    </message>
    <message>
        <source>drops the pieces that are smaller than a size; the largest one stays</source>
        <translation>elimina els trossos més petits que una mida; el més gran es queda</translation>
    </message>
    <message>
        <source>multiplies all coordinates by a factor</source>
        <translation>multiplica totes les coordenades per un factor</translation>
    </message>
    <message>
        <source>details of %1 mm take too much memory; %2 mm is the finest for its size</source>
        <translation>els detalls de %1 mm ocupen massa memòria; %2 mm és el més fi per a la seva mida</translation>
    </message>
    <message>
        <source>choose a coarser resolution</source>
        <translation>trieu una resolució més gruixuda</translation>
    </message>
    <message>
        <source>remeshing lost a detail: the old surface lies up to %1 mm from the new one</source>
        <translation>el remallat ha perdut un detall: la superfície antiga és fins a %1 mm de la nova</translation>
    </message>
    <message>
        <source>the handles cannot move by exactly %1 mm: %2</source>
        <translation>els tiradors no es poden moure exactament %1 mm: %2</translation>
    </message>
    <message>
        <source>move less far, or let more handles compensate</source>
        <translation>moveu menys, o deixeu que compensin més tiradors</translation>
    </message>
    <message>
        <source>This organ does not bend, so its tissue has no stress; let it bend as soft tissue</source>
        <translation>Aquest òrgan no es doblega, així que el seu teixit no té tensió; deixeu que es doblegui com a teixit tou</translation>
    </message>
    <message>
        <source>Move as a rigid body</source>
        <translation>Mou com a cos rígid</translation>
    </message>
    <message>
        <source>Keep in place</source>
        <translation>Mantén al seu lloc</translation>
    </message>
    <message>
        <source>Bend as soft tissue</source>
        <translation>Doblega com a teixit tou</translation>
    </message>
    <message>
        <source>Measure the distance of organs</source>
        <translation>Mesura la distància d’òrgans</translation>
    </message>
    <message>
        <source>The shortest distance is between two organs</source>
        <translation>La distància més curta és entre dos òrgans</translation>
    </message>
    <message>
        <source>select two organs</source>
        <translation>seleccioneu dos òrgans</translation>
    </message>
    <message>
        <source>shortest distance</source>
        <translation>distància més curta</translation>
    </message>
    <message>
        <source>There are %1 witness points of %2: the others would lie in cavities, which hold no tissue.</source>
        <translation>Hi ha %1 punts testimoni de %2: els altres serien en cavitats, que no contenen teixit.</translation>
    </message>
    <message>
        <source>The largest angle by which a direction is turned when the tissue is stretched; not a pressure.</source>
        <translation>L’angle més gran que gira una direcció quan s’estira el teixit; no és una pressió.</translation>
    </message>
    <message>
        <source>The volume of tissue now, as a part of that at rest; 1 is unchanged.</source>
        <translation>El volum del teixit ara, respecte al de repòs; 1 és sense canvi.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that grows most.</source>
        <translation>La longitud del teixit ara, respecte a la de repòs, en la direcció que més creix.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that shrinks most.</source>
        <translation>La longitud del teixit ara, respecte a la de repòs, en la direcció que més s’encongeix.</translation>
    </message>
    <message>
        <source>1 where the tissue is turned inside out.</source>
        <translation>1 on el teixit està capgirat.</translation>
    </message>
    <message>
        <source>global longitudinal strain</source>
        <translation>deformació longitudinal global</translation>
    </message>
    <message>
        <source>global circumferential strain</source>
        <translation>deformació circumferencial global</translation>
    </message>
    <message>
        <source>global radial strain</source>
        <translation>deformació radial global</translation>
    </message>
    <message>
        <source>67 healthy adults, by feature tracking in magnetic resonance over the whole ventricle (CVI42); other programs differ by several points</source>
        <translation>67 adults sans, per seguiment de trets en ressonància magnètica de tot el ventricle (CVI42); altres programes difereixen en diversos punts</translation>
    </message>
    <message>
        <source>The surface encloses nothing</source>
        <translation>La superfície no tanca res</translation>
    </message>
    <message>
        <source>choose the surface of its cavity</source>
        <translation>trieu la superfície de la seva cavitat</translation>
    </message>
    <message>
        <source>The base and the apex are the same place</source>
        <translation>La base i l’àpex són el mateix lloc</translation>
    </message>
    <message>
        <source>choose two other points</source>
        <translation>trieu dos altres punts</translation>
    </message>
    <message>
        <source>The insertion of the right ventricle lies on the long axis</source>
        <translation>La inserció del ventricle dret és a l’eix llarg</translation>
    </message>
    <message>
        <source>choose a point of the wall</source>
        <translation>trieu un punt de la paret</translation>
    </message>
    <message>
        <source>The wall cannot be divided into layers</source>
        <translation>La paret no es pot dividir en capes</translation>
    </message>
    <message>
        <source>use fewer witness points</source>
        <translation>useu menys punts testimoni</translation>
    </message>
    <message>
        <source>The tissue does not reach from the cavity to the outer surface</source>
        <translation>El teixit no arriba de la cavitat a la superfície exterior</translation>
    </message>
    <message>
        <source>choose the surfaces of one heart</source>
        <translation>trieu les superfícies d’un mateix cor</translation>
    </message>
    <message>
        <source>name one of the surfaces of the heart</source>
        <translation>anomeneu una de les superfícies del cor</translation>
    </message>
    <message>
        <source>There is no phase %1</source>
        <translation>No hi ha cap fase %1</translation>
    </message>
    <message>
        <source>phases are counted from 1 to %1</source>
        <translation>les fases es compten d’1 a %1</translation>
    </message>
    <message>
        <source>layers of the wall</source>
        <translation>capes de la paret</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>deformació</translation>
    </message>
    <message>
        <source>surfaces in motion</source>
        <translation>superfícies en moviment</translation>
    </message>
    <message>
        <source>No surface is a left ventricle by its name</source>
        <translation>Cap superfície és pel seu nom un ventricle esquerre</translation>
    </message>
    <message>
        <source>name its cavity with --lv</source>
        <translation>anomeneu la seva cavitat amb --lv</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>hi ha: %1</translation>
    </message>
    <message>
        <source>It holds no organ</source>
        <translation>No conté cap òrgan</translation>
    </message>
    <message>
        <source>name one with --organ</source>
        <translation>anomeneu-ne un amb --organ</translation>
    </message>
    <message>
        <source>Without the right ventricle the numbers of segments mean nothing: give its surface, or a point where it meets the left one in front</source>
        <translation>Sense el ventricle dret els números dels segments no volen dir res: doneu la seva superfície, o un punt on s’uneix a l’esquerre per davant</translation>
    </message>
    <message>
        <source>Material points are not known in this motion: lengths of contours can be read, segments cannot</source>
        <translation>En aquest moviment no es coneixen els punts materials: es poden llegir longituds de contorns, no els segments</translation>
    </message>
    <message>
        <source>The left ventricle is fullest in phase %1, and strain is measured from phase %2</source>
        <translation>El ventricle esquerre és més ple a la fase %1, i la deformació es mesura des de la fase %2</translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} too few points to be read</source>
        <translation>
            <numerusform>%n segment té massa pocs punts per llegir-se</numerusform>
            <numerusform>%n segments tenen massa pocs punts per llegir-se</numerusform>
        </translation>
    </message>
    <message>
        <source>see docs/strain.md for the form of such a file</source>
        <translation>vegeu docs/strain.md per a la forma d’un fitxer així</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Contracció isovolumètrica</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Relaxació isovolumètrica</translation>
    </message>
    <message>
        <source>Ejection time</source>
        <translation>Temps d’ejecció</translation>
    </message>
    <message>
        <source>Aorta, in exercise</source>
        <translation>Aorta, en exercici</translation>
    </message>
    <message>
        <source>Left atrium, in exercise</source>
        <translation>Aurícula esquerra, en exercici</translation>
    </message>
    <message>
        <source>Aortic valve, in exercise</source>
        <translation>Vàlvula aòrtica, en exercici</translation>
    </message>
    <message>
        <source>highest pressure (a wave)</source>
        <translation>pressió més alta (ona a)</translation>
    </message>
    <message>
        <source>healthy adults at peak exercise</source>
        <translation>adults sans en l’exercici màxim</translation>
    </message>
    <message>
        <source>62 healthy people, wedge pressure; some of the oldest exceed it</source>
        <translation>62 persones sanes, pressió d’enclavament; algunes de les més grans la superen</translation>
    </message>
    <message>
        <source>healthy adults: the limit at rest is kept</source>
        <translation>adults sans: es manté el límit en repòs</translation>
    </message>
    <message>
        <source>textbooks; percentiles of 2917 people: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</source>
        <translation>manuals; percentils de 2917 persones: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</translation>
    </message>
    <message>
        <source>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</source>
        <translation>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</translation>
    </message>
    <message>
        <source>as at rest; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>com en repòs; sense estenosi fins a 2,5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>customary at the bedside, for the 1 to 1.7 m/s of a healthy valve; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>habitual a la clínica, per als 1 a 1,7 m/s d’una vàlvula sana; sense estenosi fins a 2,5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>none or a trace, which normal valves often have: doi 10.1378/chest.103.1.226</source>
        <translation>cap o una traça, que les vàlvules normals tenen sovint: doi 10.1378/chest.103.1.226</translation>
    </message>
    <message>
        <source>between the contractions of both, shorter than the PR interval of 0.12 to 0.20 s</source>
        <translation>entre les contraccions de tots dos, més curt que l’interval PR de 0,12 a 0,20 s</translation>
    </message>
    <message>
        <source>Tricuspid valve</source>
        <translation>Vàlvula tricúspide</translation>
    </message>
    <message>
        <source>Pulmonary valve</source>
        <translation>Vàlvula pulmonar</translation>
    </message>
    <message>
        <source>Longitudinal strain</source>
        <translation>Deformació longitudinal</translation>
    </message>
    <message>
        <source>Circumferential strain</source>
        <translation>Deformació circumferencial</translation>
    </message>
    <message>
        <source>Radial strain</source>
        <translation>Deformació radial</translation>
    </message>
    <message>
        <source>Difference of both</source>
        <translation>Diferència d’ambdues</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Deformació (strain)</translation>
    </message>
    <message>
        <source>Strain (%)</source>
        <translation>Deformació (%)</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Valor pic</translation>
    </message>
    <message>
        <source>At this instant</source>
        <translation>En aquest instant</translation>
    </message>
    <message>
        <source>Time to peak</source>
        <translation>Temps fins al pic</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>mid</source>
        <translation>mitjà</translation>
    </message>
    <message>
        <source>apex</source>
        <translation>àpex</translation>
    </message>
    <message>
        <source>%1 %2 % at %3 ms (healthy adults %4 to %5)</source>
        <translation>%1 %2 % als %3 ms (adults sans: de %4 a %5)</translation>
    </message>
    <message>
        <source>&amp;Strain of the wall</source>
        <translation>Deformac&amp;ió de la paret</translation>
    </message>
    <message>
        <source>Se&amp;gments on the organ</source>
        <translation>Seg&amp;ments a l’òrgan</translation>
    </message>
    <message>
        <source>Expo&amp;rt strain...</source>
        <translation>Expo&amp;rta la deformació...</translation>
    </message>
    <message>
        <source>Strain needs the cavity of a left ventricle, by its name, that follows the handles.</source>
        <translation>La deformació necessita la cavitat d’un ventricle esquerre, pel seu nom, que segueixi els tiradors.</translation>
    </message>
    <message>
        <source>The strain is drawn here as soon as it is measured.</source>
        <translation>La deformació es dibuixa aquí tan bon punt es mesura.</translation>
    </message>
    <message>
        <source>GLS and GCS are the change of the length of contours of the endocardium, as ultrasound and feature tracking report it. GRS and the segments are the strain of the material at witness points of the wall. Shortening is negative. All are against the end of diastole. Values of single segments are poorly repeated between programs: hatched ones are not to be relied on.</source>
        <translation>GLS i GCS són el canvi de longitud de contorns de l’endocardi, tal com els donen l’ecografia i el feature tracking. GRS i els segments són la deformació del material en punts testimoni de la paret. L’escurçament és negatiu. Tot es refereix al final de la diàstole. Els valors de segments solts es reprodueixen malament entre programes: no us refieu dels ratllats.</translation>
    </message>
    <message>
        <source>left ventricle</source>
        <translation>ventricle esquerre</translation>
    </message>
    <message>
        <source>hatched: uncertain</source>
        <translation>ratllat: incert</translation>
    </message>
    <message numerus="yes">
        <source>In %n {segment|segments} the fit of the motion leaves a peak less certain than its distance from the range of healthy adults</source>
        <translation>
            <numerusform>En %n segment l’ajust del moviment deixa un pic més incert que la seva distància a l’interval dels adults sans</numerusform>
            <numerusform>En %n segments l’ajust del moviment deixa un pic més incert que la seva distància a l’interval dels adults sans</numerusform>
        </translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Pacient</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>Data de l’estudi</translation>
    </message>
    <message>
        <source>Sinoatrial node</source>
        <translation>Node sinoauricular</translation>
    </message>
    <message>
        <source>Anterior internodal pathway</source>
        <translation>Via internodal anterior</translation>
    </message>
    <message>
        <source>Middle internodal pathway</source>
        <translation>Via internodal mitjana</translation>
    </message>
    <message>
        <source>Posterior internodal pathway</source>
        <translation>Via internodal posterior</translation>
    </message>
    <message>
        <source>Bachmann&apos;s bundle</source>
        <translation>Feix de Bachmann</translation>
    </message>
    <message>
        <source>Left atrial muscle</source>
        <translation>Múscul de l&apos;aurícula esquerra</translation>
    </message>
    <message>
        <source>Atrioventricular node</source>
        <translation>Node auriculoventricular</translation>
    </message>
    <message>
        <source>Bundle of His</source>
        <translation>Feix de His</translation>
    </message>
    <message>
        <source>Left bundle branch</source>
        <translation>Branca esquerra del feix de His</translation>
    </message>
    <message>
        <source>Left anterior fascicle</source>
        <translation>Fascicle anterior esquerre</translation>
    </message>
    <message>
        <source>Left posterior fascicle</source>
        <translation>Fascicle posterior esquerre</translation>
    </message>
    <message>
        <source>Left septal fascicle</source>
        <translation>Fascicle septal esquerre</translation>
    </message>
    <message>
        <source>Right bundle branch</source>
        <translation>Branca dreta del feix de His</translation>
    </message>
    <message>
        <source>Purkinje fibres</source>
        <translation>Fibres de Purkinje</translation>
    </message>
    <message>
        <source>Cardial notch</source>
        <translation>Incisura cardial</translation>
    </message>
    <message>
        <source>Angular incisure</source>
        <translation>Incisura angular</translation>
    </message>
    <message>
        <source>Greater omentum</source>
        <translation>Oment major</translation>
    </message>
    <message>
        <source>Diaphragmatic surface</source>
        <translation>Cara diafragmàtica</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Hil</translation>
    </message>
    <message>
        <source>Superior border</source>
        <translation>Marge superior</translation>
    </message>
    <message>
        <source>Anterior end</source>
        <translation>Extrem anterior</translation>
    </message>
    <message>
        <source>Posterior end</source>
        <translation>Extrem posterior</translation>
    </message>
    <message>
        <source>name its cavity&apos;s file LV</source>
        <translation>anomeneu LV el fitxer de la seva cavitat</translation>
    </message>
    <message numerus="yes">
        <source>%n {key|keys}</source>
        <translation>
            <numerusform>%n clau</numerusform>
            <numerusform>%n claus</numerusform>
        </translation>
    </message>
    <message>
        <source>the first at %1 s, the last at %2 s</source>
        <translation>la primera als %1 s, l’última als %2 s</translation>
    </message>
    <message>
        <source>the shape of the first of %1 files of its motion; the last one is %2</source>
        <translation>la forma del primer de %1 fitxers del seu moviment; l’últim és %2</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume in one place and swollen to %2 % in another. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>El teixit està comprimit al %1 % del seu volum en un lloc i inflat al %2 % en un altre. El teixit viu, sobretot aigua, gairebé no canvia de volum; les coordenades no ho saben. Un moviment més petit, més tiradors o un volum bloquejat hi ajuden.</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>El teixit està comprimit al %1 % del seu volum. El teixit viu, sobretot aigua, gairebé no canvia de volum; les coordenades no ho saben. Un moviment més petit, més tiradors o un volum bloquejat hi ajuden.</translation>
    </message>
    <message>
        <source>Tissue is swollen to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>El teixit està inflat al %1 % del seu volum. El teixit viu, sobretot aigua, gairebé no canvia de volum; les coordenades no ho saben. Un moviment més petit, més tiradors o un volum bloquejat hi ajuden.</translation>
    </message>
    <message>
        <source>Chordae tendineae</source>
        <translation>Cordes tendinoses</translation>
    </message>
    <message>
        <source>Left main coronary artery</source>
        <translation>Tronc de l’artèria coronària esquerra</translation>
    </message>
    <message>
        <source>Circumflex artery</source>
        <translation>Artèria circumflexa</translation>
    </message>
    <message>
        <source>Diagonal branch</source>
        <translation>Branca diagonal</translation>
    </message>
    <message>
        <source>Septal branches</source>
        <translation>Branques septals</translation>
    </message>
    <message>
        <source>Intermediate branch</source>
        <translation>Branca intermèdia</translation>
    </message>
    <message>
        <source>Right ventricular branch</source>
        <translation>Branca ventricular dreta</translation>
    </message>
    <message>
        <source>Conus branch</source>
        <translation>Branca del con</translation>
    </message>
    <message>
        <source>Left marginal branch</source>
        <translation>Branca marginal esquerra</translation>
    </message>
    <message>
        <source>Right marginal branch</source>
        <translation>Branca marginal dreta</translation>
    </message>
    <message>
        <source>Posterolateral branch</source>
        <translation>Branca posterolateral</translation>
    </message>
    <message>
        <source>Posterior descending artery</source>
        <translation>Artèria descendent posterior</translation>
    </message>
    <message>
        <source>Sinoatrial nodal branch</source>
        <translation>Branca del nòdul sinusal</translation>
    </message>
    <message>
        <source>Great cardiac vein</source>
        <translation>Vena cardíaca major</translation>
    </message>
    <message>
        <source>Middle cardiac vein</source>
        <translation>Vena cardíaca mitjana</translation>
    </message>
    <message>
        <source>Posterior vein of the left ventricle</source>
        <translation>Vena posterior del ventricle esquerre</translation>
    </message>
    <message>
        <source>Coronary sinus</source>
        <translation>Si coronari</translation>
    </message>
    <message>
        <source>geometric mean (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) of the systolic and diastolic bounds, 73 to 98 mmHg, rounded</source>
        <translation>mitjana geomètrica (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) dels límits sistòlics i diastòlics, de 73 a 98 mmHg, arrodonida</translation>
    </message>
    <message>
        <source>short axis</source>
        <translation>eix curt</translation>
    </message>
    <message>
        <source>long axis</source>
        <translation>eix llarg</translation>
    </message>
    <message>
        <source>other plane</source>
        <translation>un altre pla</translation>
    </message>
    <message>
        <source>2-chamber</source>
        <translation>2 cambres</translation>
    </message>
    <message>
        <source>3-chamber</source>
        <translation>3 cambres</translation>
    </message>
    <message>
        <source>4-chamber</source>
        <translation>4 cambres</translation>
    </message>
    <message>
        <source>It has no images over a heart&apos;s cycle</source>
        <translation>No conté imatges al llarg d&apos;un cicle cardíac</translation>
    </message>
    <message>
        <source>name the folder of a cine study, or a file with volumes over time</source>
        <translation>indiqueu la carpeta d&apos;un estudi de cine o un fitxer amb volums en el temps</translation>
    </message>
    <message>
        <source>It has changed since it was opened</source>
        <translation>Ha canviat des que es va obrir</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>torneu-lo a obrir</translation>
    </message>
    <message>
        <source>It does not say how long the heart&apos;s cycle is; its phases are spread over one</source>
        <translation>No diu quant dura el cicle cardíac; les seves fases es reparteixen en un</translation>
    </message>
    <message>
        <source>It has the images of %1 patients: &quot;%2&quot; and &quot;%3&quot; are of two</source>
        <translation>Conté les imatges de %1 pacients: «%2» i «%3» són de dos d&apos;ells</translation>
    </message>
    <message>
        <source>Series %1 shows the same place as series %2, and stands in for it in the stack</source>
        <translation>La sèrie %1 mostra el mateix lloc que la sèrie %2 i la substitueix a la pila</translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 to %4 mm between them, in which nothing was seen</source>
        <translation>Els %1 talls d&apos;una pila (%2) deixen entre ells buits de %3 a %4 mm, on no s&apos;ha vist res</translation>
    </message>
    <message>
        <source>Series %1 and %2 are %3 mm apart, other slices of the stack %4 mm: a slice between them may be missing</source>
        <translation>Les sèries %1 i %2 són a %3 mm, altres talls de la pila a %4 mm: potser falta un tall entre elles</translation>
    </message>
    <message numerus="yes">
        <source>%n {phase|phases} of series %2 {is|are} missing: %3 of %4 (the first is 0)</source>
        <translation>
            <numerusform>Falta %n fase de la sèrie %2: %3 de %4 (la primera és 0)</numerusform>
            <numerusform>Falten %n fases de la sèrie %2: %3 de %4 (la primera és 0)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of series %2 {has|have} the time of another one and {is|are} left out</source>
        <translation>
            <numerusform>%n imatge de la sèrie %2 té l&apos;instant d&apos;una altra i s&apos;omet</numerusform>
            <numerusform>%n imatges de la sèrie %2 tenen l&apos;instant d&apos;una altra i s&apos;ometen</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1 states a cycle of %2 ms, which is shorter than its phases; %3 ms were taken from their distance</source>
        <translation>La sèrie %1 indica un cicle de %2 ms, més curt que les seves fases; de la distància entre elles s&apos;han pres %3 ms</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out, phase %2 of series %3 (%4)</source>
        <translation>«%1» està malmès i s&apos;omet, fase %2 de la sèrie %3 (%4)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out (%2)</source>
        <translation>«%1» està malmès i s&apos;omet (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n other {file is|files are} damaged and left out</source>
        <translation>
            <numerusform>%n fitxer més està malmès i s&apos;omet</numerusform>
            <numerusform>%n fitxers més estan malmesos i s&apos;ometen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of another study left out (series %2)</source>
        <translation>
            <numerusform>%n tall d&apos;un altre estudi omès (sèrie %2)</numerusform>
            <numerusform>%n talls d&apos;un altre estudi omesos (sèrie %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of the study in another frame of reference left out (series %2)</source>
        <translation>
            <numerusform>%n tall de l&apos;estudi en un altre sistema de referència omès (sèrie %2)</numerusform>
            <numerusform>%n talls de l&apos;estudi en un altre sistema de referència omesos (sèrie %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {series|series} without the phases of a heart&apos;s cycle left out: %2</source>
        <translation>
            <numerusform>%n sèrie sense les fases d&apos;un cicle cardíac omesa: %2</numerusform>
            <numerusform>%n sèries sense les fases d&apos;un cicle cardíac omeses: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 mm between them, in which nothing was seen</source>
        <translation>Els %1 talls d&apos;una pila (%2) deixen entre ells buits de %3 mm, on no s&apos;ha vist res</translation>
    </message>
    <message>
        <source>The directions of its rows and columns are not perpendicular</source>
        <translation>Les direccions de les seves files i columnes no són perpendiculars</translation>
    </message>
    <message>
        <source>export the series again</source>
        <translation>exporteu la sèrie de nou</translation>
    </message>
    <message>
        <source>The size of its pixels is unknown</source>
        <translation>Es desconeix la mida dels seus píxels</translation>
    </message>
    <message>
        <source>It has no image, or images without times</source>
        <translation>No té cap imatge, o té imatges sense temps</translation>
    </message>
    <message>
        <source>The time of image %1 is not after the one before, within one cycle</source>
        <translation>El temps de la imatge %1 no és posterior a l&apos;anterior dins d&apos;un cicle</translation>
    </message>
    <message>
        <source>Image %1 has another size than the first</source>
        <translation>La imatge %1 té una mida diferent de la primera</translation>
    </message>
    <message>
        <source>Image %1 has grey values that are no numbers</source>
        <translation>La imatge %1 té nivells de gris que no són nombres</translation>
    </message>
    <message>
        <source>One labelled phase is too few for the motion between two</source>
        <translation>Una fase etiquetada és massa poc per al moviment entre dues</translation>
    </message>
    <message>
        <source>label the end of diastole and the end of systole</source>
        <translation>etiqueteu el final de la diàstole i el final de la sístole</translation>
    </message>
    <message>
        <source>phases are 0 to %1</source>
        <translation>les fases van de 0 a %1</translation>
    </message>
    <message>
        <source>Phase %1 has labels twice</source>
        <translation>La fase %1 està etiquetada dues vegades</translation>
    </message>
    <message>
        <source>name each phase once</source>
        <translation>anomeneu cada fase una sola vegada</translation>
    </message>
    <message>
        <source>following the tissue</source>
        <translation>seguint el teixit</translation>
    </message>
    <message>
        <source>fitting the images</source>
        <translation>ajustant a les imatges</translation>
    </message>
    <message>
        <source>Terminal crest</source>
        <translation>Cresta terminal</translation>
    </message>
    <message>
        <source>From one labelled phase only a whole cycle can be followed</source>
        <translation>A partir d&apos;una sola fase etiquetada només es pot seguir un cicle complet</translation>
    </message>
    <message>
        <source>label the last phase as well</source>
        <translation>etiqueteu també l&apos;última fase</translation>
    </message>
    <message>
        <source>No phase has labels</source>
        <translation>Cap fase no té etiquetes</translation>
    </message>
    <message>
        <source>give those of the ends of diastole and systole, as in --phase 0=ed.nrrd --phase 9=es.nrrd</source>
        <translation>indiqueu les del final de la diàstole i de la sístole, com a --phase 0=ed.nrrd --phase 9=es.nrrd</translation>
    </message>
    <message>
        <source>The images have no phase %1</source>
        <translation>Les imatges no tenen la fase %1</translation>
    </message>
    <message>
        <source>their phases are 0 to %1</source>
        <translation>les seves fases van de 0 a %1</translation>
    </message>
    <message>
        <source>reading the images</source>
        <translation>llegint les imatges</translation>
    </message>
    <message>
        <source>The images have no series %1</source>
        <translation>Les imatges no tenen la sèrie %1</translation>
    </message>
    <message>
        <source>viscera info lists the series of a study</source>
        <translation>viscera info enumera les sèries d&apos;un estudi</translation>
    </message>
    <message>
        <source>No image shows what is labelled: the labels seem to be in RAS where the images are in LPS</source>
        <translation>Cap imatge no mostra el que s&apos;ha etiquetat: les etiquetes semblen en RAS i les imatges en LPS</translation>
    </message>
    <message>
        <source>No image shows what is labelled: it lies beside all planes, or outside their pictures</source>
        <translation>Cap imatge no mostra el que s&apos;ha etiquetat: queda al costat de tots els plans o fora de les seves imatges</translation>
    </message>
    <message>
        <source>take labels and images of one patient and one study, in the same axes</source>
        <translation>useu etiquetes i imatges d&apos;un mateix pacient i estudi, en els mateixos eixos</translation>
    </message>
    <message numerus="yes">
        <source>%n {plane|planes} of the study {does|do} not cross what is labelled</source>
        <translation>
            <numerusform>%n pla de l&apos;estudi no talla el que s&apos;ha etiquetat</numerusform>
            <numerusform>%n plans de l&apos;estudi no tallen el que s&apos;ha etiquetat</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} nearer than 4 mm to the one before {is|are} not used</source>
        <translation>
            <numerusform>%n tall a menys de 4 mm de l&apos;anterior no s&apos;usa</numerusform>
            <numerusform>%n talls a menys de 4 mm de l&apos;anterior no s&apos;usen</numerusform>
        </translation>
    </message>
    <message>
        <source>Phase %1 has no labels</source>
        <translation>La fase %1 no té etiquetes</translation>
    </message>
    <message>
        <source>as in --phase 0=ed.nrrd</source>
        <translation>com a --phase 0=ed.nrrd</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; is missing in phase %2</source>
        <translation>La superfície «%1» falta a la fase %2</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; has %2 files in phase %3</source>
        <translation>La superfície «%1» té %2 fitxers a la fase %3</translation>
    </message>
    <message>
        <source>name a surface alike in all phases, as in ed/LV.obj and es/LV.obj</source>
        <translation>doneu a una superfície el mateix nom en totes les fases, com ed/LV.obj i es/LV.obj</translation>
    </message>
    <message>
        <source>give labels of one kind for all phases</source>
        <translation>indiqueu etiquetes d&apos;un mateix tipus per a totes les fases</translation>
    </message>
    <message>
        <source>A phase has several label maps</source>
        <translation>Una fase té diversos mapes d&apos;etiquetes</translation>
    </message>
    <message>
        <source>give one file for each phase</source>
        <translation>indiqueu un fitxer per fase</translation>
    </message>
    <message>
        <source>it shows no wall that could be followed</source>
        <translation>no mostra cap paret que es pugui seguir</translation>
    </message>
    <message>
        <source>its tissue leaves the plane: it arrives %1 mm from the next label</source>
        <translation>el seu teixit surt del pla: arriba a %1 mm de l&apos;etiqueta següent</translation>
    </message>
    <message>
        <source>its images are hardly alike around the wall</source>
        <translation>les seves imatges gairebé no s&apos;assemblen al voltant de la paret</translation>
    </message>
    <message>
        <source>it has no image of %1 of %2 phases</source>
        <translation>no té imatge de %1 de %2 fases</translation>
    </message>
    <message>
        <source>only phase %1 has labels: volumes and ejection fraction are estimates, and usually too small a motion; label the end of systole too</source>
        <translation>només la fase %1 té etiquetes: els volums i la fracció d&apos;ejecció són estimacions, d&apos;un moviment en general massa petit; etiqueteu també el final de la sístole</translation>
    </message>
    <message>
        <source>the images show phase %1 emptier than the labelled end of systole, phase %2, by %3 ml: label that phase</source>
        <translation>les imatges mostren la fase %1 més buida, en %3 ml, que el final de la sístole etiquetat, fase %2: etiqueteu aquella fase</translation>
    </message>
    <message>
        <source>the images show phase %1 fuller than the labelled end of diastole, phase %2, by %3 ml: label that phase</source>
        <translation>les imatges mostren la fase %1 més plena, en %3 ml, que el final de la diàstole etiquetat, fase %2: etiqueteu aquella fase</translation>
    </message>
    <message>
        <source>planes of one direction only: what moves across them, such as the base, follows its neighbours</source>
        <translation>plans d&apos;una sola direcció: el que es mou a través d&apos;ells, com la base, segueix els seus veïns</translation>
    </message>
    <message>
        <source>no image shows a wall: its pose lies between those of the labels</source>
        <translation>cap imatge no mostra una paret: la posa és entre les de les etiquetes</translation>
    </message>
    <message>
        <source>the images hardly show how the wall moved</source>
        <translation>les imatges gairebé no mostren com s&apos;ha mogut la paret</translation>
    </message>
    <message>
        <source>the tissue in the images is %1 mm from the surfaces on average</source>
        <translation>el teixit de les imatges és de mitjana a %1 mm de les superfícies</translation>
    </message>
    <message>
        <source>the tissue would have folded: it stays nearer to the pose between the labels</source>
        <translation>el teixit s&apos;hauria plegat: queda més a prop de la posa entre les etiquetes</translation>
    </message>
    <message>
        <source>the tissue has %1 ml, in the labelled phases %2 to %3 ml</source>
        <translation>el teixit té %1 ml, a les fases etiquetades de %2 a %3 ml</translation>
    </message>
    <message>
        <source>%1 % of what is labelled in the plane of %2 lies outside its images</source>
        <translation>El %1 % del que s&apos;ha etiquetat en el pla de %2 queda fora de les seves imatges</translation>
    </message>
    <message>
        <source>series %1, %2</source>
        <translation>sèrie %1, %2</translation>
    </message>
    <message>
        <source>slice %1, %2</source>
        <translation>tall %1, %2</translation>
    </message>
    <message>
        <source>Open study %1</source>
        <translation>Obre l&apos;estudi %1</translation>
    </message>
    <message>
        <source>Close study</source>
        <translation>Tanca l&apos;estudi</translation>
    </message>
    <message>
        <source>There is no study to close</source>
        <translation>No hi ha cap estudi per tancar</translation>
    </message>
    <message>
        <source>the study %1 is not there any more (put it beside the session and open that again)</source>
        <translation>l&apos;estudi %1 ja no hi és (poseu-lo al costat de la sessió i torneu-la a obrir)</translation>
    </message>
    <message>
        <source>the study cannot be opened: %1</source>
        <translation>no es pot obrir l&apos;estudi: %1</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudi</translation>
    </message>
    <message>
        <source>The picture of this phase is missing</source>
        <translation>Falta la imatge d&apos;aquesta fase</translation>
    </message>
    <message>
        <source>The picture of this phase cannot be read</source>
        <translation>No es pot llegir la imatge d&apos;aquesta fase</translation>
    </message>
    <message>
        <source>phase %1 of %2</source>
        <translation>fase %1 de %2</translation>
    </message>
    <message>
        <source>A body surface needs a height of 30 to 250 cm and a weight of 1 to 400 kg</source>
        <translation>Una superfície corporal necessita una alçada de 30 a 250 cm i un pes d&apos;1 a 400 kg</translation>
    </message>
    <message>
        <source>Per m2 of body surface</source>
        <translation>Per m2 de superfície corporal</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Apex of the left ventricle&apos;s cavity</source>
        <translation>Àpex de la cavitat del ventricle esquerre</translation>
    </message>
    <message>
        <source>Apex of the right ventricle&apos;s cavity</source>
        <translation>Àpex de la cavitat del ventricle dret</translation>
    </message>
    <message>
        <source>Dome of the liver</source>
        <translation>Cúpula del fetge</translation>
    </message>
    <message>
        <source>Lower edge of the liver</source>
        <translation>Vora inferior del fetge</translation>
    </message>
    <message>
        <source>Lower edge of the spleen</source>
        <translation>Vora inferior de la melsa</translation>
    </message>
    <message>
        <source>Lowest point of the stomach</source>
        <translation>Punt més baix de l&apos;estómac</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Creació del fantoma</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Upper pole of the left kidney</source>
        <translation>Pol superior del ronyó esquerre</translation>
    </message>
    <message>
        <source>Upper pole of the right kidney</source>
        <translation>Pol superior del ronyó dret</translation>
    </message>
    <message>
        <source>left atrium</source>
        <translation>aurícula esquerra</translation>
    </message>
    <message>
        <source>right atrium</source>
        <translation>aurícula dreta</translation>
    </message>
    <message>
        <source>left kidney</source>
        <translation>ronyó esquerre</translation>
    </message>
    <message>
        <source>right kidney</source>
        <translation>ronyó dret</translation>
    </message>
    <message>
        <source>left lung</source>
        <translation>pulmó esquerre</translation>
    </message>
    <message>
        <source>right lung</source>
        <translation>pulmó dret</translation>
    </message>
    <message>
        <source>right ventricle</source>
        <translation>ventricle dret</translation>
    </message>
    <message>
        <source>the deviation of the noise</source>
        <translation>la desviació del soroll</translation>
    </message>
    <message>
        <source>the ejection fraction</source>
        <translation>la fracció d&apos;ejecció</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>no es pot crear la carpeta</translation>
    </message>
    <message>
        <source>the gap between slices</source>
        <translation>la separació entre els talls</translation>
    </message>
    <message>
        <source>the heart rate</source>
        <translation>la freqüència cardíaca</translation>
    </message>
    <message>
        <source>the number of phases</source>
        <translation>el nombre de fases</translation>
    </message>
    <message>
        <source>the number of slices</source>
        <translation>el nombre de talls</translation>
    </message>
    <message>
        <source>the rate of breathing</source>
        <translation>la freqüència respiratòria</translation>
    </message>
    <message>
        <source>the shift of the slices</source>
        <translation>el desplaçament dels talls</translation>
    </message>
    <message>
        <source>the spacing</source>
        <translation>l&apos;espaiat</translation>
    </message>
    <message>
        <source>the spacing of the fields</source>
        <translation>l&apos;espaiat dels camps</translation>
    </message>
    <message>
        <source>viscera phantom</source>
        <translation>fantoma Viscera</translation>
    </message>
    <message>
        <source>Choose the images first</source>
        <translation>Trieu primer les imatges</translation>
    </message>
    <message>
        <source>Choose the labels of a phase: those of the ends of diastole and systole, where there are any</source>
        <translation>Trieu les etiquetes d&apos;una fase: les dels finals de diàstole i sístole, si n&apos;hi ha</translation>
    </message>
    <message>
        <source>Enter the phase of %1</source>
        <translation>Indiqueu la fase de %1</translation>
    </message>
    <message>
        <source>The images have %1 phases: enter another one for %2</source>
        <translation>Les imatges tenen %1 fases: indiqueu-ne una altra per a %2</translation>
    </message>
    <message>
        <source>%1 and %2 are both labels of phase %3</source>
        <translation>%1 i %2 són totes dues etiquetes de la fase %3</translation>
    </message>
    <message>
        <source>Only phase %1 has labels: the motion, its volumes and ejection fractions will be estimates. Label the end of systole too, if you can</source>
        <translation>Només la fase %1 té etiquetes: el moviment, els seus volums i les seves fraccions d&apos;ejecció seran estimacions. Etiqueteu també el final de la sístole, si podeu</translation>
    </message>
    <message>
        <source>The images differ most from the first phase in phase %1, which has no labels: see whether the end of systole is labelled</source>
        <translation>Les imatges difereixen més de la primera fase a la fase %1, que no té etiquetes: comproveu si el final de la sístole està etiquetat</translation>
    </message>
    <message>
        <source>weight %1 %</source>
        <translation>pes %1 %</translation>
    </message>
    <message>
        <source>left its plane by %1 mm, %2</source>
        <translation>ha sortit del seu pla %1 mm, %2</translation>
    </message>
    <message>
        <source>hardly alike, %1</source>
        <translation>gairebé no s&apos;assemblen, %1</translation>
    </message>
    <message>
        <source>shows no wall</source>
        <translation>no mostra paret</translation>
    </message>
    <message>
        <source>no image</source>
        <translation>sense imatge</translation>
    </message>
    <message>
        <source>labelled</source>
        <translation>etiquetada</translation>
    </message>
    <message>
        <source>their phases are %1 to %2</source>
        <translation>les seves fases són de %1 a %2</translation>
    </message>
    <message>
        <source>its volumes over the beat and its ejection fraction are estimates: only phase %1 has labels</source>
        <translation>els seus volums durant el batec i la seva fracció d&apos;ejecció són estimacions: només la fase %1 té etiquetes</translation>
    </message>
    <message>
        <source>Correct contours</source>
        <translation>Corregeix els contorns</translation>
    </message>
    <message>
        <source>%1, correction of phase %2</source>
        <translation>%1, correcció de la fase %2</translation>
    </message>
    <message>
        <source>correction of phase %1</source>
        <translation>correcció de la fase %1</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only, since the tissue would fold</source>
        <translation>fase %1: el contorn corregit de %2 només s&apos;assoleix amb un error de %3 mm, ja que el teixit es plegaria</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only: the handles are too far apart for its shape</source>
        <translation>fase %1: el contorn corregit de %2 només s&apos;assoleix amb un error de %3 mm: les nanses són massa lluny per a la seva forma</translation>
    </message>
    <message>
        <source>The images have no slice %1</source>
        <translation>Les imatges no tenen el tall %1</translation>
    </message>
    <message>
        <source>their slices are 0 to %1</source>
        <translation>els seus talls van de 0 a %1</translation>
    </message>
    <message>
        <source>The corrected contour lies %1 mm beside the plane of %2</source>
        <translation>El contorn corregit és a %1 mm del pla de %2</translation>
    </message>
    <message>
        <source>give points in the plane of one slice, mm in LPS</source>
        <translation>indiqueu punts en el pla d&apos;un tall, mm en LPS</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact: only phases between them are corrected</source>
        <translation>La fase %1 té etiquetes, que són exactes: només es corregeixen les fases intermèdies</translation>
    </message>
    <message>
        <source>change its labels, or leave this correction out</source>
        <translation>canvieu-ne les etiquetes o ometeu aquesta correcció</translation>
    </message>
    <message>
        <source>A corrected contour has no points</source>
        <translation>Un contorn corregit no té punts</translation>
    </message>
    <message>
        <source>give three numbers for each of them, mm</source>
        <translation>indiqueu tres nombres per a cadascun, mm</translation>
    </message>
    <message>
        <source>The handles are no longer those of the motion that was found in the images</source>
        <translation>Les nanses ja no són les del moviment trobat en les imatges</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the handles</source>
        <translation>torneu a cercar el moviment o desfeu el canvi de les nanses</translation>
    </message>
    <message>
        <source>There is no key at phase %1 any more</source>
        <translation>Ja no hi ha cap clau a la fase %1</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the keys</source>
        <translation>torneu a cercar el moviment o desfeu el canvi de les claus</translation>
    </message>
    <message>
        <source>It has no points, or is of no surface that is fitted</source>
        <translation>No té punts o no és de cap superfície ajustada</translation>
    </message>
    <message>
        <source>give the points of a contour</source>
        <translation>indiqueu els punts d&apos;un contorn</translation>
    </message>
    <message>
        <source>Phase %1 does not lie between labelled phases</source>
        <translation>La fase %1 no és entre fases amb etiquetes</translation>
    </message>
    <message>
        <source>correct a phase that the images are fitted in</source>
        <translation>corregiu una fase que s&apos;ajusti a les imatges</translation>
    </message>
    <message>
        <source>meeting corrected contours</source>
        <translation>ajust als contorns corregits</translation>
    </message>
    <message>
        <source>The %1 is damaged and left out: %2</source>
        <translation>Malmesa i omesa: %1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n more {phase is|phases are} damaged and left out</source>
        <translation>
            <numerusform>%n fase més està malmesa i s&apos;ha omès</numerusform>
            <numerusform>%n fases més estan malmeses i s&apos;han omès</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 x %2 x %3 voxels, others %4 x %5 x %6</source>
        <translation>té %1 x %2 x %3 vòxels, altres %4 x %5 x %6</translation>
    </message>
    <message>
        <source>phase %1 %</source>
        <translation>fase %1 %</translation>
    </message>
    <message>
        <source>The %1 shows the same instant as the %2, and is left out</source>
        <translation>%1 mostra el mateix instant que %2 i s&apos;omet</translation>
    </message>
    <message>
        <source>Its phases are kept as 16 bits a voxel, to a 65,000th of their range</source>
        <translation>Les seves fases es guarden amb 16 bits per vòxel, a una 65.000a part del seu interval</translation>
    </message>
    <message>
        <source>Its phases need %1 GB, of which %2 GB are kept at a time; the others are read again when they are shown</source>
        <translation>Les seves fases necessiten %1 GB, dels quals se&apos;n guarden %2 GB alhora; les altres es tornen a llegir quan es mostren</translation>
    </message>
    <message>
        <source>It is packed, or keeps its phases beside each other, so that each of them is read as slowly as all; save it unpacked to move through it</source>
        <translation>Està comprimit o guarda les fases una al costat de l&apos;altra, de manera que cadascuna es llegeix tan a poc a poc com totes; deseu-lo sense comprimir per recórrer-lo</translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as seconds</source>
        <translation>No indica la unitat dels seus temps; es prenen com a segons</translation>
    </message>
    <message>
        <source>the session holds one phase of this scan; open its file again for the others</source>
        <translation>la sessió conté una fase d&apos;aquest estudi; torneu a obrir-ne el fitxer per a les altres</translation>
    </message>
    <message>
        <source>Series %1 states %2 phases and has %3</source>
        <translation>La sèrie %1 declara %2 fases i en té %3</translation>
    </message>
    <message>
        <source>Series %1: %2</source>
        <translation>Sèrie %1: %2</translation>
    </message>
    <message>
        <source>Series %1 is left out: &quot;%2&quot; %3</source>
        <translation>La sèrie %1 queda fora: «%2» %3</translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of %2 {is|are} empty and left out: %3</source>
        <translation>
            <numerusform>%n imatge de %2 és buida i s&apos;ha omès: %3</numerusform>
            <numerusform>%n imatges de %2 són buides i s&apos;han omès: %3</numerusform>
        </translation>
    </message>
    <message>
        <source>free handles cannot follow: these coordinates are not linear in the handles</source>
        <translation>els tiradors lliures no poden seguir: aquestes coordenades no són lineals en els tiradors</translation>
    </message>
    <message>
        <source>choose another coordinate system</source>
        <translation>trieu un altre sistema de coordenades</translation>
    </message>
    <message>
        <source>free handles cannot follow: there is no witness point in the tissue</source>
        <translation>els tiradors lliures no poden seguir: no hi ha cap punt testimoni al teixit</translation>
    </message>
    <message>
        <source>place the handles around an organ that encloses a volume</source>
        <translation>col·loqueu els tiradors al voltant d&apos;un òrgan que tanqui un volum</translation>
    </message>
    <message>
        <source>unlock it, or move the handles less far</source>
        <translation>desbloquegeu-lo, o moveu menys els tiradors</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Tensió de von Mises</translation>
    </message>
    <message>
        <source>Maximum von Mises stress</source>
        <translation>Tensió de von Mises màxima</translation>
    </message>
    <message>
        <source>The stress that shears the tissue, if it is the stated material; the change of its volume has no part in it.</source>
        <translation>La tensió que cisalla el teixit, si és del material indicat; el canvi del seu volum no hi intervé.</translation>
    </message>
    <message>
        <source>Strain energy density</source>
        <translation>Densitat d&apos;energia de deformació</translation>
    </message>
    <message>
        <source>Maximum strain energy density</source>
        <translation>Densitat d&apos;energia de deformació màxima</translation>
    </message>
    <message>
        <source>The energy for each volume at rest, if the tissue is the stated material; with what the change of its volume takes.</source>
        <translation>L&apos;energia per volum en repòs, si el teixit és del material indicat; amb el que costa el canvi del seu volum.</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>E %1 kPa</source>
        <translation>E %1 kPa</translation>
    </message>
    <message>
        <source>%1 (E %2 kPa)</source>
        <translation>%1 (E %2 kPa)</translation>
    </message>
    <message>
        <source>myocardium</source>
        <translation>miocardi</translation>
    </message>
    <message>
        <source>kidney</source>
        <translation>ronyó</translation>
    </message>
    <message>
        <source>spleen</source>
        <translation>melsa</translation>
    </message>
    <message>
        <source>pancreas</source>
        <translation>pàncrees</translation>
    </message>
    <message>
        <source>Pascals are of a stated material: %1.</source>
        <translation>Els pascals són d&apos;un material indicat: %1.</translation>
    </message>
    <message>
        <source>Interventricular septum</source>
        <translation>Septe interventricular</translation>
    </message>
    <message>
        <source>Interatrial septum</source>
        <translation>Septe interauricular</translation>
    </message>
    <message>
        <source>Oval fossa</source>
        <translation>Fossa oval</translation>
    </message>
    <message>
        <source>Opening of the coronary sinus</source>
        <translation>Orifici del si coronari</translation>
    </message>
    <message>
        <source>Valve of the coronary sinus</source>
        <translation>Vàlvula del si coronari</translation>
    </message>
    <message>
        <source>the limit of Doppler ultrasound, which no study of its own gives; measured by catheter since Gleason and Braunwald 1962, doi 10.1172/JCI104469</source>
        <translation>límit de l’ecografia Doppler, que cap estudi propi no dona; mesurat amb catèter des de Gleason i Braunwald 1962, doi 10.1172/JCI104469</translation>
    </message>
    <message>
        <source>customary; how much people at rest differ: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</source>
        <translation>habitual; com difereixen les persones en repòs: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</translation>
    </message>
    <message numerus="yes">
        <source>%n {point or open contour was|points and open contours were} left out</source>
        <translation>
            <numerusform>s&apos;ha omès %n punt o contorn obert</numerusform>
            <numerusform>s&apos;han omès %n punts i contorns oberts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was|contours were} left out, whose numbers cannot be read</source>
        <translation>
            <numerusform>s&apos;ha omès %n contorn els nombres del qual no es poden llegir</numerusform>
            <numerusform>s&apos;han omès %n contorns els nombres dels quals no es poden llegir</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was left out, which lies|contours were left out, which lie} in another direction than most</source>
        <translation>
            <numerusform>s&apos;ha omès %n contorn que és en una altra direcció que la majoria</numerusform>
            <numerusform>s&apos;han omès %n contorns que són en una altra direcció que la majoria</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {region was left out, which is|regions were left out, which are} in another coordinate system (frame of reference)</source>
        <translation>
            <numerusform>s&apos;ha omès %n regió d&apos;un altre sistema de coordenades (frame of reference)</numerusform>
            <numerusform>s&apos;han omès %n regions d&apos;un altre sistema de coordenades (frame of reference)</numerusform>
        </translation>
    </message>
    <message>
        <source>all contours lie in one plane, whose thickness is not stated; %1 mm were taken</source>
        <translation>tots els contorns són en un pla el gruix del qual no s&apos;indica; s&apos;han pres %1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of %2 without a contour got the shape between their neighbours</source>
        <translation>
            <numerusform>%n tall de %2 sense contorn ha rebut la forma entre els seus veïns</numerusform>
            <numerusform>%n talls de %2 sense contorn han rebut la forma entre els seus veïns</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no contour over %2 mm; that gap stays open</source>
        <translation>%1 no té contorn en %2 mm; aquest buit queda obert</translation>
    </message>
    <message>
        <source>It is a structure set without regions of interest</source>
        <translation>És un structure set sense regions</translation>
    </message>
    <message>
        <source>export the contours again</source>
        <translation>exporteu de nou els contorns</translation>
    </message>
    <message>
        <source>It is a structure set without closed contours, so that there is no organ in it</source>
        <translation>És un structure set sense contorns tancats, de manera que no conté cap òrgan</translation>
    </message>
    <message>
        <source>export the structures as closed planar contours</source>
        <translation>exporteu les estructures com a contorns plans tancats</translation>
    </message>
    <message>
        <source>No voxel of the grid lies within the organ</source>
        <translation>Cap vòxel de la graella és dins de l&apos;òrgan</translation>
    </message>
    <message>
        <source>choose the scan that shows it, or smaller voxels</source>
        <translation>trieu l&apos;estudi que el mostra, o vòxels més petits</translation>
    </message>
    <message>
        <source>choose the scan that shows it</source>
        <translation>trieu l&apos;estudi que el mostra</translation>
    </message>
    <message>
        <source>There are fewer than two images to lay a segmentation on</source>
        <translation>Hi ha menys de dues imatges sobre les quals posar una segmentació</translation>
    </message>
    <message>
        <source>choose a series of slices</source>
        <translation>trieu una sèrie de talls</translation>
    </message>
    <message>
        <source>The images lie at unequal distances, so that they have no grid</source>
        <translation>Les imatges són a distàncies desiguals, de manera que no tenen graella</translation>
    </message>
    <message>
        <source>write the segmentation on a grid of its own</source>
        <translation>escriviu la segmentació en una graella pròpia</translation>
    </message>
    <message>
        <source>The size of voxels has to be positive</source>
        <translation>La mida dels vòxels ha de ser positiva</translation>
    </message>
    <message>
        <source>The organs are too large for voxels of that size</source>
        <translation>Els òrgans són massa grans per a vòxels d&apos;aquesta mida</translation>
    </message>
    <message>
        <source>choose larger voxels</source>
        <translation>trieu vòxels més grans</translation>
    </message>
    <message>
        <source>No image of the scan crosses the organ</source>
        <translation>Cap imatge de l&apos;estudi talla l&apos;òrgan</translation>
    </message>
    <message>
        <source>Contours need the images whose planes they lie in</source>
        <translation>Els contorns necessiten les imatges en els plans de les quals són</translation>
    </message>
    <message>
        <source>open the DICOM scan of the organs, or write a segmentation</source>
        <translation>obriu l&apos;estudi DICOM dels òrgans, o escriviu una segmentació</translation>
    </message>
    <message>
        <source>It is no PDF document</source>
        <translation>No és un document PDF</translation>
    </message>
    <message>
        <source>There is no DICOM image whose patient and study could be taken</source>
        <translation>No hi ha cap imatge DICOM de la qual prendre el pacient i l&apos;estudi</translation>
    </message>
    <message>
        <source>name the folder of the images that the organs were made from</source>
        <translation>indiqueu la carpeta de les imatges de les quals es van fer els òrgans</translation>
    </message>
    <message>
        <source>It has no measurement</source>
        <translation>No té cap mesura</translation>
    </message>
    <message>
        <source>Its segment is named without the segmentation</source>
        <translation>El seu segment s&apos;anomena sense la segmentació</translation>
    </message>
    <message>
        <source>write the segmentation too</source>
        <translation>escriviu també la segmentació</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>exporteu-lo o copieu-lo de nou</translation>
    </message>
    <message>
        <source>key sequence</source>
        <translation>seqüència de fotogrames clau</translation>
    </message>
    <message>
        <source>as in %1</source>
        <translation>com a %1</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Corregeix el contorn</translation>
    </message>
    <message>
        <source>It is a segmentation over time: its frames show several phases at one place</source>
        <translation>És una segmentació en el temps: les seves imatges mostren diverses fases en un mateix lloc</translation>
    </message>
    <message>
        <source>The archive %1 cannot be reached</source>
        <translation>No es pot accedir a l&apos;arxiu %1</translation>
    </message>
    <message>
        <source>Check its address and port, and whether it runs</source>
        <translation>Comproveu-ne l&apos;adreça i el port, i si funciona</translation>
    </message>
    <message>
        <source>The archive %1 does not answer</source>
        <translation>L&apos;arxiu %1 no respon</translation>
    </message>
    <message>
        <source>Try again; the archive or the network may be slow</source>
        <translation>Torneu-ho a provar; l&apos;arxiu o la xarxa poden ser lents</translation>
    </message>
    <message>
        <source>The archive %1 refuses the titles: it is called %2, and this program %3</source>
        <translation>L&apos;arxiu %1 rebutja els títols: se l&apos;anomena %2, i aquest programa %3</translation>
    </message>
    <message>
        <source>Ask its administrator for its title, and to allow that of this program</source>
        <translation>Demaneu-ne el títol a l&apos;administrador, i que permeti el d&apos;aquest programa</translation>
    </message>
    <message>
        <source>The archive %1 refuses the user name or the password</source>
        <translation>L&apos;arxiu %1 rebutja l&apos;usuari o la contrasenya</translation>
    </message>
    <message>
        <source>Type both again</source>
        <translation>Torneu-los a escriure</translation>
    </message>
    <message>
        <source>The certificate of the archive %1 is not trusted</source>
        <translation>El certificat de l&apos;arxiu %1 no és de confiança</translation>
    </message>
    <message>
        <source>Name the file with its issuer&apos;s certificate in the connection</source>
        <translation>Indiqueu a la connexió el fitxer amb el certificat del seu emissor</translation>
    </message>
    <message>
        <source>The connection to the archive %1 was cut</source>
        <translation>S&apos;ha tallat la connexió amb l&apos;arxiu %1</translation>
    </message>
    <message>
        <source>Try again; nothing incomplete is kept</source>
        <translation>Torneu-ho a provar; no es guarda res incomplet</translation>
    </message>
    <message>
        <source>The answer of the archive %1 is not DICOM</source>
        <translation>La resposta de l&apos;arxiu %1 no és DICOM</translation>
    </message>
    <message>
        <source>Check its address</source>
        <translation>Comproveu-ne l&apos;adreça</translation>
    </message>
    <message>
        <source>The archive %1 refuses: %2</source>
        <translation>L&apos;arxiu %1 rebutja: %2</translation>
    </message>
    <message>
        <source>Ask its administrator</source>
        <translation>Pregunteu a l&apos;administrador</translation>
    </message>
    <message>
        <source>The archive %1 does not offer %2</source>
        <translation>L&apos;arxiu %1 no ofereix %2</translation>
    </message>
    <message>
        <source>The archive %1 has not kept %2 of %3 files</source>
        <translation>L&apos;arxiu %1 no ha desat %2 de %3 fitxers</translation>
    </message>
    <message>
        <source>The archive %1 has no such series</source>
        <translation>L&apos;arxiu %1 no té aquesta sèrie</translation>
    </message>
    <message>
        <source>What was received cannot be written</source>
        <translation>No es pot escriure el que s&apos;ha rebut</translation>
    </message>
    <message>
        <source>Is the disk full?</source>
        <translation>El disc és ple?</translation>
    </message>
    <message>
        <source>Ask the archive %1</source>
        <translation>Consultar l&apos;arxiu %1</translation>
    </message>
    <message>
        <source>Receive image %1</source>
        <translation>Rebre la imatge %1</translation>
    </message>
    <message>
        <source>Send image %1</source>
        <translation>Enviar la imatge %1</translation>
    </message>
    <message>
        <source>The folder is there already</source>
        <translation>La carpeta ja existeix</translation>
    </message>
    <message>
        <source>The folder cannot be made</source>
        <translation>No es pot crear la carpeta</translation>
    </message>
    <message>
        <source>The file is no DICOM file</source>
        <translation>El fitxer no és DICOM</translation>
    </message>
    <message>
        <source>The certificates cannot be read</source>
        <translation>No es poden llegir els certificats</translation>
    </message>
    <message>
        <source>It is no list of archives</source>
        <translation>No és una llista d&apos;arxius</translation>
    </message>
    <message>
        <source>this service</source>
        <translation>aquest servei</translation>
    </message>
    <message>
        <source>The address of the archive %1 is not known to the network</source>
        <translation>La xarxa no coneix l&apos;adreça de l&apos;arxiu %1</translation>
    </message>
    <message>
        <source>Check how its address is spelt</source>
        <translation>Comproveu com està escrita l&apos;adreça</translation>
    </message>
    <message>
        <source>There is no secure connection (TLS) to the archive %1</source>
        <translation>No hi ha connexió segura (TLS) amb l&apos;arxiu %1</translation>
    </message>
    <message>
        <source>Ask its administrator whether this port takes TLS, and of which version</source>
        <translation>Pregunteu al seu administrador si aquest port admet TLS, i de quina versió</translation>
    </message>
    <message>
        <source>the images are not there any more (the archive %1 has them)</source>
        <translation>les imatges ja no hi són (l&apos;arxiu %1 les té)</translation>
    </message>
    <message>
        <source>There is no key ring that keeps the password</source>
        <translation>No hi ha cap anell de claus que desi la contrasenya</translation>
    </message>
    <message>
        <source>it counts little in %1 of %2 phases, in which its tissue leaves the plane or its images are unlike</source>
        <translation>compta poc en %1 de %2 fases, en què el seu teixit surt del pla o les seves imatges no s&apos;assemblen</translation>
    </message>
    <message>
        <source>%1 is left out: its surface is open</source>
        <translation>%1 s&apos;omet: la superfície és oberta</translation>
    </message>
    <message>
        <source>the scan&apos;s DICOM files are not there: the objects get a study of their own</source>
        <translation>els fitxers DICOM de la imatge no hi són: els objectes reben un estudi propi</translation>
    </message>
    <message>
        <source>The report names the patient or the files, and identity is to be removed</source>
        <translation>L&apos;informe anomena el pacient o els fitxers, i cal treure&apos;n la identitat</translation>
    </message>
    <message>
        <source>leave the report out, or make one without the patient</source>
        <translation>deixeu fora l’informe o feu-ne un sense el pacient</translation>
    </message>
    <message>
        <source>The report holds the patient&apos;s name or number</source>
        <translation>L&apos;informe conté el nom o el número del pacient</translation>
    </message>
    <message>
        <source>leave the report out</source>
        <translation>deixeu fora l&apos;informe</translation>
    </message>
    <message>
        <source>No DICOM object is chosen</source>
        <translation>No s&apos;ha triat cap objecte DICOM</translation>
    </message>
    <message>
        <source>choose one at least</source>
        <translation>trieu-ne almenys un</translation>
    </message>
    <message>
        <source>There is no organ to write</source>
        <translation>No hi ha cap òrgan per escriure</translation>
    </message>
    <message>
        <source>There is no organ with a closed surface to write as DICOM</source>
        <translation>No hi ha cap òrgan de superfície tancada per escriure com a DICOM</translation>
    </message>
    <message>
        <source>close it first</source>
        <translation>tanqueu-la primer</translation>
    </message>
    <message>
        <source>The number of phases is 0 to 200</source>
        <translation>El nombre de fases és de 0 a 200</translation>
    </message>
    <message>
        <source>the file is there already</source>
        <translation>el fitxer ja existeix</translation>
    </message>
    <message>
        <source>choose an empty folder</source>
        <translation>trieu una carpeta buida</translation>
    </message>
    <message>
        <source>there is no such series</source>
        <translation>no existeix aquesta sèrie</translation>
    </message>
    <message>
        <source>one mesh says nothing about the others</source>
        <translation>una malla no diu res de les altres</translation>
    </message>
    <message>
        <source>give two sizes at least</source>
        <translation>indiqueu almenys dues mides</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or export a segmentation of each phase</source>
        <translation>seguiu el moviment per totes amb viscera track %1, o exporteu una segmentació de cada fase</translation>
    </message>
</context>
<context>
    <name>viscera::app</name>
    <message>
        <source>Choose...</source>
        <translation>Tria...</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporta</translation>
    </message>
    <message>
        <source>Fetching from %1</source>
        <translation>S&apos;està obtenint de %1</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>%1 (estimate)</source>
        <translation>%1 (estimació)</translation>
    </message>
    <message>
        <source>Planes of the images</source>
        <translation>Plans de les imatges</translation>
    </message>
    <message>
        <source>Cine study</source>
        <translation>Estudi cine</translation>
    </message>
    <message>
        <source>Use the sequence&apos;s handles</source>
        <translation>Fes servir els tiradors de la seqüència</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfés</translation>
    </message>
    <message>
        <source>Circulation</source>
        <translation>Circulació</translation>
    </message>
    <message>
        <source>Sample %1</source>
        <translation>Mostra: %1</translation>
    </message>
    <message>
        <source>Organs (%1)</source>
        <translation>Òrgans (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Prescribe a volume</source>
        <translation>Prescriu un volum</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profunditat</translation>
    </message>
    <message>
        <source>Cut away the front</source>
        <translation>Retalla la part anterior</translation>
    </message>
    <message>
        <source>Cut away the upper part</source>
        <translation>Retalla la part superior</translation>
    </message>
    <message>
        <source>Facing the viewer</source>
        <translation>De cara a l’observador</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Deforma</translation>
    </message>
    <message numerus="yes">
        <source>%n handles</source>
        <translation>
            <numerusform>%n tirador</numerusform>
            <numerusform>%n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volum</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplica</translation>
    </message>
    <message>
        <source>Rest error</source>
        <translation>Error en repòs</translation>
    </message>
    <message>
        <source>The largest distance of the bound organ at rest from the original</source>
        <translation>La distància màxima entre l’òrgan vinculat en repòs i l’original</translation>
    </message>
    <message>
        <source>Smallest weight</source>
        <translation>Pes mínim</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Secció</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Mida</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superfície</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valors separats per comes (*.csv)</translation>
    </message>
    <message>
        <source>There is no organ to export. Open one first.</source>
        <translation>No hi ha cap òrgan per exportar. Obriu-ne primer un.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>S’exporta: %1</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>S’ha escrit a %1.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>S’obre %1</translation>
    </message>
    <message>
        <source>Look for files...</source>
        <translation>Cerca els fitxers...</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Place the sequence&apos;s handles around the organ and play it</source>
        <translation>Col·loca els tiradors de la seqüència al voltant de l’òrgan i la reprodueix</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grups</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Color...</translation>
    </message>
    <message numerus="yes">
        <source>Move %n handles</source>
        <translation>
            <numerusform>Mou %n tirador</numerusform>
            <numerusform>Mou %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle %1</source>
        <translation>Mou el tirador %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Tensió</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importa</translation>
    </message>
    <message>
        <source>Duration of one cycle</source>
        <translation>Durada d’un cicle</translation>
    </message>
    <message>
        <source>Export lesson</source>
        <translation>Exporta la lliçó</translation>
    </message>
    <message>
        <source>Motion from a series</source>
        <translation>Moviment a partir d’una sèrie</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Tanca</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ara</translation>
    </message>
    <message>
        <source>before</source>
        <translation>abans</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Tanca (Esc)</translation>
    </message>
    <message>
        <source>Time in the cycle</source>
        <translation>Temps en el cicle</translation>
    </message>
</context>
</TS>
