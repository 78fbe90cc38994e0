// Sentences that are said: progress, doubts, notes and failures.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"{} is a surface; the window opens volumes and makes surfaces of them. A picture of it is made by 'sonoskin render'.",
   "{} ist eine Oberfläche; das Fenster öffnet Volumen und macht Oberflächen daraus. Ein Bild davon macht „sonoskin "
   "render“.",
   "{} est une surface ; la fenêtre ouvre des volumes et en fait des surfaces. « sonoskin render » en fait une image."},
  {"The scan tells how its beams run: the planes are the scanner's.",
   "Die Aufnahme sagt, wie ihre Strahlen verlaufen: Die Ebenen sind die des Schallkopfs.",
   "L’acquisition dit comment vont ses faisceaux : les plans sont ceux de la sonde."},
  {"The scan is ultrasound, which does not know how the patient lies: the planes are the scanner's.",
   "Die Aufnahme ist Ultraschall, der nicht weiß, wie der Patient liegt: Die Ebenen sind die des Schallkopfs.",
   "L’acquisition est une échographie, qui ignore la position du patient : les plans sont ceux de la sonde."},
  {"The scan knows how the patient lies: the planes are the patient's.",
   "Die Aufnahme weiß, wie der Patient liegt: Die Ebenen sind die des Patienten.",
   "L’acquisition connaît la position du patient : les plans sont ceux du patient."},
  {"The values are those of a CT, which knows how the patient lies: the planes are the patient's.",
   "Die Werte sind die einer CT, die weiß, wie der Patient liegt: Die Ebenen sind die des Patienten.",
   "Les valeurs sont celles d’une TDM, qui connaît la position du patient : les plans sont ceux du patient."},
  {"The file does not tell what made it and is taken for ultrasound: the planes are the scanner's.",
   "Die Datei sagt nicht, womit sie gemacht ist, und gilt als Ultraschall: Die Ebenen sind die des Schallkopfs.",
   "Le fichier ne dit pas d’où il vient et est pris pour une échographie : les plans sont ceux de la sonde."},
  {"no face is certain enough to be used (confidence {:.2f} of {:.2f})",
   "kein Gesicht ist sicher genug, um verwendet zu werden (Sicherheit {:.2f} von {:.2f})",
   "aucun visage n’est assez certain pour être utilisé (confiance {:.2f} sur {:.2f})"},
  {"a face was found, its head about {:.0f} mm from chin to crown (confidence {:.2f})",
   "ein Gesicht wurde gefunden, der Kopf etwa {:.0f} mm vom Kinn zum Scheitel (Sicherheit {:.2f})",
   "un visage a été trouvé, tête d’environ {:.0f} mm du menton au sommet (confiance {:.2f})"},
  {"the head would be {:.0f} mm from chin to crown, where heads before and after birth have {:.0f} to {:.0f}: is "
   "the spacing right?",
   "der Kopf wäre {:.0f} mm vom Kinn zum Scheitel, wo Köpfe vor und nach der Geburt {:.0f} bis {:.0f} haben: Stimmt "
   "der Voxelabstand?",
   "la tête ferait {:.0f} mm du menton au sommet, alors qu’avant et après la naissance elle en fait {:.0f} à {:.0f} "
   ": le pas est-il juste ?"},
  {"the file says that it is {}, not ultrasound: the surface may be anything but a baby's skin; open a 3D ultrasound scan",
   "die Datei sagt, sie sei {}, kein Ultraschall: Die Oberfläche kann alles sein, nur nicht die Haut eines Kindes; "
   "öffnen Sie eine 3D-Ultraschallaufnahme",
   "le fichier dit être {}, pas une échographie : la surface peut être tout sauf la peau d’un bébé ; ouvrez une "
   "échographie 3D"},
  {"the values begin at {:g}, as in a CT and not in ultrasound: the surface may be anything but a baby's skin; open "
   "a 3D ultrasound scan",
   "die Werte beginnen bei {:g}, wie in einer CT und nicht im Ultraschall: Die Oberfläche kann alles sein, nur "
   "nicht die Haut eines Kindes; öffnen Sie eine 3D-Ultraschallaufnahme",
   "les valeurs commencent à {:g}, comme en TDM et non en échographie : la surface peut être tout sauf la peau d’un "
   "bébé ; ouvrez une échographie 3D"},
  {"there is but one grey in what was recorded, and so no surface; open another scan",
   "in der Aufnahme ist nur ein Grauwert, und daher keine Oberfläche; öffnen Sie eine andere",
   "il n’y a qu’un gris dans ce qui a été acquis, donc pas de surface ; ouvrez une autre acquisition"},
  {"no border of skin and fluid rises from the noise: the surface is made of noise; record with more contrast, or "
   "open another scan",
   "keine Grenze von Haut und Flüssigkeit hebt sich vom Rauschen ab: Die Oberfläche besteht aus Rauschen; nehmen "
   "Sie mit mehr Kontrast auf oder öffnen Sie eine andere Aufnahme",
   "aucune limite entre peau et liquide ne ressort du bruit : la surface est faite de bruit ; acquérez avec plus de "
   "contraste, ou ouvrez une autre acquisition"},
  {"edges face all ways alike, as in a CT or an MRI, and not the probe, as in ultrasound: the surface may not be "
   "skin; if this is a face in fluid, set scan.probeSide",
   "Kanten weisen in alle Richtungen gleich, wie in CT oder MRT, und nicht zum Schallkopf, wie im Ultraschall: Die "
   "Oberfläche ist vielleicht keine Haut; ist dies ein Gesicht in Flüssigkeit, setzen Sie scan.probeSide",
   "les bords regardent de tous côtés, comme en TDM ou IRM, et non vers la sonde, comme en échographie : la surface "
   "n’est peut-être pas de la peau ; si c’est un visage dans le liquide, réglez scan.probeSide"},
  {"only {} % of what was recorded is as dark as fluid: the surface may be the border of any tissue; a face can be "
   "seen where fluid lies before it",
   "nur {} % der Aufnahme sind so dunkel wie Flüssigkeit: Die Oberfläche kann die Grenze irgendeines Gewebes sein; "
   "ein Gesicht ist zu sehen, wo Flüssigkeit davor liegt",
   "seulement {} % de ce qui a été acquis est aussi sombre que du liquide : la surface peut être la limite de tout "
   "tissu ; un visage se voit là où il y a du liquide devant"},
  {"only {} % of the surface has fluid before it: it may not be skin; set scan.probeSide if the probe is elsewhere, "
   "or crop the volume to the face",
   "nur {} % der Oberfläche haben Flüssigkeit vor sich: Sie ist vielleicht keine Haut; setzen Sie scan.probeSide, "
   "wenn der Schallkopf anderswo ist, oder schneiden Sie das Volumen auf das Gesicht zu",
   "seulement {} % de la surface a du liquide devant elle : ce n’est peut-être pas de la peau ; réglez "
   "scan.probeSide si la sonde est ailleurs, ou rognez le volume au visage"},
  {"across the surface the grey rises over {:.1f} mm, too slowly for a border of skin and fluid: it may not be "
   "skin, or the spacing is wrong; look at the slices",
   "quer zur Oberfläche steigt der Grauwert auf {:.1f} mm an, zu langsam für eine Grenze von Haut und Flüssigkeit: "
   "Sie ist vielleicht keine Haut, oder der Voxelabstand ist falsch; sehen Sie die Schnittbilder an",
   "à travers la surface, le gris monte sur {:.1f} mm, trop lentement pour une limite entre peau et liquide : ce "
   "n’est peut-être pas de la peau, ou le pas est faux ; regardez les coupes"},
  {"the surface is in pieces, the largest with {} % of it: they may not be skin; move classification.isoValue, or "
   "crop the volume to the face",
   "die Oberfläche ist in Stücken, das größte mit {} % davon: Sie sind vielleicht keine Haut; ändern Sie den "
   "Isowert oder schneiden Sie das Volumen auf das Gesicht zu",
   "la surface est en morceaux, le plus grand en fait {} % : ce n’est peut-être pas de la peau ; changez "
   "l’isovaleur, ou rognez le volume au visage"},
  {"the scan would be {:.0f} mm across, more than probes see: is the spacing right?",
   "die Aufnahme wäre {:.0f} mm groß, mehr als Schallköpfe sehen: Stimmt der Voxelabstand?",
   "l’acquisition ferait {:.0f} mm, plus que ne voient les sondes : le pas est-il juste ?"},
  {"Opening {}", "Öffnen von {}", "Ouverture de {}"},
  {"Saving {}", "Speichern von {}", "Enregistrement de {}"},
  {"Simulating the phantom", "Das Phantom wird simuliert", "Simulation du fantôme"},
  {"Restoring the session", "Die Sitzung wird wiederhergestellt", "Restauration de la session"},
  {"Reading time step {}", "Zeitschritt {} wird gelesen", "Lecture du pas de temps {}"},
  {"enhancement", "Entrauschen", "débruitage"},
  {"coarser voxels", "gröbere Voxel", "voxels plus gros"},
  {"low-pass", "Tiefpass", "passe-bas"},
  {"classification", "Klassifikation", "classification"},
  {"points", "Punkte", "points"},
  {"evidence", "Beleg", "indices"},
  {"face", "Gesicht", "visage"},
  {"fit", "Anpassung", "ajustement"},
  {"surface", "Oberfläche", "surface"},
  {"parts", "Teile", "parties"},
  {"piece", "Stück", "morceau"},
  {"clean", "Säubern", "nettoyage"},
  {"print", "Druckkörper", "impression"},
  {"preview", "Vorschau", "aperçu"},
  {"What the recipe erases is of another volume; nothing is erased of this one.",
   "Was das Rezept radiert, gehört zu einem anderen Volumen; in diesem wird nichts radiert.",
   "Ce que la recette gomme vient d’un autre volume ; rien n’est gommé dans celui-ci."},
  {"The file gives no spacing and 1 mm is assumed, so that lengths and areas mean nothing; give it as scan.spacing.",
   "Die Datei gibt keinen Voxelabstand an, 1 mm wird angenommen; Längen und Flächen bedeuten daher nichts; geben "
   "Sie ihn als scan.spacing an.",
   "Le fichier ne donne pas de pas et 1 mm est supposé ; longueurs et aires ne veulent donc rien dire ; donnez-le "
   "par scan.spacing."},
  {"The scan has {} time steps; the first is used.",
   "Die Aufnahme hat {} Zeitschritte; der erste wird verwendet.",
   "L’acquisition a {} pas de temps ; le premier est utilisé."},
  {"The surface that is saved is older than the parameters; the recipe beside it has its own.",
   "Die gespeicherte Oberfläche ist älter als die Parameter; das Rezept daneben hat die ihren.",
   "La surface enregistrée est plus ancienne que les paramètres ; la recette à côté a les siens."},
  {"The surface that is saved was made with short cuts while the parameters moved; reconstruct it, and save it "
   "again, for one that its recipe repeats.",
   "Die gespeicherte Oberfläche entstand mit Abkürzungen, während sich die Parameter bewegten; rekonstruieren und "
   "speichern Sie sie neu, damit ihr Rezept sie wiederholt.",
   "La surface enregistrée a été faite avec des raccourcis pendant que les paramètres changeaient ; "
   "reconstruisez-la et enregistrez-la à nouveau, pour que sa recette la répète."},
  {"There is no volume to erase from; open it first.",
   "Es gibt kein Volumen zum Radieren; öffnen Sie zuerst eines.",
   "Il n’y a pas de volume à gommer ; ouvrez-en un d’abord."},
  {"Nothing is erased that could be saved; erase something first.",
   "Nichts Radiertes zu speichern; radieren Sie zuerst etwas.",
   "Rien de gommé à enregistrer ; gommez d’abord quelque chose."},
  {"There is no surface to save yet; reconstruct it first.",
   "Es gibt noch keine Oberfläche zu speichern; rekonstruieren Sie sie zuerst.",
   "Il n’y a pas encore de surface à enregistrer ; reconstruisez-la d’abord."},
  {"There is no surface to print yet; reconstruct it first.",
   "Es gibt noch keine Oberfläche zu drucken; rekonstruieren Sie sie zuerst.",
   "Il n’y a pas encore de surface à imprimer ; reconstruisez-la d’abord."},
  {"There is no scan to save; open one.",
   "Es gibt keine Aufnahme zu speichern; öffnen Sie eine.",
   "Il n’y a pas d’acquisition à enregistrer ; ouvrez-en une."},
  {"Nothing is classified yet; wait until it is.",
   "Noch ist nichts klassifiziert; warten Sie einen Moment.",
   "Rien n’est encore classifié ; patientez un instant."},
  {"There is nothing to save as a session; open a volume.",
   "Es gibt nichts als Sitzung zu speichern; öffnen Sie ein Volumen.",
   "Rien à enregistrer comme session ; ouvrez un volume."},
  {"The session does not tell where its volume is",
   "Die Sitzung sagt nicht, wo ihr Volumen ist",
   "La session ne dit pas où est son volume"},
  {"The session's volume is not there: {}", "Das Volumen der Sitzung fehlt: {}", "Le volume de la session manque : {}"},
  {"The session was saved with another volume than {}",
   "Die Sitzung wurde mit einem anderen Volumen als {} gespeichert",
   "La session a été enregistrée avec un autre volume que {}"},
  {"This is no session of Sonoskin, or it is damaged; open another one.",
   "Dies ist keine Sitzung von Sonoskin, oder sie ist beschädigt; öffnen Sie eine andere.",
   "Ce n’est pas une session de Sonoskin, ou elle est endommagée ; ouvrez-en une autre."},
  {"The skin is not ready yet; wait until the view shows it.",
   "Die Haut ist noch nicht fertig; warten Sie, bis die Ansicht sie zeigt.",
   "La peau n’est pas encore prête ; attendez que la vue la montre."},
  {"That is no name for colours; give letters, digits, spaces, - and _.",
   "Das ist kein Name für Farben; geben Sie Buchstaben, Ziffern, Leerzeichen, - und _ ein.",
   "Ce n’est pas un nom pour des couleurs ; donnez lettres, chiffres, espaces, - et _."},
  {"The program's own colours keep their names; give another one.",
   "Die Farben des Programms behalten ihre Namen; geben Sie einen anderen ein.",
   "Les couleurs du programme gardent leurs noms ; donnez-en un autre."},
  {"{} is there already; choose another name.",
   "{} ist schon vorhanden; wählen Sie einen anderen Namen.",
   "{} existe déjà ; choisissez un autre nom."},
  {"The graphics driver reports an error ({}), so that pictures may be wrong; a newer driver may help.",
   "Der Grafiktreiber meldet einen Fehler ({}), sodass Bilder falsch sein können; ein neuerer Treiber hilft vielleicht.",
   "Le pilote graphique signale une erreur ({}), les images peuvent être fausses ; un pilote plus récent peut aider."},
  {"What was open when Sonoskin ended unexpectedly cannot be read; it stays in {}.",
   "Was offen war, als Sonoskin unerwartet endete, ist nicht lesbar; es bleibt in {}.",
   "Ce qui était ouvert quand Sonoskin s’est terminé de façon inattendue est illisible ; cela reste dans {}."},
  {"There are {} measures, as many as a session holds; take one away first.",
   "Es gibt {} Messungen, so viele, wie eine Sitzung fasst; nehmen Sie zuerst eine weg.",
   "Il y a {} mesures, autant qu’une session en contient ; enlevez-en une d’abord."},
  {"a CT", "eine CT", "une TDM"},
  {"an MRI", "eine MRT", "une IRM"},
  {"of the kind {}", "von der Art {}", "du genre {}"},
};
// clang-format on

}  // namespace

std::span<const Text> messageTexts() { return kTexts; }

}  // namespace sonoskin
