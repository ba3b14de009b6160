<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>%1 triangles instead of %2; the old surface lies %3 mm from the new one on average, %4 mm at most</source>
        <translation>%1 triángulos en lugar de %2; la superficie antigua dista de la nueva %3 mm de media y %4 mm como máximo</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>%1 and %2 are at one place: %3 from each other</source>
        <translation>%1 y %2 están en el mismo sitio: a %3 uno de otro</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>%1 at %2 % of the cycle: %3</source>
        <translation>%1 al %2 % del ciclo: %3</translation>
    </message>
    <message>
        <source>%1 gives another surface than the one that was saved</source>
        <translation>%1 da otra superficie que la guardada</translation>
    </message>
    <message>
        <source>%1 has changed since the session was saved</source>
        <translation>%1 ha cambiado desde que se guardó la sesión</translation>
    </message>
    <message>
        <source>%1 has no volume in %2</source>
        <translation>%1 no tiene volumen en la %2</translation>
    </message>
    <message>
        <source>%1 has no voxels any more</source>
        <translation>%1 ya no tiene vóxeles</translation>
    </message>
    <message>
        <source>%1 has other triangles in %2 than in the first: surfaces are fitted by their distances, which do not see motion along the wall</source>
        <translation>%1 tiene en la %2 otros triángulos que en la primera: las superficies se ajustan por sus distancias, que no ven el movimiento a lo largo de la pared</translation>
    </message>
    <message>
        <source>%1 ml cannot be reached</source>
        <translation>no se pueden alcanzar %1 ml</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates</source>
        <translation>%1 de %2 vértices no tienen coordenadas</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates in the cage</source>
        <translation>%1 de %2 vértices no tienen coordenadas en la jaula</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie in no group's region</source>
        <translation>%1 de %2 vértices no están en la región de ningún grupo</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 de más de 1 GB no cabe en un archivo de sesión</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm around %7, %8, %9</source>
        <translation>%1 x %2 x %3 vóxeles de %4 x %5 x %6 mm en torno a %7; %8; %9</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2 and not in others, so that its volumes would be cut off</source>
        <translation>%1 toca el borde de la imagen en la %2 y no en otras, de modo que sus volúmenes quedarían recortados</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2: what lies beyond is not in its volume</source>
        <translation>%1 toca el borde de la imagen en la %2: lo que queda fuera no está en su volumen</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in every phase: what lies beyond is not in its volume</source>
        <translation>%1 toca el borde de la imagen en todas las fases: lo que queda fuera no está en su volumen</translation>
    </message>
    <message numerus="yes">
        <source>%2, %n of them {is a small fragment|are small fragments} of less than 2 % of its area</source>
        <translation>
            <numerusform>%2, %n de ellos es un pequeño fragmento de menos del 2 % de su área</numerusform>
            <numerusform>%2, %n de ellos son pequeños fragmentos de menos del 2 % de su área</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modificado</translation>
    </message>
    <message>
        <source>%1, handle %2</source>
        <translation>%1, tirador %2</translation>
    </message>
    <message>
        <source>%1, handles %2 and %3</source>
        <translation>%1, tiradores %2 y %3</translation>
    </message>
    <message>
        <source>%1, key at %2 s</source>
        <translation>%1, fotograma clave en %2 s</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 lie outside the handles' hull, by up to %3 mm</source>
        <translation>%1: %2 están fuera de la envolvente de los tiradores, hasta %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n {hole|holes} closed by {a flat cap|flat caps}</source>
        <translation>
            <numerusform>%1: %n agujero cerrado con una tapa plana</numerusform>
            <numerusform>%1: %n agujeros cerrados con tapas planas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1: «%2» es desconocido y no se guardará de nuevo</translation>
    </message>
    <message>
        <source>%1: points that coincide in the first phase separate by up to %2 mm; Viscera keeps them together</source>
        <translation>%1: puntos que coinciden en la primera fase se separan hasta %2 mm; Viscera los mantiene juntos</translation>
    </message>
    <message>
        <source>%1; it looks like %2</source>
        <translation>%1; parece %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices were read, slices %3 to %4, which are even; the others, or all of them resampled, can be chosen as a series</source>
        <translation>se leyeron %1 de %2 cortes, del %3 al %4, que son regulares; los demás, o todos remuestreados, se pueden elegir como serie</translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest</source>
        <translation>
            <numerusform>%2 fragmentos, %n vóxel aparte del mayor</numerusform>
            <numerusform>%2 fragmentos, %n vóxeles aparte del mayor</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest left out</source>
        <translation>
            <numerusform>%2 fragmentos, se omite %n vóxel aparte del mayor</numerusform>
            <numerusform>%2 fragmentos, se omiten %n vóxeles aparte del mayor</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; check whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
        <translation>
            <numerusform>%2 queda fuera del estudio; compruebe que ambos son del mismo paciente y usan los mismos ejes (RAS o LPS)</numerusform>
            <numerusform>%2 quedan fuera del estudio; compruebe que todos son del mismo paciente y usan los mismos ejes (RAS o LPS)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary {edge|edges}: the surface is open and has no volume</source>
        <translation>
            <numerusform>%n arista de borde: la superficie está abierta y no tiene volumen</numerusform>
            <numerusform>%n aristas de borde: la superficie está abierta y no tiene volumen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the end ignored</source>
        <translation>
            <numerusform>se ignora %n byte después del final</numerusform>
            <numerusform>se ignoran %n bytes después del final</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the last triangle ignored</source>
        <translation>
            <numerusform>se ignora %n byte después del último triángulo</numerusform>
            <numerusform>se ignoran %n bytes después del último triángulo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge joins|edges join} more than two triangles</source>
        <translation>
            <numerusform>%n arista une más de dos triángulos</numerusform>
            <numerusform>%n aristas unen más de dos triángulos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge lies|edges lie} between triangles of opposite orientation</source>
        <translation>
            <numerusform>%n arista está entre triángulos de orientación opuesta</numerusform>
            <numerusform>%n aristas están entre triángulos de orientación opuesta</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {file is a copy|files are copies} of another one and left out</source>
        <translation>
            <numerusform>%n archivo es copia de otro y se omite</numerusform>
            <numerusform>%n archivos son copias de otro y se omiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {file is|files are} damaged and left out (%2: %3)</source>
        <translation>
            <numerusform>%n archivo está dañado y se omite (%2: %3)</numerusform>
            <numerusform>%n archivos están dañados y se omiten (%2: %3)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is in no group and moves|handles are in no group and move} nothing</source>
        <translation>
            <numerusform>%n tirador no está en ningún grupo y no mueve nada</numerusform>
            <numerusform>%n tiradores no están en ningún grupo y no mueven nada</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is|handles are} too few</source>
        <translation>
            <numerusform>%n tirador es demasiado poco</numerusform>
            <numerusform>%n tiradores son demasiado pocos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles}</source>
        <translation>
            <numerusform>%n tirador</numerusform>
            <numerusform>%n tiradores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} cannot form %2 groups</source>
        <translation>
            <numerusform>%n tirador no puede formar %2 grupos</numerusform>
            <numerusform>%n tiradores no pueden formar %2 grupos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} whose label another one has got a new one</source>
        <translation>
            <numerusform>%n tirador cuya etiqueta tiene otro recibió una nueva</numerusform>
            <numerusform>%n tiradores cuya etiqueta tiene otro recibieron una nueva</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} without a label got one</source>
        <translation>
            <numerusform>%n tirador sin etiqueta recibió una</numerusform>
            <numerusform>%n tiradores sin etiqueta recibieron una</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line or point cell|line or point cells} ignored</source>
        <translation>
            <numerusform>%n celda de línea o punto omitida</numerusform>
            <numerusform>%n celdas de línea o punto omitidas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line|lines} with points, curves or free-form surfaces ignored</source>
        <translation>
            <numerusform>se ignora %n línea con puntos, curvas o superficies de forma libre</numerusform>
            <numerusform>se ignoran %n líneas con puntos, curvas o superficies de forma libre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {mask is|masks are} empty (%2)</source>
        <translation>
            <numerusform>%n máscara está vacía (%2)</numerusform>
            <numerusform>%n máscaras están vacías (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to repair the surface first</source>
        <translation>
            <numerusform>%n par de triángulos se cruza: el modo de estrés quizá deba reparar antes la superficie</numerusform>
            <numerusform>%n pares de triángulos se cruzan: el modo de estrés quizá deba reparar antes la superficie</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series of another echo left out</source>
        <translation>
            <numerusform>se omite %n imagen de la serie de otro eco</numerusform>
            <numerusform>se omiten %n imágenes de la serie de otro eco</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series that {lies|lie} in another direction left out</source>
        <translation>
            <numerusform>se omite %n imagen de la serie que está en otra dirección</numerusform>
            <numerusform>se omiten %n imágenes de la serie que están en otra dirección</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {place has|places have} more than one slice (%2); the one with the lowest number was read</source>
        <translation>
            <numerusform>%n posición tiene más de un corte (%2); se leyó el de número más bajo</numerusform>
            <numerusform>%n posiciones tienen más de un corte (%2); se leyó el de número más bajo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that repeats|points that repeat} another merged</source>
        <translation>
            <numerusform>%n punto que repite otro fusionado</numerusform>
            <numerusform>%n puntos que repiten otros fusionados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point|points} without a triangle dropped</source>
        <translation>
            <numerusform>%n punto sin triángulo omitido</numerusform>
            <numerusform>%n puntos sin triángulo omitidos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} no voxels (%2)</source>
        <translation>
            <numerusform>%n segmento no tiene vóxeles (%2)</numerusform>
            <numerusform>%n segmentos no tienen vóxeles (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {set|sets} of points or lines ignored</source>
        <translation>
            <numerusform>se ignora %n conjunto de puntos o líneas</numerusform>
            <numerusform>se ignoran %n conjuntos de puntos o líneas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice is|slices are} missing between slice %2 (%3) and the next, which are %4 mm apart in place of %5 mm</source>
        <translation>
            <numerusform>falta %n corte entre el corte %2 (%3) y el siguiente, que distan %4 mm en lugar de %5 mm</numerusform>
            <numerusform>faltan %n cortes entre el corte %2 (%3) y el siguiente, que distan %4 mm en lugar de %5 mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle has|triangles have} no area</source>
        <translation>
            <numerusform>%n triángulo no tiene área</numerusform>
            <numerusform>%n triángulos no tienen área</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle was|triangles were} turned around to face outward.</source>
        <translation>
            <numerusform>%n triángulo se giró hacia fuera.</numerusform>
            <numerusform>%n triángulos se giraron hacia fuera.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle without area or that came twice is|triangles without area or that came twice are} left out.</source>
        <translation>
            <numerusform>Se omite %n triángulo sin área o repetido.</numerusform>
            <numerusform>Se omiten %n triángulos sin área o repetidos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} with a repeated corner dropped</source>
        <translation>
            <numerusform>%n triángulo con un vértice repetido omitido</numerusform>
            <numerusform>%n triángulos con un vértice repetido omitidos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex lies|vertices lie} outside the hull of the sequence's handles</source>
        <translation>
            <numerusform>%n vértice está fuera de la envolvente de los tiradores de la secuencia</numerusform>
            <numerusform>%n vértices están fuera de la envolvente de los tiradores de la secuencia</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex|vertices} cannot be divided among %2 groups</source>
        <translation>
            <numerusform>%n vértice no se puede repartir entre %2 grupos</numerusform>
            <numerusform>%n vértices no se pueden repartir entre %2 grupos</numerusform>
        </translation>
    </message>
    <message>
        <source>0 starts from all ones, others from random numbers</source>
        <translation>0 parte de pesos todos iguales a 1, los otros de números aleatorios</translation>
    </message>
    <message>
        <source>19 of 20 adults have %1 to %2 ml</source>
        <translation>19 de cada 20 adultos tienen de %1 a %2 ml</translation>
    </message>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adulto sano en decúbito.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Se pierde una cuarta parte del volumen sanguíneo estresado; no responde ningún reflejo, por lo que las presiones bajan más que en la realidad.</translation>
    </message>
    <message>
        <source>A session cannot be opened beside another</source>
        <translation>Una sesión no se puede abrir junto a otra</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Una sesión se abre sola</translation>
    </message>
    <message>
        <source>A slice cannot be read, so the series is not opened: %1</source>
        <translation>No se puede leer un corte, así que la serie no se abre: %1</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Un ventrículo izquierdo rígido que se relaja despacio: se vacía bien y solo se llena a presión alta.</translation>
    </message>
    <message>
        <source>A ventricle's volume is not positive</source>
        <translation>El volumen de un ventrículo no es positivo</translation>
    </message>
    <message>
        <source>A weak, dilated left ventricle and retained fluid: the loop lies far to the right, blood backs up to the lungs. Its wall has more muscle and is no thicker.</source>
        <translation>Un ventrículo izquierdo débil y dilatado y retención de líquido: el bucle queda muy a la derecha y la sangre se remansa hacia los pulmones. Su pared tiene más músculo y no es más gruesa.</translation>
    </message>
    <message>
        <source>A wire in the space of balanced vectors; for many points it has no answer</source>
        <translation>Un hilo en el espacio de vectores equilibrados; para muchos puntos no tiene respuesta</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message numerus="yes">
        <source>Add %n {organ|organs}</source>
        <translation>
            <numerusform>Añadir %n órgano</numerusform>
            <numerusform>Añadir %n órganos</numerusform>
        </translation>
    </message>
    <message>
        <source>Add enclosing group</source>
        <translation>Añadir grupo envolvente</translation>
    </message>
    <message>
        <source>Add enclosing handles</source>
        <translation>Añadir tiradores envolventes</translation>
    </message>
    <message>
        <source>Add group %1</source>
        <translation>Añadir el grupo %1</translation>
    </message>
    <message>
        <source>Add to group</source>
        <translation>Añadir al grupo</translation>
    </message>
    <message numerus="yes">
        <source>Add {handle|%n handles}</source>
        <translation>
            <numerusform>Añadir tirador</numerusform>
            <numerusform>Añadir %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Afterload: pulmonary resistance</source>
        <translation>Poscarga: resistencia pulmonar</translation>
    </message>
    <message>
        <source>Afterload: systemic resistance</source>
        <translation>Poscarga: resistencia sistémica</translation>
    </message>
    <message>
        <source>An ejection fraction of %1 is out of range</source>
        <translation>Una fracción de eyección de %1 está fuera del intervalo</translation>
    </message>
    <message>
        <source>An organ needs at least four handles around it: add %1 more</source>
        <translation>Un órgano necesita al menos cuatro tiradores a su alrededor: añada %1 más</translation>
    </message>
    <message>
        <source>An organ needs handles around it</source>
        <translation>Un órgano necesita tiradores en torno a él</translation>
    </message>
    <message>
        <source>Antrum</source>
        <translation>Antro</translation>
    </message>
    <message>
        <source>Any point on the side of the right ventricle</source>
        <translation>Cualquier punto del lado del ventrículo derecho</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorta</translation>
    </message>
    <message>
        <source>Aorta, characteristic impedance</source>
        <translation>Aorta, impedancia característica</translation>
    </message>
    <message>
        <source>Aorta, diastolic</source>
        <translation>Aorta, diastólica</translation>
    </message>
    <message>
        <source>Aorta, mean</source>
        <translation>Aorta, media</translation>
    </message>
    <message>
        <source>Aorta, systolic</source>
        <translation>Aorta, sistólica</translation>
    </message>
    <message>
        <source>Aortic arch</source>
        <translation>Arco aórtico</translation>
    </message>
    <message>
        <source>Aortic gradient, mean</source>
        <translation>Gradiente aórtico, medio</translation>
    </message>
    <message>
        <source>Aortic stenosis</source>
        <translation>Estenosis aórtica</translation>
    </message>
    <message>
        <source>Aortic valve</source>
        <translation>Válvula aórtica</translation>
    </message>
    <message>
        <source>Aortic valve, leak</source>
        <translation>Válvula aórtica, fuga</translation>
    </message>
    <message>
        <source>Aortic valve, open</source>
        <translation>Válvula aórtica, abierta</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Ápex</translation>
    </message>
    <message>
        <source>Appendix</source>
        <translation>Apéndice</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Arterial elastance Ea</source>
        <translation>Elastancia arterial Ea</translation>
    </message>
    <message>
        <source>Arteries</source>
        <translation>Arterias</translation>
    </message>
    <message>
        <source>Ascending aorta</source>
        <translation>Aorta ascendente</translation>
    </message>
    <message>
        <source>Ascending colon</source>
        <translation>Colon ascendente</translation>
    </message>
    <message>
        <source>Atria</source>
        <translation>Aurículas</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Balanced weights nearest to a target; a parameter says how negative weights are treated</source>
        <translation>Pesos en equilibrio, los más próximos a un objetivo; un parámetro indica cómo se tratan los pesos negativos</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Warping the image</source>
        <translation>Deformando la imagen</translation>
    </message>
    <message>
        <source>Warping the scan</source>
        <translation>Deformando el estudio</translation>
    </message>
    <message>
        <source>Warped</source>
        <translation>Deformado</translation>
    </message>
    <message>
        <source>Beyond the data: people were measured from 50 to 171 beats a minute</source>
        <translation>Fuera de los datos: se midió a personas entre 50 y 171 latidos por minuto</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Conducto colédoco</translation>
    </message>
    <message>
        <source>Binding %1</source>
        <translation>Vinculación de %1</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Heartbeat: %1</source>
        <translation>Latido: %1</translation>
    </message>
    <message>
        <source>LV (ml)</source>
        <translation>VI (ml)</translation>
    </message>
    <message>
        <source>Preparing the volume lock</source>
        <translation>Preparación del bloqueo del volumen</translation>
    </message>
    <message>
        <source>Binding the space between the handles</source>
        <translation>Vinculación del espacio entre los tiradores</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>De azul a rojo</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Body of the stomach</source>
        <translation>Cuerpo del estómago</translation>
    </message>
    <message>
        <source>Bones and joints</source>
        <translation>Huesos y articulaciones</translation>
    </message>
    <message>
        <source>Bounded biharmonic weights</source>
        <translation>Pesos biarmónicos acotados</translation>
    </message>
    <message>
        <source>Bradygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Bradigastria: las personas sanas tienen de 2 a 4 ondas por minuto.</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Respiración</translation>
    </message>
    <message>
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not interpolate its handles</source>
        <translation>Con esquinas y normales de una jaula de cualquier forma; casi conserva los ángulos y no interpola sus tiradores</translation>
    </message>
    <message>
        <source>C-Celestial</source>
        <translation>C-Celestial</translation>
    </message>
    <message>
        <source>Caecum</source>
        <translation>Ciego</translation>
    </message>
    <message>
        <source>Cardia</source>
        <translation>Cardias</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Gasto cardíaco</translation>
    </message>
    <message>
        <source>Catalogue of layers</source>
        <translation>Catálogo de capas</translation>
    </message>
    <message>
        <source>Caudate lobe</source>
        <translation>Lóbulo caudado</translation>
    </message>
    <message>
        <source>Centreline</source>
        <translation>Línea central</translation>
    </message>
    <message>
        <source>Centroid of all positive solutions, estimated by sampling; more samples are more accurate</source>
        <translation>Centroide de todas las soluciones positivas, estimado por muestreo; más muestras dan más exactitud</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Cambiar grupo</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Cambiar aspecto</translation>
    </message>
    <message>
        <source>Change key sequence</source>
        <translation>Cambiar secuencia de fotogramas clave</translation>
    </message>
    <message>
        <source>Checking %1</source>
        <translation>Comprobación de %1</translation>
    </message>
    <message>
        <source>Circulation: %1</source>
        <translation>Circulación: %1</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Cerrar agujeros</translation>
    </message>
    <message>
        <source>Close scan</source>
        <translation>Cerrar el estudio</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Colorear grupo</translation>
    </message>
    <message numerus="yes">
        <source>Compensate with {handle|%n handles}</source>
        <translation>
            <numerusform>Compensar con este tirador</numerusform>
            <numerusform>Compensar con %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Contractility of the left ventricle</source>
        <translation>Contractilidad del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Contractility of the right ventricle</source>
        <translation>Contractilidad del ventrículo derecho</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordenadas</translation>
    </message>
    <message>
        <source>Coordinates %1</source>
        <translation>Coordenadas %1</translation>
    </message>
    <message>
        <source>Coupling Ea/Ees</source>
        <translation>Acoplamiento Ea/Ees</translation>
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
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Locality</source>
        <translation>Localidad</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desfase</translation>
    </message>
    <message>
        <source>Partitions</source>
        <translation>Particiones</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Polyhedra</source>
        <translation>Poliedros</translation>
    </message>
    <message>
        <source>Positivity</source>
        <translation>Positividad</translation>
    </message>
    <message>
        <source>RV (ml)</source>
        <translation>VD (ml)</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Muestreo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Stress over the cycle</source>
        <translation>Estrés durante el ciclo</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transferencia</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Delaunay triangulation approach</source>
        <translation>Método de triangulación de Delaunay</translation>
    </message>
    <message>
        <source>Descending colon</source>
        <translation>Colon descendente</translation>
    </message>
    <message numerus="yes">
        <source>Describe {handle|%n handles}</source>
        <translation>
            <numerusform>Describir tirador</numerusform>
            <numerusform>Describir %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Determinants approach</source>
        <translation>Método de determinantes</translation>
    </message>
    <message>
        <source>Digestive system</source>
        <translation>Sistema digestivo</translation>
    </message>
    <message>
        <source>Distance from a zone within which its super-region still counts: smoothness against locality</source>
        <translation>Distancia a una zona dentro de la cual aún cuenta su superregión: suavidad frente a localidad</translation>
    </message>
    <message>
        <source>Distance over which the pull of a handle is rounded; 0 passes through the handles</source>
        <translation>Distancia en la que se redondea la tracción de un tirador; 0 pasa por los tiradores</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^level rays</source>
        <translation>Divisiones del icosaedro: 20 * 4^level rayos</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^samples directions</source>
        <translation>Divisiones del icosaedro: 20 * 4^samples direcciones</translation>
    </message>
    <message>
        <source>Dome under the diaphragm</source>
        <translation>Cúpula bajo el diafragma</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Duodeno</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>ECG</translation>
    </message>
    <message>
        <source>Easing %1</source>
        <translation>Transición %1</translation>
    </message>
    <message>
        <source>Edges of tetrahedra across the handles; more are finer and slower</source>
        <translation>Aristas de tetraedros entre los tiradores; más son más finas y lentas</translation>
    </message>
    <message>
        <source>Ejection fraction</source>
        <translation>Fracción de eyección</translation>
    </message>
    <message>
        <source>Enclosing</source>
        <translation>Envolventes</translation>
    </message>
    <message>
        <source>ESPVR and EDPVR</source>
        <translation>ESPVR y EDPVR</translation>
    </message>
    <message>
        <source>Endocrine glands</source>
        <translation>Glándulas endocrinas</translation>
    </message>
    <message>
        <source>Epicardium</source>
        <translation>Epicardio</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Ejercicio</translation>
    </message>
    <message>
        <source>Far corners</source>
        <translation>Esquinas lejanas</translation>
    </message>
    <message>
        <source>Added volume that multiplies pericardial pressure by e</source>
        <translation>Volumen que multiplica por e la presión pericárdica</translation>
    </message>
    <message>
        <source>Fitted circulation</source>
        <translation>Circulación ajustada</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fijos</translation>
    </message>
    <message>
        <source>Fluid in the pericardium</source>
        <translation>Líquido en el pericardio</translation>
    </message>
    <message>
        <source>Fluid in the pericardium presses on all chambers: they fill little, and all filling pressures are the same.</source>
        <translation>El líquido del pericardio comprime todas las cavidades: se llenan poco y todas las presiones de llenado son iguales.</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Plegado</translation>
    </message>
    <message>
        <source>Folded tissue</source>
        <translation>Tejido plegado</translation>
    </message>
    <message>
        <source>Discard kept circulation</source>
        <translation>Descartar la circulación conservada</translation>
    </message>
    <message>
        <source>From atrial to ventricular contraction</source>
        <translation>De la contracción auricular a la ventricular</translation>
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
        <translation>Peristaltismo gástrico</translation>
    </message>
    <message>
        <source>Gradient method</source>
        <translation>Método del gradiente</translation>
    </message>
    <message>
        <source>Great vessels</source>
        <translation>Grandes vasos</translation>
    </message>
    <message>
        <source>Greater curvature</source>
        <translation>Curvatura mayor</translation>
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
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Group automatically</source>
        <translation>Agrupar automáticamente</translation>
    </message>
    <message>
        <source>Groups of handles move only their own region of the organ; neighbouring regions blend smoothly.</source>
        <translation>Los grupos de tiradores mueven solo su propia región del órgano; las regiones vecinas se funden suavemente.</translation>
    </message>
    <message>
        <source>Haemorrhage</source>
        <translation>Hemorragia</translation>
    </message>
    <message>
        <source>Hard upright work: a fast and strong heart, open muscle vessels, veins that give blood back.</source>
        <translation>Esfuerzo intenso en bipedestación: un corazón rápido y fuerte, vasos musculares abiertos, venas que devuelven sangre.</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>Armónicas</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Corazón</translation>
    </message>
    <message>
        <source>Heart failure, preserved EF</source>
        <translation>Insuficiencia cardíaca, FE conservada</translation>
    </message>
    <message>
        <source>Heart failure, reduced EF</source>
        <translation>Insuficiencia cardíaca, FE reducida</translation>
    </message>
    <message>
        <source>Heart follows the circulation</source>
        <translation>El corazón sigue la circulación</translation>
    </message>
    <message>
        <source>Heart follows the textbook</source>
        <translation>El corazón sigue el manual</translation>
    </message>
    <message>
        <source>Heart rate</source>
        <translation>Frecuencia cardíaca</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Latido</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message numerus="yes">
        <source>Hide {handle|%n handles}</source>
        <translation>
            <numerusform>Ocultar tirador</numerusform>
            <numerusform>Ocultar %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>How far beyond the handles' hull the weights are computed</source>
        <translation>Hasta dónde se calculan los pesos fuera de la envolvente de los tiradores</translation>
    </message>
    <message>
        <source>How much nearer handles count more; 0 as in the thesis</source>
        <translation>Cuánto más cuentan los tiradores próximos; 0 como en la tesis</translation>
    </message>
    <message>
        <source>How near to a flip the two triangulations are blended; 0 for not</source>
        <translation>A qué distancia de una inversión se mezclan las dos triangulaciones; 0 para no mezclar</translation>
    </message>
    <message>
        <source>Method that finds positive balanced vectors</source>
        <translation>Método que halla vectores equilibrados positivos</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Cómo llegan a los tiradores los pesos de los vértices de Voronoi</translation>
    </message>
    <message>
        <source>Order in which the wire connects the points</source>
        <translation>Orden en que el hilo une los puntos</translation>
    </message>
    <message>
        <source>Hypertension</source>
        <translation>Hipertensión</translation>
    </message>
    <message>
        <source>Incremental approach</source>
        <translation>Método incremental</translation>
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
        <translation>Influencia de %1</translation>
    </message>
    <message>
        <source>Inner handles of each layer</source>
        <translation>Tiradores interiores de cada capa</translation>
    </message>
    <message>
        <source>Internal error of an unknown kind</source>
        <translation>Error interno de tipo desconocido</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Error interno: %1</translation>
    </message>
    <message>
        <source>It cannot be opened: %1</source>
        <translation>No se puede abrir: %1</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>No se puede leer</translation>
    </message>
    <message>
        <source>It cannot be read to its end</source>
        <translation>No se puede leer hasta el final</translation>
    </message>
    <message>
        <source>It cannot be written: %1</source>
        <translation>No se puede escribir: %1</translation>
    </message>
    <message>
        <source>It cannot be written: it is a folder</source>
        <translation>No se puede escribir: es una carpeta</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Se cruza consigo misma, en %n par de triángulos</numerusform>
            <numerusform>Se cruza consigo misma, en %n pares de triángulos</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not fit into memory</source>
        <translation>no cabe en la memoria</translation>
    </message>
    <message>
        <source>The duration of one cycle is unknown</source>
        <translation>La duración de un ciclo es desconocida</translation>
    </message>
    <message numerus="yes">
        <source>It does not say the times of its %n {phase|phases}; they are numbered</source>
        <translation>
            <numerusform>No indica el tiempo de su %n fase; se numera</numerusform>
            <numerusform>No indica los tiempos de sus %n fases; se numeran</numerusform>
        </translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as milliseconds</source>
        <translation>No indica la unidad de sus tiempos; se toman como milisegundos</translation>
    </message>
    <message>
        <source>It has %1 labels; a mask in a folder has one</source>
        <translation>Tiene %1 etiquetas; una máscara de una carpeta tiene una</translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a region needs at least 4</source>
        <translation>
            <numerusform>Tiene %n tirador; una región necesita al menos 4</numerusform>
            <numerusform>Tiene %n tiradores; una región necesita al menos 4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a sequence needs four at least</source>
        <translation>
            <numerusform>Tiene %n tirador; una secuencia necesita al menos cuatro</numerusform>
            <numerusform>Tiene %n tiradores; una secuencia necesita al menos cuatro</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {phase|phases}; a motion needs four at least</source>
        <translation>
            <numerusform>Tiene %n fase; un movimiento necesita al menos cuatro</numerusform>
            <numerusform>Tiene %n fases; un movimiento necesita al menos cuatro</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {vertex|vertices}</source>
        <translation>
            <numerusform>Tiene %n vértice</numerusform>
            <numerusform>Tiene %n vértices</numerusform>
        </translation>
    </message>
    <message>
        <source>It has a label above 2147483647</source>
        <translation>Tiene una etiqueta superior a 2147483647</translation>
    </message>
    <message>
        <source>It has more than %1 files</source>
        <translation>Tiene más de %1 archivos</translation>
    </message>
    <message>
        <source>It has more than 32767 voxels along a side, which NIfTI cannot hold</source>
        <translation>Tiene más de 32767 vóxeles a lo largo de un lado, que NIfTI no admite</translation>
    </message>
    <message>
        <source>It has no DICOM files with images</source>
        <translation>No tiene archivos DICOM con imágenes</translation>
    </message>
    <message>
        <source>It has no labelled voxel: all are 0</source>
        <translation>No tiene ningún vóxel etiquetado: todos son 0</translation>
    </message>
    <message>
        <source>It has no phase %1; it has %2</source>
        <translation>No tiene la fase %1; tiene %2</translation>
    </message>
    <message>
        <source>It has no slices of a scan</source>
        <translation>No tiene cortes de un estudio</translation>
    </message>
    <message>
        <source>It has no slices of a scan: &quot;%1&quot; %2</source>
        <translation>No tiene cortes de un estudio: «%1» %2</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>No tiene la superficie «%1»</translation>
    </message>
    <message>
        <source>It has no triangles</source>
        <translation>No tiene triángulos</translation>
    </message>
    <message>
        <source>It does not have three dimensions</source>
        <translation>No tiene tres dimensiones</translation>
    </message>
    <message>
        <source>It has several axes that are not of space</source>
        <translation>Tiene varios ejes que no son del espacio</translation>
    </message>
    <message>
        <source>It has several labels: %1</source>
        <translation>Hay varias etiquetas: %1</translation>
    </message>
    <message>
        <source>It has several values per voxel</source>
        <translation>Tiene varios valores por vóxel</translation>
    </message>
    <message>
        <source>It has several values per voxel (%1)</source>
        <translation>Tiene varios valores por vóxel (%1)</translation>
    </message>
    <message>
        <source>It has to be positive</source>
        <translation>Debe ser positivo</translation>
    </message>
    <message>
        <source>It holds an image, not labels: it has more than %1 different values</source>
        <translation>Contiene una imagen, no etiquetas: tiene más de %1 valores distintos</translation>
    </message>
    <message>
        <source>It holds an image, not labels: one of its values is %1</source>
        <translation>Contiene una imagen, no etiquetas: uno de sus valores es %1</translation>
    </message>
    <message>
        <source>It holds more than %1 masks</source>
        <translation>Contiene más de %1 máscaras</translation>
    </message>
    <message>
        <source>It holds neither surfaces nor label maps</source>
        <translation>No contiene ni superficies ni mapas de etiquetas</translation>
    </message>
    <message>
        <source>It holds no PolyData</source>
        <translation>No contiene PolyData</translation>
    </message>
    <message>
        <source>It holds no label map</source>
        <translation>No contiene ningún mapa de etiquetas</translation>
    </message>
    <message>
        <source>It holds no triangles</source>
        <translation>No contiene triángulos</translation>
    </message>
    <message>
        <source>It holds no triangles, only points</source>
        <translation>No contiene triángulos, solo puntos</translation>
    </message>
    <message>
        <source>It holds only empty masks</source>
        <translation>Solo contiene máscaras vacías</translation>
    </message>
    <message>
        <source>It holds points, but no faces</source>
        <translation>Contiene puntos, pero no caras</translation>
    </message>
    <message>
        <source>It is a DICOM file without an image</source>
        <translation>Es un archivo DICOM sin imagen</translation>
    </message>
    <message>
        <source>It is a DICOM file, but no segmentation (%1)</source>
        <translation>Es un archivo DICOM, pero no una segmentación (%1)</translation>
    </message>
    <message>
        <source>It is a binary OFF file, which Viscera does not read</source>
        <translation>Es un archivo OFF binario, que Viscera no lee</translation>
    </message>
    <message>
        <source>It is a folder, not a file</source>
        <translation>Es una carpeta, no un archivo</translation>
    </message>
    <message>
        <source>It is a scan, not an organ</source>
        <translation>Es un estudio, no un órgano</translation>
    </message>
    <message>
        <source>It is glTF version %1, but only 2 can be read</source>
        <translation>Es glTF versión %1, pero solo se puede leer la 2</translation>
    </message>
    <message>
        <source>It is named %1 but looks like %2</source>
        <translation>Se llama %1, pero parece %2</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>No es un archivo de tipo %1: su «format» no es «%2»</translation>
    </message>
    <message>
        <source>It is not a file with several phases</source>
        <translation>No es un archivo con varias fases</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>No es un archivo que se pueda leer</translation>
    </message>
    <message>
        <source>It is not a handle file</source>
        <translation>No es un archivo de tiradores</translation>
    </message>
    <message>
        <source>It is not a regular file</source>
        <translation>No es un archivo normal</translation>
    </message>
    <message>
        <source>It is not a scan in a known format</source>
        <translation>No es un estudio en un formato conocido</translation>
    </message>
    <message>
        <source>It is not a slice of a scan</source>
        <translation>No es un corte de un estudio</translation>
    </message>
    <message>
        <source>It is not a slice of a scan: it %1</source>
        <translation>No es un corte de un estudio: %1</translation>
    </message>
    <message>
        <source>It is not convex at its triangle %1</source>
        <translation>No es convexa en su triángulo %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>Es de la versión %1; este programa lee hasta la %2</translation>
    </message>
    <message>
        <source>It is too large: %1 points</source>
        <translation>Es demasiado grande: %1 puntos</translation>
    </message>
    <message>
        <source>The displacement field would have more than 20 million points</source>
        <translation>El campo de desplazamientos tendría más de 20 millones de puntos</translation>
    </message>
    <message>
        <source>It mixes surfaces and label maps</source>
        <translation>Mezcla superficies y mapas de etiquetas</translation>
    </message>
    <message>
        <source>It needs the glTF extension %1, which Viscera does not know</source>
        <translation>Necesita la extensión de glTF %1, que Viscera no conoce</translation>
    </message>
    <message>
        <source>It seems to be in RAS where %1 is in LPS, or the other way round: it lies on the opposite side of the patient's middle</source>
        <translation>Parece estar en RAS mientras que %1 está en LPS, o al revés: está al otro lado del centro del paciente</translation>
    </message>
    <message>
        <source>Its grid is sheared: its axes are not at right angles</source>
        <translation>Su cuadrícula está cizallada: sus ejes no forman ángulos rectos</translation>
    </message>
    <message>
        <source>Keep circulation for comparison</source>
        <translation>Conservar la circulación para comparar</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Riñón</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Riñón izquierdo</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Riñón derecho</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>Cav. AI</translation>
    </message>
    <message>
        <source>LV cavity</source>
        <translation>Cav. VI</translation>
    </message>
    <message>
        <source>LV dP/dt, largest</source>
        <translation>dP/dt del VI, máxima</translation>
    </message>
    <message>
        <source>LV end-diastolic</source>
        <translation>VI telediastólico</translation>
    </message>
    <message>
        <source>LV end-diastolic pressure</source>
        <translation>Presión telediastólica del VI</translation>
    </message>
    <message>
        <source>LV end-systolic</source>
        <translation>VI telesistólico</translation>
    </message>
    <message>
        <source>LV endocardium</source>
        <translation>Endocardio del VI</translation>
    </message>
    <message>
        <source>LV stroke work</source>
        <translation>Trabajo sistólico del VI</translation>
    </message>
    <message>
        <source>Lagrange minimisation</source>
        <translation>Minimización de Lagrange</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Estiramiento máximo</translation>
    </message>
    <message>
        <source>Lateral border</source>
        <translation>Borde lateral</translation>
    </message>
    <message>
        <source>Left anterior descending artery</source>
        <translation>Arteria descendente anterior</translation>
    </message>
    <message>
        <source>Left atrium</source>
        <translation>Aurícula izquierda</translation>
    </message>
    <message>
        <source>Left atrium, contractility</source>
        <translation>Aurícula izquierda, contractilidad</translation>
    </message>
    <message>
        <source>Left atrium, mean</source>
        <translation>Aurícula izquierda, media</translation>
    </message>
    <message>
        <source>Left atrium, relaxation</source>
        <translation>Aurícula izquierda, relajación</translation>
    </message>
    <message>
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Aurícula izquierda, escala de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
        <translation>Aurícula izquierda, pendiente de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Left atrium, volume without pressure</source>
        <translation>Aurícula izquierda, volumen sin presión</translation>
    </message>
    <message>
        <source>Left auricle</source>
        <translation>Orejuela izquierda</translation>
    </message>
    <message>
        <source>Left colic flexure</source>
        <translation>Flexura cólica izquierda</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Riñón izquierdo</translation>
    </message>
    <message>
        <source>Vertebra</source>
        <translation>Vértebra</translation>
    </message>
    <message>
        <source>Left rib</source>
        <translation>Costilla izquierda</translation>
    </message>
    <message>
        <source>Right rib</source>
        <translation>Costilla derecha</translation>
    </message>
    <message>
        <source>Upper lobe of the left lung</source>
        <translation>Lóbulo superior del pulmón izquierdo</translation>
    </message>
    <message>
        <source>Lower lobe of the left lung</source>
        <translation>Lóbulo inferior del pulmón izquierdo</translation>
    </message>
    <message>
        <source>Upper lobe of the right lung</source>
        <translation>Lóbulo superior del pulmón derecho</translation>
    </message>
    <message>
        <source>Middle lobe of the right lung</source>
        <translation>Lóbulo medio del pulmón derecho</translation>
    </message>
    <message>
        <source>Lower lobe of the right lung</source>
        <translation>Lóbulo inferior del pulmón derecho</translation>
    </message>
    <message>
        <source>Left deep back muscles</source>
        <translation>Músculos profundos de la espalda izquierdos</translation>
    </message>
    <message>
        <source>Right deep back muscles</source>
        <translation>Músculos profundos de la espalda derechos</translation>
    </message>
    <message>
        <source>Left iliopsoas muscle</source>
        <translation>Músculo iliopsoas izquierdo</translation>
    </message>
    <message>
        <source>Right iliopsoas muscle</source>
        <translation>Músculo iliopsoas derecho</translation>
    </message>
    <message>
        <source>Left lobe</source>
        <translation>Lóbulo izquierdo</translation>
    </message>
    <message>
        <source>Left pulmonary artery</source>
        <translation>Arteria pulmonar izquierda</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Left ventricle, relaxation</source>
        <translation>Ventrículo izquierdo, relajación</translation>
    </message>
    <message>
        <source>Left ventricle, scale of the passive filling curve</source>
        <translation>Ventrículo izquierdo, escala de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Left ventricle, volume without pressure</source>
        <translation>Ventrículo izquierdo, volumen sin presión</translation>
    </message>
    <message>
        <source>Left ventricular</source>
        <translation>Ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Lesser curvature</source>
        <translation>Curvatura menor</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Localised S-Celestial</source>
        <translation>S-Celestial localizado</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Lock volume</source>
        <translation>Bloquear volumen</translation>
    </message>
    <message numerus="yes">
        <source>Lock {handle|%n handles}</source>
        <translation>
            <numerusform>Bloquear tirador</numerusform>
            <numerusform>Bloquear %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Lower pole</source>
        <translation>Polo inferior</translation>
    </message>
    <message>
        <source>Lymphatic system</source>
        <translation>Sistema linfático</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Maximum of %1 mm</source>
        <translation>Máximo de %1 mm</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Mean of %1 mm</source>
        <translation>Media de %1 mm</translation>
    </message>
    <message>
        <source>Mean value</source>
        <translation>Valor medio</translation>
    </message>
    <message>
        <source>Mean value of a cage with flat polygons, whose diagonals play no part</source>
        <translation>Valor medio de una jaula con polígonos planos, cuyas diagonales no intervienen</translation>
    </message>
    <message>
        <source>Mean value of what can be seen of a cage, by rays; positive in any cage</source>
        <translation>Valor medio de lo que se ve de una jaula, por rayos; positivo en cualquier jaula</translation>
    </message>
    <message>
        <source>Mean value on the hull, inner handles added one by one; they may make some negative</source>
        <translation>Valor medio en la envolvente, añadiendo uno a uno los tiradores interiores; algunos pueden volverse negativos</translation>
    </message>
    <message>
        <source>Mean value over all tetrahedra of the handles at once, by directions; positive, with many maxima</source>
        <translation>Valor medio sobre todos los tetraedros de los tiradores a la vez, por direcciones; positivo, con muchos máximos</translation>
    </message>
    <message>
        <source>Mean value over the Delaunay triangles of the handles as each point sees them; jumps where triangles flip, which blending reduces</source>
        <translation>Valor medio sobre los triángulos de Delaunay de los tiradores vistos desde cada punto; salta donde los triángulos cambian, lo que la mezcla reduce</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Valor medio sobre las regiones de Voronoi de los tiradores vistas desde cada punto; salta, o lento</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Medir: %1</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medida</translation>
    </message>
    <message>
        <source>Middle of the body</source>
        <translation>Centro del cuerpo gástrico</translation>
    </message>
    <message>
        <source>Mitral regurgitation</source>
        <translation>Insuficiencia mitral</translation>
    </message>
    <message>
        <source>Mitral valve</source>
        <translation>Válvula mitral</translation>
    </message>
    <message>
        <source>Mitral valve, leak</source>
        <translation>Válvula mitral, fuga</translation>
    </message>
    <message>
        <source>Mitral valve, open</source>
        <translation>Válvula mitral, abierta</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Mover fotograma clave</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Mover punto medido</translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles}</source>
        <translation>
            <numerusform>Mover tirador</numerusform>
            <numerusform>Mover %n tiradores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles} at rest</source>
        <translation>
            <numerusform>Mover tirador en reposo</numerusform>
            <numerusform>Mover %n tiradores en reposo</numerusform>
        </translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Músculos</translation>
    </message>
    <message>
        <source>Narrow small arteries and stiff large ones, against which a stronger, stiffer, thicker ventricle works.</source>
        <translation>Arterias pequeñas estrechas y grandes rígidas, contra las que trabaja un ventrículo más fuerte, rígido y grueso.</translation>
    </message>
    <message>
        <source>Natural neighbours</source>
        <translation>Vecinos naturales</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Cuello</translation>
    </message>
    <message>
        <source>Nervous system</source>
        <translation>Sistema nervioso</translation>
    </message>
    <message>
        <source>No cavity is a ventricle by its name</source>
        <translation>Ninguna cavidad es un ventrículo por su nombre</translation>
    </message>
    <message>
        <source>No surface is chosen</source>
        <translation>No hay ninguna superficie elegida</translation>
    </message>
    <message>
        <source>No voxel has a label in %1</source>
        <translation>Ningún vóxel tiene etiqueta en la %1</translation>
    </message>
    <message>
        <source>The key sequence has no key</source>
        <translation>La secuencia no tiene ningún fotograma clave</translation>
    </message>
    <message>
        <source>Numerical integration approach</source>
        <translation>Método de integración numérica</translation>
    </message>
    <message>
        <source>Oesophagus</source>
        <translation>Esófago</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Semilla de los números aleatorios</translation>
    </message>
    <message>
        <source>Only label maps have labels</source>
        <translation>Solo los mapas de etiquetas tienen etiquetas</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message numerus="yes">
        <source>Open %n {file|files}</source>
        <translation>
            <numerusform>Abrir %n archivo</numerusform>
            <numerusform>Abrir %n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Open scan %1</source>
        <translation>Abrir el estudio %1</translation>
    </message>
    <message>
        <source>Open sequence %1</source>
        <translation>Abrir la secuencia %1</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Órgano</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otros</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Páncreas</translation>
    </message>
    <message>
        <source>Tissue folded at any instant</source>
        <translation>Tejido plegado en algún instante</translation>
    </message>
    <message>
        <source>Maximum of largest stretch</source>
        <translation>Máximo del estiramiento máximo</translation>
    </message>
    <message>
        <source>Maximum rotational stress</source>
        <translation>Estrés rotacional máximo</translation>
    </message>
    <message>
        <source>Minimum of smallest stretch</source>
        <translation>Mínimo del estiramiento mínimo</translation>
    </message>
    <message>
        <source>Extreme volume ratio</source>
        <translation>Razón de volúmenes extrema</translation>
    </message>
    <message>
        <source>Points along the middle of the stomach, from the fundus down</source>
        <translation>Puntos a lo largo del centro del estómago, del fundus hacia abajo</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Vena porta</translation>
    </message>
    <message>
        <source>Positive mean value</source>
        <translation>Valor medio positivo</translation>
    </message>
    <message>
        <source>Preload: stressed blood volume</source>
        <translation>Precarga: volumen sanguíneo estresado</translation>
    </message>
    <message>
        <source>Pressure (mmHg)</source>
        <translation>Presión (mmHg)</translation>
    </message>
    <message>
        <source>Pulmonary arteries, compliance</source>
        <translation>Arterias pulmonares, distensibilidad</translation>
    </message>
    <message>
        <source>Pulmonary artery</source>
        <translation>Arteria pulmonar</translation>
    </message>
    <message>
        <source>Pulmonary artery, characteristic impedance</source>
        <translation>Arteria pulmonar, impedancia característica</translation>
    </message>
    <message>
        <source>Pulmonary artery, mean</source>
        <translation>Arteria pulmonar, media</translation>
    </message>
    <message>
        <source>Pulmonary artery, systolic</source>
        <translation>Arteria pulmonar, sistólica</translation>
    </message>
    <message>
        <source>Pulmonary trunk</source>
        <translation>Tronco pulmonar</translation>
    </message>
    <message>
        <source>Pulmonary valve, leak</source>
        <translation>Válvula pulmonar, fuga</translation>
    </message>
    <message>
        <source>Pulmonary valve, open</source>
        <translation>Válvula pulmonar, abierta</translation>
    </message>
    <message>
        <source>Pulmonary vein</source>
        <translation>Vena pulmonar</translation>
    </message>
    <message>
        <source>Pulmonary veins, compliance</source>
        <translation>Venas pulmonares, distensibilidad</translation>
    </message>
    <message>
        <source>Pulmonary veins, resistance</source>
        <translation>Venas pulmonares, resistencia</translation>
    </message>
    <message>
        <source>Pylorus</source>
        <translation>Píloro</translation>
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
        <translation>Fracción de eyección del VD</translation>
    </message>
    <message>
        <source>RV end-diastolic</source>
        <translation>VD telediastólico</translation>
    </message>
    <message>
        <source>RV end-systolic</source>
        <translation>VD telesistólico</translation>
    </message>
    <message>
        <source>RV free wall</source>
        <translation>Pared libre del VD</translation>
    </message>
    <message>
        <source>RV stroke work</source>
        <translation>Trabajo sistólico del VD</translation>
    </message>
    <message>
        <source>Rational coordinates of a convex cage; positive and smooth inside</source>
        <translation>Coordenadas racionales de una jaula convexa; positivas y suaves en el interior</translation>
    </message>
    <message>
        <source>Record key</source>
        <translation>Grabar fotograma clave</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Grabada</translation>
    </message>
    <message>
        <source>Rectum</source>
        <translation>Recto</translation>
    </message>
    <message>
        <source>Remove all measurements</source>
        <translation>Quitar todas las mediciones</translation>
    </message>
    <message>
        <source>Remove all organs</source>
        <translation>Quitar todos los órganos</translation>
    </message>
    <message>
        <source>Take out of group</source>
        <translation>Sacar del grupo</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Quitar grupo</translation>
    </message>
    <message numerus="yes">
        <source>Remove {handle|%n handles}</source>
        <translation>
            <numerusform>Quitar tirador</numerusform>
            <numerusform>Quitar %n tiradores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {key|%n keys}</source>
        <translation>
            <numerusform>Quitar el fotograma clave</numerusform>
            <numerusform>Quitar %n fotogramas clave</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Quitar la medición</numerusform>
            <numerusform>Quitar %n mediciones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {organ|%n organs}</source>
        <translation>
            <numerusform>Quitar el órgano</numerusform>
            <numerusform>Quitar %n órganos</numerusform>
        </translation>
    </message>
    <message>
        <source>Renal artery</source>
        <translation>Arteria renal</translation>
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
        <translation>Renombrar grupo</translation>
    </message>
    <message>
        <source>Rename handle</source>
        <translation>Renombrar tirador</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>Renombrar medición</translation>
    </message>
    <message>
        <source>Rename organ</source>
        <translation>Renombrar órgano</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>Reparación de %1</translation>
    </message>
    <message>
        <source>Replace handles</source>
        <translation>Sustituir los tiradores</translation>
    </message>
    <message>
        <source>Replace pose of key</source>
        <translation>Sustituir pose de fotograma clave</translation>
    </message>
    <message>
        <source>Replace key sequence</source>
        <translation>Sustituir secuencia de fotogramas clave</translation>
    </message>
    <message>
        <source>Reproductive system</source>
        <translation>Sistema reproductor</translation>
    </message>
    <message>
        <source>Reset pose</source>
        <translation>Restablecer pose</translation>
    </message>
    <message>
        <source>Respiratory system</source>
        <translation>Sistema respiratorio</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Reposo</translation>
    </message>
    <message>
        <source>Right atrium</source>
        <translation>Aurícula derecha</translation>
    </message>
    <message>
        <source>Right atrium, contractility</source>
        <translation>Aurícula derecha, contractilidad</translation>
    </message>
    <message>
        <source>Right atrium, mean</source>
        <translation>Aurícula derecha, media</translation>
    </message>
    <message>
        <source>Right atrium, relaxation</source>
        <translation>Aurícula derecha, relajación</translation>
    </message>
    <message>
        <source>Right atrium, scale of the passive filling curve</source>
        <translation>Aurícula derecha, escala de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
        <translation>Aurícula derecha, pendiente de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Right atrium, volume without pressure</source>
        <translation>Aurícula derecha, volumen sin presión</translation>
    </message>
    <message>
        <source>Right colic flexure</source>
        <translation>Flexura cólica derecha</translation>
    </message>
    <message>
        <source>Right coronary artery</source>
        <translation>Arteria coronaria derecha</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Riñón derecho</translation>
    </message>
    <message>
        <source>Right lobe</source>
        <translation>Lóbulo derecho</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Ventrículo derecho</translation>
    </message>
    <message>
        <source>Right ventricle, relaxation</source>
        <translation>Ventrículo derecho, relajación</translation>
    </message>
    <message>
        <source>Right ventricle, scale of the passive filling curve</source>
        <translation>Ventrículo derecho, escala de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
        <translation>Ventrículo derecho, pendiente de la curva de llenado pasivo</translation>
    </message>
    <message>
        <source>Right ventricle, volume without pressure</source>
        <translation>Ventrículo derecho, volumen sin presión</translation>
    </message>
    <message>
        <source>Right ventricular</source>
        <translation>Ventrículo derecho</translation>
    </message>
    <message>
        <source>Rotational stress</source>
        <translation>Estrés rotacional</translation>
    </message>
    <message>
        <source>S-Celestial</source>
        <translation>S-Celestial</translation>
    </message>
    <message>
        <source>Number of samples for each point</source>
        <translation>Número de muestras para cada punto</translation>
    </message>
    <message>
        <source>Septum</source>
        <translation>Tabique</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Ajustar %1</translation>
    </message>
    <message>
        <source>Set pose</source>
        <translation>Fijar la pose</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message numerus="yes">
        <source>Show {handle|%n handles}</source>
        <translation>
            <numerusform>Mostrar tirador</numerusform>
            <numerusform>Mostrar %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Sibson's coordinates: what a point takes from its neighbours' Voronoi cells; positive and local</source>
        <translation>Coordenadas de Sibson: lo que un punto toma de las celdas de Voronoi de sus vecinos; positivas y locales</translation>
    </message>
    <message>
        <source>Sigmoid colon</source>
        <translation>Colon sigmoide</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Piel y grasa</translation>
    </message>
    <message>
        <source>Slice %1 (%2) is shifted sideways against those below it</source>
        <translation>El corte %1 (%2) está desplazado lateralmente respecto a los inferiores</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Intestino delgado</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Estiramiento mínimo</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; maximum entropy over directions</source>
        <translation>Suaves y positivas, solo con puntos; máxima entropía sobre direcciones</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; the thesis's choice for organs</source>
        <translation>Suaves y positivas, solo con puntos; la elección de la tesis para órganos</translation>
    </message>
    <message>
        <source>Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes</source>
        <translation>Soluciones de la ecuación de Laplace en una jaula de cualquier forma; locales y sin lóbulos negativos</translation>
    </message>
    <message>
        <source>Some of its values need more than 32 bits as a whole number; they are kept as fractions of seven digits</source>
        <translation>Algunos de sus valores necesitan más de 32 bits como número entero; se conservan como decimales de siete cifras</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Spherical mean value</source>
        <translation>Valor medio esférico</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Bazo</translation>
    </message>
    <message>
        <source>Stiffness of the left ventricle</source>
        <translation>Rigidez del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estómago</translation>
    </message>
    <message>
        <source>Stomach and bowel</source>
        <translation>Estómago e intestino</translation>
    </message>
    <message numerus="yes">
        <source>Stop compensating with {handle|%n handles}</source>
        <translation>
            <numerusform>No compensar más con este tirador</numerusform>
            <numerusform>No compensar más con %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Stress at the witness points</source>
        <translation>Estrés en los puntos testigo</translation>
    </message>
    <message>
        <source>Stroke volume</source>
        <translation>Volumen sistólico</translation>
    </message>
    <message>
        <source>Superior vena cava</source>
        <translation>Vena cava superior</translation>
    </message>
    <message>
        <source>System used inside each region</source>
        <translation>Sistema usado dentro de cada región</translation>
    </message>
    <message>
        <source>Systemic arteries, compliance</source>
        <translation>Arterias sistémicas, distensibilidad</translation>
    </message>
    <message>
        <source>Systemic veins, compliance</source>
        <translation>Venas sistémicas, distensibilidad</translation>
    </message>
    <message>
        <source>Systemic veins, resistance</source>
        <translation>Venas sistémicas, resistencia</translation>
    </message>
    <message>
        <source>T-Celestial</source>
        <translation>T-Celestial</translation>
    </message>
    <message>
        <source>Tachygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Taquigastria: las personas sanas tienen de 2 a 4 ondas por minuto.</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Cola</translation>
    </message>
    <message>
        <source>Take handles of %1</source>
        <translation>Usar los tiradores de %1</translation>
    </message>
    <message>
        <source>Take the cage %1</source>
        <translation>Usar la jaula %1</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Taponamiento</translation>
    </message>
    <message>
        <source>TetGen cannot fill this surface (%1)</source>
        <translation>TetGen no puede llenar esta superficie (%1)</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen no colocó ningún punto dentro de la superficie</translation>
    </message>
    <message>
        <source>TetGen wanted more than %1 MB of memory</source>
        <translation>TetGen necesitó más de %1 MB de memoria</translation>
    </message>
    <message>
        <source>TetGen was not done after %1 s</source>
        <translation>TetGen no había terminado tras %1 s</translation>
    </message>
    <message>
        <source>TetGen's program %1 cannot be started: %2</source>
        <translation>no se puede iniciar el programa %1 de TetGen: %2</translation>
    </message>
    <message>
        <source>TetGen&apos;s result does not fill this surface: %1</source>
        <translation>el resultado de TetGen no llena esta superficie: %1</translation>
    </message>
    <message>
        <source>Textbook heartbeat</source>
        <translation>Latido de manual</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle is far higher than that of the aorta.</source>
        <translation>La válvula aórtica se abre hasta 0,8 cm2: la presión del ventrículo hipertrofiado supera con mucho la de la aorta.</translation>
    </message>
    <message>
        <source>The cavity %1 is not inside the outer surface %2: %3 % of it lie outside</source>
        <translation>La cavidad %1 no está dentro de la superficie exterior %2: el %3 % queda fuera</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Las coordenadas clásicas de una jaula cerrada; positivas donde la jaula es convexa</translation>
    </message>
    <message>
        <source>The files' names are not in the order of the slices; they were put in order by position</source>
        <translation>Los nombres de los archivos no siguen el orden de los cortes; se ordenaron por posición</translation>
    </message>
    <message>
        <source>The grid of %1 is another one than that of the first phase</source>
        <translation>La cuadrícula de la %1 no es la de la primera fase</translation>
    </message>
    <message>
        <source>The label &quot;%1&quot; is missing in %2</source>
        <translation>Falta la etiqueta «%1» en la %2</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>El mapa de etiquetas de %1 tiene otra cuadrícula (%2) que el estudio (%3); cada uno está donde dice su archivo, y nada se remuestrea</translation>
    </message>
    <message>
        <source>The last phase does not lead back to the first: they lie %1 mm apart on average, neighbours %2 mm at most</source>
        <translation>La última fase no vuelve a la primera: distan %1 mm de media, las vecinas %2 mm como máximo</translation>
    </message>
    <message>
        <source>The mean over all tetrahedra of handles around a point; jumps where their number changes</source>
        <translation>La media sobre todos los tetraedros de tiradores en torno a un punto; salta donde cambia su número</translation>
    </message>
    <message>
        <source>The mean over the hull and partitions of it by the inner handles; kinks at their faces</source>
        <translation>La media sobre la envolvente y sus particiones por los tiradores interiores; dobleces en sus caras</translation>
    </message>
    <message>
        <source>The middle of the mitral valve, inside the heart</source>
        <translation>El centro de la válvula mitral, dentro del corazón</translation>
    </message>
    <message>
        <source>The mitral valve leaks through 0.45 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>La válvula mitral pierde por 0,45 cm2: la mitad de lo que expulsa el ventrículo vuelve a la aurícula.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>El número de puntos testigo debe estar entre %1 y %2</translation>
    </message>
    <message>
        <source>Target weights</source>
        <translation>Pesos objetivo</translation>
    </message>
    <message>
        <source>The organ that this cavity is in is not there any more</source>
        <translation>El órgano en que está esta cavidad ya no existe</translation>
    </message>
    <message>
        <source>The outlet of the stomach</source>
        <translation>La salida del estómago</translation>
    </message>
    <message>
        <source>The period is not a positive time</source>
        <translation>El período no es un tiempo positivo</translation>
    </message>
    <message>
        <source>The points of n-space that the wire connects</source>
        <translation>Los puntos del espacio n que une el hilo</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>La pose tiene una posición que no es un número finito o está demasiado lejos</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie</source>
        <translation>El programa ffmpeg no pudo escribir la película</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie: %1</source>
        <translation>El programa ffmpeg no pudo escribir la película: %1</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>La secuencia mueve %1 tiradores, pero hay %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>La secuencia se hizo para otra posición de un tirador</translation>
    </message>
    <message numerus="yes">
        <source>The series has images of several sizes: %n {image|images} of %2 left out, those of %3 read</source>
        <translation>
            <numerusform>La serie tiene imágenes de varios tamaños: se omite %n imagen de %2 y se leen las de %3</numerusform>
            <numerusform>La serie tiene imágenes de varios tamaños: se omiten %n imágenes de %2 y se leen las de %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The series has pixels of several sizes: %n {image|images} of %2 mm left out, those of %3 mm read</source>
        <translation>
            <numerusform>La serie tiene píxeles de varios tamaños: se omite %n imagen de %2 mm y se leen las de %3 mm</numerusform>
            <numerusform>La serie tiene píxeles de varios tamaños: se omiten %n imágenes de %2 mm y se leen las de %3 mm</numerusform>
        </translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the way they are stacked (a tilted gantry); the shear is kept</source>
        <translation>Los cortes están inclinados %1 grados respecto a su apilado (gantry inclinado); se conserva la cizalla</translation>
    </message>
    <message>
        <source>Maximises the smallest weight; positive, with kinks</source>
        <translation>Maximiza el peso menor; positivas, con dobleces</translation>
    </message>
    <message>
        <source>The spacing is uneven between slice %1 (%2) and the next, which are %3 mm apart in place of %4 mm (%5 %)</source>
        <translation>La separación es desigual entre el corte %1 (%2) y el siguiente, que distan %3 mm en lugar de %4 mm (%5 %)</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>La superficie no tiene ningún triángulo</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled. %1. Details smaller than %2 mm are lost.</source>
        <translation>La superficie se reparó antes de llenarla. %1. Se pierden los detalles menores de %2 mm.</translation>
    </message>
    <message>
        <source>The thesis's radius; it cancels in the coordinates and changes nothing</source>
        <translation>El radio de la tesis; se cancela en las coordenadas y no cambia nada</translation>
    </message>
    <message>
        <source>The times of the phases do not ascend within one period of %1 ms: %2 is at %3 ms</source>
        <translation>Los tiempos de las fases no aumentan dentro de un período de %1 ms: la %2 está en %3 ms</translation>
    </message>
    <message>
        <source>The tip of the heart</source>
        <translation>La punta del corazón</translation>
    </message>
    <message>
        <source>The top of the fundus</source>
        <translation>La parte más alta del fundus</translation>
    </message>
    <message>
        <source>The volume of %1 jumps from %2 to %3 ml between %4 and %5</source>
        <translation>El volumen de %1 salta de %2 a %3 ml entre la %4 y la %5</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Los puntos testigo están en una cuadrícula regular dentro de la superficie. %1.</translation>
    </message>
    <message>
        <source>There are %1 witness points; %2 do not fit this shape or the limits of time and memory.</source>
        <translation>Hay %1 puntos testigo; %2 no caben en esta forma o en los límites de tiempo y memoria.</translation>
    </message>
    <message>
        <source>There are no handles to group</source>
        <translation>No hay tiradores que agrupar</translation>
    </message>
    <message>
        <source>There are no handles whose pose could be recorded</source>
        <translation>No hay tiradores cuya pose se pueda grabar</translation>
    </message>
    <message>
        <source>There is no %1</source>
        <translation>No existe la %1</translation>
    </message>
    <message>
        <source>There is no file to open</source>
        <translation>No hay ningún archivo que abrir</translation>
    </message>
    <message>
        <source>There is no organ to enclose</source>
        <translation>No hay ningún órgano que rodear</translation>
    </message>
    <message>
        <source>There is no organ to make groups for</source>
        <translation>No hay ningún órgano para el que formar grupos</translation>
    </message>
    <message>
        <source>There is no scan to close</source>
        <translation>No hay ningún estudio que cerrar</translation>
    </message>
    <message>
        <source>There is no stress map yet</source>
        <translation>Aún no hay mapa de estrés</translation>
    </message>
    <message>
        <source>There is no such %1 any more</source>
        <translation>Ya no existe: %1</translation>
    </message>
    <message>
        <source>There is no such handle any more</source>
        <translation>Ese tirador ya no existe</translation>
    </message>
    <message>
        <source>There is no such organ any more</source>
        <translation>Ese órgano ya no existe</translation>
    </message>
    <message>
        <source>There is no surface &quot;%1&quot;</source>
        <translation>No hay ninguna superficie «%1»</translation>
    </message>
    <message>
        <source>There is no volume in it</source>
        <translation>No contiene ningún volumen</translation>
    </message>
    <message>
        <source>There is not enough memory</source>
        <translation>No hay memoria suficiente</translation>
    </message>
    <message numerus="yes">
        <source>There {is|are} %n {time|times} for %2 phases</source>
        <translation>
            <numerusform>Hay %n tiempo para %2 fases</numerusform>
            <numerusform>Hay %n tiempos para %2 fases</numerusform>
        </translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Engrosamiento</translation>
    </message>
    <message>
        <source>This file does not state its axes, but other files of the series are in RAS</source>
        <translation>Este archivo no indica sus ejes, pero otros archivos de la serie están en RAS</translation>
    </message>
    <message>
        <source>This kind of file is not supported</source>
        <translation>Este tipo de archivo no se admite</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>Tracing the displacement field</source>
        <translation>Cálculo del campo de desplazamientos</translation>
    </message>
    <message>
        <source>Transverse colon</source>
        <translation>Colon transverso</translation>
    </message>
    <message>
        <source>Tricuspid valve, leak</source>
        <translation>Válvula tricúspide, fuga</translation>
    </message>
    <message>
        <source>Tricuspid valve, open</source>
        <translation>Válvula tricúspide, abierta</translation>
    </message>
    <message>
        <source>Turns the directions at random; 0 leaves the icosahedron upright</source>
        <translation>Gira las direcciones al azar; 0 deja recto el icosaedro</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsión</translation>
    </message>
    <message>
        <source>Two handle files cannot be opened at a time</source>
        <translation>No se pueden abrir dos archivos de tiradores a la vez</translation>
    </message>
    <message>
        <source>two handles are at one place</source>
        <translation>dos tiradores están en el mismo lugar</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Proceso uncinado</translation>
    </message>
    <message>
        <source>Unlock volume</source>
        <translation>Desbloquear volumen</translation>
    </message>
    <message numerus="yes">
        <source>Unlock {handle|%n handles}</source>
        <translation>
            <numerusform>Desbloquear tirador</numerusform>
            <numerusform>Desbloquear %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Upper pole</source>
        <translation>Polo superior</translation>
    </message>
    <message>
        <source>Ureter</source>
        <translation>Uréter</translation>
    </message>
    <message>
        <source>Urinary system</source>
        <translation>Sistema urinario</translation>
    </message>
    <message>
        <source>Use the hull as the cage</source>
        <translation>Usar la envolvente como jaula</translation>
    </message>
    <message>
        <source>VTK could not write the surface: %1</source>
        <translation>VTK no ha podido escribir la superficie: %1</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Venas</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Razón de volúmenes</translation>
    </message>
    <message>
        <source>Voronoi regions triangulation</source>
        <translation>Triangulación de regiones de Voronoi</translation>
    </message>
    <message>
        <source>Wachspress</source>
        <translation>Wachspress</translation>
    </message>
    <message>
        <source>Weights of least bending between 0 and 1; smooth and local, and follow translations only</source>
        <translation>Pesos de mínima flexión entre 0 y 1; suaves y locales, y solo siguen traslaciones</translation>
    </message>
    <message>
        <source>Amount added to each weight when a handle is inserted</source>
        <translation>Cantidad que se suma a cada peso al insertar un tirador</translation>
    </message>
    <message>
        <source>Treatment of negative weights</source>
        <translation>Tratamiento de los pesos negativos</translation>
    </message>
    <message>
        <source>Pieces of the hull</source>
        <translation>Piezas de la envolvente</translation>
    </message>
    <message>
        <source>Volume that the pericardium holds without pressure</source>
        <translation>Volumen que el pericardio contiene sin presión</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Cuándo termina el ascenso del número menor</translation>
    </message>
    <message>
        <source>Direction in which 'iterative' moves the target</source>
        <translation>Dirección en que «iterative» mueve el objetivo</translation>
    </message>
    <message>
        <source>Where waves arise, about a third of the way down</source>
        <translation>Donde nacen las ondas, a un tercio del recorrido aproximadamente</translation>
    </message>
    <message>
        <source>Wire approach</source>
        <translation>Método del hilo</translation>
    </message>
    <message>
        <source>Witness</source>
        <translation>Punto testigo</translation>
    </message>
    <message>
        <source>Witness points of %1</source>
        <translation>Puntos testigo de %1</translation>
    </message>
    <message>
        <source>%1 of %2 ml is not life-sized: %3</source>
        <translation>%1 de %2 ml no es de tamaño natural: %3</translation>
    </message>
    <message>
        <source>Two of its segments have the label %1, which NIfTI cannot tell apart</source>
        <translation>Dos de sus segmentos tienen la etiqueta %1, que NIfTI no puede distinguir</translation>
    </message>
    <message>
        <source>a .fcsv file is one list: the %1 groups and their colours are not kept (.mrk.json keeps them)</source>
        <translation>un archivo .fcsv es una sola lista: los %1 grupos y sus colores no se conservan (.mrk.json los conserva)</translation>
    </message>
    <message>
        <source>a 3D Slicer fiducial table</source>
        <translation>una tabla de fiduciales de 3D Slicer</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>un archivo JSON</translation>
    </message>
    <message>
        <source>a VTK XML file that holds no surface</source>
        <translation>un archivo VTK XML sin superficie</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>un archivo ZIP</translation>
    </message>
    <message>
        <source>a buffer is at %1, but only files beside it are read</source>
        <translation>un búfer está en %1, pero solo se leen archivos situados al lado</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>una jaula es una superficie tosca: elija una de %1 vértices como máximo</translation>
    </message>
    <message>
        <source>a gallbladder</source>
        <translation>una vesícula biliar</translation>
    </message>
    <message>
        <source>a gzip-compressed file</source>
        <translation>un archivo comprimido con gzip</translation>
    </message>
    <message>
        <source>a heart</source>
        <translation>un corazón</translation>
    </message>
    <message>
        <source>a kidney</source>
        <translation>un riñón</translation>
    </message>
    <message>
        <source>a liver</source>
        <translation>un hígado</translation>
    </message>
    <message>
        <source>a locked volume must be positive</source>
        <translation>un volumen bloqueado debe ser positivo</translation>
    </message>
    <message>
        <source>a myocardium</source>
        <translation>un miocardio</translation>
    </message>
    <message>
        <source>a pancreas</source>
        <translation>un páncreas</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>una imagen</translation>
    </message>
    <message>
        <source>a point of the centreline lies %1 outside the organ</source>
        <translation>un punto de la línea central está %1 fuera del órgano</translation>
    </message>
    <message>
        <source>a scan</source>
        <translation>un estudio</translation>
    </message>
    <message>
        <source>a spleen</source>
        <translation>un bazo</translation>
    </message>
    <message>
        <source>a stomach</source>
        <translation>un estómago</translation>
    </message>
    <message>
        <source>a surface</source>
        <translation>una superficie</translation>
    </message>
    <message>
        <source>a surface of %1 vertices and %2 triangles is too small for handles</source>
        <translation>una superficie de %1 vértices y %2 triángulos es demasiado pequeña para tiradores</translation>
    </message>
    <message>
        <source>add a group that encloses them, or put handles around them into a group</source>
        <translation>añada un grupo que los encierre, o ponga en un grupo tiradores que los rodeen</translation>
    </message>
    <message>
        <source>add a handle off that plane</source>
        <translation>añada un tirador fuera de ese plano</translation>
    </message>
    <message>
        <source>add handles to it</source>
        <translation>añádale tiradores</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>añada tiradores, o colóquelos automáticamente</translation>
    </message>
    <message>
        <source>add its file, or remove those of the other surfaces in that phase</source>
        <translation>añada su archivo, o quite los de las otras superficies de esa fase</translation>
    </message>
    <message>
        <source>add the enclosing handles, or move handles outward until they surround the organ</source>
        <translation>añada los tiradores envolventes, o mueva tiradores hacia fuera hasta que rodeen el órgano</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>añadido por la agrupación automática</translation>
    </message>
    <message>
        <source>all handles</source>
        <translation>todos los tiradores</translation>
    </message>
    <message>
        <source>all handles lie in one plane</source>
        <translation>todos los tiradores están en un plano</translation>
    </message>
    <message>
        <source>all handles lie on one line</source>
        <translation>todos los tiradores están en una recta</translation>
    </message>
    <message>
        <source>all its handles lie in one plane, so its region is flat</source>
        <translation>todos sus tiradores están en un plano, así que su región es plana</translation>
    </message>
    <message>
        <source>all of it is a cavity</source>
        <translation>todo es cavidad</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>todos los puntos están en un plano</translation>
    </message>
    <message>
        <source>an error without a message</source>
        <translation>un error sin mensaje</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>antrum</source>
        <translation>antro</translation>
    </message>
    <message>
        <source>as in --period-ms 829</source>
        <translation>como en --period-ms 829</translation>
    </message>
    <message>
        <source>ask for a volume nearer to that at rest, or let more handles compensate</source>
        <translation>pida un volumen más cercano al de reposo, o deje que compensen más tiradores</translation>
    </message>
    <message>
        <source>ask for at least %1</source>
        <translation>pida al menos %1</translation>
    </message>
    <message>
        <source>ask for fewer groups</source>
        <translation>pida menos grupos</translation>
    </message>
    <message>
        <source>ask for fewer witness points</source>
        <translation>pida menos puntos testigo</translation>
    </message>
    <message>
        <source>ask for fewer, or put them nearer to the surface</source>
        <translation>pida menos, o póngalos más cerca de la superficie</translation>
    </message>
    <message>
        <source>at least %1 are needed</source>
        <translation>se necesitan al menos %1</translation>
    </message>
    <message>
        <source>atrial systole</source>
        <translation>sístole auricular</translation>
    </message>
    <message>
        <source>bind it first</source>
        <translation>vincúlelo primero</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
    <message>
        <source>bounded biharmonic weights</source>
        <translation>pesos biarmónicos acotados</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's left, but it lies on the right (x = %1 mm): %2</source>
        <translation>por su nombre va a la izquierda del paciente, pero está a la derecha (x = %1 mm): %2</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's right, but it lies on the left (x = %1 mm): %2</source>
        <translation>por su nombre va a la derecha del paciente, pero está a la izquierda (x = %1 mm): %2</translation>
    </message>
    <message>
        <source>call the left ventricle's cavity LV and the right one's RV</source>
        <translation>llame LV a la cavidad del ventrículo izquierdo y RV a la del derecho</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>no se puede abrir: %1</translation>
    </message>
    <message>
        <source>cannot place %1 witness points</source>
        <translation>no se pueden colocar %1 puntos testigo</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>gasto cardíaco</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>check its ending</source>
        <translation>compruebe su extensión</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>compruebe sus permisos</translation>
    </message>
    <message>
        <source>check its scale and its number format</source>
        <translation>compruebe su escala y su formato de números</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>compruebe su unidad; las coordenadas están en mm</translation>
    </message>
    <message>
        <source>check that its surface is closed and outward</source>
        <translation>compruebe que su superficie está cerrada y orientada hacia fuera</translation>
    </message>
    <message>
        <source>check that its triangles face outward and that its holes are small</source>
        <translation>compruebe que sus triángulos miran hacia fuera y que sus agujeros son pequeños</translation>
    </message>
    <message>
        <source>check that the segmentation was saved</source>
        <translation>compruebe que la segmentación se guardó</translation>
    </message>
    <message>
        <source>check that there is room on the disk</source>
        <translation>compruebe que hay espacio en el disco</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>compruebe que tiene permiso de lectura</translation>
    </message>
    <message>
        <source>check the disk or the connection</source>
        <translation>compruebe el disco o la conexión</translation>
    </message>
    <message>
        <source>check the name and the folder</source>
        <translation>compruebe el nombre y la carpeta</translation>
    </message>
    <message>
        <source>check the space left on the disk</source>
        <translation>compruebe el espacio libre en el disco</translation>
    </message>
    <message>
        <source>check their order, and the period</source>
        <translation>compruebe su orden y el período</translation>
    </message>
    <message>
        <source>check this phase, or leave it out</source>
        <translation>compruebe esta fase, u omítala</translation>
    </message>
    <message>
        <source>check what the file is and where it came from</source>
        <translation>compruebe qué es el archivo y de dónde viene</translation>
    </message>
    <message>
        <source>check whether one of them is mislabelled, or leave it out</source>
        <translation>compruebe si una de ellas está mal etiquetada, u omítala</translation>
    </message>
    <message>
        <source>choose %1 to %2</source>
        <translation>elija de %1 a %2</translation>
    </message>
    <message>
        <source>choose a closed surface</source>
        <translation>elija una superficie cerrada</translation>
    </message>
    <message>
        <source>choose a file that Viscera has saved as .sequence.json</source>
        <translation>elija un archivo que Viscera haya guardado como .sequence.json</translation>
    </message>
    <message>
        <source>choose a file that Viscera has saved as .viscera</source>
        <translation>elija un archivo que Viscera haya guardado como .viscera</translation>
    </message>
    <message>
        <source>choose a file with a triangle surface</source>
        <translation>elija un archivo con una superficie de triángulos</translation>
    </message>
    <message>
        <source>choose a folder that exists, may be written to and has room</source>
        <translation>elija una carpeta que exista, en la que se pueda escribir y que tenga espacio</translation>
    </message>
    <message>
        <source>choose a surface that has some</source>
        <translation>elija una superficie que los tenga</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>elija otro</translation>
    </message>
    <message>
        <source>choose at least one</source>
        <translation>elija al menos una</translation>
    </message>
    <message>
        <source>choose it again in Play mode</source>
        <translation>elíjalo de nuevo en el modo Reproducir</translation>
    </message>
    <message>
        <source>choose it on the organ; check the axes (RAS or LPS) too</source>
        <translation>elíjalo sobre el órgano; compruebe también los ejes (RAS o LPS)</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>elija uno de ellos</translation>
    </message>
    <message>
        <source>choose the two ends of the organ</source>
        <translation>elija los dos extremos del órgano</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>elija dos extremos de una superficie</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>cierre primero sus agujeros</translation>
    </message>
    <message>
        <source>close its holes, as viscera convert IN OUT --fill-holes does; an open surface has no volume to keep</source>
        <translation>cierre sus agujeros, por ejemplo con viscera convert ENTRADA SALIDA --fill-holes; una superficie abierta no tiene volumen que conservar</translation>
    </message>
    <message>
        <source>close other programs, or use fewer handles or smaller organs</source>
        <translation>cierre otros programas, o use menos tiradores u órganos más pequeños</translation>
    </message>
    <message>
        <source>compensating handles</source>
        <translation>tiradores que compensan</translation>
    </message>
    <message>
        <source>convert it to .seg.nrrd</source>
        <translation>conviértalo a .seg.nrrd</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>las coordenadas necesitan al menos cuatro tiradores, hay %1</translation>
    </message>
    <message>
        <source>copy its contents to a file first</source>
        <translation>copie primero su contenido a un archivo</translation>
    </message>
    <message>
        <source>copy the file anew, or take it out of the folder to read the others</source>
        <translation>copie el archivo de nuevo, o sáquelo de la carpeta para leer los demás</translation>
    </message>
    <message>
        <source>crop the image to the organs</source>
        <translation>recorte la imagen a los órganos</translation>
    </message>
    <message>
        <source>deeper ones would push folds of the surface into one another</source>
        <translation>unas más profundas empujarían los pliegues de la superficie unos contra otros</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>derivatives at the witness points</source>
        <translation>derivadas en los puntos testigo</translation>
    </message>
    <message>
        <source>diastasis</source>
        <translation>diástasis</translation>
    </message>
    <message>
        <source>diastole</source>
        <translation>diástole</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>does not say how large its pixels are</source>
        <translation>no indica el tamaño de sus píxeles</translation>
    </message>
    <message>
        <source>does not say where in the patient it lies</source>
        <translation>no indica dónde está en el paciente</translation>
    </message>
    <message>
        <source>does not say where its frames lie</source>
        <translation>no indica dónde están sus fotogramas</translation>
    </message>
    <message>
        <source>ejection</source>
        <translation>eyección</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>fracción de eyección</translation>
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
        <source>even so, folds of the surface meet when they pass</source>
        <translation>aun así, los pliegues de la superficie se tocan cuando pasan</translation>
    </message>
    <message>
        <source>exchanges left and right</source>
        <translation>intercambia izquierda y derecha</translation>
    </message>
    <message>
        <source>expiration</source>
        <translation>espiración</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same axes</source>
        <translation>exporte todas las superficies de un paciente con los mismos ejes</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same way (viscera convert --space LPS)</source>
        <translation>exporte todas las superficies de un paciente de la misma manera (viscera convert --space LPS)</translation>
    </message>
    <message>
        <source>export it as a surface of triangles</source>
        <translation>expórtela como superficie de triángulos</translation>
    </message>
    <message>
        <source>export it as glTF 2.0</source>
        <translation>expórtelo como glTF 2.0</translation>
    </message>
    <message>
        <source>export it as pixels of 16 bits</source>
        <translation>expórtelo con píxeles de 16 bits</translation>
    </message>
    <message>
        <source>export it little-endian</source>
        <translation>expórtelo en orden little-endian</translation>
    </message>
    <message>
        <source>export it without compression</source>
        <translation>expórtelo sin compresión</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>exporte o copie el archivo de nuevo</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>exporte de nuevo la superficie</translation>
    </message>
    <message>
        <source>extract its surface first</source>
        <translation>extraiga primero su superficie</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>llenado</translation>
    </message>
    <message>
        <source>filling the handles with tetrahedra</source>
        <translation>llenado de los tiradores con tetraedros</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>llenado del órgano con tetraedros</translation>
    </message>
    <message>
        <source>fills every hole with a cap</source>
        <translation>cierra cada agujero con una tapa</translation>
    </message>
    <message>
        <source>finding landmarks</source>
        <translation>búsqueda de puntos de referencia</translation>
    </message>
    <message>
        <source>folded where it is hatched</source>
        <translation>plegado donde está rayado</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>fundus</translation>
    </message>
    <message>
        <source>fundus, centreline from the fundus down, body in between, pylorus</source>
        <translation>fundus, línea central desde el fundus hacia abajo, cuerpo en medio, píloro</translation>
    </message>
    <message>
        <source>give apex and base too</source>
        <translation>indique también apex y base</translation>
    </message>
    <message>
        <source>give both, or none to have them computed</source>
        <translation>indique ambos, o ninguno para que se calculen</translation>
    </message>
    <message>
        <source>give every handle a label of its own</source>
        <translation>dé a cada tirador una etiqueta propia</translation>
    </message>
    <message>
        <source>give fundus and pylorus too</source>
        <translation>indique también fundus y pylorus</translation>
    </message>
    <message>
        <source>give it another one</source>
        <translation>dele otro</translation>
    </message>
    <message>
        <source>give it one</source>
        <translation>dele uno</translation>
    </message>
    <message>
        <source>give its labels smaller numbers</source>
        <translation>dé números más pequeños a sus etiquetas</translation>
    </message>
    <message>
        <source>give one between 0.1 and 0.8</source>
        <translation>indique una entre 0,1 y 0,8</translation>
    </message>
    <message>
        <source>give one for each phase</source>
        <translation>indique uno para cada fase</translation>
    </message>
    <message>
        <source>give points of the centreline yourself</source>
        <translation>indique usted los puntos de la línea central</translation>
    </message>
    <message>
        <source>give the outer surface the labels of its cavities too, as in EPI=1,2,3</source>
        <translation>dé a la superficie exterior también las etiquetas de sus cavidades, como en EPI=1,2,3</translation>
    </message>
    <message>
        <source>glTF does not say which axes a patient&apos;s are: its numbers are taken as LPS millimetres, though the format&apos;s convention is metres with y up</source>
        <translation>glTF no dice cuáles son los ejes del paciente: sus números se toman como milímetros LPS, aunque el formato prevé metros con y hacia arriba</translation>
    </message>
    <message>
        <source>grid inside the surface</source>
        <translation>cuadrícula dentro de la superficie</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupo</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>grupo %1</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;</source>
        <translation>grupo «%1»</translation>
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
        <translation>tiradores %1 y %2</translation>
    </message>
    <message>
        <source>harmonic coordinates</source>
        <translation>coordenadas armónicas</translation>
    </message>
    <message numerus="yes">
        <source>has %n {column|columns}</source>
        <translation>
            <numerusform>tiene %n columna</numerusform>
            <numerusform>tiene %n columnas</numerusform>
        </translation>
    </message>
    <message>
        <source>has a heading that does not say what the instants are</source>
        <translation>tiene un encabezado que no dice qué son los instantes</translation>
    </message>
    <message>
        <source>has a volume that is not positive</source>
        <translation>tiene un volumen que no es positivo</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>no tiene píxeles</translation>
    </message>
    <message>
        <source>has pixels that are fractions (Float Pixel Data), which Viscera does not read; export it as whole numbers, or as NIfTI</source>
        <translation>tiene píxeles decimales (Float Pixel Data), que Viscera no lee; expórtelo con números enteros o como NIfTI</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>mantener</translation>
    </message>
    <message>
        <source>holds something that is not a number</source>
        <translation>contiene algo que no es un número</translation>
    </message>
    <message>
        <source>if it is not a whole cycle, say that it is to be played once (--once); else add the phases that are missing</source>
        <translation>si no es un ciclo completo, indique que se reproduzca una vez (--once); si lo es, añada las fases que faltan</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>inspiración</translation>
    </message>
    <message>
        <source>install Viscera again, or name it in VISCERA_TETGEN_WORKER</source>
        <translation>instale Viscera de nuevo, o indíquelo en VISCERA_TETGEN_WORKER</translation>
    </message>
    <message>
        <source>install ffmpeg, or write an .ogv</source>
        <translation>instale ffmpeg, o escriba un .ogv</translation>
    </message>
    <message>
        <source>is a colour image</source>
        <translation>es una imagen en color</translation>
    </message>
    <message>
        <source>is a mosaic of many slices in one image, as Siemens writes them, which Viscera does not take apart; convert it to NIfTI (dcm2niix does)</source>
        <translation>es un mosaico de muchos cortes en una imagen, como los escribe Siemens, que Viscera no separa; conviértalo a NIfTI (dcm2niix lo hace)</translation>
    </message>
    <message>
        <source>is not a file that can be read</source>
        <translation>no es un archivo que se pueda leer</translation>
    </message>
    <message>
        <source>is not later than the line before</source>
        <translation>no es posterior a la línea anterior</translation>
    </message>
    <message numerus="yes">
        <source>is not manifold at %n {edge|edges}</source>
        <translation>
            <numerusform>no es una variedad en %n arista</numerusform>
            <numerusform>no es una variedad en %n aristas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>is open at %n {edge|edges}</source>
        <translation>
            <numerusform>está abierta en %n arista</numerusform>
            <numerusform>está abierta en %n aristas</numerusform>
        </translation>
    </message>
    <message>
        <source>is too thin in places for a surface with the volume of its voxels</source>
        <translation>es en partes demasiado fino para una superficie con el volumen de sus vóxeles</translation>
    </message>
    <message>
        <source>isovolumic contraction</source>
        <translation>contracción isovolumétrica</translation>
    </message>
    <message>
        <source>isovolumic relaxation</source>
        <translation>relajación isovolumétrica</translation>
    </message>
    <message>
        <source>it does not lie within the period</source>
        <translation>no está dentro del período</translation>
    </message>
    <message>
        <source>it does not say how large its voxels are; 1 mm is assumed</source>
        <translation>no indica el tamaño de sus vóxeles; se supone 1 mm</translation>
    </message>
    <message>
        <source>it does not say where the patient's sides are; axes are taken as right, front and up</source>
        <translation>no indica dónde están los lados del paciente; los ejes se toman como derecha, delante y arriba</translation>
    </message>
    <message>
        <source>it follows no handles, so nothing can change its volume</source>
        <translation>no sigue ningún tirador, así que nada puede cambiar su volumen</translation>
    </message>
    <message>
        <source>it has %1 triangles</source>
        <translation>tiene %1 triángulos</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>no tiene nombre</translation>
    </message>
    <message>
        <source>it is not a millisecond at least behind the key before it</source>
        <translation>no está al menos un milisegundo después del fotograma clave anterior</translation>
    </message>
    <message>
        <source>it may be mirrored</source>
        <translation>puede estar reflejado</translation>
    </message>
    <message>
        <source>its axes %1 are unknown; LPS is assumed</source>
        <translation>sus ejes %1 no se conocen; se supone LPS</translation>
    </message>
    <message>
        <source>its encoding %1 is not supported</source>
        <translation>su codificación %1 no se admite</translation>
    </message>
    <message>
        <source>its file %1 is not there any more (put it beside the session and open that again)</source>
        <translation>su archivo %1 ya no está (póngalo junto a la sesión y ábrala de nuevo)</translation>
    </message>
    <message>
        <source>its file was found as %1</source>
        <translation>su archivo se encontró como %1</translation>
    </message>
    <message>
        <source>its frames lie in different directions</source>
        <translation>sus fotogramas están en direcciones distintas</translation>
    </message>
    <message>
        <source>its labels are those of a heart: muscle and chambers are its outer surface, each chamber is a cavity</source>
        <translation>sus etiquetas son las de un corazón: el músculo y las cavidades cardíacas forman su superficie exterior, cada una de estas es una cavidad</translation>
    </message>
    <message>
        <source>its pixels of %1 bits in %2, up to bit %3, are not supported</source>
        <translation>sus píxeles de %1 bits en %2, hasta el bit %3, no se admiten</translation>
    </message>
    <message>
        <source>its sform and qform place the image differently; the sform is used</source>
        <translation>su sform y su qform colocan la imagen de forma distinta; se usa sform</translation>
    </message>
    <message>
        <source>its sform is singular or not finite and is not used</source>
        <translation>su sform es singular o no es finita y no se usa</translation>
    </message>
    <message>
        <source>its slices are not equally far from each other (frame %1)</source>
        <translation>sus cortes no están a la misma distancia unos de otros (fotograma %1)</translation>
    </message>
    <message>
        <source>its surface has changed: measured points were moved to the nearest places on the new surface</source>
        <translation>su superficie ha cambiado: los puntos medidos se han movido a los lugares más próximos de la nueva superficie</translation>
    </message>
    <message>
        <source>its surface is open, so it has no volume that could be locked</source>
        <translation>su superficie está abierta, así que no tiene volumen que bloquear</translation>
    </message>
    <message numerus="yes">
        <source>its surface was closed by %n {cap|caps}</source>
        <translation>
            <numerusform>su superficie se cerró con %n tapa</numerusform>
            <numerusform>su superficie se cerró con %n tapas</numerusform>
        </translation>
    </message>
    <message>
        <source>its triangles were turned around to face outward</source>
        <translation>sus triángulos se giraron hacia fuera</translation>
    </message>
    <message>
        <source>its two ends are at one place</source>
        <translation>sus dos extremos están en el mismo lugar</translation>
    </message>
    <message>
        <source>its two ends are on separate pieces</source>
        <translation>sus dos extremos están en fragmentos separados</translation>
    </message>
    <message>
        <source>its volume can be kept only after it is bound to the present handles</source>
        <translation>su volumen solo se puede mantener después de vincularlo a los tiradores presentes</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>su volumen ya no está bloqueado: la superficie está ahora abierta</translation>
    </message>
    <message>
        <source>its voxels lie elsewhere than those of the other masks</source>
        <translation>sus vóxeles están en otro sitio que los de las otras máscaras</translation>
    </message>
    <message>
        <source>keep the largest, as viscera convert IN OUT --keep-largest does</source>
        <translation>conserve el mayor, por ejemplo con viscera convert ENTRADA SALIDA --keep-largest</translation>
    </message>
    <message>
        <source>keeps the piece with the largest area and drops the others</source>
        <translation>conserva el fragmento de mayor área y descarta los demás</translation>
    </message>
    <message>
        <source>key</source>
        <translation>fotograma clave</translation>
    </message>
    <message>
        <source>mmHg</source>
        <translation>mmHg</translation>
    </message>
    <message>
        <source>start</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>fotograma clave %1</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>kilómetros</translation>
    </message>
    <message>
        <source>known endings: %1</source>
        <translation>extensiones conocidas: %1</translation>
    </message>
    <message>
        <source>label it in every phase, or leave this phase out</source>
        <translation>etiquételo en todas las fases, u omita esta fase</translation>
    </message>
    <message>
        <source>label the points %1</source>
        <translation>nombre los puntos %1</translation>
    </message>
    <message>
        <source>leave it out for surfaces</source>
        <translation>omítalo para superficies</translation>
    </message>
    <message>
        <source>leave the landmarks out</source>
        <translation>omita los puntos de referencia</translation>
    </message>
    <message>
        <source>leave two: the instant, and the volume in ml</source>
        <translation>deje dos: el instante y el volumen en ml</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>alargue primero el período</translation>
    </message>
    <message>
        <source>let it begin with &quot;time_s&quot; for seconds, or with &quot;fraction&quot; for parts of the cycle</source>
        <translation>que empiece por «time_s» para segundos, o por «fraction» para partes del ciclo</translation>
    </message>
    <message>
        <source>let more handles compensate, or ask for a volume nearer to the present one</source>
        <translation>deje que compensen más tiradores, o pida un volumen más cercano al actual</translation>
    </message>
    <message>
        <source>let the last volume be the first one</source>
        <translation>haga que el último volumen sea igual al primero</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineal</translation>
    </message>
    <message>
        <source>load a closed surface</source>
        <translation>cargue una superficie cerrada</translation>
    </message>
    <message>
        <source>localised coordinates</source>
        <translation>coordenadas localizadas</translation>
    </message>
    <message>
        <source>looking for folds</source>
        <translation>búsqueda de pliegues</translation>
    </message>
    <message>
        <source>make the handles from this cage: viscera handles ORGAN --cage FILE</source>
        <translation>haga los tiradores con esta jaula: viscera handles ÓRGANO --cage ARCHIVO</translation>
    </message>
    <message>
        <source>makes a closed surface without intersections near this one; colours are lost</source>
        <translation>hace una superficie cerrada sin intersecciones cerca de esta; los colores se pierden</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>medición</translation>
    </message>
    <message>
        <source>measurement %1</source>
        <translation>medición %1</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micrómetros</translation>
    </message>
    <message>
        <source>centreline</source>
        <translation>línea central</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>move it elsewhere, or remove one of the two</source>
        <translation>muévala, o quite una de las dos</translation>
    </message>
    <message>
        <source>move one out of the plane</source>
        <translation>mueva uno fuera del plano</translation>
    </message>
    <message>
        <source>move or delete one of them</source>
        <translation>mueva o elimine uno de ellos</translation>
    </message>
    <message>
        <source>move or remove one of them</source>
        <translation>mueva o quite uno de ellos</translation>
    </message>
    <message>
        <source>move some off the line</source>
        <translation>saque algunos de la recta</translation>
    </message>
    <message>
        <source>move some off the plane, or add enclosing handles</source>
        <translation>saque algunos del plano, o añada tiradores envolventes</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>separe allí los vértices, o use otra jaula</translation>
    </message>
    <message>
        <source>movies of this kind cannot be written</source>
        <translation>no se pueden escribir películas de este tipo</translation>
    </message>
    <message>
        <source>name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase</source>
        <translation>indique un NIfTI 4D, un .seq.nrrd de 3D Slicer o un archivo para cada fase</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>indique un archivo de ella</translation>
    </message>
    <message>
        <source>name a folder with one file for each phase</source>
        <translation>indique una carpeta con un archivo para cada fase</translation>
    </message>
    <message>
        <source>name a folder with one mask for each organ, such as liver.nii.gz</source>
        <translation>indique una carpeta con una máscara para cada órgano, como liver.nii.gz</translation>
    </message>
    <message>
        <source>name all phases of the cycle</source>
        <translation>indique todas las fases del ciclo</translation>
    </message>
    <message>
        <source>name all phases of the cycle; a single image of a heart with cavities can beat as the textbook's (--textbook, in the window Fit a sequence to an organ)</source>
        <translation>indique todas las fases del ciclo; una sola imagen de un corazón con cavidades puede latir como en el manual (--textbook; en la ventana, ajustar una secuencia a un órgano)</translation>
    </message>
    <message>
        <source>name compensating handles</source>
        <translation>indique tiradores que compensen</translation>
    </message>
    <message>
        <source>name instants from 0 to 1</source>
        <translation>indique instantes de 0 a 1</translation>
    </message>
    <message>
        <source>name instants from 0 to 1, or write &quot;time_s&quot; above them for seconds</source>
        <translation>indique instantes de 0 a 1, o escriba «time_s» encima para segundos</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>llámelo %1</translation>
    </message>
    <message>
        <source>name its files, a folder, or a file with several phases</source>
        <translation>indique sus archivos, una carpeta o un archivo con varias fases</translation>
    </message>
    <message>
        <source>name the folder of a CT or MR series</source>
        <translation>indique la carpeta de una serie de TC o RM</translation>
    </message>
    <message>
        <source>name the folder of one patient</source>
        <translation>indique la carpeta de un solo paciente</translation>
    </message>
    <message>
        <source>name the folder, or another file in it</source>
        <translation>indique la carpeta, u otro archivo de ella</translation>
    </message>
    <message>
        <source>names an instant outside the cycle</source>
        <translation>nombra un instante fuera del ciclo</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>nanómetros</translation>
    </message>
    <message>
        <source>no compensation within %1 mm restores the volume</source>
        <translation>ninguna compensación dentro de %1 mm restablece el volumen</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>ninguna arista une más de dos triángulos</translation>
    </message>
    <message>
        <source>no handle is left to compensate the change of volume</source>
        <translation>no queda ningún tirador que compense el cambio de volumen</translation>
    </message>
    <message>
        <source>no harmonic function can be found on the surface</source>
        <translation>no se encuentra ninguna función armónica en la superficie</translation>
    </message>
    <message>
        <source>no motion near to this one keeps the volume</source>
        <translation>ningún movimiento próximo a este mantiene el volumen</translation>
    </message>
    <message>
        <source>no witness point lies inside</source>
        <translation>ningún punto testigo está dentro</translation>
    </message>
    <message>
        <source>node %1 is moved by bones, which are ignored</source>
        <translation>el nodo %1 se mueve por huesos, que se ignoran</translation>
    </message>
    <message>
        <source>of an unknown kind</source>
        <translation>de tipo desconocido</translation>
    </message>
    <message numerus="yes">
        <source>only %n {handle|handles}</source>
        <translation>
            <numerusform>solo %n tirador</numerusform>
            <numerusform>solo %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>ábralo junto a los órganos (Archivo &gt; Abrir un estudio), o haga primero un mapa de etiquetas con 3D Slicer o TotalSegmentator</translation>
    </message>
    <message>
        <source>open it by itself, or remove it from the folder</source>
        <translation>ábralo solo, o quítelo de la carpeta</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>abra uno primero</translation>
    </message>
    <message>
        <source>open it by itself, and the other files after it</source>
        <translation>ábrala sola, y los demás archivos después</translation>
    </message>
    <message>
        <source>open it with File &gt; Open</source>
        <translation>ábrala con Archivo &gt; Abrir</translation>
    </message>
    <message>
        <source>open the segmentation that was made from it</source>
        <translation>abra la segmentación hecha a partir de él</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>órgano</translation>
    </message>
    <message>
        <source>organ %1</source>
        <translation>órgano %1</translation>
    </message>
    <message>
        <source>out</source>
        <translation>salida</translation>
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
        <translation>la fase %1 se ajusta mucho peor que sus vecinas (%2 frente a %3 mm): revise sus datos, u omítala</translation>
    </message>
    <message>
        <source>phase %1: %2</source>
        <translation>fase %1: %2</translation>
    </message>
    <message>
        <source>pick the point on the surface again</source>
        <translation>elija de nuevo el punto de la superficie</translation>
    </message>
    <message>
        <source>place handles around it</source>
        <translation>coloque tiradores a su alrededor</translation>
    </message>
    <message>
        <source>place more handles</source>
        <translation>coloque más tiradores</translation>
    </message>
    <message>
        <source>place some first</source>
        <translation>coloque algunos primero</translation>
    </message>
    <message>
        <source>place some points and save them again</source>
        <translation>coloque algunos puntos y guárdelos de nuevo</translation>
    </message>
    <message>
        <source>place the handle again</source>
        <translation>coloque el tirador de nuevo</translation>
    </message>
    <message>
        <source>placing handles</source>
        <translation>colocación de tiradores</translation>
    </message>
    <message>
        <source>play at the rate that the times are for</source>
        <translation>reproduzca a la frecuencia para la que valen los tiempos</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>lo causan puntos que coinciden o casi planos</translation>
    </message>
    <message>
        <source>put both files into one folder</source>
        <translation>ponga ambos archivos en una carpeta</translation>
    </message>
    <message>
        <source>put it into the middle of the stomach</source>
        <translation>póngalo en el centro del estómago</translation>
    </message>
    <message>
        <source>put masks of one image into a folder of their own</source>
        <translation>ponga las máscaras de una misma imagen en una carpeta propia</translation>
    </message>
    <message>
        <source>put those of one kind into a folder of their own</source>
        <translation>ponga los de un tipo en una carpeta propia</translation>
    </message>
    <message>
        <source>pylorus</source>
        <translation>píloro</translation>
    </message>
    <message>
        <source>rapid ejection</source>
        <translation>eyección rápida</translation>
    </message>
    <message>
        <source>rapid filling</source>
        <translation>llenado rápido</translation>
    </message>
    <message>
        <source>reaches the edge of the image, which may cut it off</source>
        <translation>llega al borde de la imagen, que puede recortarlo</translation>
    </message>
    <message>
        <source>add a key first</source>
        <translation>añada primero un fotograma clave</translation>
    </message>
    <message>
        <source>record and save the sequence again</source>
        <translation>grabe y guarde la secuencia de nuevo</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectángulo</translation>
    </message>
    <message>
        <source>reduce the surface first</source>
        <translation>reduzca primero la superficie</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>eyección lenta</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>quite uno de los dos</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>quite uno de ellos</translation>
    </message>
    <message>
        <source>remove one of them from the file</source>
        <translation>quite uno de ellos del archivo</translation>
    </message>
    <message>
        <source>repair the surface</source>
        <translation>repare la superficie</translation>
    </message>
    <message>
        <source>repair the surface in another program first</source>
        <translation>repare primero la superficie en otro programa</translation>
    </message>
    <message>
        <source>repaired on import: %1</source>
        <translation>reparado al importar: %1</translation>
    </message>
    <message>
        <source>repairing the surface</source>
        <translation>reparación de la superficie</translation>
    </message>
    <message>
        <source>resample all phases to one grid, in the same axes</source>
        <translation>remuestree todas las fases en una misma cuadrícula, con los mismos ejes</translation>
    </message>
    <message>
        <source>resample the images to an upright grid</source>
        <translation>remuestree las imágenes en una cuadrícula recta</translation>
    </message>
    <message>
        <source>resample the segmentation, for example by saving it as .seg.nrrd</source>
        <translation>remuestree la segmentación, por ejemplo guardándola como .seg.nrrd</translation>
    </message>
    <message>
        <source>reset the pose</source>
        <translation>restablezca la pose</translation>
    </message>
    <message>
        <source>restoring the volume would move a handle by %1 mm</source>
        <translation>restablecer el volumen movería un tirador %1 mm</translation>
    </message>
    <message>
        <source>right and left are exchanged, and so are front and back: the files seem to be in RAS</source>
        <translation>derecha e izquierda están cambiadas, y también delante y detrás: los archivos parecen estar en RAS</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>derecha e izquierda están intercambiadas, delante y detrás no: reflejado</translation>
    </message>
    <message>
        <source>right and left are exchanged: the files may be in RAS, or mirrored</source>
        <translation>derecha e izquierda están cambiadas: los archivos pueden estar en RAS o reflejados</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>guárdelo primero en un archivo propio</translation>
    </message>
    <message>
        <source>save it as a segmentation</source>
        <translation>guárdelo como segmentación</translation>
    </message>
    <message>
        <source>save it as a 3D image</source>
        <translation>guárdela como imagen 3D</translation>
    </message>
    <message>
        <source>save it with gzip or raw encoding</source>
        <translation>guárdelo con la codificación gzip o raw</translation>
    </message>
    <message>
        <source>save it with one value per voxel</source>
        <translation>guárdela con un valor por vóxel</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>guarde a menudo, o haga sitio allí</translation>
    </message>
    <message>
        <source>save the points from Slicer as .mrk.json</source>
        <translation>guarde los puntos desde Slicer como .mrk.json</translation>
    </message>
    <message>
        <source>save the points from Slicer in LPS</source>
        <translation>guarde los puntos desde Slicer en LPS</translation>
    </message>
    <message>
        <source>give it with --period-ms, or the rate with --rate</source>
        <translation>indíquela con --period-ms, o la frecuencia con --rate</translation>
    </message>
    <message>
        <source>say which surfaces they make, as in --surface LV=1 --surface RV=2 --surface EPI=1,2,3 with all labels within the outer one</source>
        <translation>indique qué superficies forman, como en --surface LV=1 --surface RV=2 --surface EPI=1,2,3, con todas las etiquetas dentro de la exterior</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suave</translation>
    </message>
    <message>
        <source>sort the lines by their instants</source>
        <translation>ordene las líneas por sus instantes</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>esfera</translation>
    </message>
    <message>
        <source>stress over the sequence</source>
        <translation>estrés a lo largo de la secuencia</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>volumen sistólico</translation>
    </message>
    <message>
        <source>surfaces at rest</source>
        <translation>superficies en reposo</translation>
    </message>
    <message>
        <source>system parameters</source>
        <translation>parámetros del sistema</translation>
    </message>
    <message>
        <source>systole</source>
        <translation>sístole</translation>
    </message>
    <message>
        <source>take a backup of the file, or begin a new session with the organs' own files</source>
        <translation>use una copia de seguridad del archivo, o empiece una sesión nueva con los archivos de los órganos</translation>
    </message>
    <message>
        <source>take a cage that surrounds the organ, or the handles' convex hull as the cage</source>
        <translation>use una jaula que rodee el órgano, o la envolvente convexa de los tiradores como jaula</translation>
    </message>
    <message>
        <source>take a closed cage, or none: then the convex hull of the handles is the cage</source>
        <translation>use una jaula cerrada o ninguna: entonces la envolvente convexa de los tiradores es la jaula</translation>
    </message>
    <message>
        <source>take a convex cage, or none: then the convex hull of the handles is the cage</source>
        <translation>use una jaula convexa o ninguna: entonces la envolvente convexa de los tiradores es la jaula</translation>
    </message>
    <message>
        <source>take a larger one</source>
        <translation>elija uno mayor</translation>
    </message>
    <message>
        <source>take another positivity</source>
        <translation>elija otra positividad</translation>
    </message>
    <message>
        <source>take the sequence's own handles</source>
        <translation>use los tiradores propios de la secuencia</translation>
    </message>
    <message>
        <source>takes the coordinates as %1</source>
        <translation>toma las coordenadas como %1</translation>
    </message>
    <message>
        <source>terminal antral contraction</source>
        <translation>contracción antral terminal</translation>
    </message>
    <message>
        <source>the Delaunay tetrahedra of %1 points cannot be computed</source>
        <translation>no se pueden calcular los tetraedros de Delaunay de %1 puntos</translation>
    </message>
    <message>
        <source>the cage</source>
        <translation>la jaula</translation>
    </message>
    <message>
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>no se puede calcular la envolvente convexa de %1 puntos</translation>
    </message>
    <message>
        <source>the coordinates are kept in single precision: they would take %1 MiB otherwise</source>
        <translation>las coordenadas se guardan en precisión simple; si no, ocuparían %1 MiB</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>el archivo no indica sus ejes: se supone LPS</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the file may be in RAS, or mirrored</source>
        <translation>el archivo puede estar en RAS o reflejado</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>el archivo indica sus ejes: %1</translation>
    </message>
    <message>
        <source>the file with its voxels, %1, cannot be read: %2</source>
        <translation>el archivo con sus vóxeles, %1, no se puede leer: %2</translation>
    </message>
    <message>
        <source>the first one is 0</source>
        <translation>la primera es 0</translation>
    </message>
    <message>
        <source>the first one is: &quot;%1&quot;</source>
        <translation>la primera es: «%1»</translation>
    </message>
    <message>
        <source>the first phase</source>
        <translation>la primera fase</translation>
    </message>
    <message>
        <source>the folder for the frames cannot be written</source>
        <translation>no se puede escribir en la carpeta de los fotogramas</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>los tiradores no encierran nada: %1</translation>
    </message>
    <message>
        <source>the handles that may compensate cannot restore the volume</source>
        <translation>los tiradores que pueden compensar no logran restablecer el volumen</translation>
    </message>
    <message>
        <source>the handles' tetrahedra</source>
        <translation>los tetraedros de los tiradores</translation>
    </message>
    <message>
        <source>the label &quot;%1&quot; is not a landmark of the sequence %2</source>
        <translation>la etiqueta «%1» no es un punto de referencia de la secuencia %2</translation>
    </message>
    <message>
        <source>the landmark &quot;%1&quot; comes twice</source>
        <translation>el punto de referencia «%1» aparece dos veces</translation>
    </message>
    <message>
        <source>the landmark lies %1 outside the organ</source>
        <translation>el punto de referencia está %1 fuera del órgano</translation>
    </message>
    <message>
        <source>the landmark's position is not a finite number</source>
        <translation>la posición del punto de referencia no es un número finito</translation>
    </message>
    <message>
        <source>the landmarks are not in order along the stomach</source>
        <translation>los puntos de referencia no están en orden a lo largo del estómago</translation>
    </message>
    <message>
        <source>the last phase equals the first and is left out: phase %1 would be phase 1 again</source>
        <translation>la última fase es igual a la primera y se omite: la fase %1 sería otra vez la fase 1</translation>
    </message>
    <message>
        <source>the locked volumes cannot be kept</source>
        <translation>los volúmenes bloqueados no se pueden conservar</translation>
    </message>
    <message>
        <source>the markup %1 of type %2 is not a list of points and was left out</source>
        <translation>la marca %1 de tipo %2 no es una lista de puntos y se omite</translation>
    </message>
    <message>
        <source>the computed centreline leaves the organ</source>
        <translation>la línea central calculada sale del órgano</translation>
    </message>
    <message>
        <source>the motion is the textbook's, fitted to one image: it is not this patient's own</source>
        <translation>el movimiento es el del manual, ajustado a una imagen: no es el propio de este paciente</translation>
    </message>
    <message>
        <source>the motion of an organ cannot be made again: nothing is known of how it was made</source>
        <translation>el movimiento de un órgano no se puede rehacer: no se sabe cómo se hizo</translation>
    </message>
    <message>
        <source>the movie cannot be written</source>
        <translation>no se puede escribir la película</translation>
    </message>
    <message>
        <source>the movie has no frame</source>
        <translation>la película no tiene ningún fotograma</translation>
    </message>
    <message>
        <source>the name of a sequence file ends in .sequence.json</source>
        <translation>el nombre de un archivo de secuencia termina en .sequence.json</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>el nombre de un archivo de sesión termina en .viscera</translation>
    </message>
    <message>
        <source>the names of its labels are those of %1</source>
        <translation>los nombres de sus etiquetas son los de %1</translation>
    </message>
    <message>
        <source>the offset of region &apos;%1&apos; is cut to %2 mm, the distance of its nearest handle from a zone</source>
        <translation>el desplazamiento de la región «%1» se recorta a %2 mm, la distancia de su tirador más próximo a una zona</translation>
    </message>
    <message>
        <source>the organ is %1 times as long as that of an adult; check its unit</source>
        <translation>el órgano es %1 veces tan largo como el de un adulto; compruebe su unidad</translation>
    </message>
    <message>
        <source>the organ is in %1 pieces</source>
        <translation>el órgano está en %1 fragmentos</translation>
    </message>
    <message>
        <source>the organ is inside out or flat</source>
        <translation>el órgano está vuelto del revés o es plano</translation>
    </message>
    <message numerus="yes">
        <source>the organ is open: %n boundary {edge|edges}</source>
        <translation>
            <numerusform>el órgano está abierto: %n arista de borde</numerusform>
            <numerusform>el órgano está abierto: %n aristas de borde</numerusform>
        </translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>no se puede escribir la imagen</translation>
    </message>
    <message>
        <source>the position is not finite</source>
        <translation>la posición no es finita</translation>
    </message>
    <message>
        <source>the position of the handle %1 in %2 is not finite</source>
        <translation>la posición del tirador %1 en %2 no es finita</translation>
    </message>
    <message>
        <source>the program ffmpeg is needed for this kind of movie and is not installed</source>
        <translation>este tipo de película necesita el programa ffmpeg, que no está instalado</translation>
    </message>
    <message>
        <source>the right ventricle is too small to eject as much as the left one</source>
        <translation>el ventrículo derecho es demasiado pequeño para eyectar tanto como el izquierdo</translation>
    </message>
    <message>
        <source>the scan %1 is not there any more (put it beside the session and open that again)</source>
        <translation>el estudio %1 ya no está (póngalo junto a la sesión y ábrala de nuevo)</translation>
    </message>
    <message>
        <source>the scan cannot be opened: %1</source>
        <translation>el estudio no se puede abrir: %1</translation>
    </message>
    <message>
        <source>the size is plausible: %1</source>
        <translation>el tamaño es plausible: %1</translation>
    </message>
    <message>
        <source>the solid could not be written</source>
        <translation>no se ha podido escribir el sólido</translation>
    </message>
    <message>
        <source>the solid could not be written: %1</source>
        <translation>no se ha podido escribir el sólido: %1</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; has two files of one phase</source>
        <translation>la superficie «%1» tiene dos archivos de una misma fase</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; is missing in phase number %2</source>
        <translation>falta la superficie «%1» en la fase número %2</translation>
    </message>
    <message>
        <source>the surface consists of %1 separate pieces</source>
        <translation>la superficie consta de %1 fragmentos separados</translation>
    </message>
    <message>
        <source>the surface does not cross itself</source>
        <translation>la superficie no se cruza consigo misma</translation>
    </message>
    <message>
        <source>every piece of the surface is smaller than the %1 mm that remeshing resolves</source>
        <translation>todos los fragmentos de la superficie son menores que los %1 mm que distingue el remallado</translation>
    </message>
    <message>
        <source>keep the largest piece first</source>
        <translation>conserve primero el fragmento mayor</translation>
    </message>
    <message>
        <source>the surface encloses nothing</source>
        <translation>la superficie no encierra nada</translation>
    </message>
    <message>
        <source>the surface encloses nothing that witness points could lie in</source>
        <translation>la superficie no encierra nada donde pueda haber puntos testigo</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>la superficie tiene %1 triángulos utilizables, así que no encierra nada</translation>
    </message>
    <message>
        <source>the surface has no triangles or is flat, so it encloses nothing</source>
        <translation>la superficie no tiene triángulos o es plana, así que no encierra nada</translation>
    </message>
    <message>
        <source>the surface has no triangles or no size</source>
        <translation>la superficie no tiene triángulos o no tiene tamaño</translation>
    </message>
    <message>
        <source>the surface has room for %1 of %2 handles</source>
        <translation>la superficie tiene sitio para %1 de %2 tiradores</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres</source>
        <translation>el tamaño de %1 mm no es plausible para un órgano; se supone que las coordenadas están en milímetros</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres, they may be in %2</source>
        <translation>el tamaño de %1 mm no es plausible para un órgano; se supone que las coordenadas están en milímetros, pero pueden estar en %2</translation>
    </message>
    <message>
        <source>the surface is closed</source>
        <translation>la superficie está cerrada</translation>
    </message>
    <message>
        <source>the surface is inside out</source>
        <translation>la superficie está del revés</translation>
    </message>
    <message>
        <source>the surface is of one piece</source>
        <translation>la superficie es de una pieza</translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges})</source>
        <translation>
            <numerusform>la superficie está abierta (%n arista de borde)</numerusform>
            <numerusform>la superficie está abierta (%n aristas de borde)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked</source>
        <translation>
            <numerusform>la superficie está abierta (%n arista de borde), así que no tiene volumen que bloquear</numerusform>
            <numerusform>la superficie está abierta (%n aristas de borde), así que no tiene volumen que bloquear</numerusform>
        </translation>
    </message>
    <message>
        <source>the surface is too large for GLB, which ends at 4 GB</source>
        <translation>la superficie es demasiado grande para GLB, que termina en 4 GB</translation>
    </message>
    <message>
        <source>the triangles beside a hole do not all run the same way round, so it cannot be closed</source>
        <translation>los triángulos junto a un agujero no giran todos en el mismo sentido, así que no se puede cerrar</translation>
    </message>
    <message>
        <source>the triangles face outward</source>
        <translation>los triángulos miran hacia fuera</translation>
    </message>
    <message>
        <source>the volume at the end of the cycle differs from the volume at its start</source>
        <translation>el volumen al final del ciclo difiere del volumen al comienzo</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>el volumen no se puede mantener aquí: %1</translation>
    </message>
    <message>
        <source>the waves are %1 % as deep as in an adult: %2</source>
        <translation>las ondas tienen el %1 % de la profundidad que en un adulto: %2</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>hay %1</translation>
    </message>
    <message>
        <source>there are no tetrahedra in it; the surface may be open</source>
        <translation>no contiene tetraedros; la superficie puede estar abierta</translation>
    </message>
    <message>
        <source>there is no coordinate system &quot;%1&quot;</source>
        <translation>no hay ningún sistema de coordenadas «%1»</translation>
    </message>
    <message>
        <source>there is no handle at vertex %1</source>
        <translation>no hay ningún tirador en el vértice %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existe ese archivo</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>no existe ese archivo ni esa carpeta</translation>
    </message>
    <message>
        <source>there is no surface to write</source>
        <translation>no hay ninguna superficie que escribir</translation>
    </message>
    <message>
        <source>there is no triangle to write</source>
        <translation>no hay ningún triángulo que escribir</translation>
    </message>
    <message>
        <source>simplifying the surface</source>
        <translation>simplificación de la superficie</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>es un fallo del programa; por favor, comuníquelo</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but neither fundus nor pylorus</source>
        <translation>faltan puntos de referencia: está %1, pero ni fundus ni pylorus</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but no %2</source>
        <translation>faltan puntos de referencia: está %1, pero no %2</translation>
    </message>
    <message>
        <source>too few landmarks: there is right but neither apex nor base</source>
        <translation>faltan puntos de referencia: está right, pero ni apex ni base</translation>
    </message>
    <message>
        <source>track surfaces that are not within each other one by one</source>
        <translation>siga una a una las superficies que no están unas dentro de otras</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>triángulo %1</translation>
    </message>
    <message>
        <source>try another resolution</source>
        <translation>pruebe otra resolución</translation>
    </message>
    <message>
        <source>try another resolution, or a cage without needle-like triangles</source>
        <translation>pruebe otra resolución, o una jaula sin triángulos en forma de aguja</translation>
    </message>
    <message>
        <source>turn its triangles around, as viscera convert IN OUT --orient does</source>
        <translation>invierta sus triángulos, por ejemplo con viscera convert ENTRADA SALIDA --orient</translation>
    </message>
    <message>
        <source>turn the surface outward, or choose a target above 0 ml</source>
        <translation>oriente la superficie hacia fuera, o elija un objetivo mayor que 0 ml</translation>
    </message>
    <message>
        <source>turns the surface by a quarter turn, from a model whose y axis points to the head</source>
        <translation>gira la superficie un cuarto de vuelta, de un modelo cuyo eje y apunta a la cabeza</translation>
    </message>
    <message>
        <source>turns the surface by half a turn, as from RAS to LPS</source>
        <translation>gira la superficie media vuelta, como de RAS a LPS</translation>
    </message>
    <message>
        <source>turns triangles around so that all of them face outward</source>
        <translation>da la vuelta a triángulos para que todos miren hacia fuera</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>dos grupos tienen este nombre</translation>
    </message>
    <message>
        <source>two handles have this label</source>
        <translation>dos tiradores tienen este nombre</translation>
    </message>
    <message>
        <source>unlock it, or let more handles compensate</source>
        <translation>desbloquéelo, o deje compensar a más tiradores</translation>
    </message>
    <message>
        <source>unsaved work cannot be kept safe: the folder cannot be written to</source>
        <translation>el trabajo sin guardar no se puede proteger: no se puede escribir en la carpeta</translation>
    </message>
    <message>
        <source>update Viscera</source>
        <translation>actualice Viscera</translation>
    </message>
    <message>
        <source>use .ogv, .mp4, .gif, or a folder for PNG frames</source>
        <translation>use .ogv, .mp4, .gif o una carpeta para fotogramas PNG</translation>
    </message>
    <message>
        <source>use images that show all of it in every phase</source>
        <translation>use imágenes que lo muestren entero en todas las fases</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>use uno de: %1</translation>
    </message>
    <message>
        <source>values from the section %1 on were not understood and ignored</source>
        <translation>los valores a partir de la sección %1 no se han entendido y se ignoran</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>vértice %1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volumen</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volumen después de comer</translation>
    </message>
    <message>
        <source>volume of the muscle</source>
        <translation>volumen del músculo</translation>
    </message>
    <message>
        <source>volume with its blood</source>
        <translation>volumen con su sangre</translation>
    </message>
    <message>
        <source>wait a moment</source>
        <translation>espere un momento</translation>
    </message>
    <message>
        <source>wait until the witness points are computed</source>
        <translation>espere a que se calculen los puntos testigo</translation>
    </message>
    <message>
        <source>wave fades at the pylorus</source>
        <translation>la onda se apaga en el píloro</translation>
    </message>
    <message>
        <source>wave in the antrum</source>
        <translation>onda en el antro</translation>
    </message>
    <message>
        <source>wave in the body</source>
        <translation>onda en el cuerpo gástrico</translation>
    </message>
    <message>
        <source>witness points</source>
        <translation>puntos testigo</translation>
    </message>
    <message>
        <source>Pin stress probe</source>
        <translation>Fijar sonda de estrés</translation>
    </message>
    <message>
        <source>Draw stress profile</source>
        <translation>Dibujar perfil de estrés</translation>
    </message>
    <message>
        <source>Remove stress profile</source>
        <translation>Quitar perfil de estrés</translation>
    </message>
    <message>
        <source>Remove all stress probes</source>
        <translation>Quitar todas las sondas de estrés</translation>
    </message>
    <message numerus="yes">
        <source>Remove {stress probe|%n stress probes}</source>
        <translation>
            <numerusform>Quitar sonda de estrés</numerusform>
            <numerusform>Quitar %n sondas de estrés</numerusform>
        </translation>
    </message>
    <message>
        <source>stress probe %1</source>
        <translation>sonda de estrés %1</translation>
    </message>
    <message>
        <source>stress profile %1</source>
        <translation>perfil de estrés %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>sonda de estrés</translation>
    </message>
    <message>
        <source>stress profile</source>
        <translation>perfil de estrés</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Un perfil necesita dos sondas de un órgano</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Estas dos sondas ya tienen un perfil</translation>
    </message>
    <message>
        <source>witness points on a grid</source>
        <translation>puntos testigo en una cuadrícula</translation>
    </message>
    <message>
        <source>women and men have on average %1 to %2 ml</source>
        <translation>mujeres y hombres tienen de media de %1 a %2 ml</translation>
    </message>
    <message>
        <source>write an .ogv instead</source>
        <translation>escriba un .ogv en su lugar</translation>
    </message>
    <message>
        <source>write lines of the instant and the volume in ml</source>
        <translation>escriba líneas con el instante y el volumen en ml</translation>
    </message>
    <message>
        <source>write the instant and the volume in ml, as in 0.25,98.5</source>
        <translation>escriba el instante y el volumen en ml, como en 0.25,98.5</translation>
    </message>
    <message>
        <source>write volumes in ml</source>
        <translation>escriba los volúmenes en ml</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>escritura de la película</translation>
    </message>
    <message>
        <source>the organ has no extent</source>
        <translation>el órgano no tiene extensión</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right</source>
        <translation>corazón con %1 ml a la izquierda y %2 ml a la derecha</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right, atria with %3 ml left and %4 ml right</source>
        <translation>corazón con %1 ml a la izquierda y %2 ml a la derecha, aurículas con %3 ml a la izquierda y %4 ml a la derecha</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml; atria: left off by %3 ml, right by %4 ml</source>
        <translation>Los ventrículos no pueden alcanzar sus volúmenes: al izquierdo le faltan %1 ml, al derecho %2 ml; aurículas: a la izquierda %3 ml, a la derecha %4 ml</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml</source>
        <translation>Los ventrículos no pueden alcanzar sus volúmenes: al izquierdo le faltan %1 ml, al derecho %2 ml</translation>
    </message>
    <message>
        <source>check that the cavities lie inside the handles of their walls</source>
        <translation>compruebe que las cavidades están dentro de los tiradores de sus paredes</translation>
    </message>
    <message>
        <source>a centreline needs at least two points</source>
        <translation>una línea central necesita al menos dos puntos</translation>
    </message>
    <message>
        <source>centreline point %1</source>
        <translation>punto %1 de la línea central</translation>
    </message>
    <message>
        <source>the point is not finite</source>
        <translation>el punto no es finito</translation>
    </message>
    <message>
        <source>the point is where the one before it is</source>
        <translation>el punto está donde el anterior</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>elimínelo</translation>
    </message>
    <message>
        <source>calibrating the heartbeat</source>
        <translation>calibración del latido</translation>
    </message>
    <message>
        <source>curve key %1</source>
        <translation>clave %1 de la curva</translation>
    </message>
    <message>
        <source>the pylorus does not lie beyond the middle of the body</source>
        <translation>el píloro no está más allá de la mitad del cuerpo</translation>
    </message>
    <message>
        <source>gastric waves</source>
        <translation>ondas gástricas</translation>
    </message>
    <message>
        <source>choose the landmarks from the fundus downwards</source>
        <translation>elija los puntos de referencia del fundus hacia abajo</translation>
    </message>
    <message>
        <source>the surface has no inside</source>
        <translation>la superficie no tiene interior</translation>
    </message>
    <message>
        <source>heart landmarks</source>
        <translation>puntos de referencia del corazón</translation>
    </message>
    <message>
        <source>give apex and base yourself</source>
        <translation>indique usted el ápex y la base</translation>
    </message>
    <message>
        <source>the base does not lie inside the heart</source>
        <translation>la base no está dentro del corazón</translation>
    </message>
    <message>
        <source>put it on the middle of the mitral valve</source>
        <translation>póngala en el centro de la válvula mitral</translation>
    </message>
    <message>
        <source>the directions to the right ventricle and to the apex do not span a frame</source>
        <translation>las direcciones al ventrículo derecho y al ápex no forman un sistema de ejes</translation>
    </message>
    <message>
        <source>heart frame</source>
        <translation>ejes del corazón</translation>
    </message>
    <message>
        <source>choose landmarks that do not lie on one line</source>
        <translation>elija puntos de referencia que no estén en una recta</translation>
    </message>
    <message numerus="yes">
        <source>a ventricle is not where its frame says: only %n {handle meets|handles meet} its wall</source>
        <translation>
            <numerusform>un ventrículo no está donde indican sus ejes: solo %n tirador toca su pared</numerusform>
            <numerusform>un ventrículo no está donde indican sus ejes: solo %n tiradores tocan su pared</numerusform>
        </translation>
    </message>
    <message>
        <source>heart rig</source>
        <translation>tiradores del corazón</translation>
    </message>
    <message>
        <source>check the landmarks of base, apex and right ventricle</source>
        <translation>compruebe los puntos de referencia de la base, el ápex y el ventrículo derecho</translation>
    </message>
    <message>
        <source>move it, or lengthen the period</source>
        <translation>muévala o alargue el período</translation>
    </message>
    <message>
        <source>there is no key</source>
        <translation>no hay ningún fotograma clave</translation>
    </message>
    <message>
        <source>the heart cannot be brought to the volume that it has to hold</source>
        <translation>el corazón no puede alcanzar el volumen que debe tener</translation>
    </message>
    <message>
        <source>heartbeat at %1 s</source>
        <translation>latido en %1 s</translation>
    </message>
    <message>
        <source>check the landmarks of apex and base</source>
        <translation>compruebe los puntos de referencia del ápex y la base</translation>
    </message>
    <message>
        <source>the upper stomach cannot take in what the waves press out</source>
        <translation>el estómago superior no puede acoger lo que las ondas desplazan</translation>
    </message>
    <message>
        <source>peristalsis after %1 s</source>
        <translation>peristaltismo tras %1 s</translation>
    </message>
    <message>
        <source>check the landmarks</source>
        <translation>compruebe los puntos de referencia</translation>
    </message>
    <message>
        <source>the centreline leaves the stomach %1 mm below the top of the fundus</source>
        <translation>la línea central sale del estómago %1 mm por debajo del vértice del fundus</translation>
    </message>
    <message>
        <source>stomach rig</source>
        <translation>tiradores del estómago</translation>
    </message>
    <message>
        <source>move its points into the stomach</source>
        <translation>mueva sus puntos al interior del estómago</translation>
    </message>
    <message>
        <source>the centreline ends before the pylorus</source>
        <translation>la línea central termina antes del píloro</translation>
    </message>
    <message>
        <source>lead it into the duodenum</source>
        <translation>prolónguela hasta el duodeno</translation>
    </message>
    <message numerus="yes">
        <source>Only %n {vertex|vertices} of the surface {lies|lie} there</source>
        <translation>
            <numerusform>Solo %n vértice de la superficie está ahí</numerusform>
            <numerusform>Solo %n vértices de la superficie están ahí</numerusform>
        </translation>
    </message>
    <message>
        <source>take a finer surface</source>
        <translation>use una superficie más fina</translation>
    </message>
    <message>
        <source>base of the left ventricle</source>
        <translation>base del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>apex of the left ventricle</source>
        <translation>ápex del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>base of the right ventricle</source>
        <translation>base del ventrículo derecho</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, inside</source>
        <translation>pared libre del ventrículo izquierdo, por dentro</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, outside</source>
        <translation>pared libre del ventrículo izquierdo, por fuera</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus towards the apex</source>
        <translation>excursión del anillo mitral hacia el ápex</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus at the free wall</source>
        <translation>excursión del anillo tricúspide en la pared libre</translation>
    </message>
    <message>
        <source>turn of the apex against the base</source>
        <translation>giro del ápex respecto a la base</translation>
    </message>
    <message>
        <source>of the left ventricle's free wall in systole</source>
        <translation>de la pared libre del ventrículo izquierdo en la sístole</translation>
    </message>
    <message>
        <source>effective areas of normal valves: doi 10.1016/j.echo.2017.02.009</source>
        <translation>áreas efectivas de válvulas normales: doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.1 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>una regurgitación leve está por debajo de 0,1 cm²: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.2 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>una regurgitación leve está por debajo de 0,2 cm²: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>20 % around the healthy adult at rest</source>
        <translation>20 % en torno al adulto sano en reposo</translation>
    </message>
    <message>
        <source>sinus rhythm at rest</source>
        <translation>ritmo sinusal en reposo</translation>
    </message>
    <message>
        <source>800 to 1600 dyn s cm^-5, customary at the bedside</source>
        <translation>800 a 1600 dyn s cm^-5, habitual en la clínica</translation>
    </message>
    <message>
        <source>up to 2 Wood units</source>
        <translation>hasta 2 unidades Wood</translation>
    </message>
    <message>
        <source>the amount in a healthy heart</source>
        <translation>la cantidad en un corazón sano</translation>
    </message>
    <message>
        <source>%1 is out of its range</source>
        <translation>%1 está fuera de su intervalo</translation>
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
        <translation>el área de la fuga debe ser menor que la de la válvula abierta</translation>
    </message>
    <message>
        <source>choose a %1 below its %2</source>
        <translation>elija %1 menor que %2</translation>
    </message>
    <message>
        <source>%1 lies between %2 and %3</source>
        <translation>%1 está entre %2 y %3</translation>
    </message>
    <message>
        <source>An end-diastolic volume in ml</source>
        <translation>Un volumen telediastólico en ml</translation>
    </message>
    <message>
        <source>give the largest volume of the left ventricle</source>
        <translation>indique el mayor volumen del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>An ejection fraction</source>
        <translation>Una fracción de eyección</translation>
    </message>
    <message>
        <source>give 55 % as 0.55</source>
        <translation>indique 55 % como 0,55</translation>
    </message>
    <message>
        <source>A mean aortic pressure in mmHg</source>
        <translation>Una presión aórtica media en mmHg</translation>
    </message>
    <message>
        <source>about a third of the way from the diastolic to the systolic one</source>
        <translation>alrededor de un tercio del camino de la diastólica a la sistólica</translation>
    </message>
    <message>
        <source>fitting the circulation</source>
        <translation>ajuste de la circulación</translation>
    </message>
    <message>
        <source>the circulation of that heart</source>
        <translation>la circulación de ese corazón</translation>
    </message>
    <message>
        <source>The circulation has the measured ventricle: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>La circulación tiene el ventrículo medido: %1 ml, fracción de eyección %2, presión aórtica media %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>Ninguna circulación tiene exactamente ese ventrículo; la más cercana: %1 ml, fracción de eyección %2, presión aórtica media %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg; at the limit of its range: %4</source>
        <translation>Ninguna circulación tiene exactamente ese ventrículo; la más cercana: %1 ml, fracción de eyección %2, presión aórtica media %3 mmHg; en el límite de su intervalo: %4</translation>
    </message>
    <message>
        <source>the circulation to start with</source>
        <translation>la circulación de partida</translation>
    </message>
    <message numerus="yes">
        <source>After %n {beat|beats} the volumes still change by %2 ml from beat to beat: strong and weak beats alternate, or the circulation fails; try a lower rate or a larger stressed volume</source>
        <translation>
            <numerusform>Tras %n latido los volúmenes aún cambian %2 ml de latido a latido: alternan latidos fuertes y débiles, o la circulación falla; pruebe una frecuencia menor o un volumen estresado mayor</numerusform>
            <numerusform>Tras %n latidos los volúmenes aún cambian %2 ml de latido a latido: alternan latidos fuertes y débiles, o la circulación falla; pruebe una frecuencia menor o un volumen estresado mayor</numerusform>
        </translation>
    </message>
    <message>
        <source>the circulation breaks down: its pressures grow without bounds</source>
        <translation>la circulación se derrumba: sus presiones crecen sin límite</translation>
    </message>
    <message>
        <source>beat %1</source>
        <translation>latido %1</translation>
    </message>
    <message>
        <source>bring the parameters nearer to those at rest, a few at a time</source>
        <translation>acerque los parámetros a los de reposo, unos pocos cada vez</translation>
    </message>
    <message>
        <source>fitting phase %1</source>
        <translation>ajuste de la fase %1</translation>
    </message>
    <message>
        <source>smoothing phase %1</source>
        <translation>suavizado de la fase %1</translation>
    </message>
    <message>
        <source>%1 is %2 mm away on average</source>
        <translation>%1 está a %2 mm de media</translation>
    </message>
    <message>
        <source>a twentieth of %1 is more than %2 mm away</source>
        <translation>una vigésima parte de %1 está a más de %2 mm</translation>
    </message>
    <message>
        <source>%1 had to be changed by %2 % to get its volume</source>
        <translation>%1 tuvo que cambiarse un %2 % para tener su volumen</translation>
    </message>
    <message>
        <source>%1 agrees with its voxels by a Dice of %2 only</source>
        <translation>%1 coincide con sus vóxeles solo con un Dice de %2</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} of %2 {is|are} turned over</source>
        <translation>
            <numerusform>%n triángulo de %2 está volteado</numerusform>
            <numerusform>%n triángulos de %2 están volteados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the tissue is folded at %n {place|places}</source>
        <translation>
            <numerusform>el tejido está plegado en %n lugar</numerusform>
            <numerusform>el tejido está plegado en %n lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>the measured volumes cannot be met</source>
        <translation>los volúmenes medidos no se pueden alcanzar</translation>
    </message>
    <message numerus="yes">
        <source>%2 handles are too few for %n {surface|surfaces}</source>
        <translation>
            <numerusform>%2 tiradores son pocos para %n superficie</numerusform>
            <numerusform>%2 tiradores son pocos para %n superficies</numerusform>
        </translation>
    </message>
    <message>
        <source>ask for fewer</source>
        <translation>pida menos</translation>
    </message>
    <message>
        <source>keeping volumes</source>
        <translation>conservación de los volúmenes</translation>
    </message>
    <message>
        <source>Phase %1 has %2 points and the first has %3</source>
        <translation>La fase %1 tiene %2 puntos y la primera tiene %3</translation>
    </message>
    <message>
        <source>export all phases with the same triangles</source>
        <translation>exporte todas las fases con los mismos triángulos</translation>
    </message>
    <message>
        <source>%1, phase %2</source>
        <translation>%1, fase %2</translation>
    </message>
    <message>
        <source>It has no triangle with three different corners</source>
        <translation>No tiene ningún triángulo con tres vértices distintos</translation>
    </message>
    <message>
        <source>It is not a closed surface, even with its holes filled: %1</source>
        <translation>No es una superficie cerrada, ni con los agujeros rellenos: %1</translation>
    </message>
    <message>
        <source>repair the surfaces in the program that made them</source>
        <translation>repare las superficies en el programa que las creó</translation>
    </message>
    <message>
        <source>the volume cannot be kept throughout the cycle: %1</source>
        <translation>el volumen no se puede conservar durante todo el ciclo: %1</translation>
    </message>
    <message>
        <source>unlock it, or prescribe a volume nearer to that at rest</source>
        <translation>desbloquéelo o prescriba un volumen más próximo al de reposo</translation>
    </message>
    <message>
        <source>No organ is shown</source>
        <translation>No se muestra ningún órgano</translation>
    </message>
    <message>
        <source>the lesson</source>
        <translation>la lección</translation>
    </message>
    <message>
        <source>show those that the lesson is about</source>
        <translation>muestre aquellos de los que trata la lección</translation>
    </message>
    <message>
        <source>check the size of the organ, and its motion</source>
        <translation>compruebe el tamaño del órgano y su movimiento</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; returned no binding of the right size</source>
        <translation>el sistema «%1» no devolvió una vinculación del tamaño correcto</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed: %2</source>
        <translation>el sistema «%1» falló: %2</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed</source>
        <translation>el sistema «%1» falló</translation>
    </message>
    <message>
        <source>choose another system</source>
        <translation>elija otro sistema</translation>
    </message>
    <message>
        <source>it was made for version %1 of the plugin interface, this program has %2</source>
        <translation>se hizo para la versión %1 de la interfaz de complementos, este programa tiene %2</translation>
    </message>
    <message>
        <source>plugin %1: %2</source>
        <translation>complemento %1: %2</translation>
    </message>
    <message>
        <source>There is already a coordinate system &quot;%1&quot; (%2)</source>
        <translation>Ya existe un sistema de coordenadas «%1» (%2)</translation>
    </message>
    <message>
        <source>remove one of the two, or give one another id</source>
        <translation>elimine uno de los dos o dé a uno otro identificador</translation>
    </message>
    <message>
        <source>There is no coordinate system &quot;%1&quot;</source>
        <translation>No existe el sistema de coordenadas «%1»</translation>
    </message>
    <message>
        <source>none is loaded</source>
        <translation>no hay ninguno cargado</translation>
    </message>
    <message>
        <source>none: the organs are as in their files</source>
        <translation>ninguno: los órganos están como en sus archivos</translation>
    </message>
    <message>
        <source>in %1 groups</source>
        <translation>en %1 grupos</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>%1 of them moved</source>
        <translation>%1 de ellos movidos</translation>
    </message>
    <message>
        <source>%1 of them shown</source>
        <translation>%1 de ellos visibles</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Órganos</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Tiradores</translation>
    </message>
    <message>
        <source>Instant</source>
        <translation>Instante</translation>
    </message>
    <message>
        <source>%1, at %2 of its cycle</source>
        <translation>%1, al %2 de su ciclo</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(oculto)</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierto</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>Rest shape (ml)</source>
        <translation>Forma en reposo (ml)</translation>
    </message>
    <message>
        <source>Now (ml)</source>
        <translation>Ahora (ml)</translation>
    </message>
    <message>
        <source>Change (ml)</source>
        <translation>Cambio (ml)</translation>
    </message>
    <message>
        <source>Change (%)</source>
        <translation>Cambio (%)</translation>
    </message>
    <message>
        <source>Surface (cm²)</source>
        <translation>Superficie (cm²)</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volúmenes</translation>
    </message>
    <message>
        <source>Open: the surface has holes and holds no volume.</source>
        <translation>Abierto: la superficie tiene agujeros y no encierra ningún volumen.</translation>
    </message>
    <message>
        <source>mean in a rectangle</source>
        <translation>media en un rectángulo</translation>
    </message>
    <message>
        <source>mean in a sphere</source>
        <translation>media en una esfera</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Medido en</translation>
    </message>
    <message>
        <source>Rest shape</source>
        <translation>Forma en reposo</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>the scan</source>
        <translation>el estudio</translation>
    </message>
    <message>
        <source>sample organ &quot;%1&quot;, %2 resolution</source>
        <translation>órgano de muestra «%1», resolución %2</translation>
    </message>
    <message>
        <source>low</source>
        <translation>baja</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>media</translation>
    </message>
    <message>
        <source>high</source>
        <translation>alta</translation>
    </message>
    <message>
        <source>made in the program</source>
        <translation>creado en el programa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Findings and repairs</source>
        <translation>Hallazgos y reparaciones</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>Files and what was done to them</source>
        <translation>Archivos y lo que se hizo con ellos</translation>
    </message>
    <message>
        <source>All lengths are in millimetres, all volumes in millilitres; positions are in the patient's axes LPS (to the left, to the back, to the head). Viscera is a program for teaching and research, not a medical device.</source>
        <translation>Todas las longitudes están en milímetros, todos los volúmenes en mililitros; las posiciones están en los ejes LPS del paciente (a la izquierda, hacia atrás, hacia la cabeza). Viscera es un programa para la docencia y la investigación, no un producto sanitario.</translation>
    </message>
    <message>
        <source>There is no organ to report on</source>
        <translation>No hay ningún órgano sobre el que informar</translation>
    </message>
    <message>
        <source>Made by Viscera %1 on %2</source>
        <translation>Creado por Viscera %1 el %2</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dibujo</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>medición</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>going through the cycle</source>
        <translation>recorrido del ciclo</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volumen (ml)</translation>
    </message>
    <message>
        <source>Volumes over one cycle, each instant computed</source>
        <translation>Volúmenes durante un ciclo, cada instante calculado</translation>
    </message>
    <message>
        <source>the first %1 of %2 organs</source>
        <translation>los primeros %1 de %2 órganos</translation>
    </message>
    <message>
        <source>Smallest (ml)</source>
        <translation>Mínimo (ml)</translation>
    </message>
    <message>
        <source>Largest (ml)</source>
        <translation>Máximo (ml)</translation>
    </message>
    <message>
        <source>Ventricle</source>
        <translation>Ventrículo</translation>
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
        <translation>Volumen sistólico (ml)</translation>
    </message>
    <message>
        <source>EF (%)</source>
        <translation>FE (%)</translation>
    </message>
    <message>
        <source>EF of healthy people</source>
        <translation>FE de personas sanas</translation>
    </message>
    <message>
        <source>Output (l/min)</source>
        <translation>Gasto (l/min)</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Secuencia</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>%1 a minute, one cycle takes %2 s</source>
        <translation>%1 por minuto, un ciclo dura %2 s</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Fases</translation>
    </message>
    <message>
        <source>Prescribed</source>
        <translation>Prescrito</translation>
    </message>
    <message>
        <source>the volume of %1</source>
        <translation>el volumen de %1</translation>
    </message>
    <message>
        <source>A volume could not be kept: %1</source>
        <translation>No se pudo conservar un volumen: %1</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De frente</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Desde la izquierda</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Desde atrás</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Desde la derecha</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Desde abajo</translation>
    </message>
    <message>
        <source>The map as the session shows it</source>
        <translation>El mapa como lo muestra la sesión</translation>
    </message>
    <message>
        <source>There is no font to write with</source>
        <translation>No hay ningún tipo de letra para escribir</translation>
    </message>
    <message>
        <source>install one, such as the package fonts-dejavu-core</source>
        <translation>instale uno, como el paquete fonts-dejavu-core</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>A report cannot be written to this kind of file</source>
        <translation>No se puede escribir un informe en este tipo de archivo</translation>
    </message>
    <message>
        <source>let it end in .pdf or .html</source>
        <translation>haga que termine en .pdf o .html</translation>
    </message>
    <message>
        <source>by TetGen</source>
        <translation>por TetGen</translation>
    </message>
    <message>
        <source>by TetGen, from a repaired copy of the surface</source>
        <translation>por TetGen, de una copia reparada de la superficie</translation>
    </message>
    <message>
        <source>by a regular grid</source>
        <translation>por una cuadrícula regular</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
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
        <translation>%1, valor extremo de un ciclo</translation>
    </message>
    <message>
        <source>Points (%)</source>
        <translation>Puntos (%)</translation>
    </message>
    <message>
        <source>%1 over the witness points</source>
        <translation>%1 en los puntos testigo</translation>
    </message>
    <message>
        <source>Rotational stress (deg)</source>
        <translation>Estrés rotacional (grados)</translation>
    </message>
    <message>
        <source>Over one cycle of the sequence</source>
        <translation>Durante un ciclo de la secuencia</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>Place (mm)</source>
        <translation>Lugar (mm)</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>sin tejido</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>plegado</translation>
    </message>
    <message>
        <source>Distance at rest (mm)</source>
        <translation>Distancia en reposo (mm)</translation>
    </message>
    <message>
        <source>Along the straight lines at rest between probes</source>
        <translation>A lo largo de las rectas en reposo entre sondas</translation>
    </message>
    <message>
        <source>Tissue distortion (rotational stress)</source>
        <translation>Distorsión del tejido (estrés rotacional)</translation>
    </message>
    <message>
        <source>Witness points</source>
        <translation>Puntos testigo</translation>
    </message>
    <message>
        <source>%1 in %2 tetrahedra</source>
        <translation>%1 en %2 tetraedros</translation>
    </message>
    <message>
        <source>Derivatives</source>
        <translation>Derivadas</translation>
    </message>
    <message>
        <source>in closed form (analytic)</source>
        <translation>en forma cerrada (analítica)</translation>
    </message>
    <message>
        <source>by central differences</source>
        <translation>por diferencias centrales</translation>
    </message>
    <message>
        <source>no point: the tissue is turned inside out nowhere</source>
        <translation>ningún punto: el tejido no está invertido en ningún lugar</translation>
    </message>
    <message>
        <source>%1 of %2 points are turned inside out</source>
        <translation>%1 de %2 puntos están invertidos</translation>
    </message>
    <message>
        <source>Rotational stress is the largest angle by which a direction is turned when the tissue is stretched. It measures distortion and is not a pressure.</source>
        <translation>El estrés rotacional es el mayor ángulo que gira una dirección cuando el tejido se estira. Mide la distorsión y no es una presión.</translation>
    </message>
    <message>
        <source>± %1, %2 to %3, %4, %5 voxels</source>
        <translation>± %1; de %2 a %3; %4; %5 vóxeles</translation>
    </message>
    <message>
        <source>The view cannot be restored completely</source>
        <translation>La vista no se puede restaurar por completo</translation>
    </message>
    <message>
        <source>the session's view</source>
        <translation>la vista de la sesión</translation>
    </message>
    <message>
        <source>the organs and the handles are complete; save the session anew</source>
        <translation>los órganos y los tiradores están completos; guarde de nuevo la sesión</translation>
    </message>
    <message>
        <source>women</source>
        <translation>mujeres</translation>
    </message>
    <message>
        <source>men</source>
        <translation>hombres</translation>
    </message>
    <message>
        <source>women and men</source>
        <translation>mujeres y hombres</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations</source>
        <translation>%1, media ± 2 desviaciones típicas</translation>
    </message>
    <message>
        <source>%1, on average</source>
        <translation>%1, de media</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations, for %2 m2 of body surface</source>
        <translation>%1, media ± 2 desviaciones típicas, para %2 m² de superficie corporal</translation>
    </message>
    <message>
        <source>%1, on average, for %2 m2 of body surface</source>
        <translation>%1, de media, para %2 m² de superficie corporal</translation>
    </message>
    <message>
        <source>800 healthy people of 45 to 74 years, by magnetic resonance, papillary muscles counted as cavity</source>
        <translation>800 personas sanas de 45 a 74 años, por resonancia magnética, músculos papilares contados como cavidad</translation>
    </message>
    <message>
        <source>ICRP publication 89, doi 10.1016/S0146-6453(03)00002-2</source>
        <translation>ICRP, publicación 89, doi 10.1016/S0146-6453(03)00002-2</translation>
    </message>
    <message>
        <source>1815 people without kidney disease, by magnetic resonance; the deviation is that of the quartiles</source>
        <translation>1815 personas sin enfermedad renal, por resonancia magnética; la desviación es la de los cuartiles</translation>
    </message>
    <message>
        <source>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (spread), and &quot;Simplifying the measurement of gastric accommodation using SPECT&quot; (mean)</source>
        <translation>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (dispersión), y «Simplifying the measurement of gastric accommodation using SPECT» (media)</translation>
    </message>
    <message>
        <source>customary at the bedside</source>
        <translation>habitual en la clínica</translation>
    </message>
    <message>
        <source>Whelton 2018, doi 10.1161/HYP.0000000000000065: normal is below 120/80; the lower bound is customary</source>
        <translation>Whelton 2018, doi 10.1161/HYP.0000000000000065: lo normal es por debajo de 120/80; el límite inferior es el habitual</translation>
    </message>
    <message>
        <source>mass of the muscle</source>
        <translation>masa del músculo</translation>
    </message>
    <message>
        <source>1969 healthy people at rest, by tissue Doppler</source>
        <translation>1969 personas sanas en reposo, por Doppler tisular</translation>
    </message>
    <message>
        <source>ejection time</source>
        <translation>tiempo de eyección</translation>
    </message>
    <message>
        <source>healthy adults, by magnetic resonance and ultrasound</source>
        <translation>adultos sanos, por resonancia magnética y ecografía</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus (MAPSE)</source>
        <translation>excursión del anillo mitral (MAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 16.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); ultrasound finds less, 12 to 15 mm</source>
        <translation>resonancia magnética: 16,4 mm (Carlsson y otros 2007, doi 10.1152/ajpheart.01376.2006); la ecografía da menos, de 12 a 15 mm</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus (TAPSE)</source>
        <translation>excursión del anillo tricúspide (TAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 23.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); below 17 mm is abnormal in ultrasound (Lang and others 2015, doi 10.1016/j.echo.2014.10.003)</source>
        <translation>resonancia magnética: 23,4 mm (Carlsson y otros 2007, doi 10.1152/ajpheart.01376.2006); en ecografía, menos de 17 mm es anormal (Lang y otros 2015, doi 10.1016/j.echo.2014.10.003)</translation>
    </message>
    <message>
        <source>twist of the apex against the base</source>
        <translation>torsión del ápex respecto a la base</translation>
    </message>
    <message>
        <source>magnetic resonance: apex about 10, base about 3 degrees the other way (Young and Cowan 2012, doi 10.1186/1532-429X-14-49)</source>
        <translation>resonancia magnética: ápex unos 10 grados, base unos 3 en sentido contrario (Young y Cowan 2012, doi 10.1186/1532-429X-14-49)</translation>
    </message>
    <message>
        <source>thickening of the free wall</source>
        <translation>engrosamiento de la pared libre</translation>
    </message>
    <message>
        <source>magnetic resonance: 4.4 +- 1.4 mm in the middle slices (Ubachs and others 2009, doi 10.1186/1532-429X-11-S1-P61)</source>
        <translation>resonancia magnética: 4,4 ± 1,4 mm en los cortes medios (Ubachs y otros 2009, doi 10.1186/1532-429X-11-S1-P61)</translation>
    </message>
    <message>
        <source>healthy adults at rest</source>
        <translation>adultos sanos en reposo</translation>
    </message>
    <message>
        <source>systolic pressure</source>
        <translation>presión sistólica</translation>
    </message>
    <message>
        <source>diastolic pressure</source>
        <translation>presión diastólica</translation>
    </message>
    <message>
        <source>mean pressure</source>
        <translation>presión media</translation>
    </message>
    <message>
        <source>end-diastolic pressure</source>
        <translation>presión telediastólica</translation>
    </message>
    <message>
        <source>fastest rise of pressure</source>
        <translation>ascenso más rápido de la presión</translation>
    </message>
    <message>
        <source>coupling Ea/Ees</source>
        <translation>acoplamiento Ea/Ees</translation>
    </message>
    <message>
        <source>mean gradient</source>
        <translation>gradiente medio</translation>
    </message>
    <message>
        <source>regurgitant fraction</source>
        <translation>fracción de regurgitación</translation>
    </message>
    <message>
        <source>Kovacs 2009, doi 10.1183/09031936.00145608: mean +- 2 standard deviations</source>
        <translation>Kovacs 2009, doi 10.1183/09031936.00145608: media ± 2 desviaciones típicas</translation>
    </message>
    <message>
        <source>between the most efficient (0.5) and the most powerful coupling (1): Burkhoff and Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</source>
        <translation>entre el acoplamiento más eficiente (0,5) y el más potente (1): Burkhoff y Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</translation>
    </message>
    <message>
        <source>reference woman and man; no spread is given</source>
        <translation>mujer y hombre de referencia; no se indica la dispersión</translation>
    </message>
    <message>
        <source>1248 people without liver disease, by magnetic resonance</source>
        <translation>1248 personas sin enfermedad hepática, por resonancia magnética</translation>
    </message>
    <message>
        <source>212 adults, by CT</source>
        <translation>212 adultos, por TC</translation>
    </message>
    <message>
        <source>adults of 20 to 60 years, by CT</source>
        <translation>adultos de 20 a 60 años, por TC</translation>
    </message>
    <message>
        <source>contents after a meal</source>
        <translation>contenido después de comer</translation>
    </message>
    <message>
        <source>443 people after a meal, by single-photon tomography</source>
        <translation>443 personas después de comer, por tomografía de fotón único</translation>
    </message>
    <message>
        <source>contents of 443 people after a meal, by single-photon tomography, and 138 ml of wall (ICRP publication 89)</source>
        <translation>contenido de 443 personas después de comer, por tomografía de fotón único, y 138 ml de pared (publicación 89 de la ICRP)</translation>
    </message>
    <message>
        <source>adults, by electrogastrography</source>
        <translation>adultos, por electrogastrografía</translation>
    </message>
    <message>
        <source>Yin and Chen 2013, doi 10.5056/jnm.2013.19.1.5</source>
        <translation>Yin y Chen 2013, doi 10.5056/jnm.2013.19.1.5</translation>
    </message>
    <message>
        <source>speed of the waves</source>
        <translation>velocidad de las ondas</translation>
    </message>
    <message>
        <source>occlusion of the antrum by a wave</source>
        <translation>oclusión del antro por una onda</translation>
    </message>
    <message>
        <source>28 healthy people, by magnetic resonance</source>
        <translation>28 personas sanas, por resonancia magnética</translation>
    </message>
    <message>
        <source>adults at rest</source>
        <translation>adultos en reposo</translation>
    </message>
    <message>
        <source>part that is inspiration</source>
        <translation>parte que es inspiración</translation>
    </message>
    <message>
        <source>adults at rest, from 1 : 2 to 1 : 1</source>
        <translation>adultos en reposo, de 1 : 2 a 1 : 1</translation>
    </message>
    <message>
        <source>way down in quiet breathing</source>
        <translation>descenso en la respiración tranquila</translation>
    </message>
    <message>
        <source>what several studies measured</source>
        <translation>lo que midieron varios estudios</translation>
    </message>
    <message>
        <source>there are no handles to save</source>
        <translation>no hay tiradores que guardar</translation>
    </message>
    <message>
        <source>There is no scan to export</source>
        <translation>No hay ningún estudio que exportar</translation>
    </message>
    <message>
        <source>There are no handles that could warp the scan</source>
        <translation>No hay tiradores que puedan deformar el estudio</translation>
    </message>
    <message>
        <source>Writing the scan</source>
        <translation>Escribiendo el estudio</translation>
    </message>
    <message>
        <source>9 healthy people, by magnetic resonance; 28 people of doi 10.1046/j.1365-2982.2001.00285.x have 1.6 +- 0.2</source>
        <translation>9 personas sanas, por resonancia magnética; 28 personas de doi 10.1046/j.1365-2982.2001.00285.x tienen 1,6 ± 0,2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>desde %1</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>hasta %1</translation>
    </message>
    <message>
        <source>the sample organs cannot be listed: %1</source>
        <translation>no se pueden enumerar los órganos de muestra: %1</translation>
    </message>
    <message>
        <source>set VISCERA_SAMPLE_ORGANS to the folder of the definitions</source>
        <translation>ponga en VISCERA_SAMPLE_ORGANS la carpeta de las definiciones</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>No se puede leer el archivo: %1</translation>
    </message>
    <message>
        <source>its segment %1 has no valid value or layer</source>
        <translation>su segmento %1 no tiene un valor o una capa válidos</translation>
    </message>
    <message>
        <source>the table of names in it cannot be read</source>
        <translation>no se puede leer la tabla de nombres que contiene</translation>
    </message>
    <message>
        <source>its voxels are no plain numbers (%1)</source>
        <translation>sus vóxeles no son números simples (%1)</translation>
    </message>
    <message>
        <source>It is not a surface</source>
        <translation>No es una superficie</translation>
    </message>
    <message>
        <source>It is not a label map</source>
        <translation>No es un mapa de etiquetas</translation>
    </message>
    <message>
        <source>an archive</source>
        <translation>un archivo comprimido</translation>
    </message>
    <message>
        <source>a CAD model</source>
        <translation>un modelo de CAD</translation>
    </message>
    <message>
        <source>a scene of a 3D program</source>
        <translation>una escena de un programa 3D</translation>
    </message>
    <message>
        <source>a scene of 3D Slicer</source>
        <translation>una escena de 3D Slicer</translation>
    </message>
    <message>
        <source>a document</source>
        <translation>un documento</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>una tabla</translation>
    </message>
    <message>
        <source>export it as STL, OBJ, PLY or GLB</source>
        <translation>expórtelo como STL, OBJ, PLY o GLB</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>descomprímalo primero</translation>
    </message>
    <message>
        <source>open the images that it was made from: a DICOM series, NIfTI, NRRD or MetaImage</source>
        <translation>abra las imágenes de las que procede: una serie DICOM, NIfTI, NRRD o MetaImage</translation>
    </message>
    <message>
        <source>save its surface as .vtp, or its image as .mha, in ParaView or 3D Slicer</source>
        <translation>guarde su superficie como .vtp o su imagen como .mha, en ParaView o 3D Slicer</translation>
    </message>
    <message>
        <source>open a file of organs, handles or a sequence</source>
        <translation>abra un archivo de órganos, de tiradores o de una secuencia</translation>
    </message>
    <message>
        <source>save its segmentation and its models in 3D Slicer, and open these</source>
        <translation>guarde su segmentación y sus modelos en 3D Slicer y ábralos</translation>
    </message>
    <message>
        <source>open the files of the organs</source>
        <translation>abra los archivos de los órganos</translation>
    </message>
    <message>
        <source>divide its polygons into triangles in the program that made it, and export it again</source>
        <translation>divida sus polígonos en triángulos en el programa que lo creó y expórtelo de nuevo</translation>
    </message>
    <message numerus="yes">
        <source>%n {polygon that is not flat was|polygons that are not flat were} cut into triangles that overlap</source>
        <translation>
            <numerusform>%n polígono que no es plano se dividió en triángulos que se solapan</numerusform>
            <numerusform>%n polígonos que no son planos se dividieron en triángulos que se solapan</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face|faces} of fewer than three corners left out</source>
        <translation>
            <numerusform>%n cara de menos de tres vértices omitida</numerusform>
            <numerusform>%n caras de menos de tres vértices omitidas</numerusform>
        </translation>
    </message>
    <message>
        <source>the colours in %1 are missing: %2</source>
        <translation>faltan los colores de %1: %2</translation>
    </message>
    <message>
        <source>Its geometry is compressed (%1), which Viscera does not read</source>
        <translation>Su geometría está comprimida (%1), lo que Viscera no lee</translation>
    </message>
    <message>
        <source>export it without compression (in Blender: leave out Data &gt; Compression), or as STL or PLY</source>
        <translation>expórtelo sin compresión (en Blender: sin Data &gt; Compression), o como STL o PLY</translation>
    </message>
    <message>
        <source>save the surfaces as .vtp</source>
        <translation>guarde las superficies como .vtp</translation>
    </message>
    <message>
        <source>It names no surface files</source>
        <translation>No nombra ningún archivo de superficie</translation>
    </message>
    <message numerus="yes">
        <source>%n {block|blocks} without a surface ignored</source>
        <translation>
            <numerusform>%n bloque sin superficie ignorado</numerusform>
            <numerusform>%n bloques sin superficie ignorados</numerusform>
        </translation>
    </message>
    <message>
        <source>a block is at %1, but only files beside it are read</source>
        <translation>un bloque está en %1, pero solo se leen archivos junto a él</translation>
    </message>
    <message>
        <source>the block %1 is no surface and was left out</source>
        <translation>el bloque %1 no es una superficie y se omitió</translation>
    </message>
    <message>
        <source>its block %1 holds blocks of its own in another file</source>
        <translation>su bloque %1 contiene a su vez bloques en otro archivo</translation>
    </message>
    <message>
        <source>its block %1 cannot be read: %2</source>
        <translation>su bloque %1 no se puede leer: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message numerus="yes">
        <source>%n {open part|open parts} that share points were joined to one organ: %2</source>
        <translation>
            <numerusform>%n parte abierta con puntos comunes se unieron en un órgano: %2</numerusform>
            <numerusform>%n partes abiertas con puntos comunes se unieron en un órgano: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It holds %n {organ|organs}: %2</source>
        <translation>
            <numerusform>Contiene %n órgano: %2</numerusform>
            <numerusform>Contiene %n órganos: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>name one of them behind a slash: %1</source>
        <translation>nombre uno de ellos tras una barra: %1</translation>
    </message>
    <message>
        <source>%1 lies inside %2, whose volume contains its volume</source>
        <translation>%1 está dentro de %2, cuyo volumen contiene el suyo</translation>
    </message>
    <message>
        <source>the commas in its numbers may be decimal marks or separate thousands or numbers</source>
        <translation>las comas de sus números pueden ser decimales o separar millares o números</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>expórtelo con puntos decimales</translation>
    </message>
    <message>
        <source>the commas in its numbers were read as decimal marks</source>
        <translation>las comas de sus números se leyeron como decimales</translation>
    </message>
    <message>
        <source>It holds several organs</source>
        <translation>Contiene varios órganos</translation>
    </message>
    <message>
        <source>its voxels are in another folder (%1)</source>
        <translation>sus vóxeles están en otra carpeta (%1)</translation>
    </message>
    <message>
        <source>it is an Analyze 7.5 image, which does not say where it lies: its axes are taken as %1, and left and right may be exchanged</source>
        <translation>es una imagen Analyze 7.5, que no dice dónde está: sus ejes se toman como %1, y la izquierda y la derecha pueden estar intercambiadas</translation>
    </message>
    <message>
        <source>it does not say where it lies; coronal slices of 1 mm are assumed, as FreeSurfer does</source>
        <translation>no dice dónde está; se suponen cortes coronales de 1 mm, como hace FreeSurfer</translation>
    </message>
    <message>
        <source>one of its labels in group %1 has no valid number or image</source>
        <translation>una de sus etiquetas del grupo %1 no tiene número o imagen válidos</translation>
    </message>
    <message>
        <source>its values are not exactly whole numbers; they were rounded to labels, by at most %1</source>
        <translation>sus valores no son exactamente números enteros; se redondearon a etiquetas, en %1 como máximo</translation>
    </message>
    <message>
        <source>It has %1 label maps over time, of which one is needed here</source>
        <translation>Contiene %1 mapas de etiquetas en el tiempo, de los que aquí se necesita uno</translation>
    </message>
    <message>
        <source>It has %1 label maps over time (at %2 ms), of which one is needed here</source>
        <translation>Contiene %1 mapas de etiquetas en el tiempo (a los %2 ms), de los que aquí se necesita uno</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or choose one with --phase, from 0 to %2</source>
        <translation>siga el movimiento por todos con viscera track %1, o elija uno con --phase, de 0 a %2</translation>
    </message>
    <message>
        <source>its segments %1 have the same voxels (label %2 in one layer); they are one organ, %3</source>
        <translation>sus segmentos %1 tienen los mismos vóxeles (etiqueta %2 en una capa); son un solo órgano, %3</translation>
    </message>
    <message>
        <source>the names of its labels are those of FreeSurfer's colour table</source>
        <translation>los nombres de sus etiquetas son los de la tabla de colores de FreeSurfer</translation>
    </message>
    <message>
        <source>It has several layers of one label map, not several phases</source>
        <translation>Contiene varias capas de un mapa de etiquetas, no varias fases</translation>
    </message>
    <message>
        <source>write a .nhdr or .mhd header for it, which says its size</source>
        <translation>escriba para él una cabecera .nhdr o .mhd, que diga su tamaño</translation>
    </message>
    <message>
        <source>a segmentation</source>
        <translation>una segmentación</translation>
    </message>
    <message>
        <source>open the images or the segmentation of the same patient, which are other files</source>
        <translation>abra las imágenes o la segmentación del mismo paciente, que son otros archivos</translation>
    </message>
    <message>
        <source>It is the table of contents of a DICOM medium (DICOMDIR)</source>
        <translation>Es el índice de un soporte DICOM (DICOMDIR)</translation>
    </message>
    <message>
        <source>open the folder that it lists, %1</source>
        <translation>abra la carpeta que describe, %1</translation>
    </message>
    <message>
        <source>open it as a label map</source>
        <translation>ábrala como mapa de etiquetas</translation>
    </message>
    <message>
        <source>open it as a surface</source>
        <translation>ábrala como superficie</translation>
    </message>
    <message>
        <source>It is a DICOM file that holds no scan, label map or surface: %1</source>
        <translation>Es un archivo DICOM sin estudio, mapa de etiquetas ni superficie: %1</translation>
    </message>
    <message>
        <source>an object of an unknown kind</source>
        <translation>un objeto de un tipo desconocido</translation>
    </message>
    <message>
        <source>its pixels are packed in a way that is not supported</source>
        <translation>sus píxeles están comprimidos de una forma no admitida</translation>
    </message>
    <message>
        <source>save it without compression</source>
        <translation>guárdelo sin compresión</translation>
    </message>
    <message>
        <source>It is a segmentation that %1</source>
        <translation>Es una segmentación que %1</translation>
    </message>
    <message>
        <source>its segment 0 (%1) has got the label %2</source>
        <translation>su segmento 0 (%1) ha recibido la etiqueta %2</translation>
    </message>
    <message>
        <source>its fractions are all 0 or 1 of a larger whole; 1 was read as inside</source>
        <translation>sus fracciones son todas 0 o 1 de un total mayor; 1 se ha leído como interior</translation>
    </message>
    <message>
        <source>its pixels of one bit are packed in a way that is not supported (%1)</source>
        <translation>sus píxeles de un bit están comprimidos de una forma no admitida (%1)</translation>
    </message>
    <message>
        <source>It is a DICOM image, not a surface</source>
        <translation>Es una imagen DICOM, no una superficie</translation>
    </message>
    <message>
        <source>make a label map of it first, or open it as one</source>
        <translation>haga primero un mapa de etiquetas con ella, o ábrala como tal</translation>
    </message>
    <message>
        <source>the file does not state its axes: RAS is assumed, as 3D Slicer does</source>
        <translation>el archivo no indica sus ejes: se supone RAS, como hace 3D Slicer</translation>
    </message>
    <message numerus="yes">
        <source>%2 and %n more</source>
        <translation>
            <numerusform>%2 y %n más</numerusform>
            <numerusform>%2 y %n más</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point was|points were} never placed (%2), and there is no other</source>
        <translation>
            <numerusform>%n punto no se colocó nunca (%2), y no hay ningún otro</numerusform>
            <numerusform>%n puntos no se colocaron nunca (%2), y no hay ningún otro</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that was never placed is|points that were never placed are} left out: %2</source>
        <translation>
            <numerusform>%n punto que no se colocó nunca se omite: %2</numerusform>
            <numerusform>%n puntos que no se colocaron nunca se omiten: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds no points, but %1</source>
        <translation>El archivo no contiene puntos, sino %1</translation>
    </message>
    <message>
        <source>copy its control points into a point list in Slicer's module Markups, and save the list</source>
        <translation>copie sus puntos de control en una lista de puntos del módulo Markups de Slicer y guarde la lista</translation>
    </message>
    <message numerus="yes">
        <source>%n {object that the file does not place is|objects that the file does not place are} left out</source>
        <translation>
            <numerusform>%n objeto que el archivo no coloca se omite</numerusform>
            <numerusform>%n objetos que el archivo no coloca se omiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {object that only supports a print is|objects that only support a print are} left out</source>
        <translation>
            <numerusform>%n objeto que solo sostiene una impresión se omite</numerusform>
            <numerusform>%n objetos que solo sostienen una impresión se omiten</numerusform>
        </translation>
    </message>
    <message>
        <source>colours that come from pictures or mixtures are left out</source>
        <translation>los colores que vienen de imágenes o mezclas se omiten</translation>
    </message>
    <message>
        <source>beams and other shapes that are no triangles are left out</source>
        <translation>las vigas y otras formas que no son triángulos se omiten</translation>
    </message>
    <message>
        <source>export it without a password</source>
        <translation>expórtelo sin contraseña</translation>
    </message>
    <message>
        <source>It is a ZIP archive without a 3D model</source>
        <translation>Es un archivo ZIP sin modelo 3D</translation>
    </message>
    <message>
        <source>unpack it and open the files in it</source>
        <translation>descomprímalo y abra los archivos que contiene</translation>
    </message>
    <message>
        <source>the surface is too large for 3MF, whose parts end at 4 GB</source>
        <translation>la superficie es demasiado grande para 3MF, cuyas partes acaban en 4 GB</translation>
    </message>
    <message>
        <source>zlib cannot pack it</source>
        <translation>zlib no puede comprimirla</translation>
    </message>
    <message>
        <source>tetrahedra are written as .inp or .vtu only</source>
        <translation>los tetraedros solo se escriben como .inp o .vtu</translation>
    </message>
    <message>
        <source>the surface %1 is open (%2 boundary edges)</source>
        <translation>la superficie %1 está abierta (%2 aristas de borde)</translation>
    </message>
    <message>
        <source>the surfaces %1 and %2 share points</source>
        <translation>las superficies %1 y %2 comparten puntos</translation>
    </message>
    <message>
        <source>move them apart: there is no tissue between them</source>
        <translation>sepárelas: no hay tejido entre ellas</translation>
    </message>
    <message>
        <source>a cavity is not wholly inside the organ, or inside another cavity</source>
        <translation>una cavidad no está del todo dentro del órgano, o está dentro de otra</translation>
    </message>
    <message>
        <source>leave it out, or make it smaller</source>
        <translation>omítala o hágala más pequeña</translation>
    </message>
    <message>
        <source>It is of gmsh's format %1, which Viscera does not read</source>
        <translation>Es del formato %1 de gmsh, que Viscera no lee</translation>
    </message>
    <message>
        <source>open it with gmsh and save it as version 2 or 4</source>
        <translation>ábralo con gmsh y guárdelo como versión 2 o 4</translation>
    </message>
    <message>
        <source>It is a plane mesh, of two dimensions</source>
        <translation>Es una malla plana, de dos dimensiones</translation>
    </message>
    <message>
        <source>export a mesh of three dimensions</source>
        <translation>exporte una malla de tres dimensiones</translation>
    </message>
    <message>
        <source>openCARP states points in micrometres: its numbers were divided by 1,000</source>
        <translation>openCARP indica los puntos en micrómetros: sus números se han dividido por 1000</translation>
    </message>
    <message>
        <source>%1 has more lines than the %2 points that it states; they were left out</source>
        <translation>%1 tiene más líneas que los %2 puntos que indica; se han omitido</translation>
    </message>
    <message>
        <source>It has elements of the type %1, which Viscera does not read</source>
        <translation>Tiene elementos del tipo %1, que Viscera no lee</translation>
    </message>
    <message>
        <source>save the mesh as tetrahedra</source>
        <translation>guarde la malla como tetraedros</translation>
    </message>
    <message>
        <source>reduce the mesh first</source>
        <translation>reduzca primero la malla</translation>
    </message>
    <message>
        <source>its %1 regions (%2) were joined to one surface around all of them</source>
        <translation>sus %1 regiones (%2) se han unido en una superficie alrededor de todas</translation>
    </message>
    <message numerus="yes">
        <source>%n {cell that repeats|cells that repeat} another left out</source>
        <translation>
            <numerusform>%n celda que repite otra omitida</numerusform>
            <numerusform>%n celdas que repiten otras omitidas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face belongs|faces belong} to more than two cells, which overlap</source>
        <translation>
            <numerusform>%n cara pertenece a más de dos celdas, que se solapan</numerusform>
            <numerusform>%n caras pertenecen a más de dos celdas, que se solapan</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {flat cell that bounds|flat cells that bound} no cell with a volume left out</source>
        <translation>
            <numerusform>%n celda plana que no limita ninguna celda con volumen omitida</numerusform>
            <numerusform>%n celdas planas que no limitan ninguna celda con volumen omitidas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curved {cell was|cells were} read as straight between {its|their} corners</source>
        <translation>
            <numerusform>%n celda curva se ha leído como recta entre sus vértices</numerusform>
            <numerusform>%n celdas curvas se han leído como rectas entre sus vértices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has %n {cavity|cavities}: its volume is that of the wall around {it|them}</source>
        <translation>
            <numerusform>tiene %n cavidad: su volumen es el de la pared que la rodea</numerusform>
            <numerusform>tiene %n cavidades: su volumen es el de la pared que las rodea</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n small {gap|gaps} between its cells filled</source>
        <translation>
            <numerusform>%n pequeño hueco rellenado entre sus celdas</numerusform>
            <numerusform>%n pequeños huecos rellenados entre sus celdas</numerusform>
        </translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Cavidad</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} that CARTO's user has cut away left out</source>
        <translation>
            <numerusform>%n triángulo recortado en CARTO omitido</numerusform>
            <numerusform>%n triángulos recortados en CARTO omitidos</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not say where its scan is: its points stay in FreeSurfer's own coordinates, which may be some millimetres beside the scan</source>
        <translation>no dice dónde está su exploración: sus puntos quedan en las coordenadas propias de FreeSurfer, que pueden estar a unos milímetros de la exploración</translation>
    </message>
    <message>
        <source>It holds values at the points of a surface, such as curvature or thickness, not a surface</source>
        <translation>Contiene valores en los puntos de una superficie, como curvatura o grosor, no una superficie</translation>
    </message>
    <message>
        <source>open the surface to which they belong, such as lh.white or lh.pial</source>
        <translation>abra la superficie a la que pertenecen, como lh.white o lh.pial</translation>
    </message>
    <message>
        <source>its points were moved from FreeSurfer's own coordinates to those of its scan</source>
        <translation>sus puntos se han movido de las coordenadas propias de FreeSurfer a las de su exploración</translation>
    </message>
    <message numerus="yes">
        <source>%n further {surface|surfaces} of the file left out</source>
        <translation>
            <numerusform>%n superficie más del archivo omitida</numerusform>
            <numerusform>%n superficies más del archivo omitidas</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds values at the points of a surface (%1), not a surface</source>
        <translation>Contiene valores en los puntos de una superficie (%1), no una superficie</translation>
    </message>
    <message>
        <source>open the surface to which they belong, which usually ends in .surf.gii</source>
        <translation>abra la superficie a la que pertenecen, que suele terminar en .surf.gii</translation>
    </message>
    <message>
        <source>It holds no surface of triangles</source>
        <translation>No contiene ninguna superficie de triángulos</translation>
    </message>
    <message>
        <source>Its values are in another file, %1, which Viscera does not read</source>
        <translation>Sus valores están en otro archivo, %1, que Viscera no lee</translation>
    </message>
    <message>
        <source>save it with its values inside (GZipBase64Binary)</source>
        <translation>guárdelo con sus valores dentro (GZipBase64Binary)</translation>
    </message>
    <message>
        <source>its points were moved to the scan by the matrix that the file states</source>
        <translation>sus puntos se han movido a la exploración con la matriz que indica el archivo</translation>
    </message>
    <message>
        <source>its matrix from %1 to %2 was not applied</source>
        <translation>su matriz de %1 a %2 no se ha aplicado</translation>
    </message>
    <message>
        <source>save it as %1 with %2</source>
        <translation>guárdelo como %1 con %2</translation>
    </message>
    <message>
        <source>load it in 3D Slicer with its images, convert it to a segmentation there, and save that as .seg.nrrd</source>
        <translation>cárguelo en 3D Slicer con sus imágenes, conviértalo allí en una segmentación y guárdela como .seg.nrrd</translation>
    </message>
    <message>
        <source>It holds %1, not %2</source>
        <translation>El archivo contiene %1, no %2</translation>
    </message>
    <message>
        <source>its unit %1 is not known; mm are assumed</source>
        <translation>su unidad %1 es desconocida; se suponen mm</translation>
    </message>
    <message>
        <source>converted from %1 to mm</source>
        <translation>convertido de %1 a mm</translation>
    </message>
    <message>
        <source>the other file that belongs to it, %1, is not beside it</source>
        <translation>el otro archivo que le corresponde, %1, no está a su lado</translation>
    </message>
    <message>
        <source>this cannot be written as %1</source>
        <translation>esto no se puede escribir como %1</translation>
    </message>
    <message>
        <source>several surfaces cannot be written as %1</source>
        <translation>varias superficies no se pueden escribir como %1</translation>
    </message>
    <message>
        <source>let its name end in %1</source>
        <translation>haga que su nombre termine en %1</translation>
    </message>
    <message>
        <source>rename it to end in %1</source>
        <translation>cámbiele el nombre para que termine en %1</translation>
    </message>
    <message>
        <source>a line</source>
        <translation>una línea</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un ángulo</translation>
    </message>
    <message>
        <source>a curve</source>
        <translation>una curva</translation>
    </message>
    <message>
        <source>a closed curve</source>
        <translation>una curva cerrada</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>un plano</translation>
    </message>
    <message>
        <source>a box (ROI)</source>
        <translation>una caja (ROI)</translation>
    </message>
    <message>
        <source>a markup of another kind</source>
        <translation>una marca de otro tipo</translation>
    </message>
    <message>
        <source>%1 is made for another organ (%2) than this one (%3): its numbers say nothing about it</source>
        <translation>%1 está hecho para otro órgano (%2) y no para este (%3): sus cifras no dicen nada de él</translation>
    </message>
    <message>
        <source>The motion was recorded of another organ (%1) than this one (%2): its numbers say nothing about it</source>
        <translation>El movimiento se registró en otro órgano (%1) y no en este (%2): sus cifras no dicen nada de él</translation>
    </message>
    <message>
        <source>right and left, front and back, head and feet are exchanged: mirrored</source>
        <translation>derecha e izquierda, delante y detrás, cabeza y pies están intercambiados: reflejado</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are right and left: the patient is upside down</source>
        <translation>cabeza y pies están intercambiados, y también derecha e izquierda: el paciente está boca abajo</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, unless head and feet are exchanged too</source>
        <translation>derecha e izquierda están intercambiadas, delante y detrás no: reflejado, salvo que también lo estén cabeza y pies</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, or situs inversus</source>
        <translation>derecha e izquierda están intercambiadas, delante y detrás no: reflejado, o situs inversus</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are front and back: the patient is upside down</source>
        <translation>cabeza y pies están intercambiados, y también delante y detrás: el paciente está boca abajo</translation>
    </message>
    <message>
        <source>head and feet are exchanged: the patient is upside down, or mirrored</source>
        <translation>cabeza y pies están intercambiados: el paciente está boca abajo o reflejado</translation>
    </message>
    <message>
        <source>head and feet are exchanged, front and back are not: the slices seem to be in the opposite order, which mirrors the patient</source>
        <translation>cabeza y pies están intercambiados, delante y detrás no: los cortes parecen estar en orden inverso, lo que refleja al paciente</translation>
    </message>
    <message>
        <source>front and back are exchanged: the files may be in RAS, mirrored, or upside down</source>
        <translation>delante y detrás están intercambiados: los archivos pueden estar en RAS, reflejados o boca abajo</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored, unless head and feet are exchanged too</source>
        <translation>delante y detrás están intercambiados, derecha e izquierda no: reflejado, salvo que también lo estén cabeza y pies</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored</source>
        <translation>delante y detrás están intercambiados, derecha e izquierda no: reflejado</translation>
    </message>
    <message>
        <source>the head lies along the y axis: the files seem to come from a program in which y is up</source>
        <translation>la cabeza está a lo largo del eje y: los archivos parecen venir de un programa en el que y apunta hacia arriba</translation>
    </message>
    <message>
        <source>the organs do not lie as in a body whose axes are LPS: other axes, or not of one patient</source>
        <translation>los órganos no están como en un cuerpo con los ejes LPS: otros ejes, o no son de un mismo paciente</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on that side, but the others lie on the side opposite to the usual one: situs inversus, or wrong names</source>
        <translation>los órganos cuyo nombre dice izquierda o derecha están en ese lado, pero los demás están en el lado opuesto al habitual: situs inversus, o nombres equivocados</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on the opposite side, but the others lie as usual: left and right seem to be exchanged in the names</source>
        <translation>los órganos cuyo nombre dice izquierda o derecha están en el lado opuesto, pero los demás están como es habitual: izquierda y derecha parecen intercambiadas en los nombres</translation>
    </message>
    <message numerus="yes">
        <source>by the other organs, %n {organ lies|organs lie} on the opposite side of the patient: %2</source>
        <translation>
            <numerusform>según los demás órganos, %n órgano está en el lado opuesto del paciente: %2</numerusform>
            <numerusform>según los demás órganos, %n órganos están en el lado opuesto del paciente: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: the coordinates seem to be in %2</source>
        <translation>por sus volúmenes, todos los órganos son %1 veces el tamaño natural: las coordenadas parecen estar en %2</translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: a child, an atlas that is not life-sized, or another unit</source>
        <translation>por sus volúmenes, todos los órganos son %1 veces el tamaño natural: un niño, un atlas que no es de tamaño natural, u otra unidad</translation>
    </message>
    <message>
        <source>among the other organs it lies on the side that its name says</source>
        <translation>entre los demás órganos está en el lado que dice su nombre</translation>
    </message>
    <message>
        <source>turns the surface by a quarter and a half turn, from a model in RAS whose y axis points to the head</source>
        <translation>gira la superficie un cuarto y media vuelta, desde un modelo en RAS cuyo eje y apunta a la cabeza</translation>
    </message>
    <message>
        <source>exchanges front and back, which mirrors the surface</source>
        <translation>intercambia delante y detrás, lo que refleja la superficie</translation>
    </message>
    <message>
        <source>exchanges head and feet, which mirrors the surface</source>
        <translation>intercambia cabeza y pies, lo que refleja la superficie</translation>
    </message>
    <message>
        <source>exchanges head and feet, and front and back, by half a turn</source>
        <translation>intercambia cabeza y pies, y delante y detrás, con media vuelta</translation>
    </message>
    <message>
        <source>exchanges head and feet, and right and left, by half a turn</source>
        <translation>intercambia cabeza y pies, y derecha e izquierda, con media vuelta</translation>
    </message>
    <message>
        <source>exchanges all three directions, which mirrors the surface</source>
        <translation>intercambia las tres direcciones, lo que refleja la superficie</translation>
    </message>
    <message>
        <source>Convert from Y up and RAS to LPS</source>
        <translation>Convertir de Y hacia arriba y RAS a LPS</translation>
    </message>
    <message>
        <source>Mirror front and back</source>
        <translation>Reflejar delante y detrás</translation>
    </message>
    <message>
        <source>Mirror head and feet</source>
        <translation>Reflejar cabeza y pies</translation>
    </message>
    <message>
        <source>Turn head and feet, front and back</source>
        <translation>Girar cabeza y pies, delante y detrás</translation>
    </message>
    <message>
        <source>Turn head and feet, right and left</source>
        <translation>Girar cabeza y pies, derecha e izquierda</translation>
    </message>
    <message>
        <source>Mirror all three directions</source>
        <translation>Reflejar las tres direcciones</translation>
    </message>
    <message numerus="yes">
        <source>is cut by {the %2 edge|%n edges (%2)} of the image: its volume is too small</source>
        <translation>
            <numerusform>está cortado por el borde %2 de la imagen: su volumen es demasiado pequeño</numerusform>
            <numerusform>está cortado por %n bordes (%2) de la imagen: su volumen es demasiado pequeño</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reaches {the %2 edge|%n edges (%2)} of the image, which may cut it off</source>
        <translation>
            <numerusform>alcanza el borde %2 de la imagen, que puede cortarlo</numerusform>
            <numerusform>alcanza %n bordes (%2) de la imagen, que puede cortarlo</numerusform>
        </translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecho</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierdo</translation>
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
        <translation>No hay órganos cuyas coordenadas se puedan convertir</translation>
    </message>
    <message>
        <source>open some first</source>
        <translation>abra alguno primero</translation>
    </message>
    <message>
        <source>Convert between RAS and LPS</source>
        <translation>Convertir entre RAS y LPS</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Reflejar izquierda y derecha</translation>
    </message>
    <message>
        <source>Convert the unit</source>
        <translation>Convertir la unidad</translation>
    </message>
    <message>
        <source>Convert the axes</source>
        <translation>Convertir los ejes</translation>
    </message>
    <message>
        <source>converted after the import: %1</source>
        <translation>convertido después de importar: %1</translation>
    </message>
    <message>
        <source>Scale by %1</source>
        <translation>Escalar por %1</translation>
    </message>
    <message>
        <source>scaled after the import by %1</source>
        <translation>escalado después de importar por %1</translation>
    </message>
    <message>
        <source>All organs together: %1.</source>
        <translation>Todos los órganos juntos: %1.</translation>
    </message>
    <message>
        <source>RAS or mirrored</source>
        <translation>RAS o reflejado</translation>
    </message>
    <message>
        <source>head and feet exchanged</source>
        <translation>cabeza y pies intercambiados</translation>
    </message>
    <message>
        <source>Only partly possible: %1</source>
        <translation>Solo es posible en parte: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Secuencias</translation>
    </message>
    <message>
        <source>All %1 slices were resampled to a distance of %2 mm; values between two slices are mixed from both</source>
        <translation>Los %1 cortes se remuestrearon a una distancia de %2 mm; los valores entre dos cortes son una mezcla de ambos</translation>
    </message>
    <message>
        <source>It does not say how thick its slice is; 1 mm is assumed, so volumes in it are not measured</source>
        <translation>No dice qué grosor tiene su corte; se supone 1 mm, por lo que sus volúmenes no están medidos</translation>
    </message>
    <message>
        <source>It does not say how large its pixels are; %1 mm were taken from its field of view, so check a length that you know</source>
        <translation>No dice qué tamaño tienen sus píxeles; se tomaron %1 mm de su campo de visión, así que compruebe una longitud conocida</translation>
    </message>
    <message>
        <source>none of the %1 pieces is as small as that</source>
        <translation>ninguno de los %1 trozos es tan pequeño</translation>
    </message>
    <message numerus="yes">
        <source>%n of %2 pieces {goes|go}, of %3 mm and %4 ml at most</source>
        <translation>
            <numerusform>desaparece %n de %2 trozos, de %3 mm y %4 ml como máximo</numerusform>
            <numerusform>desaparecen %n de %2 trozos, de %3 mm y %4 ml como máximo</numerusform>
        </translation>
    </message>
    <message>
        <source>drops the pieces that are smaller than a size; the largest one stays</source>
        <translation>elimina los trozos menores que un tamaño; el mayor se queda</translation>
    </message>
    <message>
        <source>multiplies all coordinates by a factor</source>
        <translation>multiplica todas las coordenadas por un factor</translation>
    </message>
    <message>
        <source>details of %1 mm take too much memory; %2 mm is the finest for its size</source>
        <translation>los detalles de %1 mm ocupan demasiada memoria; %2 mm es lo más fino para su tamaño</translation>
    </message>
    <message>
        <source>choose a coarser resolution</source>
        <translation>elija una resolución más gruesa</translation>
    </message>
    <message>
        <source>remeshing lost a detail: the old surface lies up to %1 mm from the new one</source>
        <translation>el remallado perdió un detalle: la superficie antigua está hasta a %1 mm de la nueva</translation>
    </message>
    <message>
        <source>the handles cannot move by exactly %1 mm: %2</source>
        <translation>los tiradores no pueden moverse exactamente %1 mm: %2</translation>
    </message>
    <message>
        <source>move less far, or let more handles compensate</source>
        <translation>mueva menos, o deje que compensen más tiradores</translation>
    </message>
    <message>
        <source>This organ does not bend, so its tissue has no stress; let it bend as soft tissue</source>
        <translation>Este órgano no se dobla, así que su tejido no tiene estrés; deje que se doble como tejido blando</translation>
    </message>
    <message>
        <source>Move as a rigid body</source>
        <translation>Mover como cuerpo rígido</translation>
    </message>
    <message>
        <source>Keep in place</source>
        <translation>Mantener en su sitio</translation>
    </message>
    <message>
        <source>Bend as soft tissue</source>
        <translation>Doblar como tejido blando</translation>
    </message>
    <message>
        <source>Measure the distance of organs</source>
        <translation>Medir la distancia de órganos</translation>
    </message>
    <message>
        <source>The shortest distance is between two organs</source>
        <translation>La distancia más corta es entre dos órganos</translation>
    </message>
    <message>
        <source>select two organs</source>
        <translation>seleccione dos órganos</translation>
    </message>
    <message>
        <source>shortest distance</source>
        <translation>distancia más corta</translation>
    </message>
    <message>
        <source>There are %1 witness points of %2: the others would lie in cavities, which hold no tissue.</source>
        <translation>Hay %1 puntos testigo de %2: los demás quedarían en cavidades, que no contienen tejido.</translation>
    </message>
    <message>
        <source>The largest angle by which a direction is turned when the tissue is stretched; not a pressure.</source>
        <translation>El mayor ángulo que gira una dirección al estirarse el tejido; no es una presión.</translation>
    </message>
    <message>
        <source>The volume of tissue now, as a part of that at rest; 1 is unchanged.</source>
        <translation>El volumen del tejido ahora, respecto al de reposo; 1 es sin cambio.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that grows most.</source>
        <translation>La longitud del tejido ahora, respecto a la de reposo, en la dirección que más crece.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that shrinks most.</source>
        <translation>La longitud del tejido ahora, respecto a la de reposo, en la dirección que más encoge.</translation>
    </message>
    <message>
        <source>1 where the tissue is turned inside out.</source>
        <translation>1 donde el tejido está vuelto del revés.</translation>
    </message>
    <message>
        <source>global longitudinal strain</source>
        <translation>deformación longitudinal global</translation>
    </message>
    <message>
        <source>global circumferential strain</source>
        <translation>deformación circunferencial global</translation>
    </message>
    <message>
        <source>global radial strain</source>
        <translation>deformación radial global</translation>
    </message>
    <message>
        <source>67 healthy adults, by feature tracking in magnetic resonance over the whole ventricle (CVI42); other programs differ by several points</source>
        <translation>67 adultos sanos, por seguimiento de rasgos en resonancia magnética de todo el ventrículo (CVI42); otros programas difieren en varios puntos</translation>
    </message>
    <message>
        <source>The surface encloses nothing</source>
        <translation>La superficie no encierra nada</translation>
    </message>
    <message>
        <source>choose the surface of its cavity</source>
        <translation>elija la superficie de su cavidad</translation>
    </message>
    <message>
        <source>The base and the apex are the same place</source>
        <translation>La base y el ápex son el mismo lugar</translation>
    </message>
    <message>
        <source>choose two other points</source>
        <translation>elija otros dos puntos</translation>
    </message>
    <message>
        <source>The insertion of the right ventricle lies on the long axis</source>
        <translation>La inserción del ventrículo derecho está en el eje largo</translation>
    </message>
    <message>
        <source>choose a point of the wall</source>
        <translation>elija un punto de la pared</translation>
    </message>
    <message>
        <source>The wall cannot be divided into layers</source>
        <translation>La pared no se puede dividir en capas</translation>
    </message>
    <message>
        <source>use fewer witness points</source>
        <translation>use menos puntos testigo</translation>
    </message>
    <message>
        <source>The tissue does not reach from the cavity to the outer surface</source>
        <translation>El tejido no llega de la cavidad a la superficie exterior</translation>
    </message>
    <message>
        <source>choose the surfaces of one heart</source>
        <translation>elija las superficies de un mismo corazón</translation>
    </message>
    <message>
        <source>name one of the surfaces of the heart</source>
        <translation>nombre una de las superficies del corazón</translation>
    </message>
    <message>
        <source>There is no phase %1</source>
        <translation>No hay ninguna fase %1</translation>
    </message>
    <message>
        <source>phases are counted from 1 to %1</source>
        <translation>las fases se cuentan de 1 a %1</translation>
    </message>
    <message>
        <source>layers of the wall</source>
        <translation>capas de la pared</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>deformación</translation>
    </message>
    <message>
        <source>surfaces in motion</source>
        <translation>superficies en movimiento</translation>
    </message>
    <message>
        <source>No surface is a left ventricle by its name</source>
        <translation>Ninguna superficie es por su nombre un ventrículo izquierdo</translation>
    </message>
    <message>
        <source>name its cavity with --lv</source>
        <translation>nombre su cavidad con --lv</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>hay: %1</translation>
    </message>
    <message>
        <source>It holds no organ</source>
        <translation>No contiene ningún órgano</translation>
    </message>
    <message>
        <source>name one with --organ</source>
        <translation>nombre uno con --organ</translation>
    </message>
    <message>
        <source>Without the right ventricle the numbers of segments mean nothing: give its surface, or a point where it meets the left one in front</source>
        <translation>Sin el ventrículo derecho los números de los segmentos no significan nada: dé su superficie, o un punto donde se une al izquierdo por delante</translation>
    </message>
    <message>
        <source>Material points are not known in this motion: lengths of contours can be read, segments cannot</source>
        <translation>En este movimiento no se conocen los puntos materiales: se pueden leer longitudes de contornos, no los segmentos</translation>
    </message>
    <message>
        <source>The left ventricle is fullest in phase %1, and strain is measured from phase %2</source>
        <translation>El ventrículo izquierdo está más lleno en la fase %1, y la deformación se mide desde la fase %2</translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} too few points to be read</source>
        <translation>
            <numerusform>%n segmento tiene demasiado pocos puntos para leerse</numerusform>
            <numerusform>%n segmentos tienen demasiado pocos puntos para leerse</numerusform>
        </translation>
    </message>
    <message>
        <source>see docs/strain.md for the form of such a file</source>
        <translation>vea docs/strain.md para la forma de tal archivo</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Contracción isovolumétrica</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Relajación isovolumétrica</translation>
    </message>
    <message>
        <source>Ejection time</source>
        <translation>Tiempo de eyección</translation>
    </message>
    <message>
        <source>Aorta, in exercise</source>
        <translation>Aorta, en ejercicio</translation>
    </message>
    <message>
        <source>Left atrium, in exercise</source>
        <translation>Aurícula izquierda, en ejercicio</translation>
    </message>
    <message>
        <source>Aortic valve, in exercise</source>
        <translation>Válvula aórtica, en ejercicio</translation>
    </message>
    <message>
        <source>highest pressure (a wave)</source>
        <translation>presión más alta (onda a)</translation>
    </message>
    <message>
        <source>healthy adults at peak exercise</source>
        <translation>adultos sanos en el ejercicio máximo</translation>
    </message>
    <message>
        <source>62 healthy people, wedge pressure; some of the oldest exceed it</source>
        <translation>62 personas sanas, presión de enclavamiento; algunas de las mayores la superan</translation>
    </message>
    <message>
        <source>healthy adults: the limit at rest is kept</source>
        <translation>adultos sanos: se mantiene el límite en reposo</translation>
    </message>
    <message>
        <source>textbooks; percentiles of 2917 people: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</source>
        <translation>manuales; percentiles de 2917 personas: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</translation>
    </message>
    <message>
        <source>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</source>
        <translation>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</translation>
    </message>
    <message>
        <source>as at rest; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>como en reposo; sin estenosis hasta 2,5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>customary at the bedside, for the 1 to 1.7 m/s of a healthy valve; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>habitual en la clínica, para los 1 a 1,7 m/s de una válvula sana; sin estenosis hasta 2,5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>none or a trace, which normal valves often have: doi 10.1378/chest.103.1.226</source>
        <translation>ninguna o una traza, que las válvulas normales tienen a menudo: doi 10.1378/chest.103.1.226</translation>
    </message>
    <message>
        <source>between the contractions of both, shorter than the PR interval of 0.12 to 0.20 s</source>
        <translation>entre las contracciones de ambos, más corto que el intervalo PR de 0,12 a 0,20 s</translation>
    </message>
    <message>
        <source>Tricuspid valve</source>
        <translation>Válvula tricúspide</translation>
    </message>
    <message>
        <source>Pulmonary valve</source>
        <translation>Válvula pulmonar</translation>
    </message>
    <message>
        <source>Longitudinal strain</source>
        <translation>Deformación longitudinal</translation>
    </message>
    <message>
        <source>Circumferential strain</source>
        <translation>Deformación circunferencial</translation>
    </message>
    <message>
        <source>Radial strain</source>
        <translation>Deformación radial</translation>
    </message>
    <message>
        <source>Difference of both</source>
        <translation>Diferencia de ambas</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Deformación (strain)</translation>
    </message>
    <message>
        <source>Strain (%)</source>
        <translation>Deformación (%)</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Valor pico</translation>
    </message>
    <message>
        <source>At this instant</source>
        <translation>En este instante</translation>
    </message>
    <message>
        <source>Time to peak</source>
        <translation>Tiempo hasta el pico</translation>
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
        <translation>medio</translation>
    </message>
    <message>
        <source>apex</source>
        <translation>ápex</translation>
    </message>
    <message>
        <source>%1 %2 % at %3 ms (healthy adults %4 to %5)</source>
        <translation>%1 %2 % a los %3 ms (adultos sanos: de %4 a %5)</translation>
    </message>
    <message>
        <source>&amp;Strain of the wall</source>
        <translation>Defor&amp;mación de la pared</translation>
    </message>
    <message>
        <source>Se&amp;gments on the organ</source>
        <translation>&amp;Segmentos en el órgano</translation>
    </message>
    <message>
        <source>Expo&amp;rt strain...</source>
        <translation>Expo&amp;rtar deformación...</translation>
    </message>
    <message>
        <source>Strain needs the cavity of a left ventricle, by its name, that follows the handles.</source>
        <translation>La deformación necesita la cavidad de un ventrículo izquierdo, por su nombre, que siga a los tiradores.</translation>
    </message>
    <message>
        <source>The strain is drawn here as soon as it is measured.</source>
        <translation>La deformación se dibuja aquí en cuanto se mide.</translation>
    </message>
    <message>
        <source>GLS and GCS are the change of the length of contours of the endocardium, as ultrasound and feature tracking report it. GRS and the segments are the strain of the material at witness points of the wall. Shortening is negative. All are against the end of diastole. Values of single segments are poorly repeated between programs: hatched ones are not to be relied on.</source>
        <translation>GLS y GCS son el cambio de longitud de contornos del endocardio, como los dan la ecografía y el feature tracking. GRS y los segmentos son la deformación del material en puntos testigo de la pared. El acortamiento es negativo. Todo se refiere al final de la diástole. Los valores de segmentos sueltos se reproducen mal entre programas: no hay que fiarse de los rayados.</translation>
    </message>
    <message>
        <source>left ventricle</source>
        <translation>ventrículo izquierdo</translation>
    </message>
    <message>
        <source>hatched: uncertain</source>
        <translation>rayado: incierto</translation>
    </message>
    <message numerus="yes">
        <source>In %n {segment|segments} the fit of the motion leaves a peak less certain than its distance from the range of healthy adults</source>
        <translation>
            <numerusform>En %n segmento el ajuste del movimiento deja un pico más incierto que su distancia al intervalo de los adultos sanos</numerusform>
            <numerusform>En %n segmentos el ajuste del movimiento deja un pico más incierto que su distancia al intervalo de los adultos sanos</numerusform>
        </translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Paciente</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>Fecha del estudio</translation>
    </message>
    <message>
        <source>Sinoatrial node</source>
        <translation>Nodo sinoauricular</translation>
    </message>
    <message>
        <source>Anterior internodal pathway</source>
        <translation>Vía internodal anterior</translation>
    </message>
    <message>
        <source>Middle internodal pathway</source>
        <translation>Vía internodal media</translation>
    </message>
    <message>
        <source>Posterior internodal pathway</source>
        <translation>Vía internodal posterior</translation>
    </message>
    <message>
        <source>Bachmann&apos;s bundle</source>
        <translation>Haz de Bachmann</translation>
    </message>
    <message>
        <source>Left atrial muscle</source>
        <translation>Músculo de la aurícula izquierda</translation>
    </message>
    <message>
        <source>Atrioventricular node</source>
        <translation>Nodo auriculoventricular</translation>
    </message>
    <message>
        <source>Bundle of His</source>
        <translation>Haz de His</translation>
    </message>
    <message>
        <source>Left bundle branch</source>
        <translation>Rama izquierda del haz de His</translation>
    </message>
    <message>
        <source>Left anterior fascicle</source>
        <translation>Fascículo anterior izquierdo</translation>
    </message>
    <message>
        <source>Left posterior fascicle</source>
        <translation>Fascículo posterior izquierdo</translation>
    </message>
    <message>
        <source>Left septal fascicle</source>
        <translation>Fascículo septal izquierdo</translation>
    </message>
    <message>
        <source>Right bundle branch</source>
        <translation>Rama derecha del haz de His</translation>
    </message>
    <message>
        <source>Purkinje fibres</source>
        <translation>Fibras de Purkinje</translation>
    </message>
    <message>
        <source>Cardial notch</source>
        <translation>Incisura del cardias</translation>
    </message>
    <message>
        <source>Angular incisure</source>
        <translation>Incisura angular</translation>
    </message>
    <message>
        <source>Greater omentum</source>
        <translation>Omento mayor</translation>
    </message>
    <message>
        <source>Diaphragmatic surface</source>
        <translation>Cara diafragmática</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Hilio</translation>
    </message>
    <message>
        <source>Superior border</source>
        <translation>Borde superior</translation>
    </message>
    <message>
        <source>Anterior end</source>
        <translation>Extremo anterior</translation>
    </message>
    <message>
        <source>Posterior end</source>
        <translation>Extremo posterior</translation>
    </message>
    <message>
        <source>name its cavity&apos;s file LV</source>
        <translation>dé al archivo de su cavidad el nombre LV</translation>
    </message>
    <message numerus="yes">
        <source>%n {key|keys}</source>
        <translation>
            <numerusform>%n fotograma clave</numerusform>
            <numerusform>%n fotogramas clave</numerusform>
        </translation>
    </message>
    <message>
        <source>the first at %1 s, the last at %2 s</source>
        <translation>el primero a los %1 s, el último a los %2 s</translation>
    </message>
    <message>
        <source>the shape of the first of %1 files of its motion; the last one is %2</source>
        <translation>la forma del primero de %1 archivos de su movimiento; el último es %2</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume in one place and swollen to %2 % in another. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>El tejido está comprimido al %1 % de su volumen en un lugar e hinchado al %2 % en otro. El tejido vivo, sobre todo agua, apenas cambia de volumen; las coordenadas no lo saben. Un movimiento menor, más tiradores o un volumen bloqueado ayudan.</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>El tejido está comprimido al %1 % de su volumen. El tejido vivo, sobre todo agua, apenas cambia de volumen; las coordenadas no lo saben. Un movimiento menor, más tiradores o un volumen bloqueado ayudan.</translation>
    </message>
    <message>
        <source>Tissue is swollen to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>El tejido está hinchado al %1 % de su volumen. El tejido vivo, sobre todo agua, apenas cambia de volumen; las coordenadas no lo saben. Un movimiento menor, más tiradores o un volumen bloqueado ayudan.</translation>
    </message>
    <message>
        <source>Chordae tendineae</source>
        <translation>Cuerdas tendinosas</translation>
    </message>
    <message>
        <source>Left main coronary artery</source>
        <translation>Tronco de la arteria coronaria izquierda</translation>
    </message>
    <message>
        <source>Circumflex artery</source>
        <translation>Arteria circunfleja</translation>
    </message>
    <message>
        <source>Diagonal branch</source>
        <translation>Rama diagonal</translation>
    </message>
    <message>
        <source>Septal branches</source>
        <translation>Ramas septales</translation>
    </message>
    <message>
        <source>Intermediate branch</source>
        <translation>Rama intermedia</translation>
    </message>
    <message>
        <source>Right ventricular branch</source>
        <translation>Rama ventricular derecha</translation>
    </message>
    <message>
        <source>Conus branch</source>
        <translation>Rama del cono</translation>
    </message>
    <message>
        <source>Left marginal branch</source>
        <translation>Rama marginal izquierda</translation>
    </message>
    <message>
        <source>Right marginal branch</source>
        <translation>Rama marginal derecha</translation>
    </message>
    <message>
        <source>Posterolateral branch</source>
        <translation>Rama posterolateral</translation>
    </message>
    <message>
        <source>Posterior descending artery</source>
        <translation>Arteria descendente posterior</translation>
    </message>
    <message>
        <source>Sinoatrial nodal branch</source>
        <translation>Rama del nódulo sinusal</translation>
    </message>
    <message>
        <source>Great cardiac vein</source>
        <translation>Vena cardíaca mayor</translation>
    </message>
    <message>
        <source>Middle cardiac vein</source>
        <translation>Vena cardíaca media</translation>
    </message>
    <message>
        <source>Posterior vein of the left ventricle</source>
        <translation>Vena posterior del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Coronary sinus</source>
        <translation>Seno coronario</translation>
    </message>
    <message>
        <source>geometric mean (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) of the systolic and diastolic bounds, 73 to 98 mmHg, rounded</source>
        <translation>media geométrica (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) de los límites sistólicos y diastólicos, de 73 a 98 mmHg, redondeada</translation>
    </message>
    <message>
        <source>short axis</source>
        <translation>eje corto</translation>
    </message>
    <message>
        <source>long axis</source>
        <translation>eje largo</translation>
    </message>
    <message>
        <source>other plane</source>
        <translation>otro plano</translation>
    </message>
    <message>
        <source>2-chamber</source>
        <translation>2 cámaras</translation>
    </message>
    <message>
        <source>3-chamber</source>
        <translation>3 cámaras</translation>
    </message>
    <message>
        <source>4-chamber</source>
        <translation>4 cámaras</translation>
    </message>
    <message>
        <source>It has no images over a heart&apos;s cycle</source>
        <translation>No contiene imágenes a lo largo de un ciclo cardíaco</translation>
    </message>
    <message>
        <source>name the folder of a cine study, or a file with volumes over time</source>
        <translation>indique la carpeta de un estudio de cine o un archivo con volúmenes en el tiempo</translation>
    </message>
    <message>
        <source>It has changed since it was opened</source>
        <translation>Ha cambiado desde que se abrió</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>ábralo de nuevo</translation>
    </message>
    <message>
        <source>It does not say how long the heart&apos;s cycle is; its phases are spread over one</source>
        <translation>No indica cuánto dura el ciclo cardíaco; sus fases se reparten en uno</translation>
    </message>
    <message>
        <source>It has the images of %1 patients: &quot;%2&quot; and &quot;%3&quot; are of two</source>
        <translation>Contiene las imágenes de %1 pacientes: «%2» y «%3» son de dos de ellos</translation>
    </message>
    <message>
        <source>Series %1 shows the same place as series %2, and stands in for it in the stack</source>
        <translation>La serie %1 muestra el mismo lugar que la serie %2 y la sustituye en la pila</translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 to %4 mm between them, in which nothing was seen</source>
        <translation>Los %1 cortes de una pila (%2) dejan entre sí huecos de %3 a %4 mm, en los que no se vio nada</translation>
    </message>
    <message>
        <source>Series %1 and %2 are %3 mm apart, other slices of the stack %4 mm: a slice between them may be missing</source>
        <translation>Las series %1 y %2 están a %3 mm, otros cortes de la pila a %4 mm: quizá falte un corte entre ellas</translation>
    </message>
    <message numerus="yes">
        <source>%n {phase|phases} of series %2 {is|are} missing: %3 of %4 (the first is 0)</source>
        <translation>
            <numerusform>Falta %n fase de la serie %2: %3 de %4 (la primera es 0)</numerusform>
            <numerusform>Faltan %n fases de la serie %2: %3 de %4 (la primera es 0)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of series %2 {has|have} the time of another one and {is|are} left out</source>
        <translation>
            <numerusform>%n imagen de la serie %2 tiene el instante de otra y se omite</numerusform>
            <numerusform>%n imágenes de la serie %2 tienen el instante de otra y se omiten</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1 states a cycle of %2 ms, which is shorter than its phases; %3 ms were taken from their distance</source>
        <translation>La serie %1 indica un ciclo de %2 ms, más corto que sus fases; de la distancia entre ellas se tomaron %3 ms</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out, phase %2 of series %3 (%4)</source>
        <translation>«%1» está dañado y se omite, fase %2 de la serie %3 (%4)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out (%2)</source>
        <translation>«%1» está dañado y se omite (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n other {file is|files are} damaged and left out</source>
        <translation>
            <numerusform>%n archivo más está dañado y se omite</numerusform>
            <numerusform>%n archivos más están dañados y se omiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of another study left out (series %2)</source>
        <translation>
            <numerusform>%n corte de otro estudio omitido (serie %2)</numerusform>
            <numerusform>%n cortes de otro estudio omitidos (serie %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of the study in another frame of reference left out (series %2)</source>
        <translation>
            <numerusform>%n corte del estudio en otro sistema de referencia omitido (serie %2)</numerusform>
            <numerusform>%n cortes del estudio en otro sistema de referencia omitidos (serie %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {series|series} without the phases of a heart&apos;s cycle left out: %2</source>
        <translation>
            <numerusform>%n serie sin las fases de un ciclo cardíaco omitida: %2</numerusform>
            <numerusform>%n series sin las fases de un ciclo cardíaco omitidas: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 mm between them, in which nothing was seen</source>
        <translation>Los %1 cortes de una pila (%2) dejan entre sí huecos de %3 mm, en los que no se vio nada</translation>
    </message>
    <message>
        <source>The directions of its rows and columns are not perpendicular</source>
        <translation>Las direcciones de sus filas y columnas no son perpendiculares</translation>
    </message>
    <message>
        <source>export the series again</source>
        <translation>exporte la serie de nuevo</translation>
    </message>
    <message>
        <source>The size of its pixels is unknown</source>
        <translation>Se desconoce el tamaño de sus píxeles</translation>
    </message>
    <message>
        <source>It has no image, or images without times</source>
        <translation>No tiene imagen, o tiene imágenes sin tiempos</translation>
    </message>
    <message>
        <source>The time of image %1 is not after the one before, within one cycle</source>
        <translation>El tiempo de la imagen %1 no es posterior al anterior dentro de un ciclo</translation>
    </message>
    <message>
        <source>Image %1 has another size than the first</source>
        <translation>La imagen %1 tiene otro tamaño que la primera</translation>
    </message>
    <message>
        <source>Image %1 has grey values that are no numbers</source>
        <translation>La imagen %1 tiene niveles de gris que no son números</translation>
    </message>
    <message>
        <source>One labelled phase is too few for the motion between two</source>
        <translation>Una fase etiquetada es poco para el movimiento entre dos</translation>
    </message>
    <message>
        <source>label the end of diastole and the end of systole</source>
        <translation>etiquete el final de la diástole y el final de la sístole</translation>
    </message>
    <message>
        <source>phases are 0 to %1</source>
        <translation>las fases van de 0 a %1</translation>
    </message>
    <message>
        <source>Phase %1 has labels twice</source>
        <translation>La fase %1 está etiquetada dos veces</translation>
    </message>
    <message>
        <source>name each phase once</source>
        <translation>nombre cada fase una sola vez</translation>
    </message>
    <message>
        <source>following the tissue</source>
        <translation>siguiendo el tejido</translation>
    </message>
    <message>
        <source>fitting the images</source>
        <translation>ajustando a las imágenes</translation>
    </message>
    <message>
        <source>Terminal crest</source>
        <translation>Cresta terminal</translation>
    </message>
    <message>
        <source>From one labelled phase only a whole cycle can be followed</source>
        <translation>A partir de una sola fase etiquetada solo se puede seguir un ciclo completo</translation>
    </message>
    <message>
        <source>label the last phase as well</source>
        <translation>etiquete también la última fase</translation>
    </message>
    <message>
        <source>No phase has labels</source>
        <translation>Ninguna fase tiene etiquetas</translation>
    </message>
    <message>
        <source>give those of the ends of diastole and systole, as in --phase 0=ed.nrrd --phase 9=es.nrrd</source>
        <translation>indique las del final de la diástole y de la sístole, como en --phase 0=ed.nrrd --phase 9=es.nrrd</translation>
    </message>
    <message>
        <source>The images have no phase %1</source>
        <translation>Las imágenes no tienen la fase %1</translation>
    </message>
    <message>
        <source>their phases are 0 to %1</source>
        <translation>sus fases van de 0 a %1</translation>
    </message>
    <message>
        <source>reading the images</source>
        <translation>leyendo las imágenes</translation>
    </message>
    <message>
        <source>The images have no series %1</source>
        <translation>Las imágenes no tienen la serie %1</translation>
    </message>
    <message>
        <source>viscera info lists the series of a study</source>
        <translation>viscera info enumera las series de un estudio</translation>
    </message>
    <message>
        <source>No image shows what is labelled: the labels seem to be in RAS where the images are in LPS</source>
        <translation>Ninguna imagen muestra lo etiquetado: las etiquetas parecen estar en RAS y las imágenes en LPS</translation>
    </message>
    <message>
        <source>No image shows what is labelled: it lies beside all planes, or outside their pictures</source>
        <translation>Ninguna imagen muestra lo etiquetado: queda al lado de todos los planos o fuera de sus imágenes</translation>
    </message>
    <message>
        <source>take labels and images of one patient and one study, in the same axes</source>
        <translation>use etiquetas e imágenes de un mismo paciente y estudio, en los mismos ejes</translation>
    </message>
    <message numerus="yes">
        <source>%n {plane|planes} of the study {does|do} not cross what is labelled</source>
        <translation>
            <numerusform>%n plano del estudio no corta lo etiquetado</numerusform>
            <numerusform>%n planos del estudio no cortan lo etiquetado</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} nearer than 4 mm to the one before {is|are} not used</source>
        <translation>
            <numerusform>%n corte a menos de 4 mm del anterior no se usa</numerusform>
            <numerusform>%n cortes a menos de 4 mm del anterior no se usan</numerusform>
        </translation>
    </message>
    <message>
        <source>Phase %1 has no labels</source>
        <translation>La fase %1 no tiene etiquetas</translation>
    </message>
    <message>
        <source>as in --phase 0=ed.nrrd</source>
        <translation>como en --phase 0=ed.nrrd</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; is missing in phase %2</source>
        <translation>La superficie «%1» falta en la fase %2</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; has %2 files in phase %3</source>
        <translation>La superficie «%1» tiene %2 archivos en la fase %3</translation>
    </message>
    <message>
        <source>name a surface alike in all phases, as in ed/LV.obj and es/LV.obj</source>
        <translation>dé a una superficie el mismo nombre en todas las fases, como ed/LV.obj y es/LV.obj</translation>
    </message>
    <message>
        <source>give labels of one kind for all phases</source>
        <translation>indique etiquetas de un mismo tipo para todas las fases</translation>
    </message>
    <message>
        <source>A phase has several label maps</source>
        <translation>Una fase tiene varios mapas de etiquetas</translation>
    </message>
    <message>
        <source>give one file for each phase</source>
        <translation>indique un archivo por fase</translation>
    </message>
    <message>
        <source>it shows no wall that could be followed</source>
        <translation>no muestra ninguna pared que se pueda seguir</translation>
    </message>
    <message>
        <source>its tissue leaves the plane: it arrives %1 mm from the next label</source>
        <translation>su tejido sale del plano: llega a %1 mm de la etiqueta siguiente</translation>
    </message>
    <message>
        <source>its images are hardly alike around the wall</source>
        <translation>sus imágenes apenas se parecen alrededor de la pared</translation>
    </message>
    <message>
        <source>it has no image of %1 of %2 phases</source>
        <translation>no tiene imagen de %1 de %2 fases</translation>
    </message>
    <message>
        <source>only phase %1 has labels: volumes and ejection fraction are estimates, and usually too small a motion; label the end of systole too</source>
        <translation>solo la fase %1 tiene etiquetas: los volúmenes y la fracción de eyección son estimaciones, de un movimiento en general demasiado pequeño; etiquete también el final de la sístole</translation>
    </message>
    <message>
        <source>the images show phase %1 emptier than the labelled end of systole, phase %2, by %3 ml: label that phase</source>
        <translation>las imágenes muestran la fase %1 más vacía, en %3 ml, que el final de la sístole etiquetado, fase %2: etiquete esa fase</translation>
    </message>
    <message>
        <source>the images show phase %1 fuller than the labelled end of diastole, phase %2, by %3 ml: label that phase</source>
        <translation>las imágenes muestran la fase %1 más llena, en %3 ml, que el final de la diástole etiquetado, fase %2: etiquete esa fase</translation>
    </message>
    <message>
        <source>planes of one direction only: what moves across them, such as the base, follows its neighbours</source>
        <translation>planos de una sola dirección: lo que se mueve a través de ellos, como la base, sigue a sus vecinos</translation>
    </message>
    <message>
        <source>no image shows a wall: its pose lies between those of the labels</source>
        <translation>ninguna imagen muestra una pared: la pose está entre las de las etiquetas</translation>
    </message>
    <message>
        <source>the images hardly show how the wall moved</source>
        <translation>las imágenes apenas muestran cómo se movió la pared</translation>
    </message>
    <message>
        <source>the tissue in the images is %1 mm from the surfaces on average</source>
        <translation>el tejido en las imágenes está en promedio a %1 mm de las superficies</translation>
    </message>
    <message>
        <source>the tissue would have folded: it stays nearer to the pose between the labels</source>
        <translation>el tejido se habría plegado: queda más cerca de la pose entre las etiquetas</translation>
    </message>
    <message>
        <source>the tissue has %1 ml, in the labelled phases %2 to %3 ml</source>
        <translation>el tejido tiene %1 ml, en las fases etiquetadas de %2 a %3 ml</translation>
    </message>
    <message>
        <source>%1 % of what is labelled in the plane of %2 lies outside its images</source>
        <translation>El %1 % de lo etiquetado en el plano de %2 queda fuera de sus imágenes</translation>
    </message>
    <message>
        <source>series %1, %2</source>
        <translation>serie %1, %2</translation>
    </message>
    <message>
        <source>slice %1, %2</source>
        <translation>corte %1, %2</translation>
    </message>
    <message>
        <source>Open study %1</source>
        <translation>Abrir el estudio %1</translation>
    </message>
    <message>
        <source>Close study</source>
        <translation>Cerrar el estudio</translation>
    </message>
    <message>
        <source>There is no study to close</source>
        <translation>No hay ningún estudio que cerrar</translation>
    </message>
    <message>
        <source>the study %1 is not there any more (put it beside the session and open that again)</source>
        <translation>el estudio %1 ya no está (póngalo junto a la sesión y vuelva a abrirla)</translation>
    </message>
    <message>
        <source>the study cannot be opened: %1</source>
        <translation>no se puede abrir el estudio: %1</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>The picture of this phase is missing</source>
        <translation>Falta la imagen de esta fase</translation>
    </message>
    <message>
        <source>The picture of this phase cannot be read</source>
        <translation>No se puede leer la imagen de esta fase</translation>
    </message>
    <message>
        <source>phase %1 of %2</source>
        <translation>fase %1 de %2</translation>
    </message>
    <message>
        <source>A body surface needs a height of 30 to 250 cm and a weight of 1 to 400 kg</source>
        <translation>Una superficie corporal necesita una talla de 30 a 250 cm y un peso de 1 a 400 kg</translation>
    </message>
    <message>
        <source>Per m2 of body surface</source>
        <translation>Por m2 de superficie corporal</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Apex of the left ventricle&apos;s cavity</source>
        <translation>Ápex de la cavidad del ventrículo izquierdo</translation>
    </message>
    <message>
        <source>Apex of the right ventricle&apos;s cavity</source>
        <translation>Ápex de la cavidad del ventrículo derecho</translation>
    </message>
    <message>
        <source>Dome of the liver</source>
        <translation>Cúpula del hígado</translation>
    </message>
    <message>
        <source>Lower edge of the liver</source>
        <translation>Borde inferior del hígado</translation>
    </message>
    <message>
        <source>Lower edge of the spleen</source>
        <translation>Borde inferior del bazo</translation>
    </message>
    <message>
        <source>Lowest point of the stomach</source>
        <translation>Punto más bajo del estómago</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Creación del fantoma</translation>
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
        <translation>Polo superior del riñón izquierdo</translation>
    </message>
    <message>
        <source>Upper pole of the right kidney</source>
        <translation>Polo superior del riñón derecho</translation>
    </message>
    <message>
        <source>left atrium</source>
        <translation>aurícula izquierda</translation>
    </message>
    <message>
        <source>right atrium</source>
        <translation>aurícula derecha</translation>
    </message>
    <message>
        <source>left kidney</source>
        <translation>riñón izquierdo</translation>
    </message>
    <message>
        <source>right kidney</source>
        <translation>riñón derecho</translation>
    </message>
    <message>
        <source>left lung</source>
        <translation>pulmón izquierdo</translation>
    </message>
    <message>
        <source>right lung</source>
        <translation>pulmón derecho</translation>
    </message>
    <message>
        <source>right ventricle</source>
        <translation>ventrículo derecho</translation>
    </message>
    <message>
        <source>the deviation of the noise</source>
        <translation>la desviación del ruido</translation>
    </message>
    <message>
        <source>the ejection fraction</source>
        <translation>la fracción de eyección</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>no se puede crear la carpeta</translation>
    </message>
    <message>
        <source>the gap between slices</source>
        <translation>la separación entre los cortes</translation>
    </message>
    <message>
        <source>the heart rate</source>
        <translation>la frecuencia cardíaca</translation>
    </message>
    <message>
        <source>the number of phases</source>
        <translation>el número de fases</translation>
    </message>
    <message>
        <source>the number of slices</source>
        <translation>el número de cortes</translation>
    </message>
    <message>
        <source>the rate of breathing</source>
        <translation>la frecuencia respiratoria</translation>
    </message>
    <message>
        <source>the shift of the slices</source>
        <translation>el desplazamiento de los cortes</translation>
    </message>
    <message>
        <source>the spacing</source>
        <translation>el espaciado</translation>
    </message>
    <message>
        <source>the spacing of the fields</source>
        <translation>el espaciado de los campos</translation>
    </message>
    <message>
        <source>viscera phantom</source>
        <translation>fantoma Viscera</translation>
    </message>
    <message>
        <source>Choose the images first</source>
        <translation>Elija primero las imágenes</translation>
    </message>
    <message>
        <source>Choose the labels of a phase: those of the ends of diastole and systole, where there are any</source>
        <translation>Elija las etiquetas de una fase: las de los finales de diástole y sístole, si las hay</translation>
    </message>
    <message>
        <source>Enter the phase of %1</source>
        <translation>Indique la fase de %1</translation>
    </message>
    <message>
        <source>The images have %1 phases: enter another one for %2</source>
        <translation>Las imágenes tienen %1 fases: indique otra para %2</translation>
    </message>
    <message>
        <source>%1 and %2 are both labels of phase %3</source>
        <translation>%1 y %2 son ambas etiquetas de la fase %3</translation>
    </message>
    <message>
        <source>Only phase %1 has labels: the motion, its volumes and ejection fractions will be estimates. Label the end of systole too, if you can</source>
        <translation>Solo la fase %1 tiene etiquetas: el movimiento, sus volúmenes y sus fracciones de eyección serán estimaciones. Etiquete también el final de la sístole, si puede</translation>
    </message>
    <message>
        <source>The images differ most from the first phase in phase %1, which has no labels: see whether the end of systole is labelled</source>
        <translation>Las imágenes difieren más de la primera fase en la fase %1, que no tiene etiquetas: compruebe si el final de la sístole está etiquetado</translation>
    </message>
    <message>
        <source>weight %1 %</source>
        <translation>peso %1 %</translation>
    </message>
    <message>
        <source>left its plane by %1 mm, %2</source>
        <translation>salió de su plano %1 mm, %2</translation>
    </message>
    <message>
        <source>hardly alike, %1</source>
        <translation>apenas parecidas, %1</translation>
    </message>
    <message>
        <source>shows no wall</source>
        <translation>no muestra pared</translation>
    </message>
    <message>
        <source>no image</source>
        <translation>sin imagen</translation>
    </message>
    <message>
        <source>labelled</source>
        <translation>etiquetada</translation>
    </message>
    <message>
        <source>their phases are %1 to %2</source>
        <translation>sus fases son de %1 a %2</translation>
    </message>
    <message>
        <source>its volumes over the beat and its ejection fraction are estimates: only phase %1 has labels</source>
        <translation>sus volúmenes durante el latido y su fracción de eyección son estimaciones: solo la fase %1 tiene etiquetas</translation>
    </message>
    <message>
        <source>Correct contours</source>
        <translation>Corregir contornos</translation>
    </message>
    <message>
        <source>%1, correction of phase %2</source>
        <translation>%1, corrección de la fase %2</translation>
    </message>
    <message>
        <source>correction of phase %1</source>
        <translation>corrección de la fase %1</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only, since the tissue would fold</source>
        <translation>fase %1: el contorno corregido de %2 solo se alcanza con un error de %3 mm, pues el tejido se plegaría</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only: the handles are too far apart for its shape</source>
        <translation>fase %1: el contorno corregido de %2 solo se alcanza con un error de %3 mm: los tiradores están demasiado separados para su forma</translation>
    </message>
    <message>
        <source>The images have no slice %1</source>
        <translation>Las imágenes no tienen el corte %1</translation>
    </message>
    <message>
        <source>their slices are 0 to %1</source>
        <translation>sus cortes van de 0 a %1</translation>
    </message>
    <message>
        <source>The corrected contour lies %1 mm beside the plane of %2</source>
        <translation>El contorno corregido está a %1 mm del plano de %2</translation>
    </message>
    <message>
        <source>give points in the plane of one slice, mm in LPS</source>
        <translation>indique puntos en el plano de un corte, mm en LPS</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact: only phases between them are corrected</source>
        <translation>La fase %1 tiene etiquetas, que son exactas: solo se corrigen las fases intermedias</translation>
    </message>
    <message>
        <source>change its labels, or leave this correction out</source>
        <translation>cambie sus etiquetas u omita esta corrección</translation>
    </message>
    <message>
        <source>A corrected contour has no points</source>
        <translation>Un contorno corregido no tiene puntos</translation>
    </message>
    <message>
        <source>give three numbers for each of them, mm</source>
        <translation>indique tres números para cada uno, mm</translation>
    </message>
    <message>
        <source>The handles are no longer those of the motion that was found in the images</source>
        <translation>Los tiradores ya no son los del movimiento encontrado en las imágenes</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the handles</source>
        <translation>busque de nuevo el movimiento o deshaga el cambio de los tiradores</translation>
    </message>
    <message>
        <source>There is no key at phase %1 any more</source>
        <translation>Ya no hay ninguna clave en la fase %1</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the keys</source>
        <translation>busque de nuevo el movimiento o deshaga el cambio de las claves</translation>
    </message>
    <message>
        <source>It has no points, or is of no surface that is fitted</source>
        <translation>No tiene puntos o no es de ninguna superficie ajustada</translation>
    </message>
    <message>
        <source>give the points of a contour</source>
        <translation>indique los puntos de un contorno</translation>
    </message>
    <message>
        <source>Phase %1 does not lie between labelled phases</source>
        <translation>La fase %1 no está entre fases con etiquetas</translation>
    </message>
    <message>
        <source>correct a phase that the images are fitted in</source>
        <translation>corrija una fase que se ajuste a las imágenes</translation>
    </message>
    <message>
        <source>meeting corrected contours</source>
        <translation>ajuste a los contornos corregidos</translation>
    </message>
    <message>
        <source>The %1 is damaged and left out: %2</source>
        <translation>Dañada y omitida: %1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n more {phase is|phases are} damaged and left out</source>
        <translation>
            <numerusform>%n fase más está dañada y se ha omitido</numerusform>
            <numerusform>%n fases más están dañadas y se han omitido</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 x %2 x %3 voxels, others %4 x %5 x %6</source>
        <translation>tiene %1 x %2 x %3 vóxeles, otras %4 x %5 x %6</translation>
    </message>
    <message>
        <source>phase %1 %</source>
        <translation>fase %1 %</translation>
    </message>
    <message>
        <source>The %1 shows the same instant as the %2, and is left out</source>
        <translation>%1 muestra el mismo instante que %2 y se omite</translation>
    </message>
    <message>
        <source>Its phases are kept as 16 bits a voxel, to a 65,000th of their range</source>
        <translation>Sus fases se guardan con 16 bits por vóxel, a una 65.000.ª parte de su intervalo</translation>
    </message>
    <message>
        <source>Its phases need %1 GB, of which %2 GB are kept at a time; the others are read again when they are shown</source>
        <translation>Sus fases necesitan %1 GB, de los que se guardan %2 GB a la vez; las demás se leen de nuevo cuando se muestran</translation>
    </message>
    <message>
        <source>It is packed, or keeps its phases beside each other, so that each of them is read as slowly as all; save it unpacked to move through it</source>
        <translation>Está comprimido o guarda sus fases una junto a otra, de modo que cada una se lee tan despacio como todas; guárdelo sin comprimir para recorrerlo</translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as seconds</source>
        <translation>No indica la unidad de sus tiempos; se toman como segundos</translation>
    </message>
    <message>
        <source>the session holds one phase of this scan; open its file again for the others</source>
        <translation>la sesión contiene una fase de este estudio; abra de nuevo su archivo para las demás</translation>
    </message>
    <message>
        <source>Series %1 states %2 phases and has %3</source>
        <translation>La serie %1 declara %2 fases y tiene %3</translation>
    </message>
    <message>
        <source>Series %1: %2</source>
        <translation>Serie %1: %2</translation>
    </message>
    <message>
        <source>Series %1 is left out: &quot;%2&quot; %3</source>
        <translation>La serie %1 queda fuera: «%2» %3</translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of %2 {is|are} empty and left out: %3</source>
        <translation>
            <numerusform>%n imagen de %2 está vacía y se ha omitido: %3</numerusform>
            <numerusform>%n imágenes de %2 están vacías y se han omitido: %3</numerusform>
        </translation>
    </message>
    <message>
        <source>free handles cannot follow: these coordinates are not linear in the handles</source>
        <translation>los tiradores libres no pueden seguir: estas coordenadas no son lineales en los tiradores</translation>
    </message>
    <message>
        <source>choose another coordinate system</source>
        <translation>elija otro sistema de coordenadas</translation>
    </message>
    <message>
        <source>free handles cannot follow: there is no witness point in the tissue</source>
        <translation>los tiradores libres no pueden seguir: no hay ningún punto testigo en el tejido</translation>
    </message>
    <message>
        <source>place the handles around an organ that encloses a volume</source>
        <translation>coloque los tiradores alrededor de un órgano que encierre un volumen</translation>
    </message>
    <message>
        <source>unlock it, or move the handles less far</source>
        <translation>desbloquéelo, o mueva menos los tiradores</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Tensión de von Mises</translation>
    </message>
    <message>
        <source>Maximum von Mises stress</source>
        <translation>Tensión de von Mises máxima</translation>
    </message>
    <message>
        <source>The stress that shears the tissue, if it is the stated material; the change of its volume has no part in it.</source>
        <translation>La tensión que cizalla el tejido, si es del material indicado; el cambio de su volumen no interviene.</translation>
    </message>
    <message>
        <source>Strain energy density</source>
        <translation>Densidad de energía de deformación</translation>
    </message>
    <message>
        <source>Maximum strain energy density</source>
        <translation>Densidad de energía de deformación máxima</translation>
    </message>
    <message>
        <source>The energy for each volume at rest, if the tissue is the stated material; with what the change of its volume takes.</source>
        <translation>La energía por volumen en reposo, si el tejido es del material indicado; con lo que cuesta el cambio de su volumen.</translation>
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
        <translation>miocardio</translation>
    </message>
    <message>
        <source>kidney</source>
        <translation>riñón</translation>
    </message>
    <message>
        <source>spleen</source>
        <translation>bazo</translation>
    </message>
    <message>
        <source>pancreas</source>
        <translation>páncreas</translation>
    </message>
    <message>
        <source>Pascals are of a stated material: %1.</source>
        <translation>Los pascales son de un material indicado: %1.</translation>
    </message>
    <message>
        <source>Interventricular septum</source>
        <translation>Tabique interventricular</translation>
    </message>
    <message>
        <source>Interatrial septum</source>
        <translation>Tabique interauricular</translation>
    </message>
    <message>
        <source>Oval fossa</source>
        <translation>Fosa oval</translation>
    </message>
    <message>
        <source>Opening of the coronary sinus</source>
        <translation>Orificio del seno coronario</translation>
    </message>
    <message>
        <source>Valve of the coronary sinus</source>
        <translation>Válvula del seno coronario</translation>
    </message>
    <message>
        <source>the limit of Doppler ultrasound, which no study of its own gives; measured by catheter since Gleason and Braunwald 1962, doi 10.1172/JCI104469</source>
        <translation>límite de la ecografía Doppler, que ningún estudio propio da; medida con catéter desde Gleason y Braunwald 1962, doi 10.1172/JCI104469</translation>
    </message>
    <message>
        <source>customary; how much people at rest differ: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</source>
        <translation>habitual; cuánto difieren las personas en reposo: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</translation>
    </message>
    <message numerus="yes">
        <source>%n {point or open contour was|points and open contours were} left out</source>
        <translation>
            <numerusform>se ha omitido %n punto o contorno abierto</numerusform>
            <numerusform>se han omitido %n puntos y contornos abiertos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was|contours were} left out, whose numbers cannot be read</source>
        <translation>
            <numerusform>se ha omitido %n contorno cuyos números no se pueden leer</numerusform>
            <numerusform>se han omitido %n contornos cuyos números no se pueden leer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was left out, which lies|contours were left out, which lie} in another direction than most</source>
        <translation>
            <numerusform>se ha omitido %n contorno que está en otra dirección que la mayoría</numerusform>
            <numerusform>se han omitido %n contornos que están en otra dirección que la mayoría</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {region was left out, which is|regions were left out, which are} in another coordinate system (frame of reference)</source>
        <translation>
            <numerusform>se ha omitido %n región de otro sistema de coordenadas (frame of reference)</numerusform>
            <numerusform>se han omitido %n regiones de otro sistema de coordenadas (frame of reference)</numerusform>
        </translation>
    </message>
    <message>
        <source>all contours lie in one plane, whose thickness is not stated; %1 mm were taken</source>
        <translation>todos los contornos están en un plano cuyo grosor no se indica; se han tomado %1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of %2 without a contour got the shape between their neighbours</source>
        <translation>
            <numerusform>%n corte de %2 sin contorno ha recibido la forma entre sus vecinos</numerusform>
            <numerusform>%n cortes de %2 sin contorno han recibido la forma entre sus vecinos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no contour over %2 mm; that gap stays open</source>
        <translation>%1 no tiene contorno en %2 mm; ese hueco queda abierto</translation>
    </message>
    <message>
        <source>It is a structure set without regions of interest</source>
        <translation>Es un structure set sin regiones</translation>
    </message>
    <message>
        <source>export the contours again</source>
        <translation>exporte de nuevo los contornos</translation>
    </message>
    <message>
        <source>It is a structure set without closed contours, so that there is no organ in it</source>
        <translation>Es un structure set sin contornos cerrados, por lo que no contiene ningún órgano</translation>
    </message>
    <message>
        <source>export the structures as closed planar contours</source>
        <translation>exporte las estructuras como contornos planos cerrados</translation>
    </message>
    <message>
        <source>No voxel of the grid lies within the organ</source>
        <translation>Ningún vóxel de la rejilla está dentro del órgano</translation>
    </message>
    <message>
        <source>choose the scan that shows it, or smaller voxels</source>
        <translation>elija el estudio que lo muestra, o vóxeles más pequeños</translation>
    </message>
    <message>
        <source>choose the scan that shows it</source>
        <translation>elija el estudio que lo muestra</translation>
    </message>
    <message>
        <source>There are fewer than two images to lay a segmentation on</source>
        <translation>Hay menos de dos imágenes sobre las que poner una segmentación</translation>
    </message>
    <message>
        <source>choose a series of slices</source>
        <translation>elija una serie de cortes</translation>
    </message>
    <message>
        <source>The images lie at unequal distances, so that they have no grid</source>
        <translation>Las imágenes están a distancias desiguales, por lo que no tienen rejilla</translation>
    </message>
    <message>
        <source>write the segmentation on a grid of its own</source>
        <translation>escriba la segmentación en una rejilla propia</translation>
    </message>
    <message>
        <source>The size of voxels has to be positive</source>
        <translation>El tamaño de los vóxeles debe ser positivo</translation>
    </message>
    <message>
        <source>The organs are too large for voxels of that size</source>
        <translation>Los órganos son demasiado grandes para vóxeles de ese tamaño</translation>
    </message>
    <message>
        <source>choose larger voxels</source>
        <translation>elija vóxeles más grandes</translation>
    </message>
    <message>
        <source>No image of the scan crosses the organ</source>
        <translation>Ninguna imagen del estudio corta el órgano</translation>
    </message>
    <message>
        <source>Contours need the images whose planes they lie in</source>
        <translation>Los contornos necesitan las imágenes en cuyos planos están</translation>
    </message>
    <message>
        <source>open the DICOM scan of the organs, or write a segmentation</source>
        <translation>abra el estudio DICOM de los órganos, o escriba una segmentación</translation>
    </message>
    <message>
        <source>It is no PDF document</source>
        <translation>No es un documento PDF</translation>
    </message>
    <message>
        <source>There is no DICOM image whose patient and study could be taken</source>
        <translation>No hay ninguna imagen DICOM de la que tomar el paciente y el estudio</translation>
    </message>
    <message>
        <source>name the folder of the images that the organs were made from</source>
        <translation>indique la carpeta de las imágenes de las que se hicieron los órganos</translation>
    </message>
    <message>
        <source>It has no measurement</source>
        <translation>No tiene ninguna medición</translation>
    </message>
    <message>
        <source>Its segment is named without the segmentation</source>
        <translation>Su segmento se nombra sin la segmentación</translation>
    </message>
    <message>
        <source>write the segmentation too</source>
        <translation>escriba también la segmentación</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>expórtelo o cópielo de nuevo</translation>
    </message>
    <message>
        <source>key sequence</source>
        <translation>secuencia de fotogramas clave</translation>
    </message>
    <message>
        <source>as in %1</source>
        <translation>como en %1</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Corregir el contorno</translation>
    </message>
    <message>
        <source>It is a segmentation over time: its frames show several phases at one place</source>
        <translation>Es una segmentación en el tiempo: sus imágenes muestran varias fases en un mismo lugar</translation>
    </message>
    <message>
        <source>The archive %1 cannot be reached</source>
        <translation>No se puede acceder al archivo %1</translation>
    </message>
    <message>
        <source>Check its address and port, and whether it runs</source>
        <translation>Compruebe su dirección y su puerto, y si funciona</translation>
    </message>
    <message>
        <source>The archive %1 does not answer</source>
        <translation>El archivo %1 no responde</translation>
    </message>
    <message>
        <source>Try again; the archive or the network may be slow</source>
        <translation>Inténtelo de nuevo; el archivo o la red pueden ser lentos</translation>
    </message>
    <message>
        <source>The archive %1 refuses the titles: it is called %2, and this program %3</source>
        <translation>El archivo %1 rechaza los títulos: se le llama %2, y a este programa %3</translation>
    </message>
    <message>
        <source>Ask its administrator for its title, and to allow that of this program</source>
        <translation>Pregunte a su administrador por el título, y que permita el de este programa</translation>
    </message>
    <message>
        <source>The archive %1 refuses the user name or the password</source>
        <translation>El archivo %1 rechaza el usuario o la contraseña</translation>
    </message>
    <message>
        <source>Type both again</source>
        <translation>Escríbalos de nuevo</translation>
    </message>
    <message>
        <source>The certificate of the archive %1 is not trusted</source>
        <translation>El certificado del archivo %1 no es de confianza</translation>
    </message>
    <message>
        <source>Name the file with its issuer&apos;s certificate in the connection</source>
        <translation>Indique en la conexión el archivo con el certificado de su emisor</translation>
    </message>
    <message>
        <source>The connection to the archive %1 was cut</source>
        <translation>Se cortó la conexión con el archivo %1</translation>
    </message>
    <message>
        <source>Try again; nothing incomplete is kept</source>
        <translation>Inténtelo de nuevo; no se guarda nada incompleto</translation>
    </message>
    <message>
        <source>The answer of the archive %1 is not DICOM</source>
        <translation>La respuesta del archivo %1 no es DICOM</translation>
    </message>
    <message>
        <source>Check its address</source>
        <translation>Compruebe su dirección</translation>
    </message>
    <message>
        <source>The archive %1 refuses: %2</source>
        <translation>El archivo %1 rechaza: %2</translation>
    </message>
    <message>
        <source>Ask its administrator</source>
        <translation>Pregunte a su administrador</translation>
    </message>
    <message>
        <source>The archive %1 does not offer %2</source>
        <translation>El archivo %1 no ofrece %2</translation>
    </message>
    <message>
        <source>The archive %1 has not kept %2 of %3 files</source>
        <translation>El archivo %1 no ha guardado %2 de %3 ficheros</translation>
    </message>
    <message>
        <source>The archive %1 has no such series</source>
        <translation>El archivo %1 no tiene esa serie</translation>
    </message>
    <message>
        <source>What was received cannot be written</source>
        <translation>No se puede escribir lo recibido</translation>
    </message>
    <message>
        <source>Is the disk full?</source>
        <translation>¿Está lleno el disco?</translation>
    </message>
    <message>
        <source>Ask the archive %1</source>
        <translation>Consultar el archivo %1</translation>
    </message>
    <message>
        <source>Receive image %1</source>
        <translation>Recibir la imagen %1</translation>
    </message>
    <message>
        <source>Send image %1</source>
        <translation>Enviar la imagen %1</translation>
    </message>
    <message>
        <source>The folder is there already</source>
        <translation>La carpeta ya existe</translation>
    </message>
    <message>
        <source>The folder cannot be made</source>
        <translation>No se puede crear la carpeta</translation>
    </message>
    <message>
        <source>The file is no DICOM file</source>
        <translation>El fichero no es DICOM</translation>
    </message>
    <message>
        <source>The certificates cannot be read</source>
        <translation>No se pueden leer los certificados</translation>
    </message>
    <message>
        <source>It is no list of archives</source>
        <translation>No es una lista de archivos</translation>
    </message>
    <message>
        <source>this service</source>
        <translation>este servicio</translation>
    </message>
    <message>
        <source>The address of the archive %1 is not known to the network</source>
        <translation>La red no conoce la dirección del archivo de imágenes %1</translation>
    </message>
    <message>
        <source>Check how its address is spelt</source>
        <translation>Compruebe cómo está escrita la dirección</translation>
    </message>
    <message>
        <source>There is no secure connection (TLS) to the archive %1</source>
        <translation>No hay conexión segura (TLS) con el archivo de imágenes %1</translation>
    </message>
    <message>
        <source>Ask its administrator whether this port takes TLS, and of which version</source>
        <translation>Pregunte a su administrador si este puerto admite TLS y en qué versión</translation>
    </message>
    <message>
        <source>the images are not there any more (the archive %1 has them)</source>
        <translation>las imágenes ya no están (el archivo de imágenes %1 las tiene)</translation>
    </message>
    <message>
        <source>There is no key ring that keeps the password</source>
        <translation>No hay depósito de claves que guarde la contraseña</translation>
    </message>
    <message>
        <source>it counts little in %1 of %2 phases, in which its tissue leaves the plane or its images are unlike</source>
        <translation>cuenta poco en %1 de %2 fases, en las que su tejido sale del plano o sus imágenes no se parecen</translation>
    </message>
    <message>
        <source>%1 is left out: its surface is open</source>
        <translation>%1 se omite: su superficie está abierta</translation>
    </message>
    <message>
        <source>the scan&apos;s DICOM files are not there: the objects get a study of their own</source>
        <translation>los archivos DICOM de la imagen no están: los objetos reciben un estudio propio</translation>
    </message>
    <message>
        <source>The report names the patient or the files, and identity is to be removed</source>
        <translation>El informe nombra al paciente o los archivos, y la identidad debe quitarse</translation>
    </message>
    <message>
        <source>leave the report out, or make one without the patient</source>
        <translation>deje fuera el informe o haga uno sin el paciente</translation>
    </message>
    <message>
        <source>The report holds the patient&apos;s name or number</source>
        <translation>El informe contiene el nombre o el número del paciente</translation>
    </message>
    <message>
        <source>leave the report out</source>
        <translation>deje fuera el informe</translation>
    </message>
    <message>
        <source>No DICOM object is chosen</source>
        <translation>No se ha elegido ningún objeto DICOM</translation>
    </message>
    <message>
        <source>choose one at least</source>
        <translation>elija al menos uno</translation>
    </message>
    <message>
        <source>There is no organ to write</source>
        <translation>No hay ningún órgano que escribir</translation>
    </message>
    <message>
        <source>There is no organ with a closed surface to write as DICOM</source>
        <translation>No hay ningún órgano de superficie cerrada que escribir como DICOM</translation>
    </message>
    <message>
        <source>close it first</source>
        <translation>ciérrela primero</translation>
    </message>
    <message>
        <source>The number of phases is 0 to 200</source>
        <translation>El número de fases es de 0 a 200</translation>
    </message>
    <message>
        <source>the file is there already</source>
        <translation>el archivo ya existe</translation>
    </message>
    <message>
        <source>choose an empty folder</source>
        <translation>elija una carpeta vacía</translation>
    </message>
    <message>
        <source>there is no such series</source>
        <translation>no existe tal serie</translation>
    </message>
    <message>
        <source>one mesh says nothing about the others</source>
        <translation>una malla no dice nada de las demás</translation>
    </message>
    <message>
        <source>give two sizes at least</source>
        <translation>indique al menos dos tamaños</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or export a segmentation of each phase</source>
        <translation>siga el movimiento por todas con viscera track %1, o exporte una segmentación de cada fase</translation>
    </message>
</context>
<context>
    <name>viscera::app</name>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Fetching from %1</source>
        <translation>Trayendo de %1</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>%1 (estimate)</source>
        <translation>%1 (estimación)</translation>
    </message>
    <message>
        <source>Planes of the images</source>
        <translation>Planos de las imágenes</translation>
    </message>
    <message>
        <source>Cine study</source>
        <translation>Estudio cine</translation>
    </message>
    <message>
        <source>Use the sequence&apos;s handles</source>
        <translation>Usar los tiradores de la secuencia</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Circulation</source>
        <translation>Circulación</translation>
    </message>
    <message>
        <source>Sample %1</source>
        <translation>Muestra: %1</translation>
    </message>
    <message>
        <source>Organs (%1)</source>
        <translation>Órganos (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Prescribe a volume</source>
        <translation>Prescribir un volumen</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Cut away the front</source>
        <translation>Retirar la parte anterior</translation>
    </message>
    <message>
        <source>Cut away the upper part</source>
        <translation>Retirar la parte superior</translation>
    </message>
    <message>
        <source>Facing the viewer</source>
        <translation>Frente al observador</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Deformar</translation>
    </message>
    <message numerus="yes">
        <source>%n handles</source>
        <translation>
            <numerusform>%n tirador</numerusform>
            <numerusform>%n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Rest error</source>
        <translation>Error en reposo</translation>
    </message>
    <message>
        <source>The largest distance of the bound organ at rest from the original</source>
        <translation>La mayor distancia entre el órgano vinculado en reposo y el original</translation>
    </message>
    <message>
        <source>Smallest weight</source>
        <translation>Peso mínimo</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valores separados por comas (*.csv)</translation>
    </message>
    <message>
        <source>There is no organ to export. Open one first.</source>
        <translation>No hay ningún órgano que exportar. Abra uno primero.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportando %1</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Guardado en %1.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Look for files...</source>
        <translation>Buscar archivos...</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Place the sequence&apos;s handles around the organ and play it</source>
        <translation>Colocar los tiradores de la secuencia en torno al órgano y reproducirla</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Color...</translation>
    </message>
    <message numerus="yes">
        <source>Move %n handles</source>
        <translation>
            <numerusform>Mover %n tirador</numerusform>
            <numerusform>Mover %n tiradores</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle %1</source>
        <translation>Mover tirador %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Estrés</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Duration of one cycle</source>
        <translation>Duración de un ciclo</translation>
    </message>
    <message>
        <source>Export lesson</source>
        <translation>Exportar lección</translation>
    </message>
    <message>
        <source>Motion from a series</source>
        <translation>Movimiento de una serie</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
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
        <translation>Cerrar (Esc)</translation>
    </message>
    <message>
        <source>Time in the cycle</source>
        <translation>Tiempo en el ciclo</translation>
    </message>
</context>
</TS>
