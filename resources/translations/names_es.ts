<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adulto sano en decúbito.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Se pierde una cuarta parte del volumen sanguíneo estresado; no responde ningún reflejo, por lo que las presiones bajan más que en la realidad.</translation>
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
        <source>Add</source>
        <translation>Añadir</translation>
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
        <source>Add to group</source>
        <translation>Añadir al grupo</translation>
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
        <source>An organ needs at least four handles around it: add</source>
        <translation>Un órgano necesita al menos cuatro tiradores en torno a él: añada</translation>
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
        <source>Binding</source>
        <translation>Vinculación</translation>
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
        <source>Checking</source>
        <translation>Comprobando</translation>
    </message>
    <message>
        <source>Circulation:</source>
        <translation>Circulación:</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Cerrar orificios</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Colorear grupo</translation>
    </message>
    <message>
        <source>Compensate with</source>
        <translation>Compensar con</translation>
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
    <message>
        <source>Describe</source>
        <translation>Describir</translation>
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
        <source>Easing</source>
        <translation>Aceleración</translation>
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
        <source>Left atrium, scale of the relaxed curve</source>
        <translation>Aurícula izquierda, escala de la curva relajada</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the relaxed curve</source>
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
        <source>Left ventricle, scale of the relaxed curve</source>
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
        <source>Measure</source>
        <translation>Medir</translation>
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
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Mover clave</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Mover punto medido</translation>
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
        <source>Remove</source>
        <translation>Quitar</translation>
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
        <source>Repairing</source>
        <translation>Reparando</translation>
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
        <source>Right atrium, scale of the relaxed curve</source>
        <translation>Aurícula derecha, escala de la curva relajada</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the relaxed curve</source>
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
        <source>Right ventricle, scale of the relaxed curve</source>
        <translation>Ventrículo derecho, escala de la curva relajada</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the relaxed curve</source>
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
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
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
    <message>
        <source>Stop compensating with</source>
        <translation>Dejar de compensar con</translation>
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
        <source>Take the cage</source>
        <translation>Tomar la jaula</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Taponamiento</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>La válvula aórtica se abre hasta 0,8 cm2: la presión del ventrículo hipertrofiado supera con mucho la de la aorta.</translation>
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
        <source>The numbers to stay near to</source>
        <translation>Los números a los que aproximarse</translation>
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
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>El número menor se eleva tanto como se pueda; positivo, con dobleces</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>La superficie se reparó antes de llenarla.</translation>
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
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Los puntos testigo están en una cuadrícula regular dentro de la superficie.</translation>
    </message>
    <message>
        <source>There are</source>
        <translation>Hay</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Engrosamiento</translation>
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
        <source>Witness points of</source>
        <translation>Puntos testigo de</translation>
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
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>gasto cardíaco</translation>
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
        <source>fundus</source>
        <translation>fundus</translation>
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
        <source>linear</source>
        <translation>lineal</translation>
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
        <source>reduced ejection</source>
        <translation>eyección reducida</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suave</translation>
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
        <source>terminal antral contraction</source>
        <translation>contracción antral terminal</translation>
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
</context>
</TS>
