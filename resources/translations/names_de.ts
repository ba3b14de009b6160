<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>%1 triangles instead of %2; the old surface lies %3 mm from the new one on average, %4 mm at most</source>
        <translation>%1 Dreiecke statt %2; die alte Oberfläche liegt im Mittel %3 mm von der neuen entfernt, höchstens %4 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 and %2 are at one place: %3 from each other</source>
        <translation>%1 und %2 liegen an einer Stelle: %3 voneinander entfernt</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 at %2 % of the cycle: %3</source>
        <translation>%1 bei %2 % des Zyklus: %3</translation>
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
        <source>%1 has no volume in %2</source>
        <translation>%1 hat in %2 kein Volumen</translation>
    </message>
    <message>
        <source>%1 has no voxels any more</source>
        <translation>%1 hat keine Voxel mehr</translation>
    </message>
    <message>
        <source>%1 has other triangles in %2 than in the first: surfaces are fitted by their distances, which do not see motion along the wall</source>
        <translation>%1 hat in %2 andere Dreiecke als in der ersten: die Oberflächen werden nach ihren Abständen angepasst, die eine Bewegung entlang der Wand nicht erkennen</translation>
    </message>
    <message>
        <source>%1 ml cannot be reached</source>
        <translation>%1 ml können nicht erreicht werden</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates</source>
        <translation>%1 von %2 Eckpunkten haben keine Koordinaten</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates in the cage</source>
        <translation>%1 von %2 Eckpunkten haben im Käfig keine Koordinaten</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie in no group's region</source>
        <translation>%1 von %2 Eckpunkten liegen in keiner Region einer Gruppe</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 von mehr als 1 GB passt nicht in eine Sitzungsdatei</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm around %7, %8, %9</source>
        <translation>%1 x %2 x %3 Voxel von %4 x %5 x %6 mm um %7; %8; %9</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2 and not in others, so that its volumes would be cut off</source>
        <translation>%1 berührt den Bildrand in %2 und in anderen nicht, sodass seine Volumina beschnitten wären</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2: what lies beyond is not in its volume</source>
        <translation>%1 berührt den Bildrand in %2: was dahinter liegt, ist nicht in seinem Volumen</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in every phase: what lies beyond is not in its volume</source>
        <translation>%1 berührt den Bildrand in jeder Phase: was dahinter liegt, ist nicht in seinem Volumen</translation>
    </message>
    <message numerus="yes">
        <source>%2, %n of them {is a small fragment|are small fragments} of less than 2 % of its area</source>
        <translation>
            <numerusform>%2, davon %n kleines Bruchstück mit weniger als 2 % der Fläche</numerusform>
            <numerusform>%2, davon %n kleine Bruchstücke mit weniger als 2 % der Fläche</numerusform>
        </translation>
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
        <translation>%1, Schlüsselbild bei %2 s</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 lie outside the handles' hull, by up to %3 mm</source>
        <translation>%1: %2 liegen außerhalb der Hülle der Griffe, bis zu %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n {hole|holes} closed by {a flat cap|flat caps}</source>
        <translation>
            <numerusform>%1: %n Loch mit einer ebenen Kappe geschlossen</numerusform>
            <numerusform>%1: %n Löcher mit ebenen Kappen geschlossen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1: „%2“ ist unbekannt und wird nicht wieder gespeichert</translation>
    </message>
    <message>
        <source>%1: points that coincide in the first phase separate by up to %2 mm; Viscera keeps them together</source>
        <translation>%1: Punkte, die in der ersten Phase zusammenfallen, entfernen sich um bis zu %2 mm; Viscera hält sie zusammen</translation>
    </message>
    <message>
        <source>%1; it looks like %2</source>
        <translation>%1; sie sieht aus wie %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices were read, slices %3 to %4, which are even; the others, or all of them resampled, can be chosen as a series</source>
        <translation>%1 von %2 Schichten wurden gelesen, die gleichmäßigen von %3 bis %4; die anderen, oder alle umgerechnet, lassen sich als Serie wählen</translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest</source>
        <translation>
            <numerusform>%2 Stücke, %n Voxel neben dem größten</numerusform>
            <numerusform>%2 Stücke, %n Voxel neben dem größten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest left out</source>
        <translation>
            <numerusform>%2 Stücke, %n Voxel neben dem größten weggelassen</numerusform>
            <numerusform>%2 Stücke, %n Voxel neben dem größten weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; check whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
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
        <source>%n {byte|bytes} after the end ignored</source>
        <translation>
            <numerusform>%n Byte nach dem Ende ignoriert</numerusform>
            <numerusform>%n Bytes nach dem Ende ignoriert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the last triangle ignored</source>
        <translation>
            <numerusform>%n Byte nach dem letzten Dreieck ignoriert</numerusform>
            <numerusform>%n Bytes nach dem letzten Dreieck ignoriert</numerusform>
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
        <source>%n {file is a copy|files are copies} of another one and left out</source>
        <translation>
            <numerusform>%n Datei ist die Kopie einer anderen und wurde weggelassen</numerusform>
            <numerusform>%n Dateien sind Kopien einer anderen und wurden weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {file is|files are} damaged and left out (%2: %3)</source>
        <translation>
            <numerusform>%n Datei ist beschädigt und wurde weggelassen (%2: %3)</numerusform>
            <numerusform>%n Dateien sind beschädigt und wurden weggelassen (%2: %3)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is in no group and moves|handles are in no group and move} nothing</source>
        <translation>
            <numerusform>%n Griff ist in keiner Gruppe und bewegt nichts</numerusform>
            <numerusform>%n Griffe sind in keiner Gruppe und bewegen nichts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is|handles are} too few</source>
        <translation>
            <numerusform>%n Griff ist zu wenig</numerusform>
            <numerusform>%n Griffe sind zu wenige</numerusform>
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
        <source>%n {handle|handles} cannot form %2 groups</source>
        <translation>
            <numerusform>%n Griff kann keine %2 Gruppen bilden</numerusform>
            <numerusform>%n Griffe können keine %2 Gruppen bilden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} whose label another one has got a new one</source>
        <translation>
            <numerusform>%n Griff, dessen Bezeichnung schon ein anderer hat, hat eine neue bekommen</numerusform>
            <numerusform>%n Griffe, deren Bezeichnung schon ein anderer hat, haben eine neue bekommen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} without a label got one</source>
        <translation>
            <numerusform>%n Griff ohne Bezeichnung hat eine bekommen</numerusform>
            <numerusform>%n Griffe ohne Bezeichnung haben eine bekommen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line or point cell|line or point cells} ignored</source>
        <translation>
            <numerusform>%n Linien- oder Punktzelle übergangen</numerusform>
            <numerusform>%n Linien- oder Punktzellen übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line|lines} with points, curves or free-form surfaces ignored</source>
        <translation>
            <numerusform>%n Zeile mit Punkten, Kurven oder Freiformflächen ignoriert</numerusform>
            <numerusform>%n Zeilen mit Punkten, Kurven oder Freiformflächen ignoriert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {mask is|masks are} empty (%2)</source>
        <translation>
            <numerusform>%n Maske ist leer (%2)</numerusform>
            <numerusform>%n Masken sind leer (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to repair the surface first</source>
        <translation>
            <numerusform>%n Paar von Dreiecken durchdringt sich: der Modus Stress muss die Oberfläche vielleicht erst reparieren</numerusform>
            <numerusform>%n Paare von Dreiecken durchdringen sich: der Modus Stress muss die Oberfläche vielleicht erst reparieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series of another echo left out</source>
        <translation>
            <numerusform>%n Bild der Serie mit einem anderen Echo weggelassen</numerusform>
            <numerusform>%n Bilder der Serie mit einem anderen Echo weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series that {lies|lie} in another direction left out</source>
        <translation>
            <numerusform>%n Bild der Serie, das in anderer Richtung liegt, weggelassen</numerusform>
            <numerusform>%n Bilder der Serie, die in anderer Richtung liegen, weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {place has|places have} more than one slice (%2); the one with the lowest number was read</source>
        <translation>
            <numerusform>%n Ort hat mehr als eine Schicht (%2); die mit der kleinsten Nummer wurde gelesen</numerusform>
            <numerusform>%n Orte haben mehr als eine Schicht (%2); die mit der kleinsten Nummer wurde gelesen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that repeats|points that repeat} another merged</source>
        <translation>
            <numerusform>%n Punkt, der einen anderen wiederholt, verschmolzen</numerusform>
            <numerusform>%n Punkte, die andere wiederholen, verschmolzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point|points} without a triangle dropped</source>
        <translation>
            <numerusform>%n Punkt ohne Dreieck weggelassen</numerusform>
            <numerusform>%n Punkte ohne Dreieck weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} no voxels (%2)</source>
        <translation>
            <numerusform>%n Segment hat keine Voxel (%2)</numerusform>
            <numerusform>%n Segmente haben keine Voxel (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {set|sets} of points or lines ignored</source>
        <translation>
            <numerusform>%n Satz von Punkten oder Linien ignoriert</numerusform>
            <numerusform>%n Sätze von Punkten oder Linien ignoriert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice is|slices are} missing between slice %2 (%3) and the next, which are %4 mm apart in place of %5 mm</source>
        <translation>
            <numerusform>%n Schicht fehlt zwischen Schicht %2 (%3) und der nächsten, die %4 mm statt %5 mm auseinander liegen</numerusform>
            <numerusform>%n Schichten fehlen zwischen Schicht %2 (%3) und der nächsten, die %4 mm statt %5 mm auseinander liegen</numerusform>
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
    <message numerus="yes">
        <source>%n {triangle|triangles} with a repeated corner dropped</source>
        <translation>
            <numerusform>%n Dreieck mit doppelter Ecke weggelassen</numerusform>
            <numerusform>%n Dreiecke mit doppelter Ecke weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex lies|vertices lie} outside the hull of the sequence's handles</source>
        <translation>
            <numerusform>%n Eckpunkt liegt außerhalb der Hülle der Griffe der Sequenz</numerusform>
            <numerusform>%n Eckpunkte liegen außerhalb der Hülle der Griffe der Sequenz</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex|vertices} cannot be divided among %2 groups</source>
        <translation>
            <numerusform>%n Eckpunkt kann nicht auf %2 Gruppen verteilt werden</numerusform>
            <numerusform>%n Eckpunkte können nicht auf %2 Gruppen verteilt werden</numerusform>
        </translation>
    </message>
    <message>
        <source>0 starts from all ones, others from random numbers</source>
        <translation>0 beginnt mit lauter Einsen, andere mit Zufallszahlen</translation>
    </message>
    <message>
        <source>19 of 20 adults have %1 to %2 ml</source>
        <translation>19 von 20 Erwachsenen haben %1 bis %2 ml</translation>
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
        <source>A session cannot be opened beside another</source>
        <translation>Eine Sitzung kann nicht neben einer anderen geöffnet werden</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Eine Sitzung wird allein geöffnet</translation>
    </message>
    <message>
        <source>A slice cannot be read, so the series is not opened: %1</source>
        <translation>Eine Schicht kann nicht gelesen werden, darum wird die Serie nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Ein steifer linker Ventrikel, der langsam erschlafft: Er entleert sich gut und füllt sich nur bei hohem Druck.</translation>
    </message>
    <message>
        <source>A ventricle's volume is not positive</source>
        <translation>Das Volumen eines Ventrikels ist nicht positiv</translation>
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
        <source>An ejection fraction of %1 is out of range</source>
        <translation>Eine Ejektionsfraktion von %1 liegt außerhalb des Bereichs</translation>
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
        <translation>Herzspitze</translation>
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
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Balanced weights nearest to a target; a parameter says how negative weights are treated</source>
        <translation>Gewichte im Gleichgewicht, einem Ziel am nächsten; ein Parameter gibt an, wie negative Gewichte behandelt werden</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Warping the image</source>
        <translation>Bild wird verformt</translation>
    </message>
    <message>
        <source>Warping the scan</source>
        <translation>Scan wird verformt</translation>
    </message>
    <message>
        <source>Warped</source>
        <translation>Verformt</translation>
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
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Heartbeat: %1</source>
        <translation>Herzschlag: %1</translation>
    </message>
    <message>
        <source>LV (ml)</source>
        <translation>LV (ml)</translation>
    </message>
    <message>
        <source>Preparing the volume lock</source>
        <translation>Vorbereitung der Volumensperre</translation>
    </message>
    <message>
        <source>Binding the space between the handles</source>
        <translation>Der Raum zwischen den Griffen wird gebunden</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>Blau nach Rot</translation>
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
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not interpolate its handles</source>
        <translation>Aus Ecken und Normalen eines Käfigs beliebiger Form; erhält Winkel nahezu und interpoliert seine Griffe nicht</translation>
    </message>
    <message>
        <source>C-Celestial</source>
        <translation>C-Celestial</translation>
    </message>
    <message>
        <source>Caecum</source>
        <translation>Caecum</translation>
    </message>
    <message>
        <source>Cardia</source>
        <translation>Cardia</translation>
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
        <source>Centroid of all positive solutions, estimated by sampling; more samples are more accurate</source>
        <translation>Schwerpunkt aller positiven Lösungen, durch Stichproben geschätzt; mehr Stichproben sind genauer</translation>
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
        <source>Change key sequence</source>
        <translation>Schlüsselbildfolge ändern</translation>
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
        <source>Cividis</source>
        <translation>Cividis</translation>
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
        <source>Connection</source>
        <translation>Verbindung</translation>
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
        <source>Inner</source>
        <translation>Innen</translation>
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
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Locality</source>
        <translation>Lokalität</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Partitions</source>
        <translation>Zerlegungen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Polyhedra</source>
        <translation>Polyeder</translation>
    </message>
    <message>
        <source>Positivity</source>
        <translation>Positivität</translation>
    </message>
    <message>
        <source>RV (ml)</source>
        <translation>RV (ml)</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastpunkte</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>Stress over the cycle</source>
        <translation>Stress über den Zyklus</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Übertragung</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
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
        <source>ESPVR and EDPVR</source>
        <translation>ESPVR und EDPVR</translation>
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
        <source>Added volume that multiplies pericardial pressure by e</source>
        <translation>Volumen, das den Perikarddruck mit e multipliziert</translation>
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
        <translation>Flüssigkeit im Perikard drückt auf alle Herzhöhlen: Sie füllen sich wenig, und alle Füllungsdrücke sind gleich.</translation>
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
        <source>Discard kept circulation</source>
        <translation>Behaltenen Kreislauf verwerfen</translation>
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
        <translation>Peristaltik des Magens</translation>
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
        <source>Grey</source>
        <translation>Grau</translation>
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
            <numerusform>Griff ausblenden</numerusform>
            <numerusform>%n Griffe ausblenden</numerusform>
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
        <source>Method that finds positive balanced vectors</source>
        <translation>Verfahren, das positive Vektoren im Gleichgewicht findet</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Wie die Gewichte der Voronoi-Ecken zu den Griffen gelangen</translation>
    </message>
    <message>
        <source>Order in which the wire connects the points</source>
        <translation>Reihenfolge, in der der Draht die Punkte verbindet</translation>
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
        <source>Inferno</source>
        <translation>Inferno</translation>
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
        <source>Internal error of an unknown kind</source>
        <translation>Interner Fehler unbekannter Art</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Interner Fehler: %1</translation>
    </message>
    <message>
        <source>It cannot be opened: %1</source>
        <translation>Es kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>Sie kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>It cannot be read to its end</source>
        <translation>Die Datei kann nicht bis zum Ende gelesen werden</translation>
    </message>
    <message>
        <source>It cannot be written: %1</source>
        <translation>Die Datei kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>It cannot be written: it is a folder</source>
        <translation>Die Datei kann nicht geschrieben werden: es ist ein Ordner</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Sie durchdringt sich selbst, an %n Paar von Dreiecken</numerusform>
            <numerusform>Sie durchdringt sich selbst, an %n Paaren von Dreiecken</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not fit into memory</source>
        <translation>die Datei passt nicht in den Speicher</translation>
    </message>
    <message>
        <source>The duration of one cycle is unknown</source>
        <translation>Die Dauer eines Zyklus ist unbekannt</translation>
    </message>
    <message numerus="yes">
        <source>It does not say the times of its %n {phase|phases}; they are numbered</source>
        <translation>
            <numerusform>Die Zeit ihrer %n Phase ist nicht angegeben; sie wird nummeriert</numerusform>
            <numerusform>Die Zeiten ihrer %n Phasen sind nicht angegeben; sie werden nummeriert</numerusform>
        </translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as milliseconds</source>
        <translation>Die Einheit der Zeiten ist nicht angegeben; sie werden als Millisekunden genommen</translation>
    </message>
    <message>
        <source>It has %1 labels; a mask in a folder has one</source>
        <translation>Die Datei hat %1 Labels; eine Maske in einem Ordner hat eines</translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a region needs at least 4</source>
        <translation>
            <numerusform>Sie hat %n Griff; eine Region braucht mindestens 4</numerusform>
            <numerusform>Sie hat %n Griffe; eine Region braucht mindestens 4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a sequence needs four at least</source>
        <translation>
            <numerusform>Es gibt %n Griff; eine Sequenz braucht mindestens vier</numerusform>
            <numerusform>Es gibt %n Griffe; eine Sequenz braucht mindestens vier</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {phase|phases}; a motion needs four at least</source>
        <translation>
            <numerusform>Es gibt %n Phase; eine Bewegung braucht mindestens vier</numerusform>
            <numerusform>Es gibt %n Phasen; eine Bewegung braucht mindestens vier</numerusform>
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
        <source>It has a label above 2147483647</source>
        <translation>Es hat ein Label über 2147483647</translation>
    </message>
    <message>
        <source>It has more than %1 files</source>
        <translation>Der Ordner hat mehr als %1 Dateien</translation>
    </message>
    <message>
        <source>It has more than 32767 voxels along a side, which NIfTI cannot hold</source>
        <translation>Das Bild hat mehr als 32767 Voxel entlang einer Seite, was NIfTI nicht fasst</translation>
    </message>
    <message>
        <source>It has no DICOM files with images</source>
        <translation>Der Ordner hat keine DICOM-Dateien mit Bildern</translation>
    </message>
    <message>
        <source>It has no labelled voxel: all are 0</source>
        <translation>Kein Voxel hat ein Label: alle sind 0</translation>
    </message>
    <message>
        <source>It has no phase %1; it has %2</source>
        <translation>Es gibt keine Phase %1; es gibt %2</translation>
    </message>
    <message>
        <source>It has no slices of a scan</source>
        <translation>Es gibt keine Schichten eines Scans</translation>
    </message>
    <message>
        <source>It has no slices of a scan: &quot;%1&quot; %2</source>
        <translation>Es gibt keine Schichten eines Scans: „%1“ %2</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>Es hat keine Oberfläche „%1“</translation>
    </message>
    <message>
        <source>It has no triangles</source>
        <translation>Die Oberfläche hat keine Dreiecke</translation>
    </message>
    <message>
        <source>It does not have three dimensions</source>
        <translation>Das Bild hat nicht drei Dimensionen</translation>
    </message>
    <message>
        <source>It has several axes that are not of space</source>
        <translation>Das Bild hat mehrere Achsen, die keine des Raumes sind</translation>
    </message>
    <message>
        <source>It has several labels: %1</source>
        <translation>Es gibt mehrere Labels: %1</translation>
    </message>
    <message>
        <source>It has several values per voxel</source>
        <translation>Das Bild hat mehrere Werte je Voxel</translation>
    </message>
    <message>
        <source>It has several values per voxel (%1)</source>
        <translation>Das Bild hat mehrere Werte je Voxel (%1)</translation>
    </message>
    <message>
        <source>It has to be positive</source>
        <translation>Der Wert muss positiv sein</translation>
    </message>
    <message>
        <source>It holds an image, not labels: it has more than %1 different values</source>
        <translation>Die Datei enthält ein Bild, keine Labels: sie hat mehr als %1 verschiedene Werte</translation>
    </message>
    <message>
        <source>It holds an image, not labels: one of its values is %1</source>
        <translation>Die Datei enthält ein Bild, keine Labels: einer ihrer Werte ist %1</translation>
    </message>
    <message>
        <source>It holds more than %1 masks</source>
        <translation>Der Ordner enthält mehr als %1 Masken</translation>
    </message>
    <message>
        <source>It holds neither surfaces nor label maps</source>
        <translation>Der Ordner enthält weder Oberflächen noch Labelmaps</translation>
    </message>
    <message>
        <source>It holds no PolyData</source>
        <translation>Die Datei enthält keine PolyData</translation>
    </message>
    <message>
        <source>It holds no label map</source>
        <translation>Der Ordner enthält keine Labelmap</translation>
    </message>
    <message>
        <source>It holds no triangles</source>
        <translation>Die Datei enthält keine Dreiecke</translation>
    </message>
    <message>
        <source>It holds no triangles, only points</source>
        <translation>Die Datei enthält keine Dreiecke, nur Punkte</translation>
    </message>
    <message>
        <source>It holds only empty masks</source>
        <translation>Der Ordner enthält nur leere Masken</translation>
    </message>
    <message>
        <source>It holds points, but no faces</source>
        <translation>Die Datei enthält Punkte, aber keine Flächen</translation>
    </message>
    <message>
        <source>It is a DICOM file without an image</source>
        <translation>Es ist eine DICOM-Datei ohne Bild</translation>
    </message>
    <message>
        <source>It is a DICOM file, but no segmentation (%1)</source>
        <translation>Es ist eine DICOM-Datei, aber keine Segmentierung (%1)</translation>
    </message>
    <message>
        <source>It is a binary OFF file, which Viscera does not read</source>
        <translation>Es ist eine binäre OFF-Datei, die Viscera nicht liest</translation>
    </message>
    <message>
        <source>It is a folder, not a file</source>
        <translation>Es ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>It is a scan, not an organ</source>
        <translation>Es ist ein Scan, kein Organ</translation>
    </message>
    <message>
        <source>It is glTF version %1, but only 2 can be read</source>
        <translation>Es ist glTF Version %1, lesbar ist aber nur 2</translation>
    </message>
    <message>
        <source>It is named %1 but looks like %2</source>
        <translation>Die Datei heißt %1, sieht aber aus wie %2</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>Es ist keine Datei der Art %1: ihr „format“ ist nicht „%2“</translation>
    </message>
    <message>
        <source>It is not a file with several phases</source>
        <translation>Es ist keine Datei mit mehreren Phasen</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>Es ist keine lesbare Datei</translation>
    </message>
    <message>
        <source>It is not a handle file</source>
        <translation>Es ist keine Griffdatei</translation>
    </message>
    <message>
        <source>It is not a regular file</source>
        <translation>Es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>It is not a scan in a known format</source>
        <translation>Es ist kein Scan in einem bekannten Format</translation>
    </message>
    <message>
        <source>It is not a slice of a scan</source>
        <translation>Es ist keine Schicht eines Scans</translation>
    </message>
    <message>
        <source>It is not a slice of a scan: it %1</source>
        <translation>Es ist keine Schicht eines Scans: %1</translation>
    </message>
    <message>
        <source>It is not convex at its triangle %1</source>
        <translation>Er ist an seinem Dreieck %1 nicht konvex</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>Sie hat die Version %1; dieses Programm liest bis %2</translation>
    </message>
    <message>
        <source>It is too large: %1 points</source>
        <translation>Sie ist zu groß: %1 Punkte</translation>
    </message>
    <message>
        <source>The displacement field would have more than 20 million points</source>
        <translation>Das Verschiebungsfeld hätte mehr als 20 Millionen Punkte</translation>
    </message>
    <message>
        <source>It mixes surfaces and label maps</source>
        <translation>Oberflächen und Labelmaps sind gemischt</translation>
    </message>
    <message>
        <source>It needs the glTF extension %1, which Viscera does not know</source>
        <translation>Die Datei braucht die glTF-Erweiterung %1, die Viscera nicht kennt</translation>
    </message>
    <message>
        <source>It seems to be in RAS where %1 is in LPS, or the other way round: it lies on the opposite side of the patient's middle</source>
        <translation>Es scheint in RAS zu sein, während %1 in LPS ist, oder umgekehrt: es liegt auf der anderen Seite der Körpermitte</translation>
    </message>
    <message>
        <source>Its grid is sheared: its axes are not at right angles</source>
        <translation>Das Gitter ist geschert: seine Achsen stehen nicht senkrecht aufeinander</translation>
    </message>
    <message>
        <source>Keep circulation for comparison</source>
        <translation>Kreislauf zum Vergleich behalten</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Linke Niere</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Rechte Niere</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>LA-Höhle</translation>
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
        <source>Vertebra</source>
        <translation>Wirbel</translation>
    </message>
    <message>
        <source>Left rib</source>
        <translation>Linke Rippe</translation>
    </message>
    <message>
        <source>Right rib</source>
        <translation>Rechte Rippe</translation>
    </message>
    <message>
        <source>Upper lobe of the left lung</source>
        <translation>Oberlappen der linken Lunge</translation>
    </message>
    <message>
        <source>Lower lobe of the left lung</source>
        <translation>Unterlappen der linken Lunge</translation>
    </message>
    <message>
        <source>Upper lobe of the right lung</source>
        <translation>Oberlappen der rechten Lunge</translation>
    </message>
    <message>
        <source>Middle lobe of the right lung</source>
        <translation>Mittellappen der rechten Lunge</translation>
    </message>
    <message>
        <source>Lower lobe of the right lung</source>
        <translation>Unterlappen der rechten Lunge</translation>
    </message>
    <message>
        <source>Left deep back muscles</source>
        <translation>Linke autochthone Rückenmuskeln</translation>
    </message>
    <message>
        <source>Right deep back muscles</source>
        <translation>Rechte autochthone Rückenmuskeln</translation>
    </message>
    <message>
        <source>Left iliopsoas muscle</source>
        <translation>Linker Iliopsoas</translation>
    </message>
    <message>
        <source>Right iliopsoas muscle</source>
        <translation>Rechter Iliopsoas</translation>
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
        <source>Maximum of %1 mm</source>
        <translation>Maximum über %1 mm</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean of %1 mm</source>
        <translation>Mittel über %1 mm</translation>
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
        <source>Mean value over the Delaunay triangles of the handles as each point sees them; jumps where triangles flip, which blending reduces</source>
        <translation>Mean Value über die Delaunay-Dreiecke der Griffe, wie jeder Punkt sie sieht; Sprünge, wo Dreiecke kippen, durch Überblenden verringert</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Mean Value über die Voronoi-Regionen der Griffe, wie jeder Punkt sie sieht; Sprünge, oder langsam</translation>
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
        <translation>Mitralinsuffizienz</translation>
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
        <translation>Schlüsselbild bewegen</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Punkt einer Messung bewegen</translation>
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
        <source>No cavity is a ventricle by its name</source>
        <translation>Kein Hohlraum ist seinem Namen nach ein Ventrikel</translation>
    </message>
    <message>
        <source>No surface is chosen</source>
        <translation>Keine Oberfläche ist ausgewählt</translation>
    </message>
    <message>
        <source>No voxel has a label in %1</source>
        <translation>Kein Voxel hat in %1 ein Label</translation>
    </message>
    <message>
        <source>The key sequence has no key</source>
        <translation>Die Schlüsselbildfolge hat kein Schlüsselbild</translation>
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
        <source>Seed of the random numbers</source>
        <translation>Startwert der Zufallszahlen</translation>
    </message>
    <message>
        <source>Only label maps have labels</source>
        <translation>Nur Labelmaps haben Labels</translation>
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
        <source>Open sequence %1</source>
        <translation>Sequenz %1 öffnen</translation>
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
        <source>Pancreas</source>
        <translation>Bauchspeicheldrüse</translation>
    </message>
    <message>
        <source>Tissue folded at any instant</source>
        <translation>Zeitweise gefaltetes Gewebe</translation>
    </message>
    <message>
        <source>Maximum of largest stretch</source>
        <translation>Maximum der größten Streckung</translation>
    </message>
    <message>
        <source>Maximum rotational stress</source>
        <translation>Maximaler Rotationsstress</translation>
    </message>
    <message>
        <source>Minimum of smallest stretch</source>
        <translation>Minimum der kleinsten Streckung</translation>
    </message>
    <message>
        <source>Extreme volume ratio</source>
        <translation>Extremes Volumenverhältnis</translation>
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
        <translation>Schlüsselbild aufzeichnen</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Rectum</source>
        <translation>Rectum</translation>
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
        <source>Take out of group</source>
        <translation>Aus der Gruppe nehmen</translation>
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
            <numerusform>Schlüsselbild entfernen</numerusform>
            <numerusform>%n Schlüsselbilder entfernen</numerusform>
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
        <translation>Pose des Schlüsselbilds ersetzen</translation>
    </message>
    <message>
        <source>Replace key sequence</source>
        <translation>Schlüsselbildfolge ersetzen</translation>
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
        <source>S-Celestial</source>
        <translation>S-Celestial</translation>
    </message>
    <message>
        <source>Number of samples for each point</source>
        <translation>Anzahl der Stichproben je Punkt</translation>
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
        <source>Slice %1 (%2) is shifted sideways against those below it</source>
        <translation>Schicht %1 (%2) ist gegen die darunter seitlich verschoben</translation>
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
        <source>Some of its values need more than 32 bits as a whole number; they are kept as fractions of seven digits</source>
        <translation>Einige seiner Werte brauchen als ganze Zahl mehr als 32 Bit; sie werden als Dezimalzahlen mit sieben Stellen gehalten</translation>
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
        <source>Take handles of %1</source>
        <translation>Griffe von %1 verwenden</translation>
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
        <source>TetGen cannot fill this surface (%1)</source>
        <translation>TetGen kann diese Oberfläche nicht füllen (%1)</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen hat keinen Punkt in die Oberfläche gesetzt</translation>
    </message>
    <message>
        <source>TetGen wanted more than %1 MB of memory</source>
        <translation>TetGen brauchte mehr als %1 MB Speicher</translation>
    </message>
    <message>
        <source>TetGen was not done after %1 s</source>
        <translation>TetGen war nach %1 s nicht fertig</translation>
    </message>
    <message>
        <source>TetGen's program %1 cannot be started: %2</source>
        <translation>das Programm %1 von TetGen kann nicht gestartet werden: %2</translation>
    </message>
    <message>
        <source>TetGen&apos;s result does not fill this surface: %1</source>
        <translation>das Ergebnis von TetGen füllt diese Oberfläche nicht: %1</translation>
    </message>
    <message>
        <source>Textbook heartbeat</source>
        <translation>Herzschlag wie im Lehrbuch</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle is far higher than that of the aorta.</source>
        <translation>Die Aortenklappe öffnet sich auf 0,8 cm2: Der Druck des hypertrophierten Ventrikels liegt weit über dem der Aorta.</translation>
    </message>
    <message>
        <source>The cavity %1 is not inside the outer surface %2: %3 % of it lie outside</source>
        <translation>Der Hohlraum %1 liegt nicht in der äußeren Oberfläche %2: %3 % davon liegen außerhalb</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Die klassischen Koordinaten eines geschlossenen Käfigs; positiv, wo der Käfig konvex ist</translation>
    </message>
    <message>
        <source>The files' names are not in the order of the slices; they were put in order by position</source>
        <translation>Die Namen der Dateien folgen nicht der Reihenfolge der Schichten; sie wurden nach ihrer Lage geordnet</translation>
    </message>
    <message>
        <source>The grid of %1 is another one than that of the first phase</source>
        <translation>Das Gitter von %1 ist ein anderes als das der ersten Phase</translation>
    </message>
    <message>
        <source>The label &quot;%1&quot; is missing in %2</source>
        <translation>Das Label „%1“ fehlt in %2</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>Die Labelmap von %1 hat ein anderes Gitter (%2) als der Scan (%3); jede liegt dort, wo ihre Datei es sagt, und nichts wird umgerechnet</translation>
    </message>
    <message>
        <source>The last phase does not lead back to the first: they lie %1 mm apart on average, neighbours %2 mm at most</source>
        <translation>Die letzte Phase führt nicht zur ersten zurück: sie liegen im Mittel %1 mm auseinander, Nachbarn höchstens %2 mm</translation>
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
        <source>The mitral valve leaks through 0.45 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>Die Mitralklappe leckt durch 0,45 cm2: Die Hälfte dessen, was der Ventrikel auswirft, fließt in den Vorhof zurück.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>Die Zahl der Messpunkte muss zwischen %1 und %2 liegen</translation>
    </message>
    <message>
        <source>Target weights</source>
        <translation>Zielgewichte</translation>
    </message>
    <message>
        <source>The organ that this cavity is in is not there any more</source>
        <translation>Das Organ, in dem dieser Hohlraum liegt, ist nicht mehr da</translation>
    </message>
    <message>
        <source>The outlet of the stomach</source>
        <translation>Der Magenausgang</translation>
    </message>
    <message>
        <source>The period is not a positive time</source>
        <translation>Die Periode ist keine positive Zeit</translation>
    </message>
    <message>
        <source>The points of n-space that the wire connects</source>
        <translation>Die Punkte des n-Raums, die der Draht verbindet</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>Die Pose hat eine Position, die keine endliche Zahl oder zu weit entfernt ist</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie</source>
        <translation>Das Programm ffmpeg konnte den Film nicht schreiben</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie: %1</source>
        <translation>Das Programm ffmpeg konnte den Film nicht schreiben: %1</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>Die Sequenz bewegt %1 Griffe, es gibt aber %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>Die Sequenz wurde für einen anderen Ort eines Griffs gemacht</translation>
    </message>
    <message numerus="yes">
        <source>The series has images of several sizes: %n {image|images} of %2 left out, those of %3 read</source>
        <translation>
            <numerusform>Die Serie hat Bilder verschiedener Größe: %n Bild mit %2 weggelassen, die mit %3 gelesen</numerusform>
            <numerusform>Die Serie hat Bilder verschiedener Größe: %n Bilder mit %2 weggelassen, die mit %3 gelesen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The series has pixels of several sizes: %n {image|images} of %2 mm left out, those of %3 mm read</source>
        <translation>
            <numerusform>Die Serie hat Pixel verschiedener Größe: %n Bild mit %2 mm weggelassen, die mit %3 mm gelesen</numerusform>
            <numerusform>Die Serie hat Pixel verschiedener Größe: %n Bilder mit %2 mm weggelassen, die mit %3 mm gelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the way they are stacked (a tilted gantry); the shear is kept</source>
        <translation>Die Schichten sind um %1 Grad gegen ihre Stapelrichtung geneigt (gekippte Gantry); die Scherung bleibt erhalten</translation>
    </message>
    <message>
        <source>Maximises the smallest weight; positive, with kinks</source>
        <translation>Maximiert das kleinste Gewicht; positiv, mit Knicken</translation>
    </message>
    <message>
        <source>The spacing is uneven between slice %1 (%2) and the next, which are %3 mm apart in place of %4 mm (%5 %)</source>
        <translation>Der Abstand ist ungleichmäßig zwischen Schicht %1 (%2) und der nächsten, die %3 mm statt %4 mm auseinander liegen (%5 %)</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>Die Oberfläche hat kein Dreieck</translation>
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
        <source>The times of the phases do not ascend within one period of %1 ms: %2 is at %3 ms</source>
        <translation>Die Zeiten der Phasen steigen innerhalb einer Periode von %1 ms nicht an: %2 liegt bei %3 ms</translation>
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
        <source>The volume of %1 jumps from %2 to %3 ml between %4 and %5</source>
        <translation>Das Volumen von %1 springt zwischen %4 und %5 von %2 auf %3 ml</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Die Messpunkte liegen auf einem regelmäßigen Gitter in der Oberfläche. %1.</translation>
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
        <source>There is no %1</source>
        <translation>%1 gibt es nicht</translation>
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
        <translation>Es gibt noch keine Stresskarte</translation>
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
        <source>There is no surface &quot;%1&quot;</source>
        <translation>Es gibt keine Oberfläche „%1“</translation>
    </message>
    <message>
        <source>There is no volume in it</source>
        <translation>Die Datei enthält kein Volumen</translation>
    </message>
    <message>
        <source>There is not enough memory</source>
        <translation>Der Speicher reicht nicht</translation>
    </message>
    <message numerus="yes">
        <source>There {is|are} %n {time|times} for %2 phases</source>
        <translation>
            <numerusform>Es gibt %n Zeit für %2 Phasen</numerusform>
            <numerusform>Es gibt %n Zeiten für %2 Phasen</numerusform>
        </translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Verdickung</translation>
    </message>
    <message>
        <source>This file does not state its axes, but other files of the series are in RAS</source>
        <translation>Diese Datei nennt ihre Achsen nicht, aber andere Dateien der Serie sind in RAS</translation>
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
        <source>Tracing the displacement field</source>
        <translation>Das Verschiebungsfeld wird berechnet</translation>
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
        <source>two handles are at one place</source>
        <translation>zwei Griffe sind am selben Ort</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Processus uncinatus</translation>
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
        <source>VTK could not write the surface: %1</source>
        <translation>VTK konnte die Oberfläche nicht schreiben: %1</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Venen</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Volumenverhältnis</translation>
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
        <source>Amount added to each weight when a handle is inserted</source>
        <translation>Betrag, der beim Einfügen eines Griffs zu jedem Gewicht kommt</translation>
    </message>
    <message>
        <source>Treatment of negative weights</source>
        <translation>Behandlung negativer Gewichte</translation>
    </message>
    <message>
        <source>Pieces of the hull</source>
        <translation>Teile der Hülle</translation>
    </message>
    <message>
        <source>Volume that the pericardium holds without pressure</source>
        <translation>Volumen, das das Perikard ohne Druck fasst</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Wann der Anstieg der kleinsten Zahl endet</translation>
    </message>
    <message>
        <source>Direction in which 'iterative' moves the target</source>
        <translation>Richtung, in die „iterative“ das Ziel verschiebt</translation>
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
        <source>%1 of %2 ml is not life-sized: %3</source>
        <translation>%1 mit %2 ml ist nicht lebensgroß: %3</translation>
    </message>
    <message>
        <source>Two of its segments have the label %1, which NIfTI cannot tell apart</source>
        <translation>Zwei ihrer Segmente haben das Label %1, was NIfTI nicht unterscheiden kann</translation>
    </message>
    <message>
        <source>a .fcsv file is one list: the %1 groups and their colours are not kept (.mrk.json keeps them)</source>
        <translation>eine .fcsv-Datei ist eine Liste: die %1 Gruppen und ihre Farben bleiben nicht erhalten (in .mrk.json schon)</translation>
    </message>
    <message>
        <source>a 3D Slicer fiducial table</source>
        <translation>eine Markertabelle von 3D Slicer</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>eine JSON-Datei</translation>
    </message>
    <message>
        <source>a VTK XML file that holds no surface</source>
        <translation>eine VTK-XML-Datei ohne Oberfläche</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ein ZIP-Archiv</translation>
    </message>
    <message>
        <source>a buffer is at %1, but only files beside it are read</source>
        <translation>ein Puffer liegt bei %1, gelesen werden aber nur Dateien daneben</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>ein Käfig ist eine grobe Oberfläche: nehmen Sie eine mit höchstens %1 Eckpunkten</translation>
    </message>
    <message>
        <source>a gallbladder</source>
        <translation>eine Gallenblase</translation>
    </message>
    <message>
        <source>a gzip-compressed file</source>
        <translation>eine mit gzip gepackte Datei</translation>
    </message>
    <message>
        <source>a heart</source>
        <translation>ein Herz</translation>
    </message>
    <message>
        <source>a kidney</source>
        <translation>eine Niere</translation>
    </message>
    <message>
        <source>a liver</source>
        <translation>eine Leber</translation>
    </message>
    <message>
        <source>a locked volume must be positive</source>
        <translation>ein gesperrtes Volumen muss positiv sein</translation>
    </message>
    <message>
        <source>a myocardium</source>
        <translation>ein Myokard</translation>
    </message>
    <message>
        <source>a pancreas</source>
        <translation>eine Bauchspeicheldrüse</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>a point of the centreline lies %1 outside the organ</source>
        <translation>ein Punkt der Mittellinie liegt %1 außerhalb des Organs</translation>
    </message>
    <message>
        <source>a scan</source>
        <translation>ein Scan</translation>
    </message>
    <message>
        <source>a spleen</source>
        <translation>eine Milz</translation>
    </message>
    <message>
        <source>a stomach</source>
        <translation>ein Magen</translation>
    </message>
    <message>
        <source>a surface</source>
        <translation>eine Oberfläche</translation>
    </message>
    <message>
        <source>a surface of %1 vertices and %2 triangles is too small for handles</source>
        <translation>eine Oberfläche mit %1 Eckpunkten und %2 Dreiecken ist zu klein für Griffe</translation>
    </message>
    <message>
        <source>add a group that encloses them, or put handles around them into a group</source>
        <translation>fügen Sie eine Gruppe hinzu, die sie umschließt, oder nehmen Sie Griffe um sie herum in eine Gruppe auf</translation>
    </message>
    <message>
        <source>add a handle off that plane</source>
        <translation>fügen Sie einen Griff außerhalb dieser Ebene hinzu</translation>
    </message>
    <message>
        <source>add handles to it</source>
        <translation>fügen Sie ihr Griffe hinzu</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>fügen Sie Griffe hinzu, oder setzen Sie sie automatisch</translation>
    </message>
    <message>
        <source>add its file, or remove those of the other surfaces in that phase</source>
        <translation>fügen Sie ihre Datei hinzu, oder entfernen Sie die der anderen Oberflächen in dieser Phase</translation>
    </message>
    <message>
        <source>add the enclosing handles, or move handles outward until they surround the organ</source>
        <translation>fügen Sie die umschließenden Griffe hinzu, oder rücken Sie Griffe nach außen, bis sie das Organ umgeben</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>durch automatisches Gruppieren hinzugefügt</translation>
    </message>
    <message>
        <source>all handles</source>
        <translation>alle Griffe</translation>
    </message>
    <message>
        <source>all handles lie in one plane</source>
        <translation>alle Griffe liegen in einer Ebene</translation>
    </message>
    <message>
        <source>all handles lie on one line</source>
        <translation>alle Griffe liegen auf einer Geraden</translation>
    </message>
    <message>
        <source>all its handles lie in one plane, so its region is flat</source>
        <translation>alle ihre Griffe liegen in einer Ebene, darum ist ihre Region flach</translation>
    </message>
    <message>
        <source>all of it is a cavity</source>
        <translation>alles davon ist ein Hohlraum</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>alle Punkte liegen in einer Ebene</translation>
    </message>
    <message>
        <source>an error without a message</source>
        <translation>ein Fehler ohne Meldung</translation>
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
        <source>as in --period-ms 829</source>
        <translation>wie in --period-ms 829</translation>
    </message>
    <message>
        <source>ask for a volume nearer to that at rest, or let more handles compensate</source>
        <translation>verlangen Sie ein Volumen näher an dem in Ruhe, oder lassen Sie mehr Griffe ausgleichen</translation>
    </message>
    <message>
        <source>ask for at least %1</source>
        <translation>verlangen Sie mindestens %1</translation>
    </message>
    <message>
        <source>ask for fewer groups</source>
        <translation>verlangen Sie weniger Gruppen</translation>
    </message>
    <message>
        <source>ask for fewer witness points</source>
        <translation>verlangen Sie weniger Messpunkte</translation>
    </message>
    <message>
        <source>ask for fewer, or put them nearer to the surface</source>
        <translation>verlangen Sie weniger, oder setzen Sie sie näher an die Oberfläche</translation>
    </message>
    <message>
        <source>at least %1 are needed</source>
        <translation>mindestens %1 werden gebraucht</translation>
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
        <translation>Corpus</translation>
    </message>
    <message>
        <source>bounded biharmonic weights</source>
        <translation>beschränkte biharmonische Gewichte</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's left, but it lies on the right (x = %1 mm): %2</source>
        <translation>dem Namen nach gehört es auf die linke Seite des Patienten, es liegt aber rechts (x = %1 mm): %2</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's right, but it lies on the left (x = %1 mm): %2</source>
        <translation>dem Namen nach gehört es auf die rechte Seite des Patienten, es liegt aber links (x = %1 mm): %2</translation>
    </message>
    <message>
        <source>call the left ventricle's cavity LV and the right one's RV</source>
        <translation>nennen Sie den Hohlraum des linken Ventrikels LV und den des rechten RV</translation>
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
        <translation>Herzminutenvolumen</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>check its ending</source>
        <translation>prüfen Sie die Endung</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>prüfen Sie ihre Zugriffsrechte</translation>
    </message>
    <message>
        <source>check its scale and its number format</source>
        <translation>prüfen Sie Maßstab und Zahlenformat</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>prüfen Sie die Einheit; Koordinaten sind in mm</translation>
    </message>
    <message>
        <source>check that its surface is closed and outward</source>
        <translation>prüfen Sie, ob seine Oberfläche geschlossen ist und nach außen zeigt</translation>
    </message>
    <message>
        <source>check that its triangles face outward and that its holes are small</source>
        <translation>prüfen Sie, ob ihre Dreiecke nach außen zeigen und ihre Löcher klein sind</translation>
    </message>
    <message>
        <source>check that the segmentation was saved</source>
        <translation>prüfen Sie, ob die Segmentierung gespeichert wurde</translation>
    </message>
    <message>
        <source>check that there is room on the disk</source>
        <translation>prüfen Sie, ob auf der Festplatte Platz ist</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>prüfen Sie, ob Sie Leserechte haben</translation>
    </message>
    <message>
        <source>check the disk or the connection</source>
        <translation>prüfen Sie die Festplatte oder die Verbindung</translation>
    </message>
    <message>
        <source>check the name and the folder</source>
        <translation>prüfen Sie Namen und Ordner</translation>
    </message>
    <message>
        <source>check the space left on the disk</source>
        <translation>prüfen Sie den freien Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>check their order, and the period</source>
        <translation>prüfen Sie ihre Reihenfolge und die Periode</translation>
    </message>
    <message>
        <source>check this phase, or leave it out</source>
        <translation>prüfen Sie diese Phase, oder lassen Sie sie weg</translation>
    </message>
    <message>
        <source>check what the file is and where it came from</source>
        <translation>prüfen Sie, was die Datei ist und woher sie kommt</translation>
    </message>
    <message>
        <source>check whether one of them is mislabelled, or leave it out</source>
        <translation>prüfen Sie, ob eine davon falsch gekennzeichnet ist, oder lassen Sie sie weg</translation>
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
        <source>choose a file that Viscera has saved as .sequence.json</source>
        <translation>wählen Sie eine Datei, die Viscera als .sequence.json gespeichert hat</translation>
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
        <source>choose a folder that exists, may be written to and has room</source>
        <translation>wählen Sie einen Ordner, den es gibt, der beschreibbar ist und Platz hat</translation>
    </message>
    <message>
        <source>choose a surface that has some</source>
        <translation>wählen Sie eine Oberfläche, die welche hat</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>choose at least one</source>
        <translation>wählen Sie mindestens eine</translation>
    </message>
    <message>
        <source>choose it again in Play mode</source>
        <translation>wählen Sie sie im Modus Abspielen neu</translation>
    </message>
    <message>
        <source>choose it on the organ; check the axes (RAS or LPS) too</source>
        <translation>wählen Sie sie auf dem Organ; prüfen Sie auch die Achsen (RAS oder LPS)</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>wählen Sie eine davon</translation>
    </message>
    <message>
        <source>choose the two ends of the organ</source>
        <translation>wählen Sie die beiden Enden des Organs</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>wählen Sie zwei Enden einer Oberfläche</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>schließen Sie zuerst ihre Löcher</translation>
    </message>
    <message>
        <source>close its holes, as viscera convert IN OUT --fill-holes does; an open surface has no volume to keep</source>
        <translation>schließen Sie seine Löcher, etwa mit viscera convert EIN AUS --fill-holes; eine offene Oberfläche hat kein Volumen, das zu erhalten wäre</translation>
    </message>
    <message>
        <source>close other programs, or use fewer handles or smaller organs</source>
        <translation>schließen Sie andere Programme, oder verwenden Sie weniger Griffe oder kleinere Organe</translation>
    </message>
    <message>
        <source>compensating handles</source>
        <translation>ausgleichende Griffe</translation>
    </message>
    <message>
        <source>convert it to .seg.nrrd</source>
        <translation>wandeln Sie sie in .seg.nrrd um</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>Koordinaten brauchen mindestens vier Griffe, es gibt %1</translation>
    </message>
    <message>
        <source>copy its contents to a file first</source>
        <translation>kopieren Sie den Inhalt zuerst in eine Datei</translation>
    </message>
    <message>
        <source>copy the file anew, or take it out of the folder to read the others</source>
        <translation>kopieren Sie die Datei neu, oder nehmen Sie sie aus dem Ordner, um die anderen zu lesen</translation>
    </message>
    <message>
        <source>crop the image to the organs</source>
        <translation>schneiden Sie das Bild auf die Organe zu</translation>
    </message>
    <message>
        <source>deeper ones would push folds of the surface into one another</source>
        <translation>tiefere würden Falten der Oberfläche ineinander schieben</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>derivatives at the witness points</source>
        <translation>Ableitungen an den Messpunkten</translation>
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
        <source>does not say how large its pixels are</source>
        <translation>nennt die Größe ihrer Pixel nicht</translation>
    </message>
    <message>
        <source>does not say where in the patient it lies</source>
        <translation>nennt ihre Lage im Patienten nicht</translation>
    </message>
    <message>
        <source>does not say where its frames lie</source>
        <translation>nennt die Lage ihrer Einzelbilder nicht</translation>
    </message>
    <message>
        <source>ejection</source>
        <translation>Austreibung</translation>
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
        <source>even so, folds of the surface meet when they pass</source>
        <translation>auch so berühren sich Falten der Oberfläche, wenn sie vorbeilaufen</translation>
    </message>
    <message>
        <source>exchanges left and right</source>
        <translation>vertauscht links und rechts</translation>
    </message>
    <message>
        <source>expiration</source>
        <translation>Ausatmung</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same axes</source>
        <translation>exportieren Sie alle Oberflächen eines Patienten in denselben Achsen</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same way (viscera convert --space LPS)</source>
        <translation>exportieren Sie alle Oberflächen eines Patienten auf dieselbe Weise (viscera convert --space LPS)</translation>
    </message>
    <message>
        <source>export it as a surface of triangles</source>
        <translation>exportieren Sie sie als Oberfläche aus Dreiecken</translation>
    </message>
    <message>
        <source>export it as glTF 2.0</source>
        <translation>exportieren Sie sie als glTF 2.0</translation>
    </message>
    <message>
        <source>export it as pixels of 16 bits</source>
        <translation>exportieren Sie sie mit Pixeln von 16 Bit</translation>
    </message>
    <message>
        <source>export it little-endian</source>
        <translation>exportieren Sie sie in Little-Endian-Folge</translation>
    </message>
    <message>
        <source>export it without compression</source>
        <translation>exportieren Sie sie ohne Kompression</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>exportieren oder kopieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>exportieren Sie die Oberfläche neu</translation>
    </message>
    <message>
        <source>extract its surface first</source>
        <translation>extrahieren Sie zuerst die Oberfläche</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>filling the handles with tetrahedra</source>
        <translation>Füllen der Griffe mit Tetraedern</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>Füllen des Organs mit Tetraedern</translation>
    </message>
    <message>
        <source>fills every hole with a cap</source>
        <translation>schließt jedes Loch mit einer Kappe</translation>
    </message>
    <message>
        <source>finding landmarks</source>
        <translation>Suche nach Landmarken</translation>
    </message>
    <message>
        <source>folded where it is hatched</source>
        <translation>gefaltet, wo es schraffiert ist</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>Fundus</translation>
    </message>
    <message>
        <source>fundus, centreline from the fundus down, body in between, pylorus</source>
        <translation>Fundus, Mittellinie vom Fundus abwärts, dazwischen der Corpus, Pylorus</translation>
    </message>
    <message>
        <source>give apex and base too</source>
        <translation>geben Sie auch apex und base an</translation>
    </message>
    <message>
        <source>give both, or none to have them computed</source>
        <translation>geben Sie beide an, oder keine, damit sie berechnet werden</translation>
    </message>
    <message>
        <source>give every handle a label of its own</source>
        <translation>geben Sie jedem Griff eine eigene Bezeichnung</translation>
    </message>
    <message>
        <source>give fundus and pylorus too</source>
        <translation>geben Sie auch fundus und pylorus an</translation>
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
        <source>give its labels smaller numbers</source>
        <translation>geben Sie den Labels kleinere Nummern</translation>
    </message>
    <message>
        <source>give one between 0.1 and 0.8</source>
        <translation>geben Sie eine zwischen 0,1 und 0,8 an</translation>
    </message>
    <message>
        <source>give one for each phase</source>
        <translation>geben Sie eine für jede Phase an</translation>
    </message>
    <message>
        <source>give points of the centreline yourself</source>
        <translation>geben Sie selbst Punkte der Mittellinie an</translation>
    </message>
    <message>
        <source>give the outer surface the labels of its cavities too, as in EPI=1,2,3</source>
        <translation>geben Sie der äußeren Oberfläche auch die Labels ihrer Hohlräume, wie in EPI=1,2,3</translation>
    </message>
    <message>
        <source>glTF does not say which axes a patient&apos;s are: its numbers are taken as LPS millimetres, though the format&apos;s convention is metres with y up</source>
        <translation>glTF sagt nicht, welche Achsen die des Patienten sind: die Zahlen werden als LPS-Millimeter genommen, obwohl das Format Meter mit y nach oben vorsieht</translation>
    </message>
    <message>
        <source>grid inside the surface</source>
        <translation>Gitter in der Oberfläche</translation>
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
        <source>group &apos;%1&apos;</source>
        <translation>Gruppe „%1“</translation>
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
        <source>harmonic coordinates</source>
        <translation>harmonische Koordinaten</translation>
    </message>
    <message numerus="yes">
        <source>has %n {column|columns}</source>
        <translation>
            <numerusform>hat %n Spalte</numerusform>
            <numerusform>hat %n Spalten</numerusform>
        </translation>
    </message>
    <message>
        <source>has a heading that does not say what the instants are</source>
        <translation>hat eine Überschrift, die nicht sagt, was die Zeitpunkte sind</translation>
    </message>
    <message>
        <source>has a volume that is not positive</source>
        <translation>hat ein Volumen, das nicht positiv ist</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>hat keine Pixel</translation>
    </message>
    <message>
        <source>has pixels that are fractions (Float Pixel Data), which Viscera does not read; export it as whole numbers, or as NIfTI</source>
        <translation>hat Pixel, die Dezimalzahlen sind (Float Pixel Data), was Viscera nicht liest; exportieren Sie sie mit ganzen Zahlen oder als NIfTI</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>holds something that is not a number</source>
        <translation>enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>if it is not a whole cycle, say that it is to be played once (--once); else add the phases that are missing</source>
        <translation>wenn es kein ganzer Zyklus ist, geben Sie an, dass er einmal abgespielt werden soll (--once); sonst fügen Sie die fehlenden Phasen hinzu</translation>
    </message>
    <message>
        <source>in</source>
        <translation>anlaufend</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>Einatmung</translation>
    </message>
    <message>
        <source>install Viscera again, or name it in VISCERA_TETGEN_WORKER</source>
        <translation>installieren Sie Viscera neu, oder geben Sie es in VISCERA_TETGEN_WORKER an</translation>
    </message>
    <message>
        <source>install ffmpeg, or write an .ogv</source>
        <translation>installieren Sie ffmpeg, oder schreiben Sie eine .ogv-Datei</translation>
    </message>
    <message>
        <source>is a colour image</source>
        <translation>ist ein Farbbild</translation>
    </message>
    <message>
        <source>is a mosaic of many slices in one image, as Siemens writes them, which Viscera does not take apart; convert it to NIfTI (dcm2niix does)</source>
        <translation>ist ein Mosaik aus vielen Schichten in einem Bild, wie Siemens sie schreibt, das Viscera nicht zerlegt; wandeln Sie es in NIfTI um (dcm2niix kann das)</translation>
    </message>
    <message>
        <source>is not a file that can be read</source>
        <translation>ist keine Datei, die gelesen werden kann</translation>
    </message>
    <message>
        <source>is not later than the line before</source>
        <translation>ist nicht später als die Zeile davor</translation>
    </message>
    <message numerus="yes">
        <source>is not manifold at %n {edge|edges}</source>
        <translation>
            <numerusform>ist an %n Kante keine Mannigfaltigkeit</numerusform>
            <numerusform>ist an %n Kanten keine Mannigfaltigkeit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>is open at %n {edge|edges}</source>
        <translation>
            <numerusform>ist an %n Kante offen</numerusform>
            <numerusform>ist an %n Kanten offen</numerusform>
        </translation>
    </message>
    <message>
        <source>is too thin in places for a surface with the volume of its voxels</source>
        <translation>ist stellenweise zu dünn für eine Oberfläche mit dem Volumen seiner Voxel</translation>
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
        <source>it does not say how large its voxels are; 1 mm is assumed</source>
        <translation>die Größe der Voxel ist nicht angegeben; 1 mm wird angenommen</translation>
    </message>
    <message>
        <source>it does not say where the patient's sides are; axes are taken as right, front and up</source>
        <translation>die Seiten des Patienten sind nicht angegeben; die Achsen werden als rechts, vorn und oben genommen</translation>
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
        <translation>es liegt keine Millisekunde hinter dem vorigen Schlüsselbild</translation>
    </message>
    <message>
        <source>it may be mirrored</source>
        <translation>vielleicht ist es gespiegelt</translation>
    </message>
    <message>
        <source>its axes %1 are unknown; LPS is assumed</source>
        <translation>ihre Achsen %1 sind unbekannt; LPS wird angenommen</translation>
    </message>
    <message>
        <source>its encoding %1 is not supported</source>
        <translation>ihre Kodierung %1 wird nicht unterstützt</translation>
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
        <source>its frames lie in different directions</source>
        <translation>ihre Einzelbilder liegen in verschiedenen Richtungen</translation>
    </message>
    <message>
        <source>its labels are those of a heart: muscle and chambers are its outer surface, each chamber is a cavity</source>
        <translation>seine Labels sind die eines Herzens: Muskel und Herzhöhlen bilden die äußere Oberfläche, jede Herzhöhle ist ein Hohlraum</translation>
    </message>
    <message>
        <source>its pixels of %1 bits in %2, up to bit %3, are not supported</source>
        <translation>ihre Pixel mit %1 Bits in %2, bis Bit %3, werden nicht unterstützt</translation>
    </message>
    <message>
        <source>its sform and qform place the image differently; the sform is used</source>
        <translation>sform und qform legen das Bild verschieden; verwendet wird sform</translation>
    </message>
    <message>
        <source>its sform is singular or not finite and is not used</source>
        <translation>sform ist singulär oder nicht endlich und wird nicht verwendet</translation>
    </message>
    <message>
        <source>its slices are not equally far from each other (frame %1)</source>
        <translation>ihre Schichten sind nicht gleich weit voneinander entfernt (Einzelbild %1)</translation>
    </message>
    <message>
        <source>its surface has changed: measured points were moved to the nearest places on the new surface</source>
        <translation>seine Oberfläche hat sich geändert: Gemessene Punkte wurden an die nächsten Stellen der neuen Oberfläche verschoben</translation>
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
        <source>its volume can be kept only after it is bound to the present handles</source>
        <translation>sein Volumen kann erst gehalten werden, nachdem es an die vorhandenen Griffe gebunden ist</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>sein Volumen ist nicht mehr gesperrt: die Oberfläche ist jetzt offen</translation>
    </message>
    <message>
        <source>its voxels lie elsewhere than those of the other masks</source>
        <translation>ihre Voxel liegen woanders als die der anderen Masken</translation>
    </message>
    <message>
        <source>keep the largest, as viscera convert IN OUT --keep-largest does</source>
        <translation>behalten Sie das größte, etwa mit viscera convert EIN AUS --keep-largest</translation>
    </message>
    <message>
        <source>keeps the piece with the largest area and drops the others</source>
        <translation>behält das Stück mit der größten Fläche und lässt die anderen weg</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüsselbild</translation>
    </message>
    <message>
        <source>mmHg</source>
        <translation>mmHg</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>Schlüsselbild %1</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>Kilometer</translation>
    </message>
    <message>
        <source>known endings: %1</source>
        <translation>bekannte Endungen: %1</translation>
    </message>
    <message>
        <source>label it in every phase, or leave this phase out</source>
        <translation>kennzeichnen Sie es in jeder Phase, oder lassen Sie diese Phase weg</translation>
    </message>
    <message>
        <source>label the points %1</source>
        <translation>benennen Sie die Punkte %1</translation>
    </message>
    <message>
        <source>leave it out for surfaces</source>
        <translation>lassen Sie dies bei Oberflächen weg</translation>
    </message>
    <message>
        <source>leave the landmarks out</source>
        <translation>lassen Sie die Landmarken weg</translation>
    </message>
    <message>
        <source>leave two: the instant, and the volume in ml</source>
        <translation>lassen Sie zwei: den Zeitpunkt und das Volumen in ml</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>verlängern Sie zuerst die Periode</translation>
    </message>
    <message>
        <source>let it begin with &quot;time_s&quot; for seconds, or with &quot;fraction&quot; for parts of the cycle</source>
        <translation>lassen Sie sie für Sekunden mit „time_s“ beginnen, für Teile des Zyklus mit „fraction“</translation>
    </message>
    <message>
        <source>let more handles compensate, or ask for a volume nearer to the present one</source>
        <translation>lassen Sie mehr Griffe ausgleichen, oder verlangen Sie ein Volumen näher am jetzigen</translation>
    </message>
    <message>
        <source>let the last volume be the first one</source>
        <translation>machen Sie das letzte Volumen gleich dem ersten</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>load a closed surface</source>
        <translation>laden Sie eine geschlossene Oberfläche</translation>
    </message>
    <message>
        <source>localised coordinates</source>
        <translation>lokalisierte Koordinaten</translation>
    </message>
    <message>
        <source>looking for folds</source>
        <translation>Suche nach Falten</translation>
    </message>
    <message>
        <source>make the handles from this cage: viscera handles ORGAN --cage FILE</source>
        <translation>erzeugen Sie die Griffe aus diesem Käfig: viscera handles ORGAN --cage DATEI</translation>
    </message>
    <message>
        <source>makes a closed surface without intersections near this one; colours are lost</source>
        <translation>macht eine geschlossene Oberfläche ohne Durchdringungen nahe dieser; Farben gehen verloren</translation>
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
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>Mikrometer</translation>
    </message>
    <message>
        <source>centreline</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
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
        <source>move or delete one of them</source>
        <translation>verschieben oder löschen Sie einen davon</translation>
    </message>
    <message>
        <source>move or remove one of them</source>
        <translation>verschieben oder entfernen Sie einen davon</translation>
    </message>
    <message>
        <source>move some off the line</source>
        <translation>verschieben Sie einige von der Geraden weg</translation>
    </message>
    <message>
        <source>move some off the plane, or add enclosing handles</source>
        <translation>verschieben Sie einige aus der Ebene, oder fügen Sie umschließende Griffe hinzu</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>rücken Sie die Eckpunkte dort auseinander, oder nehmen Sie einen anderen Käfig</translation>
    </message>
    <message>
        <source>movies of this kind cannot be written</source>
        <translation>Filme dieser Art können nicht geschrieben werden</translation>
    </message>
    <message>
        <source>name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase</source>
        <translation>geben Sie ein 4D-NIfTI, ein .seq.nrrd von 3D Slicer oder eine Datei für jede Phase an</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>geben Sie eine Datei darin an</translation>
    </message>
    <message>
        <source>name a folder with one file for each phase</source>
        <translation>geben Sie einen Ordner mit einer Datei für jede Phase an</translation>
    </message>
    <message>
        <source>name a folder with one mask for each organ, such as liver.nii.gz</source>
        <translation>geben Sie einen Ordner mit einer Maske für jedes Organ an, wie liver.nii.gz</translation>
    </message>
    <message>
        <source>name all phases of the cycle</source>
        <translation>geben Sie alle Phasen des Zyklus an</translation>
    </message>
    <message>
        <source>name all phases of the cycle; a single image of a heart with cavities can beat as the textbook's (--textbook, in the window Fit a sequence to an organ)</source>
        <translation>geben Sie alle Phasen des Zyklus an; ein einzelnes Bild eines Herzens mit Hohlräumen kann wie im Lehrbuch schlagen (--textbook, im Fenster: Sequenz an ein Organ anpassen)</translation>
    </message>
    <message>
        <source>name compensating handles</source>
        <translation>geben Sie ausgleichende Griffe an</translation>
    </message>
    <message>
        <source>name instants from 0 to 1</source>
        <translation>nennen Sie Zeitpunkte von 0 bis 1</translation>
    </message>
    <message>
        <source>name instants from 0 to 1, or write &quot;time_s&quot; above them for seconds</source>
        <translation>nennen Sie Zeitpunkte von 0 bis 1, oder schreiben Sie für Sekunden „time_s“ darüber</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>nennen Sie sie %1</translation>
    </message>
    <message>
        <source>name its files, a folder, or a file with several phases</source>
        <translation>geben Sie ihre Dateien, einen Ordner oder eine Datei mit mehreren Phasen an</translation>
    </message>
    <message>
        <source>name the folder of a CT or MR series</source>
        <translation>geben Sie den Ordner einer CT- oder MR-Serie an</translation>
    </message>
    <message>
        <source>name the folder of one patient</source>
        <translation>geben Sie den Ordner eines Patienten an</translation>
    </message>
    <message>
        <source>name the folder, or another file in it</source>
        <translation>geben Sie den Ordner an, oder eine andere Datei darin</translation>
    </message>
    <message>
        <source>names an instant outside the cycle</source>
        <translation>nennt einen Zeitpunkt außerhalb des Zyklus</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>Nanometer</translation>
    </message>
    <message>
        <source>no compensation within %1 mm restores the volume</source>
        <translation>kein Ausgleich innerhalb von %1 mm stellt das Volumen wieder her</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>keine Kante verbindet mehr als zwei Dreiecke</translation>
    </message>
    <message>
        <source>no handle is left to compensate the change of volume</source>
        <translation>es bleibt kein Griff, der die Volumenänderung ausgleichen könnte</translation>
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
        <source>no witness point lies inside</source>
        <translation>kein Messpunkt liegt innen</translation>
    </message>
    <message>
        <source>node %1 is moved by bones, which are ignored</source>
        <translation>Knoten %1 wird von Knochen bewegt, die ignoriert werden</translation>
    </message>
    <message>
        <source>of an unknown kind</source>
        <translation>von unbekannter Art</translation>
    </message>
    <message numerus="yes">
        <source>only %n {handle|handles}</source>
        <translation>
            <numerusform>nur %n Griff</numerusform>
            <numerusform>nur %n Griffe</numerusform>
        </translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>öffnen Sie ihn zu den Organen (Datei &gt; Scan öffnen), oder machen Sie daraus zuerst eine Labelmap, mit 3D Slicer oder TotalSegmentator</translation>
    </message>
    <message>
        <source>open it by itself, or remove it from the folder</source>
        <translation>öffnen Sie sie allein, oder entfernen Sie sie aus dem Ordner</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>öffnen Sie zuerst eines</translation>
    </message>
    <message>
        <source>open it by itself, and the other files after it</source>
        <translation>öffnen Sie sie allein und die anderen Dateien danach</translation>
    </message>
    <message>
        <source>open it with File &gt; Open</source>
        <translation>öffnen Sie sie mit Datei &gt; Öffnen</translation>
    </message>
    <message>
        <source>open the segmentation that was made from it</source>
        <translation>öffnen Sie die daraus gemachte Segmentierung</translation>
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
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation>Phase %1</translation>
    </message>
    <message>
        <source>phase %1 fits much worse than its neighbours (%2 against %3 mm): look at its data, or leave it out</source>
        <translation>Phase %1 passt viel schlechter als ihre Nachbarn (%2 gegen %3 mm): prüfen Sie ihre Daten, oder lassen Sie sie weg</translation>
    </message>
    <message>
        <source>phase %1: %2</source>
        <translation>Phase %1: %2</translation>
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
        <source>place more handles</source>
        <translation>setzen Sie mehr Griffe</translation>
    </message>
    <message>
        <source>place some first</source>
        <translation>setzen Sie zuerst welche</translation>
    </message>
    <message>
        <source>place some points and save them again</source>
        <translation>setzen Sie einige Punkte, und speichern Sie sie neu</translation>
    </message>
    <message>
        <source>place the handle again</source>
        <translation>setzen Sie den Griff neu</translation>
    </message>
    <message>
        <source>placing handles</source>
        <translation>Setzen der Griffe</translation>
    </message>
    <message>
        <source>play at the rate that the times are for</source>
        <translation>spielen Sie mit der Frequenz ab, für die die Zeiten gelten</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>Punkte, die zusammenfallen oder fast in einer Ebene liegen, sind die Ursache</translation>
    </message>
    <message>
        <source>put both files into one folder</source>
        <translation>legen Sie beide Dateien in einen Ordner</translation>
    </message>
    <message>
        <source>put it into the middle of the stomach</source>
        <translation>setzen Sie ihn in die Mitte des Magens</translation>
    </message>
    <message>
        <source>put masks of one image into a folder of their own</source>
        <translation>legen Sie die Masken eines Bildes in einen eigenen Ordner</translation>
    </message>
    <message>
        <source>put those of one kind into a folder of their own</source>
        <translation>legen Sie die einer Art in einen eigenen Ordner</translation>
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
        <source>reaches the edge of the image, which may cut it off</source>
        <translation>reicht bis an den Bildrand, der es vielleicht abschneidet</translation>
    </message>
    <message>
        <source>add a key first</source>
        <translation>fügen Sie zuerst ein Schlüsselbild hinzu</translation>
    </message>
    <message>
        <source>record and save the sequence again</source>
        <translation>zeichnen Sie die Sequenz neu auf, und speichern Sie sie</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>reduce the surface first</source>
        <translation>verkleinern Sie die Oberfläche zuerst</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>langsame Austreibung</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>entfernen Sie eine der beiden</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>entfernen Sie eine davon</translation>
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
        <source>resample all phases to one grid, in the same axes</source>
        <translation>rechnen Sie alle Phasen auf ein Gitter mit denselben Achsen um</translation>
    </message>
    <message>
        <source>resample the images to an upright grid</source>
        <translation>rechnen Sie die Bilder auf ein rechtwinkliges Gitter um</translation>
    </message>
    <message>
        <source>resample the segmentation, for example by saving it as .seg.nrrd</source>
        <translation>rechnen Sie die Segmentierung um, zum Beispiel durch Speichern als .seg.nrrd</translation>
    </message>
    <message>
        <source>reset the pose</source>
        <translation>setzen Sie die Pose zurück</translation>
    </message>
    <message>
        <source>restoring the volume would move a handle by %1 mm</source>
        <translation>um das Volumen wiederherzustellen, müsste sich ein Griff um %1 mm bewegen</translation>
    </message>
    <message>
        <source>right and left are exchanged, and so are front and back: the files seem to be in RAS</source>
        <translation>rechts und links sind vertauscht, ebenso vorn und hinten: die Dateien scheinen in RAS zu sein</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>rechts und links sind vertauscht, vorn und hinten nicht: gespiegelt</translation>
    </message>
    <message>
        <source>right and left are exchanged: the files may be in RAS, or mirrored</source>
        <translation>rechts und links sind vertauscht: die Dateien sind vielleicht in RAS oder gespiegelt</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>speichern Sie es zuerst als eigene Datei</translation>
    </message>
    <message>
        <source>save it as a segmentation</source>
        <translation>speichern Sie sie als Segmentierung</translation>
    </message>
    <message>
        <source>save it as a 3D image</source>
        <translation>speichern Sie es als 3D-Bild</translation>
    </message>
    <message>
        <source>save it with gzip or raw encoding</source>
        <translation>speichern Sie sie mit der Kodierung gzip oder raw</translation>
    </message>
    <message>
        <source>save it with one value per voxel</source>
        <translation>speichern Sie es mit einem Wert je Voxel</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>speichern Sie oft, oder schaffen Sie dort Platz</translation>
    </message>
    <message>
        <source>save the points from Slicer as .mrk.json</source>
        <translation>speichern Sie die Punkte in Slicer als .mrk.json</translation>
    </message>
    <message>
        <source>save the points from Slicer in LPS</source>
        <translation>speichern Sie die Punkte in Slicer in LPS</translation>
    </message>
    <message>
        <source>give it with --period-ms, or the rate with --rate</source>
        <translation>geben Sie sie mit --period-ms an, oder die Frequenz mit --rate</translation>
    </message>
    <message>
        <source>say which surfaces they make, as in --surface LV=1 --surface RV=2 --surface EPI=1,2,3 with all labels within the outer one</source>
        <translation>geben Sie an, welche Oberflächen sie bilden, wie in --surface LV=1 --surface RV=2 --surface EPI=1,2,3, die äußere mit allen Labels darin</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>sort the lines by their instants</source>
        <translation>ordnen Sie die Zeilen nach ihren Zeitpunkten</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>stress over the sequence</source>
        <translation>Stress über die Sequenz</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>Schlagvolumen</translation>
    </message>
    <message>
        <source>surfaces at rest</source>
        <translation>Oberflächen in Ruhe</translation>
    </message>
    <message>
        <source>system parameters</source>
        <translation>Parameter des Systems</translation>
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
        <source>take a cage that surrounds the organ, or the handles' convex hull as the cage</source>
        <translation>verwenden Sie einen Käfig, der das Organ umgibt, oder die konvexe Hülle der Griffe als Käfig</translation>
    </message>
    <message>
        <source>take a closed cage, or none: then the convex hull of the handles is the cage</source>
        <translation>verwenden Sie einen geschlossenen Käfig oder keinen: dann ist die konvexe Hülle der Griffe der Käfig</translation>
    </message>
    <message>
        <source>take a convex cage, or none: then the convex hull of the handles is the cage</source>
        <translation>verwenden Sie einen konvexen Käfig oder keinen: dann ist die konvexe Hülle der Griffe der Käfig</translation>
    </message>
    <message>
        <source>take a larger one</source>
        <translation>wählen Sie einen größeren</translation>
    </message>
    <message>
        <source>take another positivity</source>
        <translation>wählen Sie eine andere Positivität</translation>
    </message>
    <message>
        <source>take the sequence's own handles</source>
        <translation>nehmen Sie die eigenen Griffe der Sequenz</translation>
    </message>
    <message>
        <source>takes the coordinates as %1</source>
        <translation>nimmt die Koordinaten als %1</translation>
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
        <source>the cage</source>
        <translation>der Käfig</translation>
    </message>
    <message>
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>die konvexe Hülle von %1 Punkten kann nicht berechnet werden</translation>
    </message>
    <message>
        <source>the coordinates are kept in single precision: they would take %1 MiB otherwise</source>
        <translation>die Koordinaten werden in einfacher Genauigkeit gehalten; sonst bräuchten sie %1 MiB</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>die Datei nennt ihre Achsen nicht: LPS wird angenommen</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file may be in RAS, or mirrored</source>
        <translation>die Datei ist vielleicht in RAS oder gespiegelt</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>die Datei nennt ihre Achsen: %1</translation>
    </message>
    <message>
        <source>the file with its voxels, %1, cannot be read: %2</source>
        <translation>die Datei mit ihren Voxeln, %1, kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>the first one is 0</source>
        <translation>die erste ist 0</translation>
    </message>
    <message>
        <source>the first one is: &quot;%1&quot;</source>
        <translation>die erste ist: „%1“</translation>
    </message>
    <message>
        <source>the first phase</source>
        <translation>die erste Phase</translation>
    </message>
    <message>
        <source>the folder for the frames cannot be written</source>
        <translation>in den Ordner für die Einzelbilder kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>die Griffe umschließen nichts: %1</translation>
    </message>
    <message>
        <source>the handles that may compensate cannot restore the volume</source>
        <translation>die Griffe, die ausgleichen dürfen, können das Volumen nicht wiederherstellen</translation>
    </message>
    <message>
        <source>the handles' tetrahedra</source>
        <translation>die Tetraeder der Griffe</translation>
    </message>
    <message>
        <source>the label &quot;%1&quot; is not a landmark of the sequence %2</source>
        <translation>die Bezeichnung „%1“ ist keine Landmarke der Sequenz %2</translation>
    </message>
    <message>
        <source>the landmark &quot;%1&quot; comes twice</source>
        <translation>die Landmarke „%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>the landmark lies %1 outside the organ</source>
        <translation>die Landmarke liegt %1 außerhalb des Organs</translation>
    </message>
    <message>
        <source>the landmark's position is not a finite number</source>
        <translation>die Position der Landmarke ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the landmarks are not in order along the stomach</source>
        <translation>die Landmarken liegen nicht in der richtigen Reihenfolge am Magen entlang</translation>
    </message>
    <message>
        <source>the last phase equals the first and is left out: phase %1 would be phase 1 again</source>
        <translation>die letzte Phase gleicht der ersten und wird weggelassen: Phase %1 wäre wieder Phase 1</translation>
    </message>
    <message>
        <source>the locked volumes cannot be kept</source>
        <translation>die gesperrten Volumina können nicht erhalten werden</translation>
    </message>
    <message>
        <source>the markup %1 of type %2 is not a list of points and was left out</source>
        <translation>das Markup %1 vom Typ %2 ist keine Liste von Punkten und wurde weggelassen</translation>
    </message>
    <message>
        <source>the computed centreline leaves the organ</source>
        <translation>die berechnete Mittellinie verlässt das Organ</translation>
    </message>
    <message>
        <source>the motion is the textbook's, fitted to one image: it is not this patient's own</source>
        <translation>die Bewegung ist die des Lehrbuchs, an ein Bild angepasst: sie ist nicht die eigene dieses Patienten</translation>
    </message>
    <message>
        <source>the motion of an organ cannot be made again: nothing is known of how it was made</source>
        <translation>die Bewegung eines Organs kann nicht wiederhergestellt werden: es ist nicht bekannt, wie sie gemacht wurde</translation>
    </message>
    <message>
        <source>the movie cannot be written</source>
        <translation>der Film kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the movie has no frame</source>
        <translation>der Film hat kein Einzelbild</translation>
    </message>
    <message>
        <source>the name of a sequence file ends in .sequence.json</source>
        <translation>der Name einer Sequenzdatei endet auf .sequence.json</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>der Name einer Sitzungsdatei endet auf .viscera</translation>
    </message>
    <message>
        <source>the names of its labels are those of %1</source>
        <translation>die Namen der Labels sind die aus %1</translation>
    </message>
    <message>
        <source>the offset of region &apos;%1&apos; is cut to %2 mm, the distance of its nearest handle from a zone</source>
        <translation>der Versatz der Region „%1“ ist auf %2 mm gekürzt, den Abstand ihres nächsten Griffs von einer Zone</translation>
    </message>
    <message>
        <source>the organ is %1 times as long as that of an adult; check its unit</source>
        <translation>das Organ ist %1-mal so lang wie das eines Erwachsenen; prüfen Sie seine Einheit</translation>
    </message>
    <message>
        <source>the organ is in %1 pieces</source>
        <translation>das Organ besteht aus %1 Stücken</translation>
    </message>
    <message>
        <source>the organ is inside out or flat</source>
        <translation>das Organ ist umgestülpt oder flach</translation>
    </message>
    <message numerus="yes">
        <source>the organ is open: %n boundary {edge|edges}</source>
        <translation>
            <numerusform>das Organ ist offen: %n Randkante</numerusform>
            <numerusform>das Organ ist offen: %n Randkanten</numerusform>
        </translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>das Bild kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the position is not finite</source>
        <translation>die Position ist nicht endlich</translation>
    </message>
    <message>
        <source>the position of the handle %1 in %2 is not finite</source>
        <translation>die Position des Griffs %1 in %2 ist nicht endlich</translation>
    </message>
    <message>
        <source>the program ffmpeg is needed for this kind of movie and is not installed</source>
        <translation>für diese Art von Film wird das Programm ffmpeg gebraucht, das nicht installiert ist</translation>
    </message>
    <message>
        <source>the right ventricle is too small to eject as much as the left one</source>
        <translation>der rechte Ventrikel ist zu klein, um so viel auszuwerfen wie der linke</translation>
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
        <source>the solid could not be written</source>
        <translation>der Volumenkörper konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the solid could not be written: %1</source>
        <translation>der Volumenkörper konnte nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; has two files of one phase</source>
        <translation>die Oberfläche „%1“ hat zwei Dateien einer Phase</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; is missing in phase number %2</source>
        <translation>die Oberfläche „%1“ fehlt in der Phase Nummer %2</translation>
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
        <source>every piece of the surface is smaller than the %1 mm that remeshing resolves</source>
        <translation>alle Stücke der Oberfläche sind kleiner als die %1 mm, die beim Neuvernetzen aufgelöst werden</translation>
    </message>
    <message>
        <source>keep the largest piece first</source>
        <translation>behalten Sie zuerst das größte Stück</translation>
    </message>
    <message>
        <source>the surface encloses nothing</source>
        <translation>die Oberfläche umschließt nichts</translation>
    </message>
    <message>
        <source>the surface encloses nothing that witness points could lie in</source>
        <translation>die Oberfläche umschließt nichts, worin Messpunkte liegen könnten</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>die Oberfläche hat %1 brauchbare Dreiecke und umschließt nichts</translation>
    </message>
    <message>
        <source>the surface has no triangles or is flat, so it encloses nothing</source>
        <translation>die Oberfläche hat keine Dreiecke oder ist flach und umschließt daher nichts</translation>
    </message>
    <message>
        <source>the surface has no triangles or no size</source>
        <translation>die Oberfläche hat keine Dreiecke oder keine Ausdehnung</translation>
    </message>
    <message>
        <source>the surface has room for %1 of %2 handles</source>
        <translation>die Oberfläche hat Platz für %1 von %2 Griffen</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres</source>
        <translation>die Größe von %1 mm ist für ein Organ nicht plausibel; als Einheit der Koordinaten werden Millimeter angenommen</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres, they may be in %2</source>
        <translation>die Größe von %1 mm ist für ein Organ nicht plausibel; als Einheit der Koordinaten werden Millimeter angenommen, vielleicht sind es %2</translation>
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
        <source>the surface is open (%n boundary {edge|edges})</source>
        <translation>
            <numerusform>die Oberfläche ist offen (%n Randkante)</numerusform>
            <numerusform>die Oberfläche ist offen (%n Randkanten)</numerusform>
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
        <source>the surface is too large for GLB, which ends at 4 GB</source>
        <translation>die Oberfläche ist zu groß für GLB, das bei 4 GB endet</translation>
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
        <source>the volume at the end of the cycle differs from the volume at its start</source>
        <translation>das Volumen am Ende des Zyklus weicht von dem am Anfang ab</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>das Volumen kann hier nicht gehalten werden: %1</translation>
    </message>
    <message>
        <source>the waves are %1 % as deep as in an adult: %2</source>
        <translation>die Wellen sind %1 % so tief wie bei einem Erwachsenen: %2</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>es gibt %1</translation>
    </message>
    <message>
        <source>there are no tetrahedra in it; the surface may be open</source>
        <translation>es sind keine Tetraeder darin; vielleicht ist die Oberfläche offen</translation>
    </message>
    <message>
        <source>there is no coordinate system &quot;%1&quot;</source>
        <translation>es gibt kein Koordinatensystem „%1“</translation>
    </message>
    <message>
        <source>there is no handle at vertex %1</source>
        <translation>am Eckpunkt %1 ist kein Griff</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>es gibt keine solche Datei und keinen solchen Ordner</translation>
    </message>
    <message>
        <source>there is no surface to write</source>
        <translation>es gibt keine Oberfläche zu schreiben</translation>
    </message>
    <message>
        <source>there is no triangle to write</source>
        <translation>es gibt kein Dreieck zu schreiben</translation>
    </message>
    <message>
        <source>simplifying the surface</source>
        <translation>Vereinfachen der Oberfläche</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>das ist ein Fehler des Programms; bitte melden Sie ihn</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but neither fundus nor pylorus</source>
        <translation>zu wenige Landmarken: %1 ist da, fundus und pylorus fehlen</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but no %2</source>
        <translation>zu wenige Landmarken: %1 ist da, %2 fehlt</translation>
    </message>
    <message>
        <source>too few landmarks: there is right but neither apex nor base</source>
        <translation>zu wenige Landmarken: right ist da, apex und base fehlen</translation>
    </message>
    <message>
        <source>track surfaces that are not within each other one by one</source>
        <translation>verfolgen Sie Oberflächen, die nicht ineinander liegen, einzeln</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>try another resolution</source>
        <translation>versuchen Sie eine andere Auflösung</translation>
    </message>
    <message>
        <source>try another resolution, or a cage without needle-like triangles</source>
        <translation>versuchen Sie eine andere Auflösung oder einen Käfig ohne nadelförmige Dreiecke</translation>
    </message>
    <message>
        <source>turn its triangles around, as viscera convert IN OUT --orient does</source>
        <translation>drehen Sie seine Dreiecke um, etwa mit viscera convert EIN AUS --orient</translation>
    </message>
    <message>
        <source>turn the surface outward, or choose a target above 0 ml</source>
        <translation>drehen Sie die Oberfläche nach außen, oder wählen Sie ein Ziel über 0 ml</translation>
    </message>
    <message>
        <source>turns the surface by a quarter turn, from a model whose y axis points to the head</source>
        <translation>dreht die Oberfläche um eine Vierteldrehung, von einem Modell, dessen y-Achse zum Kopf zeigt</translation>
    </message>
    <message>
        <source>turns the surface by half a turn, as from RAS to LPS</source>
        <translation>dreht die Oberfläche um eine halbe Drehung, wie von RAS nach LPS</translation>
    </message>
    <message>
        <source>turns triangles around so that all of them face outward</source>
        <translation>dreht Dreiecke um, sodass alle nach außen zeigen</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>zwei Gruppen haben diesen Namen</translation>
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
        <source>unsaved work cannot be kept safe: the folder cannot be written to</source>
        <translation>ungespeicherte Arbeit kann nicht gesichert werden: in den Ordner kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>update Viscera</source>
        <translation>aktualisieren Sie Viscera</translation>
    </message>
    <message>
        <source>use .ogv, .mp4, .gif, or a folder for PNG frames</source>
        <translation>verwenden Sie .ogv, .mp4, .gif oder einen Ordner für PNG-Einzelbilder</translation>
    </message>
    <message>
        <source>use images that show all of it in every phase</source>
        <translation>verwenden Sie Bilder, die es in jeder Phase ganz zeigen</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>nehmen Sie eines von: %1</translation>
    </message>
    <message>
        <source>values from the section %1 on were not understood and ignored</source>
        <translation>Werte ab dem Abschnitt %1 wurden nicht verstanden und ignoriert</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
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
        <source>wait until the witness points are computed</source>
        <translation>warten Sie, bis die Messpunkte berechnet sind</translation>
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
        <translation>Welle im Corpus</translation>
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
        <source>stress profile %1</source>
        <translation>Stressprofil %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>Stresssonde</translation>
    </message>
    <message>
        <source>stress profile</source>
        <translation>Stressprofil</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Ein Profil braucht zwei Sonden eines Organs</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Diese beiden Sonden haben schon ein Profil</translation>
    </message>
    <message>
        <source>witness points on a grid</source>
        <translation>Messpunkte auf einem Gitter</translation>
    </message>
    <message>
        <source>women and men have on average %1 to %2 ml</source>
        <translation>Frauen und Männer haben im Mittel %1 bis %2 ml</translation>
    </message>
    <message>
        <source>write an .ogv instead</source>
        <translation>schreiben Sie stattdessen eine .ogv-Datei</translation>
    </message>
    <message>
        <source>write lines of the instant and the volume in ml</source>
        <translation>schreiben Sie Zeilen mit Zeitpunkt und Volumen in ml</translation>
    </message>
    <message>
        <source>write the instant and the volume in ml, as in 0.25,98.5</source>
        <translation>schreiben Sie den Zeitpunkt und das Volumen in ml, wie in 0.25,98.5</translation>
    </message>
    <message>
        <source>write volumes in ml</source>
        <translation>schreiben Sie Volumina in ml</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>Schreiben des Films</translation>
    </message>
    <message>
        <source>the organ has no extent</source>
        <translation>das Organ hat keine Ausdehnung</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right</source>
        <translation>Herz mit %1 ml links und %2 ml rechts</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right, atria with %3 ml left and %4 ml right</source>
        <translation>Herz mit %1 ml links und %2 ml rechts, Vorhöfe mit %3 ml links und %4 ml rechts</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml; atria: left off by %3 ml, right by %4 ml</source>
        <translation>Die Ventrikel lassen sich nicht auf ihre Volumina bringen: links fehlen %1 ml, rechts %2 ml; Vorhöfe: links %3 ml, rechts %4 ml</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml</source>
        <translation>Die Ventrikel lassen sich nicht auf ihre Volumina bringen: links fehlen %1 ml, rechts %2 ml</translation>
    </message>
    <message>
        <source>check that the cavities lie inside the handles of their walls</source>
        <translation>prüfen Sie, ob die Hohlräume innerhalb der Griffe ihrer Wände liegen</translation>
    </message>
    <message>
        <source>a centreline needs at least two points</source>
        <translation>eine Mittellinie braucht mindestens zwei Punkte</translation>
    </message>
    <message>
        <source>centreline point %1</source>
        <translation>Punkt %1 der Mittellinie</translation>
    </message>
    <message>
        <source>the point is not finite</source>
        <translation>der Punkt ist nicht endlich</translation>
    </message>
    <message>
        <source>the point is where the one before it is</source>
        <translation>der Punkt liegt an der Stelle des vorigen</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>entfernen Sie ihn</translation>
    </message>
    <message>
        <source>calibrating the heartbeat</source>
        <translation>Abgleich des Herzschlags</translation>
    </message>
    <message>
        <source>curve key %1</source>
        <translation>Stützpunkt %1 der Kurve</translation>
    </message>
    <message>
        <source>the pylorus does not lie beyond the middle of the body</source>
        <translation>der Pylorus liegt nicht jenseits der Mitte des Corpus</translation>
    </message>
    <message>
        <source>gastric waves</source>
        <translation>Magenwellen</translation>
    </message>
    <message>
        <source>choose the landmarks from the fundus downwards</source>
        <translation>wählen Sie die Landmarken vom Fundus abwärts</translation>
    </message>
    <message>
        <source>the surface has no inside</source>
        <translation>die Oberfläche hat kein Inneres</translation>
    </message>
    <message>
        <source>heart landmarks</source>
        <translation>Landmarken des Herzens</translation>
    </message>
    <message>
        <source>give apex and base yourself</source>
        <translation>geben Sie Spitze und Basis selbst an</translation>
    </message>
    <message>
        <source>the base does not lie inside the heart</source>
        <translation>die Basis liegt nicht im Herzen</translation>
    </message>
    <message>
        <source>put it on the middle of the mitral valve</source>
        <translation>setzen Sie sie auf die Mitte der Mitralklappe</translation>
    </message>
    <message>
        <source>the directions to the right ventricle and to the apex do not span a frame</source>
        <translation>die Richtungen zum rechten Ventrikel und zur Spitze spannen kein Achsenkreuz auf</translation>
    </message>
    <message>
        <source>heart frame</source>
        <translation>Achsenkreuz des Herzens</translation>
    </message>
    <message>
        <source>choose landmarks that do not lie on one line</source>
        <translation>wählen Sie Landmarken, die nicht auf einer Geraden liegen</translation>
    </message>
    <message numerus="yes">
        <source>a ventricle is not where its frame says: only %n {handle meets|handles meet} its wall</source>
        <translation>
            <numerusform>ein Ventrikel liegt nicht, wo sein Achsenkreuz ihn angibt: nur %n Griff trifft seine Wand</numerusform>
            <numerusform>ein Ventrikel liegt nicht, wo sein Achsenkreuz ihn angibt: nur %n Griffe treffen seine Wand</numerusform>
        </translation>
    </message>
    <message>
        <source>heart rig</source>
        <translation>Griffe des Herzens</translation>
    </message>
    <message>
        <source>check the landmarks of base, apex and right ventricle</source>
        <translation>prüfen Sie die Landmarken von Basis, Spitze und rechtem Ventrikel</translation>
    </message>
    <message>
        <source>move it, or lengthen the period</source>
        <translation>verschieben Sie ihn, oder verlängern Sie die Periode</translation>
    </message>
    <message>
        <source>there is no key</source>
        <translation>es gibt kein Schlüsselbild</translation>
    </message>
    <message>
        <source>the heart cannot be brought to the volume that it has to hold</source>
        <translation>das Herz lässt sich nicht auf das Volumen bringen, das es haben muss</translation>
    </message>
    <message>
        <source>heartbeat at %1 s</source>
        <translation>Herzschlag bei %1 s</translation>
    </message>
    <message>
        <source>check the landmarks of apex and base</source>
        <translation>prüfen Sie die Landmarken von Spitze und Basis</translation>
    </message>
    <message>
        <source>the upper stomach cannot take in what the waves press out</source>
        <translation>der obere Magen kann nicht aufnehmen, was die Wellen verdrängen</translation>
    </message>
    <message>
        <source>peristalsis after %1 s</source>
        <translation>Peristaltik nach %1 s</translation>
    </message>
    <message>
        <source>check the landmarks</source>
        <translation>prüfen Sie die Landmarken</translation>
    </message>
    <message>
        <source>the centreline leaves the stomach %1 mm below the top of the fundus</source>
        <translation>die Mittellinie verlässt den Magen %1 mm unter dem Scheitel des Fundus</translation>
    </message>
    <message>
        <source>stomach rig</source>
        <translation>Griffe des Magens</translation>
    </message>
    <message>
        <source>move its points into the stomach</source>
        <translation>verschieben Sie ihre Punkte in den Magen</translation>
    </message>
    <message>
        <source>the centreline ends before the pylorus</source>
        <translation>die Mittellinie endet vor dem Pylorus</translation>
    </message>
    <message>
        <source>lead it into the duodenum</source>
        <translation>führen Sie sie bis ins Duodenum</translation>
    </message>
    <message numerus="yes">
        <source>Only %n {vertex|vertices} of the surface {lies|lie} there</source>
        <translation>
            <numerusform>Nur %n Eckpunkt der Oberfläche liegt dort</numerusform>
            <numerusform>Nur %n Eckpunkte der Oberfläche liegen dort</numerusform>
        </translation>
    </message>
    <message>
        <source>take a finer surface</source>
        <translation>nehmen Sie eine feinere Oberfläche</translation>
    </message>
    <message>
        <source>base of the left ventricle</source>
        <translation>Basis des linken Ventrikels</translation>
    </message>
    <message>
        <source>apex of the left ventricle</source>
        <translation>Spitze des linken Ventrikels</translation>
    </message>
    <message>
        <source>base of the right ventricle</source>
        <translation>Basis des rechten Ventrikels</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, inside</source>
        <translation>freie Wand des linken Ventrikels, innen</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, outside</source>
        <translation>freie Wand des linken Ventrikels, außen</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus towards the apex</source>
        <translation>Bewegung des Mitralrings zur Spitze</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus at the free wall</source>
        <translation>Bewegung des Trikuspidalrings an der freien Wand</translation>
    </message>
    <message>
        <source>turn of the apex against the base</source>
        <translation>Drehung der Spitze gegen die Basis</translation>
    </message>
    <message>
        <source>of the left ventricle's free wall in systole</source>
        <translation>der freien Wand des linken Ventrikels in der Systole</translation>
    </message>
    <message>
        <source>effective areas of normal valves: doi 10.1016/j.echo.2017.02.009</source>
        <translation>effektive Öffnungsflächen normaler Klappen: doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.1 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>eine leichte Regurgitation liegt unter 0,1 cm²: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.2 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>eine leichte Regurgitation liegt unter 0,2 cm²: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>20 % around the healthy adult at rest</source>
        <translation>20 % um den gesunden Erwachsenen in Ruhe</translation>
    </message>
    <message>
        <source>sinus rhythm at rest</source>
        <translation>Sinusrhythmus in Ruhe</translation>
    </message>
    <message>
        <source>800 to 1600 dyn s cm^-5, customary at the bedside</source>
        <translation>800 bis 1600 dyn s cm^-5, klinisch üblich</translation>
    </message>
    <message>
        <source>up to 2 Wood units</source>
        <translation>bis 2 Wood-Einheiten</translation>
    </message>
    <message>
        <source>the amount in a healthy heart</source>
        <translation>die Menge in einem gesunden Herzen</translation>
    </message>
    <message>
        <source>%1 is out of its range</source>
        <translation>%1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>from %1 to %2 %3</source>
        <translation>von %1 bis %2 %3</translation>
    </message>
    <message>
        <source>the leak area must be smaller than the area of the open valve</source>
        <translation>die Leckfläche muss kleiner sein als die Fläche der offenen Klappe</translation>
    </message>
    <message>
        <source>choose a %1 below its %2</source>
        <translation>wählen Sie %1 kleiner als %2</translation>
    </message>
    <message>
        <source>%1 lies between %2 and %3</source>
        <translation>%1 liegt zwischen %2 und %3</translation>
    </message>
    <message>
        <source>An end-diastolic volume in ml</source>
        <translation>Ein enddiastolisches Volumen in ml</translation>
    </message>
    <message>
        <source>give the largest volume of the left ventricle</source>
        <translation>geben Sie das größte Volumen des linken Ventrikels an</translation>
    </message>
    <message>
        <source>An ejection fraction</source>
        <translation>Eine Ejektionsfraktion</translation>
    </message>
    <message>
        <source>give 55 % as 0.55</source>
        <translation>geben Sie 55 % als 0,55 an</translation>
    </message>
    <message>
        <source>A mean aortic pressure in mmHg</source>
        <translation>Ein mittlerer Aortendruck in mmHg</translation>
    </message>
    <message>
        <source>about a third of the way from the diastolic to the systolic one</source>
        <translation>etwa ein Drittel des Weges vom diastolischen zum systolischen</translation>
    </message>
    <message>
        <source>fitting the circulation</source>
        <translation>Anpassung des Kreislaufs</translation>
    </message>
    <message>
        <source>the circulation of that heart</source>
        <translation>der Kreislauf dieses Herzens</translation>
    </message>
    <message>
        <source>The circulation has the measured ventricle: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>Der Kreislauf hat den gemessenen Ventrikel: %1 ml, Ejektionsfraktion %2, mittlerer Aortendruck %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>Kein Kreislauf hat genau diesen Ventrikel; der nächste gefundene: %1 ml, Ejektionsfraktion %2, mittlerer Aortendruck %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg; at the limit of its range: %4</source>
        <translation>Kein Kreislauf hat genau diesen Ventrikel; der nächste gefundene: %1 ml, Ejektionsfraktion %2, mittlerer Aortendruck %3 mmHg; an der Grenze des Bereichs: %4</translation>
    </message>
    <message>
        <source>the circulation to start with</source>
        <translation>der Kreislauf zu Beginn</translation>
    </message>
    <message numerus="yes">
        <source>After %n {beat|beats} the volumes still change by %2 ml from beat to beat: strong and weak beats alternate, or the circulation fails; try a lower rate or a larger stressed volume</source>
        <translation>
            <numerusform>Nach %n Schlag ändern sich die Volumina noch um %2 ml von Schlag zu Schlag: starke und schwache Schläge wechseln sich ab, oder der Kreislauf versagt; versuchen Sie eine niedrigere Frequenz oder ein größeres Blutvolumen unter Spannung</numerusform>
            <numerusform>Nach %n Schlägen ändern sich die Volumina noch um %2 ml von Schlag zu Schlag: starke und schwache Schläge wechseln sich ab, oder der Kreislauf versagt; versuchen Sie eine niedrigere Frequenz oder ein größeres Blutvolumen unter Spannung</numerusform>
        </translation>
    </message>
    <message>
        <source>the circulation breaks down: its pressures grow without bounds</source>
        <translation>der Kreislauf bricht zusammen: seine Drücke wachsen unbegrenzt</translation>
    </message>
    <message>
        <source>beat %1</source>
        <translation>Schlag %1</translation>
    </message>
    <message>
        <source>bring the parameters nearer to those at rest, a few at a time</source>
        <translation>bringen Sie die Parameter näher an die in Ruhe, wenige auf einmal</translation>
    </message>
    <message>
        <source>fitting phase %1</source>
        <translation>Anpassung von Phase %1</translation>
    </message>
    <message>
        <source>smoothing phase %1</source>
        <translation>Glättung von Phase %1</translation>
    </message>
    <message>
        <source>%1 is %2 mm away on average</source>
        <translation>%1 liegt im Mittel %2 mm entfernt</translation>
    </message>
    <message>
        <source>a twentieth of %1 is more than %2 mm away</source>
        <translation>ein Zwanzigstel von %1 liegt mehr als %2 mm entfernt</translation>
    </message>
    <message>
        <source>%1 had to be changed by %2 % to get its volume</source>
        <translation>%1 musste um %2 % geändert werden, um sein Volumen zu erhalten</translation>
    </message>
    <message>
        <source>%1 agrees with its voxels by a Dice of %2 only</source>
        <translation>%1 stimmt mit seinen Voxeln nur zu einem Dice von %2 überein</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} of %2 {is|are} turned over</source>
        <translation>
            <numerusform>%n Dreieck von %2 ist umgeklappt</numerusform>
            <numerusform>%n Dreiecke von %2 sind umgeklappt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the tissue is folded at %n {place|places}</source>
        <translation>
            <numerusform>das Gewebe ist an %n Stelle gefaltet</numerusform>
            <numerusform>das Gewebe ist an %n Stellen gefaltet</numerusform>
        </translation>
    </message>
    <message>
        <source>the measured volumes cannot be met</source>
        <translation>die gemessenen Volumina sind nicht erreichbar</translation>
    </message>
    <message numerus="yes">
        <source>%2 handles are too few for %n {surface|surfaces}</source>
        <translation>
            <numerusform>%2 Griffe sind zu wenige für %n Oberfläche</numerusform>
            <numerusform>%2 Griffe sind zu wenige für %n Oberflächen</numerusform>
        </translation>
    </message>
    <message>
        <source>ask for fewer</source>
        <translation>verlangen Sie weniger</translation>
    </message>
    <message>
        <source>keeping volumes</source>
        <translation>Volumina werden gehalten</translation>
    </message>
    <message>
        <source>Phase %1 has %2 points and the first has %3</source>
        <translation>Phase %1 hat %2 Punkte und die erste %3</translation>
    </message>
    <message>
        <source>export all phases with the same triangles</source>
        <translation>exportieren Sie alle Phasen mit denselben Dreiecken</translation>
    </message>
    <message>
        <source>%1, phase %2</source>
        <translation>%1, Phase %2</translation>
    </message>
    <message>
        <source>It has no triangle with three different corners</source>
        <translation>Sie hat kein Dreieck mit drei verschiedenen Ecken</translation>
    </message>
    <message>
        <source>It is not a closed surface, even with its holes filled: %1</source>
        <translation>Die Oberfläche ist auch mit gefüllten Löchern nicht geschlossen: %1</translation>
    </message>
    <message>
        <source>repair the surfaces in the program that made them</source>
        <translation>reparieren Sie die Oberflächen in dem Programm, das sie erzeugt hat</translation>
    </message>
    <message>
        <source>the volume cannot be kept throughout the cycle: %1</source>
        <translation>das Volumen lässt sich nicht über den ganzen Zyklus halten: %1</translation>
    </message>
    <message>
        <source>unlock it, or prescribe a volume nearer to that at rest</source>
        <translation>entsperren Sie es, oder geben Sie ein Volumen näher an dem in Ruhe vor</translation>
    </message>
    <message>
        <source>No organ is shown</source>
        <translation>Es wird kein Organ gezeigt</translation>
    </message>
    <message>
        <source>the lesson</source>
        <translation>die Lektion</translation>
    </message>
    <message>
        <source>show those that the lesson is about</source>
        <translation>zeigen Sie die, von denen die Lektion handelt</translation>
    </message>
    <message>
        <source>check the size of the organ, and its motion</source>
        <translation>prüfen Sie die Größe des Organs und seine Bewegung</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; returned no binding of the right size</source>
        <translation>das System „%1“ lieferte keine Bindung der richtigen Größe</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed: %2</source>
        <translation>das System „%1“ ist fehlgeschlagen: %2</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed</source>
        <translation>das System „%1“ ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>choose another system</source>
        <translation>wählen Sie ein anderes System</translation>
    </message>
    <message>
        <source>it was made for version %1 of the plugin interface, this program has %2</source>
        <translation>es wurde für Version %1 der Plugin-Schnittstelle gemacht, dieses Programm hat %2</translation>
    </message>
    <message>
        <source>plugin %1: %2</source>
        <translation>Plugin %1: %2</translation>
    </message>
    <message>
        <source>There is already a coordinate system &quot;%1&quot; (%2)</source>
        <translation>Es gibt schon ein Koordinatensystem „%1“ (%2)</translation>
    </message>
    <message>
        <source>remove one of the two, or give one another id</source>
        <translation>entfernen Sie eines der beiden, oder geben Sie einem eine andere ID</translation>
    </message>
    <message>
        <source>There is no coordinate system &quot;%1&quot;</source>
        <translation>Das Koordinatensystem „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>none is loaded</source>
        <translation>keines ist geladen</translation>
    </message>
    <message>
        <source>none: the organs are as in their files</source>
        <translation>keine: die Organe sind wie in ihren Dateien</translation>
    </message>
    <message>
        <source>in %1 groups</source>
        <translation>in %1 Gruppen</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>%1 of them moved</source>
        <translation>davon %1 bewegt</translation>
    </message>
    <message>
        <source>%1 of them shown</source>
        <translation>davon %1 gezeigt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Instant</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>%1, at %2 of its cycle</source>
        <translation>%1, bei %2 des Zyklus</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(ausgeblendet)</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>Rest shape (ml)</source>
        <translation>Ruheform (ml)</translation>
    </message>
    <message>
        <source>Now (ml)</source>
        <translation>Jetzt (ml)</translation>
    </message>
    <message>
        <source>Change (ml)</source>
        <translation>Änderung (ml)</translation>
    </message>
    <message>
        <source>Change (%)</source>
        <translation>Änderung (%)</translation>
    </message>
    <message>
        <source>Surface (cm²)</source>
        <translation>Oberfläche (cm²)</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumina</translation>
    </message>
    <message>
        <source>Open: the surface has holes and holds no volume.</source>
        <translation>Offen: Die Oberfläche hat Löcher und umschließt kein Volumen.</translation>
    </message>
    <message>
        <source>mean in a rectangle</source>
        <translation>Mittel in einem Rechteck</translation>
    </message>
    <message>
        <source>mean in a sphere</source>
        <translation>Mittel in einer Kugel</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Gemessen an</translation>
    </message>
    <message>
        <source>Rest shape</source>
        <translation>Ruheform</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>the scan</source>
        <translation>dem Scan</translation>
    </message>
    <message>
        <source>sample organ &quot;%1&quot;, %2 resolution</source>
        <translation>Beispielorgan „%1“, %2 Auflösung</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrige</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittlere</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hohe</translation>
    </message>
    <message>
        <source>made in the program</source>
        <translation>im Programm erzeugt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Findings and repairs</source>
        <translation>Befunde und Reparaturen</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Files and what was done to them</source>
        <translation>Dateien und was mit ihnen getan wurde</translation>
    </message>
    <message>
        <source>All lengths are in millimetres, all volumes in millilitres; positions are in the patient's axes LPS (to the left, to the back, to the head). Viscera is a program for teaching and research, not a medical device.</source>
        <translation>Alle Längen sind in Millimetern, alle Volumina in Millilitern; Positionen sind in den Achsen LPS des Patienten (nach links, nach hinten, zum Kopf). Viscera ist ein Programm für Lehre und Forschung, kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>There is no organ to report on</source>
        <translation>Es gibt kein Organ, über das berichtet werden kann</translation>
    </message>
    <message>
        <source>Made by Viscera %1 on %2</source>
        <translation>Erstellt von Viscera %1 am %2</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>going through the cycle</source>
        <translation>Durchlauf des Zyklus</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volumen (ml)</translation>
    </message>
    <message>
        <source>Volumes over one cycle, each instant computed</source>
        <translation>Volumina über einen Zyklus, jeder Zeitpunkt berechnet</translation>
    </message>
    <message>
        <source>the first %1 of %2 organs</source>
        <translation>die ersten %1 von %2 Organen</translation>
    </message>
    <message>
        <source>Smallest (ml)</source>
        <translation>Kleinstes (ml)</translation>
    </message>
    <message>
        <source>Largest (ml)</source>
        <translation>Größtes (ml)</translation>
    </message>
    <message>
        <source>Ventricle</source>
        <translation>Ventrikel</translation>
    </message>
    <message>
        <source>EDV (ml)</source>
        <translation>EDV (ml)</translation>
    </message>
    <message>
        <source>ESV (ml)</source>
        <translation>ESV (ml)</translation>
    </message>
    <message>
        <source>Stroke volume (ml)</source>
        <translation>Schlagvolumen (ml)</translation>
    </message>
    <message>
        <source>EF (%)</source>
        <translation>EF (%)</translation>
    </message>
    <message>
        <source>EF of healthy people</source>
        <translation>EF von Gesunden</translation>
    </message>
    <message>
        <source>Output (l/min)</source>
        <translation>Herzminutenvolumen (l/min)</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>%1 a minute, one cycle takes %2 s</source>
        <translation>%1 pro Minute, ein Zyklus dauert %2 s</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phasen</translation>
    </message>
    <message>
        <source>Prescribed</source>
        <translation>Vorgegeben</translation>
    </message>
    <message>
        <source>the volume of %1</source>
        <translation>das Volumen von %1</translation>
    </message>
    <message>
        <source>A volume could not be kept: %1</source>
        <translation>Ein Volumen ließ sich nicht halten: %1</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>The map as the session shows it</source>
        <translation>Die Karte, wie die Sitzung sie zeigt</translation>
    </message>
    <message>
        <source>There is no font to write with</source>
        <translation>Es gibt keine Schrift zum Schreiben</translation>
    </message>
    <message>
        <source>install one, such as the package fonts-dejavu-core</source>
        <translation>installieren Sie eine, etwa das Paket fonts-dejavu-core</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>A report cannot be written to this kind of file</source>
        <translation>In diese Art von Datei lässt sich kein Bericht schreiben</translation>
    </message>
    <message>
        <source>let it end in .pdf or .html</source>
        <translation>lassen Sie sie auf .pdf oder .html enden</translation>
    </message>
    <message>
        <source>by TetGen</source>
        <translation>von TetGen</translation>
    </message>
    <message>
        <source>by TetGen, from a repaired copy of the surface</source>
        <translation>von TetGen, aus einer reparierten Kopie der Oberfläche</translation>
    </message>
    <message>
        <source>by a regular grid</source>
        <translation>von einem regelmäßigen Gitter</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>5th percentile</source>
        <translation>5. Perzentil</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95. Perzentil</translation>
    </message>
    <message>
        <source>%1, extreme over a cycle</source>
        <translation>%1, Extremwert eines Zyklus</translation>
    </message>
    <message>
        <source>Points (%)</source>
        <translation>Punkte (%)</translation>
    </message>
    <message>
        <source>%1 over the witness points</source>
        <translation>%1 über die Messpunkte</translation>
    </message>
    <message>
        <source>Rotational stress (deg)</source>
        <translation>Rotationsstress (Grad)</translation>
    </message>
    <message>
        <source>Over one cycle of the sequence</source>
        <translation>Über einen Zyklus der Sequenz</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Place (mm)</source>
        <translation>Ort (mm)</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>kein Gewebe</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>gefaltet</translation>
    </message>
    <message>
        <source>Distance at rest (mm)</source>
        <translation>Abstand in Ruhe (mm)</translation>
    </message>
    <message>
        <source>Along the straight lines at rest between probes</source>
        <translation>Entlang der in Ruhe geraden Linien zwischen Sonden</translation>
    </message>
    <message>
        <source>Tissue distortion (rotational stress)</source>
        <translation>Verzerrung des Gewebes (Rotationsstress)</translation>
    </message>
    <message>
        <source>Witness points</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>%1 in %2 tetrahedra</source>
        <translation>%1 in %2 Tetraedern</translation>
    </message>
    <message>
        <source>Derivatives</source>
        <translation>Ableitungen</translation>
    </message>
    <message>
        <source>in closed form (analytic)</source>
        <translation>in geschlossener Form (analytisch)</translation>
    </message>
    <message>
        <source>by central differences</source>
        <translation>durch zentrale Differenzen</translation>
    </message>
    <message>
        <source>no point: the tissue is turned inside out nowhere</source>
        <translation>kein Punkt: das Gewebe ist nirgends umgestülpt</translation>
    </message>
    <message>
        <source>%1 of %2 points are turned inside out</source>
        <translation>%1 von %2 Punkten sind umgestülpt</translation>
    </message>
    <message>
        <source>Rotational stress is the largest angle by which a direction is turned when the tissue is stretched. It measures distortion and is not a pressure.</source>
        <translation>Rotationsstress ist der größte Winkel, um den eine Richtung gedreht wird, wenn das Gewebe gedehnt wird. Er misst Verzerrung und ist kein Druck.</translation>
    </message>
    <message>
        <source>± %1, %2 to %3, %4, %5 voxels</source>
        <translation>± %1; %2 bis %3; %4; %5 Voxel</translation>
    </message>
    <message>
        <source>The view cannot be restored completely</source>
        <translation>Die Ansicht lässt sich nicht vollständig wiederherstellen</translation>
    </message>
    <message>
        <source>the session's view</source>
        <translation>die Ansicht der Sitzung</translation>
    </message>
    <message>
        <source>the organs and the handles are complete; save the session anew</source>
        <translation>Organe und Griffe sind vollständig; speichern Sie die Sitzung neu</translation>
    </message>
    <message>
        <source>women</source>
        <translation>Frauen</translation>
    </message>
    <message>
        <source>men</source>
        <translation>Männer</translation>
    </message>
    <message>
        <source>women and men</source>
        <translation>Frauen und Männer</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations</source>
        <translation>%1, Mittel ± 2 Standardabweichungen</translation>
    </message>
    <message>
        <source>%1, on average</source>
        <translation>%1, im Mittel</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations, for %2 m2 of body surface</source>
        <translation>%1, Mittel ± 2 Standardabweichungen, für %2 m² Körperoberfläche</translation>
    </message>
    <message>
        <source>%1, on average, for %2 m2 of body surface</source>
        <translation>%1, im Mittel, für %2 m² Körperoberfläche</translation>
    </message>
    <message>
        <source>800 healthy people of 45 to 74 years, by magnetic resonance, papillary muscles counted as cavity</source>
        <translation>800 Gesunde von 45 bis 74 Jahren, mit Magnetresonanz, Papillarmuskeln zur Höhle gezählt</translation>
    </message>
    <message>
        <source>ICRP publication 89, doi 10.1016/S0146-6453(03)00002-2</source>
        <translation>ICRP-Publikation 89, doi 10.1016/S0146-6453(03)00002-2</translation>
    </message>
    <message>
        <source>1815 people without kidney disease, by magnetic resonance; the deviation is that of the quartiles</source>
        <translation>1815 Menschen ohne Nierenkrankheit, mit Magnetresonanz; die Abweichung ist die der Quartile</translation>
    </message>
    <message>
        <source>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (spread), and &quot;Simplifying the measurement of gastric accommodation using SPECT&quot; (mean)</source>
        <translation>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (Streuung), und „Simplifying the measurement of gastric accommodation using SPECT“ (Mittelwert)</translation>
    </message>
    <message>
        <source>customary at the bedside</source>
        <translation>klinisch üblich</translation>
    </message>
    <message>
        <source>Whelton 2018, doi 10.1161/HYP.0000000000000065: normal is below 120/80; the lower bound is customary</source>
        <translation>Whelton 2018, doi 10.1161/HYP.0000000000000065: normal ist unter 120/80; die untere Grenze ist die klinisch übliche</translation>
    </message>
    <message>
        <source>mass of the muscle</source>
        <translation>Masse des Muskels</translation>
    </message>
    <message>
        <source>1969 healthy people at rest, by tissue Doppler</source>
        <translation>1969 Gesunde in Ruhe, mit Gewebedoppler</translation>
    </message>
    <message>
        <source>ejection time</source>
        <translation>Austreibungszeit</translation>
    </message>
    <message>
        <source>healthy adults, by magnetic resonance and ultrasound</source>
        <translation>gesunde Erwachsene, mit Magnetresonanz und Ultraschall</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus (MAPSE)</source>
        <translation>Bewegung des Mitralrings (MAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 16.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); ultrasound finds less, 12 to 15 mm</source>
        <translation>Magnetresonanz: 16,4 mm (Carlsson und andere 2007, doi 10.1152/ajpheart.01376.2006); Ultraschall findet weniger, 12 bis 15 mm</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus (TAPSE)</source>
        <translation>Bewegung des Trikuspidalrings (TAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 23.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); below 17 mm is abnormal in ultrasound (Lang and others 2015, doi 10.1016/j.echo.2014.10.003)</source>
        <translation>Magnetresonanz: 23,4 mm (Carlsson und andere 2007, doi 10.1152/ajpheart.01376.2006); im Ultraschall sind weniger als 17 mm nicht normal (Lang und andere 2015, doi 10.1016/j.echo.2014.10.003)</translation>
    </message>
    <message>
        <source>twist of the apex against the base</source>
        <translation>Drehung der Spitze gegen die Basis</translation>
    </message>
    <message>
        <source>magnetic resonance: apex about 10, base about 3 degrees the other way (Young and Cowan 2012, doi 10.1186/1532-429X-14-49)</source>
        <translation>Magnetresonanz: Spitze etwa 10 Grad, Basis etwa 3 Grad in Gegenrichtung (Young und Cowan 2012, doi 10.1186/1532-429X-14-49)</translation>
    </message>
    <message>
        <source>thickening of the free wall</source>
        <translation>Verdickung der freien Wand</translation>
    </message>
    <message>
        <source>magnetic resonance: 4.4 +- 1.4 mm in the middle slices (Ubachs and others 2009, doi 10.1186/1532-429X-11-S1-P61)</source>
        <translation>Magnetresonanz: 4,4 ± 1,4 mm in den mittleren Schichten (Ubachs und andere 2009, doi 10.1186/1532-429X-11-S1-P61)</translation>
    </message>
    <message>
        <source>healthy adults at rest</source>
        <translation>gesunde Erwachsene in Ruhe</translation>
    </message>
    <message>
        <source>systolic pressure</source>
        <translation>systolischer Druck</translation>
    </message>
    <message>
        <source>diastolic pressure</source>
        <translation>diastolischer Druck</translation>
    </message>
    <message>
        <source>mean pressure</source>
        <translation>mittlerer Druck</translation>
    </message>
    <message>
        <source>end-diastolic pressure</source>
        <translation>enddiastolischer Druck</translation>
    </message>
    <message>
        <source>fastest rise of pressure</source>
        <translation>schnellster Druckanstieg</translation>
    </message>
    <message>
        <source>coupling Ea/Ees</source>
        <translation>Kopplung Ea/Ees</translation>
    </message>
    <message>
        <source>mean gradient</source>
        <translation>mittlerer Gradient</translation>
    </message>
    <message>
        <source>regurgitant fraction</source>
        <translation>Regurgitationsfraktion</translation>
    </message>
    <message>
        <source>Kovacs 2009, doi 10.1183/09031936.00145608: mean +- 2 standard deviations</source>
        <translation>Kovacs 2009, doi 10.1183/09031936.00145608: Mittel ± 2 Standardabweichungen</translation>
    </message>
    <message>
        <source>between the most efficient (0.5) and the most powerful coupling (1): Burkhoff and Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</source>
        <translation>zwischen der effizientesten (0,5) und der leistungsstärksten Kopplung (1): Burkhoff und Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</translation>
    </message>
    <message>
        <source>reference woman and man; no spread is given</source>
        <translation>Referenzfrau und Referenzmann; eine Streuung ist nicht angegeben</translation>
    </message>
    <message>
        <source>1248 people without liver disease, by magnetic resonance</source>
        <translation>1248 Menschen ohne Leberkrankheit, mit Magnetresonanz</translation>
    </message>
    <message>
        <source>212 adults, by CT</source>
        <translation>212 Erwachsene, mit CT</translation>
    </message>
    <message>
        <source>adults of 20 to 60 years, by CT</source>
        <translation>Erwachsene von 20 bis 60 Jahren, mit CT</translation>
    </message>
    <message>
        <source>contents after a meal</source>
        <translation>Inhalt nach einer Mahlzeit</translation>
    </message>
    <message>
        <source>443 people after a meal, by single-photon tomography</source>
        <translation>443 Menschen nach einer Mahlzeit, mit Einzelphotonentomographie</translation>
    </message>
    <message>
        <source>contents of 443 people after a meal, by single-photon tomography, and 138 ml of wall (ICRP publication 89)</source>
        <translation>Inhalt bei 443 Menschen nach einer Mahlzeit, mit Einzelphotonentomographie, und 138 ml Wand (ICRP-Publikation 89)</translation>
    </message>
    <message>
        <source>adults, by electrogastrography</source>
        <translation>Erwachsene, mit Elektrogastrographie</translation>
    </message>
    <message>
        <source>Yin and Chen 2013, doi 10.5056/jnm.2013.19.1.5</source>
        <translation>Yin und Chen 2013, doi 10.5056/jnm.2013.19.1.5</translation>
    </message>
    <message>
        <source>speed of the waves</source>
        <translation>Geschwindigkeit der Wellen</translation>
    </message>
    <message>
        <source>occlusion of the antrum by a wave</source>
        <translation>Verschluss des Antrums durch eine Welle</translation>
    </message>
    <message>
        <source>28 healthy people, by magnetic resonance</source>
        <translation>28 Gesunde, mit Magnetresonanz</translation>
    </message>
    <message>
        <source>adults at rest</source>
        <translation>Erwachsene in Ruhe</translation>
    </message>
    <message>
        <source>part that is inspiration</source>
        <translation>Anteil der Inspiration</translation>
    </message>
    <message>
        <source>adults at rest, from 1 : 2 to 1 : 1</source>
        <translation>Erwachsene in Ruhe, von 1 : 2 bis 1 : 1</translation>
    </message>
    <message>
        <source>way down in quiet breathing</source>
        <translation>Weg nach unten bei ruhiger Atmung</translation>
    </message>
    <message>
        <source>what several studies measured</source>
        <translation>was mehrere Studien gemessen haben</translation>
    </message>
    <message>
        <source>there are no handles to save</source>
        <translation>es gibt keine Griffe zu speichern</translation>
    </message>
    <message>
        <source>There is no scan to export</source>
        <translation>Es gibt keinen Scan zu exportieren</translation>
    </message>
    <message>
        <source>There are no handles that could warp the scan</source>
        <translation>Es gibt keine Griffe, die den Scan verformen könnten</translation>
    </message>
    <message>
        <source>Writing the scan</source>
        <translation>Scan wird geschrieben</translation>
    </message>
    <message>
        <source>9 healthy people, by magnetic resonance; 28 people of doi 10.1046/j.1365-2982.2001.00285.x have 1.6 +- 0.2</source>
        <translation>9 Gesunde, mit Magnetresonanz; 28 Menschen in doi 10.1046/j.1365-2982.2001.00285.x haben 1,6 ± 0,2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>ab %1</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>the sample organs cannot be listed: %1</source>
        <translation>die Beispielorgane lassen sich nicht auflisten: %1</translation>
    </message>
    <message>
        <source>set VISCERA_SAMPLE_ORGANS to the folder of the definitions</source>
        <translation>setzen Sie VISCERA_SAMPLE_ORGANS auf den Ordner der Definitionen</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Die Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>its segment %1 has no valid value or layer</source>
        <translation>ihr Segment %1 hat keinen gültigen Wert oder keine gültige Lage</translation>
    </message>
    <message>
        <source>the table of names in it cannot be read</source>
        <translation>die Namenstabelle darin kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>its voxels are no plain numbers (%1)</source>
        <translation>ihre Voxel sind keine einfachen Zahlen (%1)</translation>
    </message>
    <message>
        <source>It is not a surface</source>
        <translation>Es ist keine Oberfläche</translation>
    </message>
    <message>
        <source>It is not a label map</source>
        <translation>Es ist keine Labelmap</translation>
    </message>
    <message>
        <source>an archive</source>
        <translation>ein Archiv</translation>
    </message>
    <message>
        <source>a CAD model</source>
        <translation>ein CAD-Modell</translation>
    </message>
    <message>
        <source>a scene of a 3D program</source>
        <translation>eine Szene eines 3D-Programms</translation>
    </message>
    <message>
        <source>a scene of 3D Slicer</source>
        <translation>eine Szene von 3D Slicer</translation>
    </message>
    <message>
        <source>a document</source>
        <translation>ein Dokument</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>export it as STL, OBJ, PLY or GLB</source>
        <translation>exportieren Sie es als STL, OBJ, PLY oder GLB</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>entpacken Sie es zuerst</translation>
    </message>
    <message>
        <source>open the images that it was made from: a DICOM series, NIfTI, NRRD or MetaImage</source>
        <translation>öffnen Sie die Bilder, aus denen es entstand: eine DICOM-Serie, NIfTI, NRRD oder MetaImage</translation>
    </message>
    <message>
        <source>save its surface as .vtp, or its image as .mha, in ParaView or 3D Slicer</source>
        <translation>speichern Sie seine Oberfläche als .vtp oder sein Bild als .mha, in ParaView oder 3D Slicer</translation>
    </message>
    <message>
        <source>open a file of organs, handles or a sequence</source>
        <translation>öffnen Sie eine Datei mit Organen, Griffen oder einer Sequenz</translation>
    </message>
    <message>
        <source>save its segmentation and its models in 3D Slicer, and open these</source>
        <translation>speichern Sie seine Segmentierung und seine Modelle in 3D Slicer und öffnen Sie diese</translation>
    </message>
    <message>
        <source>open the files of the organs</source>
        <translation>öffnen Sie die Dateien der Organe</translation>
    </message>
    <message>
        <source>divide its polygons into triangles in the program that made it, and export it again</source>
        <translation>teilen Sie ihre Vielecke in dem Programm, das sie erzeugt hat, in Dreiecke, und exportieren Sie sie erneut</translation>
    </message>
    <message numerus="yes">
        <source>%n {polygon that is not flat was|polygons that are not flat were} cut into triangles that overlap</source>
        <translation>
            <numerusform>%n Vieleck, das nicht eben ist, wurde in Dreiecke geteilt, die sich überlappen</numerusform>
            <numerusform>%n Vielecke, die nicht eben sind, wurden in Dreiecke geteilt, die sich überlappen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face|faces} of fewer than three corners left out</source>
        <translation>
            <numerusform>%n Fläche mit weniger als drei Ecken weggelassen</numerusform>
            <numerusform>%n Flächen mit weniger als drei Ecken weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>the colours in %1 are missing: %2</source>
        <translation>die Farben in %1 fehlen: %2</translation>
    </message>
    <message>
        <source>Its geometry is compressed (%1), which Viscera does not read</source>
        <translation>Ihre Geometrie ist komprimiert (%1), was Viscera nicht liest</translation>
    </message>
    <message>
        <source>export it without compression (in Blender: leave out Data &gt; Compression), or as STL or PLY</source>
        <translation>exportieren Sie sie ohne Kompression (in Blender: ohne Data &gt; Compression) oder als STL oder PLY</translation>
    </message>
    <message>
        <source>save the surfaces as .vtp</source>
        <translation>speichern Sie die Oberflächen als .vtp</translation>
    </message>
    <message>
        <source>It names no surface files</source>
        <translation>Sie nennt keine Oberflächendateien</translation>
    </message>
    <message numerus="yes">
        <source>%n {block|blocks} without a surface ignored</source>
        <translation>
            <numerusform>%n Block ohne Oberfläche ignoriert</numerusform>
            <numerusform>%n Blöcke ohne Oberfläche ignoriert</numerusform>
        </translation>
    </message>
    <message>
        <source>a block is at %1, but only files beside it are read</source>
        <translation>ein Block liegt bei %1, aber nur Dateien neben ihr werden gelesen</translation>
    </message>
    <message>
        <source>the block %1 is no surface and was left out</source>
        <translation>der Block %1 ist keine Oberfläche und wurde weggelassen</translation>
    </message>
    <message>
        <source>its block %1 holds blocks of its own in another file</source>
        <translation>ihr Block %1 enthält selbst Blöcke in einer anderen Datei</translation>
    </message>
    <message>
        <source>its block %1 cannot be read: %2</source>
        <translation>ihr Block %1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message numerus="yes">
        <source>%n {open part|open parts} that share points were joined to one organ: %2</source>
        <translation>
            <numerusform>%n offener Teil mit gemeinsamen Punkten wurden zu einem Organ verbunden: %2</numerusform>
            <numerusform>%n offene Teile mit gemeinsamen Punkten wurden zu einem Organ verbunden: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It holds %n {organ|organs}: %2</source>
        <translation>
            <numerusform>Sie enthält %n Organ: %2</numerusform>
            <numerusform>Sie enthält %n Organe: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>name one of them behind a slash: %1</source>
        <translation>nennen Sie eines davon hinter einem Schrägstrich: %1</translation>
    </message>
    <message>
        <source>%1 lies inside %2, whose volume contains its volume</source>
        <translation>%1 liegt in %2; das größere Volumen enthält das kleinere</translation>
    </message>
    <message>
        <source>the commas in its numbers may be decimal marks or separate thousands or numbers</source>
        <translation>die Kommas in ihren Zahlen können Dezimalzeichen sein oder Tausender oder Zahlen trennen</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>exportieren Sie sie mit Dezimalpunkten</translation>
    </message>
    <message>
        <source>the commas in its numbers were read as decimal marks</source>
        <translation>die Kommas in ihren Zahlen wurden als Dezimalzeichen gelesen</translation>
    </message>
    <message>
        <source>It holds several organs</source>
        <translation>Sie enthält mehrere Organe</translation>
    </message>
    <message>
        <source>its voxels are in another folder (%1)</source>
        <translation>ihre Voxel liegen in einem anderen Ordner (%1)</translation>
    </message>
    <message>
        <source>it is an Analyze 7.5 image, which does not say where it lies: its axes are taken as %1, and left and right may be exchanged</source>
        <translation>es ist ein Bild im Format Analyze 7.5, das seine Lage nicht angibt: Seine Achsen gelten als %1, und links und rechts können vertauscht sein</translation>
    </message>
    <message>
        <source>it does not say where it lies; coronal slices of 1 mm are assumed, as FreeSurfer does</source>
        <translation>sie gibt ihre Lage nicht an; angenommen werden koronale Schichten von 1 mm, wie FreeSurfer es tut</translation>
    </message>
    <message>
        <source>one of its labels in group %1 has no valid number or image</source>
        <translation>eines ihrer Labels in Gruppe %1 hat keine gültige Nummer oder kein Bild</translation>
    </message>
    <message>
        <source>its values are not exactly whole numbers; they were rounded to labels, by at most %1</source>
        <translation>ihre Werte sind keine genauen ganzen Zahlen; sie wurden zu Labels gerundet, um höchstens %1</translation>
    </message>
    <message>
        <source>It has %1 label maps over time, of which one is needed here</source>
        <translation>Sie hat %1 Labelmaps im zeitlichen Verlauf, von denen hier eine gebraucht wird</translation>
    </message>
    <message>
        <source>It has %1 label maps over time (at %2 ms), of which one is needed here</source>
        <translation>Sie hat %1 Labelmaps im zeitlichen Verlauf (bei %2 ms), von denen hier eine gebraucht wird</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or choose one with --phase, from 0 to %2</source>
        <translation>Verfolgen Sie die Bewegung über alle mit viscera track %1, oder wählen Sie eine mit --phase von 0 bis %2</translation>
    </message>
    <message>
        <source>its segments %1 have the same voxels (label %2 in one layer); they are one organ, %3</source>
        <translation>ihre Segmente %1 haben dieselben Voxel (Label %2 in einer Ebene); sie sind ein Organ, %3</translation>
    </message>
    <message>
        <source>the names of its labels are those of FreeSurfer's colour table</source>
        <translation>die Namen ihrer Labels sind die der Farbtabelle von FreeSurfer</translation>
    </message>
    <message>
        <source>It has several layers of one label map, not several phases</source>
        <translation>Sie hat mehrere Ebenen einer Labelmap, nicht mehrere Phasen</translation>
    </message>
    <message>
        <source>write a .nhdr or .mhd header for it, which says its size</source>
        <translation>Schreiben Sie dazu einen Kopf als .nhdr oder .mhd, der die Größe angibt</translation>
    </message>
    <message>
        <source>a segmentation</source>
        <translation>eine Segmentierung</translation>
    </message>
    <message>
        <source>open the images or the segmentation of the same patient, which are other files</source>
        <translation>öffnen Sie die Bilder oder die Segmentierung desselben Patienten, die andere Dateien sind</translation>
    </message>
    <message>
        <source>It is the table of contents of a DICOM medium (DICOMDIR)</source>
        <translation>Es ist das Inhaltsverzeichnis eines DICOM-Mediums (DICOMDIR)</translation>
    </message>
    <message>
        <source>open the folder that it lists, %1</source>
        <translation>öffnen Sie den Ordner, den sie auflistet, %1</translation>
    </message>
    <message>
        <source>open it as a label map</source>
        <translation>öffnen Sie sie als Labelmap</translation>
    </message>
    <message>
        <source>open it as a surface</source>
        <translation>öffnen Sie sie als Oberfläche</translation>
    </message>
    <message>
        <source>It is a DICOM file that holds no scan, label map or surface: %1</source>
        <translation>Es ist eine DICOM-Datei ohne Scan, Labelmap und Oberfläche: %1</translation>
    </message>
    <message>
        <source>an object of an unknown kind</source>
        <translation>ein Objekt unbekannter Art</translation>
    </message>
    <message>
        <source>its pixels are packed in a way that is not supported</source>
        <translation>ihre Pixel sind auf eine Weise gepackt, die nicht unterstützt wird</translation>
    </message>
    <message>
        <source>save it without compression</source>
        <translation>speichern Sie sie ohne Kompression</translation>
    </message>
    <message>
        <source>It is a segmentation that %1</source>
        <translation>Es ist eine Segmentierung und %1</translation>
    </message>
    <message>
        <source>its segment 0 (%1) has got the label %2</source>
        <translation>ihr Segment 0 (%1) hat das Label %2 bekommen</translation>
    </message>
    <message>
        <source>its fractions are all 0 or 1 of a larger whole; 1 was read as inside</source>
        <translation>ihre Anteile sind alle 0 oder 1 eines größeren Ganzen; 1 wurde als innen gelesen</translation>
    </message>
    <message>
        <source>its pixels of one bit are packed in a way that is not supported (%1)</source>
        <translation>ihre Pixel von einem Bit sind auf eine Weise gepackt, die nicht unterstützt wird (%1)</translation>
    </message>
    <message>
        <source>It is a DICOM image, not a surface</source>
        <translation>Es ist ein DICOM-Bild, keine Oberfläche</translation>
    </message>
    <message>
        <source>make a label map of it first, or open it as one</source>
        <translation>machen Sie zuerst eine Labelmap daraus, oder öffnen Sie sie als solche</translation>
    </message>
    <message>
        <source>the file does not state its axes: RAS is assumed, as 3D Slicer does</source>
        <translation>die Datei nennt ihre Achsen nicht: RAS ist angenommen, wie es 3D Slicer tut</translation>
    </message>
    <message numerus="yes">
        <source>%2 and %n more</source>
        <translation>
            <numerusform>%2 und %n weitere</numerusform>
            <numerusform>%2 und %n weitere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point was|points were} never placed (%2), and there is no other</source>
        <translation>
            <numerusform>%n Punkt wurde nie gesetzt (%2), und einen anderen gibt es nicht</numerusform>
            <numerusform>%n Punkte wurden nie gesetzt (%2), und einen anderen gibt es nicht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that was never placed is|points that were never placed are} left out: %2</source>
        <translation>
            <numerusform>%n Punkt, der nie gesetzt wurde, ist weggelassen: %2</numerusform>
            <numerusform>%n Punkte, die nie gesetzt wurden, sind weggelassen: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds no points, but %1</source>
        <translation>Die Datei enthält keine Punkte, sondern %1</translation>
    </message>
    <message>
        <source>copy its control points into a point list in Slicer's module Markups, and save the list</source>
        <translation>kopieren Sie die Kontrollpunkte in Slicers Modul Markups in eine Punktliste, und speichern Sie diese</translation>
    </message>
    <message numerus="yes">
        <source>%n {object that the file does not place is|objects that the file does not place are} left out</source>
        <translation>
            <numerusform>%n Objekt, das die Datei nicht platziert, ist weggelassen</numerusform>
            <numerusform>%n Objekte, die die Datei nicht platziert, sind weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {object that only supports a print is|objects that only support a print are} left out</source>
        <translation>
            <numerusform>%n Objekt, das nur einen Druck stützt, ist weggelassen</numerusform>
            <numerusform>%n Objekte, die nur einen Druck stützen, sind weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>colours that come from pictures or mixtures are left out</source>
        <translation>Farben aus Bildern oder Mischungen sind weggelassen</translation>
    </message>
    <message>
        <source>beams and other shapes that are no triangles are left out</source>
        <translation>Balken und andere Formen, die keine Dreiecke sind, sind weggelassen</translation>
    </message>
    <message>
        <source>export it without a password</source>
        <translation>exportieren Sie sie ohne Kennwort</translation>
    </message>
    <message>
        <source>It is a ZIP archive without a 3D model</source>
        <translation>Die Datei ist ein ZIP-Archiv ohne 3D-Modell</translation>
    </message>
    <message>
        <source>unpack it and open the files in it</source>
        <translation>entpacken Sie sie, und öffnen Sie die Dateien darin</translation>
    </message>
    <message>
        <source>the surface is too large for 3MF, whose parts end at 4 GB</source>
        <translation>die Oberfläche ist zu groß für 3MF, dessen Teile bei 4 GB enden</translation>
    </message>
    <message>
        <source>zlib cannot pack it</source>
        <translation>zlib kann sie nicht packen</translation>
    </message>
    <message>
        <source>tetrahedra are written as .inp or .vtu only</source>
        <translation>Tetraeder werden nur als .inp oder .vtu geschrieben</translation>
    </message>
    <message>
        <source>the surface %1 is open (%2 boundary edges)</source>
        <translation>die Oberfläche %1 ist offen (%2 Randkanten)</translation>
    </message>
    <message>
        <source>the surfaces %1 and %2 share points</source>
        <translation>die Oberflächen %1 und %2 haben gemeinsame Punkte</translation>
    </message>
    <message>
        <source>move them apart: there is no tissue between them</source>
        <translation>rücken Sie sie auseinander: zwischen ihnen ist kein Gewebe</translation>
    </message>
    <message>
        <source>a cavity is not wholly inside the organ, or inside another cavity</source>
        <translation>ein Hohlraum liegt nicht ganz im Organ, oder in einem anderen Hohlraum</translation>
    </message>
    <message>
        <source>leave it out, or make it smaller</source>
        <translation>lassen Sie ihn weg, oder machen Sie ihn kleiner</translation>
    </message>
    <message>
        <source>It is of gmsh's format %1, which Viscera does not read</source>
        <translation>Sie ist im Format %1 von gmsh, das Viscera nicht liest</translation>
    </message>
    <message>
        <source>open it with gmsh and save it as version 2 or 4</source>
        <translation>öffnen Sie sie mit gmsh und speichern Sie sie als Version 2 oder 4</translation>
    </message>
    <message>
        <source>It is a plane mesh, of two dimensions</source>
        <translation>Es ist ein ebenes Netz mit zwei Dimensionen</translation>
    </message>
    <message>
        <source>export a mesh of three dimensions</source>
        <translation>exportieren Sie ein Netz mit drei Dimensionen</translation>
    </message>
    <message>
        <source>openCARP states points in micrometres: its numbers were divided by 1,000</source>
        <translation>openCARP gibt Punkte in Mikrometern an: die Zahlen wurden durch 1000 geteilt</translation>
    </message>
    <message>
        <source>%1 has more lines than the %2 points that it states; they were left out</source>
        <translation>%1 hat mehr Zeilen als die %2 Punkte, die angegeben sind; sie wurden weggelassen</translation>
    </message>
    <message>
        <source>It has elements of the type %1, which Viscera does not read</source>
        <translation>Sie hat Elemente vom Typ %1, den Viscera nicht liest</translation>
    </message>
    <message>
        <source>save the mesh as tetrahedra</source>
        <translation>speichern Sie das Netz als Tetraeder</translation>
    </message>
    <message>
        <source>reduce the mesh first</source>
        <translation>vereinfachen Sie zuerst das Netz</translation>
    </message>
    <message>
        <source>its %1 regions (%2) were joined to one surface around all of them</source>
        <translation>seine %1 Regionen (%2) wurden zu einer Oberfläche um alle verbunden</translation>
    </message>
    <message numerus="yes">
        <source>%n {cell that repeats|cells that repeat} another left out</source>
        <translation>
            <numerusform>%n Zelle, die eine andere wiederholt, weggelassen</numerusform>
            <numerusform>%n Zellen, die andere wiederholen, weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face belongs|faces belong} to more than two cells, which overlap</source>
        <translation>
            <numerusform>%n Fläche gehört zu mehr als zwei Zellen, die sich überlappen</numerusform>
            <numerusform>%n Flächen gehören zu mehr als zwei Zellen, die sich überlappen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {flat cell that bounds|flat cells that bound} no cell with a volume left out</source>
        <translation>
            <numerusform>%n flache Zelle, die keine Zelle mit Volumen begrenzt, weggelassen</numerusform>
            <numerusform>%n flache Zellen, die keine Zelle mit Volumen begrenzen, weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curved {cell was|cells were} read as straight between {its|their} corners</source>
        <translation>
            <numerusform>%n gekrümmte Zelle wurde gerade zwischen ihren Ecken gelesen</numerusform>
            <numerusform>%n gekrümmte Zellen wurden gerade zwischen ihren Ecken gelesen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has %n {cavity|cavities}: its volume is that of the wall around {it|them}</source>
        <translation>
            <numerusform>sie hat %n Hohlraum: ihr Volumen ist das der Wand um ihn</numerusform>
            <numerusform>sie hat %n Hohlräume: ihr Volumen ist das der Wand um sie</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n small {gap|gaps} between its cells filled</source>
        <translation>
            <numerusform>%n kleine Lücke zwischen seinen Zellen gefüllt</numerusform>
            <numerusform>%n kleine Lücken zwischen seinen Zellen gefüllt</numerusform>
        </translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Hohlraum</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} that CARTO's user has cut away left out</source>
        <translation>
            <numerusform>%n Dreieck, die in CARTO weggeschnitten wurden, weggelassen</numerusform>
            <numerusform>%n Dreiecke, die in CARTO weggeschnitten wurden, weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not say where its scan is: its points stay in FreeSurfer's own coordinates, which may be some millimetres beside the scan</source>
        <translation>sie sagt nicht, wo ihre Aufnahme liegt: die Punkte bleiben in FreeSurfers eigenen Koordinaten, die einige Millimeter neben der Aufnahme liegen können</translation>
    </message>
    <message>
        <source>It holds values at the points of a surface, such as curvature or thickness, not a surface</source>
        <translation>Sie enthält Werte an den Punkten einer Oberfläche, wie Krümmung oder Dicke, keine Oberfläche</translation>
    </message>
    <message>
        <source>open the surface to which they belong, such as lh.white or lh.pial</source>
        <translation>öffnen Sie die Oberfläche, zu der sie gehören, wie lh.white oder lh.pial</translation>
    </message>
    <message>
        <source>its points were moved from FreeSurfer's own coordinates to those of its scan</source>
        <translation>ihre Punkte wurden von FreeSurfers eigenen Koordinaten in die ihrer Aufnahme verschoben</translation>
    </message>
    <message numerus="yes">
        <source>%n further {surface|surfaces} of the file left out</source>
        <translation>
            <numerusform>%n weitere Oberfläche der Datei weggelassen</numerusform>
            <numerusform>%n weitere Oberflächen der Datei weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds values at the points of a surface (%1), not a surface</source>
        <translation>Sie enthält Werte an den Punkten einer Oberfläche (%1), keine Oberfläche</translation>
    </message>
    <message>
        <source>open the surface to which they belong, which usually ends in .surf.gii</source>
        <translation>öffnen Sie die Oberfläche, zu der sie gehören; sie endet meist auf .surf.gii</translation>
    </message>
    <message>
        <source>It holds no surface of triangles</source>
        <translation>Sie enthält keine Oberfläche aus Dreiecken</translation>
    </message>
    <message>
        <source>Its values are in another file, %1, which Viscera does not read</source>
        <translation>Ihre Werte stehen in einer anderen Datei, %1, die Viscera nicht liest</translation>
    </message>
    <message>
        <source>save it with its values inside (GZipBase64Binary)</source>
        <translation>speichern Sie sie mit den Werten darin (GZipBase64Binary)</translation>
    </message>
    <message>
        <source>its points were moved to the scan by the matrix that the file states</source>
        <translation>ihre Punkte wurden mit der Matrix, die die Datei angibt, zur Aufnahme verschoben</translation>
    </message>
    <message>
        <source>its matrix from %1 to %2 was not applied</source>
        <translation>ihre Matrix von %1 nach %2 wurde nicht angewendet</translation>
    </message>
    <message>
        <source>save it as %1 with %2</source>
        <translation>speichern Sie es mit %2 als %1</translation>
    </message>
    <message>
        <source>load it in 3D Slicer with its images, convert it to a segmentation there, and save that as .seg.nrrd</source>
        <translation>laden Sie es mit seinen Bildern in 3D Slicer, wandeln Sie es dort in eine Segmentierung um, und speichern Sie diese als .seg.nrrd</translation>
    </message>
    <message>
        <source>It holds %1, not %2</source>
        <translation>Die Datei enthält %1, nicht %2</translation>
    </message>
    <message>
        <source>its unit %1 is not known; mm are assumed</source>
        <translation>ihre Einheit %1 ist unbekannt; mm werden angenommen</translation>
    </message>
    <message>
        <source>converted from %1 to mm</source>
        <translation>von %1 in mm umgerechnet</translation>
    </message>
    <message>
        <source>the other file that belongs to it, %1, is not beside it</source>
        <translation>die andere Datei, die zu ihr gehört, %1, liegt nicht daneben</translation>
    </message>
    <message>
        <source>this cannot be written as %1</source>
        <translation>dies lässt sich nicht als %1 schreiben</translation>
    </message>
    <message>
        <source>several surfaces cannot be written as %1</source>
        <translation>mehrere Oberflächen lassen sich nicht als %1 schreiben</translation>
    </message>
    <message>
        <source>let its name end in %1</source>
        <translation>lassen Sie ihren Namen auf %1 enden</translation>
    </message>
    <message>
        <source>rename it to end in %1</source>
        <translation>benennen Sie sie um, sodass sie auf %1 endet</translation>
    </message>
    <message>
        <source>a line</source>
        <translation>eine Linie</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>einen Winkel</translation>
    </message>
    <message>
        <source>a curve</source>
        <translation>eine Kurve</translation>
    </message>
    <message>
        <source>a closed curve</source>
        <translation>eine geschlossene Kurve</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>eine Ebene</translation>
    </message>
    <message>
        <source>a box (ROI)</source>
        <translation>einen Quader (ROI)</translation>
    </message>
    <message>
        <source>a markup of another kind</source>
        <translation>eine Markierung anderer Art</translation>
    </message>
    <message>
        <source>%1 is made for another organ (%2) than this one (%3): its numbers say nothing about it</source>
        <translation>%1 ist für ein anderes Organ (%2) gemacht als dieses (%3): die Zahlen sagen nichts über dieses aus</translation>
    </message>
    <message>
        <source>The motion was recorded of another organ (%1) than this one (%2): its numbers say nothing about it</source>
        <translation>Die Bewegung wurde an einem anderen Organ (%1) aufgenommen als diesem (%2): die Zahlen sagen nichts über dieses aus</translation>
    </message>
    <message>
        <source>right and left, front and back, head and feet are exchanged: mirrored</source>
        <translation>rechts und links, vorn und hinten, Kopf und Füße sind vertauscht: gespiegelt</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are right and left: the patient is upside down</source>
        <translation>Kopf und Füße sind vertauscht, ebenso rechts und links: der Patient steht auf dem Kopf</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, unless head and feet are exchanged too</source>
        <translation>rechts und links sind vertauscht, vorn und hinten nicht: gespiegelt, falls nicht auch Kopf und Füße vertauscht sind</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, or situs inversus</source>
        <translation>rechts und links sind vertauscht, vorn und hinten nicht: gespiegelt, oder Situs inversus</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are front and back: the patient is upside down</source>
        <translation>Kopf und Füße sind vertauscht, ebenso vorn und hinten: der Patient steht auf dem Kopf</translation>
    </message>
    <message>
        <source>head and feet are exchanged: the patient is upside down, or mirrored</source>
        <translation>Kopf und Füße sind vertauscht: der Patient steht auf dem Kopf oder ist gespiegelt</translation>
    </message>
    <message>
        <source>head and feet are exchanged, front and back are not: the slices seem to be in the opposite order, which mirrors the patient</source>
        <translation>Kopf und Füße sind vertauscht, vorn und hinten nicht: die Schichten scheinen in umgekehrter Folge zu liegen, was den Patienten spiegelt</translation>
    </message>
    <message>
        <source>front and back are exchanged: the files may be in RAS, mirrored, or upside down</source>
        <translation>vorn und hinten sind vertauscht: die Dateien sind vielleicht in RAS, gespiegelt oder auf dem Kopf</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored, unless head and feet are exchanged too</source>
        <translation>vorn und hinten sind vertauscht, rechts und links nicht: gespiegelt, falls nicht auch Kopf und Füße vertauscht sind</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored</source>
        <translation>vorn und hinten sind vertauscht, rechts und links nicht: gespiegelt</translation>
    </message>
    <message>
        <source>the head lies along the y axis: the files seem to come from a program in which y is up</source>
        <translation>der Kopf liegt entlang der y-Achse: die Dateien scheinen aus einem Programm zu stammen, in dem y nach oben zeigt</translation>
    </message>
    <message>
        <source>the organs do not lie as in a body whose axes are LPS: other axes, or not of one patient</source>
        <translation>die Organe liegen nicht wie in einem Körper mit den Achsen LPS: andere Achsen, oder nicht von einem Patienten</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on that side, but the others lie on the side opposite to the usual one: situs inversus, or wrong names</source>
        <translation>Organe, deren Namen links oder rechts nennen, liegen auf dieser Seite, die anderen aber auf der ungewöhnlichen: Situs inversus, oder falsche Namen</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on the opposite side, but the others lie as usual: left and right seem to be exchanged in the names</source>
        <translation>Organe, deren Namen links oder rechts nennen, liegen auf der anderen Seite, die übrigen aber wie gewöhnlich: in den Namen scheinen links und rechts vertauscht zu sein</translation>
    </message>
    <message numerus="yes">
        <source>by the other organs, %n {organ lies|organs lie} on the opposite side of the patient: %2</source>
        <translation>
            <numerusform>nach den anderen Organen liegt %n Organ auf der gegenüberliegenden Seite des Patienten: %2</numerusform>
            <numerusform>nach den anderen Organen liegen %n Organe auf der gegenüberliegenden Seite des Patienten: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: the coordinates seem to be in %2</source>
        <translation>nach ihren Volumina sind alle Organe %1-mal so groß wie in Wirklichkeit: die Koordinaten scheinen in %2 zu sein</translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: a child, an atlas that is not life-sized, or another unit</source>
        <translation>nach ihren Volumina sind alle Organe %1-mal so groß wie in Wirklichkeit: ein Kind, ein Atlas, der nicht lebensgroß ist, oder eine andere Einheit</translation>
    </message>
    <message>
        <source>among the other organs it lies on the side that its name says</source>
        <translation>unter den anderen Organen liegt es auf der Seite, die sein Name nennt</translation>
    </message>
    <message>
        <source>turns the surface by a quarter and a half turn, from a model in RAS whose y axis points to the head</source>
        <translation>dreht die Oberfläche um eine viertel und eine halbe Drehung, von einem Modell in RAS, dessen y-Achse zum Kopf zeigt</translation>
    </message>
    <message>
        <source>exchanges front and back, which mirrors the surface</source>
        <translation>vertauscht vorn und hinten, was die Oberfläche spiegelt</translation>
    </message>
    <message>
        <source>exchanges head and feet, which mirrors the surface</source>
        <translation>vertauscht Kopf und Füße, was die Oberfläche spiegelt</translation>
    </message>
    <message>
        <source>exchanges head and feet, and front and back, by half a turn</source>
        <translation>vertauscht Kopf und Füße sowie vorn und hinten durch eine halbe Drehung</translation>
    </message>
    <message>
        <source>exchanges head and feet, and right and left, by half a turn</source>
        <translation>vertauscht Kopf und Füße sowie rechts und links durch eine halbe Drehung</translation>
    </message>
    <message>
        <source>exchanges all three directions, which mirrors the surface</source>
        <translation>vertauscht alle drei Richtungen, was die Oberfläche spiegelt</translation>
    </message>
    <message>
        <source>Convert from Y up and RAS to LPS</source>
        <translation>Von Y oben und RAS nach LPS umwandeln</translation>
    </message>
    <message>
        <source>Mirror front and back</source>
        <translation>Vorn und hinten spiegeln</translation>
    </message>
    <message>
        <source>Mirror head and feet</source>
        <translation>Kopf und Füße spiegeln</translation>
    </message>
    <message>
        <source>Turn head and feet, front and back</source>
        <translation>Kopf und Füße, vorn und hinten drehen</translation>
    </message>
    <message>
        <source>Turn head and feet, right and left</source>
        <translation>Kopf und Füße, rechts und links drehen</translation>
    </message>
    <message>
        <source>Mirror all three directions</source>
        <translation>Alle drei Richtungen spiegeln</translation>
    </message>
    <message numerus="yes">
        <source>is cut by {the %2 edge|%n edges (%2)} of the image: its volume is too small</source>
        <translation>
            <numerusform>ist am Bildrand %2 abgeschnitten: sein Volumen ist zu klein</numerusform>
            <numerusform>ist an %n Bildrändern (%2) abgeschnitten: sein Volumen ist zu klein</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reaches {the %2 edge|%n edges (%2)} of the image, which may cut it off</source>
        <translation>
            <numerusform>reicht bis zum Bildrand %2, wo es abgeschnitten sein kann</numerusform>
            <numerusform>reicht bis zu %n Bildrändern (%2), wo es abgeschnitten sein kann</numerusform>
        </translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>There are no organs whose coordinates could be converted</source>
        <translation>Es gibt keine Organe, deren Koordinaten umgewandelt werden könnten</translation>
    </message>
    <message>
        <source>open some first</source>
        <translation>öffnen Sie zuerst welche</translation>
    </message>
    <message>
        <source>Convert between RAS and LPS</source>
        <translation>Zwischen RAS und LPS umwandeln</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>Convert the unit</source>
        <translation>Die Einheit umwandeln</translation>
    </message>
    <message>
        <source>Convert the axes</source>
        <translation>Die Achsen umwandeln</translation>
    </message>
    <message>
        <source>converted after the import: %1</source>
        <translation>nach dem Import umgewandelt: %1</translation>
    </message>
    <message>
        <source>Scale by %1</source>
        <translation>Um %1 skalieren</translation>
    </message>
    <message>
        <source>scaled after the import by %1</source>
        <translation>nach dem Import um %1 skaliert</translation>
    </message>
    <message>
        <source>All organs together: %1.</source>
        <translation>Alle Organe zusammen: %1.</translation>
    </message>
    <message>
        <source>RAS or mirrored</source>
        <translation>RAS oder gespiegelt</translation>
    </message>
    <message>
        <source>head and feet exchanged</source>
        <translation>Kopf und Füße vertauscht</translation>
    </message>
    <message>
        <source>Only partly possible: %1</source>
        <translation>Nur teilweise möglich: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source>All %1 slices were resampled to a distance of %2 mm; values between two slices are mixed from both</source>
        <translation>Alle %1 Schichten wurden auf einen Abstand von %2 mm umgerechnet; Werte zwischen zwei Schichten sind aus beiden gemischt</translation>
    </message>
    <message>
        <source>It does not say how thick its slice is; 1 mm is assumed, so volumes in it are not measured</source>
        <translation>Sie sagt nicht, wie dick ihre Schicht ist; 1 mm wird angenommen, Volumen darin sind also nicht gemessen</translation>
    </message>
    <message>
        <source>It does not say how large its pixels are; %1 mm were taken from its field of view, so check a length that you know</source>
        <translation>Sie sagt nicht, wie groß ihre Pixel sind; %1 mm wurden ihrem Bildfeld entnommen, prüfen Sie also eine bekannte Länge</translation>
    </message>
    <message>
        <source>none of the %1 pieces is as small as that</source>
        <translation>keines der %1 Stücke ist so klein</translation>
    </message>
    <message numerus="yes">
        <source>%n of %2 pieces {goes|go}, of %3 mm and %4 ml at most</source>
        <translation>
            <numerusform>%n von %2 Stücken geht weg, höchstens %3 mm und %4 ml groß</numerusform>
            <numerusform>%n von %2 Stücken gehen weg, höchstens %3 mm und %4 ml groß</numerusform>
        </translation>
    </message>
    <message>
        <source>drops the pieces that are smaller than a size; the largest one stays</source>
        <translation>entfernt die Stücke unter einer Größe; das größte bleibt</translation>
    </message>
    <message>
        <source>multiplies all coordinates by a factor</source>
        <translation>multipliziert alle Koordinaten mit einem Faktor</translation>
    </message>
    <message>
        <source>details of %1 mm take too much memory; %2 mm is the finest for its size</source>
        <translation>Einzelheiten von %1 mm brauchen zu viel Speicher; %2 mm ist bei seiner Größe das Feinste</translation>
    </message>
    <message>
        <source>choose a coarser resolution</source>
        <translation>wählen Sie eine gröbere Auflösung</translation>
    </message>
    <message>
        <source>remeshing lost a detail: the old surface lies up to %1 mm from the new one</source>
        <translation>die neue Vernetzung hat eine Einzelheit verloren: Die alte Oberfläche liegt bis zu %1 mm von der neuen entfernt</translation>
    </message>
    <message>
        <source>the handles cannot move by exactly %1 mm: %2</source>
        <translation>die Griffe können sich nicht um genau %1 mm bewegen: %2</translation>
    </message>
    <message>
        <source>move less far, or let more handles compensate</source>
        <translation>bewegen Sie weniger weit, oder lassen Sie mehr Griffe ausgleichen</translation>
    </message>
    <message>
        <source>This organ does not bend, so its tissue has no stress; let it bend as soft tissue</source>
        <translation>Dieses Organ biegt sich nicht, also hat sein Gewebe keinen Stress; lassen Sie es sich als weiches Gewebe biegen</translation>
    </message>
    <message>
        <source>Move as a rigid body</source>
        <translation>Als starren Körper bewegen</translation>
    </message>
    <message>
        <source>Keep in place</source>
        <translation>An Ort und Stelle halten</translation>
    </message>
    <message>
        <source>Bend as soft tissue</source>
        <translation>Als weiches Gewebe biegen</translation>
    </message>
    <message>
        <source>Measure the distance of organs</source>
        <translation>Abstand von Organen messen</translation>
    </message>
    <message>
        <source>The shortest distance is between two organs</source>
        <translation>Der kürzeste Abstand liegt zwischen zwei Organen</translation>
    </message>
    <message>
        <source>select two organs</source>
        <translation>wählen Sie zwei Organe</translation>
    </message>
    <message>
        <source>shortest distance</source>
        <translation>kürzester Abstand</translation>
    </message>
    <message>
        <source>There are %1 witness points of %2: the others would lie in cavities, which hold no tissue.</source>
        <translation>Es gibt %1 von %2 Messpunkten: Die anderen lägen in Hohlräumen, die kein Gewebe enthalten.</translation>
    </message>
    <message>
        <source>The largest angle by which a direction is turned when the tissue is stretched; not a pressure.</source>
        <translation>Der größte Winkel, um den eine Richtung beim Dehnen des Gewebes gedreht wird; kein Druck.</translation>
    </message>
    <message>
        <source>The volume of tissue now, as a part of that at rest; 1 is unchanged.</source>
        <translation>Das Volumen des Gewebes jetzt, als Teil dessen in Ruhe; 1 ist unverändert.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that grows most.</source>
        <translation>Die Länge des Gewebes jetzt, als Teil derer in Ruhe, in der Richtung, die am meisten wächst.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that shrinks most.</source>
        <translation>Die Länge des Gewebes jetzt, als Teil derer in Ruhe, in der Richtung, die am meisten schrumpft.</translation>
    </message>
    <message>
        <source>1 where the tissue is turned inside out.</source>
        <translation>1, wo das Gewebe umgestülpt ist.</translation>
    </message>
    <message>
        <source>global longitudinal strain</source>
        <translation>globale longitudinale Dehnung</translation>
    </message>
    <message>
        <source>global circumferential strain</source>
        <translation>globale zirkumferenzielle Dehnung</translation>
    </message>
    <message>
        <source>global radial strain</source>
        <translation>globale radiale Dehnung</translation>
    </message>
    <message>
        <source>67 healthy adults, by feature tracking in magnetic resonance over the whole ventricle (CVI42); other programs differ by several points</source>
        <translation>67 gesunde Erwachsene, mit Feature Tracking in der Magnetresonanz über den ganzen Ventrikel (CVI42); andere Programme weichen um mehrere Punkte ab</translation>
    </message>
    <message>
        <source>The surface encloses nothing</source>
        <translation>Die Oberfläche umschließt nichts</translation>
    </message>
    <message>
        <source>choose the surface of its cavity</source>
        <translation>wählen Sie die Oberfläche seiner Höhle</translation>
    </message>
    <message>
        <source>The base and the apex are the same place</source>
        <translation>Basis und Spitze sind derselbe Ort</translation>
    </message>
    <message>
        <source>choose two other points</source>
        <translation>wählen Sie zwei andere Punkte</translation>
    </message>
    <message>
        <source>The insertion of the right ventricle lies on the long axis</source>
        <translation>Der Ansatz des rechten Ventrikels liegt auf der langen Achse</translation>
    </message>
    <message>
        <source>choose a point of the wall</source>
        <translation>wählen Sie einen Punkt der Wand</translation>
    </message>
    <message>
        <source>The wall cannot be divided into layers</source>
        <translation>Die Wand lässt sich nicht in Schichten teilen</translation>
    </message>
    <message>
        <source>use fewer witness points</source>
        <translation>nehmen Sie weniger Messpunkte</translation>
    </message>
    <message>
        <source>The tissue does not reach from the cavity to the outer surface</source>
        <translation>Das Gewebe reicht nicht von der Höhle bis zur äußeren Oberfläche</translation>
    </message>
    <message>
        <source>choose the surfaces of one heart</source>
        <translation>wählen Sie die Oberflächen eines Herzens</translation>
    </message>
    <message>
        <source>name one of the surfaces of the heart</source>
        <translation>nennen Sie eine der Oberflächen des Herzens</translation>
    </message>
    <message>
        <source>There is no phase %1</source>
        <translation>Es gibt keine Phase %1</translation>
    </message>
    <message>
        <source>phases are counted from 1 to %1</source>
        <translation>Phasen zählen von 1 bis %1</translation>
    </message>
    <message>
        <source>layers of the wall</source>
        <translation>Schichten der Wand</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>surfaces in motion</source>
        <translation>Oberflächen in Bewegung</translation>
    </message>
    <message>
        <source>No surface is a left ventricle by its name</source>
        <translation>Keine Oberfläche ist dem Namen nach ein linker Ventrikel</translation>
    </message>
    <message>
        <source>name its cavity with --lv</source>
        <translation>nennen Sie seine Höhle mit --lv</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>es gibt: %1</translation>
    </message>
    <message>
        <source>It holds no organ</source>
        <translation>Sie enthält kein Organ</translation>
    </message>
    <message>
        <source>name one with --organ</source>
        <translation>nennen Sie eines mit --organ</translation>
    </message>
    <message>
        <source>Without the right ventricle the numbers of segments mean nothing: give its surface, or a point where it meets the left one in front</source>
        <translation>Ohne den rechten Ventrikel bedeuten die Nummern der Segmente nichts: geben Sie seine Oberfläche an, oder einen Punkt, an dem er vorn auf den linken trifft</translation>
    </message>
    <message>
        <source>Material points are not known in this motion: lengths of contours can be read, segments cannot</source>
        <translation>Materielle Punkte sind in dieser Bewegung nicht bekannt: Längen von Konturen lassen sich ablesen, Segmente nicht</translation>
    </message>
    <message>
        <source>The left ventricle is fullest in phase %1, and strain is measured from phase %2</source>
        <translation>Der linke Ventrikel ist in Phase %1 am vollsten, und die Dehnung wird ab Phase %2 gemessen</translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} too few points to be read</source>
        <translation>
            <numerusform>%n Segment hat zu wenige Punkte, um abgelesen zu werden</numerusform>
            <numerusform>%n Segmente haben zu wenige Punkte, um abgelesen zu werden</numerusform>
        </translation>
    </message>
    <message>
        <source>see docs/strain.md for the form of such a file</source>
        <translation>siehe docs/strain.md zur Form einer solchen Datei</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Isovolumetrische Kontraktion</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Isovolumetrische Relaxation</translation>
    </message>
    <message>
        <source>Ejection time</source>
        <translation>Austreibungszeit</translation>
    </message>
    <message>
        <source>Aorta, in exercise</source>
        <translation>Aorta, bei Belastung</translation>
    </message>
    <message>
        <source>Left atrium, in exercise</source>
        <translation>Linker Vorhof, bei Belastung</translation>
    </message>
    <message>
        <source>Aortic valve, in exercise</source>
        <translation>Aortenklappe, bei Belastung</translation>
    </message>
    <message>
        <source>highest pressure (a wave)</source>
        <translation>höchster Druck (a-Welle)</translation>
    </message>
    <message>
        <source>healthy adults at peak exercise</source>
        <translation>gesunde Erwachsene bei höchster Belastung</translation>
    </message>
    <message>
        <source>62 healthy people, wedge pressure; some of the oldest exceed it</source>
        <translation>62 Gesunde, Verschlussdruck; einige der Ältesten überschreiten ihn</translation>
    </message>
    <message>
        <source>healthy adults: the limit at rest is kept</source>
        <translation>gesunde Erwachsene: Die Grenze in Ruhe gilt weiter</translation>
    </message>
    <message>
        <source>textbooks; percentiles of 2917 people: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</source>
        <translation>Lehrbücher; Perzentile von 2917 Menschen: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</translation>
    </message>
    <message>
        <source>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</source>
        <translation>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</translation>
    </message>
    <message>
        <source>as at rest; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>wie in Ruhe; keine Stenose bis 2,5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>customary at the bedside, for the 1 to 1.7 m/s of a healthy valve; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>in der Klinik üblich, für die 1 bis 1,7 m/s einer gesunden Klappe; keine Stenose bis 2,5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>none or a trace, which normal valves often have: doi 10.1378/chest.103.1.226</source>
        <translation>keine oder eine Spur, die normale Klappen oft haben: doi 10.1378/chest.103.1.226</translation>
    </message>
    <message>
        <source>between the contractions of both, shorter than the PR interval of 0.12 to 0.20 s</source>
        <translation>zwischen den Kontraktionen beider, kürzer als das PQ-Intervall von 0,12 bis 0,20 s</translation>
    </message>
    <message>
        <source>Tricuspid valve</source>
        <translation>Trikuspidalklappe</translation>
    </message>
    <message>
        <source>Pulmonary valve</source>
        <translation>Pulmonalklappe</translation>
    </message>
    <message>
        <source>Longitudinal strain</source>
        <translation>Längsverformung</translation>
    </message>
    <message>
        <source>Circumferential strain</source>
        <translation>Umfangsverformung</translation>
    </message>
    <message>
        <source>Radial strain</source>
        <translation>Radiale Verformung</translation>
    </message>
    <message>
        <source>Difference of both</source>
        <translation>Unterschied beider</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Verformung (Strain)</translation>
    </message>
    <message>
        <source>Strain (%)</source>
        <translation>Verformung (%)</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Spitzenwert</translation>
    </message>
    <message>
        <source>At this instant</source>
        <translation>In diesem Augenblick</translation>
    </message>
    <message>
        <source>Time to peak</source>
        <translation>Zeit bis zum Spitzenwert</translation>
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
        <translation>mittventrikulär</translation>
    </message>
    <message>
        <source>apex</source>
        <translation>Herzspitze</translation>
    </message>
    <message>
        <source>%1 %2 % at %3 ms (healthy adults %4 to %5)</source>
        <translation>%1 %2 % bei %3 ms (gesunde Erwachsene %4 bis %5)</translation>
    </message>
    <message>
        <source>&amp;Strain of the wall</source>
        <translation>Ver&amp;formung der Wand</translation>
    </message>
    <message>
        <source>Se&amp;gments on the organ</source>
        <translation>Se&amp;gmente auf dem Organ</translation>
    </message>
    <message>
        <source>Expo&amp;rt strain...</source>
        <translation>Verformung e&amp;xportieren...</translation>
    </message>
    <message>
        <source>Strain needs the cavity of a left ventricle, by its name, that follows the handles.</source>
        <translation>Verformung braucht den Hohlraum einer linken Herzkammer, dem Namen nach, der den Griffen folgt.</translation>
    </message>
    <message>
        <source>The strain is drawn here as soon as it is measured.</source>
        <translation>Die Verformung wird hier gezeichnet, sobald sie gemessen ist.</translation>
    </message>
    <message>
        <source>GLS and GCS are the change of the length of contours of the endocardium, as ultrasound and feature tracking report it. GRS and the segments are the strain of the material at witness points of the wall. Shortening is negative. All are against the end of diastole. Values of single segments are poorly repeated between programs: hatched ones are not to be relied on.</source>
        <translation>GLS und GCS sind die Längenänderung von Konturen des Endokards, wie Ultraschall und Feature Tracking sie angeben. GRS und die Segmente sind die Verformung des Materials an Messpunkten der Wand. Verkürzung ist negativ. Alle gelten gegenüber dem Ende der Diastole. Werte einzelner Segmente stimmen zwischen Programmen schlecht überein: Auf schraffierte ist kein Verlass.</translation>
    </message>
    <message>
        <source>left ventricle</source>
        <translation>linke Herzkammer</translation>
    </message>
    <message>
        <source>hatched: uncertain</source>
        <translation>schraffiert: unsicher</translation>
    </message>
    <message numerus="yes">
        <source>In %n {segment|segments} the fit of the motion leaves a peak less certain than its distance from the range of healthy adults</source>
        <translation>
            <numerusform>In %n Segment ist der Spitzenwert nach der Anpassung der Bewegung unsicherer als sein Abstand vom Bereich gesunder Erwachsener</numerusform>
            <numerusform>In %n Segmenten ist der Spitzenwert nach der Anpassung der Bewegung unsicherer als sein Abstand vom Bereich gesunder Erwachsener</numerusform>
        </translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>Untersuchungsdatum</translation>
    </message>
    <message>
        <source>Sinoatrial node</source>
        <translation>Sinusknoten</translation>
    </message>
    <message>
        <source>Anterior internodal pathway</source>
        <translation>Vordere Internodalbahn</translation>
    </message>
    <message>
        <source>Middle internodal pathway</source>
        <translation>Mittlere Internodalbahn</translation>
    </message>
    <message>
        <source>Posterior internodal pathway</source>
        <translation>Hintere Internodalbahn</translation>
    </message>
    <message>
        <source>Bachmann&apos;s bundle</source>
        <translation>Bachmann-Bündel</translation>
    </message>
    <message>
        <source>Left atrial muscle</source>
        <translation>Muskel des linken Vorhofs</translation>
    </message>
    <message>
        <source>Atrioventricular node</source>
        <translation>Atrioventrikularknoten</translation>
    </message>
    <message>
        <source>Bundle of His</source>
        <translation>His-Bündel</translation>
    </message>
    <message>
        <source>Left bundle branch</source>
        <translation>Linker Tawara-Schenkel</translation>
    </message>
    <message>
        <source>Left anterior fascicle</source>
        <translation>Linksanteriorer Faszikel</translation>
    </message>
    <message>
        <source>Left posterior fascicle</source>
        <translation>Linksposteriorer Faszikel</translation>
    </message>
    <message>
        <source>Left septal fascicle</source>
        <translation>Linksseptaler Faszikel</translation>
    </message>
    <message>
        <source>Right bundle branch</source>
        <translation>Rechter Tawara-Schenkel</translation>
    </message>
    <message>
        <source>Purkinje fibres</source>
        <translation>Purkinje-Fasern</translation>
    </message>
    <message>
        <source>Cardial notch</source>
        <translation>Incisura cardialis</translation>
    </message>
    <message>
        <source>Angular incisure</source>
        <translation>Incisura angularis</translation>
    </message>
    <message>
        <source>Greater omentum</source>
        <translation>Großes Netz</translation>
    </message>
    <message>
        <source>Diaphragmatic surface</source>
        <translation>Zwerchfellfläche</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Hilum</translation>
    </message>
    <message>
        <source>Superior border</source>
        <translation>Oberer Rand</translation>
    </message>
    <message>
        <source>Anterior end</source>
        <translation>Vorderes Ende</translation>
    </message>
    <message>
        <source>Posterior end</source>
        <translation>Hinteres Ende</translation>
    </message>
    <message>
        <source>name its cavity&apos;s file LV</source>
        <translation>nennen Sie die Datei seiner Höhle LV</translation>
    </message>
    <message numerus="yes">
        <source>%n {key|keys}</source>
        <translation>
            <numerusform>%n Schlüsselbild</numerusform>
            <numerusform>%n Schlüsselbilder</numerusform>
        </translation>
    </message>
    <message>
        <source>the first at %1 s, the last at %2 s</source>
        <translation>das erste bei %1 s, das letzte bei %2 s</translation>
    </message>
    <message>
        <source>the shape of the first of %1 files of its motion; the last one is %2</source>
        <translation>die Form der ersten von %1 Dateien seiner Bewegung; die letzte ist %2</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume in one place and swollen to %2 % in another. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>Gewebe ist an einer Stelle auf %1 % seines Volumens zusammengedrückt und an einer anderen auf %2 % geschwollen. Lebendes Gewebe, größtenteils Wasser, ändert sein Volumen kaum; die Koordinaten wissen das nicht. Eine kleinere Bewegung, mehr Griffe oder ein gesperrtes Volumen helfen.</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>Gewebe ist auf %1 % seines Volumens zusammengedrückt. Lebendes Gewebe, größtenteils Wasser, ändert sein Volumen kaum; die Koordinaten wissen das nicht. Eine kleinere Bewegung, mehr Griffe oder ein gesperrtes Volumen helfen.</translation>
    </message>
    <message>
        <source>Tissue is swollen to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>Gewebe ist auf %1 % seines Volumens geschwollen. Lebendes Gewebe, größtenteils Wasser, ändert sein Volumen kaum; die Koordinaten wissen das nicht. Eine kleinere Bewegung, mehr Griffe oder ein gesperrtes Volumen helfen.</translation>
    </message>
    <message>
        <source>Chordae tendineae</source>
        <translation>Sehnenfäden</translation>
    </message>
    <message>
        <source>Left main coronary artery</source>
        <translation>Stamm der linken Koronararterie</translation>
    </message>
    <message>
        <source>Circumflex artery</source>
        <translation>Ramus circumflexus</translation>
    </message>
    <message>
        <source>Diagonal branch</source>
        <translation>Diagonalast</translation>
    </message>
    <message>
        <source>Septal branches</source>
        <translation>Septumäste</translation>
    </message>
    <message>
        <source>Intermediate branch</source>
        <translation>Intermediärast</translation>
    </message>
    <message>
        <source>Right ventricular branch</source>
        <translation>Ast zur rechten Kammer</translation>
    </message>
    <message>
        <source>Conus branch</source>
        <translation>Konusast</translation>
    </message>
    <message>
        <source>Left marginal branch</source>
        <translation>Linker Marginalast</translation>
    </message>
    <message>
        <source>Right marginal branch</source>
        <translation>Rechter Marginalast</translation>
    </message>
    <message>
        <source>Posterolateral branch</source>
        <translation>Posterolateralast</translation>
    </message>
    <message>
        <source>Posterior descending artery</source>
        <translation>Ramus interventricularis posterior</translation>
    </message>
    <message>
        <source>Sinoatrial nodal branch</source>
        <translation>Sinusknotenast</translation>
    </message>
    <message>
        <source>Great cardiac vein</source>
        <translation>Große Herzvene</translation>
    </message>
    <message>
        <source>Middle cardiac vein</source>
        <translation>Mittlere Herzvene</translation>
    </message>
    <message>
        <source>Posterior vein of the left ventricle</source>
        <translation>Hintere Vene der linken Kammer</translation>
    </message>
    <message>
        <source>Coronary sinus</source>
        <translation>Sinus coronarius</translation>
    </message>
    <message>
        <source>geometric mean (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) of the systolic and diastolic bounds, 73 to 98 mmHg, rounded</source>
        <translation>geometrisches Mittel (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) der systolischen und diastolischen Grenzen, 73 bis 98 mmHg, gerundet</translation>
    </message>
    <message>
        <source>short axis</source>
        <translation>Kurzachse</translation>
    </message>
    <message>
        <source>long axis</source>
        <translation>Längsachse</translation>
    </message>
    <message>
        <source>other plane</source>
        <translation>andere Ebene</translation>
    </message>
    <message>
        <source>2-chamber</source>
        <translation>Zweikammerblick</translation>
    </message>
    <message>
        <source>3-chamber</source>
        <translation>Dreikammerblick</translation>
    </message>
    <message>
        <source>4-chamber</source>
        <translation>Vierkammerblick</translation>
    </message>
    <message>
        <source>It has no images over a heart&apos;s cycle</source>
        <translation>Es enthält keine Bilder über einen Herzzyklus</translation>
    </message>
    <message>
        <source>name the folder of a cine study, or a file with volumes over time</source>
        <translation>nennen Sie den Ordner einer Cine-Studie oder eine Datei mit Volumen über die Zeit</translation>
    </message>
    <message>
        <source>It has changed since it was opened</source>
        <translation>Sie hat sich geändert, seit sie geöffnet wurde</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>öffnen Sie sie noch einmal</translation>
    </message>
    <message>
        <source>It does not say how long the heart&apos;s cycle is; its phases are spread over one</source>
        <translation>Sie sagt nicht, wie lang der Herzzyklus ist; ihre Phasen sind über einen verteilt</translation>
    </message>
    <message>
        <source>It has the images of %1 patients: &quot;%2&quot; and &quot;%3&quot; are of two</source>
        <translation>Es enthält die Bilder von %1 Patienten: „%2“ und „%3“ sind von zweien</translation>
    </message>
    <message>
        <source>Series %1 shows the same place as series %2, and stands in for it in the stack</source>
        <translation>Serie %1 zeigt dieselbe Stelle wie Serie %2 und steht im Stapel für sie</translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 to %4 mm between them, in which nothing was seen</source>
        <translation>Die %1 Schichten eines Stapels (%2) haben Lücken von %3 bis %4 mm, in denen nichts gesehen wurde</translation>
    </message>
    <message>
        <source>Series %1 and %2 are %3 mm apart, other slices of the stack %4 mm: a slice between them may be missing</source>
        <translation>Die Serien %1 und %2 liegen %3 mm auseinander, andere Schichten des Stapels %4 mm: zwischen ihnen fehlt vielleicht eine Schicht</translation>
    </message>
    <message numerus="yes">
        <source>%n {phase|phases} of series %2 {is|are} missing: %3 of %4 (the first is 0)</source>
        <translation>
            <numerusform>%n Phase der Serie %2 fehlt: %3 von %4 (die erste ist 0)</numerusform>
            <numerusform>%n Phasen der Serie %2 fehlen: %3 von %4 (die erste ist 0)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of series %2 {has|have} the time of another one and {is|are} left out</source>
        <translation>
            <numerusform>%n Bild der Serie %2 hat die Zeit eines anderen und wurde ausgelassen</numerusform>
            <numerusform>%n Bilder der Serie %2 haben die Zeit eines anderen und wurden ausgelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1 states a cycle of %2 ms, which is shorter than its phases; %3 ms were taken from their distance</source>
        <translation>Serie %1 nennt einen Zyklus von %2 ms, der kürzer ist als ihre Phasen; %3 ms wurden aus deren Abstand genommen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out, phase %2 of series %3 (%4)</source>
        <translation>„%1“ ist beschädigt und wurde ausgelassen, Phase %2 der Serie %3 (%4)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out (%2)</source>
        <translation>„%1“ ist beschädigt und wurde ausgelassen (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n other {file is|files are} damaged and left out</source>
        <translation>
            <numerusform>%n weitere Datei ist beschädigt und wurde ausgelassen</numerusform>
            <numerusform>%n weitere Dateien sind beschädigt und wurden ausgelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of another study left out (series %2)</source>
        <translation>
            <numerusform>%n Schicht einer anderen Studie ausgelassen (Serie %2)</numerusform>
            <numerusform>%n Schichten einer anderen Studie ausgelassen (Serie %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of the study in another frame of reference left out (series %2)</source>
        <translation>
            <numerusform>%n Schicht der Studie in einem anderen Bezugssystem ausgelassen (Serie %2)</numerusform>
            <numerusform>%n Schichten der Studie in einem anderen Bezugssystem ausgelassen (Serie %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {series|series} without the phases of a heart&apos;s cycle left out: %2</source>
        <translation>
            <numerusform>%n Serie ohne die Phasen eines Herzzyklus ausgelassen: %2</numerusform>
            <numerusform>%n Serien ohne die Phasen eines Herzzyklus ausgelassen: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 mm between them, in which nothing was seen</source>
        <translation>Die %1 Schichten eines Stapels (%2) haben Lücken von %3 mm, in denen nichts gesehen wurde</translation>
    </message>
    <message>
        <source>The directions of its rows and columns are not perpendicular</source>
        <translation>Die Richtungen seiner Zeilen und Spalten stehen nicht senkrecht aufeinander</translation>
    </message>
    <message>
        <source>export the series again</source>
        <translation>exportieren Sie die Serie noch einmal</translation>
    </message>
    <message>
        <source>The size of its pixels is unknown</source>
        <translation>Die Größe seiner Pixel ist unbekannt</translation>
    </message>
    <message>
        <source>It has no image, or images without times</source>
        <translation>Es hat kein Bild oder Bilder ohne Zeiten</translation>
    </message>
    <message>
        <source>The time of image %1 is not after the one before, within one cycle</source>
        <translation>Die Zeit von Bild %1 liegt nicht nach der des vorigen in einem Zyklus</translation>
    </message>
    <message>
        <source>Image %1 has another size than the first</source>
        <translation>Bild %1 hat eine andere Größe als das erste</translation>
    </message>
    <message>
        <source>Image %1 has grey values that are no numbers</source>
        <translation>Bild %1 hat Grauwerte, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>One labelled phase is too few for the motion between two</source>
        <translation>Eine beschriftete Phase ist zu wenig für die Bewegung zwischen zweien</translation>
    </message>
    <message>
        <source>label the end of diastole and the end of systole</source>
        <translation>beschriften Sie das Ende der Diastole und das Ende der Systole</translation>
    </message>
    <message>
        <source>phases are 0 to %1</source>
        <translation>die Phasen sind 0 bis %1</translation>
    </message>
    <message>
        <source>Phase %1 has labels twice</source>
        <translation>Phase %1 ist zweimal beschriftet</translation>
    </message>
    <message>
        <source>name each phase once</source>
        <translation>nennen Sie jede Phase einmal</translation>
    </message>
    <message>
        <source>following the tissue</source>
        <translation>Gewebe wird verfolgt</translation>
    </message>
    <message>
        <source>fitting the images</source>
        <translation>Anpassen an die Bilder</translation>
    </message>
    <message>
        <source>Terminal crest</source>
        <translation>Terminalleiste</translation>
    </message>
    <message>
        <source>From one labelled phase only a whole cycle can be followed</source>
        <translation>Von einer einzigen markierten Phase aus lässt sich nur ein ganzer Zyklus verfolgen</translation>
    </message>
    <message>
        <source>label the last phase as well</source>
        <translation>markieren Sie auch die letzte Phase</translation>
    </message>
    <message>
        <source>No phase has labels</source>
        <translation>Keine Phase hat Markierungen</translation>
    </message>
    <message>
        <source>give those of the ends of diastole and systole, as in --phase 0=ed.nrrd --phase 9=es.nrrd</source>
        <translation>geben Sie die der Enddiastole und der Endsystole an, wie in --phase 0=ed.nrrd --phase 9=es.nrrd</translation>
    </message>
    <message>
        <source>The images have no phase %1</source>
        <translation>Die Bilder haben keine Phase %1</translation>
    </message>
    <message>
        <source>their phases are 0 to %1</source>
        <translation>ihre Phasen sind 0 bis %1</translation>
    </message>
    <message>
        <source>reading the images</source>
        <translation>Bilder werden gelesen</translation>
    </message>
    <message>
        <source>The images have no series %1</source>
        <translation>Die Bilder haben keine Serie %1</translation>
    </message>
    <message>
        <source>viscera info lists the series of a study</source>
        <translation>viscera info zählt die Serien einer Studie auf</translation>
    </message>
    <message>
        <source>No image shows what is labelled: the labels seem to be in RAS where the images are in LPS</source>
        <translation>Kein Bild zeigt das Markierte: Die Markierungen scheinen in RAS zu sein, die Bilder in LPS</translation>
    </message>
    <message>
        <source>No image shows what is labelled: it lies beside all planes, or outside their pictures</source>
        <translation>Kein Bild zeigt das Markierte: Es liegt neben allen Ebenen oder außerhalb ihrer Bilder</translation>
    </message>
    <message>
        <source>take labels and images of one patient and one study, in the same axes</source>
        <translation>nehmen Sie Markierungen und Bilder eines Patienten und einer Studie in denselben Achsen</translation>
    </message>
    <message numerus="yes">
        <source>%n {plane|planes} of the study {does|do} not cross what is labelled</source>
        <translation>
            <numerusform>%n Ebene der Studie schneidet das Markierte nicht</numerusform>
            <numerusform>%n Ebenen der Studie schneiden das Markierte nicht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} nearer than 4 mm to the one before {is|are} not used</source>
        <translation>
            <numerusform>%n Schicht, die der vorigen näher als 4 mm liegt, wird nicht verwendet</numerusform>
            <numerusform>%n Schichten, die der vorigen näher als 4 mm liegen, werden nicht verwendet</numerusform>
        </translation>
    </message>
    <message>
        <source>Phase %1 has no labels</source>
        <translation>Phase %1 hat keine Markierungen</translation>
    </message>
    <message>
        <source>as in --phase 0=ed.nrrd</source>
        <translation>wie in --phase 0=ed.nrrd</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; is missing in phase %2</source>
        <translation>Die Oberfläche „%1“ fehlt in Phase %2</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; has %2 files in phase %3</source>
        <translation>Die Oberfläche „%1“ hat %2 Dateien in Phase %3</translation>
    </message>
    <message>
        <source>name a surface alike in all phases, as in ed/LV.obj and es/LV.obj</source>
        <translation>benennen Sie eine Oberfläche in allen Phasen gleich, wie in ed/LV.obj und es/LV.obj</translation>
    </message>
    <message>
        <source>give labels of one kind for all phases</source>
        <translation>geben Sie für alle Phasen Markierungen einer Art an</translation>
    </message>
    <message>
        <source>A phase has several label maps</source>
        <translation>Eine Phase hat mehrere Labelkarten</translation>
    </message>
    <message>
        <source>give one file for each phase</source>
        <translation>geben Sie für jede Phase eine Datei an</translation>
    </message>
    <message>
        <source>it shows no wall that could be followed</source>
        <translation>sie zeigt keine Wand, die sich verfolgen lässt</translation>
    </message>
    <message>
        <source>its tissue leaves the plane: it arrives %1 mm from the next label</source>
        <translation>ihr Gewebe verlässt die Ebene: Es kommt %1 mm von der nächsten Markierung an</translation>
    </message>
    <message>
        <source>its images are hardly alike around the wall</source>
        <translation>ihre Bilder ähneln sich um die Wand kaum</translation>
    </message>
    <message>
        <source>it has no image of %1 of %2 phases</source>
        <translation>sie hat kein Bild von %1 von %2 Phasen</translation>
    </message>
    <message>
        <source>only phase %1 has labels: volumes and ejection fraction are estimates, and usually too small a motion; label the end of systole too</source>
        <translation>nur Phase %1 ist markiert: Volumina und Ejektionsfraktion sind Schätzungen, meist zu kleiner Bewegung; markieren Sie auch die Endsystole</translation>
    </message>
    <message>
        <source>the images show phase %1 emptier than the labelled end of systole, phase %2, by %3 ml: label that phase</source>
        <translation>die Bilder zeigen Phase %1 um %3 ml leerer als die markierte Endsystole, Phase %2: markieren Sie jene Phase</translation>
    </message>
    <message>
        <source>the images show phase %1 fuller than the labelled end of diastole, phase %2, by %3 ml: label that phase</source>
        <translation>die Bilder zeigen Phase %1 um %3 ml voller als die markierte Enddiastole, Phase %2: markieren Sie jene Phase</translation>
    </message>
    <message>
        <source>planes of one direction only: what moves across them, such as the base, follows its neighbours</source>
        <translation>nur Ebenen einer Richtung: Was sich quer zu ihnen bewegt, wie die Basis, folgt seinen Nachbarn</translation>
    </message>
    <message>
        <source>no image shows a wall: its pose lies between those of the labels</source>
        <translation>kein Bild zeigt eine Wand: Die Pose liegt zwischen denen der Markierungen</translation>
    </message>
    <message>
        <source>the images hardly show how the wall moved</source>
        <translation>die Bilder zeigen kaum, wie sich die Wand bewegt hat</translation>
    </message>
    <message>
        <source>the tissue in the images is %1 mm from the surfaces on average</source>
        <translation>das Gewebe in den Bildern ist im Mittel %1 mm von den Oberflächen entfernt</translation>
    </message>
    <message>
        <source>the tissue would have folded: it stays nearer to the pose between the labels</source>
        <translation>das Gewebe hätte sich gefaltet: Es bleibt näher an der Pose zwischen den Markierungen</translation>
    </message>
    <message>
        <source>the tissue has %1 ml, in the labelled phases %2 to %3 ml</source>
        <translation>das Gewebe hat %1 ml, in den markierten Phasen %2 bis %3 ml</translation>
    </message>
    <message>
        <source>%1 % of what is labelled in the plane of %2 lies outside its images</source>
        <translation>%1 % des in der Ebene von %2 Markierten liegt außerhalb ihrer Bilder</translation>
    </message>
    <message>
        <source>series %1, %2</source>
        <translation>Serie %1, %2</translation>
    </message>
    <message>
        <source>slice %1, %2</source>
        <translation>Schicht %1, %2</translation>
    </message>
    <message>
        <source>Open study %1</source>
        <translation>Studie %1 öffnen</translation>
    </message>
    <message>
        <source>Close study</source>
        <translation>Studie schließen</translation>
    </message>
    <message>
        <source>There is no study to close</source>
        <translation>Es gibt keine Studie zum Schließen</translation>
    </message>
    <message>
        <source>the study %1 is not there any more (put it beside the session and open that again)</source>
        <translation>die Studie %1 ist nicht mehr da (legen Sie sie neben die Sitzung und öffnen Sie diese wieder)</translation>
    </message>
    <message>
        <source>the study cannot be opened: %1</source>
        <translation>die Studie lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>The picture of this phase is missing</source>
        <translation>Das Bild dieser Phase fehlt</translation>
    </message>
    <message>
        <source>The picture of this phase cannot be read</source>
        <translation>Das Bild dieser Phase lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>phase %1 of %2</source>
        <translation>Phase %1 von %2</translation>
    </message>
    <message>
        <source>A body surface needs a height of 30 to 250 cm and a weight of 1 to 400 kg</source>
        <translation>Eine Körperoberfläche braucht eine Größe von 30 bis 250 cm und ein Gewicht von 1 bis 400 kg</translation>
    </message>
    <message>
        <source>Per m2 of body surface</source>
        <translation>Je m2 Körperoberfläche</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Apex of the left ventricle&apos;s cavity</source>
        <translation>Spitze der Höhle der linken Kammer</translation>
    </message>
    <message>
        <source>Apex of the right ventricle&apos;s cavity</source>
        <translation>Spitze der Höhle der rechten Kammer</translation>
    </message>
    <message>
        <source>Dome of the liver</source>
        <translation>Leberkuppel</translation>
    </message>
    <message>
        <source>Lower edge of the liver</source>
        <translation>Unterer Leberrand</translation>
    </message>
    <message>
        <source>Lower edge of the spleen</source>
        <translation>Unterer Milzrand</translation>
    </message>
    <message>
        <source>Lowest point of the stomach</source>
        <translation>Tiefster Punkt des Magens</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Upper pole of the left kidney</source>
        <translation>Oberer Pol der linken Niere</translation>
    </message>
    <message>
        <source>Upper pole of the right kidney</source>
        <translation>Oberer Pol der rechten Niere</translation>
    </message>
    <message>
        <source>left atrium</source>
        <translation>linker Vorhof</translation>
    </message>
    <message>
        <source>right atrium</source>
        <translation>rechter Vorhof</translation>
    </message>
    <message>
        <source>left kidney</source>
        <translation>linke Niere</translation>
    </message>
    <message>
        <source>right kidney</source>
        <translation>rechte Niere</translation>
    </message>
    <message>
        <source>left lung</source>
        <translation>linke Lunge</translation>
    </message>
    <message>
        <source>right lung</source>
        <translation>rechte Lunge</translation>
    </message>
    <message>
        <source>right ventricle</source>
        <translation>rechte Kammer</translation>
    </message>
    <message>
        <source>the deviation of the noise</source>
        <translation>die Abweichung des Rauschens</translation>
    </message>
    <message>
        <source>the ejection fraction</source>
        <translation>die Ejektionsfraktion</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>the gap between slices</source>
        <translation>der Abstand zwischen den Schichten</translation>
    </message>
    <message>
        <source>the heart rate</source>
        <translation>die Herzfrequenz</translation>
    </message>
    <message>
        <source>the number of phases</source>
        <translation>die Zahl der Phasen</translation>
    </message>
    <message>
        <source>the number of slices</source>
        <translation>die Zahl der Schichten</translation>
    </message>
    <message>
        <source>the rate of breathing</source>
        <translation>die Atemfrequenz</translation>
    </message>
    <message>
        <source>the shift of the slices</source>
        <translation>die Verschiebung der Schichten</translation>
    </message>
    <message>
        <source>the spacing</source>
        <translation>der Abstand</translation>
    </message>
    <message>
        <source>the spacing of the fields</source>
        <translation>der Abstand der Felder</translation>
    </message>
    <message>
        <source>viscera phantom</source>
        <translation>Viscera-Phantom</translation>
    </message>
    <message>
        <source>Choose the images first</source>
        <translation>Wählen Sie zuerst die Bilder</translation>
    </message>
    <message>
        <source>Choose the labels of a phase: those of the ends of diastole and systole, where there are any</source>
        <translation>Wählen Sie die Labels einer Phase: die der Enden von Diastole und Systole, wo es welche gibt</translation>
    </message>
    <message>
        <source>Enter the phase of %1</source>
        <translation>Geben Sie die Phase von %1 ein</translation>
    </message>
    <message>
        <source>The images have %1 phases: enter another one for %2</source>
        <translation>Die Bilder haben %1 Phasen: geben Sie für %2 eine andere ein</translation>
    </message>
    <message>
        <source>%1 and %2 are both labels of phase %3</source>
        <translation>%1 und %2 sind beide Labels der Phase %3</translation>
    </message>
    <message>
        <source>Only phase %1 has labels: the motion, its volumes and ejection fractions will be estimates. Label the end of systole too, if you can</source>
        <translation>Nur Phase %1 hat Labels: die Bewegung, ihre Volumina und Ejektionsfraktionen werden Schätzungen sein. Markieren Sie auch die Endsystole, wenn Sie können</translation>
    </message>
    <message>
        <source>The images differ most from the first phase in phase %1, which has no labels: see whether the end of systole is labelled</source>
        <translation>Die Bilder unterscheiden sich in Phase %1, die keine Labels hat, am meisten von der ersten: sehen Sie nach, ob die Endsystole markiert ist</translation>
    </message>
    <message>
        <source>weight %1 %</source>
        <translation>Gewicht %1 %</translation>
    </message>
    <message>
        <source>left its plane by %1 mm, %2</source>
        <translation>hat die Ebene um %1 mm verlassen, %2</translation>
    </message>
    <message>
        <source>hardly alike, %1</source>
        <translation>kaum ähnlich, %1</translation>
    </message>
    <message>
        <source>shows no wall</source>
        <translation>zeigt keine Wand</translation>
    </message>
    <message>
        <source>no image</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>labelled</source>
        <translation>markiert</translation>
    </message>
    <message>
        <source>their phases are %1 to %2</source>
        <translation>ihre Phasen sind %1 bis %2</translation>
    </message>
    <message>
        <source>its volumes over the beat and its ejection fraction are estimates: only phase %1 has labels</source>
        <translation>seine Volumina über den Schlag und seine Ejektionsfraktion sind Schätzungen: nur Phase %1 hat Labels</translation>
    </message>
    <message>
        <source>Correct contours</source>
        <translation>Konturen korrigieren</translation>
    </message>
    <message>
        <source>%1, correction of phase %2</source>
        <translation>%1, Korrektur von Phase %2</translation>
    </message>
    <message>
        <source>correction of phase %1</source>
        <translation>Korrektur von Phase %1</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only, since the tissue would fold</source>
        <translation>Phase %1: Die korrigierte Kontur von %2 wird nur auf %3 mm genau getroffen, da sich das Gewebe sonst falten würde</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only: the handles are too far apart for its shape</source>
        <translation>Phase %1: Die korrigierte Kontur von %2 wird nur auf %3 mm genau getroffen: Die Griffe sind für ihre Form zu weit voneinander entfernt</translation>
    </message>
    <message>
        <source>The images have no slice %1</source>
        <translation>Die Bilder haben keine Schicht %1</translation>
    </message>
    <message>
        <source>their slices are 0 to %1</source>
        <translation>ihre Schichten sind 0 bis %1</translation>
    </message>
    <message>
        <source>The corrected contour lies %1 mm beside the plane of %2</source>
        <translation>Die korrigierte Kontur liegt %1 mm neben der Ebene von %2</translation>
    </message>
    <message>
        <source>give points in the plane of one slice, mm in LPS</source>
        <translation>geben Sie Punkte in der Ebene einer Schicht an, mm in LPS</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact: only phases between them are corrected</source>
        <translation>Phase %1 hat Labels, und die sind genau: Nur Phasen dazwischen werden korrigiert</translation>
    </message>
    <message>
        <source>change its labels, or leave this correction out</source>
        <translation>ändern Sie ihre Labels, oder lassen Sie diese Korrektur weg</translation>
    </message>
    <message>
        <source>A corrected contour has no points</source>
        <translation>Eine korrigierte Kontur hat keine Punkte</translation>
    </message>
    <message>
        <source>give three numbers for each of them, mm</source>
        <translation>geben Sie für jeden drei Zahlen an, mm</translation>
    </message>
    <message>
        <source>The handles are no longer those of the motion that was found in the images</source>
        <translation>Die Griffe sind nicht mehr die der Bewegung, die in den Bildern gefunden wurde</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the handles</source>
        <translation>suchen Sie die Bewegung erneut, oder machen Sie die Änderung der Griffe rückgängig</translation>
    </message>
    <message>
        <source>There is no key at phase %1 any more</source>
        <translation>An Phase %1 gibt es keine Pose mehr</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the keys</source>
        <translation>suchen Sie die Bewegung erneut, oder machen Sie die Änderung der Posen rückgängig</translation>
    </message>
    <message>
        <source>It has no points, or is of no surface that is fitted</source>
        <translation>Sie hat keine Punkte oder gehört zu keiner angepassten Oberfläche</translation>
    </message>
    <message>
        <source>give the points of a contour</source>
        <translation>geben Sie die Punkte einer Kontur an</translation>
    </message>
    <message>
        <source>Phase %1 does not lie between labelled phases</source>
        <translation>Phase %1 liegt nicht zwischen Phasen mit Labels</translation>
    </message>
    <message>
        <source>correct a phase that the images are fitted in</source>
        <translation>korrigieren Sie eine Phase, in der an die Bilder angepasst wird</translation>
    </message>
    <message>
        <source>meeting corrected contours</source>
        <translation>an korrigierte Konturen anpassen</translation>
    </message>
    <message>
        <source>The %1 is damaged and left out: %2</source>
        <translation>Beschädigt und ausgelassen: %1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n more {phase is|phases are} damaged and left out</source>
        <translation>
            <numerusform>%n weitere Phase ist beschädigt und ausgelassen</numerusform>
            <numerusform>%n weitere Phasen sind beschädigt und ausgelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 x %2 x %3 voxels, others %4 x %5 x %6</source>
        <translation>sie hat %1 x %2 x %3 Voxel, andere %4 x %5 x %6</translation>
    </message>
    <message>
        <source>phase %1 %</source>
        <translation>Phase %1 %</translation>
    </message>
    <message>
        <source>The %1 shows the same instant as the %2, and is left out</source>
        <translation>%1 zeigt denselben Augenblick wie %2 und ist ausgelassen</translation>
    </message>
    <message>
        <source>Its phases are kept as 16 bits a voxel, to a 65,000th of their range</source>
        <translation>Seine Phasen werden mit 16 Bit je Voxel gehalten, auf ein 65.000stel ihres Bereichs</translation>
    </message>
    <message>
        <source>Its phases need %1 GB, of which %2 GB are kept at a time; the others are read again when they are shown</source>
        <translation>Seine Phasen brauchen %1 GB, von denen %2 GB zugleich gehalten werden; die anderen werden gelesen, wenn sie gezeigt werden</translation>
    </message>
    <message>
        <source>It is packed, or keeps its phases beside each other, so that each of them is read as slowly as all; save it unpacked to move through it</source>
        <translation>Er ist gepackt oder hat seine Phasen nebeneinander, so dass jede so langsam gelesen wird wie alle; entpackt gespeichert lässt er sich durchfahren</translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as seconds</source>
        <translation>Die Einheit seiner Zeiten ist nicht angegeben; sie gelten als Sekunden</translation>
    </message>
    <message>
        <source>the session holds one phase of this scan; open its file again for the others</source>
        <translation>die Sitzung enthält eine Phase dieses Scans; öffnen Sie für die anderen wieder seine Datei</translation>
    </message>
    <message>
        <source>Series %1 states %2 phases and has %3</source>
        <translation>Serie %1 gibt %2 Phasen an und hat %3</translation>
    </message>
    <message>
        <source>Series %1: %2</source>
        <translation>Serie %1: %2</translation>
    </message>
    <message>
        <source>Series %1 is left out: &quot;%2&quot; %3</source>
        <translation>Serie %1 ist weggelassen: „%2“ %3</translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of %2 {is|are} empty and left out: %3</source>
        <translation>
            <numerusform>%n Bild von %2 ist leer und weggelassen: %3</numerusform>
            <numerusform>%n Bilder von %2 sind leer und weggelassen: %3</numerusform>
        </translation>
    </message>
    <message>
        <source>free handles cannot follow: these coordinates are not linear in the handles</source>
        <translation>freie Griffe können nicht folgen: diese Koordinaten sind nicht linear in den Griffen</translation>
    </message>
    <message>
        <source>choose another coordinate system</source>
        <translation>wählen Sie ein anderes Koordinatensystem</translation>
    </message>
    <message>
        <source>free handles cannot follow: there is no witness point in the tissue</source>
        <translation>freie Griffe können nicht folgen: es gibt keinen Zeugenpunkt im Gewebe</translation>
    </message>
    <message>
        <source>place the handles around an organ that encloses a volume</source>
        <translation>setzen Sie die Griffe um ein Organ, das ein Volumen umschließt</translation>
    </message>
    <message>
        <source>unlock it, or move the handles less far</source>
        <translation>entsperren Sie es, oder bewegen Sie die Griffe weniger weit</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Von-Mises-Spannung</translation>
    </message>
    <message>
        <source>Maximum von Mises stress</source>
        <translation>Größte Von-Mises-Spannung</translation>
    </message>
    <message>
        <source>The stress that shears the tissue, if it is the stated material; the change of its volume has no part in it.</source>
        <translation>Die Spannung, die das Gewebe schert, wenn es das angegebene Material ist; die Änderung seines Volumens hat daran keinen Anteil.</translation>
    </message>
    <message>
        <source>Strain energy density</source>
        <translation>Dichte der Verformungsenergie</translation>
    </message>
    <message>
        <source>Maximum strain energy density</source>
        <translation>Größte Dichte der Verformungsenergie</translation>
    </message>
    <message>
        <source>The energy for each volume at rest, if the tissue is the stated material; with what the change of its volume takes.</source>
        <translation>Die Energie je Volumen in Ruhe, wenn das Gewebe das angegebene Material ist; mit dem, was die Änderung seines Volumens kostet.</translation>
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
        <translation>Herzmuskel</translation>
    </message>
    <message>
        <source>kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>pancreas</source>
        <translation>Bauchspeicheldrüse</translation>
    </message>
    <message>
        <source>Pascals are of a stated material: %1.</source>
        <translation>Pascal gelten für ein angegebenes Material: %1.</translation>
    </message>
    <message>
        <source>Interventricular septum</source>
        <translation>Kammerseptum</translation>
    </message>
    <message>
        <source>Interatrial septum</source>
        <translation>Vorhofseptum</translation>
    </message>
    <message>
        <source>Oval fossa</source>
        <translation>Fossa ovalis</translation>
    </message>
    <message>
        <source>Opening of the coronary sinus</source>
        <translation>Mündung des Sinus coronarius</translation>
    </message>
    <message>
        <source>Valve of the coronary sinus</source>
        <translation>Klappe des Sinus coronarius</translation>
    </message>
    <message>
        <source>the limit of Doppler ultrasound, which no study of its own gives; measured by catheter since Gleason and Braunwald 1962, doi 10.1172/JCI104469</source>
        <translation>Grenze der Dopplersonografie, die keine eigene Studie angibt; mit dem Katheter gemessen seit Gleason und Braunwald 1962, doi 10.1172/JCI104469</translation>
    </message>
    <message>
        <source>customary; how much people at rest differ: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</source>
        <translation>üblich; wie sehr sich Menschen in Ruhe unterscheiden: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</translation>
    </message>
    <message numerus="yes">
        <source>%n {point or open contour was|points and open contours were} left out</source>
        <translation>
            <numerusform>%n Punkt oder offene Kontur wurde weggelassen</numerusform>
            <numerusform>%n Punkte und offene Konturen wurden weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was|contours were} left out, whose numbers cannot be read</source>
        <translation>
            <numerusform>%n Kontur wurde weggelassen, deren Zahlen nicht lesbar sind</numerusform>
            <numerusform>%n Konturen wurden weggelassen, deren Zahlen nicht lesbar sind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was left out, which lies|contours were left out, which lie} in another direction than most</source>
        <translation>
            <numerusform>%n Kontur wurde weggelassen, die in einer anderen Richtung liegt als die meisten</numerusform>
            <numerusform>%n Konturen wurden weggelassen, die in einer anderen Richtung liegen als die meisten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {region was left out, which is|regions were left out, which are} in another coordinate system (frame of reference)</source>
        <translation>
            <numerusform>%n Region wurde weggelassen, die in einem anderen Koordinatensystem liegt (Frame of Reference)</numerusform>
            <numerusform>%n Regionen wurden weggelassen, die in einem anderen Koordinatensystem liegen (Frame of Reference)</numerusform>
        </translation>
    </message>
    <message>
        <source>all contours lie in one plane, whose thickness is not stated; %1 mm were taken</source>
        <translation>alle Konturen liegen in einer Ebene, deren Dicke nicht angegeben ist; %1 mm wurden angenommen</translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of %2 without a contour got the shape between their neighbours</source>
        <translation>
            <numerusform>%n Schicht von %2 ohne Kontur hat die Form zwischen ihren Nachbarn bekommen</numerusform>
            <numerusform>%n Schichten von %2 ohne Kontur haben die Form zwischen ihren Nachbarn bekommen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no contour over %2 mm; that gap stays open</source>
        <translation>%1 hat auf %2 mm keine Kontur; diese Lücke bleibt offen</translation>
    </message>
    <message>
        <source>It is a structure set without regions of interest</source>
        <translation>Es ist ein Structure Set ohne Regionen</translation>
    </message>
    <message>
        <source>export the contours again</source>
        <translation>die Konturen noch einmal exportieren</translation>
    </message>
    <message>
        <source>It is a structure set without closed contours, so that there is no organ in it</source>
        <translation>Es ist ein Structure Set ohne geschlossene Konturen und enthält daher kein Organ</translation>
    </message>
    <message>
        <source>export the structures as closed planar contours</source>
        <translation>die Strukturen als geschlossene ebene Konturen exportieren</translation>
    </message>
    <message>
        <source>No voxel of the grid lies within the organ</source>
        <translation>Kein Voxel des Gitters liegt im Organ</translation>
    </message>
    <message>
        <source>choose the scan that shows it, or smaller voxels</source>
        <translation>den Scan wählen, der es zeigt, oder kleinere Voxel</translation>
    </message>
    <message>
        <source>choose the scan that shows it</source>
        <translation>den Scan wählen, der es zeigt</translation>
    </message>
    <message>
        <source>There are fewer than two images to lay a segmentation on</source>
        <translation>Es gibt weniger als zwei Bilder, auf die eine Segmentierung gelegt werden könnte</translation>
    </message>
    <message>
        <source>choose a series of slices</source>
        <translation>eine Serie von Schichten wählen</translation>
    </message>
    <message>
        <source>The images lie at unequal distances, so that they have no grid</source>
        <translation>Die Bilder liegen in ungleichen Abständen und haben daher kein Gitter</translation>
    </message>
    <message>
        <source>write the segmentation on a grid of its own</source>
        <translation>die Segmentierung auf einem eigenen Gitter schreiben</translation>
    </message>
    <message>
        <source>The size of voxels has to be positive</source>
        <translation>Die Größe der Voxel muss positiv sein</translation>
    </message>
    <message>
        <source>The organs are too large for voxels of that size</source>
        <translation>Die Organe sind für Voxel dieser Größe zu groß</translation>
    </message>
    <message>
        <source>choose larger voxels</source>
        <translation>größere Voxel wählen</translation>
    </message>
    <message>
        <source>No image of the scan crosses the organ</source>
        <translation>Kein Bild des Scans schneidet das Organ</translation>
    </message>
    <message>
        <source>Contours need the images whose planes they lie in</source>
        <translation>Konturen brauchen die Bilder, in deren Ebenen sie liegen</translation>
    </message>
    <message>
        <source>open the DICOM scan of the organs, or write a segmentation</source>
        <translation>den DICOM-Scan der Organe öffnen oder eine Segmentierung schreiben</translation>
    </message>
    <message>
        <source>It is no PDF document</source>
        <translation>Es ist kein PDF-Dokument</translation>
    </message>
    <message>
        <source>There is no DICOM image whose patient and study could be taken</source>
        <translation>Es gibt kein DICOM-Bild, dessen Patient und Studie übernommen werden könnten</translation>
    </message>
    <message>
        <source>name the folder of the images that the organs were made from</source>
        <translation>den Ordner der Bilder nennen, aus denen die Organe gemacht wurden</translation>
    </message>
    <message>
        <source>It has no measurement</source>
        <translation>Es hat keine Messung</translation>
    </message>
    <message>
        <source>Its segment is named without the segmentation</source>
        <translation>Sein Segment ist ohne die Segmentierung genannt</translation>
    </message>
    <message>
        <source>write the segmentation too</source>
        <translation>auch die Segmentierung schreiben</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>noch einmal exportieren oder kopieren</translation>
    </message>
    <message>
        <source>key sequence</source>
        <translation>Schlüsselbildfolge</translation>
    </message>
    <message>
        <source>as in %1</source>
        <translation>wie in %1</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Kontur korrigieren</translation>
    </message>
    <message>
        <source>It is a segmentation over time: its frames show several phases at one place</source>
        <translation>Es ist eine Segmentierung über die Zeit: Ihre Bilder zeigen mehrere Phasen an einem Ort</translation>
    </message>
    <message>
        <source>The archive %1 cannot be reached</source>
        <translation>Das Archiv %1 ist nicht erreichbar</translation>
    </message>
    <message>
        <source>Check its address and port, and whether it runs</source>
        <translation>Prüfen Sie Adresse und Port, und ob es läuft</translation>
    </message>
    <message>
        <source>The archive %1 does not answer</source>
        <translation>Das Archiv %1 antwortet nicht</translation>
    </message>
    <message>
        <source>Try again; the archive or the network may be slow</source>
        <translation>Versuchen Sie es noch einmal; Archiv oder Netz sind vielleicht langsam</translation>
    </message>
    <message>
        <source>The archive %1 refuses the titles: it is called %2, and this program %3</source>
        <translation>Das Archiv %1 lehnt die Titel ab: es wird %2 genannt, dieses Programm %3</translation>
    </message>
    <message>
        <source>Ask its administrator for its title, and to allow that of this program</source>
        <translation>Fragen Sie den Verwalter nach dem Titel, und lassen Sie den dieses Programms zu</translation>
    </message>
    <message>
        <source>The archive %1 refuses the user name or the password</source>
        <translation>Das Archiv %1 lehnt Benutzernamen oder Passwort ab</translation>
    </message>
    <message>
        <source>Type both again</source>
        <translation>Geben Sie beide noch einmal ein</translation>
    </message>
    <message>
        <source>The certificate of the archive %1 is not trusted</source>
        <translation>Dem Zertifikat des Archivs %1 wird nicht vertraut</translation>
    </message>
    <message>
        <source>Name the file with its issuer&apos;s certificate in the connection</source>
        <translation>Nennen Sie in der Verbindung die Datei mit dem Zertifikat seines Ausstellers</translation>
    </message>
    <message>
        <source>The connection to the archive %1 was cut</source>
        <translation>Die Verbindung zum Archiv %1 ist abgerissen</translation>
    </message>
    <message>
        <source>Try again; nothing incomplete is kept</source>
        <translation>Versuchen Sie es noch einmal; Unvollständiges bleibt nicht</translation>
    </message>
    <message>
        <source>The answer of the archive %1 is not DICOM</source>
        <translation>Die Antwort des Archivs %1 ist kein DICOM</translation>
    </message>
    <message>
        <source>Check its address</source>
        <translation>Prüfen Sie die Adresse</translation>
    </message>
    <message>
        <source>The archive %1 refuses: %2</source>
        <translation>Das Archiv %1 lehnt ab: %2</translation>
    </message>
    <message>
        <source>Ask its administrator</source>
        <translation>Fragen Sie den Verwalter</translation>
    </message>
    <message>
        <source>The archive %1 does not offer %2</source>
        <translation>Das Archiv %1 bietet %2 nicht an</translation>
    </message>
    <message>
        <source>The archive %1 has not kept %2 of %3 files</source>
        <translation>Das Archiv %1 hat %2 von %3 Dateien nicht behalten</translation>
    </message>
    <message>
        <source>The archive %1 has no such series</source>
        <translation>Das Archiv %1 hat keine solche Serie</translation>
    </message>
    <message>
        <source>What was received cannot be written</source>
        <translation>Das Empfangene kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Is the disk full?</source>
        <translation>Ist die Platte voll?</translation>
    </message>
    <message>
        <source>Ask the archive %1</source>
        <translation>Archiv %1 fragen</translation>
    </message>
    <message>
        <source>Receive image %1</source>
        <translation>Bild %1 empfangen</translation>
    </message>
    <message>
        <source>Send image %1</source>
        <translation>Bild %1 senden</translation>
    </message>
    <message>
        <source>The folder is there already</source>
        <translation>Den Ordner gibt es schon</translation>
    </message>
    <message>
        <source>The folder cannot be made</source>
        <translation>Der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>The file is no DICOM file</source>
        <translation>Die Datei ist keine DICOM-Datei</translation>
    </message>
    <message>
        <source>The certificates cannot be read</source>
        <translation>Die Zertifikate lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>It is no list of archives</source>
        <translation>Es ist keine Liste von Archiven</translation>
    </message>
    <message>
        <source>this service</source>
        <translation>diesen Dienst</translation>
    </message>
    <message>
        <source>The address of the archive %1 is not known to the network</source>
        <translation>Die Adresse des Archivs %1 ist dem Netz nicht bekannt</translation>
    </message>
    <message>
        <source>Check how its address is spelt</source>
        <translation>Prüfen Sie, wie die Adresse geschrieben ist</translation>
    </message>
    <message>
        <source>There is no secure connection (TLS) to the archive %1</source>
        <translation>Es gibt keine sichere Verbindung (TLS) zum Archiv %1</translation>
    </message>
    <message>
        <source>Ask its administrator whether this port takes TLS, and of which version</source>
        <translation>Fragen Sie den Verwalter, ob dieser Port TLS annimmt und in welcher Version</translation>
    </message>
    <message>
        <source>the images are not there any more (the archive %1 has them)</source>
        <translation>die Bilder sind nicht mehr da (das Archiv %1 hat sie)</translation>
    </message>
    <message>
        <source>There is no key ring that keeps the password</source>
        <translation>Es gibt keinen Schlüsselbund, der das Passwort behält</translation>
    </message>
    <message>
        <source>it counts little in %1 of %2 phases, in which its tissue leaves the plane or its images are unlike</source>
        <translation>sie zählt in %1 von %2 Phasen wenig, in denen ihr Gewebe die Ebene verlässt oder ihre Bilder einander nicht gleichen</translation>
    </message>
    <message>
        <source>%1 is left out: its surface is open</source>
        <translation>%1 wird ausgelassen: die Oberfläche ist offen</translation>
    </message>
    <message>
        <source>the scan&apos;s DICOM files are not there: the objects get a study of their own</source>
        <translation>die DICOM-Dateien der Aufnahme sind nicht da: Die Objekte bekommen eine eigene Studie</translation>
    </message>
    <message>
        <source>The report names the patient or the files, and identity is to be removed</source>
        <translation>Der Bericht nennt den Patienten oder die Dateien, und die Identität soll entfernt werden</translation>
    </message>
    <message>
        <source>leave the report out, or make one without the patient</source>
        <translation>den Bericht weglassen oder einen ohne den Patienten anfertigen</translation>
    </message>
    <message>
        <source>The report holds the patient&apos;s name or number</source>
        <translation>Der Bericht enthält Namen oder Nummer des Patienten</translation>
    </message>
    <message>
        <source>leave the report out</source>
        <translation>lassen Sie den Bericht weg</translation>
    </message>
    <message>
        <source>No DICOM object is chosen</source>
        <translation>Es ist kein DICOM-Objekt gewählt</translation>
    </message>
    <message>
        <source>choose one at least</source>
        <translation>wählen Sie mindestens eines</translation>
    </message>
    <message>
        <source>There is no organ to write</source>
        <translation>Es gibt kein Organ zu schreiben</translation>
    </message>
    <message>
        <source>There is no organ with a closed surface to write as DICOM</source>
        <translation>Es gibt kein Organ mit geschlossener Oberfläche, das als DICOM geschrieben werden kann</translation>
    </message>
    <message>
        <source>close it first</source>
        <translation>schließen Sie sie zuerst</translation>
    </message>
    <message>
        <source>The number of phases is 0 to 200</source>
        <translation>Die Zahl der Phasen ist 0 bis 200</translation>
    </message>
    <message>
        <source>the file is there already</source>
        <translation>die Datei ist schon da</translation>
    </message>
    <message>
        <source>choose an empty folder</source>
        <translation>wählen Sie einen leeren Ordner</translation>
    </message>
    <message>
        <source>there is no such series</source>
        <translation>eine solche Serie gibt es nicht</translation>
    </message>
    <message>
        <source>one mesh says nothing about the others</source>
        <translation>ein Netz sagt nichts über die anderen</translation>
    </message>
    <message>
        <source>give two sizes at least</source>
        <translation>geben Sie mindestens zwei Größen an</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or export a segmentation of each phase</source>
        <translation>Verfolgen Sie die Bewegung über alle mit viscera track %1, oder exportieren Sie eine Segmentierung je Phase</translation>
    </message>
</context>
<context>
    <name>viscera::app</name>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Fetching from %1</source>
        <translation>Wird von %1 geholt</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>%1 (estimate)</source>
        <translation>%1 (Schätzung)</translation>
    </message>
    <message>
        <source>Planes of the images</source>
        <translation>Ebenen der Bilder</translation>
    </message>
    <message>
        <source>Cine study</source>
        <translation>Cine-Studie</translation>
    </message>
    <message>
        <source>Use the sequence&apos;s handles</source>
        <translation>Griffe der Sequenz verwenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Circulation</source>
        <translation>Kreislauf</translation>
    </message>
    <message>
        <source>Sample %1</source>
        <translation>Beispiel %1</translation>
    </message>
    <message>
        <source>Organs (%1)</source>
        <translation>Organe (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Prescribe a volume</source>
        <translation>Volumen vorgeben</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Cut away the front</source>
        <translation>Vorderen Teil wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the upper part</source>
        <translation>Oberen Teil wegschneiden</translation>
    </message>
    <message>
        <source>Facing the viewer</source>
        <translation>Zum Betrachter</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message numerus="yes">
        <source>%n handles</source>
        <translation>
            <numerusform>%n Griff</numerusform>
            <numerusform>%n Griffe</numerusform>
        </translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Rest error</source>
        <translation>Ruhefehler</translation>
    </message>
    <message>
        <source>The largest distance of the bound organ at rest from the original</source>
        <translation>Der größte Abstand des gebundenen Organs in Ruhe vom Original</translation>
    </message>
    <message>
        <source>Smallest weight</source>
        <translation>Kleinstes Gewicht</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>There is no organ to export. Open one first.</source>
        <translation>Kein Organ zum Exportieren vorhanden. Öffnen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>In %1 geschrieben.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Look for files...</source>
        <translation>Dateien suchen...</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Place the sequence&apos;s handles around the organ and play it</source>
        <translation>Die Griffe der Sequenz um das Organ setzen und sie abspielen</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Farbe...</translation>
    </message>
    <message numerus="yes">
        <source>Move %n handles</source>
        <translation>
            <numerusform>%n Griff bewegen</numerusform>
            <numerusform>%n Griffe bewegen</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle %1</source>
        <translation>Griff %1 bewegen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Stress</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Duration of one cycle</source>
        <translation>Dauer eines Zyklus</translation>
    </message>
    <message>
        <source>Export lesson</source>
        <translation>Lektion exportieren</translation>
    </message>
    <message>
        <source>Motion from a series</source>
        <translation>Bewegung aus einer Serie</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Time in the cycle</source>
        <translation>Zeit im Zyklus</translation>
    </message>
</context>
</TS>
