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
    <name>clone</name>
    <message>
        <source>Clone</source>
        <extracomment>Stages that the five parts of the work end with, in order; between them the operator sees which part is under way.</extracomment>
        <translation>Cloner</translation>
    </message>
    <message>
        <source>Clone first.</source>
        <translation>Clonez d’abord.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
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
</context>
<context>
    <name>consent</name>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept for the time named at the booth. I can have everything deleted at any time.</source>
        <extracomment>What visitors agree to, unless the event has a text of its own.</extracomment>
        <translation>J’accepte que des photos de moi soient prises ici, qu’une image de moi en trois dimensions en soit tirée sur cet ordinateur et que les deux soient conservées pendant la durée indiquée au stand. Je peux faire tout effacer à tout moment.</translation>
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
    <name>hints</name>
    <message>
        <source>Your own point on the outline: drag it on to the border of the person.</source>
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
</context>
<context>
    <name>photos</name>
    <message>
        <source>Photos</source>
        <translation>Photos</translation>
    </message>
    <message>
        <source>Add the photos first.</source>
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
        <translation>Ajoutez d’abord des photos.</translation>
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
        <source>Whole person</source>
        <translation>Personne entière</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Visage</translation>
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
        <source>Days that visitors are kept</source>
        <translation>Jours de conservation des visiteurs</translation>
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
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>takeaway</name>
    <message>
        <source>Writing the files…</source>
        <translation>Écriture des fichiers…</translation>
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
        <source>Copy to &amp;stick or folder…</source>
        <translation>Copier sur &amp;clé ou dossier…</translation>
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
        <source>Show f&amp;older</source>
        <translation>Montrer le d&amp;ossier</translation>
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
        <source>Where the files were put</source>
        <translation>Où les fichiers ont été mis</translation>
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
        <source>Copy the files first, or type an address.</source>
        <translation>Copiez d’abord les fichiers, ou tapez une adresse.</translation>
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
        <source>The visitor has read this and &amp;agrees</source>
        <translation>Le visiteur a lu ceci et &amp;accepte</translation>
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
        <source>The visitor agrees</source>
        <translation>Le visiteur accepte</translation>
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
        <source>&amp;Open event…</source>
        <translation>&amp;Ouvrir l’événement…</translation>
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
        <source>Ne&amp;xt visitor</source>
        <translation>Visiteur s&amp;uivant</translation>
    </message>
    <message>
        <source>Ne&amp;xt</source>
        <translation>S&amp;uivant</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Step {n}: {title}</source>
        <translation>Étape {n} : {title}</translation>
    </message>
</context>
</TS>
