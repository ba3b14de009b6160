<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Lesson</name>
    <message>
        <source>The organs in three dimensions</source>
        <translation>Les organes en trois dimensions</translation>
    </message>
    <message>
        <source>%1. Drag or use the arrow keys to turn, two fingers, the wheel or plus and minus to come nearer.</source>
        <translation>%1. Faites glisser ou utilisez les flèches pour tourner ; deux doigts, la molette ou plus et moins pour approcher.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Diapositives</translation>
    </message>
    <message>
        <source>Quiz</source>
        <translation>Quiz</translation>
    </message>
    <message>
        <source>Light or dark (T)</source>
        <translation>Clair ou sombre (T)</translation>
    </message>
    <message>
        <source>Seen from (1, 3, 7)</source>
        <translation>Vu de (1, 3, 7)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Devant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Derrière</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms</translation>
    </message>
    <message>
        <source>Names of the parts (N)</source>
        <translation>Noms des parties (N)</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Poignées</translation>
    </message>
    <message>
        <source>Handles to drag (H)</source>
        <translation>Poignées à faire glisser (H)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Back to the shape as sent (R)</source>
        <translation>Revenir à la forme d’origine (R)</translation>
    </message>
    <message>
        <source>Drag a handle.</source>
        <translation>Faites glisser une poignée.</translation>
    </message>
    <message>
        <source>Handle %1: arrow keys, plus and minus move it.</source>
        <translation>Poignée %1 : les flèches, plus et moins la déplacent.</translation>
    </message>
    <message>
        <source>Previous slide (Page Up)</source>
        <translation>Diapositive précédente (Page préc.)</translation>
    </message>
    <message>
        <source>Next slide (Page Down)</source>
        <translation>Diapositive suivante (Page suiv.)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 sur %2 : %3</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Afficher %1</translation>
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
        <translation>%1 % du repos</translation>
    </message>
    <message>
        <source>%1 % by the handles</source>
        <translation>%1 % par les poignées</translation>
    </message>
    <message>
        <source>%1: ejection fraction</source>
        <translation>%1 : fraction d’éjection</translation>
    </message>
    <message>
        <source>Stroke volume</source>
        <translation>Volume d’éjection systolique</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Débit cardiaque</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normale %1</translation>
    </message>
    <message>
        <source>%1 of healthy people</source>
        <translation>%1 de personnes saines</translation>
    </message>
    <message>
        <source>without handles %1</source>
        <translation>sans poignées %1</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Moment of the cycle</source>
        <translation>Instant du cycle</translation>
    </message>
    <message>
        <source>%1 s, %2</source>
        <translation>%1 s, %2</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 par minute</translation>
    </message>
    <message>
        <source>Volumes over one cycle: %1</source>
        <translation>Volumes sur un cycle : %1</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Space: play or stop
Arrow keys: turn the picture when it has the focus, else go through the cycle
Plus, minus: nearer, farther
Page Down, Page Up: next and previous slide; B: dark screen
J, K: choose a handle; arrow keys, plus and minus move it; Escape lets it go
1, 3, 7: front, left, above
N: names, H: handles, X: wall, R: reset, T: light or dark, Home: beginning</source>
        <translation>Espace : lire ou arrêter
Flèches : tourner l’image quand elle a le focus, sinon parcourir le cycle
Plus, moins : approcher, éloigner
Page suiv., Page préc. : diapositive suivante et précédente ; B : écran noir
J, K : choisir une poignée ; les flèches, plus et moins la déplacent ; Échap la lâche
1, 3, 7 : devant, gauche, dessus
N : noms, H : poignées, X : paroi, R : rétablir, T : clair ou sombre, Origine : début</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Leave the quiz</source>
        <translation>Quitter le quiz</translation>
    </message>
    <message>
        <source>What is marked?</source>
        <translation>Qu’est-ce qui est marqué ?</translation>
    </message>
    <message>
        <source>Which phase is this?</source>
        <translation>Quelle est cette phase ?</translation>
    </message>
    <message>
        <source>Which chamber shrinks now?</source>
        <translation>Quelle cavité rétrécit maintenant ?</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Exact.</translation>
    </message>
    <message>
        <source>No. The answer is: %1.</source>
        <translation>Non. La réponse est : %1.</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%1 sur %2 exactes</translation>
    </message>
    <message>
        <source>%1 of %2 right.</source>
        <translation>%1 sur %2 exactes.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later.</source>
        <translation>Cette leçon demande un navigateur de 2023 ou plus récent.</translation>
    </message>
    <message>
        <source>This lesson needs WebGL 2. It may be switched off in this browser.</source>
        <translation>Cette leçon demande WebGL 2. Il est peut-être désactivé dans ce navigateur.</translation>
    </message>
    <message>
        <source>The graphics were lost. Load the page again.</source>
        <translation>L’affichage graphique a été perdu. Rechargez la page.</translation>
    </message>
    <message>
        <source>This lesson needs a browser of 2023 or later, with JavaScript and WebGL 2.</source>
        <translation>Cette leçon demande un navigateur de 2023 ou plus récent, avec JavaScript et WebGL 2.</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Ventricule gauche</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Ventricule droit</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Name on it</source>
        <translation>Nom dessus</translation>
    </message>
    <message>
        <source>Normal range</source>
        <translation>Intervalle normal</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Diapositive</translation>
    </message>
    <message>
        <source>Text of the slide</source>
        <translation>Texte de la diapositive</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Poignée</translation>
    </message>
    <message>
        <source>end-diastolic volume</source>
        <translation>volume télédiastolique</translation>
    </message>
    <message>
        <source>end-systolic volume</source>
        <translation>volume télésystolique</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>fraction d’éjection</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volume après un repas</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of your language (BCP 47): numbers are written as it does.</extracomment>
        <translation>fr</translation>
    </message>
    <message>
        <source>For teaching. It is not a medical device.</source>
        <translation>Pour l’enseignement. Ce n’est pas un dispositif médical.</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estomac</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Rein</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Rein gauche</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Rein droit</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vésicule biliaire</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pancréas</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Battement du cœur</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Péristaltisme gastrique</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Respiration</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Atrial systole</source>
        <translation>Systole auriculaire</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Contraction isovolumique</translation>
    </message>
    <message>
        <source>Ejection</source>
        <translation>Éjection</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Relaxation isovolumique</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Onde dans le corps</translation>
    </message>
    <message>
        <source>Wave in the antrum</source>
        <translation>Onde dans l’antre</translation>
    </message>
    <message>
        <source>Terminal antral contraction</source>
        <translation>Contraction antrale terminale</translation>
    </message>
    <message>
        <source>Wave fades at the pylorus</source>
        <translation>L’onde s’éteint au pylore</translation>
    </message>
    <message>
        <source>Inspiration</source>
        <translation>Inspiration</translation>
    </message>
    <message>
        <source>Expiration</source>
        <translation>Expiration</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
</TS>
