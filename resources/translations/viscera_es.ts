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
        <source>Measurements</source>
        <translation>Mediciones</translation>
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
        <source>Left</source>
        <translation>Izquierda</translation>
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
        <source>Handles</source>
        <translation>Tiradores</translation>
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
        <source>Back to the shape as sent (R)</source>
        <translation>Volver a la forma original (R)</translation>
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
        <source>%1 % by the handles</source>
        <translation>%1 % por los tiradores</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1: fracción de eyección</translation>
    </message>
    <message>
        <source>Stroke volume</source>
        <translation>Volumen sistólico</translation>
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
        <source>Rate</source>
        <translation>Frecuencia</translation>
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
        <source>Organ</source>
        <translation>Órgano</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Ventrículo derecho</translation>
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
        <source>Name on it</source>
        <translation>Nombre encima</translation>
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
        <source>end-diastolic volume</source>
        <translation>volumen telediastólico</translation>
    </message>
    <message>
        <source>end-systolic volume</source>
        <translation>volumen telesistólico</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>fracción de eyección</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volumen después de comer</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volumen</translation>
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
        <source>Heart</source>
        <translation>Corazón</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómago</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Bazo</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Riñón</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Riñón izquierdo</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Riñón derecho</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vesícula biliar</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Páncreas</translation>
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
        <source>Breathing</source>
        <translation>Respiración</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Grabado</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Atrial systole</source>
        <translation>Sístole auricular</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Contracción isovolumétrica</translation>
    </message>
    <message>
        <source>Ejection</source>
        <translation>Eyección</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Relajación isovolumétrica</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Llenado</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Onda en el cuerpo</translation>
    </message>
    <message>
        <source>Wave in the antrum</source>
        <translation>Onda en el antro</translation>
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
        <source>Inspiration</source>
        <translation>Inspiración</translation>
    </message>
    <message>
        <source>Expiration</source>
        <translation>Espiración</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
</context>
</TS>
