<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>&quot;%1&quot; is %2 instead of &quot;%3&quot;</source>
        <translation>« %1 » est %2 au lieu de « %3 »</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither true nor false</source>
        <translation>« %1 » n’est ni vrai ni faux</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list</source>
        <translation>« %1 » n’est pas une liste</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a text</source>
        <translation>« %1 » n’est pas un texte</translation>
    </message>
    <message>
        <source>&quot;version&quot; is not a positive whole number</source>
        <translation>« version » n’est pas un entier positif</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>%1 gives another surface than the one that was saved</source>
        <translation>%1 donne une autre surface que celle qui a été enregistrée</translation>
    </message>
    <message>
        <source>%1 has changed since the session was saved</source>
        <translation>%1 a changé depuis l’enregistrement de la session</translation>
    </message>
    <message>
        <source>%1 is farther away than a thousand kilometres</source>
        <translation>%1 est à plus de mille kilomètres</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 de plus de 1 Go ne peut pas être gardé dans un fichier de session</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 lignes</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 voxels</translation>
    </message>
    <message>
        <source>%1, %2 of them crumbs of less than 2 % of its area</source>
        <translation>%1, dont %2 miettes de moins de 2 % de son aire</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modifié</translation>
    </message>
    <message>
        <source>%1, handle %2</source>
        <translation>%1, poignée %2</translation>
    </message>
    <message>
        <source>%1, handles %2 and %3</source>
        <translation>%1, poignées %2 et %3</translation>
    </message>
    <message>
        <source>%1, key at %2 s</source>
        <translation>%1, clé à %2 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1 : « %2 » est inconnu et ne sera pas enregistré de nouveau</translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; look whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
        <translation>
            <numerusform>%2 se trouve hors de l’examen ; vérifiez que les deux viennent du même patient et ont les mêmes axes (RAS ou LPS)</numerusform>
            <numerusform>%2 se trouvent hors de l’examen ; vérifiez que tous viennent du même patient et ont les mêmes axes (RAS ou LPS)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary {edge|edges}: the surface is open and has no volume</source>
        <translation>
            <numerusform>%n arête de bord : la surface est ouverte et n’a pas de volume</numerusform>
            <numerusform>%n arêtes de bord : la surface est ouverte et n’a pas de volume</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge joins|edges join} more than two triangles</source>
        <translation>
            <numerusform>%n arête joint plus de deux triangles</numerusform>
            <numerusform>%n arêtes joignent plus de deux triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {edge lies|edges lie} between triangles of opposite orientation</source>
        <translation>
            <numerusform>%n arête est entre des triangles d’orientation opposée</numerusform>
            <numerusform>%n arêtes sont entre des triangles d’orientation opposée</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles}</source>
        <translation>
            <numerusform>%n poignée</numerusform>
            <numerusform>%n poignées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to repair the surface first</source>
        <translation>
            <numerusform>%n paire de triangles se traverse : le mode de contrainte devra peut-être d’abord réparer la surface</numerusform>
            <numerusform>%n paires de triangles se traversent : le mode de contrainte devra peut-être d’abord réparer la surface</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle has|triangles have} no area</source>
        <translation>
            <numerusform>%n triangle n’a pas d’aire</numerusform>
            <numerusform>%n triangles n’ont pas d’aire</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle was|triangles were} turned around to face outward.</source>
        <translation>
            <numerusform>%n triangle a été retourné vers l’extérieur.</numerusform>
            <numerusform>%n triangles ont été retournés vers l’extérieur.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle without area or that came twice is|triangles without area or that came twice are} left out.</source>
        <translation>
            <numerusform>%n triangle sans aire ou en double est laissé de côté.</numerusform>
            <numerusform>%n triangles sans aire ou en double sont laissés de côté.</numerusform>
        </translation>
    </message>
    <message>
        <source>A cavity has to come after the organ that it is in</source>
        <translation>Une cavité doit venir après l’organe où elle se trouve</translation>
    </message>
    <message>
        <source>A group names a handle that is not there</source>
        <translation>Un groupe nomme une poignée qui n’existe pas</translation>
    </message>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adulte sain couché.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Un quart du volume sanguin sous tension est perdu ; aucun réflexe ne répond, si bien que les pressions baissent plus qu’en réalité.</translation>
    </message>
    <message>
        <source>A rectangle lies in an axial, coronal or sagittal slice</source>
        <translation>Un rectangle se trouve dans une coupe axiale, coronale ou sagittale</translation>
    </message>
    <message>
        <source>A row has four numbers</source>
        <translation>Une ligne a quatre nombres</translation>
    </message>
    <message>
        <source>A scan has three axes</source>
        <translation>Un examen a trois axes</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Une session s’ouvre seule</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Un ventricule gauche rigide qui se relâche lentement : il se vide bien et ne se remplit qu’à haute pression.</translation>
    </message>
    <message>
        <source>A weak, dilated left ventricle and retained fluid: the loop lies far to the right, blood backs up to the lungs. Its wall has more muscle and is no thicker.</source>
        <translation>Un ventricule gauche faible et dilaté et une rétention de liquide : la boucle est loin à droite, le sang reflue vers les poumons. Sa paroi a plus de muscle sans être plus épaisse.</translation>
    </message>
    <message>
        <source>A wire in the space of balanced vectors; for many points it has no answer</source>
        <translation>Un fil dans l’espace des vecteurs équilibrés ; pour beaucoup de points il n’a pas de réponse</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message numerus="yes">
        <source>Add %n {organ|organs}</source>
        <translation>
            <numerusform>Ajouter %n organe</numerusform>
            <numerusform>Ajouter %n organes</numerusform>
        </translation>
    </message>
    <message>
        <source>Add enclosing group</source>
        <translation>Ajouter un groupe englobant</translation>
    </message>
    <message>
        <source>Add enclosing handles</source>
        <translation>Ajouter des poignées englobantes</translation>
    </message>
    <message>
        <source>Add group</source>
        <translation>Ajouter un groupe</translation>
    </message>
    <message>
        <source>Add group %1</source>
        <translation>Ajouter le groupe %1</translation>
    </message>
    <message>
        <source>Add to group</source>
        <translation>Ajouter au groupe</translation>
    </message>
    <message numerus="yes">
        <source>Add {handle|%n handles}</source>
        <translation>
            <numerusform>Ajouter une poignée</numerusform>
            <numerusform>Ajouter %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Afterload: pulmonary resistance</source>
        <translation>Postcharge : résistance pulmonaire</translation>
    </message>
    <message>
        <source>Afterload: systemic resistance</source>
        <translation>Postcharge : résistance systémique</translation>
    </message>
    <message>
        <source>An angle needs three points, any other measurement two</source>
        <translation>Un angle demande trois points, toute autre mesure deux</translation>
    </message>
    <message>
        <source>An organ needs a surface</source>
        <translation>Un organe a besoin d’une surface</translation>
    </message>
    <message>
        <source>An organ needs at least four handles around it: add %1 more</source>
        <translation>Un organe a besoin d’au moins quatre poignées autour de lui : ajoutez-en encore %1</translation>
    </message>
    <message>
        <source>An organ needs handles around it</source>
        <translation>Un organe demande des poignées autour de lui</translation>
    </message>
    <message>
        <source>Antrum</source>
        <translation>Antre</translation>
    </message>
    <message>
        <source>Any point on the side of the right ventricle</source>
        <translation>Un point quelconque du côté du ventricule droit</translation>
    </message>
    <message>
        <source>Aorta</source>
        <translation>Aorte</translation>
    </message>
    <message>
        <source>Aorta, characteristic impedance</source>
        <translation>Aorte, impédance caractéristique</translation>
    </message>
    <message>
        <source>Aorta, diastolic</source>
        <translation>Aorte, diastolique</translation>
    </message>
    <message>
        <source>Aorta, mean</source>
        <translation>Aorte, moyenne</translation>
    </message>
    <message>
        <source>Aorta, systolic</source>
        <translation>Aorte, systolique</translation>
    </message>
    <message>
        <source>Aortic arch</source>
        <translation>Arc aortique</translation>
    </message>
    <message>
        <source>Aortic gradient, mean</source>
        <translation>Gradient aortique, moyen</translation>
    </message>
    <message>
        <source>Aortic stenosis</source>
        <translation>Sténose aortique</translation>
    </message>
    <message>
        <source>Aortic valve</source>
        <translation>Valve aortique</translation>
    </message>
    <message>
        <source>Aortic valve, leak</source>
        <translation>Valve aortique, fuite</translation>
    </message>
    <message>
        <source>Aortic valve, open</source>
        <translation>Valve aortique, ouverture</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Apex</translation>
    </message>
    <message>
        <source>Appendix</source>
        <translation>Appendice</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Arterial elastance Ea</source>
        <translation>Élastance artérielle Ea</translation>
    </message>
    <message>
        <source>Arteries</source>
        <translation>Artères</translation>
    </message>
    <message>
        <source>As near to a target as balance allows; what is done about negative numbers can be chosen</source>
        <translation>Aussi près d’une cible que l’équilibre le permet ; le traitement des nombres négatifs est au choix</translation>
    </message>
    <message>
        <source>Ascending aorta</source>
        <translation>Aorte ascendante</translation>
    </message>
    <message>
        <source>Ascending colon</source>
        <translation>Côlon ascendant</translation>
    </message>
    <message>
        <source>Atria</source>
        <translation>Atriums</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Bending the scan</source>
        <translation>Courbure de l’examen</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>Courbé</translation>
    </message>
    <message>
        <source>Beyond the data: people were measured from 50 to 171 beats a minute</source>
        <translation>Au-delà des données : mesures faites de 50 à 171 battements par minute</translation>
    </message>
    <message>
        <source>Bile duct</source>
        <translation>Conduit cholédoque</translation>
    </message>
    <message>
        <source>Binding %1</source>
        <translation>Liaison de %1</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Body of the stomach</source>
        <translation>Corps gastrique</translation>
    </message>
    <message>
        <source>Bones and joints</source>
        <translation>Os et articulations</translation>
    </message>
    <message>
        <source>Bounded biharmonic weights</source>
        <translation>Poids biharmoniques bornés</translation>
    </message>
    <message>
        <source>Bradygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Bradygastrie : les personnes saines ont 2 à 4 ondes par minute.</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Respiration</translation>
    </message>
    <message>
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not touch its handles</source>
        <translation>Par les coins et les normales d’une cage de forme quelconque ; conserve presque les angles, et ne touche pas ses poignées</translation>
    </message>
    <message>
        <source>C-Celestial</source>
        <translation>C-Celestial</translation>
    </message>
    <message>
        <source>Caecum</source>
        <translation>Cæcum</translation>
    </message>
    <message>
        <source>Cardia</source>
        <translation>Cardia</translation>
    </message>
    <message>
        <source>Cardiac output</source>
        <translation>Débit cardiaque</translation>
    </message>
    <message>
        <source>Catalogue of layers</source>
        <translation>Catalogue de couches</translation>
    </message>
    <message>
        <source>Caudate lobe</source>
        <translation>Lobe caudé</translation>
    </message>
    <message>
        <source>Centreline</source>
        <translation>Ligne médiane</translation>
    </message>
    <message>
        <source>Change group</source>
        <translation>Modifier le groupe</translation>
    </message>
    <message>
        <source>Change look</source>
        <translation>Changer l’aspect</translation>
    </message>
    <message>
        <source>Change recording</source>
        <translation>Modifier l’enregistrement</translation>
    </message>
    <message>
        <source>Checking %1</source>
        <translation>Vérification de %1</translation>
    </message>
    <message>
        <source>Circulation: %1</source>
        <translation>Circulation : %1</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Fermer les trous</translation>
    </message>
    <message>
        <source>Close scan</source>
        <translation>Fermer l’examen</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Colorer le groupe</translation>
    </message>
    <message numerus="yes">
        <source>Compensate with {handle|%n handles}</source>
        <translation>
            <numerusform>Compenser avec cette poignée</numerusform>
            <numerusform>Compenser avec %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Contractility of the left ventricle</source>
        <translation>Contractilité du ventricule gauche</translation>
    </message>
    <message>
        <source>Contractility of the right ventricle</source>
        <translation>Contractilité du ventricule droit</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordonnées</translation>
    </message>
    <message>
        <source>Coordinates %1</source>
        <translation>Coordonnées %1</translation>
    </message>
    <message>
        <source>Coupling Ea/Ees</source>
        <translation>Couplage Ea/Ees</translation>
    </message>
    <message>
        <source>Delaunay triangulation approach</source>
        <translation>Méthode de la triangulation de Delaunay</translation>
    </message>
    <message>
        <source>Descending colon</source>
        <translation>Côlon descendant</translation>
    </message>
    <message numerus="yes">
        <source>Describe {handle|%n handles}</source>
        <translation>
            <numerusform>Décrire la poignée</numerusform>
            <numerusform>Décrire %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Determinants approach</source>
        <translation>Méthode des déterminants</translation>
    </message>
    <message>
        <source>Digestive system</source>
        <translation>Système digestif</translation>
    </message>
    <message>
        <source>Displacement_mm</source>
        <translation>Displacement_mm</translation>
    </message>
    <message>
        <source>Distance from a zone within which its super-region still counts: smoothness against locality</source>
        <translation>Distance à une zone jusqu’à laquelle sa super-région compte encore : régularité contre localité</translation>
    </message>
    <message>
        <source>Distance over which the pull of a handle is rounded; 0 passes through the handles</source>
        <translation>Distance sur laquelle la traction d’une poignée est arrondie ; 0 passe par les poignées</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^level rays</source>
        <translation>Divisions de l’icosaèdre : 20 * 4^niveau rayons</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^samples directions</source>
        <translation>Divisions de l’icosaèdre : 20 * 4^échantillons directions</translation>
    </message>
    <message>
        <source>Dome under the diaphragm</source>
        <translation>Dôme sous le diaphragme</translation>
    </message>
    <message>
        <source>Duodenum</source>
        <translation>Duodénum</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>ECG</translation>
    </message>
    <message>
        <source>Easing %1</source>
        <translation>Transition %1</translation>
    </message>
    <message>
        <source>Edges of tetrahedra across the handles; more are finer and slower</source>
        <translation>Arêtes de tétraèdres à travers les poignées ; davantage est plus fin et plus lent</translation>
    </message>
    <message>
        <source>Ejection fraction</source>
        <translation>Fraction d’éjection</translation>
    </message>
    <message>
        <source>Enclosing</source>
        <translation>Englobantes</translation>
    </message>
    <message>
        <source>End-systolic and relaxed</source>
        <translation>Télésystolique et relâchée</translation>
    </message>
    <message>
        <source>Endocrine glands</source>
        <translation>Glandes endocrines</translation>
    </message>
    <message>
        <source>Epicardium</source>
        <translation>Épicarde</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Far corners</source>
        <translation>Coins lointains</translation>
    </message>
    <message>
        <source>Filling that multiplies the pericardium's pressure by e</source>
        <translation>Remplissage qui multiplie la pression du péricarde par e</translation>
    </message>
    <message>
        <source>Fitted circulation</source>
        <translation>Circulation ajustée</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fixe</translation>
    </message>
    <message>
        <source>Fluid in the pericardium</source>
        <translation>Liquide dans le péricarde</translation>
    </message>
    <message>
        <source>Fluid in the pericardium presses on all chambers: they fill little, and all filling pressures are the same.</source>
        <translation>Du liquide dans le péricarde comprime toutes les cavités : elles se remplissent peu, et toutes les pressions de remplissage sont égales.</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Replié</translation>
    </message>
    <message>
        <source>Folded tissue</source>
        <translation>Tissu replié</translation>
    </message>
    <message>
        <source>Forget what was before</source>
        <translation>Oublier l’état d’avant</translation>
    </message>
    <message>
        <source>From atrial to ventricular contraction</source>
        <translation>De la contraction atriale à la ventriculaire</translation>
    </message>
    <message>
        <source>Fundus</source>
        <translation>Fundus</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vésicule biliaire</translation>
    </message>
    <message>
        <source>Gastric peristalsis</source>
        <translation>Péristaltisme gastrique</translation>
    </message>
    <message>
        <source>Gradient method</source>
        <translation>Méthode du gradient</translation>
    </message>
    <message>
        <source>Great vessels</source>
        <translation>Gros vaisseaux</translation>
    </message>
    <message>
        <source>Greater curvature</source>
        <translation>Grande courbure</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Green</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Group automatically</source>
        <translation>Grouper automatiquement</translation>
    </message>
    <message>
        <source>Groups of handles move only their own region of the organ; neighbouring regions blend smoothly.</source>
        <translation>Les groupes de poignées ne meuvent que leur région de l’organe ; les régions voisines se fondent sans heurt.</translation>
    </message>
    <message>
        <source>Haemorrhage</source>
        <translation>Hémorragie</translation>
    </message>
    <message>
        <source>Hard upright work: a fast and strong heart, open muscle vessels, veins that give blood back.</source>
        <translation>Travail intense debout : un cœur rapide et fort, des vaisseaux musculaires ouverts, des veines qui rendent du sang.</translation>
    </message>
    <message>
        <source>Harmonic</source>
        <translation>Harmonique</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Heart failure, preserved EF</source>
        <translation>Insuffisance cardiaque, FE préservée</translation>
    </message>
    <message>
        <source>Heart failure, reduced EF</source>
        <translation>Insuffisance cardiaque, FE réduite</translation>
    </message>
    <message>
        <source>Heart follows the circulation</source>
        <translation>Le cœur suit la circulation</translation>
    </message>
    <message>
        <source>Heart follows the textbook</source>
        <translation>Le cœur suit le battement type</translation>
    </message>
    <message>
        <source>Heart rate</source>
        <translation>Fréquence cardiaque</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Battement du cœur</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message numerus="yes">
        <source>Hide {handle|%n handles}</source>
        <translation>
            <numerusform>Cacher la poignée</numerusform>
            <numerusform>Cacher %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>How far beyond the handles' hull the weights are computed</source>
        <translation>Jusqu’où au-delà de l’enveloppe des poignées les poids sont calculés</translation>
    </message>
    <message>
        <source>How much nearer handles count more; 0 as in the thesis</source>
        <translation>Combien les poignées proches comptent davantage ; 0 comme dans la thèse</translation>
    </message>
    <message>
        <source>How near to a flip the two triangulations are blended; 0 for not</source>
        <translation>À quelle distance d’un basculement les deux triangulations sont mêlées ; 0 pour jamais</translation>
    </message>
    <message>
        <source>How positive balanced vectors are found</source>
        <translation>Comment sont trouvés des vecteurs équilibrés positifs</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Comment les poids des sommets de Voronoï atteignent les poignées</translation>
    </message>
    <message>
        <source>How the wire connects them</source>
        <translation>Comment le fil les relie</translation>
    </message>
    <message>
        <source>Hypertension</source>
        <translation>Hypertension</translation>
    </message>
    <message>
        <source>Incremental approach</source>
        <translation>Méthode incrémentale</translation>
    </message>
    <message>
        <source>Inferior vena cava</source>
        <translation>Veine cave inférieure</translation>
    </message>
    <message>
        <source>Influence of %1</source>
        <translation>Influence de %1</translation>
    </message>
    <message>
        <source>Inner handles of each layer</source>
        <translation>Poignées internes de chaque couche</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>Il est illisible</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Elle se traverse elle-même, à %n paire de triangles</numerusform>
            <numerusform>Elle se traverse elle-même, à %n paires de triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {vertex|vertices}</source>
        <translation>
            <numerusform>Elle a %n sommet</numerusform>
            <numerusform>Elle a %n sommets</numerusform>
        </translation>
    </message>
    <message>
        <source>It has no &quot;%1&quot;</source>
        <translation>« %1 » manque</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>Il n’a pas de surface « %1 »</translation>
    </message>
    <message>
        <source>It has to be a text</source>
        <translation>Ce doit être un texte</translation>
    </message>
    <message>
        <source>It holds less than %1</source>
        <translation>Il contient moins que %1</translation>
    </message>
    <message>
        <source>It is a scan and no organ</source>
        <translation>C’est un examen et non un organe</translation>
    </message>
    <message>
        <source>It is damaged: it does not hold %1</source>
        <translation>Il est endommagé : il ne contient pas %1</translation>
    </message>
    <message>
        <source>It is damaged: its SHA-256 is not %1</source>
        <translation>Il est endommagé : son SHA-256 n’est pas %1</translation>
    </message>
    <message>
        <source>It is neither &quot;embedded&quot; nor &quot;linked&quot;</source>
        <translation>Ce n’est ni « embedded » ni « linked »</translation>
    </message>
    <message>
        <source>It is nested too deeply</source>
        <translation>L’imbrication est trop profonde</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>Ce n’est pas un fichier de type %1 : son « format » n’est pas « %2 »</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>Ce n’est pas un fichier lisible</translation>
    </message>
    <message>
        <source>It is not a finite number</source>
        <translation>Ce n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>It is not a list of three numbers</source>
        <translation>Ce n’est pas une liste de trois nombres</translation>
    </message>
    <message>
        <source>It is not a text</source>
        <translation>Ce n’est pas un texte</translation>
    </message>
    <message>
        <source>It is not a triangle of three handles</source>
        <translation>Ce n’est pas un triangle de trois poignées</translation>
    </message>
    <message>
        <source>It is not a whole number from 0 to 2^53</source>
        <translation>Ce n’est pas un entier de 0 à 2^53</translation>
    </message>
    <message>
        <source>It is not an object</source>
        <translation>Ce n’est pas un objet</translation>
    </message>
    <message>
        <source>It is not base64</source>
        <translation>Ce n’est pas du base64</translation>
    </message>
    <message>
        <source>It is not complete JSON: %1</source>
        <translation>Ce n’est pas du JSON complet : %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>Il est de la version %1 ; ce programme lit jusqu’à %2</translation>
    </message>
    <message>
        <source>It is too long</source>
        <translation>Il est trop long</translation>
    </message>
    <message>
        <source>Its axes lie in one plane</source>
        <translation>Ses axes sont dans un même plan</translation>
    </message>
    <message>
        <source>Keep as before</source>
        <translation>Garder comme avant</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Rein</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>Cavité AG</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>LV cavity</source>
        <translation>Cavité VG</translation>
    </message>
    <message>
        <source>LV dP/dt, largest</source>
        <translation>dP/dt VG, maximum</translation>
    </message>
    <message>
        <source>LV end-diastolic</source>
        <translation>VG télédiastolique</translation>
    </message>
    <message>
        <source>LV end-diastolic pressure</source>
        <translation>Pression télédiastolique VG</translation>
    </message>
    <message>
        <source>LV end-systolic</source>
        <translation>VG télésystolique</translation>
    </message>
    <message>
        <source>LV endocardium</source>
        <translation>Endocarde VG</translation>
    </message>
    <message>
        <source>LV stroke work</source>
        <translation>Travail systolique VG</translation>
    </message>
    <message>
        <source>Lagrange minimisation</source>
        <translation>Minimisation de Lagrange</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Plus grand étirement</translation>
    </message>
    <message>
        <source>Lateral border</source>
        <translation>Bord latéral</translation>
    </message>
    <message>
        <source>Leak below its</source>
        <translation>Fuite sous sa</translation>
    </message>
    <message>
        <source>Left anterior descending artery</source>
        <translation>Artère interventriculaire antérieure</translation>
    </message>
    <message>
        <source>Left atrium</source>
        <translation>Atrium gauche</translation>
    </message>
    <message>
        <source>Left atrium, contractility</source>
        <translation>Atrium gauche, contractilité</translation>
    </message>
    <message>
        <source>Left atrium, mean</source>
        <translation>Atrium gauche, moyenne</translation>
    </message>
    <message>
        <source>Left atrium, relaxation</source>
        <translation>Atrium gauche, relaxation</translation>
    </message>
    <message>
        <source>Left atrium, right ventricle</source>
        <translation>Atrium gauche, ventricule droit</translation>
    </message>
    <message>
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Atrium gauche, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
        <translation>Atrium gauche, pente de la courbe relâchée</translation>
    </message>
    <message>
        <source>Left atrium, volume without pressure</source>
        <translation>Atrium gauche, volume à pression nulle</translation>
    </message>
    <message>
        <source>Left auricle</source>
        <translation>Auricule gauche</translation>
    </message>
    <message>
        <source>Left colic flexure</source>
        <translation>Angle colique gauche</translation>
    </message>
    <message>
        <source>Left kidney</source>
        <translation>Rein gauche</translation>
    </message>
    <message>
        <source>Left lobe</source>
        <translation>Lobe gauche</translation>
    </message>
    <message>
        <source>Left pulmonary artery</source>
        <translation>Artère pulmonaire gauche</translation>
    </message>
    <message>
        <source>Left ventricle</source>
        <translation>Ventricule gauche</translation>
    </message>
    <message>
        <source>Left ventricle, relaxation</source>
        <translation>Ventricule gauche, relaxation</translation>
    </message>
    <message>
        <source>Left ventricle, scale of the passive filling curve</source>
        <translation>Ventricule gauche, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Left ventricle, volume without pressure</source>
        <translation>Ventricule gauche, volume à pression nulle</translation>
    </message>
    <message>
        <source>Left ventricular</source>
        <translation>Ventriculaire gauche</translation>
    </message>
    <message>
        <source>Lesser curvature</source>
        <translation>Petite courbure</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Localised S-Celestial</source>
        <translation>S-Celestial localisé</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Lock volume</source>
        <translation>Verrouiller le volume</translation>
    </message>
    <message numerus="yes">
        <source>Lock {handle|%n handles}</source>
        <translation>
            <numerusform>Verrouiller la poignée</numerusform>
            <numerusform>Verrouiller %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Lower pole</source>
        <translation>Pôle inférieur</translation>
    </message>
    <message>
        <source>Lymphatic system</source>
        <translation>Système lymphatique</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Mean value</source>
        <translation>Valeur moyenne</translation>
    </message>
    <message>
        <source>Mean value of a cage with flat polygons, whose diagonals play no part</source>
        <translation>Valeur moyenne d’une cage à polygones plans, dont les diagonales ne jouent aucun rôle</translation>
    </message>
    <message>
        <source>Mean value of what can be seen of a cage, by rays; positive in any cage</source>
        <translation>Valeur moyenne de ce qui est visible d’une cage, par rayons ; positive dans toute cage</translation>
    </message>
    <message>
        <source>Mean value on the hull, inner handles added one by one; they may make some negative</source>
        <translation>Valeur moyenne sur l’enveloppe, poignées internes ajoutées une à une ; elles peuvent en rendre négatives</translation>
    </message>
    <message>
        <source>Mean value over all tetrahedra of the handles at once, by directions; positive, with many maxima</source>
        <translation>Valeur moyenne sur tous les tétraèdres des poignées à la fois, par directions ; positive, avec beaucoup de maxima</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Valeur moyenne sur les régions de Voronoï des poignées vues de chaque point ; sauts, ou lente</translation>
    </message>
    <message>
        <source>Mean value over the triangles in which each point sees the handles; jumps, or blended rough</source>
        <translation>Valeur moyenne sur les triangles dans lesquels chaque point voit les poignées ; sauts, ou rugueux si mêlé</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Mesurer : %1</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurée</translation>
    </message>
    <message>
        <source>Middle of the body</source>
        <translation>Milieu du corps</translation>
    </message>
    <message>
        <source>Mitral regurgitation</source>
        <translation>Insuffisance mitrale</translation>
    </message>
    <message>
        <source>Mitral valve</source>
        <translation>Valve mitrale</translation>
    </message>
    <message>
        <source>Mitral valve, leak</source>
        <translation>Valve mitrale, fuite</translation>
    </message>
    <message>
        <source>Mitral valve, open</source>
        <translation>Valve mitrale, ouverture</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Déplacer la clé</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Déplacer un point mesuré</translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles}</source>
        <translation>
            <numerusform>Déplacer la poignée</numerusform>
            <numerusform>Déplacer %n poignées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move {handle|%n handles} at rest</source>
        <translation>
            <numerusform>Déplacer la poignée au repos</numerusform>
            <numerusform>Déplacer %n poignées au repos</numerusform>
        </translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Muscles</translation>
    </message>
    <message>
        <source>Narrow small arteries and stiff large ones, against which a stronger, stiffer, thicker ventricle works.</source>
        <translation>De petites artères étroites et de grandes artères rigides, contre lesquelles travaille un ventricule plus fort, plus rigide et plus épais.</translation>
    </message>
    <message>
        <source>Natural neighbours</source>
        <translation>Voisins naturels</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Col</translation>
    </message>
    <message>
        <source>Nervous system</source>
        <translation>Système nerveux</translation>
    </message>
    <message>
        <source>No scan has %1 voxels along an axis</source>
        <translation>Aucun examen n’a %1 voxels le long d’un axe</translation>
    </message>
    <message>
        <source>Numerical integration approach</source>
        <translation>Méthode de l’intégration numérique</translation>
    </message>
    <message>
        <source>Oesophagus</source>
        <translation>Œsophage</translation>
    </message>
    <message>
        <source>Of the random numbers</source>
        <translation>Des nombres aléatoires</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message numerus="yes">
        <source>Open %n {file|files}</source>
        <translation>
            <numerusform>Ouvrir %n fichier</numerusform>
            <numerusform>Ouvrir %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Open scan %1</source>
        <translation>Ouvrir l’examen %1</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>PR interval, 0.12 to 0.20 s</source>
        <translation>Intervalle PR, 0,12 à 0,20 s</translation>
    </message>
    <message>
        <source>Pancreas</source>
        <translation>Pancréas</translation>
    </message>
    <message>
        <source>Peak of %1</source>
        <translation>Pic de : %1</translation>
    </message>
    <message>
        <source>Peak stress</source>
        <translation>Contrainte de pic</translation>
    </message>
    <message>
        <source>Points along the middle of the stomach, from the fundus down</source>
        <translation>Points le long du milieu de l’estomac, du fundus vers le bas</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Positive mean value</source>
        <translation>Valeur moyenne positive</translation>
    </message>
    <message>
        <source>Preload: stressed blood volume</source>
        <translation>Précharge : volume sanguin sous tension</translation>
    </message>
    <message>
        <source>Pressure (mmHg)</source>
        <translation>Pression (mmHg)</translation>
    </message>
    <message>
        <source>Pulmonary arteries, compliance</source>
        <translation>Artères pulmonaires, compliance</translation>
    </message>
    <message>
        <source>Pulmonary artery</source>
        <translation>Artère pulmonaire</translation>
    </message>
    <message>
        <source>Pulmonary artery, characteristic impedance</source>
        <translation>Artère pulmonaire, impédance caractéristique</translation>
    </message>
    <message>
        <source>Pulmonary artery, mean</source>
        <translation>Artère pulmonaire, moyenne</translation>
    </message>
    <message>
        <source>Pulmonary artery, systolic</source>
        <translation>Artère pulmonaire, systolique</translation>
    </message>
    <message>
        <source>Pulmonary trunk</source>
        <translation>Tronc pulmonaire</translation>
    </message>
    <message>
        <source>Pulmonary valve, leak</source>
        <translation>Valve pulmonaire, fuite</translation>
    </message>
    <message>
        <source>Pulmonary valve, open</source>
        <translation>Valve pulmonaire, ouverture</translation>
    </message>
    <message>
        <source>Pulmonary vein</source>
        <translation>Veine pulmonaire</translation>
    </message>
    <message>
        <source>Pulmonary veins, compliance</source>
        <translation>Veines pulmonaires, compliance</translation>
    </message>
    <message>
        <source>Pulmonary veins, resistance</source>
        <translation>Veines pulmonaires, résistance</translation>
    </message>
    <message>
        <source>Pylorus</source>
        <translation>Pylore</translation>
    </message>
    <message>
        <source>RA cavity</source>
        <translation>Cavité AD</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>RV cavity</source>
        <translation>Cavité VD</translation>
    </message>
    <message>
        <source>RV ejection fraction</source>
        <translation>Fraction d’éjection VD</translation>
    </message>
    <message>
        <source>RV end-diastolic</source>
        <translation>VD télédiastolique</translation>
    </message>
    <message>
        <source>RV end-systolic</source>
        <translation>VD télésystolique</translation>
    </message>
    <message>
        <source>RV free wall</source>
        <translation>Paroi libre VD</translation>
    </message>
    <message>
        <source>RV stroke work</source>
        <translation>Travail systolique VD</translation>
    </message>
    <message>
        <source>Rational coordinates of a convex cage; positive and smooth inside</source>
        <translation>Coordonnées rationnelles d’une cage convexe ; positives et lisses à l’intérieur</translation>
    </message>
    <message>
        <source>Record key</source>
        <translation>Enregistrer une clé</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistrée</translation>
    </message>
    <message>
        <source>Rectum</source>
        <translation>Rectum</translation>
    </message>
    <message>
        <source>Remove all measurements</source>
        <translation>Supprimer toutes les mesures</translation>
    </message>
    <message>
        <source>Remove all organs</source>
        <translation>Supprimer tous les organes</translation>
    </message>
    <message>
        <source>Remove from group</source>
        <translation>Retirer du groupe</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Supprimer le groupe</translation>
    </message>
    <message numerus="yes">
        <source>Remove {handle|%n handles}</source>
        <translation>
            <numerusform>Retirer la poignée</numerusform>
            <numerusform>Retirer %n poignées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {key|%n keys}</source>
        <translation>
            <numerusform>Retirer la clé</numerusform>
            <numerusform>Retirer %n clés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Retirer la mesure</numerusform>
            <numerusform>Retirer %n mesures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {organ|%n organs}</source>
        <translation>
            <numerusform>Retirer l’organe</numerusform>
            <numerusform>Retirer %n organes</numerusform>
        </translation>
    </message>
    <message>
        <source>Renal artery</source>
        <translation>Artère rénale</translation>
    </message>
    <message>
        <source>Renal pelvis</source>
        <translation>Pelvis rénal</translation>
    </message>
    <message>
        <source>Renal vein</source>
        <translation>Veine rénale</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Renommer le groupe</translation>
    </message>
    <message>
        <source>Rename handle</source>
        <translation>Renommer la poignée</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>Renommer la mesure</translation>
    </message>
    <message>
        <source>Rename organ</source>
        <translation>Renommer l’organe</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>Réparation de %1</translation>
    </message>
    <message>
        <source>Replace handles</source>
        <translation>Remplacer les poignées</translation>
    </message>
    <message>
        <source>Replace pose of key</source>
        <translation>Remplacer la pose de la clé</translation>
    </message>
    <message>
        <source>Replace recording</source>
        <translation>Remplacer l’enregistrement</translation>
    </message>
    <message>
        <source>Reproductive system</source>
        <translation>Système génital</translation>
    </message>
    <message>
        <source>Reset pose</source>
        <translation>Rétablir la pose</translation>
    </message>
    <message>
        <source>Respiratory system</source>
        <translation>Système respiratoire</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Repos</translation>
    </message>
    <message>
        <source>Right atrium</source>
        <translation>Atrium droit</translation>
    </message>
    <message>
        <source>Right atrium, contractility</source>
        <translation>Atrium droit, contractilité</translation>
    </message>
    <message>
        <source>Right atrium, mean</source>
        <translation>Atrium droit, moyenne</translation>
    </message>
    <message>
        <source>Right atrium, relaxation</source>
        <translation>Atrium droit, relaxation</translation>
    </message>
    <message>
        <source>Right atrium, scale of the passive filling curve</source>
        <translation>Atrium droit, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
        <translation>Atrium droit, pente de la courbe relâchée</translation>
    </message>
    <message>
        <source>Right atrium, volume without pressure</source>
        <translation>Atrium droit, volume à pression nulle</translation>
    </message>
    <message>
        <source>Right colic flexure</source>
        <translation>Angle colique droit</translation>
    </message>
    <message>
        <source>Right coronary artery</source>
        <translation>Artère coronaire droite</translation>
    </message>
    <message>
        <source>Right kidney</source>
        <translation>Rein droit</translation>
    </message>
    <message>
        <source>Right lobe</source>
        <translation>Lobe droit</translation>
    </message>
    <message>
        <source>Right ventricle</source>
        <translation>Ventricule droit</translation>
    </message>
    <message>
        <source>Right ventricle, relaxation</source>
        <translation>Ventricule droit, relaxation</translation>
    </message>
    <message>
        <source>Right ventricle, scale of the passive filling curve</source>
        <translation>Ventricule droit, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
        <translation>Ventricule droit, pente de la courbe relâchée</translation>
    </message>
    <message>
        <source>Right ventricle, volume without pressure</source>
        <translation>Ventricule droit, volume à pression nulle</translation>
    </message>
    <message>
        <source>Right ventricular</source>
        <translation>Ventriculaire droite</translation>
    </message>
    <message>
        <source>Rotational stress</source>
        <translation>Contrainte rotationnelle</translation>
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
        <translation>Échantillons par point</translation>
    </message>
    <message>
        <source>Septum</source>
        <translation>Septum</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Régler %1</translation>
    </message>
    <message>
        <source>Set pose</source>
        <translation>Définir la pose</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message numerus="yes">
        <source>Show {handle|%n handles}</source>
        <translation>
            <numerusform>Montrer la poignée</numerusform>
            <numerusform>Montrer %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Sibson's coordinates: what a point takes from its neighbours' Voronoi cells; positive and local</source>
        <translation>Coordonnées de Sibson : ce qu’un point prend aux cellules de Voronoï de ses voisins ; positives et locales</translation>
    </message>
    <message>
        <source>Sigmoid colon</source>
        <translation>Côlon sigmoïde</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Peau et graisse</translation>
    </message>
    <message>
        <source>Small bowel</source>
        <translation>Intestin grêle</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Plus petit étirement</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; maximum entropy over directions</source>
        <translation>Lisse et positif, à partir de points seuls ; entropie maximale sur les directions</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; the thesis's choice for organs</source>
        <translation>Lisse et positif, à partir de points seuls ; le choix de la thèse pour les organes</translation>
    </message>
    <message>
        <source>Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes</source>
        <translation>Solutions de l’équation de Laplace dans une cage de forme quelconque ; locales, sans lobes négatifs</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Spherical mean value</source>
        <translation>Valeur moyenne sphérique</translation>
    </message>
    <message>
        <source>Spleen</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Stiffness of the left ventricle</source>
        <translation>Rigidité du ventricule gauche</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>Estomac</translation>
    </message>
    <message>
        <source>Stomach and bowel</source>
        <translation>Estomac et intestin</translation>
    </message>
    <message numerus="yes">
        <source>Stop compensating with {handle|%n handles}</source>
        <translation>
            <numerusform>Ne plus compenser avec cette poignée</numerusform>
            <numerusform>Ne plus compenser avec %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Stress at the witness points</source>
        <translation>Contrainte aux points témoins</translation>
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
        <translation>Volume d’éjection systolique</translation>
    </message>
    <message>
        <source>Superior vena cava</source>
        <translation>Veine cave supérieure</translation>
    </message>
    <message>
        <source>Surfaces are cut by at most 8 planes at once, not by %1</source>
        <translation>Les surfaces sont coupées par 8 plans au plus à la fois, et non par %1</translation>
    </message>
    <message>
        <source>System used inside each region</source>
        <translation>Système utilisé dans chaque région</translation>
    </message>
    <message>
        <source>Systemic arteries, compliance</source>
        <translation>Artères systémiques, compliance</translation>
    </message>
    <message>
        <source>Systemic veins, compliance</source>
        <translation>Veines systémiques, compliance</translation>
    </message>
    <message>
        <source>Systemic veins, resistance</source>
        <translation>Veines systémiques, résistance</translation>
    </message>
    <message>
        <source>T-Celestial</source>
        <translation>T-Celestial</translation>
    </message>
    <message>
        <source>Tachygastria: healthy people have 2 to 4 waves a minute.</source>
        <translation>Tachygastrie : les personnes saines ont 2 à 4 ondes par minute.</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Queue</translation>
    </message>
    <message>
        <source>Take the cage %1</source>
        <translation>Prendre la cage %1</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponnade</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen n’a placé aucun point à l’intérieur de la surface</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>La valve aortique s’ouvre à 0,8 cm2 : la pression du ventricule hypertrophié dépasse de loin celle de l’aorte.</translation>
    </message>
    <message>
        <source>The cage names a handle that is not there</source>
        <translation>La cage nomme une poignée qui n’existe pas</translation>
    </message>
    <message>
        <source>The centre of all positive answers, by sampling; as good as the number of samples</source>
        <translation>Le centre de toutes les réponses positives, par échantillonnage ; aussi bon que le nombre d’échantillons</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Les coordonnées classiques d’une cage fermée ; positives là où la cage est convexe</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>La carte d’étiquettes de %1 a une autre grille (%2) que l’examen (%3) ; chacune est là où son fichier le dit, et rien n’est rééchantillonné</translation>
    </message>
    <message>
        <source>The mean over all tetrahedra of handles around a point; jumps where their number changes</source>
        <translation>La moyenne sur tous les tétraèdres de poignées autour d’un point ; saute où leur nombre change</translation>
    </message>
    <message>
        <source>The mean over the hull and partitions of it by the inner handles; kinks at their faces</source>
        <translation>La moyenne sur l’enveloppe et ses partitions par les poignées internes ; plis à leurs faces</translation>
    </message>
    <message>
        <source>The middle of the mitral valve, inside the heart</source>
        <translation>Le milieu de la valve mitrale, dans le cœur</translation>
    </message>
    <message>
        <source>The mitral valve leaks through 0.4 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>La valve mitrale fuit par 0,4 cm2 : la moitié de ce que le ventricule éjecte retourne dans l’atrium.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>Le nombre de points témoins doit être de %1 à %2</translation>
    </message>
    <message>
        <source>The numbers to stay near to</source>
        <translation>Les nombres dont rester proche</translation>
    </message>
    <message>
        <source>The organ that this cavity is in is not there any more</source>
        <translation>L’organe où se trouve cette cavité n’existe plus</translation>
    </message>
    <message>
        <source>The outlet of the stomach</source>
        <translation>La sortie de l’estomac</translation>
    </message>
    <message>
        <source>The points of n-space that the wire connects</source>
        <translation>Les points de l’espace à n dimensions que le fil relie</translation>
    </message>
    <message>
        <source>The pose has %1 handles, the document %2</source>
        <translation>La pose a %1 poignées, le document %2</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>La pose a une position qui n’est pas un nombre fini, ou trop éloignée</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>La séquence déplace %1 poignées, mais il y en a %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>La séquence a été faite pour une autre position d’une poignée</translation>
    </message>
    <message>
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>Le plus petit nombre est élevé autant que possible ; positif, avec des plis</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>La surface n’a aucun triangle</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>La surface a été réparée avant d’être remplie.</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled. %1. Details smaller than %2 mm are lost.</source>
        <translation>La surface a été réparée avant d’être remplie. %1. Les détails de moins de %2 mm sont perdus.</translation>
    </message>
    <message>
        <source>The thesis's radius; it cancels in the coordinates and changes nothing</source>
        <translation>Le rayon de la thèse ; il s’élimine dans les coordonnées et ne change rien</translation>
    </message>
    <message>
        <source>The tip of the heart</source>
        <translation>La pointe du cœur</translation>
    </message>
    <message>
        <source>The top of the fundus</source>
        <translation>Le sommet du fundus</translation>
    </message>
    <message>
        <source>The width has to be positive</source>
        <translation>La largeur doit être positive</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Les points témoins sont sur une grille régulière dans la surface.</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Les points témoins sont sur une grille régulière à l’intérieur de la surface. %1.</translation>
    </message>
    <message>
        <source>There are %1 positions for %2 handles</source>
        <translation>Il y a %1 positions pour %2 poignées</translation>
    </message>
    <message>
        <source>There are %1 witness points; %2 do not fit this shape or the limits of time and memory.</source>
        <translation>Il y a %1 points témoins ; %2 ne conviennent pas à cette forme ou aux limites de temps et de mémoire.</translation>
    </message>
    <message>
        <source>There are no handles to group</source>
        <translation>Il n’y a pas de poignées à grouper</translation>
    </message>
    <message>
        <source>There are no handles whose pose could be recorded</source>
        <translation>Il n’y a pas de poignées dont la pose puisse être enregistrée</translation>
    </message>
    <message>
        <source>There are no such vertices to enclose</source>
        <translation>Ces sommets à entourer n’existent pas</translation>
    </message>
    <message>
        <source>There is no file to open</source>
        <translation>Il n’y a pas de fichier à ouvrir</translation>
    </message>
    <message>
        <source>There is no organ to enclose</source>
        <translation>Il n’y a pas d’organe à entourer</translation>
    </message>
    <message>
        <source>There is no organ to make groups for</source>
        <translation>Il n’y a pas d’organe pour lequel former des groupes</translation>
    </message>
    <message>
        <source>There is no scan to close</source>
        <translation>Il n’y a pas d’examen à fermer</translation>
    </message>
    <message>
        <source>There is no stress map yet</source>
        <translation>Il n’y a pas encore de carte de contrainte</translation>
    </message>
    <message>
        <source>There is no such %1 any more</source>
        <translation>Cela n’existe plus : %1</translation>
    </message>
    <message>
        <source>There is no such handle any more</source>
        <translation>Cette poignée n’existe plus</translation>
    </message>
    <message>
        <source>There is no such organ any more</source>
        <translation>Cet organe n’existe plus</translation>
    </message>
    <message>
        <source>There is no such point</source>
        <translation>Ce point n’existe pas</translation>
    </message>
    <message>
        <source>There is no type of samples &quot;%1&quot;</source>
        <translation>Il n’y a pas de type d’échantillons « %1 »</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Épaississement</translation>
    </message>
    <message>
        <source>This kind of file is not supported</source>
        <translation>Ce type de fichier n’est pas pris en charge</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Transverse colon</source>
        <translation>Côlon transverse</translation>
    </message>
    <message>
        <source>Tricuspid valve, leak</source>
        <translation>Valve tricuspide, fuite</translation>
    </message>
    <message>
        <source>Tricuspid valve, open</source>
        <translation>Valve tricuspide, ouverture</translation>
    </message>
    <message>
        <source>Turns the directions at random; 0 leaves the icosahedron upright</source>
        <translation>Tourne les directions au hasard ; 0 laisse l’icosaèdre droit</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>Two handle files cannot be opened at a time</source>
        <translation>Deux fichiers de poignées ne peuvent pas être ouverts à la fois</translation>
    </message>
    <message>
        <source>Two handles are at one place</source>
        <translation>Deux poignées sont au même endroit</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Processus unciné</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Déverrouiller</translation>
    </message>
    <message>
        <source>Unlock volume</source>
        <translation>Déverrouiller le volume</translation>
    </message>
    <message numerus="yes">
        <source>Unlock {handle|%n handles}</source>
        <translation>
            <numerusform>Déverrouiller la poignée</numerusform>
            <numerusform>Déverrouiller %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Upper pole</source>
        <translation>Pôle supérieur</translation>
    </message>
    <message>
        <source>Ureter</source>
        <translation>Uretère</translation>
    </message>
    <message>
        <source>Urinary system</source>
        <translation>Système urinaire</translation>
    </message>
    <message>
        <source>Use the hull as the cage</source>
        <translation>Utiliser l’enveloppe comme cage</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Veines</translation>
    </message>
    <message>
        <source>Viscera:</source>
        <translation>Viscera :</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Rapport de volume</translation>
    </message>
    <message>
        <source>VolumeRatio</source>
        <translation>VolumeRatio</translation>
    </message>
    <message>
        <source>Voronoi regions triangulation</source>
        <translation>Triangulation des régions de Voronoï</translation>
    </message>
    <message>
        <source>Wachspress</source>
        <translation>Wachspress</translation>
    </message>
    <message>
        <source>Weights of least bending between 0 and 1; smooth and local, and follow translations only</source>
        <translation>Poids de flexion minimale entre 0 et 1 ; lisses et locaux, ne suivent que les translations</translation>
    </message>
    <message>
        <source>What is added to every weight when a handle comes in</source>
        <translation>Ce qui est ajouté à chaque poids quand une poignée arrive</translation>
    </message>
    <message>
        <source>What is done about negative numbers</source>
        <translation>Traitement des nombres négatifs</translation>
    </message>
    <message>
        <source>What the hull is divided into</source>
        <translation>En quoi l’enveloppe est divisée</translation>
    </message>
    <message>
        <source>What the pericardium holds without pressing</source>
        <translation>Ce que le péricarde contient sans comprimer</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Quand cesse la montée du plus petit nombre</translation>
    </message>
    <message>
        <source>Where 'iterative' moves the target</source>
        <translation>Où « iterative » déplace la cible</translation>
    </message>
    <message>
        <source>Where waves arise, about a third of the way down</source>
        <translation>Où naissent les ondes, environ au tiers supérieur</translation>
    </message>
    <message>
        <source>Wire approach</source>
        <translation>Méthode du fil</translation>
    </message>
    <message>
        <source>Witness</source>
        <translation>Témoin</translation>
    </message>
    <message>
        <source>Witness points of %1</source>
        <translation>Points témoins de %1</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>une cage est une surface grossière : prenez-en une de %1 sommets au plus</translation>
    </message>
    <message>
        <source>a coarse surface needs at least four vertices</source>
        <translation>une surface grossière demande au moins quatre sommets</translation>
    </message>
    <message>
        <source>a convex hull needs at least 4 points, there are %1</source>
        <translation>une enveloppe convexe demande au moins 4 points, il y en a %1</translation>
    </message>
    <message>
        <source>a displacement</source>
        <translation>un déplacement</translation>
    </message>
    <message>
        <source>a distance grid of this spacing is too large</source>
        <translation>une grille de distances de ce pas est trop grande</translation>
    </message>
    <message>
        <source>a handle of a recorded key</source>
        <translation>une poignée d’une clé enregistrée</translation>
    </message>
    <message>
        <source>a part of the scan is on no organ</source>
        <translation>une partie de l’examen n’est sur aucun organe</translation>
    </message>
    <message>
        <source>a point of its surface</source>
        <translation>un point de sa surface</translation>
    </message>
    <message>
        <source>a recorded key</source>
        <translation>une clé enregistrée</translation>
    </message>
    <message>
        <source>a remark on it is not UTF-8</source>
        <translation>une remarque à son sujet n’est pas en UTF-8</translation>
    </message>
    <message>
        <source>a surface without triangles has no inside</source>
        <translation>une surface sans triangles n’a pas d’intérieur</translation>
    </message>
    <message>
        <source>a triangle has a handle at two corners</source>
        <translation>un triangle a une poignée à deux coins</translation>
    </message>
    <message>
        <source>a triangle names a handle that is not there</source>
        <translation>un triangle nomme une poignée qui n’existe pas</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>ajoutez des poignées, ou placez-les automatiquement</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>ajoutée par le groupement automatique</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>tous les points sont dans un même plan</translation>
    </message>
    <message>
        <source>an angle has three points, any other measurement two</source>
        <translation>un angle a trois points, toute autre mesure deux</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>antrum</source>
        <translation>antre</translation>
    </message>
    <message>
        <source>atrial systole</source>
        <translation>systole auriculaire</translation>
    </message>
    <message>
        <source>bind it first</source>
        <translation>liez-le d’abord</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ne peut pas être ouvert : %1</translation>
    </message>
    <message>
        <source>cannot place %1 witness points</source>
        <translation>impossible de placer %1 points témoins</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>débit cardiaque</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>vérifiez l’unité ; les coordonnées sont en mm</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>vérifiez le nom</translation>
    </message>
    <message>
        <source>choose %1 to %2</source>
        <translation>choisissez de %1 à %2</translation>
    </message>
    <message>
        <source>choose a closed surface</source>
        <translation>choisissez une surface fermée</translation>
    </message>
    <message>
        <source>choose a file that Viscera has saved as .viscera</source>
        <translation>choisissez un fichier que Viscera a enregistré en .viscera</translation>
    </message>
    <message>
        <source>choose a file with a triangle surface</source>
        <translation>choisissez un fichier avec une surface de triangles</translation>
    </message>
    <message>
        <source>choose a larger spacing</source>
        <translation>choisissez un pas plus grand</translation>
    </message>
    <message>
        <source>choose a volume nearer to the present one, or let more handles compensate</source>
        <translation>choisissez un volume plus proche de l’actuel, ou laissez compenser plus de poignées</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>choisissez-en un autre</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>choisissez l’un d’eux</translation>
    </message>
    <message>
        <source>choose organ, axis or cluster</source>
        <translation>choisissez organ, axis ou cluster</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>choisissez deux extrémités d’une même surface</translation>
    </message>
    <message>
        <source>circulation that was kept</source>
        <translation>circulation gardée</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>fermez d’abord ses trous</translation>
    </message>
    <message>
        <source>close other programs, or work with fewer organs or coarser surfaces</source>
        <translation>fermez d’autres programmes, ou travaillez avec moins d’organes ou des surfaces plus grossières</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>les coordonnées demandent au moins quatre poignées, il y en a %1</translation>
    </message>
    <message>
        <source>diastasis</source>
        <translation>diastasis</translation>
    </message>
    <message>
        <source>diastole</source>
        <translation>diastole</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>does not lie between 0 and 1</source>
        <translation>n’est pas entre 0 et 1</translation>
    </message>
    <message>
        <source>ejection fraction</source>
        <translation>fraction d’éjection</translation>
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
        <source>expiration</source>
        <translation>expiration</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>exportez de nouveau la surface</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>remplissage de l’organe par des tétraèdres</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>fundus</translation>
    </message>
    <message>
        <source>give it another one</source>
        <translation>donnez-lui-en un autre</translation>
    </message>
    <message>
        <source>give it one</source>
        <translation>donnez-lui-en un</translation>
    </message>
    <message>
        <source>group</source>
        <translation>groupe</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>groupe %1</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>poignée</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>poignée %1</translation>
    </message>
    <message>
        <source>handles %1 and %2</source>
        <translation>poignées %1 et %2</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>maintien</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>inspiration</translation>
    </message>
    <message>
        <source>isovolumic contraction</source>
        <translation>contraction isovolumique</translation>
    </message>
    <message>
        <source>isovolumic relaxation</source>
        <translation>relaxation isovolumique</translation>
    </message>
    <message>
        <source>it does not lie within the period</source>
        <translation>elle n’est pas dans la période</translation>
    </message>
    <message>
        <source>it follows no handles, so nothing can change its volume</source>
        <translation>il ne suit aucune poignée, rien ne peut donc changer son volume</translation>
    </message>
    <message>
        <source>it has %1 triangles</source>
        <translation>elle a %1 triangles</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>il n’a pas de nom</translation>
    </message>
    <message>
        <source>it is not a millisecond at least behind the key before it</source>
        <translation>elle n’est pas au moins une milliseconde après la clé précédente</translation>
    </message>
    <message>
        <source>its colour does not lie between 0 and 1</source>
        <translation>sa couleur n’est pas entre 0 et 1</translation>
    </message>
    <message>
        <source>its description is not UTF-8</source>
        <translation>sa description n’est pas en UTF-8</translation>
    </message>
    <message>
        <source>its file %1 is not there any more (put it beside the session and open that again)</source>
        <translation>son fichier %1 n’est plus là (mettez-le à côté de la session et rouvrez-la)</translation>
    </message>
    <message>
        <source>its file was found as %1</source>
        <translation>son fichier a été trouvé sous %1</translation>
    </message>
    <message>
        <source>its handles are not handles of the rig, each once and in their order</source>
        <translation>ses poignées ne sont pas celles de l’ensemble, chacune une fois et dans l’ordre</translation>
    </message>
    <message>
        <source>its id is another thing's, too</source>
        <translation>son identifiant est aussi celui d’autre chose</translation>
    </message>
    <message>
        <source>its id is not a whole number from 1 to 2^52</source>
        <translation>son identifiant n’est pas un entier de 1 à 2^52</translation>
    </message>
    <message>
        <source>its name is not UTF-8</source>
        <translation>son nom n’est pas en UTF-8</translation>
    </message>
    <message>
        <source>its opacity does not lie between 0 and 1</source>
        <translation>son opacité n’est pas entre 0 et 1</translation>
    </message>
    <message>
        <source>its parent is not an organ before it</source>
        <translation>son organe parent n’est pas avant lui</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>sa position</translation>
    </message>
    <message>
        <source>its position at rest</source>
        <translation>sa position au repos</translation>
    </message>
    <message>
        <source>its surface is open, so it has no volume that could be locked</source>
        <translation>sa surface est ouverte, elle n’a donc pas de volume à verrouiller</translation>
    </message>
    <message numerus="yes">
        <source>its surface was closed by %n {cap|caps}</source>
        <translation>
            <numerusform>sa surface a été fermée par %n couvercle</numerusform>
            <numerusform>sa surface a été fermée par %n couvercles</numerusform>
        </translation>
    </message>
    <message>
        <source>its triangles were turned around to face outward</source>
        <translation>ses triangles ont été retournés vers l’extérieur</translation>
    </message>
    <message>
        <source>its two ends are at one place</source>
        <translation>ses deux extrémités sont au même endroit</translation>
    </message>
    <message>
        <source>its two ends are on separate pieces</source>
        <translation>ses deux extrémités sont sur des morceaux séparés</translation>
    </message>
    <message>
        <source>its value is not a finite number</source>
        <translation>sa valeur n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>its volume can be kept only when it is bound to the handles there are</source>
        <translation>son volume ne peut être gardé que s’il est lié aux poignées présentes</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>son volume n’est plus verrouillé : la surface est maintenant ouverte</translation>
    </message>
    <message>
        <source>its weights are no place in a triangle: they have to be 0 at least, and 1 together</source>
        <translation>ses poids ne sont pas un lieu d’un triangle : ils doivent être d’au moins 0, et 1 ensemble</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>allongez d’abord la période</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>mesure</translation>
    </message>
    <message>
        <source>measurement %1</source>
        <translation>mesure %1</translation>
    </message>
    <message>
        <source>middle line</source>
        <translation>ligne médiane</translation>
    </message>
    <message>
        <source>move it elsewhere, or remove one of the two</source>
        <translation>déplacez-la, ou retirez l’une des deux</translation>
    </message>
    <message>
        <source>move one out of the plane</source>
        <translation>déplacez-en un hors du plan</translation>
    </message>
    <message>
        <source>move or remove one of them</source>
        <translation>déplacez ou retirez l’une d’elles</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>écartez les sommets à cet endroit, ou prenez une autre cage</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>nommez-le %1</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>aucune arête ne joint plus de deux triangles</translation>
    </message>
    <message>
        <source>no harmonic function can be found on the surface</source>
        <translation>aucune fonction harmonique ne se trouve sur la surface</translation>
    </message>
    <message>
        <source>no motion near to this one keeps the volume</source>
        <translation>aucun mouvement proche de celui-ci ne garde le volume</translation>
    </message>
    <message>
        <source>no surface has so many triangles</source>
        <translation>aucune surface n’a autant de triangles</translation>
    </message>
    <message>
        <source>one of its points</source>
        <translation>un de ses points</translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>ouvrez-le à côté des organes (Fichier &gt; Ouvrir un examen), ou faites-en d’abord une carte d’étiquettes, avec 3D Slicer ou TotalSegmentator</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>ouvrez-en un d’abord</translation>
    </message>
    <message>
        <source>open the other files after it</source>
        <translation>ouvrez les autres fichiers ensuite</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>organe</translation>
    </message>
    <message>
        <source>organ %1</source>
        <translation>organe %1</translation>
    </message>
    <message>
        <source>out</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>paramètre %1</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pause</translation>
    </message>
    <message>
        <source>peak stress over the sequence</source>
        <translation>contrainte maximale sur la séquence</translation>
    </message>
    <message>
        <source>pick the point on the surface again</source>
        <translation>choisissez de nouveau le point sur la surface</translation>
    </message>
    <message>
        <source>place handles around it</source>
        <translation>placez des poignées autour</translation>
    </message>
    <message>
        <source>place some first</source>
        <translation>placez-en d’abord</translation>
    </message>
    <message>
        <source>point %1 has a coordinate that is not a finite number</source>
        <translation>le point %1 a une coordonnée qui n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>des points confondus ou presque plans en sont la cause</translation>
    </message>
    <message>
        <source>pylorus</source>
        <translation>pylore</translation>
    </message>
    <message>
        <source>rapid ejection</source>
        <translation>éjection rapide</translation>
    </message>
    <message>
        <source>rapid filling</source>
        <translation>remplissage rapide</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>éjection lente</translation>
    </message>
    <message>
        <source>remove one of them from the file</source>
        <translation>retirez l’une d’elles du fichier</translation>
    </message>
    <message>
        <source>repair the surface</source>
        <translation>réparez la surface</translation>
    </message>
    <message>
        <source>repair the surface in another program first</source>
        <translation>réparez d’abord la surface dans un autre programme</translation>
    </message>
    <message>
        <source>repaired on import: %1</source>
        <translation>réparé à l’importation : %1</translation>
    </message>
    <message>
        <source>repairing the surface</source>
        <translation>réparation de la surface</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>droite et gauche sont échangées, avant et arrière non : en miroir</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>enregistrez-le d’abord dans un fichier à part</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>enregistrez souvent, ou faites-y de la place</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>douce</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>volume d’éjection systolique</translation>
    </message>
    <message>
        <source>systole</source>
        <translation>systole</translation>
    </message>
    <message>
        <source>take a backup of the file, or begin a new session with the organs' own files</source>
        <translation>prenez une sauvegarde du fichier, ou commencez une nouvelle session avec les fichiers des organes</translation>
    </message>
    <message>
        <source>take the sequence's own handles</source>
        <translation>prenez les poignées de la séquence</translation>
    </message>
    <message>
        <source>terminal antral contraction</source>
        <translation>contraction antrale terminale</translation>
    </message>
    <message>
        <source>the Delaunay tetrahedra of %1 points cannot be computed</source>
        <translation>les tétraèdres de Delaunay de %1 points ne peuvent pas être calculés</translation>
    </message>
    <message>
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>l’enveloppe convexe de %1 points ne peut pas être calculée</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>le fichier n’indique pas ses axes : LPS est supposé</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>le fichier indique ses axes : %1</translation>
    </message>
    <message>
        <source>the handle %1 comes twice</source>
        <translation>la poignée %1 apparaît deux fois</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>les poignées n’entourent rien : %1</translation>
    </message>
    <message>
        <source>the id %1 comes twice</source>
        <translation>l’identifiant %1 apparaît deux fois</translation>
    </message>
    <message>
        <source>the limits of time and memory must be above 0</source>
        <translation>les limites de temps et de mémoire doivent être supérieures à 0</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>le nom d’un fichier de session se termine par .viscera</translation>
    </message>
    <message>
        <source>the organ that it is a cavity of is not before it</source>
        <translation>l’organe dont il est une cavité n’est pas avant lui</translation>
    </message>
    <message>
        <source>the parts of its colour do not lie between 0 and 1</source>
        <translation>les parts de sa couleur ne sont pas entre 0 et 1</translation>
    </message>
    <message>
        <source>the period is not a positive number of seconds</source>
        <translation>la période n’est pas un nombre positif de secondes</translation>
    </message>
    <message>
        <source>the pose has another number of handles than the document</source>
        <translation>la pose n’a pas le même nombre de poignées que le document</translation>
    </message>
    <message>
        <source>the quality of tetrahedra is a ratio from 1.1 (best) to 10</source>
        <translation>la qualité des tétraèdres est un rapport de 1,1 (meilleur) à 10</translation>
    </message>
    <message>
        <source>the scan %1 is not there any more (put it beside the session and open that again)</source>
        <translation>l’examen %1 n’est plus là (mettez-le à côté de la session et rouvrez-la)</translation>
    </message>
    <message>
        <source>the scan cannot be opened: %1</source>
        <translation>l’examen ne peut pas être ouverte : %1</translation>
    </message>
    <message>
        <source>the size is plausible: %1</source>
        <translation>la taille est plausible : %1</translation>
    </message>
    <message>
        <source>the surface consists of %1 separate pieces</source>
        <translation>la surface se compose de %1 morceaux séparés</translation>
    </message>
    <message>
        <source>the surface does not cross itself</source>
        <translation>la surface ne se traverse pas</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>la surface a %1 triangles utilisables, elle n’enferme donc rien</translation>
    </message>
    <message>
        <source>the surface has no such triangle</source>
        <translation>la surface n’a pas ce triangle</translation>
    </message>
    <message>
        <source>the surface is closed</source>
        <translation>la surface est fermée</translation>
    </message>
    <message>
        <source>the surface is inside out</source>
        <translation>la surface est à l’envers</translation>
    </message>
    <message>
        <source>the surface is of one piece</source>
        <translation>la surface est d’un seul morceau</translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume</source>
        <translation>
            <numerusform>la surface est ouverte (%n arête de bord), elle n’a donc pas de volume</numerusform>
            <numerusform>la surface est ouverte (%n arêtes de bord), elle n’a donc pas de volume</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked</source>
        <translation>
            <numerusform>la surface est ouverte (%n arête de bord), elle n’a donc pas de volume à verrouiller</numerusform>
            <numerusform>la surface est ouverte (%n arêtes de bord), elle n’a donc pas de volume à verrouiller</numerusform>
        </translation>
    </message>
    <message>
        <source>the triangles beside a hole do not all run the same way round, so it cannot be closed</source>
        <translation>les triangles autour d’un trou ne tournent pas tous dans le même sens, il ne peut donc pas être fermé</translation>
    </message>
    <message>
        <source>the triangles face outward</source>
        <translation>les triangles sont tournés vers l’extérieur</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>le volume ne peut pas être gardé ici : %1</translation>
    </message>
    <message>
        <source>the weights of a measured point are no place in its triangle</source>
        <translation>les poids d’un point mesuré ne sont pas un lieu de son triangle</translation>
    </message>
    <message>
        <source>there is no %1 &quot;%2&quot;</source>
        <translation>« %2 » n’est pas une valeur de %1</translation>
    </message>
    <message>
        <source>there is no organ %1</source>
        <translation>il n’y a pas d’organe %1</translation>
    </message>
    <message>
        <source>there is no such slice</source>
        <translation>cette coupe n’existe pas</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>il n’y a pas de triangle %1</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to make groups</source>
        <translation>il n’y a pas de façon « %1 » de former des groupes</translation>
    </message>
    <message>
        <source>there is not enough memory for this</source>
        <translation>il n’y a pas assez de mémoire pour cela</translation>
    </message>
    <message>
        <source>thinning out the surface</source>
        <translation>simplification de la surface</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>c’est une faute du programme ; merci de la signaler</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>triangle %1</translation>
    </message>
    <message>
        <source>triangle %1 refers to vertex %2, but there are %3</source>
        <translation>le triangle %1 renvoie au sommet %2, mais il y en a %3</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>deux groupes ont ce nom</translation>
    </message>
    <message>
        <source>two handles are at one place</source>
        <translation>deux poignées sont au même endroit</translation>
    </message>
    <message>
        <source>two handles have this label</source>
        <translation>deux poignées portent ce nom</translation>
    </message>
    <message>
        <source>unlock it, or let more handles compensate</source>
        <translation>déverrouillez-le, ou laissez compenser plus de poignées</translation>
    </message>
    <message>
        <source>unsaved work</source>
        <translation>travail non enregistré</translation>
    </message>
    <message>
        <source>unsaved work cannot be kept safe: the folder cannot be written to</source>
        <translation>le travail non enregistré ne peut pas être protégé : le dossier n’est pas accessible en écriture</translation>
    </message>
    <message>
        <source>update Viscera</source>
        <translation>mettez Viscera à jour</translation>
    </message>
    <message>
        <source>use a pose of the same handles</source>
        <translation>prenez une pose des mêmes poignées</translation>
    </message>
    <message>
        <source>use one of %1</source>
        <translation>utilisez l’un de %1</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>utilisez l’un de : %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>sommet %1</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that is not a finite number</source>
        <translation>le sommet %1 a une coordonnée qui n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>volume after a meal</source>
        <translation>volume après un repas</translation>
    </message>
    <message>
        <source>volume of the muscle</source>
        <translation>volume du muscle</translation>
    </message>
    <message>
        <source>volume with its blood</source>
        <translation>volume avec son sang</translation>
    </message>
    <message>
        <source>wait a moment</source>
        <translation>attendez un instant</translation>
    </message>
    <message>
        <source>wait until the witness points are there</source>
        <translation>attendez que les points témoins soient là</translation>
    </message>
    <message>
        <source>wave fades at the pylorus</source>
        <translation>l’onde s’éteint au pylore</translation>
    </message>
    <message>
        <source>wave in the antrum</source>
        <translation>onde dans l’antre</translation>
    </message>
    <message>
        <source>wave in the body</source>
        <translation>onde dans le corps</translation>
    </message>
    <message>
        <source>what is measured on it is now at the nearest places of that surface</source>
        <translation>ce qui y est mesuré est maintenant aux endroits les plus proches de cette surface</translation>
    </message>
    <message>
        <source>witness points</source>
        <translation>points témoins</translation>
    </message>
    <message>
        <source>Pin stress probe</source>
        <translation>Fixer une sonde de contrainte</translation>
    </message>
    <message>
        <source>Draw stress profile</source>
        <translation>Tracer un profil de contrainte</translation>
    </message>
    <message>
        <source>Remove stress profile</source>
        <translation>Supprimer un profil de contrainte</translation>
    </message>
    <message>
        <source>Remove all stress probes</source>
        <translation>Supprimer toutes les sondes de contrainte</translation>
    </message>
    <message numerus="yes">
        <source>Remove {stress probe|%n stress probes}</source>
        <translation>
            <numerusform>Supprimer une sonde de contrainte</numerusform>
            <numerusform>Supprimer %n sondes de contrainte</numerusform>
        </translation>
    </message>
    <message>
        <source>stress probe %1</source>
        <translation>sonde de contrainte %1</translation>
    </message>
    <message>
        <source>stress line %1</source>
        <translation>ligne de contrainte %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>sonde de contrainte</translation>
    </message>
    <message>
        <source>stress line</source>
        <translation>ligne de contrainte</translation>
    </message>
    <message>
        <source>its number is not a whole number from 1</source>
        <translation>son numéro n’est pas un entier à partir de 1</translation>
    </message>
    <message>
        <source>two stress probes have this number</source>
        <translation>deux sondes de contrainte ont ce numéro</translation>
    </message>
    <message>
        <source>its place at rest</source>
        <translation>son lieu au repos</translation>
    </message>
    <message>
        <source>it does not join two stress probes of one organ</source>
        <translation>elle ne relie pas deux sondes de contrainte d’un organe</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Un profil demande deux sondes d’un organe</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Ces deux sondes ont déjà un profil</translation>
    </message>
</context>
</TS>
