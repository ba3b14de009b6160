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
        <translation>%1. Faites glisser ou utilisez les flèches pour tourner&#x202f;; deux doigts, la molette ou plus et moins pour approcher.</translation>
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
        <source>Handles to drag (H)</source>
        <translation>Poignées à faire glisser (H)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Drag a handle.</source>
        <translation>Faites glisser une poignée.</translation>
    </message>
    <message>
        <source>Handle %1: arrow keys, plus and minus move it.</source>
        <translation>Poignée %1&#xa0;: les flèches, plus et moins la déplacent.</translation>
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
        <translation>%1 sur %2&#xa0;: %3</translation>
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
        <source>%1: ejection fraction</source>
        <translation>%1&#xa0;: fraction d’éjection</translation>
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
        <translation>Lecture</translation>
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
        <source>%1 a minute</source>
        <translation>%1 par minute</translation>
    </message>
    <message>
        <source>Volumes over one cycle: %1</source>
        <translation>Volumes sur un cycle&#xa0;: %1</translation>
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
        <translation>Espace&#xa0;: lire ou arrêter
Flèches&#xa0;: tourner l’image quand elle a le focus, sinon parcourir le cycle
Plus, moins&#xa0;: approcher, éloigner
Page suiv., Page préc.&#xa0;: diapositive suivante et précédente&#x202f;; B&#xa0;: écran noir
J, K&#xa0;: choisir une poignée&#x202f;; les flèches, plus et moins la déplacent&#x202f;; Échap la lâche
1, 3, 7&#xa0;: devant, gauche, dessus
N&#xa0;: noms, H&#xa0;: poignées, X&#xa0;: paroi, R&#xa0;: rétablir, T&#xa0;: clair ou sombre, Origine&#xa0;: début</translation>
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
        <translation>Qu’est-ce qui est marqué&#x202f;?</translation>
    </message>
    <message>
        <source>Which phase is this?</source>
        <translation>Quelle est cette phase&#x202f;?</translation>
    </message>
    <message>
        <source>Which chamber shrinks now?</source>
        <translation>Quelle cavité rétrécit maintenant&#x202f;?</translation>
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
        <translation>Non. La réponse est&#xa0;: %1.</translation>
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
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
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
        <source>volume after a meal</source>
        <translation>volume après un repas</translation>
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
        <source>Heartbeat</source>
        <translation>Battement du cœur</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Péristaltisme gastrique</translation>
    </message>
    <message>
        <source>Wave in the body</source>
        <translation>Onde dans le corps gastrique</translation>
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
        <source>Back to the original shape (R)</source>
        <translation>Revenir à la forme d’origine (R)</translation>
    </message>
    <message>
        <source>%1 % from moved handles</source>
        <translation>%1 % par poignées déplacées</translation>
    </message>
    <message>
        <source>Label in the view</source>
        <translation>Étiquette dans la vue</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the heart and look into it (C)</source>
        <translation>Ouvrir le cœur et regarder dedans (C)</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Sang</translation>
    </message>
    <message>
        <source>Blood in the opened chambers (F)</source>
        <translation>Du sang dans les cavités ouvertes (F)</translation>
    </message>
    <message>
        <source>Conduction</source>
        <translation>Conduction</translation>
    </message>
    <message>
        <source>Conduction system, lit with the electrocardiogram (E)</source>
        <translation>Système de conduction, s’allume avec l’électrocardiogramme (E)</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>ECG</translation>
    </message>
    <message>
        <source>C: cut open, F: blood, E: conduction system</source>
        <translation>C&#xa0;: ouvrir, F&#xa0;: sang, E&#xa0;: système de conduction</translation>
    </message>
</context>
<context>
    <name>NewFile</name>
    <message>
        <source>Replace the file?</source>
        <translation>Remplacer le fichier&#x202f;?</translation>
    </message>
    <message>
        <source>%1 already exists. Do you want to replace it?</source>
        <translation>%1 existe déjà. Voulez-vous le remplacer&#x202f;?</translation>
    </message>
</context>
<context>
    <name>OrganLooks</name>
    <message>
        <source>Show only this</source>
        <translation>Afficher seulement ceci</translation>
    </message>
</context>
<context>
    <name>Tissue</name>
    <message>
        <source>Muscle</source>
        <translation>Muscle</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Rein</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estomac</translation>
    </message>
    <message>
        <source>Bowel</source>
        <translation>Intestin</translation>
    </message>
    <message>
        <source>Arterial blood</source>
        <translation>Sang artériel</translation>
    </message>
    <message>
        <source>Venous blood</source>
        <translation>Sang veineux</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Poumon</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Graisse</translation>
    </message>
    <message>
        <source>Another colour...</source>
        <translation>Autre couleur...</translation>
    </message>
    <message>
        <source>Bile</source>
        <translation>Bile</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveActions</name>
    <message>
        <source>From the &amp;archive...</source>
        <translation>Depuis l&apos;&amp;archive...</translation>
    </message>
    <message>
        <source>Search a hospital&apos;s archive (PACS) for a patient and open a series</source>
        <translation>Chercher un patient dans l&apos;archive d&apos;un hôpital (PACS) et ouvrir une série</translation>
    </message>
    <message>
        <source>No archive is called %1 here. Add it, then open the session again.</source>
        <translation>Aucune archive ne s&apos;appelle %1 ici. Ajoutez-la, puis rouvrez la session.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveClient</name>
    <message>
        <source>Forgetting the password</source>
        <translation>Oubli du mot de passe</translation>
    </message>
    <message>
        <source>Testing %1</source>
        <translation>Test de %1</translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation>Recherche dans %1</translation>
    </message>
    <message>
        <source>Sending to %1</source>
        <translation>Envoi à %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::ArchiveDialog</name>
    <message>
        <source>The beginning of the name; * stands for any letters</source>
        <translation>Le début du nom ; * remplace des lettres quelconques</translation>
    </message>
    <message>
        <source>The beginning of the number of the patient</source>
        <translation>Le début du numéro du patient</translation>
    </message>
    <message>
        <source>The first day of the study, as 2024-03-01</source>
        <translation>Le premier jour de l&apos;étude, comme 2024-03-01</translation>
    </message>
    <message>
        <source>The last day of the study, as 2024-03-31</source>
        <translation>Le dernier jour de l&apos;étude, comme 2024-03-31</translation>
    </message>
    <message>
        <source>From the archive</source>
        <translation>Depuis l&apos;archive</translation>
    </message>
    <message>
        <source>Fetch what is chosen and open it</source>
        <translation>Récupérer ce qui est choisi et l&apos;ouvrir</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>The archive to search</source>
        <translation>L&apos;archive où chercher</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Ajouter...</translation>
    </message>
    <message>
        <source>Name another archive</source>
        <translation>Nommer une autre archive</translation>
    </message>
    <message>
        <source>Edit...</source>
        <translation>Modifier...</translation>
    </message>
    <message>
        <source>Change the address and the titles of this archive</source>
        <translation>Modifier l&apos;adresse et les titres de cette archive</translation>
    </message>
    <message>
        <source>Forget this archive and its password</source>
        <translation>Oublier cette archive et son mot de passe</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Tester</translation>
    </message>
    <message>
        <source>Ask whether the archive answers</source>
        <translation>Demander si l&apos;archive répond</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Only studies with images of this kind</source>
        <translation>Seulement les études avec des images de ce type</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>List the studies that match (Return)</source>
        <translation>Lister les études qui correspondent (Entrée)</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>Nom du patient</translation>
    </message>
    <message>
        <source>Patient&apos;s number</source>
        <translation>Numéro du patient</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Du</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Au</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalité</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>AAAA-MM-JJ</translation>
    </message>
    <message>
        <source>Studies and series</source>
        <translation>Études et séries</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Description</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Stop; nothing incomplete is kept</source>
        <translation>Arrêter ; rien d&apos;incomplet n&apos;est conservé</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was kept.</source>
        <translation>Annulé. Rien n&apos;a été conservé.</translation>
    </message>
    <message>
        <source>No archive is named yet. Add one: its address, and for the classic services its title.</source>
        <translation>Aucune archive n&apos;est encore nommée. Ajoutez-en une : son adresse, et son titre pour les services classiques.</translation>
    </message>
    <message>
        <source>Remove the archive?</source>
        <translation>Retirer l&apos;archive ?</translation>
    </message>
    <message>
        <source>Forget %1 and its password?</source>
        <translation>Oublier %1 et son mot de passe ?</translation>
    </message>
    <message>
        <source>%1 answers.</source>
        <translation>%1 répond.</translation>
    </message>
    <message>
        <source>%1 is no day. Write it as 2024-03-01.</source>
        <translation>%1 n&apos;est pas un jour. Écrivez-le sous la forme 2024-03-01.</translation>
    </message>
    <message>
        <source>No study matches.</source>
        <translation>Aucune étude ne correspond.</translation>
    </message>
    <message numerus="yes">
        <source>%n studies. Open one to see its series.</source>
        <translation>
            <numerusform>%n étude. Dépliez-la pour voir ses séries.</numerusform>
            <numerusform>%n études. Dépliez-en une pour voir ses séries.</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Série %1</translation>
    </message>
    <message>
        <source>This study has no series.</source>
        <translation>Cette étude n&apos;a pas de série.</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Ouvrir l&apos;étude</translation>
    </message>
</context>
<context>
    <name>viscera::app::AxisPicker</name>
    <message>
        <source>Axes of the heart, from which segments count: set by clicks</source>
        <translation>Axes du cœur, à partir desquels comptent les segments : à définir par des clics</translation>
    </message>
    <message>
        <source>Anterior insertion of the right ventricle</source>
        <translation>Insertion antérieure du ventricule droit</translation>
    </message>
</context>
<context>
    <name>viscera::app::BeatStrip</name>
    <message>
        <source>Electrocardiogram, heart sounds and valves</source>
        <translation>Électrocardiogramme, bruits du cœur et valves</translation>
    </message>
    <message>
        <source>Schematic electrocardiogram, heart sounds S1 and S2 when the valves close, and a bar for each valve while it is open. The lamp is lit while the valve is open.</source>
        <translation>Électrocardiogramme schématique, bruits du cœur B1 et B2 à la fermeture des valves, et une barre pour chaque valve tant qu’elle est ouverte. Le voyant est allumé tant que la valve est ouverte.</translation>
    </message>
    <message>
        <source>S1</source>
        <translation>B1</translation>
    </message>
    <message>
        <source>S2</source>
        <translation>B2</translation>
    </message>
</context>
<context>
    <name>viscera::app::BindingMessages</name>
    <message>
        <source>%1 is not bound to these handles: binding was cancelled.</source>
        <translation>%1 n’est pas lié à ces poignées&#xa0;: la liaison a été annulée.</translation>
    </message>
    <message>
        <source>Bind now</source>
        <translation>Lier maintenant</translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 have no coordinates in the cage.</source>
        <translation>
            <numerusform>%n sommet de %1 n’a pas de coordonnées dans la cage.</numerusform>
            <numerusform>%n sommets de %1 n’ont pas de coordonnées dans la cage.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie in no group&apos;s region.</source>
        <translation>
            <numerusform>%n sommet de %1 n’est dans la région d’aucun groupe.</numerusform>
            <numerusform>%n sommets de %1 ne sont dans la région d’aucun groupe.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles&apos; hull.</source>
        <translation>
            <numerusform>%n sommet de %1 est hors de l’enveloppe des poignées.</numerusform>
            <numerusform>%n sommets de %1 sont hors de l’enveloppe des poignées.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices of %1 lie outside the handles of the motion, so %1 stays at rest.</source>
        <translation>
            <numerusform>%n sommet de %1 est hors des poignées du mouvement ; %1 reste au repos.</numerusform>
            <numerusform>%n sommets de %1 sont hors des poignées du mouvement ; %1 reste au repos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CinePage</name>
    <message>
        <source>Open study</source>
        <translation>Étude ouverte</translation>
    </message>
    <message>
        <source>Take the images that are open in the window</source>
        <translation>Prendre les images ouvertes dans la fenêtre</translation>
    </message>
    <message>
        <source>Images...</source>
        <translation>Images...</translation>
    </message>
    <message>
        <source>A folder with the DICOM files of a cine study</source>
        <translation>Un dossier avec les fichiers DICOM d&apos;une étude ciné</translation>
    </message>
    <message>
        <source>Image file...</source>
        <translation>Fichier d&apos;images...</translation>
    </message>
    <message>
        <source>One file of images over time: 4D NIfTI or .seq.nrrd</source>
        <translation>Un fichier d&apos;images dans le temps : NIfTI 4D ou .seq.nrrd</translation>
    </message>
    <message>
        <source>Labels...</source>
        <translation>Étiquettes...</translation>
    </message>
    <message>
        <source>Label maps or surfaces of single phases: the ends of diastole and systole at least</source>
        <translation>Cartes d&apos;étiquettes ou surfaces de phases isolées : au moins les fins de diastole et de systole</translation>
    </message>
    <message>
        <source>Folder of one phase...</source>
        <translation>Dossier d&apos;une phase...</translation>
    </message>
    <message>
        <source>A folder with all surfaces of one phase</source>
        <translation>Un dossier avec toutes les surfaces d&apos;une phase</translation>
    </message>
    <message>
        <source>Labels and their phases</source>
        <translation>Étiquettes et leurs phases</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Looking through the images</source>
        <translation>Examen des images</translation>
    </message>
    <message>
        <source>Folder with a cine study</source>
        <translation>Dossier avec une étude ciné</translation>
    </message>
    <message>
        <source>Images over time</source>
        <translation>Images dans le temps</translation>
    </message>
    <message>
        <source>Labels of single phases</source>
        <translation>Étiquettes de phases isolées</translation>
    </message>
    <message>
        <source>Surfaces of one phase</source>
        <translation>Surfaces d&apos;une phase</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>non indiquée</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> sur %1</translation>
    </message>
    <message>
        <source>Phase of %1</source>
        <translation>Phase de %1</translation>
    </message>
    <message>
        <source>Guessed from the name and the images: check it</source>
        <translation>Deviné d&apos;après le nom et les images : à vérifier</translation>
    </message>
    <message>
        <source>The phase that these labels belong to</source>
        <translation>La phase à laquelle ces étiquettes appartiennent</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>Laisser %1 de côté</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>Lecture de %1 ...</translation>
    </message>
    <message>
        <source>No images are chosen.</source>
        <translation>Aucune image n&apos;est choisie.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 phases, %n planes</source>
        <translation>
            <numerusform>%1 : %2 phases, %n plan</numerusform>
            <numerusform>%1 : %2 phases, %n plans</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationBox</name>
    <message>
        <source>Preload: stressed blood</source>
        <translation>Précharge&#xa0;: volume contraint</translation>
    </message>
    <message>
        <source>Afterload: body</source>
        <translation>Postcharge&#xa0;: systémique</translation>
    </message>
    <message>
        <source>Afterload: lungs</source>
        <translation>Postcharge&#xa0;: pulmonaire</translation>
    </message>
    <message>
        <source>Contractility, left</source>
        <translation>Contractilité gauche</translation>
    </message>
    <message>
        <source>Contractility, right</source>
        <translation>Contractilité droite</translation>
    </message>
    <message>
        <source>Stiffness, left</source>
        <translation>Rigidité gauche</translation>
    </message>
    <message>
        <source>%1, %2 at rest</source>
        <translation>%1, %2 au repos</translation>
    </message>
    <message>
        <source>%1. Marked: normal, %2 %3 (%4)</source>
        <translation>%1. Repère&#xa0;: normale, %2 %3 (%4)</translation>
    </message>
    <message>
        <source>Only the sample heart can be moved by the circulation model; the charts show its results for any organ.</source>
        <translation>Seul le cœur type peut être animé par le modèle de circulation&#x202f;; les graphiques montrent ses résultats pour tout organe.</translation>
    </message>
    <message>
        <source>Textbook beat</source>
        <translation>Battement de référence</translation>
    </message>
    <message>
        <source>Volumes of healthy adults over one beat at this rate</source>
        <translation>Volumes d’adultes sains sur un battement à cette fréquence</translation>
    </message>
    <message>
        <source>A model of heart and vessels: pressures, pressure-volume loops, valves and sounds</source>
        <translation>Un modèle du cœur et des vaisseaux&#xa0;: pressions, boucles pression-volume, valves et bruits</translation>
    </message>
    <message>
        <source>Rate, preload, afterload</source>
        <translation>Fréquence, précharge, postcharge</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Muscle</translation>
    </message>
    <message>
        <source>Valves and pericardium</source>
        <translation>Valves et péricarde</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Avant&#xa0;: %1</translation>
    </message>
    <message>
        <source>Fitted to the volume and the ejection fraction of a left ventricle.</source>
        <translation>Ajustée au volume et à la fraction d’éjection d’un ventricule gauche.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CirculationModel</name>
    <message>
        <source>Heart of the circulation</source>
        <translation>Cœur de la circulation</translation>
    </message>
</context>
<context>
    <name>viscera::app::ComparedSystem</name>
    <message>
        <source>Coordinates of the second view</source>
        <translation>Coordonnées de la seconde vue</translation>
    </message>
    <message>
        <source>Coordinate system that binds the same organs to the same handles in this view</source>
        <translation>Système de coordonnées qui lie les mêmes organes aux mêmes poignées dans cette vue</translation>
    </message>
</context>
<context>
    <name>viscera::app::Comparison</name>
    <message>
        <source>Rate of the second view</source>
        <translation>Fréquence de la seconde vue</translation>
    </message>
    <message>
        <source> / min</source>
        <translation> / min</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>Ce que montre cette vue</translation>
    </message>
    <message>
        <source>The same organ at another rate</source>
        <translation>Le même organe à une autre fréquence</translation>
    </message>
    <message>
        <source>The same organ with other coordinates</source>
        <translation>Le même organe avec d’autres coordonnées</translation>
    </message>
    <message>
        <source>Open files...</source>
        <translation>Ouvrir des fichiers...</translation>
    </message>
    <message>
        <source>Back to one view</source>
        <translation>Revenir à une vue</translation>
    </message>
    <message>
        <source>Open beside the first organ</source>
        <translation>Ouvrir à côté du premier organe</translation>
    </message>
    <message>
        <source>No organ yet</source>
        <translation>Pas encore d’organe</translation>
    </message>
    <message>
        <source>  %1 / min</source>
        <translation>  %1 / min</translation>
    </message>
    <message>
        <source>The errors of both coordinate systems</source>
        <translation>Les erreurs des deux systèmes de coordonnées</translation>
    </message>
    <message>
        <source>The second view of the session is not shown: %1 is not installed here.</source>
        <translation>La seconde vue de la session n’est pas affichée&#xa0;: %1 n’est pas installé ici.</translation>
    </message>
    <message>
        <source>The same organ, kept in the present pose</source>
        <translation>Le même organe, gardé dans la pose actuelle</translation>
    </message>
    <message>
        <source>Colour each vertex by its distance to the same vertex in view 1; while stress is shown, by what view 1 has more than view 2</source>
        <translation>Colorer chaque sommet selon sa distance au même sommet de la vue 1&#xa0;; quand la contrainte est affichée, selon ce que la vue 1 a de plus que la vue 2</translation>
    </message>
    <message>
        <source>Present pose</source>
        <translation>Pose actuelle</translation>
    </message>
    <message>
        <source>Kept pose</source>
        <translation>Pose gardée</translation>
    </message>
</context>
<context>
    <name>viscera::app::ConnectionDialog</name>
    <message>
        <source>Secure connection (TLS)</source>
        <translation>Connexion sécurisée (TLS)</translation>
    </message>
    <message>
        <source>Add an archive</source>
        <translation>Ajouter une archive</translation>
    </message>
    <message>
        <source>Edit an archive</source>
        <translation>Modifier une archive</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>Classic DICOM services (DIMSE)</source>
        <translation>Services DICOM classiques (DIMSE)</translation>
    </message>
    <message>
        <source>The name under which you choose the archive</source>
        <translation>Le nom sous lequel vous choisissez l&apos;archive</translation>
    </message>
    <message>
        <source>Leave it empty where the archive asks for no password</source>
        <translation>À laisser vide si l&apos;archive ne demande pas de mot de passe</translation>
    </message>
    <message>
        <source>The title (AE title) of the archive, at most 16 characters</source>
        <translation>Le titre (AE title) de l&apos;archive, 16 caractères au plus</translation>
    </message>
    <message>
        <source>The title by which the archive knows this program</source>
        <translation>Le titre sous lequel l&apos;archive connaît ce programme</translation>
    </message>
    <message>
        <source>How long the archive may be silent</source>
        <translation>Combien de temps l&apos;archive peut se taire</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Title of the archive</source>
        <translation>Titre de l&apos;archive</translation>
    </message>
    <message>
        <source>Title of this program</source>
        <translation>Titre de ce programme</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Certificats de confiance</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>Patience</translation>
    </message>
    <message>
        <source>Those of the system</source>
        <translation>Ceux du système</translation>
    </message>
    <message>
        <source>A file with the certificate of the archive&apos;s issuer (.pem)</source>
        <translation>Un fichier avec le certificat de l&apos;émetteur de l&apos;archive (.pem)</translation>
    </message>
    <message>
        <source>Choose the file with the certificates</source>
        <translation>Choisir le fichier des certificats</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt);;All files (*)</source>
        <translation>Certificats (*.pem *.crt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Give the archive a name.</source>
        <translation>Donnez un nom à l&apos;archive.</translation>
    </message>
    <message>
        <source>Another archive has this name.</source>
        <translation>Une autre archive porte ce nom.</translation>
    </message>
    <message>
        <source>Type the address of the archive.</source>
        <translation>Saisissez l&apos;adresse de l&apos;archive.</translation>
    </message>
    <message>
        <source>The address of DICOMweb begins with http:// or https://.</source>
        <translation>L&apos;adresse de DICOMweb commence par http:// ou https://.</translation>
    </message>
    <message>
        <source>The address holds no user and no password.</source>
        <translation>L&apos;adresse ne contient ni utilisateur ni mot de passe.</translation>
    </message>
    <message>
        <source>A title has 1 to 16 plain characters.</source>
        <translation>Un titre a de 1 à 16 caractères simples.</translation>
    </message>
    <message>
        <source>Images travel readable for others in the network, and so does a password.</source>
        <translation>Les images voyagent lisibles pour d&apos;autres sur le réseau, un mot de passe aussi.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourCorrector</name>
    <message>
        <source>Only contours of a motion that was found in images can be corrected.</source>
        <translation>Seuls les contours d&apos;un mouvement trouvé dans des images peuvent être corrigés.</translation>
    </message>
    <message>
        <source>The motion is being fitted to the last correction.</source>
        <translation>Le mouvement est en cours d&apos;ajustement à la dernière correction.</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact. Correct a phase between them, or change its labels.</source>
        <translation>La phase %1 a des labels, qui sont exacts. Corrigez une phase intermédiaire, ou modifiez ses labels.</translation>
    </message>
    <message>
        <source>This organ is not moved by the motion that was found in images.</source>
        <translation>Cet organe n&apos;est pas mû par le mouvement trouvé dans les images.</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Corriger le contour</translation>
    </message>
    <message numerus="yes">
        <source>The motion is that of the images again. %n phases have changed.</source>
        <translation>
            <numerusform>Le mouvement est de nouveau celui des images. %n phase a changé.</numerusform>
            <numerusform>Le mouvement est de nouveau celui des images. %n phases ont changé.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n phases have changed.</source>
        <translation>
            <numerusform>%n phase a changé.</numerusform>
            <numerusform>%n phases ont changé.</numerusform>
        </translation>
    </message>
    <message>
        <source>The motion meets all corrected contours to %1 mm.</source>
        <translation>Le mouvement passe par tous les contours corrigés à %1 mm près.</translation>
    </message>
    <message>
        <source>The corrected contour of %1 in phase %2 is met to %3 mm only.</source>
        <translation>Le contour corrigé de %1 à la phase %2 n&apos;est atteint qu&apos;à %3 mm près.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ContourGrip</name>
    <message>
        <source>Correct &amp;contours</source>
        <translation>Corriger les &amp;contours</translation>
    </message>
    <message>
        <source>Drag the contour of a tracked organ in a slice: the motion is fitted to it. Ctrl does the same while it is held. Enabled for a motion that was found in images</source>
        <translation>Tirez le contour d&apos;un organe suivi dans une coupe : le mouvement s&apos;y ajuste. Ctrl fait de même tant que la touche est enfoncée. Disponible pour un mouvement trouvé dans des images</translation>
    </message>
    <message>
        <source>&amp;Remove a corrected contour</source>
        <translation>&amp;Supprimer un contour corrigé</translation>
    </message>
    <message>
        <source>%1, slice %2, phase %3</source>
        <translation>%1, coupe %2, phase %3</translation>
    </message>
</context>
<context>
    <name>viscera::app::CurveBox</name>
    <message>
        <source>Curve...</source>
        <translation>Courbe...</translation>
    </message>
    <message>
        <source>Organ whose volume is prescribed</source>
        <translation>Organe dont le volume est imposé</translation>
    </message>
    <message>
        <source>A .csv file with two columns: the fraction of the cycle (or time_s) and the volume in ml. At each instant the handles move as little as possible to reach that volume</source>
        <translation>Un fichier .csv à deux colonnes&#xa0;: la fraction du cycle (ou time_s) et le volume en ml. À chaque instant, les poignées bougent le moins possible pour atteindre ce volume</translation>
    </message>
    <message>
        <source>Let the sequence alone determine the volume again</source>
        <translation>Laisser à nouveau la séquence seule déterminer le volume</translation>
    </message>
    <message>
        <source>Volume curves (*.csv *.txt *.tsv)</source>
        <translation>Courbes de volume (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>%1 follows %2; dashed in the chart.</source>
        <translation>%1 suit %2&#x202f;; en tirets dans le graphique.</translation>
    </message>
</context>
<context>
    <name>viscera::app::CutBox</name>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>Cut away the left side</source>
        <translation>Retirer le côté gauche</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Cut away the part nearest to the viewer</source>
        <translation>Retirer ce qui est le plus proche de l’observateur</translation>
    </message>
    <message>
        <source>Distance of the cut from the middle of the organs, in per cent of the distance to their edge</source>
        <translation>Distance de la section au milieu des organes, en pourcentage de la distance jusqu’à leur bord</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Sang</translation>
    </message>
    <message>
        <source>Fill chambers and vessels of the heart with blood. Without it they are empty and show walls, papillary muscles and valves</source>
        <translation>Remplir de sang les cavités et les vaisseaux du cœur. Sans lui, ils sont vides et montrent parois, muscles papillaires et valves</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformMode</name>
    <message>
        <source>Drag a handle and the organ follows; K locks the volume, T turns and scales, M mirrors</source>
        <translation>Faites glisser une poignée et l’organe suit&#x202f;; K verrouille le volume, T tourne et met à l’échelle, M met en miroir</translation>
    </message>
    <message>
        <source>&amp;Turn and scale</source>
        <translation>&amp;Tourner et mettre à l’échelle</translation>
    </message>
    <message>
        <source>In Deform mode, rings turn and cubes scale the selected handles (at least two)</source>
        <translation>En mode Déformer, des anneaux tournent et des cubes mettent à l’échelle les poignées sélectionnées (au moins deux)</translation>
    </message>
    <message>
        <source>Reset &amp;pose</source>
        <translation>Réinitialiser la &amp;pose</translation>
    </message>
    <message>
        <source>Move every handle back to its rest position</source>
        <translation>Ramener chaque poignée à sa position de repos</translation>
    </message>
    <message>
        <source>Reset selected handles</source>
        <translation>Réinitialiser la sélection</translation>
    </message>
    <message>
        <source>Move the selected handles back to their rest positions</source>
        <translation>Ramener les poignées sélectionnées à leur position de repos</translation>
    </message>
    <message>
        <source>Restore &amp;rest volume</source>
        <translation>Rendre le volume de &amp;repos</translation>
    </message>
    <message>
        <source>Restore the organ&apos;s volume at rest with the smallest motion of the handles</source>
        <translation>Rendre à l’organe son volume de repos par le plus petit mouvement des poignées</translation>
    </message>
    <message>
        <source>Selected handles &amp;compensate</source>
        <translation>Les poignées sélectionnées &amp;compensent</translation>
    </message>
    <message>
        <source>Only the selected handles compensate when others would change a locked volume</source>
        <translation>Seules les poignées sélectionnées compensent quand d’autres changeraient un volume verrouillé</translation>
    </message>
    <message>
        <source>&amp;Off</source>
        <translation>&amp;Aucun</translation>
    </message>
    <message>
        <source>&amp;Sagittal plane</source>
        <translation>Plan &amp;sagittal</translation>
    </message>
    <message>
        <source>&amp;Coronal plane</source>
        <translation>Plan &amp;coronal</translation>
    </message>
    <message>
        <source>&amp;Axial plane</source>
        <translation>Plan &amp;axial</translation>
    </message>
    <message>
        <source>In Deform mode, mirrored handles move along with a drag</source>
        <translation>En mode Déformer, les poignées symétriques accompagnent un glissement</translation>
    </message>
    <message>
        <source>&amp;Next mirror plane</source>
        <translation>Plan de miroir &amp;suivant</translation>
    </message>
    <message>
        <source>Switch between off, sagittal, coronal and axial</source>
        <translation>Passer entre aucun, sagittal, coronal et axial</translation>
    </message>
    <message>
        <source>Move e&amp;xactly, others compensate</source>
        <translation>Bouger e&amp;xactement, les autres compensent</translation>
    </message>
    <message>
        <source>Under a locked volume, moved handles go exactly where they are sent, and the others compensate; else a moved handle stays where the volume lets it</source>
        <translation>Sous un volume verrouillé, les poignées vont exactement où on les envoie et les autres compensent&#xa0;; sinon une poignée reste là où le volume le permet</translation>
    </message>
    <message>
        <source>&amp;Free handles follow</source>
        <translation>Les poignées &amp;libres suivent</translation>
    </message>
    <message>
        <source>Handles that you do not drag go to where the elastic energy of the organs&apos; tissue is least; locked handles hold it, else it moves as a whole. Locked volumes stay exact. The first drag takes about a second, the next ones a tenth of a second a step</source>
        <translation>Les poignées que vous ne tirez pas vont là où l&apos;énergie élastique du tissu des organes est minimale ; les poignées verrouillées le retiennent, sinon il se déplace d&apos;un bloc. Les volumes verrouillés restent exacts. Le premier déplacement prend environ une seconde, les suivants un dixième de seconde par pas</translation>
    </message>
    <message>
        <source>&amp;Beside elasticity</source>
        <translation>À côté de l’&amp;élasticité</translation>
    </message>
    <message>
        <source>Show the current organ as an elastic body that the moved handles grip, as a ghost, and colour the organ by the distance from it; the other handles hold it. It takes some seconds after each drag</source>
        <translation>Montre l’organe actuel comme un corps élastique que saisissent les poignées déplacées, en fantôme, et colore l’organe selon la distance à celui-ci ; les autres poignées le tiennent. Cela prend quelques secondes après chaque déplacement</translation>
    </message>
</context>
<context>
    <name>viscera::app::DeformPage</name>
    <message>
        <source>Largest shift</source>
        <translation>Plus grand déplacement</translation>
    </message>
    <message>
        <source>The largest distance by which a vertex of the organ has moved from rest</source>
        <translation>La plus grande distance dont un sommet de l’organe s’est éloigné du repos</translation>
    </message>
    <message>
        <source>Selected handles</source>
        <translation>Poignées sélectionnées</translation>
    </message>
    <message>
        <source>Compensating</source>
        <translation>Compensent</translation>
    </message>
    <message>
        <source>These handles compensate when others would change a locked volume. If none is marked, a dragged handle stays in a plane, and all free handles compensate for other motions.</source>
        <translation>Ces poignées compensent quand d’autres changeraient un volume verrouillé. Si aucune n’est marquée, une poignée que l’on fait glisser reste dans un plan, et toutes les poignées libres compensent les autres mouvements.</translation>
    </message>
    <message>
        <source>Symmetric drags</source>
        <translation>Glissements symétriques</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Handles moved</source>
        <translation>Poignées déplacées</translation>
    </message>
    <message>
        <source>Mirror plane</source>
        <translation>Plan de miroir</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Sagittal plane (left and right)</source>
        <translation>Plan sagittal (gauche et droite)</translation>
    </message>
    <message>
        <source>Coronal plane (front and back)</source>
        <translation>Plan coronal (avant et arrière)</translation>
    </message>
    <message>
        <source>Axial plane (head and feet)</source>
        <translation>Plan axial (tête et pieds)</translation>
    </message>
    <message>
        <source>A drag moves the mirrored handles too; the mirror plane passes through the middle of the organ at rest (M: next plane)</source>
        <translation>Un glissement déplace aussi les poignées symétriques&#x202f;; le plan de miroir passe par le milieu de l’organe au repos (M&#xa0;: plan suivant)</translation>
    </message>
    <message>
        <source>Moves along</source>
        <translation>Accompagne</translation>
    </message>
    <message>
        <source>no handle is near the mirror image</source>
        <translation>aucune poignée près de l’image miroir</translation>
    </message>
    <message>
        <source>all free handles</source>
        <translation>toutes les poignées libres</translation>
    </message>
    <message>
        <source>Elasticity</source>
        <translation>Élasticité</translation>
    </message>
    <message>
        <source>Median distance</source>
        <translation>Distance médiane</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Plus grande distance</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomDialog</name>
    <message>
        <source>Segmentation (SEG)</source>
        <translation>Segmentation (SEG)</translation>
    </message>
    <message>
        <source>The organs as voxels on the grid of the scan, one file for each instant</source>
        <translation>Les organes en voxels sur la grille de l’examen, un fichier par instant</translation>
    </message>
    <message>
        <source>Measurements (SR)</source>
        <translation>Mesures (SR)</translation>
    </message>
    <message>
        <source>A structured report of volumes, distances and angles for each instant</source>
        <translation>Un compte rendu structuré des volumes, distances et angles par instant</translation>
    </message>
    <message>
        <source>Surfaces (STL)</source>
        <translation>Surfaces (STL)</translation>
    </message>
    <message>
        <source>The surface of each organ, one file for each</source>
        <translation>La surface de chaque organe, un fichier pour chacun</translation>
    </message>
    <message>
        <source>Contours (RTSTRUCT)</source>
        <translation>Contours (RTSTRUCT)</translation>
    </message>
    <message>
        <source>Contours on the slices of the scan, for radiotherapy</source>
        <translation>Contours sur les coupes de l’examen, pour la radiothérapie</translation>
    </message>
    <message>
        <source>Without identity</source>
        <translation>Sans identité</translation>
    </message>
    <message>
        <source>No name, number or date of the patient, and new identifiers of study and series</source>
        <translation>Ni nom, ni numéro, ni date du patient, et de nouveaux identifiants de l’étude et de la série</translation>
    </message>
    <message>
        <source>Export as DICOM</source>
        <translation>Exporter en DICOM</translation>
    </message>
    <message>
        <source>The pose that is shown</source>
        <translation>La pose affichée</translation>
    </message>
    <message>
        <source>So many instants of one cycle of the motion</source>
        <translation>Autant d’instants d’un cycle du mouvement</translation>
    </message>
    <message>
        <source>No motion moves the organs</source>
        <translation>Aucun mouvement n’anime les organes</translation>
    </message>
    <message>
        <source>Instants</source>
        <translation>Instants</translation>
    </message>
    <message>
        <source>Whose they are</source>
        <translation>À qui ils sont</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destination</translation>
    </message>
    <message>
        <source>For research and teaching, not for diagnosis.</source>
        <translation>Pour la recherche et l’enseignement, non pour le diagnostic.</translation>
    </message>
    <message>
        <source>The files of the scan are being read</source>
        <translation>Lecture des fichiers de l’examen</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Contours need the slices of a scan</source>
        <translation>Les contours ont besoin des coupes d’un examen</translation>
    </message>
    <message>
        <source>The organs that are written</source>
        <translation>Les organes qui sont écrits</translation>
    </message>
    <message>
        <source>%1 is open and has no inside</source>
        <translation>%1 est ouvert et n’a pas d’intérieur</translation>
    </message>
    <message>
        <source>The elements of each file that say whose it is</source>
        <translation>Les éléments de chaque fichier qui disent à qui il est</translation>
    </message>
    <message>
        <source>A folder, or an archive that From the archive knows</source>
        <translation>Un dossier, ou une archive que «&#x202f;Depuis l’archive&#x202f;» connaît</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Made when it is not there; no file in it is replaced</source>
        <translation>Créé s’il manque&#x202f;; aucun fichier n’y est remplacé</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Choisir le dossier</translation>
    </message>
    <message>
        <source>No DICOM scan says whose they are: they get a study of their own.</source>
        <translation>Aucun examen DICOM ne dit à qui ils sont&#x202f;: ils reçoivent une étude à eux.</translation>
    </message>
    <message>
        <source>Choose at least one object.</source>
        <translation>Choisissez au moins un objet.</translation>
    </message>
    <message>
        <source>Choose at least one organ; its surface has to be closed.</source>
        <translation>Choisissez au moins un organe&#x202f;; sa surface doit être fermée.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Choisissez un dossier.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envoyer</translation>
    </message>
</context>
<context>
    <name>viscera::app::DicomExports</name>
    <message>
        <source>Export as &amp;DICOM...</source>
        <translation>Exporter en &amp;DICOM...</translation>
    </message>
    <message>
        <source>Write organs and measurements as DICOM files, or send them to an archive (PACS)</source>
        <translation>Écrire organes et mesures en fichiers DICOM, ou les envoyer à une archive (PACS)</translation>
    </message>
    <message>
        <source>Reading whose the scan is</source>
        <translation>Lecture de l’identité de l’examen</translation>
    </message>
    <message>
        <source>segmentations</source>
        <translation>segmentations</translation>
    </message>
    <message>
        <source>structured reports</source>
        <translation>comptes rendus structurés</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>surfaces</translation>
    </message>
    <message>
        <source>structure sets</source>
        <translation>ensembles de structures</translation>
    </message>
    <message>
        <source>Exporting as DICOM</source>
        <translation>Exportation en DICOM</translation>
    </message>
    <message>
        <source>Written to %1: %2</source>
        <translation>Écrit dans %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Sent to %1: %2</source>
        <translation>Envoyé à %1&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DifferenceMap</name>
    <message>
        <source>Distance to view 1</source>
        <translation>Distance à la vue 1</translation>
    </message>
    <message>
        <source>%1: view 1 less view 2</source>
        <translation>%1&#xa0;: vue 1 moins vue 2</translation>
    </message>
</context>
<context>
    <name>viscera::app::DisplacementBox</name>
    <message>
        <source>Right to left</source>
        <translation>De droite à gauche</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>D’avant en arrière</translation>
    </message>
    <message>
        <source>Foot to head</source>
        <translation>Des pieds à la tête</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s left; negative: right (R/L)</source>
        <translation>Vers la gauche du patient&#x202f;; négatif&#xa0;: droite (R/L)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s back; negative: front (A/P)</source>
        <translation>Vers le dos du patient&#x202f;; négatif&#xa0;: avant (A/P)</translation>
    </message>
    <message>
        <source>Towards the patient&apos;s head; negative: feet (S/I)</source>
        <translation>Vers la tête du patient&#x202f;; négatif&#xa0;: pieds (S/I)</translation>
    </message>
    <message>
        <source>Move the selected handles once by this distance; locked volumes are kept</source>
        <translation>Déplacer une fois les poignées sélectionnées de cette distance&#x202f;; les volumes verrouillés sont gardés</translation>
    </message>
    <message>
        <source>Moved by %1 of %2 mm: the locked volume allows no more in this direction.</source>
        <translation>Déplacé de %1 sur %2 mm&#xa0;: le volume verrouillé ne permet pas plus dans cette direction.</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Déplacer de</translation>
    </message>
</context>
<context>
    <name>viscera::app::ElasticGhost</name>
    <message>
        <source>There is no organ to compare.</source>
        <translation>Il n’y a pas d’organe à comparer.</translation>
    </message>
    <message>
        <source>Move a handle: at rest there is nothing to compare.</source>
        <translation>Déplacez une poignée : au repos, il n’y a rien à comparer.</translation>
    </message>
    <message>
        <source>The elastic organ is being computed.</source>
        <translation>L’organe élastique est en cours de calcul.</translation>
    </message>
    <message>
        <source>Only an organ that follows the handles can be compared.</source>
        <translation>Seul un organe qui suit les poignées peut être comparé.</translation>
    </message>
    <message>
        <source>Elastic organ</source>
        <translation>Organe élastique</translation>
    </message>
    <message>
        <source>The comparison was cancelled. Move a handle, or switch it off and on again.</source>
        <translation>La comparaison a été annulée. Déplacez une poignée, ou désactivez-la puis réactivez-la.</translation>
    </message>
    <message>
        <source>Distance from elasticity</source>
        <translation>Distance à l’élasticité</translation>
    </message>
</context>
<context>
    <name>viscera::app::ErrorTable</name>
    <message>
        <source>Unity error</source>
        <translation>Erreur de la somme</translation>
    </message>
    <message>
        <source>The largest distance of a vertex&apos;s weights&apos; sum from 1</source>
        <translation>Le plus grand écart entre 1 et la somme des poids d’un sommet</translation>
    </message>
    <message>
        <source>Negative where the system is not positive</source>
        <translation>Négatif là où le système n’est pas positif</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Échecs</translation>
    </message>
    <message>
        <source>Vertices for which the system has no coordinates; they do not move</source>
        <translation>Sommets pour lesquels le système n’a pas de coordonnées&#x202f;; ils ne bougent pas</translation>
    </message>
    <message>
        <source>Binding time</source>
        <translation>Temps de liaison</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExploreMode</name>
    <message>
        <source>Explore</source>
        <translation>Explorer</translation>
    </message>
    <message>
        <source>Left drag rotates, Shift+left pans, right drag or wheel zooms, click selects an organ, D and A measure</source>
        <translation>Glisser à gauche tourne, Maj+gauche déplace, glisser à droite ou molette zoome, un clic sélectionne un organe, D et A mesurent</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; Esc ends</source>
        <translation>Cliquez sur deux points d’un organe ou d’une coupe&#x202f;; Échap termine</translation>
    </message>
    <message>
        <source>Measure &amp;distance</source>
        <translation>Mesurer une &amp;distance</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Measure &amp;angle</source>
        <translation>Mesurer un &amp;angle</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; Esc ends</source>
        <translation>Cliquez sur trois points d’un organe ou d’une coupe, le sommet de l’angle en deuxième&#x202f;; Échap termine</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;rectangle</source>
        <translation>Mesurer les valeurs d’un &amp;rectangle</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Faites glisser sur une coupe de coin à coin&#xa0;: moyenne et écart type des valeurs de l’examen&#x202f;; Échap termine</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Measure the values in a &amp;sphere</source>
        <translation>Mesurer les valeurs d’une &amp;sphère</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border: mean and deviation of the scan&apos;s values; Esc ends</source>
        <translation>Faites glisser sur une coupe du centre au bord&#xa0;: moyenne et écart type des valeurs de l’examen&#x202f;; Échap termine</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Remove all &amp;measurements</source>
        <translation>Supprimer toutes les &amp;mesures</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Mesures</translation>
    </message>
    <message>
        <source>Show the measurements</source>
        <translation>Afficher les mesures</translation>
    </message>
    <message>
        <source>Names of &amp;parts</source>
        <translation>Noms des &amp;parties</translation>
    </message>
    <message>
        <source>Name the parts of the organs, such as the apex of the heart</source>
        <translation>Nommer les parties des organes, comme l’apex du cœur</translation>
    </message>
    <message>
        <source>&amp;Quiz on the parts</source>
        <translation>&amp;Quiz sur les parties</translation>
    </message>
    <message>
        <source>Hide the names and ask for one part after the other; answer with a click on the organ</source>
        <translation>Masquer les noms et demander une partie après l’autre&#x202f;; répondez par un clic sur l’organe</translation>
    </message>
    <message>
        <source>%1. Drags turn the view, Esc ends the quiz</source>
        <translation>%1. Glisser tourne la vue, Échap termine le quiz</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice; drags turn the view, Esc ends</source>
        <translation>Cliquez sur deux points d’un organe ou d’une coupe&#x202f;; glisser tourne la vue, Échap termine</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second; drags turn the view, Esc ends</source>
        <translation>Cliquez sur trois points d’un organe ou d’une coupe, le sommet de l’angle en deuxième&#x202f;; glisser tourne la vue, Échap termine</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner; Esc ends</source>
        <translation>Faites glisser sur une coupe de coin à coin&#x202f;; Échap termine</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle of a sphere to its border; Esc ends</source>
        <translation>Faites glisser sur une coupe du centre d’une sphère à son bord&#x202f;; Échap termine</translation>
    </message>
</context>
<context>
    <name>viscera::app::ExplorePage</name>
    <message>
        <source>View from</source>
        <translation>Vu de</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Rest volume</source>
        <translation>Volume au repos</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Examen</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxels</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermée</translation>
    </message>
    <message numerus="yes">
        <source>open, %n edges</source>
        <translation>
            <numerusform>ouverte, %n arête</numerusform>
            <numerusform>ouverte, %n arêtes</numerusform>
        </translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>aucun sélectionné</translation>
    </message>
    <message>
        <source>Select an organ in the view or in the list to read about it.</source>
        <translation>Sélectionnez un organe dans la vue ou dans la liste pour en lire les données.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases</source>
        <translation>
            <numerusform>%n phase</numerusform>
            <numerusform>%n phases</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 phases</source>
        <translation>%1 phases sur %2</translation>
    </message>
    <message>
        <source> in %1 ms</source>
        <translation> en %1 ms</translation>
    </message>
    <message>
        <source>, pixels of %1 mm</source>
        <translation>, pixels de %1 mm</translation>
    </message>
    <message>
        <source>, %1 mm thick</source>
        <translation>, épaisseur %1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n phases in %1 s</source>
        <translation>
            <numerusform>%n phase en %1 s</numerusform>
            <numerusform>%n phases en %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ExportActions</name>
    <message>
        <source>Export all &amp;organs...</source>
        <translation>Exporter tous les &amp;organes...</translation>
    </message>
    <message>
        <source>Write all visible organs into one file, with names and colours</source>
        <translation>Écrire tous les organes visibles dans un fichier, avec noms et couleurs</translation>
    </message>
    <message>
        <source>Export all organs</source>
        <translation>Exporter tous les organes</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb);;3MF models for printing (*.3mf)</source>
        <translation>Scènes glTF (*.glb);;Modèles 3MF à imprimer (*.3mf)</translation>
    </message>
    <message>
        <source>Export &amp;displacements...</source>
        <translation>Exporter les &amp;déplacements...</translation>
    </message>
    <message>
        <source>Write the current organ at rest, with the displacement of every vertex</source>
        <translation>Écrire l’organe courant au repos, avec le déplacement de chaque sommet</translation>
    </message>
    <message>
        <source>Export displacements</source>
        <translation>Exporter les déplacements</translation>
    </message>
    <message>
        <source>VTK surfaces (*.vtp)</source>
        <translation>Surfaces VTK (*.vtp)</translation>
    </message>
    <message>
        <source>Export displacement &amp;field...</source>
        <translation>Exporter le &amp;champ de déplacement...</translation>
    </message>
    <message>
        <source>Write the displacement of the space around the current organ, for 3D Slicer and ITK</source>
        <translation>Écrire le déplacement de l’espace autour de l’organe courant, pour 3D Slicer et ITK</translation>
    </message>
    <message>
        <source>Export displacement field</source>
        <translation>Exporter le champ de déplacement</translation>
    </message>
    <message>
        <source>Displacement fields (*.nrrd *.mha)</source>
        <translation>Champs de déplacement (*.nrrd *.mha)</translation>
    </message>
    <message>
        <source>Export &amp;table of volumes...</source>
        <translation>Exporter le &amp;tableau des volumes...</translation>
    </message>
    <message>
        <source>Write volumes and sizes of all organs</source>
        <translation>Écrire les volumes et tailles de tous les organes</translation>
    </message>
    <message>
        <source>Export table of volumes</source>
        <translation>Exporter le tableau des volumes</translation>
    </message>
    <message>
        <source>Export &amp;measurements...</source>
        <translation>Exporter les &amp;mesures...</translation>
    </message>
    <message>
        <source>Write all measured distances and angles</source>
        <translation>Écrire toutes les distances et tous les angles mesurés</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Measure a distance (D) or an angle (A) first.</source>
        <translation>Rien n’est encore mesuré. Mesurez d’abord une distance (D) ou un angle (A).</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>Exporter les mesures</translation>
    </message>
    <message>
        <source>all organs</source>
        <translation>tous les organes</translation>
    </message>
    <message numerus="yes">
        <source>The rest position of %n points of the field is uncertain.</source>
        <translation>
            <numerusform>La position de repos de %n point du champ est incertaine.</numerusform>
            <numerusform>La position de repos de %n points du champ est incertaine.</numerusform>
        </translation>
    </message>
    <message>
        <source>table of volumes</source>
        <translation>tableau des volumes</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>mesures</translation>
    </message>
</context>
<context>
    <name>viscera::app::FileActions</name>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Open a session, organs, label maps, handles or a scan</source>
        <translation>Ouvrir une session, des organes, des cartes d’étiquettes, des poignées ou un examen</translation>
    </message>
    <message>
        <source>Open a &amp;folder of masks...</source>
        <translation>Ouvrir un &amp;dossier de masques...</translation>
    </message>
    <message>
        <source>Open one patient: a folder with one mask for each organ, as TotalSegmentator writes it</source>
        <translation>Ouvrir un patient&#xa0;: un dossier avec un masque par organe, tel que TotalSegmentator l’écrit</translation>
    </message>
    <message>
        <source>&amp;Import with check...</source>
        <translation>&amp;Importer avec contrôle...</translation>
    </message>
    <message>
        <source>Check and repair the contents of files before importing them</source>
        <translation>Contrôler et réparer le contenu des fichiers avant de les importer</translation>
    </message>
    <message>
        <source>Save &amp;handles...</source>
        <translation>Enregistrer les &amp;poignées...</translation>
    </message>
    <message>
        <source>Save the handles at rest as Slicer markups</source>
        <translation>Enregistrer les poignées au repos comme markups de Slicer</translation>
    </message>
    <message>
        <source>&amp;Export organ...</source>
        <translation>&amp;Exporter l’organe...</translation>
    </message>
    <message>
        <source>Export the organ in its present pose</source>
        <translation>Exporter l’organe dans sa pose actuelle</translation>
    </message>
    <message>
        <source>Load a &amp;cage...</source>
        <translation>Charger une &amp;cage...</translation>
    </message>
    <message>
        <source>For coordinates that need a cage: load a closed surface around the organ; its vertices become the handles</source>
        <translation>Pour les coordonnées qui demandent une cage&#xa0;: charger une surface fermée autour de l’organe&#x202f;; ses sommets deviennent les poignées</translation>
    </message>
    <message>
        <source>Sessions, organs, label maps, handles and scans (*.viscera %1 %2 %3)</source>
        <translation>Sessions, organes, cartes d’étiquettes, poignées et examens (*.viscera %1 %2 %3)</translation>
    </message>
    <message>
        <source>Sessions (*.viscera)</source>
        <translation>Sessions (*.viscera)</translation>
    </message>
    <message>
        <source>Organs, label maps and handles (%1 %2 %3)</source>
        <translation>Organes, cartes d’étiquettes et poignées (%1 %2 %3)</translation>
    </message>
    <message>
        <source>Label maps (%1)</source>
        <translation>Cartes d’étiquettes (%1)</translation>
    </message>
    <message>
        <source>Handles (%1)</source>
        <translation>Poignées (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a folder with one mask for each organ</source>
        <translation>Ouvrir un dossier avec un masque par organe</translation>
    </message>
    <message numerus="yes">
        <source>Opening %n files</source>
        <translation>
            <numerusform>Ouverture de %n fichier</numerusform>
            <numerusform>Ouverture de %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Save handles</source>
        <translation>Enregistrer les poignées</translation>
    </message>
    <message>
        <source>Slicer markups (*%1 *.fcsv)</source>
        <translation>Markups de Slicer (*%1 *.fcsv)</translation>
    </message>
    <message>
        <source>Load a cage</source>
        <translation>Charger une cage</translation>
    </message>
    <message>
        <source>Closed surfaces (%1);;All files (*)</source>
        <translation>Surfaces fermées (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading the cage %1</source>
        <translation>Lecture de la cage %1</translation>
    </message>
    <message>
        <source>The handles at the vertices of %1 are now the corners of the cage.</source>
        <translation>Les poignées aux sommets de %1 sont maintenant les coins de la cage.</translation>
    </message>
    <message numerus="yes">
        <source>The %n vertices of %1 are now the handles.</source>
        <translation>
            <numerusform>Le sommet (%n) de %1 est maintenant la poignée.</numerusform>
            <numerusform>Les %n sommets de %1 sont maintenant les poignées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Surfaces (%1)</translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>%1 écrit dans %2</translation>
    </message>
    <message>
        <source>%1 was not found.</source>
        <translation>%1 est introuvable.</translation>
    </message>
    <message numerus="yes">
        <source>%n more findings; see the organs&apos; pages in Explore mode</source>
        <translation>
            <numerusform>%n autre constat&#xa0;: voir la page de l’organe en mode Explorer</numerusform>
            <numerusform>%n autres constats&#xa0;: voir les pages des organes en mode Explorer</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lies exactly where %2 lies already: only one of them is seen.</source>
        <translation>%1 se trouve exactement là où se trouve déjà %2 : un seul des deux est visible.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Findings</name>
    <message>
        <source>Side of the body</source>
        <translation>Côté du corps</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Surface ouverte</translation>
    </message>
    <message>
        <source>Edges of more than two triangles</source>
        <translation>Arêtes de plus de deux triangles</translation>
    </message>
    <message>
        <source>Triangles that face inward</source>
        <translation>Triangles tournés vers l’intérieur</translation>
    </message>
    <message>
        <source>Separate pieces</source>
        <translation>Morceaux séparés</translation>
    </message>
    <message>
        <source>Crossing triangles</source>
        <translation>Triangles qui se croisent</translation>
    </message>
    <message>
        <source>Positions of the organs</source>
        <translation>Positions des organes</translation>
    </message>
    <message>
        <source>Lost details</source>
        <translation>Détails perdus</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitBox</name>
    <message>
        <source>by the shape</source>
        <translation>par la forme</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit to this organ</source>
        <translation>Ajuster à cet organe</translation>
    </message>
    <message>
        <source>Sequence to fit</source>
        <translation>Séquence à ajuster</translation>
    </message>
    <message>
        <source>Of the left ventricle. The right one ejects as much blood, and the muscle keeps its volume</source>
        <translation>Du ventricule gauche. Le droit éjecte autant de sang et le muscle garde son volume</translation>
    </message>
    <message>
        <source>%1: click its place in the view</source>
        <translation>%1&#xa0;: placez-le d’un clic dans la vue</translation>
    </message>
    <message>
        <source>click the organ</source>
        <translation>clic sur l’organe</translation>
    </message>
    <message>
        <source>Open a patient&apos;s organ first.</source>
        <translation>Ouvrez d’abord un organe de patient.</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface.</source>
        <translation>%1&#xa0;: surface ouverte&#x202f;; une séquence demande une surface fermée.</translation>
    </message>
    <message>
        <source>Makes %1 and its chambers beat like a textbook heart. The present shape counts as the end of diastole. The result is a key sequence.</source>
        <translation>Fait battre %1 et ses cavités comme le cœur d’un manuel. La forme actuelle compte comme fin de diastole. Le résultat est une séquence de clés.</translation>
    </message>
    <message>
        <source>Moves %1 like the sample organ. Landmarks that you do not set are found from its shape.</source>
        <translation>Anime %1 comme l’organe type. Les repères que vous ne placez pas sont trouvés d’après sa forme.</translation>
    </message>
    <message>
        <source>Fitting %1</source>
        <translation>Ajustement de %1</translation>
    </message>
    <message>
        <source>Fit the textbook&apos;s beat to %1</source>
        <translation>Ajuster le battement de référence à %1</translation>
    </message>
    <message>
        <source>Spine and pelvis stay in place: breathing does not move them.</source>
        <translation>La colonne vertébrale et le bassin restent en place : la respiration ne les déplace pas.</translation>
    </message>
</context>
<context>
    <name>viscera::app::FitOffer</name>
    <message>
        <source>Replace all open organs; Undo brings them back</source>
        <translation>Remplacer tous les organes ouverts&#x202f;; Annuler les ramène</translation>
    </message>
    <message>
        <source>%1 is made for a %2, but the name %3 suggests another organ.</source>
        <translation>%1 est faite pour un organe «&#xa0;%2&#xa0;», mais le nom %3 suggère un autre organe.</translation>
    </message>
    <message>
        <source>%1: fit it to %2?</source>
        <translation>%1&#xa0;: ajuster à %2&#x202f;?</translation>
    </message>
    <message>
        <source>Fit it anyway</source>
        <translation>Ajuster quand même</translation>
    </message>
    <message>
        <source>Fit it to %1</source>
        <translation>Ajuster à %1</translation>
    </message>
    <message>
        <source>%1 is open; a sequence needs a closed surface</source>
        <translation>%1&#xa0;: surface ouverte&#x202f;; une séquence demande une surface fermée</translation>
    </message>
    <message>
        <source>Show the sample %1</source>
        <translation>Montrer l’organe type&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::GroupPanel</name>
    <message>
        <source>No groups: all handles act everywhere. Select handles and make a group of them, or make groups automatically below.</source>
        <translation>Pas de groupes&#xa0;: toutes les poignées agissent partout. Sélectionnez des poignées et faites-en un groupe, ou créez des groupes automatiquement ci-dessous.</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Nouveau groupe</translation>
    </message>
    <message>
        <source>Make a group of the selected handles</source>
        <translation>Faire un groupe des poignées sélectionnées</translation>
    </message>
    <message>
        <source>Select handles</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Select the handles of the chosen group</source>
        <translation>Sélectionner les poignées du groupe choisi</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Ajouter la sélection</translation>
    </message>
    <message>
        <source>Add the selected handles to the chosen group</source>
        <translation>Ajouter les poignées sélectionnées au groupe choisi</translation>
    </message>
    <message>
        <source>Choose the colour of the chosen group</source>
        <translation>Choisir la couleur du groupe choisi</translation>
    </message>
    <message>
        <source>Remove the chosen group; its handles stay</source>
        <translation>Supprimer le groupe choisi&#x202f;; ses poignées restent</translation>
    </message>
    <message>
        <source>How groups are made</source>
        <translation>Façon de grouper</translation>
    </message>
    <message>
        <source>Parts along the axis</source>
        <translation>Parties le long de l’axe</translation>
    </message>
    <message>
        <source>Clusters of handles</source>
        <translation>Amas de poignées</translation>
    </message>
    <message>
        <source>Organs and their pieces</source>
        <translation>Organes et leurs morceaux</translation>
    </message>
    <message>
        <source>How many groups</source>
        <translation>Nombre de groupes</translation>
    </message>
    <message>
        <source>Replace the present groups. Where handles do not surround a group&apos;s part of the organ, the corners of a box are added.</source>
        <translation>Remplacer les groupes actuels. Là où les poignées n’entourent pas la partie d’organe d’un groupe, les coins d’une boîte sont ajoutés.</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Groupe %1</translation>
    </message>
    <message>
        <source>F2 renames</source>
        <translation>F2 renomme</translation>
    </message>
    <message>
        <source>A region needs at least four handles</source>
        <translation>Une région demande au moins quatre poignées</translation>
    </message>
    <message>
        <source>These coordinates do not use groups.</source>
        <translation>Ces coordonnées n’utilisent pas de groupes.</translation>
    </message>
    <message>
        <source>No coordinate system that uses groups is loaded: the plugin is missing.</source>
        <translation>Aucun système de coordonnées à groupes n’est chargé&#xa0;: le plugin manque.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to the group.</source>
        <translation>
            <numerusform>Le groupement automatique a ajouté %n poignée de coin au groupe.</numerusform>
            <numerusform>Le groupement automatique a ajouté %n poignées de coin au groupe.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Automatic grouping has added %n corner handles to %1 of %2 groups.</source>
        <translation>
            <numerusform>Le groupement automatique a ajouté %n poignée de coin à %1 des %2 groupes.</numerusform>
            <numerusform>Le groupement automatique a ajouté %n poignées de coin à %1 des %2 groupes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Take the selected handles out of the chosen group</source>
        <translation>Retirer les poignées sélectionnées du groupe choisi</translation>
    </message>
</context>
<context>
    <name>viscera::app::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Guide de l’utilisateur</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Chercher dans le guide</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sections</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleController</name>
    <message numerus="yes">
        <source>Turn %n handles</source>
        <translation>
            <numerusform>Tourner %n poignée</numerusform>
            <numerusform>Tourner %n poignées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n handles</source>
        <translation>
            <numerusform>Mettre %n poignée à l’échelle</numerusform>
            <numerusform>Mettre %n poignées à l’échelle</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleModel</name>
    <message>
        <source>Handle</source>
        <translation>Poignée</translation>
    </message>
    <message>
        <source>Rest L</source>
        <translation>Repos L</translation>
    </message>
    <message>
        <source>Rest P</source>
        <translation>Repos P</translation>
    </message>
    <message>
        <source>Rest S</source>
        <translation>Repos S</translation>
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
        <translation>Déplacée (mm)</translation>
    </message>
    <message>
        <source>Coordinate</source>
        <translation>Coordonnée</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePanel</name>
    <message>
        <source>No handles yet.
Move the slider above to place some, or click the organ in Handles mode (2).</source>
        <translation>Pas encore de poignées.
Déplacez le curseur ci-dessus pour en placer, ou cliquez sur l’organe en mode Poignées (2).</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>Placer automatiquement</translation>
    </message>
    <message>
        <source>Place this many handles evenly, a little outside the organ&apos;s surface; they replace the present ones</source>
        <translation>Placer ce nombre de poignées régulièrement, un peu hors de la surface de l’organe&#x202f;; elles remplacent les actuelles</translation>
    </message>
    <message>
        <source>Enclosing box</source>
        <translation>Boîte englobante</translation>
    </message>
    <message>
        <source>Eight of the handles are the corners of a box around the organ, so that all of it lies inside</source>
        <translation>Huit des poignées sont les coins d’une boîte autour de l’organe, qui le contient ainsi tout entier</translation>
    </message>
    <message>
        <source>F2 renames, Delete removes</source>
        <translation>F2 renomme, Suppr supprime</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlePlacer</name>
    <message>
        <source>Place handles</source>
        <translation>Placer les poignées</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandleTable</name>
    <message>
        <source>Table of handles</source>
        <translation>Tableau des poignées</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, with all digits (Ctrl+C)</source>
        <translation>Copier les lignes sélectionnées, ou toutes, avec tous les chiffres (Ctrl+C)</translation>
    </message>
    <message>
        <source>&amp;Table of handles...</source>
        <translation>&amp;Tableau des poignées...</translation>
    </message>
    <message>
        <source>Positions of all handles, and the coordinates of a vertex that you click</source>
        <translation>Positions de toutes les poignées, et coordonnées du sommet sur lequel vous cliquez</translation>
    </message>
    <message>
        <source>Click the organ in the view to see the coordinates of its nearest vertex.</source>
        <translation>Cliquez sur l’organe dans la vue pour voir les coordonnées du sommet le plus proche.</translation>
    </message>
    <message>
        <source>Vertex %1 of %2, at rest at %3, %4, %5 mm (LPS)</source>
        <translation>Sommet %1 sur %2, au repos à %3; %4; %5 mm (LPS)</translation>
    </message>
    <message>
        <source>%1: the organ is not bound to the handles.</source>
        <translation>%1&#xa0;: l’organe n’est pas lié aux poignées.</translation>
    </message>
    <message>
        <source>%1. Its coordinates sum to %2 and miss it by %3 mm.</source>
        <translation>%1. Ses coordonnées ont pour somme %2 et le manquent de %3 mm.</translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesMode</name>
    <message>
        <source>Click the organ to add a handle, drag to move it, Delete removes it; the rest shape stays</source>
        <translation>Cliquez sur l’organe pour ajouter une poignée, faites-la glisser pour la déplacer, Suppr la supprime&#x202f;; la forme au repos reste</translation>
    </message>
    <message>
        <source>&amp;Place automatically</source>
        <translation>&amp;Placer automatiquement</translation>
    </message>
    <message>
        <source>Spread handles evenly around the organ</source>
        <translation>Répartir les poignées régulièrement autour de l’organe</translation>
    </message>
    <message>
        <source>Add &amp;enclosing handles</source>
        <translation>Ajouter des poignées &amp;englobantes</translation>
    </message>
    <message>
        <source>Add the eight corners of a box around everything</source>
        <translation>Ajouter les huit coins d’une boîte autour de tout</translation>
    </message>
    <message>
        <source>&amp;Remove handles</source>
        <translation>&amp;Supprimer les poignées</translation>
    </message>
    <message>
        <source>Remove the selected handles</source>
        <translation>Supprimer les poignées sélectionnées</translation>
    </message>
    <message>
        <source>Select &amp;all handles</source>
        <translation>&amp;Sélectionner toutes les poignées</translation>
    </message>
    <message>
        <source>Use the &amp;hull as the cage</source>
        <translation>Utiliser l’en&amp;veloppe comme cage</translation>
    </message>
    <message>
        <source>Discard the loaded cage and use the convex hull of the handles again</source>
        <translation>Abandonner la cage chargée et reprendre l’enveloppe convexe des poignées</translation>
    </message>
    <message>
        <source>&amp;Influence map</source>
        <translation>Carte d’&amp;influence</translation>
    </message>
    <message>
        <source>Colour the organ by the influence of the selected handle</source>
        <translation>Colorer l’organe selon l’influence de la poignée sélectionnée</translation>
    </message>
    <message>
        <source>Show &amp;regions</source>
        <translation>Afficher les &amp;régions</translation>
    </message>
    <message>
        <source>Show where each group of handles acts, and the cage of coordinates that need one</source>
        <translation>Montrer où agit chaque groupe de poignées, et la cage des coordonnées qui en demandent une</translation>
    </message>
    <message>
        <source>Show &amp;zones</source>
        <translation>Afficher les &amp;zones</translation>
    </message>
    <message>
        <source>Show where regions meet, in red</source>
        <translation>Montrer en rouge où les régions se rejoignent</translation>
    </message>
    <message>
        <source>Show &amp;super-regions</source>
        <translation>Afficher les s&amp;uper-régions</translation>
    </message>
    <message>
        <source>Show the super-region that counts in each zone, in yellow</source>
        <translation>Montrer en jaune la super-région qui compte dans chaque zone</translation>
    </message>
    <message>
        <source>Bound in %1 ms</source>
        <translation>Lié en %1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n handles removed</source>
        <translation>
            <numerusform>%n poignée supprimée</numerusform>
            <numerusform>%n poignées supprimées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HandlesPage</name>
    <message>
        <source>not bound</source>
        <translation>non lié</translation>
    </message>
    <message>
        <source>binding...</source>
        <translation>liaison...</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>lié</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulée</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>impossible</translation>
    </message>
    <message>
        <source>Binding</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Handle at rest</source>
        <translation>Poignée au repos</translation>
    </message>
    <message>
        <source>The cage is the convex hull of the handles.</source>
        <translation>La cage est l’enveloppe convexe des poignées.</translation>
    </message>
    <message>
        <source>The cage has %1 triangles over %2 handles.</source>
        <translation>La cage a %1 triangles sur %2 poignées.</translation>
    </message>
    <message numerus="yes">
        <source>%1 ms, %n threads</source>
        <translation>
            <numerusform>%1 ms, %n thread</numerusform>
            <numerusform>%1 ms, %n threads</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartNumbersBox</name>
    <message>
        <source>Numbers of the measured heart</source>
        <translation>Valeurs du cœur mesuré</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>par m²</translation>
    </message>
    <message>
        <source>End of diastole here</source>
        <translation>Fin de la diastole ici</translation>
    </message>
    <message>
        <source>The present instant is the end of diastole (ED)</source>
        <translation>L&apos;instant présent est la fin de la diastole (ED)</translation>
    </message>
    <message>
        <source>End of systole here</source>
        <translation>Fin de la systole ici</translation>
    </message>
    <message>
        <source>The present instant is the end of systole (ES)</source>
        <translation>L&apos;instant présent est la fin de la systole (ES)</translation>
    </message>
    <message>
        <source>Find both ends</source>
        <translation>Trouver les deux fins</translation>
    </message>
    <message>
        <source>ED is where the volume is largest, ES where it is smallest</source>
        <translation>ED est l&apos;instant du plus grand volume, ES celui du plus petit</translation>
    </message>
    <message>
        <source>Height and weight...</source>
        <translation>Taille et poids...</translation>
    </message>
    <message>
        <source>Body surface area by Mosteller, for numbers per square metre</source>
        <translation>Surface corporelle selon Mosteller, pour les valeurs par mètre carré</translation>
    </message>
    <message>
        <source>Save as CSV...</source>
        <translation>Enregistrer en CSV...</translation>
    </message>
    <message>
        <source>Write these numbers into a table</source>
        <translation>Écrire ces valeurs dans un tableau</translation>
    </message>
    <message>
        <source>ED at %1 % of the cycle, ES at %2 %</source>
        <translation>ED à %1 % du cycle, ES à %2 %</translation>
    </message>
    <message>
        <source>Body surface</source>
        <translation>Surface corporelle</translation>
    </message>
    <message>
        <source>Height in cm</source>
        <translation>Taille en cm</translation>
    </message>
    <message>
        <source>Weight in kg</source>
        <translation>Poids en kg</translation>
    </message>
    <message>
        <source>A body surface area of %1 m² is not that of an adult: nothing is indexed</source>
        <translation>Une surface corporelle de %1 m² n&apos;est pas celle d&apos;un adulte : rien n&apos;est indexé</translation>
    </message>
    <message>
        <source>Save the heart&apos;s numbers</source>
        <translation>Enregistrer les valeurs du cœur</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>The heart&apos;s numbers are in %1</source>
        <translation>Les valeurs du cœur sont dans %1</translation>
    </message>
    <message>
        <source>Estimates: only one phase of the images has labels. Of a right ventricle there are no numbers then.</source>
        <translation>Estimations : une seule phase des images a des étiquettes. Il n&apos;y a alors pas de nombres pour un ventricule droit.</translation>
    </message>
    <message>
        <source>Body surface %1 m² from the images: %2 cm, %3 kg</source>
        <translation>Surface corporelle %1 m² d&apos;après les images : %2 cm, %3 kg</translation>
    </message>
</context>
<context>
    <name>viscera::app::HeartOpener</name>
    <message>
        <source>Opening the heart</source>
        <translation>Ouverture du cœur</translation>
    </message>
</context>
<context>
    <name>viscera::app::Help</name>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Souris et touches</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>&amp;Visite en deux minutes</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Bienvenue</translation>
    </message>
    <message>
        <source>&amp;About Viscera</source>
        <translation>À &amp;propos de Viscera</translation>
    </message>
    <message>
        <source>Viscera %1: organs deformed by handles, without a cage. BSD-3-Clause; a program for research and teaching, not a medical device.</source>
        <translation>Viscera %1&#xa0;: des organes déformés par des poignées, sans cage. BSD-3-Clause&#x202f;; un programme pour la recherche et l’enseignement, pas un dispositif médical.</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Regarder</translation>
    </message>
    <message>
        <source>Drag with the left button to rotate, with Shift to pan; the wheel zooms. Click an organ to select it, press F to bring it into the picture; D measures distances, A angles. The eye in the list on the left hides it, the square changes its colour.</source>
        <translation>Faites glisser avec le bouton gauche pour tourner, avec Maj pour déplacer&#x202f;; la molette zoome. Cliquez sur un organe pour le sélectionner, appuyez sur F pour le cadrer&#x202f;; D mesure des distances, A des angles. L’œil de la liste de gauche le masque, le carré change sa couleur.</translation>
    </message>
    <message>
        <source>Play a motion</source>
        <translation>Lire un mouvement</translation>
    </message>
    <message>
        <source>Space plays and pauses. The timeline shows the phases of the cycle: drag along it to look at one instant. Below, the volumes are drawn as they change.</source>
        <translation>Espace lit et met en pause. La barre de temps montre les phases du cycle&#xa0;: faites-la glisser pour regarder un instant. Dessous, les volumes sont tracés à mesure qu’ils changent.</translation>
    </message>
    <message>
        <source>Organs follow handles around them. Here you edit them at rest: click the organ to add one, drag to move it, Delete to remove it. The organ is bound again at once. I shows how far a handle reaches.</source>
        <translation>Les organes suivent les poignées qui les entourent. Ici vous les modifiez au repos&#xa0;: cliquez sur l’organe pour en ajouter une, faites-la glisser pour la déplacer, Suppr pour la supprimer. L’organe est aussitôt relié. I montre jusqu’où porte une poignée.</translation>
    </message>
    <message>
        <source>Drag a handle and the organ follows; its volume is in the status bar. The padlock in the list on the left (K) keeps the volume whatever you do. T turns and scales selected handles, M mirrors drags. Ctrl+Z undoes any change, G shows the rest shape as an outline.</source>
        <translation>Faites glisser une poignée et l’organe suit&#x202f;; son volume est dans la barre d’état. Le cadenas dans la liste de gauche (K) garde le volume quoi que vous fassiez. T tourne et met à l’échelle les poignées sélectionnées, M met les glissements en miroir. Ctrl+Z annule tout changement, G montre le contour de la forme au repos.</translation>
    </message>
    <message>
        <source>The colours say how much the pose distorts the tissue inside. Click the organ to read the values of a point, C cuts it open, M shows the next map. Space plays the sequence, and the map follows.</source>
        <translation>Les couleurs montrent à quel point la pose distord le tissu à l’intérieur. Cliquez sur l’organe pour lire les valeurs d’un point&#x202f;; C l’ouvre, M montre la carte suivante. Espace lit la séquence et la carte suit.</translation>
    </message>
    <message>
        <source>Your own organs</source>
        <translation>Vos propres organes</translation>
    </message>
    <message>
        <source>Open surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) or label maps (NIfTI, NRRD, DICOM-SEG) with Ctrl+O or drop them here; they get handles at once. Ctrl+S saves all of it as a session. ? lists all keys.</source>
        <translation>Ouvrez des surfaces (STL, OBJ, PLY, OFF, VTK, VTP, GLB) ou des cartes d’étiquettes (NIfTI, NRRD, DICOM-SEG) avec Ctrl+O ou déposez-les ici&#x202f;; elles reçoivent aussitôt des poignées. Ctrl+S enregistre le tout comme session.&#x202f;? montre toutes les touches.</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Guide de l’utilisateur</translation>
    </message>
    <message>
        <source>The guide, at what the present mode does</source>
        <translation>Le guide, à l’endroit du mode présent</translation>
    </message>
    <message>
        <source>&amp;First task: drag a dot</source>
        <translation>&amp;Premier essai&#xa0;: tirer un point</translation>
    </message>
</context>
<context>
    <name>viscera::app::Histogram</name>
    <message>
        <source>Histogram of the map</source>
        <translation>Histogramme de la carte</translation>
    </message>
    <message>
        <source>Number of witness points with each value; the lines mark the mean and the 95th percentile</source>
        <translation>Nombre de points témoins pour chaque valeur&#x202f;; les lignes marquent la moyenne et le 95e centile</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportController</name>
    <message>
        <source>Import or cancel the files in the panel first, then open the others.</source>
        <translation>Importez ou annulez d’abord les fichiers du panneau, puis ouvrez les autres.</translation>
    </message>
    <message>
        <source>Check of %1</source>
        <translation>Contrôle de %1</translation>
    </message>
    <message numerus="yes">
        <source>Check of %n files</source>
        <translation>
            <numerusform>Contrôle de %n fichier</numerusform>
            <numerusform>Contrôle de %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Repairing: %1</source>
        <translation>Réparation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Checking again</source>
        <translation>Nouveau contrôle</translation>
    </message>
    <message>
        <source>%1 of %2 organs could not be repaired that way and stay as they are. The panel says why.</source>
        <translation>%1 organes sur %2 n’ont pas pu être réparés ainsi et restent tels quels. Le panneau dit pourquoi.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ImportPanel</name>
    <message>
        <source>No problems found. Nothing is in the document yet.</source>
        <translation>Aucun problème trouvé. Rien n’est encore dans le document.</translation>
    </message>
    <message>
        <source>Check the findings first. Nothing is in the document yet, and no file is changed.</source>
        <translation>Examinez d’abord les constats. Rien n’est encore dans le document, et aucun fichier n’est modifié.</translation>
    </message>
    <message>
        <source>%1 organs: %2 with faults, %3 to check, %4 without problems. Nothing is in the document yet, and no file is changed.</source>
        <translation>%1 organes&#xa0;: %2 avec défauts, %3 à examiner, %4 sans problème. Rien n’est encore dans le document, et aucun fichier n’est modifié.</translation>
    </message>
    <message>
        <source>%1 of %2 organs are not life-sized; a change of unit applies to all organs from surface files</source>
        <translation>%1 organes sur %2 ne sont pas grandeur nature&#x202f;; un changement d’unité s’applique à tous les organes lus dans des fichiers de surface</translation>
    </message>
    <message>
        <source>%1: %2 of %3 organs</source>
        <translation>%1&#xa0;: %2 organes sur %3</translation>
    </message>
    <message>
        <source>Find an organ</source>
        <translation>Chercher un organe</translation>
    </message>
    <message>
        <source>Organs to show, by finding</source>
        <translation>Organes à afficher, par constat</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Import all organs of this list</source>
        <translation>Importer tous les organes de cette liste</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Import no organ of this list</source>
        <translation>N’importer aucun organe de cette liste</translation>
    </message>
    <message numerus="yes">
        <source>Import %n organs</source>
        <translation>
            <numerusform>Importer %n organe</numerusform>
            <numerusform>Importer %n organes</numerusform>
        </translation>
    </message>
    <message>
        <source>Import as it is</source>
        <translation>Importer tel quel</translation>
    </message>
    <message>
        <source>All organs together</source>
        <translation>Tous les organes ensemble</translation>
    </message>
    <message>
        <source>Every organ</source>
        <translation>Chaque organe</translation>
    </message>
    <message>
        <source>To check</source>
        <translation>À examiner</translation>
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
        <translation>Donnez une pose à l’organe en mode Déformer et appuyez sur Ctrl+K&#xa0;: chaque clé mémorise cette pose.</translation>
    </message>
    <message>
        <source>Time of the next key</source>
        <translation>Temps de la prochaine clé</translation>
    </message>
    <message>
        <source>Easing to the key after it</source>
        <translation>Transition vers la clé suivante</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Ajouter une clé</translation>
    </message>
    <message>
        <source>Store the present pose as a key (Ctrl+K)</source>
        <translation>Mémoriser la pose actuelle comme clé (Ctrl+K)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>temps (s)</translation>
    </message>
    <message>
        <source>easing</source>
        <translation>transition</translation>
    </message>
    <message>
        <source>Take pose</source>
        <translation>Reprendre la pose</translation>
    </message>
    <message>
        <source>Set the present pose to that of this key</source>
        <translation>Donner à l’organe la pose de cette clé</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Store the present pose in this key</source>
        <translation>Mémoriser la pose actuelle dans cette clé</translation>
    </message>
    <message>
        <source>Remove this key</source>
        <translation>Supprimer cette clé</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Lancer la lecture</translation>
    </message>
    <message>
        <source>Play the key sequence</source>
        <translation>Lire la séquence de clés</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Enregistrer...</translation>
    </message>
    <message>
        <source>Save the sequence as a file</source>
        <translation>Enregistrer la séquence dans un fichier</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Ouvrir...</translation>
    </message>
    <message>
        <source>Open a sequence file</source>
        <translation>Ouvrir un fichier de séquence</translation>
    </message>
    <message>
        <source>Duration </source>
        <translation>Durée </translation>
    </message>
    <message>
        <source>Sequences (*%1)</source>
        <translation>Séquences (*%1)</translation>
    </message>
    <message>
        <source>Save the sequence</source>
        <translation>Enregistrer la séquence</translation>
    </message>
    <message>
        <source>Open a sequence</source>
        <translation>Ouvrir une séquence</translation>
    </message>
</context>
<context>
    <name>viscera::app::KeySequencePlayback</name>
    <message>
        <source>Record a key at %1 s</source>
        <translation>Enregistrer une clé à %1 s</translation>
    </message>
    <message>
        <source>Use a key&apos;s pose</source>
        <translation>Utiliser la pose d’une clé</translation>
    </message>
    <message>
        <source>Sequence saved as %1</source>
        <translation>Séquence enregistrée dans %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::LectureScreen</name>
    <message>
        <source>&amp;Lecture</source>
        <translation>&amp;Présentation</translation>
    </message>
    <message>
        <source>The view alone on the whole screen, in large letters; Page Down shows the next slide, Escape ends it</source>
        <translation>La vue seule sur tout l’écran, en grandes lettres&#x202f;; Page suiv. montre la diapositive suivante, Échap termine</translation>
    </message>
    <message>
        <source>&amp;Darken the screen</source>
        <translation>&amp;Noircir l’écran</translation>
    </message>
    <message>
        <source>&amp;Pressures and volume</source>
        <translation>&amp;Pressions et volume</translation>
    </message>
    <message>
        <source>Pressure-volume &amp;loops</source>
        <translation>&amp;Boucles pression-volume</translation>
    </message>
    <message>
        <source>&amp;Electrocardiogram</source>
        <translation>&amp;Électrocardiogramme</translation>
    </message>
    <message>
        <source>Open &amp;valves</source>
        <translation>&amp;Valves ouvertes</translation>
    </message>
    <message>
        <source>Heart &amp;sounds</source>
        <translation>Bruits du &amp;cœur</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonDialog</name>
    <message>
        <source>Handles that a reader can drag</source>
        <translation>Poignées que le lecteur peut déplacer</translation>
    </message>
    <message>
        <source>Web page for any browser (.html)</source>
        <translation>Page web pour tout navigateur (.html)</translation>
    </message>
    <message>
        <source>Animated glTF scene (.glb)</source>
        <translation>Scène glTF animée (.glb)</translation>
    </message>
    <message>
        <source>Language of the page&apos;s buttons and messages; the texts below stay as they are</source>
        <translation>Langue des boutons et messages de la page&#x202f;; les textes ci-dessous restent tels quels</translation>
    </message>
    <message>
        <source>A reader of the lesson sees only these texts: it holds no file names, no dates and no hidden organs. Check the texts for names of patients; double-click a text to change it.</source>
        <translation>Le lecteur de la leçon ne voit que ces textes&#xa0;: elle ne contient ni noms de fichiers, ni dates, ni organes masqués. Vérifiez que les textes ne contiennent pas de noms de patients&#x202f;; double-cliquez sur un texte pour le changer.</translation>
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
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Enregistrer sous...</translation>
    </message>
    <message>
        <source>Texts of the lesson</source>
        <translation>Textes de la leçon</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>The shape of a head or a face can identify a patient.</source>
        <translation>La forme d’une tête ou d’un visage peut identifier un patient.</translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation>Langue de la fenêtre</translation>
    </message>
</context>
<context>
    <name>viscera::app::LessonExport</name>
    <message>
        <source>Export &amp;lesson...</source>
        <translation>Exporter la &amp;leçon...</translation>
    </message>
    <message>
        <source>Write the organs and their motion as one page that opens in any browser</source>
        <translation>Écrire les organes et leur mouvement en une page qui s’ouvre dans tout navigateur</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>glTF scenes (*.glb)</source>
        <translation>Scènes glTF (*.glb)</translation>
    </message>
    <message>
        <source>Exporting the lesson</source>
        <translation>Exportation de la leçon</translation>
    </message>
    <message>
        <source>Written to %1 (%2 MB). The motion in the file differs by at most %3 mm.</source>
        <translation>Écrit dans %1 (%2 Mo). Le mouvement du fichier diffère de %3 mm au plus.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MainWindow</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>%1: checked, no problems found</source>
        <translation>%1&#xa0;: contrôlé, aucun problème trouvé</translation>
    </message>
    <message>
        <source>Viscera cancelled the drag because you chose another mode.</source>
        <translation>Viscera a annulé le glissement, car vous avez choisi un autre mode.</translation>
    </message>
    <message>
        <source>Close without these files?</source>
        <translation>Fermer sans ces fichiers&#x202f;?</translation>
    </message>
    <message>
        <source>Viscera is still writing: %1.</source>
        <translation>Viscera écrit encore&#xa0;: %1.</translation>
    </message>
    <message>
        <source>If you close Viscera now, it does not finish these files.</source>
        <translation>Si vous fermez Viscera maintenant, il ne terminera pas ces fichiers.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Wait</source>
        <translation>&amp;Attendre</translation>
    </message>
    <message>
        <source>View kept as %1</source>
        <translation>Vue conservée sous le nom %1</translation>
    </message>
    <message>
        <source>Writing a movie</source>
        <translation>Écriture d’un film</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>&amp;Paramètres...</translation>
    </message>
    <message>
        <source>Language, theme, folders and what is shown at the start</source>
        <translation>Langue, thème, dossiers et ce qui est montré au démarrage</translation>
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
        <translation>Tracer les valeurs le long de la droite au repos entre deux sondes choisies, ou entre les deux dernières</translation>
    </message>
    <message>
        <source>Remove the chosen probes and profiles (Delete in the list)</source>
        <translation>Supprimer les sondes et les profils choisis (Suppr dans la liste)</translation>
    </message>
    <message>
        <source>Probes and profiles</source>
        <translation>Sondes et profils</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>%1: at rest %2 mm</source>
        <translation>%1&#xa0;: au repos %2 mm</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>hors tissu</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm de long</translation>
    </message>
    <message>
        <source>Profile along the line between two probes; the value is the largest</source>
        <translation>Profil le long de la ligne entre deux sondes&#x202f;; la valeur est la plus grande</translation>
    </message>
    <message>
        <source>Place in the pose: towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S)</source>
        <translation>Lieu dans la pose&#xa0;: vers la droite (R) ou la gauche (L), l’avant (A) ou l’arrière (P), les pieds (I) ou la tête (S)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasureBox</name>
    <message>
        <source>Remove the chosen measurement (Delete in the list)</source>
        <translation>Supprimer la mesure choisie (Suppr dans la liste)</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Tout supprimer</translation>
    </message>
    <message>
        <source>Export CSV...</source>
        <translation>Exporter en CSV...</translation>
    </message>
    <message>
        <source>Points stay on the organ while it moves, and can be dragged along it; those on a slice go with the warped scan.</source>
        <translation>Les points restent sur l’organe quand il bouge, et glissent le long de lui&#x202f;; ceux d’une coupe suivent le scan déformé.</translation>
    </message>
    <message>
        <source>Click two points on an organ or on a slice. Esc ends.</source>
        <translation>Cliquez sur deux points d’un organe ou d’une coupe. Échap termine.</translation>
    </message>
    <message>
        <source>Click three points on an organ or on a slice, the corner second. Esc ends.</source>
        <translation>Cliquez sur trois points d’un organe ou d’une coupe, le sommet de l’angle en deuxième. Échap termine.</translation>
    </message>
    <message>
        <source>Drag on a slice from corner to corner. Esc ends.</source>
        <translation>Faites glisser sur une coupe de coin à coin. Échap termine.</translation>
    </message>
    <message>
        <source>Drag on a slice from the middle to the border. Esc ends.</source>
        <translation>Faites glisser sur une coupe du centre au bord. Échap termine.</translation>
    </message>
</context>
<context>
    <name>viscera::app::MeasuredMotion</name>
    <message numerus="yes">
        <source>Motion of %n phases. Mean distance from the measured surfaces: %1.</source>
        <translation>
            <numerusform>Mouvement de %n phase. Distance moyenne aux surfaces mesurées&#xa0;: %1.</numerusform>
            <numerusform>Mouvement de %n phases. Distance moyenne aux surfaces mesurées&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The series does not show how points move along a wall. The mean and the 95th percentile over the beat are reliable, the local pattern of this map is not.</source>
        <translation>La série ne montre pas comment les points se déplacent le long d’une paroi. La moyenne et le 95e centile sur le battement sont fiables, le motif local de cette carte ne l’est pas.</translation>
    </message>
    <message>
        <source>Leave out phase %1</source>
        <translation>Omettre la phase %1</translation>
    </message>
    <message>
        <source>Surface of phase %1</source>
        <translation>Surface de la phase %1</translation>
    </message>
    <message>
        <source>Distance from the measured surface</source>
        <translation>Distance à la surface mesurée</translation>
    </message>
    <message>
        <source>The search for the motion was cancelled.</source>
        <translation>La recherche du mouvement a été annulée.</translation>
    </message>
    <message numerus="yes">
        <source>%n phases need attention: see the table beside the chart.</source>
        <translation>
            <numerusform>%n phase demande attention&#xa0;: voir le tableau à côté du graphique.</numerusform>
            <numerusform>%n phases demandent attention&#xa0;: voir le tableau à côté du graphique.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>An estimate of %n phases from the images and the labels of phase %1 alone. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Une estimation de %n phase à partir des images et des étiquettes de la seule phase %1. Distance moyenne aux étiquettes et au tissu suivi : %2.</numerusform>
            <numerusform>Une estimation de %n phases à partir des images et des étiquettes de la seule phase %1. Distance moyenne aux étiquettes et au tissu suivi : %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Motion of %n phases from the images and the labels of phases %1. Mean distance from labels and followed tissue: %2.</source>
        <translation>
            <numerusform>Mouvement de %n phase à partir des images et des étiquettes des phases %1. Distance moyenne aux étiquettes et au tissu suivi : %2.</numerusform>
            <numerusform>Mouvement de %n phases à partir des images et des étiquettes des phases %1. Distance moyenne aux étiquettes et au tissu suivi : %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Motion from images</source>
        <translation>Mouvement à partir d&apos;images</translation>
    </message>
    <message>
        <source>Not used for the motion</source>
        <translation>Non utilisé pour le mouvement</translation>
    </message>
    <message>
        <source>Estimate: %1</source>
        <translation>Estimation : %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::Menus</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>Sample &amp;organs</source>
        <translation>&amp;Organes types</translation>
    </message>
    <message>
        <source>Export &amp;more</source>
        <translation>Autres &amp;exportations</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;Steps</source>
        <translation>É&amp;tapes</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>St&amp;ress map</source>
        <translation>&amp;Carte de contrainte</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>E&amp;xamen</translation>
    </message>
    <message>
        <source>&amp;Slides</source>
        <translation>&amp;Diapositives</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>The next start uses this language: %1.</source>
        <translation>Le prochain démarrage utilisera cette langue&#xa0;: %1.</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Comme le &amp;système</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>&amp;Organe</translation>
    </message>
    <message>
        <source>Ha&amp;ndles</source>
        <translation>&amp;Poignées</translation>
    </message>
    <message>
        <source>&amp;Mirror drags</source>
        <translation>Glissements en &amp;miroir</translation>
    </message>
    <message>
        <source>&amp;Sequence</source>
        <translation>&amp;Séquence</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Rien n’a encore été ouvert</translation>
    </message>
    <message numerus="yes">
        <source>%n earlier steps</source>
        <translation>
            <numerusform>%n étape antérieure</numerusform>
            <numerusform>%n étapes antérieures</numerusform>
        </translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>À l’ouverture</translation>
    </message>
    <message>
        <source>No sample organs are installed</source>
        <translation>Aucun organe type n’est installé</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Regarder depuis</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparer</translation>
    </message>
    <message>
        <source>S&amp;hown in lectures and movies</source>
        <translation>Montré dans les &amp;présentations et les films</translation>
    </message>
</context>
<context>
    <name>viscera::app::MessageBar</name>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Fermer ce message (Échap)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>viscera::app::MotionDialog</name>
    <message>
        <source>Tissue around cavities</source>
        <translation>Tissu autour de cavités</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omettre</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Find the motion</source>
        <translation>Trouver le mouvement</translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation>Dossier...</translation>
    </message>
    <message>
        <source>Files...</source>
        <translation>Fichiers...</translation>
    </message>
    <message>
        <source>All phases, or one 4D NIfTI or .seq.nrrd</source>
        <translation>Toutes les phases, ou un NIfTI 4D ou .seq.nrrd</translation>
    </message>
    <message>
        <source>Surfaces of the series</source>
        <translation>Surfaces de la série</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Duration of one whole cycle: the number of phases times the step between them</source>
        <translation>Durée d’un cycle entier&#xa0;: le nombre de phases multiplié par le pas entre elles</translation>
    </message>
    <message>
        <source>The last phase leads back to the first</source>
        <translation>La dernière phase ramène à la première</translation>
    </message>
    <message>
        <source>60 for one surface, 120 for several. More follow the surfaces more closely</source>
        <translation>60 pour une surface, 120 pour plusieurs. Davantage suivent les surfaces de plus près</translation>
    </message>
    <message>
        <source>Keep the measured volumes exactly</source>
        <translation>Garder exactement les volumes mesurés</translation>
    </message>
    <message>
        <source>Larger distances count less: for label maps with outliers</source>
        <translation>Les grandes distances comptent moins&#xa0;: pour des cartes d’étiquettes à valeurs aberrantes</translation>
    </message>
    <message>
        <source>Distances count less beyond</source>
        <translation>Pondération réduite au-delà de</translation>
    </message>
    <message>
        <source>Leave out phases</source>
        <translation>Phases à omettre</translation>
    </message>
    <message>
        <source>Folder with a series</source>
        <translation>Dossier d’une série</translation>
    </message>
    <message>
        <source>Phases of a series</source>
        <translation>Phases d’une série</translation>
    </message>
    <message>
        <source>Reading the series</source>
        <translation>Lecture de la série</translation>
    </message>
    <message>
        <source>A single image shows no motion. Open it with File &gt; Open, then choose &quot;Fit a sequence to an organ&quot; in Play mode to give the heart and its chambers the textbook&apos;s beat.</source>
        <translation>Une image seule ne montre pas de mouvement. Ouvrez-la avec Fichier &gt; Ouvrir, puis choisissez «&#xa0;Ajuster une séquence à un organe&#xa0;» en mode Lecture pour donner au cœur et à ses cavités le battement de référence.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Label %1; a double click gives the surface another name</source>
        <translation>Étiquette %1&#x202f;; un double-clic donne un autre nom à la surface</translation>
    </message>
    <message>
        <source>%1 a minute</source>
        <translation>%1 par minute</translation>
    </message>
    <message>
        <source>The files do not state it</source>
        <translation>Les fichiers ne l’indiquent pas</translation>
    </message>
    <message>
        <source>No series is chosen.</source>
        <translation>Aucune série n’est choisie.</translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation>Lecture de %1 ...</translation>
    </message>
    <message numerus="yes">
        <source>%1: label maps, %n phases</source>
        <translation>
            <numerusform>%1&#xa0;: cartes d’étiquettes, %n phase</numerusform>
            <numerusform>%1&#xa0;: cartes d’étiquettes, %n phases</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: surfaces, %n phases</source>
        <translation>
            <numerusform>%1&#xa0;: surfaces, %n phase</numerusform>
            <numerusform>%1&#xa0;: surfaces, %n phases</numerusform>
        </translation>
    </message>
    <message>
        <source>Working...</source>
        <translation>En cours...</translation>
    </message>
    <message>
        <source>Enter the duration of one cycle first</source>
        <translation>Indiquez d’abord la durée d’un cycle</translation>
    </message>
    <message>
        <source>Outer surface</source>
        <translation>Surface externe</translation>
    </message>
    <message>
        <source>%1 is not a phase</source>
        <translation>%1 n’est pas une phase</translation>
    </message>
    <message>
        <source>name phases by their numbers, counted from 1, as in 3, 7</source>
        <translation>nommez les phases par leurs numéros, comptés à partir de 1, comme 3, 7</translation>
    </message>
    <message>
        <source>Choose a series first</source>
        <translation>Choisissez d’abord une série</translation>
    </message>
    <message>
        <source>A single image shows no motion</source>
        <translation>Une image seule ne montre pas de mouvement</translation>
    </message>
    <message>
        <source>Turns one organ, given in several phases of a cycle, into handles and a key sequence with a key for each phase. Choose surfaces or label maps, one file for each phase, or one file with several phases. The result replaces the open organs; Undo brings them back.</source>
        <translation>Transforme un organe, donné en plusieurs phases d’un cycle, en poignées et en une séquence de clés, une clé par phase. Choisissez des surfaces ou des cartes d’étiquettes, un fichier par phase, ou un fichier à plusieurs phases. Le résultat remplace les organes ouverts&#x202f;; Annuler les ramène.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sans limite</translation>
    </message>
    <message>
        <source>For example 3, 7</source>
        <translation>Par exemple 3, 7</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation>Rôle de %1</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Annuler la recherche</translation>
    </message>
    <message>
        <source>What the motion is found from</source>
        <translation>À partir de quoi le mouvement est trouvé</translation>
    </message>
    <message>
        <source>Labels or surfaces of every phase</source>
        <translation>Étiquettes ou surfaces de chaque phase</translation>
    </message>
    <message>
        <source>Cine images, and labels of a few phases</source>
        <translation>Images ciné et étiquettes de quelques phases</translation>
    </message>
    <message>
        <source>Turns the labels of a few phases, the ends of diastole and systole at least, and cine images of the whole cycle into handles and a key sequence with a key for each phase. Volumes of labelled phases are exact; the images show the others. One labelled phase gives an estimate. The result replaces the open organs; Undo brings them back.</source>
        <translation>Transforme les étiquettes de quelques phases, au moins des fins de diastole et de systole, et les images ciné de tout le cycle en poignées et en une séquence de clés avec une clé par phase. Les volumes des phases étiquetées sont exacts ; les images montrent les autres. Une seule phase étiquetée donne une estimation. Le résultat remplace les organes ouverts ; Annuler les ramène.</translation>
    </message>
    <message>
        <source>Leave out series</source>
        <translation>Séries à laisser de côté</translation>
    </message>
    <message>
        <source>The labels are being read</source>
        <translation>Lecture des étiquettes en cours</translation>
    </message>
    <message>
        <source>Choose other labels: these cannot be read</source>
        <translation>Choisissez d&apos;autres étiquettes : celles-ci sont illisibles</translation>
    </message>
    <message>
        <source>%1 is not the number of a series</source>
        <translation>%1 n&apos;est pas un numéro de série</translation>
    </message>
    <message>
        <source>name series by their numbers, as in 3, 7</source>
        <translation>nommez les séries par leurs numéros, comme dans 3, 7</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieBox</name>
    <message>
        <source>Choose a destination</source>
        <translation>Choisir la destination</translation>
    </message>
    <message>
        <source> / s</source>
        <translation> / s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Cycles</translation>
    </message>
    <message>
        <source>Write phase and volumes into it</source>
        <translation>Y inscrire la phase et les volumes</translation>
    </message>
    <message>
        <source>Table of volumes beside it (.csv)</source>
        <translation>Tableau des volumes à côté (.csv)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Record what the view shows</source>
        <translation>Enregistrer ce que montre la vue</translation>
    </message>
    <message>
        <source>MP4 and GIF need the program ffmpeg, which is not installed on this computer.</source>
        <translation>MP4 et GIF demandent le programme ffmpeg, qui n’est pas installé sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Dossier des images</translation>
    </message>
    <message>
        <source>Record as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Cancel the movie</source>
        <translation>Annuler le film</translation>
    </message>
    <message>
        <source>Discard the movie</source>
        <translation>Abandonner le film</translation>
    </message>
</context>
<context>
    <name>viscera::app::MoviePlan</name>
    <message>
        <source>Ogg movie (.ogv)</source>
        <translation>Film Ogg (.ogv)</translation>
    </message>
    <message>
        <source>MP4 movie (.mp4)</source>
        <translation>Film MP4 (.mp4)</translation>
    </message>
    <message>
        <source>Animated GIF (.gif)</source>
        <translation>GIF animé (.gif)</translation>
    </message>
    <message>
        <source>PNG pictures (folder)</source>
        <translation>Images PNG (dossier)</translation>
    </message>
    <message>
        <source>Table of volumes (.csv)</source>
        <translation>Tableau des volumes (.csv)</translation>
    </message>
</context>
<context>
    <name>viscera::app::MovieRecorder</name>
    <message>
        <source>Recording %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::NumbersTable</name>
    <message>
        <source>Numbers of the circulation</source>
        <translation>Valeurs de la circulation</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganCheck</name>
    <message>
        <source>%1, open</source>
        <translation>%1, ouverte</translation>
    </message>
    <message>
        <source>Import this organ</source>
        <translation>Importer cet organe</translation>
    </message>
    <message numerus="yes">
        <source>%n checks passed</source>
        <translation>
            <numerusform>%n contrôle réussi</numerusform>
            <numerusform>%n contrôles réussis</numerusform>
        </translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Fait&#xa0;: %1</translation>
    </message>
    <message>
        <source>More repairs</source>
        <translation>Autres réparations</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Comme dans le fichier</translation>
    </message>
    <message>
        <source>Undo the repairs of this organ</source>
        <translation>Annuler les réparations de cet organe</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganMenu</name>
    <message>
        <source>&amp;Lock volume</source>
        <translation>&amp;Verrouiller le volume</translation>
    </message>
    <message>
        <source>Keep the organ&apos;s volume constant in Deform mode; for an organ with cavities, the volume within its outer surface</source>
        <translation>Garder constant le volume de l’organe en mode Déformer&#x202f;; pour un organe à cavités, le volume dans sa surface externe</translation>
    </message>
    <message>
        <source>The organ&apos;s own colours</source>
        <translation>Couleurs propres de l’organe</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Changer la couleur</translation>
    </message>
    <message>
        <source>&amp;Shortest distance of two organs</source>
        <translation>Di&amp;stance la plus courte de deux organes</translation>
    </message>
    <message>
        <source>Two organs</source>
        <translation>Deux organes</translation>
    </message>
    <message>
        <source>Choose two organs in the list: the distance follows them, wherever they are nearest</source>
        <translation>Choisissez deux organes dans la liste&#xa0;: la distance les suit, où qu’ils soient le plus proches</translation>
    </message>
    <message>
        <source>Choose two organs in the list first, the second one with Ctrl.</source>
        <translation>Choisissez d’abord deux organes dans la liste, le second avec Ctrl.</translation>
    </message>
    <message>
        <source>&amp;Bends as soft tissue</source>
        <translation>Se &amp;plie comme un tissu mou</translation>
    </message>
    <message>
        <source>Every place of the organ follows the handles</source>
        <translation>Chaque endroit de l’organe suit les poignées</translation>
    </message>
    <message>
        <source>Moves as a r&amp;igid body</source>
        <translation>Bouge en corps r&amp;igide</translation>
    </message>
    <message>
        <source>The organ keeps its shape and moves as the tissue around it does on the whole; so do bones</source>
        <translation>L’organe garde sa forme et bouge comme le tissu autour de lui dans l’ensemble&#xa0;; de même les os</translation>
    </message>
    <message>
        <source>Stays in &amp;place</source>
        <translation>Reste en pl&amp;ace</translation>
    </message>
    <message>
        <source>No handle moves the organ</source>
        <translation>Aucune poignée ne bouge l’organe</translation>
    </message>
    <message>
        <source>Textbook colours</source>
        <translation>Couleurs des manuels</translation>
    </message>
</context>
<context>
    <name>viscera::app::OrganPanel</name>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>No organ yet.
Open a file (Ctrl+O), drop one here, or take a sample organ from the menu.</source>
        <translation>Pas encore d’organe.
Ouvrez un fichier (Ctrl+O), déposez-en un ici, ou prenez un organe type dans le menu.</translation>
    </message>
    <message>
        <source>Find an organ (Ctrl+F)</source>
        <translation>Chercher un organe (Ctrl+F)</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Changer l’opacité</translation>
    </message>
    <message>
        <source>Show &amp;only this</source>
        <translation>Afficher &amp;seulement ceci</translation>
    </message>
    <message>
        <source>Show the chosen organs with their cavities and hide all others</source>
        <translation>Afficher les organes choisis avec leurs cavités et masquer tous les autres</translation>
    </message>
    <message>
        <source>&amp;Hide this</source>
        <translation>&amp;Masquer ceci</translation>
    </message>
    <message>
        <source>Hide the chosen organs</source>
        <translation>Masquer les organes choisis</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Tout &amp;afficher</translation>
    </message>
    <message>
        <source>Show every organ</source>
        <translation>Afficher tous les organes</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>&amp;Find an organ</source>
        <translation>&amp;Chercher un organe</translation>
    </message>
    <message>
        <source>Type a part of its name</source>
        <translation>Tapez une partie de son nom</translation>
    </message>
    <message>
        <source>Re&amp;name organ</source>
        <translation>&amp;Renommer l’organe</translation>
    </message>
    <message>
        <source>&amp;Remove organ</source>
        <translation>&amp;Supprimer l’organe</translation>
    </message>
    <message>
        <source>Hide all of them (click)</source>
        <translation>Tous les masquer (clic)</translation>
    </message>
    <message>
        <source>Show all of them (click)</source>
        <translation>Tous les afficher (clic)</translation>
    </message>
    <message>
        <source>Hide (click)</source>
        <translation>Masquer (clic)</translation>
    </message>
    <message>
        <source>Show (click)</source>
        <translation>Afficher (clic)</translation>
    </message>
    <message numerus="yes">
        <source>%1
%n triangles</source>
        <translation>
            <numerusform>%1
%n triangle</numerusform>
            <numerusform>%1
%n triangles</numerusform>
        </translation>
    </message>
    <message>
        <source>
Double click or F2 renames; a click on the square changes the colour</source>
        <translation>
Un double-clic ou F2 renomme&#x202f;; un clic sur le carré change la couleur</translation>
    </message>
    <message>
        <source>An open surface has no volume to lock; click to close its holes</source>
        <translation>Une surface ouverte n’a pas de volume à verrouiller&#x202f;; cliquez pour fermer ses trous</translation>
    </message>
    <message>
        <source>The volume is locked: Deform mode keeps it (click or K to unlock)</source>
        <translation>Le volume est verrouillé&#xa0;: le mode Déformer le garde (clic ou K pour déverrouiller)</translation>
    </message>
    <message>
        <source>Lock the volume (click or K)</source>
        <translation>Verrouiller le volume (clic ou K)</translation>
    </message>
    <message>
        <source>
This is the volume within the outer surface; cavities have locks of their own</source>
        <translation>
C’est le volume dans la surface externe&#x202f;; les cavités ont leurs propres verrous</translation>
    </message>
    <message>
        <source>
This is the volume of the cavity; the wall around it has a lock of its own</source>
        <translation>
C’est le volume de la cavité&#x202f;; la paroi qui l’entoure a son propre verrou</translation>
    </message>
    <message>
        <source>open</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>An open surface encloses no volume</source>
        <translation>Une surface ouverte n’enferme aucun volume</translation>
    </message>
    <message>
        <source>%1 at rest, %2 (%3) now</source>
        <translation>%1 au repos, %2 (%3) actuellement</translation>
    </message>
    <message numerus="yes">
        <source>%n organs removed</source>
        <translation>
            <numerusform>%n organe supprimé</numerusform>
            <numerusform>%n organes supprimés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n organs and all handles removed</source>
        <translation>
            <numerusform>%n organe et toutes les poignées supprimés</numerusform>
            <numerusform>%n organes et toutes les poignées supprimés</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 sur %3)</translation>
    </message>
    <message>
        <source>The sample organ is being made.</source>
        <translation>L’organe d’exemple est en cours de création.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PanelDock</name>
    <message>
        <source>Float or dock the panel %1</source>
        <translation>Détacher ou ancrer le panneau %1</translation>
    </message>
    <message>
        <source>Hide the panel %1 (the View menu shows it again)</source>
        <translation>Masquer le panneau %1 (le menu Vue l’affiche à nouveau)</translation>
    </message>
</context>
<context>
    <name>viscera::app::PasswordDialog</name>
    <message>
        <source>Keep it in the system&apos;s key ring</source>
        <translation>Le conserver dans le trousseau du système</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Mot de passe</translation>
    </message>
    <message>
        <source>Password of %1 at %2</source>
        <translation>Mot de passe de %1 chez %2</translation>
    </message>
    <message>
        <source>Else Viscera asks again after the next start</source>
        <translation>Sinon Viscera demande de nouveau au prochain démarrage</translation>
    </message>
    <message>
        <source>There is no key ring; Viscera asks again after the next start</source>
        <translation>Il n&apos;y a pas de trousseau ; Viscera demande de nouveau au prochain démarrage</translation>
    </message>
    <message>
        <source>The archive refuses the user name or the password.</source>
        <translation>L&apos;archive refuse le nom d&apos;utilisateur ou le mot de passe.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PatientOffer</name>
    <message>
        <source>Searching beside %1</source>
        <translation>Recherche à côté de %1</translation>
    </message>
    <message>
        <source>Open the scan</source>
        <translation>Ouvrir l’examen</translation>
    </message>
    <message>
        <source>Open its organs</source>
        <translation>Ouvrir ses organes</translation>
    </message>
    <message>
        <source>The scan %2 has the same voxels as %1.</source>
        <translation>L’examen %2 a les mêmes voxels que %1.</translation>
    </message>
    <message>
        <source>The label map %2 has the same voxels as %1.</source>
        <translation>La carte d’étiquettes %2 a les mêmes voxels que %1.</translation>
    </message>
</context>
<context>
    <name>viscera::app::PersonBox</name>
    <message>
        <source>Women and men</source>
        <translation>Femmes et hommes</translation>
    </message>
    <message>
        <source>Women</source>
        <translation>Femmes</translation>
    </message>
    <message>
        <source>Men</source>
        <translation>Hommes</translation>
    </message>
    <message>
        <source>Whose normal ranges are shown</source>
        <translation>Personnes dont les intervalles normaux sont affichés</translation>
    </message>
    <message>
        <source> m²</source>
        <translation> m²</translation>
    </message>
    <message>
        <source>any body surface area</source>
        <translation>toute surface corporelle</translation>
    </message>
    <message>
        <source>Body surface area: ranges that the source gives per square metre are scaled by it</source>
        <translation>Surface corporelle&#xa0;: les intervalles que la source donne par mètre carré sont multipliés par elle</translation>
    </message>
</context>
<context>
    <name>viscera::app::PhaseScrubber</name>
    <message>
        <source>Instant of the cycle</source>
        <translation>Instant du cycle</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys</source>
        <translation>Faites glisser, ou utilisez les flèches</translation>
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
        <translation>Plan</translation>
    </message>
    <message>
        <source>in this phase</source>
        <translation>dans cette phase</translation>
    </message>
    <message>
        <source>weight %</source>
        <translation>poids %</translation>
    </message>
    <message>
        <source>likeness %</source>
        <translation>ressemblance %</translation>
    </message>
    <message>
        <source>arrives mm</source>
        <translation>arrivée mm</translation>
    </message>
    <message>
        <source>apart mm</source>
        <translation>écart mm</translation>
    </message>
    <message>
        <source>over the beat</source>
        <translation>sur le battement</translation>
    </message>
    <message>
        <source>Series or slice, and what it shows of the heart</source>
        <translation>Série ou coupe, et ce qu&apos;elle montre du cœur</translation>
    </message>
    <message>
        <source>What the plane says of the phase that is shown</source>
        <translation>Ce que le plan dit de la phase affichée</translation>
    </message>
    <message>
        <source>Mean weight of its contours over the beat</source>
        <translation>Poids moyen de ses contours sur le battement</translation>
    </message>
    <message>
        <source>How alike its images are around the wall, over the beat</source>
        <translation>Ressemblance de ses images autour de la paroi, sur le battement</translation>
    </message>
    <message>
        <source>How far its tissue arrives from the next labelled surface</source>
        <translation>À quelle distance de la surface étiquetée suivante son tissu arrive</translation>
    </message>
    <message>
        <source>Distance of its tissue from the surfaces</source>
        <translation>Distance de son tissu aux surfaces</translation>
    </message>
    <message>
        <source>Why the plane says little</source>
        <translation>Pourquoi le plan dit peu de choses</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bon</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayMode</name>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Space plays or pauses; drag the timeline to look at one instant</source>
        <translation>Espace lit ou met en pause&#x202f;; faites glisser la barre de temps pour regarder un instant</translation>
    </message>
    <message>
        <source>Slow &amp;motion</source>
        <translation>&amp;Ralenti</translation>
    </message>
    <message>
        <source>Slower, down to a tenth; then real time again</source>
        <translation>Plus lent, jusqu’à un dixième&#x202f;; puis de nouveau temps réel</translation>
    </message>
    <message>
        <source>&amp;Chart of one cycle</source>
        <translation>&amp;Graphique d’un cycle</translation>
    </message>
    <message>
        <source>Draw one cycle with a cursor instead of the last seconds</source>
        <translation>Tracer un cycle avec un curseur au lieu des dernières secondes</translation>
    </message>
    <message>
        <source>&amp;ECG, sounds and valves</source>
        <translation>&amp;ECG, bruits et valves</translation>
    </message>
    <message>
        <source>Under the phases of a heart: a schematic electrocardiogram, S1 and S2, and which valves are open</source>
        <translation>Sous les phases d’un cœur&#xa0;: un électrocardiogramme schématique, B1 et B2, et quelles valves sont ouvertes</translation>
    </message>
    <message>
        <source>&amp;Valves and flow</source>
        <translation>&amp;Valves et flux</translation>
    </message>
    <message>
        <source>Record a &amp;key</source>
        <translation>Enregistrer une &amp;clé</translation>
    </message>
    <message>
        <source>Add the present pose to the key sequence</source>
        <translation>Ajouter la pose actuelle à la séquence de clés</translation>
    </message>
    <message>
        <source>Motion from a ser&amp;ies...</source>
        <translation>Mouvement d’une &amp;série...</translation>
    </message>
    <message>
        <source>Compare two &amp;rates</source>
        <translation>Comparer deux &amp;fréquences</translation>
    </message>
    <message>
        <source>Show the same organs beside these at another rate, or with the circulation kept as before</source>
        <translation>Montrer les mêmes organes à côté de ceux-ci à une autre fréquence, ou avec la circulation gardée comme avant</translation>
    </message>
    <message>
        <source>Compare &amp;coordinates</source>
        <translation>Comparer les c&amp;oordonnées</translation>
    </message>
    <message>
        <source>Show the same organs and handles beside these with another coordinate system</source>
        <translation>Montrer les mêmes organes et poignées à côté de ceux-ci avec un autre système de coordonnées</translation>
    </message>
    <message>
        <source>Compare with another &amp;organ...</source>
        <translation>Comparer avec un &amp;autre organe...</translation>
    </message>
    <message>
        <source>Open files in a second view beside these organs</source>
        <translation>Ouvrir des fichiers dans une seconde vue à côté de ces organes</translation>
    </message>
    <message>
        <source>Compare with the te&amp;xtbook&apos;s heart</source>
        <translation>Comparer avec le cœur du &amp;manuel</translation>
    </message>
    <message>
        <source>Show the sample heart with its textbook beat beside these organs, at their rate</source>
        <translation>Montrer le cœur type avec son battement de référence à côté de ces organes, à leur fréquence</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>&amp;Une vue</translation>
    </message>
    <message>
        <source>Close the second view</source>
        <translation>Fermer la seconde vue</translation>
    </message>
    <message>
        <source>&amp;Pressures and loops</source>
        <translation>&amp;Pressions et boucles</translation>
    </message>
    <message>
        <source>Where a circulation moves the heart, show its curves below the view instead of the volumes</source>
        <translation>Quand une circulation anime le cœur, montrer ses courbes sous la vue au lieu des volumes</translation>
    </message>
    <message>
        <source>Keep circ&amp;ulation for comparison</source>
        <translation>&amp;Garder la circulation pour comparer</translation>
    </message>
    <message>
        <source>Keep this circulation to compare with: dashed loops and a second column of numbers</source>
        <translation>Garder cette circulation pour comparer&#xa0;: boucles en tirets et seconde colonne de valeurs</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Terminer la comparaison</translation>
    </message>
    <message>
        <source>Organ &amp;labels</source>
        <translation>&amp;Noms des organes</translation>
    </message>
    <message>
        <source>Write names beside the organs</source>
        <translation>Écrire les noms à côté des organes</translation>
    </message>
    <message>
        <source>See &amp;through</source>
        <translation>&amp;Transparence</translation>
    </message>
    <message>
        <source>Make the wall translucent, so that the cavities are seen</source>
        <translation>Rendre la paroi translucide pour voir les cavités</translation>
    </message>
    <message>
        <source>See through</source>
        <translation>Transparence</translation>
    </message>
    <message>
        <source>Key at %1 s</source>
        <translation>Clé à %1 s</translation>
    </message>
    <message>
        <source>Recorded as %1</source>
        <translation>Enregistré comme %1</translation>
    </message>
    <message>
        <source>Compare with the present &amp;pose</source>
        <translation>Comparer avec la pose act&amp;uelle</translation>
    </message>
    <message>
        <source>Only the sample heart has valves to show</source>
        <translation>Seul le cœur type a des valves à montrer</translation>
    </message>
    <message>
        <source>In the beating sample heart: leaflets as far open as the valves are, and arrows whose width shows the opening and whose length shows the speed of the blood</source>
        <translation>Dans le cœur type qui bat&#xa0;: des feuillets ouverts comme les valves, et des flèches dont la largeur montre l’ouverture et la longueur, la vitesse du sang</translation>
    </message>
    <message>
        <source>This sequence has no valves; choose the heartbeat</source>
        <translation>Cette séquence n’a pas de valves&#x202f;; choisissez le battement du cœur</translation>
    </message>
    <message>
        <source>Show the present pose in a second view, to compare it with later poses</source>
        <translation>Montrer la pose actuelle dans une seconde vue, pour la comparer aux poses suivantes</translation>
    </message>
    <message>
        <source>&amp;Discard kept circulation</source>
        <translation>A&amp;bandonner la circulation gardée</translation>
    </message>
    <message>
        <source>Make the wall opaque</source>
        <translation>Rendre la paroi opaque</translation>
    </message>
    <message>
        <source>The movie does not show distance colours, measured surfaces or warped slices.</source>
        <translation>Le film ne montre ni les couleurs des distances, ni les surfaces mesurées, ni les coupes déformées.</translation>
    </message>
    <message>
        <source>Below the view, show curves and bull&apos;s eye of the heart&apos;s strain instead of the volumes</source>
        <translation>Afficher sous la vue les courbes et le bull’s eye de la déformation du cœur au lieu des volumes</translation>
    </message>
    <message>
        <source>Colour the heart&apos;s wall by the strain of its segments; a click chooses one</source>
        <translation>Colorer la paroi du cœur selon la déformation de ses segments&#x202f;; un clic en choisit un</translation>
    </message>
    <message>
        <source>Compute a patient&apos;s own motion from surfaces or label maps of each phase of the cycle, or from cine images and the labels of a few phases</source>
        <translation>Calculer le mouvement propre d&apos;un patient à partir de surfaces ou de cartes d&apos;étiquettes de chaque phase du cycle, ou d&apos;images ciné et des étiquettes de quelques phases</translation>
    </message>
</context>
<context>
    <name>viscera::app::PlayPage</name>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Source of the motion</source>
        <translation>Source du mouvement</translation>
    </message>
    <message>
        <source>During one cycle</source>
        <translation>Sur le cycle</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>SV</source>
        <translation>VES</translation>
    </message>
    <message>
        <source>EF</source>
        <translation>FE</translation>
    </message>
    <message>
        <source>Volumes in ml. SV is the stroke volume, EF the ejection fraction.</source>
        <translation>Volumes en ml. VES&#xa0;: volume d’éjection systolique, FE&#xa0;: fraction d’éjection.</translation>
    </message>
    <message>
        <source>Circulation of this heart</source>
        <translation>Circulation de ce cœur</translation>
    </message>
    <message>
        <source>Finds pressures, loops and sounds for the volume and the ejection fraction of this left ventricle. The organ keeps its own motion.</source>
        <translation>Calcule pressions, boucles et bruits pour le volume et la fraction d’éjection de ce ventricule gauche. L’organe garde son propre mouvement.</translation>
    </message>
    <message>
        <source>Record a movie</source>
        <translation>Enregistrer un film</translation>
    </message>
    <message>
        <source>Key sequence</source>
        <translation>Séquence de clés</translation>
    </message>
    <message>
        <source>Fit a sequence to an organ</source>
        <translation>Ajuster une séquence à un organe</translation>
    </message>
    <message>
        <source>%1 / min, one cycle %2 s</source>
        <translation>%1 / min, un cycle %2 s</translation>
    </message>
    <message>
        <source>%1, measured on the surfaces. Healthy adults: %2</source>
        <translation>%1, mesuré sur les surfaces. Adultes sains&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2; %3</source>
        <translation>%1&#xa0;: %2&#x202f;; %3</translation>
    </message>
    <message>
        <source>Normal for %1: %2.</source>
        <translation>Normale pour %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>An estimate: only one phase of the images has labels</source>
        <translation>Une estimation : une seule phase des images a des étiquettes</translation>
    </message>
</context>
<context>
    <name>viscera::app::Playback</name>
    <message>
        <source>The sequence %1 moves its own handles, but the document has others.</source>
        <translation>La séquence %1 déplace ses propres poignées, mais le document en a d’autres.</translation>
    </message>
    <message>
        <source>Use its handles</source>
        <translation>Utiliser ses poignées</translation>
    </message>
    <message>
        <source>posed by hand</source>
        <translation>pose à la main</translation>
    </message>
</context>
<context>
    <name>viscera::app::PoseEditor</name>
    <message numerus="yes">
        <source>Reset %n handles</source>
        <translation>
            <numerusform>Réinitialiser %n poignée</numerusform>
            <numerusform>Réinitialiser %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>The handles could not move back all the way: %1.</source>
        <translation>Les poignées n’ont pas pu revenir jusqu’au bout&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Volume %1</source>
        <translation>Volume %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 is open (%n boundary edges), so it has no volume that could be locked.</source>
        <translation>
            <numerusform>%1&#xa0;: surface ouverte (%n arête de bord), donc sans volume à verrouiller.</numerusform>
            <numerusform>%1&#xa0;: surface ouverte (%n arêtes de bord), donc sans volume à verrouiller.</numerusform>
        </translation>
    </message>
    <message>
        <source>Close the holes and lock</source>
        <translation>Fermer les trous et verrouiller</translation>
    </message>
    <message>
        <source>Close holes and lock volume</source>
        <translation>Fermer les trous et verrouiller le volume</translation>
    </message>
    <message>
        <source>These organs are open, so they have no volumes that could be locked: %1.</source>
        <translation>Ces organes sont ouverts et n’ont pas de volume à verrouiller&#xa0;: %1.</translation>
    </message>
    <message>
        <source>the locked volume leaves %1 of %2 mm</source>
        <translation>le volume verrouillé laisse %1 sur %2 mm</translation>
    </message>
    <message>
        <source>Move exactly, others compensate</source>
        <translation>Bouger exactement, les autres compensent</translation>
    </message>
</context>
<context>
    <name>viscera::app::PositionBox</name>
    <message>
        <source>No handle is selected. Click one in the view or in the list.</source>
        <translation>Aucune poignée n’est sélectionnée. Cliquez sur l’une d’elles dans la vue ou dans la liste.</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Poignée %1</translation>
    </message>
    <message>
        <source>, %1 mm from rest</source>
        <translation>, à %1 mm du repos</translation>
    </message>
    <message>
        <source>, locked</source>
        <translation>, verrouillée</translation>
    </message>
    <message>
        <source>Place in the patient</source>
        <translation>Position dans le patient</translation>
    </message>
    <message>
        <source>Right or left</source>
        <translation>Droite ou gauche</translation>
    </message>
    <message>
        <source>Front or back</source>
        <translation>Avant ou arrière</translation>
    </message>
    <message>
        <source>Foot or head</source>
        <translation>Pieds ou tête</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProbeCard</name>
    <message>
        <source>Surface point %1</source>
        <translation>Point de surface %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Witness point %1</source>
        <translation>Point témoin %1</translation>
    </message>
    <message>
        <source>At rest %1 mm</source>
        <translation>Au repos %1 mm</translation>
    </message>
    <message>
        <source>Towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S), mm</source>
        <translation>Vers la droite (R) ou la gauche (L), l’avant (A) ou l’arrière (P), les pieds (I) ou la tête (S), mm</translation>
    </message>
</context>
<context>
    <name>viscera::app::ProfileChart</name>
    <message>
        <source>Profile along the line</source>
        <translation>Profil le long de la ligne</translation>
    </message>
</context>
<context>
    <name>viscera::app::QuizTool</name>
    <message>
        <source>%1 right, %2 wrong</source>
        <translation>%1 justes, %2 fausses</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Aucune des deux</translation>
    </message>
    <message>
        <source>%1: which valve is open?</source>
        <translation>%1 : quelle valve est ouverte ?</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Non. %1</translation>
    </message>
    <message>
        <source>Click: %1</source>
        <translation>Cliquez&#xa0;: %1</translation>
    </message>
    <message>
        <source>All %1 found without a mistake.</source>
        <translation>Les %1 trouvées sans erreur.</translation>
    </message>
    <message numerus="yes">
        <source>All %1 found, with %n mistakes.</source>
        <translation>
            <numerusform>Les %1 trouvées, avec %n erreur.</numerusform>
            <numerusform>Les %1 trouvées, avec %n erreurs.</numerusform>
        </translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Exact&#xa0;: %1</translation>
    </message>
    <message>
        <source>No, that is nearer to: %1</source>
        <translation>Non, c’est plus proche de&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::RepairValueBox</name>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Life size</source>
        <translation>Taille réelle</translation>
    </message>
    <message>
        <source>The factor by which the organ gets the usual volume of its kind</source>
        <translation>Le facteur qui donne à l’organe le volume habituel de son espèce</translation>
    </message>
    <message>
        <source>About %1 triangles. Details smaller than %2 mm are lost.</source>
        <translation>Environ %1 triangles. Les détails de moins de %2 mm sont perdus.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Repairs</name>
    <message>
        <source>Turn triangles outward</source>
        <translation>Tourner vers l’extérieur</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Boucher les trous</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>Garder le plus grand morceau</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>Remailler</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Inverser gauche et droite</translation>
    </message>
    <message>
        <source>Convert from RAS to LPS</source>
        <translation>Convertir de RAS en LPS</translation>
    </message>
    <message>
        <source>Convert from Y up to LPS</source>
        <translation>Convertir de Y en haut en LPS</translation>
    </message>
    <message>
        <source>Coordinates are in %1</source>
        <translation>Les coordonnées sont en %1</translation>
    </message>
    <message>
        <source>Remove small fragments</source>
        <translation>Supprimer les petits fragments</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Mettre à l’échelle</translation>
    </message>
</context>
<context>
    <name>viscera::app::ReportExport</name>
    <message>
        <source>&amp;Report...</source>
        <translation>&amp;Rapport...</translation>
    </message>
    <message>
        <source>Write pictures, volumes, measurements, stress and motion as PDF or as one HTML page</source>
        <translation>Écrire images, volumes, mesures, contrainte et mouvement en PDF ou en une page HTML</translation>
    </message>
    <message>
        <source>&amp;Copy as commands</source>
        <translation>&amp;Copier comme commandes</translation>
    </message>
    <message>
        <source>Copy the session as a script of viscera commands that gives the same result</source>
        <translation>Copier la session comme script de commandes viscera qui donne le même résultat</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf);;Web pages (*.html)</source>
        <translation>Documents PDF (*.pdf);;Pages web (*.html)</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pages.</source>
        <translation>
            <numerusform>%1&#xa0;: %n page.</numerusform>
            <numerusform>%1&#xa0;: %n pages.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copying as commands</source>
        <translation>Copie comme commandes</translation>
    </message>
    <message numerus="yes">
        <source>%n commands are in the clipboard.</source>
        <translation>
            <numerusform>%n commande est dans le presse-papiers.</numerusform>
            <numerusform>%n commandes sont dans le presse-papiers.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::ResectionBox</name>
    <message>
        <source>Volumes on both sides of the cut</source>
        <translation>Volumes des deux côtés de la coupe</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Coupé</translation>
    </message>
    <message>
        <source>The volumes of the visible, closed organs on both sides of the plane, in this pose</source>
        <translation>Les volumes des organes visibles et fermés des deux côtés du plan, dans cette pose</translation>
    </message>
    <message>
        <source>Cut face %1 cm²</source>
        <translation>Face de coupe %1 cm²</translation>
    </message>
</context>
<context>
    <name>viscera::app::ResidualTable</name>
    <message>
        <source>largest volume</source>
        <translation>plus grand volume</translation>
    </message>
    <message>
        <source>smallest volume</source>
        <translation>plus petit volume</translation>
    </message>
    <message>
        <source>Surface whose fit is shown</source>
        <translation>Surface dont l’ajustement est montré</translation>
    </message>
    <message>
        <source>Measured surface</source>
        <translation>Surface mesurée</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
    <message>
        <source>Fit of the motion, phase by phase</source>
        <translation>Ajustement du mouvement, phase par phase</translation>
    </message>
    <message>
        <source>mean mm</source>
        <translation>moy. mm</translation>
    </message>
    <message>
        <source>95 % mm</source>
        <translation>95 % mm</translation>
    </message>
    <message>
        <source>max mm</source>
        <translation>max mm</translation>
    </message>
    <message>
        <source>measured ml</source>
        <translation>mesuré ml</translation>
    </message>
    <message>
        <source>unconstrained ml</source>
        <translation>libre ml</translation>
    </message>
    <message>
        <source>fitted ml</source>
        <translation>ajusté ml</translation>
    </message>
    <message>
        <source>Dice</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>retournés</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>replié</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>étapes</translation>
    </message>
    <message>
        <source>Time of the phase</source>
        <translation>Temps de la phase</translation>
    </message>
    <message>
        <source>Distance of the fitted surface from the measured surface, weighted by area</source>
        <translation>Distance de la surface ajustée à la surface mesurée, pondérée par l’aire</translation>
    </message>
    <message>
        <source>95 % of the area lies within this distance</source>
        <translation>95 % de l’aire se trouve en deçà de cette distance</translation>
    </message>
    <message>
        <source>The largest distance</source>
        <translation>La plus grande distance</translation>
    </message>
    <message>
        <source>Volume that was measured</source>
        <translation>Volume mesuré</translation>
    </message>
    <message>
        <source>Volume of the fit before it is brought to the measured volume</source>
        <translation>Volume de l’ajustement avant d’être amené au volume mesuré</translation>
    </message>
    <message>
        <source>Volume of the fit</source>
        <translation>Volume de l’ajustement</translation>
    </message>
    <message>
        <source>Triangles that face the wrong way</source>
        <translation>Triangles tournés du mauvais côté</translation>
    </message>
    <message>
        <source>Places in the tissue that are folded</source>
        <translation>Endroits du tissu qui sont repliés</translation>
    </message>
    <message>
        <source>Steps that the fit took</source>
        <translation>Étapes de l’ajustement</translation>
    </message>
    <message>
        <source>Differences from the previous series</source>
        <translation>Ce qui diffère de la série précédente</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>All surfaces</source>
        <translation>Toutes les surfaces</translation>
    </message>
    <message>
        <source>Compared with the previous series</source>
        <translation>Comparé à la série précédente</translation>
    </message>
    <message>
        <source>%1: EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1&#xa0;: FE %2 %, %3 à %4 ml, %5 l/min</translation>
    </message>
    <message>
        <source>tissue %1 to %2 ml</source>
        <translation>tissu %1 à %2 ml</translation>
    </message>
    <message>
        <source>A session does not keep the measured surfaces. To see them, find the motion again: Sequence &gt; Motion from a series</source>
        <translation>Une session ne garde pas les surfaces mesurées. Pour les voir, recalculez le mouvement&#xa0;: Séquence &gt; Mouvement d’une série</translation>
    </message>
    <message>
        <source>Colour the organs by their distance from the measured surfaces of the nearest phase</source>
        <translation>Colorer les organes selon leur distance aux surfaces mesurées de la phase la plus proche</translation>
    </message>
    <message>
        <source>A mark shows that the phase needs attention; the row&apos;s tooltip gives the reason</source>
        <translation>Une marque montre que la phase demande attention&#x202f;; l’infobulle de la ligne en donne la raison</translation>
    </message>
    <message>
        <source>Dice coefficient of the voxels; 1 if all agree</source>
        <translation>Coefficient de Dice des voxels&#x202f;; 1 si tous concordent</translation>
    </message>
    <message>
        <source>Show the measured surfaces of the nearest phase, translucent</source>
        <translation>Montrer les surfaces mesurées de la phase la plus proche, translucides</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>wall ml</source>
        <translation>paroi ml</translation>
    </message>
    <message>
        <source>Whether the phase has labels, or was found in the images</source>
        <translation>Si la phase a des étiquettes ou a été trouvée dans les images</translation>
    </message>
    <message>
        <source>Volume of the wall as a check: muscle hardly changes it. More than 10 % beyond the labelled phases needs attention</source>
        <translation>Volume de la paroi comme contrôle : le muscle n&apos;en change guère. Plus de 10 % au-delà des phases étiquetées demande attention</translation>
    </message>
    <message>
        <source>Estimate from the labels of one phase</source>
        <translation>Estimation à partir des étiquettes d&apos;une phase</translation>
    </message>
    <message>
        <source>%1: about EF %2 %, %3 to %4 ml, %5 l/min</source>
        <translation>%1 : environ FE %2 %, %3 à %4 ml, %5 l/min</translation>
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
        <translation>Une estimation : cette phase n&apos;a pas d&apos;étiquettes, et une seule en a.</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>étiquettes</translation>
    </message>
    <message>
        <source>images</source>
        <translation>images</translation>
    </message>
</context>
<context>
    <name>viscera::app::SampleNames</name>
    <message>
        <source>digestive system</source>
        <translation>système digestif</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>cœur</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>foie</translation>
    </message>
    <message>
        <source>stomach</source>
        <translation>estomac</translation>
    </message>
    <message>
        <source>stomach and bowel</source>
        <translation>estomac et intestin</translation>
    </message>
</context>
<context>
    <name>viscera::app::ScanActions</name>
    <message>
        <source>Soft &amp;tissue</source>
        <translation>&amp;Tissus mous</translation>
    </message>
    <message>
        <source>&amp;Lung</source>
        <translation>&amp;Poumon</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Os</translation>
    </message>
    <message>
        <source>B&amp;rain</source>
        <translation>&amp;Cerveau</translation>
    </message>
    <message>
        <source>Li&amp;ver</source>
        <translation>&amp;Foie</translation>
    </message>
    <message>
        <source>&amp;Angiography</source>
        <translation>&amp;Angiographie</translation>
    </message>
    <message>
        <source>&amp;3D view alone</source>
        <translation>Vue &amp;3D seule</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Quatre vues</translation>
    </message>
    <message>
        <source>&amp;Axial slice</source>
        <translation>Coupe &amp;axiale</translation>
    </message>
    <message>
        <source>&amp;Coronal slice</source>
        <translation>Coupe &amp;coronale</translation>
    </message>
    <message>
        <source>&amp;Sagittal slice</source>
        <translation>Coupe &amp;sagittale</translation>
    </message>
    <message>
        <source>Open a &amp;scan...</source>
        <translation>Ouvrir un &amp;examen...</translation>
    </message>
    <message>
        <source>Open a CT or MR beside the organs</source>
        <translation>Ouvrir un scanner ou une IRM à côté des organes</translation>
    </message>
    <message>
        <source>Open a DICOM &amp;series...</source>
        <translation>Ouvrir une &amp;série DICOM...</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files as a scan</source>
        <translation>Ouvrir un dossier de fichiers DICOM comme examen</translation>
    </message>
    <message>
        <source>C&amp;lose the scan</source>
        <translation>&amp;Fermer l’examen</translation>
    </message>
    <message>
        <source>Close the scan; the organs stay</source>
        <translation>Fermer l’examen&#x202f;; les organes restent</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomatique</translation>
    </message>
    <message>
        <source>Level and width that the scan&apos;s file proposes, or found from its values</source>
        <translation>Niveau et largeur que propose le fichier de l’examen, ou trouvés d’après ses valeurs</translation>
    </message>
    <message>
        <source>Level %1, width %2</source>
        <translation>Niveau %1, largeur %2</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Contours</translation>
    </message>
    <message>
        <source>Draw the organs&apos; contours on the slices</source>
        <translation>Tracer les contours des organes sur les coupes</translation>
    </message>
    <message>
        <source>Contours at &amp;rest</source>
        <translation>Contours au &amp;repos</translation>
    </message>
    <message>
        <source>Draw thin contours of the organs at rest as well</source>
        <translation>Tracer aussi de fins contours des organes au repos</translation>
    </message>
    <message>
        <source>Slices in the &amp;3D view</source>
        <translation>Coupes dans la vue &amp;3D</translation>
    </message>
    <message>
        <source>&amp;Warp the scan</source>
        <translation>&amp;Déformer l’examen</translation>
    </message>
    <message>
        <source>Show the scan as the pose warps it</source>
        <translation>Montrer l’examen tel que la pose le déforme</translation>
    </message>
    <message>
        <source>S&amp;mooth between voxels</source>
        <translation>&amp;Lisser entre les voxels</translation>
    </message>
    <message>
        <source>Ma&amp;ximum of thick slices</source>
        <translation>&amp;Maximum des coupes épaisses</translation>
    </message>
    <message>
        <source>Show the largest value across a thick slice instead of the mean</source>
        <translation>Afficher la plus grande valeur à travers une coupe épaisse au lieu de la moyenne</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>É&amp;paisseur</translation>
    </message>
    <message>
        <source>Slices of %1 mm</source>
        <translation>Coupes de %1 mm</translation>
    </message>
    <message>
        <source>Thin slices</source>
        <translation>Coupes fines</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Ouvrir un dossier de fichiers DICOM</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Ouvrir un examen</translation>
    </message>
    <message>
        <source>Scans (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)</source>
        <translation>Examens (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>The folder has several scans. Which one?</source>
        <translation>Le dossier contient plusieurs examens. Lequel&#x202f;?</translation>
    </message>
    <message numerus="yes">
        <source>%n more: see Scan on the page of Explore.</source>
        <translation>
            <numerusform>%n autre&#xa0;: voir Examen sur la page d’Explorer.</numerusform>
            <numerusform>%n autres&#xa0;: voir Examen sur la page d’Explorer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, all %n slices, resampled to an even grid</source>
        <translation>
            <numerusform>, la %n coupe, rééchantillonnée sur une grille régulière</numerusform>
            <numerusform>, les %n coupes, rééchantillonnées sur une grille régulière</numerusform>
        </translation>
    </message>
    <message>
        <source>, slices %1 to %2 of %3</source>
        <translation>, coupes %1 à %2 sur %3</translation>
    </message>
    <message>
        <source>The slices are not at even distances: at most %1 of %2 are. What shall be read?</source>
        <translation>Les coupes ne sont pas régulièrement espacées&#xa0;: %1 sur %2 au plus le sont. Que faut-il lire&#xa0;?</translation>
    </message>
    <message>
        <source>Read other slices...</source>
        <translation>Lire d’autres coupes...</translation>
    </message>
    <message numerus="yes">
        <source>  %n phases</source>
        <translation>
            <numerusform>  %n phase</numerusform>
            <numerusform>  %n phases</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::SequenceList</name>
    <message>
        <source>%1: can be fitted to %2</source>
        <translation>%1&#xa0;: peut être ajustée à %2</translation>
    </message>
    <message>
        <source>%1: shows the sample organ and plays</source>
        <translation>%1&#xa0;: montre l’organe type et lit la séquence</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionFiles</name>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Nouvelle session</translation>
    </message>
    <message>
        <source>Start with an empty session</source>
        <translation>Commencer avec une session vide</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Enregistrer la session</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous...</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Enregistrer la session dans un autre fichier</translation>
    </message>
    <message>
        <source>&amp;Recover unsaved work</source>
        <translation>&amp;Récupérer le travail non enregistré</translation>
    </message>
    <message>
        <source>Open the copy that Viscera kept when it ended without saving</source>
        <translation>Ouvrir la copie que Viscera a gardée quand il s’est terminé sans enregistrer</translation>
    </message>
    <message>
        <source>Viscera</source>
        <translation>Viscera</translation>
    </message>
    <message>
        <source>Untitled session</source>
        <translation>Session sans titre</translation>
    </message>
    <message>
        <source>Session that names its organs&apos; files</source>
        <translation>Session qui renvoie aux fichiers de ses organes</translation>
    </message>
    <message>
        <source>Session with all surfaces and the scan inside</source>
        <translation>Session avec toutes les surfaces et l’examen</translation>
    </message>
    <message>
        <source>session</source>
        <translation>session</translation>
    </message>
    <message>
        <source>Save the session as</source>
        <translation>Enregistrer la session sous</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Enregistré dans %1</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>Enregistrer les modifications&#x202f;?</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Enregistrer les modifications de %1&#x202f;?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>A&amp;bandonner</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Et %n autre.</numerusform>
            <numerusform>Et %n autres.</numerusform>
        </translation>
    </message>
    <message>
        <source>Viscera ended without saving. It has kept a copy of the work of %1.</source>
        <translation>Viscera s’est terminé sans enregistrer. Il a gardé une copie du travail du %1.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Choose the folder with the missing files</source>
        <translation>Choisir le dossier des fichiers manquants</translation>
    </message>
    <message>
        <source>Save this session?</source>
        <translation>Enregistrer cette session&#xa0;?</translation>
    </message>
    <message>
        <source>If you discard them, the changes since the last saving are lost.</source>
        <translation>Si vous ne les gardez pas, les modifications depuis le dernier enregistrement sont perdues.</translation>
    </message>
    <message>
        <source>Fetch it from %1</source>
        <translation>Récupérer depuis %1</translation>
    </message>
</context>
<context>
    <name>viscera::app::SessionView</name>
    <message>
        <source>Preparing the motion</source>
        <translation>Préparation du mouvement</translation>
    </message>
    <message>
        <source>it has other handles</source>
        <translation>elle a d’autres poignées</translation>
    </message>
    <message>
        <source>This version moves the organ differently from the one that saved the session: %1.</source>
        <translation>Cette version déplace l’organe autrement que celle qui a enregistré la session : %1.</translation>
    </message>
    <message>
        <source>handles differ by up to %1 mm</source>
        <translation>les poignées diffèrent de %1 mm au plus</translation>
    </message>
</context>
<context>
    <name>viscera::app::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Lengths are in mm, volumes in ml, everywhere; numbers have the decimal mark of the language.</source>
        <translation>Les longueurs sont partout en mm, les volumes en ml&#xa0;; les nombres ont le séparateur décimal de la langue.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>The next start uses the language.</source>
        <translation>Le prochain démarrage utilise la langue.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Show the welcome</source>
        <translation>Afficher l’accueil</translation>
    </message>
    <message>
        <source>Folders that dialogs begin in</source>
        <translation>Dossiers où commencent les dialogues</translation>
    </message>
    <message>
        <source>Organs and sessions</source>
        <translation>Organes et sessions</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Movies</source>
        <translation>Films</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Choisir...</translation>
    </message>
</context>
<context>
    <name>viscera::app::ShortcutCard</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Souris et touches</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Glisser à gauche</translation>
    </message>
    <message>
        <source>Rotate, or move a handle</source>
        <translation>Tourner, ou déplacer une poignée</translation>
    </message>
    <message>
        <source>Middle, Shift+left drag</source>
        <translation>Milieu, Maj+glisser à gauche</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Translater</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Glisser à droite, molette</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomer</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Select, or add a handle</source>
        <translation>Sélectionner, ou ajouter une poignée</translation>
    </message>
    <message>
        <source>Shift or Ctrl+click</source>
        <translation>Maj ou Ctrl+clic</translation>
    </message>
    <message>
        <source>Add to the selection</source>
        <translation>Ajouter à la sélection</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Cancel a drag, close a message</source>
        <translation>Annuler un glissement, fermer un message</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlicePanes</name>
    <message>
        <source>The scan cannot be warped: %1</source>
        <translation>L’examen ne peut pas être déformé&#xa0;: %1</translation>
    </message>
    <message>
        <source>folded by the pose: estimated</source>
        <translation>replié par la pose&#xa0;: estimé</translation>
    </message>
</context>
<context>
    <name>viscera::app::SlidePanel</name>
    <message>
        <source>Keep views as slides, then show them with F5 and Page Down. The session keeps them.</source>
        <translation>Gardez des vues comme diapositives, puis montrez-les avec F5 et Page suiv. La session les conserve.</translation>
    </message>
</context>
<context>
    <name>viscera::app::Slides</name>
    <message>
        <source>&amp;Keep this view as a slide</source>
        <translation>&amp;Garder cette vue comme diapositive</translation>
    </message>
    <message>
        <source>&amp;Remove the slide</source>
        <translation>Supprimer la &amp;diapositive</translation>
    </message>
    <message>
        <source>Remove the slide that was shown last</source>
        <translation>Supprimer la dernière diapositive montrée</translation>
    </message>
    <message>
        <source>&amp;Next slide</source>
        <translation>Diapositive &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;Previous slide</source>
        <translation>Diapositive &amp;précédente</translation>
    </message>
    <message>
        <source>Slide %1</source>
        <translation>Diapositive %1</translation>
    </message>
    <message>
        <source>Keep the present view with its cut, names and hidden organs, and the instant of a paused sequence</source>
        <translation>Garder la vue actuelle avec sa section, ses noms et ses organes masqués, et l’instant d’une séquence en pause</translation>
    </message>
    <message>
        <source>&amp;Back from the slides</source>
        <translation>&amp;Revenir des diapositives</translation>
    </message>
    <message>
        <source>Show, cut and name the organs as before the slides</source>
        <translation>Montrer, sectionner et nommer les organes comme avant les diapositives</translation>
    </message>
</context>
<context>
    <name>viscera::app::StatusLine</name>
    <message>
        <source>Cancel this task</source>
        <translation>Annuler cette tâche</translation>
    </message>
    <message>
        <source>No organ</source>
        <translation>Aucun organe</translation>
    </message>
    <message>
        <source>%1: open surface, no volume</source>
        <translation>%1&#xa0;: surface ouverte, pas de volume</translation>
    </message>
    <message>
        <source>  locked</source>
        <translation>  verrouillé</translation>
    </message>
    <message>
        <source>no handles</source>
        <translation>aucune poignée</translation>
    </message>
    <message>
        <source>, binding...</source>
        <translation>, liaison...</translation>
    </message>
    <message>
        <source>, binding cancelled</source>
        <translation>, liaison annulée</translation>
    </message>
    <message>
        <source>, bound in %1 ms</source>
        <translation>, lié en %1 ms</translation>
    </message>
    <message>
        <source>%1, %2 of tissue folded by the pose</source>
        <translation>%1, %2 de tissu repliés par la pose</translation>
    </message>
    <message numerus="yes">
        <source>%n organs</source>
        <translation>
            <numerusform>%n organe</numerusform>
            <numerusform>%n organes</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 not bound</source>
        <translation>, %1 non lié</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainModel</name>
    <message>
        <source>Choose a motion, or drag a handle: strain is the change of the heart&apos;s wall.</source>
        <translation>Choisissez un mouvement ou tirez une poignée&#xa0;: la déformation est le changement de la paroi du cœur.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StrainPanel</name>
    <message>
        <source>From the fullest phase</source>
        <translation>Depuis la phase la plus remplie</translation>
    </message>
    <message>
        <source>From phase %1</source>
        <translation>Depuis la phase %1</translation>
    </message>
    <message>
        <source>Times to the peak differ by %1 ms along and %2 ms around</source>
        <translation>Les temps jusqu’au pic diffèrent de %1 ms dans la longueur et de %2 ms sur le pourtour</translation>
    </message>
    <message>
        <source>The bull&apos;s eye shows the present pose against rest.</source>
        <translation>Le bull’s eye montre la pose actuelle par rapport au repos.</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressChart</name>
    <message>
        <source>maximum</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>The stress over one cycle of the sequence is drawn here as soon as it is computed.</source>
        <translation>La contrainte sur un cycle de la séquence est tracée ici dès qu’elle est calculée.</translation>
    </message>
    <message>
        <source>chosen point</source>
        <translation>point choisi</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressExport</name>
    <message>
        <source>Export stress &amp;map...</source>
        <translation>Exporter la &amp;carte de contrainte...</translation>
    </message>
    <message>
        <source>Write all quantities at all points inside the organ, for ParaView</source>
        <translation>Écrire toutes les grandeurs en tous les points de l’organe, pour ParaView</translation>
    </message>
    <message>
        <source>Export stress map</source>
        <translation>Exporter la carte de contrainte</translation>
    </message>
    <message>
        <source>VTK solids (*.vtu)</source>
        <translation>Solides VTK (*.vtu)</translation>
    </message>
    <message>
        <source>Export stress at the &amp;points...</source>
        <translation>Exporter la contrainte aux &amp;points...</translation>
    </message>
    <message>
        <source>Write the values at the witness points as a table</source>
        <translation>Écrire les valeurs aux points témoins sous forme de tableau</translation>
    </message>
    <message>
        <source>Export stress at the points</source>
        <translation>Exporter la contrainte aux points</translation>
    </message>
    <message>
        <source>Export &amp;histogram...</source>
        <translation>Exporter l’&amp;histogramme...</translation>
    </message>
    <message>
        <source>Write the distribution of the shown quantity over the witness points</source>
        <translation>Écrire la distribution de la grandeur affichée sur les points témoins</translation>
    </message>
    <message>
        <source>Export histogram</source>
        <translation>Exporter l’histogramme</translation>
    </message>
    <message>
        <source>Export &amp;curve over the sequence...</source>
        <translation>Exporter la co&amp;urbe sur la séquence...</translation>
    </message>
    <message>
        <source>Write the rotational stress over one whole cycle of the sequence</source>
        <translation>Écrire la contrainte rotationnelle sur un cycle entier de la séquence</translation>
    </message>
    <message>
        <source>Export curve</source>
        <translation>Exporter la courbe</translation>
    </message>
    <message>
        <source>the stress map</source>
        <translation>la carte de contrainte</translation>
    </message>
    <message>
        <source>the stress</source>
        <translation>la contrainte</translation>
    </message>
    <message>
        <source>the histogram</source>
        <translation>l’histogramme</translation>
    </message>
    <message>
        <source>the curve</source>
        <translation>la courbe</translation>
    </message>
    <message>
        <source>Export pro&amp;bes...</source>
        <translation>Exporter les &amp;sondes...</translation>
    </message>
    <message>
        <source>Write place and values of the pinned probes as a table</source>
        <translation>Écrire le lieu et les valeurs des sondes fixées dans un tableau</translation>
    </message>
    <message>
        <source>Export probes</source>
        <translation>Exporter les sondes</translation>
    </message>
    <message>
        <source>Export prof&amp;iles...</source>
        <translation>Exporter les profi&amp;ls...</translation>
    </message>
    <message>
        <source>Write the values along the lines between probes as a table</source>
        <translation>Écrire les valeurs le long des lignes entre sondes dans un tableau</translation>
    </message>
    <message>
        <source>Export profiles</source>
        <translation>Exporter les profils</translation>
    </message>
    <message>
        <source>the probes</source>
        <translation>les sondes</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>les profils</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressMode</name>
    <message>
        <source>How much the pose distorts the tissue (rotational stress): click the organ to read the values of a point; C cuts it open; the map follows while you drag a handle</source>
        <translation>Distorsion du tissu due à la pose (contrainte rotationnelle)&#xa0;: cliquez sur l’organe pour lire les valeurs d’un point&#x202f;; C l’ouvre&#x202f;; la carte suit pendant que vous faites glisser une poignée</translation>
    </message>
    <message>
        <source>&amp;Next map</source>
        <translation>Carte &amp;suivante</translation>
    </message>
    <message>
        <source>The next stress map</source>
        <translation>La carte de contrainte suivante</translation>
    </message>
    <message>
        <source>&amp;Go to the maximum</source>
        <translation>Aller au &amp;maximum</translation>
    </message>
    <message>
        <source>Show the values where the map is largest, and cut the organ open there</source>
        <translation>Montrer les valeurs là où la carte est maximale, et y ouvrir l’organe</translation>
    </message>
    <message>
        <source>&amp;Maximum over the sequence</source>
        <translation>Ma&amp;ximum sur la séquence</translation>
    </message>
    <message>
        <source>The most extreme value that each point reaches in one cycle of the sequence</source>
        <translation>La valeur la plus extrême que chaque point atteint en un cycle de la séquence</translation>
    </message>
    <message>
        <source>Map on the organ&apos;s &amp;surface</source>
        <translation>Carte sur la s&amp;urface de l’organe</translation>
    </message>
    <message>
        <source>Draw the map on the organ&apos;s surface instead of the outer tetrahedra</source>
        <translation>Tracer la carte sur la surface de l’organe au lieu des tétraèdres externes</translation>
    </message>
    <message>
        <source>&amp;Keep the legend&apos;s range</source>
        <translation>&amp;Garder l’échelle de la légende</translation>
    </message>
    <message>
        <source>Keep the range of colours, so that poses can be compared</source>
        <translation>Garder l’intervalle des couleurs, pour comparer des poses</translation>
    </message>
    <message>
        <source>&amp;Cut open</source>
        <translation>&amp;Ouvrir par une section</translation>
    </message>
    <message>
        <source>Cut the organ open by a plane</source>
        <translation>Ouvrir l’organe par un plan</translation>
    </message>
    <message>
        <source>&amp;Only beyond a limit</source>
        <translation>Seulement au-delà d’une &amp;limite</translation>
    </message>
    <message>
        <source>Show only tissue above or below a limit</source>
        <translation>N’afficher que le tissu au-dessus ou au-dessous d’une limite</translation>
    </message>
    <message>
        <source>&amp;Glyphs of the stretch</source>
        <translation>Gl&amp;yphes de l’étirement</translation>
    </message>
    <message>
        <source>No glyphs, ellipsoids or crosses</source>
        <translation>Aucun glyphe, ellipsoïdes ou croix</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Poignées</translation>
    </message>
    <message>
        <source>Show the handles, so that they can be dragged</source>
        <translation>Afficher les poignées, pour les faire glisser</translation>
    </message>
    <message>
        <source>O&amp;ther organs</source>
        <translation>&amp;Autres organes</translation>
    </message>
    <message>
        <source>Show the other organs as well</source>
        <translation>Afficher aussi les autres organes</translation>
    </message>
    <message>
        <source>P&amp;in the probe</source>
        <translation>&amp;Fixer la sonde</translation>
    </message>
    <message>
        <source>Keep the point that was clicked: its place and value follow the pose in the table</source>
        <translation>Garder le point choisi&#xa0;: son lieu et sa valeur suivent la pose dans le tableau</translation>
    </message>
    <message>
        <source>&amp;Logarithmic range</source>
        <translation>É&amp;chelle logarithmique</translation>
    </message>
    <message>
        <source>Same range in both &amp;views</source>
        <translation>Même échelle dans les &amp;deux vues</translation>
    </message>
    <message>
        <source>Beside another view: one range of colours for both stress maps, so that they can be compared</source>
        <translation>À côté d’une autre vue&#xa0;: une seule échelle de couleurs pour les deux cartes de contrainte, pour les comparer</translation>
    </message>
    <message>
        <source>Go to the &amp;time of the maximum</source>
        <translation>Alle&amp;r au moment du maximum</translation>
    </message>
    <message>
        <source>Show the sequence at the instant at which the rotational stress is largest</source>
        <translation>Montrer la séquence à l’instant où la contrainte rotationnelle est la plus grande</translation>
    </message>
    <message>
        <source>Use a logarithmic colour scale, which separates small values</source>
        <translation>Utiliser une échelle de couleurs logarithmique, qui distingue les petites valeurs</translation>
    </message>
</context>
<context>
    <name>viscera::app::StressModel</name>
    <message>
        <source>This point is probe %1 already.</source>
        <translation>Ce point est déjà la sonde %1.</translation>
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
        <translation>TetGen, surface réparée</translation>
    </message>
    <message>
        <source>regular grid</source>
        <translation>grille régulière</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>What the colours mean (M: next map). Rotational stress is the largest angle by which a direction is turned when the tissue is stretched; it is not a pressure.</source>
        <translation>Ce que signifient les couleurs (M&#xa0;: carte suivante). La contrainte rotationnelle est le plus grand angle dont une direction tourne quand le tissu est étiré&#x202f;; ce n’est pas une pression.</translation>
    </message>
    <message>
        <source>Your pose</source>
        <translation>Votre pose</translation>
    </message>
    <message>
        <source>The map of your pose; handles can be dragged</source>
        <translation>La carte de votre pose&#x202f;; les poignées peuvent être déplacées</translation>
    </message>
    <message>
        <source>The map of the sequence at the timeline&apos;s instant; Space plays</source>
        <translation>La carte de la séquence à l’instant de la barre de temps&#x202f;; Espace lit</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Smooth: through the tetrahedra</source>
        <translation>Lisse&#xa0;: à travers les tétraèdres</translation>
    </message>
    <message>
        <source>Crinkle: whole tetrahedra</source>
        <translation>Crénelée&#xa0;: tétraèdres entiers</translation>
    </message>
    <message>
        <source>Distance of the cut from the organ&apos;s middle; the arrow in the view moves it, the rim tilts it</source>
        <translation>Distance de la section au milieu de l’organe&#x202f;; la flèche dans la vue la déplace, le bord l’incline</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Glyphs</source>
        <translation>Glyphes</translation>
    </message>
    <message>
        <source>No glyphs</source>
        <translation>Aucun glyphe</translation>
    </message>
    <message>
        <source>Ellipsoids of the stretch</source>
        <translation>Ellipsoïdes de l’étirement</translation>
    </message>
    <message>
        <source>Crosses of the stretch</source>
        <translation>Croix de l’étirement</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>Cut away the right side</source>
        <translation>Retirer le côté droit</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Cut through the middle, across the line of sight</source>
        <translation>Couper par le milieu, perpendiculairement au regard</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Number of witness points</source>
        <translation>Nombre de points témoins</translation>
    </message>
    <message>
        <source>More points show finer detail and take longer; up to 20,000 the map follows a drag</source>
        <translation>Plus de points montrent des détails plus fins et prennent plus de temps&#x202f;; jusqu’à 20&#x202f;000, la carte suit un glissement</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Open an organ to see where it is distorted.</source>
        <translation>Ouvrez un organe pour voir où il est distordu.</translation>
    </message>
    <message>
        <source>Filling the organ with witness points...</source>
        <translation>Remplissage de l’organe de points témoins...</translation>
    </message>
    <message>
        <source>Binding the witness points to the handles...</source>
        <translation>Liaison des points témoins aux poignées...</translation>
    </message>
    <message>
        <source>Cancelled. Press Try again to go on.</source>
        <translation>Annulé. Cliquez sur Réessayer pour continuer.</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>forme close</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>différences</translation>
    </message>
    <message numerus="yes">
        <source>%n points lie outside the handles&apos; hull and stay where they are.</source>
        <translation>
            <numerusform>%n point est hors de l’enveloppe des poignées et reste où il est.</numerusform>
            <numerusform>%n points sont hors de l’enveloppe des poignées et restent où ils sont.</numerusform>
        </translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sondes</translation>
    </message>
    <message>
        <source>Time of the maximum</source>
        <translation>Moment du maximum</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Colours from the lowest value to the highest; maps of angles and maps of ratios each keep their own choice</source>
        <translation>Couleurs de la valeur la plus basse à la plus haute&#x202f;; les cartes d’angles et les cartes de rapports gardent chacune leur propre choix</translation>
    </message>
    <message>
        <source>Witness points at which the tissue is turned inside out; in magenta, except on the map of folded tissue</source>
        <translation>Points témoins où le tissu est retourné&#x202f;; en magenta, sauf sur la carte du tissu replié</translation>
    </message>
    <message>
        <source>Cut and glyphs</source>
        <translation>Section et glyphes</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Above the limit</source>
        <translation>Au-dessus de la limite</translation>
    </message>
    <message>
        <source>Below the limit</source>
        <translation>Au-dessous de la limite</translation>
    </message>
    <message>
        <source>Glyphs of the stretch at about 300 points: the shape that a small sphere of tissue takes</source>
        <translation>Glyphes de l’étirement en 300 points environ&#xa0;: la forme que prend une petite sphère de tissu</translation>
    </message>
    <message>
        <source>No handle is near %1: the nearest is %2 mm away. Place handles around it in Handles (2).</source>
        <translation>Aucune poignée n’est proche de %1 : la plus proche est à %2 mm. Placez des poignées autour dans Poignées (2).</translation>
    </message>
    <message>
        <source>Nothing is deformed: drag a handle, or play a sequence (Space).</source>
        <translation>Rien n’est déformé : tirez une poignée, ou lancez une séquence (Espace).</translation>
    </message>
    <message>
        <source>Choose a material</source>
        <translation>Choisir un matériau</translation>
    </message>
    <message>
        <source>Another material</source>
        <translation>Autre matériau</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>The tissue whose stiffness makes pascals of the deformation; it does not change the pose</source>
        <translation>Le tissu dont la rigidité fait des pascals de la déformation ; il ne change pas la pose</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module d&apos;Young</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Coefficient de Poisson</translation>
    </message>
    <message>
        <source>Pascals exist only of a stated material. Choose a material first.</source>
        <translation>Il n&apos;y a de pascals que pour un matériau indiqué. Choisissez d&apos;abord un matériau.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus %1 kPa, doi:%2</source>
        <translation>Module d&apos;Young %1 kPa, doi:%2</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemBox</name>
    <message>
        <source>Coordinate system that binds the organs to the handles</source>
        <translation>Système de coordonnées qui lie les organes aux poignées</translation>
    </message>
    <message>
        <source>no cage</source>
        <translation>sans cage</translation>
    </message>
    <message>
        <source>Handles may stand anywhere around the organ</source>
        <translation>Les poignées peuvent être n’importe où autour de l’organe</translation>
    </message>
    <message>
        <source>cage</source>
        <translation>cage</translation>
    </message>
    <message>
        <source>Works with a closed surface over the handles: their convex hull, or a cage that was loaded</source>
        <translation>Fonctionne avec une surface fermée sur les poignées&#xa0;: leur enveloppe convexe, ou une cage chargée</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positif</translation>
    </message>
    <message>
        <source>interpolating</source>
        <translation>interpolant</translation>
    </message>
    <message>
        <source>A point at a handle follows it exactly</source>
        <translation>Un point situé à une poignée la suit exactement</translation>
    </message>
    <message>
        <source>exact gradient</source>
        <translation>gradient exact</translation>
    </message>
    <message>
        <source>Stress is computed without differences</source>
        <translation>La contrainte est calculée sans différences</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>lacunes</translation>
    </message>
    <message>
        <source>Some points inside the hull have no coordinates and do not move</source>
        <translation>Certains points de l’enveloppe n’ont pas de coordonnées et ne bougent pas</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>sauts</translation>
    </message>
    <message>
        <source>Neighbouring points may move very differently</source>
        <translation>Des points voisins peuvent bouger très différemment</translation>
    </message>
    <message>
        <source>kinks</source>
        <translation>plis</translation>
    </message>
    <message>
        <source>The deformed organ may show creases</source>
        <translation>L’organe déformé peut montrer des arêtes</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>groupes</translation>
    </message>
    <message>
        <source>Handles act by their groups</source>
        <translation>Les poignées agissent par leurs groupes</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tétraèdres</translation>
    </message>
    <message>
        <source>Fills the organ with tetrahedra first</source>
        <translation>Remplit d’abord l’organe de tétraèdres</translation>
    </message>
    <message>
        <source>The value is set to %1 %2, but these handles allow at most %3, so %3 is used.</source>
        <translation>La valeur est réglée à %1 %2, mais ces poignées permettent au plus %3&#x202f;; c’est donc %3 qui est utilisé.</translation>
    </message>
    <message>
        <source>These handles allow up to %1.</source>
        <translation>Ces poignées permettent jusqu’à %1.</translation>
    </message>
    <message>
        <source>No coordinate is negative: the organ follows the direction of every handle</source>
        <translation>Aucune coordonnée n’est négative&#xa0;: l’organe suit la direction de chaque poignée</translation>
    </message>
</context>
<context>
    <name>viscera::app::SystemCombo</name>
    <message>
        <source>Recommended</source>
        <translation>Recommandés</translation>
    </message>
    <message>
        <source>With a cage</source>
        <translation>Avec une cage</translation>
    </message>
    <message>
        <source>With tetrahedra</source>
        <translation>Avec des tétraèdres</translation>
    </message>
    <message>
        <source>Attempts of the thesis</source>
        <translation>Essais de la thèse</translation>
    </message>
</context>
<context>
    <name>viscera::app::TaskCard</name>
    <message>
        <source>Drag the bright dot: the organ follows.</source>
        <translation>Tirez le point clair&#xa0;: l’organe suit.</translation>
    </message>
    <message>
        <source>Done. Ctrl+Z takes it back. F1 opens the guide at what you are doing.</source>
        <translation>C’est fait. Ctrl+Z l’annule. F1 ouvre le guide là où vous en êtes.</translation>
    </message>
</context>
<context>
    <name>viscera::app::TimelineBar</name>
    <message>
        <source>To the start of the cycle (Home)</source>
        <translation>Au début du cycle (Origine)</translation>
    </message>
    <message>
        <source>One frame back (,)</source>
        <translation>Une image en arrière (,)</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Lire ou mettre en pause (Espace)</translation>
    </message>
    <message>
        <source>One frame forward (.)</source>
        <translation>Une image en avant (.)</translation>
    </message>
    <message>
        <source>Repeat the cycle (L)</source>
        <translation>Répéter le cycle (L)</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Répéter</translation>
    </message>
    <message>
        <source>Repeat the cycle</source>
        <translation>Répéter le cycle</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou mettre en pause</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Au &amp;début</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Une image en a&amp;rrière</translation>
    </message>
    <message>
        <source>One frame &amp;forward</source>
        <translation>Une image en &amp;avant</translation>
    </message>
    <message>
        <source>A fine step bac&amp;k</source>
        <translation>Un pas fin en arr&amp;ière</translation>
    </message>
    <message>
        <source>Go back by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Reculer de dix millisecondes dans un battement, d’une image dans les autres séquences</translation>
    </message>
    <message>
        <source>A fine step for&amp;ward</source>
        <translation>Un pas fin en a&amp;vant</translation>
    </message>
    <message>
        <source>Go forward by ten milliseconds in a heartbeat, by one frame in other sequences</source>
        <translation>Avancer de dix millisecondes dans un battement, d’une image dans les autres séquences</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Slow motion: how fast time passes (S)</source>
        <translation>Ralenti&#xa0;: vitesse à laquelle passe le temps (S)</translation>
    </message>
    <message>
        <source>%1: %2 %3. The heart rate of the circulation sets it.</source>
        <translation>%1&#xa0;: %2 %3. La fréquence cardiaque de la circulation la fixe.</translation>
    </message>
    <message>
        <source>%1: %2 to %3 %4</source>
        <translation>%1&#xa0;: %2 à %3 %4</translation>
    </message>
    <message>
        <source>No motion yet: choose a sequence in Play (5)</source>
        <translation>Pas encore de mouvement&#xa0;: choisissez une séquence dans Lire (5)</translation>
    </message>
    <message>
        <source>%1 s into the cycle</source>
        <translation>à %1 s du cycle</translation>
    </message>
    <message>
        <source>The images of the cine study: there is no motion yet</source>
        <translation>Les images de l&apos;étude ciné : il n&apos;y a pas encore de mouvement</translation>
    </message>
    <message>
        <source>The phases of the scan: there is no motion yet</source>
        <translation>Les phases de l&apos;examen : il n&apos;y a pas encore de mouvement</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Examen</translation>
    </message>
</context>
<context>
    <name>viscera::app::TourCard</name>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>viscera::app::Value</name>
    <message>
        <source>No password was given.</source>
        <translation>Aucun mot de passe n&apos;a été donné.</translation>
    </message>
</context>
<context>
    <name>viscera::app::ViewActions</name>
    <message>
        <source>Save s&amp;creenshot</source>
        <translation>Enregistrer une &amp;capture</translation>
    </message>
    <message>
        <source>Save a picture of the 3D view</source>
        <translation>Enregistrer une image de la vue 3D</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Cadrer</translation>
    </message>
    <message>
        <source>Bring the selected organ, or all, into the picture</source>
        <translation>Cadrer l’organe sélectionné, ou tous</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Antérieure</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>&amp;Postérieure</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Supérieure</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>&amp;Inférieure</translation>
    </message>
    <message>
        <source>Show &amp;handles in every mode</source>
        <translation>Afficher les &amp;poignées dans chaque mode</translation>
    </message>
    <message>
        <source>&amp;Ghost of the rest shape</source>
        <translation>&amp;Fantôme de la forme au repos</translation>
    </message>
    <message>
        <source>Cut &amp;open</source>
        <translation>&amp;Ouvrir par une section</translation>
    </message>
    <message>
        <source>Cut all organs open by a plane; their cavities are hollow then</source>
        <translation>Ouvrir tous les organes par un plan&#x202f;; leurs cavités sont alors creuses</translation>
    </message>
    <message>
        <source>Orientation &amp;cube</source>
        <translation>C&amp;ube d’orientation</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>&amp;Barre d’échelle</translation>
    </message>
    <message>
        <source>Sha&amp;de in folds</source>
        <translation>Om&amp;brer les plis</translation>
    </message>
    <message>
        <source>Darken the folds of organs and soften the light; takes time on a computer without a graphics processor</source>
        <translation>Assombrir les plis des organes et adoucir la lumière&#x202f;; lent sur un ordinateur sans processeur graphique</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>Image enregistrée dans %1</translation>
    </message>
    <message>
        <source>%1 is hidden behind %2.</source>
        <translation>%1 est caché derrière %2.</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Afficher seulement ceci</translation>
    </message>
    <message>
        <source>&amp;Edges of triangles</source>
        <translation>&amp;Arêtes des triangles</translation>
    </message>
    <message>
        <source>Draw the triangles of organs as lines</source>
        <translation>Tracer les triangles des organes sous forme de lignes</translation>
    </message>
    <message>
        <source>&amp;Flat triangles</source>
        <translation>Triangles &amp;plats</translation>
    </message>
    <message>
        <source>Give each triangle of an organ one shade, in place of a smooth surface</source>
        <translation>Donner à chaque triangle d’un organe une seule teinte, au lieu d’une surface lisse</translation>
    </message>
    <message>
        <source>Co&amp;nduction system</source>
        <translation>Système de co&amp;nduction</translation>
    </message>
    <message>
        <source>In the sample heart: sinus node, atrioventricular node, bundles and branches, lit where the excitation of the beat is; names of parts name them</source>
        <translation>Dans le cœur d&apos;exemple : nœud sinusal, nœud atrio-ventriculaire, faisceaux et branches, éclairés là où se trouve l&apos;excitation du battement ; les noms des parties les nomment</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeBox</name>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Target volume</source>
        <translation>Volume cible</translation>
    </message>
    <message>
        <source>Give the organ this volume with the smallest motion of the compensating handles, or of all free ones</source>
        <translation>Donner ce volume à l’organe par le plus petit mouvement des poignées qui compensent, ou de toutes les libres</translation>
    </message>
    <message>
        <source>%1 now has the target volume; its lock keeps this volume from now on.</source>
        <translation>%1 a maintenant le volume cible&#x202f;; désormais son verrou garde ce volume.</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumeMonitor</name>
    <message>
        <source>Volumes over the cycle</source>
        <translation>Volumes sur le cycle</translation>
    </message>
</context>
<context>
    <name>viscera::app::VolumePanel</name>
    <message>
        <source>normal at the end of diastole</source>
        <translation>normale en fin de diastole</translation>
    </message>
    <message>
        <source>normal at the end of systole</source>
        <translation>normale en fin de systole</translation>
    </message>
    <message>
        <source>normal %1</source>
        <translation>normale&#xa0;: %1</translation>
    </message>
    <message>
        <source>Volumes over time are drawn here while a sequence plays (Space) or handles are dragged (3).</source>
        <translation>Les volumes au cours du temps sont tracés ici pendant la lecture d’une séquence (Espace) ou le glissement de poignées (3).</translation>
    </message>
    <message>
        <source>%1 (right axis)</source>
        <translation>%1 (axe droit)</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 mesuré</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 avant</translation>
    </message>
    <message>
        <source>%1 prescribed</source>
        <translation>%1 imposé</translation>
    </message>
    <message>
        <source>Closed organs show their volume here.</source>
        <translation>Les organes fermés montrent ici leur volume.</translation>
    </message>
    <message>
        <source>%1: show its normal range in the chart</source>
        <translation>%1&#xa0;: montrer dans le graphique ce qui est normal pour lui</translation>
    </message>
    <message>
        <source>Shaded: normal for %1, %2. %3</source>
        <translation>Ombré&#xa0;: normale pour %1, %2. %3</translation>
    </message>
    <message>
        <source>EF %1 %  SV %2 ml</source>
        <translation>FE %1 %  VES %2 ml</translation>
    </message>
    <message>
        <source>%1 % of rest</source>
        <translation>%1 % du repos</translation>
    </message>
    <message>
        <source>Part of the cycle</source>
        <translation>Fraction du cycle</translation>
    </message>
    <message>
        <source>Time while dragging</source>
        <translation>Temps de glissement</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Graphique</translation>
    </message>
    <message numerus="yes">
        <source>%n more organs are not drawn: choose one to see its volume.</source>
        <translation>
            <numerusform>%n autre organe n’est pas dessiné : choisissez-le pour voir son volume.</numerusform>
            <numerusform>%n autres organes ne sont pas dessinés : choisissez-en un pour voir son volume.</numerusform>
        </translation>
    </message>
    <message>
        <source>Fit of the motion</source>
        <translation>Ajustement du mouvement</translation>
    </message>
    <message>
        <source>EF about %1 %  SV about %2 ml (estimate)</source>
        <translation>FE environ %1 %  VES environ %2 ml (estimation)</translation>
    </message>
</context>
<context>
    <name>viscera::app::WarpExport</name>
    <message>
        <source>Export the &amp;warped scan...</source>
        <translation>Exporter l’&amp;examen déformé...</translation>
    </message>
    <message>
        <source>Write the scan as the pose warps it, with a label map of the posed organs</source>
        <translation>Écrire l’examen tel que la pose le déforme, avec une carte d’étiquettes des organes dans cette pose</translation>
    </message>
    <message>
        <source>Export the warped scan</source>
        <translation>Exporter l’examen déformé</translation>
    </message>
    <message>
        <source>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</source>
        <translation>NIfTI (*.nii.gz *.nii);;NRRD (*.nrrd)</translation>
    </message>
    <message>
        <source>Exporting the warped scan</source>
        <translation>Exportation de l’examen déformé</translation>
    </message>
    <message>
        <source>The warped scan was written to %1.</source>
        <translation>L’examen déformé a été écrit dans %1.</translation>
    </message>
    <message>
        <source>Its labels are beside it: %1.</source>
        <translation>Ses étiquettes sont à côté&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The pose folds the tissue at %n voxels: their values are estimates.</source>
        <translation>
            <numerusform>La pose replie le tissu dans %n voxel&#xa0;: sa valeur est une estimation.</numerusform>
            <numerusform>La pose replie le tissu dans %n voxels&#xa0;: leurs valeurs sont des estimations.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>viscera::app::WelcomeCard</name>
    <message>
        <source>Welcome</source>
        <translation>Bienvenue</translation>
    </message>
    <message>
        <source>Open a patient...</source>
        <translation>Ouvrir un patient...</translation>
    </message>
    <message>
        <source>Choose organ surfaces of a patient (Ctrl+O)</source>
        <translation>Choisir les surfaces d’organes d’un patient (Ctrl+O)</translation>
    </message>
    <message>
        <source>Sample organs</source>
        <translation>Organes types</translation>
    </message>
    <message>
        <source>Organs that come with the program</source>
        <translation>Organes fournis avec le programme</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Visite en deux minutes</translation>
    </message>
    <message>
        <source>The parts of the window, step by step</source>
        <translation>Les parties de la fenêtre, étape par étape</translation>
    </message>
    <message>
        <source>Close this card (Help &gt; Welcome shows it again)</source>
        <translation>Fermer cette carte (Aide &gt; Bienvenue l’affiche à nouveau)</translation>
    </message>
    <message>
        <source>Close this card</source>
        <translation>Fermer cette carte</translation>
    </message>
    <message>
        <source>First task</source>
        <translation>Premier essai</translation>
    </message>
    <message>
        <source>Drag a dot, and see the organ follow</source>
        <translation>Tirer un point et voir l’organe suivre</translation>
    </message>
</context>
<context>
    <name>viscera::app::WindowLayout</name>
    <message>
        <source>&amp;Standard layout</source>
        <translation>Disposition &amp;standard</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>The window takes the whole screen</source>
        <translation>La fenêtre occupe tout l’écran</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Modes</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Barre de temps</translation>
    </message>
    <message>
        <source>Slides</source>
        <translation>Diapositives</translation>
    </message>
    <message>
        <source>Move all panels to their default places</source>
        <translation>Remettre tous les panneaux à leur place par défaut</translation>
    </message>
</context>
<context>
    <name>viscera::app::Workspace</name>
    <message>
        <source>Open folder</source>
        <translation>Ouvrir un dossier</translation>
    </message>
</context>
</TS>
