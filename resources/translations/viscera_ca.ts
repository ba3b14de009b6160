<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ca" sourcelanguage="en">
<context>
    <name>Lesson</name>
    <message>
        <source>The organs in three dimensions</source>
        <translation>Els òrgans en tres dimensions</translation>
    </message>
    <message>
        <source>%1. Drag or use the arrow keys to turn, two fingers, the wheel or plus and minus to come nearer.</source>
        <translation>%1. Arrossegueu o feu servir les fletxes per girar; dos dits, la roda o més i menys per acostar-vos.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Valors</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Diapositives</translation>
    </message>
    <message>
        <source>Quiz</source>
        <translation>Qüestionari</translation>
    </message>
    <message>
        <source>Light or dark (T)</source>
        <translation>Clar o fosc (T)</translation>
    </message>
    <message>
        <source>Seen from (1, 3, 7)</source>
        <translation>Vist des de (1, 3, 7)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Davant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Darrere</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Dreta</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Dalt</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Baix</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms</translation>
    </message>
    <message>
        <source>Names of the parts (N)</source>
        <translation>Noms de les parts (N)</translation>
    </message>
    <message>
        <source>Handles to drag (H)</source>
        <translation>Tiradors per arrossegar (H)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restableix</translation>
    </message>
    <message>
        <source>Drag a handle.</source>
        <translation>Arrossegueu un tirador.</translation>
    </message>
    <message>
        <source>Handle %1: arrow keys, plus and minus move it.</source>
        <translation>Tirador %1: les fletxes, més i menys el mouen.</translation>
    </message>
    <message>
        <source>Previous slide (Page Up)</source>
        <translation>Diapositiva anterior (Re Pàg)</translation>
    </message>
    <message>
        <source>Next slide (Page Down)</source>
        <translation>Diapositiva següent (Av Pàg)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 de %2: %3</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostra %1</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 l/min</source>
        <translation>%1 l/min</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 % of rest</source>
        <translation>%1 % del repòs</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1: fracció d’ejecció</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Cabal cardíac</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normal %1</translation>
    </message>
    <message>
        <source>%1 of healthy people</source>
        <translation>%1 de persones sanes</translation>
    </message>
    <message>
        <source>without handles %1</source>
        <translation>sense tiradors %1</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paret</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocitat</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reprodueix</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Atura</translation>
    </message>
    <message>
        <source>Moment of the cycle</source>
        <translation>Moment del cicle</translation>
    </message>
    <message>
        <source>%1 s, %2</source>
        <translation>%1 s, %2</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 per minut</translation>
    </message>
    <message>
        <source>Volumes over one cycle: %1</source>
        <translation>Volums en un cicle: %1</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tecles</translation>
    </message>
    <message>
        <source>Space: play or stop
Arrow keys: turn the picture when it has the focus, else go through the cycle
Plus, minus: nearer, farther
Page Down, Page Up: next and previous slide; B: dark screen
J, K: choose a handle; arrow keys, plus and minus move it; Escape lets it go
1, 3, 7: front, left, above
N: names, H: handles, X: wall, R: reset, T: light or dark, Home: beginning</source>
        <translation>Espai: reprodueix o atura
Fletxes: giren la imatge quan té el focus; si no, recorren el cicle
Més, menys: acosta, allunya
Av Pàg, Re Pàg: diapositiva següent i anterior; B: pantalla fosca
J, K: trien un tirador; les fletxes, més i menys el mouen; Escape el deixa anar
1, 3, 7: davant, esquerra, dalt
N: noms, H: tiradors, X: paret, R: restableix, T: clar o fosc, Inici: principi</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Següent</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Una altra vegada</translation>
    </message>
    <message>
        <source>Leave the quiz</source>
        <translation>Surt del qüestionari</translation>
    </message>
    <message>
        <source>What is marked?</source>
        <translation>Què està marcat?</translation>
    </message>
    <message>
        <source>Which phase is this?</source>
        <translation>Quina fase és aquesta?</translation>
    </message>
    <message>
        <source>Which chamber shrinks now?</source>
        <translation>Quina cavitat es contrau ara?</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Totes dues</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Correcte.</translation>
    </message>
    <message>
        <source>No. The answer is: %1.</source>
        <translation>No. La resposta és: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%1 de %2 correctes</translation>
    </message>
    <message>
        <source>%1 of %2 right.</source>
        <translation>%1 de %2 correctes.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later.</source>
        <translation>Aquesta lliçó necessita un navegador de 2023 o posterior.</translation>
    </message>
    <message>
        <source>This lesson needs WebGL 2. It may be switched off in this browser.</source>
        <translation>Aquesta lliçó necessita WebGL 2. Potser està desactivat en aquest navegador.</translation>
    </message>
    <message>
        <source>The graphics were lost. Load the page again.</source>
        <translation>S’han perdut els gràfics. Torneu a carregar la pàgina.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later, with JavaScript and WebGL 2.</source>
        <translation>Aquesta lliçó necessita un navegador de 2023 o posterior, amb JavaScript i WebGL 2.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Títol</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Normal range</source>
        <translation>Interval normal</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Mesura</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Diapositiva</translation>
    </message>
    <message>
        <source>Text of the slide</source>
        <translation>Text de la diapositiva</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Tirador</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volum després d’un àpat</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of your language (BCP 47): numbers are written as it does.</extracomment>
        <translation>ca</translation>
    </message>
    <message>
        <source>For teaching. It is not a medical device.</source>
        <translation>Per a la docència. No és un producte sanitari.</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Batec del cor</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Peristalsi gàstrica</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Ona al cos gàstric</translation>
    </message>
    <message>
        <source>Terminal antral contraction</source>
        <translation>Contracció antral terminal</translation>
    </message>
    <message>
        <source>Wave fades at the pylorus</source>
        <translation>L’ona s’apaga al pílor</translation>
    </message>
    <message>
        <source>Back to the original shape (R)</source>
        <translation>Torna a la forma original (R)</translation>
    </message>
    <message>
        <source>%1 % from moved handles</source>
        <translation>%1 % per tiradors moguts</translation>
    </message>
    <message>
        <source>Label in the view</source>
        <translation>Etiqueta a la vista</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerra</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Secciona</translation>
    </message>
    <message>
        <source>Open the heart and look into it (C)</source>
        <translation>Obre el cor i mira a dins (C)</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Sang</translation>
    </message>
    <message>
        <source>Blood in the opened chambers (F)</source>
        <translation>Sang a les cavitats obertes (F)</translation>
    </message>
    <message>
        <source>Conduction</source>
        <translation>Conducció</translation>
    </message>
    <message>
        <source>Conduction system, lit with the electrocardiogram (E)</source>
        <translation>Sistema de conducció, s’il·lumina amb l’electrocardiograma (E)</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>ECG</translation>
    </message>
    <message>
        <source>C: cut open, F: blood, E: conduction system</source>
        <translation>C: obre, F: sang, E: sistema de conducció</translation>
    </message>
</context>
<context>
    <name>NewFile</name>
    <message>
        <source>Replace the file?</source>
        <translation>Voleu substituir el fitxer?</translation>
    </message>
    <message>
        <source>%1 already exists. Do you want to replace it?</source>
        <translation>%1 ja existeix. Voleu substituir-lo?</translation>
    </message>
</context>
<context>
    <name>OrganLooks</name>
    <message>
        <source>Show only this</source>
        <translation>Mostra només aquest</translation>
    </message>
</context>
<context>
    <name>Tissue</name>
    <message>
        <source>Muscle</source>
        <translation>Múscul</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Fetge</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Ronyó</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Melsa</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómac</translation>
    </message>
    <message>
        <source>Bowel</source>
        <translation>Intestí</translation>
    </message>
    <message>
        <source>Arterial blood</source>
        <translation>Sang arterial</translation>
    </message>
    <message>
        <source>Venous blood</source>
        <translation>Sang venosa</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Pulmó</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Greix</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Un altre color...</translation>
    </message>
    <message>
        <source>Bile</source>
        <translation>Bilis</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveActions</name>
    <message>
        <source>From the &amp;archive...</source>
        <translation>De l&apos;&amp;arxiu...</translation>
    </message>
    <message>
        <source>Search a hospital&apos;s archive (PACS) for a patient and open a series</source>
        <translation>Cerca un pacient a l&apos;arxiu d&apos;un hospital (PACS) i obre&apos;n una sèrie</translation>
    </message>
    <message>
        <source>No archive is called %1 here. Add it, then open the session again.</source>
        <translation>Cap arxiu no es diu %1 aquí. Afegiu-lo i torneu a obrir la sessió.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveClient</name>
    <message>
        <source>Forgetting the password</source>
        <translation>S&apos;està oblidant la contrasenya</translation>
    </message>
    <message>
        <source>Testing %1</source>
        <translation>S&apos;està provant %1</translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation>S&apos;està cercant a %1</translation>
    </message>
    <message>
        <source>Sending to %1</source>
        <translation>S’envia a %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveDialog</name>
    <message>
        <source>The beginning of the name; * stands for any letters</source>
        <translation>El començament del nom; * val per lletres qualssevol</translation>
    </message>
    <message>
        <source>The beginning of the number of the patient</source>
        <translation>El començament del número del pacient</translation>
    </message>
    <message>
        <source>The first day of the study, as 2024-03-01</source>
        <translation>El primer dia de l&apos;estudi, com ara 2024-03-01</translation>
    </message>
    <message>
        <source>The last day of the study, as 2024-03-31</source>
        <translation>L&apos;últim dia de l&apos;estudi, com ara 2024-03-31</translation>
    </message>
    <message>
        <source>From the archive</source>
        <translation>De l&apos;arxiu</translation>
    </message>
    <message>
        <source>Fetch what is chosen and open it</source>
        <translation>Obtén el que s&apos;ha triat i obre-ho</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Arxiu</translation>
    </message>
    <message>
        <source>The archive to search</source>
        <translation>L&apos;arxiu on se cerca</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Afegeix...</translation>
    </message>
    <message>
        <source>Name another archive</source>
        <translation>Anomena un altre arxiu</translation>
    </message>
    <message>
        <source>Edit...</source>
        <translation>Edita...</translation>
    </message>
    <message>
        <source>Change the address and the titles of this archive</source>
        <translation>Canvia l&apos;adreça i els títols d&apos;aquest arxiu</translation>
    </message>
    <message>
        <source>Forget this archive and its password</source>
        <translation>Oblida aquest arxiu i la seva contrasenya</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Ask whether the archive answers</source>
        <translation>Pregunta si l&apos;arxiu respon</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Qualsevol</translation>
    </message>
    <message>
        <source>Only studies with images of this kind</source>
        <translation>Només estudis amb imatges d&apos;aquest tipus</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>List the studies that match (Return)</source>
        <translation>Llista els estudis que coincideixen (Retorn)</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>Nom del pacient</translation>
    </message>
    <message>
        <source>Patient&apos;s number</source>
        <translation>Número del pacient</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Des de</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Fins a</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalitat</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>AAAA-MM-DD</translation>
    </message>
    <message>
        <source>Studies and series</source>
        <translation>Estudis i sèries</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripció</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imatges</translation>
    </message>
    <message>
        <source>Stop; nothing incomplete is kept</source>
        <translation>Atura; no es conserva res incomplet</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was kept.</source>
        <translation>Cancel·lat. No s&apos;ha conservat res.</translation>
    </message>
    <message>
        <source>No archive is named yet. Add one: its address, and for the classic services its title.</source>
        <translation>Encara no hi ha cap arxiu. Afegiu-ne un: la seva adreça i, per als serveis clàssics, el seu títol.</translation>
    </message>
    <message>
        <source>Remove the archive?</source>
        <translation>Voleu eliminar l&apos;arxiu?</translation>
    </message>
    <message>
        <source>Forget %1 and its password?</source>
        <translation>Voleu oblidar %1 i la seva contrasenya?</translation>
    </message>
    <message>
        <source>%1 answers.</source>
        <translation>%1 respon.</translation>
    </message>
    <message>
        <source>%1 is no day. Write it as 2024-03-01.</source>
        <translation>%1 no és un dia. Escriviu-lo com a 2024-03-01.</translation>
    </message>
    <message>
        <source>No study matches.</source>
        <translation>Cap estudi no coincideix.</translation>
    </message>
    <message numerus="yes">
        <source>%n studies. Open one to see its series.</source>
        <translation>
            <numerusform>%n estudi. Desplegueu-lo per veure&apos;n les sèries.</numerusform>
            <numerusform>%n estudis. Desplegueu-ne un per veure&apos;n les sèries.</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Sèrie %1</translation>
    </message>
    <message>
        <source>This study has no series.</source>
        <translation>Aquest estudi no té sèries.</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Obre l&apos;estudi</translation>
    </message>
</context>
<context>
    <name>viscera::app::AxisPicker</name>
    <message>
        <source>Axes of the heart, from which segments count: set by clicks</source>
        <translation>Eixos del cor, des dels quals es compten els segments: es fixen amb clics</translation>
    </message>
    <message>
        <source>Anterior insertion of the right ventricle</source>
        <translation>Inserció anterior del ventricle dret</translation>
    </message>
</context>
<context>
    <name>viscera::app::BeatStrip</name>
    <message>
        <source>Electrocardiogram, heart sounds and valves</source>
        <translation>Electrocardiograma, sorolls cardíacs i vàlvules</translation>
    </message>
    <message>
        <source>Schematic electrocardiogram, heart sounds S1 and S2 when the valves close, and a bar for each valve while it is open. The lamp is lit while the valve is open.</source>
        <translation>Electrocardiograma esquemàtic, sorolls cardíacs S1 i S2 quan es tanquen les vàlvules, i una barra per a cada vàlvula mentre és oberta. El llum és encès mentre la vàlvula és oberta.</translation>
    </message>
    <message>
        <source>S1</source>
        <translation>S1</translation>
    </message>
    <message>
        <source>S2</source>
        <translation>S2</translation>
    </message>
</context>
<context>
    <name>viscera::app::BindingMessages</name>
    <message>
        <source>%1 is not bound to these handles: binding was cancelled.</source>
        <translation>%1 no està vinculat a aquests tiradors: s’ha cancel·lat la vinculació.</translation>
    </message>
    <message>
        <source>Bind now</source>
        <translation>Vincula ara</translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 have no coordinates in the cage.</source>
        <translation>
            <numerusform>%n vèrtex de %1 no té coordenades a la gàbia.</numerusform>
            <numerusform>%n vèrtexs de %1 no tenen coordenades a la gàbia.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie in no group&apos;s region.</source>
        <translation>
            <numerusform>%n vèrtex de %1 no és a la regió de cap grup.</numerusform>
            <numerusform>%n vèrtexs de %1 no són a la regió de cap grup.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles&apos; hull.</source>
        <translation>
            <numerusform>%n vèrtex de %1 és fora de l’envolupant dels tiradors.</numerusform>
            <numerusform>%n vèrtexs de %1 són fora de l’envolupant dels tiradors.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.</source>
        <translation>
            <numerusform>%n vèrtex de %1 és fora dels tiradors del moviment; %1 queda en repòs.</numerusform>
            <numerusform>%n vèrtexs de %1 són fora dels tiradors del moviment; %1 queda en repòs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CinePage</name>
    <message>
        <source>Open study</source>
        <translation>Estudi obert</translation>
    </message>
    <message>
        <source>Take the images that are open in the window</source>
        <translation>Agafa les imatges obertes a la finestra</translation>
    </message>
    <message>
        <source>Images...</source>
        <translation>Imatges...</translation>
    </message>
    <message>
        <source>A folder with the DICOM files of a cine study</source>
        <translation>Una carpeta amb els fitxers DICOM d&apos;un estudi de cine</translation>
    </message>
    <message>
        <source>Image file...</source>
        <translation>Fitxer d&apos;imatges...</translation>
    </message>
    <message>
        <source>One file of images over time: 4D NIfTI or .seq.nrrd</source>
        <translation>Un fitxer d&apos;imatges en el temps: NIfTI 4D o .seq.nrrd</translation>
    </message>
    <message>
        <source>Labels...</source>
        <translation>Etiquetes...</translation>
    </message>
    <message>
        <source>Label maps or surfaces of single phases: the ends of diastole and systole at least</source>
        <translation>Mapes d&apos;etiquetes o superfícies de fases soltes: com a mínim els finals de diàstole i sístole</translation>
    </message>
    <message>
        <source>Folder of one phase...</source>
        <translation>Carpeta d&apos;una fase...</translation>
    </message>
    <message>
        <source>A folder with all surfaces of one phase</source>
        <translation>Una carpeta amb totes les superfícies d&apos;una fase</translation>
    </message>
    <message>
        <source>Labels and their phases</source>
        <translation>Etiquetes i les seves fases</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetes</translation>
    </message>
    <message>
        <source>Looking through the images</source>
        <translation>S&apos;examinen les imatges</translation>
    </message>
    <message>
        <source>Folder with a cine study</source>
        <translation>Carpeta amb un estudi de cine</translation>
    </message>
    <message>
        <source>Images over time</source>
        <translation>Imatges en el temps</translation>
    </message>
    <message>
        <source>Labels of single phases</source>
        <translation>Etiquetes de fases soltes</translation>
    </message>
    <message>
        <source>Surfaces of one phase</source>
        <translation>Superfícies d&apos;una fase</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>sense indicar</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> de %1</translation>
    </message>
    <message>
        <source>Phase of %1</source>
        <translation>Fase de %1</translation>
    </message>
    <message>
        <source>Guessed from the name and the images: check it</source>
        <translation>Deduït del nom i de les imatges: comproveu-ho</translation>
    </message>
    <message>
        <source>The phase that these labels belong to</source>
        <translation>La fase a què pertanyen aquestes etiquetes</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>Omet %1</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>S&apos;està llegint %1 ...</translation>
    </message>
    <message>
        <source>No images are chosen.</source>
        <translation>No hi ha imatges triades.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 phases, %n planes</source>
        <translation>
            <numerusform>%1: %2 fases, %n pla</numerusform>
            <numerusform>%1: %2 fases, %n plans</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationBox</name>
    <message>
        <source>Preload: stressed blood</source>
        <translation>Precàrrega: volum estressat</translation>
    </message>
    <message>
        <source>Afterload: body</source>
        <translation>Postcàrrega: sistèmica</translation>
    </message>
    <message>
        <source>Afterload: lungs</source>
        <translation>Postcàrrega: pulmonar</translation>
    </message>
    <message>
        <source>Contractility, left</source>
        <translation>Contractilitat, esquerra</translation>
    </message>
    <message>
        <source>Contractility, right</source>
        <translation>Contractilitat, dreta</translation>
    </message>
    <message>
        <source>Stiffness, left</source>
        <translation>Rigidesa, esquerra</translation>
    </message>
    <message>
        <source>%1, %2 at rest</source>
        <translation>%1, %2 en repòs</translation>
    </message>
    <message>
        <source>%1. Marked: normal, %2 %3 (%4)</source>
        <translation>%1. Marcat: normal, %2 %3 (%4)</translation>
    </message>
    <message>
        <source>Only the sample heart can be moved by the circulation model; the charts show its results for any organ.</source>
        <translation>El model de circulació només pot moure el cor de mostra; els gràfics en mostren els resultats per a qualsevol òrgan.</translation>
    </message>
    <message>
        <source>Textbook beat</source>
        <translation>Batec de llibre</translation>
    </message>
    <message>
        <source>Volumes of healthy adults over one beat at this rate</source>
        <translation>Volums d’adults sans durant un batec a aquesta freqüència</translation>
    </message>
    <message>
        <source>A model of heart and vessels: pressures, pressure-volume loops, valves and sounds</source>
        <translation>Un model del cor i els vasos: pressions, bucles pressió-volum, vàlvules i sorolls</translation>
    </message>
    <message>
        <source>Rate, preload, afterload</source>
        <translation>Freqüència, precàrrega, postcàrrega</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Múscul</translation>
    </message>
    <message>
        <source>Valves and pericardium</source>
        <translation>Vàlvules i pericardi</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Abans: %1</translation>
    </message>
    <message>
        <source>Fitted to the volume and the ejection fraction of a left ventricle.</source>
        <translation>Ajustada al volum i a la fracció d’ejecció d’un ventricle esquerre.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationModel</name>
    <message>
        <source>Heart of the circulation</source>
        <translation>Cor de la circulació</translation>
    </message>
</context>
<context>
    <name>viscera::app::ComparedSystem</name>
    <message>
        <source>Coordinates of the second view</source>
        <translation>Coordenades de la segona vista</translation>
    </message>
    <message>
        <source>Coordinate system that binds the same organs to the same handles in this view</source>
        <translation>Sistema de coordenades que vincula els mateixos òrgans als mateixos tiradors en aquesta vista</translation>
    </message>
</context>
<context>
    <name>viscera::app::Comparison</name>
    <message>
        <source>Rate of the second view</source>
        <translation>Freqüència de la segona vista</translation>
    </message>
    <message>
        <source> / min</source>
        <translation> / min</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>Què mostra aquesta vista</translation>
    </message>
    <message>
        <source>The same organ at another rate</source>
        <translation>El mateix òrgan a una altra freqüència</translation>
    </message>
    <message>
        <source>The same organ with other coordinates</source>
        <translation>El mateix òrgan amb altres coordenades</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Obre fitxers...</translation>
    </message>
    <message>
        <source>Back to one view</source>
        <translation>Torna a una vista</translation>
    </message>
    <message>
        <source>Open beside the first organ</source>
        <translation>Obre al costat del primer òrgan</translation>
    </message>
    <message>
        <source>No organ yet</source>
        <translation>Encara cap òrgan</translation>
    </message>
    <message>
        <source>  %1 / min</source>
        <translation>  %1 / min</translation>
    </message>
    <message>
        <source>The errors of both coordinate systems</source>
        <translation>Els errors de tots dos sistemes de coordenades</translation>
    </message>
    <message>
        <source>The second view of the session is not shown: %1 is not installed here.</source>
        <translation>La segona vista de la sessió no es mostra: %1 no és instal·lat aquí.</translation>
    </message>
    <message>
        <source>The same organ, kept in the present pose</source>
        <translation>El mateix òrgan, fixat en la postura actual</translation>
    </message>
    <message>
        <source>Colour each vertex by its distance to the same vertex in view 1; while stress is shown, by what view 1 has more than view 2</source>
        <translation>Acoloreix cada vèrtex segons la distància al mateix vèrtex de la vista 1; amb la tensió a la vista, segons el que la vista 1 té de més que la vista 2</translation>
    </message>
    <message>
        <source>Present pose</source>
        <translation>Posa actual</translation>
    </message>
    <message>
        <source>Kept pose</source>
        <translation>Posa guardada</translation>
    </message>
</context>
<context>
    <name>viscera::app::ConnectionDialog</name>
    <message>
        <source>Secure connection (TLS)</source>
        <translation>Connexió segura (TLS)</translation>
    </message>
    <message>
        <source>Add an archive</source>
        <translation>Afegeix un arxiu</translation>
    </message>
    <message>
        <source>Edit an archive</source>
        <translation>Edita un arxiu</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>Classic DICOM services (DIMSE)</source>
        <translation>Serveis DICOM clàssics (DIMSE)</translation>
    </message>
    <message>
        <source>The name under which you choose the archive</source>
        <translation>El nom amb què trieu l&apos;arxiu</translation>
    </message>
    <message>
        <source>Leave it empty where the archive asks for no password</source>
        <translation>Deixeu-ho buit si l&apos;arxiu no demana contrasenya</translation>
    </message>
    <message>
        <source>The title (AE title) of the archive, at most 16 characters</source>
        <translation>El títol (AE title) de l&apos;arxiu, 16 caràcters com a màxim</translation>
    </message>
    <message>
        <source>The title by which the archive knows this program</source>
        <translation>El títol amb què l&apos;arxiu coneix aquest programa</translation>
    </message>
    <message>
        <source>How long the archive may be silent</source>
        <translation>Quant de temps pot callar l&apos;arxiu</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adreça</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuari</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Title of the archive</source>
        <translation>Títol de l&apos;arxiu</translation>
    </message>
    <message>
        <source>Title of this program</source>
        <translation>Títol d&apos;aquest programa</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Certificats de confiança</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>Paciència</translation>
    </message>
    <message>
        <source>Those of the system</source>
        <translation>Els del sistema</translation>
    </message>
    <message>
        <source>A file with the certificate of the archive&apos;s issuer (.pem)</source>
        <translation>Un fitxer amb el certificat de l&apos;emissor de l&apos;arxiu (.pem)</translation>
    </message>
    <message>
        <source>Choose the file with the certificates</source>
        <translation>Tria el fitxer amb els certificats</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt);;All files (*)</source>
        <translation>Certificats (*.pem *.crt);;Tots els fitxers (*)</translation>
    </message>
    <message>
        <source>Give the archive a name.</source>
        <translation>Doneu un nom a l&apos;arxiu.</translation>
    </message>
    <message>
        <source>Another archive has this name.</source>
        <translation>Un altre arxiu té aquest nom.</translation>
    </message>
    <message>
        <source>Type the address of the archive.</source>
        <translation>Escriviu l&apos;adreça de l&apos;arxiu.</translation>
    </message>
    <message>
        <source>The address of DICOMweb begins with http:// or https://.</source>
        <translation>L&apos;adreça de DICOMweb comença per http:// o https://.</translation>
    </message>
    <message>
        <source>The address holds no user and no password.</source>
        <translation>L&apos;adreça no conté ni usuari ni contrasenya.</translation>
    </message>
    <message>
        <source>A title has 1 to 16 plain characters.</source>
        <translation>Un títol té d&apos;1 a 16 caràcters simples.</translation>
    </message>
    <message>
        <source>Images travel readable for others in the network, and so does a password.</source>
        <translation>Les imatges viatgen llegibles per a altres a la xarxa, i també una contrasenya.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourCorrector</name>
    <message>
        <source>Only contours of a motion that was found in images can be corrected.</source>
        <translation>Només es poden corregir contorns d&apos;un moviment trobat en imatges.</translation>
    </message>
    <message>
        <source>The motion is being fitted to the last correction.</source>
        <translation>El moviment s&apos;està ajustant a l&apos;última correcció.</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact. Correct a phase between them, or change its labels.</source>
        <translation>La fase %1 té etiquetes, que són exactes. Corregiu una fase intermèdia o canvieu-ne les etiquetes.</translation>
    </message>
    <message>
        <source>This organ is not moved by the motion that was found in images.</source>
        <translation>Aquest òrgan no el mou el moviment trobat en les imatges.</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Corregeix el contorn</translation>
    </message>
    <message numerus="yes">
        <source>The motion is that of the images again. %n phases have changed.</source>
        <translation>
            <numerusform>El moviment torna a ser el de les imatges. Ha canviat %n fase.</numerusform>
            <numerusform>El moviment torna a ser el de les imatges. Han canviat %n fases.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases have changed.</source>
        <translation>
            <numerusform>Ha canviat %n fase.</numerusform>
            <numerusform>Han canviat %n fases.</numerusform>
        </translation>
    </message>
    <message>
        <source>The motion meets all corrected contours to %1 mm.</source>
        <translation>El moviment passa per tots els contorns corregits amb un error de %1 mm.</translation>
    </message>
    <message>
        <source>The corrected contour of %1 in phase %2 is met to %3 mm only.</source>
        <translation>El contorn corregit de %1 a la fase %2 només s&apos;assoleix amb un error de %3 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourGrip</name>
    <message>
        <source>Correct &amp;contours</source>
        <translation>Corregeix els &amp;contorns</translation>
    </message>
    <message>
        <source>Drag the contour of a tracked organ in a slice: the motion is fitted to it. Ctrl does the same while it is held. Enabled for a motion that was found in images</source>
        <translation>Arrossegueu el contorn d&apos;un òrgan seguit en un tall: el moviment s&apos;hi ajusta. Ctrl fa el mateix mentre es manté premuda. Disponible per a un moviment trobat en imatges</translation>
    </message>
    <message>
        <source>&amp;Remove a corrected contour</source>
        <translation>&amp;Suprimeix un contorn corregit</translation>
    </message>
    <message>
        <source>%1, slice %2, phase %3</source>
        <translation>%1, tall %2, fase %3</translation>
    </message>
</context>
<context>
    <name>viscera::app::CurveBox</name>
    <message>
        <source>Curve...</source>
        <translation>Corba...</translation>
    </message>
    <message>
        <source>Organ whose volume is prescribed</source>
        <translation>Òrgan del qual es prescriu el volum</translation>
    </message>
    <message>
        <source>A .csv file with two columns: the fraction of the cycle (or time_s) and the volume in ml. At each instant the handles move as little as possible to reach that volume</source>
        <translation>Un fitxer .csv amb dues columnes: la fracció del cicle (o time_s) i el volum en ml. A cada instant els tiradors es mouen el mínim possible per assolir aquest volum</translation>
    </message>
    <message>
        <source>Let the sequence alone determine the volume again</source>
        <translation>Deixa que només la seqüència torni a determinar el volum</translation>
    </message>
    <message>
        <source>Volume curves (*.csv *.txt *.tsv)</source>
        <translation>Corbes de volum (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>%1 follows %2; dashed in the chart.</source>
        <translation>%1 segueix %2; en traç discontinu al gràfic.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CutBox</name>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Cut away the left side</source>
        <translation>Retalla el costat esquerre</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Cut away the part nearest to the viewer</source>
        <translation>Retalla el que és més a prop de l’observador</translation>
    </message>
    <message>
        <source>Distance of the cut from the middle of the organs, in per cent of the distance to their edge</source>
        <translation>Distància de la secció al centre dels òrgans, en percentatge de la distància fins a la vora</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Sang</translation>
    </message>
    <message>
        <source>Fill chambers and vessels of the heart with blood. Without it they are empty and show walls, papillary muscles and valves</source>
        <translation>Omple de sang les cavitats i els vasos del cor. Sense sang són buits i mostren parets, músculs papil·lars i vàlvules</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformMode</name>
    <message>
        <source>Drag a handle and the organ follows; K locks the volume, T turns and scales, M mirrors</source>
        <translation>Arrossegueu un tirador i l’òrgan el segueix; K bloqueja el volum, T gira i escala, M reflecteix</translation>
    </message>
    <message>
        <source>&amp;Turn and scale</source>
        <translation>&amp;Gira i escala</translation>
    </message>
    <message>
        <source>In Deform mode, rings turn and cubes scale the selected handles (at least two)</source>
        <translation>En el mode Deforma, uns anells giren i uns cubs escalen els tiradors seleccionats (almenys dos)</translation>
    </message>
    <message>
        <source>Reset &amp;pose</source>
        <translation>Restableix la &amp;postura</translation>
    </message>
    <message>
        <source>Move every handle back to its rest position</source>
        <translation>Torna tots els tiradors a la posició de repòs</translation>
    </message>
    <message>
        <source>Reset selected handles</source>
        <translation>Restableix els tiradors seleccionats</translation>
    </message>
    <message>
        <source>Move the selected handles back to their rest positions</source>
        <translation>Torna els tiradors seleccionats a la posició de repòs</translation>
    </message>
    <message>
        <source>Restore &amp;rest volume</source>
        <translation>Restableix el volum en &amp;repòs</translation>
    </message>
    <message>
        <source>Restore the organ&apos;s volume at rest with the smallest motion of the handles</source>
        <translation>Restableix el volum de l’òrgan en repòs amb el mínim moviment dels tiradors</translation>
    </message>
    <message>
        <source>Selected handles &amp;compensate</source>
        <translation>Els seleccionats &amp;compensen</translation>
    </message>
    <message>
        <source>Only the selected handles compensate when others would change a locked volume</source>
        <translation>Només compensen els tiradors seleccionats quan els altres canviarien un volum bloquejat</translation>
    </message>
    <message>
        <source>&amp;Off</source>
        <translation>&amp;Desactivat</translation>
    </message>
    <message>
        <source>&amp;Sagittal plane</source>
        <translation>Pla &amp;sagital</translation>
    </message>
    <message>
        <source>&amp;Coronal plane</source>
        <translation>Pla &amp;coronal</translation>
    </message>
    <message>
        <source>&amp;Axial plane</source>
        <translation>Pla &amp;axial</translation>
    </message>
    <message>
        <source>In Deform mode, mirrored handles move along with a drag</source>
        <translation>En el mode Deforma, els tiradors simètrics es mouen junts en arrossegar</translation>
    </message>
    <message>
        <source>&amp;Next mirror plane</source>
        <translation>Pla de simetria següe&amp;nt</translation>
    </message>
    <message>
        <source>Switch between off, sagittal, coronal and axial</source>
        <translation>Alterna entre desactivat, sagital, coronal i axial</translation>
    </message>
    <message>
        <source>Move e&amp;xactly, others compensate</source>
        <translation>Mou e&amp;xactament, els altres compensen</translation>
    </message>
    <message>
        <source>Under a locked volume, moved handles go exactly where they are sent, and the others compensate; else a moved handle stays where the volume lets it</source>
        <translation>Amb un volum bloquejat, els tiradors van exactament on s’envien i els altres compensen; si no, un tirador queda on el volum el deixa</translation>
    </message>
    <message>
        <source>&amp;Free handles follow</source>
        <translation>Els tiradors &amp;lliures segueixen</translation>
    </message>
    <message>
        <source>Handles that you do not drag go to where the elastic energy of the organs&apos; tissue is least; locked handles hold it, else it moves as a whole. Locked volumes stay exact. The first drag takes about a second, the next ones a tenth of a second a step</source>
        <translation>Els tiradors que no arrossegueu van on l&apos;energia elàstica del teixit dels òrgans és mínima; els bloquejats el subjecten, si no es mou en bloc. Els volums bloquejats es mantenen exactes. El primer arrossegament triga aproximadament un segon, els següents una dècima de segon per pas</translation>
    </message>
    <message>
        <source>&amp;Beside elasticity</source>
        <translation>&amp;Al costat de l’elasticitat</translation>
    </message>
    <message>
        <source>Show the current organ as an elastic body that the moved handles grip, as a ghost, and colour the organ by the distance from it; the other handles hold it. It takes some seconds after each drag</source>
        <translation>Mostra l’òrgan actual com un cos elàstic que agafen els tiradors moguts, com un fantasma, i acoloreix l’òrgan segons la distància a aquest; els altres tiradors el sostenen. Triga uns segons després de cada arrossegament</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformPage</name>
    <message>
        <source>Largest shift</source>
        <translation>Desplaçament màxim</translation>
    </message>
    <message>
        <source>The largest distance by which a vertex of the organ has moved from rest</source>
        <translation>La distància més gran que s’ha mogut un vèrtex de l’òrgan des del repòs</translation>
    </message>
    <message>
        <source>Selected handles</source>
        <translation>Tiradors seleccionats</translation>
    </message>
    <message>
        <source>Compensating</source>
        <translation>Compensadors</translation>
    </message>
    <message>
        <source>These handles compensate when others would change a locked volume. If none is marked, a dragged handle stays in a plane, and all free handles compensate for other motions.</source>
        <translation>Aquests tiradors compensen quan els altres canviarien un volum bloquejat. Si no n’hi ha cap de marcat, un tirador arrossegat es manté en un pla, i tots els tiradors lliures compensen els altres moviments.</translation>
    </message>
    <message>
        <source>Symmetric drags</source>
        <translation>Arrossegament simètric</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Postura</translation>
    </message>
    <message>
        <source>Handles moved</source>
        <translation>Tiradors moguts</translation>
    </message>
    <message>
        <source>Mirror plane</source>
        <translation>Pla de simetria</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desactivat</translation>
    </message>
    <message>
        <source>Sagittal plane (left and right)</source>
        <translation>Pla sagital (esquerra i dreta)</translation>
    </message>
    <message>
        <source>Coronal plane (front and back)</source>
        <translation>Pla coronal (davant i darrere)</translation>
    </message>
    <message>
        <source>Axial plane (head and feet)</source>
        <translation>Pla axial (cap i peus)</translation>
    </message>
    <message>
        <source>A drag moves the mirrored handles too; the mirror plane passes through the middle of the organ at rest (M: next plane)</source>
        <translation>En arrossegar es mouen també els tiradors simètrics; el pla de simetria passa pel centre de l’òrgan en repòs (M: pla següent)</translation>
    </message>
    <message>
        <source>Moves along</source>
        <translation>També es mou</translation>
    </message>
    <message>
        <source>no handle is near the mirror image</source>
        <translation>no hi ha cap tirador prop de la imatge simètrica</translation>
    </message>
    <message>
        <source>all free handles</source>
        <translation>tots els lliures</translation>
    </message>
    <message>
        <source>Elasticity</source>
        <translation>Elasticitat</translation>
    </message>
    <message>
        <source>Median distance</source>
        <translation>Distància mediana</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Distància màxima</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomDialog</name>
    <message>
        <source>Segmentation (SEG)</source>
        <translation>Segmentació (SEG)</translation>
    </message>
    <message>
        <source>The organs as voxels on the grid of the scan, one file for each instant</source>
        <translation>Els òrgans com a vòxels a la graella de l’exploració, un fitxer per a cada instant</translation>
    </message>
    <message>
        <source>Measurements (SR)</source>
        <translation>Mesures (SR)</translation>
    </message>
    <message>
        <source>A structured report of volumes, distances and angles for each instant</source>
        <translation>Un informe estructurat de volums, distàncies i angles per a cada instant</translation>
    </message>
    <message>
        <source>Surfaces (STL)</source>
        <translation>Superfícies (STL)</translation>
    </message>
    <message>
        <source>The surface of each organ, one file for each</source>
        <translation>La superfície de cada òrgan, un fitxer per a cadascun</translation>
    </message>
    <message>
        <source>Contours (RTSTRUCT)</source>
        <translation>Contorns (RTSTRUCT)</translation>
    </message>
    <message>
        <source>Contours on the slices of the scan, for radiotherapy</source>
        <translation>Contorns als talls de l’exploració, per a radioteràpia</translation>
    </message>
    <message>
        <source>Without identity</source>
        <translation>Sense identitat</translation>
    </message>
    <message>
        <source>No name, number or date of the patient, and new identifiers of study and series</source>
        <translation>Sense nom, número ni data del pacient, i amb nous identificadors d’estudi i sèrie</translation>
    </message>
    <message>
        <source>Export as DICOM</source>
        <translation>Exporta com a DICOM</translation>
    </message>
    <message>
        <source>The pose that is shown</source>
        <translation>La posa que es mostra</translation>
    </message>
    <message>
        <source>So many instants of one cycle of the motion</source>
        <translation>Tants instants d’un cicle del moviment</translation>
    </message>
    <message>
        <source>No motion moves the organs</source>
        <translation>Cap moviment mou els òrgans</translation>
    </message>
    <message>
        <source>Instants</source>
        <translation>Instants</translation>
    </message>
    <message>
        <source>Whose they are</source>
        <translation>De qui són</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destinació</translation>
    </message>
    <message>
        <source>For research and teaching, not for diagnosis.</source>
        <translation>Per a recerca i docència, no per a diagnòstic.</translation>
    </message>
    <message>
        <source>The files of the scan are being read</source>
        <translation>Es llegeixen els fitxers de l’exploració</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objectes</translation>
    </message>
    <message>
        <source>Contours need the slices of a scan</source>
        <translation>Els contorns necessiten els talls d’una exploració</translation>
    </message>
    <message>
        <source>The organs that are written</source>
        <translation>Els òrgans que s’escriuen</translation>
    </message>
    <message>
        <source>%1 is open and has no inside</source>
        <translation>%1 és obert i no té interior</translation>
    </message>
    <message>
        <source>The elements of each file that say whose it is</source>
        <translation>Els elements de cada fitxer que diuen de qui és</translation>
    </message>
    <message>
        <source>A folder, or an archive that From the archive knows</source>
        <translation>Una carpeta, o un arxiu que «De l’arxiu» coneix</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Made when it is not there; no file in it is replaced</source>
        <translation>Es crea si no hi és; no s’hi substitueix cap fitxer</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Tria la carpeta</translation>
    </message>
    <message>
        <source>No DICOM scan says whose they are: they get a study of their own.</source>
        <translation>Cap exploració DICOM diu de qui són: reben un estudi propi.</translation>
    </message>
    <message>
        <source>Choose at least one object.</source>
        <translation>Trieu almenys un objecte.</translation>
    </message>
    <message>
        <source>Choose at least one organ; its surface has to be closed.</source>
        <translation>Trieu almenys un òrgan; la superfície ha de ser tancada.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Trieu una carpeta.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envia</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomExports</name>
    <message>
        <source>Export as &amp;DICOM...</source>
        <translation>Exporta com a &amp;DICOM...</translation>
    </message>
    <message>
        <source>Write organs and measurements as DICOM files, or send them to an archive (PACS)</source>
        <translation>Escriu òrgans i mesures com a fitxers DICOM, o envia’ls a un arxiu (PACS)</translation>
    </message>
    <message>
        <source>Reading whose the scan is</source>
        <translation>Es llegeix de qui és l’exploració</translation>
    </message>
    <message>
        <source>segmentations</source>
        <translation>segmentacions</translation>
    </message>
    <message>
        <source>structured reports</source>
        <translation>informes estructurats</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>superfícies</translation>
    </message>
    <message>
        <source>structure sets</source>
        <translation>conjunts d’estructures</translation>
    </message>
    <message>
        <source>Exporting as DICOM</source>
        <translation>S’exporta com a DICOM</translation>
    </message>
    <message>
        <source>Written to %1: %2</source>
        <translation>Escrit a %1: %2</translation>
    </message>
    <message>
        <source>Sent to %1: %2</source>
        <translation>Enviat a %1: %2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DifferenceMap</name>
    <message>
        <source>Distance to view 1</source>
        <translation>Distància a la vista 1</translation>
    </message>
    <message>
        <source>%1: view 1 less view 2</source>
        <translation>%1: vista 1 menys vista 2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DisplacementBox</name>
    <message>
        <source>Right to left</source>
        <translation>De dreta a esquerra</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>De davant a darrere</translation>
    </message>
    <message>
        <source>Foot to head</source>
        <translation>De peus a cap</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s left; negative: right (R/L)</source>
        <translation>Cap a l’esquerra del pacient; negatiu: dreta (R/L)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s back; negative: front (A/P)</source>
        <translation>Cap a l’esquena del pacient; negatiu: davant (A/P)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s head; negative: feet (S/I)</source>
        <translation>Cap al cap del pacient; negatiu: peus (S/I)</translation>
    </message>
    <message>
        <source>Move the selected handles once by this distance; locked volumes are kept</source>
        <translation>Mou una vegada els tiradors seleccionats aquesta distància; es mantenen els volums bloquejats</translation>
    </message>
    <message>
        <source>Moved by %1 of %2 mm: the locked volume allows no more in this direction.</source>
        <translation>Moviment de %1 de %2 mm: el volum bloquejat no en permet més en aquesta direcció.</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Mou</translation>
    </message>
</context>
<context>
    <name>viscera::app::ElasticGhost</name>
    <message>
        <source>There is no organ to compare.</source>
        <translation>No hi ha cap òrgan per comparar.</translation>
    </message>
    <message>
        <source>Move a handle: at rest there is nothing to compare.</source>
        <translation>Moveu un tirador: en repòs no hi ha res per comparar.</translation>
    </message>
    <message>
        <source>The elastic organ is being computed.</source>
        <translation>S’està calculant l’òrgan elàstic.</translation>
    </message>
    <message>
        <source>Only an organ that follows the handles can be compared.</source>
        <translation>Només es pot comparar un òrgan que segueix els tiradors.</translation>
    </message>
    <message>
        <source>Elastic organ</source>
        <translation>Òrgan elàstic</translation>
    </message>
    <message>
        <source>The comparison was cancelled. Move a handle, or switch it off and on again.</source>
        <translation>La comparació s’ha cancel·lat. Moveu un tirador, o desactiveu-la i torneu-la a activar.</translation>
    </message>
    <message>
        <source>Distance from elasticity</source>
        <translation>Distància a l’elasticitat</translation>
    </message>
</context>
<context>
    <name>viscera::app::ErrorTable</name>
    <message>
        <source>Unity error</source>
        <translation>Error de la suma</translation>
    </message>
    <message>
        <source>The largest distance of a vertex&apos;s weights&apos; sum from 1</source>
        <translation>La distància màxima entre 1 i la suma dels pesos d’un vèrtex</translation>
    </message>
    <message>
        <source>Negative where the system is not positive</source>
        <translation>Negatiu on el sistema no és positiu</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Fallades</translation>
    </message>
    <message>
        <source>Vertices for which the system has no coordinates; they do not move</source>
        <translation>Vèrtexs per als quals el sistema no té coordenades; no es mouen</translation>
    </message>
    <message>
        <source>Binding time</source>
        <translation>Temps de vinculació</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExploreMode</name>
    <message>
        <source>Explore</source>
        <translation>Explora</translation>
    </message>
    <message>
        <source>Left drag rotates, Shift+left pans, right drag or wheel zooms, click selects an organ, D and A measure</source>
        <translation>Arrossegar amb el botó esquerre gira, Maj+esquerre desplaça, el dret o la roda fan zoom, un clic selecciona un òrgan, D i A mesuren</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; Esc ends</source>
        <translation>Feu clic a dos punts d’un òrgan o d’un tall; Esc ho acaba</translation>
    </message>
    <message>
        <source>Measure &amp;distance</source>
        <translation>Mesura la &amp;distància</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distància</translation>
    </message>
    <message>
        <source>Measure &amp;angle</source>
        <translation>Mesura l’&amp;angle</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; Esc ends</source>
        <translation>Feu clic a tres punts d’un òrgan o d’un tall, el vèrtex en segon lloc; Esc ho acaba</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;rectangle</source>
        <translation>Mesura els valors en un &amp;rectangle</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Arrossegueu sobre un tall de cantó a cantó: mitjana i desviació dels valors de l’exploració; Esc ho acaba</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;sphere</source>
        <translation>Mesura els valors en una &amp;esfera</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Arrossegueu sobre un tall del centre a la vora: mitjana i desviació dels valors de l’exploració; Esc ho acaba</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Remove all &amp;measurements</source>
        <translation>Elimina totes les &amp;mesures</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Mesures</translation>
    </message>
    <message>
        <source>Show the measurements</source>
        <translation>Mostra les mesures</translation>
    </message>
    <message>
        <source>Names of &amp;parts</source>
        <translation>Noms de les &amp;parts</translation>
    </message>
    <message>
        <source>Name the parts of the organs, such as the apex of the heart</source>
        <translation>Anomena les parts dels òrgans, com ara l’àpex del cor</translation>
    </message>
    <message>
        <source>&amp;Quiz on the parts</source>
        <translation>&amp;Qüestionari de les parts</translation>
    </message>
    <message>
        <source>Hide the names and ask for one part after the other; answer with a click on the organ</source>
        <translation>Amaga els noms i pregunta una part rere l’altra; responeu amb un clic a l’òrgan</translation>
    </message>
    <message>
        <source>%1. Drags turn the view, Esc ends the quiz</source>
        <translation>%1. Arrossegar gira la vista, Esc acaba el qüestionari</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; drags turn the view, Esc ends</source>
        <translation>Feu clic a dos punts d’un òrgan o d’un tall; arrossegar gira la vista, Esc ho acaba</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; drags turn the view, Esc ends</source>
        <translation>Feu clic a tres punts d’un òrgan o d’un tall, el vèrtex en segon lloc; arrossegar gira la vista, Esc ho acaba</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner; Esc ends</source>
        <translation>Arrossegueu sobre un tall de cantó a cantó; Esc ho acaba</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle of a sphere to its border; Esc ends</source>
        <translation>Arrossegueu sobre un tall del centre d’una esfera a la vora; Esc ho acaba</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExplorePage</name>
    <message>
        <source>View from</source>
        <translation>Vista des de</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesura</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parts</translation>
    </message>
    <message>
        <source>Rest volume</source>
        <translation>Volum en repòs</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Exploració</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Vòxels</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaiat</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>tancada</translation>
    </message>
    <message numerus="yes">
        <source>open, %n edges</source>
        <translation>
            <numerusform>oberta, %n aresta</numerusform>
            <numerusform>oberta, %n arestes</numerusform>
        </translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>cap seleccionat</translation>
    </message>
    <message>
        <source>Select an organ in the view or in the list to read about it.</source>
        <translation>Seleccioneu un òrgan a la vista o a la llista per llegir-ne les dades.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases</source>
        <translation>
            <numerusform>%n fase</numerusform>
            <numerusform>%n fases</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 phases</source>
        <translation>%1 de %2 fases</translation>
    </message>
    <message>
        <source> in %1 ms</source>
        <translation> en %1 ms</translation>
    </message>
    <message>
        <source>, pixels of %1 mm</source>
        <translation>, píxels de %1 mm</translation>
    </message>
    <message>
        <source>, %1 mm thick</source>
        <translation>, %1 mm de gruix</translation>
    </message>
    <message numerus="yes">
        <source>%n phases in %1 s</source>
        <translation>
            <numerusform>%n fase en %1 s</numerusform>
            <numerusform>%n fases en %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ExportActions</name>
    <message>
        <source>Export all &amp;organs...</source>
        <translation>Exporta tots els ò&amp;rgans...</translation>
    </message>
    <message>
        <source>Write all visible organs into one file, with names and colours</source>
        <translation>Escriu tots els òrgans visibles en un sol fitxer, amb noms i colors</translation>
    </message>
    <message>
        <source>Export all organs</source>
        <translation>Exporta tots els òrgans</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb);;3MF models for printing (*.3mf)</source>
        <translation>Escenes glTF (*.glb);;Models 3MF per imprimir (*.3mf)</translation>
    </message>
    <message>
        <source>Export &amp;displacements...</source>
        <translation>Exporta els &amp;desplaçaments...</translation>
    </message>
    <message>
        <source>Write the current organ at rest, with the displacement of every vertex</source>
        <translation>Escriu l’òrgan actual en repòs, amb el desplaçament de cada vèrtex</translation>
    </message>
    <message>
        <source>Export displacements</source>
        <translation>Exporta els desplaçaments</translation>
    </message>
    <message>
        <source>VTK surfaces (*.vtp)</source>
        <translation>Superfícies VTK (*.vtp)</translation>
    </message>
    <message>
        <source>Export displacement &amp;field...</source>
        <translation>Exporta el &amp;camp de desplaçaments...</translation>
    </message>
    <message>
        <source>Write the displacement of the space around the current organ, for 3D Slicer and ITK</source>
        <translation>Escriu el desplaçament de l’espai al voltant de l’òrgan actual, per a 3D Slicer i ITK</translation>
    </message>
    <message>
        <source>Export displacement field</source>
        <translation>Exporta el camp de desplaçaments</translation>
    </message>
    <message>
        <source>Displacement fields (*.nrrd *.mha)</source>
        <translation>Camps de desplaçaments (*.nrrd *.mha)</translation>
    </message>
    <message>
        <source>Export &amp;table of volumes...</source>
        <translation>Exporta la &amp;taula de volums...</translation>
    </message>
    <message>
        <source>Write volumes and sizes of all organs</source>
        <translation>Escriu els volums i les mides de tots els òrgans</translation>
    </message>
    <message>
        <source>Export table of volumes</source>
        <translation>Exporta la taula de volums</translation>
    </message>
    <message>
        <source>Export &amp;measurements...</source>
        <translation>Exporta les &amp;mesures...</translation>
    </message>
    <message>
        <source>Write all measured distances and angles</source>
        <translation>Escriu totes les distàncies i els angles mesurats</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Measure a distance (D) or an angle (A) first.</source>
        <translation>Encara no s’ha mesurat res. Mesureu primer una distància (D) o un angle (A).</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>Exporta les mesures</translation>
    </message>
    <message>
        <source>all organs</source>
        <translation>tots els òrgans</translation>
    </message>
    <message numerus="yes">
        <source>The rest position of %n points of the field is uncertain.</source>
        <translation>
            <numerusform>La posició de repòs de %n punt del camp és incerta.</numerusform>
            <numerusform>La posició de repòs de %n punts del camp és incerta.</numerusform>
        </translation>
    </message>
    <message>
        <source>table of volumes</source>
        <translation>taula de volums</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>mesures</translation>
    </message>
</context>
<context>
    <name>viscera::app::FileActions</name>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Obre...</translation>
    </message>
    <message>
        <source>Open a session, organs, label maps, handles or a scan</source>
        <translation>Obre una sessió, òrgans, mapes d’etiquetes, tiradors o una exploració</translation>
    </message>
    <message>
        <source>Open a &amp;folder of masks...</source>
        <translation>Obre una &amp;carpeta de màscares...</translation>
    </message>
    <message>
        <source>Open one patient: a folder with one mask for each organ, as TotalSegmentator writes it</source>
        <translation>Obre un pacient: una carpeta amb una màscara per a cada òrgan, tal com l’escriu TotalSegmentator</translation>
    </message>
    <message>
        <source>&amp;Import with check...</source>
        <translation>&amp;Importa amb comprovació...</translation>
    </message>
    <message>
        <source>Check and repair the contents of files before importing them</source>
        <translation>Comprova i repara el contingut dels fitxers abans d’importar-los</translation>
    </message>
    <message>
        <source>Save &amp;handles...</source>
        <translation>Desa els &amp;tiradors...</translation>
    </message>
    <message>
        <source>Save the handles at rest as Slicer markups</source>
        <translation>Desa els tiradors en repòs com a marques de Slicer</translation>
    </message>
    <message>
        <source>&amp;Export organ...</source>
        <translation>&amp;Exporta l’òrgan...</translation>
    </message>
    <message>
        <source>Export the organ in its present pose</source>
        <translation>Exporta l’òrgan en la postura actual</translation>
    </message>
    <message>
        <source>Load a &amp;cage...</source>
        <translation>Carrega una &amp;gàbia...</translation>
    </message>
    <message>
        <source>For coordinates that need a cage: load a closed surface around the organ; its vertices become the handles</source>
        <translation>Per a coordenades que necessiten gàbia: carrega una superfície tancada al voltant de l’òrgan; els vèrtexs esdevenen els tiradors</translation>
    </message>
    <message>
        <source>Sessions, organs, label maps, handles and scans (*.viscera %1 %2 %3)</source>
        <translation>Sessions, òrgans, mapes d’etiquetes, tiradors i exploracions (*.viscera %1 %2 %3)</translation>
    </message>
    <message>
        <source>Sessions (*.viscera)</source>
        <translation>Sessions (*.viscera)</translation>
    </message>
    <message>
        <source>Organs, label maps and handles (%1 %2 %3)</source>
        <translation>Òrgans, mapes d’etiquetes i tiradors (%1 %2 %3)</translation>
    </message>
    <message>
        <source>Label maps (%1)</source>
        <translation>Mapes d’etiquetes (%1)</translation>
    </message>
    <message>
        <source>Handles (%1)</source>
        <translation>Tiradors (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tots els fitxers (*)</translation>
    </message>
    <message>
        <source>Open a folder with one mask for each organ</source>
        <translation>Obre una carpeta amb una màscara per a cada òrgan</translation>
    </message>
    <message numerus="yes">
        <source>Opening %n files</source>
        <translation>
            <numerusform>S’obre %n fitxer</numerusform>
            <numerusform>S’obren %n fitxers</numerusform>
        </translation>
    </message>
    <message>
        <source>Save handles</source>
        <translation>Desa els tiradors</translation>
    </message>
    <message>
        <source>Slicer markups (*%1 *.fcsv)</source>
        <translation>Marques de Slicer (*%1 *.fcsv)</translation>
    </message>
    <message>
        <source>Load a cage</source>
        <translation>Carrega una gàbia</translation>
    </message>
    <message>
        <source>Closed surfaces (%1);;All files (*)</source>
        <translation>Superfícies tancades (%1);;Tots els fitxers (*)</translation>
    </message>
    <message>
        <source>Reading the cage %1</source>
        <translation>Es llegeix la gàbia %1</translation>
    </message>
    <message>
        <source>The handles at the vertices of %1 are now the corners of the cage.</source>
        <translation>Els tiradors als vèrtexs de %1 són ara els cantons de la gàbia.</translation>
    </message>
    <message numerus="yes">
        <source>The %n vertices of %1 are now the handles.</source>
        <translation>
            <numerusform>L’únic vèrtex (%n) de %1 és ara el tirador.</numerusform>
            <numerusform>Els %n vèrtexs de %1 són ara els tiradors.</numerusform>
        </translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Superfícies (%1)</translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>S’ha escrit %1 a %2</translation>
    </message>
    <message>
        <source>%1 was not found.</source>
        <translation>No s’ha trobat %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n more findings; see the organs&apos; pages in Explore mode</source>
        <translation>
            <numerusform>%n troballa més; vegeu la pàgina de l’òrgan al mode Explora</numerusform>
            <numerusform>%n troballes més; vegeu les pàgines dels òrgans al mode Explora</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lies exactly where %2 lies already: only one of them is seen.</source>
        <translation>%1 és exactament on ja és %2: només se’n veu un dels dos.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Findings</name>
    <message>
        <source>Side of the body</source>
        <translation>Costat del cos</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Superfície oberta</translation>
    </message>
    <message>
        <source>Edges of more than two triangles</source>
        <translation>Arestes de més de dos triangles</translation>
    </message>
    <message>
        <source>Triangles that face inward</source>
        <translation>Triangles que miren cap endins</translation>
    </message>
    <message>
        <source>Separate pieces</source>
        <translation>Peces separades</translation>
    </message>
    <message>
        <source>Crossing triangles</source>
        <translation>Triangles que es creuen</translation>
    </message>
    <message>
        <source>Positions of the organs</source>
        <translation>Posicions dels òrgans</translation>
    </message>
    <message>
        <source>Lost details</source>
        <translation>Detalls perduts</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitBox</name>
    <message>
        <source>by the shape</source>
        <translation>per la forma</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punt</numerusform>
            <numerusform>%n punts</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit to this organ</source>
        <translation>Ajusta a aquest òrgan</translation>
    </message>
    <message>
        <source>Sequence to fit</source>
        <translation>Seqüència per ajustar</translation>
    </message>
    <message>
        <source>Of the left ventricle. The right one ejects as much blood, and the muscle keeps its volume</source>
        <translation>Del ventricle esquerre. El dret expulsa la mateixa sang i el múscul conserva el volum</translation>
    </message>
    <message>
        <source>%1: click its place in the view</source>
        <translation>%1: definiu-lo amb un clic a la vista</translation>
    </message>
    <message>
        <source>click the organ</source>
        <translation>feu clic a l’òrgan</translation>
    </message>
    <message>
        <source>Open a patient&apos;s organ first.</source>
        <translation>Obriu primer un òrgan d’un pacient.</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface.</source>
        <translation>%1 és una superfície oberta; una seqüència en necessita una de tancada.</translation>
    </message>
    <message>
        <source>Makes %1 and its chambers beat like a textbook heart. The present shape counts as the end of diastole. The result is a key sequence.</source>
        <translation>Fa bategar %1 i les seves cavitats com el cor d’un llibre de text. La forma actual compta com a final de la diàstole. El resultat és una seqüència de claus.</translation>
    </message>
    <message>
        <source>Moves %1 like the sample organ. Landmarks that you do not set are found from its shape.</source>
        <translation>Mou %1 com l’òrgan de mostra. Els punts de referència que no definiu es dedueixen de la forma.</translation>
    </message>
    <message>
        <source>Fitting %1</source>
        <translation>S’ajusta %1</translation>
    </message>
    <message>
        <source>Fit the textbook&apos;s beat to %1</source>
        <translation>Ajusta el batec de llibre a %1</translation>
    </message>
    <message>
        <source>Spine and pelvis stay in place: breathing does not move them.</source>
        <translation>La columna vertebral i la pelvis es queden al seu lloc: la respiració no les mou.</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitOffer</name>
    <message>
        <source>Replace all open organs; Undo brings them back</source>
        <translation>Substitueix tots els òrgans oberts; Desfés els recupera</translation>
    </message>
    <message>
        <source>%1 is made for a %2, but the name %3 suggests another organ.</source>
        <translation>%1 és per a: %2, però el nom %3 fa pensar en un altre òrgan.</translation>
    </message>
    <message>
        <source>%1: fit it to %2?</source>
        <translation>%1: voleu ajustar-la a %2?</translation>
    </message>
    <message>
        <source>Fit it anyway</source>
        <translation>Ajusta-la igualment</translation>
    </message>
    <message>
        <source>Fit it to %1</source>
        <translation>Ajusta-la a %1</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface</source>
        <translation>%1 és una superfície oberta; una seqüència en necessita una de tancada</translation>
    </message>
    <message>
        <source>Show the sample %1</source>
        <translation>Mostra l’òrgan de mostra: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::GroupPanel</name>
    <message>
        <source>No groups: all handles act everywhere. Select handles and make a group of them, or make groups automatically below.</source>
        <translation>No hi ha grups: tots els tiradors actuen pertot. Seleccioneu tiradors i feu-ne un grup, o creeu grups automàticament a sota.</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Grup nou</translation>
    </message>
    <message>
        <source>Make a group of the selected handles</source>
        <translation>Fes un grup amb els tiradors seleccionats</translation>
    </message>
    <message>
        <source>Select handles</source>
        <translation>Selecciona tiradors</translation>
    </message>
    <message>
        <source>Select the handles of the chosen group</source>
        <translation>Selecciona els tiradors del grup triat</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Afegeix-hi</translation>
    </message>
    <message>
        <source>Add the selected handles to the chosen group</source>
        <translation>Afegeix els tiradors seleccionats al grup triat</translation>
    </message>
    <message>
        <source>Choose the colour of the chosen group</source>
        <translation>Tria el color del grup triat</translation>
    </message>
    <message>
        <source>Remove the chosen group; its handles stay</source>
        <translation>Elimina el grup triat; els tiradors es conserven</translation>
    </message>
    <message>
        <source>How groups are made</source>
        <translation>Com es fan els grups</translation>
    </message>
    <message>
        <source>Parts along the axis</source>
        <translation>Parts al llarg de l’eix</translation>
    </message>
    <message>
        <source>Clusters of handles</source>
        <translation>Agrupacions de tiradors</translation>
    </message>
    <message>
        <source>Organs and their pieces</source>
        <translation>Òrgans i les seves peces</translation>
    </message>
    <message>
        <source>How many groups</source>
        <translation>Nombre de grups</translation>
    </message>
    <message>
        <source>Replace the present groups. Where handles do not surround a group&apos;s part of the organ, the corners of a box are added.</source>
        <translation>Substitueix els grups actuals. On els tiradors no envolten la part de l’òrgan d’un grup, s’hi afegeixen els cantons d’una capsa.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grup %1</translation>
    </message>
    <message>
        <source>F2 renames</source>
        <translation>F2 canvia el nom</translation>
    </message>
    <message>
        <source>A region needs at least four handles</source>
        <translation>Una regió necessita almenys quatre tiradors</translation>
    </message>
    <message>
        <source>These coordinates do not use groups.</source>
        <translation>Aquestes coordenades no fan servir grups.</translation>
    </message>
    <message>
        <source>No coordinate system that uses groups is loaded: the plugin is missing.</source>
        <translation>No hi ha carregat cap sistema de coordenades amb grups: falta el connector.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Fes servir %1</translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to the group.</source>
        <translation>
            <numerusform>L’agrupació automàtica ha afegit %n tirador de cantó al grup.</numerusform>
            <numerusform>L’agrupació automàtica ha afegit %n tiradors de cantó al grup.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to %1 of %2 groups.</source>
        <translation>
            <numerusform>L’agrupació automàtica ha afegit %n tirador de cantó a %1 de %2 grups.</numerusform>
            <numerusform>L’agrupació automàtica ha afegit %n tiradors de cantó a %1 de %2 grups.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Treu</translation>
    </message>
    <message>
        <source>Take the selected handles out of the chosen group</source>
        <translation>Treure les nanses seleccionades del grup triat</translation>
    </message>
</context>
<context>
    <name>viscera::app::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Guia de l’usuari</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Cerca a la guia</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Seccions</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n secció</numerusform>
            <numerusform>%n seccions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleController</name>
    <message numerus="yes">
        <source>Turn %n handles</source>
        <translation>
            <numerusform>Gira %n tirador</numerusform>
            <numerusform>Gira %n tiradors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n handles</source>
        <translation>
            <numerusform>Escala %n tirador</numerusform>
            <numerusform>Escala %n tiradors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleModel</name>
    <message>
        <source>Handle</source>
        <translation>Tirador</translation>
    </message>
    <message>
        <source>Rest L</source>
        <translation>Repòs L</translation>
    </message>
    <message>
        <source>Rest P</source>
        <translation>Repòs P</translation>
    </message>
    <message>
        <source>Rest S</source>
        <translation>Repòs S</translation>
    </message>
    <message>
        <source>Pose L</source>
        <translation>Postura L</translation>
    </message>
    <message>
        <source>Pose P</source>
        <translation>Postura P</translation>
    </message>
    <message>
        <source>Pose S</source>
        <translation>Postura S</translation>
    </message>
    <message>
        <source>Moved (mm)</source>
        <translation>Mogut (mm)</translation>
    </message>
    <message>
        <source>Coordinate</source>
        <translation>Coordenada</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePanel</name>
    <message>
        <source>No handles yet.
Move the slider above to place some, or click the organ in Handles mode (2).</source>
        <translation>Encara no hi ha tiradors.
Moveu el lliscador de dalt per col·locar-ne, o feu clic a l’òrgan en el mode Tiradors (2).</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>Col·loca automàticament</translation>
    </message>
    <message>
        <source>Place this many handles evenly, a little outside the organ&apos;s surface; they replace the present ones</source>
        <translation>Col·loca aquest nombre de tiradors de manera uniforme, una mica fora de la superfície de l’òrgan; substitueixen els actuals</translation>
    </message>
    <message>
        <source>Enclosing box</source>
        <translation>Capsa envoltant</translation>
    </message>
    <message>
        <source>Eight of the handles are the corners of a box around the organ, so that all of it lies inside</source>
        <translation>Vuit dels tiradors són els cantons d’una capsa al voltant de l’òrgan, de manera que tot hi queda dins</translation>
    </message>
    <message>
        <source>F2 renames, Delete removes</source>
        <translation>F2 canvia el nom, Supr elimina</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePlacer</name>
    <message>
        <source>Place handles</source>
        <translation>Col·loca tiradors</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleTable</name>
    <message>
        <source>Table of handles</source>
        <translation>Taula de tiradors</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copia</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, with all digits (Ctrl+C)</source>
        <translation>Copia les files seleccionades, o totes, amb tots els dígits (Ctrl+C)</translation>
    </message>
    <message>
        <source>&amp;Table of handles...</source>
        <translation>&amp;Taula de tiradors...</translation>
    </message>
    <message>
        <source>Positions of all handles, and the coordinates of a vertex that you click</source>
        <translation>Posicions de tots els tiradors, i coordenades del vèrtex en què feu clic</translation>
    </message>
    <message>
        <source>Click the organ in the view to see the coordinates of its nearest vertex.</source>
        <translation>Feu clic a l’òrgan a la vista per veure les coordenades del vèrtex més proper.</translation>
    </message>
    <message>
        <source>Vertex %1 of %2, at rest at %3, %4, %5 mm (LPS)</source>
        <translation>Vèrtex %1 de %2, en repòs a %3; %4; %5 mm (LPS)</translation>
    </message>
    <message>
        <source>%1: the organ is not bound to the handles.</source>
        <translation>%1: l’òrgan no està vinculat als tiradors.</translation>
    </message>
    <message>
        <source>%1. Its coordinates sum to %2 and miss it by %3 mm.</source>
        <translation>%1. Les coordenades sumen %2 i se’n desvien %3 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesMode</name>
    <message>
        <source>Click the organ to add a handle, drag to move it, Delete removes it; the rest shape stays</source>
        <translation>Feu clic a l’òrgan per afegir un tirador, arrossegueu per moure’l, Supr l’elimina; la forma en repòs es manté</translation>
    </message>
    <message>
        <source>&amp;Place automatically</source>
        <translation>Col·loca a&amp;utomàticament</translation>
    </message>
    <message>
        <source>Spread handles evenly around the organ</source>
        <translation>Distribueix tiradors uniformement al voltant de l’òrgan</translation>
    </message>
    <message>
        <source>Add &amp;enclosing handles</source>
        <translation>Afegeix tiradors &amp;envoltants</translation>
    </message>
    <message>
        <source>Add the eight corners of a box around everything</source>
        <translation>Afegeix els vuit cantons d’una capsa al voltant de tot</translation>
    </message>
    <message>
        <source>&amp;Remove handles</source>
        <translation>Elimina els &amp;tiradors</translation>
    </message>
    <message>
        <source>Remove the selected handles</source>
        <translation>Elimina els tiradors seleccionats</translation>
    </message>
    <message>
        <source>Select &amp;all handles</source>
        <translation>Selecciona &amp;tots els tiradors</translation>
    </message>
    <message>
        <source>Use the &amp;hull as the cage</source>
        <translation>&amp;Fes servir l’envolupant com a gàbia</translation>
    </message>
    <message>
        <source>Discard the loaded cage and use the convex hull of the handles again</source>
        <translation>Descarta la gàbia carregada i torna a fer servir l’envolupant convexa dels tiradors</translation>
    </message>
    <message>
        <source>&amp;Influence map</source>
        <translation>Mapa d’&amp;influència</translation>
    </message>
    <message>
        <source>Colour the organ by the influence of the selected handle</source>
        <translation>Acoloreix l’òrgan segons la influència del tirador seleccionat</translation>
    </message>
    <message>
        <source>Show &amp;regions</source>
        <translation>Mostra les &amp;regions</translation>
    </message>
    <message>
        <source>Show where each group of handles acts, and the cage of coordinates that need one</source>
        <translation>Mostra on actua cada grup de tiradors, i la gàbia de les coordenades que en necessiten</translation>
    </message>
    <message>
        <source>Show &amp;zones</source>
        <translation>Mostra les &amp;zones</translation>
    </message>
    <message>
        <source>Show where regions meet, in red</source>
        <translation>Mostra en vermell on es troben les regions</translation>
    </message>
    <message>
        <source>Show &amp;super-regions</source>
        <translation>Mostra les &amp;superregions</translation>
    </message>
    <message>
        <source>Show the super-region that counts in each zone, in yellow</source>
        <translation>Mostra en groc la superregió que compta en cada zona</translation>
    </message>
    <message>
        <source>Bound in %1 ms</source>
        <translation>Vinculat en %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n handles removed</source>
        <translation>
            <numerusform>S’ha eliminat %n tirador</numerusform>
            <numerusform>S’han eliminat %n tiradors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesPage</name>
    <message>
        <source>not bound</source>
        <translation>no vinculat</translation>
    </message>
    <message>
        <source>binding...</source>
        <translation>es vincula...</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>vinculat</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancel·lat</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>no és possible</translation>
    </message>
    <message>
        <source>Binding</source>
        <translation>Vinculació</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estat</translation>
    </message>
    <message>
        <source>Handle at rest</source>
        <translation>Tirador en repòs</translation>
    </message>
    <message>
        <source>The cage is the convex hull of the handles.</source>
        <translation>La gàbia és l’envolupant convexa dels tiradors.</translation>
    </message>
    <message>
        <source>The cage has %1 triangles over %2 handles.</source>
        <translation>La gàbia té %1 triangles sobre %2 tiradors.</translation>
    </message>
    <message numerus="yes">
        <source>%1 ms, %n threads</source>
        <translation>
            <numerusform>%1 ms, %n fil</numerusform>
            <numerusform>%1 ms, %n fils</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartNumbersBox</name>
    <message>
        <source>Numbers of the measured heart</source>
        <translation>Valors del cor mesurat</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>per m²</translation>
    </message>
    <message>
        <source>End of diastole here</source>
        <translation>Fi de la diàstole aquí</translation>
    </message>
    <message>
        <source>The present instant is the end of diastole (ED)</source>
        <translation>L&apos;instant present és el final de la diàstole (ED)</translation>
    </message>
    <message>
        <source>End of systole here</source>
        <translation>Fi de la sístole aquí</translation>
    </message>
    <message>
        <source>The present instant is the end of systole (ES)</source>
        <translation>L&apos;instant present és el final de la sístole (ES)</translation>
    </message>
    <message>
        <source>Find both ends</source>
        <translation>Troba els dos finals</translation>
    </message>
    <message>
        <source>ED is where the volume is largest, ES where it is smallest</source>
        <translation>ED és on el volum és més gran, ES on és més petit</translation>
    </message>
    <message>
        <source>Height and weight...</source>
        <translation>Alçada i pes...</translation>
    </message>
    <message>
        <source>Body surface area by Mosteller, for numbers per square metre</source>
        <translation>Superfície corporal segons Mosteller, per a valors per metre quadrat</translation>
    </message>
    <message>
        <source>Save as CSV...</source>
        <translation>Desa com a CSV...</translation>
    </message>
    <message>
        <source>Write these numbers into a table</source>
        <translation>Escriu aquests valors en una taula</translation>
    </message>
    <message>
        <source>ED at %1 % of the cycle, ES at %2 %</source>
        <translation>ED al %1 % del cicle, ES al %2 %</translation>
    </message>
    <message>
        <source>Body surface</source>
        <translation>Superfície corporal</translation>
    </message>
    <message>
        <source>Height in cm</source>
        <translation>Alçada en cm</translation>
    </message>
    <message>
        <source>Weight in kg</source>
        <translation>Pes en kg</translation>
    </message>
    <message>
        <source>A body surface area of %1 m² is not that of an adult: nothing is indexed</source>
        <translation>Una superfície corporal d&apos;%1 m² no és la d&apos;un adult: no s&apos;indexa res</translation>
    </message>
    <message>
        <source>Save the heart&apos;s numbers</source>
        <translation>Desa els valors del cor</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Taula (*.csv)</translation>
    </message>
    <message>
        <source>The heart&apos;s numbers are in %1</source>
        <translation>Els valors del cor són a %1</translation>
    </message>
    <message>
        <source>Estimates: only one phase of the images has labels. Of a right ventricle there are no numbers then.</source>
        <translation>Estimacions: només una fase de les imatges té etiquetes. D&apos;un ventricle dret no hi ha nombres llavors.</translation>
    </message>
    <message>
        <source>Body surface %1 m² from the images: %2 cm, %3 kg</source>
        <translation>Superfície corporal %1 m² segons les imatges: %2 cm, %3 kg</translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartOpener</name>
    <message>
        <source>Opening the heart</source>
        <translation>S&apos;està obrint el cor</translation>
    </message>
</context>
<context>
    <name>viscera::app::Help</name>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Ratolí i tecles</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>&amp;Visita de dos minuts</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Benvinguda</translation>
    </message>
    <message>
        <source>&amp;About Viscera</source>
        <translation>&amp;Quant a Viscera</translation>
    </message>
    <message>
        <source>Viscera %1: organs deformed by handles, without a cage. BSD-3-Clause; a program for research and teaching, not a medical device.</source>
        <translation>Viscera %1: òrgans deformats amb tiradors, sense gàbia. BSD-3-Clause; un programa per a la recerca i la docència, no és un producte sanitari.</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Mireu al voltant</translation>
    </message>
    <message>
        <source>Drag with the left button to rotate, with Shift to pan; the wheel zooms. Click an organ to select it, press F to bring it into the picture; D measures distances, A angles. The eye in the list on the left hides it, the square changes its colour.</source>
        <translation>Arrossegueu amb el botó esquerre per girar, amb Maj per desplaçar; la roda apropa i allunya. Feu clic en un òrgan per seleccionar-lo, premeu F per enquadrar-lo; D mesura distàncies i A angles. L’ull de la llista de l’esquerra l’amaga, el quadrat en canvia el color.</translation>
    </message>
    <message>
        <source>Play a motion</source>
        <translation>Reprodueix un moviment</translation>
    </message>
    <message>
        <source>Space plays and pauses. The timeline shows the phases of the cycle: drag along it to look at one instant. Below, the volumes are drawn as they change.</source>
        <translation>Espai reprodueix i posa en pausa. La línia de temps mostra les fases del cicle: arrossegueu-la per veure un instant. A sota es dibuixen els volums a mesura que canvien.</translation>
    </message>
    <message>
        <source>Organs follow handles around them. Here you edit them at rest: click the organ to add one, drag to move it, Delete to remove it. The organ is bound again at once. I shows how far a handle reaches.</source>
        <translation>Els òrgans segueixen els tiradors que els envolten. Aquí els editeu en repòs: feu clic a l’òrgan per afegir-ne un, arrossegueu-lo per moure’l, Supr per eliminar-lo. L’òrgan es torna a vincular de seguida. I mostra fins on arriba un tirador.</translation>
    </message>
    <message>
        <source>Drag a handle and the organ follows; its volume is in the status bar. The padlock in the list on the left (K) keeps the volume whatever you do. T turns and scales selected handles, M mirrors drags. Ctrl+Z undoes any change, G shows the rest shape as an outline.</source>
        <translation>Arrossegueu un tirador i l’òrgan el segueix; el volum és a la barra d’estat. El cadenat de la llista de l’esquerra (K) manté el volum feu el que feu. T gira i escala els tiradors seleccionats, M fa simètric l’arrossegament. Ctrl+Z desfà qualsevol canvi, G mostra el contorn de la forma en repòs.</translation>
    </message>
    <message>
        <source>The colours say how much the pose distorts the tissue inside. Click the organ to read the values of a point, C cuts it open, M shows the next map. Space plays the sequence, and the map follows.</source>
        <translation>Els colors mostren fins a quin punt la postura distorsiona el teixit interior. Feu clic a l’òrgan per llegir els valors d’un punt; C el secciona, M mostra el mapa següent. Espai reprodueix la seqüència i el mapa la segueix.</translation>
    </message>
    <message>
        <source>Your own organs</source>
        <translation>Els vostres òrgans</translation>
    </message>
    <message>
        <source>Open surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) or label maps (NIfTI, NRRD, DICOM-SEG) with Ctrl+O or drop them here; they get handles at once. Ctrl+S saves all of it as a session. ? lists all keys.</source>
        <translation>Obriu superfícies (STL, OBJ, PLY, OFF, VTK, VTP, GLB) o mapes d’etiquetes (NIfTI, NRRD, DICOM-SEG) amb Ctrl+O o deixeu-los anar aquí; reben tiradors a l’instant. Ctrl+S ho desa tot com a sessió. ? mostra totes les tecles.</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Guia de l’usuari</translation>
    </message>
    <message>
        <source>The guide, at what the present mode does</source>
        <translation>La guia, al que fa el mode present</translation>
    </message>
    <message>
        <source>&amp;First task: drag a dot</source>
        <translation>&amp;Primera tasca: arrossegar un punt</translation>
    </message>
</context>
<context>
    <name>viscera::app::Histogram</name>
    <message>
        <source>Histogram of the map</source>
        <translation>Histograma del mapa</translation>
    </message>
    <message>
        <source>Number of witness points with each value; the lines mark the mean and the 95th percentile</source>
        <translation>Nombre de punts testimoni amb cada valor; les línies marquen la mitjana i el percentil 95</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportController</name>
    <message>
        <source>Import or cancel the files in the panel first, then open the others.</source>
        <translation>Primer importeu o cancel·leu els fitxers del panell, després obriu els altres.</translation>
    </message>
    <message>
        <source>Check of %1</source>
        <translation>Comprovació de %1</translation>
    </message>
    <message numerus="yes">
        <source>Check of %n files</source>
        <translation>
            <numerusform>Comprovació de %n fitxer</numerusform>
            <numerusform>Comprovació de %n fitxers</numerusform>
        </translation>
    </message>
    <message>
        <source>Repairing: %1</source>
        <translation>Es repara: %1</translation>
    </message>
    <message>
        <source>Checking again</source>
        <translation>Es torna a comprovar</translation>
    </message>
    <message>
        <source>%1 of %2 organs could not be repaired that way and stay as they are. The panel says why.</source>
        <translation>%1 de %2 òrgans no s’han pogut reparar així i es queden com estaven. El panell diu per què.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportPanel</name>
    <message>
        <source>No problems found. Nothing is in the document yet.</source>
        <translation>No s’ha trobat cap problema. Encara no hi ha res al document.</translation>
    </message>
    <message>
        <source>Check the findings first. Nothing is in the document yet, and no file is changed.</source>
        <translation>Reviseu primer les troballes. Encara no hi ha res al document, i no es canvia cap fitxer.</translation>
    </message>
    <message>
        <source>%1 organs: %2 with faults, %3 to check, %4 without problems. Nothing is in the document yet, and no file is changed.</source>
        <translation>%1 òrgans: %2 amb defectes, %3 per revisar, %4 sense problemes. Encara no hi ha res al document, i no es canvia cap fitxer.</translation>
    </message>
    <message>
        <source>%1 of %2 organs are not life-sized; a change of unit applies to all organs from surface files</source>
        <translation>%1 de %2 òrgans no són de mida natural; un canvi d’unitat s’aplica a tots els òrgans llegits de fitxers de superfície</translation>
    </message>
    <message>
        <source>%1: %2 of %3 organs</source>
        <translation>%1: %2 de %3 òrgans</translation>
    </message>
    <message>
        <source>Find an organ</source>
        <translation>Cerca un òrgan</translation>
    </message>
    <message>
        <source>Organs to show, by finding</source>
        <translation>Òrgans que es mostren, segons la troballa</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tots</translation>
    </message>
    <message>
        <source>Import all organs of this list</source>
        <translation>Importa tots els òrgans d’aquesta llista</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Import no organ of this list</source>
        <translation>No importis cap òrgan d’aquesta llista</translation>
    </message>
    <message numerus="yes">
        <source>Import %n organs</source>
        <translation>
            <numerusform>Importa %n òrgan</numerusform>
            <numerusform>Importa %n òrgans</numerusform>
        </translation>
    </message>
    <message>
        <source>Import as it is</source>
        <translation>Importa tal com és</translation>
    </message>
    <message>
        <source>All organs together</source>
        <translation>Tots els òrgans alhora</translation>
    </message>
    <message>
        <source>Every organ</source>
        <translation>Tots els òrgans</translation>
    </message>
    <message>
        <source>To check</source>
        <translation>Per revisar</translation>
    </message>
</context>
<context>
    <name>viscera::app::KeyBox</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Pose the organ in Deform mode and press Ctrl+K: each key stores that pose.</source>
        <translation>Poseu l’òrgan en postura en el mode Deforma i premeu Ctrl+K: cada clau desa aquella postura.</translation>
    </message>
    <message>
        <source>Time of the next key</source>
        <translation>Temps de la clau següent</translation>
    </message>
    <message>
        <source>Easing to the key after it</source>
        <translation>Transició fins a la clau següent</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Afegeix una clau</translation>
    </message>
    <message>
        <source>Store the present pose as a key (Ctrl+K)</source>
        <translation>Desa la postura actual com a clau (Ctrl+K)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>temps (s)</translation>
    </message>
    <message>
        <source>easing</source>
        <translation>transició</translation>
    </message>
    <message>
        <source>Take pose</source>
        <translation>Pren la postura</translation>
    </message>
    <message>
        <source>Set the present pose to that of this key</source>
        <translation>Posa com a postura actual la d’aquesta clau</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Substitueix</translation>
    </message>
    <message>
        <source>Store the present pose in this key</source>
        <translation>Desa la postura actual en aquesta clau</translation>
    </message>
    <message>
        <source>Remove this key</source>
        <translation>Elimina aquesta clau</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Reprodueix-la</translation>
    </message>
    <message>
        <source>Play the key sequence</source>
        <translation>Reprodueix la seqüència de claus</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Desa...</translation>
    </message>
    <message>
        <source>Save the sequence as a file</source>
        <translation>Desa la seqüència en un fitxer</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Obre...</translation>
    </message>
    <message>
        <source>Open a sequence file</source>
        <translation>Obre un fitxer de seqüència</translation>
    </message>
    <message>
        <source>Duration </source>
        <translation>Durada </translation>
    </message>
    <message>
        <source>Sequences (*%1)</source>
        <translation>Seqüències (*%1)</translation>
    </message>
    <message>
        <source>Save the sequence</source>
        <translation>Desa la seqüència</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Obre una seqüència</translation>
    </message>
</context>
<context>
    <name>viscera::app::KeySequencePlayback</name>
    <message>
        <source>Record a key at %1 s</source>
        <translation>Enregistra una clau a %1 s</translation>
    </message>
    <message>
        <source>Use a key&apos;s pose</source>
        <translation>Usa la postura d’una clau</translation>
    </message>
    <message>
        <source>Sequence saved as %1</source>
        <translation>Seqüència desada com a %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::LectureScreen</name>
    <message>
        <source>&amp;Lecture</source>
        <translation>C&amp;lasse</translation>
    </message>
    <message>
        <source>The view alone on the whole screen, in large letters; Page Down shows the next slide, Escape ends it</source>
        <translation>Només la vista a tota la pantalla, amb lletra grossa; Av Pàg mostra la diapositiva següent, Esc ho acaba</translation>
    </message>
    <message>
        <source>&amp;Darken the screen</source>
        <translation>&amp;Enfosqueix la pantalla</translation>
    </message>
    <message>
        <source>&amp;Pressures and volume</source>
        <translation>&amp;Pressions i volum</translation>
    </message>
    <message>
        <source>Pressure-volume &amp;loops</source>
        <translation>&amp;Bucles pressió-volum</translation>
    </message>
    <message>
        <source>&amp;Electrocardiogram</source>
        <translation>&amp;Electrocardiograma</translation>
    </message>
    <message>
        <source>Open &amp;valves</source>
        <translation>&amp;Vàlvules obertes</translation>
    </message>
    <message>
        <source>Heart &amp;sounds</source>
        <translation>&amp;Sorolls cardíacs</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonDialog</name>
    <message>
        <source>Handles that a reader can drag</source>
        <translation>Tiradors que el lector pot arrossegar</translation>
    </message>
    <message>
        <source>Web page for any browser (.html)</source>
        <translation>Pàgina web per a qualsevol navegador (.html)</translation>
    </message>
    <message>
        <source>Animated glTF scene (.glb)</source>
        <translation>Escena glTF animada (.glb)</translation>
    </message>
    <message>
        <source>Language of the page&apos;s buttons and messages; the texts below stay as they are</source>
        <translation>Llengua dels botons i missatges de la pàgina; els textos de sota es queden com estan</translation>
    </message>
    <message>
        <source>A reader of the lesson sees only these texts: it holds no file names, no dates and no hidden organs. Check the texts for names of patients; double-click a text to change it.</source>
        <translation>Qui llegeixi la lliçó només veurà aquests textos: no conté noms de fitxer, dates ni òrgans amagats. Comproveu que als textos no hi hagi noms de pacients; feu doble clic en un text per canviar-lo.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Títol</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Anomena i desa...</translation>
    </message>
    <message>
        <source>Texts of the lesson</source>
        <translation>Textos de la lliçó</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The shape of a head or a face can identify a patient.</source>
        <translation>La forma d’un cap o d’una cara pot identificar un pacient.</translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation>Llengua de la finestra</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonExport</name>
    <message>
        <source>Export &amp;lesson...</source>
        <translation>Exporta la &amp;lliçó...</translation>
    </message>
    <message>
        <source>Write the organs and their motion as one page that opens in any browser</source>
        <translation>Escriu els òrgans i el seu moviment en una pàgina que s’obre en qualsevol navegador</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pàgines web (*.html)</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb)</source>
        <translation>Escenes glTF (*.glb)</translation>
    </message>
    <message>
        <source>Exporting the lesson</source>
        <translation>S’exporta la lliçó</translation>
    </message>
    <message>
        <source>Written to %1 (%2 MB). The motion in the file differs by at most %3 mm.</source>
        <translation>S’ha escrit a %1 (%2 MB). El moviment del fitxer difereix en %3 mm com a màxim.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MainWindow</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Surt</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Fosc</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>C&amp;lar</translation>
    </message>
    <message>
        <source>%1: checked, no problems found</source>
        <translation>%1: comprovat, sense problemes</translation>
    </message>
    <message>
        <source>Viscera cancelled the drag because you chose another mode.</source>
        <translation>Viscera ha cancel·lat l’arrossegament perquè heu triat un altre mode.</translation>
    </message>
    <message>
        <source>Close without these files?</source>
        <translation>Voleu tancar sense aquests fitxers?</translation>
    </message>
    <message>
        <source>Viscera is still writing: %1.</source>
        <translation>Viscera encara escriu: %1.</translation>
    </message>
    <message>
        <source>If you close Viscera now, it does not finish these files.</source>
        <translation>Si tanqueu el Viscera ara, no acabarà aquests fitxers.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Tanca</translation>
    </message>
    <message>
        <source>&amp;Wait</source>
        <translation>&amp;Espera</translation>
    </message>
    <message>
        <source>View kept as %1</source>
        <translation>Vista desada com a %1</translation>
    </message>
    <message>
        <source>Writing a movie</source>
        <translation>Escriptura d’una pel·lícula</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>&amp;Configuració...</translation>
    </message>
    <message>
        <source>Language, theme, folders and what is shown at the start</source>
        <translation>Llengua, tema, carpetes i el que es mostra a l’inici</translation>
    </message>
</context>
<context>
    <name>viscera::app::MarksBox</name>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>Draw the values along the straight line at rest between two chosen probes, or between the last two</source>
        <translation>Dibuixa els valors al llarg de la recta en repòs entre dues sondes triades, o entre les dues últimes</translation>
    </message>
    <message>
        <source>Remove the chosen probes and profiles (Delete in the list)</source>
        <translation>Elimina les sondes i els perfils triats (Supr a la llista)</translation>
    </message>
    <message>
        <source>Probes and profiles</source>
        <translation>Sondes i perfils</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Núm.</translation>
    </message>
    <message>
        <source>%1: at rest %2 mm</source>
        <translation>%1: en repòs %2 mm</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>sense teixit</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm de llarg</translation>
    </message>
    <message>
        <source>Profile along the line between two probes; the value is the largest</source>
        <translation>Perfil al llarg de la línia entre dues sondes; el valor és el més gran</translation>
    </message>
    <message>
        <source>Place in the pose: towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S)</source>
        <translation>Lloc en la posa: cap a la dreta (R) o l’esquerra (L), el davant (A) o el darrere (P), els peus (I) o el cap (S)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasureBox</name>
    <message>
        <source>Remove the chosen measurement (Delete in the list)</source>
        <translation>Elimina la mesura triada (Supr a la llista)</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Elimina-ho tot</translation>
    </message>
    <message>
        <source>Export CSV...</source>
        <translation>Exporta CSV...</translation>
    </message>
    <message>
        <source>Points stay on the organ while it moves, and can be dragged along it; those on a slice go with the warped scan.</source>
        <translation>Els punts segueixen l’òrgan mentre es mou, i s’hi poden arrossegar; els d’un tall segueixen la imatge deformada.</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice. Esc ends.</source>
        <translation>Feu clic a dos punts d’un òrgan o d’un tall. Esc ho acaba.</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second. Esc ends.</source>
        <translation>Feu clic a tres punts d’un òrgan o d’un tall, el vèrtex en segon lloc. Esc ho acaba.</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner. Esc ends.</source>
        <translation>Arrossegueu sobre un tall de cantó a cantó. Esc ho acaba.</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border. Esc ends.</source>
        <translation>Arrossegueu sobre un tall del centre a la vora. Esc ho acaba.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasuredMotion</name>
    <message numerus="yes">
        <source>Motion of %n phases. Mean distance from the measured surfaces: %1.</source>
        <translation>
            <numerusform>Moviment de %n fase. Distància mitjana a les superfícies mesurades: %1.</numerusform>
            <numerusform>Moviment de %n fases. Distància mitjana a les superfícies mesurades: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The series does not show how points move along a wall. The mean and the 95th percentile over the beat are reliable, the local pattern of this map is not.</source>
        <translation>La sèrie no mostra com es mouen els punts al llarg d’una paret. La mitjana i el percentil 95 del batec són fiables; el patró local d’aquest mapa, no.</translation>
    </message>
    <message>
        <source>Leave out phase %1</source>
        <translation>Omet la fase %1</translation>
    </message>
    <message>
        <source>Surface of phase %1</source>
        <translation>Superfície de la fase %1</translation>
    </message>
    <message>
        <source>Distance from the measured surface</source>
        <translation>Distància al que s’ha mesurat</translation>
    </message>
    <message>
        <source>The search for the motion was cancelled.</source>
        <translation>S’ha cancel·lat la cerca del moviment.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases need attention: see the table beside the chart.</source>
        <translation>
            <numerusform>%n fase requereix atenció: vegeu la taula al costat del gràfic.</numerusform>
            <numerusform>%n fases requereixen atenció: vegeu la taula al costat del gràfic.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>An estimate of %n phases from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Una estimació de %n fase a partir de les imatges i les etiquetes de la fase %1 sola. Distància mitjana a les etiquetes i al teixit seguit: %2.</numerusform>
            <numerusform>Una estimació de %n fases a partir de les imatges i les etiquetes de la fase %1 sola. Distància mitjana a les etiquetes i al teixit seguit: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Motion of %n phases from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Moviment de %n fase a partir de les imatges i les etiquetes de les fases %1. Distància mitjana a les etiquetes i al teixit seguit: %2.</numerusform>
            <numerusform>Moviment de %n fases a partir de les imatges i les etiquetes de les fases %1. Distància mitjana a les etiquetes i al teixit seguit: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Motion from images</source>
        <translation>Moviment a partir d&apos;imatges</translation>
    </message>
    <message>
        <source>Not used for the motion</source>
        <translation>No s&apos;usa per al moviment</translation>
    </message>
    <message>
        <source>Estimate: %1</source>
        <translation>Estimació: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::Menus</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Desfés</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refés</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Desfés: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Refés: %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fitxer</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Obre un &amp;recent</translation>
    </message>
    <message>
        <source>Sample &amp;organs</source>
        <translation>Òr&amp;gans de mostra</translation>
    </message>
    <message>
        <source>Export &amp;more</source>
        <translation>Exporta &amp;més</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edita</translation>
    </message>
    <message>
        <source>&amp;Steps</source>
        <translation>&amp;Passos</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visualitza</translation>
    </message>
    <message>
        <source>St&amp;ress map</source>
        <translation>Mapa de t&amp;ensió</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>E&amp;xploració</translation>
    </message>
    <message>
        <source>&amp;Slides</source>
        <translation>&amp;Diapositives</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panells</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>The next start uses this language: %1.</source>
        <translation>El proper inici farà servir aquest idioma: %1.</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Com el &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>Ò&amp;rgan</translation>
    </message>
    <message>
        <source>Ha&amp;ndles</source>
        <translation>&amp;Tiradors</translation>
    </message>
    <message>
        <source>&amp;Mirror drags</source>
        <translation>Arrossegament &amp;simètric</translation>
    </message>
    <message>
        <source>&amp;Sequence</source>
        <translation>&amp;Seqüència</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Ajuda</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Encara no s’ha obert res</translation>
    </message>
    <message numerus="yes">
        <source>%n earlier steps</source>
        <translation>
            <numerusform>%n pas anterior</numerusform>
            <numerusform>%n passos anteriors</numerusform>
        </translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Tal com s’ha obert</translation>
    </message>
    <message>
        <source>No sample organs are installed</source>
        <translation>No hi ha instal·lat cap òrgan de mostra</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Mira des de</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Compara</translation>
    </message>
    <message>
        <source>S&amp;hown in lectures and movies</source>
        <translation>&amp;Mostrat a classes i pel·lícules</translation>
    </message>
</context>
<context>
    <name>viscera::app::MessageBar</name>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Tanca aquest missatge (Esc)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Tanca aquest missatge</translation>
    </message>
</context>
<context>
    <name>viscera::app::MotionDialog</name>
    <message>
        <source>Tissue around cavities</source>
        <translation>Teixit al voltant de cavitats</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usa</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omet</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Més</translation>
    </message>
    <message>
        <source>Find the motion</source>
        <translation>Troba el moviment</translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation>Carpeta...</translation>
    </message>
    <message>
        <source>Files...</source>
        <translation>Fitxers...</translation>
    </message>
    <message>
        <source>All phases, or one 4D NIfTI or .seq.nrrd</source>
        <translation>Totes les fases, o un NIfTI 4D o .seq.nrrd</translation>
    </message>
    <message>
        <source>Surfaces of the series</source>
        <translation>Superfícies de la sèrie</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Duration of one whole cycle: the number of phases times the step between them</source>
        <translation>Durada d’un cicle sencer: el nombre de fases per l’interval entre elles</translation>
    </message>
    <message>
        <source>The last phase leads back to the first</source>
        <translation>L’última fase torna a la primera</translation>
    </message>
    <message>
        <source>60 for one surface, 120 for several. More follow the surfaces more closely</source>
        <translation>60 per a una superfície, 120 per a diverses. Amb més se segueixen millor les superfícies</translation>
    </message>
    <message>
        <source>Keep the measured volumes exactly</source>
        <translation>Mantén exactament els volums mesurats</translation>
    </message>
    <message>
        <source>Larger distances count less: for label maps with outliers</source>
        <translation>Les distàncies grans compten menys: per a mapes d’etiquetes amb valors atípics</translation>
    </message>
    <message>
        <source>Distances count less beyond</source>
        <translation>Les distàncies compten menys a partir de</translation>
    </message>
    <message>
        <source>Leave out phases</source>
        <translation>Omet les fases</translation>
    </message>
    <message>
        <source>Folder with a series</source>
        <translation>Carpeta amb una sèrie</translation>
    </message>
    <message>
        <source>Phases of a series</source>
        <translation>Fases d’una sèrie</translation>
    </message>
    <message>
        <source>Reading the series</source>
        <translation>Es llegeix la sèrie</translation>
    </message>
    <message>
        <source>A single image shows no motion. Open it with File &gt; Open, then choose &quot;Fit a sequence to an organ&quot; in Play mode to give the heart and its chambers the textbook&apos;s beat.</source>
        <translation>Una sola imatge no mostra moviment. Obriu-la amb Fitxer &gt; Obre i trieu després «Ajusta una seqüència a un òrgan» en el mode Reprodueix per donar al cor i a les seves cavitats el batec del llibre de text.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Label %1; a double click gives the surface another name</source>
        <translation>Etiqueta %1; un doble clic canvia el nom de la superfície</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 per minut</translation>
    </message>
    <message>
        <source>The files do not state it</source>
        <translation>Els fitxers no ho indiquen</translation>
    </message>
    <message>
        <source>No series is chosen.</source>
        <translation>No s’ha triat cap sèrie.</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>Es llegeix %1 ...</translation>
    </message>
    <message numerus="yes">
        <source>%1: label maps, %n phases</source>
        <translation>
            <numerusform>%1: mapes d’etiquetes, %n fase</numerusform>
            <numerusform>%1: mapes d’etiquetes, %n fases</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: surfaces, %n phases</source>
        <translation>
            <numerusform>%1: superfícies, %n fase</numerusform>
            <numerusform>%1: superfícies, %n fases</numerusform>
        </translation>
    </message>
    <message>
        <source>Working...</source>
        <translation>En curs...</translation>
    </message>
    <message>
        <source>Enter the duration of one cycle first</source>
        <translation>Introduïu primer la durada d’un cicle</translation>
    </message>
    <message>
        <source>Outer surface</source>
        <translation>Superfície externa</translation>
    </message>
    <message>
        <source>%1 is not a phase</source>
        <translation>%1 no és una fase</translation>
    </message>
    <message>
        <source>name phases by their numbers, counted from 1, as in 3, 7</source>
        <translation>indiqueu les fases amb el número, comptant des d’1, p. ex. 3, 7</translation>
    </message>
    <message>
        <source>Choose a series first</source>
        <translation>Trieu primer una sèrie</translation>
    </message>
    <message>
        <source>A single image shows no motion</source>
        <translation>Una sola imatge no mostra moviment</translation>
    </message>
    <message>
        <source>Turns one organ, given in several phases of a cycle, into handles and a key sequence with a key for each phase. Choose surfaces or label maps, one file for each phase, or one file with several phases. The result replaces the open organs; Undo brings them back.</source>
        <translation>Converteix un òrgan, donat en diverses fases d’un cicle, en tiradors i una seqüència de claus, una clau per a cada fase. Trieu superfícies o mapes d’etiquetes, un fitxer per fase, o un fitxer amb diverses fases. El resultat substitueix els òrgans oberts; Desfés els recupera.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automàtic</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sense límit</translation>
    </message>
    <message>
        <source>For example 3, 7</source>
        <translation>Per exemple 3, 7</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Funció</translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation>Funció de %1</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Cancel·la la cerca</translation>
    </message>
    <message>
        <source>What the motion is found from</source>
        <translation>A partir de què es troba el moviment</translation>
    </message>
    <message>
        <source>Labels or surfaces of every phase</source>
        <translation>Etiquetes o superfícies de cada fase</translation>
    </message>
    <message>
        <source>Cine images, and labels of a few phases</source>
        <translation>Imatges de cine i etiquetes d&apos;algunes fases</translation>
    </message>
    <message>
        <source>Turns the labels of a few phases, the ends of diastole and systole at least, and cine images of the whole cycle into handles and a key sequence with a key for each phase. Volumes of labelled phases are exact; the images show the others. One labelled phase gives an estimate. The result replaces the open organs; Undo brings them back.</source>
        <translation>Converteix les etiquetes d&apos;algunes fases, com a mínim dels finals de diàstole i sístole, i les imatges de cine de tot el cicle en tiradors i una seqüència de claus, una clau per a cada fase. Els volums de les fases etiquetades són exactes; les imatges mostren els altres. Una sola fase etiquetada dona una estimació. El resultat substitueix els òrgans oberts; Desfés els recupera.</translation>
    </message>
    <message>
        <source>Leave out series</source>
        <translation>Omet sèries</translation>
    </message>
    <message>
        <source>The labels are being read</source>
        <translation>S&apos;estan llegint les etiquetes</translation>
    </message>
    <message>
        <source>Choose other labels: these cannot be read</source>
        <translation>Trieu altres etiquetes: aquestes no es poden llegir</translation>
    </message>
    <message>
        <source>%1 is not the number of a series</source>
        <translation>%1 no és el número d&apos;una sèrie</translation>
    </message>
    <message>
        <source>name series by their numbers, as in 3, 7</source>
        <translation>anomeneu les sèries pels seus números, com a 3, 7</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieBox</name>
    <message>
        <source>Choose a destination</source>
        <translation>Tria la destinació</translation>
    </message>
    <message>
        <source> / s</source>
        <translation> / s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogrames</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Cicles</translation>
    </message>
    <message>
        <source>Write phase and volumes into it</source>
        <translation>Escriu-hi la fase i els volums</translation>
    </message>
    <message>
        <source>Table of volumes beside it (.csv)</source>
        <translation>Taula de volums al costat (.csv)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistra</translation>
    </message>
    <message>
        <source>Record what the view shows</source>
        <translation>Enregistra el que mostra la vista</translation>
    </message>
    <message>
        <source>MP4 and GIF need the program ffmpeg, which is not installed on this computer.</source>
        <translation>MP4 i GIF necessiten el programa ffmpeg, que no està instal·lat en aquest ordinador.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Carpeta per a les imatges</translation>
    </message>
    <message>
        <source>Record as</source>
        <translation>Enregistra com a</translation>
    </message>
    <message>
        <source>Cancel the movie</source>
        <translation>Cancel·la la pel·lícula</translation>
    </message>
    <message>
        <source>Discard the movie</source>
        <translation>Descarta la pel·lícula</translation>
    </message>
</context>
<context>
    <name>viscera::app::MoviePlan</name>
    <message>
        <source>Ogg movie (.ogv)</source>
        <translation>Pel·lícula Ogg (.ogv)</translation>
    </message>
    <message>
        <source>MP4 movie (.mp4)</source>
        <translation>Pel·lícula MP4 (.mp4)</translation>
    </message>
    <message>
        <source>Animated GIF (.gif)</source>
        <translation>GIF animat (.gif)</translation>
    </message>
    <message>
        <source>PNG pictures (folder)</source>
        <translation>Imatges PNG (carpeta)</translation>
    </message>
    <message>
        <source>Table of volumes (.csv)</source>
        <translation>Taula de volums (.csv)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieRecorder</name>
    <message>
        <source>Recording %1</source>
        <translation>S’enregistra %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::NumbersTable</name>
    <message>
        <source>Numbers of the circulation</source>
        <translation>Valors de la circulació</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganCheck</name>
    <message>
        <source>%1, open</source>
        <translation>%1, oberta</translation>
    </message>
    <message>
        <source>Import this organ</source>
        <translation>Importa aquest òrgan</translation>
    </message>
    <message numerus="yes">
        <source>%n checks passed</source>
        <translation>
            <numerusform>%n comprovació superada</numerusform>
            <numerusform>%n comprovacions superades</numerusform>
        </translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Fet: %1</translation>
    </message>
    <message>
        <source>More repairs</source>
        <translation>Més reparacions</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Com al fitxer</translation>
    </message>
    <message>
        <source>Undo the repairs of this organ</source>
        <translation>Desfés les reparacions d’aquest òrgan</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganMenu</name>
    <message>
        <source>&amp;Lock volume</source>
        <translation>B&amp;loqueja el volum</translation>
    </message>
    <message>
        <source>Keep the organ&apos;s volume constant in Deform mode; for an organ with cavities, the volume within its outer surface</source>
        <translation>Manté constant el volum de l’òrgan en el mode Deforma; en un òrgan amb cavitats, el volum dins de la superfície externa</translation>
    </message>
    <message>
        <source>The organ&apos;s own colours</source>
        <translation>Colors propis de l’òrgan</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Canvia el color</translation>
    </message>
    <message>
        <source>&amp;Shortest distance of two organs</source>
        <translation>Di&amp;stància més curta de dos òrgans</translation>
    </message>
    <message>
        <source>Two organs</source>
        <translation>Dos òrgans</translation>
    </message>
    <message>
        <source>Choose two organs in the list: the distance follows them, wherever they are nearest</source>
        <translation>Trieu dos òrgans a la llista: la distància els segueix, on sigui que estiguin més a prop</translation>
    </message>
    <message>
        <source>Choose two organs in the list first, the second one with Ctrl.</source>
        <translation>Trieu primer dos òrgans a la llista, el segon amb Ctrl.</translation>
    </message>
    <message>
        <source>&amp;Bends as soft tissue</source>
        <translation>Es do&amp;blega com a teixit tou</translation>
    </message>
    <message>
        <source>Every place of the organ follows the handles</source>
        <translation>Cada lloc de l’òrgan segueix els tiradors</translation>
    </message>
    <message>
        <source>Moves as a r&amp;igid body</source>
        <translation>Es mou com a cos ríg&amp;id</translation>
    </message>
    <message>
        <source>The organ keeps its shape and moves as the tissue around it does on the whole; so do bones</source>
        <translation>L’òrgan manté la seva forma i es mou com el teixit que l’envolta en conjunt; així també els ossos</translation>
    </message>
    <message>
        <source>Stays in &amp;place</source>
        <translation>&amp;Roman al seu lloc</translation>
    </message>
    <message>
        <source>No handle moves the organ</source>
        <translation>Cap tirador no mou l’òrgan</translation>
    </message>
    <message>
        <source>Textbook colours</source>
        <translation>Colors dels manuals</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganPanel</name>
    <message>
        <source>Opacity</source>
        <translation>Opacitat</translation>
    </message>
    <message>
        <source>No organ yet.
Open a file (Ctrl+O), drop one here, or take a sample organ from the menu.</source>
        <translation>Encara no hi ha cap òrgan.
Obriu un fitxer (Ctrl+O), deixeu-ne anar un aquí o agafeu un òrgan de mostra del menú.</translation>
    </message>
    <message>
        <source>Find an organ (Ctrl+F)</source>
        <translation>Cerca un òrgan (Ctrl+F)</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Canvia l’opacitat</translation>
    </message>
    <message>
        <source>Show &amp;only this</source>
        <translation>Mostra &amp;només aquest</translation>
    </message>
    <message>
        <source>Show the chosen organs with their cavities and hide all others</source>
        <translation>Mostra els òrgans triats amb les seves cavitats i amaga tots els altres</translation>
    </message>
    <message>
        <source>&amp;Hide this</source>
        <translation>&amp;Amaga’l</translation>
    </message>
    <message>
        <source>Hide the chosen organs</source>
        <translation>Amaga els òrgans triats</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostra’ls &amp;tots</translation>
    </message>
    <message>
        <source>Show every organ</source>
        <translation>Mostra tots els òrgans</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostra’ls tots</translation>
    </message>
    <message>
        <source>&amp;Find an organ</source>
        <translation>&amp;Cerca un òrgan</translation>
    </message>
    <message>
        <source>Type a part of its name</source>
        <translation>Escriviu una part del nom</translation>
    </message>
    <message>
        <source>Re&amp;name organ</source>
        <translation>Canvia el &amp;nom de l’òrgan</translation>
    </message>
    <message>
        <source>&amp;Remove organ</source>
        <translation>&amp;Elimina l’òrgan</translation>
    </message>
    <message>
        <source>Hide all of them (click)</source>
        <translation>Amaga’ls tots (clic)</translation>
    </message>
    <message>
        <source>Show all of them (click)</source>
        <translation>Mostra’ls tots (clic)</translation>
    </message>
    <message>
        <source>Hide (click)</source>
        <translation>Amaga (clic)</translation>
    </message>
    <message>
        <source>Show (click)</source>
        <translation>Mostra (clic)</translation>
    </message>
    <message numerus="yes">
        <source>%1
%n triangles</source>
        <translation>
            <numerusform>%1
%n triangle</numerusform>
            <numerusform>%1
%n triangles</numerusform>
        </translation>
    </message>
    <message>
        <source>
Double click or F2 renames; a click on the square changes the colour</source>
        <translation>
Doble clic o F2 canvia el nom; un clic al quadrat canvia el color</translation>
    </message>
    <message>
        <source>An open surface has no volume to lock; click to close its holes</source>
        <translation>Una superfície oberta no té volum per bloquejar; feu clic per tancar-ne els forats</translation>
    </message>
    <message>
        <source>The volume is locked: Deform mode keeps it (click or K to unlock)</source>
        <translation>El volum està bloquejat: el mode Deforma el manté (clic o K per desbloquejar-lo)</translation>
    </message>
    <message>
        <source>Lock the volume (click or K)</source>
        <translation>Bloqueja el volum (clic o K)</translation>
    </message>
    <message>
        <source>
This is the volume within the outer surface; cavities have locks of their own</source>
        <translation>
És el volum dins de la superfície externa; les cavitats tenen bloquejos propis</translation>
    </message>
    <message>
        <source>
This is the volume of the cavity; the wall around it has a lock of its own</source>
        <translation>
És el volum de la cavitat; la paret que l’envolta té un bloqueig propi</translation>
    </message>
    <message>
        <source>open</source>
        <translation>oberta</translation>
    </message>
    <message>
        <source>An open surface encloses no volume</source>
        <translation>Una superfície oberta no tanca cap volum</translation>
    </message>
    <message>
        <source>%1 at rest, %2 (%3) now</source>
        <translation>%1 en repòs, %2 (%3) ara</translation>
    </message>
    <message numerus="yes">
        <source>%n organs removed</source>
        <translation>
            <numerusform>S’ha eliminat %n òrgan</numerusform>
            <numerusform>S’han eliminat %n òrgans</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs and all handles removed</source>
        <translation>
            <numerusform>S’han eliminat %n òrgan i tots els tiradors</numerusform>
            <numerusform>S’han eliminat %n òrgans i tots els tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 de %3)</translation>
    </message>
    <message>
        <source>The sample organ is being made.</source>
        <translation>S’està creant l’òrgan d’exemple.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PanelDock</name>
    <message>
        <source>Float or dock the panel %1</source>
        <translation>Fes flotar o acobla el panell %1</translation>
    </message>
    <message>
        <source>Hide the panel %1 (the View menu shows it again)</source>
        <translation>Amaga el panell %1 (el menú Visualitza el torna a mostrar)</translation>
    </message>
</context>
<context>
    <name>viscera::app::PasswordDialog</name>
    <message>
        <source>Keep it in the system&apos;s key ring</source>
        <translation>Desa-la a l&apos;anell de claus del sistema</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contrasenya</translation>
    </message>
    <message>
        <source>Password of %1 at %2</source>
        <translation>Contrasenya de %1 a %2</translation>
    </message>
    <message>
        <source>Else Viscera asks again after the next start</source>
        <translation>Si no, Viscera torna a preguntar després del pròxim inici</translation>
    </message>
    <message>
        <source>There is no key ring; Viscera asks again after the next start</source>
        <translation>No hi ha anell de claus; Viscera torna a preguntar després del pròxim inici</translation>
    </message>
    <message>
        <source>The archive refuses the user name or the password.</source>
        <translation>L&apos;arxiu rebutja el nom d&apos;usuari o la contrasenya.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PatientOffer</name>
    <message>
        <source>Searching beside %1</source>
        <translation>Se cerca al costat de %1</translation>
    </message>
    <message>
        <source>Open the scan</source>
        <translation>Obre l’exploració</translation>
    </message>
    <message>
        <source>Open its organs</source>
        <translation>Obre’n els òrgans</translation>
    </message>
    <message>
        <source>The scan %2 has the same voxels as %1.</source>
        <translation>L’exploració %2 té els mateixos vòxels que %1.</translation>
    </message>
    <message>
        <source>The label map %2 has the same voxels as %1.</source>
        <translation>El mapa d’etiquetes %2 té els mateixos vòxels que %1.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PersonBox</name>
    <message>
        <source>Women and men</source>
        <translation>Dones i homes</translation>
    </message>
    <message>
        <source>Women</source>
        <translation>Dones</translation>
    </message>
    <message>
        <source>Men</source>
        <translation>Homes</translation>
    </message>
    <message>
        <source>Whose normal ranges are shown</source>
        <translation>De qui es mostren els intervals normals</translation>
    </message>
    <message>
        <source> m²</source>
        <translation> m²</translation>
    </message>
    <message>
        <source>any body surface area</source>
        <translation>tota superfície corporal</translation>
    </message>
    <message>
        <source>Body surface area: ranges that the source gives per square metre are scaled by it</source>
        <translation>Superfície corporal: escala els intervals que la font dona per metre quadrat</translation>
    </message>
</context>
<context>
    <name>viscera::app::PhaseScrubber</name>
    <message>
        <source>Instant of the cycle</source>
        <translation>Instant del cicle</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys</source>
        <translation>Arrossegueu, o feu servir les fletxes</translation>
    </message>
    <message>
        <source>ED</source>
        <translation>ED</translation>
    </message>
    <message>
        <source>ES</source>
        <translation>ES</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlaneTable</name>
    <message>
        <source>Plane</source>
        <translation>Pla</translation>
    </message>
    <message>
        <source>in this phase</source>
        <translation>en aquesta fase</translation>
    </message>
    <message>
        <source>weight %</source>
        <translation>pes %</translation>
    </message>
    <message>
        <source>likeness %</source>
        <translation>semblança %</translation>
    </message>
    <message>
        <source>arrives mm</source>
        <translation>arribada mm</translation>
    </message>
    <message>
        <source>apart mm</source>
        <translation>separació mm</translation>
    </message>
    <message>
        <source>over the beat</source>
        <translation>durant el batec</translation>
    </message>
    <message>
        <source>Series or slice, and what it shows of the heart</source>
        <translation>Sèrie o tall, i què mostra del cor</translation>
    </message>
    <message>
        <source>What the plane says of the phase that is shown</source>
        <translation>El que el pla diu de la fase mostrada</translation>
    </message>
    <message>
        <source>Mean weight of its contours over the beat</source>
        <translation>Pes mitjà dels seus contorns durant el batec</translation>
    </message>
    <message>
        <source>How alike its images are around the wall, over the beat</source>
        <translation>Com s&apos;assemblen les seves imatges al voltant de la paret, durant el batec</translation>
    </message>
    <message>
        <source>How far its tissue arrives from the next labelled surface</source>
        <translation>A quina distància de la següent superfície etiquetada arriba el seu teixit</translation>
    </message>
    <message>
        <source>Distance of its tissue from the surfaces</source>
        <translation>Distància del seu teixit a les superfícies</translation>
    </message>
    <message>
        <source>Why the plane says little</source>
        <translation>Per què el pla diu poc</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bo</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayMode</name>
    <message>
        <source>Play</source>
        <translation>Reprodueix</translation>
    </message>
    <message>
        <source>Space plays or pauses; drag the timeline to look at one instant</source>
        <translation>Espai reprodueix o posa en pausa; arrossegueu la línia de temps per veure un instant</translation>
    </message>
    <message>
        <source>Slow &amp;motion</source>
        <translation>Càmera &amp;lenta</translation>
    </message>
    <message>
        <source>Slower, down to a tenth; then real time again</source>
        <translation>Més lent, fins a una dècima; després torna al temps real</translation>
    </message>
    <message>
        <source>&amp;Chart of one cycle</source>
        <translation>&amp;Gràfic d’un cicle</translation>
    </message>
    <message>
        <source>Draw one cycle with a cursor instead of the last seconds</source>
        <translation>Dibuixa un cicle amb un cursor en comptes dels últims segons</translation>
    </message>
    <message>
        <source>&amp;ECG, sounds and valves</source>
        <translation>&amp;ECG, sorolls i vàlvules</translation>
    </message>
    <message>
        <source>Under the phases of a heart: a schematic electrocardiogram, S1 and S2, and which valves are open</source>
        <translation>Sota les fases d’un cor: un electrocardiograma esquemàtic, S1 i S2, i quines vàlvules són obertes</translation>
    </message>
    <message>
        <source>&amp;Valves and flow</source>
        <translation>&amp;Vàlvules i flux</translation>
    </message>
    <message>
        <source>Record a &amp;key</source>
        <translation>Enregistra una &amp;clau</translation>
    </message>
    <message>
        <source>Add the present pose to the key sequence</source>
        <translation>Afegeix la postura actual a la seqüència de claus</translation>
    </message>
    <message>
        <source>Motion from a ser&amp;ies...</source>
        <translation>Moviment a partir d’una &amp;sèrie...</translation>
    </message>
    <message>
        <source>Compare two &amp;rates</source>
        <translation>Compara dues &amp;freqüències</translation>
    </message>
    <message>
        <source>Show the same organs beside these at another rate, or with the circulation kept as before</source>
        <translation>Mostra al costat els mateixos òrgans a una altra freqüència, o amb la circulació guardada com a anterior</translation>
    </message>
    <message>
        <source>Compare &amp;coordinates</source>
        <translation>Compara &amp;coordenades</translation>
    </message>
    <message>
        <source>Show the same organs and handles beside these with another coordinate system</source>
        <translation>Mostra al costat els mateixos òrgans i tiradors amb un altre sistema de coordenades</translation>
    </message>
    <message>
        <source>Compare with another &amp;organ...</source>
        <translation>Compara amb un altre ò&amp;rgan...</translation>
    </message>
    <message>
        <source>Open files in a second view beside these organs</source>
        <translation>Obre fitxers en una segona vista al costat d’aquests òrgans</translation>
    </message>
    <message>
        <source>Compare with the te&amp;xtbook&apos;s heart</source>
        <translation>Compara amb el cor de &amp;llibre</translation>
    </message>
    <message>
        <source>Show the sample heart with its textbook beat beside these organs, at their rate</source>
        <translation>Mostra el cor de mostra amb el batec de llibre al costat d’aquests òrgans, a la mateixa freqüència</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>&amp;Una vista</translation>
    </message>
    <message>
        <source>Close the second view</source>
        <translation>Tanca la segona vista</translation>
    </message>
    <message>
        <source>&amp;Pressures and loops</source>
        <translation>&amp;Pressions i bucles</translation>
    </message>
    <message>
        <source>Where a circulation moves the heart, show its curves below the view instead of the volumes</source>
        <translation>Si una circulació mou el cor, mostra’n les corbes sota la vista en comptes dels volums</translation>
    </message>
    <message>
        <source>Keep circ&amp;ulation for comparison</source>
        <translation>Guarda la circulació per comp&amp;arar</translation>
    </message>
    <message>
        <source>Keep this circulation to compare with: dashed loops and a second column of numbers</source>
        <translation>Guarda aquesta circulació per comparar-hi: bucles discontinus i una segona columna de valors</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Acaba la comparació</translation>
    </message>
    <message>
        <source>Organ &amp;labels</source>
        <translation>Etiqu&amp;etes dels òrgans</translation>
    </message>
    <message>
        <source>Write names beside the organs</source>
        <translation>Escriu els noms al costat dels òrgans</translation>
    </message>
    <message>
        <source>See &amp;through</source>
        <translation>&amp;Transparent</translation>
    </message>
    <message>
        <source>Make the wall translucent, so that the cavities are seen</source>
        <translation>Fa translúcida la paret perquè es vegin les cavitats</translation>
    </message>
    <message>
        <source>See through</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Key at %1 s</source>
        <translation>Clau a %1 s</translation>
    </message>
    <message>
        <source>Recorded as %1</source>
        <translation>Enregistrat com a %1</translation>
    </message>
    <message>
        <source>Compare with the present &amp;pose</source>
        <translation>Compara amb la pos&amp;tura actual</translation>
    </message>
    <message>
        <source>Only the sample heart has valves to show</source>
        <translation>Només el cor de mostra té vàlvules per mostrar</translation>
    </message>
    <message>
        <source>In the beating sample heart: leaflets as far open as the valves are, and arrows whose width shows the opening and whose length shows the speed of the blood</source>
        <translation>En el cor de mostra que batega: valves tan obertes com les vàlvules, i fletxes que mostren amb l’amplada l’obertura i amb la llargada la velocitat de la sang</translation>
    </message>
    <message>
        <source>This sequence has no valves; choose the heartbeat</source>
        <translation>Aquesta seqüència no té vàlvules; trieu el batec del cor</translation>
    </message>
    <message>
        <source>Show the present pose in a second view, to compare it with later poses</source>
        <translation>Mostra la postura actual en una segona vista, per comparar-la amb postures posteriors</translation>
    </message>
    <message>
        <source>&amp;Discard kept circulation</source>
        <translation>&amp;Descarta la circulació guardada</translation>
    </message>
    <message>
        <source>Make the wall opaque</source>
        <translation>Fes opaca la paret</translation>
    </message>
    <message>
        <source>The movie does not show distance colours, measured surfaces or warped slices.</source>
        <translation>La pel·lícula no mostra els colors de les distàncies, ni superfícies mesurades ni talls deformats.</translation>
    </message>
    <message>
        <source>Below the view, show curves and bull&apos;s eye of the heart&apos;s strain instead of the volumes</source>
        <translation>Mostra sota la vista les corbes i l’ull de bou de la deformació del cor en lloc dels volums</translation>
    </message>
    <message>
        <source>Colour the heart&apos;s wall by the strain of its segments; a click chooses one</source>
        <translation>Acoloreix la paret del cor segons la deformació dels seus segments; un clic en tria un</translation>
    </message>
    <message>
        <source>Compute a patient&apos;s own motion from surfaces or label maps of each phase of the cycle, or from cine images and the labels of a few phases</source>
        <translation>Calcula el moviment propi d&apos;un pacient a partir de superfícies o mapes d&apos;etiquetes de cada fase del cicle, o d&apos;imatges de cine i les etiquetes d&apos;algunes fases</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayPage</name>
    <message>
        <source>Appearance</source>
        <translation>Aspecte</translation>
    </message>
    <message>
        <source>Source of the motion</source>
        <translation>Origen del moviment</translation>
    </message>
    <message>
        <source>During one cycle</source>
        <translation>Al llarg del cicle</translation>
    </message>
    <message>
        <source>max</source>
        <translation>màx</translation>
    </message>
    <message>
        <source>min</source>
        <translation>mín</translation>
    </message>
    <message>
        <source>SV</source>
        <translation>VS</translation>
    </message>
    <message>
        <source>EF</source>
        <translation>FE</translation>
    </message>
    <message>
        <source>Volumes in ml. SV is the stroke volume, EF the ejection fraction.</source>
        <translation>Volums en ml. VS és el volum sistòlic, FE la fracció d’ejecció.</translation>
    </message>
    <message>
        <source>Circulation of this heart</source>
        <translation>Circulació d’aquest cor</translation>
    </message>
    <message>
        <source>Finds pressures, loops and sounds for the volume and the ejection fraction of this left ventricle. The organ keeps its own motion.</source>
        <translation>Calcula pressions, bucles i sorolls per al volum i la fracció d’ejecció d’aquest ventricle esquerre. L’òrgan conserva el seu propi moviment.</translation>
    </message>
    <message>
        <source>Record a movie</source>
        <translation>Enregistra una pel·lícula</translation>
    </message>
    <message>
        <source>Key sequence</source>
        <translation>Seqüència de claus</translation>
    </message>
    <message>
        <source>Fit a sequence to an organ</source>
        <translation>Ajusta una seqüència a un òrgan</translation>
    </message>
    <message>
        <source>%1 / min, one cycle %2 s</source>
        <translation>%1 / min, un cicle %2 s</translation>
    </message>
    <message>
        <source>%1, measured on the surfaces. Healthy adults: %2</source>
        <translation>%1, mesurat a les superfícies. Adults sans: %2</translation>
    </message>
    <message>
        <source>%1: %2; %3</source>
        <translation>%1: %2; %3</translation>
    </message>
    <message>
        <source>Normal for %1: %2.</source>
        <translation>Normal per a %1: %2.</translation>
    </message>
    <message>
        <source>An estimate: only one phase of the images has labels</source>
        <translation>Una estimació: només una fase de les imatges té etiquetes</translation>
    </message>
</context>
<context>
    <name>viscera::app::Playback</name>
    <message>
        <source>The sequence %1 moves its own handles, but the document has others.</source>
        <translation>La seqüència %1 mou els seus propis tiradors, però el document en té uns altres.</translation>
    </message>
    <message>
        <source>Use its handles</source>
        <translation>Fes servir els seus</translation>
    </message>
    <message>
        <source>posed by hand</source>
        <translation>posat a mà</translation>
    </message>
</context>
<context>
    <name>viscera::app::PoseEditor</name>
    <message numerus="yes">
        <source>Reset %n handles</source>
        <translation>
            <numerusform>Restableix %n tirador</numerusform>
            <numerusform>Restableix %n tiradors</numerusform>
        </translation>
    </message>
    <message>
        <source>The handles could not move back all the way: %1.</source>
        <translation>Els tiradors no han pogut tornar del tot: %1.</translation>
    </message>
    <message>
        <source>Volume %1</source>
        <translation>Volum de %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 is open (%n boundary edges), so it has no volume that could be locked.</source>
        <translation>
            <numerusform>%1 és una superfície oberta (%n aresta de vora): no té volum per bloquejar.</numerusform>
            <numerusform>%1 és una superfície oberta (%n arestes de vora): no té volum per bloquejar.</numerusform>
        </translation>
    </message>
    <message>
        <source>Close the holes and lock</source>
        <translation>Tanca els forats i bloqueja</translation>
    </message>
    <message>
        <source>Close holes and lock volume</source>
        <translation>Tanca els forats i bloqueja el volum</translation>
    </message>
    <message>
        <source>These organs are open, so they have no volumes that could be locked: %1.</source>
        <translation>Aquests òrgans són oberts i no tenen cap volum que es pugui bloquejar: %1.</translation>
    </message>
    <message>
        <source>the locked volume leaves %1 of %2 mm</source>
        <translation>el volum bloquejat deixa %1 de %2 mm</translation>
    </message>
    <message>
        <source>Move exactly, others compensate</source>
        <translation>Mou exactament, els altres compensen</translation>
    </message>
</context>
<context>
    <name>viscera::app::PositionBox</name>
    <message>
        <source>No handle is selected. Click one in the view or in the list.</source>
        <translation>No hi ha cap tirador seleccionat. Feu clic en un a la vista o a la llista.</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Tirador %1</translation>
    </message>
    <message>
        <source>, %1 mm from rest</source>
        <translation>, a %1 mm del repòs</translation>
    </message>
    <message>
        <source>, locked</source>
        <translation>, bloquejat</translation>
    </message>
    <message>
        <source>Place in the patient</source>
        <translation>Lloc en el pacient</translation>
    </message>
    <message>
        <source>Right or left</source>
        <translation>Dreta o esquerra</translation>
    </message>
    <message>
        <source>Front or back</source>
        <translation>Davant o darrere</translation>
    </message>
    <message>
        <source>Foot or head</source>
        <translation>Peus o cap</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProbeCard</name>
    <message>
        <source>Surface point %1</source>
        <translation>Punt de superfície %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Witness point %1</source>
        <translation>Punt testimoni %1</translation>
    </message>
    <message>
        <source>At rest %1 mm</source>
        <translation>En repòs %1 mm</translation>
    </message>
    <message>
        <source>Towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S), mm</source>
        <translation>Cap a la dreta (R) o l’esquerra (L), el davant (A) o el darrere (P), els peus (I) o el cap (S), mm</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProfileChart</name>
    <message>
        <source>Profile along the line</source>
        <translation>Perfil al llarg de la línia</translation>
    </message>
</context>
<context>
    <name>viscera::app::QuizTool</name>
    <message>
        <source>%1 right, %2 wrong</source>
        <translation>%1 correctes, %2 incorrectes</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Cap de les dues</translation>
    </message>
    <message>
        <source>%1: which valve is open?</source>
        <translation>%1: quina vàlvula és oberta?</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>No. %1</translation>
    </message>
    <message>
        <source>Click: %1</source>
        <translation>Feu clic a: %1</translation>
    </message>
    <message>
        <source>All %1 found without a mistake.</source>
        <translation>S’han trobat totes (%1) sense cap error.</translation>
    </message>
    <message numerus="yes">
        <source>All %1 found, with %n mistakes.</source>
        <translation>
            <numerusform>S’han trobat totes (%1), amb %n error.</numerusform>
            <numerusform>S’han trobat totes (%1), amb %n errors.</numerusform>
        </translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Correcte: %1</translation>
    </message>
    <message>
        <source>No, that is nearer to: %1</source>
        <translation>No, això és més a prop de: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::RepairValueBox</name>
    <message>
        <source>Unit</source>
        <translation>Unitat</translation>
    </message>
    <message>
        <source>Life size</source>
        <translation>Mida natural</translation>
    </message>
    <message>
        <source>The factor by which the organ gets the usual volume of its kind</source>
        <translation>El factor amb què l’òrgan obté el volum habitual dels seus</translation>
    </message>
    <message>
        <source>About %1 triangles. Details smaller than %2 mm are lost.</source>
        <translation>Uns %1 triangles. Es perden els detalls de menys de %2 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Repairs</name>
    <message>
        <source>Turn triangles outward</source>
        <translation>Orienta cap enfora</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Omple els forats</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>Conserva la peça més gran</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>Refés la malla</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Inverteix esquerra i dreta</translation>
    </message>
    <message>
        <source>Convert from RAS to LPS</source>
        <translation>Converteix de RAS a LPS</translation>
    </message>
    <message>
        <source>Convert from Y up to LPS</source>
        <translation>Converteix de Y amunt a LPS</translation>
    </message>
    <message>
        <source>Coordinates are in %1</source>
        <translation>Les coordenades són en %1</translation>
    </message>
    <message>
        <source>Remove small fragments</source>
        <translation>Elimina els fragments petits</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
</context>
<context>
    <name>viscera::app::ReportExport</name>
    <message>
        <source>&amp;Report...</source>
        <translation>&amp;Informe...</translation>
    </message>
    <message>
        <source>Write pictures, volumes, measurements, stress and motion as PDF or as one HTML page</source>
        <translation>Escriu imatges, volums, mesures, tensió i moviment en PDF o en una sola pàgina HTML</translation>
    </message>
    <message>
        <source>&amp;Copy as commands</source>
        <translation>&amp;Copia com a ordres</translation>
    </message>
    <message>
        <source>Copy the session as a script of viscera commands that gives the same result</source>
        <translation>Copia la sessió com un script d’ordres de viscera que dona el mateix resultat</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf);;Web pages (*.html)</source>
        <translation>Documents PDF (*.pdf);;Pàgines web (*.html)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>S’escriu l’informe</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pages.</source>
        <translation>
            <numerusform>%1: %n pàgina.</numerusform>
            <numerusform>%1: %n pàgines.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copying as commands</source>
        <translation>Es copia com a ordres</translation>
    </message>
    <message numerus="yes">
        <source>%n commands are in the clipboard.</source>
        <translation>
            <numerusform>Hi ha %n ordre al porta-retalls.</numerusform>
            <numerusform>Hi ha %n ordres al porta-retalls.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ResectionBox</name>
    <message>
        <source>Volumes on both sides of the cut</source>
        <translation>Volums a banda i banda del tall</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Tallat</translation>
    </message>
    <message>
        <source>The volumes of the visible, closed organs on both sides of the plane, in this pose</source>
        <translation>Els volums dels òrgans visibles i tancats a banda i banda del pla, en aquesta posa</translation>
    </message>
    <message>
        <source>Cut face %1 cm²</source>
        <translation>Cara del tall %1 cm²</translation>
    </message>
</context>
<context>
    <name>viscera::app::ResidualTable</name>
    <message>
        <source>largest volume</source>
        <translation>volum màxim</translation>
    </message>
    <message>
        <source>smallest volume</source>
        <translation>volum mínim</translation>
    </message>
    <message>
        <source>Surface whose fit is shown</source>
        <translation>Superfície de la qual es mostra l’ajust</translation>
    </message>
    <message>
        <source>Measured surface</source>
        <translation>Superfície mesurada</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distàncies</translation>
    </message>
    <message>
        <source>Fit of the motion, phase by phase</source>
        <translation>Ajust del moviment, fase per fase</translation>
    </message>
    <message>
        <source>mean mm</source>
        <translation>mm mitjana</translation>
    </message>
    <message>
        <source>95 % mm</source>
        <translation>mm 95 %</translation>
    </message>
    <message>
        <source>max mm</source>
        <translation>mm màx</translation>
    </message>
    <message>
        <source>measured ml</source>
        <translation>ml mesurats</translation>
    </message>
    <message>
        <source>unconstrained ml</source>
        <translation>ml lliures</translation>
    </message>
    <message>
        <source>fitted ml</source>
        <translation>ml ajustats</translation>
    </message>
    <message>
        <source>Dice</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>invertits</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>plegats</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>passos</translation>
    </message>
    <message>
        <source>Time of the phase</source>
        <translation>Temps de la fase</translation>
    </message>
    <message>
        <source>Distance of the fitted surface from the measured surface, weighted by area</source>
        <translation>Distància de la superfície ajustada a la mesurada, ponderada per àrea</translation>
    </message>
    <message>
        <source>95 % of the area lies within this distance</source>
        <translation>El 95 % de l’àrea és dins d’aquesta distància</translation>
    </message>
    <message>
        <source>The largest distance</source>
        <translation>La distància més gran</translation>
    </message>
    <message>
        <source>Volume that was measured</source>
        <translation>Volum mesurat</translation>
    </message>
    <message>
        <source>Volume of the fit before it is brought to the measured volume</source>
        <translation>Volum de l’ajust abans de dur-lo al volum mesurat</translation>
    </message>
    <message>
        <source>Volume of the fit</source>
        <translation>Volum de l’ajust</translation>
    </message>
    <message>
        <source>Triangles that face the wrong way</source>
        <translation>Triangles orientats al revés</translation>
    </message>
    <message>
        <source>Places in the tissue that are folded</source>
        <translation>Llocs del teixit que estan plegats</translation>
    </message>
    <message>
        <source>Steps that the fit took</source>
        <translation>Passos que ha necessitat l’ajust</translation>
    </message>
    <message>
        <source>Differences from the previous series</source>
        <translation>Què canvia respecte a la sèrie anterior</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>diferència</translation>
    </message>
    <message>
        <source>All surfaces</source>
        <translation>Totes les superfícies</translation>
    </message>
    <message>
        <source>Compared with the previous series</source>
        <translation>Comparat amb la sèrie anterior</translation>
    </message>
    <message>
        <source>%1: EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1: FE %2 %, de %3 a %4 ml, %5 l/min</translation>
    </message>
    <message>
        <source>tissue %1 to %2 ml</source>
        <translation>teixit de %1 a %2 ml</translation>
    </message>
    <message>
        <source>A session does not keep the measured surfaces. To see them, find the motion again: Sequence &gt; Motion from a series</source>
        <translation>La sessió no desa les superfícies mesurades. Per veure-les, calculeu de nou el moviment: Seqüència &gt; Moviment a partir d’una sèrie</translation>
    </message>
    <message>
        <source>Colour the organs by their distance from the measured surfaces of the nearest phase</source>
        <translation>Acoloreix els òrgans segons la distància a les superfícies mesurades de la fase més propera</translation>
    </message>
    <message>
        <source>A mark shows that the phase needs attention; the row&apos;s tooltip gives the reason</source>
        <translation>Una marca indica que la fase requereix atenció; la descripció emergent de la fila en dona el motiu</translation>
    </message>
    <message>
        <source>Dice coefficient of the voxels; 1 if all agree</source>
        <translation>Coeficient de Dice dels vòxels; 1 si coincideixen tots</translation>
    </message>
    <message>
        <source>Show the measured surfaces of the nearest phase, translucent</source>
        <translation>Mostra les superfícies mesurades de la fase més propera, translúcides</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>wall ml</source>
        <translation>paret ml</translation>
    </message>
    <message>
        <source>Whether the phase has labels, or was found in the images</source>
        <translation>Si la fase té etiquetes o s&apos;ha trobat a les imatges</translation>
    </message>
    <message>
        <source>Volume of the wall as a check: muscle hardly changes it. More than 10 % beyond the labelled phases needs attention</source>
        <translation>Volum de la paret com a control: el múscul gairebé no el canvia. Més d&apos;un 10 % fora de les fases etiquetades demana atenció</translation>
    </message>
    <message>
        <source>Estimate from the labels of one phase</source>
        <translation>Estimació a partir de les etiquetes d&apos;una fase</translation>
    </message>
    <message>
        <source>%1: about EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1: FE aproximada %2 %, %3 a %4 ml, %5 l/min</translation>
    </message>
    <message>
        <source>%1 ED</source>
        <translation>%1 ED</translation>
    </message>
    <message>
        <source>%1 ES</source>
        <translation>%1 ES</translation>
    </message>
    <message>
        <source>An estimate: this phase has no labels, and only one has some.</source>
        <translation>Una estimació: aquesta fase no té etiquetes i només una en té.</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>etiquetes</translation>
    </message>
    <message>
        <source>images</source>
        <translation>imatges</translation>
    </message>
</context>
<context>
    <name>viscera::app::SampleNames</name>
    <message>
        <source>digestive system</source>
        <translation>aparell digestiu</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>cor</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>fetge</translation>
    </message>
    <message>
        <source>stomach</source>
        <translation>estómac</translation>
    </message>
    <message>
        <source>stomach and bowel</source>
        <translation>estómac i intestí</translation>
    </message>
</context>
<context>
    <name>viscera::app::ScanActions</name>
    <message>
        <source>Soft &amp;tissue</source>
        <translation>&amp;Teixits tous</translation>
    </message>
    <message>
        <source>&amp;Lung</source>
        <translation>&amp;Pulmó</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Os</translation>
    </message>
    <message>
        <source>B&amp;rain</source>
        <translation>&amp;Cervell</translation>
    </message>
    <message>
        <source>Li&amp;ver</source>
        <translation>&amp;Fetge</translation>
    </message>
    <message>
        <source>&amp;Angiography</source>
        <translation>&amp;Angiografia</translation>
    </message>
    <message>
        <source>&amp;3D view alone</source>
        <translation>Només la vista &amp;3D</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Quatre vistes</translation>
    </message>
    <message>
        <source>&amp;Axial slice</source>
        <translation>Tall &amp;axial</translation>
    </message>
    <message>
        <source>&amp;Coronal slice</source>
        <translation>Tall &amp;coronal</translation>
    </message>
    <message>
        <source>&amp;Sagittal slice</source>
        <translation>Tall &amp;sagital</translation>
    </message>
    <message>
        <source>Open a &amp;scan...</source>
        <translation>Obre una &amp;exploració...</translation>
    </message>
    <message>
        <source>Open a CT or MR beside the organs</source>
        <translation>Obre una TC o RM al costat dels òrgans</translation>
    </message>
    <message>
        <source>Open a DICOM &amp;series...</source>
        <translation>Obre una sèrie &amp;DICOM...</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files as a scan</source>
        <translation>Obre una carpeta de fitxers DICOM com a exploració</translation>
    </message>
    <message>
        <source>C&amp;lose the scan</source>
        <translation>&amp;Tanca l’exploració</translation>
    </message>
    <message>
        <source>Close the scan; the organs stay</source>
        <translation>Tanca l’exploració; els òrgans es conserven</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomàtic</translation>
    </message>
    <message>
        <source>Level and width that the scan&apos;s file proposes, or found from its values</source>
        <translation>Nivell i amplada que proposa el fitxer de l’exploració, o trobats a partir dels valors</translation>
    </message>
    <message>
        <source>Level %1, width %2</source>
        <translation>Nivell %1, amplada %2</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Contorns</translation>
    </message>
    <message>
        <source>Draw the organs&apos; contours on the slices</source>
        <translation>Dibuixa els contorns dels òrgans als talls</translation>
    </message>
    <message>
        <source>Contours at &amp;rest</source>
        <translation>Contorns en &amp;repòs</translation>
    </message>
    <message>
        <source>Draw thin contours of the organs at rest as well</source>
        <translation>Dibuixa també contorns fins dels òrgans en repòs</translation>
    </message>
    <message>
        <source>Slices in the &amp;3D view</source>
        <translation>Talls a la &amp;vista 3D</translation>
    </message>
    <message>
        <source>&amp;Warp the scan</source>
        <translation>&amp;Deforma l’exploració</translation>
    </message>
    <message>
        <source>Show the scan as the pose warps it</source>
        <translation>Mostra l’exploració tal com la deforma la postura</translation>
    </message>
    <message>
        <source>S&amp;mooth between voxels</source>
        <translation>&amp;Suavitza entre vòxels</translation>
    </message>
    <message>
        <source>Ma&amp;ximum of thick slices</source>
        <translation>Mà&amp;xim de talls gruixuts</translation>
    </message>
    <message>
        <source>Show the largest value across a thick slice instead of the mean</source>
        <translation>Mostra el valor màxim a través d’un tall gruixut en comptes de la mitjana</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>&amp;Gruix</translation>
    </message>
    <message>
        <source>Slices of %1 mm</source>
        <translation>Talls de %1 mm</translation>
    </message>
    <message>
        <source>Thin slices</source>
        <translation>Talls fins</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Obre una carpeta de fitxers DICOM</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Obre una exploració</translation>
    </message>
    <message>
        <source>Scans (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)</source>
        <translation>Exploracions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;Tots els fitxers (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Es llegeix %1</translation>
    </message>
    <message>
        <source>The folder has several scans. Which one?</source>
        <translation>La carpeta té diverses exploracions. Quina?</translation>
    </message>
    <message numerus="yes">
        <source>%n more: see Scan on the page of Explore.</source>
        <translation>
            <numerusform>%n més: vegeu Exploració a la pàgina d’Explora.</numerusform>
            <numerusform>%n més: vegeu Exploració a la pàgina d’Explora.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, all %n slices, resampled to an even grid</source>
        <translation>
            <numerusform>, el %n tall, remostrejat en una malla regular</numerusform>
            <numerusform>, els %n talls, remostrejats en una malla regular</numerusform>
        </translation>
    </message>
    <message>
        <source>, slices %1 to %2 of %3</source>
        <translation>, talls %1 a %2 de %3</translation>
    </message>
    <message>
        <source>The slices are not at even distances: at most %1 of %2 are. What shall be read?</source>
        <translation>Els talls no són a distàncies regulars: com a màxim %1 de %2 ho són. Què cal llegir?</translation>
    </message>
    <message>
        <source>Read other slices...</source>
        <translation>Llegeix altres talls...</translation>
    </message>
    <message numerus="yes">
        <source>  %n phases</source>
        <translation>
            <numerusform>  %n fase</numerusform>
            <numerusform>  %n fases</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::SequenceList</name>
    <message>
        <source>%1: can be fitted to %2</source>
        <translation>%1: es pot ajustar a %2</translation>
    </message>
    <message>
        <source>%1: shows the sample organ and plays</source>
        <translation>%1: mostra l’òrgan de mostra i es reprodueix</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionFiles</name>
    <message>
        <source>&amp;New session</source>
        <translation>Sessió &amp;nova</translation>
    </message>
    <message>
        <source>Start with an empty session</source>
        <translation>Comença amb una sessió buida</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Desa</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Desa la sessió</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>&amp;Anomena i desa...</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Desa la sessió en un altre fitxer</translation>
    </message>
    <message>
        <source>&amp;Recover unsaved work</source>
        <translation>&amp;Recupera el treball no desat</translation>
    </message>
    <message>
        <source>Open the copy that Viscera kept when it ended without saving</source>
        <translation>Obre la còpia que Viscera va guardar quan es va tancar sense desar</translation>
    </message>
    <message>
        <source>Viscera</source>
        <translation>Viscera</translation>
    </message>
    <message>
        <source>Untitled session</source>
        <translation>Sessió sense títol</translation>
    </message>
    <message>
        <source>Session that names its organs&apos; files</source>
        <translation>Sessió que enllaça els fitxers dels òrgans</translation>
    </message>
    <message>
        <source>Session with all surfaces and the scan inside</source>
        <translation>Sessió amb totes les superfícies i l’exploració a dins</translation>
    </message>
    <message>
        <source>session</source>
        <translation>sessió</translation>
    </message>
    <message>
        <source>Save the session as</source>
        <translation>Anomena i desa la sessió</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Es desa %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>S’ha desat com a %1</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>Voleu desar els canvis?</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Voleu desar els canvis de %1?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descarta</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancel·la</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>I %n més.</numerusform>
            <numerusform>I %n més.</numerusform>
        </translation>
    </message>
    <message>
        <source>Viscera ended without saving. It has kept a copy of the work of %1.</source>
        <translation>Viscera es va tancar sense desar. Ha guardat una còpia del treball del %1.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recupera</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descarta</translation>
    </message>
    <message>
        <source>Choose the folder with the missing files</source>
        <translation>Trieu la carpeta dels fitxers que falten</translation>
    </message>
    <message>
        <source>Save this session?</source>
        <translation>Voleu desar aquesta sessió?</translation>
    </message>
    <message>
        <source>If you discard them, the changes since the last saving are lost.</source>
        <translation>Si els descarteu, es perden els canvis des de l’últim desament.</translation>
    </message>
    <message>
        <source>Fetch it from %1</source>
        <translation>Obtén-ho de %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionView</name>
    <message>
        <source>Preparing the motion</source>
        <translation>Es prepara el moviment</translation>
    </message>
    <message>
        <source>it has other handles</source>
        <translation>té altres tiradors</translation>
    </message>
    <message>
        <source>This version moves the organ differently from the one that saved the session: %1.</source>
        <translation>Aquesta versió mou l’òrgan d’una altra manera que la que va desar la sessió: %1.</translation>
    </message>
    <message>
        <source>handles differ by up to %1 mm</source>
        <translation>els tiradors difereixen fins a %1 mm</translation>
    </message>
</context>
<context>
    <name>viscera::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Configuració</translation>
    </message>
    <message>
        <source>Lengths are in mm, volumes in ml, everywhere; numbers have the decimal mark of the language.</source>
        <translation>Les longituds són sempre en mm i els volums en ml; els nombres porten el signe decimal de la llengua.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecte</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Com el sistema</translation>
    </message>
    <message>
        <source>The next start uses the language.</source>
        <translation>El pròxim inici fa servir la llengua.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inici</translation>
    </message>
    <message>
        <source>Show the welcome</source>
        <translation>Mostra la benvinguda</translation>
    </message>
    <message>
        <source>Folders that dialogs begin in</source>
        <translation>Carpetes on comencen els diàlegs</translation>
    </message>
    <message>
        <source>Organs and sessions</source>
        <translation>Òrgans i sessions</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imatges</translation>
    </message>
    <message>
        <source>Movies</source>
        <translation>Pel·lícules</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Tria...</translation>
    </message>
</context>
<context>
    <name>viscera::app::ShortcutCard</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Ratolí i tecles</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Arrossegar amb l’esquerre</translation>
    </message>
    <message>
        <source>Rotate, or move a handle</source>
        <translation>Gira, o mou un tirador</translation>
    </message>
    <message>
        <source>Middle, Shift+left drag</source>
        <translation>Botó del mig, Maj+esquerre</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplaça</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Arrossegar amb el dret, roda</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Select, or add a handle</source>
        <translation>Selecciona, o afegeix un tirador</translation>
    </message>
    <message>
        <source>Shift or Ctrl+click</source>
        <translation>Maj o Ctrl+clic</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Afegeix a la selecció</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel a drag, close a message</source>
        <translation>Cancel·la l’arrossegament, tanca un missatge</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlicePanes</name>
    <message>
        <source>The scan cannot be warped: %1</source>
        <translation>L’exploració no es pot deformar: %1</translation>
    </message>
    <message>
        <source>folded by the pose: estimated</source>
        <translation>plegat per la postura: estimat</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlidePanel</name>
    <message>
        <source>Keep views as slides, then show them with F5 and Page Down. The session keeps them.</source>
        <translation>Guardeu vistes com a diapositives i mostreu-les amb F5 i Av Pàg. La sessió les conserva.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Slides</name>
    <message>
        <source>&amp;Keep this view as a slide</source>
        <translation>&amp;Guarda la vista com a diapositiva</translation>
    </message>
    <message>
        <source>&amp;Remove the slide</source>
        <translation>&amp;Elimina la diapositiva</translation>
    </message>
    <message>
        <source>Remove the slide that was shown last</source>
        <translation>Elimina l’última diapositiva mostrada</translation>
    </message>
    <message>
        <source>&amp;Next slide</source>
        <translation>Diapositiva següe&amp;nt</translation>
    </message>
    <message>
        <source>&amp;Previous slide</source>
        <translation>Diapositiva &amp;anterior</translation>
    </message>
    <message>
        <source>Slide %1</source>
        <translation>Diapositiva %1</translation>
    </message>
    <message>
        <source>Keep the present view with its cut, names and hidden organs, and the instant of a paused sequence</source>
        <translation>Guarda la vista actual amb la secció, els noms i els òrgans amagats, i l’instant d’una seqüència en pausa</translation>
    </message>
    <message>
        <source>&amp;Back from the slides</source>
        <translation>&amp;Torna de les diapositives</translation>
    </message>
    <message>
        <source>Show, cut and name the organs as before the slides</source>
        <translation>Mostra, secciona i anomena els òrgans com abans de les diapositives</translation>
    </message>
</context>
<context>
    <name>viscera::app::StatusLine</name>
    <message>
        <source>Cancel this task</source>
        <translation>Cancel·la aquesta tasca</translation>
    </message>
    <message>
        <source>No organ</source>
        <translation>Cap òrgan</translation>
    </message>
    <message>
        <source>%1: open surface, no volume</source>
        <translation>%1: superfície oberta, sense volum</translation>
    </message>
    <message>
        <source>  locked</source>
        <translation>  bloquejat</translation>
    </message>
    <message>
        <source>no handles</source>
        <translation>sense tiradors</translation>
    </message>
    <message>
        <source>, binding...</source>
        <translation>, es vincula...</translation>
    </message>
    <message>
        <source>, binding cancelled</source>
        <translation>, vinculació cancel·lada</translation>
    </message>
    <message>
        <source>, bound in %1 ms</source>
        <translation>, vinculat en %1 ms</translation>
    </message>
    <message>
        <source>%1, %2 of tissue folded by the pose</source>
        <translation>%1, %2 de teixit plegats per la postura</translation>
    </message>
    <message numerus="yes">
        <source>%n organs</source>
        <translation>
            <numerusform>%n òrgan</numerusform>
            <numerusform>%n òrgans</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 not bound</source>
        <translation>, %1 sense vincular</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainModel</name>
    <message>
        <source>Choose a motion, or drag a handle: strain is the change of the heart&apos;s wall.</source>
        <translation>Trieu un moviment o arrossegueu un tirador: la deformació és el canvi de la paret del cor.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainPanel</name>
    <message>
        <source>From the fullest phase</source>
        <translation>Des de la fase més plena</translation>
    </message>
    <message>
        <source>From phase %1</source>
        <translation>Des de la fase %1</translation>
    </message>
    <message>
        <source>Times to the peak differ by %1 ms along and %2 ms around</source>
        <translation>Els temps fins al pic difereixen en %1 ms al llarg i %2 ms al voltant</translation>
    </message>
    <message>
        <source>The bull&apos;s eye shows the present pose against rest.</source>
        <translation>L’ull de bou mostra la posa actual respecte al repòs.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressChart</name>
    <message>
        <source>maximum</source>
        <translation>màxima</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>mitjana</translation>
    </message>
    <message>
        <source>The stress over one cycle of the sequence is drawn here as soon as it is computed.</source>
        <translation>La tensió durant un cicle de la seqüència es dibuixa aquí tan bon punt s’ha calculat.</translation>
    </message>
    <message>
        <source>chosen point</source>
        <translation>punt triat</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressExport</name>
    <message>
        <source>Export stress &amp;map...</source>
        <translation>Exporta el &amp;mapa de tensió...</translation>
    </message>
    <message>
        <source>Write all quantities at all points inside the organ, for ParaView</source>
        <translation>Escriu totes les magnituds en tots els punts dins de l’òrgan, per a ParaView</translation>
    </message>
    <message>
        <source>Export stress map</source>
        <translation>Exporta el mapa de tensió</translation>
    </message>
    <message>
        <source>VTK solids (*.vtu)</source>
        <translation>Sòlids VTK (*.vtu)</translation>
    </message>
    <message>
        <source>Export stress at the &amp;points...</source>
        <translation>Exporta la tensió als &amp;punts...</translation>
    </message>
    <message>
        <source>Write the values at the witness points as a table</source>
        <translation>Escriu els valors als punts testimoni com a taula</translation>
    </message>
    <message>
        <source>Export stress at the points</source>
        <translation>Exporta la tensió als punts</translation>
    </message>
    <message>
        <source>Export &amp;histogram...</source>
        <translation>Exporta l’&amp;histograma...</translation>
    </message>
    <message>
        <source>Write the distribution of the shown quantity over the witness points</source>
        <translation>Escriu la distribució de la magnitud mostrada sobre els punts testimoni</translation>
    </message>
    <message>
        <source>Export histogram</source>
        <translation>Exporta l’histograma</translation>
    </message>
    <message>
        <source>Export &amp;curve over the sequence...</source>
        <translation>Exporta la &amp;corba de la seqüència...</translation>
    </message>
    <message>
        <source>Write the rotational stress over one whole cycle of the sequence</source>
        <translation>Escriu la tensió rotacional durant un cicle sencer de la seqüència</translation>
    </message>
    <message>
        <source>Export curve</source>
        <translation>Exporta la corba</translation>
    </message>
    <message>
        <source>the stress map</source>
        <translation>el mapa de tensió</translation>
    </message>
    <message>
        <source>the stress</source>
        <translation>la tensió</translation>
    </message>
    <message>
        <source>the histogram</source>
        <translation>l’histograma</translation>
    </message>
    <message>
        <source>the curve</source>
        <translation>la corba</translation>
    </message>
    <message>
        <source>Export pro&amp;bes...</source>
        <translation>Exporta les &amp;sondes...</translation>
    </message>
    <message>
        <source>Write place and values of the pinned probes as a table</source>
        <translation>Escriu el lloc i els valors de les sondes fixades en una taula</translation>
    </message>
    <message>
        <source>Export probes</source>
        <translation>Exporta les sondes</translation>
    </message>
    <message>
        <source>Export prof&amp;iles...</source>
        <translation>Exporta els perfi&amp;ls...</translation>
    </message>
    <message>
        <source>Write the values along the lines between probes as a table</source>
        <translation>Escriu els valors al llarg de les línies entre sondes en una taula</translation>
    </message>
    <message>
        <source>Export profiles</source>
        <translation>Exporta els perfils</translation>
    </message>
    <message>
        <source>the probes</source>
        <translation>les sondes</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>els perfils</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressMode</name>
    <message>
        <source>How much the pose distorts the tissue (rotational stress): click the organ to read the values of a point; C cuts it open; the map follows while you drag a handle</source>
        <translation>Fins a quin punt la postura distorsiona el teixit (tensió rotacional): feu clic a l’òrgan per llegir els valors d’un punt; C el secciona; el mapa s’actualitza mentre arrossegueu un tirador</translation>
    </message>
    <message>
        <source>&amp;Next map</source>
        <translation>Mapa següe&amp;nt</translation>
    </message>
    <message>
        <source>The next stress map</source>
        <translation>El mapa de tensió següent</translation>
    </message>
    <message>
        <source>&amp;Go to the maximum</source>
        <translation>&amp;Ves al màxim</translation>
    </message>
    <message>
        <source>Show the values where the map is largest, and cut the organ open there</source>
        <translation>Mostra els valors on el mapa és màxim, i hi secciona l’òrgan</translation>
    </message>
    <message>
        <source>&amp;Maximum over the sequence</source>
        <translation>Mà&amp;xim de la seqüència</translation>
    </message>
    <message>
        <source>The most extreme value that each point reaches in one cycle of the sequence</source>
        <translation>El valor més extrem que assoleix cada punt en un cicle de la seqüència</translation>
    </message>
    <message>
        <source>Map on the organ&apos;s &amp;surface</source>
        <translation>Mapa a la &amp;superfície de l’òrgan</translation>
    </message>
    <message>
        <source>Draw the map on the organ&apos;s surface instead of the outer tetrahedra</source>
        <translation>Dibuixa el mapa a la superfície de l’òrgan en comptes dels tetràedres exteriors</translation>
    </message>
    <message>
        <source>&amp;Keep the legend&apos;s range</source>
        <translation>&amp;Fixa l’escala de la llegenda</translation>
    </message>
    <message>
        <source>Keep the range of colours, so that poses can be compared</source>
        <translation>Manté l’interval dels colors perquè es puguin comparar postures</translation>
    </message>
    <message>
        <source>&amp;Cut open</source>
        <translation>&amp;Secciona</translation>
    </message>
    <message>
        <source>Cut the organ open by a plane</source>
        <translation>Secciona l’òrgan per un pla</translation>
    </message>
    <message>
        <source>&amp;Only beyond a limit</source>
        <translation>&amp;Només més enllà d’un límit</translation>
    </message>
    <message>
        <source>Show only tissue above or below a limit</source>
        <translation>Mostra només el teixit per sobre o per sota d’un límit</translation>
    </message>
    <message>
        <source>&amp;Glyphs of the stretch</source>
        <translation>&amp;Glifs de l’estirament</translation>
    </message>
    <message>
        <source>No glyphs, ellipsoids or crosses</source>
        <translation>Sense glifs, el·lipsoides o creus</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Tiradors</translation>
    </message>
    <message>
        <source>Show the handles, so that they can be dragged</source>
        <translation>Mostra els tiradors per poder-los arrossegar</translation>
    </message>
    <message>
        <source>O&amp;ther organs</source>
        <translation>Els al&amp;tres òrgans</translation>
    </message>
    <message>
        <source>Show the other organs as well</source>
        <translation>Mostra també els altres òrgans</translation>
    </message>
    <message>
        <source>P&amp;in the probe</source>
        <translation>Fi&amp;xa la sonda</translation>
    </message>
    <message>
        <source>Keep the point that was clicked: its place and value follow the pose in the table</source>
        <translation>Conserva el punt triat: el seu lloc i el seu valor segueixen la postura a la taula</translation>
    </message>
    <message>
        <source>&amp;Logarithmic range</source>
        <translation>&amp;Escala logarítmica</translation>
    </message>
    <message>
        <source>Same range in both &amp;views</source>
        <translation>La mateixa escala a les &amp;dues vistes</translation>
    </message>
    <message>
        <source>Beside another view: one range of colours for both stress maps, so that they can be compared</source>
        <translation>Al costat d’una altra vista: una sola escala de colors per als dos mapes de tensió, perquè es puguin comparar</translation>
    </message>
    <message>
        <source>Go to the &amp;time of the maximum</source>
        <translation>Vés al &amp;moment del màxim</translation>
    </message>
    <message>
        <source>Show the sequence at the instant at which the rotational stress is largest</source>
        <translation>Mostra la seqüència a l’instant en què la tensió rotacional és més gran</translation>
    </message>
    <message>
        <source>Use a logarithmic colour scale, which separates small values</source>
        <translation>Fa servir una escala de colors logarítmica, que distingeix els valors petits</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressModel</name>
    <message>
        <source>This point is probe %1 already.</source>
        <translation>Aquest punt ja és la sonda %1.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressPage</name>
    <message>
        <source>TetGen</source>
        <translation>TetGen</translation>
    </message>
    <message>
        <source>TetGen, surface repaired</source>
        <translation>TetGen, superfície reparada</translation>
    </message>
    <message>
        <source>regular grid</source>
        <translation>quadrícula regular</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>What the colours mean (M: next map). Rotational stress is the largest angle by which a direction is turned when the tissue is stretched; it is not a pressure.</source>
        <translation>Què volen dir els colors (M: mapa següent). La tensió rotacional és l’angle màxim que gira una direcció quan el teixit s’estira; no és una pressió.</translation>
    </message>
    <message>
        <source>Your pose</source>
        <translation>La vostra postura</translation>
    </message>
    <message>
        <source>The map of your pose; handles can be dragged</source>
        <translation>El mapa de la vostra postura; es poden arrossegar tiradors</translation>
    </message>
    <message>
        <source>The map of the sequence at the timeline&apos;s instant; Space plays</source>
        <translation>El mapa de la seqüència a l’instant de la línia de temps; Espai reprodueix</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Valors</translation>
    </message>
    <message>
        <source>Smooth: through the tetrahedra</source>
        <translation>Llisa: a través dels tetràedres</translation>
    </message>
    <message>
        <source>Crinkle: whole tetrahedra</source>
        <translation>Irregular: tetràedres sencers</translation>
    </message>
    <message>
        <source>Distance of the cut from the organ&apos;s middle; the arrow in the view moves it, the rim tilts it</source>
        <translation>Distància de la secció al centre de l’òrgan; a la vista, la fletxa la mou i la vora la inclina</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Límit</translation>
    </message>
    <message>
        <source>Glyphs</source>
        <translation>Glifs</translation>
    </message>
    <message>
        <source>No glyphs</source>
        <translation>Sense glifs</translation>
    </message>
    <message>
        <source>Ellipsoids of the stretch</source>
        <translation>El·lipsoides de l’estirament</translation>
    </message>
    <message>
        <source>Crosses of the stretch</source>
        <translation>Creus de l’estirament</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Cut away the right side</source>
        <translation>Retalla el costat dret</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Cut through the middle, across the line of sight</source>
        <translation>Secciona pel mig, perpendicularment a la línia de visió</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Number of witness points</source>
        <translation>Nombre de punts testimoni</translation>
    </message>
    <message>
        <source>More points show finer detail and take longer; up to 20,000 the map follows a drag</source>
        <translation>Més punts mostren més detall i triguen més; fins a 20.000 el mapa segueix l’arrossegament</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Font</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Torna-ho a provar</translation>
    </message>
    <message>
        <source>Open an organ to see where it is distorted.</source>
        <translation>Obriu un òrgan per veure on es distorsiona.</translation>
    </message>
    <message>
        <source>Filling the organ with witness points...</source>
        <translation>S’omple l’òrgan de punts testimoni...</translation>
    </message>
    <message>
        <source>Binding the witness points to the handles...</source>
        <translation>Es vinculen els punts testimoni als tiradors...</translation>
    </message>
    <message>
        <source>Cancelled. Press Try again to go on.</source>
        <translation>Cancel·lat. Premeu Torna-ho a provar per continuar.</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>forma tancada</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>diferències</translation>
    </message>
    <message numerus="yes">
        <source>%n points lie outside the handles&apos; hull and stay where they are.</source>
        <translation>
            <numerusform>%n punt és fora de l’envolupant dels tiradors i es queda on és.</numerusform>
            <numerusform>%n punts són fora de l’envolupant dels tiradors i es queden on són.</numerusform>
        </translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sondes</translation>
    </message>
    <message>
        <source>Time of the maximum</source>
        <translation>Moment del màxim</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colors</translation>
    </message>
    <message>
        <source>Colours from the lowest value to the highest; maps of angles and maps of ratios each keep their own choice</source>
        <translation>Colors del valor més baix al més alt; els mapes d’angles i els de raons conserven cadascun la seva pròpia tria</translation>
    </message>
    <message>
        <source>Witness points at which the tissue is turned inside out; in magenta, except on the map of folded tissue</source>
        <translation>Punts testimoni on el teixit està girat del revés; en magenta, llevat del mapa de teixit plegat</translation>
    </message>
    <message>
        <source>Cut and glyphs</source>
        <translation>Secció i glifs</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Teixit</translation>
    </message>
    <message>
        <source>Above the limit</source>
        <translation>Per sobre del límit</translation>
    </message>
    <message>
        <source>Below the limit</source>
        <translation>Per sota del límit</translation>
    </message>
    <message>
        <source>Glyphs of the stretch at about 300 points: the shape that a small sphere of tissue takes</source>
        <translation>Glifs de l’estirament en uns 300 punts: la forma que pren una petita esfera de teixit</translation>
    </message>
    <message>
        <source>No handle is near %1: the nearest is %2 mm away. Place handles around it in Handles (2).</source>
        <translation>Cap tirador no és a prop de %1: el més proper és a %2 mm. Poseu tiradors al voltant a Tiradors (2).</translation>
    </message>
    <message>
        <source>Nothing is deformed: drag a handle, or play a sequence (Space).</source>
        <translation>Res no està deformat: arrossegueu un tirador o reproduïu una seqüència (Espai).</translation>
    </message>
    <message>
        <source>Choose a material</source>
        <translation>Trieu un material</translation>
    </message>
    <message>
        <source>Another material</source>
        <translation>Un altre material</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>The tissue whose stiffness makes pascals of the deformation; it does not change the pose</source>
        <translation>El teixit la rigidesa del qual converteix la deformació en pascals; no canvia la postura</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Mòdul de Young</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Coeficient de Poisson</translation>
    </message>
    <message>
        <source>Pascals exist only of a stated material. Choose a material first.</source>
        <translation>Només hi ha pascals d&apos;un material indicat. Trieu primer un material.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus %1 kPa, doi:%2</source>
        <translation>Mòdul de Young %1 kPa, doi:%2</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemBox</name>
    <message>
        <source>Coordinate system that binds the organs to the handles</source>
        <translation>Sistema de coordenades que vincula els òrgans als tiradors</translation>
    </message>
    <message>
        <source>no cage</source>
        <translation>sense gàbia</translation>
    </message>
    <message>
        <source>Handles may stand anywhere around the organ</source>
        <translation>Els tiradors poden ser a qualsevol lloc al voltant de l’òrgan</translation>
    </message>
    <message>
        <source>cage</source>
        <translation>gàbia</translation>
    </message>
    <message>
        <source>Works with a closed surface over the handles: their convex hull, or a cage that was loaded</source>
        <translation>Treballa amb una superfície tancada sobre els tiradors: l’envolupant convexa, o una gàbia carregada</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positives</translation>
    </message>
    <message>
        <source>interpolating</source>
        <translation>interpolants</translation>
    </message>
    <message>
        <source>A point at a handle follows it exactly</source>
        <translation>Un punt en un tirador el segueix exactament</translation>
    </message>
    <message>
        <source>exact gradient</source>
        <translation>gradient exacte</translation>
    </message>
    <message>
        <source>Stress is computed without differences</source>
        <translation>La tensió es calcula sense diferències</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>buits</translation>
    </message>
    <message>
        <source>Some points inside the hull have no coordinates and do not move</source>
        <translation>Alguns punts dins de l’envolupant no tenen coordenades i no es mouen</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>salts</translation>
    </message>
    <message>
        <source>Neighbouring points may move very differently</source>
        <translation>Punts veïns es poden moure de manera molt diferent</translation>
    </message>
    <message>
        <source>kinks</source>
        <translation>plecs</translation>
    </message>
    <message>
        <source>The deformed organ may show creases</source>
        <translation>L’òrgan deformat pot mostrar arrugues</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>grups</translation>
    </message>
    <message>
        <source>Handles act by their groups</source>
        <translation>Els tiradors actuen per grups</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tetràedres</translation>
    </message>
    <message>
        <source>Fills the organ with tetrahedra first</source>
        <translation>Primer omple l’òrgan de tetràedres</translation>
    </message>
    <message>
        <source>The value is set to %1 %2, but these handles allow at most %3, so %3 is used.</source>
        <translation>El valor està establert a %1 %2, però aquests tiradors permeten com a màxim %3, de manera que s’usa %3.</translation>
    </message>
    <message>
        <source>These handles allow up to %1.</source>
        <translation>Aquests tiradors permeten fins a %1.</translation>
    </message>
    <message>
        <source>No coordinate is negative: the organ follows the direction of every handle</source>
        <translation>Cap coordenada no és negativa: l’òrgan segueix la direcció de cada tirador</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemCombo</name>
    <message>
        <source>Recommended</source>
        <translation>Recomanats</translation>
    </message>
    <message>
        <source>With a cage</source>
        <translation>Amb gàbia</translation>
    </message>
    <message>
        <source>With tetrahedra</source>
        <translation>Amb tetràedres</translation>
    </message>
    <message>
        <source>Attempts of the thesis</source>
        <translation>Intents de la tesi</translation>
    </message>
</context>
<context>
    <name>viscera::app::TaskCard</name>
    <message>
        <source>Drag the bright dot: the organ follows.</source>
        <translation>Arrossegueu el punt clar: l’òrgan el segueix.</translation>
    </message>
    <message>
        <source>Done. Ctrl+Z takes it back. F1 opens the guide at what you are doing.</source>
        <translation>Fet. Ctrl+Z ho desfà. F1 obre la guia al que esteu fent.</translation>
    </message>
</context>
<context>
    <name>viscera::app::TimelineBar</name>
    <message>
        <source>To the start of the cycle (Home)</source>
        <translation>A l’inici del cicle (Inici)</translation>
    </message>
    <message>
        <source>One frame back (,)</source>
        <translation>Un fotograma enrere (,)</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Reprodueix o pausa (Espai)</translation>
    </message>
    <message>
        <source>One frame forward (.)</source>
        <translation>Un fotograma endavant (.)</translation>
    </message>
    <message>
        <source>Repeat the cycle (L)</source>
        <translation>Repeteix el cicle (L)</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Repeteix</translation>
    </message>
    <message>
        <source>Repeat the cycle</source>
        <translation>Repeteix el cicle</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Re&amp;produeix o pausa</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>A l’&amp;inici</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Un fotograma &amp;enrere</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Un fotograma en&amp;davant</translation>
    </message>
    <message>
        <source>A fine step bac&amp;k</source>
        <translation>Un pas fi enre&amp;re</translation>
    </message>
    <message>
        <source>Go back by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Retrocedeix deu mil·lisegons en un batec, un fotograma en altres seqüències</translation>
    </message>
    <message>
        <source>A fine step for&amp;ward</source>
        <translation>Un pas fi enda&amp;vant</translation>
    </message>
    <message>
        <source>Go forward by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Avança deu mil·lisegons en un batec, un fotograma en altres seqüències</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocitat</translation>
    </message>
    <message>
        <source>Slow motion: how fast time passes (S)</source>
        <translation>Càmera lenta: velocitat a què passa el temps (S)</translation>
    </message>
    <message>
        <source>%1: %2 %3. The heart rate of the circulation sets it.</source>
        <translation>%1: %2 %3. La fixa la freqüència cardíaca de la circulació.</translation>
    </message>
    <message>
        <source>%1: %2 to %3 %4</source>
        <translation>%1: de %2 a %3 %4</translation>
    </message>
    <message>
        <source>No motion yet: choose a sequence in Play (5)</source>
        <translation>Encara sense moviment: trieu una seqüència a Reprodueix (5)</translation>
    </message>
    <message>
        <source>%1 s into the cycle</source>
        <translation>a %1 s de l’inici del cicle</translation>
    </message>
    <message>
        <source>The images of the cine study: there is no motion yet</source>
        <translation>Les imatges de l&apos;estudi cine: encara no hi ha moviment</translation>
    </message>
    <message>
        <source>The phases of the scan: there is no motion yet</source>
        <translation>Les fases de l&apos;estudi: encara no hi ha moviment</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Estudi</translation>
    </message>
</context>
<context>
    <name>viscera::app::TourCard</name>
    <message>
        <source>Back</source>
        <translation>Enrere</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Acaba la visita</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Següent</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fet</translation>
    </message>
</context>
<context>
    <name>viscera::app::Value</name>
    <message>
        <source>No password was given.</source>
        <translation>No s&apos;ha donat cap contrasenya.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ViewActions</name>
    <message>
        <source>Save s&amp;creenshot</source>
        <translation>Desa una &amp;captura</translation>
    </message>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Desa una imatge de la vista 3D</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Enquadra</translation>
    </message>
    <message>
        <source>Bring the selected organ, or all, into the picture</source>
        <translation>Enquadra l’òrgan seleccionat, o tots</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Anterior</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>&amp;Posterior</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Esquerra</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Dreta</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Superior</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>&amp;Inferior</translation>
    </message>
    <message>
        <source>Show &amp;handles in every mode</source>
        <translation>Mostra els &amp;tiradors en tots els modes</translation>
    </message>
    <message>
        <source>&amp;Ghost of the rest shape</source>
        <translation>&amp;Fantasma de la forma en repòs</translation>
    </message>
    <message>
        <source>Cut &amp;open</source>
        <translation>Secci&amp;ona</translation>
    </message>
    <message>
        <source>Cut all organs open by a plane; their cavities are hollow then</source>
        <translation>Secciona tots els òrgans per un pla; les cavitats es veuen buides</translation>
    </message>
    <message>
        <source>Orientation &amp;cube</source>
        <translation>&amp;Cub d’orientació</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>&amp;Barra d’escala</translation>
    </message>
    <message>
        <source>Sha&amp;de in folds</source>
        <translation>Om&amp;breja els plecs</translation>
    </message>
    <message>
        <source>Darken the folds of organs and soften the light; takes time on a computer without a graphics processor</source>
        <translation>Enfosqueix els plecs dels òrgans i suavitza la llum; lent en un ordinador sense processador gràfic</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Imatge desada com a %1</translation>
    </message>
    <message>
        <source>%1 is hidden behind %2.</source>
        <translation>%2 tapa %1.</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Mostra només aquest</translation>
    </message>
    <message>
        <source>&amp;Edges of triangles</source>
        <translation>Arestes dels &amp;triangles</translation>
    </message>
    <message>
        <source>Draw the triangles of organs as lines</source>
        <translation>Dibuixa els triangles dels òrgans com a línies</translation>
    </message>
    <message>
        <source>&amp;Flat triangles</source>
        <translation>Triangles &amp;plans</translation>
    </message>
    <message>
        <source>Give each triangle of an organ one shade, in place of a smooth surface</source>
        <translation>Dona a cada triangle d’un òrgan un sol to, en lloc d’una superfície llisa</translation>
    </message>
    <message>
        <source>Co&amp;nduction system</source>
        <translation>Sistema de co&amp;nducció</translation>
    </message>
    <message>
        <source>In the sample heart: sinus node, atrioventricular node, bundles and branches, lit where the excitation of the beat is; names of parts name them</source>
        <translation>En el cor de mostra: node sinoauricular, node auriculoventricular, feixos i branques, il·luminats on hi ha l&apos;excitació del batec; els noms de les parts els anomenen</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeBox</name>
    <message>
        <source>Target</source>
        <translation>Objectiu</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Target volume</source>
        <translation>Volum objectiu</translation>
    </message>
    <message>
        <source>Give the organ this volume with the smallest motion of the compensating handles, or of all free ones</source>
        <translation>Dona a l’òrgan aquest volum amb el mínim moviment dels tiradors compensadors, o de tots els lliures</translation>
    </message>
    <message>
        <source>%1 now has the target volume; its lock keeps this volume from now on.</source>
        <translation>%1 té ara el volum objectiu; a partir d’ara el bloqueig conserva aquest volum.</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeMonitor</name>
    <message>
        <source>Volumes over the cycle</source>
        <translation>Volums al llarg del cicle</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumePanel</name>
    <message>
        <source>normal at the end of diastole</source>
        <translation>normal al final de la diàstole</translation>
    </message>
    <message>
        <source>normal at the end of systole</source>
        <translation>normal al final de la sístole</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normal: %1</translation>
    </message>
    <message>
        <source>Volumes over time are drawn here while a sequence plays (Space) or handles are dragged (3).</source>
        <translation>Els volums al llarg del temps es dibuixen aquí mentre es reprodueix una seqüència (Espai) o s’arrosseguen tiradors (3).</translation>
    </message>
    <message>
        <source>%1 (right axis)</source>
        <translation>%1 (eix dret)</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 mesurat</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 abans</translation>
    </message>
    <message>
        <source>%1 prescribed</source>
        <translation>%1 prescrit</translation>
    </message>
    <message>
        <source>Closed organs show their volume here.</source>
        <translation>Els òrgans tancats mostren aquí el seu volum.</translation>
    </message>
    <message>
        <source>%1: show its normal range in the chart</source>
        <translation>%1: mostra al gràfic què és normal</translation>
    </message>
    <message>
        <source>Shaded: normal for %1, %2. %3</source>
        <translation>Ombrejat: normal per a %1, %2. %3</translation>
    </message>
    <message>
        <source>EF %1 %  SV %2 ml</source>
        <translation>FE %1 %  VS %2 ml</translation>
    </message>
    <message>
        <source>%1 % of rest</source>
        <translation>%1 % del repòs</translation>
    </message>
    <message>
        <source>Part of the cycle</source>
        <translation>Part del cicle</translation>
    </message>
    <message>
        <source>Time while dragging</source>
        <translation>Temps d’arrossegament</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gràfic</translation>
    </message>
    <message numerus="yes">
        <source>%n more organs are not drawn: choose one to see its volume.</source>
        <translation>
            <numerusform>%n òrgan més no està dibuixat: trieu-lo per veure’n el volum.</numerusform>
            <numerusform>%n òrgans més no estan dibuixats: trieu-ne un per veure’n el volum.</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit of the motion</source>
        <translation>Ajust del moviment</translation>
    </message>
    <message>
        <source>EF about %1 %  SV about %2 ml (estimate)</source>
        <translation>FE aprox. %1 %  VS aprox. %2 ml (estimació)</translation>
    </message>
</context>
<context>
    <name>viscera::app::WarpExport</name>
    <message>
        <source>Export the &amp;warped scan...</source>
        <translation>Exporta l’exploració de&amp;formada...</translation>
    </message>
    <message>
        <source>Write the scan as the pose warps it, with a label map of the posed organs</source>
        <translation>Escriu l’exploració tal com la deforma la postura, amb un mapa d’etiquetes dels òrgans en aquesta postura</translation>
    </message>
    <message>
        <source>Export the warped scan</source>
        <translation>Exporta l’exploració deformada</translation>
    </message>
    <message>
        <source>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</source>
        <translation>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</translation>
    </message>
    <message>
        <source>Exporting the warped scan</source>
        <translation>S’exporta l’exploració deformada</translation>
    </message>
    <message>
        <source>The warped scan was written to %1.</source>
        <translation>S’ha escrit l’exploració deformada a %1.</translation>
    </message>
    <message>
        <source>Its labels are beside it: %1.</source>
        <translation>Les etiquetes són al costat: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The pose folds the tissue at %n voxels: their values are estimates.</source>
        <translation>
            <numerusform>La postura plega el teixit en %n vòxel: el valor és una estimació.</numerusform>
            <numerusform>La postura plega el teixit en %n vòxels: els valors són estimacions.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::WelcomeCard</name>
    <message>
        <source>Welcome</source>
        <translation>Benvinguda</translation>
    </message>
    <message>
        <source>Open a patient...</source>
        <translation>Obre un pacient...</translation>
    </message>
    <message>
        <source>Choose organ surfaces of a patient (Ctrl+O)</source>
        <translation>Trieu superfícies d’òrgans d’un pacient (Ctrl+O)</translation>
    </message>
    <message>
        <source>Sample organs</source>
        <translation>Òrgans de mostra</translation>
    </message>
    <message>
        <source>Organs that come with the program</source>
        <translation>Òrgans que venen amb el programa</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Visita de dos minuts</translation>
    </message>
    <message>
        <source>The parts of the window, step by step</source>
        <translation>Les parts de la finestra, pas a pas</translation>
    </message>
    <message>
        <source>Close this card (Help &gt; Welcome shows it again)</source>
        <translation>Tanca aquesta targeta (Ajuda &gt; Benvinguda la torna a mostrar)</translation>
    </message>
    <message>
        <source>Close this card</source>
        <translation>Tanca aquesta targeta</translation>
    </message>
    <message>
        <source>First task</source>
        <translation>Primera tasca</translation>
    </message>
    <message>
        <source>Drag a dot, and see the organ follow</source>
        <translation>Arrossegar un punt i veure com segueix l’òrgan</translation>
    </message>
</context>
<context>
    <name>viscera::app::WindowLayout</name>
    <message>
        <source>&amp;Standard layout</source>
        <translation>&amp;Disposició estàndard</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Pantalla completa</translation>
    </message>
    <message>
        <source>The window takes the whole screen</source>
        <translation>La finestra ocupa tota la pantalla</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Modes</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propietats</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línia de temps</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Diapositives</translation>
    </message>
    <message>
        <source>Move all panels to their default places</source>
        <translation>Mou tots els panells als seus llocs predeterminats</translation>
    </message>
</context>
<context>
    <name>viscera::app::Workspace</name>
    <message>
        <source>Open folder</source>
        <translation>Obre la carpeta</translation>
    </message>
</context>
</TS>
