<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Lesson</name>
    <message>
        <source>The organs in three dimensions</source>
        <translation>Die Organe in drei Dimensionen</translation>
    </message>
    <message>
        <source>%1. Drag or use the arrow keys to turn, two fingers, the wheel or plus and minus to come nearer.</source>
        <translation>%1. Ziehen oder Pfeiltasten drehen, zwei Finger, das Mausrad oder Plus und Minus ändern den Abstand.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Folien</translation>
    </message>
    <message>
        <source>Quiz</source>
        <translation>Quiz</translation>
    </message>
    <message>
        <source>Light or dark (T)</source>
        <translation>Hell oder dunkel (T)</translation>
    </message>
    <message>
        <source>Seen from (1, 3, 7)</source>
        <translation>Gesehen von (1, 3, 7)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Names of the parts (N)</source>
        <translation>Namen der Teile (N)</translation>
    </message>
    <message>
        <source>Handles to drag (H)</source>
        <translation>Griffe zum Ziehen (H)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Drag a handle.</source>
        <translation>Ziehen Sie an einem Griff.</translation>
    </message>
    <message>
        <source>Handle %1: arrow keys, plus and minus move it.</source>
        <translation>Griff %1: Pfeiltasten, Plus und Minus bewegen ihn.</translation>
    </message>
    <message>
        <source>Previous slide (Page Up)</source>
        <translation>Vorige Folie (Bild auf)</translation>
    </message>
    <message>
        <source>Next slide (Page Down)</source>
        <translation>Nächste Folie (Bild ab)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
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
        <translation>%1 % der Ruhe</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1: Ejektions­fraktion</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Herzminuten­volumen</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normal %1</translation>
    </message>
    <message>
        <source>%1 of healthy people</source>
        <translation>%1, gesunde Menschen</translation>
    </message>
    <message>
        <source>without handles %1</source>
        <translation>ohne Griffe %1</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Moment of the cycle</source>
        <translation>Zeitpunkt im Zyklus</translation>
    </message>
    <message>
        <source>%1 s, %2</source>
        <translation>%1 s, %2</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 pro Minute</translation>
    </message>
    <message>
        <source>Volumes over one cycle: %1</source>
        <translation>Volumina über einen Zyklus: %1</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Space: play or stop
Arrow keys: turn the picture when it has the focus, else go through the cycle
Plus, minus: nearer, farther
Page Down, Page Up: next and previous slide; B: dark screen
J, K: choose a handle; arrow keys, plus and minus move it; Escape lets it go
1, 3, 7: front, left, above
N: names, H: handles, X: wall, R: reset, T: light or dark, Home: beginning</source>
        <translation>Leertaste: abspielen oder anhalten
Pfeiltasten: das Bild drehen, wenn es den Fokus hat, sonst durch den Zyklus gehen
Plus, Minus: näher, weiter weg
Bild ab, Bild auf: nächste und vorige Folie; B: dunkler Bildschirm
J, K: einen Griff wählen; Pfeiltasten, Plus und Minus bewegen ihn; Escape lässt ihn los
1, 3, 7: vorn, links, oben
N: Namen, H: Griffe, X: Wand, R: zurück, T: hell oder dunkel, Pos1: Anfang</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Leave the quiz</source>
        <translation>Quiz verlassen</translation>
    </message>
    <message>
        <source>What is marked?</source>
        <translation>Was ist markiert?</translation>
    </message>
    <message>
        <source>Which phase is this?</source>
        <translation>Welche Phase ist das?</translation>
    </message>
    <message>
        <source>Which chamber shrinks now?</source>
        <translation>Welche Herzhöhle wird jetzt kleiner?</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Richtig.</translation>
    </message>
    <message>
        <source>No. The answer is: %1.</source>
        <translation>Nein. Die Antwort ist: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%1 von %2 richtig</translation>
    </message>
    <message>
        <source>%1 of %2 right.</source>
        <translation>%1 von %2 richtig.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later.</source>
        <translation>Diese Lektion braucht einen Browser von 2023 oder später.</translation>
    </message>
    <message>
        <source>This lesson needs WebGL 2. It may be switched off in this browser.</source>
        <translation>Diese Lektion braucht WebGL 2. Vielleicht ist es in diesem Browser ausgeschaltet.</translation>
    </message>
    <message>
        <source>The graphics were lost. Load the page again.</source>
        <translation>Die Grafik ging verloren. Laden Sie die Seite neu.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later, with JavaScript and WebGL 2.</source>
        <translation>Diese Lektion braucht einen Browser von 2023 oder später, mit JavaScript und WebGL 2.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Normal range</source>
        <translation>Normbereich</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>Text of the slide</source>
        <translation>Text der Folie</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>Volumen nach einer Mahlzeit</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of your language (BCP 47): numbers are written as it does.</extracomment>
        <translation>de</translation>
    </message>
    <message>
        <source>For teaching. It is not a medical device.</source>
        <translation>Für den Unterricht. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Herzschlag</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Magenperistaltik</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Welle im Magencorpus</translation>
    </message>
    <message>
        <source>Terminal antral contraction</source>
        <translation>Terminale antrale Kontraktion</translation>
    </message>
    <message>
        <source>Wave fades at the pylorus</source>
        <translation>Welle verebbt am Pylorus</translation>
    </message>
    <message>
        <source>Back to the original shape (R)</source>
        <translation>Zurück zur ursprünglichen Form (R)</translation>
    </message>
    <message>
        <source>%1 % from moved handles</source>
        <translation>%1 % durch bewegte Griffe</translation>
    </message>
    <message>
        <source>Label in the view</source>
        <translation>Beschriftung in der Ansicht</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>Open the heart and look into it (C)</source>
        <translation>Das Herz öffnen und hineinsehen (C)</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>Blood in the opened chambers (F)</source>
        <translation>Blut in den geöffneten Höhlen (F)</translation>
    </message>
    <message>
        <source>Conduction</source>
        <translation>Erregung</translation>
    </message>
    <message>
        <source>Conduction system, lit with the electrocardiogram (E)</source>
        <translation>Erregungsleitung, leuchtet mit dem Elektrokardiogramm (E)</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>EKG</translation>
    </message>
    <message>
        <source>C: cut open, F: blood, E: conduction system</source>
        <translation>C: aufschneiden, F: Blut, E: Erregungsleitung</translation>
    </message>
</context>
<context>
    <name>NewFile</name>
    <message>
        <source>Replace the file?</source>
        <translation>Datei ersetzen?</translation>
    </message>
    <message>
        <source>%1 already exists. Do you want to replace it?</source>
        <translation>%1 ist schon vorhanden. Soll die Datei ersetzt werden?</translation>
    </message>
</context>
<context>
    <name>OrganLooks</name>
    <message>
        <source>Show only this</source>
        <translation>Nur dieses zeigen</translation>
    </message>
</context>
<context>
    <name>Tissue</name>
    <message>
        <source>Muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>Bowel</source>
        <translation>Darm</translation>
    </message>
    <message>
        <source>Arterial blood</source>
        <translation>Arterielles Blut</translation>
    </message>
    <message>
        <source>Venous blood</source>
        <translation>Venöses Blut</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Andere Farbe...</translation>
    </message>
    <message>
        <source>Bile</source>
        <translation>Galle</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveActions</name>
    <message>
        <source>From the &amp;archive...</source>
        <translation>Aus dem &amp;Archiv...</translation>
    </message>
    <message>
        <source>Search a hospital&apos;s archive (PACS) for a patient and open a series</source>
        <translation>Im Archiv einer Klinik (PACS) einen Patienten suchen und eine Serie öffnen</translation>
    </message>
    <message>
        <source>No archive is called %1 here. Add it, then open the session again.</source>
        <translation>Kein Archiv heißt hier %1. Fügen Sie es hinzu, und öffnen Sie die Sitzung noch einmal.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveClient</name>
    <message>
        <source>Forgetting the password</source>
        <translation>Passwort wird vergessen</translation>
    </message>
    <message>
        <source>Testing %1</source>
        <translation>%1 wird getestet</translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation>%1 wird durchsucht</translation>
    </message>
    <message>
        <source>Sending to %1</source>
        <translation>Wird an %1 gesendet</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveDialog</name>
    <message>
        <source>The beginning of the name; * stands for any letters</source>
        <translation>Der Anfang des Namens; * steht für beliebige Buchstaben</translation>
    </message>
    <message>
        <source>The beginning of the number of the patient</source>
        <translation>Der Anfang der Nummer des Patienten</translation>
    </message>
    <message>
        <source>The first day of the study, as 2024-03-01</source>
        <translation>Der erste Tag der Studie, etwa 2024-03-01</translation>
    </message>
    <message>
        <source>The last day of the study, as 2024-03-31</source>
        <translation>Der letzte Tag der Studie, etwa 2024-03-31</translation>
    </message>
    <message>
        <source>From the archive</source>
        <translation>Aus dem Archiv</translation>
    </message>
    <message>
        <source>Fetch what is chosen and open it</source>
        <translation>Holen und öffnen, was gewählt ist</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>The archive to search</source>
        <translation>Das Archiv, das durchsucht wird</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Hinzufügen...</translation>
    </message>
    <message>
        <source>Name another archive</source>
        <translation>Ein weiteres Archiv nennen</translation>
    </message>
    <message>
        <source>Edit...</source>
        <translation>Bearbeiten...</translation>
    </message>
    <message>
        <source>Change the address and the titles of this archive</source>
        <translation>Adresse und Titel dieses Archivs ändern</translation>
    </message>
    <message>
        <source>Forget this archive and its password</source>
        <translation>Dieses Archiv und sein Passwort vergessen</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Ask whether the archive answers</source>
        <translation>Fragen, ob das Archiv antwortet</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Jede</translation>
    </message>
    <message>
        <source>Only studies with images of this kind</source>
        <translation>Nur Studien mit Bildern dieser Art</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>List the studies that match (Return)</source>
        <translation>Die passenden Studien auflisten (Eingabetaste)</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>Name des Patienten</translation>
    </message>
    <message>
        <source>Patient&apos;s number</source>
        <translation>Nummer des Patienten</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>JJJJ-MM-TT</translation>
    </message>
    <message>
        <source>Studies and series</source>
        <translation>Studien und Serien</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Stop; nothing incomplete is kept</source>
        <translation>Anhalten; nichts Unvollständiges bleibt</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was kept.</source>
        <translation>Abgebrochen. Nichts wurde behalten.</translation>
    </message>
    <message>
        <source>No archive is named yet. Add one: its address, and for the classic services its title.</source>
        <translation>Noch ist kein Archiv genannt. Fügen Sie eines hinzu: seine Adresse, und für die klassischen Dienste seinen Titel.</translation>
    </message>
    <message>
        <source>Remove the archive?</source>
        <translation>Archiv entfernen?</translation>
    </message>
    <message>
        <source>Forget %1 and its password?</source>
        <translation>%1 und sein Passwort vergessen?</translation>
    </message>
    <message>
        <source>%1 answers.</source>
        <translation>%1 antwortet.</translation>
    </message>
    <message>
        <source>%1 is no day. Write it as 2024-03-01.</source>
        <translation>%1 ist kein Tag. Schreiben Sie ihn als 2024-03-01.</translation>
    </message>
    <message>
        <source>No study matches.</source>
        <translation>Keine Studie passt.</translation>
    </message>
    <message numerus="yes">
        <source>%n studies. Open one to see its series.</source>
        <translation>
            <numerusform>%n Studie. Klappen Sie sie auf, um ihre Serien zu sehen.</numerusform>
            <numerusform>%n Studien. Klappen Sie eine auf, um ihre Serien zu sehen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>This study has no series.</source>
        <translation>Diese Studie hat keine Serien.</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Studie öffnen</translation>
    </message>
</context>
<context>
    <name>viscera::app::AxisPicker</name>
    <message>
        <source>Axes of the heart, from which segments count: set by clicks</source>
        <translation>Achsen des Herzens, von denen an Segmente zählen: durch Klicks setzen</translation>
    </message>
    <message>
        <source>Anterior insertion of the right ventricle</source>
        <translation>Vordere Insertion des rechten Ventrikels</translation>
    </message>
</context>
<context>
    <name>viscera::app::BeatStrip</name>
    <message>
        <source>Electrocardiogram, heart sounds and valves</source>
        <translation>Elektrokardiogramm, Herztöne und Klappen</translation>
    </message>
    <message>
        <source>Schematic electrocardiogram, heart sounds S1 and S2 when the valves close, and a bar for each valve while it is open. The lamp is lit while the valve is open.</source>
        <translation>Schematisches Elektrokardiogramm, die Herztöne S1 und S2 beim Schließen der Klappen und ein Balken für jede Klappe, solange sie offen ist. Die Lampe leuchtet, solange die Klappe offen ist.</translation>
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
        <translation>%1 ist nicht an diese Griffe gebunden: Das Binden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Bind now</source>
        <translation>Jetzt binden</translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 have no coordinates in the cage.</source>
        <translation>
            <numerusform>%n Eckpunkt von %1 hat keine Koordinaten im Käfig.</numerusform>
            <numerusform>%n Eckpunkte von %1 haben keine Koordinaten im Käfig.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie in no group&apos;s region.</source>
        <translation>
            <numerusform>%n Eckpunkt von %1 liegt in keiner Region einer Gruppe.</numerusform>
            <numerusform>%n Eckpunkte von %1 liegen in keiner Region einer Gruppe.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles&apos; hull.</source>
        <translation>
            <numerusform>%n Eckpunkt von %1 liegt außerhalb der Hülle der Griffe.</numerusform>
            <numerusform>%n Eckpunkte von %1 liegen außerhalb der Hülle der Griffe.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.</source>
        <translation>
            <numerusform>%n Eckpunkt von %1 liegt außerhalb der Griffe der Bewegung; %1 bleibt in Ruhe.</numerusform>
            <numerusform>%n Eckpunkte von %1 liegen außerhalb der Griffe der Bewegung; %1 bleibt in Ruhe.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CinePage</name>
    <message>
        <source>Open study</source>
        <translation>Offene Studie</translation>
    </message>
    <message>
        <source>Take the images that are open in the window</source>
        <translation>Die Bilder nehmen, die im Fenster offen sind</translation>
    </message>
    <message>
        <source>Images...</source>
        <translation>Bilder...</translation>
    </message>
    <message>
        <source>A folder with the DICOM files of a cine study</source>
        <translation>Ein Ordner mit den DICOM-Dateien einer Cine-Studie</translation>
    </message>
    <message>
        <source>Image file...</source>
        <translation>Bilddatei...</translation>
    </message>
    <message>
        <source>One file of images over time: 4D NIfTI or .seq.nrrd</source>
        <translation>Eine Datei mit Bildern über die Zeit: 4D-NIfTI oder .seq.nrrd</translation>
    </message>
    <message>
        <source>Labels...</source>
        <translation>Labels...</translation>
    </message>
    <message>
        <source>Label maps or surfaces of single phases: the ends of diastole and systole at least</source>
        <translation>Labelmaps oder Oberflächen einzelner Phasen: wenigstens die Enden von Diastole und Systole</translation>
    </message>
    <message>
        <source>Folder of one phase...</source>
        <translation>Ordner einer Phase...</translation>
    </message>
    <message>
        <source>A folder with all surfaces of one phase</source>
        <translation>Ein Ordner mit allen Oberflächen einer Phase</translation>
    </message>
    <message>
        <source>Labels and their phases</source>
        <translation>Labels und ihre Phasen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Looking through the images</source>
        <translation>Die Bilder werden durchgesehen</translation>
    </message>
    <message>
        <source>Folder with a cine study</source>
        <translation>Ordner mit einer Cine-Studie</translation>
    </message>
    <message>
        <source>Images over time</source>
        <translation>Bilder über die Zeit</translation>
    </message>
    <message>
        <source>Labels of single phases</source>
        <translation>Labels einzelner Phasen</translation>
    </message>
    <message>
        <source>Surfaces of one phase</source>
        <translation>Oberflächen einer Phase</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht gesagt</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>Phase of %1</source>
        <translation>Phase von %1</translation>
    </message>
    <message>
        <source>Guessed from the name and the images: check it</source>
        <translation>Aus dem Namen und den Bildern erraten: bitte prüfen</translation>
    </message>
    <message>
        <source>The phase that these labels belong to</source>
        <translation>Die Phase, zu der diese Labels gehören</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>%1 weglassen</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>%1 wird gelesen ...</translation>
    </message>
    <message>
        <source>No images are chosen.</source>
        <translation>Es sind keine Bilder gewählt.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 phases, %n planes</source>
        <translation>
            <numerusform>%1: %2 Phasen, %n Ebene</numerusform>
            <numerusform>%1: %2 Phasen, %n Ebenen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationBox</name>
    <message>
        <source>Preload: stressed blood</source>
        <translation>Vorlast: Blut unter Spannung</translation>
    </message>
    <message>
        <source>Afterload: body</source>
        <translation>Nachlast: Körperkreislauf</translation>
    </message>
    <message>
        <source>Afterload: lungs</source>
        <translation>Nachlast: Lungenkreislauf</translation>
    </message>
    <message>
        <source>Contractility, left</source>
        <translation>Kontraktilität, links</translation>
    </message>
    <message>
        <source>Contractility, right</source>
        <translation>Kontraktilität, rechts</translation>
    </message>
    <message>
        <source>Stiffness, left</source>
        <translation>Steifigkeit, links</translation>
    </message>
    <message>
        <source>%1, %2 at rest</source>
        <translation>%1, %2 in Ruhe</translation>
    </message>
    <message>
        <source>%1. Marked: normal, %2 %3 (%4)</source>
        <translation>%1. Markiert: normal, %2 %3 (%4)</translation>
    </message>
    <message>
        <source>Only the sample heart can be moved by the circulation model; the charts show its results for any organ.</source>
        <translation>Nur das Beispielherz kann vom Kreislaufmodell bewegt werden; die Diagramme zeigen dessen Ergebnisse für jedes Organ.</translation>
    </message>
    <message>
        <source>Textbook beat</source>
        <translation>Lehrbuchschlag</translation>
    </message>
    <message>
        <source>Volumes of healthy adults over one beat at this rate</source>
        <translation>Volumina gesunder Erwachsener über einen Herzschlag bei dieser Frequenz</translation>
    </message>
    <message>
        <source>A model of heart and vessels: pressures, pressure-volume loops, valves and sounds</source>
        <translation>Ein Modell von Herz und Gefäßen: Drücke, Druck-Volumen-Schleifen, Klappen und Töne</translation>
    </message>
    <message>
        <source>Rate, preload, afterload</source>
        <translation>Frequenz, Vorlast, Nachlast</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>Valves and pericardium</source>
        <translation>Klappen und Perikard</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Vorher: %1</translation>
    </message>
    <message>
        <source>Fitted to the volume and the ejection fraction of a left ventricle.</source>
        <translation>Angepasst an das Volumen und die Ejektionsfraktion eines linken Ventrikels.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationModel</name>
    <message>
        <source>Heart of the circulation</source>
        <translation>Herz des Kreislaufs</translation>
    </message>
</context>
<context>
    <name>viscera::app::ComparedSystem</name>
    <message>
        <source>Coordinates of the second view</source>
        <translation>Koordinaten der zweiten Ansicht</translation>
    </message>
    <message>
        <source>Coordinate system that binds the same organs to the same handles in this view</source>
        <translation>Koordinatensystem, das in dieser Ansicht dieselben Organe an dieselben Griffe bindet</translation>
    </message>
</context>
<context>
    <name>viscera::app::Comparison</name>
    <message>
        <source>Rate of the second view</source>
        <translation>Frequenz der zweiten Ansicht</translation>
    </message>
    <message>
        <source> / min</source>
        <translation> / min</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>Was diese Ansicht zeigt</translation>
    </message>
    <message>
        <source>The same organ at another rate</source>
        <translation>Dasselbe Organ bei anderer Frequenz</translation>
    </message>
    <message>
        <source>The same organ with other coordinates</source>
        <translation>Dasselbe Organ mit anderen Koordinaten</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Dateien öffnen...</translation>
    </message>
    <message>
        <source>Back to one view</source>
        <translation>Zurück zu einer Ansicht</translation>
    </message>
    <message>
        <source>Open beside the first organ</source>
        <translation>Neben dem ersten Organ öffnen</translation>
    </message>
    <message>
        <source>No organ yet</source>
        <translation>Noch kein Organ</translation>
    </message>
    <message>
        <source>  %1 / min</source>
        <translation>  %1 / min</translation>
    </message>
    <message>
        <source>The errors of both coordinate systems</source>
        <translation>Die Fehler beider Koordinatensysteme</translation>
    </message>
    <message>
        <source>The second view of the session is not shown: %1 is not installed here.</source>
        <translation>Die zweite Ansicht der Sitzung wird nicht gezeigt: %1 ist hier nicht installiert.</translation>
    </message>
    <message>
        <source>The same organ, kept in the present pose</source>
        <translation>Dasselbe Organ, in der jetzigen Pose festgehalten</translation>
    </message>
    <message>
        <source>Colour each vertex by its distance to the same vertex in view 1; while stress is shown, by what view 1 has more than view 2</source>
        <translation>Jeden Eckpunkt nach seinem Abstand vom selben Eckpunkt in Ansicht 1 färben; bei gezeigtem Stress danach, was Ansicht 1 mehr hat als Ansicht 2</translation>
    </message>
    <message>
        <source>Present pose</source>
        <translation>Jetzige Pose</translation>
    </message>
    <message>
        <source>Kept pose</source>
        <translation>Behaltene Pose</translation>
    </message>
</context>
<context>
    <name>viscera::app::ConnectionDialog</name>
    <message>
        <source>Secure connection (TLS)</source>
        <translation>Sichere Verbindung (TLS)</translation>
    </message>
    <message>
        <source>Add an archive</source>
        <translation>Archiv hinzufügen</translation>
    </message>
    <message>
        <source>Edit an archive</source>
        <translation>Archiv bearbeiten</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>Classic DICOM services (DIMSE)</source>
        <translation>Klassische DICOM-Dienste (DIMSE)</translation>
    </message>
    <message>
        <source>The name under which you choose the archive</source>
        <translation>Der Name, unter dem Sie das Archiv wählen</translation>
    </message>
    <message>
        <source>Leave it empty where the archive asks for no password</source>
        <translation>Leer lassen, wo das Archiv kein Passwort verlangt</translation>
    </message>
    <message>
        <source>The title (AE title) of the archive, at most 16 characters</source>
        <translation>Der Titel (AE Title) des Archivs, höchstens 16 Zeichen</translation>
    </message>
    <message>
        <source>The title by which the archive knows this program</source>
        <translation>Der Titel, unter dem das Archiv dieses Programm kennt</translation>
    </message>
    <message>
        <source>How long the archive may be silent</source>
        <translation>Wie lange das Archiv schweigen darf</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Title of the archive</source>
        <translation>Titel des Archivs</translation>
    </message>
    <message>
        <source>Title of this program</source>
        <translation>Titel dieses Programms</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Vertraute Zertifikate</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>Geduld</translation>
    </message>
    <message>
        <source>Those of the system</source>
        <translation>Die des Systems</translation>
    </message>
    <message>
        <source>A file with the certificate of the archive&apos;s issuer (.pem)</source>
        <translation>Eine Datei mit dem Zertifikat des Ausstellers des Archivs (.pem)</translation>
    </message>
    <message>
        <source>Choose the file with the certificates</source>
        <translation>Die Datei mit den Zertifikaten wählen</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt);;All files (*)</source>
        <translation>Zertifikate (*.pem *.crt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Give the archive a name.</source>
        <translation>Geben Sie dem Archiv einen Namen.</translation>
    </message>
    <message>
        <source>Another archive has this name.</source>
        <translation>Ein anderes Archiv heißt so.</translation>
    </message>
    <message>
        <source>Type the address of the archive.</source>
        <translation>Geben Sie die Adresse des Archivs ein.</translation>
    </message>
    <message>
        <source>The address of DICOMweb begins with http:// or https://.</source>
        <translation>Die Adresse von DICOMweb beginnt mit http:// oder https://.</translation>
    </message>
    <message>
        <source>The address holds no user and no password.</source>
        <translation>Die Adresse enthält weder Benutzer noch Passwort.</translation>
    </message>
    <message>
        <source>A title has 1 to 16 plain characters.</source>
        <translation>Ein Titel hat 1 bis 16 einfache Zeichen.</translation>
    </message>
    <message>
        <source>Images travel readable for others in the network, and so does a password.</source>
        <translation>Bilder sind unterwegs für andere im Netz lesbar, ein Passwort auch.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourCorrector</name>
    <message>
        <source>Only contours of a motion that was found in images can be corrected.</source>
        <translation>Nur Konturen einer Bewegung, die in Bildern gefunden wurde, lassen sich korrigieren.</translation>
    </message>
    <message>
        <source>The motion is being fitted to the last correction.</source>
        <translation>Die Bewegung wird gerade an die letzte Korrektur angepasst.</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact. Correct a phase between them, or change its labels.</source>
        <translation>Phase %1 hat Labels, und die sind genau. Korrigieren Sie eine Phase dazwischen, oder ändern Sie ihre Labels.</translation>
    </message>
    <message>
        <source>This organ is not moved by the motion that was found in images.</source>
        <translation>Dieses Organ wird nicht von der Bewegung bewegt, die in Bildern gefunden wurde.</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Kontur korrigieren</translation>
    </message>
    <message numerus="yes">
        <source>The motion is that of the images again. %n phases have changed.</source>
        <translation>
            <numerusform>Die Bewegung ist wieder die der Bilder. %n Phase hat sich geändert.</numerusform>
            <numerusform>Die Bewegung ist wieder die der Bilder. %n Phasen haben sich geändert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases have changed.</source>
        <translation>
            <numerusform>%n Phase hat sich geändert.</numerusform>
            <numerusform>%n Phasen haben sich geändert.</numerusform>
        </translation>
    </message>
    <message>
        <source>The motion meets all corrected contours to %1 mm.</source>
        <translation>Die Bewegung trifft alle korrigierten Konturen auf %1 mm genau.</translation>
    </message>
    <message>
        <source>The corrected contour of %1 in phase %2 is met to %3 mm only.</source>
        <translation>Die korrigierte Kontur von %1 in Phase %2 wird nur auf %3 mm genau getroffen.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourGrip</name>
    <message>
        <source>Correct &amp;contours</source>
        <translation>Konturen &amp;korrigieren</translation>
    </message>
    <message>
        <source>Drag the contour of a tracked organ in a slice: the motion is fitted to it. Ctrl does the same while it is held. Enabled for a motion that was found in images</source>
        <translation>Ziehen Sie die Kontur eines verfolgten Organs in einer Schicht: Die Bewegung wird an sie angepasst. Strg bewirkt dasselbe, solange es gedrückt ist. Verfügbar bei einer Bewegung, die in Bildern gefunden wurde</translation>
    </message>
    <message>
        <source>&amp;Remove a corrected contour</source>
        <translation>Korrigierte Kontur &amp;entfernen</translation>
    </message>
    <message>
        <source>%1, slice %2, phase %3</source>
        <translation>%1, Schicht %2, Phase %3</translation>
    </message>
</context>
<context>
    <name>viscera::app::CurveBox</name>
    <message>
        <source>Curve...</source>
        <translation>Kurve...</translation>
    </message>
    <message>
        <source>Organ whose volume is prescribed</source>
        <translation>Organ, dessen Volumen vorgegeben wird</translation>
    </message>
    <message>
        <source>A .csv file with two columns: the fraction of the cycle (or time_s) and the volume in ml. At each instant the handles move as little as possible to reach that volume</source>
        <translation>Eine .csv-Datei mit zwei Spalten: dem Anteil des Zyklus (oder time_s) und dem Volumen in ml. Zu jedem Zeitpunkt bewegen sich die Griffe so wenig wie möglich, um dieses Volumen zu erreichen</translation>
    </message>
    <message>
        <source>Let the sequence alone determine the volume again</source>
        <translation>Das Volumen wieder allein von der Sequenz bestimmen lassen</translation>
    </message>
    <message>
        <source>Volume curves (*.csv *.txt *.tsv)</source>
        <translation>Volumenkurven (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>%1 follows %2; dashed in the chart.</source>
        <translation>%1 folgt %2; im Diagramm gestrichelt.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CutBox</name>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Cut away the left side</source>
        <translation>Linke Seite wegschneiden</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Cut away the part nearest to the viewer</source>
        <translation>Wegschneiden, was dem Betrachter am nächsten ist</translation>
    </message>
    <message>
        <source>Distance of the cut from the middle of the organs, in per cent of the distance to their edge</source>
        <translation>Abstand des Schnitts von der Mitte der Organe, in Prozent des Abstands bis zu ihrem Rand</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>Fill chambers and vessels of the heart with blood. Without it they are empty and show walls, papillary muscles and valves</source>
        <translation>Kammern und Gefäße des Herzens mit Blut füllen. Ohne Blut sind sie leer und zeigen Wände, Papillarmuskeln und Klappen</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformMode</name>
    <message>
        <source>Drag a handle and the organ follows; K locks the volume, T turns and scales, M mirrors</source>
        <translation>Ziehen Sie an einem Griff, und das Organ folgt; K sperrt das Volumen, T dreht und skaliert, M spiegelt</translation>
    </message>
    <message>
        <source>&amp;Turn and scale</source>
        <translation>&amp;Drehen und skalieren</translation>
    </message>
    <message>
        <source>In Deform mode, rings turn and cubes scale the selected handles (at least two)</source>
        <translation>Im Modus Verformen drehen Ringe und skalieren Würfel die gewählten Griffe (mindestens zwei)</translation>
    </message>
    <message>
        <source>Reset &amp;pose</source>
        <translation>&amp;Pose zurücksetzen</translation>
    </message>
    <message>
        <source>Move every handle back to its rest position</source>
        <translation>Alle Griffe in ihre Ruhelage zurückbewegen</translation>
    </message>
    <message>
        <source>Reset selected handles</source>
        <translation>Gewählte Griffe zurücksetzen</translation>
    </message>
    <message>
        <source>Move the selected handles back to their rest positions</source>
        <translation>Die gewählten Griffe in ihre Ruhelage zurückbewegen</translation>
    </message>
    <message>
        <source>Restore &amp;rest volume</source>
        <translation>&amp;Ruhevolumen wiederherstellen</translation>
    </message>
    <message>
        <source>Restore the organ&apos;s volume at rest with the smallest motion of the handles</source>
        <translation>Das Volumen des Organs in Ruhe mit der kleinsten Bewegung der Griffe wiederherstellen</translation>
    </message>
    <message>
        <source>Selected handles &amp;compensate</source>
        <translation>Gewählte Griffe &amp;gleichen aus</translation>
    </message>
    <message>
        <source>Only the selected handles compensate when others would change a locked volume</source>
        <translation>Nur die gewählten Griffe gleichen aus, wenn andere ein gesperrtes Volumen ändern würden</translation>
    </message>
    <message>
        <source>&amp;Off</source>
        <translation>&amp;Aus</translation>
    </message>
    <message>
        <source>&amp;Sagittal plane</source>
        <translation>&amp;Sagittalebene</translation>
    </message>
    <message>
        <source>&amp;Coronal plane</source>
        <translation>&amp;Koronalebene</translation>
    </message>
    <message>
        <source>&amp;Axial plane</source>
        <translation>A&amp;xialebene</translation>
    </message>
    <message>
        <source>In Deform mode, mirrored handles move along with a drag</source>
        <translation>Im Modus Verformen bewegen sich gespiegelte Griffe beim Ziehen mit</translation>
    </message>
    <message>
        <source>&amp;Next mirror plane</source>
        <translation>&amp;Nächste Spiegelebene</translation>
    </message>
    <message>
        <source>Switch between off, sagittal, coronal and axial</source>
        <translation>Zwischen aus, sagittal, koronal und axial wechseln</translation>
    </message>
    <message>
        <source>Move e&amp;xactly, others compensate</source>
        <translation>&amp;Genau bewegen, andere gleichen aus</translation>
    </message>
    <message>
        <source>Under a locked volume, moved handles go exactly where they are sent, and the others compensate; else a moved handle stays where the volume lets it</source>
        <translation>Bei gesperrtem Volumen gehen bewegte Griffe genau dorthin, wohin sie sollen, und die anderen gleichen aus; sonst bleibt ein bewegter Griff, wo das Volumen ihn lässt</translation>
    </message>
    <message>
        <source>&amp;Free handles follow</source>
        <translation>&amp;Freie Griffe folgen</translation>
    </message>
    <message>
        <source>Handles that you do not drag go to where the elastic energy of the organs&apos; tissue is least; locked handles hold it, else it moves as a whole. Locked volumes stay exact. The first drag takes about a second, the next ones a tenth of a second a step</source>
        <translation>Griffe, die Sie nicht ziehen, gehen dorthin, wo die elastische Energie des Gewebes der Organe am kleinsten ist; gesperrte Griffe halten es fest, sonst bewegt es sich als Ganzes. Gesperrte Volumen bleiben exakt. Der erste Zug dauert etwa eine Sekunde, die nächsten eine Zehntelsekunde je Schritt</translation>
    </message>
    <message>
        <source>&amp;Beside elasticity</source>
        <translation>&amp;Neben der Elastizität</translation>
    </message>
    <message>
        <source>Show the current organ as an elastic body that the moved handles grip, as a ghost, and colour the organ by the distance from it; the other handles hold it. It takes some seconds after each drag</source>
        <translation>Zeigt das aktuelle Organ als elastischen Körper, den die bewegten Griffe fassen, als Geisterbild und färbt das Organ nach dem Abstand davon; die anderen Griffe halten es. Das dauert nach jedem Ziehen einige Sekunden</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformPage</name>
    <message>
        <source>Largest shift</source>
        <translation>Größte Verschiebung</translation>
    </message>
    <message>
        <source>The largest distance by which a vertex of the organ has moved from rest</source>
        <translation>Der größte Weg, um den sich ein Eckpunkt des Organs aus der Ruhelage bewegt hat</translation>
    </message>
    <message>
        <source>Selected handles</source>
        <translation>Gewählte Griffe</translation>
    </message>
    <message>
        <source>Compensating</source>
        <translation>Ausgleichend</translation>
    </message>
    <message>
        <source>These handles compensate when others would change a locked volume. If none is marked, a dragged handle stays in a plane, and all free handles compensate for other motions.</source>
        <translation>Diese Griffe gleichen aus, wenn andere ein gesperrtes Volumen ändern würden. Ist keiner markiert, bleibt ein gezogener Griff in einer Ebene, und bei anderen Bewegungen gleichen alle freien Griffe aus.</translation>
    </message>
    <message>
        <source>Symmetric drags</source>
        <translation>Symmetrisches Ziehen</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Handles moved</source>
        <translation>Bewegte Griffe</translation>
    </message>
    <message>
        <source>Mirror plane</source>
        <translation>Spiegelebene</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Sagittal plane (left and right)</source>
        <translation>Sagittalebene (links und rechts)</translation>
    </message>
    <message>
        <source>Coronal plane (front and back)</source>
        <translation>Koronalebene (vorn und hinten)</translation>
    </message>
    <message>
        <source>Axial plane (head and feet)</source>
        <translation>Axialebene (Kopf und Füße)</translation>
    </message>
    <message>
        <source>A drag moves the mirrored handles too; the mirror plane passes through the middle of the organ at rest (M: next plane)</source>
        <translation>Beim Ziehen bewegen sich auch die gespiegelten Griffe; die Spiegelebene geht durch die Mitte des Organs in Ruhe (M: nächste Ebene)</translation>
    </message>
    <message>
        <source>Moves along</source>
        <translation>Bewegt sich mit</translation>
    </message>
    <message>
        <source>no handle is near the mirror image</source>
        <translation>kein Griff liegt nahe dem Spiegelbild</translation>
    </message>
    <message>
        <source>all free handles</source>
        <translation>alle freien Griffe</translation>
    </message>
    <message>
        <source>Elasticity</source>
        <translation>Elastizität</translation>
    </message>
    <message>
        <source>Median distance</source>
        <translation>Mittlerer Abstand (Median)</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomDialog</name>
    <message>
        <source>Segmentation (SEG)</source>
        <translation>Segmentierung (SEG)</translation>
    </message>
    <message>
        <source>The organs as voxels on the grid of the scan, one file for each instant</source>
        <translation>Die Organe als Voxel auf dem Gitter des Scans, eine Datei für jeden Zeitpunkt</translation>
    </message>
    <message>
        <source>Measurements (SR)</source>
        <translation>Messungen (SR)</translation>
    </message>
    <message>
        <source>A structured report of volumes, distances and angles for each instant</source>
        <translation>Ein strukturierter Befund mit Volumen, Abständen und Winkeln für jeden Zeitpunkt</translation>
    </message>
    <message>
        <source>Surfaces (STL)</source>
        <translation>Oberflächen (STL)</translation>
    </message>
    <message>
        <source>The surface of each organ, one file for each</source>
        <translation>Die Oberfläche jedes Organs, je eine Datei</translation>
    </message>
    <message>
        <source>Contours (RTSTRUCT)</source>
        <translation>Konturen (RTSTRUCT)</translation>
    </message>
    <message>
        <source>Contours on the slices of the scan, for radiotherapy</source>
        <translation>Konturen auf den Schichten des Scans, für die Strahlentherapie</translation>
    </message>
    <message>
        <source>Without identity</source>
        <translation>Ohne Identität</translation>
    </message>
    <message>
        <source>No name, number or date of the patient, and new identifiers of study and series</source>
        <translation>Kein Name, keine Nummer und kein Datum des Patienten, und neue Kennungen von Studie und Serie</translation>
    </message>
    <message>
        <source>Export as DICOM</source>
        <translation>Als DICOM exportieren</translation>
    </message>
    <message>
        <source>The pose that is shown</source>
        <translation>Die gezeigte Pose</translation>
    </message>
    <message>
        <source>So many instants of one cycle of the motion</source>
        <translation>So viele Zeitpunkte eines Zyklus der Bewegung</translation>
    </message>
    <message>
        <source>No motion moves the organs</source>
        <translation>Keine Bewegung bewegt die Organe</translation>
    </message>
    <message>
        <source>Instants</source>
        <translation>Zeitpunkte</translation>
    </message>
    <message>
        <source>Whose they are</source>
        <translation>Wessen sie sind</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>For research and teaching, not for diagnosis.</source>
        <translation>Für Forschung und Lehre, nicht zur Diagnose.</translation>
    </message>
    <message>
        <source>The files of the scan are being read</source>
        <translation>Die Dateien des Scans werden gelesen</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Contours need the slices of a scan</source>
        <translation>Konturen brauchen die Schichten eines Scans</translation>
    </message>
    <message>
        <source>The organs that are written</source>
        <translation>Die Organe, die geschrieben werden</translation>
    </message>
    <message>
        <source>%1 is open and has no inside</source>
        <translation>%1 ist offen und hat kein Inneres</translation>
    </message>
    <message>
        <source>The elements of each file that say whose it is</source>
        <translation>Die Elemente jeder Datei, die sagen, wessen sie ist</translation>
    </message>
    <message>
        <source>A folder, or an archive that From the archive knows</source>
        <translation>Ein Ordner, oder ein Archiv, das „Aus dem Archiv“ kennt</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Made when it is not there; no file in it is replaced</source>
        <translation>Wird angelegt, wenn er fehlt; keine Datei darin wird ersetzt</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Den Ordner wählen</translation>
    </message>
    <message>
        <source>No DICOM scan says whose they are: they get a study of their own.</source>
        <translation>Kein DICOM-Scan sagt, wessen sie sind: Sie bekommen eine eigene Studie.</translation>
    </message>
    <message>
        <source>Choose at least one object.</source>
        <translation>Wählen Sie mindestens ein Objekt.</translation>
    </message>
    <message>
        <source>Choose at least one organ; its surface has to be closed.</source>
        <translation>Wählen Sie mindestens ein Organ; seine Oberfläche muss geschlossen sein.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Wählen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomExports</name>
    <message>
        <source>Export as &amp;DICOM...</source>
        <translation>Als &amp;DICOM exportieren...</translation>
    </message>
    <message>
        <source>Write organs and measurements as DICOM files, or send them to an archive (PACS)</source>
        <translation>Organe und Messungen als DICOM-Dateien schreiben oder an ein Archiv (PACS) senden</translation>
    </message>
    <message>
        <source>Reading whose the scan is</source>
        <translation>Es wird gelesen, wessen Scan es ist</translation>
    </message>
    <message>
        <source>segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>structured reports</source>
        <translation>strukturierte Befunde</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>structure sets</source>
        <translation>Struktursätze</translation>
    </message>
    <message>
        <source>Exporting as DICOM</source>
        <translation>Wird als DICOM exportiert</translation>
    </message>
    <message>
        <source>Written to %1: %2</source>
        <translation>Geschrieben nach %1: %2</translation>
    </message>
    <message>
        <source>Sent to %1: %2</source>
        <translation>Gesendet an %1: %2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DifferenceMap</name>
    <message>
        <source>Distance to view 1</source>
        <translation>Abstand zu Ansicht 1</translation>
    </message>
    <message>
        <source>%1: view 1 less view 2</source>
        <translation>%1: Ansicht 1 minus Ansicht 2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DisplacementBox</name>
    <message>
        <source>Right to left</source>
        <translation>Rechts nach links</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>Vorn nach hinten</translation>
    </message>
    <message>
        <source>Foot to head</source>
        <translation>Fuß nach Kopf</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s left; negative: right (R/L)</source>
        <translation>Zur linken Seite des Patienten; negativ: rechts (R/L)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s back; negative: front (A/P)</source>
        <translation>Zum Rücken des Patienten; negativ: nach vorn (A/P)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s head; negative: feet (S/I)</source>
        <translation>Zum Kopf des Patienten; negativ: zu den Füßen (S/I)</translation>
    </message>
    <message>
        <source>Move the selected handles once by this distance; locked volumes are kept</source>
        <translation>Die gewählten Griffe einmal um diese Strecke bewegen; gesperrte Volumina bleiben erhalten</translation>
    </message>
    <message>
        <source>Moved by %1 of %2 mm: the locked volume allows no more in this direction.</source>
        <translation>Um %1 von %2 mm bewegt: Mehr lässt das gesperrte Volumen in dieser Richtung nicht zu.</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Verschieben um</translation>
    </message>
</context>
<context>
    <name>viscera::app::ElasticGhost</name>
    <message>
        <source>There is no organ to compare.</source>
        <translation>Es gibt kein Organ zum Vergleichen.</translation>
    </message>
    <message>
        <source>Move a handle: at rest there is nothing to compare.</source>
        <translation>Bewegen Sie einen Griff: in Ruhe gibt es nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>The elastic organ is being computed.</source>
        <translation>Das elastische Organ wird berechnet.</translation>
    </message>
    <message>
        <source>Only an organ that follows the handles can be compared.</source>
        <translation>Nur ein Organ, das den Griffen folgt, kann verglichen werden.</translation>
    </message>
    <message>
        <source>Elastic organ</source>
        <translation>Elastisches Organ</translation>
    </message>
    <message>
        <source>The comparison was cancelled. Move a handle, or switch it off and on again.</source>
        <translation>Der Vergleich wurde abgebrochen. Bewegen Sie einen Griff, oder schalten Sie ihn aus und wieder ein.</translation>
    </message>
    <message>
        <source>Distance from elasticity</source>
        <translation>Abstand von der Elastizität</translation>
    </message>
</context>
<context>
    <name>viscera::app::ErrorTable</name>
    <message>
        <source>Unity error</source>
        <translation>Summenfehler</translation>
    </message>
    <message>
        <source>The largest distance of a vertex&apos;s weights&apos; sum from 1</source>
        <translation>Der größte Abstand der Summe der Gewichte eines Eckpunkts von 1</translation>
    </message>
    <message>
        <source>Negative where the system is not positive</source>
        <translation>Negativ, wo das System nicht positiv ist</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Ausfälle</translation>
    </message>
    <message>
        <source>Vertices for which the system has no coordinates; they do not move</source>
        <translation>Eckpunkte, für die das System keine Koordinaten hat; sie bewegen sich nicht</translation>
    </message>
    <message>
        <source>Binding time</source>
        <translation>Bindezeit</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExploreMode</name>
    <message>
        <source>Explore</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>Left drag rotates, Shift+left pans, right drag or wheel zooms, click selects an organ, D and A measure</source>
        <translation>Ziehen mit links dreht, Umschalt+links verschiebt, Ziehen mit rechts oder Mausrad zoomt, Klick wählt ein Organ, D und A messen</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; Esc ends</source>
        <translation>Zwei Punkte auf einem Organ oder einer Schicht anklicken; Esc beendet</translation>
    </message>
    <message>
        <source>Measure &amp;distance</source>
        <translation>&amp;Abstand messen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Measure &amp;angle</source>
        <translation>&amp;Winkel messen</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; Esc ends</source>
        <translation>Drei Punkte auf einem Organ oder einer Schicht anklicken, den Scheitel als zweiten; Esc beendet</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;rectangle</source>
        <translation>Werte in einem &amp;Rechteck messen</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Auf einer Schicht von Ecke zu Ecke ziehen: Mittelwert und Abweichung der Werte des Scans; Esc beendet</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;sphere</source>
        <translation>Werte in einer &amp;Kugel messen</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Auf einer Schicht von der Mitte zum Rand ziehen: Mittelwert und Abweichung der Werte des Scans; Esc beendet</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Remove all &amp;measurements</source>
        <translation>Alle &amp;Messungen entfernen</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Messungen</translation>
    </message>
    <message>
        <source>Show the measurements</source>
        <translation>Die Messungen zeigen</translation>
    </message>
    <message>
        <source>Names of &amp;parts</source>
        <translation>Namen der &amp;Teile</translation>
    </message>
    <message>
        <source>Name the parts of the organs, such as the apex of the heart</source>
        <translation>Die Teile der Organe benennen, etwa die Herzspitze</translation>
    </message>
    <message>
        <source>&amp;Quiz on the parts</source>
        <translation>&amp;Quiz zu den Teilen</translation>
    </message>
    <message>
        <source>Hide the names and ask for one part after the other; answer with a click on the organ</source>
        <translation>Die Namen verbergen und nach einem Teil nach dem anderen fragen; geantwortet wird mit einem Klick auf das Organ</translation>
    </message>
    <message>
        <source>%1. Drags turn the view, Esc ends the quiz</source>
        <translation>%1. Ziehen dreht die Ansicht, Esc beendet das Quiz</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; drags turn the view, Esc ends</source>
        <translation>Zwei Punkte auf einem Organ oder einer Schicht anklicken; Ziehen dreht die Ansicht, Esc beendet</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; drags turn the view, Esc ends</source>
        <translation>Drei Punkte auf einem Organ oder einer Schicht anklicken, den Scheitel als zweiten; Ziehen dreht die Ansicht, Esc beendet</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner; Esc ends</source>
        <translation>Auf einer Schicht von Ecke zu Ecke ziehen; Esc beendet</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle of a sphere to its border; Esc ends</source>
        <translation>Auf einer Schicht von der Mitte einer Kugel zu ihrem Rand ziehen; Esc beendet</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExplorePage</name>
    <message>
        <source>View from</source>
        <translation>Ansicht von</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Rest volume</source>
        <translation>Ruhevolumen</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message numerus="yes">
        <source>open, %n edges</source>
        <translation>
            <numerusform>offen, %n Kante</numerusform>
            <numerusform>offen, %n Kanten</numerusform>
        </translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>keines ausgewählt</translation>
    </message>
    <message>
        <source>Select an organ in the view or in the list to read about it.</source>
        <translation>Wählen Sie ein Organ in der Ansicht oder in der Liste aus, um Angaben dazu zu lesen.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases</source>
        <translation>
            <numerusform>%n Phase</numerusform>
            <numerusform>%n Phasen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 phases</source>
        <translation>%1 von %2 Phasen</translation>
    </message>
    <message>
        <source> in %1 ms</source>
        <translation> in %1 ms</translation>
    </message>
    <message>
        <source>, pixels of %1 mm</source>
        <translation>, Pixel von %1 mm</translation>
    </message>
    <message>
        <source>, %1 mm thick</source>
        <translation>, %1 mm dick</translation>
    </message>
    <message numerus="yes">
        <source>%n phases in %1 s</source>
        <translation>
            <numerusform>%n Phase in %1 s</numerusform>
            <numerusform>%n Phasen in %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ExportActions</name>
    <message>
        <source>Export all &amp;organs...</source>
        <translation>Alle &amp;Organe exportieren...</translation>
    </message>
    <message>
        <source>Write all visible organs into one file, with names and colours</source>
        <translation>Alle sichtbaren Organe mit Namen und Farben in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Export all organs</source>
        <translation>Alle Organe exportieren</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb);;3MF models for printing (*.3mf)</source>
        <translation>glTF-Szenen (*.glb);;3MF-Modelle zum Drucken (*.3mf)</translation>
    </message>
    <message>
        <source>Export &amp;displacements...</source>
        <translation>&amp;Verschiebungen exportieren...</translation>
    </message>
    <message>
        <source>Write the current organ at rest, with the displacement of every vertex</source>
        <translation>Das aktuelle Organ in Ruhe schreiben, mit der Verschiebung jedes Eckpunkts</translation>
    </message>
    <message>
        <source>Export displacements</source>
        <translation>Verschiebungen exportieren</translation>
    </message>
    <message>
        <source>VTK surfaces (*.vtp)</source>
        <translation>VTK-Oberflächen (*.vtp)</translation>
    </message>
    <message>
        <source>Export displacement &amp;field...</source>
        <translation>Verschiebungs&amp;feld exportieren...</translation>
    </message>
    <message>
        <source>Write the displacement of the space around the current organ, for 3D Slicer and ITK</source>
        <translation>Die Verschiebung des Raums um das aktuelle Organ schreiben, für 3D Slicer und ITK</translation>
    </message>
    <message>
        <source>Export displacement field</source>
        <translation>Verschiebungsfeld exportieren</translation>
    </message>
    <message>
        <source>Displacement fields (*.nrrd *.mha)</source>
        <translation>Verschiebungsfelder (*.nrrd *.mha)</translation>
    </message>
    <message>
        <source>Export &amp;table of volumes...</source>
        <translation>Volumen&amp;tabelle exportieren...</translation>
    </message>
    <message>
        <source>Write volumes and sizes of all organs</source>
        <translation>Volumina und Größen aller Organe schreiben</translation>
    </message>
    <message>
        <source>Export table of volumes</source>
        <translation>Volumentabelle exportieren</translation>
    </message>
    <message>
        <source>Export &amp;measurements...</source>
        <translation>&amp;Messungen exportieren...</translation>
    </message>
    <message>
        <source>Write all measured distances and angles</source>
        <translation>Alle gemessenen Abstände und Winkel schreiben</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Measure a distance (D) or an angle (A) first.</source>
        <translation>Noch ist nichts gemessen. Messen Sie zuerst einen Abstand (D) oder einen Winkel (A).</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>Messungen exportieren</translation>
    </message>
    <message>
        <source>all organs</source>
        <translation>alle Organe</translation>
    </message>
    <message numerus="yes">
        <source>The rest position of %n points of the field is uncertain.</source>
        <translation>
            <numerusform>Die Ruhelage von %n Punkt des Felds ist unsicher.</numerusform>
            <numerusform>Die Ruhelage von %n Punkten des Felds ist unsicher.</numerusform>
        </translation>
    </message>
    <message>
        <source>table of volumes</source>
        <translation>Volumentabelle</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>Messungen</translation>
    </message>
</context>
<context>
    <name>viscera::app::FileActions</name>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a session, organs, label maps, handles or a scan</source>
        <translation>Eine Sitzung, Organe, Labelmaps, Griffe oder einen Scan öffnen</translation>
    </message>
    <message>
        <source>Open a &amp;folder of masks...</source>
        <translation>&amp;Maskenordner öffnen...</translation>
    </message>
    <message>
        <source>Open one patient: a folder with one mask for each organ, as TotalSegmentator writes it</source>
        <translation>Einen Patienten öffnen: ein Ordner mit einer Maske je Organ, wie TotalSegmentator ihn schreibt</translation>
    </message>
    <message>
        <source>&amp;Import with check...</source>
        <translation>Mit Prüfung &amp;importieren...</translation>
    </message>
    <message>
        <source>Check and repair the contents of files before importing them</source>
        <translation>Den Inhalt von Dateien vor dem Import prüfen und reparieren</translation>
    </message>
    <message>
        <source>Save &amp;handles...</source>
        <translation>&amp;Griffe speichern...</translation>
    </message>
    <message>
        <source>Save the handles at rest as Slicer markups</source>
        <translation>Die Griffe in Ruhe als Slicer-Markups speichern</translation>
    </message>
    <message>
        <source>&amp;Export organ...</source>
        <translation>Organ &amp;exportieren...</translation>
    </message>
    <message>
        <source>Export the organ in its present pose</source>
        <translation>Das Organ in seiner jetzigen Pose exportieren</translation>
    </message>
    <message>
        <source>Load a &amp;cage...</source>
        <translation>&amp;Käfig laden...</translation>
    </message>
    <message>
        <source>For coordinates that need a cage: load a closed surface around the organ; its vertices become the handles</source>
        <translation>Für Koordinaten, die einen Käfig brauchen: eine geschlossene Oberfläche um das Organ laden; ihre Eckpunkte werden die Griffe</translation>
    </message>
    <message>
        <source>Sessions, organs, label maps, handles and scans (*.viscera %1 %2 %3)</source>
        <translation>Sitzungen, Organe, Labelmaps, Griffe und Scans (*.viscera %1 %2 %3)</translation>
    </message>
    <message>
        <source>Sessions (*.viscera)</source>
        <translation>Sitzungen (*.viscera)</translation>
    </message>
    <message>
        <source>Organs, label maps and handles (%1 %2 %3)</source>
        <translation>Organe, Labelmaps und Griffe (%1 %2 %3)</translation>
    </message>
    <message>
        <source>Label maps (%1)</source>
        <translation>Labelmaps (%1)</translation>
    </message>
    <message>
        <source>Handles (%1)</source>
        <translation>Griffe (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a folder with one mask for each organ</source>
        <translation>Ordner mit einer Maske je Organ öffnen</translation>
    </message>
    <message numerus="yes">
        <source>Opening %n files</source>
        <translation>
            <numerusform>%n Datei wird geöffnet</numerusform>
            <numerusform>%n Dateien werden geöffnet</numerusform>
        </translation>
    </message>
    <message>
        <source>Save handles</source>
        <translation>Griffe speichern</translation>
    </message>
    <message>
        <source>Slicer markups (*%1 *.fcsv)</source>
        <translation>Slicer-Markups (*%1 *.fcsv)</translation>
    </message>
    <message>
        <source>Load a cage</source>
        <translation>Käfig laden</translation>
    </message>
    <message>
        <source>Closed surfaces (%1);;All files (*)</source>
        <translation>Geschlossene Oberflächen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading the cage %1</source>
        <translation>Käfig %1 wird gelesen</translation>
    </message>
    <message>
        <source>The handles at the vertices of %1 are now the corners of the cage.</source>
        <translation>Die Griffe an den Eckpunkten von %1 sind jetzt die Ecken des Käfigs.</translation>
    </message>
    <message numerus="yes">
        <source>The %n vertices of %1 are now the handles.</source>
        <translation>
            <numerusform>Der %n Eckpunkt von %1 ist jetzt der Griff.</numerusform>
            <numerusform>Die %n Eckpunkte von %1 sind jetzt die Griffe.</numerusform>
        </translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Oberflächen (%1)</translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>%1 in %2 geschrieben</translation>
    </message>
    <message>
        <source>%1 was not found.</source>
        <translation>%1 wurde nicht gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n more findings; see the organs&apos; pages in Explore mode</source>
        <translation>
            <numerusform>%n weiterer Befund; siehe die Seite des Organs im Modus Erkunden</numerusform>
            <numerusform>%n weitere Befunde; siehe die Seiten der Organe im Modus Erkunden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lies exactly where %2 lies already: only one of them is seen.</source>
        <translation>„%1“ liegt genau dort, wo „%2“ schon liegt: Nur eines von beiden ist zu sehen.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Findings</name>
    <message>
        <source>Side of the body</source>
        <translation>Körperseite</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Offene Oberfläche</translation>
    </message>
    <message>
        <source>Edges of more than two triangles</source>
        <translation>Kanten von mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>Triangles that face inward</source>
        <translation>Nach innen gerichtete Dreiecke</translation>
    </message>
    <message>
        <source>Separate pieces</source>
        <translation>Getrennte Stücke</translation>
    </message>
    <message>
        <source>Crossing triangles</source>
        <translation>Sich kreuzende Dreiecke</translation>
    </message>
    <message>
        <source>Positions of the organs</source>
        <translation>Lage der Organe</translation>
    </message>
    <message>
        <source>Lost details</source>
        <translation>Verlorene Einzelheiten</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitBox</name>
    <message>
        <source>by the shape</source>
        <translation>nach der Form</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit to this organ</source>
        <translation>An dieses Organ anpassen</translation>
    </message>
    <message>
        <source>Sequence to fit</source>
        <translation>Anzupassende Sequenz</translation>
    </message>
    <message>
        <source>Of the left ventricle. The right one ejects as much blood, and the muscle keeps its volume</source>
        <translation>Des linken Ventrikels. Der rechte wirft ebenso viel Blut aus, und der Muskel behält sein Volumen</translation>
    </message>
    <message>
        <source>%1: click its place in the view</source>
        <translation>%1: durch Klick in die Ansicht setzen</translation>
    </message>
    <message>
        <source>click the organ</source>
        <translation>Organ anklicken</translation>
    </message>
    <message>
        <source>Open a patient&apos;s organ first.</source>
        <translation>Öffnen Sie zuerst ein Organ eines Patienten.</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface.</source>
        <translation>%1 ist offen; eine Sequenz braucht eine geschlossene Oberfläche.</translation>
    </message>
    <message>
        <source>Makes %1 and its chambers beat like a textbook heart. The present shape counts as the end of diastole. The result is a key sequence.</source>
        <translation>Lässt %1 und seine Höhlen wie ein Lehrbuchherz schlagen. Die jetzige Form gilt als Ende der Diastole. Das Ergebnis ist eine Schlüsselbildfolge.</translation>
    </message>
    <message>
        <source>Moves %1 like the sample organ. Landmarks that you do not set are found from its shape.</source>
        <translation>Bewegt %1 wie das Beispielorgan. Landmarken, die Sie nicht setzen, werden aus der Form bestimmt.</translation>
    </message>
    <message>
        <source>Fitting %1</source>
        <translation>%1 wird angepasst</translation>
    </message>
    <message>
        <source>Fit the textbook&apos;s beat to %1</source>
        <translation>Lehrbuchschlag an %1 anpassen</translation>
    </message>
    <message>
        <source>Spine and pelvis stay in place: breathing does not move them.</source>
        <translation>Wirbelsäule und Becken bleiben an ihrem Ort: Die Atmung bewegt sie nicht.</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitOffer</name>
    <message>
        <source>Replace all open organs; Undo brings them back</source>
        <translation>Alle offenen Organe ersetzen; Rückgängig holt sie zurück</translation>
    </message>
    <message>
        <source>%1 is made for a %2, but the name %3 suggests another organ.</source>
        <translation>%1 ist für „%2“ gemacht, aber der Name %3 deutet auf ein anderes Organ hin.</translation>
    </message>
    <message>
        <source>%1: fit it to %2?</source>
        <translation>%1: an %2 anpassen?</translation>
    </message>
    <message>
        <source>Fit it anyway</source>
        <translation>Trotzdem anpassen</translation>
    </message>
    <message>
        <source>Fit it to %1</source>
        <translation>An %1 anpassen</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface</source>
        <translation>%1 ist offen; eine Sequenz braucht eine geschlossene Oberfläche</translation>
    </message>
    <message>
        <source>Show the sample %1</source>
        <translation>Beispiel zeigen: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::GroupPanel</name>
    <message>
        <source>No groups: all handles act everywhere. Select handles and make a group of them, or make groups automatically below.</source>
        <translation>Keine Gruppen: Alle Griffe wirken überall. Wählen Sie Griffe und bilden Sie daraus eine Gruppe, oder bilden Sie unten Gruppen automatisch.</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Neue Gruppe</translation>
    </message>
    <message>
        <source>Make a group of the selected handles</source>
        <translation>Aus den gewählten Griffen eine Gruppe bilden</translation>
    </message>
    <message>
        <source>Select handles</source>
        <translation>Griffe wählen</translation>
    </message>
    <message>
        <source>Select the handles of the chosen group</source>
        <translation>Die Griffe der gewählten Gruppe auswählen</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Gewählte dazu</translation>
    </message>
    <message>
        <source>Add the selected handles to the chosen group</source>
        <translation>Die gewählten Griffe der gewählten Gruppe hinzufügen</translation>
    </message>
    <message>
        <source>Choose the colour of the chosen group</source>
        <translation>Die Farbe der gewählten Gruppe wählen</translation>
    </message>
    <message>
        <source>Remove the chosen group; its handles stay</source>
        <translation>Die gewählte Gruppe entfernen; ihre Griffe bleiben</translation>
    </message>
    <message>
        <source>How groups are made</source>
        <translation>Wie Gruppen gebildet werden</translation>
    </message>
    <message>
        <source>Parts along the axis</source>
        <translation>Teile entlang der Achse</translation>
    </message>
    <message>
        <source>Clusters of handles</source>
        <translation>Häufungen von Griffen</translation>
    </message>
    <message>
        <source>Organs and their pieces</source>
        <translation>Organe und ihre Stücke</translation>
    </message>
    <message>
        <source>How many groups</source>
        <translation>Anzahl der Gruppen</translation>
    </message>
    <message>
        <source>Replace the present groups. Where handles do not surround a group&apos;s part of the organ, the corners of a box are added.</source>
        <translation>Die jetzigen Gruppen ersetzen. Wo Griffe den Teil des Organs einer Gruppe nicht umgeben, werden die Ecken eines Quaders hinzugefügt.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>F2 renames</source>
        <translation>F2 benennt um</translation>
    </message>
    <message>
        <source>A region needs at least four handles</source>
        <translation>Eine Region braucht mindestens vier Griffe</translation>
    </message>
    <message>
        <source>These coordinates do not use groups.</source>
        <translation>Diese Koordinaten verwenden keine Gruppen.</translation>
    </message>
    <message>
        <source>No coordinate system that uses groups is loaded: the plugin is missing.</source>
        <translation>Kein Koordinatensystem mit Gruppen ist geladen: Das Plugin fehlt.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to the group.</source>
        <translation>
            <numerusform>Das automatische Gruppieren hat der Gruppe %n Eckgriff hinzugefügt.</numerusform>
            <numerusform>Das automatische Gruppieren hat der Gruppe %n Eckgriffe hinzugefügt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to %1 of %2 groups.</source>
        <translation>
            <numerusform>Das automatische Gruppieren hat %1 von %2 Gruppen %n Eckgriff hinzugefügt.</numerusform>
            <numerusform>Das automatische Gruppieren hat %1 von %2 Gruppen %n Eckgriffe hinzugefügt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>Take the selected handles out of the chosen group</source>
        <translation>Die ausgewählten Griffe aus der gewählten Gruppe nehmen</translation>
    </message>
</context>
<context>
    <name>viscera::app::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Abschnitte</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n Abschnitt</numerusform>
            <numerusform>%n Abschnitte</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleController</name>
    <message numerus="yes">
        <source>Turn %n handles</source>
        <translation>
            <numerusform>%n Griff drehen</numerusform>
            <numerusform>%n Griffe drehen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n handles</source>
        <translation>
            <numerusform>%n Griff skalieren</numerusform>
            <numerusform>%n Griffe skalieren</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleModel</name>
    <message>
        <source>Handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Rest L</source>
        <translation>Ruhe L</translation>
    </message>
    <message>
        <source>Rest P</source>
        <translation>Ruhe P</translation>
    </message>
    <message>
        <source>Rest S</source>
        <translation>Ruhe S</translation>
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
        <translation>Weg (mm)</translation>
    </message>
    <message>
        <source>Coordinate</source>
        <translation>Koordinate</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePanel</name>
    <message>
        <source>No handles yet.
Move the slider above to place some, or click the organ in Handles mode (2).</source>
        <translation>Noch keine Griffe.
Bewegen Sie den Regler oben, um welche zu setzen, oder klicken Sie im Modus Griffe (2) auf das Organ.</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>Automatisch setzen</translation>
    </message>
    <message>
        <source>Place this many handles evenly, a little outside the organ&apos;s surface; they replace the present ones</source>
        <translation>So viele Griffe gleichmäßig setzen, etwas außerhalb der Oberfläche des Organs; sie ersetzen die jetzigen</translation>
    </message>
    <message>
        <source>Enclosing box</source>
        <translation>Umschließender Quader</translation>
    </message>
    <message>
        <source>Eight of the handles are the corners of a box around the organ, so that all of it lies inside</source>
        <translation>Acht der Griffe sind die Ecken eines Quaders um das Organ, sodass es ganz darin liegt</translation>
    </message>
    <message>
        <source>F2 renames, Delete removes</source>
        <translation>F2 benennt um, Entf entfernt</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePlacer</name>
    <message>
        <source>Place handles</source>
        <translation>Griffe setzen</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleTable</name>
    <message>
        <source>Table of handles</source>
        <translation>Tabelle der Griffe</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, with all digits (Ctrl+C)</source>
        <translation>Die gewählten Zeilen oder alle mit sämtlichen Stellen kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>&amp;Table of handles...</source>
        <translation>&amp;Tabelle der Griffe...</translation>
    </message>
    <message>
        <source>Positions of all handles, and the coordinates of a vertex that you click</source>
        <translation>Positionen aller Griffe und die Koordinaten eines Eckpunkts, den Sie anklicken</translation>
    </message>
    <message>
        <source>Click the organ in the view to see the coordinates of its nearest vertex.</source>
        <translation>Klicken Sie in der Ansicht auf das Organ, um die Koordinaten des nächsten Eckpunkts zu sehen.</translation>
    </message>
    <message>
        <source>Vertex %1 of %2, at rest at %3, %4, %5 mm (LPS)</source>
        <translation>Eckpunkt %1 von %2, in Ruhe bei %3; %4; %5 mm (LPS)</translation>
    </message>
    <message>
        <source>%1: the organ is not bound to the handles.</source>
        <translation>%1: Das Organ ist nicht an die Griffe gebunden.</translation>
    </message>
    <message>
        <source>%1. Its coordinates sum to %2 and miss it by %3 mm.</source>
        <translation>%1. Seine Koordinaten haben die Summe %2 und verfehlen ihn um %3 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesMode</name>
    <message>
        <source>Click the organ to add a handle, drag to move it, Delete removes it; the rest shape stays</source>
        <translation>Klick auf das Organ fügt einen Griff hinzu, Ziehen bewegt ihn, Entf entfernt ihn; die Ruheform bleibt</translation>
    </message>
    <message>
        <source>&amp;Place automatically</source>
        <translation>Automatisch &amp;setzen</translation>
    </message>
    <message>
        <source>Spread handles evenly around the organ</source>
        <translation>Griffe gleichmäßig um das Organ verteilen</translation>
    </message>
    <message>
        <source>Add &amp;enclosing handles</source>
        <translation>&amp;Umschließende Griffe hinzufügen</translation>
    </message>
    <message>
        <source>Add the eight corners of a box around everything</source>
        <translation>Die acht Ecken eines Quaders um alles hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove handles</source>
        <translation>Griffe &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove the selected handles</source>
        <translation>Die gewählten Griffe entfernen</translation>
    </message>
    <message>
        <source>Select &amp;all handles</source>
        <translation>&amp;Alle Griffe auswählen</translation>
    </message>
    <message>
        <source>Use the &amp;hull as the cage</source>
        <translation>&amp;Hülle als Käfig verwenden</translation>
    </message>
    <message>
        <source>Discard the loaded cage and use the convex hull of the handles again</source>
        <translation>Den geladenen Käfig verwerfen und wieder die konvexe Hülle der Griffe verwenden</translation>
    </message>
    <message>
        <source>&amp;Influence map</source>
        <translation>Ein&amp;flusskarte</translation>
    </message>
    <message>
        <source>Colour the organ by the influence of the selected handle</source>
        <translation>Das Organ nach dem Einfluss des gewählten Griffs färben</translation>
    </message>
    <message>
        <source>Show &amp;regions</source>
        <translation>&amp;Regionen zeigen</translation>
    </message>
    <message>
        <source>Show where each group of handles acts, and the cage of coordinates that need one</source>
        <translation>Zeigen, wo jede Gruppe von Griffen wirkt, und den Käfig von Koordinaten, die einen brauchen</translation>
    </message>
    <message>
        <source>Show &amp;zones</source>
        <translation>&amp;Zonen zeigen</translation>
    </message>
    <message>
        <source>Show where regions meet, in red</source>
        <translation>In Rot zeigen, wo Regionen sich treffen</translation>
    </message>
    <message>
        <source>Show &amp;super-regions</source>
        <translation>Superre&amp;gionen zeigen</translation>
    </message>
    <message>
        <source>Show the super-region that counts in each zone, in yellow</source>
        <translation>In Gelb die Superregion zeigen, die in jeder Zone gilt</translation>
    </message>
    <message>
        <source>Bound in %1 ms</source>
        <translation>In %1 ms gebunden</translation>
    </message>
    <message numerus="yes">
        <source>%n handles removed</source>
        <translation>
            <numerusform>%n Griff entfernt</numerusform>
            <numerusform>%n Griffe entfernt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesPage</name>
    <message>
        <source>not bound</source>
        <translation>nicht gebunden</translation>
    </message>
    <message>
        <source>binding...</source>
        <translation>wird gebunden...</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>gebunden</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>nicht möglich</translation>
    </message>
    <message>
        <source>Binding</source>
        <translation>Bindung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Handle at rest</source>
        <translation>Griff in Ruhe</translation>
    </message>
    <message>
        <source>The cage is the convex hull of the handles.</source>
        <translation>Der Käfig ist die konvexe Hülle der Griffe.</translation>
    </message>
    <message>
        <source>The cage has %1 triangles over %2 handles.</source>
        <translation>Der Käfig hat %1 Dreiecke über %2 Griffen.</translation>
    </message>
    <message numerus="yes">
        <source>%1 ms, %n threads</source>
        <translation>
            <numerusform>%1 ms, %n Thread</numerusform>
            <numerusform>%1 ms, %n Threads</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartNumbersBox</name>
    <message>
        <source>Numbers of the measured heart</source>
        <translation>Zahlen des gemessenen Herzens</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>je m²</translation>
    </message>
    <message>
        <source>End of diastole here</source>
        <translation>Ende der Diastole hier</translation>
    </message>
    <message>
        <source>The present instant is the end of diastole (ED)</source>
        <translation>Der jetzige Augenblick ist das Ende der Diastole (ED)</translation>
    </message>
    <message>
        <source>End of systole here</source>
        <translation>Ende der Systole hier</translation>
    </message>
    <message>
        <source>The present instant is the end of systole (ES)</source>
        <translation>Der jetzige Augenblick ist das Ende der Systole (ES)</translation>
    </message>
    <message>
        <source>Find both ends</source>
        <translation>Beide Enden finden</translation>
    </message>
    <message>
        <source>ED is where the volume is largest, ES where it is smallest</source>
        <translation>ED ist, wo das Volumen am größten ist, ES, wo es am kleinsten ist</translation>
    </message>
    <message>
        <source>Height and weight...</source>
        <translation>Größe und Gewicht...</translation>
    </message>
    <message>
        <source>Body surface area by Mosteller, for numbers per square metre</source>
        <translation>Körperoberfläche nach Mosteller, für Zahlen je Quadratmeter</translation>
    </message>
    <message>
        <source>Save as CSV...</source>
        <translation>Als CSV speichern...</translation>
    </message>
    <message>
        <source>Write these numbers into a table</source>
        <translation>Diese Zahlen in eine Tabelle schreiben</translation>
    </message>
    <message>
        <source>ED at %1 % of the cycle, ES at %2 %</source>
        <translation>ED bei %1 % des Zyklus, ES bei %2 %</translation>
    </message>
    <message>
        <source>Body surface</source>
        <translation>Körperoberfläche</translation>
    </message>
    <message>
        <source>Height in cm</source>
        <translation>Größe in cm</translation>
    </message>
    <message>
        <source>Weight in kg</source>
        <translation>Gewicht in kg</translation>
    </message>
    <message>
        <source>A body surface area of %1 m² is not that of an adult: nothing is indexed</source>
        <translation>Eine Körperoberfläche von %1 m² ist nicht die eines Erwachsenen: nichts wird darauf bezogen</translation>
    </message>
    <message>
        <source>Save the heart&apos;s numbers</source>
        <translation>Die Zahlen des Herzens speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>The heart&apos;s numbers are in %1</source>
        <translation>Die Zahlen des Herzens sind in %1</translation>
    </message>
    <message>
        <source>Estimates: only one phase of the images has labels. Of a right ventricle there are no numbers then.</source>
        <translation>Schätzungen: nur eine Phase der Bilder hat Labels. Von einem rechten Ventrikel gibt es dann keine Zahlen.</translation>
    </message>
    <message>
        <source>Body surface %1 m² from the images: %2 cm, %3 kg</source>
        <translation>Körperoberfläche %1 m² aus den Bildern: %2 cm, %3 kg</translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartOpener</name>
    <message>
        <source>Opening the heart</source>
        <translation>Das Herz wird geöffnet</translation>
    </message>
</context>
<context>
    <name>viscera::app::Help</name>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>&amp;Tour in zwei Minuten</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Willkommen</translation>
    </message>
    <message>
        <source>&amp;About Viscera</source>
        <translation>&amp;Über Viscera</translation>
    </message>
    <message>
        <source>Viscera %1: organs deformed by handles, without a cage. BSD-3-Clause; a program for research and teaching, not a medical device.</source>
        <translation>Viscera %1: Organe, mit Griffen verformt, ohne Käfig. BSD-3-Clause; ein Programm für Forschung und Lehre, kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Umsehen</translation>
    </message>
    <message>
        <source>Drag with the left button to rotate, with Shift to pan; the wheel zooms. Click an organ to select it, press F to bring it into the picture; D measures distances, A angles. The eye in the list on the left hides it, the square changes its colour.</source>
        <translation>Ziehen mit der linken Taste dreht, mit Umschalt verschiebt; das Rad zoomt. Ein Klick wählt ein Organ, F holt es ins Bild; D misst Abstände, A Winkel. Das Auge in der Liste links blendet es aus, das Quadrat ändert seine Farbe.</translation>
    </message>
    <message>
        <source>Play a motion</source>
        <translation>Eine Bewegung abspielen</translation>
    </message>
    <message>
        <source>Space plays and pauses. The timeline shows the phases of the cycle: drag along it to look at one instant. Below, the volumes are drawn as they change.</source>
        <translation>Die Leertaste spielt ab und hält an. Die Zeitleiste zeigt die Phasen des Zyklus: Ziehen Sie daran, um einen Zeitpunkt zu betrachten. Darunter werden die Volumina in ihrem Verlauf gezeichnet.</translation>
    </message>
    <message>
        <source>Organs follow handles around them. Here you edit them at rest: click the organ to add one, drag to move it, Delete to remove it. The organ is bound again at once. I shows how far a handle reaches.</source>
        <translation>Organe folgen den Griffen um sie herum. Hier bearbeiten Sie die Griffe in Ruhe: Klick auf das Organ fügt einen hinzu, Ziehen bewegt ihn, Entf entfernt ihn. Das Organ wird sofort neu gebunden. I zeigt, wie weit ein Griff reicht.</translation>
    </message>
    <message>
        <source>Drag a handle and the organ follows; its volume is in the status bar. The padlock in the list on the left (K) keeps the volume whatever you do. T turns and scales selected handles, M mirrors drags. Ctrl+Z undoes any change, G shows the rest shape as an outline.</source>
        <translation>Ziehen Sie an einem Griff, und das Organ folgt; sein Volumen steht in der Statusleiste. Das Schloss in der Liste links (K) hält das Volumen, was immer Sie tun. T dreht und skaliert gewählte Griffe, M spiegelt das Ziehen. Strg+Z macht jede Änderung rückgängig, G zeigt die Ruheform als Umriss.</translation>
    </message>
    <message>
        <source>The colours say how much the pose distorts the tissue inside. Click the organ to read the values of a point, C cuts it open, M shows the next map. Space plays the sequence, and the map follows.</source>
        <translation>Die Farben zeigen, wie stark die Pose das Gewebe innen verzerrt. Ein Klick auf das Organ zeigt die Werte eines Punktes, C schneidet es auf, M zeigt die nächste Karte. Die Leertaste spielt die Sequenz, und die Karte folgt.</translation>
    </message>
    <message>
        <source>Your own organs</source>
        <translation>Ihre eigenen Organe</translation>
    </message>
    <message>
        <source>Open surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) or label maps (NIfTI, NRRD, DICOM-SEG) with Ctrl+O or drop them here; they get handles at once. Ctrl+S saves all of it as a session. ? lists all keys.</source>
        <translation>Öffnen Sie Oberflächen (STL, OBJ, PLY, OFF, VTK, VTP, GLB) oder Labelmaps (NIfTI, NRRD, DICOM-SEG) mit Strg+O oder legen Sie sie hier ab; sie erhalten sofort Griffe. Strg+S speichert alles als Sitzung. ? listet alle Tasten.</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>The guide, at what the present mode does</source>
        <translation>Das Handbuch, an der Stelle zum jetzigen Modus</translation>
    </message>
    <message>
        <source>&amp;First task: drag a dot</source>
        <translation>&amp;Erste Aufgabe: einen Punkt ziehen</translation>
    </message>
</context>
<context>
    <name>viscera::app::Histogram</name>
    <message>
        <source>Histogram of the map</source>
        <translation>Histogramm der Karte</translation>
    </message>
    <message>
        <source>Number of witness points with each value; the lines mark the mean and the 95th percentile</source>
        <translation>Anzahl der Messpunkte mit jedem Wert; die Linien markieren den Mittelwert und das 95. Perzentil</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportController</name>
    <message>
        <source>Import or cancel the files in the panel first, then open the others.</source>
        <translation>Importieren oder verwerfen Sie zuerst die Dateien im Bedienfeld und öffnen Sie dann die anderen.</translation>
    </message>
    <message>
        <source>Check of %1</source>
        <translation>Prüfung von %1</translation>
    </message>
    <message numerus="yes">
        <source>Check of %n files</source>
        <translation>
            <numerusform>Prüfung von %n Datei</numerusform>
            <numerusform>Prüfung von %n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Repairing: %1</source>
        <translation>Reparatur: %1</translation>
    </message>
    <message>
        <source>Checking again</source>
        <translation>Wird erneut geprüft</translation>
    </message>
    <message>
        <source>%1 of %2 organs could not be repaired that way and stay as they are. The panel says why.</source>
        <translation>%1 von %2 Organen konnten so nicht repariert werden und bleiben, wie sie sind. Das Bedienfeld nennt den Grund.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportPanel</name>
    <message>
        <source>No problems found. Nothing is in the document yet.</source>
        <translation>Keine Probleme gefunden. Noch ist nichts im Dokument.</translation>
    </message>
    <message>
        <source>Check the findings first. Nothing is in the document yet, and no file is changed.</source>
        <translation>Prüfen Sie zuerst die Befunde. Noch ist nichts im Dokument, und keine Datei wird geändert.</translation>
    </message>
    <message>
        <source>%1 organs: %2 with faults, %3 to check, %4 without problems. Nothing is in the document yet, and no file is changed.</source>
        <translation>%1 Organe: %2 mit Fehlern, %3 zu prüfen, %4 ohne Probleme. Noch ist nichts im Dokument, und keine Datei wird geändert.</translation>
    </message>
    <message>
        <source>%1 of %2 organs are not life-sized; a change of unit applies to all organs from surface files</source>
        <translation>%1 von %2 Organen sind nicht lebensgroß; eine andere Einheit gilt für alle Organe aus Oberflächendateien</translation>
    </message>
    <message>
        <source>%1: %2 of %3 organs</source>
        <translation>%1: %2 von %3 Organen</translation>
    </message>
    <message>
        <source>Find an organ</source>
        <translation>Organ suchen</translation>
    </message>
    <message>
        <source>Organs to show, by finding</source>
        <translation>Angezeigte Organe, nach Befund</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Import all organs of this list</source>
        <translation>Alle Organe dieser Liste importieren</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Import no organ of this list</source>
        <translation>Kein Organ dieser Liste importieren</translation>
    </message>
    <message numerus="yes">
        <source>Import %n organs</source>
        <translation>
            <numerusform>%n Organ importieren</numerusform>
            <numerusform>%n Organe importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Import as it is</source>
        <translation>Unverändert importieren</translation>
    </message>
    <message>
        <source>All organs together</source>
        <translation>Alle Organe zusammen</translation>
    </message>
    <message>
        <source>Every organ</source>
        <translation>Jedes Organ</translation>
    </message>
    <message>
        <source>To check</source>
        <translation>Zu prüfen</translation>
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
        <translation>Stellen Sie im Modus Verformen eine Pose ein und drücken Sie Strg+K: Jedes Schlüsselbild speichert diese Pose.</translation>
    </message>
    <message>
        <source>Time of the next key</source>
        <translation>Zeit des nächsten Schlüsselbilds</translation>
    </message>
    <message>
        <source>Easing to the key after it</source>
        <translation>Übergang zum folgenden Schlüsselbild</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Neues Schlüsselbild</translation>
    </message>
    <message>
        <source>Store the present pose as a key (Ctrl+K)</source>
        <translation>Die jetzige Pose als Schlüsselbild speichern (Strg+K)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>easing</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Take pose</source>
        <translation>Pose übernehmen</translation>
    </message>
    <message>
        <source>Set the present pose to that of this key</source>
        <translation>Die jetzige Pose auf die dieses Schlüsselbilds setzen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Store the present pose in this key</source>
        <translation>Die jetzige Pose in diesem Schlüsselbild speichern</translation>
    </message>
    <message>
        <source>Remove this key</source>
        <translation>Dieses Schlüsselbild entfernen</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the key sequence</source>
        <translation>Die Schlüsselbildfolge abspielen</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Save the sequence as a file</source>
        <translation>Die Sequenz als Datei speichern</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>Open a sequence file</source>
        <translation>Eine Sequenzdatei öffnen</translation>
    </message>
    <message>
        <source>Duration </source>
        <translation>Dauer </translation>
    </message>
    <message>
        <source>Sequences (*%1)</source>
        <translation>Sequenzen (*%1)</translation>
    </message>
    <message>
        <source>Save the sequence</source>
        <translation>Sequenz speichern</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Sequenz öffnen</translation>
    </message>
</context>
<context>
    <name>viscera::app::KeySequencePlayback</name>
    <message>
        <source>Record a key at %1 s</source>
        <translation>Schlüsselbild bei %1 s aufzeichnen</translation>
    </message>
    <message>
        <source>Use a key&apos;s pose</source>
        <translation>Pose eines Schlüsselbilds verwenden</translation>
    </message>
    <message>
        <source>Sequence saved as %1</source>
        <translation>Sequenz als %1 gespeichert</translation>
    </message>
</context>
<context>
    <name>viscera::app::LectureScreen</name>
    <message>
        <source>&amp;Lecture</source>
        <translation>&amp;Vortrag</translation>
    </message>
    <message>
        <source>The view alone on the whole screen, in large letters; Page Down shows the next slide, Escape ends it</source>
        <translation>Nur die Ansicht auf dem ganzen Bildschirm, in großer Schrift; Bild ab zeigt die nächste Folie, Escape beendet</translation>
    </message>
    <message>
        <source>&amp;Darken the screen</source>
        <translation>Bildschirm &amp;verdunkeln</translation>
    </message>
    <message>
        <source>&amp;Pressures and volume</source>
        <translation>&amp;Drücke und Volumen</translation>
    </message>
    <message>
        <source>Pressure-volume &amp;loops</source>
        <translation>Druck-Volumen-&amp;Schleifen</translation>
    </message>
    <message>
        <source>&amp;Electrocardiogram</source>
        <translation>&amp;Elektrokardiogramm</translation>
    </message>
    <message>
        <source>Open &amp;valves</source>
        <translation>Offene &amp;Klappen</translation>
    </message>
    <message>
        <source>Heart &amp;sounds</source>
        <translation>&amp;Herztöne</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonDialog</name>
    <message>
        <source>Handles that a reader can drag</source>
        <translation>Griffe, an denen Leser ziehen können</translation>
    </message>
    <message>
        <source>Web page for any browser (.html)</source>
        <translation>Webseite für jeden Browser (.html)</translation>
    </message>
    <message>
        <source>Animated glTF scene (.glb)</source>
        <translation>Animierte glTF-Szene (.glb)</translation>
    </message>
    <message>
        <source>Language of the page&apos;s buttons and messages; the texts below stay as they are</source>
        <translation>Sprache der Schaltflächen und Meldungen der Seite; die Texte unten bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>A reader of the lesson sees only these texts: it holds no file names, no dates and no hidden organs. Check the texts for names of patients; double-click a text to change it.</source>
        <translation>Wer die Lektion liest, sieht nur diese Texte: Sie enthält keine Dateinamen, keine Datumsangaben und keine ausgeblendeten Organe. Prüfen Sie die Texte auf Namen von Patienten; ein Doppelklick auf einen Text ändert ihn.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Speichern unter...</translation>
    </message>
    <message>
        <source>Texts of the lesson</source>
        <translation>Texte der Lektion</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The shape of a head or a face can identify a patient.</source>
        <translation>Die Form eines Kopfs oder Gesichts kann einen Patienten erkennbar machen.</translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation>Sprache des Fensters</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonExport</name>
    <message>
        <source>Export &amp;lesson...</source>
        <translation>&amp;Lektion exportieren...</translation>
    </message>
    <message>
        <source>Write the organs and their motion as one page that opens in any browser</source>
        <translation>Die Organe und ihre Bewegung als eine Seite schreiben, die sich in jedem Browser öffnet</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb)</source>
        <translation>glTF-Szenen (*.glb)</translation>
    </message>
    <message>
        <source>Exporting the lesson</source>
        <translation>Lektion wird exportiert</translation>
    </message>
    <message>
        <source>Written to %1 (%2 MB). The motion in the file differs by at most %3 mm.</source>
        <translation>In %1 geschrieben (%2 MB). Die Bewegung in der Datei weicht um höchstens %3 mm ab.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MainWindow</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>%1: checked, no problems found</source>
        <translation>%1: geprüft, keine Probleme gefunden</translation>
    </message>
    <message>
        <source>Viscera cancelled the drag because you chose another mode.</source>
        <translation>Viscera hat das Ziehen abgebrochen, weil Sie einen anderen Modus gewählt haben.</translation>
    </message>
    <message>
        <source>Close without these files?</source>
        <translation>Ohne diese Dateien schließen?</translation>
    </message>
    <message>
        <source>Viscera is still writing: %1.</source>
        <translation>Viscera schreibt noch: %1.</translation>
    </message>
    <message>
        <source>If you close Viscera now, it does not finish these files.</source>
        <translation>Wenn Sie Viscera jetzt schließen, werden diese Dateien nicht fertig.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;Wait</source>
        <translation>&amp;Warten</translation>
    </message>
    <message>
        <source>View kept as %1</source>
        <translation>Ansicht aufbewahrt als %1</translation>
    </message>
    <message>
        <source>Writing a movie</source>
        <translation>Ein Film wird geschrieben</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>&amp;Einstellungen ...</translation>
    </message>
    <message>
        <source>Language, theme, folders and what is shown at the start</source>
        <translation>Sprache, Farbschema, Ordner und was beim Start gezeigt wird</translation>
    </message>
</context>
<context>
    <name>viscera::app::MarksBox</name>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Draw the values along the straight line at rest between two chosen probes, or between the last two</source>
        <translation>Die Werte entlang der in Ruhe geraden Linie zwischen zwei gewählten Sonden zeichnen, sonst zwischen den letzten beiden</translation>
    </message>
    <message>
        <source>Remove the chosen probes and profiles (Delete in the list)</source>
        <translation>Die gewählten Sonden und Profile entfernen (Entf in der Liste)</translation>
    </message>
    <message>
        <source>Probes and profiles</source>
        <translation>Sonden und Profile</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>%1: at rest %2 mm</source>
        <translation>%1: in Ruhe %2 mm</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>kein Gewebe</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm lang</translation>
    </message>
    <message>
        <source>Profile along the line between two probes; the value is the largest</source>
        <translation>Profil entlang der Linie zwischen zwei Sonden; der Wert ist der größte</translation>
    </message>
    <message>
        <source>Place in the pose: towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S)</source>
        <translation>Ort in der Pose: nach rechts (R) oder links (L), vorn (A) oder hinten (P), zum Fuß (I) oder Kopf (S)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasureBox</name>
    <message>
        <source>Remove the chosen measurement (Delete in the list)</source>
        <translation>Die gewählte Messung entfernen (Entf in der Liste)</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Export CSV...</source>
        <translation>CSV exportieren...</translation>
    </message>
    <message>
        <source>Points stay on the organ while it moves, and can be dragged along it; those on a slice go with the warped scan.</source>
        <translation>Punkte bleiben auf dem Organ, während es sich bewegt, und lassen sich darauf ziehen; Punkte auf einer Schicht gehen mit dem verformten Scan.</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice. Esc ends.</source>
        <translation>Zwei Punkte auf einem Organ oder einer Schicht anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second. Esc ends.</source>
        <translation>Drei Punkte auf einem Organ oder einer Schicht anklicken, den Scheitel als zweiten. Esc beendet.</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner. Esc ends.</source>
        <translation>Auf einer Schicht von Ecke zu Ecke ziehen. Esc beendet.</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border. Esc ends.</source>
        <translation>Auf einer Schicht von der Mitte zum Rand ziehen. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasuredMotion</name>
    <message numerus="yes">
        <source>Motion of %n phases. Mean distance from the measured surfaces: %1.</source>
        <translation>
            <numerusform>Bewegung aus %n Phase. Mittlerer Abstand von den gemessenen Oberflächen: %1.</numerusform>
            <numerusform>Bewegung aus %n Phasen. Mittlerer Abstand von den gemessenen Oberflächen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The series does not show how points move along a wall. The mean and the 95th percentile over the beat are reliable, the local pattern of this map is not.</source>
        <translation>Die Serie zeigt nicht, wie sich Punkte entlang einer Wand bewegen. Mittelwert und 95. Perzentil über den Schlag sind zuverlässig, das örtliche Muster dieser Karte nicht.</translation>
    </message>
    <message>
        <source>Leave out phase %1</source>
        <translation>Phase %1 auslassen</translation>
    </message>
    <message>
        <source>Surface of phase %1</source>
        <translation>Oberfläche der Phase %1</translation>
    </message>
    <message>
        <source>Distance from the measured surface</source>
        <translation>Abstand von den Messdaten</translation>
    </message>
    <message>
        <source>The search for the motion was cancelled.</source>
        <translation>Die Suche nach der Bewegung wurde abgebrochen.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases need attention: see the table beside the chart.</source>
        <translation>
            <numerusform>%n Phase braucht Aufmerksamkeit: siehe die Tabelle neben dem Diagramm.</numerusform>
            <numerusform>%n Phasen brauchen Aufmerksamkeit: siehe die Tabelle neben dem Diagramm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>An estimate of %n phases from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Eine Schätzung von %n Phase aus den Bildern und den Labels der Phase %1 allein. Mittlerer Abstand von Labels und verfolgtem Gewebe: %2.</numerusform>
            <numerusform>Eine Schätzung von %n Phasen aus den Bildern und den Labels der Phase %1 allein. Mittlerer Abstand von Labels und verfolgtem Gewebe: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Motion of %n phases from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Bewegung von %n Phase aus den Bildern und den Labels der Phasen %1. Mittlerer Abstand von Labels und verfolgtem Gewebe: %2.</numerusform>
            <numerusform>Bewegung von %n Phasen aus den Bildern und den Labels der Phasen %1. Mittlerer Abstand von Labels und verfolgtem Gewebe: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Motion from images</source>
        <translation>Bewegung aus Bildern</translation>
    </message>
    <message>
        <source>Not used for the motion</source>
        <translation>Für die Bewegung nicht verwendet</translation>
    </message>
    <message>
        <source>Estimate: %1</source>
        <translation>Schätzung: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::Menus</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Sample &amp;organs</source>
        <translation>Beispiel&amp;organe</translation>
    </message>
    <message>
        <source>Export &amp;more</source>
        <translation>&amp;Weitere Exporte</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Steps</source>
        <translation>&amp;Schritte</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>St&amp;ress map</source>
        <translation>St&amp;resskarte</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>S&amp;can</translation>
    </message>
    <message>
        <source>&amp;Slides</source>
        <translation>&amp;Folien</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Design</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Sp&amp;rache</translation>
    </message>
    <message>
        <source>The next start uses this language: %1.</source>
        <translation>Der nächste Start verwendet diese Sprache: %1.</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>&amp;Organ</translation>
    </message>
    <message>
        <source>Ha&amp;ndles</source>
        <translation>&amp;Griffe</translation>
    </message>
    <message>
        <source>&amp;Mirror drags</source>
        <translation>Ziehen s&amp;piegeln</translation>
    </message>
    <message>
        <source>&amp;Sequence</source>
        <translation>&amp;Sequenz</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Noch nichts geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>%n earlier steps</source>
        <translation>
            <numerusform>%n früherer Schritt</numerusform>
            <numerusform>%n frühere Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>No sample organs are installed</source>
        <translation>Keine Beispielorgane installiert</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Ansicht &amp;von</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>S&amp;hown in lectures and movies</source>
        <translation>In &amp;Vorträgen und Filmen gezeigt</translation>
    </message>
</context>
<context>
    <name>viscera::app::MessageBar</name>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Diese Meldung schließen (Esc)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>viscera::app::MotionDialog</name>
    <message>
        <source>Tissue around cavities</source>
        <translation>Gewebe um Hohlräume</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Find the motion</source>
        <translation>Bewegung bestimmen</translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation>Ordner...</translation>
    </message>
    <message>
        <source>Files...</source>
        <translation>Dateien...</translation>
    </message>
    <message>
        <source>All phases, or one 4D NIfTI or .seq.nrrd</source>
        <translation>Alle Phasen oder ein 4D-NIfTI oder .seq.nrrd</translation>
    </message>
    <message>
        <source>Surfaces of the series</source>
        <translation>Oberflächen der Serie</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Duration of one whole cycle: the number of phases times the step between them</source>
        <translation>Dauer eines ganzen Zyklus: Anzahl der Phasen mal Schritt zwischen ihnen</translation>
    </message>
    <message>
        <source>The last phase leads back to the first</source>
        <translation>Die letzte Phase führt zur ersten zurück</translation>
    </message>
    <message>
        <source>60 for one surface, 120 for several. More follow the surfaces more closely</source>
        <translation>60 für eine Oberfläche, 120 für mehrere. Mehr folgen den Oberflächen genauer</translation>
    </message>
    <message>
        <source>Keep the measured volumes exactly</source>
        <translation>Gemessene Volumina genau halten</translation>
    </message>
    <message>
        <source>Larger distances count less: for label maps with outliers</source>
        <translation>Größere Abstände zählen weniger: für Labelmaps mit Ausreißern</translation>
    </message>
    <message>
        <source>Distances count less beyond</source>
        <translation>Abstände zählen weniger ab</translation>
    </message>
    <message>
        <source>Leave out phases</source>
        <translation>Phasen auslassen</translation>
    </message>
    <message>
        <source>Folder with a series</source>
        <translation>Ordner mit einer Serie</translation>
    </message>
    <message>
        <source>Phases of a series</source>
        <translation>Phasen einer Serie</translation>
    </message>
    <message>
        <source>Reading the series</source>
        <translation>Serie wird gelesen</translation>
    </message>
    <message>
        <source>A single image shows no motion. Open it with File &gt; Open, then choose &quot;Fit a sequence to an organ&quot; in Play mode to give the heart and its chambers the textbook&apos;s beat.</source>
        <translation>Ein einzelnes Bild zeigt keine Bewegung. Öffnen Sie es mit Datei &gt; Öffnen und wählen Sie dann „Sequenz an ein Organ anpassen“ im Modus Abspielen, um das Herz und seine Höhlen wie im Lehrbuch schlagen zu lassen.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Label %1; a double click gives the surface another name</source>
        <translation>Label %1; ein Doppelklick gibt der Oberfläche einen anderen Namen</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 pro Minute</translation>
    </message>
    <message>
        <source>The files do not state it</source>
        <translation>Die Dateien geben es nicht an</translation>
    </message>
    <message>
        <source>No series is chosen.</source>
        <translation>Keine Serie gewählt.</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>%1 wird gelesen ...</translation>
    </message>
    <message numerus="yes">
        <source>%1: label maps, %n phases</source>
        <translation>
            <numerusform>%1: Labelmaps, %n Phase</numerusform>
            <numerusform>%1: Labelmaps, %n Phasen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: surfaces, %n phases</source>
        <translation>
            <numerusform>%1: Oberflächen, %n Phase</numerusform>
            <numerusform>%1: Oberflächen, %n Phasen</numerusform>
        </translation>
    </message>
    <message>
        <source>Working...</source>
        <translation>In Arbeit...</translation>
    </message>
    <message>
        <source>Enter the duration of one cycle first</source>
        <translation>Geben Sie zuerst die Dauer eines Zyklus ein</translation>
    </message>
    <message>
        <source>Outer surface</source>
        <translation>Außenfläche</translation>
    </message>
    <message>
        <source>%1 is not a phase</source>
        <translation>%1 ist keine Phase</translation>
    </message>
    <message>
        <source>name phases by their numbers, counted from 1, as in 3, 7</source>
        <translation>Nennen Sie Phasen mit ihrer Nummer, ab 1 gezählt, wie in 3, 7</translation>
    </message>
    <message>
        <source>Choose a series first</source>
        <translation>Wählen Sie zuerst eine Serie</translation>
    </message>
    <message>
        <source>A single image shows no motion</source>
        <translation>Ein einzelnes Bild zeigt keine Bewegung</translation>
    </message>
    <message>
        <source>Turns one organ, given in several phases of a cycle, into handles and a key sequence with a key for each phase. Choose surfaces or label maps, one file for each phase, or one file with several phases. The result replaces the open organs; Undo brings them back.</source>
        <translation>Macht aus einem Organ, das in mehreren Phasen eines Zyklus vorliegt, Griffe und eine Schlüsselbildfolge mit einem Schlüsselbild je Phase. Wählen Sie Oberflächen oder Labelmaps, eine Datei je Phase, oder eine Datei mit mehreren Phasen. Das Ergebnis ersetzt die offenen Organe; Rückgängig holt sie zurück.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Keine Grenze</translation>
    </message>
    <message>
        <source>For example 3, 7</source>
        <translation>Zum Beispiel 3, 7</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation>Rolle von %1</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Suche abbrechen</translation>
    </message>
    <message>
        <source>What the motion is found from</source>
        <translation>Woraus die Bewegung gefunden wird</translation>
    </message>
    <message>
        <source>Labels or surfaces of every phase</source>
        <translation>Labels oder Oberflächen jeder Phase</translation>
    </message>
    <message>
        <source>Cine images, and labels of a few phases</source>
        <translation>Cine-Bilder und Labels weniger Phasen</translation>
    </message>
    <message>
        <source>Turns the labels of a few phases, the ends of diastole and systole at least, and cine images of the whole cycle into handles and a key sequence with a key for each phase. Volumes of labelled phases are exact; the images show the others. One labelled phase gives an estimate. The result replaces the open organs; Undo brings them back.</source>
        <translation>Macht aus den Labels weniger Phasen, wenigstens der Enden von Diastole und Systole, und Cine-Bildern des ganzen Zyklus Griffe und eine Schlüsselbildfolge mit einem Schlüsselbild je Phase. Volumina markierter Phasen sind genau; die anderen zeigen die Bilder. Eine markierte Phase ergibt eine Schätzung. Das Ergebnis ersetzt die offenen Organe; Rückgängig holt sie zurück.</translation>
    </message>
    <message>
        <source>Leave out series</source>
        <translation>Serien weglassen</translation>
    </message>
    <message>
        <source>The labels are being read</source>
        <translation>Die Labels werden gelesen</translation>
    </message>
    <message>
        <source>Choose other labels: these cannot be read</source>
        <translation>Wählen Sie andere Labels: diese sind nicht lesbar</translation>
    </message>
    <message>
        <source>%1 is not the number of a series</source>
        <translation>%1 ist keine Nummer einer Serie</translation>
    </message>
    <message>
        <source>name series by their numbers, as in 3, 7</source>
        <translation>nennen Sie Serien mit ihren Nummern, wie in 3, 7</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieBox</name>
    <message>
        <source>Choose a destination</source>
        <translation>Ziel wählen</translation>
    </message>
    <message>
        <source> / s</source>
        <translation> / s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Zyklen</translation>
    </message>
    <message>
        <source>Write phase and volumes into it</source>
        <translation>Phase und Volumina hineinschreiben</translation>
    </message>
    <message>
        <source>Table of volumes beside it (.csv)</source>
        <translation>Volumentabelle daneben (.csv)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Record what the view shows</source>
        <translation>Aufnehmen, was die Ansicht zeigt</translation>
    </message>
    <message>
        <source>MP4 and GIF need the program ffmpeg, which is not installed on this computer.</source>
        <translation>MP4 und GIF brauchen das Programm ffmpeg, das auf diesem Rechner nicht installiert ist.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>Record as</source>
        <translation>Aufnehmen als</translation>
    </message>
    <message>
        <source>Cancel the movie</source>
        <translation>Film abbrechen</translation>
    </message>
    <message>
        <source>Discard the movie</source>
        <translation>Film verwerfen</translation>
    </message>
</context>
<context>
    <name>viscera::app::MoviePlan</name>
    <message>
        <source>Ogg movie (.ogv)</source>
        <translation>Ogg-Film (.ogv)</translation>
    </message>
    <message>
        <source>MP4 movie (.mp4)</source>
        <translation>MP4-Film (.mp4)</translation>
    </message>
    <message>
        <source>Animated GIF (.gif)</source>
        <translation>Animiertes GIF (.gif)</translation>
    </message>
    <message>
        <source>PNG pictures (folder)</source>
        <translation>PNG-Bilder (Ordner)</translation>
    </message>
    <message>
        <source>Table of volumes (.csv)</source>
        <translation>Tabelle der Volumina (.csv)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieRecorder</name>
    <message>
        <source>Recording %1</source>
        <translation>%1 wird aufgenommen</translation>
    </message>
</context>
<context>
    <name>viscera::app::NumbersTable</name>
    <message>
        <source>Numbers of the circulation</source>
        <translation>Zahlen des Kreislaufs</translation>
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
        <translation>%1, offen</translation>
    </message>
    <message>
        <source>Import this organ</source>
        <translation>Dieses Organ importieren</translation>
    </message>
    <message numerus="yes">
        <source>%n checks passed</source>
        <translation>
            <numerusform>%n Prüfung bestanden</numerusform>
            <numerusform>%n Prüfungen bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Erledigt: %1</translation>
    </message>
    <message>
        <source>More repairs</source>
        <translation>Weitere Reparaturen</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>Undo the repairs of this organ</source>
        <translation>Die Reparaturen dieses Organs rückgängig machen</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganMenu</name>
    <message>
        <source>&amp;Lock volume</source>
        <translation>Volumen &amp;sperren</translation>
    </message>
    <message>
        <source>Keep the organ&apos;s volume constant in Deform mode; for an organ with cavities, the volume within its outer surface</source>
        <translation>Das Volumen des Organs im Modus Verformen konstant halten; bei einem Organ mit Hohlräumen das Volumen innerhalb seiner Außenfläche</translation>
    </message>
    <message>
        <source>The organ&apos;s own colours</source>
        <translation>Eigene Farben des Organs</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>&amp;Shortest distance of two organs</source>
        <translation>&amp;Kürzester Abstand zweier Organe</translation>
    </message>
    <message>
        <source>Two organs</source>
        <translation>Zwei Organe</translation>
    </message>
    <message>
        <source>Choose two organs in the list: the distance follows them, wherever they are nearest</source>
        <translation>Wählen Sie zwei Organe in der Liste: Der Abstand folgt ihnen, wo immer sie sich am nächsten sind</translation>
    </message>
    <message>
        <source>Choose two organs in the list first, the second one with Ctrl.</source>
        <translation>Wählen Sie zuerst zwei Organe in der Liste, das zweite mit Strg.</translation>
    </message>
    <message>
        <source>&amp;Bends as soft tissue</source>
        <translation>&amp;Biegt sich als weiches Gewebe</translation>
    </message>
    <message>
        <source>Every place of the organ follows the handles</source>
        <translation>Jede Stelle des Organs folgt den Griffen</translation>
    </message>
    <message>
        <source>Moves as a r&amp;igid body</source>
        <translation>Bewegt sich als starrer &amp;Körper</translation>
    </message>
    <message>
        <source>The organ keeps its shape and moves as the tissue around it does on the whole; so do bones</source>
        <translation>Das Organ behält seine Form und bewegt sich wie das Gewebe um es im Ganzen; so auch Knochen</translation>
    </message>
    <message>
        <source>Stays in &amp;place</source>
        <translation>Bleibt an Ort und &amp;Stelle</translation>
    </message>
    <message>
        <source>No handle moves the organ</source>
        <translation>Kein Griff bewegt das Organ</translation>
    </message>
    <message>
        <source>Textbook colours</source>
        <translation>Lehrbuchfarben</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganPanel</name>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>No organ yet.
Open a file (Ctrl+O), drop one here, or take a sample organ from the menu.</source>
        <translation>Noch kein Organ.
Öffnen Sie eine Datei (Strg+O), ziehen Sie eine hierher oder nehmen Sie ein Beispielorgan aus dem Menü.</translation>
    </message>
    <message>
        <source>Find an organ (Ctrl+F)</source>
        <translation>Organ suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Show &amp;only this</source>
        <translation>N&amp;ur dieses zeigen</translation>
    </message>
    <message>
        <source>Show the chosen organs with their cavities and hide all others</source>
        <translation>Die gewählten Organe mit ihren Hohlräumen zeigen und alle anderen ausblenden</translation>
    </message>
    <message>
        <source>&amp;Hide this</source>
        <translation>Dieses aus&amp;blenden</translation>
    </message>
    <message>
        <source>Hide the chosen organs</source>
        <translation>Die gewählten Organe ausblenden</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Alle zeigen</translation>
    </message>
    <message>
        <source>Show every organ</source>
        <translation>Jedes Organ zeigen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>&amp;Find an organ</source>
        <translation>Organ &amp;suchen</translation>
    </message>
    <message>
        <source>Type a part of its name</source>
        <translation>Geben Sie einen Teil seines Namens ein</translation>
    </message>
    <message>
        <source>Re&amp;name organ</source>
        <translation>Organ u&amp;mbenennen</translation>
    </message>
    <message>
        <source>&amp;Remove organ</source>
        <translation>Organ &amp;entfernen</translation>
    </message>
    <message>
        <source>Hide all of them (click)</source>
        <translation>Alle ausblenden (Klick)</translation>
    </message>
    <message>
        <source>Show all of them (click)</source>
        <translation>Alle zeigen (Klick)</translation>
    </message>
    <message>
        <source>Hide (click)</source>
        <translation>Ausblenden (Klick)</translation>
    </message>
    <message>
        <source>Show (click)</source>
        <translation>Zeigen (Klick)</translation>
    </message>
    <message numerus="yes">
        <source>%1
%n triangles</source>
        <translation>
            <numerusform>%1
%n Dreieck</numerusform>
            <numerusform>%1
%n Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>
Double click or F2 renames; a click on the square changes the colour</source>
        <translation>
Doppelklick oder F2 benennt um; ein Klick auf das Quadrat ändert die Farbe</translation>
    </message>
    <message>
        <source>An open surface has no volume to lock; click to close its holes</source>
        <translation>Eine offene Oberfläche hat kein Volumen zum Sperren; Klick schließt ihre Löcher</translation>
    </message>
    <message>
        <source>The volume is locked: Deform mode keeps it (click or K to unlock)</source>
        <translation>Das Volumen ist gesperrt: Der Modus Verformen hält es (Klick oder K entsperrt)</translation>
    </message>
    <message>
        <source>Lock the volume (click or K)</source>
        <translation>Volumen sperren (Klick oder K)</translation>
    </message>
    <message>
        <source>
This is the volume within the outer surface; cavities have locks of their own</source>
        <translation>
Dies ist das Volumen innerhalb der Außenfläche; Hohlräume haben eigene Sperren</translation>
    </message>
    <message>
        <source>
This is the volume of the cavity; the wall around it has a lock of its own</source>
        <translation>
Dies ist das Volumen des Hohlraums; die Wand um ihn hat eine eigene Sperre</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>An open surface encloses no volume</source>
        <translation>Eine offene Oberfläche schließt kein Volumen ein</translation>
    </message>
    <message>
        <source>%1 at rest, %2 (%3) now</source>
        <translation>%1 in Ruhe, jetzt %2 (%3)</translation>
    </message>
    <message numerus="yes">
        <source>%n organs removed</source>
        <translation>
            <numerusform>%n Organ entfernt</numerusform>
            <numerusform>%n Organe entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs and all handles removed</source>
        <translation>
            <numerusform>%n Organ und alle Griffe entfernt</numerusform>
            <numerusform>%n Organe und alle Griffe entfernt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
    <message>
        <source>The sample organ is being made.</source>
        <translation>Das Beispielorgan wird erzeugt.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PanelDock</name>
    <message>
        <source>Float or dock the panel %1</source>
        <translation>Bedienfeld %1 lösen oder andocken</translation>
    </message>
    <message>
        <source>Hide the panel %1 (the View menu shows it again)</source>
        <translation>Bedienfeld %1 ausblenden (das Menü Ansicht zeigt es wieder)</translation>
    </message>
</context>
<context>
    <name>viscera::app::PasswordDialog</name>
    <message>
        <source>Keep it in the system&apos;s key ring</source>
        <translation>Im Schlüsselbund des Systems behalten</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Password of %1 at %2</source>
        <translation>Passwort von %1 bei %2</translation>
    </message>
    <message>
        <source>Else Viscera asks again after the next start</source>
        <translation>Sonst fragt Viscera nach dem nächsten Start wieder</translation>
    </message>
    <message>
        <source>There is no key ring; Viscera asks again after the next start</source>
        <translation>Es gibt keinen Schlüsselbund; Viscera fragt nach dem nächsten Start wieder</translation>
    </message>
    <message>
        <source>The archive refuses the user name or the password.</source>
        <translation>Das Archiv lehnt Benutzername oder Passwort ab.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PatientOffer</name>
    <message>
        <source>Searching beside %1</source>
        <translation>Suche neben %1</translation>
    </message>
    <message>
        <source>Open the scan</source>
        <translation>Scan öffnen</translation>
    </message>
    <message>
        <source>Open its organs</source>
        <translation>Deren Organe öffnen</translation>
    </message>
    <message>
        <source>The scan %2 has the same voxels as %1.</source>
        <translation>Der Scan %2 hat dieselben Voxel wie %1.</translation>
    </message>
    <message>
        <source>The label map %2 has the same voxels as %1.</source>
        <translation>Die Labelmap %2 hat dieselben Voxel wie %1.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PersonBox</name>
    <message>
        <source>Women and men</source>
        <translation>Frauen, Männer</translation>
    </message>
    <message>
        <source>Women</source>
        <translation>Frauen</translation>
    </message>
    <message>
        <source>Men</source>
        <translation>Männer</translation>
    </message>
    <message>
        <source>Whose normal ranges are shown</source>
        <translation>Wessen Normbereiche gezeigt werden</translation>
    </message>
    <message>
        <source> m²</source>
        <translation> m²</translation>
    </message>
    <message>
        <source>any body surface area</source>
        <translation>jede Körperoberfläche</translation>
    </message>
    <message>
        <source>Body surface area: ranges that the source gives per square metre are scaled by it</source>
        <translation>Körperoberfläche: Bereiche, die die Quelle je Quadratmeter angibt, werden damit skaliert</translation>
    </message>
</context>
<context>
    <name>viscera::app::PhaseScrubber</name>
    <message>
        <source>Instant of the cycle</source>
        <translation>Zeitpunkt im Zyklus</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys</source>
        <translation>Ziehen oder Pfeiltasten verwenden</translation>
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
        <translation>Ebene</translation>
    </message>
    <message>
        <source>in this phase</source>
        <translation>in dieser Phase</translation>
    </message>
    <message>
        <source>weight %</source>
        <translation>Gewicht %</translation>
    </message>
    <message>
        <source>likeness %</source>
        <translation>Ähnlichkeit %</translation>
    </message>
    <message>
        <source>arrives mm</source>
        <translation>Ankunft mm</translation>
    </message>
    <message>
        <source>apart mm</source>
        <translation>Abstand mm</translation>
    </message>
    <message>
        <source>over the beat</source>
        <translation>über den Schlag</translation>
    </message>
    <message>
        <source>Series or slice, and what it shows of the heart</source>
        <translation>Serie oder Schicht, und was sie vom Herzen zeigt</translation>
    </message>
    <message>
        <source>What the plane says of the phase that is shown</source>
        <translation>Was die Ebene über die gezeigte Phase sagt</translation>
    </message>
    <message>
        <source>Mean weight of its contours over the beat</source>
        <translation>Mittleres Gewicht ihrer Konturen über den Schlag</translation>
    </message>
    <message>
        <source>How alike its images are around the wall, over the beat</source>
        <translation>Wie ähnlich ihre Bilder um die Wand sind, über den Schlag</translation>
    </message>
    <message>
        <source>How far its tissue arrives from the next labelled surface</source>
        <translation>Wie weit ihr Gewebe von der nächsten markierten Oberfläche ankommt</translation>
    </message>
    <message>
        <source>Distance of its tissue from the surfaces</source>
        <translation>Abstand ihres Gewebes von den Oberflächen</translation>
    </message>
    <message>
        <source>Why the plane says little</source>
        <translation>Warum die Ebene wenig sagt</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayMode</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Space plays or pauses; drag the timeline to look at one instant</source>
        <translation>Leertaste spielt ab oder hält an; ziehen Sie an der Zeitleiste, um einen Zeitpunkt zu betrachten</translation>
    </message>
    <message>
        <source>Slow &amp;motion</source>
        <translation>Zeit&amp;lupe</translation>
    </message>
    <message>
        <source>Slower, down to a tenth; then real time again</source>
        <translation>Langsamer, bis zu einem Zehntel; dann wieder Echtzeit</translation>
    </message>
    <message>
        <source>&amp;Chart of one cycle</source>
        <translation>&amp;Diagramm eines Zyklus</translation>
    </message>
    <message>
        <source>Draw one cycle with a cursor instead of the last seconds</source>
        <translation>Einen Zyklus mit Cursor zeichnen statt der letzten Sekunden</translation>
    </message>
    <message>
        <source>&amp;ECG, sounds and valves</source>
        <translation>&amp;EKG, Töne und Klappen</translation>
    </message>
    <message>
        <source>Under the phases of a heart: a schematic electrocardiogram, S1 and S2, and which valves are open</source>
        <translation>Unter den Phasen eines Herzens: ein schematisches Elektrokardiogramm, S1 und S2 und welche Klappen offen sind</translation>
    </message>
    <message>
        <source>&amp;Valves and flow</source>
        <translation>&amp;Klappen und Fluss</translation>
    </message>
    <message>
        <source>Record a &amp;key</source>
        <translation>Schl&amp;üsselbild aufzeichnen</translation>
    </message>
    <message>
        <source>Add the present pose to the key sequence</source>
        <translation>Die jetzige Pose der Schlüsselbildfolge hinzufügen</translation>
    </message>
    <message>
        <source>Motion from a ser&amp;ies...</source>
        <translation>Bewegung aus einer Ser&amp;ie...</translation>
    </message>
    <message>
        <source>Compare two &amp;rates</source>
        <translation>Zwei &amp;Frequenzen vergleichen</translation>
    </message>
    <message>
        <source>Show the same organs beside these at another rate, or with the circulation kept as before</source>
        <translation>Dieselben Organe daneben bei anderer Frequenz zeigen oder mit dem zuvor gemerkten Kreislauf</translation>
    </message>
    <message>
        <source>Compare &amp;coordinates</source>
        <translation>&amp;Koordinaten vergleichen</translation>
    </message>
    <message>
        <source>Show the same organs and handles beside these with another coordinate system</source>
        <translation>Dieselben Organe und Griffe daneben mit einem anderen Koordinatensystem zeigen</translation>
    </message>
    <message>
        <source>Compare with another &amp;organ...</source>
        <translation>Mit anderem &amp;Organ vergleichen...</translation>
    </message>
    <message>
        <source>Open files in a second view beside these organs</source>
        <translation>Dateien in einer zweiten Ansicht neben diesen Organen öffnen</translation>
    </message>
    <message>
        <source>Compare with the te&amp;xtbook&apos;s heart</source>
        <translation>Mit dem Herzen des Lehr&amp;buchs vergleichen</translation>
    </message>
    <message>
        <source>Show the sample heart with its textbook beat beside these organs, at their rate</source>
        <translation>Das Beispielherz mit seinem Schlag nach Lehrbuch neben diesen Organen zeigen, bei deren Frequenz</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>Eine A&amp;nsicht</translation>
    </message>
    <message>
        <source>Close the second view</source>
        <translation>Die zweite Ansicht schließen</translation>
    </message>
    <message>
        <source>&amp;Pressures and loops</source>
        <translation>D&amp;rücke und Schleifen</translation>
    </message>
    <message>
        <source>Where a circulation moves the heart, show its curves below the view instead of the volumes</source>
        <translation>Wo ein Kreislauf das Herz bewegt, unter der Ansicht dessen Kurven statt der Volumina zeigen</translation>
    </message>
    <message>
        <source>Keep circ&amp;ulation for comparison</source>
        <translation>Kreislauf zum &amp;Vergleich behalten</translation>
    </message>
    <message>
        <source>Keep this circulation to compare with: dashed loops and a second column of numbers</source>
        <translation>Diesen Kreislauf zum Vergleich merken: gestrichelte Schleifen und eine zweite Spalte mit Zahlen</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Den Vergleich beenden</translation>
    </message>
    <message>
        <source>Organ &amp;labels</source>
        <translation>Organ&amp;namen</translation>
    </message>
    <message>
        <source>Write names beside the organs</source>
        <translation>Namen neben die Organe schreiben</translation>
    </message>
    <message>
        <source>See &amp;through</source>
        <translation>Durchsich&amp;tig</translation>
    </message>
    <message>
        <source>Make the wall translucent, so that the cavities are seen</source>
        <translation>Die Wand durchscheinend machen, damit die Hohlräume zu sehen sind</translation>
    </message>
    <message>
        <source>See through</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Key at %1 s</source>
        <translation>Schlüsselbild bei %1 s</translation>
    </message>
    <message>
        <source>Recorded as %1</source>
        <translation>Aufgezeichnet als %1</translation>
    </message>
    <message>
        <source>Compare with the present &amp;pose</source>
        <translation>Mit der &amp;jetzigen Pose vergleichen</translation>
    </message>
    <message>
        <source>Only the sample heart has valves to show</source>
        <translation>Nur das Beispielherz hat Klappen, die gezeigt werden können</translation>
    </message>
    <message>
        <source>In the beating sample heart: leaflets as far open as the valves are, and arrows whose width shows the opening and whose length shows the speed of the blood</source>
        <translation>Im schlagenden Beispielherz: Segel, so weit geöffnet wie die Klappen, und Pfeile, deren Breite die Öffnung und deren Länge die Geschwindigkeit des Blutes zeigt</translation>
    </message>
    <message>
        <source>This sequence has no valves; choose the heartbeat</source>
        <translation>Diese Sequenz hat keine Klappen; wählen Sie den Herzschlag</translation>
    </message>
    <message>
        <source>Show the present pose in a second view, to compare it with later poses</source>
        <translation>Die jetzige Pose in einer zweiten Ansicht zeigen, um sie mit späteren Posen zu vergleichen</translation>
    </message>
    <message>
        <source>&amp;Discard kept circulation</source>
        <translation>Behaltenen Krei&amp;slauf verwerfen</translation>
    </message>
    <message>
        <source>Make the wall opaque</source>
        <translation>Wand undurchsichtig machen</translation>
    </message>
    <message>
        <source>The movie does not show distance colours, measured surfaces or warped slices.</source>
        <translation>Der Film zeigt keine Abstandsfarben, keine gemessenen Oberflächen und keine verformten Schichten.</translation>
    </message>
    <message>
        <source>Below the view, show curves and bull&apos;s eye of the heart&apos;s strain instead of the volumes</source>
        <translation>Unter der Ansicht Kurven und Bull’s Eye der Verformung des Herzens statt der Volumen zeigen</translation>
    </message>
    <message>
        <source>Colour the heart&apos;s wall by the strain of its segments; a click chooses one</source>
        <translation>Die Herzwand nach der Verformung ihrer Segmente färben; ein Klick wählt eines</translation>
    </message>
    <message>
        <source>Compute a patient&apos;s own motion from surfaces or label maps of each phase of the cycle, or from cine images and the labels of a few phases</source>
        <translation>Die eigene Bewegung eines Patienten aus Oberflächen oder Labelmaps jeder Phase des Zyklus berechnen, oder aus Cine-Bildern und den Labels weniger Phasen</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayPage</name>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Source of the motion</source>
        <translation>Quelle der Bewegung</translation>
    </message>
    <message>
        <source>During one cycle</source>
        <translation>Über den Zyklus</translation>
    </message>
    <message>
        <source>max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>SV</source>
        <translation>SV</translation>
    </message>
    <message>
        <source>EF</source>
        <translation>EF</translation>
    </message>
    <message>
        <source>Volumes in ml. SV is the stroke volume, EF the ejection fraction.</source>
        <translation>Volumina in ml. SV ist das Schlagvolumen, EF die Ejektionsfraktion.</translation>
    </message>
    <message>
        <source>Circulation of this heart</source>
        <translation>Kreislauf dieses Herzens</translation>
    </message>
    <message>
        <source>Finds pressures, loops and sounds for the volume and the ejection fraction of this left ventricle. The organ keeps its own motion.</source>
        <translation>Bestimmt Drücke, Schleifen und Töne zu Volumen und Ejektionsfraktion dieses linken Ventrikels. Das Organ behält seine eigene Bewegung.</translation>
    </message>
    <message>
        <source>Record a movie</source>
        <translation>Film aufnehmen</translation>
    </message>
    <message>
        <source>Key sequence</source>
        <translation>Schlüsselbildfolge</translation>
    </message>
    <message>
        <source>Fit a sequence to an organ</source>
        <translation>Sequenz an ein Organ anpassen</translation>
    </message>
    <message>
        <source>%1 / min, one cycle %2 s</source>
        <translation>%1 / min, ein Zyklus %2 s</translation>
    </message>
    <message>
        <source>%1, measured on the surfaces. Healthy adults: %2</source>
        <translation>%1, an den Oberflächen gemessen. Gesunde Erwachsene: %2</translation>
    </message>
    <message>
        <source>%1: %2; %3</source>
        <translation>%1: %2; %3</translation>
    </message>
    <message>
        <source>Normal for %1: %2.</source>
        <translation>Normal für %1: %2.</translation>
    </message>
    <message>
        <source>An estimate: only one phase of the images has labels</source>
        <translation>Eine Schätzung: nur eine Phase der Bilder hat Labels</translation>
    </message>
</context>
<context>
    <name>viscera::app::Playback</name>
    <message>
        <source>The sequence %1 moves its own handles, but the document has others.</source>
        <translation>Die Sequenz %1 bewegt eigene Griffe, aber das Dokument hat andere.</translation>
    </message>
    <message>
        <source>Use its handles</source>
        <translation>Deren Griffe verwenden</translation>
    </message>
    <message>
        <source>posed by hand</source>
        <translation>von Hand verformt</translation>
    </message>
</context>
<context>
    <name>viscera::app::PoseEditor</name>
    <message numerus="yes">
        <source>Reset %n handles</source>
        <translation>
            <numerusform>%n Griff zurücksetzen</numerusform>
            <numerusform>%n Griffe zurücksetzen</numerusform>
        </translation>
    </message>
    <message>
        <source>The handles could not move back all the way: %1.</source>
        <translation>Die Griffe konnten nicht ganz zurückbewegt werden: %1.</translation>
    </message>
    <message>
        <source>Volume %1</source>
        <translation>Volumen %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 is open (%n boundary edges), so it has no volume that could be locked.</source>
        <translation>
            <numerusform>%1 ist offen (%n Randkante) und hat daher kein Volumen, das gesperrt werden könnte.</numerusform>
            <numerusform>%1 ist offen (%n Randkanten) und hat daher kein Volumen, das gesperrt werden könnte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Close the holes and lock</source>
        <translation>Löcher schließen und sperren</translation>
    </message>
    <message>
        <source>Close holes and lock volume</source>
        <translation>Löcher schließen und Volumen sperren</translation>
    </message>
    <message>
        <source>These organs are open, so they have no volumes that could be locked: %1.</source>
        <translation>Diese Organe sind offen und haben keine Volumina, die sich sperren ließen: %1.</translation>
    </message>
    <message>
        <source>the locked volume leaves %1 of %2 mm</source>
        <translation>das gesperrte Volumen lässt %1 von %2 mm zu</translation>
    </message>
    <message>
        <source>Move exactly, others compensate</source>
        <translation>Genau bewegen, andere gleichen aus</translation>
    </message>
</context>
<context>
    <name>viscera::app::PositionBox</name>
    <message>
        <source>No handle is selected. Click one in the view or in the list.</source>
        <translation>Kein Griff ist gewählt. Klicken Sie einen in der Ansicht oder in der Liste an.</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Griff %1</translation>
    </message>
    <message>
        <source>, %1 mm from rest</source>
        <translation>, %1 mm aus der Ruhelage</translation>
    </message>
    <message>
        <source>, locked</source>
        <translation>, gesperrt</translation>
    </message>
    <message>
        <source>Place in the patient</source>
        <translation>Ort im Patienten</translation>
    </message>
    <message>
        <source>Right or left</source>
        <translation>Rechts oder links</translation>
    </message>
    <message>
        <source>Front or back</source>
        <translation>Vorn oder hinten</translation>
    </message>
    <message>
        <source>Foot or head</source>
        <translation>Fuß oder Kopf</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProbeCard</name>
    <message>
        <source>Surface point %1</source>
        <translation>Oberflächenpunkt %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Witness point %1</source>
        <translation>Messpunkt %1</translation>
    </message>
    <message>
        <source>At rest %1 mm</source>
        <translation>In Ruhe %1 mm</translation>
    </message>
    <message>
        <source>Towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S), mm</source>
        <translation>Nach rechts (R) oder links (L), vorn (A) oder hinten (P), zum Fuß (I) oder Kopf (S), mm</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProfileChart</name>
    <message>
        <source>Profile along the line</source>
        <translation>Profil entlang der Linie</translation>
    </message>
</context>
<context>
    <name>viscera::app::QuizTool</name>
    <message>
        <source>%1 right, %2 wrong</source>
        <translation>%1 richtig, %2 falsch</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Keine von beiden</translation>
    </message>
    <message>
        <source>%1: which valve is open?</source>
        <translation>%1: Welche Klappe ist offen?</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nein. %1</translation>
    </message>
    <message>
        <source>Click: %1</source>
        <translation>Anklicken: %1</translation>
    </message>
    <message>
        <source>All %1 found without a mistake.</source>
        <translation>Alle %1 ohne Fehler gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>All %1 found, with %n mistakes.</source>
        <translation>
            <numerusform>Alle %1 gefunden, mit %n Fehler.</numerusform>
            <numerusform>Alle %1 gefunden, mit %n Fehlern.</numerusform>
        </translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Richtig: %1</translation>
    </message>
    <message>
        <source>No, that is nearer to: %1</source>
        <translation>Nein, näher liegt: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::RepairValueBox</name>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Life size</source>
        <translation>Lebensgröße</translation>
    </message>
    <message>
        <source>The factor by which the organ gets the usual volume of its kind</source>
        <translation>Der Faktor, durch den das Organ das übliche Volumen seiner Art bekommt</translation>
    </message>
    <message>
        <source>About %1 triangles. Details smaller than %2 mm are lost.</source>
        <translation>Etwa %1 Dreiecke. Einzelheiten unter %2 mm gehen verloren.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Repairs</name>
    <message>
        <source>Turn triangles outward</source>
        <translation>Nach außen richten</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>Größtes Stück behalten</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>Neu vernetzen</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>Convert from RAS to LPS</source>
        <translation>Von RAS in LPS umrechnen</translation>
    </message>
    <message>
        <source>Convert from Y up to LPS</source>
        <translation>Von Y oben in LPS umrechnen</translation>
    </message>
    <message>
        <source>Coordinates are in %1</source>
        <translation>Koordinaten sind in %1</translation>
    </message>
    <message>
        <source>Remove small fragments</source>
        <translation>Kleine Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
</context>
<context>
    <name>viscera::app::ReportExport</name>
    <message>
        <source>&amp;Report...</source>
        <translation>&amp;Bericht...</translation>
    </message>
    <message>
        <source>Write pictures, volumes, measurements, stress and motion as PDF or as one HTML page</source>
        <translation>Bilder, Volumina, Messungen, Stress und Bewegung als PDF oder als eine HTML-Seite schreiben</translation>
    </message>
    <message>
        <source>&amp;Copy as commands</source>
        <translation>Als Befehle &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the session as a script of viscera commands that gives the same result</source>
        <translation>Die Sitzung als Skript von viscera-Befehlen kopieren, das dasselbe Ergebnis liefert</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf);;Web pages (*.html)</source>
        <translation>PDF-Dokumente (*.pdf);;Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pages.</source>
        <translation>
            <numerusform>%1: %n Seite.</numerusform>
            <numerusform>%1: %n Seiten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copying as commands</source>
        <translation>Als Befehle kopieren</translation>
    </message>
    <message numerus="yes">
        <source>%n commands are in the clipboard.</source>
        <translation>
            <numerusform>%n Befehl ist in der Zwischenablage.</numerusform>
            <numerusform>%n Befehle sind in der Zwischenablage.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ResectionBox</name>
    <message>
        <source>Volumes on both sides of the cut</source>
        <translation>Volumen auf beiden Seiten des Schnitts</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Weggeschnitten</translation>
    </message>
    <message>
        <source>The volumes of the visible, closed organs on both sides of the plane, in this pose</source>
        <translation>Die Volumen der sichtbaren, geschlossenen Organe auf beiden Seiten der Ebene, in dieser Pose</translation>
    </message>
    <message>
        <source>Cut face %1 cm²</source>
        <translation>Schnittfläche %1 cm²</translation>
    </message>
</context>
<context>
    <name>viscera::app::ResidualTable</name>
    <message>
        <source>largest volume</source>
        <translation>größtes Volumen</translation>
    </message>
    <message>
        <source>smallest volume</source>
        <translation>kleinstes Volumen</translation>
    </message>
    <message>
        <source>Surface whose fit is shown</source>
        <translation>Oberfläche, deren Anpassung gezeigt wird</translation>
    </message>
    <message>
        <source>Measured surface</source>
        <translation>Gemessene Oberfläche</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Fit of the motion, phase by phase</source>
        <translation>Anpassung der Bewegung, Phase für Phase</translation>
    </message>
    <message>
        <source>mean mm</source>
        <translation>Mittel mm</translation>
    </message>
    <message>
        <source>95 % mm</source>
        <translation>95 % mm</translation>
    </message>
    <message>
        <source>max mm</source>
        <translation>max. mm</translation>
    </message>
    <message>
        <source>measured ml</source>
        <translation>gemessen ml</translation>
    </message>
    <message>
        <source>unconstrained ml</source>
        <translation>frei ml</translation>
    </message>
    <message>
        <source>fitted ml</source>
        <translation>angepasst ml</translation>
    </message>
    <message>
        <source>Dice</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>umgeklappt</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>gefaltet</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Time of the phase</source>
        <translation>Zeit der Phase</translation>
    </message>
    <message>
        <source>Distance of the fitted surface from the measured surface, weighted by area</source>
        <translation>Abstand der angepassten von der gemessenen Oberfläche, nach Fläche gewichtet</translation>
    </message>
    <message>
        <source>95 % of the area lies within this distance</source>
        <translation>95 % der Fläche liegen innerhalb dieses Abstands</translation>
    </message>
    <message>
        <source>The largest distance</source>
        <translation>Der größte Abstand</translation>
    </message>
    <message>
        <source>Volume that was measured</source>
        <translation>Gemessenes Volumen</translation>
    </message>
    <message>
        <source>Volume of the fit before it is brought to the measured volume</source>
        <translation>Volumen der Anpassung, bevor sie auf das gemessene Volumen gebracht wird</translation>
    </message>
    <message>
        <source>Volume of the fit</source>
        <translation>Volumen der Anpassung</translation>
    </message>
    <message>
        <source>Triangles that face the wrong way</source>
        <translation>Dreiecke, die in die falsche Richtung zeigen</translation>
    </message>
    <message>
        <source>Places in the tissue that are folded</source>
        <translation>Stellen im Gewebe, die gefaltet sind</translation>
    </message>
    <message>
        <source>Steps that the fit took</source>
        <translation>Schritte, die die Anpassung brauchte</translation>
    </message>
    <message>
        <source>Differences from the previous series</source>
        <translation>Was sich von der vorigen Serie unterscheidet</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>All surfaces</source>
        <translation>Alle Oberflächen</translation>
    </message>
    <message>
        <source>Compared with the previous series</source>
        <translation>Verglichen mit der vorigen Serie</translation>
    </message>
    <message>
        <source>%1: EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1: EF %2 %, %3 bis %4 ml, %5 l/min</translation>
    </message>
    <message>
        <source>tissue %1 to %2 ml</source>
        <translation>Gewebe %1 bis %2 ml</translation>
    </message>
    <message>
        <source>A session does not keep the measured surfaces. To see them, find the motion again: Sequence &gt; Motion from a series</source>
        <translation>Eine Sitzung behält die gemessenen Oberflächen nicht. Um sie zu sehen, bestimmen Sie die Bewegung erneut: Sequenz &gt; Bewegung aus einer Serie</translation>
    </message>
    <message>
        <source>Colour the organs by their distance from the measured surfaces of the nearest phase</source>
        <translation>Die Organe nach ihrem Abstand von den gemessenen Oberflächen der nächsten Phase färben</translation>
    </message>
    <message>
        <source>A mark shows that the phase needs attention; the row&apos;s tooltip gives the reason</source>
        <translation>Eine Marke zeigt, dass die Phase Aufmerksamkeit braucht; der Tooltip der Zeile nennt den Grund</translation>
    </message>
    <message>
        <source>Dice coefficient of the voxels; 1 if all agree</source>
        <translation>Dice-Koeffizient der Voxel; 1, wenn alle übereinstimmen</translation>
    </message>
    <message>
        <source>Show the measured surfaces of the nearest phase, translucent</source>
        <translation>Die gemessenen Oberflächen der nächsten Phase durchscheinend zeigen</translation>
    </message>
    <message>
        <source>from</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>wall ml</source>
        <translation>Wand ml</translation>
    </message>
    <message>
        <source>Whether the phase has labels, or was found in the images</source>
        <translation>Ob die Phase Labels hat oder in den Bildern gefunden wurde</translation>
    </message>
    <message>
        <source>Volume of the wall as a check: muscle hardly changes it. More than 10 % beyond the labelled phases needs attention</source>
        <translation>Volumen der Wand als Probe: Muskel ändert es kaum. Mehr als 10 % jenseits der markierten Phasen verlangt Aufmerksamkeit</translation>
    </message>
    <message>
        <source>Estimate from the labels of one phase</source>
        <translation>Schätzung aus den Labels einer Phase</translation>
    </message>
    <message>
        <source>%1: about EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1: etwa EF %2 %, %3 bis %4 ml, %5 l/min</translation>
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
        <translation>Eine Schätzung: diese Phase hat keine Labels, und nur eine hat welche.</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>images</source>
        <translation>Bildern</translation>
    </message>
</context>
<context>
    <name>viscera::app::SampleNames</name>
    <message>
        <source>digestive system</source>
        <translation>Verdauungssystem</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>stomach and bowel</source>
        <translation>Magen und Darm</translation>
    </message>
</context>
<context>
    <name>viscera::app::ScanActions</name>
    <message>
        <source>Soft &amp;tissue</source>
        <translation>&amp;Weichteile</translation>
    </message>
    <message>
        <source>&amp;Lung</source>
        <translation>&amp;Lunge</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Knochen</translation>
    </message>
    <message>
        <source>B&amp;rain</source>
        <translation>&amp;Gehirn</translation>
    </message>
    <message>
        <source>Li&amp;ver</source>
        <translation>L&amp;eber</translation>
    </message>
    <message>
        <source>&amp;Angiography</source>
        <translation>&amp;Angiographie</translation>
    </message>
    <message>
        <source>&amp;3D view alone</source>
        <translation>Nur &amp;3D-Ansicht</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>&amp;Axial slice</source>
        <translation>&amp;Axiale Schicht</translation>
    </message>
    <message>
        <source>&amp;Coronal slice</source>
        <translation>&amp;Koronale Schicht</translation>
    </message>
    <message>
        <source>&amp;Sagittal slice</source>
        <translation>&amp;Sagittale Schicht</translation>
    </message>
    <message>
        <source>Open a &amp;scan...</source>
        <translation>&amp;Scan öffnen...</translation>
    </message>
    <message>
        <source>Open a CT or MR beside the organs</source>
        <translation>CT oder MR neben den Organen öffnen</translation>
    </message>
    <message>
        <source>Open a DICOM &amp;series...</source>
        <translation>&amp;DICOM-Serie öffnen...</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files as a scan</source>
        <translation>Einen Ordner mit DICOM-Dateien als Scan öffnen</translation>
    </message>
    <message>
        <source>C&amp;lose the scan</source>
        <translation>Scan schl&amp;ießen</translation>
    </message>
    <message>
        <source>Close the scan; the organs stay</source>
        <translation>Den Scan schließen; die Organe bleiben</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomatisch</translation>
    </message>
    <message>
        <source>Level and width that the scan&apos;s file proposes, or found from its values</source>
        <translation>Fenstermitte und -weite, wie die Datei des Scans sie vorschlägt oder aus seinen Werten bestimmt</translation>
    </message>
    <message>
        <source>Level %1, width %2</source>
        <translation>Mitte %1, Weite %2</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>K&amp;onturen</translation>
    </message>
    <message>
        <source>Draw the organs&apos; contours on the slices</source>
        <translation>Die Konturen der Organe auf die Schichten zeichnen</translation>
    </message>
    <message>
        <source>Contours at &amp;rest</source>
        <translation>Konturen in &amp;Ruhe</translation>
    </message>
    <message>
        <source>Draw thin contours of the organs at rest as well</source>
        <translation>Auch dünne Konturen der Organe in Ruhe zeichnen</translation>
    </message>
    <message>
        <source>Slices in the &amp;3D view</source>
        <translation>Schichten in der 3&amp;D-Ansicht</translation>
    </message>
    <message>
        <source>&amp;Warp the scan</source>
        <translation>Scan &amp;verformen</translation>
    </message>
    <message>
        <source>Show the scan as the pose warps it</source>
        <translation>Den Scan so zeigen, wie die Pose ihn verformt</translation>
    </message>
    <message>
        <source>S&amp;mooth between voxels</source>
        <translation>Zwischen Voxeln &amp;glätten</translation>
    </message>
    <message>
        <source>Ma&amp;ximum of thick slices</source>
        <translation>Ma&amp;ximum dicker Schichten</translation>
    </message>
    <message>
        <source>Show the largest value across a thick slice instead of the mean</source>
        <translation>Den größten Wert in einer dicken Schicht statt des Mittelwerts zeigen</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>Schichtdi&amp;cke</translation>
    </message>
    <message>
        <source>Slices of %1 mm</source>
        <translation>Schichten von %1 mm</translation>
    </message>
    <message>
        <source>Thin slices</source>
        <translation>Dünne Schichten</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Ordner mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Scan öffnen</translation>
    </message>
    <message>
        <source>Scans (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)</source>
        <translation>Scans (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>The folder has several scans. Which one?</source>
        <translation>Der Ordner enthält mehrere Scans. Welchen öffnen?</translation>
    </message>
    <message numerus="yes">
        <source>%n more: see Scan on the page of Explore.</source>
        <translation>
            <numerusform>%n weiterer: siehe Scan auf der Seite von Erkunden.</numerusform>
            <numerusform>%n weitere: siehe Scan auf der Seite von Erkunden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, all %n slices, resampled to an even grid</source>
        <translation>
            <numerusform>, alle %n Schicht, auf ein gleichmäßiges Gitter umgerechnet</numerusform>
            <numerusform>, alle %n Schichten, auf ein gleichmäßiges Gitter umgerechnet</numerusform>
        </translation>
    </message>
    <message>
        <source>, slices %1 to %2 of %3</source>
        <translation>, Schichten %1 bis %2 von %3</translation>
    </message>
    <message>
        <source>The slices are not at even distances: at most %1 of %2 are. What shall be read?</source>
        <translation>Die Schichten haben keine gleichmäßigen Abstände: höchstens %1 von %2 haben sie. Was soll gelesen werden?</translation>
    </message>
    <message>
        <source>Read other slices...</source>
        <translation>Andere Schichten lesen ...</translation>
    </message>
    <message numerus="yes">
        <source>  %n phases</source>
        <translation>
            <numerusform>  %n Phase</numerusform>
            <numerusform>  %n Phasen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::SequenceList</name>
    <message>
        <source>%1: can be fitted to %2</source>
        <translation>%1: lässt sich an %2 anpassen</translation>
    </message>
    <message>
        <source>%1: shows the sample organ and plays</source>
        <translation>%1: zeigt das Beispielorgan und spielt ab</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionFiles</name>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Neue Sitzung</translation>
    </message>
    <message>
        <source>Start with an empty session</source>
        <translation>Mit einer leeren Sitzung beginnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Die Sitzung speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Die Sitzung in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>&amp;Recover unsaved work</source>
        <translation>Ungespeicherte Arbeit &amp;wiederherstellen</translation>
    </message>
    <message>
        <source>Open the copy that Viscera kept when it ended without saving</source>
        <translation>Die Kopie öffnen, die Viscera behielt, als es ohne Speichern endete</translation>
    </message>
    <message>
        <source>Viscera</source>
        <translation>Viscera</translation>
    </message>
    <message>
        <source>Untitled session</source>
        <translation>Unbenannte Sitzung</translation>
    </message>
    <message>
        <source>Session that names its organs&apos; files</source>
        <translation>Sitzung, die auf die Dateien ihrer Organe verweist</translation>
    </message>
    <message>
        <source>Session with all surfaces and the scan inside</source>
        <translation>Sitzung mit allen Oberflächen und dem Scan darin</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Save the session as</source>
        <translation>Sitzung speichern unter</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Als %1 gespeichert</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>Änderungen speichern?</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Änderungen von %1 speichern?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weiterer Eintrag.</numerusform>
            <numerusform>Und %n weitere Einträge.</numerusform>
        </translation>
    </message>
    <message>
        <source>Viscera ended without saving. It has kept a copy of the work of %1.</source>
        <translation>Viscera wurde beendet, ohne zu speichern. Es hat eine Kopie der Arbeit vom %1 behalten.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Choose the folder with the missing files</source>
        <translation>Ordner mit den fehlenden Dateien wählen</translation>
    </message>
    <message>
        <source>Save this session?</source>
        <translation>Diese Sitzung speichern?</translation>
    </message>
    <message>
        <source>If you discard them, the changes since the last saving are lost.</source>
        <translation>Verwerfen Sie sie, so gehen die Änderungen seit dem letzten Speichern verloren.</translation>
    </message>
    <message>
        <source>Fetch it from %1</source>
        <translation>Von %1 holen</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionView</name>
    <message>
        <source>Preparing the motion</source>
        <translation>Bewegung wird vorbereitet</translation>
    </message>
    <message>
        <source>it has other handles</source>
        <translation>sie hat andere Griffe</translation>
    </message>
    <message>
        <source>This version moves the organ differently from the one that saved the session: %1.</source>
        <translation>Diese Version bewegt das Organ anders als die, die die Sitzung gespeichert hat: %1.</translation>
    </message>
    <message>
        <source>handles differ by up to %1 mm</source>
        <translation>Griffe weichen um bis zu %1 mm ab</translation>
    </message>
</context>
<context>
    <name>viscera::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Lengths are in mm, volumes in ml, everywhere; numbers have the decimal mark of the language.</source>
        <translation>Längen sind überall in mm, Volumen in ml; Zahlen haben das Dezimalzeichen der Sprache.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>The next start uses the language.</source>
        <translation>Der nächste Start verwendet die Sprache.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Show the welcome</source>
        <translation>Begrüßung zeigen</translation>
    </message>
    <message>
        <source>Folders that dialogs begin in</source>
        <translation>Ordner, in denen Dialoge beginnen</translation>
    </message>
    <message>
        <source>Organs and sessions</source>
        <translation>Organe und Sitzungen</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Movies</source>
        <translation>Filme</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen ...</translation>
    </message>
</context>
<context>
    <name>viscera::app::ShortcutCard</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Links ziehen</translation>
    </message>
    <message>
        <source>Rotate, or move a handle</source>
        <translation>Drehen oder einen Griff bewegen</translation>
    </message>
    <message>
        <source>Middle, Shift+left drag</source>
        <translation>Mitte, Umschalt+links ziehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Rechts ziehen, Mausrad</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Select, or add a handle</source>
        <translation>Wählen oder einen Griff hinzufügen</translation>
    </message>
    <message>
        <source>Shift or Ctrl+click</source>
        <translation>Umschalt- oder Strg-Klick</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Zur Auswahl hinzufügen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel a drag, close a message</source>
        <translation>Ziehen abbrechen, eine Meldung schließen</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlicePanes</name>
    <message>
        <source>The scan cannot be warped: %1</source>
        <translation>Der Scan kann nicht verformt werden: %1</translation>
    </message>
    <message>
        <source>folded by the pose: estimated</source>
        <translation>von der Pose gefaltet: geschätzt</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlidePanel</name>
    <message>
        <source>Keep views as slides, then show them with F5 and Page Down. The session keeps them.</source>
        <translation>Behalten Sie Ansichten als Folien und zeigen Sie sie mit F5 und Bild ab. Die Sitzung bewahrt sie auf.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Slides</name>
    <message>
        <source>&amp;Keep this view as a slide</source>
        <translation>Diese Ansicht als Folie &amp;behalten</translation>
    </message>
    <message>
        <source>&amp;Remove the slide</source>
        <translation>Folie &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove the slide that was shown last</source>
        <translation>Die zuletzt gezeigte Folie entfernen</translation>
    </message>
    <message>
        <source>&amp;Next slide</source>
        <translation>&amp;Nächste Folie</translation>
    </message>
    <message>
        <source>&amp;Previous slide</source>
        <translation>&amp;Vorige Folie</translation>
    </message>
    <message>
        <source>Slide %1</source>
        <translation>Folie %1</translation>
    </message>
    <message>
        <source>Keep the present view with its cut, names and hidden organs, and the instant of a paused sequence</source>
        <translation>Die jetzige Ansicht mit Schnitt, Namen und ausgeblendeten Organen behalten, und den Zeitpunkt einer angehaltenen Sequenz</translation>
    </message>
    <message>
        <source>&amp;Back from the slides</source>
        <translation>&amp;Folien verlassen</translation>
    </message>
    <message>
        <source>Show, cut and name the organs as before the slides</source>
        <translation>Die Organe wie vor den Folien zeigen, schneiden und benennen</translation>
    </message>
</context>
<context>
    <name>viscera::app::StatusLine</name>
    <message>
        <source>Cancel this task</source>
        <translation>Diese Aufgabe abbrechen</translation>
    </message>
    <message>
        <source>No organ</source>
        <translation>Kein Organ</translation>
    </message>
    <message>
        <source>%1: open surface, no volume</source>
        <translation>%1: offene Oberfläche, kein Volumen</translation>
    </message>
    <message>
        <source>  locked</source>
        <translation>  gesperrt</translation>
    </message>
    <message>
        <source>no handles</source>
        <translation>keine Griffe</translation>
    </message>
    <message>
        <source>, binding...</source>
        <translation>, wird gebunden...</translation>
    </message>
    <message>
        <source>, binding cancelled</source>
        <translation>, Binden abgebrochen</translation>
    </message>
    <message>
        <source>, bound in %1 ms</source>
        <translation>, in %1 ms gebunden</translation>
    </message>
    <message>
        <source>%1, %2 of tissue folded by the pose</source>
        <translation>%1, %2 Gewebe von der Pose gefaltet</translation>
    </message>
    <message numerus="yes">
        <source>%n organs</source>
        <translation>
            <numerusform>%n Organ</numerusform>
            <numerusform>%n Organe</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 not bound</source>
        <translation>, %1 nicht gebunden</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainModel</name>
    <message>
        <source>Choose a motion, or drag a handle: strain is the change of the heart&apos;s wall.</source>
        <translation>Wählen Sie eine Bewegung oder ziehen Sie einen Griff: Verformung ist die Änderung der Herzwand.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainPanel</name>
    <message>
        <source>From the fullest phase</source>
        <translation>Ab der vollsten Phase</translation>
    </message>
    <message>
        <source>From phase %1</source>
        <translation>Ab Phase %1</translation>
    </message>
    <message>
        <source>Times to the peak differ by %1 ms along and %2 ms around</source>
        <translation>Die Zeiten bis zum Spitzenwert streuen um %1 ms längs und %2 ms rundum</translation>
    </message>
    <message>
        <source>The bull&apos;s eye shows the present pose against rest.</source>
        <translation>Das Bull’s Eye zeigt die jetzige Pose gegenüber der Ruhe.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressChart</name>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>The stress over one cycle of the sequence is drawn here as soon as it is computed.</source>
        <translation>Der Stress über einen Zyklus der Sequenz wird hier gezeichnet, sobald er berechnet ist.</translation>
    </message>
    <message>
        <source>chosen point</source>
        <translation>gewählter Punkt</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressExport</name>
    <message>
        <source>Export stress &amp;map...</source>
        <translation>Stress&amp;karte exportieren...</translation>
    </message>
    <message>
        <source>Write all quantities at all points inside the organ, for ParaView</source>
        <translation>Alle Größen an allen Punkten im Organ schreiben, für ParaView</translation>
    </message>
    <message>
        <source>Export stress map</source>
        <translation>Stresskarte exportieren</translation>
    </message>
    <message>
        <source>VTK solids (*.vtu)</source>
        <translation>VTK-Körper (*.vtu)</translation>
    </message>
    <message>
        <source>Export stress at the &amp;points...</source>
        <translation>Stress an den &amp;Punkten exportieren...</translation>
    </message>
    <message>
        <source>Write the values at the witness points as a table</source>
        <translation>Die Werte an den Messpunkten als Tabelle schreiben</translation>
    </message>
    <message>
        <source>Export stress at the points</source>
        <translation>Stress an den Punkten exportieren</translation>
    </message>
    <message>
        <source>Export &amp;histogram...</source>
        <translation>&amp;Histogramm exportieren...</translation>
    </message>
    <message>
        <source>Write the distribution of the shown quantity over the witness points</source>
        <translation>Die Verteilung der gezeigten Größe über die Messpunkte schreiben</translation>
    </message>
    <message>
        <source>Export histogram</source>
        <translation>Histogramm exportieren</translation>
    </message>
    <message>
        <source>Export &amp;curve over the sequence...</source>
        <translation>K&amp;urve über die Sequenz exportieren...</translation>
    </message>
    <message>
        <source>Write the rotational stress over one whole cycle of the sequence</source>
        <translation>Den Rotationsstress über einen ganzen Zyklus der Sequenz schreiben</translation>
    </message>
    <message>
        <source>Export curve</source>
        <translation>Kurve exportieren</translation>
    </message>
    <message>
        <source>the stress map</source>
        <translation>die Stresskarte</translation>
    </message>
    <message>
        <source>the stress</source>
        <translation>der Stress</translation>
    </message>
    <message>
        <source>the histogram</source>
        <translation>das Histogramm</translation>
    </message>
    <message>
        <source>the curve</source>
        <translation>die Kurve</translation>
    </message>
    <message>
        <source>Export pro&amp;bes...</source>
        <translation>&amp;Sonden exportieren...</translation>
    </message>
    <message>
        <source>Write place and values of the pinned probes as a table</source>
        <translation>Ort und Werte der angehefteten Sonden als Tabelle schreiben</translation>
    </message>
    <message>
        <source>Export probes</source>
        <translation>Sonden exportieren</translation>
    </message>
    <message>
        <source>Export prof&amp;iles...</source>
        <translation>Profi&amp;le exportieren...</translation>
    </message>
    <message>
        <source>Write the values along the lines between probes as a table</source>
        <translation>Die Werte entlang der Linien zwischen Sonden als Tabelle schreiben</translation>
    </message>
    <message>
        <source>Export profiles</source>
        <translation>Profile exportieren</translation>
    </message>
    <message>
        <source>the probes</source>
        <translation>die Sonden</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>die Profile</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressMode</name>
    <message>
        <source>How much the pose distorts the tissue (rotational stress): click the organ to read the values of a point; C cuts it open; the map follows while you drag a handle</source>
        <translation>Wie stark die Pose das Gewebe verzerrt (Rotationsstress): Ein Klick auf das Organ zeigt die Werte eines Punktes; C schneidet es auf; die Karte folgt, während Sie an einem Griff ziehen</translation>
    </message>
    <message>
        <source>&amp;Next map</source>
        <translation>&amp;Nächste Karte</translation>
    </message>
    <message>
        <source>The next stress map</source>
        <translation>Die nächste Stresskarte</translation>
    </message>
    <message>
        <source>&amp;Go to the maximum</source>
        <translation>&amp;Zum Maximum gehen</translation>
    </message>
    <message>
        <source>Show the values where the map is largest, and cut the organ open there</source>
        <translation>Die Werte zeigen, wo die Karte am größten ist, und das Organ dort aufschneiden</translation>
    </message>
    <message>
        <source>&amp;Maximum over the sequence</source>
        <translation>Ma&amp;ximum über die Sequenz</translation>
    </message>
    <message>
        <source>The most extreme value that each point reaches in one cycle of the sequence</source>
        <translation>Der extremste Wert, den jeder Punkt in einem Zyklus der Sequenz erreicht</translation>
    </message>
    <message>
        <source>Map on the organ&apos;s &amp;surface</source>
        <translation>Karte auf der &amp;Oberfläche des Organs</translation>
    </message>
    <message>
        <source>Draw the map on the organ&apos;s surface instead of the outer tetrahedra</source>
        <translation>Die Karte auf die Oberfläche des Organs statt auf die äußeren Tetraeder zeichnen</translation>
    </message>
    <message>
        <source>&amp;Keep the legend&apos;s range</source>
        <translation>&amp;Bereich der Legende halten</translation>
    </message>
    <message>
        <source>Keep the range of colours, so that poses can be compared</source>
        <translation>Den Farbbereich halten, damit Posen verglichen werden können</translation>
    </message>
    <message>
        <source>&amp;Cut open</source>
        <translation>&amp;Aufschneiden</translation>
    </message>
    <message>
        <source>Cut the organ open by a plane</source>
        <translation>Das Organ mit einer Ebene aufschneiden</translation>
    </message>
    <message>
        <source>&amp;Only beyond a limit</source>
        <translation>Nur &amp;jenseits einer Grenze</translation>
    </message>
    <message>
        <source>Show only tissue above or below a limit</source>
        <translation>Nur Gewebe über oder unter einer Grenze zeigen</translation>
    </message>
    <message>
        <source>&amp;Glyphs of the stretch</source>
        <translation>G&amp;lyphen der Streckung</translation>
    </message>
    <message>
        <source>No glyphs, ellipsoids or crosses</source>
        <translation>Keine Glyphen, Ellipsoide oder Kreuze</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Griffe</translation>
    </message>
    <message>
        <source>Show the handles, so that they can be dragged</source>
        <translation>Die Griffe zeigen, damit man sie ziehen kann</translation>
    </message>
    <message>
        <source>O&amp;ther organs</source>
        <translation>Andere O&amp;rgane</translation>
    </message>
    <message>
        <source>Show the other organs as well</source>
        <translation>Auch die anderen Organe zeigen</translation>
    </message>
    <message>
        <source>P&amp;in the probe</source>
        <translation>Sonde an&amp;heften</translation>
    </message>
    <message>
        <source>Keep the point that was clicked: its place and value follow the pose in the table</source>
        <translation>Den angeklickten Punkt festhalten: Ort und Wert folgen in der Tabelle der Pose</translation>
    </message>
    <message>
        <source>&amp;Logarithmic range</source>
        <translation>Logarith&amp;mischer Bereich</translation>
    </message>
    <message>
        <source>Same range in both &amp;views</source>
        <translation>Gleicher Bereich in beiden Ansi&amp;chten</translation>
    </message>
    <message>
        <source>Beside another view: one range of colours for both stress maps, so that they can be compared</source>
        <translation>Neben einer zweiten Ansicht: ein Farbbereich für beide Stresskarten, damit sie verglichen werden können</translation>
    </message>
    <message>
        <source>Go to the &amp;time of the maximum</source>
        <translation>Zum Zei&amp;tpunkt des Maximums gehen</translation>
    </message>
    <message>
        <source>Show the sequence at the instant at which the rotational stress is largest</source>
        <translation>Die Sequenz zu dem Zeitpunkt zeigen, an dem der Rotationsstress am größten ist</translation>
    </message>
    <message>
        <source>Use a logarithmic colour scale, which separates small values</source>
        <translation>Eine logarithmische Farbskala verwenden, die kleine Werte unterscheidbar macht</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressModel</name>
    <message>
        <source>This point is probe %1 already.</source>
        <translation>Dieser Punkt ist schon Sonde %1.</translation>
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
        <translation>TetGen, Oberfläche repariert</translation>
    </message>
    <message>
        <source>regular grid</source>
        <translation>regelmäßiges Gitter</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>What the colours mean (M: next map). Rotational stress is the largest angle by which a direction is turned when the tissue is stretched; it is not a pressure.</source>
        <translation>Was die Farben bedeuten (M: nächste Karte). Rotationsstress ist der größte Winkel, um den eine Richtung beim Strecken des Gewebes gedreht wird; er ist kein Druck.</translation>
    </message>
    <message>
        <source>Your pose</source>
        <translation>Ihre Pose</translation>
    </message>
    <message>
        <source>The map of your pose; handles can be dragged</source>
        <translation>Die Karte Ihrer Pose; Griffe können gezogen werden</translation>
    </message>
    <message>
        <source>The map of the sequence at the timeline&apos;s instant; Space plays</source>
        <translation>Die Karte der Sequenz zum Zeitpunkt der Zeitleiste; Leertaste spielt ab</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Smooth: through the tetrahedra</source>
        <translation>Glatt: durch die Tetraeder</translation>
    </message>
    <message>
        <source>Crinkle: whole tetrahedra</source>
        <translation>Zackig: ganze Tetraeder</translation>
    </message>
    <message>
        <source>Distance of the cut from the organ&apos;s middle; the arrow in the view moves it, the rim tilts it</source>
        <translation>Abstand des Schnitts von der Mitte des Organs; der Pfeil in der Ansicht bewegt ihn, der Rand kippt ihn</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Glyphs</source>
        <translation>Glyphen</translation>
    </message>
    <message>
        <source>No glyphs</source>
        <translation>Keine Glyphen</translation>
    </message>
    <message>
        <source>Ellipsoids of the stretch</source>
        <translation>Ellipsoide der Streckung</translation>
    </message>
    <message>
        <source>Crosses of the stretch</source>
        <translation>Kreuze der Streckung</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Cut away the right side</source>
        <translation>Rechte Seite wegschneiden</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Cut through the middle, across the line of sight</source>
        <translation>Schnitt durch die Mitte, quer zur Blickrichtung</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Number of witness points</source>
        <translation>Anzahl der Messpunkte</translation>
    </message>
    <message>
        <source>More points show finer detail and take longer; up to 20,000 the map follows a drag</source>
        <translation>Mehr Punkte zeigen feinere Einzelheiten und brauchen länger; bis 20000 folgt die Karte dem Ziehen</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Open an organ to see where it is distorted.</source>
        <translation>Öffnen Sie ein Organ, um zu sehen, wo es verzerrt ist.</translation>
    </message>
    <message>
        <source>Filling the organ with witness points...</source>
        <translation>Organ wird mit Messpunkten gefüllt...</translation>
    </message>
    <message>
        <source>Binding the witness points to the handles...</source>
        <translation>Messpunkte werden an die Griffe gebunden...</translation>
    </message>
    <message>
        <source>Cancelled. Press Try again to go on.</source>
        <translation>Abgebrochen. Weiter geht es mit Noch einmal.</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>Differenzen</translation>
    </message>
    <message numerus="yes">
        <source>%n points lie outside the handles&apos; hull and stay where they are.</source>
        <translation>
            <numerusform>%n Punkt liegt außerhalb der Hülle der Griffe und bleibt, wo er ist.</numerusform>
            <numerusform>%n Punkte liegen außerhalb der Hülle der Griffe und bleiben, wo sie sind.</numerusform>
        </translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sonden</translation>
    </message>
    <message>
        <source>Time of the maximum</source>
        <translation>Zeitpunkt des Maximums</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colours from the lowest value to the highest; maps of angles and maps of ratios each keep their own choice</source>
        <translation>Farben vom niedrigsten zum höchsten Wert; Karten von Winkeln und Karten von Verhältnissen behalten je eine eigene Auswahl</translation>
    </message>
    <message>
        <source>Witness points at which the tissue is turned inside out; in magenta, except on the map of folded tissue</source>
        <translation>Messpunkte, an denen das Gewebe umgestülpt ist; in Magenta, außer auf der Karte des gefalteten Gewebes</translation>
    </message>
    <message>
        <source>Cut and glyphs</source>
        <translation>Schnitt und Glyphen</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Above the limit</source>
        <translation>Über der Grenze</translation>
    </message>
    <message>
        <source>Below the limit</source>
        <translation>Unter der Grenze</translation>
    </message>
    <message>
        <source>Glyphs of the stretch at about 300 points: the shape that a small sphere of tissue takes</source>
        <translation>Glyphen der Streckung an etwa 300 Punkten: die Form, die eine kleine Kugel aus Gewebe annimmt</translation>
    </message>
    <message>
        <source>No handle is near %1: the nearest is %2 mm away. Place handles around it in Handles (2).</source>
        <translation>Kein Griff ist nahe bei „%1“: Der nächste ist %2 mm entfernt. Setzen Sie in „Griffe“ (2) Griffe darum herum.</translation>
    </message>
    <message>
        <source>Nothing is deformed: drag a handle, or play a sequence (Space).</source>
        <translation>Nichts ist verformt: Ziehen Sie an einem Griff, oder spielen Sie eine Sequenz ab (Leertaste).</translation>
    </message>
    <message>
        <source>Choose a material</source>
        <translation>Material wählen</translation>
    </message>
    <message>
        <source>Another material</source>
        <translation>Anderes Material</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>The tissue whose stiffness makes pascals of the deformation; it does not change the pose</source>
        <translation>Das Gewebe, dessen Steifigkeit aus der Verformung Pascal macht; die Pose ändert es nicht</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Pascals exist only of a stated material. Choose a material first.</source>
        <translation>Pascal gibt es nur für ein angegebenes Material. Wählen Sie zuerst ein Material.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus %1 kPa, doi:%2</source>
        <translation>Elastizitätsmodul %1 kPa, doi:%2</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemBox</name>
    <message>
        <source>Coordinate system that binds the organs to the handles</source>
        <translation>Koordinatensystem, das die Organe an die Griffe bindet</translation>
    </message>
    <message>
        <source>no cage</source>
        <translation>kein Käfig</translation>
    </message>
    <message>
        <source>Handles may stand anywhere around the organ</source>
        <translation>Griffe können überall um das Organ stehen</translation>
    </message>
    <message>
        <source>cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>Works with a closed surface over the handles: their convex hull, or a cage that was loaded</source>
        <translation>Arbeitet mit einer geschlossenen Oberfläche über den Griffen: ihrer konvexen Hülle oder einem geladenen Käfig</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positiv</translation>
    </message>
    <message>
        <source>interpolating</source>
        <translation>interpolierend</translation>
    </message>
    <message>
        <source>A point at a handle follows it exactly</source>
        <translation>Ein Punkt an einem Griff folgt ihm genau</translation>
    </message>
    <message>
        <source>exact gradient</source>
        <translation>exakter Gradient</translation>
    </message>
    <message>
        <source>Stress is computed without differences</source>
        <translation>Stress wird ohne Differenzen berechnet</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Some points inside the hull have no coordinates and do not move</source>
        <translation>Manche Punkte in der Hülle haben keine Koordinaten und bewegen sich nicht</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Neighbouring points may move very differently</source>
        <translation>Benachbarte Punkte können sich sehr verschieden bewegen</translation>
    </message>
    <message>
        <source>kinks</source>
        <translation>Knicke</translation>
    </message>
    <message>
        <source>The deformed organ may show creases</source>
        <translation>Das verformte Organ kann Kanten zeigen</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Handles act by their groups</source>
        <translation>Griffe wirken nach ihren Gruppen</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Fills the organ with tetrahedra first</source>
        <translation>Füllt das Organ zuerst mit Tetraedern</translation>
    </message>
    <message>
        <source>The value is set to %1 %2, but these handles allow at most %3, so %3 is used.</source>
        <translation>Der Wert ist auf %1 %2 gesetzt, aber diese Griffe erlauben höchstens %3; daher wird %3 verwendet.</translation>
    </message>
    <message>
        <source>These handles allow up to %1.</source>
        <translation>Diese Griffe erlauben bis zu %1.</translation>
    </message>
    <message>
        <source>No coordinate is negative: the organ follows the direction of every handle</source>
        <translation>Keine Koordinate ist negativ: Das Organ folgt der Richtung jedes Griffs</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemCombo</name>
    <message>
        <source>Recommended</source>
        <translation>Empfohlen</translation>
    </message>
    <message>
        <source>With a cage</source>
        <translation>Mit Käfig</translation>
    </message>
    <message>
        <source>With tetrahedra</source>
        <translation>Mit Tetraedern</translation>
    </message>
    <message>
        <source>Attempts of the thesis</source>
        <translation>Versuche der Dissertation</translation>
    </message>
</context>
<context>
    <name>viscera::app::TaskCard</name>
    <message>
        <source>Drag the bright dot: the organ follows.</source>
        <translation>Ziehen Sie den hellen Punkt: Das Organ folgt.</translation>
    </message>
    <message>
        <source>Done. Ctrl+Z takes it back. F1 opens the guide at what you are doing.</source>
        <translation>Geschafft. Strg+Z nimmt es zurück. F1 öffnet das Handbuch bei dem, was Sie tun.</translation>
    </message>
</context>
<context>
    <name>viscera::app::TimelineBar</name>
    <message>
        <source>To the start of the cycle (Home)</source>
        <translation>Zum Anfang des Zyklus (Pos1)</translation>
    </message>
    <message>
        <source>One frame back (,)</source>
        <translation>Ein Bild zurück (,)</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Abspielen oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>One frame forward (.)</source>
        <translation>Ein Bild vor (.)</translation>
    </message>
    <message>
        <source>Repeat the cycle (L)</source>
        <translation>Zyklus wiederholen (L)</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Repeat the cycle</source>
        <translation>Zyklus wiederholen</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Abspielen oder an&amp;halten</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Zum &amp;Anfang</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Ein Bild &amp;zurück</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Ein Bild &amp;vor</translation>
    </message>
    <message>
        <source>A fine step bac&amp;k</source>
        <translation>Kleiner Schritt zurüc&amp;k</translation>
    </message>
    <message>
        <source>Go back by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Beim Herzschlag um zehn Millisekunden zurück, bei anderen Sequenzen um ein Bild</translation>
    </message>
    <message>
        <source>A fine step for&amp;ward</source>
        <translation>Kleiner Schritt v&amp;or</translation>
    </message>
    <message>
        <source>Go forward by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Beim Herzschlag um zehn Millisekunden vor, bei anderen Sequenzen um ein Bild</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Slow motion: how fast time passes (S)</source>
        <translation>Zeitlupe: wie schnell die Zeit vergeht (S)</translation>
    </message>
    <message>
        <source>%1: %2 %3. The heart rate of the circulation sets it.</source>
        <translation>%1: %2 %3. Die Herzfrequenz des Kreislaufs gibt sie vor.</translation>
    </message>
    <message>
        <source>%1: %2 to %3 %4</source>
        <translation>%1: %2 bis %3 %4</translation>
    </message>
    <message>
        <source>No motion yet: choose a sequence in Play (5)</source>
        <translation>Noch keine Bewegung: Wählen Sie eine Sequenz in Abspielen (5)</translation>
    </message>
    <message>
        <source>%1 s into the cycle</source>
        <translation>%1 s im Zyklus</translation>
    </message>
    <message>
        <source>The images of the cine study: there is no motion yet</source>
        <translation>Die Bilder der Cine-Studie: noch gibt es keine Bewegung</translation>
    </message>
    <message>
        <source>The phases of the scan: there is no motion yet</source>
        <translation>Die Phasen des Scans: es gibt noch keine Bewegung</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
</context>
<context>
    <name>viscera::app::TourCard</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Tour beenden</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>viscera::app::Value</name>
    <message>
        <source>No password was given.</source>
        <translation>Kein Passwort wurde eingegeben.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ViewActions</name>
    <message>
        <source>Save s&amp;creenshot</source>
        <translation>Bildschirm&amp;foto speichern</translation>
    </message>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Ein Bild der 3D-Ansicht speichern</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Fokus</translation>
    </message>
    <message>
        <source>Bring the selected organ, or all, into the picture</source>
        <translation>Das gewählte Organ oder alle ins Bild holen</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Show &amp;handles in every mode</source>
        <translation>&amp;Griffe in jedem Modus zeigen</translation>
    </message>
    <message>
        <source>&amp;Ghost of the rest shape</source>
        <translation>Schatten&amp;bild der Ruheform</translation>
    </message>
    <message>
        <source>Cut &amp;open</source>
        <translation>A&amp;ufschneiden</translation>
    </message>
    <message>
        <source>Cut all organs open by a plane; their cavities are hollow then</source>
        <translation>Alle Organe mit einer Ebene aufschneiden; ihre Hohlräume sind dann hohl</translation>
    </message>
    <message>
        <source>Orientation &amp;cube</source>
        <translation>Orientierungs&amp;würfel</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>Sha&amp;de in folds</source>
        <translation>Falten sch&amp;attieren</translation>
    </message>
    <message>
        <source>Darken the folds of organs and soften the light; takes time on a computer without a graphics processor</source>
        <translation>Falten der Organe abdunkeln und das Licht weicher machen; braucht ohne Grafikprozessor Zeit</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Bild als %1 gespeichert</translation>
    </message>
    <message>
        <source>%1 is hidden behind %2.</source>
        <translation>%1 ist hinter %2 verborgen.</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Nur dieses zeigen</translation>
    </message>
    <message>
        <source>&amp;Edges of triangles</source>
        <translation>&amp;Kanten der Dreiecke</translation>
    </message>
    <message>
        <source>Draw the triangles of organs as lines</source>
        <translation>Die Dreiecke der Organe als Linien zeichnen</translation>
    </message>
    <message>
        <source>&amp;Flat triangles</source>
        <translation>&amp;Flache Dreiecke</translation>
    </message>
    <message>
        <source>Give each triangle of an organ one shade, in place of a smooth surface</source>
        <translation>Jedes Dreieck eines Organs in einem einheitlichen Ton zeigen, statt einer glatten Oberfläche</translation>
    </message>
    <message>
        <source>Co&amp;nduction system</source>
        <translation>Er&amp;regungsleitungssystem</translation>
    </message>
    <message>
        <source>In the sample heart: sinus node, atrioventricular node, bundles and branches, lit where the excitation of the beat is; names of parts name them</source>
        <translation>Im Beispielherzen: Sinusknoten, Atrioventrikularknoten, Bündel und Schenkel, hell, wo die Erregung des Schlags ist; Namen der Teile benennen sie</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeBox</name>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Target volume</source>
        <translation>Zielvolumen</translation>
    </message>
    <message>
        <source>Give the organ this volume with the smallest motion of the compensating handles, or of all free ones</source>
        <translation>Dem Organ dieses Volumen mit der kleinsten Bewegung der ausgleichenden oder aller freien Griffe geben</translation>
    </message>
    <message>
        <source>%1 now has the target volume; its lock keeps this volume from now on.</source>
        <translation>%1 hat jetzt das Zielvolumen; die Sperre hält von nun an dieses Volumen.</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeMonitor</name>
    <message>
        <source>Volumes over the cycle</source>
        <translation>Volumina über den Zyklus</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumePanel</name>
    <message>
        <source>normal at the end of diastole</source>
        <translation>normal am Ende der Diastole</translation>
    </message>
    <message>
        <source>normal at the end of systole</source>
        <translation>normal am Ende der Systole</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normal: %1</translation>
    </message>
    <message>
        <source>Volumes over time are drawn here while a sequence plays (Space) or handles are dragged (3).</source>
        <translation>Volumina im Zeitverlauf werden hier gezeichnet, während eine Sequenz läuft (Leertaste) oder Griffe gezogen werden (3).</translation>
    </message>
    <message>
        <source>%1 (right axis)</source>
        <translation>%1 (rechte Achse)</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 gemessen</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 vorher</translation>
    </message>
    <message>
        <source>%1 prescribed</source>
        <translation>%1 vorgegeben</translation>
    </message>
    <message>
        <source>Closed organs show their volume here.</source>
        <translation>Geschlossene Organe zeigen hier ihr Volumen.</translation>
    </message>
    <message>
        <source>%1: show its normal range in the chart</source>
        <translation>%1: Normbereich im Diagramm zeigen</translation>
    </message>
    <message>
        <source>Shaded: normal for %1, %2. %3</source>
        <translation>Schattiert: normal für %1, %2. %3</translation>
    </message>
    <message>
        <source>EF %1 %  SV %2 ml</source>
        <translation>EF %1 %  SV %2 ml</translation>
    </message>
    <message>
        <source>%1 % of rest</source>
        <translation>%1 % der Ruheform</translation>
    </message>
    <message>
        <source>Part of the cycle</source>
        <translation>Anteil des Zyklus</translation>
    </message>
    <message>
        <source>Time while dragging</source>
        <translation>Zeit beim Ziehen</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message numerus="yes">
        <source>%n more organs are not drawn: choose one to see its volume.</source>
        <translation>
            <numerusform>%n weiteres Organ ist nicht gezeichnet: Wählen Sie es aus, um sein Volumen zu sehen.</numerusform>
            <numerusform>%n weitere Organe sind nicht gezeichnet: Wählen Sie eines aus, um sein Volumen zu sehen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit of the motion</source>
        <translation>Güte der Bewegung</translation>
    </message>
    <message>
        <source>EF about %1 %  SV about %2 ml (estimate)</source>
        <translation>EF etwa %1 %  SV etwa %2 ml (Schätzung)</translation>
    </message>
</context>
<context>
    <name>viscera::app::WarpExport</name>
    <message>
        <source>Export the &amp;warped scan...</source>
        <translation>Verformten S&amp;can exportieren...</translation>
    </message>
    <message>
        <source>Write the scan as the pose warps it, with a label map of the posed organs</source>
        <translation>Den Scan so schreiben, wie die Pose ihn verformt, mit einer Labelmap der Organe in dieser Pose</translation>
    </message>
    <message>
        <source>Export the warped scan</source>
        <translation>Verformten Scan exportieren</translation>
    </message>
    <message>
        <source>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</source>
        <translation>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</translation>
    </message>
    <message>
        <source>Exporting the warped scan</source>
        <translation>Verformter Scan wird exportiert</translation>
    </message>
    <message>
        <source>The warped scan was written to %1.</source>
        <translation>Der verformte Scan wurde in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Its labels are beside it: %1.</source>
        <translation>Seine Labels liegen daneben: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The pose folds the tissue at %n voxels: their values are estimates.</source>
        <translation>
            <numerusform>Die Pose faltet das Gewebe an %n Voxel: Sein Wert ist geschätzt.</numerusform>
            <numerusform>Die Pose faltet das Gewebe an %n Voxeln: Ihre Werte sind geschätzt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::WelcomeCard</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Open a patient...</source>
        <translation>Patient öffnen...</translation>
    </message>
    <message>
        <source>Choose organ surfaces of a patient (Ctrl+O)</source>
        <translation>Organoberflächen eines Patienten wählen (Strg+O)</translation>
    </message>
    <message>
        <source>Sample organs</source>
        <translation>Beispielorgane</translation>
    </message>
    <message>
        <source>Organs that come with the program</source>
        <translation>Organe, die das Programm mitbringt</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Tour in zwei Minuten</translation>
    </message>
    <message>
        <source>The parts of the window, step by step</source>
        <translation>Die Teile des Fensters, Schritt für Schritt</translation>
    </message>
    <message>
        <source>Close this card (Help &gt; Welcome shows it again)</source>
        <translation>Diese Karte schließen (Hilfe &gt; Willkommen zeigt sie wieder)</translation>
    </message>
    <message>
        <source>Close this card</source>
        <translation>Diese Karte schließen</translation>
    </message>
    <message>
        <source>First task</source>
        <translation>Erste Aufgabe</translation>
    </message>
    <message>
        <source>Drag a dot, and see the organ follow</source>
        <translation>Einen Punkt ziehen und sehen, wie das Organ folgt</translation>
    </message>
</context>
<context>
    <name>viscera::app::WindowLayout</name>
    <message>
        <source>&amp;Standard layout</source>
        <translation>&amp;Standardanordnung</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>The window takes the whole screen</source>
        <translation>Das Fenster nimmt den ganzen Bildschirm ein</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Modi</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Folien</translation>
    </message>
    <message>
        <source>Move all panels to their default places</source>
        <translation>Alle Bedienfelder an ihren Standardplatz bewegen</translation>
    </message>
</context>
<context>
    <name>viscera::app::Workspace</name>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
</context>
</TS>
