<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>PhotoView</name>
    <message>
        <source>Remove this outline point</source>
        <translation>Diesen Umrisspunkt entfernen</translation>
    </message>
    <message>
        <source>Use the proposal for %1 again</source>
        <translation>Vorschlag für %1 wieder verwenden</translation>
    </message>
    <message>
        <source>Add an outline point here</source>
        <translation>Hier einen Umrisspunkt hinzufügen</translation>
    </message>
</context>
<context>
    <name>Preview</name>
    <message>
        <source>The clone in three dimensions</source>
        <translation>Der Klon in drei Dimensionen</translation>
    </message>
    <message>
        <source>Press Clone: after about a minute the person stands here.</source>
        <translation>Klonen drücken: nach etwa einer Minute steht die Person hier.</translation>
    </message>
    <message>
        <source>This machine cannot draw in 3-D</source>
        <translation>Dieser Rechner kann nicht in 3-D zeichnen</translation>
    </message>
</context>
<context>
    <name>SmallPhoto</name>
    <message numerus="yes">
        <source>%n doubtful point(s)</source>
        <translation>
            <numerusform>%n zweifelhafter Punkt</numerusform>
            <numerusform>%n zweifelhafte Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>no points yet</source>
        <translation>noch keine Punkte</translation>
    </message>
</context>
<context>
    <name>clone</name>
    <message>
        <source>Clone</source>
        <extracomment>Stages that the five parts of the work end with, in order; between them the operator sees which part is under way.</extracomment>
        <translation>Klonen</translation>
    </message>
    <message>
        <source>Clone first.</source>
        <translation>Erst klonen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>Haare</translation>
    </message>
    <message>
        <source>Texture and files</source>
        <translation>Textur und Dateien</translation>
    </message>
    <message>
        <source>Press Clone: after about a minute the person stands here.</source>
        <translation>Klonen drücken: nach etwa einer Minute steht die Person hier.</translation>
    </message>
</context>
<context>
    <name>consent</name>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept for the time named at the booth. I can have everything deleted at any time.</source>
        <extracomment>What visitors agree to, unless the event has a text of its own.</extracomment>
        <translation>Ich bin einverstanden, dass hier Fotos von mir aufgenommen werden, dass daraus auf diesem Rechner ein dreidimensionales Abbild von mir entsteht und dass beides für die am Stand genannte Zeit aufbewahrt wird. Ich kann jederzeit alles löschen lassen.</translation>
    </message>
</context>
<context>
    <name>formats</name>
    <message>
        <source>GLB: games, web, telephone</source>
        <translation>GLB: Spiele, Web, Telefon</translation>
    </message>
    <message>
        <source>VRML97: H-Anim players</source>
        <translation>VRML97: H-Anim-Programme</translation>
    </message>
    <message>
        <source>X3D: H-Anim with one skin</source>
        <translation>X3D: H-Anim mit einer Haut</translation>
    </message>
    <message>
        <source>VRM: virtual meeting places</source>
        <translation>VRM: virtuelle Treffpunkte</translation>
    </message>
    <message>
        <source>OBJ: any 3-D program</source>
        <translation>OBJ: jedes 3-D-Programm</translation>
    </message>
    <message>
        <source>PLY: 3-D printing</source>
        <translation>PLY: 3-D-Druck</translation>
    </message>
</context>
<context>
    <name>hints</name>
    <message>
        <source>Your own point on the outline: drag it on to the border of the person.</source>
        <translation>Ihr eigener Umrisspunkt: auf den Rand der Person ziehen.</translation>
    </message>
    <message>
        <source>Highest point of the skull: under the hair, not on top of it.</source>
        <translation>Höchster Punkt des Schädels: unter dem Haar, nicht darauf.</translation>
    </message>
    <message>
        <source>Lowest edge of the shoe or foot: it sets the height of the person.</source>
        <translation>Unterste Kante von Schuh oder Fuß: sie bestimmt die Größe der Person.</translation>
    </message>
    <message>
        <source>Foremost point of the shoe or foot.</source>
        <translation>Vorderster Punkt von Schuh oder Fuß.</translation>
    </message>
    <message>
        <source>Hindmost point of the shoe or foot.</source>
        <translation>Hinterster Punkt von Schuh oder Fuß.</translation>
    </message>
    <message>
        <source>Outline at the narrowest place of the trunk.</source>
        <translation>Umriss an der schmalsten Stelle des Rumpfes.</translation>
    </message>
    <message>
        <source>Outline at the widest place of the hips.</source>
        <translation>Umriss an der breitesten Stelle der Hüften.</translation>
    </message>
    <message>
        <source>Outline of the leg at the middle of the kneecap.</source>
        <translation>Umriss des Beins auf Höhe der Kniescheibenmitte.</translation>
    </message>
    <message>
        <source>Outline of the leg at its narrowest place above the foot.</source>
        <translation>Umriss des Beins an der schmalsten Stelle über dem Fuß.</translation>
    </message>
    <message>
        <source>Outline of the lower leg where the calf is thickest.</source>
        <translation>Umriss des Unterschenkels, wo die Wade am dicksten ist.</translation>
    </message>
    <message>
        <source>Outline of the arm at the bend of the elbow.</source>
        <translation>Umriss des Arms an der Ellenbeuge.</translation>
    </message>
    <message>
        <source>Outline of the arm at its narrowest place before the hand.</source>
        <translation>Umriss des Arms an der schmalsten Stelle vor der Hand.</translation>
    </message>
    <message>
        <source>Outline where the shoulder turns down into the arm.</source>
        <translation>Umriss, wo die Schulter in den Arm übergeht.</translation>
    </message>
    <message>
        <source>Outline where the neck turns into the shoulder.</source>
        <translation>Umriss, wo der Hals in die Schulter übergeht.</translation>
    </message>
    <message>
        <source>Outline of the neck at half its height.</source>
        <translation>Umriss des Halses auf halber Höhe.</translation>
    </message>
    <message>
        <source>Where the arm meets the trunk: the end of the gap between them.</source>
        <translation>Wo der Arm auf den Rumpf trifft: das Ende der Lücke dazwischen.</translation>
    </message>
    <message>
        <source>Where the legs meet: the top of the gap between them.</source>
        <translation>Wo sich die Beine treffen: das obere Ende der Lücke dazwischen.</translation>
    </message>
    <message>
        <source>Foremost outline of the chest.</source>
        <translation>Vorderster Umriss der Brust.</translation>
    </message>
    <message>
        <source>Foremost outline of the belly.</source>
        <translation>Vorderster Umriss des Bauchs.</translation>
    </message>
    <message>
        <source>Hindmost outline of the upper back.</source>
        <translation>Hinterster Umriss des oberen Rückens.</translation>
    </message>
    <message>
        <source>Hindmost outline of the seat.</source>
        <translation>Hinterster Umriss des Gesäßes.</translation>
    </message>
    <message>
        <source>Outline of the thigh at half its length.</source>
        <translation>Umriss des Oberschenkels auf halber Länge.</translation>
    </message>
    <message>
        <source>Middle of the joint inside the limb: where it bends, not on the outline.</source>
        <translation>Mitte des Gelenks im Inneren: wo es sich beugt, nicht am Umriss.</translation>
    </message>
    <message>
        <source>Middle of the pupil.</source>
        <translation>Mitte der Pupille.</translation>
    </message>
    <message>
        <source>Corner of the eye towards the nose.</source>
        <translation>Augenwinkel zur Nase hin.</translation>
    </message>
    <message>
        <source>Corner of the eye towards the ear.</source>
        <translation>Augenwinkel zum Ohr hin.</translation>
    </message>
    <message>
        <source>Edge of the upper lid, above the pupil.</source>
        <translation>Kante des Oberlids, über der Pupille.</translation>
    </message>
    <message>
        <source>Edge of the lower lid, below the pupil.</source>
        <translation>Kante des Unterlids, unter der Pupille.</translation>
    </message>
    <message>
        <source>Corner of the closed mouth.</source>
        <translation>Winkel des geschlossenen Mundes.</translation>
    </message>
    <message>
        <source>Upper edge of the upper lip, in the middle.</source>
        <translation>Oberkante der Oberlippe, in der Mitte.</translation>
    </message>
    <message>
        <source>Lower edge of the lower lip, in the middle.</source>
        <translation>Unterkante der Unterlippe, in der Mitte.</translation>
    </message>
    <message>
        <source>Middle of the line between the closed lips.</source>
        <translation>Mitte der Linie zwischen den geschlossenen Lippen.</translation>
    </message>
    <message>
        <source>Outermost point of the wing of the nose.</source>
        <translation>Äußerster Punkt des Nasenflügels.</translation>
    </message>
    <message>
        <source>Tip of the nose; in the side photo its foremost point.</source>
        <translation>Nasenspitze; im Seitenfoto ihr vorderster Punkt.</translation>
    </message>
    <message>
        <source>Deepest place of the root of the nose, between the eyes.</source>
        <translation>Tiefste Stelle der Nasenwurzel, zwischen den Augen.</translation>
    </message>
    <message>
        <source>Foremost place of the forehead between the brows.</source>
        <translation>Vorderste Stelle der Stirn zwischen den Brauen.</translation>
    </message>
    <message>
        <source>Where the nose meets the upper lip, in the middle.</source>
        <translation>Wo die Nase auf die Oberlippe trifft, in der Mitte.</translation>
    </message>
    <message>
        <source>Foremost point of the chin.</source>
        <translation>Vorderster Punkt des Kinns.</translation>
    </message>
    <message>
        <source>Lowest point of the chin.</source>
        <translation>Tiefster Punkt des Kinns.</translation>
    </message>
    <message>
        <source>Where the hair begins above the forehead.</source>
        <translation>Wo über der Stirn das Haar beginnt.</translation>
    </message>
    <message>
        <source>Highest point of the ear.</source>
        <translation>Höchster Punkt des Ohrs.</translation>
    </message>
    <message>
        <source>Lowest point of the earlobe.</source>
        <translation>Tiefster Punkt des Ohrläppchens.</translation>
    </message>
    <message>
        <source>Hindmost point of the ear.</source>
        <translation>Hinterster Punkt des Ohrs.</translation>
    </message>
    <message>
        <source>Point of the ear farthest from the head.</source>
        <translation>Punkt des Ohrs, der am weitesten vom Kopf absteht.</translation>
    </message>
    <message>
        <source>Drag a point to its place, or press Tab: the least sure point comes first.</source>
        <translation>Einen Punkt an seinen Platz ziehen oder Tab drücken: der unsicherste kommt zuerst.</translation>
    </message>
    <message>
        <source>%1 % sure</source>
        <translation>%1 % sicher</translation>
    </message>
    <message>
        <source>placed by you</source>
        <translation>von Ihnen gesetzt</translation>
    </message>
    <message>
        <source>outline point</source>
        <translation>Umrisspunkt</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>outline in the photo</source>
        <translation>Umriss im Foto</translation>
    </message>
    <message>
        <source>outline of the clone</source>
        <translation>Umriss des Klons</translation>
    </message>
</context>
<context>
    <name>menu</name>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;New visitor</source>
        <translation>&amp;Neuer Besucher</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Effort…</source>
        <translation>&amp;Aufwand…</translation>
    </message>
    <message>
        <source>&amp;What is held…</source>
        <translation>&amp;Was gespeichert ist…</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>High &amp;contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>&amp;Textgröße</translation>
    </message>
    <message>
        <source>&amp;Big buttons</source>
        <translation>&amp;Große Knöpfe</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>&amp;Veranstaltung</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>O&amp;perator</source>
        <translation>B&amp;ediener</translation>
    </message>
</context>
<context>
    <name>photos</name>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Add the photos first.</source>
        <translation>Erst die Fotos hinzufügen.</translation>
    </message>
    <message>
        <source>&amp;Add photos…</source>
        <translation>Fotos &amp;hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Camera folder: {name}</source>
        <translation>Kameraordner: {name}</translation>
    </message>
    <message>
        <source>&amp;Camera folder…</source>
        <translation>&amp;Kameraordner…</translation>
    </message>
    <message>
        <source>&amp;Webcam…</source>
        <translation>&amp;Webcam…</translation>
    </message>
    <message>
        <source>Photos that appear in this folder are taken at once</source>
        <translation>Fotos, die in diesem Ordner erscheinen, werden sofort übernommen</translation>
    </message>
    <message>
        <source>Photos without a place</source>
        <translation>Fotos ohne Platz</translation>
    </message>
    <message>
        <source>Being looked at…</source>
        <translation>Wird angesehen…</translation>
    </message>
    <message>
        <source>✓ Good</source>
        <translation>✓ Gut</translation>
    </message>
    <message>
        <source>No consent is recorded: new photos are not stored.</source>
        <translation>Keine Einwilligung vermerkt: neue Fotos werden nicht gespeichert.</translation>
    </message>
    <message>
        <source>Looking at photos: {n} to go</source>
        <translation>Fotos werden angesehen: noch {n}</translation>
    </message>
    <message>
        <source>Photos of the visitor</source>
        <translation>Fotos des Besuchers</translation>
    </message>
    <message>
        <source>Folder where the camera drops its photos</source>
        <translation>Ordner, in den die Kamera ihre Fotos legt</translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation>Foto hier ablegen</translation>
    </message>
    <message>
        <source>What to do with {photo}</source>
        <translation>Was mit {photo} tun</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Ersetzen…</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Exchange with</source>
        <translation>Tauschen mit</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Nach rechts drehen</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Use as…</source>
        <translation>Verwenden als…</translation>
    </message>
    <message>
        <source>Photo {n} without a place</source>
        <translation>Foto {n} ohne Platz</translation>
    </message>
    <message>
        <source>All five photos are here.</source>
        <translation>Alle fünf Fotos sind da.</translation>
    </message>
    <message>
        <source>No photos yet.</source>
        <translation>Noch keine Fotos.</translation>
    </message>
    <message>
        <source>A front photo is needed. Missing: {names}.</source>
        <translation>Ein Foto von vorn wird gebraucht. Es fehlt: {names}.</translation>
    </message>
    <message>
        <source>Only the head can be cloned, on a body of matching build. Missing: {names}.</source>
        <translation>Nur der Kopf kann geklont werden, auf einem passenden Körper. Es fehlt: {names}.</translation>
    </message>
    <message>
        <source>The face will come from the body photos and be coarse. Missing: {names}.</source>
        <translation>Das Gesicht kommt aus den Körperfotos und wird grob. Es fehlt: {names}.</translation>
    </message>
    <message>
        <source>The clone will be less exact. Missing: {names}.</source>
        <translation>Der Klon wird weniger genau. Es fehlt: {names}.</translation>
    </message>
</context>
<context>
    <name>points</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Add photos first.</source>
        <translation>Erst Fotos hinzufügen.</translation>
    </message>
    <message>
        <source>Find points</source>
        <translation>Punkte suchen</translation>
    </message>
    <message>
        <source>◀</source>
        <translation>◀</translation>
    </message>
    <message>
        <source>Point before (Shift+Tab)</source>
        <translation>Punkt davor (Umschalt+Tab)</translation>
    </message>
    <message>
        <source>Next doubtful point</source>
        <translation>Nächster zweifelhafter Punkt</translation>
    </message>
    <message>
        <source>Least sure first (Tab)</source>
        <translation>Der unsicherste zuerst (Tab)</translation>
    </message>
    <message>
        <source>Back to proposal</source>
        <translation>Zurück zum Vorschlag</translation>
    </message>
    <message>
        <source>Undo this point (Delete)</source>
        <translation>Diesen Punkt zurücknehmen (Entf)</translation>
    </message>
    <message>
        <source>Add outline point</source>
        <translation>Umrisspunkt hinzufügen</translation>
    </message>
    <message>
        <source>Or pull at it (Insert)</source>
        <translation>Oder daran ziehen (Einfg)</translation>
    </message>
    <message>
        <source>Whole photo</source>
        <translation>Ganzes Foto</translation>
    </message>
    <message>
        <source>Show all of the photo (Home)</source>
        <translation>Das ganze Foto zeigen (Pos1)</translation>
    </message>
    <message>
        <source>Tab: next point. Arrows: 1 pixel, with Shift 10. Wheel or + and −: zoom. Home: all.</source>
        <translation>Tab: nächster Punkt. Pfeile: 1 Pixel, mit Umschalt 10. Rad oder + und −: Zoom. Pos1: alles.</translation>
    </message>
    <message>
        <source>After the first clone, the person here follows your hand.</source>
        <translation>Nach dem ersten Klon folgt die Person hier Ihrer Hand.</translation>
    </message>
    <message>
        <source>The body follows; hair and textures will when you clone again.</source>
        <translation>Der Körper folgt; Haare und Texturen beim nächsten Klonen.</translation>
    </message>
    <message>
        <source>Clone again: this changes more than is shown.</source>
        <translation>Noch einmal klonen: das ändert mehr, als gezeigt wird.</translation>
    </message>
</context>
<context>
    <name>preview</name>
    <message>
        <source>Photo texture</source>
        <translation>Fototextur</translation>
    </message>
    <message>
        <source>Shape alone</source>
        <translation>Nur die Form</translation>
    </message>
    <message>
        <source>Wire mesh</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Distance from the outlines</source>
        <translation>Abstand von den Umrissen</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Stehen</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Atmen</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Blinzeln</translation>
    </message>
    <message>
        <source>Smile</source>
        <translation>Lächeln</translation>
    </message>
    <message>
        <source>Talk</source>
        <translation>Sprechen</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Over</source>
        <translation>Ü&amp;ber</translation>
    </message>
    <message>
        <source>Co&amp;ver</source>
        <translation>&amp;Deckung</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>Be&amp;wegen</translation>
    </message>
    <message>
        <source>Whole person</source>
        <translation>Ganze Person</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Gesicht</translation>
    </message>
    <message>
        <source>no photo</source>
        <translation>kein Foto</translation>
    </message>
    <message>
        <source>between the clone&apos;s and the photos&apos; outlines</source>
        <translation>zwischen den Umrissen von Klon und Fotos</translation>
    </message>
</context>
<context>
    <name>privacy</name>
    <message>
        <source>Delete {names} with all photos, points and clones?</source>
        <translation>{names} mit allen Fotos, Punkten und Klonen löschen?</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Nothing of it can be brought back. Files on sticks stay.</source>
        <translation>Nichts davon lässt sich zurückholen. Dateien auf Sticks bleiben.</translation>
    </message>
    <message>
        <source>Delete for good</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>Save everything held of {name}</source>
        <translation>Alles zu {name} Gespeicherte sichern</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Was gespeichert ist</translation>
    </message>
    <message>
        <source>What is held, by visitor</source>
        <translation>Was gespeichert ist, nach Besucher</translation>
    </message>
    <message>
        <source>&amp;Save everything held…</source>
        <translation>Alles Gespeicherte &amp;sichern…</translation>
    </message>
    <message>
        <source>&amp;Delete the marked visitors…</source>
        <translation>Markierte Besucher &amp;löschen…</translation>
    </message>
    <message>
        <source>{n} visitors, {size} MB; nothing leaves this computer</source>
        <translation>{n} Besucher, {size} MB; nichts verlässt diesen Rechner</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Besucher</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>Last change</source>
        <translation>Letzte Änderung</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht vermerkt</translation>
    </message>
</context>
<context>
    <name>queue</name>
    <message>
        <source>Stop cloning {name}</source>
        <translation>Klonen von {name} abbrechen</translation>
    </message>
    <message>
        <source>Progress of {name}</source>
        <translation>Fortschritt von {name}</translation>
    </message>
    <message>
        <source>, {n} more wait</source>
        <translation>, {n} weitere warten</translation>
    </message>
    <message>
        <source>{name}: {step}, {left}</source>
        <translation>{name}: {step}, {left}</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>This event</source>
        <translation>Diese Veranstaltung</translation>
    </message>
    <message>
        <source>kept until deleted</source>
        <translation>bis zum Löschen aufbewahrt</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>Days that visitors are kept</source>
        <translation>Tage, die Besucher aufbewahrt werden</translation>
    </message>
    <message>
        <source>What visitors agree to</source>
        <translation>Worin Besucher einwilligen</translation>
    </message>
    <message>
        <source>&amp;Keep visitors for</source>
        <translation>Besucher &amp;aufbewahren</translation>
    </message>
    <message>
        <source>&amp;Consent</source>
        <translation>&amp;Einwilligung</translation>
    </message>
</context>
<context>
    <name>states</name>
    <message>
        <source>in progress</source>
        <translation>in Arbeit</translation>
    </message>
    <message>
        <source>waiting for the clone</source>
        <translation>wartet auf den Klon</translation>
    </message>
    <message>
        <source>cloned</source>
        <translation>geklont</translation>
    </message>
    <message>
        <source>not cloned: look at the photos</source>
        <translation>nicht geklont: Fotos ansehen</translation>
    </message>
</context>
<context>
    <name>statistics</name>
    <message>
        <source>Operator&apos;s effort</source>
        <translation>Aufwand des Bedieners</translation>
    </message>
    <message>
        <source>Effort by visitor</source>
        <translation>Aufwand je Besucher</translation>
    </message>
    <message>
        <source>&amp;Save as table…</source>
        <translation>Als Tabelle &amp;sichern…</translation>
    </message>
    <message>
        <source>{n} visitors; in the middle {s} s, {c} clicks, {d} drags each</source>
        <translation>{n} Besucher; im Mittel je {s} s, {c} Klicks, {d} Züge</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Sichern als</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Besucher</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Kam</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Klicks</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>Züge</translation>
    </message>
    <message>
        <source>Clone, s</source>
        <translation>Klon, s</translation>
    </message>
</context>
<context>
    <name>steps</name>
    <message>
        <source>Looking at the photo</source>
        <extracomment>What the progress bar says for a step&apos;s name.</extracomment>
        <translation>Foto wird angesehen</translation>
    </message>
    <message>
        <source>Reading the photos</source>
        <translation>Fotos werden gelesen</translation>
    </message>
    <message>
        <source>Finding the person in the photos</source>
        <translation>Person wird in den Fotos gesucht</translation>
    </message>
    <message>
        <source>Placing feature points</source>
        <translation>Merkmalspunkte werden gesetzt</translation>
    </message>
    <message>
        <source>Placing the cameras</source>
        <translation>Kameras werden aufgestellt</translation>
    </message>
    <message>
        <source>Drawing outlines</source>
        <translation>Umrisse werden gezeichnet</translation>
    </message>
    <message>
        <source>Choosing the nearest build and pose</source>
        <translation>Nächste Statur und Haltung werden gewählt</translation>
    </message>
    <message>
        <source>Fitting the skeleton</source>
        <translation>Skelett wird angepasst</translation>
    </message>
    <message>
        <source>Fitting the body</source>
        <translation>Körper wird angepasst</translation>
    </message>
    <message>
        <source>Fitting the outlines</source>
        <translation>Umrisse werden angepasst</translation>
    </message>
    <message>
        <source>Fitting the head</source>
        <translation>Kopf wird angepasst</translation>
    </message>
    <message>
        <source>Joining head and body</source>
        <translation>Kopf und Körper werden verbunden</translation>
    </message>
    <message>
        <source>Following corrected points</source>
        <translation>Korrigierten Punkten wird gefolgt</translation>
    </message>
    <message>
        <source>Measuring the body</source>
        <translation>Körper wird vermessen</translation>
    </message>
    <message>
        <source>Growing the hair</source>
        <translation>Haare wachsen</translation>
    </message>
    <message>
        <source>Painting skin and clothes</source>
        <translation>Haut und Kleidung werden gemalt</translation>
    </message>
    <message>
        <source>Telling skin from clothes</source>
        <translation>Haut und Kleidung werden unterschieden</translation>
    </message>
    <message>
        <source>Writing the files</source>
        <translation>Dateien werden geschrieben</translation>
    </message>
    <message>
        <source>Drawing previews</source>
        <translation>Vorschauen werden gezeichnet</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>takeaway</name>
    <message>
        <source>Writing the files…</source>
        <translation>Dateien werden geschrieben…</translation>
    </message>
    <message>
        <source>Written: {place}</source>
        <translation>Geschrieben: {place}</translation>
    </message>
    <message>
        <source>Choose what the visitor takes home.</source>
        <translation>Wählen, was der Besucher mitnimmt.</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Mitnehmen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Code to scan</source>
        <translation>Code zum Scannen</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Was gespeichert ist</translation>
    </message>
    <message>
        <source>Copy to &amp;stick or folder…</source>
        <translation>Auf &amp;Stick oder in Ordner kopieren…</translation>
    </message>
    <message>
        <source>Save as one &amp;zip file…</source>
        <translation>Als eine &amp;Zip-Datei sichern…</translation>
    </message>
    <message>
        <source>Show &amp;report</source>
        <translation>&amp;Bericht zeigen</translation>
    </message>
    <message>
        <source>Show f&amp;older</source>
        <translation>&amp;Ordner zeigen</translation>
    </message>
    <message>
        <source>Save &amp;everything held…</source>
        <translation>&amp;Alles Gespeicherte sichern…</translation>
    </message>
    <message>
        <source>&amp;Delete this visitor…</source>
        <translation>Diesen Besucher &amp;löschen…</translation>
    </message>
    <message>
        <source>Text or address in the code; {id} stands for the visitor</source>
        <translation>Text oder Adresse im Code; {id} steht für den Besucher</translation>
    </message>
    <message>
        <source>Text of the code</source>
        <translation>Text des Codes</translation>
    </message>
    <message>
        <source>Where the files were put</source>
        <translation>Wohin die Dateien kamen</translation>
    </message>
    <message>
        <source>There is no clone yet.</source>
        <translation>Noch gibt es keinen Klon.</translation>
    </message>
    <message>
        <source>No consent is recorded.</source>
        <translation>Keine Einwilligung vermerkt.</translation>
    </message>
    <message>
        <source>Consent: {when}.</source>
        <translation>Einwilligung: {when}.</translation>
    </message>
    <message>
        <source>Kept for {n} days.</source>
        <translation>{n} Tage aufbewahrt.</translation>
    </message>
    <message>
        <source>Kept.</source>
        <translation>Aufbewahrt.</translation>
    </message>
    <message>
        <source>Copy the files first, or type an address.</source>
        <translation>Erst die Dateien kopieren oder eine Adresse eingeben.</translation>
    </message>
    <message>
        <source>Stick or folder for the visitor&apos;s files</source>
        <translation>Stick oder Ordner für die Dateien des Besuchers</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Sichern als</translation>
    </message>
</context>
<context>
    <name>time</name>
    <message>
        <source>a few seconds</source>
        <translation>ein paar Sekunden</translation>
    </message>
    <message>
        <source>about {n} s</source>
        <translation>etwa {n} s</translation>
    </message>
    <message>
        <source>about {n} min</source>
        <translation>etwa {n} min</translation>
    </message>
</context>
<context>
    <name>troubles</name>
    <message>
        <source>Nobody was found: take it again with the person in full view.</source>
        <extracomment>One sentence each: what is wrong with a photo and what to do, for an operator with the visitor still there.</extracomment>
        <translation>Niemand gefunden: noch einmal, mit der ganzen Person im Bild.</translation>
    </message>
    <message>
        <source>More than one person: take it again with one person alone.</source>
        <translation>Mehr als eine Person: noch einmal, mit einer Person allein.</translation>
    </message>
    <message>
        <source>It shows none of the five views: turn the person or retake.</source>
        <translation>Zeigt keine der fünf Ansichten: Person drehen oder wiederholen.</translation>
    </message>
    <message>
        <source>It does not show this view: exchange or retake it.</source>
        <translation>Zeigt nicht diese Ansicht: tauschen oder wiederholen.</translation>
    </message>
    <message>
        <source>The person is cut off: step back and retake.</source>
        <translation>Die Person ist abgeschnitten: zurücktreten und wiederholen.</translation>
    </message>
    <message>
        <source>The person is small: step nearer or zoom in.</source>
        <translation>Die Person ist klein: näher treten oder zoomen.</translation>
    </message>
    <message>
        <source>It is blurred: hold still, focus and retake.</source>
        <translation>Unscharf: ruhig halten, scharf stellen, wiederholen.</translation>
    </message>
    <message>
        <source>It is dark: add light or expose longer.</source>
        <translation>Zu dunkel: mehr Licht oder länger belichten.</translation>
    </message>
    <message>
        <source>It is burnt out: less light or a shorter exposure.</source>
        <translation>Überbelichtet: weniger Licht oder kürzer belichten.</translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>Body, front</source>
        <extracomment>``translate(&quot;page&quot;, &quot;Text&quot;)``: Qt&apos;s own tools find these calls and write them into the translators&apos; files.</extracomment>
        <translation>Körper, vorn</translation>
    </message>
    <message>
        <source>Body, side</source>
        <translation>Körper, Seite</translation>
    </message>
    <message>
        <source>Body, back</source>
        <translation>Körper, hinten</translation>
    </message>
    <message>
        <source>Face, front</source>
        <translation>Gesicht, vorn</translation>
    </message>
    <message>
        <source>Face, side</source>
        <translation>Gesicht, Seite</translation>
    </message>
</context>
<context>
    <name>visitor</name>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>Height is known</source>
        <translation>Größe ist bekannt</translation>
    </message>
    <message>
        <source>Height in centimetres</source>
        <translation>Größe in Zentimetern</translation>
    </message>
    <message>
        <source>Height, feet</source>
        <translation>Größe, Fuß</translation>
    </message>
    <message>
        <source>Height, inches</source>
        <translation>Größe, Zoll</translation>
    </message>
    <message>
        <source>Unit of the height</source>
        <translation>Einheit der Größe</translation>
    </message>
    <message>
        <source>The visitor has to agree before photos are taken.</source>
        <translation>Vor den Fotos muss der Besucher einwilligen.</translation>
    </message>
    <message>
        <source>N&amp;ame or number</source>
        <translation>N&amp;ame oder Nummer</translation>
    </message>
    <message>
        <source>&amp;Height without shoes</source>
        <translation>&amp;Größe ohne Schuhe</translation>
    </message>
    <message>
        <source>&amp;Language of the consent</source>
        <translation>&amp;Sprache der Einwilligung</translation>
    </message>
    <message>
        <source>The visitor has read this and &amp;agrees</source>
        <translation>Der Besucher hat das gelesen und &amp;willigt ein</translation>
    </message>
    <message>
        <source>Name or number of the visitor</source>
        <translation>Name oder Nummer des Besuchers</translation>
    </message>
    <message>
        <source>Language of the consent</source>
        <translation>Sprache der Einwilligung</translation>
    </message>
    <message>
        <source>The visitor agrees</source>
        <translation>Der Besucher willigt ein</translation>
    </message>
    <message>
        <source>Unknown: {n} cm is assumed, and every length is unscaled.</source>
        <translation>Unbekannt: {n} cm werden angenommen, alle Längen sind ohne Maßstab.</translation>
    </message>
    <message>
        <source>Recorded: {text}</source>
        <translation>Vermerkt: {text}</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Besucher</translation>
    </message>
    <message>
        <source>Begin with a visitor first.</source>
        <translation>Erst mit einem Besucher beginnen.</translation>
    </message>
    <message>
        <source>Visitors</source>
        <translation>Besucher</translation>
    </message>
    <message>
        <source>&amp;New visitor</source>
        <translation>&amp;Neuer Besucher</translation>
    </message>
    <message>
        <source>&amp;Open event…</source>
        <translation>Veranstaltung ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Visitors of this event</source>
        <translation>Besucher dieser Veranstaltung</translation>
    </message>
    <message>
        <source>No event is open.</source>
        <translation>Keine Veranstaltung ist offen.</translation>
    </message>
    <message>
        <source>Open the event&apos;s folder; an empty one begins a new event.</source>
        <translation>Den Ordner der Veranstaltung öffnen; ein leerer beginnt eine neue.</translation>
    </message>
    <message>
        <source>Press New visitor when somebody steps up.</source>
        <translation>Neuer Besucher drücken, wenn jemand herantritt.</translation>
    </message>
</context>
<context>
    <name>webcam</name>
    <message>
        <source>Webcam</source>
        <extracomment>Half of a person with the arms a hand&apos;s breadth away from the body: shares of the height (taste).</extracomment>
        <translation>Webcam</translation>
    </message>
    <message>
        <source>&amp;Take the photo</source>
        <translation>Foto &amp;aufnehmen</translation>
    </message>
    <message>
        <source>T&amp;urn the picture</source>
        <translation>Bild &amp;drehen</translation>
    </message>
    <message>
        <source>Fill the outline, and keep all of it in the picture.</source>
        <translation>Den Umriss füllen und ganz im Bild halten.</translation>
    </message>
    <message>
        <source>Which photo is taken</source>
        <translation>Welches Foto aufgenommen wird</translation>
    </message>
    <message>
        <source>Live picture</source>
        <translation>Livebild</translation>
    </message>
</context>
<context>
    <name>window</name>
    <message>
        <source>Folder of the event, or of one visitor</source>
        <extracomment>Names under which a visit&apos;s file remembers the page.</extracomment>
        <translation>Ordner der Veranstaltung oder eines Besuchers</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Ne&amp;xt visitor</source>
        <translation>Nächster B&amp;esucher</translation>
    </message>
    <message>
        <source>Ne&amp;xt</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Step {n}: {title}</source>
        <translation>Schritt {n}: {title}</translation>
    </message>
</context>
</TS>
