<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>viscera::presentation</name>
    <message>
        <source>%1 triangles instead of %2; the old surface lies %3 mm from the new one on average, %4 mm at most</source>
        <translation>%1 triangles au lieu de %2&#x202f;; l’ancienne surface est à %3 mm de la nouvelle en moyenne, à %4 mm au plus</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>«&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 and %2 are at one place: %3 from each other</source>
        <translation>%1 et %2 sont au même endroit&#xa0;: à %3 l’un de l’autre</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>%1 at %2 % of the cycle: %3</source>
        <translation>%1 à %2 % du cycle&#xa0;: %3</translation>
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
        <source>%1 has no volume in %2</source>
        <translation>%1 n’a pas de volume dans la %2</translation>
    </message>
    <message>
        <source>%1 has no voxels any more</source>
        <translation>%1 n’a plus de voxels</translation>
    </message>
    <message>
        <source>%1 has other triangles in %2 than in the first: surfaces are fitted by their distances, which do not see motion along the wall</source>
        <translation>%1 a dans la %2 d’autres triangles que dans la première&#xa0;: les surfaces sont ajustées par leurs distances, qui ne voient pas le mouvement le long de la paroi</translation>
    </message>
    <message>
        <source>%1 ml cannot be reached</source>
        <translation>%1 ml ne peuvent pas être atteints</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates</source>
        <translation>%1 sommets sur %2 n’ont pas de coordonnées</translation>
    </message>
    <message>
        <source>%1 of %2 vertices have no coordinates in the cage</source>
        <translation>%1 sommets sur %2 n’ont pas de coordonnées dans la cage</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie in no group's region</source>
        <translation>%1 sommets sur %2 ne sont dans la région d’aucun groupe</translation>
    </message>
    <message>
        <source>%1 of more than 1 GB cannot be kept in a session file</source>
        <translation>%1 de plus de 1 Go ne peut pas être gardé dans un fichier de session</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm around %7, %8, %9</source>
        <translation>%1 x %2 x %3 voxels de %4 x %5 x %6 mm autour de %7; %8; %9</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2 and not in others, so that its volumes would be cut off</source>
        <translation>%1 touche le bord de l’image dans la %2 et non dans d’autres, de sorte que ses volumes seraient tronqués</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in %2: what lies beyond is not in its volume</source>
        <translation>%1 touche le bord de l’image dans la %2&#xa0;: ce qui est au-delà n’est pas dans son volume</translation>
    </message>
    <message>
        <source>%1 touches the edge of the image in every phase: what lies beyond is not in its volume</source>
        <translation>%1 touche le bord de l’image dans chaque phase&#xa0;: ce qui est au-delà n’est pas dans son volume</translation>
    </message>
    <message numerus="yes">
        <source>%2, %n of them {is a small fragment|are small fragments} of less than 2 % of its area</source>
        <translation>
            <numerusform>%2, dont %n petit fragment de moins de 2 % de son aire</numerusform>
            <numerusform>%2, dont %n petits fragments de moins de 2 % de son aire</numerusform>
        </translation>
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
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2 lie outside the handles' hull, by up to %3 mm</source>
        <translation>%1&#xa0;: %2 sont hors de l’enveloppe des poignées, jusqu’à %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n {hole|holes} closed by {a flat cap|flat caps}</source>
        <translation>
            <numerusform>%1&#xa0;: %n trou fermé par un capuchon plat</numerusform>
            <numerusform>%1&#xa0;: %n trous fermés par des capuchons plats</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: nothing is known about &quot;%2&quot;; it will not be saved again</source>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» est inconnu et ne sera pas enregistré de nouveau</translation>
    </message>
    <message>
        <source>%1: points that coincide in the first phase separate by up to %2 mm; Viscera keeps them together</source>
        <translation>%1&#xa0;: des points confondus dans la première phase s’écartent jusqu’à %2 mm&#x202f;; Viscera les garde ensemble</translation>
    </message>
    <message>
        <source>%1; it looks like %2</source>
        <translation>%1&#x202f;; il semble être %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices were read, slices %3 to %4, which are even; the others, or all of them resampled, can be chosen as a series</source>
        <translation>%1 coupes sur %2 ont été lues, les coupes %3 à %4, régulières; les autres, ou toutes rééchantillonnées, peuvent être choisies comme série</translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest</source>
        <translation>
            <numerusform>%2 morceaux, %n voxel hors du plus grand</numerusform>
            <numerusform>%2 morceaux, %n voxels hors du plus grand</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 pieces, %n {voxel|voxels} besides the largest left out</source>
        <translation>
            <numerusform>%2 morceaux, %n voxel hors du plus grand omis</numerusform>
            <numerusform>%2 morceaux, %n voxels hors du plus grand omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%2 {lies|lie} outside of the scan; check whether both are of one patient and their files agree on the axes (RAS or LPS)</source>
        <translation>
            <numerusform>%2 se trouve hors de l’examen&#x202f;; vérifiez que les deux viennent du même patient et ont les mêmes axes (RAS ou LPS)</numerusform>
            <numerusform>%2 se trouvent hors de l’examen&#x202f;; vérifiez que tous viennent du même patient et ont les mêmes axes (RAS ou LPS)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary {edge|edges}: the surface is open and has no volume</source>
        <translation>
            <numerusform>%n arête de bord&#xa0;: la surface est ouverte et n’a pas de volume</numerusform>
            <numerusform>%n arêtes de bord&#xa0;: la surface est ouverte et n’a pas de volume</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the end ignored</source>
        <translation>
            <numerusform>%n octet après la fin ignoré</numerusform>
            <numerusform>%n octets après la fin ignorés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {byte|bytes} after the last triangle ignored</source>
        <translation>
            <numerusform>%n octet après le dernier triangle ignoré</numerusform>
            <numerusform>%n octets après le dernier triangle ignorés</numerusform>
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
        <source>%n {file is a copy|files are copies} of another one and left out</source>
        <translation>
            <numerusform>%n fichier est la copie d’un autre et est omis</numerusform>
            <numerusform>%n fichiers sont des copies d’un autre et sont omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {file is|files are} damaged and left out (%2: %3)</source>
        <translation>
            <numerusform>%n fichier est endommagé et omis (%2&#xa0;: %3)</numerusform>
            <numerusform>%n fichiers sont endommagés et omis (%2&#xa0;: %3)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is in no group and moves|handles are in no group and move} nothing</source>
        <translation>
            <numerusform>%n poignée n’est dans aucun groupe et ne déplace rien</numerusform>
            <numerusform>%n poignées ne sont dans aucun groupe et ne déplacent rien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle is|handles are} too few</source>
        <translation>
            <numerusform>%n poignée, c’est trop peu</numerusform>
            <numerusform>%n poignées, c’est trop peu</numerusform>
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
        <source>%n {handle|handles} cannot form %2 groups</source>
        <translation>
            <numerusform>%n poignée ne peut pas former %2 groupes</numerusform>
            <numerusform>%n poignées ne peuvent pas former %2 groupes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} whose label another one has got a new one</source>
        <translation>
            <numerusform>%n poignée dont une autre a l’étiquette en a reçu une nouvelle</numerusform>
            <numerusform>%n poignées dont une autre a l’étiquette en ont reçu une nouvelle</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {handle|handles} without a label got one</source>
        <translation>
            <numerusform>%n poignée sans étiquette en a reçu une</numerusform>
            <numerusform>%n poignées sans étiquette en ont reçu une</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line or point cell|line or point cells} ignored</source>
        <translation>
            <numerusform>%n cellule de ligne ou de point ignorée</numerusform>
            <numerusform>%n cellules de ligne ou de point ignorées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {line|lines} with points, curves or free-form surfaces ignored</source>
        <translation>
            <numerusform>%n ligne avec des points, courbes ou surfaces de forme libre ignorée</numerusform>
            <numerusform>%n lignes avec des points, courbes ou surfaces de forme libre ignorées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {mask is|masks are} empty (%2)</source>
        <translation>
            <numerusform>%n masque est vide (%2)</numerusform>
            <numerusform>%n masques sont vides (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {pair of triangles crosses|pairs of triangles cross} each other: stress mode may have to repair the surface first</source>
        <translation>
            <numerusform>%n paire de triangles se traverse&#xa0;: le mode de contrainte devra peut-être d’abord réparer la surface</numerusform>
            <numerusform>%n paires de triangles se traversent&#xa0;: le mode de contrainte devra peut-être d’abord réparer la surface</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series of another echo left out</source>
        <translation>
            <numerusform>%n image de la série d’un autre écho omise</numerusform>
            <numerusform>%n images de la série d’un autre écho omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {image|images} in the series that {lies|lie} in another direction left out</source>
        <translation>
            <numerusform>%n image de la série d’une autre direction omise</numerusform>
            <numerusform>%n images de la série d’une autre direction omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {place has|places have} more than one slice (%2); the one with the lowest number was read</source>
        <translation>
            <numerusform>%n position a plus d’une coupe (%2)&#x202f;; celle du plus petit numéro a été lue</numerusform>
            <numerusform>%n positions ont plus d’une coupe (%2)&#x202f;; celle du plus petit numéro a été lue</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that repeats|points that repeat} another merged</source>
        <translation>
            <numerusform>%n point qui en répète un autre fusionné</numerusform>
            <numerusform>%n points qui en répètent d’autres fusionnés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point|points} without a triangle dropped</source>
        <translation>
            <numerusform>%n point sans triangle omis</numerusform>
            <numerusform>%n points sans triangle omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} no voxels (%2)</source>
        <translation>
            <numerusform>%n segment n’a pas de voxels (%2)</numerusform>
            <numerusform>%n segments n’ont pas de voxels (%2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {set|sets} of points or lines ignored</source>
        <translation>
            <numerusform>%n ensemble de points ou de lignes ignoré</numerusform>
            <numerusform>%n ensembles de points ou de lignes ignorés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice is|slices are} missing between slice %2 (%3) and the next, which are %4 mm apart in place of %5 mm</source>
        <translation>
            <numerusform>il manque %n coupe entre la coupe %2 (%3) et la suivante, distantes de %4 mm au lieu de %5 mm</numerusform>
            <numerusform>il manque %n coupes entre la coupe %2 (%3) et la suivante, distantes de %4 mm au lieu de %5 mm</numerusform>
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
    <message numerus="yes">
        <source>%n {triangle|triangles} with a repeated corner dropped</source>
        <translation>
            <numerusform>%n triangle à sommet répété omis</numerusform>
            <numerusform>%n triangles à sommet répété omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex lies|vertices lie} outside the hull of the sequence's handles</source>
        <translation>
            <numerusform>%n sommet est hors de l’enveloppe des poignées de la séquence</numerusform>
            <numerusform>%n sommets sont hors de l’enveloppe des poignées de la séquence</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {vertex|vertices} cannot be divided among %2 groups</source>
        <translation>
            <numerusform>%n sommet ne peut pas être réparti entre %2 groupes</numerusform>
            <numerusform>%n sommets ne peuvent pas être répartis entre %2 groupes</numerusform>
        </translation>
    </message>
    <message>
        <source>0 starts from all ones, others from random numbers</source>
        <translation>0 part de poids tous égaux à 1, les autres de nombres aléatoires</translation>
    </message>
    <message>
        <source>19 of 20 adults have %1 to %2 ml</source>
        <translation>19 adultes sur 20 ont de %1 à %2 ml</translation>
    </message>
    <message>
        <source>A healthy adult lying down.</source>
        <translation>Un adulte sain couché.</translation>
    </message>
    <message>
        <source>A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than in life.</source>
        <translation>Un quart du volume sanguin contraint est perdu&#x202f;; aucun réflexe ne répond, si bien que les pressions baissent plus qu’en réalité.</translation>
    </message>
    <message>
        <source>A session cannot be opened beside another</source>
        <translation>Une session ne peut pas être ouverte à côté d’une autre</translation>
    </message>
    <message>
        <source>A session is opened alone</source>
        <translation>Une session s’ouvre seule</translation>
    </message>
    <message>
        <source>A slice cannot be read, so the series is not opened: %1</source>
        <translation>Une coupe ne peut pas être lue, la série n’est donc pas ouverte&#xa0;: %1</translation>
    </message>
    <message>
        <source>A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.</source>
        <translation>Un ventricule gauche rigide qui se relâche lentement&#xa0;: il se vide bien et ne se remplit qu’à haute pression.</translation>
    </message>
    <message>
        <source>A ventricle's volume is not positive</source>
        <translation>Le volume d’un ventricule n’est pas positif</translation>
    </message>
    <message>
        <source>A weak, dilated left ventricle and retained fluid: the loop lies far to the right, blood backs up to the lungs. Its wall has more muscle and is no thicker.</source>
        <translation>Un ventricule gauche faible et dilaté et une rétention de liquide&#xa0;: la boucle est loin à droite, le sang reflue vers les poumons. Sa paroi a plus de muscle sans être plus épaisse.</translation>
    </message>
    <message>
        <source>A wire in the space of balanced vectors; for many points it has no answer</source>
        <translation>Un fil dans l’espace des vecteurs équilibrés&#x202f;; pour beaucoup de points il n’a pas de réponse</translation>
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
        <translation>Postcharge&#xa0;: résistance pulmonaire</translation>
    </message>
    <message>
        <source>Afterload: systemic resistance</source>
        <translation>Postcharge&#xa0;: résistance systémique</translation>
    </message>
    <message>
        <source>An ejection fraction of %1 is out of range</source>
        <translation>Une fraction d’éjection de %1 est hors limites</translation>
    </message>
    <message>
        <source>An organ needs at least four handles around it: add %1 more</source>
        <translation>Un organe a besoin d’au moins quatre poignées autour de lui&#xa0;: ajoutez-en encore %1</translation>
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
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Balanced weights nearest to a target; a parameter says how negative weights are treated</source>
        <translation>Poids en équilibre, les plus proches d’une cible&#x202f;; un paramètre indique comment les poids négatifs sont traités</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Warping the image</source>
        <translation>Déformation de l’image</translation>
    </message>
    <message>
        <source>Warping the scan</source>
        <translation>Déformation de l’examen</translation>
    </message>
    <message>
        <source>Warped</source>
        <translation>Déformé</translation>
    </message>
    <message>
        <source>Beyond the data: people were measured from 50 to 171 beats a minute</source>
        <translation>Au-delà des données&#xa0;: mesures faites de 50 à 171 battements par minute</translation>
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
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Heartbeat: %1</source>
        <translation>Battement du cœur&#xa0;: %1</translation>
    </message>
    <message>
        <source>LV (ml)</source>
        <translation>VG (ml)</translation>
    </message>
    <message>
        <source>Preparing the volume lock</source>
        <translation>Préparation du verrouillage du volume</translation>
    </message>
    <message>
        <source>Binding the space between the handles</source>
        <translation>Liaison de l’espace entre les poignées</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>Blue to red</source>
        <translation>Du bleu au rouge</translation>
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
        <translation>Bradygastrie&#xa0;: les personnes saines ont 2 à 4 ondes par minute.</translation>
    </message>
    <message>
        <source>Breathing</source>
        <translation>Respiration</translation>
    </message>
    <message>
        <source>By corners and normals of a cage of any shape; nearly keeps angles, and does not interpolate its handles</source>
        <translation>Par les coins et les normales d’une cage de forme quelconque&#x202f;; conserve presque les angles, et n’interpole pas ses poignées</translation>
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
        <translation>Ligne centrale</translation>
    </message>
    <message>
        <source>Centroid of all positive solutions, estimated by sampling; more samples are more accurate</source>
        <translation>Centroïde de toutes les solutions positives, estimé par échantillonnage&#x202f;; plus d’échantillons sont plus exacts</translation>
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
        <source>Change key sequence</source>
        <translation>Modifier la séquence de clés</translation>
    </message>
    <message>
        <source>Checking %1</source>
        <translation>Vérification de %1</translation>
    </message>
    <message>
        <source>Circulation: %1</source>
        <translation>Circulation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
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
        <source>Connection</source>
        <translation>Connexion</translation>
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
        <source>Inner</source>
        <translation>Intérieur</translation>
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
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Locality</source>
        <translation>Localité</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Partitions</source>
        <translation>Partitions</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Polyhedra</source>
        <translation>Polyèdres</translation>
    </message>
    <message>
        <source>Positivity</source>
        <translation>Positivité</translation>
    </message>
    <message>
        <source>RV (ml)</source>
        <translation>VD (ml)</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Stress over the cycle</source>
        <translation>Contrainte sur le cycle</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfert</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
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
        <source>Distance from a zone within which its super-region still counts: smoothness against locality</source>
        <translation>Distance à une zone jusqu’à laquelle sa super-région compte encore&#xa0;: régularité contre localité</translation>
    </message>
    <message>
        <source>Distance over which the pull of a handle is rounded; 0 passes through the handles</source>
        <translation>Distance sur laquelle la traction d’une poignée est arrondie&#x202f;; 0 passe par les poignées</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^level rays</source>
        <translation>Divisions de l’icosaèdre&#xa0;: 20 * 4^niveau rayons</translation>
    </message>
    <message>
        <source>Divisions of the icosahedron: 20 * 4^samples directions</source>
        <translation>Divisions de l’icosaèdre&#xa0;: 20 * 4^échantillons directions</translation>
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
        <translation>Arêtes de tétraèdres à travers les poignées&#x202f;; davantage est plus fin et plus lent</translation>
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
        <source>ESPVR and EDPVR</source>
        <translation>ESPVR et EDPVR</translation>
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
        <source>Added volume that multiplies pericardial pressure by e</source>
        <translation>Volume qui multiplie par e la pression péricardique</translation>
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
        <translation>Du liquide dans le péricarde comprime toutes les cavités&#xa0;: elles se remplissent peu, et toutes les pressions de remplissage sont égales.</translation>
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
        <source>Discard kept circulation</source>
        <translation>Abandonner la circulation gardée</translation>
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
        <source>Grey</source>
        <translation>Gris</translation>
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
        <translation>Les groupes de poignées ne déplacent que leur région de l’organe&#x202f;; les régions voisines se fondent sans heurt.</translation>
    </message>
    <message>
        <source>Haemorrhage</source>
        <translation>Hémorragie</translation>
    </message>
    <message>
        <source>Hard upright work: a fast and strong heart, open muscle vessels, veins that give blood back.</source>
        <translation>Travail intense debout&#xa0;: un cœur rapide et fort, des vaisseaux musculaires ouverts, des veines qui rendent du sang.</translation>
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
        <translation>Le cœur suit le battement de référence</translation>
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
            <numerusform>Masquer la poignée</numerusform>
            <numerusform>Masquer %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>How far beyond the handles' hull the weights are computed</source>
        <translation>Jusqu’où au-delà de l’enveloppe des poignées les poids sont calculés</translation>
    </message>
    <message>
        <source>How much nearer handles count more; 0 as in the thesis</source>
        <translation>Combien les poignées proches comptent davantage&#x202f;; 0 comme dans la thèse</translation>
    </message>
    <message>
        <source>How near to a flip the two triangulations are blended; 0 for not</source>
        <translation>À quelle distance d’un basculement les deux triangulations sont mêlées&#x202f;; 0 pour jamais</translation>
    </message>
    <message>
        <source>Method that finds positive balanced vectors</source>
        <translation>Méthode qui trouve des vecteurs équilibrés positifs</translation>
    </message>
    <message>
        <source>How the Voronoi vertices' weights reach the handles</source>
        <translation>Comment les poids des sommets de Voronoï atteignent les poignées</translation>
    </message>
    <message>
        <source>Order in which the wire connects the points</source>
        <translation>Ordre dans lequel le fil relie les points</translation>
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
        <source>Inferno</source>
        <translation>Inferno</translation>
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
        <source>Internal error of an unknown kind</source>
        <translation>Erreur interne d’un genre inconnu</translation>
    </message>
    <message>
        <source>Internal error: %1</source>
        <translation>Erreur interne&#xa0;: %1</translation>
    </message>
    <message>
        <source>It cannot be opened: %1</source>
        <translation>Impossible de l’ouvrir&#xa0;: %1</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>Il est illisible</translation>
    </message>
    <message>
        <source>It cannot be read to its end</source>
        <translation>Il ne peut pas être lu jusqu’à la fin</translation>
    </message>
    <message>
        <source>It cannot be written: %1</source>
        <translation>Impossible de l’écrire&#xa0;: %1</translation>
    </message>
    <message>
        <source>It cannot be written: it is a folder</source>
        <translation>Impossible de l’écrire&#xa0;: c’est un dossier</translation>
    </message>
    <message numerus="yes">
        <source>It crosses itself, at %n {pair|pairs} of triangles</source>
        <translation>
            <numerusform>Elle se traverse elle-même, à %n paire de triangles</numerusform>
            <numerusform>Elle se traverse elle-même, à %n paires de triangles</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not fit into memory</source>
        <translation>il ne tient pas en mémoire</translation>
    </message>
    <message>
        <source>The duration of one cycle is unknown</source>
        <translation>La durée d’un cycle est inconnue</translation>
    </message>
    <message numerus="yes">
        <source>It does not say the times of its %n {phase|phases}; they are numbered</source>
        <translation>
            <numerusform>L’instant de sa %n phase n’est pas indiqué&#x202f;; elle est numérotée</numerusform>
            <numerusform>Les instants de ses %n phases ne sont pas indiqués&#x202f;; elles sont numérotées</numerusform>
        </translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as milliseconds</source>
        <translation>L’unité de ses temps n’est pas indiquée&#x202f;; ils sont pris en millisecondes</translation>
    </message>
    <message>
        <source>It has %1 labels; a mask in a folder has one</source>
        <translation>Il a %1 étiquettes&#x202f;; un masque d’un dossier en a une</translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a region needs at least 4</source>
        <translation>
            <numerusform>Il a %n poignée&#x202f;; une région en demande au moins 4</numerusform>
            <numerusform>Il a %n poignées&#x202f;; une région en demande au moins 4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {handle|handles}; a sequence needs four at least</source>
        <translation>
            <numerusform>Il y a %n poignée&#x202f;; une séquence en demande au moins quatre</numerusform>
            <numerusform>Il y a %n poignées&#x202f;; une séquence en demande au moins quatre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It has %n {phase|phases}; a motion needs four at least</source>
        <translation>
            <numerusform>Il y a %n phase&#x202f;; un mouvement en demande au moins quatre</numerusform>
            <numerusform>Il y a %n phases&#x202f;; un mouvement en demande au moins quatre</numerusform>
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
        <source>It has a label above 2147483647</source>
        <translation>Elle a une étiquette au-dessus de 2147483647</translation>
    </message>
    <message>
        <source>It has more than %1 files</source>
        <translation>Il a plus de %1 fichiers</translation>
    </message>
    <message>
        <source>It has more than 32767 voxels along a side, which NIfTI cannot hold</source>
        <translation>Elle a plus de 32767 voxels le long d’un côté, ce que NIfTI ne permet pas</translation>
    </message>
    <message>
        <source>It has no DICOM files with images</source>
        <translation>Il n’a pas de fichiers DICOM avec des images</translation>
    </message>
    <message>
        <source>It has no labelled voxel: all are 0</source>
        <translation>Aucun voxel n’est étiqueté&#xa0;: tous valent 0</translation>
    </message>
    <message>
        <source>It has no phase %1; it has %2</source>
        <translation>Il n’y a pas de phase %1&#x202f;; il y en a %2</translation>
    </message>
    <message>
        <source>It has no slices of a scan</source>
        <translation>Il n’y a pas de coupes d’un examen</translation>
    </message>
    <message>
        <source>It has no slices of a scan: &quot;%1&quot; %2</source>
        <translation>Il n’y a pas de coupes d’un examen&#xa0;: «&#xa0;%1&#xa0;» %2</translation>
    </message>
    <message>
        <source>It has no surface &quot;%1&quot;</source>
        <translation>Il n’a pas de surface «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>It has no triangles</source>
        <translation>Elle n’a pas de triangles</translation>
    </message>
    <message>
        <source>It does not have three dimensions</source>
        <translation>Elle n’a pas trois dimensions</translation>
    </message>
    <message>
        <source>It has several axes that are not of space</source>
        <translation>Elle a plusieurs axes qui ne sont pas de l’espace</translation>
    </message>
    <message>
        <source>It has several labels: %1</source>
        <translation>Il y a plusieurs étiquettes&#xa0;: %1</translation>
    </message>
    <message>
        <source>It has several values per voxel</source>
        <translation>Elle a plusieurs valeurs par voxel</translation>
    </message>
    <message>
        <source>It has several values per voxel (%1)</source>
        <translation>Elle a plusieurs valeurs par voxel (%1)</translation>
    </message>
    <message>
        <source>It has to be positive</source>
        <translation>La valeur doit être positive</translation>
    </message>
    <message>
        <source>It holds an image, not labels: it has more than %1 different values</source>
        <translation>Il contient une image, non des étiquettes&#xa0;: il a plus de %1 valeurs différentes</translation>
    </message>
    <message>
        <source>It holds an image, not labels: one of its values is %1</source>
        <translation>Il contient une image, non des étiquettes&#xa0;: l’une de ses valeurs est %1</translation>
    </message>
    <message>
        <source>It holds more than %1 masks</source>
        <translation>Il contient plus de %1 masques</translation>
    </message>
    <message>
        <source>It holds neither surfaces nor label maps</source>
        <translation>Il ne contient ni surfaces ni cartes d’étiquettes</translation>
    </message>
    <message>
        <source>It holds no PolyData</source>
        <translation>Il ne contient pas de PolyData</translation>
    </message>
    <message>
        <source>It holds no label map</source>
        <translation>Il ne contient pas de carte d’étiquettes</translation>
    </message>
    <message>
        <source>It holds no triangles</source>
        <translation>Il ne contient pas de triangles</translation>
    </message>
    <message>
        <source>It holds no triangles, only points</source>
        <translation>Il ne contient pas de triangles, seulement des points</translation>
    </message>
    <message>
        <source>It holds only empty masks</source>
        <translation>Il ne contient que des masques vides</translation>
    </message>
    <message>
        <source>It holds points, but no faces</source>
        <translation>Il contient des points, mais pas de faces</translation>
    </message>
    <message>
        <source>It is a DICOM file without an image</source>
        <translation>C’est un fichier DICOM sans image</translation>
    </message>
    <message>
        <source>It is a DICOM file, but no segmentation (%1)</source>
        <translation>C’est un fichier DICOM, mais pas une segmentation (%1)</translation>
    </message>
    <message>
        <source>It is a binary OFF file, which Viscera does not read</source>
        <translation>C’est un fichier OFF binaire, que Viscera ne lit pas</translation>
    </message>
    <message>
        <source>It is a folder, not a file</source>
        <translation>C’est un dossier, non un fichier</translation>
    </message>
    <message>
        <source>It is a scan, not an organ</source>
        <translation>C’est un examen, pas un organe</translation>
    </message>
    <message>
        <source>It is glTF version %1, but only 2 can be read</source>
        <translation>C’est du glTF version %1, mais seule la 2 peut être lue</translation>
    </message>
    <message>
        <source>It is named %1 but looks like %2</source>
        <translation>Il est nommé %1 mais semble être %2</translation>
    </message>
    <message>
        <source>It is no %1: its &quot;format&quot; is not &quot;%2&quot;</source>
        <translation>Ce n’est pas un fichier de type %1&#xa0;: son «&#xa0;format&#xa0;» n’est pas «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>It is not a file with several phases</source>
        <translation>Ce n’est pas un fichier à plusieurs phases</translation>
    </message>
    <message>
        <source>It is not a file that can be read</source>
        <translation>Ce n’est pas un fichier lisible</translation>
    </message>
    <message>
        <source>It is not a handle file</source>
        <translation>Ce n’est pas un fichier de poignées</translation>
    </message>
    <message>
        <source>It is not a regular file</source>
        <translation>Ce n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>It is not a scan in a known format</source>
        <translation>Ce n’est pas un examen dans un format connu</translation>
    </message>
    <message>
        <source>It is not a slice of a scan</source>
        <translation>Ce n’est pas une coupe d’un examen</translation>
    </message>
    <message>
        <source>It is not a slice of a scan: it %1</source>
        <translation>Ce n’est pas une coupe d’un examen&#xa0;: %1</translation>
    </message>
    <message>
        <source>It is not convex at its triangle %1</source>
        <translation>Elle n’est pas convexe à son triangle %1</translation>
    </message>
    <message>
        <source>It is of version %1; this program reads up to %2</source>
        <translation>Il est de la version %1&#x202f;; ce programme lit jusqu’à %2</translation>
    </message>
    <message>
        <source>It is too large: %1 points</source>
        <translation>Elle est trop grande&#xa0;: %1 points</translation>
    </message>
    <message>
        <source>The displacement field would have more than 20 million points</source>
        <translation>Le champ de déplacements aurait plus de 20 millions de points</translation>
    </message>
    <message>
        <source>It mixes surfaces and label maps</source>
        <translation>Il mélange surfaces et cartes d’étiquettes</translation>
    </message>
    <message>
        <source>It needs the glTF extension %1, which Viscera does not know</source>
        <translation>Il demande l’extension glTF %1, que Viscera ne connaît pas</translation>
    </message>
    <message>
        <source>It seems to be in RAS where %1 is in LPS, or the other way round: it lies on the opposite side of the patient's middle</source>
        <translation>Il semble être en RAS alors que %1 est en LPS, ou l’inverse&#xa0;: il est de l’autre côté du milieu du patient</translation>
    </message>
    <message>
        <source>Its grid is sheared: its axes are not at right angles</source>
        <translation>Sa grille est cisaillée&#xa0;: ses axes ne sont pas à angle droit</translation>
    </message>
    <message>
        <source>Keep circulation for comparison</source>
        <translation>Garder la circulation pour comparer</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Rein</translation>
    </message>
    <message>
        <source>Kidney left</source>
        <translation>Rein gauche</translation>
    </message>
    <message>
        <source>Kidney right</source>
        <translation>Rein droit</translation>
    </message>
    <message>
        <source>LA cavity</source>
        <translation>Cavité AG</translation>
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
        <source>Left atrium, scale of the passive filling curve</source>
        <translation>Atrium gauche, échelle de la courbe de remplissage passif</translation>
    </message>
    <message>
        <source>Left atrium, steepness of the passive filling curve</source>
        <translation>Atrium gauche, pente de la courbe de remplissage passif</translation>
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
        <source>Vertebra</source>
        <translation>Vertèbre</translation>
    </message>
    <message>
        <source>Left rib</source>
        <translation>Côte gauche</translation>
    </message>
    <message>
        <source>Right rib</source>
        <translation>Côte droite</translation>
    </message>
    <message>
        <source>Upper lobe of the left lung</source>
        <translation>Lobe supérieur du poumon gauche</translation>
    </message>
    <message>
        <source>Lower lobe of the left lung</source>
        <translation>Lobe inférieur du poumon gauche</translation>
    </message>
    <message>
        <source>Upper lobe of the right lung</source>
        <translation>Lobe supérieur du poumon droit</translation>
    </message>
    <message>
        <source>Middle lobe of the right lung</source>
        <translation>Lobe moyen du poumon droit</translation>
    </message>
    <message>
        <source>Lower lobe of the right lung</source>
        <translation>Lobe inférieur du poumon droit</translation>
    </message>
    <message>
        <source>Left deep back muscles</source>
        <translation>Muscles profonds du dos à gauche</translation>
    </message>
    <message>
        <source>Right deep back muscles</source>
        <translation>Muscles profonds du dos à droite</translation>
    </message>
    <message>
        <source>Left iliopsoas muscle</source>
        <translation>Muscle ilio-psoas gauche</translation>
    </message>
    <message>
        <source>Right iliopsoas muscle</source>
        <translation>Muscle ilio-psoas droit</translation>
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
        <translation>Ventricule gauche, échelle de la courbe de remplissage passif</translation>
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
        <source>Maximum of %1 mm</source>
        <translation>Maximum sur %1 mm</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Mean of %1 mm</source>
        <translation>Moyenne sur %1 mm</translation>
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
        <translation>Valeur moyenne de ce qui est visible d’une cage, par rayons&#x202f;; positive dans toute cage</translation>
    </message>
    <message>
        <source>Mean value on the hull, inner handles added one by one; they may make some negative</source>
        <translation>Valeur moyenne sur l’enveloppe, poignées internes ajoutées une à une&#x202f;; elles peuvent en rendre négatives</translation>
    </message>
    <message>
        <source>Mean value over all tetrahedra of the handles at once, by directions; positive, with many maxima</source>
        <translation>Valeur moyenne sur tous les tétraèdres des poignées à la fois, par directions&#x202f;; positive, avec beaucoup de maxima</translation>
    </message>
    <message>
        <source>Mean value over the Delaunay triangles of the handles as each point sees them; jumps where triangles flip, which blending reduces</source>
        <translation>Valeur moyenne sur les triangles de Delaunay des poignées vues de chaque point&#x202f;; sauts où les triangles basculent, réduits par le mélange</translation>
    </message>
    <message>
        <source>Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow</source>
        <translation>Valeur moyenne sur les régions de Voronoï des poignées vues de chaque point&#x202f;; sauts, ou lente</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Mesurer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurée</translation>
    </message>
    <message>
        <source>Middle of the body</source>
        <translation>Milieu du corps gastrique</translation>
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
        <source>No cavity is a ventricle by its name</source>
        <translation>Aucune cavité n’est un ventricule d’après son nom</translation>
    </message>
    <message>
        <source>No surface is chosen</source>
        <translation>Aucune surface n’est choisie</translation>
    </message>
    <message>
        <source>No voxel has a label in %1</source>
        <translation>Aucun voxel n’a d’étiquette dans la %1</translation>
    </message>
    <message>
        <source>The key sequence has no key</source>
        <translation>La séquence de clés n’a pas de clé</translation>
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
        <source>Seed of the random numbers</source>
        <translation>Graine des nombres aléatoires</translation>
    </message>
    <message>
        <source>Only label maps have labels</source>
        <translation>Seules les cartes d’étiquettes ont des étiquettes</translation>
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
        <source>Open sequence %1</source>
        <translation>Ouvrir la séquence %1</translation>
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
        <source>Pancreas</source>
        <translation>Pancréas</translation>
    </message>
    <message>
        <source>Tissue folded at any instant</source>
        <translation>Tissu replié à un instant</translation>
    </message>
    <message>
        <source>Maximum of largest stretch</source>
        <translation>Maximum du plus grand étirement</translation>
    </message>
    <message>
        <source>Maximum rotational stress</source>
        <translation>Contrainte rotationnelle maximale</translation>
    </message>
    <message>
        <source>Minimum of smallest stretch</source>
        <translation>Minimum du plus petit étirement</translation>
    </message>
    <message>
        <source>Extreme volume ratio</source>
        <translation>Rapport de volume extrême</translation>
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
        <translation>Précharge&#xa0;: volume sanguin contraint</translation>
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
        <translation>Coordonnées rationnelles d’une cage convexe&#x202f;; positives et lisses à l’intérieur</translation>
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
        <source>Take out of group</source>
        <translation>Retirer du groupe</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Supprimer le groupe</translation>
    </message>
    <message numerus="yes">
        <source>Remove {handle|%n handles}</source>
        <translation>
            <numerusform>Supprimer la poignée</numerusform>
            <numerusform>Supprimer %n poignées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {key|%n keys}</source>
        <translation>
            <numerusform>Supprimer la clé</numerusform>
            <numerusform>Supprimer %n clés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {measurement|%n measurements}</source>
        <translation>
            <numerusform>Supprimer la mesure</numerusform>
            <numerusform>Supprimer %n mesures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove {organ|%n organs}</source>
        <translation>
            <numerusform>Supprimer l’organe</numerusform>
            <numerusform>Supprimer %n organes</numerusform>
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
        <source>Replace key sequence</source>
        <translation>Remplacer la séquence de clés</translation>
    </message>
    <message>
        <source>Reproductive system</source>
        <translation>Système génital</translation>
    </message>
    <message>
        <source>Reset pose</source>
        <translation>Réinitialiser la pose</translation>
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
        <translation>Atrium droit, échelle de la courbe de remplissage passif</translation>
    </message>
    <message>
        <source>Right atrium, steepness of the passive filling curve</source>
        <translation>Atrium droit, pente de la courbe de remplissage passif</translation>
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
        <translation>Ventricule droit, échelle de la courbe de remplissage passif</translation>
    </message>
    <message>
        <source>Right ventricle, steepness of the passive filling curve</source>
        <translation>Ventricule droit, pente de la courbe de remplissage passif</translation>
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
        <source>S-Celestial</source>
        <translation>S-Celestial</translation>
    </message>
    <message>
        <source>Number of samples for each point</source>
        <translation>Nombre d’échantillons pour chaque point</translation>
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
        <translation>Coordonnées de Sibson&#xa0;: ce qu’un point prend aux cellules de Voronoï de ses voisins&#x202f;; positives et locales</translation>
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
        <source>Slice %1 (%2) is shifted sideways against those below it</source>
        <translation>La coupe %1 (%2) est décalée latéralement par rapport à celles du dessous</translation>
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
        <translation>Lisse et positif, à partir de points seuls&#x202f;; entropie maximale sur les directions</translation>
    </message>
    <message>
        <source>Smooth and positive, from points alone; the thesis's choice for organs</source>
        <translation>Lisse et positif, à partir de points seuls&#x202f;; le choix de la thèse pour les organes</translation>
    </message>
    <message>
        <source>Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes</source>
        <translation>Solutions de l’équation de Laplace dans une cage de forme quelconque&#x202f;; locales, sans lobes négatifs</translation>
    </message>
    <message>
        <source>Some of its values need more than 32 bits as a whole number; they are kept as fractions of seven digits</source>
        <translation>Certaines de ses valeurs demandent plus de 32 bits comme nombre entier&#x202f;; elles sont gardées comme décimaux de sept chiffres</translation>
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
        <translation>Tachygastrie&#xa0;: les personnes saines ont 2 à 4 ondes par minute.</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Queue</translation>
    </message>
    <message>
        <source>Take handles of %1</source>
        <translation>Prendre les poignées de %1</translation>
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
        <source>TetGen cannot fill this surface (%1)</source>
        <translation>TetGen ne peut pas remplir cette surface (%1)</translation>
    </message>
    <message>
        <source>TetGen placed no point inside the surface</source>
        <translation>TetGen n’a placé aucun point à l’intérieur de la surface</translation>
    </message>
    <message>
        <source>TetGen wanted more than %1 MB of memory</source>
        <translation>TetGen a demandé plus de %1 Mo de mémoire</translation>
    </message>
    <message>
        <source>TetGen was not done after %1 s</source>
        <translation>TetGen n’avait pas terminé après %1 s</translation>
    </message>
    <message>
        <source>TetGen's program %1 cannot be started: %2</source>
        <translation>impossible de lancer le programme %1 de TetGen&#xa0;: %2</translation>
    </message>
    <message>
        <source>TetGen&apos;s result does not fill this surface: %1</source>
        <translation>le résultat de TetGen ne remplit pas cette surface&#xa0;: %1</translation>
    </message>
    <message>
        <source>Textbook heartbeat</source>
        <translation>Battement de référence</translation>
    </message>
    <message>
        <source>The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle is far higher than that of the aorta.</source>
        <translation>La valve aortique s’ouvre à 0,8 cm2&#xa0;: la pression du ventricule hypertrophié dépasse de loin celle de l’aorte.</translation>
    </message>
    <message>
        <source>The cavity %1 is not inside the outer surface %2: %3 % of it lie outside</source>
        <translation>La cavité %1 n’est pas dans la surface externe %2&#xa0;: %3 % sont à l’extérieur</translation>
    </message>
    <message>
        <source>The classical coordinates of a closed cage; positive where the cage is convex</source>
        <translation>Les coordonnées classiques d’une cage fermée&#x202f;; positives là où la cage est convexe</translation>
    </message>
    <message>
        <source>The files' names are not in the order of the slices; they were put in order by position</source>
        <translation>Les noms des fichiers ne sont pas dans l’ordre des coupes&#x202f;; elles ont été ordonnées par position</translation>
    </message>
    <message>
        <source>The grid of %1 is another one than that of the first phase</source>
        <translation>La grille de la %1 n’est pas celle de la première phase</translation>
    </message>
    <message>
        <source>The label &quot;%1&quot; is missing in %2</source>
        <translation>L’étiquette «&#xa0;%1&#xa0;» manque dans la %2</translation>
    </message>
    <message>
        <source>The label map of %1 has another grid (%2) than the scan (%3); each lies where its file says, and nothing is resampled</source>
        <translation>La carte d’étiquettes de %1 a une autre grille (%2) que l’examen (%3)&#x202f;; chacune est là où son fichier le dit, et rien n’est rééchantillonné</translation>
    </message>
    <message>
        <source>The last phase does not lead back to the first: they lie %1 mm apart on average, neighbours %2 mm at most</source>
        <translation>La dernière phase ne ramène pas à la première&#xa0;: elles sont distantes de %1 mm en moyenne, les voisines de %2 mm au plus</translation>
    </message>
    <message>
        <source>The mean over all tetrahedra of handles around a point; jumps where their number changes</source>
        <translation>La moyenne sur tous les tétraèdres de poignées autour d’un point&#x202f;; saute où leur nombre change</translation>
    </message>
    <message>
        <source>The mean over the hull and partitions of it by the inner handles; kinks at their faces</source>
        <translation>La moyenne sur l’enveloppe et ses partitions par les poignées internes&#x202f;; plis à leurs faces</translation>
    </message>
    <message>
        <source>The middle of the mitral valve, inside the heart</source>
        <translation>Le milieu de la valve mitrale, dans le cœur</translation>
    </message>
    <message>
        <source>The mitral valve leaks through 0.45 cm2: half of what the ventricle ejects goes back into the atrium.</source>
        <translation>La valve mitrale fuit par 0,45 cm2&#xa0;: la moitié de ce que le ventricule éjecte retourne dans l’atrium.</translation>
    </message>
    <message>
        <source>The number of witness points must be from %1 to %2</source>
        <translation>Le nombre de points témoins doit être de %1 à %2</translation>
    </message>
    <message>
        <source>Target weights</source>
        <translation>Poids cibles</translation>
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
        <source>The period is not a positive time</source>
        <translation>La période n’est pas une durée positive</translation>
    </message>
    <message>
        <source>The points of n-space that the wire connects</source>
        <translation>Les points de l’espace à n dimensions que le fil relie</translation>
    </message>
    <message>
        <source>The pose has a position that is not a finite number, or too far away</source>
        <translation>La pose a une position qui n’est pas un nombre fini, ou trop éloignée</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie</source>
        <translation>Le programme ffmpeg n’a pas pu écrire le film</translation>
    </message>
    <message>
        <source>The program ffmpeg could not write the movie: %1</source>
        <translation>Le programme ffmpeg n’a pas pu écrire le film&#xa0;: %1</translation>
    </message>
    <message>
        <source>The sequence moves %1 handles, but there are %2</source>
        <translation>La séquence déplace %1 poignées, mais il y en a %2</translation>
    </message>
    <message>
        <source>The sequence was made for another place of a handle</source>
        <translation>La séquence a été faite pour une autre position d’une poignée</translation>
    </message>
    <message numerus="yes">
        <source>The series has images of several sizes: %n {image|images} of %2 left out, those of %3 read</source>
        <translation>
            <numerusform>La série a des images de plusieurs tailles&#xa0;: %n image de %2 omise, celles de %3 lues</numerusform>
            <numerusform>La série a des images de plusieurs tailles&#xa0;: %n images de %2 omises, celles de %3 lues</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The series has pixels of several sizes: %n {image|images} of %2 mm left out, those of %3 mm read</source>
        <translation>
            <numerusform>La série a des pixels de plusieurs tailles&#xa0;: %n image de %2 mm omise, celles de %3 mm lues</numerusform>
            <numerusform>La série a des pixels de plusieurs tailles&#xa0;: %n images de %2 mm omises, celles de %3 mm lues</numerusform>
        </translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the way they are stacked (a tilted gantry); the shear is kept</source>
        <translation>Les coupes sont inclinées de %1 degrés par rapport à leur empilement (statif incliné)&#x202f;; le cisaillement est conservé</translation>
    </message>
    <message>
        <source>Maximises the smallest weight; positive, with kinks</source>
        <translation>Maximise le plus petit poids&#x202f;; positives, avec des plis</translation>
    </message>
    <message>
        <source>The spacing is uneven between slice %1 (%2) and the next, which are %3 mm apart in place of %4 mm (%5 %)</source>
        <translation>L’espacement est inégal entre la coupe %1 (%2) et la suivante, distantes de %3 mm au lieu de %4 mm (%5 %)</translation>
    </message>
    <message>
        <source>The surface has no triangle</source>
        <translation>La surface n’a aucun triangle</translation>
    </message>
    <message>
        <source>The surface was repaired before it was filled. %1. Details smaller than %2 mm are lost.</source>
        <translation>La surface a été réparée avant d’être remplie. %1. Les détails de moins de %2 mm sont perdus.</translation>
    </message>
    <message>
        <source>The thesis's radius; it cancels in the coordinates and changes nothing</source>
        <translation>Le rayon de la thèse&#x202f;; il s’élimine dans les coordonnées et ne change rien</translation>
    </message>
    <message>
        <source>The times of the phases do not ascend within one period of %1 ms: %2 is at %3 ms</source>
        <translation>Les instants des phases ne croissent pas dans une période de %1 ms&#xa0;: la %2 est à %3 ms</translation>
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
        <source>The volume of %1 jumps from %2 to %3 ml between %4 and %5</source>
        <translation>Le volume de %1 saute de %2 à %3 ml entre la %4 et la %5</translation>
    </message>
    <message>
        <source>The witness points lie on a regular grid inside the surface. %1.</source>
        <translation>Les points témoins sont sur une grille régulière à l’intérieur de la surface. %1.</translation>
    </message>
    <message>
        <source>There are %1 witness points; %2 do not fit this shape or the limits of time and memory.</source>
        <translation>Il y a %1 points témoins&#x202f;; %2 ne conviennent pas à cette forme ou aux limites de temps et de mémoire.</translation>
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
        <source>There is no %1</source>
        <translation>Il n’y a pas de %1</translation>
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
        <translation>Cela n’existe plus&#xa0;: %1</translation>
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
        <source>There is no surface &quot;%1&quot;</source>
        <translation>Il n’y a pas de surface «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>There is no volume in it</source>
        <translation>Il ne contient aucun volume</translation>
    </message>
    <message>
        <source>There is not enough memory</source>
        <translation>Il n’y a pas assez de mémoire</translation>
    </message>
    <message numerus="yes">
        <source>There {is|are} %n {time|times} for %2 phases</source>
        <translation>
            <numerusform>Il y a %n instant pour %2 phases</numerusform>
            <numerusform>Il y a %n instants pour %2 phases</numerusform>
        </translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Épaississement</translation>
    </message>
    <message>
        <source>This file does not state its axes, but other files of the series are in RAS</source>
        <translation>Ce fichier n’indique pas ses axes, mais d’autres fichiers de la série sont en RAS</translation>
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
        <source>Tracing the displacement field</source>
        <translation>Calcul du champ de déplacements</translation>
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
        <translation>Tourne les directions au hasard&#x202f;; 0 laisse l’icosaèdre droit</translation>
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
        <source>two handles are at one place</source>
        <translation>deux poignées sont au même endroit</translation>
    </message>
    <message>
        <source>Uncinate process</source>
        <translation>Processus unciné</translation>
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
        <source>VTK could not write the surface: %1</source>
        <translation>VTK n’a pas pu écrire la surface&#xa0;: %1</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Veines</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>Viridis</translation>
    </message>
    <message>
        <source>Volume ratio</source>
        <translation>Rapport de volume</translation>
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
        <translation>Poids de flexion minimale entre 0 et 1&#x202f;; lisses et locaux, ne suivent que les translations</translation>
    </message>
    <message>
        <source>Amount added to each weight when a handle is inserted</source>
        <translation>Quantité ajoutée à chaque poids quand une poignée est insérée</translation>
    </message>
    <message>
        <source>Treatment of negative weights</source>
        <translation>Traitement des poids négatifs</translation>
    </message>
    <message>
        <source>Pieces of the hull</source>
        <translation>Morceaux de l’enveloppe</translation>
    </message>
    <message>
        <source>Volume that the pericardium holds without pressure</source>
        <translation>Volume que le péricarde contient sans pression</translation>
    </message>
    <message>
        <source>When the ascent of the smallest number ends</source>
        <translation>Quand cesse la montée du plus petit nombre</translation>
    </message>
    <message>
        <source>Direction in which 'iterative' moves the target</source>
        <translation>Direction dans laquelle «&#xa0;iterative&#xa0;» déplace la cible</translation>
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
        <translation>Point témoin</translation>
    </message>
    <message>
        <source>Witness points of %1</source>
        <translation>Points témoins de %1</translation>
    </message>
    <message>
        <source>%1 of %2 ml is not life-sized: %3</source>
        <translation>%1 de %2 ml n’est pas de taille réelle&#xa0;: %3</translation>
    </message>
    <message>
        <source>Two of its segments have the label %1, which NIfTI cannot tell apart</source>
        <translation>Deux de ses segments ont l’étiquette %1, ce que NIfTI ne peut pas distinguer</translation>
    </message>
    <message>
        <source>a .fcsv file is one list: the %1 groups and their colours are not kept (.mrk.json keeps them)</source>
        <translation>un fichier .fcsv est une seule liste&#xa0;: les %1 groupes et leurs couleurs ne sont pas conservés (.mrk.json les conserve)</translation>
    </message>
    <message>
        <source>a 3D Slicer fiducial table</source>
        <translation>un tableau de repères de 3D Slicer</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>un fichier JSON</translation>
    </message>
    <message>
        <source>a VTK XML file that holds no surface</source>
        <translation>un fichier VTK XML sans surface</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>une archive ZIP</translation>
    </message>
    <message>
        <source>a buffer is at %1, but only files beside it are read</source>
        <translation>un tampon est à %1, mais seuls les fichiers placés à côté sont lus</translation>
    </message>
    <message>
        <source>a cage is a coarse surface: take one of at most %1 vertices</source>
        <translation>une cage est une surface grossière&#xa0;: prenez-en une de %1 sommets au plus</translation>
    </message>
    <message>
        <source>a gallbladder</source>
        <translation>une vésicule biliaire</translation>
    </message>
    <message>
        <source>a gzip-compressed file</source>
        <translation>un fichier compressé avec gzip</translation>
    </message>
    <message>
        <source>a heart</source>
        <translation>un cœur</translation>
    </message>
    <message>
        <source>a kidney</source>
        <translation>un rein</translation>
    </message>
    <message>
        <source>a liver</source>
        <translation>un foie</translation>
    </message>
    <message>
        <source>a locked volume must be positive</source>
        <translation>un volume verrouillé doit être positif</translation>
    </message>
    <message>
        <source>a myocardium</source>
        <translation>un myocarde</translation>
    </message>
    <message>
        <source>a pancreas</source>
        <translation>un pancréas</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>une image</translation>
    </message>
    <message>
        <source>a point of the centreline lies %1 outside the organ</source>
        <translation>un point de la ligne centrale est à %1 hors de l’organe</translation>
    </message>
    <message>
        <source>a scan</source>
        <translation>un examen</translation>
    </message>
    <message>
        <source>a spleen</source>
        <translation>une rate</translation>
    </message>
    <message>
        <source>a stomach</source>
        <translation>un estomac</translation>
    </message>
    <message>
        <source>a surface</source>
        <translation>une surface</translation>
    </message>
    <message>
        <source>a surface of %1 vertices and %2 triangles is too small for handles</source>
        <translation>une surface de %1 sommets et %2 triangles est trop petite pour des poignées</translation>
    </message>
    <message>
        <source>add a group that encloses them, or put handles around them into a group</source>
        <translation>ajoutez un groupe qui les entoure, ou mettez dans un groupe des poignées autour d’eux</translation>
    </message>
    <message>
        <source>add a handle off that plane</source>
        <translation>ajoutez une poignée hors de ce plan</translation>
    </message>
    <message>
        <source>add handles to it</source>
        <translation>ajoutez-lui des poignées</translation>
    </message>
    <message>
        <source>add handles, or place them automatically</source>
        <translation>ajoutez des poignées, ou placez-les automatiquement</translation>
    </message>
    <message>
        <source>add its file, or remove those of the other surfaces in that phase</source>
        <translation>ajoutez son fichier, ou supprimez ceux des autres surfaces de cette phase</translation>
    </message>
    <message>
        <source>add the enclosing handles, or move handles outward until they surround the organ</source>
        <translation>ajoutez les poignées englobantes, ou déplacez des poignées vers l’extérieur jusqu’à ce qu’elles entourent l’organe</translation>
    </message>
    <message>
        <source>added by automatic grouping</source>
        <translation>ajoutée par le groupement automatique</translation>
    </message>
    <message>
        <source>all handles</source>
        <translation>toutes les poignées</translation>
    </message>
    <message>
        <source>all handles lie in one plane</source>
        <translation>toutes les poignées sont dans un plan</translation>
    </message>
    <message>
        <source>all handles lie on one line</source>
        <translation>toutes les poignées sont sur une droite</translation>
    </message>
    <message>
        <source>all its handles lie in one plane, so its region is flat</source>
        <translation>toutes ses poignées sont dans un plan, sa région est donc plate</translation>
    </message>
    <message>
        <source>all of it is a cavity</source>
        <translation>tout est cavité</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>tous les points sont dans un même plan</translation>
    </message>
    <message>
        <source>an error without a message</source>
        <translation>une erreur sans message</translation>
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
        <source>as in --period-ms 829</source>
        <translation>comme dans --period-ms 829</translation>
    </message>
    <message>
        <source>ask for a volume nearer to that at rest, or let more handles compensate</source>
        <translation>demandez un volume plus proche de celui au repos, ou laissez compenser plus de poignées</translation>
    </message>
    <message>
        <source>ask for at least %1</source>
        <translation>demandez-en au moins %1</translation>
    </message>
    <message>
        <source>ask for fewer groups</source>
        <translation>demandez moins de groupes</translation>
    </message>
    <message>
        <source>ask for fewer witness points</source>
        <translation>demandez moins de points témoins</translation>
    </message>
    <message>
        <source>ask for fewer, or put them nearer to the surface</source>
        <translation>demandez-en moins, ou placez-les plus près de la surface</translation>
    </message>
    <message>
        <source>at least %1 are needed</source>
        <translation>il en faut au moins %1</translation>
    </message>
    <message>
        <source>atrial systole</source>
        <translation>systole atriale</translation>
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
        <source>bounded biharmonic weights</source>
        <translation>poids biharmoniques bornés</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's left, but it lies on the right (x = %1 mm): %2</source>
        <translation>d’après son nom il va à gauche du patient, mais il est à droite (x = %1 mm)&#xa0;: %2</translation>
    </message>
    <message>
        <source>by its name it belongs on the patient's right, but it lies on the left (x = %1 mm): %2</source>
        <translation>d’après son nom il va à droite du patient, mais il est à gauche (x = %1 mm)&#xa0;: %2</translation>
    </message>
    <message>
        <source>call the left ventricle's cavity LV and the right one's RV</source>
        <translation>appelez LV la cavité du ventricule gauche et RV celle du droit</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ne peut pas être ouvert&#xa0;: %1</translation>
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
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <source>check its ending</source>
        <translation>vérifiez son extension</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>check its scale and its number format</source>
        <translation>vérifiez son échelle et son format de nombres</translation>
    </message>
    <message>
        <source>check its unit; coordinates are in mm</source>
        <translation>vérifiez l’unité&#x202f;; les coordonnées sont en mm</translation>
    </message>
    <message>
        <source>check that its surface is closed and outward</source>
        <translation>vérifiez que sa surface est fermée et orientée vers l’extérieur</translation>
    </message>
    <message>
        <source>check that its triangles face outward and that its holes are small</source>
        <translation>vérifiez que ses triangles sont orientés vers l’extérieur et que ses trous sont petits</translation>
    </message>
    <message>
        <source>check that the segmentation was saved</source>
        <translation>vérifiez que la segmentation a été enregistrée</translation>
    </message>
    <message>
        <source>check that there is room on the disk</source>
        <translation>vérifiez qu’il y a de la place sur le disque</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>vérifiez que vous avez le droit de le lire</translation>
    </message>
    <message>
        <source>check the disk or the connection</source>
        <translation>vérifiez le disque ou la connexion</translation>
    </message>
    <message>
        <source>check the name and the folder</source>
        <translation>vérifiez le nom et le dossier</translation>
    </message>
    <message>
        <source>check the space left on the disk</source>
        <translation>vérifiez l’espace libre sur le disque</translation>
    </message>
    <message>
        <source>check their order, and the period</source>
        <translation>vérifiez leur ordre et la période</translation>
    </message>
    <message>
        <source>check this phase, or leave it out</source>
        <translation>vérifiez cette phase, ou omettez-la</translation>
    </message>
    <message>
        <source>check what the file is and where it came from</source>
        <translation>vérifiez ce qu’est le fichier et d’où il vient</translation>
    </message>
    <message>
        <source>check whether one of them is mislabelled, or leave it out</source>
        <translation>vérifiez si l’une d’elles est mal étiquetée, ou omettez-la</translation>
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
        <source>choose a file that Viscera has saved as .sequence.json</source>
        <translation>choisissez un fichier que Viscera a enregistré en .sequence.json</translation>
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
        <source>choose a folder that exists, may be written to and has room</source>
        <translation>choisissez un dossier qui existe, où l’on peut écrire et qui a de la place</translation>
    </message>
    <message>
        <source>choose a surface that has some</source>
        <translation>choisissez une surface qui en a</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>choisissez-en un autre</translation>
    </message>
    <message>
        <source>choose at least one</source>
        <translation>choisissez-en au moins une</translation>
    </message>
    <message>
        <source>choose it again in Play mode</source>
        <translation>choisissez-le à nouveau dans le mode Lecture</translation>
    </message>
    <message>
        <source>choose it on the organ; check the axes (RAS or LPS) too</source>
        <translation>choisissez-le sur l’organe&#x202f;; vérifiez aussi les axes (RAS ou LPS)</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>choisissez l’un d’eux</translation>
    </message>
    <message>
        <source>choose the two ends of the organ</source>
        <translation>choisissez les deux extrémités de l’organe</translation>
    </message>
    <message>
        <source>choose two ends of one surface</source>
        <translation>choisissez deux extrémités d’une même surface</translation>
    </message>
    <message>
        <source>close its holes first</source>
        <translation>fermez d’abord ses trous</translation>
    </message>
    <message>
        <source>close its holes, as viscera convert IN OUT --fill-holes does; an open surface has no volume to keep</source>
        <translation>fermez ses trous, par exemple avec viscera convert ENTRÉE SORTIE --fill-holes&#x202f;; une surface ouverte n’a pas de volume à conserver</translation>
    </message>
    <message>
        <source>close other programs, or use fewer handles or smaller organs</source>
        <translation>fermez d’autres programmes, ou utilisez moins de poignées ou des organes plus petits</translation>
    </message>
    <message>
        <source>compensating handles</source>
        <translation>poignées qui compensent</translation>
    </message>
    <message>
        <source>convert it to .seg.nrrd</source>
        <translation>convertissez-le en .seg.nrrd</translation>
    </message>
    <message>
        <source>coordinates need at least four handles, there are %1</source>
        <translation>les coordonnées demandent au moins quatre poignées, il y en a %1</translation>
    </message>
    <message>
        <source>copy its contents to a file first</source>
        <translation>copiez d’abord son contenu dans un fichier</translation>
    </message>
    <message>
        <source>copy the file anew, or take it out of the folder to read the others</source>
        <translation>recopiez le fichier, ou retirez-le du dossier pour lire les autres</translation>
    </message>
    <message>
        <source>crop the image to the organs</source>
        <translation>recadrez l’image sur les organes</translation>
    </message>
    <message>
        <source>deeper ones would push folds of the surface into one another</source>
        <translation>des ondes plus profondes pousseraient les plis de la surface les uns dans les autres</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>derivatives at the witness points</source>
        <translation>dérivées aux points témoins</translation>
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
        <source>does not say how large its pixels are</source>
        <translation>n’indique pas la taille de ses pixels</translation>
    </message>
    <message>
        <source>does not say where in the patient it lies</source>
        <translation>n’indique pas sa position dans le patient</translation>
    </message>
    <message>
        <source>does not say where its frames lie</source>
        <translation>n’indique pas la position de ses images</translation>
    </message>
    <message>
        <source>ejection</source>
        <translation>éjection</translation>
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
        <source>even so, folds of the surface meet when they pass</source>
        <translation>malgré cela, des plis de la surface se touchent à leur passage</translation>
    </message>
    <message>
        <source>exchanges left and right</source>
        <translation>échange gauche et droite</translation>
    </message>
    <message>
        <source>expiration</source>
        <translation>expiration</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same axes</source>
        <translation>exportez toutes les surfaces d’un patient dans les mêmes axes</translation>
    </message>
    <message>
        <source>export all surfaces of a patient in the same way (viscera convert --space LPS)</source>
        <translation>exportez toutes les surfaces d’un patient de la même façon (viscera convert --space LPS)</translation>
    </message>
    <message>
        <source>export it as a surface of triangles</source>
        <translation>exportez-la comme surface de triangles</translation>
    </message>
    <message>
        <source>export it as glTF 2.0</source>
        <translation>exportez-le en glTF 2.0</translation>
    </message>
    <message>
        <source>export it as pixels of 16 bits</source>
        <translation>exportez-le en pixels de 16 bits</translation>
    </message>
    <message>
        <source>export it little-endian</source>
        <translation>exportez-le en ordre petit-boutiste</translation>
    </message>
    <message>
        <source>export it without compression</source>
        <translation>exportez-le sans compression</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>exportez ou copiez le fichier à nouveau</translation>
    </message>
    <message>
        <source>export the surface again</source>
        <translation>exportez de nouveau la surface</translation>
    </message>
    <message>
        <source>extract its surface first</source>
        <translation>extrayez d’abord sa surface</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>remplissage</translation>
    </message>
    <message>
        <source>filling the handles with tetrahedra</source>
        <translation>remplissage des poignées par des tétraèdres</translation>
    </message>
    <message>
        <source>filling the organ with tetrahedra</source>
        <translation>remplissage de l’organe par des tétraèdres</translation>
    </message>
    <message>
        <source>fills every hole with a cap</source>
        <translation>ferme chaque trou par un capuchon</translation>
    </message>
    <message>
        <source>finding landmarks</source>
        <translation>recherche des repères</translation>
    </message>
    <message>
        <source>folded where it is hatched</source>
        <translation>replié là où c’est hachuré</translation>
    </message>
    <message>
        <source>fundus</source>
        <translation>fundus</translation>
    </message>
    <message>
        <source>fundus, centreline from the fundus down, body in between, pylorus</source>
        <translation>fundus, ligne centrale à partir du fundus, corps entre les deux, pylore</translation>
    </message>
    <message>
        <source>give apex and base too</source>
        <translation>donnez aussi apex et base</translation>
    </message>
    <message>
        <source>give both, or none to have them computed</source>
        <translation>donnez les deux, ou aucun pour qu’ils soient calculés</translation>
    </message>
    <message>
        <source>give every handle a label of its own</source>
        <translation>donnez à chaque poignée sa propre étiquette</translation>
    </message>
    <message>
        <source>give fundus and pylorus too</source>
        <translation>donnez aussi fundus et pylorus</translation>
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
        <source>give its labels smaller numbers</source>
        <translation>donnez des numéros plus petits à ses étiquettes</translation>
    </message>
    <message>
        <source>give one between 0.1 and 0.8</source>
        <translation>donnez-en une entre 0,1 et 0,8</translation>
    </message>
    <message>
        <source>give one for each phase</source>
        <translation>donnez-en un pour chaque phase</translation>
    </message>
    <message>
        <source>give points of the centreline yourself</source>
        <translation>donnez vous-même des points de la ligne centrale</translation>
    </message>
    <message>
        <source>give the outer surface the labels of its cavities too, as in EPI=1,2,3</source>
        <translation>donnez aussi à la surface externe les étiquettes de ses cavités, comme dans EPI=1,2,3</translation>
    </message>
    <message>
        <source>glTF does not say which axes a patient&apos;s are: its numbers are taken as LPS millimetres, though the format&apos;s convention is metres with y up</source>
        <translation>glTF ne dit pas quels sont les axes du patient&#xa0;: ses nombres sont pris en millimètres LPS, bien que le format prévoie des mètres avec y vers le haut</translation>
    </message>
    <message>
        <source>grid inside the surface</source>
        <translation>grille à l’intérieur de la surface</translation>
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
        <source>group &apos;%1&apos;</source>
        <translation>groupe «&#xa0;%1&#xa0;»</translation>
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
        <source>harmonic coordinates</source>
        <translation>coordonnées harmoniques</translation>
    </message>
    <message numerus="yes">
        <source>has %n {column|columns}</source>
        <translation>
            <numerusform>a %n colonne</numerusform>
            <numerusform>a %n colonnes</numerusform>
        </translation>
    </message>
    <message>
        <source>has a heading that does not say what the instants are</source>
        <translation>a un en-tête qui ne dit pas ce que sont les instants</translation>
    </message>
    <message>
        <source>has a volume that is not positive</source>
        <translation>a un volume qui n’est pas positif</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>n’a pas de pixels</translation>
    </message>
    <message>
        <source>has pixels that are fractions (Float Pixel Data), which Viscera does not read; export it as whole numbers, or as NIfTI</source>
        <translation>a des pixels décimaux (Float Pixel Data), que Viscera ne lit pas&#x202f;; exportez-le en nombres entiers, ou en NIfTI</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>maintien</translation>
    </message>
    <message>
        <source>holds something that is not a number</source>
        <translation>contient quelque chose qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>if it is not a whole cycle, say that it is to be played once (--once); else add the phases that are missing</source>
        <translation>si ce n’est pas un cycle entier, indiquez qu’il doit être lu une fois (--once)&#x202f;; sinon ajoutez les phases qui manquent</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>inspiration</source>
        <translation>inspiration</translation>
    </message>
    <message>
        <source>install Viscera again, or name it in VISCERA_TETGEN_WORKER</source>
        <translation>réinstallez Viscera, ou indiquez-le dans VISCERA_TETGEN_WORKER</translation>
    </message>
    <message>
        <source>install ffmpeg, or write an .ogv</source>
        <translation>installez ffmpeg, ou écrivez un .ogv</translation>
    </message>
    <message>
        <source>is a colour image</source>
        <translation>est une image en couleurs</translation>
    </message>
    <message>
        <source>is a mosaic of many slices in one image, as Siemens writes them, which Viscera does not take apart; convert it to NIfTI (dcm2niix does)</source>
        <translation>est une mosaïque de nombreuses coupes en une image, comme les écrit Siemens, que Viscera ne sépare pas&#x202f;; convertissez-la en NIfTI (dcm2niix le fait)</translation>
    </message>
    <message>
        <source>is not a file that can be read</source>
        <translation>n’est pas un fichier qui puisse être lu</translation>
    </message>
    <message>
        <source>is not later than the line before</source>
        <translation>n’est pas postérieure à la ligne précédente</translation>
    </message>
    <message numerus="yes">
        <source>is not manifold at %n {edge|edges}</source>
        <translation>
            <numerusform>n’est pas une variété à %n arête</numerusform>
            <numerusform>n’est pas une variété à %n arêtes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>is open at %n {edge|edges}</source>
        <translation>
            <numerusform>est ouverte à %n arête</numerusform>
            <numerusform>est ouverte à %n arêtes</numerusform>
        </translation>
    </message>
    <message>
        <source>is too thin in places for a surface with the volume of its voxels</source>
        <translation>est par endroits trop mince pour une surface ayant le volume de ses voxels</translation>
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
        <source>it does not say how large its voxels are; 1 mm is assumed</source>
        <translation>la taille de ses voxels n’est pas indiquée&#x202f;; 1 mm est supposé</translation>
    </message>
    <message>
        <source>it does not say where the patient's sides are; axes are taken as right, front and up</source>
        <translation>il n’indique pas où sont les côtés du patient&#x202f;; les axes sont pris comme droite, avant et haut</translation>
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
        <source>it may be mirrored</source>
        <translation>il est peut-être en miroir</translation>
    </message>
    <message>
        <source>its axes %1 are unknown; LPS is assumed</source>
        <translation>ses axes %1 sont inconnus&#x202f;; LPS est supposé</translation>
    </message>
    <message>
        <source>its encoding %1 is not supported</source>
        <translation>son encodage %1 n’est pas pris en charge</translation>
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
        <source>its frames lie in different directions</source>
        <translation>ses images sont dans des directions différentes</translation>
    </message>
    <message>
        <source>its labels are those of a heart: muscle and chambers are its outer surface, each chamber is a cavity</source>
        <translation>ses étiquettes sont celles d’un cœur&#xa0;: le muscle et les cavités cardiaques forment sa surface externe, chacune de celles-ci est une cavité</translation>
    </message>
    <message>
        <source>its pixels of %1 bits in %2, up to bit %3, are not supported</source>
        <translation>ses pixels de %1 bits sur %2, jusqu’au bit %3, ne sont pas pris en charge</translation>
    </message>
    <message>
        <source>its sform and qform place the image differently; the sform is used</source>
        <translation>son sform et son qform placent l’image différemment&#x202f;; sform est utilisé</translation>
    </message>
    <message>
        <source>its sform is singular or not finite and is not used</source>
        <translation>son sform est singulier ou non fini et n’est pas utilisé</translation>
    </message>
    <message>
        <source>its slices are not equally far from each other (frame %1)</source>
        <translation>ses coupes ne sont pas à égale distance les unes des autres (image %1)</translation>
    </message>
    <message>
        <source>its surface has changed: measured points were moved to the nearest places on the new surface</source>
        <translation>sa surface a changé&#xa0;: les points mesurés ont été déplacés aux endroits les plus proches de la nouvelle surface</translation>
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
        <source>its volume can be kept only after it is bound to the present handles</source>
        <translation>son volume ne peut être gardé qu’après sa liaison aux poignées présentes</translation>
    </message>
    <message>
        <source>its volume is not locked any more: the surface is open now</source>
        <translation>son volume n’est plus verrouillé&#xa0;: la surface est maintenant ouverte</translation>
    </message>
    <message>
        <source>its voxels lie elsewhere than those of the other masks</source>
        <translation>ses voxels sont ailleurs que ceux des autres masques</translation>
    </message>
    <message>
        <source>keep the largest, as viscera convert IN OUT --keep-largest does</source>
        <translation>gardez le plus grand, par exemple avec viscera convert ENTRÉE SORTIE --keep-largest</translation>
    </message>
    <message>
        <source>keeps the piece with the largest area and drops the others</source>
        <translation>garde le morceau de plus grande aire et écarte les autres</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>mmHg</source>
        <translation>mmHg</translation>
    </message>
    <message>
        <source>start</source>
        <translation>début</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>clé %1</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>kilomètres</translation>
    </message>
    <message>
        <source>known endings: %1</source>
        <translation>extensions connues&#xa0;: %1</translation>
    </message>
    <message>
        <source>label it in every phase, or leave this phase out</source>
        <translation>étiquetez-le dans chaque phase, ou omettez cette phase</translation>
    </message>
    <message>
        <source>label the points %1</source>
        <translation>nommez les points %1</translation>
    </message>
    <message>
        <source>leave it out for surfaces</source>
        <translation>omettez-le pour les surfaces</translation>
    </message>
    <message>
        <source>leave the landmarks out</source>
        <translation>omettez les repères</translation>
    </message>
    <message>
        <source>leave two: the instant, and the volume in ml</source>
        <translation>laissez-en deux&#xa0;: l’instant et le volume en ml</translation>
    </message>
    <message>
        <source>lengthen the period first</source>
        <translation>allongez d’abord la période</translation>
    </message>
    <message>
        <source>let it begin with &quot;time_s&quot; for seconds, or with &quot;fraction&quot; for parts of the cycle</source>
        <translation>faites-le commencer par «&#xa0;time_s&#xa0;» pour des secondes, ou par «&#xa0;fraction&#xa0;» pour des parties du cycle</translation>
    </message>
    <message>
        <source>let more handles compensate, or ask for a volume nearer to the present one</source>
        <translation>laissez compenser plus de poignées, ou demandez un volume plus proche de l’actuel</translation>
    </message>
    <message>
        <source>let the last volume be the first one</source>
        <translation>donnez au dernier volume la valeur du premier</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>load a closed surface</source>
        <translation>chargez une surface fermée</translation>
    </message>
    <message>
        <source>localised coordinates</source>
        <translation>coordonnées localisées</translation>
    </message>
    <message>
        <source>looking for folds</source>
        <translation>recherche de plis</translation>
    </message>
    <message>
        <source>make the handles from this cage: viscera handles ORGAN --cage FILE</source>
        <translation>faites les poignées à partir de cette cage&#xa0;: viscera handles ORGANE --cage FICHIER</translation>
    </message>
    <message>
        <source>makes a closed surface without intersections near this one; colours are lost</source>
        <translation>fait une surface fermée sans intersections près de celle-ci&#x202f;; les couleurs sont perdues</translation>
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
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micromètres</translation>
    </message>
    <message>
        <source>centreline</source>
        <translation>ligne centrale</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
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
        <source>move or delete one of them</source>
        <translation>déplacez ou supprimez l’une d’elles</translation>
    </message>
    <message>
        <source>move or remove one of them</source>
        <translation>déplacez ou retirez l’une d’elles</translation>
    </message>
    <message>
        <source>move some off the line</source>
        <translation>sortez-en quelques-unes de la droite</translation>
    </message>
    <message>
        <source>move some off the plane, or add enclosing handles</source>
        <translation>sortez-en quelques-unes du plan, ou ajoutez des poignées englobantes</translation>
    </message>
    <message>
        <source>move the vertices there apart, or take another cage</source>
        <translation>écartez les sommets à cet endroit, ou prenez une autre cage</translation>
    </message>
    <message>
        <source>movies of this kind cannot be written</source>
        <translation>les films de ce type ne peuvent pas être écrits</translation>
    </message>
    <message>
        <source>name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase</source>
        <translation>indiquez un NIfTI 4D, un .seq.nrrd de 3D Slicer ou un fichier pour chaque phase</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>indiquez un fichier qu’il contient</translation>
    </message>
    <message>
        <source>name a folder with one file for each phase</source>
        <translation>indiquez un dossier avec un fichier pour chaque phase</translation>
    </message>
    <message>
        <source>name a folder with one mask for each organ, such as liver.nii.gz</source>
        <translation>indiquez un dossier avec un masque pour chaque organe, tel que liver.nii.gz</translation>
    </message>
    <message>
        <source>name all phases of the cycle</source>
        <translation>indiquez toutes les phases du cycle</translation>
    </message>
    <message>
        <source>name all phases of the cycle; a single image of a heart with cavities can beat as the textbook's (--textbook, in the window Fit a sequence to an organ)</source>
        <translation>indiquez toutes les phases du cycle&#x202f;; une seule image d’un cœur avec cavités peut battre comme dans le manuel (--textbook&#x202f;; dans la fenêtre, ajuster une séquence à un organe)</translation>
    </message>
    <message>
        <source>name compensating handles</source>
        <translation>indiquez des poignées qui compensent</translation>
    </message>
    <message>
        <source>name instants from 0 to 1</source>
        <translation>indiquez des instants de 0 à 1</translation>
    </message>
    <message>
        <source>name instants from 0 to 1, or write &quot;time_s&quot; above them for seconds</source>
        <translation>indiquez des instants de 0 à 1, ou écrivez «&#xa0;time_s&#xa0;» au-dessus pour des secondes</translation>
    </message>
    <message>
        <source>name it %1</source>
        <translation>nommez-le %1</translation>
    </message>
    <message>
        <source>name its files, a folder, or a file with several phases</source>
        <translation>indiquez ses fichiers, un dossier ou un fichier à plusieurs phases</translation>
    </message>
    <message>
        <source>name the folder of a CT or MR series</source>
        <translation>indiquez le dossier d’une série de TDM ou d’IRM</translation>
    </message>
    <message>
        <source>name the folder of one patient</source>
        <translation>indiquez le dossier d’un seul patient</translation>
    </message>
    <message>
        <source>name the folder, or another file in it</source>
        <translation>indiquez le dossier, ou un autre fichier de celui-ci</translation>
    </message>
    <message>
        <source>names an instant outside the cycle</source>
        <translation>nomme un instant hors du cycle</translation>
    </message>
    <message>
        <source>nanometres</source>
        <translation>nanomètres</translation>
    </message>
    <message>
        <source>no compensation within %1 mm restores the volume</source>
        <translation>aucune compensation en deçà de %1 mm ne rétablit le volume</translation>
    </message>
    <message>
        <source>no edge joins more than two triangles</source>
        <translation>aucune arête ne joint plus de deux triangles</translation>
    </message>
    <message>
        <source>no handle is left to compensate the change of volume</source>
        <translation>il ne reste aucune poignée pour compenser le changement de volume</translation>
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
        <source>no witness point lies inside</source>
        <translation>aucun point témoin n’est à l’intérieur</translation>
    </message>
    <message>
        <source>node %1 is moved by bones, which are ignored</source>
        <translation>le nœud %1 est animé par des os, qui sont ignorés</translation>
    </message>
    <message>
        <source>of an unknown kind</source>
        <translation>de type inconnu</translation>
    </message>
    <message numerus="yes">
        <source>only %n {handle|handles}</source>
        <translation>
            <numerusform>seulement %n poignée</numerusform>
            <numerusform>seulement %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>open it beside the organs (File &gt; Open a scan), or make a label map of it first, with 3D Slicer or TotalSegmentator</source>
        <translation>ouvrez-le à côté des organes (Fichier &gt; Ouvrir un examen), ou faites-en d’abord une carte d’étiquettes, avec 3D Slicer ou TotalSegmentator</translation>
    </message>
    <message>
        <source>open it by itself, or remove it from the folder</source>
        <translation>ouvrez-le seul, ou retirez-le du dossier</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>ouvrez-en un d’abord</translation>
    </message>
    <message>
        <source>open it by itself, and the other files after it</source>
        <translation>ouvrez-la seule, et les autres fichiers ensuite</translation>
    </message>
    <message>
        <source>open it with File &gt; Open</source>
        <translation>ouvrez-la par Fichier &gt; Ouvrir</translation>
    </message>
    <message>
        <source>open the segmentation that was made from it</source>
        <translation>ouvrez la segmentation qui en a été faite</translation>
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
        <source>pause</source>
        <translation>pause</translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation>phase %1</translation>
    </message>
    <message>
        <source>phase %1 fits much worse than its neighbours (%2 against %3 mm): look at its data, or leave it out</source>
        <translation>la phase %1 s’ajuste beaucoup moins bien que ses voisines (%2 contre %3 mm)&#xa0;: vérifiez ses données, ou omettez-la</translation>
    </message>
    <message>
        <source>phase %1: %2</source>
        <translation>phase %1&#xa0;: %2</translation>
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
        <source>place more handles</source>
        <translation>placez plus de poignées</translation>
    </message>
    <message>
        <source>place some first</source>
        <translation>placez-en d’abord</translation>
    </message>
    <message>
        <source>place some points and save them again</source>
        <translation>placez quelques points et enregistrez-les à nouveau</translation>
    </message>
    <message>
        <source>place the handle again</source>
        <translation>placez la poignée à nouveau</translation>
    </message>
    <message>
        <source>placing handles</source>
        <translation>placement des poignées</translation>
    </message>
    <message>
        <source>play at the rate that the times are for</source>
        <translation>lisez à la fréquence pour laquelle les instants sont donnés</translation>
    </message>
    <message>
        <source>points that coincide or are almost flat cause this</source>
        <translation>des points confondus ou presque plans en sont la cause</translation>
    </message>
    <message>
        <source>put both files into one folder</source>
        <translation>mettez les deux fichiers dans un même dossier</translation>
    </message>
    <message>
        <source>put it into the middle of the stomach</source>
        <translation>placez-le au milieu de l’estomac</translation>
    </message>
    <message>
        <source>put masks of one image into a folder of their own</source>
        <translation>mettez les masques d’une même image dans un dossier à part</translation>
    </message>
    <message>
        <source>put those of one kind into a folder of their own</source>
        <translation>mettez ceux d’un même type dans un dossier à part</translation>
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
        <source>reaches the edge of the image, which may cut it off</source>
        <translation>atteint le bord de l’image, qui le coupe peut-être</translation>
    </message>
    <message>
        <source>add a key first</source>
        <translation>ajoutez d’abord une clé</translation>
    </message>
    <message>
        <source>record and save the sequence again</source>
        <translation>refaites la séquence et enregistrez-la à nouveau</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>reduce the surface first</source>
        <translation>réduisez d’abord la surface</translation>
    </message>
    <message>
        <source>reduced ejection</source>
        <translation>éjection lente</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>supprimez l’un des deux</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>supprimez l’un d’eux</translation>
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
        <translation>réparé à l’importation&#xa0;: %1</translation>
    </message>
    <message>
        <source>repairing the surface</source>
        <translation>réparation de la surface</translation>
    </message>
    <message>
        <source>resample all phases to one grid, in the same axes</source>
        <translation>rééchantillonnez toutes les phases sur une seule grille, avec les mêmes axes</translation>
    </message>
    <message>
        <source>resample the images to an upright grid</source>
        <translation>rééchantillonnez les images sur une grille droite</translation>
    </message>
    <message>
        <source>resample the segmentation, for example by saving it as .seg.nrrd</source>
        <translation>rééchantillonnez la segmentation, par exemple en l’enregistrant en .seg.nrrd</translation>
    </message>
    <message>
        <source>reset the pose</source>
        <translation>réinitialisez la pose</translation>
    </message>
    <message>
        <source>restoring the volume would move a handle by %1 mm</source>
        <translation>rétablir le volume déplacerait une poignée de %1 mm</translation>
    </message>
    <message>
        <source>right and left are exchanged, and so are front and back: the files seem to be in RAS</source>
        <translation>droite et gauche sont échangées, ainsi que l’avant et l’arrière&#xa0;: les fichiers semblent être en RAS</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored</source>
        <translation>droite et gauche sont échangées, avant et arrière non&#xa0;: en miroir</translation>
    </message>
    <message>
        <source>right and left are exchanged: the files may be in RAS, or mirrored</source>
        <translation>droite et gauche sont échangées&#xa0;: les fichiers sont peut-être en RAS, ou en miroir</translation>
    </message>
    <message>
        <source>save it as a file of its own first</source>
        <translation>enregistrez-le d’abord dans un fichier à part</translation>
    </message>
    <message>
        <source>save it as a segmentation</source>
        <translation>enregistrez-le comme segmentation</translation>
    </message>
    <message>
        <source>save it as a 3D image</source>
        <translation>enregistrez-la comme image 3D</translation>
    </message>
    <message>
        <source>save it with gzip or raw encoding</source>
        <translation>enregistrez-le avec l’encodage gzip ou raw</translation>
    </message>
    <message>
        <source>save it with one value per voxel</source>
        <translation>enregistrez-la avec une valeur par voxel</translation>
    </message>
    <message>
        <source>save often, or make room there</source>
        <translation>enregistrez souvent, ou faites-y de la place</translation>
    </message>
    <message>
        <source>save the points from Slicer as .mrk.json</source>
        <translation>enregistrez les points depuis Slicer en .mrk.json</translation>
    </message>
    <message>
        <source>save the points from Slicer in LPS</source>
        <translation>enregistrez les points depuis Slicer en LPS</translation>
    </message>
    <message>
        <source>give it with --period-ms, or the rate with --rate</source>
        <translation>indiquez-la avec --period-ms, ou la fréquence avec --rate</translation>
    </message>
    <message>
        <source>say which surfaces they make, as in --surface LV=1 --surface RV=2 --surface EPI=1,2,3 with all labels within the outer one</source>
        <translation>indiquez quelles surfaces elles forment, comme dans --surface LV=1 --surface RV=2 --surface EPI=1,2,3, la surface externe avec toutes les étiquettes qu’elle contient</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>douce</translation>
    </message>
    <message>
        <source>sort the lines by their instants</source>
        <translation>triez les lignes par instant</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>stress over the sequence</source>
        <translation>contrainte sur la séquence</translation>
    </message>
    <message>
        <source>stroke volume</source>
        <translation>volume d’éjection systolique</translation>
    </message>
    <message>
        <source>surfaces at rest</source>
        <translation>surfaces au repos</translation>
    </message>
    <message>
        <source>system parameters</source>
        <translation>paramètres du système</translation>
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
        <source>take a cage that surrounds the organ, or the handles' convex hull as the cage</source>
        <translation>prenez une cage qui entoure l’organe, ou l’enveloppe convexe des poignées comme cage</translation>
    </message>
    <message>
        <source>take a closed cage, or none: then the convex hull of the handles is the cage</source>
        <translation>prenez une cage fermée, ou aucune&#xa0;: l’enveloppe convexe des poignées est alors la cage</translation>
    </message>
    <message>
        <source>take a convex cage, or none: then the convex hull of the handles is the cage</source>
        <translation>prenez une cage convexe, ou aucune&#xa0;: l’enveloppe convexe des poignées est alors la cage</translation>
    </message>
    <message>
        <source>take a larger one</source>
        <translation>prenez-en un plus grand</translation>
    </message>
    <message>
        <source>take another positivity</source>
        <translation>choisissez une autre positivité</translation>
    </message>
    <message>
        <source>take the sequence's own handles</source>
        <translation>prenez les poignées de la séquence</translation>
    </message>
    <message>
        <source>takes the coordinates as %1</source>
        <translation>prend les coordonnées comme des %1</translation>
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
        <source>the cage</source>
        <translation>la cage</translation>
    </message>
    <message>
        <source>the convex hull of %1 points cannot be computed</source>
        <translation>l’enveloppe convexe de %1 points ne peut pas être calculée</translation>
    </message>
    <message>
        <source>the coordinates are kept in single precision: they would take %1 MiB otherwise</source>
        <translation>les coordonnées sont gardées en simple précision&#x202f;; sinon, elles prendraient %1 Mio</translation>
    </message>
    <message>
        <source>the file does not state its axes: LPS is assumed</source>
        <translation>le fichier n’indique pas ses axes&#xa0;: LPS est supposé</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file may be in RAS, or mirrored</source>
        <translation>le fichier est peut-être en RAS, ou en miroir</translation>
    </message>
    <message>
        <source>the file states its axes: %1</source>
        <translation>le fichier indique ses axes&#xa0;: %1</translation>
    </message>
    <message>
        <source>the file with its voxels, %1, cannot be read: %2</source>
        <translation>le fichier de ses voxels, %1, ne peut pas être lu&#xa0;: %2</translation>
    </message>
    <message>
        <source>the first one is 0</source>
        <translation>la première est 0</translation>
    </message>
    <message>
        <source>the first one is: &quot;%1&quot;</source>
        <translation>la première est&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the first phase</source>
        <translation>la première phase</translation>
    </message>
    <message>
        <source>the folder for the frames cannot be written</source>
        <translation>impossible d’écrire dans le dossier des images</translation>
    </message>
    <message>
        <source>the handles enclose nothing: %1</source>
        <translation>les poignées n’entourent rien&#xa0;: %1</translation>
    </message>
    <message>
        <source>the handles that may compensate cannot restore the volume</source>
        <translation>les poignées qui peuvent compenser ne rétablissent pas le volume</translation>
    </message>
    <message>
        <source>the handles' tetrahedra</source>
        <translation>les tétraèdres des poignées</translation>
    </message>
    <message>
        <source>the label &quot;%1&quot; is not a landmark of the sequence %2</source>
        <translation>l’étiquette «&#xa0;%1&#xa0;» n’est pas un repère de la séquence %2</translation>
    </message>
    <message>
        <source>the landmark &quot;%1&quot; comes twice</source>
        <translation>le repère «&#xa0;%1&#xa0;» apparaît deux fois</translation>
    </message>
    <message>
        <source>the landmark lies %1 outside the organ</source>
        <translation>le repère est à %1 hors de l’organe</translation>
    </message>
    <message>
        <source>the landmark's position is not a finite number</source>
        <translation>la position du repère n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>the landmarks are not in order along the stomach</source>
        <translation>les repères ne sont pas dans l’ordre le long de l’estomac</translation>
    </message>
    <message>
        <source>the last phase equals the first and is left out: phase %1 would be phase 1 again</source>
        <translation>la dernière phase est égale à la première et est omise&#xa0;: la phase %1 serait à nouveau la phase 1</translation>
    </message>
    <message>
        <source>the locked volumes cannot be kept</source>
        <translation>les volumes verrouillés ne peuvent pas être conservés</translation>
    </message>
    <message>
        <source>the markup %1 of type %2 is not a list of points and was left out</source>
        <translation>le markup %1 de type %2 n’est pas une liste de points et est omis</translation>
    </message>
    <message>
        <source>the computed centreline leaves the organ</source>
        <translation>la ligne centrale calculée sort de l’organe</translation>
    </message>
    <message>
        <source>the motion is the textbook's, fitted to one image: it is not this patient's own</source>
        <translation>le mouvement est celui du manuel, ajusté à une image&#xa0;: ce n’est pas celui de ce patient</translation>
    </message>
    <message>
        <source>the motion of an organ cannot be made again: nothing is known of how it was made</source>
        <translation>le mouvement d’un organe ne peut pas être refait&#xa0;: on ne sait pas comment il a été fait</translation>
    </message>
    <message>
        <source>the movie cannot be written</source>
        <translation>le film ne peut pas être écrit</translation>
    </message>
    <message>
        <source>the movie has no frame</source>
        <translation>le film n’a aucune image</translation>
    </message>
    <message>
        <source>the name of a sequence file ends in .sequence.json</source>
        <translation>le nom d’un fichier de séquence se termine par .sequence.json</translation>
    </message>
    <message>
        <source>the name of a session file ends in .viscera</source>
        <translation>le nom d’un fichier de session se termine par .viscera</translation>
    </message>
    <message>
        <source>the names of its labels are those of %1</source>
        <translation>les noms de ses étiquettes sont ceux de %1</translation>
    </message>
    <message>
        <source>the offset of region &apos;%1&apos; is cut to %2 mm, the distance of its nearest handle from a zone</source>
        <translation>le décalage de la région «&#xa0;%1&#xa0;» est réduit à %2 mm, la distance de sa poignée la plus proche d’une zone</translation>
    </message>
    <message>
        <source>the organ is %1 times as long as that of an adult; check its unit</source>
        <translation>l’organe est %1 fois aussi long que celui d’un adulte&#x202f;; vérifiez son unité</translation>
    </message>
    <message>
        <source>the organ is in %1 pieces</source>
        <translation>l’organe est en %1 morceaux</translation>
    </message>
    <message>
        <source>the organ is inside out or flat</source>
        <translation>l’organe est retourné ou plat</translation>
    </message>
    <message numerus="yes">
        <source>the organ is open: %n boundary {edge|edges}</source>
        <translation>
            <numerusform>l’organe est ouvert&#xa0;: %n arête de bord</numerusform>
            <numerusform>l’organe est ouvert&#xa0;: %n arêtes de bord</numerusform>
        </translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>l’image ne peut pas être écrite</translation>
    </message>
    <message>
        <source>the position is not finite</source>
        <translation>la position n’est pas finie</translation>
    </message>
    <message>
        <source>the position of the handle %1 in %2 is not finite</source>
        <translation>la position de la poignée %1 dans %2 n’est pas finie</translation>
    </message>
    <message>
        <source>the program ffmpeg is needed for this kind of movie and is not installed</source>
        <translation>ce type de film demande le programme ffmpeg, qui n’est pas installé</translation>
    </message>
    <message>
        <source>the right ventricle is too small to eject as much as the left one</source>
        <translation>le ventricule droit est trop petit pour éjecter autant que le gauche</translation>
    </message>
    <message>
        <source>the scan %1 is not there any more (put it beside the session and open that again)</source>
        <translation>l’examen %1 n’est plus là (mettez-le à côté de la session et rouvrez-la)</translation>
    </message>
    <message>
        <source>the scan cannot be opened: %1</source>
        <translation>l’examen ne peut pas être ouvert&#xa0;: %1</translation>
    </message>
    <message>
        <source>the size is plausible: %1</source>
        <translation>la taille est plausible&#xa0;: %1</translation>
    </message>
    <message>
        <source>the solid could not be written</source>
        <translation>le solide n’a pas pu être écrit</translation>
    </message>
    <message>
        <source>the solid could not be written: %1</source>
        <translation>le solide n’a pas pu être écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; has two files of one phase</source>
        <translation>la surface «&#xa0;%1&#xa0;» a deux fichiers d’une même phase</translation>
    </message>
    <message>
        <source>the surface &quot;%1&quot; is missing in phase number %2</source>
        <translation>la surface «&#xa0;%1&#xa0;» manque dans la phase numéro %2</translation>
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
        <source>every piece of the surface is smaller than the %1 mm that remeshing resolves</source>
        <translation>tous les morceaux de la surface sont plus petits que les %1 mm que le remaillage distingue</translation>
    </message>
    <message>
        <source>keep the largest piece first</source>
        <translation>gardez d’abord le plus grand morceau</translation>
    </message>
    <message>
        <source>the surface encloses nothing</source>
        <translation>la surface n’enferme rien</translation>
    </message>
    <message>
        <source>the surface encloses nothing that witness points could lie in</source>
        <translation>la surface n’entoure rien où des points témoins puissent se trouver</translation>
    </message>
    <message>
        <source>the surface has %1 usable triangles, so it encloses nothing</source>
        <translation>la surface a %1 triangles utilisables, elle n’enferme donc rien</translation>
    </message>
    <message>
        <source>the surface has no triangles or is flat, so it encloses nothing</source>
        <translation>la surface n’a pas de triangles ou est plate, elle n’entoure donc rien</translation>
    </message>
    <message>
        <source>the surface has no triangles or no size</source>
        <translation>la surface n’a pas de triangles ou pas d’étendue</translation>
    </message>
    <message>
        <source>the surface has room for %1 of %2 handles</source>
        <translation>la surface a de la place pour %1 poignées sur %2</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres</source>
        <translation>la taille de %1 mm n’est pas plausible pour un organe&#x202f;; les coordonnées sont supposées en millimètres</translation>
    </message>
    <message>
        <source>the size of %1 mm is implausible for an organ; coordinates are assumed to be in millimetres, they may be in %2</source>
        <translation>la taille de %1 mm n’est pas plausible pour un organe&#x202f;; les coordonnées sont supposées en millimètres, mais peuvent être en %2</translation>
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
        <source>the surface is open (%n boundary {edge|edges})</source>
        <translation>
            <numerusform>la surface est ouverte (%n arête de bord)</numerusform>
            <numerusform>la surface est ouverte (%n arêtes de bord)</numerusform>
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
        <source>the surface is too large for GLB, which ends at 4 GB</source>
        <translation>la surface est trop grande pour GLB, qui s’arrête à 4 Go</translation>
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
        <source>the volume at the end of the cycle differs from the volume at its start</source>
        <translation>le volume à la fin du cycle diffère du volume au début</translation>
    </message>
    <message>
        <source>the volume cannot be kept here: %1</source>
        <translation>le volume ne peut pas être gardé ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>the waves are %1 % as deep as in an adult: %2</source>
        <translation>les ondes ont %1 % de la profondeur de celles d’un adulte&#xa0;: %2</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>il y en a %1</translation>
    </message>
    <message>
        <source>there are no tetrahedra in it; the surface may be open</source>
        <translation>elle ne contient pas de tétraèdres&#x202f;; la surface est peut-être ouverte</translation>
    </message>
    <message>
        <source>there is no coordinate system &quot;%1&quot;</source>
        <translation>il n’y a pas de système de coordonnées «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>there is no handle at vertex %1</source>
        <translation>il n’y a pas de poignée au sommet %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>ce fichier ou dossier n’existe pas</translation>
    </message>
    <message>
        <source>there is no surface to write</source>
        <translation>il n’y a pas de surface à écrire</translation>
    </message>
    <message>
        <source>there is no triangle to write</source>
        <translation>il n’y a pas de triangle à écrire</translation>
    </message>
    <message>
        <source>simplifying the surface</source>
        <translation>simplification de la surface</translation>
    </message>
    <message>
        <source>this is a fault of the program; please report it</source>
        <translation>c’est une faute du programme&#x202f;; merci de la signaler</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but neither fundus nor pylorus</source>
        <translation>trop peu de repères&#xa0;: il y a %1 mais ni fundus ni pylorus</translation>
    </message>
    <message>
        <source>too few landmarks: there is %1 but no %2</source>
        <translation>trop peu de repères&#xa0;: il y a %1 mais pas %2</translation>
    </message>
    <message>
        <source>too few landmarks: there is right but neither apex nor base</source>
        <translation>trop peu de repères&#xa0;: il y a right mais ni apex ni base</translation>
    </message>
    <message>
        <source>track surfaces that are not within each other one by one</source>
        <translation>suivez une par une les surfaces qui ne sont pas l’une dans l’autre</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>triangle %1</translation>
    </message>
    <message>
        <source>try another resolution</source>
        <translation>essayez une autre résolution</translation>
    </message>
    <message>
        <source>try another resolution, or a cage without needle-like triangles</source>
        <translation>essayez une autre résolution, ou une cage sans triangles en aiguille</translation>
    </message>
    <message>
        <source>turn its triangles around, as viscera convert IN OUT --orient does</source>
        <translation>retournez ses triangles, par exemple avec viscera convert ENTRÉE SORTIE --orient</translation>
    </message>
    <message>
        <source>turn the surface outward, or choose a target above 0 ml</source>
        <translation>orientez la surface vers l’extérieur, ou choisissez une cible supérieure à 0 ml</translation>
    </message>
    <message>
        <source>turns the surface by a quarter turn, from a model whose y axis points to the head</source>
        <translation>tourne la surface d’un quart de tour, d’un modèle dont l’axe y pointe vers la tête</translation>
    </message>
    <message>
        <source>turns the surface by half a turn, as from RAS to LPS</source>
        <translation>tourne la surface d’un demi-tour, comme de RAS à LPS</translation>
    </message>
    <message>
        <source>turns triangles around so that all of them face outward</source>
        <translation>retourne des triangles pour que tous soient orientés vers l’extérieur</translation>
    </message>
    <message>
        <source>two groups have this name</source>
        <translation>deux groupes ont ce nom</translation>
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
        <source>unsaved work cannot be kept safe: the folder cannot be written to</source>
        <translation>le travail non enregistré ne peut pas être protégé&#xa0;: le dossier n’est pas accessible en écriture</translation>
    </message>
    <message>
        <source>update Viscera</source>
        <translation>mettez Viscera à jour</translation>
    </message>
    <message>
        <source>use .ogv, .mp4, .gif, or a folder for PNG frames</source>
        <translation>utilisez .ogv, .mp4, .gif, ou un dossier pour des images PNG</translation>
    </message>
    <message>
        <source>use images that show all of it in every phase</source>
        <translation>utilisez des images qui le montrent en entier dans chaque phase</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>utilisez l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>values from the section %1 on were not understood and ignored</source>
        <translation>les valeurs à partir de la section %1 n’ont pas été comprises et sont ignorées</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>sommet %1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
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
        <source>wait until the witness points are computed</source>
        <translation>attendez que les points témoins soient calculés</translation>
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
        <translation>onde dans le corps gastrique</translation>
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
        <source>stress profile %1</source>
        <translation>profil de contrainte %1</translation>
    </message>
    <message>
        <source>stress probe</source>
        <translation>sonde de contrainte</translation>
    </message>
    <message>
        <source>stress profile</source>
        <translation>profil de contrainte</translation>
    </message>
    <message>
        <source>A profile needs two probes of one organ</source>
        <translation>Un profil demande deux sondes d’un organe</translation>
    </message>
    <message>
        <source>These two probes have a profile already</source>
        <translation>Ces deux sondes ont déjà un profil</translation>
    </message>
    <message>
        <source>witness points on a grid</source>
        <translation>points témoins sur une grille</translation>
    </message>
    <message>
        <source>women and men have on average %1 to %2 ml</source>
        <translation>femmes et hommes ont en moyenne de %1 à %2 ml</translation>
    </message>
    <message>
        <source>write an .ogv instead</source>
        <translation>écrivez plutôt un .ogv</translation>
    </message>
    <message>
        <source>write lines of the instant and the volume in ml</source>
        <translation>écrivez des lignes avec l’instant et le volume en ml</translation>
    </message>
    <message>
        <source>write the instant and the volume in ml, as in 0.25,98.5</source>
        <translation>écrivez l’instant et le volume en ml, comme dans 0.25,98.5</translation>
    </message>
    <message>
        <source>write volumes in ml</source>
        <translation>écrivez les volumes en ml</translation>
    </message>
    <message>
        <source>writing the movie</source>
        <translation>écriture du film</translation>
    </message>
    <message>
        <source>the organ has no extent</source>
        <translation>l’organe n’a pas d’étendue</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right</source>
        <translation>cœur avec %1 ml à gauche et %2 ml à droite</translation>
    </message>
    <message>
        <source>heart with %1 ml left and %2 ml right, atria with %3 ml left and %4 ml right</source>
        <translation>cœur avec %1 ml à gauche et %2 ml à droite, atriums avec %3 ml à gauche et %4 ml à droite</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml; atria: left off by %3 ml, right by %4 ml</source>
        <translation>Les ventricules ne peuvent pas atteindre leurs volumes&#xa0;: il manque %1 ml à gauche, %2 ml à droite&#x202f;; atriums&#xa0;: %3 ml à gauche, %4 ml à droite</translation>
    </message>
    <message>
        <source>The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml</source>
        <translation>Les ventricules ne peuvent pas atteindre leurs volumes&#xa0;: il manque %1 ml à gauche, %2 ml à droite</translation>
    </message>
    <message>
        <source>check that the cavities lie inside the handles of their walls</source>
        <translation>vérifiez que les cavités sont à l’intérieur des poignées de leurs parois</translation>
    </message>
    <message>
        <source>a centreline needs at least two points</source>
        <translation>une ligne centrale demande au moins deux points</translation>
    </message>
    <message>
        <source>centreline point %1</source>
        <translation>point %1 de la ligne centrale</translation>
    </message>
    <message>
        <source>the point is not finite</source>
        <translation>le point n’est pas fini</translation>
    </message>
    <message>
        <source>the point is where the one before it is</source>
        <translation>le point est à la place du précédent</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>supprimez-le</translation>
    </message>
    <message>
        <source>calibrating the heartbeat</source>
        <translation>calibrage du battement</translation>
    </message>
    <message>
        <source>curve key %1</source>
        <translation>clé %1 de la courbe</translation>
    </message>
    <message>
        <source>the pylorus does not lie beyond the middle of the body</source>
        <translation>le pylore n’est pas au-delà du milieu du corps</translation>
    </message>
    <message>
        <source>gastric waves</source>
        <translation>ondes gastriques</translation>
    </message>
    <message>
        <source>choose the landmarks from the fundus downwards</source>
        <translation>choisissez les repères du fundus vers le bas</translation>
    </message>
    <message>
        <source>the surface has no inside</source>
        <translation>la surface n’a pas d’intérieur</translation>
    </message>
    <message>
        <source>heart landmarks</source>
        <translation>repères du cœur</translation>
    </message>
    <message>
        <source>give apex and base yourself</source>
        <translation>donnez vous-même l’apex et la base</translation>
    </message>
    <message>
        <source>the base does not lie inside the heart</source>
        <translation>la base n’est pas à l’intérieur du cœur</translation>
    </message>
    <message>
        <source>put it on the middle of the mitral valve</source>
        <translation>placez-la au milieu de la valve mitrale</translation>
    </message>
    <message>
        <source>the directions to the right ventricle and to the apex do not span a frame</source>
        <translation>les directions du ventricule droit et de l’apex ne forment pas un repère</translation>
    </message>
    <message>
        <source>heart frame</source>
        <translation>axes du cœur</translation>
    </message>
    <message>
        <source>choose landmarks that do not lie on one line</source>
        <translation>choisissez des repères qui ne sont pas alignés</translation>
    </message>
    <message numerus="yes">
        <source>a ventricle is not where its frame says: only %n {handle meets|handles meet} its wall</source>
        <translation>
            <numerusform>un ventricule n’est pas où ses axes l’indiquent&#xa0;: seule %n poignée touche sa paroi</numerusform>
            <numerusform>un ventricule n’est pas où ses axes l’indiquent&#xa0;: seules %n poignées touchent sa paroi</numerusform>
        </translation>
    </message>
    <message>
        <source>heart rig</source>
        <translation>poignées du cœur</translation>
    </message>
    <message>
        <source>check the landmarks of base, apex and right ventricle</source>
        <translation>vérifiez les repères de la base, de l’apex et du ventricule droit</translation>
    </message>
    <message>
        <source>move it, or lengthen the period</source>
        <translation>déplacez-la ou allongez la période</translation>
    </message>
    <message>
        <source>there is no key</source>
        <translation>il n’y a pas de clé</translation>
    </message>
    <message>
        <source>the heart cannot be brought to the volume that it has to hold</source>
        <translation>le cœur ne peut pas atteindre le volume qu’il doit avoir</translation>
    </message>
    <message>
        <source>heartbeat at %1 s</source>
        <translation>battement à %1 s</translation>
    </message>
    <message>
        <source>check the landmarks of apex and base</source>
        <translation>vérifiez les repères de l’apex et de la base</translation>
    </message>
    <message>
        <source>the upper stomach cannot take in what the waves press out</source>
        <translation>l’estomac supérieur ne peut pas recevoir ce que les ondes déplacent</translation>
    </message>
    <message>
        <source>peristalsis after %1 s</source>
        <translation>péristaltisme après %1 s</translation>
    </message>
    <message>
        <source>check the landmarks</source>
        <translation>vérifiez les repères</translation>
    </message>
    <message>
        <source>the centreline leaves the stomach %1 mm below the top of the fundus</source>
        <translation>la ligne centrale quitte l’estomac %1 mm sous le sommet du fundus</translation>
    </message>
    <message>
        <source>stomach rig</source>
        <translation>poignées de l’estomac</translation>
    </message>
    <message>
        <source>move its points into the stomach</source>
        <translation>déplacez ses points dans l’estomac</translation>
    </message>
    <message>
        <source>the centreline ends before the pylorus</source>
        <translation>la ligne centrale finit avant le pylore</translation>
    </message>
    <message>
        <source>lead it into the duodenum</source>
        <translation>prolongez-la jusque dans le duodénum</translation>
    </message>
    <message numerus="yes">
        <source>Only %n {vertex|vertices} of the surface {lies|lie} there</source>
        <translation>
            <numerusform>Seul %n sommet de la surface s’y trouve</numerusform>
            <numerusform>Seuls %n sommets de la surface s’y trouvent</numerusform>
        </translation>
    </message>
    <message>
        <source>take a finer surface</source>
        <translation>prenez une surface plus fine</translation>
    </message>
    <message>
        <source>base of the left ventricle</source>
        <translation>base du ventricule gauche</translation>
    </message>
    <message>
        <source>apex of the left ventricle</source>
        <translation>apex du ventricule gauche</translation>
    </message>
    <message>
        <source>base of the right ventricle</source>
        <translation>base du ventricule droit</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, inside</source>
        <translation>paroi libre du ventricule gauche, à l’intérieur</translation>
    </message>
    <message>
        <source>free wall of the left ventricle, outside</source>
        <translation>paroi libre du ventricule gauche, à l’extérieur</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus towards the apex</source>
        <translation>excursion de l’anneau mitral vers l’apex</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus at the free wall</source>
        <translation>excursion de l’anneau tricuspide à la paroi libre</translation>
    </message>
    <message>
        <source>turn of the apex against the base</source>
        <translation>rotation de l’apex par rapport à la base</translation>
    </message>
    <message>
        <source>of the left ventricle's free wall in systole</source>
        <translation>de la paroi libre du ventricule gauche en systole</translation>
    </message>
    <message>
        <source>effective areas of normal valves: doi 10.1016/j.echo.2017.02.009</source>
        <translation>surfaces effectives de valves normales&#xa0;: doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.1 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>une régurgitation légère est inférieure à 0,1 cm²&#xa0;: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>mild regurgitation is below 0.2 cm2: doi 10.1016/j.echo.2017.01.007</source>
        <translation>une régurgitation légère est inférieure à 0,2 cm²&#xa0;: doi 10.1016/j.echo.2017.01.007</translation>
    </message>
    <message>
        <source>20 % around the healthy adult at rest</source>
        <translation>20 % autour de l’adulte sain au repos</translation>
    </message>
    <message>
        <source>sinus rhythm at rest</source>
        <translation>rythme sinusal au repos</translation>
    </message>
    <message>
        <source>800 to 1600 dyn s cm^-5, customary at the bedside</source>
        <translation>800 à 1600 dyn s cm^-5, usuel en clinique</translation>
    </message>
    <message>
        <source>up to 2 Wood units</source>
        <translation>jusqu’à 2 unités Wood</translation>
    </message>
    <message>
        <source>the amount in a healthy heart</source>
        <translation>la quantité dans un cœur sain</translation>
    </message>
    <message>
        <source>%1 is out of its range</source>
        <translation>%1 est hors de ses limites</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>from %1 to %2 %3</source>
        <translation>de %1 à %2 %3</translation>
    </message>
    <message>
        <source>the leak area must be smaller than the area of the open valve</source>
        <translation>la surface de fuite doit être inférieure à celle de la valve ouverte</translation>
    </message>
    <message>
        <source>choose a %1 below its %2</source>
        <translation>choisissez %1 inférieur à %2</translation>
    </message>
    <message>
        <source>%1 lies between %2 and %3</source>
        <translation>%1 est entre %2 et %3</translation>
    </message>
    <message>
        <source>An end-diastolic volume in ml</source>
        <translation>Un volume télédiastolique en ml</translation>
    </message>
    <message>
        <source>give the largest volume of the left ventricle</source>
        <translation>donnez le plus grand volume du ventricule gauche</translation>
    </message>
    <message>
        <source>An ejection fraction</source>
        <translation>Une fraction d’éjection</translation>
    </message>
    <message>
        <source>give 55 % as 0.55</source>
        <translation>donnez 55 % comme 0,55</translation>
    </message>
    <message>
        <source>A mean aortic pressure in mmHg</source>
        <translation>Une pression aortique moyenne en mmHg</translation>
    </message>
    <message>
        <source>about a third of the way from the diastolic to the systolic one</source>
        <translation>environ un tiers du chemin de la diastolique à la systolique</translation>
    </message>
    <message>
        <source>fitting the circulation</source>
        <translation>ajustement de la circulation</translation>
    </message>
    <message>
        <source>the circulation of that heart</source>
        <translation>la circulation de ce cœur</translation>
    </message>
    <message>
        <source>The circulation has the measured ventricle: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>La circulation a le ventricule mesuré&#xa0;: %1 ml, fraction d’éjection %2, pression aortique moyenne %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg</source>
        <translation>Aucune circulation n’a exactement ce ventricule&#x202f;; la plus proche&#xa0;: %1 ml, fraction d’éjection %2, pression aortique moyenne %3 mmHg</translation>
    </message>
    <message>
        <source>No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction %2, mean aortic pressure %3 mmHg; at the limit of its range: %4</source>
        <translation>Aucune circulation n’a exactement ce ventricule&#x202f;; la plus proche&#xa0;: %1 ml, fraction d’éjection %2, pression aortique moyenne %3 mmHg&#x202f;; à la limite de son intervalle&#xa0;: %4</translation>
    </message>
    <message>
        <source>the circulation to start with</source>
        <translation>la circulation de départ</translation>
    </message>
    <message numerus="yes">
        <source>After %n {beat|beats} the volumes still change by %2 ml from beat to beat: strong and weak beats alternate, or the circulation fails; try a lower rate or a larger stressed volume</source>
        <translation>
            <numerusform>Après %n battement les volumes changent encore de %2 ml d’un battement à l’autre&#xa0;: des battements forts et faibles alternent, ou la circulation défaille&#x202f;; essayez une fréquence plus basse ou un volume contraint plus grand</numerusform>
            <numerusform>Après %n battements les volumes changent encore de %2 ml d’un battement à l’autre&#xa0;: des battements forts et faibles alternent, ou la circulation défaille&#x202f;; essayez une fréquence plus basse ou un volume contraint plus grand</numerusform>
        </translation>
    </message>
    <message>
        <source>the circulation breaks down: its pressures grow without bounds</source>
        <translation>la circulation s’effondre&#xa0;: ses pressions croissent sans limite</translation>
    </message>
    <message>
        <source>beat %1</source>
        <translation>battement %1</translation>
    </message>
    <message>
        <source>bring the parameters nearer to those at rest, a few at a time</source>
        <translation>rapprochez les paramètres de ceux au repos, quelques-uns à la fois</translation>
    </message>
    <message>
        <source>fitting phase %1</source>
        <translation>ajustement de la phase %1</translation>
    </message>
    <message>
        <source>smoothing phase %1</source>
        <translation>lissage de la phase %1</translation>
    </message>
    <message>
        <source>%1 is %2 mm away on average</source>
        <translation>%1 est à %2 mm en moyenne</translation>
    </message>
    <message>
        <source>a twentieth of %1 is more than %2 mm away</source>
        <translation>un vingtième de %1 est à plus de %2 mm</translation>
    </message>
    <message>
        <source>%1 had to be changed by %2 % to get its volume</source>
        <translation>%1 a dû être modifié de %2 % pour avoir son volume</translation>
    </message>
    <message>
        <source>%1 agrees with its voxels by a Dice of %2 only</source>
        <translation>%1 ne concorde avec ses voxels qu’avec un Dice de %2</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} of %2 {is|are} turned over</source>
        <translation>
            <numerusform>%n triangle de %2 est retourné</numerusform>
            <numerusform>%n triangles de %2 sont retournés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the tissue is folded at %n {place|places}</source>
        <translation>
            <numerusform>le tissu est replié à %n endroit</numerusform>
            <numerusform>le tissu est replié à %n endroits</numerusform>
        </translation>
    </message>
    <message>
        <source>the measured volumes cannot be met</source>
        <translation>les volumes mesurés ne peuvent pas être atteints</translation>
    </message>
    <message numerus="yes">
        <source>%2 handles are too few for %n {surface|surfaces}</source>
        <translation>
            <numerusform>%2 poignées ne suffisent pas pour %n surface</numerusform>
            <numerusform>%2 poignées ne suffisent pas pour %n surfaces</numerusform>
        </translation>
    </message>
    <message>
        <source>ask for fewer</source>
        <translation>demandez-en moins</translation>
    </message>
    <message>
        <source>keeping volumes</source>
        <translation>maintien des volumes</translation>
    </message>
    <message>
        <source>Phase %1 has %2 points and the first has %3</source>
        <translation>La phase %1 a %2 points et la première en a %3</translation>
    </message>
    <message>
        <source>export all phases with the same triangles</source>
        <translation>exportez toutes les phases avec les mêmes triangles</translation>
    </message>
    <message>
        <source>%1, phase %2</source>
        <translation>%1, phase %2</translation>
    </message>
    <message>
        <source>It has no triangle with three different corners</source>
        <translation>Elle n’a aucun triangle à trois sommets différents</translation>
    </message>
    <message>
        <source>It is not a closed surface, even with its holes filled: %1</source>
        <translation>Ce n’est pas une surface fermée, même avec ses trous comblés&#xa0;: %1</translation>
    </message>
    <message>
        <source>repair the surfaces in the program that made them</source>
        <translation>réparez les surfaces dans le programme qui les a faites</translation>
    </message>
    <message>
        <source>the volume cannot be kept throughout the cycle: %1</source>
        <translation>le volume ne peut pas être maintenu pendant tout le cycle&#xa0;: %1</translation>
    </message>
    <message>
        <source>unlock it, or prescribe a volume nearer to that at rest</source>
        <translation>déverrouillez-le ou imposez un volume plus proche de celui au repos</translation>
    </message>
    <message>
        <source>No organ is shown</source>
        <translation>Aucun organe n’est affiché</translation>
    </message>
    <message>
        <source>the lesson</source>
        <translation>la leçon</translation>
    </message>
    <message>
        <source>show those that the lesson is about</source>
        <translation>affichez ceux dont parle la leçon</translation>
    </message>
    <message>
        <source>check the size of the organ, and its motion</source>
        <translation>vérifiez la taille de l’organe et son mouvement</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; returned no binding of the right size</source>
        <translation>le système «&#xa0;%1&#xa0;» n’a pas rendu de liaison de la bonne taille</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed: %2</source>
        <translation>le système «&#xa0;%1&#xa0;» a échoué&#xa0;: %2</translation>
    </message>
    <message>
        <source>system &quot;%1&quot; failed</source>
        <translation>le système «&#xa0;%1&#xa0;» a échoué</translation>
    </message>
    <message>
        <source>choose another system</source>
        <translation>choisissez un autre système</translation>
    </message>
    <message>
        <source>it was made for version %1 of the plugin interface, this program has %2</source>
        <translation>il a été fait pour la version %1 de l’interface des plugins, ce programme a la %2</translation>
    </message>
    <message>
        <source>plugin %1: %2</source>
        <translation>plugin %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>There is already a coordinate system &quot;%1&quot; (%2)</source>
        <translation>Il y a déjà un système de coordonnées «&#xa0;%1&#xa0;» (%2)</translation>
    </message>
    <message>
        <source>remove one of the two, or give one another id</source>
        <translation>supprimez l’un des deux, ou donnez à l’un un autre identifiant</translation>
    </message>
    <message>
        <source>There is no coordinate system &quot;%1&quot;</source>
        <translation>Le système de coordonnées «&#xa0;%1&#xa0;» n’existe pas</translation>
    </message>
    <message>
        <source>none is loaded</source>
        <translation>aucun n’est chargé</translation>
    </message>
    <message>
        <source>none: the organs are as in their files</source>
        <translation>aucune&#xa0;: les organes sont comme dans leurs fichiers</translation>
    </message>
    <message>
        <source>in %1 groups</source>
        <translation>en %1 groupes</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>%1 of them moved</source>
        <translation>dont %1 déplacées</translation>
    </message>
    <message>
        <source>%1 of them shown</source>
        <translation>dont %1 affichés</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organes</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Poignées</translation>
    </message>
    <message>
        <source>Instant</source>
        <translation>Instant</translation>
    </message>
    <message>
        <source>%1, at %2 of its cycle</source>
        <translation>%1, à %2 de son cycle</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(masqué)</translation>
    </message>
    <message>
        <source>open</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message>
        <source>Rest shape (ml)</source>
        <translation>Forme au repos (ml)</translation>
    </message>
    <message>
        <source>Now (ml)</source>
        <translation>Actuel (ml)</translation>
    </message>
    <message>
        <source>Change (ml)</source>
        <translation>Variation (ml)</translation>
    </message>
    <message>
        <source>Change (%)</source>
        <translation>Variation (%)</translation>
    </message>
    <message>
        <source>Surface (cm²)</source>
        <translation>Surface (cm²)</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumes</translation>
    </message>
    <message>
        <source>Open: the surface has holes and holds no volume.</source>
        <translation>Ouvert&#xa0;: la surface a des trous et n’enferme aucun volume.</translation>
    </message>
    <message>
        <source>mean in a rectangle</source>
        <translation>moyenne dans un rectangle</translation>
    </message>
    <message>
        <source>mean in a sphere</source>
        <translation>moyenne dans une sphère</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Mesuré sur</translation>
    </message>
    <message>
        <source>Rest shape</source>
        <translation>Forme au repos</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Actuel</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>the scan</source>
        <translation>l’examen</translation>
    </message>
    <message>
        <source>sample organ &quot;%1&quot;, %2 resolution</source>
        <translation>organe type «&#xa0;%1&#xa0;», résolution %2</translation>
    </message>
    <message>
        <source>low</source>
        <translation>basse</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>high</source>
        <translation>haute</translation>
    </message>
    <message>
        <source>made in the program</source>
        <translation>créé dans le programme</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Findings and repairs</source>
        <translation>Constats et réparations</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Files and what was done to them</source>
        <translation>Fichiers et ce qui en a été fait</translation>
    </message>
    <message>
        <source>All lengths are in millimetres, all volumes in millilitres; positions are in the patient's axes LPS (to the left, to the back, to the head). Viscera is a program for teaching and research, not a medical device.</source>
        <translation>Toutes les longueurs sont en millimètres, tous les volumes en millilitres&#x202f;; les positions sont dans les axes LPS du patient (vers la gauche, vers l’arrière, vers la tête). Viscera est un programme pour l’enseignement et la recherche, pas un dispositif médical.</translation>
    </message>
    <message>
        <source>There is no organ to report on</source>
        <translation>Il n’y a pas d’organe à décrire</translation>
    </message>
    <message>
        <source>Made by Viscera %1 on %2</source>
        <translation>Fait par Viscera %1 le %2</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dessin</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>mesure</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fini</translation>
    </message>
    <message>
        <source>going through the cycle</source>
        <translation>parcours du cycle</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volume (ml)</translation>
    </message>
    <message>
        <source>Volumes over one cycle, each instant computed</source>
        <translation>Volumes sur un cycle, chaque instant calculé</translation>
    </message>
    <message>
        <source>the first %1 of %2 organs</source>
        <translation>les %1 premiers organes sur %2</translation>
    </message>
    <message>
        <source>Smallest (ml)</source>
        <translation>Minimum (ml)</translation>
    </message>
    <message>
        <source>Largest (ml)</source>
        <translation>Maximum (ml)</translation>
    </message>
    <message>
        <source>Ventricle</source>
        <translation>Ventricule</translation>
    </message>
    <message>
        <source>EDV (ml)</source>
        <translation>VTD (ml)</translation>
    </message>
    <message>
        <source>ESV (ml)</source>
        <translation>VTS (ml)</translation>
    </message>
    <message>
        <source>Stroke volume (ml)</source>
        <translation>Volume d’éjection (ml)</translation>
    </message>
    <message>
        <source>EF (%)</source>
        <translation>FE (%)</translation>
    </message>
    <message>
        <source>EF of healthy people</source>
        <translation>FE de personnes saines</translation>
    </message>
    <message>
        <source>Output (l/min)</source>
        <translation>Débit (l/min)</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>%1 a minute, one cycle takes %2 s</source>
        <translation>%1 par minute, un cycle dure %2 s</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phases</translation>
    </message>
    <message>
        <source>Prescribed</source>
        <translation>Imposé</translation>
    </message>
    <message>
        <source>the volume of %1</source>
        <translation>le volume de %1</translation>
    </message>
    <message>
        <source>A volume could not be kept: %1</source>
        <translation>Un volume n’a pas pu être maintenu&#xa0;: %1</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>De la gauche</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>D’en haut</translation>
    </message>
    <message>
        <source>From behind</source>
        <translation>De dos</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>De la droite</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>D’en bas</translation>
    </message>
    <message>
        <source>The map as the session shows it</source>
        <translation>La carte telle que la session la montre</translation>
    </message>
    <message>
        <source>There is no font to write with</source>
        <translation>Il n’y a pas de police pour écrire</translation>
    </message>
    <message>
        <source>install one, such as the package fonts-dejavu-core</source>
        <translation>installez-en une, par exemple le paquet fonts-dejavu-core</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>A report cannot be written to this kind of file</source>
        <translation>Un rapport ne peut pas être écrit dans ce type de fichier</translation>
    </message>
    <message>
        <source>let it end in .pdf or .html</source>
        <translation>faites-le finir par .pdf ou .html</translation>
    </message>
    <message>
        <source>by TetGen</source>
        <translation>par TetGen</translation>
    </message>
    <message>
        <source>by TetGen, from a repaired copy of the surface</source>
        <translation>par TetGen, d’une copie réparée de la surface</translation>
    </message>
    <message>
        <source>by a regular grid</source>
        <translation>par une grille régulière</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>5th percentile</source>
        <translation>5e centile</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95e centile</translation>
    </message>
    <message>
        <source>%1, extreme over a cycle</source>
        <translation>%1, valeur extrême d’un cycle</translation>
    </message>
    <message>
        <source>Points (%)</source>
        <translation>Points (%)</translation>
    </message>
    <message>
        <source>%1 over the witness points</source>
        <translation>%1 aux points témoins</translation>
    </message>
    <message>
        <source>Rotational stress (deg)</source>
        <translation>Contrainte rotationnelle (degrés)</translation>
    </message>
    <message>
        <source>Over one cycle of the sequence</source>
        <translation>Sur un cycle de la séquence</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Place (mm)</source>
        <translation>Lieu (mm)</translation>
    </message>
    <message>
        <source>no tissue</source>
        <translation>pas de tissu</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>replié</translation>
    </message>
    <message>
        <source>Distance at rest (mm)</source>
        <translation>Distance au repos (mm)</translation>
    </message>
    <message>
        <source>Along the straight lines at rest between probes</source>
        <translation>Le long des droites au repos entre les sondes</translation>
    </message>
    <message>
        <source>Tissue distortion (rotational stress)</source>
        <translation>Distorsion du tissu (contrainte rotationnelle)</translation>
    </message>
    <message>
        <source>Witness points</source>
        <translation>Points témoins</translation>
    </message>
    <message>
        <source>%1 in %2 tetrahedra</source>
        <translation>%1 dans %2 tétraèdres</translation>
    </message>
    <message>
        <source>Derivatives</source>
        <translation>Dérivées</translation>
    </message>
    <message>
        <source>in closed form (analytic)</source>
        <translation>en forme close (analytique)</translation>
    </message>
    <message>
        <source>by central differences</source>
        <translation>par différences centrées</translation>
    </message>
    <message>
        <source>no point: the tissue is turned inside out nowhere</source>
        <translation>aucun point&#xa0;: le tissu n’est retourné nulle part</translation>
    </message>
    <message>
        <source>%1 of %2 points are turned inside out</source>
        <translation>%1 points sur %2 sont retournés</translation>
    </message>
    <message>
        <source>Rotational stress is the largest angle by which a direction is turned when the tissue is stretched. It measures distortion and is not a pressure.</source>
        <translation>La contrainte rotationnelle est le plus grand angle dont une direction tourne quand le tissu est étiré. Elle mesure la distorsion et n’est pas une pression.</translation>
    </message>
    <message>
        <source>± %1, %2 to %3, %4, %5 voxels</source>
        <translation>± %1; de %2 à %3; %4; %5 voxels</translation>
    </message>
    <message>
        <source>The view cannot be restored completely</source>
        <translation>La vue ne peut pas être rétablie entièrement</translation>
    </message>
    <message>
        <source>the session's view</source>
        <translation>la vue de la session</translation>
    </message>
    <message>
        <source>the organs and the handles are complete; save the session anew</source>
        <translation>les organes et les poignées sont complets&#x202f;; enregistrez de nouveau la session</translation>
    </message>
    <message>
        <source>women</source>
        <translation>femmes</translation>
    </message>
    <message>
        <source>men</source>
        <translation>hommes</translation>
    </message>
    <message>
        <source>women and men</source>
        <translation>femmes et hommes</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations</source>
        <translation>%1, moyenne ± 2 écarts types</translation>
    </message>
    <message>
        <source>%1, on average</source>
        <translation>%1, en moyenne</translation>
    </message>
    <message>
        <source>%1, mean +- 2 standard deviations, for %2 m2 of body surface</source>
        <translation>%1, moyenne ± 2 écarts types, pour %2 m² de surface corporelle</translation>
    </message>
    <message>
        <source>%1, on average, for %2 m2 of body surface</source>
        <translation>%1, en moyenne, pour %2 m² de surface corporelle</translation>
    </message>
    <message>
        <source>800 healthy people of 45 to 74 years, by magnetic resonance, papillary muscles counted as cavity</source>
        <translation>800 personnes saines de 45 à 74 ans, par résonance magnétique, muscles papillaires comptés dans la cavité</translation>
    </message>
    <message>
        <source>ICRP publication 89, doi 10.1016/S0146-6453(03)00002-2</source>
        <translation>CIPR, publication 89, doi 10.1016/S0146-6453(03)00002-2</translation>
    </message>
    <message>
        <source>1815 people without kidney disease, by magnetic resonance; the deviation is that of the quartiles</source>
        <translation>1815 personnes sans maladie rénale, par résonance magnétique&#x202f;; l’écart est celui des quartiles</translation>
    </message>
    <message>
        <source>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (spread), and &quot;Simplifying the measurement of gastric accommodation using SPECT&quot; (mean)</source>
        <translation>Breen 2011, doi 10.1111/j.1365-2982.2010.01660.x (dispersion), et «&#xa0;Simplifying the measurement of gastric accommodation using SPECT&#xa0;» (moyenne)</translation>
    </message>
    <message>
        <source>customary at the bedside</source>
        <translation>usuel en clinique</translation>
    </message>
    <message>
        <source>Whelton 2018, doi 10.1161/HYP.0000000000000065: normal is below 120/80; the lower bound is customary</source>
        <translation>Whelton 2018, doi 10.1161/HYP.0000000000000065&#xa0;: la normale est inférieure à 120/80&#x202f;; la limite inférieure est celle d’usage</translation>
    </message>
    <message>
        <source>mass of the muscle</source>
        <translation>masse du muscle</translation>
    </message>
    <message>
        <source>1969 healthy people at rest, by tissue Doppler</source>
        <translation>1969 personnes saines au repos, par Doppler tissulaire</translation>
    </message>
    <message>
        <source>ejection time</source>
        <translation>temps d’éjection</translation>
    </message>
    <message>
        <source>healthy adults, by magnetic resonance and ultrasound</source>
        <translation>adultes sains, par résonance magnétique et échographie</translation>
    </message>
    <message>
        <source>excursion of the mitral annulus (MAPSE)</source>
        <translation>excursion de l’anneau mitral (MAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 16.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); ultrasound finds less, 12 to 15 mm</source>
        <translation>résonance magnétique&#xa0;: 16,4 mm (Carlsson et autres 2007, doi 10.1152/ajpheart.01376.2006)&#x202f;; l’échographie donne moins, de 12 à 15 mm</translation>
    </message>
    <message>
        <source>excursion of the tricuspid annulus (TAPSE)</source>
        <translation>excursion de l’anneau tricuspide (TAPSE)</translation>
    </message>
    <message>
        <source>magnetic resonance: 23.4 mm (Carlsson and others 2007, doi 10.1152/ajpheart.01376.2006); below 17 mm is abnormal in ultrasound (Lang and others 2015, doi 10.1016/j.echo.2014.10.003)</source>
        <translation>résonance magnétique&#xa0;: 23,4 mm (Carlsson et autres 2007, doi 10.1152/ajpheart.01376.2006)&#x202f;; en échographie, moins de 17 mm est anormal (Lang et autres 2015, doi 10.1016/j.echo.2014.10.003)</translation>
    </message>
    <message>
        <source>twist of the apex against the base</source>
        <translation>torsion de l’apex par rapport à la base</translation>
    </message>
    <message>
        <source>magnetic resonance: apex about 10, base about 3 degrees the other way (Young and Cowan 2012, doi 10.1186/1532-429X-14-49)</source>
        <translation>résonance magnétique&#xa0;: apex environ 10 degrés, base environ 3 en sens inverse (Young et Cowan 2012, doi 10.1186/1532-429X-14-49)</translation>
    </message>
    <message>
        <source>thickening of the free wall</source>
        <translation>épaississement de la paroi libre</translation>
    </message>
    <message>
        <source>magnetic resonance: 4.4 +- 1.4 mm in the middle slices (Ubachs and others 2009, doi 10.1186/1532-429X-11-S1-P61)</source>
        <translation>résonance magnétique&#xa0;: 4,4 ± 1,4 mm dans les coupes moyennes (Ubachs et autres 2009, doi 10.1186/1532-429X-11-S1-P61)</translation>
    </message>
    <message>
        <source>healthy adults at rest</source>
        <translation>adultes sains au repos</translation>
    </message>
    <message>
        <source>systolic pressure</source>
        <translation>pression systolique</translation>
    </message>
    <message>
        <source>diastolic pressure</source>
        <translation>pression diastolique</translation>
    </message>
    <message>
        <source>mean pressure</source>
        <translation>pression moyenne</translation>
    </message>
    <message>
        <source>end-diastolic pressure</source>
        <translation>pression télédiastolique</translation>
    </message>
    <message>
        <source>fastest rise of pressure</source>
        <translation>montée la plus rapide de la pression</translation>
    </message>
    <message>
        <source>coupling Ea/Ees</source>
        <translation>couplage Ea/Ees</translation>
    </message>
    <message>
        <source>mean gradient</source>
        <translation>gradient moyen</translation>
    </message>
    <message>
        <source>regurgitant fraction</source>
        <translation>fraction de régurgitation</translation>
    </message>
    <message>
        <source>Kovacs 2009, doi 10.1183/09031936.00145608: mean +- 2 standard deviations</source>
        <translation>Kovacs 2009, doi 10.1183/09031936.00145608&#xa0;: moyenne ± 2 écarts types</translation>
    </message>
    <message>
        <source>between the most efficient (0.5) and the most powerful coupling (1): Burkhoff and Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</source>
        <translation>entre le couplage le plus efficient (0,5) et le plus puissant (1)&#xa0;: Burkhoff et Sagawa 1986, doi 10.1152/ajpregu.1986.250.6.R1021</translation>
    </message>
    <message>
        <source>reference woman and man; no spread is given</source>
        <translation>femme et homme de référence&#x202f;; la dispersion n’est pas donnée</translation>
    </message>
    <message>
        <source>1248 people without liver disease, by magnetic resonance</source>
        <translation>1248 personnes sans maladie du foie, par résonance magnétique</translation>
    </message>
    <message>
        <source>212 adults, by CT</source>
        <translation>212 adultes, par TDM</translation>
    </message>
    <message>
        <source>adults of 20 to 60 years, by CT</source>
        <translation>adultes de 20 à 60 ans, par TDM</translation>
    </message>
    <message>
        <source>contents after a meal</source>
        <translation>contenu après un repas</translation>
    </message>
    <message>
        <source>443 people after a meal, by single-photon tomography</source>
        <translation>443 personnes après un repas, par tomographie monophotonique</translation>
    </message>
    <message>
        <source>contents of 443 people after a meal, by single-photon tomography, and 138 ml of wall (ICRP publication 89)</source>
        <translation>contenu de 443 personnes après un repas, par tomographie monophotonique, et 138 ml de paroi (publication 89 de la CIPR)</translation>
    </message>
    <message>
        <source>adults, by electrogastrography</source>
        <translation>adultes, par électrogastrographie</translation>
    </message>
    <message>
        <source>Yin and Chen 2013, doi 10.5056/jnm.2013.19.1.5</source>
        <translation>Yin et Chen 2013, doi 10.5056/jnm.2013.19.1.5</translation>
    </message>
    <message>
        <source>speed of the waves</source>
        <translation>vitesse des ondes</translation>
    </message>
    <message>
        <source>occlusion of the antrum by a wave</source>
        <translation>occlusion de l’antre par une onde</translation>
    </message>
    <message>
        <source>28 healthy people, by magnetic resonance</source>
        <translation>28 personnes saines, par résonance magnétique</translation>
    </message>
    <message>
        <source>adults at rest</source>
        <translation>adultes au repos</translation>
    </message>
    <message>
        <source>part that is inspiration</source>
        <translation>part de l’inspiration</translation>
    </message>
    <message>
        <source>adults at rest, from 1 : 2 to 1 : 1</source>
        <translation>adultes au repos, de 1&#xa0;: 2 à 1&#xa0;: 1</translation>
    </message>
    <message>
        <source>way down in quiet breathing</source>
        <translation>descente en respiration calme</translation>
    </message>
    <message>
        <source>what several studies measured</source>
        <translation>ce que plusieurs études ont mesuré</translation>
    </message>
    <message>
        <source>there are no handles to save</source>
        <translation>il n’y a pas de poignées à enregistrer</translation>
    </message>
    <message>
        <source>There is no scan to export</source>
        <translation>Il n’y a pas d’examen à exporter</translation>
    </message>
    <message>
        <source>There are no handles that could warp the scan</source>
        <translation>Il n’y a pas de poignées pour déformer l’examen</translation>
    </message>
    <message>
        <source>Writing the scan</source>
        <translation>Écriture de l’examen</translation>
    </message>
    <message>
        <source>9 healthy people, by magnetic resonance; 28 people of doi 10.1046/j.1365-2982.2001.00285.x have 1.6 +- 0.2</source>
        <translation>9 personnes saines, par résonance magnétique&#x202f;; 28 personnes de doi 10.1046/j.1365-2982.2001.00285.x ont 1,6 ± 0,2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>à partir de %1</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>jusqu’à %1</translation>
    </message>
    <message>
        <source>the sample organs cannot be listed: %1</source>
        <translation>les organes types ne peuvent pas être listés&#xa0;: %1</translation>
    </message>
    <message>
        <source>set VISCERA_SAMPLE_ORGANS to the folder of the definitions</source>
        <translation>mettez dans VISCERA_SAMPLE_ORGANS le dossier des définitions</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Le fichier ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>its segment %1 has no valid value or layer</source>
        <translation>son segment %1 n’a pas de valeur ou de couche valable</translation>
    </message>
    <message>
        <source>the table of names in it cannot be read</source>
        <translation>la table de noms qu’il contient ne peut pas être lue</translation>
    </message>
    <message>
        <source>its voxels are no plain numbers (%1)</source>
        <translation>ses voxels ne sont pas de simples nombres (%1)</translation>
    </message>
    <message>
        <source>It is not a surface</source>
        <translation>Ce n’est pas une surface</translation>
    </message>
    <message>
        <source>It is not a label map</source>
        <translation>Ce n’est pas une carte d’étiquettes</translation>
    </message>
    <message>
        <source>an archive</source>
        <translation>une archive</translation>
    </message>
    <message>
        <source>a CAD model</source>
        <translation>un modèle de CAO</translation>
    </message>
    <message>
        <source>a scene of a 3D program</source>
        <translation>une scène d’un logiciel 3D</translation>
    </message>
    <message>
        <source>a scene of 3D Slicer</source>
        <translation>une scène de 3D Slicer</translation>
    </message>
    <message>
        <source>a document</source>
        <translation>un document</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>un tableau</translation>
    </message>
    <message>
        <source>export it as STL, OBJ, PLY or GLB</source>
        <translation>exportez-le en STL, OBJ, PLY ou GLB</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>décompressez-le d’abord</translation>
    </message>
    <message>
        <source>open the images that it was made from: a DICOM series, NIfTI, NRRD or MetaImage</source>
        <translation>ouvrez les images dont il provient : une série DICOM, NIfTI, NRRD ou MetaImage</translation>
    </message>
    <message>
        <source>save its surface as .vtp, or its image as .mha, in ParaView or 3D Slicer</source>
        <translation>enregistrez sa surface en .vtp ou son image en .mha, dans ParaView ou 3D Slicer</translation>
    </message>
    <message>
        <source>open a file of organs, handles or a sequence</source>
        <translation>ouvrez un fichier d’organes, de poignées ou de séquence</translation>
    </message>
    <message>
        <source>save its segmentation and its models in 3D Slicer, and open these</source>
        <translation>enregistrez sa segmentation et ses modèles dans 3D Slicer, puis ouvrez-les</translation>
    </message>
    <message>
        <source>open the files of the organs</source>
        <translation>ouvrez les fichiers des organes</translation>
    </message>
    <message>
        <source>divide its polygons into triangles in the program that made it, and export it again</source>
        <translation>divisez ses polygones en triangles dans le programme qui l’a créé, puis exportez-le à nouveau</translation>
    </message>
    <message numerus="yes">
        <source>%n {polygon that is not flat was|polygons that are not flat were} cut into triangles that overlap</source>
        <translation>
            <numerusform>%n polygone qui n’est pas plan a été divisé en triangles qui se chevauchent</numerusform>
            <numerusform>%n polygones qui ne sont pas plans ont été divisés en triangles qui se chevauchent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face|faces} of fewer than three corners left out</source>
        <translation>
            <numerusform>%n face de moins de trois sommets omise</numerusform>
            <numerusform>%n faces de moins de trois sommets omises</numerusform>
        </translation>
    </message>
    <message>
        <source>the colours in %1 are missing: %2</source>
        <translation>les couleurs de %1 manquent : %2</translation>
    </message>
    <message>
        <source>Its geometry is compressed (%1), which Viscera does not read</source>
        <translation>Sa géométrie est compressée (%1), ce que Viscera ne lit pas</translation>
    </message>
    <message>
        <source>export it without compression (in Blender: leave out Data &gt; Compression), or as STL or PLY</source>
        <translation>exportez-le sans compression (dans Blender : sans Data &gt; Compression), ou en STL ou PLY</translation>
    </message>
    <message>
        <source>save the surfaces as .vtp</source>
        <translation>enregistrez les surfaces en .vtp</translation>
    </message>
    <message>
        <source>It names no surface files</source>
        <translation>Il ne nomme aucun fichier de surface</translation>
    </message>
    <message numerus="yes">
        <source>%n {block|blocks} without a surface ignored</source>
        <translation>
            <numerusform>%n bloc sans surface ignoré</numerusform>
            <numerusform>%n blocs sans surface ignorés</numerusform>
        </translation>
    </message>
    <message>
        <source>a block is at %1, but only files beside it are read</source>
        <translation>un bloc se trouve à %1, mais seuls les fichiers à côté sont lus</translation>
    </message>
    <message>
        <source>the block %1 is no surface and was left out</source>
        <translation>le bloc %1 n’est pas une surface et a été omis</translation>
    </message>
    <message>
        <source>its block %1 holds blocks of its own in another file</source>
        <translation>son bloc %1 contient lui-même des blocs dans un autre fichier</translation>
    </message>
    <message>
        <source>its block %1 cannot be read: %2</source>
        <translation>son bloc %1 ne peut pas être lu : %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 autres</translation>
    </message>
    <message numerus="yes">
        <source>%n {open part|open parts} that share points were joined to one organ: %2</source>
        <translation>
            <numerusform>%n partie ouverte ayant des points communs ont été réunies en un organe : %2</numerusform>
            <numerusform>%n parties ouvertes ayant des points communs ont été réunies en un organe : %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It holds %n {organ|organs}: %2</source>
        <translation>
            <numerusform>Il contient %n organe : %2</numerusform>
            <numerusform>Il contient %n organes : %2</numerusform>
        </translation>
    </message>
    <message>
        <source>name one of them behind a slash: %1</source>
        <translation>nommez l’un d’eux derrière une barre oblique : %1</translation>
    </message>
    <message>
        <source>%1 lies inside %2, whose volume contains its volume</source>
        <translation>%1 se trouve dans %2, dont le volume contient le sien</translation>
    </message>
    <message>
        <source>the commas in its numbers may be decimal marks or separate thousands or numbers</source>
        <translation>les virgules de ses nombres peuvent être des marques décimales ou séparer des milliers ou des nombres</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>exportez-le avec des points décimaux</translation>
    </message>
    <message>
        <source>the commas in its numbers were read as decimal marks</source>
        <translation>les virgules de ses nombres ont été lues comme marques décimales</translation>
    </message>
    <message>
        <source>It holds several organs</source>
        <translation>Il contient plusieurs organes</translation>
    </message>
    <message>
        <source>its voxels are in another folder (%1)</source>
        <translation>ses voxels sont dans un autre dossier (%1)</translation>
    </message>
    <message>
        <source>it is an Analyze 7.5 image, which does not say where it lies: its axes are taken as %1, and left and right may be exchanged</source>
        <translation>c’est une image Analyze 7.5, qui ne dit pas où elle se trouve : ses axes sont pris pour %1, et la gauche et la droite peuvent être échangées</translation>
    </message>
    <message>
        <source>it does not say where it lies; coronal slices of 1 mm are assumed, as FreeSurfer does</source>
        <translation>il ne dit pas où il se trouve ; des coupes coronales de 1 mm sont supposées, comme le fait FreeSurfer</translation>
    </message>
    <message>
        <source>one of its labels in group %1 has no valid number or image</source>
        <translation>une de ses étiquettes du groupe %1 n’a pas de numéro ou d’image valables</translation>
    </message>
    <message>
        <source>its values are not exactly whole numbers; they were rounded to labels, by at most %1</source>
        <translation>ses valeurs ne sont pas exactement des nombres entiers ; elles ont été arrondies à des étiquettes, de %1 au plus</translation>
    </message>
    <message>
        <source>It has %1 label maps over time, of which one is needed here</source>
        <translation>Il contient %1 cartes d’étiquettes au cours du temps, dont une est nécessaire ici</translation>
    </message>
    <message>
        <source>It has %1 label maps over time (at %2 ms), of which one is needed here</source>
        <translation>Il contient %1 cartes d’étiquettes au cours du temps (à %2 ms), dont une est nécessaire ici</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or choose one with --phase, from 0 to %2</source>
        <translation>suivez le mouvement sur toutes avec viscera track %1, ou choisissez-en une avec --phase, de 0 à %2</translation>
    </message>
    <message>
        <source>its segments %1 have the same voxels (label %2 in one layer); they are one organ, %3</source>
        <translation>ses segments %1 ont les mêmes voxels (étiquette %2 dans une couche) ; ils sont un seul organe, %3</translation>
    </message>
    <message>
        <source>the names of its labels are those of FreeSurfer's colour table</source>
        <translation>les noms de ses étiquettes sont ceux de la table de couleurs de FreeSurfer</translation>
    </message>
    <message>
        <source>It has several layers of one label map, not several phases</source>
        <translation>Il contient plusieurs couches d’une carte d’étiquettes, et non plusieurs phases</translation>
    </message>
    <message>
        <source>write a .nhdr or .mhd header for it, which says its size</source>
        <translation>écrivez pour lui un en-tête .nhdr ou .mhd, qui dit sa taille</translation>
    </message>
    <message>
        <source>a segmentation</source>
        <translation>une segmentation</translation>
    </message>
    <message>
        <source>open the images or the segmentation of the same patient, which are other files</source>
        <translation>ouvrez les images ou la segmentation du même patient, qui sont d’autres fichiers</translation>
    </message>
    <message>
        <source>It is the table of contents of a DICOM medium (DICOMDIR)</source>
        <translation>C’est la table des matières d’un support DICOM (DICOMDIR)</translation>
    </message>
    <message>
        <source>open the folder that it lists, %1</source>
        <translation>ouvrez le dossier qu’elle décrit, %1</translation>
    </message>
    <message>
        <source>open it as a label map</source>
        <translation>ouvrez-la comme carte d’étiquettes</translation>
    </message>
    <message>
        <source>open it as a surface</source>
        <translation>ouvrez-la comme surface</translation>
    </message>
    <message>
        <source>It is a DICOM file that holds no scan, label map or surface: %1</source>
        <translation>C’est un fichier DICOM sans examen, carte d’étiquettes ni surface : %1</translation>
    </message>
    <message>
        <source>an object of an unknown kind</source>
        <translation>un objet d’un type inconnu</translation>
    </message>
    <message>
        <source>its pixels are packed in a way that is not supported</source>
        <translation>ses pixels sont compressés d’une manière non prise en charge</translation>
    </message>
    <message>
        <source>save it without compression</source>
        <translation>enregistrez-le sans compression</translation>
    </message>
    <message>
        <source>It is a segmentation that %1</source>
        <translation>C’est une segmentation qui %1</translation>
    </message>
    <message>
        <source>its segment 0 (%1) has got the label %2</source>
        <translation>son segment 0 (%1) a reçu l’étiquette %2</translation>
    </message>
    <message>
        <source>its fractions are all 0 or 1 of a larger whole; 1 was read as inside</source>
        <translation>ses fractions sont toutes 0 ou 1 d’un tout plus grand ; 1 a été lu comme intérieur</translation>
    </message>
    <message>
        <source>its pixels of one bit are packed in a way that is not supported (%1)</source>
        <translation>ses pixels d’un bit sont compressés d’une manière non prise en charge (%1)</translation>
    </message>
    <message>
        <source>It is a DICOM image, not a surface</source>
        <translation>C’est une image DICOM, pas une surface</translation>
    </message>
    <message>
        <source>make a label map of it first, or open it as one</source>
        <translation>faites-en d’abord une carte d’étiquettes, ou ouvrez-la comme telle</translation>
    </message>
    <message>
        <source>the file does not state its axes: RAS is assumed, as 3D Slicer does</source>
        <translation>le fichier n’indique pas ses axes : RAS est supposé, comme le fait 3D Slicer</translation>
    </message>
    <message numerus="yes">
        <source>%2 and %n more</source>
        <translation>
            <numerusform>%2 et %n autre</numerusform>
            <numerusform>%2 et %n autres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point was|points were} never placed (%2), and there is no other</source>
        <translation>
            <numerusform>%n point n’a jamais été placé (%2), et il n’y en a pas d’autre</numerusform>
            <numerusform>%n points n’ont jamais été placés (%2), et il n’y en a pas d’autre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {point that was never placed is|points that were never placed are} left out: %2</source>
        <translation>
            <numerusform>%n point qui n’a jamais été placé est omis : %2</numerusform>
            <numerusform>%n points qui n’ont jamais été placés sont omis : %2</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds no points, but %1</source>
        <translation>Le fichier ne contient pas de points, mais %1</translation>
    </message>
    <message>
        <source>copy its control points into a point list in Slicer's module Markups, and save the list</source>
        <translation>copiez ses points de contrôle dans une liste de points du module Markups de Slicer, et enregistrez la liste</translation>
    </message>
    <message numerus="yes">
        <source>%n {object that the file does not place is|objects that the file does not place are} left out</source>
        <translation>
            <numerusform>%n objet que le fichier ne place pas est omis</numerusform>
            <numerusform>%n objets que le fichier ne place pas sont omis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {object that only supports a print is|objects that only support a print are} left out</source>
        <translation>
            <numerusform>%n objet qui ne fait que soutenir une impression est omis</numerusform>
            <numerusform>%n objets qui ne font que soutenir une impression sont omis</numerusform>
        </translation>
    </message>
    <message>
        <source>colours that come from pictures or mixtures are left out</source>
        <translation>les couleurs issues d’images ou de mélanges sont omises</translation>
    </message>
    <message>
        <source>beams and other shapes that are no triangles are left out</source>
        <translation>les poutres et les autres formes qui ne sont pas des triangles sont omises</translation>
    </message>
    <message>
        <source>export it without a password</source>
        <translation>exportez-le sans mot de passe</translation>
    </message>
    <message>
        <source>It is a ZIP archive without a 3D model</source>
        <translation>C’est une archive ZIP sans modèle 3D</translation>
    </message>
    <message>
        <source>unpack it and open the files in it</source>
        <translation>décompressez-la et ouvrez les fichiers qu’elle contient</translation>
    </message>
    <message>
        <source>the surface is too large for 3MF, whose parts end at 4 GB</source>
        <translation>la surface est trop grande pour 3MF, dont les parties s’arrêtent à 4 Go</translation>
    </message>
    <message>
        <source>zlib cannot pack it</source>
        <translation>zlib ne peut pas la compresser</translation>
    </message>
    <message>
        <source>tetrahedra are written as .inp or .vtu only</source>
        <translation>les tétraèdres ne s’écrivent qu’en .inp ou .vtu</translation>
    </message>
    <message>
        <source>the surface %1 is open (%2 boundary edges)</source>
        <translation>la surface %1 est ouverte (%2 arêtes de bord)</translation>
    </message>
    <message>
        <source>the surfaces %1 and %2 share points</source>
        <translation>les surfaces %1 et %2 ont des points communs</translation>
    </message>
    <message>
        <source>move them apart: there is no tissue between them</source>
        <translation>écartez-les : il n’y a pas de tissu entre elles</translation>
    </message>
    <message>
        <source>a cavity is not wholly inside the organ, or inside another cavity</source>
        <translation>une cavité n’est pas entièrement dans l’organe, ou est dans une autre cavité</translation>
    </message>
    <message>
        <source>leave it out, or make it smaller</source>
        <translation>omettez-la ou rendez-la plus petite</translation>
    </message>
    <message>
        <source>It is of gmsh's format %1, which Viscera does not read</source>
        <translation>Il est au format %1 de gmsh, que Viscera ne lit pas</translation>
    </message>
    <message>
        <source>open it with gmsh and save it as version 2 or 4</source>
        <translation>ouvrez-le avec gmsh et enregistrez-le en version 2 ou 4</translation>
    </message>
    <message>
        <source>It is a plane mesh, of two dimensions</source>
        <translation>C’est un maillage plan, à deux dimensions</translation>
    </message>
    <message>
        <source>export a mesh of three dimensions</source>
        <translation>exportez un maillage à trois dimensions</translation>
    </message>
    <message>
        <source>openCARP states points in micrometres: its numbers were divided by 1,000</source>
        <translation>openCARP donne les points en micromètres : ses nombres ont été divisés par 1000</translation>
    </message>
    <message>
        <source>%1 has more lines than the %2 points that it states; they were left out</source>
        <translation>%1 a plus de lignes que les %2 points annoncés ; elles ont été omises</translation>
    </message>
    <message>
        <source>It has elements of the type %1, which Viscera does not read</source>
        <translation>Il a des éléments du type %1, que Viscera ne lit pas</translation>
    </message>
    <message>
        <source>save the mesh as tetrahedra</source>
        <translation>enregistrez le maillage en tétraèdres</translation>
    </message>
    <message>
        <source>reduce the mesh first</source>
        <translation>réduisez d’abord le maillage</translation>
    </message>
    <message>
        <source>its %1 regions (%2) were joined to one surface around all of them</source>
        <translation>ses %1 régions (%2) ont été réunies en une surface qui les entoure toutes</translation>
    </message>
    <message numerus="yes">
        <source>%n {cell that repeats|cells that repeat} another left out</source>
        <translation>
            <numerusform>%n cellule qui en répète une autre omise</numerusform>
            <numerusform>%n cellules qui en répètent d’autres omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {face belongs|faces belong} to more than two cells, which overlap</source>
        <translation>
            <numerusform>%n face appartient à plus de deux cellules, qui se chevauchent</numerusform>
            <numerusform>%n faces appartiennent à plus de deux cellules, qui se chevauchent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {flat cell that bounds|flat cells that bound} no cell with a volume left out</source>
        <translation>
            <numerusform>%n cellule plate qui ne borde aucune cellule à volume omise</numerusform>
            <numerusform>%n cellules plates qui ne bordent aucune cellule à volume omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n curved {cell was|cells were} read as straight between {its|their} corners</source>
        <translation>
            <numerusform>%n cellule courbe a été lue comme droite entre ses sommets</numerusform>
            <numerusform>%n cellules courbes ont été lues comme droites entre leurs sommets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has %n {cavity|cavities}: its volume is that of the wall around {it|them}</source>
        <translation>
            <numerusform>elle a %n cavité : son volume est celui de la paroi qui l’entoure</numerusform>
            <numerusform>elle a %n cavités : son volume est celui de la paroi qui les entoure</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n small {gap|gaps} between its cells filled</source>
        <translation>
            <numerusform>%n petit espace rempli entre ses cellules</numerusform>
            <numerusform>%n petits espaces remplis entre ses cellules</numerusform>
        </translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Cavité</translation>
    </message>
    <message numerus="yes">
        <source>%n {triangle|triangles} that CARTO's user has cut away left out</source>
        <translation>
            <numerusform>%n triangle coupé dans CARTO omis</numerusform>
            <numerusform>%n triangles coupés dans CARTO omis</numerusform>
        </translation>
    </message>
    <message>
        <source>it does not say where its scan is: its points stay in FreeSurfer's own coordinates, which may be some millimetres beside the scan</source>
        <translation>elle ne dit pas où se trouve son examen : ses points restent dans les coordonnées propres de FreeSurfer, qui peuvent être décalées de quelques millimètres</translation>
    </message>
    <message>
        <source>It holds values at the points of a surface, such as curvature or thickness, not a surface</source>
        <translation>Il contient des valeurs aux points d’une surface, comme la courbure ou l’épaisseur, pas une surface</translation>
    </message>
    <message>
        <source>open the surface to which they belong, such as lh.white or lh.pial</source>
        <translation>ouvrez la surface à laquelle elles appartiennent, comme lh.white ou lh.pial</translation>
    </message>
    <message>
        <source>its points were moved from FreeSurfer's own coordinates to those of its scan</source>
        <translation>ses points ont été déplacés des coordonnées propres de FreeSurfer à celles de son examen</translation>
    </message>
    <message numerus="yes">
        <source>%n further {surface|surfaces} of the file left out</source>
        <translation>
            <numerusform>%n autre surface du fichier omise</numerusform>
            <numerusform>%n autres surfaces du fichier omises</numerusform>
        </translation>
    </message>
    <message>
        <source>It holds values at the points of a surface (%1), not a surface</source>
        <translation>Il contient des valeurs aux points d’une surface (%1), pas une surface</translation>
    </message>
    <message>
        <source>open the surface to which they belong, which usually ends in .surf.gii</source>
        <translation>ouvrez la surface à laquelle elles appartiennent, qui se termine d’habitude par .surf.gii</translation>
    </message>
    <message>
        <source>It holds no surface of triangles</source>
        <translation>Il ne contient aucune surface de triangles</translation>
    </message>
    <message>
        <source>Its values are in another file, %1, which Viscera does not read</source>
        <translation>Ses valeurs sont dans un autre fichier, %1, que Viscera ne lit pas</translation>
    </message>
    <message>
        <source>save it with its values inside (GZipBase64Binary)</source>
        <translation>enregistrez-le avec ses valeurs à l’intérieur (GZipBase64Binary)</translation>
    </message>
    <message>
        <source>its points were moved to the scan by the matrix that the file states</source>
        <translation>ses points ont été déplacés vers l’examen par la matrice que donne le fichier</translation>
    </message>
    <message>
        <source>its matrix from %1 to %2 was not applied</source>
        <translation>sa matrice de %1 à %2 n’a pas été appliquée</translation>
    </message>
    <message>
        <source>save it as %1 with %2</source>
        <translation>enregistrez-le en %1 avec %2</translation>
    </message>
    <message>
        <source>load it in 3D Slicer with its images, convert it to a segmentation there, and save that as .seg.nrrd</source>
        <translation>chargez-le dans 3D Slicer avec ses images, convertissez-le en segmentation et enregistrez celle-ci en .seg.nrrd</translation>
    </message>
    <message>
        <source>It holds %1, not %2</source>
        <translation>Le fichier contient %1, pas %2</translation>
    </message>
    <message>
        <source>its unit %1 is not known; mm are assumed</source>
        <translation>son unité %1 est inconnue ; des mm sont supposés</translation>
    </message>
    <message>
        <source>converted from %1 to mm</source>
        <translation>converti de %1 en mm</translation>
    </message>
    <message>
        <source>the other file that belongs to it, %1, is not beside it</source>
        <translation>l’autre fichier qui va avec, %1, n’est pas à côté</translation>
    </message>
    <message>
        <source>this cannot be written as %1</source>
        <translation>ceci ne peut pas être écrit en %1</translation>
    </message>
    <message>
        <source>several surfaces cannot be written as %1</source>
        <translation>plusieurs surfaces ne peuvent pas être écrites en %1</translation>
    </message>
    <message>
        <source>let its name end in %1</source>
        <translation>faites finir son nom par %1</translation>
    </message>
    <message>
        <source>rename it to end in %1</source>
        <translation>renommez-le pour qu’il se termine par %1</translation>
    </message>
    <message>
        <source>a line</source>
        <translation>une ligne</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un angle</translation>
    </message>
    <message>
        <source>a curve</source>
        <translation>une courbe</translation>
    </message>
    <message>
        <source>a closed curve</source>
        <translation>une courbe fermée</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>un plan</translation>
    </message>
    <message>
        <source>a box (ROI)</source>
        <translation>une boîte (ROI)</translation>
    </message>
    <message>
        <source>a markup of another kind</source>
        <translation>un marquage d’un autre type</translation>
    </message>
    <message>
        <source>%1 is made for another organ (%2) than this one (%3): its numbers say nothing about it</source>
        <translation>%1 est prévu pour un autre organe (%2) que celui-ci (%3) : ses valeurs ne disent rien de celui-ci</translation>
    </message>
    <message>
        <source>The motion was recorded of another organ (%1) than this one (%2): its numbers say nothing about it</source>
        <translation>Le mouvement a été enregistré sur un autre organe (%1) que celui-ci (%2) : ses valeurs ne disent rien de celui-ci</translation>
    </message>
    <message>
        <source>right and left, front and back, head and feet are exchanged: mirrored</source>
        <translation>droite et gauche, avant et arrière, tête et pieds sont échangés : en miroir</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are right and left: the patient is upside down</source>
        <translation>tête et pieds sont échangés, ainsi que droite et gauche : le patient est à l’envers</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, unless head and feet are exchanged too</source>
        <translation>droite et gauche sont échangées, avant et arrière non : en miroir, à moins que tête et pieds ne soient échangés aussi</translation>
    </message>
    <message>
        <source>right and left are exchanged, front and back are not: mirrored, or situs inversus</source>
        <translation>droite et gauche sont échangées, avant et arrière non : en miroir, ou situs inversus</translation>
    </message>
    <message>
        <source>head and feet are exchanged, and so are front and back: the patient is upside down</source>
        <translation>tête et pieds sont échangés, ainsi que l’avant et l’arrière : le patient est à l’envers</translation>
    </message>
    <message>
        <source>head and feet are exchanged: the patient is upside down, or mirrored</source>
        <translation>tête et pieds sont échangés : le patient est à l’envers, ou en miroir</translation>
    </message>
    <message>
        <source>head and feet are exchanged, front and back are not: the slices seem to be in the opposite order, which mirrors the patient</source>
        <translation>tête et pieds sont échangés, avant et arrière non : les coupes semblent être dans l’ordre inverse, ce qui met le patient en miroir</translation>
    </message>
    <message>
        <source>front and back are exchanged: the files may be in RAS, mirrored, or upside down</source>
        <translation>avant et arrière sont échangés : les fichiers sont peut-être en RAS, en miroir ou à l’envers</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored, unless head and feet are exchanged too</source>
        <translation>avant et arrière sont échangés, droite et gauche non : en miroir, à moins que tête et pieds ne soient échangés aussi</translation>
    </message>
    <message>
        <source>front and back are exchanged, right and left are not: mirrored</source>
        <translation>avant et arrière sont échangés, droite et gauche non : en miroir</translation>
    </message>
    <message>
        <source>the head lies along the y axis: the files seem to come from a program in which y is up</source>
        <translation>la tête est le long de l’axe y : les fichiers semblent venir d’un programme où y est vers le haut</translation>
    </message>
    <message>
        <source>the organs do not lie as in a body whose axes are LPS: other axes, or not of one patient</source>
        <translation>les organes ne sont pas placés comme dans un corps aux axes LPS : d’autres axes, ou pas d’un seul patient</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on that side, but the others lie on the side opposite to the usual one: situs inversus, or wrong names</source>
        <translation>les organes dont le nom dit gauche ou droite sont de ce côté, mais les autres sont du côté opposé au côté habituel : situs inversus, ou noms faux</translation>
    </message>
    <message>
        <source>organs whose names say left or right lie on the opposite side, but the others lie as usual: left and right seem to be exchanged in the names</source>
        <translation>les organes dont le nom dit gauche ou droite sont du côté opposé, mais les autres sont à leur place : gauche et droite semblent échangées dans les noms</translation>
    </message>
    <message numerus="yes">
        <source>by the other organs, %n {organ lies|organs lie} on the opposite side of the patient: %2</source>
        <translation>
            <numerusform>d’après les autres organes, %n organe est du côté opposé du patient : %2</numerusform>
            <numerusform>d’après les autres organes, %n organes sont du côté opposé du patient : %2</numerusform>
        </translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: the coordinates seem to be in %2</source>
        <translation>d’après leurs volumes, tous les organes font %1 fois la taille réelle : les coordonnées semblent être en %2</translation>
    </message>
    <message>
        <source>by their volumes all organs are %1 times as large as life: a child, an atlas that is not life-sized, or another unit</source>
        <translation>d’après leurs volumes, tous les organes font %1 fois la taille réelle : un enfant, un atlas qui n’est pas grandeur nature, ou une autre unité</translation>
    </message>
    <message>
        <source>among the other organs it lies on the side that its name says</source>
        <translation>parmi les autres organes, il est du côté que dit son nom</translation>
    </message>
    <message>
        <source>turns the surface by a quarter and a half turn, from a model in RAS whose y axis points to the head</source>
        <translation>tourne la surface d’un quart et d’un demi-tour, depuis un modèle en RAS dont l’axe y pointe vers la tête</translation>
    </message>
    <message>
        <source>exchanges front and back, which mirrors the surface</source>
        <translation>échange l’avant et l’arrière, ce qui met la surface en miroir</translation>
    </message>
    <message>
        <source>exchanges head and feet, which mirrors the surface</source>
        <translation>échange la tête et les pieds, ce qui met la surface en miroir</translation>
    </message>
    <message>
        <source>exchanges head and feet, and front and back, by half a turn</source>
        <translation>échange tête et pieds, avant et arrière, par un demi-tour</translation>
    </message>
    <message>
        <source>exchanges head and feet, and right and left, by half a turn</source>
        <translation>échange tête et pieds, droite et gauche, par un demi-tour</translation>
    </message>
    <message>
        <source>exchanges all three directions, which mirrors the surface</source>
        <translation>échange les trois directions, ce qui met la surface en miroir</translation>
    </message>
    <message>
        <source>Convert from Y up and RAS to LPS</source>
        <translation>Convertir de Y vers le haut et RAS en LPS</translation>
    </message>
    <message>
        <source>Mirror front and back</source>
        <translation>Mettre en miroir avant et arrière</translation>
    </message>
    <message>
        <source>Mirror head and feet</source>
        <translation>Mettre en miroir tête et pieds</translation>
    </message>
    <message>
        <source>Turn head and feet, front and back</source>
        <translation>Retourner tête et pieds, avant et arrière</translation>
    </message>
    <message>
        <source>Turn head and feet, right and left</source>
        <translation>Retourner tête et pieds, droite et gauche</translation>
    </message>
    <message>
        <source>Mirror all three directions</source>
        <translation>Mettre en miroir les trois directions</translation>
    </message>
    <message numerus="yes">
        <source>is cut by {the %2 edge|%n edges (%2)} of the image: its volume is too small</source>
        <translation>
            <numerusform>est coupé par le bord %2 de l’image : son volume est trop petit</numerusform>
            <numerusform>est coupé par %n bords (%2) de l’image : son volume est trop petit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reaches {the %2 edge|%n edges (%2)} of the image, which may cut it off</source>
        <translation>
            <numerusform>atteint le bord %2 de l’image, qui peut le couper</numerusform>
            <numerusform>atteint %n bords (%2) de l’image, qui peut le couper</numerusform>
        </translation>
    </message>
    <message>
        <source>right</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>front</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>back</source>
        <translation>arrière</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>inférieur</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>supérieur</translation>
    </message>
    <message>
        <source>There are no organs whose coordinates could be converted</source>
        <translation>Il n’y a pas d’organes dont les coordonnées pourraient être converties</translation>
    </message>
    <message>
        <source>open some first</source>
        <translation>ouvrez-en d’abord</translation>
    </message>
    <message>
        <source>Convert between RAS and LPS</source>
        <translation>Convertir entre RAS et LPS</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Mettre en miroir gauche et droite</translation>
    </message>
    <message>
        <source>Convert the unit</source>
        <translation>Convertir l’unité</translation>
    </message>
    <message>
        <source>Convert the axes</source>
        <translation>Convertir les axes</translation>
    </message>
    <message>
        <source>converted after the import: %1</source>
        <translation>converti après l’importation : %1</translation>
    </message>
    <message>
        <source>Scale by %1</source>
        <translation>Mettre à l’échelle par %1</translation>
    </message>
    <message>
        <source>scaled after the import by %1</source>
        <translation>mis à l’échelle après l’importation par %1</translation>
    </message>
    <message>
        <source>All organs together: %1.</source>
        <translation>Tous les organes ensemble : %1.</translation>
    </message>
    <message>
        <source>RAS or mirrored</source>
        <translation>RAS ou en miroir</translation>
    </message>
    <message>
        <source>head and feet exchanged</source>
        <translation>tête et pieds échangés</translation>
    </message>
    <message>
        <source>Only partly possible: %1</source>
        <translation>Possible en partie seulement&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>All %1 slices were resampled to a distance of %2 mm; values between two slices are mixed from both</source>
        <translation>Les %1 coupes ont été rééchantillonnées à une distance de %2 mm; les valeurs entre deux coupes sont un mélange des deux</translation>
    </message>
    <message>
        <source>It does not say how thick its slice is; 1 mm is assumed, so volumes in it are not measured</source>
        <translation>Il ne dit pas quelle est l’épaisseur de sa coupe; 1 mm est supposé, les volumes n’y sont donc pas mesurés</translation>
    </message>
    <message>
        <source>It does not say how large its pixels are; %1 mm were taken from its field of view, so check a length that you know</source>
        <translation>Il ne dit pas quelle est la taille de ses pixels; %1 mm ont été tirés de son champ de vue, vérifiez donc une longueur connue</translation>
    </message>
    <message>
        <source>none of the %1 pieces is as small as that</source>
        <translation>aucun des %1 morceaux n’est aussi petit</translation>
    </message>
    <message numerus="yes">
        <source>%n of %2 pieces {goes|go}, of %3 mm and %4 ml at most</source>
        <translation>
            <numerusform>%n morceau sur %2 disparaît, de %3 mm et %4 ml au plus</numerusform>
            <numerusform>%n morceaux sur %2 disparaissent, de %3 mm et %4 ml au plus</numerusform>
        </translation>
    </message>
    <message>
        <source>drops the pieces that are smaller than a size; the largest one stays</source>
        <translation>supprime les morceaux plus petits qu’une taille; le plus grand reste</translation>
    </message>
    <message>
        <source>multiplies all coordinates by a factor</source>
        <translation>multiplie toutes les coordonnées par un facteur</translation>
    </message>
    <message>
        <source>details of %1 mm take too much memory; %2 mm is the finest for its size</source>
        <translation>des détails de %1 mm prennent trop de mémoire; %2 mm est le plus fin pour sa taille</translation>
    </message>
    <message>
        <source>choose a coarser resolution</source>
        <translation>choisissez une résolution plus grossière</translation>
    </message>
    <message>
        <source>remeshing lost a detail: the old surface lies up to %1 mm from the new one</source>
        <translation>le remaillage a perdu un détail: l’ancienne surface est jusqu’à %1 mm de la nouvelle</translation>
    </message>
    <message>
        <source>the handles cannot move by exactly %1 mm: %2</source>
        <translation>les poignées ne peuvent pas bouger d’exactement %1 mm&#xa0;: %2</translation>
    </message>
    <message>
        <source>move less far, or let more handles compensate</source>
        <translation>bougez moins loin, ou laissez compenser plus de poignées</translation>
    </message>
    <message>
        <source>This organ does not bend, so its tissue has no stress; let it bend as soft tissue</source>
        <translation>Cet organe ne se plie pas, son tissu n’a donc pas de contrainte&#xa0;; laissez-le se plier comme un tissu mou</translation>
    </message>
    <message>
        <source>Move as a rigid body</source>
        <translation>Bouger en corps rigide</translation>
    </message>
    <message>
        <source>Keep in place</source>
        <translation>Garder en place</translation>
    </message>
    <message>
        <source>Bend as soft tissue</source>
        <translation>Plier comme un tissu mou</translation>
    </message>
    <message>
        <source>Measure the distance of organs</source>
        <translation>Mesurer la distance d’organes</translation>
    </message>
    <message>
        <source>The shortest distance is between two organs</source>
        <translation>La distance la plus courte est entre deux organes</translation>
    </message>
    <message>
        <source>select two organs</source>
        <translation>sélectionnez deux organes</translation>
    </message>
    <message>
        <source>shortest distance</source>
        <translation>distance la plus courte</translation>
    </message>
    <message>
        <source>There are %1 witness points of %2: the others would lie in cavities, which hold no tissue.</source>
        <translation>Il y a %1 points témoins sur %2&#xa0;: les autres seraient dans des cavités, qui ne contiennent pas de tissu.</translation>
    </message>
    <message>
        <source>The largest angle by which a direction is turned when the tissue is stretched; not a pressure.</source>
        <translation>Le plus grand angle dont une direction tourne quand le tissu est étiré&#xa0;; pas une pression.</translation>
    </message>
    <message>
        <source>The volume of tissue now, as a part of that at rest; 1 is unchanged.</source>
        <translation>Le volume du tissu maintenant, rapporté à celui au repos&#xa0;; 1&#xa0;: inchangé.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that grows most.</source>
        <translation>La longueur du tissu maintenant, rapportée à celle au repos, dans la direction qui grandit le plus.</translation>
    </message>
    <message>
        <source>The length of tissue now, as a part of that at rest, in the direction that shrinks most.</source>
        <translation>La longueur du tissu maintenant, rapportée à celle au repos, dans la direction qui rétrécit le plus.</translation>
    </message>
    <message>
        <source>1 where the tissue is turned inside out.</source>
        <translation>1 là où le tissu est retourné.</translation>
    </message>
    <message>
        <source>global longitudinal strain</source>
        <translation>déformation longitudinale globale</translation>
    </message>
    <message>
        <source>global circumferential strain</source>
        <translation>déformation circonférentielle globale</translation>
    </message>
    <message>
        <source>global radial strain</source>
        <translation>déformation radiale globale</translation>
    </message>
    <message>
        <source>67 healthy adults, by feature tracking in magnetic resonance over the whole ventricle (CVI42); other programs differ by several points</source>
        <translation>67 adultes sains, par suivi de traits en résonance magnétique sur tout le ventricule (CVI42); d’autres programmes s’en écartent de plusieurs points</translation>
    </message>
    <message>
        <source>The surface encloses nothing</source>
        <translation>La surface n’enferme rien</translation>
    </message>
    <message>
        <source>choose the surface of its cavity</source>
        <translation>choisissez la surface de sa cavité</translation>
    </message>
    <message>
        <source>The base and the apex are the same place</source>
        <translation>La base et l’apex sont au même endroit</translation>
    </message>
    <message>
        <source>choose two other points</source>
        <translation>choisissez deux autres points</translation>
    </message>
    <message>
        <source>The insertion of the right ventricle lies on the long axis</source>
        <translation>L’insertion du ventricule droit est sur le grand axe</translation>
    </message>
    <message>
        <source>choose a point of the wall</source>
        <translation>choisissez un point de la paroi</translation>
    </message>
    <message>
        <source>The wall cannot be divided into layers</source>
        <translation>La paroi ne peut pas être divisée en couches</translation>
    </message>
    <message>
        <source>use fewer witness points</source>
        <translation>utilisez moins de points témoins</translation>
    </message>
    <message>
        <source>The tissue does not reach from the cavity to the outer surface</source>
        <translation>Le tissu ne va pas de la cavité à la surface extérieure</translation>
    </message>
    <message>
        <source>choose the surfaces of one heart</source>
        <translation>choisissez les surfaces d’un même cœur</translation>
    </message>
    <message>
        <source>name one of the surfaces of the heart</source>
        <translation>nommez une des surfaces du cœur</translation>
    </message>
    <message>
        <source>There is no phase %1</source>
        <translation>Il n’y a pas de phase %1</translation>
    </message>
    <message>
        <source>phases are counted from 1 to %1</source>
        <translation>les phases sont comptées de 1 à %1</translation>
    </message>
    <message>
        <source>layers of the wall</source>
        <translation>couches de la paroi</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>déformation</translation>
    </message>
    <message>
        <source>surfaces in motion</source>
        <translation>surfaces en mouvement</translation>
    </message>
    <message>
        <source>No surface is a left ventricle by its name</source>
        <translation>Aucune surface n’est par son nom un ventricule gauche</translation>
    </message>
    <message>
        <source>name its cavity with --lv</source>
        <translation>nommez sa cavité avec --lv</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>il y a: %1</translation>
    </message>
    <message>
        <source>It holds no organ</source>
        <translation>Elle ne contient aucun organe</translation>
    </message>
    <message>
        <source>name one with --organ</source>
        <translation>nommez-en un avec --organ</translation>
    </message>
    <message>
        <source>Without the right ventricle the numbers of segments mean nothing: give its surface, or a point where it meets the left one in front</source>
        <translation>Sans le ventricule droit, les numéros des segments ne veulent rien dire: donnez sa surface, ou un point où il rejoint le gauche en avant</translation>
    </message>
    <message>
        <source>Material points are not known in this motion: lengths of contours can be read, segments cannot</source>
        <translation>Les points matériels ne sont pas connus dans ce mouvement: les longueurs des contours se lisent, pas les segments</translation>
    </message>
    <message>
        <source>The left ventricle is fullest in phase %1, and strain is measured from phase %2</source>
        <translation>Le ventricule gauche est le plus rempli à la phase %1, et la déformation est mesurée depuis la phase %2</translation>
    </message>
    <message numerus="yes">
        <source>%n {segment has|segments have} too few points to be read</source>
        <translation>
            <numerusform>%n segment a trop peu de points pour être lus</numerusform>
            <numerusform>%n segments ont trop peu de points pour être lus</numerusform>
        </translation>
    </message>
    <message>
        <source>see docs/strain.md for the form of such a file</source>
        <translation>voyez docs/strain.md pour la forme d’un tel fichier</translation>
    </message>
    <message>
        <source>Isovolumic contraction</source>
        <translation>Contraction isovolumique</translation>
    </message>
    <message>
        <source>Isovolumic relaxation</source>
        <translation>Relaxation isovolumique</translation>
    </message>
    <message>
        <source>Ejection time</source>
        <translation>Temps d’éjection</translation>
    </message>
    <message>
        <source>Aorta, in exercise</source>
        <translation>Aorte, à l’effort</translation>
    </message>
    <message>
        <source>Left atrium, in exercise</source>
        <translation>Atrium gauche, à l’effort</translation>
    </message>
    <message>
        <source>Aortic valve, in exercise</source>
        <translation>Valve aortique, à l’effort</translation>
    </message>
    <message>
        <source>highest pressure (a wave)</source>
        <translation>pression la plus haute (onde a)</translation>
    </message>
    <message>
        <source>healthy adults at peak exercise</source>
        <translation>adultes en bonne santé à l’effort maximal</translation>
    </message>
    <message>
        <source>62 healthy people, wedge pressure; some of the oldest exceed it</source>
        <translation>62 personnes en bonne santé, pression d’occlusion ; certaines des plus âgées la dépassent</translation>
    </message>
    <message>
        <source>healthy adults: the limit at rest is kept</source>
        <translation>adultes en bonne santé : la limite au repos est gardée</translation>
    </message>
    <message>
        <source>textbooks; percentiles of 2917 people: Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</source>
        <translation>manuels ; percentiles de 2917 personnes : Sabbahi 2018, doi 10.1161/HYPERTENSIONAHA.117.10116</translation>
    </message>
    <message>
        <source>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</source>
        <translation>Wolsk 2017, doi 10.1016/j.jchf.2016.10.012</translation>
    </message>
    <message>
        <source>as at rest; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>comme au repos ; pas de sténose jusqu’à 2,5 m/s : Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>customary at the bedside, for the 1 to 1.7 m/s of a healthy valve; no stenosis up to 2.5 m/s: Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</source>
        <translation>usuel en clinique, pour les 1 à 1,7 m/s d’une valve saine ; pas de sténose jusqu’à 2,5 m/s : Baumgartner 2017, doi 10.1016/j.echo.2017.02.009</translation>
    </message>
    <message>
        <source>none or a trace, which normal valves often have: doi 10.1378/chest.103.1.226</source>
        <translation>aucune ou une trace, que les valves normales ont souvent : doi 10.1378/chest.103.1.226</translation>
    </message>
    <message>
        <source>between the contractions of both, shorter than the PR interval of 0.12 to 0.20 s</source>
        <translation>entre les contractions des deux, plus court que l’intervalle PR de 0,12 à 0,20 s</translation>
    </message>
    <message>
        <source>Tricuspid valve</source>
        <translation>Valve tricuspide</translation>
    </message>
    <message>
        <source>Pulmonary valve</source>
        <translation>Valve pulmonaire</translation>
    </message>
    <message>
        <source>Longitudinal strain</source>
        <translation>Déformation longitudinale</translation>
    </message>
    <message>
        <source>Circumferential strain</source>
        <translation>Déformation circonférentielle</translation>
    </message>
    <message>
        <source>Radial strain</source>
        <translation>Déformation radiale</translation>
    </message>
    <message>
        <source>Difference of both</source>
        <translation>Différence des deux</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Déformation (strain)</translation>
    </message>
    <message>
        <source>Strain (%)</source>
        <translation>Déformation (%)</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Valeur de pic</translation>
    </message>
    <message>
        <source>At this instant</source>
        <translation>À cet instant</translation>
    </message>
    <message>
        <source>Time to peak</source>
        <translation>Temps jusqu’au pic</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>antérieur</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inférieur</translation>
    </message>
    <message>
        <source>mid</source>
        <translation>médian</translation>
    </message>
    <message>
        <source>apex</source>
        <translation>apex</translation>
    </message>
    <message>
        <source>%1 %2 % at %3 ms (healthy adults %4 to %5)</source>
        <translation>%1 %2 % à %3 ms (adultes en bonne santé : %4 à %5)</translation>
    </message>
    <message>
        <source>&amp;Strain of the wall</source>
        <translation>Défor&amp;mation de la paroi</translation>
    </message>
    <message>
        <source>Se&amp;gments on the organ</source>
        <translation>Segments sur l’&amp;organe</translation>
    </message>
    <message>
        <source>Expo&amp;rt strain...</source>
        <translation>E&amp;xporter la déformation...</translation>
    </message>
    <message>
        <source>Strain needs the cavity of a left ventricle, by its name, that follows the handles.</source>
        <translation>La déformation exige la cavité d’un ventricule gauche, reconnue à son nom, qui suit les poignées.</translation>
    </message>
    <message>
        <source>The strain is drawn here as soon as it is measured.</source>
        <translation>La déformation est dessinée ici dès qu’elle est mesurée.</translation>
    </message>
    <message>
        <source>GLS and GCS are the change of the length of contours of the endocardium, as ultrasound and feature tracking report it. GRS and the segments are the strain of the material at witness points of the wall. Shortening is negative. All are against the end of diastole. Values of single segments are poorly repeated between programs: hatched ones are not to be relied on.</source>
        <translation>GLS et GCS sont la variation de longueur de contours de l’endocarde, telle que l’échographie et le feature tracking la donnent. GRS et les segments sont la déformation de la matière aux points témoins de la paroi. Le raccourcissement est négatif. Tout se rapporte à la fin de la diastole. Les valeurs de segments isolés se reproduisent mal d’un programme à l’autre : ne pas se fier à celles qui sont hachurées.</translation>
    </message>
    <message>
        <source>left ventricle</source>
        <translation>ventricule gauche</translation>
    </message>
    <message>
        <source>hatched: uncertain</source>
        <translation>hachuré : incertain</translation>
    </message>
    <message numerus="yes">
        <source>In %n {segment|segments} the fit of the motion leaves a peak less certain than its distance from the range of healthy adults</source>
        <translation>
            <numerusform>Dans %n segment, l’ajustement du mouvement laisse une valeur de pic plus incertaine que sa distance à la plage des adultes sains</numerusform>
            <numerusform>Dans %n segments, l’ajustement du mouvement laisse une valeur de pic plus incertaine que sa distance à la plage des adultes sains</numerusform>
        </translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>Date de l’examen</translation>
    </message>
    <message>
        <source>Sinoatrial node</source>
        <translation>Nœud sinusal</translation>
    </message>
    <message>
        <source>Anterior internodal pathway</source>
        <translation>Voie internodale antérieure</translation>
    </message>
    <message>
        <source>Middle internodal pathway</source>
        <translation>Voie internodale moyenne</translation>
    </message>
    <message>
        <source>Posterior internodal pathway</source>
        <translation>Voie internodale postérieure</translation>
    </message>
    <message>
        <source>Bachmann&apos;s bundle</source>
        <translation>Faisceau de Bachmann</translation>
    </message>
    <message>
        <source>Left atrial muscle</source>
        <translation>Muscle de l&apos;oreillette gauche</translation>
    </message>
    <message>
        <source>Atrioventricular node</source>
        <translation>Nœud atrio-ventriculaire</translation>
    </message>
    <message>
        <source>Bundle of His</source>
        <translation>Faisceau de His</translation>
    </message>
    <message>
        <source>Left bundle branch</source>
        <translation>Branche gauche du faisceau de His</translation>
    </message>
    <message>
        <source>Left anterior fascicle</source>
        <translation>Faisceau antérieur gauche</translation>
    </message>
    <message>
        <source>Left posterior fascicle</source>
        <translation>Faisceau postérieur gauche</translation>
    </message>
    <message>
        <source>Left septal fascicle</source>
        <translation>Faisceau septal gauche</translation>
    </message>
    <message>
        <source>Right bundle branch</source>
        <translation>Branche droite du faisceau de His</translation>
    </message>
    <message>
        <source>Purkinje fibres</source>
        <translation>Fibres de Purkinje</translation>
    </message>
    <message>
        <source>Cardial notch</source>
        <translation>Incisure cardiale</translation>
    </message>
    <message>
        <source>Angular incisure</source>
        <translation>Incisure angulaire</translation>
    </message>
    <message>
        <source>Greater omentum</source>
        <translation>Grand omentum</translation>
    </message>
    <message>
        <source>Diaphragmatic surface</source>
        <translation>Face diaphragmatique</translation>
    </message>
    <message>
        <source>Hilum</source>
        <translation>Hile</translation>
    </message>
    <message>
        <source>Superior border</source>
        <translation>Bord supérieur</translation>
    </message>
    <message>
        <source>Anterior end</source>
        <translation>Extrémité antérieure</translation>
    </message>
    <message>
        <source>Posterior end</source>
        <translation>Extrémité postérieure</translation>
    </message>
    <message>
        <source>name its cavity&apos;s file LV</source>
        <translation>nommez LV le fichier de sa cavité</translation>
    </message>
    <message numerus="yes">
        <source>%n {key|keys}</source>
        <translation>
            <numerusform>%n clé</numerusform>
            <numerusform>%n clés</numerusform>
        </translation>
    </message>
    <message>
        <source>the first at %1 s, the last at %2 s</source>
        <translation>la première à %1&#xa0;s, la dernière à %2&#xa0;s</translation>
    </message>
    <message>
        <source>the shape of the first of %1 files of its motion; the last one is %2</source>
        <translation>la forme du premier de %1 fichiers de son mouvement&#xa0;; le dernier est %2</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume in one place and swollen to %2 % in another. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>Le tissu est comprimé à %1&#xa0;% de son volume à un endroit et gonflé à %2&#xa0;% à un autre. Un tissu vivant, fait surtout d’eau, ne change guère de volume&#xa0;; les coordonnées ne le savent pas. Un mouvement plus petit, plus de poignées ou un volume verrouillé aident.</translation>
    </message>
    <message>
        <source>Tissue is squeezed to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>Le tissu est comprimé à %1&#xa0;% de son volume. Un tissu vivant, fait surtout d’eau, ne change guère de volume&#xa0;; les coordonnées ne le savent pas. Un mouvement plus petit, plus de poignées ou un volume verrouillé aident.</translation>
    </message>
    <message>
        <source>Tissue is swollen to %1 % of its volume. Living tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller motion, more handles or a locked volume help.</source>
        <translation>Le tissu est gonflé à %1&#xa0;% de son volume. Un tissu vivant, fait surtout d’eau, ne change guère de volume&#xa0;; les coordonnées ne le savent pas. Un mouvement plus petit, plus de poignées ou un volume verrouillé aident.</translation>
    </message>
    <message>
        <source>Chordae tendineae</source>
        <translation>Cordages tendineux</translation>
    </message>
    <message>
        <source>Left main coronary artery</source>
        <translation>Tronc commun de l’artère coronaire gauche</translation>
    </message>
    <message>
        <source>Circumflex artery</source>
        <translation>Artère circonflexe</translation>
    </message>
    <message>
        <source>Diagonal branch</source>
        <translation>Branche diagonale</translation>
    </message>
    <message>
        <source>Septal branches</source>
        <translation>Branches septales</translation>
    </message>
    <message>
        <source>Intermediate branch</source>
        <translation>Branche intermédiaire</translation>
    </message>
    <message>
        <source>Right ventricular branch</source>
        <translation>Branche ventriculaire droite</translation>
    </message>
    <message>
        <source>Conus branch</source>
        <translation>Branche du cône</translation>
    </message>
    <message>
        <source>Left marginal branch</source>
        <translation>Branche marginale gauche</translation>
    </message>
    <message>
        <source>Right marginal branch</source>
        <translation>Branche marginale droite</translation>
    </message>
    <message>
        <source>Posterolateral branch</source>
        <translation>Branche postérolatérale</translation>
    </message>
    <message>
        <source>Posterior descending artery</source>
        <translation>Artère interventriculaire postérieure</translation>
    </message>
    <message>
        <source>Sinoatrial nodal branch</source>
        <translation>Branche du nœud sinusal</translation>
    </message>
    <message>
        <source>Great cardiac vein</source>
        <translation>Grande veine du cœur</translation>
    </message>
    <message>
        <source>Middle cardiac vein</source>
        <translation>Veine moyenne du cœur</translation>
    </message>
    <message>
        <source>Posterior vein of the left ventricle</source>
        <translation>Veine postérieure du ventricule gauche</translation>
    </message>
    <message>
        <source>Coronary sinus</source>
        <translation>Sinus coronaire</translation>
    </message>
    <message>
        <source>geometric mean (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) of the systolic and diastolic bounds, 73 to 98 mmHg, rounded</source>
        <translation>moyenne géométrique (Chemla 2005, doi 10.1152/japplphysiol.00713.2005) des limites systoliques et diastoliques, de 73 à 98 mmHg, arrondie</translation>
    </message>
    <message>
        <source>short axis</source>
        <translation>petit axe</translation>
    </message>
    <message>
        <source>long axis</source>
        <translation>grand axe</translation>
    </message>
    <message>
        <source>other plane</source>
        <translation>autre plan</translation>
    </message>
    <message>
        <source>2-chamber</source>
        <translation>2 cavités</translation>
    </message>
    <message>
        <source>3-chamber</source>
        <translation>3 cavités</translation>
    </message>
    <message>
        <source>4-chamber</source>
        <translation>4 cavités</translation>
    </message>
    <message>
        <source>It has no images over a heart&apos;s cycle</source>
        <translation>Il ne contient pas d&apos;images sur un cycle cardiaque</translation>
    </message>
    <message>
        <source>name the folder of a cine study, or a file with volumes over time</source>
        <translation>indiquez le dossier d&apos;une étude ciné, ou un fichier de volumes au cours du temps</translation>
    </message>
    <message>
        <source>It has changed since it was opened</source>
        <translation>Il a changé depuis son ouverture</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>ouvrez-le à nouveau</translation>
    </message>
    <message>
        <source>It does not say how long the heart&apos;s cycle is; its phases are spread over one</source>
        <translation>Il n&apos;indique pas la durée du cycle cardiaque ; ses phases sont réparties sur un cycle</translation>
    </message>
    <message>
        <source>It has the images of %1 patients: &quot;%2&quot; and &quot;%3&quot; are of two</source>
        <translation>Il contient les images de %1 patients : « %2 » et « %3 » sont de deux d&apos;entre eux</translation>
    </message>
    <message>
        <source>Series %1 shows the same place as series %2, and stands in for it in the stack</source>
        <translation>La série %1 montre le même endroit que la série %2 et la remplace dans la pile</translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 to %4 mm between them, in which nothing was seen</source>
        <translation>Les %1 coupes d&apos;une pile (%2) laissent entre elles des intervalles de %3 à %4 mm, où rien n&apos;a été vu</translation>
    </message>
    <message>
        <source>Series %1 and %2 are %3 mm apart, other slices of the stack %4 mm: a slice between them may be missing</source>
        <translation>Les séries %1 et %2 sont à %3 mm l&apos;une de l&apos;autre, les autres coupes de la pile à %4 mm : il manque peut-être une coupe entre elles</translation>
    </message>
    <message numerus="yes">
        <source>%n {phase|phases} of series %2 {is|are} missing: %3 of %4 (the first is 0)</source>
        <translation>
            <numerusform>%n phase de la série %2 manque : %3 sur %4 (la première est 0)</numerusform>
            <numerusform>%n phases de la série %2 manquent : %3 sur %4 (la première est 0)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of series %2 {has|have} the time of another one and {is|are} left out</source>
        <translation>
            <numerusform>%n image de la série %2 a l&apos;instant d&apos;une autre et est laissée de côté</numerusform>
            <numerusform>%n images de la série %2 ont l&apos;instant d&apos;une autre et sont laissées de côté</numerusform>
        </translation>
    </message>
    <message>
        <source>Series %1 states a cycle of %2 ms, which is shorter than its phases; %3 ms were taken from their distance</source>
        <translation>La série %1 indique un cycle de %2 ms, plus court que ses phases ; %3 ms ont été tirés de leur écart</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out, phase %2 of series %3 (%4)</source>
        <translation>« %1 » est endommagé et laissé de côté, phase %2 de la série %3 (%4)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged and left out (%2)</source>
        <translation>« %1 » est endommagé et laissé de côté (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n other {file is|files are} damaged and left out</source>
        <translation>
            <numerusform>%n autre fichier est endommagé et laissé de côté</numerusform>
            <numerusform>%n autres fichiers sont endommagés et laissés de côté</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of another study left out (series %2)</source>
        <translation>
            <numerusform>%n coupe d&apos;une autre étude laissée de côté (série %2)</numerusform>
            <numerusform>%n coupes d&apos;une autre étude laissées de côté (série %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of the study in another frame of reference left out (series %2)</source>
        <translation>
            <numerusform>%n coupe de l&apos;étude dans un autre repère laissée de côté (série %2)</numerusform>
            <numerusform>%n coupes de l&apos;étude dans un autre repère laissées de côté (série %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {series|series} without the phases of a heart&apos;s cycle left out: %2</source>
        <translation>
            <numerusform>%n série sans les phases d&apos;un cycle cardiaque laissée de côté : %2</numerusform>
            <numerusform>%n séries sans les phases d&apos;un cycle cardiaque laissées de côté : %2</numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 slices of a stack (%2) have gaps of %3 mm between them, in which nothing was seen</source>
        <translation>Les %1 coupes d&apos;une pile (%2) laissent entre elles des intervalles de %3 mm, où rien n&apos;a été vu</translation>
    </message>
    <message>
        <source>The directions of its rows and columns are not perpendicular</source>
        <translation>Les directions de ses lignes et de ses colonnes ne sont pas perpendiculaires</translation>
    </message>
    <message>
        <source>export the series again</source>
        <translation>exportez de nouveau la série</translation>
    </message>
    <message>
        <source>The size of its pixels is unknown</source>
        <translation>La taille de ses pixels est inconnue</translation>
    </message>
    <message>
        <source>It has no image, or images without times</source>
        <translation>Il n&apos;a pas d&apos;image, ou des images sans temps</translation>
    </message>
    <message>
        <source>The time of image %1 is not after the one before, within one cycle</source>
        <translation>Le temps de l&apos;image %1 ne suit pas le précédent, dans un même cycle</translation>
    </message>
    <message>
        <source>Image %1 has another size than the first</source>
        <translation>L&apos;image %1 n&apos;a pas la même taille que la première</translation>
    </message>
    <message>
        <source>Image %1 has grey values that are no numbers</source>
        <translation>L&apos;image %1 a des niveaux de gris qui ne sont pas des nombres</translation>
    </message>
    <message>
        <source>One labelled phase is too few for the motion between two</source>
        <translation>Une seule phase étiquetée ne suffit pas pour le mouvement entre deux</translation>
    </message>
    <message>
        <source>label the end of diastole and the end of systole</source>
        <translation>étiquetez la fin de la diastole et la fin de la systole</translation>
    </message>
    <message>
        <source>phases are 0 to %1</source>
        <translation>les phases vont de 0 à %1</translation>
    </message>
    <message>
        <source>Phase %1 has labels twice</source>
        <translation>La phase %1 est étiquetée deux fois</translation>
    </message>
    <message>
        <source>name each phase once</source>
        <translation>nommez chaque phase une seule fois</translation>
    </message>
    <message>
        <source>following the tissue</source>
        <translation>suivi du tissu</translation>
    </message>
    <message>
        <source>fitting the images</source>
        <translation>ajustement aux images</translation>
    </message>
    <message>
        <source>Terminal crest</source>
        <translation>Crête terminale</translation>
    </message>
    <message>
        <source>From one labelled phase only a whole cycle can be followed</source>
        <translation>À partir d&apos;une seule phase étiquetée, seul un cycle entier peut être suivi</translation>
    </message>
    <message>
        <source>label the last phase as well</source>
        <translation>étiquetez aussi la dernière phase</translation>
    </message>
    <message>
        <source>No phase has labels</source>
        <translation>Aucune phase n&apos;est étiquetée</translation>
    </message>
    <message>
        <source>give those of the ends of diastole and systole, as in --phase 0=ed.nrrd --phase 9=es.nrrd</source>
        <translation>donnez celles de la fin de la diastole et de la systole, comme dans --phase 0=ed.nrrd --phase 9=es.nrrd</translation>
    </message>
    <message>
        <source>The images have no phase %1</source>
        <translation>Les images n&apos;ont pas de phase %1</translation>
    </message>
    <message>
        <source>their phases are 0 to %1</source>
        <translation>leurs phases vont de 0 à %1</translation>
    </message>
    <message>
        <source>reading the images</source>
        <translation>lecture des images</translation>
    </message>
    <message>
        <source>The images have no series %1</source>
        <translation>Les images n&apos;ont pas de série %1</translation>
    </message>
    <message>
        <source>viscera info lists the series of a study</source>
        <translation>viscera info énumère les séries d&apos;un examen</translation>
    </message>
    <message>
        <source>No image shows what is labelled: the labels seem to be in RAS where the images are in LPS</source>
        <translation>Aucune image ne montre ce qui est étiqueté : les étiquettes semblent être en RAS et les images en LPS</translation>
    </message>
    <message>
        <source>No image shows what is labelled: it lies beside all planes, or outside their pictures</source>
        <translation>Aucune image ne montre ce qui est étiqueté : cela se trouve à côté de tous les plans ou en dehors de leurs images</translation>
    </message>
    <message>
        <source>take labels and images of one patient and one study, in the same axes</source>
        <translation>prenez les étiquettes et les images d&apos;un même patient et d&apos;un même examen, dans les mêmes axes</translation>
    </message>
    <message numerus="yes">
        <source>%n {plane|planes} of the study {does|do} not cross what is labelled</source>
        <translation>
            <numerusform>%n plan de l&apos;examen ne coupe pas ce qui est étiqueté</numerusform>
            <numerusform>%n plans de l&apos;examen ne coupent pas ce qui est étiqueté</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} nearer than 4 mm to the one before {is|are} not used</source>
        <translation>
            <numerusform>%n coupe à moins de 4 mm de la précédente n&apos;est pas utilisée</numerusform>
            <numerusform>%n coupes à moins de 4 mm de la précédente ne sont pas utilisées</numerusform>
        </translation>
    </message>
    <message>
        <source>Phase %1 has no labels</source>
        <translation>La phase %1 n&apos;a pas d&apos;étiquettes</translation>
    </message>
    <message>
        <source>as in --phase 0=ed.nrrd</source>
        <translation>comme dans --phase 0=ed.nrrd</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; is missing in phase %2</source>
        <translation>La surface « %1 » manque dans la phase %2</translation>
    </message>
    <message>
        <source>The surface &quot;%1&quot; has %2 files in phase %3</source>
        <translation>La surface « %1 » a %2 fichiers dans la phase %3</translation>
    </message>
    <message>
        <source>name a surface alike in all phases, as in ed/LV.obj and es/LV.obj</source>
        <translation>nommez une surface de la même façon dans toutes les phases, comme ed/LV.obj et es/LV.obj</translation>
    </message>
    <message>
        <source>give labels of one kind for all phases</source>
        <translation>donnez des étiquettes d&apos;un même type pour toutes les phases</translation>
    </message>
    <message>
        <source>A phase has several label maps</source>
        <translation>Une phase a plusieurs cartes d&apos;étiquettes</translation>
    </message>
    <message>
        <source>give one file for each phase</source>
        <translation>donnez un fichier par phase</translation>
    </message>
    <message>
        <source>it shows no wall that could be followed</source>
        <translation>il ne montre aucune paroi qui puisse être suivie</translation>
    </message>
    <message>
        <source>its tissue leaves the plane: it arrives %1 mm from the next label</source>
        <translation>son tissu quitte le plan : il arrive à %1 mm de l&apos;étiquette suivante</translation>
    </message>
    <message>
        <source>its images are hardly alike around the wall</source>
        <translation>ses images se ressemblent à peine autour de la paroi</translation>
    </message>
    <message>
        <source>it has no image of %1 of %2 phases</source>
        <translation>il n&apos;a pas d&apos;image de %1 phases sur %2</translation>
    </message>
    <message>
        <source>only phase %1 has labels: volumes and ejection fraction are estimates, and usually too small a motion; label the end of systole too</source>
        <translation>seule la phase %1 est étiquetée : les volumes et la fraction d&apos;éjection sont des estimations, d&apos;un mouvement en général trop petit ; étiquetez aussi la fin de la systole</translation>
    </message>
    <message>
        <source>the images show phase %1 emptier than the labelled end of systole, phase %2, by %3 ml: label that phase</source>
        <translation>les images montrent la phase %1 plus vide de %3 ml que la fin de systole étiquetée, phase %2 : étiquetez cette phase</translation>
    </message>
    <message>
        <source>the images show phase %1 fuller than the labelled end of diastole, phase %2, by %3 ml: label that phase</source>
        <translation>les images montrent la phase %1 plus pleine de %3 ml que la fin de diastole étiquetée, phase %2 : étiquetez cette phase</translation>
    </message>
    <message>
        <source>planes of one direction only: what moves across them, such as the base, follows its neighbours</source>
        <translation>plans d&apos;une seule direction : ce qui les traverse, comme la base, suit ses voisins</translation>
    </message>
    <message>
        <source>no image shows a wall: its pose lies between those of the labels</source>
        <translation>aucune image ne montre de paroi : la pose se situe entre celles des étiquettes</translation>
    </message>
    <message>
        <source>the images hardly show how the wall moved</source>
        <translation>les images montrent à peine comment la paroi a bougé</translation>
    </message>
    <message>
        <source>the tissue in the images is %1 mm from the surfaces on average</source>
        <translation>le tissu dans les images est en moyenne à %1 mm des surfaces</translation>
    </message>
    <message>
        <source>the tissue would have folded: it stays nearer to the pose between the labels</source>
        <translation>le tissu se serait replié : il reste plus près de la pose entre les étiquettes</translation>
    </message>
    <message>
        <source>the tissue has %1 ml, in the labelled phases %2 to %3 ml</source>
        <translation>le tissu a %1 ml, dans les phases étiquetées %2 à %3 ml</translation>
    </message>
    <message>
        <source>%1 % of what is labelled in the plane of %2 lies outside its images</source>
        <translation>%1 % de ce qui est étiqueté dans le plan de %2 est en dehors de ses images</translation>
    </message>
    <message>
        <source>series %1, %2</source>
        <translation>série %1, %2</translation>
    </message>
    <message>
        <source>slice %1, %2</source>
        <translation>coupe %1, %2</translation>
    </message>
    <message>
        <source>Open study %1</source>
        <translation>Ouvrir l&apos;étude %1</translation>
    </message>
    <message>
        <source>Close study</source>
        <translation>Fermer l&apos;étude</translation>
    </message>
    <message>
        <source>There is no study to close</source>
        <translation>Il n&apos;y a pas d&apos;étude à fermer</translation>
    </message>
    <message>
        <source>the study %1 is not there any more (put it beside the session and open that again)</source>
        <translation>l&apos;étude %1 n&apos;est plus là (placez-la à côté de la session et rouvrez celle-ci)</translation>
    </message>
    <message>
        <source>the study cannot be opened: %1</source>
        <translation>l&apos;étude ne peut pas être ouverte : %1</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>The picture of this phase is missing</source>
        <translation>L&apos;image de cette phase manque</translation>
    </message>
    <message>
        <source>The picture of this phase cannot be read</source>
        <translation>L&apos;image de cette phase ne peut pas être lue</translation>
    </message>
    <message>
        <source>phase %1 of %2</source>
        <translation>phase %1 sur %2</translation>
    </message>
    <message>
        <source>A body surface needs a height of 30 to 250 cm and a weight of 1 to 400 kg</source>
        <translation>Une surface corporelle demande une taille de 30 à 250 cm et un poids de 1 à 400 kg</translation>
    </message>
    <message>
        <source>Per m2 of body surface</source>
        <translation>Par m2 de surface corporelle</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Apex of the left ventricle&apos;s cavity</source>
        <translation>Pointe de la cavité du ventricule gauche</translation>
    </message>
    <message>
        <source>Apex of the right ventricle&apos;s cavity</source>
        <translation>Pointe de la cavité du ventricule droit</translation>
    </message>
    <message>
        <source>Dome of the liver</source>
        <translation>Dôme du foie</translation>
    </message>
    <message>
        <source>Lower edge of the liver</source>
        <translation>Bord inférieur du foie</translation>
    </message>
    <message>
        <source>Lower edge of the spleen</source>
        <translation>Bord inférieur de la rate</translation>
    </message>
    <message>
        <source>Lowest point of the stomach</source>
        <translation>Point le plus bas de l&apos;estomac</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Création du fantôme</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Upper pole of the left kidney</source>
        <translation>Pôle supérieur du rein gauche</translation>
    </message>
    <message>
        <source>Upper pole of the right kidney</source>
        <translation>Pôle supérieur du rein droit</translation>
    </message>
    <message>
        <source>left atrium</source>
        <translation>oreillette gauche</translation>
    </message>
    <message>
        <source>right atrium</source>
        <translation>oreillette droite</translation>
    </message>
    <message>
        <source>left kidney</source>
        <translation>rein gauche</translation>
    </message>
    <message>
        <source>right kidney</source>
        <translation>rein droit</translation>
    </message>
    <message>
        <source>left lung</source>
        <translation>poumon gauche</translation>
    </message>
    <message>
        <source>right lung</source>
        <translation>poumon droit</translation>
    </message>
    <message>
        <source>right ventricle</source>
        <translation>ventricule droit</translation>
    </message>
    <message>
        <source>the deviation of the noise</source>
        <translation>l&apos;écart du bruit</translation>
    </message>
    <message>
        <source>the ejection fraction</source>
        <translation>la fraction d&apos;éjection</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>the gap between slices</source>
        <translation>l&apos;écart entre les coupes</translation>
    </message>
    <message>
        <source>the heart rate</source>
        <translation>la fréquence cardiaque</translation>
    </message>
    <message>
        <source>the number of phases</source>
        <translation>le nombre de phases</translation>
    </message>
    <message>
        <source>the number of slices</source>
        <translation>le nombre de coupes</translation>
    </message>
    <message>
        <source>the rate of breathing</source>
        <translation>la fréquence respiratoire</translation>
    </message>
    <message>
        <source>the shift of the slices</source>
        <translation>le décalage des coupes</translation>
    </message>
    <message>
        <source>the spacing</source>
        <translation>l&apos;espacement</translation>
    </message>
    <message>
        <source>the spacing of the fields</source>
        <translation>l&apos;espacement des champs</translation>
    </message>
    <message>
        <source>viscera phantom</source>
        <translation>fantôme Viscera</translation>
    </message>
    <message>
        <source>Choose the images first</source>
        <translation>Choisissez d&apos;abord les images</translation>
    </message>
    <message>
        <source>Choose the labels of a phase: those of the ends of diastole and systole, where there are any</source>
        <translation>Choisissez les étiquettes d&apos;une phase : celles des fins de diastole et de systole, s&apos;il y en a</translation>
    </message>
    <message>
        <source>Enter the phase of %1</source>
        <translation>Indiquez la phase de %1</translation>
    </message>
    <message>
        <source>The images have %1 phases: enter another one for %2</source>
        <translation>Les images ont %1 phases : indiquez-en une autre pour %2</translation>
    </message>
    <message>
        <source>%1 and %2 are both labels of phase %3</source>
        <translation>%1 et %2 sont toutes deux des étiquettes de la phase %3</translation>
    </message>
    <message>
        <source>Only phase %1 has labels: the motion, its volumes and ejection fractions will be estimates. Label the end of systole too, if you can</source>
        <translation>Seule la phase %1 a des étiquettes : le mouvement, ses volumes et ses fractions d&apos;éjection seront des estimations. Étiquetez aussi la fin de systole, si vous le pouvez</translation>
    </message>
    <message>
        <source>The images differ most from the first phase in phase %1, which has no labels: see whether the end of systole is labelled</source>
        <translation>C&apos;est dans la phase %1, sans étiquettes, que les images diffèrent le plus de la première : vérifiez que la fin de systole est étiquetée</translation>
    </message>
    <message>
        <source>weight %1 %</source>
        <translation>poids %1 %</translation>
    </message>
    <message>
        <source>left its plane by %1 mm, %2</source>
        <translation>a quitté son plan de %1 mm, %2</translation>
    </message>
    <message>
        <source>hardly alike, %1</source>
        <translation>guère semblables, %1</translation>
    </message>
    <message>
        <source>shows no wall</source>
        <translation>ne montre pas de paroi</translation>
    </message>
    <message>
        <source>no image</source>
        <translation>pas d&apos;image</translation>
    </message>
    <message>
        <source>labelled</source>
        <translation>étiquetée</translation>
    </message>
    <message>
        <source>their phases are %1 to %2</source>
        <translation>leurs phases vont de %1 à %2</translation>
    </message>
    <message>
        <source>its volumes over the beat and its ejection fraction are estimates: only phase %1 has labels</source>
        <translation>ses volumes sur le battement et sa fraction d&apos;éjection sont des estimations : seule la phase %1 a des étiquettes</translation>
    </message>
    <message>
        <source>Correct contours</source>
        <translation>Corriger les contours</translation>
    </message>
    <message>
        <source>%1, correction of phase %2</source>
        <translation>%1, correction de la phase %2</translation>
    </message>
    <message>
        <source>correction of phase %1</source>
        <translation>correction de la phase %1</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only, since the tissue would fold</source>
        <translation>phase %1 : le contour corrigé de %2 n&apos;est atteint qu&apos;à %3 mm près, car le tissu se plierait</translation>
    </message>
    <message>
        <source>phase %1: the corrected contour of %2 is met to %3 mm only: the handles are too far apart for its shape</source>
        <translation>phase %1 : le contour corrigé de %2 n&apos;est atteint qu&apos;à %3 mm près : les poignées sont trop éloignées pour sa forme</translation>
    </message>
    <message>
        <source>The images have no slice %1</source>
        <translation>Les images n&apos;ont pas de coupe %1</translation>
    </message>
    <message>
        <source>their slices are 0 to %1</source>
        <translation>leurs coupes vont de 0 à %1</translation>
    </message>
    <message>
        <source>The corrected contour lies %1 mm beside the plane of %2</source>
        <translation>Le contour corrigé est à %1 mm du plan de %2</translation>
    </message>
    <message>
        <source>give points in the plane of one slice, mm in LPS</source>
        <translation>donnez des points dans le plan d&apos;une coupe, en mm, LPS</translation>
    </message>
    <message>
        <source>Phase %1 has labels, which are exact: only phases between them are corrected</source>
        <translation>La phase %1 a des labels, qui sont exacts : seules les phases intermédiaires se corrigent</translation>
    </message>
    <message>
        <source>change its labels, or leave this correction out</source>
        <translation>modifiez ses labels, ou omettez cette correction</translation>
    </message>
    <message>
        <source>A corrected contour has no points</source>
        <translation>Un contour corrigé n&apos;a pas de points</translation>
    </message>
    <message>
        <source>give three numbers for each of them, mm</source>
        <translation>donnez trois nombres pour chacun, en mm</translation>
    </message>
    <message>
        <source>The handles are no longer those of the motion that was found in the images</source>
        <translation>Les poignées ne sont plus celles du mouvement trouvé dans les images</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the handles</source>
        <translation>cherchez de nouveau le mouvement, ou annulez la modification des poignées</translation>
    </message>
    <message>
        <source>There is no key at phase %1 any more</source>
        <translation>Il n&apos;y a plus de pose clé à la phase %1</translation>
    </message>
    <message>
        <source>find the motion again, or undo the change of the keys</source>
        <translation>cherchez de nouveau le mouvement, ou annulez la modification des poses clés</translation>
    </message>
    <message>
        <source>It has no points, or is of no surface that is fitted</source>
        <translation>Elle n&apos;a pas de points, ou n&apos;est d&apos;aucune surface ajustée</translation>
    </message>
    <message>
        <source>give the points of a contour</source>
        <translation>donnez les points d&apos;un contour</translation>
    </message>
    <message>
        <source>Phase %1 does not lie between labelled phases</source>
        <translation>La phase %1 n&apos;est pas entre des phases à labels</translation>
    </message>
    <message>
        <source>correct a phase that the images are fitted in</source>
        <translation>corrigez une phase ajustée aux images</translation>
    </message>
    <message>
        <source>meeting corrected contours</source>
        <translation>ajustement aux contours corrigés</translation>
    </message>
    <message>
        <source>The %1 is damaged and left out: %2</source>
        <translation>Endommagée et laissée de côté : %1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n more {phase is|phases are} damaged and left out</source>
        <translation>
            <numerusform>%n autre phase est endommagée et laissée de côté</numerusform>
            <numerusform>%n autres phases sont endommagées et laissées de côté</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 x %2 x %3 voxels, others %4 x %5 x %6</source>
        <translation>elle a %1 x %2 x %3 voxels, les autres %4 x %5 x %6</translation>
    </message>
    <message>
        <source>phase %1 %</source>
        <translation>phase %1 %</translation>
    </message>
    <message>
        <source>The %1 shows the same instant as the %2, and is left out</source>
        <translation>%1 montre le même instant que %2 et est laissée de côté</translation>
    </message>
    <message>
        <source>Its phases are kept as 16 bits a voxel, to a 65,000th of their range</source>
        <translation>Ses phases sont gardées en 16 bits par voxel, au 65 000e de leur étendue</translation>
    </message>
    <message>
        <source>Its phases need %1 GB, of which %2 GB are kept at a time; the others are read again when they are shown</source>
        <translation>Ses phases demandent %1 Go, dont %2 Go sont gardés à la fois ; les autres sont relues quand elles sont montrées</translation>
    </message>
    <message>
        <source>It is packed, or keeps its phases beside each other, so that each of them is read as slowly as all; save it unpacked to move through it</source>
        <translation>Il est compressé ou garde ses phases côte à côte, si bien que chacune se lit aussi lentement que toutes ; enregistrez-le non compressé pour le parcourir</translation>
    </message>
    <message>
        <source>It does not say the unit of its times; they are taken as seconds</source>
        <translation>L&apos;unité de ses temps n&apos;est pas indiquée ; ils sont pris pour des secondes</translation>
    </message>
    <message>
        <source>the session holds one phase of this scan; open its file again for the others</source>
        <translation>la session contient une phase de cet examen ; rouvrez son fichier pour les autres</translation>
    </message>
    <message>
        <source>Series %1 states %2 phases and has %3</source>
        <translation>La série %1 annonce %2 phases et en a %3</translation>
    </message>
    <message>
        <source>Series %1: %2</source>
        <translation>Série %1 : %2</translation>
    </message>
    <message>
        <source>Series %1 is left out: &quot;%2&quot; %3</source>
        <translation>La série %1 est laissée de côté : « %2 » %3</translation>
    </message>
    <message numerus="yes">
        <source>%n {picture|pictures} of %2 {is|are} empty and left out: %3</source>
        <translation>
            <numerusform>%n image de %2 est vide et laissée de côté : %3</numerusform>
            <numerusform>%n images de %2 sont vides et laissées de côté : %3</numerusform>
        </translation>
    </message>
    <message>
        <source>free handles cannot follow: these coordinates are not linear in the handles</source>
        <translation>les poignées libres ne peuvent pas suivre : ces coordonnées ne sont pas linéaires en les poignées</translation>
    </message>
    <message>
        <source>choose another coordinate system</source>
        <translation>choisissez un autre système de coordonnées</translation>
    </message>
    <message>
        <source>free handles cannot follow: there is no witness point in the tissue</source>
        <translation>les poignées libres ne peuvent pas suivre : il n&apos;y a aucun point témoin dans le tissu</translation>
    </message>
    <message>
        <source>place the handles around an organ that encloses a volume</source>
        <translation>placez les poignées autour d&apos;un organe qui enferme un volume</translation>
    </message>
    <message>
        <source>unlock it, or move the handles less far</source>
        <translation>déverrouillez-le, ou déplacez moins les poignées</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Contrainte de von Mises</translation>
    </message>
    <message>
        <source>Maximum von Mises stress</source>
        <translation>Contrainte de von Mises maximale</translation>
    </message>
    <message>
        <source>The stress that shears the tissue, if it is the stated material; the change of its volume has no part in it.</source>
        <translation>La contrainte qui cisaille le tissu, s&apos;il est du matériau indiqué ; la variation de son volume n&apos;y a pas de part.</translation>
    </message>
    <message>
        <source>Strain energy density</source>
        <translation>Densité d&apos;énergie de déformation</translation>
    </message>
    <message>
        <source>Maximum strain energy density</source>
        <translation>Densité d&apos;énergie de déformation maximale</translation>
    </message>
    <message>
        <source>The energy for each volume at rest, if the tissue is the stated material; with what the change of its volume takes.</source>
        <translation>L&apos;énergie par volume au repos, si le tissu est du matériau indiqué ; avec ce que coûte la variation de son volume.</translation>
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
        <translation>myocarde</translation>
    </message>
    <message>
        <source>kidney</source>
        <translation>rein</translation>
    </message>
    <message>
        <source>spleen</source>
        <translation>rate</translation>
    </message>
    <message>
        <source>pancreas</source>
        <translation>pancréas</translation>
    </message>
    <message>
        <source>Pascals are of a stated material: %1.</source>
        <translation>Les pascals sont ceux d&apos;un matériau indiqué : %1.</translation>
    </message>
    <message>
        <source>Interventricular septum</source>
        <translation>Septum interventriculaire</translation>
    </message>
    <message>
        <source>Interatrial septum</source>
        <translation>Septum interatrial</translation>
    </message>
    <message>
        <source>Oval fossa</source>
        <translation>Fosse ovale</translation>
    </message>
    <message>
        <source>Opening of the coronary sinus</source>
        <translation>Ostium du sinus coronaire</translation>
    </message>
    <message>
        <source>Valve of the coronary sinus</source>
        <translation>Valvule du sinus coronaire</translation>
    </message>
    <message>
        <source>the limit of Doppler ultrasound, which no study of its own gives; measured by catheter since Gleason and Braunwald 1962, doi 10.1172/JCI104469</source>
        <translation>limite de l’échographie Doppler, qu’aucune étude propre ne donne ; mesurée par cathéter depuis Gleason et Braunwald 1962, doi 10.1172/JCI104469</translation>
    </message>
    <message>
        <source>customary; how much people at rest differ: Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</source>
        <translation>usuel ; combien les personnes au repos diffèrent : Benchetrit 2000, doi 10.1016/S0034-5687(00)00154-7</translation>
    </message>
    <message numerus="yes">
        <source>%n {point or open contour was|points and open contours were} left out</source>
        <translation>
            <numerusform>%n point ou contour ouvert a été laissé de côté</numerusform>
            <numerusform>%n points et contours ouverts ont été laissés de côté</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was|contours were} left out, whose numbers cannot be read</source>
        <translation>
            <numerusform>%n contour dont les nombres sont illisibles a été laissé de côté</numerusform>
            <numerusform>%n contours dont les nombres sont illisibles ont été laissés de côté</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {contour was left out, which lies|contours were left out, which lie} in another direction than most</source>
        <translation>
            <numerusform>%n contour, d&apos;une autre direction que la plupart, a été laissé de côté</numerusform>
            <numerusform>%n contours, d&apos;une autre direction que la plupart, ont été laissés de côté</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n {region was left out, which is|regions were left out, which are} in another coordinate system (frame of reference)</source>
        <translation>
            <numerusform>%n région d&apos;un autre système de coordonnées (frame of reference) a été laissée de côté</numerusform>
            <numerusform>%n régions d&apos;un autre système de coordonnées (frame of reference) ont été laissées de côté</numerusform>
        </translation>
    </message>
    <message>
        <source>all contours lie in one plane, whose thickness is not stated; %1 mm were taken</source>
        <translation>tous les contours sont dans un plan dont l&apos;épaisseur n&apos;est pas indiquée ; %1 mm ont été pris</translation>
    </message>
    <message numerus="yes">
        <source>%n {slice|slices} of %2 without a contour got the shape between their neighbours</source>
        <translation>
            <numerusform>%n coupe de %2 sans contour a reçu la forme entre ses voisines</numerusform>
            <numerusform>%n coupes de %2 sans contour ont reçu la forme entre leurs voisines</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no contour over %2 mm; that gap stays open</source>
        <translation>%1 n&apos;a pas de contour sur %2 mm ; cette lacune reste ouverte</translation>
    </message>
    <message>
        <source>It is a structure set without regions of interest</source>
        <translation>C&apos;est un structure set sans régions</translation>
    </message>
    <message>
        <source>export the contours again</source>
        <translation>exportez de nouveau les contours</translation>
    </message>
    <message>
        <source>It is a structure set without closed contours, so that there is no organ in it</source>
        <translation>C&apos;est un structure set sans contours fermés, donc sans organe</translation>
    </message>
    <message>
        <source>export the structures as closed planar contours</source>
        <translation>exportez les structures en contours plans fermés</translation>
    </message>
    <message>
        <source>No voxel of the grid lies within the organ</source>
        <translation>Aucun voxel de la grille n&apos;est dans l&apos;organe</translation>
    </message>
    <message>
        <source>choose the scan that shows it, or smaller voxels</source>
        <translation>choisissez le scan qui le montre, ou des voxels plus petits</translation>
    </message>
    <message>
        <source>choose the scan that shows it</source>
        <translation>choisissez le scan qui le montre</translation>
    </message>
    <message>
        <source>There are fewer than two images to lay a segmentation on</source>
        <translation>Il y a moins de deux images sur lesquelles poser une segmentation</translation>
    </message>
    <message>
        <source>choose a series of slices</source>
        <translation>choisissez une série de coupes</translation>
    </message>
    <message>
        <source>The images lie at unequal distances, so that they have no grid</source>
        <translation>Les images sont à des distances inégales et n&apos;ont donc pas de grille</translation>
    </message>
    <message>
        <source>write the segmentation on a grid of its own</source>
        <translation>écrivez la segmentation sur une grille à elle</translation>
    </message>
    <message>
        <source>The size of voxels has to be positive</source>
        <translation>La taille des voxels doit être positive</translation>
    </message>
    <message>
        <source>The organs are too large for voxels of that size</source>
        <translation>Les organes sont trop grands pour des voxels de cette taille</translation>
    </message>
    <message>
        <source>choose larger voxels</source>
        <translation>choisissez des voxels plus grands</translation>
    </message>
    <message>
        <source>No image of the scan crosses the organ</source>
        <translation>Aucune image du scan ne coupe l&apos;organe</translation>
    </message>
    <message>
        <source>Contours need the images whose planes they lie in</source>
        <translation>Les contours ont besoin des images dans les plans desquelles ils sont</translation>
    </message>
    <message>
        <source>open the DICOM scan of the organs, or write a segmentation</source>
        <translation>ouvrez le scan DICOM des organes, ou écrivez une segmentation</translation>
    </message>
    <message>
        <source>It is no PDF document</source>
        <translation>Ce n&apos;est pas un document PDF</translation>
    </message>
    <message>
        <source>There is no DICOM image whose patient and study could be taken</source>
        <translation>Il n&apos;y a pas d&apos;image DICOM dont prendre le patient et l&apos;étude</translation>
    </message>
    <message>
        <source>name the folder of the images that the organs were made from</source>
        <translation>indiquez le dossier des images dont les organes ont été faits</translation>
    </message>
    <message>
        <source>It has no measurement</source>
        <translation>Il n&apos;a pas de mesure</translation>
    </message>
    <message>
        <source>Its segment is named without the segmentation</source>
        <translation>Son segment est nommé sans la segmentation</translation>
    </message>
    <message>
        <source>write the segmentation too</source>
        <translation>écrivez aussi la segmentation</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>exportez-le ou copiez-le de nouveau</translation>
    </message>
    <message>
        <source>key sequence</source>
        <translation>séquence de clés</translation>
    </message>
    <message>
        <source>as in %1</source>
        <translation>comme dans %1</translation>
    </message>
    <message>
        <source>Correct contour</source>
        <translation>Corriger le contour</translation>
    </message>
    <message>
        <source>It is a segmentation over time: its frames show several phases at one place</source>
        <translation>C&apos;est une segmentation dans le temps : ses images montrent plusieurs phases à un même endroit</translation>
    </message>
    <message>
        <source>The archive %1 cannot be reached</source>
        <translation>L&apos;archive %1 est injoignable</translation>
    </message>
    <message>
        <source>Check its address and port, and whether it runs</source>
        <translation>Vérifiez son adresse et son port, et s&apos;il fonctionne</translation>
    </message>
    <message>
        <source>The archive %1 does not answer</source>
        <translation>L&apos;archive %1 ne répond pas</translation>
    </message>
    <message>
        <source>Try again; the archive or the network may be slow</source>
        <translation>Réessayez ; l&apos;archive ou le réseau est peut-être lent</translation>
    </message>
    <message>
        <source>The archive %1 refuses the titles: it is called %2, and this program %3</source>
        <translation>L&apos;archive %1 refuse les titres : elle est appelée %2, et ce programme %3</translation>
    </message>
    <message>
        <source>Ask its administrator for its title, and to allow that of this program</source>
        <translation>Demandez son titre à son administrateur, et d&apos;autoriser celui de ce programme</translation>
    </message>
    <message>
        <source>The archive %1 refuses the user name or the password</source>
        <translation>L&apos;archive %1 refuse le nom d&apos;utilisateur ou le mot de passe</translation>
    </message>
    <message>
        <source>Type both again</source>
        <translation>Saisissez-les à nouveau</translation>
    </message>
    <message>
        <source>The certificate of the archive %1 is not trusted</source>
        <translation>Le certificat de l&apos;archive %1 n&apos;est pas de confiance</translation>
    </message>
    <message>
        <source>Name the file with its issuer&apos;s certificate in the connection</source>
        <translation>Indiquez dans la connexion le fichier du certificat de son émetteur</translation>
    </message>
    <message>
        <source>The connection to the archive %1 was cut</source>
        <translation>La connexion à l&apos;archive %1 a été coupée</translation>
    </message>
    <message>
        <source>Try again; nothing incomplete is kept</source>
        <translation>Réessayez ; rien d&apos;incomplet n&apos;est gardé</translation>
    </message>
    <message>
        <source>The answer of the archive %1 is not DICOM</source>
        <translation>La réponse de l&apos;archive %1 n&apos;est pas du DICOM</translation>
    </message>
    <message>
        <source>Check its address</source>
        <translation>Vérifiez son adresse</translation>
    </message>
    <message>
        <source>The archive %1 refuses: %2</source>
        <translation>L&apos;archive %1 refuse : %2</translation>
    </message>
    <message>
        <source>Ask its administrator</source>
        <translation>Demandez à son administrateur</translation>
    </message>
    <message>
        <source>The archive %1 does not offer %2</source>
        <translation>L&apos;archive %1 n&apos;offre pas %2</translation>
    </message>
    <message>
        <source>The archive %1 has not kept %2 of %3 files</source>
        <translation>L&apos;archive %1 n&apos;a pas gardé %2 fichiers sur %3</translation>
    </message>
    <message>
        <source>The archive %1 has no such series</source>
        <translation>L&apos;archive %1 n&apos;a pas cette série</translation>
    </message>
    <message>
        <source>What was received cannot be written</source>
        <translation>Ce qui a été reçu ne peut pas être écrit</translation>
    </message>
    <message>
        <source>Is the disk full?</source>
        <translation>Le disque est-il plein ?</translation>
    </message>
    <message>
        <source>Ask the archive %1</source>
        <translation>Interroger l&apos;archive %1</translation>
    </message>
    <message>
        <source>Receive image %1</source>
        <translation>Recevoir l&apos;image %1</translation>
    </message>
    <message>
        <source>Send image %1</source>
        <translation>Envoyer l&apos;image %1</translation>
    </message>
    <message>
        <source>The folder is there already</source>
        <translation>Le dossier existe déjà</translation>
    </message>
    <message>
        <source>The folder cannot be made</source>
        <translation>Le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>The file is no DICOM file</source>
        <translation>Le fichier n&apos;est pas un fichier DICOM</translation>
    </message>
    <message>
        <source>The certificates cannot be read</source>
        <translation>Les certificats ne peuvent pas être lus</translation>
    </message>
    <message>
        <source>It is no list of archives</source>
        <translation>Ce n&apos;est pas une liste d&apos;archives</translation>
    </message>
    <message>
        <source>this service</source>
        <translation>ce service</translation>
    </message>
    <message>
        <source>The address of the archive %1 is not known to the network</source>
        <translation>L&apos;adresse de l&apos;archive %1 est inconnue du réseau</translation>
    </message>
    <message>
        <source>Check how its address is spelt</source>
        <translation>Vérifiez l&apos;orthographe de l&apos;adresse</translation>
    </message>
    <message>
        <source>There is no secure connection (TLS) to the archive %1</source>
        <translation>Pas de connexion sécurisée (TLS) avec l&apos;archive %1</translation>
    </message>
    <message>
        <source>Ask its administrator whether this port takes TLS, and of which version</source>
        <translation>Demandez à son administrateur si ce port accepte TLS, et dans quelle version</translation>
    </message>
    <message>
        <source>the images are not there any more (the archive %1 has them)</source>
        <translation>les images ne sont plus là (l&apos;archive %1 les a)</translation>
    </message>
    <message>
        <source>There is no key ring that keeps the password</source>
        <translation>Il n&apos;y a pas de trousseau qui conserve le mot de passe</translation>
    </message>
    <message>
        <source>it counts little in %1 of %2 phases, in which its tissue leaves the plane or its images are unlike</source>
        <translation>il compte peu dans %1 phases sur %2, où son tissu quitte le plan ou ses images ne se ressemblent pas</translation>
    </message>
    <message>
        <source>%1 is left out: its surface is open</source>
        <translation>%1 est laissé de côté : sa surface est ouverte</translation>
    </message>
    <message>
        <source>the scan&apos;s DICOM files are not there: the objects get a study of their own</source>
        <translation>les fichiers DICOM de l&apos;examen ne sont pas là : les objets reçoivent une étude à eux</translation>
    </message>
    <message>
        <source>The report names the patient or the files, and identity is to be removed</source>
        <translation>Le rapport nomme le patient ou les fichiers, et l&apos;identité doit être retirée</translation>
    </message>
    <message>
        <source>leave the report out, or make one without the patient</source>
        <translation>laisser le rapport de côté, ou en faire un sans le patient</translation>
    </message>
    <message>
        <source>The report holds the patient&apos;s name or number</source>
        <translation>Le rapport contient le nom ou le numéro du patient</translation>
    </message>
    <message>
        <source>leave the report out</source>
        <translation>laissez le rapport de côté</translation>
    </message>
    <message>
        <source>No DICOM object is chosen</source>
        <translation>Aucun objet DICOM n&apos;est choisi</translation>
    </message>
    <message>
        <source>choose one at least</source>
        <translation>choisissez-en au moins un</translation>
    </message>
    <message>
        <source>There is no organ to write</source>
        <translation>Il n&apos;y a pas d&apos;organe à écrire</translation>
    </message>
    <message>
        <source>There is no organ with a closed surface to write as DICOM</source>
        <translation>Il n&apos;y a pas d&apos;organe à surface fermée à écrire en DICOM</translation>
    </message>
    <message>
        <source>close it first</source>
        <translation>fermez-la d&apos;abord</translation>
    </message>
    <message>
        <source>The number of phases is 0 to 200</source>
        <translation>Le nombre de phases est de 0 à 200</translation>
    </message>
    <message>
        <source>the file is there already</source>
        <translation>le fichier existe déjà</translation>
    </message>
    <message>
        <source>choose an empty folder</source>
        <translation>choisissez un dossier vide</translation>
    </message>
    <message>
        <source>there is no such series</source>
        <translation>cette série n&apos;existe pas</translation>
    </message>
    <message>
        <source>one mesh says nothing about the others</source>
        <translation>un maillage ne dit rien des autres</translation>
    </message>
    <message>
        <source>give two sizes at least</source>
        <translation>donnez au moins deux tailles</translation>
    </message>
    <message>
        <source>follow the motion over all of them with viscera track %1, or export a segmentation of each phase</source>
        <translation>suivez le mouvement sur toutes avec viscera track %1, ou exportez une segmentation de chaque phase</translation>
    </message>
</context>
<context>
    <name>viscera::app</name>
    <message>
        <source>Choose...</source>
        <translation>Choisir...</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Fetching from %1</source>
        <translation>Récupération depuis %1</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>%1 (estimate)</source>
        <translation>%1 (estimation)</translation>
    </message>
    <message>
        <source>Planes of the images</source>
        <translation>Plans des images</translation>
    </message>
    <message>
        <source>Cine study</source>
        <translation>Étude ciné</translation>
    </message>
    <message>
        <source>Use the sequence&apos;s handles</source>
        <translation>Utiliser les poignées de la séquence</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Circulation</source>
        <translation>Circulation</translation>
    </message>
    <message>
        <source>Sample %1</source>
        <translation>Organe type&#xa0;: %1</translation>
    </message>
    <message>
        <source>Organs (%1)</source>
        <translation>Organes (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Prescribe a volume</source>
        <translation>Imposer un volume</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Cut away the front</source>
        <translation>Retirer la partie avant</translation>
    </message>
    <message>
        <source>Cut away the upper part</source>
        <translation>Retirer la partie supérieure</translation>
    </message>
    <message>
        <source>Facing the viewer</source>
        <translation>Face à l’observateur</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Déformer</translation>
    </message>
    <message numerus="yes">
        <source>%n handles</source>
        <translation>
            <numerusform>%n poignée</numerusform>
            <numerusform>%n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Rest error</source>
        <translation>Erreur au repos</translation>
    </message>
    <message>
        <source>The largest distance of the bound organ at rest from the original</source>
        <translation>La plus grande distance entre l’organe lié au repos et l’original</translation>
    </message>
    <message>
        <source>Smallest weight</source>
        <translation>Plus petit poids</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
    <message>
        <source>There is no organ to export. Open one first.</source>
        <translation>Il n’y a pas d’organe à exporter. Ouvrez-en un d’abord.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportation&#xa0;: %1</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Look for files...</source>
        <translation>Chercher les fichiers...</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Place the sequence&apos;s handles around the organ and play it</source>
        <translation>Placer les poignées de la séquence autour de l’organe et la lire</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>Colour...</source>
        <translation>Couleur...</translation>
    </message>
    <message numerus="yes">
        <source>Move %n handles</source>
        <translation>
            <numerusform>Déplacer %n poignée</numerusform>
            <numerusform>Déplacer %n poignées</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle %1</source>
        <translation>Déplacer la poignée %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Contrainte</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Duration of one cycle</source>
        <translation>Durée d’un cycle</translation>
    </message>
    <message>
        <source>Export lesson</source>
        <translation>Exporter la leçon</translation>
    </message>
    <message>
        <source>Motion from a series</source>
        <translation>Mouvement d’une série</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>now</source>
        <translation>actuel</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
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
        <translation>Fermer (Échap)</translation>
    </message>
    <message>
        <source>Time in the cycle</source>
        <translation>Temps dans le cycle</translation>
    </message>
</context>
</TS>
