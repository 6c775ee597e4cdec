<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>PhotoView</name>
    <message>
        <source>Remove this outline point</source>
        <translation>Bu kontur noktasını kaldır</translation>
    </message>
    <message>
        <source>Use the proposal for %1 again</source>
        <translation>%1 için öneriyi yeniden kullan</translation>
    </message>
    <message>
        <source>Add an outline point here</source>
        <translation>Buraya kontur noktası ekle</translation>
    </message>
</context>
<context>
    <name>Preview</name>
    <message>
        <source>The clone in three dimensions</source>
        <translation>Üç boyutlu klon</translation>
    </message>
    <message>
        <source>Press Clone: after about a minute the person stands here.</source>
        <translation>Klonla düğmesine basın: yaklaşık bir dakika sonra kişi burada durur.</translation>
    </message>
    <message>
        <source>This machine cannot draw in 3-D</source>
        <translation>Bu bilgisayar 3B çizemiyor</translation>
    </message>
</context>
<context>
    <name>SmallPhoto</name>
    <message numerus="yes">
        <source>%n doubtful point(s)</source>
        <translation>
            <numerusform>%n kuşkulu nokta</numerusform>
        </translation>
    </message>
    <message>
        <source>no points yet</source>
        <translation>henüz nokta yok</translation>
    </message>
</context>
<context>
    <name>blobs</name>
    <message>
        <source>belly</source>
        <translation>karın</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>bel</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>göğüs</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>boyun</translation>
    </message>
    <message>
        <source>pelvis</source>
        <translation>leğen</translation>
    </message>
    <message>
        <source>chest, across</source>
        <translation>göğüs, enine</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>omuzlar</translation>
    </message>
    <message>
        <source>buttock</source>
        <translation>kalça</translation>
    </message>
    <message>
        <source>breast</source>
        <translation>meme</translation>
    </message>
    <message>
        <source>shoulder&apos;s muscle</source>
        <translation>omuz kası</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>uyluk</translation>
    </message>
    <message>
        <source>lower leg</source>
        <translation>alt bacak</translation>
    </message>
    <message>
        <source>calf</source>
        <translation>baldır</translation>
    </message>
    <message>
        <source>kneecap</source>
        <translation>diz kapağı</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>üst kol</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>ön kol</translation>
    </message>
</context>
<context>
    <name>clone</name>
    <message>
        <source>Clone</source>
        <translation>Klonla</translation>
    </message>
    <message>
        <source>Clone first.</source>
        <translation>Önce klonlayın.</translation>
    </message>
    <message>
        <source>The clone is being made; the next visitor can come.</source>
        <extracomment>Stages that the five parts of the work end with, in order; between them the operator sees which part is under way.</extracomment>
        <translation>Klon yapılıyor; sıradaki ziyaretçi gelebilir.</translation>
    </message>
    <message>
        <source>Sho&amp;w it off</source>
        <translation>&amp;Sergile</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>&amp;Vazgeç</translation>
    </message>
    <message>
        <source>The clone be&amp;fore</source>
        <translation>Ön&amp;ceki klon</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Noktalar</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Beden</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Baş</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>Saç</translation>
    </message>
    <message>
        <source>Texture and files</source>
        <translation>Doku ve dosyalar</translation>
    </message>
    <message>
        <source>Press Clone: after about a minute the person stands here.</source>
        <translation>Klonla düğmesine basın: yaklaşık bir dakika sonra kişi burada durur.</translation>
    </message>
    <message>
        <source>C&amp;lone again</source>
        <translation>Yeniden k&amp;lonla</translation>
    </message>
    <message>
        <source>C&amp;lone</source>
        <translation>K&amp;lonla</translation>
    </message>
    <message>
        <source>Points or height were changed since: what is seen and taken away is the clone before.</source>
        <translation>Noktalar ya da boy sonradan değişti: görülen ve götürülen, önceki klondur.</translation>
    </message>
</context>
<context>
    <name>consent</name>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept for {days} days and then deleted. I can have everything deleted at any time.</source>
        <extracomment>What visitors agree to, unless the event has a text of its own.</extracomment>
        <translation>Burada fotoğraflarımın çekilmesini, bu bilgisayarda onlardan üç boyutlu bir benzerimin yapılmasını ve ikisinin de {days} gün saklanıp sonra silinmesini kabul ediyorum. İstediğim zaman her şeyi sildirebilirim.</translation>
    </message>
    <message>
        <source>I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, and that both are kept until I have them deleted. I can have everything deleted at any time.</source>
        <extracomment>The same where an event keeps its visitors until somebody deletes them.</extracomment>
        <translation>Burada fotoğraflarımın çekilmesini, bu bilgisayarda onlardan üç boyutlu bir benzerimin yapılmasını ve ben sildirene kadar ikisinin de saklanmasını kabul ediyorum. İstediğim zaman her şeyi sildirebilirim.</translation>
    </message>
</context>
<context>
    <name>day</name>
    <message>
        <source>{day}: {n} visitors, {m} clones.</source>
        <translation>{day}: {n} ziyaretçi, {m} klon.</translation>
    </message>
    <message>
        <source>{n} of them lie in the trash.</source>
        <translation>{n} tanesi çöp kutusunda.</translation>
    </message>
    <message>
        <source>In the queue {m} minutes in the middle, {l} at most.</source>
        <translation>Kuyrukta ortanca {m} dakika, en çok {l}.</translation>
    </message>
    <message>
        <source>Refused: {reasons}.</source>
        <translation>Geri çevrilen: {reasons}.</translation>
    </message>
</context>
<context>
    <name>fabrics</name>
    <message>
        <source>Silk</source>
        <translation>İpek</translation>
    </message>
    <message>
        <source>Cotton</source>
        <translation>Pamuk</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>Keten</translation>
    </message>
    <message>
        <source>Wool</source>
        <translation>Yün</translation>
    </message>
    <message>
        <source>Denim</source>
        <translation>Kot</translation>
    </message>
    <message>
        <source>Burlap</source>
        <translation>Çuval bezi</translation>
    </message>
</context>
<context>
    <name>formats</name>
    <message>
        <source>GLB: games, web, telephone</source>
        <translation>GLB: oyun, web, telefon</translation>
    </message>
    <message>
        <source>VRML97: H-Anim players</source>
        <translation>VRML97: H-Anim oynatıcılar</translation>
    </message>
    <message>
        <source>X3D: H-Anim with one skin</source>
        <translation>X3D: tek derili H-Anim</translation>
    </message>
    <message>
        <source>VRM: virtual meeting places</source>
        <translation>VRM: sanal buluşma yerleri</translation>
    </message>
    <message>
        <source>OBJ: any 3-D program</source>
        <translation>OBJ: her 3B program</translation>
    </message>
    <message>
        <source>PLY: 3-D printing</source>
        <translation>PLY: 3B baskı</translation>
    </message>
</context>
<context>
    <name>gallery</name>
    <message>
        <source>Everybody of today</source>
        <extracomment>What is shown: everybody, the cloned, those without a clone, who lies in the trash.</extracomment>
        <translation>Bugünkü herkes</translation>
    </message>
    <message>
        <source>Name or number</source>
        <translation>Ad ya da numara</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>herkes</translation>
    </message>
    <message>
        <source>with a clone</source>
        <translation>klonu olanlar</translation>
    </message>
    <message>
        <source>without a clone</source>
        <translation>klonu olmayanlar</translation>
    </message>
    <message>
        <source>in the trash</source>
        <translation>çöpte</translation>
    </message>
    <message>
        <source>Search by name or number</source>
        <translation>Ada ya da numaraya göre ara</translation>
    </message>
    <message>
        <source>Who is shown</source>
        <translation>Kim gösteriliyor</translation>
    </message>
    <message>
        <source>Visitors of this event</source>
        <translation>Bu etkinliğin ziyaretçileri</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Aç</translation>
    </message>
    <message>
        <source>Clone &amp;again</source>
        <translation>&amp;Yeniden klonla</translation>
    </message>
    <message>
        <source>The clone be&amp;fore</source>
        <translation>Ön&amp;ceki klon</translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation>Çö&amp;pe at</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>&amp;Geri al</translation>
    </message>
    <message>
        <source>&amp;Delete for good…</source>
        <translation>Tümüyle &amp;sil…</translation>
    </message>
    <message>
        <source>Save the &amp;numbers of the days…</source>
        <translation>&amp;Günlerin sayılarını kaydet…</translation>
    </message>
    <message>
        <source>{n} visitors, {m} with a clone</source>
        <translation>{n} ziyaretçi, {m} klonlu</translation>
    </message>
    <message>
        <source>deleted for good on {when}</source>
        <translation>tümüyle silinme: {when}</translation>
    </message>
</context>
<context>
    <name>garments</name>
    <message>
        <source>Skirt</source>
        <translation>Etek</translation>
    </message>
    <message>
        <source>Circle skirt</source>
        <translation>Kloş etek</translation>
    </message>
    <message>
        <source>Straight skirt</source>
        <translation>Düz etek</translation>
    </message>
    <message>
        <source>Long skirt</source>
        <translation>Uzun etek</translation>
    </message>
    <message>
        <source>Cape</source>
        <translation>Pelerin</translation>
    </message>
    <message>
        <source>T-shirt</source>
        <translation>Tişört</translation>
    </message>
    <message>
        <source>Dress</source>
        <translation>Elbise</translation>
    </message>
    <message>
        <source>Coat</source>
        <translation>Palto</translation>
    </message>
    <message>
        <source>Trousers</source>
        <translation>Pantolon</translation>
    </message>
    <message>
        <source>GLB: the clone walks in it</source>
        <extracomment>What a dressed clone is written as, by file ending; a folder has none.</extracomment>
        <translation>GLB: klon onunla yürür</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4 filmi</translation>
    </message>
    <message>
        <source>WebP film</source>
        <translation>WebP filmi</translation>
    </message>
    <message>
        <source>GIF film</source>
        <translation>GIF filmi</translation>
    </message>
    <message>
        <source>USD: the garment alone</source>
        <translation>USD: yalnız giysi</translation>
    </message>
    <message>
        <source>PC2 and OBJ: the garment alone</source>
        <translation>PC2 ve OBJ: yalnız giysi</translation>
    </message>
    <message>
        <source>Folder: a clone in it, whose cloth flows in crowds</source>
        <translation>Klasör: içinde bir klon; kumaşı kalabalıklarda dalgalanır</translation>
    </message>
</context>
<context>
    <name>hints</name>
    <message>
        <source>Your own point on the outline: drag it on to the border of the person.</source>
        <extracomment>Hint for every point whose name, without its side, begins so; the longest beginning wins.</extracomment>
        <translation>Kendi kontur noktanız: kişinin kenarına sürükleyin.</translation>
    </message>
    <message>
        <source>Highest point of the skull: under the hair, not on top of it.</source>
        <translation>Kafatasının en yüksek noktası: saçın altı, üstü değil.</translation>
    </message>
    <message>
        <source>Lowest edge of the shoe or foot: it sets the height of the person.</source>
        <translation>Ayakkabının veya ayağın en alt kenarı: kişinin boyunu belirler.</translation>
    </message>
    <message>
        <source>Foremost point of the shoe or foot.</source>
        <translation>Ayakkabının veya ayağın en ön noktası.</translation>
    </message>
    <message>
        <source>Hindmost point of the shoe or foot.</source>
        <translation>Ayakkabının veya ayağın en arka noktası.</translation>
    </message>
    <message>
        <source>Outline at the narrowest place of the trunk.</source>
        <translation>Gövdenin en dar yerindeki kontur.</translation>
    </message>
    <message>
        <source>Outline at the widest place of the hips.</source>
        <translation>Kalçanın en geniş yerindeki kontur.</translation>
    </message>
    <message>
        <source>Outline of the leg at the middle of the kneecap.</source>
        <translation>Diz kapağı ortasında bacağın konturu.</translation>
    </message>
    <message>
        <source>Outline of the leg at its narrowest place above the foot.</source>
        <translation>Ayağın üstünde bacağın en dar yerindeki kontur.</translation>
    </message>
    <message>
        <source>Outline of the lower leg where the calf is thickest.</source>
        <translation>Baldırın en kalın yerinde alt bacağın konturu.</translation>
    </message>
    <message>
        <source>Outline of the arm at the bend of the elbow.</source>
        <translation>Dirsek bükümünde kolun konturu.</translation>
    </message>
    <message>
        <source>Outline of the arm at its narrowest place before the hand.</source>
        <translation>Elden önce kolun en dar yerindeki kontur.</translation>
    </message>
    <message>
        <source>Outline where the shoulder turns down into the arm.</source>
        <translation>Omzun kola indiği yerdeki kontur.</translation>
    </message>
    <message>
        <source>Outline where the neck turns into the shoulder.</source>
        <translation>Boynun omza geçtiği yerdeki kontur.</translation>
    </message>
    <message>
        <source>Outline of the neck at half its height.</source>
        <translation>Boynun yarı yüksekliğindeki kontur.</translation>
    </message>
    <message>
        <source>Where the arm meets the trunk: the end of the gap between them.</source>
        <translation>Kolun gövdeyle birleştiği yer: aralarındaki boşluğun sonu.</translation>
    </message>
    <message>
        <source>Where the legs meet: the top of the gap between them.</source>
        <translation>Bacakların birleştiği yer: aralarındaki boşluğun tepesi.</translation>
    </message>
    <message>
        <source>Foremost outline of the chest.</source>
        <translation>Göğsün en ön konturu.</translation>
    </message>
    <message>
        <source>Foremost outline of the belly.</source>
        <translation>Karnın en ön konturu.</translation>
    </message>
    <message>
        <source>Hindmost outline of the upper back.</source>
        <translation>Üst sırtın en arka konturu.</translation>
    </message>
    <message>
        <source>Hindmost outline of the seat.</source>
        <translation>Kalçanın en arka konturu.</translation>
    </message>
    <message>
        <source>Outline of the thigh at half its length.</source>
        <translation>Uyluğun yarı uzunluğundaki kontur.</translation>
    </message>
    <message>
        <source>Middle of the joint inside the limb: where it bends, not on the outline.</source>
        <translation>Eklemin iç ortası: büküldüğü yer, kontur değil.</translation>
    </message>
    <message>
        <source>Middle of the pupil.</source>
        <translation>Göz bebeğinin ortası.</translation>
    </message>
    <message>
        <source>Corner of the eye towards the nose.</source>
        <translation>Gözün burun tarafındaki köşesi.</translation>
    </message>
    <message>
        <source>Corner of the eye towards the ear.</source>
        <translation>Gözün kulak tarafındaki köşesi.</translation>
    </message>
    <message>
        <source>Edge of the upper lid, above the pupil.</source>
        <translation>Üst göz kapağının kenarı, göz bebeğinin üstünde.</translation>
    </message>
    <message>
        <source>Edge of the lower lid, below the pupil.</source>
        <translation>Alt göz kapağının kenarı, göz bebeğinin altında.</translation>
    </message>
    <message>
        <source>Corner of the closed mouth.</source>
        <translation>Kapalı ağzın köşesi.</translation>
    </message>
    <message>
        <source>Upper edge of the upper lip, in the middle.</source>
        <translation>Üst dudağın üst kenarı, ortada.</translation>
    </message>
    <message>
        <source>Lower edge of the lower lip, in the middle.</source>
        <translation>Alt dudağın alt kenarı, ortada.</translation>
    </message>
    <message>
        <source>Middle of the line between the closed lips.</source>
        <translation>Kapalı dudaklar arasındaki çizginin ortası.</translation>
    </message>
    <message>
        <source>Outermost point of the wing of the nose.</source>
        <translation>Burun kanadının en dış noktası.</translation>
    </message>
    <message>
        <source>Tip of the nose; in the side photo its foremost point.</source>
        <translation>Burun ucu; yan fotoğrafta en ön noktası.</translation>
    </message>
    <message>
        <source>Deepest place of the root of the nose, between the eyes.</source>
        <translation>Gözlerin arasında burun kökünün en çukur yeri.</translation>
    </message>
    <message>
        <source>Foremost place of the forehead between the brows.</source>
        <translation>Kaşların arasında alnın en ön yeri.</translation>
    </message>
    <message>
        <source>Where the nose meets the upper lip, in the middle.</source>
        <translation>Burnun üst dudakla birleştiği yer, ortada.</translation>
    </message>
    <message>
        <source>Foremost point of the chin.</source>
        <translation>Çenenin en ön noktası.</translation>
    </message>
    <message>
        <source>Lowest point of the chin.</source>
        <translation>Çenenin en alt noktası.</translation>
    </message>
    <message>
        <source>Where the hair begins above the forehead.</source>
        <translation>Alnın üstünde saçın başladığı yer.</translation>
    </message>
    <message>
        <source>Highest point of the ear.</source>
        <translation>Kulağın en yüksek noktası.</translation>
    </message>
    <message>
        <source>Lowest point of the earlobe.</source>
        <translation>Kulak memesinin en alt noktası.</translation>
    </message>
    <message>
        <source>Hindmost point of the ear.</source>
        <translation>Kulağın en arka noktası.</translation>
    </message>
    <message>
        <source>Point of the ear farthest from the head.</source>
        <translation>Kulağın baştan en uzak noktası.</translation>
    </message>
    <message>
        <source>Drag a point to its place, or press Tab: the least sure point comes first.</source>
        <translation>Bir noktayı yerine sürükleyin veya Tab’a basın: en belirsiz nokta önce gelir.</translation>
    </message>
    <message>
        <source>%1 % sure</source>
        <translation>%%1 emin</translation>
    </message>
    <message>
        <source>placed by you</source>
        <translation>sizin yerleştirdiğiniz</translation>
    </message>
    <message>
        <source>outline point</source>
        <translation>kontur noktası</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>emin</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>kuşkulu</translation>
    </message>
    <message>
        <source>outline in the photo</source>
        <translation>fotoğraftaki kontur</translation>
    </message>
    <message>
        <source>outline of the clone</source>
        <translation>klonun konturu</translation>
    </message>
</context>
<context>
    <name>keepsakes</name>
    <message>
        <source>Card and e-mail</source>
        <translation>Kart ve e-posta</translation>
    </message>
    <message>
        <source>Pr&amp;int the card…</source>
        <translation>Kartı &amp;yazdır…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the card as a file…</source>
        <translation>Kartı &amp;dosyaya kaydet…</translation>
    </message>
    <message>
        <source>E-&amp;mail as a draft…</source>
        <translation>E-posta &amp;taslağı…</translation>
    </message>
    <message>
        <source>The card as it will be printed</source>
        <translation>Yazdırılacağı haliyle kart</translation>
    </message>
    <message>
        <source>Your files: {folder}</source>
        <translation>Dosyalarınız: {folder}</translation>
    </message>
    <message>
        <source>Scan to see yourself turn and to take your files home.</source>
        <translation>Kendinizi her yandan görmek ve dosyalarınızı almak için taratın.</translation>
    </message>
</context>
<context>
    <name>kiosk</name>
    <message>
        <source>Operator</source>
        <translation>Görevli</translation>
    </message>
    <message>
        <source>Number of the operator</source>
        <translation>Görevlinin numarası</translation>
    </message>
    <message>
        <source>Too many wrong numbers: wait half a minute.</source>
        <translation>Çok fazla yanlış numara: yarım dakika bekleyin.</translation>
    </message>
    <message>
        <source>This is not the number.</source>
        <translation>Numara bu değil.</translation>
    </message>
    <message>
        <source>Give the operator a number under Event, Settings first.</source>
        <translation>Önce Etkinlik, Ayarlar altında görevliye bir numara verin.</translation>
    </message>
</context>
<context>
    <name>licences</name>
    <message>
        <source>the visitor alone</source>
        <extracomment>Who may use a visitor&apos;s files, by licence; and what that means.</extracomment>
        <translation>yalnızca ziyaretçi</translation>
    </message>
    <message>
        <source>visitor and event</source>
        <translation>ziyaretçi ve etkinlik</translation>
    </message>
    <message>
        <source>everybody</source>
        <translation>herkes</translation>
    </message>
    <message>
        <source>Nobody else may use the files or earn money with them.</source>
        <translation>Başka hiç kimse dosyaları kullanamaz ve onlarla para kazanamaz.</translation>
    </message>
    <message>
        <source>The event may use the files too, also in its advertising.</source>
        <translation>Etkinlik de dosyaları kullanabilir, reklamlarında da.</translation>
    </message>
    <message>
        <source>Everybody may use the files, change them and pass them on, but not earn money with them.</source>
        <translation>Herkes dosyaları kullanabilir, değiştirebilir ve başkalarına verebilir, ama onlarla para kazanamaz.</translation>
    </message>
</context>
<context>
    <name>mail</name>
    <message>
        <source>Your clone</source>
        <translation>Klonunuz</translation>
    </message>
    <message>
        <source>Your clone from {event}</source>
        <translation>{event} etkinliğinden klonunuz</translation>
    </message>
    <message>
        <source>Hello,</source>
        <translation>Merhaba,</translation>
    </message>
    <message>
        <source>Hello {name},</source>
        <translation>Merhaba {name},</translation>
    </message>
    <message>
        <source>this is the clone that was made of your photos. Its picture is attached.</source>
        <translation>fotoğraflarınızdan yapılan klon burada. Resmi ektedir.</translation>
    </message>
    <message>
        <source>As long as you are on the booth&apos;s network you can see it turn and take the files here:</source>
        <translation>Standın ağında olduğunuz sürece onu her yandan görebilir ve dosyaları buradan alabilirsiniz:</translation>
    </message>
    <message>
        <source>If you want everything that is held of you deleted, answer this message or tell us.</source>
        <translation>Sizinle ilgili saklanan her şeyin silinmesini isterseniz bu iletiyi yanıtlayın ya da bize söyleyin.</translation>
    </message>
    <message>
        <source>Thank you for your visit.</source>
        <translation>Ziyaretiniz için teşekkürler.</translation>
    </message>
</context>
<context>
    <name>materials</name>
    <message>
        <source>Stone</source>
        <translation>Taş</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Kil</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronz</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Mermer</translation>
    </message>
    <message>
        <source>As photographed</source>
        <translation>Fotoğraftaki gibi</translation>
    </message>
    <message>
        <source>Arms hanging</source>
        <translation>Kollar aşağıda</translation>
    </message>
    <message>
        <source>On guard</source>
        <translation>Nöbette</translation>
    </message>
    <message>
        <source>Hailing</source>
        <translation>Selamlayan</translation>
    </message>
</context>
<context>
    <name>measures</name>
    <message>
        <source>Height without shoes</source>
        <extracomment>What the sliders tell, in the order of the form; the stature and the measures of `cloner.bodies.telling.PRESETS`.</extracomment>
        <translation>Ayakkabısız boy</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Göğüs</translation>
    </message>
    <message>
        <source>Waist</source>
        <translation>Bel</translation>
    </message>
    <message>
        <source>Hips</source>
        <translation>Kalça</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Boyun</translation>
    </message>
    <message>
        <source>Below the breast</source>
        <translation>Göğüs altı</translation>
    </message>
    <message>
        <source>Thigh</source>
        <translation>Uyluk</translation>
    </message>
    <message>
        <source>Inside leg</source>
        <translation>İç bacak</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Kol</translation>
    </message>
</context>
<context>
    <name>menu</name>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Aç…</translation>
    </message>
    <message>
        <source>&amp;New visitor</source>
        <translation>&amp;Yeni ziyaretçi</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>A&amp;yarlar…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Çık</translation>
    </message>
    <message>
        <source>&amp;Kiosk (Ctrl+Shift+K)</source>
        <translation>&amp;Kiosk (Ctrl+Shift+K)</translation>
    </message>
    <message>
        <source>&amp;Gallery…</source>
        <translation>&amp;Galeri…</translation>
    </message>
    <message>
        <source>&amp;Screen for visitors</source>
        <translation>&amp;Ziyaretçi ekranı</translation>
    </message>
    <message>
        <source>&amp;Effort…</source>
        <translation>&amp;Emek…</translation>
    </message>
    <message>
        <source>&amp;What is held…</source>
        <translation>&amp;Neler saklanıyor…</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Dil</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>&amp;Masaüstü gibi</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Açık</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Koyu</translation>
    </message>
    <message>
        <source>High &amp;contrast</source>
        <translation>&amp;Yüksek karşıtlık</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Renkler</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>&amp;Yazı boyutu</translation>
    </message>
    <message>
        <source>&amp;Big buttons</source>
        <translation>&amp;Büyük düğmeler</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Tam ekran</translation>
    </message>
    <message>
        <source>&amp;Dress a clone…</source>
        <translation>Bir klonu &amp;giydir…</translation>
    </message>
    <message>
        <source>&amp;Body from measures…</source>
        <translation>Ölçülerden &amp;beden…</translation>
    </message>
    <message>
        <source>&amp;Clone in stone…</source>
        <translation>Taştan &amp;klon…</translation>
    </message>
    <message>
        <source>&amp;Photograph on a statue…</source>
        <translation>Heykele &amp;fotoğraf…</translation>
    </message>
    <message>
        <source>Body of b&amp;lobs…</source>
        <translation>&amp;Bloblardan beden…</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>&amp;Etkinlik</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Düzen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Görünüm</translation>
    </message>
    <message>
        <source>O&amp;perator</source>
        <translation>&amp;Operatör</translation>
    </message>
    <message>
        <source>&amp;Studio</source>
        <translation>&amp;Stüdyo</translation>
    </message>
</context>
<context>
    <name>names</name>
    <message>
        <source>inner corner of the eye</source>
        <extracomment>Names without their sides.</extracomment>
        <translation>gözün iç köşesi</translation>
    </message>
    <message>
        <source>outer corner of the eye</source>
        <translation>gözün dış köşesi</translation>
    </message>
    <message>
        <source>upper lid</source>
        <translation>üst göz kapağı</translation>
    </message>
    <message>
        <source>lower lid</source>
        <translation>alt göz kapağı</translation>
    </message>
    <message>
        <source>corner of the mouth</source>
        <translation>ağız köşesi</translation>
    </message>
    <message>
        <source>wing of the nose</source>
        <translation>burun kanadı</translation>
    </message>
    <message>
        <source>pupil</source>
        <translation>gözbebeği</translation>
    </message>
    <message>
        <source>top of the ear</source>
        <translation>kulağın tepesi</translation>
    </message>
    <message>
        <source>earlobe</source>
        <translation>kulak memesi</translation>
    </message>
    <message>
        <source>outermost point of the ear</source>
        <translation>kulağın en dış noktası</translation>
    </message>
    <message>
        <source>back of the ear</source>
        <translation>kulağın arkası</translation>
    </message>
    <message>
        <source>root of the nose</source>
        <translation>burun kökü</translation>
    </message>
    <message>
        <source>forehead between the brows</source>
        <translation>kaşlar arası alın</translation>
    </message>
    <message>
        <source>tip of the nose</source>
        <translation>burun ucu</translation>
    </message>
    <message>
        <source>base of the nose</source>
        <translation>burun altı</translation>
    </message>
    <message>
        <source>upper lip</source>
        <translation>üst dudak</translation>
    </message>
    <message>
        <source>middle of the mouth</source>
        <translation>ağzın ortası</translation>
    </message>
    <message>
        <source>lower lip</source>
        <translation>alt dudak</translation>
    </message>
    <message>
        <source>front of the chin</source>
        <translation>çenenin önü</translation>
    </message>
    <message>
        <source>bottom of the chin</source>
        <translation>çenenin altı</translation>
    </message>
    <message>
        <source>hairline</source>
        <translation>saç çizgisi</translation>
    </message>
    <message>
        <source>top of the head</source>
        <translation>başın tepesi</translation>
    </message>
    <message>
        <source>toe</source>
        <translation>ayak ucu</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>bel</translation>
    </message>
    <message>
        <source>waist, front</source>
        <translation>bel, ön</translation>
    </message>
    <message>
        <source>waist, back</source>
        <translation>bel, arka</translation>
    </message>
    <message>
        <source>hip</source>
        <translation>kalça</translation>
    </message>
    <message>
        <source>hip joint</source>
        <translation>kalça eklemi</translation>
    </message>
    <message>
        <source>outside of the knee</source>
        <translation>dizin dışı</translation>
    </message>
    <message>
        <source>inside of the knee</source>
        <translation>dizin içi</translation>
    </message>
    <message>
        <source>front of the knee</source>
        <translation>dizin önü</translation>
    </message>
    <message>
        <source>back of the knee</source>
        <translation>dizin arkası</translation>
    </message>
    <message>
        <source>knee joint</source>
        <translation>diz eklemi</translation>
    </message>
    <message>
        <source>outside of the ankle</source>
        <translation>ayak bileğinin dışı</translation>
    </message>
    <message>
        <source>inside of the ankle</source>
        <translation>ayak bileğinin içi</translation>
    </message>
    <message>
        <source>front of the ankle</source>
        <translation>ayak bileğinin önü</translation>
    </message>
    <message>
        <source>back of the ankle</source>
        <translation>ayak bileğinin arkası</translation>
    </message>
    <message>
        <source>ankle joint</source>
        <translation>ayak bileği eklemi</translation>
    </message>
    <message>
        <source>outside of the elbow</source>
        <translation>dirseğin dışı</translation>
    </message>
    <message>
        <source>inside of the elbow</source>
        <translation>dirseğin içi</translation>
    </message>
    <message>
        <source>elbow joint</source>
        <translation>dirsek eklemi</translation>
    </message>
    <message>
        <source>outside of the wrist</source>
        <translation>el bileğinin dışı</translation>
    </message>
    <message>
        <source>inside of the wrist</source>
        <translation>el bileğinin içi</translation>
    </message>
    <message>
        <source>wrist joint</source>
        <translation>el bileği eklemi</translation>
    </message>
    <message>
        <source>end of the shoulder</source>
        <translation>omuz ucu</translation>
    </message>
    <message>
        <source>shoulder joint</source>
        <translation>omuz eklemi</translation>
    </message>
    <message>
        <source>bony tip of the shoulder</source>
        <translation>omuz çıkıntısı</translation>
    </message>
    <message>
        <source>base of the neck</source>
        <translation>boyun dibi</translation>
    </message>
    <message>
        <source>front of the neck</source>
        <translation>boynun önü</translation>
    </message>
    <message>
        <source>back of the neck</source>
        <translation>boynun arkası</translation>
    </message>
    <message>
        <source>pit of the neck</source>
        <translation>boyun çukuru</translation>
    </message>
    <message>
        <source>nape</source>
        <translation>ense</translation>
    </message>
    <message>
        <source>armpit</source>
        <translation>koltuk altı</translation>
    </message>
    <message>
        <source>sole</source>
        <translation>taban</translation>
    </message>
    <message>
        <source>heel</source>
        <translation>topuk</translation>
    </message>
    <message>
        <source>crotch</source>
        <translation>kasık</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>göğüs</translation>
    </message>
    <message>
        <source>chest, front</source>
        <translation>göğüs, ön</translation>
    </message>
    <message>
        <source>back</source>
        <translation>sırt</translation>
    </message>
    <message>
        <source>belly</source>
        <translation>karın</translation>
    </message>
    <message>
        <source>seat</source>
        <translation>kalça arkası</translation>
    </message>
    <message>
        <source>front of the thigh</source>
        <translation>uyluğun önü</translation>
    </message>
    <message>
        <source>back of the thigh</source>
        <translation>uyluğun arkası</translation>
    </message>
    <message>
        <source>outside of the thigh</source>
        <translation>uyluğun dışı</translation>
    </message>
    <message>
        <source>inside of the thigh</source>
        <translation>uyluğun içi</translation>
    </message>
    <message>
        <source>calf</source>
        <translation>baldır</translation>
    </message>
    <message>
        <source>fingertip</source>
        <translation>parmak ucu</translation>
    </message>
    <message>
        <source>top of the skull</source>
        <translation>kafatasının tepesi</translation>
    </message>
    <message>
        <source>outline point</source>
        <translation>dış çizgi noktası</translation>
    </message>
</context>
<context>
    <name>photos</name>
    <message>
        <source>Photos are still looked at.</source>
        <translation>Fotoğraflara hâlâ bakılıyor.</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotoğraflar</translation>
    </message>
    <message>
        <source>Add the photos first.</source>
        <extracomment>Points are sought when photos have rested so long, milliseconds: looking at new ones comes first.</extracomment>
        <translation>Önce fotoğrafları ekleyin.</translation>
    </message>
    <message>
        <source>&amp;Add photos…</source>
        <translation>Fotoğraf &amp;ekle…</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Yapıştır</translation>
    </message>
    <message>
        <source>Camera folder: {name}</source>
        <translation>Kamera klasörü: {name}</translation>
    </message>
    <message>
        <source>&amp;Camera folder…</source>
        <translation>&amp;Kamera klasörü…</translation>
    </message>
    <message>
        <source>&amp;Webcam…</source>
        <translation>&amp;Web kamerası…</translation>
    </message>
    <message>
        <source>Photos that appear in this folder are taken at once</source>
        <translation>Bu klasörde beliren fotoğraflar hemen alınır</translation>
    </message>
    <message>
        <source>Watch no camera folder any more</source>
        <translation>Artık kamera klasörünü izleme</translation>
    </message>
    <message>
        <source>Photos without a place</source>
        <translation>Yeri olmayan fotoğraflar</translation>
    </message>
    <message>
        <source>Being looked at…</source>
        <translation>İnceleniyor…</translation>
    </message>
    <message>
        <source>✓ Good</source>
        <translation>✓ İyi</translation>
    </message>
    <message>
        <source>No consent is recorded: new photos are not stored.</source>
        <translation>Kayıtlı onay yok: yeni fotoğraflar saklanmaz.</translation>
    </message>
    <message>
        <source>Looking at photos: {n} to go</source>
        <translation>Fotoğraflar inceleniyor: {n} kaldı</translation>
    </message>
    <message>
        <source>Photos of the visitor</source>
        <translation>Ziyaretçinin fotoğrafları</translation>
    </message>
    <message>
        <source>Folder where the camera drops its photos</source>
        <translation>Kameranın fotoğrafları bıraktığı klasör</translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation>Fotoğrafı buraya bırakın</translation>
    </message>
    <message>
        <source>What to do with {photo}</source>
        <translation>{photo} ile yapılacaklar</translation>
    </message>
    <message>
        <source>Return shows or chooses the photo, Space tells what else can be done.</source>
        <translation>Enter fotoğrafı gösterir ya da seçer, boşluk tuşu başka neler yapılabileceğini söyler.</translation>
    </message>
    <message>
        <source>See it large</source>
        <translation>Büyük göster</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Değiştir…</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Seç…</translation>
    </message>
    <message>
        <source>Exchange with</source>
        <translation>Şununla değiş tokuş et</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Sağa döndür</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Çıkar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Use as…</source>
        <translation>Şu olarak kullan…</translation>
    </message>
    <message>
        <source>Photo {n} without a place</source>
        <translation>Yeri olmayan fotoğraf {n}</translation>
    </message>
    <message>
        <source>All five photos are here.</source>
        <translation>Beş fotoğraf da burada.</translation>
    </message>
    <message>
        <source>No photos yet.</source>
        <translation>Henüz fotoğraf yok.</translation>
    </message>
    <message>
        <source>A front photo is needed. Missing: {names}.</source>
        <translation>Önden bir fotoğraf gerekli. Eksik: {names}.</translation>
    </message>
    <message>
        <source>Only the head can be cloned, on a body of matching build. Missing: {names}.</source>
        <translation>Yalnız baş klonlanabilir, uygun bir beden üzerinde. Eksik: {names}.</translation>
    </message>
    <message>
        <source>The face will come from the body photos and be coarse. Missing: {names}.</source>
        <translation>Yüz, beden fotoğraflarından gelecek ve kaba olacak. Eksik: {names}.</translation>
    </message>
    <message>
        <source>The clone will be less exact. Missing: {names}.</source>
        <translation>Klon daha az kesin olacak. Eksik: {names}.</translation>
    </message>
</context>
<context>
    <name>points</name>
    <message>
        <source>Points</source>
        <translation>Noktalar</translation>
    </message>
    <message>
        <source>Add photos first.</source>
        <extracomment>The clone&apos;s outline is drawn anew when the hand has rested so long: it costs as much as the preview.</extracomment>
        <translation>Önce fotoğraf ekleyin.</translation>
    </message>
    <message>
        <source>{n} doubtful points are left after this one.</source>
        <translation>Bundan sonra {n} kuşkulu nokta kaldı.</translation>
    </message>
    <message>
        <source>All doubtful points are seen: this one is sure. Press Clone.</source>
        <translation>Kuşkulu noktaların hepsi görüldü: bu nokta kesin. Klonla düğmesine basın.</translation>
    </message>
    <message>
        <source>Find points</source>
        <translation>Noktaları bul</translation>
    </message>
    <message>
        <source>◀</source>
        <translation>◀</translation>
    </message>
    <message>
        <source>Point before (Shift+Tab)</source>
        <translation>Önceki nokta (Shift+Tab)</translation>
    </message>
    <message>
        <source>Next doubtful point</source>
        <translation>Sonraki kuşkulu nokta</translation>
    </message>
    <message>
        <source>Least sure first (Tab)</source>
        <translation>Önce en belirsiz (Tab)</translation>
    </message>
    <message>
        <source>Back to proposal</source>
        <translation>Öneriye dön</translation>
    </message>
    <message>
        <source>Undo this point (Delete)</source>
        <translation>Bu noktayı geri al (Delete)</translation>
    </message>
    <message>
        <source>Add outline point</source>
        <translation>Kontur noktası ekle</translation>
    </message>
    <message>
        <source>Or pull at it (Insert)</source>
        <translation>Ya da onu çekin (Insert)</translation>
    </message>
    <message>
        <source>Whole photo</source>
        <translation>Tüm fotoğraf</translation>
    </message>
    <message>
        <source>Show all of the photo (Home)</source>
        <translation>Fotoğrafın tümünü göster (Home)</translation>
    </message>
    <message>
        <source>Tab: next point. Arrows: 1 pixel, with Shift 10. Wheel or + and −: zoom. Home: all.</source>
        <translation>Tab: sonraki nokta. Oklar: 1 piksel, Shift ile 10. Tekerlek veya + ve −: yakınlaştırma. Home: tümü.</translation>
    </message>
    <message>
        <source>After the first clone, the person here follows your hand.</source>
        <translation>İlk klondan sonra buradaki kişi elinizi izler.</translation>
    </message>
    <message>
        <source>The body follows; hair and textures will when you clone again.</source>
        <translation>Beden izliyor; saç ve dokular yeniden klonlayınca izler.</translation>
    </message>
    <message>
        <source>Clone again: this changes more than is shown.</source>
        <translation>Yeniden klonlayın: bu, gösterilenden fazlasını değiştirir.</translation>
    </message>
    <message>
        <source>moving %1</source>
        <translation>%1 taşıma</translation>
    </message>
    <message>
        <source>resetting %1</source>
        <translation>%1 sıfırlama</translation>
    </message>
</context>
<context>
    <name>preview</name>
    <message>
        <source>Photo texture</source>
        <translation>Fotoğraf dokusu</translation>
    </message>
    <message>
        <source>Shape alone</source>
        <translation>Yalnız biçim</translation>
    </message>
    <message>
        <source>Wire mesh</source>
        <translation>Tel kafes</translation>
    </message>
    <message>
        <source>Distance from the outlines</source>
        <translation>Konturlara uzaklık</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Dur</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Yürü</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Nefes al</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Göz kırp</translation>
    </message>
    <message>
        <source>Smile</source>
        <translation>Gülümse</translation>
    </message>
    <message>
        <source>Talk</source>
        <translation>Konuş</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>El salla</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Göster</translation>
    </message>
    <message>
        <source>&amp;Over</source>
        <translation>Ü&amp;zerinde</translation>
    </message>
    <message>
        <source>Co&amp;ver</source>
        <translation>&amp;Örtme</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Hareket</translation>
    </message>
    <message>
        <source>Whole pe&amp;rson</source>
        <translation>&amp;Bütün kişi</translation>
    </message>
    <message>
        <source>&amp;Face</source>
        <translation>&amp;Yüz</translation>
    </message>
    <message>
        <source>no photo</source>
        <translation>fotoğraf yok</translation>
    </message>
    <message>
        <source>between the clone&apos;s and the photos&apos; outlines</source>
        <translation>klonun ve fotoğrafların konturları arasında</translation>
    </message>
</context>
<context>
    <name>privacy</name>
    <message>
        <source>Delete {names} with all photos, points and clones?</source>
        <translation>{names} tüm fotoğraf, nokta ve klonlarıyla silinsin mi?</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Sil</translation>
    </message>
    <message>
        <source>Nothing of it can be brought back. Files on sticks stay.</source>
        <translation>Hiçbiri geri getirilemez. Belleklerdeki dosyalar kalır.</translation>
    </message>
    <message>
        <source>Delete for good</source>
        <translation>Kalıcı olarak sil</translation>
    </message>
    <message>
        <source>Save everything held of {name}</source>
        <translation>{name} hakkında saklanan her şeyi kaydet</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Neler saklanıyor</translation>
    </message>
    <message>
        <source>What is held, by visitor</source>
        <translation>Ziyaretçiye göre saklananlar</translation>
    </message>
    <message>
        <source>&amp;Save everything held…</source>
        <translation>Saklanan her şeyi &amp;kaydet…</translation>
    </message>
    <message>
        <source>&amp;Delete the marked visitors…</source>
        <translation>İşaretli ziyaretçileri &amp;sil…</translation>
    </message>
    <message>
        <source>{n} visitors, {size} MB; nothing leaves this computer</source>
        <translation>{n} ziyaretçi, {size} MB; hiçbir şey bu bilgisayardan çıkmaz</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Ziyaretçi</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dosyalar</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>Last change</source>
        <translation>Son değişiklik</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Onay</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>kayıtlı değil</translation>
    </message>
</context>
<context>
    <name>queue</name>
    <message>
        <source>Stop cloning {name}</source>
        <translation>{name} klonlamasını durdur</translation>
    </message>
    <message>
        <source>Progress of {name}</source>
        <translation>{name} ilerlemesi</translation>
    </message>
    <message>
        <source>, {n} more wait</source>
        <translation>, {n} kişi daha bekliyor</translation>
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
        <translation>Bu etkinlik</translation>
    </message>
    <message>
        <source>kept until deleted</source>
        <translation>silinene kadar saklanır</translation>
    </message>
    <message>
        <source> days</source>
        <translation> gün</translation>
    </message>
    <message>
        <source>Nothing &amp;moves by itself</source>
        <translation>Hiçbir şey kendiliğinden &amp;oynamasın</translation>
    </message>
    <message>
        <source>&amp;Encrypt the page for telephones</source>
        <translation>Telefon sayfasını &amp;şifrele</translation>
    </message>
    <message>
        <source>The kiosk &amp;asks for a number</source>
        <translation>Kiosk bir num&amp;ara sorar</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>hiç</translation>
    </message>
    <message>
        <source> hours</source>
        <translation> saat</translation>
    </message>
    <message>
        <source>Each takes a core of this computer and 1 GB of its memory.</source>
        <translation>Her biri bu bilgisayarın bir çekirdeğini ve 1 GB belleğini alır.</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>değişmedi</translation>
    </message>
    <message>
        <source>none; for example: museum</source>
        <translation>yok; örneğin: müze</translation>
    </message>
    <message>
        <source>{days} in the text stands for the days that visitors are kept.</source>
        <translation>Metindeki {days}, ziyaretçilerin saklandığı gün sayısıdır.</translation>
    </message>
    <message>
        <source>&amp;Name of the event</source>
        <translation>Etkinliğin &amp;adı</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Bring &amp;back thrown away ones for</source>
        <translation>Çöpten &amp;geri alma süresi</translation>
    </message>
    <message>
        <source>&amp;Language of the text</source>
        <translation>Metnin &amp;dili</translation>
    </message>
    <message>
        <source>Visitors may let &amp;use the files</source>
        <translation>Ziyaretçiler dosyaları &amp;kullandırabilir</translation>
    </message>
    <message>
        <source>Links for &amp;telephones work for</source>
        <translation>Telefon &amp;bağlantılarının süresi</translation>
    </message>
    <message>
        <source>&amp;Scene that clones may walk in</source>
        <translation>Klonların yürüyebileceği &amp;sahne</translation>
    </message>
    <message>
        <source>&amp;Visitors cloned at the same time</source>
        <translation>&amp;Aynı anda klonlanan ziyaretçiler</translation>
    </message>
    <message>
        <source>N&amp;umber of the operator</source>
        <translation>Görevlinin n&amp;umarası</translation>
    </message>
    <message>
        <source>Name of the event</source>
        <translation>Etkinliğin adı</translation>
    </message>
    <message>
        <source>Days that visitors are kept</source>
        <translation>Ziyaretçilerin saklandığı gün sayısı</translation>
    </message>
    <message>
        <source>Days that thrown away visitors can be brought back</source>
        <translation>Çöpe atılan ziyaretçilerin geri alınabileceği gün sayısı</translation>
    </message>
    <message>
        <source>Hours that links for telephones work</source>
        <translation>Telefon bağlantılarının geçerli olduğu saat</translation>
    </message>
    <message>
        <source>Scene that clones may walk in</source>
        <translation>Klonların yürüyebileceği sahne</translation>
    </message>
    <message>
        <source>Visitors cloned at the same time</source>
        <translation>Aynı anda klonlanan ziyaretçiler</translation>
    </message>
    <message>
        <source>Language of the text</source>
        <translation>Metnin dili</translation>
    </message>
    <message>
        <source>Who visitors may let use the files, at the most</source>
        <translation>Ziyaretçiler dosyaları en çok kime kullandırabilir</translation>
    </message>
    <message>
        <source>Number of the operator</source>
        <translation>Görevlinin numarası</translation>
    </message>
    <message>
        <source>What visitors agree to</source>
        <translation>Ziyaretçilerin kabul ettiği</translation>
    </message>
    <message>
        <source>&amp;Keep visitors for</source>
        <translation>Ziyaretçileri &amp;sakla</translation>
    </message>
    <message>
        <source>&amp;Consent</source>
        <translation>&amp;Onay</translation>
    </message>
    <message>
        <source>Choose a &amp;picture…</source>
        <translation>&amp;Resim seç…</translation>
    </message>
    <message>
        <source>No pictu&amp;re</source>
        <translation>Resim &amp;yok</translation>
    </message>
    <message>
        <source>Logo of the event</source>
        <translation>Etkinliğin logosu</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Resimler</translation>
    </message>
</context>
<context>
    <name>sides</name>
    <message>
        <source>%1, left</source>
        <translation>%1, sol</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, sağ</translation>
    </message>
</context>
<context>
    <name>stage</name>
    <message>
        <source>Everybody of today</source>
        <extracomment>A clone that does not move by itself is seen so long, milliseconds; and so often it is looked for a first one.</extracomment>
        <translation>Bugünün herkesi</translation>
    </message>
    <message>
        <source> and {n} more</source>
        <translation> ve {n} tane daha</translation>
    </message>
    <message>
        <source>Next: {names}</source>
        <translation>Sırada: {names}</translation>
    </message>
    <message>
        <source>Screen for visitors</source>
        <translation>Ziyaretçi ekranı</translation>
    </message>
    <message>
        <source>Five photos, one minute: your own clone stands here.</source>
        <translation>Beş fotoğraf, bir dakika: burada kendi klonunuz durur.</translation>
    </message>
</context>
<context>
    <name>states</name>
    <message>
        <source>in progress</source>
        <translation>sürüyor</translation>
    </message>
    <message>
        <source>waiting for the clone</source>
        <translation>klonu bekliyor</translation>
    </message>
    <message>
        <source>cloned</source>
        <translation>klonlandı</translation>
    </message>
    <message>
        <source>not cloned: look at the photos</source>
        <translation>klonlanmadı: fotoğraflara bakın</translation>
    </message>
</context>
<context>
    <name>statistics</name>
    <message>
        <source>Operator&apos;s effort</source>
        <translation>Operatörün emeği</translation>
    </message>
    <message>
        <source>Effort by visitor</source>
        <translation>Ziyaretçi başına emek</translation>
    </message>
    <message>
        <source>&amp;Save as table…</source>
        <translation>Tablo olarak &amp;kaydet…</translation>
    </message>
    <message>
        <source>{n} visitors; in the middle {s} s, {c} clicks, {d} drags each</source>
        <translation>{n} ziyaretçi; ortanca {s} sn, {c} tıklama, {d} sürükleme</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Farklı kaydet</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Ziyaretçi</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Geldi</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Durum</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Saniye</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Tıklama</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>Sürükleme</translation>
    </message>
    <message>
        <source>Clone, s</source>
        <translation>Klon, sn</translation>
    </message>
</context>
<context>
    <name>steps</name>
    <message>
        <source>Looking at the photo</source>
        <extracomment>What the progress bar says for a step&apos;s name.</extracomment>
        <translation>Fotoğraf inceleniyor</translation>
    </message>
    <message>
        <source>Reading the photos</source>
        <translation>Fotoğraflar okunuyor</translation>
    </message>
    <message>
        <source>Finding the person in the photos</source>
        <translation>Fotoğraflarda kişi aranıyor</translation>
    </message>
    <message>
        <source>Placing feature points</source>
        <translation>Noktalar yerleştiriliyor</translation>
    </message>
    <message>
        <source>Placing the cameras</source>
        <translation>Kameralar yerleştiriliyor</translation>
    </message>
    <message>
        <source>Drawing outlines</source>
        <translation>Konturlar çiziliyor</translation>
    </message>
    <message>
        <source>Choosing the nearest build and pose</source>
        <translation>En yakın yapı ve duruş seçiliyor</translation>
    </message>
    <message>
        <source>Fitting the skeleton</source>
        <translation>İskelet uyduruluyor</translation>
    </message>
    <message>
        <source>Fitting the body</source>
        <translation>Beden uyduruluyor</translation>
    </message>
    <message>
        <source>Fitting the outlines</source>
        <translation>Konturlar uyduruluyor</translation>
    </message>
    <message>
        <source>Fitting the head</source>
        <translation>Baş uyduruluyor</translation>
    </message>
    <message>
        <source>Joining head and body</source>
        <translation>Baş ve beden birleştiriliyor</translation>
    </message>
    <message>
        <source>Following corrected points</source>
        <translation>Düzeltilen noktalar izleniyor</translation>
    </message>
    <message>
        <source>Measuring the body</source>
        <translation>Beden ölçülüyor</translation>
    </message>
    <message>
        <source>Growing the hair</source>
        <translation>Saç uzatılıyor</translation>
    </message>
    <message>
        <source>Painting skin and clothes</source>
        <translation>Deri ve giysiler boyanıyor</translation>
    </message>
    <message>
        <source>Telling skin from clothes</source>
        <translation>Deri ve giysiler ayırt ediliyor</translation>
    </message>
    <message>
        <source>Writing the files</source>
        <translation>Dosyalar yazılıyor</translation>
    </message>
    <message>
        <source>Drawing previews</source>
        <translation>Önizlemeler çiziliyor</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Rapor yazılıyor</translation>
    </message>
    <message>
        <source>Copying</source>
        <translation>Kopyalanıyor</translation>
    </message>
    <message>
        <source>Making the body</source>
        <translation>Beden yapılıyor</translation>
    </message>
    <message>
        <source>Cutting the pieces</source>
        <translation>Parçalar kesiliyor</translation>
    </message>
    <message>
        <source>Sewing and hanging</source>
        <translation>Dikiliyor ve asılıyor</translation>
    </message>
    <message>
        <source>Walking in it</source>
        <translation>Onunla yürünüyor</translation>
    </message>
    <message>
        <source>Closing the loop</source>
        <translation>Döngü kapatılıyor</translation>
    </message>
    <message>
        <source>Reading back what was written</source>
        <translation>Yazılanlar yeniden okunuyor</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Bitti</translation>
    </message>
</context>
<context>
    <name>stick</name>
    <message>
        <source>Sticks are found by themselves on Linux only: choose the stick&apos;s folder.</source>
        <extracomment>Where Linux tells what is mounted; read again and again, it costs nothing. Only when it changes a program is asked.</extracomment>
        <translation>Bellekler yalnızca Linux’ta kendiliğinden bulunur: belleğin klasörünü seçin.</translation>
    </message>
    <message>
        <source>Which stick</source>
        <translation>Hangi bellek</translation>
    </message>
    <message>
        <source>This system does not tell which sticks are plugged in: choose the folder.</source>
        <translation>Bu sistem hangi belleklerin takılı olduğunu söylemiyor: klasörü seçin.</translation>
    </message>
    <message>
        <source>No stick is plugged in: it is found by itself.</source>
        <translation>Takılı bellek yok: takılınca kendiliğinden bulunur.</translation>
    </message>
    <message>
        <source>&amp;Copy to {stick}</source>
        <translation>{stick} belleğine &amp;kopyala</translation>
    </message>
    <message>
        <source>E&amp;ject {stick}</source>
        <translation>{stick} belleğini çı&amp;kar</translation>
    </message>
    <message>
        <source>{n} GB are free.</source>
        <translation>{n} GB boş.</translation>
    </message>
    <message>
        <source>It is write-protected.</source>
        <translation>Yazmaya karşı korumalı.</translation>
    </message>
    <message>
        <source>The stick is being let go…</source>
        <translation>Bellek çıkarılıyor…</translation>
    </message>
    <message>
        <source>{stick} can be pulled out.</source>
        <translation>{stick} çekilebilir.</translation>
    </message>
</context>
<context>
    <name>studio</name>
    <message>
        <source>Ca&amp;ncel</source>
        <extracomment>Width of the controls beside the picture, lines of text; taste.</extracomment>
        <translation>İ&amp;ptal</translation>
    </message>
    <message>
        <source>How far the work is</source>
        <translation>İşin durumu</translation>
    </message>
    <message>
        <source>Written: {place}</source>
        <translation>Yazıldı: {place}</translation>
    </message>
    <message>
        <source>&amp;Another clone…</source>
        <translation>&amp;Başka bir klon…</translation>
    </message>
    <message>
        <source>No clone is chosen.</source>
        <translation>Klon seçilmedi.</translation>
    </message>
    <message>
        <source>Folder of a clone</source>
        <translation>Bir klonun klasörü</translation>
    </message>
    <message>
        <source>Body of blobs</source>
        <extracomment>What of a blob&apos;s ends may be told here, cm; its file takes more.</extracomment>
        <translation>Bloblardan beden</translation>
    </message>
    <message>
        <source>Show the &amp;blobs</source>
        <translation>&amp;Blobları göster</translation>
    </message>
    <message>
        <source>&amp;Open a file of blobs…</source>
        <translation>Blob dosyası &amp;aç…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the blobs as a file…</source>
        <translation>Blobları dosyaya ka&amp;ydet…</translation>
    </message>
    <message>
        <source>Bl&amp;obs</source>
        <translation>B&amp;loblar</translation>
    </message>
    <message>
        <source> cm</source>
        <extracomment>Steps of the slider a centimetre.</extracomment>
        <translation> cm</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>&amp;Malzeme</translation>
    </message>
    <message>
        <source>File of blobs</source>
        <translation>Blob dosyası</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Yarıçap</translation>
    </message>
    <message>
        <source>Radius at the other end</source>
        <translation>Öbür uçta yarıçap</translation>
    </message>
    <message>
        <source>To the left</source>
        <translation>Sola</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Yukarı</translation>
    </message>
    <message>
        <source>Forwards</source>
        <translation>Öne</translation>
    </message>
    <message>
        <source>Times as wide</source>
        <translation>Genişlik katı</translation>
    </message>
    <message>
        <source>Times as high</source>
        <translation>Yükseklik katı</translation>
    </message>
    <message>
        <source>Times as deep</source>
        <translation>Derinlik katı</translation>
    </message>
    <message>
        <source>Body from measures</source>
        <extracomment>Sliders go so many spreads to either side of what is usual; a body may have 4.5 (`FAR`). Side of a saved body&apos;s texture, texels; as `cloner body` has it.</extracomment>
        <translation>Ölçülerden beden</translation>
    </message>
    <message>
        <source>A woman or a girl</source>
        <translation>Bir kadın ya da kız</translation>
    </message>
    <message>
        <source>A man or a boy</source>
        <translation>Bir erkek ya da oğlan</translation>
    </message>
    <message>
        <source>A clone, told new measures</source>
        <translation>Yeni ölçülerle bir klon</translation>
    </message>
    <message>
        <source> years</source>
        <translation> yaş</translation>
    </message>
    <message>
        <source>Four, as a shop asks</source>
        <translation>Dört, mağazadaki gibi</translation>
    </message>
    <message>
        <source>Nine, as a tailor takes</source>
        <translation>Dokuz, terzideki gibi</translation>
    </message>
    <message>
        <source>&amp;Save the body…</source>
        <translation>Bedeni &amp;kaydet…</translation>
    </message>
    <message>
        <source>&amp;Who</source>
        <translation>&amp;Kim</translation>
    </message>
    <message>
        <source>&amp;Age</source>
        <translation>Y&amp;aş</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>&amp;Ölçüler</translation>
    </message>
    <message>
        <source>&amp;Name of the body</source>
        <translation>Bedenin &amp;adı</translation>
    </message>
    <message>
        <source>body</source>
        <translation>beden</translation>
    </message>
    <message>
        <source>Folder for bodies</source>
        <translation>Bedenler için klasör</translation>
    </message>
    <message>
        <source>Take this marker away</source>
        <extracomment>What a vertex is called that has no name of its own: this and its number.</extracomment>
        <translation>Bu işareti kaldır</translation>
    </message>
    <message>
        <source>Photograph on a statue</source>
        <translation>Heykele fotoğraf</translation>
    </message>
    <message>
        <source>Choose a &amp;photograph…</source>
        <translation>Bir &amp;fotoğraf seç…</translation>
    </message>
    <message>
        <source>Paint it all &amp;round</source>
        <translation>Her yanı &amp;boya</translation>
    </message>
    <message>
        <source>Choose a photograph of a face, of flesh or of stone.</source>
        <translation>Etten ya da taştan bir yüzün fotoğrafını seçin.</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Fotoğraf</translation>
    </message>
    <message>
        <source>No face was found: drag the markers to their places.</source>
        <translation>Yüz bulunamadı: işaretleri yerlerine sürükleyin.</translation>
    </message>
    <message>
        <source>Drag the markers. A double click on the clone adds one, Delete takes one away.</source>
        <translation>İşaretleri sürükleyin. Klona çift tıklama bir tane ekler, Sil bir tane kaldırır.</translation>
    </message>
    <message>
        <source>The usual man</source>
        <extracomment>Side of the texture of a statue that is nobody&apos;s clone, texels; as `cloner statue` has it.</extracomment>
        <translation>Sıradan adam</translation>
    </message>
    <message>
        <source>Its own colours</source>
        <translation>Kendi renkleri</translation>
    </message>
    <message>
        <source>A clone</source>
        <translation>Bir klon</translation>
    </message>
    <message>
        <source>&amp;Save the statue…</source>
        <translation>Heykeli &amp;kaydet…</translation>
    </message>
    <message>
        <source>statue</source>
        <translation>heykel</translation>
    </message>
    <message>
        <source>La&amp;id on</source>
        <translation>Üzerine &amp;konan</translation>
    </message>
    <message>
        <source>&amp;Name of the statue</source>
        <translation>Heykelin &amp;adı</translation>
    </message>
    <message>
        <source>Folder for statues</source>
        <translation>Heykeller için klasör</translation>
    </message>
    <message>
        <source>Clone in stone</source>
        <translation>Taştan klon</translation>
    </message>
    <message>
        <source>Choose a clone that is finished.</source>
        <translation>Bitmiş bir klon seçin.</translation>
    </message>
    <message>
        <source>&amp;Pose</source>
        <translation>&amp;Duruş</translation>
    </message>
    <message>
        <source>Dress a clone</source>
        <extracomment>Lengths that may be asked for, cm; the first stands for the usual one.</extracomment>
        <translation>Bir klonu giydir</translation>
    </message>
    <message>
        <source>A file of my own…</source>
        <translation>Kendi dosyam…</translation>
    </message>
    <message>
        <source>Own walk</source>
        <translation>Kendi yürüyüşü</translation>
    </message>
    <message>
        <source>A captured walk…</source>
        <translation>Kaydedilmiş yürüyüş…</translation>
    </message>
    <message>
        <source>as usual</source>
        <translation>her zamanki gibi</translation>
    </message>
    <message>
        <source>&amp;Instead of the photographed clothes</source>
        <translation>Fotoğraftaki giysiler &amp;yerine</translation>
    </message>
    <message>
        <source>Otherwise it is worn over the clothes of the photos.</source>
        <translation>Yoksa fotoğraftaki giysilerin üstüne giyilir.</translation>
    </message>
    <message>
        <source>Who wears it</source>
        <translation>Kim giyiyor</translation>
    </message>
    <message>
        <source>&amp;Garment</source>
        <translation>&amp;Giysi</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Uzunluk</translation>
    </message>
    <message>
        <source>&amp;Fabric</source>
        <translation>&amp;Kumaş</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Hareket</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Parçalar</translation>
    </message>
    <message>
        <source>Something &amp;over it</source>
        <translation>Ü&amp;stüne bir şey</translation>
    </message>
    <message>
        <source>Photographed clothes</source>
        <translation>Fotoğraftaki giysiler</translation>
    </message>
    <message>
        <source>Take the photographed clothes of {name} off?</source>
        <translation>{name} için fotoğraftaki giysiler çıkarılsın mı?</translation>
    </message>
    <message>
        <source>The garment is then worn over neutral underwear. Ask the visitor first.</source>
        <translation>Giysi o zaman sade iç çamaşırı üstüne giyilir. Önce ziyaretçiye sorun.</translation>
    </message>
    <message>
        <source>Take them off</source>
        <translation>Çıkar</translation>
    </message>
    <message>
        <source>File of a garment</source>
        <translation>Giysi dosyası</translation>
    </message>
    <message>
        <source>Captured walk</source>
        <translation>Kaydedilmiş yürüyüş</translation>
    </message>
    <message>
        <source>Save the dressed clone</source>
        <translation>Giydirilmiş klonu kaydet</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Yerleştir</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Dik</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Kumaş</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Canlandır</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Dışa aktar</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>Ye&amp;rleştir</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>&amp;Dik</translation>
    </message>
    <message>
        <source>Let it wal&amp;k</source>
        <translation>Yür&amp;üt</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>Farklı &amp;kaydet…</translation>
    </message>
</context>
<context>
    <name>takeaway</name>
    <message>
        <source>Writing the files…</source>
        <translation>Dosyalar yazılıyor…</translation>
    </message>
    <message>
        <source>Written and read back: {place}</source>
        <translation>Yazıldı ve yeniden okundu: {place}</translation>
    </message>
    <message>
        <source>Stopped: nothing of it was left there.</source>
        <translation>Durduruldu: orada hiçbir şey kalmadı.</translation>
    </message>
    <message>
        <source>Written: {place}</source>
        <translation>Yazıldı: {place}</translation>
    </message>
    <message>
        <source>Choose what the visitor takes home.</source>
        <translation>Ziyaretçinin ne götüreceğini seçin.</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Götür</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dosyalar</translation>
    </message>
    <message>
        <source>Code to scan</source>
        <translation>Taranacak kod</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Neler saklanıyor</translation>
    </message>
    <message>
        <source>Save as one &amp;zip file…</source>
        <translation>Tek &amp;zip dosyası olarak kaydet…</translation>
    </message>
    <message>
        <source>Show &amp;report</source>
        <translation>&amp;Raporu göster</translation>
    </message>
    <message>
        <source>Copy to a f&amp;older…</source>
        <translation>Bir k&amp;lasöre kopyala…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Durdur</translation>
    </message>
    <message>
        <source>Show &amp;folder</source>
        <translation>&amp;Klasörü göster</translation>
    </message>
    <message>
        <source>&amp;Page for telephones on this network</source>
        <translation>Bu ağda &amp;telefon sayfası</translation>
    </message>
    <message>
        <source>Page for telephones on this network</source>
        <translation>Bu ağda telefon sayfası</translation>
    </message>
    <message>
        <source>Save &amp;everything held…</source>
        <translation>Saklanan &amp;her şeyi kaydet…</translation>
    </message>
    <message>
        <source>&amp;Delete this visitor…</source>
        <translation>Bu ziyaretçiyi &amp;sil…</translation>
    </message>
    <message>
        <source>Text or address in the code; {id} stands for the visitor</source>
        <translation>Koddaki metin veya adres; {id} ziyaretçinin yerine geçer</translation>
    </message>
    <message>
        <source>Text of the code</source>
        <translation>Kodun metni</translation>
    </message>
    <message>
        <source>How far the files are</source>
        <translation>Dosyaların ilerleyişi</translation>
    </message>
    <message>
        <source>There is no clone yet.</source>
        <translation>Henüz klon yok.</translation>
    </message>
    <message>
        <source>No consent is recorded.</source>
        <translation>Kayıtlı onay yok.</translation>
    </message>
    <message>
        <source>Consent: {when}.</source>
        <translation>Onay: {when}.</translation>
    </message>
    <message>
        <source>Kept for {n} days.</source>
        <translation>{n} gün saklanır.</translation>
    </message>
    <message>
        <source>Kept.</source>
        <translation>Saklanır.</translation>
    </message>
    <message>
        <source>Switch the page for telephones on, or type the address of a page of your own.</source>
        <translation>Telefon sayfasını açın ya da kendi sayfanızın adresini yazın.</translation>
    </message>
    <message>
        <source>In the scene “{scene}”, within seconds.</source>
        <translation>“{scene}” sahnesinde, saniyeler içinde.</translation>
    </message>
    <message>
        <source>Off: nothing leaves this computer.</source>
        <translation>Kapalı: bu bilgisayardan hiçbir şey çıkmaz.</translation>
    </message>
    <message>
        <source>The page is being made…</source>
        <translation>Sayfa hazırlanıyor…</translation>
    </message>
    <message>
        <source>Telephones warn of the booth&apos;s own certificate once.</source>
        <translation>Telefonlar standın kendi sertifikası için bir kez uyarır.</translation>
    </message>
    <message>
        <source>Not encrypted: use a hotspot of your own with a password.</source>
        <translation>Şifresiz: parolalı, kendinize ait bir erişim noktası kullanın.</translation>
    </message>
    <message>
        <source>Each visitor&apos;s link works for {n} hours.</source>
        <translation>Her ziyaretçinin bağlantısı {n} saat geçerlidir.</translation>
    </message>
    <message>
        <source>Stick or folder for the visitor&apos;s files</source>
        <translation>Ziyaretçinin dosyaları için bellek veya klasör</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Farklı kaydet</translation>
    </message>
</context>
<context>
    <name>time</name>
    <message>
        <source>a few seconds</source>
        <translation>birkaç saniye</translation>
    </message>
    <message>
        <source>about {n} s</source>
        <translation>yaklaşık {n} sn</translation>
    </message>
    <message>
        <source>about {n} min</source>
        <translation>yaklaşık {n} dk</translation>
    </message>
</context>
<context>
    <name>told</name>
    <message>
        <source>there is no camera</source>
        <translation>kamera bulunamadı</translation>
    </message>
    <message>
        <source>Plug it in and allow its use, then try again</source>
        <translation>Takın, kullanımına izin verin ve yeniden deneyin</translation>
    </message>
    <message>
        <source>the camera gives no pictures any more</source>
        <translation>kamera artık görüntü vermiyor</translation>
    </message>
    <message>
        <source>Plug it in again</source>
        <translation>Yeniden takın</translation>
    </message>
    <message>
        <source>it must be an object with &quot;format&quot;: %1</source>
        <translation>&quot;format&quot;: %1 içeren bir nesne olmalı</translation>
    </message>
    <message>
        <source>a setting is out of its range</source>
        <translation>bir ayar sınırlarının dışında</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>böyle bir klasör yok</translation>
    </message>
    <message>
        <source>Choose another, or make it first</source>
        <translation>Başka birini seçin veya önce oluşturun</translation>
    </message>
    <message>
        <source>this folder holds other things than visitors</source>
        <translation>bu klasörde ziyaretçilerden başka şeyler var</translation>
    </message>
    <message>
        <source>Choose an empty folder, an event&apos;s, or one with photos named body_front.jpg and so on</source>
        <translation>Boş bir klasör, bir etkinlik klasörü ya da body_front.jpg gibi adlı fotoğraflar olan bir klasör seçin</translation>
    </message>
    <message>
        <source>the event&apos;s settings cannot be read</source>
        <translation>etkinliğin ayarları okunamıyor</translation>
    </message>
    <message>
        <source>Correct %1, or move it away to start with the usual settings</source>
        <translation>%1 dosyasını düzeltin ya da olağan ayarlarla başlamak için başka yere taşıyın</translation>
    </message>
    <message>
        <source>the key %1 is not known</source>
        <translation>%1 anahtarı bilinmiyor</translation>
    </message>
    <message>
        <source>The keys are %1</source>
        <translation>Anahtarlar: %1</translation>
    </message>
    <message>
        <source>the licence %1 is not known</source>
        <translation>%1 lisansı bilinmiyor</translation>
    </message>
    <message>
        <source>The licences are %1</source>
        <translation>Lisanslar: %1</translation>
    </message>
    <message>
        <source>%1 has a value of the wrong kind</source>
        <translation>%1 yanlış türde bir değer taşıyor</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>klasör okunamıyor</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Erişim izinlerini denetleyin</translation>
    </message>
    <message>
        <source>the visitor&apos;s folder cannot be made</source>
        <translation>ziyaretçinin klasörü oluşturulamıyor</translation>
    </message>
    <message>
        <source>Check permissions and space</source>
        <translation>İzinleri ve boş alanı denetleyin</translation>
    </message>
    <message>
        <source>this is there already</source>
        <translation>bu zaten var</translation>
    </message>
    <message>
        <source>Choose another name or place</source>
        <translation>Başka bir ad veya yer seçin</translation>
    </message>
    <message>
        <source>it cannot be written there</source>
        <translation>oraya yazılamıyor</translation>
    </message>
    <message>
        <source>Is the stick full or write-protected?</source>
        <translation>Bellek dolu ya da yazmaya karşı korumalı mı?</translation>
    </message>
    <message>
        <source>there is no photo yet</source>
        <translation>henüz fotoğraf yok</translation>
    </message>
    <message>
        <source>Take the photos first</source>
        <translation>Önce fotoğrafları çekin</translation>
    </message>
    <message>
        <source>no photo is stored before the visitor agreed</source>
        <translation>ziyaretçi onay vermeden fotoğraf saklanmaz</translation>
    </message>
    <message>
        <source>Ask the visitor and tick the consent on the first page</source>
        <translation>Ziyaretçiye sorun ve ilk sayfadaki onayı işaretleyin</translation>
    </message>
    <message>
        <source>this is no photo</source>
        <translation>bu bir fotoğraf değil</translation>
    </message>
    <message>
        <source>Use one of %1</source>
        <translation>Şunlardan birini kullanın: %1</translation>
    </message>
    <message>
        <source>the photo cannot be stored</source>
        <translation>fotoğraf saklanamıyor</translation>
    </message>
    <message>
        <source>Check the folder&apos;s permissions and space</source>
        <translation>Klasörün izinlerini ve boş alanını denetleyin</translation>
    </message>
    <message>
        <source>the photo cannot be moved</source>
        <translation>fotoğraf taşınamıyor</translation>
    </message>
    <message>
        <source>the photo cannot be deleted</source>
        <translation>fotoğraf silinemiyor</translation>
    </message>
    <message>
        <source>the photo cannot be turned</source>
        <translation>fotoğraf döndürülemiyor</translation>
    </message>
    <message>
        <source>Turn it with another program</source>
        <translation>Başka bir programla döndürün</translation>
    </message>
    <message>
        <source>the text is too long for a code</source>
        <translation>metin bir kod için çok uzun</translation>
    </message>
    <message>
        <source>%1 characters can be scanned</source>
        <translation>%1 karakter okunabilir</translation>
    </message>
    <message>
        <source>something went wrong that the program did not expect (%1)</source>
        <translation>programın beklemediği bir hata oluştu (%1)</translation>
    </message>
    <message>
        <source>something went wrong that the program did not expect</source>
        <translation>programın beklemediği bir hata oluştu</translation>
    </message>
    <message>
        <source>Try again; if it happens again, send the log file</source>
        <translation>Yeniden deneyin; tekrar olursa günlük dosyasını gönderin</translation>
    </message>
    <message>
        <source>Go on; if it happens again, send the log file</source>
        <translation>Devam edin; tekrar olursa günlük dosyasını gönderin</translation>
    </message>
    <message>
        <source>Start it from a terminal with -v and send what it prints</source>
        <translation>Programı uçbirimden -v ile başlatın ve yazdıklarını gönderin</translation>
    </message>
    <message>
        <source>the worker&apos;s process ended</source>
        <translation>çalışan süreç sona erdi</translation>
    </message>
    <message>
        <source>a texture of %1 texels cannot be made</source>
        <translation>%1 tekselli bir doku yapılamaz</translation>
    </message>
    <message>
        <source>The sizes are %1</source>
        <translation>Boyutlar: %1</translation>
    </message>
    <message>
        <source>the format %1 is not known</source>
        <translation>%1 biçimi bilinmiyor</translation>
    </message>
    <message>
        <source>The formats are %1</source>
        <translation>Biçimler: %1</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>Dosya yazılamıyor: %1</translation>
    </message>
    <message>
        <source>Choose another folder or free some space</source>
        <translation>Başka bir klasör seçin veya yer açın</translation>
    </message>
    <message>
        <source>there is not enough memory: a limit allows %1 GB, a clone needs %2</source>
        <translation>Bellek yetmiyor: bir sınır %1 GB’a izin veriyor, bir klon için %2 gerekiyor</translation>
    </message>
    <message>
        <source>Raise it: ulimit -v %1</source>
        <translation>Sınırı yükseltin: ulimit -v %1</translation>
    </message>
    <message>
        <source>USD needs a library that is not here</source>
        <translation>USD burada olmayan bir kitaplık gerektirir</translation>
    </message>
    <message>
        <source>Install it with: %1</source>
        <translation>Şununla kurun: %1</translation>
    </message>
    <message>
        <source>This machine cannot draw: EGL gives no context</source>
        <translation>Bu bilgisayar çizemiyor: EGL bağlam vermiyor</translation>
    </message>
    <message>
        <source>nothing is held under this name</source>
        <translation>bu adla saklanan bir şey yok</translation>
    </message>
    <message>
        <source>cloner list shows the names</source>
        <translation>adları cloner list gösterir</translation>
    </message>
    <message>
        <source>somebody is cloning this visitor just now</source>
        <translation>bu ziyaretçi şu anda klonlanıyor</translation>
    </message>
    <message>
        <source>Wait or stop that, and repeat</source>
        <translation>Bekleyin ya da durdurun, sonra yineleyin</translation>
    </message>
    <message>
        <source>there is nowhere to look</source>
        <translation>aranacak bir yer yok</translation>
    </message>
    <message>
        <source>Give --photos, --out or both</source>
        <translation>--photos, --out ya da ikisini verin</translation>
    </message>
    <message>
        <source>Give --photos and --out as you gave them to batch</source>
        <translation>--photos ve --out değerlerini batch’e verdiğiniz gibi verin</translation>
    </message>
    <message>
        <source>the file exists</source>
        <translation>dosya zaten var</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Başka bir ad seçin</translation>
    </message>
    <message>
        <source>the zip file cannot be written</source>
        <translation>zip dosyası yazılamıyor</translation>
    </message>
    <message>
        <source>Check the folder and its space</source>
        <translation>Klasörü ve boş alanını denetleyin</translation>
    </message>
    <message>
        <source>not everything could be deleted</source>
        <translation>her şey silinemedi</translation>
    </message>
    <message>
        <source>Check permissions and repeat</source>
        <translation>İzinleri denetleyin ve yineleyin</translation>
    </message>
    <message>
        <source>the results cannot be written there</source>
        <translation>sonuçlar oraya yazılamıyor</translation>
    </message>
    <message>
        <source>Choose another --out folder, or check its permissions and free space</source>
        <translation>Başka bir klasör seçin ya da izinlerini ve boş alanını denetleyin</translation>
    </message>
    <message>
        <source>something that is no earlier result is in the way and will not be replaced</source>
        <translation>daha önceki bir sonuç olmayan bir şey yolda duruyor ve değiştirilmeyecek</translation>
    </message>
    <message>
        <source>Choose another --out folder or --id</source>
        <translation>Başka bir klasör veya ad seçin</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>dosya yazılamıyor</translation>
    </message>
    <message>
        <source>The clone was written by a newer version</source>
        <translation>Klon daha yeni bir sürümle yazılmış</translation>
    </message>
    <message>
        <source>Clone the person again with this version of Cloner</source>
        <translation>Kişiyi bu sürümle yeniden klonlayın</translation>
    </message>
    <message>
        <source>The clone is not there</source>
        <translation>Klon yerinde değil</translation>
    </message>
    <message>
        <source>Run: cloner clone</source>
        <translation>Çalıştırın: cloner clone</translation>
    </message>
    <message>
        <source>The file is not a readable clone</source>
        <translation>Dosya okunabilir bir klon değil</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 bir nesne olmalı</translation>
    </message>
    <message>
        <source>Correct the entry, or move the file away to use the proposals alone</source>
        <translation>Girdiyi düzeltin ya da yalnız önerileri kullanmak için dosyayı taşıyın</translation>
    </message>
    <message>
        <source>a point needs numbers &quot;x&quot; and &quot;y&quot; in photo pixels</source>
        <translation>bir nokta fotoğraf pikseli olarak &quot;x&quot; ve &quot;y&quot; sayılarını gerektirir</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>bu geçerli JSON değil</translation>
    </message>
    <message>
        <source>%1 is not a view; the views are %2</source>
        <translation>%1 bir görünüş değil; görünüşler: %2</translation>
    </message>
    <message>
        <source>there is no feature point of this name in this view</source>
        <translation>bu görünüşte bu adda bir nokta yok</translation>
    </message>
    <message>
        <source>the point lies outside the photo of %1</source>
        <translation>nokta %1 boyutlu fotoğrafın dışında</translation>
    </message>
    <message>
        <source>%1 with a usable name is here, and one front photo is needed</source>
        <translation>burada kullanılabilir adla %1 var, bir de önden fotoğraf gerekli</translation>
    </message>
    <message>
        <source>Give the folder inside it that holds the photos (%1), or use cloner batch for all</source>
        <translation>İçindeki fotoğraf klasörünü verin (%1) ya da tümü için cloner batch kullanın</translation>
    </message>
    <message>
        <source>Name the photos %1 (png, webp, tiff and heic work too)</source>
        <translation>Fotoğrafları şöyle adlandırın: %1 (png, webp, tiff ve heic de olur)</translation>
    </message>
    <message>
        <source>there is no such folder of photos</source>
        <translation>böyle bir fotoğraf klasörü yok</translation>
    </message>
    <message>
        <source>Give the folder that holds the photos</source>
        <translation>Fotoğrafların bulunduğu klasörü verin</translation>
    </message>
    <message>
        <source>%1 must be text in quotes</source>
        <translation>%1 tırnak içinde metin olmalı</translation>
    </message>
    <message>
        <source>Put it in quotes</source>
        <translation>Tırnak içine alın</translation>
    </message>
    <message>
        <source>Write sex = &quot;f&quot; or sex = &quot;m&quot;, or leave it out</source>
        <translation>sex = &quot;f&quot; veya sex = &quot;m&quot; yazın ya da boş bırakın</translation>
    </message>
    <message>
        <source>age must be years</source>
        <translation>age yıl olmalıdır</translation>
    </message>
    <message>
        <source>Write a line like: age = 71</source>
        <translation>Şöyle bir satır yazın: age = 71</translation>
    </message>
    <message>
        <source>measures must be a table of centimetres</source>
        <translation>measures santimetre tablosu olmalı</translation>
    </message>
    <message>
        <source>Write a line [measures], and below it lines like: waist_girth = 70.2</source>
        <translation>[measures] satırı ve altına waist_girth = 70.2 gibi satırlar yazın</translation>
    </message>
    <message>
        <source>the height must be a number of centimetres</source>
        <translation>boy santimetre cinsinden bir sayı olmalı</translation>
    </message>
    <message>
        <source>Write height_cm = 172</source>
        <translation>height_cm = 172 yazın</translation>
    </message>
    <message>
        <source>a height of %1 cm is outside %2 to %3 cm</source>
        <translation>%1 cm boy %2–%3 cm aralığının dışında</translation>
    </message>
    <message>
        <source>Give the barefoot height in centimetres</source>
        <translation>Ayakkabısız boyu santimetre olarak verin</translation>
    </message>
    <message>
        <source>there are two photos for %1: %2 and %3</source>
        <translation>%1 için iki fotoğraf var: %2 ve %3</translation>
    </message>
    <message>
        <source>Keep one of them</source>
        <translation>Birini bırakın</translation>
    </message>
    <message>
        <source>this is not valid TOML (%1)</source>
        <translation>bu geçerli TOML değil (%1)</translation>
    </message>
    <message>
        <source>Write lines like: height_cm = 172</source>
        <translation>height_cm = 172 gibi satırlar yazın</translation>
    </message>
    <message>
        <source>this is a link that leads out of its folder</source>
        <translation>bu, klasörünün dışına çıkan bir bağlantı</translation>
    </message>
    <message>
        <source>Put the file itself there</source>
        <translation>Dosyanın kendisini oraya koyun</translation>
    </message>
    <message>
        <source>&quot;format&quot; must be a whole number</source>
        <translation>&quot;format&quot; bir tam sayı olmalı</translation>
    </message>
    <message>
        <source>Write format = %1, as this version does</source>
        <translation>Bu sürüm gibi format = %1 yazın</translation>
    </message>
    <message>
        <source>it was written by a newer version of Cloner (format %1, this one knows %2)</source>
        <translation>Cloner’ın daha yeni bir sürümüyle yazılmış (biçim %1, bu sürüm %2 biliyor)</translation>
    </message>
    <message>
        <source>Update Cloner, or move the file away</source>
        <translation>Cloner’ı güncelleyin ya da dosyayı taşıyın</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>bu sıradan bir dosya değil</translation>
    </message>
    <message>
        <source>Check it or move it away</source>
        <translation>Denetleyin ya da başka yere taşıyın</translation>
    </message>
    <message>
        <source>the file is larger than %1 MB</source>
        <translation>dosya %1 MB’den büyük</translation>
    </message>
    <message>
        <source>the file cannot be read as text</source>
        <translation>dosya metin olarak okunamıyor</translation>
    </message>
    <message>
        <source>the work folder cannot be written</source>
        <translation>çalışma klasörüne yazılamıyor</translation>
    </message>
    <message>
        <source>The picture is too large to draw</source>
        <translation>Resim çizilemeyecek kadar büyük</translation>
    </message>
    <message>
        <source>Keep it under %1 pixels</source>
        <translation>%1 pikselin altında tutun</translation>
    </message>
    <message>
        <source>this photo shows only the upper part of the person, not the whole body</source>
        <translation>bu fotoğraf yalnız üst bedeni gösteriyor, tüm bedeni değil</translation>
    </message>
    <message>
        <source>the feet are outside this photo</source>
        <translation>ayaklar fotoğrafın dışında</translation>
    </message>
    <message>
        <source>this photo shows the person from the front or back, not from the side</source>
        <translation>bu fotoğraf kişiyi önden veya arkadan gösteriyor, yandan değil</translation>
    </message>
    <message>
        <source>this photo shows the person from the side, not the %1</source>
        <translation>bu fotoğraf kişiyi yandan gösteriyor, %1 değil</translation>
    </message>
    <message>
        <source>front</source>
        <translation>önden</translation>
    </message>
    <message>
        <source>back</source>
        <translation>arkadan</translation>
    </message>
    <message>
        <source>this photo shows the person&apos;s back, not the front</source>
        <translation>bu fotoğraf kişiyi arkadan gösteriyor, önden değil</translation>
    </message>
    <message>
        <source>this photo shows the person&apos;s front, not the back</source>
        <translation>bu fotoğraf kişiyi önden gösteriyor, arkadan değil</translation>
    </message>
    <message>
        <source>this photo shows the whole body, not the face from near</source>
        <translation>bu fotoğraf tüm bedeni gösteriyor, yüzü yakından değil</translation>
    </message>
    <message>
        <source>this photo shows the face from the side, not from the front</source>
        <translation>bu fotoğraf yüzü yandan gösteriyor, önden değil</translation>
    </message>
    <message>
        <source>no face can be seen from the front in this photo</source>
        <translation>bu fotoğrafta önden görünen bir yüz yok</translation>
    </message>
    <message>
        <source>this photo shows the head from the front or back, not from the side</source>
        <translation>bu fotoğraf başı önden veya arkadan gösteriyor, yandan değil</translation>
    </message>
    <message>
        <source>Rename or retake the photos so that each shows what its name says</source>
        <translation>Her fotoğraf kendi görünüşünü gösterecek biçimde yerlerini değiştirin veya yeniden çekin</translation>
    </message>
    <message>
        <source>%1: the corrected point %2 lies off the image</source>
        <translation>%1: düzeltilen %2 noktası görüntünün dışında</translation>
    </message>
    <message>
        <source>Drag it back on to the photo</source>
        <translation>Fotoğrafın üzerine geri sürükleyin</translation>
    </message>
    <message>
        <source>no person found in this photo</source>
        <translation>bu fotoğrafta kimse bulunamadı</translation>
    </message>
    <message>
        <source>Take it again with one person in full view</source>
        <translation>Tek kişi bütünüyle görünecek biçimde yeniden çekin</translation>
    </message>
    <message>
        <source>%1 people found in this photo</source>
        <translation>bu fotoğrafta %1 kişi bulundu</translation>
    </message>
    <message>
        <source>Take it again with one person alone in view</source>
        <translation>Karede tek kişi olacak biçimde yeniden çekin</translation>
    </message>
    <message>
        <source>the person&apos;s outline was not found</source>
        <translation>kişinin dış çizgisi bulunamadı</translation>
    </message>
    <message>
        <source>Retake the photo before a plain background</source>
        <translation>Fotoğrafı düz bir fon önünde yeniden çekin</translation>
    </message>
    <message>
        <source>the photo is missing</source>
        <translation>fotoğraf eksik</translation>
    </message>
    <message>
        <source>Put it into the photos folder</source>
        <translation>Fotoğraf klasörüne koyun</translation>
    </message>
    <message>
        <source>the photo is empty (0 bytes)</source>
        <translation>fotoğraf boş (0 bayt)</translation>
    </message>
    <message>
        <source>Copy the photo from the camera again, or retake it</source>
        <translation>Fotoğrafı kameradan yeniden kopyalayın ya da yeniden çekin</translation>
    </message>
    <message>
        <source>%1 has %2 megapixels, more than the %3 that can be read</source>
        <translation>%1 %2 megapiksel; okunabilen en çok %3</translation>
    </message>
    <message>
        <source>the photo</source>
        <translation>fotoğraf</translation>
    </message>
    <message>
        <source>this %1 photo</source>
        <translation>bu %1 fotoğraf</translation>
    </message>
    <message>
        <source>the photo has more than %1 megapixels</source>
        <translation>fotoğraf %1 megapikselden büyük</translation>
    </message>
    <message>
        <source>Save it smaller, 12 megapixels are plenty</source>
        <translation>Daha küçük kaydedin, 12 megapiksel yeterli</translation>
    </message>
    <message>
        <source>the photo is only %1 x %2 pixels</source>
        <translation>fotoğraf yalnızca %1 x %2 piksel</translation>
    </message>
    <message>
        <source>Use the original photo, not a thumbnail</source>
        <translation>Küçük resim değil, özgün fotoğrafı kullanın</translation>
    </message>
    <message>
        <source>this file is not a photo that can be read</source>
        <translation>bu dosya okunabilir bir fotoğraf değil</translation>
    </message>
    <message>
        <source>Install pillow-heif, or let the phone save photos as JPEG</source>
        <translation>pillow-heif kurun ya da telefon fotoğrafları JPEG olarak kaydetsin</translation>
    </message>
    <message>
        <source>Use a JPEG, PNG, TIFF or WebP photo</source>
        <translation>JPEG, PNG, TIFF veya WebP fotoğraf kullanın</translation>
    </message>
    <message>
        <source>the photo is damaged or cut short</source>
        <translation>fotoğraf bozuk ya da yarım</translation>
    </message>
    <message>
        <source>the photo cannot be opened</source>
        <translation>fotoğraf açılamıyor</translation>
    </message>
    <message>
        <source>the photo cannot be read</source>
        <translation>fotoğraf okunamıyor</translation>
    </message>
    <message>
        <source>Is the card or the cable still in its place?</source>
        <translation>Kart ya da kablo hâlâ yerinde mi?</translation>
    </message>
    <message>
        <source>the photos changed while they were cloned</source>
        <translation>fotoğraflar klonlanırken değişti</translation>
    </message>
    <message>
        <source>Clone again</source>
        <translation>Yeniden klonlayın</translation>
    </message>
    <message>
        <source>%1: depths of the face are those of a usual face of this shape</source>
        <translation>%1: derinlikler bu biçimde olağan bir yüzünkilerdir</translation>
    </message>
    <message>
        <source>there is no side photo of the face</source>
        <translation>yüzün yandan fotoğrafı yok</translation>
    </message>
    <message>
        <source>no profile was found in the side photo of the face</source>
        <translation>yüzün yandan fotoğrafında profil bulunamadı</translation>
    </message>
    <message>
        <source>No height was given: %1 cm is assumed, so every length is unscaled; %2</source>
        <translation>Boy verilmedi: %1 cm varsayılıyor, uzunluklar ölçeksiz; %2</translation>
    </message>
    <message>
        <source>give --height-cm or height_cm in person.toml</source>
        <translation>boyu ilk sayfada verin</translation>
    </message>
    <message>
        <source>%1: the clone covers the person&apos;s outline only to %2 percent</source>
        <translation>%1: klon, kişinin dış çizgisini yalnızca yüzde %2 oranında örtüyor</translation>
    </message>
    <message>
        <source>%1: the clone covers the head&apos;s outline only to %2 percent</source>
        <translation>%1: klon, başın dış çizgisini yalnızca yüzde %2 oranında örtüyor</translation>
    </message>
    <message>
        <source>%1: the hair is %2 times as large here as in the other photos, so this photo&apos;s was not used; take it again before a wall that looks unlike the hair</source>
        <translation>%1: Saçlar burada diğer fotoğraflardakinin %2 katı; bu fotoğrafın saçı kullanılmadı. Fotoğrafı saça benzemeyen bir duvarın önünde yeniden çekin</translation>
    </message>
    <message>
        <source>%1: nobody can be made out in this photo, so it was left out; retake it with hair, hood or scarf away from the face</source>
        <translation>%1: bu fotoğrafta kimse seçilemiyor, bu yüzden kullanılmadı; saç, kapüşon veya atkı yüzü örtmeden yeniden çekin</translation>
    </message>
    <message>
        <source>%1: hair hides the face in this photo, so it shows no more than the hair; retake it with hair, hood or scarf away from the face</source>
        <translation>%1: bu fotoğrafta saç yüzü örtüyor, bu yüzden yalnızca saçı gösteriyor; saç, kapüşon veya atkı yüzü örtmeden yeniden çekin</translation>
    </message>
    <message>
        <source>%1: the clone would cover only %2 percent of the person in this photo, so it was left out; check that it shows the same person in the same clothes, straight from the side or from behind</source>
        <translation>%1: klon bu fotoğraftaki kişinin yalnızca yüzde %2 kadarını örterdi, bu yüzden fotoğraf kullanılmadı; aynı kişiyi aynı giysilerle, tam yandan veya arkadan gösterdiğini denetleyin</translation>
    </message>
    <message>
        <source>%1: the %2 arm of the clone lies %3 cm beside the arm in this photo; let the arms hang a little away from the body and retake it</source>
        <translation>%1: klonun %2 kolu bu fotoğraftaki kolun %3 cm yanında duruyor; kolları gövdeden biraz ayrık sarkıtıp yeniden çekin</translation>
    </message>
    <message>
        <source>%1: the head is turned by about %2 degrees from where it should look; retake it with the head turned as the body</source>
        <translation>%1: baş, bakması gereken yönden yaklaşık %2 derece dönük; baş gövdeyle aynı yöne dönükken yeniden çekin</translation>
    </message>
    <message>
        <source>%1: the glasses became an object of their own and the skin behind their frame is a guess; take the face photos without glasses if you can</source>
        <translation>%1: gözlük ayrı bir nesne oldu ve çerçevenin arkasındaki ten tahmindir; mümkünse yüz fotoğraflarını gözlüksüz çekin</translation>
    </message>
    <message>
        <source>%1: headwear hides the hair and becomes part of the head; take it off if you can</source>
        <translation>%1: başlık saçı gizliyor ve başın bir parçası oluyor; mümkünse çıkarın</translation>
    </message>
    <message>
        <source>%1: hair hides an eye, so what lies behind it is a guess; retake the face photos with the hair away from the face</source>
        <translation>%1: saç bir gözü örtüyor, arkasında kalan tahmindir; yüz fotoğraflarını saç yüzden çekilmiş olarak yeniden çekin</translation>
    </message>
    <message>
        <source>left</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>right</source>
        <translation>sağ</translation>
    </message>
    <message>
        <source>nothing can be written into this folder</source>
        <translation>bu klasöre hiçbir şey yazılamıyor</translation>
    </message>
    <message>
        <source>the visitor cannot be moved</source>
        <translation>ziyaretçi taşınamıyor</translation>
    </message>
    <message>
        <source>these files still tell of who was deleted</source>
        <translation>bu dosyalar silinen kişileri hâlâ anlatıyor</translation>
    </message>
    <message>
        <source>Look at them: they may be copies</source>
        <translation>Onlara bakın: kopya olabilirler</translation>
    </message>
    <message>
        <source>there is no clone before this one</source>
        <translation>bundan önce bir klon yok</translation>
    </message>
    <message>
        <source>the page for telephones cannot be served</source>
        <translation>telefon sayfası sunulamıyor</translation>
    </message>
    <message>
        <source>Is the booth&apos;s network up, and is nothing else served here?</source>
        <translation>Standın ağı çalışıyor mu ve burada başka bir hizmet yok mu?</translation>
    </message>
    <message>
        <source>an encrypted page needs a library that is not here</source>
        <translation>şifreli sayfa, burada olmayan bir kitaplık gerektirir</translation>
    </message>
    <message>
        <source>Switch encryption off and use a hotspot of the booth&apos;s own with a password</source>
        <translation>Şifrelemeyi kapatıp standın parolalı erişim noktasını kullanın</translation>
    </message>
    <message>
        <source>the keys cannot be written</source>
        <translation>anahtarlar yazılamıyor</translation>
    </message>
    <message>
        <source>Check its permissions and the space left, or choose another</source>
        <translation>İzinlerini ve boş yeri denetleyin ya da başka bir klasör seçin</translation>
    </message>
    <message>
        <source>%1 was damaged and is put right from what could be read; the damaged file is kept beside it</source>
        <translation>%1: hasarlıydı ve okunabilen kısımdan düzeltildi; hasarlı dosya yanında saklanıyor</translation>
    </message>
    <message>
        <source>The event&apos;s settings</source>
        <extracomment>All that the library may say in the window. Files of the program&apos;s own, as the operator knows them.</extracomment>
        <translation>Etkinliğin ayarları</translation>
    </message>
    <message>
        <source>The corrected points</source>
        <translation>Düzeltilen noktalar</translation>
    </message>
    <message>
        <source>What is known of the visitor</source>
        <translation>Ziyaretçinin bilgileri</translation>
    </message>
    <message>
        <source>The visit</source>
        <translation>Ziyaret</translation>
    </message>
    <message>
        <source>The clone</source>
        <translation>Klon</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Onay</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Bellek</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Yazıcı</translation>
    </message>
    <message>
        <source>A photo</source>
        <translation>Bir fotoğraf</translation>
    </message>
    <message>
        <source>its files were changed while they were read</source>
        <translation>dosyaları okunurken değişti</translation>
    </message>
    <message>
        <source>gphoto2, which speaks with cameras, is not installed</source>
        <translation>kameralarla konuşan gphoto2 kurulu değil</translation>
    </message>
    <message>
        <source>Install it, or let the camera&apos;s own program write into a folder and watch that</source>
        <translation>Kurun, ya da kameranın kendi programı bir klasöre yazsın ve o izlensin</translation>
    </message>
    <message>
        <source>no camera is found on the cable</source>
        <translation>kabloda kamera bulunamadı</translation>
    </message>
    <message>
        <source>Is it switched on, and no other program using it? Plug it in again</source>
        <translation>Açık mı, başka bir program kullanmıyor mu? Yeniden takın</translation>
    </message>
    <message>
        <source>the camera took no photo</source>
        <translation>kamera fotoğraf çekmedi</translation>
    </message>
    <message>
        <source>the camera does not answer</source>
        <translation>kamera yanıt vermiyor</translation>
    </message>
    <message>
        <source>what was written there reads differently</source>
        <translation>oraya yazılanlar farklı okunuyor</translation>
    </message>
    <message>
        <source>Use another stick: this one loses what is written on it</source>
        <translation>Başka bir bellek kullanın: bu, üzerine yazılanı yitiriyor</translation>
    </message>
    <message>
        <source>this system does not tell which sticks are plugged in</source>
        <translation>bu sistem hangi belleklerin takılı olduğunu söylemiyor</translation>
    </message>
    <message>
        <source>Choose the stick&apos;s folder by hand</source>
        <translation>Belleğin klasörünü elle seçin</translation>
    </message>
    <message>
        <source>no program that ejects sticks is installed</source>
        <translation>bellek çıkaran bir program kurulu değil</translation>
    </message>
    <message>
        <source>Eject it with the desktop&apos;s own files window before it is pulled out</source>
        <translation>Çekmeden önce masaüstünün dosya penceresinden çıkarın</translation>
    </message>
    <message>
        <source>the stick cannot be ejected</source>
        <translation>bellek çıkarılamıyor</translation>
    </message>
    <message>
        <source>Close every window that shows its files, then eject it again</source>
        <translation>Dosyalarını gösteren her pencereyi kapatın, sonra yeniden çıkarın</translation>
    </message>
    <message>
        <source>the printer does not answer</source>
        <translation>yazıcı yanıt vermiyor</translation>
    </message>
    <message>
        <source>Is it switched on, with paper in it? A file can be printed elsewhere</source>
        <translation>Açık ve kâğıdı var mı? Dosya başka yerde de yazdırılabilir</translation>
    </message>
    <message>
        <source>the file exists and is not replaced</source>
        <translation>dosya zaten var ve değiştirilmez</translation>
    </message>
    <message>
        <source>Choose another --out file, or delete it</source>
        <translation>Başka bir ad seçin ya da dosyayı silin</translation>
    </message>
    <message>
        <source>no file can be called that</source>
        <translation>hiçbir dosyanın adı böyle olamaz</translation>
    </message>
    <message>
        <source>Choose another --out file</source>
        <translation>Başka bir ad seçin</translation>
    </message>
    <message>
        <source>this is no photo but a folder, a pipe or the like</source>
        <translation>bu bir fotoğraf değil; klasör, boru ya da benzeri</translation>
    </message>
    <message>
        <source>Put the photo itself there</source>
        <translation>Oraya fotoğrafın kendisini koyun</translation>
    </message>
    <message>
        <source>Choose another --out folder or --id, or move those files away</source>
        <translation>Başka bir klasör ya da ad seçin veya bu dosyaları taşıyın</translation>
    </message>
    <message>
        <source>the photos lie where the result would, and are never replaced</source>
        <translation>fotoğraflar sonucun yerinde duruyor ve asla değiştirilmez</translation>
    </message>
    <message>
        <source>the result of another visitor is there: other photos, from another folder</source>
        <translation>orada başka bir ziyaretçinin sonucu var: başka klasörden başka fotoğraflar</translation>
    </message>
    <message>
        <source>Choose another --id or --out folder, or forget that visitor first</source>
        <translation>Başka bir ad ya da klasör seçin veya önce o ziyaretçiyi silin</translation>
    </message>
    <message>
        <source>the earlier result holds files of somebody&apos;s own (%1)</source>
        <translation>önceki sonuçta başkasına ait dosyalar var (%1)</translation>
    </message>
    <message>
        <source>this cannot be read: %1</source>
        <translation>bu okunamıyor: %1</translation>
    </message>
    <message>
        <source>the photo cannot be opened: %1</source>
        <translation>fotoğraf açılamıyor: %1</translation>
    </message>
    <message>
        <source>No photo could be laid on the body: it keeps one plain colour</source>
        <translation>Bedene hiçbir fotoğraf yerleştirilemedi: tek renk kalıyor</translation>
    </message>
    <message>
        <source>%1: no focal length in the photo; %2 mm is assumed</source>
        <translation>%1: fotoğrafta odak uzaklığı yok; %2 mm varsayılıyor</translation>
    </message>
    <message>
        <source>%1: no focal length in the photo; %2 assumed.</source>
        <translation>%1: fotoğrafta odak uzaklığı yok; %2 varsayılıyor.</translation>
    </message>
    <message>
        <source>no photo shows the face from the front: the head is the generic one of this build</source>
        <translation>hiçbir fotoğraf yüzü önden göstermiyor: baş bu yapının genel başıdır</translation>
    </message>
    <message>
        <source>no usable front photo of the face: the face comes from the small one in the body photo</source>
        <translation>kullanılabilir önden yüz fotoğrafı yok: yüz, beden fotoğrafındaki küçük yüzden geliyor</translation>
    </message>
    <message>
        <source>Loose clothing between hips and knees was given its own surface</source>
        <translation>Kalça ile diz arasındaki bol giysiye ayrı bir yüzey verildi</translation>
    </message>
    <message>
        <source>There is no body photo: the body is the generic one of a matching build, its colours a guess</source>
        <translation>Beden fotoğrafı yok: beden uygun yapıda genel bir bedendir, renkleri tahmindir</translation>
    </message>
    <message>
        <source>There is no front photo of the body: its front is seen by the face photo alone</source>
        <translation>Bedenin önden fotoğrafı yok: önü yalnız yüz fotoğrafı görüyor</translation>
    </message>
    <message>
        <source>There is no side photo of the body: its depths are those of a usual body of this shape</source>
        <translation>Bedenin yandan fotoğrafı yok: derinlikler bu biçimde olağan bir bedeninkilerdir</translation>
    </message>
    <message>
        <source>There is no back photo of the body: its back is coloured from what the other photos show</source>
        <translation>Bedenin arkadan fotoğrafı yok: sırt öteki fotoğraflara göre renklendirildi</translation>
    </message>
    <message>
        <source>corrections.json corrects %1, but there is no such photo: they are not used</source>
        <translation>corrections.json %1 için düzeltme içeriyor ama böyle bir fotoğraf yok: kullanılmıyor</translation>
    </message>
    <message>
        <source>%1 has changed since its points were corrected: check them</source>
        <translation>%1 noktaları düzeltildikten sonra değişti: denetleyin</translation>
    </message>
    <message>
        <source>%1: the corrected point %2 could not be obeyed: %3</source>
        <translation>%1: düzeltilen %2 noktasına uyulamadı: %3</translation>
    </message>
    <message>
        <source>it sets the scale of its photo; hair and soles are no skin that could be laid on it</source>
        <translation>fotoğrafının ölçeğini belirler; saç ve tabanlar üzerine yatırılacak deri değildir</translation>
    </message>
    <message>
        <source>the face does not follow it, so the clone stays %1 px off it</source>
        <translation>yüz ona uymuyor, klon %1 piksel uzakta kalıyor</translation>
    </message>
    <message>
        <source>the limb does not reach it, so the clone stays %1 px off it</source>
        <translation>uzuv ona erişmiyor, klon %1 piksel uzakta kalıyor</translation>
    </message>
    <message>
        <source>no outline of the clone is seen there, so the point was left out</source>
        <translation>orada klonun dış çizgisi görünmüyor, nokta dışarıda bırakıldı</translation>
    </message>
    <message>
        <source>the point lies %1 cm off the body, so it was left out: drag it back to the outline</source>
        <translation>nokta bedenden %1 cm uzakta ve dışarıda bırakıldı: dış çizgiye geri sürükleyin</translation>
    </message>
    <message>
        <source>the skin would fold, so the clone stays %1 px off it</source>
        <translation>deri katlanırdı, klon %1 piksel uzakta kalıyor</translation>
    </message>
    <message>
        <source>it contradicts %1, so the clone stays %2 px off it</source>
        <translation>%1 ile çelişiyor, klon %2 piksel uzakta kalıyor</translation>
    </message>
    <message>
        <source>the clone does not tell its clothes from its skin</source>
        <translation>klon giysilerini derisinden ayırmıyor</translation>
    </message>
    <message>
        <source>Clone the photos again</source>
        <translation>Fotoğrafları yeniden klonlayın</translation>
    </message>
    <message>
        <source>no body could be made with a %1 of %2: %3 mm remain</source>
        <translation>%1 %2 olan bir beden yapılamadı: %3 mm kalıyor</translation>
    </message>
    <message>
        <source>Measure it again, or leave it out</source>
        <translation>Yeniden ölçün ya da boş bırakın</translation>
    </message>
    <message>
        <source>the sex %1 is not known</source>
        <translation>%1 cinsiyeti bilinmiyor</translation>
    </message>
    <message>
        <source>Give --sex f or --sex m</source>
        <translation>--sex f ya da --sex m verin</translation>
    </message>
    <message>
        <source>a stature of %1 cm cannot be made</source>
        <translation>%1 cm boy yapılamaz</translation>
    </message>
    <message>
        <source>Adults of %1 to %2 cm can be made</source>
        <translation>%1 ile %2 cm arası yetişkinler yapılabilir</translation>
    </message>
    <message>
        <source>At %1 years bodies of %2 to %3 cm can be made</source>
        <translation>%1 yaşında %2 ile %3 cm arası bedenler yapılabilir</translation>
    </message>
    <message>
        <source>an age of %1 years cannot be made</source>
        <translation>%1 yaş yapılamaz</translation>
    </message>
    <message>
        <source>People of %1 to %2 years can be made</source>
        <translation>%1 ile %2 yaş arası insanlar yapılabilir</translation>
    </message>
    <message>
        <source>These can: %1</source>
        <translation>Bunlar olabilir: %1</translation>
    </message>
    <message>
        <source>a %1 of %2 is no body&apos;s of %3 cm</source>
        <translation>%3 cm boyunda kimsede %1 %2 değildir</translation>
    </message>
    <message>
        <source>%1 with the other measures</source>
        <translation>%1, öbür ölçülerle</translation>
    </message>
    <message>
        <source>Measure again; %1 to %2 can be made</source>
        <translation>Yeniden ölçün; %1 ile %2 arası yapılabilir</translation>
    </message>
    <message>
        <source>the %1 cannot be told, it follows from the others</source>
        <translation>%1 verilemez, öbürlerinden çıkar</translation>
    </message>
    <message>
        <source>the %1 of %2 is smaller than the %3 of %4</source>
        <translation>%1 (%2), %3 ölçüsünden (%4) küçük</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Yeniden ölçün</translation>
    </message>
    <message>
        <source>Give --sex f or --sex m, or leave it out</source>
        <translation>--sex f ya da --sex m verin ya da boş bırakın</translation>
    </message>
    <message>
        <source>no consent to being shown is recorded</source>
        <translation>gösterilmeye onay kaydı yok</translation>
    </message>
    <message>
        <source>Write consent = &quot;...&quot; into person.toml and clone again</source>
        <translation>İlk sayfada onay alın ve yeniden klonlayın</translation>
    </message>
    <message>
        <source>Clones from %1 cm on can be</source>
        <translation>%1 cm&apos;den uzun klonlar olabilir</translation>
    </message>
    <message>
        <source>a statue has no clothes to take off</source>
        <translation>heykelin çıkarılacak giysisi yok</translation>
    </message>
    <message>
        <source>Undress the clone, then make a statue of it</source>
        <translation>Klonu soyun, sonra heykel yapın</translation>
    </message>
    <message>
        <source>a clone of %1 cm may be a child&apos;s and is not undressed</source>
        <translation>%1 cm boyundaki klon çocuk olabilir, soyulmaz</translation>
    </message>
    <message>
        <source>the clone has no measures of its body</source>
        <translation>klonun beden ölçüleri yok</translation>
    </message>
    <message>
        <source>the stature is missing</source>
        <translation>boy eksik</translation>
    </message>
    <message>
        <source>Give --stature and as many measures as you know</source>
        <translation>Boyu ve bildiğiniz kadar ölçü verin</translation>
    </message>
    <message>
        <source>the stature must be a length in centimetres</source>
        <translation>boy santimetre olmalı</translation>
    </message>
    <message>
        <source>For example --stature 168</source>
        <translation>Örneğin 168</translation>
    </message>
    <message>
        <source>the drawing has a DOCTYPE</source>
        <translation>çizimde DOCTYPE var</translation>
    </message>
    <message>
        <source>Save it as plain SVG</source>
        <translation>Düz SVG olarak kaydedin</translation>
    </message>
    <message>
        <source>a seam of the drawing does not name two edges</source>
        <translation>çizimdeki bir dikiş iki kenar adlandırmıyor</translation>
    </message>
    <message>
        <source>See docs/cloth.md for how a garment is drawn</source>
        <translation>Giysi çizimi için docs/cloth.md dosyasına bakın</translation>
    </message>
    <message>
        <source>the drawing has no width in millimetres</source>
        <translation>çizimin milimetre genişliği yok</translation>
    </message>
    <message>
        <source>Give it one, such as width=&quot;600mm&quot;</source>
        <translation>Verin, örneğin width=&quot;600mm&quot;</translation>
    </message>
    <message>
        <source>the piece %1 has %2 edges and %3 names for them</source>
        <translation>%1 parçasının %2 kenarı ve %3 adı var</translation>
    </message>
    <message>
        <source>Name every edge once, in the order of drawing</source>
        <translation>Her kenarı çizim sırasıyla bir kez adlandırın</translation>
    </message>
    <message>
        <source>the file is no SVG</source>
        <translation>dosya SVG değil</translation>
    </message>
    <message>
        <source>a part of the drawing is transformed</source>
        <translation>çizimin bir bölümü dönüştürülmüş</translation>
    </message>
    <message>
        <source>Apply the transformation first</source>
        <translation>Önce dönüşümü uygulayın</translation>
    </message>
    <message>
        <source>the outline of the piece %1 has a command %2</source>
        <translation>%1 parçasının çizgisinde %2 komutu var</translation>
    </message>
    <message>
        <source>the outline of the piece %1 ends early</source>
        <translation>%1 parçasının çizgisi erken bitiyor</translation>
    </message>
    <message>
        <source>the outline of the piece %1 goes out of all bounds</source>
        <translation>%1 parçasının çizgisi bütün sınırları aşıyor</translation>
    </message>
    <message>
        <source>the fabric %1 is not known</source>
        <translation>%1 kumaşı bilinmiyor</translation>
    </message>
    <message>
        <source>The fabrics are %1</source>
        <translation>Kumaşlar: %1</translation>
    </message>
    <message>
        <source>the garment %1 cannot be laid round this body</source>
        <translation>%1 giysisi bu bedenin çevresine yerleştirilemez</translation>
    </message>
    <message>
        <source>there is not memory enough for the cloth</source>
        <translation>kumaş için yeterli bellek yok</translation>
    </message>
    <message>
        <source>Make its triangles larger</source>
        <translation>Üçgenlerini büyütün</translation>
    </message>
    <message>
        <source>the garment %1 is not known</source>
        <translation>%1 giysisi bilinmiyor</translation>
    </message>
    <message>
        <source>The garments are %1, or a .json or .svg file</source>
        <translation>Giysiler: %1 ya da .json veya .svg dosyası</translation>
    </message>
    <message>
        <source>a %1 of %2 cm cannot be cut</source>
        <translation>%2 cm %1 kesilemez</translation>
    </message>
    <message>
        <source>%1 to %2 cm hang clear of the floor</source>
        <translation>%1 ile %2 cm arası yere değmez</translation>
    </message>
    <message>
        <source>the motion %1 is not known</source>
        <translation>%1 hareketi bilinmiyor</translation>
    </message>
    <message>
        <source>Give walk, or a captured walk (.bvh)</source>
        <translation>Kendi yürüyüşü ya da kaydedilmiş yürüyüş (.bvh) seçin</translation>
    </message>
    <message>
        <source>a garment has 1 to %1 pieces</source>
        <translation>bir giysinin 1 ile %1 arası parçası olur</translation>
    </message>
    <message>
        <source>See docs/cloth.md for the form of a garment&apos;s file</source>
        <translation>Giysi dosyasının biçimi için docs/cloth.md dosyasına bakın</translation>
    </message>
    <message>
        <source>two pieces share one name</source>
        <translation>iki parçanın adı aynı</translation>
    </message>
    <message>
        <source>some pieces hang from a ring and others lie round the body</source>
        <translation>bazı parçalar halkadan sarkıyor, bazıları bedeni sarıyor</translation>
    </message>
    <message>
        <source>the piece %1 lies round %2, which is no part</source>
        <translation>%1 parçası %2 çevresinde, bu bir bölüm değil</translation>
    </message>
    <message>
        <source>A piece lies round %1</source>
        <translation>Parça şunları sarar: %1</translation>
    </message>
    <message>
        <source>Let every edge begin where the one before ends</source>
        <translation>Her kenar öncekinin bittiği yerde başlasın</translation>
    </message>
    <message>
        <source>the piece %1 has fewer than two edges</source>
        <translation>%1 parçasının ikiden az kenarı var</translation>
    </message>
    <message>
        <source>the piece %1 has an edge that is no curve of four points</source>
        <translation>%1 parçasının bir kenarı dört noktalı eğri değil</translation>
    </message>
    <message>
        <source>the piece %1 has no garment&apos;s size</source>
        <translation>%1 parçası giysi boyunda değil</translation>
    </message>
    <message>
        <source>Write metres</source>
        <translation>Metre yazın</translation>
    </message>
    <message>
        <source>the outline of the piece %1 crosses itself</source>
        <translation>%1 parçasının çizgisi kendini kesiyor</translation>
    </message>
    <message>
        <source>Draw it without a loop</source>
        <translation>Düğümsüz çizin</translation>
    </message>
    <message>
        <source>the held edge %1 is in no piece</source>
        <translation>tutulan %1 kenarı hiçbir parçada yok</translation>
    </message>
    <message>
        <source>the seam&apos;s edge %1 is in no piece</source>
        <translation>dikişin %1 kenarı hiçbir parçada yok</translation>
    </message>
    <message>
        <source>the edge %1 is sewn twice</source>
        <translation>%1 kenarı iki kez dikiliyor</translation>
    </message>
    <message>
        <source>the edges %1 and %2 of a seam are %3 long</source>
        <translation>bir dikişin %1 ve %2 kenarları %3 uzunlukta</translation>
    </message>
    <message>
        <source>Make them alike</source>
        <translation>Eşitleyin</translation>
    </message>
    <message>
        <source>the outline of the piece %1 is open</source>
        <translation>%1 parçasının çizgisi açık</translation>
    </message>
    <message>
        <source>the file is no garment</source>
        <translation>dosya giysi değil</translation>
    </message>
    <message>
        <source>the piece %1 lies at heights that do not rise</source>
        <translation>%1 parçasının yükseklikleri artmıyor</translation>
    </message>
    <message>
        <source>the clone would be replaced by itself dressed</source>
        <translation>klonun yerine giyinmiş hali yazılırdı</translation>
    </message>
    <message>
        <source>the file is no garment of GarmentCode</source>
        <translation>dosya bir GarmentCode giysisi değil</translation>
    </message>
    <message>
        <source>Write it again with GarmentCode, or draw it anew (docs/cloth.md)</source>
        <translation>GarmentCode ile yeniden yazın ya da yeniden çizin (docs/cloth.md)</translation>
    </message>
    <message>
        <source>the draft has no parts &apos;front&apos; and &apos;back&apos;</source>
        <translation>Kalıpta &apos;front&apos; ve &apos;back&apos; parçaları yok</translation>
    </message>
    <message>
        <source>Cloner reads fronts and backs on the fold and sleeves of one piece (docs/cloth.md)</source>
        <translation>Cloner kumaş katında ön ve arka parçaları ile tek parça kolları okur (docs/cloth.md)</translation>
    </message>
    <message>
        <source>the part %1 has no outline</source>
        <translation>%1 parçasının çevre çizgisi yok</translation>
    </message>
    <message>
        <source>the part %1 is not cut on the fold</source>
        <translation>%1 parçası kumaş katında kesilmiyor</translation>
    </message>
    <message>
        <source>the part %1 has %2 edges from corner to corner, not hem, side, armhole, shoulder, neck</source>
        <translation>%1 parçasının köşeden köşeye %2 kenarı var; etek ucu, yan, kol oyuğu, omuz, yaka değil</translation>
    </message>
    <message>
        <source>the armhole of the part %1 lies below this wearer&apos;s trunk</source>
        <translation>%1 parçasının kol oyuğu bu kişinin gövdesinin altında kalıyor</translation>
    </message>
    <message>
        <source>Draft it to the wearer&apos;s measures, in millimetres</source>
        <translation>Kişinin ölçülerine göre, milimetre olarak çizin</translation>
    </message>
    <message>
        <source>the sleeve has %1 edges from corner to corner, not hem, side, cap and side</source>
        <translation>Kolun köşeden köşeye %1 kenarı var; uç, yan, kol evi ve yan değil</translation>
    </message>
    <message>
        <source>the part %1 is no whole sleeve</source>
        <translation>%1 parçası tam bir kol değil</translation>
    </message>
    <message>
        <source>the piece %1 has no edge to hang from</source>
        <translation>%1 parçasının asılacak kenarı yok</translation>
    </message>
    <message>
        <source>Name the edge at the ring %1 and the lowest one %2</source>
        <translation>Halkadaki kenara %1, en alttakine %2 deyin</translation>
    </message>
    <message>
        <source>no dressed clone is written as %1</source>
        <translation>giydirilmiş klon %1 olarak yazılmaz</translation>
    </message>
    <message>
        <source>Give --out a name that ends with %1</source>
        <translation>%1 ile biten bir ad seçin</translation>
    </message>
    <message>
        <source>the blobs lie nowhere near most of the body</source>
        <translation>bloblar bedenin çoğundan uzakta</translation>
    </message>
    <message>
        <source>cloner statue blobs CLONE --out body.json writes blobs to begin with</source>
        <translation>Pencerenin önerdiği bloblarla başlayın</translation>
    </message>
    <message>
        <source>a body has 1 to %1 blobs, not %2</source>
        <translation>bir bedenin 1 ile %1 arası blobu olur, %2 değil</translation>
    </message>
    <message>
        <source>See docs/statues.md for how blobs are written</source>
        <translation>Blob yazımı için docs/statues.md dosyasına bakın</translation>
    </message>
    <message>
        <source>blob %1 lacks its joint or radius, or tells more than blobs have</source>
        <translation>%1. blobun eklemi ya da yarıçapı eksik ya da fazla bilgi var</translation>
    </message>
    <message>
        <source>blob %1 has no name of 1 to 60 letters</source>
        <translation>%1. blobun 1-60 harflik adı yok</translation>
    </message>
    <message>
        <source>the blob %1 needs a place for each end</source>
        <translation>%1 blobunun her ucu için yer gerekli</translation>
    </message>
    <message>
        <source>the %1 must be %2 numbers from %3 to %4</source>
        <translation>%1: %3 ile %4 arasında %2 sayı olmalı</translation>
    </message>
    <message>
        <source>the blob %1 hangs on %2, which is no joint</source>
        <translation>%1 blobu %2 üzerinde, bu eklem değil</translation>
    </message>
    <message>
        <source>Joints have H-Anim&apos;s names</source>
        <translation>Eklemler H-Anim adlarını taşır</translation>
    </message>
    <message>
        <source>the file holds no list of %1</source>
        <translation>dosyada %1 listesi yok</translation>
    </message>
    <message>
        <source>the %1 are no JSON</source>
        <translation>%1 JSON değil</translation>
    </message>
    <message>
        <source>%1 markers are too few</source>
        <translation>%1 işaret çok az</translation>
    </message>
    <message>
        <source>Mark at least %1 vertices</source>
        <translation>En az %1 nokta işaretleyin</translation>
    </message>
    <message>
        <source>a marker&apos;s vertex is not on the mesh</source>
        <translation>bir işaretin noktası ağda değil</translation>
    </message>
    <message>
        <source>It has %1 of them</source>
        <translation>%1 tane var</translation>
    </message>
    <message>
        <source>two markers lie on the same vertex</source>
        <translation>iki işaret aynı noktada</translation>
    </message>
    <message>
        <source>Leave one of them out</source>
        <translation>Birini çıkarın</translation>
    </message>
    <message>
        <source>all markers lie on one line</source>
        <translation>bütün işaretler bir çizgide</translation>
    </message>
    <message>
        <source>Mark vertices beside it too</source>
        <translation>Yanına da işaret koyun</translation>
    </message>
    <message>
        <source>markers on mesh and photo differ in number</source>
        <translation>ağdaki ve fotoğraftaki işaret sayısı farklı</translation>
    </message>
    <message>
        <source>Give each both places</source>
        <translation>Her birine iki yer verin</translation>
    </message>
    <message>
        <source>all markers lie at one place of the photo</source>
        <translation>bütün işaretler fotoğrafın aynı yerinde</translation>
    </message>
    <message>
        <source>Drag them to their places</source>
        <translation>Yerlerine sürükleyin</translation>
    </message>
    <message>
        <source>a mesh from elsewhere keeps the photo&apos;s colours</source>
        <translation>başka yerden bir ağ fotoğrafın renklerini korur</translation>
    </message>
    <message>
        <source>Leave --material out</source>
        <translation>Malzeme vermeyin</translation>
    </message>
    <message>
        <source>neck girth</source>
        <translation>boyun çevresi</translation>
    </message>
    <message>
        <source>bust girth</source>
        <translation>göğüs çevresi</translation>
    </message>
    <message>
        <source>underbust girth</source>
        <translation>göğüs altı çevresi</translation>
    </message>
    <message>
        <source>waist girth</source>
        <translation>bel çevresi</translation>
    </message>
    <message>
        <source>hip girth</source>
        <translation>kalça çevresi</translation>
    </message>
    <message>
        <source>thigh girth</source>
        <translation>uyluk çevresi</translation>
    </message>
    <message>
        <source>inside leg height</source>
        <translation>iç bacak boyu</translation>
    </message>
    <message>
        <source>arm length</source>
        <translation>kol boyu</translation>
    </message>
    <message>
        <source>skirt</source>
        <translation>etek</translation>
    </message>
    <message>
        <source>circle-skirt</source>
        <translation>kloş etek</translation>
    </message>
    <message>
        <source>straight-skirt</source>
        <translation>düz etek</translation>
    </message>
    <message>
        <source>long-skirt</source>
        <translation>uzun etek</translation>
    </message>
    <message>
        <source>cape</source>
        <translation>pelerin</translation>
    </message>
    <message>
        <source>tee</source>
        <translation>tişört</translation>
    </message>
    <message>
        <source>dress</source>
        <translation>elbise</translation>
    </message>
    <message>
        <source>coat</source>
        <translation>palto</translation>
    </message>
    <message>
        <source>trousers</source>
        <translation>pantolon</translation>
    </message>
</context>
<context>
    <name>troubles</name>
    <message>
        <source>Nobody was found: take it again with the person in full view.</source>
        <extracomment>One sentence each: what is wrong with a photo and what to do, for an operator with the visitor still there.</extracomment>
        <translation>Kimse bulunamadı: kişi tam görünecek şekilde yeniden çekin.</translation>
    </message>
    <message>
        <source>More than one person: take it again with one person alone.</source>
        <translation>Birden fazla kişi: yalnız bir kişiyle yeniden çekin.</translation>
    </message>
    <message>
        <source>The person lies on the side: turn the photo.</source>
        <translation>Kişi yan yatmış: fotoğrafı döndürün.</translation>
    </message>
    <message>
        <source>It shows none of the five views: turn the person or retake.</source>
        <translation>Beş görünümden hiçbirini göstermiyor: kişiyi döndürün veya yeniden çekin.</translation>
    </message>
    <message>
        <source>It does not show this view: exchange or retake it.</source>
        <translation>Bu görünümü göstermiyor: değiş tokuş edin veya yeniden çekin.</translation>
    </message>
    <message>
        <source>The person is cut off: step back and retake.</source>
        <translation>Kişi kesilmiş: geri çekilip yeniden çekin.</translation>
    </message>
    <message>
        <source>The person is small: step nearer or zoom in.</source>
        <translation>Kişi küçük: yaklaşın veya yakınlaştırın.</translation>
    </message>
    <message>
        <source>It is blurred: hold still, focus and retake.</source>
        <translation>Bulanık: sabit tutun, odaklayın, yeniden çekin.</translation>
    </message>
    <message>
        <source>It is dark: add light or expose longer.</source>
        <translation>Karanlık: ışık ekleyin veya daha uzun pozlayın.</translation>
    </message>
    <message>
        <source>It is burnt out: less light or a shorter exposure.</source>
        <translation>Aşırı parlak: ışığı azaltın veya daha kısa pozlayın.</translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>Body, front</source>
        <extracomment>``translate(&quot;page&quot;, &quot;Text&quot;)``: Qt&apos;s own tools find these calls and write them into the translators&apos; files.</extracomment>
        <translation>Beden, ön</translation>
    </message>
    <message>
        <source>Body, side</source>
        <translation>Beden, yan</translation>
    </message>
    <message>
        <source>Body, back</source>
        <translation>Beden, arka</translation>
    </message>
    <message>
        <source>Face, front</source>
        <translation>Yüz, ön</translation>
    </message>
    <message>
        <source>Face, side</source>
        <translation>Yüz, yan</translation>
    </message>
</context>
<context>
    <name>visitor</name>
    <message>
        <source>known</source>
        <translation>biliniyor</translation>
    </message>
    <message>
        <source>Height is known</source>
        <translation>Boy biliniyor</translation>
    </message>
    <message>
        <source>Height in centimetres</source>
        <translation>Santimetre olarak boy</translation>
    </message>
    <message>
        <source>Height, feet</source>
        <translation>Boy, fit</translation>
    </message>
    <message>
        <source>Height, inches</source>
        <translation>Boy, inç</translation>
    </message>
    <message>
        <source>Unit of the height</source>
        <translation>Boy birimi</translation>
    </message>
    <message>
        <source>The visitor has to agree before photos are taken.</source>
        <extracomment>Typing that rests so long is saved, milliseconds.</extracomment>
        <translation>Fotoğraflardan önce ziyaretçi onay vermelidir.</translation>
    </message>
    <message>
        <source>N&amp;ame or number</source>
        <translation>&amp;Ad veya numara</translation>
    </message>
    <message>
        <source>&amp;Height without shoes</source>
        <translation>Ayakkabısız &amp;boy</translation>
    </message>
    <message>
        <source>&amp;Language of the consent</source>
        <translation>Onayın &amp;dili</translation>
    </message>
    <message>
        <source>Who may use the &amp;files</source>
        <translation>Dosyaları &amp;kim kullanabilir</translation>
    </message>
    <message>
        <source>The visitor has read this and &amp;agrees</source>
        <translation>Ziyaretçi bunu okudu ve &amp;kabul ediyor</translation>
    </message>
    <message>
        <source>May be seen on the &amp;screen for visitors</source>
        <translation>Ziyaretçi &amp;ekranında gösterilebilir</translation>
    </message>
    <message>
        <source>Agrees: on to the &amp;photos</source>
        <translation>Kabul ediyor: &amp;fotoğraflara geç</translation>
    </message>
    <message>
        <source>To find each other again; a number will do, or nothing at all.</source>
        <translation>Yeniden bulmak için; bir numara yeter, boş da kalabilir.</translation>
    </message>
    <message>
        <source>With the first name, among the others of today; asked apart.</source>
        <translation>Adıyla, bugünkü diğerlerinin arasında; ayrıca sorulur.</translation>
    </message>
    <message>
        <source>Name or number of the visitor</source>
        <translation>Ziyaretçinin adı veya numarası</translation>
    </message>
    <message>
        <source>Language of the consent</source>
        <translation>Onayın dili</translation>
    </message>
    <message>
        <source>Who may use the files</source>
        <translation>Dosyaları kim kullanabilir</translation>
    </message>
    <message>
        <source>The visitor agrees</source>
        <translation>Ziyaretçi kabul ediyor</translation>
    </message>
    <message>
        <source>May be seen on the screen for visitors</source>
        <translation>Ziyaretçi ekranında gösterilebilir</translation>
    </message>
    <message>
        <source>It gives the clone its true size; everything else is measured in the photos.</source>
        <translation>Klona gerçek boyunu verir; geri kalan her şey fotoğraflarda ölçülür.</translation>
    </message>
    <message>
        <source>Unknown: {n} cm is assumed, and every length is unscaled.</source>
        <translation>Bilinmiyor: {n} cm varsayılır, tüm uzunluklar ölçeksizdir.</translation>
    </message>
    <message>
        <source>Recorded: {text}</source>
        <translation>Kaydedildi: {text}</translation>
    </message>
    <message>
        <source>The clone may &amp;walk in the scene “{scene}”</source>
        <translation>Klon “{scene}” sahnesinde &amp;yürüyebilir</translation>
    </message>
    <message>
        <source>Visitor</source>
        <translation>Ziyaretçi</translation>
    </message>
    <message>
        <source>Begin with a visitor first.</source>
        <translation>Önce bir ziyaretçiyle başlayın.</translation>
    </message>
    <message>
        <source>Visitors</source>
        <translation>Ziyaretçiler</translation>
    </message>
    <message>
        <source>&amp;New visitor</source>
        <translation>&amp;Yeni ziyaretçi</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Aç…</translation>
    </message>
    <message>
        <source>Visitors of this event</source>
        <translation>Bu etkinliğin ziyaretçileri</translation>
    </message>
    <message>
        <source>No event is open.</source>
        <translation>Açık etkinlik yok.</translation>
    </message>
    <message>
        <source>Open the event&apos;s folder; an empty one begins a new event.</source>
        <translation>Etkinliğin klasörünü açın; boş klasör yeni etkinlik başlatır.</translation>
    </message>
    <message>
        <source>Press New visitor when somebody steps up.</source>
        <translation>Biri gelince Yeni ziyaretçi’ye basın.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Aç</translation>
    </message>
    <message>
        <source>&amp;Save everything held…</source>
        <translation>Tutulan her şeyi &amp;kaydet…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Sil…</translation>
    </message>
    <message>
        <source>Opening {name}…</source>
        <translation>{name} açılıyor…</translation>
    </message>
    <message>
        <source>Visitor {n}</source>
        <extracomment>Folders where they lie now, and what went wrong with others.</extracomment>
        <translation>Ziyaretçi {n}</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Son açılanlar</translation>
    </message>
</context>
<context>
    <name>webcam</name>
    <message>
        <source>Webcam</source>
        <extracomment>Time between button and photo, seconds, so that the operator can look at the visitor again (taste).</extracomment>
        <translation>Web kamerası</translation>
    </message>
    <message>
        <source>&amp;Take the photo</source>
        <translation>Fotoğrafı &amp;çek</translation>
    </message>
    <message>
        <source>T&amp;urn the picture</source>
        <translation>Resmi &amp;döndür</translation>
    </message>
    <message>
        <source>Fill the outline, and keep all of it in the picture.</source>
        <translation>Konturu doldurun ve tümünü resimde tutun.</translation>
    </message>
    <message>
        <source>Camera on a cable</source>
        <translation>Kablodaki kamera</translation>
    </message>
    <message>
        <source>Which camera takes it</source>
        <translation>Hangi kamera çekiyor</translation>
    </message>
    <message>
        <source>Which photo is taken</source>
        <translation>Hangi fotoğraf çekiliyor</translation>
    </message>
    <message>
        <source>Live picture</source>
        <translation>Canlı görüntü</translation>
    </message>
</context>
<context>
    <name>window</name>
    <message>
        <source>Folder of the event, or of one visitor</source>
        <extracomment>Names under which a visit&apos;s file remembers the page.</extracomment>
        <translation>Etkinliğin veya bir ziyaretçinin klasörü</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Geri</translation>
    </message>
    <message>
        <source>L&amp;ook at the points</source>
        <translation>N&amp;oktalara bak</translation>
    </message>
    <message>
        <source>Ne&amp;xt visitor</source>
        <translation>S&amp;onraki ziyaretçi</translation>
    </message>
    <message>
        <source>&amp;Clone</source>
        <translation>&amp;Klonla</translation>
    </message>
    <message>
        <source>Ne&amp;xt</source>
        <translation>&amp;İleri</translation>
    </message>
    <message>
        <source>{n} more</source>
        <extracomment>How long good news is shown, milliseconds; what went wrong stays until somebody closes it or the visitor goes.</extracomment>
        <translation>{n} tane daha</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>İletiyi kapat</translation>
    </message>
    <message>
        <source>Step {n}: {title}</source>
        <translation>Adım {n}: {title}</translation>
    </message>
    <message>
        <source>{name} waits for the clone now: it was not asked for.</source>
        <translation>{name} artık klonunu bekliyor: istenmemişti.</translation>
    </message>
    <message>
        <source>{name} lies in the trash for {n} days.</source>
        <translation>{name} {n} gün çöpte kalır.</translation>
    </message>
    <message>
        <source>{name}: the clone before is back. The other one is kept: the same again.</source>
        <translation>{name}: önceki klon geri geldi. Öteki saklandı: aynısını yineleyin.</translation>
    </message>
    <message>
        <source>{name}: the clone is ready.</source>
        <translation>{name}: klon hazır.</translation>
    </message>
</context>
<context>
    <name>worth</name>
    <message>
        <source>the height</source>
        <translation>boy</translation>
    </message>
    <message>
        <source>the face</source>
        <translation>yüz</translation>
    </message>
    <message>
        <source>the pose</source>
        <translation>duruş</translation>
    </message>
    <message>
        <source>how broad the body is</source>
        <translation>gövdenin genişliği</translation>
    </message>
    <message>
        <source>All points are sure: the clone needs no hand.</source>
        <translation>Bütün noktalar kesin: klon için elle düzeltme gerekmiyor.</translation>
    </message>
    <message>
        <source> and {n} more</source>
        <translation> ve {n} tane daha</translation>
    </message>
    <message>
        <source>Worth a look under Points: {names}. They set {changes}.</source>
        <translation>Noktalar altında bakmaya değer: {names}. Belirledikleri: {changes}.</translation>
    </message>
</context>
</TS>
