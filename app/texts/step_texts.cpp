// Steps, their states, and the history of what was done.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"What is open, and how it was recorded.",
   "Was geöffnet ist, und wie es aufgenommen wurde.",
   "Ce qui est ouvert, et comment il a été acquis."},
  {"The part of the volume that may become surface.",
   "Der Teil des Volumens, der Oberfläche werden darf.",
   "La partie du volume qui peut devenir surface."},
  {"Finds surfaces in the noise.", "Findet Oberflächen im Rauschen.", "Trouve les surfaces dans le bruit."},
  {"Fits a smooth surface to what was found.",
   "Passt eine glatte Oberfläche an das Gefundene an.",
   "Ajuste une surface lisse à ce qui a été trouvé."},
  {"What the surface looks like as skin.",
   "Wie die Oberfläche als Haut aussieht.",
   "L’aspect de la surface en tant que peau."},
  {"Surfaces, pictures and volumes for others.",
   "Oberflächen, Bilder und Volumen für andere.",
   "Surfaces, images et volumes pour d’autres."},
  {"not yet", "noch nicht", "pas encore"},
  {"working", "rechnet", "en calcul"},
  {"ready", "fertig", "prêt"},
  {"live", "vorläufig", "provisoire"},
  {"stale", "veraltet", "périmé"},
  {"stopped", "angehalten", "arrêté"},
  {"failed", "fehlgeschlagen", "échec"},
  {"whole volume", "ganzes Volumen", "volume entier"},
  {"{:.1f} % left", "{:.1f} % übrig", "reste {:.1f} %"},
  {"iso-value {:.2f}", "Isowert {:.2f}", "isovaleur {:.2f}"},
  {"full quality", "volle Qualität", "qualité pleine"},
  {"light quality", "leichte Qualität", "qualité légère"},
  {"not saved yet", "nicht gespeichert", "non enregistré"},
  {"saved", "gespeichert", "enregistré"},
  {"{:.0f} min left", "noch {:.0f} min", "encore {:.0f} min"},
  {"{:.0f} s left", "noch {:.0f} s", "encore {:.0f} s"},
  {"Waiting for a volume", "Warten auf ein Volumen", "En attente d’un volume"},
  {"Opening", "Öffnen", "Ouverture"},
  {"Working", "Rechnet", "Calcul en cours"},
  {"Saving", "Speichern", "Enregistrement"},
  {"Stopped; press Continue", "Angehalten; bitte Fortsetzen", "Arrêté ; cliquez Continuer"},
  {"Failed", "Fehlgeschlagen", "Échec"},
  {"No surface yet", "Noch keine Oberfläche", "Pas encore de surface"},
  {"Surface older than the parameters", "Parameter neuer als Oberfläche", "Paramètres plus récents"},
  {"Live, not yet final", "Vorläufig, noch nicht fertig", "Provisoire, pas définitif"},
  {"Up to date", "Aktuell", "À jour"},
  {"Nothing is erased any more", "Nichts mehr radiert", "Plus rien n’est gommé"},
  {"Erased {} voxels", "{} Voxel radiert", "{} voxels gommés"},
  {"Brought {} voxels back", "{} Voxel zurückgeholt", "{} voxels rétablis"},
  {"Part split", "Teil geteilt", "Partie divisée"},
  {"Part taken away", "Teil entfernt", "Partie retirée"},
  {"Part brought back", "Teil zurückgeholt", "Partie rétablie"},
  {"Parts chosen", "Teile gewählt", "Parties choisies"},
  {"Time step {} → {}", "Zeitschritt {} → {}", "Pas de temps {} → {}"},
  {"Preset {}", "Vorgabe {}", "Préréglage {}"},
  {"{} and {} more", "{} und {} weitere", "{} et {} autres"},
  {"As it was opened", "Wie geöffnet", "À l’ouverture"},
  {"window {:.{}f}   level {:.{}f}", "Breite {:.{}f}   Lage {:.{}f}", "largeur {:.{}f}   centre {:.{}f}"},
  {"simulated scan", "simulierte Aufnahme", "acquisition simulée"},
  {"volume", "Volumen", "volume"},
  {"{}: mark moved", "{}: Marke bewegt", "{} : marque déplacée"},
  {"All marks deleted", "Alle Marken gelöscht", "Toutes les marques supprimées"},
  {"{} deleted", "{} gelöscht", "Suppression : {}"},
  {"Clip plane off", "Clip-Ebene aus", "Plan d’écrêtage désactivé"},
  {"Clip plane moved", "Clip-Ebene verschoben", "Plan d’écrêtage déplacé"},
  {"Clip plane: the other side", "Clip-Ebene: andere Seite", "Plan d’écrêtage : l’autre côté"},
  {"Clip plane turned", "Clip-Ebene gedreht", "Plan d’écrêtage tourné"},
  {"Colours edited", "Farben bearbeitet", "Couleurs modifiées"},
  {"Colours as they were", "Farben wie zuvor", "Couleurs d’origine"},
  {"Colours: {}", "Farben: {}", "Couleurs : {}"},
};
// clang-format on

}  // namespace

std::span<const Text> stepTexts() { return kTexts; }

}  // namespace sonoskin
