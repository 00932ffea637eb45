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
    <name>channels</name>
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
        <source>Roll</source>
        <translation>Wanken</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Angular rate x</source>
        <translation>Drehrate x</translation>
    </message>
    <message>
        <source>Angular rate y</source>
        <translation>Drehrate y</translation>
    </message>
    <message>
        <source>Angular rate z</source>
        <translation>Drehrate z</translation>
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
        <source>Speed (measured)</source>
        <translation>Geschwindigkeit (gemessen)</translation>
    </message>
    <message>
        <source>Roll (measured)</source>
        <translation>Wanken (gemessen)</translation>
    </message>
    <message>
        <source>Pitch (measured)</source>
        <translation>Nicken (gemessen)</translation>
    </message>
    <message>
        <source>Angular rate x (measured)</source>
        <translation>Drehrate x (gemessen)</translation>
    </message>
    <message>
        <source>Angular rate y (measured)</source>
        <translation>Drehrate y (gemessen)</translation>
    </message>
    <message>
        <source>Angular rate z (measured)</source>
        <translation>Drehrate z (gemessen)</translation>
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
        <source>Torque of the speed loop</source>
        <translation>Drehmoment der Geschwindigkeitsschleife</translation>
    </message>
    <message>
        <source>Required friction (planned)</source>
        <translation>Nötige Reibung (geplant)</translation>
    </message>
    <message>
        <source>Friction trusted</source>
        <translation>Reibung, auf die gebaut wird</translation>
    </message>
    <message>
        <source>Slip (absolute)</source>
        <translation>Schlupf (absolut)</translation>
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
        <source>Slip (lateral)</source>
        <translation>Schlupf (seitlich)</translation>
    </message>
    <message>
        <source>Friction work</source>
        <translation>Reibarbeit</translation>
    </message>
    <message>
        <source>Torque (commanded)</source>
        <translation>Drehmoment (verlangt)</translation>
    </message>
    <message>
        <source>Torque (applied)</source>
        <translation>Drehmoment (gestellt)</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>Traction force</source>
        <translation>Traktionskraft</translation>
    </message>
    <message>
        <source>Lateral force</source>
        <translation>Seitenkraft</translation>
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
        <source>Contact angle</source>
        <translation>Kontaktwinkel</translation>
    </message>
    <message>
        <source>Penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>Wheel rate</source>
        <translation>Raddrehzahl</translation>
    </message>
    <message>
        <source>Wheel speed</source>
        <translation>Radgeschwindigkeit</translation>
    </message>
    <message>
        <source>Wheel rate (measured)</source>
        <translation>Raddrehzahl (gemessen)</translation>
    </message>
    <message>
        <source>Normal force (measured)</source>
        <translation>Normalkraft (gemessen)</translation>
    </message>
    <message>
        <source>Contact angle (measured)</source>
        <translation>Kontaktwinkel (gemessen)</translation>
    </message>
    <message>
        <source>Torque (planned)</source>
        <translation>Drehmoment (geplant)</translation>
    </message>
    <message>
        <source>Normal force (planned)</source>
        <translation>Normalkraft (geplant)</translation>
    </message>
    <message>
        <source>Wheel rate (planned)</source>
        <translation>Raddrehzahl (geplant)</translation>
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
        <translation>müßig</translation>
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
        <translation>Welche Gelenke brauchen mehr Freiheit, damit nichts redundant oder müßig ist und der Rover sich bewegt wie bisher? Vorgeschlagen werden die billigsten Sätze; einer davon kann das gelockerte Modell werden.</translation>
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
        <translation>%1 m gefahren, Schlupf %2 m, %3 J</translation>
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
