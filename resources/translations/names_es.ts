<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>&quot;%1&quot; is %2 instead of &quot;%3&quot;</source>
        <translation>«%1» es %2 en lugar de «%3»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither true nor false</source>
        <translation>«%1» no es verdadero ni falso</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list</source>
        <translation>«%1» no es una lista</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a text</source>
        <translation>«%1» no es un texto</translation>
    </message>
    <message>
        <source>&quot;version&quot; is not a positive whole number</source>
        <translation>«version» no es un número entero positivo</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
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
        <source>%1 is farther away than a thousand kilometres</source>
        <translation>%1 está a más de mil kilómetros</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 no es un número finito</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 de más de 1 GB no cabe en un archivo de sesión</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 filas</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 vóxeles</translation>
    </message>
    <message>
        <source>%1, %2 of them crumbs of less than 2 % of its area</source>
        <translation>%1, %2 de ellas migajas de menos del 2 % de su área</translation>
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
        <translation>%1, clave en %2 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1: «%2» es desconocido y no se guardará de nuevo</translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; look whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
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
        <source>%n {handle|handles}</source>
        <translation>
            <numerusform>%n tirador</numerusform>
            <numerusform>%n tiradores</numerusform>
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
    <message>
        <source>A cavity has to come after the organ that it is in</source>
        <translation>Una cavidad debe ir después del órgano en que está</translation>
    </message>
    <message>
        <source>A group names a handle that is not there</source>
        <translation>Un grupo nombra un tirador que no existe</translation>
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
        <source>A rectangle lies in an axial, coronal or sagittal slice</source>
        <translation>Un rectángulo está en un corte axial, coronal o sagital</translation>
    </message>
    <message>
        <source>A row has four numbers</source>
        <translation>Una fila tiene cuatro números</translation>
    </message>
    <message>
        <source>A scan has three axes</source>
        <translation>Un estudio tiene tres ejes</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Una sesión se abre sola</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Un ventrículo izquierdo rígido que se relaja despacio: se vacía bien y solo se llena a presión alta.</translation>
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
        <source>Add group</source>
        <translation>Añadir grupo</translation>
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
        <source>An angle needs three points, any other measurement two</source>
        <translation>Un ángulo necesita tres puntos, cualquier otra medida dos</translation>
    </message>
    <message>
        <source>An organ needs a surface</source>
        <translation>Un órgano necesita una superficie</translation>
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
        <source>As near to a target as balance allows; what is done about negative numbers can be chosen</source>
        <translation>Tan cerca de un objetivo como permita el equilibrio; se puede elegir qué hacer con los números negativos</translation>
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
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Bending the scan</source>
        <translation>Curvando el estudio</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>Curvado</translation>
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
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not touch its handles</source>
        <translation>Con esquinas y normales de una jaula de cualquier forma; casi conserva los ángulos y no toca sus tiradores</translation>
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
        <source>Change group</source>
        <translation>Cambiar grupo</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Cambiar aspecto</translation>
    </message>
    <message>
        <source>Change recording</source>
        <translation>Cambiar grabación</translation>
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
        <source>Close holes</source>
        <translation>Cerrar orificios</translation>
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
        <source>Displacement_mm</source>
        <translation>Displacement_mm</translation>
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
        <source>End-systolic and relaxed</source>
        <translation>Telesistólica y relajada</translation>
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
        <source>Filling that multiplies the pericardium's pressure by e</source>
        <translation>Llenado que multiplica por e la presión del pericardio</translation>
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
        <source>Forget what was before</source>
        <translation>Olvidar lo anterior</translation>
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
        <source>How positive balanced vectors are found</source>
        <translation>Cómo se hallan los vectores equilibrados positivos</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Cómo llegan a los tiradores los pesos de los vértices de Voronoi</translation>
    </message>
    <message>
        <source>How the wire connects them</source>
        <translation>Cómo los une el hilo</translation>
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
        <source>Influence of %1</source>
        <translation>Influencia de %1</translation>
    </message>
    <message>
        <source>Inner handles of each layer</source>
        <translation>Tiradores interiores de cada capa</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>No se puede leer</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Se cruza consigo misma, en %n par de triángulos</numerusform>
            <numerusform>Se cruza consigo misma, en %n pares de triángulos</numerusform>
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
        <source>It has no &quot;%1&quot;</source>
        <translation>Falta «%1»</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>No tiene la superficie «%1»</translation>
    </message>
    <message>
        <source>It has to be a text</source>
        <translation>Debe ser un texto</translation>
    </message>
    <message>
        <source>It holds less than %1</source>
        <translation>Contiene menos de %1</translation>
    </message>
    <message>
        <source>It is a scan and no organ</source>
        <translation>Es un estudio y no un órgano</translation>
    </message>
    <message>
        <source>It is damaged: it does not hold %1</source>
        <translation>Está dañado: no contiene %1</translation>
    </message>
    <message>
        <source>It is damaged: its SHA-256 is not %1</source>
        <translation>Está dañado: su SHA-256 no es %1</translation>
    </message>
    <message>
        <source>It is neither &quot;embedded&quot; nor &quot;linked&quot;</source>
        <translation>No es ni «embedded» ni «linked»</translation>
    </message>
    <message>
        <source>It is nested too deeply</source>
        <translation>Está anidado demasiado profundamente</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>No es un archivo de tipo %1: su «format» no es «%2»</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>No es un archivo que se pueda leer</translation>
    </message>
    <message>
        <source>It is not a finite number</source>
        <translation>No es un número finito</translation>
    </message>
    <message>
        <source>It is not a list of three numbers</source>
        <translation>No es una lista de tres números</translation>
    </message>
    <message>
        <source>It is not a text</source>
        <translation>No es un texto</translation>
    </message>
    <message>
        <source>It is not a triangle of three handles</source>
        <translation>No es un triángulo de tres tiradores</translation>
    </message>
    <message>
        <source>It is not a whole number from 0 to 2^53</source>
        <translation>No es un número entero de 0 a 2^53</translation>
    </message>
    <message>
        <source>It is not an object</source>
        <translation>No es un objeto</translation>
    </message>
    <message>
        <source>It is not base64</source>
        <translation>No es base64</translation>
    </message>
    <message>
        <source>It is not complete JSON: %1</source>
        <translation>No es JSON completo: %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>Es de la versión %1; este programa lee hasta la %2</translation>
    </message>
    <message>
        <source>It is too long</source>
        <translation>Es demasiado largo</translation>
    </message>
    <message>
        <source>Its axes lie in one plane</source>
        <translation>Sus ejes están en un plano</translation>
    </message>
    <message>
        <source>Keep as before</source>
        <translation>Conservar como anterior</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Riñón</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>Cavidad de la AI</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>LV cavity</source>
        <translation>Cavidad del VI</translation>
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
        <source>Leak below its</source>
        <translation>Fuga inferior a su</translation>
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
        <source>Left atrium, right ventricle</source>
        <translation>Aurícula izquierda, ventrículo derecho</translation>
    </message>
    <message>
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Aurícula izquierda, escala de la curva relajada</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
        <translation>Aurícula izquierda, pendiente de la curva relajada</translation>
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
        <translation>Ventrículo izquierdo, escala de la curva relajada</translation>
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
        <source>Mean</source>
        <translation>Media</translation>
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
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Valor medio sobre las regiones de Voronoi de los tiradores vistas desde cada punto; salta, o lento</translation>
    </message>
    <message>
        <source>Mean value over the triangles in which each point sees the handles; jumps, or blended rough</source>
        <translation>Valor medio sobre los triángulos en que cada punto ve los tiradores; salta, o rugoso al mezclar</translation>
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
        <translation>Centro del cuerpo</translation>
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
        <translation>Mover clave</translation>
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
        <source>No scan has %1 voxels along an axis</source>
        <translation>Ningun estudio tiene %1 vóxeles a lo largo de un eje</translation>
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
        <source>Of the random numbers</source>
        <translation>De los números aleatorios</translation>
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
        <source>Organ</source>
        <translation>Órgano</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otros</translation>
    </message>
    <message>
        <source>PR interval, 0.12 to 0.20 s</source>
        <translation>Intervalo PR, de 0,12 a 0,20 s</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Páncreas</translation>
    </message>
    <message>
        <source>Peak of %1</source>
        <translation>Máximo de %1</translation>
    </message>
    <message>
        <source>Peak stress</source>
        <translation>Estrés máximo</translation>
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
        <translation>Cavidad de la AD</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>RV cavity</source>
        <translation>Cavidad del VD</translation>
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
        <translation>Grabar clave</translation>
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
        <source>Remove from group</source>
        <translation>Quitar del grupo</translation>
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
            <numerusform>Quitar la clave</numerusform>
            <numerusform>Quitar %n claves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Quitar la medida</numerusform>
            <numerusform>Quitar %n medidas</numerusform>
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
        <translation>Reemplazar los tiradores</translation>
    </message>
    <message>
        <source>Replace pose of key</source>
        <translation>Sustituir pose de clave</translation>
    </message>
    <message>
        <source>Replace recording</source>
        <translation>Sustituir grabación</translation>
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
        <translation>Aurícula derecha, escala de la curva relajada</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
        <translation>Aurícula derecha, pendiente de la curva relajada</translation>
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
        <translation>Ventrículo derecho, escala de la curva relajada</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
        <translation>Ventrículo derecho, pendiente de la curva relajada</translation>
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
        <source>RotationalStress_deg</source>
        <translation>RotationalStress_deg</translation>
    </message>
    <message>
        <source>S-Celestial</source>
        <translation>S-Celestial</translation>
    </message>
    <message>
        <source>Samples a point</source>
        <translation>Muestras por punto</translation>
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
        <source>Small bowel</source>
        <translation>Intestino delgado</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Estiramiento mínimo</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; maximum entropy over directions</source>
        <translation>Suave y positivo, solo con puntos; máxima entropía sobre direcciones</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; the thesis's choice for organs</source>
        <translation>Suave y positivo, solo con puntos; la elección de la tesis para órganos</translation>
    </message>
    <message>
        <source>Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes</source>
        <translation>Soluciones de la ecuación de Laplace en una jaula de cualquier forma; locales y sin lóbulos negativos</translation>
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
        <source>StretchMax</source>
        <translation>StretchMax</translation>
    </message>
    <message>
        <source>StretchMin</source>
        <translation>StretchMin</translation>
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
        <source>Surfaces are cut by at most 8 planes at once, not by %1</source>
        <translation>Las superficies se cortan con 8 planos a la vez como máximo, no con %1</translation>
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
        <source>Take the cage %1</source>
        <translation>Usar la jaula %1</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Taponamiento</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen no colocó ningún punto dentro de la superficie</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>La válvula aórtica se abre hasta 0,8 cm2: la presión del ventrículo hipertrofiado supera con mucho la de la aorta.</translation>
    </message>
    <message>
        <source>The cage names a handle that is not there</source>
        <translation>La jaula nombra un tirador que no existe</translation>
    </message>
    <message>
        <source>The centre of all positive answers, by sampling; as good as the number of samples</source>
        <translation>El centro de todas las respuestas positivas, por muestreo; tan bueno como el número de muestras</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Las coordenadas clásicas de una jaula cerrada; positivas donde la jaula es convexa</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>El mapa de etiquetas de %1 tiene otra cuadrícula (%2) que el estudio (%3); cada uno está donde dice su archivo, y nada se remuestrea</translation>
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
        <source>The mitral valve leaks through 0.4 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>La válvula mitral pierde por 0,4 cm2: la mitad de lo que expulsa el ventrículo vuelve a la aurícula.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>El número de puntos testigo debe estar entre %1 y %2</translation>
    </message>
    <message>
        <source>The numbers to stay near to</source>
        <translation>Los números a los que aproximarse</translation>
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
        <source>The points of n-space that the wire connects</source>
        <translation>Los puntos del espacio n que une el hilo</translation>
    </message>
    <message>
        <source>The pose has %1 handles, the document %2</source>
        <translation>La pose tiene %1 tiradores, el documento %2</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>La pose tiene una posición que no es un número finito o está demasiado lejos</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>La secuencia mueve %1 tiradores, pero hay %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>La secuencia se hizo para otra posición de un tirador</translation>
    </message>
    <message>
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>El número menor se eleva tanto como se pueda; positivo, con dobleces</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>La superficie no tiene ningún triángulo</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>La superficie se reparó antes de llenarla.</translation>
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
        <source>The tip of the heart</source>
        <translation>La punta del corazón</translation>
    </message>
    <message>
        <source>The top of the fundus</source>
        <translation>La parte más alta del fundus</translation>
    </message>
    <message>
        <source>The width has to be positive</source>
        <translation>La anchura debe ser positiva</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Los puntos testigo están en una cuadrícula regular dentro de la superficie.</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Los puntos testigo están en una cuadrícula regular dentro de la superficie. %1.</translation>
    </message>
    <message>
        <source>There are %1 positions for %2 handles</source>
        <translation>Hay %1 posiciones para %2 tiradores</translation>
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
        <translation>No hay tiradores cuya pose se pueda registrar</translation>
    </message>
    <message>
        <source>There are no such vertices to enclose</source>
        <translation>No existen esos vértices que rodear</translation>
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
        <translation>No hay ningun estudio que cerrar</translation>
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
        <source>There is no such point</source>
        <translation>Ese punto no existe</translation>
    </message>
    <message>
        <source>There is no type of samples &quot;%1&quot;</source>
        <translation>No existe el tipo de muestras «%1»</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Engrosamiento</translation>
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
        <source>Two handles are at one place</source>
        <translation>Dos tiradores están en el mismo lugar</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Proceso uncinado</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloquear</translation>
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
        <source>Veins</source>
        <translation>Venas</translation>
    </message>
    <message>
        <source>Viscera:</source>
        <translation>Viscera:</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Razón de volúmenes</translation>
    </message>
    <message>
        <source>VolumeRatio</source>
        <translation>VolumeRatio</translation>
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
        <source>What is added to every weight when a handle comes in</source>
        <translation>Qué se suma a cada peso cuando entra un tirador</translation>
    </message>
    <message>
        <source>What is done about negative numbers</source>
        <translation>Qué se hace con los números negativos</translation>
    </message>
    <message>
        <source>What the hull is divided into</source>
        <translation>En qué se divide la envolvente</translation>
    </message>
    <message>
        <source>What the pericardium holds without pressing</source>
        <translation>Lo que cabe en el pericardio sin comprimir</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Cuándo termina el ascenso del número menor</translation>
    </message>
    <message>
        <source>Where 'iterative' moves the target</source>
        <translation>Adónde mueve el objetivo «iterative»</translation>
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
        <translation>Testigo</translation>
    </message>
    <message>
        <source>Witness points of %1</source>
        <translation>Puntos testigo de %1</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>una jaula es una superficie gruesa: elija una de %1 vértices como máximo</translation>
    </message>
    <message>
        <source>a coarse surface needs at least four vertices</source>
        <translation>una superficie gruesa necesita al menos cuatro vértices</translation>
    </message>
    <message>
        <source>a convex hull needs at least 4 points, there are %1</source>
        <translation>una envolvente convexa necesita al menos 4 puntos, hay %1</translation>
    </message>
    <message>
        <source>a displacement</source>
        <translation>un desplazamiento</translation>
    </message>
    <message>
        <source>a distance grid of this spacing is too large</source>
        <translation>una cuadrícula de distancias con este paso es demasiado grande</translation>
    </message>
    <message>
        <source>a handle of a recorded key</source>
        <translation>un tirador de una clave registrada</translation>
    </message>
    <message>
        <source>a part of the scan is on no organ</source>
        <translation>una parte del estudio no está en ningún órgano</translation>
    </message>
    <message>
        <source>a point of its surface</source>
        <translation>un punto de su superficie</translation>
    </message>
    <message>
        <source>a recorded key</source>
        <translation>una clave registrada</translation>
    </message>
    <message>
        <source>a remark on it is not UTF-8</source>
        <translation>una observación sobre él no es UTF-8</translation>
    </message>
    <message>
        <source>a surface without triangles has no inside</source>
        <translation>una superficie sin triángulos no tiene interior</translation>
    </message>
    <message>
        <source>a triangle has a handle at two corners</source>
        <translation>un triángulo tiene un tirador en dos esquinas</translation>
    </message>
    <message>
        <source>a triangle names a handle that is not there</source>
        <translation>un triángulo nombra un tirador que no existe</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>añada tiradores, o colóquelos automáticamente</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>añadido por la agrupación automática</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>todos los puntos están en un plano</translation>
    </message>
    <message>
        <source>an angle has three points, any other measurement two</source>
        <translation>un ángulo tiene tres puntos, cualquier otra medida dos</translation>
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
        <source>check its permissions</source>
        <translation>compruebe sus permisos</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>compruebe su unidad; las coordenadas están en mm</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>compruebe el nombre</translation>
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
        <source>choose a file that Viscera has saved as .viscera</source>
        <translation>elija un archivo que Viscera haya guardado como .viscera</translation>
    </message>
    <message>
        <source>choose a file with a triangle surface</source>
        <translation>elija un archivo con una superficie de triángulos</translation>
    </message>
    <message>
        <source>choose a larger spacing</source>
        <translation>elija un paso mayor</translation>
    </message>
    <message>
        <source>choose a volume nearer to the present one, or let more handles compensate</source>
        <translation>elija un volumen más próximo al actual, o deje compensar a más tiradores</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>elija otro</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>elija uno de ellos</translation>
    </message>
    <message>
        <source>choose organ, axis or cluster</source>
        <translation>elija organ, axis o cluster</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>elija dos extremos de una superficie</translation>
    </message>
    <message>
        <source>circulation that was kept</source>
        <translation>circulación conservada</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>cierre primero sus agujeros</translation>
    </message>
    <message>
        <source>close other programs, or work with fewer organs or coarser surfaces</source>
        <translation>cierre otros programas, o trabaje con menos órganos o superficies más gruesas</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>las coordenadas necesitan al menos cuatro tiradores, hay %1</translation>
    </message>
    <message>
        <source>diastasis</source>
        <translation>diastasis</translation>
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
        <source>does not lie between 0 and 1</source>
        <translation>no está entre 0 y 1</translation>
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
        <source>expiration</source>
        <translation>espiración</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>exporte de nuevo la superficie</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>llenado del órgano con tetraedros</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>fundus</translation>
    </message>
    <message>
        <source>give it another one</source>
        <translation>déle otro</translation>
    </message>
    <message>
        <source>give it one</source>
        <translation>déle uno</translation>
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
        <source>hold</source>
        <translation>mantener</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>inspiración</translation>
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
        <translation>no está dentro del periodo</translation>
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
        <translation>no está al menos un milisegundo después de la clave anterior</translation>
    </message>
    <message>
        <source>its colour does not lie between 0 and 1</source>
        <translation>su color no está entre 0 y 1</translation>
    </message>
    <message>
        <source>its description is not UTF-8</source>
        <translation>su descripción no es UTF-8</translation>
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
        <source>its handles are not handles of the rig, each once and in their order</source>
        <translation>sus tiradores no son los del conjunto, cada uno una vez y en su orden</translation>
    </message>
    <message>
        <source>its id is another thing's, too</source>
        <translation>su identificador es también el de otra cosa</translation>
    </message>
    <message>
        <source>its id is not a whole number from 1 to 2^52</source>
        <translation>su identificador no es un número entero de 1 a 2^52</translation>
    </message>
    <message>
        <source>its name is not UTF-8</source>
        <translation>su nombre no es UTF-8</translation>
    </message>
    <message>
        <source>its opacity does not lie between 0 and 1</source>
        <translation>su opacidad no está entre 0 y 1</translation>
    </message>
    <message>
        <source>its parent is not an organ before it</source>
        <translation>su órgano superior no está antes que él</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>su posición</translation>
    </message>
    <message>
        <source>its position at rest</source>
        <translation>su posición en reposo</translation>
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
        <translation>sus dos extremos están en piezas separadas</translation>
    </message>
    <message>
        <source>its value is not a finite number</source>
        <translation>su valor no es un número finito</translation>
    </message>
    <message>
        <source>its volume can be kept only when it is bound to the handles there are</source>
        <translation>su volumen solo se puede mantener cuando está vinculado a los tiradores presentes</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>su volumen ya no está bloqueado: la superficie está ahora abierta</translation>
    </message>
    <message>
        <source>its weights are no place in a triangle: they have to be 0 at least, and 1 together</source>
        <translation>sus pesos no son un lugar de un triángulo: deben ser al menos 0 y sumar 1</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clave</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>alargue primero el periodo</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineal</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>medida</translation>
    </message>
    <message>
        <source>measurement %1</source>
        <translation>medida %1</translation>
    </message>
    <message>
        <source>middle line</source>
        <translation>línea media</translation>
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
        <source>move or remove one of them</source>
        <translation>mueva o quite uno de ellos</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>separe allí los vértices, o use otra jaula</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>llámelo %1</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>ninguna arista une más de dos triángulos</translation>
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
        <source>no surface has so many triangles</source>
        <translation>ninguna superficie tiene tantos triángulos</translation>
    </message>
    <message>
        <source>one of its points</source>
        <translation>uno de sus puntos</translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>ábralo junto a los órganos (Archivo &gt; Abrir un estudio), o haga primero un mapa de etiquetas con 3D Slicer o TotalSegmentator</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>abra uno primero</translation>
    </message>
    <message>
        <source>open the other files after it</source>
        <translation>abra los demás archivos después</translation>
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
        <source>parameter %1</source>
        <translation>parámetro %1</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pausa</translation>
    </message>
    <message>
        <source>peak stress over the sequence</source>
        <translation>estrés máximo a lo largo de la secuencia</translation>
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
        <source>place some first</source>
        <translation>coloque algunos primero</translation>
    </message>
    <message>
        <source>point %1 has a coordinate that is not a finite number</source>
        <translation>el punto %1 tiene una coordenada que no es un número finito</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>lo causan puntos que coinciden o casi planos</translation>
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
        <source>rectangle</source>
        <translation>rectángulo</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>eyección reducida</translation>
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
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>derecha e izquierda están intercambiadas, delante y detrás no: reflejado</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>guárdelo primero en un archivo propio</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>guarde a menudo, o haga sitio allí</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suave</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>esfera</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>volumen sistólico</translation>
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
        <source>take the sequence's own handles</source>
        <translation>use los tiradores propios de la secuencia</translation>
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
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>no se puede calcular la envolvente convexa de %1 puntos</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>el archivo no indica sus ejes: se supone LPS</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>el archivo indica sus ejes: %1</translation>
    </message>
    <message>
        <source>the handle %1 comes twice</source>
        <translation>el tirador %1 aparece dos veces</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>los tiradores no encierran nada: %1</translation>
    </message>
    <message>
        <source>the id %1 comes twice</source>
        <translation>el identificador %1 aparece dos veces</translation>
    </message>
    <message>
        <source>the limits of time and memory must be above 0</source>
        <translation>los límites de tiempo y memoria deben ser mayores que 0</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>el nombre de un archivo de sesión termina en .viscera</translation>
    </message>
    <message>
        <source>the organ that it is a cavity of is not before it</source>
        <translation>el órgano del que es cavidad no está antes</translation>
    </message>
    <message>
        <source>the parts of its colour do not lie between 0 and 1</source>
        <translation>las partes de su color no están entre 0 y 1</translation>
    </message>
    <message>
        <source>the period is not a positive number of seconds</source>
        <translation>el periodo no es un número positivo de segundos</translation>
    </message>
    <message>
        <source>the pose has another number of handles than the document</source>
        <translation>la pose tiene otro número de tiradores que el documento</translation>
    </message>
    <message>
        <source>the quality of tetrahedra is a ratio from 1.1 (best) to 10</source>
        <translation>la calidad de los tetraedros es una razón de 1,1 (mejor) a 10</translation>
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
        <source>the surface consists of %1 separate pieces</source>
        <translation>la superficie consta de %1 piezas separadas</translation>
    </message>
    <message>
        <source>the surface does not cross itself</source>
        <translation>la superficie no se cruza consigo misma</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>la superficie tiene %1 triángulos utilizables, así que no encierra nada</translation>
    </message>
    <message>
        <source>the surface has no such triangle</source>
        <translation>la superficie no tiene ese triángulo</translation>
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
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume</source>
        <translation>
            <numerusform>la superficie está abierta (%n arista de borde), así que no tiene volumen</numerusform>
            <numerusform>la superficie está abierta (%n aristas de borde), así que no tiene volumen</numerusform>
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
        <source>the triangles beside a hole do not all run the same way round, so it cannot be closed</source>
        <translation>los triángulos junto a un agujero no giran todos en el mismo sentido, así que no se puede cerrar</translation>
    </message>
    <message>
        <source>the triangles face outward</source>
        <translation>los triángulos miran hacia fuera</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>el volumen no se puede mantener aquí: %1</translation>
    </message>
    <message>
        <source>the weights of a measured point are no place in its triangle</source>
        <translation>los pesos de un punto medido no son un lugar de su triángulo</translation>
    </message>
    <message>
        <source>there is no %1 &quot;%2&quot;</source>
        <translation>«%2» no es un valor de %1</translation>
    </message>
    <message>
        <source>there is no organ %1</source>
        <translation>no hay ningún órgano %1</translation>
    </message>
    <message>
        <source>there is no such slice</source>
        <translation>ese corte no existe</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>no hay ningún triángulo %1</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to make groups</source>
        <translation>no existe la manera «%1» de formar grupos</translation>
    </message>
    <message>
        <source>there is not enough memory for this</source>
        <translation>no hay memoria suficiente para esto</translation>
    </message>
    <message>
        <source>thinning out the surface</source>
        <translation>simplificación de la superficie</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>es un fallo del programa; por favor, comuníquelo</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>triángulo %1</translation>
    </message>
    <message>
        <source>triangle %1 refers to vertex %2, but there are %3</source>
        <translation>el triángulo %1 se refiere al vértice %2, pero hay %3</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>dos grupos tienen este nombre</translation>
    </message>
    <message>
        <source>two handles are at one place</source>
        <translation>dos tiradores están en el mismo lugar</translation>
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
        <source>unsaved work</source>
        <translation>trabajo sin guardar</translation>
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
        <source>use a pose of the same handles</source>
        <translation>use una pose de los mismos tiradores</translation>
    </message>
    <message>
        <source>use one of %1</source>
        <translation>use uno de %1</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>use uno de: %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>vértice %1</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that is not a finite number</source>
        <translation>el vértice %1 tiene una coordenada que no es un número finito</translation>
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
        <source>wait until the witness points are there</source>
        <translation>espere a que estén los puntos testigo</translation>
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
        <translation>onda en el cuerpo</translation>
    </message>
    <message>
        <source>what is measured on it is now at the nearest places of that surface</source>
        <translation>lo medido en él está ahora en los lugares más próximos de esa superficie</translation>
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
        <source>stress line %1</source>
        <translation>línea de estrés %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>sonda de estrés</translation>
    </message>
    <message>
        <source>stress line</source>
        <translation>línea de estrés</translation>
    </message>
    <message>
        <source>its number is not a whole number from 1</source>
        <translation>su número no es un entero desde 1</translation>
    </message>
    <message>
        <source>two stress probes have this number</source>
        <translation>dos sondas de estrés tienen este número</translation>
    </message>
    <message>
        <source>its place at rest</source>
        <translation>su lugar en reposo</translation>
    </message>
    <message>
        <source>it does not join two stress probes of one organ</source>
        <translation>no une dos sondas de estrés de un órgano</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Un perfil necesita dos sondas de un órgano</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Estas dos sondas ya tienen un perfil</translation>
    </message>
</context>
</TS>
