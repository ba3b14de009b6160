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
        <source>Measurements</source>
        <translation>Messungen</translation>
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
        <source>Left</source>
        <translation>Links</translation>
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
        <source>Handles</source>
        <translation>Griffe</translation>
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
        <source>Back to the shape as sent (R)</source>
        <translation>Zurück zur ursprünglichen Form (R)</translation>
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
        <source>%1 % by the handles</source>
        <translation>%1 % durch die Griffe</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1: Ejektions­fraktion</translation>
    </message>
    <message>
        <source>Stroke volume</source>
        <translation>Schlagvolumen</translation>
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
        <source>Rate</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 pro Minute</translation>
    </message>
    <message>
        <source>Volumes over one cycle: %1</source>
        <translation>Volumen über einen Zyklus: %1</translation>
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
        <translation>Welche Kammer wird jetzt kleiner?</translation>
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
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Linker Ventrikel</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Rechter Ventrikel</translation>
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
        <source>Name on it</source>
        <translation>Name darauf</translation>
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
        <source>end-diastolic volume</source>
        <translation>enddiastolisches Volumen</translation>
    </message>
    <message>
        <source>end-systolic volume</source>
        <translation>endsystolisches Volumen</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>Ejektionsfraktion</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>Volumen nach einer Mahlzeit</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
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
        <source>Heart</source>
        <translation>Herz</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Magen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Milz</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Linke Niere</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Rechte Niere</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Bauchspeicheldrüse</translation>
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
        <source>Breathing</source>
        <translation>Atmung</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Atrial systole</source>
        <translation>Vorhofsystole</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Isovolumetrische Kontraktion</translation>
    </message>
    <message>
        <source>Ejection</source>
        <translation>Austreibung</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Isovolumetrische Relaxation</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Welle im Magenkörper</translation>
    </message>
    <message>
        <source>Wave in the antrum</source>
        <translation>Welle im Antrum</translation>
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
        <source>Inspiration</source>
        <translation>Einatmung</translation>
    </message>
    <message>
        <source>Expiration</source>
        <translation>Ausatmung</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
</TS>
