<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ca" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adult sa estirat.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Es perd una quarta part del volum de sang estressat; no respon cap reflex, de manera que les pressions baixen més que a la realitat.</translation>
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
        <source>Add</source>
        <translation>Afegeix</translation>
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
        <source>Add to group</source>
        <translation>Afegeix al grup</translation>
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
        <source>An organ needs at least four handles around it: add</source>
        <translation>Un òrgan necessita almenys quatre tiradors al seu voltant: afegiu</translation>
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
        <source>Binding</source>
        <translation>Vinculació</translation>
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
        <source>Checking</source>
        <translation>Es comprova</translation>
    </message>
    <message>
        <source>Circulation:</source>
        <translation>Circulació:</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Tanca els forats</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Acoloreix el grup</translation>
    </message>
    <message>
        <source>Compensate with</source>
        <translation>Compensa amb</translation>
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
    <message>
        <source>Describe</source>
        <translation>Descriu</translation>
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
        <source>Easing</source>
        <translation>Suavització</translation>
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
        <source>Left atrium, scale of the relaxed curve</source>
        <translation>Aurícula esquerra, escala de la corba relaxada</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the relaxed curve</source>
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
        <source>Left ventricle, scale of the relaxed curve</source>
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
        <source>Measure</source>
        <translation>Mesura</translation>
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
        <source>Move</source>
        <translation>Mou</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Mou la clau</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Mou un punt mesurat</translation>
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
        <source>Remove</source>
        <translation>Elimina</translation>
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
        <source>Repairing</source>
        <translation>Es repara</translation>
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
        <source>Right atrium, scale of the relaxed curve</source>
        <translation>Aurícula dreta, escala de la corba relaxada</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the relaxed curve</source>
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
        <source>Right ventricle, scale of the relaxed curve</source>
        <translation>Ventricle dret, escala de la corba relaxada</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the relaxed curve</source>
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
        <source>Set</source>
        <translation>Fixa</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
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
    <message>
        <source>Stop compensating with</source>
        <translation>Deixa de compensar amb</translation>
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
        <source>Take the cage</source>
        <translation>Pren la gàbia</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponament</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>La vàlvula aòrtica s’obre fins a 0,8 cm2: la pressió del ventricle hipertròfic supera de molt la de l’aorta.</translation>
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
        <source>The numbers to stay near to</source>
        <translation>Els nombres als quals cal acostar-se</translation>
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
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>El nombre més petit s’eleva tant com es pot; positives, amb plecs</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>La superfície s’ha reparat abans d’omplir-la.</translation>
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
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Els punts testimoni són en una quadrícula regular dins de la superfície.</translation>
    </message>
    <message>
        <source>There are</source>
        <translation>Hi ha</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Engruiximent</translation>
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
        <source>Witness points of</source>
        <translation>Punts testimoni de</translation>
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
        <source>body</source>
        <translation>cos</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>cabal cardíac</translation>
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
        <source>fundus</source>
        <translation>fundus</translation>
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
        <source>linear</source>
        <translation>lineal</translation>
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
        <source>reduced ejection</source>
        <translation>ejecció reduïda</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suau</translation>
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
        <source>terminal antral contraction</source>
        <translation>contracció antral terminal</translation>
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
</context>
</TS>
