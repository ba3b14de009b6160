<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ca" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>&quot;%1&quot; is %2 instead of &quot;%3&quot;</source>
        <translation>«%1» és %2 en lloc de «%3»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither true nor false</source>
        <translation>«%1» no és ni cert ni fals</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list</source>
        <translation>«%1» no és una llista</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a text</source>
        <translation>«%1» no és un text</translation>
    </message>
    <message>
        <source>&quot;version&quot; is not a positive whole number</source>
        <translation>«version» no és un nombre enter positiu</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 i %2 més</translation>
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
        <source>%1 is farther away than a thousand kilometres</source>
        <translation>%1 és a més de mil quilòmetres</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 no és un nombre finit</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 de més d’1 GB no cap en un fitxer de sessió</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 files</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 vòxels</translation>
    </message>
    <message>
        <source>%1, %2 of them crumbs of less than 2 % of its area</source>
        <translation>%1, %2 de les quals molles de menys del 2 % de la seva àrea</translation>
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
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1: «%2» és desconegut i no es tornarà a desar</translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; look whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
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
        <source>%n {handle|handles}</source>
        <translation>
            <numerusform>%n tirador</numerusform>
            <numerusform>%n tiradors</numerusform>
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
    <message>
        <source>A cavity has to come after the organ that it is in</source>
        <translation>Una cavitat ha d’anar després de l’òrgan on és</translation>
    </message>
    <message>
        <source>A group names a handle that is not there</source>
        <translation>Un grup anomena un tirador que no hi és</translation>
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
        <source>A rectangle lies in an axial, coronal or sagittal slice</source>
        <translation>Un rectangle és en un tall axial, coronal o sagital</translation>
    </message>
    <message>
        <source>A row has four numbers</source>
        <translation>Una fila té quatre nombres</translation>
    </message>
    <message>
        <source>A scan has three axes</source>
        <translation>Una exploració té tres eixos</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Una sessió s’obre sola</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Un ventricle esquerre rígid que es relaxa lentament: es buida bé i només s’omple a una pressió alta.</translation>
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
        <source>Add group</source>
        <translation>Afegeix un grup</translation>
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
        <source>An angle needs three points, any other measurement two</source>
        <translation>Un angle necessita tres punts, qualsevol altra mesura dos</translation>
    </message>
    <message>
        <source>An organ needs a surface</source>
        <translation>Un òrgan necessita una superfície</translation>
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
        <source>As near to a target as balance allows; what is done about negative numbers can be chosen</source>
        <translation>Tan a prop d’un objectiu com permet l’equilibri; es pot triar què es fa amb els nombres negatius</translation>
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
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Bending the scan</source>
        <translation>Es deforma l’exploració</translation>
    </message>
    <message>
        <source>Bent</source>
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
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not touch its handles</source>
        <translation>Amb els cantons i les normals d’una gàbia de qualsevol forma; gairebé manté els angles, i no toca els tiradors</translation>
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
        <source>Change group</source>
        <translation>Canvia el grup</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Canvia l’aspecte</translation>
    </message>
    <message>
        <source>Change recording</source>
        <translation>Canvia l’enregistrament</translation>
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
        <source>Displacement_mm</source>
        <translation>Displacement_mm</translation>
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
        <translation>Divisions de l’icosaedre: 20 * 4^nivell raigs</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^samples directions</source>
        <translation>Divisions de l’icosaedre: 20 * 4^mostres direccions</translation>
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
        <translation>Arestes de tetraedre entre els tiradors; més és més fi i més lent</translation>
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
        <source>End-systolic and relaxed</source>
        <translation>Telesistòlica i relaxada</translation>
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
        <source>Filling that multiplies the pericardium's pressure by e</source>
        <translation>Ompliment que multiplica per e la pressió del pericardi</translation>
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
        <source>Forget what was before</source>
        <translation>Oblida l’anterior</translation>
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
        <translation>Peristaltisme gàstric</translation>
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
        <source>How positive balanced vectors are found</source>
        <translation>Com es troben vectors equilibrats positius</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Com arriben als tiradors els pesos dels vèrtexs de Voronoi</translation>
    </message>
    <message>
        <source>How the wire connects them</source>
        <translation>Com els uneix el fil</translation>
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
        <source>Influence of %1</source>
        <translation>Influència de %1</translation>
    </message>
    <message>
        <source>Inner handles of each layer</source>
        <translation>Tiradors interns de cada capa</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>No es pot llegir</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Es travessa ella mateixa, en %n parell de triangles</numerusform>
            <numerusform>Es travessa ella mateixa, en %n parells de triangles</numerusform>
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
        <source>It has no &quot;%1&quot;</source>
        <translation>Hi falta «%1»</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>No té la superfície «%1»</translation>
    </message>
    <message>
        <source>It has to be a text</source>
        <translation>Ha de ser un text</translation>
    </message>
    <message>
        <source>It holds less than %1</source>
        <translation>Conté menys de %1</translation>
    </message>
    <message>
        <source>It is a scan and no organ</source>
        <translation>És una exploració i no un òrgan</translation>
    </message>
    <message>
        <source>It is damaged: it does not hold %1</source>
        <translation>Està malmès: no conté %1</translation>
    </message>
    <message>
        <source>It is damaged: its SHA-256 is not %1</source>
        <translation>Està malmès: el seu SHA-256 no és %1</translation>
    </message>
    <message>
        <source>It is neither &quot;embedded&quot; nor &quot;linked&quot;</source>
        <translation>No és ni «embedded» ni «linked»</translation>
    </message>
    <message>
        <source>It is nested too deeply</source>
        <translation>Està niat massa profundament</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>No és un fitxer de tipus %1: el seu «format» no és «%2»</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>No és un fitxer que es pugui llegir</translation>
    </message>
    <message>
        <source>It is not a finite number</source>
        <translation>No és un nombre finit</translation>
    </message>
    <message>
        <source>It is not a list of three numbers</source>
        <translation>No és una llista de tres nombres</translation>
    </message>
    <message>
        <source>It is not a text</source>
        <translation>No és un text</translation>
    </message>
    <message>
        <source>It is not a triangle of three handles</source>
        <translation>No és un triangle de tres tiradors</translation>
    </message>
    <message>
        <source>It is not a whole number from 0 to 2^53</source>
        <translation>No és un nombre enter de 0 a 2^53</translation>
    </message>
    <message>
        <source>It is not an object</source>
        <translation>No és un objecte</translation>
    </message>
    <message>
        <source>It is not base64</source>
        <translation>No és base64</translation>
    </message>
    <message>
        <source>It is not complete JSON: %1</source>
        <translation>No és JSON complet: %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>És de la versió %1; aquest programa llegeix fins a la %2</translation>
    </message>
    <message>
        <source>It is too long</source>
        <translation>És massa llarg</translation>
    </message>
    <message>
        <source>Its axes lie in one plane</source>
        <translation>Els seus eixos són en un pla</translation>
    </message>
    <message>
        <source>Keep as before</source>
        <translation>Guarda com a anterior</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Ronyó</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>Cavitat de l’AE</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>LV cavity</source>
        <translation>Cavitat del VE</translation>
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
        <source>Leak below its</source>
        <translation>Fuita per sota de la seva</translation>
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
        <source>Left atrium, right ventricle</source>
        <translation>Aurícula esquerra, ventricle dret</translation>
    </message>
    <message>
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Aurícula esquerra, escala de la corba relaxada</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
        <translation>Aurícula esquerra, pendent de la corba relaxada</translation>
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
        <translation>Ventricle esquerre, escala de la corba relaxada</translation>
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
        <source>Mean</source>
        <translation>Mitjana</translation>
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
        <translation>Valor mitjà sobre tots els tetraedres dels tiradors alhora, per direccions; positives, amb molts màxims</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Valor mitjà sobre les regions de Voronoi dels tiradors tal com els veu cada punt; salts, o lentes</translation>
    </message>
    <message>
        <source>Mean value over the triangles in which each point sees the handles; jumps, or blended rough</source>
        <translation>Valor mitjà sobre els triangles en què cada punt veu els tiradors; salts, o rugoses si es fusionen</translation>
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
        <translation>Mig del cos</translation>
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
        <source>No scan has %1 voxels along an axis</source>
        <translation>Cap exploració té %1 vòxels al llarg d’un eix</translation>
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
        <source>Of the random numbers</source>
        <translation>Dels nombres aleatoris</translation>
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
        <source>Organ</source>
        <translation>Òrgan</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Altres</translation>
    </message>
    <message>
        <source>PR interval, 0.12 to 0.20 s</source>
        <translation>Interval PR, de 0,12 a 0,20 s</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pàncrees</translation>
    </message>
    <message>
        <source>Peak of %1</source>
        <translation>Pic de: %1</translation>
    </message>
    <message>
        <source>Peak stress</source>
        <translation>Tensió màxima</translation>
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
        <translation>Cavitat de l’AD</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>RV cavity</source>
        <translation>Cavitat del VD</translation>
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
        <source>Remove from group</source>
        <translation>Treu del grup</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Elimina el grup</translation>
    </message>
    <message numerus="yes">
        <source>Remove {handle|%n handles}</source>
        <translation>
            <numerusform>Treu el tirador</numerusform>
            <numerusform>Treu %n tiradors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {key|%n keys}</source>
        <translation>
            <numerusform>Treu la clau</numerusform>
            <numerusform>Treu %n claus</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Treu la mesura</numerusform>
            <numerusform>Treu %n mesures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {organ|%n organs}</source>
        <translation>
            <numerusform>Treu l’òrgan</numerusform>
            <numerusform>Treu %n òrgans</numerusform>
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
        <source>Replace recording</source>
        <translation>Substitueix l’enregistrament</translation>
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
        <translation>Aurícula dreta, escala de la corba relaxada</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
        <translation>Aurícula dreta, pendent de la corba relaxada</translation>
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
        <translation>Ventricle dret, escala de la corba relaxada</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
        <translation>Ventricle dret, pendent de la corba relaxada</translation>
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
        <source>RotationalStress_deg</source>
        <translation>RotationalStress_deg</translation>
    </message>
    <message>
        <source>S-Celestial</source>
        <translation>S-Celestial</translation>
    </message>
    <message>
        <source>Samples a point</source>
        <translation>Mostres per punt</translation>
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
        <source>StretchMax</source>
        <translation>StretchMax</translation>
    </message>
    <message>
        <source>StretchMin</source>
        <translation>StretchMin</translation>
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
        <source>Surfaces are cut by at most 8 planes at once, not by %1</source>
        <translation>Les superfícies es tallen amb 8 plans alhora com a màxim, no amb %1</translation>
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
        <source>Take the cage %1</source>
        <translation>Pren la gàbia %1</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponament</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen no ha posat cap punt dins de la superfície</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>La vàlvula aòrtica s’obre fins a 0,8 cm2: la pressió del ventricle hipertròfic supera de molt la de l’aorta.</translation>
    </message>
    <message>
        <source>The cage names a handle that is not there</source>
        <translation>La gàbia anomena un tirador que no hi és</translation>
    </message>
    <message>
        <source>The centre of all positive answers, by sampling; as good as the number of samples</source>
        <translation>El centre de totes les respostes positives, per mostreig; tan bones com el nombre de mostres</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Les coordenades clàssiques d’una gàbia tancada; positives on la gàbia és convexa</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>El mapa d’etiquetes de %1 té una altra quadrícula (%2) que l’exploració (%3); cadascun és on diu el seu fitxer, i res no es remostreja</translation>
    </message>
    <message>
        <source>The mean over all tetrahedra of handles around a point; jumps where their number changes</source>
        <translation>La mitjana sobre tots els tetraedres de tiradors al voltant d’un punt; salts on en canvia el nombre</translation>
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
        <source>The mitral valve leaks through 0.4 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>La vàlvula mitral té una fuita de 0,4 cm2: la meitat del que ejecta el ventricle torna a l’aurícula.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>El nombre de punts testimoni ha de ser de %1 a %2</translation>
    </message>
    <message>
        <source>The numbers to stay near to</source>
        <translation>Els nombres als quals cal acostar-se</translation>
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
        <source>The points of n-space that the wire connects</source>
        <translation>Els punts de l’espai n-dimensional que uneix el fil</translation>
    </message>
    <message>
        <source>The pose has %1 handles, the document %2</source>
        <translation>La postura té %1 tiradors, el document %2</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>La postura té una posició que no és un nombre finit o és massa lluny</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>La seqüència mou %1 tiradors, però n’hi ha %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>La seqüència es va fer per a una altra posició d’un tirador</translation>
    </message>
    <message>
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>El nombre més petit s’eleva tant com es pot; positives, amb plecs</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>La superfície no té cap triangle</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>La superfície s’ha reparat abans d’omplir-la.</translation>
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
        <source>The tip of the heart</source>
        <translation>La punta del cor</translation>
    </message>
    <message>
        <source>The top of the fundus</source>
        <translation>El punt més alt del fundus</translation>
    </message>
    <message>
        <source>The width has to be positive</source>
        <translation>L’amplada ha de ser positiva</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Els punts testimoni són en una quadrícula regular dins de la superfície.</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Els punts testimoni són en una quadrícula regular dins de la superfície. %1.</translation>
    </message>
    <message>
        <source>There are %1 positions for %2 handles</source>
        <translation>Hi ha %1 posicions per a %2 tiradors</translation>
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
        <source>There are no such vertices to enclose</source>
        <translation>Aquests vèrtexs per envoltar no existeixen</translation>
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
        <source>There is no such point</source>
        <translation>Aquest punt no existeix</translation>
    </message>
    <message>
        <source>There is no type of samples &quot;%1&quot;</source>
        <translation>No existeix el tipus de mostres «%1»</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Engruiximent</translation>
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
        <translation>Gira les direccions a l’atzar; 0 deixa l’icosaedre dret</translation>
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
        <source>Two handles are at one place</source>
        <translation>Dos tiradors són al mateix lloc</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Procés uncinat</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloqueja</translation>
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
        <source>Veins</source>
        <translation>Venes</translation>
    </message>
    <message>
        <source>Viscera:</source>
        <translation>Viscera:</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Raó de volums</translation>
    </message>
    <message>
        <source>VolumeRatio</source>
        <translation>VolumeRatio</translation>
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
        <source>What is added to every weight when a handle comes in</source>
        <translation>Què s’afegeix a cada pes quan entra un tirador</translation>
    </message>
    <message>
        <source>What is done about negative numbers</source>
        <translation>Què es fa amb els nombres negatius</translation>
    </message>
    <message>
        <source>What the hull is divided into</source>
        <translation>En què es divideix l’envolupant</translation>
    </message>
    <message>
        <source>What the pericardium holds without pressing</source>
        <translation>El que conté el pericardi sense comprimir</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Quan acaba l’ascens del nombre més petit</translation>
    </message>
    <message>
        <source>Where 'iterative' moves the target</source>
        <translation>Cap on mou l’objectiu «iterative»</translation>
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
        <translation>Testimoni</translation>
    </message>
    <message>
        <source>Witness points of %1</source>
        <translation>Punts testimoni de %1</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>una gàbia és una superfície gruixuda: preneu-ne una de %1 vèrtexs com a màxim</translation>
    </message>
    <message>
        <source>a coarse surface needs at least four vertices</source>
        <translation>una superfície gruixuda necessita almenys quatre vèrtexs</translation>
    </message>
    <message>
        <source>a convex hull needs at least 4 points, there are %1</source>
        <translation>una envolupant convexa necessita almenys 4 punts, n’hi ha %1</translation>
    </message>
    <message>
        <source>a displacement</source>
        <translation>un desplaçament</translation>
    </message>
    <message>
        <source>a distance grid of this spacing is too large</source>
        <translation>una quadrícula de distàncies amb aquest pas és massa gran</translation>
    </message>
    <message>
        <source>a handle of a recorded key</source>
        <translation>un tirador d’una clau registrada</translation>
    </message>
    <message>
        <source>a part of the scan is on no organ</source>
        <translation>una part de l’exploració no és sobre cap òrgan</translation>
    </message>
    <message>
        <source>a point of its surface</source>
        <translation>un punt de la seva superfície</translation>
    </message>
    <message>
        <source>a recorded key</source>
        <translation>una clau registrada</translation>
    </message>
    <message>
        <source>a remark on it is not UTF-8</source>
        <translation>una observació sobre ell no és UTF-8</translation>
    </message>
    <message>
        <source>a surface without triangles has no inside</source>
        <translation>una superfície sense triangles no té interior</translation>
    </message>
    <message>
        <source>a triangle has a handle at two corners</source>
        <translation>un triangle té un tirador en dues cantonades</translation>
    </message>
    <message>
        <source>a triangle names a handle that is not there</source>
        <translation>un triangle anomena un tirador que no hi és</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>afegiu tiradors, o col·loqueu-los automàticament</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>afegit per l’agrupació automàtica</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>tots els punts són en un pla</translation>
    </message>
    <message>
        <source>an angle has three points, any other measurement two</source>
        <translation>un angle té tres punts, qualsevol altra mesura dos</translation>
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
        <source>check its permissions</source>
        <translation>comproveu-ne els permisos</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>comproveu-ne la unitat; les coordenades són en mm</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>comproveu el nom</translation>
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
        <source>choose a file that Viscera has saved as .viscera</source>
        <translation>trieu un fitxer que Viscera hagi desat com a .viscera</translation>
    </message>
    <message>
        <source>choose a file with a triangle surface</source>
        <translation>trieu un fitxer amb una superfície de triangles</translation>
    </message>
    <message>
        <source>choose a larger spacing</source>
        <translation>trieu un pas més gran</translation>
    </message>
    <message>
        <source>choose a volume nearer to the present one, or let more handles compensate</source>
        <translation>trieu un volum més proper a l’actual, o deixeu compensar més tiradors</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>trieu-ne un altre</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>trieu-ne un</translation>
    </message>
    <message>
        <source>choose organ, axis or cluster</source>
        <translation>trieu organ, axis o cluster</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>trieu dos extrems d’una superfície</translation>
    </message>
    <message>
        <source>circulation that was kept</source>
        <translation>circulació conservada</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>tanqueu-ne primer els forats</translation>
    </message>
    <message>
        <source>close other programs, or work with fewer organs or coarser surfaces</source>
        <translation>tanqueu altres programes, o treballeu amb menys òrgans o superfícies més gruixudes</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>les coordenades necessiten almenys quatre tiradors, n’hi ha %1</translation>
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
        <source>does not lie between 0 and 1</source>
        <translation>no és entre 0 i 1</translation>
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
        <source>expiration</source>
        <translation>espiració</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>torneu a exportar la superfície</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>ompliment de l’òrgan amb tetràedres</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>fundus</translation>
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
        <source>group</source>
        <translation>grup</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>grup %1</translation>
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
        <source>hold</source>
        <translation>manté</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>inspiració</translation>
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
        <source>its colour does not lie between 0 and 1</source>
        <translation>el seu color no és entre 0 i 1</translation>
    </message>
    <message>
        <source>its description is not UTF-8</source>
        <translation>la seva descripció no és UTF-8</translation>
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
        <source>its handles are not handles of the rig, each once and in their order</source>
        <translation>els seus tiradors no són els del conjunt, cada un un cop i en el seu ordre</translation>
    </message>
    <message>
        <source>its id is another thing's, too</source>
        <translation>el seu identificador és també el d’una altra cosa</translation>
    </message>
    <message>
        <source>its id is not a whole number from 1 to 2^52</source>
        <translation>el seu identificador no és un nombre enter d’1 a 2^52</translation>
    </message>
    <message>
        <source>its name is not UTF-8</source>
        <translation>el seu nom no és UTF-8</translation>
    </message>
    <message>
        <source>its opacity does not lie between 0 and 1</source>
        <translation>la seva opacitat no és entre 0 i 1</translation>
    </message>
    <message>
        <source>its parent is not an organ before it</source>
        <translation>el seu òrgan superior no és abans que ell</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>la seva posició</translation>
    </message>
    <message>
        <source>its position at rest</source>
        <translation>la seva posició en repòs</translation>
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
        <source>its value is not a finite number</source>
        <translation>el seu valor no és un nombre finit</translation>
    </message>
    <message>
        <source>its volume can be kept only when it is bound to the handles there are</source>
        <translation>el seu volum només es pot mantenir quan està vinculat als tiradors presents</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>el seu volum ja no està bloquejat: ara la superfície és oberta</translation>
    </message>
    <message>
        <source>its weights are no place in a triangle: they have to be 0 at least, and 1 together</source>
        <translation>els seus pesos no són un lloc d’un triangle: han de ser almenys 0 i sumar 1</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clau</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>allargueu primer el període</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineal</translation>
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
        <source>middle line</source>
        <translation>línia mitjana</translation>
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
        <source>move or remove one of them</source>
        <translation>moveu-ne o traieu-ne un</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>separeu-hi els vèrtexs, o preneu una altra gàbia</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>anomeneu-lo %1</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>cap aresta uneix més de dos triangles</translation>
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
        <source>no surface has so many triangles</source>
        <translation>cap superfície té tants triangles</translation>
    </message>
    <message>
        <source>one of its points</source>
        <translation>un dels seus punts</translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>obriu-la al costat dels òrgans (Fitxer &gt; Obre una exploració), o feu-ne primer un mapa d’etiquetes, amb 3D Slicer o TotalSegmentator</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>obriu-ne un primer</translation>
    </message>
    <message>
        <source>open the other files after it</source>
        <translation>obriu els altres fitxers després</translation>
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
        <source>parameter %1</source>
        <translation>paràmetre %1</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pausa</translation>
    </message>
    <message>
        <source>peak stress over the sequence</source>
        <translation>tensió màxima al llarg de la seqüència</translation>
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
        <source>place some first</source>
        <translation>col·loqueu-ne primer</translation>
    </message>
    <message>
        <source>point %1 has a coordinate that is not a finite number</source>
        <translation>el punt %1 té una coordenada que no és un nombre finit</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>ho causen punts que coincideixen o gairebé plans</translation>
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
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>ejecció reduïda</translation>
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
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>dreta i esquerra estan intercanviades, davant i darrere no: emmirallat</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>deseu-lo primer en un fitxer propi</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>deseu sovint, o feu-hi lloc</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suau</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>esfera</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>volum sistòlic</translation>
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
        <source>take the sequence's own handles</source>
        <translation>preneu els tiradors propis de la seqüència</translation>
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
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>no es pot calcular l’envolupant convexa de %1 punts</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>el fitxer no indica els seus eixos: se suposa LPS</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>el fitxer indica els seus eixos: %1</translation>
    </message>
    <message>
        <source>the handle %1 comes twice</source>
        <translation>el tirador %1 apareix dues vegades</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>els tiradors no envolten res: %1</translation>
    </message>
    <message>
        <source>the id %1 comes twice</source>
        <translation>l’identificador %1 apareix dues vegades</translation>
    </message>
    <message>
        <source>the limits of time and memory must be above 0</source>
        <translation>els límits de temps i memòria han de ser més grans que 0</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>el nom d’un fitxer de sessió acaba en .viscera</translation>
    </message>
    <message>
        <source>the organ that it is a cavity of is not before it</source>
        <translation>l’òrgan de què és cavitat no és abans</translation>
    </message>
    <message>
        <source>the parts of its colour do not lie between 0 and 1</source>
        <translation>les parts del seu color no són entre 0 i 1</translation>
    </message>
    <message>
        <source>the period is not a positive number of seconds</source>
        <translation>el període no és un nombre positiu de segons</translation>
    </message>
    <message>
        <source>the pose has another number of handles than the document</source>
        <translation>la postura té un altre nombre de tiradors que el document</translation>
    </message>
    <message>
        <source>the quality of tetrahedra is a ratio from 1.1 (best) to 10</source>
        <translation>la qualitat dels tetràedres és una raó d’1,1 (millor) a 10</translation>
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
        <source>the surface consists of %1 separate pieces</source>
        <translation>la superfície consta de %1 peces separades</translation>
    </message>
    <message>
        <source>the surface does not cross itself</source>
        <translation>la superfície no es travessa ella mateixa</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>la superfície té %1 triangles utilitzables, així que no tanca res</translation>
    </message>
    <message>
        <source>the surface has no such triangle</source>
        <translation>la superfície no té aquest triangle</translation>
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
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume</source>
        <translation>
            <numerusform>la superfície és oberta (%n aresta de vora), així que no té volum</numerusform>
            <numerusform>la superfície és oberta (%n arestes de vora), així que no té volum</numerusform>
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
        <source>the triangles beside a hole do not all run the same way round, so it cannot be closed</source>
        <translation>els triangles al voltant d’un forat no giren tots en el mateix sentit, així que no es pot tancar</translation>
    </message>
    <message>
        <source>the triangles face outward</source>
        <translation>els triangles miren cap enfora</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>el volum no es pot mantenir aquí: %1</translation>
    </message>
    <message>
        <source>the weights of a measured point are no place in its triangle</source>
        <translation>els pesos d’un punt mesurat no són un lloc del seu triangle</translation>
    </message>
    <message>
        <source>there is no %1 &quot;%2&quot;</source>
        <translation>«%2» no és un valor de %1</translation>
    </message>
    <message>
        <source>there is no organ %1</source>
        <translation>no hi ha cap òrgan %1</translation>
    </message>
    <message>
        <source>there is no such slice</source>
        <translation>aquest tall no existeix</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>no hi ha cap triangle %1</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to make groups</source>
        <translation>no existeix la manera «%1» de fer grups</translation>
    </message>
    <message>
        <source>there is not enough memory for this</source>
        <translation>no hi ha prou memòria per a això</translation>
    </message>
    <message>
        <source>thinning out the surface</source>
        <translation>simplificació de la superfície</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>és un error del programa; si us plau, comuniqueu-lo</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>triangle %1</translation>
    </message>
    <message>
        <source>triangle %1 refers to vertex %2, but there are %3</source>
        <translation>el triangle %1 es refereix al vèrtex %2, però n’hi ha %3</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>dos grups tenen aquest nom</translation>
    </message>
    <message>
        <source>two handles are at one place</source>
        <translation>dos tiradors són al mateix lloc</translation>
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
        <source>unsaved work</source>
        <translation>feina sense desar</translation>
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
        <source>use a pose of the same handles</source>
        <translation>feu servir una postura dels mateixos tiradors</translation>
    </message>
    <message>
        <source>use one of %1</source>
        <translation>feu servir un de %1</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>feu servir un de: %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>vèrtex %1</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that is not a finite number</source>
        <translation>el vèrtex %1 té una coordenada que no és un nombre finit</translation>
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
        <source>wait until the witness points are there</source>
        <translation>espereu que hi siguin els punts testimoni</translation>
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
        <translation>ona al cos</translation>
    </message>
    <message>
        <source>what is measured on it is now at the nearest places of that surface</source>
        <translation>el que s’hi ha mesurat és ara als llocs més propers d’aquesta superfície</translation>
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
        <source>stress line %1</source>
        <translation>línia de tensió %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>sonda de tensió</translation>
    </message>
    <message>
        <source>stress line</source>
        <translation>línia de tensió</translation>
    </message>
    <message>
        <source>its number is not a whole number from 1</source>
        <translation>el seu número no és un enter a partir d’1</translation>
    </message>
    <message>
        <source>two stress probes have this number</source>
        <translation>dues sondes de tensió tenen aquest número</translation>
    </message>
    <message>
        <source>its place at rest</source>
        <translation>el seu lloc en repòs</translation>
    </message>
    <message>
        <source>it does not join two stress probes of one organ</source>
        <translation>no uneix dues sondes de tensió d’un òrgan</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Un perfil necessita dues sondes d’un òrgan</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Aquestes dues sondes ja tenen un perfil</translation>
    </message>
</context>
</TS>
