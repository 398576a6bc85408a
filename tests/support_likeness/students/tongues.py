"""Words of several languages: for names of places and for what people write behind a `;`."""

from typing import NamedTuple


class Tongue(NamedTuple):
    """What somebody says, by what it is about; several ways for each."""

    things: dict[str, tuple[str, ...]]  # of names
    says: dict[str, tuple[str, ...]]  # of comments; `{}` is the thing


def _words(text: str) -> dict[str, tuple[str, ...]]:
    whole = text.strip().replace("|\n", "|")  # a line may go on below
    rows = (line.partition(":") for line in whole.split("\n"))
    return {key.strip(): tuple(word.strip() for word in rest.split("|")) for key, _, rest in rows}


ENGLISH = Tongue(
    _words("""
can: can|tin|c|part|obj|cyl
base: base|b|block|dest|target|spot
dish: dish|bowl|plate|di
pizza: pizza|pz|pie|pan
oven: oven|stove|ov
stand: stand|rack|holder|st
grip: grip|pick|get|take|grab|src
put: put|place|drop|set|goal|to
corner: corner|via|wp|turn|c|edge
gap: gap|pass|hole|door|g
door: door|entry|front|mouth
in: inside|in_oven|above|in
safe: safe|home|park|neutral|rest|up|start_pos|wait_pos|hover
carry: carry|transfer|movecan|pickplace|bring|haul|do_can|handle
pick: pick|grab|fetch|getit|pickup|take
place: place|putdown|drop|release|setdown
main: main|main|main|task|start|go
init: init|setup|prepare|defs|locations|teach
from: from|src|pick|start|a|start_loc
to: to|goal|dest|b|finish|tgt
count: i|n|k|cnt|num|j
height: h|high|dist|app|z|clear
"""),
    _words("""
head: Robot programming lab|exercise for week 4|my solution|pick and place program|
    assignment, version 2|final version|made with a lot of coffee|program for the PUMA|
    lab report attached|VAL-II exercise
part: {}|now the {}|move the {}|{} goes to its place|next: {}|then {}|---- {} ----|
    here comes the {}|handle {}
above: go above it|approach|approach from the top|above the {}|hover first|
    come near, not too fast|get over the part|stay above
down: down|straight down|go to it|lower the hand|slowly down|now carefully|touch height
grip: grip|close the gripper|take it|got it|close hand|hold the {}|wait until closed
up: up again|lift|lift it|straight up|get away from the table|raise so nothing is hit|
    high enough to clear
over: above the goal|go to the base|over the target|approach the target|over there
put: put it down|down on the base|set down|slow because of the fragile stuff|place it
open: let go|open|open the gripper|release it|drop it|open hand
away: go away|back up|retreat|up and away|leave it alone
safe: safe position|home|go home|in between|away from everything|so that nothing collides
fast: fast|full speed|hurry up|speed for the free moves|as quick as possible
slow: slow|careful here|reduced speed|gentle|slow near the object
start: open gripper first|hand is closed at the start|make sure the hand is open|init
loop: for every can|loop over all cans|repeat|one after another
done: done|finished|all done|the end|ready|task complete|that's it
"""),
)
GERMAN = Tongue(
    _words("""
can: dose|d|buechse|teil|objekt|zyl
base: sockel|basis|podest|ziel|s|platz
dish: schale|teller|schuessel|sch
pizza: pizza|pz|blech|fladen
oven: ofen|herd|of
stand: staender|gestell|halter|st
grip: griff|greif|nehmen|hol|auf|von
put: ab|ablage|setz|stell|nach|weg
corner: ecke|zwischen|wp|punkt|e|via
gap: luecke|spalt|durch|l|tor
door: tuer|vor|eingang|davor
in: innen|drin|ueber|im_ofen
safe: sicher|oben|grund|ruhe|start|park|neutral|mitte|warte
carry: transport|trage|umsetzen|bringe|versetze|handhaben|bewegen
pick: greifen|hole|nimm|aufnehmen|packen
place: ablegen|stelle|lege|absetzen|loslassen
main: main|main|haupt|start|programm|aufgabe
init: init|punkte|vorber|setup|anfang|definiere
from: quelle|von|start|a|auf|p_von
to: ziel|nach|ende|b|ab|p_nach
count: i|n|k|nr|z|zaehler
height: h|hoehe|abst|z|dist|an
"""),
    _words("""
head: Robotik Praktikum|Uebung 4|Aufgabe 1|Abgabe Gruppe|Programm fuer PUMA|Loesung|
    Hausuebung Robotik|Version 3, laeuft|RT Labor
part: {}|jetzt {}|{} umsetzen|zuerst die {}|und nun {}|--- {} ---|dann {}|{} transportieren
above: ueber die {}|anfahren|darueber fahren|Anfahrt von oben|erst mal drueber|Annaeherung
down: runter|gerade runter|hinfahren|senkrecht nach unten|langsam absenken|vorsichtig!
grip: greifen|Greifer zu|zupacken|Hand schliessen|{} nehmen|warten bis zu
up: hoch|anheben|nach oben|wieder hoch|weg vom Tisch|hoch genug, sonst Kollision
over: ueber das Ziel|zum Sockel|Ziel anfahren|drueber
put: absetzen|runter auf den Sockel|abstellen|langsam weil sonst kippt
open: loslassen|Greifer auf|Hand auf|oeffnen|und los
away: weg|wieder hoch|zurueckziehen|nach oben weg
safe: sichere Position|Grundstellung|Zwischenpunkt|weg von allem|nach Hause
fast: schnell|volle Geschwindigkeit|Eilgang|Tempo
slow: langsam|vorsichtig|reduziert|Feinfahrt
start: Greifer oeffnen|Hand ist am Anfang zu|auf machen|Initialisierung
loop: fuer alle Dosen|Schleife|alle der Reihe nach|wiederholen
done: fertig|Ende|geschafft|alles erledigt|Schluss
"""),
)
DUTCH = Tongue(
    _words("""
can: blik|bl|bus|deel|voorwerp|cil
base: voet|basis|blok|doel|plek|v
dish: schaal|bord|kom|sch
pizza: pizza|pz|plaat|pan
oven: oven|ov|kachel
stand: standaard|rek|houder|st
grip: pak|grijp|neem|haal|op|van
put: zet|leg|neer|plaats|naar|los
corner: hoek|tussen|punt|via|h|bocht
gap: gat|opening|door|g|spleet
door: deur|voor|ingang
in: binnen|boven|erin|in_ov
safe: veilig|rust|thuis|begin|midden|hoog|parkeer
carry: verplaats|breng|draag|verzet|transport|doe_blik
pick: pak|oppakken|grijp|haal|neem
place: zet|neerzetten|leg|loslaten|plaats
main: main|main|hoofd|start|opdracht
init: init|punten|begin|posities|instel
from: van|bron|begin|a|oppak
to: naar|doel|eind|b|neerzet
count: i|n|k|nr|teller|t
height: h|hoogte|afst|z|boven
"""),
    _words("""
head: Practicum robotica|opdracht 2|mijn oplossing|programma voor de robot|versie 2|
    werkt eindelijk|inleveropgave
part: {}|nu {}|{} verplaatsen|eerst {}|daarna {}|== {} ==|en dan de {}
above: boven het {}|ernaartoe|naderen|erboven gaan hangen|van boven
down: naar beneden|recht omlaag|zakken|rustig omlaag
grip: pakken|grijper dicht|vastpakken|hand sluiten|{} vast
up: omhoog|optillen|weer omhoog|van de tafel af|hoog genoeg
over: boven het doel|naar de voet|erboven|doel naderen
put: neerzetten|zakken op de voet|voorzichtig neer
open: loslaten|grijper open|hand open|laat los
away: weg|weer omhoog|terug|wegwezen
safe: veilige plek|naar huis|tussenpunt|ruststand
fast: snel|volle snelheid|gas erop
slow: langzaam|voorzichtig|rustig aan
start: grijper eerst open|hand is dicht bij start|openen
loop: voor elk blik|lus|allemaal na elkaar|herhaal
done: klaar|einde|gelukt|alles staat goed
"""),
)
FRENCH = Tongue(
    _words("""
can: boite|bte|b|piece|obj|cyl
base: socle|base|cible|s|bloc
dish: plat|assiette|bol|pl
pizza: pizza|pz|tarte
oven: four|fr
stand: support|pied|sup
grip: prise|prend|pris|saisie|de
put: pose|depot|depose|vers|but
corner: coin|via|pt|angle|inter
gap: trou|passage|fente|porte
door: porte|entree|devant
in: dedans|dessus|interieur
safe: repos|maison|haut|securite|depart|neutre|attente
carry: transfert|porter|deplacer|amener|transport
pick: prendre|saisir|prise|attraper
place: poser|deposer|lacher|pose
main: main|main|principal|debut
init: init|points|prepa|reglage
from: source|de|depart|a|orig
to: but|vers|arrivee|b|dest
count: i|n|k|num|cpt
height: h|haut|dist|z|appr
"""),
    _words("""
head: TP robotique|exercice 3|ma solution|programme PUMA|compte rendu joint|binome 7
part: {}|maintenant {}|deplacer {}|d'abord {}|puis {}|** {} **
above: au dessus|approche|approche par le haut|venir au dessus de {}
down: descendre|descente droite|doucement|en bas
grip: prendre|fermer la pince|serrer|saisir {}
up: remonter|lever|monter tout droit|degager
over: au dessus du but|vers le socle|approche du but
put: poser|descendre sur le socle|poser doucement
open: lacher|ouvrir la pince|ouvrir
away: partir|remonter|reculer
safe: position de repos|retour|point intermediaire
fast: vite|vitesse max|rapide
slow: lentement|attention|vitesse reduite
start: ouvrir d'abord|pince fermee au debut
loop: pour chaque boite|boucle|repeter
done: fini|termine|fin du programme
"""),
)
POLISH = Tongue(
    _words("""
can: puszka|p|pusz|czesc|el
base: podst|cel|klocek|baza
dish: talerz|miska|t
pizza: pizza|pz|placek
oven: piec|pc
stand: stojak|podp|st
grip: chwyt|wez|bierz|z
put: odloz|poloz|cel|do
corner: rog|posr|pkt|via
gap: szpara|przejscie|luka
door: drzwi|przed|wejscie
in: srodek|nad|wew
safe: bezp|dom|gora|spocz|start
carry: przenies|transport|niesc|rusz
pick: chwyc|wez|podnies|pobierz
place: odloz|postaw|pusc|poloz
main: main|main|glowny|start
init: init|punkty|ustaw
from: skad|od|pocz|a
to: dokad|do|kon|b
count: i|n|k|nr|licz
height: h|wys|odl|z
"""),
    _words("""
head: Laboratorium robotyki|cwiczenie 2|moje rozwiazanie|program PUMA|zadanie
part: {}|teraz {}|przenies {}|najpierw {}|potem {}
above: nad {}|dojazd|podejscie z gory
down: w dol|prosto w dol|powoli w dol
grip: chwyc|zamknij chwytak|lap {}
up: w gore|podnies|do gory prosto
over: nad cel|nad podstawe|dojazd do celu
put: odloz|postaw|powoli postaw
open: pusc|otworz chwytak|otworz
away: odjazd|w gore|cofnij
safe: pozycja bezpieczna|do domu|punkt posredni
fast: szybko|pelna predkosc
slow: powoli|ostroznie
start: otworz chwytak na poczatku
loop: dla kazdej puszki|petla|powtarzaj
done: koniec|gotowe|zrobione
"""),
)
TONGUES = (ENGLISH, GERMAN, DUTCH, FRENCH, POLISH)
SHARES = (42, 30, 14, 8, 6)  # of authors, in percent
