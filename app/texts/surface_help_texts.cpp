// What the parameters of surface and mesh do.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"look for eyes, nose, mouth and chin: for the colour of lips, lids and cheeks, for the view, and for the parts "
   "that are kept",
   "nach Augen, Nase, Mund und Kinn suchen: für die Farbe von Lippen, Lidern und Wangen, für den Blick und für die "
   "Teile, die bleiben",
   "chercher les yeux, le nez, la bouche et le menton : pour la couleur des lèvres, paupières et joues, pour la "
   "vue, et pour les parties gardées"},
  {"a face that is less certain than this is not used; 1: none is",
   "ein weniger sicheres Gesicht wird nicht verwendet; 1: keines",
   "un visage moins certain n’est pas utilisé ; 1 : aucun"},
  {"height of a head as expected, from chin to crown",
   "erwartete Kopfhöhe, vom Kinn zum Scheitel",
   "hauteur de tête attendue, du menton au sommet"},
  {"cells along the longest side of the surface",
   "Zellen entlang der längsten Seite der Oberfläche",
   "cellules le long du plus grand côté de la surface"},
  {"edge of a cell; 0: by the resolution",
   "Kante einer Zelle; 0: nach der Auflösung",
   "arête d’une cellule ; 0 : selon la résolution"},
  {"overlap of supports below which the surface is cut off",
   "Überlappung der Träger, unter der die Oberfläche abgeschnitten wird",
   "recouvrement des supports sous lequel la surface est coupée"},
  {"distance from the points beyond which the surface is cut off, in spacings of the points",
   "Abstand von den Punkten, jenseits dessen die Oberfläche abgeschnitten wird, in Punktabständen",
   "distance aux points au-delà de laquelle la surface est coupée, en espacements des points"},
  {"share of the usual density of points below which the surface is cut off; 0: anywhere",
   "Anteil der üblichen Punktdichte, unter dem die Oberfläche abgeschnitten wird; 0: nirgends",
   "part de la densité usuelle de points sous laquelle la surface est coupée ; 0 : nulle part"},
  {"parts at the border that are narrower are cut off, in spacings of the points; 0: none",
   "schmalere Teile am Rand werden abgeschnitten, in Punktabständen; 0: keine",
   "les parties du bord plus étroites sont coupées, en espacements des points ; 0 : aucune"},
  {"probe: the piece most in the probe's view; largest: by area; index, point: see below",
   "Sonde: das Stück, das der Schallkopf am meisten sieht; größtes: nach Fläche; Nummer, Punkt: siehe unten",
   "sonde : le morceau le plus en vue de la sonde ; le plus grand : par l’aire ; numéro, point : voir ci-dessous"},
  {"for piece = probe: parts or pieces that fill this share of the middle of its view are kept too; 1 keeps it alone",
   "für Stück = Sonde: Teile oder Stücke, die diesen Anteil der Mitte seiner Sicht füllen, bleiben auch; 1 behält "
   "es allein",
   "pour morceau = sonde : les parties ou morceaux qui remplissent cette part du milieu de sa vue sont aussi gardés "
   "; 1 le garde seul"},
  {"for piece = index: 0 is the piece with the largest area, 1 the next, ...",
   "für Stück = Nummer: 0 ist das Stück mit der größten Fläche, 1 das nächste, …",
   "pour morceau = numéro : 0 est le morceau de plus grande aire, 1 le suivant, …"},
  {"for piece = point: the piece nearest to this point of the volume's frame",
   "für Stück = Punkt: das Stück, das diesem Punkt im Rahmen des Volumens am nächsten ist",
   "pour morceau = point : le morceau le plus proche de ce point du repère du volume"},
  {"pieces with a smaller area are dropped",
   "Stücke mit kleinerer Fläche fallen weg",
   "les morceaux d’aire plus petite sont retirés"},
  {"holes inside the surface up to this size, measured across, are closed; 0: none",
   "Löcher in der Oberfläche bis zu diesem Durchmesser werden geschlossen; 0: keine",
   "les trous de la surface jusqu’à ce diamètre sont bouchés ; 0 : aucun"},
  {"steps of smoothing that keep features and size",
   "Schritte einer Glättung, die Merkmale und Größe erhält",
   "pas d’un lissage qui garde les détails et la taille"},
  {"reduce the mesh to this many triangles; 0: all are kept",
   "das Netz auf so viele Dreiecke verringern; 0: alle bleiben",
   "réduire le maillage à ce nombre de triangles ; 0 : tous sont gardés"},
  {"automatic: the surface is cut where people would cut it, and the face and what belongs to the baby are kept, if "
   "piece = probe; pieces: whole connected pieces; all: every part is kept",
   "automatisch: Die Oberfläche wird geteilt, wo ein Mensch sie teilen würde, und das Gesicht und was zum Kind "
   "gehört bleibt, wenn Stück = Sonde; Stücke: ganze zusammenhängende Stücke; alle: jedes Teil bleibt",
   "automatique : la surface est coupée là où on la couperait à la main, et le visage et ce qui est du bébé sont "
   "gardés, si morceau = sonde ; morceaux : morceaux connexes entiers ; tout : chaque partie est gardée"},
  {"parts that are kept too: those nearest to these places",
   "Teile, die auch bleiben: die diesen Stellen nächsten",
   "parties gardées en plus : les plus proches de ces points"},
  {"parts that are taken away: those nearest to these places",
   "Teile, die entfernt werden: die diesen Stellen nächsten",
   "parties retirées : les plus proches de ces points"},
  {"strokes that split a part, three places each: begin and end on the surface, and the eye that drew it",
   "Striche, die ein Teil teilen, je drei Stellen: Anfang und Ende auf der Oberfläche und das Auge, das ihn zog",
   "traits qui divisent une partie, trois points chacun : début et fin sur la surface, et l’œil qui l’a tracé"},
  {"shell: a wall behind the surface; block: a relief with a flat back",
   "Schale: eine Wand hinter der Oberfläche; Block: ein Relief mit flacher Rückseite",
   "coque : une paroi derrière la surface ; bloc : un relief à dos plat"},
  {"shell: of the wall; block: of its thinnest place",
   "Schale: der Wand; Block: an seiner dünnsten Stelle",
   "coque : de la paroi ; bloc : à son endroit le plus mince"},
  {"size of the print; 1 is life-size",
   "Größe des Drucks; 1 ist Lebensgröße",
   "taille de l’impression ; 1 est grandeur nature"},
  {"the radial function; the harmonic ones and thinPlate have no width",
   "die radiale Funktion; die harmonischen und die dünne Platte haben keine Breite",
   "la fonction radiale ; les harmoniques et la plaque mince n’ont pas de largeur"},
  {"degree of the polynomial, -1: none; at least 0 for biharmonic and multiquadric, 1 for triharmonic and thinPlate",
   "Grad des Polynoms, -1: keines; mindestens 0 für biharmonisch und multiquadratisch, 1 für triharmonisch und "
   "dünne Platte",
   "degré du polynôme, -1 : aucun ; au moins 0 pour biharmonique et multiquadrique, 1 pour triharmonique et plaque mince"},
  {"width of gaussian, multiquadric, inverseMultiquadric; support of wendland",
   "Breite von Gauß, multiquadratisch und invers multiquadratisch; Träger von Wendland",
   "largeur de gaussienne, multiquadrique et multiquadrique inverse ; support de Wendland"},
  {"distance of the points off the surface; halved where another part of it is nearer",
   "Abstand der Punkte abseits der Oberfläche; halbiert, wo ein anderer Teil von ihr näher ist",
   "distance des points hors de la surface ; réduite de moitié si une autre partie en est plus proche"},
  {"share of the points that have points off the surface, on both sides",
   "Anteil der Punkte, die Punkte abseits der Oberfläche haben, auf beiden Seiten",
   "part des points qui ont des points hors de la surface, des deux côtés"},
  {"points that the surface misses by more become centres, until there are none; 0: every point is one",
   "Punkte, die die Oberfläche um mehr verfehlt, werden Zentren, bis es keine mehr gibt; 0: jeder Punkt ist eines",
   "les points que la surface manque de plus deviennent des centres, jusqu’à ce qu’il n’y en ait plus ; 0 : chaque "
   "point en est un"},
  {"smoothing: added to the diagonal of the system, as a multiple of what the basis changes over the offset",
   "Glättung: zur Diagonale des Systems addiert, als Vielfaches der Änderung der Basis über den Versatz",
   "lissage : ajouté à la diagonale du système, en multiple de la variation de la base sur le décalage"},
  {"residual of the solver, as a share of the right side",
   "Residuum des Lösers, als Anteil der rechten Seite",
   "résidu du solveur, en part du second membre"},
  {"more centres than this are refused: time grows with their square",
   "mehr Zentren werden abgelehnt: Die Zeit wächst mit ihrem Quadrat",
   "davantage de centres sont refusés : le temps croît avec leur carré"},
  {"adaptive: local and fast; thesis: as the thesis' program did; global: one function through all",
   "adaptiv: örtlich und schnell; Dissertation: wie das Programm der Dissertation; global: eine Funktion durch alle",
   "adaptative : locale et rapide ; thèse : comme le programme de la thèse ; globale : une fonction par tous"},
  {"1e-5 keeps detail and noise, 1e-4 is smooth",
   "1e-5 behält Feinheiten und Rauschen, 1e-4 ist glatt",
   "1e-5 garde détails et bruit, 1e-4 est lisse"},
  {"each place is as smooth as its measured noise asks for: smoothness then says how much more or less than 2e-5, "
   "which stands for just so much; off: the same smoothness everywhere",
   "jede Stelle ist so glatt, wie ihr gemessenes Rauschen verlangt: Die Glattheit sagt dann, wie viel mehr oder "
   "weniger als 2e-5, das für genau so viel steht; aus: überall gleich glatt",
   "chaque endroit est aussi lisse que le demande son bruit mesuré : la régularité dit alors combien de plus ou de "
   "moins que 2e-5, qui signifie juste autant ; non : la même régularité partout"},
  {"supports that must cover every point, at least",
   "Träger, die jeden Punkt mindestens überdecken müssen",
   "supports qui doivent couvrir chaque point, au moins"},
  {"neighbours that measure the density around a point",
   "Nachbarn, die die Dichte um einen Punkt messen",
   "voisins qui mesurent la densité autour d’un point"},
  {"largest support, as a share of the diagonal of the points' box",
   "größter Träger, als Anteil der Diagonale der Punktebox",
   "plus grand support, en part de la diagonale de la boîte des points"},
  {"points count by the strength of their echo",
   "Punkte zählen nach der Stärke ihres Echos",
   "les points comptent selon la force de leur écho"},
  {"fit the weights lambda too; lowers the residual by following the noise",
   "auch die Gewichte Lambda anpassen; senkt das Residuum, indem es dem Rauschen folgt",
   "ajuster aussi les poids lambda ; réduit le résidu en suivant le bruit"},
  {"regularisation of the weights lambda", "Regularisierung der Gewichte Lambda", "régularisation des poids lambda"},
};
// clang-format on

}  // namespace

std::span<const Text> surfaceHelps() { return kTexts; }

}  // namespace sonoskin
