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
        <source>Measurements</source>
        <translation>Mesures</translation>
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
        <source>Left</source>
        <translation>Esquerra</translation>
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
        <source>Handles</source>
        <translation>Tiradors</translation>
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
        <source>Back to the shape as sent (R)</source>
        <translation>Torna a la forma original (R)</translation>
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
        <source>%1 % by the handles</source>
        <translation>%1 % pels tiradors</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1: fracció d’ejecció</translation>
    </message>
    <message>
        <source>Stroke volume</source>
        <translation>Volum sistòlic</translation>
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
        <source>Rate</source>
        <translation>Freqüència</translation>
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
        <source>Organ</source>
        <translation>Òrgan</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Ventricle esquerre</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Ventricle dret</translation>
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
        <source>Name on it</source>
        <translation>Nom a sobre</translation>
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
        <source>end-diastolic volume</source>
        <translation>volum telediastòlic</translation>
    </message>
    <message>
        <source>end-systolic volume</source>
        <translation>volum telesistòlic</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>fracció d’ejecció</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volum després d’un àpat</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volum</translation>
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
        <source>Heart</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómac</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Fetge</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Melsa</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Ronyó</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Ronyó esquerre</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Ronyó dret</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vesícula biliar</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pàncrees</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Batec del cor</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Peristaltisme gàstric</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Respiració</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistrat</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurat</translation>
    </message>
    <message>
        <source>Atrial systole</source>
        <translation>Sístole auricular</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Contracció isovolumètrica</translation>
    </message>
    <message>
        <source>Ejection</source>
        <translation>Ejecció</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Relaxació isovolumètrica</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Ompliment</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Ona al cos</translation>
    </message>
    <message>
        <source>Wave in the antrum</source>
        <translation>Ona a l’antre</translation>
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
        <source>Inspiration</source>
        <translation>Inspiració</translation>
    </message>
    <message>
        <source>Expiration</source>
        <translation>Espiració</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
</context>
</TS>
