// About, the list of mouse and keys, and the tour.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"Turns a noisy three-dimensional ultrasound scan into a smooth surface of the face, and the surface into a picture.",
   "Macht aus einer verrauschten dreidimensionalen Ultraschallaufnahme eine glatte Oberfläche des Gesichts, und aus "
   "der Oberfläche ein Bild.",
   "Transforme une échographie tridimensionnelle bruitée en une surface lisse du visage, et la surface en une image."},
  {"For research and keepsakes. Not for diagnosis: what is seen here may have been smoothed away or filled in.",
   "Für Forschung und Andenken. Nicht für die Diagnose: Was hier zu sehen ist, kann geglättet oder ergänzt sein.",
   "Pour la recherche et le souvenir. Pas pour le diagnostic : ce que l’on voit ici peut avoir été lissé ou comblé."},
  {"What it is made of, and under which licences",
   "Woraus es besteht, und unter welchen Lizenzen",
   "De quoi il est fait, et sous quelles licences"},
  {"Find a command or a parameter", "Befehl oder Parameter suchen", "Chercher une commande ou un paramètre"},
  {"No command or parameter has these words",
   "Kein Befehl oder Parameter hat diese Wörter",
   "Aucune commande ni paramètre n’a ces mots"},
  {"Left button", "Linke Taste", "Bouton gauche"},
  {"move the cross-hair", "Fadenkreuz bewegen", "déplacer le réticule"},
  {"Wheel", "Rad", "Molette"},
  {"next slice", "nächste Schicht", "coupe suivante"},
  {"Ctrl+wheel", "Strg+Rad", "Ctrl+molette"},
  {"zoom", "zoomen", "zoomer"},
  {"Middle or Shift+left", "Mitte oder Umschalt+links", "Milieu ou Maj+gauche"},
  {"pan", "verschieben", "déplacer"},
  {"Right", "Rechts", "Droite"},
  {"window (sideways), level (up and down)",
   "Fensterbreite (seitwärts), -lage (auf und ab)",
   "largeur (horizontal), centre (vertical)"},
  {"Left on a side of the crop box", "Links auf einer Seite der Box", "Gauche sur un côté de la boîte"},
  {"move it", "bewegen", "le déplacer"},
  {"Left", "Links", "Gauche"},
  {"erase a ball", "eine Kugel radieren", "gommer une boule"},
  {"Ctrl+left", "Strg+links", "Ctrl+gauche"},
  {"bring back", "zurückholen", "rétablir"},
  {"Outline", "Umriss", "Contour"},
  {"cut out what is seen within it", "ausschneiden, was darin zu sehen ist", "découper ce qu’il entoure"},
  {"bring it back", "es zurückholen", "le rétablir"},
  {"Shift+left", "Umschalt+links", "Maj+gauche"},
  {"keep nothing but what is seen within it", "nur behalten, was darin zu sehen ist", "ne garder que ce qu’il entoure"},
  {"Click, or drag", "Klick oder Ziehen", "Clic, ou glisser"},
  {"set a mark, or move one", "Marke setzen oder bewegen", "placer ou déplacer une marque"},
  {"Double click", "Doppelklick", "Double clic"},
  {"close an area", "Fläche schließen", "fermer une aire"},
  {"rotate", "drehen", "tourner"},
  {"Right or wheel", "Rechts oder Rad", "Droite ou molette"},
  {"Click on the cube", "Klick auf den Würfel", "Clic sur le cube"},
  {"look from that side", "von dieser Seite blicken", "regarder de ce côté"},
  {"Click", "Klick", "Clic"},
  {"take a part away, or bring it back", "Teil entfernen oder zurückholen", "retirer ou rétablir une partie"},
  {"Shift+click", "Umschalt+Klick", "Maj+clic"},
  {"leave that part alone", "nur dieses Teil lassen", "ne laisser que cette partie"},
  {"draw a line that splits a part", "Linie ziehen, die ein Teil teilt", "tracer une ligne qui divise"},
  {"Left on the lamp", "Links auf der Lampe", "Gauche sur la lampe"},
  {"move the light; beyond the rim: behind",
   "Licht bewegen; außerhalb: dahinter",
   "déplacer la lumière ; hors du bord : derrière"},
  {"Wheel on the lamp", "Rad auf der Lampe", "Molette sur la lampe"},
  {"its distance, if it is near or inside", "ihr Abstand, wenn nah oder innen", "sa distance, si proche ou intérieure"},
  {"Left on the dividing line", "Links auf der Trennlinie", "Gauche sur la séparation"},
  {"move it, where two pictures are compared", "bewegen, wo verglichen wird", "la déplacer, en comparaison"},
  {"Any view", "Ansichten", "Vues"},
  {"alone and back", "allein und zurück", "seule et retour"},
  {"Sliders", "Regler", "Curseurs"},
  {"Double click or right", "Doppelklick oder rechts", "Double clic ou droite"},
  {"default", "Standard", "valeur par défaut"},
  {"Click on the number", "Klick auf die Zahl", "Clic sur le nombre"},
  {"type it", "eingeben", "le saisir"},
  {"Drop a file", "Datei ablegen", "Déposer un fichier"},
  {"open it", "öffnen", "l’ouvrir"},
  {"F10 or Alt", "F10 oder Alt", "F10 ou Alt"},
  {"the menus: arrows, Enter, Escape", "Menüs: Pfeile, Eingabe, Esc", "les menus : flèches, Entrée, Échap"},
  {"Tab", "Tab", "Tab"},
  {"the side panel: arrows, Enter or space; Escape",
   "Seitenleiste: Pfeile, Eingabe oder Leertaste; Esc",
   "le panneau : flèches, Entrée ou espace ; Échap"},
  {"End tour", "Beenden", "Quitter"},
  {"Five steps on a simulated scan show how the window works. It is in the Help menu, too.",
   "Fünf Schritte an einer simulierten Aufnahme zeigen, wie das Fenster funktioniert. Der Rundgang steht auch im "
   "Menü Hilfe.",
   "Cinq étapes sur une acquisition simulée montrent le fonctionnement de la fenêtre. La visite est aussi dans le "
   "menu Aide."},
  {"New here? Take the tour", "Neu hier? Zum Rundgang", "Nouveau ? Faites la visite"},
  {"Not now", "Jetzt nicht", "Plus tard"},
  {"The scan in slices", "Die Aufnahme in Schnittbildern", "L’acquisition en coupes"},
  {"Three slices meet at the cross-hair. Drag it with the left button; the wheel goes to the next slice, the right "
   "button sets brightness and contrast.",
   "Drei Schnittbilder treffen sich am Fadenkreuz. Ziehen Sie es mit der linken Taste; das Rad geht zur nächsten "
   "Schicht, die rechte Taste stellt Helligkeit und Kontrast ein.",
   "Trois coupes se croisent au réticule. Déplacez-le avec le bouton gauche ; la molette passe à la coupe suivante, "
   "le bouton droit règle luminosité et contraste."},
  {"What counts as skin", "Was als Haut zählt", "Ce qui compte comme peau"},
  {"v_iso is the grey value of the skin's border; α suppresses what is far from it, β smooths along the surface, γ "
   "strengthens edges. Move one: slices (key 2) and volume follow at once.",
   "v_iso ist der Grauwert der Hautgrenze; α unterdrückt, was weit davon ist, β glättet entlang der Oberfläche, γ "
   "stärkt Kanten. Bewegen Sie einen Regler: Schnittbilder (Taste 2) und Volumen folgen sofort.",
   "v_iso est le gris de la limite de la peau ; α supprime ce qui en est loin, β lisse le long de la surface, γ "
   "renforce les bords. Déplacez un curseur : coupes (touche 2) et volume suivent aussitôt."},
  {"From voxels to a surface", "Von Voxeln zur Oberfläche", "Des voxels à la surface"},
  {"This button, or Ctrl+Enter, fits a smooth surface through what was found. From then on it follows the "
   "parameters; Escape stops it.",
   "Diese Schaltfläche, oder Strg+Eingabe, passt eine glatte Oberfläche an das Gefundene an. Von da an folgt sie "
   "den Parametern; Esc hält sie an.",
   "Ce bouton, ou Ctrl+Entrée, ajuste une surface lisse à ce qui a été trouvé. Elle suit ensuite les paramètres ; "
   "Échap l’arrête."},
  {"Skin and light", "Haut und Licht", "Peau et lumière"},
  {"The surface is shown as skin. Drag the lamp, the small disc, to move the light; drag beside it to turn the "
   "view, R looks at the face again.",
   "Die Oberfläche wird als Haut gezeigt. Ziehen Sie die Lampe, die kleine Scheibe, um das Licht zu bewegen; Ziehen "
   "daneben dreht die Ansicht, R blickt wieder auf das Gesicht.",
   "La surface est montrée comme peau. Déplacez la lampe, le petit disque, pour bouger la lumière ; glissez à côté "
   "pour tourner la vue, R revient face au visage."},
  {"Keep it", "Behalten", "Conserver"},
  {"The mesh (Ctrl+S), a picture (F12), volumes and the recipe are saved here. Ctrl+K finds every command by its "
   "name, H shows mouse and keys.",
   "Netz (Strg+S), Bild (F12), Volumen und Rezept werden hier gespeichert. Strg+K findet jeden Befehl nach Namen, H "
   "zeigt Maus und Tasten.",
   "Le maillage (Ctrl+S), une image (F12), les volumes et la recette s’enregistrent ici. Ctrl+K trouve chaque "
   "commande par son nom, H montre souris et touches."},
};
// clang-format on

}  // namespace

std::span<const Text> helpTexts() { return kTexts; }

}  // namespace sonoskin
