// What the parameters of classification and points do.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"variational: smooths along surfaces; thesis-closed: equation 3.7, whose matrix is diagonal; thesis-skew: the "
   "same with a curl that does not vanish",
   "variationell: glättet entlang von Oberflächen; These, geschlossen: Gleichung 3.7, deren Matrix diagonal ist; "
   "These, schief: dieselbe mit einer Rotation, die nicht verschwindet",
   "variationnelle : lisse le long des surfaces ; thèse, fermée : équation 3.7, à matrice diagonale ; thèse, oblique"
   " : la même avec un rotationnel qui ne s’annule pas"},
  {"how strongly values away from the iso-value are set to zero",
   "wie stark Werte abseits des Isowerts auf null gesetzt werden",
   "avec quelle force les valeurs éloignées de l’isovaleur sont mises à zéro"},
  {"smoothing along the surface; 1 smooths over the tangential length",
   "Glättung entlang der Oberfläche; 1 glättet über die Tangentiallänge",
   "lissage le long de la surface ; 1 lisse sur la longueur tangente"},
  {"how strongly edges are pulled up to the target value",
   "wie stark Kanten zum Zielwert hinaufgezogen werden",
   "avec quelle force les bords sont tirés vers la valeur cible"},
  {"grey value at the border of the skin; 0 finds one from the volume",
   "Grauwert an der Grenze der Haut; 0 bestimmt ihn aus dem Volumen",
   "niveau de gris à la limite de la peau ; 0 le détermine d’après le volume"},
  {"where isoValue is 0: how far it lies on the way from the grey of the fluid to that of the steepest edges around",
   "wo der Isowert 0 ist: wie weit er auf dem Weg vom Grau der Flüssigkeit zu dem der steilsten Kanten ringsum liegt",
   "si l’isovaleur est 0 : sa position entre le gris du liquide et celui des bords les plus raides alentour"},
  {"share of the raw volume, against the low-passed one, in the iso-value term",
   "Anteil des rohen Volumens, gegenüber dem tiefpassgefilterten, am Isowert-Term",
   "part du volume brut, face au volume passe-bas, dans le terme d’isovaleur"},
  {"volume whose gradients tell edges: low-passed is quiet, raw is sharp where there is little noise",
   "Volumen, dessen Gradienten Kanten anzeigen: tiefpassgefiltert ist ruhig, roh ist scharf bei wenig Rauschen",
   "volume dont les gradients indiquent les bords : passe-bas est calme, brut est net quand il y a peu de bruit"},
  {"pull toward the target where there is no gradient",
   "Zug zum Zielwert, wo kein Gradient ist",
   "attraction vers la cible là où il n’y a pas de gradient"},
  {"gradient per voxel that counts as a full edge",
   "Gradient je Voxel, der als volle Kante zählt",
   "gradient par voxel qui compte comme un bord plein"},
  {"value that surfaces get", "Wert, den Oberflächen erhalten", "valeur que reçoivent les surfaces"},
  {"width (standard deviation) of the low-pass filter",
   "Breite (Standardabweichung) des Tiefpassfilters",
   "largeur (écart-type) du filtre passe-bas"},
  {"distance over which beta = 1 smooths along the surface",
   "Strecke, über die Beta = 1 entlang der Oberfläche glättet",
   "distance sur laquelle bêta = 1 lisse le long de la surface"},
  {"difference from the iso-value that counts as noise",
   "Abweichung vom Isowert, die als Rauschen zählt",
   "écart à l’isovaleur qui compte comme du bruit"},
  {"distance from the iso-surface beyond which all voxels count as equally far",
   "Abstand von der Isofläche, jenseits dessen alle Voxel als gleich weit zählen",
   "distance à l’isosurface au-delà de laquelle tous les voxels comptent comme également loin"},
  {"gradient per voxel below which a direction is not trusted",
   "Gradient je Voxel, unter dem einer Richtung nicht getraut wird",
   "gradient par voxel sous lequel une direction n’est pas fiable"},
  {"differences that take the curl in the thesis' term: forward ones leave a rest, central ones none",
   "Differenzen für die Rotation im Term der Dissertation: vorwärts lassen einen Rest, zentral keinen",
   "différences qui donnent le rotationnel dans le terme de la thèse : en avant, elles laissent un reste, centrées, aucun"},
  {"brings the result of the thesis' formulations to 0 .. 1 by its least and greatest value",
   "bringt das Ergebnis der Formulierungen der Dissertation über kleinsten und größten Wert auf 0 .. 1",
   "ramène le résultat des formulations de la thèse à 0 .. 1 par ses valeurs extrêmes"},
  {"relative residual at which the solver stops, for a mesh; sliders are answered to 0.002",
   "relatives Residuum, bei dem der Löser für ein Netz aufhört; auf Regler wird bis 0.002 geantwortet",
   "résidu relatif auquel le solveur s’arrête, pour un maillage ; les curseurs répondent à 0.002 près"},
  {"none, or diffusion: smooths speckle and stops at edges",
   "keine, oder Diffusion: glättet Speckle und hält an Kanten an",
   "aucun, ou diffusion : lisse le speckle et s’arrête aux bords"},
  {"steps of the diffusion; more smooth farther",
   "Schritte der Diffusion; mehr glätten weiter",
   "pas de la diffusion ; plus il y en a, plus elle lisse loin"},
  {"gradient at which smoothing falls to half, as a multiple of the volume's typical one",
   "Gradient, bei dem die Glättung auf die Hälfte fällt, als Vielfaches des für das Volumen typischen",
   "gradient auquel le lissage tombe de moitié, en multiple de celui typique du volume"},
  {"trilinear: sub-voxel, across the low-passed volume's edges; thesis: whole voxels, 13 directions",
   "trilinear: feiner als Voxel, quer zu den Kanten des tiefpassgefilterten Volumens; Dissertation: ganze Voxel, 13 "
   "Richtungen",
   "trilinéaire : sous-voxel, à travers les bords du volume passe-bas ; thèse : voxels entiers, 13 directions"},
  {"what both thresholds are shares of: the volume's strongest surfaces, or 1 as in the thesis",
   "wovon beide Schwellen Anteile sind: von den stärksten Oberflächen des Volumens, oder von 1 wie in der Dissertation",
   "ce dont les deux seuils sont des parts : les plus fortes surfaces du volume, ou 1 comme dans la thèse"},
  {"smallest classified value of a surface voxel, as a share of the threshold scale",
   "kleinster klassifizierter Wert eines Oberflächenvoxels, als Anteil des Schwellenbezugs",
   "plus petite valeur classifiée d’un voxel de surface, en part de l’échelle des seuils"},
  {"classified value of a strong surface voxel, as a share of the threshold scale",
   "klassifizierter Wert eines starken Oberflächenvoxels, als Anteil des Schwellenbezugs",
   "valeur classifiée d’un voxel de surface fort, en part de l’échelle des seuils"},
  {"hysteresis: every piece with enough strong voxels; largest: one piece alone, as the thesis",
   "Hysterese: jedes Stück mit genug starken Voxeln; größtes: nur ein Stück, wie in der Dissertation",
   "hystérésis : chaque morceau ayant assez de voxels forts ; le plus grand : un seul morceau, comme la thèse"},
  {"strong voxels that a piece needs to be kept, as a share of those of the piece with most of them",
   "starke Voxel, die ein Stück braucht, um zu bleiben, als Anteil derer des Stücks mit den meisten",
   "voxels forts nécessaires pour garder un morceau, en part de ceux du morceau qui en a le plus"},
  {"sheets that hang on a piece by a neck are dropped if their share of strong voxels is below this times the "
   "piece's; 0 keeps all",
   "Flächen, die an einem Hals an einem Stück hängen, fallen weg, wenn ihr Anteil starker Voxel unter dem so "
   "Vielfachen des Stücks liegt; 0 behält alle",
   "les feuillets reliés à un morceau par un col sont retirés si leur part de voxels forts est sous ce multiple de "
   "celle du morceau ; 0 garde tout"},
  {"pieces of the surface that are smaller are dropped; 0 keeps all",
   "kleinere Stücke der Oberfläche fallen weg; 0 behält alle",
   "les morceaux plus petits de la surface sont retirés ; 0 garde tout"},
  {"cosine between beam and inward gradient that a surface needs; -1 keeps all",
   "Kosinus zwischen Schallstrahl und Gradient nach innen, den eine Oberfläche braucht; -1 behält alle",
   "cosinus requis entre le faisceau et le gradient entrant d’une surface ; -1 garde tout"},
  {"how far around its sides a surface that faces the probe is followed, so that what overhangs is whole; 0 leaves "
   "them out",
   "wie weit eine Oberfläche, die dem Schallkopf zugewandt ist, um ihre Seiten verfolgt wird, damit Überhängendes "
   "ganz ist; 0 lässt sie weg",
   "jusqu’où une surface tournée vers la sonde est suivie sur ses côtés, pour que les surplombs soient entiers ; 0 "
   "les omet"},
  {"distance from the border of the scanned region within which nothing is surface",
   "Abstand vom Rand des aufgenommenen Bereichs, innerhalb dessen nichts Oberfläche ist",
   "distance au bord de la région acquise en deçà de laquelle rien n’est surface"},
  {"depth behind a surface within which another one is dropped, such as bone below skin, unless fluid lies between; "
   "0 keeps all",
   "Tiefe hinter einer Oberfläche, innerhalb derer eine weitere wegfällt, etwa Knochen unter Haut, wenn keine "
   "Flüssigkeit dazwischen liegt; 0 behält alle",
   "profondeur derrière une surface où une autre est retirée, comme l’os sous la peau, sauf s’il y a du liquide "
   "entre elles ; 0 garde tout"},
  {"move each point along its normal to where the grey rises most steeply, and from there onto the skin",
   "jeden Punkt entlang seiner Normalen dorthin verschieben, wo der Grauwert am steilsten ansteigt, und von dort "
   "auf die Haut",
   "déplacer chaque point selon sa normale là où le gris monte le plus vite, puis de là sur la peau"},
  {"how far behind the steepest rise the skin lies, as a share of the way in which the grey rises from 20 to 80 %",
   "wie weit die Haut hinter dem steilsten Anstieg liegt, als Anteil der Strecke, auf der der Grauwert von 20 auf "
   "80 % steigt",
   "à quelle distance derrière la montée la plus raide se trouve la peau, en part du trajet où le gris monte de 20 à 80 %"},
  {"cut away at the low end of the volume's axes i, j, k",
   "am unteren Ende der Achsen i, j, k des Volumens abgeschnitten",
   "coupé au début des axes i, j, k du volume"},
  {"cut away at the high end of the volume's axes i, j, k",
   "am oberen Ende der Achsen i, j, k des Volumens abgeschnitten",
   "coupé à la fin des axes i, j, k du volume"},
};
// clang-format on

}  // namespace

std::span<const Text> foundHelps() { return kTexts; }

}  // namespace sonoskin
