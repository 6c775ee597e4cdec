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
    <name>blobs</name>
    <message>
        <source>belly</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brustkorb</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>pelvis</source>
        <translation>Becken</translation>
    </message>
    <message>
        <source>chest, across</source>
        <translation>Brustkorb, quer</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>Schultern</translation>
    </message>
    <message>
        <source>buttock</source>
        <translation>Gesäß</translation>
    </message>
    <message>
        <source>breast</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>shoulder&apos;s muscle</source>
        <translation>Schultermuskel</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>Oberschenkel</translation>
    </message>
    <message>
        <source>lower leg</source>
        <translation>Unterschenkel</translation>
    </message>
    <message>
        <source>calf</source>
        <translation>Wade</translation>
    </message>
    <message>
        <source>kneecap</source>
        <translation>Kniescheibe</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>Unterarm</translation>
    </message>
</context>
<context>
    <name>clone</name>
    <message>
        <source>Clone</source>
        <translation>Klonen</translation>
    </message>
    <message>
        <source>Clone first.</source>
        <translation>Erst klonen.</translation>
    </message>
    <message>
        <source>The clone is being made; the next visitor can come.</source>
        <extracomment>Stages that the five parts of the work end with, in order; between them the operator sees which part is under way.</extracomment>
        <translation>Der Klon entsteht; der nächste Besucher kann kommen.</translation>
    </message>
    <message>
        <source>Sho&amp;w it off</source>
        <translation>&amp;Vorführen</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>The clone be&amp;fore</source>
        <translation>Klon da&amp;vor</translation>
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
    <message>
        <source>C&amp;lone again</source>
        <translation>Noch einmal k&amp;lonen</translation>
    </message>
    <message>
        <source>C&amp;lone</source>
        <translation>K&amp;lonen</translation>
    </message>
    <message>
        <source>Points or height were changed since: what is seen and taken away is the clone before.</source>
        <translation>Punkte oder Größe wurden seither geändert: gezeigt und mitgenommen wird der Klon von vorher.</translation>
    </message>
</context>
<context>
    <name>consent</name>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept for {days} days and then deleted. I can have everything deleted at any time.</source>
        <extracomment>What visitors agree to, unless the event has a text of its own.</extracomment>
        <translation>Ich bin einverstanden, dass hier Fotos von mir gemacht werden, dass daraus auf diesem Rechner ein dreidimensionales Abbild entsteht und dass beides {days} Tage aufbewahrt und dann gelöscht wird. Ich kann jederzeit alles löschen lassen.</translation>
    </message>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept until I have them deleted. I can have everything deleted at any time.</source>
        <extracomment>The same where an event keeps its visitors until somebody deletes them.</extracomment>
        <translation>Ich bin einverstanden, dass hier Fotos von mir gemacht werden, dass daraus auf diesem Rechner ein dreidimensionales Abbild entsteht und dass beides aufbewahrt wird, bis ich es löschen lasse. Ich kann jederzeit alles löschen lassen.</translation>
    </message>
</context>
<context>
    <name>day</name>
    <message>
        <source>{day}: {n} visitors, {m} clones.</source>
        <translation>{day}: {n} Besucher, {m} Klone.</translation>
    </message>
    <message>
        <source>{n} of them lie in the trash.</source>
        <translation>{n} davon liegen im Papierkorb.</translation>
    </message>
    <message>
        <source>In the queue {m} minutes in the middle, {l} at most.</source>
        <translation>In der Schlange in der Mitte {m} Minuten, höchstens {l}.</translation>
    </message>
    <message>
        <source>Refused: {reasons}.</source>
        <translation>Zurückgewiesen: {reasons}.</translation>
    </message>
</context>
<context>
    <name>fabrics</name>
    <message>
        <source>Silk</source>
        <translation>Seide</translation>
    </message>
    <message>
        <source>Cotton</source>
        <translation>Baumwolle</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>Leinen</translation>
    </message>
    <message>
        <source>Wool</source>
        <translation>Wolle</translation>
    </message>
    <message>
        <source>Denim</source>
        <translation>Jeansstoff</translation>
    </message>
    <message>
        <source>Burlap</source>
        <translation>Sackleinen</translation>
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
    <name>gallery</name>
    <message>
        <source>Everybody of today</source>
        <extracomment>What is shown: everybody, the cloned, those without a clone, who lies in the trash.</extracomment>
        <translation>Alle von heute</translation>
    </message>
    <message>
        <source>Name or number</source>
        <translation>Name oder Nummer</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>with a clone</source>
        <translation>mit Klon</translation>
    </message>
    <message>
        <source>without a clone</source>
        <translation>ohne Klon</translation>
    </message>
    <message>
        <source>in the trash</source>
        <translation>im Papierkorb</translation>
    </message>
    <message>
        <source>Search by name or number</source>
        <translation>Nach Name oder Nummer suchen</translation>
    </message>
    <message>
        <source>Who is shown</source>
        <translation>Wer gezeigt wird</translation>
    </message>
    <message>
        <source>Visitors of this event</source>
        <translation>Besucher dieser Veranstaltung</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Clone &amp;again</source>
        <translation>Noch ein&amp;mal klonen</translation>
    </message>
    <message>
        <source>The clone be&amp;fore</source>
        <translation>Klon da&amp;vor</translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation>&amp;Wegwerfen</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>&amp;Zurückholen</translation>
    </message>
    <message>
        <source>&amp;Delete for good…</source>
        <translation>Endgültig &amp;löschen…</translation>
    </message>
    <message>
        <source>Save the &amp;numbers of the days…</source>
        <translation>&amp;Zahlen der Tage sichern…</translation>
    </message>
    <message>
        <source>{n} visitors, {m} with a clone</source>
        <translation>{n} Besucher, {m} mit Klon</translation>
    </message>
    <message>
        <source>deleted for good on {when}</source>
        <translation>endgültig gelöscht am {when}</translation>
    </message>
</context>
<context>
    <name>garments</name>
    <message>
        <source>Skirt</source>
        <translation>Rock</translation>
    </message>
    <message>
        <source>Circle skirt</source>
        <translation>Tellerrock</translation>
    </message>
    <message>
        <source>Straight skirt</source>
        <translation>Gerader Rock</translation>
    </message>
    <message>
        <source>Long skirt</source>
        <translation>Langer Rock</translation>
    </message>
    <message>
        <source>Cape</source>
        <translation>Umhang</translation>
    </message>
    <message>
        <source>T-shirt</source>
        <translation>T-Shirt</translation>
    </message>
    <message>
        <source>Dress</source>
        <translation>Kleid</translation>
    </message>
    <message>
        <source>Coat</source>
        <translation>Mantel</translation>
    </message>
    <message>
        <source>Trousers</source>
        <translation>Hose</translation>
    </message>
    <message>
        <source>GLB: the clone walks in it</source>
        <extracomment>What a dressed clone is written as, by file ending; a folder has none.</extracomment>
        <translation>GLB: der Klon geht darin</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4-Film</translation>
    </message>
    <message>
        <source>WebP film</source>
        <translation>WebP-Film</translation>
    </message>
    <message>
        <source>GIF film</source>
        <translation>GIF-Film</translation>
    </message>
    <message>
        <source>USD: the garment alone</source>
        <translation>USD: das Kleidungsstück allein</translation>
    </message>
    <message>
        <source>PC2 and OBJ: the garment alone</source>
        <translation>PC2 und OBJ: das Kleidungsstück allein</translation>
    </message>
    <message>
        <source>Folder: a clone in it, whose cloth flows in crowds</source>
        <translation>Ordner: ein Klon darin, dessen Stoff in Mengen fließt</translation>
    </message>
</context>
<context>
    <name>hints</name>
    <message>
        <source>Your own point on the outline: drag it on to the border of the person.</source>
        <extracomment>Hint for every point whose name, without its side, begins so; the longest beginning wins.</extracomment>
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
    <name>keepsakes</name>
    <message>
        <source>Card and e-mail</source>
        <translation>Karte und E-Mail</translation>
    </message>
    <message>
        <source>Pr&amp;int the card…</source>
        <translation>Karte dr&amp;ucken…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the card as a file…</source>
        <translation>Karte als Datei sp&amp;eichern…</translation>
    </message>
    <message>
        <source>E-&amp;mail as a draft…</source>
        <translation>E-&amp;Mail als Entwurf…</translation>
    </message>
    <message>
        <source>The card as it will be printed</source>
        <translation>Die Karte, wie sie gedruckt wird</translation>
    </message>
    <message>
        <source>Your files: {folder}</source>
        <translation>Ihre Dateien: {folder}</translation>
    </message>
    <message>
        <source>Scan to see yourself turn and to take your files home.</source>
        <translation>Scannen: Sie sehen sich von allen Seiten und nehmen Ihre Dateien mit.</translation>
    </message>
</context>
<context>
    <name>kiosk</name>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Number of the operator</source>
        <translation>Nummer des Bedieners</translation>
    </message>
    <message>
        <source>Too many wrong numbers: wait half a minute.</source>
        <translation>Zu viele falsche Nummern: warten Sie eine halbe Minute.</translation>
    </message>
    <message>
        <source>This is not the number.</source>
        <translation>Das ist nicht die Nummer.</translation>
    </message>
    <message>
        <source>Give the operator a number under Event, Settings first.</source>
        <translation>Geben Sie dem Bediener zuerst unter Veranstaltung, Einstellungen eine Nummer.</translation>
    </message>
</context>
<context>
    <name>licences</name>
    <message>
        <source>the visitor alone</source>
        <extracomment>Who may use a visitor&apos;s files, by licence; and what that means.</extracomment>
        <translation>der Besucher allein</translation>
    </message>
    <message>
        <source>visitor and event</source>
        <translation>Besucher und Veranstaltung</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Nobody else may use the files or earn money with them.</source>
        <translation>Niemand sonst darf die Dateien benutzen oder damit Geld verdienen.</translation>
    </message>
    <message>
        <source>The event may use the files too, also in its advertising.</source>
        <translation>Auch die Veranstaltung darf die Dateien benutzen, auch in ihrer Werbung.</translation>
    </message>
    <message>
        <source>Everybody may use the files, change them and pass them on, but not earn money with them.</source>
        <translation>Alle dürfen die Dateien benutzen, verändern und weitergeben, aber kein Geld damit verdienen.</translation>
    </message>
</context>
<context>
    <name>mail</name>
    <message>
        <source>Your clone</source>
        <translation>Ihr Klon</translation>
    </message>
    <message>
        <source>Your clone from {event}</source>
        <translation>Ihr Klon von {event}</translation>
    </message>
    <message>
        <source>Hello,</source>
        <translation>Guten Tag,</translation>
    </message>
    <message>
        <source>Hello {name},</source>
        <translation>Guten Tag {name},</translation>
    </message>
    <message>
        <source>this is the clone that was made of your photos. Its picture is attached.</source>
        <translation>dies ist der Klon, der aus Ihren Fotos entstanden ist. Sein Bild ist angehängt.</translation>
    </message>
    <message>
        <source>As long as you are on the booth&apos;s network you can see it turn and take the files here:</source>
        <translation>Solange Sie im Netz des Standes sind, sehen Sie ihn hier von allen Seiten und holen die Dateien ab:</translation>
    </message>
    <message>
        <source>If you want everything that is held of you deleted, answer this message or tell us.</source>
        <translation>Wenn alles gelöscht werden soll, was von Ihnen gespeichert ist, antworten Sie auf diese Nachricht oder sagen Sie es uns.</translation>
    </message>
    <message>
        <source>Thank you for your visit.</source>
        <translation>Danke für Ihren Besuch.</translation>
    </message>
</context>
<context>
    <name>materials</name>
    <message>
        <source>Stone</source>
        <translation>Stein</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronze</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Marmor</translation>
    </message>
    <message>
        <source>As photographed</source>
        <translation>Wie fotografiert</translation>
    </message>
    <message>
        <source>Arms hanging</source>
        <translation>Arme hängend</translation>
    </message>
    <message>
        <source>On guard</source>
        <translation>Auf Wache</translation>
    </message>
    <message>
        <source>Hailing</source>
        <translation>Grüßend</translation>
    </message>
</context>
<context>
    <name>measures</name>
    <message>
        <source>Height without shoes</source>
        <extracomment>What the sliders tell, in the order of the form; the stature and the measures of `cloner.bodies.telling.PRESETS`.</extracomment>
        <translation>Größe ohne Schuhe</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>Waist</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Hips</source>
        <translation>Hüfte</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Below the breast</source>
        <translation>Unterbrust</translation>
    </message>
    <message>
        <source>Thigh</source>
        <translation>Oberschenkel</translation>
    </message>
    <message>
        <source>Inside leg</source>
        <translation>Schrittlänge</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
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
        <source>&amp;Kiosk (Ctrl+Shift+K)</source>
        <translation>&amp;Kiosk (Strg+Umschalt+K)</translation>
    </message>
    <message>
        <source>&amp;Gallery…</source>
        <translation>&amp;Galerie…</translation>
    </message>
    <message>
        <source>&amp;Screen for visitors</source>
        <translation>&amp;Bildschirm für Besucher</translation>
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
        <source>&amp;Dress a clone…</source>
        <translation>Einen Klon &amp;anziehen…</translation>
    </message>
    <message>
        <source>&amp;Body from measures…</source>
        <translation>&amp;Körper nach Maßen…</translation>
    </message>
    <message>
        <source>&amp;Clone in stone…</source>
        <translation>Klon in &amp;Stein…</translation>
    </message>
    <message>
        <source>&amp;Photograph on a statue…</source>
        <translation>&amp;Fotografie auf einer Statue…</translation>
    </message>
    <message>
        <source>Body of b&amp;lobs…</source>
        <translation>Körper aus &amp;Blobs…</translation>
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
    <message>
        <source>&amp;Studio</source>
        <translation>&amp;Studio</translation>
    </message>
</context>
<context>
    <name>names</name>
    <message>
        <source>inner corner of the eye</source>
        <extracomment>Names without their sides.</extracomment>
        <translation>innerer Augenwinkel</translation>
    </message>
    <message>
        <source>outer corner of the eye</source>
        <translation>äußerer Augenwinkel</translation>
    </message>
    <message>
        <source>upper lid</source>
        <translation>Oberlid</translation>
    </message>
    <message>
        <source>lower lid</source>
        <translation>Unterlid</translation>
    </message>
    <message>
        <source>corner of the mouth</source>
        <translation>Mundwinkel</translation>
    </message>
    <message>
        <source>wing of the nose</source>
        <translation>Nasenflügel</translation>
    </message>
    <message>
        <source>pupil</source>
        <translation>Pupille</translation>
    </message>
    <message>
        <source>top of the ear</source>
        <translation>oberster Punkt des Ohrs</translation>
    </message>
    <message>
        <source>earlobe</source>
        <translation>Ohrläppchen</translation>
    </message>
    <message>
        <source>outermost point of the ear</source>
        <translation>äußerster Punkt des Ohrs</translation>
    </message>
    <message>
        <source>back of the ear</source>
        <translation>hinterster Punkt des Ohrs</translation>
    </message>
    <message>
        <source>root of the nose</source>
        <translation>Nasenwurzel</translation>
    </message>
    <message>
        <source>forehead between the brows</source>
        <translation>Stirn zwischen den Brauen</translation>
    </message>
    <message>
        <source>tip of the nose</source>
        <translation>Nasenspitze</translation>
    </message>
    <message>
        <source>base of the nose</source>
        <translation>Nasenansatz über der Lippe</translation>
    </message>
    <message>
        <source>upper lip</source>
        <translation>Oberlippe</translation>
    </message>
    <message>
        <source>middle of the mouth</source>
        <translation>Mundmitte</translation>
    </message>
    <message>
        <source>lower lip</source>
        <translation>Unterlippe</translation>
    </message>
    <message>
        <source>front of the chin</source>
        <translation>vorderster Punkt des Kinns</translation>
    </message>
    <message>
        <source>bottom of the chin</source>
        <translation>unterster Punkt des Kinns</translation>
    </message>
    <message>
        <source>hairline</source>
        <translation>Haaransatz</translation>
    </message>
    <message>
        <source>top of the head</source>
        <translation>Scheitel</translation>
    </message>
    <message>
        <source>toe</source>
        <translation>Zehenspitze</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>waist, front</source>
        <translation>Taille, vorn</translation>
    </message>
    <message>
        <source>waist, back</source>
        <translation>Taille, hinten</translation>
    </message>
    <message>
        <source>hip</source>
        <translation>Hüfte</translation>
    </message>
    <message>
        <source>hip joint</source>
        <translation>Hüftgelenk</translation>
    </message>
    <message>
        <source>outside of the knee</source>
        <translation>Knie außen</translation>
    </message>
    <message>
        <source>inside of the knee</source>
        <translation>Knie innen</translation>
    </message>
    <message>
        <source>front of the knee</source>
        <translation>Knie vorn</translation>
    </message>
    <message>
        <source>back of the knee</source>
        <translation>Kniekehle</translation>
    </message>
    <message>
        <source>knee joint</source>
        <translation>Kniegelenk</translation>
    </message>
    <message>
        <source>outside of the ankle</source>
        <translation>Knöchel außen</translation>
    </message>
    <message>
        <source>inside of the ankle</source>
        <translation>Knöchel innen</translation>
    </message>
    <message>
        <source>front of the ankle</source>
        <translation>Knöchel vorn</translation>
    </message>
    <message>
        <source>back of the ankle</source>
        <translation>Knöchel hinten</translation>
    </message>
    <message>
        <source>ankle joint</source>
        <translation>Fußgelenk</translation>
    </message>
    <message>
        <source>outside of the elbow</source>
        <translation>Ellbogen außen</translation>
    </message>
    <message>
        <source>inside of the elbow</source>
        <translation>Ellbogen innen</translation>
    </message>
    <message>
        <source>elbow joint</source>
        <translation>Ellbogengelenk</translation>
    </message>
    <message>
        <source>outside of the wrist</source>
        <translation>Handgelenk außen</translation>
    </message>
    <message>
        <source>inside of the wrist</source>
        <translation>Handgelenk innen</translation>
    </message>
    <message>
        <source>wrist joint</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source>end of the shoulder</source>
        <translation>Schulterende</translation>
    </message>
    <message>
        <source>shoulder joint</source>
        <translation>Schultergelenk</translation>
    </message>
    <message>
        <source>bony tip of the shoulder</source>
        <translation>Schulterhöhe</translation>
    </message>
    <message>
        <source>base of the neck</source>
        <translation>Halsansatz</translation>
    </message>
    <message>
        <source>front of the neck</source>
        <translation>Hals vorn</translation>
    </message>
    <message>
        <source>back of the neck</source>
        <translation>Hals hinten</translation>
    </message>
    <message>
        <source>pit of the neck</source>
        <translation>Halsgrube</translation>
    </message>
    <message>
        <source>nape</source>
        <translation>Nacken</translation>
    </message>
    <message>
        <source>armpit</source>
        <translation>Achsel</translation>
    </message>
    <message>
        <source>sole</source>
        <translation>Sohle</translation>
    </message>
    <message>
        <source>heel</source>
        <translation>Ferse</translation>
    </message>
    <message>
        <source>crotch</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>chest, front</source>
        <translation>Brust, vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>Rücken</translation>
    </message>
    <message>
        <source>belly</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>seat</source>
        <translation>Gesäß</translation>
    </message>
    <message>
        <source>front of the thigh</source>
        <translation>Oberschenkel vorn</translation>
    </message>
    <message>
        <source>back of the thigh</source>
        <translation>Oberschenkel hinten</translation>
    </message>
    <message>
        <source>outside of the thigh</source>
        <translation>Oberschenkel außen</translation>
    </message>
    <message>
        <source>inside of the thigh</source>
        <translation>Oberschenkel innen</translation>
    </message>
    <message>
        <source>calf</source>
        <translation>Wade</translation>
    </message>
    <message>
        <source>fingertip</source>
        <translation>Fingerspitze</translation>
    </message>
    <message>
        <source>top of the skull</source>
        <translation>höchster Punkt des Schädels</translation>
    </message>
    <message>
        <source>outline point</source>
        <translation>Umrisspunkt</translation>
    </message>
</context>
<context>
    <name>photos</name>
    <message>
        <source>Photos are still looked at.</source>
        <translation>Fotos werden noch angesehen.</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Add the photos first.</source>
        <extracomment>Points are sought when photos have rested so long, milliseconds: looking at new ones comes first.</extracomment>
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
        <source>Watch no camera folder any more</source>
        <translation>Keinen Kameraordner mehr beobachten</translation>
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
        <source>Return shows or chooses the photo, Space tells what else can be done.</source>
        <translation>Eingabe zeigt oder wählt das Foto, die Leertaste sagt, was sonst noch geht.</translation>
    </message>
    <message>
        <source>See it large</source>
        <translation>Groß ansehen</translation>
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
        <extracomment>The clone&apos;s outline is drawn anew when the hand has rested so long: it costs as much as the preview.</extracomment>
        <translation>Erst Fotos hinzufügen.</translation>
    </message>
    <message>
        <source>{n} doubtful points are left after this one.</source>
        <translation>Nach diesem sind noch {n} Punkte zweifelhaft.</translation>
    </message>
    <message>
        <source>All doubtful points are seen: this one is sure. Press Clone.</source>
        <translation>Alle zweifelhaften Punkte sind gesehen: dieser ist sicher. Drücken Sie Klonen.</translation>
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
    <message>
        <source>moving %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>resetting %1</source>
        <translation>%1 zurücksetzen</translation>
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
        <source>Wave</source>
        <translation>Winken</translation>
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
        <source>Whole pe&amp;rson</source>
        <translation>Ganze Pe&amp;rson</translation>
    </message>
    <message>
        <source>&amp;Face</source>
        <translation>&amp;Gesicht</translation>
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
        <source>Nothing &amp;moves by itself</source>
        <translation>Nichts &amp;bewegt sich von selbst</translation>
    </message>
    <message>
        <source>&amp;Encrypt the page for telephones</source>
        <translation>Seite für Telefone &amp;verschlüsseln</translation>
    </message>
    <message>
        <source>The kiosk &amp;asks for a number</source>
        <translation>Der Kiosk &amp;fragt nach einer Nummer</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>gar nicht</translation>
    </message>
    <message>
        <source> hours</source>
        <translation> Stunden</translation>
    </message>
    <message>
        <source>Each takes a core of this computer and 1 GB of its memory.</source>
        <translation>Jeder braucht einen Kern dieses Rechners und 1 GB seines Speichers.</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>none; for example: museum</source>
        <translation>keine; zum Beispiel: Museum</translation>
    </message>
    <message>
        <source>{days} in the text stands for the days that visitors are kept.</source>
        <translation>{days} im Text steht für die Tage, die Besucher aufbewahrt werden.</translation>
    </message>
    <message>
        <source>&amp;Name of the event</source>
        <translation>&amp;Name der Veranstaltung</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Bring &amp;back thrown away ones for</source>
        <translation>Weggeworfene &amp;zurückholen</translation>
    </message>
    <message>
        <source>&amp;Language of the text</source>
        <translation>&amp;Sprache des Textes</translation>
    </message>
    <message>
        <source>Visitors may let &amp;use the files</source>
        <translation>Besucher dürfen die Dateien &amp;benutzen lassen</translation>
    </message>
    <message>
        <source>Links for &amp;telephones work for</source>
        <translation>Links für &amp;Telefone gelten</translation>
    </message>
    <message>
        <source>&amp;Scene that clones may walk in</source>
        <translation>&amp;Szene, in der Klone gehen dürfen</translation>
    </message>
    <message>
        <source>&amp;Visitors cloned at the same time</source>
        <translation>Gleich&amp;zeitig geklonte Besucher</translation>
    </message>
    <message>
        <source>N&amp;umber of the operator</source>
        <translation>N&amp;ummer des Bedieners</translation>
    </message>
    <message>
        <source>Name of the event</source>
        <translation>Name der Veranstaltung</translation>
    </message>
    <message>
        <source>Days that visitors are kept</source>
        <translation>Tage, die Besucher aufbewahrt werden</translation>
    </message>
    <message>
        <source>Days that thrown away visitors can be brought back</source>
        <translation>Tage, in denen weggeworfene Besucher zurückgeholt werden können</translation>
    </message>
    <message>
        <source>Hours that links for telephones work</source>
        <translation>Stunden, die Links für Telefone gelten</translation>
    </message>
    <message>
        <source>Scene that clones may walk in</source>
        <translation>Szene, in der Klone gehen dürfen</translation>
    </message>
    <message>
        <source>Visitors cloned at the same time</source>
        <translation>Gleichzeitig geklonte Besucher</translation>
    </message>
    <message>
        <source>Language of the text</source>
        <translation>Sprache des Textes</translation>
    </message>
    <message>
        <source>Who visitors may let use the files, at the most</source>
        <translation>Wen Besucher die Dateien höchstens benutzen lassen</translation>
    </message>
    <message>
        <source>Number of the operator</source>
        <translation>Nummer des Bedieners</translation>
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
    <message>
        <source>Choose a &amp;picture…</source>
        <translation>&amp;Bild wählen…</translation>
    </message>
    <message>
        <source>No pictu&amp;re</source>
        <translation>Kein B&amp;ild</translation>
    </message>
    <message>
        <source>Logo of the event</source>
        <translation>Logo der Veranstaltung</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
</context>
<context>
    <name>sides</name>
    <message>
        <source>%1, left</source>
        <translation>%1, links</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, rechts</translation>
    </message>
</context>
<context>
    <name>stage</name>
    <message>
        <source>Everybody of today</source>
        <extracomment>A clone that does not move by itself is seen so long, milliseconds; and so often it is looked for a first one.</extracomment>
        <translation>Alle von heute</translation>
    </message>
    <message>
        <source> and {n} more</source>
        <translation> und {n} weitere</translation>
    </message>
    <message>
        <source>Next: {names}</source>
        <translation>Als Nächste: {names}</translation>
    </message>
    <message>
        <source>Screen for visitors</source>
        <translation>Bildschirm für Besucher</translation>
    </message>
    <message>
        <source>Five photos, one minute: your own clone stands here.</source>
        <translation>Fünf Fotos, eine Minute: hier steht Ihr eigener Klon.</translation>
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
        <source>Copying</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Making the body</source>
        <translation>Der Körper wird gemacht</translation>
    </message>
    <message>
        <source>Cutting the pieces</source>
        <translation>Die Teile werden zugeschnitten</translation>
    </message>
    <message>
        <source>Sewing and hanging</source>
        <translation>Nähen und Hängen</translation>
    </message>
    <message>
        <source>Walking in it</source>
        <translation>Gehen darin</translation>
    </message>
    <message>
        <source>Closing the loop</source>
        <translation>Die Schleife wird geschlossen</translation>
    </message>
    <message>
        <source>Reading back what was written</source>
        <translation>Geschriebenes wird gegengelesen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>stick</name>
    <message>
        <source>Sticks are found by themselves on Linux only: choose the stick&apos;s folder.</source>
        <extracomment>Where Linux tells what is mounted; read again and again, it costs nothing. Only when it changes a program is asked.</extracomment>
        <translation>Sticks werden nur unter Linux von selbst gefunden: Wählen Sie den Ordner des Sticks.</translation>
    </message>
    <message>
        <source>Which stick</source>
        <translation>Welcher Stick</translation>
    </message>
    <message>
        <source>This system does not tell which sticks are plugged in: choose the folder.</source>
        <translation>Dieses System sagt nicht, welche Sticks stecken: Wählen Sie den Ordner.</translation>
    </message>
    <message>
        <source>No stick is plugged in: it is found by itself.</source>
        <translation>Kein Stick steckt: Er wird von selbst gefunden.</translation>
    </message>
    <message>
        <source>&amp;Copy to {stick}</source>
        <translation>Auf {stick} &amp;kopieren</translation>
    </message>
    <message>
        <source>E&amp;ject {stick}</source>
        <translation>{stick} a&amp;uswerfen</translation>
    </message>
    <message>
        <source>{n} GB are free.</source>
        <translation>{n} GB sind frei.</translation>
    </message>
    <message>
        <source>It is write-protected.</source>
        <translation>Er ist schreibgeschützt.</translation>
    </message>
    <message>
        <source>The stick is being let go…</source>
        <translation>Der Stick wird ausgeworfen…</translation>
    </message>
    <message>
        <source>{stick} can be pulled out.</source>
        <translation>{stick} kann abgezogen werden.</translation>
    </message>
</context>
<context>
    <name>studio</name>
    <message>
        <source>Ca&amp;ncel</source>
        <extracomment>Width of the controls beside the picture, lines of text; taste.</extracomment>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>How far the work is</source>
        <translation>Wie weit die Arbeit ist</translation>
    </message>
    <message>
        <source>Written: {place}</source>
        <translation>Geschrieben: {place}</translation>
    </message>
    <message>
        <source>&amp;Another clone…</source>
        <translation>Ein &amp;anderer Klon…</translation>
    </message>
    <message>
        <source>No clone is chosen.</source>
        <translation>Es ist kein Klon gewählt.</translation>
    </message>
    <message>
        <source>Folder of a clone</source>
        <translation>Ordner eines Klons</translation>
    </message>
    <message>
        <source>Body of blobs</source>
        <extracomment>What of a blob&apos;s ends may be told here, cm; its file takes more.</extracomment>
        <translation>Körper aus Blobs</translation>
    </message>
    <message>
        <source>Show the &amp;blobs</source>
        <translation>&amp;Blobs zeigen</translation>
    </message>
    <message>
        <source>&amp;Open a file of blobs…</source>
        <translation>Datei mit Blobs ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the blobs as a file…</source>
        <translation>Blobs als &amp;Datei sichern…</translation>
    </message>
    <message>
        <source>Bl&amp;obs</source>
        <translation>B&amp;lobs</translation>
    </message>
    <message>
        <source> cm</source>
        <extracomment>Steps of the slider a centimetre.</extracomment>
        <translation> cm</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>&amp;Material</translation>
    </message>
    <message>
        <source>File of blobs</source>
        <translation>Datei mit Blobs</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius at the other end</source>
        <translation>Radius am Ende</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>Nach links</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Forwards</source>
        <translation>Nach vorn</translation>
    </message>
    <message>
        <source>Times as wide</source>
        <translation>So breit</translation>
    </message>
    <message>
        <source>Times as high</source>
        <translation>So hoch</translation>
    </message>
    <message>
        <source>Times as deep</source>
        <translation>So tief</translation>
    </message>
    <message>
        <source>Body from measures</source>
        <extracomment>Sliders go so many spreads to either side of what is usual; a body may have 4.5 (`FAR`). Side of a saved body&apos;s texture, texels; as `cloner body` has it.</extracomment>
        <translation>Körper nach Maßen</translation>
    </message>
    <message>
        <source>A woman or a girl</source>
        <translation>Eine Frau oder ein Mädchen</translation>
    </message>
    <message>
        <source>A man or a boy</source>
        <translation>Ein Mann oder ein Junge</translation>
    </message>
    <message>
        <source>A clone, told new measures</source>
        <translation>Ein Klon, neu vermessen</translation>
    </message>
    <message>
        <source> years</source>
        <translation> Jahre</translation>
    </message>
    <message>
        <source>Four, as a shop asks</source>
        <translation>Vier, wie im Laden</translation>
    </message>
    <message>
        <source>Nine, as a tailor takes</source>
        <translation>Neun, wie beim Schneider</translation>
    </message>
    <message>
        <source>&amp;Save the body…</source>
        <translation>Den Körper &amp;sichern…</translation>
    </message>
    <message>
        <source>&amp;Who</source>
        <translation>&amp;Wer</translation>
    </message>
    <message>
        <source>&amp;Age</source>
        <translation>&amp;Alter</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>&amp;Maße</translation>
    </message>
    <message>
        <source>&amp;Name of the body</source>
        <translation>&amp;Name des Körpers</translation>
    </message>
    <message>
        <source>body</source>
        <translation>koerper</translation>
    </message>
    <message>
        <source>Folder for bodies</source>
        <translation>Ordner für Körper</translation>
    </message>
    <message>
        <source>Take this marker away</source>
        <extracomment>What a vertex is called that has no name of its own: this and its number.</extracomment>
        <translation>Diese Marke entfernen</translation>
    </message>
    <message>
        <source>Photograph on a statue</source>
        <translation>Fotografie auf einer Statue</translation>
    </message>
    <message>
        <source>Choose a &amp;photograph…</source>
        <translation>Eine &amp;Fotografie wählen…</translation>
    </message>
    <message>
        <source>Paint it all &amp;round</source>
        <translation>&amp;Ringsum bemalen</translation>
    </message>
    <message>
        <source>Choose a photograph of a face, of flesh or of stone.</source>
        <translation>Wählen Sie die Fotografie eines Gesichts, aus Fleisch oder aus Stein.</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Fotografie</translation>
    </message>
    <message>
        <source>No face was found: drag the markers to their places.</source>
        <translation>Es wurde kein Gesicht gefunden: ziehen Sie die Marken an ihre Orte.</translation>
    </message>
    <message>
        <source>Drag the markers. A double click on the clone adds one, Delete takes one away.</source>
        <translation>Ziehen Sie die Marken. Ein Doppelklick auf den Klon fügt eine hinzu, Entf nimmt eine weg.</translation>
    </message>
    <message>
        <source>The usual man</source>
        <extracomment>Side of the texture of a statue that is nobody&apos;s clone, texels; as `cloner statue` has it.</extracomment>
        <translation>Der übliche Mann</translation>
    </message>
    <message>
        <source>Its own colours</source>
        <translation>Die eigenen Farben</translation>
    </message>
    <message>
        <source>A clone</source>
        <translation>Ein Klon</translation>
    </message>
    <message>
        <source>&amp;Save the statue…</source>
        <translation>Die Statue &amp;sichern…</translation>
    </message>
    <message>
        <source>statue</source>
        <translation>statue</translation>
    </message>
    <message>
        <source>La&amp;id on</source>
        <translation>&amp;Gelegt auf</translation>
    </message>
    <message>
        <source>&amp;Name of the statue</source>
        <translation>&amp;Name der Statue</translation>
    </message>
    <message>
        <source>Folder for statues</source>
        <translation>Ordner für Statuen</translation>
    </message>
    <message>
        <source>Clone in stone</source>
        <translation>Klon in Stein</translation>
    </message>
    <message>
        <source>Choose a clone that is finished.</source>
        <translation>Wählen Sie einen fertigen Klon.</translation>
    </message>
    <message>
        <source>&amp;Pose</source>
        <translation>&amp;Haltung</translation>
    </message>
    <message>
        <source>Dress a clone</source>
        <extracomment>Lengths that may be asked for, cm; the first stands for the usual one.</extracomment>
        <translation>Einen Klon anziehen</translation>
    </message>
    <message>
        <source>A file of my own…</source>
        <translation>Eine eigene Datei…</translation>
    </message>
    <message>
        <source>Own walk</source>
        <translation>Eigener Gang</translation>
    </message>
    <message>
        <source>A captured walk…</source>
        <translation>Ein aufgenommener Gang…</translation>
    </message>
    <message>
        <source>as usual</source>
        <translation>wie üblich</translation>
    </message>
    <message>
        <source>&amp;Instead of the photographed clothes</source>
        <translation>S&amp;tatt der fotografierten Kleider</translation>
    </message>
    <message>
        <source>Otherwise it is worn over the clothes of the photos.</source>
        <translation>Sonst wird es über den Kleidern der Fotos getragen.</translation>
    </message>
    <message>
        <source>Who wears it</source>
        <translation>Wer es trägt</translation>
    </message>
    <message>
        <source>&amp;Garment</source>
        <translation>&amp;Kleidungsstück</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>&amp;Fabric</source>
        <translation>&amp;Stoff</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Bewegung</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Something &amp;over it</source>
        <translation>Etwas da&amp;rüber</translation>
    </message>
    <message>
        <source>Photographed clothes</source>
        <translation>Fotografierte Kleider</translation>
    </message>
    <message>
        <source>Take the photographed clothes of {name} off?</source>
        <translation>Die fotografierten Kleider von {name} ausziehen?</translation>
    </message>
    <message>
        <source>The garment is then worn over neutral underwear. Ask the visitor first.</source>
        <translation>Das Kleidungsstück wird dann über neutraler Unterwäsche getragen. Fragen Sie zuerst die Person.</translation>
    </message>
    <message>
        <source>Take them off</source>
        <translation>Ausziehen</translation>
    </message>
    <message>
        <source>File of a garment</source>
        <translation>Datei eines Kleidungsstücks</translation>
    </message>
    <message>
        <source>Captured walk</source>
        <translation>Aufgenommener Gang</translation>
    </message>
    <message>
        <source>Save the dressed clone</source>
        <translation>Den angezogenen Klon sichern</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Nähen</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>An&amp;legen</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>&amp;Nähen</translation>
    </message>
    <message>
        <source>Let it wal&amp;k</source>
        <translation>&amp;Gehen lassen</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Sichern als…</translation>
    </message>
</context>
<context>
    <name>takeaway</name>
    <message>
        <source>Writing the files…</source>
        <translation>Dateien werden geschrieben…</translation>
    </message>
    <message>
        <source>Written and read back: {place}</source>
        <translation>Geschrieben und gegengelesen: {place}</translation>
    </message>
    <message>
        <source>Stopped: nothing of it was left there.</source>
        <translation>Angehalten: nichts davon blieb dort.</translation>
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
        <source>Save as one &amp;zip file…</source>
        <translation>Als eine &amp;Zip-Datei sichern…</translation>
    </message>
    <message>
        <source>Show &amp;report</source>
        <translation>&amp;Bericht zeigen</translation>
    </message>
    <message>
        <source>Copy to a f&amp;older…</source>
        <translation>In einen &amp;Ordner kopieren…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Show &amp;folder</source>
        <translation>Ordner &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Page for telephones on this network</source>
        <translation>&amp;Seite für Telefone in diesem Netz</translation>
    </message>
    <message>
        <source>Page for telephones on this network</source>
        <translation>Seite für Telefone in diesem Netz</translation>
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
        <source>How far the files are</source>
        <translation>Wie weit die Dateien sind</translation>
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
        <source>Switch the page for telephones on, or type the address of a page of your own.</source>
        <translation>Schalten Sie die Seite für Telefone ein, oder tippen Sie die Adresse einer eigenen Seite.</translation>
    </message>
    <message>
        <source>In the scene “{scene}”, within seconds.</source>
        <translation>In der Szene „{scene}“, binnen Sekunden.</translation>
    </message>
    <message>
        <source>Off: nothing leaves this computer.</source>
        <translation>Aus: nichts verlässt diesen Rechner.</translation>
    </message>
    <message>
        <source>The page is being made…</source>
        <translation>Die Seite entsteht…</translation>
    </message>
    <message>
        <source>Telephones warn of the booth&apos;s own certificate once.</source>
        <translation>Telefone warnen einmal vor dem eigenen Zertifikat des Stands.</translation>
    </message>
    <message>
        <source>Not encrypted: use a hotspot of your own with a password.</source>
        <translation>Unverschlüsselt: nehmen Sie einen eigenen Hotspot mit Kennwort.</translation>
    </message>
    <message>
        <source>Each visitor&apos;s link works for {n} hours.</source>
        <translation>Jeder Link eines Besuchers gilt {n} Stunden.</translation>
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
    <name>told</name>
    <message>
        <source>there is no camera</source>
        <translation>Keine Kamera gefunden</translation>
    </message>
    <message>
        <source>Plug it in and allow its use, then try again</source>
        <translation>Schließen Sie sie an, erlauben Sie ihre Benutzung und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>the camera gives no pictures any more</source>
        <translation>die Kamera liefert keine Bilder mehr</translation>
    </message>
    <message>
        <source>Plug it in again</source>
        <translation>Schließen Sie sie neu an</translation>
    </message>
    <message>
        <source>it must be an object with &quot;format&quot;: %1</source>
        <translation>es muss ein Objekt mit &quot;format&quot;: %1 sein</translation>
    </message>
    <message>
        <source>a setting is out of its range</source>
        <translation>eine Einstellung liegt außerhalb ihrer Grenzen</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Choose another, or make it first</source>
        <translation>Wählen Sie einen anderen oder legen Sie ihn zuerst an</translation>
    </message>
    <message>
        <source>this folder holds other things than visitors</source>
        <translation>in diesem Ordner liegt anderes als Besucher</translation>
    </message>
    <message>
        <source>Choose an empty folder, an event&apos;s, or one with photos named body_front.jpg and so on</source>
        <translation>Wählen Sie einen leeren Ordner, den einer Veranstaltung oder einen mit Fotos namens body_front.jpg usw.</translation>
    </message>
    <message>
        <source>the event&apos;s settings cannot be read</source>
        <translation>die Einstellungen der Veranstaltung sind nicht lesbar</translation>
    </message>
    <message>
        <source>Correct %1, or move it away to start with the usual settings</source>
        <translation>Berichtigen Sie %1, oder legen Sie die Datei beiseite, um mit den üblichen Einstellungen zu beginnen</translation>
    </message>
    <message>
        <source>the key %1 is not known</source>
        <translation>der Schlüssel %1 ist unbekannt</translation>
    </message>
    <message>
        <source>The keys are %1</source>
        <translation>Die Schlüssel sind %1</translation>
    </message>
    <message>
        <source>the licence %1 is not known</source>
        <translation>die Lizenz %1 ist unbekannt</translation>
    </message>
    <message>
        <source>The licences are %1</source>
        <translation>Die Lizenzen sind %1</translation>
    </message>
    <message>
        <source>%1 has a value of the wrong kind</source>
        <translation>%1 hat einen Wert der falschen Art</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>der Ordner ist nicht lesbar</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Prüfen Sie die Zugriffsrechte</translation>
    </message>
    <message>
        <source>the visitor&apos;s folder cannot be made</source>
        <translation>der Ordner des Besuchers kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>Check permissions and space</source>
        <translation>Prüfen Sie Zugriffsrechte und freien Platz</translation>
    </message>
    <message>
        <source>this is there already</source>
        <translation>das gibt es schon</translation>
    </message>
    <message>
        <source>Choose another name or place</source>
        <translation>Wählen Sie einen anderen Namen oder Ort</translation>
    </message>
    <message>
        <source>it cannot be written there</source>
        <translation>dorthin kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Is the stick full or write-protected?</source>
        <translation>Ist der Stick voll oder schreibgeschützt?</translation>
    </message>
    <message>
        <source>there is no photo yet</source>
        <translation>es gibt noch kein Foto</translation>
    </message>
    <message>
        <source>Take the photos first</source>
        <translation>Machen Sie zuerst die Fotos</translation>
    </message>
    <message>
        <source>no photo is stored before the visitor agreed</source>
        <translation>ohne Einwilligung des Besuchers wird kein Foto gespeichert</translation>
    </message>
    <message>
        <source>Ask the visitor and tick the consent on the first page</source>
        <translation>Fragen Sie den Besucher und haken Sie die Einwilligung auf der ersten Seite an</translation>
    </message>
    <message>
        <source>this is no photo</source>
        <translation>das ist kein Foto</translation>
    </message>
    <message>
        <source>Use one of %1</source>
        <translation>Nehmen Sie eines von %1</translation>
    </message>
    <message>
        <source>the photo cannot be stored</source>
        <translation>das Foto kann nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Check the folder&apos;s permissions and space</source>
        <translation>Prüfen Sie Zugriffsrechte und Platz des Ordners</translation>
    </message>
    <message>
        <source>the photo cannot be moved</source>
        <translation>das Foto kann nicht verschoben werden</translation>
    </message>
    <message>
        <source>the photo cannot be deleted</source>
        <translation>das Foto kann nicht gelöscht werden</translation>
    </message>
    <message>
        <source>the photo cannot be turned</source>
        <translation>das Foto kann nicht gedreht werden</translation>
    </message>
    <message>
        <source>Turn it with another program</source>
        <translation>Drehen Sie es mit einem anderen Programm</translation>
    </message>
    <message>
        <source>the text is too long for a code</source>
        <translation>der Text ist zu lang für einen Code</translation>
    </message>
    <message>
        <source>%1 characters can be scanned</source>
        <translation>%1 Zeichen können gelesen werden</translation>
    </message>
    <message>
        <source>something went wrong that the program did not expect (%1)</source>
        <translation>etwas ging schief, womit das Programm nicht gerechnet hat (%1)</translation>
    </message>
    <message>
        <source>something went wrong that the program did not expect</source>
        <translation>etwas ging schief, womit das Programm nicht gerechnet hat</translation>
    </message>
    <message>
        <source>Try again; if it happens again, send the log file</source>
        <translation>Versuchen Sie es erneut; geschieht es wieder, schicken Sie die Protokolldatei</translation>
    </message>
    <message>
        <source>Go on; if it happens again, send the log file</source>
        <translation>Machen Sie weiter; geschieht es wieder, schicken Sie die Protokolldatei</translation>
    </message>
    <message>
        <source>Start it from a terminal with -v and send what it prints</source>
        <translation>Starten Sie das Programm im Terminal mit -v und schicken Sie die Ausgabe</translation>
    </message>
    <message>
        <source>the worker&apos;s process ended</source>
        <translation>der Arbeitsprozess wurde beendet</translation>
    </message>
    <message>
        <source>a texture of %1 texels cannot be made</source>
        <translation>eine Textur mit %1 Texeln ist nicht möglich</translation>
    </message>
    <message>
        <source>The sizes are %1</source>
        <translation>Möglich sind %1</translation>
    </message>
    <message>
        <source>the format %1 is not known</source>
        <translation>das Format %1 ist unbekannt</translation>
    </message>
    <message>
        <source>The formats are %1</source>
        <translation>Die Formate sind %1</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>Die Datei kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>Choose another folder or free some space</source>
        <translation>Wählen Sie einen anderen Ordner oder schaffen Sie Platz</translation>
    </message>
    <message>
        <source>there is not enough memory: a limit allows %1 GB, a clone needs %2</source>
        <translation>Es gibt nicht genug Speicher: Eine Grenze erlaubt %1 GB, ein Klon braucht %2</translation>
    </message>
    <message>
        <source>Raise it: ulimit -v %1</source>
        <translation>Heben Sie sie an: ulimit -v %1</translation>
    </message>
    <message>
        <source>USD needs a library that is not here</source>
        <translation>USD braucht eine Bibliothek, die hier fehlt</translation>
    </message>
    <message>
        <source>Install it with: %1</source>
        <translation>Installieren Sie sie mit: %1</translation>
    </message>
    <message>
        <source>This machine cannot draw: EGL gives no context</source>
        <translation>Dieser Rechner kann nicht zeichnen: EGL gibt keinen Kontext</translation>
    </message>
    <message>
        <source>nothing is held under this name</source>
        <translation>unter diesem Namen ist nichts gespeichert</translation>
    </message>
    <message>
        <source>cloner list shows the names</source>
        <translation>cloner list zeigt die Namen</translation>
    </message>
    <message>
        <source>somebody is cloning this visitor just now</source>
        <translation>dieser Besucher wird gerade geklont</translation>
    </message>
    <message>
        <source>Wait or stop that, and repeat</source>
        <translation>Warten Sie oder brechen Sie das ab, dann noch einmal</translation>
    </message>
    <message>
        <source>there is nowhere to look</source>
        <translation>es ist kein Ort zum Suchen angegeben</translation>
    </message>
    <message>
        <source>Give --photos, --out or both</source>
        <translation>Geben Sie --photos, --out oder beides an</translation>
    </message>
    <message>
        <source>Give --photos and --out as you gave them to batch</source>
        <translation>Geben Sie --photos und --out so an wie bei batch</translation>
    </message>
    <message>
        <source>the file exists</source>
        <translation>die Datei gibt es schon</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the zip file cannot be written</source>
        <translation>die Zip-Datei kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Check the folder and its space</source>
        <translation>Prüfen Sie den Ordner und seinen Platz</translation>
    </message>
    <message>
        <source>not everything could be deleted</source>
        <translation>nicht alles konnte gelöscht werden</translation>
    </message>
    <message>
        <source>Check permissions and repeat</source>
        <translation>Prüfen Sie die Zugriffsrechte und wiederholen Sie es</translation>
    </message>
    <message>
        <source>the results cannot be written there</source>
        <translation>dorthin können die Ergebnisse nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Choose another --out folder, or check its permissions and free space</source>
        <translation>Wählen Sie einen anderen Ordner, oder prüfen Sie Zugriffsrechte und freien Platz</translation>
    </message>
    <message>
        <source>something that is no earlier result is in the way and will not be replaced</source>
        <translation>etwas, das kein früheres Ergebnis ist, liegt im Weg und wird nicht ersetzt</translation>
    </message>
    <message>
        <source>Choose another --out folder or --id</source>
        <translation>Wählen Sie einen anderen Ordner oder Namen</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>die Datei kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>The clone was written by a newer version</source>
        <translation>Der Klon stammt von einer neueren Version</translation>
    </message>
    <message>
        <source>Clone the person again with this version of Cloner</source>
        <translation>Klonen Sie die Person mit dieser Version neu</translation>
    </message>
    <message>
        <source>The clone is not there</source>
        <translation>Der Klon ist nicht da</translation>
    </message>
    <message>
        <source>Run: cloner clone</source>
        <translation>Führen Sie cloner clone aus</translation>
    </message>
    <message>
        <source>The file is not a readable clone</source>
        <translation>Die Datei ist kein lesbarer Klon</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 muss ein Objekt sein</translation>
    </message>
    <message>
        <source>Correct the entry, or move the file away to use the proposals alone</source>
        <translation>Berichtigen Sie den Eintrag, oder legen Sie die Datei beiseite, um nur die Vorschläge zu nutzen</translation>
    </message>
    <message>
        <source>a point needs numbers &quot;x&quot; and &quot;y&quot; in photo pixels</source>
        <translation>ein Punkt braucht Zahlen &quot;x&quot; und &quot;y&quot; in Fotopixeln</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>das ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>%1 is not a view; the views are %2</source>
        <translation>%1 ist keine Ansicht; die Ansichten sind %2</translation>
    </message>
    <message>
        <source>there is no feature point of this name in this view</source>
        <translation>in dieser Ansicht gibt es keinen Punkt dieses Namens</translation>
    </message>
    <message>
        <source>the point lies outside the photo of %1</source>
        <translation>der Punkt liegt außerhalb des Fotos von %1</translation>
    </message>
    <message>
        <source>%1 with a usable name is here, and one front photo is needed</source>
        <translation>%1 mit brauchbarem Namen ist hier, und ein Foto von vorn ist nötig</translation>
    </message>
    <message>
        <source>Give the folder inside it that holds the photos (%1), or use cloner batch for all</source>
        <translation>Nehmen Sie den Ordner darin, der die Fotos enthält (%1), oder cloner batch für alle</translation>
    </message>
    <message>
        <source>Name the photos %1 (png, webp, tiff and heic work too)</source>
        <translation>Nennen Sie die Fotos %1 (auch png, webp, tiff und heic)</translation>
    </message>
    <message>
        <source>there is no such folder of photos</source>
        <translation>diesen Ordner mit Fotos gibt es nicht</translation>
    </message>
    <message>
        <source>Give the folder that holds the photos</source>
        <translation>Geben Sie den Ordner mit den Fotos an</translation>
    </message>
    <message>
        <source>%1 must be text in quotes</source>
        <translation>%1 muss Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>Put it in quotes</source>
        <translation>Setzen Sie es in Anführungszeichen</translation>
    </message>
    <message>
        <source>Write sex = &quot;f&quot; or sex = &quot;m&quot;, or leave it out</source>
        <translation>Schreiben Sie sex = &quot;f&quot; oder sex = &quot;m&quot;, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>age must be years</source>
        <translation>age müssen Jahre sein</translation>
    </message>
    <message>
        <source>Write a line like: age = 71</source>
        <translation>Schreiben Sie eine Zeile wie: age = 71</translation>
    </message>
    <message>
        <source>measures must be a table of centimetres</source>
        <translation>measures muss eine Tabelle in Zentimetern sein</translation>
    </message>
    <message>
        <source>Write a line [measures], and below it lines like: waist_girth = 70.2</source>
        <translation>Schreiben Sie eine Zeile [measures] und darunter Zeilen wie: waist_girth = 70.2</translation>
    </message>
    <message>
        <source>the height must be a number of centimetres</source>
        <translation>die Größe muss eine Zahl in Zentimetern sein</translation>
    </message>
    <message>
        <source>Write height_cm = 172</source>
        <translation>Schreiben Sie height_cm = 172</translation>
    </message>
    <message>
        <source>a height of %1 cm is outside %2 to %3 cm</source>
        <translation>eine Größe von %1 cm liegt außerhalb von %2 bis %3 cm</translation>
    </message>
    <message>
        <source>Give the barefoot height in centimetres</source>
        <translation>Geben Sie die Größe ohne Schuhe in Zentimetern an</translation>
    </message>
    <message>
        <source>there are two photos for %1: %2 and %3</source>
        <translation>es gibt zwei Fotos für %1: %2 und %3</translation>
    </message>
    <message>
        <source>Keep one of them</source>
        <translation>Behalten Sie eines davon</translation>
    </message>
    <message>
        <source>this is not valid TOML (%1)</source>
        <translation>das ist kein gültiges TOML (%1)</translation>
    </message>
    <message>
        <source>Write lines like: height_cm = 172</source>
        <translation>Schreiben Sie Zeilen wie: height_cm = 172</translation>
    </message>
    <message>
        <source>this is a link that leads out of its folder</source>
        <translation>das ist eine Verknüpfung, die aus dem Ordner hinausführt</translation>
    </message>
    <message>
        <source>Put the file itself there</source>
        <translation>Legen Sie die Datei selbst dorthin</translation>
    </message>
    <message>
        <source>&quot;format&quot; must be a whole number</source>
        <translation>&quot;format&quot; muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>Write format = %1, as this version does</source>
        <translation>Schreiben Sie format = %1, wie diese Version</translation>
    </message>
    <message>
        <source>it was written by a newer version of Cloner (format %1, this one knows %2)</source>
        <translation>es stammt von einer neueren Version von Cloner (Format %1, diese kennt %2)</translation>
    </message>
    <message>
        <source>Update Cloner, or move the file away</source>
        <translation>Aktualisieren Sie Cloner oder legen Sie die Datei beiseite</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>das ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Check it or move it away</source>
        <translation>Prüfen Sie sie oder legen Sie sie beiseite</translation>
    </message>
    <message>
        <source>the file is larger than %1 MB</source>
        <translation>die Datei ist größer als %1 MB</translation>
    </message>
    <message>
        <source>the file cannot be read as text</source>
        <translation>die Datei ist nicht als Text lesbar</translation>
    </message>
    <message>
        <source>the work folder cannot be written</source>
        <translation>in den Arbeitsordner kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>The picture is too large to draw</source>
        <translation>Das Bild ist zu groß zum Zeichnen</translation>
    </message>
    <message>
        <source>Keep it under %1 pixels</source>
        <translation>Bleiben Sie unter %1 Pixeln</translation>
    </message>
    <message>
        <source>this photo shows only the upper part of the person, not the whole body</source>
        <translation>dieses Foto zeigt nur den Oberkörper, nicht den ganzen Körper</translation>
    </message>
    <message>
        <source>the feet are outside this photo</source>
        <translation>die Füße sind nicht auf dem Foto</translation>
    </message>
    <message>
        <source>this photo shows the person from the front or back, not from the side</source>
        <translation>dieses Foto zeigt die Person von vorn oder hinten, nicht von der Seite</translation>
    </message>
    <message>
        <source>this photo shows the person from the side, not the %1</source>
        <translation>dieses Foto zeigt die Person von der Seite, nicht von %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>this photo shows the person&apos;s back, not the front</source>
        <translation>dieses Foto zeigt die Person von hinten, nicht von vorn</translation>
    </message>
    <message>
        <source>this photo shows the person&apos;s front, not the back</source>
        <translation>dieses Foto zeigt die Person von vorn, nicht von hinten</translation>
    </message>
    <message>
        <source>this photo shows the whole body, not the face from near</source>
        <translation>dieses Foto zeigt den ganzen Körper, nicht das Gesicht aus der Nähe</translation>
    </message>
    <message>
        <source>this photo shows the face from the side, not from the front</source>
        <translation>dieses Foto zeigt das Gesicht von der Seite, nicht von vorn</translation>
    </message>
    <message>
        <source>no face can be seen from the front in this photo</source>
        <translation>auf diesem Foto ist kein Gesicht von vorn zu sehen</translation>
    </message>
    <message>
        <source>this photo shows the head from the front or back, not from the side</source>
        <translation>dieses Foto zeigt den Kopf von vorn oder hinten, nicht von der Seite</translation>
    </message>
    <message>
        <source>Rename or retake the photos so that each shows what its name says</source>
        <translation>Ordnen Sie die Fotos neu zu oder machen Sie sie neu, sodass jedes seine Ansicht zeigt</translation>
    </message>
    <message>
        <source>%1: the corrected point %2 lies off the image</source>
        <translation>%1: der berichtigte Punkt %2 liegt außerhalb des Bildes</translation>
    </message>
    <message>
        <source>Drag it back on to the photo</source>
        <translation>Ziehen Sie ihn zurück auf das Foto</translation>
    </message>
    <message>
        <source>no person found in this photo</source>
        <translation>auf diesem Foto wurde niemand gefunden</translation>
    </message>
    <message>
        <source>Take it again with one person in full view</source>
        <translation>Machen Sie es neu, mit einer ganz sichtbaren Person</translation>
    </message>
    <message>
        <source>%1 people found in this photo</source>
        <translation>%1 Personen auf diesem Foto gefunden</translation>
    </message>
    <message>
        <source>Take it again with one person alone in view</source>
        <translation>Machen Sie es neu, mit nur einer Person im Bild</translation>
    </message>
    <message>
        <source>the person&apos;s outline was not found</source>
        <translation>der Umriss der Person wurde nicht gefunden</translation>
    </message>
    <message>
        <source>Retake the photo before a plain background</source>
        <translation>Machen Sie das Foto vor einem ruhigen Hintergrund neu</translation>
    </message>
    <message>
        <source>the photo is missing</source>
        <translation>das Foto fehlt</translation>
    </message>
    <message>
        <source>Put it into the photos folder</source>
        <translation>Legen Sie es in den Fotoordner</translation>
    </message>
    <message>
        <source>the photo is empty (0 bytes)</source>
        <translation>das Foto ist leer (0 Bytes)</translation>
    </message>
    <message>
        <source>Copy the photo from the camera again, or retake it</source>
        <translation>Kopieren Sie das Foto erneut von der Kamera oder machen Sie es neu</translation>
    </message>
    <message>
        <source>%1 has %2 megapixels, more than the %3 that can be read</source>
        <translation>%1 hat %2 Megapixel, mehr als die %3, die lesbar sind</translation>
    </message>
    <message>
        <source>the photo</source>
        <translation>das Foto</translation>
    </message>
    <message>
        <source>this %1 photo</source>
        <translation>dieses %1-Foto</translation>
    </message>
    <message>
        <source>the photo has more than %1 megapixels</source>
        <translation>das Foto hat mehr als %1 Megapixel</translation>
    </message>
    <message>
        <source>Save it smaller, 12 megapixels are plenty</source>
        <translation>Speichern Sie es kleiner, 12 Megapixel genügen</translation>
    </message>
    <message>
        <source>the photo is only %1 x %2 pixels</source>
        <translation>das Foto hat nur %1 x %2 Pixel</translation>
    </message>
    <message>
        <source>Use the original photo, not a thumbnail</source>
        <translation>Nehmen Sie das Original, kein Vorschaubild</translation>
    </message>
    <message>
        <source>this file is not a photo that can be read</source>
        <translation>diese Datei ist kein lesbares Foto</translation>
    </message>
    <message>
        <source>Install pillow-heif, or let the phone save photos as JPEG</source>
        <translation>Installieren Sie pillow-heif, oder lassen Sie das Telefon JPEG speichern</translation>
    </message>
    <message>
        <source>Use a JPEG, PNG, TIFF or WebP photo</source>
        <translation>Nehmen Sie ein Foto als JPEG, PNG, TIFF oder WebP</translation>
    </message>
    <message>
        <source>the photo is damaged or cut short</source>
        <translation>das Foto ist beschädigt oder unvollständig</translation>
    </message>
    <message>
        <source>the photo cannot be opened</source>
        <translation>das Foto kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>the photo cannot be read</source>
        <translation>das Foto ist nicht lesbar</translation>
    </message>
    <message>
        <source>Is the card or the cable still in its place?</source>
        <translation>Steckt die Karte oder das Kabel noch?</translation>
    </message>
    <message>
        <source>the photos changed while they were cloned</source>
        <translation>die Fotos haben sich während des Klonens geändert</translation>
    </message>
    <message>
        <source>Clone again</source>
        <translation>Klonen Sie noch einmal</translation>
    </message>
    <message>
        <source>%1: depths of the face are those of a usual face of this shape</source>
        <translation>%1: die Tiefen sind die eines üblichen Gesichts dieser Form</translation>
    </message>
    <message>
        <source>there is no side photo of the face</source>
        <translation>kein Foto des Gesichts von der Seite</translation>
    </message>
    <message>
        <source>no profile was found in the side photo of the face</source>
        <translation>im Seitenfoto des Gesichts wurde kein Profil gefunden</translation>
    </message>
    <message>
        <source>No height was given: %1 cm is assumed, so every length is unscaled; %2</source>
        <translation>Keine Größe angegeben: %1 cm werden angenommen, alle Längen sind ohne Maßstab; %2</translation>
    </message>
    <message>
        <source>give --height-cm or height_cm in person.toml</source>
        <translation>geben Sie die Größe auf der ersten Seite an</translation>
    </message>
    <message>
        <source>%1: the clone covers the person&apos;s outline only to %2 percent</source>
        <translation>%1: der Klon deckt den Umriss der Person nur zu %2 Prozent</translation>
    </message>
    <message>
        <source>%1: the clone covers the head&apos;s outline only to %2 percent</source>
        <translation>%1: der Klon deckt den Umriss des Kopfes nur zu %2 Prozent</translation>
    </message>
    <message>
        <source>%1: the hair is %2 times as large here as in the other photos, so this photo&apos;s was not used; take it again before a wall that looks unlike the hair</source>
        <translation>%1: Das Haar ist hier %2-mal so groß wie auf den anderen Fotos; dieses Foto wurde dafür nicht verwendet. Nehmen Sie es vor einer Wand neu auf, die anders aussieht als das Haar</translation>
    </message>
    <message>
        <source>%1: nobody can be made out in this photo, so it was left out; retake it with hair, hood or scarf away from the face</source>
        <translation>%1: auf diesem Foto ist niemand zu erkennen, daher wurde es ausgelassen; nehmen Sie es noch einmal auf, ohne Haar, Kapuze oder Tuch vor dem Gesicht</translation>
    </message>
    <message>
        <source>%1: hair hides the face in this photo, so it shows no more than the hair; retake it with hair, hood or scarf away from the face</source>
        <translation>%1: auf diesem Foto verdeckt Haar das Gesicht, daher zeigt es nur das Haar; nehmen Sie es noch einmal auf, ohne Haar, Kapuze oder Tuch vor dem Gesicht</translation>
    </message>
    <message>
        <source>%1: the clone would cover only %2 percent of the person in this photo, so it was left out; check that it shows the same person in the same clothes, straight from the side or from behind</source>
        <translation>%1: der Klon würde nur %2 Prozent der Person auf diesem Foto decken, daher wurde es ausgelassen; prüfen Sie, ob es dieselbe Person in derselben Kleidung zeigt, gerade von der Seite oder von hinten</translation>
    </message>
    <message>
        <source>%1: the %2 arm of the clone lies %3 cm beside the arm in this photo; let the arms hang a little away from the body and retake it</source>
        <translation>%1: Arm des Klons (%2) liegt %3 cm neben dem Arm auf diesem Foto; lassen Sie die Arme ein wenig vom Körper entfernt hängen und nehmen Sie es noch einmal auf</translation>
    </message>
    <message>
        <source>%1: the head is turned by about %2 degrees from where it should look; retake it with the head turned as the body</source>
        <translation>%1: der Kopf ist um etwa %2 Grad aus der Blickrichtung gedreht; nehmen Sie es noch einmal auf, den Kopf wie den Körper ausgerichtet</translation>
    </message>
    <message>
        <source>%1: the glasses became an object of their own and the skin behind their frame is a guess; take the face photos without glasses if you can</source>
        <translation>%1: die Brille wurde ein eigener Gegenstand und die Haut hinter ihrem Gestell ist geraten; machen Sie die Gesichtsfotos wenn möglich ohne Brille</translation>
    </message>
    <message>
        <source>%1: headwear hides the hair and becomes part of the head; take it off if you can</source>
        <translation>%1: eine Kopfbedeckung verdeckt das Haar und wird Teil des Kopfes; nehmen Sie sie wenn möglich ab</translation>
    </message>
    <message>
        <source>%1: hair hides an eye, so what lies behind it is a guess; retake the face photos with the hair away from the face</source>
        <translation>%1: Haare verdecken ein Auge; was dahinter liegt, ist geraten. Nehmen Sie die Fotos des Gesichts neu auf, mit den Haaren aus dem Gesicht</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>nothing can be written into this folder</source>
        <translation>in diesen Ordner kann nichts geschrieben werden</translation>
    </message>
    <message>
        <source>the visitor cannot be moved</source>
        <translation>der Besucher kann nicht verschoben werden</translation>
    </message>
    <message>
        <source>these files still tell of who was deleted</source>
        <translation>diese Dateien verraten noch etwas über Gelöschte</translation>
    </message>
    <message>
        <source>Look at them: they may be copies</source>
        <translation>Sehen Sie sie an: Es können Kopien sein</translation>
    </message>
    <message>
        <source>there is no clone before this one</source>
        <translation>es gibt keinen Klon vor diesem</translation>
    </message>
    <message>
        <source>the page for telephones cannot be served</source>
        <translation>die Seite für Telefone kann nicht angeboten werden</translation>
    </message>
    <message>
        <source>Is the booth&apos;s network up, and is nothing else served here?</source>
        <translation>Steht das Netz des Stands, und läuft hier kein anderer Dienst?</translation>
    </message>
    <message>
        <source>an encrypted page needs a library that is not here</source>
        <translation>eine verschlüsselte Seite braucht eine Bibliothek, die hier fehlt</translation>
    </message>
    <message>
        <source>Switch encryption off and use a hotspot of the booth&apos;s own with a password</source>
        <translation>Schalten Sie die Verschlüsselung aus und nehmen Sie einen eigenen Hotspot mit Kennwort</translation>
    </message>
    <message>
        <source>the keys cannot be written</source>
        <translation>die Schlüssel können nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Check its permissions and the space left, or choose another</source>
        <translation>Prüfen Sie Rechte und freien Platz, oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>%1 was damaged and is put right from what could be read; the damaged file is kept beside it</source>
        <translation>%1: beschädigt und aus dem Lesbaren wiederhergestellt; die beschädigte Datei bleibt daneben erhalten</translation>
    </message>
    <message>
        <source>The event&apos;s settings</source>
        <extracomment>All that the library may say in the window. Files of the program&apos;s own, as the operator knows them.</extracomment>
        <translation>Die Einstellungen der Veranstaltung</translation>
    </message>
    <message>
        <source>The corrected points</source>
        <translation>Die berichtigten Punkte</translation>
    </message>
    <message>
        <source>What is known of the visitor</source>
        <translation>Die Angaben zum Besucher</translation>
    </message>
    <message>
        <source>The visit</source>
        <translation>Der Besuch</translation>
    </message>
    <message>
        <source>The clone</source>
        <translation>Der Klon</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Stick</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>A photo</source>
        <translation>Ein Foto</translation>
    </message>
    <message>
        <source>its files were changed while they were read</source>
        <translation>Dateien wurden beim Lesen verändert</translation>
    </message>
    <message>
        <source>gphoto2, which speaks with cameras, is not installed</source>
        <translation>gphoto2, das mit Kameras spricht, ist nicht installiert</translation>
    </message>
    <message>
        <source>Install it, or let the camera&apos;s own program write into a folder and watch that</source>
        <translation>Installieren Sie es, oder lassen Sie das Programm der Kamera in einen Ordner schreiben und diesen beobachten</translation>
    </message>
    <message>
        <source>no camera is found on the cable</source>
        <translation>am Kabel wird keine Kamera gefunden</translation>
    </message>
    <message>
        <source>Is it switched on, and no other program using it? Plug it in again</source>
        <translation>Ist sie an, und benutzt sie kein anderes Programm? Stecken Sie sie neu an</translation>
    </message>
    <message>
        <source>the camera took no photo</source>
        <translation>die Kamera hat kein Foto gemacht</translation>
    </message>
    <message>
        <source>the camera does not answer</source>
        <translation>die Kamera antwortet nicht</translation>
    </message>
    <message>
        <source>what was written there reads differently</source>
        <translation>was dort geschrieben wurde, liest sich anders</translation>
    </message>
    <message>
        <source>Use another stick: this one loses what is written on it</source>
        <translation>Nehmen Sie einen anderen Stick: Dieser verliert, was auf ihn geschrieben wird</translation>
    </message>
    <message>
        <source>this system does not tell which sticks are plugged in</source>
        <translation>dieses System sagt nicht, welche Sticks stecken</translation>
    </message>
    <message>
        <source>Choose the stick&apos;s folder by hand</source>
        <translation>Wählen Sie den Ordner des Sticks von Hand</translation>
    </message>
    <message>
        <source>no program that ejects sticks is installed</source>
        <translation>kein Programm zum Auswerfen von Sticks ist installiert</translation>
    </message>
    <message>
        <source>Eject it with the desktop&apos;s own files window before it is pulled out</source>
        <translation>Werfen Sie ihn im Dateifenster des Desktops aus, bevor er abgezogen wird</translation>
    </message>
    <message>
        <source>the stick cannot be ejected</source>
        <translation>der Stick kann nicht ausgeworfen werden</translation>
    </message>
    <message>
        <source>Close every window that shows its files, then eject it again</source>
        <translation>Schließen Sie jedes Fenster, das seine Dateien zeigt, und werfen Sie ihn noch einmal aus</translation>
    </message>
    <message>
        <source>the printer does not answer</source>
        <translation>der Drucker antwortet nicht</translation>
    </message>
    <message>
        <source>Is it switched on, with paper in it? A file can be printed elsewhere</source>
        <translation>Ist er an, mit Papier darin? Eine Datei lässt sich anderswo drucken</translation>
    </message>
    <message>
        <source>the file exists and is not replaced</source>
        <translation>die Datei gibt es schon und wird nicht ersetzt</translation>
    </message>
    <message>
        <source>Choose another --out file, or delete it</source>
        <translation>Einen anderen Namen wählen oder sie löschen</translation>
    </message>
    <message>
        <source>no file can be called that</source>
        <translation>so kann keine Datei heißen</translation>
    </message>
    <message>
        <source>Choose another --out file</source>
        <translation>Einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>this is no photo but a folder, a pipe or the like</source>
        <translation>das ist kein Foto, sondern ein Ordner, eine Pipe oder Ähnliches</translation>
    </message>
    <message>
        <source>Put the photo itself there</source>
        <translation>Das Foto selbst dorthin legen</translation>
    </message>
    <message>
        <source>Choose another --out folder or --id, or move those files away</source>
        <translation>Einen anderen Ordner oder Namen wählen oder diese Dateien wegräumen</translation>
    </message>
    <message>
        <source>the photos lie where the result would, and are never replaced</source>
        <translation>die Fotos liegen dort, wo das Ergebnis läge, und werden nie ersetzt</translation>
    </message>
    <message>
        <source>the result of another visitor is there: other photos, from another folder</source>
        <translation>dort liegt das Ergebnis einer anderen Person: andere Fotos, aus einem anderen Ordner</translation>
    </message>
    <message>
        <source>Choose another --id or --out folder, or forget that visitor first</source>
        <translation>Einen anderen Namen oder Ordner wählen oder jene Person zuerst löschen</translation>
    </message>
    <message>
        <source>the earlier result holds files of somebody&apos;s own (%1)</source>
        <translation>im früheren Ergebnis liegen fremde Dateien (%1)</translation>
    </message>
    <message>
        <source>this cannot be read: %1</source>
        <translation>das kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>the photo cannot be opened: %1</source>
        <translation>das Foto kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>No photo could be laid on the body: it keeps one plain colour</source>
        <translation>Kein Foto konnte auf den Körper gelegt werden: er behält eine einzige Farbe</translation>
    </message>
    <message>
        <source>%1: no focal length in the photo; %2 mm is assumed</source>
        <translation>%1: keine Brennweite im Foto; %2 mm werden angenommen</translation>
    </message>
    <message>
        <source>%1: no focal length in the photo; %2 assumed.</source>
        <translation>%1: keine Brennweite im Foto; %2 angenommen.</translation>
    </message>
    <message>
        <source>no photo shows the face from the front: the head is the generic one of this build</source>
        <translation>kein Foto zeigt das Gesicht von vorn: der Kopf ist der allgemeine dieser Statur</translation>
    </message>
    <message>
        <source>no usable front photo of the face: the face comes from the small one in the body photo</source>
        <translation>kein brauchbares Gesichtsfoto von vorn: das Gesicht stammt vom kleinen im Körperfoto</translation>
    </message>
    <message>
        <source>Loose clothing between hips and knees was given its own surface</source>
        <translation>Lose Kleidung zwischen Hüfte und Knien bekam eine eigene Fläche</translation>
    </message>
    <message>
        <source>There is no body photo: the body is the generic one of a matching build, its colours a guess</source>
        <translation>Kein Körperfoto: der Körper ist der allgemeine einer passenden Statur, seine Farben sind geraten</translation>
    </message>
    <message>
        <source>There is no front photo of the body: its front is seen by the face photo alone</source>
        <translation>Kein Körperfoto von vorn: die Vorderseite zeigt nur das Gesichtsfoto</translation>
    </message>
    <message>
        <source>There is no side photo of the body: its depths are those of a usual body of this shape</source>
        <translation>Kein Körperfoto von der Seite: die Tiefen sind die eines üblichen Körpers dieser Form</translation>
    </message>
    <message>
        <source>There is no back photo of the body: its back is coloured from what the other photos show</source>
        <translation>Kein Körperfoto von hinten: der Rücken ist nach den anderen Fotos gefärbt</translation>
    </message>
    <message>
        <source>corrections.json corrects %1, but there is no such photo: they are not used</source>
        <translation>corrections.json berichtigt %1, doch dieses Foto fehlt: die Berichtigungen werden nicht benutzt</translation>
    </message>
    <message>
        <source>%1 has changed since its points were corrected: check them</source>
        <translation>%1 hat sich geändert, seit die Punkte berichtigt wurden: prüfen Sie sie</translation>
    </message>
    <message>
        <source>%1: the corrected point %2 could not be obeyed: %3</source>
        <translation>%1: dem berichtigten Punkt %2 konnte nicht gefolgt werden: %3</translation>
    </message>
    <message>
        <source>it sets the scale of its photo; hair and soles are no skin that could be laid on it</source>
        <translation>er bestimmt den Maßstab seines Fotos; Haar und Sohlen sind keine Haut, die man darauf legen könnte</translation>
    </message>
    <message>
        <source>the face does not follow it, so the clone stays %1 px off it</source>
        <translation>das Gesicht folgt ihm nicht, der Klon bleibt %1 px davon entfernt</translation>
    </message>
    <message>
        <source>the limb does not reach it, so the clone stays %1 px off it</source>
        <translation>das Glied reicht nicht hin, der Klon bleibt %1 px davon entfernt</translation>
    </message>
    <message>
        <source>no outline of the clone is seen there, so the point was left out</source>
        <translation>dort ist kein Umriss des Klons zu sehen, der Punkt wurde ausgelassen</translation>
    </message>
    <message>
        <source>the point lies %1 cm off the body, so it was left out: drag it back to the outline</source>
        <translation>der Punkt liegt %1 cm neben dem Körper und wurde ausgelassen: ziehen Sie ihn zurück an den Umriss</translation>
    </message>
    <message>
        <source>the skin would fold, so the clone stays %1 px off it</source>
        <translation>die Haut würde sich falten, der Klon bleibt %1 px davon entfernt</translation>
    </message>
    <message>
        <source>it contradicts %1, so the clone stays %2 px off it</source>
        <translation>er widerspricht %1, der Klon bleibt %2 px davon entfernt</translation>
    </message>
    <message>
        <source>the clone does not tell its clothes from its skin</source>
        <translation>der Klon unterscheidet Kleider und Haut nicht</translation>
    </message>
    <message>
        <source>Clone the photos again</source>
        <translation>Klonen Sie die Fotos neu</translation>
    </message>
    <message>
        <source>no body could be made with a %1 of %2: %3 mm remain</source>
        <translation>kein Körper lässt sich mit %1 von %2 machen: %3 mm bleiben</translation>
    </message>
    <message>
        <source>Measure it again, or leave it out</source>
        <translation>Messen Sie noch einmal, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>the sex %1 is not known</source>
        <translation>das Geschlecht %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>Give --sex f or --sex m</source>
        <translation>Geben Sie --sex f oder --sex m an</translation>
    </message>
    <message>
        <source>a stature of %1 cm cannot be made</source>
        <translation>eine Körpergröße von %1 cm lässt sich nicht machen</translation>
    </message>
    <message>
        <source>Adults of %1 to %2 cm can be made</source>
        <translation>Erwachsene von %1 bis %2 cm lassen sich machen</translation>
    </message>
    <message>
        <source>At %1 years bodies of %2 to %3 cm can be made</source>
        <translation>Mit %1 Jahren lassen sich Körper von %2 bis %3 cm herstellen</translation>
    </message>
    <message>
        <source>an age of %1 years cannot be made</source>
        <translation>ein Alter von %1 Jahren lässt sich nicht herstellen</translation>
    </message>
    <message>
        <source>People of %1 to %2 years can be made</source>
        <translation>Menschen von %1 bis %2 Jahren lassen sich herstellen</translation>
    </message>
    <message>
        <source>These can: %1</source>
        <translation>Diese gehen: %1</translation>
    </message>
    <message>
        <source>a %1 of %2 is no body&apos;s of %3 cm</source>
        <translation>%1 von %2 hat niemand von %3 cm</translation>
    </message>
    <message>
        <source>%1 with the other measures</source>
        <translation>%1 bei den übrigen Maßen</translation>
    </message>
    <message>
        <source>Measure again; %1 to %2 can be made</source>
        <translation>Messen Sie noch einmal; %1 bis %2 lässt sich machen</translation>
    </message>
    <message>
        <source>the %1 cannot be told, it follows from the others</source>
        <translation>%1 kann man nicht angeben, das folgt aus den übrigen</translation>
    </message>
    <message>
        <source>the %1 of %2 is smaller than the %3 of %4</source>
        <translation>%1 von %2 ist kleiner als %3 von %4</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Messen Sie noch einmal</translation>
    </message>
    <message>
        <source>Give --sex f or --sex m, or leave it out</source>
        <translation>Geben Sie --sex f oder --sex m an, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>no consent to being shown is recorded</source>
        <translation>es ist keine Einwilligung festgehalten, gezeigt zu werden</translation>
    </message>
    <message>
        <source>Write consent = &quot;...&quot; into person.toml and clone again</source>
        <translation>Lassen Sie die Person auf der ersten Seite einwilligen und klonen Sie neu</translation>
    </message>
    <message>
        <source>Clones from %1 cm on can be</source>
        <translation>Klone ab %1 cm gehen</translation>
    </message>
    <message>
        <source>a statue has no clothes to take off</source>
        <translation>eine Statue hat keine Kleider zum Ausziehen</translation>
    </message>
    <message>
        <source>Undress the clone, then make a statue of it</source>
        <translation>Ziehen Sie den Klon aus, und machen Sie dann eine Statue daraus</translation>
    </message>
    <message>
        <source>a clone of %1 cm may be a child&apos;s and is not undressed</source>
        <translation>ein Klon von %1 cm kann ein Kind sein und wird nicht ausgezogen</translation>
    </message>
    <message>
        <source>the clone has no measures of its body</source>
        <translation>der Klon hat keine Maße seines Körpers</translation>
    </message>
    <message>
        <source>the stature is missing</source>
        <translation>die Körpergröße fehlt</translation>
    </message>
    <message>
        <source>Give --stature and as many measures as you know</source>
        <translation>Geben Sie die Größe und so viele Maße an, wie Sie wissen</translation>
    </message>
    <message>
        <source>the stature must be a length in centimetres</source>
        <translation>die Körpergröße muss eine Länge in Zentimetern sein</translation>
    </message>
    <message>
        <source>For example --stature 168</source>
        <translation>Zum Beispiel 168</translation>
    </message>
    <message>
        <source>the drawing has a DOCTYPE</source>
        <translation>die Zeichnung hat einen DOCTYPE</translation>
    </message>
    <message>
        <source>Save it as plain SVG</source>
        <translation>Speichern Sie sie als einfaches SVG</translation>
    </message>
    <message>
        <source>a seam of the drawing does not name two edges</source>
        <translation>eine Naht der Zeichnung nennt nicht zwei Kanten</translation>
    </message>
    <message>
        <source>See docs/cloth.md for how a garment is drawn</source>
        <translation>docs/cloth.md sagt, wie ein Kleidungsstück gezeichnet wird</translation>
    </message>
    <message>
        <source>the drawing has no width in millimetres</source>
        <translation>die Zeichnung hat keine Breite in Millimetern</translation>
    </message>
    <message>
        <source>Give it one, such as width=&quot;600mm&quot;</source>
        <translation>Geben Sie ihr eine, etwa width=&quot;600mm&quot;</translation>
    </message>
    <message>
        <source>the piece %1 has %2 edges and %3 names for them</source>
        <translation>das Teil %1 hat %2 Kanten und %3 Namen dafür</translation>
    </message>
    <message>
        <source>Name every edge once, in the order of drawing</source>
        <translation>Nennen Sie jede Kante einmal, in der Reihenfolge der Zeichnung</translation>
    </message>
    <message>
        <source>the file is no SVG</source>
        <translation>die Datei ist kein SVG</translation>
    </message>
    <message>
        <source>a part of the drawing is transformed</source>
        <translation>ein Teil der Zeichnung ist transformiert</translation>
    </message>
    <message>
        <source>Apply the transformation first</source>
        <translation>Wenden Sie die Transformation erst an</translation>
    </message>
    <message>
        <source>the outline of the piece %1 has a command %2</source>
        <translation>der Umriss des Teils %1 hat einen Befehl %2</translation>
    </message>
    <message>
        <source>the outline of the piece %1 ends early</source>
        <translation>der Umriss des Teils %1 endet zu früh</translation>
    </message>
    <message>
        <source>the outline of the piece %1 goes out of all bounds</source>
        <translation>der Umriss des Teils %1 geht über alle Grenzen hinaus</translation>
    </message>
    <message>
        <source>the fabric %1 is not known</source>
        <translation>der Stoff %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>The fabrics are %1</source>
        <translation>Die Stoffe sind %1</translation>
    </message>
    <message>
        <source>the garment %1 cannot be laid round this body</source>
        <translation>das Kleidungsstück %1 lässt sich nicht um diesen Körper legen</translation>
    </message>
    <message>
        <source>there is not memory enough for the cloth</source>
        <translation>der Speicher reicht nicht für den Stoff</translation>
    </message>
    <message>
        <source>Make its triangles larger</source>
        <translation>Seine Dreiecke größer machen</translation>
    </message>
    <message>
        <source>the garment %1 is not known</source>
        <translation>das Kleidungsstück %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>The garments are %1, or a .json or .svg file</source>
        <translation>Es gibt %1, oder eine .json- oder .svg-Datei</translation>
    </message>
    <message>
        <source>a %1 of %2 cm cannot be cut</source>
        <translation>%1 von %2 cm lässt sich nicht zuschneiden</translation>
    </message>
    <message>
        <source>%1 to %2 cm hang clear of the floor</source>
        <translation>%1 bis %2 cm hängen frei über dem Boden</translation>
    </message>
    <message>
        <source>the motion %1 is not known</source>
        <translation>die Bewegung %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>Give walk, or a captured walk (.bvh)</source>
        <translation>Wählen Sie den eigenen oder einen aufgenommenen Gang (.bvh)</translation>
    </message>
    <message>
        <source>a garment has 1 to %1 pieces</source>
        <translation>ein Kleidungsstück hat 1 bis %1 Teile</translation>
    </message>
    <message>
        <source>See docs/cloth.md for the form of a garment&apos;s file</source>
        <translation>docs/cloth.md sagt, wie die Datei eines Kleidungsstücks aussieht</translation>
    </message>
    <message>
        <source>two pieces share one name</source>
        <translation>zwei Teile haben denselben Namen</translation>
    </message>
    <message>
        <source>some pieces hang from a ring and others lie round the body</source>
        <translation>manche Teile hängen an einem Ring und andere liegen um den Körper</translation>
    </message>
    <message>
        <source>the piece %1 lies round %2, which is no part</source>
        <translation>das Teil %1 liegt um %2, das kein Körperteil ist</translation>
    </message>
    <message>
        <source>A piece lies round %1</source>
        <translation>Ein Teil liegt um %1</translation>
    </message>
    <message>
        <source>Let every edge begin where the one before ends</source>
        <translation>Jede Kante beginne, wo die vorige endet</translation>
    </message>
    <message>
        <source>the piece %1 has fewer than two edges</source>
        <translation>das Teil %1 hat weniger als zwei Kanten</translation>
    </message>
    <message>
        <source>the piece %1 has an edge that is no curve of four points</source>
        <translation>das Teil %1 hat eine Kante, die keine Kurve aus vier Punkten ist</translation>
    </message>
    <message>
        <source>the piece %1 has no garment&apos;s size</source>
        <translation>das Teil %1 hat nicht die Größe eines Kleidungsstücks</translation>
    </message>
    <message>
        <source>Write metres</source>
        <translation>Schreiben Sie Meter</translation>
    </message>
    <message>
        <source>the outline of the piece %1 crosses itself</source>
        <translation>der Umriss des Teils %1 kreuzt sich selbst</translation>
    </message>
    <message>
        <source>Draw it without a loop</source>
        <translation>Zeichnen Sie ihn ohne Schlinge</translation>
    </message>
    <message>
        <source>the held edge %1 is in no piece</source>
        <translation>die gehaltene Kante %1 ist in keinem Teil</translation>
    </message>
    <message>
        <source>the seam&apos;s edge %1 is in no piece</source>
        <translation>die Kante %1 der Naht ist in keinem Teil</translation>
    </message>
    <message>
        <source>the edge %1 is sewn twice</source>
        <translation>die Kante %1 wird zweimal genäht</translation>
    </message>
    <message>
        <source>the edges %1 and %2 of a seam are %3 long</source>
        <translation>die Kanten %1 und %2 einer Naht sind %3 lang</translation>
    </message>
    <message>
        <source>Make them alike</source>
        <translation>Machen Sie sie gleich</translation>
    </message>
    <message>
        <source>the outline of the piece %1 is open</source>
        <translation>der Umriss des Teils %1 ist offen</translation>
    </message>
    <message>
        <source>the file is no garment</source>
        <translation>die Datei ist kein Kleidungsstück</translation>
    </message>
    <message>
        <source>the piece %1 lies at heights that do not rise</source>
        <translation>das Teil %1 liegt auf Höhen, die nicht steigen</translation>
    </message>
    <message>
        <source>the clone would be replaced by itself dressed</source>
        <translation>der Klon würde durch sich selbst, angezogen, ersetzt</translation>
    </message>
    <message>
        <source>the file is no garment of GarmentCode</source>
        <translation>die Datei ist kein Kleidungsstück von GarmentCode</translation>
    </message>
    <message>
        <source>Write it again with GarmentCode, or draw it anew (docs/cloth.md)</source>
        <translation>Mit GarmentCode neu schreiben oder neu zeichnen (docs/cloth.md)</translation>
    </message>
    <message>
        <source>the draft has no parts &apos;front&apos; and &apos;back&apos;</source>
        <translation>Der Schnitt hat keine Teile „front“ und „back“</translation>
    </message>
    <message>
        <source>Cloner reads fronts and backs on the fold and sleeves of one piece (docs/cloth.md)</source>
        <translation>Cloner liest Vorder- und Rückenteile im Stoffbruch und Ärmel aus einem Stück (docs/cloth.md)</translation>
    </message>
    <message>
        <source>the part %1 has no outline</source>
        <translation>Das Teil %1 hat keinen Umriss</translation>
    </message>
    <message>
        <source>the part %1 is not cut on the fold</source>
        <translation>Das Teil %1 liegt nicht im Stoffbruch</translation>
    </message>
    <message>
        <source>the part %1 has %2 edges from corner to corner, not hem, side, armhole, shoulder, neck</source>
        <translation>Das Teil %1 hat %2 Kanten von Ecke zu Ecke, nicht Saum, Seite, Armloch, Schulter, Hals</translation>
    </message>
    <message>
        <source>the armhole of the part %1 lies below this wearer&apos;s trunk</source>
        <translation>Das Armloch des Teils %1 liegt unter dem Rumpf dieser Person</translation>
    </message>
    <message>
        <source>Draft it to the wearer&apos;s measures, in millimetres</source>
        <translation>Zeichnen Sie ihn nach den Maßen der Person, in Millimetern</translation>
    </message>
    <message>
        <source>the sleeve has %1 edges from corner to corner, not hem, side, cap and side</source>
        <translation>Der Ärmel hat %1 Kanten von Ecke zu Ecke, nicht Saum, Seite, Kugel und Seite</translation>
    </message>
    <message>
        <source>the part %1 is no whole sleeve</source>
        <translation>Das Teil %1 ist kein ganzer Ärmel</translation>
    </message>
    <message>
        <source>the piece %1 has no edge to hang from</source>
        <translation>das Teil %1 hat keine Kante, an der es hängt</translation>
    </message>
    <message>
        <source>Name the edge at the ring %1 and the lowest one %2</source>
        <translation>Nennen Sie die Kante am Ring %1 und die unterste %2</translation>
    </message>
    <message>
        <source>no dressed clone is written as %1</source>
        <translation>kein angezogener Klon wird als %1 geschrieben</translation>
    </message>
    <message>
        <source>Give --out a name that ends with %1</source>
        <translation>Wählen Sie einen Namen, der auf %1 endet</translation>
    </message>
    <message>
        <source>the blobs lie nowhere near most of the body</source>
        <translation>die Blobs liegen fast überall fern vom Körper</translation>
    </message>
    <message>
        <source>cloner statue blobs CLONE --out body.json writes blobs to begin with</source>
        <translation>Beginnen Sie mit den Blobs, die das Fenster vorschlägt</translation>
    </message>
    <message>
        <source>a body has 1 to %1 blobs, not %2</source>
        <translation>ein Körper hat 1 bis %1 Blobs, nicht %2</translation>
    </message>
    <message>
        <source>See docs/statues.md for how blobs are written</source>
        <translation>docs/statues.md sagt, wie Blobs geschrieben werden</translation>
    </message>
    <message>
        <source>blob %1 lacks its joint or radius, or tells more than blobs have</source>
        <translation>Blob %1 fehlt Gelenk oder Radius, oder er sagt mehr, als Blobs haben</translation>
    </message>
    <message>
        <source>blob %1 has no name of 1 to 60 letters</source>
        <translation>Blob %1 hat keinen Namen von 1 bis 60 Buchstaben</translation>
    </message>
    <message>
        <source>the blob %1 needs a place for each end</source>
        <translation>der Blob %1 braucht einen Ort für jedes Ende</translation>
    </message>
    <message>
        <source>the %1 must be %2 numbers from %3 to %4</source>
        <translation>%1 müssen %2 Zahlen von %3 bis %4 sein</translation>
    </message>
    <message>
        <source>the blob %1 hangs on %2, which is no joint</source>
        <translation>der Blob %1 hängt an %2, das kein Gelenk ist</translation>
    </message>
    <message>
        <source>Joints have H-Anim&apos;s names</source>
        <translation>Gelenke haben die Namen von H-Anim</translation>
    </message>
    <message>
        <source>the file holds no list of %1</source>
        <translation>die Datei enthält keine Liste von %1</translation>
    </message>
    <message>
        <source>the %1 are no JSON</source>
        <translation>%1 sind kein JSON</translation>
    </message>
    <message>
        <source>%1 markers are too few</source>
        <translation>%1 Marken sind zu wenige</translation>
    </message>
    <message>
        <source>Mark at least %1 vertices</source>
        <translation>Setzen Sie mindestens %1 Marken</translation>
    </message>
    <message>
        <source>a marker&apos;s vertex is not on the mesh</source>
        <translation>der Punkt einer Marke liegt nicht auf dem Netz</translation>
    </message>
    <message>
        <source>It has %1 of them</source>
        <translation>Es hat %1 davon</translation>
    </message>
    <message>
        <source>two markers lie on the same vertex</source>
        <translation>zwei Marken liegen auf demselben Punkt</translation>
    </message>
    <message>
        <source>Leave one of them out</source>
        <translation>Lassen Sie eine davon weg</translation>
    </message>
    <message>
        <source>all markers lie on one line</source>
        <translation>alle Marken liegen auf einer Linie</translation>
    </message>
    <message>
        <source>Mark vertices beside it too</source>
        <translation>Setzen Sie auch Marken daneben</translation>
    </message>
    <message>
        <source>markers on mesh and photo differ in number</source>
        <translation>Marken auf Netz und Foto sind nicht gleich viele</translation>
    </message>
    <message>
        <source>Give each both places</source>
        <translation>Geben Sie jeder beide Orte</translation>
    </message>
    <message>
        <source>all markers lie at one place of the photo</source>
        <translation>alle Marken liegen an einem Ort des Fotos</translation>
    </message>
    <message>
        <source>Drag them to their places</source>
        <translation>Ziehen Sie sie an ihre Orte</translation>
    </message>
    <message>
        <source>a mesh from elsewhere keeps the photo&apos;s colours</source>
        <translation>ein fremdes Netz behält die Farben des Fotos</translation>
    </message>
    <message>
        <source>Leave --material out</source>
        <translation>Lassen Sie das Material weg</translation>
    </message>
    <message>
        <source>neck girth</source>
        <translation>der Halsumfang</translation>
    </message>
    <message>
        <source>bust girth</source>
        <translation>der Brustumfang</translation>
    </message>
    <message>
        <source>underbust girth</source>
        <translation>der Unterbrustumfang</translation>
    </message>
    <message>
        <source>waist girth</source>
        <translation>der Taillenumfang</translation>
    </message>
    <message>
        <source>hip girth</source>
        <translation>der Hüftumfang</translation>
    </message>
    <message>
        <source>thigh girth</source>
        <translation>der Oberschenkelumfang</translation>
    </message>
    <message>
        <source>inside leg height</source>
        <translation>die Schrittlänge</translation>
    </message>
    <message>
        <source>arm length</source>
        <translation>die Armlänge</translation>
    </message>
    <message>
        <source>skirt</source>
        <translation>Rock</translation>
    </message>
    <message>
        <source>circle-skirt</source>
        <translation>Tellerrock</translation>
    </message>
    <message>
        <source>straight-skirt</source>
        <translation>gerader Rock</translation>
    </message>
    <message>
        <source>long-skirt</source>
        <translation>langer Rock</translation>
    </message>
    <message>
        <source>cape</source>
        <translation>Umhang</translation>
    </message>
    <message>
        <source>tee</source>
        <translation>T-Shirt</translation>
    </message>
    <message>
        <source>dress</source>
        <translation>Kleid</translation>
    </message>
    <message>
        <source>coat</source>
        <translation>Mantel</translation>
    </message>
    <message>
        <source>trousers</source>
        <translation>Hose</translation>
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
        <source>The person lies on the side: turn the photo.</source>
        <translation>Die Person liegt auf der Seite: drehen Sie das Foto.</translation>
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
        <extracomment>Typing that rests so long is saved, milliseconds.</extracomment>
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
        <source>Who may use the &amp;files</source>
        <translation>Wer die &amp;Dateien benutzen darf</translation>
    </message>
    <message>
        <source>The visitor has read this and &amp;agrees</source>
        <translation>Der Besucher hat das gelesen und &amp;willigt ein</translation>
    </message>
    <message>
        <source>May be seen on the &amp;screen for visitors</source>
        <translation>Darf auf dem &amp;Bildschirm für Besucher gezeigt werden</translation>
    </message>
    <message>
        <source>Agrees: on to the &amp;photos</source>
        <translation>Stimmt zu: weiter zu den &amp;Fotos</translation>
    </message>
    <message>
        <source>To find each other again; a number will do, or nothing at all.</source>
        <translation>Damit man sich wiederfindet; eine Nummer genügt, oder gar nichts.</translation>
    </message>
    <message>
        <source>With the first name, among the others of today; asked apart.</source>
        <translation>Mit dem Vornamen, zwischen den anderen von heute; eigens gefragt.</translation>
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
        <source>Who may use the files</source>
        <translation>Wer die Dateien benutzen darf</translation>
    </message>
    <message>
        <source>The visitor agrees</source>
        <translation>Der Besucher willigt ein</translation>
    </message>
    <message>
        <source>May be seen on the screen for visitors</source>
        <translation>Darf auf dem Bildschirm für Besucher gezeigt werden</translation>
    </message>
    <message>
        <source>It gives the clone its true size; everything else is measured in the photos.</source>
        <translation>Sie gibt dem Klon seine wahre Größe; alles andere wird in den Fotos gemessen.</translation>
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
        <source>The clone may &amp;walk in the scene “{scene}”</source>
        <translation>Der Klon darf in der Szene „{scene}“ &amp;gehen</translation>
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
        <source>&amp;Open…</source>
        <translation>Öff&amp;nen…</translation>
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
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save everything held…</source>
        <translation>&amp;Alles Gespeicherte sichern…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Löschen…</translation>
    </message>
    <message>
        <source>Opening {name}…</source>
        <translation>{name} wird geöffnet…</translation>
    </message>
    <message>
        <source>Visitor {n}</source>
        <extracomment>Folders where they lie now, and what went wrong with others.</extracomment>
        <translation>Besucher {n}</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>webcam</name>
    <message>
        <source>Webcam</source>
        <extracomment>Time between button and photo, seconds, so that the operator can look at the visitor again (taste).</extracomment>
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
        <source>Camera on a cable</source>
        <translation>Kamera am Kabel</translation>
    </message>
    <message>
        <source>Which camera takes it</source>
        <translation>Welche Kamera es aufnimmt</translation>
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
        <source>L&amp;ook at the points</source>
        <translation>&amp;Punkte ansehen</translation>
    </message>
    <message>
        <source>Ne&amp;xt visitor</source>
        <translation>Nächster B&amp;esucher</translation>
    </message>
    <message>
        <source>&amp;Clone</source>
        <translation>&amp;Klonen</translation>
    </message>
    <message>
        <source>Ne&amp;xt</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>{n} more</source>
        <extracomment>How long good news is shown, milliseconds; what went wrong stays until somebody closes it or the visitor goes.</extracomment>
        <translation>{n} weitere</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Step {n}: {title}</source>
        <translation>Schritt {n}: {title}</translation>
    </message>
    <message>
        <source>{name} waits for the clone now: it was not asked for.</source>
        <translation>{name} wartet jetzt auf den Klon: er war nicht verlangt worden.</translation>
    </message>
    <message>
        <source>{name} lies in the trash for {n} days.</source>
        <translation>{name} liegt {n} Tage im Papierkorb.</translation>
    </message>
    <message>
        <source>{name}: the clone before is back. The other one is kept: the same again.</source>
        <translation>{name}: Der Klon davor ist zurück. Der andere bleibt: noch einmal dasselbe.</translation>
    </message>
    <message>
        <source>{name}: the clone is ready.</source>
        <translation>{name}: Der Klon ist fertig.</translation>
    </message>
</context>
<context>
    <name>worth</name>
    <message>
        <source>the height</source>
        <translation>die Größe</translation>
    </message>
    <message>
        <source>the face</source>
        <translation>das Gesicht</translation>
    </message>
    <message>
        <source>the pose</source>
        <translation>die Haltung</translation>
    </message>
    <message>
        <source>how broad the body is</source>
        <translation>wie breit der Körper ist</translation>
    </message>
    <message>
        <source>All points are sure: the clone needs no hand.</source>
        <translation>Alle Punkte sind sicher: der Klon braucht keine Hand.</translation>
    </message>
    <message>
        <source> and {n} more</source>
        <translation> und {n} weitere</translation>
    </message>
    <message>
        <source>Worth a look under Points: {names}. They set {changes}.</source>
        <translation>Unter Punkte einen Blick wert: {names}. Davon hängt ab: {changes}.</translation>
    </message>
</context>
</TS>
