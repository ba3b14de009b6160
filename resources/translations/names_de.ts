<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Ein gesunder Erwachsener im Liegen.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Ein Viertel des Blutvolumens unter Spannung geht verloren; kein Reflex antwortet, sodass die Drücke stärker fallen als im Leben.</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Ein steifer linker Ventrikel, der langsam erschlafft: Er entleert sich gut und füllt sich nur bei hohem Druck.</translation>
    </message>
    <message>
        <source>A weak, dilated left ventricle and retained fluid: the loop lies far to the right, blood backs up to the lungs. Its wall has more muscle and is no thicker.</source>
        <translation>Ein schwacher, erweiterter linker Ventrikel und zurückgehaltene Flüssigkeit: Die Schleife liegt weit rechts, Blut staut sich in die Lunge zurück. Seine Wand hat mehr Muskel und ist nicht dicker.</translation>
    </message>
    <message>
        <source>A wire in the space of balanced vectors; for many points it has no answer</source>
        <translation>Ein Draht im Raum der Vektoren im Gleichgewicht; für viele Punkte hat er keine Lösung</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add enclosing group</source>
        <translation>Umschließende Gruppe hinzufügen</translation>
    </message>
    <message>
        <source>Add enclosing handles</source>
        <translation>Umschließende Griffe hinzufügen</translation>
    </message>
    <message>
        <source>Add group</source>
        <translation>Gruppe hinzufügen</translation>
    </message>
    <message>
        <source>Add to group</source>
        <translation>Zur Gruppe hinzufügen</translation>
    </message>
    <message>
        <source>Afterload: pulmonary resistance</source>
        <translation>Nachlast: pulmonaler Widerstand</translation>
    </message>
    <message>
        <source>Afterload: systemic resistance</source>
        <translation>Nachlast: systemischer Widerstand</translation>
    </message>
    <message>
        <source>An organ needs at least four handles around it: add</source>
        <translation>Ein Organ braucht mindestens vier Griffe um sich: noch hinzuzufügen</translation>
    </message>
    <message>
        <source>An organ needs handles around it</source>
        <translation>Ein Organ braucht Griffe um sich</translation>
    </message>
    <message>
        <source>Antrum</source>
        <translation>Antrum</translation>
    </message>
    <message>
        <source>Any point on the side of the right ventricle</source>
        <translation>Ein beliebiger Punkt auf der Seite des rechten Ventrikels</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorta</translation>
    </message>
    <message>
        <source>Aorta, characteristic impedance</source>
        <translation>Aorta, charakteristische Impedanz</translation>
    </message>
    <message>
        <source>Aorta, diastolic</source>
        <translation>Aorta, diastolisch</translation>
    </message>
    <message>
        <source>Aorta, mean</source>
        <translation>Aorta, Mittel</translation>
    </message>
    <message>
        <source>Aorta, systolic</source>
        <translation>Aorta, systolisch</translation>
    </message>
    <message>
        <source>Aortic arch</source>
        <translation>Aortenbogen</translation>
    </message>
    <message>
        <source>Aortic gradient, mean</source>
        <translation>Aortengradient, Mittel</translation>
    </message>
    <message>
        <source>Aortic stenosis</source>
        <translation>Aortenstenose</translation>
    </message>
    <message>
        <source>Aortic valve</source>
        <translation>Aortenklappe</translation>
    </message>
    <message>
        <source>Aortic valve, leak</source>
        <translation>Aortenklappe, Leck</translation>
    </message>
    <message>
        <source>Aortic valve, open</source>
        <translation>Aortenklappe, offen</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Apex</translation>
    </message>
    <message>
        <source>Appendix</source>
        <translation>Appendix</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Arterial elastance Ea</source>
        <translation>Arterielle Elastance Ea</translation>
    </message>
    <message>
        <source>Arteries</source>
        <translation>Arterien</translation>
    </message>
    <message>
        <source>As near to a target as balance allows; what is done about negative numbers can be chosen</source>
        <translation>So nah an einem Ziel, wie das Gleichgewicht zulässt; was mit negativen Zahlen geschieht, ist wählbar</translation>
    </message>
    <message>
        <source>Ascending aorta</source>
        <translation>Aorta ascendens</translation>
    </message>
    <message>
        <source>Ascending colon</source>
        <translation>Colon ascendens</translation>
    </message>
    <message>
        <source>Atria</source>
        <translation>Vorhöfe</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Bending the scan</source>
        <translation>Scan wird gebogen</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>Gebogen</translation>
    </message>
    <message>
        <source>Beyond the data: people were measured from 50 to 171 beats a minute</source>
        <translation>Jenseits der Daten: Menschen wurden bei 50 bis 171 Schlägen pro Minute gemessen</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>Binding</source>
        <translation>Bindung</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corpus</translation>
    </message>
    <message>
        <source>Body of the stomach</source>
        <translation>Magencorpus</translation>
    </message>
    <message>
        <source>Bones and joints</source>
        <translation>Knochen und Gelenke</translation>
    </message>
    <message>
        <source>Bounded biharmonic weights</source>
        <translation>Beschränkte biharmonische Gewichte</translation>
    </message>
    <message>
        <source>Bradygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Bradygastrie: Gesunde haben 2 bis 4 Wellen pro Minute.</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Atmung</translation>
    </message>
    <message>
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not touch its handles</source>
        <translation>Aus Ecken und Normalen eines Käfigs beliebiger Form; erhält Winkel nahezu und berührt seine Griffe nicht</translation>
    </message>
    <message>
        <source>C-Celestial</source>
        <translation>C-Celestial</translation>
    </message>
    <message>
        <source>Caecum</source>
        <translation>Zäkum</translation>
    </message>
    <message>
        <source>Cardia</source>
        <translation>Kardia</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Herzminutenvolumen</translation>
    </message>
    <message>
        <source>Catalogue of layers</source>
        <translation>Katalog der Lagen</translation>
    </message>
    <message>
        <source>Caudate lobe</source>
        <translation>Lobus caudatus</translation>
    </message>
    <message>
        <source>Centreline</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Gruppe ändern</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Darstellung ändern</translation>
    </message>
    <message>
        <source>Change recording</source>
        <translation>Aufzeichnung ändern</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfung:</translation>
    </message>
    <message>
        <source>Circulation:</source>
        <translation>Kreislauf:</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Löcher schließen</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Gruppe färben</translation>
    </message>
    <message>
        <source>Compensate with</source>
        <translation>Ausgleich mit</translation>
    </message>
    <message>
        <source>Contractility of the left ventricle</source>
        <translation>Kontraktilität des linken Ventrikels</translation>
    </message>
    <message>
        <source>Contractility of the right ventricle</source>
        <translation>Kontraktilität des rechten Ventrikels</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>Coupling Ea/Ees</source>
        <translation>Kopplung Ea/Ees</translation>
    </message>
    <message>
        <source>Delaunay triangulation approach</source>
        <translation>Delaunay-Triangulierungsansatz</translation>
    </message>
    <message>
        <source>Descending colon</source>
        <translation>Colon descendens</translation>
    </message>
    <message>
        <source>Describe</source>
        <translation>Beschreiben</translation>
    </message>
    <message>
        <source>Determinants approach</source>
        <translation>Determinantenansatz</translation>
    </message>
    <message>
        <source>Digestive system</source>
        <translation>Verdauungssystem</translation>
    </message>
    <message>
        <source>Displacement_mm</source>
        <translation>Displacement_mm</translation>
    </message>
    <message>
        <source>Distance from a zone within which its super-region still counts: smoothness against locality</source>
        <translation>Abstand von einer Zone, in dem ihre Superregion noch zählt: Glätte gegen Lokalität</translation>
    </message>
    <message>
        <source>Distance over which the pull of a handle is rounded; 0 passes through the handles</source>
        <translation>Strecke, über die der Zug eines Griffs gerundet wird; 0 geht durch die Griffe</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^level rays</source>
        <translation>Teilungen des Ikosaeders: 20 * 4^level Strahlen</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^samples directions</source>
        <translation>Teilungen des Ikosaeders: 20 * 4^samples Richtungen</translation>
    </message>
    <message>
        <source>Dome under the diaphragm</source>
        <translation>Kuppel unter dem Zwerchfell</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Duodenum</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>EKG</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Edges of tetrahedra across the handles; more are finer and slower</source>
        <translation>Tetraederkanten über die Ausdehnung der Griffe; mehr sind feiner und langsamer</translation>
    </message>
    <message>
        <source>Ejection fraction</source>
        <translation>Ejektionsfraktion</translation>
    </message>
    <message>
        <source>Enclosing</source>
        <translation>Umschließend</translation>
    </message>
    <message>
        <source>End-systolic and relaxed</source>
        <translation>Endsystolisch und erschlafft</translation>
    </message>
    <message>
        <source>Endocrine glands</source>
        <translation>Endokrine Drüsen</translation>
    </message>
    <message>
        <source>Epicardium</source>
        <translation>Epikard</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Belastung</translation>
    </message>
    <message>
        <source>Far corners</source>
        <translation>Ferne Ecken</translation>
    </message>
    <message>
        <source>Filling that multiplies the pericardium's pressure by e</source>
        <translation>Füllung, die den Druck des Perikards mit e multipliziert</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Fluid in the pericardium</source>
        <translation>Flüssigkeit im Perikard</translation>
    </message>
    <message>
        <source>Fluid in the pericardium presses on all chambers: they fill little, and all filling pressures are the same.</source>
        <translation>Flüssigkeit im Perikard drückt auf alle Kammern: Sie füllen sich wenig, und alle Füllungsdrücke sind gleich.</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Gefaltet</translation>
    </message>
    <message>
        <source>Folded tissue</source>
        <translation>Gefaltetes Gewebe</translation>
    </message>
    <message>
        <source>Forget what was before</source>
        <translation>Vorher vergessen</translation>
    </message>
    <message>
        <source>From atrial to ventricular contraction</source>
        <translation>Von der Vorhof- zur Kammerkontraktion</translation>
    </message>
    <message>
        <source>Fundus</source>
        <translation>Fundus</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Magenperistaltik</translation>
    </message>
    <message>
        <source>Gradient method</source>
        <translation>Gradientenverfahren</translation>
    </message>
    <message>
        <source>Great vessels</source>
        <translation>Große Gefäße</translation>
    </message>
    <message>
        <source>Greater curvature</source>
        <translation>Große Kurvatur</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Green</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Group automatically</source>
        <translation>Automatisch gruppieren</translation>
    </message>
    <message>
        <source>Groups of handles move only their own region of the organ; neighbouring regions blend smoothly.</source>
        <translation>Gruppen von Griffen bewegen nur ihre eigene Region des Organs; benachbarte Regionen gehen glatt ineinander über.</translation>
    </message>
    <message>
        <source>Haemorrhage</source>
        <translation>Blutung</translation>
    </message>
    <message>
        <source>Hard upright work: a fast and strong heart, open muscle vessels, veins that give blood back.</source>
        <translation>Schwere aufrechte Arbeit: ein schnelles, kräftiges Herz, offene Muskelgefäße, Venen, die Blut zurückgeben.</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>Harmonisch</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>Heart failure, preserved EF</source>
        <translation>Herzinsuffizienz, erhaltene EF</translation>
    </message>
    <message>
        <source>Heart failure, reduced EF</source>
        <translation>Herzinsuffizienz, reduzierte EF</translation>
    </message>
    <message>
        <source>Heart follows the circulation</source>
        <translation>Herz folgt dem Kreislauf</translation>
    </message>
    <message>
        <source>Heart follows the textbook</source>
        <translation>Herz folgt dem Lehrbuch</translation>
    </message>
    <message>
        <source>Heart rate</source>
        <translation>Herzfrequenz</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Herzschlag</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>How far beyond the handles' hull the weights are computed</source>
        <translation>Wie weit über die Hülle der Griffe hinaus die Gewichte berechnet werden</translation>
    </message>
    <message>
        <source>How much nearer handles count more; 0 as in the thesis</source>
        <translation>Wie viel mehr nähere Griffe zählen; 0 wie in der Dissertation</translation>
    </message>
    <message>
        <source>How near to a flip the two triangulations are blended; 0 for not</source>
        <translation>Wie nah an einem Kantentausch die beiden Triangulierungen überblendet werden; 0 für nicht</translation>
    </message>
    <message>
        <source>How positive balanced vectors are found</source>
        <translation>Wie positive Vektoren im Gleichgewicht gefunden werden</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Wie die Gewichte der Voronoi-Ecken zu den Griffen gelangen</translation>
    </message>
    <message>
        <source>How the wire connects them</source>
        <translation>Wie der Draht sie verbindet</translation>
    </message>
    <message>
        <source>Hypertension</source>
        <translation>Hypertonie</translation>
    </message>
    <message>
        <source>Incremental approach</source>
        <translation>Inkrementeller Ansatz</translation>
    </message>
    <message>
        <source>Inferior vena cava</source>
        <translation>Vena cava inferior</translation>
    </message>
    <message>
        <source>Influence of %1</source>
        <translation>Einfluss von %1</translation>
    </message>
    <message>
        <source>Inner handles of each layer</source>
        <translation>Innere Griffe jeder Lage</translation>
    </message>
    <message>
        <source>Keep as before</source>
        <translation>Als Vorher merken</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>LA-Höhle</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>LV cavity</source>
        <translation>LV-Höhle</translation>
    </message>
    <message>
        <source>LV dP/dt, largest</source>
        <translation>LV dP/dt, Maximum</translation>
    </message>
    <message>
        <source>LV end-diastolic</source>
        <translation>LV enddiastolisch</translation>
    </message>
    <message>
        <source>LV end-diastolic pressure</source>
        <translation>LV enddiastolischer Druck</translation>
    </message>
    <message>
        <source>LV end-systolic</source>
        <translation>LV endsystolisch</translation>
    </message>
    <message>
        <source>LV endocardium</source>
        <translation>LV-Endokard</translation>
    </message>
    <message>
        <source>LV stroke work</source>
        <translation>LV-Schlagarbeit</translation>
    </message>
    <message>
        <source>Lagrange minimisation</source>
        <translation>Lagrange-Minimierung</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Streckung</translation>
    </message>
    <message>
        <source>Lateral border</source>
        <translation>Lateralrand</translation>
    </message>
    <message>
        <source>Leak below its</source>
        <translation>Leck unter seiner</translation>
    </message>
    <message>
        <source>Left anterior descending artery</source>
        <translation>RIVA (LAD)</translation>
    </message>
    <message>
        <source>Left atrium</source>
        <translation>Linker Vorhof</translation>
    </message>
    <message>
        <source>Left atrium, contractility</source>
        <translation>Linker Vorhof, Kontraktilität</translation>
    </message>
    <message>
        <source>Left atrium, mean</source>
        <translation>Linker Vorhof, Mittel</translation>
    </message>
    <message>
        <source>Left atrium, relaxation</source>
        <translation>Linker Vorhof, Relaxation</translation>
    </message>
    <message>
        <source>Left atrium, right ventricle</source>
        <translation>Linker Vorhof, rechter Ventrikel</translation>
    </message>
    <message>
        <source>Left atrium, scale of the relaxed curve</source>
        <translation>Linker Vorhof, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the relaxed curve</source>
        <translation>Linker Vorhof, Steilheit der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Left atrium, volume without pressure</source>
        <translation>Linker Vorhof, Volumen ohne Druck</translation>
    </message>
    <message>
        <source>Left auricle</source>
        <translation>Linkes Herzohr</translation>
    </message>
    <message>
        <source>Left colic flexure</source>
        <translation>Linke Kolonflexur</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Linke Niere</translation>
    </message>
    <message>
        <source>Left lobe</source>
        <translation>Linker Lappen</translation>
    </message>
    <message>
        <source>Left pulmonary artery</source>
        <translation>Linke Pulmonalarterie</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Linker Ventrikel</translation>
    </message>
    <message>
        <source>Left ventricle, relaxation</source>
        <translation>Linker Ventrikel, Relaxation</translation>
    </message>
    <message>
        <source>Left ventricle, scale of the relaxed curve</source>
        <translation>Linker Ventrikel, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Left ventricle, volume without pressure</source>
        <translation>Linker Ventrikel, Volumen ohne Druck</translation>
    </message>
    <message>
        <source>Left ventricular</source>
        <translation>Linksventrikulär</translation>
    </message>
    <message>
        <source>Lesser curvature</source>
        <translation>Kleine Kurvatur</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Localised S-Celestial</source>
        <translation>Lokalisiertes S-Celestial</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Lock volume</source>
        <translation>Volumen sperren</translation>
    </message>
    <message>
        <source>Lower pole</source>
        <translation>Unterer Pol</translation>
    </message>
    <message>
        <source>Lymphatic system</source>
        <translation>Lymphsystem</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean value</source>
        <translation>Mean Value</translation>
    </message>
    <message>
        <source>Mean value of a cage with flat polygons, whose diagonals play no part</source>
        <translation>Mean Value eines Käfigs mit ebenen Vielecken, deren Diagonalen keine Rolle spielen</translation>
    </message>
    <message>
        <source>Mean value of what can be seen of a cage, by rays; positive in any cage</source>
        <translation>Mean Value dessen, was von einem Käfig zu sehen ist, mit Strahlen; positiv in jedem Käfig</translation>
    </message>
    <message>
        <source>Mean value on the hull, inner handles added one by one; they may make some negative</source>
        <translation>Mean Value auf der Hülle, innere Griffe einzeln hinzugefügt; sie können manche negativ machen</translation>
    </message>
    <message>
        <source>Mean value over all tetrahedra of the handles at once, by directions; positive, with many maxima</source>
        <translation>Mean Value über alle Tetraeder der Griffe zugleich, nach Richtungen; positiv, mit vielen Maxima</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Mean Value über die Voronoi-Regionen der Griffe, wie jeder Punkt sie sieht; Sprünge, oder langsam</translation>
    </message>
    <message>
        <source>Mean value over the triangles in which each point sees the handles; jumps, or blended rough</source>
        <translation>Mean Value über die Dreiecke, in denen jeder Punkt die Griffe sieht; Sprünge, oder überblendet und rau</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Middle of the body</source>
        <translation>Mitte des Corpus</translation>
    </message>
    <message>
        <source>Mitral regurgitation</source>
        <translation>Mitralregurgitation</translation>
    </message>
    <message>
        <source>Mitral valve</source>
        <translation>Mitralklappe</translation>
    </message>
    <message>
        <source>Mitral valve, leak</source>
        <translation>Mitralklappe, Leck</translation>
    </message>
    <message>
        <source>Mitral valve, open</source>
        <translation>Mitralklappe, offen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Schlüssel bewegen</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Messpunkt bewegen</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Muskeln</translation>
    </message>
    <message>
        <source>Narrow small arteries and stiff large ones, against which a stronger, stiffer, thicker ventricle works.</source>
        <translation>Enge kleine und steife große Arterien, gegen die ein kräftigerer, steiferer, dickerer Ventrikel arbeitet.</translation>
    </message>
    <message>
        <source>Natural neighbours</source>
        <translation>Natürliche Nachbarn</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Nervous system</source>
        <translation>Nervensystem</translation>
    </message>
    <message>
        <source>Numerical integration approach</source>
        <translation>Numerischer Integrationsansatz</translation>
    </message>
    <message>
        <source>Oesophagus</source>
        <translation>Ösophagus</translation>
    </message>
    <message>
        <source>Of the random numbers</source>
        <translation>Startwert der Zufallszahlen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>PR interval, 0.12 to 0.20 s</source>
        <translation>PR-Intervall (PQ-Zeit), 0,12 bis 0,20 s</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Bauchspeicheldrüse</translation>
    </message>
    <message>
        <source>Peak of %1</source>
        <translation>Spitze: %1</translation>
    </message>
    <message>
        <source>Peak stress</source>
        <translation>Spitzenstress</translation>
    </message>
    <message>
        <source>Points along the middle of the stomach, from the fundus down</source>
        <translation>Punkte entlang der Mitte des Magens, vom Fundus abwärts</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Positive mean value</source>
        <translation>Positive Mean Value</translation>
    </message>
    <message>
        <source>Preload: stressed blood volume</source>
        <translation>Vorlast: Blutvolumen unter Spannung</translation>
    </message>
    <message>
        <source>Pressure (mmHg)</source>
        <translation>Druck (mmHg)</translation>
    </message>
    <message>
        <source>Pulmonary arteries, compliance</source>
        <translation>Pulmonalarterien, Compliance</translation>
    </message>
    <message>
        <source>Pulmonary artery</source>
        <translation>Pulmonalarterie</translation>
    </message>
    <message>
        <source>Pulmonary artery, characteristic impedance</source>
        <translation>Pulmonalarterie, charakteristische Impedanz</translation>
    </message>
    <message>
        <source>Pulmonary artery, mean</source>
        <translation>Pulmonalarterie, Mittel</translation>
    </message>
    <message>
        <source>Pulmonary artery, systolic</source>
        <translation>Pulmonalarterie, systolisch</translation>
    </message>
    <message>
        <source>Pulmonary trunk</source>
        <translation>Truncus pulmonalis</translation>
    </message>
    <message>
        <source>Pulmonary valve, leak</source>
        <translation>Pulmonalklappe, Leck</translation>
    </message>
    <message>
        <source>Pulmonary valve, open</source>
        <translation>Pulmonalklappe, offen</translation>
    </message>
    <message>
        <source>Pulmonary vein</source>
        <translation>Pulmonalvene</translation>
    </message>
    <message>
        <source>Pulmonary veins, compliance</source>
        <translation>Pulmonalvenen, Compliance</translation>
    </message>
    <message>
        <source>Pulmonary veins, resistance</source>
        <translation>Pulmonalvenen, Widerstand</translation>
    </message>
    <message>
        <source>Pylorus</source>
        <translation>Pylorus</translation>
    </message>
    <message>
        <source>RA cavity</source>
        <translation>RA-Höhle</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>RV cavity</source>
        <translation>RV-Höhle</translation>
    </message>
    <message>
        <source>RV ejection fraction</source>
        <translation>RV-Ejektionsfraktion</translation>
    </message>
    <message>
        <source>RV end-diastolic</source>
        <translation>RV enddiastolisch</translation>
    </message>
    <message>
        <source>RV end-systolic</source>
        <translation>RV endsystolisch</translation>
    </message>
    <message>
        <source>RV free wall</source>
        <translation>Freie RV-Wand</translation>
    </message>
    <message>
        <source>RV stroke work</source>
        <translation>RV-Schlagarbeit</translation>
    </message>
    <message>
        <source>Rational coordinates of a convex cage; positive and smooth inside</source>
        <translation>Rationale Koordinaten eines konvexen Käfigs; innen positiv und glatt</translation>
    </message>
    <message>
        <source>Record key</source>
        <translation>Schlüssel aufzeichnen</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Rectum</source>
        <translation>Rektum</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove all measurements</source>
        <translation>Alle Messungen entfernen</translation>
    </message>
    <message>
        <source>Remove all organs</source>
        <translation>Alle Organe entfernen</translation>
    </message>
    <message>
        <source>Remove from group</source>
        <translation>Aus Gruppe entfernen</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Gruppe entfernen</translation>
    </message>
    <message>
        <source>Renal artery</source>
        <translation>Nierenarterie</translation>
    </message>
    <message>
        <source>Renal pelvis</source>
        <translation>Nierenbecken</translation>
    </message>
    <message>
        <source>Renal vein</source>
        <translation>Nierenvene</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Gruppe umbenennen</translation>
    </message>
    <message>
        <source>Rename handle</source>
        <translation>Griff umbenennen</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>Messung umbenennen</translation>
    </message>
    <message>
        <source>Rename organ</source>
        <translation>Organ umbenennen</translation>
    </message>
    <message>
        <source>Repairing</source>
        <translation>Reparatur:</translation>
    </message>
    <message>
        <source>Replace pose of key</source>
        <translation>Pose des Schlüssels ersetzen</translation>
    </message>
    <message>
        <source>Replace recording</source>
        <translation>Aufzeichnung ersetzen</translation>
    </message>
    <message>
        <source>Reproductive system</source>
        <translation>Geschlechtsorgane</translation>
    </message>
    <message>
        <source>Reset pose</source>
        <translation>Pose zurücksetzen</translation>
    </message>
    <message>
        <source>Respiratory system</source>
        <translation>Atmungssystem</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Right atrium</source>
        <translation>Rechter Vorhof</translation>
    </message>
    <message>
        <source>Right atrium, contractility</source>
        <translation>Rechter Vorhof, Kontraktilität</translation>
    </message>
    <message>
        <source>Right atrium, mean</source>
        <translation>Rechter Vorhof, Mittel</translation>
    </message>
    <message>
        <source>Right atrium, relaxation</source>
        <translation>Rechter Vorhof, Relaxation</translation>
    </message>
    <message>
        <source>Right atrium, scale of the relaxed curve</source>
        <translation>Rechter Vorhof, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the relaxed curve</source>
        <translation>Rechter Vorhof, Steilheit der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Right atrium, volume without pressure</source>
        <translation>Rechter Vorhof, Volumen ohne Druck</translation>
    </message>
    <message>
        <source>Right colic flexure</source>
        <translation>Rechte Kolonflexur</translation>
    </message>
    <message>
        <source>Right coronary artery</source>
        <translation>Rechte Koronararterie</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Rechte Niere</translation>
    </message>
    <message>
        <source>Right lobe</source>
        <translation>Rechter Lappen</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Rechter Ventrikel</translation>
    </message>
    <message>
        <source>Right ventricle, relaxation</source>
        <translation>Rechter Ventrikel, Relaxation</translation>
    </message>
    <message>
        <source>Right ventricle, scale of the relaxed curve</source>
        <translation>Rechter Ventrikel, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the relaxed curve</source>
        <translation>Rechter Ventrikel, Steilheit der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Right ventricle, volume without pressure</source>
        <translation>Rechter Ventrikel, Volumen ohne Druck</translation>
    </message>
    <message>
        <source>Right ventricular</source>
        <translation>Rechtsventrikulär</translation>
    </message>
    <message>
        <source>Rotational stress</source>
        <translation>Rotationsstress</translation>
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
        <translation>Stichproben je Punkt</translation>
    </message>
    <message>
        <source>Septum</source>
        <translation>Septum</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Sibson's coordinates: what a point takes from its neighbours' Voronoi cells; positive and local</source>
        <translation>Sibson-Koordinaten: was ein Punkt den Voronoi-Zellen seiner Nachbarn nimmt; positiv und lokal</translation>
    </message>
    <message>
        <source>Sigmoid colon</source>
        <translation>Colon sigmoideum</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Haut und Fett</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Dünndarm</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Kleinste Streckung</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; maximum entropy over directions</source>
        <translation>Glatt und positiv, allein aus Punkten; maximale Entropie über Richtungen</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; the thesis's choice for organs</source>
        <translation>Glatt und positiv, allein aus Punkten; die Wahl der Dissertation für Organe</translation>
    </message>
    <message>
        <source>Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes</source>
        <translation>Lösungen der Laplace-Gleichung in einem Käfig beliebiger Form; lokal und ohne negative Ausläufer</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Spherical mean value</source>
        <translation>Sphärische Mean Value</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>Stiffness of the left ventricle</source>
        <translation>Steifigkeit des linken Ventrikels</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>Stomach and bowel</source>
        <translation>Magen und Darm</translation>
    </message>
    <message>
        <source>Stop compensating with</source>
        <translation>Kein Ausgleich mit</translation>
    </message>
    <message>
        <source>Stress at the witness points</source>
        <translation>Stress an den Messpunkten</translation>
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
        <translation>Schlagvolumen</translation>
    </message>
    <message>
        <source>Superior vena cava</source>
        <translation>Vena cava superior</translation>
    </message>
    <message>
        <source>System used inside each region</source>
        <translation>In jeder Region verwendetes System</translation>
    </message>
    <message>
        <source>Systemic arteries, compliance</source>
        <translation>Systemarterien, Compliance</translation>
    </message>
    <message>
        <source>Systemic veins, compliance</source>
        <translation>Systemvenen, Compliance</translation>
    </message>
    <message>
        <source>Systemic veins, resistance</source>
        <translation>Systemvenen, Widerstand</translation>
    </message>
    <message>
        <source>T-Celestial</source>
        <translation>T-Celestial</translation>
    </message>
    <message>
        <source>Tachygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Tachygastrie: Gesunde haben 2 bis 4 Wellen pro Minute.</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>Take the cage</source>
        <translation>Käfig übernehmen</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponade</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>Die Aortenklappe öffnet sich auf 0,8 cm2: Der Druck des hypertrophierten Ventrikels liegt weit über dem der Aorta.</translation>
    </message>
    <message>
        <source>The centre of all positive answers, by sampling; as good as the number of samples</source>
        <translation>Die Mitte aller positiven Lösungen, durch Stichproben; so gut wie deren Anzahl</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Die klassischen Koordinaten eines geschlossenen Käfigs; positiv, wo der Käfig konvex ist</translation>
    </message>
    <message>
        <source>The mean over all tetrahedra of handles around a point; jumps where their number changes</source>
        <translation>Das Mittel über alle Tetraeder von Griffen um einen Punkt; springt, wo deren Anzahl sich ändert</translation>
    </message>
    <message>
        <source>The mean over the hull and partitions of it by the inner handles; kinks at their faces</source>
        <translation>Das Mittel über die Hülle und ihre Zerlegungen durch die inneren Griffe; Knicke an deren Flächen</translation>
    </message>
    <message>
        <source>The middle of the mitral valve, inside the heart</source>
        <translation>Die Mitte der Mitralklappe, im Innern des Herzens</translation>
    </message>
    <message>
        <source>The mitral valve leaks through 0.4 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>Die Mitralklappe leckt durch 0,4 cm2: Die Hälfte dessen, was der Ventrikel auswirft, fließt in den Vorhof zurück.</translation>
    </message>
    <message>
        <source>The numbers to stay near to</source>
        <translation>Zahlen, denen das Ergebnis nahe bleibt</translation>
    </message>
    <message>
        <source>The outlet of the stomach</source>
        <translation>Der Magenausgang</translation>
    </message>
    <message>
        <source>The points of n-space that the wire connects</source>
        <translation>Die Punkte des n-Raums, die der Draht verbindet</translation>
    </message>
    <message>
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>Die kleinste Zahl wird so hoch gehoben, wie es geht; positiv, mit Knicken</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>Die Oberfläche wurde vor dem Füllen repariert.</translation>
    </message>
    <message>
        <source>The thesis's radius; it cancels in the coordinates and changes nothing</source>
        <translation>Der Radius der Dissertation; er kürzt sich in den Koordinaten heraus und ändert nichts</translation>
    </message>
    <message>
        <source>The tip of the heart</source>
        <translation>Die Herzspitze</translation>
    </message>
    <message>
        <source>The top of the fundus</source>
        <translation>Der höchste Punkt des Fundus</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Die Messpunkte liegen auf einem regelmäßigen Gitter in der Oberfläche.</translation>
    </message>
    <message>
        <source>There are</source>
        <translation>Es gibt</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Verdickung</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Transverse colon</source>
        <translation>Colon transversum</translation>
    </message>
    <message>
        <source>Tricuspid valve, leak</source>
        <translation>Trikuspidalklappe, Leck</translation>
    </message>
    <message>
        <source>Tricuspid valve, open</source>
        <translation>Trikuspidalklappe, offen</translation>
    </message>
    <message>
        <source>Turns the directions at random; 0 leaves the icosahedron upright</source>
        <translation>Dreht die Richtungen zufällig; 0 lässt das Ikosaeder aufrecht</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Processus uncinatus</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Unlock volume</source>
        <translation>Volumen entsperren</translation>
    </message>
    <message>
        <source>Upper pole</source>
        <translation>Oberer Pol</translation>
    </message>
    <message>
        <source>Ureter</source>
        <translation>Ureter</translation>
    </message>
    <message>
        <source>Urinary system</source>
        <translation>Harnsystem</translation>
    </message>
    <message>
        <source>Use the hull as the cage</source>
        <translation>Hülle als Käfig verwenden</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Venen</translation>
    </message>
    <message>
        <source>Viscera:</source>
        <translation>Viscera:</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Volumenverhältnis</translation>
    </message>
    <message>
        <source>VolumeRatio</source>
        <translation>VolumeRatio</translation>
    </message>
    <message>
        <source>Voronoi regions triangulation</source>
        <translation>Triangulierung der Voronoi-Regionen</translation>
    </message>
    <message>
        <source>Wachspress</source>
        <translation>Wachspress</translation>
    </message>
    <message>
        <source>Weights of least bending between 0 and 1; smooth and local, and follow translations only</source>
        <translation>Gewichte kleinster Biegung zwischen 0 und 1; glatt und lokal, folgen nur Verschiebungen</translation>
    </message>
    <message>
        <source>What is added to every weight when a handle comes in</source>
        <translation>Was zu jedem Gewicht addiert wird, wenn ein Griff hinzukommt</translation>
    </message>
    <message>
        <source>What is done about negative numbers</source>
        <translation>Was mit negativen Zahlen geschieht</translation>
    </message>
    <message>
        <source>What the hull is divided into</source>
        <translation>Worin die Hülle geteilt wird</translation>
    </message>
    <message>
        <source>What the pericardium holds without pressing</source>
        <translation>Was das Perikard ohne Druck fasst</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Wann der Anstieg der kleinsten Zahl endet</translation>
    </message>
    <message>
        <source>Where 'iterative' moves the target</source>
        <translation>Wohin 'iterative' das Ziel verschiebt</translation>
    </message>
    <message>
        <source>Where waves arise, about a third of the way down</source>
        <translation>Wo Wellen entstehen, nach etwa einem Drittel des Wegs</translation>
    </message>
    <message>
        <source>Wire approach</source>
        <translation>Drahtansatz</translation>
    </message>
    <message>
        <source>Witness</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Witness points of</source>
        <translation>Messpunkte von</translation>
    </message>
    <message>
        <source>antrum</source>
        <translation>Antrum</translation>
    </message>
    <message>
        <source>atrial systole</source>
        <translation>Vorhofsystole</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Korpus</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>Herzzeitvolumen</translation>
    </message>
    <message>
        <source>diastasis</source>
        <translation>Diastase</translation>
    </message>
    <message>
        <source>diastole</source>
        <translation>Diastole</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>Ejektionsfraktion</translation>
    </message>
    <message>
        <source>end-diastolic volume</source>
        <translation>enddiastolisches Volumen</translation>
    </message>
    <message>
        <source>end-systolic volume</source>
        <translation>endsystolisches Volumen</translation>
    </message>
    <message>
        <source>expiration</source>
        <translation>Ausatmung</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>Fundus</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>in</source>
        <translation>anlaufend</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>Einatmung</translation>
    </message>
    <message>
        <source>isovolumic contraction</source>
        <translation>isovolumetrische Kontraktion</translation>
    </message>
    <message>
        <source>isovolumic relaxation</source>
        <translation>isovolumetrische Relaxation</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>out</source>
        <translation>auslaufend</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>pylorus</source>
        <translation>Pylorus</translation>
    </message>
    <message>
        <source>rapid ejection</source>
        <translation>schnelle Austreibung</translation>
    </message>
    <message>
        <source>rapid filling</source>
        <translation>schnelle Füllung</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>langsame Austreibung</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>Schlagvolumen</translation>
    </message>
    <message>
        <source>systole</source>
        <translation>Systole</translation>
    </message>
    <message>
        <source>terminal antral contraction</source>
        <translation>terminale Antrumkontraktion</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>Volumen nach einer Mahlzeit</translation>
    </message>
    <message>
        <source>volume of the muscle</source>
        <translation>Volumen des Muskels</translation>
    </message>
    <message>
        <source>volume with its blood</source>
        <translation>Volumen mit seinem Blut</translation>
    </message>
    <message>
        <source>wave fades at the pylorus</source>
        <translation>Welle läuft am Pylorus aus</translation>
    </message>
    <message>
        <source>wave in the antrum</source>
        <translation>Welle im Antrum</translation>
    </message>
    <message>
        <source>wave in the body</source>
        <translation>Welle im Korpus</translation>
    </message>
</context>
</TS>
