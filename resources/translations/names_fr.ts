<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adulte sain couché.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Un quart du volume sanguin sous tension est perdu ; aucun réflexe ne répond, si bien que les pressions baissent plus qu’en réalité.</translation>
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
        <source>Add</source>
        <translation>Ajouter</translation>
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
        <source>Add to group</source>
        <translation>Ajouter au groupe</translation>
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
        <source>An organ needs at least four handles around it: add</source>
        <translation>Un organe demande au moins quatre poignées autour de lui : ajoutez</translation>
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
        <source>Binding</source>
        <translation>Liaison</translation>
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
        <source>Checking</source>
        <translation>Contrôle</translation>
    </message>
    <message>
        <source>Circulation:</source>
        <translation>Circulation :</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Fermer les trous</translation>
    </message>
    <message>
        <source>Colour group</source>
        <translation>Colorer le groupe</translation>
    </message>
    <message>
        <source>Compensate with</source>
        <translation>Compenser avec</translation>
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
    <message>
        <source>Describe</source>
        <translation>Décrire</translation>
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
        <source>Easing</source>
        <translation>Transition</translation>
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
        <source>Left atrium, scale of the relaxed curve</source>
        <translation>Atrium gauche, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the relaxed curve</source>
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
        <source>Left ventricle, scale of the relaxed curve</source>
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
        <source>Measure</source>
        <translation>Mesurer</translation>
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
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Déplacer la clé</translation>
    </message>
    <message>
        <source>Move measured point</source>
        <translation>Déplacer un point mesuré</translation>
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
        <source>Remove</source>
        <translation>Supprimer</translation>
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
        <source>Repairing</source>
        <translation>Réparation</translation>
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
        <source>Right atrium, scale of the relaxed curve</source>
        <translation>Atrium droit, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the relaxed curve</source>
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
        <source>Right ventricle, scale of the relaxed curve</source>
        <translation>Ventricule droit, échelle de la courbe relâchée</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the relaxed curve</source>
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
        <source>Set</source>
        <translation>Régler</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
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
    <message>
        <source>Stop compensating with</source>
        <translation>Ne plus compenser avec</translation>
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
        <source>Take the cage</source>
        <translation>Prendre la cage</translation>
    </message>
    <message>
        <source>Tamponade</source>
        <translation>Tamponnade</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle towers above that of the aorta.</source>
        <translation>La valve aortique s’ouvre à 0,8 cm2 : la pression du ventricule hypertrophié dépasse de loin celle de l’aorte.</translation>
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
        <source>The numbers to stay near to</source>
        <translation>Les nombres dont rester proche</translation>
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
        <source>The smallest number is raised as high as it goes; positive, with kinks</source>
        <translation>Le plus petit nombre est élevé autant que possible ; positif, avec des plis</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled.</source>
        <translation>La surface a été réparée avant d’être remplie.</translation>
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
        <source>The witness points lie on a regular grid inside the surface.</source>
        <translation>Les points témoins sont sur une grille régulière dans la surface.</translation>
    </message>
    <message>
        <source>There are</source>
        <translation>Il y a</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Épaississement</translation>
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
        <source>Witness points of</source>
        <translation>Points témoins de</translation>
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
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>cardiac output</source>
        <translation>débit cardiaque</translation>
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
        <source>fundus</source>
        <translation>fundus</translation>
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
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>out</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pause</translation>
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
        <source>reduced ejection</source>
        <translation>éjection lente</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>douce</translation>
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
        <source>terminal antral contraction</source>
        <translation>contraction antrale terminale</translation>
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
</context>
</TS>
