// What the parameters of files and the phantom do.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"numbers along the three axes of a file without a header, the fastest first; 0: not told; when it is opened next",
   "Zahlen entlang der drei Achsen einer Datei ohne Vorspann, die schnellste zuerst; 0: nicht angegeben; beim "
   "nächsten Öffnen",
   "nombres le long des trois axes d’un fichier sans en-tête, le plus rapide d’abord ; 0 : non indiqué ; à la "
   "prochaine ouverture"},
  {"how one number is stored", "wie eine Zahl gespeichert ist", "comment un nombre est stocké"},
  {"which byte of a number comes first", "welches Byte einer Zahl zuerst kommt", "quel octet d’un nombre vient en premier"},
  {"before the first number; -1: all that is more than the numbers",
   "vor der ersten Zahl; -1: alles, was mehr ist als die Zahlen",
   "avant le premier nombre ; -1 : tout ce qui dépasse les nombres"},
  {"volumes one after another in the file",
   "Volumen hintereinander in der Datei",
   "volumes l’un après l’autre dans le fichier"},
  {"from number to number along the three axes; a sector needs the first, along its beams, a pyramid the first two, "
   "within its pictures; 0: unknown",
   "von Zahl zu Zahl entlang der drei Achsen; ein Sektor braucht den ersten, entlang seiner Strahlen, eine Pyramide "
   "die ersten beiden, in ihren Bildern; 0: unbekannt",
   "d’un nombre au suivant le long des trois axes ; un secteur demande le premier, le long de ses faisceaux, une "
   "pyramide les deux premiers, dans ses images ; 0 : inconnu"},
  {"where the numbers were sampled: cartesian: on voxels; sector: along the beams of a fan that was swept (axes: "
   "along the beam, fan, sweep); pyramid: on straight pictures that draw apart with the depth (axes: across, depth, "
   "pictures)",
   "wo die Zahlen abgetastet wurden: kartesisch: auf Voxeln; Sektor: entlang der Strahlen eines geschwenkten "
   "Fächers (Achsen: Strahl, Fächer, Schwenk); Pyramide: auf ebenen Bildern, die mit der Tiefe auseinandergehen "
   "(Achsen: quer, Tiefe, Bilder)",
   "où les nombres ont été échantillonnés : cartésienne : sur des voxels ; secteur : le long des faisceaux d’un "
   "éventail balayé (axes : faisceau, éventail, balayage) ; pyramide : sur des images planes qui s’écartent avec la "
   "profondeur (axes : travers, profondeur, images)"},
  {"of a sector, from the apex of its fan to the first number",
   "eines Sektors, vom Scheitel seines Fächers zur ersten Zahl",
   "d’un secteur, du sommet de son éventail au premier nombre"},
  {"of a sector, from the apex of its fan to the axis that it was swept about",
   "eines Sektors, vom Scheitel seines Fächers zur Achse, um die er geschwenkt wurde",
   "d’un secteur, du sommet de son éventail à l’axe de balayage"},
  {"of a sector, between the outermost beams of its fan",
   "eines Sektors, zwischen den äußersten Strahlen seines Fächers",
   "d’un secteur, entre les faisceaux extrêmes de son éventail"},
  {"of a sector, between the outermost pictures of its sweep; of a pyramid, between the sides of its stack of pictures",
   "eines Sektors, zwischen den äußersten Bildern seines Schwenks; einer Pyramide, zwischen den Seiten ihres Bilderstapels",
   "d’un secteur, entre les images extrêmes de son balayage ; d’une pyramide, entre les côtés de sa pile d’images"},
  {"of a pyramid, how wide the stack of pictures is at their near edge",
   "einer Pyramide, wie breit der Bilderstapel an seiner nahen Kante ist",
   "d’une pyramide, largeur de la pile d’images à leur bord proche"},
  {"voxels of the simulated volume", "Voxel des simulierten Volumens", "voxels du volume simulé"},
  {"what makes the scan hard; clear: nothing much",
   "was die Aufnahme schwierig macht; klar: nicht viel",
   "ce qui rend l’acquisition difficile ; claire : pas grand-chose"},
  {"another number gives another head: size, proportions, features; 0 is the first one",
   "eine andere Zahl gibt einen anderen Kopf: Größe, Proportionen, Merkmale; 0 ist der erste",
   "un autre nombre donne une autre tête : taille, proportions, traits ; 0 est la première"},
  {"echo of soft tissue over the noise of the receiver; 0 is very noisy, 40 nearly clean",
   "Echo der Weichteile über dem Rauschen des Empfängers; 0 ist sehr verrauscht, 40 fast rein",
   "écho des parties molles par rapport au bruit du récepteur ; 0 est très bruité, 40 presque net"},
  {"another number gives another pattern of speckle",
   "eine andere Zahl gibt ein anderes Specklemuster",
   "un autre nombre donne un autre motif de speckle"},
  {"side of the volume where the probe was, if the file does not say",
   "Seite des Volumens, an der der Schallkopf war, wenn die Datei es nicht sagt",
   "côté du volume où était la sonde, si le fichier ne le dit pas"},
  {"side of the volume that pictures show at the top, if the file does not say",
   "Seite des Volumens, die Bilder oben zeigen, wenn die Datei es nicht sagt",
   "côté du volume que les images montrent en haut, si le fichier ne le dit pas"},
  {"where the beams start: automatic: what the file says, else where the sides of the scanned sector meet; given: "
   "in scan.apex; parallel: nowhere",
   "wo die Strahlen beginnen: automatisch: was die Datei sagt, sonst wo sich die Seiten des Sektors treffen; "
   "gegeben: in scan.apex; parallel: nirgends",
   "où partent les faisceaux : automatique : ce que dit le fichier, sinon là où se rejoignent les côtés du secteur "
   "; donnée : dans scan.apex ; parallèle : nulle part"},
  {"where the beams start if scan.beamOrigin is given; in the world of the volume",
   "wo die Strahlen beginnen, wenn scan.beamOrigin gegeben ist; in der Welt des Volumens",
   "où partent les faisceaux si scan.beamOrigin est donnée ; dans le monde du volume"},
  {"from voxel to voxel, for files that give no spacing; 0: unknown",
   "von Voxel zu Voxel, für Dateien ohne Voxelabstand; 0: unbekannt",
   "d’un voxel au suivant, pour les fichiers sans pas ; 0 : inconnu"},
  {"which of several volumes in a file or folder, as info counts them; 0: it holds one alone; when it is opened next",
   "welches von mehreren Volumen einer Datei oder eines Ordners, wie info sie zählt; 0: es ist nur eines; beim "
   "nächsten Öffnen",
   "lequel de plusieurs volumes d’un fichier ou dossier, comme info les compte ; 0 : il n’y en a qu’un ; à la "
   "prochaine ouverture"},
  {"which time step of a recording in time, counted from 1",
   "welcher Zeitschritt einer zeitlichen Aufnahme, gezählt ab 1",
   "quel pas d’un enregistrement dans le temps, compté à partir de 1"},
  {"edge of the voxels that samples of a probe's beams are converted to, for files that hold those; 0: as fine as "
   "they were sampled; when it is opened next",
   "Kante der Voxel, in die Abtastwerte der Strahlen umgerechnet werden, für Dateien, die solche enthalten; 0: so "
   "fein wie abgetastet; beim nächsten Öffnen",
   "arête des voxels en lesquels les échantillons des faisceaux sont convertis, pour les fichiers qui en contiennent"
   " ; 0 : aussi fine qu’échantillonnée ; à la prochaine ouverture"},
  {"axis of a volume that is turned over in the world, for files whose left and right come out swapped",
   "Achse eines Volumens, die in der Welt umgekehrt wird, für Dateien, bei denen links und rechts vertauscht herauskommen",
   "axe d’un volume inversé dans le monde, pour les fichiers où gauche et droite sont échangées"},
  {"blanks what lies outside of the picture in ultrasound of DICOM, such as names that are burnt in, where the file "
   "says where the picture lies; when it is opened next",
   "leert, was in DICOM-Ultraschall außerhalb des Bildes liegt, etwa eingebrannte Namen, wo die Datei sagt, wo das "
   "Bild liegt; beim nächsten Öffnen",
   "efface ce qui est hors de l’image dans l’échographie DICOM, comme des noms incrustés, si le fichier dit où est "
   "l’image ; à la prochaine ouverture"},
  {"reads a volume at half its resolution, in an eighth of the memory; when it is opened next",
   "liest ein Volumen mit halber Auflösung, in einem Achtel des Speichers; beim nächsten Öffnen",
   "lit un volume à la moitié de sa résolution, dans un huitième de la mémoire ; à la prochaine ouverture"},
  {"left out at the sides i-low, j-low, k-low of a volume when it is opened next",
   "an den Seiten i unten, j unten, k unten eines Volumens beim nächsten Öffnen weggelassen",
   "laissé de côté aux bords i bas, j bas, k bas d’un volume à la prochaine ouverture"},
  {"left out at the sides i-high, j-high, k-high of a volume when it is opened next",
   "an den Seiten i oben, j oben, k oben eines Volumens beim nächsten Öffnen weggelassen",
   "laissé de côté aux bords i haut, j haut, k haut d’un volume à la prochaine ouverture"},
};
// clang-format on

}  // namespace

std::span<const Text> scanHelps() { return kTexts; }

}  // namespace sonoskin
