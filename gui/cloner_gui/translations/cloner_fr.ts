<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>PhotoView</name>
    <message>
        <source>Remove this outline point</source>
        <translation>Retirer ce point du contour</translation>
    </message>
    <message>
        <source>Use the proposal for %1 again</source>
        <translation>Reprendre la proposition pour %1</translation>
    </message>
    <message>
        <source>Add an outline point here</source>
        <translation>Ajouter ici un point de contour</translation>
    </message>
</context>
<context>
    <name>Preview</name>
    <message>
        <source>The clone in three dimensions</source>
        <translation>Le clone en trois dimensions</translation>
    </message>
    <message>
        <source>Press Clone: after about a minute the person stands here.</source>
        <translation>Appuyez sur Cloner : après une minute environ, la personne est là.</translation>
    </message>
    <message>
        <source>This machine cannot draw in 3-D</source>
        <translation>Cet ordinateur ne peut pas dessiner en 3D</translation>
    </message>
</context>
<context>
    <name>SmallPhoto</name>
    <message numerus="yes">
        <source>%n doubtful point(s)</source>
        <translation>
            <numerusform>%n point douteux</numerusform>
            <numerusform>%n points douteux</numerusform>
        </translation>
    </message>
    <message>
        <source>no points yet</source>
        <translation>pas encore de points</translation>
    </message>
</context>
<context>
    <name>blobs</name>
    <message>
        <source>belly</source>
        <translation>ventre</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>taille</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>torse</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>cou</translation>
    </message>
    <message>
        <source>pelvis</source>
        <translation>bassin</translation>
    </message>
    <message>
        <source>chest, across</source>
        <translation>torse, en travers</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>épaules</translation>
    </message>
    <message>
        <source>buttock</source>
        <translation>fesse</translation>
    </message>
    <message>
        <source>breast</source>
        <translation>sein</translation>
    </message>
    <message>
        <source>shoulder&apos;s muscle</source>
        <translation>muscle de l&apos;épaule</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>cuisse</translation>
    </message>
    <message>
        <source>lower leg</source>
        <translation>jambe</translation>
    </message>
    <message>
        <source>calf</source>
        <translation>mollet</translation>
    </message>
    <message>
        <source>kneecap</source>
        <translation>rotule</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>bras</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>avant-bras</translation>
    </message>
</context>
<context>
    <name>clone</name>
    <message>
        <source>Clone</source>
        <translation>Cloner</translation>
    </message>
    <message>
        <source>Clone first.</source>
        <translation>Clonez d’abord.</translation>
    </message>
    <message>
        <source>The clone is being made; the next visitor can come.</source>
        <extracomment>Stages that the five parts of the work end with, in order; between them the operator sees which part is under way.</extracomment>
        <translation>Le clone est en cours ; le visiteur suivant peut venir.</translation>
    </message>
    <message>
        <source>Sho&amp;w it off</source>
        <translation>&amp;Présenter</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>The clone be&amp;fore</source>
        <translation>Clone &amp;précédent</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>Cheveux</translation>
    </message>
    <message>
        <source>Texture and files</source>
        <translation>Texture et fichiers</translation>
    </message>
    <message>
        <source>Press Clone: after about a minute the person stands here.</source>
        <translation>Appuyez sur Cloner : après une minute environ, la personne est là.</translation>
    </message>
    <message>
        <source>C&amp;lone again</source>
        <translation>C&amp;loner encore</translation>
    </message>
    <message>
        <source>C&amp;lone</source>
        <translation>C&amp;loner</translation>
    </message>
    <message>
        <source>Points or height were changed since: what is seen and taken away is the clone before.</source>
        <translation>Des points ou la taille ont changé depuis : on voit et on emporte le clone d’avant.</translation>
    </message>
</context>
<context>
    <name>consent</name>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept for {days} days and then deleted. I can have everything deleted at any time.</source>
        <extracomment>What visitors agree to, unless the event has a text of its own.</extracomment>
        <translation>J’accepte que des photos de moi soient prises ici, qu’une image en trois dimensions en soit faite sur cet ordinateur et que les deux soient gardées {days} jours puis supprimées. Je peux à tout moment faire tout supprimer.</translation>
    </message>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept until I have them deleted. I can have everything deleted at any time.</source>
        <extracomment>The same where an event keeps its visitors until somebody deletes them.</extracomment>
        <translation>J’accepte que des photos de moi soient prises ici, qu’une image en trois dimensions en soit faite sur cet ordinateur et que les deux soient gardées jusqu’à ce que je les fasse supprimer. Je peux à tout moment faire tout supprimer.</translation>
    </message>
</context>
<context>
    <name>day</name>
    <message>
        <source>{day}: {n} visitors, {m} clones.</source>
        <translation>{day} : {n} visiteurs, {m} clones.</translation>
    </message>
    <message>
        <source>{n} of them lie in the trash.</source>
        <translation>{n} d’entre eux sont dans la corbeille.</translation>
    </message>
    <message>
        <source>In the queue {m} minutes in the middle, {l} at most.</source>
        <translation>Dans la file {m} minutes en médiane, {l} au plus.</translation>
    </message>
    <message>
        <source>Refused: {reasons}.</source>
        <translation>Refusés : {reasons}.</translation>
    </message>
</context>
<context>
    <name>fabrics</name>
    <message>
        <source>Silk</source>
        <translation>Soie</translation>
    </message>
    <message>
        <source>Cotton</source>
        <translation>Coton</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>Lin</translation>
    </message>
    <message>
        <source>Wool</source>
        <translation>Laine</translation>
    </message>
    <message>
        <source>Denim</source>
        <translation>Denim</translation>
    </message>
    <message>
        <source>Burlap</source>
        <translation>Toile de jute</translation>
    </message>
</context>
<context>
    <name>formats</name>
    <message>
        <source>GLB: games, web, telephone</source>
        <translation>GLB : jeux, web, téléphone</translation>
    </message>
    <message>
        <source>VRML97: H-Anim players</source>
        <translation>VRML97 : lecteurs H-Anim</translation>
    </message>
    <message>
        <source>X3D: H-Anim with one skin</source>
        <translation>X3D : H-Anim à peau unique</translation>
    </message>
    <message>
        <source>VRM: virtual meeting places</source>
        <translation>VRM : lieux de rencontre virtuels</translation>
    </message>
    <message>
        <source>OBJ: any 3-D program</source>
        <translation>OBJ : tout logiciel 3D</translation>
    </message>
    <message>
        <source>PLY: 3-D printing</source>
        <translation>PLY : impression 3D</translation>
    </message>
</context>
<context>
    <name>gallery</name>
    <message>
        <source>Everybody of today</source>
        <extracomment>What is shown: everybody, the cloned, those without a clone, who lies in the trash.</extracomment>
        <translation>Tout le monde du jour</translation>
    </message>
    <message>
        <source>Name or number</source>
        <translation>Nom ou numéro</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>tout le monde</translation>
    </message>
    <message>
        <source>with a clone</source>
        <translation>avec un clone</translation>
    </message>
    <message>
        <source>without a clone</source>
        <translation>sans clone</translation>
    </message>
    <message>
        <source>in the trash</source>
        <translation>dans la corbeille</translation>
    </message>
    <message>
        <source>Search by name or number</source>
        <translation>Chercher par nom ou numéro</translation>
    </message>
    <message>
        <source>Who is shown</source>
        <translation>Qui est montré</translation>
    </message>
    <message>
        <source>Visitors of this event</source>
        <translation>Visiteurs de cet événement</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Clone &amp;again</source>
        <translation>Cloner &amp;encore</translation>
    </message>
    <message>
        <source>The clone be&amp;fore</source>
        <translation>Clone &amp;précédent</translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation>&amp;Jeter</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>&amp;Récupérer</translation>
    </message>
    <message>
        <source>&amp;Delete for good…</source>
        <translation>&amp;Supprimer pour de bon…</translation>
    </message>
    <message>
        <source>Save the &amp;numbers of the days…</source>
        <translation>Enregistrer les chiffres des &amp;jours…</translation>
    </message>
    <message>
        <source>{n} visitors, {m} with a clone</source>
        <translation>{n} visiteurs, {m} avec un clone</translation>
    </message>
    <message>
        <source>deleted for good on {when}</source>
        <translation>supprimé pour de bon le {when}</translation>
    </message>
</context>
<context>
    <name>garments</name>
    <message>
        <source>Skirt</source>
        <translation>Jupe</translation>
    </message>
    <message>
        <source>Circle skirt</source>
        <translation>Jupe cercle</translation>
    </message>
    <message>
        <source>Straight skirt</source>
        <translation>Jupe droite</translation>
    </message>
    <message>
        <source>Long skirt</source>
        <translation>Jupe longue</translation>
    </message>
    <message>
        <source>Cape</source>
        <translation>Cape</translation>
    </message>
    <message>
        <source>T-shirt</source>
        <translation>T-shirt</translation>
    </message>
    <message>
        <source>Dress</source>
        <translation>Robe</translation>
    </message>
    <message>
        <source>Coat</source>
        <translation>Manteau</translation>
    </message>
    <message>
        <source>Trousers</source>
        <translation>Pantalon</translation>
    </message>
    <message>
        <source>GLB: the clone walks in it</source>
        <extracomment>What a dressed clone is written as, by file ending; a folder has none.</extracomment>
        <translation>GLB : le clone marche avec</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>Film MP4</translation>
    </message>
    <message>
        <source>WebP film</source>
        <translation>Film WebP</translation>
    </message>
    <message>
        <source>GIF film</source>
        <translation>Film GIF</translation>
    </message>
    <message>
        <source>USD: the garment alone</source>
        <translation>USD : le vêtement seul</translation>
    </message>
    <message>
        <source>PC2 and OBJ: the garment alone</source>
        <translation>PC2 et OBJ : le vêtement seul</translation>
    </message>
    <message>
        <source>Folder: a clone in it, whose cloth flows in crowds</source>
        <translation>Dossier : un clone, dont le tissu flotte dans les foules</translation>
    </message>
</context>
<context>
    <name>hints</name>
    <message>
        <source>Your own point on the outline: drag it on to the border of the person.</source>
        <extracomment>Hint for every point whose name, without its side, begins so; the longest beginning wins.</extracomment>
        <translation>Votre point de contour : glissez-le sur le bord de la personne.</translation>
    </message>
    <message>
        <source>Highest point of the skull: under the hair, not on top of it.</source>
        <translation>Point le plus haut du crâne : sous les cheveux, pas dessus.</translation>
    </message>
    <message>
        <source>Lowest edge of the shoe or foot: it sets the height of the person.</source>
        <translation>Bord inférieur de la chaussure ou du pied : il fixe la taille de la personne.</translation>
    </message>
    <message>
        <source>Foremost point of the shoe or foot.</source>
        <translation>Point le plus avancé de la chaussure ou du pied.</translation>
    </message>
    <message>
        <source>Hindmost point of the shoe or foot.</source>
        <translation>Point le plus reculé de la chaussure ou du pied.</translation>
    </message>
    <message>
        <source>Outline at the narrowest place of the trunk.</source>
        <translation>Contour à l’endroit le plus étroit du tronc.</translation>
    </message>
    <message>
        <source>Outline at the widest place of the hips.</source>
        <translation>Contour à l’endroit le plus large des hanches.</translation>
    </message>
    <message>
        <source>Outline of the leg at the middle of the kneecap.</source>
        <translation>Contour de la jambe au milieu de la rotule.</translation>
    </message>
    <message>
        <source>Outline of the leg at its narrowest place above the foot.</source>
        <translation>Contour de la jambe à l’endroit le plus étroit au-dessus du pied.</translation>
    </message>
    <message>
        <source>Outline of the lower leg where the calf is thickest.</source>
        <translation>Contour de la jambe là où le mollet est le plus épais.</translation>
    </message>
    <message>
        <source>Outline of the arm at the bend of the elbow.</source>
        <translation>Contour du bras au pli du coude.</translation>
    </message>
    <message>
        <source>Outline of the arm at its narrowest place before the hand.</source>
        <translation>Contour du bras à l’endroit le plus étroit avant la main.</translation>
    </message>
    <message>
        <source>Outline where the shoulder turns down into the arm.</source>
        <translation>Contour là où l’épaule descend vers le bras.</translation>
    </message>
    <message>
        <source>Outline where the neck turns into the shoulder.</source>
        <translation>Contour là où le cou rejoint l’épaule.</translation>
    </message>
    <message>
        <source>Outline of the neck at half its height.</source>
        <translation>Contour du cou à mi-hauteur.</translation>
    </message>
    <message>
        <source>Where the arm meets the trunk: the end of the gap between them.</source>
        <translation>Là où le bras rejoint le tronc : la fin de l’espace entre eux.</translation>
    </message>
    <message>
        <source>Where the legs meet: the top of the gap between them.</source>
        <translation>Là où les jambes se rejoignent : le haut de l’espace entre elles.</translation>
    </message>
    <message>
        <source>Foremost outline of the chest.</source>
        <translation>Contour le plus avancé de la poitrine.</translation>
    </message>
    <message>
        <source>Foremost outline of the belly.</source>
        <translation>Contour le plus avancé du ventre.</translation>
    </message>
    <message>
        <source>Hindmost outline of the upper back.</source>
        <translation>Contour le plus reculé du haut du dos.</translation>
    </message>
    <message>
        <source>Hindmost outline of the seat.</source>
        <translation>Contour le plus reculé des fesses.</translation>
    </message>
    <message>
        <source>Outline of the thigh at half its length.</source>
        <translation>Contour de la cuisse à mi-longueur.</translation>
    </message>
    <message>
        <source>Middle of the joint inside the limb: where it bends, not on the outline.</source>
        <translation>Milieu de l’articulation : là où elle plie, pas sur le contour.</translation>
    </message>
    <message>
        <source>Middle of the pupil.</source>
        <translation>Milieu de la pupille.</translation>
    </message>
    <message>
        <source>Corner of the eye towards the nose.</source>
        <translation>Coin de l’œil côté nez.</translation>
    </message>
    <message>
        <source>Corner of the eye towards the ear.</source>
        <translation>Coin de l’œil côté oreille.</translation>
    </message>
    <message>
        <source>Edge of the upper lid, above the pupil.</source>
        <translation>Bord de la paupière supérieure, au-dessus de la pupille.</translation>
    </message>
    <message>
        <source>Edge of the lower lid, below the pupil.</source>
        <translation>Bord de la paupière inférieure, sous la pupille.</translation>
    </message>
    <message>
        <source>Corner of the closed mouth.</source>
        <translation>Coin de la bouche fermée.</translation>
    </message>
    <message>
        <source>Upper edge of the upper lip, in the middle.</source>
        <translation>Bord supérieur de la lèvre supérieure, au milieu.</translation>
    </message>
    <message>
        <source>Lower edge of the lower lip, in the middle.</source>
        <translation>Bord inférieur de la lèvre inférieure, au milieu.</translation>
    </message>
    <message>
        <source>Middle of the line between the closed lips.</source>
        <translation>Milieu de la ligne entre les lèvres fermées.</translation>
    </message>
    <message>
        <source>Outermost point of the wing of the nose.</source>
        <translation>Point le plus extérieur de l’aile du nez.</translation>
    </message>
    <message>
        <source>Tip of the nose; in the side photo its foremost point.</source>
        <translation>Bout du nez ; sur la photo de côté, son point le plus avancé.</translation>
    </message>
    <message>
        <source>Deepest place of the root of the nose, between the eyes.</source>
        <translation>Creux de la racine du nez, entre les yeux.</translation>
    </message>
    <message>
        <source>Foremost place of the forehead between the brows.</source>
        <translation>Endroit le plus avancé du front entre les sourcils.</translation>
    </message>
    <message>
        <source>Where the nose meets the upper lip, in the middle.</source>
        <translation>Là où le nez rejoint la lèvre supérieure, au milieu.</translation>
    </message>
    <message>
        <source>Foremost point of the chin.</source>
        <translation>Point le plus avancé du menton.</translation>
    </message>
    <message>
        <source>Lowest point of the chin.</source>
        <translation>Point le plus bas du menton.</translation>
    </message>
    <message>
        <source>Where the hair begins above the forehead.</source>
        <translation>Là où commencent les cheveux au-dessus du front.</translation>
    </message>
    <message>
        <source>Highest point of the ear.</source>
        <translation>Point le plus haut de l’oreille.</translation>
    </message>
    <message>
        <source>Lowest point of the earlobe.</source>
        <translation>Point le plus bas du lobe.</translation>
    </message>
    <message>
        <source>Hindmost point of the ear.</source>
        <translation>Point le plus reculé de l’oreille.</translation>
    </message>
    <message>
        <source>Point of the ear farthest from the head.</source>
        <translation>Point de l’oreille le plus éloigné de la tête.</translation>
    </message>
    <message>
        <source>Drag a point to its place, or press Tab: the least sure point comes first.</source>
        <translation>Glissez un point à sa place, ou appuyez sur Tab : le moins sûr vient d’abord.</translation>
    </message>
    <message>
        <source>%1 % sure</source>
        <translation>sûr à %1 %</translation>
    </message>
    <message>
        <source>placed by you</source>
        <translation>placé par vous</translation>
    </message>
    <message>
        <source>outline point</source>
        <translation>point de contour</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sûr</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteux</translation>
    </message>
    <message>
        <source>outline in the photo</source>
        <translation>contour sur la photo</translation>
    </message>
    <message>
        <source>outline of the clone</source>
        <translation>contour du clone</translation>
    </message>
</context>
<context>
    <name>keepsakes</name>
    <message>
        <source>Card and e-mail</source>
        <translation>Carte et e-mail</translation>
    </message>
    <message>
        <source>Pr&amp;int the card…</source>
        <translation>&amp;Imprimer la carte…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the card as a file…</source>
        <translation>Enregistrer la carte dans un fichier…</translation>
    </message>
    <message>
        <source>E-&amp;mail as a draft…</source>
        <translation>&amp;Brouillon d’e-mail…</translation>
    </message>
    <message>
        <source>The card as it will be printed</source>
        <translation>La carte telle qu’elle sera imprimée</translation>
    </message>
    <message>
        <source>Your files: {folder}</source>
        <translation>Vos fichiers : {folder}</translation>
    </message>
    <message>
        <source>Scan to see yourself turn and to take your files home.</source>
        <translation>Scannez pour vous voir tourner et emporter vos fichiers.</translation>
    </message>
</context>
<context>
    <name>kiosk</name>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Number of the operator</source>
        <translation>Numéro de l’opérateur</translation>
    </message>
    <message>
        <source>Too many wrong numbers: wait half a minute.</source>
        <translation>Trop de mauvais numéros : attendez une demi-minute.</translation>
    </message>
    <message>
        <source>This is not the number.</source>
        <translation>Ce n’est pas le numéro.</translation>
    </message>
    <message>
        <source>Give the operator a number under Event, Settings first.</source>
        <translation>Donnez d’abord un numéro à l’opérateur sous Événement, Réglages.</translation>
    </message>
</context>
<context>
    <name>licences</name>
    <message>
        <source>the visitor alone</source>
        <extracomment>Who may use a visitor&apos;s files, by licence; and what that means.</extracomment>
        <translation>le visiteur seul</translation>
    </message>
    <message>
        <source>visitor and event</source>
        <translation>visiteur et événement</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>tout le monde</translation>
    </message>
    <message>
        <source>Nobody else may use the files or earn money with them.</source>
        <translation>Personne d’autre ne peut utiliser les fichiers ni gagner d’argent avec eux.</translation>
    </message>
    <message>
        <source>The event may use the files too, also in its advertising.</source>
        <translation>L’événement peut aussi utiliser les fichiers, y compris dans sa publicité.</translation>
    </message>
    <message>
        <source>Everybody may use the files, change them and pass them on, but not earn money with them.</source>
        <translation>Tout le monde peut utiliser, modifier et transmettre les fichiers, mais sans gagner d’argent avec eux.</translation>
    </message>
</context>
<context>
    <name>mail</name>
    <message>
        <source>Your clone</source>
        <translation>Votre clone</translation>
    </message>
    <message>
        <source>Your clone from {event}</source>
        <translation>Votre clone de {event}</translation>
    </message>
    <message>
        <source>Hello,</source>
        <translation>Bonjour,</translation>
    </message>
    <message>
        <source>Hello {name},</source>
        <translation>Bonjour {name},</translation>
    </message>
    <message>
        <source>this is the clone that was made of your photos. Its picture is attached.</source>
        <translation>voici le clone réalisé à partir de vos photos. Son image est jointe.</translation>
    </message>
    <message>
        <source>As long as you are on the booth&apos;s network you can see it turn and take the files here:</source>
        <translation>Tant que vous êtes sur le réseau du stand, vous pouvez le voir tourner et prendre les fichiers ici :</translation>
    </message>
    <message>
        <source>If you want everything that is held of you deleted, answer this message or tell us.</source>
        <translation>Si vous voulez que tout ce qui est conservé de vous soit effacé, répondez à ce message ou dites-le-nous.</translation>
    </message>
    <message>
        <source>Thank you for your visit.</source>
        <translation>Merci de votre visite.</translation>
    </message>
</context>
<context>
    <name>materials</name>
    <message>
        <source>Stone</source>
        <translation>Pierre</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Argile</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronze</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Marbre</translation>
    </message>
    <message>
        <source>As photographed</source>
        <translation>Comme sur les photos</translation>
    </message>
    <message>
        <source>Arms hanging</source>
        <translation>Bras ballants</translation>
    </message>
    <message>
        <source>On guard</source>
        <translation>En garde</translation>
    </message>
    <message>
        <source>Hailing</source>
        <translation>Saluant</translation>
    </message>
</context>
<context>
    <name>measures</name>
    <message>
        <source>Height without shoes</source>
        <extracomment>What the sliders tell, in the order of the form; the stature and the measures of `cloner.bodies.telling.PRESETS`.</extracomment>
        <translation>Taille sans chaussures</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Poitrine</translation>
    </message>
    <message>
        <source>Waist</source>
        <translation>Tour de taille</translation>
    </message>
    <message>
        <source>Hips</source>
        <translation>Hanches</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Cou</translation>
    </message>
    <message>
        <source>Below the breast</source>
        <translation>Dessous de poitrine</translation>
    </message>
    <message>
        <source>Thigh</source>
        <translation>Cuisse</translation>
    </message>
    <message>
        <source>Inside leg</source>
        <translation>Entrejambe</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
</context>
<context>
    <name>menu</name>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>&amp;New visitor</source>
        <translation>&amp;Nouveau visiteur</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Réglages…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Kiosk (Ctrl+Shift+K)</source>
        <translation>&amp;Kiosque (Ctrl+Maj+K)</translation>
    </message>
    <message>
        <source>&amp;Gallery…</source>
        <translation>&amp;Galerie…</translation>
    </message>
    <message>
        <source>&amp;Screen for visitors</source>
        <translation>&amp;Écran des visiteurs</translation>
    </message>
    <message>
        <source>&amp;Effort…</source>
        <translation>&amp;Effort…</translation>
    </message>
    <message>
        <source>&amp;What is held…</source>
        <translation>&amp;Données conservées…</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>High &amp;contrast</source>
        <translation>&amp;Fort contraste</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Couleurs</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>&amp;Taille du texte</translation>
    </message>
    <message>
        <source>&amp;Big buttons</source>
        <translation>&amp;Gros boutons</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>&amp;Dress a clone…</source>
        <translation>&amp;Habiller un clone…</translation>
    </message>
    <message>
        <source>&amp;Body from measures…</source>
        <translation>&amp;Corps d&apos;après mesures…</translation>
    </message>
    <message>
        <source>&amp;Clone in stone…</source>
        <translation>Clone en &amp;pierre…</translation>
    </message>
    <message>
        <source>&amp;Photograph on a statue…</source>
        <translation>Photo sur une &amp;statue…</translation>
    </message>
    <message>
        <source>Body of b&amp;lobs…</source>
        <translation>Corps de &amp;blobs…</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>&amp;Événement</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>O&amp;perator</source>
        <translation>O&amp;pérateur</translation>
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
        <translation>coin intérieur de l’œil</translation>
    </message>
    <message>
        <source>outer corner of the eye</source>
        <translation>coin extérieur de l’œil</translation>
    </message>
    <message>
        <source>upper lid</source>
        <translation>paupière supérieure</translation>
    </message>
    <message>
        <source>lower lid</source>
        <translation>paupière inférieure</translation>
    </message>
    <message>
        <source>corner of the mouth</source>
        <translation>coin de la bouche</translation>
    </message>
    <message>
        <source>wing of the nose</source>
        <translation>aile du nez</translation>
    </message>
    <message>
        <source>pupil</source>
        <translation>pupille</translation>
    </message>
    <message>
        <source>top of the ear</source>
        <translation>haut de l’oreille</translation>
    </message>
    <message>
        <source>earlobe</source>
        <translation>lobe de l’oreille</translation>
    </message>
    <message>
        <source>outermost point of the ear</source>
        <translation>point extérieur de l’oreille</translation>
    </message>
    <message>
        <source>back of the ear</source>
        <translation>arrière de l’oreille</translation>
    </message>
    <message>
        <source>root of the nose</source>
        <translation>racine du nez</translation>
    </message>
    <message>
        <source>forehead between the brows</source>
        <translation>front entre les sourcils</translation>
    </message>
    <message>
        <source>tip of the nose</source>
        <translation>bout du nez</translation>
    </message>
    <message>
        <source>base of the nose</source>
        <translation>base du nez</translation>
    </message>
    <message>
        <source>upper lip</source>
        <translation>lèvre supérieure</translation>
    </message>
    <message>
        <source>middle of the mouth</source>
        <translation>milieu de la bouche</translation>
    </message>
    <message>
        <source>lower lip</source>
        <translation>lèvre inférieure</translation>
    </message>
    <message>
        <source>front of the chin</source>
        <translation>avant du menton</translation>
    </message>
    <message>
        <source>bottom of the chin</source>
        <translation>bas du menton</translation>
    </message>
    <message>
        <source>hairline</source>
        <translation>naissance des cheveux</translation>
    </message>
    <message>
        <source>top of the head</source>
        <translation>sommet de la tête</translation>
    </message>
    <message>
        <source>toe</source>
        <translation>orteil</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>taille</translation>
    </message>
    <message>
        <source>waist, front</source>
        <translation>taille, devant</translation>
    </message>
    <message>
        <source>waist, back</source>
        <translation>taille, derrière</translation>
    </message>
    <message>
        <source>hip</source>
        <translation>hanche</translation>
    </message>
    <message>
        <source>hip joint</source>
        <translation>articulation de la hanche</translation>
    </message>
    <message>
        <source>outside of the knee</source>
        <translation>genou, extérieur</translation>
    </message>
    <message>
        <source>inside of the knee</source>
        <translation>genou, intérieur</translation>
    </message>
    <message>
        <source>front of the knee</source>
        <translation>genou, devant</translation>
    </message>
    <message>
        <source>back of the knee</source>
        <translation>creux du genou</translation>
    </message>
    <message>
        <source>knee joint</source>
        <translation>articulation du genou</translation>
    </message>
    <message>
        <source>outside of the ankle</source>
        <translation>cheville, extérieur</translation>
    </message>
    <message>
        <source>inside of the ankle</source>
        <translation>cheville, intérieur</translation>
    </message>
    <message>
        <source>front of the ankle</source>
        <translation>cheville, devant</translation>
    </message>
    <message>
        <source>back of the ankle</source>
        <translation>cheville, derrière</translation>
    </message>
    <message>
        <source>ankle joint</source>
        <translation>articulation de la cheville</translation>
    </message>
    <message>
        <source>outside of the elbow</source>
        <translation>coude, extérieur</translation>
    </message>
    <message>
        <source>inside of the elbow</source>
        <translation>coude, intérieur</translation>
    </message>
    <message>
        <source>elbow joint</source>
        <translation>articulation du coude</translation>
    </message>
    <message>
        <source>outside of the wrist</source>
        <translation>poignet, extérieur</translation>
    </message>
    <message>
        <source>inside of the wrist</source>
        <translation>poignet, intérieur</translation>
    </message>
    <message>
        <source>wrist joint</source>
        <translation>articulation du poignet</translation>
    </message>
    <message>
        <source>end of the shoulder</source>
        <translation>bout de l’épaule</translation>
    </message>
    <message>
        <source>shoulder joint</source>
        <translation>articulation de l’épaule</translation>
    </message>
    <message>
        <source>bony tip of the shoulder</source>
        <translation>pointe osseuse de l’épaule</translation>
    </message>
    <message>
        <source>base of the neck</source>
        <translation>base du cou</translation>
    </message>
    <message>
        <source>front of the neck</source>
        <translation>cou, devant</translation>
    </message>
    <message>
        <source>back of the neck</source>
        <translation>cou, derrière</translation>
    </message>
    <message>
        <source>pit of the neck</source>
        <translation>creux du cou</translation>
    </message>
    <message>
        <source>nape</source>
        <translation>nuque</translation>
    </message>
    <message>
        <source>armpit</source>
        <translation>aisselle</translation>
    </message>
    <message>
        <source>sole</source>
        <translation>semelle</translation>
    </message>
    <message>
        <source>heel</source>
        <translation>talon</translation>
    </message>
    <message>
        <source>crotch</source>
        <translation>entrejambe</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>poitrine</translation>
    </message>
    <message>
        <source>chest, front</source>
        <translation>poitrine, devant</translation>
    </message>
    <message>
        <source>back</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>belly</source>
        <translation>ventre</translation>
    </message>
    <message>
        <source>seat</source>
        <translation>fesse</translation>
    </message>
    <message>
        <source>front of the thigh</source>
        <translation>cuisse, devant</translation>
    </message>
    <message>
        <source>back of the thigh</source>
        <translation>cuisse, derrière</translation>
    </message>
    <message>
        <source>outside of the thigh</source>
        <translation>cuisse, extérieur</translation>
    </message>
    <message>
        <source>inside of the thigh</source>
        <translation>cuisse, intérieur</translation>
    </message>
    <message>
        <source>calf</source>
        <translation>mollet</translation>
    </message>
    <message>
        <source>fingertip</source>
        <translation>bout du doigt</translation>
    </message>
    <message>
        <source>top of the skull</source>
        <translation>sommet du crâne</translation>
    </message>
    <message>
        <source>outline point</source>
        <translation>point du contour</translation>
    </message>
</context>
<context>
    <name>photos</name>
    <message>
        <source>Photos are still looked at.</source>
        <translation>Les photos sont encore examinées.</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Photos</translation>
    </message>
    <message>
        <source>Add the photos first.</source>
        <extracomment>Points are sought when photos have rested so long, milliseconds: looking at new ones comes first.</extracomment>
        <translation>Ajoutez d’abord les photos.</translation>
    </message>
    <message>
        <source>&amp;Add photos…</source>
        <translation>&amp;Ajouter des photos…</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Coller</translation>
    </message>
    <message>
        <source>Camera folder: {name}</source>
        <translation>Dossier de l’appareil : {name}</translation>
    </message>
    <message>
        <source>&amp;Camera folder…</source>
        <translation>&amp;Dossier de l’appareil…</translation>
    </message>
    <message>
        <source>&amp;Webcam…</source>
        <translation>&amp;Webcam…</translation>
    </message>
    <message>
        <source>Photos that appear in this folder are taken at once</source>
        <translation>Les photos qui apparaissent dans ce dossier sont prises aussitôt</translation>
    </message>
    <message>
        <source>Watch no camera folder any more</source>
        <translation>Ne plus surveiller de dossier d’appareil</translation>
    </message>
    <message>
        <source>Photos without a place</source>
        <translation>Photos sans place</translation>
    </message>
    <message>
        <source>Being looked at…</source>
        <translation>En cours d’examen…</translation>
    </message>
    <message>
        <source>✓ Good</source>
        <translation>✓ Bien</translation>
    </message>
    <message>
        <source>No consent is recorded: new photos are not stored.</source>
        <translation>Aucun consentement noté : les nouvelles photos ne sont pas conservées.</translation>
    </message>
    <message>
        <source>Looking at photos: {n} to go</source>
        <translation>Examen des photos : encore {n}</translation>
    </message>
    <message>
        <source>Photos of the visitor</source>
        <translation>Photos du visiteur</translation>
    </message>
    <message>
        <source>Folder where the camera drops its photos</source>
        <translation>Dossier où l’appareil dépose ses photos</translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation>Déposez une photo ici</translation>
    </message>
    <message>
        <source>What to do with {photo}</source>
        <translation>Que faire de {photo}</translation>
    </message>
    <message>
        <source>Return shows or chooses the photo, Space tells what else can be done.</source>
        <translation>Entrée montre ou choisit la photo, Espace dit ce qu’on peut faire d’autre.</translation>
    </message>
    <message>
        <source>See it large</source>
        <translation>Voir en grand</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Remplacer…</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Exchange with</source>
        <translation>Échanger avec</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Tourner à droite</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Use as…</source>
        <translation>Utiliser comme…</translation>
    </message>
    <message>
        <source>Photo {n} without a place</source>
        <translation>Photo {n} sans place</translation>
    </message>
    <message>
        <source>All five photos are here.</source>
        <translation>Les cinq photos sont là.</translation>
    </message>
    <message>
        <source>No photos yet.</source>
        <translation>Pas encore de photos.</translation>
    </message>
    <message>
        <source>A front photo is needed. Missing: {names}.</source>
        <translation>Une photo de face est nécessaire. Il manque : {names}.</translation>
    </message>
    <message>
        <source>Only the head can be cloned, on a body of matching build. Missing: {names}.</source>
        <translation>Seule la tête peut être clonée, sur un corps assorti. Il manque : {names}.</translation>
    </message>
    <message>
        <source>The face will come from the body photos and be coarse. Missing: {names}.</source>
        <translation>Le visage viendra des photos du corps et sera grossier. Il manque : {names}.</translation>
    </message>
    <message>
        <source>The clone will be less exact. Missing: {names}.</source>
        <translation>Le clone sera moins exact. Il manque : {names}.</translation>
    </message>
</context>
<context>
    <name>points</name>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Add photos first.</source>
        <extracomment>The clone&apos;s outline is drawn anew when the hand has rested so long: it costs as much as the preview.</extracomment>
        <translation>Ajoutez d’abord des photos.</translation>
    </message>
    <message>
        <source>{n} doubtful points are left after this one.</source>
        <translation>Après celui-ci, il reste {n} points douteux.</translation>
    </message>
    <message>
        <source>All doubtful points are seen: this one is sure. Press Clone.</source>
        <translation>Tous les points douteux sont vus : celui-ci est sûr. Appuyez sur Cloner.</translation>
    </message>
    <message>
        <source>Find points</source>
        <translation>Trouver les points</translation>
    </message>
    <message>
        <source>◀</source>
        <translation>◀</translation>
    </message>
    <message>
        <source>Point before (Shift+Tab)</source>
        <translation>Point précédent (Maj+Tab)</translation>
    </message>
    <message>
        <source>Next doubtful point</source>
        <translation>Point douteux suivant</translation>
    </message>
    <message>
        <source>Least sure first (Tab)</source>
        <translation>Le moins sûr d’abord (Tab)</translation>
    </message>
    <message>
        <source>Back to proposal</source>
        <translation>Revenir à la proposition</translation>
    </message>
    <message>
        <source>Undo this point (Delete)</source>
        <translation>Annuler ce point (Suppr)</translation>
    </message>
    <message>
        <source>Add outline point</source>
        <translation>Ajouter un point de contour</translation>
    </message>
    <message>
        <source>Or pull at it (Insert)</source>
        <translation>Ou tirez dessus (Inser)</translation>
    </message>
    <message>
        <source>Whole photo</source>
        <translation>Photo entière</translation>
    </message>
    <message>
        <source>Show all of the photo (Home)</source>
        <translation>Montrer toute la photo (Début)</translation>
    </message>
    <message>
        <source>Tab: next point. Arrows: 1 pixel, with Shift 10. Wheel or + and −: zoom. Home: all.</source>
        <translation>Tab : point suivant. Flèches : 1 pixel, avec Maj 10. Molette ou + et − : zoom. Début : tout.</translation>
    </message>
    <message>
        <source>After the first clone, the person here follows your hand.</source>
        <translation>Après le premier clone, la personne suit ici votre main.</translation>
    </message>
    <message>
        <source>The body follows; hair and textures will when you clone again.</source>
        <translation>Le corps suit ; cheveux et textures suivront au prochain clonage.</translation>
    </message>
    <message>
        <source>Clone again: this changes more than is shown.</source>
        <translation>Clonez à nouveau : cela change plus que ce qui est montré.</translation>
    </message>
    <message>
        <source>moving %1</source>
        <translation>déplacer %1</translation>
    </message>
    <message>
        <source>resetting %1</source>
        <translation>rétablir %1</translation>
    </message>
</context>
<context>
    <name>preview</name>
    <message>
        <source>Photo texture</source>
        <translation>Texture photo</translation>
    </message>
    <message>
        <source>Shape alone</source>
        <translation>Forme seule</translation>
    </message>
    <message>
        <source>Wire mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Distance from the outlines</source>
        <translation>Distance aux contours</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Debout</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Marcher</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Respirer</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Cligner</translation>
    </message>
    <message>
        <source>Smile</source>
        <translation>Sourire</translation>
    </message>
    <message>
        <source>Talk</source>
        <translation>Parler</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Saluer</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Montrer</translation>
    </message>
    <message>
        <source>&amp;Over</source>
        <translation>&amp;Sur</translation>
    </message>
    <message>
        <source>Co&amp;ver</source>
        <translation>Cou&amp;vrir</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Bouger</translation>
    </message>
    <message>
        <source>Whole pe&amp;rson</source>
        <translation>Pe&amp;rsonne entière</translation>
    </message>
    <message>
        <source>&amp;Face</source>
        <translation>&amp;Visage</translation>
    </message>
    <message>
        <source>no photo</source>
        <translation>aucune photo</translation>
    </message>
    <message>
        <source>between the clone&apos;s and the photos&apos; outlines</source>
        <translation>entre les contours du clone et des photos</translation>
    </message>
</context>
<context>
    <name>privacy</name>
    <message>
        <source>Delete {names} with all photos, points and clones?</source>
        <translation>Effacer {names} avec toutes les photos, tous les points et clones ?</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Nothing of it can be brought back. Files on sticks stay.</source>
        <translation>Rien ne pourra être récupéré. Les fichiers sur clé restent.</translation>
    </message>
    <message>
        <source>Delete for good</source>
        <translation>Effacer définitivement</translation>
    </message>
    <message>
        <source>Save everything held of {name}</source>
        <translation>Enregistrer tout ce qui concerne {name}</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Données conservées</translation>
    </message>
    <message>
        <source>What is held, by visitor</source>
        <translation>Données conservées, par visiteur</translation>
    </message>
    <message>
        <source>&amp;Save everything held…</source>
        <translation>&amp;Enregistrer tout…</translation>
    </message>
    <message>
        <source>&amp;Delete the marked visitors…</source>
        <translation>Effacer les visiteurs &amp;marqués…</translation>
    </message>
    <message>
        <source>{n} visitors, {size} MB; nothing leaves this computer</source>
        <translation>{n} visiteurs, {size} Mo ; rien ne quitte cet ordinateur</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Visiteur</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>Mo</translation>
    </message>
    <message>
        <source>Last change</source>
        <translation>Dernier changement</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Consentement</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>non noté</translation>
    </message>
</context>
<context>
    <name>queue</name>
    <message>
        <source>Stop cloning {name}</source>
        <translation>Arrêter le clonage de {name}</translation>
    </message>
    <message>
        <source>Progress of {name}</source>
        <translation>Progression de {name}</translation>
    </message>
    <message>
        <source>, {n} more wait</source>
        <translation>, {n} autres attendent</translation>
    </message>
    <message>
        <source>{name}: {step}, {left}</source>
        <translation>{name} : {step}, {left}</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>This event</source>
        <translation>Cet événement</translation>
    </message>
    <message>
        <source>kept until deleted</source>
        <translation>conservés jusqu’à effacement</translation>
    </message>
    <message>
        <source> days</source>
        <translation> jours</translation>
    </message>
    <message>
        <source>Nothing &amp;moves by itself</source>
        <translation>Rien ne &amp;bouge tout seul</translation>
    </message>
    <message>
        <source>&amp;Encrypt the page for telephones</source>
        <translation>&amp;Chiffrer la page pour téléphones</translation>
    </message>
    <message>
        <source>The kiosk &amp;asks for a number</source>
        <translation>Le kiosque dem&amp;ande un numéro</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>pas du tout</translation>
    </message>
    <message>
        <source> hours</source>
        <translation> heures</translation>
    </message>
    <message>
        <source>Each takes a core of this computer and 1 GB of its memory.</source>
        <translation>Chacun prend un cœur de cet ordinateur et 1 Go de sa mémoire.</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>inchangé</translation>
    </message>
    <message>
        <source>none; for example: museum</source>
        <translation>aucune ; par exemple : musée</translation>
    </message>
    <message>
        <source>{days} in the text stands for the days that visitors are kept.</source>
        <translation>{days} dans le texte est remplacé par le nombre de jours de conservation.</translation>
    </message>
    <message>
        <source>&amp;Name of the event</source>
        <translation>&amp;Nom de l’événement</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Bring &amp;back thrown away ones for</source>
        <translation>&amp;Récupérables après la corbeille</translation>
    </message>
    <message>
        <source>&amp;Language of the text</source>
        <translation>&amp;Langue du texte</translation>
    </message>
    <message>
        <source>Visitors may let &amp;use the files</source>
        <translation>Les visiteurs peuvent laisser &amp;utiliser les fichiers</translation>
    </message>
    <message>
        <source>Links for &amp;telephones work for</source>
        <translation>Liens pour &amp;téléphones valables</translation>
    </message>
    <message>
        <source>&amp;Scene that clones may walk in</source>
        <translation>&amp;Scène où les clones peuvent marcher</translation>
    </message>
    <message>
        <source>&amp;Visitors cloned at the same time</source>
        <translation>&amp;Visiteurs clonés en même temps</translation>
    </message>
    <message>
        <source>N&amp;umber of the operator</source>
        <translation>N&amp;uméro de l’opérateur</translation>
    </message>
    <message>
        <source>Name of the event</source>
        <translation>Nom de l’événement</translation>
    </message>
    <message>
        <source>Days that visitors are kept</source>
        <translation>Jours de conservation des visiteurs</translation>
    </message>
    <message>
        <source>Days that thrown away visitors can be brought back</source>
        <translation>Jours pendant lesquels un visiteur jeté est récupérable</translation>
    </message>
    <message>
        <source>Hours that links for telephones work</source>
        <translation>Heures de validité des liens pour téléphones</translation>
    </message>
    <message>
        <source>Scene that clones may walk in</source>
        <translation>Scène où les clones peuvent marcher</translation>
    </message>
    <message>
        <source>Visitors cloned at the same time</source>
        <translation>Visiteurs clonés en même temps</translation>
    </message>
    <message>
        <source>Language of the text</source>
        <translation>Langue du texte</translation>
    </message>
    <message>
        <source>Who visitors may let use the files, at the most</source>
        <translation>Qui les visiteurs peuvent laisser utiliser les fichiers, au plus</translation>
    </message>
    <message>
        <source>Number of the operator</source>
        <translation>Numéro de l’opérateur</translation>
    </message>
    <message>
        <source>What visitors agree to</source>
        <translation>Ce que les visiteurs acceptent</translation>
    </message>
    <message>
        <source>&amp;Keep visitors for</source>
        <translation>&amp;Conserver les visiteurs</translation>
    </message>
    <message>
        <source>&amp;Consent</source>
        <translation>C&amp;onsentement</translation>
    </message>
    <message>
        <source>Choose a &amp;picture…</source>
        <translation>Choisir une &amp;image…</translation>
    </message>
    <message>
        <source>No pictu&amp;re</source>
        <translation>&amp;Aucune image</translation>
    </message>
    <message>
        <source>Logo of the event</source>
        <translation>Logo de l’événement</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
</context>
<context>
    <name>sides</name>
    <message>
        <source>%1, left</source>
        <translation>%1, gauche</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, droite</translation>
    </message>
</context>
<context>
    <name>stage</name>
    <message>
        <source>Everybody of today</source>
        <extracomment>A clone that does not move by itself is seen so long, milliseconds; and so often it is looked for a first one.</extracomment>
        <translation>Tous ceux d’aujourd’hui</translation>
    </message>
    <message>
        <source> and {n} more</source>
        <translation> et {n} de plus</translation>
    </message>
    <message>
        <source>Next: {names}</source>
        <translation>Ensuite : {names}</translation>
    </message>
    <message>
        <source>Screen for visitors</source>
        <translation>Écran des visiteurs</translation>
    </message>
    <message>
        <source>Five photos, one minute: your own clone stands here.</source>
        <translation>Cinq photos, une minute : votre propre clone est ici.</translation>
    </message>
</context>
<context>
    <name>states</name>
    <message>
        <source>in progress</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>waiting for the clone</source>
        <translation>attend le clone</translation>
    </message>
    <message>
        <source>cloned</source>
        <translation>cloné</translation>
    </message>
    <message>
        <source>not cloned: look at the photos</source>
        <translation>non cloné : voyez les photos</translation>
    </message>
</context>
<context>
    <name>statistics</name>
    <message>
        <source>Operator&apos;s effort</source>
        <translation>Effort de l’opérateur</translation>
    </message>
    <message>
        <source>Effort by visitor</source>
        <translation>Effort par visiteur</translation>
    </message>
    <message>
        <source>&amp;Save as table…</source>
        <translation>&amp;Enregistrer en tableau…</translation>
    </message>
    <message>
        <source>{n} visitors; in the middle {s} s, {c} clicks, {d} drags each</source>
        <translation>{n} visiteurs ; en médiane {s} s, {c} clics, {d} glissements chacun</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Visiteur</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Clics</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>Glissements</translation>
    </message>
    <message>
        <source>Clone, s</source>
        <translation>Clone, s</translation>
    </message>
</context>
<context>
    <name>steps</name>
    <message>
        <source>Looking at the photo</source>
        <extracomment>What the progress bar says for a step&apos;s name.</extracomment>
        <translation>Examen de la photo</translation>
    </message>
    <message>
        <source>Reading the photos</source>
        <translation>Lecture des photos</translation>
    </message>
    <message>
        <source>Finding the person in the photos</source>
        <translation>Recherche de la personne sur les photos</translation>
    </message>
    <message>
        <source>Placing feature points</source>
        <translation>Placement des points</translation>
    </message>
    <message>
        <source>Placing the cameras</source>
        <translation>Placement des caméras</translation>
    </message>
    <message>
        <source>Drawing outlines</source>
        <translation>Tracé des contours</translation>
    </message>
    <message>
        <source>Choosing the nearest build and pose</source>
        <translation>Choix de la carrure et de la pose</translation>
    </message>
    <message>
        <source>Fitting the skeleton</source>
        <translation>Ajustement du squelette</translation>
    </message>
    <message>
        <source>Fitting the body</source>
        <translation>Ajustement du corps</translation>
    </message>
    <message>
        <source>Fitting the outlines</source>
        <translation>Ajustement des contours</translation>
    </message>
    <message>
        <source>Fitting the head</source>
        <translation>Ajustement de la tête</translation>
    </message>
    <message>
        <source>Joining head and body</source>
        <translation>Assemblage de la tête et du corps</translation>
    </message>
    <message>
        <source>Following corrected points</source>
        <translation>Suivi des points corrigés</translation>
    </message>
    <message>
        <source>Measuring the body</source>
        <translation>Mesure du corps</translation>
    </message>
    <message>
        <source>Growing the hair</source>
        <translation>Pousse des cheveux</translation>
    </message>
    <message>
        <source>Painting skin and clothes</source>
        <translation>Peinture de la peau et des vêtements</translation>
    </message>
    <message>
        <source>Telling skin from clothes</source>
        <translation>Distinction peau et vêtements</translation>
    </message>
    <message>
        <source>Writing the files</source>
        <translation>Écriture des fichiers</translation>
    </message>
    <message>
        <source>Drawing previews</source>
        <translation>Dessin des aperçus</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
    </message>
    <message>
        <source>Copying</source>
        <translation>Copie</translation>
    </message>
    <message>
        <source>Making the body</source>
        <translation>Création du corps</translation>
    </message>
    <message>
        <source>Cutting the pieces</source>
        <translation>Coupe des pièces</translation>
    </message>
    <message>
        <source>Sewing and hanging</source>
        <translation>Couture et tombé</translation>
    </message>
    <message>
        <source>Walking in it</source>
        <translation>Marche avec</translation>
    </message>
    <message>
        <source>Closing the loop</source>
        <translation>Fermeture de la boucle</translation>
    </message>
    <message>
        <source>Reading back what was written</source>
        <translation>Relecture de ce qui est écrit</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>stick</name>
    <message>
        <source>Sticks are found by themselves on Linux only: choose the stick&apos;s folder.</source>
        <extracomment>Where Linux tells what is mounted; read again and again, it costs nothing. Only when it changes a program is asked.</extracomment>
        <translation>Les clés ne sont trouvées d’elles-mêmes que sous Linux : choisissez le dossier de la clé.</translation>
    </message>
    <message>
        <source>Which stick</source>
        <translation>Quelle clé</translation>
    </message>
    <message>
        <source>This system does not tell which sticks are plugged in: choose the folder.</source>
        <translation>Ce système ne dit pas quelles clés sont branchées : choisissez le dossier.</translation>
    </message>
    <message>
        <source>No stick is plugged in: it is found by itself.</source>
        <translation>Aucune clé branchée : elle sera trouvée d’elle-même.</translation>
    </message>
    <message>
        <source>&amp;Copy to {stick}</source>
        <translation>&amp;Copier sur {stick}</translation>
    </message>
    <message>
        <source>E&amp;ject {stick}</source>
        <translation>É&amp;jecter {stick}</translation>
    </message>
    <message>
        <source>{n} GB are free.</source>
        <translation>{n} Go sont libres.</translation>
    </message>
    <message>
        <source>It is write-protected.</source>
        <translation>Elle est protégée en écriture.</translation>
    </message>
    <message>
        <source>The stick is being let go…</source>
        <translation>La clé est en cours d’éjection…</translation>
    </message>
    <message>
        <source>{stick} can be pulled out.</source>
        <translation>{stick} peut être retirée.</translation>
    </message>
</context>
<context>
    <name>studio</name>
    <message>
        <source>Ca&amp;ncel</source>
        <extracomment>Width of the controls beside the picture, lines of text; taste.</extracomment>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>How far the work is</source>
        <translation>Avancement du travail</translation>
    </message>
    <message>
        <source>Written: {place}</source>
        <translation>Écrit : {place}</translation>
    </message>
    <message>
        <source>&amp;Another clone…</source>
        <translation>Un &amp;autre clone…</translation>
    </message>
    <message>
        <source>No clone is chosen.</source>
        <translation>Aucun clone n&apos;est choisi.</translation>
    </message>
    <message>
        <source>Folder of a clone</source>
        <translation>Dossier d&apos;un clone</translation>
    </message>
    <message>
        <source>Body of blobs</source>
        <extracomment>What of a blob&apos;s ends may be told here, cm; its file takes more.</extracomment>
        <translation>Corps de blobs</translation>
    </message>
    <message>
        <source>Show the &amp;blobs</source>
        <translation>Montrer les &amp;blobs</translation>
    </message>
    <message>
        <source>&amp;Open a file of blobs…</source>
        <translation>&amp;Ouvrir un fichier de blobs…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the blobs as a file…</source>
        <translation>En&amp;registrer les blobs…</translation>
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
        <translation>&amp;Matière</translation>
    </message>
    <message>
        <source>File of blobs</source>
        <translation>Fichier de blobs</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Radius at the other end</source>
        <translation>Rayon au bout</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>Vers la gauche</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Forwards</source>
        <translation>Vers l&apos;avant</translation>
    </message>
    <message>
        <source>Times as wide</source>
        <translation>Largeur, fois</translation>
    </message>
    <message>
        <source>Times as high</source>
        <translation>Hauteur, fois</translation>
    </message>
    <message>
        <source>Times as deep</source>
        <translation>Profondeur, fois</translation>
    </message>
    <message>
        <source>Body from measures</source>
        <extracomment>Sliders go so many spreads to either side of what is usual; a body may have 4.5 (`FAR`). Side of a saved body&apos;s texture, texels; as `cloner body` has it.</extracomment>
        <translation>Corps d&apos;après mesures</translation>
    </message>
    <message>
        <source>A woman or a girl</source>
        <translation>Une femme ou une fille</translation>
    </message>
    <message>
        <source>A man or a boy</source>
        <translation>Un homme ou un garçon</translation>
    </message>
    <message>
        <source>A clone, told new measures</source>
        <translation>Un clone, nouvelles mesures</translation>
    </message>
    <message>
        <source> years</source>
        <translation> ans</translation>
    </message>
    <message>
        <source>Four, as a shop asks</source>
        <translation>Quatre, comme en magasin</translation>
    </message>
    <message>
        <source>Nine, as a tailor takes</source>
        <translation>Neuf, comme le tailleur</translation>
    </message>
    <message>
        <source>&amp;Save the body…</source>
        <translation>Enregi&amp;strer le corps…</translation>
    </message>
    <message>
        <source>&amp;Who</source>
        <translation>&amp;Qui</translation>
    </message>
    <message>
        <source>&amp;Age</source>
        <translation>Â&amp;ge</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>&amp;Mesures</translation>
    </message>
    <message>
        <source>&amp;Name of the body</source>
        <translation>&amp;Nom du corps</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>Folder for bodies</source>
        <translation>Dossier pour les corps</translation>
    </message>
    <message>
        <source>Take this marker away</source>
        <extracomment>What a vertex is called that has no name of its own: this and its number.</extracomment>
        <translation>Enlever ce repère</translation>
    </message>
    <message>
        <source>Photograph on a statue</source>
        <translation>Photo sur une statue</translation>
    </message>
    <message>
        <source>Choose a &amp;photograph…</source>
        <translation>Choisir une &amp;photo…</translation>
    </message>
    <message>
        <source>Paint it all &amp;round</source>
        <translation>Peindre tout aut&amp;our</translation>
    </message>
    <message>
        <source>Choose a photograph of a face, of flesh or of stone.</source>
        <translation>Choisissez la photo d&apos;un visage, de chair ou de pierre.</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Photo</translation>
    </message>
    <message>
        <source>No face was found: drag the markers to their places.</source>
        <translation>Aucun visage trouvé : tirez les repères à leur place.</translation>
    </message>
    <message>
        <source>Drag the markers. A double click on the clone adds one, Delete takes one away.</source>
        <translation>Tirez les repères. Un double clic sur le clone en ajoute un, Suppr en enlève un.</translation>
    </message>
    <message>
        <source>The usual man</source>
        <extracomment>Side of the texture of a statue that is nobody&apos;s clone, texels; as `cloner statue` has it.</extracomment>
        <translation>L&apos;homme habituel</translation>
    </message>
    <message>
        <source>Its own colours</source>
        <translation>Ses propres couleurs</translation>
    </message>
    <message>
        <source>A clone</source>
        <translation>Un clone</translation>
    </message>
    <message>
        <source>&amp;Save the statue…</source>
        <translation>Enregi&amp;strer la statue…</translation>
    </message>
    <message>
        <source>statue</source>
        <translation>statue</translation>
    </message>
    <message>
        <source>La&amp;id on</source>
        <translation>Posé s&amp;ur</translation>
    </message>
    <message>
        <source>&amp;Name of the statue</source>
        <translation>&amp;Nom de la statue</translation>
    </message>
    <message>
        <source>Folder for statues</source>
        <translation>Dossier pour les statues</translation>
    </message>
    <message>
        <source>Clone in stone</source>
        <translation>Clone en pierre</translation>
    </message>
    <message>
        <source>Choose a clone that is finished.</source>
        <translation>Choisissez un clone achevé.</translation>
    </message>
    <message>
        <source>&amp;Pose</source>
        <translation>&amp;Pose</translation>
    </message>
    <message>
        <source>Dress a clone</source>
        <extracomment>Lengths that may be asked for, cm; the first stands for the usual one.</extracomment>
        <translation>Habiller un clone</translation>
    </message>
    <message>
        <source>A file of my own…</source>
        <translation>Un fichier à moi…</translation>
    </message>
    <message>
        <source>Own walk</source>
        <translation>Sa propre marche</translation>
    </message>
    <message>
        <source>A captured walk…</source>
        <translation>Une marche capturée…</translation>
    </message>
    <message>
        <source>as usual</source>
        <translation>comme d&apos;habitude</translation>
    </message>
    <message>
        <source>&amp;Instead of the photographed clothes</source>
        <translation>Sans les vêtements des &amp;photos</translation>
    </message>
    <message>
        <source>Otherwise it is worn over the clothes of the photos.</source>
        <translation>Sinon il se porte par-dessus les vêtements des photos.</translation>
    </message>
    <message>
        <source>Who wears it</source>
        <translation>Qui le porte</translation>
    </message>
    <message>
        <source>&amp;Garment</source>
        <translation>&amp;Vêtement</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Longueur</translation>
    </message>
    <message>
        <source>&amp;Fabric</source>
        <translation>&amp;Tissu</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Mouvement</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Something &amp;over it</source>
        <translation>Quelque chose par-&amp;dessus</translation>
    </message>
    <message>
        <source>Photographed clothes</source>
        <translation>Vêtements photographiés</translation>
    </message>
    <message>
        <source>Take the photographed clothes of {name} off?</source>
        <translation>Enlever les vêtements photographiés de {name} ?</translation>
    </message>
    <message>
        <source>The garment is then worn over neutral underwear. Ask the visitor first.</source>
        <translation>Le vêtement se porte alors sur des sous-vêtements neutres. Demandez d&apos;abord à la personne.</translation>
    </message>
    <message>
        <source>Take them off</source>
        <translation>Les enlever</translation>
    </message>
    <message>
        <source>File of a garment</source>
        <translation>Fichier d&apos;un vêtement</translation>
    </message>
    <message>
        <source>Captured walk</source>
        <translation>Marche capturée</translation>
    </message>
    <message>
        <source>Save the dressed clone</source>
        <translation>Enregistrer le clone habillé</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Disposer</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Coudre</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>Dis&amp;poser</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>C&amp;oudre</translation>
    </message>
    <message>
        <source>Let it wal&amp;k</source>
        <translation>Faire marc&amp;her</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>Enregi&amp;strer sous…</translation>
    </message>
</context>
<context>
    <name>takeaway</name>
    <message>
        <source>Writing the files…</source>
        <translation>Écriture des fichiers…</translation>
    </message>
    <message>
        <source>Written and read back: {place}</source>
        <translation>Écrit et relu : {place}</translation>
    </message>
    <message>
        <source>Stopped: nothing of it was left there.</source>
        <translation>Arrêté : rien n’en est resté là-bas.</translation>
    </message>
    <message>
        <source>Written: {place}</source>
        <translation>Écrit : {place}</translation>
    </message>
    <message>
        <source>Choose what the visitor takes home.</source>
        <translation>Choisissez ce que le visiteur emporte.</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Emporter</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Code to scan</source>
        <translation>Code à scanner</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Données conservées</translation>
    </message>
    <message>
        <source>Save as one &amp;zip file…</source>
        <translation>Enregistrer en fichier &amp;zip…</translation>
    </message>
    <message>
        <source>Show &amp;report</source>
        <translation>Montrer le &amp;rapport</translation>
    </message>
    <message>
        <source>Copy to a f&amp;older…</source>
        <translation>Copier dans un d&amp;ossier…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Show &amp;folder</source>
        <translation>Montrer le &amp;dossier</translation>
    </message>
    <message>
        <source>&amp;Page for telephones on this network</source>
        <translation>&amp;Page pour téléphones sur ce réseau</translation>
    </message>
    <message>
        <source>Page for telephones on this network</source>
        <translation>Page pour téléphones sur ce réseau</translation>
    </message>
    <message>
        <source>Save &amp;everything held…</source>
        <translation>&amp;Enregistrer toutes les données…</translation>
    </message>
    <message>
        <source>&amp;Delete this visitor…</source>
        <translation>&amp;Effacer ce visiteur…</translation>
    </message>
    <message>
        <source>Text or address in the code; {id} stands for the visitor</source>
        <translation>Texte ou adresse du code ; {id} représente le visiteur</translation>
    </message>
    <message>
        <source>Text of the code</source>
        <translation>Texte du code</translation>
    </message>
    <message>
        <source>How far the files are</source>
        <translation>Avancement des fichiers</translation>
    </message>
    <message>
        <source>There is no clone yet.</source>
        <translation>Il n’y a pas encore de clone.</translation>
    </message>
    <message>
        <source>No consent is recorded.</source>
        <translation>Aucun consentement noté.</translation>
    </message>
    <message>
        <source>Consent: {when}.</source>
        <translation>Consentement : {when}.</translation>
    </message>
    <message>
        <source>Kept for {n} days.</source>
        <translation>Conservé {n} jours.</translation>
    </message>
    <message>
        <source>Kept.</source>
        <translation>Conservé.</translation>
    </message>
    <message>
        <source>Switch the page for telephones on, or type the address of a page of your own.</source>
        <translation>Activez la page pour téléphones, ou tapez l’adresse d’une page à vous.</translation>
    </message>
    <message>
        <source>In the scene “{scene}”, within seconds.</source>
        <translation>Dans la scène « {scene} », en quelques secondes.</translation>
    </message>
    <message>
        <source>Off: nothing leaves this computer.</source>
        <translation>Désactivé : rien ne quitte cet ordinateur.</translation>
    </message>
    <message>
        <source>The page is being made…</source>
        <translation>La page est en cours…</translation>
    </message>
    <message>
        <source>Telephones warn of the booth&apos;s own certificate once.</source>
        <translation>Les téléphones signalent une fois le certificat du stand.</translation>
    </message>
    <message>
        <source>Not encrypted: use a hotspot of your own with a password.</source>
        <translation>Non chiffré : utilisez votre propre point d’accès avec mot de passe.</translation>
    </message>
    <message>
        <source>Each visitor&apos;s link works for {n} hours.</source>
        <translation>Le lien de chaque visiteur marche {n} heures.</translation>
    </message>
    <message>
        <source>Stick or folder for the visitor&apos;s files</source>
        <translation>Clé ou dossier pour les fichiers du visiteur</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
</context>
<context>
    <name>time</name>
    <message>
        <source>a few seconds</source>
        <translation>quelques secondes</translation>
    </message>
    <message>
        <source>about {n} s</source>
        <translation>environ {n} s</translation>
    </message>
    <message>
        <source>about {n} min</source>
        <translation>environ {n} min</translation>
    </message>
</context>
<context>
    <name>told</name>
    <message>
        <source>there is no camera</source>
        <translation>aucune caméra n’a été trouvée</translation>
    </message>
    <message>
        <source>Plug it in and allow its use, then try again</source>
        <translation>Branchez-la, autorisez son utilisation et réessayez</translation>
    </message>
    <message>
        <source>the camera gives no pictures any more</source>
        <translation>la caméra ne donne plus d’images</translation>
    </message>
    <message>
        <source>Plug it in again</source>
        <translation>Rebranchez-la</translation>
    </message>
    <message>
        <source>it must be an object with &quot;format&quot;: %1</source>
        <translation>ce doit être un objet avec &quot;format&quot; : %1</translation>
    </message>
    <message>
        <source>a setting is out of its range</source>
        <translation>un réglage est hors de ses limites</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>ce dossier n’existe pas</translation>
    </message>
    <message>
        <source>Choose another, or make it first</source>
        <translation>Choisissez-en un autre ou créez-le d’abord</translation>
    </message>
    <message>
        <source>this folder holds other things than visitors</source>
        <translation>ce dossier contient autre chose que des visiteurs</translation>
    </message>
    <message>
        <source>Choose an empty folder, an event&apos;s, or one with photos named body_front.jpg and so on</source>
        <translation>Choisissez un dossier vide, celui d’un événement, ou un dossier de photos nommées body_front.jpg, etc.</translation>
    </message>
    <message>
        <source>the event&apos;s settings cannot be read</source>
        <translation>les réglages de l’événement sont illisibles</translation>
    </message>
    <message>
        <source>Correct %1, or move it away to start with the usual settings</source>
        <translation>Corrigez %1, ou déplacez-le pour repartir des réglages habituels</translation>
    </message>
    <message>
        <source>the key %1 is not known</source>
        <translation>la clé %1 est inconnue</translation>
    </message>
    <message>
        <source>The keys are %1</source>
        <translation>Les clés sont %1</translation>
    </message>
    <message>
        <source>the licence %1 is not known</source>
        <translation>la licence %1 est inconnue</translation>
    </message>
    <message>
        <source>The licences are %1</source>
        <translation>Les licences sont %1</translation>
    </message>
    <message>
        <source>%1 has a value of the wrong kind</source>
        <translation>%1 a une valeur du mauvais type</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>le dossier est illisible</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Vérifiez ses droits d’accès</translation>
    </message>
    <message>
        <source>the visitor&apos;s folder cannot be made</source>
        <translation>le dossier du visiteur ne peut pas être créé</translation>
    </message>
    <message>
        <source>Check permissions and space</source>
        <translation>Vérifiez les droits d’accès et la place libre</translation>
    </message>
    <message>
        <source>this is there already</source>
        <translation>cela existe déjà</translation>
    </message>
    <message>
        <source>Choose another name or place</source>
        <translation>Choisissez un autre nom ou un autre endroit</translation>
    </message>
    <message>
        <source>it cannot be written there</source>
        <translation>impossible d’écrire à cet endroit</translation>
    </message>
    <message>
        <source>Is the stick full or write-protected?</source>
        <translation>La clé est-elle pleine ou protégée en écriture ?</translation>
    </message>
    <message>
        <source>there is no photo yet</source>
        <translation>il n’y a pas encore de photo</translation>
    </message>
    <message>
        <source>Take the photos first</source>
        <translation>Prenez d’abord les photos</translation>
    </message>
    <message>
        <source>no photo is stored before the visitor agreed</source>
        <translation>aucune photo n’est conservée avant l’accord du visiteur</translation>
    </message>
    <message>
        <source>Ask the visitor and tick the consent on the first page</source>
        <translation>Demandez au visiteur et cochez l’accord sur la première page</translation>
    </message>
    <message>
        <source>this is no photo</source>
        <translation>ce n’est pas une photo</translation>
    </message>
    <message>
        <source>Use one of %1</source>
        <translation>Utilisez l’un de ces formats : %1</translation>
    </message>
    <message>
        <source>the photo cannot be stored</source>
        <translation>la photo ne peut pas être enregistrée</translation>
    </message>
    <message>
        <source>Check the folder&apos;s permissions and space</source>
        <translation>Vérifiez les droits d’accès et la place du dossier</translation>
    </message>
    <message>
        <source>the photo cannot be moved</source>
        <translation>la photo ne peut pas être déplacée</translation>
    </message>
    <message>
        <source>the photo cannot be deleted</source>
        <translation>la photo ne peut pas être supprimée</translation>
    </message>
    <message>
        <source>the photo cannot be turned</source>
        <translation>la photo ne peut pas être tournée</translation>
    </message>
    <message>
        <source>Turn it with another program</source>
        <translation>Tournez-la avec un autre programme</translation>
    </message>
    <message>
        <source>the text is too long for a code</source>
        <translation>le texte est trop long pour un code</translation>
    </message>
    <message>
        <source>%1 characters can be scanned</source>
        <translation>%1 caractères peuvent être lus</translation>
    </message>
    <message>
        <source>something went wrong that the program did not expect (%1)</source>
        <translation>une erreur que le programme n’attendait pas s’est produite (%1)</translation>
    </message>
    <message>
        <source>something went wrong that the program did not expect</source>
        <translation>une erreur que le programme n’attendait pas s’est produite</translation>
    </message>
    <message>
        <source>Try again; if it happens again, send the log file</source>
        <translation>Réessayez ; si cela se reproduit, envoyez le fichier journal</translation>
    </message>
    <message>
        <source>Go on; if it happens again, send the log file</source>
        <translation>Continuez ; si cela se reproduit, envoyez le fichier journal</translation>
    </message>
    <message>
        <source>Start it from a terminal with -v and send what it prints</source>
        <translation>Lancez le programme dans un terminal avec -v et envoyez ce qu’il affiche</translation>
    </message>
    <message>
        <source>the worker&apos;s process ended</source>
        <translation>le processus de travail s’est arrêté</translation>
    </message>
    <message>
        <source>a texture of %1 texels cannot be made</source>
        <translation>une texture de %1 texels est impossible</translation>
    </message>
    <message>
        <source>The sizes are %1</source>
        <translation>Les tailles sont %1</translation>
    </message>
    <message>
        <source>the format %1 is not known</source>
        <translation>le format %1 est inconnu</translation>
    </message>
    <message>
        <source>The formats are %1</source>
        <translation>Les formats sont %1</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>Le fichier ne peut pas être écrit : %1</translation>
    </message>
    <message>
        <source>Choose another folder or free some space</source>
        <translation>Choisissez un autre dossier ou libérez de la place</translation>
    </message>
    <message>
        <source>there is not enough memory: a limit allows %1 GB, a clone needs %2</source>
        <translation>La mémoire ne suffit pas : une limite permet %1 Go, un clone en demande %2</translation>
    </message>
    <message>
        <source>Raise it: ulimit -v %1</source>
        <translation>Relevez-la : ulimit -v %1</translation>
    </message>
    <message>
        <source>USD needs a library that is not here</source>
        <translation>USD a besoin d’une bibliothèque absente ici</translation>
    </message>
    <message>
        <source>Install it with: %1</source>
        <translation>Installez-la avec : %1</translation>
    </message>
    <message>
        <source>This machine cannot draw: EGL gives no context</source>
        <translation>Cette machine ne peut pas dessiner : EGL ne donne pas de contexte</translation>
    </message>
    <message>
        <source>nothing is held under this name</source>
        <translation>rien n’est conservé sous ce nom</translation>
    </message>
    <message>
        <source>cloner list shows the names</source>
        <translation>cloner list montre les noms</translation>
    </message>
    <message>
        <source>somebody is cloning this visitor just now</source>
        <translation>ce visiteur est en cours de clonage</translation>
    </message>
    <message>
        <source>Wait or stop that, and repeat</source>
        <translation>Attendez ou arrêtez cela, puis recommencez</translation>
    </message>
    <message>
        <source>there is nowhere to look</source>
        <translation>aucun endroit où chercher</translation>
    </message>
    <message>
        <source>Give --photos, --out or both</source>
        <translation>Donnez --photos, --out ou les deux</translation>
    </message>
    <message>
        <source>Give --photos and --out as you gave them to batch</source>
        <translation>Donnez --photos et --out comme pour batch</translation>
    </message>
    <message>
        <source>the file exists</source>
        <translation>le fichier existe déjà</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Choisissez un autre nom</translation>
    </message>
    <message>
        <source>the zip file cannot be written</source>
        <translation>le fichier zip ne peut pas être écrit</translation>
    </message>
    <message>
        <source>Check the folder and its space</source>
        <translation>Vérifiez le dossier et sa place libre</translation>
    </message>
    <message>
        <source>not everything could be deleted</source>
        <translation>tout n’a pas pu être supprimé</translation>
    </message>
    <message>
        <source>Check permissions and repeat</source>
        <translation>Vérifiez les droits d’accès et recommencez</translation>
    </message>
    <message>
        <source>the results cannot be written there</source>
        <translation>les résultats ne peuvent pas être écrits à cet endroit</translation>
    </message>
    <message>
        <source>Choose another --out folder, or check its permissions and free space</source>
        <translation>Choisissez un autre dossier, ou vérifiez ses droits d’accès et la place libre</translation>
    </message>
    <message>
        <source>something that is no earlier result is in the way and will not be replaced</source>
        <translation>quelque chose qui n’est pas un résultat antérieur gêne et ne sera pas remplacé</translation>
    </message>
    <message>
        <source>Choose another --out folder or --id</source>
        <translation>Choisissez un autre dossier ou un autre nom</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>le fichier ne peut pas être écrit</translation>
    </message>
    <message>
        <source>The clone was written by a newer version</source>
        <translation>Le clone vient d’une version plus récente</translation>
    </message>
    <message>
        <source>Clone the person again with this version of Cloner</source>
        <translation>Clonez la personne de nouveau avec cette version</translation>
    </message>
    <message>
        <source>The clone is not there</source>
        <translation>Le clone n’est pas là</translation>
    </message>
    <message>
        <source>Run: cloner clone</source>
        <translation>Lancez : cloner clone</translation>
    </message>
    <message>
        <source>The file is not a readable clone</source>
        <translation>Le fichier n’est pas un clone lisible</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 doit être un objet</translation>
    </message>
    <message>
        <source>Correct the entry, or move the file away to use the proposals alone</source>
        <translation>Corrigez l’entrée, ou déplacez le fichier pour n’utiliser que les propositions</translation>
    </message>
    <message>
        <source>a point needs numbers &quot;x&quot; and &quot;y&quot; in photo pixels</source>
        <translation>un point demande des nombres &quot;x&quot; et &quot;y&quot; en pixels de la photo</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>ce n’est pas du JSON valide</translation>
    </message>
    <message>
        <source>%1 is not a view; the views are %2</source>
        <translation>%1 n’est pas une vue ; les vues sont %2</translation>
    </message>
    <message>
        <source>there is no feature point of this name in this view</source>
        <translation>cette vue n’a pas de point de ce nom</translation>
    </message>
    <message>
        <source>the point lies outside the photo of %1</source>
        <translation>le point est hors de la photo de %1</translation>
    </message>
    <message>
        <source>%1 with a usable name is here, and one front photo is needed</source>
        <translation>%1 avec un nom utilisable ici, et il faut une photo de face</translation>
    </message>
    <message>
        <source>Give the folder inside it that holds the photos (%1), or use cloner batch for all</source>
        <translation>Prenez le dossier intérieur qui contient les photos (%1), ou cloner batch pour tous</translation>
    </message>
    <message>
        <source>Name the photos %1 (png, webp, tiff and heic work too)</source>
        <translation>Nommez les photos %1 (png, webp, tiff et heic conviennent aussi)</translation>
    </message>
    <message>
        <source>there is no such folder of photos</source>
        <translation>ce dossier de photos n’existe pas</translation>
    </message>
    <message>
        <source>Give the folder that holds the photos</source>
        <translation>Donnez le dossier qui contient les photos</translation>
    </message>
    <message>
        <source>%1 must be text in quotes</source>
        <translation>%1 doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>Put it in quotes</source>
        <translation>Mettez-le entre guillemets</translation>
    </message>
    <message>
        <source>Write sex = &quot;f&quot; or sex = &quot;m&quot;, or leave it out</source>
        <translation>Écrivez sex = &quot;f&quot; ou sex = &quot;m&quot;, ou omettez-le</translation>
    </message>
    <message>
        <source>age must be years</source>
        <translation>age doit être en années</translation>
    </message>
    <message>
        <source>Write a line like: age = 71</source>
        <translation>Écrivez une ligne comme : age = 71</translation>
    </message>
    <message>
        <source>measures must be a table of centimetres</source>
        <translation>measures doit être un tableau en centimètres</translation>
    </message>
    <message>
        <source>Write a line [measures], and below it lines like: waist_girth = 70.2</source>
        <translation>Écrivez une ligne [measures], puis des lignes comme : waist_girth = 70.2</translation>
    </message>
    <message>
        <source>the height must be a number of centimetres</source>
        <translation>la taille doit être un nombre de centimètres</translation>
    </message>
    <message>
        <source>Write height_cm = 172</source>
        <translation>Écrivez height_cm = 172</translation>
    </message>
    <message>
        <source>a height of %1 cm is outside %2 to %3 cm</source>
        <translation>une taille de %1 cm est hors de %2 à %3 cm</translation>
    </message>
    <message>
        <source>Give the barefoot height in centimetres</source>
        <translation>Donnez la taille pieds nus en centimètres</translation>
    </message>
    <message>
        <source>there are two photos for %1: %2 and %3</source>
        <translation>il y a deux photos pour %1 : %2 et %3</translation>
    </message>
    <message>
        <source>Keep one of them</source>
        <translation>Gardez-en une</translation>
    </message>
    <message>
        <source>this is not valid TOML (%1)</source>
        <translation>ce n’est pas du TOML valide (%1)</translation>
    </message>
    <message>
        <source>Write lines like: height_cm = 172</source>
        <translation>Écrivez des lignes comme : height_cm = 172</translation>
    </message>
    <message>
        <source>this is a link that leads out of its folder</source>
        <translation>c’est un lien qui sort de son dossier</translation>
    </message>
    <message>
        <source>Put the file itself there</source>
        <translation>Mettez-y le fichier lui-même</translation>
    </message>
    <message>
        <source>&quot;format&quot; must be a whole number</source>
        <translation>&quot;format&quot; doit être un nombre entier</translation>
    </message>
    <message>
        <source>Write format = %1, as this version does</source>
        <translation>Écrivez format = %1, comme cette version</translation>
    </message>
    <message>
        <source>it was written by a newer version of Cloner (format %1, this one knows %2)</source>
        <translation>il vient d’une version plus récente de Cloner (format %1, celle-ci connaît %2)</translation>
    </message>
    <message>
        <source>Update Cloner, or move the file away</source>
        <translation>Mettez Cloner à jour ou déplacez le fichier</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>ce n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>Check it or move it away</source>
        <translation>Vérifiez-le ou déplacez-le</translation>
    </message>
    <message>
        <source>the file is larger than %1 MB</source>
        <translation>le fichier dépasse %1 Mo</translation>
    </message>
    <message>
        <source>the file cannot be read as text</source>
        <translation>le fichier n’est pas lisible comme texte</translation>
    </message>
    <message>
        <source>the work folder cannot be written</source>
        <translation>le dossier de travail ne peut pas être écrit</translation>
    </message>
    <message>
        <source>The picture is too large to draw</source>
        <translation>L’image est trop grande pour être dessinée</translation>
    </message>
    <message>
        <source>Keep it under %1 pixels</source>
        <translation>Restez sous %1 pixels</translation>
    </message>
    <message>
        <source>this photo shows only the upper part of the person, not the whole body</source>
        <translation>cette photo ne montre que le haut du corps, pas le corps entier</translation>
    </message>
    <message>
        <source>the feet are outside this photo</source>
        <translation>les pieds sont hors de la photo</translation>
    </message>
    <message>
        <source>this photo shows the person from the front or back, not from the side</source>
        <translation>cette photo montre la personne de face ou de dos, pas de côté</translation>
    </message>
    <message>
        <source>this photo shows the person from the side, not the %1</source>
        <translation>cette photo montre la personne de côté, pas de %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>face</translation>
    </message>
    <message>
        <source>back</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>this photo shows the person&apos;s back, not the front</source>
        <translation>cette photo montre la personne de dos, pas de face</translation>
    </message>
    <message>
        <source>this photo shows the person&apos;s front, not the back</source>
        <translation>cette photo montre la personne de face, pas de dos</translation>
    </message>
    <message>
        <source>this photo shows the whole body, not the face from near</source>
        <translation>cette photo montre le corps entier, pas le visage de près</translation>
    </message>
    <message>
        <source>this photo shows the face from the side, not from the front</source>
        <translation>cette photo montre le visage de côté, pas de face</translation>
    </message>
    <message>
        <source>no face can be seen from the front in this photo</source>
        <translation>aucun visage n’est visible de face sur cette photo</translation>
    </message>
    <message>
        <source>this photo shows the head from the front or back, not from the side</source>
        <translation>cette photo montre la tête de face ou de dos, pas de côté</translation>
    </message>
    <message>
        <source>Rename or retake the photos so that each shows what its name says</source>
        <translation>Replacez ou reprenez les photos pour que chacune montre sa vue</translation>
    </message>
    <message>
        <source>%1: the corrected point %2 lies off the image</source>
        <translation>%1 : le point corrigé %2 est hors de l’image</translation>
    </message>
    <message>
        <source>Drag it back on to the photo</source>
        <translation>Ramenez-le sur la photo</translation>
    </message>
    <message>
        <source>no person found in this photo</source>
        <translation>personne n’a été trouvé sur cette photo</translation>
    </message>
    <message>
        <source>Take it again with one person in full view</source>
        <translation>Reprenez-la avec une personne entièrement visible</translation>
    </message>
    <message>
        <source>%1 people found in this photo</source>
        <translation>%1 personnes trouvées sur cette photo</translation>
    </message>
    <message>
        <source>Take it again with one person alone in view</source>
        <translation>Reprenez-la avec une seule personne dans le cadre</translation>
    </message>
    <message>
        <source>the person&apos;s outline was not found</source>
        <translation>le contour de la personne n’a pas été trouvé</translation>
    </message>
    <message>
        <source>Retake the photo before a plain background</source>
        <translation>Reprenez la photo devant un fond uni</translation>
    </message>
    <message>
        <source>the photo is missing</source>
        <translation>la photo manque</translation>
    </message>
    <message>
        <source>Put it into the photos folder</source>
        <translation>Mettez-la dans le dossier des photos</translation>
    </message>
    <message>
        <source>the photo is empty (0 bytes)</source>
        <translation>la photo est vide (0 octet)</translation>
    </message>
    <message>
        <source>Copy the photo from the camera again, or retake it</source>
        <translation>Copiez de nouveau la photo depuis l’appareil, ou reprenez-la</translation>
    </message>
    <message>
        <source>%1 has %2 megapixels, more than the %3 that can be read</source>
        <translation>%1 a %2 mégapixels, plus que les %3 lisibles</translation>
    </message>
    <message>
        <source>the photo</source>
        <translation>la photo</translation>
    </message>
    <message>
        <source>this %1 photo</source>
        <translation>cette photo %1</translation>
    </message>
    <message>
        <source>the photo has more than %1 megapixels</source>
        <translation>la photo a plus de %1 mégapixels</translation>
    </message>
    <message>
        <source>Save it smaller, 12 megapixels are plenty</source>
        <translation>Enregistrez-la plus petite, 12 mégapixels suffisent</translation>
    </message>
    <message>
        <source>the photo is only %1 x %2 pixels</source>
        <translation>la photo n’a que %1 x %2 pixels</translation>
    </message>
    <message>
        <source>Use the original photo, not a thumbnail</source>
        <translation>Utilisez l’original, pas une vignette</translation>
    </message>
    <message>
        <source>this file is not a photo that can be read</source>
        <translation>ce fichier n’est pas une photo lisible</translation>
    </message>
    <message>
        <source>Install pillow-heif, or let the phone save photos as JPEG</source>
        <translation>Installez pillow-heif, ou faites enregistrer des JPEG par le téléphone</translation>
    </message>
    <message>
        <source>Use a JPEG, PNG, TIFF or WebP photo</source>
        <translation>Utilisez une photo JPEG, PNG, TIFF ou WebP</translation>
    </message>
    <message>
        <source>the photo is damaged or cut short</source>
        <translation>la photo est abîmée ou tronquée</translation>
    </message>
    <message>
        <source>the photo cannot be opened</source>
        <translation>la photo ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>the photo cannot be read</source>
        <translation>la photo est illisible</translation>
    </message>
    <message>
        <source>Is the card or the cable still in its place?</source>
        <translation>La carte ou le câble est-il toujours en place ?</translation>
    </message>
    <message>
        <source>the photos changed while they were cloned</source>
        <translation>les photos ont changé pendant le clonage</translation>
    </message>
    <message>
        <source>Clone again</source>
        <translation>Clonez de nouveau</translation>
    </message>
    <message>
        <source>%1: depths of the face are those of a usual face of this shape</source>
        <translation>%1 : les profondeurs sont celles d’un visage usuel de cette forme</translation>
    </message>
    <message>
        <source>there is no side photo of the face</source>
        <translation>pas de photo du visage de côté</translation>
    </message>
    <message>
        <source>no profile was found in the side photo of the face</source>
        <translation>aucun profil trouvé sur la photo du visage de côté</translation>
    </message>
    <message>
        <source>No height was given: %1 cm is assumed, so every length is unscaled; %2</source>
        <translation>Aucune taille donnée : %1 cm sont supposés, les longueurs sont sans échelle ; %2</translation>
    </message>
    <message>
        <source>give --height-cm or height_cm in person.toml</source>
        <translation>donnez la taille sur la première page</translation>
    </message>
    <message>
        <source>%1: the clone covers the person&apos;s outline only to %2 percent</source>
        <translation>%1 : le clone ne couvre que %2 pour cent de la silhouette de la personne</translation>
    </message>
    <message>
        <source>%1: the clone covers the head&apos;s outline only to %2 percent</source>
        <translation>%1 : le clone ne couvre que %2 pour cent de la silhouette de la tête</translation>
    </message>
    <message>
        <source>%1: the hair is %2 times as large here as in the other photos, so this photo&apos;s was not used; take it again before a wall that looks unlike the hair</source>
        <translation>%1 : les cheveux sont ici %2 fois aussi grands que sur les autres photos ; cette photo n’a pas servi pour eux. Reprenez-la devant un mur qui ne ressemble pas aux cheveux</translation>
    </message>
    <message>
        <source>%1: nobody can be made out in this photo, so it was left out; retake it with hair, hood or scarf away from the face</source>
        <translation>%1 : on ne distingue personne sur cette photo, elle a donc été écartée ; reprenez-la sans cheveux, capuche ni foulard devant le visage</translation>
    </message>
    <message>
        <source>%1: hair hides the face in this photo, so it shows no more than the hair; retake it with hair, hood or scarf away from the face</source>
        <translation>%1 : sur cette photo les cheveux cachent le visage, elle ne montre donc que les cheveux ; reprenez-la sans cheveux, capuche ni foulard devant le visage</translation>
    </message>
    <message>
        <source>%1: the clone would cover only %2 percent of the person in this photo, so it was left out; check that it shows the same person in the same clothes, straight from the side or from behind</source>
        <translation>%1 : le clone ne couvrirait que %2 pour cent de la personne sur cette photo, elle a donc été écartée ; vérifiez qu&apos;elle montre la même personne dans les mêmes vêtements, bien de côté ou de dos</translation>
    </message>
    <message>
        <source>%1: the %2 arm of the clone lies %3 cm beside the arm in this photo; let the arms hang a little away from the body and retake it</source>
        <translation>%1 : le bras du clone (%2) se trouve à %3 cm du bras sur cette photo ; laissez pendre les bras un peu écartés du corps et reprenez-la</translation>
    </message>
    <message>
        <source>%1: the head is turned by about %2 degrees from where it should look; retake it with the head turned as the body</source>
        <translation>%1 : la tête est tournée d&apos;environ %2 degrés par rapport à la direction voulue ; reprenez-la, la tête orientée comme le corps</translation>
    </message>
    <message>
        <source>%1: the glasses became an object of their own and the skin behind their frame is a guess; take the face photos without glasses if you can</source>
        <translation>%1 : les lunettes sont devenues un objet à part et la peau derrière la monture est devinée ; prenez si possible les photos du visage sans lunettes</translation>
    </message>
    <message>
        <source>%1: headwear hides the hair and becomes part of the head; take it off if you can</source>
        <translation>%1 : un couvre-chef cache les cheveux et devient une partie de la tête ; enlevez-le si possible</translation>
    </message>
    <message>
        <source>%1: hair hides an eye, so what lies behind it is a guess; retake the face photos with the hair away from the face</source>
        <translation>%1 : des cheveux cachent un œil, ce qui est derrière est deviné ; reprenez les photos du visage, les cheveux dégagés</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>nothing can be written into this folder</source>
        <translation>rien ne peut être écrit dans ce dossier</translation>
    </message>
    <message>
        <source>the visitor cannot be moved</source>
        <translation>le visiteur ne peut pas être déplacé</translation>
    </message>
    <message>
        <source>these files still tell of who was deleted</source>
        <translation>ces fichiers parlent encore de personnes supprimées</translation>
    </message>
    <message>
        <source>Look at them: they may be copies</source>
        <translation>Regardez-les : ce sont peut-être des copies</translation>
    </message>
    <message>
        <source>there is no clone before this one</source>
        <translation>il n’y a pas de clone avant celui-ci</translation>
    </message>
    <message>
        <source>the page for telephones cannot be served</source>
        <translation>la page pour téléphones ne peut pas être servie</translation>
    </message>
    <message>
        <source>Is the booth&apos;s network up, and is nothing else served here?</source>
        <translation>Le réseau du stand marche-t-il, et rien d’autre n’est-il servi ici ?</translation>
    </message>
    <message>
        <source>an encrypted page needs a library that is not here</source>
        <translation>une page chiffrée demande une bibliothèque absente ici</translation>
    </message>
    <message>
        <source>Switch encryption off and use a hotspot of the booth&apos;s own with a password</source>
        <translation>Désactivez le chiffrement et utilisez un point d’accès à vous avec mot de passe</translation>
    </message>
    <message>
        <source>the keys cannot be written</source>
        <translation>les clés ne peuvent pas être écrites</translation>
    </message>
    <message>
        <source>Check its permissions and the space left, or choose another</source>
        <translation>Vérifiez ses droits et la place libre, ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>%1 was damaged and is put right from what could be read; the damaged file is kept beside it</source>
        <translation>%1 : endommagé et rétabli à partir de ce qui était lisible ; le fichier endommagé est gardé à côté</translation>
    </message>
    <message>
        <source>The event&apos;s settings</source>
        <extracomment>All that the library may say in the window. Files of the program&apos;s own, as the operator knows them.</extracomment>
        <translation>Les réglages de l’événement</translation>
    </message>
    <message>
        <source>The corrected points</source>
        <translation>Les points corrigés</translation>
    </message>
    <message>
        <source>What is known of the visitor</source>
        <translation>Ce qu’on sait du visiteur</translation>
    </message>
    <message>
        <source>The visit</source>
        <translation>La visite</translation>
    </message>
    <message>
        <source>The clone</source>
        <translation>Le clone</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Accord</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Imprimante</translation>
    </message>
    <message>
        <source>A photo</source>
        <translation>Une photo</translation>
    </message>
    <message>
        <source>its files were changed while they were read</source>
        <translation>ses fichiers ont changé pendant la lecture</translation>
    </message>
    <message>
        <source>gphoto2, which speaks with cameras, is not installed</source>
        <translation>gphoto2, qui parle avec les appareils, n’est pas installé</translation>
    </message>
    <message>
        <source>Install it, or let the camera&apos;s own program write into a folder and watch that</source>
        <translation>Installez-le, ou laissez le programme de l’appareil écrire dans un dossier à surveiller</translation>
    </message>
    <message>
        <source>no camera is found on the cable</source>
        <translation>aucun appareil n’est trouvé sur le câble</translation>
    </message>
    <message>
        <source>Is it switched on, and no other program using it? Plug it in again</source>
        <translation>Est-il allumé, et aucun autre programme ne l’utilise-t-il ? Rebranchez-le</translation>
    </message>
    <message>
        <source>the camera took no photo</source>
        <translation>l’appareil n’a pas pris de photo</translation>
    </message>
    <message>
        <source>the camera does not answer</source>
        <translation>l’appareil ne répond pas</translation>
    </message>
    <message>
        <source>what was written there reads differently</source>
        <translation>ce qui y a été écrit se relit autrement</translation>
    </message>
    <message>
        <source>Use another stick: this one loses what is written on it</source>
        <translation>Prenez une autre clé : celle-ci perd ce qu’on y écrit</translation>
    </message>
    <message>
        <source>this system does not tell which sticks are plugged in</source>
        <translation>ce système ne dit pas quelles clés sont branchées</translation>
    </message>
    <message>
        <source>Choose the stick&apos;s folder by hand</source>
        <translation>Choisissez le dossier de la clé à la main</translation>
    </message>
    <message>
        <source>no program that ejects sticks is installed</source>
        <translation>aucun programme pour éjecter les clés n’est installé</translation>
    </message>
    <message>
        <source>Eject it with the desktop&apos;s own files window before it is pulled out</source>
        <translation>Éjectez-la avec le gestionnaire de fichiers du bureau avant de la retirer</translation>
    </message>
    <message>
        <source>the stick cannot be ejected</source>
        <translation>la clé ne peut pas être éjectée</translation>
    </message>
    <message>
        <source>Close every window that shows its files, then eject it again</source>
        <translation>Fermez toute fenêtre qui montre ses fichiers, puis éjectez-la de nouveau</translation>
    </message>
    <message>
        <source>the printer does not answer</source>
        <translation>l’imprimante ne répond pas</translation>
    </message>
    <message>
        <source>Is it switched on, with paper in it? A file can be printed elsewhere</source>
        <translation>Est-elle allumée, avec du papier ? Un fichier peut être imprimé ailleurs</translation>
    </message>
    <message>
        <source>the file exists and is not replaced</source>
        <translation>le fichier existe et n&apos;est pas remplacé</translation>
    </message>
    <message>
        <source>Choose another --out file, or delete it</source>
        <translation>Choisissez un autre nom, ou supprimez-le</translation>
    </message>
    <message>
        <source>no file can be called that</source>
        <translation>aucun fichier ne peut porter ce nom</translation>
    </message>
    <message>
        <source>Choose another --out file</source>
        <translation>Choisissez un autre nom</translation>
    </message>
    <message>
        <source>this is no photo but a folder, a pipe or the like</source>
        <translation>ce n&apos;est pas une photo mais un dossier, un tube ou autre</translation>
    </message>
    <message>
        <source>Put the photo itself there</source>
        <translation>Placez-y la photo elle-même</translation>
    </message>
    <message>
        <source>Choose another --out folder or --id, or move those files away</source>
        <translation>Choisissez un autre dossier ou nom, ou déplacez ces fichiers</translation>
    </message>
    <message>
        <source>the photos lie where the result would, and are never replaced</source>
        <translation>les photos se trouvent à la place du résultat et ne sont jamais remplacées</translation>
    </message>
    <message>
        <source>the result of another visitor is there: other photos, from another folder</source>
        <translation>le résultat d&apos;un autre visiteur s&apos;y trouve : d&apos;autres photos, d&apos;un autre dossier</translation>
    </message>
    <message>
        <source>Choose another --id or --out folder, or forget that visitor first</source>
        <translation>Choisissez un autre nom ou dossier, ou supprimez d&apos;abord ce visiteur</translation>
    </message>
    <message>
        <source>the earlier result holds files of somebody&apos;s own (%1)</source>
        <translation>le résultat précédent contient des fichiers étrangers (%1)</translation>
    </message>
    <message>
        <source>this cannot be read: %1</source>
        <translation>ceci ne peut être lu : %1</translation>
    </message>
    <message>
        <source>the photo cannot be opened: %1</source>
        <translation>la photo ne peut être ouverte : %1</translation>
    </message>
    <message>
        <source>No photo could be laid on the body: it keeps one plain colour</source>
        <translation>Aucune photo n’a pu être posée sur le corps : il garde une seule couleur</translation>
    </message>
    <message>
        <source>%1: no focal length in the photo; %2 mm is assumed</source>
        <translation>%1 : pas de focale dans la photo ; %2 mm sont supposés</translation>
    </message>
    <message>
        <source>%1: no focal length in the photo; %2 assumed.</source>
        <translation>%1 : pas de focale dans la photo ; %2 supposé.</translation>
    </message>
    <message>
        <source>no photo shows the face from the front: the head is the generic one of this build</source>
        <translation>aucune photo ne montre le visage de face : la tête est celle, générique, de cette carrure</translation>
    </message>
    <message>
        <source>no usable front photo of the face: the face comes from the small one in the body photo</source>
        <translation>pas de photo de face utilisable : le visage vient du petit visage de la photo du corps</translation>
    </message>
    <message>
        <source>Loose clothing between hips and knees was given its own surface</source>
        <translation>Les vêtements amples entre hanches et genoux ont reçu leur propre surface</translation>
    </message>
    <message>
        <source>There is no body photo: the body is the generic one of a matching build, its colours a guess</source>
        <translation>Pas de photo du corps : le corps est celui, générique, d’une carrure assortie, ses couleurs sont devinées</translation>
    </message>
    <message>
        <source>There is no front photo of the body: its front is seen by the face photo alone</source>
        <translation>Pas de photo du corps de face : l’avant n’est vu que par la photo du visage</translation>
    </message>
    <message>
        <source>There is no side photo of the body: its depths are those of a usual body of this shape</source>
        <translation>Pas de photo du corps de côté : les profondeurs sont celles d’un corps usuel de cette forme</translation>
    </message>
    <message>
        <source>There is no back photo of the body: its back is coloured from what the other photos show</source>
        <translation>Pas de photo du corps de dos : le dos est coloré d’après les autres photos</translation>
    </message>
    <message>
        <source>corrections.json corrects %1, but there is no such photo: they are not used</source>
        <translation>corrections.json corrige %1, mais cette photo manque : ces corrections ne servent pas</translation>
    </message>
    <message>
        <source>%1 has changed since its points were corrected: check them</source>
        <translation>%1 a changé depuis la correction de ses points : vérifiez-les</translation>
    </message>
    <message>
        <source>%1: the corrected point %2 could not be obeyed: %3</source>
        <translation>%1 : le point corrigé %2 n’a pas pu être suivi : %3</translation>
    </message>
    <message>
        <source>it sets the scale of its photo; hair and soles are no skin that could be laid on it</source>
        <translation>il fixe l’échelle de sa photo ; cheveux et semelles ne sont pas de la peau à y poser</translation>
    </message>
    <message>
        <source>the face does not follow it, so the clone stays %1 px off it</source>
        <translation>le visage ne le suit pas, le clone en reste à %1 px</translation>
    </message>
    <message>
        <source>the limb does not reach it, so the clone stays %1 px off it</source>
        <translation>le membre ne l’atteint pas, le clone en reste à %1 px</translation>
    </message>
    <message>
        <source>no outline of the clone is seen there, so the point was left out</source>
        <translation>aucun contour du clone n’y est visible, le point est laissé de côté</translation>
    </message>
    <message>
        <source>the point lies %1 cm off the body, so it was left out: drag it back to the outline</source>
        <translation>le point est à %1 cm du corps et est laissé de côté : ramenez-le sur le contour</translation>
    </message>
    <message>
        <source>the skin would fold, so the clone stays %1 px off it</source>
        <translation>la peau ferait un pli, le clone en reste à %1 px</translation>
    </message>
    <message>
        <source>it contradicts %1, so the clone stays %2 px off it</source>
        <translation>il contredit %1, le clone en reste à %2 px</translation>
    </message>
    <message>
        <source>the clone does not tell its clothes from its skin</source>
        <translation>le clone ne distingue pas ses vêtements de sa peau</translation>
    </message>
    <message>
        <source>Clone the photos again</source>
        <translation>Clonez à nouveau les photos</translation>
    </message>
    <message>
        <source>no body could be made with a %1 of %2: %3 mm remain</source>
        <translation>aucun corps n&apos;a pu être fait avec %1 de %2 : il reste %3 mm</translation>
    </message>
    <message>
        <source>Measure it again, or leave it out</source>
        <translation>Mesurez à nouveau, ou laissez-la de côté</translation>
    </message>
    <message>
        <source>the sex %1 is not known</source>
        <translation>le sexe %1 n&apos;est pas connu</translation>
    </message>
    <message>
        <source>Give --sex f or --sex m</source>
        <translation>Donnez --sex f ou --sex m</translation>
    </message>
    <message>
        <source>a stature of %1 cm cannot be made</source>
        <translation>une taille de %1 cm ne peut pas être faite</translation>
    </message>
    <message>
        <source>Adults of %1 to %2 cm can be made</source>
        <translation>Des adultes de %1 à %2 cm peuvent être faits</translation>
    </message>
    <message>
        <source>At %1 years bodies of %2 to %3 cm can be made</source>
        <translation>À %1 ans, des corps de %2 à %3 cm sont possibles</translation>
    </message>
    <message>
        <source>an age of %1 years cannot be made</source>
        <translation>un âge de %1 ans n’est pas possible</translation>
    </message>
    <message>
        <source>People of %1 to %2 years can be made</source>
        <translation>Des personnes de %1 à %2 ans sont possibles</translation>
    </message>
    <message>
        <source>These can: %1</source>
        <translation>Celles-ci le peuvent : %1</translation>
    </message>
    <message>
        <source>a %1 of %2 is no body&apos;s of %3 cm</source>
        <translation>personne de %3 cm n&apos;a %1 de %2</translation>
    </message>
    <message>
        <source>%1 with the other measures</source>
        <translation>%1 avec les autres mesures</translation>
    </message>
    <message>
        <source>Measure again; %1 to %2 can be made</source>
        <translation>Mesurez à nouveau ; de %1 à %2 est possible</translation>
    </message>
    <message>
        <source>the %1 cannot be told, it follows from the others</source>
        <translation>%1 ne peut pas être donné, cela découle du reste</translation>
    </message>
    <message>
        <source>the %1 of %2 is smaller than the %3 of %4</source>
        <translation>%1 de %2 est plus petit que %3 de %4</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Mesurez à nouveau</translation>
    </message>
    <message>
        <source>Give --sex f or --sex m, or leave it out</source>
        <translation>Donnez --sex f ou --sex m, ou rien</translation>
    </message>
    <message>
        <source>no consent to being shown is recorded</source>
        <translation>aucun consentement à être montré n&apos;est noté</translation>
    </message>
    <message>
        <source>Write consent = &quot;...&quot; into person.toml and clone again</source>
        <translation>Faites consentir la personne à la première page et clonez à nouveau</translation>
    </message>
    <message>
        <source>Clones from %1 cm on can be</source>
        <translation>Les clones à partir de %1 cm le peuvent</translation>
    </message>
    <message>
        <source>a statue has no clothes to take off</source>
        <translation>une statue n&apos;a pas de vêtements à enlever</translation>
    </message>
    <message>
        <source>Undress the clone, then make a statue of it</source>
        <translation>Déshabillez le clone, puis faites-en une statue</translation>
    </message>
    <message>
        <source>a clone of %1 cm may be a child&apos;s and is not undressed</source>
        <translation>un clone de %1 cm peut être un enfant et n&apos;est pas déshabillé</translation>
    </message>
    <message>
        <source>the clone has no measures of its body</source>
        <translation>le clone n&apos;a pas de mesures de son corps</translation>
    </message>
    <message>
        <source>the stature is missing</source>
        <translation>la taille manque</translation>
    </message>
    <message>
        <source>Give --stature and as many measures as you know</source>
        <translation>Donnez la taille et autant de mesures que possible</translation>
    </message>
    <message>
        <source>the stature must be a length in centimetres</source>
        <translation>la taille doit être une longueur en centimètres</translation>
    </message>
    <message>
        <source>For example --stature 168</source>
        <translation>Par exemple 168</translation>
    </message>
    <message>
        <source>the drawing has a DOCTYPE</source>
        <translation>le dessin a un DOCTYPE</translation>
    </message>
    <message>
        <source>Save it as plain SVG</source>
        <translation>Enregistrez-le en SVG simple</translation>
    </message>
    <message>
        <source>a seam of the drawing does not name two edges</source>
        <translation>une couture du dessin ne nomme pas deux bords</translation>
    </message>
    <message>
        <source>See docs/cloth.md for how a garment is drawn</source>
        <translation>docs/cloth.md dit comment dessiner un vêtement</translation>
    </message>
    <message>
        <source>the drawing has no width in millimetres</source>
        <translation>le dessin n&apos;a pas de largeur en millimètres</translation>
    </message>
    <message>
        <source>Give it one, such as width=&quot;600mm&quot;</source>
        <translation>Donnez-lui-en une, comme width=&quot;600mm&quot;</translation>
    </message>
    <message>
        <source>the piece %1 has %2 edges and %3 names for them</source>
        <translation>la pièce %1 a %2 bords et %3 noms pour eux</translation>
    </message>
    <message>
        <source>Name every edge once, in the order of drawing</source>
        <translation>Nommez chaque bord une fois, dans l&apos;ordre du dessin</translation>
    </message>
    <message>
        <source>the file is no SVG</source>
        <translation>le fichier n&apos;est pas un SVG</translation>
    </message>
    <message>
        <source>a part of the drawing is transformed</source>
        <translation>une partie du dessin est transformée</translation>
    </message>
    <message>
        <source>Apply the transformation first</source>
        <translation>Appliquez d&apos;abord la transformation</translation>
    </message>
    <message>
        <source>the outline of the piece %1 has a command %2</source>
        <translation>le contour de la pièce %1 a une commande %2</translation>
    </message>
    <message>
        <source>the outline of the piece %1 ends early</source>
        <translation>le contour de la pièce %1 finit trop tôt</translation>
    </message>
    <message>
        <source>the outline of the piece %1 goes out of all bounds</source>
        <translation>le contour de la pièce %1 dépasse toutes les limites</translation>
    </message>
    <message>
        <source>the fabric %1 is not known</source>
        <translation>le tissu %1 n&apos;est pas connu</translation>
    </message>
    <message>
        <source>The fabrics are %1</source>
        <translation>Les tissus sont %1</translation>
    </message>
    <message>
        <source>the garment %1 cannot be laid round this body</source>
        <translation>le vêtement %1 ne peut pas être posé autour de ce corps</translation>
    </message>
    <message>
        <source>there is not memory enough for the cloth</source>
        <translation>il n’y a pas assez de mémoire pour le tissu</translation>
    </message>
    <message>
        <source>Make its triangles larger</source>
        <translation>Agrandissez ses triangles</translation>
    </message>
    <message>
        <source>the garment %1 is not known</source>
        <translation>le vêtement %1 n&apos;est pas connu</translation>
    </message>
    <message>
        <source>The garments are %1, or a .json or .svg file</source>
        <translation>Les vêtements sont %1, ou un fichier .json ou .svg</translation>
    </message>
    <message>
        <source>a %1 of %2 cm cannot be cut</source>
        <translation>%1 de %2 cm ne peut pas être coupé</translation>
    </message>
    <message>
        <source>%1 to %2 cm hang clear of the floor</source>
        <translation>%1 à %2 cm pendent sans toucher le sol</translation>
    </message>
    <message>
        <source>the motion %1 is not known</source>
        <translation>le mouvement %1 n&apos;est pas connu</translation>
    </message>
    <message>
        <source>Give walk, or a captured walk (.bvh)</source>
        <translation>Choisissez la marche propre ou une marche capturée (.bvh)</translation>
    </message>
    <message>
        <source>a garment has 1 to %1 pieces</source>
        <translation>un vêtement a de 1 à %1 pièces</translation>
    </message>
    <message>
        <source>See docs/cloth.md for the form of a garment&apos;s file</source>
        <translation>docs/cloth.md dit la forme du fichier d&apos;un vêtement</translation>
    </message>
    <message>
        <source>two pieces share one name</source>
        <translation>deux pièces ont le même nom</translation>
    </message>
    <message>
        <source>some pieces hang from a ring and others lie round the body</source>
        <translation>certaines pièces pendent d&apos;un anneau et d&apos;autres entourent le corps</translation>
    </message>
    <message>
        <source>the piece %1 lies round %2, which is no part</source>
        <translation>la pièce %1 entoure %2, qui n&apos;est pas une partie</translation>
    </message>
    <message>
        <source>A piece lies round %1</source>
        <translation>Une pièce entoure %1</translation>
    </message>
    <message>
        <source>Let every edge begin where the one before ends</source>
        <translation>Que chaque bord commence où finit le précédent</translation>
    </message>
    <message>
        <source>the piece %1 has fewer than two edges</source>
        <translation>la pièce %1 a moins de deux bords</translation>
    </message>
    <message>
        <source>the piece %1 has an edge that is no curve of four points</source>
        <translation>la pièce %1 a un bord qui n&apos;est pas une courbe de quatre points</translation>
    </message>
    <message>
        <source>the piece %1 has no garment&apos;s size</source>
        <translation>la pièce %1 n&apos;a pas la taille d&apos;un vêtement</translation>
    </message>
    <message>
        <source>Write metres</source>
        <translation>Écrivez des mètres</translation>
    </message>
    <message>
        <source>the outline of the piece %1 crosses itself</source>
        <translation>le contour de la pièce %1 se croise</translation>
    </message>
    <message>
        <source>Draw it without a loop</source>
        <translation>Dessinez-le sans boucle</translation>
    </message>
    <message>
        <source>the held edge %1 is in no piece</source>
        <translation>le bord tenu %1 n&apos;est dans aucune pièce</translation>
    </message>
    <message>
        <source>the seam&apos;s edge %1 is in no piece</source>
        <translation>le bord %1 de la couture n&apos;est dans aucune pièce</translation>
    </message>
    <message>
        <source>the edge %1 is sewn twice</source>
        <translation>le bord %1 est cousu deux fois</translation>
    </message>
    <message>
        <source>the edges %1 and %2 of a seam are %3 long</source>
        <translation>les bords %1 et %2 d&apos;une couture mesurent %3</translation>
    </message>
    <message>
        <source>Make them alike</source>
        <translation>Rendez-les pareils</translation>
    </message>
    <message>
        <source>the outline of the piece %1 is open</source>
        <translation>le contour de la pièce %1 est ouvert</translation>
    </message>
    <message>
        <source>the file is no garment</source>
        <translation>le fichier n&apos;est pas un vêtement</translation>
    </message>
    <message>
        <source>the piece %1 lies at heights that do not rise</source>
        <translation>la pièce %1 se trouve à des hauteurs qui ne montent pas</translation>
    </message>
    <message>
        <source>the clone would be replaced by itself dressed</source>
        <translation>le clone serait remplacé par lui-même habillé</translation>
    </message>
    <message>
        <source>the file is no garment of GarmentCode</source>
        <translation>le fichier n&apos;est pas un vêtement de GarmentCode</translation>
    </message>
    <message>
        <source>Write it again with GarmentCode, or draw it anew (docs/cloth.md)</source>
        <translation>Écrivez-le à nouveau avec GarmentCode, ou dessinez-le (docs/cloth.md)</translation>
    </message>
    <message>
        <source>the draft has no parts &apos;front&apos; and &apos;back&apos;</source>
        <translation>Le patron n’a pas de pièces « front » et « back »</translation>
    </message>
    <message>
        <source>Cloner reads fronts and backs on the fold and sleeves of one piece (docs/cloth.md)</source>
        <translation>Cloner lit les devants et dos au pli et les manches d’une pièce (docs/cloth.md)</translation>
    </message>
    <message>
        <source>the part %1 has no outline</source>
        <translation>La pièce %1 n’a pas de contour</translation>
    </message>
    <message>
        <source>the part %1 is not cut on the fold</source>
        <translation>La pièce %1 n’est pas coupée au pli</translation>
    </message>
    <message>
        <source>the part %1 has %2 edges from corner to corner, not hem, side, armhole, shoulder, neck</source>
        <translation>La pièce %1 a %2 bords d’un angle à l’autre, et non ourlet, côté, emmanchure, épaule, encolure</translation>
    </message>
    <message>
        <source>the armhole of the part %1 lies below this wearer&apos;s trunk</source>
        <translation>L’emmanchure de la pièce %1 se trouve sous le tronc de cette personne</translation>
    </message>
    <message>
        <source>Draft it to the wearer&apos;s measures, in millimetres</source>
        <translation>Tracez-le aux mesures de la personne, en millimètres</translation>
    </message>
    <message>
        <source>the sleeve has %1 edges from corner to corner, not hem, side, cap and side</source>
        <translation>La manche a %1 bords d’un angle à l’autre, et non ourlet, côté, tête et côté</translation>
    </message>
    <message>
        <source>the part %1 is no whole sleeve</source>
        <translation>La pièce %1 n’est pas une manche entière</translation>
    </message>
    <message>
        <source>the piece %1 has no edge to hang from</source>
        <translation>la pièce %1 n&apos;a pas de bord où pendre</translation>
    </message>
    <message>
        <source>Name the edge at the ring %1 and the lowest one %2</source>
        <translation>Nommez %1 le bord à l&apos;anneau et %2 le plus bas</translation>
    </message>
    <message>
        <source>no dressed clone is written as %1</source>
        <translation>aucun clone habillé ne s&apos;écrit en %1</translation>
    </message>
    <message>
        <source>Give --out a name that ends with %1</source>
        <translation>Choisissez un nom qui finit par %1</translation>
    </message>
    <message>
        <source>the blobs lie nowhere near most of the body</source>
        <translation>les blobs sont loin de presque tout le corps</translation>
    </message>
    <message>
        <source>cloner statue blobs CLONE --out body.json writes blobs to begin with</source>
        <translation>Commencez par les blobs que propose la fenêtre</translation>
    </message>
    <message>
        <source>a body has 1 to %1 blobs, not %2</source>
        <translation>un corps a de 1 à %1 blobs, pas %2</translation>
    </message>
    <message>
        <source>See docs/statues.md for how blobs are written</source>
        <translation>docs/statues.md dit comment écrire les blobs</translation>
    </message>
    <message>
        <source>blob %1 lacks its joint or radius, or tells more than blobs have</source>
        <translation>il manque au blob %1 l&apos;articulation ou le rayon, ou il en dit trop</translation>
    </message>
    <message>
        <source>blob %1 has no name of 1 to 60 letters</source>
        <translation>le blob %1 n&apos;a pas de nom de 1 à 60 lettres</translation>
    </message>
    <message>
        <source>the blob %1 needs a place for each end</source>
        <translation>le blob %1 a besoin d&apos;un lieu pour chaque bout</translation>
    </message>
    <message>
        <source>the %1 must be %2 numbers from %3 to %4</source>
        <translation>%1 doit être %2 nombres de %3 à %4</translation>
    </message>
    <message>
        <source>the blob %1 hangs on %2, which is no joint</source>
        <translation>le blob %1 pend à %2, qui n&apos;est pas une articulation</translation>
    </message>
    <message>
        <source>Joints have H-Anim&apos;s names</source>
        <translation>Les articulations ont les noms de H-Anim</translation>
    </message>
    <message>
        <source>the file holds no list of %1</source>
        <translation>le fichier ne contient pas de liste de %1</translation>
    </message>
    <message>
        <source>the %1 are no JSON</source>
        <translation>%1 : ce n&apos;est pas du JSON</translation>
    </message>
    <message>
        <source>%1 markers are too few</source>
        <translation>%1 repères sont trop peu</translation>
    </message>
    <message>
        <source>Mark at least %1 vertices</source>
        <translation>Marquez au moins %1 sommets</translation>
    </message>
    <message>
        <source>a marker&apos;s vertex is not on the mesh</source>
        <translation>le sommet d&apos;un repère n&apos;est pas sur le maillage</translation>
    </message>
    <message>
        <source>It has %1 of them</source>
        <translation>Il en a %1</translation>
    </message>
    <message>
        <source>two markers lie on the same vertex</source>
        <translation>deux repères sont sur le même sommet</translation>
    </message>
    <message>
        <source>Leave one of them out</source>
        <translation>Enlevez l&apos;un d&apos;eux</translation>
    </message>
    <message>
        <source>all markers lie on one line</source>
        <translation>tous les repères sont sur une ligne</translation>
    </message>
    <message>
        <source>Mark vertices beside it too</source>
        <translation>Marquez aussi à côté</translation>
    </message>
    <message>
        <source>markers on mesh and photo differ in number</source>
        <translation>les repères du maillage et de la photo diffèrent en nombre</translation>
    </message>
    <message>
        <source>Give each both places</source>
        <translation>Donnez à chacun ses deux lieux</translation>
    </message>
    <message>
        <source>all markers lie at one place of the photo</source>
        <translation>tous les repères sont au même endroit de la photo</translation>
    </message>
    <message>
        <source>Drag them to their places</source>
        <translation>Tirez-les à leur place</translation>
    </message>
    <message>
        <source>a mesh from elsewhere keeps the photo&apos;s colours</source>
        <translation>un maillage d&apos;ailleurs garde les couleurs de la photo</translation>
    </message>
    <message>
        <source>Leave --material out</source>
        <translation>Laissez la matière de côté</translation>
    </message>
    <message>
        <source>neck girth</source>
        <translation>le tour de cou</translation>
    </message>
    <message>
        <source>bust girth</source>
        <translation>le tour de poitrine</translation>
    </message>
    <message>
        <source>underbust girth</source>
        <translation>le tour de dessous de poitrine</translation>
    </message>
    <message>
        <source>waist girth</source>
        <translation>le tour de taille</translation>
    </message>
    <message>
        <source>hip girth</source>
        <translation>le tour de hanches</translation>
    </message>
    <message>
        <source>thigh girth</source>
        <translation>le tour de cuisse</translation>
    </message>
    <message>
        <source>inside leg height</source>
        <translation>l&apos;entrejambe</translation>
    </message>
    <message>
        <source>arm length</source>
        <translation>la longueur du bras</translation>
    </message>
    <message>
        <source>skirt</source>
        <translation>jupe</translation>
    </message>
    <message>
        <source>circle-skirt</source>
        <translation>jupe cercle</translation>
    </message>
    <message>
        <source>straight-skirt</source>
        <translation>jupe droite</translation>
    </message>
    <message>
        <source>long-skirt</source>
        <translation>jupe longue</translation>
    </message>
    <message>
        <source>cape</source>
        <translation>cape</translation>
    </message>
    <message>
        <source>tee</source>
        <translation>t-shirt</translation>
    </message>
    <message>
        <source>dress</source>
        <translation>robe</translation>
    </message>
    <message>
        <source>coat</source>
        <translation>manteau</translation>
    </message>
    <message>
        <source>trousers</source>
        <translation>pantalon</translation>
    </message>
</context>
<context>
    <name>troubles</name>
    <message>
        <source>Nobody was found: take it again with the person in full view.</source>
        <extracomment>One sentence each: what is wrong with a photo and what to do, for an operator with the visitor still there.</extracomment>
        <translation>Personne trouvé : reprenez, la personne bien en vue.</translation>
    </message>
    <message>
        <source>More than one person: take it again with one person alone.</source>
        <translation>Plus d’une personne : reprenez avec une seule.</translation>
    </message>
    <message>
        <source>The person lies on the side: turn the photo.</source>
        <translation>La personne est couchée : tournez la photo.</translation>
    </message>
    <message>
        <source>It shows none of the five views: turn the person or retake.</source>
        <translation>Ne montre aucune des cinq vues : tournez la personne ou reprenez.</translation>
    </message>
    <message>
        <source>It does not show this view: exchange or retake it.</source>
        <translation>Ne montre pas cette vue : échangez ou reprenez.</translation>
    </message>
    <message>
        <source>The person is cut off: step back and retake.</source>
        <translation>La personne est coupée : reculez et reprenez.</translation>
    </message>
    <message>
        <source>The person is small: step nearer or zoom in.</source>
        <translation>La personne est petite : approchez ou zoomez.</translation>
    </message>
    <message>
        <source>It is blurred: hold still, focus and retake.</source>
        <translation>Photo floue : ne bougez pas, faites le point, reprenez.</translation>
    </message>
    <message>
        <source>It is dark: add light or expose longer.</source>
        <translation>Photo sombre : plus de lumière ou pose plus longue.</translation>
    </message>
    <message>
        <source>It is burnt out: less light or a shorter exposure.</source>
        <translation>Photo surexposée : moins de lumière ou pose plus courte.</translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>Body, front</source>
        <extracomment>``translate(&quot;page&quot;, &quot;Text&quot;)``: Qt&apos;s own tools find these calls and write them into the translators&apos; files.</extracomment>
        <translation>Corps, face</translation>
    </message>
    <message>
        <source>Body, side</source>
        <translation>Corps, côté</translation>
    </message>
    <message>
        <source>Body, back</source>
        <translation>Corps, dos</translation>
    </message>
    <message>
        <source>Face, front</source>
        <translation>Visage, face</translation>
    </message>
    <message>
        <source>Face, side</source>
        <translation>Visage, côté</translation>
    </message>
</context>
<context>
    <name>visitor</name>
    <message>
        <source>known</source>
        <translation>connue</translation>
    </message>
    <message>
        <source>Height is known</source>
        <translation>La taille est connue</translation>
    </message>
    <message>
        <source>Height in centimetres</source>
        <translation>Taille en centimètres</translation>
    </message>
    <message>
        <source>Height, feet</source>
        <translation>Taille, pieds</translation>
    </message>
    <message>
        <source>Height, inches</source>
        <translation>Taille, pouces</translation>
    </message>
    <message>
        <source>Unit of the height</source>
        <translation>Unité de la taille</translation>
    </message>
    <message>
        <source>The visitor has to agree before photos are taken.</source>
        <extracomment>Typing that rests so long is saved, milliseconds.</extracomment>
        <translation>Le visiteur doit accepter avant les photos.</translation>
    </message>
    <message>
        <source>N&amp;ame or number</source>
        <translation>N&amp;om ou numéro</translation>
    </message>
    <message>
        <source>&amp;Height without shoes</source>
        <translation>&amp;Taille sans chaussures</translation>
    </message>
    <message>
        <source>&amp;Language of the consent</source>
        <translation>&amp;Langue du consentement</translation>
    </message>
    <message>
        <source>Who may use the &amp;files</source>
        <translation>Qui peut utiliser les &amp;fichiers</translation>
    </message>
    <message>
        <source>The visitor has read this and &amp;agrees</source>
        <translation>Le visiteur a lu ceci et &amp;accepte</translation>
    </message>
    <message>
        <source>May be seen on the &amp;screen for visitors</source>
        <translation>Peut être montré sur l’é&amp;cran des visiteurs</translation>
    </message>
    <message>
        <source>Agrees: on to the &amp;photos</source>
        <translation>D’accord : vers les &amp;photos</translation>
    </message>
    <message>
        <source>To find each other again; a number will do, or nothing at all.</source>
        <translation>Pour se retrouver ; un numéro suffit, ou rien du tout.</translation>
    </message>
    <message>
        <source>With the first name, among the others of today; asked apart.</source>
        <translation>Avec le prénom, parmi les autres du jour ; demandé à part.</translation>
    </message>
    <message>
        <source>Name or number of the visitor</source>
        <translation>Nom ou numéro du visiteur</translation>
    </message>
    <message>
        <source>Language of the consent</source>
        <translation>Langue du consentement</translation>
    </message>
    <message>
        <source>Who may use the files</source>
        <translation>Qui peut utiliser les fichiers</translation>
    </message>
    <message>
        <source>The visitor agrees</source>
        <translation>Le visiteur accepte</translation>
    </message>
    <message>
        <source>May be seen on the screen for visitors</source>
        <translation>Peut être montré sur l’écran des visiteurs</translation>
    </message>
    <message>
        <source>It gives the clone its true size; everything else is measured in the photos.</source>
        <translation>Elle donne au clone sa vraie taille ; tout le reste est mesuré sur les photos.</translation>
    </message>
    <message>
        <source>Unknown: {n} cm is assumed, and every length is unscaled.</source>
        <translation>Inconnue : {n} cm sont supposés, les longueurs sont sans échelle.</translation>
    </message>
    <message>
        <source>Recorded: {text}</source>
        <translation>Noté : {text}</translation>
    </message>
    <message>
        <source>The clone may &amp;walk in the scene “{scene}”</source>
        <translation>Le clone peut &amp;marcher dans la scène « {scene} »</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Visiteur</translation>
    </message>
    <message>
        <source>Begin with a visitor first.</source>
        <translation>Commencez d’abord avec un visiteur.</translation>
    </message>
    <message>
        <source>Visitors</source>
        <translation>Visiteurs</translation>
    </message>
    <message>
        <source>&amp;New visitor</source>
        <translation>&amp;Nouveau visiteur</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Visitors of this event</source>
        <translation>Visiteurs de cet événement</translation>
    </message>
    <message>
        <source>No event is open.</source>
        <translation>Aucun événement ouvert.</translation>
    </message>
    <message>
        <source>Open the event&apos;s folder; an empty one begins a new event.</source>
        <translation>Ouvrez le dossier de l’événement ; un dossier vide en commence un nouveau.</translation>
    </message>
    <message>
        <source>Press New visitor when somebody steps up.</source>
        <translation>Appuyez sur Nouveau visiteur quand quelqu’un se présente.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Save everything held…</source>
        <translation>&amp;Enregistrer toutes les données…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Supprimer…</translation>
    </message>
    <message>
        <source>Opening {name}…</source>
        <translation>Ouverture de {name}…</translation>
    </message>
    <message>
        <source>Visitor {n}</source>
        <extracomment>Folders where they lie now, and what went wrong with others.</extracomment>
        <translation>Visiteur {n}</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Ouverts récemment</translation>
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
        <translation>&amp;Prendre la photo</translation>
    </message>
    <message>
        <source>T&amp;urn the picture</source>
        <translation>&amp;Tourner l’image</translation>
    </message>
    <message>
        <source>Fill the outline, and keep all of it in the picture.</source>
        <translation>Remplissez le contour et gardez-le entier dans l’image.</translation>
    </message>
    <message>
        <source>Camera on a cable</source>
        <translation>Appareil sur câble</translation>
    </message>
    <message>
        <source>Which camera takes it</source>
        <translation>Quel appareil la prend</translation>
    </message>
    <message>
        <source>Which photo is taken</source>
        <translation>Quelle photo est prise</translation>
    </message>
    <message>
        <source>Live picture</source>
        <translation>Image en direct</translation>
    </message>
</context>
<context>
    <name>window</name>
    <message>
        <source>Folder of the event, or of one visitor</source>
        <extracomment>Names under which a visit&apos;s file remembers the page.</extracomment>
        <translation>Dossier de l’événement ou d’un visiteur</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retour</translation>
    </message>
    <message>
        <source>L&amp;ook at the points</source>
        <translation>Voir les p&amp;oints</translation>
    </message>
    <message>
        <source>Ne&amp;xt visitor</source>
        <translation>Visiteur s&amp;uivant</translation>
    </message>
    <message>
        <source>&amp;Clone</source>
        <translation>&amp;Cloner</translation>
    </message>
    <message>
        <source>Ne&amp;xt</source>
        <translation>S&amp;uivant</translation>
    </message>
    <message>
        <source>{n} more</source>
        <extracomment>How long good news is shown, milliseconds; what went wrong stays until somebody closes it or the visitor goes.</extracomment>
        <translation>{n} de plus</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Step {n}: {title}</source>
        <translation>Étape {n} : {title}</translation>
    </message>
    <message>
        <source>{name} waits for the clone now: it was not asked for.</source>
        <translation>{name} attend maintenant son clone : il n’avait pas été demandé.</translation>
    </message>
    <message>
        <source>{name} lies in the trash for {n} days.</source>
        <translation>{name} reste {n} jours dans la corbeille.</translation>
    </message>
    <message>
        <source>{name}: the clone before is back. The other one is kept: the same again.</source>
        <translation>{name} : le clone précédent est de retour. L’autre est gardé : refaites la même chose.</translation>
    </message>
    <message>
        <source>{name}: the clone is ready.</source>
        <translation>{name} : le clone est prêt.</translation>
    </message>
</context>
<context>
    <name>worth</name>
    <message>
        <source>the height</source>
        <translation>la taille</translation>
    </message>
    <message>
        <source>the face</source>
        <translation>le visage</translation>
    </message>
    <message>
        <source>the pose</source>
        <translation>la pose</translation>
    </message>
    <message>
        <source>how broad the body is</source>
        <translation>la largeur du corps</translation>
    </message>
    <message>
        <source>All points are sure: the clone needs no hand.</source>
        <translation>Tous les points sont sûrs : le clone n’a besoin d’aucune retouche.</translation>
    </message>
    <message>
        <source> and {n} more</source>
        <translation> et {n} de plus</translation>
    </message>
    <message>
        <source>Worth a look under Points: {names}. They set {changes}.</source>
        <translation>À regarder sous Points : {names}. En dépendent : {changes}.</translation>
    </message>
</context>
</TS>
