<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>%1 over time</source>
        <translation>%1 über der Zeit</translation>
    </message>
    <message>
        <source>the film&apos;s format is not known.</source>
        <translation>Das Format des Films ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Use a name ending in .mp4, .webm or .gif.</source>
        <translation>Einen Namen wählen, der auf .mp4, .webm oder .gif endet.</translation>
    </message>
    <message>
        <source>there is no run to film.</source>
        <translation>Es gibt keine Fahrt zum Filmen.</translation>
    </message>
    <message>
        <source>Run a scenario first.</source>
        <translation>Zuerst ein Szenario fahren.</translation>
    </message>
    <message>
        <source>films are made by ffmpeg, which is not there.</source>
        <translation>Filme macht ffmpeg, und das fehlt.</translation>
    </message>
    <message>
        <source>Install it; on Debian: apt install ffmpeg.</source>
        <translation>Installieren; unter Debian: apt install ffmpeg.</translation>
    </message>
    <message>
        <source>the film could not be written.</source>
        <translation>Der Film konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>the film could not be written: %1.</source>
        <translation>Der Film konnte nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>Check the folder and the free space of the disk.</source>
        <translation>Ordner und freien Platz auf dem Datenträger prüfen.</translation>
    </message>
</context>
<context>
    <name>fields</name>
    <message>
        <source>Display unit</source>
        <translation>Anzeigeeinheit</translation>
    </message>
    <message>
        <source>Unit on the screen; files hold SI</source>
        <translation>Einheit auf dem Bildschirm; Dateien enthalten SI</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>In the rover frame: x forward, y left, z up from the ground</source>
        <translation>Im Rover-Koordinatensystem: x vorwärts, y links, z vom Boden nach oben</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Held in the world: a frame, or a test stand</source>
        <translation>In der Welt festgehalten: ein Gestell oder ein Prüfstand</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Ixx Iyy Izz Ixy Ixz Iyz about the centre of mass</source>
        <translation>Ixx Iyy Izz Ixy Ixz Iyz um den Schwerpunkt</translation>
    </message>
    <message>
        <source>First body</source>
        <translation>Erster Körper</translation>
    </message>
    <message>
        <source>The free directions are fixed to this body</source>
        <translation>Die freien Richtungen sind an diesem Körper fest</translation>
    </message>
    <message>
        <source>Second body</source>
        <translation>Zweiter Körper</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Pin axis</source>
        <translation>Drehachse</translation>
    </message>
    <message>
        <source>Direction; its length does not matter</source>
        <translation>Richtung; ihre Länge ist gleich</translation>
    </message>
    <message>
        <source>Free as built</source>
        <translation>Frei wie gebaut</translation>
    </message>
    <message>
        <source>Free directions, separated by commas: turn axis, slide axis, turn x, slide z, slide 1 0 1</source>
        <translation>Freie Richtungen, durch Kommas getrennt: turn axis, slide axis, turn x, slide z, slide 1 0 1</translation>
    </message>
    <message>
        <source>Free, relaxed</source>
        <translation>Frei, gelockert</translation>
    </message>
    <message>
        <source>Free directions in the relaxed model; empty = as built</source>
        <translation>Freie Richtungen im gelockerten Modell; leer = wie gebaut</translation>
    </message>
    <message>
        <source>Relaxed on</source>
        <translation>Gelockert an</translation>
    </message>
    <message>
        <source>Which of the two mirrored joints the relaxed model changes</source>
        <translation>Welches der beiden gespiegelten Gelenke das gelockerte Modell ändert</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>A locked joint welds its two bodies</source>
        <translation>Ein gesperrtes Gelenk verschweißt seine beiden Körper</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Anschläge</translation>
    </message>
    <message>
        <source>Turn about the pin axis; the drawn pose is 0</source>
        <translation>Drehung um die Drehachse; die gezeichnete Stellung ist 0</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Torque limit</source>
        <translation>Größtes Moment</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>Rotor inertia</source>
        <translation>Rotorträgheit</translation>
    </message>
    <message>
        <source>Reflected to the wheel</source>
        <translation>Auf das Rad umgerechnet</translation>
    </message>
    <message>
        <source>Wheel&apos;s body</source>
        <translation>Körper des Rades</translation>
    </message>
    <message>
        <source>Axle</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The joint the wheel turns on</source>
        <translation>Das Gelenk, auf dem sich das Rad dreht</translation>
    </message>
    <message>
        <source>Grousers</source>
        <translation>Stollen</translation>
    </message>
    <message>
        <source>Drawn only</source>
        <translation>Nur gezeichnet</translation>
    </message>
    <message>
        <source>Relaxed: free sideways</source>
        <translation>Gelockert: seitlich frei</translation>
    </message>
    <message>
        <source>The relaxed model lets this contact slide sideways</source>
        <translation>Im gelockerten Modell darf dieser Kontakt seitlich gleiten</translation>
    </message>
    <message>
        <source>Which of the two mirrored wheels the relaxed model frees</source>
        <translation>Welches der beiden gespiegelten Räder das gelockerte Modell freigibt</translation>
    </message>
    <message>
        <source>Steering motor</source>
        <translation>Lenkmotor</translation>
    </message>
    <message>
        <source>Steering joint</source>
        <translation>Lenkgelenk</translation>
    </message>
    <message>
        <source>Upright pin; welded unless the controller steers</source>
        <translation>Aufrechtes Drehgelenk; verschweißt, solange der Regler nicht lenkt</translation>
    </message>
    <message>
        <source>Steering torque</source>
        <translation>Lenkmoment</translation>
    </message>
    <message>
        <source>0 = that of the wheel&apos;s motor</source>
        <translation>0 = das des Radmotors</translation>
    </message>
    <message>
        <source>Steering speed</source>
        <translation>Lenkgeschwindigkeit</translation>
    </message>
    <message>
        <source>On joint</source>
        <translation>Am Gelenk</translation>
    </message>
    <message>
        <source>A torsion spring about this joint; empty = between points</source>
        <translation>Eine Drehfeder um dieses Gelenk; leer = zwischen Punkten</translation>
    </message>
    <message>
        <source>First point</source>
        <translation>Erster Punkt</translation>
    </message>
    <message>
        <source>Second point</source>
        <translation>Zweiter Punkt</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Preload</source>
        <translation>Vorspannung</translation>
    </message>
    <message>
        <source>At the drawn pose; positive pushes apart</source>
        <translation>In der gezeichneten Stellung; positiv drückt auseinander</translation>
    </message>
    <message>
        <source>First joint</source>
        <translation>Erstes Gelenk</translation>
    </message>
    <message>
        <source>Second joint</source>
        <translation>Zweites Gelenk</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>turn(second) = ratio * turn(first)</source>
        <translation>Drehung(zweites) = Übersetzung * Drehung(erstes)</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>Soil</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>Parameters set</source>
        <translation>Gesetzte Parameter</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>x of the first feature</source>
        <translation>x des ersten Hindernisses</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Step: of the top; stairs: of a tread; trench: its width; sinus: of a wave; ramp: of its run; cross slope: until it is reached; others: of the whole</source>
        <translation>Stufe: der Oberseite; Treppe: eines Auftritts; Graben: seine Breite; Sinus: einer Welle; Rampe: ihr Auslauf; Querneigung: bis sie erreicht ist; sonst: des Ganzen</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Of steps, waves, bumps, features or particles</source>
        <translation>Von Stufen, Wellen, Höckern, Hindernissen oder Teilchen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Same seed, same terrain</source>
        <translation>Gleicher Startwert, gleiches Gelände</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Bedeckung</translation>
    </message>
    <message>
        <source>Share of the ground under rocks, k of Golombek and Rapp</source>
        <translation>Anteil des Bodens unter Steinen, k nach Golombek und Rapp</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Under the wheels of both sides or of one</source>
        <translation>Unter den Rädern beider Seiten oder einer</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>The right half is the mirror image of the left</source>
        <translation>Die rechte Hälfte ist das Spiegelbild der linken</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Between two points of the grid; an image&apos;s pixel</source>
        <translation>Zwischen zwei Punkten des Gitters; ein Bildpunkt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Relative to the project&apos;s folder, or absolute</source>
        <translation>Relativ zum Ordner des Projekts oder absolut</translation>
    </message>
    <message>
        <source>File units</source>
        <translation>Dateieinheit</translation>
    </message>
    <message>
        <source>Unit of length of the file&apos;s numbers: m, mm, in, ...</source>
        <translation>Längeneinheit der Zahlen in der Datei: m, mm, in, ...</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Further factor on the file&apos;s numbers</source>
        <translation>Weiterer Faktor auf die Zahlen der Datei</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up</source>
        <translation>Achse der Datei, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>Where the file&apos;s origin lies in the world</source>
        <translation>Wo der Ursprung der Datei in der Welt liegt</translation>
    </message>
    <message>
        <source>Terrains added</source>
        <translation>Weiteres Gelände</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Rectangles of ground with values of their own</source>
        <translation>Rechtecke des Bodens mit eigenen Werten</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Coulomb coefficient between wheel and ground</source>
        <translation>Reibungszahl nach Coulomb zwischen Rad und Boden</translation>
    </message>
    <message>
        <source>Rolling resistance</source>
        <translation>Rollwiderstand</translation>
    </message>
    <message>
        <source>c in: moment = c N R</source>
        <translation>c in: Moment = c N R</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Yaw rate of speed control, to the left</source>
        <translation>Giergeschwindigkeit der Geschwindigkeitsregelung, nach links</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Lenkung</translation>
    </message>
    <message>
        <source>skid: by wheel speeds; ackermann: by steering joints alone; auto: both</source>
        <translation>skid: durch Raddrehzahlen; ackermann: allein durch Lenkgelenke; auto: beides</translation>
    </message>
    <message>
        <source>Heading hold</source>
        <translation>Richtung halten</translation>
    </message>
    <message>
        <source>Keeps the heading while no turn is asked</source>
        <translation>Hält die Richtung, solange keine Drehung verlangt ist</translation>
    </message>
    <message>
        <source>Assumed friction</source>
        <translation>Angenommene Reibung</translation>
    </message>
    <message>
        <source>Torques are capped at this times N R; 0 = no cap</source>
        <translation>Drehmomente sind auf das so Vielfache von N R begrenzt; 0 = unbegrenzt</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Gain P</source>
        <translation>P-Anteil</translation>
    </message>
    <message>
        <source>0 = derived from the rover</source>
        <translation>0 = aus dem Rover abgeleitet</translation>
    </message>
    <message>
        <source>Gain I</source>
        <translation>I-Anteil</translation>
    </message>
    <message>
        <source>Gain D</source>
        <translation>D-Anteil</translation>
    </message>
    <message>
        <source>Joint encoders [rad]</source>
        <translation>Gelenkgeber [rad]</translation>
    </message>
    <message>
        <source>Wheel rate [rad/s]</source>
        <translation>Raddrehzahl [rad/s]</translation>
    </message>
    <message>
        <source>Roll and pitch [rad]</source>
        <translation>Wanken und Nicken [rad]</translation>
    </message>
    <message>
        <source>Angular rate [rad/s]</source>
        <translation>Drehrate [rad/s]</translation>
    </message>
    <message>
        <source>Acceleration [m/s²]</source>
        <translation>Beschleunigung [m/s²]</translation>
    </message>
    <message>
        <source>Tactile force [N]</source>
        <translation>Kraft am Tastrad [N]</translation>
    </message>
    <message>
        <source>Tactile angle [rad]</source>
        <translation>Winkel am Tastrad [rad]</translation>
    </message>
    <message>
        <source>Body speed [m/s]</source>
        <translation>Fahrgeschwindigkeit [m/s]</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Standard deviation of one reading</source>
        <translation>Standardabweichung einer Messung</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Added to every reading</source>
        <translation>Wird zu jeder Messung addiert</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Age of what is reported</source>
        <translation>Alter des Gemeldeten</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Readings are multiples of it; 0 = continuous</source>
        <translation>Messwerte sind Vielfache davon; 0 = stufenlos</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Engine</translation>
    </message>
    <message>
        <source>ode: rows of constraints; reduced: free rates, faster</source>
        <translation>ode: Zeilen von Zwangsbedingungen; reduced: freie Geschwindigkeiten, schneller</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Travel that completes the run</source>
        <translation>Weg, mit dem die Fahrt am Ziel ist</translation>
    </message>
    <message>
        <source>Longest time</source>
        <translation>Längste Zeit</translation>
    </message>
    <message>
        <source>0 = from distance and speed</source>
        <translation>0 = aus Strecke und Geschwindigkeit</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Einschwingzeit</translation>
    </message>
    <message>
        <source>Ramp time</source>
        <translation>Anfahrzeit</translation>
    </message>
    <message>
        <source>Relaxed joints</source>
        <translation>Gelockerte Gelenke</translation>
    </message>
    <message>
        <source>Joints with the freedoms of the relaxed model</source>
        <translation>Gelenke mit den Freiheiten des gelockerten Modells</translation>
    </message>
    <message>
        <source>Body contacts</source>
        <translation>Körperkontakte</translation>
    </message>
    <message>
        <source>Chassis, forks and links touch the ground, not only wheels</source>
        <translation>Chassis, Gabeln und Lenker berühren den Boden, nicht nur Räder</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>References follow when you rename; {side} stands for left and right</source>
        <translation>Verweise folgen beim Umbenennen; {side} steht für left und right</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>A second one on the other side, y to -y</source>
        <translation>Ein zweites auf der anderen Seite, y wird -y</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>One end</source>
        <translation>Ein Ende</translation>
    </message>
    <message>
        <source>Other end</source>
        <translation>Anderes Ende</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Turn about y through its centre</source>
        <translation>Drehung um y durch die Mitte</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>#rrggbb, or a name: chassis, accent, link, link_dark, metal, solar, tyre, white</source>
        <translation>#rrggbb oder ein Name: chassis, accent, link, link_dark, metal, solar, tyre, white</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>lower</source>
        <extracomment>Case of a noun in the middle of a sentence: &quot;lower&quot;, or &quot;keep&quot; where nouns have capitals.</extracomment>
        <translation>keep</translation>
    </message>
</context>
<context>
    <name>simcore</name>
    <message>
        <source>&apos;{}&apos; cannot be used in expressions.</source>
        <translation>&apos;{}&apos; ist in Ausdrücken nicht verwendbar.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not steer it: without that joint the wheel would still hang on the chassis.</source>
        <translation>&apos;{}&apos; lenkt es nicht: Ohne dieses Gelenk hinge das Rad immer noch am Chassis.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no value: {}.</source>
        <translation>&apos;{}&apos; hat keinen Wert: {}.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a {}, but this is a {}</source>
        <translation>&apos;{}&apos; gibt {} an, verlangt ist {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a {}, but this is a {}.</source>
        <translation>&apos;{}&apos; gibt {} an, verlangt ist {}.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is missing.</source>
        <translation>&apos;{}&apos; fehlt.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no unit of length.</source>
        <translation>&apos;{}&apos; ist keine Längeneinheit.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a kind of mesh that is read.</source>
        <translation>&apos;{}&apos; ist keine Art von Netz, die gelesen wird.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a known key.</source>
        <translation>&apos;{}&apos; ist kein bekannter Schlüssel.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number.</source>
        <translation>&apos;{}&apos; ist keine Zahl.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a pin of its body.</source>
        <translation>&apos;{}&apos; ist kein Drehgelenk seines Körpers.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not followed by a number.</source>
        <translation>Auf &apos;{}&apos; folgt keine Zahl.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not known.</source>
        <translation>&apos;{}&apos; ist nicht bekannt.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not understood.</source>
        <translation>&apos;{}&apos; ist unverständlich.</translation>
    </message>
    <message>
        <source>(new)</source>
        <translation>(neu)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>(wR - v) / max(abs(wR), abs(v), 0.01 m/s): positive when the wheel spins.</source>
        <translation>(wR - v) / max(abs(wR), abs(v), 0.01 m/s): positiv, wenn das Rad durchdreht.</translation>
    </message>
    <message>
        <source>1 constraint is redundant</source>
        <translation>1 Bedingung redundant</translation>
    </message>
    <message>
        <source>1 freedom within it.</source>
        <translation>1 Freiheit in sich.</translation>
    </message>
    <message>
        <source>1 joint of the suspension turns</source>
        <translation>1 Gelenk der Aufhängung dreht sich</translation>
    </message>
    <message>
        <source>1 of its constraints repeats what its others already hold.</source>
        <translation>1 seiner Bedingungen wiederholt, was die anderen schon halten.</translation>
    </message>
    <message>
        <source>1 of the freedoms is idle: neither chassis nor wheels move.</source>
        <translation>1 der Freiheiten ist leer: Weder Chassis noch Räder bewegen sich.</translation>
    </message>
    <message>
        <source>A grey image of 16 bit is needed, at most {} pixels.</source>
        <translation>Nötig ist ein Graustufenbild mit 16 Bit und höchstens {} Bildpunkten.</translation>
    </message>
    <message>
        <source>A project has &quot;format&quot;: &quot;{}&quot;.</source>
        <translation>Ein Projekt hat &quot;format&quot;: &quot;{}&quot;.</translation>
    </message>
    <message>
        <source>Absolute rotation rate of the wheel, positive forward.</source>
        <translation>Absolute Drehgeschwindigkeit des Rades, vorwärts positiv.</translation>
    </message>
    <message>
        <source>Acceleration less gravity along the chassis&apos; x axis as last read.</source>
        <translation>Beschleunigung ohne Erdbeschleunigung entlang der x-Achse des Chassis, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Acceleration less gravity along the chassis&apos; y axis as last read.</source>
        <translation>Beschleunigung ohne Erdbeschleunigung entlang der y-Achse des Chassis, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Acceleration less gravity along the chassis&apos; z axis as last read.</source>
        <translation>Beschleunigung ohne Erdbeschleunigung entlang der z-Achse des Chassis, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Acceleration x (measured)</source>
        <translation>Beschleunigung x (gemessen)</translation>
    </message>
    <message>
        <source>Acceleration y (measured)</source>
        <translation>Beschleunigung y (gemessen)</translation>
    </message>
    <message>
        <source>Acceleration z (measured)</source>
        <translation>Beschleunigung z (gemessen)</translation>
    </message>
    <message>
        <source>Add a body first.</source>
        <translation>Zuerst einen Körper hinzufügen.</translation>
    </message>
    <message>
        <source>Add a joint with one free turn first.</source>
        <translation>Zuerst ein Gelenk mit einer freien Drehung hinzufügen.</translation>
    </message>
    <message>
        <source>Add at least a chassis.</source>
        <translation>Mindestens ein Chassis hinzufügen.</translation>
    </message>
    <message>
        <source>Add it.</source>
        <translation>Ergänzen.</translation>
    </message>
    <message>
        <source>Add joints with one free turn first.</source>
        <translation>Zuerst Gelenke mit einer freien Drehung hinzufügen.</translation>
    </message>
    <message>
        <source>Add wheels to drive it.</source>
        <translation>Zum Fahren Räder hinzufügen.</translation>
    </message>
    <message>
        <source>Add wheels.</source>
        <translation>Räder hinzufügen.</translation>
    </message>
    <message>
        <source>An ASCII grid begins with lines such as &apos;ncols 200&apos;.</source>
        <translation>Ein ASCII-Gitter beginnt mit Zeilen wie &apos;ncols 200&apos;.</translation>
    </message>
    <message>
        <source>An idle freedom cannot be held by a universal joint in place of a ball; it has to go first.</source>
        <translation>Eine leere Freiheit kann ein Kreuzgelenk anstelle eines Kugelgelenks nicht halten; sie muss zuerst weg.</translation>
    </message>
    <message>
        <source>Angle in the wheel plane from world up to the contact normal, positive when the obstacle is ahead; held while the wheel is in the air.</source>
        <translation>Winkel in der Radebene von der Senkrechten zur Kontaktnormalen, positiv bei einem Hindernis voraus; bleibt stehen, solange das Rad in der Luft ist.</translation>
    </message>
    <message>
        <source>Angular rate about the chassis&apos; x axis as last read.</source>
        <translation>Drehrate um die x-Achse des Chassis, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Angular rate about the chassis&apos; y axis as last read.</source>
        <translation>Drehrate um die y-Achse des Chassis, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Angular rate about the chassis&apos; z axis as last read.</source>
        <translation>Drehrate um die z-Achse des Chassis, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Angular rate x</source>
        <translation>Drehrate x</translation>
    </message>
    <message>
        <source>Angular rate x (measured)</source>
        <translation>Drehrate x (gemessen)</translation>
    </message>
    <message>
        <source>Angular rate y</source>
        <translation>Drehrate y</translation>
    </message>
    <message>
        <source>Angular rate y (measured)</source>
        <translation>Drehrate y (gemessen)</translation>
    </message>
    <message>
        <source>Angular rate z</source>
        <translation>Drehrate z</translation>
    </message>
    <message>
        <source>Angular rate z (measured)</source>
        <translation>Drehrate z (gemessen)</translation>
    </message>
    <message>
        <source>Angular velocity of the chassis about its own x axis.</source>
        <translation>Winkelgeschwindigkeit des Chassis um die eigene x-Achse.</translation>
    </message>
    <message>
        <source>Angular velocity of the chassis about its own y axis.</source>
        <translation>Winkelgeschwindigkeit des Chassis um die eigene y-Achse.</translation>
    </message>
    <message>
        <source>Angular velocity of the chassis about its own z axis.</source>
        <translation>Winkelgeschwindigkeit des Chassis um die eigene z-Achse.</translation>
    </message>
    <message>
        <source>Another run may be writing it; else rename or remove it.</source>
        <translation>Vielleicht schreibt sie eine andere Fahrt; sonst umbenennen oder entfernen.</translation>
    </message>
    <message>
        <source>Applied torque times the wheel&apos;s rate against its carrier, negative when the motor brakes.</source>
        <translation>Gestelltes Drehmoment mal Drehzahl des Rades gegen seinen Träger, negativ beim Bremsen des Motors.</translation>
    </message>
    <message>
        <source>As built, a free motion of the drawn pose does not go on: it only yields. What follows keeps that motion, too.</source>
        <translation>Wie gebaut geht eine freie Bewegung der gezeichneten Stellung nicht weiter: Sie gibt nur nach. Was folgt, behält auch diese Bewegung.</translation>
    </message>
    <message>
        <source>As built, {} and 1 freedom is idle.</source>
        <translation>Wie gebaut: {} und 1 Freiheit leer.</translation>
    </message>
    <message>
        <source>As built, {} and {} freedoms are idle.</source>
        <translation>Wie gebaut: {} und {} Freiheiten leer.</translation>
    </message>
    <message>
        <source>As built, {}.</source>
        <translation>Wie gebaut: {}.</translation>
    </message>
    <message>
        <source>Ask for advice again.</source>
        <translation>Erneut um Rat fragen.</translation>
    </message>
    <message>
        <source>Ask the Advisor in Mobility what to free.</source>
        <translation>Im Laufgrad den Ratgeber fragen, was zu lösen ist.</translation>
    </message>
    <message>
        <source>Body speed as the controller last read it.</source>
        <translation>Fahrgeschwindigkeit, wie der Regler sie zuletzt gelesen hat.</translation>
    </message>
    <message>
        <source>Break the circle: give one a number.</source>
        <translation>Den Kreis auflösen: einem davon eine Zahl geben.</translation>
    </message>
    <message>
        <source>Cannot move</source>
        <translation>Unbeweglich</translation>
    </message>
    <message>
        <source>Cannot move: the constraints hold every body.</source>
        <translation>Unbeweglich: Die Zwangsbedingungen halten jeden Körper.</translation>
    </message>
    <message>
        <source>Centre of mass near the edge of its feet</source>
        <translation>Schwerpunkt nahe am Rand der Aufstandsfläche</translation>
    </message>
    <message>
        <source>Centre of mass x</source>
        <translation>Schwerpunkt x</translation>
    </message>
    <message>
        <source>Centre of mass y</source>
        <translation>Schwerpunkt y</translation>
    </message>
    <message>
        <source>Centre of mass z</source>
        <translation>Schwerpunkt z</translation>
    </message>
    <message>
        <source>Change the value, or the range if it is too narrow.</source>
        <translation>Den Wert ändern, oder den Bereich, wenn er zu eng ist.</translation>
    </message>
    <message>
        <source>Check it in a mesh editor, simplify it, or write it in another format.</source>
        <translation>In einem Netzeditor prüfen, vereinfachen oder in einem anderen Format schreiben.</translation>
    </message>
    <message>
        <source>Check its inertia, or leave it away to have that of its shapes.</source>
        <translation>Die Trägheit prüfen, oder weglassen: Dann gilt die der Formen.</translation>
    </message>
    <message>
        <source>Check its inertia: kg m^2, about its own centre of mass.</source>
        <translation>Die Trägheit prüfen: kg m^2, um den eigenen Schwerpunkt.</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Ihre Rechte prüfen.</translation>
    </message>
    <message>
        <source>Check that the file is still there.</source>
        <translation>Prüfen, ob die Datei noch da ist.</translation>
    </message>
    <message>
        <source>Check that the folder exists and can be written, and that the name ends in .png.</source>
        <translation>Prüfen, ob der Ordner vorhanden und beschreibbar ist und der Name auf .png endet.</translation>
    </message>
    <message>
        <source>Check that the folder exists and can be written.</source>
        <translation>Prüfen, ob der Ordner vorhanden und beschreibbar ist.</translation>
    </message>
    <message>
        <source>Check the file and its units, scale and origin.</source>
        <translation>Die Datei, ihre Einheit, Maßstab und Ursprung prüfen.</translation>
    </message>
    <message>
        <source>Check the file and its value for &apos;no data&apos;.</source>
        <translation>Die Datei und ihren Wert für &apos;keine Daten&apos; prüfen.</translation>
    </message>
    <message>
        <source>Check the file, its units and scale.</source>
        <translation>Die Datei, ihre Einheit und Maßstab prüfen.</translation>
    </message>
    <message>
        <source>Check the file, its units, scale and origin: {} m apart at least, {} m away at most.</source>
        <translation>Die Datei, ihre Einheit, Maßstab und Ursprung prüfen: mindestens {} m Abstand, höchstens {} m entfernt.</translation>
    </message>
    <message>
        <source>Check the file; obj, stl and ply are the safest formats.</source>
        <translation>Die Datei prüfen; am sichersten sind die Formate obj, stl und ply.</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space.</source>
        <translation>Ordner, Rechte und freien Platz prüfen.</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space; the old file is untouched.</source>
        <translation>Ordner, Rechte und freien Platz prüfen; die alte Datei ist unberührt.</translation>
    </message>
    <message>
        <source>Check the free space of the disk.</source>
        <translation>Den freien Platz auf dem Datenträger prüfen.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Den Pfad prüfen.</translation>
    </message>
    <message>
        <source>Check the rover&apos;s joints and wheels.</source>
        <translation>Gelenke und Räder des Rovers prüfen.</translation>
    </message>
    <message>
        <source>Check the rover&apos;s masses, joints and wheels.</source>
        <translation>Massen, Gelenke und Räder des Rovers prüfen.</translation>
    </message>
    <message>
        <source>Check the spelling against the rover&apos;s parameters.</source>
        <translation>Die Schreibweise mit den Parametern des Rovers vergleichen.</translation>
    </message>
    <message>
        <source>Check the up axis, or turn the normals in the file.</source>
        <translation>Die Hochachse prüfen, oder die Normalen in der Datei umdrehen.</translation>
    </message>
    <message>
        <source>Choose --cell for 2 x 2 to {} points.</source>
        <translation>--cell so wählen, dass es 2 x 2 bis {} Punkte sind.</translation>
    </message>
    <message>
        <source>Choose a .roverrec file.</source>
        <translation>Eine .roverrec-Datei wählen.</translation>
    </message>
    <message>
        <source>Choose a body.</source>
        <translation>Einen Körper wählen.</translation>
    </message>
    <message>
        <source>Choose another folder, or free space.</source>
        <translation>Einen anderen Ordner wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Choose another parameter, or replace the expression.</source>
        <translation>Einen anderen Parameter wählen oder den Ausdruck ersetzen.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Einen anderen Platz wählen.</translation>
    </message>
    <message>
        <source>Choose larger cells or a shorter way: at most {} points.</source>
        <translation>Größere Zellen oder einen kürzeren Weg wählen: höchstens {} Punkte.</translation>
    </message>
    <message>
        <source>Choose one that is mirrored.</source>
        <translation>Ein gespiegeltes Teil wählen.</translation>
    </message>
    <message>
        <source>Choose the parameter to change, or replace the expression.</source>
        <translation>Den zu ändernden Parameter wählen oder den Ausdruck ersetzen.</translation>
    </message>
    <message>
        <source>Choose times between the start and the end of the run.</source>
        <translation>Zeiten zwischen Anfang und Ende der Fahrt wählen.</translation>
    </message>
    <message>
        <source>Clean the mesh if it looks wrong.</source>
        <translation>Das Netz bereinigen, wenn es falsch aussieht.</translation>
    </message>
    <message>
        <source>Close other programs if there is no memory left.</source>
        <translation>Andere Programme schließen, wenn der Speicher nicht reicht.</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>Andere Programme schließen.</translation>
    </message>
    <message>
        <source>Connect pins of the same carrier.</source>
        <translation>Drehgelenke desselben Trägers verbinden.</translation>
    </message>
    <message>
        <source>Contact angle</source>
        <translation>Kontaktwinkel</translation>
    </message>
    <message>
        <source>Contact angle (measured)</source>
        <translation>Kontaktwinkel (gemessen)</translation>
    </message>
    <message>
        <source>Contact angle of the tactile wheel as last read.</source>
        <translation>Kontaktwinkel des Tastrades, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Contact force x</source>
        <translation>Kontaktkraft x</translation>
    </message>
    <message>
        <source>Contact force y</source>
        <translation>Kontaktkraft y</translation>
    </message>
    <message>
        <source>Contact force z</source>
        <translation>Kontaktkraft z</translation>
    </message>
    <message>
        <source>Copy parts in RoverStudio first.</source>
        <translation>Zuerst in RoverStudio Teile kopieren.</translation>
    </message>
    <message>
        <source>Copy some parts first.</source>
        <translation>Zuerst Teile kopieren.</translation>
    </message>
    <message>
        <source>Copy them with this version of RoverStudio.</source>
        <translation>Mit dieser Version von RoverStudio kopieren.</translation>
    </message>
    <message>
        <source>Correct it; values are in SI unless a unit is written.</source>
        <translation>Berichtigen; ohne Einheit gelten Werte in SI.</translation>
    </message>
    <message>
        <source>Correct ncols or nrows.</source>
        <translation>ncols oder nrows berichtigen.</translation>
    </message>
    <message>
        <source>Correct the file.</source>
        <translation>Die Datei berichtigen.</translation>
    </message>
    <message>
        <source>Correct the file; a project needs about ten.</source>
        <translation>Die Datei berichtigen; ein Projekt braucht etwa zehn.</translation>
    </message>
    <message>
        <source>Correct the file; it may have been cut off.</source>
        <translation>Die Datei berichtigen; vielleicht ist sie abgeschnitten.</translation>
    </message>
    <message>
        <source>Correct the header.</source>
        <translation>Den Kopf berichtigen.</translation>
    </message>
    <message>
        <source>Correct the inertia, or remove it to use that of the shapes.</source>
        <translation>Die Trägheit berichtigen, oder entfernen: Dann gilt die der Formen.</translation>
    </message>
    <message>
        <source>Correct the text there; a comma or a quote is often missing just before.</source>
        <translation>Den Text dort berichtigen; oft fehlt kurz davor ein Komma oder Anführungszeichen.</translation>
    </message>
    <message>
        <source>Correct the value.</source>
        <translation>Den Wert berichtigen.</translation>
    </message>
    <message>
        <source>Correct them.</source>
        <translation>Berichtigen.</translation>
    </message>
    <message>
        <source>Cut or simplify it.</source>
        <translation>Beschneiden oder vereinfachen.</translation>
    </message>
    <message>
        <source>Cut or simplify them, or run without recording.</source>
        <translation>Beschneiden, vereinfachen oder ohne Aufzeichnung fahren.</translation>
    </message>
    <message>
        <source>Cut out the part that is driven on, or resample it.</source>
        <translation>Den befahrenen Teil ausschneiden oder gröber abtasten.</translation>
    </message>
    <message>
        <source>Delete or rename that first.</source>
        <translation>Das zuerst löschen oder umbenennen.</translation>
    </message>
    <message>
        <source>Delete those first, or make them use something else.</source>
        <translation>Diese zuerst löschen oder etwas anderes verwenden lassen.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Draw a shape, or give its inertia.</source>
        <translation>Eine Form zeichnen oder die Trägheit angeben.</translation>
    </message>
    <message>
        <source>EGL offers no configuration for OpenGL.</source>
        <translation>EGL bietet keine Konfiguration für OpenGL.</translation>
    </message>
    <message>
        <source>EGL&apos;s surfaceless platform is not available.</source>
        <translation>Die oberflächenlose Plattform von EGL ist nicht verfügbar.</translation>
    </message>
    <message>
        <source>Energy that friction took where the wheel slid since counting began.</source>
        <translation>Energie, die die Reibung am gleitenden Rad seit Beginn der Zählung aufnahm.</translation>
    </message>
    <message>
        <source>Every reaction follows from the loads.</source>
        <translation>Jede Reaktion folgt aus den Lasten.</translation>
    </message>
    <message>
        <source>Exact as built: nothing is redundant and nothing idle. No joint needs to change.</source>
        <translation>Wie gebaut exakt: Nichts ist redundant und nichts leer. Kein Gelenk muss sich ändern.</translation>
    </message>
    <message>
        <source>Force of the ground on the wheel along the axle, positive to the left.</source>
        <translation>Kraft des Bodens auf das Rad entlang der Achse, nach links positiv.</translation>
    </message>
    <message>
        <source>Force of the ground on the wheel along the contact normal.</source>
        <translation>Kraft des Bodens auf das Rad entlang der Kontaktnormalen.</translation>
    </message>
    <message>
        <source>Force of the ground on the wheel along the rolling direction, positive forward.</source>
        <translation>Kraft des Bodens auf das Rad entlang der Rollrichtung, vorwärts positiv.</translation>
    </message>
    <message>
        <source>Found one set of joints that makes it exact and leaves its motion as it is.</source>
        <translation>Gefunden ist ein Satz von Gelenken, mit dem er exakt wird und sich bewegt wie zuvor.</translation>
    </message>
    <message>
        <source>Found {} sets of joints that make it exact and leave its motion as it is.</source>
        <translation>Gefunden sind {} Sätze von Gelenken, mit denen er exakt wird und sich bewegt wie zuvor.</translation>
    </message>
    <message>
        <source>Free memory or processes, or use fewer jobs.</source>
        <translation>Speicher oder Prozesse freigeben oder weniger zugleich rechnen.</translation>
    </message>
    <message>
        <source>Free some space in {} and run again.</source>
        <translation>In {} Platz schaffen und erneut fahren.</translation>
    </message>
    <message>
        <source>Free some space on the disk and run again.</source>
        <translation>Auf dem Datenträger Platz schaffen und erneut fahren.</translation>
    </message>
    <message>
        <source>Free some space or choose another folder. What was recorded is in {}.</source>
        <translation>Platz schaffen oder einen anderen Ordner wählen. Das Aufgezeichnete liegt in {}.</translation>
    </message>
    <message>
        <source>Friction that the controller trusts the ground with: assumed, or learned from slip; missing where it sets no such limit.</source>
        <translation>Reibung, die der Regler dem Boden zutraut: angenommen oder aus dem Schlupf gelernt; fehlt, wo er keine solche Grenze setzt.</translation>
    </message>
    <message>
        <source>Friction trusted</source>
        <translation>Reibung, auf die gebaut wird</translation>
    </message>
    <message>
        <source>Friction work</source>
        <translation>Reibarbeit</translation>
    </message>
    <message>
        <source>Give 0 &lt;= low &lt; high and a tolerance above zero.</source>
        <translation>0 &lt;= unten &lt; oben und eine Toleranz über null angeben.</translation>
    </message>
    <message>
        <source>Give 0 to 200.</source>
        <translation>0 bis 200 angeben.</translation>
    </message>
    <message>
        <source>Give 1 to {}.</source>
        <translation>1 bis {} angeben.</translation>
    </message>
    <message>
        <source>Give A..B with 0 &lt;= A &lt;= B, at most {} of them.</source>
        <translation>A..B mit 0 &lt;= A &lt;= B angeben, höchstens {} davon.</translation>
    </message>
    <message>
        <source>Give a direction, e.g. [0, 1, 0].</source>
        <translation>Eine Richtung angeben, z. B. [0, 1, 0].</translation>
    </message>
    <message>
        <source>Give a joint of the loop another freedom, or free a body.</source>
        <translation>Einem Gelenk der Schleife eine weitere Freiheit geben oder einen Körper lösen.</translation>
    </message>
    <message>
        <source>Give a number.</source>
        <translation>Eine Zahl angeben.</translation>
    </message>
    <message>
        <source>Give a value above zero.</source>
        <translation>Einen Wert über null angeben.</translation>
    </message>
    <message>
        <source>Give an angle from -90 to 90 degrees; 90 is a wall ahead.</source>
        <translation>Einen Winkel von -90 bis 90 Grad angeben; 90 ist eine Wand voraus.</translation>
    </message>
    <message>
        <source>Give another folder, or delete it to begin anew.</source>
        <translation>Einen anderen Ordner angeben, oder sie löschen, um neu anzufangen.</translation>
    </message>
    <message>
        <source>Give coefficients such as 0.3,0.5,0.7.</source>
        <translation>Reibungszahlen wie 0.3,0.5,0.7 angeben.</translation>
    </message>
    <message>
        <source>Give each wheel its own body.</source>
        <translation>Jedem Rad einen eigenen Körper geben.</translation>
    </message>
    <message>
        <source>Give every body its own name.</source>
        <translation>Jedem Körper einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>Give every joint its own name.</source>
        <translation>Jedem Gelenk einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>Give every {} its own name.</source>
        <translation>Jeden Namen nur einmal vergeben ({}).</translation>
    </message>
    <message>
        <source>Give exactly that many, in square brackets.</source>
        <translation>Genau so viele angeben, in eckigen Klammern.</translation>
    </message>
    <message>
        <source>Give it an axis along z, or within 45 deg of it.</source>
        <translation>Eine Achse entlang z geben, oder höchstens 45 Grad davon.</translation>
    </message>
    <message>
        <source>Give it the mass of the real part, or weld it to its neighbour.</source>
        <translation>Die Masse des wirklichen Teils angeben oder mit dem Nachbarn verschweißen.</translation>
    </message>
    <message>
        <source>Give it wheels with motors.</source>
        <translation>Räder mit Motoren hinzufügen.</translation>
    </message>
    <message>
        <source>Give it wheels.</source>
        <translation>Räder hinzufügen.</translation>
    </message>
    <message>
        <source>Give joints the freedoms it lacks.</source>
        <translation>Gelenken die fehlenden Freiheiten geben.</translation>
    </message>
    <message>
        <source>Give the lower one first, below zero, and the upper one above.</source>
        <translation>Zuerst den unteren angeben, unter null, dann den oberen, darüber.</translation>
    </message>
    <message>
        <source>Give the path of a file, relative to the project&apos;s folder or absolute.</source>
        <translation>Den Pfad einer Datei angeben, relativ zum Ordner des Projekts oder absolut.</translation>
    </message>
    <message>
        <source>Give the ratio of the turns.</source>
        <translation>Das Verhältnis der Drehungen angeben.</translation>
    </message>
    <message>
        <source>Give two or more to compare; not manual.</source>
        <translation>Zwei oder mehr zum Vergleichen angeben; nicht manual.</translation>
    </message>
    <message>
        <source>Give zero or more.</source>
        <translation>Null oder mehr angeben.</translation>
    </message>
    <message>
        <source>Go on with what is there, or take another copy.</source>
        <translation>Mit dem Vorhandenen weitermachen oder eine andere Kopie nehmen.</translation>
    </message>
    <message>
        <source>Hold them by another type of joint, or leave them if nothing can jam.</source>
        <translation>Mit einem anderen Gelenktyp halten, oder lassen, wenn nichts klemmen kann.</translation>
    </message>
    <message>
        <source>How far the wheel&apos;s deepest contact lies in the ground; 0 without contact.</source>
        <translation>Wie tief der tiefste Kontakt des Rades im Boden liegt; 0 ohne Kontakt.</translation>
    </message>
    <message>
        <source>Hyperstatic: 1 constraint repeats what others already hold. Its reaction cannot be told from statics, and inaccurate parts strain each other.</source>
        <translation>Überbestimmt: 1 Bedingung wiederholt, was andere schon halten. Ihre Reaktion folgt nicht aus der Statik, und ungenaue Teile verspannen einander.</translation>
    </message>
    <message>
        <source>Hyperstatic: {} constraints repeat what others already hold. Their reactions cannot be told from statics, and inaccurate parts strain each other.</source>
        <translation>Überbestimmt: {} Bedingungen wiederholen, was andere schon halten. Ihre Reaktionen folgen nicht aus der Statik, und ungenaue Teile verspannen einander.</translation>
    </message>
    <message>
        <source>Idle freedoms</source>
        <translation>Leere Freiheiten</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Install an OpenGL driver with EGL, e.g. Mesa&apos;s software renderer.</source>
        <translation>Einen OpenGL-Treiber mit EGL installieren, z. B. den Software-Renderer von Mesa.</translation>
    </message>
    <message>
        <source>Join it, or remove it.</source>
        <translation>Verbinden oder entfernen.</translation>
    </message>
    <message>
        <source>Joint angle</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>Joint angle (measured)</source>
        <translation>Gelenkwinkel (gemessen)</translation>
    </message>
    <message>
        <source>Joint rate</source>
        <translation>Gelenkdrehzahl</translation>
    </message>
    <message>
        <source>Known here: {}.</source>
        <translation>Hier bekannt: {}.</translation>
    </message>
    <message>
        <source>Known: {}.</source>
        <translation>Bekannt: {}.</translation>
    </message>
    <message>
        <source>Largest ratio of tangential to normal force with the planned torques, by the controller&apos;s quasi-static model; missing where it has none.</source>
        <translation>Größtes Verhältnis von Tangential- zu Normalkraft mit den geplanten Drehmomenten, nach dem quasistatischen Modell des Reglers; fehlt, wo er keines hat.</translation>
    </message>
    <message>
        <source>Lateral force</source>
        <translation>Seitenkraft</translation>
    </message>
    <message>
        <source>Leave it one free direction, &apos;turn axis&apos;.</source>
        <translation>Eine freie Richtung lassen: &apos;turn axis&apos;.</translation>
    </message>
    <message>
        <source>Leave one that is not mirrored in the first place.</source>
        <translation>An erster Stelle einen lassen, der nicht gespiegelt ist.</translation>
    </message>
    <message>
        <source>Let roversim reproduce start its workers.</source>
        <translation>Die Arbeiter von roversim reproduce starten lassen.</translation>
    </message>
    <message>
        <source>Let the wheel go; fix the chassis for a test stand.</source>
        <translation>Das Rad lösen; für einen Prüfstand das Chassis festhalten.</translation>
    </message>
    <message>
        <source>List the terrains of the inner sum; use a mesh alone.</source>
        <translation>Das Gelände der inneren Summe aufzählen; ein Netz allein verwenden.</translation>
    </message>
    <message>
        <source>Load that those torques make by the same model.</source>
        <translation>Last, die diese Drehmomente nach demselben Modell bewirken.</translation>
    </message>
    <message>
        <source>Lower the obstacle, change the suspension, or raise the friction.</source>
        <translation>Das Hindernis verkleinern, die Aufhängung ändern oder die Reibung erhöhen.</translation>
    </message>
    <message>
        <source>Lower the slope or raise the friction.</source>
        <translation>Die Neigung verringern oder die Reibung erhöhen.</translation>
    </message>
    <message>
        <source>Main dimensions: {}.</source>
        <translation>Hauptmaße: {}.</translation>
    </message>
    <message>
        <source>Make the chassis the first body.</source>
        <translation>Das Chassis zum ersten Körper machen.</translation>
    </message>
    <message>
        <source>Mass ratio</source>
        <translation>Massenverhältnis</translation>
    </message>
    <message>
        <source>Mirror bodies, joints, wheels, springs and payloads.</source>
        <translation>Spiegeln lassen sich Körper, Gelenke, Räder, Federn und Nutzlasten.</translation>
    </message>
    <message>
        <source>Mirror it, or relax both sides.</source>
        <translation>Spiegeln oder beide Seiten lockern.</translation>
    </message>
    <message>
        <source>Mirror the body.</source>
        <translation>Den Körper spiegeln.</translation>
    </message>
    <message>
        <source>Motor torque after the motor&apos;s torque and speed limits.</source>
        <translation>Motormoment nach den Grenzen des Motors für Moment und Drehzahl.</translation>
    </message>
    <message>
        <source>Motor torque the controller asked for, positive drives forward.</source>
        <translation>Motormoment, das der Regler verlangt hat, vorwärts positiv.</translation>
    </message>
    <message>
        <source>Move another body to the second place first.</source>
        <translation>Zuerst einen anderen Körper an die zweite Stelle schieben.</translation>
    </message>
    <message>
        <source>Move mass or wheels.</source>
        <translation>Masse oder Räder versetzen.</translation>
    </message>
    <message>
        <source>Move one end.</source>
        <translation>Ein Ende versetzen.</translation>
    </message>
    <message>
        <source>Move one of them, or make them smaller.</source>
        <translation>Eines davon versetzen oder beide verkleinern.</translation>
    </message>
    <message>
        <source>Move one of them.</source>
        <translation>Eines davon versetzen.</translation>
    </message>
    <message>
        <source>Move shapes alone into another body.</source>
        <translation>Nur Formen in einen anderen Körper verschieben.</translation>
    </message>
    <message>
        <source>Move the terrain&apos;s origin, so that the rover starts on it.</source>
        <translation>Den Ursprung des Geländes so versetzen, dass der Rover darauf startet.</translation>
    </message>
    <message>
        <source>Moves with one freedom, as a rover on its wheels should.</source>
        <translation>Bewegt sich mit einer Freiheit, wie es sich für einen Rover auf Rädern gehört.</translation>
    </message>
    <message>
        <source>Moves with {} freedoms.</source>
        <translation>Bewegt sich mit {} Freiheiten.</translation>
    </message>
    <message>
        <source>Name one of the project&apos;s variants, or none.</source>
        <translation>Eine der Varianten des Projekts nennen, oder keine.</translation>
    </message>
    <message>
        <source>Name the pin between the wheel&apos;s carrier and the rest of the rover.</source>
        <translation>Das Drehgelenk zwischen dem Träger des Rades und dem übrigen Rover nennen.</translation>
    </message>
    <message>
        <source>Name the pin joint between the wheel&apos;s body and its carrier.</source>
        <translation>Das Drehgelenk zwischen dem Körper des Rades und seinem Träger nennen.</translation>
    </message>
    <message>
        <source>Name two bodies.</source>
        <translation>Zwei Körper nennen.</translation>
    </message>
    <message>
        <source>Name two pin joints.</source>
        <translation>Zwei Drehgelenke nennen.</translation>
    </message>
    <message>
        <source>No OpenGL context could be made.</source>
        <translation>Es war kein OpenGL-Kontext zu bekommen.</translation>
    </message>
    <message>
        <source>No free motion can be continued: it yields in this pose, but some constraints are inconsistent after any finite step.</source>
        <translation>Keine freie Bewegung geht weiter: Sie gibt in dieser Stellung nur nach, nach jedem endlichen Schritt widersprechen sich Bedingungen.</translation>
    </message>
    <message>
        <source>No set of permitted joints makes it exact and leaves its motion as it is.</source>
        <translation>Kein Satz erlaubter Gelenke macht ihn exakt und lässt seine Bewegung, wie sie ist.</translation>
    </message>
    <message>
        <source>No set that changes both sides alike is exact, so each of these changes something on one side only.</source>
        <translation>Kein Satz, der beide Seiten gleich ändert, ist exakt; jeder von diesen ändert darum etwas nur an einer Seite.</translation>
    </message>
    <message>
        <source>None that was left out costs less than the last one.</source>
        <translation>Keiner, der fehlt, kostet weniger als der letzte.</translation>
    </message>
    <message>
        <source>None was found until then.</source>
        <translation>Bis dahin ist keiner gefunden.</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>Normal force (measured)</source>
        <translation>Normalkraft (gemessen)</translation>
    </message>
    <message>
        <source>Normal force (planned)</source>
        <translation>Normalkraft (geplant)</translation>
    </message>
    <message>
        <source>Normal force of the tactile wheel as last read.</source>
        <translation>Normalkraft des Tastrades, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Nothing can be known of {}.</source>
        <translation>Nichts ist bekannt von {}.</translation>
    </message>
    <message>
        <source>Nothing in it is redundant.</source>
        <translation>Nichts darin ist redundant.</translation>
    </message>
    <message>
        <source>Of {} components of reactions the loads determine {}; the others depend on play, stiffness and errors of manufacture.</source>
        <translation>Von {} Komponenten der Reaktionen bestimmen die Lasten {}; die anderen hängen von Spiel, Steifigkeit und Fertigungsfehlern ab.</translation>
    </message>
    <message>
        <source>Only {} free motions can be continued: it yields in this pose, but some constraints are inconsistent after any finite step.</source>
        <translation>Nur {} freie Bewegungen gehen weiter: Sonst gibt er in dieser Stellung nur nach, nach jedem endlichen Schritt widersprechen sich Bedingungen.</translation>
    </message>
    <message>
        <source>Open it with the RoverStudio version that wrote it, or take another copy.</source>
        <translation>Mit der Version von RoverStudio öffnen, die sie geschrieben hat, oder eine andere Kopie nehmen.</translation>
    </message>
    <message>
        <source>Open it with the RoverStudio version that wrote it.</source>
        <translation>Mit der Version von RoverStudio öffnen, die sie geschrieben hat.</translation>
    </message>
    <message>
        <source>Part of the reaction can be known of {}.</source>
        <translation>Ein Teil der Reaktion ist bekannt von {}.</translation>
    </message>
    <message>
        <source>Penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Pitch (measured)</source>
        <translation>Nicken (gemessen)</translation>
    </message>
    <message>
        <source>Pitch of the inertial unit as last read.</source>
        <translation>Nicken laut Inertialsensor, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>Position x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Position y</translation>
    </message>
    <message>
        <source>Position z</source>
        <translation>Position z</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Put its axle at the height of its radius.</source>
        <translation>Die Achse auf die Höhe des Radius setzen.</translation>
    </message>
    <message>
        <source>Put its axle one radius above the ground.</source>
        <translation>Die Achse einen Radius über den Boden setzen.</translation>
    </message>
    <message>
        <source>Rate of that turn.</source>
        <translation>Geschwindigkeit dieser Drehung.</translation>
    </message>
    <message>
        <source>Rate of the wheel against its carrier as the controller last read it.</source>
        <translation>Drehzahl des Rades gegen seinen Träger, wie der Regler sie zuletzt gelesen hat.</translation>
    </message>
    <message>
        <source>Rate of the wheel that the controller aims at.</source>
        <translation>Drehzahl des Rades, die der Regler anstrebt.</translation>
    </message>
    <message>
        <source>Record at least 2.56 s, or let the run end.</source>
        <translation>Mindestens 2.56 s aufzeichnen oder die Fahrt zu Ende gehen lassen.</translation>
    </message>
    <message>
        <source>Redundant constraints</source>
        <translation>Redundante Bedingungen</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Eines davon entfernen.</translation>
    </message>
    <message>
        <source>Remove one, or turn it.</source>
        <translation>Eine entfernen oder drehen.</translation>
    </message>
    <message>
        <source>Remove the joint, or let one of the bodies go.</source>
        <translation>Das Gelenk entfernen oder einen der Körper lösen.</translation>
    </message>
    <message>
        <source>Remove the joint, or unlock the other one.</source>
        <translation>Das Gelenk entfernen oder das andere entsperren.</translation>
    </message>
    <message>
        <source>Rename it.</source>
        <translation>Umbenennen.</translation>
    </message>
    <message>
        <source>Rename its body.</source>
        <translation>Seinen Körper umbenennen.</translation>
    </message>
    <message>
        <source>Rename one of them.</source>
        <translation>Eines davon umbenennen.</translation>
    </message>
    <message>
        <source>Required friction (planned)</source>
        <translation>Nötige Reibung (geplant)</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Wanken</translation>
    </message>
    <message>
        <source>Roll (measured)</source>
        <translation>Wanken (gemessen)</translation>
    </message>
    <message>
        <source>Roll of the inertial unit as last read.</source>
        <translation>Wanken laut Inertialsensor, wie zuletzt gelesen.</translation>
    </message>
    <message>
        <source>Run a scenario first.</source>
        <translation>Zuerst ein Szenario fahren.</translation>
    </message>
    <message>
        <source>Search higher, or make it easier.</source>
        <translation>Weiter oben suchen oder es leichter machen.</translation>
    </message>
    <message>
        <source>Search lower.</source>
        <translation>Weiter unten suchen.</translation>
    </message>
    <message>
        <source>Select the body that it belongs to first.</source>
        <translation>Zuerst den Körper auswählen, zu dem sie gehört.</translation>
    </message>
    <message>
        <source>Select the body to put it in first.</source>
        <translation>Zuerst den Körper auswählen, in den sie kommt.</translation>
    </message>
    <message>
        <source>Set it within its range.</source>
        <translation>Innerhalb des Bereichs setzen.</translation>
    </message>
    <message>
        <source>Set the parameters it is made of.</source>
        <translation>Die Parameter setzen, aus denen er sich ergibt.</translation>
    </message>
    <message>
        <source>Shorten the run&apos;s distance.</source>
        <translation>Die Strecke der Fahrt verkürzen.</translation>
    </message>
    <message>
        <source>Simplify the project, or run without recording.</source>
        <translation>Das Projekt vereinfachen oder ohne Aufzeichnung fahren.</translation>
    </message>
    <message>
        <source>Simulated time since the start of the run.</source>
        <translation>Simulierte Zeit seit Beginn der Fahrt.</translation>
    </message>
    <message>
        <source>Slip (absolute)</source>
        <translation>Schlupf (absolut)</translation>
    </message>
    <message>
        <source>Slip (lateral)</source>
        <translation>Schlupf (seitlich)</translation>
    </message>
    <message>
        <source>Slip (loaded)</source>
        <translation>Schlupf (unter Last)</translation>
    </message>
    <message>
        <source>Slip (signed)</source>
        <translation>Schlupf (mit Vorzeichen)</translation>
    </message>
    <message>
        <source>Slip ratio</source>
        <translation>Schlupfverhältnis</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed (measured)</source>
        <translation>Geschwindigkeit (gemessen)</translation>
    </message>
    <message>
        <source>Speed of the chassis origin along the chassis&apos; forward axis.</source>
        <translation>Geschwindigkeit des Chassis-Ursprungs entlang der Vorwärtsachse des Chassis.</translation>
    </message>
    <message>
        <source>Speed of the wheel centre along the contact tangent.</source>
        <translation>Geschwindigkeit der Radmitte entlang der Kontakttangente.</translation>
    </message>
    <message>
        <source>Split that first.</source>
        <translation>Das zuerst trennen.</translation>
    </message>
    <message>
        <source>Start the terrain&apos;s first feature further ahead, or raise the wheel.</source>
        <translation>Das erste Hindernis des Geländes weiter voraus beginnen lassen oder das Rad anheben.</translation>
    </message>
    <message>
        <source>Start the terrain&apos;s first feature further ahead, raise the body&apos;s shapes, or set the run&apos;s body_contacts to false.</source>
        <translation>Das erste Hindernis des Geländes weiter voraus beginnen lassen, die Formen des Körpers anheben oder body_contacts der Fahrt auf false setzen.</translation>
    </message>
    <message>
        <source>Statically determinate: every reaction follows from the loads.</source>
        <translation>Statisch bestimmt: Jede Reaktion folgt aus den Lasten.</translation>
    </message>
    <message>
        <source>Step of {:.3g} ms</source>
        <translation>Zeitschritt {:.3g} ms</translation>
    </message>
    <message>
        <source>Step too large for the speed</source>
        <translation>Zeitschritt zu groß für die Geschwindigkeit</translation>
    </message>
    <message>
        <source>Sum of the absolute motion of the wheel centre along the axle since counting began.</source>
        <translation>Summe der Beträge der Bewegung der Radmitte entlang der Achse seit Beginn der Zählung.</translation>
    </message>
    <message>
        <source>Sum of the absolute slip of consecutive 20 ms windows since counting began.</source>
        <translation>Summe der Beträge des Schlupfs aufeinanderfolgender Fenster von 20 ms seit Beginn der Zählung.</translation>
    </message>
    <message>
        <source>Sum of wheel-centre travel minus turn times effective radius; negative when the wheel spins.</source>
        <translation>Summe aus Weg der Radmitte minus Drehung mal wirksamem Radius; negativ, wenn das Rad durchdreht.</translation>
    </message>
    <message>
        <source>Swap or correct them.</source>
        <translation>Vertauschen oder berichtigen.</translation>
    </message>
    <message>
        <source>Take a smaller step or a lower speed.</source>
        <translation>Einen kleineren Zeitschritt oder eine geringere Geschwindigkeit wählen.</translation>
    </message>
    <message>
        <source>Take another copy of the file if there is one.</source>
        <translation>Eine andere Kopie der Datei nehmen, wenn es eine gibt.</translation>
    </message>
    <message>
        <source>Take another copy of the recording if there is one.</source>
        <translation>Eine andere Kopie der Aufzeichnung nehmen, wenn es eine gibt.</translation>
    </message>
    <message>
        <source>Take another copy of the recording, or record the run again.</source>
        <translation>Eine andere Kopie der Aufzeichnung nehmen oder die Fahrt erneut aufzeichnen.</translation>
    </message>
    <message>
        <source>Take some of them out.</source>
        <translation>Einige herausnehmen.</translation>
    </message>
    <message>
        <source>Take stronger motors, smaller wheels or a lower obstacle.</source>
        <translation>Stärkere Motoren, kleinere Räder oder ein niedrigeres Hindernis wählen.</translation>
    </message>
    <message>
        <source>Take stronger motors, smaller wheels or a lower slope.</source>
        <translation>Stärkere Motoren, kleinere Räder oder eine geringere Neigung wählen.</translation>
    </message>
    <message>
        <source>The Grübler count ({}) cannot see this.</source>
        <translation>Der Laufgrad nach Grübler ({}) kann das nicht zeigen.</translation>
    </message>
    <message>
        <source>The drawn pose is special: after a small real motion more constraints hold. The search was made there, and in the drawn pose itself constraints stay redundant.</source>
        <translation>Die gezeichnete Stellung ist besonders: Nach einer kleinen wirklichen Bewegung halten mehr Bedingungen. Dort wurde gesucht; in der gezeichneten Stellung selbst bleiben Bedingungen redundant.</translation>
    </message>
    <message>
        <source>The frame buffer for the picture could not be made.</source>
        <translation>Der Bildspeicher für das Bild war nicht zu bekommen.</translation>
    </message>
    <message>
        <source>The picture could not be written.</source>
        <translation>Das Bild konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The relaxed model that the file has is exact.</source>
        <translation>Das gelockerte Modell der Datei ist exakt.</translation>
    </message>
    <message>
        <source>The same of the time in which the wheel carries load: free flight is not in it.</source>
        <translation>Dasselbe für die Zeit, in der das Rad Last trägt: ohne freien Flug.</translation>
    </message>
    <message>
        <source>The search was cancelled.</source>
        <translation>Die Suche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The search was cut short by its time limit.</source>
        <translation>Die Suche endete an ihrer Zeitgrenze.</translation>
    </message>
    <message>
        <source>This machine&apos;s EGL has no platform displays.</source>
        <translation>EGL kennt auf diesem Rechner keine Plattformen.</translation>
    </message>
    <message>
        <source>This pose is special: after a small real motion the mobility is {}.</source>
        <translation>Diese Stellung ist besonders: Nach einer kleinen wirklichen Bewegung ist der Laufgrad {}.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Too little friction for a scenario</source>
        <translation>Zu wenig Reibung für ein Szenario</translation>
    </message>
    <message>
        <source>Too little torque for a scenario</source>
        <translation>Zu wenig Drehmoment für ein Szenario</translation>
    </message>
    <message>
        <source>Torque (applied)</source>
        <translation>Drehmoment (gestellt)</translation>
    </message>
    <message>
        <source>Torque (commanded)</source>
        <translation>Drehmoment (verlangt)</translation>
    </message>
    <message>
        <source>Torque (planned)</source>
        <translation>Drehmoment (geplant)</translation>
    </message>
    <message>
        <source>Torque of least required friction by the controller&apos;s quasi-static model, before its speed loop and caps.</source>
        <translation>Drehmoment der kleinsten nötigen Reibung nach dem quasistatischen Modell des Reglers, vor Geschwindigkeitsschleife und Grenzen.</translation>
    </message>
    <message>
        <source>Torque of the speed loop</source>
        <translation>Drehmoment der Geschwindigkeitsschleife</translation>
    </message>
    <message>
        <source>Traction force</source>
        <translation>Traktionskraft</translation>
    </message>
    <message>
        <source>Turn of the chassis about its forward axis, positive right side down.</source>
        <translation>Drehung des Chassis um seine Vorwärtsachse, positiv mit der rechten Seite nach unten.</translation>
    </message>
    <message>
        <source>Turn of the chassis about its left axis, positive nose down.</source>
        <translation>Drehung des Chassis um seine linke Achse, positiv mit der Nase nach unten.</translation>
    </message>
    <message>
        <source>Turn of the chassis about the vertical, positive to the left.</source>
        <translation>Drehung des Chassis um die Senkrechte, nach links positiv.</translation>
    </message>
    <message>
        <source>Turn of the joint by its encoder as the controller last read it.</source>
        <translation>Drehung des Gelenks laut Geber, wie der Regler sie zuletzt gelesen hat.</translation>
    </message>
    <message>
        <source>Turn of the joint&apos;s second body against the first, 0 at the drawn pose.</source>
        <translation>Drehung des zweiten Körpers des Gelenks gegen den ersten, 0 in der gezeichneten Stellung.</translation>
    </message>
    <message>
        <source>Type a name.</source>
        <translation>Einen Namen eingeben.</translation>
    </message>
    <message>
        <source>Type a number or an expression.</source>
        <translation>Eine Zahl oder einen Ausdruck eingeben.</translation>
    </message>
    <message>
        <source>Unlock it, or remove the spring.</source>
        <translation>Entsperren oder die Feder entfernen.</translation>
    </message>
    <message>
        <source>Unlock the axle.</source>
        <translation>Die Achse entsperren.</translation>
    </message>
    <message>
        <source>Use .obj, .stl, .ply, .asc or .png.</source>
        <translation>.obj, .stl, .ply, .asc oder .png verwenden.</translation>
    </message>
    <message>
        <source>Use a name ending in .png, .svg or .pdf.</source>
        <translation>Einen Namen wählen, der auf .png, .svg oder .pdf endet.</translation>
    </message>
    <message>
        <source>Use a unit such as mm, deg or kg; it is shown in SI now.</source>
        <translation>Eine Einheit wie mm, deg oder kg verwenden; vorerst wird er in SI gezeigt.</translation>
    </message>
    <message>
        <source>Use numbers, other parameters and a unit at the end.</source>
        <translation>Zahlen, andere Parameter und eine Einheit am Ende verwenden.</translation>
    </message>
    <message>
        <source>Use numbers, parameters of the rover and a unit at the end.</source>
        <translation>Zahlen, Parameter des Rovers und eine Einheit am Ende verwenden.</translation>
    </message>
    <message>
        <source>Use one of: m, dm, cm, mm, km, in.</source>
        <translation>Eine davon verwenden: m, dm, cm, mm, km, in.</translation>
    </message>
    <message>
        <source>Use one of: {}.</source>
        <translation>Eines davon verwenden: {}.</translation>
    </message>
    <message>
        <source>Use up to 100 letters, digits and underscores, not starting with a digit and not the name of a function.</source>
        <translation>Höchstens 100 Buchstaben, Ziffern und Unterstriche verwenden, nicht mit einer Ziffer beginnen und keinen Namen einer Funktion wählen.</translation>
    </message>
    <message>
        <source>Way of the chassis origin along world x since the start.</source>
        <translation>Weg des Chassis-Ursprungs entlang der Welt-x-Achse seit Beginn.</translation>
    </message>
    <message>
        <source>What the loop on the body&apos;s speed asks of a wheel with the mean load; missing where the controller has no such loop.</source>
        <translation>Was die Schleife der Fahrgeschwindigkeit von einem Rad mit mittlerer Last verlangt; fehlt, wo der Regler keine solche Schleife hat.</translation>
    </message>
    <message>
        <source>Wheel off the ground</source>
        <translation>Rad über dem Boden</translation>
    </message>
    <message>
        <source>Wheel rate</source>
        <translation>Raddrehzahl</translation>
    </message>
    <message>
        <source>Wheel rate (measured)</source>
        <translation>Raddrehzahl (gemessen)</translation>
    </message>
    <message>
        <source>Wheel rate (planned)</source>
        <translation>Raddrehzahl (geplant)</translation>
    </message>
    <message>
        <source>Wheel speed</source>
        <translation>Radgeschwindigkeit</translation>
    </message>
    <message>
        <source>Wheels are: {}.</source>
        <translation>Räder sind: {}.</translation>
    </message>
    <message>
        <source>Wheels can fall into holes; close them if that is not meant.</source>
        <translation>Räder können in Löcher fallen; diese schließen, wenn das nicht gewollt ist.</translation>
    </message>
    <message>
        <source>Wheels in one another</source>
        <translation>Räder ineinander</translation>
    </message>
    <message>
        <source>Wheels may touch inner faces there; clean the mesh.</source>
        <translation>Räder können dort innere Flächen berühren; das Netz bereinigen.</translation>
    </message>
    <message>
        <source>Wheels pass through a face from behind; make the normals consistent.</source>
        <translation>Räder fahren von hinten durch eine Fläche; die Normalen einheitlich ausrichten.</translation>
    </message>
    <message>
        <source>Wheels roll forward: give the axle an axis along y.</source>
        <translation>Räder rollen vorwärts: dem Radgelenk eine Achse entlang y geben.</translation>
    </message>
    <message>
        <source>With {} held:</source>
        <translation>Ist {} gehalten:</translation>
    </message>
    <message>
        <source>World x (forward) of the rover frame&apos;s origin carried by the chassis.</source>
        <translation>Welt-x (vorwärts) des Ursprungs des Rover-Koordinatensystems, das das Chassis trägt.</translation>
    </message>
    <message>
        <source>World x component of the whole force of the ground on the wheel.</source>
        <translation>Welt-x-Komponente der ganzen Kraft des Bodens auf das Rad.</translation>
    </message>
    <message>
        <source>World x of the centre of mass of the whole rover.</source>
        <translation>Welt-x des Schwerpunkts des ganzen Rovers.</translation>
    </message>
    <message>
        <source>World y (left) of the same point.</source>
        <translation>Welt-y (links) desselben Punkts.</translation>
    </message>
    <message>
        <source>World y component of the same force.</source>
        <translation>Welt-y-Komponente derselben Kraft.</translation>
    </message>
    <message>
        <source>World y of the centre of mass of the whole rover.</source>
        <translation>Welt-y des Schwerpunkts des ganzen Rovers.</translation>
    </message>
    <message>
        <source>World z (up) of the same point.</source>
        <translation>Welt-z (oben) desselben Punkts.</translation>
    </message>
    <message>
        <source>World z component of the same force.</source>
        <translation>Welt-z-Komponente derselben Kraft.</translation>
    </message>
    <message>
        <source>World z of the centre of mass of the whole rover.</source>
        <translation>Welt-z des Schwerpunkts des ganzen Rovers.</translation>
    </message>
    <message>
        <source>Write &apos;turn&apos; or &apos;slide&apos;, then axis, x, y, z or three numbers.</source>
        <translation>&apos;turn&apos; oder &apos;slide&apos; schreiben, dann axis, x, y, z oder drei Zahlen.</translation>
    </message>
    <message>
        <source>Write TIME,SPEED,TURN in s, m/s and rad/s, with ; between entries.</source>
        <translation>TIME,SPEED,TURN in s, m/s und rad/s schreiben, mit ; zwischen Einträgen.</translation>
    </message>
    <message>
        <source>Write an ASCII grid (.asc) or a mesh.</source>
        <translation>Ein ASCII-Gitter (.asc) oder ein Netz schreiben.</translation>
    </message>
    <message>
        <source>Write it anew, as a grey image of 16 bit.</source>
        <translation>Neu schreiben, als Graustufenbild mit 16 Bit.</translation>
    </message>
    <message>
        <source>Write it in a unit of {}, or as a number in SI.</source>
        <translation>In einer Einheit von {} schreiben, oder als Zahl in SI.</translation>
    </message>
    <message>
        <source>Write it in {} or another unit of {}.</source>
        <translation>In {} oder einer anderen Einheit von {} schreiben.</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>a file of the ground is larger or has a longer name than a recording can have.</source>
        <translation>Eine Datei des Geländes ist größer oder hat einen längeren Namen, als eine Aufzeichnung haben kann.</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a name in quotes</source>
        <translation>ein Name in Anführungszeichen</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number or an expression in quotes</source>
        <translation>eine Zahl oder ein Ausdruck in Anführungszeichen</translation>
    </message>
    <message>
        <source>a shape has no name.</source>
        <translation>Eine Form hat keinen Namen.</translation>
    </message>
    <message>
        <source>a shape is mirrored with its body.</source>
        <translation>Eine Form wird mit ihrem Körper gespiegelt.</translation>
    </message>
    <message>
        <source>a shape&apos;s two ends coincide.</source>
        <translation>Die beiden Enden einer Form fallen zusammen.</translation>
    </message>
    <message>
        <source>a sum and a mesh cannot be added to others.</source>
        <translation>Eine Summe und ein Netz lassen sich nicht zu anderen addieren.</translation>
    </message>
    <message>
        <source>a vertex is not a finite number, or more than 10 km away.</source>
        <translation>Eine Ecke ist keine endliche Zahl oder mehr als 10 km entfernt.</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a {} cannot be mirrored.</source>
        <translation>Spiegeln ist hier nicht möglich ({}).</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>all wheels roll</source>
        <translation>alle Räder rollen</translation>
    </message>
    <message>
        <source>an object in braces</source>
        <translation>ein Objekt in geschweiften Klammern</translation>
    </message>
    <message>
        <source>an unfinished recording is there.</source>
        <translation>Dort liegt eine unvollendete Aufzeichnung.</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>angular rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>angular speed</source>
        <translation>Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>as built it has mobility {} of at least 1: it cannot roll.</source>
        <translation>Wie gebaut ist der Laufgrad {} statt mindestens 1: Er kann nicht rollen.</translation>
    </message>
    <message>
        <source>assumed friction</source>
        <translation>angenommene Reibung</translation>
    </message>
    <message>
        <source>at x = {:.2f} m it asks for a friction of {:.2f}, and the ground gives {:.2f}.</source>
        <translation>Bei x = {:.2f} m ist eine Reibungszahl von {:.2f} nötig, der Boden bietet {:.2f}.</translation>
    </message>
    <message>
        <source>at x = {:.2f} m it asks for {:.2f} N m at wheel {}, and its motor gives {:.2f} N m.</source>
        <translation>Bei x = {:.2f} m sind {:.2f} N m an Rad {} nötig, sein Motor leistet {:.2f} N m.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugelgelenk</translation>
    </message>
    <message>
        <source>ball with slide</source>
        <translation>Kugelgelenk mit Schub</translation>
    </message>
    <message>
        <source>ball with {}</source>
        <translation>Kugelgelenk mit {}</translation>
    </message>
    <message>
        <source>bar height</source>
        <translation>Höhe des Stabs</translation>
    </message>
    <message>
        <source>bar width</source>
        <translation>Breite des Stabs</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>body &apos;{}&apos; already carries a wheel.</source>
        <translation>Körper &apos;{}&apos; trägt schon ein Rad.</translation>
    </message>
    <message>
        <source>body &apos;{}&apos; is fixed.</source>
        <translation>Körper &apos;{}&apos; ist fest.</translation>
    </message>
    <message>
        <source>body speed</source>
        <translation>Fahrgeschwindigkeit</translation>
    </message>
    <message>
        <source>body {}</source>
        <translation>Körper {}</translation>
    </message>
    <message>
        <source>boolean</source>
        <translation>Wahrheitswert</translation>
    </message>
    <message>
        <source>both its bodies are fixed: it has nothing to hold.</source>
        <translation>Seine beiden Körper sind fest: Es hat nichts zu halten.</translation>
    </message>
    <message>
        <source>box center</source>
        <translation>Mitte des Quaders</translation>
    </message>
    <message>
        <source>box height</source>
        <translation>Höhe des Quaders</translation>
    </message>
    <message>
        <source>box length</source>
        <translation>Länge des Quaders</translation>
    </message>
    <message>
        <source>box pitch</source>
        <translation>Nicken des Quaders</translation>
    </message>
    <message>
        <source>box width</source>
        <translation>Breite des Quaders</translation>
    </message>
    <message>
        <source>cannot create a file there</source>
        <translation>Dort lässt sich keine Datei anlegen</translation>
    </message>
    <message>
        <source>cannot create a file there ({}).</source>
        <translation>Dort lässt sich keine Datei anlegen ({}).</translation>
    </message>
    <message>
        <source>cannot give the file its name</source>
        <translation>Die Datei lässt sich nicht benennen</translation>
    </message>
    <message>
        <source>cannot write</source>
        <translation>Schreiben nicht möglich</translation>
    </message>
    <message>
        <source>cannot write the file</source>
        <translation>Die Datei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>cells of {:.6g} m give {:.0f} x {} points.</source>
        <translation>Zellen von {:.6g} m ergeben {:.0f} x {} Punkte.</translation>
    </message>
    <message>
        <source>centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>channel {}</source>
        <translation>Kanal {}</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>com</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>contact free sideways</source>
        <translation>Kontakt seitlich frei</translation>
    </message>
    <message>
        <source>contact {}</source>
        <translation>Kontakt {}</translation>
    </message>
    <message>
        <source>controller period</source>
        <translation>Reglerperiode</translation>
    </message>
    <message>
        <source>controllers</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>Bedeckung</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>cylinder radius</source>
        <translation>Radius des Zylinders</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>Drehschubgelenk</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>derivative gain</source>
        <translation>D-Anteil</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>Fahrbefehle</translation>
    </message>
    <message>
        <source>drive entry {}</source>
        <translation>Fahrbefehl {}</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>expected a list of {} numbers.</source>
        <translation>Erwartet ist eine Liste von {} Zahlen.</translation>
    </message>
    <message>
        <source>expected {}, found {}.</source>
        <translation>Erwartet: {}, gefunden: {}.</translation>
    </message>
    <message>
        <source>expression is empty</source>
        <translation>der Ausdruck ist leer</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>file version {} is not one this program reads ({}).</source>
        <translation>Dateiversion {} liest dieses Programm nicht ({}).</translation>
    </message>
    <message>
        <source>first point</source>
        <translation>erster Punkt</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>freedom &apos;{}&apos; is not understood.</source>
        <translation>Freiheit &apos;{}&apos; ist unverständlich.</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>gear</source>
        <translation>Differential</translation>
    </message>
    <message>
        <source>gear {}</source>
        <translation>Differential {}</translation>
    </message>
    <message>
        <source>ground that hangs over cannot carry a wheel.</source>
        <translation>Überhängender Boden kann kein Rad tragen.</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>info</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>integral gain</source>
        <translation>I-Anteil</translation>
    </message>
    <message>
        <source>it cannot be read ({}).</source>
        <translation>Lässt sich nicht lesen ({}).</translation>
    </message>
    <message>
        <source>it cannot be started: {}.</source>
        <translation>Lässt sich nicht starten: {}.</translation>
    </message>
    <message>
        <source>it cannot be written ({})</source>
        <translation>Schreiben nicht möglich ({})</translation>
    </message>
    <message>
        <source>it cannot be written: {}.</source>
        <translation>Lässt sich nicht schreiben: {}.</translation>
    </message>
    <message>
        <source>it connects a joint with itself.</source>
        <translation>Verbindet ein Gelenk mit sich selbst.</translation>
    </message>
    <message>
        <source>it does not connect two pins.</source>
        <translation>Verbindet nicht zwei Drehgelenke.</translation>
    </message>
    <message>
        <source>it ends before its first state hash: nothing can be compared.</source>
        <translation>Endet vor dem ersten Zustands-Hash: Nichts lässt sich vergleichen.</translation>
    </message>
    <message>
        <source>it has fewer than 2 x 2 pixels.</source>
        <translation>Hat weniger als 2 x 2 Bildpunkte.</translation>
    </message>
    <message>
        <source>it has neither inertia nor shapes; a solid aluminium ball is assumed.</source>
        <translation>Hat weder Trägheit noch Formen; angenommen ist eine massive Aluminiumkugel.</translation>
    </message>
    <message>
        <source>it has no bodies.</source>
        <translation>Hat keine Körper.</translation>
    </message>
    <message>
        <source>it has no entries.</source>
        <translation>Hat keine Einträge.</translation>
    </message>
    <message>
        <source>it has no name.</source>
        <translation>Hat keinen Namen.</translation>
    </message>
    <message>
        <source>it has no wheels to drive on.</source>
        <translation>Hat keine Räder zum Fahren.</translation>
    </message>
    <message>
        <source>it has no wheels to drive.</source>
        <translation>Hat keine Räder zum Antreiben.</translation>
    </message>
    <message>
        <source>it has no wheels to stand on.</source>
        <translation>Hat keine Räder zum Stehen.</translation>
    </message>
    <message>
        <source>it has no wheels.</source>
        <translation>Hat keine Räder.</translation>
    </message>
    <message>
        <source>it has several values; write one (decimals with a point)</source>
        <translation>es sind mehrere Werte; nur einen schreiben (Dezimalzahlen mit Punkt)</translation>
    </message>
    <message>
        <source>it has too many pixels.</source>
        <translation>Hat zu viele Bildpunkte.</translation>
    </message>
    <message>
        <source>it has {:.3g} kg, {:.0f} times less than {} (limit {:.0f}): engines that iterate lose accuracy.</source>
        <translation>Hat {:.3g} kg, {:.0f}-mal weniger als {} (Grenze {:.0f}): Iterierende Engines werden ungenau.</translation>
    </message>
    <message>
        <source>it has {} rims, one outline and holes or several pieces.</source>
        <translation>Hat {} Ränder: einen Umriss und Löcher, oder mehrere Stücke.</translation>
    </message>
    <message>
        <source>it holds no parts of a rover.</source>
        <translation>Enthält keine Teile eines Rovers.</translation>
    </message>
    <message>
        <source>it holds parts of another version.</source>
        <translation>Enthält Teile einer anderen Version.</translation>
    </message>
    <message>
        <source>it holds runs of another plan or rover.</source>
        <translation>Enthält Fahrten eines anderen Plans oder Rovers.</translation>
    </message>
    <message>
        <source>it is a colour image.</source>
        <translation>Ist ein Farbbild.</translation>
    </message>
    <message>
        <source>it is damaged at byte {}.</source>
        <translation>Ist bei Byte {} beschädigt.</translation>
    </message>
    <message>
        <source>it is derived ({}) and cannot be set.</source>
        <translation>Ist abgeleitet ({}) und nicht zu setzen.</translation>
    </message>
    <message>
        <source>it is drawn {:.1f} mm above the lowest wheel (limit {:.0f} mm).</source>
        <translation>Ist {:.1f} mm über dem tiefsten Rad gezeichnet (Grenze {:.0f} mm).</translation>
    </message>
    <message>
        <source>it is no main dimension of this template.</source>
        <translation>Ist kein Hauptmaß dieser Vorlage.</translation>
    </message>
    <message>
        <source>it is no plan of an experiment.</source>
        <translation>Ist kein Plan eines Experiments.</translation>
    </message>
    <message>
        <source>it is no shape.</source>
        <translation>Ist keine Form.</translation>
    </message>
    <message>
        <source>it is not a mirrored pair.</source>
        <translation>Ist kein gespiegeltes Paar.</translation>
    </message>
    <message>
        <source>it is relaxed on one side, but it is not mirrored.</source>
        <translation>Ist an einer Seite gelockert, aber nicht gespiegelt.</translation>
    </message>
    <message>
        <source>it is the chassis, and the next body, &apos;{}&apos;, is mirrored.</source>
        <translation>Ist das Chassis, und der nächste Körper, &apos;{}&apos;, ist gespiegelt.</translation>
    </message>
    <message>
        <source>it is used by {}.</source>
        <translation>Wird verwendet von {}.</translation>
    </message>
    <message>
        <source>it is {:.1f} mm above the ground at the drawn pose.</source>
        <translation>Steht in der gezeichneten Stellung {:.1f} mm über dem Boden.</translation>
    </message>
    <message>
        <source>it is {:.1f} mm below the ground at the drawn pose.</source>
        <translation>Steht in der gezeichneten Stellung {:.1f} mm unter dem Boden.</translation>
    </message>
    <message>
        <source>it joins a body to itself.</source>
        <translation>Verbindet einen Körper mit sich selbst.</translation>
    </message>
    <message>
        <source>it joins two parts that are welded together.</source>
        <translation>Verbindet zwei Teile, die verschweißt sind.</translation>
    </message>
    <message>
        <source>it stands {:.0f} mm deep in wheel {}.</source>
        <translation>Steckt {:.0f} mm tief in Rad {}.</translation>
    </message>
    <message>
        <source>it starts {:.1f} mm deep in the ground.</source>
        <translation>Steckt am Anfang {:.1f} mm tief im Boden.</translation>
    </message>
    <message>
        <source>its axis has no length.</source>
        <translation>Die Achse hat keine Länge.</translation>
    </message>
    <message>
        <source>its axle does not point sideways.</source>
        <translation>Die Achse zeigt nicht zur Seite.</translation>
    </message>
    <message>
        <source>its axle is locked or has no freedom.</source>
        <translation>Die Achse ist gesperrt oder hat keine Freiheit.</translation>
    </message>
    <message>
        <source>its brackets nest deeper than {} levels.</source>
        <translation>Klammern sind mehr als {} Ebenen tief geschachtelt.</translation>
    </message>
    <message>
        <source>its centre of mass lies only {:.0f} mm inside its feet (limit {:.0f} mm).</source>
        <translation>Der Schwerpunkt liegt nur {:.0f} mm innerhalb der Aufstandsfläche (Grenze {:.0f} mm).</translation>
    </message>
    <message>
        <source>its centre of mass lies {:.0f} mm outside its feet: it tips.</source>
        <translation>Der Schwerpunkt liegt {:.0f} mm außerhalb der Aufstandsfläche: Er kippt.</translation>
    </message>
    <message>
        <source>its files are {} MiB together; a recording carries {} MiB at most.</source>
        <translation>Die Dateien haben zusammen {} MiB; eine Aufzeichnung fasst höchstens {} MiB.</translation>
    </message>
    <message>
        <source>its header cannot be read ({}).</source>
        <translation>Der Kopf lässt sich nicht lesen ({}).</translation>
    </message>
    <message>
        <source>its inertia is impossible: {}.</source>
        <translation>Die Trägheit ist unmöglich: {}.</translation>
    </message>
    <message>
        <source>its joint is locked.</source>
        <translation>Das Gelenk ist gesperrt.</translation>
    </message>
    <message>
        <source>its least radius of gyration is {:.2f} mm (limit {:.0f} mm): it turns as easily as a needle.</source>
        <translation>Der kleinste Trägheitsradius ist {:.2f} mm (Grenze {:.0f} mm): Er dreht sich so leicht wie eine Nadel.</translation>
    </message>
    <message>
        <source>its mass, centre or inertia is not usable.</source>
        <translation>Masse, Schwerpunkt oder Trägheit sind unbrauchbar.</translation>
    </message>
    <message>
        <source>its minimum is above its maximum.</source>
        <translation>Das Minimum liegt über dem Maximum.</translation>
    </message>
    <message>
        <source>its new name is empty.</source>
        <translation>Der neue Name ist leer.</translation>
    </message>
    <message>
        <source>its numbers are of another rover than its project.</source>
        <translation>Die Zahlen gehören zu einem anderen Rover als dem des Projekts.</translation>
    </message>
    <message>
        <source>its points are {:.6g} m apart and up to {:.6g} m away.</source>
        <translation>Die Punkte liegen {:.6g} m auseinander und bis zu {:.6g} m entfernt.</translation>
    </message>
    <message>
        <source>its radius of gyration is {:.2f} m, {:.1f} times the rover&apos;s size (limit {:.0f}).</source>
        <translation>Der Trägheitsradius ist {:.2f} m, das {:.1f}-Fache der Größe des Rovers (Grenze {:.0f}).</translation>
    </message>
    <message>
        <source>its ratio is zero.</source>
        <translation>Die Übersetzung ist null.</translation>
    </message>
    <message>
        <source>its run cannot be made again ({}).</source>
        <translation>Die Fahrt lässt sich nicht nachfahren ({}).</translation>
    </message>
    <message>
        <source>its slope of {:.1f} deg asks for a friction of {:.2f}, and the ground gives {:.2f}.</source>
        <translation>Die Neigung von {:.1f} Grad verlangt eine Reibungszahl von {:.2f}, der Boden bietet {:.2f}.</translation>
    </message>
    <message>
        <source>its slope of {:.1f} deg asks for {:.0f} N of traction, and all motors together give {:.0f} N.</source>
        <translation>Die Neigung von {:.1f} Grad verlangt {:.0f} N Traktion, alle Motoren zusammen leisten {:.0f} N.</translation>
    </message>
    <message>
        <source>its steering joint &apos;{}&apos; does not stand upright.</source>
        <translation>Das Lenkgelenk &apos;{}&apos; steht nicht aufrecht.</translation>
    </message>
    <message>
        <source>its steering joint &apos;{}&apos; is no pin.</source>
        <translation>Das Lenkgelenk &apos;{}&apos; ist kein Drehgelenk.</translation>
    </message>
    <message>
        <source>its time {:.6g} is not after the one before.</source>
        <translation>Die Zeit {:.6g} liegt nicht nach der davor.</translation>
    </message>
    <message>
        <source>its times are out of order.</source>
        <translation>Die Zeiten sind ungeordnet.</translation>
    </message>
    <message>
        <source>its triangles face down; the mesh was turned over.</source>
        <translation>Die Dreiecke zeigen nach unten; das Netz wurde umgedreht.</translation>
    </message>
    <message>
        <source>its two ends coincide.</source>
        <translation>Die beiden Enden fallen zusammen.</translation>
    </message>
    <message>
        <source>its two pins do not turn in one common body.</source>
        <translation>Die beiden Drehgelenke drehen sich nicht in einem gemeinsamen Körper.</translation>
    </message>
    <message>
        <source>its unit &apos;{}&apos; is not known.</source>
        <translation>Die Einheit &apos;{}&apos; ist nicht bekannt.</translation>
    </message>
    <message>
        <source>its value depends on itself.</source>
        <translation>Der Wert hängt von sich selbst ab.</translation>
    </message>
    <message>
        <source>its value is not a finite number</source>
        <translation>der Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>its value is not a finite number.</source>
        <translation>Der Wert ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>joint encoder</source>
        <translation>Gelenkgeber</translation>
    </message>
    <message>
        <source>joint {}</source>
        <translation>Gelenk {}</translation>
    </message>
    <message>
        <source>key &apos;{}&apos; is given twice in one object.</source>
        <translation>Der Schlüssel &apos;{}&apos; steht zweimal in einem Objekt.</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>less than {:.0f} mm gained in {:.0f} s</source>
        <translation>in {1:.0f} s weniger als {0:.0f} mm vorangekommen</translation>
    </message>
    <message>
        <source>less than {} MiB of the disk are free</source>
        <translation>auf dem Datenträger sind weniger als {} MiB frei</translation>
    </message>
    <message>
        <source>line {}, column {}</source>
        <translation>Zeile {}, Spalte {}</translation>
    </message>
    <message>
        <source>lower stop</source>
        <translation>unterer Anschlag</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>missing parenthesis</source>
        <translation>eine Klammer fehlt</translation>
    </message>
    <message>
        <source>moves along {}</source>
        <translation>bewegt sich entlang {}</translation>
    </message>
    <message>
        <source>moves along {} and turns about {}</source>
        <translation>bewegt sich entlang {} und dreht sich um {}</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>zu tief geschachtelt</translation>
    </message>
    <message>
        <source>no body is selected for it.</source>
        <translation>Kein Körper ist dafür ausgewählt.</translation>
    </message>
    <message>
        <source>no cell of the grid has a height at all of its corners.</source>
        <translation>Keine Zelle des Gitters hat an allen Ecken eine Höhe.</translation>
    </message>
    <message>
        <source>no file can be made ({})</source>
        <translation>keine Datei lässt sich anlegen ({})</translation>
    </message>
    <message>
        <source>no file is given.</source>
        <translation>Keine Datei ist angegeben.</translation>
    </message>
    <message>
        <source>no friction is enough: at x = {:.2f} m no torques move the rover on.</source>
        <translation>Keine Reibung genügt: Bei x = {:.2f} m bringt kein Drehmoment den Rover weiter.</translation>
    </message>
    <message>
        <source>no joint connects it to the chassis.</source>
        <translation>Kein Gelenk verbindet ihn mit dem Chassis.</translation>
    </message>
    <message>
        <source>no process can be started to read it.</source>
        <translation>Zum Lesen lässt sich kein Prozess starten.</translation>
    </message>
    <message>
        <source>no recorded instant lies in these times.</source>
        <translation>Kein aufgezeichneter Zeitpunkt liegt in diesen Zeiten.</translation>
    </message>
    <message>
        <source>no value of {} brings {} = {} there.</source>
        <translation>Kein Wert von {} bringt {} = {} dorthin.</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>nothing else moves</source>
        <translation>sonst bewegt sich nichts</translation>
    </message>
    <message>
        <source>nothing in it can move</source>
        <translation>nichts darin kann sich bewegen</translation>
    </message>
    <message>
        <source>nothing in it moves.</source>
        <translation>nichts darin bewegt sich.</translation>
    </message>
    <message>
        <source>null</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>objects lie too deep within each other.</source>
        <translation>Objekte liegen zu tief ineinander.</translation>
    </message>
    <message>
        <source>of its file &apos;{}&apos; there are {} of {} bytes.</source>
        <translation>Von der Datei &apos;{}&apos; sind {} von {} Byte da.</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Wanken und Nicken</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>parameter {}</source>
        <translation>Parameter {}</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>payload {}</source>
        <translation>Nutzlast {}</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>Drehgelenk</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>Vorspannung</translation>
    </message>
    <message>
        <source>proportional gain</source>
        <translation>P-Anteil</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>ramp time</source>
        <translation>Anfahrzeit</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>recording of the run</source>
        <translation>Aufzeichnung der Fahrt</translation>
    </message>
    <message>
        <source>region {}</source>
        <translation>Bereich {}</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>rolling resistance</source>
        <translation>Rollwiderstand</translation>
    </message>
    <message>
        <source>rotor inertia</source>
        <translation>Rotorträgheit</translation>
    </message>
    <message>
        <source>rover {}</source>
        <translation>Rover {}</translation>
    </message>
    <message>
        <source>roversim channels FILE lists those of a rover.</source>
        <translation>roversim channels DATEI nennt die eines Rovers.</translation>
    </message>
    <message>
        <source>roversim mobility FILE lists them.</source>
        <translation>roversim mobility DATEI nennt sie.</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>scenario {}</source>
        <translation>Szenario {}</translation>
    </message>
    <message>
        <source>scenario {}, {}{}</source>
        <translation>Szenario {}, {}{}</translation>
    </message>
    <message>
        <source>second point</source>
        <translation>zweiter Punkt</translation>
    </message>
    <message>
        <source>seeds</source>
        <translation>Startwerte</translation>
    </message>
    <message>
        <source>settling time</source>
        <translation>Einschwingzeit</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>shape end</source>
        <translation>Ende der Form</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>Schubgelenk</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>speed limit</source>
        <translation>größte Drehzahl</translation>
    </message>
    <message>
        <source>speed {:.6g} or turn {:.6g} is above {:.0f}.</source>
        <translation>Geschwindigkeit {:.6g} oder Drehung {:.6g} ist größer als {:.0f}.</translation>
    </message>
    <message>
        <source>sphere center</source>
        <translation>Mitte der Kugel</translation>
    </message>
    <message>
        <source>sphere radius</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>spring {}</source>
        <translation>Feder {}</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>steering speed</source>
        <translation>Lenkgeschwindigkeit</translation>
    </message>
    <message>
        <source>steering torque</source>
        <translation>Lenkmoment</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>stops {:.4g} and {:.4g} rad do not enclose the drawn pose (0).</source>
        <translation>Die Anschläge {:.4g} und {:.4g} rad schließen die gezeichnete Stellung (0) nicht ein.</translation>
    </message>
    <message>
        <source>string</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>tactile angle</source>
        <translation>Winkel am Tastrad</translation>
    </message>
    <message>
        <source>tactile force</source>
        <translation>Kraft am Tastrad</translation>
    </message>
    <message>
        <source>terrain {}</source>
        <translation>Gelände {}</translation>
    </message>
    <message>
        <source>terrain {}, file</source>
        <translation>Gelände {}, Datei</translation>
    </message>
    <message>
        <source>terrains</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>text in quotes</source>
        <translation>Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>the Advisor</source>
        <translation>der Ratgeber</translation>
    </message>
    <message>
        <source>the centre of mass is moved by moving this body&apos;s, and it is mirrored or has no mass.</source>
        <translation>Der Schwerpunkt wird mit dem dieses Körpers verschoben, und der ist gespiegelt oder hat keine Masse.</translation>
    </message>
    <message>
        <source>the ending of the name does not tell the format.</source>
        <translation>Die Endung des Namens nennt kein bekanntes Format.</translation>
    </message>
    <message>
        <source>the file cannot be read.</source>
        <translation>Die Datei lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>the file ends after {} of {} heights.</source>
        <translation>Die Datei endet nach {} von {} Höhen.</translation>
    </message>
    <message>
        <source>the file ends early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>the file is larger than 256 MiB.</source>
        <translation>Die Datei ist größer als 256 MiB.</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>Die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the files of the ground are more or larger than a recording can have.</source>
        <translation>Die Dateien des Geländes sind mehr oder größer, als eine Aufzeichnung haben kann.</translation>
    </message>
    <message>
        <source>the first body is the chassis, and &apos;{}&apos; is mirrored.</source>
        <translation>Der erste Körper ist das Chassis, und &apos;{}&apos; ist gespiegelt.</translation>
    </message>
    <message>
        <source>the ground cannot be shown: {}</source>
        <translation>Das Gelände lässt sich nicht zeigen: {}</translation>
    </message>
    <message>
        <source>the ground has holes, which an image written here cannot show.</source>
        <translation>Der Boden hat Löcher, die ein hier geschriebenes Bild nicht zeigen kann.</translation>
    </message>
    <message>
        <source>the header lacks ncols, nrows (2 or more) or cellsize (above 0).</source>
        <translation>Im Kopf fehlen ncols, nrows (2 oder mehr) oder cellsize (über 0).</translation>
    </message>
    <message>
        <source>the largest principal moment ({:.4g}) exceeds the sum of the other two ({:.4g} kg m^2)</source>
        <translation>das größte Hauptträgheitsmoment ({:.4g}) übersteigt die Summe der beiden anderen ({:.4g} kg m^2)</translation>
    </message>
    <message>
        <source>the loop of joints {}</source>
        <translation>die Schleife der Gelenke {}</translation>
    </message>
    <message>
        <source>the mesh cannot be read ({}).</source>
        <translation>Das Netz lässt sich nicht lesen ({}).</translation>
    </message>
    <message>
        <source>the mesh has no triangles with an area.</source>
        <translation>Das Netz hat keine Dreiecke mit einer Fläche.</translation>
    </message>
    <message>
        <source>the mesh reader gave up: the file is broken, or takes more than 5 s or 1 GiB.</source>
        <translation>Das Lesen des Netzes wurde aufgegeben: Die Datei ist beschädigt oder braucht mehr als 5 s oder 1 GiB.</translation>
    </message>
    <message>
        <source>the name is empty or used twice.</source>
        <translation>Der Name ist leer oder doppelt.</translation>
    </message>
    <message>
        <source>the name is used twice.</source>
        <translation>Der Name kommt zweimal vor.</translation>
    </message>
    <message>
        <source>the picture cannot be written.</source>
        <translation>Das Bild lässt sich nicht schreiben.</translation>
    </message>
    <message>
        <source>the picture could not be written whole.</source>
        <translation>Das Bild ließ sich nicht vollständig schreiben.</translation>
    </message>
    <message>
        <source>the picture&apos;s format is not known.</source>
        <translation>Das Format des Bildes ist nicht bekannt.</translation>
    </message>
    <message>
        <source>the project has no scenario of this name.</source>
        <translation>Das Projekt hat kein Szenario dieses Namens.</translation>
    </message>
    <message>
        <source>the project&apos;s text is longer than a recording can have.</source>
        <translation>Der Text des Projekts ist länger, als eine Aufzeichnung haben kann.</translation>
    </message>
    <message>
        <source>the proposal changes it, but the project has it no longer.</source>
        <translation>Der Vorschlag ändert es, aber das Projekt hat es nicht mehr.</translation>
    </message>
    <message>
        <source>the recorded project</source>
        <translation>das aufgezeichnete Projekt</translation>
    </message>
    <message>
        <source>the recording cannot be read.</source>
        <translation>Die Aufzeichnung lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>the recording cannot be written ({}).</source>
        <translation>Die Aufzeichnung lässt sich nicht schreiben ({}).</translation>
    </message>
    <message>
        <source>the recording lacks its file &apos;{}&apos;.</source>
        <translation>In der Aufzeichnung fehlt die Datei &apos;{}&apos;.</translation>
    </message>
    <message>
        <source>the recording was interrupted or is damaged: {} of its {} bytes can be read, up to {:.2f} s.</source>
        <translation>Die Aufzeichnung wurde unterbrochen oder ist beschädigt: {} ihrer {} Byte sind lesbar, bis {:.2f} s.</translation>
    </message>
    <message>
        <source>the rover finds no way to stand at its start.</source>
        <translation>Der Rover kann am Anfang nicht stehen.</translation>
    </message>
    <message>
        <source>the rover goes {:.2f} mm in a step of {:.3g} ms (limit {:.2f} mm, a hundredth of a wheel&apos;s radius): contacts are met too late.</source>
        <translation>Der Rover fährt {:.2f} mm in einem Zeitschritt von {:.3g} ms (Grenze {:.2f} mm, ein Hundertstel eines Radradius): Kontakte kommen zu spät.</translation>
    </message>
    <message>
        <source>the rover has more parts than a recording can have.</source>
        <translation>Der Rover hat mehr Teile, als eine Aufzeichnung haben kann.</translation>
    </message>
    <message>
        <source>the rover has no parameter of this name.</source>
        <translation>Der Rover hat keinen Parameter dieses Namens.</translation>
    </message>
    <message>
        <source>the run completes at {:.4g}.</source>
        <translation>Bei {:.4g} kommt die Fahrt ans Ziel.</translation>
    </message>
    <message>
        <source>the run does not complete at {:.4g}.</source>
        <translation>Bei {:.4g} kommt die Fahrt nicht ans Ziel.</translation>
    </message>
    <message>
        <source>the run has no channel of this name.</source>
        <translation>Die Fahrt hat keinen Kanal dieses Namens.</translation>
    </message>
    <message>
        <source>the run never began.</source>
        <translation>Die Fahrt hat nie begonnen.</translation>
    </message>
    <message>
        <source>the run&apos;s recording is no longer there.</source>
        <translation>Die Aufzeichnung der Fahrt ist nicht mehr da.</translation>
    </message>
    <message>
        <source>the simulation could not be made</source>
        <translation>Die Simulation ließ sich nicht anlegen</translation>
    </message>
    <message>
        <source>the simulation could not be made: {}</source>
        <translation>Die Simulation ließ sich nicht anlegen: {}</translation>
    </message>
    <message>
        <source>the simulation stopped for an unknown reason</source>
        <translation>Die Simulation hielt aus unbekanntem Grund an</translation>
    </message>
    <message>
        <source>the smallest principal moment of inertia is {:.4g} kg m^2, not positive</source>
        <translation>das kleinste Hauptträgheitsmoment ist {:.4g} kg m^2, nicht positiv</translation>
    </message>
    <message>
        <source>the text cannot be read ({}).</source>
        <translation>Der Text lässt sich nicht lesen ({}).</translation>
    </message>
    <message>
        <source>the {} is {:.6g}, negative.</source>
        <translation>{} ist {:.6g}, also negativ.</translation>
    </message>
    <message>
        <source>the {} is {:.6g}, not positive.</source>
        <translation>{} ist {:.6g}, also nicht positiv.</translation>
    </message>
    <message>
        <source>there are no triangles in it</source>
        <translation>keine Dreiecke sind darin</translation>
    </message>
    <message>
        <source>there are no two bodies to join.</source>
        <translation>Es gibt keine zwei Körper zum Verbinden.</translation>
    </message>
    <message>
        <source>there are no two pins in one body left for it to connect.</source>
        <translation>Es gibt keine zwei freien Drehgelenke in einem Körper mehr, die es verbinden könnte.</translation>
    </message>
    <message>
        <source>there are none.</source>
        <translation>Es gibt keine.</translation>
    </message>
    <message>
        <source>there are too many triangles in it</source>
        <translation>zu viele Dreiecke sind darin</translation>
    </message>
    <message>
        <source>there is already a {} &apos;{}&apos;.</source>
        <translation>{} &apos;{}&apos; gibt es schon.</translation>
    </message>
    <message>
        <source>there is more than the {} heights of {} x {} points.</source>
        <translation>Es sind mehr als die {} Höhen von {} x {} Punkten.</translation>
    </message>
    <message>
        <source>there is no body for it.</source>
        <translation>Es gibt keinen Körper dafür.</translation>
    </message>
    <message>
        <source>there is no body to carry it.</source>
        <translation>Es gibt keinen Körper, der sie trägt.</translation>
    </message>
    <message>
        <source>there is no body to hang it on.</source>
        <translation>Es gibt keinen Körper, an dem es hängen könnte.</translation>
    </message>
    <message>
        <source>there is no body, joint or wheel of this name</source>
        <translation>Kein Körper, Gelenk oder Rad heißt so</translation>
    </message>
    <message>
        <source>there is no file &apos;{}&apos; in &apos;{}&apos;.</source>
        <translation>In &apos;{1}&apos; gibt es keine Datei &apos;{0}&apos;.</translation>
    </message>
    <message>
        <source>there is no ground under it at the start, x = {:.3g} m, y = {:.3g} m.</source>
        <translation>Am Anfang ist kein Boden unter dem Rad, x = {:.3g} m, y = {:.3g} m.</translation>
    </message>
    <message>
        <source>there is no number.</source>
        <translation>Die Zahl fehlt.</translation>
    </message>
    <message>
        <source>there is no pin for it to act on.</source>
        <translation>Es gibt kein Drehgelenk, an dem sie wirken könnte.</translation>
    </message>
    <message>
        <source>there is no run to save.</source>
        <translation>Es gibt keine Fahrt zum Speichern.</translation>
    </message>
    <message>
        <source>there is no run to write.</source>
        <translation>Es gibt keine Fahrt zum Schreiben.</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>there is no such place among its shapes.</source>
        <translation>Diesen Platz gibt es unter seinen Formen nicht.</translation>
    </message>
    <message>
        <source>there is no such place in the list.</source>
        <translation>Diesen Platz gibt es in der Liste nicht.</translation>
    </message>
    <message>
        <source>there is no such variant.</source>
        <translation>Diese Variante gibt es nicht.</translation>
    </message>
    <message>
        <source>there is no such wheel.</source>
        <translation>Dieses Rad gibt es nicht.</translation>
    </message>
    <message>
        <source>there is no variant &apos;{}&apos;.</source>
        <translation>Eine Variante &apos;{}&apos; gibt es nicht.</translation>
    </message>
    <message>
        <source>there is no {} &apos;{}&apos;.</source>
        <translation>{} &apos;{}&apos; gibt es nicht.</translation>
    </message>
    <message>
        <source>there is none to drive with, or one outside 0 to 5.</source>
        <translation>Es gibt keine zum Fahren, oder eine außerhalb von 0 bis 5.</translation>
    </message>
    <message>
        <source>there is none, or one that nobody drives.</source>
        <translation>Es gibt keinen, oder einen, mit dem niemand fährt.</translation>
    </message>
    <message>
        <source>there is nothing of its run in it.</source>
        <translation>Von der Fahrt ist nichts darin.</translation>
    </message>
    <message>
        <source>this is not a RoverStudio project.</source>
        <translation>Ist kein Projekt von RoverStudio.</translation>
    </message>
    <message>
        <source>this is not a readable PNG image ({}).</source>
        <translation>Ist kein lesbares PNG-Bild ({}).</translation>
    </message>
    <message>
        <source>this is not a recording.</source>
        <translation>Ist keine Aufzeichnung.</translation>
    </message>
    <message>
        <source>this is not valid JSON ({}).</source>
        <translation>Ist kein gültiges JSON ({}).</translation>
    </message>
    <message>
        <source>this name cannot be used in expressions.</source>
        <translation>Dieser Name ist in Ausdrücken nicht verwendbar.</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>too few parameters for function &quot;{}&quot; at expression position {}</source>
        <translation>zu wenige Argumente für Funktion &quot;{}&quot; an Stelle {} des Ausdrucks</translation>
    </message>
    <message>
        <source>too many parameters for function &quot;{}&quot; at expression position {}</source>
        <translation>zu viele Argumente für Funktion &quot;{}&quot; an Stelle {} des Ausdrucks</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>torque limit</source>
        <translation>größtes Moment</translation>
    </message>
    <message>
        <source>torsional damping</source>
        <translation>Drehdämpfung</translation>
    </message>
    <message>
        <source>torsional stiffness</source>
        <translation>Drehsteifigkeit</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>turns about {}</source>
        <translation>dreht sich um {}</translation>
    </message>
    <message>
        <source>two of its free directions are the same or dependent.</source>
        <translation>Zwei der freien Richtungen sind gleich oder abhängig.</translation>
    </message>
    <message>
        <source>unexpected argument separator at position {}</source>
        <translation>unerwartetes Trennzeichen an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected end of expression at position {}</source>
        <translation>unerwartetes Ende des Ausdrucks an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected function &quot;{}&quot; at position {}</source>
        <translation>unerwartete Funktion &quot;{}&quot; an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected operator &quot;{}&quot; found at position {}</source>
        <translation>unerwarteter Operator &quot;{}&quot; an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected parenthesis &quot;{}&quot; at position {}</source>
        <translation>unerwartete Klammer &quot;{}&quot; an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected token &quot;{}&quot; found at position {}</source>
        <translation>unerwartetes Zeichen &quot;{}&quot; an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected value &quot;{}&quot; found at position {}</source>
        <translation>unerwarteter Wert &quot;{}&quot; an Stelle {}</translation>
    </message>
    <message>
        <source>unexpected variable &quot;{}&quot; found at position {}</source>
        <translation>unerwartete Variable &quot;{}&quot; an Stelle {}</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>universal</source>
        <translation>Kreuzgelenk</translation>
    </message>
    <message>
        <source>upper stop</source>
        <translation>oberer Anschlag</translation>
    </message>
    <message>
        <source>variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>variant {}</source>
        <translation>Variante {}</translation>
    </message>
    <message>
        <source>variant {}, {}</source>
        <translation>Variante {}, {}</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>weld</source>
        <translation>verschweißt</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>wheel rate</source>
        <translation>Raddrehzahl</translation>
    </message>
    <message>
        <source>wheel {}</source>
        <translation>Rad {}</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>worker {}</source>
        <translation>Arbeiter {}</translation>
    </message>
    <message>
        <source>x from</source>
        <translation>x von</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x bis</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y von</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y bis</translation>
    </message>
    <message>
        <source>{:.0f} x {:.0f} points are more than {}.</source>
        <translation>{:.0f} x {:.0f} Punkte sind mehr als {}.</translation>
    </message>
    <message>
        <source>{:.4g} to {:.4g} in steps of {:.4g} cannot be searched.</source>
        <translation>{:.4g} bis {:.4g} in Schritten von {:.4g} lässt sich nicht absuchen.</translation>
    </message>
    <message>
        <source>{:.6g} is not between {:.6g} and {:.6g}.</source>
        <translation>{:.6g} liegt nicht zwischen {:.6g} und {:.6g}.</translation>
    </message>
    <message>
        <source>{:.6g} m between points gives {:.0f} x {:.0f} of them.</source>
        <translation>{:.6g} m zwischen Punkten ergibt {:.0f} x {:.0f} davon.</translation>
    </message>
    <message>
        <source>{:.6g} m is more than 1000 m.</source>
        <translation>{:.6g} m ist mehr als 1000 m.</translation>
    </message>
    <message>
        <source>{} </source>
        <translation>{}: </translation>
    </message>
    <message>
        <source>{} (its project)</source>
        <translation>{} (sein Projekt)</translation>
    </message>
    <message>
        <source>{} ({}); the recording ends before the run.</source>
        <translation>{} ({}); die Aufzeichnung endet vor der Fahrt.</translation>
    </message>
    <message>
        <source>{} = {} depends on {}.</source>
        <translation>{} = {} hängt ab von {}.</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} und {} weitere</translation>
    </message>
    <message>
        <source>{} balls</source>
        <translation>{} Kugelgelenke</translation>
    </message>
    <message>
        <source>{} balls with slide</source>
        <translation>{} Kugelgelenke mit Schub</translation>
    </message>
    <message>
        <source>{} bodies move</source>
        <translation>{} Körper bewegen sich</translation>
    </message>
    <message>
        <source>{} cannot be closed</source>
        <translation>{} lässt sich nicht schließen</translation>
    </message>
    <message>
        <source>{} cannot move</source>
        <translation>{} kann sich nicht bewegen</translation>
    </message>
    <message>
        <source>{} constraints are redundant</source>
        <translation>{} Bedingungen redundant</translation>
    </message>
    <message>
        <source>{} constraints are redundant, and the relaxed model leaves {} of them.</source>
        <translation>{} Bedingungen sind redundant, und das gelockerte Modell lässt {} davon.</translation>
    </message>
    <message>
        <source>{} contacts free sideways</source>
        <translation>{} Kontakte seitlich frei</translation>
    </message>
    <message>
        <source>{} cylindrical</source>
        <translation>{} Drehschubgelenke</translation>
    </message>
    <message>
        <source>{} drops</source>
        <translation>{} fällt</translation>
    </message>
    <message>
        <source>{} edges have more than two triangles.</source>
        <translation>{} Kanten haben mehr als zwei Dreiecke.</translation>
    </message>
    <message>
        <source>{} edges lie between triangles that face opposite sides.</source>
        <translation>{} Kanten liegen zwischen Dreiecken, die nach entgegengesetzten Seiten zeigen.</translation>
    </message>
    <message>
        <source>{} freedoms within it.</source>
        <translation>{} Freiheiten in sich.</translation>
    </message>
    <message>
        <source>{} grousers cannot be drawn.</source>
        <translation>{} Stollen lassen sich nicht zeichnen.</translation>
    </message>
    <message>
        <source>{} holds its bodies</source>
        <translation>{} hält ihre Körper</translation>
    </message>
    <message>
        <source>{} is drawn in a singular pose: which way it went on from there is chance</source>
        <translation>{} ist in singulärer Stellung gezeichnet: Wie es von dort weiterging, ist Zufall</translation>
    </message>
    <message>
        <source>{} is free</source>
        <translation>{} ist frei</translation>
    </message>
    <message>
        <source>{} is mirrored and means it by the name &apos;{}&apos; together with one on the other side.</source>
        <translation>{} ist gespiegelt und meint es mit dem Namen &apos;{}&apos; zusammen mit einem der anderen Seite.</translation>
    </message>
    <message>
        <source>{} joints change: {}; {} points, the least</source>
        <translation>{} Gelenke ändern sich: {}; {} Punkte, die wenigsten</translation>
    </message>
    <message>
        <source>{} joints change: {}; {} points, {} more than the least</source>
        <translation>{} Gelenke ändern sich: {}; {} Punkte, {} mehr als die wenigsten</translation>
    </message>
    <message>
        <source>{} joints of the suspension turn</source>
        <translation>{} Gelenke der Aufhängung drehen sich</translation>
    </message>
    <message>
        <source>{} lands</source>
        <translation>{} setzt auf</translation>
    </message>
    <message>
        <source>{} leaves</source>
        <translation>{} löst sich</translation>
    </message>
    <message>
        <source>{} leaves edge</source>
        <translation>{} verlässt Kante</translation>
    </message>
    <message>
        <source>{} leaves its stop</source>
        <translation>{} verlässt Anschlag</translation>
    </message>
    <message>
        <source>{} lifts</source>
        <translation>{} hebt ab</translation>
    </message>
    <message>
        <source>{} meets</source>
        <translation>{} trifft auf</translation>
    </message>
    <message>
        <source>{} of its constraints repeat what its others already hold.</source>
        <translation>{} seiner Bedingungen wiederholen, was die anderen schon halten.</translation>
    </message>
    <message>
        <source>{} of its motions move neither chassis nor wheels.</source>
        <translation>{} seiner Bewegungen bewegen weder Chassis noch Räder.</translation>
    </message>
    <message>
        <source>{} of the freedoms are idle: neither chassis nor wheels move.</source>
        <translation>{} der Freiheiten sind leer: Weder Chassis noch Räder bewegen sich.</translation>
    </message>
    <message>
        <source>{} of {} wheels roll</source>
        <translation>{} von {} Rädern rollen</translation>
    </message>
    <message>
        <source>{} passed a singular pose, where energy could not be kept within 1 %</source>
        <translation>{} durchlief eine singuläre Stellung, in der die Energie nicht auf 1 % zu halten war</translation>
    </message>
    <message>
        <source>{} passed next to a singular pose</source>
        <translation>{} kam dicht an eine singuläre Stellung</translation>
    </message>
    <message>
        <source>{} pieces that no joint connects.</source>
        <translation>{} Stücke, die kein Gelenk verbindet.</translation>
    </message>
    <message>
        <source>{} reaches edge</source>
        <translation>{} erreicht Kante</translation>
    </message>
    <message>
        <source>{} reaches its stop</source>
        <translation>{} erreicht Anschlag</translation>
    </message>
    <message>
        <source>{} terrains are added.</source>
        <translation>{} Gelände werden addiert.</translation>
    </message>
    <message>
        <source>{} touches</source>
        <translation>{} berührt den Boden</translation>
    </message>
    <message>
        <source>{} triangles without area were left out.</source>
        <translation>{} Dreiecke ohne Fläche wurden weggelassen.</translation>
    </message>
    <message>
        <source>{} turns, {} slides</source>
        <translation>{} Drehungen, {} Schübe</translation>
    </message>
    <message>
        <source>{} universal</source>
        <translation>{} Kreuzgelenke</translation>
    </message>
    <message>
        <source>{}, every wheel at the traction cap of assumed friction {:.3g}</source>
        <translation>{}, jedes Rad an der Traktionsgrenze der angenommenen Reibung {:.3g}</translation>
    </message>
    <message>
        <source>{}, shape {}</source>
        <translation>{}, Form {}</translation>
    </message>
    <message>
        <source>{}, though every wheel gave all that the ground takes; they rest</source>
        <translation>{}, obwohl jedes Rad alles gab, was der Boden hergibt; sie ruhen</translation>
    </message>
    <message>
        <source>{}..{} are no seeds.</source>
        <translation>{}..{} sind keine Startwerte.</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; has no value: {}.</source>
        <translation>{}: &apos;{}&apos; hat keinen Wert: {}.</translation>
    </message>
    <message>
        <source>{}: its value is not a finite number.</source>
        <translation>{}: Der Wert ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>{}: line {}</source>
        <translation>{}: Zeile {}</translation>
    </message>
    <message>
        <source>{}; it was given up.</source>
        <translation>{}; sie wurde aufgegeben.</translation>
    </message>
    <message>
        <source>{}{} is above its maximum of {}{}.</source>
        <translation>{}{} liegt über dem Maximum von {}{}.</translation>
    </message>
    <message>
        <source>{}{} is below its minimum of {}{}.</source>
        <translation>{}{} liegt unter dem Minimum von {}{}.</translation>
    </message>
    <message>
        <source>gear ratio</source>
        <translation>Übersetzung</translation>
    </message>
</context>
<context>
    <name>widgets::ActionRegistry</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Orbit the 3D view</source>
        <translation>3-D-Ansicht drehen</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>mit links ziehen</translation>
    </message>
    <message>
        <source>Pan the 3D view</source>
        <translation>3-D-Ansicht verschieben</translation>
    </message>
    <message>
        <source>middle, right or Shift + left drag</source>
        <translation>mit Mitte, rechts oder Umschalt + links ziehen</translation>
    </message>
    <message>
        <source>Zoom the 3D view</source>
        <translation>3-D-Ansicht zoomen</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Select a joint or body</source>
        <translation>Gelenk oder Körper auswählen</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Look at a point</source>
        <translation>Einen Punkt in die Mitte holen</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Drive a rover by hand</source>
        <translation>Rover von Hand fahren</translation>
    </message>
    <message>
        <source>W A S D, the arrow keys or a gamepad; Shift: slowly</source>
        <translation>W A S D, Pfeiltasten oder Gamepad; Umschalt: langsam</translation>
    </message>
    <message>
        <source>Step a number</source>
        <translation>Zahl schrittweise ändern</translation>
    </message>
    <message>
        <source>Up and Down in its field, Shift for ten</source>
        <translation>Auf und Ab in ihrem Feld, mit Umschalt zehnfach</translation>
    </message>
</context>
<context>
    <name>widgets::AdvisorPage</name>
    <message>
        <source>%1: held → free sideways</source>
        <translation>%1: gehalten → seitlich frei</translation>
    </message>
    <message>
        <source>%1 (left only)</source>
        <translation>%1 (nur links)</translation>
    </message>
    <message>
        <source>%1 (right only)</source>
        <translation>%1 (nur rechts)</translation>
    </message>
    <message>
        <source>Grübler</source>
        <translation>Grübler</translation>
    </message>
    <message>
        <source>rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>redundant</source>
        <translation>redundant</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Exact as built</source>
        <translation>Schon wie gebaut statisch bestimmt</translation>
    </message>
    <message>
        <source>1 exact set of joints</source>
        <translation>1 exakter Satz von Gelenken</translation>
    </message>
    <message>
        <source>%1 exact sets of joints</source>
        <translation>%1 exakte Sätze von Gelenken</translation>
    </message>
    <message>
        <source>Nothing found in the time given</source>
        <translation>In der gegebenen Zeit nichts gefunden</translation>
    </message>
    <message>
        <source>Cancelled before anything was found</source>
        <translation>Abgebrochen, bevor etwas gefunden war</translation>
    </message>
    <message>
        <source>There is no exact set of joints</source>
        <translation>Es gibt keinen exakten Satz von Gelenken</translation>
    </message>
    <message>
        <source>Advisor</source>
        <translation>Ratgeber</translation>
    </message>
    <message>
        <source>What the Advisor found</source>
        <translation>Was der Ratgeber gefunden hat</translation>
    </message>
    <message>
        <source>Advice in words</source>
        <translation>Rat in Worten</translation>
    </message>
    <message>
        <source>Counts with the proposal</source>
        <translation>Zahlen mit dem Vorschlag</translation>
    </message>
    <message>
        <source>Make this the relaxed model of the project; the rover as built stays</source>
        <translation>Dies zum gelockerten Modell des Projekts machen; der Rover wie gebaut bleibt</translation>
    </message>
    <message>
        <source>Search joints that would leave nothing redundant (Ctrl+Shift+A)</source>
        <translation>Gelenke suchen, mit denen nichts redundant bleibt (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Suche abbrechen</translation>
    </message>
    <message>
        <source>Time of the search</source>
        <translation>Dauer der Suche</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>What the changes cost: a ball 2, a ball with slide 5, a contact 1, ...</source>
        <translation>Was die Änderungen kosten: Kugelgelenk 2, Kugelgelenk mit Schub 5, Kontakt 1, ...</translation>
    </message>
    <message>
        <source>0 to 1: a small one is barely exact, and magnifies errors of make</source>
        <translation>0 bis 1: Ein kleiner ist kaum noch exakt und vergrößert Fertigungsfehler</translation>
    </message>
    <message>
        <source>Find exact joints</source>
        <translation>Exakte Gelenke suchen</translation>
    </message>
    <message>
        <source>Search longer</source>
        <translation>Länger suchen</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>%1 s of at most %2 s</source>
        <translation>%1 s von höchstens %2 s</translation>
    </message>
    <message>
        <source>Searching for joints to free. Edit the rover, and the search ends.</source>
        <translation>Sucht Gelenke zum Lösen. Wird der Rover bearbeitet, endet die Suche.</translation>
    </message>
    <message>
        <source>The rover was edited: the search has ended</source>
        <translation>Der Rover wurde bearbeitet: Die Suche ist zu Ende</translation>
    </message>
    <message>
        <source>For the rover before it was edited: search again</source>
        <translation>Für den Rover vor der Bearbeitung: erneut suchen</translation>
    </message>
    <message>
        <source>No advice</source>
        <translation>Kein Rat</translation>
    </message>
    <message>
        <source>Which joints need more freedom so that nothing is redundant or idle, and the rover still moves as it does? The cheapest sets are proposed; one of them can become the relaxed model.</source>
        <translation>Welche Gelenke brauchen mehr Freiheit, damit nichts redundant oder leer ist und der Rover sich bewegt wie bisher? Vorgeschlagen werden die billigsten Sätze; einer davon kann das gelockerte Modell werden.</translation>
    </message>
    <message>
        <source>Proposal %1 is applied</source>
        <translation>Vorschlag %1 ist angewandt</translation>
    </message>
    <message>
        <source>Apply proposal %1</source>
        <translation>Vorschlag %1 anwenden</translation>
    </message>
    <message>
        <source>%1: %2 changes</source>
        <translation>%1: %2 Änderungen</translation>
    </message>
</context>
<context>
    <name>widgets::Autosave</name>
    <message>
        <source>copies of unsaved work cannot be written there.</source>
        <translation>Kopien ungesicherter Arbeit können dort nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check the permissions of the folder and the free space, and save often.</source>
        <translation>Rechte des Ordners und freien Platz prüfen, und oft speichern.</translation>
    </message>
</context>
<context>
    <name>widgets::ComparePanel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Schlupf</translation>
    </message>
    <message>
        <source>Absolute slip of all wheels</source>
        <translation>Absoluter Schlupf aller Räder</translation>
    </message>
    <message>
        <source>Loaded slip</source>
        <translation>Schlupf unter Last</translation>
    </message>
    <message>
        <source>The same of wheels that carry load</source>
        <translation>Dasselbe für Räder, die Last tragen</translation>
    </message>
    <message>
        <source>Friction work</source>
        <translation>Reibarbeit</translation>
    </message>
    <message>
        <source>Energy lost where something slides</source>
        <translation>Energieverlust, wo etwas gleitet</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Work of the drives</source>
        <translation>Arbeit der Antriebe</translation>
    </message>
    <message>
        <source>Peak torque</source>
        <translation>Spitzenmoment</translation>
    </message>
    <message>
        <source>Largest torque of any wheel</source>
        <translation>Größtes Drehmoment eines Rades</translation>
    </message>
    <message>
        <source>End x</source>
        <translation>Ende x</translation>
    </message>
    <message>
        <source>Where the chassis&apos; origin ended</source>
        <translation>Wo der Ursprung des Chassis endete</translation>
    </message>
    <message>
        <source>End y</source>
        <translation>Ende y</translation>
    </message>
    <message>
        <source>%1
μ %2, %3</source>
        <translation>%1
μ %2, %3</translation>
    </message>
    <message>
        <source>Compare runs</source>
        <translation>Fahrten vergleichen</translation>
    </message>
    <message>
        <source>First controller, chosen in the run bar</source>
        <translation>Erster Regler, in der Fahrtleiste gewählt</translation>
    </message>
    <message>
        <source>Chosen in the run bar, as scenario, engine and friction</source>
        <translation>In der Fahrtleiste gewählt, wie Szenario, Engine und Reibung</translation>
    </message>
    <message>
        <source>Second controller</source>
        <translation>Zweiter Regler</translation>
    </message>
    <message>
        <source>Run both</source>
        <translation>Beide fahren</translation>
    </message>
    <message>
        <source>Drive the scenario with both controllers side by side; the second is shown pale</source>
        <translation>Das Szenario mit beiden Reglern nebeneinander fahren; der zweite erscheint blass</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Verdict in detail</source>
        <translation>Urteil im Einzelnen</translation>
    </message>
    <message>
        <source>against</source>
        <translation>gegen</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Fahrten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>Its curves are drawn in the plots</source>
        <translation>Ihre Kurven erscheinen in den Diagrammen</translation>
    </message>
    <message>
        <source>Its rover is shown pale in the 3-D view, too</source>
        <translation>Ihr Rover erscheint blass auch in der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>Keep run</source>
        <translation>Fahrt behalten</translation>
    </message>
    <message>
        <source>Hold a copy of the run on show, to compare the next with it (Ctrl+K)</source>
        <translation>Eine Kopie der gezeigten Fahrt behalten, um die nächste damit zu vergleichen (Strg+K)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Drop the selected run</source>
        <translation>Die ausgewählte Fahrt verwerfen</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>For a spreadsheet</source>
        <translation>Für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>What the runs came to</source>
        <translation>Ergebnisse der Fahrten</translation>
    </message>
    <message>
        <source>Drive a scenario, keep the run, drive again: the two stand side by side here.</source>
        <translation>Ein Szenario fahren, die Fahrt behalten, noch einmal fahren: Hier stehen beide nebeneinander.</translation>
    </message>
    <message>
        <source>How to compare runs</source>
        <translation>Wie Fahrten verglichen werden</translation>
    </message>
    <message>
        <source>%1 (older design)</source>
        <translation>%1 (älterer Entwurf)</translation>
    </message>
    <message>
        <source>The design or the settings have changed since</source>
        <translation>Entwurf oder Einstellungen haben sich seither geändert</translation>
    </message>
    <message>
        <source>The run on show</source>
        <translation>Die gezeigte Fahrt</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>%1 still drives...</source>
        <translation>%1 fährt noch ...</translation>
    </message>
    <message>
        <source>Both drive; the pale rover is %1.</source>
        <translation>Beide fahren; der blasse Rover ist %1.</translation>
    </message>
    <message>
        <source>%1: no difference.</source>
        <translation>%1: kein Unterschied.</translation>
    </message>
    <message>
        <source>%1: %2 has %3 % less (%4 against %5 %6).</source>
        <translation>%1: %2 hat %3 % weniger (%4 gegen %5 %6).</translation>
    </message>
    <message>
        <source>Only %1 gets there</source>
        <translation>Nur %1 kommt ans Ziel</translation>
    </message>
    <message>
        <source>%1: %2. A run that fails has no slip to compare.</source>
        <translation>%1: %2. Eine gescheiterte Fahrt hat keinen vergleichbaren Schlupf.</translation>
    </message>
    <message>
        <source>Neither gets there</source>
        <translation>Keiner kommt ans Ziel</translation>
    </message>
    <message>
        <source>%1: %2. %3: %4.</source>
        <translation>%1: %2. %3: %4.</translation>
    </message>
    <message>
        <source>They did not drive the same way</source>
        <translation>Beide sind nicht denselben Weg gefahren</translation>
    </message>
    <message>
        <source>Their ends are %1 m apart; below 0.1 m slip could be compared.</source>
        <translation>Ihre Endpunkte liegen %1 m auseinander; unter 0.1 m wäre der Schlupf vergleichbar.</translation>
    </message>
    <message>
        <source>Both slip alike</source>
        <translation>Beide mit gleichem Schlupf</translation>
    </message>
    <message>
        <source>%1 slips less: %2 against %3 mm</source>
        <translation>%1 hat weniger Schlupf: %2 gegen %3 mm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>am Ziel</translation>
    </message>
    <message>
        <source>time is up</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>steckt fest</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>fährt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Hinzufügen ...</translation>
    </message>
    <message>
        <source>Hold a recording beside these runs; the project stays</source>
        <translation>Eine Aufzeichnung neben diese Fahrten stellen; das Projekt bleibt</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern ...</translation>
    </message>
    <message>
        <source>Save the selected run as a recording</source>
        <translation>Die gewählte Fahrt als Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Runs out of sight</source>
        <translation>Fahrten außer Sicht</translation>
    </message>
    <message>
        <source>More runs to the right →</source>
        <translation>Weitere Fahrten rechts →</translation>
    </message>
    <message>
        <source>← More runs to the left</source>
        <translation>← Weitere Fahrten links</translation>
    </message>
</context>
<context>
    <name>widgets::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
</context>
<context>
    <name>widgets::DragEditor</name>
    <message>
        <source>centre of mass of the rover</source>
        <translation>Schwerpunkt des Rovers</translation>
    </message>
    <message>
        <source>centre of mass of %1</source>
        <translation>Schwerpunkt von %1</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>Gelenk %1</translation>
    </message>
    <message>
        <source>wheel %1</source>
        <translation>Rad %1</translation>
    </message>
    <message>
        <source>payload %1</source>
        <translation>Nutzlast %1</translation>
    </message>
    <message>
        <source>wheelbase %1 mm</source>
        <translation>Radstand %1 mm</translation>
    </message>
    <message>
        <source>track %1 mm</source>
        <translation>Spurweite %1 mm</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>%1 %2 mm, by %3</source>
        <translation>%1 %2 mm, durch %3</translation>
    </message>
    <message>
        <source>%1 of %2 moves by</source>
        <translation>%1 von %2 folgt</translation>
    </message>
    <message>
        <source>%1 will move by %2: drag again</source>
        <translation>%1 folgt künftig %2: noch einmal ziehen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>%1 %2 mm (%3)</source>
        <translation>%1 %2 mm (%3)</translation>
    </message>
</context>
<context>
    <name>widgets::DrawingOverlay</name>
    <message>
        <source>Handles and dimensions</source>
        <translation>Griffe und Maße</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
</context>
<context>
    <name>widgets::ExportDialog</name>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 bis %2 s</translation>
    </message>
    <message>
        <source>Export channels as CSV</source>
        <translation>Kanäle als CSV exportieren</translation>
    </message>
    <message>
        <source>Search channels</source>
        <translation>Kanäle suchen</translation>
    </message>
    <message>
        <source>Search channels: torque, front, ...</source>
        <translation>Kanäle suchen: Drehmoment, front, ...</translation>
    </message>
    <message>
        <source>Channels to write</source>
        <translation>Zu schreibende Kanäle</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Time to write</source>
        <translation>Zu schreibende Zeit</translation>
    </message>
    <message>
        <source>Visible: %1</source>
        <translation>Sichtbar: %1</translation>
    </message>
    <message>
        <source>Between the cursors: %1</source>
        <translation>Zwischen den Marken: %1</translation>
    </message>
    <message>
        <source>Between the cursors (mark one with Shift and a click)</source>
        <translation>Zwischen den Marken (eine mit Umschalt und Klick setzen)</translation>
    </message>
    <message>
        <source>Whole run: %1</source>
        <translation>Ganze Fahrt: %1</translation>
    </message>
    <message>
        <source>Tick all shown</source>
        <translation>Alle gezeigten ankreuzen</translation>
    </message>
    <message>
        <source>Untick all shown</source>
        <translation>Alle gezeigten abwählen</translation>
    </message>
    <message>
        <source>Write...</source>
        <translation>Schreiben ...</translation>
    </message>
    <message>
        <source>Tick at least one channel.</source>
        <translation>Mindestens einen Kanal ankreuzen.</translation>
    </message>
    <message>
        <source>No recorded instant lies in this time.</source>
        <translation>In dieser Zeit liegt kein aufgezeichneter Zeitpunkt.</translation>
    </message>
    <message>
        <source>%1 columns with the time, %2 rows</source>
        <translation>%1 Spalten mit der Zeit, %2 Zeilen</translation>
    </message>
</context>
<context>
    <name>widgets::FileCommands</name>
    <message>
        <source>RoverStudio projects (*.rover);;All files (*)</source>
        <translation>RoverStudio-Projekte (*.rover);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>A new rover: save it under a name of your own.</source>
        <translation>Ein neuer Rover: unter eigenem Namen speichern.</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>The project cannot be opened</source>
        <translation>Das Projekt lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>The example cannot be opened</source>
        <translation>Das Beispiel lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Opened a copy of %1: save it under a name of your own.</source>
        <translation>Kopie von %1 geöffnet: unter eigenem Namen speichern.</translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation>Das Projekt wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>Projekt speichern unter</translation>
    </message>
    <message>
        <source>Saved %1; the files of its ground are in the recording only</source>
        <translation>%1 gespeichert; die Dateien des Geländes liegen nur in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>They are lost if you do not save them.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept safe: %1</source>
        <translation>Ungesicherte Arbeit kann nicht bewahrt werden: %1</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Auf dem Datenträger geändert</translation>
    </message>
    <message>
        <source>%1 is no longer there, or cannot be read.</source>
        <translation>%1 ist nicht mehr da oder kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>%1 was changed by somebody else since it was read.</source>
        <translation>%1 wurde seit dem Lesen von anderen geändert.</translation>
    </message>
    <message>
        <source>It was removed, renamed or moved.</source>
        <translation>Die Datei wurde gelöscht, umbenannt oder verschoben.</translation>
    </message>
    <message>
        <source>What it holds now is kept as %1 if you replace it.</source>
        <translation>Was sie jetzt enthält, bleibt beim Ersetzen als %1 erhalten.</translation>
    </message>
    <message>
        <source>&amp;Write it again</source>
        <translation>&amp;Erneut schreiben</translation>
    </message>
    <message>
        <source>&amp;Replace it</source>
        <translation>E&amp;rsetzen</translation>
    </message>
    <message>
        <source>&amp;Save as...</source>
        <translation>&amp;Speichern unter...</translation>
    </message>
    <message>
        <source>Saved %1, but what it held before could not be kept: %2</source>
        <translation>%1 gespeichert, aber der frühere Inhalt konnte nicht bewahrt werden: %2</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>You have unsaved changes. Reloading can be undone.</source>
        <translation>Es gibt ungesicherte Änderungen. Neu laden lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Reloading can be undone.</source>
        <translation>Neu laden lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Neu laden</translation>
    </message>
    <message>
        <source>&amp;Keep mine</source>
        <translation>&amp;Meines behalten</translation>
    </message>
    <message>
        <source>The project cannot be read again</source>
        <translation>Das Projekt kann nicht erneut gelesen werden</translation>
    </message>
    <message>
        <source>%1 is no longer there: save the project to keep it.</source>
        <translation>%1 ist nicht mehr da: Projekt speichern, um es zu behalten.</translation>
    </message>
    <message numerus="yes">
        <source>%n other project(s) with unsaved changes: File &gt; Recover unsaved work, or at the next start.</source>
        <translation>
            <numerusform>%n weiteres Projekt mit ungesicherten Änderungen: Datei &gt; Ungespeichertes wiederherstellen, oder beim nächsten Start.</numerusform>
            <numerusform>%n weitere Projekte mit ungesicherten Änderungen: Datei &gt; Ungespeichertes wiederherstellen, oder beim nächsten Start.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Ungespeichertes wiederherstellen</translation>
    </message>
    <message>
        <source>No other session left unsaved work behind. What is unsaved in this one is kept safe while it runs.</source>
        <translation>Keine andere Sitzung hat Ungespeichertes hinterlassen. Was in dieser ungespeichert ist, wird gesichert, solange sie läuft.</translation>
    </message>
</context>
<context>
    <name>widgets::GraphPanel</name>
    <message>
        <source>Joint graph</source>
        <translation>Gelenkgraph</translation>
    </message>
    <message>
        <source>What the graph shows</source>
        <translation>Was der Graph zeigt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit the graph</source>
        <translation>Graph einpassen</translation>
    </message>
    <message>
        <source>Show the whole graph; the mouse wheel zooms</source>
        <translation>Den ganzen Graphen zeigen; das Mausrad zoomt</translation>
    </message>
    <message>
        <source>%1: joints and wheel contacts with the number of their freedoms. &lt;span style=&apos;color:%2&apos;&gt;●&lt;/span&gt; Holds what others hold already.</source>
        <translation>%1: Gelenke und Radkontakte mit der Zahl ihrer Freiheiten. &lt;span style=&apos;color:%2&apos;&gt;●&lt;/span&gt; Hält, was andere schon halten.</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Wie gebaut</translation>
    </message>
    <message>
        <source>Relaxed</source>
        <translation>Gelockert</translation>
    </message>
    <message>
        <source>No graph: the project has problems. They are listed under Problems.</source>
        <translation>Kein Graph: Das Projekt hat Probleme. Sie stehen unter Probleme.</translation>
    </message>
    <message>
        <source>%1: %2 free, %3 held, %4 of these could go</source>
        <translation>%1: %2 frei, %3 gehalten, %4 davon entbehrlich</translation>
    </message>
    <message>
        <source>contact %1: %2 free, %3 held, %4 of these could go</source>
        <translation>Kontakt %1: %2 frei, %3 gehalten, %4 davon entbehrlich</translation>
    </message>
    <message>
        <source>gear %1</source>
        <translation>Differential %1</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Boden</translation>
    </message>
</context>
<context>
    <name>widgets::GraphView</name>
    <message>
        <source>Joint graph</source>
        <translation>Gelenkgraph</translation>
    </message>
</context>
<context>
    <name>widgets::GuideWindow</name>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>The guide is not installed beside the program.</source>
        <translation>Das Handbuch ist nicht neben dem Programm installiert.</translation>
    </message>
</context>
<context>
    <name>widgets::MainWindow</name>
    <message>
        <source>Rover</source>
        <translation>Rover</translation>
    </message>
    <message>
        <source>Mobility</source>
        <translation>Laufgrad</translation>
    </message>
    <message>
        <source>Statics</source>
        <translation>Statik</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Steps that can be undone</source>
        <translation>Schritte, die sich rückgängig machen lassen</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Run and plots</source>
        <translation>Fahrt und Diagramme</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>What is drawn over the rover</source>
        <translation>Was über den Rover gezeichnet wird</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>The run goes on, but it cannot be saved: %1</source>
        <translation>Die Fahrt geht weiter, lässt sich aber nicht speichern: %1</translation>
    </message>
    <message>
        <source>Run finished after %1 s: state hash %2, friction violation %3 %, largest loop error %4 mm</source>
        <translation>Fahrt nach %1 s beendet: Zustands-Hash %2, Reibungsverletzung %3 %, größter Schleifenfehler %4 mm</translation>
    </message>
    <message>
        <source>%1[*] - RoverStudio</source>
        <translation>%1[*] - RoverStudio</translation>
    </message>
    <message>
        <source>As built: mobility %1, %2 redundant</source>
        <translation>Wie gebaut: Laufgrad %1, %2 redundant</translation>
    </message>
    <message>
        <source>Relaxed: mobility %1, %2 redundant</source>
        <translation>Gelockert: Laufgrad %1, %2 redundant</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Mobility unknown</source>
        <translation>Laufgrad unbekannt</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Keine Probleme</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Probleme (%1)</translation>
    </message>
    <message>
        <source>Cannot run: see Problems</source>
        <translation>Fahren nicht möglich: siehe Probleme</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>Systeminformationen</translation>
    </message>
    <message>
        <source>&lt;table cellspacing=6&gt;&lt;tr&gt;&lt;td&gt;RoverStudio&lt;/td&gt;&lt;td&gt;%1&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;System&lt;/td&gt;&lt;td&gt;%2&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Qt&lt;/td&gt;&lt;td&gt;%3, platform %4&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;OpenGL&lt;/td&gt;&lt;td&gt;%5&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;table cellspacing=6&gt;&lt;tr&gt;&lt;td&gt;RoverStudio&lt;/td&gt;&lt;td&gt;%1&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;System&lt;/td&gt;&lt;td&gt;%2&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Qt&lt;/td&gt;&lt;td&gt;%3, Plattform %4&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;OpenGL&lt;/td&gt;&lt;td&gt;%5&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>About RoverStudio</source>
        <translation>Über RoverStudio</translation>
    </message>
    <message>
        <source>&lt;h3&gt;RoverStudio %1&lt;/h3&gt;&lt;p&gt;Design wheeled rovers with passive suspension, see whether they are statically determinate, and drive them over terrain.&lt;/p&gt;&lt;p&gt;After Lamon, Thüer, Jordi and Siegwart, &lt;i&gt;Modeling and Optimization of Wheeled Rovers&lt;/i&gt;, 2004.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. No warranty.&lt;/p&gt;&lt;p&gt;Uses Qt, OpenSceneGraph, the Open Dynamics Engine, Eigen, muParser, QCustomPlot, nlohmann-json and fmt.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;RoverStudio %1&lt;/h3&gt;&lt;p&gt;Rover mit Rädern und passivem Fahrwerk entwerfen, prüfen, ob sie statisch bestimmt sind, und sie durch Gelände fahren.&lt;/p&gt;&lt;p&gt;Nach Lamon, Thüer, Jordi und Siegwart, &lt;i&gt;Modeling and Optimization of Wheeled Rovers&lt;/i&gt;, 2004.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später. Ohne Gewähr.&lt;/p&gt;&lt;p&gt;Verwendet Qt, OpenSceneGraph, die Open Dynamics Engine, Eigen, muParser, QCustomPlot, nlohmann-json und fmt.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>List all shortcuts</source>
        <translation>Alle Tastenkürzel zeigen</translation>
    </message>
    <message>
        <source>System &amp;information</source>
        <translation>&amp;Systeminformationen</translation>
    </message>
    <message>
        <source>Versions and what draws, for a report</source>
        <translation>Versionen und Grafiktreiber, für eine Fehlermeldung</translation>
    </message>
    <message>
        <source>&amp;About RoverStudio</source>
        <translation>&amp;Über RoverStudio</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>An empty project</source>
        <translation>Ein leeres Projekt</translation>
    </message>
    <message>
        <source>New from &amp;template...</source>
        <translation>Neu aus &amp;Vorlage ...</translation>
    </message>
    <message>
        <source>A rover of a topology and dimensions of your choice</source>
        <translation>Ein Rover mit frei gewählter Topologie und Hauptmaßen</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen ...</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ein Projekt öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter ...</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Open recordin&amp;g...</source>
        <translation>Auf&amp;zeichnung öffnen ...</translation>
    </message>
    <message>
        <source>Look at a recorded run</source>
        <translation>Eine aufgezeichnete Fahrt ansehen</translation>
    </message>
    <message>
        <source>Save recor&amp;ding...</source>
        <translation>Aufzeichnung s&amp;peichern ...</translation>
    </message>
    <message>
        <source>Save the run so far, with all that is needed to make it again</source>
        <translation>Die bisherige Fahrt speichern, mit allem, was zum Wiederholen nötig ist</translation>
    </message>
    <message>
        <source>Run as &amp;CSV...</source>
        <translation>Fahrt als &amp;CSV ...</translation>
    </message>
    <message>
        <source>Write the recorded run as a table</source>
        <translation>Die aufgezeichnete Fahrt als Tabelle schreiben</translation>
    </message>
    <message>
        <source>&amp;Plots as picture...</source>
        <translation>&amp;Diagramme als Bild ...</translation>
    </message>
    <message>
        <source>Save the plots as PNG, SVG or PDF</source>
        <translation>Die Diagramme als PNG, SVG oder PDF speichern</translation>
    </message>
    <message>
        <source>Copy pl&amp;ots</source>
        <translation>Diagramme k&amp;opieren</translation>
    </message>
    <message>
        <source>Copy the plots as a picture</source>
        <translation>Die Diagramme als Bild kopieren</translation>
    </message>
    <message>
        <source>3D &amp;view as picture...</source>
        <translation>3-D-&amp;Ansicht als Bild ...</translation>
    </message>
    <message>
        <source>Save the 3D view as PNG</source>
        <translation>Die 3-D-Ansicht als PNG speichern</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Cut the selected parts</source>
        <translation>Die ausgewählten Teile ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected parts, for this project or another one</source>
        <translation>Die ausgewählten Teile kopieren, für dieses oder ein anderes Projekt</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Paste parts</source>
        <translation>Teile einfügen</translation>
    </message>
    <message>
        <source>D&amp;uplicate part</source>
        <translation>Teil &amp;duplizieren</translation>
    </message>
    <message>
        <source>Copy the selected parts</source>
        <translation>Die ausgewählten Teile verdoppeln</translation>
    </message>
    <message>
        <source>&amp;Delete part</source>
        <translation>Teil &amp;löschen</translation>
    </message>
    <message>
        <source>Delete the selected parts</source>
        <translation>Die ausgewählten Teile löschen</translation>
    </message>
    <message>
        <source>&amp;Rename part</source>
        <translation>Teil &amp;umbenennen</translation>
    </message>
    <message>
        <source>Rename the current part (F2 in the tree)</source>
        <translation>Das aktuelle Teil umbenennen (F2 im Baum)</translation>
    </message>
    <message>
        <source>&amp;Mirror part</source>
        <translation>Teil s&amp;piegeln</translation>
    </message>
    <message>
        <source>Make a left and a right one of the selected parts</source>
        <translation>Aus den ausgewählten Teilen je ein linkes und ein rechtes machen</translation>
    </message>
    <message>
        <source>Spl&amp;it pair</source>
        <translation>Paar &amp;trennen</translation>
    </message>
    <message>
        <source>Make two independent parts of a mirrored one</source>
        <translation>Aus einem gespiegelten Teil zwei unabhängige machen</translation>
    </message>
    <message>
        <source>Move part &amp;up</source>
        <translation>Teil nach &amp;oben</translation>
    </message>
    <message>
        <source>Move the selected parts up in their list</source>
        <translation>Die ausgewählten Teile in ihrer Liste nach oben schieben</translation>
    </message>
    <message>
        <source>Move part d&amp;own</source>
        <translation>Teil nach u&amp;nten</translation>
    </message>
    <message>
        <source>Move the selected parts down in their list</source>
        <translation>Die ausgewählten Teile in ihrer Liste nach unten schieben</translation>
    </message>
    <message>
        <source>&amp;Search parts</source>
        <translation>Teile &amp;suchen</translation>
    </message>
    <message>
        <source>Show only parts with a text in their name</source>
        <translation>Nur Teile mit einem Text im Namen zeigen</translation>
    </message>
    <message>
        <source>Add: %1</source>
        <translation>Hinzufügen: %1</translation>
    </message>
    <message>
        <source>&amp;Add part</source>
        <translation>Teil &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Bring the whole rover into view</source>
        <translation>Den ganzen Rover zeigen</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>S&amp;chräg</translation>
    </message>
    <message>
        <source>Look from the front right and above</source>
        <translation>Von vorn rechts oben ansehen</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>V&amp;orn</translation>
    </message>
    <message>
        <source>Look at the front</source>
        <translation>Von vorn ansehen</translation>
    </message>
    <message>
        <source>&amp;Side</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>Look at the right side: forward is to the right</source>
        <translation>Die rechte Seite ansehen: vorwärts ist rechts</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Von oben ansehen</translation>
    </message>
    <message>
        <source>O&amp;rthographic</source>
        <translation>O&amp;rthografisch</translation>
    </message>
    <message>
        <source>Without perspective; front, side and top are to scale, with rulers</source>
        <translation>Ohne Perspektive; Vorn, Seite und Oben sind maßstäblich, mit Linealen</translation>
    </message>
    <message>
        <source>&amp;Move parts</source>
        <translation>Teile &amp;bewegen</translation>
    </message>
    <message>
        <source>Drag joints, wheels and centres of mass with the mouse. Snaps to 5 mm, not with Ctrl; Shift keeps to one axis, Alt makes numbers of expressions, Escape takes it back</source>
        <translation>Gelenke, Räder und Schwerpunkte mit der Maus ziehen. Rastet auf 5 mm ein, mit Strg nicht; Umschalt hält eine Achse, Alt macht aus Ausdrücken Zahlen, Esc bricht ab</translation>
    </message>
    <message>
        <source>Fo&amp;llow</source>
        <translation>&amp;Folgen</translation>
    </message>
    <message>
        <source>Keep the driving rover in view</source>
        <translation>Den fahrenden Rover im Bild halten</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Anzeigen</translation>
    </message>
    <message>
        <source>&amp;Centre of mass</source>
        <translation>S&amp;chwerpunkt</translation>
    </message>
    <message>
        <source>&amp;Support polygon</source>
        <translation>&amp;Aufstandspolygon</translation>
    </message>
    <message>
        <source>Contact &amp;forces</source>
        <translation>&amp;Kontaktkräfte</translation>
    </message>
    <message>
        <source>&amp;Freedoms at the joints</source>
        <translation>&amp;Freiheiten der Gelenke</translation>
    </message>
    <message>
        <source>&amp;Trail</source>
        <translation>&amp;Spur</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Gitter</translation>
    </message>
    <message>
        <source>World &amp;axes</source>
        <translation>&amp;Weltachsen</translation>
    </message>
    <message>
        <source>Sh&amp;adow</source>
        <translation>S&amp;chatten</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Reset panels</source>
        <translation>Bereiche &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>All panels back to their places</source>
        <translation>Alle Bereiche zurück an ihren Platz</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The language changes when RoverStudio is started the next time.</source>
        <translation>Die Sprache wechselt beim nächsten Start von RoverStudio.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Fahren</translation>
    </message>
    <message>
        <source>Drive, or pause (Space)</source>
        <translation>Fahren oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>One time step, or one picture on while looking back (Right)</source>
        <translation>Ein Zeitschritt, beim Zurückblicken ein Bild weiter (Rechts)</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>One picture back (Left)</source>
        <translation>Ein Bild zurück (Links)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the start of the run; the design stays (Backspace)</source>
        <translation>Zurück an den Start der Fahrt; der Entwurf bleibt (Rücktaste)</translation>
    </message>
    <message>
        <source>Run again and &amp;compare</source>
        <translation>&amp;Nachfahren und vergleichen</translation>
    </message>
    <message>
        <source>Run the opened recording again: is it the same to the last bit?</source>
        <translation>Die geöffnete Aufzeichnung nachfahren: Ist sie bis aufs letzte Bit gleich?</translation>
    </message>
    <message>
        <source>&amp;Keep run</source>
        <translation>Fahrt &amp;behalten</translation>
    </message>
    <message>
        <source>Hold a copy of the run on show, to compare the next with it</source>
        <translation>Eine Kopie der gezeigten Fahrt behalten, um die nächste damit zu vergleichen</translation>
    </message>
    <message>
        <source>Run two &amp;controllers</source>
        <translation>Zwei &amp;Regler fahren</translation>
    </message>
    <message>
        <source>Drive the scenario with the chosen controller and its rival, side by side</source>
        <translation>Das Szenario mit dem gewählten Regler und seinem Gegner nebeneinander fahren</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>Faster playback</source>
        <translation>Schneller abspielen</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Slower playback</source>
        <translation>Langsamer abspielen</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Show the newest instant</source>
        <translation>Den neuesten Zeitpunkt zeigen</translation>
    </message>
    <message>
        <source>Show the &amp;design</source>
        <translation>&amp;Entwurf zeigen</translation>
    </message>
    <message>
        <source>Show the rover as drawn instead of the run</source>
        <translation>Den gezeichneten Rover statt der Fahrt zeigen</translation>
    </message>
    <message>
        <source>&amp;Mobility</source>
        <translation>&amp;Laufgrad</translation>
    </message>
    <message>
        <source>Show the mobility panel</source>
        <translation>Den Bereich Laufgrad zeigen</translation>
    </message>
    <message>
        <source>&amp;Statics</source>
        <translation>&amp;Statik</translation>
    </message>
    <message>
        <source>Show the statics panel</source>
        <translation>Den Bereich Statik zeigen</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>Show the panel that compares runs</source>
        <translation>Den Bereich zum Vergleichen von Fahrten zeigen</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Show every step that can be undone</source>
        <translation>Alle Schritte zeigen, die sich rückgängig machen lassen</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Probleme</translation>
    </message>
    <message>
        <source>Show the problems panel</source>
        <translation>Den Bereich Probleme zeigen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zu&amp;letzt verwendet</translation>
    </message>
    <message>
        <source>Open &amp;example</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
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
        <source>T&amp;heme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Fahrt</translation>
    </message>
    <message>
        <source>&amp;Analyze</source>
        <translation>A&amp;nalyse</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Clear list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Save 3D view</source>
        <translation>3-D-Ansicht speichern</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written. Check that the folder exists and can be written, and that the name ends in .png.</source>
        <translation>%1 konnte nicht geschrieben werden. Prüfen, ob der Ordner vorhanden und beschreibbar ist und der Name auf .png endet.</translation>
    </message>
    <message>
        <source>Joint graph</source>
        <translation>Gelenkgraph</translation>
    </message>
    <message>
        <source>&amp;Film of the 3D view...</source>
        <translation>&amp;Film der 3D-Ansicht...</translation>
    </message>
    <message>
        <source>Save the run as MP4, WebM or GIF, as fast as it is played, by ffmpeg</source>
        <translation>Die Fahrt als MP4, WebM oder GIF speichern, so schnell wie abgespielt, mit ffmpeg</translation>
    </message>
    <message>
        <source>&amp;Design</source>
        <translation>&amp;Entwerfen</translation>
    </message>
    <message>
        <source>Parts and mobility, the 3D view as large as it goes</source>
        <translation>Teile und Laufgrad, die 3D-Ansicht so groß wie möglich</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Simulieren</translation>
    </message>
    <message>
        <source>The 3D view over run and plots</source>
        <translation>Die 3D-Ansicht über Fahrt und Diagrammen</translation>
    </message>
    <message>
        <source>Plots as large as they go beside the table of runs</source>
        <translation>Diagramme so groß wie möglich neben der Tabelle der Fahrten</translation>
    </message>
    <message>
        <source>Find e&amp;xact joints</source>
        <translation>E&amp;xakte Gelenke suchen</translation>
    </message>
    <message>
        <source>Search joints to free so that nothing is redundant</source>
        <translation>Gelenke suchen, die zu lösen sind, damit nichts redundant ist</translation>
    </message>
    <message>
        <source>&amp;Free motions</source>
        <translation>&amp;Freie Bewegungen</translation>
    </message>
    <message>
        <source>Show how the rover can move</source>
        <translation>Zeigen, wie der Rover sich bewegen kann</translation>
    </message>
    <message>
        <source>Joint &amp;graph</source>
        <translation>Gelenk&amp;graph</translation>
    </message>
    <message>
        <source>Draw bodies and joints as a graph</source>
        <translation>Körper und Gelenke als Graph zeichnen</translation>
    </message>
    <message>
        <source>&amp;Arrangement</source>
        <translation>&amp;Anordnung</translation>
    </message>
    <message>
        <source>Save film of the 3D view</source>
        <translation>Film der 3D-Ansicht speichern</translation>
    </message>
    <message>
        <source>Films (*.mp4 *.webm *.gif)</source>
        <translation>Filme (*.mp4 *.webm *.gif)</translation>
    </message>
    <message>
        <source>Filming...</source>
        <translation>Filmt...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>&amp;Channels as CSV...</source>
        <translation>&amp;Kanäle als CSV ...</translation>
    </message>
    <message>
        <source>Write chosen channels of the visible time, or all of it, as a table</source>
        <translation>Gewählte Kanäle der sichtbaren oder der ganzen Zeit als Tabelle schreiben</translation>
    </message>
    <message>
        <source>Add recordin&amp;g to compare...</source>
        <translation>Auf&amp;zeichnung zum Vergleich hinzufügen ...</translation>
    </message>
    <message>
        <source>Hold a recording beside the run on show; the project stays</source>
        <translation>Eine Aufzeichnung neben die gezeigte Fahrt stellen; das Projekt bleibt</translation>
    </message>
    <message>
        <source>Parameters and properties</source>
        <translation>Parameter und Eigenschaften</translation>
    </message>
    <message>
        <source>Text size %1 %</source>
        <translation>Textgröße %1 %</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Larger text in all panels, plots and dialogs</source>
        <translation>Größerer Text in allen Feldern, Diagrammen und Dialogen</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Smaller text in all panels, plots and dialogs</source>
        <translation>Kleinerer Text in allen Feldern, Diagrammen und Dialogen</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Wie im System</translation>
    </message>
    <message>
        <source>Text as large as the system has it</source>
        <translation>Text so groß, wie das System ihn hat</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Te&amp;xtgröße</translation>
    </message>
    <message>
        <source>Recover &amp;unsaved work...</source>
        <translation>&amp;Ungespeichertes wiederherstellen ...</translation>
    </message>
    <message>
        <source>Fetch what sessions that ended badly left unsaved</source>
        <translation>Holt, was schlecht beendete Sitzungen ungespeichert hinterließen</translation>
    </message>
    <message>
        <source>&amp;User guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>What every panel shows and every key does</source>
        <translation>Was jedes Feld zeigt und jede Taste tut</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>Five minutes with SOLERO; again: ends it</source>
        <translation>Fünf Minuten mit SOLERO; noch einmal: beendet ihn</translation>
    </message>
    <message>
        <source>&amp;Next step of the tour</source>
        <translation>&amp;Nächster Schritt des Rundgangs</translation>
    </message>
    <message>
        <source>Add to the selected body: %1</source>
        <translation>Zum gewählten Körper hinzufügen: %1</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
</context>
<context>
    <name>widgets::MassPanel</name>
    <message>
        <source>Mass of the rover</source>
        <translation>Masse des Rovers</translation>
    </message>
    <message>
        <source>Wheelbase and track</source>
        <translation>Radstand und Spurweite</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Wheelbase, track</source>
        <translation>Radstand, Spurweite</translation>
    </message>
    <message>
        <source>Centre of mass %1</source>
        <translation>Schwerpunkt %1</translation>
    </message>
    <message>
        <source>Of the whole rover, in the rover frame. Editing it moves the centre of mass of the chassis.</source>
        <translation>Des ganzen Rovers, im Rover-Koordinatensystem. Eine Änderung verschiebt den Schwerpunkt des Chassis.</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Masses of the bodies</source>
        <translation>Massen der Körper</translation>
    </message>
    <message>
        <source>unknown while the project has problems</source>
        <translation>unbekannt, solange das Projekt Probleme hat</translation>
    </message>
    <message>
        <source>Move the centre of mass</source>
        <translation>Schwerpunkt verschieben</translation>
    </message>
</context>
<context>
    <name>widgets::MobilityList</name>
    <message>
        <source>holds the turn about %1</source>
        <translation>hält die Drehung um %1</translation>
    </message>
    <message>
        <source>couples two joints</source>
        <translation>koppelt zwei Gelenke</translation>
    </message>
    <message>
        <source>holds the slide along %1</source>
        <translation>hält die Verschiebung entlang %1</translation>
    </message>
    <message>
        <source>torque about %1: not only from the loads</source>
        <translation>Moment um %1: nicht allein aus den Lasten</translation>
    </message>
    <message>
        <source>torque of the gear: not only from the loads</source>
        <translation>Moment des Getriebes: nicht allein aus den Lasten</translation>
    </message>
    <message>
        <source>force along %1: not only from the loads</source>
        <translation>Kraft entlang %1: nicht allein aus den Lasten</translation>
    </message>
    <message>
        <source>Constraints that could go</source>
        <translation>Bedingungen, die entfallen könnten</translation>
    </message>
    <message>
        <source>Loops, one at a time</source>
        <translation>Schleifen, einzeln</translation>
    </message>
    <message>
        <source>Reactions and self-stress</source>
        <translation>Reaktionen und Eigenspannung</translation>
    </message>
    <message>
        <source>What lies behind the counts</source>
        <translation>Was hinter den Zahlen steht</translation>
    </message>
    <message>
        <source>No constraint repeats what others hold.</source>
        <translation>Keine Bedingung wiederholt, was andere halten.</translation>
    </message>
    <message>
        <source>Removing any one of these gives no new motion. The bar is the constraint&apos;s share in the self-stress: 100 % is wholly redundant.</source>
        <translation>Entfällt eine davon, entsteht keine neue Bewegung. Der Balken ist der Anteil der Bedingung an der Eigenspannung: 100 % ist ganz redundant.</translation>
    </message>
    <message>
        <source>No joints form a loop.</source>
        <translation>Keine Gelenke bilden eine Schleife.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 loops&lt;/b&gt;, each counted alone with one of its bodies held</source>
        <translation>&lt;b&gt;%1 Schleifen&lt;/b&gt;, jede für sich gezählt, einer ihrer Körper gehalten</translation>
    </message>
    <message>
        <source>The shortest independent loops. The ground is one body, a wheel&apos;s contact a joint to it. What is redundant in the whole may be more than in the loops.</source>
        <translation>Die kürzesten unabhängigen Schleifen. Der Boden ist ein Körper, der Kontakt eines Rades ein Gelenk zu ihm. Im Ganzen kann mehr redundant sein als in den Schleifen.</translation>
    </message>
    <message>
        <source>Grübler %1, rank %2, mobility %3, redundant %4</source>
        <translation>Grübler %1, Rang %2, Laufgrad %3, redundant %4</translation>
    </message>
    <message>
        <source>Gear %1: %2</source>
        <translation>Getriebe %1: %2</translation>
    </message>
    <message>
        <source>Loop %1: %2</source>
        <translation>Schleife %1: %2</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>%1 redundant</source>
        <translation>%1 redundant</translation>
    </message>
    <message>
        <source>Known: components of the reaction that every equilibrium has in common. The bar is the part of the self-stress that is in the joint, 100 % over all joints.</source>
        <translation>Bekannt: Komponenten der Reaktion, die in jedem Gleichgewicht gleich sind. Der Balken ist der Teil der Eigenspannung, der im Gelenk steckt, 100 % über alle Gelenke.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 known</source>
        <translation>%1: %2 von %3 bekannt</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 removable&lt;/b&gt;, %2 of them together</source>
        <translation>&lt;b&gt;%1 entbehrlich&lt;/b&gt;, davon %2 zugleich</translation>
    </message>
    <message>
        <source>&lt;b&gt;1 loop&lt;/b&gt;, counted alone with one body held</source>
        <translation>&lt;b&gt;1 Schleife&lt;/b&gt;, für sich gezählt, ein Körper gehalten</translation>
    </message>
</context>
<context>
    <name>widgets::MobilityPanel</name>
    <message>
        <source>Joints by their freedoms, wheel contacts counted:</source>
        <translation>Gelenke nach ihren Freiheiten, Radkontakte mitgezählt:</translation>
    </message>
    <message>
        <source>Verdict on mobility</source>
        <translation>Urteil zum Laufgrad</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Wie gebaut</translation>
    </message>
    <message>
        <source>Relaxed</source>
        <translation>Gelockert</translation>
    </message>
    <message>
        <source>Every joint with the freedoms it has in the rover</source>
        <translation>Jedes Gelenk mit den Freiheiten, die es im Rover hat</translation>
    </message>
    <message>
        <source>With the extra freedoms that the project gives joints for statics</source>
        <translation>Mit den zusätzlichen Freiheiten, die das Projekt den Gelenken für die Statik gibt</translation>
    </message>
    <message>
        <source>Grübler count</source>
        <translation>Laufgrad nach Grübler</translation>
    </message>
    <message>
        <source>Bodies, joints</source>
        <translation>Körper, Gelenke</translation>
    </message>
    <message>
        <source>Welded parts merged; wheel contacts and differentials counted as joints</source>
        <translation>Verschweißtes zusammengefasst; Radkontakte und Differenziale zählen als Gelenke</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>Zwangsbedingungen</translation>
    </message>
    <message>
        <source>Rows of the constraint Jacobian</source>
        <translation>Zeilen der Jacobi-Matrix der Zwangsbedingungen</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Mobility</source>
        <translation>Laufgrad</translation>
    </message>
    <message>
        <source>Redundant</source>
        <translation>Redundant</translation>
    </message>
    <message>
        <source>Constraints minus rank: 0 = statically determinate</source>
        <translation>Zwangsbedingungen minus Rang: 0 = statisch bestimmt</translation>
    </message>
    <message>
        <source>Mobility cannot be worked out: the project has problems.
They are listed under Problems.</source>
        <translation>Der Laufgrad lässt sich nicht bestimmen: Das Projekt hat Probleme.
Sie stehen unter Probleme.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Statically determinate</source>
        <translation>Statisch bestimmt</translation>
    </message>
    <message>
        <source>Cannot move</source>
        <translation>Unbeweglich</translation>
    </message>
    <message>
        <source>Hyperstatic: 1 redundant constraint</source>
        <translation>Überbestimmt: 1 redundante Bedingung</translation>
    </message>
    <message>
        <source>Hyperstatic: %1 redundant constraints</source>
        <translation>Überbestimmt: %1 redundante Bedingungen</translation>
    </message>
    <message>
        <source>Determinate, 1 idle freedom</source>
        <translation>Bestimmt, 1 leere Freiheit</translation>
    </message>
    <message>
        <source>Determinate, %1 idle freedoms</source>
        <translation>Bestimmt, %1 leere Freiheiten</translation>
    </message>
    <message>
        <source>Cannot move: the constraints hold every body.</source>
        <translation>Unbeweglich: Die Zwangsbedingungen halten jeden Körper.</translation>
    </message>
    <message>
        <source>Moves with one freedom, as a rover on its wheels should.</source>
        <translation>Bewegt sich mit einer Freiheit, wie es sich für einen Rover auf Rädern gehört.</translation>
    </message>
    <message>
        <source>Moves with %1 freedoms.</source>
        <translation>Bewegt sich mit %1 Freiheiten.</translation>
    </message>
    <message>
        <source>Hyperstatic: 1 constraint repeats what others already hold. Its reaction cannot be told from statics, and inaccurate parts strain each other.</source>
        <translation>Überbestimmt: 1 Zwangsbedingung wiederholt, was andere schon halten. Ihre Reaktion folgt nicht aus der Statik, und ungenaue Teile verspannen einander.</translation>
    </message>
    <message>
        <source>Hyperstatic: %1 constraints repeat what others already hold. Their reactions cannot be told from statics, and inaccurate parts strain each other.</source>
        <translation>Überbestimmt: %1 Zwangsbedingungen wiederholen, was andere schon halten. Ihre Reaktionen folgen nicht aus der Statik, und ungenaue Teile verspannen einander.</translation>
    </message>
    <message>
        <source>Statically determinate: every reaction follows from the loads.</source>
        <translation>Statisch bestimmt: Jede Reaktion folgt aus den Lasten.</translation>
    </message>
    <message>
        <source>The Grübler count (%1) cannot see this.</source>
        <translation>Der Laufgrad nach Grübler (%1) kann das nicht zeigen.</translation>
    </message>
    <message>
        <source>1 of the freedoms is idle: neither chassis nor wheels move.</source>
        <translation>1 der Freiheiten ist leer: Weder Chassis noch Räder bewegen sich.</translation>
    </message>
    <message>
        <source>%1 of the freedoms are idle: neither chassis nor wheels move.</source>
        <translation>%1 der Freiheiten sind leer: Weder Chassis noch Räder bewegen sich.</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>How much it moves, and what is redundant</source>
        <translation>Wie beweglich er ist und was redundant ist</translation>
    </message>
    <message>
        <source>Exact joints</source>
        <translation>Exakte Gelenke</translation>
    </message>
    <message>
        <source>Which joints to free so that nothing is redundant</source>
        <translation>Welche Gelenke zu lösen sind, damit nichts redundant ist</translation>
    </message>
    <message>
        <source>Free motions</source>
        <translation>Freie Bewegungen</translation>
    </message>
    <message>
        <source>How it moves, to look at</source>
        <translation>Wie er sich bewegt, zum Ansehen</translation>
    </message>
    <message>
        <source>Whole rover</source>
        <translation>Ganzer Rover</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>What the counts are of</source>
        <translation>Wovon die Zahlen sind</translation>
    </message>
    <message>
        <source>The whole rover, or only the parts selected in the tree and the joints between them</source>
        <translation>Der ganze Rover, oder nur die im Baum gewählten Teile und die Gelenke zwischen ihnen</translation>
    </message>
    <message>
        <source>Nothing to count</source>
        <translation>Nichts zu zählen</translation>
    </message>
    <message>
        <source>Select parts that a joint connects, a joint, or a wheel with its contact: in the tree with Ctrl, or in the 3-D view.</source>
        <translation>Teile wählen, die ein Gelenk verbindet, ein Gelenk oder ein Rad mit seinem Kontakt: mit Strg im Baum oder in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>%1 pieces that no joint connects.</source>
        <translation>%1 Stücke, die kein Gelenk verbindet.</translation>
    </message>
    <message>
        <source>Nothing in it moves.</source>
        <translation>Nichts darin bewegt sich.</translation>
    </message>
    <message>
        <source>With %1 held nothing in it moves.</source>
        <translation>Ist %1 gehalten, bewegt sich nichts darin.</translation>
    </message>
    <message>
        <source>It moves with 1 freedom.</source>
        <translation>Es bewegt sich mit 1 Freiheit.</translation>
    </message>
    <message>
        <source>It moves with %1 freedoms.</source>
        <translation>Es bewegt sich mit %1 Freiheiten.</translation>
    </message>
    <message>
        <source>With %1 held it moves with 1 freedom.</source>
        <translation>Ist %1 gehalten, bewegt es sich mit 1 Freiheit.</translation>
    </message>
    <message>
        <source>With %1 held it moves with %2 freedoms.</source>
        <translation>Ist %1 gehalten, bewegt es sich mit %2 Freiheiten.</translation>
    </message>
    <message>
        <source>1 of its constraints repeats what its others already hold.</source>
        <translation>1 seiner Bedingungen wiederholt, was die anderen schon halten.</translation>
    </message>
    <message>
        <source>%1 of its constraints repeat what its others already hold.</source>
        <translation>%1 seiner Bedingungen wiederholen, was die anderen schon halten.</translation>
    </message>
    <message>
        <source>Nothing in it is redundant.</source>
        <translation>Nichts darin ist redundant.</translation>
    </message>
    <message>
        <source>Every reaction follows from the loads.</source>
        <translation>Jede Reaktion folgt aus den Lasten.</translation>
    </message>
    <message>
        <source>Of %1 components of reactions the loads determine %2. The others cannot be known: they depend on play, stiffness and errors of manufacture.</source>
        <translation>Von %1 Komponenten der Reaktionen bestimmen die Lasten %2. Die anderen kann man nicht kennen: Sie hängen von Spiel, Steifigkeit und Fertigungsfehlern ab.</translation>
    </message>
    <message>
        <source>Nothing is known of %1.</source>
        <translation>Nichts ist bekannt von %1.</translation>
    </message>
    <message>
        <source>Nothing is known of %1 and %2 more.</source>
        <translation>Nichts ist bekannt von %1 und %2 weiteren.</translation>
    </message>
    <message>
        <source>Verdict on mobility, in words</source>
        <translation>Urteil über die Beweglichkeit, in Worten</translation>
    </message>
    <message>
        <source>6 n minus the constraints: what counting alone says. Lamon et al. 2004, equation 1</source>
        <translation>6 n minus die Bedingungen: was bloßes Zählen ergibt. Lamon u. a. 2004, Gleichung 1</translation>
    </message>
    <message>
        <source>Constraints that are independent of each other: rank of the Jacobian J with J v = 0</source>
        <translation>Bedingungen, die voneinander unabhängig sind: Rang der Jacobi-Matrix J mit J v = 0</translation>
    </message>
    <message>
        <source>Freedoms the rover truly has: 6 n − rank J</source>
        <translation>Freiheiten, die der Rover wirklich hat: 6 n − Rang J</translation>
    </message>
    <message>
        <source>contact %1</source>
        <translation>Kontakt %1</translation>
    </message>
</context>
<context>
    <name>widgets::MotionPage</name>
    <message>
        <source>Idle: %1</source>
        <translation>Müßig: %1</translation>
    </message>
    <message>
        <source>The rover only yields here: constraints that are redundant as drawn hold after any real step. There is nothing to show.</source>
        <translation>Der Rover gibt hier nur nach: Zwangsbedingungen, die wie gezeichnet redundant sind, halten nach jedem wirklichen Schritt. Es gibt nichts zu zeigen.</translation>
    </message>
    <message>
        <source>Idle: chassis and wheels stand still. The body that turns is marked.</source>
        <translation>Müßig: Chassis und Räder stehen still. Der Körper, der sich dreht, ist markiert.</translation>
    </message>
    <message>
        <source>Only together with other free motions: the drawn pose is a branching point.</source>
        <translation>Nur zusammen mit anderen freien Bewegungen: Die gezeichnete Lage ist ein Verzweigungspunkt.</translation>
    </message>
    <message>
        <source>Loops and wheel contacts stay closed. Largest travel 5 % of the wheelbase, or 0.5 rad.</source>
        <translation>Schleifen und Radkontakte bleiben geschlossen. Größter Weg 5 % des Radstands, oder 0.5 rad.</translation>
    </message>
    <message>
        <source>Free motions</source>
        <translation>Freie Bewegungen</translation>
    </message>
    <message>
        <source>Number of free motions</source>
        <translation>Zahl der freien Bewegungen</translation>
    </message>
    <message>
        <source>What to know of this motion</source>
        <translation>Was man von dieser Bewegung wissen sollte</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Wie gebaut</translation>
    </message>
    <message>
        <source>Relaxed</source>
        <translation>Gelockert</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Schwingen</translation>
    </message>
    <message>
        <source>Swing along the free motion</source>
        <translation>Entlang der freien Bewegung schwingen</translation>
    </message>
    <message>
        <source>Swing the bodies to and fro along the chosen motion</source>
        <translation>Die Körper entlang der gewählten Bewegung hin und her schwingen</translation>
    </message>
    <message>
        <source>Next free motion</source>
        <translation>Nächste freie Bewegung</translation>
    </message>
    <message>
        <source>No free motion</source>
        <translation>Keine freie Bewegung</translation>
    </message>
    <message>
        <source>The constraints hold every body: the rover cannot move without slipping or straining.</source>
        <translation>Die Zwangsbedingungen halten jeden Körper: Der Rover kann sich nicht bewegen, ohne zu rutschen oder sich zu verspannen.</translation>
    </message>
    <message>
        <source>Free motion %1 of %2</source>
        <translation>Freie Bewegung %1 von %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>widgets::NewRoverDialog</name>
    <message>
        <source>New rover</source>
        <translation>Neuer Rover</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topologie</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>%1 to %2 %3 · %4</source>
        <translation>%1 bis %2 %3 · %4</translation>
    </message>
    <message>
        <source>it is less than %1.</source>
        <translation>weniger als %1.</translation>
    </message>
    <message>
        <source>it is more than %1.</source>
        <translation>mehr als %1.</translation>
    </message>
    <message>
        <source>Stay within the range.</source>
        <translation>Im erlaubten Bereich bleiben.</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mobility %1&lt;/b&gt;, %2 redundant · Grübler count %3, %4 rows, rank %5 · %6 bodies, %7 wheels, %8 kg</source>
        <translation>&lt;b&gt;Laufgrad %1&lt;/b&gt;, %2 redundant · nach Grübler %3, %4 Zeilen, Rang %5 · %6 Körper, %7 Räder, %8 kg</translation>
    </message>
    <message>
        <source>These dimensions do not go together.</source>
        <translation>Diese Maße passen nicht zusammen.</translation>
    </message>
</context>
<context>
    <name>widgets::ParameterPanel</name>
    <message>
        <source>Range: %1 to %2 %3</source>
        <translation>Bereich: %1 bis %2 %3</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>This rover has no parameters.</source>
        <translation>Dieser Rover hat keine Parameter.</translation>
    </message>
    <message>
        <source>Filter parameters</source>
        <translation>Parameter filtern</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Slider of %1</source>
        <translation>Schieber von %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
</context>
<context>
    <name>widgets::PartsPanel</name>
    <message>
        <source>Search parts</source>
        <translation>Teile suchen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a part</source>
        <translation>Ein Teil hinzufügen</translation>
    </message>
</context>
<context>
    <name>widgets::PartsTree</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>Räder</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>Differentials</source>
        <translation>Differenziale</translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation>Nutzlasten</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Szenarien</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>Drehgelenk</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>Schubgelenk</translation>
    </message>
    <message>
        <source>%1 freedoms</source>
        <translation>%1 Freiheiten</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>Differential</source>
        <translation>Differenzial</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>Parts of the project</source>
        <translation>Teile des Projekts</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>Radius %1</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>In %1 umbenennen</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>%1 kopiert</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 ausschneiden</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>It is mirrored already.</source>
        <translation>Es ist schon gespiegelt.</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 trennen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>The first body is the chassis: that is %1 now.</source>
        <translation>Der erste Körper ist das Chassis: jetzt ist das %1.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>shape</comment>
        <extracomment>Kind of a shape and its place among those of the body: &quot;Box 2&quot;.</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>shape</comment>
        <extracomment>A shape of a body: &quot;box 2 of chassis&quot;.</extracomment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>A shape has no name.</source>
        <translation>Eine Form hat keinen Namen.</translation>
    </message>
</context>
<context>
    <name>widgets::PlotPanel</name>
    <message>
        <source>Values at the cursor</source>
        <translation>Werte am Zeiger</translation>
    </message>
    <message>
        <source>Time at the cursor</source>
        <translation>Zeit am Zeiger</translation>
    </message>
    <message>
        <source>Runs and their lines</source>
        <translation>Fahrten und ihre Linien</translation>
    </message>
    <message>
        <source>Number of plots</source>
        <translation>Anzahl der Diagramme</translation>
    </message>
    <message>
        <source>1 plot</source>
        <translation>1 Diagramm</translation>
    </message>
    <message>
        <source>%1 plots</source>
        <translation>%1 Diagramme</translation>
    </message>
    <message>
        <source>Time window</source>
        <translation>Zeitfenster</translation>
    </message>
    <message>
        <source>Drag a plot to pan, turn the wheel to zoom: then the window is free and stays put</source>
        <translation>Ein Diagramm ziehen verschiebt es, das Mausrad zoomt: dann ist das Fenster frei und bleibt stehen</translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation>Ganze Fahrt</translation>
    </message>
    <message>
        <source>Last %1 s</source>
        <translation>Letzte %1 s</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Export CSV...</source>
        <translation>CSV exportieren ...</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Bild speichern ...</translation>
    </message>
    <message>
        <source>Quantity of plot %1</source>
        <translation>Größe in Diagramm %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Show or hide the curves of %1</source>
        <translation>Die Kurven von %1 zeigen oder verbergen</translation>
    </message>
    <message>
        <source>%1, plot %2</source>
        <translation>%1, Diagramm %2</translation>
    </message>
    <message>
        <source>rover</source>
        <translation>Rover</translation>
    </message>
    <message>
        <source>Rover, plot %1</source>
        <translation>Rover, Diagramm %1</translation>
    </message>
    <message>
        <source>Values at %1 s</source>
        <translation>Werte bei %1 s</translation>
    </message>
    <message>
        <source>The recording ends before its first numbers</source>
        <translation>Die Aufzeichnung endet vor ihren ersten Zahlen</translation>
    </message>
    <message>
        <source>Press Space to drive:
every wheel&apos;s curve appears here</source>
        <translation>Mit der Leertaste losfahren:
Hier erscheint die Kurve jedes Rades</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>There is no run to export yet. Press Space to drive first.</source>
        <translation>Es gibt noch keine Fahrt zum Exportieren. Zuerst mit der Leertaste losfahren.</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV-Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save picture of the plots</source>
        <translation>Bild der Diagramme speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Bilder (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>From %1 to %2 s: change in %3 s</source>
        <translation>Von %1 bis %2 s: Änderung in %3 s</translation>
    </message>
    <message>
        <source>After equations 5 and 6 of Lamon et al. 2004</source>
        <translation>Nach Gleichung 5 und 6 von Lamon u. a. 2004</translation>
    </message>
</context>
<context>
    <name>widgets::ProblemsPanel</name>
    <message>
        <source>No problems.</source>
        <translation>Keine Probleme.</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Hidden advice</source>
        <translation>Ausgeblendete Ratschläge</translation>
    </message>
    <message>
        <source>Choose a kind of advice to show it again</source>
        <translation>Eine Art von Rat wählen, um sie wieder zu zeigen</translation>
    </message>
    <message>
        <source>Find exact joints</source>
        <translation>Exakte Gelenke suchen</translation>
    </message>
    <message>
        <source>Fix %1: %2</source>
        <translation>%1 beheben: %2</translation>
    </message>
    <message>
        <source>Fix: %1</source>
        <translation>Beheben: %1</translation>
    </message>
    <message>
        <source>Hide “%1”</source>
        <translation>„%1“ ausblenden</translation>
    </message>
    <message>
        <source>1 kind of advice hidden</source>
        <translation>1 Art von Rat ausgeblendet</translation>
    </message>
    <message>
        <source>%1 kinds of advice hidden</source>
        <translation>%1 Arten von Rat ausgeblendet</translation>
    </message>
    <message>
        <source>Show “%1”</source>
        <translation>„%1“ zeigen</translation>
    </message>
</context>
<context>
    <name>widgets::PropertyPanel</name>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Rename to %1</source>
        <translation>In %1 umbenennen</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Do not mirror %1</source>
        <translation>%1 nicht spiegeln</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>given</source>
        <translation>vorgegeben</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>Lower stop</source>
        <translation>Unterer Anschlag</translation>
    </message>
    <message>
        <source>Upper stop</source>
        <translation>Oberer Anschlag</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>ohne Grenze</translation>
    </message>
    <message>
        <source>%1: a number is needed, not &apos;%2&apos;.</source>
        <translation>%1: Eine Zahl ist nötig, nicht &apos;%2&apos;.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Set another parameter</source>
        <translation>Weiteren Parameter setzen</translation>
    </message>
    <message>
        <source>Set another parameter...</source>
        <translation>Weiteren Parameter setzen ...</translation>
    </message>
    <message>
        <source>Remove %1 %2</source>
        <translation>%1 %2 entfernen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add to %1</source>
        <translation>%1: hinzufügen</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Select a part in the tree
or in the 3D view to edit it.</source>
        <translation>Zum Bearbeiten ein Teil im Baum
oder in der 3-D-Ansicht auswählen.</translation>
    </message>
    <message>
        <source>Edit this shape</source>
        <translation>Diese Form bearbeiten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>shape</comment>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>widgets::RecordingCommands</name>
    <message>
        <source>Recordings (*.roverrec *.roverrec.part)</source>
        <translation>Aufzeichnungen (*.roverrec *.roverrec.part)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>The recording cannot be opened</source>
        <translation>Die Aufzeichnung lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>The recording is not whole</source>
        <translation>Die Aufzeichnung ist nicht vollständig</translation>
    </message>
    <message>
        <source>The run cannot be saved</source>
        <translation>Die Fahrt lässt sich nicht speichern</translation>
    </message>
    <message>
        <source>Save recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Recordings (*.roverrec)</source>
        <translation>Aufzeichnungen (*.roverrec)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>The run was not saved</source>
        <translation>Die Fahrt wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Running the recorded run again</source>
        <translation>Die aufgezeichnete Fahrt wird nachgefahren</translation>
    </message>
    <message>
        <source>The recording cannot be run again</source>
        <translation>Die Aufzeichnung lässt sich nicht nachfahren</translation>
    </message>
    <message>
        <source>Run again and compare</source>
        <translation>Nachfahren und vergleichen</translation>
    </message>
    <message>
        <source>The same run.</source>
        <translation>Dieselbe Fahrt.</translation>
    </message>
    <message>
        <source>Another run.</source>
        <translation>Eine andere Fahrt.</translation>
    </message>
    <message>
        <source>%1 s were run again, to the last bit as recorded. State hash %2.</source>
        <translation>%1 s wurden nachgefahren, bis aufs letzte Bit wie aufgezeichnet. Zustands-Hash %2.</translation>
    </message>
    <message>
        <source>It is the same for the first %1 s, and differs at %2 s. State hash %3 was recorded, %4 came out.</source>
        <translation>Die ersten %1 s sind gleich, bei %2 s weicht sie ab. Aufgezeichnet ist der Zustands-Hash %3, heraus kam %4.</translation>
    </message>
    <message>
        <source>an earlier end</source>
        <translation>ein früheres Ende</translation>
    </message>
    <message>
        <source>It was recorded with version %1, this is %2.</source>
        <translation>Aufgezeichnet wurde sie mit Version %1, dies ist %2.</translation>
    </message>
    <message>
        <source>Add recording to compare</source>
        <translation>Aufzeichnung zum Vergleich hinzufügen</translation>
    </message>
</context>
<context>
    <name>widgets::RecoveryDialog</name>
    <message>
        <source>Unsaved work found</source>
        <translation>Ungesicherte Arbeit gefunden</translation>
    </message>
    <message>
        <source>RoverStudio did not end well. This project has changes that were not saved:</source>
        <translation>RoverStudio ist nicht ordentlich beendet worden. Dieses Projekt hat ungesicherte Änderungen:</translation>
    </message>
    <message>
        <source>RoverStudio did not end well. These projects have changes that were not saved:</source>
        <translation>RoverStudio ist nicht ordentlich beendet worden. Diese Projekte haben ungesicherte Änderungen:</translation>
    </message>
    <message>
        <source>Projects with unsaved changes</source>
        <translation>Projekte mit ungesicherten Änderungen</translation>
    </message>
    <message>
        <source>%1 (never saved)</source>
        <translation>%1 (nie gespeichert)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Throw away...</source>
        <translation>&amp;Verwerfen...</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Throw away the changes to %1? They cannot be brought back.</source>
        <translation>Die Änderungen an %1 verwerfen? Sie sind dann nicht wiederzubekommen.</translation>
    </message>
    <message>
        <source>Asks again at the next start; until then: File &gt; Recover unsaved work</source>
        <translation>Fragt beim nächsten Start wieder; bis dahin: Datei &gt; Ungespeichertes wiederherstellen</translation>
    </message>
</context>
<context>
    <name>widgets::RoverSketch</name>
    <message>
        <source>The rover from the side</source>
        <translation>Der Rover von der Seite</translation>
    </message>
</context>
<context>
    <name>widgets::RunBar</name>
    <message>
        <source>%1 m driven, slip %2 m, %3 J</source>
        <translation>%1 m, Schlupf %2 m, %3 J</translation>
    </message>
    <message>
        <source>Completed: %1</source>
        <translation>Am Ziel: %1</translation>
    </message>
    <message>
        <source>Time is up: %1</source>
        <translation>Zeit abgelaufen: %1</translation>
    </message>
    <message>
        <source>Stuck: %1</source>
        <translation>Steckt fest: %1</translation>
    </message>
    <message>
        <source>Stopped, the simulation failed: %1</source>
        <translation>Angehalten, die Simulation ist gescheitert: %1</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Angehalten: %1</translation>
    </message>
    <message>
        <source>Recording, incomplete: up to %1 s</source>
        <translation>Aufzeichnung, unvollständig: bis %1 s</translation>
    </message>
    <message>
        <source>Recording of the first %1 s of a run</source>
        <translation>Aufzeichnung der ersten %1 s einer Fahrt</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>ODE: Open Dynamics Engine, friction by boxes. Reduced: free rates only, Coulomb&apos;s cone, several times faster</source>
        <translation>ODE: Open Dynamics Engine, Reibung als Pyramide. Reduziert: nur freie Geschwindigkeiten, Coulombscher Reibkegel, um ein Mehrfaches schneller</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Engine</translation>
    </message>
    <message>
        <source>Coulomb coefficient between wheel and ground</source>
        <translation>Reibungszahl nach Coulomb zwischen Rad und Boden</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation>Zustand der Fahrt</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>Drag to look at any instant of the run</source>
        <translation>Ziehen, um einen beliebigen Zeitpunkt der Fahrt anzusehen</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>schnellstens</translation>
    </message>
    <message>
        <source>Playback speed; never changes the numbers (+ and - keys)</source>
        <translation>Wiedergabetempo; ändert nie die Zahlen (Tasten + und -)</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Wiedergabetempo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Real-time factor</source>
        <translation>Echtzeitfaktor</translation>
    </message>
    <message>
        <source>Simulated time over clock time</source>
        <translation>Simulierte Zeit durch Uhrzeit</translation>
    </message>
    <message>
        <source>RTF %1</source>
        <translation>RTF %1</translation>
    </message>
    <message>
        <source>ahead %1 m/s</source>
        <translation>vor %1 m/s</translation>
    </message>
    <message>
        <source>back %1 m/s</source>
        <translation>zurück %1 m/s</translation>
    </message>
    <message>
        <source>left %1 °/s</source>
        <translation>links %1 °/s</translation>
    </message>
    <message>
        <source>right %1 °/s</source>
        <translation>rechts %1 °/s</translation>
    </message>
    <message>
        <source>Driving: %1</source>
        <translation>Fährt: %1</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Fahren</translation>
    </message>
    <message>
        <source>Edited since this run: play starts a new one</source>
        <translation>Seit dieser Fahrt geändert: Fahren beginnt eine neue</translation>
    </message>
    <message>
        <source>Ready: press Space to drive</source>
        <translation>Bereit: Leertaste zum Losfahren</translation>
    </message>
    <message>
        <source>Drive with W A S D, arrow keys or gamepad</source>
        <translation>Mit W A S D, Pfeiltasten oder Gamepad fahren</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2 s</translation>
    </message>
    <message>
        <source>Speed control</source>
        <translation>Geschwindigkeitsregelung</translation>
    </message>
    <message>
        <source>Synchronised speeds</source>
        <translation>Gleichlauf der Räder</translation>
    </message>
    <message>
        <source>Common integral</source>
        <translation>Gemeinsamer I-Anteil</translation>
    </message>
    <message>
        <source>Equal torque</source>
        <translation>Gleiches Drehmoment</translation>
    </message>
    <message>
        <source>Torque control</source>
        <translation>Drehmomentregelung</translation>
    </message>
    <message>
        <source>Hybrid</source>
        <translation>Hybrid</translation>
    </message>
    <message>
        <source>Manual (W A S D)</source>
        <translation>Von Hand (W A S D)</translation>
    </message>
    <message>
        <source>ODE</source>
        <translation>ODE</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>μ %1</source>
        <translation>μ %1</translation>
    </message>
    <message>
        <source>Shares a common torque by the wheels&apos; loads: equation 4 of Lamon et al. 2004</source>
        <translation>Teilt ein gemeinsames Moment nach den Radlasten auf: Gleichung 4 von Lamon u. a. 2004</translation>
    </message>
</context>
<context>
    <name>widgets::StaticsPanel</name>
    <message>
        <source>Statics</source>
        <translation>Statik</translation>
    </message>
    <message>
        <source>Why there are no statics</source>
        <translation>Warum es keine Statik gibt</translation>
    </message>
    <message>
        <source>Required friction</source>
        <translation>Nötige Reibung</translation>
    </message>
    <message>
        <source>required friction</source>
        <translation>nötige Reibung</translation>
    </message>
    <message>
        <source>Whether the ground gives enough friction</source>
        <translation>Ob der Boden genug Reibung bietet</translation>
    </message>
    <message>
        <source>Required friction over the way</source>
        <translation>Nötige Reibung längs des Weges</translation>
    </message>
    <message>
        <source>Place on the way</source>
        <translation>Ort auf dem Weg</translation>
    </message>
    <message>
        <source>Drive the rover along the obstacle; arrow keys, Home and End too</source>
        <translation>Den Rover über das Hindernis fahren; auch mit Pfeiltasten, Pos1 und Ende</translation>
    </message>
    <message>
        <source>Way and x of the chassis</source>
        <translation>Weg und x des Chassis</translation>
    </message>
    <message>
        <source>Way that the wheels have rolled, and x of the chassis&apos; origin</source>
        <translation>Abgerollter Weg der Räder und x des Chassis-Ursprungs</translation>
    </message>
    <message>
        <source>Hardest place</source>
        <translation>Schwerste Stelle</translation>
    </message>
    <message>
        <source>Where the way asks for the most friction, also after edits</source>
        <translation>Wo der Weg die größte Reibung verlangt, auch nach Änderungen</translation>
    </message>
    <message>
        <source>Wheels that limit</source>
        <translation>Begrenzende Räder</translation>
    </message>
    <message>
        <source>Equal torques</source>
        <translation>Gleiche Drehmomente</translation>
    </message>
    <message>
        <source>All wheels have the same torque, whatever they carry</source>
        <translation>Alle Räder haben dasselbe Drehmoment, gleich was sie tragen</translation>
    </message>
    <message>
        <source>Tip-over angle</source>
        <translation>Kippwinkel</translation>
    </message>
    <message>
        <source>Least turn about a line between two wheels until the centre of mass is above it</source>
        <translation>Kleinste Drehung um eine Linie zwischen zwei Rädern, bis der Schwerpunkt darüber liegt</translation>
    </message>
    <message>
        <source>What to know of this place</source>
        <translation>Was zu dieser Stelle zu sagen ist</translation>
    </message>
    <message>
        <source>The whole way</source>
        <translation>Der ganze Weg</translation>
    </message>
    <message>
        <source>Wheels and notes</source>
        <translation>Räder und Anmerkungen</translation>
    </message>
    <message>
        <source>Working out how the rover stands...</source>
        <translation>Der Stand des Rovers wird berechnet ...</translation>
    </message>
    <message>
        <source>Working out the way...</source>
        <translation>Der Weg wird berechnet ...</translation>
    </message>
    <message>
        <source>way %1 m, x %2 m</source>
        <translation>Weg %1 m, x %2 m</translation>
    </message>
    <message>
        <source>μ* –</source>
        <translation>μ* –</translation>
    </message>
    <message>
        <source>Nothing holds the rover</source>
        <translation>Nichts hält den Rover</translation>
    </message>
    <message>
        <source>The rover sits on its body</source>
        <translation>Der Rover sitzt auf</translation>
    </message>
    <message>
        <source>Enough:
the ground gives %1</source>
        <translation>Genug:
der Boden bietet %1</translation>
    </message>
    <message>
        <source>Not enough:
the ground gives %1</source>
        <translation>Zu wenig:
der Boden bietet %1</translation>
    </message>
    <message>
        <source>Here: %1.</source>
        <translation>Hier: %1.</translation>
    </message>
    <message>
        <source>Tip-over angle %1°.</source>
        <translation>Kippwinkel %1°.</translation>
    </message>
    <message>
        <source>there is no ground under it</source>
        <translation>unter ihm ist kein Boden</translation>
    </message>
    <message>
        <source>it tips over</source>
        <translation>er kippt um</translation>
    </message>
    <message>
        <source>its joints cannot follow</source>
        <translation>seine Gelenke können nicht folgen</translation>
    </message>
    <message>
        <source>it comes to no rest</source>
        <translation>er kommt nicht zur Ruhe</translation>
    </message>
    <message>
        <source>No torques hold the rover here.</source>
        <translation>Keine Drehmomente halten den Rover hier.</translation>
    </message>
    <message>
        <source>Hangs in the air: %1.</source>
        <translation>Hängt in der Luft: %1.</translation>
    </message>
    <message>
        <source>About to lift: %1.</source>
        <translation>Hebt gleich ab: %1.</translation>
    </message>
    <message>
        <source>At the torque limit: %1.</source>
        <translation>An der Drehmomentgrenze: %1.</translation>
    </message>
    <message>
        <source>Touches the ground: %1.</source>
        <translation>Berührt den Boden: %1.</translation>
    </message>
    <message>
        <source>At its stop: %1.</source>
        <translation>Am Anschlag: %1.</translation>
    </message>
    <message>
        <source>No equal torque holds the rover here.</source>
        <translation>Kein gleiches Drehmoment hält den Rover hier.</translation>
    </message>
    <message>
        <source>With equal torques a wheel would have to pull on the ground.</source>
        <translation>Bei gleichen Drehmomenten müsste ein Rad am Boden ziehen.</translation>
    </message>
    <message>
        <source>The rover cannot be studied here.

%1: %2
%3</source>
        <translation>Der Rover lässt sich hier nicht untersuchen.

%1: %2
%3</translation>
    </message>
    <message>
        <source>The rover cannot stand at the start of this scenario: %1.</source>
        <translation>Der Rover kann am Anfang dieses Szenarios nicht stehen: %1.</translation>
    </message>
    <message>
        <source>The way ends after %1 m: %2.</source>
        <translation>Der Weg endet nach %1 m: %2.</translation>
    </message>
    <message>
        <source>The way ends after %1 m: the wheels roll on, the rover does not.</source>
        <translation>Der Weg endet nach %1 m: Die Räder rollen weiter, der Rover nicht.</translation>
    </message>
    <message>
        <source>The whole way takes %1.</source>
        <translation>Der ganze Weg verlangt %1.</translation>
    </message>
    <message>
        <source>No friction is enough for the whole way.</source>
        <translation>Für den ganzen Weg genügt keine Reibung.</translation>
    </message>
    <message>
        <source>No wheel needs friction here.</source>
        <translation>Hier braucht kein Rad Reibung.</translation>
    </message>
    <message>
        <source>All wheels that touch limit alike.</source>
        <translation>Alle Räder mit Kontakt begrenzen gleichermaßen.</translation>
    </message>
    <message>
        <source>All wheels that touch limit alike but %1.</source>
        <translation>Alle Räder mit Kontakt begrenzen gleichermaßen, außer %1.</translation>
    </message>
    <message>
        <source>%1 limits.</source>
        <translation>%1 begrenzt.</translation>
    </message>
    <message>
        <source>%1 limit.</source>
        <translation>%1 begrenzen.</translation>
    </message>
    <message>
        <source>Equal torques: %1 N·m each, μ %2.</source>
        <translation>Gleiche Drehmomente: je %1 N·m, μ %2.</translation>
    </message>
    <message>
        <source>Equal torques: %1 N·m each, no friction is enough.</source>
        <translation>Gleiche Drehmomente: je %1 N·m, keine Reibung genügt.</translation>
    </message>
    <message>
        <source>μ* %1</source>
        <translation>μ* %1</translation>
    </message>
    <message>
        <source>μ* &gt; %1</source>
        <translation>μ* &gt; %1</translation>
    </message>
    <message>
        <source>The least friction with which some torques within the motors&apos; limits hold the rover here: the largest T/N of the wheels, made as small as the balances allow. These come from virtual work and say what equations 2 and 3 of Lamon et al. 2004 say</source>
        <translation>Die kleinste Reibung, mit der irgendwelche Momente innerhalb der Motorgrenzen den Rover hier halten: das größte T/N der Räder, so klein, wie es die Gleichgewichte zulassen. Diese kommen aus virtueller Arbeit und sagen, was Gleichung 2 und 3 von Lamon u. a. 2004 sagen</translation>
    </message>
</context>
<context>
    <name>widgets::Tour</name>
    <message>
        <source>Five minutes with SOLERO</source>
        <translation>Fünf Minuten mit SOLERO</translation>
    </message>
    <message>
        <source>This rover climbs steps higher than its wheels, without a motor in its suspension. The tour drives it, and finds what is wrong with its joints. &lt;b&gt;Enter&lt;/b&gt; goes on, &lt;b&gt;Esc&lt;/b&gt; ends it; &lt;i&gt;Help &amp;gt; Tour&lt;/i&gt; brings it back.</source>
        <translation>Dieser Rover steigt auf Stufen, die höher sind als seine Räder, ohne Motor in seinem Fahrwerk. Der Rundgang fährt ihn und findet, was an seinen Gelenken nicht stimmt. &lt;b&gt;Eingabe&lt;/b&gt; führt weiter, &lt;b&gt;Esc&lt;/b&gt; beendet ihn; &lt;i&gt;Hilfe &amp;gt; Rundgang&lt;/i&gt; holt ihn wieder.</translation>
    </message>
    <message>
        <source>That was it</source>
        <translation>Das war es</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+Shift+N&lt;/b&gt; makes a rover of your own from its main dimensions. &lt;b&gt;F1&lt;/b&gt; opens the user guide, &lt;b&gt;Ctrl+F1&lt;/b&gt; lists the keys.</source>
        <translation>&lt;b&gt;Strg+Umschalt+N&lt;/b&gt; macht aus Hauptmaßen einen eigenen Rover. &lt;b&gt;F1&lt;/b&gt; öffnet das Handbuch, &lt;b&gt;Strg+F1&lt;/b&gt; nennt die Tasten.</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Umsehen</translation>
    </message>
    <message>
        <source>Drag in the 3-D view to turn it, drag with the right button to move it, turn the wheel to zoom.</source>
        <translation>In der 3D-Ansicht ziehen dreht sie, mit der rechten Taste ziehen verschiebt sie, das Mausrad vergrößert.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Press &lt;b&gt;Space&lt;/b&gt;: SOLERO drives over rough ground. Arrows show the forces of the ground.</source>
        <translation>&lt;b&gt;Leertaste&lt;/b&gt; drücken: SOLERO fährt über unebenen Boden. Pfeile zeigen die Kräfte des Bodens.</translation>
    </message>
    <message>
        <source>Read the slip</source>
        <translation>Schlupf ablesen</translation>
    </message>
    <message>
        <source>Every wheel has a curve, with a sign and a colour of its own. Click into a plot: the 3-D view shows that instant, the table its values.</source>
        <translation>Jedes Rad hat eine Kurve mit eigenem Zeichen und eigener Farbe. In ein Diagramm klicken: Die 3D-Ansicht zeigt diesen Zeitpunkt, die Tabelle seine Werte.</translation>
    </message>
    <message>
        <source>Over-constrained</source>
        <translation>Überbestimmt</translation>
    </message>
    <message>
        <source>The Grübler count says −20: it should not move at all. Yet it drives, for &lt;b&gt;21 constraints are redundant&lt;/b&gt;: inaccurate parts strain each other, and no statics tell the forces in them.</source>
        <translation>Die Grübler-Zahl ist −20: Er dürfte sich gar nicht bewegen. Und doch fährt er, denn &lt;b&gt;21 Bedingungen sind redundant&lt;/b&gt;: Ungenaue Teile verspannen einander, und keine Statik nennt die Kräfte darin.</translation>
    </message>
    <message>
        <source>Which joints?</source>
        <translation>Welche Gelenke?</translation>
    </message>
    <message>
        <source>Click a joint in this list: it is ringed in the 3-D view. The bar is how much of it others hold already.</source>
        <translation>Ein Gelenk in dieser Liste anklicken: Es bekommt in der 3D-Ansicht einen Ring. Der Balken zeigt, wie viel davon andere schon halten.</translation>
    </message>
    <message>
        <source>Ask the Advisor</source>
        <translation>Den Ratgeber fragen</translation>
    </message>
    <message>
        <source>Press &lt;b&gt;Ctrl+Shift+A&lt;/b&gt;. It searches joints to free so that nothing is redundant and the rover moves as before.</source>
        <translation>&lt;b&gt;Strg+Umschalt+A&lt;/b&gt; drücken. Er sucht Gelenke, die zu lösen sind, damit nichts redundant ist und der Rover sich bewegt wie zuvor.</translation>
    </message>
    <message>
        <source>Apply a proposal</source>
        <translation>Einen Vorschlag anwenden</translation>
    </message>
    <message>
        <source>Choose one that is not applied yet and press &lt;b&gt;Apply proposal&lt;/b&gt;: it becomes the &lt;i&gt;relaxed&lt;/i&gt; model, with nothing redundant. The rover as built stays.</source>
        <translation>Einen wählen, der noch nicht angewandt ist, und &lt;b&gt;Vorschlag anwenden&lt;/b&gt; drücken: Er wird das &lt;i&gt;gelockerte&lt;/i&gt; Modell, in dem nichts redundant ist. Der Rover wie gebaut bleibt.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+Z&lt;/b&gt; undoes it, as every other edit.</source>
        <translation>&lt;b&gt;Strg+Z&lt;/b&gt; nimmt es zurück, wie jede andere Änderung.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Progress of the tour</source>
        <translation>Fortschritt des Rundgangs</translation>
    </message>
    <message>
        <source>&amp;Skip the tour</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>Fe&amp;rtig</translation>
    </message>
</context>
<context>
    <name>widgets::Viewport</name>
    <message>
        <source>3D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>&lt;h3&gt;No 3D view&lt;/h3&gt;&lt;p&gt;OpenGL is not available here. Editing, mobility, runs, plots and export work without it.&lt;/p&gt;&lt;p&gt;To see the rover, install an OpenGL driver; on Debian &lt;tt&gt;libgl1-mesa-dri&lt;/tt&gt; draws without a graphics card.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Keine 3-D-Ansicht&lt;/h3&gt;&lt;p&gt;OpenGL steht hier nicht zur Verfügung. Bearbeiten, Laufgrad, Fahrten, Diagramme und Export gehen ohne.&lt;/p&gt;&lt;p&gt;Um den Rover zu sehen, einen OpenGL-Treiber installieren; unter Debian zeichnet &lt;tt&gt;libgl1-mesa-dri&lt;/tt&gt; ohne Grafikkarte.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>3D view not available</source>
        <translation>3-D-Ansicht nicht verfügbar</translation>
    </message>
</context>
<context>
    <name>widgets::WayPlot</name>
    <message>
        <source>Required friction over the way</source>
        <translation>Nötige Reibung längs des Weges</translation>
    </message>
    <message>
        <source>μ*</source>
        <translation>μ*</translation>
    </message>
</context>
<context>
    <name>widgets::WheelTable</name>
    <message>
        <source>Wheels: contact angle, load, friction used and torques</source>
        <translation>Räder: Kontaktwinkel, Last, genutzte Reibung und Drehmomente</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Contact angle: 90° is a wall ahead</source>
        <translation>Kontaktwinkel: 90° ist eine Wand voraus</translation>
    </message>
    <message>
        <source>Normal force with the best torques [N]</source>
        <translation>Normalkraft bei den besten Drehmomenten [N]</translation>
    </message>
    <message>
        <source>Tangential over normal force, as a part of the friction of the ground</source>
        <translation>Tangential- durch Normalkraft, als Anteil der Reibungszahl des Bodens</translation>
    </message>
    <message>
        <source>The torques that ask for the least friction [N·m]; the mark on the bar is the torque when all wheels have the same</source>
        <translation>Die Drehmomente, die am wenigsten Reibung verlangen [N·m]; die Marke am Balken ist das Drehmoment, wenn alle Räder dasselbe haben</translation>
    </message>
    <message>
        <source>%1 N·m when all wheels have the same</source>
        <translation>%1 N·m, wenn alle Räder dasselbe haben</translation>
    </message>
    <message>
        <source>No equal torque holds the rover here</source>
        <translation>Kein gleiches Drehmoment hält den Rover hier</translation>
    </message>
</context>
<context>
    <name>widgets::background</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping...</source>
        <translation>Wird angehalten ...</translation>
    </message>
</context>
<context>
    <name>widgets::mayReplace</name>
    <message>
        <source>A file of this name is there</source>
        <translation>Eine Datei dieses Namens ist vorhanden</translation>
    </message>
    <message>
        <source>Replace %1?</source>
        <translation>%1 ersetzen?</translation>
    </message>
</context>
</TS>
