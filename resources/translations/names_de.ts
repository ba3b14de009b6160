<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>&quot;%1&quot; is %2 instead of &quot;%3&quot;</source>
        <translation>„%1“ ist %2 statt „%3“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither true nor false</source>
        <translation>„%1“ ist weder wahr noch falsch</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list</source>
        <translation>„%1“ ist keine Liste</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a text</source>
        <translation>„%1“ ist kein Text</translation>
    </message>
    <message>
        <source>&quot;version&quot; is not a positive whole number</source>
        <translation>„version“ ist keine positive ganze Zahl</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 gives another surface than the one that was saved</source>
        <translation>%1 ergibt eine andere Oberfläche als die gespeicherte</translation>
    </message>
    <message>
        <source>%1 has changed since the session was saved</source>
        <translation>%1 hat sich seit dem Speichern der Sitzung geändert</translation>
    </message>
    <message>
        <source>%1 is farther away than a thousand kilometres</source>
        <translation>%1 ist weiter als tausend Kilometer entfernt</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 von mehr als 1 GB passt nicht in eine Sitzungsdatei</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>%1, %2 of them crumbs of less than 2 % of its area</source>
        <translation>%1, davon %2 Krümel mit weniger als 2 % der Fläche</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, geändert</translation>
    </message>
    <message>
        <source>%1, handle %2</source>
        <translation>%1, Griff %2</translation>
    </message>
    <message>
        <source>%1, handles %2 and %3</source>
        <translation>%1, Griffe %2 und %3</translation>
    </message>
    <message>
        <source>%1, key at %2 s</source>
        <translation>%1, Schlüssel bei %2 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1: „%2“ ist unbekannt und wird nicht wieder gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; look whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
        <translation>
            <numerusform>%2 liegt außerhalb des Scans; prüfen Sie, ob beide vom selben Patienten stammen und dieselben Achsen haben (RAS oder LPS)</numerusform>
            <numerusform>%2 liegen außerhalb des Scans; prüfen Sie, ob alle vom selben Patienten stammen und dieselben Achsen haben (RAS oder LPS)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary {edge|edges}: the surface is open and has no volume</source>
        <translation>
            <numerusform>%n Randkante: die Oberfläche ist offen und hat kein Volumen</numerusform>
            <numerusform>%n Randkanten: die Oberfläche ist offen und hat kein Volumen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge joins|edges join} more than two triangles</source>
        <translation>
            <numerusform>%n Kante verbindet mehr als zwei Dreiecke</numerusform>
            <numerusform>%n Kanten verbinden mehr als zwei Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge lies|edges lie} between triangles of opposite orientation</source>
        <translation>
            <numerusform>%n Kante liegt zwischen Dreiecken entgegengesetzter Richtung</numerusform>
            <numerusform>%n Kanten liegen zwischen Dreiecken entgegengesetzter Richtung</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles}</source>
        <translation>
            <numerusform>%n Griff</numerusform>
            <numerusform>%n Griffe</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to repair the surface first</source>
        <translation>
            <numerusform>%n Paar von Dreiecken durchdringt sich: der Spannungsmodus muss die Oberfläche vielleicht erst reparieren</numerusform>
            <numerusform>%n Paare von Dreiecken durchdringen sich: der Spannungsmodus muss die Oberfläche vielleicht erst reparieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle has|triangles have} no area</source>
        <translation>
            <numerusform>%n Dreieck hat keine Fläche</numerusform>
            <numerusform>%n Dreiecke haben keine Fläche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle was|triangles were} turned around to face outward.</source>
        <translation>
            <numerusform>%n Dreieck wurde nach außen gewendet.</numerusform>
            <numerusform>%n Dreiecke wurden nach außen gewendet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle without area or that came twice is|triangles without area or that came twice are} left out.</source>
        <translation>
            <numerusform>%n Dreieck ohne Fläche oder das doppelt vorkam, ist weggelassen.</numerusform>
            <numerusform>%n Dreiecke ohne Fläche oder die doppelt vorkamen, sind weggelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>A cavity has to come after the organ that it is in</source>
        <translation>Eine Höhle muss nach dem Organ kommen, in dem sie liegt</translation>
    </message>
    <message>
        <source>A group names a handle that is not there</source>
        <translation>Eine Gruppe nennt einen Griff, den es nicht gibt</translation>
    </message>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Ein gesunder Erwachsener im Liegen.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Ein Viertel des Blutvolumens unter Spannung geht verloren; kein Reflex antwortet, sodass die Drücke stärker fallen als im Leben.</translation>
    </message>
    <message>
        <source>A rectangle lies in an axial, coronal or sagittal slice</source>
        <translation>Ein Rechteck liegt in einem axialen, koronalen oder sagittalen Schnitt</translation>
    </message>
    <message>
        <source>A row has four numbers</source>
        <translation>Eine Zeile hat vier Zahlen</translation>
    </message>
    <message>
        <source>A scan has three axes</source>
        <translation>Ein Scan hat drei Achsen</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Eine Sitzung wird allein geöffnet</translation>
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
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>Add %n {organ|organs}</source>
        <translation>
            <numerusform>%n Organ hinzufügen</numerusform>
            <numerusform>%n Organe hinzufügen</numerusform>
        </translation>
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
        <source>Add group %1</source>
        <translation>Gruppe %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add to group</source>
        <translation>Zur Gruppe hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>Add {handle|%n handles}</source>
        <translation>
            <numerusform>Griff hinzufügen</numerusform>
            <numerusform>%n Griffe hinzufügen</numerusform>
        </translation>
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
        <source>An angle needs three points, any other measurement two</source>
        <translation>Ein Winkel braucht drei Punkte, jede andere Messung zwei</translation>
    </message>
    <message>
        <source>An organ needs a surface</source>
        <translation>Ein Organ braucht eine Oberfläche</translation>
    </message>
    <message>
        <source>An organ needs at least four handles around it: add %1 more</source>
        <translation>Ein Organ braucht mindestens vier Griffe um sich: fügen Sie noch %1 hinzu</translation>
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
        <source>Binding %1</source>
        <translation>Bindung von %1</translation>
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
        <source>Checking %1</source>
        <translation>Prüfung von %1</translation>
    </message>
    <message>
        <source>Circulation: %1</source>
        <translation>Kreislauf: %1</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Löcher schließen</translation>
    </message>
    <message>
        <source>Close scan</source>
        <translation>Scan schließen</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Gruppe färben</translation>
    </message>
    <message numerus="yes">
        <source>Compensate with {handle|%n handles}</source>
        <translation>
            <numerusform>Mit diesem Griff ausgleichen</numerusform>
            <numerusform>Mit %n Griffen ausgleichen</numerusform>
        </translation>
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
        <source>Coordinates %1</source>
        <translation>Koordinaten %1</translation>
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
    <message numerus="yes">
        <source>Describe {handle|%n handles}</source>
        <translation>
            <numerusform>Griff beschreiben</numerusform>
            <numerusform>%n Griffe beschreiben</numerusform>
        </translation>
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
        <source>Easing %1</source>
        <translation>Übergang %1</translation>
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
        <source>Fitted circulation</source>
        <translation>Angepasster Kreislauf</translation>
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
    <message numerus="yes">
        <source>Hide {handle|%n handles}</source>
        <translation>
            <numerusform>Griff verbergen</numerusform>
            <numerusform>%n Griffe verbergen</numerusform>
        </translation>
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
        <source>It cannot be read</source>
        <translation>Sie kann nicht gelesen werden</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Sie durchdringt sich selbst, an %n Paar von Dreiecken</numerusform>
            <numerusform>Sie durchdringt sich selbst, an %n Paaren von Dreiecken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {vertex|vertices}</source>
        <translation>
            <numerusform>Sie hat %n Eckpunkt</numerusform>
            <numerusform>Sie hat %n Eckpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>It has no &quot;%1&quot;</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>Es hat keine Oberfläche „%1“</translation>
    </message>
    <message>
        <source>It has to be a text</source>
        <translation>Es muss ein Text sein</translation>
    </message>
    <message>
        <source>It holds less than %1</source>
        <translation>Es enthält weniger als %1</translation>
    </message>
    <message>
        <source>It is a scan and no organ</source>
        <translation>Es ist ein Scan und kein Organ</translation>
    </message>
    <message>
        <source>It is damaged: it does not hold %1</source>
        <translation>Es ist beschädigt: es enthält nicht %1</translation>
    </message>
    <message>
        <source>It is damaged: its SHA-256 is not %1</source>
        <translation>Es ist beschädigt: sein SHA-256 ist nicht %1</translation>
    </message>
    <message>
        <source>It is neither &quot;embedded&quot; nor &quot;linked&quot;</source>
        <translation>Es ist weder „embedded“ noch „linked“</translation>
    </message>
    <message>
        <source>It is nested too deeply</source>
        <translation>Es ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>Es ist keine Datei der Art %1: ihr „format“ ist nicht „%2“</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>Es ist keine lesbare Datei</translation>
    </message>
    <message>
        <source>It is not a finite number</source>
        <translation>Es ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>It is not a list of three numbers</source>
        <translation>Es ist keine Liste aus drei Zahlen</translation>
    </message>
    <message>
        <source>It is not a text</source>
        <translation>Es ist kein Text</translation>
    </message>
    <message>
        <source>It is not a triangle of three handles</source>
        <translation>Es ist kein Dreieck aus drei Griffen</translation>
    </message>
    <message>
        <source>It is not a whole number from 0 to 2^53</source>
        <translation>Es ist keine ganze Zahl von 0 bis 2^53</translation>
    </message>
    <message>
        <source>It is not an object</source>
        <translation>Es ist kein Objekt</translation>
    </message>
    <message>
        <source>It is not base64</source>
        <translation>Es ist kein Base64</translation>
    </message>
    <message>
        <source>It is not complete JSON: %1</source>
        <translation>Es ist kein vollständiges JSON: %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>Sie hat die Version %1; dieses Programm liest bis %2</translation>
    </message>
    <message>
        <source>It is too long</source>
        <translation>Es ist zu lang</translation>
    </message>
    <message>
        <source>Its axes lie in one plane</source>
        <translation>Seine Achsen liegen in einer Ebene</translation>
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
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Linker Vorhof, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
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
        <source>Left ventricle, scale of the passive filling curve</source>
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
    <message numerus="yes">
        <source>Lock {handle|%n handles}</source>
        <translation>
            <numerusform>Griff sperren</numerusform>
            <numerusform>%n Griffe sperren</numerusform>
        </translation>
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
        <source>Measure %1</source>
        <translation>Messen: %1</translation>
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
        <source>Move key</source>
        <translation>Schlüssel bewegen</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Messpunkt bewegen</translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles}</source>
        <translation>
            <numerusform>Griff bewegen</numerusform>
            <numerusform>%n Griffe bewegen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles} at rest</source>
        <translation>
            <numerusform>Griff in Ruhe bewegen</numerusform>
            <numerusform>%n Griffe in Ruhe bewegen</numerusform>
        </translation>
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
        <source>No scan has %1 voxels along an axis</source>
        <translation>Kein Scan hat %1 Voxel entlang einer Achse</translation>
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
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message numerus="yes">
        <source>Open %n {file|files}</source>
        <translation>
            <numerusform>%n Datei öffnen</numerusform>
            <numerusform>%n Dateien öffnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Open scan %1</source>
        <translation>Scan %1 öffnen</translation>
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
    <message numerus="yes">
        <source>Remove {handle|%n handles}</source>
        <translation>
            <numerusform>Griff entfernen</numerusform>
            <numerusform>%n Griffe entfernen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {key|%n keys}</source>
        <translation>
            <numerusform>Schlüssel entfernen</numerusform>
            <numerusform>%n Schlüssel entfernen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Messung entfernen</numerusform>
            <numerusform>%n Messungen entfernen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {organ|%n organs}</source>
        <translation>
            <numerusform>Organ entfernen</numerusform>
            <numerusform>%n Organe entfernen</numerusform>
        </translation>
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
        <source>Repairing %1</source>
        <translation>Reparatur von %1</translation>
    </message>
    <message>
        <source>Replace handles</source>
        <translation>Griffe ersetzen</translation>
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
        <source>Right atrium, scale of the passive filling curve</source>
        <translation>Rechter Vorhof, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
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
        <source>Right ventricle, scale of the passive filling curve</source>
        <translation>Rechter Ventrikel, Skala der Ruhedehnungskurve</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
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
        <source>Set %1</source>
        <translation>%1 einstellen</translation>
    </message>
    <message>
        <source>Set pose</source>
        <translation>Pose setzen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message numerus="yes">
        <source>Show {handle|%n handles}</source>
        <translation>
            <numerusform>Griff zeigen</numerusform>
            <numerusform>%n Griffe zeigen</numerusform>
        </translation>
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
    <message numerus="yes">
        <source>Stop compensating with {handle|%n handles}</source>
        <translation>
            <numerusform>Nicht mehr mit diesem Griff ausgleichen</numerusform>
            <numerusform>Nicht mehr mit %n Griffen ausgleichen</numerusform>
        </translation>
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
        <source>Surfaces are cut by at most 8 planes at once, not by %1</source>
        <translation>Oberflächen werden von höchstens 8 Ebenen zugleich geschnitten, nicht von %1</translation>
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
        <source>Take the cage %1</source>
        <translation>Käfig %1 verwenden</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponade</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen hat keinen Punkt in die Oberfläche gesetzt</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>Die Aortenklappe öffnet sich auf 0,8 cm2: Der Druck des hypertrophierten Ventrikels liegt weit über dem der Aorta.</translation>
    </message>
    <message>
        <source>The cage names a handle that is not there</source>
        <translation>Der Käfig nennt einen Griff, den es nicht gibt</translation>
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
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>Die Labelmap von %1 hat ein anderes Gitter (%2) als der Scan (%3); jede liegt dort, wo ihre Datei es sagt, und nichts wird umgerechnet</translation>
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
        <source>The number of witness points must be from %1 to %2</source>
        <translation>Die Zahl der Messpunkte muss zwischen %1 und %2 liegen</translation>
    </message>
    <message>
        <source>The numbers to stay near to</source>
        <translation>Zahlen, denen das Ergebnis nahe bleibt</translation>
    </message>
    <message>
        <source>The organ that this cavity is in is not there any more</source>
        <translation>Das Organ, in dem diese Höhle liegt, ist nicht mehr da</translation>
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
        <source>The pose has %1 handles, the document %2</source>
        <translation>Die Pose hat %1 Griffe, das Dokument %2</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>Die Pose hat eine Position, die keine endliche Zahl oder zu weit entfernt ist</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>Die Sequenz bewegt %1 Griffe, es gibt aber %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>Die Sequenz wurde für einen anderen Ort eines Griffs gemacht</translation>
    </message>
    <message>
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>Die kleinste Zahl wird so hoch gehoben, wie es geht; positiv, mit Knicken</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>Die Oberfläche hat kein Dreieck</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>Die Oberfläche wurde vor dem Füllen repariert.</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled. %1. Details smaller than %2 mm are lost.</source>
        <translation>Die Oberfläche wurde vor dem Füllen repariert. %1. Einzelheiten unter %2 mm gehen verloren.</translation>
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
        <source>The width has to be positive</source>
        <translation>Die Breite muss positiv sein</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Die Messpunkte liegen auf einem regelmäßigen Gitter in der Oberfläche.</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Die Messpunkte liegen auf einem regelmäßigen Gitter in der Oberfläche. %1.</translation>
    </message>
    <message>
        <source>There are %1 positions for %2 handles</source>
        <translation>Es gibt %1 Positionen für %2 Griffe</translation>
    </message>
    <message>
        <source>There are %1 witness points; %2 do not fit this shape or the limits of time and memory.</source>
        <translation>Es gibt %1 Messpunkte; %2 passen nicht zu dieser Form oder zu den Grenzen von Zeit und Speicher.</translation>
    </message>
    <message>
        <source>There are no handles to group</source>
        <translation>Es gibt keine Griffe zum Gruppieren</translation>
    </message>
    <message>
        <source>There are no handles whose pose could be recorded</source>
        <translation>Es gibt keine Griffe, deren Pose aufgezeichnet werden könnte</translation>
    </message>
    <message>
        <source>There are no such vertices to enclose</source>
        <translation>Solche Eckpunkte zum Umschließen gibt es nicht</translation>
    </message>
    <message>
        <source>There is no file to open</source>
        <translation>Es gibt keine Datei zum Öffnen</translation>
    </message>
    <message>
        <source>There is no organ to enclose</source>
        <translation>Es gibt kein Organ zum Umschließen</translation>
    </message>
    <message>
        <source>There is no organ to make groups for</source>
        <translation>Es gibt kein Organ, für das Gruppen gebildet werden könnten</translation>
    </message>
    <message>
        <source>There is no scan to close</source>
        <translation>Es gibt keinen Scan zum Schließen</translation>
    </message>
    <message>
        <source>There is no stress map yet</source>
        <translation>Es gibt noch keine Spannungskarte</translation>
    </message>
    <message>
        <source>There is no such %1 any more</source>
        <translation>Das gibt es nicht mehr: %1</translation>
    </message>
    <message>
        <source>There is no such handle any more</source>
        <translation>Diesen Griff gibt es nicht mehr</translation>
    </message>
    <message>
        <source>There is no such organ any more</source>
        <translation>Dieses Organ gibt es nicht mehr</translation>
    </message>
    <message>
        <source>There is no such point</source>
        <translation>Diesen Punkt gibt es nicht</translation>
    </message>
    <message>
        <source>There is no type of samples &quot;%1&quot;</source>
        <translation>Es gibt keine Art von Messwerten „%1“</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Verdickung</translation>
    </message>
    <message>
        <source>This kind of file is not supported</source>
        <translation>Diese Art von Datei wird nicht unterstützt</translation>
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
        <source>Two handle files cannot be opened at a time</source>
        <translation>Zwei Griffdateien können nicht zugleich geöffnet werden</translation>
    </message>
    <message>
        <source>Two handles are at one place</source>
        <translation>Zwei Griffe sind am selben Ort</translation>
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
    <message numerus="yes">
        <source>Unlock {handle|%n handles}</source>
        <translation>
            <numerusform>Griff entsperren</numerusform>
            <numerusform>%n Griffe entsperren</numerusform>
        </translation>
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
        <source>Witness points of %1</source>
        <translation>Messpunkte von %1</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>ein Käfig ist eine grobe Oberfläche: nehmen Sie eine mit höchstens %1 Eckpunkten</translation>
    </message>
    <message>
        <source>a coarse surface needs at least four vertices</source>
        <translation>eine grobe Oberfläche braucht mindestens vier Eckpunkte</translation>
    </message>
    <message>
        <source>a convex hull needs at least 4 points, there are %1</source>
        <translation>eine konvexe Hülle braucht mindestens 4 Punkte, es gibt %1</translation>
    </message>
    <message>
        <source>a displacement</source>
        <translation>eine Verschiebung</translation>
    </message>
    <message>
        <source>a distance grid of this spacing is too large</source>
        <translation>ein Abstandsgitter mit dieser Weite ist zu groß</translation>
    </message>
    <message>
        <source>a handle of a recorded key</source>
        <translation>ein Griff eines aufgezeichneten Schlüssels</translation>
    </message>
    <message>
        <source>a part of the scan is on no organ</source>
        <translation>ein Teil des Scans liegt auf keinem Organ</translation>
    </message>
    <message>
        <source>a point of its surface</source>
        <translation>ein Punkt seiner Oberfläche</translation>
    </message>
    <message>
        <source>a recorded key</source>
        <translation>ein aufgezeichneter Schlüssel</translation>
    </message>
    <message>
        <source>a remark on it is not UTF-8</source>
        <translation>eine Bemerkung dazu ist kein UTF-8</translation>
    </message>
    <message>
        <source>a surface without triangles has no inside</source>
        <translation>eine Oberfläche ohne Dreiecke hat kein Inneres</translation>
    </message>
    <message>
        <source>a triangle has a handle at two corners</source>
        <translation>ein Dreieck hat einen Griff an zwei Ecken</translation>
    </message>
    <message>
        <source>a triangle names a handle that is not there</source>
        <translation>ein Dreieck nennt einen Griff, den es nicht gibt</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>fügen Sie Griffe hinzu, oder setzen Sie sie automatisch</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>durch automatisches Gruppieren hinzugefügt</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>alle Punkte liegen in einer Ebene</translation>
    </message>
    <message>
        <source>an angle has three points, any other measurement two</source>
        <translation>ein Winkel hat drei Punkte, jede andere Messung zwei</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
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
        <source>bind it first</source>
        <translation>binden Sie es zuerst</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Korpus</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>cannot place %1 witness points</source>
        <translation>%1 Messpunkte können nicht gesetzt werden</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>Herzzeitvolumen</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>prüfen Sie ihre Zugriffsrechte</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>prüfen Sie die Einheit; Koordinaten sind in mm</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>choose %1 to %2</source>
        <translation>wählen Sie %1 bis %2</translation>
    </message>
    <message>
        <source>choose a closed surface</source>
        <translation>wählen Sie eine geschlossene Oberfläche</translation>
    </message>
    <message>
        <source>choose a file that Viscera has saved as .viscera</source>
        <translation>wählen Sie eine Datei, die Viscera als .viscera gespeichert hat</translation>
    </message>
    <message>
        <source>choose a file with a triangle surface</source>
        <translation>wählen Sie eine Datei mit einer Oberfläche aus Dreiecken</translation>
    </message>
    <message>
        <source>choose a larger spacing</source>
        <translation>wählen Sie eine größere Weite</translation>
    </message>
    <message>
        <source>choose a volume nearer to the present one, or let more handles compensate</source>
        <translation>wählen Sie ein Volumen näher am jetzigen, oder lassen Sie mehr Griffe ausgleichen</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>wählen Sie eine davon</translation>
    </message>
    <message>
        <source>choose organ, axis or cluster</source>
        <translation>wählen Sie organ, axis oder cluster</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>wählen Sie zwei Enden einer Oberfläche</translation>
    </message>
    <message>
        <source>circulation that was kept</source>
        <translation>gemerkter Kreislauf</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>schließen Sie zuerst ihre Löcher</translation>
    </message>
    <message>
        <source>close other programs, or work with fewer organs or coarser surfaces</source>
        <translation>schließen Sie andere Programme, oder arbeiten Sie mit weniger Organen oder gröberen Oberflächen</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>Koordinaten brauchen mindestens vier Griffe, es gibt %1</translation>
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
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>does not lie between 0 and 1</source>
        <translation>liegt nicht zwischen 0 und 1</translation>
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
        <source>export the surface again</source>
        <translation>exportieren Sie die Oberfläche neu</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>Füllen des Organs mit Tetraedern</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>Fundus</translation>
    </message>
    <message>
        <source>give it another one</source>
        <translation>geben Sie ihm einen anderen</translation>
    </message>
    <message>
        <source>give it one</source>
        <translation>geben Sie ihm einen</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>Griff %1</translation>
    </message>
    <message>
        <source>handles %1 and %2</source>
        <translation>Griffe %1 und %2</translation>
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
        <source>it does not lie within the period</source>
        <translation>er liegt nicht innerhalb der Periode</translation>
    </message>
    <message>
        <source>it follows no handles, so nothing can change its volume</source>
        <translation>es folgt keinen Griffen, also kann nichts sein Volumen ändern</translation>
    </message>
    <message>
        <source>it has %1 triangles</source>
        <translation>sie hat %1 Dreiecke</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>es hat keinen Namen</translation>
    </message>
    <message>
        <source>it is not a millisecond at least behind the key before it</source>
        <translation>er liegt keine Millisekunde hinter dem vorigen Schlüssel</translation>
    </message>
    <message>
        <source>its colour does not lie between 0 and 1</source>
        <translation>seine Farbe liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>its description is not UTF-8</source>
        <translation>seine Beschreibung ist kein UTF-8</translation>
    </message>
    <message>
        <source>its file %1 is not there any more (put it beside the session and open that again)</source>
        <translation>seine Datei %1 ist nicht mehr da (legen Sie sie neben die Sitzung und öffnen Sie diese noch einmal)</translation>
    </message>
    <message>
        <source>its file was found as %1</source>
        <translation>seine Datei wurde als %1 gefunden</translation>
    </message>
    <message>
        <source>its handles are not handles of the rig, each once and in their order</source>
        <translation>ihre Griffe sind nicht die Griffe des Rigs, jeder einmal und in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>its id is another thing's, too</source>
        <translation>seine Kennung hat auch etwas anderes</translation>
    </message>
    <message>
        <source>its id is not a whole number from 1 to 2^52</source>
        <translation>seine Kennung ist keine ganze Zahl von 1 bis 2^52</translation>
    </message>
    <message>
        <source>its name is not UTF-8</source>
        <translation>sein Name ist kein UTF-8</translation>
    </message>
    <message>
        <source>its opacity does not lie between 0 and 1</source>
        <translation>seine Deckkraft liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>its parent is not an organ before it</source>
        <translation>sein übergeordnetes Organ steht nicht vor ihm</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>seine Position</translation>
    </message>
    <message>
        <source>its position at rest</source>
        <translation>seine Ruheposition</translation>
    </message>
    <message>
        <source>its surface is open, so it has no volume that could be locked</source>
        <translation>seine Oberfläche ist offen und hat kein Volumen, das gesperrt werden könnte</translation>
    </message>
    <message numerus="yes">
        <source>its surface was closed by %n {cap|caps}</source>
        <translation>
            <numerusform>seine Oberfläche wurde mit %n Deckel geschlossen</numerusform>
            <numerusform>seine Oberfläche wurde mit %n Deckeln geschlossen</numerusform>
        </translation>
    </message>
    <message>
        <source>its triangles were turned around to face outward</source>
        <translation>seine Dreiecke wurden nach außen gewendet</translation>
    </message>
    <message>
        <source>its two ends are at one place</source>
        <translation>ihre beiden Enden sind am selben Ort</translation>
    </message>
    <message>
        <source>its two ends are on separate pieces</source>
        <translation>ihre beiden Enden sind auf getrennten Stücken</translation>
    </message>
    <message>
        <source>its value is not a finite number</source>
        <translation>sein Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>its volume can be kept only when it is bound to the handles there are</source>
        <translation>sein Volumen kann nur gehalten werden, wenn es an die vorhandenen Griffe gebunden ist</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>sein Volumen ist nicht mehr gesperrt: die Oberfläche ist jetzt offen</translation>
    </message>
    <message>
        <source>its weights are no place in a triangle: they have to be 0 at least, and 1 together</source>
        <translation>seine Gewichte sind kein Ort in einem Dreieck: sie müssen mindestens 0 sein und zusammen 1</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>verlängern Sie zuerst die Periode</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>measurement %1</source>
        <translation>Messung %1</translation>
    </message>
    <message>
        <source>middle line</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>move it elsewhere, or remove one of the two</source>
        <translation>verschieben Sie ihn, oder entfernen Sie einen der beiden</translation>
    </message>
    <message>
        <source>move one out of the plane</source>
        <translation>rücken Sie einen aus der Ebene</translation>
    </message>
    <message>
        <source>move or remove one of them</source>
        <translation>verschieben oder entfernen Sie einen davon</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>rücken Sie die Eckpunkte dort auseinander, oder nehmen Sie einen anderen Käfig</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>nennen Sie sie %1</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>keine Kante verbindet mehr als zwei Dreiecke</translation>
    </message>
    <message>
        <source>no harmonic function can be found on the surface</source>
        <translation>auf der Oberfläche lässt sich keine harmonische Funktion finden</translation>
    </message>
    <message>
        <source>no motion near to this one keeps the volume</source>
        <translation>keine Bewegung nahe dieser hält das Volumen</translation>
    </message>
    <message>
        <source>no surface has so many triangles</source>
        <translation>keine Oberfläche hat so viele Dreiecke</translation>
    </message>
    <message>
        <source>one of its points</source>
        <translation>einer ihrer Punkte</translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>öffnen Sie ihn zu den Organen (Datei &gt; Scan öffnen), oder machen Sie daraus zuerst eine Labelmap, mit 3D Slicer oder TotalSegmentator</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>öffnen Sie zuerst eines</translation>
    </message>
    <message>
        <source>open the other files after it</source>
        <translation>öffnen Sie die anderen Dateien danach</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>organ %1</source>
        <translation>Organ %1</translation>
    </message>
    <message>
        <source>out</source>
        <translation>auslaufend</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>Parameter %1</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>peak stress over the sequence</source>
        <translation>Spitzenwert der Spannung über die Sequenz</translation>
    </message>
    <message>
        <source>pick the point on the surface again</source>
        <translation>wählen Sie den Punkt auf der Oberfläche neu</translation>
    </message>
    <message>
        <source>place handles around it</source>
        <translation>setzen Sie Griffe um es</translation>
    </message>
    <message>
        <source>place some first</source>
        <translation>setzen Sie zuerst welche</translation>
    </message>
    <message>
        <source>point %1 has a coordinate that is not a finite number</source>
        <translation>Punkt %1 hat eine Koordinate, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>Punkte, die zusammenfallen oder fast in einer Ebene liegen, sind die Ursache</translation>
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
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>langsame Austreibung</translation>
    </message>
    <message>
        <source>remove one of them from the file</source>
        <translation>entfernen Sie einen davon aus der Datei</translation>
    </message>
    <message>
        <source>repair the surface</source>
        <translation>reparieren Sie die Oberfläche</translation>
    </message>
    <message>
        <source>repair the surface in another program first</source>
        <translation>reparieren Sie die Oberfläche zuerst in einem anderen Programm</translation>
    </message>
    <message>
        <source>repaired on import: %1</source>
        <translation>beim Import repariert: %1</translation>
    </message>
    <message>
        <source>repairing the surface</source>
        <translation>Reparatur der Oberfläche</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>rechts und links sind vertauscht, vorn und hinten nicht: gespiegelt</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>speichern Sie es zuerst als eigene Datei</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>speichern Sie oft, oder schaffen Sie dort Platz</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
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
        <source>take a backup of the file, or begin a new session with the organs' own files</source>
        <translation>nehmen Sie eine Sicherung der Datei, oder beginnen Sie eine neue Sitzung mit den Dateien der Organe</translation>
    </message>
    <message>
        <source>take the sequence's own handles</source>
        <translation>nehmen Sie die eigenen Griffe der Sequenz</translation>
    </message>
    <message>
        <source>terminal antral contraction</source>
        <translation>terminale Antrumkontraktion</translation>
    </message>
    <message>
        <source>the Delaunay tetrahedra of %1 points cannot be computed</source>
        <translation>die Delaunay-Tetraeder von %1 Punkten können nicht berechnet werden</translation>
    </message>
    <message>
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>die konvexe Hülle von %1 Punkten kann nicht berechnet werden</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>die Datei nennt ihre Achsen nicht: LPS wird angenommen</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>die Datei nennt ihre Achsen: %1</translation>
    </message>
    <message>
        <source>the handle %1 comes twice</source>
        <translation>der Griff %1 kommt zweimal vor</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>die Griffe umschließen nichts: %1</translation>
    </message>
    <message>
        <source>the id %1 comes twice</source>
        <translation>die Kennung %1 kommt zweimal vor</translation>
    </message>
    <message>
        <source>the limits of time and memory must be above 0</source>
        <translation>die Grenzen von Zeit und Speicher müssen über 0 liegen</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>der Name einer Sitzungsdatei endet auf .viscera</translation>
    </message>
    <message>
        <source>the organ that it is a cavity of is not before it</source>
        <translation>das Organ, dessen Höhle es ist, steht nicht davor</translation>
    </message>
    <message>
        <source>the parts of its colour do not lie between 0 and 1</source>
        <translation>die Anteile seiner Farbe liegen nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>the period is not a positive number of seconds</source>
        <translation>die Periode ist keine positive Zahl von Sekunden</translation>
    </message>
    <message>
        <source>the pose has another number of handles than the document</source>
        <translation>die Pose hat eine andere Zahl von Griffen als das Dokument</translation>
    </message>
    <message>
        <source>the quality of tetrahedra is a ratio from 1.1 (best) to 10</source>
        <translation>die Güte der Tetraeder ist ein Verhältnis von 1,1 (beste) bis 10</translation>
    </message>
    <message>
        <source>the scan %1 is not there any more (put it beside the session and open that again)</source>
        <translation>der Scan %1 ist nicht mehr da (legen Sie ihn neben die Sitzung und öffnen Sie diese noch einmal)</translation>
    </message>
    <message>
        <source>the scan cannot be opened: %1</source>
        <translation>der Scan kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>the size is plausible: %1</source>
        <translation>die Größe ist plausibel: %1</translation>
    </message>
    <message>
        <source>the surface consists of %1 separate pieces</source>
        <translation>die Oberfläche besteht aus %1 getrennten Stücken</translation>
    </message>
    <message>
        <source>the surface does not cross itself</source>
        <translation>die Oberfläche durchdringt sich nicht</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>die Oberfläche hat %1 brauchbare Dreiecke und umschließt nichts</translation>
    </message>
    <message>
        <source>the surface has no such triangle</source>
        <translation>die Oberfläche hat dieses Dreieck nicht</translation>
    </message>
    <message>
        <source>the surface is closed</source>
        <translation>die Oberfläche ist geschlossen</translation>
    </message>
    <message>
        <source>the surface is inside out</source>
        <translation>die Oberfläche ist umgestülpt</translation>
    </message>
    <message>
        <source>the surface is of one piece</source>
        <translation>die Oberfläche ist aus einem Stück</translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume</source>
        <translation>
            <numerusform>die Oberfläche ist offen (%n Randkante) und hat kein Volumen</numerusform>
            <numerusform>die Oberfläche ist offen (%n Randkanten) und hat kein Volumen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked</source>
        <translation>
            <numerusform>die Oberfläche ist offen (%n Randkante) und hat kein Volumen, das gesperrt werden könnte</numerusform>
            <numerusform>die Oberfläche ist offen (%n Randkanten) und hat kein Volumen, das gesperrt werden könnte</numerusform>
        </translation>
    </message>
    <message>
        <source>the triangles beside a hole do not all run the same way round, so it cannot be closed</source>
        <translation>die Dreiecke an einem Loch laufen nicht alle gleich herum, darum kann es nicht geschlossen werden</translation>
    </message>
    <message>
        <source>the triangles face outward</source>
        <translation>die Dreiecke zeigen nach außen</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>das Volumen kann hier nicht gehalten werden: %1</translation>
    </message>
    <message>
        <source>the weights of a measured point are no place in its triangle</source>
        <translation>die Gewichte eines gemessenen Punkts sind kein Ort in seinem Dreieck</translation>
    </message>
    <message>
        <source>there is no %1 &quot;%2&quot;</source>
        <translation>„%2“ ist kein Wert von %1</translation>
    </message>
    <message>
        <source>there is no organ %1</source>
        <translation>es gibt kein Organ %1</translation>
    </message>
    <message>
        <source>there is no such slice</source>
        <translation>diesen Schnitt gibt es nicht</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>es gibt kein Dreieck %1</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to make groups</source>
        <translation>es gibt keine Art „%1“, Gruppen zu bilden</translation>
    </message>
    <message>
        <source>there is not enough memory for this</source>
        <translation>dafür reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>thinning out the surface</source>
        <translation>Ausdünnen der Oberfläche</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>das ist ein Fehler des Programms; bitte melden Sie ihn</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>triangle %1 refers to vertex %2, but there are %3</source>
        <translation>Dreieck %1 nennt Eckpunkt %2, es gibt aber %3</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>zwei Gruppen haben diesen Namen</translation>
    </message>
    <message>
        <source>two handles are at one place</source>
        <translation>zwei Griffe sind am selben Ort</translation>
    </message>
    <message>
        <source>two handles have this label</source>
        <translation>zwei Griffe haben diese Bezeichnung</translation>
    </message>
    <message>
        <source>unlock it, or let more handles compensate</source>
        <translation>entsperren Sie es, oder lassen Sie mehr Griffe ausgleichen</translation>
    </message>
    <message>
        <source>unsaved work</source>
        <translation>ungespeicherte Arbeit</translation>
    </message>
    <message>
        <source>unsaved work cannot be kept safe: the folder cannot be written to</source>
        <translation>ungespeicherte Arbeit kann nicht gesichert werden: in den Ordner kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>update Viscera</source>
        <translation>aktualisieren Sie Viscera</translation>
    </message>
    <message>
        <source>use a pose of the same handles</source>
        <translation>nehmen Sie eine Pose derselben Griffe</translation>
    </message>
    <message>
        <source>use one of %1</source>
        <translation>nehmen Sie eine von %1</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>nehmen Sie eines von: %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that is not a finite number</source>
        <translation>Eckpunkt %1 hat eine Koordinate, die keine endliche Zahl ist</translation>
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
        <source>wait a moment</source>
        <translation>warten Sie einen Augenblick</translation>
    </message>
    <message>
        <source>wait until the witness points are there</source>
        <translation>warten Sie, bis die Messpunkte da sind</translation>
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
    <message>
        <source>what is measured on it is now at the nearest places of that surface</source>
        <translation>Messungen darauf liegen jetzt an den nächsten Stellen dieser Oberfläche</translation>
    </message>
    <message>
        <source>witness points</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Pin stress probe</source>
        <translation>Stresssonde anheften</translation>
    </message>
    <message>
        <source>Draw stress profile</source>
        <translation>Stressprofil zeichnen</translation>
    </message>
    <message>
        <source>Remove stress profile</source>
        <translation>Stressprofil entfernen</translation>
    </message>
    <message>
        <source>Remove all stress probes</source>
        <translation>Alle Stresssonden entfernen</translation>
    </message>
    <message numerus="yes">
        <source>Remove {stress probe|%n stress probes}</source>
        <translation>
            <numerusform>Stresssonde entfernen</numerusform>
            <numerusform>%n Stresssonden entfernen</numerusform>
        </translation>
    </message>
    <message>
        <source>stress probe %1</source>
        <translation>Stresssonde %1</translation>
    </message>
    <message>
        <source>stress line %1</source>
        <translation>Stresslinie %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>Stresssonde</translation>
    </message>
    <message>
        <source>stress line</source>
        <translation>Stresslinie</translation>
    </message>
    <message>
        <source>its number is not a whole number from 1</source>
        <translation>seine Nummer ist keine ganze Zahl ab 1</translation>
    </message>
    <message>
        <source>two stress probes have this number</source>
        <translation>zwei Stresssonden haben diese Nummer</translation>
    </message>
    <message>
        <source>its place at rest</source>
        <translation>ihr Ort in Ruhe</translation>
    </message>
    <message>
        <source>it does not join two stress probes of one organ</source>
        <translation>sie verbindet nicht zwei Stresssonden eines Organs</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Ein Profil braucht zwei Sonden eines Organs</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Diese beiden Sonden haben schon ein Profil</translation>
    </message>
</context>
</TS>
