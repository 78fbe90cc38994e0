// Files: dialogs and questions.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"Unsaved work", "Nicht gespeicherte Arbeit", "Travail non enregistré"},
  {"{} loses what is not saved: changes of parameters and marks, what was erased, or the surface. A session keeps "
   "all of it.",
   "{} verwirft, was nicht gespeichert ist: Änderungen an Parametern und Marken, Radiertes oder die Oberfläche. "
   "Eine Sitzung bewahrt alles.",
   "{} fait perdre ce qui n’est pas enregistré : modifications des paramètres et marques, zones gommées ou surface. "
   "Une session garde tout."},
  {"The session's volume", "Das Volumen der Sitzung", "Le volume de la session"},
  {"{}. Choose the file, please.", "{}. Bitte wählen Sie die Datei.", "{}. Choisissez le fichier, s’il vous plaît."},
  {"Choose...", "Wählen …", "Choisir…"},
  {"Several files", "Mehrere Dateien", "Plusieurs fichiers"},
  {"The window opens one file at a time; which one?",
   "Das Fenster öffnet eine Datei auf einmal; welche?",
   "La fenêtre ouvre un fichier à la fois ; lequel ?"},
  {"The first", "Die erste", "Le premier"},
  {"Sonoskin ended unexpectedly. Restore what was open ({})?",
   "Sonoskin wurde unerwartet beendet. Wiederherstellen, was offen war ({})?",
   "Sonoskin s’est arrêté de façon inattendue. Restaurer ce qui était ouvert ({}) ?"},
  {"Ask later", "Später fragen", "Plus tard"},
  {"The file has {} bytes, as many as that.",
   "Die Datei hat {} Bytes, genau so viele.",
   "Le fichier a {} octets, exactement autant."},
  {"The file has {} bytes; that is {:.0f}.",
   "Die Datei hat {} Bytes; das sind {:.0f}.",
   "Le fichier a {} octets ; cela en fait {:.0f}."},
  {"What the file holds", "Was die Datei enthält", "Contenu du fichier"},
  {"{} has no header; what is in it?", "{} hat keinen Vorspann; was ist darin?", "{} n’a pas d’en-tête ; que contient-il ?"},
  {"Choose a volume", "Ein Volumen wählen", "Choisir un volume"},
  {"There are {} volumes; which one is to be opened?",
   "Es gibt {} Volumen; welches soll geöffnet werden?",
   "Il y a {} volumes ; lequel ouvrir ?"},
  {"Home", "Persönlicher Ordner", "Dossier personnel"},
  {"Desktop", "Schreibtisch", "Bureau"},
  {"Documents", "Dokumente", "Documents"},
  {"Downloads", "Downloads", "Téléchargements"},
  {"Computer", "Computer", "Ordinateur"},
  {"Up one folder", "Ordner höher", "Dossier parent"},
  {"Nothing to choose here", "Hier gibt es nichts zu wählen", "Rien à choisir ici"},
  {"File name", "Dateiname", "Nom du fichier"},
  {"All files", "Alle Dateien", "Tous les fichiers"},
  {"Open volume or session", "Volumen oder Sitzung öffnen", "Ouvrir un volume ou une session"},
  {"Choose the session's volume", "Das Volumen der Sitzung wählen", "Choisir le volume de la session"},
  {"Open session", "Sitzung öffnen", "Ouvrir une session"},
  {"Open erased parts", "Radierte Bereiche öffnen", "Ouvrir les zones gommées"},
  {"Save erased parts", "Radierte Bereiche speichern", "Enregistrer les zones gommées"},
  {"Open recipe", "Rezept öffnen", "Ouvrir une recette"},
  {"Save recipe", "Rezept speichern", "Enregistrer la recette"},
  {"Save mesh", "Netz speichern", "Enregistrer le maillage"},
  {"Save a mesh of each time step", "Netz jedes Zeitschritts speichern", "Enregistrer un maillage par pas de temps"},
  {"Save for printing", "Für den 3D-Druck speichern", "Enregistrer pour l’impression 3D"},
  {"Save scan for other programs",
   "Aufnahme für andere Programme speichern",
   "Enregistrer l’acquisition pour d’autres logiciels"},
  {"Save classified volume", "Klassifiziertes Volumen speichern", "Enregistrer le volume classifié"},
  {"Save surface with skin", "Oberfläche mit Haut speichern", "Enregistrer la surface avec peau"},
  {"Save surface with skin and light",
   "Oberfläche mit Haut und Licht speichern",
   "Enregistrer la surface avec peau et lumière"},
  {"Save picture of the 3D view", "Bild der 3D-Ansicht speichern", "Enregistrer une image de la vue 3D"},
  {"Save messages", "Meldungen speichern", "Enregistrer les messages"},
  {"Save turntable of the 3D view", "Rundumansicht speichern", "Enregistrer une rotation de la vue 3D"},
  {"This folder cannot be read: {}", "Dieser Ordner ist nicht lesbar: {}", "Ce dossier ne peut pas être lu : {}"},
  {"{} is there already; press Replace to write over it.",
   "{} ist schon vorhanden; „Ersetzen“ überschreibt die Datei.",
   "{} existe déjà ; « Remplacer » l’écrase."},
  {"{} more files", "{} weitere Dateien", "{} autres fichiers"},
  {"{} and {} are there already; press Replace to write over them.",
   "{} und {} sind schon vorhanden; „Ersetzen“ überschreibt sie.",
   "{} et {} existent déjà ; « Remplacer » les écrase."},
  {"Choose a file or type its name.",
   "Wählen Sie eine Datei oder geben Sie ihren Namen ein.",
   "Choisissez un fichier ou saisissez son nom."},
  {"There is no file of that name here; choose one of the list.",
   "Hier gibt es keine Datei dieses Namens; wählen Sie eine aus der Liste.",
   "Aucun fichier de ce nom ici ; choisissez-en un dans la liste."},
  {"Saved {}", "Gespeichert: {}", "Enregistré : {}"},
};
// clang-format on

}  // namespace

std::span<const Text> fileTexts() { return kTexts; }

}  // namespace sonoskin
