<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Lesson</name>
    <message>
        <source>The organs in three dimensions</source>
        <translation>Los órganos en tres dimensiones</translation>
    </message>
    <message>
        <source>%1. Drag or use the arrow keys to turn, two fingers, the wheel or plus and minus to come nearer.</source>
        <translation>%1. Arrastre o use las flechas para girar; dos dedos, la rueda o más y menos para acercarse.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Diapositivas</translation>
    </message>
    <message>
        <source>Quiz</source>
        <translation>Cuestionario</translation>
    </message>
    <message>
        <source>Light or dark (T)</source>
        <translation>Claro u oscuro (T)</translation>
    </message>
    <message>
        <source>Seen from (1, 3, 7)</source>
        <translation>Visto desde (1, 3, 7)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Names of the parts (N)</source>
        <translation>Nombres de las partes (N)</translation>
    </message>
    <message>
        <source>Handles to drag (H)</source>
        <translation>Tiradores para arrastrar (H)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Drag a handle.</source>
        <translation>Arrastre un tirador.</translation>
    </message>
    <message>
        <source>Handle %1: arrow keys, plus and minus move it.</source>
        <translation>Tirador %1: las flechas, más y menos lo mueven.</translation>
    </message>
    <message>
        <source>Previous slide (Page Up)</source>
        <translation>Diapositiva anterior (Re Pág)</translation>
    </message>
    <message>
        <source>Next slide (Page Down)</source>
        <translation>Diapositiva siguiente (Av Pág)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 de %2: %3</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostrar %1</translation>
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
        <translation>%1 % del reposo</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1: fracción de eyección</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Gasto cardíaco</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normal %1</translation>
    </message>
    <message>
        <source>%1 of healthy people</source>
        <translation>%1 de personas sanas</translation>
    </message>
    <message>
        <source>without handles %1</source>
        <translation>sin tiradores %1</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Moment of the cycle</source>
        <translation>Momento del ciclo</translation>
    </message>
    <message>
        <source>%1 s, %2</source>
        <translation>%1 s, %2</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 por minuto</translation>
    </message>
    <message>
        <source>Volumes over one cycle: %1</source>
        <translation>Volúmenes en un ciclo: %1</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Space: play or stop
Arrow keys: turn the picture when it has the focus, else go through the cycle
Plus, minus: nearer, farther
Page Down, Page Up: next and previous slide; B: dark screen
J, K: choose a handle; arrow keys, plus and minus move it; Escape lets it go
1, 3, 7: front, left, above
N: names, H: handles, X: wall, R: reset, T: light or dark, Home: beginning</source>
        <translation>Espacio: reproducir o detener
Flechas: girar la imagen cuando tiene el foco; si no, recorrer el ciclo
Más, menos: acercar, alejar
Av Pág, Re Pág: diapositiva siguiente y anterior; B: pantalla oscura
J, K: elegir un tirador; las flechas, más y menos lo mueven; Escape lo suelta
1, 3, 7: delante, izquierda, arriba
N: nombres, H: tiradores, X: pared, R: restablecer, T: claro u oscuro, Inicio: principio</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Otra vez</translation>
    </message>
    <message>
        <source>Leave the quiz</source>
        <translation>Salir del cuestionario</translation>
    </message>
    <message>
        <source>What is marked?</source>
        <translation>¿Qué está marcado?</translation>
    </message>
    <message>
        <source>Which phase is this?</source>
        <translation>¿Qué fase es esta?</translation>
    </message>
    <message>
        <source>Which chamber shrinks now?</source>
        <translation>¿Qué cavidad se contrae ahora?</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambas</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Correcto.</translation>
    </message>
    <message>
        <source>No. The answer is: %1.</source>
        <translation>No. La respuesta es: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%1 de %2 correctas</translation>
    </message>
    <message>
        <source>%1 of %2 right.</source>
        <translation>%1 de %2 correctas.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later.</source>
        <translation>Esta lección necesita un navegador de 2023 o posterior.</translation>
    </message>
    <message>
        <source>This lesson needs WebGL 2. It may be switched off in this browser.</source>
        <translation>Esta lección necesita WebGL 2. Puede que esté desactivado en este navegador.</translation>
    </message>
    <message>
        <source>The graphics were lost. Load the page again.</source>
        <translation>Se perdieron los gráficos. Cargue la página de nuevo.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later, with JavaScript and WebGL 2.</source>
        <translation>Esta lección necesita un navegador de 2023 o posterior, con JavaScript y WebGL 2.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Normal range</source>
        <translation>Intervalo normal</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medición</translation>
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
        <translation>Texto de la diapositiva</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Tirador</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volumen después de comer</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of your language (BCP 47): numbers are written as it does.</extracomment>
        <translation>es</translation>
    </message>
    <message>
        <source>For teaching. It is not a medical device.</source>
        <translation>Para la enseñanza. No es un producto sanitario.</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Latido</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Peristaltismo gástrico</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Onda en el cuerpo gástrico</translation>
    </message>
    <message>
        <source>Terminal antral contraction</source>
        <translation>Contracción antral terminal</translation>
    </message>
    <message>
        <source>Wave fades at the pylorus</source>
        <translation>La onda se apaga en el píloro</translation>
    </message>
    <message>
        <source>Back to the original shape (R)</source>
        <translation>Volver a la forma original (R)</translation>
    </message>
    <message>
        <source>%1 % from moved handles</source>
        <translation>%1 % por tiradores movidos</translation>
    </message>
    <message>
        <source>Label in the view</source>
        <translation>Etiqueta en la vista</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Seccionar</translation>
    </message>
    <message>
        <source>Open the heart and look into it (C)</source>
        <translation>Abrir el corazón y mirar dentro (C)</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Sangre</translation>
    </message>
    <message>
        <source>Blood in the opened chambers (F)</source>
        <translation>Sangre en las cavidades abiertas (F)</translation>
    </message>
    <message>
        <source>Conduction</source>
        <translation>Conducción</translation>
    </message>
    <message>
        <source>Conduction system, lit with the electrocardiogram (E)</source>
        <translation>Sistema de conducción, se ilumina con el electrocardiograma (E)</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>ECG</translation>
    </message>
    <message>
        <source>C: cut open, F: blood, E: conduction system</source>
        <translation>C: abrir, F: sangre, E: sistema de conducción</translation>
    </message>
</context>
<context>
    <name>NewFile</name>
    <message>
        <source>Replace the file?</source>
        <translation>¿Sustituir el archivo?</translation>
    </message>
    <message>
        <source>%1 already exists. Do you want to replace it?</source>
        <translation>%1 ya existe. ¿Quiere sustituirlo?</translation>
    </message>
</context>
<context>
    <name>OrganLooks</name>
    <message>
        <source>Show only this</source>
        <translation>Mostrar solo este</translation>
    </message>
</context>
<context>
    <name>Tissue</name>
    <message>
        <source>Muscle</source>
        <translation>Músculo</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Riñón</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Bazo</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómago</translation>
    </message>
    <message>
        <source>Bowel</source>
        <translation>Intestino</translation>
    </message>
    <message>
        <source>Arterial blood</source>
        <translation>Sangre arterial</translation>
    </message>
    <message>
        <source>Venous blood</source>
        <translation>Sangre venosa</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Pulmón</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Grasa</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Otro color...</translation>
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
        <translation>Del &amp;archivo de imágenes...</translation>
    </message>
    <message>
        <source>Search a hospital&apos;s archive (PACS) for a patient and open a series</source>
        <translation>Buscar un paciente en el archivo de imágenes de un hospital (PACS) y abrir una serie</translation>
    </message>
    <message>
        <source>No archive is called %1 here. Add it, then open the session again.</source>
        <translation>Ningún archivo de imágenes se llama %1 aquí. Añádalo y abra la sesión de nuevo.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveClient</name>
    <message>
        <source>Forgetting the password</source>
        <translation>Olvidando la contraseña</translation>
    </message>
    <message>
        <source>Testing %1</source>
        <translation>Probando %1</translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation>Buscando en %1</translation>
    </message>
    <message>
        <source>Sending to %1</source>
        <translation>Enviando a %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveDialog</name>
    <message>
        <source>The beginning of the name; * stands for any letters</source>
        <translation>El principio del nombre; * vale por letras cualesquiera</translation>
    </message>
    <message>
        <source>The beginning of the number of the patient</source>
        <translation>El principio del número del paciente</translation>
    </message>
    <message>
        <source>The first day of the study, as 2024-03-01</source>
        <translation>El primer día del estudio, como 2024-03-01</translation>
    </message>
    <message>
        <source>The last day of the study, as 2024-03-31</source>
        <translation>El último día del estudio, como 2024-03-31</translation>
    </message>
    <message>
        <source>From the archive</source>
        <translation>Del archivo de imágenes</translation>
    </message>
    <message>
        <source>Fetch what is chosen and open it</source>
        <translation>Traer lo elegido y abrirlo</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivo de imágenes</translation>
    </message>
    <message>
        <source>The archive to search</source>
        <translation>El archivo de imágenes en el que buscar</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Añadir...</translation>
    </message>
    <message>
        <source>Name another archive</source>
        <translation>Nombrar otro archivo de imágenes</translation>
    </message>
    <message>
        <source>Edit...</source>
        <translation>Editar...</translation>
    </message>
    <message>
        <source>Change the address and the titles of this archive</source>
        <translation>Cambiar la dirección y los títulos de este archivo de imágenes</translation>
    </message>
    <message>
        <source>Forget this archive and its password</source>
        <translation>Olvidar este archivo de imágenes y su contraseña</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Ask whether the archive answers</source>
        <translation>Preguntar si el archivo de imágenes responde</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Cualquiera</translation>
    </message>
    <message>
        <source>Only studies with images of this kind</source>
        <translation>Solo estudios con imágenes de este tipo</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>List the studies that match (Return)</source>
        <translation>Listar los estudios que coinciden (Intro)</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>Nombre del paciente</translation>
    </message>
    <message>
        <source>Patient&apos;s number</source>
        <translation>Número del paciente</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalidad</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>AAAA-MM-DD</translation>
    </message>
    <message>
        <source>Studies and series</source>
        <translation>Estudios y series</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Stop; nothing incomplete is kept</source>
        <translation>Parar; no se guarda nada incompleto</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was kept.</source>
        <translation>Cancelado. No se ha guardado nada.</translation>
    </message>
    <message>
        <source>No archive is named yet. Add one: its address, and for the classic services its title.</source>
        <translation>Aún no hay ningún archivo de imágenes. Añada uno: su dirección y, para los servicios clásicos, su título.</translation>
    </message>
    <message>
        <source>Remove the archive?</source>
        <translation>¿Quitar el archivo de imágenes?</translation>
    </message>
    <message>
        <source>Forget %1 and its password?</source>
        <translation>¿Olvidar %1 y su contraseña?</translation>
    </message>
    <message>
        <source>%1 answers.</source>
        <translation>%1 responde.</translation>
    </message>
    <message>
        <source>%1 is no day. Write it as 2024-03-01.</source>
        <translation>%1 no es un día. Escríbalo como 2024-03-01.</translation>
    </message>
    <message>
        <source>No study matches.</source>
        <translation>Ningún estudio coincide.</translation>
    </message>
    <message numerus="yes">
        <source>%n studies. Open one to see its series.</source>
        <translation>
            <numerusform>%n estudio. Despliéguelo para ver sus series.</numerusform>
            <numerusform>%n estudios. Despliegue uno para ver sus series.</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>This study has no series.</source>
        <translation>Este estudio no tiene series.</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Abrir el estudio</translation>
    </message>
</context>
<context>
    <name>viscera::app::AxisPicker</name>
    <message>
        <source>Axes of the heart, from which segments count: set by clicks</source>
        <translation>Ejes del corazón, desde los que se cuentan los segmentos: se fijan con clics</translation>
    </message>
    <message>
        <source>Anterior insertion of the right ventricle</source>
        <translation>Inserción anterior del ventrículo derecho</translation>
    </message>
</context>
<context>
    <name>viscera::app::BeatStrip</name>
    <message>
        <source>Electrocardiogram, heart sounds and valves</source>
        <translation>Electrocardiograma, ruidos cardíacos y válvulas</translation>
    </message>
    <message>
        <source>Schematic electrocardiogram, heart sounds S1 and S2 when the valves close, and a bar for each valve while it is open. The lamp is lit while the valve is open.</source>
        <translation>Electrocardiograma esquemático, ruidos S1 y S2 al cerrarse las válvulas y una barra para cada válvula mientras está abierta. La luz está encendida mientras la válvula está abierta.</translation>
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
        <translation>%1: sin vincular a estos tiradores; se canceló la vinculación.</translation>
    </message>
    <message>
        <source>Bind now</source>
        <translation>Vincular ahora</translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 have no coordinates in the cage.</source>
        <translation>
            <numerusform>%n vértice de %1 no tiene coordenadas en la jaula.</numerusform>
            <numerusform>%n vértices de %1 no tienen coordenadas en la jaula.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie in no group&apos;s region.</source>
        <translation>
            <numerusform>%n vértice de %1 no está en la región de ningún grupo.</numerusform>
            <numerusform>%n vértices de %1 no están en la región de ningún grupo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles&apos; hull.</source>
        <translation>
            <numerusform>%n vértice de %1 está fuera de la envolvente de los tiradores.</numerusform>
            <numerusform>%n vértices de %1 están fuera de la envolvente de los tiradores.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.</source>
        <translation>
            <numerusform>%n vértice de %1 está fuera de los tiradores del movimiento; %1 queda en reposo.</numerusform>
            <numerusform>%n vértices de %1 están fuera de los tiradores del movimiento; %1 queda en reposo.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CinePage</name>
    <message>
        <source>Open study</source>
        <translation>Estudio abierto</translation>
    </message>
    <message>
        <source>Take the images that are open in the window</source>
        <translation>Tomar las imágenes abiertas en la ventana</translation>
    </message>
    <message>
        <source>Images...</source>
        <translation>Imágenes...</translation>
    </message>
    <message>
        <source>A folder with the DICOM files of a cine study</source>
        <translation>Una carpeta con los archivos DICOM de un estudio de cine</translation>
    </message>
    <message>
        <source>Image file...</source>
        <translation>Archivo de imágenes...</translation>
    </message>
    <message>
        <source>One file of images over time: 4D NIfTI or .seq.nrrd</source>
        <translation>Un archivo de imágenes en el tiempo: NIfTI 4D o .seq.nrrd</translation>
    </message>
    <message>
        <source>Labels...</source>
        <translation>Etiquetas...</translation>
    </message>
    <message>
        <source>Label maps or surfaces of single phases: the ends of diastole and systole at least</source>
        <translation>Mapas de etiquetas o superficies de fases sueltas: al menos los finales de diástole y sístole</translation>
    </message>
    <message>
        <source>Folder of one phase...</source>
        <translation>Carpeta de una fase...</translation>
    </message>
    <message>
        <source>A folder with all surfaces of one phase</source>
        <translation>Una carpeta con todas las superficies de una fase</translation>
    </message>
    <message>
        <source>Labels and their phases</source>
        <translation>Etiquetas y sus fases</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Looking through the images</source>
        <translation>Examinando las imágenes</translation>
    </message>
    <message>
        <source>Folder with a cine study</source>
        <translation>Carpeta con un estudio de cine</translation>
    </message>
    <message>
        <source>Images over time</source>
        <translation>Imágenes en el tiempo</translation>
    </message>
    <message>
        <source>Labels of single phases</source>
        <translation>Etiquetas de fases sueltas</translation>
    </message>
    <message>
        <source>Surfaces of one phase</source>
        <translation>Superficies de una fase</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>sin indicar</translation>
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
        <translation>Deducido del nombre y de las imágenes: compruébelo</translation>
    </message>
    <message>
        <source>The phase that these labels belong to</source>
        <translation>La fase a la que pertenecen estas etiquetas</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>Omitir %1</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>Leyendo %1 ...</translation>
    </message>
    <message>
        <source>No images are chosen.</source>
        <translation>No hay imágenes elegidas.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 phases, %n planes</source>
        <translation>
            <numerusform>%1: %2 fases, %n plano</numerusform>
            <numerusform>%1: %2 fases, %n planos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationBox</name>
    <message>
        <source>Preload: stressed blood</source>
        <translation>Precarga: volumen estresado</translation>
    </message>
    <message>
        <source>Afterload: body</source>
        <translation>Poscarga: sistémica</translation>
    </message>
    <message>
        <source>Afterload: lungs</source>
        <translation>Poscarga: pulmonar</translation>
    </message>
    <message>
        <source>Contractility, left</source>
        <translation>Contractilidad, izda.</translation>
    </message>
    <message>
        <source>Contractility, right</source>
        <translation>Contractilidad, dcha.</translation>
    </message>
    <message>
        <source>Stiffness, left</source>
        <translation>Rigidez, izda.</translation>
    </message>
    <message>
        <source>%1, %2 at rest</source>
        <translation>%1, %2 en reposo</translation>
    </message>
    <message>
        <source>%1. Marked: normal, %2 %3 (%4)</source>
        <translation>%1. Marcado: normal, %2 %3 (%4)</translation>
    </message>
    <message>
        <source>Only the sample heart can be moved by the circulation model; the charts show its results for any organ.</source>
        <translation>El modelo de circulación solo puede mover el corazón de muestra; las gráficas muestran sus resultados con cualquier órgano.</translation>
    </message>
    <message>
        <source>Textbook beat</source>
        <translation>Latido de manual</translation>
    </message>
    <message>
        <source>Volumes of healthy adults over one beat at this rate</source>
        <translation>Volúmenes de adultos sanos en un latido a esta frecuencia</translation>
    </message>
    <message>
        <source>A model of heart and vessels: pressures, pressure-volume loops, valves and sounds</source>
        <translation>Modelo del corazón y los vasos: presiones, bucles presión-volumen, válvulas y ruidos</translation>
    </message>
    <message>
        <source>Rate, preload, afterload</source>
        <translation>Frecuencia, precarga, poscarga</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Músculo</translation>
    </message>
    <message>
        <source>Valves and pericardium</source>
        <translation>Válvulas y pericardio</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Antes: %1</translation>
    </message>
    <message>
        <source>Fitted to the volume and the ejection fraction of a left ventricle.</source>
        <translation>Ajustada al volumen y a la fracción de eyección de un ventrículo izquierdo.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationModel</name>
    <message>
        <source>Heart of the circulation</source>
        <translation>Corazón de la circulación</translation>
    </message>
</context>
<context>
    <name>viscera::app::ComparedSystem</name>
    <message>
        <source>Coordinates of the second view</source>
        <translation>Coordenadas de la segunda vista</translation>
    </message>
    <message>
        <source>Coordinate system that binds the same organs to the same handles in this view</source>
        <translation>Sistema de coordenadas que vincula los mismos órganos a los mismos tiradores en esta vista</translation>
    </message>
</context>
<context>
    <name>viscera::app::Comparison</name>
    <message>
        <source>Rate of the second view</source>
        <translation>Frecuencia de la segunda vista</translation>
    </message>
    <message>
        <source> / min</source>
        <translation> / min</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>Qué muestra esta vista</translation>
    </message>
    <message>
        <source>The same organ at another rate</source>
        <translation>El mismo órgano a otra frecuencia</translation>
    </message>
    <message>
        <source>The same organ with other coordinates</source>
        <translation>El mismo órgano con otras coordenadas</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Abrir archivos...</translation>
    </message>
    <message>
        <source>Back to one view</source>
        <translation>Volver a una vista</translation>
    </message>
    <message>
        <source>Open beside the first organ</source>
        <translation>Abrir junto al primer órgano</translation>
    </message>
    <message>
        <source>No organ yet</source>
        <translation>Aún no hay órganos</translation>
    </message>
    <message>
        <source>  %1 / min</source>
        <translation>  %1 / min</translation>
    </message>
    <message>
        <source>The errors of both coordinate systems</source>
        <translation>Los errores de ambos sistemas de coordenadas</translation>
    </message>
    <message>
        <source>The second view of the session is not shown: %1 is not installed here.</source>
        <translation>La segunda vista de la sesión no se muestra: %1 no está instalado aquí.</translation>
    </message>
    <message>
        <source>The same organ, kept in the present pose</source>
        <translation>El mismo órgano, conservado en la pose actual</translation>
    </message>
    <message>
        <source>Colour each vertex by its distance to the same vertex in view 1; while stress is shown, by what view 1 has more than view 2</source>
        <translation>Colorear cada vértice según su distancia al mismo vértice de la vista 1; con el estrés a la vista, según lo que la vista 1 tiene de más que la vista 2</translation>
    </message>
    <message>
        <source>Present pose</source>
        <translation>Pose actual</translation>
    </message>
    <message>
        <source>Kept pose</source>
        <translation>Pose guardada</translation>
    </message>
</context>
<context>
    <name>viscera::app::ConnectionDialog</name>
    <message>
        <source>Secure connection (TLS)</source>
        <translation>Conexión segura (TLS)</translation>
    </message>
    <message>
        <source>Add an archive</source>
        <translation>Añadir un archivo de imágenes</translation>
    </message>
    <message>
        <source>Edit an archive</source>
        <translation>Editar un archivo de imágenes</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>Classic DICOM services (DIMSE)</source>
        <translation>Servicios DICOM clásicos (DIMSE)</translation>
    </message>
    <message>
        <source>The name under which you choose the archive</source>
        <translation>El nombre con el que se elige el archivo de imágenes</translation>
    </message>
    <message>
        <source>Leave it empty where the archive asks for no password</source>
        <translation>Déjelo vacío si el archivo de imágenes no pide contraseña</translation>
    </message>
    <message>
        <source>The title (AE title) of the archive, at most 16 characters</source>
        <translation>El título (AE title) del archivo de imágenes, 16 caracteres como máximo</translation>
    </message>
    <message>
        <source>The title by which the archive knows this program</source>
        <translation>El título con el que el archivo de imágenes conoce este programa</translation>
    </message>
    <message>
        <source>How long the archive may be silent</source>
        <translation>Cuánto tiempo puede callar el archivo de imágenes</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Title of the archive</source>
        <translation>Título del archivo de imágenes</translation>
    </message>
    <message>
        <source>Title of this program</source>
        <translation>Título de este programa</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Certificados de confianza</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>Paciencia</translation>
    </message>
    <message>
        <source>Those of the system</source>
        <translation>Los del sistema</translation>
    </message>
    <message>
        <source>A file with the certificate of the archive&apos;s issuer (.pem)</source>
        <translation>Un archivo con el certificado del emisor del archivo de imágenes (.pem)</translation>
    </message>
    <message>
        <source>Choose the file with the certificates</source>
        <translation>Elegir el archivo con los certificados</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt);;All files (*)</source>
        <translation>Certificados (*.pem *.crt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Give the archive a name.</source>
        <translation>Dé un nombre al archivo de imágenes.</translation>
    </message>
    <message>
        <source>Another archive has this name.</source>
        <translation>Otro archivo de imágenes tiene este nombre.</translation>
    </message>
    <message>
        <source>Type the address of the archive.</source>
        <translation>Escriba la dirección del archivo de imágenes.</translation>
    </message>
    <message>
        <source>The address of DICOMweb begins with http:// or https://.</source>
        <translation>La dirección de DICOMweb empieza por http:// o https://.</translation>
    </message>
    <message>
        <source>The address holds no user and no password.</source>
        <translation>La dirección no contiene usuario ni contraseña.</translation>
    </message>
    <message>
        <source>A title has 1 to 16 plain characters.</source>
        <translation>Un título tiene de 1 a 16 caracteres simples.</translation>
    </message>
    <message>
        <source>Images travel readable for others in the network, and so does a password.</source>
        <translation>Las imágenes viajan legibles para otros en la red, y también una contraseña.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourCorrector</name>
    <message>
        <source>Only contours of a motion that was found in images can be corrected.</source>
        <translation>Solo se pueden corregir contornos de un movimiento encontrado en imágenes.</translation>
    </message>
    <message>
        <source>The motion is being fitted to the last correction.</source>
        <translation>El movimiento se está ajustando a la última corrección.</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact. Correct a phase between them, or change its labels.</source>
        <translation>La fase %1 tiene etiquetas, que son exactas. Corrija una fase intermedia o cambie sus etiquetas.</translation>
    </message>
    <message>
        <source>This organ is not moved by the motion that was found in images.</source>
        <translation>Este órgano no lo mueve el movimiento encontrado en las imágenes.</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Corregir contorno</translation>
    </message>
    <message numerus="yes">
        <source>The motion is that of the images again. %n phases have changed.</source>
        <translation>
            <numerusform>El movimiento vuelve a ser el de las imágenes. Ha cambiado %n fase.</numerusform>
            <numerusform>El movimiento vuelve a ser el de las imágenes. Han cambiado %n fases.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases have changed.</source>
        <translation>
            <numerusform>Ha cambiado %n fase.</numerusform>
            <numerusform>Han cambiado %n fases.</numerusform>
        </translation>
    </message>
    <message>
        <source>The motion meets all corrected contours to %1 mm.</source>
        <translation>El movimiento pasa por todos los contornos corregidos con un error de %1 mm.</translation>
    </message>
    <message>
        <source>The corrected contour of %1 in phase %2 is met to %3 mm only.</source>
        <translation>El contorno corregido de %1 en la fase %2 solo se alcanza con un error de %3 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourGrip</name>
    <message>
        <source>Correct &amp;contours</source>
        <translation>Corregir &amp;contornos</translation>
    </message>
    <message>
        <source>Drag the contour of a tracked organ in a slice: the motion is fitted to it. Ctrl does the same while it is held. Enabled for a motion that was found in images</source>
        <translation>Arrastre el contorno de un órgano seguido en un corte: el movimiento se ajusta a él. Ctrl hace lo mismo mientras se mantiene pulsada. Disponible para un movimiento encontrado en imágenes</translation>
    </message>
    <message>
        <source>&amp;Remove a corrected contour</source>
        <translation>&amp;Quitar un contorno corregido</translation>
    </message>
    <message>
        <source>%1, slice %2, phase %3</source>
        <translation>%1, corte %2, fase %3</translation>
    </message>
</context>
<context>
    <name>viscera::app::CurveBox</name>
    <message>
        <source>Curve...</source>
        <translation>Curva...</translation>
    </message>
    <message>
        <source>Organ whose volume is prescribed</source>
        <translation>Órgano cuyo volumen se prescribe</translation>
    </message>
    <message>
        <source>A .csv file with two columns: the fraction of the cycle (or time_s) and the volume in ml. At each instant the handles move as little as possible to reach that volume</source>
        <translation>Archivo .csv con dos columnas: la fracción del ciclo (o time_s) y el volumen en ml. En cada instante los tiradores se mueven lo mínimo para alcanzar ese volumen</translation>
    </message>
    <message>
        <source>Let the sequence alone determine the volume again</source>
        <translation>Dejar de nuevo que solo la secuencia determine el volumen</translation>
    </message>
    <message>
        <source>Volume curves (*.csv *.txt *.tsv)</source>
        <translation>Curvas de volumen (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>%1 follows %2; dashed in the chart.</source>
        <translation>%1 sigue %2; línea discontinua en la gráfica.</translation>
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
        <translation>Retirar el lado izquierdo</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Cut away the part nearest to the viewer</source>
        <translation>Retirar lo más cercano al observador</translation>
    </message>
    <message>
        <source>Distance of the cut from the middle of the organs, in per cent of the distance to their edge</source>
        <translation>Distancia de la sección al centro de los órganos, en porcentaje de la distancia hasta su borde</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Sangre</translation>
    </message>
    <message>
        <source>Fill chambers and vessels of the heart with blood. Without it they are empty and show walls, papillary muscles and valves</source>
        <translation>Llenar de sangre las cavidades y los vasos del corazón. Sin ella están vacíos y muestran paredes, músculos papilares y válvulas</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformMode</name>
    <message>
        <source>Drag a handle and the organ follows; K locks the volume, T turns and scales, M mirrors</source>
        <translation>Arrastre un tirador y el órgano lo sigue; K bloquea el volumen, T gira y escala, M refleja</translation>
    </message>
    <message>
        <source>&amp;Turn and scale</source>
        <translation>&amp;Girar y escalar</translation>
    </message>
    <message>
        <source>In Deform mode, rings turn and cubes scale the selected handles (at least two)</source>
        <translation>En el modo Deformar, los anillos giran y los cubos escalan los tiradores seleccionados (dos como mínimo)</translation>
    </message>
    <message>
        <source>Reset &amp;pose</source>
        <translation>Restablecer la &amp;pose</translation>
    </message>
    <message>
        <source>Move every handle back to its rest position</source>
        <translation>Devolver todos los tiradores a su posición de reposo</translation>
    </message>
    <message>
        <source>Reset selected handles</source>
        <translation>Restablecer tiradores seleccionados</translation>
    </message>
    <message>
        <source>Move the selected handles back to their rest positions</source>
        <translation>Devolver los tiradores seleccionados a su posición de reposo</translation>
    </message>
    <message>
        <source>Restore &amp;rest volume</source>
        <translation>Restaurar volumen de &amp;reposo</translation>
    </message>
    <message>
        <source>Restore the organ&apos;s volume at rest with the smallest motion of the handles</source>
        <translation>Restaurar el volumen del órgano en reposo con el menor movimiento de los tiradores</translation>
    </message>
    <message>
        <source>Selected handles &amp;compensate</source>
        <translation>&amp;Compensar con los seleccionados</translation>
    </message>
    <message>
        <source>Only the selected handles compensate when others would change a locked volume</source>
        <translation>Solo los tiradores seleccionados compensan cuando otros cambiarían un volumen bloqueado</translation>
    </message>
    <message>
        <source>&amp;Off</source>
        <translation>&amp;Ninguno</translation>
    </message>
    <message>
        <source>&amp;Sagittal plane</source>
        <translation>Plano &amp;sagital</translation>
    </message>
    <message>
        <source>&amp;Coronal plane</source>
        <translation>Plano &amp;coronal</translation>
    </message>
    <message>
        <source>&amp;Axial plane</source>
        <translation>Plano &amp;axial</translation>
    </message>
    <message>
        <source>In Deform mode, mirrored handles move along with a drag</source>
        <translation>En el modo Deformar, los tiradores simétricos acompañan el arrastre</translation>
    </message>
    <message>
        <source>&amp;Next mirror plane</source>
        <translation>&amp;Siguiente plano de simetría</translation>
    </message>
    <message>
        <source>Switch between off, sagittal, coronal and axial</source>
        <translation>Alternar entre ninguno, sagital, coronal y axial</translation>
    </message>
    <message>
        <source>Move e&amp;xactly, others compensate</source>
        <translation>Mover e&amp;xactamente, los demás compensan</translation>
    </message>
    <message>
        <source>Under a locked volume, moved handles go exactly where they are sent, and the others compensate; else a moved handle stays where the volume lets it</source>
        <translation>Con un volumen bloqueado, los tiradores van exactamente adonde se envían y los demás compensan; si no, un tirador queda donde el volumen lo deja</translation>
    </message>
    <message>
        <source>&amp;Free handles follow</source>
        <translation>Los tiradores &amp;libres siguen</translation>
    </message>
    <message>
        <source>Handles that you do not drag go to where the elastic energy of the organs&apos; tissue is least; locked handles hold it, else it moves as a whole. Locked volumes stay exact. The first drag takes about a second, the next ones a tenth of a second a step</source>
        <translation>Los tiradores que no arrastra van adonde la energía elástica del tejido de los órganos es mínima; los bloqueados lo sujetan, si no se mueve en bloque. Los volúmenes bloqueados se mantienen exactos. El primer arrastre tarda alrededor de un segundo, los siguientes una décima de segundo por paso</translation>
    </message>
    <message>
        <source>&amp;Beside elasticity</source>
        <translation>&amp;Junto a la elasticidad</translation>
    </message>
    <message>
        <source>Show the current organ as an elastic body that the moved handles grip, as a ghost, and colour the organ by the distance from it; the other handles hold it. It takes some seconds after each drag</source>
        <translation>Muestra el órgano actual como un cuerpo elástico que sujetan los tiradores movidos, como un fantasma, y colorea el órgano según la distancia a él; los demás tiradores lo sostienen. Tarda unos segundos tras cada arrastre</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformPage</name>
    <message>
        <source>Largest shift</source>
        <translation>Desplazamiento máximo</translation>
    </message>
    <message>
        <source>The largest distance by which a vertex of the organ has moved from rest</source>
        <translation>La mayor distancia que un vértice del órgano se ha movido desde el reposo</translation>
    </message>
    <message>
        <source>Selected handles</source>
        <translation>Tiradores seleccionados</translation>
    </message>
    <message>
        <source>Compensating</source>
        <translation>Compensan</translation>
    </message>
    <message>
        <source>These handles compensate when others would change a locked volume. If none is marked, a dragged handle stays in a plane, and all free handles compensate for other motions.</source>
        <translation>Estos tiradores compensan cuando otros cambiarían un volumen bloqueado. Si no se marca ninguno, el tirador arrastrado permanece en un plano y todos los tiradores libres compensan los demás movimientos.</translation>
    </message>
    <message>
        <source>Symmetric drags</source>
        <translation>Arrastres simétricos</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Handles moved</source>
        <translation>Tiradores movidos</translation>
    </message>
    <message>
        <source>Mirror plane</source>
        <translation>Plano de simetría</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Sagittal plane (left and right)</source>
        <translation>Plano sagital (izquierda y derecha)</translation>
    </message>
    <message>
        <source>Coronal plane (front and back)</source>
        <translation>Plano coronal (delante y detrás)</translation>
    </message>
    <message>
        <source>Axial plane (head and feet)</source>
        <translation>Plano axial (cabeza y pies)</translation>
    </message>
    <message>
        <source>A drag moves the mirrored handles too; the mirror plane passes through the middle of the organ at rest (M: next plane)</source>
        <translation>El arrastre mueve también los tiradores simétricos; el plano de simetría pasa por el centro del órgano en reposo (M: plano siguiente)</translation>
    </message>
    <message>
        <source>Moves along</source>
        <translation>Acompaña</translation>
    </message>
    <message>
        <source>no handle is near the mirror image</source>
        <translation>ningún tirador cerca de la imagen especular</translation>
    </message>
    <message>
        <source>all free handles</source>
        <translation>todos los libres</translation>
    </message>
    <message>
        <source>Elasticity</source>
        <translation>Elasticidad</translation>
    </message>
    <message>
        <source>Median distance</source>
        <translation>Distancia mediana</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Distancia máxima</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomDialog</name>
    <message>
        <source>Segmentation (SEG)</source>
        <translation>Segmentación (SEG)</translation>
    </message>
    <message>
        <source>The organs as voxels on the grid of the scan, one file for each instant</source>
        <translation>Los órganos como vóxeles en la cuadrícula del estudio, un archivo por instante</translation>
    </message>
    <message>
        <source>Measurements (SR)</source>
        <translation>Mediciones (SR)</translation>
    </message>
    <message>
        <source>A structured report of volumes, distances and angles for each instant</source>
        <translation>Un informe estructurado de volúmenes, distancias y ángulos por instante</translation>
    </message>
    <message>
        <source>Surfaces (STL)</source>
        <translation>Superficies (STL)</translation>
    </message>
    <message>
        <source>The surface of each organ, one file for each</source>
        <translation>La superficie de cada órgano, un archivo para cada uno</translation>
    </message>
    <message>
        <source>Contours (RTSTRUCT)</source>
        <translation>Contornos (RTSTRUCT)</translation>
    </message>
    <message>
        <source>Contours on the slices of the scan, for radiotherapy</source>
        <translation>Contornos en los cortes del estudio, para radioterapia</translation>
    </message>
    <message>
        <source>Without identity</source>
        <translation>Sin identidad</translation>
    </message>
    <message>
        <source>No name, number or date of the patient, and new identifiers of study and series</source>
        <translation>Sin nombre, número ni fecha del paciente, y con nuevos identificadores de estudio y serie</translation>
    </message>
    <message>
        <source>Export as DICOM</source>
        <translation>Exportar como DICOM</translation>
    </message>
    <message>
        <source>The pose that is shown</source>
        <translation>La pose que se muestra</translation>
    </message>
    <message>
        <source>So many instants of one cycle of the motion</source>
        <translation>Tantos instantes de un ciclo del movimiento</translation>
    </message>
    <message>
        <source>No motion moves the organs</source>
        <translation>Ningún movimiento mueve los órganos</translation>
    </message>
    <message>
        <source>Instants</source>
        <translation>Instantes</translation>
    </message>
    <message>
        <source>Whose they are</source>
        <translation>De quién son</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destino</translation>
    </message>
    <message>
        <source>For research and teaching, not for diagnosis.</source>
        <translation>Para investigación y docencia, no para diagnóstico.</translation>
    </message>
    <message>
        <source>The files of the scan are being read</source>
        <translation>Se leen los archivos del estudio</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>Contours need the slices of a scan</source>
        <translation>Los contornos necesitan los cortes de un estudio</translation>
    </message>
    <message>
        <source>The organs that are written</source>
        <translation>Los órganos que se escriben</translation>
    </message>
    <message>
        <source>%1 is open and has no inside</source>
        <translation>%1 está abierto y no tiene interior</translation>
    </message>
    <message>
        <source>The elements of each file that say whose it is</source>
        <translation>Los elementos de cada archivo que dicen de quién es</translation>
    </message>
    <message>
        <source>A folder, or an archive that From the archive knows</source>
        <translation>Una carpeta, o un archivo de imágenes que «Del archivo de imágenes» conoce</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Made when it is not there; no file in it is replaced</source>
        <translation>Se crea si no existe; no se reemplaza ningún archivo en ella</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Elegir la carpeta</translation>
    </message>
    <message>
        <source>No DICOM scan says whose they are: they get a study of their own.</source>
        <translation>Ninguna imagen DICOM dice de quién son: reciben un estudio propio.</translation>
    </message>
    <message>
        <source>Choose at least one object.</source>
        <translation>Elija al menos un objeto.</translation>
    </message>
    <message>
        <source>Choose at least one organ; its surface has to be closed.</source>
        <translation>Elija al menos un órgano; su superficie debe estar cerrada.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Elija una carpeta.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Enviar</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomExports</name>
    <message>
        <source>Export as &amp;DICOM...</source>
        <translation>Exportar como &amp;DICOM...</translation>
    </message>
    <message>
        <source>Write organs and measurements as DICOM files, or send them to an archive (PACS)</source>
        <translation>Escribir órganos y mediciones como archivos DICOM, o enviarlos a un archivo de imágenes (PACS)</translation>
    </message>
    <message>
        <source>Reading whose the scan is</source>
        <translation>Leyendo de quién es el estudio</translation>
    </message>
    <message>
        <source>segmentations</source>
        <translation>segmentaciones</translation>
    </message>
    <message>
        <source>structured reports</source>
        <translation>informes estructurados</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>superficies</translation>
    </message>
    <message>
        <source>structure sets</source>
        <translation>conjuntos de estructuras</translation>
    </message>
    <message>
        <source>Exporting as DICOM</source>
        <translation>Exportando como DICOM</translation>
    </message>
    <message>
        <source>Written to %1: %2</source>
        <translation>Escrito en %1: %2</translation>
    </message>
    <message>
        <source>Sent to %1: %2</source>
        <translation>Enviado a %1: %2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DifferenceMap</name>
    <message>
        <source>Distance to view 1</source>
        <translation>Distancia a la vista 1</translation>
    </message>
    <message>
        <source>%1: view 1 less view 2</source>
        <translation>%1: vista 1 menos vista 2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DisplacementBox</name>
    <message>
        <source>Right to left</source>
        <translation>Derecha a izquierda</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>Delante a detrás</translation>
    </message>
    <message>
        <source>Foot to head</source>
        <translation>Pies a cabeza</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s left; negative: right (R/L)</source>
        <translation>Hacia la izquierda del paciente; negativo: derecha (R/L)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s back; negative: front (A/P)</source>
        <translation>Hacia la espalda del paciente; negativo: delante (A/P)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s head; negative: feet (S/I)</source>
        <translation>Hacia la cabeza del paciente; negativo: pies (S/I)</translation>
    </message>
    <message>
        <source>Move the selected handles once by this distance; locked volumes are kept</source>
        <translation>Mover una vez esta distancia los tiradores seleccionados; los volúmenes bloqueados se mantienen</translation>
    </message>
    <message>
        <source>Moved by %1 of %2 mm: the locked volume allows no more in this direction.</source>
        <translation>Movido %1 de %2 mm: el volumen bloqueado no permite más en esta dirección.</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Mover</translation>
    </message>
</context>
<context>
    <name>viscera::app::ElasticGhost</name>
    <message>
        <source>There is no organ to compare.</source>
        <translation>No hay ningún órgano que comparar.</translation>
    </message>
    <message>
        <source>Move a handle: at rest there is nothing to compare.</source>
        <translation>Mueva un tirador: en reposo no hay nada que comparar.</translation>
    </message>
    <message>
        <source>The elastic organ is being computed.</source>
        <translation>Se está calculando el órgano elástico.</translation>
    </message>
    <message>
        <source>Only an organ that follows the handles can be compared.</source>
        <translation>Solo se puede comparar un órgano que sigue los tiradores.</translation>
    </message>
    <message>
        <source>Elastic organ</source>
        <translation>Órgano elástico</translation>
    </message>
    <message>
        <source>The comparison was cancelled. Move a handle, or switch it off and on again.</source>
        <translation>La comparación se canceló. Mueva un tirador, o desactívela y vuelva a activarla.</translation>
    </message>
    <message>
        <source>Distance from elasticity</source>
        <translation>Distancia a la elasticidad</translation>
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
        <translation>La mayor distancia entre 1 y la suma de los pesos de un vértice</translation>
    </message>
    <message>
        <source>Negative where the system is not positive</source>
        <translation>Negativo donde el sistema no es positivo</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Fallos</translation>
    </message>
    <message>
        <source>Vertices for which the system has no coordinates; they do not move</source>
        <translation>Vértices para los que el sistema no tiene coordenadas; no se mueven</translation>
    </message>
    <message>
        <source>Binding time</source>
        <translation>Tiempo de vinculación</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExploreMode</name>
    <message>
        <source>Explore</source>
        <translation>Explorar</translation>
    </message>
    <message>
        <source>Left drag rotates, Shift+left pans, right drag or wheel zooms, click selects an organ, D and A measure</source>
        <translation>Arrastrar con el botón izquierdo gira; Mayús+izquierdo desplaza; arrastrar con el botón derecho o la rueda acerca; un clic selecciona un órgano; D y A miden</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; Esc ends</source>
        <translation>Haga clic en dos puntos de un órgano o un corte; Esc termina</translation>
    </message>
    <message>
        <source>Measure &amp;distance</source>
        <translation>Medir &amp;distancia</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Measure &amp;angle</source>
        <translation>Medir á&amp;ngulo</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; Esc ends</source>
        <translation>Haga clic en tres puntos de un órgano o un corte, el vértice en segundo lugar; Esc termina</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;rectangle</source>
        <translation>Medir los valores en un &amp;rectángulo</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Arrastre en un corte de esquina a esquina: media y desviación de los valores del estudio; Esc termina</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;sphere</source>
        <translation>Medir los valores en una &amp;esfera</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Arrastre en un corte del centro al borde: media y desviación de los valores del estudio; Esc termina</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Remove all &amp;measurements</source>
        <translation>&amp;Quitar todas las mediciones</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Mediciones</translation>
    </message>
    <message>
        <source>Show the measurements</source>
        <translation>Mostrar las mediciones</translation>
    </message>
    <message>
        <source>Names of &amp;parts</source>
        <translation>Nombres de las &amp;partes</translation>
    </message>
    <message>
        <source>Name the parts of the organs, such as the apex of the heart</source>
        <translation>Nombrar las partes de los órganos, como el ápex del corazón</translation>
    </message>
    <message>
        <source>&amp;Quiz on the parts</source>
        <translation>&amp;Cuestionario sobre las partes</translation>
    </message>
    <message>
        <source>Hide the names and ask for one part after the other; answer with a click on the organ</source>
        <translation>Ocultar los nombres y preguntar las partes una a una; se responde con un clic en el órgano</translation>
    </message>
    <message>
        <source>%1. Drags turn the view, Esc ends the quiz</source>
        <translation>%1. Arrastrar gira la vista, Esc termina el cuestionario</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; drags turn the view, Esc ends</source>
        <translation>Haga clic en dos puntos de un órgano o un corte; arrastrar gira la vista, Esc termina</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; drags turn the view, Esc ends</source>
        <translation>Haga clic en tres puntos de un órgano o un corte, el vértice en segundo lugar; arrastrar gira la vista, Esc termina</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner; Esc ends</source>
        <translation>Arrastre en un corte de esquina a esquina; Esc termina</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle of a sphere to its border; Esc ends</source>
        <translation>Arrastre en un corte del centro de una esfera a su borde; Esc termina</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExplorePage</name>
    <message>
        <source>View from</source>
        <translation>Ver desde</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Rest volume</source>
        <translation>Volumen en reposo</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Vóxeles</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaciado</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>cerrada</translation>
    </message>
    <message numerus="yes">
        <source>open, %n edges</source>
        <translation>
            <numerusform>abierta, %n arista</numerusform>
            <numerusform>abierta, %n aristas</numerusform>
        </translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>ninguno seleccionado</translation>
    </message>
    <message>
        <source>Select an organ in the view or in the list to read about it.</source>
        <translation>Seleccione un órgano en la vista o en la lista para ver sus datos.</translation>
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
        <translation>, píxeles de %1 mm</translation>
    </message>
    <message>
        <source>, %1 mm thick</source>
        <translation>, %1 mm de grosor</translation>
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
        <translation>Exportar todos los &amp;órganos...</translation>
    </message>
    <message>
        <source>Write all visible organs into one file, with names and colours</source>
        <translation>Guardar todos los órganos visibles en un archivo, con nombres y colores</translation>
    </message>
    <message>
        <source>Export all organs</source>
        <translation>Exportar todos los órganos</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb);;3MF models for printing (*.3mf)</source>
        <translation>Escenas glTF (*.glb);;Modelos 3MF para imprimir (*.3mf)</translation>
    </message>
    <message>
        <source>Export &amp;displacements...</source>
        <translation>Exportar &amp;desplazamientos...</translation>
    </message>
    <message>
        <source>Write the current organ at rest, with the displacement of every vertex</source>
        <translation>Guardar el órgano actual en reposo, con el desplazamiento de cada vértice</translation>
    </message>
    <message>
        <source>Export displacements</source>
        <translation>Exportar desplazamientos</translation>
    </message>
    <message>
        <source>VTK surfaces (*.vtp)</source>
        <translation>Superficies VTK (*.vtp)</translation>
    </message>
    <message>
        <source>Export displacement &amp;field...</source>
        <translation>Exportar &amp;campo de desplazamiento...</translation>
    </message>
    <message>
        <source>Write the displacement of the space around the current organ, for 3D Slicer and ITK</source>
        <translation>Guardar el desplazamiento del espacio en torno al órgano actual, para 3D Slicer e ITK</translation>
    </message>
    <message>
        <source>Export displacement field</source>
        <translation>Exportar campo de desplazamiento</translation>
    </message>
    <message>
        <source>Displacement fields (*.nrrd *.mha)</source>
        <translation>Campos de desplazamiento (*.nrrd *.mha)</translation>
    </message>
    <message>
        <source>Export &amp;table of volumes...</source>
        <translation>Exportar &amp;tabla de volúmenes...</translation>
    </message>
    <message>
        <source>Write volumes and sizes of all organs</source>
        <translation>Guardar volúmenes y tamaños de todos los órganos</translation>
    </message>
    <message>
        <source>Export table of volumes</source>
        <translation>Exportar tabla de volúmenes</translation>
    </message>
    <message>
        <source>Export &amp;measurements...</source>
        <translation>Exportar &amp;mediciones...</translation>
    </message>
    <message>
        <source>Write all measured distances and angles</source>
        <translation>Guardar todas las distancias y ángulos medidos</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Measure a distance (D) or an angle (A) first.</source>
        <translation>Aún no hay mediciones. Mida antes una distancia (D) o un ángulo (A).</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>Exportar mediciones</translation>
    </message>
    <message>
        <source>all organs</source>
        <translation>todos los órganos</translation>
    </message>
    <message numerus="yes">
        <source>The rest position of %n points of the field is uncertain.</source>
        <translation>
            <numerusform>La posición de reposo de %n punto del campo es incierta.</numerusform>
            <numerusform>La posición de reposo de %n puntos del campo es incierta.</numerusform>
        </translation>
    </message>
    <message>
        <source>table of volumes</source>
        <translation>tabla de volúmenes</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>mediciones</translation>
    </message>
</context>
<context>
    <name>viscera::app::FileActions</name>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Open a session, organs, label maps, handles or a scan</source>
        <translation>Abrir una sesión, órganos, mapas de etiquetas, tiradores o un estudio</translation>
    </message>
    <message>
        <source>Open a &amp;folder of masks...</source>
        <translation>Abrir una ca&amp;rpeta de máscaras...</translation>
    </message>
    <message>
        <source>Open one patient: a folder with one mask for each organ, as TotalSegmentator writes it</source>
        <translation>Abrir un paciente: una carpeta con una máscara por órgano, como las que escribe TotalSegmentator</translation>
    </message>
    <message>
        <source>&amp;Import with check...</source>
        <translation>&amp;Importar con comprobación...</translation>
    </message>
    <message>
        <source>Check and repair the contents of files before importing them</source>
        <translation>Comprobar y reparar el contenido de los archivos antes de importarlos</translation>
    </message>
    <message>
        <source>Save &amp;handles...</source>
        <translation>Guardar &amp;tiradores...</translation>
    </message>
    <message>
        <source>Save the handles at rest as Slicer markups</source>
        <translation>Guardar los tiradores en reposo como marcas de Slicer</translation>
    </message>
    <message>
        <source>&amp;Export organ...</source>
        <translation>&amp;Exportar órgano...</translation>
    </message>
    <message>
        <source>Export the organ in its present pose</source>
        <translation>Exportar el órgano en su pose actual</translation>
    </message>
    <message>
        <source>Load a &amp;cage...</source>
        <translation>Cargar una &amp;jaula...</translation>
    </message>
    <message>
        <source>For coordinates that need a cage: load a closed surface around the organ; its vertices become the handles</source>
        <translation>Para coordenadas que necesitan una jaula: cargar una superficie cerrada en torno al órgano; sus vértices pasan a ser los tiradores</translation>
    </message>
    <message>
        <source>Sessions, organs, label maps, handles and scans (*.viscera %1 %2 %3)</source>
        <translation>Sesiones, órganos, mapas de etiquetas, tiradores y estudios (*.viscera %1 %2 %3)</translation>
    </message>
    <message>
        <source>Sessions (*.viscera)</source>
        <translation>Sesiones (*.viscera)</translation>
    </message>
    <message>
        <source>Organs, label maps and handles (%1 %2 %3)</source>
        <translation>Órganos, mapas de etiquetas y tiradores (%1 %2 %3)</translation>
    </message>
    <message>
        <source>Label maps (%1)</source>
        <translation>Mapas de etiquetas (%1)</translation>
    </message>
    <message>
        <source>Handles (%1)</source>
        <translation>Tiradores (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a folder with one mask for each organ</source>
        <translation>Abrir una carpeta con una máscara por órgano</translation>
    </message>
    <message numerus="yes">
        <source>Opening %n files</source>
        <translation>
            <numerusform>Abriendo %n archivo</numerusform>
            <numerusform>Abriendo %n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Save handles</source>
        <translation>Guardar tiradores</translation>
    </message>
    <message>
        <source>Slicer markups (*%1 *.fcsv)</source>
        <translation>Marcas de Slicer (*%1 *.fcsv)</translation>
    </message>
    <message>
        <source>Load a cage</source>
        <translation>Cargar una jaula</translation>
    </message>
    <message>
        <source>Closed surfaces (%1);;All files (*)</source>
        <translation>Superficies cerradas (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Reading the cage %1</source>
        <translation>Leyendo la jaula %1</translation>
    </message>
    <message>
        <source>The handles at the vertices of %1 are now the corners of the cage.</source>
        <translation>Los tiradores en los vértices de %1 son ahora las esquinas de la jaula.</translation>
    </message>
    <message numerus="yes">
        <source>The %n vertices of %1 are now the handles.</source>
        <translation>
            <numerusform>El %n vértice de %1 es ahora el tirador.</numerusform>
            <numerusform>Los %n vértices de %1 son ahora los tiradores.</numerusform>
        </translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Superficies (%1)</translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>%1 guardado en %2</translation>
    </message>
    <message>
        <source>%1 was not found.</source>
        <translation>No se encontró %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n more findings; see the organs&apos; pages in Explore mode</source>
        <translation>
            <numerusform>%n hallazgo más; vea la página del órgano en el modo Explorar</numerusform>
            <numerusform>%n hallazgos más; vea las páginas de los órganos en el modo Explorar</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lies exactly where %2 lies already: only one of them is seen.</source>
        <translation>%1 está exactamente donde ya está %2: solo se ve uno de los dos.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Findings</name>
    <message>
        <source>Side of the body</source>
        <translation>Lado del cuerpo</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Superficie abierta</translation>
    </message>
    <message>
        <source>Edges of more than two triangles</source>
        <translation>Aristas de más de dos triángulos</translation>
    </message>
    <message>
        <source>Triangles that face inward</source>
        <translation>Triángulos orientados hacia dentro</translation>
    </message>
    <message>
        <source>Separate pieces</source>
        <translation>Fragmentos separados</translation>
    </message>
    <message>
        <source>Crossing triangles</source>
        <translation>Triángulos que se cruzan</translation>
    </message>
    <message>
        <source>Positions of the organs</source>
        <translation>Posiciones de los órganos</translation>
    </message>
    <message>
        <source>Lost details</source>
        <translation>Detalles perdidos</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitBox</name>
    <message>
        <source>by the shape</source>
        <translation>por la forma</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punto</numerusform>
            <numerusform>%n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit to this organ</source>
        <translation>Ajustar a este órgano</translation>
    </message>
    <message>
        <source>Sequence to fit</source>
        <translation>Secuencia que ajustar</translation>
    </message>
    <message>
        <source>Of the left ventricle. The right one ejects as much blood, and the muscle keeps its volume</source>
        <translation>Del ventrículo izquierdo. El derecho expulsa la misma sangre y el músculo conserva su volumen</translation>
    </message>
    <message>
        <source>%1: click its place in the view</source>
        <translation>%1: fíjelo con un clic en la vista</translation>
    </message>
    <message>
        <source>click the organ</source>
        <translation>clic en el órgano</translation>
    </message>
    <message>
        <source>Open a patient&apos;s organ first.</source>
        <translation>Abra primero el órgano de un paciente.</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface.</source>
        <translation>%1 tiene una superficie abierta; una secuencia necesita una cerrada.</translation>
    </message>
    <message>
        <source>Makes %1 and its chambers beat like a textbook heart. The present shape counts as the end of diastole. The result is a key sequence.</source>
        <translation>Hace latir %1 y sus cavidades como el corazón de un manual. La forma actual cuenta como final de la diástole. El resultado es una secuencia de fotogramas clave.</translation>
    </message>
    <message>
        <source>Moves %1 like the sample organ. Landmarks that you do not set are found from its shape.</source>
        <translation>Mueve %1 como el órgano de muestra. Los puntos de referencia que no fije se deducen de su forma.</translation>
    </message>
    <message>
        <source>Fitting %1</source>
        <translation>Ajustando %1</translation>
    </message>
    <message>
        <source>Fit the textbook&apos;s beat to %1</source>
        <translation>Ajustar el latido de manual a %1</translation>
    </message>
    <message>
        <source>Spine and pelvis stay in place: breathing does not move them.</source>
        <translation>La columna vertebral y la pelvis permanecen en su sitio: la respiración no las mueve.</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitOffer</name>
    <message>
        <source>Replace all open organs; Undo brings them back</source>
        <translation>Sustituir todos los órganos abiertos; Deshacer los recupera</translation>
    </message>
    <message>
        <source>%1 is made for a %2, but the name %3 suggests another organ.</source>
        <translation>%1 es para %2, pero el nombre %3 sugiere otro órgano.</translation>
    </message>
    <message>
        <source>%1: fit it to %2?</source>
        <translation>%1: ¿ajustar a %2?</translation>
    </message>
    <message>
        <source>Fit it anyway</source>
        <translation>Ajustar igualmente</translation>
    </message>
    <message>
        <source>Fit it to %1</source>
        <translation>Ajustar a %1</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface</source>
        <translation>%1 tiene una superficie abierta; una secuencia necesita una cerrada</translation>
    </message>
    <message>
        <source>Show the sample %1</source>
        <translation>Mostrar muestra: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::GroupPanel</name>
    <message>
        <source>No groups: all handles act everywhere. Select handles and make a group of them, or make groups automatically below.</source>
        <translation>Sin grupos: todos los tiradores actúan en todas partes. Seleccione tiradores y forme un grupo con ellos, o cree grupos automáticamente abajo.</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Nuevo grupo</translation>
    </message>
    <message>
        <source>Make a group of the selected handles</source>
        <translation>Formar un grupo con los tiradores seleccionados</translation>
    </message>
    <message>
        <source>Select handles</source>
        <translation>Seleccionar tiradores</translation>
    </message>
    <message>
        <source>Select the handles of the chosen group</source>
        <translation>Seleccionar los tiradores del grupo elegido</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Añadir selección</translation>
    </message>
    <message>
        <source>Add the selected handles to the chosen group</source>
        <translation>Añadir los tiradores seleccionados al grupo elegido</translation>
    </message>
    <message>
        <source>Choose the colour of the chosen group</source>
        <translation>Elegir el color del grupo elegido</translation>
    </message>
    <message>
        <source>Remove the chosen group; its handles stay</source>
        <translation>Quitar el grupo elegido; sus tiradores permanecen</translation>
    </message>
    <message>
        <source>How groups are made</source>
        <translation>Cómo se forman los grupos</translation>
    </message>
    <message>
        <source>Parts along the axis</source>
        <translation>Partes a lo largo del eje</translation>
    </message>
    <message>
        <source>Clusters of handles</source>
        <translation>Cúmulos de tiradores</translation>
    </message>
    <message>
        <source>Organs and their pieces</source>
        <translation>Órganos y sus fragmentos</translation>
    </message>
    <message>
        <source>How many groups</source>
        <translation>Número de grupos</translation>
    </message>
    <message>
        <source>Replace the present groups. Where handles do not surround a group&apos;s part of the organ, the corners of a box are added.</source>
        <translation>Sustituir los grupos actuales. Donde los tiradores no rodean la parte del órgano de un grupo, se añaden las esquinas de una caja.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupo %1</translation>
    </message>
    <message>
        <source>F2 renames</source>
        <translation>F2 renombra</translation>
    </message>
    <message>
        <source>A region needs at least four handles</source>
        <translation>Una región necesita al menos cuatro tiradores</translation>
    </message>
    <message>
        <source>These coordinates do not use groups.</source>
        <translation>Estas coordenadas no usan grupos.</translation>
    </message>
    <message>
        <source>No coordinate system that uses groups is loaded: the plugin is missing.</source>
        <translation>No hay cargado ningún sistema de coordenadas que use grupos: falta el complemento.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to the group.</source>
        <translation>
            <numerusform>La agrupación automática ha añadido %n tirador de esquina al grupo.</numerusform>
            <numerusform>La agrupación automática ha añadido %n tiradores de esquina al grupo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to %1 of %2 groups.</source>
        <translation>
            <numerusform>La agrupación automática ha añadido %n tirador de esquina a %1 de %2 grupos.</numerusform>
            <numerusform>La agrupación automática ha añadido %n tiradores de esquina a %1 de %2 grupos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Sacar</translation>
    </message>
    <message>
        <source>Take the selected handles out of the chosen group</source>
        <translation>Sacar las asas seleccionadas del grupo elegido</translation>
    </message>
</context>
<context>
    <name>viscera::app::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Buscar en la guía</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Secciones</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sección</numerusform>
            <numerusform>%n secciones</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleController</name>
    <message numerus="yes">
        <source>Turn %n handles</source>
        <translation>
            <numerusform>Girar %n tirador</numerusform>
            <numerusform>Girar %n tiradores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n handles</source>
        <translation>
            <numerusform>Escalar %n tirador</numerusform>
            <numerusform>Escalar %n tiradores</numerusform>
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
        <translation>Reposo L</translation>
    </message>
    <message>
        <source>Rest P</source>
        <translation>Reposo P</translation>
    </message>
    <message>
        <source>Rest S</source>
        <translation>Reposo S</translation>
    </message>
    <message>
        <source>Pose L</source>
        <translation>Pose L</translation>
    </message>
    <message>
        <source>Pose P</source>
        <translation>Pose P</translation>
    </message>
    <message>
        <source>Pose S</source>
        <translation>Pose S</translation>
    </message>
    <message>
        <source>Moved (mm)</source>
        <translation>Movido (mm)</translation>
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
        <translation>Aún no hay tiradores.
Mueva el control de arriba para colocar algunos o haga clic en el órgano en el modo Tiradores (2).</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>Colocar automáticamente</translation>
    </message>
    <message>
        <source>Place this many handles evenly, a little outside the organ&apos;s surface; they replace the present ones</source>
        <translation>Colocar este número de tiradores de forma regular, algo por fuera de la superficie del órgano; sustituyen a los actuales</translation>
    </message>
    <message>
        <source>Enclosing box</source>
        <translation>Caja envolvente</translation>
    </message>
    <message>
        <source>Eight of the handles are the corners of a box around the organ, so that all of it lies inside</source>
        <translation>Ocho de los tiradores son las esquinas de una caja en torno al órgano, de modo que todo él queda dentro</translation>
    </message>
    <message>
        <source>F2 renames, Delete removes</source>
        <translation>F2 renombra, Supr quita</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePlacer</name>
    <message>
        <source>Place handles</source>
        <translation>Colocar tiradores</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleTable</name>
    <message>
        <source>Table of handles</source>
        <translation>Tabla de tiradores</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, with all digits (Ctrl+C)</source>
        <translation>Copiar las filas seleccionadas, o todas, con todos los dígitos (Ctrl+C)</translation>
    </message>
    <message>
        <source>&amp;Table of handles...</source>
        <translation>&amp;Tabla de tiradores...</translation>
    </message>
    <message>
        <source>Positions of all handles, and the coordinates of a vertex that you click</source>
        <translation>Posiciones de todos los tiradores y coordenadas del vértice en que haga clic</translation>
    </message>
    <message>
        <source>Click the organ in the view to see the coordinates of its nearest vertex.</source>
        <translation>Haga clic en el órgano en la vista para ver las coordenadas de su vértice más cercano.</translation>
    </message>
    <message>
        <source>Vertex %1 of %2, at rest at %3, %4, %5 mm (LPS)</source>
        <translation>Vértice %1 de %2, en reposo en %3; %4; %5 mm (LPS)</translation>
    </message>
    <message>
        <source>%1: the organ is not bound to the handles.</source>
        <translation>%1: órgano sin vincular a los tiradores.</translation>
    </message>
    <message>
        <source>%1. Its coordinates sum to %2 and miss it by %3 mm.</source>
        <translation>%1. Sus coordenadas suman %2 y el error es de %3 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesMode</name>
    <message>
        <source>Click the organ to add a handle, drag to move it, Delete removes it; the rest shape stays</source>
        <translation>Un clic en el órgano añade un tirador, arrastrar lo mueve, Supr lo quita; la forma en reposo se mantiene</translation>
    </message>
    <message>
        <source>&amp;Place automatically</source>
        <translation>&amp;Colocar automáticamente</translation>
    </message>
    <message>
        <source>Spread handles evenly around the organ</source>
        <translation>Distribuir los tiradores de forma regular en torno al órgano</translation>
    </message>
    <message>
        <source>Add &amp;enclosing handles</source>
        <translation>&amp;Añadir tiradores envolventes</translation>
    </message>
    <message>
        <source>Add the eight corners of a box around everything</source>
        <translation>Añadir las ocho esquinas de una caja en torno a todo</translation>
    </message>
    <message>
        <source>&amp;Remove handles</source>
        <translation>&amp;Quitar tiradores</translation>
    </message>
    <message>
        <source>Remove the selected handles</source>
        <translation>Quitar los tiradores seleccionados</translation>
    </message>
    <message>
        <source>Select &amp;all handles</source>
        <translation>Seleccionar &amp;todos los tiradores</translation>
    </message>
    <message>
        <source>Use the &amp;hull as the cage</source>
        <translation>Usar la &amp;envolvente como jaula</translation>
    </message>
    <message>
        <source>Discard the loaded cage and use the convex hull of the handles again</source>
        <translation>Descartar la jaula cargada y usar de nuevo la envolvente convexa de los tiradores</translation>
    </message>
    <message>
        <source>&amp;Influence map</source>
        <translation>Mapa de &amp;influencia</translation>
    </message>
    <message>
        <source>Colour the organ by the influence of the selected handle</source>
        <translation>Colorear el órgano según la influencia del tirador seleccionado</translation>
    </message>
    <message>
        <source>Show &amp;regions</source>
        <translation>Mostrar &amp;regiones</translation>
    </message>
    <message>
        <source>Show where each group of handles acts, and the cage of coordinates that need one</source>
        <translation>Mostrar dónde actúa cada grupo de tiradores y la jaula de las coordenadas que la necesitan</translation>
    </message>
    <message>
        <source>Show &amp;zones</source>
        <translation>Mostrar &amp;zonas</translation>
    </message>
    <message>
        <source>Show where regions meet, in red</source>
        <translation>Mostrar en rojo dónde se encuentran las regiones</translation>
    </message>
    <message>
        <source>Show &amp;super-regions</source>
        <translation>Mostrar &amp;superregiones</translation>
    </message>
    <message>
        <source>Show the super-region that counts in each zone, in yellow</source>
        <translation>Mostrar en amarillo la superregión que cuenta en cada zona</translation>
    </message>
    <message>
        <source>Bound in %1 ms</source>
        <translation>Vinculado en %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n handles removed</source>
        <translation>
            <numerusform>%n tirador quitado</numerusform>
            <numerusform>%n tiradores quitados</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesPage</name>
    <message>
        <source>not bound</source>
        <translation>sin vincular</translation>
    </message>
    <message>
        <source>binding...</source>
        <translation>vinculando...</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>vinculado</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>no es posible</translation>
    </message>
    <message>
        <source>Binding</source>
        <translation>Vinculación</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Handle at rest</source>
        <translation>Tirador en reposo</translation>
    </message>
    <message>
        <source>The cage is the convex hull of the handles.</source>
        <translation>La jaula es la envolvente convexa de los tiradores.</translation>
    </message>
    <message>
        <source>The cage has %1 triangles over %2 handles.</source>
        <translation>La jaula tiene %1 triángulos sobre %2 tiradores.</translation>
    </message>
    <message numerus="yes">
        <source>%1 ms, %n threads</source>
        <translation>
            <numerusform>%1 ms, %n hilo</numerusform>
            <numerusform>%1 ms, %n hilos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartNumbersBox</name>
    <message>
        <source>Numbers of the measured heart</source>
        <translation>Valores del corazón medido</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>por m²</translation>
    </message>
    <message>
        <source>End of diastole here</source>
        <translation>Fin de la diástole aquí</translation>
    </message>
    <message>
        <source>The present instant is the end of diastole (ED)</source>
        <translation>El instante presente es el final de la diástole (ED)</translation>
    </message>
    <message>
        <source>End of systole here</source>
        <translation>Fin de la sístole aquí</translation>
    </message>
    <message>
        <source>The present instant is the end of systole (ES)</source>
        <translation>El instante presente es el final de la sístole (ES)</translation>
    </message>
    <message>
        <source>Find both ends</source>
        <translation>Encontrar ambos finales</translation>
    </message>
    <message>
        <source>ED is where the volume is largest, ES where it is smallest</source>
        <translation>ED es donde el volumen es mayor, ES donde es menor</translation>
    </message>
    <message>
        <source>Height and weight...</source>
        <translation>Talla y peso...</translation>
    </message>
    <message>
        <source>Body surface area by Mosteller, for numbers per square metre</source>
        <translation>Superficie corporal según Mosteller, para valores por metro cuadrado</translation>
    </message>
    <message>
        <source>Save as CSV...</source>
        <translation>Guardar como CSV...</translation>
    </message>
    <message>
        <source>Write these numbers into a table</source>
        <translation>Escribir estos valores en una tabla</translation>
    </message>
    <message>
        <source>ED at %1 % of the cycle, ES at %2 %</source>
        <translation>ED al %1 % del ciclo, ES al %2 %</translation>
    </message>
    <message>
        <source>Body surface</source>
        <translation>Superficie corporal</translation>
    </message>
    <message>
        <source>Height in cm</source>
        <translation>Talla en cm</translation>
    </message>
    <message>
        <source>Weight in kg</source>
        <translation>Peso en kg</translation>
    </message>
    <message>
        <source>A body surface area of %1 m² is not that of an adult: nothing is indexed</source>
        <translation>Una superficie corporal de %1 m² no es la de un adulto: no se indexa nada</translation>
    </message>
    <message>
        <source>Save the heart&apos;s numbers</source>
        <translation>Guardar los valores del corazón</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>The heart&apos;s numbers are in %1</source>
        <translation>Los valores del corazón están en %1</translation>
    </message>
    <message>
        <source>Estimates: only one phase of the images has labels. Of a right ventricle there are no numbers then.</source>
        <translation>Estimaciones: solo una fase de las imágenes tiene etiquetas. De un ventrículo derecho no hay números entonces.</translation>
    </message>
    <message>
        <source>Body surface %1 m² from the images: %2 cm, %3 kg</source>
        <translation>Superficie corporal %1 m² según las imágenes: %2 cm, %3 kg</translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartOpener</name>
    <message>
        <source>Opening the heart</source>
        <translation>Abriendo el corazón</translation>
    </message>
</context>
<context>
    <name>viscera::app::Help</name>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Ratón y teclas</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>&amp;Recorrido de dos minutos</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Bienvenida</translation>
    </message>
    <message>
        <source>&amp;About Viscera</source>
        <translation>&amp;Acerca de Viscera</translation>
    </message>
    <message>
        <source>Viscera %1: organs deformed by handles, without a cage. BSD-3-Clause; a program for research and teaching, not a medical device.</source>
        <translation>Viscera %1: órganos deformados mediante tiradores, sin jaula. BSD-3-Clause; un programa para la investigación y la enseñanza, no un producto sanitario.</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Mirar alrededor</translation>
    </message>
    <message>
        <source>Drag with the left button to rotate, with Shift to pan; the wheel zooms. Click an organ to select it, press F to bring it into the picture; D measures distances, A angles. The eye in the list on the left hides it, the square changes its colour.</source>
        <translation>Arrastre con el botón izquierdo para girar, con Mayús para desplazar; la rueda acerca y aleja. Haga clic en un órgano para seleccionarlo, pulse F para encuadrarlo; D mide distancias y A ángulos. El ojo de la lista de la izquierda lo oculta, el cuadrado cambia su color.</translation>
    </message>
    <message>
        <source>Play a motion</source>
        <translation>Reproducir un movimiento</translation>
    </message>
    <message>
        <source>Space plays and pauses. The timeline shows the phases of the cycle: drag along it to look at one instant. Below, the volumes are drawn as they change.</source>
        <translation>Espacio reproduce y pausa. La línea de tiempo muestra las fases del ciclo: arrastre por ella para ver un instante. Debajo se dibujan los volúmenes a medida que cambian.</translation>
    </message>
    <message>
        <source>Organs follow handles around them. Here you edit them at rest: click the organ to add one, drag to move it, Delete to remove it. The organ is bound again at once. I shows how far a handle reaches.</source>
        <translation>Los órganos siguen a los tiradores que los rodean. Aquí se editan en reposo: haga clic en el órgano para añadir uno, arrastre para moverlo, Supr para quitarlo. El órgano se vincula de nuevo al instante. I muestra hasta dónde llega un tirador.</translation>
    </message>
    <message>
        <source>Drag a handle and the organ follows; its volume is in the status bar. The padlock in the list on the left (K) keeps the volume whatever you do. T turns and scales selected handles, M mirrors drags. Ctrl+Z undoes any change, G shows the rest shape as an outline.</source>
        <translation>Arrastre un tirador y el órgano lo sigue; su volumen está en la barra de estado. El candado de la lista de la izquierda (K) mantiene el volumen haga lo que haga. T gira y escala los tiradores seleccionados, M refleja los arrastres. Ctrl+Z deshace cualquier cambio, G muestra la silueta de la forma en reposo.</translation>
    </message>
    <message>
        <source>The colours say how much the pose distorts the tissue inside. Click the organ to read the values of a point, C cuts it open, M shows the next map. Space plays the sequence, and the map follows.</source>
        <translation>Los colores muestran cuánto distorsiona la pose el tejido interior. Haga clic en el órgano para leer los valores de un punto; C lo secciona, M muestra el mapa siguiente. Espacio reproduce la secuencia y el mapa la sigue.</translation>
    </message>
    <message>
        <source>Your own organs</source>
        <translation>Sus propios órganos</translation>
    </message>
    <message>
        <source>Open surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) or label maps (NIfTI, NRRD, DICOM-SEG) with Ctrl+O or drop them here; they get handles at once. Ctrl+S saves all of it as a session. ? lists all keys.</source>
        <translation>Abra superficies (STL, OBJ, PLY, OFF, VTK, VTP, GLB) o mapas de etiquetas (NIfTI, NRRD, DICOM-SEG) con Ctrl+O o suéltelos aquí; reciben tiradores al instante. Ctrl+S lo guarda todo como sesión. ? muestra todas las teclas.</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Guía del usuario</translation>
    </message>
    <message>
        <source>The guide, at what the present mode does</source>
        <translation>La guía, en lo que hace el modo presente</translation>
    </message>
    <message>
        <source>&amp;First task: drag a dot</source>
        <translation>&amp;Primera tarea: arrastrar un punto</translation>
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
        <translation>Número de puntos testigo con cada valor; las líneas marcan la media y el percentil 95</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportController</name>
    <message>
        <source>Import or cancel the files in the panel first, then open the others.</source>
        <translation>Importe o cancele primero los archivos del panel y abra después los demás.</translation>
    </message>
    <message>
        <source>Check of %1</source>
        <translation>Comprobación de %1</translation>
    </message>
    <message numerus="yes">
        <source>Check of %n files</source>
        <translation>
            <numerusform>Comprobación de %n archivo</numerusform>
            <numerusform>Comprobación de %n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Repairing: %1</source>
        <translation>Reparando: %1</translation>
    </message>
    <message>
        <source>Checking again</source>
        <translation>Comprobando de nuevo</translation>
    </message>
    <message>
        <source>%1 of %2 organs could not be repaired that way and stay as they are. The panel says why.</source>
        <translation>%1 de %2 órganos no se pudieron reparar así y quedan como estaban. El panel dice por qué.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportPanel</name>
    <message>
        <source>No problems found. Nothing is in the document yet.</source>
        <translation>No se han encontrado problemas. Aún no hay nada en el documento.</translation>
    </message>
    <message>
        <source>Check the findings first. Nothing is in the document yet, and no file is changed.</source>
        <translation>Revise primero los hallazgos. Aún no hay nada en el documento y no se modifica ningún archivo.</translation>
    </message>
    <message>
        <source>%1 organs: %2 with faults, %3 to check, %4 without problems. Nothing is in the document yet, and no file is changed.</source>
        <translation>%1 órganos: %2 con defectos, %3 por revisar, %4 sin problemas. Aún no hay nada en el documento y no se modifica ningún archivo.</translation>
    </message>
    <message>
        <source>%1 of %2 organs are not life-sized; a change of unit applies to all organs from surface files</source>
        <translation>%1 de %2 órganos no tienen tamaño natural; un cambio de unidad se aplica a todos los órganos leídos de archivos de superficie</translation>
    </message>
    <message>
        <source>%1: %2 of %3 organs</source>
        <translation>%1: %2 de %3 órganos</translation>
    </message>
    <message>
        <source>Find an organ</source>
        <translation>Buscar un órgano</translation>
    </message>
    <message>
        <source>Organs to show, by finding</source>
        <translation>Órganos que mostrar, por hallazgo</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>Import all organs of this list</source>
        <translation>Importar todos los órganos de esta lista</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Import no organ of this list</source>
        <translation>No importar ningún órgano de esta lista</translation>
    </message>
    <message numerus="yes">
        <source>Import %n organs</source>
        <translation>
            <numerusform>Importar %n órgano</numerusform>
            <numerusform>Importar %n órganos</numerusform>
        </translation>
    </message>
    <message>
        <source>Import as it is</source>
        <translation>Importar tal cual</translation>
    </message>
    <message>
        <source>All organs together</source>
        <translation>Todos los órganos juntos</translation>
    </message>
    <message>
        <source>Every organ</source>
        <translation>Todos los órganos</translation>
    </message>
    <message>
        <source>To check</source>
        <translation>Por revisar</translation>
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
        <translation>Dé una pose al órgano en el modo Deformar y pulse Ctrl+K: cada fotograma clave guarda esa pose.</translation>
    </message>
    <message>
        <source>Time of the next key</source>
        <translation>Tiempo del fotograma clave siguiente</translation>
    </message>
    <message>
        <source>Easing to the key after it</source>
        <translation>Transición al fotograma clave siguiente</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Añadir clave</translation>
    </message>
    <message>
        <source>Store the present pose as a key (Ctrl+K)</source>
        <translation>Guardar la pose actual como fotograma clave (Ctrl+K)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>tiempo (s)</translation>
    </message>
    <message>
        <source>easing</source>
        <translation>transición</translation>
    </message>
    <message>
        <source>Take pose</source>
        <translation>Tomar pose</translation>
    </message>
    <message>
        <source>Set the present pose to that of this key</source>
        <translation>Aplicar la pose de este fotograma clave como pose actual</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sustituir</translation>
    </message>
    <message>
        <source>Store the present pose in this key</source>
        <translation>Guardar la pose actual en este fotograma clave</translation>
    </message>
    <message>
        <source>Remove this key</source>
        <translation>Quitar este fotograma clave</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Play the key sequence</source>
        <translation>Reproducir la secuencia de fotogramas clave</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Guardar...</translation>
    </message>
    <message>
        <source>Save the sequence as a file</source>
        <translation>Guardar la secuencia como archivo</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Abrir...</translation>
    </message>
    <message>
        <source>Open a sequence file</source>
        <translation>Abrir un archivo de secuencia</translation>
    </message>
    <message>
        <source>Duration </source>
        <translation>Duración </translation>
    </message>
    <message>
        <source>Sequences (*%1)</source>
        <translation>Secuencias (*%1)</translation>
    </message>
    <message>
        <source>Save the sequence</source>
        <translation>Guardar la secuencia</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Abrir una secuencia</translation>
    </message>
</context>
<context>
    <name>viscera::app::KeySequencePlayback</name>
    <message>
        <source>Record a key at %1 s</source>
        <translation>Grabar un fotograma clave en %1 s</translation>
    </message>
    <message>
        <source>Use a key&apos;s pose</source>
        <translation>Usar la pose de un fotograma clave</translation>
    </message>
    <message>
        <source>Sequence saved as %1</source>
        <translation>Secuencia guardada como %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::LectureScreen</name>
    <message>
        <source>&amp;Lecture</source>
        <translation>&amp;Clase</translation>
    </message>
    <message>
        <source>The view alone on the whole screen, in large letters; Page Down shows the next slide, Escape ends it</source>
        <translation>Solo la vista a pantalla completa, con letra grande; Av Pág muestra la diapositiva siguiente, Escape termina</translation>
    </message>
    <message>
        <source>&amp;Darken the screen</source>
        <translation>&amp;Oscurecer la pantalla</translation>
    </message>
    <message>
        <source>&amp;Pressures and volume</source>
        <translation>&amp;Presiones y volumen</translation>
    </message>
    <message>
        <source>Pressure-volume &amp;loops</source>
        <translation>&amp;Bucles presión-volumen</translation>
    </message>
    <message>
        <source>&amp;Electrocardiogram</source>
        <translation>&amp;Electrocardiograma</translation>
    </message>
    <message>
        <source>Open &amp;valves</source>
        <translation>&amp;Válvulas abiertas</translation>
    </message>
    <message>
        <source>Heart &amp;sounds</source>
        <translation>&amp;Ruidos cardíacos</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonDialog</name>
    <message>
        <source>Handles that a reader can drag</source>
        <translation>Tiradores que el lector puede arrastrar</translation>
    </message>
    <message>
        <source>Web page for any browser (.html)</source>
        <translation>Página web para cualquier navegador (.html)</translation>
    </message>
    <message>
        <source>Animated glTF scene (.glb)</source>
        <translation>Escena glTF animada (.glb)</translation>
    </message>
    <message>
        <source>Language of the page&apos;s buttons and messages; the texts below stay as they are</source>
        <translation>Idioma de los botones y mensajes de la página; los textos de abajo no cambian</translation>
    </message>
    <message>
        <source>A reader of the lesson sees only these texts: it holds no file names, no dates and no hidden organs. Check the texts for names of patients; double-click a text to change it.</source>
        <translation>Quien lea la lección verá solo estos textos: no contiene nombres de archivos, fechas ni órganos ocultos. Compruebe que en los textos no haya nombres de pacientes; haga doble clic en un texto para cambiarlo.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Guardar como...</translation>
    </message>
    <message>
        <source>Texts of the lesson</source>
        <translation>Textos de la lección</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>The shape of a head or a face can identify a patient.</source>
        <translation>La forma de una cabeza o una cara puede identificar a un paciente.</translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation>Idioma de la ventana</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonExport</name>
    <message>
        <source>Export &amp;lesson...</source>
        <translation>Exportar &amp;lección...</translation>
    </message>
    <message>
        <source>Write the organs and their motion as one page that opens in any browser</source>
        <translation>Guardar los órganos y su movimiento como una página que se abre en cualquier navegador</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb)</source>
        <translation>Escenas glTF (*.glb)</translation>
    </message>
    <message>
        <source>Exporting the lesson</source>
        <translation>Exportando la lección</translation>
    </message>
    <message>
        <source>Written to %1 (%2 MB). The motion in the file differs by at most %3 mm.</source>
        <translation>Guardado en %1 (%2 MB). El movimiento del archivo difiere en %3 mm como máximo.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MainWindow</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>%1: checked, no problems found</source>
        <translation>%1: comprobado, sin problemas</translation>
    </message>
    <message>
        <source>Viscera cancelled the drag because you chose another mode.</source>
        <translation>Viscera canceló el arrastre porque usted eligió otro modo.</translation>
    </message>
    <message>
        <source>Close without these files?</source>
        <translation>¿Cerrar sin estos archivos?</translation>
    </message>
    <message>
        <source>Viscera is still writing: %1.</source>
        <translation>Viscera todavía escribe: %1.</translation>
    </message>
    <message>
        <source>If you close Viscera now, it does not finish these files.</source>
        <translation>Si cierra Viscera ahora, no terminará estos archivos.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>&amp;Wait</source>
        <translation>&amp;Esperar</translation>
    </message>
    <message>
        <source>View kept as %1</source>
        <translation>Vista guardada como %1</translation>
    </message>
    <message>
        <source>Writing a movie</source>
        <translation>Escritura de una película</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>&amp;Ajustes...</translation>
    </message>
    <message>
        <source>Language, theme, folders and what is shown at the start</source>
        <translation>Idioma, tema, carpetas y lo que se muestra al inicio</translation>
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
        <translation>Dibujar los valores a lo largo de la recta en reposo entre dos sondas elegidas, o entre las dos últimas</translation>
    </message>
    <message>
        <source>Remove the chosen probes and profiles (Delete in the list)</source>
        <translation>Quitar las sondas y los perfiles elegidos (Supr en la lista)</translation>
    </message>
    <message>
        <source>Probes and profiles</source>
        <translation>Sondas y perfiles</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>%1: at rest %2 mm</source>
        <translation>%1: en reposo %2 mm</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>sin tejido</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm de largo</translation>
    </message>
    <message>
        <source>Profile along the line between two probes; the value is the largest</source>
        <translation>Perfil a lo largo de la línea entre dos sondas; el valor es el mayor</translation>
    </message>
    <message>
        <source>Place in the pose: towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S)</source>
        <translation>Lugar en la pose: hacia la derecha (R) o la izquierda (L), delante (A) o detrás (P), los pies (I) o la cabeza (S)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasureBox</name>
    <message>
        <source>Remove the chosen measurement (Delete in the list)</source>
        <translation>Quitar la medición elegida (Supr en la lista)</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Quitar todo</translation>
    </message>
    <message>
        <source>Export CSV...</source>
        <translation>Exportar CSV...</translation>
    </message>
    <message>
        <source>Points stay on the organ while it moves, and can be dragged along it; those on a slice go with the warped scan.</source>
        <translation>Los puntos siguen al órgano mientras se mueve y pueden arrastrarse por él; los de un corte siguen a la imagen deformada.</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice. Esc ends.</source>
        <translation>Haga clic en dos puntos de un órgano o un corte. Esc termina.</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second. Esc ends.</source>
        <translation>Haga clic en tres puntos de un órgano o un corte, el vértice en segundo lugar. Esc termina.</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner. Esc ends.</source>
        <translation>Arrastre en un corte de esquina a esquina. Esc termina.</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border. Esc ends.</source>
        <translation>Arrastre en un corte del centro al borde. Esc termina.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasuredMotion</name>
    <message numerus="yes">
        <source>Motion of %n phases. Mean distance from the measured surfaces: %1.</source>
        <translation>
            <numerusform>Movimiento de %n fase. Distancia media a las superficies medidas: %1.</numerusform>
            <numerusform>Movimiento de %n fases. Distancia media a las superficies medidas: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The series does not show how points move along a wall. The mean and the 95th percentile over the beat are reliable, the local pattern of this map is not.</source>
        <translation>La serie no muestra cómo se mueven los puntos a lo largo de una pared. La media y el percentil 95 del latido son fiables; el patrón local de este mapa, no.</translation>
    </message>
    <message>
        <source>Leave out phase %1</source>
        <translation>Omitir la fase %1</translation>
    </message>
    <message>
        <source>Surface of phase %1</source>
        <translation>Superficie de la fase %1</translation>
    </message>
    <message>
        <source>Distance from the measured surface</source>
        <translation>Distancia a la superficie medida</translation>
    </message>
    <message>
        <source>The search for the motion was cancelled.</source>
        <translation>Se canceló la búsqueda del movimiento.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases need attention: see the table beside the chart.</source>
        <translation>
            <numerusform>%n fase requiere atención: vea la tabla junto a la gráfica.</numerusform>
            <numerusform>%n fases requieren atención: vea la tabla junto a la gráfica.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>An estimate of %n phases from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Una estimación de %n fase a partir de las imágenes y las etiquetas de la fase %1 sola. Distancia media a las etiquetas y al tejido seguido: %2.</numerusform>
            <numerusform>Una estimación de %n fases a partir de las imágenes y las etiquetas de la fase %1 sola. Distancia media a las etiquetas y al tejido seguido: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Motion of %n phases from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Movimiento de %n fase a partir de las imágenes y las etiquetas de las fases %1. Distancia media a las etiquetas y al tejido seguido: %2.</numerusform>
            <numerusform>Movimiento de %n fases a partir de las imágenes y las etiquetas de las fases %1. Distancia media a las etiquetas y al tejido seguido: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Motion from images</source>
        <translation>Movimiento a partir de imágenes</translation>
    </message>
    <message>
        <source>Not used for the motion</source>
        <translation>No se usa para el movimiento</translation>
    </message>
    <message>
        <source>Estimate: %1</source>
        <translation>Estimación: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::Menus</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Sample &amp;organs</source>
        <translation>Órganos de &amp;muestra</translation>
    </message>
    <message>
        <source>Export &amp;more</source>
        <translation>Más e&amp;xportaciones</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Steps</source>
        <translation>&amp;Pasos</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>St&amp;ress map</source>
        <translation>Mapa de es&amp;trés</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>E&amp;studio</translation>
    </message>
    <message>
        <source>&amp;Slides</source>
        <translation>&amp;Diapositivas</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneles</translation>
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
        <translation>El próximo inicio usará este idioma: %1.</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>Ór&amp;gano</translation>
    </message>
    <message>
        <source>Ha&amp;ndles</source>
        <translation>&amp;Tiradores</translation>
    </message>
    <message>
        <source>&amp;Mirror drags</source>
        <translation>Arrastres &amp;simétricos</translation>
    </message>
    <message>
        <source>&amp;Sequence</source>
        <translation>Sec&amp;uencia</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Aún no se ha abierto nada</translation>
    </message>
    <message numerus="yes">
        <source>%n earlier steps</source>
        <translation>
            <numerusform>%n paso anterior</numerusform>
            <numerusform>%n pasos anteriores</numerusform>
        </translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Al abrir</translation>
    </message>
    <message>
        <source>No sample organs are installed</source>
        <translation>No hay órganos de muestra instalados</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Mirar desde</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparar</translation>
    </message>
    <message>
        <source>S&amp;hown in lectures and movies</source>
        <translation>&amp;Mostrado en clases y películas</translation>
    </message>
</context>
<context>
    <name>viscera::app::MessageBar</name>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Cerrar este mensaje (Esc)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>viscera::app::MotionDialog</name>
    <message>
        <source>Tissue around cavities</source>
        <translation>Tejido en torno a cavidades</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>Find the motion</source>
        <translation>Hallar el movimiento</translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation>Carpeta...</translation>
    </message>
    <message>
        <source>Files...</source>
        <translation>Archivos...</translation>
    </message>
    <message>
        <source>All phases, or one 4D NIfTI or .seq.nrrd</source>
        <translation>Todas las fases, o un NIfTI 4D o .seq.nrrd</translation>
    </message>
    <message>
        <source>Surfaces of the series</source>
        <translation>Superficies de la serie</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Duration of one whole cycle: the number of phases times the step between them</source>
        <translation>Duración de un ciclo completo: el número de fases por el intervalo entre ellas</translation>
    </message>
    <message>
        <source>The last phase leads back to the first</source>
        <translation>La última fase enlaza con la primera</translation>
    </message>
    <message>
        <source>60 for one surface, 120 for several. More follow the surfaces more closely</source>
        <translation>60 para una superficie, 120 para varias. Un número mayor sigue más de cerca las superficies</translation>
    </message>
    <message>
        <source>Keep the measured volumes exactly</source>
        <translation>Mantener exactos los volúmenes medidos</translation>
    </message>
    <message>
        <source>Larger distances count less: for label maps with outliers</source>
        <translation>Las distancias mayores cuentan menos: para mapas de etiquetas con valores atípicos</translation>
    </message>
    <message>
        <source>Distances count less beyond</source>
        <translation>Cuentan menos las distancias desde</translation>
    </message>
    <message>
        <source>Leave out phases</source>
        <translation>Omitir fases</translation>
    </message>
    <message>
        <source>Folder with a series</source>
        <translation>Carpeta con una serie</translation>
    </message>
    <message>
        <source>Phases of a series</source>
        <translation>Fases de una serie</translation>
    </message>
    <message>
        <source>Reading the series</source>
        <translation>Leyendo la serie</translation>
    </message>
    <message>
        <source>A single image shows no motion. Open it with File &gt; Open, then choose &quot;Fit a sequence to an organ&quot; in Play mode to give the heart and its chambers the textbook&apos;s beat.</source>
        <translation>Una sola imagen no muestra movimiento. Ábrala con Archivo &gt; Abrir y elija después «Ajustar una secuencia a un órgano» en el modo Reproducir para dar al corazón y a sus cavidades el latido del manual.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Label %1; a double click gives the surface another name</source>
        <translation>Etiqueta %1; un doble clic da otro nombre a la superficie</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 por minuto</translation>
    </message>
    <message>
        <source>The files do not state it</source>
        <translation>Los archivos no lo indican</translation>
    </message>
    <message>
        <source>No series is chosen.</source>
        <translation>No se ha elegido ninguna serie.</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>Leyendo %1 ...</translation>
    </message>
    <message numerus="yes">
        <source>%1: label maps, %n phases</source>
        <translation>
            <numerusform>%1: mapas de etiquetas, %n fase</numerusform>
            <numerusform>%1: mapas de etiquetas, %n fases</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: surfaces, %n phases</source>
        <translation>
            <numerusform>%1: superficies, %n fase</numerusform>
            <numerusform>%1: superficies, %n fases</numerusform>
        </translation>
    </message>
    <message>
        <source>Working...</source>
        <translation>Trabajando...</translation>
    </message>
    <message>
        <source>Enter the duration of one cycle first</source>
        <translation>Introduzca primero la duración de un ciclo</translation>
    </message>
    <message>
        <source>Outer surface</source>
        <translation>Superficie externa</translation>
    </message>
    <message>
        <source>%1 is not a phase</source>
        <translation>%1 no es una fase</translation>
    </message>
    <message>
        <source>name phases by their numbers, counted from 1, as in 3, 7</source>
        <translation>indique las fases por su número, contando desde 1, p. ej. 3, 7</translation>
    </message>
    <message>
        <source>Choose a series first</source>
        <translation>Elija primero una serie</translation>
    </message>
    <message>
        <source>A single image shows no motion</source>
        <translation>Una sola imagen no muestra movimiento</translation>
    </message>
    <message>
        <source>Turns one organ, given in several phases of a cycle, into handles and a key sequence with a key for each phase. Choose surfaces or label maps, one file for each phase, or one file with several phases. The result replaces the open organs; Undo brings them back.</source>
        <translation>Convierte un órgano, dado en varias fases de un ciclo, en tiradores y una secuencia con un fotograma clave por fase. Elija superficies o mapas de etiquetas, un archivo por fase o un archivo con varias fases. El resultado sustituye los órganos abiertos; Deshacer los recupera.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sin límite</translation>
    </message>
    <message>
        <source>For example 3, 7</source>
        <translation>Por ejemplo 3, 7</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation>Función de %1</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Cancelar la búsqueda</translation>
    </message>
    <message>
        <source>What the motion is found from</source>
        <translation>A partir de qué se encuentra el movimiento</translation>
    </message>
    <message>
        <source>Labels or surfaces of every phase</source>
        <translation>Etiquetas o superficies de cada fase</translation>
    </message>
    <message>
        <source>Cine images, and labels of a few phases</source>
        <translation>Imágenes de cine y etiquetas de algunas fases</translation>
    </message>
    <message>
        <source>Turns the labels of a few phases, the ends of diastole and systole at least, and cine images of the whole cycle into handles and a key sequence with a key for each phase. Volumes of labelled phases are exact; the images show the others. One labelled phase gives an estimate. The result replaces the open organs; Undo brings them back.</source>
        <translation>Convierte las etiquetas de algunas fases, al menos de los finales de diástole y sístole, y las imágenes de cine de todo el ciclo en tiradores y una secuencia con un fotograma clave por fase. Los volúmenes de las fases etiquetadas son exactos; las imágenes muestran los demás. Una sola fase etiquetada da una estimación. El resultado sustituye a los órganos abiertos; Deshacer los recupera.</translation>
    </message>
    <message>
        <source>Leave out series</source>
        <translation>Omitir series</translation>
    </message>
    <message>
        <source>The labels are being read</source>
        <translation>Se están leyendo las etiquetas</translation>
    </message>
    <message>
        <source>Choose other labels: these cannot be read</source>
        <translation>Elija otras etiquetas: estas no se pueden leer</translation>
    </message>
    <message>
        <source>%1 is not the number of a series</source>
        <translation>%1 no es el número de una serie</translation>
    </message>
    <message>
        <source>name series by their numbers, as in 3, 7</source>
        <translation>nombre las series por sus números, como en 3, 7</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieBox</name>
    <message>
        <source>Choose a destination</source>
        <translation>Elegir el destino</translation>
    </message>
    <message>
        <source> / s</source>
        <translation> / s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Ciclos</translation>
    </message>
    <message>
        <source>Write phase and volumes into it</source>
        <translation>Incluir fase y volúmenes</translation>
    </message>
    <message>
        <source>Table of volumes beside it (.csv)</source>
        <translation>Tabla de volúmenes al lado (.csv)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Record what the view shows</source>
        <translation>Grabar lo que muestra la vista</translation>
    </message>
    <message>
        <source>MP4 and GIF need the program ffmpeg, which is not installed on this computer.</source>
        <translation>MP4 y GIF necesitan el programa ffmpeg, que no está instalado en este equipo.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Carpeta para las imágenes</translation>
    </message>
    <message>
        <source>Record as</source>
        <translation>Grabar como</translation>
    </message>
    <message>
        <source>Cancel the movie</source>
        <translation>Cancelar la película</translation>
    </message>
    <message>
        <source>Discard the movie</source>
        <translation>Descartar la película</translation>
    </message>
</context>
<context>
    <name>viscera::app::MoviePlan</name>
    <message>
        <source>Ogg movie (.ogv)</source>
        <translation>Película Ogg (.ogv)</translation>
    </message>
    <message>
        <source>MP4 movie (.mp4)</source>
        <translation>Película MP4 (.mp4)</translation>
    </message>
    <message>
        <source>Animated GIF (.gif)</source>
        <translation>GIF animado (.gif)</translation>
    </message>
    <message>
        <source>PNG pictures (folder)</source>
        <translation>Imágenes PNG (carpeta)</translation>
    </message>
    <message>
        <source>Table of volumes (.csv)</source>
        <translation>Tabla de volúmenes (.csv)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieRecorder</name>
    <message>
        <source>Recording %1</source>
        <translation>Grabando %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::NumbersTable</name>
    <message>
        <source>Numbers of the circulation</source>
        <translation>Valores de la circulación</translation>
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
        <translation>%1, abierta</translation>
    </message>
    <message>
        <source>Import this organ</source>
        <translation>Importar este órgano</translation>
    </message>
    <message numerus="yes">
        <source>%n checks passed</source>
        <translation>
            <numerusform>%n comprobación superada</numerusform>
            <numerusform>%n comprobaciones superadas</numerusform>
        </translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Hecho: %1</translation>
    </message>
    <message>
        <source>More repairs</source>
        <translation>Más reparaciones</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Como en el archivo</translation>
    </message>
    <message>
        <source>Undo the repairs of this organ</source>
        <translation>Deshacer las reparaciones de este órgano</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganMenu</name>
    <message>
        <source>&amp;Lock volume</source>
        <translation>&amp;Bloquear volumen</translation>
    </message>
    <message>
        <source>Keep the organ&apos;s volume constant in Deform mode; for an organ with cavities, the volume within its outer surface</source>
        <translation>Mantener constante el volumen del órgano en el modo Deformar; en un órgano con cavidades, el volumen dentro de su superficie externa</translation>
    </message>
    <message>
        <source>The organ&apos;s own colours</source>
        <translation>Los colores propios del órgano</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Cambiar el color</translation>
    </message>
    <message>
        <source>&amp;Shortest distance of two organs</source>
        <translation>Di&amp;stancia más corta de dos órganos</translation>
    </message>
    <message>
        <source>Two organs</source>
        <translation>Dos órganos</translation>
    </message>
    <message>
        <source>Choose two organs in the list: the distance follows them, wherever they are nearest</source>
        <translation>Elija dos órganos en la lista: la distancia los sigue, dondequiera que estén más cerca</translation>
    </message>
    <message>
        <source>Choose two organs in the list first, the second one with Ctrl.</source>
        <translation>Elija primero dos órganos en la lista, el segundo con Ctrl.</translation>
    </message>
    <message>
        <source>&amp;Bends as soft tissue</source>
        <translation>Se do&amp;bla como tejido blando</translation>
    </message>
    <message>
        <source>Every place of the organ follows the handles</source>
        <translation>Cada lugar del órgano sigue a los tiradores</translation>
    </message>
    <message>
        <source>Moves as a r&amp;igid body</source>
        <translation>Se mueve como cuerpo ríg&amp;ido</translation>
    </message>
    <message>
        <source>The organ keeps its shape and moves as the tissue around it does on the whole; so do bones</source>
        <translation>El órgano conserva su forma y se mueve como el tejido que lo rodea en conjunto; así también los huesos</translation>
    </message>
    <message>
        <source>Stays in &amp;place</source>
        <translation>&amp;Permanece en su sitio</translation>
    </message>
    <message>
        <source>No handle moves the organ</source>
        <translation>Ningún tirador mueve el órgano</translation>
    </message>
    <message>
        <source>Textbook colours</source>
        <translation>Colores de los manuales</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganPanel</name>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>No organ yet.
Open a file (Ctrl+O), drop one here, or take a sample organ from the menu.</source>
        <translation>Aún no hay órganos.
Abra un archivo (Ctrl+O), suelte uno aquí o elija un órgano de muestra en el menú.</translation>
    </message>
    <message>
        <source>Find an organ (Ctrl+F)</source>
        <translation>Buscar un órgano (Ctrl+F)</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Cambiar opacidad</translation>
    </message>
    <message>
        <source>Show &amp;only this</source>
        <translation>Mostrar &amp;solo este</translation>
    </message>
    <message>
        <source>Show the chosen organs with their cavities and hide all others</source>
        <translation>Mostrar los órganos elegidos con sus cavidades y ocultar todos los demás</translation>
    </message>
    <message>
        <source>&amp;Hide this</source>
        <translation>&amp;Ocultar este</translation>
    </message>
    <message>
        <source>Hide the chosen organs</source>
        <translation>Ocultar los órganos elegidos</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Mostrar todos</translation>
    </message>
    <message>
        <source>Show every organ</source>
        <translation>Mostrar todos los órganos</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todos</translation>
    </message>
    <message>
        <source>&amp;Find an organ</source>
        <translation>&amp;Buscar un órgano</translation>
    </message>
    <message>
        <source>Type a part of its name</source>
        <translation>Escriba parte de su nombre</translation>
    </message>
    <message>
        <source>Re&amp;name organ</source>
        <translation>Re&amp;nombrar órgano</translation>
    </message>
    <message>
        <source>&amp;Remove organ</source>
        <translation>&amp;Quitar órgano</translation>
    </message>
    <message>
        <source>Hide all of them (click)</source>
        <translation>Ocultar todos (clic)</translation>
    </message>
    <message>
        <source>Show all of them (click)</source>
        <translation>Mostrar todos (clic)</translation>
    </message>
    <message>
        <source>Hide (click)</source>
        <translation>Ocultar (clic)</translation>
    </message>
    <message>
        <source>Show (click)</source>
        <translation>Mostrar (clic)</translation>
    </message>
    <message numerus="yes">
        <source>%1
%n triangles</source>
        <translation>
            <numerusform>%1
%n triángulo</numerusform>
            <numerusform>%1
%n triángulos</numerusform>
        </translation>
    </message>
    <message>
        <source>
Double click or F2 renames; a click on the square changes the colour</source>
        <translation>
Doble clic o F2 renombra; un clic en el cuadrado cambia el color</translation>
    </message>
    <message>
        <source>An open surface has no volume to lock; click to close its holes</source>
        <translation>Una superficie abierta no tiene volumen que bloquear; haga clic para cerrar sus agujeros</translation>
    </message>
    <message>
        <source>The volume is locked: Deform mode keeps it (click or K to unlock)</source>
        <translation>El volumen está bloqueado: el modo Deformar lo mantiene (clic o K para desbloquear)</translation>
    </message>
    <message>
        <source>Lock the volume (click or K)</source>
        <translation>Bloquear el volumen (clic o K)</translation>
    </message>
    <message>
        <source>
This is the volume within the outer surface; cavities have locks of their own</source>
        <translation>
Este es el volumen dentro de la superficie externa; las cavidades tienen sus propios bloqueos</translation>
    </message>
    <message>
        <source>
This is the volume of the cavity; the wall around it has a lock of its own</source>
        <translation>
Este es el volumen de la cavidad; la pared que la rodea tiene su propio bloqueo</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierta</translation>
    </message>
    <message>
        <source>An open surface encloses no volume</source>
        <translation>Una superficie abierta no encierra ningún volumen</translation>
    </message>
    <message>
        <source>%1 at rest, %2 (%3) now</source>
        <translation>%1 en reposo, %2 (%3) ahora</translation>
    </message>
    <message numerus="yes">
        <source>%n organs removed</source>
        <translation>
            <numerusform>%n órgano quitado</numerusform>
            <numerusform>%n órganos quitados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs and all handles removed</source>
        <translation>
            <numerusform>%n órgano y todos los tiradores quitados</numerusform>
            <numerusform>%n órganos y todos los tiradores quitados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 de %3)</translation>
    </message>
    <message>
        <source>The sample organ is being made.</source>
        <translation>Se está creando el órgano de ejemplo.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PanelDock</name>
    <message>
        <source>Float or dock the panel %1</source>
        <translation>Desacoplar o acoplar el panel %1</translation>
    </message>
    <message>
        <source>Hide the panel %1 (the View menu shows it again)</source>
        <translation>Ocultar el panel %1 (el menú Ver vuelve a mostrarlo)</translation>
    </message>
</context>
<context>
    <name>viscera::app::PasswordDialog</name>
    <message>
        <source>Keep it in the system&apos;s key ring</source>
        <translation>Guardarla en el depósito de claves del sistema</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>Password of %1 at %2</source>
        <translation>Contraseña de %1 en %2</translation>
    </message>
    <message>
        <source>Else Viscera asks again after the next start</source>
        <translation>Si no, Viscera vuelve a preguntar tras el próximo inicio</translation>
    </message>
    <message>
        <source>There is no key ring; Viscera asks again after the next start</source>
        <translation>No hay depósito de claves; Viscera vuelve a preguntar tras el próximo inicio</translation>
    </message>
    <message>
        <source>The archive refuses the user name or the password.</source>
        <translation>El archivo de imágenes rechaza el usuario o la contraseña.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PatientOffer</name>
    <message>
        <source>Searching beside %1</source>
        <translation>Buscando junto a %1</translation>
    </message>
    <message>
        <source>Open the scan</source>
        <translation>Abrir el estudio</translation>
    </message>
    <message>
        <source>Open its organs</source>
        <translation>Abrir sus órganos</translation>
    </message>
    <message>
        <source>The scan %2 has the same voxels as %1.</source>
        <translation>El estudio %2 tiene los mismos vóxeles que %1.</translation>
    </message>
    <message>
        <source>The label map %2 has the same voxels as %1.</source>
        <translation>El mapa de etiquetas %2 tiene los mismos vóxeles que %1.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PersonBox</name>
    <message>
        <source>Women and men</source>
        <translation>Mujeres y hombres</translation>
    </message>
    <message>
        <source>Women</source>
        <translation>Mujeres</translation>
    </message>
    <message>
        <source>Men</source>
        <translation>Hombres</translation>
    </message>
    <message>
        <source>Whose normal ranges are shown</source>
        <translation>De quién son los intervalos normales que se muestran</translation>
    </message>
    <message>
        <source> m²</source>
        <translation> m²</translation>
    </message>
    <message>
        <source>any body surface area</source>
        <translation>toda superficie corporal</translation>
    </message>
    <message>
        <source>Body surface area: ranges that the source gives per square metre are scaled by it</source>
        <translation>Superficie corporal: escala los intervalos que la fuente da por metro cuadrado</translation>
    </message>
</context>
<context>
    <name>viscera::app::PhaseScrubber</name>
    <message>
        <source>Instant of the cycle</source>
        <translation>Instante del ciclo</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys</source>
        <translation>Arrastre o use las flechas</translation>
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
        <translation>Plano</translation>
    </message>
    <message>
        <source>in this phase</source>
        <translation>en esta fase</translation>
    </message>
    <message>
        <source>weight %</source>
        <translation>peso %</translation>
    </message>
    <message>
        <source>likeness %</source>
        <translation>parecido %</translation>
    </message>
    <message>
        <source>arrives mm</source>
        <translation>llegada mm</translation>
    </message>
    <message>
        <source>apart mm</source>
        <translation>separación mm</translation>
    </message>
    <message>
        <source>over the beat</source>
        <translation>durante el latido</translation>
    </message>
    <message>
        <source>Series or slice, and what it shows of the heart</source>
        <translation>Serie o corte, y lo que muestra del corazón</translation>
    </message>
    <message>
        <source>What the plane says of the phase that is shown</source>
        <translation>Lo que el plano dice de la fase mostrada</translation>
    </message>
    <message>
        <source>Mean weight of its contours over the beat</source>
        <translation>Peso medio de sus contornos durante el latido</translation>
    </message>
    <message>
        <source>How alike its images are around the wall, over the beat</source>
        <translation>Cuánto se parecen sus imágenes alrededor de la pared, durante el latido</translation>
    </message>
    <message>
        <source>How far its tissue arrives from the next labelled surface</source>
        <translation>A qué distancia de la siguiente superficie etiquetada llega su tejido</translation>
    </message>
    <message>
        <source>Distance of its tissue from the surfaces</source>
        <translation>Distancia de su tejido a las superficies</translation>
    </message>
    <message>
        <source>Why the plane says little</source>
        <translation>Por qué el plano dice poco</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bueno</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayMode</name>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Space plays or pauses; drag the timeline to look at one instant</source>
        <translation>Espacio reproduce o pausa; arrastre la línea de tiempo para ver un instante</translation>
    </message>
    <message>
        <source>Slow &amp;motion</source>
        <translation>Cámara &amp;lenta</translation>
    </message>
    <message>
        <source>Slower, down to a tenth; then real time again</source>
        <translation>Más lento, hasta una décima parte; después, tiempo real de nuevo</translation>
    </message>
    <message>
        <source>&amp;Chart of one cycle</source>
        <translation>&amp;Gráfica de un ciclo</translation>
    </message>
    <message>
        <source>Draw one cycle with a cursor instead of the last seconds</source>
        <translation>Dibujar un ciclo con un cursor en lugar de los últimos segundos</translation>
    </message>
    <message>
        <source>&amp;ECG, sounds and valves</source>
        <translation>&amp;ECG, ruidos y válvulas</translation>
    </message>
    <message>
        <source>Under the phases of a heart: a schematic electrocardiogram, S1 and S2, and which valves are open</source>
        <translation>Bajo las fases de un corazón: un electrocardiograma esquemático, S1 y S2 y qué válvulas están abiertas</translation>
    </message>
    <message>
        <source>&amp;Valves and flow</source>
        <translation>&amp;Válvulas y flujo</translation>
    </message>
    <message>
        <source>Record a &amp;key</source>
        <translation>Grabar un fotograma &amp;clave</translation>
    </message>
    <message>
        <source>Add the present pose to the key sequence</source>
        <translation>Añadir la pose actual a la secuencia de fotogramas clave</translation>
    </message>
    <message>
        <source>Motion from a ser&amp;ies...</source>
        <translation>Movimiento de una ser&amp;ie...</translation>
    </message>
    <message>
        <source>Compare two &amp;rates</source>
        <translation>Comparar dos &amp;frecuencias</translation>
    </message>
    <message>
        <source>Show the same organs beside these at another rate, or with the circulation kept as before</source>
        <translation>Mostrar al lado los mismos órganos a otra frecuencia, o con la circulación conservada como anterior</translation>
    </message>
    <message>
        <source>Compare &amp;coordinates</source>
        <translation>Comparar c&amp;oordenadas</translation>
    </message>
    <message>
        <source>Show the same organs and handles beside these with another coordinate system</source>
        <translation>Mostrar al lado los mismos órganos y tiradores con otro sistema de coordenadas</translation>
    </message>
    <message>
        <source>Compare with another &amp;organ...</source>
        <translation>Comparar con otro ó&amp;rgano...</translation>
    </message>
    <message>
        <source>Open files in a second view beside these organs</source>
        <translation>Abrir archivos en una segunda vista junto a estos órganos</translation>
    </message>
    <message>
        <source>Compare with the te&amp;xtbook&apos;s heart</source>
        <translation>Comparar con el corazón de &amp;manual</translation>
    </message>
    <message>
        <source>Show the sample heart with its textbook beat beside these organs, at their rate</source>
        <translation>Mostrar junto a estos órganos el corazón de muestra con su latido de manual, a la frecuencia de ellos</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>&amp;Una vista</translation>
    </message>
    <message>
        <source>Close the second view</source>
        <translation>Cerrar la segunda vista</translation>
    </message>
    <message>
        <source>&amp;Pressures and loops</source>
        <translation>&amp;Presiones y bucles</translation>
    </message>
    <message>
        <source>Where a circulation moves the heart, show its curves below the view instead of the volumes</source>
        <translation>Cuando una circulación mueve el corazón, mostrar sus curvas bajo la vista en lugar de los volúmenes</translation>
    </message>
    <message>
        <source>Keep circ&amp;ulation for comparison</source>
        <translation>Conservar la circulación para comp&amp;arar</translation>
    </message>
    <message>
        <source>Keep this circulation to compare with: dashed loops and a second column of numbers</source>
        <translation>Conservar esta circulación para comparar: bucles discontinuos y una segunda columna de valores</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Terminar la comparación</translation>
    </message>
    <message>
        <source>Organ &amp;labels</source>
        <translation>&amp;Etiquetas de órganos</translation>
    </message>
    <message>
        <source>Write names beside the organs</source>
        <translation>Escribir los nombres junto a los órganos</translation>
    </message>
    <message>
        <source>See &amp;through</source>
        <translation>&amp;Transparencia</translation>
    </message>
    <message>
        <source>Make the wall translucent, so that the cavities are seen</source>
        <translation>Hacer translúcida la pared para que se vean las cavidades</translation>
    </message>
    <message>
        <source>See through</source>
        <translation>Ver a través</translation>
    </message>
    <message>
        <source>Key at %1 s</source>
        <translation>Fotograma clave en %1 s</translation>
    </message>
    <message>
        <source>Recorded as %1</source>
        <translation>Grabado como %1</translation>
    </message>
    <message>
        <source>Compare with the present &amp;pose</source>
        <translation>Comparar con la pose a&amp;ctual</translation>
    </message>
    <message>
        <source>Only the sample heart has valves to show</source>
        <translation>Solo el corazón de muestra tiene válvulas que mostrar</translation>
    </message>
    <message>
        <source>In the beating sample heart: leaflets as far open as the valves are, and arrows whose width shows the opening and whose length shows the speed of the blood</source>
        <translation>En el corazón de muestra que late: valvas tan abiertas como las válvulas, y flechas cuyo ancho muestra la apertura y cuya longitud, la velocidad de la sangre</translation>
    </message>
    <message>
        <source>This sequence has no valves; choose the heartbeat</source>
        <translation>Esta secuencia no tiene válvulas; elija el latido</translation>
    </message>
    <message>
        <source>Show the present pose in a second view, to compare it with later poses</source>
        <translation>Mostrar la pose actual en una segunda vista, para compararla con poses posteriores</translation>
    </message>
    <message>
        <source>&amp;Discard kept circulation</source>
        <translation>&amp;Descartar la circulación conservada</translation>
    </message>
    <message>
        <source>Make the wall opaque</source>
        <translation>Hacer opaca la pared</translation>
    </message>
    <message>
        <source>The movie does not show distance colours, measured surfaces or warped slices.</source>
        <translation>La película no muestra los colores de las distancias, las superficies medidas ni los cortes deformados.</translation>
    </message>
    <message>
        <source>Below the view, show curves and bull&apos;s eye of the heart&apos;s strain instead of the volumes</source>
        <translation>Mostrar bajo la vista las curvas y el ojo de buey de la deformación del corazón en lugar de los volúmenes</translation>
    </message>
    <message>
        <source>Colour the heart&apos;s wall by the strain of its segments; a click chooses one</source>
        <translation>Colorear la pared del corazón según la deformación de sus segmentos; un clic elige uno</translation>
    </message>
    <message>
        <source>Compute a patient&apos;s own motion from surfaces or label maps of each phase of the cycle, or from cine images and the labels of a few phases</source>
        <translation>Calcular el movimiento propio de un paciente a partir de superficies o mapas de etiquetas de cada fase del ciclo, o de imágenes de cine y las etiquetas de algunas fases</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayPage</name>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Source of the motion</source>
        <translation>Origen del movimiento</translation>
    </message>
    <message>
        <source>During one cycle</source>
        <translation>En el ciclo</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx.</translation>
    </message>
    <message>
        <source>min</source>
        <translation>mín.</translation>
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
        <translation>Volúmenes en ml. VS es el volumen sistólico; FE, la fracción de eyección.</translation>
    </message>
    <message>
        <source>Circulation of this heart</source>
        <translation>Circulación de este corazón</translation>
    </message>
    <message>
        <source>Finds pressures, loops and sounds for the volume and the ejection fraction of this left ventricle. The organ keeps its own motion.</source>
        <translation>Calcula presiones, bucles y ruidos para el volumen y la fracción de eyección de este ventrículo izquierdo. El órgano conserva su propio movimiento.</translation>
    </message>
    <message>
        <source>Record a movie</source>
        <translation>Grabar una película</translation>
    </message>
    <message>
        <source>Key sequence</source>
        <translation>Secuencia de fotogramas clave</translation>
    </message>
    <message>
        <source>Fit a sequence to an organ</source>
        <translation>Ajustar una secuencia a un órgano</translation>
    </message>
    <message>
        <source>%1 / min, one cycle %2 s</source>
        <translation>%1 / min, un ciclo %2 s</translation>
    </message>
    <message>
        <source>%1, measured on the surfaces. Healthy adults: %2</source>
        <translation>%1, medido en las superficies. Adultos sanos: %2</translation>
    </message>
    <message>
        <source>%1: %2; %3</source>
        <translation>%1: %2; %3</translation>
    </message>
    <message>
        <source>Normal for %1: %2.</source>
        <translation>Normal para %1: %2.</translation>
    </message>
    <message>
        <source>An estimate: only one phase of the images has labels</source>
        <translation>Una estimación: solo una fase de las imágenes tiene etiquetas</translation>
    </message>
</context>
<context>
    <name>viscera::app::Playback</name>
    <message>
        <source>The sequence %1 moves its own handles, but the document has others.</source>
        <translation>La secuencia %1 mueve sus propios tiradores, pero el documento tiene otros.</translation>
    </message>
    <message>
        <source>Use its handles</source>
        <translation>Usar sus tiradores</translation>
    </message>
    <message>
        <source>posed by hand</source>
        <translation>pose a mano</translation>
    </message>
</context>
<context>
    <name>viscera::app::PoseEditor</name>
    <message numerus="yes">
        <source>Reset %n handles</source>
        <translation>
            <numerusform>Restablecer %n tirador</numerusform>
            <numerusform>Restablecer %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>The handles could not move back all the way: %1.</source>
        <translation>Los tiradores no pudieron volver del todo: %1.</translation>
    </message>
    <message>
        <source>Volume %1</source>
        <translation>Volumen %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 is open (%n boundary edges), so it has no volume that could be locked.</source>
        <translation>
            <numerusform>%1 tiene una superficie abierta (%n arista de borde), sin volumen que se pueda bloquear.</numerusform>
            <numerusform>%1 tiene una superficie abierta (%n aristas de borde), sin volumen que se pueda bloquear.</numerusform>
        </translation>
    </message>
    <message>
        <source>Close the holes and lock</source>
        <translation>Cerrar agujeros y bloquear</translation>
    </message>
    <message>
        <source>Close holes and lock volume</source>
        <translation>Cerrar agujeros y bloquear volumen</translation>
    </message>
    <message>
        <source>These organs are open, so they have no volumes that could be locked: %1.</source>
        <translation>Estos órganos están abiertos y no tienen ningún volumen que se pueda bloquear: %1.</translation>
    </message>
    <message>
        <source>the locked volume leaves %1 of %2 mm</source>
        <translation>el volumen bloqueado deja %1 de %2 mm</translation>
    </message>
    <message>
        <source>Move exactly, others compensate</source>
        <translation>Mover exactamente, los demás compensan</translation>
    </message>
</context>
<context>
    <name>viscera::app::PositionBox</name>
    <message>
        <source>No handle is selected. Click one in the view or in the list.</source>
        <translation>No hay ningún tirador seleccionado. Haga clic en uno en la vista o en la lista.</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Tirador %1</translation>
    </message>
    <message>
        <source>, %1 mm from rest</source>
        <translation>, a %1 mm del reposo</translation>
    </message>
    <message>
        <source>, locked</source>
        <translation>, bloqueado</translation>
    </message>
    <message>
        <source>Place in the patient</source>
        <translation>Lugar en el paciente</translation>
    </message>
    <message>
        <source>Right or left</source>
        <translation>Derecha o izquierda</translation>
    </message>
    <message>
        <source>Front or back</source>
        <translation>Delante o detrás</translation>
    </message>
    <message>
        <source>Foot or head</source>
        <translation>Pies o cabeza</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProbeCard</name>
    <message>
        <source>Surface point %1</source>
        <translation>Punto de superficie %1</translation>
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
        <translation>Punto testigo %1</translation>
    </message>
    <message>
        <source>At rest %1 mm</source>
        <translation>En reposo %1 mm</translation>
    </message>
    <message>
        <source>Towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S), mm</source>
        <translation>Hacia la derecha (R) o la izquierda (L), delante (A) o detrás (P), los pies (I) o la cabeza (S), mm</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProfileChart</name>
    <message>
        <source>Profile along the line</source>
        <translation>Perfil a lo largo de la línea</translation>
    </message>
</context>
<context>
    <name>viscera::app::QuizTool</name>
    <message>
        <source>%1 right, %2 wrong</source>
        <translation>%1 correctas, %2 incorrectas</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Ninguna de las dos</translation>
    </message>
    <message>
        <source>%1: which valve is open?</source>
        <translation>%1: ¿qué válvula está abierta?</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>No. %1</translation>
    </message>
    <message>
        <source>Click: %1</source>
        <translation>Haga clic: %1</translation>
    </message>
    <message>
        <source>All %1 found without a mistake.</source>
        <translation>Encontradas las %1 sin ningún error.</translation>
    </message>
    <message numerus="yes">
        <source>All %1 found, with %n mistakes.</source>
        <translation>
            <numerusform>Encontradas las %1, con %n error.</numerusform>
            <numerusform>Encontradas las %1, con %n errores.</numerusform>
        </translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Correcto: %1</translation>
    </message>
    <message>
        <source>No, that is nearer to: %1</source>
        <translation>No, eso está más cerca de: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::RepairValueBox</name>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Life size</source>
        <translation>Tamaño natural</translation>
    </message>
    <message>
        <source>The factor by which the organ gets the usual volume of its kind</source>
        <translation>El factor con el que el órgano obtiene el volumen habitual de los suyos</translation>
    </message>
    <message>
        <source>About %1 triangles. Details smaller than %2 mm are lost.</source>
        <translation>Unos %1 triángulos. Se pierden los detalles de menos de %2 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Repairs</name>
    <message>
        <source>Turn triangles outward</source>
        <translation>Orientar hacia fuera</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Rellenar agujeros</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>Conservar el fragmento mayor</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>Remallar</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Reflejar izquierda y derecha</translation>
    </message>
    <message>
        <source>Convert from RAS to LPS</source>
        <translation>Convertir de RAS a LPS</translation>
    </message>
    <message>
        <source>Convert from Y up to LPS</source>
        <translation>Convertir de Y arriba a LPS</translation>
    </message>
    <message>
        <source>Coordinates are in %1</source>
        <translation>Las coordenadas están en %1</translation>
    </message>
    <message>
        <source>Remove small fragments</source>
        <translation>Eliminar fragmentos pequeños</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escalar</translation>
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
        <translation>Guardar imágenes, volúmenes, mediciones, estrés y movimiento como PDF o como una página HTML</translation>
    </message>
    <message>
        <source>&amp;Copy as commands</source>
        <translation>&amp;Copiar como órdenes</translation>
    </message>
    <message>
        <source>Copy the session as a script of viscera commands that gives the same result</source>
        <translation>Copiar la sesión como un guion de órdenes de viscera que da el mismo resultado</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf);;Web pages (*.html)</source>
        <translation>Documentos PDF (*.pdf);;Páginas web (*.html)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Escribiendo el informe</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pages.</source>
        <translation>
            <numerusform>%1: %n página.</numerusform>
            <numerusform>%1: %n páginas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copying as commands</source>
        <translation>Copiando como órdenes</translation>
    </message>
    <message numerus="yes">
        <source>%n commands are in the clipboard.</source>
        <translation>
            <numerusform>%n orden en el portapapeles.</numerusform>
            <numerusform>%n órdenes en el portapapeles.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ResectionBox</name>
    <message>
        <source>Volumes on both sides of the cut</source>
        <translation>Volúmenes a ambos lados del corte</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Queda</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Cortado</translation>
    </message>
    <message>
        <source>The volumes of the visible, closed organs on both sides of the plane, in this pose</source>
        <translation>Los volúmenes de los órganos visibles y cerrados a ambos lados del plano, en esta pose</translation>
    </message>
    <message>
        <source>Cut face %1 cm²</source>
        <translation>Cara del corte %1 cm²</translation>
    </message>
</context>
<context>
    <name>viscera::app::ResidualTable</name>
    <message>
        <source>largest volume</source>
        <translation>volumen máximo</translation>
    </message>
    <message>
        <source>smallest volume</source>
        <translation>volumen mínimo</translation>
    </message>
    <message>
        <source>Surface whose fit is shown</source>
        <translation>Superficie cuyo ajuste se muestra</translation>
    </message>
    <message>
        <source>Measured surface</source>
        <translation>Superficie medida</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distancias</translation>
    </message>
    <message>
        <source>Fit of the motion, phase by phase</source>
        <translation>Ajuste del movimiento, fase por fase</translation>
    </message>
    <message>
        <source>mean mm</source>
        <translation>media mm</translation>
    </message>
    <message>
        <source>95 % mm</source>
        <translation>95 % mm</translation>
    </message>
    <message>
        <source>max mm</source>
        <translation>máx. mm</translation>
    </message>
    <message>
        <source>measured ml</source>
        <translation>medido ml</translation>
    </message>
    <message>
        <source>unconstrained ml</source>
        <translation>libre ml</translation>
    </message>
    <message>
        <source>fitted ml</source>
        <translation>ajustado ml</translation>
    </message>
    <message>
        <source>Dice</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>invertidos</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>plegado</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>pasos</translation>
    </message>
    <message>
        <source>Time of the phase</source>
        <translation>Tiempo de la fase</translation>
    </message>
    <message>
        <source>Distance of the fitted surface from the measured surface, weighted by area</source>
        <translation>Distancia de la superficie ajustada a la medida, ponderada por área</translation>
    </message>
    <message>
        <source>95 % of the area lies within this distance</source>
        <translation>El 95 % del área está dentro de esta distancia</translation>
    </message>
    <message>
        <source>The largest distance</source>
        <translation>La mayor distancia</translation>
    </message>
    <message>
        <source>Volume that was measured</source>
        <translation>Volumen medido</translation>
    </message>
    <message>
        <source>Volume of the fit before it is brought to the measured volume</source>
        <translation>Volumen del ajuste antes de llevarlo al volumen medido</translation>
    </message>
    <message>
        <source>Volume of the fit</source>
        <translation>Volumen del ajuste</translation>
    </message>
    <message>
        <source>Triangles that face the wrong way</source>
        <translation>Triángulos orientados al lado equivocado</translation>
    </message>
    <message>
        <source>Places in the tissue that are folded</source>
        <translation>Lugares del tejido que están plegados</translation>
    </message>
    <message>
        <source>Steps that the fit took</source>
        <translation>Pasos que necesitó el ajuste</translation>
    </message>
    <message>
        <source>Differences from the previous series</source>
        <translation>Qué cambia respecto a la serie anterior</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>diferencia</translation>
    </message>
    <message>
        <source>All surfaces</source>
        <translation>Todas las superficies</translation>
    </message>
    <message>
        <source>Compared with the previous series</source>
        <translation>En comparación con la serie anterior</translation>
    </message>
    <message>
        <source>%1: EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1: FE %2 %, %3 a %4 ml, %5 l/min</translation>
    </message>
    <message>
        <source>tissue %1 to %2 ml</source>
        <translation>tejido %1 a %2 ml</translation>
    </message>
    <message>
        <source>A session does not keep the measured surfaces. To see them, find the motion again: Sequence &gt; Motion from a series</source>
        <translation>La sesión no guarda las superficies medidas. Para verlas, calcule de nuevo el movimiento: Secuencia &gt; Movimiento de una serie</translation>
    </message>
    <message>
        <source>Colour the organs by their distance from the measured surfaces of the nearest phase</source>
        <translation>Colorear los órganos según su distancia a las superficies medidas de la fase más próxima</translation>
    </message>
    <message>
        <source>A mark shows that the phase needs attention; the row&apos;s tooltip gives the reason</source>
        <translation>Una marca indica que la fase requiere atención; la descripción emergente de la fila da el motivo</translation>
    </message>
    <message>
        <source>Dice coefficient of the voxels; 1 if all agree</source>
        <translation>Coeficiente de Dice de los vóxeles; 1 si coinciden todos</translation>
    </message>
    <message>
        <source>Show the measured surfaces of the nearest phase, translucent</source>
        <translation>Mostrar las superficies medidas de la fase más próxima, translúcidas</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>wall ml</source>
        <translation>pared ml</translation>
    </message>
    <message>
        <source>Whether the phase has labels, or was found in the images</source>
        <translation>Si la fase tiene etiquetas o se encontró en las imágenes</translation>
    </message>
    <message>
        <source>Volume of the wall as a check: muscle hardly changes it. More than 10 % beyond the labelled phases needs attention</source>
        <translation>Volumen de la pared como control: el músculo apenas lo cambia. Más del 10 % fuera de las fases etiquetadas requiere atención</translation>
    </message>
    <message>
        <source>Estimate from the labels of one phase</source>
        <translation>Estimación a partir de las etiquetas de una fase</translation>
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
        <translation>Una estimación: esta fase no tiene etiquetas y solo una las tiene.</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>etiquetas</translation>
    </message>
    <message>
        <source>images</source>
        <translation>imágenes</translation>
    </message>
</context>
<context>
    <name>viscera::app::SampleNames</name>
    <message>
        <source>digestive system</source>
        <translation>sistema digestivo</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>corazón</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>hígado</translation>
    </message>
    <message>
        <source>stomach</source>
        <translation>estómago</translation>
    </message>
    <message>
        <source>stomach and bowel</source>
        <translation>estómago e intestino</translation>
    </message>
</context>
<context>
    <name>viscera::app::ScanActions</name>
    <message>
        <source>Soft &amp;tissue</source>
        <translation>&amp;Partes blandas</translation>
    </message>
    <message>
        <source>&amp;Lung</source>
        <translation>P&amp;ulmón</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Hueso</translation>
    </message>
    <message>
        <source>B&amp;rain</source>
        <translation>&amp;Encéfalo</translation>
    </message>
    <message>
        <source>Li&amp;ver</source>
        <translation>Hí&amp;gado</translation>
    </message>
    <message>
        <source>&amp;Angiography</source>
        <translation>&amp;Angiografía</translation>
    </message>
    <message>
        <source>&amp;3D view alone</source>
        <translation>Solo vista &amp;3D</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Cuatro vistas</translation>
    </message>
    <message>
        <source>&amp;Axial slice</source>
        <translation>Corte &amp;axial</translation>
    </message>
    <message>
        <source>&amp;Coronal slice</source>
        <translation>Corte c&amp;oronal</translation>
    </message>
    <message>
        <source>&amp;Sagittal slice</source>
        <translation>Corte &amp;sagital</translation>
    </message>
    <message>
        <source>Open a &amp;scan...</source>
        <translation>Abrir un &amp;estudio...</translation>
    </message>
    <message>
        <source>Open a CT or MR beside the organs</source>
        <translation>Abrir una TC o RM junto a los órganos</translation>
    </message>
    <message>
        <source>Open a DICOM &amp;series...</source>
        <translation>Abrir una serie &amp;DICOM...</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files as a scan</source>
        <translation>Abrir una carpeta de archivos DICOM como estudio</translation>
    </message>
    <message>
        <source>C&amp;lose the scan</source>
        <translation>Ce&amp;rrar el estudio</translation>
    </message>
    <message>
        <source>Close the scan; the organs stay</source>
        <translation>Cerrar el estudio; los órganos permanecen</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomático</translation>
    </message>
    <message>
        <source>Level and width that the scan&apos;s file proposes, or found from its values</source>
        <translation>Nivel y ancho propuestos por el archivo del estudio o deducidos de sus valores</translation>
    </message>
    <message>
        <source>Level %1, width %2</source>
        <translation>Nivel %1, ancho %2</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>Co&amp;ntornos</translation>
    </message>
    <message>
        <source>Draw the organs&apos; contours on the slices</source>
        <translation>Dibujar los contornos de los órganos en los cortes</translation>
    </message>
    <message>
        <source>Contours at &amp;rest</source>
        <translation>Contornos en &amp;reposo</translation>
    </message>
    <message>
        <source>Draw thin contours of the organs at rest as well</source>
        <translation>Dibujar también contornos finos de los órganos en reposo</translation>
    </message>
    <message>
        <source>Slices in the &amp;3D view</source>
        <translation>Cortes en la &amp;vista 3D</translation>
    </message>
    <message>
        <source>&amp;Warp the scan</source>
        <translation>&amp;Deformar el estudio</translation>
    </message>
    <message>
        <source>Show the scan as the pose warps it</source>
        <translation>Mostrar el estudio deformado por la pose</translation>
    </message>
    <message>
        <source>S&amp;mooth between voxels</source>
        <translation>Sua&amp;vizar entre vóxeles</translation>
    </message>
    <message>
        <source>Ma&amp;ximum of thick slices</source>
        <translation>Má&amp;ximo de los cortes gruesos</translation>
    </message>
    <message>
        <source>Show the largest value across a thick slice instead of the mean</source>
        <translation>Mostrar el valor máximo a través de un corte grueso en lugar de la media</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>&amp;Grosor</translation>
    </message>
    <message>
        <source>Slices of %1 mm</source>
        <translation>Cortes de %1 mm</translation>
    </message>
    <message>
        <source>Thin slices</source>
        <translation>Cortes finos</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Abrir una carpeta de archivos DICOM</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Abrir un estudio</translation>
    </message>
    <message>
        <source>Scans (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)</source>
        <translation>Estudios (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>The folder has several scans. Which one?</source>
        <translation>La carpeta contiene varios estudios. ¿Cuál?</translation>
    </message>
    <message numerus="yes">
        <source>%n more: see Scan on the page of Explore.</source>
        <translation>
            <numerusform>%n más: vea Estudio en la página de Explorar.</numerusform>
            <numerusform>%n más: vea Estudio en la página de Explorar.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, all %n slices, resampled to an even grid</source>
        <translation>
            <numerusform>, el %n corte, remuestreado en una malla regular</numerusform>
            <numerusform>, los %n cortes, remuestreados en una malla regular</numerusform>
        </translation>
    </message>
    <message>
        <source>, slices %1 to %2 of %3</source>
        <translation>, cortes %1 a %2 de %3</translation>
    </message>
    <message>
        <source>The slices are not at even distances: at most %1 of %2 are. What shall be read?</source>
        <translation>Los cortes no están a distancias regulares: a lo sumo %1 de %2 lo están. ¿Qué se debe leer?</translation>
    </message>
    <message>
        <source>Read other slices...</source>
        <translation>Leer otros cortes...</translation>
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
        <translation>%1: puede ajustarse a %2</translation>
    </message>
    <message>
        <source>%1: shows the sample organ and plays</source>
        <translation>%1: muestra el órgano de muestra y lo reproduce</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionFiles</name>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Nueva sesión</translation>
    </message>
    <message>
        <source>Start with an empty session</source>
        <translation>Empezar con una sesión vacía</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Guardar la sesión</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>G&amp;uardar como...</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Guardar la sesión en otro archivo</translation>
    </message>
    <message>
        <source>&amp;Recover unsaved work</source>
        <translation>&amp;Recuperar trabajo no guardado</translation>
    </message>
    <message>
        <source>Open the copy that Viscera kept when it ended without saving</source>
        <translation>Abrir la copia que Viscera conservó al terminar sin guardar</translation>
    </message>
    <message>
        <source>Viscera</source>
        <translation>Viscera</translation>
    </message>
    <message>
        <source>Untitled session</source>
        <translation>Sesión sin título</translation>
    </message>
    <message>
        <source>Session that names its organs&apos; files</source>
        <translation>Sesión que enlaza los archivos de sus órganos</translation>
    </message>
    <message>
        <source>Session with all surfaces and the scan inside</source>
        <translation>Sesión con todas las superficies y el estudio dentro</translation>
    </message>
    <message>
        <source>session</source>
        <translation>sesión</translation>
    </message>
    <message>
        <source>Save the session as</source>
        <translation>Guardar la sesión como</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Guardando %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Guardado como %1</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>¿Guardar los cambios?</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>¿Guardar los cambios de %1?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Y %n más.</numerusform>
            <numerusform>Y %n más.</numerusform>
        </translation>
    </message>
    <message>
        <source>Viscera ended without saving. It has kept a copy of the work of %1.</source>
        <translation>Viscera terminó sin guardar. Ha conservado una copia del trabajo del %1.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Choose the folder with the missing files</source>
        <translation>Elegir la carpeta de los archivos que faltan</translation>
    </message>
    <message>
        <source>Save this session?</source>
        <translation>¿Guardar esta sesión?</translation>
    </message>
    <message>
        <source>If you discard them, the changes since the last saving are lost.</source>
        <translation>Si los descarta, se pierden los cambios desde el último guardado.</translation>
    </message>
    <message>
        <source>Fetch it from %1</source>
        <translation>Traer de %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionView</name>
    <message>
        <source>Preparing the motion</source>
        <translation>Preparando el movimiento</translation>
    </message>
    <message>
        <source>it has other handles</source>
        <translation>tiene otros tiradores</translation>
    </message>
    <message>
        <source>This version moves the organ differently from the one that saved the session: %1.</source>
        <translation>Esta versión mueve el órgano de otro modo que la que guardó la sesión: %1.</translation>
    </message>
    <message>
        <source>handles differ by up to %1 mm</source>
        <translation>los tiradores difieren hasta %1 mm</translation>
    </message>
</context>
<context>
    <name>viscera::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Lengths are in mm, volumes in ml, everywhere; numbers have the decimal mark of the language.</source>
        <translation>Las longitudes están siempre en mm y los volúmenes en ml; los números llevan el signo decimal del idioma.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>The next start uses the language.</source>
        <translation>El próximo inicio usa el idioma.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Show the welcome</source>
        <translation>Mostrar la bienvenida</translation>
    </message>
    <message>
        <source>Folders that dialogs begin in</source>
        <translation>Carpetas en que empiezan los diálogos</translation>
    </message>
    <message>
        <source>Organs and sessions</source>
        <translation>Órganos y sesiones</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Movies</source>
        <translation>Películas</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
</context>
<context>
    <name>viscera::app::ShortcutCard</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Ratón y teclas</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Arrastrar con botón izquierdo</translation>
    </message>
    <message>
        <source>Rotate, or move a handle</source>
        <translation>Girar o mover un tirador</translation>
    </message>
    <message>
        <source>Middle, Shift+left drag</source>
        <translation>Botón central, Mayús+izquierdo</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Arrastrar con botón derecho, rueda</translation>
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
        <translation>Seleccionar o añadir un tirador</translation>
    </message>
    <message>
        <source>Shift or Ctrl+click</source>
        <translation>Mayús o Ctrl+clic</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Añadir a la selección</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel a drag, close a message</source>
        <translation>Cancelar un arrastre, cerrar un mensaje</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlicePanes</name>
    <message>
        <source>The scan cannot be warped: %1</source>
        <translation>El estudio no se puede deformar: %1</translation>
    </message>
    <message>
        <source>folded by the pose: estimated</source>
        <translation>plegado por la pose: estimado</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlidePanel</name>
    <message>
        <source>Keep views as slides, then show them with F5 and Page Down. The session keeps them.</source>
        <translation>Conserve vistas como diapositivas y muéstrelas con F5 y Av Pág. La sesión las guarda.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Slides</name>
    <message>
        <source>&amp;Keep this view as a slide</source>
        <translation>&amp;Conservar esta vista como diapositiva</translation>
    </message>
    <message>
        <source>&amp;Remove the slide</source>
        <translation>&amp;Quitar la diapositiva</translation>
    </message>
    <message>
        <source>Remove the slide that was shown last</source>
        <translation>Quitar la última diapositiva mostrada</translation>
    </message>
    <message>
        <source>&amp;Next slide</source>
        <translation>Diapositiva &amp;siguiente</translation>
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
        <translation>Conservar la vista actual con su sección, sus nombres y sus órganos ocultos, y el instante de una secuencia en pausa</translation>
    </message>
    <message>
        <source>&amp;Back from the slides</source>
        <translation>&amp;Volver de las diapositivas</translation>
    </message>
    <message>
        <source>Show, cut and name the organs as before the slides</source>
        <translation>Mostrar, seccionar y nombrar los órganos como antes de las diapositivas</translation>
    </message>
</context>
<context>
    <name>viscera::app::StatusLine</name>
    <message>
        <source>Cancel this task</source>
        <translation>Cancelar esta tarea</translation>
    </message>
    <message>
        <source>No organ</source>
        <translation>Sin órgano</translation>
    </message>
    <message>
        <source>%1: open surface, no volume</source>
        <translation>%1: superficie abierta, sin volumen</translation>
    </message>
    <message>
        <source>  locked</source>
        <translation>  bloqueado</translation>
    </message>
    <message>
        <source>no handles</source>
        <translation>sin tiradores</translation>
    </message>
    <message>
        <source>, binding...</source>
        <translation>, vinculando...</translation>
    </message>
    <message>
        <source>, binding cancelled</source>
        <translation>, vinculación cancelada</translation>
    </message>
    <message>
        <source>, bound in %1 ms</source>
        <translation>, vinculación en %1 ms</translation>
    </message>
    <message>
        <source>%1, %2 of tissue folded by the pose</source>
        <translation>%1, %2 de tejido plegados por la pose</translation>
    </message>
    <message numerus="yes">
        <source>%n organs</source>
        <translation>
            <numerusform>%n órgano</numerusform>
            <numerusform>%n órganos</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 not bound</source>
        <translation>, %1 sin vincular</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainModel</name>
    <message>
        <source>Choose a motion, or drag a handle: strain is the change of the heart&apos;s wall.</source>
        <translation>Elija un movimiento o arrastre un tirador: la deformación es el cambio de la pared del corazón.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainPanel</name>
    <message>
        <source>From the fullest phase</source>
        <translation>Desde la fase más llena</translation>
    </message>
    <message>
        <source>From phase %1</source>
        <translation>Desde la fase %1</translation>
    </message>
    <message>
        <source>Times to the peak differ by %1 ms along and %2 ms around</source>
        <translation>Los tiempos hasta el pico difieren en %1 ms a lo largo y %2 ms alrededor</translation>
    </message>
    <message>
        <source>The bull&apos;s eye shows the present pose against rest.</source>
        <translation>El ojo de buey muestra la pose actual frente al reposo.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressChart</name>
    <message>
        <source>maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>The stress over one cycle of the sequence is drawn here as soon as it is computed.</source>
        <translation>El estrés durante un ciclo de la secuencia se dibuja aquí en cuanto está calculado.</translation>
    </message>
    <message>
        <source>chosen point</source>
        <translation>punto elegido</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressExport</name>
    <message>
        <source>Export stress &amp;map...</source>
        <translation>Exportar &amp;mapa de estrés...</translation>
    </message>
    <message>
        <source>Write all quantities at all points inside the organ, for ParaView</source>
        <translation>Guardar todas las magnitudes en todos los puntos dentro del órgano, para ParaView</translation>
    </message>
    <message>
        <source>Export stress map</source>
        <translation>Exportar mapa de estrés</translation>
    </message>
    <message>
        <source>VTK solids (*.vtu)</source>
        <translation>Sólidos VTK (*.vtu)</translation>
    </message>
    <message>
        <source>Export stress at the &amp;points...</source>
        <translation>Exportar estrés en los &amp;puntos...</translation>
    </message>
    <message>
        <source>Write the values at the witness points as a table</source>
        <translation>Guardar como tabla los valores en los puntos testigo</translation>
    </message>
    <message>
        <source>Export stress at the points</source>
        <translation>Exportar estrés en los puntos</translation>
    </message>
    <message>
        <source>Export &amp;histogram...</source>
        <translation>Exportar &amp;histograma...</translation>
    </message>
    <message>
        <source>Write the distribution of the shown quantity over the witness points</source>
        <translation>Guardar la distribución de la magnitud mostrada en los puntos testigo</translation>
    </message>
    <message>
        <source>Export histogram</source>
        <translation>Exportar histograma</translation>
    </message>
    <message>
        <source>Export &amp;curve over the sequence...</source>
        <translation>Exportar &amp;curva de la secuencia...</translation>
    </message>
    <message>
        <source>Write the rotational stress over one whole cycle of the sequence</source>
        <translation>Guardar el estrés rotacional durante un ciclo completo de la secuencia</translation>
    </message>
    <message>
        <source>Export curve</source>
        <translation>Exportar curva</translation>
    </message>
    <message>
        <source>the stress map</source>
        <translation>el mapa de estrés</translation>
    </message>
    <message>
        <source>the stress</source>
        <translation>el estrés</translation>
    </message>
    <message>
        <source>the histogram</source>
        <translation>el histograma</translation>
    </message>
    <message>
        <source>the curve</source>
        <translation>la curva</translation>
    </message>
    <message>
        <source>Export pro&amp;bes...</source>
        <translation>Exportar &amp;sondas...</translation>
    </message>
    <message>
        <source>Write place and values of the pinned probes as a table</source>
        <translation>Guardar como tabla el lugar y los valores de las sondas fijadas</translation>
    </message>
    <message>
        <source>Export probes</source>
        <translation>Exportar sondas</translation>
    </message>
    <message>
        <source>Export prof&amp;iles...</source>
        <translation>Exportar perfi&amp;les...</translation>
    </message>
    <message>
        <source>Write the values along the lines between probes as a table</source>
        <translation>Guardar como tabla los valores a lo largo de las líneas entre sondas</translation>
    </message>
    <message>
        <source>Export profiles</source>
        <translation>Exportar perfiles</translation>
    </message>
    <message>
        <source>the probes</source>
        <translation>las sondas</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>los perfiles</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressMode</name>
    <message>
        <source>How much the pose distorts the tissue (rotational stress): click the organ to read the values of a point; C cuts it open; the map follows while you drag a handle</source>
        <translation>Cuánto distorsiona la pose el tejido (estrés rotacional): haga clic en el órgano para leer los valores de un punto; C lo secciona; el mapa se actualiza mientras arrastra un tirador</translation>
    </message>
    <message>
        <source>&amp;Next map</source>
        <translation>Mapa &amp;siguiente</translation>
    </message>
    <message>
        <source>The next stress map</source>
        <translation>El siguiente mapa de estrés</translation>
    </message>
    <message>
        <source>&amp;Go to the maximum</source>
        <translation>&amp;Ir al máximo</translation>
    </message>
    <message>
        <source>Show the values where the map is largest, and cut the organ open there</source>
        <translation>Mostrar los valores donde el mapa es máximo y seccionar ahí el órgano</translation>
    </message>
    <message>
        <source>&amp;Maximum over the sequence</source>
        <translation>Máximo de la se&amp;cuencia</translation>
    </message>
    <message>
        <source>The most extreme value that each point reaches in one cycle of the sequence</source>
        <translation>El valor más extremo que alcanza cada punto en un ciclo de la secuencia</translation>
    </message>
    <message>
        <source>Map on the organ&apos;s &amp;surface</source>
        <translation>Mapa en la s&amp;uperficie del órgano</translation>
    </message>
    <message>
        <source>Draw the map on the organ&apos;s surface instead of the outer tetrahedra</source>
        <translation>Dibujar el mapa en la superficie del órgano en lugar de los tetraedros externos</translation>
    </message>
    <message>
        <source>&amp;Keep the legend&apos;s range</source>
        <translation>&amp;Mantener el intervalo de la leyenda</translation>
    </message>
    <message>
        <source>Keep the range of colours, so that poses can be compared</source>
        <translation>Mantener el intervalo de colores para poder comparar poses</translation>
    </message>
    <message>
        <source>&amp;Cut open</source>
        <translation>Seccion&amp;ar</translation>
    </message>
    <message>
        <source>Cut the organ open by a plane</source>
        <translation>Seccionar el órgano por un plano</translation>
    </message>
    <message>
        <source>&amp;Only beyond a limit</source>
        <translation>Solo más allá de un &amp;límite</translation>
    </message>
    <message>
        <source>Show only tissue above or below a limit</source>
        <translation>Mostrar solo el tejido por encima o por debajo de un límite</translation>
    </message>
    <message>
        <source>&amp;Glyphs of the stretch</source>
        <translation>&amp;Glifos del estiramiento</translation>
    </message>
    <message>
        <source>No glyphs, ellipsoids or crosses</source>
        <translation>Sin glifos, elipsoides o cruces</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Tiradores</translation>
    </message>
    <message>
        <source>Show the handles, so that they can be dragged</source>
        <translation>Mostrar los tiradores para poder arrastrarlos</translation>
    </message>
    <message>
        <source>O&amp;ther organs</source>
        <translation>&amp;Otros órganos</translation>
    </message>
    <message>
        <source>Show the other organs as well</source>
        <translation>Mostrar también los demás órganos</translation>
    </message>
    <message>
        <source>P&amp;in the probe</source>
        <translation>&amp;Fijar la sonda</translation>
    </message>
    <message>
        <source>Keep the point that was clicked: its place and value follow the pose in the table</source>
        <translation>Conservar el punto pulsado: su lugar y su valor siguen a la pose en la tabla</translation>
    </message>
    <message>
        <source>&amp;Logarithmic range</source>
        <translation>I&amp;ntervalo logarítmico</translation>
    </message>
    <message>
        <source>Same range in both &amp;views</source>
        <translation>Mismo intervalo en ambas &amp;vistas</translation>
    </message>
    <message>
        <source>Beside another view: one range of colours for both stress maps, so that they can be compared</source>
        <translation>Junto a otra vista: un solo intervalo de colores para ambos mapas de estrés, para poder compararlos</translation>
    </message>
    <message>
        <source>Go to the &amp;time of the maximum</source>
        <translation>Ir al momento d&amp;el máximo</translation>
    </message>
    <message>
        <source>Show the sequence at the instant at which the rotational stress is largest</source>
        <translation>Mostrar la secuencia en el instante en que el estrés rotacional es mayor</translation>
    </message>
    <message>
        <source>Use a logarithmic colour scale, which separates small values</source>
        <translation>Usar una escala de colores logarítmica, que distingue los valores pequeños</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressModel</name>
    <message>
        <source>This point is probe %1 already.</source>
        <translation>Este punto ya es la sonda %1.</translation>
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
        <translation>TetGen, superficie reparada</translation>
    </message>
    <message>
        <source>regular grid</source>
        <translation>cuadrícula regular</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>What the colours mean (M: next map). Rotational stress is the largest angle by which a direction is turned when the tissue is stretched; it is not a pressure.</source>
        <translation>Qué significan los colores (M: mapa siguiente). El estrés rotacional es el mayor ángulo que gira una dirección al estirarse el tejido; no es una presión.</translation>
    </message>
    <message>
        <source>Your pose</source>
        <translation>Su pose</translation>
    </message>
    <message>
        <source>The map of your pose; handles can be dragged</source>
        <translation>El mapa de su pose; los tiradores se pueden arrastrar</translation>
    </message>
    <message>
        <source>The map of the sequence at the timeline&apos;s instant; Space plays</source>
        <translation>El mapa de la secuencia en el instante de la línea de tiempo; Espacio reproduce</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Smooth: through the tetrahedra</source>
        <translation>Liso: a través de los tetraedros</translation>
    </message>
    <message>
        <source>Crinkle: whole tetrahedra</source>
        <translation>Escalonado: tetraedros enteros</translation>
    </message>
    <message>
        <source>Distance of the cut from the organ&apos;s middle; the arrow in the view moves it, the rim tilts it</source>
        <translation>Distancia de la sección al centro del órgano; la flecha de la vista la mueve, el borde la inclina</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Límite</translation>
    </message>
    <message>
        <source>Glyphs</source>
        <translation>Glifos</translation>
    </message>
    <message>
        <source>No glyphs</source>
        <translation>Sin glifos</translation>
    </message>
    <message>
        <source>Ellipsoids of the stretch</source>
        <translation>Elipsoides del estiramiento</translation>
    </message>
    <message>
        <source>Crosses of the stretch</source>
        <translation>Cruces del estiramiento</translation>
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
        <translation>Retirar el lado derecho</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Cut through the middle, across the line of sight</source>
        <translation>Seccionar por el centro, perpendicular a la línea de visión</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Number of witness points</source>
        <translation>Número de puntos testigo</translation>
    </message>
    <message>
        <source>More points show finer detail and take longer; up to 20,000 the map follows a drag</source>
        <translation>Más puntos muestran más detalle y tardan más; hasta 20 000, el mapa sigue el arrastre</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Open an organ to see where it is distorted.</source>
        <translation>Abra un órgano para ver dónde se distorsiona.</translation>
    </message>
    <message>
        <source>Filling the organ with witness points...</source>
        <translation>Llenando el órgano de puntos testigo...</translation>
    </message>
    <message>
        <source>Binding the witness points to the handles...</source>
        <translation>Vinculando los puntos testigo a los tiradores...</translation>
    </message>
    <message>
        <source>Cancelled. Press Try again to go on.</source>
        <translation>Cancelado. Pulse Reintentar para continuar.</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>forma cerrada</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>diferencias</translation>
    </message>
    <message numerus="yes">
        <source>%n points lie outside the handles&apos; hull and stay where they are.</source>
        <translation>
            <numerusform>%n punto está fuera de la envolvente de los tiradores y no se mueve.</numerusform>
            <numerusform>%n puntos están fuera de la envolvente de los tiradores y no se mueven.</numerusform>
        </translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sondas</translation>
    </message>
    <message>
        <source>Time of the maximum</source>
        <translation>Momento del máximo</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Colours from the lowest value to the highest; maps of angles and maps of ratios each keep their own choice</source>
        <translation>Colores del valor más bajo al más alto; los mapas de ángulos y los de razones conservan cada uno su propia elección</translation>
    </message>
    <message>
        <source>Witness points at which the tissue is turned inside out; in magenta, except on the map of folded tissue</source>
        <translation>Puntos testigo en los que el tejido está vuelto del revés; en magenta, salvo en el mapa de tejido plegado</translation>
    </message>
    <message>
        <source>Cut and glyphs</source>
        <translation>Sección y glifos</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tejido</translation>
    </message>
    <message>
        <source>Above the limit</source>
        <translation>Por encima del límite</translation>
    </message>
    <message>
        <source>Below the limit</source>
        <translation>Por debajo del límite</translation>
    </message>
    <message>
        <source>Glyphs of the stretch at about 300 points: the shape that a small sphere of tissue takes</source>
        <translation>Glifos del estiramiento en unos 300 puntos: la forma que adopta una pequeña esfera de tejido</translation>
    </message>
    <message>
        <source>No handle is near %1: the nearest is %2 mm away. Place handles around it in Handles (2).</source>
        <translation>Ningún tirador está cerca de %1: el más próximo está a %2 mm. Coloque tiradores alrededor en Tiradores (2).</translation>
    </message>
    <message>
        <source>Nothing is deformed: drag a handle, or play a sequence (Space).</source>
        <translation>Nada está deformado: arrastre un tirador o reproduzca una secuencia (Espacio).</translation>
    </message>
    <message>
        <source>Choose a material</source>
        <translation>Elegir un material</translation>
    </message>
    <message>
        <source>Another material</source>
        <translation>Otro material</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>The tissue whose stiffness makes pascals of the deformation; it does not change the pose</source>
        <translation>El tejido cuya rigidez convierte la deformación en pascales; no cambia la pose</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Módulo de Young</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Coeficiente de Poisson</translation>
    </message>
    <message>
        <source>Pascals exist only of a stated material. Choose a material first.</source>
        <translation>Solo hay pascales de un material indicado. Elija primero un material.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus %1 kPa, doi:%2</source>
        <translation>Módulo de Young %1 kPa, doi:%2</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemBox</name>
    <message>
        <source>Coordinate system that binds the organs to the handles</source>
        <translation>Sistema de coordenadas que vincula los órganos a los tiradores</translation>
    </message>
    <message>
        <source>no cage</source>
        <translation>sin jaula</translation>
    </message>
    <message>
        <source>Handles may stand anywhere around the organ</source>
        <translation>Los tiradores pueden estar en cualquier lugar en torno al órgano</translation>
    </message>
    <message>
        <source>cage</source>
        <translation>jaula</translation>
    </message>
    <message>
        <source>Works with a closed surface over the handles: their convex hull, or a cage that was loaded</source>
        <translation>Funciona con una superficie cerrada sobre los tiradores: su envolvente convexa o una jaula cargada</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positivas</translation>
    </message>
    <message>
        <source>interpolating</source>
        <translation>interpolantes</translation>
    </message>
    <message>
        <source>A point at a handle follows it exactly</source>
        <translation>Un punto situado en un tirador lo sigue exactamente</translation>
    </message>
    <message>
        <source>exact gradient</source>
        <translation>gradiente exacto</translation>
    </message>
    <message>
        <source>Stress is computed without differences</source>
        <translation>El estrés se calcula sin diferencias</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>huecos</translation>
    </message>
    <message>
        <source>Some points inside the hull have no coordinates and do not move</source>
        <translation>Algunos puntos dentro de la envolvente no tienen coordenadas y no se mueven</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>saltos</translation>
    </message>
    <message>
        <source>Neighbouring points may move very differently</source>
        <translation>Puntos vecinos pueden moverse de forma muy distinta</translation>
    </message>
    <message>
        <source>kinks</source>
        <translation>dobleces</translation>
    </message>
    <message>
        <source>The deformed organ may show creases</source>
        <translation>El órgano deformado puede mostrar dobleces</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>grupos</translation>
    </message>
    <message>
        <source>Handles act by their groups</source>
        <translation>Los tiradores actúan por grupos</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tetraedros</translation>
    </message>
    <message>
        <source>Fills the organ with tetrahedra first</source>
        <translation>Llena antes el órgano de tetraedros</translation>
    </message>
    <message>
        <source>The value is set to %1 %2, but these handles allow at most %3, so %3 is used.</source>
        <translation>El valor está fijado en %1 %2, pero estos tiradores permiten como máximo %3, por lo que se usa %3.</translation>
    </message>
    <message>
        <source>These handles allow up to %1.</source>
        <translation>Estos tiradores permiten hasta %1.</translation>
    </message>
    <message>
        <source>No coordinate is negative: the organ follows the direction of every handle</source>
        <translation>Ninguna coordenada es negativa: el órgano sigue la dirección de cada tirador</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemCombo</name>
    <message>
        <source>Recommended</source>
        <translation>Recomendados</translation>
    </message>
    <message>
        <source>With a cage</source>
        <translation>Con jaula</translation>
    </message>
    <message>
        <source>With tetrahedra</source>
        <translation>Con tetraedros</translation>
    </message>
    <message>
        <source>Attempts of the thesis</source>
        <translation>Intentos de la tesis</translation>
    </message>
</context>
<context>
    <name>viscera::app::TaskCard</name>
    <message>
        <source>Drag the bright dot: the organ follows.</source>
        <translation>Arrastre el punto claro: el órgano lo sigue.</translation>
    </message>
    <message>
        <source>Done. Ctrl+Z takes it back. F1 opens the guide at what you are doing.</source>
        <translation>Hecho. Ctrl+Z lo deshace. F1 abre la guía en lo que está haciendo.</translation>
    </message>
</context>
<context>
    <name>viscera::app::TimelineBar</name>
    <message>
        <source>To the start of the cycle (Home)</source>
        <translation>Al principio del ciclo (Inicio)</translation>
    </message>
    <message>
        <source>One frame back (,)</source>
        <translation>Un fotograma atrás (,)</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Reproducir o pausar (Espacio)</translation>
    </message>
    <message>
        <source>One frame forward (.)</source>
        <translation>Un fotograma adelante (.)</translation>
    </message>
    <message>
        <source>Repeat the cycle (L)</source>
        <translation>Repetir el ciclo (L)</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Repetir</translation>
    </message>
    <message>
        <source>Repeat the cycle</source>
        <translation>Repetir el ciclo</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Re&amp;producir o pausar</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Al pr&amp;incipio</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Un &amp;fotograma atrás</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Un fo&amp;tograma adelante</translation>
    </message>
    <message>
        <source>A fine step bac&amp;k</source>
        <translation>Un paso fino at&amp;rás</translation>
    </message>
    <message>
        <source>Go back by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Retroceder diez milisegundos en un latido, un fotograma en otras secuencias</translation>
    </message>
    <message>
        <source>A fine step for&amp;ward</source>
        <translation>Un paso fino a&amp;delante</translation>
    </message>
    <message>
        <source>Go forward by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Avanzar diez milisegundos en un latido, un fotograma en otras secuencias</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Slow motion: how fast time passes (S)</source>
        <translation>Cámara lenta: velocidad a la que pasa el tiempo (S)</translation>
    </message>
    <message>
        <source>%1: %2 %3. The heart rate of the circulation sets it.</source>
        <translation>%1: %2 %3. La fija la frecuencia cardíaca de la circulación.</translation>
    </message>
    <message>
        <source>%1: %2 to %3 %4</source>
        <translation>%1: %2 a %3 %4</translation>
    </message>
    <message>
        <source>No motion yet: choose a sequence in Play (5)</source>
        <translation>Aún no hay movimiento: elija una secuencia en Reproducir (5)</translation>
    </message>
    <message>
        <source>%1 s into the cycle</source>
        <translation>%1 s desde el inicio</translation>
    </message>
    <message>
        <source>The images of the cine study: there is no motion yet</source>
        <translation>Las imágenes del estudio cine: todavía no hay movimiento</translation>
    </message>
    <message>
        <source>The phases of the scan: there is no motion yet</source>
        <translation>Las fases del estudio: todavía no hay movimiento</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Estudio</translation>
    </message>
</context>
<context>
    <name>viscera::app::TourCard</name>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
</context>
<context>
    <name>viscera::app::Value</name>
    <message>
        <source>No password was given.</source>
        <translation>No se ha dado ninguna contraseña.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ViewActions</name>
    <message>
        <source>Save s&amp;creenshot</source>
        <translation>Guardar &amp;captura de pantalla</translation>
    </message>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Guardar una imagen de la vista 3D</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Encuadrar</translation>
    </message>
    <message>
        <source>Bring the selected organ, or all, into the picture</source>
        <translation>Encuadrar el órgano seleccionado, o todos</translation>
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
        <translation>&amp;Izquierda</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Derecha</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Superior</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>In&amp;ferior</translation>
    </message>
    <message>
        <source>Show &amp;handles in every mode</source>
        <translation>Mostrar &amp;tiradores en todos los modos</translation>
    </message>
    <message>
        <source>&amp;Ghost of the rest shape</source>
        <translation>Si&amp;lueta de la forma en reposo</translation>
    </message>
    <message>
        <source>Cut &amp;open</source>
        <translation>Secci&amp;onar</translation>
    </message>
    <message>
        <source>Cut all organs open by a plane; their cavities are hollow then</source>
        <translation>Seccionar todos los órganos por un plano; sus cavidades quedan entonces huecas</translation>
    </message>
    <message>
        <source>Orientation &amp;cube</source>
        <translation>C&amp;ubo de orientación</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>&amp;Barra de escala</translation>
    </message>
    <message>
        <source>Sha&amp;de in folds</source>
        <translation>Som&amp;brear los pliegues</translation>
    </message>
    <message>
        <source>Darken the folds of organs and soften the light; takes time on a computer without a graphics processor</source>
        <translation>Oscurecer los pliegues de los órganos y suavizar la luz; lento en un ordenador sin procesador gráfico</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Imagen guardada como %1</translation>
    </message>
    <message>
        <source>%1 is hidden behind %2.</source>
        <translation>%2 tapa %1.</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Mostrar solo este</translation>
    </message>
    <message>
        <source>&amp;Edges of triangles</source>
        <translation>Aristas de los &amp;triángulos</translation>
    </message>
    <message>
        <source>Draw the triangles of organs as lines</source>
        <translation>Dibujar los triángulos de los órganos como líneas</translation>
    </message>
    <message>
        <source>&amp;Flat triangles</source>
        <translation>Triángulos &amp;planos</translation>
    </message>
    <message>
        <source>Give each triangle of an organ one shade, in place of a smooth surface</source>
        <translation>Dar a cada triángulo de un órgano un solo tono, en lugar de una superficie lisa</translation>
    </message>
    <message>
        <source>Co&amp;nduction system</source>
        <translation>Sistema de co&amp;nducción</translation>
    </message>
    <message>
        <source>In the sample heart: sinus node, atrioventricular node, bundles and branches, lit where the excitation of the beat is; names of parts name them</source>
        <translation>En el corazón de muestra: nodo sinoauricular, nodo auriculoventricular, haces y ramas, iluminados donde está la excitación del latido; los nombres de las partes los nombran</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeBox</name>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Target volume</source>
        <translation>Volumen objetivo</translation>
    </message>
    <message>
        <source>Give the organ this volume with the smallest motion of the compensating handles, or of all free ones</source>
        <translation>Dar al órgano este volumen con el menor movimiento de los tiradores que compensan, o de todos los libres</translation>
    </message>
    <message>
        <source>%1 now has the target volume; its lock keeps this volume from now on.</source>
        <translation>%1 tiene ahora el volumen objetivo; desde ahora su bloqueo conserva este volumen.</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeMonitor</name>
    <message>
        <source>Volumes over the cycle</source>
        <translation>Volúmenes en el ciclo</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumePanel</name>
    <message>
        <source>normal at the end of diastole</source>
        <translation>normal al final de la diástole</translation>
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
        <translation>Los volúmenes en el tiempo se dibujan aquí mientras se reproduce una secuencia (Espacio) o se arrastran tiradores (3).</translation>
    </message>
    <message>
        <source>%1 (right axis)</source>
        <translation>%1 (eje derecho)</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 medido</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 antes</translation>
    </message>
    <message>
        <source>%1 prescribed</source>
        <translation>%1 prescrito</translation>
    </message>
    <message>
        <source>Closed organs show their volume here.</source>
        <translation>Los órganos cerrados muestran aquí su volumen.</translation>
    </message>
    <message>
        <source>%1: show its normal range in the chart</source>
        <translation>%1: mostrar en la gráfica sus valores normales</translation>
    </message>
    <message>
        <source>Shaded: normal for %1, %2. %3</source>
        <translation>Sombreado: normal para %1, %2. %3</translation>
    </message>
    <message>
        <source>EF %1 %  SV %2 ml</source>
        <translation>FE %1 %  VS %2 ml</translation>
    </message>
    <message>
        <source>%1 % of rest</source>
        <translation>%1 % del reposo</translation>
    </message>
    <message>
        <source>Part of the cycle</source>
        <translation>Parte del ciclo</translation>
    </message>
    <message>
        <source>Time while dragging</source>
        <translation>Tiempo de arrastre</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gráfica</translation>
    </message>
    <message numerus="yes">
        <source>%n more organs are not drawn: choose one to see its volume.</source>
        <translation>
            <numerusform>%n órgano más no está dibujado: elíjalo para ver su volumen.</numerusform>
            <numerusform>%n órganos más no están dibujados: elija uno para ver su volumen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit of the motion</source>
        <translation>Ajuste del movimiento</translation>
    </message>
    <message>
        <source>EF about %1 %  SV about %2 ml (estimate)</source>
        <translation>FE aprox. %1 %  VS aprox. %2 ml (estimación)</translation>
    </message>
</context>
<context>
    <name>viscera::app::WarpExport</name>
    <message>
        <source>Export the &amp;warped scan...</source>
        <translation>&amp;Exportar el estudio deformado...</translation>
    </message>
    <message>
        <source>Write the scan as the pose warps it, with a label map of the posed organs</source>
        <translation>Guardar el estudio deformado por la pose, con un mapa de etiquetas de los órganos en esa pose</translation>
    </message>
    <message>
        <source>Export the warped scan</source>
        <translation>Exportar el estudio deformado</translation>
    </message>
    <message>
        <source>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</source>
        <translation>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</translation>
    </message>
    <message>
        <source>Exporting the warped scan</source>
        <translation>Exportando el estudio deformado</translation>
    </message>
    <message>
        <source>The warped scan was written to %1.</source>
        <translation>El estudio deformado se ha guardado en %1.</translation>
    </message>
    <message>
        <source>Its labels are beside it: %1.</source>
        <translation>Sus etiquetas están al lado: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The pose folds the tissue at %n voxels: their values are estimates.</source>
        <translation>
            <numerusform>La pose pliega el tejido en %n vóxel: su valor es una estimación.</numerusform>
            <numerusform>La pose pliega el tejido en %n vóxeles: sus valores son estimaciones.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::WelcomeCard</name>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>Open a patient...</source>
        <translation>Abrir un paciente...</translation>
    </message>
    <message>
        <source>Choose organ surfaces of a patient (Ctrl+O)</source>
        <translation>Elegir superficies de órganos de un paciente (Ctrl+O)</translation>
    </message>
    <message>
        <source>Sample organs</source>
        <translation>Órganos de muestra</translation>
    </message>
    <message>
        <source>Organs that come with the program</source>
        <translation>Órganos que se incluyen con el programa</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Recorrido de dos minutos</translation>
    </message>
    <message>
        <source>The parts of the window, step by step</source>
        <translation>Las partes de la ventana, paso a paso</translation>
    </message>
    <message>
        <source>Close this card (Help &gt; Welcome shows it again)</source>
        <translation>Cerrar esta tarjeta (Ayuda &gt; Bienvenida la muestra de nuevo)</translation>
    </message>
    <message>
        <source>Close this card</source>
        <translation>Cerrar esta tarjeta</translation>
    </message>
    <message>
        <source>First task</source>
        <translation>Primera tarea</translation>
    </message>
    <message>
        <source>Drag a dot, and see the organ follow</source>
        <translation>Arrastrar un punto y ver cómo sigue el órgano</translation>
    </message>
</context>
<context>
    <name>viscera::app::WindowLayout</name>
    <message>
        <source>&amp;Standard layout</source>
        <translation>&amp;Disposición estándar</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Pantalla completa</translation>
    </message>
    <message>
        <source>The window takes the whole screen</source>
        <translation>La ventana ocupa toda la pantalla</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Modos</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Diapositivas</translation>
    </message>
    <message>
        <source>Move all panels to their default places</source>
        <translation>Mover todos los paneles a sus lugares predeterminados</translation>
    </message>
</context>
<context>
    <name>viscera::app::Workspace</name>
    <message>
        <source>Open folder</source>
        <translation>Abrir carpeta</translation>
    </message>
</context>
</TS>
