<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ColumnRole</name>
    <message>
        <source>target</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>use</source>
        <translation>verwendet</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>{now} is before the program was made, {made}</source>
        <translation>{now} liegt vor der Zeit, zu der das Programm gebaut wurde, {made}</translation>
    </message>
    <message>
        <source>set the clock (timedatectl says what it follows): flash operations are counted by it</source>
        <translation>Uhr stellen (timedatectl sagt, wonach sie geht): Flash-Vorgänge werden nach ihr gezählt</translation>
    </message>
    <message>
        <source>display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>unset it if the window does not appear</source>
        <translation>die Variable löschen, wenn das Fenster nicht erscheint</translation>
    </message>
    <message>
        <source>none; the window needs one</source>
        <translation>keine; das Fenster braucht eine</translation>
    </message>
    <message>
        <source>start the window on the desktop, or over ssh -X; the command line does without</source>
        <translation>das Fenster am Desktop oder über ssh -X starten; die Befehlszeile kommt ohne aus</translation>
    </message>
    <message>
        <source>temporary folder</source>
        <translation>temporärer Ordner</translation>
    </message>
    <message>
        <source>{folder} is not there</source>
        <translation>{folder} gibt es nicht</translation>
    </message>
    <message>
        <source>make it, or set {variable} to another folder</source>
        <translation>den Ordner anlegen, oder {variable} auf einen anderen setzen</translation>
    </message>
    <message>
        <source>{folder}, {free} free</source>
        <translation>{folder}, {free} frei</translation>
    </message>
    <message>
        <source>runtime folder</source>
        <translation>Laufzeitordner</translation>
    </message>
    <message>
        <source>log in at the desktop or over ssh, and not by su or sudo, if the window does not appear</source>
        <translation>sich am Desktop oder über ssh anmelden, nicht mit su oder sudo, wenn das Fenster nicht erscheint</translation>
    </message>
    <message>
        <source>XDG_RUNTIME_DIR is not set</source>
        <translation>XDG_RUNTIME_DIR ist nicht gesetzt</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}</source>
        <translation>{folder} gehört {owner}</translation>
    </message>
    <message>
        <source>proxies</source>
        <translation>Proxys</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>{variables}: drives are reached without a proxy all the same</source>
        <translation>{variables}: Antriebe werden trotzdem ohne Proxy angesprochen</translation>
    </message>
    <message>
        <source>no variable is set</source>
        <translation>keine Variable ist gesetzt</translation>
    </message>
    <message>
        <source>locale</source>
        <translation>Gebietsschema</translation>
    </message>
    <message>
        <source>{variables}: this locale is not installed</source>
        <translation>{variables}: dieses Gebietsschema ist nicht installiert</translation>
    </message>
    <message>
        <source>{variables}: its encoding {encoding} is not UTF-8, so that letters outside of ASCII may look wrong</source>
        <translation>{variables}: die Kodierung {encoding} ist nicht UTF-8; Buchstaben außerhalb von ASCII können falsch aussehen</translation>
    </message>
    <message>
        <source>export LC_ALL=C.UTF-8, or the locale of your language with UTF-8</source>
        <translation>export LC_ALL=C.UTF-8, oder das Gebietsschema Ihrer Sprache mit UTF-8</translation>
    </message>
    <message>
        <source>{variables}: {encoding}</source>
        <translation>{variables}: {encoding}</translation>
    </message>
    <message>
        <source>set {variable} to a folder of your own</source>
        <translation>{variable} auf einen eigenen Ordner setzen</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} is no folder</source>
        <translation>{folder} ist nicht benutzbar: {nearest} ist kein Ordner</translation>
    </message>
    <message>
        <source>{folder} cannot be used: you have no permission to look into {nearest}</source>
        <translation>{folder} ist nicht benutzbar: Sie dürfen nicht in {nearest} sehen</translation>
    </message>
    <message>
        <source>{folder} is on a file system that is read-only</source>
        <translation>{folder} liegt auf einem Dateisystem, das nur gelesen werden kann</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} belongs to {owner}, and you have no permission to change it</source>
        <translation>{folder} ist nicht benutzbar: {nearest} gehört {owner}, und Sie dürfen es nicht ändern</translation>
    </message>
    <message>
        <source>{folder} has only {free} free</source>
        <translation>{folder} hat nur noch {free} frei</translation>
    </message>
    <message>
        <source>{folder} is on a file system that takes no more files, with {free} free</source>
        <translation>{folder} liegt auf einem Dateisystem, das keine Dateien mehr aufnimmt, bei {free} frei</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to a folder of another disk</source>
        <translation>dort Platz schaffen, oder {variable} auf einen Ordner eines anderen Datenträgers setzen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>system</source>
        <translation>System</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>Kernel</translation>
    </message>
    <message>
        <source>processor cores</source>
        <translation>Prozessorkerne</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>{all}, {free} free</source>
        <translation>{all}, {free} frei</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>&quot;{sign}&quot;; the command line writes and reads a point</source>
        <translation>&quot;{sign}&quot;; die Befehlszeile schreibt und liest einen Punkt</translation>
    </message>
    <message>
        <source>translations</source>
        <translation>Übersetzungen</translation>
    </message>
    <message>
        <source>window settings</source>
        <translation>Einstellungen des Fensters</translation>
    </message>
    <message>
        <source>none; the window was not used yet</source>
        <translation>keine; das Fenster wurde noch nicht benutzt</translation>
    </message>
    <message>
        <source>{file} is not a file that you may read</source>
        <translation>{file} ist keine Datei, die Sie lesen dürfen</translation>
    </message>
    <message>
        <source>move it away; the window begins a new one</source>
        <translation>sie wegschieben; das Fenster beginnt eine neue</translation>
    </message>
    <message>
        <source>{file} is damaged</source>
        <translation>{file} ist beschädigt</translation>
    </message>
    <message>
        <source>{file}, connections: {number}</source>
        <translation>{file}, Verbindungen: {number}</translation>
    </message>
    <message>
        <source>drive profile</source>
        <translation>Antriebsprofil</translation>
    </message>
    <message>
        <source>{profile}, built in</source>
        <translation>{profile}, eingebaut</translation>
    </message>
    <message>
        <source>trusted certificates</source>
        <translation>vertraute Zertifikate</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>open {drive} in a browser of this computer; if it does not answer there either, look at power, cable and network</source>
        <translation>{drive} in einem Browser dieses Rechners öffnen; wenn er auch dort nicht antwortet, nach Strom, Kabel und Netz sehen</translation>
    </message>
    <message>
        <source>look at power and cable; `axiscomp axes --find --any-baud` tries other speeds</source>
        <translation>nach Strom und Kabel sehen; `axiscomp axes --find --any-baud` probiert andere Geschwindigkeiten</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>{drive}, serial number {serial}, axes: {axes}, profile {profile}; answered after {milliseconds}</source>
        <translation>{drive}, Seriennummer {serial}, Achsen: {axes}, Profil {profile}; hat nach {milliseconds} geantwortet</translation>
    </message>
    <message>
        <source>{drive}; then: {error}</source>
        <translation>{drive}; dann: {error}</translation>
    </message>
    <message>
        <source>{unit}, {homing}, compensation {state}</source>
        <translation>{unit}, {homing}, Kompensation {state}</translation>
    </message>
    <message>
        <source>{state}, no table</source>
        <translation>{state}, keine Tabelle</translation>
    </message>
    <message>
        <source>{state}, table {slot} with CRC {crc}</source>
        <translation>{state}, Tabelle {slot} mit CRC {crc}</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>Achse {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>Achse {axis} ({name})</translation>
    </message>
    <message>
        <source>it has no compensation registers by this profile</source>
        <translation>sie hat nach diesem Profil keine Kompensationsregister</translation>
    </message>
    <message>
        <source>drive error</source>
        <translation>Fehler des Antriebs</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>none is known</source>
        <translation>keiner ist bekannt</translation>
    </message>
    <message>
        <source>add a connection in the window, or give --drive ADDRESS</source>
        <translation>im Fenster eine Verbindung hinzufügen, oder --drive ADRESSE angeben</translation>
    </message>
    <message>
        <source>{version}, built with {other}</source>
        <translation>{version}, gebaut mit {other}</translation>
    </message>
    <message>
        <source>there is no TLS library: https drives cannot be reached</source>
        <translation>es gibt keine TLS-Bibliothek: Antriebe mit https sind nicht erreichbar</translation>
    </message>
    <message>
        <source>install OpenSSL (sudo apt install libssl3)</source>
        <translation>OpenSSL installieren (sudo apt install libssl3)</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>not installed; the command line does without</source>
        <translation>nicht installiert; die Befehlszeile kommt ohne aus</translation>
    </message>
    <message>
        <source>reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>what draws PDF is not installed</source>
        <translation>was PDF zeichnet, ist nicht installiert</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>a port without a name</source>
        <translation>ein Anschluss ohne Namen</translation>
    </message>
    <message>
        <source>{hardware}, built in</source>
        <translation>{hardware}, eingebaut</translation>
    </message>
    <message>
        <source>{hardware}, USB {id}</source>
        <translation>{hardware}, USB {id}</translation>
    </message>
    <message>
        <source>{hardware}: {problem}</source>
        <translation>{hardware}: {problem}</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>Serielle Anschlüsse</translation>
    </message>
    <message>
        <source>ports</source>
        <translation>Anschlüsse</translation>
    </message>
    <message>
        <source>this computer has none</source>
        <translation>dieser Rechner hat keine</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>sudo chown -R $USER {folder}; run this program without sudo</source>
        <translation>sudo chown -R $USER {folder}; dieses Programm ohne sudo starten</translation>
    </message>
    <message>
        <source>{folder} is yours, but its permissions keep you out</source>
        <translation>{folder} gehört Ihnen, aber seine Rechte sperren Sie aus</translation>
    </message>
    <message>
        <source>{folder} is not there yet; the first write makes it</source>
        <translation>{folder} gibt es noch nicht; das erste Schreiben legt ihn an</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}, and you are root: what is made there now belongs to root</source>
        <translation>{folder} gehört {owner}, und Sie sind root: was jetzt dort entsteht, gehört root</translation>
    </message>
    <message>
        <source>run this program without sudo</source>
        <translation>dieses Programm ohne sudo starten</translation>
    </message>
    <message>
        <source>{folder} can be changed by other users</source>
        <translation>{folder} kann von anderen Benutzern geändert werden</translation>
    </message>
    <message>
        <source>file system</source>
        <translation>Dateisystem</translation>
    </message>
    <message>
        <source>on the network, where a database can be damaged: nothing is kept there, and no write begins</source>
        <translation>im Netz, wo eine Datenbank beschädigt werden kann: dort wird nichts aufgehoben, und kein Schreiben beginnt</translation>
    </message>
    <message>
        <source>set {variable} to a folder on this computer</source>
        <translation>{variable} auf einen Ordner auf diesem Rechner setzen</translation>
    </message>
    <message>
        <source>in memory: backups and journal are gone after a restart</source>
        <translation>im Arbeitsspeicher: Sicherungen und Journal sind nach einem Neustart weg</translation>
    </message>
    <message>
        <source>set {variable} to a folder on a disk</source>
        <translation>{variable} auf einen Ordner auf einem Datenträger setzen</translation>
    </message>
    <message>
        <source>of this computer</source>
        <translation>von diesem Rechner</translation>
    </message>
    <message>
        <source>database</source>
        <translation>Datenbank</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>sie wegschieben</translation>
    </message>
    <message>
        <source>none yet; the first write makes it</source>
        <translation>noch keine; das erste Schreiben legt sie an</translation>
    </message>
    <message>
        <source>of an older version, {size}; the next command that needs it brings it up to date</source>
        <translation>von einer älteren Version, {size}; der nächste Befehl, der sie braucht, bringt sie auf den neuen Stand</translation>
    </message>
    <message>
        <source>a newer version of this program has written it</source>
        <translation>eine neuere Version dieses Programms hat sie geschrieben</translation>
    </message>
    <message>
        <source>use that version</source>
        <translation>diese Version verwenden</translation>
    </message>
    <message>
        <source>it is the database of another program</source>
        <translation>sie ist die Datenbank eines anderen Programms</translation>
    </message>
    <message>
        <source>it is damaged ({reason})</source>
        <translation>sie ist beschädigt ({reason})</translation>
    </message>
    <message>
        <source>the next command that needs it sets it aside and keeps what can be read; look what the drives hold, then `axiscomp status --reset-flash-count` for each</source>
        <translation>der nächste Befehl, der sie braucht, legt sie beiseite und behält, was lesbar ist; nachsehen, was die Antriebe haben, dann für jeden `axiscomp status --reset-flash-count`</translation>
    </message>
    <message>
        <source>not checked, because programs write to it all the time</source>
        <translation>nicht geprüft, weil Programme ständig in sie schreiben</translation>
    </message>
    <message>
        <source>try again when they have finished</source>
        <translation>noch einmal versuchen, wenn sie fertig sind</translation>
    </message>
    <message>
        <source>you have no permission to change it</source>
        <translation>Sie dürfen sie nicht ändern</translation>
    </message>
    <message>
        <source>let the user have it to whom the folder belongs (chown, chmod u+rw)</source>
        <translation>sie dem Benutzer geben, dem der Ordner gehört (chown, chmod u+rw)</translation>
    </message>
    <message>
        <source>whole, {size}</source>
        <translation>unversehrt, {size}</translation>
    </message>
    <message>
        <source>interrupted write</source>
        <translation>unterbrochener Schreibvorgang</translation>
    </message>
    <message>
        <source>write</source>
        <translation>Schreibvorgang</translation>
    </message>
    <message>
        <source>a program is writing to axis {axis} of the drive with serial number {drive} now, since {time} ({step})</source>
        <translation>ein Programm schreibt gerade auf Achse {axis} des Antriebs mit der Seriennummer {drive}, seit {time} ({step})</translation>
    </message>
    <message>
        <source>a write to axis {axis} of the drive with serial number {drive} began at {time} and did not end (step {step})</source>
        <translation>ein Schreibvorgang auf Achse {axis} des Antriebs mit der Seriennummer {drive} begann um {time} und endete nicht (Schritt {step})</translation>
    </message>
    <message>
        <source>`axiscomp recover --axis {axis}` with that drive says what it holds, and finishes the write or undoes it</source>
        <translation>`axiscomp recover --axis {axis}` mit diesem Antrieb sagt, was er hat, und vollendet den Schreibvorgang oder macht ihn rückgängig</translation>
    </message>
    <message>
        <source>interrupted writes</source>
        <translation>unterbrochene Schreibvorgänge</translation>
    </message>
    <message>
        <source>flash record</source>
        <translation>Flash-Aufzeichnung</translation>
    </message>
    <message>
        <source>that of the drive with serial number {drive} was damaged: its flash operations count as used up</source>
        <translation>die des Antriebs mit der Seriennummer {drive} war beschädigt: seine Flash-Vorgänge gelten als aufgebraucht</translation>
    </message>
    <message>
        <source>wait as long as the drive counts them, then `axiscomp status --reset-flash-count`</source>
        <translation>so lange warten, wie der Antrieb sie zählt, dann `axiscomp status --reset-flash-count`</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>beiseitegelegt</translation>
    </message>
    <message>
        <source>{file} is an earlier database that was damaged</source>
        <translation>{file} ist eine frühere Datenbank, die beschädigt war</translation>
    </message>
    <message>
        <source>delete it when nothing is missed</source>
        <translation>sie löschen, wenn nichts vermisst wird</translation>
    </message>
    <message>
        <source>last change</source>
        <translation>letzte Änderung</translation>
    </message>
    <message>
        <source>{time} is still to come: the clock was set back since</source>
        <translation>{time} liegt in der Zukunft: die Uhr wurde seither zurückgestellt</translation>
    </message>
    <message>
        <source>look at the clock: flash operations are counted by it</source>
        <translation>nach der Uhr sehen: Flash-Vorgänge werden nach ihr gezählt</translation>
    </message>
    <message>
        <source>backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>files: {backups}, drives: {drives}, {size}</source>
        <translation>Dateien: {backups}, Antriebe: {drives}, {size}</translation>
    </message>
    <message>
        <source>State folder</source>
        <translation>Zustandsordner</translation>
    </message>
    <message>
        <source>sudo apt install locales and sudo dpkg-reconfigure locales, or export LC_ALL=C.UTF-8</source>
        <translation>sudo apt install locales und sudo dpkg-reconfigure locales, oder export LC_ALL=C.UTF-8</translation>
    </message>
    <message>
        <source>if the drive has the same fingerprint: `axiscomp axes --drive {drive} --trust-certificate {fingerprint}` trusts it from then on</source>
        <translation>wenn der Antrieb denselben Fingerabdruck zeigt: `axiscomp axes --drive {drive} --trust-certificate {fingerprint}` vertraut ihm von da an</translation>
    </message>
    <message>
        <source>install the package {package}</source>
        <translation>das Paket {package} installieren</translation>
    </message>
    <message>
        <source>install the package {package}, or write the report as HTML and print that</source>
        <translation>das Paket {package} installieren oder den Bericht als HTML schreiben und drucken</translation>
    </message>
    <message>
        <source>not checked: {reason}</source>
        <translation>nicht geprüft: {reason}</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to another folder</source>
        <translation>dort Platz schaffen oder {variable} auf einen anderen Ordner setzen</translation>
    </message>
    <message>
        <source>not checked, because no copy could be made in the temporary folder</source>
        <translation>nicht geprüft, da im temporären Ordner keine Kopie angelegt werden konnte</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>{size} bytes</source>
        <translation>{size} Byte</translation>
    </message>
    <message>
        <source>at most {size} bytes</source>
        <translation>höchstens {size} Byte</translation>
    </message>
    <message>
        <source>at most {count} columns</source>
        <translation>höchstens {count} Spalten</translation>
    </message>
    <message>
        <source>a line with the names of the columns, not only comments</source>
        <translation>eine Zeile mit den Namen der Spalten, nicht nur Kommentare</translation>
    </message>
    <message>
        <source>no data lines after the header</source>
        <translation>keine Datenzeilen nach der Kopfzeile</translation>
    </message>
    <message>
        <source>at least 2 positions in each dimension, one line per grid point</source>
        <translation>mindestens 2 Positionen je Dimension, eine Zeile je Stützstelle</translation>
    </message>
    <message>
        <source>the names of the columns, not numbers</source>
        <translation>die Namen der Spalten, keine Zahlen</translation>
    </message>
    <message>
        <source>at least {count} for dimensionality {dimensions}, {positions} of positions and 1 of values</source>
        <translation>mindestens {count} bei Dimensionalität {dimensions}, davon {positions} mit Positionen und 1 mit Werten</translation>
    </message>
    <message>
        <source>{expected} (or is the dimensionality {dimensions}?)</source>
        <translation>{expected} (oder ist die Dimensionalität {dimensions}?)</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ;</source>
        <translation>{expected}; die Spalten mit , oder ; trennen</translation>
    </message>
    <message>
        <source>{expected}; if the commas are decimal commas, separate the columns with ; in every line</source>
        <translation>{expected}; wenn die Kommas Dezimalkommas sind, die Spalten in jeder Zeile mit ; trennen</translation>
    </message>
    <message>
        <source>{expected}; the header separates its columns with {separator}, so every line must</source>
        <translation>{expected}; die Kopfzeile trennt die Spalten mit {separator}, also muss es jede Zeile tun</translation>
    </message>
    <message>
        <source>{expected}; decimal commas need the separator ; in every line</source>
        <translation>{expected}; Dezimalkommas erfordern das Trennzeichen ; in jeder Zeile</translation>
    </message>
    <message>
        <source>{count} as in the header (line {line})</source>
        <translation>{count} wie in der Kopfzeile (Zeile {line})</translation>
    </message>
    <message>
        <source>a closing &quot; in the same line</source>
        <translation>ein schließendes &quot; in derselben Zeile</translation>
    </message>
    <message>
        <source>a separator after the closing &quot;</source>
        <translation>ein Trennzeichen nach dem schließenden &quot;</translation>
    </message>
    <message>
        <source>a separator or the end of the line after the closing &quot;</source>
        <translation>ein Trennzeichen oder das Zeilenende nach dem schließenden &quot;</translation>
    </message>
    <message>
        <source>a number such as {example}</source>
        <translation>eine Zahl wie {example}</translation>
    </message>
    <message>
        <source>a finite number such as {example}</source>
        <translation>eine endliche Zahl wie {example}</translation>
    </message>
    <message>
        <source>0 or a number that is not as close to it</source>
        <translation>0 oder eine Zahl, die nicht so nahe bei 0 liegt</translation>
    </message>
    <message>
        <source>a value that fits float32 (below 3.4e38)</source>
        <translation>ein Wert, der in float32 passt (unter 3.4e38)</translation>
    </message>
    <message>
        <source>a decimal comma as in line {line}</source>
        <translation>ein Dezimalkomma wie in Zeile {line}</translation>
    </message>
    <message>
        <source>a decimal point as in line {line}</source>
        <translation>ein Dezimalpunkt wie in Zeile {line}</translation>
    </message>
    <message>
        <source>no sign between the thousands</source>
        <translation>kein Tausendertrennzeichen</translation>
    </message>
    <message>
        <source>more than {rows} data lines of {columns} columns</source>
        <translation>mehr als {rows} Datenzeilen mit {columns} Spalten</translation>
    </message>
    <message>
        <source>at most {cells} cells (lines x columns)</source>
        <translation>höchstens {cells} Zellen (Zeilen x Spalten)</translation>
    </message>
    <message>
        <source>positions with a finite range</source>
        <translation>Positionen mit endlichem Bereich</translation>
    </message>
    <message>
        <source>positions whose distance a double can hold</source>
        <translation>Positionen, deren Abstand sich als Double darstellen lässt</translation>
    </message>
    <message>
        <source>{position} (steps of {distance})</source>
        <translation>{position} (Schrittweite {distance})</translation>
    </message>
    <message>
        <source>{position} next to {before}</source>
        <translation>{position} neben {before}</translation>
    </message>
    <message>
        <source>{position} on an even line in steps of {distance}</source>
        <translation>{position} bei gleichmäßiger Schrittweite {distance}</translation>
    </message>
    <message>
        <source>only {position}</source>
        <translation>nur {position}</translation>
    </message>
    <message>
        <source>at least 2 different positions</source>
        <translation>mindestens 2 verschiedene Positionen</translation>
    </message>
    <message>
        <source>{point} in line {first} and again in line {second}</source>
        <translation>{point} in Zeile {first} und nochmals in Zeile {second}</translation>
    </message>
    <message>
        <source>every position once</source>
        <translation>jede Position einmal</translation>
    </message>
    <message>
        <source>no line for {points} (missing: {missing} of {all} points)</source>
        <translation>keine Zeile für {points} (es fehlen {missing} von {all} Stützstellen)</translation>
    </message>
    <message>
        <source>{value} at every point of {table}</source>
        <translation>{value} an jeder Stützstelle von {table}</translation>
    </message>
    <message>
        <source>values that differ</source>
        <translation>unterschiedliche Werte</translation>
    </message>
    <message>
        <source>a change of {change}</source>
        <translation>eine Änderung um {change}</translation>
    </message>
    <message>
        <source>at most a millionth of the largest value, {value}</source>
        <translation>höchstens ein Millionstel des größten Werts {value}</translation>
    </message>
    <message>
        <source>a step from {from} to {to} over {distance} in dimension {dimension}</source>
        <translation>ein Sprung von {from} auf {to} über {distance} in Dimension {dimension}</translation>
    </message>
    <message>
        <source>at most 0.01 per unit of position</source>
        <translation>höchstens 0.01 je Positionseinheit</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>Text in UTF-16</translation>
    </message>
    <message>
        <source>a spreadsheet workbook or ZIP archive</source>
        <translation>eine Tabellenkalkulationsmappe oder ein ZIP-Archiv</translation>
    </message>
    <message>
        <source>an old Excel workbook</source>
        <translation>eine alte Excel-Mappe</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a compressed file (gzip)</source>
        <translation>eine komprimierte Datei (gzip)</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>a TAM table</source>
        <translation>eine TAM-Tabelle</translation>
    </message>
    <message>
        <source>a binary file</source>
        <translation>eine Binärdatei</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>ein NUL-Byte</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>eine Textdatei</translation>
    </message>
    <message>
        <source>the byte 0x{byte} ({character})</source>
        <translation>das Byte 0x{byte} ({character})</translation>
    </message>
    <message>
        <source>file length</source>
        <translation>Dateilänge</translation>
    </message>
    <message>
        <source>element {number}</source>
        <translation>Element {number}</translation>
    </message>
    <message>
        <source>{size} for the header and 4 for each of the {count} elements</source>
        <translation>{size} für den Kopf und je 4 für {count} Elemente</translation>
    </message>
    <message>
        <source>at least the {size} bytes of the header</source>
        <translation>mindestens die {size} Byte des Kopfs</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 oder 1</translation>
    </message>
    <message>
        <source>1, 2 or 3</source>
        <translation>1, 2 oder 3</translation>
    </message>
    <message>
        <source>2 or more</source>
        <translation>2 oder mehr</translation>
    </message>
    <message>
        <source>1, because this dimension is not used</source>
        <translation>1, weil diese Dimension nicht verwendet wird</translation>
    </message>
    <message>
        <source>{count}, the product of the sizes</source>
        <translation>{count}, das Produkt der Größen</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a finite number above 0</source>
        <translation>eine endliche Zahl über 0</translation>
    </message>
    <message>
        <source>one that leads to a finite last position</source>
        <translation>ein Wert, der zu einer endlichen letzten Position führt</translation>
    </message>
    <message>
        <source>one that tells positions such as {position} apart</source>
        <translation>ein Wert, der Positionen wie {position} unterscheidbar lässt</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the header before it</source>
        <translation>{crc}, die CRC des Kopfs davor</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the elements</source>
        <translation>{crc}, die CRC der Elemente</translation>
    </message>
    <message>
        <source>the size of dimension {dimension} is {value}, at least 2 is needed</source>
        <translation>die Größe der Dimension {dimension} ist {value}, nötig ist mindestens 2</translation>
    </message>
    <message>
        <source>the start value of dimension {dimension} is {value}, a finite number is needed</source>
        <translation>der Anfangswert der Dimension {dimension} ist {value}, nötig ist eine endliche Zahl</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, a finite number above 0 is needed</source>
        <translation>die Schrittweite der Dimension {dimension} ist {value}, nötig ist eine endliche Zahl über 0</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, too little to tell positions such as {position} apart</source>
        <translation>die Schrittweite der Dimension {dimension} ist {value}, zu klein, um Positionen wie {position} zu unterscheiden</translation>
    </message>
    <message>
        <source>the last position of dimension {dimension} is too large to be a number</source>
        <translation>die letzte Position der Dimension {dimension} ist zu groß für eine Zahl</translation>
    </message>
    <message>
        <source>the table has {count} dimensions, 1 to 3 are possible</source>
        <translation>die Tabelle hat {count} Dimensionen, möglich sind 1 bis 3</translation>
    </message>
    <message>
        <source>the table has {count} values, which is not the product of its sizes</source>
        <translation>die Tabelle hat {count} Werte, was nicht das Produkt ihrer Größen ist</translation>
    </message>
    <message>
        <source>the table has more values than a file can count</source>
        <translation>die Tabelle hat mehr Werte, als eine Datei zählen kann</translation>
    </message>
    <message>
        <source>value {number} is {value}, a finite number is needed</source>
        <translation>Wert {number} ist {value}, nötig ist eine endliche Zahl</translation>
    </message>
    <message>
        <source>the table cannot be kept in this drive&apos;s table file: {reason}</source>
        <translation>die Tabelle lässt sich nicht in der Tabellendatei dieses Antriebs ablegen: {reason}</translation>
    </message>
    <message>
        <source>{value} does not fit into the field {field}, which is of type {type}</source>
        <translation>{value} passt nicht in das Feld {field} vom Typ {type}</translation>
    </message>
    <message>
        <source>the grid of dimension {dimension}, start {start} and distance {distance}, cannot be held by fields of the types {first} and {second}</source>
        <translation>das Gitter der Dimension {dimension} mit Anfang {start} und Schrittweite {distance} lässt sich nicht in Feldern der Typen {first} und {second} darstellen</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>vom Benutzer abgebrochen</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}</source>
        <translation>{file} kann nicht gelesen werden: {reason}</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}</source>
        <translation>{file} kann nicht geschrieben werden: {reason}</translation>
    </message>
    <message>
        <source>{file} has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{file} hat {size} Byte; höchstens {limit} sind für eine solche Datei möglich</translation>
    </message>
    <message>
        <source>this is not a valid TAM table: {field} at offset {offset} is {found}, expected {expected}</source>
        <translation>keine gültige TAM-Tabelle: {field} bei Byte {offset} ist {found}, erwartet: {expected}</translation>
    </message>
    <message>
        <source>the drive profile {file} is wrong at {path}: {reason}</source>
        <translation>Fehler im Antriebsprofil {file} bei {path}: {reason}</translation>
    </message>
    <message>
        <source>the TAM configuration {file} is wrong in line {line}: {reason}</source>
        <translation>Fehler in der TAM-Konfiguration {file}, Zeile {line}: {reason}</translation>
    </message>
    <message>
        <source>{file} is not a valid backup: {reason}</source>
        <translation>{file} ist keine gültige Sicherung: {reason}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}</source>
        <translation>das Format von {file} ist unbekannt; eines davon angeben: {known}</translation>
    </message>
    <message>
        <source>the name {file} says no format that can be written; name one with --to: {known}</source>
        <translation>der Name {file} sagt kein Format, das geschrieben werden kann; eines mit --to angeben: {known}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}; of any other CSV file, say which column is what</source>
        <translation>das Format von {file} ist unbekannt; eines davon angeben: {known}; bei jeder anderen CSV-Datei angeben, welche Spalte was ist</translation>
    </message>
    <message>
        <source>there is no table {table} in the file; it has: {known}</source>
        <translation>die Datei enthält keine Tabelle {table}, sondern: {known}</translation>
    </message>
    <message>
        <source>{endpoint} is not the address of a drive: {reason}</source>
        <translation>{endpoint} ist keine Adresse eines Antriebs: {reason}</translation>
    </message>
    <message>
        <source>no connection to {endpoint}: {reason}</source>
        <translation>keine Verbindung zu {endpoint}: {reason}</translation>
    </message>
    <message>
        <source>the connection to {endpoint} was lost: {reason}</source>
        <translation>die Verbindung zu {endpoint} ist abgebrochen: {reason}</translation>
    </message>
    <message>
        <source>{endpoint} did not answer within {seconds} s</source>
        <translation>{endpoint} hat nicht innerhalb von {seconds} s geantwortet</translation>
    </message>
    <message>
        <source>{endpoint} did not answer as a drive does: expected {expected}, got {quote}</source>
        <translation>{endpoint} antwortet nicht wie ein Antrieb: erwartet {expected}, erhalten {quote}</translation>
    </message>
    <message>
        <source>the drive refused: {reason}</source>
        <translation>der Antrieb hat abgelehnt: {reason}</translation>
    </message>
    <message>
        <source>the drive has no register {path}</source>
        <translation>der Antrieb hat kein Register {path}</translation>
    </message>
    <message>
        <source>the drive has no file {path}</source>
        <translation>der Antrieb hat keine Datei {path}</translation>
    </message>
    <message>
        <source>the drive does not allow this now: {reason}</source>
        <translation>der Antrieb lässt das jetzt nicht zu: {reason}</translation>
    </message>
    <message>
        <source>the table does not fit: {reason}</source>
        <translation>die Tabelle passt nicht: {reason}</translation>
    </message>
    <message>
        <source>the drive refused the table: {reason}</source>
        <translation>der Antrieb hat die Tabelle abgelehnt: {reason}</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s, or write volatile</source>
        <translation>zu viele Flash-Vorgänge in kurzer Zeit; {seconds} s warten oder flüchtig schreiben</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is in error {error}: {hint}</source>
        <translation>die Kompensation der Achse {axis} meldet den Fehler {error}: {hint}</translation>
    </message>
    <message>
        <source>the drive has no axis {axis}; it has: {known}</source>
        <translation>der Antrieb hat keine Achse {axis}; vorhanden: {known}</translation>
    </message>
    <message>
        <source>several axes are named {axis}: give the index, one of {matches}</source>
        <translation>mehrere Achsen heißen {axis}: den Index angeben, einen von {matches}</translation>
    </message>
    <message>
        <source>axis {axis} of this drive has no compensation registers</source>
        <translation>Achse {axis} dieses Antriebs hat keine Kompensationsregister</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} is missing</source>
        <translation>die Quelle der Dimension {dimension} fehlt</translation>
    </message>
    <message>
        <source>the drive has no register {source}{nearest}</source>
        <translation>der Antrieb hat kein Register {source}{nearest}</translation>
    </message>
    <message>
        <source>{source} is of type {type}; a dimension source must be one of {allowed}</source>
        <translation>{source} hat den Typ {type}; eine Dimensionsquelle braucht einen dieser Typen: {allowed}</translation>
    </message>
    <message>
        <source>{source} is a register of the drive {other}; a source must be on the drive itself, {drive}</source>
        <translation>{source} ist ein Register des Antriebs {other}; eine Quelle muss auf dem Antrieb selbst liegen, {drive}</translation>
    </message>
    <message>
        <source>{source} is the source of both dimension {first} and dimension {second}</source>
        <translation>{source} ist Quelle sowohl der Dimension {first} als auch der Dimension {second}</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or correct the unit in the file</source>
        <translation>{doubt} Wählen Sie eine andere Quelle oder Spalte, oder berichtigen Sie die Einheit in der Datei</translation>
    </message>
    <message>
        <source>the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds {largest}</source>
        <translation>die Tabelle braucht {size} Byte, der größte verfügbare Tabellenplatz {slot} fasst nur {largest}</translation>
    </message>
    <message>
        <source>the drive has no slot {slot}; it has: {known}</source>
        <translation>der Antrieb hat keinen Tabellenplatz {slot}; vorhanden: {known}</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}</source>
        <translation>Tabellenplatz {slot} ist belegt durch {user}</translation>
    </message>
    <message>
        <source>no slot is free for a table of {size} bytes: {slots}; name one to overwrite it</source>
        <translation>kein Tabellenplatz ist frei für eine Tabelle mit {size} Byte: {slots}; zum Überschreiben einen angeben</translation>
    </message>
    <message>
        <source>axis {axis} has no table on the drive; write one first</source>
        <translation>Achse {axis} hat keine Tabelle auf dem Antrieb; zuerst eine schreiben</translation>
    </message>
    <message>
        <source>axis {axis} already has all of this; there is nothing to write</source>
        <translation>Achse {axis} hat das alles schon; es gibt nichts zu schreiben</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is active; deactivate it first</source>
        <translation>die Kompensation der Achse {axis} ist aktiv; zuerst deaktivieren</translation>
    </message>
    <message>
        <source>axis {axis} must be homed first</source>
        <translation>Achse {axis} muss zuerst referenziert werden</translation>
    </message>
    <message>
        <source>this is another drive: expected serial number {expected}, found {found}</source>
        <translation>das ist ein anderer Antrieb: erwartet Seriennummer {expected}, gefunden {found}</translation>
    </message>
    <message>
        <source>somebody else changed {what} from {before} to {now}; nothing was written, look again</source>
        <translation>inzwischen geändert: {what}, vorher {before}, jetzt {now}; es wurde nichts geschrieben, bitte neu prüfen</translation>
    </message>
    <message>
        <source>{what} read back as {found}, but {expected} was written</source>
        <translation>{what}: zurückgelesen {found}, geschrieben {expected}</translation>
    </message>
    <message>
        <source>the drive does not add what it should: {what} at {position} is {found}, expected {expected}</source>
        <translation>der Antrieb addiert nicht, was er soll: {what} bei {position} ist {found}, erwartet {expected}</translation>
    </message>
    <message>
        <source>{reason}. The drive holds the complete old or the complete new state; ask for the status when it answers again. The old state is kept in {backup}</source>
        <translation>{reason}. Der Antrieb hat vollständig den alten oder vollständig den neuen Zustand; den Status abfragen, sobald er wieder antwortet. Der alte Zustand ist gesichert in {backup}</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis; restore it from {backup}</source>
        <translation>{reason}; auch das Zurückstellen des alten Zustands ist fehlgeschlagen ({rollback}). Die Achse nicht aktivieren, sondern wiederherstellen aus {backup}</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation>das Speicherkontingent ist erschöpft</translation>
    </message>
    <message>
        <source>the file system is read-only</source>
        <translation>das Dateisystem ist schreibgeschützt</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>das ist ein Ordner</translation>
    </message>
    <message>
        <source>a part of the path is not a folder</source>
        <translation>ein Teil des Pfads ist kein Ordner</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>die symbolischen Links führen im Kreis</translation>
    </message>
    <message>
        <source>it would be larger than a file may be here</source>
        <translation>die Datei würde größer, als hier erlaubt ist</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>der Datenträger meldet einen Fehler</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Arbeitsspeicher reicht nicht</translation>
    </message>
    <message>
        <source>the folder {folder} does not exist</source>
        <translation>der Ordner {folder} ist nicht vorhanden</translation>
    </message>
    <message>
        <source>more than {size}</source>
        <translation>mehr als {size}</translation>
    </message>
    <message>
        <source>another program is using it; try again when that one has finished</source>
        <translation>ein anderes Programm verwendet sie gerade; danach erneut versuchen</translation>
    </message>
    <message>
        <source>it cannot be locked: {reason}</source>
        <translation>Sperren nicht möglich: {reason}</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>kein gültiges JSON</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>das Dokument</translation>
    </message>
    <message>
        <source>line {line}, column {column}</source>
        <translation>Zeile {line}, Spalte {column}</translation>
    </message>
    <message>
        <source>{place}: {problem}</source>
        <translation>{place}: {problem}</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is there twice in one object</source>
        <translation>der Eintrag &quot;{name}&quot; kommt in einem Objekt zweimal vor</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is not known</source>
        <translation>der Eintrag &quot;{name}&quot; ist unbekannt</translation>
    </message>
    <message>
        <source>it has more than {count} values</source>
        <translation>mehr als {count} Werte</translation>
    </message>
    <message>
        <source>it is nested deeper than {count} levels</source>
        <translation>tiefer als {count} Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>it has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{size} Byte; höchstens {limit} sind für eine solche Datei möglich</translation>
    </message>
    <message>
        <source>an object is expected, not {found}</source>
        <translation>erwartet wird ein Objekt, gefunden: {found}</translation>
    </message>
    <message>
        <source>a list is expected, not {found}</source>
        <translation>erwartet wird eine Liste, gefunden: {found}</translation>
    </message>
    <message>
        <source>a text is expected, not {found}</source>
        <translation>erwartet wird ein Text, gefunden: {found}</translation>
    </message>
    <message>
        <source>true or false is expected, not {found}</source>
        <translation>erwartet wird true oder false, gefunden: {found}</translation>
    </message>
    <message>
        <source>a number is expected, not {found}</source>
        <translation>erwartet wird eine Zahl, gefunden: {found}</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most} is expected, not {found}</source>
        <translation>erwartet wird eine ganze Zahl von {least} bis {most}, gefunden: {found}</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>this is missing</source>
        <translation>das fehlt</translation>
    </message>
    <message>
        <source>this is not base64</source>
        <translation>das ist kein Base64</translation>
    </message>
    <message>
        <source>this is too large for a Single</source>
        <translation>das ist zu groß für Single</translation>
    </message>
    <message>
        <source>a number is expected, or NaN, Infinity, -Infinity as a text</source>
        <translation>erwartet wird eine Zahl, oder NaN, Infinity, -Infinity als Text</translation>
    </message>
    <message>
        <source>the bytes have the CRC-32 {crc}, so they are damaged</source>
        <translation>die Bytes haben die CRC-32 {crc}, sind also beschädigt</translation>
    </message>
    <message>
        <source>this file is there twice</source>
        <translation>diese Datei kommt zweimal vor</translation>
    </message>
    <message>
        <source>this axis of the drive is there twice</source>
        <translation>diese Achse des Antriebs kommt zweimal vor</translation>
    </message>
    <message>
        <source>&quot;{format}&quot; is expected</source>
        <translation>erwartet wird &quot;{format}&quot;</translation>
    </message>
    <message>
        <source>only version {version} can be read; a newer version of this program may have written it</source>
        <translation>lesbar ist nur Version {version}; vielleicht stammt die Datei von einer neueren Programmversion</translation>
    </message>
    <message>
        <source>one of Boolean, Int32, UInt32, Single, Double, Enum is expected</source>
        <translation>erwartet wird Boolean, Int32, UInt32, Single, Double oder Enum</translation>
    </message>
    <message>
        <source>a time such as 2026-11-21T08:02:23Z is expected</source>
        <translation>erwartet wird eine Zeit wie 2026-11-21T08:02:23Z</translation>
    </message>
    <message>
        <source>a CRC-32 of eight hexadecimal digits such as 1c291ca3 is expected</source>
        <translation>erwartet wird eine CRC-32 aus acht Hexadezimalziffern wie 1c291ca3</translation>
    </message>
    <message>
        <source>it was closed before the reply was complete</source>
        <translation>sie wurde geschlossen, bevor die Antwort vollständig war</translation>
    </message>
    <message>
        <source>nothing listens there; is the drive switched on, and is the address right?</source>
        <translation>dort antwortet nichts; ist der Antrieb eingeschaltet und stimmt die Adresse?</translation>
    </message>
    <message>
        <source>the network does not know the name {name}</source>
        <translation>der Name {name} ist im Netzwerk unbekannt</translation>
    </message>
    <message>
        <source>there is no https; try http://, or another port</source>
        <translation>kein https vorhanden; http:// oder einen anderen Port versuchen</translation>
    </message>
    <message>
        <source>write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or demo:</source>
        <translation>möglich sind http://host[:port], https://host[:port], serial:/dev/ttyUSB0 oder demo:</translation>
    </message>
    <message>
        <source>the host is missing; write http://192.168.1.20 or http://host:8080</source>
        <translation>der Host fehlt; anzugeben als http://192.168.1.20 oder http://host:8080</translation>
    </message>
    <message>
        <source>only host and port belong here, no path</source>
        <translation>hierher gehören nur Host und Port, kein Pfad</translation>
    </message>
    <message>
        <source>port 0 cannot be reached</source>
        <translation>Port 0 ist nicht erreichbar</translation>
    </message>
    <message>
        <source>the device must be an absolute path such as serial:/dev/ttyUSB0</source>
        <translation>das Gerät muss ein absoluter Pfad sein wie serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>the only option is baud, as in serial:/dev/ttyUSB0?baud=115200</source>
        <translation>die einzige Option ist baud wie in serial:/dev/ttyUSB0?baud=115200</translation>
    </message>
    <message>
        <source>you have no permission to look into its folder</source>
        <translation>keine Berechtigung für den Ordner</translation>
    </message>
    <message>
        <source>the port cannot be used</source>
        <translation>der Anschluss kann nicht verwendet werden</translation>
    </message>
    <message>
        <source>the serial port is gone; was the cable or the adapter unplugged?</source>
        <translation>der serielle Anschluss ist weg; wurde das Kabel oder der Adapter ausgesteckt?</translation>
    </message>
    <message>
        <source>another program is using the port; close it there</source>
        <translation>ein anderes Programm verwendet den Anschluss; dort schließen</translation>
    </message>
    <message>
        <source>this is no serial port ({reason})</source>
        <translation>das ist kein serieller Anschluss ({reason})</translation>
    </message>
    <message>
        <source>the port cannot do {speed} baud</source>
        <translation>der Anschluss kann {speed} Baud nicht</translation>
    </message>
    <message>
        <source>the reply of a drive at {speed} baud</source>
        <translation>die Antwort eines Antriebs mit {speed} Baud</translation>
    </message>
    <message>
        <source>name, serial number, axes and profile</source>
        <translation>Name, Seriennummer, Achsen und Profil</translation>
    </message>
    <message>
        <source>the number of lines that follow</source>
        <translation>die Anzahl der Zeilen, die folgen</translation>
    </message>
    <message>
        <source>the line garbles too much; check the cable, or try a lower baud rate</source>
        <translation>die Leitung verfälscht zu viel; das Kabel prüfen oder eine niedrigere Baudrate versuchen</translation>
    </message>
    <message>
        <source>the drive began anew</source>
        <translation>der Antrieb hat von vorn begonnen</translation>
    </message>
    <message>
        <source>a size of at most {most} and a CRC</source>
        <translation>eine Größe von höchstens {most} und eine CRC</translation>
    </message>
    <message>
        <source>a type and a value</source>
        <translation>ein Typ und ein Wert</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>eine Adresse</translation>
    </message>
    <message>
        <source>how many registers there are</source>
        <translation>die Anzahl der Register</translation>
    </message>
    <message>
        <source>path, address, type and value</source>
        <translation>Pfad, Adresse, Typ und Wert</translation>
    </message>
    <message>
        <source>the rest of the registers</source>
        <translation>die übrigen Register</translation>
    </message>
    <message>
        <source>the serial link writes 1 to {most} registers at one instant, not {count}</source>
        <translation>die serielle Verbindung schreibt 1 bis {most} Register zugleich, nicht {count}</translation>
    </message>
    <message>
        <source>path, size and maximum size</source>
        <translation>Pfad, Größe und größte Größe</translation>
    </message>
    <message>
        <source>a redirect to {address}</source>
        <translation>eine Weiterleitung nach {address}</translation>
    </message>
    <message>
        <source>a redirect to {address}; give its address with https://</source>
        <translation>eine Weiterleitung nach {address}; die Adresse mit https:// angeben</translation>
    </message>
    <message>
        <source>the answer itself</source>
        <translation>die Antwort selbst</translation>
    </message>
    <message>
        <source>success or a refusal</source>
        <translation>Erfolg oder eine Ablehnung</translation>
    </message>
    <message>
        <source>HTTP status {status}</source>
        <translation>HTTP-Status {status}</translation>
    </message>
    <message>
        <source>HTTP status {status}, {text}</source>
        <translation>HTTP-Status {status}, {text}</translation>
    </message>
    <message>
        <source>HTTP status {status} and {text}</source>
        <translation>HTTP-Status {status} und {text}</translation>
    </message>
    <message>
        <source>an HTTP reply</source>
        <translation>eine HTTP-Antwort</translation>
    </message>
    <message>
        <source>the status line of an HTTP reply</source>
        <translation>die Statuszeile einer HTTP-Antwort</translation>
    </message>
    <message>
        <source>a header field of an HTTP reply</source>
        <translation>ein Kopffeld einer HTTP-Antwort</translation>
    </message>
    <message>
        <source>a head of at most 64 KiB</source>
        <translation>ein Kopf mit höchstens 64 KiB</translation>
    </message>
    <message>
        <source>one Content-Length</source>
        <translation>ein Content-Length</translation>
    </message>
    <message>
        <source>no Transfer-Encoding but chunked</source>
        <translation>als Transfer-Encoding nur chunked</translation>
    </message>
    <message>
        <source>the size of a chunk</source>
        <translation>die Größe eines Blocks</translation>
    </message>
    <message>
        <source>the end of a chunk</source>
        <translation>das Ende eines Blocks</translation>
    </message>
    <message>
        <source>at most {count} files</source>
        <translation>höchstens {count} Dateien</translation>
    </message>
    <message>
        <source>file paths without blanks</source>
        <translation>Dateipfade ohne Leerzeichen</translation>
    </message>
    <message>
        <source>an actual size of {path} up to its maximum size</source>
        <translation>eine Größe von {path} bis zur Höchstgröße</translation>
    </message>
    <message>
        <source>the file {path} once</source>
        <translation>die Datei {path} einmal</translation>
    </message>
    <message>
        <source>a file, its size and its maximum size in each row</source>
        <translation>eine Datei, ihre Größe und ihre Höchstgröße in jeder Zeile</translation>
    </message>
    <message>
        <source>sizes in bytes</source>
        <translation>Größen in Byte</translation>
    </message>
    <message>
        <source>a JSON array of files</source>
        <translation>ein JSON-Array von Dateien</translation>
    </message>
    <message>
        <source>a file with path, size and maximumSize</source>
        <translation>eine Datei mit path, size und maximumSize</translation>
    </message>
    <message>
        <source>at least one file in the table</source>
        <translation>mindestens eine Datei in der Tabelle</translation>
    </message>
    <message>
        <source>a Directory page with a table of File, actual size and maximum size</source>
        <translation>eine Directory-Seite mit einer Tabelle aus File, actual size und maximum size</translation>
    </message>
    <message>
        <source>a JSON array of registers</source>
        <translation>ein JSON-Array von Registern</translation>
    </message>
    <message>
        <source>a register with path, address, type and a value of that type</source>
        <translation>ein Register mit path, address, type und einem Wert dieses Typs</translation>
    </message>
    <message>
        <source>registers below {path}</source>
        <translation>Register unterhalb von {path}</translation>
    </message>
    <message>
        <source>at most 1024 axes</source>
        <translation>höchstens 1024 Achsen</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>status 204 without a body</source>
        <translation>Status 204 ohne Inhalt</translation>
    </message>
    <message>
        <source>a file with its Content-Length</source>
        <translation>eine Datei mit Content-Length</translation>
    </message>
    <message>
        <source>the bytes of {path}</source>
        <translation>die Bytes von {path}</translation>
    </message>
    <message>
        <source>a reply</source>
        <translation>eine Antwort</translation>
    </message>
    <message>
        <source>flipped bytes</source>
        <translation>verfälschte Bytes</translation>
    </message>
    <message>
        <source>the connection was cut</source>
        <translation>die Verbindung wurde getrennt</translation>
    </message>
    <message>
        <source>the drive rebooted</source>
        <translation>der Antrieb ist neu gestartet</translation>
    </message>
    <message>
        <source>a request reads at most {most} registers, not {count}</source>
        <translation>eine Anfrage liest höchstens {most} Register, nicht {count}</translation>
    </message>
    <message>
        <source>a request writes 1 to {most} registers, not {count}</source>
        <translation>eine Anfrage schreibt 1 bis {most} Register, nicht {count}</translation>
    </message>
    <message>
        <source>{path} is written twice in one request</source>
        <translation>{path} wird in einer Anfrage zweimal geschrieben</translation>
    </message>
    <message>
        <source>{path} is read-only</source>
        <translation>{path} ist nur lesbar</translation>
    </message>
    <message>
        <source>{path} is of type {type}, and cannot be {value}</source>
        <translation>{path} hat den Typ {type} und kann nicht {value} sein</translation>
    </message>
    <message>
        <source>{path} is of type {type}, one of {names}, and cannot be {value}</source>
        <translation>{path} hat den Typ {type}, also einen der Werte {names}, und kann nicht {value} sein</translation>
    </message>
    <message>
        <source>the compensation of {axis} is on, so {what} must stay; deactivate it</source>
        <translation>die Kompensation ist eingeschaltet ({axis}), daher unveränderlich: {what}; zuerst deaktivieren</translation>
    </message>
    <message>
        <source>its homing</source>
        <translation>die Referenzierung</translation>
    </message>
    <message>
        <source>the table in {slot}</source>
        <translation>die Tabelle in {slot}</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be persistent</source>
        <translation>in {slot} ist keine Tabelle, die dauerhaft werden könnte</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be committed</source>
        <translation>in {slot} ist keine Tabelle, die sich im Flash ablegen ließe</translation>
    </message>
    <message>
        <source>{path} can have {most} bytes, not {size}</source>
        <translation>{path} fasst {most} Byte, nicht {size}</translation>
    </message>
    <message>
        <source>the drive&apos;s flash failed: {reason}</source>
        <translation>der Flash-Speicher des Antriebs hat versagt: {reason}</translation>
    </message>
    <message>
        <source>the axis must be homed first</source>
        <translation>die Achse muss zuerst referenziert werden</translation>
    </message>
    <message>
        <source>the axis has no table; write one first</source>
        <translation>die Achse hat keine Tabelle; zuerst eine schreiben</translation>
    </message>
    <message>
        <source>the number of sources must equal the table&apos;s dimensions</source>
        <translation>es muss so viele Quellen geben, wie die Tabelle Dimensionen hat</translation>
    </message>
    <message>
        <source>a source is not a Single or Double register of this drive</source>
        <translation>eine Quelle ist kein Single- oder Double-Register dieses Antriebs</translation>
    </message>
    <message>
        <source>the drive cannot use the table; write it again</source>
        <translation>der Antrieb kann die Tabelle nicht verwenden; neu schreiben</translation>
    </message>
    <message>
        <source>see the drive&apos;s manual</source>
        <translation>siehe Handbuch des Antriebs</translation>
    </message>
    <message>
        <source>the drive has restarted, or somebody else has switched the compensation</source>
        <translation>der Antrieb wurde neu gestartet, oder jemand anders hat die Kompensation geschaltet</translation>
    </message>
    <message>
        <source>it did not become {state} in time</source>
        <translation>der Zustand {state} wurde nicht rechtzeitig erreicht</translation>
    </message>
    <message>
        <source>only an active or an evaluating compensation can be proved</source>
        <translation>nur eine aktive oder auswertende Kompensation lässt sich nachweisen</translation>
    </message>
    <message>
        <source>No other slot is free: the table in {slot} is overwritten. A copy is kept in the backup.</source>
        <translation>Kein anderer Tabellenplatz ist frei: die Tabelle in {slot} wird überschrieben. Die Sicherung enthält eine Kopie.</translation>
    </message>
    <message>
        <source>What {slot} holds now is overwritten. A copy is kept in the backup.</source>
        <translation>Der jetzige Inhalt von {slot} wird überschrieben. Die Sicherung enthält eine Kopie.</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved, but the table of {axis} in {slot} is volatile: after a reboot that axis has no table.</source>
        <translation>Gespeichert werden die Parameter aller Achsen, doch eine Tabelle ist flüchtig ({axis}, {slot}): nach einem Neustart hat diese Achse keine Tabelle.</translation>
    </message>
    <message>
        <source>The new table is volatile and covers an older one that flash holds in {slot}: after a reboot the axis may have that one again, until the parameters are saved, which deletes it.</source>
        <translation>Die neue Tabelle ist flüchtig und verdeckt eine ältere, die im Flash von {slot} liegt: nach einem Neustart hat die Achse womöglich wieder diese, bis die Parameter gespeichert werden; dabei wird sie gelöscht.</translation>
    </message>
    <message>
        <source>After a reboot the drive would look for another table in {slot}: the parameters are saved once before the new one goes into flash. When the write is interrupted then, the axis may have no table after a reboot.</source>
        <translation>Nach einem Neustart suchte der Antrieb eine andere Tabelle in {slot}: die Parameter werden einmal gespeichert, bevor die neue in den Flash kommt. Wird das Schreiben dann unterbrochen, hat die Achse nach einem Neustart womöglich keine Tabelle.</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: it is deleted before the parameters are saved.</source>
        <translation>Im Flash von {slot} liegt womöglich eine ältere Tabelle: sie wird gelöscht, bevor die Parameter gespeichert werden.</translation>
    </message>
    <message>
        <source>the settings of {axis}</source>
        <translation>Einstellungen von {axis}</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>Achse {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>Achse {axis} ({name})</translation>
    </message>
    <message>
        <source>axis {axis} after a reboot</source>
        <translation>Achse {axis} nach einem Neustart</translation>
    </message>
    <message>
        <source>the cogging compensation of axis {axis}</source>
        <translation>Rastmomentkompensation der Achse {axis}</translation>
    </message>
    <message>
        <source>{slot} holds only {size} bytes</source>
        <translation>{slot} fasst nur {size} Byte</translation>
    </message>
    <message>
        <source>{slot} is used by {user}</source>
        <translation>{slot} ist belegt durch {user}</translation>
    </message>
    <message>
        <source>{slot} holds a table that is not this axis&apos;s</source>
        <translation>{slot} enthält eine Tabelle, die nicht zu dieser Achse gehört</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), persistent</source>
        <translation>{table} (CRC {crc}), dauerhaft</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), volatile</source>
        <translation>{table} (CRC {crc}), flüchtig</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, persistent</source>
        <translation>{table} (CRC {crc}), {sources}, dauerhaft</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, volatile</source>
        <translation>{table} (CRC {crc}), {sources}, flüchtig</translation>
    </message>
    <message>
        <source>{path} at offset {offset}</source>
        <translation>{path} bei Byte {offset}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>the output</source>
        <translation>der Ausgang</translation>
    </message>
    <message>
        <source>the index of dimension {dimension}</source>
        <translation>der Index der Dimension {dimension}</translation>
    </message>
    <message>
        <source>the dimensionality is 1, 2 or 3</source>
        <translation>die Dimensionalität ist 1, 2 oder 3</translation>
    </message>
    <message>
        <source>; a URI is written tam://mc/&lt;drive&gt;/&lt;path&gt;</source>
        <translation>; eine URI lautet tam://mc/&lt;Antrieb&gt;/&lt;Pfad&gt;</translation>
    </message>
    <message>
        <source>; an address is written 0x and 1 to 8 hex digits</source>
        <translation>; eine Adresse besteht aus 0x und 1 bis 8 Hexadezimalziffern</translation>
    </message>
    <message>
        <source>: no register has this address</source>
        <translation>: kein Register hat diese Adresse</translation>
    </message>
    <message>
        <source>; the nearest are {names}</source>
        <translation>; am ähnlichsten sind {names}</translation>
    </message>
    <message>
        <source>there is no backup that differs from what the axis has now</source>
        <translation>es gibt keine Sicherung, die sich vom jetzigen Zustand der Achse unterscheidet</translation>
    </message>
    <message>
        <source>the program is ending</source>
        <translation>das Programm wird beendet</translation>
    </message>
    <message>
        <source>the backup</source>
        <translation>die Sicherung</translation>
    </message>
    <message>
        <source>axis {axis} has no Table register</source>
        <translation>Achse {axis} hat kein Register Table</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with {separator} instead of tabs</source>
        <translation>{expected}; die Spalten mit {separator} statt mit Tabulatoren trennen</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ; instead of tabs</source>
        <translation>{expected}; die Spalten mit , oder ; statt mit Tabulatoren trennen</translation>
    </message>
    <message>
        <source>{path} of type Int32</source>
        <translation>{path} vom Typ Int32</translation>
    </message>
    <message>
        <source>the settings of axis {axis}</source>
        <translation>Einstellungen von Achse {axis}</translation>
    </message>
    <message>
        <source>the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is {fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has the same</source>
        <translation>dem Zertifikat von {endpoint} kann nicht vertraut werden: {reason}. Sein SHA-256-Fingerabdruck ist {fingerprint}; vertrauen Sie ihm unter Verbindungen oder mit --trust-certificate, wenn der Antrieb denselben hat</translation>
    </message>
    <message>
        <source>it has CHANGED and is not the one that was trusted</source>
        <translation>es hat sich GEÄNDERT und ist nicht das, dem vertraut wurde</translation>
    </message>
    <message>
        <source>no write to axis {axis} is unfinished; there is nothing to finish or to undo</source>
        <translation>kein Schreibvorgang für Achse {axis} ist unterbrochen; es gibt nichts zu vollenden oder rückgängig zu machen</translation>
    </message>
    <message>
        <source>the new table of the unfinished write to axis {axis} was not kept on this computer: write it again, or undo the write</source>
        <translation>die neue Tabelle für Achse {axis} fehlt auf diesem Rechner: neu schreiben oder rückgängig machen</translation>
    </message>
    <message>
        <source>slot {slot}</source>
        <translation>Tabellenplatz {slot}</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent</source>
        <translation>{count} Werte (CRC {crc}), dauerhaft</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile</source>
        <translation>{count} Werte (CRC {crc}), flüchtig</translation>
    </message>
    <message>
        <source>empty, used by {user}</source>
        <translation>leer, benutzt von {user}</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent, used by {user}</source>
        <translation>{count} Werte (CRC {crc}), dauerhaft, benutzt von {user}</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile, used by {user}</source>
        <translation>{count} Werte (CRC {crc}), flüchtig, benutzt von {user}</translation>
    </message>
    <message>
        <source>the unfinished write to axis {axis}</source>
        <translation>den unterbrochenen Schreibvorgang für Achse {axis}</translation>
    </message>
    <message>
        <source>the name of a file beside the journal is expected</source>
        <translation>hier gehört der Name einer Datei neben dem Journal hin</translation>
    </message>
    <message>
        <source>it is not of axis {axis} of this drive</source>
        <translation>sie ist nicht von Achse {axis} dieses Antriebs</translation>
    </message>
    <message>
        <source>{file} can be one of several formats: {candidates}; say which one it is</source>
        <translation>{file} kann eines von mehreren Formaten sein: {candidates}; bitte angeben, welches es ist</translation>
    </message>
    <message>
        <source>the format {format} cannot hold this table: {reason}; {wayOut}</source>
        <translation>das Format {format} kann diese Tabelle nicht aufnehmen: {reason}; {wayOut}</translation>
    </message>
    <message>
        <source>the sign cannot be converted at {position}: {reason}</source>
        <translation>das Vorzeichen lässt sich bei {position} nicht umrechnen: {reason}</translation>
    </message>
    <message>
        <source>the table cannot be resampled: {reason}</source>
        <translation>die Tabelle lässt sich nicht auf ein anderes Gitter bringen: {reason}</translation>
    </message>
    <message>
        <source>the numbers of the file are taken as they are</source>
        <translation>die Zahlen der Datei werden übernommen, wie sie sind</translation>
    </message>
    <message>
        <source>sign: {from}; {example}</source>
        <translation>Vorzeichen: {from}; {example}</translation>
    </message>
    <message>
        <source>{format} holds feedback values</source>
        <translation>{format} enthält Werte der Geberseite (feedback)</translation>
    </message>
    <message>
        <source>{format} holds command values</source>
        <translation>{format} enthält Werte der Sollseite (command)</translation>
    </message>
    <message>
        <source>{format} holds feedback values, as you say</source>
        <translation>{format} enthält nach Ihrer Angabe Werte der Geberseite (feedback)</translation>
    </message>
    <message>
        <source>{format} holds command values, as you say</source>
        <translation>{format} enthält nach Ihrer Angabe Werte der Sollseite (command)</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}</source>
        <translation>{example}: in der Datei der Geberseite steht {value}</translation>
    </message>
    <message>
        <source>{example}: the command file says {value}</source>
        <translation>{example}: in der Datei der Sollseite steht {value}</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}, the command file {other}</source>
        <translation>{example}: in der Datei der Geberseite steht {value}, in der der Sollseite {other}</translation>
    </message>
    <message>
        <source>all values are 0, in either sign</source>
        <translation>alle Werte sind 0, mit jedem Vorzeichen</translation>
    </message>
    <message>
        <source>moving in positive direction, {example}</source>
        <translation>in positiver Richtung: {example}</translation>
    </message>
    <message>
        <source>moving in negative direction, {example}</source>
        <translation>in negativer Richtung: {example}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference says {moved}</source>
        <translation>wo der Geber {place} meldet, zeigt die Referenz {moved}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} says {moved}</source>
        <translation>wo die Geber {place} melden, zeigt die Referenz von {axis} {moved}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>wo der Geber {place} meldet, liegt die Referenz von {axis} {offset} über ihrem Geber</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>wo der Geber {place} meldet, liegt die Referenz von {axis} {offset} unter ihrem Geber</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>wo die Geber {place} melden, liegt die Referenz von {axis} {offset} über ihrem Geber</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>wo die Geber {place} melden, liegt die Referenz von {axis} {offset} unter ihrem Geber</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}, where the reference says {reference}</source>
        <translation>bei der Sollposition {place} fährt die Steuerung den Geber auf {moved}, wo die Referenz {reference} zeigt</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}, where the reference says {reference}</source>
        <translation>bei der Sollposition {place} fährt die Steuerung den Geber von {axis} auf {moved}, wo die Referenz {reference} zeigt</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} above its encoder, the controller moves {target} by {value}</source>
        <translation>bei der Sollposition {place}, wo die Referenz von {axis} {offset} über ihrem Geber liegt, verschiebt die Steuerung {target} um {value}</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} below its encoder, the controller moves {target} by {value}</source>
        <translation>bei der Sollposition {place}, wo die Referenz von {axis} {offset} unter ihrem Geber liegt, verschiebt die Steuerung {target} um {value}</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>die Zielachse</translation>
    </message>
    <message>
        <source>{axis} = {position}</source>
        <translation>{axis} = {position}</translation>
    </message>
    <message>
        <source>resampled from {before} points to {after} points: at the positions of the source it is off by at most {largest}, {rms} rms</source>
        <translation>von {before} auf {after} Punkte umgerechnet: an den Positionen der Quelle weicht es höchstens um {largest} ab, im Effektivwert um {rms}</translation>
    </message>
    <message>
        <source>the values of the file are rounded by up to {amount}</source>
        <translation>die Werte der Datei sind um bis zu {amount} gerundet</translation>
    </message>
    <message>
        <source>the positions of the file are rounded by up to {amount}</source>
        <translation>die Positionen der Datei sind um bis zu {amount} gerundet</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules: {difference}</source>
        <translation>verglichen an {count} Positionen, jede nach den Regeln ihrer Steuerung: {difference}</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules ({column}): {difference}</source>
        <translation>verglichen an {count} Positionen, jede nach den Regeln ihrer Steuerung ({column}): {difference}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}</source>
        <translation>sie unterscheiden sich höchstens um {largest} bei {place}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, where both have values by at most {inside}</source>
        <translation>sie unterscheiden sich höchstens um {largest} bei {place}, wo beide Werte haben höchstens um {inside}</translation>
    </message>
    <message>
        <source>at the ends of the table the sign was converted with the end values held, where the controller of the source applies nothing</source>
        <translation>an den Enden der Tabelle wurde das Vorzeichen mit gehaltenen Endwerten umgerechnet, wo die Steuerung der Quelle nichts korrigiert</translation>
    </message>
    <message>
        <source>the {what} have no unit; they are taken to be {unit}</source>
        <translation>die Einheit fehlt ({what}); angenommen wird {unit}</translation>
    </message>
    <message>
        <source>the positions are in {unit}</source>
        <translation>die Positionen sind in {unit}</translation>
    </message>
    <message>
        <source>the values are in {unit}</source>
        <translation>die Werte sind in {unit}</translation>
    </message>
    <message>
        <source>positions and values are in {unit}</source>
        <translation>Positionen und Werte sind in {unit}</translation>
    </message>
    <message>
        <source>no known unit</source>
        <translation>keiner bekannten Einheit</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} behind it</source>
        <translation>{range}: das Gitter endet bei {end}, {distance} dahinter</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} before its end</source>
        <translation>{range}: das Gitter endet bei {end}, {distance} vor seinem Ende</translation>
    </message>
    <message>
        <source>the range of {axis} from {from} to {to} is no whole multiple of {distance}</source>
        <translation>der Bereich von {axis} von {from} bis {to} ist kein ganzes Vielfaches von {distance}</translation>
    </message>
    <message>
        <source>a number of points is a whole number, at least 2</source>
        <translation>eine Anzahl Punkte ist eine ganze Zahl, mindestens 2</translation>
    </message>
    <message>
        <source>the number for the even grid is missing</source>
        <translation>die Zahl für das gleichmäßige Gitter fehlt</translation>
    </message>
    <message>
        <source>the even grid needs one number, or one for each of the {count} source axes</source>
        <translation>das gleichmäßige Gitter braucht eine Zahl oder je eine für die {count} Quellachsen</translation>
    </message>
    <message>
        <source>the format {format} can be written, not read</source>
        <translation>das Format {format} kann geschrieben, aber nicht gelesen werden</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key} ({meaning})</source>
        <translation>das Format {format} braucht die Angabe {key} ({meaning})</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected {expected} ({meaning})</source>
        <translation>die Angabe {key} ist &quot;{value}&quot;, erwartet wird {expected} ({meaning})</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>one of {choices}</source>
        <translation>eines von {choices}</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes oder no</translation>
    </message>
    <message>
        <source>the positions of source {number} are not evenly spaced</source>
        <translation>die Positionen der Quelle {number} haben keinen gleichmäßigen Abstand</translation>
    </message>
    <message>
        <source>resample it onto an even grid</source>
        <translation>sie auf ein gleichmäßiges Gitter bringen</translation>
    </message>
    <message>
        <source>resample it onto a coarser grid</source>
        <translation>sie auf ein gröberes Gitter bringen</translation>
    </message>
    <message>
        <source>it takes one distance for all sources, and these are different</source>
        <translation>es hat einen Abstand für alle Quellen, und diese sind verschieden</translation>
    </message>
    <message>
        <source>resample it with the same distance for each source</source>
        <translation>sie mit dem gleichen Abstand für jede Quelle umrechnen</translation>
    </message>
    <message>
        <source>it has one value for both directions of motion</source>
        <translation>es hat einen Wert für beide Bewegungsrichtungen</translation>
    </message>
    <message>
        <source>choose the mean, the positive or the negative direction</source>
        <translation>den Mittelwert, die positive oder die negative Richtung wählen</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>ein anderes Format wählen</translation>
    </message>
    <message>
        <source>{count} points are more than the {limit} that the controller takes</source>
        <translation>{count} Punkte sind mehr als die {limit}, die die Steuerung annimmt</translation>
    </message>
    <message>
        <source>it has no modulo axes</source>
        <translation>es hat keine Moduloachsen</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap, in a machine file no-wrap = true) when it stays within one revolution</source>
        <translation>die Achse als lineare behandeln (--no-wrap, in einer Maschinendatei no-wrap = true), wenn sie innerhalb einer Umdrehung bleibt</translation>
    </message>
    <message>
        <source>its values are offsets of the command</source>
        <translation>ihre Werte sind Offsets der Sollposition</translation>
    </message>
    <message>
        <source>convert the sign</source>
        <translation>das Vorzeichen umrechnen</translation>
    </message>
    <message>
        <source>a value is beyond what a float32 can be</source>
        <translation>ein Wert ist größer, als ein float32 sein kann</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>a grid along {axis} needs at least two points</source>
        <translation>ein Gitter entlang {axis} braucht mindestens zwei Punkte</translation>
    </message>
    <message>
        <source>the distance along {axis} must be a number above 0</source>
        <translation>der Abstand entlang {axis} muss eine Zahl über 0 sein</translation>
    </message>
    <message>
        <source>the positions of {axis} are not evenly spaced; give a number of points or a distance</source>
        <translation>die Positionen von {axis} haben keinen gleichmäßigen Abstand; eine Anzahl Punkte oder einen Abstand angeben</translation>
    </message>
    <message>
        <source>the full turn of {axis}, {turn}, is no whole multiple of {distance}; possible are {fewer} or {more}</source>
        <translation>die volle Umdrehung von {axis}, {turn}, ist kein ganzes Vielfaches von {distance}; möglich sind {fewer} oder {more}</translation>
    </message>
    <message>
        <source>a distance of {distance} is longer than the range of {axis} from {from} to {to}; take a shorter one, or let the end values be held</source>
        <translation>ein Abstand von {distance} ist länger als der Bereich von {axis} von {from} bis {to}; einen kürzeren nehmen oder die Endwerte halten lassen</translation>
    </message>
    <message>
        <source>the grid would have more than {count} points; take fewer along an axis</source>
        <translation>das Gitter hätte mehr als {count} Punkte; entlang einer Achse weniger nehmen</translation>
    </message>
    <message>
        <source>calibration file: reference positions and compensation values</source>
        <translation>Kalibrierdatei: Referenzpositionen und Kompensationswerte</translation>
    </message>
    <message>
        <source>table file of the drive, laid out as the drive profile says</source>
        <translation>Tabellendatei des Antriebs, aufgebaut wie im Antriebsprofil</translation>
    </message>
    <message>
        <source>CSV file of positions and offsets</source>
        <translation>CSV-Datei mit Positionen und Offsets</translation>
    </message>
    <message>
        <source>cross compensation in a compensation list (kw.crosscomp)</source>
        <translation>Kreuzkompensation in einer Kompensationsliste (kw.crosscomp)</translation>
    </message>
    <message>
        <source>plane compensation in a compensation list (kw.crosscomp2)</source>
        <translation>Flächenkompensation in einer Kompensationsliste (kw.crosscomp2)</translation>
    </message>
    <message>
        <source>leadscrew error compensation in a compensation list (kw.ssfk)</source>
        <translation>Spindelsteigungsfehlerkompensation in einer Kompensationsliste (kw.ssfk)</translation>
    </message>
    <message>
        <source>compensation file of a joint: nominal forward reverse</source>
        <translation>Kompensationsdatei eines Gelenks: Sollposition vorwärts rückwärts</translation>
    </message>
    <message>
        <source>CSV file of this program with the table of a compensator</source>
        <translation>CSV-Datei dieses Programms mit der Tabelle eines Kompensators</translation>
    </message>
    <message>
        <source>C++ header with the table of a compensator</source>
        <translation>C++-Headerdatei mit der Tabelle eines Kompensators</translation>
    </message>
    <message>
        <source>sag and angularity compensation ($AN_CEC)</source>
        <translation>Durchhang- und Winkligkeitskompensation ($AN_CEC)</translation>
    </message>
    <message>
        <source>encoder and leadscrew error compensation ($AA_ENC_COMP)</source>
        <translation>Geber- und Spindelsteigungsfehlerkompensation ($AA_ENC_COMP)</translation>
    </message>
    <message>
        <source>text table of positions and corrections</source>
        <translation>Texttabelle mit Positionen und Korrekturen</translation>
    </message>
    <message>
        <source>MC-BASIC assignments to SourceData and TargetData</source>
        <translation>MC-BASIC-Zuweisungen an SourceData und TargetData</translation>
    </message>
    <message>
        <source>of a rotary axis: the range after which its position begins again, such as 360</source>
        <translation>bei einer Rundachse: der Bereich, nach dem die Position von vorn beginnt, zum Beispiel 360</translation>
    </message>
    <message>
        <source>logical number of the axis whose position counts, for master_ax_nr</source>
        <translation>logische Nummer der Achse, deren Position zählt, für master_ax_nr</translation>
    </message>
    <message>
        <source>cycles over which switching is smoothed, for n_cycles</source>
        <translation>Takte, über die das Umschalten geglättet wird, für n_cycles</translation>
    </message>
    <message>
        <source>the master is a modulo axis: the first and the last point are one place</source>
        <translation>die Masterachse ist eine Moduloachse: der erste und der letzte Punkt sind dieselbe Stelle</translation>
    </message>
    <message>
        <source>whether the master axis is linear (mm) or rotary (deg)</source>
        <translation>ob die Masterachse linear (mm) oder rotatorisch (Grad) ist</translation>
    </message>
    <message>
        <source>whether the compensated axis is linear (mm) or rotary (deg)</source>
        <translation>ob die kompensierte Achse linear (mm) oder rotatorisch (Grad) ist</translation>
    </message>
    <message>
        <source>whether the axis is linear (mm) or rotary (deg)</source>
        <translation>ob die Achse linear (mm) oder rotatorisch (Grad) ist</translation>
    </message>
    <message>
        <source>metric: 0.1 um and 0.0001 deg; increments: of the encoder</source>
        <translation>metric: 0,1 µm und 0,0001 Grad; increments: Inkremente des Gebers</translation>
    </message>
    <message>
        <source>encoder increments for one mm or degree, of a list in increments</source>
        <translation>Geberinkremente je mm oder Grad, bei einer Liste in Inkrementen</translation>
    </message>
    <message>
        <source>write numbers with decimals, which only newer kernels take</source>
        <translation>Zahlen mit Nachkommastellen schreiben, die nur neuere Kernel lesen</translation>
    </message>
    <message>
        <source>logical number of the axis that is compensated, for kopf.achs_nr</source>
        <translation>logische Nummer der kompensierten Achse, für kopf.achs_nr</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims; 0 is assumed</source>
        <translation>COMP_FILE_TYPE: 0 für gemessene Positionen, 1 für Korrekturen; angenommen wird 0</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims</source>
        <translation>COMP_FILE_TYPE: 0 für gemessene Positionen, 1 für Korrekturen</translation>
    </message>
    <message>
        <source>raw counts of the output axis for one unit of the values</source>
        <translation>Rohinkremente der Ausgangsachse je Einheit der Werte</translation>
    </message>
    <message>
        <source>the same, where the file does not say it</source>
        <translation>Rohinkremente je Einheit der Werte, wenn die Datei sie nicht nennt</translation>
    </message>
    <message>
        <source>unit of the positions, the user unit of the input axes</source>
        <translation>Einheit der Positionen, die Benutzereinheit der Eingangsachsen</translation>
    </message>
    <message>
        <source>unit of the values, the user unit of the output axis; otherwise that of the positions</source>
        <translation>Einheit der Werte, die Benutzereinheit der Ausgangsachse; sonst die der Positionen</translation>
    </message>
    <message>
        <source>namespace of the constants, a C++ name</source>
        <translation>Namensraum der Konstanten, ein C++-Name</translation>
    </message>
    <message>
        <source>unit of the positions, where the file does not say it</source>
        <translation>Einheit der Positionen, wenn die Datei sie nicht nennt</translation>
    </message>
    <message>
        <source>unit of the values, where the file does not say it</source>
        <translation>Einheit der Werte, wenn die Datei sie nicht nennt</translation>
    </message>
    <message>
        <source>index of the first table that is written</source>
        <translation>Nummer der ersten Tabelle, die geschrieben wird</translation>
    </message>
    <message>
        <source>name of the axis whose position counts, instead of the table&apos;s name for it</source>
        <translation>Name der Achse, deren Position zählt, statt des Namens in der Tabelle</translation>
    </message>
    <message>
        <source>name of the axis that is compensated, instead of the table&apos;s name for it</source>
        <translation>Name der kompensierten Achse, statt des Namens in der Tabelle</translation>
    </message>
    <message>
        <source>name of the machine axis, such as X1, instead of the table&apos;s name for it</source>
        <translation>Name der Maschinenachse, zum Beispiel X1, statt des Namens in der Tabelle</translation>
    </message>
    <message>
        <source>measuring system of the axis, instead of that of the program that was read, or 0</source>
        <translation>Messsystem der Achse anstelle desjenigen aus dem gelesenen Programm, sonst 0</translation>
    </message>
    <message>
        <source>name of the compensation table in the MC-BASIC program</source>
        <translation>Name der Kompensationstabelle im MC-BASIC-Programm</translation>
    </message>
    <message>
        <source>the drive stores the table in its flash</source>
        <translation>der Antrieb legt die Tabelle in seinem Flash ab</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: they are the same</source>
        <translation>ein Wert für beide Bewegungsrichtungen, {choice}: sie sind gleich</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: they are the same</source>
        <translation>ein Wert für beide Bewegungsrichtungen, {choice}, für {target}: sie sind gleich</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: half their difference is up to {loss}, at {place}</source>
        <translation>ein Wert für beide Bewegungsrichtungen, {choice}: ihr halber Unterschied ist bis zu {loss}, bei {place}</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: half their difference is up to {loss}, at {place}</source>
        <translation>ein Wert für beide Bewegungsrichtungen, {choice}, für {target}: ihr halber Unterschied ist bis zu {loss}, bei {place}</translation>
    </message>
    <message>
        <source>they do not differ</source>
        <translation>sie unterscheiden sich nicht</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, and not at all where both have values</source>
        <translation>sie unterscheiden sich höchstens um {largest} bei {place}, und gar nicht, wo beide Werte haben</translation>
    </message>
    <message>
        <source>number of the axis, from 1, instead of the table&apos;s name for it</source>
        <translation>Nummer der Achse, ab 1, statt des Namens in der Tabelle</translation>
    </message>
    <message>
        <source>calibration file of single axes (:START)</source>
        <translation>Kalibrierdatei einzelner Achsen (:START)</translation>
    </message>
    <message>
        <source>calibration file of two axes (:START2D)</source>
        <translation>Kalibrierdatei zweier Achsen (:START2D)</translation>
    </message>
    <message>
        <source>numbers of the axes for which METRIC means degrees, such as 4,5; all others mm</source>
        <translation>Nummern der Achsen, für die METRIC Grad bedeutet, zum Beispiel 4,5; für alle anderen mm</translation>
    </message>
    <message>
        <source>what PRIMARY stands for, such as mm</source>
        <translation>wofür PRIMARY steht, zum Beispiel mm</translation>
    </message>
    <message>
        <source>METRIC (mm and degrees), or PRIMARY: the table&apos;s own units are those of the axes</source>
        <translation>METRIC (mm und Grad) oder PRIMARY: die Einheiten der Tabelle sind die der Achsen</translation>
    </message>
    <message>
        <source>[bed_mesh NAME] sections of printer.cfg: heights of the bed</source>
        <translation>Abschnitte [bed_mesh NAME] von printer.cfg: Höhen des Druckbetts</translation>
    </message>
    <message>
        <source>heightmap.csv, version 2: heights of the bed</source>
        <translation>heightmap.csv, Version 2: Höhen des Druckbetts</translation>
    </message>
    <message>
        <source>names of the axes in degrees, such as C,B; all others are in mm, and modulo axes in degrees anyway</source>
        <translation>Namen der Achsen in Grad, zum Beispiel C,B; alle anderen sind in mm, und Moduloachsen ohnehin in Grad</translation>
    </message>
    <message>
        <source>leadscrew compensation of one source (DEFINE COMP)</source>
        <translation>Spindelsteigungskompensation mit einer Quelle (DEFINE COMP)</translation>
    </message>
    <message>
        <source>compensation of a motor by two others (DEFINE COMP)</source>
        <translation>Kompensation eines Motors nach zwei anderen (DEFINE COMP)</translation>
    </message>
    <message>
        <source>encoder counts for one unit, of every motor without a setting of its own</source>
        <translation>Geberinkremente je Einheit, für jeden Motor ohne eigene Angabe</translation>
    </message>
    <message>
        <source>encoder counts for one unit; without it tables are in counts</source>
        <translation>Geberinkremente je Einheit; ohne sie sind Tabellen in Inkrementen</translation>
    </message>
    <message>
        <source>position of the sources that counts: desired (written with D) or actual</source>
        <translation>welche Position der Quellen zählt: Sollposition (desired, mit D geschrieben) oder Istposition (actual)</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the positions</source>
        <translation>Geberinkremente je Einheit der Positionen</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the values</source>
        <translation>Geberinkremente je Einheit der Werte</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the row motor</source>
        <translation>Geberinkremente je Einheit des Zeilenmotors</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the column motor</source>
        <translation>Geberinkremente je Einheit des Spaltenmotors</translation>
    </message>
    <message>
        <source>number of the motor whose position counts, 1 to 32</source>
        <translation>Nummer des Motors, dessen Position zählt, 1 bis 32</translation>
    </message>
    <message>
        <source>number of the motor that is compensated, 1 to 32</source>
        <translation>Nummer des kompensierten Motors, 1 bis 32</translation>
    </message>
    <message>
        <source>number of the motor along a row of entries, 1 to 32</source>
        <translation>Nummer des Motors entlang einer Zeile, 1 bis 32</translation>
    </message>
    <message>
        <source>number of the motor from row to row, 1 to 32</source>
        <translation>Nummer des Motors von Zeile zu Zeile, 1 bis 32</translation>
    </message>
    <message>
        <source>number of the axis that changes along a line, from 1</source>
        <translation>Nummer der Achse, die sich entlang einer Zeile ändert, ab 1</translation>
    </message>
    <message>
        <source>number of the axis that changes from line to line, from 1</source>
        <translation>Nummer der Achse, die sich von Zeile zu Zeile ändert, ab 1</translation>
    </message>
    <message>
        <source>number of the axis of the first corrections, from 1</source>
        <translation>Nummer der Achse der ersten Korrekturen, ab 1</translation>
    </message>
    <message>
        <source>number of the axis of the second corrections, from 1</source>
        <translation>Nummer der Achse der zweiten Korrekturen, ab 1</translation>
    </message>
    <message>
        <source>number of the axis of the third corrections, from 1</source>
        <translation>Nummer der Achse der dritten Korrekturen, ab 1</translation>
    </message>
    <message>
        <source>axis {axis} is named twice</source>
        <translation>die Achse {axis} ist zweimal genannt</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s, or write volatile</source>
        <translation>die übrigen Flash-Vorgänge reichen für die Änderung, aber nicht, um nach einem Fehlschlag alles zurückzustellen; {seconds} s warten oder flüchtig schreiben</translation>
    </message>
    <message>
        <source>{axis} has fewer than two positions</source>
        <translation>{axis} hat weniger als zwei Positionen</translation>
    </message>
    <message>
        <source>the positions of {axis} do not increase strictly</source>
        <translation>die Positionen von {axis} steigen nicht streng</translation>
    </message>
    <message>
        <source>the period of {axis}, {period}, is shorter than the range of its positions, {range}</source>
        <translation>die Periode von {axis}, {period}, ist kürzer als der Bereich ihrer Positionen, {range}</translation>
    </message>
    <message>
        <source>a table has 1 to 3 source axes, this has {count}</source>
        <translation>eine Tabelle hat 1 bis 3 Quellachsen, diese hat {count}</translation>
    </message>
    <message>
        <source>the table has no values</source>
        <translation>die Tabelle hat keine Werte</translation>
    </message>
    <message>
        <source>{number} values for {column}, for {points} points</source>
        <translation>{number} Werte für {column} bei {points} Punkten</translation>
    </message>
    <message>
        <source>a value for {column} is not a finite number</source>
        <translation>ein Wert für {column} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>columns {first} and {second} both correct {axis} in the same direction; keep one of them</source>
        <translation>die Spalten {first} und {second} korrigieren beide {axis} in derselben Richtung; eine davon behalten</translation>
    </message>
    <message>
        <source>values for {column}</source>
        <translation>Werte für {column}</translation>
    </message>
    <message>
        <source>{column}, positive</source>
        <translation>{column}, positiv</translation>
    </message>
    <message>
        <source>{column}, negative</source>
        <translation>{column}, negativ</translation>
    </message>
    <message>
        <source>table {number} of {count}:</source>
        <translation>Tabelle {number} von {count}:</translation>
    </message>
    <message>
        <source>the target without a name</source>
        <translation>die Zielachse ohne Namen</translation>
    </message>
    <message>
        <source>there are two columns for {target} in positive direction; keep one of them</source>
        <translation>für {target} gibt es zwei Spalten in positiver Richtung; eine davon behalten</translation>
    </message>
    <message>
        <source>there are two columns for {target} in negative direction; keep one of them</source>
        <translation>für {target} gibt es zwei Spalten in negativer Richtung; eine davon behalten</translation>
    </message>
    <message>
        <source>for {target} there are values for both directions and others for one; keep one of them</source>
        <translation>für {target} gibt es Werte für beide Richtungen und andere für eine; eines davon behalten</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no mean; choose the positive direction</source>
        <translation>{target} hat nur Werte für die positive Richtung, also keinen Mittelwert; die positive Richtung wählen</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no negative one; choose the positive direction</source>
        <translation>{target} hat nur Werte für die positive Richtung, also keine für die negative; die positive Richtung wählen</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no mean; choose the negative direction</source>
        <translation>{target} hat nur Werte für die negative Richtung, also keinen Mittelwert; die negative Richtung wählen</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no positive one; choose the negative direction</source>
        <translation>{target} hat nur Werte für die negative Richtung, also keine für die positive; die negative Richtung wählen</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with the correction {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap, in a machine file no-wrap = true)</source>
        <translation>eine volle Umdrehung von {axis} beginnt mit der Korrektur {begin} und endet mit {end}; beide gleich machen oder die Achse als lineare behandeln (--no-wrap, in einer Maschinendatei no-wrap = true)</translation>
    </message>
    <message>
        <source>the numbers are too large to be added to each other</source>
        <translation>die Zahlen sind zu groß, um addiert zu werden</translation>
    </message>
    <message>
        <source>from there to {place} the correction changes by {change}, so that positions would change their order; check the unit of the values</source>
        <translation>von dort bis {place} ändert sich die Korrektur um {change}, sodass Positionen ihre Reihenfolge ändern würden; die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>the correction of {axis} changes by {change} for each unit of the way, too much for several axes that are corrected together; check the unit of the values</source>
        <translation>die Korrektur von {axis} ändert sich um {change} je Einheit des Wegs, zu viel für mehrere Achsen, die gemeinsam korrigiert werden; die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>the corrections are so steep that {count} steps do not find the place that belongs to it; check the unit of the values</source>
        <translation>die Korrekturen sind so steil, dass {count} Schritte die zugehörige Stelle nicht finden; die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>the second table has no column for {column}</source>
        <translation>die zweite Tabelle hat keine Spalte für {column}</translation>
    </message>
    <message>
        <source>a table of {count} source axes cannot be compared with one of {other}</source>
        <translation>eine Tabelle mit {count} Quellachsen lässt sich nicht mit einer mit {other} vergleichen</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more than {count} points along {axis}; with {most} it is {found}; allow more points or a larger deviation</source>
        <translation>eine Abweichung von {deviation} braucht entlang {axis} mehr als {count} Punkte; mit {most} ist sie {found}; mehr Punkte oder eine größere Abweichung zulassen</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; with {sizes} points it is {found}; allow more points or a larger deviation</source>
        <translation>eine Abweichung von {deviation} braucht mehr Punkte als erlaubt; mit {sizes} Punkten ist sie {found}; mehr Punkte oder eine größere Abweichung zulassen</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; it takes at least {sizes} points; allow more points or a larger deviation</source>
        <translation>eine Abweichung von {deviation} braucht mehr Punkte als erlaubt; nötig sind mindestens {sizes} Punkte; mehr Punkte oder eine größere Abweichung zulassen</translation>
    </message>
    <message>
        <source>the wanted deviation must be a number of 0 or more</source>
        <translation>die gewünschte Abweichung muss eine Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>limits for {count} axes are given, the table has {axes}</source>
        <translation>Grenzen sind für {count} Achsen angegeben, die Tabelle hat {axes}</translation>
    </message>
    <message>
        <source>a grid has at least two points along each axis; allow as many</source>
        <translation>ein Gitter hat entlang jeder Achse mindestens zwei Punkte; so viele zulassen</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap)</source>
        <translation>eine volle Umdrehung von {axis} beginnt mit {begin} und endet mit {end}; beide gleich machen oder die Achse als lineare behandeln (--no-wrap)</translation>
    </message>
    <message>
        <source>the values for {column} are too large to be interpolated</source>
        <translation>die Werte für {column} sind zu groß, um interpoliert zu werden</translation>
    </message>
    <message>
        <source>grids for {count} axes are given, the table has {axes}</source>
        <translation>Gitter sind für {count} Achsen angegeben, die Tabelle hat {axes}</translation>
    </message>
    <message>
        <source>the points along {axis} would be so close that positions cannot tell them apart; take fewer</source>
        <translation>die Punkte entlang {axis} lägen so nahe beieinander, dass Positionen sie nicht unterscheiden können; weniger nehmen</translation>
    </message>
    <message>
        <source>for {axis} both a number of points and a distance are given</source>
        <translation>für {axis} sind sowohl eine Anzahl Punkte als auch ein Abstand angegeben</translation>
    </message>
    <message>
        <source>the grid along {axis} must end above its start, not go from {from} to {to}</source>
        <translation>das Gitter entlang {axis} muss über seinem Anfang enden, nicht von {from} bis {to} gehen</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than {most}</source>
        <translation>{count} Punkte entlang {axis} sind mehr als {most}</translation>
    </message>
    <message>
        <source>for a part of {axis} a number of points or a distance is needed</source>
        <translation>für einen Teil von {axis} ist eine Anzahl Punkte oder ein Abstand nötig</translation>
    </message>
    <message>
        <source>the grid along {axis} must be one full turn, from {from} to {to}</source>
        <translation>das Gitter entlang {axis} muss eine volle Umdrehung sein, von {from} bis {to}</translation>
    </message>
    <message>
        <source>the grid along {axis} begins at {from}, before the data at {data}; stay within the data, or let the end values be held</source>
        <translation>das Gitter entlang {axis} beginnt bei {from}, vor den Daten bei {data}; innerhalb der Daten bleiben oder die Endwerte halten lassen</translation>
    </message>
    <message>
        <source>the grid along {axis} ends at {to}, behind the data at {data}; stay within the data, or let the end values be held</source>
        <translation>das Gitter entlang {axis} endet bei {to}, hinter den Daten bei {data}; innerhalb der Daten bleiben oder die Endwerte halten lassen</translation>
    </message>
    <message>
        <source>a distance of {distance} along {axis} makes more than {count} points</source>
        <translation>ein Abstand von {distance} entlang {axis} ergibt mehr als {count} Punkte</translation>
    </message>
    <message>
        <source>the position {position} is the same as the one before when it is rounded</source>
        <translation>die Position {position} ist gerundet dieselbe wie die davor</translation>
    </message>
    <message>
        <source>the position {position} is beyond the 32 bits of its numbers</source>
        <translation>die Position {position} geht über die 32 Bit seiner Zahlen hinaus</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 32 bits of its numbers</source>
        <translation>der Wert {value} geht über die 32 Bit seiner Zahlen hinaus</translation>
    </message>
    <message>
        <source>master axis {number}</source>
        <translation>Masterachse {number}</translation>
    </message>
    <message>
        <source>ascending setpoints</source>
        <translation>steigende Sollwerte</translation>
    </message>
    <message>
        <source>{number} at the end</source>
        <translation>{number} am Ende</translation>
    </message>
    <message>
        <source>{number}, as at the beginning</source>
        <translation>{number}, wie am Anfang</translation>
    </message>
    <message>
        <source>activate it in the axis list of axis {axis}: {parameter} 1</source>
        <translation>in der Achsliste der Achse {axis} aktivieren: {parameter} 1</translation>
    </message>
    <message>
        <source>QUADRATIC or RECTANGULAR</source>
        <translation>QUADRATIC oder RECTANGULAR</translation>
    </message>
    <message>
        <source>different values at both ends</source>
        <translation>verschiedene Werte an beiden Enden</translation>
    </message>
    <message>
        <source>different values at both ends of master axis {number}</source>
        <translation>verschiedene Werte an beiden Enden der Masterachse {number}</translation>
    </message>
    <message>
        <source>the same values: a modulo axis is at the same place there</source>
        <translation>dieselben Werte: eine Moduloachse ist dort an derselben Stelle</translation>
    </message>
    <message>
        <source>the same values, since modulo is 1</source>
        <translation>dieselben Werte, denn modulo ist 1</translation>
    </message>
    <message>
        <source>the distance of {distance} along master {axis} is no whole number of {step}</source>
        <translation>der Abstand {distance} entlang Master {axis} ist kein ganzes Vielfaches von {step}</translation>
    </message>
    <message>
        <source>resample it with such a distance</source>
        <translation>sie mit einem solchen Abstand umrechnen</translation>
    </message>
    <message>
        <source>it takes one distance for both sources, and these are different</source>
        <translation>es hat einen Abstand für beide Quellen, und diese sind verschieden</translation>
    </message>
    <message>
        <source>numbers of 0.1 um or 0.0001 deg</source>
        <translation>Zahlen in 0,1 µm oder 0,0001 Grad</translation>
    </message>
    <message>
        <source>increments for one mm or degree</source>
        <translation>Inkremente je mm oder Grad</translation>
    </message>
    <message>
        <source>the setting {key}, linear or rotary; linear is assumed, so that it is mm</source>
        <translation>die Angabe {key}, linear oder rotary; angenommen wird linear, also mm</translation>
    </message>
    <message>
        <source>numbers in encoder increments</source>
        <translation>Zahlen in Geberinkrementen</translation>
    </message>
    <message>
        <source>the setting increments-per-unit, where millimetres or degrees matter</source>
        <translation>die Angabe increments-per-unit, wenn es auf Millimeter oder Grad ankommt</translation>
    </message>
    <message>
        <source>the setting increments-per-unit is not above 0</source>
        <translation>die Angabe increments-per-unit ist nicht über 0</translation>
    </message>
    <message>
        <source>numbers in mm or degrees become increments only with the setting increments-per-unit</source>
        <translation>aus Zahlen in mm oder Grad werden Inkremente nur mit der Angabe increments-per-unit</translation>
    </message>
    <message>
        <source>an index from 0 such as [3], at most two of them</source>
        <translation>ein Index ab 0 wie [3], höchstens zwei davon</translation>
    </message>
    <message>
        <source>nothing after End</source>
        <translation>nichts nach End</translation>
    </message>
    <message>
        <source>a value behind the name and a blank</source>
        <translation>ein Wert hinter dem Namen und einem Leerzeichen</translation>
    </message>
    <message>
        <source>the entry {name}, which is missing</source>
        <translation>der Eintrag {name}, der fehlt</translation>
    </message>
    <message>
        <source>a whole number, {range}</source>
        <translation>eine ganze Zahl, {range}</translation>
    </message>
    <message>
        <source>no entry {name}</source>
        <translation>kein Eintrag {name}</translation>
    </message>
    <message>
        <source>0 or 1; 0 is assumed</source>
        <translation>0 oder 1; angenommen wird 0</translation>
    </message>
    <message>
        <source>0 or 1; 1 is assumed</source>
        <translation>0 oder 1; angenommen wird 1</translation>
    </message>
    <message>
        <source>the logical number of the axis, from 1</source>
        <translation>die logische Nummer der Achse, ab 1</translation>
    </message>
    <message>
        <source>at most {number}, which is {name}</source>
        <translation>höchstens {number} nach {name}</translation>
    </message>
    <message>
        <source>at most {number}, which is the standard value of {name}</source>
        <translation>höchstens {number}, der Standardwert von {name}</translation>
    </message>
    <message>
        <source>indices within the size that the list says</source>
        <translation>Indizes innerhalb der Größe, die die Liste nennt</translation>
    </message>
    <message>
        <source>{number} of them; there are {number2}</source>
        <translation>{number} davon; vorhanden sind {number2}</translation>
    </message>
    <message>
        <source>0, or a distance above 0</source>
        <translation>0 oder ein Abstand über 0</translation>
    </message>
    <message>
        <source>{entry} and setpoints of each point</source>
        <translation>{entry} und Sollwerte für jeden Punkt</translation>
    </message>
    <message>
        <source>an interval of 0 with setpoints, or an interval without</source>
        <translation>ein Intervall 0 mit Sollwerten oder ein Intervall ohne</translation>
    </message>
    <message>
        <source>values neg without bilateral 1</source>
        <translation>Werte neg ohne bilateral 1</translation>
    </message>
    <message>
        <source>values pos only; neg is left out</source>
        <translation>nur Werte pos; neg wird ausgelassen</translation>
    </message>
    <message>
        <source>the index of a table, 0 to {number}</source>
        <translation>der Index einer Tabelle, 0 bis {number}</translation>
    </message>
    <message>
        <source>each variable once</source>
        <translation>jede Variable einmal</translation>
    </message>
    <message>
        <source>each variable once; the first is in line {line}</source>
        <translation>jede Variable einmal; die erste steht in Zeile {line}</translation>
    </message>
    <message>
        <source>tables {name} besides {other}</source>
        <translation>Tabellen {name} neben {other}</translation>
    </message>
    <message>
        <source>one index: [table]</source>
        <translation>ein Index: [Tabelle]</translation>
    </message>
    <message>
        <source>two indices: [table,point]</source>
        <translation>zwei Indizes: [Tabelle,Punkt]</translation>
    </message>
    <message>
        <source>two indices: [encoder,axis]</source>
        <translation>zwei Indizes: [Messsystem,Achse]</translation>
    </message>
    <message>
        <source>three indices: [encoder,point,axis]</source>
        <translation>drei Indizes: [Messsystem,Punkt,Achse]</translation>
    </message>
    <message>
        <source>0, 1 or -1</source>
        <translation>0, 1 oder -1</translation>
    </message>
    <message>
        <source>{variable} of {curve}, which is missing</source>
        <translation>{variable} ({curve}), die fehlt</translation>
    </message>
    <message>
        <source>a product with another table</source>
        <translation>ein Produkt mit einer anderen Tabelle</translation>
    </message>
    <message>
        <source>a table by itself; the product is left out</source>
        <translation>eine Tabelle für sich; das Produkt wird ausgelassen</translation>
    </message>
    <message>
        <source>variables {name}, of which there are none</source>
        <translation>Variablen {name}, von denen keine da ist</translation>
    </message>
    <message>
        <source>there is no table {number}</source>
        <translation>es gibt keine Tabelle {number}</translation>
    </message>
    <message>
        <source>choose fewer tables, or another first-table</source>
        <translation>weniger Tabellen oder ein anderes first-table wählen</translation>
    </message>
    <message>
        <source>the measuring system, 0 or 1</source>
        <translation>das Messsystem, 0 oder 1</translation>
    </message>
    <message>
        <source>measuring system {number} of axis {axis}</source>
        <translation>Messsystem {number} der Achse {axis}</translation>
    </message>
    <message>
        <source>0 or 1, and the name of an axis, at most {number} of them</source>
        <translation>0 oder 1 und der Name einer Achse, höchstens {number} davon</translation>
    </message>
    <message>
        <source>axis {axis}, encoder {number}</source>
        <translation>Achse {axis}, Messsystem {number}</translation>
    </message>
    <message>
        <source>its positions and values are not both lengths or both angles</source>
        <translation>ihre Positionen und Werte sind nicht beide Längen oder beide Winkel</translation>
    </message>
    <message>
        <source>axis {axis} needs $MA_MM_ENC_COMP_MAX_POINTS (MD38000) of at least {count}; load the file with $MA_ENC_COMP_ENABLE (MD32700) 0, then set it to 1</source>
        <translation>Achse {axis} braucht $MA_MM_ENC_COMP_MAX_POINTS (MD38000) von mindestens {count}; die Datei mit $MA_ENC_COMP_ENABLE (MD32700) 0 laden, danach auf 1 setzen</translation>
    </message>
    <message>
        <source>an index in [ ] behind the name</source>
        <translation>ein Index in [ ] hinter dem Namen</translation>
    </message>
    <message>
        <source>an index that ends in ]</source>
        <translation>ein Index, der mit ] endet</translation>
    </message>
    <message>
        <source>= and a value behind the index</source>
        <translation>= und ein Wert hinter dem Index</translation>
    </message>
    <message>
        <source>a value behind =</source>
        <translation>ein Wert hinter =</translation>
    </message>
    <message>
        <source>nothing behind the end of the program, M17</source>
        <translation>nichts hinter dem Ende des Programms, M17</translation>
    </message>
    <message>
        <source>an assignment such as $NAME[0,1]=0.5, CHANDATA(1) or M17</source>
        <translation>eine Zuweisung wie $NAME[0,1]=0.5, CHANDATA(1) oder M17</translation>
    </message>
    <message>
        <source>{variable} of {curve} a second time</source>
        <translation>{variable} ({curve}) ein zweites Mal</translation>
    </message>
    <message>
        <source>the number of a point, from 0</source>
        <translation>die Nummer eines Punkts, ab 0</translation>
    </message>
    <message>
        <source>a compensation value</source>
        <translation>ein Kompensationswert</translation>
    </message>
    <message>
        <source>MIN {min}, MAX {max} and STEP {step} of {curve}</source>
        <translation>MIN {min}, MAX {max} und STEP {step} ({curve})</translation>
    </message>
    <message>
        <source>a STEP above 0 and a MAX above MIN</source>
        <translation>ein STEP über 0 und ein MAX über MIN</translation>
    </message>
    <message>
        <source>a whole number of steps from MIN to MAX</source>
        <translation>eine ganze Zahl von Schritten von MIN bis MAX</translation>
    </message>
    <message>
        <source>point {number} of {curve}</source>
        <translation>Punkt {number} ({curve})</translation>
    </message>
    <message>
        <source>point {number} of {curve} a second time</source>
        <translation>Punkt {number} ({curve}) ein zweites Mal</translation>
    </message>
    <message>
        <source>points up to {number}, which MIN, MAX and STEP give</source>
        <translation>Punkte bis {number}, wie MIN, MAX und STEP ergeben</translation>
    </message>
    <message>
        <source>no point {number} of {curve}</source>
        <translation>kein Punkt {number} ({curve})</translation>
    </message>
    <message>
        <source>{number} points, which MIN, MAX and STEP give; there are {number2}</source>
        <translation>{number} Punkte, wie MIN, MAX und STEP ergeben; vorhanden sind {number2}</translation>
    </message>
    <message>
        <source>{number} at MAX of {curve}</source>
        <translation>{number} bei MAX ({curve})</translation>
    </message>
    <message>
        <source>{number}, as at MIN, which follows it</source>
        <translation>{number}, wie bei MIN, das darauf folgt</translation>
    </message>
    <message>
        <source>&quot;{axis}&quot; is no axis name for the format {format}, such as X1; give the setting {key}</source>
        <translation>&quot;{axis}&quot; ist kein Achsname für das Format {format} wie X1; die Angabe {key} ergänzen</translation>
    </message>
    <message>
        <source>three numbers: nominal forward reverse; the controller stops reading here without a message</source>
        <translation>drei Zahlen: nominal forward reverse; die Steuerung hört hier ohne Meldung auf zu lesen</translation>
    </message>
    <message>
        <source>{text} after three numbers</source>
        <translation>{text} nach drei Zahlen</translation>
    </message>
    <message>
        <source>nothing; it is left out, as the controller does</source>
        <translation>nichts; es wird ausgelassen, wie es die Steuerung tut</translation>
    </message>
    <message>
        <source>at most 256; the controller leaves out the others</source>
        <translation>höchstens 256; die Steuerung lässt die anderen aus</translation>
    </message>
    <message>
        <source>a measured position that does not increase</source>
        <translation>eine gemessene Position, die nicht zunimmt</translation>
    </message>
    <message>
        <source>increasing ones; if these are trims, the setting type=1</source>
        <translation>zunehmende; falls dies Korrekturen sind, die Angabe type=1</translation>
    </message>
    <message>
        <source>measured positions (COMP_FILE_TYPE 0)</source>
        <translation>gemessene Positionen (COMP_FILE_TYPE 0)</translation>
    </message>
    <message>
        <source>the setting type=0, or type=1 if these are trims</source>
        <translation>die Angabe type=0, oder type=1, falls dies Korrekturen sind</translation>
    </message>
    <message>
        <source>increasing ones; perhaps these are trims (type=1)</source>
        <translation>zunehmende; vielleicht sind dies Korrekturen (type=1)</translation>
    </message>
    <message>
        <source>trims that change by {change}</source>
        <translation>Korrekturen, die sich um {change} ändern</translation>
    </message>
    <message>
        <source>less than the positions do; perhaps these are measured positions (type=0)</source>
        <translation>weniger als die Positionen; vielleicht sind dies gemessene Positionen (type=0)</translation>
    </message>
    <message>
        <source>a measured position at {position} is beyond what a number can be</source>
        <translation>eine gemessene Position bei {position} ist größer, als eine Zahl sein kann</translation>
    </message>
    <message>
        <source>check the unit of positions and values</source>
        <translation>die Einheit der Positionen und Werte prüfen</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = {file} and COMP_FILE_TYPE = {type}</source>
        <translation>im Abschnitt [JOINT_n] der INI-Datei: COMP_FILE = {file} und COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = the file and COMP_FILE_TYPE = {type}</source>
        <translation>im Abschnitt [JOINT_n] der INI-Datei: COMP_FILE = die Datei und COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>BACKLASH of the joint is not used any more</source>
        <translation>BACKLASH des Gelenks (joint) wird nicht mehr verwendet</translation>
    </message>
    <message>
        <source>a second section for the profile {name}</source>
        <translation>ein zweiter Abschnitt für das Profil {name}</translation>
    </message>
    <message>
        <source>each profile once</source>
        <translation>jedes Profil einmal</translation>
    </message>
    <message>
        <source>an entry such as min_x = 10</source>
        <translation>ein Eintrag wie min_x = 10</translation>
    </message>
    <message>
        <source>each entry once in a section</source>
        <translation>jeder Eintrag einmal in einem Abschnitt</translation>
    </message>
    <message>
        <source>an entry {key} in this section</source>
        <translation>ein Eintrag {key} in diesem Abschnitt</translation>
    </message>
    <message>
        <source>version {version}</source>
        <translation>Version {version}</translation>
    </message>
    <message>
        <source>1; the firmware does not use other versions</source>
        <translation>1; die Firmware verwendet keine anderen Versionen</translation>
    </message>
    <message>
        <source>a height in mm</source>
        <translation>eine Höhe in mm</translation>
    </message>
    <message>
        <source>a position in mm</source>
        <translation>eine Position in mm</translation>
    </message>
    <message>
        <source>an offset in mm</source>
        <translation>ein Offset in mm</translation>
    </message>
    <message>
        <source>a maximum above the minimum</source>
        <translation>ein Maximum über dem Minimum</translation>
    </message>
    <message>
        <source>a section [bed_mesh NAME] with the points of a mesh</source>
        <translation>ein Abschnitt [bed_mesh NAME] mit den Punkten eines Netzes</translation>
    </message>
    <message>
        <source>{axis} from {number} to {number2} by {number3} in {number4} points</source>
        <translation>{axis} von {number} bis {number2} mit Schrittweite {number3} in {number4} Punkten</translation>
    </message>
    <message>
        <source>at least 2 along each axis</source>
        <translation>mindestens 2 entlang jeder Achse</translation>
    </message>
    <message>
        <source>as many points as lie between minimum and maximum</source>
        <translation>so viele Punkte, wie zwischen Minimum und Maximum liegen</translation>
    </message>
    <message>
        <source>the axes &quot;{first}&quot; and &quot;{second}&quot;</source>
        <translation>die Achsen &quot;{first}&quot; und &quot;{second}&quot;</translation>
    </message>
    <message>
        <source>two different letters</source>
        <translation>zwei verschiedene Buchstaben</translation>
    </message>
    <message>
        <source>a point that was not probed at {position}, {other}</source>
        <translation>ein nicht gemessener Punkt bei {position}, {other}</translation>
    </message>
    <message>
        <source>a further line after {number}</source>
        <translation>eine weitere Zeile nach {number}</translation>
    </message>
    <message>
        <source>{number} lines of heights</source>
        <translation>{number} Zeilen mit Höhen</translation>
    </message>
    <message>
        <source>the line {line}</source>
        <translation>die Zeile {line}</translation>
    </message>
    <message>
        <source>the line {line}, or {other}</source>
        <translation>die Zeile {line} oder {other}</translation>
    </message>
    <message>
        <source>the number of one axis, from 1, behind :START</source>
        <translation>die Nummer einer Achse, ab 1, hinter :START</translation>
    </message>
    <message>
        <source>SAMPLEDIST= and the distance of the corrections, which is not 0</source>
        <translation>SAMPLEDIST= und der Abstand der Korrekturen, der nicht 0 ist</translation>
    </message>
    <message>
        <source>choose a table of an axis for itself</source>
        <translation>eine Tabelle wählen, die eine Achse für sich korrigiert</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}, and the controller adds their corrections</source>
        <translation>für die Achse {axis} gibt es zwei Tabellen, und die Steuerung addiert ihre Korrekturen</translation>
    </message>
    <message>
        <source>the number of an axis, from 1</source>
        <translation>die Nummer einer Achse, ab 1</translation>
    </message>
    <message>
        <source>7 numbers behind :START2D: row axis, column axis, two output axes, distance along rows, distance along columns, number of columns</source>
        <translation>7 Zahlen hinter :START2D: Zeilenachse, Spaltenachse, zwei Ausgangsachsen, Abstand entlang der Zeilen, Abstand entlang der Spalten, Anzahl der Spalten</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>ein Abstand</translation>
    </message>
    <message>
        <source>the number of columns</source>
        <translation>die Anzahl der Spalten</translation>
    </message>
    <message>
        <source>a distance of 0</source>
        <translation>ein Abstand von 0</translation>
    </message>
    <message>
        <source>a distance that is not 0</source>
        <translation>ein Abstand, der nicht 0 ist</translation>
    </message>
    <message>
        <source>axis {number} for rows and columns</source>
        <translation>Achse {number} für Zeilen und Spalten</translation>
    </message>
    <message>
        <source>two axes</source>
        <translation>zwei Achsen</translation>
    </message>
    <message>
        <source>{number} points of {number2} corrections each in a row</source>
        <translation>{number} Punkte mit je {number2} Korrekturen in einer Zeile</translation>
    </message>
    <message>
        <source>KEY=VALUE</source>
        <translation>SCHLÜSSEL=WERT</translation>
    </message>
    <message>
        <source>:END of the table that begins in line {line}</source>
        <translation>:END der Tabelle, die in Zeile {line} beginnt</translation>
    </message>
    <message>
        <source>{directive} before :END</source>
        <translation>{directive} vor :END</translation>
    </message>
    <message>
        <source>a table that begins with {directive}</source>
        <translation>eine Tabelle, die mit {directive} beginnt</translation>
    </message>
    <message>
        <source>a table that begins with {directive} and ends with :END</source>
        <translation>eine Tabelle, die mit {directive} beginnt und mit :END endet</translation>
    </message>
    <message>
        <source>{directive} or :END; tables of one and of two dimensions are in separate files</source>
        <translation>{directive} oder :END; Tabellen mit einer und mit zwei Dimensionen stehen in getrennten Dateien</translation>
    </message>
    <message>
        <source>each option once</source>
        <translation>jede Option einmal</translation>
    </message>
    <message>
        <source>{key}= and a number</source>
        <translation>{key}= und eine Zahl</translation>
    </message>
    <message>
        <source>positions in the coordinates of the axis after homing; it is left out</source>
        <translation>Positionen in den Koordinaten der Achse nach der Referenzfahrt; die Option wird ausgelassen</translation>
    </message>
    <message>
        <source>a table without {key}</source>
        <translation>eine Tabelle ohne {key}</translation>
    </message>
    <message>
        <source>{key}=METRIC, ENGLISH, PRIMARY, SECONDARY or COUNTS, perhaps divided by a number as in METRIC/1000</source>
        <translation>{key}=METRIC, ENGLISH, PRIMARY, SECONDARY oder COUNTS, eventuell geteilt durch eine Zahl wie in METRIC/1000</translation>
    </message>
    <message>
        <source>a correction that is too large for its unit</source>
        <translation>eine Korrektur, die für ihre Einheit zu groß ist</translation>
    </message>
    <message>
        <source>another CORUNIT</source>
        <translation>ein anderes CORUNIT</translation>
    </message>
    <message>
        <source>two numbers such as 0.25,0.001: position and offset</source>
        <translation>zwei Zahlen wie 0.25,0.001: Position und Offset</translation>
    </message>
    <message>
        <source>a position such as 0.25</source>
        <translation>eine Position wie 0.25</translation>
    </message>
    <message>
        <source>an offset such as 0.001</source>
        <translation>ein Offset wie 0.001</translation>
    </message>
    <message>
        <source>lines of {expected}</source>
        <translation>Zeilen mit {expected}</translation>
    </message>
    <message>
        <source>&quot;{line}&quot;, which is taken to be a header</source>
        <translation>&quot;{line}&quot;, als Kopfzeile aufgefasst</translation>
    </message>
    <message>
        <source>{expected}, if it is a point</source>
        <translation>{expected}, falls es ein Punkt ist</translation>
    </message>
    <message>
        <source>position + offset {number} after {number2}</source>
        <translation>Position + Offset {number} nach {number2}</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>strictly decreasing positions</source>
        <translation>streng fallende Positionen</translation>
    </message>
    <message>
        <source>strictly increasing positions</source>
        <translation>streng steigende Positionen</translation>
    </message>
    <message>
        <source>strictly decreasing values, as the positions are</source>
        <translation>streng fallende Werte, wie die Positionen</translation>
    </message>
    <message>
        <source>strictly increasing values, as the positions are</source>
        <translation>streng steigende Werte, wie die Positionen</translation>
    </message>
    <message>
        <source>positions from {first} to {last}</source>
        <translation>Positionen von {first} bis {last}</translation>
    </message>
    <message>
        <source>a span of exactly {range}, the wrap range</source>
        <translation>eine Spanne von genau {range}, dem Bereich einer Umdrehung</translation>
    </message>
    <message>
        <source>the offsets {first} and {last} at the ends</source>
        <translation>die Offsets {first} und {last} an den Enden</translation>
    </message>
    <message>
        <source>the same offset at both ends, which are one place</source>
        <translation>derselbe Offset an beiden Enden, die eine Stelle sind</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, expected more than 0</source>
        <translation>die Angabe wrap-range ist {value}, erwartet wird mehr als 0</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, and the table repeats after {period}</source>
        <translation>die Angabe wrap-range ist {value}, und die Tabelle wiederholt sich nach {period}</translation>
    </message>
    <message>
        <source>at {position} position + offset {sum} after {before} does not increase (error 4900 of the controller)</source>
        <translation>bei {position} nimmt Position + Offset nicht zu: {sum} nach {before} (Fehler 4900 der Steuerung)</translation>
    </message>
    <message>
        <source>check the unit of the values, or smooth them</source>
        <translation>die Einheit der Werte prüfen oder die Werte glätten</translation>
    </message>
    <message>
        <source>of a rotary axis it wants {expected}, and this table has {found} (error 4902 of the controller)</source>
        <translation>bei einer Rundachse verlangt es {expected}, und diese Tabelle hat {found} (Fehler 4902 der Steuerung)</translation>
    </message>
    <message>
        <source>add the point that closes the revolution</source>
        <translation>den Punkt ergänzen, der die Umdrehung schließt</translation>
    </message>
    <message>
        <source>the controller looks for the file as {name}PosComp.CSV, unless axis.xml names another one</source>
        <translation>die Steuerung sucht die Datei unter {name}PosComp.CSV, wenn axis.xml keine andere nennt</translation>
    </message>
    <message>
        <source>the controller looks for the file as the name of the axis and PosComp.CSV, unless axis.xml names another one</source>
        <translation>die Steuerung sucht die Datei unter dem Namen der Achse und PosComp.CSV, wenn axis.xml keine andere nennt</translation>
    </message>
    <message>
        <source>motor {number}</source>
        <translation>Motor {number}</translation>
    </message>
    <message>
        <source>a number of entries</source>
        <translation>eine Anzahl Einträge</translation>
    </message>
    <message>
        <source>the number of a motor, #1 to #32, perhaps with a D</source>
        <translation>die Nummer eines Motors, #1 bis #32, eventuell mit einem D</translation>
    </message>
    <message>
        <source>DEFINE COMP entries,#source,#target,span</source>
        <translation>DEFINE COMP Einträge,#Quelle,#Ziel,Spanne</translation>
    </message>
    <message>
        <source>DEFINE COMP rows.columns,#row,#column,#target,span,span</source>
        <translation>DEFINE COMP Zeilen.Spalten,#Zeile,#Spalte,#Ziel,Spanne,Spanne</translation>
    </message>
    <message>
        <source>a span in counts</source>
        <translation>eine Spanne in Inkrementen</translation>
    </message>
    <message>
        <source>a span of {span}</source>
        <translation>eine Spanne von {span}</translation>
    </message>
    <message>
        <source>a span of {span} counts</source>
        <translation>eine Spanne von {span} Inkrementen</translation>
    </message>
    <message>
        <source>at least 1 count</source>
        <translation>mindestens 1 Inkrement</translation>
    </message>
    <message>
        <source>motors that are not named</source>
        <translation>Motoren, die nicht genannt sind</translation>
    </message>
    <message>
        <source>the motor that is addressed when the file is loaded; name it with #</source>
        <translation>der Motor, der beim Laden der Datei angesprochen ist; ihn mit # nennen</translation>
    </message>
    <message>
        <source>a table of one dimension</source>
        <translation>eine Tabelle mit einer Dimension</translation>
    </message>
    <message>
        <source>a table of two dimensions</source>
        <translation>eine Tabelle mit zwei Dimensionen</translation>
    </message>
    <message>
        <source>further entries: {entries}</source>
        <translation>weitere Einträge: {entries}</translation>
    </message>
    <message>
        <source>DEFINE COMP in front of them</source>
        <translation>DEFINE COMP davor</translation>
    </message>
    <message>
        <source>a whole number of 1/16 count</source>
        <translation>eine ganze Zahl in 1/16 Inkrement</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of one dimension</source>
        <translation>DEFINE COMP für eine Tabelle mit einer Dimension</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of two dimensions</source>
        <translation>DEFINE COMP für eine Tabelle mit zwei Dimensionen</translation>
    </message>
    <message>
        <source>a table in counts</source>
        <translation>eine Tabelle in Inkrementen</translation>
    </message>
    <message>
        <source>different entries at 0 and at the span of motor {motor}</source>
        <translation>verschiedene Einträge bei 0 und am Ende der Spanne von Motor {motor}</translation>
    </message>
    <message>
        <source>the same: the table rolls over there</source>
        <translation>dieselben: die Tabelle beginnt dort von vorn</translation>
    </message>
    <message>
        <source>entries that are too large in these units</source>
        <translation>Einträge, die in diesen Einheiten zu groß sind</translation>
    </message>
    <message>
        <source>another counts-per-unit</source>
        <translation>ein anderes counts-per-unit</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected a number above 0</source>
        <translation>die Angabe {key} des Formats {format} ist {value}, erwartet wird eine Zahl über 0</translation>
    </message>
    <message>
        <source>position 0, where its tables begin, is no point of source {number}</source>
        <translation>die Position 0, wo seine Tabellen beginnen, ist kein Punkt der Quelle {number}</translation>
    </message>
    <message>
        <source>resample it with a point at 0</source>
        <translation>sie mit einem Punkt bei 0 umrechnen</translation>
    </message>
    <message>
        <source>its tables begin at position 0, which source {number} does not reach</source>
        <translation>seine Tabellen beginnen bei Position 0, die Quelle {number} nicht erreicht</translation>
    </message>
    <message>
        <source>add points to the table, as far as position 0</source>
        <translation>der Tabelle Punkte hinzufügen, bis zur Position 0</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the positions</source>
        <translation>counts-per-unit und die Einheit der Positionen prüfen</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 24 bits of an entry</source>
        <translation>der Wert {value} geht über die 24 Bit eines Eintrags hinaus</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the values</source>
        <translation>counts-per-unit und die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>its value at position 0 is {value}, and the controller takes it to be 0 there</source>
        <translation>ihr Wert bei Position 0 ist {value}, und die Steuerung nimmt dort 0 an</translation>
    </message>
    <message>
        <source>there is no motor {number}</source>
        <translation>es gibt keinen Motor {number}</translation>
    </message>
    <message>
        <source>choose one from 1 to 32</source>
        <translation>einen von 1 bis 32 wählen</translation>
    </message>
    <message>
        <source>switch the table on with I51=1; outside of its span it rolls over</source>
        <translation>die Tabelle mit I51=1 einschalten; außerhalb ihrer Spanne beginnt sie von vorn</translation>
    </message>
    <message>
        <source>a line &quot;# {key} = NUMBER&quot; before the counts</source>
        <translation>eine Zeile &quot;# {key} = ZAHL&quot; vor den Inkrementen</translation>
    </message>
    <message>
        <source>{number} to {number2} by {number3}</source>
        <translation>{number} bis {number2} mit Schrittweite {number3}</translation>
    </message>
    <message>
        <source>a maximum above the minimum, and a delta above 0</source>
        <translation>ein Maximum über dem Minimum und eine Schrittweite über 0</translation>
    </message>
    <message>
        <source>a range that is an integer multiple of the delta</source>
        <translation>ein Bereich, der ein ganzes Vielfaches der Schrittweite ist</translation>
    </message>
    <message>
        <source>the unit {unit}</source>
        <translation>die Einheit {unit}</translation>
    </message>
    <message>
        <source>values in counts</source>
        <translation>Werte in Inkrementen</translation>
    </message>
    <message>
        <source>a line &quot;# output.counts-per-unit = NUMBER&quot;, or the setting counts-per-unit</source>
        <translation>eine Zeile &quot;# output.counts-per-unit = ZAHL&quot; oder die Angabe counts-per-unit</translation>
    </message>
    <message>
        <source>a number of counts</source>
        <translation>eine Anzahl Inkremente</translation>
    </message>
    <message>
        <source>{number} counts per unit</source>
        <translation>{number} Inkremente je Einheit</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>eine andere Zahl als 0</translation>
    </message>
    <message>
        <source>{number}, one for each position of the first axis</source>
        <translation>{number}, je Position der ersten Achse einer</translation>
    </message>
    <message>
        <source>{number}, one for each position of the second axis</source>
        <translation>{number}, je Position der zweiten Achse eine</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>eine Zeile</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected a C++ name: letters, digits and _</source>
        <translation>die Angabe name ist &quot;{name}&quot;, erwartet wird ein C++-Name: Buchstaben, Ziffern und _</translation>
    </message>
    <message>
        <source>the value {value} is {count} counts, and at most 2147483647 can be held</source>
        <translation>der Wert {value} ist {count} Inkremente, und höchstens 2147483647 sind möglich</translation>
    </message>
    <message>
        <source>the setting counts-per-unit is 0, expected a number of counts</source>
        <translation>die Angabe counts-per-unit ist 0, erwartet wird eine Anzahl Inkremente</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 {unit}</source>
        <translation>counts-per-unit wird verstanden als {count} Inkremente für 1 {unit}</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 unit of the values</source>
        <translation>counts-per-unit wird verstanden als {count} Inkremente für 1 Einheit der Werte</translation>
    </message>
    <message>
        <source>an input axis is the output axis: its command position must be the input, the actual position is not possible</source>
        <translation>eine Eingangsachse ist die Ausgangsachse: ihre Sollposition muss der Eingang sein, die Istposition ist nicht möglich</translation>
    </message>
    <message>
        <source>the inputs are other axes: their command or their actual positions can be the inputs</source>
        <translation>die Eingänge sind andere Achsen: ihre Soll- oder ihre Istpositionen können die Eingänge sein</translation>
    </message>
    <message>
        <source>the number of source axes, 1 to 3</source>
        <translation>die Anzahl der Quellachsen, 1 bis 3</translation>
    </message>
    <message>
        <source>{number}, one for each source axis</source>
        <translation>{number}, je Quellachse eine</translation>
    </message>
    <message>
        <source>the number of points of a source</source>
        <translation>die Anzahl der Punkte einer Quelle</translation>
    </message>
    <message>
        <source>at least 2, and at most {number} rows in all</source>
        <translation>mindestens 2, und insgesamt höchstens {number} Zeilen</translation>
    </message>
    <message>
        <source>{number}, as in the first row</source>
        <translation>{number}, wie in der ersten Zeile</translation>
    </message>
    <message>
        <source>a source position</source>
        <translation>eine Position der Quelle</translation>
    </message>
    <message>
        <source>{number} for source {number2}</source>
        <translation>{number} für Quelle {number2}</translation>
    </message>
    <message>
        <source>{number}: the first source changes fastest</source>
        <translation>{number}: die erste Quelle ändert sich am schnellsten</translation>
    </message>
    <message>
        <source>positions of source {axis} from {first} to {last}</source>
        <translation>Positionen der Quelle {axis} von {first} bis {last}</translation>
    </message>
    <message>
        <source>equal distances</source>
        <translation>gleiche Abstände</translation>
    </message>
    <message>
        <source>a header of {sizes} = {number} rows, and {number2} rows</source>
        <translation>eine Kopfzeile für {sizes} = {number} Zeilen, und {number2} Zeilen</translation>
    </message>
    <message>
        <source>as many rows as the header says</source>
        <translation>so viele Zeilen, wie die Kopfzeile sagt</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected letters, digits and _, beginning with a letter</source>
        <translation>die Angabe name ist &quot;{name}&quot;, erwartet werden Buchstaben, Ziffern und _, beginnend mit einem Buchstaben</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, and not be in use (CompActive = 0) while the lines run</source>
        <translation>die Tabelle {name} muss im Programm mit {count} Punkten definiert sein und darf nicht in Gebrauch sein (CompActive = 0), während die Zeilen laufen</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, the first source fastest, and not be in use (CompActive = 0) while the lines run</source>
        <translation>die Tabelle {name} muss im Programm mit {count} Punkten definiert sein, die erste Quelle am schnellsten, und darf nicht in Gebrauch sein (CompActive = 0), während die Zeilen laufen</translation>
    </message>
    <message>
        <source>{number} after {number2}</source>
        <translation>{number} nach {number2}</translation>
    </message>
    <message>
        <source>strictly increasing positions of {axis}</source>
        <translation>streng steigende Positionen von {axis}</translation>
    </message>
    <message>
        <source>positions of {axis}</source>
        <translation>Positionen von {axis}</translation>
    </message>
    <message>
        <source>positions of the axis</source>
        <translation>Positionen der Achse</translation>
    </message>
    <message>
        <source>numbers that a computer can tell from each other; check their size</source>
        <translation>Zahlen, die ein Computer voneinander unterscheiden kann; ihre Größe prüfen</translation>
    </message>
    <message>
        <source>values of {target}</source>
        <translation>Werte von {target}</translation>
    </message>
    <message>
        <source>values of the table</source>
        <translation>Werte der Tabelle</translation>
    </message>
    <message>
        <source>numbers that a computer can hold; check their size</source>
        <translation>Zahlen, die ein Computer darstellen kann; ihre Größe prüfen</translation>
    </message>
    <message>
        <source>axis {number}</source>
        <translation>Achse {number}</translation>
    </message>
    <message>
        <source>source {number}</source>
        <translation>Quelle {number}</translation>
    </message>
    <message>
        <source>table {number}</source>
        <translation>Tabelle {number}</translation>
    </message>
    <message>
        <source>at least 2</source>
        <translation>mindestens 2</translation>
    </message>
    <message>
        <source>{number} to {number2}</source>
        <translation>{number} bis {number2}</translation>
    </message>
    <message>
        <source>at most {number} points</source>
        <translation>höchstens {number} Punkte</translation>
    </message>
    <message>
        <source>{number} lines</source>
        <translation>{number} Zeilen</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>eine Zahl über 0</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>eine Anzahl Punkte</translation>
    </message>
    <message>
        <source>a number for {key}</source>
        <translation>eine Zahl für {key}</translation>
    </message>
    <message>
        <source>the number of {key}</source>
        <translation>die Zahl für {key}</translation>
    </message>
    <message>
        <source>a distance above 0</source>
        <translation>ein Abstand über 0</translation>
    </message>
    <message>
        <source>a correction</source>
        <translation>eine Korrektur</translation>
    </message>
    <message>
        <source>{what} a second time</source>
        <translation>{what} ein zweites Mal</translation>
    </message>
    <message>
        <source>a second {key}</source>
        <translation>{key} ein zweites Mal</translation>
    </message>
    <message>
        <source>each entry once</source>
        <translation>jeder Eintrag einmal</translation>
    </message>
    <message>
        <source>each entry once; the first is in line {line}</source>
        <translation>jeder Eintrag einmal; der erste steht in Zeile {line}</translation>
    </message>
    <message>
        <source>each point once</source>
        <translation>jeder Punkt einmal</translation>
    </message>
    <message>
        <source>{value}, as {key} says</source>
        <translation>{value}, wie {key} sagt</translation>
    </message>
    <message>
        <source>{value}, as the setting {key} says</source>
        <translation>{value}, wie die Angabe {key} sagt</translation>
    </message>
    <message>
        <source>{number}, one for each position of {axis}</source>
        <translation>{number}, je Position von {axis} eine</translation>
    </message>
    <message>
        <source>the format {format} to read it; it is left out here</source>
        <translation>das Format {format}, um sie zu lesen; hier wird sie ausgelassen</translation>
    </message>
    <message>
        <source>the format {format} to read them; they are left out here</source>
        <translation>das Format {format}, um sie zu lesen; hier werden sie ausgelassen</translation>
    </message>
    <message>
        <source>numbers in {from} cannot be given in {to}</source>
        <translation>Zahlen in {from} lassen sich nicht in {to} angeben</translation>
    </message>
    <message>
        <source>a unit that is not said</source>
        <translation>einer nicht genannten Einheit</translation>
    </message>
    <message>
        <source>positions without a unit</source>
        <translation>Positionen ohne Einheit</translation>
    </message>
    <message>
        <source>values without a unit</source>
        <translation>Werte ohne Einheit</translation>
    </message>
    <message>
        <source>numbers without a unit</source>
        <translation>Zahlen ohne Einheit</translation>
    </message>
    <message>
        <source>the setting {key}, where a unit matters</source>
        <translation>die Angabe {key}, wenn es auf die Einheit ankommt</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>not all units are said: the values are taken to be in the unit of the positions</source>
        <translation>nicht alle Einheiten sind genannt: für die Werte wird die Einheit der Positionen angenommen</translation>
    </message>
    <message>
        <source>the values were in {before} and are now in {unit}, the unit of the positions</source>
        <translation>die Werte waren in {before} und sind jetzt in {unit}, der Einheit der Positionen</translation>
    </message>
    <message>
        <source>positions in {unit} and values in {other}</source>
        <translation>Positionen in {unit} und Werte in {other}</translation>
    </message>
    <message>
        <source>one unit, since the controller adds the values to the positions</source>
        <translation>eine Einheit, denn die Steuerung addiert die Werte zu den Positionen</translation>
    </message>
    <message>
        <source>{units}: the format {format} has one unit for both</source>
        <translation>{units}: das Format {format} hat eine Einheit für beides</translation>
    </message>
    <message>
        <source>choose a format for cross compensation</source>
        <translation>ein Format für Kreuzkompensation wählen</translation>
    </message>
    <message>
        <source>check the unit of the table</source>
        <translation>die Einheit der Tabelle prüfen</translation>
    </message>
    <message>
        <source>check the units of the table</source>
        <translation>die Einheiten der Tabelle prüfen</translation>
    </message>
    <message>
        <source>the {what} are in {from}, which cannot be given in {to}; correct the units</source>
        <translation>die Einheit {from} lässt sich nicht in {to} umrechnen ({what}); die Einheiten berichtigen</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for writing; it has: {known}</source>
        <translation>das Format {format} hat zum Schreiben keine Angabe {key}; es hat: {known}</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for reading; it has: {known}</source>
        <translation>das Format {format} hat zum Lesen keine Angabe {key}; es hat: {known}</translation>
    </message>
    <message>
        <source>the format {format} can be read, not written</source>
        <translation>das Format {format} kann gelesen, aber nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1; the setting {key} is {value}</source>
        <translation>das Format {format} benennt seine Achsen mit Nummern ab 1; die Angabe {key} ist {value}</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1 and there is no number in the axis name &quot;{name}&quot;; give the setting {key}</source>
        <translation>das Format {format} benennt seine Achsen mit Nummern ab 1, und im Achsnamen &quot;{name}&quot; steht keine Nummer; die Angabe {key} ergänzen</translation>
    </message>
    <message>
        <source>its positions of source {number} span {span}, and a modulo axis needs exactly one period of {period}</source>
        <translation>ihre Positionen der Quelle {number} reichen über {span}, und eine Moduloachse braucht genau eine Periode von {period}</translation>
    </message>
    <message>
        <source>resample it over one whole period</source>
        <translation>sie über eine ganze Periode umrechnen</translation>
    </message>
    <message>
        <source>the values at both ends of the modulo axis, source {number}, differ by {difference}</source>
        <translation>die Werte an beiden Enden der Moduloachse, Quelle {number}, unterscheiden sich um {difference}</translation>
    </message>
    <message>
        <source>make both ends equal: they are the same place</source>
        <translation>beide Enden gleich machen: sie sind dieselbe Stelle</translation>
    </message>
    <message>
        <source>its modulo axis is not rotary</source>
        <translation>ihre Moduloachse ist keine Rundachse</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap)</source>
        <translation>die Achse als lineare behandeln (--no-wrap)</translation>
    </message>
    <message>
        <source>it takes a column for both directions of motion, or one for each direction of one axis</source>
        <translation>es nimmt eine Spalte für beide Bewegungsrichtungen oder je eine für jede Richtung einer Achse</translation>
    </message>
    <message>
        <source>choose these columns</source>
        <translation>diese Spalten wählen</translation>
    </message>
    <message>
        <source>{count} columns are more than the {limit} of one table</source>
        <translation>{count} Spalten sind mehr als die {limit} einer Tabelle</translation>
    </message>
    <message>
        <source>choose a column, and write the others to files of their own</source>
        <translation>eine Spalte wählen und die anderen in eigene Dateien schreiben</translation>
    </message>
    <message>
        <source>{count} tables are more than the {limit} of one file</source>
        <translation>{count} Tabellen sind mehr als die {limit} einer Datei</translation>
    </message>
    <message>
        <source>choose one, and write the others to files of their own</source>
        <translation>eine wählen und die anderen in eigene Dateien schreiben</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>eine davon wählen</translation>
    </message>
    <message>
        <source>{size} bytes are more than the {limit} of a file</source>
        <translation>{size} Byte sind mehr als die {limit} einer Datei</translation>
    </message>
    <message>
        <source>write it as {format}</source>
        <translation>sie als {format} schreiben</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}</source>
        <translation>für die Achse {axis} gibt es zwei Tabellen</translation>
    </message>
    <message>
        <source>a TAM table needs the table layout of a drive profile</source>
        <translation>eine TAM-Tabelle braucht den Tabellenaufbau aus einem Antriebsprofil</translation>
    </message>
    <message>
        <source>a calibration file needs the number of its dimensions: 1, 2 or 3</source>
        <translation>eine Kalibrierdatei braucht die Anzahl ihrer Dimensionen: 1, 2 oder 3</translation>
    </message>
    <message>
        <source>a table kw.{name} besides kw.{other}</source>
        <translation>eine Tabelle kw.{name} neben kw.{other}</translation>
    </message>
    <message>
        <source>a point kw.{point} with one index</source>
        <translation>ein Punkt kw.{point} mit einem Index</translation>
    </message>
    <message>
        <source>a point kw.{point} with two indices</source>
        <translation>ein Punkt kw.{point} mit zwei Indizes</translation>
    </message>
    <message>
        <source>a table kw.{name}, of which there is no entry</source>
        <translation>eine Tabelle kw.{name}, von der kein Eintrag da ist</translation>
    </message>
    <message>
        <source>the setting {key}, such as mm, where a unit matters</source>
        <translation>die Angabe {key}, zum Beispiel mm, wenn es auf die Einheit ankommt</translation>
    </message>
    <message>
        <source>byte {value}</source>
        <translation>Byte {value}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid calibration file: {count} problems</source>
        <comment>{file} is not a valid calibration file: one problem</comment>
        <translation>
            <numerusform>{file} ist keine gültige Kalibrierdatei: 1 Problem</numerusform>
            <numerusform>{file} ist keine gültige Kalibrierdatei: {count} Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>there is a source for dimension {dimension}, but the table is {dimensions}D</source>
        <translation>es gibt eine Quelle für Dimension {dimension}, aber die Tabelle ist {dimensions}D</translation>
    </message>
    <message>
        <source>the table is {table}D, but {chosen}D is chosen</source>
        <translation>die Tabelle ist {table}D, gewählt ist aber {chosen}D</translation>
    </message>
    <message>
        <source>{time} ({step})</source>
        <translation>{time} ({step})</translation>
    </message>
    <message>
        <source>sign: {from}, {to}; {example}</source>
        <translation>Vorzeichen: {from}, {to}; {example}</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positiv</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>negativ</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}; {next}</translation>
    </message>
    <message>
        <source>position {number} = {position}</source>
        <translation>Position {number} = {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} columns</source>
        <comment>1 column</comment>
        <translation>
            <numerusform>1 Spalte</numerusform>
            <numerusform>{count} Spalten</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a value of type {type}; expected {expected}</source>
        <translation>&quot;{text}&quot; ist kein Wert vom Typ {type}; erwartet {expected}</translation>
    </message>
    <message>
        <source>a number such as 12.5, at most {most} in magnitude</source>
        <translation>eine Zahl wie 12.5, vom Betrag höchstens {most}</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}, or an address such as 0x1234</source>
        <translation>eine ganze Zahl von {least} bis {most} oder eine Adresse wie 0x1234</translation>
    </message>
    <message>
        <source>the name of an enum value, without blanks</source>
        <translation>der Name eines Enum-Werts ohne Leerzeichen</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}</source>
        <translation>eine ganze Zahl von {least} bis {most}</translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections</source>
        <comment>1 correction</comment>
        <translation>
            <numerusform>1 Korrektur</numerusform>
            <numerusform>{count} Korrekturen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} rows</source>
        <comment>1 row</comment>
        <translation>
            <numerusform>1 Zeile</numerusform>
            <numerusform>{count} Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections in this line, {all} in all</source>
        <comment>1 correction in this line, {all} in all</comment>
        <translation>
            <numerusform>1 Korrektur in dieser Zeile, insgesamt {all}</numerusform>
            <numerusform>{count} Korrekturen in dieser Zeile, insgesamt {all}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has {count} source axes, possible are {range}</source>
        <comment>it has 1 source axis, possible are {range}</comment>
        <translation>
            <numerusform>sie hat 1 Quellachse, möglich sind {range}</numerusform>
            <numerusform>sie hat {count} Quellachsen, möglich sind {range}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>1 Zahl</numerusform>
            <numerusform>{count} Zahlen</numerusform>
        </translation>
    </message>
    <message>
        <source>logical number of master axis 1, for master1_ax_nr</source>
        <translation>logische Nummer der Masterachse 1, für master1_ax_nr</translation>
    </message>
    <message>
        <source>logical number of master axis 2, for master2_ax_nr</source>
        <translation>logische Nummer der Masterachse 2, für master2_ax_nr</translation>
    </message>
    <message>
        <source>whether master axis 1 is linear (mm) or rotary (deg)</source>
        <translation>ob die Masterachse 1 linear (mm) oder rotatorisch (deg) ist</translation>
    </message>
    <message>
        <source>whether master axis 2 is linear (mm) or rotary (deg)</source>
        <translation>ob die Masterachse 2 linear (mm) oder rotatorisch (deg) ist</translation>
    </message>
    <message>
        <source>master axis 1 is a modulo axis: its ends are one place</source>
        <translation>Masterachse 1 ist eine Moduloachse: ihre Enden sind derselbe Ort</translation>
    </message>
    <message>
        <source>master axis 2 is a modulo axis: its ends are one place</source>
        <translation>Masterachse 2 ist eine Moduloachse: ihre Enden sind derselbe Ort</translation>
    </message>
    <message numerus="yes">
        <source>{count} points</source>
        <comment>1 point</comment>
        <translation>
            <numerusform>1 Punkt</numerusform>
            <numerusform>{count} Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>no {name}</source>
        <translation>{name} fehlt</translation>
    </message>
    <message numerus="yes">
        <source>{count} heights</source>
        <comment>1 height</comment>
        <translation>
            <numerusform>1 Höhe</numerusform>
            <numerusform>{count} Höhen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of points</source>
        <comment>1 line of points</comment>
        <translation>
            <numerusform>1 Zeile mit Punkten</numerusform>
            <numerusform>{count} Zeilen mit Punkten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} entries</source>
        <comment>1 entry</comment>
        <translation>
            <numerusform>1 Eintrag</numerusform>
            <numerusform>{count} Einträge</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values</source>
        <comment>1 value</comment>
        <translation>
            <numerusform>1 Wert</numerusform>
            <numerusform>{count} Werte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of counts</source>
        <comment>1 line of counts</comment>
        <translation>
            <numerusform>1 Zeile mit Inkrementen</numerusform>
            <numerusform>{count} Zeilen mit Inkrementen</numerusform>
        </translation>
    </message>
    <message>
        <source>{number}: {names}</source>
        <translation>{number}: {names}</translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of heights</source>
        <comment>1 line of heights</comment>
        <translation>
            <numerusform>1 Zeile mit Höhen</numerusform>
            <numerusform>{count} Zeilen mit Höhen</numerusform>
        </translation>
    </message>
    <message>
        <source>table {index} needs $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) of at least {count}; switch it on with $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 and $MA_CEC_ENABLE (MD32710) 1 of axis {axis}</source>
        <translation>Tabelle {index} braucht $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) von mindestens {count}; eingeschaltet wird sie mit $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 und $MA_CEC_ENABLE (MD32710) 1 der Achse {axis}</translation>
    </message>
    <message>
        <source>no {variable} of {curve}</source>
        <translation>{variable} fehlt für {curve}</translation>
    </message>
    <message numerus="yes">
        <source>{count} source axes</source>
        <comment>1 source axis</comment>
        <translation>
            <numerusform>1 Quellachse</numerusform>
            <numerusform>{count} Quellachsen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} sizes</source>
        <comment>1 size</comment>
        <translation>
            <numerusform>1 Größe</numerusform>
            <numerusform>{count} Größen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions and at least one correction</source>
        <comment>1 position and at least one correction</comment>
        <translation>
            <numerusform>1 Position und mindestens eine Korrektur</numerusform>
            <numerusform>{count} Positionen und mindestens eine Korrektur</numerusform>
        </translation>
    </message>
    <message>
        <source>{axes}</source>
        <translation>{axes}</translation>
    </message>
    <message>
        <source>{axes} to {target}</source>
        <translation>{axes} nach {target}</translation>
    </message>
    <message>
        <source>(table layout)</source>
        <translation>(Tabellenlayout)</translation>
    </message>
    <message>
        <source>it cannot be of type {type}; expected {expected}</source>
        <translation>der Typ kann nicht {type} sein; erwartet wird {expected}</translation>
    </message>
    <message>
        <source>f32 or f64</source>
        <translation>f32 oder f64</translation>
    </message>
    <message>
        <source>u8, u16, u32 or i32</source>
        <translation>u8, u16, u32 oder i32</translation>
    </message>
    <message>
        <source>its count is {found}, expected the length of the magic text, {expected}, which is at least 1</source>
        <translation>die Anzahl ist {found}, erwartet wird die Länge der Kennung (magic), {expected}, und mindestens 1</translation>
    </message>
    <message>
        <source>its count is 0, expected at least 1</source>
        <translation>die Anzahl ist 0, erwartet wird mindestens 1</translation>
    </message>
    <message>
        <source>its count is {found}, expected {expected}</source>
        <translation>die Anzahl ist {found}, erwartet wird {expected}</translation>
    </message>
    <message>
        <source>its type {type} cannot hold {value}</source>
        <translation>der Typ {type} kann {value} nicht aufnehmen</translation>
    </message>
    <message>
        <source>it ends at byte {end}, but the header has only {size} bytes</source>
        <translation>das Feld endet bei Byte {end}, der Kopf hat aber nur {size} Bytes</translation>
    </message>
    <message>
        <source>it covers the header bytes before it, and there are none</source>
        <translation>es gilt für die Bytes des Kopfes davor, und davor sind keine</translation>
    </message>
    <message>
        <source>it begins at byte {begin}, inside {field}, which ends at byte {end}</source>
        <translation>das Feld beginnt bei Byte {begin}, innerhalb von {field}, das bei Byte {end} endet</translation>
    </message>
    <message>
        <source>it is {size}, expected 1 to {limit} bytes</source>
        <translation>die Größe ist {size}, erwartet werden 1 bis {limit} Bytes</translation>
    </message>
    <message>
        <source>it is missing; a table cannot be read without it</source>
        <translation>das Feld fehlt; ohne es kann keine Tabelle gelesen werden</translation>
    </message>
    <message numerus="yes">
        <source>{count} positions</source>
        <comment>1 position</comment>
        <translation>
            <numerusform>1 Position</numerusform>
            <numerusform>{count} Positionen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions of {axis}</source>
        <comment>1 position of {axis}</comment>
        <translation>
            <numerusform>1 Position von {axis}</numerusform>
            <numerusform>{count} Positionen von {axis}</numerusform>
        </translation>
    </message>
    <message>
        <source>CRC {crc}</source>
        <translation>CRC {crc}</translation>
    </message>
    <message>
        <source>the body is not JSON</source>
        <translation>der Inhalt ist kein JSON</translation>
    </message>
    <message>
        <source>the body must be an array, {example}</source>
        <translation>der Inhalt muss ein Array sein, {example}</translation>
    </message>
    <message>
        <source>{place} must be an object, {example}</source>
        <translation>{place} muss ein Objekt sein, {example}</translation>
    </message>
    <message>
        <source>{place}.path must be a text</source>
        <translation>{place}.path muss ein Text sein</translation>
    </message>
    <message>
        <source>{place}.value must be a number, a text, true, false or null</source>
        <translation>{place}.value muss eine Zahl, ein Text, true, false oder null sein</translation>
    </message>
    <message>
        <source>the body must be an object with &quot;value&quot;: a number, a text, true, false or null</source>
        <translation>der Inhalt muss ein Objekt mit &quot;value&quot; sein: eine Zahl, ein Text, true, false oder null</translation>
    </message>
    <message>
        <source>one of u8, u16, u32, i32, f32, f64 or char is expected, with a count in brackets where there are several: char[32]</source>
        <translation>erwartet wird u8, u16, u32, i32, f32, f64 oder char, bei mehreren mit der Anzahl in Klammern: char[32]</translation>
    </message>
    <message>
        <source>the count is given twice, here and in the type</source>
        <translation>die Anzahl steht zweimal da, hier und im Typ</translation>
    </message>
    <message>
        <source>the number of characters is missing: char[32]</source>
        <translation>die Zahl der Zeichen fehlt: char[32]</translation>
    </message>
    <message>
        <source>there is no field {name} to hold it</source>
        <translation>es gibt kein Feld {name} dafür</translation>
    </message>
    <message>
        <source>&quot;little&quot; or &quot;big&quot; is expected</source>
        <translation>erwartet wird &quot;little&quot; oder &quot;big&quot;</translation>
    </message>
    <message>
        <source>&quot;first&quot; or &quot;last&quot; is expected</source>
        <translation>erwartet wird &quot;first&quot; oder &quot;last&quot;</translation>
    </message>
    <message>
        <source>a file path such as tables/small1.TAMtbl is expected</source>
        <translation>erwartet wird ein Dateipfad wie tables/small1.TAMtbl</translation>
    </message>
    <message>
        <source>a file path has a name between its slashes, none at its ends, and no &quot;.&quot; or &quot;..&quot;</source>
        <translation>ein Dateipfad hat Namen zwischen den Schrägstrichen, keinen Schrägstrich an den Enden und kein &quot;.&quot; oder &quot;..&quot;</translation>
    </message>
    <message>
        <source>there are more than {most} slots</source>
        <translation>es sind mehr als {most} Tabellenplätze</translation>
    </message>
    <message>
        <source>this is the value that stands for no table, enums.tableDisabled</source>
        <translation>das ist der Wert für keine Tabelle, enums.tableDisabled</translation>
    </message>
    <message>
        <source>another slot has the name {name}</source>
        <translation>ein anderer Tabellenplatz heißt {name}</translation>
    </message>
    <message>
        <source>another slot has the file {file}</source>
        <translation>ein anderer Tabellenplatz hat die Datei {file}</translation>
    </message>
    <message>
        <source>at least one slot is needed</source>
        <translation>mindestens ein Tabellenplatz ist nötig</translation>
    </message>
    <message>
        <source>the path of a web page is expected, such as /directory</source>
        <translation>erwartet wird der Pfad einer Webseite, etwa /directory</translation>
    </message>
    <message>
        <source>a slash is needed at the end, because a file path follows</source>
        <translation>am Ende ist ein Schrägstrich nötig, weil ein Dateipfad folgt</translation>
    </message>
    <message>
        <source>there must be no slash at the end</source>
        <translation>am Ende darf kein Schrägstrich stehen</translation>
    </message>
    <message>
        <source>this is the same page as directory</source>
        <translation>das ist dieselbe Seite wie directory</translation>
    </message>
    <message>
        <source>this is the same page as directory or transfer</source>
        <translation>das ist dieselbe Seite wie directory oder transfer</translation>
    </message>
    <message>
        <source>this is the same field as transferPathField</source>
        <translation>das ist dasselbe Feld wie transferPathField</translation>
    </message>
    <message>
        <source>it is empty; a register path is expected</source>
        <translation>das ist leer; erwartet wird ein Registerpfad</translation>
    </message>
    <message>
        <source>it has {count} characters, at most {most} are possible</source>
        <translation>{count} Zeichen, möglich sind höchstens {most}</translation>
    </message>
    <message>
        <source>a path has one slash between its parts and none at its ends</source>
        <translation>ein Pfad hat einen Schrägstrich zwischen seinen Teilen und keinen an den Enden</translation>
    </message>
    <message>
        <source>a path is made of letters, digits, &apos;_&apos;, &apos;-&apos;, &apos;/&apos;, &apos;[&apos; and &apos;]&apos;; the character at position {position} is none of them</source>
        <translation>ein Pfad besteht aus Buchstaben, Ziffern, &apos;_&apos;, &apos;-&apos;, &apos;/&apos;, &apos;[&apos; und &apos;]&apos;; das Zeichen an Stelle {position} gehört nicht dazu</translation>
    </message>
    <message>
        <source>the placeholder {name} is missing</source>
        <translation>der Platzhalter {name} fehlt</translation>
    </message>
    <message>
        <source>the placeholder {name} is there more than once</source>
        <translation>der Platzhalter {name} steht mehrfach da</translation>
    </message>
    <message>
        <source>the placeholder {name} has no meaning here</source>
        <translation>der Platzhalter {name} hat hier keine Bedeutung</translation>
    </message>
    <message>
        <source>in braces there can only be a placeholder, one of {known}</source>
        <translation>in geschweiften Klammern kann nur ein Platzhalter stehen: {known}</translation>
    </message>
    <message>
        <source>a range is written in brackets, such as [0..15]</source>
        <translation>ein Bereich steht in Klammern, etwa [0..15]</translation>
    </message>
    <message>
        <source>a range goes from a whole number up to another one, such as [0..15]</source>
        <translation>ein Bereich geht von einer ganzen Zahl zu einer größeren, etwa [0..15]</translation>
    </message>
    <message>
        <source>the register {path} is there twice</source>
        <translation>das Register {path} steht zweimal da</translation>
    </message>
    <message>
        <source>the shortlist has more than {most} registers</source>
        <translation>die Auswahlliste hat mehr als {most} Register</translation>
    </message>
    <message>
        <source>a word of 1 to {most} letters, digits, &apos;_&apos; or &apos;-&apos; is expected</source>
        <translation>erwartet wird ein Wort aus 1 bis {most} Buchstaben, Ziffern, &apos;_&apos; oder &apos;-&apos;</translation>
    </message>
    <message>
        <source>this is the same register as {name}</source>
        <translation>das ist dasselbe Register wie {name}</translation>
    </message>
    <message>
        <source>this is the same value as {name}</source>
        <translation>das ist derselbe Wert wie {name}</translation>
    </message>
    <message>
        <source>a numeric type is expected: Int32, UInt32, Single or Double</source>
        <translation>erwartet wird ein Zahlentyp: Int32, UInt32, Single oder Double</translation>
    </message>
    <message>
        <source>the type {type} is there twice</source>
        <translation>der Typ {type} steht zweimal da</translation>
    </message>
    <message>
        <source>at least one type is needed</source>
        <translation>mindestens ein Typ ist nötig</translation>
    </message>
    <message numerus="yes">
        <source>{count} registers</source>
        <comment>one register</comment>
        <translation>
            <numerusform>1 Register</numerusform>
            <numerusform>{count} Register</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} addresses</source>
        <comment>one address</comment>
        <translation>
            <numerusform>1 Adresse</numerusform>
            <numerusform>{count} Adressen</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{code}&quot; is not what a drive can answer; that is one of {known}</source>
        <translation>&quot;{code}&quot; kann kein Antrieb antworten; möglich sind {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a fault; known are {known}</source>
        <translation>&quot;{text}&quot; ist kein Fehler; bekannt sind {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a whole number from 1 to {most}, as {name} needs</source>
        <translation>&quot;{text}&quot; ist keine ganze Zahl von 1 bis {most}, wie sie {name} braucht</translation>
    </message>
    <message>
        <source>a fault was asked for</source>
        <translation>ein Fehler wurde verlangt</translation>
    </message>
    <message>
        <source>it is the state of the drive with serial number {found}, not of {expected}</source>
        <translation>das ist der Zustand des Antriebs mit Seriennummer {found}, nicht von {expected}</translation>
    </message>
    <message>
        <source>the profile {profile} has no slot {slot}</source>
        <translation>das Profil {profile} hat keinen Tabellenplatz {slot}</translation>
    </message>
    <message>
        <source>the table in {slot} is larger than the slot</source>
        <translation>die Tabelle in {slot} ist größer als der Tabellenplatz</translation>
    </message>
    <message>
        <source>the name of a file in the folder {folder}</source>
        <translation>der Name einer Datei im Ordner {folder}</translation>
    </message>
    <message>
        <source>{place} must be {expected}</source>
        <translation>{place} muss {expected} sein</translation>
    </message>
    <message>
        <source>a list of whole numbers, 0 or more</source>
        <translation>eine Liste ganzer Zahlen ab 0</translation>
    </message>
    <message>
        <source>a boolean, a number or a text</source>
        <translation>ein Wahrheitswert, eine Zahl oder ein Text</translation>
    </message>
    <message>
        <source>it is not the JSON of a virtual drive&apos;s state</source>
        <translation>das ist nicht das JSON vom Zustand eines virtuellen Antriebs</translation>
    </message>
    <message>
        <source>a virtual drive has at most {most} axes, not {count}</source>
        <translation>ein virtueller Antrieb hat höchstens {most} Achsen, nicht {count}</translation>
    </message>
    <message>
        <source>an axis needs a range with low below high, and a period above 0 s</source>
        <translation>eine Achse braucht einen Bereich, dessen Anfang unter dem Ende liegt, und eine Periode über 0 s</translation>
    </message>
    <message>
        <source>a parameter does not fit: {reason}</source>
        <translation>ein Parameter passt nicht: {reason}</translation>
    </message>
    <message>
        <source>{request} is not a request; these are: {known}</source>
        <translation>{request} ist keine Anfrage; es gibt: {known}</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, not {count}</source>
        <translation>1 bis {most} Register nennen, nicht {count}</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, each with its value</source>
        <translation>1 bis {most} Register nennen, jedes mit seinem Wert</translation>
    </message>
    <message>
        <source>write {request}; &quot;&quot; is everything</source>
        <translation>{request} schreiben; &quot;&quot; steht für alles</translation>
    </message>
    <message>
        <source>write {request}, the CRC in hexadecimal digits</source>
        <translation>{request} schreiben, die CRC mit hexadezimalen Ziffern</translation>
    </message>
    <message>
        <source>write {request}</source>
        <translation>{request} schreiben</translation>
    </message>
    <message>
        <source>a new pseudo-terminal</source>
        <translation>ein neues Pseudoterminal</translation>
    </message>
    <message>
        <source>no pseudo-terminal: {reason}</source>
        <translation>kein Pseudoterminal: {reason}</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another one</source>
        <translation>es gibt schon eine Datei dieses Namens; einen anderen wählen</translation>
    </message>
    <message>
        <source>the link cannot be made: {reason}</source>
        <translation>die Verknüpfung kann nicht angelegt werden: {reason}</translation>
    </message>
    <message>
        <source>the line has more than {most} characters</source>
        <translation>die Zeile hat mehr als {most} Zeichen</translation>
    </message>
    <message>
        <source>this is no request; a line is [#n ]words[ *XXXX]</source>
        <translation>das ist keine Anfrage; eine Zeile ist [#n ]Wörter[ *XXXX]</translation>
    </message>
    <message>
        <source>&quot;{value}&quot; is too large for a Single</source>
        <translation>&quot;{value}&quot; ist zu groß für einen Single</translation>
    </message>
    <message>
        <source>the value is longer than any name of an enum</source>
        <translation>der Wert ist länger als jeder Name eines Enums</translation>
    </message>
    <message>
        <source>a document type is not allowed</source>
        <translation>ein Dokumenttyp ist nicht erlaubt</translation>
    </message>
    <message>
        <source>entities are not allowed</source>
        <translation>Entitäten sind nicht erlaubt</translation>
    </message>
    <message>
        <source>the root element is {name}, expected TamTopology</source>
        <translation>das Wurzelelement ist {name}, erwartet TamTopology</translation>
    </message>
    <message>
        <source>a RegisterComponent needs Address, Type and Value</source>
        <translation>ein RegisterComponent braucht Address, Type und Value</translation>
    </message>
    <message>
        <source>the axis index must be from 0 to {most}</source>
        <translation>der Index der Achse muss von 0 bis {most} sein</translation>
    </message>
    <message>
        <source>there are more than {most} registers</source>
        <translation>es sind mehr als {most} Register</translation>
    </message>
    <message>
        <source>there is no TamStation with registers of an axis in it</source>
        <translation>es enthält keine TamStation mit Registern einer Achse</translation>
    </message>
    <message numerus="yes">
        <source>{path}, or one of {count} others asked for with it</source>
        <comment>{path}, or another one asked for with it</comment>
        <translation>
            <numerusform>{path} oder ein anderes, das mit abgefragt wurde</numerusform>
            <numerusform>{path} oder eines von {count} anderen, die mit abgefragt wurden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers</source>
        <comment>a JSON array of one register</comment>
        <translation>
            <numerusform>ein JSON-Array mit einem Register</numerusform>
            <numerusform>ein JSON-Array mit {count} Registern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers, in the order asked for</source>
        <comment>a JSON array of the one register asked for</comment>
        <translation>
            <numerusform>ein JSON-Array mit dem abgefragten Register</numerusform>
            <numerusform>ein JSON-Array mit {count} Registern in der abgefragten Reihenfolge</numerusform>
        </translation>
    </message>
    <message>
        <source>this is empty</source>
        <translation>das ist leer</translation>
    </message>
    <message>
        <source>this is there twice</source>
        <translation>das kommt zweimal vor</translation>
    </message>
    <message>
        <source>it does not read back as it was written</source>
        <translation>zurückgelesen wurde etwas anderes als geschrieben</translation>
    </message>
    <message>
        <source>it is not the table that was kept there: its size or CRC differs</source>
        <translation>es ist nicht die Tabelle, die dort aufbewahrt wurde: Größe oder CRC weicht ab</translation>
    </message>
    <message>
        <source>it was kept about a write that did not end, but is damaged ({reason}). Look at what the drive holds, then delete the file</source>
        <translation>sie gehört zu einem nicht beendeten Schreibvorgang, ist aber beschädigt ({reason}). Den Zustand des Antriebs prüfen, dann die Datei löschen</translation>
    </message>
    <message>
        <source>it is about axis {axis} of drive {drive}</source>
        <translation>sie gehört zu Achse {axis} des Antriebs {drive}</translation>
    </message>
    <message>
        <source>user name or password is missing or wrong</source>
        <translation>Benutzername oder Passwort fehlt oder ist falsch</translation>
    </message>
    <message>
        <source>the request has more bytes than the largest that the drive takes</source>
        <translation>die Anfrage hat mehr Bytes, als der Antrieb höchstens annimmt</translation>
    </message>
    <message>
        <source>it is not stated which axis the values of {column} correct, and the numbers depend on it; state the target: {sources}</source>
        <translation>es ist nicht angegeben, welche Achse die Werte von {column} korrigieren, und die Zahlen hängen davon ab; Zielachse angeben: {sources}</translation>
    </message>
    <message>
        <source>{table} is the name of table {named} and the number of table {numbered}; say name:{table} or #{table}</source>
        <translation>{table} ist der Name von Tabelle {named} und die Nummer von Tabelle {numbered}; name:{table} oder #{table} angeben</translation>
    </message>
    <message>
        <source>the table goes from {before}, and the file would say from {after}; correct the settings for its axes, or the target</source>
        <translation>die Tabelle geht von {before}, die Datei würde sagen: von {after}; die Einstellungen für ihre Achsen oder die Zielachse berichtigen</translation>
    </message>
    <message>
        <source>one axis for all columns or one for each: the name of an axis, #1 for the first source, or other</source>
        <translation>eine Achse für alle Spalten oder eine für jede: der Name einer Achse, #1 für die erste Quelle oder other</translation>
    </message>
    <message>
        <source>the axis of dimension {number}</source>
        <translation>die Achse der Dimension {number}</translation>
    </message>
    <message>
        <source>the axis of dimension {number} ({axis})</source>
        <translation>die Achse der Dimension {number} ({axis})</translation>
    </message>
    <message>
        <source>an axis that is no source</source>
        <translation>eine Achse, die keine Quelle ist</translation>
    </message>
    <message>
        <source>dimension {number} is its own position</source>
        <translation>Dimension {number} ist ihre eigene Position</translation>
    </message>
    <message>
        <source>all sources are positions of other axes</source>
        <translation>alle Quellen sind Positionen anderer Achsen</translation>
    </message>
    <message>
        <source>it corrects an axis by its own position, and this table goes from {column}</source>
        <translation>es korrigiert eine Achse nach ihrer eigenen Position, und diese Tabelle geht von {column}</translation>
    </message>
    <message>
        <source>{statement} (source {number})</source>
        <translation>{statement} (Quelle {number})</translation>
    </message>
    <message>
        <source>{statement} ({axis})</source>
        <translation>{statement} ({axis})</translation>
    </message>
    <message>
        <source>{statement} (an axis that is no source)</source>
        <translation>{statement} (eine Achse, die keine Quelle ist)</translation>
    </message>
    <message>
        <source>{count} targets are stated for {columns} columns; state one for all or one for each</source>
        <translation>{count} Zielachsen sind für {columns} Spalten angegeben; eine für alle oder eine für jede angeben</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>eine andere Achse</translation>
    </message>
    <message>
        <source>{placeholder} is expected in the path</source>
        <translation>{placeholder} wird im Pfad erwartet</translation>
    </message>
    <message>
        <source>the {what} are in {unit}, which cannot be converted to {other}, the unit of the drive; correct the unit in the file, or state it</source>
        <translation>die {what} sind in {unit}, was sich nicht in {other}, die Einheit des Antriebs, umrechnen lässt; berichtigen Sie die Einheit in der Datei oder geben Sie sie an</translation>
    </message>
    <message>
        <source>positions of dimension {number}</source>
        <translation>Positionen der Dimension {number}</translation>
    </message>
    <message>
        <source>Neither the table nor the drive states a unit for the values. The largest correction is {largest}.</source>
        <translation>Weder die Tabelle noch der Antrieb nennt eine Einheit der Werte. Die größte Korrektur ist {largest}.</translation>
    </message>
    <message>
        <source>The values are converted from {before} to {after}. The largest correction is {largest}.</source>
        <translation>Die Werte werden von {before} in {after} umgerechnet. Die größte Korrektur ist {largest}.</translation>
    </message>
    <message>
        <source>The drive states no unit for the axis; the values are written in {before}. The largest correction is {largest}.</source>
        <translation>Der Antrieb nennt keine Einheit der Achse; die Werte werden in {before} geschrieben. Die größte Korrektur ist {largest}.</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {after}. The largest correction is {largest}.</source>
        <translation>Die Tabelle nennt keine Einheit ihrer Werte; angenommen wird {after}. Die größte Korrektur ist {largest}.</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are converted from {before} to {after}: {first} to {last}.</source>
        <translation>Die Positionen der Dimension {number} werden von {before} in {after} umgerechnet: {first} bis {last}.</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them in the preview, or with --accept-large</source>
        <translation>{reason} Prüfen Sie die Einheit der Werte; wenn sie stimmen, bestätigen Sie sie in der Vorschau oder mit --accept-large</translation>
    </message>
    <message>
        <source>The largest correction, {largest}, is {percent} of the range of dimension {number}, {range}.</source>
        <translation>Die größte Korrektur, {largest}, beträgt {percent} des Bereichs der Dimension {number}, {range}.</translation>
    </message>
    <message>
        <source>The correction has a slope of {slope} along dimension {number}, between {first} and {last}.</source>
        <translation>Die Korrektur hat entlang der Dimension {number} eine Steigung von {slope}, zwischen {first} und {last}.</translation>
    </message>
    <message>
        <source>The axis is outside of the table, where the values at its ends hold. Move the axis into the table and activate again.</source>
        <translation>Die Achse steht außerhalb der Tabelle, wo die Werte an deren Enden gelten. Fahren Sie die Achse in den Bereich der Tabelle und aktivieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>The table is 0, or too small to be seen, at every position that was looked at. Move the axis to where the table is larger and activate again.</source>
        <translation>Die Tabelle ist an jeder betrachteten Position 0 oder zu klein, um erkannt zu werden. Fahren Sie die Achse dorthin, wo die Tabelle größer ist, und aktivieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>version 1 of the height map</source>
        <translation>Version 1 der Höhenkarte</translation>
    </message>
    <message>
        <source>version 2, which newer firmware writes</source>
        <translation>Version 2, die neuere Firmware schreibt</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a file</source>
        <translation>es ist eine Pipe oder ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>the values are multiplied by a number that is not 0, and shifted by a number</source>
        <translation>die Werte werden mit einer Zahl multipliziert, die nicht 0 ist, und um eine Zahl verschoben</translation>
    </message>
    <message>
        <source>an offset and a position at which the values are 0 contradict each other</source>
        <translation>ein Versatz und eine Position, an der die Werte 0 sind, widersprechen einander</translation>
    </message>
    <message>
        <source>the position at which the values are 0 needs a number for each of the {count} source axes</source>
        <translation>die Position, an der die Werte 0 sind, braucht eine Zahl für jede der {count} Quellachsen</translation>
    </message>
    <message>
        <source>{position} of source {number}, where the values shall be 0, is outside of the table, which goes from {first} to {last}</source>
        <translation>{position} der Quelle {number}, wo die Werte 0 sein sollen, liegt außerhalb der Tabelle, die von {first} bis {last} geht</translation>
    </message>
    <message>
        <source>the values are multiplied by {factor}</source>
        <translation>die Werte werden mit {factor} multipliziert</translation>
    </message>
    <message>
        <source>the values of {column} are shifted by {shift}</source>
        <translation>die Werte von {column} werden um {shift} verschoben</translation>
    </message>
    <message>
        <source>{source} is a position after the compensation: the table would be looked up where its own values have moved the axis.</source>
        <translation>{source} ist eine Position nach der Kompensation: Die Tabelle würde dort nachgeschlagen, wohin ihre eigenen Werte die Achse bewegt haben.</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; write volatile, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>die Aufzeichnung der Flash-Vorgänge dieses Antriebs war beschädigt, daher gelten alle als verbraucht; flüchtig schreiben oder die Zählung mit „axiscomp status --reset-flash-count“ zurücksetzen</translation>
    </message>
    <message>
        <source>it is not an ordinary file; move it away</source>
        <translation>das ist keine gewöhnliche Datei; bitte an einen anderen Ort verschieben</translation>
    </message>
    <message>
        <source>the SHA-256 of a certificate is expected</source>
        <translation>erwartet wird der SHA-256 eines Zertifikats</translation>
    </message>
    <message>
        <source>it cannot be renamed: {reason}</source>
        <translation>sie lässt sich nicht umbenennen: {reason}</translation>
    </message>
    <message>
        <source>it is on a network file system, where a database can be damaged; set XDG_STATE_HOME to a folder on this computer</source>
        <translation>er liegt auf einem Netzwerk-Dateisystem, auf dem eine Datenbank beschädigt werden kann; XDG_STATE_HOME auf einen Ordner dieses Rechners setzen</translation>
    </message>
    <message>
        <source>a newer version of this program has written it; use that version</source>
        <translation>eine neuere Version dieses Programms hat sie geschrieben; bitte diese Version verwenden</translation>
    </message>
    <message>
        <source>it is the database of another program; move it away</source>
        <translation>das ist die Datenbank eines anderen Programms; bitte an einen anderen Ort verschieben</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>this file system cannot share it between programs</source>
        <translation>auf diesem Dateisystem können sich Programme die Datei nicht teilen</translation>
    </message>
    <message>
        <source>the file or its folder is read-only</source>
        <translation>die Datei oder ihr Ordner ist schreibgeschützt</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>sie ist beschädigt</translation>
    </message>
    <message>
        <source>its journal of an interrupted write is damaged ({reason}). Look at what the drive holds, then move the file away</source>
        <translation>ihr Journal eines unterbrochenen Schreibvorgangs ist beschädigt ({reason}). Den Zustand des Antriebs prüfen, dann die Datei an einen anderen Ort verschieben</translation>
    </message>
    <message>
        <source>{axis} is taken for {first} to {last} in steps of {distance}; the largest shift is {shift}, at {position}</source>
        <translation>{axis} gilt als {first} bis {last} in Schritten von {distance}; die größte Verschiebung ist {shift}, bei {position}</translation>
    </message>
    <message>
        <source>position {number}</source>
        <translation>Position {number}</translation>
    </message>
    <message>
        <source>no 2 neighbouring points in every dimension with a value</source>
        <translation>nicht einmal 2 benachbarte Punkte mit Wert in jeder Dimension</translation>
    </message>
    <message>
        <source>a part of the grid that is complete; fill the points instead</source>
        <translation>ein vollständiger Teil des Gitters; füllen Sie die Punkte stattdessen</translation>
    </message>
    <message>
        <source>{axis} from {first} to {last}</source>
        <translation>{axis} von {first} bis {last}</translation>
    </message>
    <message>
        <source>{missing} of {all} points without a value; kept are {kept} points, {ranges}</source>
        <translation>{missing} von {all} Punkten ohne Wert; es bleiben {kept} Punkte, {ranges}</translation>
    </message>
    <message>
        <source>no value at all in {table}</source>
        <translation>kein einziger Wert in {table}</translation>
    </message>
    <message>
        <source>a column with values</source>
        <translation>eine Spalte mit Werten</translation>
    </message>
    <message>
        <source>{count} points without a value</source>
        <translation>{count} Punkte ohne Wert</translation>
    </message>
    <message>
        <source>at most {most} for a smooth filling; choose the nearest point or a plane</source>
        <translation>höchstens {most} für ein glattes Füllen; wählen Sie den nächsten Punkt oder eine Ebene</translation>
    </message>
    <message>
        <source>measured points of {table} on one line only</source>
        <translation>gemessene Punkte von {table} nur auf einer Linie</translation>
    </message>
    <message>
        <source>points that determine a plane; choose the nearest point instead</source>
        <translation>Punkte, die eine Ebene bestimmen; wählen Sie stattdessen den nächsten Punkt</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} bis {high}</translation>
    </message>
    <message>
        <source>{count} of {all} points of {table} without a value; they get {made}, the measured values are {measured}</source>
        <translation>{count} von {all} Punkten von {table} ohne Wert; sie erhalten {made}, die gemessenen Werte sind {measured}</translation>
    </message>
    <message>
        <source>{expected}; a tolerance of {tolerance} takes them for an even grid (--snap, or Snap tolerance in the import)</source>
        <translation>{expected}; mit einer Toleranz von {tolerance} gelten sie als gleichmäßiges Gitter (--snap oder Fangtoleranz beim Import)</translation>
    </message>
    <message>
        <source>every combination of the positions; missing points can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>jede Kombination der Positionen; fehlende Punkte können gefüllt oder weggelassen werden (--fill, --crop oder Fehlende Punkte beim Import)</translation>
    </message>
    <message>
        <source>{expected}; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>{expected}; Punkte ohne Wert können gefüllt oder weggelassen werden (--fill, --crop oder Fehlende Punkte beim Import)</translation>
    </message>
    <message>
        <source>a height with decimals; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>eine Höhe mit Nachkommastellen; Punkte ohne Wert können gefüllt oder weggelassen werden (--fill, --crop oder Fehlende Punkte beim Import)</translation>
    </message>
    <message>
        <source>every combination of the positions</source>
        <translation>jede Kombination der Positionen</translation>
    </message>
    <message>
        <source>parameter 1020 of the axis shows the commanded position with the compensation in it</source>
        <translation>Parameter 1020 der Achse zeigt die Sollposition mit der Kompensation darin</translation>
    </message>
    <message>
        <source>at most {most} for older kernels</source>
        <translation>höchstens {most} für ältere Kernel</translation>
    </message>
    <message>
        <source>the table has {count} points; older kernels take at most {most}</source>
        <translation>die Tabelle hat {count} Punkte; ältere Kernel nehmen höchstens {most}</translation>
    </message>
    <message>
        <source>unit of the positions, in place of what the header says</source>
        <translation>Einheit der Positionen, anstelle dessen, was die Kopfzeile sagt</translation>
    </message>
    <message>
        <source>unit of the values, in place of what the header says</source>
        <translation>Einheit der Werte, anstelle dessen, was die Kopfzeile sagt</translation>
    </message>
    <message>
        <source>{number} ({name}, axes: {axes})</source>
        <translation>{number} ({name}, Achsen: {axes})</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>{slot} is empty: there is nothing to delete</source>
        <translation>{slot} ist leer: es gibt nichts zu löschen</translation>
    </message>
    <message>
        <source>axis {axis} uses no table: there is nothing to delete</source>
        <translation>Achse {axis} verwendet keine Tabelle: es gibt nichts zu löschen</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}: name another slot, or none, and a free one is chosen</source>
        <translation>Tabellenplatz {slot} ist belegt durch {user}: einen anderen angeben, oder keinen, dann wird ein freier gewählt</translation>
    </message>
    <message>
        <source>the table in {slot} is not deleted, because {user} uses it; free it there first</source>
        <translation>die Tabelle in {slot} wird nicht gelöscht, weil sie noch verwendet wird ({user}); geben Sie sie dort zuerst frei</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: that one is deleted too.</source>
        <translation>Im Flash von {slot} liegt womöglich eine ältere Tabelle: sie wird mit gelöscht.</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved before {slot} is emptied: otherwise {axis} could look for the deleted table after a reboot.</source>
        <translation>Die Parameter aller Achsen werden gespeichert, bevor {slot} geleert wird: sonst könnte {axis} nach einem Neustart die gelöschte Tabelle suchen.</translation>
    </message>
    <message>
        <source>After a reboot {axis} uses the table in {slot} again, as its saved parameters say.</source>
        <translation>Nach einem Neustart verwendet {axis} wieder die Tabelle in {slot}, wie es in den gespeicherten Parametern steht.</translation>
    </message>
    <message>
        <source>the configuration has {unit} for axis {axis}, but the axis of the drive has {other}</source>
        <translation>die Konfiguration hat für Achse {axis} die Einheit {unit}, die Achse des Antriebs aber {other}</translation>
    </message>
    <message>
        <source>the profile has no slot {slot}</source>
        <translation>das Profil hat keinen Tabellenplatz {slot}</translation>
    </message>
    <message>
        <source>the station {station} has no register {path}</source>
        <translation>die Station {station} hat kein Register {path}</translation>
    </message>
    <message>
        <source>the unit is {unit}, but the axis that is written has {other}</source>
        <translation>die Einheit ist {unit}, die Achse, die geschrieben wird, hat aber {other}</translation>
    </message>
    <message>
        <source>which station of {file} is meant is not certain; name one of: {known}</source>
        <translation>welche Station von {file} gemeint ist, steht nicht fest; nennen Sie eine von diesen: {known}</translation>
    </message>
    <message>
        <source>it is not a text in UTF-8</source>
        <translation>sie ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>it is not an XML document</source>
        <translation>sie ist kein XML-Dokument</translation>
    </message>
    <message>
        <source>it ends before {name} ends</source>
        <translation>sie endet vor dem Ende von {name}</translation>
    </message>
    <message>
        <source>a tag is not well-formed</source>
        <translation>ein Tag ist nicht wohlgeformt</translation>
    </message>
    <message>
        <source>{name} ends where it has not begun</source>
        <translation>{name} endet, ohne begonnen zu haben</translation>
    </message>
    <message>
        <source>it has changed since it was read; export again</source>
        <translation>sie hat sich geändert, seit sie gelesen wurde; noch einmal exportieren</translation>
    </message>
    <message numerus="yes">
        <source>{count} more comment lines</source>
        <comment>1 more comment line</comment>
        <translation>
            <numerusform>1 weitere Kommentarzeile</numerusform>
            <numerusform>{count} weitere Kommentarzeilen</numerusform>
        </translation>
    </message>
    <message>
        <source>at most 1 MiB of comments</source>
        <translation>höchstens 1 MiB Kommentare</translation>
    </message>
    <message>
        <source>The drive looks up where it should, but adds nothing while it evaluates. Activate to prove what it adds.</source>
        <translation>Der Antrieb schlägt an der richtigen Stelle nach, addiert beim Auswerten aber nichts. Aktivieren Sie, um nachzuweisen, was er addiert.</translation>
    </message>
    <message>
        <source>it has nothing of axis {axis}</source>
        <translation>sie enthält nichts von der Achse {axis}</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: {percent} of the travel of axis {axis}, {low} to {high}. Beyond the table the drive holds the value of its end.</source>
        <translation>Dimension {number} der Tabelle reicht von {first} bis {last}: {percent} des Verfahrwegs von Achse {axis}, {low} bis {high}. Außerhalb der Tabelle hält der Antrieb den Endwert.</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: outside the travel of axis {axis}, {low} to {high}. The drive holds the value of one end everywhere.</source>
        <translation>Dimension {number} der Tabelle reicht von {first} bis {last}: außerhalb des Verfahrwegs von Achse {axis}, {low} bis {high}. Der Antrieb hält überall einen Endwert.</translation>
    </message>
    <message>
        <source>The backup is of another drive, the one with the serial number {number}.</source>
        <translation>Die Sicherung ist von einem anderen Antrieb, dem mit der Seriennummer {number}.</translation>
    </message>
    <message>
        <source>a full {dimensions}D grid of {points} points</source>
        <translation>ein volles {dimensions}D-Gitter mit {points} Punkten</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid measurement: {count} problems</source>
        <comment>{file} is not a valid measurement: one problem</comment>
        <translation>
            <numerusform>{file} ist keine gültige Messung: ein Problem</numerusform>
            <numerusform>{file} ist keine gültige Messung: {count} Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} does not say its units; state them with --unit and --value-unit</source>
        <translation>{file} nennt seine Einheiten nicht; geben Sie sie mit --unit und --value-unit an</translation>
    </message>
    <message>
        <source>the positions in {file} do not follow one another one to one</source>
        <translation>die Positionen in {file} folgen einander nicht eins zu eins</translation>
    </message>
    <message>
        <source>{file} has no targets; the figures of the standard need a measurement of runs over targets</source>
        <translation>{file} hat keine Zielpositionen; die Kennwerte der Norm brauchen eine Messung mit Durchläufen über Zielpositionen</translation>
    </message>
    <message>
        <source>an error in mm</source>
        <translation>eine Abweichung in mm</translation>
    </message>
    <message>
        <source>a position without a bidirectional mean</source>
        <translation>eine Position ohne Mittelwert beider Richtungen</translation>
    </message>
    <message>
        <source>the same positions in both blocks</source>
        <translation>dieselben Positionen in beiden Blöcken</translation>
    </message>
    <message>
        <source>no block of a direction</source>
        <translation>kein Block einer Richtung</translation>
    </message>
    <message>
        <source>a block Forward Directional Avg Error; the mean of both directions alone says nothing of either</source>
        <translation>ein Block „Forward Directional Avg Error“; der Mittelwert beider Richtungen allein sagt nichts über die einzelne</translation>
    </message>
    <message>
        <source>means of a linear measurement (.pos)</source>
        <translation>Mittelwerte einer Längenmessung (.pos)</translation>
    </message>
    <message>
        <source>TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= or KEY=</source>
        <translation>TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= oder SCHLÜSSEL=</translation>
    </message>
    <message>
        <source>the position of a target</source>
        <translation>die Lage einer Zielposition</translation>
    </message>
    <message>
        <source>a second target {number}</source>
        <translation>eine zweite Zielposition {number}</translation>
    </message>
    <message>
        <source>each target once</source>
        <translation>jede Zielposition einmal</translation>
    </message>
    <message>
        <source>a position of the reference</source>
        <translation>eine Position der Referenz</translation>
    </message>
    <message>
        <source>{key}: {said}, but {found} are there</source>
        <translation>{key}: {said}, vorhanden sind {found}</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>die ganze Datei</translation>
    </message>
    <message>
        <source>a length or an angle: mm, um, m, inch, deg, arcsec, mrad</source>
        <translation>eine Länge oder ein Winkel: mm, um, m, inch, deg, arcsec, mrad</translation>
    </message>
    <message>
        <source>the number of a target, TGT_DATA[{number}]=</source>
        <translation>die Nummer einer Zielposition, TGT_DATA[{number}]=</translation>
    </message>
    <message>
        <source>data of an ISO 230-2 test</source>
        <translation>Daten einer Prüfung nach ISO 230-2</translation>
    </message>
    <message>
        <source>a head such as i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</source>
        <translation>ein Kopf wie i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</translation>
    </message>
    <message>
        <source>a position</source>
        <translation>eine Position</translation>
    </message>
    <message>
        <source>{value}, as the head of the table has</source>
        <translation>{value} wie im Kopf der Tabelle</translation>
    </message>
    <message>
        <source>a report by a program that is known to print forward and backward the other way round</source>
        <translation>ein Bericht eines Programms, das vorwärts und rückwärts bekanntermaßen vertauscht ausgibt</translation>
    </message>
    <message>
        <source>report of an ISO 230-2 test, with its results</source>
        <translation>Bericht einer Prüfung nach ISO 230-2 mit Ergebnissen</translation>
    </message>
    <message>
        <source>a line with the names of the columns, such as target [mm]</source>
        <translation>eine Zeile mit den Namen der Spalten, zum Beispiel target [mm]</translation>
    </message>
    <message>
        <source>no column {column} for {role}</source>
        <translation>keine Spalte {column} für {role}</translation>
    </message>
    <message numerus="yes">
        <source>the name of a column, or its number from 1 to {count}</source>
        <comment>the name of the column, or 1</comment>
        <translation>
            <numerusform>der Name der Spalte oder 1</numerusform>
            <numerusform>der Name einer Spalte oder ihre Nummer von 1 bis {count}</numerusform>
        </translation>
    </message>
    <message>
        <source>two columns for {role}</source>
        <translation>zwei Spalten für {role}</translation>
    </message>
    <message>
        <source>one; name the columns with --columns</source>
        <translation>eine; benennen Sie die Spalten mit --columns</translation>
    </message>
    <message>
        <source>a column for {role}</source>
        <translation>eine Spalte für {role}</translation>
    </message>
    <message>
        <source>one of these words before the =: {known}</source>
        <translation>eines dieser Wörter vor dem =: {known}</translation>
    </message>
    <message>
        <source>a unit in brackets behind the name, such as {example}, or --unit and --value-unit</source>
        <translation>eine Einheit in Klammern hinter dem Namen, zum Beispiel {example}, oder --unit und --value-unit</translation>
    </message>
    <message>
        <source>column {column}</source>
        <translation>Spalte {column}</translation>
    </message>
    <message>
        <source>the unit {unit} of column {column}</source>
        <translation>die Einheit {unit} der Spalte {column}</translation>
    </message>
    <message>
        <source>an angle as the targets are</source>
        <translation>ein Winkel wie die Zielpositionen</translation>
    </message>
    <message>
        <source>a length as the targets are</source>
        <translation>eine Länge wie die Zielpositionen</translation>
    </message>
    <message>
        <source>corrected: none, or corrected: 20C</source>
        <translation>corrected: none oder corrected: 20C</translation>
    </message>
    <message>
        <source>values: deviation, or values: reference</source>
        <translation>values: deviation oder values: reference</translation>
    </message>
    <message>
        <source>sign: deviation (reference minus target), or sign: correction (its opposite)</source>
        <translation>sign: deviation (Referenz minus Zielposition) oder sign: correction (das Gegenteil)</translation>
    </message>
    <message>
        <source>a temperature in deg C, such as 20.4</source>
        <translation>eine Temperatur in °C, zum Beispiel 20.4</translation>
    </message>
    <message>
        <source>a coefficient of expansion in 1/K, such as 11.5e-6</source>
        <translation>ein Ausdehnungskoeffizient in 1/K, zum Beispiel 11.5e-6</translation>
    </message>
    <message>
        <source>compensation: off, on, or crc: with the checksum of the table, such as crc:1c291ca3</source>
        <translation>compensation: off, on oder crc: mit der Prüfsumme der Tabelle, zum Beispiel crc:1c291ca3</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names no columns; write target=1,direction=3,deviation=5, with numbers or names of columns</source>
        <translation>„{text}“ benennt keine Spalten; schreiben Sie target=1,direction=3,deviation=5 mit Nummern oder Namen von Spalten</translation>
    </message>
    <message>
        <source>no columns X and Y</source>
        <translation>keine Spalten X und Y</translation>
    </message>
    <message>
        <source>columns X and Y, or X, Y and Z, with the positions</source>
        <translation>Spalten X und Y, oder X, Y und Z, mit den Positionen</translation>
    </message>
    <message>
        <source>no column of values</source>
        <translation>keine Spalte mit Werten</translation>
    </message>
    <message>
        <source>at least one behind the positions, such as dX [um]</source>
        <translation>mindestens eine hinter den Positionen, zum Beispiel dX [um]</translation>
    </message>
    <message>
        <source>a line for each point</source>
        <translation>eine Zeile für jeden Punkt</translation>
    </message>
    <message>
        <source>CSV of values at positions of 2 or 3 axes</source>
        <translation>CSV mit Werten an Positionen von 2 oder 3 Achsen</translation>
    </message>
    <message>
        <source>run, number of the target and deviation, such as 1 1 0.21</source>
        <translation>Durchlauf, Nummer der Zielposition und Abweichung, zum Beispiel 1 1 0.21</translation>
    </message>
    <message>
        <source>a deviation</source>
        <translation>eine Abweichung</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>eine ganze Zahl ab 1</translation>
    </message>
    <message numerus="yes">
        <source>a number from 1 to {count}, as there are targets</source>
        <comment>1, the only target</comment>
        <translation>
            <numerusform>1, die einzige Zielposition</numerusform>
            <numerusform>eine Nummer von 1 bis {count}, so viele Zielpositionen gibt es</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole file; save it again from the instrument&apos;s software</source>
        <translation>die ganze Datei; speichern Sie sie aus der Software des Messgeräts neu</translation>
    </message>
    <message>
        <source>File type: rtl or rta, which says the units</source>
        <translation>File type: rtl oder rta, woraus die Einheiten folgen</translation>
    </message>
    <message>
        <source>sections TARGET DATA:: and DEVIATIONS:: with their numbers</source>
        <translation>Abschnitte TARGET DATA:: und DEVIATIONS:: mit ihren Zahlen</translation>
    </message>
    <message numerus="yes">
        <source>{count} runs of a unidirectional file that are exactly 0 throughout</source>
        <comment>1 run of a unidirectional file that is exactly 0 throughout</comment>
        <translation>
            <numerusform>1 Durchlauf einer einseitigen Messung, der überall genau 0 ist</numerusform>
            <numerusform>{count} Durchläufe einer einseitigen Messung, die überall genau 0 sind</numerusform>
        </translation>
    </message>
    <message>
        <source>a run whose target numbers rise or fall throughout</source>
        <translation>ein Durchlauf, dessen Zielnummern durchgehend steigen oder fallen</translation>
    </message>
    <message>
        <source>linear and angular measurements (.rtl, .rta)</source>
        <translation>Längen- und Winkelmessungen (.rtl, .rta)</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times smaller, as um for mm</source>
        <translation>die Referenz hat eine 1000-mal kleinere Einheit, zum Beispiel um statt mm</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times larger, as m for mm</source>
        <translation>die Referenz hat eine 1000-mal größere Einheit, zum Beispiel m statt mm</translation>
    </message>
    <message>
        <source>the reference is in mm and the encoder in inch</source>
        <translation>die Referenz ist in mm und der Geber in Zoll</translation>
    </message>
    <message>
        <source>the reference is in inch and the encoder in mm</source>
        <translation>die Referenz ist in Zoll und der Geber in mm</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts half</source>
        <translation>der Faktor des Interferometers stimmt nicht: es zählt die Hälfte</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts double</source>
        <translation>der Faktor des Interferometers stimmt nicht: es zählt doppelt</translation>
    </message>
    <message>
        <source>the reference is in degrees and the encoder in radians</source>
        <translation>die Referenz ist in Grad und der Geber in Radiant</translation>
    </message>
    <message>
        <source>the reference is in radians and the encoder in degrees</source>
        <translation>die Referenz ist in Radiant und der Geber in Grad</translation>
    </message>
    <message>
        <source>the instrument counts the other way; if so, say it with --invert-reference</source>
        <translation>das Messgerät zählt andersherum; wenn das so ist, geben Sie --invert-reference an</translation>
    </message>
    <message>
        <source>1; {meaning}: correct the file, or state the unit of the reference with --value-unit, and that of the other positions with --unit</source>
        <translation>1; {meaning}: berichtigen Sie die Datei oder geben Sie die Einheit der Referenz mit --value-unit an und die der anderen Positionen mit --unit</translation>
    </message>
    <message>
        <source>1 within 1 %; check which columns are reference and encoder, and their units</source>
        <translation>1 auf 1 % genau; prüfen Sie, welche Spalten Referenz und Geber sind, und ihre Einheiten</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets</source>
        <comment>1 target</comment>
        <translation>
            <numerusform>1 Zielposition</numerusform>
            <numerusform>{count} Zielpositionen</numerusform>
        </translation>
    </message>
    <message>
        <source>at least 2 different positions that the axis was sent to</source>
        <translation>mindestens 2 verschiedene Positionen, die die Achse angefahren hat</translation>
    </message>
    <message>
        <source>target {target}, {direction}, run {run} in line {first} and in line {second}</source>
        <translation>Zielposition {target}, {direction}, Durchlauf {run} in Zeile {first} und in Zeile {second}</translation>
    </message>
    <message>
        <source>{up} up and {down} down</source>
        <translation>{up} aufwärts und {down} abwärts</translation>
    </message>
    <message>
        <source>as many in each direction</source>
        <translation>gleich viele in jeder Richtung</translation>
    </message>
    <message numerus="yes">
        <source>no value for {places} ({count} are missing)</source>
        <comment>no value for {places}</comment>
        <translation>
            <numerusform>kein Wert für {places}</numerusform>
            <numerusform>kein Wert für {places} ({count} fehlen)</numerusform>
        </translation>
    </message>
    <message>
        <source>a value for every target in every run</source>
        <translation>ein Wert für jede Zielposition in jedem Durchlauf</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the target</source>
        <translation>Werte, die mit der Zielposition um {slope} steigen</translation>
    </message>
    <message>
        <source>deviations, which hardly follow it</source>
        <translation>Abweichungen, die ihr kaum folgen</translation>
    </message>
    <message>
        <source>a largest deviation of {value} over {travel}</source>
        <translation>eine größte Abweichung von {value} auf {travel}</translation>
    </message>
    <message>
        <source>more than a billionth of the travel</source>
        <translation>mehr als ein Milliardstel des Wegs</translation>
    </message>
    <message>
        <source>at most 1 % of the travel</source>
        <translation>höchstens 1 % des Wegs</translation>
    </message>
    <message>
        <source>the reference moves {slope} times as far as the axis</source>
        <translation>die Referenz bewegt sich {slope}-mal so weit wie die Achse</translation>
    </message>
    <message>
        <source>no column target</source>
        <translation>keine Spalte target</translation>
    </message>
    <message>
        <source>a column target, or which column it is: --columns &apos;target=1,direction=2,...&apos;</source>
        <translation>eine Spalte target, oder welche Spalte es ist: --columns &apos;target=1,direction=2,...&apos;</translation>
    </message>
    <message>
        <source>no column direction</source>
        <translation>keine Spalte direction</translation>
    </message>
    <message>
        <source>a column direction with + and -, or --direction-from order when the runs rise and fall</source>
        <translation>eine Spalte direction mit + und -, oder --direction-from order, wenn die Durchläufe steigen und fallen</translation>
    </message>
    <message>
        <source>neither deviation nor reference</source>
        <translation>weder deviation noch reference</translation>
    </message>
    <message>
        <source>both deviation and reference</source>
        <translation>sowohl deviation als auch reference</translation>
    </message>
    <message>
        <source>either a column deviation (reference minus target) or a column reference (position)</source>
        <translation>entweder eine Spalte deviation (Referenz minus Zielposition) oder eine Spalte reference (Position)</translation>
    </message>
    <message>
        <source>+ or -, up or down, forward or backward</source>
        <translation>+ oder -, up oder down, forward oder backward</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>Zeile {line}</translation>
    </message>
    <message>
        <source>at least two targets one after the other in each run, so that its direction shows</source>
        <translation>mindestens zwei Zielpositionen nacheinander in jedem Durchlauf, damit seine Richtung zu sehen ist</translation>
    </message>
    <message>
        <source>CSV with a line for each value</source>
        <translation>CSV mit einer Zeile für jeden Wert</translation>
    </message>
    <message>
        <source>no column encoder</source>
        <translation>keine Spalte encoder</translation>
    </message>
    <message>
        <source>no column reference</source>
        <translation>keine Spalte reference</translation>
    </message>
    <message>
        <source>columns encoder and reference</source>
        <translation>Spalten encoder und reference</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples</source>
        <comment>1 sample</comment>
        <translation>
            <numerusform>1 Messpunkt</numerusform>
            <numerusform>{count} Messpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>at least {count} samples of an axis that moves</source>
        <translation>mindestens {count} Messpunkte einer Achse, die sich bewegt</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples after turns, until the axis had moved {overrun}</source>
        <comment>1 sample after a turn, until the axis had moved {overrun}</comment>
        <translation>
            <numerusform>1 Messpunkt nach einer Umkehr, bis die Achse {overrun} gefahren war</numerusform>
            <numerusform>{count} Messpunkte nach Umkehrungen, bis die Achse {overrun} gefahren war</numerusform>
        </translation>
    </message>
    <message>
        <source>CSV of encoder and reference positions without targets</source>
        <translation>CSV mit Geber- und Referenzpositionen ohne Zielpositionen</translation>
    </message>
    <message>
        <source>columns of runs that are either deviations or positions</source>
        <translation>Spalten von Durchläufen, die Abweichungen oder Positionen sein können</translation>
    </message>
    <message>
        <source>a column target before those of the runs</source>
        <translation>eine Spalte target vor denen der Durchläufe</translation>
    </message>
    <message>
        <source>CSV with a line for each target</source>
        <translation>CSV mit einer Zeile für jede Zielposition</translation>
    </message>
    <message>
        <source>angles do not change with temperature or air: the correction is for lengths</source>
        <translation>Winkel ändern sich nicht mit Temperatur oder Luft: die Korrektur ist für Längen</translation>
    </message>
    <message>
        <source>the file says that its values are corrected to 20 deg C already; correcting them again would make them wrong</source>
        <translation>nach der Datei sind die Werte schon auf 20 °C korrigiert; eine weitere Korrektur würde sie verfälschen</translation>
    </message>
    <message>
        <source>a temperature is in deg C and a coefficient of expansion in 1/K, such as 22.5 and 11.5e-6</source>
        <translation>eine Temperatur ist in °C und ein Ausdehnungskoeffizient in 1/K, zum Beispiel 22.5 und 11.5e-6</translation>
    </message>
    <message>
        <source>a dead path is a length in mm between the interferometer and the reflector, at most 100 m</source>
        <translation>eine Totstrecke ist eine Länge in mm zwischen Interferometer und Reflektor, höchstens 100 m</translation>
    </message>
    <message>
        <source>there is no such air on the dead path: pressure is in kPa (50 to 120), temperature in deg C (-40 to 60), humidity in percent (0 to 100)</source>
        <translation>solche Luft gibt es auf der Totstrecke nicht: Druck in kPa (50 bis 120), Temperatur in °C (-40 bis 60), Feuchte in Prozent (0 bis 100)</translation>
    </message>
    <message>
        <source>{file} does not describe a dead path: {reason}</source>
        <translation>{file} beschreibt keine Totstrecke: {reason}</translation>
    </message>
    <message>
        <source>the air of run {run} {direction} is not known; the dead path needs pressure, temperature and humidity of every run</source>
        <translation>die Luft während Durchlauf {run} {direction} ist nicht bekannt; die Totstrecke braucht Druck, Temperatur und Feuchte jedes Durchlaufs</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>eine Zahl, die nicht negativ ist</translation>
    </message>
    <message>
        <source>the uncertainty budget is wrong: {reason}</source>
        <translation>das Unsicherheitsbudget ist falsch: {reason}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no angle; write a number that is not negative and its unit, such as 5arcsec</source>
        <translation>„{text}“ ist kein Winkel; schreiben Sie eine nicht negative Zahl mit Einheit, zum Beispiel 5arcsec</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no length; write a number that is not negative and its unit, such as 10um</source>
        <translation>„{text}“ ist keine Länge; schreiben Sie eine nicht negative Zahl mit Einheit, zum Beispiel 10um</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no tolerance; write a figure and its limit, such as A=10um; the figures are A, A+, A-, R, R+, R-, E, E+, E-, B, Bm and M</source>
        <translation>„{text}“ ist keine Toleranz; schreiben Sie einen Kennwert und seine Grenze, zum Beispiel A=10um; die Kennwerte sind A, A+, A-, R, R+, R-, E, E+, E-, B, Bm und M</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names nothing that can be excluded; write down:1:1 for a value (direction, target, run), run:up:3 or target:7</source>
        <translation>„{text}“ benennt nichts, was ausgeschlossen werden kann; schreiben Sie down:1:1 für einen Wert (Richtung, Zielposition, Durchlauf), run:up:3 oder target:7</translation>
    </message>
    <message>
        <source>there is no value {exclusion}: the measurement has {targets} targets, {up} runs up and {down} runs down</source>
        <translation>es gibt keinen Wert {exclusion}: die Messung hat {targets} Zielpositionen, {up} Durchläufe aufwärts und {down} abwärts</translation>
    </message>
    <message>
        <source>only runs over targets can be joined; one file has {kind}</source>
        <translation>nur Durchläufe über Zielpositionen können verbunden werden; eine Datei enthält {kind}</translation>
    </message>
    <message>
        <source>a measurement of lengths and one of angles cannot be joined</source>
        <translation>eine Messung von Längen und eine von Winkeln können nicht verbunden werden</translation>
    </message>
    <message>
        <source>measurements with different tables, or with and without compensation, cannot be joined</source>
        <translation>Messungen mit verschiedenen Tabellen oder mit und ohne Kompensation können nicht verbunden werden</translation>
    </message>
    <message>
        <source>these positions cannot tell an error with the period {period}: they lie in {filled} of {classes} equal parts of the period, and {fewest} are needed; measure at targets that are spread over the period (axiscomp targets --period), or leave the period out</source>
        <translation>an diesen Positionen lässt sich ein Fehler mit der Periode {period} nicht erkennen: sie liegen in {filled} von {classes} gleichen Teilen der Periode, nötig sind {fewest}; messen Sie an Zielpositionen, die über die Periode verteilt sind (axiscomp targets --period), oder lassen Sie die Periode weg</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of the grid, at {region}, are more than {distances} distances away from any measured point; measure there, take a smaller grid, or let them be filled (--fill smooth or --fill nearest)</source>
        <comment>one point of the grid, at {region}, is more than {distances} distances away from any measured point; measure there, take a smaller grid, or let it be filled (--fill smooth or --fill nearest)</comment>
        <translation>
            <numerusform>eine Stützstelle, bei {region}, ist mehr als {distances} Gitterabstände von jedem gemessenen Punkt entfernt; messen Sie dort, nehmen Sie ein kleineres Gitter, oder lassen Sie sie füllen (--fill smooth oder --fill nearest)</numerusform>
            <numerusform>{count} Stützstellen, bei {region}, sind mehr als {distances} Gitterabstände von jedem gemessenen Punkt entfernt; messen Sie dort, nehmen Sie ein kleineres Gitter, oder lassen Sie sie füllen (--fill smooth oder --fill nearest)</numerusform>
        </translation>
    </message>
    <message>
        <source>the computation did not come to an end: {reason}</source>
        <translation>die Berechnung kam zu keinem Ende: {reason}</translation>
    </message>
    <message>
        <source>each position must have one value and one weight</source>
        <translation>zu jeder Position gehört ein Wert und ein Gewicht</translation>
    </message>
    <message>
        <source>positions, values and weights must be finite numbers</source>
        <translation>Positionen, Werte und Gewichte müssen endliche Zahlen sein</translation>
    </message>
    <message>
        <source>weights must be larger than 0</source>
        <translation>Gewichte müssen größer als 0 sein</translation>
    </message>
    <message>
        <source>the period of a modulo axis must be a number above 0</source>
        <translation>die Periode einer Modulo-Achse muss eine Zahl über 0 sein</translation>
    </message>
    <message>
        <source>there are values at {count} positions; this method needs {fewest}, measure more of them or choose another method</source>
        <translation>an {count} Positionen gibt es Werte; dieses Verfahren braucht {fewest}, messen Sie an mehr Positionen, oder wählen Sie ein anderes Verfahren</translation>
    </message>
    <message>
        <source>the number of harmonics must be 1 to 1000</source>
        <translation>die Anzahl der Harmonischen muss 1 bis 1000 sein</translation>
    </message>
    <message>
        <source>a period has at least one harmonic</source>
        <translation>eine Periode hat mindestens eine Harmonische</translation>
    </message>
    <message>
        <source>a period must be a number above 0</source>
        <translation>eine Periode muss eine Zahl über 0 sein</translation>
    </message>
    <message>
        <source>the period {period} is wanted twice, by itself or as a harmonic of another; give each once</source>
        <translation>die Periode {period} ist zweimal angegeben, für sich oder als Harmonische einer anderen; geben Sie jede einmal an</translation>
    </message>
    <message>
        <source>the period {period} does not divide the turn of {turn}; on a modulo axis it must</source>
        <translation>die Periode {period} teilt die Umdrehung von {turn} nicht; auf einer Modulo-Achse muss sie das</translation>
    </message>
    <message>
        <source>the smoothness must be a number above 0</source>
        <translation>die Glätte muss eine Zahl über 0 sein</translation>
    </message>
    <message>
        <source>a smoothness of {smoothness} cannot be computed for these positions; take a smaller one</source>
        <translation>mit einer Glätte von {smoothness} lässt sich für diese Positionen nicht rechnen; nehmen Sie eine kleinere</translation>
    </message>
    <message>
        <source>a grid has one to three dimensions, with two points and a distance above 0 in each</source>
        <translation>ein Gitter hat eine bis drei Dimensionen, in jeder mindestens zwei Punkte und einen Abstand über 0</translation>
    </message>
    <message>
        <source>points need one finite number for each dimension, for their value and for their weight</source>
        <translation>Punkte brauchen je eine endliche Zahl für jede Dimension, für ihren Wert und für ihr Gewicht</translation>
    </message>
    <message>
        <source>the smoothness must be a number of 0 or more</source>
        <translation>die Glätte muss eine Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>{axis} {from} to {to}</source>
        <translation>{axis} {from} bis {to}</translation>
    </message>
    <message>
        <source>with a smoothness of 0 every point of the grid needs a measured one beside it, and {count} have none; take a larger smoothness or a coarser grid</source>
        <translation>mit einer Glätte von 0 braucht jede Stützstelle einen gemessenen Punkt neben sich, und {count} haben keinen; nehmen Sie eine größere Glätte oder ein gröberes Gitter</translation>
    </message>
    <message>
        <source>no point lies within the grid; check its start and end, and the unit of the positions</source>
        <translation>kein Punkt liegt im Gitter; prüfen Sie dessen Anfang und Ende sowie die Einheit der Positionen</translation>
    </message>
    <message>
        <source>the points do not determine every point of the grid; take a larger smoothness or a coarser grid</source>
        <translation>die Punkte bestimmen nicht jede Stützstelle; nehmen Sie eine größere Glätte oder ein gröberes Gitter</translation>
    </message>
    <message>
        <source>the points lie too unevenly for so little smoothness; take a larger smoothness or a coarser grid</source>
        <translation>die Punkte liegen zu ungleichmäßig für so wenig Glätte; nehmen Sie eine größere Glätte oder ein gröberes Gitter</translation>
    </message>
    <message>
        <source>the table that was active has other sources than the table that is made</source>
        <translation>die Tabelle, die aktiv war, hat andere Quellen als die Tabelle, die entsteht</translation>
    </message>
    <message>
        <source>a table has one to three dimensions</source>
        <translation>eine Tabelle hat eine bis drei Dimensionen</translation>
    </message>
    <message>
        <source>the tables that were active move their axes too much for their raw position to be found; check the unit of their values</source>
        <translation>die Tabellen, die aktiv waren, bewegen ihre Achsen zu stark, als dass sich deren rohe Position finden ließe; prüfen Sie die Einheit ihrer Werte</translation>
    </message>
    <message>
        <source>Column {column} of the file has positions in {unit}, but its source {source} is a temperature.</source>
        <translation>Spalte {column} der Datei hat Positionen in {unit}, aber ihre Quelle {source} ist eine Temperatur.</translation>
    </message>
    <message>
        <source>Column {column} of the file is named as an axis, but its source {source} is a temperature.</source>
        <translation>Spalte {column} der Datei heißt wie eine Achse, aber ihre Quelle {source} ist eine Temperatur.</translation>
    </message>
    <message>
        <source>Column {column} of the file has temperatures, but its source {source} is a position.</source>
        <translation>Spalte {column} der Datei hat Temperaturen, aber ihre Quelle {source} ist eine Position.</translation>
    </message>
    <message>
        <source>Column {column} of the file is not named as axis {axis}, whose position its source {source} is.</source>
        <translation>Spalte {column} der Datei heißt nicht wie die Achse {axis}, deren Position ihre Quelle {source} ist.</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up; keep the table persistent, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>auch das Entfernen einer Tabelle aus dem Flash ist ein Flash-Vorgang, und die Aufzeichnung der Flash-Vorgänge dieses Antriebs war beschädigt, daher gelten alle als verbraucht; die Tabelle dauerhaft lassen oder die Zählung mit „axiscomp status --reset-flash-count“ zurücksetzen</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for removing the table from flash, but not for putting everything back if it fails; wait {seconds} s, or keep the table persistent</source>
        <translation>die übrigen Flash-Vorgänge reichen, um die Tabelle aus dem Flash zu entfernen, aber nicht, um nach einem Fehlschlag alles zurückzustellen; {seconds} s warten oder die Tabelle dauerhaft lassen</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and there were too many of them in a short time; wait {seconds} s, or keep the table persistent</source>
        <translation>auch das Entfernen einer Tabelle aus dem Flash ist ein Flash-Vorgang, und es waren zu viele in kurzer Zeit; {seconds} s warten oder die Tabelle dauerhaft lassen</translation>
    </message>
    <message>
        <source>The table is removed from flash, which is a flash operation too. After a reboot the axis has no table.</source>
        <translation>Die Tabelle wird aus dem Flash entfernt, und auch das ist ein Flash-Vorgang. Nach einem Neustart hat die Achse keine Tabelle.</translation>
    </message>
    <message>
        <source>&quot;{range}&quot; is not a range of addresses: {reason}</source>
        <translation>„{range}“ ist kein Adressbereich: {reason}</translation>
    </message>
    <message>
        <source>write it as {network}, {range} or {address}, with {port} behind it for another port</source>
        <translation>als {network}, {range} oder {address} schreiben, mit {port} dahinter für einen anderen Port</translation>
    </message>
    <message>
        <source>a port is a number from 1 to 65535</source>
        <translation>ein Port ist eine Zahl von 1 bis 65535</translation>
    </message>
    <message>
        <source>its last address is before the first</source>
        <translation>die letzte Adresse kommt vor der ersten</translation>
    </message>
    <message>
        <source>it has {count} addresses, and a search asks {limit} at most: name a part of it</source>
        <translation>er hat {count} Adressen, und eine Suche fragt höchstens {limit}: einen Teil davon nennen</translation>
    </message>
    <message>
        <source>these are no addresses of computers</source>
        <translation>das sind keine Adressen von Rechnern</translation>
    </message>
    <message>
        <source>the wanted distance must be a number above 0</source>
        <translation>der gewünschte Abstand muss eine Zahl über 0 sein</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes more than {count} points; with these it is {found}; allow more points or a larger distance</source>
        <translation>ein Abstand von {distance} zur Kurve braucht mehr als {count} Stützstellen; mit diesen ist er {found}; erlauben Sie mehr Stützstellen oder einen größeren Abstand</translation>
    </message>
    <message>
        <source>each point needs a finite position and deviation in two or three dimensions</source>
        <translation>jeder Punkt braucht eine endliche Position und Abweichung in zwei oder drei Dimensionen</translation>
    </message>
    <message>
        <source>the points lie on a line, or on a plane in space, and cannot tell how the artefact lay; measure points beside it</source>
        <translation>die Punkte liegen auf einer Geraden, oder im Raum auf einer Ebene, und zeigen nicht, wie der Prüfkörper lag; messen Sie Punkte daneben</translation>
    </message>
    <message>
        <source>targets and deviations must be finite numbers</source>
        <translation>Zielpositionen und Abweichungen müssen endliche Zahlen sein</translation>
    </message>
    <message>
        <source>there are values at {count} targets; a table needs two</source>
        <translation>an {count} Zielpositionen gibt es Werte; eine Tabelle braucht zwei</translation>
    </message>
    <message>
        <source>the target {target} has no value of one direction; measure it, leave the target out, or make the table of the other direction (--direction)</source>
        <translation>an der Zielposition {target} fehlt der Wert einer Richtung; messen Sie ihn, lassen Sie die Zielposition weg, oder machen Sie die Tabelle aus der anderen Richtung (--direction)</translation>
    </message>
    <message>
        <source>known periods are fitted by the method smooth only (--method smooth)</source>
        <translation>bekannte Perioden gibt es nur mit dem Verfahren smooth (--method smooth)</translation>
    </message>
    <message>
        <source>harmonics need the length of a turn, which is that of a modulo axis</source>
        <translation>Harmonische brauchen die Länge einer Umdrehung, also eine Modulo-Achse</translation>
    </message>
    <message>
        <source>there is no such method</source>
        <translation>dieses Verfahren gibt es nicht</translation>
    </message>
    <message>
        <source>a modulo axis has no slope that could be removed: it ends where it begins</source>
        <translation>eine Modulo-Achse hat keine Steigung, die sich entfernen ließe: sie endet, wo sie beginnt</translation>
    </message>
    <message>
        <source>there are values at {count} targets; four are needed to leave one out</source>
        <translation>an {count} Zielpositionen gibt es Werte; um eine wegzulassen, sind vier nötig</translation>
    </message>
    <message>
        <source>a gain is above 0 and at most 2; it is usually 1</source>
        <translation>ein Faktor liegt über 0 und ist höchstens 2; üblich ist 1</translation>
    </message>
    <message>
        <source>{name} has no table whose target is that of the column {column}; state the targets of its tables, or measure without a table</source>
        <translation>{name} hat keine Tabelle, deren Zielachse die der Spalte {column} ist; geben Sie die Zielachsen ihrer Tabellen an, oder messen Sie ohne Tabelle</translation>
    </message>
    <message>
        <source>all points have the same position along {axis}</source>
        <translation>alle Punkte haben dieselbe Position entlang {axis}</translation>
    </message>
    <message>
        <source>a grid has at least 2 points along {axis}</source>
        <translation>ein Gitter hat entlang {axis} mindestens 2 Punkte</translation>
    </message>
    <message>
        <source>the distance along {axis} is too small</source>
        <translation>der Abstand entlang {axis} ist zu klein</translation>
    </message>
    <message>
        <source>the grid needs one number, or one for each of the {count} axes</source>
        <translation>das Gitter braucht eine Zahl, oder eine für jede der {count} Achsen</translation>
    </message>
    <message>
        <source>points are fitted on the grid itself, as the drive interpolates it; leave out --method and --period</source>
        <translation>Punkte werden auf dem Gitter selbst angepasst, so wie der Antrieb interpoliert; lassen Sie --method und --period weg</translation>
    </message>
    <message>
        <source>a track is fitted on the grid itself, or by --method smooth, which known periods (--period) need; leave other methods out</source>
        <translation>eine Bahn wird auf dem Gitter selbst angepasst oder mit --method smooth, das bekannte Perioden (--period) brauchen; lassen Sie andere Verfahren weg</translation>
    </message>
    <message>
        <source>--robust is for a fit on the grid itself; leave out --robust or --method smooth</source>
        <translation>--robust ist für die Anpassung auf dem Gitter selbst; lassen Sie --robust oder --method smooth weg</translation>
    </message>
    <message>
        <source>the figures of the standard need targets; leave --tolerance out</source>
        <translation>die Kennwerte der Norm brauchen Zielpositionen; lassen Sie --tolerance weg</translation>
    </message>
    <message>
        <source>a home position is that of one axis measured over targets; take --zero first, mean, keep or a position</source>
        <translation>ein Referenzpunkt gehört zu einer Achse, die über Zielpositionen gemessen wurde; nehmen Sie --zero first, mean, keep oder eine Position</translation>
    </message>
    <message>
        <source>--remove is for points of two or three axes; a track has one</source>
        <translation>--remove ist für Punkte von zwei oder drei Achsen; eine Bahn hat eine</translation>
    </message>
    <message>
        <source>points have no direction; leave --direction out</source>
        <translation>Punkte haben keine Richtung; lassen Sie --direction weg</translation>
    </message>
    <message>
        <source>the zero needs {count} numbers, one for each axis</source>
        <translation>die Nullstelle braucht {count} Zahlen, eine für jede Achse</translation>
    </message>
    <message>
        <source>--remove names an axis that the points do not have</source>
        <translation>--remove nennt eine Achse, die die Punkte nicht haben</translation>
    </message>
    <message>
        <source>the position of the zero is outside the grid</source>
        <translation>die Position der Nullstelle liegt außerhalb des Gitters</translation>
    </message>
    <message>
        <source>there are no values in this direction</source>
        <translation>in dieser Richtung gibt es keine Werte</translation>
    </message>
    <message>
        <source>--remove, --robust and --fill are for points of two or three axes and for tracks; this measurement has targets along one axis</source>
        <translation>--remove, --robust und --fill sind für Punkte von zwei oder drei Achsen und für Bahnen; diese Messung hat Zielpositionen entlang einer Achse</translation>
    </message>
    <message>
        <source>the measurement is along one axis: give one number for its grid and zero</source>
        <translation>die Messung geht entlang einer Achse: geben Sie für Gitter und Nullstelle eine Zahl an</translation>
    </message>
    <message>
        <source>a smoothness is for the method smooth (--method smooth); the others go through every mean</source>
        <translation>eine Glättung ist für das Verfahren smooth (--method smooth); die anderen gehen durch jeden Mittelwert</translation>
    </message>
    <message>
        <source>the position {position} of the zero is outside the targets, which go from {from} to {to}</source>
        <translation>die Position {position} der Nullstelle liegt außerhalb der Zielpositionen, die von {from} bis {to} gehen</translation>
    </message>
    <message>
        <source>a program for {dialect} cannot move an axis &quot;{axis}&quot;; name one of X, Y, Z, A, B, C, U, V, W (--axis)</source>
        <translation>Ein Programm für {dialect} kann keine Achse &quot;{axis}&quot; bewegen; nennen Sie X, Y, Z, A, B, C, U, V oder W (--axis)</translation>
    </message>
    <message>
        <source>a target must lie within {limit} of zero</source>
        <translation>Eine Zielposition darf höchstens {limit} von null entfernt sein</translation>
    </message>
    <message>
        <source>{position} has more than the three decimals that a program prints; choose an end with fewer</source>
        <translation>{position} hat mehr als die drei Nachkommastellen, die ein Programm schreibt; wählen Sie ein Ende mit weniger Stellen</translation>
    </message>
    <message>
        <source>the last target ({to}) must be above the first ({from}); exchange the two, or choose other ends</source>
        <translation>Die letzte Zielposition ({to}) muss über der ersten ({from}) liegen; vertauschen Sie die beiden, oder wählen Sie andere Enden</translation>
    </message>
    <message>
        <source>a period is above 0; leave it out if none is known</source>
        <translation>Eine Periode ist größer als 0; lassen Sie sie weg, wenn keine bekannt ist</translation>
    </message>
    <message>
        <source>the overrun must be above 0: without it the first target of a run would not be approached in the direction of the run</source>
        <translation>Der Überlauf muss größer als 0 sein: Ohne ihn würde die erste Zielposition eines Durchlaufs nicht in dessen Richtung angefahren</translation>
    </message>
    <message>
        <source>the overrun has more than three decimals; round it</source>
        <translation>Der Überlauf hat mehr als drei Nachkommastellen; runden Sie ihn</translation>
    </message>
    <message>
        <source>the feed must be above 0 and at most {most}</source>
        <translation>Der Vorschub muss größer als 0 und höchstens {most} sein</translation>
    </message>
    <message>
        <source>the dwell must be above 0 s and at most {most}: the axis stands still while it is measured</source>
        <translation>Die Verweilzeit muss größer als 0 s und höchstens {most} sein: Die Achse steht still, während gemessen wird</translation>
    </message>
    <message>
        <source>at least one cycle is needed</source>
        <translation>Mindestens ein Zyklus ist nötig</translation>
    </message>
    <message>
        <source>give the number of targets or their spacing, one of the two</source>
        <translation>Geben Sie die Zahl der Zielpositionen oder ihren Abstand an, eines von beiden</translation>
    </message>
    <message>
        <source>the spacing must be above 0 and at most the distance of the ends, {range}</source>
        <translation>Der Abstand muss größer als 0 und höchstens der Abstand der Enden sein, {range}</translation>
    </message>
    <message>
        <source>a plan has 2 to {most} targets, not {count}</source>
        <translation>Ein Plan hat 2 bis {most} Zielpositionen, nicht {count}</translation>
    </message>
    <message>
        <source>{count} targets would be closer than {least}, which three decimals cannot keep uneven; choose fewer</source>
        <translation>{count} Zielpositionen lägen enger als {least}; mit drei Nachkommastellen bleiben sie dann nicht ungleichmäßig. Wählen Sie weniger</translation>
    </message>
    <message>
        <source>the plan would have more than {most} steps; choose fewer targets or cycles</source>
        <translation>Der Plan hätte mehr als {most} Schritte; wählen Sie weniger Zielpositionen oder Zyklen</translation>
    </message>
    <message>
        <source>there is no step in it</source>
        <translation>Sie enthält keinen Schritt</translation>
    </message>
    <message>
        <source>a plan as axiscomp targets writes it</source>
        <translation>ein Plan, wie ihn axiscomp targets schreibt</translation>
    </message>
    <message>
        <source>{found}; expected: {expected}</source>
        <translation>{found}; erwartet: {expected}</translation>
    </message>
    <message>
        <source>line {line}: {found}; expected: {expected}</source>
        <translation>Zeile {line}: {found}; erwartet: {expected}</translation>
    </message>
    <message>
        <source>version 1; a newer version of this program may have written it</source>
        <translation>Version 1; vielleicht hat eine neuere Version dieses Programms sie geschrieben</translation>
    </message>
    <message>
        <source>a number above 0 with its unit</source>
        <translation>eine Zahl größer als 0 mit ihrer Einheit</translation>
    </message>
    <message>
        <source>the header {header}</source>
        <translation>die Kopfzeile {header}</translation>
    </message>
    <message>
        <source>five cells, as the header has</source>
        <translation>fünf Zellen, wie in der Kopfzeile</translation>
    </message>
    <message>
        <source>at most {count} steps</source>
        <translation>höchstens {count} Schritte</translation>
    </message>
    <message>
        <source>step {step}</source>
        <translation>Schritt {step}</translation>
    </message>
    <message>
        <source>the number of a run, from 1</source>
        <translation>die Nummer eines Durchlaufs, ab 1</translation>
    </message>
    <message>
        <source>the direction + or -</source>
        <translation>die Richtung + oder -</translation>
    </message>
    <message>
        <source>a position below the target, since the axis moves up</source>
        <translation>eine Position unter der Zielposition, da die Achse aufwärts fährt</translation>
    </message>
    <message>
        <source>a position above the target, since the axis moves down</source>
        <translation>eine Position über der Zielposition, da die Achse abwärts fährt</translation>
    </message>
    <message>
        <source>each target once in a run; it has this one already</source>
        <translation>jede Zielposition einmal in einem Durchlauf; diese hat er schon</translation>
    </message>
    <message>
        <source>the plan is for axis {axis}; the machine has: {known}</source>
        <translation>Der Plan ist für Achse {axis}; die Maschine hat: {known}</translation>
    </message>
    <message>
        <source>the plan and axis {axis} of the machine differ: one is in mm, the other in deg</source>
        <translation>Der Plan und Achse {axis} der Maschine passen nicht zusammen: Das eine ist in mm, das andere in Grad</translation>
    </message>
    <message>
        <source>the plan needs a feed and a dwell above 0: lines such as // feed: 1000 mm/min and // dwell: 5 s</source>
        <translation>Der Plan braucht einen Vorschub und eine Verweilzeit größer als 0: Zeilen wie // feed: 1000 mm/min und // dwell: 5 s</translation>
    </message>
    <message>
        <source>step {step} of the plan goes to {place}, more than a tenth beyond the travel of axis {axis}, {low} to {high}</source>
        <translation>Schritt {step} des Plans führt nach {place}, mehr als ein Zehntel über den Verfahrweg von Achse {axis} hinaus, {low} bis {high}</translation>
    </message>
    <message>
        <source>a program needs a machine that plays it (--machine)</source>
        <translation>Ein Programm braucht eine Maschine, die es abspielt (--machine)</translation>
    </message>
    <message>
        <source>a machine has at least one axis</source>
        <translation>Eine Maschine hat mindestens eine Achse</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; is &quot;{nearest}&quot; meant?</source>
        <translation>&quot;{name}&quot; ist hier nicht bekannt; ist &quot;{nearest}&quot; gemeint?</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; there is: {known}</source>
        <translation>&quot;{name}&quot; ist hier nicht bekannt; es gibt: {known}</translation>
    </message>
    <message>
        <source>a number from {least} to {most} is expected, not {found}</source>
        <translation>Erwartet wird eine Zahl von {least} bis {most}, nicht {found}</translation>
    </message>
    <message>
        <source>a number above 0, at most {most}, is expected, not {found}</source>
        <translation>Erwartet wird eine Zahl größer als 0 und höchstens {most}, nicht {found}</translation>
    </message>
    <message>
        <source>there are more than {most} waves</source>
        <translation>Es sind mehr als {most} Wellen</translation>
    </message>
    <message>
        <source>the travel has more than {most} knots at this distance</source>
        <translation>Der Verfahrweg hat bei diesem Abstand mehr als {most} Stützstellen</translation>
    </message>
    <message>
        <source>two numbers are expected: the ends of the travel</source>
        <translation>Erwartet werden zwei Zahlen: die Enden des Verfahrwegs</translation>
    </message>
    <message>
        <source>the first end must be below the second</source>
        <translation>Das erste Ende muss unter dem zweiten liegen</translation>
    </message>
    <message>
        <source>mm or deg is expected</source>
        <translation>Erwartet wird mm oder deg</translation>
    </message>
    <message>
        <source>an object with 1 to {most} axes is expected</source>
        <translation>Erwartet wird ein Objekt mit 1 bis {most} Achsen</translation>
    </message>
    <message>
        <source>the name of an axis has 1 to {most} characters</source>
        <translation>Der Name einer Achse hat 1 bis {most} Zeichen</translation>
    </message>
    <message>
        <source>there is no axis &quot;{name}&quot;; there is: {known}</source>
        <translation>Es gibt keine Achse &quot;{name}&quot;; es gibt: {known}</translation>
    </message>
    <message>
        <source>an axis&apos;s own terms stand with the axis; here are those of others</source>
        <translation>Die eigenen Anteile einer Achse stehen bei der Achse; hier stehen die der anderen</translation>
    </message>
    <message>
        <source>one of these units is expected: {known}</source>
        <translation>Erwartet wird eine dieser Einheiten: {known}</translation>
    </message>
    <message>
        <source>1 or -1 is expected</source>
        <translation>Erwartet wird 1 oder -1</translation>
    </message>
    <message>
        <source>there are more than {most} gross errors</source>
        <translation>Es sind mehr als {most} grobe Fehler</translation>
    </message>
    <message>
        <source>{file} is not a valid record: {reason}</source>
        <translation>{file} ist kein gültiges Protokoll: {reason}</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes at least {sizes} points, more than allowed; allow more points or a larger distance</source>
        <translation>ein Abstand von {distance} von der Kurve braucht mindestens {sizes} Punkte, mehr als erlaubt; mehr Punkte oder einen größeren Abstand erlauben</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}, which at {speed} is a step of the velocity of {step}</source>
        <translation>entlang {axis}, {points} Punkte: höchstens {distance} von der Kurve; an einem Punkt ändert sich die Steigung um bis zu {slope}, bei {speed} ein Sprung der Geschwindigkeit von {step}</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}</source>
        <translation>entlang {axis}, {points} Punkte: höchstens {distance} von der Kurve; an einem Punkt ändert sich die Steigung um bis zu {slope}</translation>
    </message>
    <message>
        <source>smoothing needs at least {fewest} positions along {axis}, which has {count}; take the method spline or cubic</source>
        <translation>Glätten braucht mindestens {fewest} Positionen entlang {axis}, und es sind {count}; das Verfahren spline oder cubic nehmen</translation>
    </message>
    <message>
        <source>a SHA-256 of 64 hexadecimal digits is expected</source>
        <translation>erwartet wird ein SHA-256 aus 64 hexadezimalen Ziffern</translation>
    </message>
    <message>
        <source>at least one file is expected</source>
        <translation>erwartet wird mindestens eine Datei</translation>
    </message>
    <message>
        <source>what is left out is expected, such as down:1:1, run:up:3 or target:7</source>
        <translation>erwartet wird, was weggelassen wird, etwa down:1:1, run:up:3 oder target:7</translation>
    </message>
    <message>
        <source>the record has version {found}, and this program reads version {known} at most; open it with a newer version of the program</source>
        <translation>das Protokoll hat Version {found}, und dieses Programm liest höchstens Version {known}; mit einer neueren Version des Programms öffnen</translation>
    </message>
    <message>
        <source>the second measurement was made with the compensation off; activate the table {crc} and measure again</source>
        <translation>die zweite Messung wurde ohne Kompensation gemacht; die Tabelle {crc} einschalten und noch einmal messen</translation>
    </message>
    <message>
        <source>the second measurement was made with the table {found} active, and the record has the table {crc}; activate that one and measure again, or take the record of {found}</source>
        <translation>bei der zweiten Messung war die Tabelle {found} aktiv, und das Protokoll hat die Tabelle {crc}; diese einschalten und noch einmal messen, oder das Protokoll von {found} nehmen</translation>
    </message>
    <message>
        <source>the second measurement does not say which table was active while it was made; if it was the table {crc}, say it with --measured-with on</source>
        <translation>die zweite Messung sagt nicht, welche Tabelle dabei aktiv war; war es die Tabelle {crc}, --measured-with on angeben</translation>
    </message>
    <message>
        <source>only measurements of runs over targets are compared</source>
        <translation>verglichen werden nur Messungen mit Durchläufen über Zielpositionen</translation>
    </message>
    <message>
        <source>one measurement is of lengths and the other of angles; they are not of the same axis</source>
        <translation>eine Messung hat Längen und die andere Winkel; sie sind nicht von derselben Achse</translation>
    </message>
    <message>
        <source>this is no figure of ISO 230-2, such as A or EUp</source>
        <translation>das ist kein Kennwert der ISO 230-2, wie A oder EUp</translation>
    </message>
    <message>
        <source>a distance above 0 is expected</source>
        <translation>erwartet wird ein Abstand über 0</translation>
    </message>
    <message>
        <source>numbers of the table&apos;s points are expected, ascending from 0</source>
        <translation>erwartet werden Nummern von Punkten der Tabelle, aufsteigend ab 0</translation>
    </message>
    <message>
        <source>a table has 1 to 3 axes</source>
        <translation>eine Tabelle hat 1 bis 3 Achsen</translation>
    </message>
    <message>
        <source>{count} values are here, and the grid has {expected} points</source>
        <translation>hier stehen {count} Werte, und das Gitter hat {expected} Punkte</translation>
    </message>
    <message>
        <source>this list has {count} elements, and the others have {expected}</source>
        <translation>diese Liste hat {count} Elemente, und die anderen haben {expected}</translation>
    </message>
    <message>
        <source>the values have the CRC-32 {found}: they were changed, or the file is damaged</source>
        <translation>die Werte haben die CRC-32 {found}: sie wurden geändert, oder die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>whole numbers from {least} to {most} are expected, not {found}</source>
        <translation>erwartet werden ganze Zahlen von {least} bis {most}, nicht {found}</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is neither up nor down</source>
        <translation>„{found}“ ist weder up noch down</translation>
    </message>
    <message>
        <source>there are values without targets</source>
        <translation>es gibt Werte ohne Zielpositionen</translation>
    </message>
    <message>
        <source>{count} lists are here, and there are {expected} names</source>
        <translation>hier stehen {count} Listen, und es gibt {expected} Namen</translation>
    </message>
    <message>
        <source>points have 2 or 3 axes</source>
        <translation>Punkte haben 2 oder 3 Achsen</translation>
    </message>
    <message>
        <source>targets are expected to ascend</source>
        <translation>erwartet werden aufsteigende Zielpositionen</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is none of: {known}</source>
        <translation>„{found}“ ist keines von: {known}</translation>
    </message>
    <message>
        <source>the compensation changed in mid-measurement, from {before} to {now}; what was taken belongs to {before}: begin a new file</source>
        <translation>Die Kompensation hat sich während der Messung von {before} zu {now} geändert; die bisherigen Werte gehören zu {before}: Beginnen Sie eine neue Datei</translation>
    </message>
    <message>
        <source>the axis stands at {position}; step {step} at {target} is due</source>
        <translation>Die Achse steht bei {position}; fällig ist Schritt {step} bei {target}</translation>
    </message>
    <message>
        <source>{problem}; this is the target of step {other}: move the axis back</source>
        <translation>{problem}; dies ist die Zielposition von Schritt {other}: Fahren Sie die Achse zurück</translation>
    </message>
    <message>
        <source>how the axis came to step {step} is not known, as nothing could be read for {time}; go to {approach} and come back</source>
        <translation>Wie die Achse zu Schritt {step} kam, ist nicht bekannt, da {time} lang nichts gelesen werden konnte; fahren Sie nach {approach} und zurück</translation>
    </message>
    <message>
        <source>the axis came only {way} in the direction of step {step}, less than the overrun of {overrun}; go to {approach} and come back</source>
        <translation>Die Achse kam nur {way} weit in der Richtung von Schritt {step}, weniger als der Überlauf von {overrun}; fahren Sie nach {approach} und zurück</translation>
    </message>
    <message>
        <source>step {step} is approached upwards, and the axis did not come from below; go to {approach} and come back</source>
        <translation>Schritt {step} wird aufwärts angefahren, und die Achse kam nicht von unten; fahren Sie nach {approach} und zurück</translation>
    </message>
    <message>
        <source>step {step} is approached downwards, and the axis did not come from above; go to {approach} and come back</source>
        <translation>Schritt {step} wird abwärts angefahren, und die Achse kam nicht von oben; fahren Sie nach {approach} und zurück</translation>
    </message>
    <message>
        <source>the instrument gives no position</source>
        <translation>Das Messgerät liefert keine Position</translation>
    </message>
    <message>
        <source>the readings of the instrument differ by {spread}, more than the window of {window}; they are taken again</source>
        <translation>Die Ablesungen des Messgeräts unterscheiden sich um {spread}, mehr als das Fenster von {window}; sie werden wiederholt</translation>
    </message>
    <message>
        <source>it is not an ordinary file</source>
        <translation>Sie ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>another program is writing measured values to it</source>
        <translation>Ein anderes Programm schreibt gerade Messwerte hinein</translation>
    </message>
    <message>
        <source>it holds something else than captured values; name a new file</source>
        <translation>Sie enthält etwas anderes als aufgenommene Messwerte; nennen Sie eine neue Datei</translation>
    </message>
    <message>
        <source>line {line} has {found} where {expected} is expected; name a new file</source>
        <translation>In Zeile {line} steht {found}, erwartet wird {expected}; nennen Sie eine neue Datei</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>das Ende</translation>
    </message>
    <message>
        <source>step {step} of the plan, {begin}...</source>
        <translation>Schritt {step} des Plans, {begin}...</translation>
    </message>
    <message>
        <source>there is no font to draw a PDF with: install one, such as fonts-dejavu-core, or write the report as HTML</source>
        <translation>es gibt keine Schrift, mit der sich ein PDF zeichnen lässt: Installieren Sie eine, etwa fonts-dejavu-core, oder schreiben Sie den Bericht als HTML</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid machine file: {count} problems</source>
        <comment>{file} is not a valid machine file: one problem</comment>
        <translation>
            <numerusform>{file} ist keine gültige Maschinendatei: ein Problem</numerusform>
            <numerusform>{file} ist keine gültige Maschinendatei: {count} Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>the old state</source>
        <translation>der alte Zustand</translation>
    </message>
    <message>
        <source>what it is writing at this moment</source>
        <translation>was gerade geschrieben wird</translation>
    </message>
    <message>
        <source>values of the tolerance</source>
        <translation>Werte der Toleranz</translation>
    </message>
    <message>
        <source>{file} has several tables; name one of them with column: {known}</source>
        <translation>{file} hat mehrere Tabellen; nennen Sie eine davon mit column: {known}</translation>
    </message>
    <message>
        <source>axis {index} of {drive} (serial number {serial})</source>
        <translation>Achse {index} von {drive} (Seriennummer {serial})</translation>
    </message>
    <message>
        <source>axis {index} ({name}) of {drive} (serial number {serial})</source>
        <translation>Achse {index} ({name}) von {drive} (Seriennummer {serial})</translation>
    </message>
    <message>
        <source>the record is of {recorded}, and this is {found}; begin a record for each axis</source>
        <translation>das Protokoll gehört zu {recorded}, und dies ist {found}; für jede Achse ein eigenes beginnen</translation>
    </message>
    <message>
        <source>the record does not say that its table was written: `axiscomp write --record` writes it and notes that</source>
        <translation>das Protokoll sagt nicht, dass seine Tabelle geschrieben wurde: „axiscomp write --record“ schreibt sie und hält das fest</translation>
    </message>
    <message>
        <source>the axis has the table {found}, and that of the record is {recorded}: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>die Achse hat die Tabelle {found}, und die des Protokolls ist {recorded}: die Tabelle des Protokolls noch einmal schreiben („axiscomp write --record“) oder das Protokoll weglassen</translation>
    </message>
    <message>
        <source>the register {path} is of type {type}, which is no position</source>
        <translation>das Register {path} hat den Typ {type} und ist keine Position</translation>
    </message>
    <message>
        <source>{path} follows the encoder of the axis itself: name the register of an instrument</source>
        <translation>{path} folgt dem Geber der Achse selbst: nennen Sie das Register eines Messgeräts</translation>
    </message>
    <message>
        <source>since the value before, the axis has moved by {way}, and the instrument says {measured}</source>
        <translation>seit dem Wert davor hat sich die Achse um {way} bewegt, und das Messgerät meldet {measured}</translation>
    </message>
    <message>
        <source>the instrument says nothing: look whether it sends, and whether its lines end</source>
        <translation>das Messgerät meldet nichts: sehen Sie nach, ob es sendet und ob seine Zeilen enden</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder, and until now it was {seen} at most: type it once more if it is right, or another number</source>
        <translation>{position} ist {difference} vom Geber entfernt, und bisher waren es höchstens {seen}: geben Sie es noch einmal ein, wenn es stimmt, oder eine andere Zahl</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder: type it once more if it is right, or another number</source>
        <translation>{position} ist {difference} vom Geber entfernt: geben Sie es noch einmal ein, wenn es stimmt, oder eine andere Zahl</translation>
    </message>
    <message>
        <source>the position of the instrument is asked for</source>
        <translation>die Position des Messgeräts wird erfragt</translation>
    </message>
    <message>
        <source>it is one of the files of this measurement; choose another name</source>
        <translation>sie ist eine der Dateien dieser Messung; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the axis would move from {lowest} to {highest}, and its travel is {low} to {high}: choose other ends, or a smaller overrun</source>
        <translation>die Achse führe von {lowest} bis {highest}, und ihr Verfahrweg ist {low} bis {high}: andere Enden oder einen kleineren Überlauf wählen</translation>
    </message>
    <message>
        <source>the plan is for axis {planned}, and this is axis {axis}: choose the other axis, or make a plan for this one</source>
        <translation>der Messplan ist für Achse {planned}, und dies ist Achse {axis}: die andere Achse wählen oder einen Plan für diese machen</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is neither on nor off (the drive says {state}): activate or deactivate it first</source>
        <translation>die Kompensation der Achse {axis} ist weder ein- noch ausgeschaltet (der Antrieb sagt {state}): sie zuerst aktivieren oder deaktivieren</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is on, and the drive does not say with which table: deactivate it first</source>
        <translation>die Kompensation der Achse {axis} ist eingeschaltet, und der Antrieb sagt nicht, mit welcher Tabelle: sie zuerst deaktivieren</translation>
    </message>
    <message>
        <source>the instrument is in {unit}, which cannot be converted to {planned}, the unit of the plan: state the unit of the instrument</source>
        <translation>das Messgerät ist in {unit}, was sich nicht in {planned}, die Einheit des Messplans, umrechnen lässt: die Einheit des Messgeräts angeben</translation>
    </message>
    <message>
        <source>no position is asked for at the moment: wait until the axis stands at its target</source>
        <translation>im Augenblick wird nach keiner Position gefragt: warten, bis die Achse an ihrer Zielposition steht</translation>
    </message>
    <message>
        <source>{found}: it counts the other way; begin a new file with the reference inverted</source>
        <translation>{found}: es zählt andersherum; eine neue Datei mit umgekehrter Referenz beginnen</translation>
    </message>
    <message>
        <source>{found}: its unit or factor is another one, or its zero was set anew, or its beam was interrupted; put that right, or begin a new file with the right unit</source>
        <translation>{found}: seine Einheit oder sein Faktor ist anders, oder sein Nullpunkt wurde neu gesetzt, oder sein Strahl war unterbrochen; das in Ordnung bringen oder eine neue Datei mit der richtigen Einheit beginnen</translation>
    </message>
    <message>
        <source>the instrument says {line}, where a number is expected; a pattern says where it is</source>
        <translation>das Messgerät sagt {line}, wo eine Zahl erwartet wird; ein Muster sagt, wo sie steht</translation>
    </message>
    <message>
        <source>the instrument says {line}: its number has a comma; set it to a decimal point, or say what the number is with a pattern</source>
        <translation>das Messgerät sagt {line}: seine Zahl hat ein Komma; es auf Dezimalpunkt stellen oder mit einem Muster sagen, was die Zahl ist</translation>
    </message>
    <message>
        <source>the instrument says {line} without a unit: state the unit, such as mm</source>
        <translation>das Messgerät sagt {line} ohne Einheit: die Einheit angeben, etwa mm</translation>
    </message>
    <message>
        <source>the instrument says {line}, in another unit than {unit}: set the instrument, or begin a new file with the right unit</source>
        <translation>das Messgerät sagt {line}, in einer anderen Einheit als {unit}: das Messgerät umstellen oder eine neue Datei mit der richtigen Einheit beginnen</translation>
    </message>
    <message>
        <source>the drive profile does not say which register is the encoder of the axis: name it</source>
        <translation>das Profil des Antriebs sagt nicht, welches Register der Geber der Achse ist: es nennen</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position before the compensation, which is --lookup-at encoder</source>
        <translation>die Achse schlägt in ihrer Tabelle bei {source} nach, einer Position vor der Kompensation, das heißt --lookup-at encoder</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position after the compensation, which is --lookup-at set</source>
        <translation>die Achse schlägt in ihrer Tabelle bei {source} nach, einer Position nach der Kompensation, das heißt --lookup-at set</translation>
    </message>
    <message>
        <source>there are values at {count} points of the grid&apos;s range; {fewest} are needed to choose the smoothness, so give it (--smoothness)</source>
        <translation>im Bereich des Gitters gibt es Werte an {count} Punkten; um die Glätte zu wählen, sind {fewest} nötig, geben Sie sie also an (--smoothness)</translation>
    </message>
    <message>
        <source>the measurement does not say whether a compensation was active while it was made: say that it was off, that it was on, or which table was active (--measured-with off, --measured-with on, or --measured-with and the file of the table)</source>
        <translation>die Messung sagt nicht, ob während ihr eine Kompensation aktiv war: sagen Sie, dass sie aus war, dass sie an war, oder welche Tabelle aktiv war (--measured-with off, --measured-with on oder --measured-with und die Datei der Tabelle)</translation>
    </message>
    <message>
        <source>the measurement says that it was made with {recorded}, not with {stated}; say nothing else (--measured-with), or take the table that was active</source>
        <translation>die Messung sagt, dass sie mit {recorded} gemacht wurde, nicht mit {stated}; sagen Sie nichts anderes (--measured-with), oder nehmen Sie die Tabelle, die aktiv war</translation>
    </message>
    <message>
        <source>these are residuals of the table {crc}, which was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>das sind Restabweichungen der Tabelle {crc}, die während der Messung aktiv war: rechnen Sie sie in diese Tabelle ein, aus ihrer Datei oder vom Antrieb (--onto und die Datei oder --onto drive)</translation>
    </message>
    <message>
        <source>these are residuals of a table that was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>das sind Restabweichungen einer Tabelle, die während der Messung aktiv war: rechnen Sie sie in diese Tabelle ein, aus ihrer Datei oder vom Antrieb (--onto und die Datei oder --onto drive)</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, which is not {name} ({known}), nor any other table known; give its file (--measured-with), or merge onto it</source>
        <translation>während der Messung war die Tabelle {crc} aktiv; das ist weder {name} ({known}) noch eine andere bekannte Tabelle; geben Sie ihre Datei an (--measured-with), oder rechnen Sie in sie ein</translation>
    </message>
    <message>
        <source>it was measured with the compensation off: the values are the whole error, and must not be added to {name}; merge them onto nothing (leave out --onto), or measure with that table active</source>
        <translation>während der Messung war die Kompensation aus: die Werte sind der ganze Fehler und dürfen nicht zu {name} addiert werden; rechnen Sie sie in keine Tabelle ein (--onto weglassen), oder messen Sie mit dieser Tabelle aktiv</translation>
    </message>
    <message>
        <source>at which position the drive looks the table up decides where its values belong: choose the encoder, for a position before the compensation, or the set position, for one after it (--lookup-at encoder or --lookup-at set)</source>
        <translation>an welcher Position der Antrieb in der Tabelle nachschlägt, entscheidet, wohin ihre Werte gehören: wählen Sie den Geber, für eine Position vor der Kompensation, oder die Sollposition, für eine danach (--lookup-at encoder oder --lookup-at set)</translation>
    </message>
    <message>
        <source>how the artefact lay is found from the deviations along all of its axes, but there is no column for {axis}, such as d{axis}; take out nothing (--remove)</source>
        <translation>wie der Prüfkörper lag, ergibt sich aus den Abweichungen entlang aller seiner Achsen, aber für {axis} fehlt eine Spalte wie d{axis}; nehmen Sie nichts heraus (--remove)</translation>
    </message>
    <message>
        <source>the positions along {axis} are no even grid; say the grid of the table: its points, or their distance (--points or --distance)</source>
        <translation>die Positionen entlang {axis} sind kein gleichmäßiges Gitter; geben Sie das Gitter der Tabelle an: seine Punkte oder ihren Abstand (--points oder --distance)</translation>
    </message>
    <message>
        <source>a table over temperature is made of runs with targets along one axis</source>
        <translation>eine Tabelle über der Temperatur entsteht aus Durchläufen mit Zielpositionen entlang einer Achse</translation>
    </message>
    <message>
        <source>the home position of the axis is not known: give it (--home), or the position of the zero (--zero)</source>
        <translation>der Referenzpunkt der Achse ist nicht bekannt: geben Sie ihn an (--home), oder die Position der Nullstelle (--zero)</translation>
    </message>
    <message>
        <source>the home position {home} is outside the targets, so that the error there is not known; take the first target for the zero or another position (--zero)</source>
        <translation>der Referenzpunkt {home} liegt außerhalb der Zielpositionen, der Fehler dort ist also nicht bekannt; nehmen Sie für die Nullstelle die erste Zielposition oder eine andere Position (--zero)</translation>
    </message>
    <message>
        <source>the targets are not evenly spaced; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>die Zielpositionen haben keine gleichmäßigen Abstände; geben Sie das Gitter der Tabelle an: seine Punkte, ihren Abstand, oder wie weit sie von der Kurve abweichen darf (--points, --distance oder --within)</translation>
    </message>
    <message>
        <source>the thermal states span {span}, less than five times the {scatter} by which the temperature varies within them: let the machine settle before each run</source>
        <translation>die thermischen Zustände umfassen {span}, weniger als das Fünffache der {scatter}, um die die Temperatur in ihnen schwankt: lassen Sie die Maschine vor jedem Durchlauf zur Ruhe kommen</translation>
    </message>
    <message>
        <source>at {temperature} it was measured from {from} to {to}, at {other} from {otherFrom} to {otherTo}: measure the same range in each thermal state</source>
        <translation>bei {temperature} wurde von {from} bis {to} gemessen, bei {other} von {otherFrom} bis {otherTo}: messen Sie in jedem thermischen Zustand denselben Bereich</translation>
    </message>
    <message numerus="yes">
        <source>{count} values have no temperature; a table over temperature needs that of each (the column temperature)</source>
        <comment>1 value has no temperature; a table over temperature needs that of each (the column temperature)</comment>
        <translation>
            <numerusform>1 Wert hat keine Temperatur; eine Tabelle über der Temperatur braucht die jedes Werts (die Spalte temperature)</numerusform>
            <numerusform>{count} Werte haben keine Temperatur; eine Tabelle über der Temperatur braucht die jedes Werts (die Spalte temperature)</numerusform>
        </translation>
    </message>
    <message>
        <source>residuals are not merged over temperature: measure with the compensation off</source>
        <translation>Restabweichungen werden über der Temperatur nicht eingerechnet: messen Sie mit ausgeschalteter Kompensation</translation>
    </message>
    <message>
        <source>a table over temperature has two dimensions: give at most two numbers for its grid</source>
        <translation>eine Tabelle über der Temperatur hat zwei Dimensionen: geben Sie für ihr Gitter höchstens zwei Zahlen an</translation>
    </message>
    <message>
        <source>the targets differ from one thermal state to the other, so that they give no grid together; say the grid of the table with --points or --distance</source>
        <translation>die Zielpositionen unterscheiden sich von einem thermischen Zustand zum anderen, sodass sie zusammen kein Gitter ergeben; geben Sie das Gitter der Tabelle mit --points oder --distance an</translation>
    </message>
    <message>
        <source>the grid has {count} points, and a table holds {most}; take fewer</source>
        <translation>das Gitter hat {count} Punkte, und eine Tabelle fasst {most}; nehmen Sie weniger</translation>
    </message>
    <message>
        <source>name the axis as the drive or the control names it, such as X</source>
        <translation>die Achse nennen, wie der Antrieb oder die Steuerung sie nennt, etwa X</translation>
    </message>
    <message>
        <source>the pattern {pattern} is no regular expression: {problem} at character {place}</source>
        <translation>das Muster {pattern} ist kein regulärer Ausdruck: {problem} beim Zeichen {place}</translation>
    </message>
    <message>
        <source>the request {text}: behind a backslash r, n, t or another backslash is expected</source>
        <translation>die Anfrage {text}: hinter einem Rückstrich wird r, n, t oder noch einer erwartet</translation>
    </message>
    <message>
        <source>the connection was removed</source>
        <translation>die Verbindung wurde entfernt</translation>
    </message>
    <message>
        <source>its name is one of a program for a control, and a plan in it would mislead the control; choose a name that ends in .csv</source>
        <translation>ihr Name ist der eines Programms für eine Steuerung, und ein Messplan darin führte sie in die Irre; einen Namen wählen, der auf .csv endet</translation>
    </message>
    <message>
        <source>choose the file of the table that was active</source>
        <translation>wählen Sie die Datei der Tabelle, die aktiv war</translation>
    </message>
    <message>
        <source>its content cannot be used</source>
        <translation>ihr Inhalt lässt sich nicht verwenden</translation>
    </message>
    <message>
        <source>{file} cannot be used as the table: {reason}</source>
        <translation>{file} lässt sich nicht als Tabelle verwenden: {reason}</translation>
    </message>
    <message>
        <source>there is no axis whose table the residuals could be merged onto; choose one, or take the file of the table</source>
        <translation>es gibt keine Achse, in deren Tabelle die Restabweichungen eingerechnet werden könnten; wählen Sie eine, oder nehmen Sie die Datei der Tabelle</translation>
    </message>
    <message>
        <source>the table of the axis is still being read from the drive</source>
        <translation>die Tabelle der Achse wird noch vom Antrieb gelesen</translation>
    </message>
    <message>
        <source>a report is PDF or HTML; choose a name that ends in .pdf or .html</source>
        <translation>ein Bericht ist PDF oder HTML; wählen Sie einen Namen, der auf .pdf oder .html endet</translation>
    </message>
    <message>
        <source>all runs were measured in one thermal state; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>alle Durchläufe wurden in einem thermischen Zustand gemessen; eine Tabelle über der Temperatur braucht mindestens zwei, die {least} auseinander liegen (Durchläufe innerhalb von {gap} sind ein Zustand)</translation>
    </message>
    <message>
        <source>the runs were measured in {count} thermal states that span {span}; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>die Durchläufe wurden in {count} thermischen Zuständen gemessen, die {span} umfassen; eine Tabelle über der Temperatur braucht mindestens zwei, die {least} auseinander liegen (Durchläufe innerhalb von {gap} sind ein Zustand)</translation>
    </message>
    <message>
        <source>a table for each direction is made of runs over targets; make those of a track one after the other (--direction positive, then --direction negative)</source>
        <translation>eine Tabelle für jede Richtung entsteht aus Durchläufen über Zielpositionen; die einer Bahn nacheinander erstellen (--direction positive, dann --direction negative)</translation>
    </message>
    <message>
        <source>{name} has one value for both directions, and so has what is merged onto it: make the table of the mean (--direction mean)</source>
        <translation>{name} hat einen Wert für beide Richtungen, also auch, was darin eingerechnet wird: die Tabelle des Mittels erstellen (--direction mean)</translation>
    </message>
    <message>
        <source>a table over position and temperature is for a drive, which has one value for both directions (--direction mean)</source>
        <translation>eine Tabelle über Position und Temperatur ist für einen Antrieb, und der hat einen Wert für beide Richtungen (--direction mean)</translation>
    </message>
    <message>
        <source>--remove-slope, --turn, --home and --remove-drift are for runs over targets along one axis</source>
        <translation>--remove-slope, --turn, --home und --remove-drift sind für Durchläufe über Zielpositionen entlang einer Achse</translation>
    </message>
    <message>
        <source>the fewest points that leave no more than a deviation (--within) are counted on a curve, which runs have, and a track with --method smooth; say the points of the grid or their distance (--points or --distance)</source>
        <translation>die wenigsten Punkte, die nicht mehr als eine Abweichung lassen (--within), werden an einer Kurve gezählt; die haben Durchläufe und eine Bahn mit --method smooth; sonst die Punkte des Gitters oder ihren Abstand angeben (--points oder --distance)</translation>
    </message>
    <message>
        <source>the name on the drive is {name}</source>
        <translation>der Name auf dem Antrieb ist {name}</translation>
    </message>
    <message>
        <source>the first measurement is of axis {before} and the second of axis {after}; they are not of the same axis</source>
        <translation>die erste Messung ist von Achse {before}, die zweite von Achse {after}; sie sind nicht von derselben Achse</translation>
    </message>
    <message>
        <source>measurements of axis {axis} and of axis {other} cannot be joined</source>
        <translation>Messungen der Achse {axis} und der Achse {other} lassen sich nicht zusammenfügen</translation>
    </message>
    <message>
        <source>the position of the zero is missing</source>
        <translation>die Position der Nullstelle fehlt</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, lookup: encoder or lookup: set, says for which side of the compensation the table was made: correct that line, or leave it out</source>
        <translation>in der Datei steht „{note}“; ein Kommentar, lookup: encoder oder lookup: set, sagt dort, für welche Seite der Kompensation die Tabelle erstellt wurde: diese Zeile korrigieren oder weglassen</translation>
    </message>
    <message>
        <source>these drives make no machine: {problem}</source>
        <translation>diese Antriebe ergeben keine Maschine: {problem}</translation>
    </message>
    <message>
        <source>the connection was ended</source>
        <translation>die Verbindung wurde beendet</translation>
    </message>
    <message>
        <source>number of the axis, from 0</source>
        <translation>Nummer der Achse, ab 0</translation>
    </message>
    <message>
        <source>number of the zone of the error map, from 0</source>
        <translation>Nummer der Zone der Fehlerkarte, ab 0</translation>
    </message>
    <message>
        <source>how the array is mapped: ERRORMAP1D, or CONNECT with MAP</source>
        <translation>wie das Array zugeordnet wird: ERRORMAP1D oder CONNECT mit MAP</translation>
    </message>
    <message>
        <source>ERRORMAP1D axis, zone, base, step, array</source>
        <translation>ERRORMAP1D Achse, Zone, Anfang, Schritt, Array</translation>
    </message>
    <message>
        <source>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), array, base, step)</source>
        <translation>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), Array, Anfang, Schritt)</translation>
    </message>
    <message>
        <source>a step of {step}</source>
        <translation>ein Schritt von {step}</translation>
    </message>
    <message>
        <source>a step above 0</source>
        <translation>ein Schritt über 0</translation>
    </message>
    <message>
        <source>another map of axis {axis}, besides that of line {line}</source>
        <translation>eine weitere Karte der Achse {axis} neben der in Zeile {line}</translation>
    </message>
    <message>
        <source>one map of an axis; both are read, and the program decides which one counts</source>
        <translation>eine Karte je Achse; beide werden gelesen, und das Programm entscheidet, welche gilt</translation>
    </message>
    <message>
        <source>no ERRORMAPON {axis}, {zone}</source>
        <translation>kein ERRORMAPON {axis}, {zone}</translation>
    </message>
    <message>
        <source>a statement that switches the map on, which may stand in another program</source>
        <translation>eine Anweisung, die die Karte einschaltet; sie kann in einem anderen Programm stehen</translation>
    </message>
    <message>
        <source>a map over two axes (MAP2)</source>
        <translation>eine Karte über zwei Achsen (MAP2)</translation>
    </message>
    <message>
        <source>the format {format} to read it</source>
        <translation>das Format {format}, um sie zu lesen</translation>
    </message>
    <message>
        <source>a statement ERRORMAP1D, or CONNECT with MAP, of which there is none</source>
        <translation>eine Anweisung ERRORMAP1D oder CONNECT mit MAP; es gibt keine</translation>
    </message>
    <message>
        <source>the axis must be referenced; the connection replaces an error map of the axis</source>
        <translation>die Achse muss referenziert sein; die Verbindung ersetzt eine Fehlerkarte der Achse</translation>
    </message>
    <message>
        <source>the axis must be referenced, and a map that is on switched off with ERRORMAPOFF before; ERRORUNMAP {axis}, {zone} removes the map</source>
        <translation>die Achse muss referenziert sein und eine eingeschaltete Karte vorher mit ERRORMAPOFF ausgeschaltet werden; ERRORUNMAP {axis}, {zone} entfernt die Karte</translation>
    </message>
    <message>
        <source>program with the error map of an axis (ERRORMAP1D, or CONNECT with MAP)</source>
        <translation>Programm mit der Fehlerkarte einer Achse (ERRORMAP1D oder CONNECT mit MAP)</translation>
    </message>
    <message>
        <source>number of the axis of the first source of the table, from 0</source>
        <translation>Nummer der Achse der ersten Quelle der Tabelle, ab 0</translation>
    </message>
    <message>
        <source>number of the axis of the second source of the table, from 0</source>
        <translation>Nummer der Achse der zweiten Quelle der Tabelle, ab 0</translation>
    </message>
    <message>
        <source>number of the axis that is compensated, from 0; needed where it is none of the sources</source>
        <translation>Nummer der kompensierten Achse, ab 0; nötig, wo sie keine der Quellen ist</translation>
    </message>
    <message>
        <source>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), array, base1, step1, base2, step2)</source>
        <translation>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), Array, Anfang1, Schritt1, Anfang2, Schritt2)</translation>
    </message>
    <message>
        <source>a map of one axis ({name})</source>
        <translation>eine Karte einer Achse ({name})</translation>
    </message>
    <message>
        <source>a statement CONNECT with MAP2, of which there is none</source>
        <translation>eine Anweisung CONNECT mit MAP2; es gibt keine</translation>
    </message>
    <message>
        <source>both sources are axis {axis}: {key} and {other}</source>
        <translation>beide Quellen sind Achse {axis}: {key} und {other}</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key}, since the table corrects none of its sources</source>
        <translation>das Format {format} braucht die Einstellung {key}, weil die Tabelle keine ihrer Quellen korrigiert</translation>
    </message>
    <message>
        <source>the table goes from {column}, which the settings {key}, {other} and {target} contradict</source>
        <translation>die Tabelle geht von {column}; dem widersprechen die Einstellungen {key}, {other} und {target}</translation>
    </message>
    <message>
        <source>the axes must be referenced; the connection replaces an error map of axis {axis}</source>
        <translation>die Achsen müssen referenziert sein; die Verbindung ersetzt eine Fehlerkarte der Achse {axis}</translation>
    </message>
    <message>
        <source>program with the map of an axis over two (MAP2)</source>
        <translation>Programm mit der Karte einer Achse über zwei Achsen (MAP2)</translation>
    </message>
    <message>
        <source>a number, or a name that got one before</source>
        <translation>eine Zahl oder ein Name, der vorher eine bekommen hat</translation>
    </message>
    <message>
        <source>one number; other buffers give it another one in line {line}</source>
        <translation>eine einzige Zahl; in Zeile {line} gibt ihm ein anderer Puffer eine andere</translation>
    </message>
    <message>
        <source>a name that got a number; in line {line} it gets something that is not computed here</source>
        <translation>ein Name, der eine Zahl bekommen hat; in Zeile {line} bekommt er etwas, das hier nicht ausgerechnet wird</translation>
    </message>
    <message>
        <source>a whole number, since it is declared INT; in line {line} it gets another one</source>
        <translation>eine ganze Zahl, weil er als INT deklariert ist; in Zeile {line} bekommt er eine andere</translation>
    </message>
    <message>
        <source>a number with a decimal point, or a name that got one; expressions are not computed</source>
        <translation>eine Zahl mit Dezimalpunkt oder ein Name, der eine bekommen hat; Ausdrücke werden nicht ausgerechnet</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>one index of {name}</source>
        <translation>ein Index von {name}</translation>
    </message>
    <message>
        <source>two indices of {name}</source>
        <translation>zwei Indizes von {name}</translation>
    </message>
    <message>
        <source>an index of {name}: a whole number from 0</source>
        <translation>ein Index von {name}: eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>a number with a decimal point; expressions are not computed</source>
        <translation>eine Zahl mit Dezimalpunkt; Ausdrücke werden nicht ausgerechnet</translation>
    </message>
    <message>
        <source>a whole number, since {name} is declared INT</source>
        <translation>eine ganze Zahl, weil {name} als INT deklariert ist</translation>
    </message>
    <message>
        <source>an array whose elements are numbers in this program</source>
        <translation>ein Array, dessen Elemente in diesem Programm Zahlen sind</translation>
    </message>
    <message>
        <source>{name} with another number of indices</source>
        <translation>{name} mit einer anderen Zahl von Indizes</translation>
    </message>
    <message>
        <source>{sizes}, which its elements need</source>
        <translation>{sizes}, wie es seine Elemente brauchen</translation>
    </message>
    <message>
        <source>{array} with elements for {sizes}</source>
        <translation>{array} mit Elementen für {sizes}</translation>
    </message>
    <message>
        <source>a value for each element; the table has those that the program gives, and the controller may use the others as they are</source>
        <translation>ein Wert für jedes Element; die Tabelle hat die Werte aus dem Programm, und die Steuerung kann die übrigen verwenden, wie sie sind</translation>
    </message>
    <message>
        <source>no {element}</source>
        <translation>kein {element}</translation>
    </message>
    <message>
        <source>a number for each element up to the highest index</source>
        <translation>eine Zahl für jedes Element bis zum höchsten Index</translation>
    </message>
    <message>
        <source>{element} a second time</source>
        <translation>{element} ein zweites Mal</translation>
    </message>
    <message>
        <source>each element once; the last number counts</source>
        <translation>jedes Element einmal; die letzte Zahl gilt</translation>
    </message>
    <message>
        <source>{name}, which is not supported</source>
        <translation>{name}, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>ERRORMAP1D, or CONNECT with MAP or MAP2</source>
        <translation>ERRORMAP1D oder CONNECT mit MAP oder MAP2</translation>
    </message>
    <message>
        <source>name of the array: a letter, then letters, digits and underlines</source>
        <translation>Name des Arrays: ein Buchstabe, dann Buchstaben, Ziffern und Unterstriche</translation>
    </message>
    <message>
        <source>the program declares the array; no where the controller has it already</source>
        <translation>das Programm deklariert das Array; no, wo die Steuerung es schon hat</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is no name for an array of the format {format}, such as {example}; change the setting {key}</source>
        <translation>„{name}“ ist kein Name für ein Array des Formats {format}, wie {example}; Einstellung {key} ändern</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}; it is a number from 0</source>
        <translation>die Einstellung {key} des Formats {format} ist {value}; sie ist eine Zahl ab 0</translation>
    </message>
    <message>
        <source>the controller must not have declared the array {name} before, since the program declares it; where it has, set declare=no</source>
        <translation>die Steuerung darf das Array {name} noch nicht deklariert haben, denn das Programm deklariert es; hat sie es schon, declare=no setzen</translation>
    </message>
    <message>
        <source>the controller must have declared the array {name}, with as many elements as the program gives it</source>
        <translation>die Steuerung muss das Array {name} deklariert haben, mit so vielen Elementen, wie das Programm ihm gibt</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}, and the axis name is &quot;{name}&quot;; give the setting {key}</source>
        <translation>das Format {format} benennt seine Achsen mit einem der Buchstaben {letters}, und der Achsname ist „{name}“; Einstellung {key} angeben</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}; the setting {key} is {value}</source>
        <translation>das Format {format} benennt seine Achsen mit einem der Buchstaben {letters}; die Einstellung {key} ist {value}</translation>
    </message>
    <message>
        <source>the table is of axis &quot;{name}&quot;, and the setting {key} of the format {format} says {value}</source>
        <translation>die Tabelle gehört zur Achse „{name}“, und die Einstellung {key} des Formats {format} sagt {value}</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with the position in each line</source>
        <translation>Kompensationswert-Tabelle (.COM) mit der Position in jeder Zeile</translation>
    </message>
    <message>
        <source>also distances that are no power of two times 0.0001, for an iTNC 530</source>
        <translation>auch Abstände, die keine Zweierpotenz mal 0.0001 sind, für eine iTNC 530</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with even positions</source>
        <translation>Kompensationswert-Tabelle (.COM) mit gleichmäßigen Positionen</translation>
    </message>
    <message>
        <source>letter of the axis whose position counts, where its name is none or another one</source>
        <translation>Buchstabe der Achse, deren Position gilt, wo ihr Name keiner oder ein anderer ist</translation>
    </message>
    <message>
        <source>letter of the axis that is compensated by the position of another one, where its name is none</source>
        <translation>Buchstabe der Achse, die nach der Position einer anderen kompensiert wird, wo ihr Name keiner ist</translation>
    </message>
    <message>
        <source>a number in mm or degrees behind {word}</source>
        <translation>eine Zahl in mm oder Grad hinter {word}</translation>
    </message>
    <message>
        <source>the setting {key} {value}</source>
        <translation>die Einstellung {key} {value}</translation>
    </message>
    <message>
        <source>one letter</source>
        <translation>ein Buchstabe</translation>
    </message>
    <message>
        <source>the moving axis, as in AXIS_Y; its letter as the setting {key} where the file has another name</source>
        <translation>die bewegte Achse, wie in AXIS_Y; ihr Buchstabe als Einstellung {key}, wo die Datei anders heißt</translation>
    </message>
    <message>
        <source>axis {axis} in the name of the file</source>
        <translation>Achse {axis} im Namen der Datei</translation>
    </message>
    <message>
        <source>axis {axis}, as the setting {key} says</source>
        <translation>Achse {axis}, wie die Einstellung {key} sagt</translation>
    </message>
    <message>
        <source>a first line without MM</source>
        <translation>eine erste Zeile ohne MM</translation>
    </message>
    <message>
        <source>MM or INCH; mm is assumed</source>
        <translation>MM oder INCH; mm wird angenommen</translation>
    </message>
    <message>
        <source>a first line such as {example}</source>
        <translation>eine erste Zeile wie {example}</translation>
    </message>
    <message>
        <source>a distance of {distance}</source>
        <translation>ein Abstand von {distance}</translation>
    </message>
    <message>
        <source>a tab</source>
        <translation>ein Tabulator</translation>
    </message>
    <message>
        <source>blanks, since the columns are counted in characters</source>
        <translation>Leerzeichen, weil die Spalten in Zeichen gezählt werden</translation>
    </message>
    <message>
        <source>each column once</source>
        <translation>jede Spalte einmal</translation>
    </message>
    <message>
        <source>a line of headers such as {example}</source>
        <translation>eine Zeile mit Überschriften wie {example}</translation>
    </message>
    <message>
        <source>a value below the header of an axis, and one in each column</source>
        <translation>ein Wert unter der Überschrift einer Achse, und einer je Spalte</translation>
    </message>
    <message>
        <source>the number of a line</source>
        <translation>die Nummer einer Zeile</translation>
    </message>
    <message>
        <source>ascending numbers from 0</source>
        <translation>aufsteigende Nummern ab 0</translation>
    </message>
    <message>
        <source>{position}, as DATUM and DISTANCE say for line {number}</source>
        <translation>{position}, wie DATUM und DISTANCE für Zeile {number} sagen</translation>
    </message>
    <message>
        <source>more than {count} lines</source>
        <translation>mehr als {count} Zeilen</translation>
    </message>
    <message>
        <source>at most {count} lines</source>
        <translation>höchstens {count} Zeilen</translation>
    </message>
    <message>
        <source>a line with its number and its position</source>
        <translation>eine Zeile mit ihrer Nummer und ihrer Position</translation>
    </message>
    <message>
        <source>nothing behind [END]</source>
        <translation>nichts hinter [END]</translation>
    </message>
    <message>
        <source>no line [END]</source>
        <translation>keine Zeile [END]</translation>
    </message>
    <message>
        <source>that line at the end; the file may be cut off</source>
        <translation>diese Zeile am Ende; die Datei ist vielleicht abgeschnitten</translation>
    </message>
    <message>
        <source>the position {position} of the rotary axis {axis}</source>
        <translation>die Position {position} der Drehachse {axis}</translation>
    </message>
    <message>
        <source>0 to 360 deg; the control does not use others</source>
        <translation>0 bis 360 deg; andere verwendet die Steuerung nicht</translation>
    </message>
    <message>
        <source>values of {axis} that change by {change}</source>
        <translation>Werte von {axis}, die sich um {change} ändern</translation>
    </message>
    <message>
        <source>at most {limit} from line to line, DISTANCE / 64, on older controls</source>
        <translation>höchstens {limit} von Zeile zu Zeile, DISTANCE / 64, bei älteren Steuerungen</translation>
    </message>
    <message>
        <source>values in a column, of which there are none</source>
        <translation>Werte in einer Spalte; es gibt keine</translation>
    </message>
    <message>
        <source>the column of {axis}</source>
        <translation>der Spalte von {axis}</translation>
    </message>
    <message>
        <source>a line of headers behind the first line</source>
        <translation>eine Zeile mit Überschriften hinter der ersten Zeile</translation>
    </message>
    <message numerus="yes">
        <source>{count} values in the column BACKLASH</source>
        <comment>1 value in the column BACKLASH</comment>
        <translation>
            <numerusform>1 Wert in der Spalte BACKLASH</numerusform>
            <numerusform>{count} Werte in der Spalte BACKLASH</numerusform>
        </translation>
    </message>
    <message>
        <source>none: it is not published whether they are whole values or differences</source>
        <translation>keine: es ist nicht veröffentlicht, ob es ganze Werte oder Differenzen sind</translation>
    </message>
    <message>
        <source>the table goes from {column}, and the settings for its axes say {axis} for both</source>
        <translation>die Tabelle geht von {column}, und die Einstellungen für ihre Achsen sagen {axis} für beide</translation>
    </message>
    <message>
        <source>there are two columns for axis {axis}</source>
        <translation>es gibt zwei Spalten für die Achse {axis}</translation>
    </message>
    <message>
        <source>its numbers for axis {axis} are in {unit}; A, B and C are in degrees, other axes in mm</source>
        <translation>ihre Zahlen für die Achse {axis} sind in {unit}; A, B und C sind in Grad, andere Achsen in mm</translation>
    </message>
    <message>
        <source>check the units and the axes of the table</source>
        <translation>Einheiten und Achsen der Tabelle prüfen</translation>
    </message>
    <message>
        <source>its positions go from {first} to {last}, and of a rotary axis only 0 to 360 degrees count</source>
        <translation>ihre Positionen gehen von {first} bis {last}, und von einer Drehachse gelten nur 0 bis 360 Grad</translation>
    </message>
    <message>
        <source>give them from 0 to 360 degrees in the file that is converted, -90 as 270</source>
        <translation>in der Datei, die umgewandelt wird, von 0 bis 360 Grad angeben, -90 als 270</translation>
    </message>
    <message>
        <source>the numbers for axis {axis} have no unit; they are taken to be in {unit}</source>
        <translation>die Zahlen für die Achse {axis} haben keine Einheit; sie gelten als {unit}</translation>
    </message>
    <message>
        <source>its distance is {distance}; the TNC 407 takes a power of two times {step}, and the next ones are {below} and {above}</source>
        <translation>ihr Abstand ist {distance}; die TNC 407 nimmt eine Zweierpotenz mal {step}, und die nächsten sind {below} und {above}</translation>
    </message>
    <message>
        <source>resample it with one of these distances, or set any-distance=yes for an iTNC 530</source>
        <translation>mit einem dieser Abstände umrechnen, oder any-distance=yes für eine iTNC 530 setzen</translation>
    </message>
    <message>
        <source>its distance {distance} has more than {count} decimals</source>
        <translation>ihr Abstand {distance} hat mehr als {count} Nachkommastellen</translation>
    </message>
    <message>
        <source>resample it with a distance of fewer decimals</source>
        <translation>mit einem Abstand mit weniger Nachkommastellen umrechnen</translation>
    </message>
    <message>
        <source>the number {number} has more digits than a column holds</source>
        <translation>die Zahl {number} hat mehr Ziffern, als eine Spalte fasst</translation>
    </message>
    <message>
        <source>no text says the sign of a .COM table; it is written as the error, actual - commanded position. Check one point on the machine</source>
        <translation>kein Text sagt das Vorzeichen einer .COM-Tabelle; sie wird als Fehler geschrieben, Istposition - Sollposition. Einen Punkt an der Maschine prüfen</translation>
    </message>
    <message>
        <source>name the file in a line of config.cma, in the column of axis {axis}, and mark the line with *; older controls also need the bit of the axis in MP730</source>
        <translation>die Datei in einer Zeile von config.cma in der Spalte der Achse {axis} eintragen und die Zeile mit * markieren; ältere Steuerungen brauchen auch das Bit der Achse in MP730</translation>
    </message>
    <message>
        <source>axis of the table, where the table names none of these</source>
        <translation>Achse der Tabelle, wo die Tabelle keine von diesen nennt</translation>
    </message>
    <message>
        <source>the unit &quot;{unit}&quot;</source>
        <translation>die Einheit „{unit}“</translation>
    </message>
    <message>
        <source>mm, the only unit of this file</source>
        <translation>mm, die einzige Einheit dieser Datei</translation>
    </message>
    <message>
        <source>the letter of an axis between brackets, such as [X]</source>
        <translation>der Buchstabe einer Achse zwischen Klammern, wie [X]</translation>
    </message>
    <message>
        <source>a section of axis {axis}</source>
        <translation>ein Abschnitt der Achse {axis}</translation>
    </message>
    <message>
        <source>X, Y or Z</source>
        <translation>X, Y oder Z</translation>
    </message>
    <message>
        <source>a second section of axis {axis}</source>
        <translation>ein zweiter Abschnitt der Achse {axis}</translation>
    </message>
    <message>
        <source>each axis once; the first is in line {line}</source>
        <translation>jede Achse einmal; der erste Abschnitt steht in Zeile {line}</translation>
    </message>
    <message>
        <source>a section such as [X] before the first numbers</source>
        <translation>ein Abschnitt wie [X] vor den ersten Zahlen</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers between commas</source>
        <comment>1 number between commas</comment>
        <translation>
            <numerusform>1 Zahl zwischen Kommas</numerusform>
            <numerusform>{count} Zahlen zwischen Kommas</numerusform>
        </translation>
    </message>
    <message>
        <source>3, with decimal points: nominal position, forward error, backward error</source>
        <translation>3, mit Dezimalpunkten: Sollposition, Fehler vorwärts, Fehler rückwärts</translation>
    </message>
    <message>
        <source>a forward error in mm</source>
        <translation>ein Fehler vorwärts in mm</translation>
    </message>
    <message>
        <source>a backward error in mm</source>
        <translation>ein Fehler rückwärts in mm</translation>
    </message>
    <message>
        <source>a section such as [X], of which there is none</source>
        <translation>ein Abschnitt wie [X]; es gibt keinen</translation>
    </message>
    <message>
        <source>no line unit=mm</source>
        <translation>keine Zeile unit=mm</translation>
    </message>
    <message>
        <source>that line; mm is the only unit</source>
        <translation>diese Zeile; mm ist die einzige Einheit</translation>
    </message>
    <message>
        <source>the file is axeserr.dat in the folder of the software (NK200: from a USB stick), read when the software starts</source>
        <translation>die Datei ist axeserr.dat im Ordner der Software (NK200: vom USB-Stick), gelesen beim Start der Software</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2: both directions</source>
        <translation>den Parameter Screw error compensation auf 2 setzen: beide Richtungen</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2, or to 1 with the backlash as a parameter of its own</source>
        <translation>den Parameter Screw error compensation auf 2 setzen, oder auf 1 mit dem Umkehrspiel als eigenem Parameter</translation>
    </message>
    <message>
        <source>positions are machine coordinates from the reference point and must lie within the stroke, else the compensation is invalid</source>
        <translation>Positionen sind Maschinenkoordinaten vom Referenzpunkt aus und müssen im Verfahrweg liegen, sonst ist die Kompensation ungültig</translation>
    </message>
    <message>
        <source>axeserr.dat: screw errors forwards and backwards</source>
        <translation>axeserr.dat: Spindelfehler vorwärts und rückwärts</translation>
    </message>
    <message>
        <source>nobody has published which sign files of the format {format} have; {sign} is an assumption. Check one point on the machine, and state feedback or command {statement}</source>
        <translation>niemand hat veröffentlicht, welches Vorzeichen Dateien des Formats {format} haben; {sign} ist eine Annahme. Einen Punkt an der Maschine prüfen und feedback oder command angeben, {statement}</translation>
    </message>
    <message>
        <source>holds the end values</source>
        <translation>hält die Endwerte</translation>
    </message>
    <message>
        <source>applies nothing</source>
        <translation>wendet nichts an</translation>
    </message>
    <message>
        <source>goes on as in the last cell</source>
        <translation>fährt wie in der letzten Zelle fort</translation>
    </message>
    <message>
        <source>beyond the ends of the table the controller of {from} {before}, and that of {to} {after}: up to one cell beyond them, the corrections for {column} differ by at most {largest}, at {place}</source>
        <translation>jenseits der Enden der Tabelle gilt: die Steuerung von {from} {before}, die von {to} {after}; bis zu einer Zelle jenseits davon unterscheiden sich die Korrekturen für {column} um höchstens {largest}, bei {place}</translation>
    </message>
    <message>
        <source>in the field Sign, or with {option}</source>
        <translation>im Feld Vorzeichen oder mit {option}</translation>
    </message>
    <message>
        <source>in the field Sign, with {option}, or as {entry} in a machine file</source>
        <translation>im Feld Vorzeichen, mit {option} oder als {entry} in einer Maschinendatei</translation>
    </message>
    <message>
        <source>an entry such as {example}</source>
        <translation>ein Eintrag wie {example}</translation>
    </message>
    <message>
        <source>each entry once; the last one counts</source>
        <translation>jeder Eintrag einmal; der letzte zählt</translation>
    </message>
    <message>
        <source>a value in mm</source>
        <translation>ein Wert in mm</translation>
    </message>
    <message>
        <source>{key} and {key2} as the ends of {list}</source>
        <translation>{key} und {key2} als Enden von {list}</translation>
    </message>
    <message>
        <source>{key} and {key2}, as later firmware writes them</source>
        <translation>{key} und {key2}, wie spätere Firmware sie schreibt</translation>
    </message>
    <message>
        <source>entries {key} and {key2} for {list}</source>
        <translation>Einträge {key} und {key2} für {list}</translation>
    </message>
    <message>
        <source>an end above the start</source>
        <translation>ein Ende über dem Anfang</translation>
    </message>
    <message>
        <source>a section [{section}] with {list} or {list2}</source>
        <translation>ein Abschnitt [{section}] mit {list} oder {list2}</translation>
    </message>
    <message>
        <source>[axis_twist_compensation] of printer.cfg: errors of the probe over X or Y</source>
        <translation>[axis_twist_compensation] von printer.cfg: Fehler des Tasters über X oder Y</translation>
    </message>
    <message>
        <source>unit of all numbers of the file; the controller takes them to be inches, and files in millimetres occur</source>
        <translation>Einheit aller Zahlen der Datei; die Steuerung hält sie für Zoll, und es kommen Dateien in Millimetern vor</translation>
    </message>
    <message>
        <source>a missing number</source>
        <translation>eine fehlende Zahl</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers with commas between</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>eine Zahl</numerusform>
            <numerusform>{count} Zahlen mit Kommas dazwischen</numerusform>
        </translation>
    </message>
    <message>
        <source>a comma directly behind the number &quot;{number}&quot;</source>
        <translation>ein Komma direkt hinter der Zahl &quot;{number}&quot;</translation>
    </message>
    <message>
        <source>rows and columns, distances of X and Y, and X and Y of the first point</source>
        <translation>Zeilen und Spalten, Abstände von X und Y sowie X und Y des ersten Punkts</translation>
    </message>
    <message>
        <source>a number of rows or columns, {number} to {number2}</source>
        <translation>eine Anzahl Zeilen oder Spalten, {number} bis {number2}</translation>
    </message>
    <message>
        <source>a distance such as 0.5</source>
        <translation>ein Abstand wie 0.5</translation>
    </message>
    <message>
        <source>another one: with 0 the controller corrects nothing</source>
        <translation>ein anderer: mit 0 korrigiert die Steuerung nichts</translation>
    </message>
    <message>
        <source>a position of row 0 and column 0</source>
        <translation>eine Position von Zeile 0 und Spalte 0</translation>
    </message>
    <message>
        <source>the number of a row, 0 to {last}</source>
        <translation>die Nummer einer Zeile, 0 bis {last}</translation>
    </message>
    <message>
        <source>the number of a column, 0 to {last}</source>
        <translation>die Nummer einer Spalte, 0 bis {last}</translation>
    </message>
    <message>
        <source>row {row}, column {column}</source>
        <translation>Zeile {row}, Spalte {column}</translation>
    </message>
    <message>
        <source>each point once; the last line counts</source>
        <translation>jeder Punkt einmal; die letzte Zeile zählt</translation>
    </message>
    <message numerus="yes">
        <source>no line for {count} points, the first of them {point}</source>
        <comment>no line for {point}</comment>
        <translation>
            <numerusform>keine Zeile für {point}</numerusform>
            <numerusform>keine Zeile für {count} Punkte, der erste davon {point}</numerusform>
        </translation>
    </message>
    <message>
        <source>a line for each of the {rows} x {columns} points</source>
        <translation>eine Zeile für jeden der {rows} x {columns} Punkte</translation>
    </message>
    <message>
        <source>further numbers behind the last point</source>
        <translation>weitere Zahlen hinter dem letzten Punkt</translation>
    </message>
    <message>
        <source>{number} points; the controller does not read more either</source>
        <translation>{number} Punkte; auch die Steuerung liest nicht mehr</translation>
    </message>
    <message>
        <source>numbers without a unit, taken to be {unit}</source>
        <translation>Zahlen ohne Einheit, angenommen wird {unit}</translation>
    </message>
    <message>
        <source>the setting {key}, {value} or {value2}</source>
        <translation>die Einstellung {key}, {value} oder {value2}</translation>
    </message>
    <message>
        <source>its source {number} is {axis}, and this one is {name}</source>
        <translation>seine Quelle {number} ist {axis}, und diese ist {name}</translation>
    </message>
    <message>
        <source>exchange the sources of the table</source>
        <translation>vertauschen Sie die Quellen der Tabelle</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than the {limit} that the controller takes</source>
        <translation>{count} Punkte entlang {axis} sind mehr als die {limit}, die die Steuerung annimmt</translation>
    </message>
    <message>
        <source>it corrects X, Y and Z, and this table goes from {column}</source>
        <translation>es korrigiert X, Y und Z, und diese Tabelle geht von {column}</translation>
    </message>
    <message>
        <source>state the target as Z, or as other, where it is Z</source>
        <translation>geben Sie das Ziel als Z an, oder als other, wo es Z ist</translation>
    </message>
    <message>
        <source>two columns go from {column}</source>
        <translation>zwei Spalten gehen von {column}</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>behalten Sie eine davon</translation>
    </message>
    <message>
        <source>the numbers of the file are in {unit}; the controller takes them to be inches</source>
        <translation>die Zahlen der Datei sind in {unit}; die Steuerung hält sie für Zoll</translation>
    </message>
    <message>
        <source>name the file as Geo File in the tool setup of KMotionCNC; arcs are then broken into short lines, and Z is corrected for the plane Z = 0 only</source>
        <translation>tragen Sie die Datei als Geo File im Tool Setup von KMotionCNC ein; Bögen werden dann in kurze Strecken zerlegt, und Z wird nur für die Ebene Z = 0 korrigiert</translation>
    </message>
    <message>
        <source>geometric correction of X, Y and Z over X and Y</source>
        <translation>geometrische Korrektur von X, Y und Z über X und Y</translation>
    </message>
    <message>
        <source>a line each for the number of positions, the size of a range and the first position</source>
        <translation>je eine Zeile für die Anzahl der Positionen, die Größe eines Bereichs und die erste Position</translation>
    </message>
    <message>
        <source>a number of positions</source>
        <translation>eine Anzahl Positionen</translation>
    </message>
    <message>
        <source>the size of a range</source>
        <translation>die Größe eines Bereichs</translation>
    </message>
    <message>
        <source>the first position</source>
        <translation>die erste Position</translation>
    </message>
    <message>
        <source>a range of {size}</source>
        <translation>ein Bereich von {size}</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>mehr als 0</translation>
    </message>
    <message>
        <source>index and position, or the position alone</source>
        <translation>Index und Position, oder die Position allein</translation>
    </message>
    <message>
        <source>an index from 0</source>
        <translation>ein Index ab 0</translation>
    </message>
    <message>
        <source>the index {number}</source>
        <translation>der Index {number}</translation>
    </message>
    <message>
        <source>{number}: indices count from 0 in the order of the lines</source>
        <translation>{number}: Indizes zählen ab 0 in der Reihenfolge der Zeilen</translation>
    </message>
    <message>
        <source>a position to command</source>
        <translation>eine zu kommandierende Position</translation>
    </message>
    <message>
        <source>{value}, as the first line says</source>
        <translation>{value}, wie die erste Zeile sagt</translation>
    </message>
    <message>
        <source>strictly increasing positions to command; a list of corrections is no such file</source>
        <translation>streng steigende zu kommandierende Positionen; eine Liste von Korrekturen ist keine solche Datei</translation>
    </message>
    <message>
        <source>at {position} the position to command, {sum}, is not larger than the one before, {before}</source>
        <translation>bei {position} ist die zu kommandierende Position {sum} nicht größer als die davor, {before}</translation>
    </message>
    <message>
        <source>the file holds positions to command, not corrections; KMotionCNC applies them after the geometric correction</source>
        <translation>die Datei enthält zu kommandierende Positionen, keine Korrekturen; KMotionCNC wendet sie nach der geometrischen Korrektur an</translation>
    </message>
    <message>
        <source>linear table of one axis: positions to command</source>
        <translation>lineare Tabelle einer Achse: zu kommandierende Positionen</translation>
    </message>
    <message>
        <source>motor units for one unit of the positions</source>
        <translation>Motoreinheiten für eine Einheit der Positionen</translation>
    </message>
    <message>
        <source>number of the table, from 0</source>
        <translation>Nummer der Tabelle, ab 0</translation>
    </message>
    <message>
        <source>number of the motor whose position counts</source>
        <translation>Nummer des Motors, dessen Position zählt</translation>
    </message>
    <message>
        <source>number of the motor that is compensated</source>
        <translation>Nummer des Motors, der kompensiert wird</translation>
    </message>
    <message>
        <source>a value of the table</source>
        <translation>ein Wert der Tabelle</translation>
    </message>
    <message>
        <source>value {number} again</source>
        <translation>Wert {number} noch einmal</translation>
    </message>
    <message>
        <source>each value once; the last one counts</source>
        <translation>jeder Wert einmal; der letzte zählt</translation>
    </message>
    <message>
        <source>an assignment such as {example}</source>
        <translation>eine Zuweisung wie {example}</translation>
    </message>
    <message>
        <source>{element} of the table: {meaning}</source>
        <translation>{element} der Tabelle: {meaning}</translation>
    </message>
    <message>
        <source>CompPos or CompPos2 of one motor, such as {example}</source>
        <translation>CompPos oder CompPos2 eines Motors, wie {example}</translation>
    </message>
    <message>
        <source>the motor that is compensated</source>
        <translation>der Motor, der kompensiert wird</translation>
    </message>
    <message>
        <source>the scale factor of the values</source>
        <translation>der Skalierungsfaktor der Werte</translation>
    </message>
    <message>
        <source>a scale factor Sf[0] of {factor}</source>
        <translation>ein Skalierungsfaktor Sf[0] von {factor}</translation>
    </message>
    <message>
        <source>1; it is taken to multiply the values</source>
        <translation>1; angenommen wird, dass er die Werte multipliziert</translation>
    </message>
    <message>
        <source>{value}; what other bits do is not known</source>
        <translation>{value}; was andere Bits bewirken, ist nicht bekannt</translation>
    </message>
    <message>
        <source>no value {number}</source>
        <translation>kein Wert {number}</translation>
    </message>
    <message>
        <source>a table of several sources</source>
        <translation>eine Tabelle mit mehreren Quellen</translation>
    </message>
    <message>
        <source>one source: in which order the values of several stand is not known</source>
        <translation>eine Quelle: in welcher Reihenfolge die Werte mehrerer stehen, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the number of segments, one less than values</source>
        <translation>die Anzahl der Segmente, eines weniger als Werte</translation>
    </message>
    <message>
        <source>the whole span</source>
        <translation>die ganze Spanne</translation>
    </message>
    <message>
        <source>the number of the source motor</source>
        <translation>die Nummer des Quellmotors</translation>
    </message>
    <message>
        <source>{count} segments over {span}</source>
        <translation>{count} Segmente über {span}</translation>
    </message>
    <message>
        <source>1 to {most} segments over more than 0</source>
        <translation>1 bis {most} Segmente über mehr als 0</translation>
    </message>
    <message>
        <source>assignments to {name}</source>
        <translation>Zuweisungen an {name}</translation>
    </message>
    <message>
        <source>a table in motor units</source>
        <translation>eine Tabelle in Motoreinheiten</translation>
    </message>
    <message>
        <source>there is no number {number}</source>
        <translation>es gibt keine Nummer {number}</translation>
    </message>
    <message>
        <source>choose one from 0 to {most}</source>
        <translation>wählen Sie eine von 0 bis {most}</translation>
    </message>
    <message>
        <source>Sys.CompEnable must be at least {number}, also for other tables</source>
        <translation>Sys.CompEnable muss mindestens {number} sein, auch für andere Tabellen</translation>
    </message>
    <message>
        <source>the sign of these tables and what Sf, Ctrl and OutCtrl do are assumptions: look at one point on the machine before the table is used</source>
        <translation>das Vorzeichen dieser Tabellen und was Sf, Ctrl und OutCtrl bewirken, sind Annahmen: sehen Sie sich einen Punkt an der Maschine an, bevor die Tabelle benutzt wird</translation>
    </message>
    <message>
        <source>compensation table of one source (CompTable)</source>
        <translation>Kompensationstabelle mit einer Quelle (CompTable)</translation>
    </message>
    <message>
        <source>what the variables are called: letters, digits and _, a letter first</source>
        <translation>wie die Variablen heißen: Buchstaben, Ziffern und _, ein Buchstabe zuerst</translation>
    </message>
    <message>
        <source>a variable of the type {type} in front of the elements</source>
        <translation>eine Variable des Typs {type} vor den Elementen</translation>
    </message>
    <message>
        <source>TRUE or FALSE</source>
        <translation>TRUE oder FALSE</translation>
    </message>
    <message>
        <source>{value}: what another direction means is not known here</source>
        <translation>{value}: was eine andere Richtung bedeutet, ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>a declaration without its end</source>
        <translation>eine Deklaration ohne ihr Ende</translation>
    </message>
    <message>
        <source>a semicolon behind it</source>
        <translation>ein Semikolon dahinter</translation>
    </message>
    <message>
        <source>the last position</source>
        <translation>die letzte Position</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>die Anzahl der Elemente</translation>
    </message>
    <message numerus="yes">
        <source>{count} elements</source>
        <comment>1 element</comment>
        <translation>
            <numerusform>ein Element</numerusform>
            <numerusform>{count} Elemente</numerusform>
        </translation>
    </message>
    <message>
        <source>from {first} to {last}, as MinPosition and MaxPosition say</source>
        <translation>von {first} bis {last}, wie MinPosition und MaxPosition sagen</translation>
    </message>
    <message>
        <source>an element of one number</source>
        <translation>ein Element aus einer Zahl</translation>
    </message>
    <message>
        <source>a position and a compensation</source>
        <translation>eine Position und eine Kompensation</translation>
    </message>
    <message>
        <source>a compensation</source>
        <translation>eine Kompensation</translation>
    </message>
    <message>
        <source>the values {first} and {last} at the ends</source>
        <translation>die Werte {first} und {last} an den Enden</translation>
    </message>
    <message>
        <source>the same value at both ends, which are one place</source>
        <translation>derselbe Wert an beiden Enden, die ein Ort sind</translation>
    </message>
    <message>
        <source>an array of {type} behind the parameters</source>
        <translation>ein Feld von {type} hinter den Parametern</translation>
    </message>
    <message>
        <source>a variable of the type {type}</source>
        <translation>eine Variable des Typs {type}</translation>
    </message>
    <message>
        <source>the setting name is &quot;{value}&quot;, expected letters, digits and _, a letter first</source>
        <translation>die Einstellung name ist &quot;{value}&quot;, erwartet werden Buchstaben, Ziffern und _, ein Buchstabe zuerst</translation>
    </message>
    <message>
        <source>the manual contradicts itself on whether the correction is added to the nominal or to the actual position: check one point on the machine</source>
        <translation>das Handbuch widerspricht sich, ob die Korrektur zur Soll- oder zur Istposition addiert wird: prüfen Sie einen Punkt an der Maschine</translation>
    </message>
    <message>
        <source>switch Position Correction of the axis on; Ramp limits the speed of the correction</source>
        <translation>schalten Sie Position Correction der Achse ein; Ramp begrenzt die Geschwindigkeit der Korrektur</translation>
    </message>
    <message>
        <source>structured text for MC_TableBasedPositionCompensation</source>
        <translation>strukturierter Text für MC_TableBasedPositionCompensation</translation>
    </message>
    <message>
        <source>a prediction needs a measurement of targets</source>
        <translation>eine Vorhersage braucht eine Messung mit Zielpositionen</translation>
    </message>
    <message>
        <source>a prediction needs a table of one dimension</source>
        <translation>eine Vorhersage braucht eine Tabelle mit einer Dimension</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them with accept-large = true for axis {machineAxis} in the machine file</source>
        <translation>{reason} Die Einheit der Werte prüfen; wenn sie stimmen, sie mit accept-large = true bei Achse {machineAxis} in der Maschinendatei bestätigen</translation>
    </message>
    <message>
        <source>the table is in counts already, and the format {format} would multiply it by the counts per unit once more: set them to 1, or read the source with its own</source>
        <translation>die Tabelle ist bereits in Inkrementen, und das Format {format} würde sie noch einmal mit den Inkrementen je Einheit multiplizieren: diese auf 1 setzen, oder die Quelle mit ihren eigenen lesen</translation>
    </message>
    <message>
        <source>a comma, a bracket or a semicolon behind the value &quot;{value}&quot;</source>
        <translation>ein Komma, eine Klammer oder ein Semikolon hinter dem Wert &quot;{value}&quot;</translation>
    </message>
    <message>
        <source>the table is {length} long, but a turn of the axis is {turn}: a prediction needs a table of one turn</source>
        <translation>die Tabelle ist {length} lang, eine Umdrehung der Achse aber {turn}: eine Vorhersage braucht eine Tabelle über eine Umdrehung</translation>
    </message>
    <message>
        <source>nobody has published the sign of its format. Import it on Write, where you state the sign, export it from there as a calibration file, and choose that</source>
        <translation>niemand hat das Vorzeichen seines Formats veröffentlicht. Auf „Schreiben“ importieren, dort das Vorzeichen angeben, von dort als Kalibrierdatei exportieren und diese wählen</translation>
    </message>
    <message>
        <source>there is no font with the characters of this language to draw a PDF with: install one, such as fonts-noto-cjk, or write the report as HTML</source>
        <translation>es gibt keine Schrift mit den Zeichen dieser Sprache, um ein PDF zu zeichnen: eine installieren, etwa fonts-noto-cjk, oder den Bericht als HTML schreiben</translation>
    </message>
    <message>
        <source>{file} is no record (.axcal), no machine file (.toml), no TAM configuration (.TAMcfg), and no table or measurement of a known format; a table whose format you can name is opened on the tab Write</source>
        <translation>{file} ist kein Protokoll (.axcal), keine Maschinendatei (.toml), keine TAM-Konfiguration (.TAMcfg) und keine Tabelle oder Messung in einem bekannten Format; eine Tabelle, deren Format Sie nennen können, wird im Reiter Schreiben geöffnet</translation>
    </message>
    <message>
        <source>the drive is only looked at</source>
        <translation>der Antrieb wird nur angesehen</translation>
    </message>
    <message>
        <source>you have no permission to use the port, and no group has it</source>
        <translation>keine Berechtigung für den Anschluss, und keine Gruppe hat sie</translation>
    </message>
    <message>
        <source>ask the administrator</source>
        <translation>den Administrator fragen</translation>
    </message>
    <message>
        <source>you have no permission to use the port, although you are in its group {group}</source>
        <translation>keine Berechtigung für den Anschluss, obwohl Sie in seiner Gruppe {group} sind</translation>
    </message>
    <message>
        <source>you have no permission to use the port: you are in the group {group}, but this session is older than that</source>
        <translation>keine Berechtigung für den Anschluss: Sie sind in der Gruppe {group}, aber diese Sitzung ist älter</translation>
    </message>
    <message>
        <source>log out and in again</source>
        <translation>ab- und wieder anmelden</translation>
    </message>
    <message>
        <source>you have no permission to use the port</source>
        <translation>keine Berechtigung für den Anschluss</translation>
    </message>
    <message>
        <source>join the group {group} (sudo usermod -aG {name} $USER) and log in again</source>
        <translation>der Gruppe {group} beitreten (sudo usermod -aG {name} $USER) und neu anmelden</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>einen solchen Anschluss gibt es nicht</translation>
    </message>
    <message>
        <source>is the cable or the adapter plugged in?</source>
        <translation>ist das Kabel oder der Adapter eingesteckt?</translation>
    </message>
    <message>
        <source>{found}; {wayOut}</source>
        <translation>{found}; {wayOut}</translation>
    </message>
    <message>
        <source>the instrument sends a line of more than {count} characters: check its settings and its speed</source>
        <translation>das Messgerät sendet eine Zeile von mehr als {count} Zeichen: seine Einstellungen und seine Baudrate prüfen</translation>
    </message>
    <message>
        <source>number of the reference point, parameter 3620</source>
        <translation>Nummer des Referenzpunkts, Parameter 3620</translation>
    </message>
    <message>
        <source>interval of the points, parameter 3624, in the unit of the positions</source>
        <translation>Abstand der Punkte, Parameter 3624, in der Einheit der Positionen</translation>
    </message>
    <message>
        <source>detection unit of the axis, in the unit of the positions, such as 0.001</source>
        <translation>Erfassungseinheit der Achse, in der Einheit der Positionen, zum Beispiel 0.001</translation>
    </message>
    <message>
        <source>magnification of the values, parameter 3623</source>
        <translation>Vergrößerungsfaktor der Werte, Parameter 3623</translation>
    </message>
    <message>
        <source>position of the reference point</source>
        <translation>Position des Referenzpunkts</translation>
    </message>
    <message>
        <source>lowest number of the axis, parameter 3621, instead of the lowest one in the file</source>
        <translation>niedrigste Nummer der Achse, Parameter 3621, statt der niedrigsten in der Datei</translation>
    </message>
    <message>
        <source>highest number of the axis, parameter 3622, instead of the highest one in the file</source>
        <translation>höchste Nummer der Achse, Parameter 3622, statt der höchsten in der Datei</translation>
    </message>
    <message>
        <source>what N of a line is for number 0</source>
        <translation>was das N einer Zeile für Nummer 0 ist</translation>
    </message>
    <message>
        <source>largest value that the controller takes for a number</source>
        <translation>größter Wert, den die Steuerung für eine Nummer annimmt</translation>
    </message>
    <message>
        <source>stored pitch error data of an axis (N10033P2)</source>
        <translation>gespeicherte Steigungsfehlerdaten einer Achse (N10033P2)</translation>
    </message>
    <message>
        <source>a whole number of increments behind P</source>
        <translation>eine ganze Zahl von Inkrementen hinter P</translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation>höchstens {most}</translation>
    </message>
    <message>
        <source>bit 0 of parameter 3605 is 1: values for each direction of motion</source>
        <translation>Bit 0 von Parameter 3605 ist 1: Werte für jede Bewegungsrichtung</translation>
    </message>
    <message>
        <source>one value for both directions; leave the line out if it is of another axis</source>
        <translation>ein Wert für beide Richtungen; die Zeile weglassen, wenn sie zu einer anderen Achse gehört</translation>
    </message>
    <message>
        <source>line N{number}</source>
        <translation>Zeile N{number}</translation>
    </message>
    <message>
        <source>N{first} to N{last}, as the setting first-record says</source>
        <translation>N{first} bis N{last}, wie die Angabe first-record sagt</translation>
    </message>
    <message>
        <source>a line such as {example}</source>
        <translation>eine Zeile wie {example}</translation>
    </message>
    <message>
        <source>a line % in front of it</source>
        <translation>eine Zeile % davor</translation>
    </message>
    <message>
        <source>lines without an end</source>
        <translation>Zeilen ohne Ende</translation>
    </message>
    <message>
        <source>a line % behind the last one</source>
        <translation>eine Zeile % hinter der letzten</translation>
    </message>
    <message>
        <source>lines such as {example} between two lines %</source>
        <translation>Zeilen wie {example} zwischen zwei Zeilen %</translation>
    </message>
    <message>
        <source>no line from N{first} to N{last}</source>
        <translation>keine Zeile von N{first} bis N{last}</translation>
    </message>
    <message>
        <source>pitch error data; the setting first-record says where their numbers begin</source>
        <translation>Steigungsfehlerdaten; die Angabe first-record sagt, wo ihre Nummern beginnen</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} for the axis</source>
        <translation>die Nummern {first} bis {last} für die Achse</translation>
    </message>
    <message>
        <source>numbers round that of the reference point, {number}, as the setting {key} says</source>
        <translation>Nummern um die des Referenzpunkts herum, {number}, wie die Angabe {key} sagt</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} of one turn</source>
        <translation>die Nummern {first} bis {last} einer Umdrehung</translation>
    </message>
    <message>
        <source>each number from {first} to {last}; first-number and last-number choose those of one axis</source>
        <translation>jede Nummer von {first} bis {last}; first-number und last-number wählen die einer Achse</translation>
    </message>
    <message>
        <source>at most {most} of an axis, as one source says</source>
        <translation>höchstens {most} einer Achse, wie eine Quelle sagt</translation>
    </message>
    <message>
        <source>the values {first} to {last}, which add up to {sum}</source>
        <translation>die Werte {first} bis {last}, deren Summe {sum} ist</translation>
    </message>
    <message>
        <source>0 over one turn</source>
        <translation>0 über eine Umdrehung</translation>
    </message>
    <message>
        <source>value {number}, of the reference point</source>
        <translation>Wert {number}, der des Referenzpunkts</translation>
    </message>
    <message>
        <source>the same as value {number}, which is the same section</source>
        <translation>derselbe wie Wert {number}, der denselben Abschnitt meint</translation>
    </message>
    <message>
        <source>the setting wrap-range is {turn}, expected 1 to {most} times the interval of {interval}</source>
        <translation>die Angabe wrap-range ist {turn}, erwartet wird das 1- bis {most}-fache des Abstands {interval}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected {least} to {most}</source>
        <translation>die Angabe {key} des Formats {format} ist {value}, erwartet wird {least} bis {most}</translation>
    </message>
    <message>
        <source>wrap-range says which numbers a rotary axis has; leave {key} and {key2} out</source>
        <translation>wrap-range sagt, welche Nummern eine Rundachse hat; {key} und {key2} weglassen</translation>
    </message>
    <message>
        <source>the reference position {position} is no point of it; its points are from {first} to {last}, {distance} apart</source>
        <translation>die Referenzposition {position} ist kein Punkt von ihr; ihre Punkte liegen von {first} bis {last} im Abstand {distance}</translation>
    </message>
    <message>
        <source>resample it with a point there, or check reference-position</source>
        <translation>sie mit einem Punkt dort umrechnen oder reference-position prüfen</translation>
    </message>
    <message>
        <source>its points would get the numbers {first} to {last}</source>
        <translation>ihre Punkte bekämen die Nummern {first} bis {last}</translation>
    </message>
    <message>
        <source>choose a reference-number so that they are from 0 to {most}</source>
        <translation>reference-number so wählen, dass sie von 0 bis {most} gehen</translation>
    </message>
    <message>
        <source>the value {value} is too large</source>
        <translation>der Wert {value} ist zu groß</translation>
    </message>
    <message>
        <source>check detection-unit and the unit of the values</source>
        <translation>detection-unit und die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>its value at the reference position is {value}, and the controller takes it to be 0 there</source>
        <translation>ihr Wert an der Referenzposition ist {value}, und die Steuerung nimmt dort 0 an</translation>
    </message>
    <message>
        <source>from {first} to {last} it changes by {count} increments of {increment}, and a value is at most {most}</source>
        <translation>von {first} bis {last} ändert sie sich um {count} Inkremente zu {increment}, und ein Wert ist höchstens {most}</translation>
    </message>
    <message>
        <source>set magnification={number}, the smallest that fits, or largest-step if the controller takes more</source>
        <translation>magnification={number} setzen, den kleinsten passenden, oder largest-step, wenn die Steuerung mehr annimmt</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}</source>
        <translation>die Parameter der Achse setzen: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}</source>
        <translation>die Parameter der Achse setzen: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}</translation>
    </message>
    <message>
        <source>these are {count} points, and one source says that an axis has at most {most}</source>
        <translation>das sind {count} Punkte, und eine Quelle sagt, dass eine Achse höchstens {most} hat</translation>
    </message>
    <message>
        <source>the sign is an assumption: a value is put out to the axis as pulses. Check one point on the machine</source>
        <translation>das Vorzeichen ist eine Annahme: ein Wert wird als Impulse an die Achse ausgegeben. Einen Punkt an der Maschine prüfen</translation>
    </message>
    <message>
        <source>where within its section a value is put out is not known: the correction is taken to be linear, and its place is in doubt by half an interval</source>
        <translation>wo in seinem Abschnitt ein Wert ausgegeben wird, ist nicht bekannt: die Korrektur wird als linear angenommen, und ihr Ort ist um einen halben Abstand unsicher</translation>
    </message>
    <message>
        <source>after loading switch the power off and on and return to the reference point; alarm PW1102 says that the numbers do not fit</source>
        <translation>nach dem Laden die Versorgung aus- und einschalten und den Referenzpunkt anfahren; der Alarm PW1102 sagt, dass die Nummern nicht passen</translation>
    </message>
    <message>
        <source>parameter {number}, which is {value} for no axis</source>
        <translation>Parameter {number}, der für keine Achse {value} ist</translation>
    </message>
    <message>
        <source>the reference point, numbers and magnification of one axis, as the settings say</source>
        <translation>Referenzpunkt, Nummern und Vergrößerungsfaktor einer Achse, wie in den Einstellungen</translation>
    </message>
    <message>
        <source>parameters 3620 to 3623 of several axes, and numbers {first} to {last}</source>
        <translation>Parameter 3620 bis 3623 mehrerer Achsen und Nummern {first} bis {last}</translation>
    </message>
    <message>
        <source>the numbers of one axis; first-number and last-number choose them</source>
        <translation>die Nummern einer Achse; first-number und last-number wählen sie</translation>
    </message>
    <message>
        <source>shift all values so that it is 0 there; convert does that with --zero</source>
        <translation>alle Werte so verschieben, dass der Wert dort 0 ist; convert tut das mit --zero</translation>
    </message>
    <message>
        <source>{number} to command, to reach {number2}</source>
        <translation>{number} als Sollwert, um {number2} zu erreichen</translation>
    </message>
    <message>
        <source>at most half a range away; a list of corrections is no such file</source>
        <translation>höchstens eine halbe Schrittweite entfernt; eine Liste von Korrekturen ist keine solche Datei</translation>
    </message>
    <message>
        <source>a comment without an end</source>
        <translation>ein Kommentar ohne Ende</translation>
    </message>
    <message>
        <source>{sign} behind it</source>
        <translation>{sign} dahinter</translation>
    </message>
    <message>
        <source>one position and one compensation in each pair of brackets</source>
        <translation>eine Position und eine Kompensation in jedem Klammerpaar</translation>
    </message>
    <message>
        <source>the values for {column} have no unit; they are taken to be in {unit}, as the positions are</source>
        <translation>die Werte für {column} haben keine Einheit; angenommen wird {unit} wie bei den Positionen</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to have no unit; state it in the header, as X [mm], or as the setting {key} of the file that is read</source>
        <translation>die Werte für {column} sind in {unit}, und die Positionen, zu denen sie addiert werden, haben keine Einheit; sie in der Kopfzeile angeben, etwa X [mm], oder als Einstellung {key} der gelesenen Datei</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {before}, as its positions are, and converted to {after}. The largest correction is {largest}.</source>
        <translation>Die Tabelle nennt keine Einheit für ihre Werte; angenommen wird {before} wie bei ihren Positionen, umgerechnet in {after}. Die größte Korrektur ist {largest}.</translation>
    </message>
    <message>
        <source>{name} has several tables of axis {axis}; which of them was active has to be said by its CRC, in the file of the measurement (// compensation: crc:{crc})</source>
        <translation>{name} hat mehrere Tabellen der Achse {axis}; welche davon aktiv war, muss ihre CRC in der Messdatei sagen (// compensation: crc:{crc})</translation>
    </message>
    <message>
        <source>{name} has several tables, none of which says its axis, so that it is not known which of them is meant: take a file with that table alone</source>
        <translation>{name} hat mehrere Tabellen, von denen keine ihre Achse nennt, sodass nicht bekannt ist, welche gemeint ist: eine Datei nehmen, die nur diese Tabelle enthält</translation>
    </message>
    <message>
        <source>{name} has several tables, and which of them is meant is not known: state the axis as it is called there (--target, or // axis: in the file of the measurement; there are: {axes}), or take a file with that table alone</source>
        <translation>{name} hat mehrere Tabellen, und welche gemeint ist, ist nicht bekannt: die Achse so angeben, wie sie dort heißt (--target, oder // axis: in der Messdatei; vorhanden: {axes}), oder eine Datei nehmen, die nur diese Tabelle enthält</translation>
    </message>
    <message>
        <source>the targets go from {from} to {to}, which is more than a turn of {turn}: give the length of the whole turn (--turn), or leave out what lies in a second one (--exclude)</source>
        <translation>die Zielpositionen reichen von {from} bis {to}, das ist mehr als eine Umdrehung von {turn}: geben Sie die Länge der ganzen Umdrehung an (--turn), oder lassen Sie weg, was in einer zweiten liegt (--exclude)</translation>
    </message>
    <message>
        <source>positions with a decimal point and blanks between them; without a Target-count nobody can tell two positions from one with a decimal comma</source>
        <translation>Positionen mit Dezimalpunkt und Leerzeichen dazwischen; ohne Target-count lassen sich zwei Positionen nicht von einer mit Dezimalkomma unterscheiden</translation>
    </message>
    <message>
        <source>{found} targets, but deviations of {used}</source>
        <translation>{found} Zielpositionen, aber Abweichungen von {used}</translation>
    </message>
    <message>
        <source>a deviation of every target, or a Target-count</source>
        <translation>eine Abweichung jeder Zielposition, oder ein Target-count</translation>
    </message>
    <message>
        <source>positions of targets that rise or fall throughout, with a decimal point and blanks between them</source>
        <translation>Zielpositionen, die durchgehend steigen oder fallen, mit Dezimalpunkt und Leerzeichen dazwischen</translation>
    </message>
    <message>
        <source>every run goes {direction}, in a file of both directions (Flags: 0 0 2 0)</source>
        <translation>jeder Durchlauf geht {direction}, in einer Datei mit beiden Richtungen (Flags: 0 0 2 0)</translation>
    </message>
    <message>
        <source>the lines of each run in the order in which they were measured; sorted by target they all seem to rise</source>
        <translation>die Zeilen jedes Durchlaufs in der Reihenfolge, in der gemessen wurde; nach Zielposition sortiert scheinen alle zu steigen</translation>
    </message>
    <message>
        <source>the file does not say whether its values are corrected to 20 deg C already; if they are not, that has to be stated (--not-corrected)</source>
        <translation>die Datei sagt nicht, ob ihre Werte schon auf 20 °C korrigiert sind; wenn nicht, muss das angegeben werden (--not-corrected)</translation>
    </message>
    <message>
        <source>file {second} holds the same measurement as file {first}, value by value: give it once</source>
        <translation>Datei {second} enthält dieselbe Messung wie Datei {first}, Wert für Wert: nur einmal angeben</translation>
    </message>
    <message>
        <source>some of the files say otherwise than the others, or do not say, whether their values are corrected to 20 deg C, so that no correction would be right for all; say it in each of them (// corrected: 20C, or // corrected: none), or take those alone that agree</source>
        <translation>die Dateien sagen nicht alle gleich oder gar nicht, ob ihre Werte auf 20 °C korrigiert sind, sodass keine Korrektur für alle richtig wäre; in jeder angeben (// corrected: 20C oder // corrected: none), oder nur die nehmen, die übereinstimmen</translation>
    </message>
    <message>
        <source>the drive is taken to look the table up before the compensation, at the position of the encoder; at the set position (lookup: set) its corrections would differ by up to {largest}</source>
        <translation>angenommen ist, dass der Antrieb vor der Kompensation nachschlägt, an der Position des Gebers; an der Sollposition (lookup: set) wären die Korrekturen um bis zu {largest} anders</translation>
    </message>
    <message>
        <source>where a table is looked up (--lookup-at) is said of a table of the drive, and neither {from} nor {to} is one</source>
        <translation>wo der Antrieb nachschlägt (--lookup-at), wird von einer Tabelle des Antriebs gesagt, und weder {from} noch {to} ist eine</translation>
    </message>
    <message>
        <source>the file does not say where the drive looks its table up: in a calibration file add the line // lookup: encoder or // lookup: set</source>
        <translation>die Datei sagt nicht, wo der Antrieb in ihrer Tabelle nachschlägt: in einer Kalibrierdatei die Zeile // lookup: encoder oder // lookup: set ergänzen</translation>
    </message>
    <message>
        <source>the table is made for a drive that looks it up after the compensation, at the set position (lookup: set)</source>
        <translation>die Tabelle ist für einen Antrieb, der nach der Kompensation nachschlägt, an der Sollposition (lookup: set)</translation>
    </message>
    <message>
        <source>the values are converted from those that the drive looks up after the compensation, at the set position (lookup: set)</source>
        <translation>die Werte sind aus denen umgerechnet, die der Antrieb nach der Kompensation nachschlägt, an der Sollposition (lookup: set)</translation>
    </message>
    <message>
        <source>the file of the table says lookup: {file}, and stated is {stated} (--lookup-at): correct the one that is wrong</source>
        <translation>die Datei der Tabelle sagt lookup: {file}, und angegeben ist {stated} (--lookup-at): das Falsche von beiden korrigieren</translation>
    </message>
    <message>
        <source>while {name} was active the sources of the axis were others, so that its values may belong to other positions: measure again with what the axis has now</source>
        <translation>während {name} aktiv war, hatte die Achse andere Quellen, sodass die Werte zu anderen Positionen gehören können: noch einmal mit dem messen, was die Achse jetzt hat</translation>
    </message>
    <message>
        <source>The table stays, and its new source is on the other side of the compensation: its values belong to other positions. Write the table that was made for this source.</source>
        <translation>Die Tabelle bleibt, und ihre neue Quelle liegt auf der anderen Seite der Kompensation: Ihre Werte gehören zu anderen Positionen. Schreiben Sie die Tabelle, die für diese Quelle erstellt wurde.</translation>
    </message>
    <message>
        <source>the plan is in {planned}, and axis {axis} of the drive in {unit}: make a plan in {needed}, or choose another axis</source>
        <translation>der Messplan ist in {planned} und Achse {axis} des Antriebs in {unit}: einen Plan in {needed} machen oder eine andere Achse wählen</translation>
    </message>
    <message>
        <source>The table that no axis used in {slot} is not restored: the table of this axis is there.</source>
        <translation>Die Tabelle in {slot}, die keine Achse verwendet hat, wird nicht wiederhergestellt: dort ist die Tabelle dieser Achse.</translation>
    </message>
    <message>
        <source>the values for {column} are said to be in the unit of the drive, and the positions that they are added to are in {unit}; state the unit of the values, or that the positions are in that of the drive, too</source>
        <translation>die Werte für {column} sollen in der Einheit des Antriebs sein, und die Positionen, zu denen sie addiert werden, sind in {unit}; die Einheit der Werte angeben, oder dass auch die Positionen in der des Antriebs sind</translation>
    </message>
    <message>
        <source>{name} = {value}, which multiplies the table on the control</source>
        <translation>{name} = {value}, womit die Steuerung die Tabelle multipliziert</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply the values by the number (--scale)</source>
        <translation>1; die Zeile entfernen und die Werte mit der Zahl multiplizieren (--scale)</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, which cannot be given in {other}, the unit of the positions that they are added to; correct the units</source>
        <translation>die Werte für {column} sind in {unit}, was sich nicht in {other} umrechnen lässt, die Einheit der Positionen, zu denen sie addiert werden; die Einheiten berichtigen</translation>
    </message>
    <message>
        <source>{name} does not say the unit of its numbers, and its CRC-32 {crc} is the same in mm and in m, in degrees and in radians: take a calibration file in whose header the units stand, such as the one that reading the table from the drive writes</source>
        <translation>{name} sagt nicht, in welcher Einheit die Zahlen sind, und der CRC-32 {crc} ist in mm und m, in Grad und Radiant derselbe: nehmen Sie eine Kalibrierdatei, in deren Kopfzeile die Einheiten stehen, etwa die, die beim Lesen der Tabelle aus dem Antrieb entsteht</translation>
    </message>
    <message>
        <source>the axis had other sources with {name}, so that its values may belong to other positions: merge onto nothing (leave out --onto), since with the raw positions on file the values are the whole error</source>
        <translation>mit {name} hatte die Achse andere Quellen, sodass deren Werte zu anderen Positionen gehören können: in keine Tabelle einrechnen (--onto weglassen), denn mit den Rohpositionen in der Datei sind die Werte der ganze Fehler</translation>
    </message>
    <message>
        <source>a gain is for residuals that are merged onto a table (--onto); here the values are the whole error</source>
        <translation>ein Faktor ist für Restabweichungen, die in eine Tabelle eingerechnet werden (--onto); hier sind die Werte der ganze Fehler</translation>
    </message>
    <message>
        <source>{name} is a table over {axes}, but what was measured is over {measured}: take a table over the same axes, in the same order</source>
        <translation>{name} ist eine Tabelle über {axes}, gemessen wurde aber über {measured}: nehmen Sie eine Tabelle über denselben Achsen, in derselben Reihenfolge</translation>
    </message>
    <message>
        <source>what was measured along one axis needs a table of one dimension; {name} has {dimensions}</source>
        <translation>was entlang einer Achse gemessen wurde, braucht eine Tabelle von einer Dimension; {name} hat {dimensions}</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} is of axis {axis}: take the table of the axis that was measured</source>
        <translation>gemessen wurde Achse {measured}, {name} gehört aber zu Achse {axis}: nehmen Sie die Tabelle der Achse, die gemessen wurde</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} corrects an axis that is no source: take the table of the axis that was measured, or state what the values correct (--target other)</source>
        <translation>gemessen wurde Achse {measured}, {name} korrigiert aber eine Achse, die keine Quelle ist: nehmen Sie die Tabelle der Achse, die gemessen wurde, oder geben Sie an, was die Werte korrigieren (--target other)</translation>
    </message>
    <message>
        <source>nothing is merged over temperature: leave out --onto, since with the raw positions on file the values are the whole error</source>
        <translation>über der Temperatur wird nichts eingerechnet: --onto weglassen, denn mit den Rohpositionen in der Datei sind die Werte der ganze Fehler</translation>
    </message>
    <message>
        <source>a unit that is not stated</source>
        <translation>einer Einheit, die nicht angegeben ist</translation>
    </message>
    <message>
        <source>a time in s, ms, min or h, in brackets behind the name; without a unit it is in s</source>
        <translation>eine Zeit in s, ms, min oder h, in Klammern hinter dem Namen; ohne Einheit ist sie in s</translation>
    </message>
    <message>
        <source>a temperature in C, K or F, in brackets behind the name; without a unit it is in C</source>
        <translation>eine Temperatur in C, K oder F, in Klammern hinter dem Namen; ohne Einheit ist sie in C</translation>
    </message>
    <message>
        <source>an angle as the first axis has</source>
        <translation>ein Winkel wie bei der ersten Achse</translation>
    </message>
    <message>
        <source>a length as the first axis has</source>
        <translation>eine Länge wie bei der ersten Achse</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>Positionen der Referenz</translation>
    </message>
    <message>
        <source>deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>what --values says; leave it out, since the file says it</source>
        <translation>was --values sagt; lassen Sie es weg, denn die Datei sagt es selbst</translation>
    </message>
    <message>
        <source>positions of the reference for --invert-reference; deviations with the opposite sign say it in the file (// sign: correction)</source>
        <translation>Positionen der Referenz für --invert-reference; für Abweichungen mit umgekehrtem Vorzeichen steht das in der Datei (// sign: correction)</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the position</source>
        <translation>Werte, die mit der Position um {slope} steigen</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for all of these changes, {together}, but not for putting everything back if one fails; wait {seconds} s, or make fewer changes at a time</source>
        <translation>die übrigen Flash-Vorgänge reichen für alle diese Änderungen, {together}, aber nicht, um nach einem Fehlschlag alles zurückzustellen; {seconds} s warten oder weniger auf einmal ändern</translation>
    </message>
    <message>
        <source>together these changes cost {together} flash operations, more than are possible now; wait {seconds} s, or make fewer changes at a time</source>
        <translation>diese Änderungen kosten zusammen {together} Flash-Vorgänge, mehr als jetzt möglich sind; {seconds} s warten oder weniger auf einmal ändern</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or, if it is right all the same, name the column after axis {axis} in the file</source>
        <translation>{doubt} Wählen Sie eine andere Quelle oder Spalte, oder benennen Sie, wenn es trotzdem stimmt, die Spalte in der Datei nach der Achse {axis}</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the backup was made, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>Achse {axis} hieß {target}, als die Sicherung entstand, und heißt im Antrieb jetzt {name}; geben Sie den Achsen die Reihenfolge oder die Namen von damals oder schreiben Sie die Tabelle aus ihrer Datei</translation>
    </message>
    <message>
        <source>the {what} of the table on the drive are in {unit}, and the new source is in {other}; write the table from its file, together with the source</source>
        <translation>die {what} der Tabelle im Antrieb sind in {unit}, und die neue Quelle ist in {other}; schreiben Sie die Tabelle zusammen mit der Quelle aus ihrer Datei</translation>
    </message>
    <message>
        <source>the {what} are in {unit} in the backup, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>die {what} sind in der Sicherung in {unit}, und der Antrieb hat sie jetzt in {other}, sodass dieselben Zahlen etwas anderes bedeuten würden; stellen Sie die Einheit im Antrieb wieder auf {unit} oder schreiben Sie die Tabelle aus ihrer Datei</translation>
    </message>
    <message>
        <source>The table states no unit for the positions of dimension {number}; they are taken to be in {after}: {first} to {last}.</source>
        <translation>Die Tabelle gibt für die Positionen der Dimension {number} keine Einheit an; angenommen wird {after}: {first} bis {last}.</translation>
    </message>
    <message>
        <source>values of axis {axis}</source>
        <translation>Werte der Achse {axis}</translation>
    </message>
    <message>
        <source>positions of dimension {number} of axis {axis}</source>
        <translation>Positionen der Dimension {number} der Achse {axis}</translation>
    </message>
    <message>
        <source>Axis {axis} was called {before} when the backup was made, and is called {after} now: see that it is the same axis.</source>
        <translation>Achse {axis} hieß {before}, als die Sicherung entstand, und heißt jetzt {after}: vergewissern Sie sich, dass es dieselbe Achse ist.</translation>
    </message>
    <message>
        <source>The backup does not say in which unit axis {axis} was; its table is taken to be in {unit}.</source>
        <translation>Die Sicherung sagt nicht, in welcher Einheit Achse {axis} war; ihre Tabelle wird in {unit} angenommen.</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are written in {unit} as they stand: the profile does not say the unit of {source}.</source>
        <translation>Die Positionen der Dimension {number} werden unverändert in {unit} geschrieben: das Profil nennt die Einheit von {source} nicht.</translation>
    </message>
    <message>
        <source>axis {axis}, which is written first</source>
        <translation>Achse {axis}, die vorher geschrieben wird</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the numbers of the file were read in {unit}; leave the statement out</source>
        <translation>angegeben ist die Einheit {stated}, und die Zahlen der Datei sind in {unit} gelesen; die Angabe weglassen</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: it is not activated. Finish that write with &apos;axiscomp recover --finish&apos;, undo it with &apos;axiscomp recover --undo&apos;, or write again. The old state is kept in {backup}</source>
        <translation>ein Schreibvorgang, der nicht zu Ende kam, hat Achse {axis} weder im alten noch im neuen Zustand hinterlassen: sie wird nicht aktiviert. Den Schreibvorgang mit &apos;axiscomp recover --finish&apos; vollenden, mit &apos;axiscomp recover --undo&apos; rückgängig machen, oder neu schreiben. Der alte Zustand ist aufbewahrt in {backup}</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as http://user:password@host</source>
        <translation>{endpoint} verlangt Benutzername und Passwort; anzugeben als http://benutzer:passwort@host</translation>
    </message>
    <message>
        <source>{text} has no unit and is taken as {amount}, {fine}</source>
        <translation>{text} hat keine Einheit; angenommen wird {amount}, also {fine}</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as https://user:password@host</source>
        <translation>{endpoint} verlangt Benutzername und Passwort; anzugeben als https://benutzer:passwort@host</translation>
    </message>
    <message>
        <source>{path} is no position of axis {axis} before its compensation: name the register of its encoder</source>
        <translation>{path} ist keine Position der Achse {axis} vor ihrer Kompensation: das Register ihres Gebers nennen</translation>
    </message>
    <message>
        <source>&quot;{name}&quot;, which is taken to be a name without a unit</source>
        <translation>„{name}“, als Name ohne Einheit aufgefasst</translation>
    </message>
    <message>
        <source>a unit such as mm, um, inch, deg or arcsec, if {unit} is meant as one</source>
        <translation>eine Einheit wie mm, um, inch, deg oder arcsec, falls {unit} eine sein soll</translation>
    </message>
    <message>
        <source>decimal points, and blanks between the numbers; nobody can tell a decimal comma from one that separates two numbers</source>
        <translation>Dezimalpunkte und Leerzeichen zwischen den Zahlen; ein Dezimalkomma lässt sich nicht von einem Komma zwischen zwei Zahlen unterscheiden</translation>
    </message>
    <message>
        <source>{key} without a value, or no {key}</source>
        <translation>{key} ohne Wert, oder kein {key}</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>eine Zahl mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>several tables of {axes}</source>
        <translation>mehrere Tabellen von {axes}</translation>
    </message>
    <message>
        <source>their sum, since the controller adds them; a table that is converted alone is a part of it</source>
        <translation>ihre Summe, da die Steuerung sie addiert; eine einzeln umgewandelte Tabelle ist nur ein Teil davon</translation>
    </message>
    <message>
        <source>&quot;{statement}&quot;, which switches a table of the file off</source>
        <translation>„{statement}“ schaltet eine Tabelle der Datei ab</translation>
    </message>
    <message>
        <source>tables that are in use; this one does not act on the machine</source>
        <translation>Tabellen, die in Gebrauch sind; diese wirkt nicht auf die Maschine</translation>
    </message>
    <message>
        <source>one unit for positions and offsets, which the controller adds; a calibration file is read with --from {format}</source>
        <translation>eine Einheit für Positionen und Offsets, die die Steuerung addiert; eine Kalibrierdatei wird mit --from {format} gelesen</translation>
    </message>
    <message>
        <source>{count} lines that are taken to be headers, the first of them &quot;{line}&quot;</source>
        <translation>{count} Zeilen, die als Kopfzeilen gelten, die erste davon „{line}“</translation>
    </message>
    <message>
        <source>decimal points, and a comma with a blank between the values; nobody can tell a decimal comma from one that separates two values</source>
        <translation>Dezimalpunkte, und zwischen den Werten ein Komma mit Leerzeichen; ein Dezimalkomma lässt sich nicht von einem Komma zwischen zwei Werten unterscheiden</translation>
    </message>
    <message>
        <source>numbers in {unit}, as the file says</source>
        <translation>Zahlen in {unit}, wie die Datei sagt</translation>
    </message>
    <message>
        <source>{unit}, as the setting says</source>
        <translation>{unit}, wie die Einstellung sagt</translation>
    </message>
    <message>
        <source>{name}, which is changed by a statement of the program</source>
        <translation>{name}, durch eine Anweisung des Programms geändert</translation>
    </message>
    <message>
        <source>the declaration alone; the table is that of the declaration, since statements are not computed</source>
        <translation>nur die Deklaration; die Tabelle ist die der Deklaration, da Anweisungen nicht berechnet werden</translation>
    </message>
    <message>
        <source>axis {axis}, and axis {before} in line {line}</source>
        <translation>Achse {axis}, und Achse {before} in Zeile {line}</translation>
    </message>
    <message>
        <source>the measurement of one axis; make a file for each axis</source>
        <translation>die Messung einer Achse; für jede Achse eine Datei anlegen</translation>
    </message>
    <message>
        <source>{second}, and {first} in line {line}</source>
        <translation>{second}, und {first} in Zeile {line}</translation>
    </message>
    <message>
        <source>one statement of it</source>
        <translation>eine Angabe dazu</translation>
    </message>
    <message>
        <source>this statement before the header, since it holds for every line</source>
        <translation>diese Angabe vor der Kopfzeile, da sie für alle Zeilen gilt</translation>
    </message>
    <message>
        <source>further sections behind EOF::</source>
        <translation>weitere Abschnitte hinter EOF::</translation>
    </message>
    <message>
        <source>one measurement in a file; make a file of each</source>
        <translation>eine Messung in einer Datei; aus jeder eine eigene Datei machen</translation>
    </message>
    <message>
        <source>which it is: // values: deviation or // values: reference before the header, or --values</source>
        <translation>was davon: // values: deviation oder // values: reference vor der Kopfzeile, oder --values</translation>
    </message>
    <message>
        <source>axis {axis} of the machine file</source>
        <translation>Achse {axis} der Maschinendatei</translation>
    </message>
    <message>
        <source>a position and an error in mm, with decimal points and without separators of thousands</source>
        <translation>eine Position und eine Abweichung in mm, mit Dezimalpunkten und ohne Tausendertrennzeichen</translation>
    </message>
    <message>
        <source>a position without a forward mean</source>
        <translation>eine Position ohne Mittelwert in Vorwärtsrichtung</translation>
    </message>
    <message>
        <source>for a run its direction and number, such as up2 or down1</source>
        <translation>für einen Durchlauf dessen Richtung und Nummer, zum Beispiel up2 oder down1</translation>
    </message>
    <message>
        <source>sign: feedback or sign: command; where the values are encoder minus reference, leave the line out, and turn them with --scale -1</source>
        <translation>sign: feedback oder sign: command; sind die Werte Geber minus Referenz, die Zeile weglassen und sie mit --scale -1 umkehren</translation>
    </message>
    <message>
        <source>the table states no unit for its values, and its positions are in {positions}; state the unit of the values, in the file or with --value-unit</source>
        <translation>die Tabelle gibt keine Einheit für ihre Werte an, und ihre Positionen sind in {positions}; die Einheit der Werte in der Datei oder mit --value-unit angeben</translation>
    </message>
    <message>
        <source>the values for {column} have no unit, and the positions are in {positions}; state it in the header, as Z [mm], or as the setting {key} of the file that is read</source>
        <translation>die Werte für {column} haben keine Einheit, und die Positionen sind in {positions}; sie in der Kopfzeile angeben, etwa Z [mm], oder als Einstellung {key} der gelesenen Datei</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. The positions have different units, and it is not stated which one that is: convert to a .csv file first, and that one with --value-unit, such as --value-unit mm, or, if the values correct the axis of one of the positions, state the target, such as #1 for the first</source>
        <translation>eine .TAMtbl hat keine Einheiten, und ein Antrieb nimmt ihre Werte in der Einheit der Achse, die sie korrigieren. Die Positionen haben verschiedene Einheiten, und es ist nicht angegeben, welche davon das ist: erst in eine .csv-Datei konvertieren und diese mit --value-unit, etwa --value-unit mm, oder, wenn die Werte die Achse einer der Positionen korrigieren, die Zielachse angeben, etwa #1 für die erste</translation>
    </message>
    <message>
        <source>{number} in a column with {whole}</source>
        <translation>{number} in einer Spalte mit {whole}</translation>
    </message>
    <message>
        <source>numbers that show whether the point stands between thousands: no point in {number}, or the same decimals in {whole}</source>
        <translation>Zahlen, an denen zu sehen ist, ob der Punkt zwischen Tausendern steht: {number} ohne Punkt, oder dieselben Nachkommastellen in {whole}</translation>
    </message>
    <message>
        <source>the axis is taken to count from {from} to {to}, and steps of {distance} do not lead from one end over the targets to the other; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>angenommen wird, dass die Achse von {from} bis {to} zählt, und Schritte von {distance} führen nicht von einem Ende über die Zielpositionen zum anderen; geben Sie das Gitter der Tabelle an: die Stützstellen, ihren Abstand oder die erlaubte Abweichung von der Kurve (--points, --distance oder --within)</translation>
    </message>
    <message>
        <source>the table in {slot} stays in flash, because {user} uses it too; free it there first, with a persistent write into another slot</source>
        <translation>die Tabelle in {slot} bleibt im Flash, weil sie noch anderswo verwendet wird ({user}); geben Sie sie dort zuerst frei, indem Sie dort dauerhaft in einen anderen Tabellenplatz schreiben</translation>
    </message>
    <message>
        <source>Flash keeps the table in {slot}: after a reboot {axis} uses it again. Delete the table first (&apos;axiscomp delete&apos;) if it must not come back.</source>
        <translation>Die Tabelle in {slot} bleibt im Flash: nach einem Neustart verwendet {axis} sie wieder. Wenn sie nicht wiederkommen darf, löschen Sie die Tabelle zuerst (&apos;axiscomp delete&apos;).</translation>
    </message>
    <message>
        <source>the axis has the values of the record&apos;s table, {crc}, over other positions: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>die Achse hat die Werte der Tabelle des Protokolls, {crc}, über anderen Positionen: die Tabelle des Protokolls noch einmal schreiben („axiscomp write --record“) oder das Protokoll weglassen</translation>
    </message>
    <message>
        <source>The table stays, and {source} is a position of another axis: its values belong to positions of the axis itself. Write the table that was made for this source.</source>
        <translation>Die Tabelle bleibt, und {source} ist eine Position einer anderen Achse: Ihre Werte gehören zu Positionen der Achse selbst. Schreiben Sie die Tabelle, die für diese Quelle erstellt wurde.</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, and {first} and {second} have the same values over other positions: merge onto the file of the one that was active (--onto)</source>
        <translation>während der Messung war die Tabelle {crc} aktiv, und {first} und {second} haben dieselben Werte über verschiedenen Positionen: in die Datei der Tabelle einrechnen, die aktiv war (--onto)</translation>
    </message>
    <message>
        <source>{axis} is the name of axis {named} and the index of axis {numbered}; say name:{axis} or {index}</source>
        <translation>{axis} ist der Name von Achse {named} und der Index von Achse {numbered}; name:{axis} oder {index} angeben</translation>
    </message>
    <message>
        <source>there is no name on the drive</source>
        <translation>auf dem Antrieb steht kein Name</translation>
    </message>
    <message>
        <source>the program must define the target axes of the table in the order of the corrections: {axes}</source>
        <translation>das Programm muss die Zielachsen der Tabelle in der Reihenfolge der Korrekturen definieren: {axes}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} says {value}, and the table goes from {column}</source>
        <translation>die Einstellung {key} des Formats {format} sagt {value}, und die Tabelle geht von {column}</translation>
    </message>
    <message>
        <source>positions with {all} combinations in the first {count} data lines</source>
        <translation>Positionen mit {all} Kombinationen in den ersten {count} Datenzeilen</translation>
    </message>
    <message>
        <source>a line for every combination of the positions; fit makes a table of scattered points</source>
        <translation>eine Zeile für jede Kombination der Positionen; fit macht aus verstreuten Punkten eine Tabelle</translation>
    </message>
    <message>
        <source>the first measurement is corrected and the second is not, so that they cannot be compared: save the record and correct the second one with `axiscomp compare --record`, or state in its file that its values are at 20 °C (// corrected: 20C)</source>
        <translation>die erste Messung ist korrigiert, die zweite nicht, so dass sie sich nicht vergleichen lassen: Protokoll speichern und die zweite mit „axiscomp compare --record“ korrigieren oder in ihrer Datei angeben, dass ihre Werte bei 20 °C gelten (// corrected: 20C)</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; can be read in two ways; write thousands without a sign between them</source>
        <translation>„{text}“ lässt sich auf zwei Arten lesen; Tausender ohne Zeichen dazwischen schreiben</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. These are in {unit} and the positions in {positions}, none of which is that of the axis for certain: convert to a .csv file first, and that one with --value-unit and the unit of the axis, such as --value-unit {example}</source>
        <translation>eine .TAMtbl hat keine Einheiten, und ein Antrieb nimmt ihre Werte in der Einheit der Achse, die sie korrigieren. Diese sind in {unit} und die Positionen in {positions}, und nichts davon ist sicher die Einheit der Achse: zuerst in eine .csv-Datei umwandeln und diese mit --value-unit und der Einheit der Achse, zum Beispiel --value-unit {example}</translation>
    </message>
    <message>
        <source>sign: correction, and positions of the reference</source>
        <translation>sign: correction, und Positionen der Referenz</translation>
    </message>
    <message>
        <source>no sign with positions of the reference, which are what they are; or deviations with their sign</source>
        <translation>kein Vorzeichen bei Positionen der Referenz, die sind, was sie sind; oder Abweichungen mit ihrem Vorzeichen</translation>
    </message>
    <message>
        <source>the two directions of the track have no part of the way in common: make the table of one of them (--direction positive or negative)</source>
        <translation>die beiden Richtungen der Bahn haben kein gemeinsames Wegstück: die Tabelle aus einer von ihnen machen (--direction positive oder negative)</translation>
    </message>
    <message>
        <source>the table is looked up at the desired position of its sources (D); with position=actual at the actual one</source>
        <translation>die Tabelle wird bei der Sollposition ihrer Quellachsen nachgeschlagen (D); mit position=actual bei der Istposition</translation>
    </message>
    <message>
        <source>the table is looked up at the actual position of its sources; with position=desired at the desired one (D)</source>
        <translation>die Tabelle wird bei der Istposition ihrer Quellachsen nachgeschlagen; mit position=desired bei der Sollposition (D)</translation>
    </message>
    <message>
        <source>max_points {number} of the source is left out: the table has {count} points</source>
        <translation>max_points {number} der Quelle wird weggelassen: die Tabelle hat {count} Punkte</translation>
    </message>
    <message>
        <source>the encoder moves {slope} times as far as the targets</source>
        <translation>der Geber bewegt sich {slope}-mal so weit wie die Zielpositionen</translation>
    </message>
    <message>
        <source>1 within 1 %; correct the column of the encoder, or take it out of the file</source>
        <translation>1 auf 1 % genau; berichtigen Sie die Spalte des Gebers oder nehmen Sie sie aus der Datei heraus</translation>
    </message>
    <message>
        <source>columns separated by , or ; instead of tabs</source>
        <translation>durch , oder ; statt durch Tabulatoren getrennte Spalten</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: what can be read of it is half of that write. Finish it with &apos;axiscomp recover --finish&apos;, or undo it with &apos;axiscomp recover --undo&apos;. The old state is kept in {backup}</source>
        <translation>ein Schreibvorgang, der nicht zu Ende kam, hat Achse {axis} weder im alten noch im neuen Zustand hinterlassen: was sich von ihr lesen lässt, ist ein halber Schreibvorgang. Diesen mit &apos;axiscomp recover --finish&apos; vollenden oder mit &apos;axiscomp recover --undo&apos; rückgängig machen. Der alte Zustand ist aufbewahrt in {backup}</translation>
    </message>
    <message>
        <source>the name of the table, {table}, says that its values correct {target}, but for axis {axis} {role}; choose another table or axis, or, if it is right all the same, write the table to this axis from its file first, and state the target as {statement} there</source>
        <translation>laut ihrem Namen ({table}) korrigieren die Werte der Tabelle {target}, aber bei Achse {axis} gilt: {role}; andere Tabelle oder Achse wählen oder, wenn es dennoch stimmt, die Tabelle zuerst aus ihrer Datei auf diese Achse schreiben und dabei die Zielachse als {statement} angeben</translation>
    </message>
    <message>
        <source>mm, or both units stated: that of the positions (--unit) and that of the errors (--value-unit)</source>
        <translation>mm, oder beide Einheiten angegeben: die der Positionen (--unit) und die der Fehler (--value-unit)</translation>
    </message>
    <message>
        <source>kind: runs, or kind: averages (means of runs)</source>
        <translation>kind: runs oder kind: averages (Mittelwerte von Durchläufen)</translation>
    </message>
    <message>
        <source>one mean for each target and direction</source>
        <translation>ein Mittelwert für jede Zielposition und jede Richtung</translation>
    </message>
    <message>
        <source>the second measurement is of the drive with the serial number {found}, and the first one or its table is of the one with {known}; measure that drive, or, where it was replaced since, correct the line // drive: in the file of the second</source>
        <translation>die zweite Messung ist von dem Antrieb mit der Seriennummer {found}, und die erste oder ihre Tabelle von dem mit {known}; diesen Antrieb messen, oder, wenn er seitdem ersetzt wurde, in der Datei der zweiten die Zeile // drive: berichtigen</translation>
    </message>
    <message>
        <source>measurements of the drive with the serial number {drive} and of the one with {other} cannot be joined; take those of one drive, and where it was replaced in between, correct the line // drive: of the files</source>
        <translation>Messungen des Antriebs mit der Seriennummer {drive} und dessen mit {other} lassen sich nicht zusammenfügen; die eines Antriebs nehmen, und wenn er dazwischen ersetzt wurde, die Zeile // drive: der Dateien berichtigen</translation>
    </message>
    <message>
        <source>the record was made of a measurement of the drive with the serial number {measured}, and this is {found}; connect the drive that was measured, or, where it was replaced since, correct the line // drive: of the measurement&apos;s file and begin a new record with it</source>
        <translation>das Protokoll entstand aus einer Messung des Antriebs mit der Seriennummer {measured}, und dies ist {found}; den gemessenen Antrieb verbinden, oder, wenn er seitdem ersetzt wurde, in der Datei der Messung die Zeile // drive: berichtigen und damit ein neues Protokoll beginnen</translation>
    </message>
    <message>
        <source>axis {axis} used {slot}, and the file of this slot is missing</source>
        <translation>Achse {axis} hat {slot} benutzt, und die Datei dieses Tabellenplatzes fehlt</translation>
    </message>
    <message>
        <source>the deletion of {slot} for axis {axis} can only be finished: the saved parameters that would bring its table back after a reboot are not known; the backup has the table</source>
        <translation>das Löschen von {slot} für Achse {axis} lässt sich nur abschließen: die gespeicherten Parameter, die seine Tabelle nach einem Neustart zurückbrächten, sind nicht bekannt; die Sicherung hat die Tabelle</translation>
    </message>
    <message>
        <source>the line // drive: of the file says that the drive with the serial number {expected} was measured, and this one has {found}: connect that drive, or, where it was replaced since, correct the line or remove it</source>
        <translation>laut der Zeile // drive: der Datei wurde der Antrieb mit der Seriennummer {expected} gemessen, und der verbundene hat {found}: den gemessenen Antrieb verbinden, oder, wenn er seitdem ersetzt wurde, die Zeile berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, and another of its comments the serial number {serial}: a table is made of the measurement of one drive, so correct the wrong line, or leave it out</source>
        <translation>in der Datei steht „{note}“ und in einem anderen Kommentar die Seriennummer {serial}: eine Tabelle entsteht aus der Messung eines einzigen Antriebs, also die falsche Zeile berichtigen oder weglassen</translation>
    </message>
    <message>
        <source>the drive does not read the table in {slot} as the layout of the profile has it: of dimension {dimension} the drive shows {found} where the layout has {expected}. Compare {layout} in the profile with the drive&apos;s table file</source>
        <translation>der Antrieb liest die Tabelle in {slot} anders, als es der Tabellenaufbau des Profils sagt: Für Dimension {dimension} zeigt der Antrieb {found}, der Aufbau hat dort {expected}. {layout} im Profil mit der Tabellendatei des Antriebs vergleichen</translation>
    </message>
    <message>
        <source>dimension {number} of the table on the drive is one of {before}, and {source} is something else: one of them is a position, the other a temperature; write the table from its file, together with the source</source>
        <translation>Dimension {number} der Tabelle im Antrieb gehört zu {before}, und {source} ist etwas anderes: Das eine ist eine Position, das andere eine Temperatur; schreiben Sie die Tabelle zusammen mit der Quelle aus ihrer Datei</translation>
    </message>
    <message>
        <source>The table stays, its dimension {number} has positions of an axis, and the profile does not say what {source} is. Write the table that was made for this source.</source>
        <translation>Die Tabelle bleibt, ihre Dimension {number} hat Positionen einer Achse, und das Profil sagt nicht, was {source} ist. Schreiben Sie die Tabelle, die für diese Quelle erstellt wurde.</translation>
    </message>
    <message>
        <source>The backup of axis {axis} does not say with which profile it was made; its table is read with the profile {profile}.</source>
        <translation>Die Sicherung von Achse {axis} sagt nicht, mit welchem Profil sie erstellt wurde; ihre Tabelle wird mit dem Profil {profile} gelesen.</translation>
    </message>
    <message>
        <source>the backup was made with the profile {before}, which has another layout of table files than {profile}: restore it with that profile (--profile), or, on a drive that needs the other one, write the table from its file</source>
        <translation>die Sicherung wurde mit dem Profil {before} erstellt, das einen anderen Aufbau der Tabellendateien hat als {profile}: mit jenem Profil wiederherstellen (--profile) oder, bei einem Antrieb, der das andere braucht, die Tabelle aus ihrer Datei schreiben</translation>
    </message>
    <message>
        <source>The layout of table files in the profile {profile} has been changed since the backup was made: see that the table is right.</source>
        <translation>Der Aufbau der Tabellendateien im Profil {profile} wurde geändert, seit die Sicherung erstellt wurde: Prüfen Sie, ob die Tabelle stimmt.</translation>
    </message>
    <message>
        <source>the register {path} is in {name} too</source>
        <translation>das Register {path} steht auch in {name}</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}, and an import does not move a table from one axis to another: write the table to axis {imported} from its file, and name the slot that it gets there in the configuration</source>
        <translation>Tabellenplatz {slot} ist belegt durch {user}, und ein Import verschiebt keine Tabelle von einer Achse zu einer anderen: die Tabelle aus ihrer Datei auf Achse {imported} schreiben und den Tabellenplatz, den sie dort erhält, in der Konfiguration angeben</translation>
    </message>
    <message>
        <source>interval of a square grid, or interval1 and interval2 of a grid RECTANGULAR</source>
        <translation>interval eines quadratischen Gitters oder interval1 und interval2 eines Gitters RECTANGULAR</translation>
    </message>
    <message>
        <source>parameter {number} of {value}</source>
        <translation>Parameter {number} mit {value}</translation>
    </message>
    <message>
        <source>a number with a decimal point, to compare it with the setting {key} of {value}; the file does not say what unit it is in without one</source>
        <translation>eine Zahl mit Dezimalpunkt, um sie mit der Angabe {key} von {value} zu vergleichen; ohne ihn sagt die Datei nicht, in welcher Einheit sie ist</translation>
    </message>
    <message>
        <source>{name} = {value}, with which the lengths of the table are in inches</source>
        <translation>{name} = {value}, womit die Längen der Tabelle in Zoll sind</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply positions and values in inches by 25.4</source>
        <translation>1; die Zeile entfernen und Positionen und Werte in Zoll mit 25,4 multiplizieren</translation>
    </message>
    <message>
        <source>what SECONDARY stands for, such as inch</source>
        <translation>wofür SECONDARY steht, zum Beispiel inch</translation>
    </message>
    <message>
        <source>counts of each axis for one primary-unit; without it what is in COUNTS stays in counts</source>
        <translation>Inkremente jeder Achse je primary-unit; ohne sie bleibt in Inkrementen, was in COUNTS ist</translation>
    </message>
    <message>
        <source>{key} ENGLISH of the rotary axis {axis}</source>
        <translation>{key} ENGLISH der Drehachse {axis}</translation>
    </message>
    <message>
        <source>METRIC, which is degrees there; inches are lengths</source>
        <translation>METRIC, das dort Grad bedeutet; Zoll sind Längen</translation>
    </message>
    <message>
        <source>two kinds of units in one table</source>
        <translation>zwei Arten von Einheiten in einer Tabelle</translation>
    </message>
    <message>
        <source>the settings {key} and {key2}</source>
        <translation>die Angaben {key} und {key2}</translation>
    </message>
    <message>
        <source>the instrument says {line}: another number follows its first one, as in degrees, minutes and seconds; set it to one decimal number, or say what the number is with a pattern</source>
        <translation>das Messgerät sagt {line}: auf seine erste Zahl folgt noch eine, wie bei Grad, Minuten und Sekunden; es auf eine einzige Dezimalzahl stellen oder mit einem Muster sagen, was die Zahl ist</translation>
    </message>
    <message>
        <source>the axis lost its homing in mid-measurement, as after a restart of the drive; its positions are others after it is homed again: begin a new file</source>
        <translation>Die Achse hat während der Messung ihre Referenz verloren, wie nach einem Neustart des Antriebs; nach erneutem Referenzieren sind ihre Positionen andere: Beginnen Sie eine neue Datei</translation>
    </message>
    <message>
        <source>the file says sign: {file}, and stated is {stated}: correct the one that is wrong</source>
        <translation>in der Datei steht sign: {file}, und angegeben ist {stated}: das Falsche von beiden korrigieren</translation>
    </message>
    <message>
        <source>{file} says sign: command, and a table that was active holds feedback values: convert the file first, and take what is written</source>
        <translation>in {file} steht sign: command, und eine Tabelle, die aktiv war, enthält Werte der Geberseite (feedback): die Datei zuerst umwandeln und nehmen, was geschrieben wird</translation>
    </message>
    <message>
        <source>the table that is active lies over other positions or sources than at the beginning; what was taken belongs to the one before: begin a new file</source>
        <translation>Die aktive Tabelle gilt für andere Positionen oder Quellen als am Anfang; die bisherigen Werte gehören zu der vorigen: Beginnen Sie eine neue Datei</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to in {other}; state how many counts are one unit, with the setting {key} of the file that is read</source>
        <translation>die Werte für {column} sind in {unit}, und die Positionen, zu denen sie addiert werden, in {other}; angeben, wie viele Inkremente eine Einheit sind, mit der Angabe {key} der Datei, die gelesen wird</translation>
    </message>
    <message>
        <source>the setting {key} for numbers in counts</source>
        <translation>die Angabe {key} für Zahlen in Inkrementen</translation>
    </message>
    <message>
        <source>the setting {key}, which says how many of them are one unit</source>
        <translation>die Angabe {key}, die sagt, wie viele davon eine Einheit sind</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, which is for files of measurements: a table holds reference minus encoder (sign: feedback), or what is added to the command (sign: command). Correct that line; where the values are encoder minus reference, leave it out, and turn them with --scale -1</source>
        <translation>in der Datei steht „{note}“, was nur in Messdateien gilt: eine Tabelle enthält Referenz minus Geber (sign: feedback) oder das, was zum Sollwert addiert wird (sign: command). Diese Zeile korrigieren; sind die Werte Geber minus Referenz, sie weglassen und die Werte mit --scale -1 umkehren</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, sign: feedback or sign: command, says what the values are: correct that line, or leave it out, which means feedback</source>
        <translation>in der Datei steht „{note}“; ein Kommentar, sign: feedback oder sign: command, sagt dort, was die Werte sind: diese Zeile korrigieren oder weglassen, was feedback bedeutet</translation>
    </message>
    <message>
        <source>1; as it stands in the file it follows the axis: leave --invert-reference out</source>
        <translation>1; wie sie in der Datei steht, folgt sie der Achse: --invert-reference weglassen</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>die Aufzeichnung der Flash-Vorgänge dieses Antriebs war beschädigt, daher gelten alle als verbraucht; die Zählung mit „axiscomp status --reset-flash-count“ zurücksetzen</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s</source>
        <translation>die übrigen Flash-Vorgänge reichen für die Änderung, aber nicht, um nach einem Fehlschlag alles zurückzustellen; {seconds} s warten</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s</source>
        <translation>zu viele Flash-Vorgänge in kurzer Zeit; {seconds} s warten</translation>
    </message>
    <message>
        <source>{stated}, stated as the axis that the values of {column} correct, may be one of the sources or not, since their names do not tell it, and the numbers depend on it; state the target: {sources}</source>
        <translation>{stated}, angegeben als die Achse, die die Werte von {column} korrigieren, kann eine der Quellen sein oder nicht, da deren Namen es nicht sagen, und die Zahlen hängen davon ab; Zielachse angeben: {sources}</translation>
    </message>
    <message>
        <source>an answer of the drive itself and not one that a cache or proxy in between has kept; connect to the drive without it</source>
        <translation>eine Antwort des Antriebs selbst und keine, die ein Cache oder Proxy dazwischen aufbewahrt hat; verbinden Sie sich ohne ihn mit dem Antrieb</translation>
    </message>
    <message>
        <source>no Content-Encoding but identity</source>
        <translation>als Content-Encoding nur identity</translation>
    </message>
    <message>
        <source>nothing after the bytes that Content-Length announces</source>
        <translation>nichts nach den Bytes, die Content-Length ankündigt</translation>
    </message>
    <message>
        <source>a Directory page with its Content-Length, or up to &lt;/html&gt;</source>
        <translation>eine Directory-Seite mit Content-Length oder bis &lt;/html&gt;</translation>
    </message>
    <message>
        <source>the file in {slot} is no table that the profile can read: it is in the backup as it is, but cannot be restored as the table of an axis</source>
        <translation>die Datei in {slot} ist keine Tabelle, die das Profil lesen kann: Sie ist unverändert in der Sicherung, lässt sich aber nicht als Tabelle einer Achse wiederherstellen</translation>
    </message>
    <message>
        <source>the drive has taken the command that stores the table in {slot}, but has counted no flash cycle for it ({cycles} before and after): it is not known to be in flash, and may be gone after a reboot</source>
        <translation>der Antrieb hat den Befehl angenommen, der die Tabelle in {slot} speichert, hat aber keinen Flash-Zyklus dafür gezählt ({cycles} vorher und nachher): Dass sie im Flash ist, steht nicht fest, und nach einem Neustart ist sie vielleicht weg</translation>
    </message>
    <message>
        <source>what a write that did not end has left of axis {axis} is not known: the backup of its old state, {backup}, cannot be read. Write again or restore another backup, which puts an end to it</source>
        <translation>was ein Schreibvorgang, der nicht zu Ende kam, von Achse {axis} hinterlassen hat, ist nicht bekannt: die Sicherung ihres alten Zustands, {backup}, ist nicht lesbar. Neu schreiben oder eine andere Sicherung wiederherstellen, was ihn beendet</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the setting {key} says {unit}; leave one of them out</source>
        <translation>Die Einheit {stated} ist angegeben, und die Einstellung {key} nennt {unit}; eines von beiden weglassen</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected a unit; that numbers are in the unit of the drive is stated as {option} of {command}, or as {key} beside the settings of a machine file</source>
        <translation>Die Einstellung {key} ist &quot;{value}&quot;, erwartet wird eine Einheit; dass Zahlen in der Einheit des Antriebs sind, wird als {option} von {command} angegeben, oder als {key} neben den Einstellungen einer Maschinendatei</translation>
    </message>
    <message>
        <source>&quot;{note}&quot;, as another comment says; leave one of them out</source>
        <translation>&quot;{note}&quot;, wie ein anderer Kommentar sagt; einen von beiden weglassen</translation>
    </message>
    <message>
        <source>{axes} as the setting {key}</source>
        <translation>{axes} als Einstellung {key}</translation>
    </message>
    <message>
        <source>an axis of the file: {axes}</source>
        <translation>eine Achse der Datei: {axes}</translation>
    </message>
    <message>
        <source>{ranges}: nothing of what was measured first is measured again; measure over the targets of the first measurement</source>
        <translation>{ranges}: nichts von dem, was zuerst gemessen wurde, ist noch einmal gemessen; über die Zielpositionen der ersten Messung messen</translation>
    </message>
    <message>
        <source>1; some values are whole turns away, since the instrument begins again at 360 deg: let it count on, or write -0.0001 in place of 359.9999 in the file</source>
        <translation>1; einige Werte liegen ganze Umdrehungen daneben, da das Messgerät bei 360° von vorn beginnt: weiterzählen lassen oder in der Datei -0.0001 statt 359.9999 schreiben</translation>
    </message>
    <message>
        <source>no installed font has {characters}, so that empty boxes would stand in the PDF: install one that has them, such as fonts-noto-cjk for Chinese and Japanese, or write the report as HTML</source>
        <translation>keine installierte Schrift enthält {characters}, im PDF stünden leere Kästchen: eine Schrift mit diesen Zeichen installieren, etwa fonts-noto-cjk für Chinesisch und Japanisch, oder den Bericht als HTML schreiben</translation>
    </message>
    <message>
        <source>the values of {table} correct {target}, but for axis {axis} {role}; choose another column, axis or source, or, if it is right all the same, state the target as {statement} when the file is read</source>
        <translation>die Werte von {table} korrigieren {target}, aber bei Achse {axis} gilt: {role}; andere Spalte, Achse oder Quelle wählen oder, wenn es dennoch stimmt, beim Einlesen der Datei die Zielachse als {statement} angeben</translation>
    </message>
    <message>
        <source>the file does not say what the values of {table} correct. They were converted for {target}, but for axis {axis} {role}: read the file again with these sources, or state its target</source>
        <translation>die Datei sagt nicht, welche Achse die Werte von {table} korrigieren. Sie wurden für {target} umgerechnet, aber bei Achse {axis} gilt: {role}. Die Datei mit diesen Quellen neu einlesen oder ihre Zielachse angeben</translation>
    </message>
    <message>
        <source>a source is no position of an axis</source>
        <translation>eine Quelle ist keine Position einer Achse</translation>
    </message>
    <message>
        <source>the table was made for a position before the compensation, and {source} is one after it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at set)</source>
        <translation>die Tabelle ist für eine Position vor der Kompensation gemacht, und {source} ist eine danach: eine andere Quelle wählen oder die Tabelle für diese neu machen, aus ihrer Messung oder der Datei ihrer Steuerung (in der Befehlszeile mit --lookup-at set)</translation>
    </message>
    <message>
        <source>the table was made for a position after the compensation, and {source} is one before it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at encoder)</source>
        <translation>die Tabelle ist für eine Position nach der Kompensation gemacht, und {source} ist eine davor: eine andere Quelle wählen oder die Tabelle für diese neu machen, aus ihrer Messung oder der Datei ihrer Steuerung (in der Befehlszeile mit --lookup-at encoder)</translation>
    </message>
    <message>
        <source>the instrument says {line}: it is not clear where its number begins and ends; set it to one decimal number and its unit, or say what the number is with a pattern</source>
        <translation>das Messgerät sagt {line}: es ist nicht klar, wo die Zahl beginnt und endet; es auf eine einzige Dezimalzahl mit ihrer Einheit stellen oder mit einem Muster sagen, was die Zahl ist</translation>
    </message>
    <message>
        <source>another program has replaced, changed or deleted it since it was opened; look which values it has before you go on with it</source>
        <translation>ein anderes Programm hat sie ersetzt, geändert oder gelöscht, seit sie geöffnet wurde; vor dem Fortsetzen nachsehen, welche Werte sie enthält</translation>
    </message>
    <message>
        <source>column {column}, and values: {said}</source>
        <translation>Spalte {column}, und values: {said}</translation>
    </message>
    <message>
        <source>one of the two; a column value goes with both</source>
        <translation>eines von beiden; eine Spalte value geht mit beidem</translation>
    </message>
    <message>
        <source>the controller adds the tables for {axis}: the sign of each is converted, and each is compared, as if it were alone</source>
        <translation>die Steuerung addiert die Tabellen für {axis}: umgerechnet ist das Vorzeichen jeder Tabelle, und verglichen ist jede, als wäre sie allein</translation>
    </message>
    <message>
        <source>a second table that belongs to the same motor</source>
        <translation>eine zweite Tabelle, die zum selben Motor gehört</translation>
    </message>
    <message>
        <source>one for each motor; the last one counts</source>
        <translation>eine für jeden Motor; die letzte zählt</translation>
    </message>
    <message>
        <source>begins again at the other end</source>
        <translation>beginnt am anderen Ende von vorn</translation>
    </message>
    <message>
        <source>another axis than that of the first source</source>
        <translation>eine andere Achse als die der ersten Quelle</translation>
    </message>
    <message>
        <source>one number; line {line} gives it another one for the next pass of the loop</source>
        <translation>eine einzige Zahl; in Zeile {line} bekommt er für den nächsten Durchlauf der Schleife eine andere</translation>
    </message>
    <message>
        <source>one number; another part of the program gives it another one in line {line}</source>
        <translation>eine einzige Zahl; in Zeile {line} gibt ihm ein anderer Teil des Programms eine andere</translation>
    </message>
    <message>
        <source>a name that got a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether that of line {line} counts</source>
        <translation>ein Name, der außerhalb von IF, ELSE, SWITCH, LOOP, WHILE und ON eine Zahl bekommen hat; ob die aus Zeile {line} gilt, weiß nur die Steuerung</translation>
    </message>
    <message>
        <source>a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether this one counts</source>
        <translation>eine Zahl außerhalb von IF, ELSE, SWITCH, LOOP, WHILE und ON; ob diese gilt, weiß nur die Steuerung</translation>
    </message>
    <message>
        <source>numbers for the elements of {name} alone; what else changes the array behind them is not computed</source>
        <translation>nur Zahlen für die Elemente von {name}; was das Feld danach auf andere Weise ändert, wird nicht berechnet</translation>
    </message>
    <message>
        <source>The new table is volatile: after a reboot the axis has the old, persistent one again, or none where the parameters have been saved since then.</source>
        <translation>Die neue Tabelle ist flüchtig: nach einem Neustart hat die Achse wieder die alte, dauerhafte, oder keine, wenn seither die Parameter gespeichert wurden.</translation>
    </message>
    <message>
        <source>the setting {key} says {value} for tables of different axes, {axes}; choose one of the tables (--table), or leave the setting out</source>
        <translation>die Einstellung {key} nennt {value} für Tabellen verschiedener Achsen, {axes}; eine der Tabellen wählen (--table) oder die Einstellung weglassen</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the set position: use it with such sources only</source>
        <translation>die neue Datei sagt nicht, dass der Antrieb an der Sollposition nachschlagen muss: nur mit solchen Quellen verwenden</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the encoder position: use it with such sources only</source>
        <translation>die neue Datei sagt nicht, dass der Antrieb an der Position des Gebers nachschlagen muss: nur mit solchen Quellen verwenden</translation>
    </message>
    <message>
        <source>the new file does not say that the drive with the serial number {serial} was measured, as its source does: use it for that drive only</source>
        <translation>anders als ihre Quelle sagt die neue Datei nicht, dass der Antrieb mit der Seriennummer {serial} gemessen wurde: nur für diesen Antrieb verwenden</translation>
    </message>
    <message>
        <source>several tables are called {table}; choose one by its number, such as #1: {alike}</source>
        <translation>mehrere Tabellen heißen {table}; eine über ihre Nummer wählen, etwa #1: {alike}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid list of positions: {count} problems</source>
        <comment>{file} is not a valid list of positions: one problem</comment>
        <translation>
            <numerusform>{file} ist keine gültige Liste von Positionen: 1 Problem</numerusform>
            <numerusform>{file} ist keine gültige Liste von Positionen: {count} Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} is UTF-16 text; save it as UTF-8 text</source>
        <translation>{file} ist Text in UTF-16; als Text in UTF-8 speichern</translation>
    </message>
    <message>
        <source>one value for each target, direction and run, or a number for each run</source>
        <translation>ein Wert für jede Zielposition, jede Richtung und jeden Durchlauf, oder eine Nummer für jeden Durchlauf</translation>
    </message>
    <message>
        <source>nobody has published that the numbers begin at line N{first} (first-record): compare with a file of this controller</source>
        <translation>niemand hat veröffentlicht, dass die Nummern bei Zeile N{first} beginnen (first-record): mit einer Datei dieser Steuerung vergleichen</translation>
    </message>
    <message>
        <source>nobody has published that a value is at most {most} (largest-step): compare with a file of this controller</source>
        <translation>niemand hat veröffentlicht, dass ein Wert höchstens {most} ist (largest-step): mit einer Datei dieser Steuerung vergleichen</translation>
    </message>
    <message>
        <source>this counts only with {member}, which is missing</source>
        <translation>das zählt nur zusammen mit {member}, und das fehlt</translation>
    </message>
    <message>
        <source>it states no term of the uncertainty</source>
        <translation>es nennt keinen Beitrag zur Messunsicherheit</translation>
    </message>
    <message>
        <source>the {what} were in {unit} when the write began, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>die {what} waren zu Beginn des Schreibens in {unit}, und der Antrieb hat sie jetzt in {other}, sodass dieselben Zahlen etwas anderes bedeuten würden; stellen Sie die Einheit im Antrieb wieder auf {unit} oder schreiben Sie die Tabelle aus ihrer Datei</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the write began, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>Achse {axis} hieß zu Beginn des Schreibens {target} und heißt im Antrieb jetzt {name}; geben Sie den Achsen die Reihenfolge oder die Namen von damals oder schreiben Sie die Tabelle aus ihrer Datei</translation>
    </message>
    <message>
        <source>the {what} of the record&apos;s table were in {unit} when it was written, and the drive has them in {other} now, so that the same numbers mean something else; set the unit on the drive to {unit} again, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>die {what} der Tabelle des Protokolls waren in {unit}, als sie geschrieben wurde, und der Antrieb hat sie jetzt in {other}, sodass dieselben Zahlen etwas anderes bedeuten; die Einheit im Antrieb wieder auf {unit} stellen oder die Tabelle des Protokolls noch einmal schreiben („axiscomp write --record“)</translation>
    </message>
    <message>
        <source>an unknown unit</source>
        <translation>einer unbekannten Einheit</translation>
    </message>
    <message>
        <source>the record does not say in which unit the axis was when its table was written, and in {unit}, as the axis is now, none of its tables is the one on the drive: set the unit that the axis had, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>das Protokoll sagt nicht, in welcher Einheit die Achse war, als seine Tabelle geschrieben wurde, und in {unit}, der Einheit der Achse jetzt, ist keine seiner Tabellen die im Antrieb: die Einheit einstellen, die die Achse hatte, oder die Tabelle des Protokolls noch einmal schreiben („axiscomp write --record“)</translation>
    </message>
    <message>
        <source>{example}: the file says {value}</source>
        <translation>{example}: in der Datei steht {value}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller takes the axis to be at {moved}</source>
        <translation>wo der Geber {place} meldet, steht die Achse für die Steuerung bei {moved}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller takes {axis} to be at {moved}</source>
        <translation>wo die Geber {place} melden, steht {axis} für die Steuerung bei {moved}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller adds {value} to the position of {axis}</source>
        <translation>wo der Geber {place} meldet, addiert die Steuerung {value} zur Position von {axis}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller adds {value} to the position of {axis}</source>
        <translation>wo die Geber {place} melden, addiert die Steuerung {value} zur Position von {axis}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}</source>
        <translation>bei der Sollposition {place} fährt die Steuerung den Geber auf {moved}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}</source>
        <translation>bei der Sollposition {place} fährt die Steuerung den Geber von {axis} auf {moved}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves {target} by {value}</source>
        <translation>bei der Sollposition {place} verschiebt die Steuerung {target} um {value}</translation>
    </message>
    <message>
        <source>the configuration names the table in {slot} for axis {axis}, but the drive has none there: write the table to the axis from its file and name the slot that it gets in the configuration, or write it into {slot} with &apos;axiscomp write --slot {slot}&apos;</source>
        <translation>die Konfiguration nennt für Achse {axis} die Tabelle in {slot}, doch der Antrieb hat dort keine: die Tabelle aus ihrer Datei auf die Achse schreiben und den Tabellenplatz, den sie erhält, in der Konfiguration angeben, oder sie mit &apos;axiscomp write --slot {slot}&apos; in {slot} schreiben</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis: &apos;axiscomp recover&apos; says how the write can be finished or undone. The old state is kept in {backup}</source>
        <translation>{reason}; auch das Zurückstellen des alten Zustands ist fehlgeschlagen ({rollback}). Die Achse nicht aktivieren: &apos;axiscomp recover&apos; sagt, wie sich der Schreibvorgang vollenden oder rückgängig machen lässt. Der alte Zustand ist aufbewahrt in {backup}</translation>
    </message>
    <message>
        <source>{endpoint} refuses the user name or the password that was given; in an address %40 stands for @, %3A for :, %2F for /, %23 for # and %25 for %</source>
        <translation>{endpoint} lehnt den angegebenen Benutzernamen oder das Passwort ab; in einer Adresse steht %40 für @, %3A für :, %2F für /, %23 für # und %25 für %</translation>
    </message>
    <message>
        <source>write http://user:password@host[:port], and in user name and password %40 for @, %3A for :, %2F for /, %3F for ?, %23 for # and %25 for %</source>
        <translation>anzugeben ist http://benutzer:passwort@host[:port], und in Benutzername und Passwort %40 für @, %3A für :, %2F für /, %3F für ?, %23 für # und %25 für %</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} of axis {ofAxis} is missing</source>
        <translation>die Quelle der Dimension {dimension} von Achse {ofAxis} fehlt</translation>
    </message>
    <message>
        <source>a machine cannot be called {name}: a name has no control characters</source>
        <translation>eine Maschine kann nicht {name} heißen: ein Name hat keine Steuerzeichen</translation>
    </message>
    <message>
        <source>the name of axis {axis}</source>
        <translation>Name von Achse {axis}</translation>
    </message>
    <message>
        <source>the units of the table of {axis}</source>
        <translation>Einheiten der Tabelle von {axis}</translation>
    </message>
    <message>
        <source>{file} is a measurement, not a table; make a table of it with &apos;axiscomp fit&apos; or on the pages Measure and Fit; if it is a table all the same, name its format</source>
        <translation>{file} ist eine Messung, keine Tabelle; mit „axiscomp fit“ oder auf den Seiten Messen und Anpassen eine Tabelle daraus machen; ist es doch eine Tabelle, deren Format angeben</translation>
    </message>
    <message>
        <source>The open record will not note this write: {reason}.</source>
        <translation>Das offene Protokoll wird dieses Schreiben nicht vermerken: {reason}.</translation>
    </message>
    <message>
        <source>nothing says for which measuring system of axis {axis} the table is: it is written for 0; the setting {key} states another one</source>
        <translation>nichts sagt, für welches Messsystem der Achse {axis} die Tabelle ist: sie wird für 0 geschrieben; die Einstellung {key} nennt ein anderes</translation>
    </message>
    <message>
        <source>a table for {element} alone</source>
        <translation>eine Tabelle nur für {element}</translation>
    </message>
    <message>
        <source>CompPos and CompPos2 of the motor; the table is taken for both, and written for both</source>
        <translation>CompPos und CompPos2 des Motors; die Tabelle wird für beide genommen und für beide geschrieben</translation>
    </message>
    <message>
        <source>axis {axis}, whose numbers are taken to be in mm</source>
        <translation>Achse {axis}, deren Zahlen als mm genommen werden</translation>
    </message>
    <message>
        <source>the setting {key} where the axis is rotary</source>
        <translation>die Einstellung {key}, wenn es eine Drehachse ist</translation>
    </message>
</context>
<context>
    <name>FileFilter</name>
    <message>
        <source>Compensation data</source>
        <translation>Kompensationsdaten</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Record of the compensation (axiscomp write --record), which notes the proof</source>
        <translation>Protokoll der Kompensation (axiscomp write --record), das den Nachweis festhält</translation>
    </message>
    <message>
        <source>List the axes of one or several drives</source>
        <translation>Die Achsen eines oder mehrerer Antriebe auflisten</translation>
    </message>
    <message>
        <source>Also try all serial ports of this computer; without --drive, the connections of the window too</source>
        <translation>Auch alle seriellen Anschlüsse dieses Rechners versuchen; ohne --drive auch die Verbindungen des Fensters</translation>
    </message>
    <message>
        <source>Try the usual baud rates at every serial port</source>
        <translation>Die üblichen Baudraten an jedem seriellen Anschluss versuchen</translation>
    </message>
    <message>
        <source>Also ask these addresses over http: 192.168.1.0/24, 192.168.1.10-40 or one address, at most 1024, with :PORT for another port than 80</source>
        <translation>Auch diese Adressen über http fragen: 192.168.1.0/24, 192.168.1.10-40 oder eine Adresse, höchstens 1024, mit :PORT für einen anderen Port als 80</translation>
    </message>
    <message>
        <source>Save everything that this program can change on a whole drive, all axes, to one file</source>
        <translation>Alles, was dieses Programm an einem ganzen Antrieb ändern kann, mit allen Achsen in eine Datei sichern</translation>
    </message>
    <message>
        <source>File to write; standard output without it, or with -</source>
        <translation>Zu schreibende Datei; ohne Angabe oder mit - die Standardausgabe</translation>
    </message>
    <message>
        <source>Restore a whole drive from a backup file, with verified writes; all of them are planned first</source>
        <translation>Einen ganzen Antrieb aus einer Sicherung wiederherstellen, mit verifizierten Schreibvorgängen; zuerst werden alle geplant</translation>
    </message>
    <message>
        <source>File that `axiscomp backup` wrote; - for standard input</source>
        <translation>Datei, die `axiscomp backup` geschrieben hat; - für die Standardeingabe</translation>
    </message>
    <message>
        <source>Restore to a drive with another serial number, such as a replacement</source>
        <translation>Auf einem Antrieb mit anderer Seriennummer wiederherstellen, etwa einem Ersatz</translation>
    </message>
    <message>
        <source>Show what would be written without writing it</source>
        <translation>Zeigen, was geschrieben würde, ohne es zu schreiben</translation>
    </message>
    <message>
        <source>Where the axis really is: a register of the drive, serial:/dev/ttyUSB1?baud=9600, - for lines on standard input, or typed</source>
        <translation>Wo die Achse wirklich ist: ein Register des Antriebs, serial:/dev/ttyUSB1?baud=9600, - für Zeilen der Standardeingabe, oder typed für die Eingabe von Hand</translation>
    </message>
    <message>
        <source>Unit of the instrument; of a register it is that of the axis, of lines the one behind the number unless given</source>
        <translation>Einheit des Messgeräts; ohne Angabe bei einem Register die der Achse, bei Zeilen die hinter der Zahl</translation>
    </message>
    <message>
        <source>The instrument counts the other way</source>
        <translation>Das Messgerät zählt andersherum</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0 (0 unless given)</source>
        <translation>Position der Achse, wo das Messgerät 0 sagt (Standard: 0)</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line, its first group or all of it; the first number of the line unless given</source>
        <translation>Regulärer Ausdruck für die Zahl in einer Zeile, seine erste Gruppe oder der ganze Treffer; ohne Angabe die erste Zahl der Zeile</translation>
    </message>
    <message>
        <source>Send this to the serial instrument before each reading, with \r and \n for line ends</source>
        <translation>Dies vor jeder Ablesung an das serielle Messgerät senden, mit \r und \n für Zeilenenden</translation>
    </message>
    <message>
        <source>Register of the raw position; the profile&apos;s unless given</source>
        <translation>Register der Rohposition; ohne Angabe das des Profils</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within so many mm or deg, and readings may differ by as much (0.001 unless given)</source>
        <translation>Die Achse steht, solange ihr Geber innerhalb so vieler mm oder Grad bleibt, und so viel dürfen Ablesungen sich unterscheiden (Standard: 0.001)</translation>
    </message>
    <message>
        <source>So many seconds, before anything is taken (1 unless given)</source>
        <translation>Verweilzeit in Sekunden, bevor ein Wert genommen wird (Standard: 1)</translation>
    </message>
    <message>
        <source>Readings that make a value (10 unless given)</source>
        <translation>Ablesungen, die einen Wert ergeben (Standard: 10)</translation>
    </message>
    <message>
        <source>Readings per second, 10 to 50 (20 unless given)</source>
        <translation>Ablesungen je Sekunde, 10 bis 50 (Standard: 20)</translation>
    </message>
    <message>
        <source>Take the values of a measuring plan while something else moves the axis</source>
        <translation>Die Werte eines Messplans erfassen, während etwas anderes die Achse bewegt</translation>
    </message>
    <message>
        <source>Plan as axiscomp targets writes it</source>
        <translation>Messplan, wie ihn axiscomp targets schreibt</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>Datei der Werte; eine vorhandene geht weiter, wo sie endet</translation>
    </message>
    <message>
        <source>axiscomp never moves an axis: the machine&apos;s control or a person does.</source>
        <translation>axiscomp bewegt nie eine Achse: das tut die Steuerung der Maschine oder ein Mensch.</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Beispiele:</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to a servo drive, activates them, and checks the drive&apos;s output against the table.</source>
        <translation>Schreibt Kompensationstabellen für gemessene Achsfehler in einen Servoantrieb, aktiviert sie und vergleicht den Ausgang des Antriebs mit der Tabelle.</translation>
    </message>
    <message>
        <source>Show the version</source>
        <translation>Die Version zeigen</translation>
    </message>
    <message>
        <source>ENDPOINT is http://host[:port], https://host[:port], serial:DEVICE[?baud=N] or demo: (a virtual drive inside the program). AXISCOMP_DRIVE is the default of --drive. `axiscomp COMMAND --help` has more.</source>
        <translation>ENDPOINT ist http://host[:port], https://host[:port], serial:GERÄT[?baud=N] oder demo: (ein virtueller Antrieb im Programm). AXISCOMP_DRIVE ist der Standard für --drive. Mehr zeigt `axiscomp COMMAND --help`.</translation>
    </message>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>Ein JSON-Dokument auf die Standardausgabe schreiben</translation>
    </message>
    <message>
        <source>Files on this computer</source>
        <translation>Dateien auf diesem Rechner</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>Compare measurements before and after a compensation, and with what was promised</source>
        <translation>Messungen vor und nach einer Kompensation vergleichen, auch mit der Vorhersage</translation>
    </message>
    <message>
        <source>on: the second measurement was made with the table of the record active, where its file does not say it</source>
        <translation>on: bei der zweiten Messung war die Tabelle des Protokolls aktiv, wenn ihre Datei es nicht sagt</translation>
    </message>
    <message>
        <source>Add the second measurement and the verdict to the record</source>
        <translation>Die zweite Messung und das Urteil in das Protokoll aufnehmen</translation>
    </message>
    <message>
        <source>Compensation parameters of a TAM configuration: show them, take them from a drive, or bring them to one</source>
        <translation>Kompensationsparameter einer TAM-Konfiguration: zeigen, aus einem Antrieb übernehmen oder in einen schreiben</translation>
    </message>
    <message>
        <source>show, export (to the file) or import (from it)</source>
        <translation>show (zeigen), export (in die Datei) oder import (aus ihr)</translation>
    </message>
    <message>
        <source>TAM configuration (.TAMcfg)</source>
        <translation>TAM-Konfiguration (.TAMcfg)</translation>
    </message>
    <message>
        <source>export: take the parameters from this configuration in place of a drive</source>
        <translation>export: die Parameter aus dieser Konfiguration nehmen statt aus einem Antrieb</translation>
    </message>
    <message>
        <source>export: write this file instead, and leave the other one as it is</source>
        <translation>export: stattdessen diese Datei schreiben und die andere lassen, wie sie ist</translation>
    </message>
    <message>
        <source>Name or serial number of the station in the file; without it the one with the drive&apos;s serial number</source>
        <translation>Name oder Seriennummer der Station in der Datei; ohne Angabe die mit der Seriennummer des Antriebs</translation>
    </message>
    <message>
        <source>Accept a station with another serial number than the drive&apos;s</source>
        <translation>Eine Station mit anderer Seriennummer als der des Antriebs annehmen</translation>
    </message>
    <message>
        <source>Only the registers Table and Dim1Source to Dim3Source of the axes are read and written. Everything else in the file stays as it is, and tables stay on the drive. Importing never switches a compensation on.</source>
        <translation>Gelesen und geschrieben werden nur die Register Table und Dim1Source bis Dim3Source der Achsen. Alles andere in der Datei bleibt, wie es ist, und Tabellen bleiben im Antrieb. Der Import schaltet nie eine Kompensation ein.</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>Beispiel:</translation>
    </message>
    <message>
        <source>Convert a table file to another format</source>
        <translation>Eine Tabellendatei in ein anderes Format umwandeln</translation>
    </message>
    <message>
        <source>File to read; - for standard input</source>
        <translation>Zu lesende Datei; - für die Standardeingabe</translation>
    </message>
    <message>
        <source>File to write, replaced if it exists; - for standard output</source>
        <translation>Zu schreibende Datei, eine vorhandene wird ersetzt; - für die Standardausgabe</translation>
    </message>
    <message>
        <source>Format of the output, if its name leaves it open</source>
        <translation>Format der Ausgabe, wenn ihr Name es offenlässt</translation>
    </message>
    <message>
        <source>Unit of the values in a .TAMtbl, which does not say it; by default that of the positions</source>
        <translation>Einheit der Werte in einer .TAMtbl, die sie nicht nennt; Standard ist die der Positionen</translation>
    </message>
    <message>
        <source>Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl</source>
        <translation>Auch Korrekturen über 1 % des Bereichs oder mit einer Steigung über 0,1 in eine .TAMtbl schreiben</translation>
    </message>
    <message>
        <source>Mark the table persistent: the drive stores it</source>
        <translation>Die Tabelle als dauerhaft kennzeichnen: der Antrieb speichert sie</translation>
    </message>
    <message>
        <source>Mark the table volatile (without either: as the input is)</source>
        <translation>Die Tabelle als flüchtig kennzeichnen (ohne beides: wie die Eingabe)</translation>
    </message>
    <message>
        <source>Name of the table</source>
        <translation>Name der Tabelle</translation>
    </message>
    <message>
        <source>Delete the table of an axis, or one that no axis uses, and free its slot</source>
        <translation>Die Tabelle einer Achse löschen, oder eine, die keine Achse verwendet, und ihren Tabellenplatz freigeben</translation>
    </message>
    <message>
        <source>Delete the table in this slot, small1 to small8, large1 or large2, which no axis uses</source>
        <translation>Die Tabelle auf diesem Tabellenplatz löschen, small1 bis small8, large1 oder large2; keine Achse darf sie verwenden</translation>
    </message>
    <message>
        <source>Show what would be deleted without deleting it</source>
        <translation>Zeigen, was gelöscht würde, ohne es zu löschen</translation>
    </message>
    <message>
        <source>The compensation must be off. The axis then uses no table, also after a reboot; its sources stay. What is deleted is kept in a backup: `axiscomp restore` brings it back.</source>
        <translation>Die Kompensation muss ausgeschaltet sein. Die Achse verwendet danach keine Tabelle, auch nach einem Neustart; ihre Quellen bleiben. Gelöschtes bleibt in einer Sicherung erhalten: `axiscomp restore` bringt es zurück.</translation>
    </message>
    <message>
        <source>Write an example calibration file (CSV)</source>
        <translation>Eine Kalibrierdatei (CSV) als Beispiel schreiben</translation>
    </message>
    <message>
        <source>Number of dimensions: 1, 2 or 3</source>
        <translation>Anzahl der Dimensionen: 1, 2 oder 3</translation>
    </message>
    <message>
        <source>Number of tables (2 unless given)</source>
        <translation>Anzahl der Tabellen (Standard: 2)</translation>
    </message>
    <message>
        <source>Table file to write, replaced if it exists; - for standard output. Without it nothing is written</source>
        <translation>Zu schreibende Tabellendatei, eine vorhandene wird ersetzt; - für die Standardausgabe. Ohne Angabe wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Begin a record of the compensation (.axcal): measurement, table and what it promises, for compare and report</source>
        <translation>Ein Protokoll der Kompensation (.axcal) beginnen: Messung, Tabelle und deren Vorhersage, für compare und report</translation>
    </message>
    <message>
        <source>Write this column of points only, where the format holds one table</source>
        <translation>Von Punkten nur diese Spalte schreiben, wenn das Format nur eine Tabelle fasst</translation>
    </message>
    <message>
        <source>Curve and grid</source>
        <translation>Kurve und Gitter</translation>
    </message>
    <message>
        <source>Curve through the means: linear (the default), cubic, spline, smooth or harmonic</source>
        <translation>Kurve durch die Mittelwerte: linear (Standard), cubic, spline, smooth oder harmonic</translation>
    </message>
    <message>
        <source>Of the method smooth, and of points and tracks; by cross-validation unless given</source>
        <translation>Glätte für das Verfahren smooth sowie für Punkte und Bahnen; ohne Angabe durch Kreuzvalidierung</translation>
    </message>
    <message>
        <source>Known periods, such as the lead of the screw, fitted by the method smooth</source>
        <translation>Bekannte Perioden, etwa die Steigung der Spindel, angepasst mit dem Verfahren smooth</translation>
    </message>
    <message>
        <source>Harmonics of each period, and of the method harmonic, the fundamental counted (1 unless given)</source>
        <translation>Anzahl der Harmonischen jeder Periode und von harmonic, die Grundwelle mitgezählt (Standard: 1)</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>Länge einer Umdrehung einer Moduloachse, etwa 360: die Tabelle endet, wie sie beginnt</translation>
    </message>
    <message>
        <source>Which runs the table is made of: mean of both (the default), positive or negative; both makes a table for each, for controllers that keep two</source>
        <translation>Durchläufe, aus denen die Tabelle entsteht: mean (Mittel beider Richtungen, Standard), positive oder negative; both macht für jede eine Tabelle, für Steuerungen, die zwei haben</translation>
    </message>
    <message>
        <source>temperature: a table over position and temperature, from runs in several thermal states; --points and --distance take a second number for it</source>
        <translation>temperature: eine Tabelle über Position und Temperatur, aus Durchläufen in mehreren thermischen Zuständen; --points und --distance nehmen dafür eine zweite Zahl</translation>
    </message>
    <message>
        <source>Even grid with N points, for each axis or for all; unless given, that of the targets, where they are even</source>
        <translation>Gleichmäßiges Gitter mit N Stützstellen, für jede Achse oder für alle; ohne Angabe das der Zielpositionen, wenn sie gleichmäßig liegen</translation>
    </message>
    <message>
        <source>Even grid with spacing D, for each axis or for all</source>
        <translation>Gleichmäßiges Gitter mit Abstand D, für jede Achse oder für alle</translation>
    </message>
    <message>
        <source>The fewest points that leave no more than this to the curve, in mm or deg</source>
        <translation>So wenige Stützstellen, wie diese Abweichung von der Kurve erlaubt, in mm oder Grad</translation>
    </message>
    <message>
        <source>Let the grid extend beyond the targets, where the end values are held</source>
        <translation>Das Gitter darf über die Zielpositionen hinausgehen, wo die Endwerte gehalten werden</translation>
    </message>
    <message>
        <source>Speed of the axis in mm/s or deg/s, for the steps of the velocity that are told</source>
        <translation>Geschwindigkeit der Achse in mm/s oder Grad/s, für die Angabe der Geschwindigkeitssprünge</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>Nullstelle, Steigung und Drift</translation>
    </message>
    <message>
        <source>Where the table is 0: home, first (the first target), mean, keep, or a position; home where it is known and measured, else first, unless given</source>
        <translation>Wo die Tabelle 0 ist: home, first (erste Zielposition), mean, keep oder eine Position; ohne Angabe home, wenn der Referenzpunkt bekannt und gemessen ist, sonst first</translation>
    </message>
    <message>
        <source>Home position of the axis</source>
        <translation>Referenzpunkt der Achse</translation>
    </message>
    <message>
        <source>Take the slope out, for straightness: lsq (least squares) or ends</source>
        <translation>Die Steigung herausnehmen, für Geradheit: lsq (kleinste Quadrate) oder ends</translation>
    </message>
    <message>
        <source>Take the drift of the runs out before they are averaged: offset or trend</source>
        <translation>Die Drift der Durchläufe herausnehmen, bevor sie gemittelt werden: offset oder trend</translation>
    </message>
    <message>
        <source>State of the drive</source>
        <translation>Zustand des Antriebs</translation>
    </message>
    <message>
        <source>Where the drive looks the table up: encoder (before the compensation) or set (after it); with --onto drive by its source</source>
        <translation>Wo der Antrieb in der Tabelle nachschlägt: encoder (vor der Kompensation) oder set (danach); mit --onto drive nach ihrer Quelle</translation>
    </message>
    <message>
        <source>What was active while it was measured, where the file does not say it: off, on, or the file of the table</source>
        <translation>Was während der Messung aktiv war, wenn die Datei es nicht sagt: off, on oder die Datei der Tabelle</translation>
    </message>
    <message>
        <source>Merge residuals onto the table that was active: its file, or drive for the one that the axis uses (--drive, --axis)</source>
        <translation>Restabweichungen in die Tabelle einrechnen, die aktiv war: ihre Datei, oder drive für die, die die Achse verwendet (--drive, --axis)</translation>
    </message>
    <message>
        <source>Factor for the residuals before they are merged (1); below 1, such as 0.7, where the machine responds sluggishly</source>
        <translation>Faktor für die Restabweichungen, bevor sie eingerechnet werden (Standard: 1); unter 1, etwa 0.7, bei träger Maschine</translation>
    </message>
    <message>
        <source>Points and tracks</source>
        <translation>Punkte und Bahnen</translation>
    </message>
    <message>
        <source>Remove the alignment of the artefact: rigid (position and rotation), rigid:X (rotated so that lines along X have no slope), or scale (its scale as well)</source>
        <translation>Lage des Prüfkörpers herausrechnen: rigid (Position und Drehung), rigid:X (so gedreht, dass Geraden entlang X keine Steigung haben) oder scale (auch den Maßstab)</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one: smooth or nearest; refused unless given</source>
        <translation>Stützstellen, die weit von jedem gemessenen Punkt entfernt sind: smooth oder nearest; ohne Angabe werden sie abgelehnt</translation>
    </message>
    <message>
        <source>Give values that do not fit the others less weight</source>
        <translation>Werten, die nicht zu den anderen passen, weniger Gewicht geben</translation>
    </message>
    <message>
        <source>Make a compensation table of a measurement, and foretell what it does</source>
        <translation>Aus einer Messung eine Kompensationstabelle machen und vorhersagen, was sie bewirkt</translation>
    </message>
    <message>
        <source>List the table formats, or describe one: its limits, rules and settings</source>
        <translation>Die Tabellenformate auflisten oder eines beschreiben: Grenzen, Regeln und Angaben</translation>
    </message>
    <message>
        <source>One format: its rules, limits and settings</source>
        <translation>Ein Format: Regeln, Grenzen und Angaben</translation>
    </message>
    <message>
        <source>All of them, as the page docs/formats.md</source>
        <translation>Alle, als Seite docs/formats.md</translation>
    </message>
    <message>
        <source>The formats of measurements instead of those of tables</source>
        <translation>Die Formate von Messungen statt der von Tabellen</translation>
    </message>
    <message>
        <source>Check a file and report its format, grid, tables and problems</source>
        <translation>Eine Datei prüfen und Format, Gitter, Tabellen und Probleme nennen</translation>
    </message>
    <message>
        <source>Calibration file or table; - for standard input</source>
        <translation>Kalibrierdatei oder Tabelle; - für die Standardeingabe</translation>
    </message>
    <message>
        <source>Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances</source>
        <translation>Eine Messung beurteilen: Kennwerte nach ISO 230-2, Drift, Ausreißer, Toleranzen</translation>
    </message>
    <message>
        <source>Rule that proposes outliers: mad (the default), grubbs or none</source>
        <translation>Regel, die Ausreißer vorschlägt: mad (Standard), grubbs oder none</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw, in mm or deg</source>
        <translation>Bekannte Periode der Achse, etwa die Steigung ihrer Spindel, in mm oder Grad</translation>
    </message>
    <message>
        <source>Show the figures of VDI/DGQ 3441 as well</source>
        <translation>Auch die Kennwerte nach VDI/DGQ 3441 zeigen</translation>
    </message>
    <message>
        <source>Print the interpolated value at a position, as the drive or the controller of the file computes it</source>
        <translation>Den interpolierten Wert an einer Position ausgeben, wie ihn der Antrieb oder die Steuerung der Datei berechnet</translation>
    </message>
    <message>
        <source>Calibration file or table</source>
        <translation>Kalibrierdatei oder Tabelle</translation>
    </message>
    <message>
        <source>X [Y [Z]], one number per dimension; may be negative</source>
        <translation>X [Y [Z]], eine Zahl je Dimension, auch negativ</translation>
    </message>
    <message>
        <source>File with one position per line, - for standard input; prints one result per line</source>
        <translation>Datei mit einer Position je Zeile, - für die Standardeingabe; gibt je Zeile ein Ergebnis aus</translation>
    </message>
    <message>
        <source>Value outside the table: hold (as the drive does; the default), zero, wrap, extrapolate or error</source>
        <translation>Wert außerhalb der Tabelle: hold (wie der Antrieb; Standard), zero, wrap, extrapolate oder error</translation>
    </message>
    <message>
        <source>Print the value that the controller of this format would apply, after conversion</source>
        <translation>Den Wert ausgeben, den die Steuerung dieses Formats nach der Umwandlung anwenden würde</translation>
    </message>
    <message>
        <source>Machine file (.toml)</source>
        <translation>Maschinendatei (.toml)</translation>
    </message>
    <message>
        <source>Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may be given several times</source>
        <translation>Nur diese Achse, wie die Datei sie nennt, oder SERIAL/AXIS für die eines bestimmten Antriebs; mehrfach möglich</translation>
    </message>
    <message>
        <source>Drives at the same time (16 unless given)</source>
        <translation>Antriebe gleichzeitig (Standard: 16)</translation>
    </message>
    <message>
        <source>Leave drives out that do not answer, which is an error otherwise</source>
        <translation>Antriebe übergehen, die nicht antworten; sonst ist das ein Fehler</translation>
    </message>
    <message>
        <source>Compare the drives of a machine with its machine file, and change nothing</source>
        <translation>Die Antriebe einer Maschine mit ihrer Maschinendatei vergleichen, ohne etwas zu ändern</translation>
    </message>
    <message>
        <source>The exit code is 0 when all drives have what the file says, and 9 when something differs.</source>
        <translation>Der Exit-Code ist 0, wenn alle Antriebe haben, was in der Datei steht, und 9, wenn etwas abweicht.</translation>
    </message>
    <message>
        <source>Write what a machine file says to the drives of the machine, where they differ</source>
        <translation>Den Inhalt einer Maschinendatei in die Antriebe der Maschine schreiben, wo sie davon abweichen</translation>
    </message>
    <message>
        <source>Switch the compensation of axes on and off where the file says so (active), and prove it</source>
        <translation>Die Kompensation von Achsen ein- und ausschalten, wo die Datei es sagt (active), und nachweisen</translation>
    </message>
    <message>
        <source>All drives are planned first, and nothing is written unless all of it is possible. Each write is safe as that of `axiscomp write`. A second apply finds nothing to do.</source>
        <translation>Zuerst werden alle Antriebe geplant, und nichts wird geschrieben, wenn nicht alles möglich ist. Jeder Schreibvorgang ist so sicher wie der von `axiscomp write`. Ein zweites apply hat nichts mehr zu tun.</translation>
    </message>
    <message>
        <source>Print output, indices and sources of an axis as CSV until stopped</source>
        <translation>Ausgang, Indizes und Quellen einer Achse als CSV ausgeben, bis zum Abbruch</translation>
    </message>
    <message>
        <source>Lines per second, 1 to 100 (10 unless given)</source>
        <translation>Zeilen je Sekunde, 1 bis 100 (Standard: 10)</translation>
    </message>
    <message>
        <source>Number of lines; without end unless given</source>
        <translation>Anzahl der Zeilen; ohne Angabe endlos</translation>
    </message>
    <message>
        <source>Download the table that an axis uses</source>
        <translation>Die Tabelle herunterladen, die eine Achse verwendet</translation>
    </message>
    <message>
        <source>File to write, .csv, .TAMtbl or that of another controller; CSV on standard output without it</source>
        <translation>Zu schreibende Datei, .csv, .TAMtbl oder die einer anderen Steuerung; ohne Angabe CSV auf die Standardausgabe</translation>
    </message>
    <message>
        <source>Finish or undo an interrupted write; without an option, say which is possible</source>
        <translation>Einen unterbrochenen Schreibvorgang vollenden oder rückgängig machen; ohne Option sagen, was möglich ist</translation>
    </message>
    <message>
        <source>Bring the complete new state about, from whatever there is now</source>
        <translation>Den vollständigen neuen Zustand herstellen, gleich was jetzt vorhanden ist</translation>
    </message>
    <message>
        <source>Bring back the complete state before the write</source>
        <translation>Den vollständigen Zustand vor dem Schreiben wiederherstellen</translation>
    </message>
    <message>
        <source>Write the report of a record: by how much an axis became better, on one page</source>
        <translation>Den Bericht eines Protokolls schreiben: um wie viel eine Achse besser wurde, auf einer Seite</translation>
    </message>
    <message>
        <source>Record of the compensation (.axcal)</source>
        <translation>Protokoll der Kompensation (.axcal)</translation>
    </message>
    <message>
        <source>The report; its extension says whether it is PDF or HTML</source>
        <translation>Der Bericht; seine Endung sagt, ob er PDF oder HTML ist</translation>
    </message>
    <message>
        <source>Language of the report: en, de, fr, ja or zh</source>
        <translation>Sprache des Berichts: en, de, fr, ja oder zh</translation>
    </message>
    <message>
        <source>Add pages with every target and every value that is left out</source>
        <translation>Seiten mit jeder Zielposition und jedem weggelassenen Wert hinzufügen</translation>
    </message>
    <message>
        <source>Show what is in measurement files, join them, and write them as one CSV</source>
        <translation>Den Inhalt von Messdateien zeigen, sie verbinden und als eine CSV-Datei schreiben</translation>
    </message>
    <message>
        <source>CSV file to write, replaced if it exists; - for standard output</source>
        <translation>Zu schreibende CSV-Datei, eine vorhandene wird ersetzt; - für die Standardausgabe</translation>
    </message>
    <message>
        <source>Write a machine file with all tables from running drives</source>
        <translation>Eine Maschinendatei mit allen Tabellen aus laufenden Antrieben schreiben</translation>
    </message>
    <message>
        <source>Folder for machine.toml and the tables; files of the same names are replaced</source>
        <translation>Ordner für machine.toml und die Tabellen; Dateien mit denselben Namen werden ersetzt</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>Applied to drives with the same serial numbers and without tables, the file gives the same state, and a snapshot of them the same bytes.</source>
        <translation>Auf Antriebe mit denselben Seriennummern und ohne Tabellen angewendet, ergibt die Datei denselben Zustand, und ein snapshot von ihnen dieselben Bytes.</translation>
    </message>
    <message>
        <source>Print the states of drives as OpenMetrics text, for a collector</source>
        <translation>Die Zustände von Antrieben als OpenMetrics-Text ausgeben, für einen Collector</translation>
    </message>
    <message>
        <source>Machine file: its drives, and whether they differ from it</source>
        <translation>Maschinendatei: ihre Antriebe, und ob sie davon abweichen</translation>
    </message>
    <message>
        <source>Compare the outputs of active compensations with their tables now</source>
        <translation>Die Ausgänge aktiver Kompensationen jetzt mit ihren Tabellen vergleichen</translation>
    </message>
    <message>
        <source>File to write, whole or not at all; standard output without it</source>
        <translation>Zu schreibende Datei, ganz oder gar nicht; ohne Angabe die Standardausgabe</translation>
    </message>
    <message>
        <source>Show the compensation of an axis, and the outcome of an interrupted write</source>
        <translation>Die Kompensation einer Achse zeigen, und wie ein unterbrochener Schreibvorgang ausging</translation>
    </message>
    <message>
        <source>Count the drive&apos;s flash operations again after their record was damaged; first wait as long as the drive counts them</source>
        <translation>Die Flash-Vorgänge des Antriebs neu zählen, nachdem ihre Aufzeichnung beschädigt wurde; vorher so lange warten, wie der Antrieb sie zählt</translation>
    </message>
    <message>
        <source>First target</source>
        <translation>Erste Zielposition</translation>
    </message>
    <message>
        <source>Last target, above the first</source>
        <translation>Letzte Zielposition, über der ersten</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>Anzahl der Zielpositionen</translation>
    </message>
    <message>
        <source>Mean distance of targets, instead of --count</source>
        <translation>Mittlerer Abstand der Zielpositionen, statt --count</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw: targets are spread over it</source>
        <translation>Bekannte Periode der Achse, etwa die Steigung ihrer Spindel: Zielpositionen werden darüber verteilt</translation>
    </message>
    <message>
        <source>Runs in each direction (5 unless given)</source>
        <translation>Durchläufe in jeder Richtung (Standard: 5)</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same (1 unless given)</source>
        <translation>Eine andere Zahl gibt andere Zielpositionen, dieselbe dieselben (Standard: 1)</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target (1 % of the range unless given, at most a third of the spacing)</source>
        <translation>Wie weit die Achse vor der ersten Zielposition eines Durchlaufs in dessen Richtung fährt (Standard: 1 % des Bereichs, höchstens ein Drittel des Abstands)</translation>
    </message>
    <message>
        <source>Feed in mm or deg per minute (1000 unless given)</source>
        <translation>Vorschub in mm oder Grad je Minute (Standard: 1000)</translation>
    </message>
    <message>
        <source>Seconds at each target (5 unless given): time to stand still and be measured</source>
        <translation>Sekunden an jeder Zielposition (Standard: 5): Zeit, um zur Ruhe zu kommen und gemessen zu werden</translation>
    </message>
    <message>
        <source>Choose the targets of a measurement: a plan, or a program for the machine&apos;s control</source>
        <translation>Die Zielpositionen einer Messung wählen: ein Messplan oder ein Programm für die Steuerung der Maschine</translation>
    </message>
    <message>
        <source>Name of the axis (X unless given)</source>
        <translation>Name der Achse (Standard: X)</translation>
    </message>
    <message>
        <source>Unit of all positions: mm (the default) or deg</source>
        <translation>Einheit aller Positionen: mm (Standard) oder deg</translation>
    </message>
    <message>
        <source>Write G-code for this control: linuxcnc, fanuc or siemens</source>
        <translation>G-Code für diese Steuerung schreiben: linuxcnc, fanuc oder siemens</translation>
    </message>
    <message>
        <source>List the table files of a drive</source>
        <translation>Die Tabellendateien eines Antriebs auflisten</translation>
    </message>
    <message>
        <source>Upload a file unchanged and verify it, for drive programs that use tables</source>
        <translation>Eine Datei unverändert übertragen und verifizieren, für Antriebsprogramme, die Tabellen verwenden</translation>
    </message>
    <message>
        <source>File on this computer</source>
        <translation>Datei auf diesem Rechner</translation>
    </message>
    <message>
        <source>Path in the drive, such as tables/small1.TAMtbl</source>
        <translation>Pfad im Antrieb, etwa tables/small1.TAMtbl</translation>
    </message>
    <message>
        <source>Download a file unchanged</source>
        <translation>Eine Datei unverändert herunterladen</translation>
    </message>
    <message>
        <source>Register that supplies the position of dimension 1: path, tam:// URI or address (0x1234)</source>
        <translation>Register, das die Position für Dimension 1 liefert: Pfad, tam://-URI oder Adresse (0x1234)</translation>
    </message>
    <message>
        <source>The same for dimension 2</source>
        <translation>Dasselbe für Dimension 2</translation>
    </message>
    <message>
        <source>The same for dimension 3</source>
        <translation>Dasselbe für Dimension 3</translation>
    </message>
    <message>
        <source>The source is the axis&apos;s own position, for tables of one dimension; with --map each axis&apos;s own</source>
        <translation>Die Quelle ist die eigene Position der Achse, für Tabellen mit einer Dimension; mit --map die eigene jeder Achse</translation>
    </message>
    <message>
        <source>Write a compensation table to an axis in the safe order, and verify it</source>
        <translation>Eine Kompensationstabelle in sicherer Reihenfolge auf eine Achse schreiben und verifizieren</translation>
    </message>
    <message>
        <source>Calibration file (.csv), table (.TAMtbl), or file of another controller; without it the axis keeps its table</source>
        <translation>Kalibrierdatei (.csv), Tabelle (.TAMtbl) oder Datei einer anderen Steuerung; ohne Angabe behält die Achse ihre Tabelle</translation>
    </message>
    <message>
        <source>Record of a compensation in place of --data: its table is written, and it notes drive, slot and CRC</source>
        <translation>Protokoll einer Kompensation statt --data: seine Tabelle wird geschrieben, und es hält Antrieb, Tabellenplatz und CRC fest</translation>
    </message>
    <message>
        <source>Store the table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>Die Tabelle im Flash-Speicher des Antriebs ablegen, sodass sie einen Neustart übersteht</translation>
    </message>
    <message>
        <source>Keep the table in memory until the next reboot (the default for a new table)</source>
        <translation>Die Tabelle bis zum nächsten Neustart im Arbeitsspeicher halten (Standard für eine neue Tabelle)</translation>
    </message>
    <message>
        <source>Unit of the values in place of what the file says, such as um; drive for the drive&apos;s own</source>
        <translation>Einheit der Werte statt der in der Datei genannten, etwa um; drive für die des Antriebs</translation>
    </message>
    <message>
        <source>The same for the positions</source>
        <translation>Dasselbe für die Positionen</translation>
    </message>
    <message>
        <source>Slot to use, small1 to small8, large1 or large2; chosen unless given</source>
        <translation>Zu verwendender Tabellenplatz, small1 bis small8, large1 oder large2; ohne Angabe wird einer gewählt</translation>
    </message>
    <message>
        <source>Write this column of the file (name or number) to this axis; AXIS alone is the column that is named as the axis. May be given several times. Nothing is written unless all of the writes are possible</source>
        <translation>Diese Spalte der Datei (Name oder Nummer) auf diese Achse schreiben; AXIS allein ist die Spalte, die wie die Achse heißt. Mehrfach möglich. Nichts wird geschrieben, wenn nicht alle Schreibvorgänge möglich sind</translation>
    </message>
    <message>
        <source>Write corrections above 1 % of the range, or with a slope above 0.1, which without this are taken for a wrong unit</source>
        <translation>Auch Korrekturen über 1 % des Bereichs oder mit einer Steigung über 0,1 schreiben, die sonst als Zeichen einer falschen Einheit gelten</translation>
    </message>
    <message>
        <source>Without --source1 the axis keeps its sources. The compensation stays off: `axiscomp activate` switches it on.</source>
        <translation>Ohne --source1 behält die Achse ihre Quellen. Die Kompensation bleibt ausgeschaltet: `axiscomp activate` schaltet sie ein.</translation>
    </message>
    <message>
        <source>Axis that the values correct, for each column or for all: its name, #1 for the first source, or other for an axis that is no source; by default as the file says</source>
        <translation>Achse, die von den Werten korrigiert wird, für jede Spalte oder für alle: ihr Name, #1 für die erste Quelle oder other für eine Achse, die keine Quelle ist; Standard ist, was die Datei sagt</translation>
    </message>
    <message>
        <source>Conversion</source>
        <translation>Umwandlung</translation>
    </message>
    <message>
        <source>Convention of the input: feedback (added to the encoder position) or command (added to the commanded position); by default that of its format, needed where that is assumed</source>
        <translation>Konvention der Eingabe: feedback (zur Geberposition addiert) oder command (zur Sollposition addiert); Standard ist die ihres Formats, nötig, wo diese nur angenommen wird</translation>
    </message>
    <message>
        <source>Which values to use if the file has both directions of motion: mean, positive or negative</source>
        <translation>Zu verwendende Werte, wenn die Datei beide Bewegungsrichtungen enthält: mean, positive oder negative</translation>
    </message>
    <message>
        <source>Multiply the values by this number, before anything else</source>
        <translation>Die Werte vor allem anderen mit dieser Zahl multiplizieren</translation>
    </message>
    <message>
        <source>Add this to the values, in their unit</source>
        <translation>Dies zu den Werten addieren, in ihrer Einheit</translation>
    </message>
    <message>
        <source>Shift the values so that they are 0 at this position</source>
        <translation>Die Werte so verschieben, dass sie an dieser Position 0 sind</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a linear one</source>
        <translation>Eine Moduloachse als lineare Achse behandeln</translation>
    </message>
    <message>
        <source>Resample onto an even grid with N points, for each source or for all</source>
        <translation>Auf ein gleichmäßiges Gitter mit N Stützstellen umrechnen, für jede Quelle oder für alle</translation>
    </message>
    <message>
        <source>Resample onto an even grid with spacing D, for each source or for all</source>
        <translation>Auf ein gleichmäßiges Gitter mit Abstand D umrechnen, für jede Quelle oder für alle</translation>
    </message>
    <message>
        <source>Resample onto the coarsest even grid within this deviation, in the unit of the values</source>
        <translation>Auf das gröbste gleichmäßige Gitter innerhalb dieser Abweichung umrechnen, in der Einheit der Werte</translation>
    </message>
    <message>
        <source>Between the points of the source: linear (the default), cubic (monotone), spline (natural cubic) or smooth (smoothing spline)</source>
        <translation>Zwischen den Punkten der Quelle: linear (Standard), cubic (monoton), spline (natürlich kubisch) oder smooth (Glättungsspline)</translation>
    </message>
    <message>
        <source>Speed of the axis in positions per second: says the steps of the velocity that are left with spline and smooth</source>
        <translation>Geschwindigkeit der Achse in Positionseinheiten je Sekunde: nennt die Geschwindigkeitssprünge, die mit spline und smooth bleiben</translation>
    </message>
    <message>
        <source>Let the even grid extend beyond the data, where the end values are held</source>
        <translation>Das gleichmäßige Gitter darf über die Daten hinausgehen, wo die Endwerte gehalten werden</translation>
    </message>
    <message>
        <source>Convention of the output: feedback or command; by default that of its format, needed where that is assumed</source>
        <translation>Konvention der Ausgabe: feedback oder command; Standard ist die ihres Formats, nötig, wo diese nur angenommen wird</translation>
    </message>
    <message>
        <source>Setting that the output format needs; `axiscomp formats NAME` lists them</source>
        <translation>Angabe, die das Ausgabeformat braucht; `axiscomp formats NAME` listet sie auf</translation>
    </message>
    <message>
        <source>Corrections, made only when asked for</source>
        <translation>Korrekturen, nur auf Wunsch</translation>
    </message>
    <message>
        <source>Temperature of the axis&apos;s scale in C</source>
        <translation>Temperatur des Maßstabs der Achse in °C</translation>
    </message>
    <message>
        <source>Coefficient of expansion of the axis&apos;s scale in 1/K, such as 11.5e-6</source>
        <translation>Ausdehnungskoeffizient des Maßstabs der Achse in 1/K, etwa 11.5e-6</translation>
    </message>
    <message>
        <source>Temperature of the reference in C</source>
        <translation>Temperatur der Referenz in °C</translation>
    </message>
    <message>
        <source>Coefficient of the reference in 1/K; 0 for a laser with wavelength compensation</source>
        <translation>Ausdehnungskoeffizient der Referenz in 1/K; 0 für einen Laser mit Wellenlängenkompensation</translation>
    </message>
    <message>
        <source>Position in mm that does not move with temperature; the first target unless given</source>
        <translation>Position in mm, die sich mit der Temperatur nicht bewegt; ohne Angabe die erste Zielposition</translation>
    </message>
    <message>
        <source>The values are not corrected to 20 C, where the file does not say it</source>
        <translation>Die Werte sind nicht auf 20 °C korrigiert, wenn die Datei es nicht sagt</translation>
    </message>
    <message>
        <source>Dead path of the interferometer: a JSON file with its length and the air of each run</source>
        <translation>Totstrecke des Interferometers: eine JSON-Datei mit ihrer Länge und der Luft jedes Durchlaufs</translation>
    </message>
    <message>
        <source>Limits, such as A=10um,R=4um; exit code 8 when one is not met</source>
        <translation>Grenzen, etwa A=10um,R=4um; Exit-Code 8, wenn eine nicht eingehalten ist</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms</source>
        <translation>Messunsicherheit mit k = 2: U=2.1um, oder eine JSON-Datei mit ihren Anteilen</translation>
    </message>
    <message>
        <source>Measurement files, joined when there are several; - for standard input</source>
        <translation>Messdateien, mehrere werden verbunden; - für die Standardeingabe</translation>
    </message>
    <message>
        <source>Format of the files, if their content leaves it open</source>
        <translation>Format der Dateien, wenn ihr Inhalt es offenlässt</translation>
    </message>
    <message>
        <source>Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>Werte weglassen: down:1:1 (Richtung, Zielposition, Durchlauf), run:up:3 oder target:7, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>Aufwärts und abwärts tauschen</translation>
    </message>
    <message>
        <source>What a file leaves open</source>
        <translation>Was eine Datei offenlässt</translation>
    </message>
    <message>
        <source>Which column of a CSV file is what, by number or name: &apos;target=1,direction=3,deviation=5&apos;</source>
        <translation>Welche Spalte einer CSV-Datei was ist, nach Nummer oder Name: &apos;target=1,direction=3,deviation=5&apos;</translation>
    </message>
    <message>
        <source>Lines before the header of a CSV file</source>
        <translation>Zeilen vor der Kopfzeile einer CSV-Datei</translation>
    </message>
    <message>
        <source>Unit of targets and encoder</source>
        <translation>Einheit von Zielpositionen und Geber</translation>
    </message>
    <message>
        <source>Unit of deviations and reference</source>
        <translation>Einheit von Abweichungen und Referenz</translation>
    </message>
    <message>
        <source>What the values are: deviation (reference minus target) or reference (positions)</source>
        <translation>Was die Werte sind: deviation (Referenz minus Zielposition) oder reference (Positionen)</translation>
    </message>
    <message>
        <source>order: the direction of a run follows from the order of its targets</source>
        <translation>order: die Richtung eines Durchlaufs folgt aus der Reihenfolge seiner Zielpositionen</translation>
    </message>
    <message>
        <source>How far a track moves after a turn before its samples count, in mm or deg; 1 % of the range unless given</source>
        <translation>Wie weit die Achse einer Bahn nach einer Umkehr fährt, bevor Messpunkte zählen, in mm oder Grad; Standard: 1 % des Bereichs</translation>
    </message>
    <message>
        <source>Number of dimensions of a CSV file: its first D columns are positions</source>
        <translation>Anzahl der Dimensionen einer CSV-Datei: ihre ersten D Spalten sind Positionen</translation>
    </message>
    <message>
        <source>Format of the input, if content and name leave it open</source>
        <translation>Format der Eingabe, wenn Inhalt und Name es offenlassen</translation>
    </message>
    <message>
        <source>Setting that the file leaves open; `axiscomp formats NAME` lists them</source>
        <translation>Angabe, die die Datei offenlässt; `axiscomp formats NAME` listet sie auf</translation>
    </message>
    <message>
        <source>Incomplete grids</source>
        <translation>Unvollständige Gitter</translation>
    </message>
    <message>
        <source>Give points without a value that of the nearest measured point (nearest), of the plane through all of them (plane), or the values that bend least (smooth)</source>
        <translation>Punkten ohne Wert den des nächsten gemessenen Punkts geben (nearest), den der Ebene durch alle Punkte (plane) oder die Werte mit der kleinsten Krümmung (smooth)</translation>
    </message>
    <message>
        <source>Cut the grid to the largest part in which every point has a value</source>
        <translation>Das Gitter auf den größten Teil beschneiden, in dem jeder Punkt einen Wert hat</translation>
    </message>
    <message>
        <source>Take positions of a calibration file that are this close to the grid for grid positions, in their unit</source>
        <translation>Positionen einer Kalibrierdatei auf das Gitter legen, wenn sie ihm so nahe sind, in ihrer Einheit</translation>
    </message>
    <message>
        <source>Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either); not needed if there is only one</source>
        <translation>Tabelle der Datei, nach Name oder Nummer ab 1 (name:TEXT, #N, wenn es beides sein könnte); bei nur einer nicht nötig</translation>
    </message>
    <message>
        <source>Drive profile (JSON) in place of the built-in one, generic</source>
        <translation>Antriebsprofil (JSON) statt des eingebauten, generic</translation>
    </message>
    <message>
        <source>Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given</source>
        <translation>Adresse des Antriebs, mehrfach möglich; ohne Angabe $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Address of the drive; $AXISCOMP_DRIVE unless given</source>
        <translation>Adresse des Antriebs; ohne Angabe $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Trust the https certificate with this fingerprint from now on; any other one is refused</source>
        <translation>Dem https-Zertifikat mit diesem Fingerabdruck von nun an vertrauen; jedes andere wird abgelehnt</translation>
    </message>
    <message>
        <source>Time limit for one exchange with the drive (5 unless given)</source>
        <translation>Zeitlimit für einen Austausch mit dem Antrieb (Standard: 5)</translation>
    </message>
    <message>
        <source>Index or name of the axis; not needed if the drive has only one</source>
        <translation>Index oder Name der Achse; nicht nötig, wenn der Antrieb nur eine hat</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Show this help</source>
        <translation>Diese Hilfe zeigen</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Argumente</translation>
    </message>
    <message>
        <source>options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMAND</translation>
    </message>
    <message>
        <source>usage</source>
        <translation>Aufruf</translation>
    </message>
    <message>
        <source>Serve the drive&apos;s web pages here; port 0 picks a free one (127.0.0.1:0 unless this or --serial is given). Several drives take ports in a row</source>
        <translation>Die Webseiten des Antriebs hier bereitstellen; Port 0 wählt einen freien (127.0.0.1:0, wenn weder dies noch --serial angegeben ist). Mehrere Antriebe belegen aufeinanderfolgende Ports</translation>
    </message>
    <message>
        <source>Serve the serial link on a pseudo-terminal, and make LINK a symbolic link to it. Several drives take LINK, LINK-2, ...</source>
        <translation>Die serielle Verbindung auf einem Pseudoterminal bereitstellen und LINK als symbolischen Link darauf anlegen. Mehrere Antriebe belegen LINK, LINK-2, ...</translation>
    </message>
    <message>
        <source>Make the serial link as slow as a line of this speed (as fast as it can unless given)</source>
        <translation>Die serielle Verbindung so langsam machen wie eine Leitung dieser Geschwindigkeit (ohne Angabe so schnell wie möglich)</translation>
    </message>
    <message>
        <source>Name of the drive (Virtual-1 unless given)</source>
        <translation>Name des Antriebs (Standard: Virtual-1)</translation>
    </message>
    <message>
        <source>Number of axes, 1 to 16 (2 unless given)</source>
        <translation>Anzahl der Achsen, 1 bis 16 (Standard: 2)</translation>
    </message>
    <message>
        <source>Take names, axes and parameters from a TAM configuration; several drives in it are several virtual drives</source>
        <translation>Namen, Achsen und Parameter aus einer TAM-Konfiguration nehmen; mehrere Antriebe darin ergeben mehrere virtuelle Antriebe</translation>
    </message>
    <message>
        <source>Move the machine of this file (JSON): axes with errors that nobody knows, and an instrument that measures them</source>
        <translation>Die Maschine dieser Datei (JSON) bewegen: Achsen mit Fehlern, die niemand kennt, und ein Messgerät, das sie misst</translation>
    </message>
    <message>
        <source>Play this measuring plan (axiscomp targets) as the machine&apos;s control would, from 10 s after the start</source>
        <translation>Diesen Messplan (axiscomp targets) abspielen, wie es die Steuerung der Maschine täte, ab 10 s nach dem Start</translation>
    </message>
    <message>
        <source>Begin the program so many seconds after the start, whatever --speed is; unless given, after 10 s of the machine&apos;s time</source>
        <translation>Das Programm so viele Sekunden nach dem Start beginnen, gleich was --speed ist; ohne Angabe nach 10 s Maschinenzeit</translation>
    </message>
    <message>
        <source>Serve the instrument&apos;s lines on a pseudo-terminal, and make LINK a symbolic link to it</source>
        <translation>Die Zeilen des Messgeräts auf einem Pseudoterminal bereitstellen und LINK als symbolischen Link darauf anlegen</translation>
    </message>
    <message>
        <source>Keep flash and saved parameters here across runs, a folder per drive</source>
        <translation>Flash-Speicher und gespeicherte Parameter hier von Aufruf zu Aufruf aufbewahren, ein Ordner je Antrieb</translation>
    </message>
    <message>
        <source>Misbehave: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, reboot-after=N or reject=CODE; may be given several times</source>
        <translation>Fehlverhalten: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, reboot-after=N oder reject=CODE; mehrfach möglich</translation>
    </message>
    <message>
        <source>Simulated seconds per second (1 unless given)</source>
        <translation>Simulierte Sekunden je Sekunde (Standard: 1)</translation>
    </message>
    <message>
        <source>Start with axes that are not homed</source>
        <translation>Mit nicht referenzierten Achsen beginnen</translation>
    </message>
    <message>
        <source>Ask for this user name</source>
        <translation>Diesen Benutzernamen verlangen</translation>
    </message>
    <message>
        <source>File whose first line is the password of --user</source>
        <translation>Datei, deren erste Zeile das Passwort zu --user ist</translation>
    </message>
    <message>
        <source>Serve https with this certificate</source>
        <translation>https mit diesem Zertifikat bereitstellen</translation>
    </message>
    <message>
        <source>Private key of --certificate</source>
        <translation>Privater Schlüssel zu --certificate</translation>
    </message>
    <message>
        <source>A servo drive in software, with the web pages, registers and behaviour of a real one.</source>
        <translation>Ein Servoantrieb in Software, mit den Webseiten, den Registern und dem Verhalten eines echten.</translation>
    </message>
    <message>
        <source>Prints a line `ready http=URL serial=DEVICE drive=NAME` for each drive, and runs until Ctrl-C.</source>
        <translation>Gibt für jeden Antrieb eine Zeile `ready http=URL serial=DEVICE drive=NAME` aus und läuft bis Strg+C.</translation>
    </message>
    <message>
        <source>Use this drive in place of the remembered ones; may be given several times: http://[user:password@]host[:port], https://..., serial:/dev/ttyUSB0[?baud=N], demo:</source>
        <translation>Diesen Antrieb statt der gemerkten verwenden; mehrfach möglich: http://[benutzer:passwort@]host[:port], https://..., serial:/dev/ttyUSB0[?baud=N], demo:</translation>
    </message>
    <message>
        <source>Open this file of compensation data</source>
        <translation>Diese Datei mit Kompensationsdaten öffnen</translation>
    </message>
    <message>
        <source>How long one exchange with a drive may take (5 unless given)</source>
        <translation>Wie lange ein Austausch mit einem Antrieb dauern darf (Standard: 5)</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to servo drives, in a window.</source>
        <translation>Schreibt Kompensationstabellen für gemessene Achsfehler in Servoantriebe, in einem Fenster.</translation>
    </message>
    <message>
        <source>Without --drive it uses the drives of the last time, or the built-in demo drive.</source>
        <translation>Ohne --drive verwendet es die Antriebe vom letzten Mal oder den eingebauten Demo-Antrieb.</translation>
    </message>
    <message>
        <source>Let the drive look up the table without adding its values</source>
        <translation>Den Antrieb die Tabelle auswerten lassen, ohne ihre Werte zu addieren</translation>
    </message>
    <message>
        <source>Activate the compensation, and compare the drive&apos;s output with the table</source>
        <translation>Die Kompensation aktivieren und den Ausgang des Antriebs mit der Tabelle vergleichen</translation>
    </message>
    <message>
        <source>Deactivate the compensation</source>
        <translation>Die Kompensation deaktivieren</translation>
    </message>
    <message>
        <source>Store the axis&apos;s table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>Die Tabelle der Achse im Flash-Speicher des Antriebs ablegen, sodass sie einen Neustart übersteht</translation>
    </message>
    <message>
        <source>Make the axis&apos;s table volatile, so that it is lost at the next reboot</source>
        <translation>Die Tabelle der Achse flüchtig machen, sodass sie beim nächsten Neustart verloren geht</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Dieser Rechner</translation>
    </message>
    <message>
        <source>Show what this computer has and lacks, and what each known drive answers</source>
        <translation>Zeigen, was dieser Rechner hat und was ihm fehlt, und was jeder bekannte Antrieb antwortet</translation>
    </message>
    <message>
        <source>Time limit for all that a drive is asked (5 unless given)</source>
        <translation>Zeitlimit für alles, was ein Antrieb gefragt wird (Standard: 5)</translation>
    </message>
    <message>
        <source>The connections of the window are asked too. Nothing is changed, on this computer or on a drive. What is printed has no passwords in it and is meant to be sent to whoever helps.</source>
        <translation>Die Verbindungen des Fensters werden auch gefragt. Weder auf diesem Rechner noch auf einem Antrieb wird etwas geändert. Was ausgegeben wird, enthält keine Passwörter und ist für den bestimmt, der hilft.</translation>
    </message>
    <message>
        <source>Open this file: a record (.axcal), a machine file (.toml), a TAM configuration (.TAMcfg), a table or a measurement</source>
        <translation>Diese Datei öffnen: ein Protokoll (.axcal), eine Maschinendatei (.toml), eine TAM-Konfiguration (.TAMcfg), eine Tabelle oder eine Messung</translation>
    </message>
    <message>
        <source>Measurement before and measurement after; with a record, which has the first, the second alone is enough</source>
        <translation>Messung vorher und Messung nachher; mit einem Protokoll, das die erste enthält, genügt die zweite allein</translation>
    </message>
    <message>
        <source>Leave values of the second measurement out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>Werte der zweiten Messung weglassen: down:1:1 (Richtung, Zielposition, Durchlauf), run:up:3 oder target:7, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Record of the compensation: the first measurement with its exclusions and corrections, prediction, table and tolerances</source>
        <translation>Protokoll der Kompensation: die erste Messung mit ihren Ausschlüssen und Korrekturen, Vorhersage, Tabelle und Toleranzen</translation>
    </message>
    <message>
        <source>Where the drive looks its table up (the input or the output, whichever is the drive&apos;s): encoder (before the compensation) or set (after it); by default as the file says, or encoder</source>
        <translation>Wo der Antrieb in seiner Tabelle (Eingabe oder Ausgabe) nachschlägt: encoder (vor der Kompensation) oder set (danach); sonst wie die Datei es sagt, oder encoder</translation>
    </message>
</context>
<context>
    <name>JudgeOutlook</name>
    <message>
        <source>%1: not defined, so that the tolerance %2 cannot be met.</source>
        <translation>%1: nicht definiert, so dass die Toleranz %2 nicht eingehalten sein kann.</translation>
    </message>
    <message>
        <source>%1: %2, nearer to the tolerance %3 than the uncertainty. That is undecided.</source>
        <translation>%1: %2, näher an der Toleranz %3 als die Messunsicherheit. Das ist nicht entscheidbar.</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. Go on to Fit: a table may make it smaller.</source>
        <translation>%1: %2, über der Toleranz %3. Weiter mit Anpassen: eine Tabelle kann sie verkleinern.</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. No table makes it smaller: look at the mechanics.</source>
        <translation>%1: %2, über der Toleranz %3. Keine Tabelle verkleinert sie: sehen Sie nach der Mechanik.</translation>
    </message>
    <message>
        <source>Add the files of a measurement on the tab Measure.</source>
        <translation>Fügen Sie auf der Seite Messen die Dateien einer Messung hinzu.</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>Die Dateien werden gelesen …</translation>
    </message>
    <message>
        <source>A file cannot be used: the tab Measure says why.</source>
        <translation>Eine Datei ist nicht verwendbar: die Seite Messen sagt, warum.</translation>
    </message>
    <message>
        <source>This measurement has no targets, and so no figures of ISO 230-2. Go on to Fit, or measure at targets.</source>
        <translation>Diese Messung hat keine Zielpositionen und damit keine Kennwerte nach ISO 230-2. Weiter mit Anpassen, oder messen Sie an Zielpositionen.</translation>
    </message>
    <message>
        <source>Enter the tolerances of the axis, or go on to Fit.</source>
        <translation>Geben Sie die Toleranzen der Achse ein, oder weiter mit Anpassen.</translation>
    </message>
    <message>
        <source>Every tolerance is met. A table can still make the axis better: go on to Fit.</source>
        <translation>Jede Toleranz ist eingehalten. Eine Tabelle kann die Achse noch verbessern: weiter mit Anpassen.</translation>
    </message>
    <message>
        <source>The standard&apos;s condition “%1” is not met.</source>
        <translation>Die Bedingung „%1“ der Norm ist nicht erfüllt.</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>Dimensionalität</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>Dim{n}Source</source>
        <translation>Dim{n}-Quelle</translation>
    </message>
    <message>
        <source>problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>has all of this</source>
        <translation>hat das alles</translation>
    </message>
    <message>
        <source>unfinished write</source>
        <translation>unterbrochener Schreibvorgang</translation>
    </message>
    <message>
        <source>Activation</source>
        <translation>Aktivierung</translation>
    </message>
    <message>
        <source>differs: {fields}</source>
        <translation>weicht ab: {fields}</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>written and switched</source>
        <translation>geschrieben und geschaltet</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>switched</source>
        <translation>geschaltet</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>nichts zu tun</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>nicht geschrieben</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>{slot}, empty</source>
        <translation>{slot}, leer</translation>
    </message>
    <message>
        <source>{slot}, persistent, CRC {crc}</source>
        <translation>{slot}, dauerhaft, CRC {crc}</translation>
    </message>
    <message>
        <source>{slot}, volatile, CRC {crc}</source>
        <translation>{slot}, flüchtig, CRC {crc}</translation>
    </message>
    <message>
        <source>switched, not written</source>
        <translation>geschaltet, nicht geschrieben</translation>
    </message>
    <message>
        <source>written, not switched</source>
        <translation>geschrieben, nicht geschaltet</translation>
    </message>
    <message>
        <source>not switched</source>
        <translation>nicht geschaltet</translation>
    </message>
    <message>
        <source>{outcome}, proved</source>
        <translation>{outcome}, nachgewiesen</translation>
    </message>
    <message>
        <source>{outcome}, not proved</source>
        <translation>{outcome}, nicht nachgewiesen</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>the file states the temperature</source>
        <translation>die Datei nennt die Temperatur</translation>
    </message>
    <message>
        <source>the file states the instrument</source>
        <translation>die Datei nennt das Messgerät</translation>
    </message>
    <message>
        <source>the file states the feed</source>
        <translation>die Datei nennt den Vorschub</translation>
    </message>
    <message>
        <source>the file states the dwell</source>
        <translation>die Datei nennt die Verweilzeit</translation>
    </message>
    <message>
        <source>at least {due} targets over {range}: {count}</source>
        <translation>mindestens {due} Zielpositionen auf {range}: {count}</translation>
    </message>
    <message>
        <source>a target about every 250 mm on an axis above 2 m: {count} over {range}, at most {gap} apart</source>
        <translation>eine Zielposition etwa alle 250 mm bei einer Achse über 2 m: {count} auf {range}, höchstens {gap} auseinander</translation>
    </message>
    <message>
        <source>at least 5 targets, and 5 for each metre: {count} over {range}</source>
        <translation>mindestens 5 Zielpositionen und 5 je Meter: {count} auf {range}</translation>
    </message>
    <message>
        <source>a run in each direction on an axis above 2 m, for E, B and M alone: {count}</source>
        <translation>ein Durchlauf in jeder Richtung bei einer Achse über 2 m, nur für E, B und M: {count}</translation>
    </message>
    <message>
        <source>5 runs in each direction: the file has means</source>
        <translation>5 Durchläufe in jeder Richtung: die Datei enthält Mittelwerte</translation>
    </message>
    <message>
        <source>5 runs in each direction: {count} at the target with the fewest</source>
        <translation>5 Durchläufe in jeder Richtung: {count} an der Zielposition mit den wenigsten</translation>
    </message>
    <message>
        <source>every target is approached in both directions</source>
        <translation>jede Zielposition ist in beiden Richtungen angefahren</translation>
    </message>
    <message>
        <source>the targets are not all at the same place of the period {period}</source>
        <translation>die Zielpositionen liegen nicht alle an derselben Stelle der Periode {period}</translation>
    </message>
    <message>
        <source>reversal value B</source>
        <translation>Umkehrspanne B</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <translation>mittlere Umkehrspanne</translation>
    </message>
    <message>
        <source>range of the mean deviation M</source>
        <translation>Spanne der mittleren Abweichung M</translation>
    </message>
    <message>
        <source>systematic deviation E, up</source>
        <translation>systematische Abweichung E, aufwärts</translation>
    </message>
    <message>
        <source>systematic deviation E, down</source>
        <translation>systematische Abweichung E, abwärts</translation>
    </message>
    <message>
        <source>systematic deviation E</source>
        <translation>systematische Abweichung E</translation>
    </message>
    <message>
        <source>repeatability R, up</source>
        <translation>Wiederholpräzision R, aufwärts</translation>
    </message>
    <message>
        <source>repeatability R, down</source>
        <translation>Wiederholpräzision R, abwärts</translation>
    </message>
    <message>
        <source>repeatability R</source>
        <translation>Wiederholpräzision R</translation>
    </message>
    <message>
        <source>accuracy A, up</source>
        <translation>Genauigkeit A, aufwärts</translation>
    </message>
    <message>
        <source>accuracy A, down</source>
        <translation>Genauigkeit A, abwärts</translation>
    </message>
    <message>
        <source>accuracy A</source>
        <translation>Genauigkeit A</translation>
    </message>
    <message>
        <source>the runs {direction} drift by {drift} from the first to the last, more than their spread explains</source>
        <translation>die Durchläufe {direction} driften vom ersten zum letzten um {drift}, mehr als ihre Streuung erklärt</translation>
    </message>
    <message>
        <source>more than a fifth of the values {direction} do not fit the others: the measurement was disturbed, and nothing is proposed</source>
        <translation>mehr als ein Fünftel der Werte {direction} passt nicht zu den anderen: die Messung war gestört, es wird nichts vorgeschlagen</translation>
    </message>
    <message numerus="yes">
        <source>{count} values excluded, not an evaluation by ISO 230-2</source>
        <comment>1 value excluded, not an evaluation by ISO 230-2</comment>
        <translation>
            <numerusform>1 Wert ausgeschlossen, keine Auswertung nach ISO 230-2</numerusform>
            <numerusform>{count} Werte ausgeschlossen, keine Auswertung nach ISO 230-2</numerusform>
        </translation>
    </message>
    <message>
        <source>the file says {figure} = {published}</source>
        <translation>die Datei sagt: {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}, which is less than its own {figure} = {published}</source>
        <translation>{statement}, das ist weniger als in derselben Datei {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}; computed from its values: {computed}</source>
        <translation>{statement}; aus ihren Werten berechnet: {computed}</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>nicht entscheidbar</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>means of runs</source>
        <translation>Mittelwerte von Durchläufen</translation>
    </message>
    <message>
        <source>a track without targets</source>
        <translation>eine Bahn ohne Zielpositionen</translation>
    </message>
    <message>
        <source>points of a plane or space</source>
        <translation>Punkte einer Ebene oder eines Raums</translation>
    </message>
    <message>
        <source>runs over targets</source>
        <translation>Durchläufe über Zielpositionen</translation>
    </message>
    <message>
        <source>up</source>
        <translation>aufwärts</translation>
    </message>
    <message>
        <source>down</source>
        <translation>abwärts</translation>
    </message>
    <message>
        <source>a slope of {slope} over {length} was taken out</source>
        <translation>eine Steigung von {slope} über {length} wurde herausgenommen</translation>
    </message>
    <message>
        <source>the steepest part of {table} is between {from} and {to}: {step}, {slope} for each {one}</source>
        <translation>am steilsten ist {table} zwischen {from} und {to}: {step}, das sind {slope} je {one}</translation>
    </message>
    <message>
        <source>a drive holds numbers with 24 bits, which changes a value of {table} by at most {rounding}</source>
        <translation>ein Antrieb hält Zahlen mit 24 Bit; das ändert einen Wert von {table} um höchstens {rounding}</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of {table} have nothing measured beside them and were filled</source>
        <comment>1 point of {table} has nothing measured beside it and was filled</comment>
        <translation>
            <numerusform>neben 1 Punkt von {table} wurde nichts gemessen; er wurde gefüllt</numerusform>
            <numerusform>neben {count} Punkten von {table} wurde nichts gemessen; sie wurden gefüllt</numerusform>
        </translation>
    </message>
    <message>
        <source>merged onto {name} with gain {gain}: a value changes by at most {change}, at {place}</source>
        <translation>in {name} eingerechnet, Faktor {gain}: ein Wert ändert sich um höchstens {change}, bei {place}</translation>
    </message>
    <message>
        <source>the table improves little: {figure} from {before} to {after}, less than a fifth</source>
        <translation>die Tabelle bessert wenig: {figure} von {before} auf {after}, weniger als ein Fünftel</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}; measure at more targets</source>
        <translation>zwischen den Zielpositionen ist der Fehler nicht gut genug bekannt: ohne die jeweilige Zielposition vorhergesagt ist M {heldOut}; messen Sie an mehr Zielpositionen</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>zwischen den Zielpositionen ist der Fehler nicht gut genug bekannt: ohne die jeweilige Zielposition vorhergesagt ist M {heldOut}, vorher war es {before}; messen Sie an mehr Zielpositionen</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: up to {reversal} remains in each direction</source>
        <translation>dieser Fehler ist vor allem Umkehrspanne, die keine Tabelle beseitigt: bis zu {reversal} bleiben in jeder Richtung</translation>
    </message>
    <message>
        <source>the table is for both directions: up to {reversal} of the reversal remains in each</source>
        <translation>die Tabelle gilt für beide Richtungen: von der Umkehrspanne bleiben in jeder bis zu {reversal}</translation>
    </message>
    <message>
        <source>the table is for one direction: in the other up to {reversal} of reversal remains</source>
        <translation>die Tabelle gilt für eine Richtung: in der anderen bleiben bis zu {reversal} Umkehrspanne</translation>
    </message>
    <message>
        <source>{count} targets lie in {turns} periods of {period}</source>
        <translation>{count} Zielpositionen liegen in {turns} Perioden von {period}</translation>
    </message>
    <message>
        <source>{table} adds {value} at the home position {home}</source>
        <translation>{table} addiert am Referenzpunkt {home} {value}</translation>
    </message>
    <message>
        <source>over a turn, from {from} to {to}, {table} ends {jump} above where it begins</source>
        <translation>über eine Umdrehung, von {from} bis {to}, endet {table} {jump} über ihrem Anfang</translation>
    </message>
    <message>
        <source>the compensation off</source>
        <translation>ausgeschalteter Kompensation</translation>
    </message>
    <message>
        <source>the compensation on</source>
        <translation>eingeschalteter Kompensation</translation>
    </message>
    <message>
        <source>the table {crc} active</source>
        <translation>aktiver Tabelle {crc}</translation>
    </message>
    <message>
        <source>measured with the table {crc} of {name} active</source>
        <translation>gemessen, während die Tabelle {crc} von {name} aktiv war</translation>
    </message>
    <message>
        <source>measured with {name} active ({known})</source>
        <translation>gemessen, während {name} aktiv war ({known})</translation>
    </message>
    <message>
        <source>the measurement does not say which table was active; {name} ({known}) is taken to have been</source>
        <translation>die Messung sagt nicht, welche Tabelle aktiv war; angenommen wird {name} ({known})</translation>
    </message>
    <message>
        <source>the raw positions of the encoder are on file: the table is made of reference minus encoder, whatever compensation was active</source>
        <translation>die Rohpositionen des Gebers stehen in der Datei: die Tabelle ist Referenz minus Geber, gleich welche Kompensation aktiv war</translation>
    </message>
    <message>
        <source>measured with the compensation off</source>
        <translation>mit ausgeschalteter Kompensation gemessen</translation>
    </message>
    <message>
        <source>{table} explains {share} % of the variance of {count} values; {rms} rms remains</source>
        <translation>{table} erklärt {share} % der Varianz von {count} Werten; {rms} (Effektivwert) bleiben</translation>
    </message>
    <message>
        <source>{table} explains little: values that were left out are foretold with {left} rms, and they are {values} rms themselves</source>
        <translation>{table} erklärt wenig: weggelassene Werte werden auf {left} vorhergesagt (Effektivwert), selbst sind die Werte {values} groß</translation>
    </message>
    <message numerus="yes">
        <source>{count} values lie outside the grid and were left out</source>
        <comment>1 value lies outside the grid and was left out</comment>
        <translation>
            <numerusform>1 Wert liegt außerhalb des Gitters und wurde weggelassen</numerusform>
            <numerusform>{count} Werte liegen außerhalb des Gitters und wurden weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is point {first}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: point {first}, {residual} off</comment>
        <translation>
            <numerusform>1 Wert von {table} passt nicht zu den anderen und zählt wenig: Punkt {first}, um {residual} daneben</numerusform>
            <numerusform>{count} Werte von {table} passen nicht zu den anderen und zählen wenig; der erste ist Punkt {first}, um {residual} daneben</numerusform>
        </translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} less than 90 degrees</source>
        <translation>der Winkel zwischen {first} und {second} ist um {angle} kleiner als 90 Grad</translation>
    </message>
    <message>
        <source>a scale of {scale} for each {length} was taken out; the mean scale error of the axes is in it, and stays in the machine</source>
        <translation>ein Maßstab von {scale} je {length} wurde herausgenommen; der mittlere Maßstabsfehler der Achsen steckt darin und bleibt in der Maschine</translation>
    </message>
    <message>
        <source>{axis} {position}</source>
        <translation>{axis} {position}</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; the drive will add {added}</source>
        <translation>bei {position} lag die Referenz in {table} um {measured} neben dem Geber; der Antrieb wird {added} addieren</translation>
    </message>
    <message>
        <source>how well the error between the targets is known cannot be told: {reason}</source>
        <translation>wie gut der Fehler zwischen den Zielpositionen bekannt ist, lässt sich nicht sagen: {reason}</translation>
    </message>
    <message>
        <source>at {speed} the velocity jumps by at most {step} at a point of the table</source>
        <translation>bei {speed} springt die Geschwindigkeit an einem Punkt der Tabelle um höchstens {step}</translation>
    </message>
    <message>
        <source>{count} points of {table} with straight lines between them are at most {distance} off the curve, at {place}</source>
        <translation>{count} Punkte von {table} mit Geraden dazwischen sind höchstens {distance} von der Kurve entfernt, bei {place}</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; the drive will add {added}</comment>
        <translation>
            <numerusform>wo der Geber {reading} anzeigt, sagte die Referenz {reference}, einmal gemessen; der Antrieb wird {added} addieren</numerusform>
            <numerusform>wo der Geber {reading} anzeigt, sagte die Referenz {reference} im Mittel von {count} Werten; der Antrieb wird {added} addieren</numerusform>
        </translation>
    </message>
    <message>
        <source>the error is {factor} times what it was before: the table has the wrong sign</source>
        <translation>der Fehler ist das {factor}-fache von vorher: die Tabelle hat das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>the error is the same as before: the compensation was not active, or another axis was measured</source>
        <translation>der Fehler ist derselbe wie vorher: die Kompensation war nicht aktiv, oder es wurde eine andere Achse gemessen</translation>
    </message>
    <message>
        <source>what is left is {factor} times the error before: the table adds {share} times what it should; look at the units of measurement and table</source>
        <translation>was bleibt, ist das {factor}-fache des Fehlers vorher: die Tabelle addiert das {share}-fache von dem, was sie soll; die Einheiten von Messung und Tabelle prüfen</translation>
    </message>
    <message>
        <source>what is left resembles neither the error before nor its slope: the machine was in another state, such as another temperature or load, or it is another axis</source>
        <translation>was bleibt, ähnelt weder dem Fehler vorher noch dessen Steigung: die Maschine war in einem anderen Zustand, etwa anderer Temperatur oder Last, oder es ist eine andere Achse</translation>
    </message>
    <message>
        <source>what is left follows the slope of the error before: the table is shifted by about {shift} against the axis; look at the home position and the source of the table</source>
        <translation>was bleibt, folgt der Steigung des Fehlers vorher: die Tabelle ist um etwa {shift} gegen die Achse verschoben; Referenzpunkt und Quelle der Tabelle prüfen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others: look at them, and exclude them or leave them in</source>
        <comment>1 value does not fit the others: look at it, and exclude it or leave it in</comment>
        <translation>
            <numerusform>1 Wert passt nicht zu den anderen: sehen Sie ihn an, und schließen Sie ihn aus oder lassen Sie ihn</numerusform>
            <numerusform>{count} Werte passen nicht zu den anderen: sehen Sie sie an, und schließen Sie sie aus oder lassen Sie sie</numerusform>
        </translation>
    </message>
    <message>
        <source>the backup {file}</source>
        <translation>die Sicherung {file}</translation>
    </message>
    <message>
        <source>the table of axis {index}</source>
        <translation>die Tabelle der Achse {index}</translation>
    </message>
    <message>
        <source>the table of axis {index} ({axis})</source>
        <translation>die Tabelle der Achse {index} ({axis})</translation>
    </message>
    <message>
        <source>{temperature}</source>
        <translation>{temperature}</translation>
    </message>
    <message>
        <source>measured in {count} thermal states: {temperatures}; outside of them the drive holds the values of the ends</source>
        <translation>gemessen in {count} thermischen Zuständen: {temperatures}; außerhalb davon hält der Antrieb die Werte der Enden</translation>
    </message>
    <message>
        <source>the table is straight over temperature, which leaves up to {largest} of what was measured in a state</source>
        <translation>die Tabelle ist über der Temperatur gerade; von dem, was in einem Zustand gemessen wurde, bleiben dadurch bis zu {largest}</translation>
    </message>
    <message>
        <source>the table has the movement of the zero from one thermal state to the other, as the instrument saw it: that is only right if its own zero was not set anew in between</source>
        <translation>die Tabelle enthält, wie sich der Nullpunkt von einem thermischen Zustand zum anderen verschoben hat, so wie das Messgerät es sah: das stimmt nur, wenn dessen eigener Nullpunkt dazwischen nicht neu gesetzt wurde</translation>
    </message>
    <message>
        <source>at {temperature}: {sentence}</source>
        <translation>bei {temperature}: {sentence}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {after} after</source>
        <translation>{figure} {before} vorher, {after} nachher</translation>
    </message>
    <message>
        <source>{figure} {after}</source>
        <translation>{figure} {after}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {predicted} predicted, not measured since</source>
        <translation>{figure} {before} vorher, {predicted} vorausgesagt, seitdem nicht gemessen</translation>
    </message>
    <message>
        <source>{figure} {before} before, not measured since</source>
        <translation>{figure} {before} vorher, seitdem nicht gemessen</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance})</source>
        <translation>{values} (Toleranz {tolerance})</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance}: {result})</source>
        <translation>{values} (Toleranz {tolerance}: {result})</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}; {next}</translation>
    </message>
    <message>
        <source>measured {date}: {figures}</source>
        <translation>gemessen {date}: {figures}</translation>
    </message>
    <message>
        <source>{figure} {before} before</source>
        <translation>{figure} {before} vorher</translation>
    </message>
    <message>
        <source>{figure} {after}, {before} before</source>
        <translation>{figure} {after}, {before} vorher</translation>
    </message>
    <message>
        <source>there is a table for each direction, and the reversal of up to {reversal} is in them: switch off the controller&apos;s own backlash compensation</source>
        <translation>es gibt eine Tabelle für jede Richtung, und die Umkehrspanne von bis zu {reversal} ist darin enthalten: die Losekompensation der Steuerung ausschalten</translation>
    </message>
    <message>
        <source>approached upwards: {sentence}</source>
        <translation>aufwärts angefahren: {sentence}</translation>
    </message>
    <message>
        <source>approached downwards: {sentence}</source>
        <translation>abwärts angefahren: {sentence}</translation>
    </message>
    <message>
        <source>the new table is coarser than {name}: up to {lost} of what that has between the new points is lost; take more points</source>
        <translation>die neue Tabelle ist gröber als {name}: bis zu {lost} von dem, was diese zwischen den neuen Punkten hat, gehen verloren; mehr Punkte nehmen</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others and are in the table; judging names them, and they can be excluded</source>
        <comment>1 value does not fit the others and is in the table; judging names it, and it can be excluded</comment>
        <translation>
            <numerusform>1 Wert passt nicht zu den anderen und ist in der Tabelle; die Beurteilung nennt ihn, und er lässt sich ausschließen</numerusform>
            <numerusform>{count} Werte passen nicht zu den anderen und sind in der Tabelle; die Beurteilung nennt sie, und sie lassen sich ausschließen</numerusform>
        </translation>
    </message>
    <message>
        <source>the targets are not all at the same place of a period of the axis; no period is stated</source>
        <translation>die Zielpositionen liegen nicht alle an derselben Stelle einer Periode der Achse; es ist keine Periode angegeben</translation>
    </message>
    <message>
        <source>from {from} to {to} nothing was measured, {gap} of a turn of {turn}: there the table is guessed, and no figure knows of it; measure the whole turn</source>
        <translation>von {from} bis {to} wurde nichts gemessen, {gap} einer Umdrehung von {turn}: dort ist die Tabelle geraten, und kein Kennwert weiß davon; messen Sie die ganze Umdrehung</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: the table is for one direction, and up to {reversal} remains in the other</source>
        <translation>dieser Fehler ist vor allem Umkehrspanne, die keine Tabelle beseitigt: die Tabelle gilt für eine Richtung, und in der anderen bleiben bis zu {reversal}</translation>
    </message>
    <message>
        <source>each figure, before and foretold, is the largest of a thermal state and of all runs together</source>
        <translation>jeder Kennwert, vorher und vorhergesagt, ist der größte eines thermischen Zustands und aller Durchläufe zusammen</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of both tables for their zero</source>
        <translation>{constant} wurde für die Nullstelle aus allen Werten beider Tabellen herausgenommen</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of {table} for its zero</source>
        <translation>{constant} wurde für die Nullstelle aus allen Werten von {table} herausgenommen</translation>
    </message>
    <message>
        <source>the new table is shorter than {name}: up to {lost} of what that has beyond the ends of the new one is lost; ask for no grid, which keeps that of {name}, or for one as long, or measure the whole of it</source>
        <translation>Die neue Tabelle ist kürzer als {name}: bis zu {lost} von dem, was jene jenseits der Enden der neuen hat, gehen verloren; kein Gitter angeben, dann bleibt das von {name}, oder eines, das so lang ist, oder den ganzen Bereich messen</translation>
    </message>
    <message>
        <source>the rule grubbs is for 4 to 10 values of a target, and some of those {direction} were not tested</source>
        <translation>die Regel grubbs gilt für 4 bis 10 Werte einer Zielposition, und einige {direction} wurden nicht geprüft</translation>
    </message>
    <message>
        <source>a value {direction} stands out that the rule mad does not propose: it keeps 3 values of each target, and needs others that differ</source>
        <translation>ein Wert {direction} fällt auf, den die Regel mad nicht vorschlägt: sie behält 3 Werte jeder Zielposition und braucht andere, die sich unterscheiden</translation>
    </message>
    <message>
        <source>{table} goes from {from} to {to}, the targets from {first} to {last}: beyond its ends the drive holds their values; take the number of points, or a distance that divides the range of the targets</source>
        <translation>{table} geht von {from} bis {to}, die Zielpositionen von {first} bis {last}: jenseits der Enden hält der Antrieb deren Werte; geben Sie die Anzahl der Stützstellen an oder einen Abstand, der den Bereich der Zielpositionen teilt</translation>
    </message>
    <message>
        <source>the first target is {first}; the table is for an axis that counts from {from} to {to}: where it counts otherwise, the drive holds the values at the ends</source>
        <translation>die erste Zielposition ist {first}; die Tabelle ist für eine Achse, die von {from} bis {to} zählt: wo sie anders zählt, hält der Antrieb die Werte an den Enden</translation>
    </message>
    <message>
        <source>{read} ({corrected} after corrections)</source>
        <translation>{read} (nach Korrekturen {corrected})</translation>
    </message>
    <message>
        <source>first measurement: {remark}</source>
        <translation>erste Messung: {remark}</translation>
    </message>
    <message>
        <source>second measurement: {remark}</source>
        <translation>zweite Messung: {remark}</translation>
    </message>
    <message>
        <source>of all values {figure} is {value} (tolerance {tolerance}: {result})</source>
        <translation>aus allen Werten ergibt sich {figure} zu {value} (Toleranz {tolerance}: {result})</translation>
    </message>
    <message>
        <source>the first measurement is of the machine {before}, the second of {after}</source>
        <translation>die erste Messung ist von der Maschine {before}, die zweite von {after}</translation>
    </message>
    <message>
        <source>the first measurement has the serial number {before}, the second {after}</source>
        <translation>die erste Messung nennt die Seriennummer {before}, die zweite {after}</translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} more than 90 degrees</source>
        <translation>der Winkel zwischen {first} und {second} ist um {angle} größer als 90 Grad</translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is at {place}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: at {place}, {residual} off</comment>
        <translation>
            <numerusform>1 Wert von {table} passt nicht zu den anderen und zählt wenig: bei {place}, um {residual} daneben</numerusform>
            <numerusform>{count} Werte von {table} passen nicht zu den anderen und zählen wenig; der erste liegt bei {place}, um {residual} daneben</numerusform>
        </translation>
    </message>
    <message>
        <source>first measurement from {beforeFirst} to {beforeLast}, second one from {afterFirst} to {afterLast}</source>
        <translation>erste Messung von {beforeFirst} bis {beforeLast}, zweite von {afterFirst} bis {afterLast}</translation>
    </message>
    <message>
        <source>{ranges}: over a shorter travel the figures are smaller whatever the compensation does, and nothing is proved for the rest</source>
        <translation>{ranges}: auf einem kürzeren Verfahrweg sind die Kennwerte kleiner, gleich was die Kompensation bewirkt, und für den Rest ist nichts nachgewiesen</translation>
    </message>
    <message>
        <source>{figures}, over part of the travel</source>
        <translation>{figures}, auf einem Teil des Verfahrwegs</translation>
    </message>
    <message>
        <source>{removed} was taken out for the zero of the table</source>
        <translation>{removed} wurden für den Nullpunkt der Tabelle herausgenommen</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope and the zero of the table</source>
        <translation>{removed} wurden für Steigung und Nullpunkt der Tabelle herausgenommen</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope</source>
        <translation>{removed} wurden für die Steigung herausgenommen</translation>
    </message>
    <message>
        <source>{removed} was taken out for how the artefact lay and for the zero of the table</source>
        <translation>{removed} wurden für die Lage des Prüfkörpers und den Nullpunkt der Tabelle herausgenommen</translation>
    </message>
    <message>
        <source>{evened} was taken out by gain, averaging, smoothing or grid</source>
        <translation>{evened} wurden durch Faktor, Mittelung, Glättung oder Gitter herausgenommen</translation>
    </message>
    <message>
        <source>{removed}, and {evened} by gain, averaging, smoothing or grid</source>
        <translation>{removed}, und {evened} durch Faktor, Mittelung, Glättung oder Gitter</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; {taken}, so the drive will add {added}</source>
        <translation>bei {position} lag die Referenz in {table} um {measured} neben dem Geber; {taken}, also wird der Antrieb {added} addieren</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; {taken}, so the drive will add {added}</source>
        <translation>wo der Geber {reading} anzeigt, sagte die Referenz {reference}, das Mittel beider Richtungen mit {count} Werten; {taken}, also wird der Antrieb {added} addieren</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; the drive will add {added}</source>
        <translation>wo der Geber {reading} anzeigt, sagte die Referenz {reference}, das Mittel beider Richtungen mit {count} Werten; der Antrieb wird {added} addieren</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; {taken}, so the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; {taken}, so the drive will add {added}</comment>
        <translation>
            <numerusform>wo der Geber {reading} anzeigt, sagte die Referenz {reference}, einmal gemessen; {taken}, also wird der Antrieb {added} addieren</numerusform>
            <numerusform>wo der Geber {reading} anzeigt, sagte die Referenz {reference} im Mittel von {count} Werten; {taken}, also wird der Antrieb {added} addieren</numerusform>
        </translation>
    </message>
    <message>
        <source>the second measurement is of {date}, and the record has one of {last} with the same table, which decides</source>
        <translation>die zweite Messung ist vom {date}, und das Protokoll hat eine vom {last} mit derselben Tabelle; diese entscheidet</translation>
    </message>
    <message>
        <source>the targets of the second measurement are up to {second} apart, those of the first one up to {first}: what lies between them is not measured again</source>
        <translation>die Zielpositionen der zweiten Messung liegen bis zu {second} auseinander, die der ersten bis zu {first}: was dazwischen liegt, ist nicht nachgemessen</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, E of the direction that was measured is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>zwischen den Zielpositionen ist der Fehler nicht gut genug bekannt: ohne die jeweilige Zielposition vorhergesagt ist E der gemessenen Richtung {heldOut}, vorher war es {before}; messen Sie an mehr Zielpositionen</translation>
    </message>
    <message>
        <source>0 = mean at {position}</source>
        <translation>0 = Mittel bei {position}</translation>
    </message>
    <message>
        <source>{said} (file {file})</source>
        <translation>{said} (Datei {file})</translation>
    </message>
    <message>
        <source>the files are of different machines: {machines}</source>
        <translation>die Dateien sind von verschiedenen Maschinen: {machines}</translation>
    </message>
    <message>
        <source>the files have different serial numbers: {numbers}</source>
        <translation>die Dateien nennen verschiedene Seriennummern: {numbers}</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg or .pdf.</source>
        <translation>Der Dateiname muss auf .png, .svg oder .pdf enden.</translation>
    </message>
    <message>
        <source>Save picture or values</source>
        <translation>Bild oder Werte speichern</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Values (*.csv)</source>
        <translation>Werte (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
</context>
<context>
    <name>PlanText</name>
    <message>
        <source>Axis %1: %2 targets, %3 values</source>
        <translation>Achse %1: %2 Zielpositionen, %3 Werte</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>the file holds no data</source>
        <translation>die Datei enthält keine Daten</translation>
    </message>
    <message>
        <source>export it again, or choose another file</source>
        <translation>die Datei erneut exportieren oder eine andere wählen</translation>
    </message>
    <message>
        <source>the header line with the names of the columns is missing</source>
        <translation>die Kopfzeile mit den Namen der Spalten fehlt</translation>
    </message>
    <message>
        <source>add a first line such as X [mm],Table 1 [mm], or for a measurement target [mm],direction,run,deviation [um]</source>
        <translation>eine erste Zeile wie X [mm],Tabelle 1 [mm] einfügen, für eine Messung target [mm],direction,run,deviation [um]</translation>
    </message>
    <message>
        <source>the header has too few columns</source>
        <translation>die Kopfzeile hat zu wenige Spalten</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has</source>
        <translation>die Dimensionalität der Datei wählen</translation>
    </message>
    <message>
        <source>this line does not have as many columns as the header</source>
        <translation>diese Zeile hat nicht so viele Spalten wie die Kopfzeile</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>das ist keine Zahl</translation>
    </message>
    <message>
        <source>this number is not finite</source>
        <translation>diese Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>it is not clear which sign is the decimal one</source>
        <translation>es ist nicht klar, welches das Dezimalzeichen ist</translation>
    </message>
    <message>
        <source>use one decimal sign in all numbers, and none between thousands</source>
        <translation>verwenden Sie in allen Zahlen dasselbe Dezimalzeichen und keines zwischen Tausendern</translation>
    </message>
    <message>
        <source>a quotation mark is not closed as it should be</source>
        <translation>ein Anführungszeichen ist nicht richtig geschlossen</translation>
    </message>
    <message>
        <source>the same position occurs twice</source>
        <translation>dieselbe Position kommt zweimal vor</translation>
    </message>
    <message>
        <source>delete one of the two lines</source>
        <translation>eine der beiden Zeilen löschen</translation>
    </message>
    <message>
        <source>the grid is incomplete</source>
        <translation>das Gitter ist unvollständig</translation>
    </message>
    <message>
        <source>the positions are not evenly spaced</source>
        <translation>die Positionen haben keinen gleichmäßigen Abstand</translation>
    </message>
    <message>
        <source>resample the data onto an even grid, which can be done here for a calibration file only</source>
        <translation>die Daten auf ein gleichmäßiges Gitter umrechnen, was hier nur für eine Kalibrierdatei möglich ist</translation>
    </message>
    <message>
        <source>there are too few points</source>
        <translation>es gibt zu wenige Stützstellen</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>die Datei ist zu groß</translation>
    </message>
    <message>
        <source>choose a coarser grid, or split the file</source>
        <translation>ein gröberes Gitter wählen oder die Datei aufteilen</translation>
    </message>
    <message>
        <source>this is not a text file</source>
        <translation>das ist keine Textdatei</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file is not valid UTF-8 and is read as Windows-1252</source>
        <translation>die Datei ist kein gültiges UTF-8 und wird als Windows-1252 gelesen</translation>
    </message>
    <message>
        <source>the positions are even only within the printed precision</source>
        <translation>die Positionen sind nur im Rahmen der gedruckten Genauigkeit gleichmäßig</translation>
    </message>
    <message>
        <source>the even grid is used; print more decimals if that is not meant</source>
        <translation>verwendet wird das gleichmäßige Gitter; ist das nicht gemeint, mehr Nachkommastellen ausgeben</translation>
    </message>
    <message>
        <source>a value loses precision when it is stored as float32</source>
        <translation>ein Wert verliert als float32 an Genauigkeit</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>die Einheit der Werte prüfen</translation>
    </message>
    <message>
        <source>the table is very steep, which is likely a unit mistake</source>
        <translation>die Tabelle ist sehr steil, vermutlich stimmt eine Einheit nicht</translation>
    </message>
    <message>
        <source>all values of the table are equal</source>
        <translation>alle Werte der Tabelle sind gleich</translation>
    </message>
    <message>
        <source>check that this column is meant</source>
        <translation>prüfen, ob diese Spalte gemeint ist</translation>
    </message>
    <message>
        <source>found an empty cell</source>
        <translation>die Zelle ist leer</translation>
    </message>
    <message>
        <source>this is not written as the format demands</source>
        <translation>das ist nicht so geschrieben, wie das Format es verlangt</translation>
    </message>
    <message>
        <source>the positions do not go in one direction</source>
        <translation>die Positionen gehen nicht in einer Richtung</translation>
    </message>
    <message>
        <source>the table does not close after one revolution</source>
        <translation>die Tabelle schließt sich nach einer Umdrehung nicht</translation>
    </message>
    <message>
        <source>the controller does not take as much</source>
        <translation>so viel nimmt die Steuerung nicht an</translation>
    </message>
    <message>
        <source>this entry is not known and is left out</source>
        <translation>dieser Eintrag ist unbekannt und wird ausgelassen</translation>
    </message>
    <message>
        <source>the file does not say a unit</source>
        <translation>die Datei nennt keine Einheit</translation>
    </message>
    <message>
        <source>the file can be understood in several ways</source>
        <translation>die Datei kann verschieden verstanden werden</translation>
    </message>
    <message>
        <source> (error %1 of the controller)</source>
        <translation> (Fehler %1 der Steuerung)</translation>
    </message>
    <message>
        <source>found &quot;{found}&quot;</source>
        <translation>gefunden &quot;{found}&quot;</translation>
    </message>
    <message>
        <source>found {found}</source>
        <translation>gefunden {found}</translation>
    </message>
    <message>
        <source>{problem}: {found}</source>
        <translation>{problem}: {found}</translation>
    </message>
    <message>
        <source>{problem}, expected {expected}</source>
        <translation>{problem}, erwartet {expected}</translation>
    </message>
    <message>
        <source>{problem}; {wayOut}</source>
        <translation>{problem}; {wayOut}</translation>
    </message>
    <message>
        <source>the axis that the values correct cannot be told</source>
        <translation>welche Achse die Werte korrigieren, ist nicht erkennbar</translation>
    </message>
    <message>
        <source>check the units of values and positions</source>
        <translation>prüfen Sie die Einheiten der Werte und der Positionen</translation>
    </message>
    <message>
        <source>points without a value are filled</source>
        <translation>Punkte ohne Wert werden gefüllt</translation>
    </message>
    <message>
        <source>the grid is cropped to the points that have a value</source>
        <translation>das Gitter wird auf die Punkte mit Wert zugeschnitten</translation>
    </message>
    <message>
        <source>positions are snapped to the grid</source>
        <translation>Positionen werden auf das Gitter gelegt</translation>
    </message>
    <message>
        <source>comments from here on are not kept with the table</source>
        <translation>Kommentare ab hier werden nicht mit der Tabelle behalten</translation>
    </message>
    <message>
        <source>the file has another dimensionality than the one chosen</source>
        <translation>die Datei hat eine andere Dimensionalität als die gewählte</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has (--dims)</source>
        <translation>die Dimensionalität der Datei wählen (--dims)</translation>
    </message>
    <message>
        <source>the columns do not say what was measured</source>
        <translation>die Spalten sagen nicht, was gemessen wurde</translation>
    </message>
    <message>
        <source>the unit of a column is not known</source>
        <translation>die Einheit einer Spalte ist nicht bekannt</translation>
    </message>
    <message>
        <source>a length and an angle are mixed</source>
        <translation>eine Länge und ein Winkel sind vermischt</translation>
    </message>
    <message>
        <source>correct the unit in the file, or state it</source>
        <translation>berichtigen Sie die Einheit in der Datei oder geben Sie sie an</translation>
    </message>
    <message>
        <source>this is not a direction</source>
        <translation>das ist keine Richtung</translation>
    </message>
    <message>
        <source>this is not the number of a run</source>
        <translation>das ist keine Nummer eines Durchlaufs</translation>
    </message>
    <message>
        <source>the same value is there twice</source>
        <translation>derselbe Wert ist zweimal da</translation>
    </message>
    <message>
        <source>the file holds another number than it says</source>
        <translation>die Datei enthält eine andere Anzahl, als sie angibt</translation>
    </message>
    <message>
        <source>there are too few targets</source>
        <translation>es sind zu wenige Zielpositionen</translation>
    </message>
    <message>
        <source>there is no target of this number</source>
        <translation>es gibt keine Zielposition dieser Nummer</translation>
    </message>
    <message>
        <source>positions do not follow one another one to one</source>
        <translation>Positionen folgen einander nicht eins zu eins</translation>
    </message>
    <message>
        <source>values are missing</source>
        <translation>es fehlen Werte</translation>
    </message>
    <message>
        <source>the figures are made of the values that are there</source>
        <translation>die Kennwerte entstehen aus den vorhandenen Werten</translation>
    </message>
    <message>
        <source>the directions have different numbers of runs</source>
        <translation>die Richtungen haben verschieden viele Durchläufe</translation>
    </message>
    <message>
        <source>the values look like positions instead of deviations</source>
        <translation>die Werte sehen aus wie Positionen statt Abweichungen</translation>
    </message>
    <message>
        <source>if they are positions of the reference, say so: --values reference, or name the column reference</source>
        <translation>wenn es Positionen der Referenz sind, geben Sie das an: --values reference, oder nennen Sie die Spalte reference</translation>
    </message>
    <message>
        <source>the size of the values is unusual</source>
        <translation>die Größe der Werte ist ungewöhnlich</translation>
    </message>
    <message>
        <source>a result in the file is not what its values give</source>
        <translation>ein Ergebnis in der Datei passt nicht zu ihren Werten</translation>
    </message>
    <message>
        <source>not everything in the file is used</source>
        <translation>nicht alles in der Datei wird verwendet</translation>
    </message>
    <message>
        <source>an entry {key}</source>
        <translation>ein Eintrag {key}</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>one of {known}</source>
        <translation>eines von {known}</translation>
    </message>
    <message>
        <source>sections that begin with [[{key}]]</source>
        <translation>Abschnitte, die mit [[{key}]] beginnen</translation>
    </message>
    <message>
        <source>at most {count} of them</source>
        <translation>höchstens {count} davon</translation>
    </message>
    <message>
        <source>a known key; the nearest is {key}</source>
        <translation>ein bekannter Schlüssel; der ähnlichste ist {key}</translation>
    </message>
    <message>
        <source>valid TOML ({reason})</source>
        <translation>gültiges TOML ({reason})</translation>
    </message>
    <message>
        <source>{number}, the version of this format</source>
        <translation>{number}, die Version dieses Formats</translation>
    </message>
    <message>
        <source>{name} is a drive in line {line} already</source>
        <translation>{name} ist schon in Zeile {line} ein Antrieb</translation>
    </message>
    <message>
        <source>serial number {name} is in line {line} already</source>
        <translation>die Seriennummer {name} steht schon in Zeile {line}</translation>
    </message>
    <message>
        <source>a list of one to three registers</source>
        <translation>eine Liste von einem bis drei Registern</translation>
    </message>
    <message>
        <source>settings as {example}</source>
        <translation>Einstellungen wie {example}</translation>
    </message>
    <message>
        <source>a text, a number, true or false</source>
        <translation>ein Text, eine Zahl, true oder false</translation>
    </message>
    <message>
        <source>an entry file, or no-table = true for an axis that shall have none</source>
        <translation>ein Eintrag file, oder no-table = true für eine Achse, die keine Tabelle haben soll</translation>
    </message>
    <message>
        <source>{key} of an axis without a table</source>
        <translation>{key} bei einer Achse ohne Tabelle</translation>
    </message>
    <message>
        <source>no-table beside file</source>
        <translation>no-table neben file</translation>
    </message>
    <message>
        <source>an entry sources, with the register that looks the table up for each of its dimensions</source>
        <translation>ein Eintrag sources mit dem Register, das die Tabelle nachschlägt, für jede ihrer Dimensionen</translation>
    </message>
    <message>
        <source>axis {name} of this drive is in line {line} already</source>
        <translation>die Achse {name} dieses Antriebs steht schon in Zeile {line}</translation>
    </message>
    <message>
        <source>slot {name} is taken by the axis in line {line}</source>
        <translation>den Tabellenplatz {name} hat schon die Achse in Zeile {line}</translation>
    </message>
    <message>
        <source>save it as UTF-8 text</source>
        <translation>als Text in UTF-8 speichern</translation>
    </message>
    <message>
        <source>check the names and notes, or save it as UTF-8 text</source>
        <translation>Namen und Bemerkungen prüfen oder als Text in UTF-8 speichern</translation>
    </message>
    <message>
        <source>the directions of the runs are doubtful</source>
        <translation>die Richtungen der Durchläufe sind zweifelhaft</translation>
    </message>
    <message>
        <source>compare them with the data, and exchange them if they are the other way round</source>
        <translation>vergleichen Sie sie mit den Daten und vertauschen Sie sie, wenn sie umgekehrt sind</translation>
    </message>
    <message>
        <source>line {line}: {problem}</source>
        <translation>Zeile {line}: {problem}</translation>
    </message>
    <message>
        <source>two statements contradict each other</source>
        <translation>zwei Angaben widersprechen sich</translation>
    </message>
    <message>
        <source>the serial number of the drive, a whole number of at most 32 bits, without quotation marks</source>
        <translation>die Seriennummer des Antriebs, eine ganze Zahl mit höchstens 32 Bit ohne Anführungszeichen</translation>
    </message>
    <message>
        <source>a text that is not empty and has no control characters</source>
        <translation>ein Text, der nicht leer ist und keine Steuerzeichen enthält</translation>
    </message>
    <message>
        <source>a name, or a whole number that is not negative</source>
        <translation>ein Name oder eine nicht negative ganze Zahl</translation>
    </message>
    <message>
        <source>a number that is not negative and its unit, such as {example}</source>
        <translation>eine nicht negative Zahl und ihre Einheit, etwa {example}</translation>
    </message>
    <message>
        <source>UTF-8 text</source>
        <translation>Text in UTF-8</translation>
    </message>
    <message>
        <source>delete one of the two</source>
        <translation>löschen Sie eine der beiden Angaben</translation>
    </message>
    <message>
        <source>a text; write it in quotation marks</source>
        <translation>ein Text; in Anführungszeichen schreiben</translation>
    </message>
    <message>
        <source>a text; write {source} for the first source, {name} for an axis of that name</source>
        <translation>ein Text; {source} für die erste Quelle oder {name} für eine Achse dieses Namens schreiben</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Deviation in {unit}</source>
        <translation>Abweichung in {unit}</translation>
    </message>
    <message>
        <source>Position in {unit}</source>
        <translation>Position in {unit}</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions with bands of 2 s, the mean of both, single runs</source>
        <translation>Abweichung über der Position: Mittelwerte beider Richtungen mit Bändern von 2 s, das Mittel beider, einzelne Durchläufe</translation>
    </message>
    <message>
        <source>What lines and markers mean</source>
        <translation>Was Linien und Zeichen bedeuten</translation>
    </message>
    <message>
        <source>mean ↑</source>
        <translation>Mittel ↑</translation>
    </message>
    <message>
        <source>mean ↓</source>
        <translation>Mittel ↓</translation>
    </message>
    <message>
        <source>mean of both</source>
        <translation>Mittel beider</translation>
    </message>
    <message>
        <source>mean ↑ ± 2 s</source>
        <translation>Mittel ↑ ± 2 s</translation>
    </message>
    <message>
        <source>mean ↓ ± 2 s</source>
        <translation>Mittel ↓ ± 2 s</translation>
    </message>
    <message>
        <source>single run</source>
        <translation>ein Durchlauf</translation>
    </message>
    <message>
        <source>dead path of {length}: values changed by up to {largest}</source>
        <translation>Totstrecke von {length}: Werte um bis zu {largest} geändert</translation>
    </message>
    <message>
        <source>drift taken out for the table, not for figures</source>
        <translation>Drift für die Tabelle entfernt, nicht für Kennwerte</translation>
    </message>
    <message>
        <source>smooth grid of scattered points</source>
        <translation>glattes Gitter aus verstreuten Punkten</translation>
    </message>
    <message>
        <source>{method}, from the runs ↑</source>
        <translation>{method}, aus den Durchläufen ↑</translation>
    </message>
    <message>
        <source>{method}, from the runs ↓</source>
        <translation>{method}, aus den Durchläufen ↓</translation>
    </message>
    <message>
        <source>{method}, from the mean of both directions</source>
        <translation>{method}, aus dem Mittel beider Richtungen</translation>
    </message>
    <message>
        <source>failed after {share} of the table</source>
        <translation>nach {share} der Tabelle fehlgeschlagen</translation>
    </message>
    <message>
        <source>passed over {share} of the table</source>
        <translation>über {share} der Tabelle bestanden</translation>
    </message>
    <message>
        <source>At the set position {position} the drive adds {added} to what the encoder reads.</source>
        <translation>Bei der Sollposition {position} addiert der Antrieb {added} zu dem, was der Geber anzeigt.</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the drive adds {added}.</source>
        <translation>Wo der Geber {reading} anzeigt, addiert der Antrieb {added}.</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the reference said {reference}: the drive adds {added}.</source>
        <translation>Wo der Geber {reading} anzeigt, sagte die Referenz {reference}: Der Antrieb addiert {added}.</translation>
    </message>
    <message>
        <source>Compensation of axis {axis}, machine {machine}</source>
        <translation>Kompensation der Achse {axis}, Maschine {machine}</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>The accuracy A before is not defined.</source>
        <translation>Die Genauigkeit A vorher ist nicht definiert.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Serial number of the drive</source>
        <translation>Seriennummer des Antriebs</translation>
    </message>
    <message>
        <source>Firmware profile</source>
        <translation>Firmware-Profil</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Ausführende Person</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Messgerät</translation>
    </message>
    <message>
        <source>Feed, dwell</source>
        <translation>Vorschub, Verweilzeit</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Targets and runs</source>
        <translation>Zielpositionen und Durchläufe</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgeschlossen</translation>
    </message>
    <message>
        <source>air {air}, material {material}, expansion {expansion}</source>
        <translation>Luft {air}, Material {material}, Ausdehnung {expansion}</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on, which table is not stated</source>
        <translation>ein, welche Tabelle ist nicht angegeben</translation>
    </message>
    <message>
        <source>on, table {crc}</source>
        <translation>ein, Tabelle {crc}</translation>
    </message>
    <message>
        <source>to 20 °C by the instrument</source>
        <translation>auf 20 °C durch das Messgerät</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none here, by the instrument not stated</source>
        <translation>hier keine, durch das Messgerät nicht angegeben</translation>
    </message>
    <message>
        <source>no targets: {kind}</source>
        <translation>keine Zielpositionen: {kind}</translation>
    </message>
    <message>
        <source>{direction} target {target} run {run}</source>
        <translation>{direction} Ziel {target} Durchlauf {run}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>{count} values: not an evaluation by ISO 230-2</source>
        <translation>{count} Werte: keine Auswertung nach ISO 230-2</translation>
    </message>
    <message>
        <source>{values}: not an evaluation by ISO 230-2</source>
        <translation>{values}: keine Auswertung nach ISO 230-2</translation>
    </message>
    <message>
        <source>Deviation over position: before, after, to one scale</source>
        <translation>Abweichung über der Position: vorher, nachher, im selben Maßstab</translation>
    </message>
    <message>
        <source>Deviation over position, before</source>
        <translation>Abweichung über der Position, vorher</translation>
    </message>
    <message>
        <source>Deviation over position, after</source>
        <translation>Abweichung über der Position, nachher</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014 in {unit}</source>
        <translation>Kennwerte nach ISO 230-2:2014 in {unit}</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>Verdict on the measurement after</source>
        <translation>Urteil über die Messung nachher</translation>
    </message>
    <message>
        <source>Verdict on the measurement before</source>
        <translation>Urteil über die Messung vorher</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>Messunsicherheit U, k = 2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>uncertainty U, k = 2</source>
        <translation>Messunsicherheit U, k = 2</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>CRC-32</source>
        <translation>CRC-32</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Tabellenplatz</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Dauerhaftigkeit</translation>
    </message>
    <message>
        <source>End-to-end proof</source>
        <translation>Nachweis am Antrieb</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Vorzeichen</translation>
    </message>
    <message>
        <source>{count} points from {from} to {to}</source>
        <translation>{count} Stützstellen von {from} bis {to}</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>none on record</source>
        <translation>keine im Protokoll</translation>
    </message>
    <message numerus="yes">
        <source>and {count} more in the record</source>
        <comment>and 1 more in the record</comment>
        <translation>
            <numerusform>und 1 weitere im Protokoll</numerusform>
            <numerusform>und {count} weitere im Protokoll</numerusform>
        </translation>
    </message>
    <message>
        <source>Input files</source>
        <translation>Eingelesene Dateien</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Made by Axis Compensation Wizard {version}. Figures that the values do not define are not defined; what is not on record is not stated.</source>
        <translation>Erstellt von Axis Compensation Wizard {version}. Kennwerte, die sich aus den Werten nicht ergeben, sind nicht definiert; was nicht im Protokoll steht, ist nicht angegeben.</translation>
    </message>
    <message>
        <source>Targets before, in {unit}</source>
        <translation>Zielpositionen vorher, in {unit}</translation>
    </message>
    <message>
        <source>Targets after, in {unit}</source>
        <translation>Zielpositionen nachher, in {unit}</translation>
    </message>
    <message>
        <source>target in {unit}</source>
        <translation>Ziel in {unit}</translation>
    </message>
    <message>
        <source>values ↑</source>
        <translation>Werte ↑</translation>
    </message>
    <message>
        <source>s ↑</source>
        <translation>s ↑</translation>
    </message>
    <message>
        <source>values ↓</source>
        <translation>Werte ↓</translation>
    </message>
    <message>
        <source>s ↓</source>
        <translation>s ↓</translation>
    </message>
    <message>
        <source>Left out: {values}</source>
        <translation>Ausgeschlossen: {values}</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>The accuracy A is not defined, before or after.</source>
        <translation>Die Genauigkeit A ist nicht definiert, weder vorher noch nachher.</translation>
    </message>
    <message>
        <source>{figure}: {before} before, {after} after.</source>
        <translation>{figure}: {before} vorher, {after} nachher.</translation>
    </message>
    <message>
        <source>{method}, over position and temperature</source>
        <translation>{method}, über Position und Temperatur</translation>
    </message>
    <message>
        <source>Each figure is the largest of a thermal state and of all runs together.</source>
        <translation>Jeder Kennwert ist der größte eines thermischen Zustands und aller Durchläufe zusammen.</translation>
    </message>
    <message>
        <source>air {air}, material {material}, values measured at {values}, expansion {expansion}</source>
        <translation>Luft {air}, Material {material}, Werte gemessen bei {values}, Ausdehnung {expansion}</translation>
    </message>
    <message>
        <source>{from} to {to}</source>
        <translation>{from} bis {to}</translation>
    </message>
    <message>
        <source>Warning: {warning}.</source>
        <translation>Warnung: {warning}.</translation>
    </message>
    <message>
        <source>up and down exchanged</source>
        <translation>aufwärts und abwärts getauscht</translation>
    </message>
    <message>
        <source>reference taken with the opposite sign</source>
        <translation>Referenz mit umgekehrtem Vorzeichen verwendet</translation>
    </message>
    <message>
        <source>unit of {what} taken as {stated}, the file says {unit}</source>
        <translation>Einheit von {what}: {stated} verwendet, in der Datei steht {unit}</translation>
    </message>
    <message>
        <source>slope taken out for the table, not for figures</source>
        <translation>Steigung für die Tabelle entfernt, nicht für Kennwerte</translation>
    </message>
    <message>
        <source>to {standard}, {conditions}: values changed by up to {largest}</source>
        <translation>auf {standard}, {conditions}: Werte um bis zu {largest} geändert</translation>
    </message>
    <message>
        <source>scale at {temperature} with {expansion}</source>
        <translation>Maßstab bei {temperature} mit {expansion}</translation>
    </message>
    <message>
        <source>reference at {temperature} with {expansion}</source>
        <translation>Referenz bei {temperature} mit {expansion}</translation>
    </message>
    <message>
        <source>datum at {position}</source>
        <translation>Bezugspunkt bei {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets from {from} to {to}</source>
        <comment>1 target from {from} to {to}</comment>
        <translation>
            <numerusform>1 Zielposition von {from} bis {to}</numerusform>
            <numerusform>{count} Zielpositionen von {from} bis {to}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} runs {direction}</source>
        <comment>1 run {direction}</comment>
        <translation>
            <numerusform>1 Durchlauf {direction}</numerusform>
            <numerusform>{count} Durchläufe {direction}</numerusform>
        </translation>
    </message>
    <message>
        <source>means {direction}</source>
        <translation>Mittelwerte {direction}</translation>
    </message>
    <message>
        <source>no means {direction}</source>
        <translation>keine Mittelwerte {direction}</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions, the mean of both</source>
        <translation>Abweichung über der Position: Mittelwerte beider Richtungen, das Mittel beider</translation>
    </message>
    <message>
        <source>on, table {crc}, as stated with the measurement</source>
        <translation>ein, Tabelle {crc}, wie zur Messung angegeben</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>that of each table, below</source>
        <translation>die jeder Tabelle, unten</translation>
    </message>
    <message>
        <source>{name} for axis {axis}, CRC-32 {crc}</source>
        <translation>{name} für Achse {axis}, CRC-32 {crc}</translation>
    </message>
    <message>
        <source>Compensation of axis {target} over axis {axis}, machine {machine}</source>
        <translation>Kompensation der Achse {target} über der Achse {axis}, Maschine {machine}</translation>
    </message>
    <message>
        <source>At the set position {position} of axis {axis} the drive adds {added} to what the encoder of axis {target} reads.</source>
        <translation>Bei der Sollposition {position} der Achse {axis} addiert der Antrieb {added} zu dem, was der Geber der Achse {target} anzeigt.</translation>
    </message>
    <message>
        <source>Where the encoder of axis {axis} reads {position}, the drive adds {added} to axis {target}.</source>
        <translation>Wo der Geber der Achse {axis} {position} anzeigt, addiert der Antrieb {added} zur Achse {target}.</translation>
    </message>
    <message>
        <source>values taken as positions of the reference, the file says deviations</source>
        <translation>Werte als Positionen der Referenz genommen, laut Datei Abweichungen</translation>
    </message>
    <message>
        <source>values taken as deviations, the file says positions of the reference</source>
        <translation>Werte als Abweichungen genommen, laut Datei Positionen der Referenz</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before, {after} after.</source>
        <translation>Genauigkeit {figure}: {before} vorher, {after} nachher.</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before. There is no measurement afterwards on record.</source>
        <translation>Genauigkeit {figure}: {before} vorher. Im Protokoll steht keine Messung danach.</translation>
    </message>
    <message>
        <source>Held out: what is left at targets that the table was made without: {figure} {range}, rms {rms}, largest {largest}. Of the two predictions this is the one to believe.</source>
        <translation>Ausgelassen: was an Zielpositionen bleibt, ohne die die Tabelle gemacht wurde: {figure} {range}, Effektivwert {rms}, größter Wert {largest}. Von beiden Vorhersagen ist dies die glaubwürdige.</translation>
    </message>
    <message>
        <source>before, all values</source>
        <translation>vorher, alle Werte</translation>
    </message>
    <message>
        <source>after, all values</source>
        <translation>nachher, alle Werte</translation>
    </message>
    <message>
        <source>all values</source>
        <translation>alle Werte</translation>
    </message>
    <message>
        <source>verdict, all values</source>
        <translation>Urteil, alle Werte</translation>
    </message>
    <message>
        <source>Targets before, all values, in {unit}</source>
        <translation>Zielpositionen vorher, alle Werte, in {unit}</translation>
    </message>
    <message>
        <source>Targets after, all values, in {unit}</source>
        <translation>Zielpositionen nachher, alle Werte, in {unit}</translation>
    </message>
    <message>
        <source>{said} ({files})</source>
        <translation>{said} ({files})</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before, {after} after.</source>
        <translation>Genauigkeit {figure} aus allen Werten, auch den ausgeschlossenen: {before} vorher, {after} nachher.</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before.</source>
        <translation>Genauigkeit {figure} aus allen Werten, auch den ausgeschlossenen: {before} vorher.</translation>
    </message>
</context>
<context>
    <name>RunValueText</name>
    <message>
        <source>%1, target %2, run %3, %4</source>
        <translation>%1, Zielposition %2, Durchlauf %3, %4</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>zum Ausschließen vorgeschlagen</translation>
    </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>counts per unit</source>
        <translation>Inkremente je Einheit</translation>
    </message>
    <message>
        <source>position unit</source>
        <translation>Einheit der Positionen</translation>
    </message>
    <message>
        <source>value unit</source>
        <translation>Einheit der Werte</translation>
    </message>
    <message>
        <source>wrap range</source>
        <translation>Bereich einer Umdrehung</translation>
    </message>
    <message>
        <source>master axis</source>
        <translation>Masterachse</translation>
    </message>
    <message>
        <source>master1 axis</source>
        <translation>Masterachse 1</translation>
    </message>
    <message>
        <source>master2 axis</source>
        <translation>Masterachse 2</translation>
    </message>
    <message>
        <source>n cycles</source>
        <translation>Anzahl Takte</translation>
    </message>
    <message>
        <source>master kind</source>
        <translation>Art der Masterachse</translation>
    </message>
    <message>
        <source>master1 kind</source>
        <translation>Art der Masterachse 1</translation>
    </message>
    <message>
        <source>master2 kind</source>
        <translation>Art der Masterachse 2</translation>
    </message>
    <message>
        <source>axis kind</source>
        <translation>Art der Achse</translation>
    </message>
    <message>
        <source>modulo</source>
        <translation>Modulo</translation>
    </message>
    <message>
        <source>modulo1</source>
        <translation>Modulo 1</translation>
    </message>
    <message>
        <source>modulo2</source>
        <translation>Modulo 2</translation>
    </message>
    <message>
        <source>list unit</source>
        <translation>Einheit der Liste</translation>
    </message>
    <message>
        <source>increments per unit</source>
        <translation>Inkremente je Einheit</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Art der Datei</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>first table</source>
        <translation>Erste Tabelle</translation>
    </message>
    <message>
        <source>input axis</source>
        <translation>Eingangsachse</translation>
    </message>
    <message>
        <source>output axis</source>
        <translation>Ausgangsachse</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>Messsystem</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>metrisch</translation>
    </message>
    <message>
        <source>increments</source>
        <translation>Inkremente</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>rotatorisch</translation>
    </message>
    <message>
        <source>rotary axes</source>
        <translation>Rundachsen</translation>
    </message>
    <message>
        <source>primary unit</source>
        <translation>Einheit von PRIMARY</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>primary</source>
        <translation>primary</translation>
    </message>
    <message>
        <source>column axis</source>
        <translation>Spaltenachse</translation>
    </message>
    <message>
        <source>row axis</source>
        <translation>Zeilenachse</translation>
    </message>
    <message>
        <source>output axis 1</source>
        <translation>Ausgangsachse 1</translation>
    </message>
    <message>
        <source>output axis 2</source>
        <translation>Ausgangsachse 2</translation>
    </message>
    <message>
        <source>output axis 3</source>
        <translation>Ausgangsachse 3</translation>
    </message>
    <message>
        <source>source counts per unit</source>
        <translation>Inkremente je Einheit der Quelle</translation>
    </message>
    <message>
        <source>target counts per unit</source>
        <translation>Inkremente je Einheit des Ziels</translation>
    </message>
    <message>
        <source>column counts per unit</source>
        <translation>Inkremente je Einheit der Spalte</translation>
    </message>
    <message>
        <source>source motor</source>
        <translation>Quellmotor</translation>
    </message>
    <message>
        <source>target motor</source>
        <translation>Zielmotor</translation>
    </message>
    <message>
        <source>row motor</source>
        <translation>Zeilenmotor</translation>
    </message>
    <message>
        <source>column motor</source>
        <translation>Spaltenmotor</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>Sollposition</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>Istposition</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>source axis 1</source>
        <translation>Quellachse 1</translation>
    </message>
    <message>
        <source>source axis 2</source>
        <translation>Quellachse 2</translation>
    </message>
    <message>
        <source>zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>declare</source>
        <translation>Deklaration</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>errormap</source>
        <translation>ERRORMAP</translation>
    </message>
    <message>
        <source>connect</source>
        <translation>CONNECT</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>beliebiger Abstand</translation>
    </message>
    <message>
        <source>reference number</source>
        <translation>Referenznummer</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>detection unit</source>
        <translation>Erfassungseinheit</translation>
    </message>
    <message>
        <source>magnification</source>
        <translation>Vergrößerungsfaktor</translation>
    </message>
    <message>
        <source>reference position</source>
        <translation>Referenzposition</translation>
    </message>
    <message>
        <source>first number</source>
        <translation>erste Nummer</translation>
    </message>
    <message>
        <source>last number</source>
        <translation>letzte Nummer</translation>
    </message>
    <message>
        <source>first record</source>
        <translation>erste Zeile</translation>
    </message>
    <message>
        <source>largest step</source>
        <translation>größter Wert</translation>
    </message>
    <message>
        <source>secondary unit</source>
        <translation>Einheit von SECONDARY</translation>
    </message>
    <message>
        <source>target axis</source>
        <translation>Zielachse der Steuerung</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>backing up the old state</source>
        <translation>der alte Zustand wird gesichert</translation>
    </message>
    <message>
        <source>checking for changes since the plan</source>
        <translation>es wird geprüft, ob sich seit der Planung etwas geändert hat</translation>
    </message>
    <message>
        <source>detaching the table from the axis</source>
        <translation>die Tabelle wird von der Achse gelöst</translation>
    </message>
    <message>
        <source>uploading the table</source>
        <translation>Tabelle übertragen</translation>
    </message>
    <message>
        <source>verifying the table</source>
        <translation>Tabelle vergleichen</translation>
    </message>
    <message>
        <source>storing the table in flash</source>
        <translation>Tabelle im Flash ablegen</translation>
    </message>
    <message>
        <source>switching the axis over</source>
        <translation>Achse umschalten</translation>
    </message>
    <message>
        <source>saving the parameters</source>
        <translation>Parameter speichern</translation>
    </message>
    <message>
        <source>reading back</source>
        <translation>zurücklesen</translation>
    </message>
    <message>
        <source>rolling back</source>
        <translation>der alte Zustand wird wiederhergestellt</translation>
    </message>
    <message>
        <source>reading the table</source>
        <translation>Tabelle lesen</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>Tabelle löschen</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>Dim %1</source>
        <translation>Dim %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Stützstellen</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between items of a list</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>.</source>
        <comment>ends a sentence</comment>
        <translation>.</translation>
    </message>
</context>
<context>
    <name>axiscomp::app::WizardWindow</name>
    <message>
        <source>[*]Axis Compensation Wizard</source>
        <translation>[*]Assistent für Achskompensation</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionPanel</name>
    <message>
        <source>&amp;Write Compensation</source>
        <translation>&amp;Kompensation schreiben</translation>
    </message>
    <message>
        <source>Re&amp;vert All</source>
        <translation>Alles &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Activate</source>
        <translation>&amp;Aktivieren</translation>
    </message>
    <message>
        <source>More actions</source>
        <translation>Weitere Aktionen</translation>
    </message>
    <message>
        <source>D&amp;eactivate</source>
        <translation>&amp;Deaktivieren</translation>
    </message>
    <message>
        <source>&amp;Evaluate (Adds Nothing)</source>
        <translation>Aus&amp;werten (ohne Aufschaltung)</translation>
    </message>
    <message>
        <source>Restore &amp;Previous Table…</source>
        <translation>&amp;Vorherige Tabelle wiederherstellen…</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Writes table and settings to the drive and verifies them (Ctrl+Return)</source>
        <translation>Schreibt Tabelle und Einstellungen in den Antrieb und prüft sie (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Resets all fields to the drive&apos;s values (Ctrl+Shift+R)</source>
        <translation>Setzt alle Felder auf die Werte des Antriebs zurück (Strg+Umschalt+R)</translation>
    </message>
    <message>
        <source>Switches the compensation on, then compares the drive&apos;s output with the table</source>
        <translation>Schaltet die Kompensation ein und vergleicht dann den Ausgang des Antriebs mit der Tabelle</translation>
    </message>
    <message>
        <source>Switches the compensation off</source>
        <translation>Schaltet die Kompensation aus</translation>
    </message>
    <message>
        <source>The drive looks up the table and shows the indices, but adds nothing</source>
        <translation>Der Antrieb liest die Tabelle und zeigt die Indizes, schaltet aber nichts auf</translation>
    </message>
    <message>
        <source>Writes back the table and settings from before the last write</source>
        <translation>Schreibt Tabelle und Einstellungen von vor dem letzten Schreiben zurück</translation>
    </message>
    <message>
        <source>Continue in the preview on the right</source>
        <translation>Weiter in der Vorschau rechts</translation>
    </message>
    <message>
        <source>&amp;Delete Table…</source>
        <translation>Tabelle &amp;löschen …</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive and frees its slot</source>
        <translation>Löscht die Tabelle der Achse vom Antrieb und gibt ihren Tabellenplatz frei</translation>
    </message>
    <message>
        <source>Evaluate, restore a backup, or delete the table</source>
        <translation>Auswerten, eine Sicherung wiederherstellen oder die Tabelle löschen</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>Siche&amp;rung wiederherstellen…</translation>
    </message>
    <message>
        <source>Shows the backups of this drive and restores the one you choose</source>
        <translation>Zeigt die Sicherungen dieses Antriebs und stellt die gewählte wieder her</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionRules</name>
    <message>
        <source>No drive is connected: add a connection first.</source>
        <translation>Kein Antrieb ist verbunden: zuerst eine Verbindung hinzufügen.</translation>
    </message>
    <message>
        <source>Reading the axes of the drives.</source>
        <translation>Die Achsen der Antriebe werden gelesen.</translation>
    </message>
    <message>
        <source>Choose an axis first.</source>
        <translation>Zuerst eine Achse wählen.</translation>
    </message>
    <message>
        <source>The drive is not connected.</source>
        <translation>Der Antrieb ist nicht verbunden.</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>Diese Achse hat keine Kompensationsregister.</translation>
    </message>
    <message>
        <source>Please wait: %1.</source>
        <translation>Bitte warten: %1.</translation>
    </message>
    <message>
        <source>The axis is being read.</source>
        <translation>Die Achse wird gelesen.</translation>
    </message>
    <message>
        <source>The compensation is active: deactivate it first.</source>
        <translation>Die Kompensation ist aktiv: zuerst deaktivieren.</translation>
    </message>
    <message>
        <source>No table is chosen: open compensation data.</source>
        <translation>Keine Tabelle gewählt: Kompensationsdaten öffnen.</translation>
    </message>
    <message>
        <source>The table has 1 dimension, but %1D is chosen.</source>
        <translation>Die Tabelle hat 1 Dimension, gewählt ist aber %1D.</translation>
    </message>
    <message>
        <source>The table has %1 dimensions, but %2D is chosen.</source>
        <translation>Die Tabelle hat %1 Dimensionen, gewählt ist aber %2D.</translation>
    </message>
    <message>
        <source>A source is being checked.</source>
        <translation>Eine Quelle wird geprüft.</translation>
    </message>
    <message>
        <source>Dim%1 Source is missing.</source>
        <translation>Die Dim%1-Quelle fehlt.</translation>
    </message>
    <message>
        <source>Dim%1 Source is the same as another source.</source>
        <translation>Die Dim%1-Quelle ist dieselbe wie eine andere.</translation>
    </message>
    <message>
        <source>The table needs %1 bytes, but the largest slot has %2.</source>
        <translation>Die Tabelle braucht %1 Byte, der größte Tabellenplatz hat %2.</translation>
    </message>
    <message>
        <source>To spare the flash, wait %1 or write volatile.</source>
        <translation>Zur Schonung des Flash-Speichers %1 warten oder flüchtig schreiben.</translation>
    </message>
    <message>
        <source>Nothing has changed.</source>
        <translation>Nichts ist geändert.</translation>
    </message>
    <message>
        <source>The file is being read.</source>
        <translation>Die Datei wird gelesen.</translation>
    </message>
    <message>
        <source>The parameters still have to be saved.</source>
        <translation>Die Parameter müssen noch gespeichert werden.</translation>
    </message>
    <message>
        <source>The axis has no table on the drive: write one first.</source>
        <translation>Die Achse hat keine Tabelle im Antrieb: zuerst eine schreiben.</translation>
    </message>
    <message>
        <source>An earlier write left the axis in neither the old nor the new state: write again or restore the previous state.</source>
        <translation>Ein früherer Schreibvorgang hat die Achse weder im alten noch im neuen Zustand hinterlassen: erneut schreiben oder den vorigen Zustand wiederherstellen.</translation>
    </message>
    <message>
        <source>The compensation is already active.</source>
        <translation>Die Kompensation ist bereits aktiv.</translation>
    </message>
    <message>
        <source>The axis must be homed first.</source>
        <translation>Die Achse muss zuerst referenziert werden.</translation>
    </message>
    <message>
        <source>The compensation is already being evaluated.</source>
        <translation>Die Kompensation wird bereits ausgewertet.</translation>
    </message>
    <message>
        <source>The compensation is not active.</source>
        <translation>Die Kompensation ist nicht aktiv.</translation>
    </message>
    <message>
        <source>This axis has no backup yet; every write makes one.</source>
        <translation>Diese Achse hat noch keine Sicherung; jedes Schreiben legt eine an.</translation>
    </message>
    <message>
        <source>Nothing is running.</source>
        <translation>Es läuft nichts.</translation>
    </message>
    <message>
        <source>It is already being stopped.</source>
        <translation>Es wird bereits angehalten.</translation>
    </message>
    <message>
        <source>Finishes an earlier write: saves the parameters of the drive.</source>
        <translation>Schließt ein früheres Schreiben ab: speichert die Parameter des Antriebs.</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash; uses %1 of the %2 flash operations available now.</source>
        <translation>Schreibt in den Antrieb und in den Flash-Speicher; braucht %1 der %2 jetzt verfügbaren Flash-Vorgänge.</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash.</source>
        <translation>Schreibt in den Antrieb und in seinen Flash-Speicher.</translation>
    </message>
    <message>
        <source>Writes to the drive and saves its parameters; the table in flash stays.</source>
        <translation>Schreibt in den Antrieb und speichert seine Parameter; die Tabelle im Flash-Speicher bleibt.</translation>
    </message>
    <message>
        <source>Writes to the drive; a reboot of the drive restores the stored state.</source>
        <translation>Schreibt in den Antrieb; ein Neustart des Antriebs stellt den gespeicherten Zustand wieder her.</translation>
    </message>
    <message>
        <source>Adds the table to the encoder position and proves that the drive&apos;s output matches the table.</source>
        <translation>Addiert die Tabelle zur Geberposition und weist nach, dass der Ausgang des Antriebs der Tabelle entspricht.</translation>
    </message>
    <message>
        <source>The drive looks up the table without adding anything.</source>
        <translation>Der Antrieb liest die Tabelle, ohne etwas aufzuschalten.</translation>
    </message>
    <message>
        <source>Switches the compensation off; table and settings stay on the drive.</source>
        <translation>Schaltet die Kompensation aus; Tabelle und Einstellungen bleiben im Antrieb.</translation>
    </message>
    <message>
        <source>Resets the fields to the drive&apos;s values.</source>
        <translation>Setzt die Felder auf die Werte des Antriebs zurück.</translation>
    </message>
    <message>
        <source>Writes back the previous table and sources.</source>
        <translation>Schreibt die vorige Tabelle und die vorigen Quellen zurück.</translation>
    </message>
    <message>
        <source>Searches for drives and axes again and reads the axis.</source>
        <translation>Sucht Antriebe und Achsen erneut und liest die Achse.</translation>
    </message>
    <message>
        <source>Opens a file of compensation data, .csv or .TAMtbl.</source>
        <translation>Öffnet eine Datei mit Kompensationsdaten, .csv oder .TAMtbl.</translation>
    </message>
    <message>
        <source>Stops reading the file.</source>
        <translation>Bricht das Lesen der Datei ab.</translation>
    </message>
    <message>
        <source>Stops the write and rolls back.</source>
        <translation>Hält das Schreiben an und stellt den alten Zustand wieder her.</translation>
    </message>
    <message>
        <source>Stops what is running.</source>
        <translation>Bricht den laufenden Vorgang ab.</translation>
    </message>
    <message>
        <source>%1 ...</source>
        <translation>%1 ...</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: its parameters may not be saved. Write to finish it.</source>
        <translation>Ein früherer Schreibvorgang wurde unterbrochen: die Parameter sind womöglich nicht gespeichert. Schreiben vollendet ihn.</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>Die Kompensation ist aktiv.</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>Die Kompensation wird nur ausgewertet: der Antrieb addiert nichts.</translation>
    </message>
    <message>
        <source>This axis has no unfinished write.</source>
        <translation>Diese Achse hat keinen unterbrochenen Schreibvorgang.</translation>
    </message>
    <message>
        <source>Completes the interrupted write.</source>
        <translation>Vollendet den unterbrochenen Schreibvorgang.</translation>
    </message>
    <message>
        <source>Restores the state before the interrupted write.</source>
        <translation>Stellt den Zustand vor dem unterbrochenen Schreibvorgang wieder her.</translation>
    </message>
    <message>
        <source>Open a file with several columns of values first.</source>
        <translation>Zuerst eine Datei mit mehreren Spalten von Werten öffnen.</translation>
    </message>
    <message>
        <source>The drive has no second axis with compensation registers.</source>
        <translation>Der Antrieb hat keine zweite Achse mit Kompensationsregistern.</translation>
    </message>
    <message>
        <source>Writes several columns of the open file, each to its own axis.</source>
        <translation>Schreibt mehrere Spalten der offenen Datei, jede auf ihre Achse.</translation>
    </message>
    <message>
        <source>planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>writing several axes</source>
        <translation>mehrere Achsen schreiben</translation>
    </message>
    <message>
        <source>activating</source>
        <translation>Aktivieren</translation>
    </message>
    <message>
        <source>evaluating</source>
        <translation>Auswerten</translation>
    </message>
    <message>
        <source>deactivating</source>
        <translation>Deaktivieren</translation>
    </message>
    <message>
        <source>finishing the write</source>
        <translation>Schreibvorgang wird vollendet</translation>
    </message>
    <message>
        <source>undoing the write</source>
        <translation>Schreiben wird zurückgenommen</translation>
    </message>
    <message>
        <source>restoring</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>The record of this drive&apos;s flash operations was damaged, so all of them count as used up. Write volatile, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>Die Aufzeichnung der Flash-Vorgänge dieses Antriebs war beschädigt, daher gelten alle als verbraucht. Flüchtig schreiben oder „axiscomp status --reset-flash-count“ ausführen.</translation>
    </message>
    <message>
        <source>The axis has no table on the drive.</source>
        <translation>Die Achse hat keine Tabelle auf dem Antrieb.</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive; a backup is kept.</source>
        <translation>Löscht die Tabelle der Achse vom Antrieb; eine Sicherung bleibt.</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>Tabelle löschen</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: finish or undo it first.</source>
        <translation>Ein früherer Schreibvorgang wurde unterbrochen: zuerst vollenden oder rückgängig machen.</translation>
    </message>
    <message>
        <source>Writes the table and source parameters of a TAM configuration to the drive.</source>
        <translation>Schreibt die Parameter für Tabellen und Quellen aus einer TAM-Konfiguration in den Antrieb.</translation>
    </message>
    <message>
        <source>Puts the drive&apos;s table and source parameters into a TAM configuration.</source>
        <translation>Übernimmt die Parameter des Antriebs für Tabellen und Quellen in eine TAM-Konfiguration.</translation>
    </message>
    <message>
        <source>importing parameters</source>
        <translation>Parameter importieren</translation>
    </message>
    <message>
        <source>Writes back a backup that you choose.</source>
        <translation>Stellt eine Sicherung wieder her, die Sie wählen.</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up. Keep the table persistent, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>Auch das Entfernen der Tabelle aus dem Flash ist ein Flash-Vorgang, und die Aufzeichnung der Flash-Vorgänge dieses Antriebs war beschädigt, daher gelten alle als verbraucht. Die Tabelle dauerhaft lassen oder „axiscomp status --reset-flash-count“ ausführen.</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too: wait %1, or keep the table persistent.</source>
        <translation>Auch das Entfernen der Tabelle aus dem Flash ist ein Flash-Vorgang: %1 warten oder die Tabelle dauerhaft lassen.</translation>
    </message>
    <message>
        <source>Removes the table from flash, which uses %1 of the %2 flash operations available now.</source>
        <translation>Entfernt die Tabelle aus dem Flash; das braucht %1 der %2 jetzt möglichen Flash-Vorgänge.</translation>
    </message>
    <message>
        <source>Writes to the drive and removes the table from flash.</source>
        <translation>Schreibt in den Antrieb und entfernt die Tabelle aus dem Flash.</translation>
    </message>
    <message>
        <source>Saves the tables and sources of all axes of the drive to a file.</source>
        <translation>Speichert die Tabellen und Quellen aller Achsen des Antriebs in einer Datei.</translation>
    </message>
    <message>
        <source>Writes a backup of the whole drive back to it, axis by axis.</source>
        <translation>Schreibt eine Sicherung des ganzen Antriebs Achse für Achse zurück.</translation>
    </message>
    <message>
        <source>backing up the drive</source>
        <translation>Antrieb wird gesichert</translation>
    </message>
    <message>
        <source>restoring the drive</source>
        <translation>Antrieb wird wiederhergestellt</translation>
    </message>
    <message>
        <source>What an earlier write left is not known: write again or restore another backup.</source>
        <translation>Was ein früherer Schreibvorgang hinterlassen hat, ist nicht bekannt: erneut schreiben oder eine andere Sicherung wiederherstellen.</translation>
    </message>
    <message>
        <source>An earlier write was interrupted, and the backup of the state before it cannot be read: write again or restore another backup first.</source>
        <translation>Ein früherer Schreibvorgang wurde unterbrochen, und die Sicherung des Zustands davor ist nicht lesbar: zuerst erneut schreiben oder eine andere Sicherung wiederherstellen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ApplyMachineDialog</name>
    <message>
        <source>Apply Machine File</source>
        <translation>Maschinendatei anwenden</translation>
    </message>
    <message>
        <source>What %1 says is written to all drives that differ from it, or to none. Each axis is backed up first, verified, and put back when its write fails.</source>
        <translation>Was in %1 steht, wird in alle Antriebe geschrieben, die davon abweichen, oder in keinen. Jede Achse wird zuerst gesichert, dann verifiziert und zurückgesetzt, wenn ihr Schreibvorgang misslingt.</translation>
    </message>
    <message>
        <source>Also &amp;switch compensations on and off where the file says so</source>
        <translation>Kompensationen auch ein- und ausschalten, wo die Datei es &amp;sagt</translation>
    </message>
    <message>
        <source>Leave &amp;out drives that do not answer</source>
        <translation>Antriebe auslassen, die &amp;nicht antworten</translation>
    </message>
    <message>
        <source>Otherwise nothing is written while one does not answer</source>
        <translation>Sonst wird nichts geschrieben, solange einer nicht antwortet</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Im Antrieb</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>In der Maschinendatei</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Anwenden</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field and value</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and warning</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>Dieser Antrieb ist nicht mehr unter den Verbindungen.</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>It holds</source>
        <translation>Sie enthält</translation>
    </message>
    <message>
        <source>What has become of each axis</source>
        <translation>Was aus jeder Achse geworden ist</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>Braucht keinen Flash-Vorgang.</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>Flash-Vorgänge insgesamt: %1.</translation>
    </message>
    <message>
        <source>Stopping: each drive ends where it is safe …</source>
        <translation>Wird angehalten: jeder Antrieb endet dort, wo es sicher ist …</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
    <message>
        <source>Write these to the drives now</source>
        <translation>Das jetzt in die Antriebe schreiben</translation>
    </message>
    <message>
        <source>Stops the writes; those under way are rolled back (Esc)</source>
        <translation>Hält das Schreiben an; was gerade läuft, wird rückgängig gemacht (Esc)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and proof</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tries to prove each axis that it switches on, and names those of which nothing is proved; without it the file&apos;s “active” is only compared</source>
        <translation>Versucht, jede eingeschaltete Achse nachzuweisen, und nennt die, bei denen nichts nachgewiesen ist; ohne dies wird „active“ der Datei nur verglichen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisList</name>
    <message>
        <source>The drive %1 is not connected.</source>
        <translation>Der Antrieb %1 ist nicht verbunden.</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>Diese Achse hat keine Kompensationsregister.</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source> (no compensation)</source>
        <translation> (keine Kompensation)</translation>
    </message>
    <message>
        <source> (demo)</source>
        <translation> (Demo)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisState</name>
    <message>
        <source>Compensation: %1.</source>
        <translation>Kompensation: %1.</translation>
    </message>
    <message>
        <source>Homing: %1.</source>
        <translation>Referenzierung: %1.</translation>
    </message>
    <message>
        <source>The compensation is in error: %1.</source>
        <translation>Die Kompensation meldet einen Fehler: %1.</translation>
    </message>
    <message>
        <source>The drive is in error: %1.</source>
        <translation>Der Antrieb meldet einen Fehler: %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::BackupDialog</name>
    <message>
        <source>damaged</source>
        <comment>backup</comment>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>last write</source>
        <comment>what was done after the backup</comment>
        <translation>letzter Schreibvorgang</translation>
    </message>
    <message>
        <source>new table</source>
        <comment>what was done after the backup</comment>
        <translation>neue Tabelle</translation>
    </message>
    <message>
        <source>table deleted</source>
        <comment>what was done after the backup</comment>
        <translation>Tabelle gelöscht</translation>
    </message>
    <message>
        <source>settings changed</source>
        <comment>what was done after the backup</comment>
        <translation>Einstellungen geändert</translation>
    </message>
    <message>
        <source>undone, or nothing changed</source>
        <comment>what was done after the backup</comment>
        <translation>rückgängig gemacht, oder nichts geändert</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>Restore Backup</source>
        <translation>Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>Before each write this computer keeps what the axis had. Choose what %1 shall have again; the preview shows what that changes before anything is written.</source>
        <translation>Vor jedem Schreiben bewahrt dieser Rechner auf, was die Achse hatte. Wählen Sie, was %1 wieder haben soll; die Vorschau zeigt, was sich dadurch ändert, bevor etwas geschrieben wird.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>Sicherungen, die neueste zuerst</translation>
    </message>
    <message>
        <source>Restore the backup of an&amp;other drive to this one</source>
        <translation>Sicherung eines an&amp;deren Antriebs auf diesem wiederherstellen</translation>
    </message>
    <message>
        <source>Open Backup &amp;File…</source>
        <translation>Sicherungs&amp;datei öffnen…</translation>
    </message>
    <message>
        <source>Choose from a file that is kept elsewhere, such as one of a drive that was replaced</source>
        <translation>Aus einer Datei wählen, die woanders liegt, etwa der eines ersetzten Antriebs</translation>
    </message>
    <message>
        <source>&amp;Restore…</source>
        <translation>&amp;Wiederherstellen…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open Backup File</source>
        <translation>Sicherungsdatei öffnen</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>Sicherungen (*.json)</translation>
    </message>
    <message>
        <source>%1, drive %2</source>
        <comment>axis and serial number</comment>
        <translation>%1, Antrieb %2</translation>
    </message>
    <message>
        <source>This backup is damaged: %1</source>
        <translation>Diese Sicherung ist beschädigt: %1</translation>
    </message>
    <message>
        <source>This backup is of the drive with the serial number %1; this one is %2.</source>
        <translation>Diese Sicherung ist von dem Antrieb mit der Seriennummer %1; dieser hier ist %2.</translation>
    </message>
    <message>
        <source>Table of the backup</source>
        <translation>Tabelle der Sicherung</translation>
    </message>
    <message>
        <source>There is no backup of this drive on this computer.</source>
        <translation>Auf diesem Rechner ist keine Sicherung dieses Antriebs.</translation>
    </message>
    <message>
        <source>The backups are being read.</source>
        <translation>Die Sicherungen werden gelesen.</translation>
    </message>
    <message>
        <source>A damaged backup cannot be restored.</source>
        <translation>Eine beschädigte Sicherung kann nicht wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>Confirm first that the backup of another drive is meant.</source>
        <translation>Bestätigen Sie zuerst, dass die Sicherung eines anderen Antriebs gemeint ist.</translation>
    </message>
    <message>
        <source>Show what restoring this backup would change</source>
        <translation>Zeigen, was das Wiederherstellen dieser Sicherung ändern würde</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CaptureDialog</name>
    <message>
        <source>Capture Values</source>
        <translation>Messwerte erfassen</translation>
    </message>
    <message>
        <source>a register of the drive</source>
        <translation>ein Register des Antriebs</translation>
    </message>
    <message>
        <source>an instrument on a serial port</source>
        <translation>ein Messgerät an einem seriellen Anschluss</translation>
    </message>
    <message>
        <source>typed by hand</source>
        <translation>von Hand eingegeben</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>Wäh&amp;len…</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>Wä&amp;hlen…</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Take nothing and go back (Esc)</source>
        <translation>Nichts nehmen und zurückgehen (Esc)</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The current one; something else moves it</source>
        <translation>Die aktuelle; etwas anderes bewegt sie</translation>
    </message>
    <message>
        <source>Pla&amp;n</source>
        <translation>Me&amp;ssplan</translation>
    </message>
    <message>
        <source>As New Program saves it</source>
        <translation>Wie Neues Programm ihn speichert</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>&amp;Referenz</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>Woher sie kommt</translation>
    </message>
    <message>
        <source>Re&amp;gister</source>
        <translation>Re&amp;gister</translation>
    </message>
    <message>
        <source>Which says where the axis really is: chosen from the list, or a path, URI or address</source>
        <translation>Das sagt, wo die Achse wirklich ist: aus der Liste gewählt, oder ein Pfad, eine URI oder Adresse</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Anschluss</translation>
    </message>
    <message>
        <source>Of the instrument, with its speed</source>
        <translation>Des Messgeräts, mit seiner Geschwindigkeit</translation>
    </message>
    <message>
        <source>Re&amp;quest</source>
        <translation>An&amp;frage</translation>
    </message>
    <message>
        <source>Sent before each reading, with \r and \n for line ends; empty: the instrument sends by itself</source>
        <translation>Wird vor jeder Ablesung gesendet, mit \r und \n für Zeilenenden; leer: das Messgerät sendet von selbst</translation>
    </message>
    <message>
        <source>Pa&amp;ttern</source>
        <translation>&amp;Muster</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line; empty: the first number of the line</source>
        <translation>Regulärer Ausdruck für die Zahl in einer Zeile; leer: die erste Zahl der Zeile</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Einheit</translation>
    </message>
    <message>
        <source>Of the numbers of the instrument</source>
        <translation>Der Zahlen des Messgeräts</translation>
    </message>
    <message>
        <source>&amp;Zero at</source>
        <translation>&amp;Null bei</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0</source>
        <translation>Position der Achse, wo das Messgerät 0 sagt</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Ruhefens&amp;ter</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within this, and readings may differ by as much</source>
        <translation>Die Achse steht, solange ihr Geber darin bleibt, und so viel dürfen Ablesungen sich unterscheiden</translation>
    </message>
    <message>
        <source>&amp;Dwell</source>
        <translation>Verweil&amp;zeit</translation>
    </message>
    <message>
        <source>So long the axis must have stood before its value is taken</source>
        <translation>So lange muss die Achse gestanden haben, bevor ihr Wert genommen wird</translation>
    </message>
    <message>
        <source>&amp;Average of</source>
        <translation>M&amp;ittel aus</translation>
    </message>
    <message>
        <source>Readings that make a value</source>
        <translation>Ablesungen, die einen Wert ergeben</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Werte</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>Datei der Werte; eine, die es gibt, geht weiter, wo sie endet</translation>
    </message>
    <message>
        <source>The instrument counts the &amp;other way</source>
        <translation>Das Messgerät zählt an&amp;dersherum</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>Für ein Messgerät, das abwärts zählt, während die Achse aufwärts fährt</translation>
    </message>
    <message>
        <source>Choose the plan</source>
        <translation>Den Messplan wählen</translation>
    </message>
    <message>
        <source>Choose the file of the values</source>
        <translation>Die Datei der Werte wählen</translation>
    </message>
    <message>
        <source> readings</source>
        <translation> Ablesungen</translation>
    </message>
    <message>
        <source>Choose Plan</source>
        <translation>Messplan wählen</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>Messpläne (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>File of the Values</source>
        <translation>Datei der Werte</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>Durchläufe (*.csv)</translation>
    </message>
    <message>
        <source>that of the axis</source>
        <translation>die der Achse</translation>
    </message>
    <message>
        <source>as the instrument says</source>
        <translation>wie das Messgerät sagt</translation>
    </message>
    <message>
        <source>that of the plan</source>
        <translation>die des Messplans</translation>
    </message>
    <message>
        <source>The drive does not answer.</source>
        <translation>Der Antrieb antwortet nicht.</translation>
    </message>
    <message>
        <source>Wait until the drive is free.</source>
        <translation>Warten, bis der Antrieb frei ist.</translation>
    </message>
    <message>
        <source>The plan is being read …</source>
        <translation>Der Messplan wird gelesen …</translation>
    </message>
    <message>
        <source>Choose a plan; New Program makes one.</source>
        <translation>Einen Messplan wählen; Neues Programm macht einen.</translation>
    </message>
    <message>
        <source>Choose the register of the reference.</source>
        <translation>Das Register der Referenz wählen.</translation>
    </message>
    <message>
        <source>Name the port of the instrument, such as serial:/dev/ttyUSB1?baud=9600.</source>
        <translation>Den Anschluss des Messgeräts nennen, etwa serial:/dev/ttyUSB1?baud=9600.</translation>
    </message>
    <message>
        <source>Choose the file of the values.</source>
        <translation>Die Datei der Werte wählen.</translation>
    </message>
    <message>
        <source>the plan just made (%1)</source>
        <translation>der eben gemachte Messplan (%1)</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>Der Antrieb wird gelesen …</translation>
    </message>
    <message>
        <source>Values are taken while the control of the machine, or a person, moves the axis. This program never moves it.</source>
        <translation>Werte werden genommen, während die Steuerung der Maschine oder ein Mensch die Achse bewegt. Dieses Programm bewegt sie nie.</translation>
    </message>
    <message>
        <source>Read axis and instrument, and take values</source>
        <translation>Achse und Messgerät lesen und Werte nehmen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CapturePanel</name>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Reference - axis</source>
        <translation>Referenz - Achse</translation>
    </message>
    <message>
        <source>The reference minus where the axis is: its encoder and what the drive adds</source>
        <translation>Die Referenz minus wo die Achse ist: ihr Geber und was der Antrieb addiert</translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation>Schritte des Messplans</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>&amp;Jetzt übernehmen</translation>
    </message>
    <message>
        <source>Undo Las&amp;t</source>
        <translation>Letzten zurückneh&amp;men</translation>
    </message>
    <message>
        <source>Stop Capturin&amp;g</source>
        <translation>Erfassun&amp;g beenden</translation>
    </message>
    <message>
        <source>%1: values to %2</source>
        <translation>%1: Werte nach %2</translation>
    </message>
    <message>
        <source>T&amp;he instrument says [%1]</source>
        <translation>Ablesu&amp;ng [%1]</translation>
    </message>
    <message>
        <source>What the instrument says, in %1</source>
        <translation>Was das Messgerät sagt, in %1</translation>
    </message>
    <message>
        <source>Nothing is being taken</source>
        <translation>Es wird nichts erfasst</translation>
    </message>
    <message>
        <source>The drive does not answer</source>
        <translation>Der Antrieb antwortet nicht</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>Wie&amp;der aufnehmen</translation>
    </message>
    <message>
        <source>Paus&amp;e</source>
        <translation>Unter&amp;brechen</translation>
    </message>
    <message>
        <source>Take what was typed for the step that is due (Enter or space bar)</source>
        <translation>Nehmen, was für den fälligen Schritt eingegeben wurde (Eingabe- oder Leertaste)</translation>
    </message>
    <message>
        <source>A position is asked for as soon as the axis stands at the target that is due</source>
        <translation>Nach einer Position wird gefragt, sobald die Achse an der fälligen Zielposition steht</translation>
    </message>
    <message>
        <source>No value has been taken yet</source>
        <translation>Es wurde noch kein Wert genommen</translation>
    </message>
    <message>
        <source>Take the last value off the file; its step is due again</source>
        <translation>Den letzten Wert aus der Datei nehmen; sein Schritt ist wieder fällig</translation>
    </message>
    <message>
        <source>Go on; the axis has to come to its target once more</source>
        <translation>Weitermachen; die Achse muss noch einmal zu ihrer Zielposition kommen</translation>
    </message>
    <message>
        <source>Take nothing until Resume, such as while somebody works at the machine</source>
        <translation>Nichts nehmen bis zur Wiederaufnahme, etwa während jemand an der Maschine arbeitet</translation>
    </message>
    <message>
        <source>End here; what was taken stays in the file, and Capture goes on behind it with the same plan</source>
        <translation>Hier aufhören; was genommen wurde, bleibt in der Datei, und Messwerte erfassen macht mit demselben Messplan dahinter weiter</translation>
    </message>
    <message>
        <source>The drive does not say the unit of the axis: it is taken to be that of the plan.</source>
        <translation>Der Antrieb sagt die Einheit der Achse nicht: die des Messplans wird angenommen.</translation>
    </message>
    <message>
        <source>The clock of this computer is behind the last value of the file: times go on from there.</source>
        <translation>Die Uhr dieses Rechners geht hinter dem letzten Wert der Datei: die Zeiten gehen von dort weiter.</translation>
    </message>
    <message>
        <source>The reference is a Single: at %1 its numbers are %2 apart.</source>
        <translation>Die Referenz ist ein Single: bei %1 liegen ihre Zahlen %2 auseinander.</translation>
    </message>
    <message>
        <source>The instrument is far from the axis, as if it said 0 at %1: if that is right, begin a new file with this as the zero.</source>
        <translation>Das Messgerät ist weit von der Achse, als sagte es 0 bei %1: wenn das stimmt, eine neue Datei mit diesem Nullpunkt beginnen.</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, upwards from %3.</source>
        <translation>Schritt %1 ist fällig: %2, aufwärts von %3.</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, downwards from %3.</source>
        <translation>Schritt %1 ist fällig: %2, abwärts von %3.</translation>
    </message>
    <message>
        <source>The axis stands at step %1: %2 of %3 readings.</source>
        <translation>Die Achse steht bei Schritt %1: %2 von %3 Ablesungen.</translation>
    </message>
    <message>
        <source>The axis stands; it is waited until it has come to rest.</source>
        <translation>Die Achse steht; es wird gewartet, bis sie zur Ruhe gekommen ist.</translation>
    </message>
    <message>
        <source>The axis stands at step %1: read the instrument, and type what it says.</source>
        <translation>Die Achse steht bei Schritt %1: das Messgerät ablesen und eingeben, was es sagt.</translation>
    </message>
    <message>
        <source>Taken. %1</source>
        <translation>Genommen. %1</translation>
    </message>
    <message>
        <source>The axis moves. %1</source>
        <translation>Die Achse bewegt sich. %1</translation>
    </message>
    <message>
        <source>%1 of %2 values are in %3.</source>
        <translation>%1 von %2 Werten sind in %3.</translation>
    </message>
    <message>
        <source>Every step has its value: %1 values are in %2.</source>
        <translation>Jeder Schritt hat seinen Wert: %1 Werte sind in %2.</translation>
    </message>
    <message>
        <source>Stopped. %1 Capture goes on behind them with the same plan and file.</source>
        <translation>Beendet. %1 Messwerte erfassen macht mit demselben Messplan und derselben Datei dahinter weiter.</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>Der Antrieb wird gelesen …</translation>
    </message>
    <message>
        <source>Nothing is taken: %1 It goes on when the drive answers again.</source>
        <translation>Es wird nichts genommen: %1 Es geht weiter, wenn der Antrieb wieder antwortet.</translation>
    </message>
    <message>
        <source>Nothing is taken while the window does something else on this drive.</source>
        <translation>Es wird nichts genommen, solange das Fenster etwas anderes auf diesem Antrieb tut.</translation>
    </message>
    <message>
        <source>Paused: nothing is taken. %1</source>
        <translation>Unterbrochen: es wird nichts genommen. %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CapturedPlot</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>up</source>
        <translation>aufwärts</translation>
    </message>
    <message>
        <source>down</source>
        <translation>abwärts</translation>
    </message>
    <message>
        <source>Deviations that were taken</source>
        <translation>Abweichungen, die genommen wurden</translation>
    </message>
    <message>
        <source>The same values are in the list of steps</source>
        <translation>Dieselben Werte stehen in der Liste der Schritte</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateButton</name>
    <message>
        <source>Forget Cert&amp;ificate</source>
        <translation>Zerti&amp;fikat vergessen</translation>
    </message>
    <message>
        <source>Cert&amp;ificate …</source>
        <translation>Zerti&amp;fikat …</translation>
    </message>
    <message>
        <source>Stop trusting the certificate of the selected drive</source>
        <translation>Dem Zertifikat des ausgewählten Antriebs nicht mehr vertrauen</translation>
    </message>
    <message>
        <source>Show the certificate of the selected drive and decide whether to trust it</source>
        <translation>Das Zertifikat des ausgewählten Antriebs zeigen und entscheiden, ob ihm vertraut wird</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateDialog</name>
    <message>
        <source>Drive Certificate</source>
        <translation>Zertifikat des Antriebs</translation>
    </message>
    <message>
        <source>The certificate of this drive has CHANGED since it was trusted. Either the drive has a new one, or another device answers at its address.</source>
        <translation>Das Zertifikat dieses Antriebs hat sich GEÄNDERT, seit ihm vertraut wurde. Entweder hat der Antrieb ein neues, oder ein anderes Gerät antwortet unter seiner Adresse.</translation>
    </message>
    <message>
        <source>No authority known to this computer has signed this certificate, so the identity of the drive cannot be confirmed.</source>
        <translation>Keine diesem Rechner bekannte Stelle hat dieses Zertifikat unterschrieben; dass wirklich der Antrieb antwortet, ist daher nicht sicher.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Ausgestellt für</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Ausgestellt von</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>SHA-256 fingerprint</source>
        <translation>SHA-256-Fingerabdruck</translation>
    </message>
    <message>
        <source>from %1 until %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>Trust it only if the drive itself, or its administrator, shows the same fingerprint. From then on this address is accepted with this certificate only.</source>
        <translation>Nur vertrauen, wenn der Antrieb selbst oder sein Verwalter denselben Fingerabdruck zeigt. Von da an wird diese Adresse nur mit diesem Zertifikat angenommen.</translation>
    </message>
    <message>
        <source>Do &amp;Not Trust</source>
        <translation>&amp;Nicht vertrauen</translation>
    </message>
    <message>
        <source>Stay disconnected (Esc)</source>
        <translation>Getrennt bleiben (Esc)</translation>
    </message>
    <message>
        <source>&amp;Trust This Certificate</source>
        <translation>Diesem Zertifikat &amp;vertrauen</translation>
    </message>
    <message>
        <source>Accept this certificate for this address from now on</source>
        <translation>Dieses Zertifikat ab jetzt für diese Adresse annehmen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ChangePictures</name>
    <message>
        <source>On the drive</source>
        <translation>Im Antrieb</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Difference, new − old</source>
        <translation>Differenz, neu − alt</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>größter Wert %1</translation>
    </message>
    <message>
        <source>%1; shown: the middle slice, %2 %3</source>
        <comment>largest value, dimension, place</comment>
        <translation>%1; gezeigt: der mittlere Schnitt, %2 %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>value at position</comment>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis zu %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnMapping</name>
    <message>
        <source>Select at least one axis.</source>
        <translation>Mindestens eine Achse auswählen.</translation>
    </message>
    <message>
        <source>%1 is selected twice; an axis has only one table.</source>
        <translation>%1 ist zweimal ausgewählt; eine Achse hat nur eine Tabelle.</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnMappingTable</name>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>Spalte der Datei</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Which column is for which axis</source>
        <translation>Welche Spalte für welche Achse ist</translation>
    </message>
    <message>
        <source>none</source>
        <comment>axis</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>Axis for %1</source>
        <translation>Achse für %1</translation>
    </message>
    <message>
        <source>The axis for column %1</source>
        <translation>Die Achse für Spalte %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnPreview</name>
    <message>
        <source>Columns of the file</source>
        <translation>Spalten der Datei</translation>
    </message>
    <message>
        <source>by its name</source>
        <translation>nach ihrem Namen</translation>
    </message>
    <message>
        <source>What column %1 is</source>
        <translation>Was Spalte %1 ist</translation>
    </message>
    <message>
        <source>What this column is. Once one is chosen, only chosen columns are read; until then the names of the columns say it.</source>
        <translation>Was diese Spalte ist. Sobald eine gewählt ist, werden nur gewählte Spalten gelesen; bis dahin sagen es die Namen der Spalten.</translation>
    </message>
    <message>
        <source>%1 in column %2</source>
        <translation>%1 in Spalte %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnProposal</name>
    <message>
        <source>Proposed, as you chose it for the last file with these columns: %1.</source>
        <translation>Vorgeschlagen, wie Sie es für die letzte Datei mit diesen Spalten gewählt haben: %1.</translation>
    </message>
    <message>
        <source>Use T&amp;hese</source>
        <translation>&amp;Diese verwenden</translation>
    </message>
    <message>
        <source>Read the columns of this file in the same way</source>
        <translation>Die Spalten dieser Datei ebenso lesen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ComparisonFiguresModel</name>
    <message>
        <source>no tolerance</source>
        <translation>keine Toleranz</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>column and its value</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>figure and its values</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhergesagt</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>What is left at targets that the table was made without: the figure to believe</source>
        <translation>Was an Zielpositionen bleibt, ohne die die Tabelle gemacht wurde: der Wert, dem zu glauben ist</translation>
    </message>
    <message>
        <source>Before, all values</source>
        <translation>Vorher, alle Werte</translation>
    </message>
    <message>
        <source>After, all values</source>
        <translation>Nachher, alle Werte</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CompensationWizard</name>
    <message>
        <source>Axis Compensation Wizard</source>
        <translation>Assistent für Achskompensation</translation>
    </message>
    <message>
        <source>%1 is opened as soon as that is possible. %2</source>
        <translation>%1 wird geöffnet, sobald es möglich ist. %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConditionsModel</name>
    <message>
        <source>Condition of ISO 230-2</source>
        <translation>Bedingung der ISO 230-2</translation>
    </message>
    <message>
        <source>Met?</source>
        <translation>Erfüllt?</translation>
    </message>
    <message>
        <source>%1 (assumption)</source>
        <translation>%1 (Annahme)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConnectionsDialog</name>
    <message>
        <source>Use the drives of the list</source>
        <translation>Die Antriebe der Liste verwenden</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>Die Änderungen verwerfen (Esc)</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Change the address of the chosen connection</source>
        <translation>Adresse der gewählten Verbindung ändern</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen connection</source>
        <translation>Gewählte Verbindung entfernen</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Testen</translation>
    </message>
    <message>
        <source>Ask the drive at the selected address to identify itself</source>
        <translation>Den Antrieb unter der ausgewählten Adresse nach seiner Identität fragen</translation>
    </message>
    <message>
        <source>De&amp;mo Drive</source>
        <translation>De&amp;mo-Antrieb</translation>
    </message>
    <message>
        <source>Add the built-in demo drive to try everything without hardware</source>
        <translation>Den eingebauten Demo-Antrieb hinzufügen, um alles ohne Hardware zu versuchen</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>%1 (demo)</source>
        <translation>%1 (Demo)</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>verbindet …</translation>
    </message>
    <message>
        <source>answers; serial number %1, axes: %2</source>
        <translation>antwortet; Seriennummer %1, Achsen: %2</translation>
    </message>
    <message>
        <source>asking …</source>
        <translation>fragt an …</translation>
    </message>
    <message>
        <source>This address is already in the list.</source>
        <translation>Diese Adresse steht bereits in der Liste.</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>%1 wird gefragt …</translation>
    </message>
    <message>
        <source>Added, but not answering yet: %1</source>
        <translation>Hinzugefügt, aber noch ohne Antwort: %1</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>Hin&amp;zufügen</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>Ä&amp;ndern</translation>
    </message>
    <message>
        <source>Checks the address and adds it to the list</source>
        <translation>Prüft die Adresse und nimmt sie in die Liste auf</translation>
    </message>
    <message>
        <source>Not possible while a drive is being written</source>
        <translation>Nicht möglich, während ein Antrieb geschrieben wird</translation>
    </message>
    <message>
        <source>Drives are reached through their web server, such as http://192.168.1.20, or a serial line, such as serial:/dev/ttyUSB0. A web address may contain a user name and password (http://user:password@host); they are used until the program ends and never stored.</source>
        <translation>Antriebe werden über ihren Webserver erreicht, etwa http://192.168.1.20, oder über eine serielle Leitung, etwa serial:/dev/ttyUSB0. Eine Webadresse kann Benutzernamen und Passwort enthalten (http://benutzer:passwort@host); sie gelten bis zum Ende des Programms und werden nie gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Find …</source>
        <translation>Su&amp;chen …</translation>
    </message>
    <message>
        <source>Search the serial ports of this computer for drives</source>
        <translation>Die seriellen Anschlüsse dieses Rechners nach Antrieben absuchen</translation>
    </message>
    <message>
        <source>The address of a drive&apos;s web server, or a serial port</source>
        <translation>Die Adresse des Webservers eines Antriebs oder ein serieller Anschluss</translation>
    </message>
    <message>
        <source>The certificate of %1 is no longer trusted.</source>
        <translation>Dem Zertifikat von %1 wird nicht mehr vertraut.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ControllerCombo</name>
    <message>
        <source>As applied by %1</source>
        <translation>Wie in %1</translation>
    </message>
    <message>
        <source>The table as the drive applies it, or converted to another controller&apos;s convention: its sign, and its rules beyond the ends</source>
        <translation>Die Tabelle, wie der Antrieb sie anwendet, oder umgerechnet für eine andere Steuerung: mit deren Vorzeichen und deren Regeln jenseits der Enden</translation>
    </message>
    <message>
        <source>Applied by</source>
        <translation>Angewendet von</translation>
    </message>
    <message>
        <source>As on the drive</source>
        <translation>Wie im Antrieb</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Change nothing (Esc)</source>
        <translation>Nichts ändern (Esc)</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>E&amp;rgebnis</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What the conversion does to the numbers, with an example</source>
        <translation>Was die Umrechnung mit den Zahlen macht, mit einem Beispiel</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Wird berechnet …</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionForm</name>
    <message>
        <source>Choose the format.</source>
        <translation>Bitte das Format wählen.</translation>
    </message>
    <message>
        <source>Enter a number for the even grid.</source>
        <translation>Eine Zahl für das gleichmäßige Gitter eingeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number, and no list such as 21; 31.</source>
        <translation>&quot;%1&quot; ist keine Zahl und keine Liste wie 21; 31.</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Sign</source>
        <translation>&amp;Vorzeichen</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Richtung</translation>
    </message>
    <message>
        <source>&amp;Between points</source>
        <translation>&amp;Zwischen den Punkten</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a &amp;linear one</source>
        <translation>Eine Moduloachse als &amp;lineare Achse behandeln</translation>
    </message>
    <message>
        <source>&amp;Hold the end values beyond the data</source>
        <translation>&amp;Endwerte über die Daten hinaus halten</translation>
    </message>
    <message>
        <source>The format that the file is read as</source>
        <translation>Das Format, als das die Datei gelesen wird</translation>
    </message>
    <message>
        <source>The format of the new file</source>
        <translation>Das Format der neuen Datei</translation>
    </message>
    <message>
        <source>Whether the file&apos;s values are added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>Ob die Werte der Datei zur Geberposition (Geberseite) oder zur Sollposition (Sollseite) addiert werden</translation>
    </message>
    <message>
        <source>Whether the new file&apos;s values are to be added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>Ob die Werte der neuen Datei zur Geberposition (Geberseite) oder zur Sollposition (Sollseite) addiert werden sollen</translation>
    </message>
    <message>
        <source>The drive holds one value for both directions of motion; choose which one</source>
        <translation>Der Antrieb hat einen Wert für beide Bewegungsrichtungen; hier wird gewählt, welchen</translation>
    </message>
    <message>
        <source>For an axis that stays within one revolution: the table is used as it is</source>
        <translation>Für eine Achse, die innerhalb einer Umdrehung bleibt: die Tabelle wird unverändert verwendet</translation>
    </message>
    <message>
        <source>Brings the table onto evenly spaced positions</source>
        <translation>Bringt die Tabelle auf Positionen mit gleichmäßigem Abstand</translation>
    </message>
    <message>
        <source>How the values between the positions of the table are made</source>
        <translation>Wie die Werte zwischen den Positionen der Tabelle entstehen</translation>
    </message>
    <message>
        <source>The even grid may end beyond the last position</source>
        <translation>Das gleichmäßige Gitter darf hinter der letzten Position enden</translation>
    </message>
    <message>
        <source>choose the format</source>
        <translation>Format wählen</translation>
    </message>
    <message>
        <source>as the format says</source>
        <translation>wie das Format sagt</translation>
    </message>
    <message>
        <source>as the format says: feedback</source>
        <translation>wie das Format sagt: feedback</translation>
    </message>
    <message>
        <source>as the format says: command</source>
        <translation>wie das Format sagt: command</translation>
    </message>
    <message>
        <source>feedback: added to the encoder position</source>
        <translation>feedback: zur Geberposition addiert</translation>
    </message>
    <message>
        <source>command: added to the commanded position</source>
        <translation>command: zur Sollposition addiert</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>bitte wählen</translation>
    </message>
    <message>
        <source>the mean of both directions</source>
        <translation>der Mittelwert beider Richtungen</translation>
    </message>
    <message>
        <source>the values of the positive direction</source>
        <translation>die Werte der positiven Richtung</translation>
    </message>
    <message>
        <source>the values of the negative direction</source>
        <translation>die Werte der negativen Richtung</translation>
    </message>
    <message>
        <source>the positions of the table</source>
        <translation>die Positionen der Tabelle</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>eine Anzahl Punkte</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>ein Abstand</translation>
    </message>
    <message>
        <source>coarsest within a deviation</source>
        <translation>so grob wie eine Abweichung erlaubt</translation>
    </message>
    <message>
        <source>linear, as controllers do</source>
        <translation>linear, wie Steuerungen es tun</translation>
    </message>
    <message>
        <source>smooth (monotone cubic)</source>
        <translation>glatt (monoton kubisch)</translation>
    </message>
    <message>
        <source>&amp;Number of points</source>
        <translation>Anzahl P&amp;unkte</translation>
    </message>
    <message>
        <source>At least 2; one number for all sources, or one for each: 21; 31</source>
        <translation>Mindestens 2; eine Zahl für alle Quellen oder eine für jede: 21; 31</translation>
    </message>
    <message>
        <source>Dista&amp;nce</source>
        <translation>Abstan&amp;d</translation>
    </message>
    <message>
        <source>In the unit of the positions; one number for all sources, or one for each: 5; 10</source>
        <translation>In der Einheit der Positionen; eine Zahl für alle Quellen oder eine für jede: 5; 10</translation>
    </message>
    <message>
        <source>Deviatio&amp;n</source>
        <translation>Ab&amp;weichung</translation>
    </message>
    <message>
        <source>In the unit of the values; the coarsest grid within it is used</source>
        <translation>In der Einheit der Werte; das gröbste Gitter, das sie einhält, wird verwendet</translation>
    </message>
    <message>
        <source>Target &amp;axis</source>
        <translation>Ziel&amp;achse</translation>
    </message>
    <message>
        <source>The axis that the values correct: one of the sources, or another axis; the sign is converted accordingly</source>
        <translation>Die Achse, die die Werte korrigieren: eine der Quellen oder eine andere Achse; danach wird das Vorzeichen umgerechnet</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie in der Datei angegeben</translation>
    </message>
    <message>
        <source>as the table says</source>
        <translation>wie in der Tabelle angegeben</translation>
    </message>
    <message>
        <source>the first source</source>
        <translation>die erste Quelle</translation>
    </message>
    <message>
        <source>the second source</source>
        <translation>die zweite Quelle</translation>
    </message>
    <message>
        <source>the third source</source>
        <translation>die dritte Quelle</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>eine andere Achse</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tolerance: enter a number above 0, or nothing.</source>
        <translation>„%1“ ist keine Toleranz: Geben Sie eine Zahl über 0 ein, oder nichts.</translation>
    </message>
    <message>
        <source>Missin&amp;g points</source>
        <translation>Fehlende Pun&amp;kte</translation>
    </message>
    <message>
        <source>Snap &amp;tolerance</source>
        <translation>Fang&amp;toleranz</translation>
    </message>
    <message>
        <source>&amp;Even grid</source>
        <translation>Gleichmäßiges &amp;Gitter</translation>
    </message>
    <message>
        <source>What becomes of points of the grid that have no value</source>
        <translation>Was aus Punkten des Gitters wird, die keinen Wert haben</translation>
    </message>
    <message>
        <source>Positions that are this close to an even grid are taken for its positions, in their unit; empty: as they stand in the file</source>
        <translation>Positionen, die so nahe an einem gleichmäßigen Gitter liegen, gelten als dessen Positionen, in ihrer Einheit; leer: wie sie in der Datei stehen</translation>
    </message>
    <message>
        <source>none may be missing</source>
        <translation>keine dürfen fehlen</translation>
    </message>
    <message>
        <source>filled with the nearest measured value</source>
        <translation>mit dem nächsten gemessenen Wert gefüllt</translation>
    </message>
    <message>
        <source>filled from the plane through all points</source>
        <translation>aus der Ebene durch alle Punkte gefüllt</translation>
    </message>
    <message>
        <source>filled smoothly, with the least bending</source>
        <translation>glatt gefüllt, mit der kleinsten Krümmung</translation>
    </message>
    <message>
        <source>left out: the grid is cropped</source>
        <translation>weggelassen: Das Gitter wird zugeschnitten</translation>
    </message>
    <message>
        <source>spline (natural cubic)</source>
        <translation>Spline (natürlich kubisch)</translation>
    </message>
    <message>
        <source>without noise (smoothing spline)</source>
        <translation>ohne Rauschen (Glättungsspline)</translation>
    </message>
    <message>
        <source>choose one; feedback is assumed</source>
        <translation>bitte wählen; angenommen wird Feedback</translation>
    </message>
    <message>
        <source>choose one; command is assumed</source>
        <translation>bitte wählen; angenommen wird Command</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CorrectionsDialog</name>
    <message>
        <source>%1 mm; runs with their air: %2</source>
        <translation>%1 mm; Durchläufe mit ihrer Luft: %2</translation>
    </message>
    <message>
        <source>not corrected for</source>
        <translation>nicht korrigiert</translation>
    </message>
    <message>
        <source>Enter temperatures and coefficients as numbers; only the position that does not move may be left empty.</source>
        <translation>Geben Sie Temperaturen und Koeffizienten als Zahlen ein; nur die Position, die sich nicht bewegt, darf leer bleiben.</translation>
    </message>
    <message>
        <source>The file does not say whether its values are at 20 °C already. Only values that are not may be corrected.</source>
        <translation>Die Datei sagt nicht, ob ihre Werte schon für 20 °C gelten. Nur Werte, die das nicht tun, dürfen korrigiert werden.</translation>
    </message>
    <message>
        <source>Corrections Before Judging</source>
        <translation>Korrekturen vor dem Beurteilen</translation>
    </message>
    <message>
        <source>&amp;Bring the values to 20 °C</source>
        <translation>Werte auf 20 °C &amp;bringen</translation>
    </message>
    <message>
        <source>&amp;Temperature of the scale [°C]</source>
        <translation>&amp;Temperatur des Maßstabs [°C]</translation>
    </message>
    <message>
        <source>&amp;Expansion of the scale [%1]</source>
        <translation>Ausd&amp;ehnung des Maßstabs [%1]</translation>
    </message>
    <message>
        <source>Temperature of the &amp;reference [°C]</source>
        <translation>Temperatur der &amp;Referenz [°C]</translation>
    </message>
    <message>
        <source>E&amp;xpansion of the reference [%1]</source>
        <translation>A&amp;usdehnung der Referenz [%1]</translation>
    </message>
    <message>
        <source>&amp;Position that does not move [mm]</source>
        <translation>&amp;Position, die sich nicht bewegt [mm]</translation>
    </message>
    <message>
        <source>Of the material that the axis is measured by</source>
        <translation>Des Materials, an dem die Achse gemessen wird</translation>
    </message>
    <message>
        <source>Of the same material; steel has about 11.5</source>
        <translation>Desselben Materials; Stahl hat etwa 11,5</translation>
    </message>
    <message>
        <source>Of the measuring instrument</source>
        <translation>Des Messgeräts</translation>
    </message>
    <message>
        <source>0 for a laser that is compensated for its wavelength</source>
        <translation>0 für einen Laser, dessen Wellenlänge kompensiert ist</translation>
    </message>
    <message>
        <source>Empty: the first target</source>
        <translation>Leer: die erste Zielposition</translation>
    </message>
    <message>
        <source>the first target</source>
        <translation>die erste Zielposition</translation>
    </message>
    <message>
        <source>&amp;Steel</source>
        <translation>&amp;Stahl</translation>
    </message>
    <message>
        <source>Enter the coefficient of steel, 11.5 µm/(m·K)</source>
        <translation>Den Koeffizienten von Stahl eintragen, 11,5 µm/(m·K)</translation>
    </message>
    <message>
        <source>The instrument has &amp;not corrected the values itself</source>
        <translation>Das Messgerät hat die Werte &amp;nicht selbst korrigiert</translation>
    </message>
    <message>
        <source>Needed where the file does not say it</source>
        <translation>Nötig, wo die Datei es nicht sagt</translation>
    </message>
    <message>
        <source>Dead path of the interferometer</source>
        <translation>Totstrecke des Interferometers</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Do not correct for the dead path</source>
        <translation>Die Totstrecke nicht korrigieren</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>&amp;Korrigieren</translation>
    </message>
    <message>
        <source>Judge the values with these corrections</source>
        <translation>Die Werte mit diesen Korrekturen beurteilen</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Leave the corrections as they are (Esc)</source>
        <translation>Die Korrekturen lassen, wie sie sind (Esc)</translation>
    </message>
    <message>
        <source>A JSON file with its length and the air of each run</source>
        <translation>Eine JSON-Datei mit ihrer Länge und der Luft jedes Durchlaufs</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DataFileField</name>
    <message>
        <source>No file is open</source>
        <translation>Es ist keine Datei offen</translation>
    </message>
    <message>
        <source>Open a file of compensation data, or drop it on the window (Ctrl+O)</source>
        <translation>Datei mit Kompensationsdaten öffnen oder auf dem Fenster ablegen (Strg+O)</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>keine Datei</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>Geöffnete Datei</translation>
    </message>
    <message>
        <source>The name of the open file of compensation data</source>
        <translation>Name der geöffneten Datei mit Kompensationsdaten</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Datei wird gelesen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Opens a file of compensation data</source>
        <translation>Öffnet eine Datei mit Kompensationsdaten</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>Sto&amp;pp</translation>
    </message>
    <message>
        <source>Stop reading the file</source>
        <translation>Lesen der Datei abbrechen</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt verwendete Dateien</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine zuletzt verwendeten Dateien</translation>
    </message>
    <message>
        <source>&amp;Read Again</source>
        <translation>&amp;Neu einlesen</translation>
    </message>
    <message>
        <source>&amp;Close File</source>
        <translation>Datei &amp;schließen</translation>
    </message>
    <message>
        <source>Import &amp;Options…</source>
        <translation>Import&amp;optionen…</translation>
    </message>
    <message>
        <source>Format, sign and grid of the open file</source>
        <translation>Format, Vorzeichen und Gitter der offenen Datei</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationCanvas</name>
    <message>
        <source>smallest and largest value</source>
        <translation>kleinster und größter Wert</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>zum Ausschließen vorgeschlagen</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationPlot</name>
    <message>
        <source>Deviation over position</source>
        <translation>Abweichung über der Position</translation>
    </message>
    <message>
        <source>A click selects a value; arrow keys go from value to value. The wheel and + and - zoom, dragging moves, Home or a double click shows everything.</source>
        <translation>Ein Klick wählt einen Wert; Pfeiltasten gehen von Wert zu Wert. Das Rad sowie + und - vergrößern und verkleinern, Ziehen verschiebt, Pos1 oder ein Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>Durchlauf %1, %2</translation>
    </message>
    <message>
        <source>target %1 %2, ↑ %3, ↓ %4 %5, B %6 %5</source>
        <translation>Zielposition %1 %2, ↑ %3, ↓ %4 %5, B %6 %5</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftDetails</name>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Im Antrieb</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>In der Maschinendatei</translation>
    </message>
    <message>
        <source>How the axis differs from the machine file</source>
        <translation>Wie die Achse von der Maschinendatei abweicht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis, and how it stands to the machine file</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftModel</name>
    <message>
        <source>Drift of the runs</source>
        <translation>Drift der Durchläufe</translation>
    </message>
    <message>
        <source>Runs ↑</source>
        <translation>Durchläufe ↑</translation>
    </message>
    <message>
        <source>Runs ↓</source>
        <translation>Durchläufe ↓</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>From the first to the last run</source>
        <translation>Vom ersten zum letzten Durchlauf</translation>
    </message>
    <message>
        <source>From run to run</source>
        <translation>Von Durchlauf zu Durchlauf</translation>
    </message>
    <message>
        <source>Per hour</source>
        <translation>Je Stunde</translation>
    </message>
    <message>
        <source>Per kelvin</source>
        <translation>Je Kelvin</translation>
    </message>
    <message>
        <source>s without the offsets of the runs</source>
        <translation>s ohne die Versätze der Durchläufe</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>A without the offsets of the runs</source>
        <translation>A ohne die Versätze der Durchläufe</translation>
    </message>
    <message>
        <source>R without the offsets of the runs</source>
        <translation>R ohne die Versätze der Durchläufe</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>vermutet</translation>
    </message>
    <message>
        <source>not suspected</source>
        <translation>nicht vermutet</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftPlot</name>
    <message>
        <source>%1, run %2: offset %3</source>
        <translation>%1, Durchlauf %2: Versatz %3</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Offset of the run</source>
        <translation>Versatz des Durchlaufs</translation>
    </message>
    <message>
        <source>runs ↑</source>
        <translation>Durchläufe ↑</translation>
    </message>
    <message>
        <source>runs ↓</source>
        <translation>Durchläufe ↓</translation>
    </message>
    <message>
        <source>Drift: offsets of the runs</source>
        <translation>Drift: Versätze der Durchläufe</translation>
    </message>
    <message>
        <source>How far each run lies beside the mean of its direction. A click or the arrow keys select a run.</source>
        <translation>Wie weit jeder Durchlauf neben dem Mittel seiner Richtung liegt. Ein Klick oder die Pfeiltasten wählen einen Durchlauf.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftText</name>
    <message>
        <source>not in the file</source>
        <comment>axis</comment>
        <translation>nicht in der Datei</translation>
    </message>
    <message>
        <source>not among the connections</source>
        <comment>drive</comment>
        <translation>nicht unter den Verbindungen</translation>
    </message>
    <message>
        <source>is being compared …</source>
        <translation>wird verglichen …</translation>
    </message>
    <message>
        <source>not reachable</source>
        <comment>drive</comment>
        <translation>nicht erreichbar</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>nicht vergleichbar</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>%1 (compared at %2)</source>
        <comment>state and time</comment>
        <translation>%1 (verglichen um %2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>table and grid</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>aus</translation>
    </message>
    <message>
        <source>Earlier write</source>
        <translation>Früheres Schreiben</translation>
    </message>
    <message>
        <source>did not end</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>is ended by the next write</source>
        <translation>wird vom nächsten Schreiben beendet</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>%1 (serial number %2)</source>
        <comment>address of a drive</comment>
        <translation>%1 (Seriennummer %2)</translation>
    </message>
    <message>
        <source>%1, axis %2</source>
        <comment>drive and axis</comment>
        <translation>%1, Achse %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <comment>file, line and problem</comment>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>This cannot be written now: %1</source>
        <translation>Das kann jetzt nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveBar</name>
    <message>
        <source>%1 (demo)</source>
        <translation>%1 (Demo)</translation>
    </message>
    <message>
        <source>&amp;Drive</source>
        <translation>Antr&amp;ieb</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>The drive of the chosen axis, and its address</source>
        <translation>Der Antrieb der gewählten Achse und seine Adresse</translation>
    </message>
    <message>
        <source>The drive of the selected axis; lists all drives under Connections</source>
        <translation>Der Antrieb der gewählten Achse; hier stehen alle Antriebe der Verbindungen</translation>
    </message>
    <message>
        <source>Co&amp;nnections…</source>
        <translation>&amp;Verbindungen…</translation>
    </message>
    <message>
        <source>Add, test or remove drives</source>
        <translation>Antriebe hinzufügen, testen oder entfernen</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>Aktualisie&amp;ren</translation>
    </message>
    <message>
        <source>More: language, log, settings</source>
        <translation>Weiteres: Sprache, Logbuch, Einstellungen</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>no drive</source>
        <translation>kein Antrieb</translation>
    </message>
    <message>
        <source>no drive: add one under Connections</source>
        <translation>kein Antrieb: unter Verbindungen einen hinzufügen</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>verbindet …</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>Verbindung verloren, neuer Versuch läuft</translation>
    </message>
    <message>
        <source>Search for axes again and read everything from the drives (F5)</source>
        <translation>Achsen erneut suchen und alles aus den Antrieben lesen (F5)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveList</name>
    <message>
        <source>Connected to %1 (%2).</source>
        <translation>Verbunden mit %1 (%2).</translation>
    </message>
    <message>
        <source>A different drive now answers at %1: %2. Unwritten changes were discarded.</source>
        <translation>Unter %1 antwortet jetzt ein anderer Antrieb: %2. Nicht geschriebene Änderungen wurden verworfen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DropFrame</name>
    <message>
        <source>Drop to open %1</source>
        <translation>Ablegen öffnet %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExaggerationCombo</name>
    <message>
        <source>Exaggeration</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>passend</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportConfigurationDialog</name>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>In TAM-Konfiguration exportieren</translation>
    </message>
    <message>
        <source>Puts the table and source parameters of %1 into %2. Everything else in the file stays as it is; nothing on the drive changes.</source>
        <translation>Übernimmt die Parameter von %1 für Tabellen und Quellen in %2. Alles andere in der Datei bleibt, wie es ist; am Antrieb ändert sich nichts.</translation>
    </message>
    <message>
        <source>What the drive has</source>
        <translation>Was der Antrieb hat</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Tabellenplatz</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>&amp;Speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>Nichts ändern und zurückgehen (Esc)</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>Der Antrieb wird gelesen …</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Wird verglichen …</translation>
    </message>
    <message>
        <source>The configuration has all of this already.</source>
        <translation>Die Konfiguration hat das alles bereits.</translation>
    </message>
    <message>
        <source>Choose where to save the configuration</source>
        <translation>Wählen, wo die Konfiguration gespeichert wird</translation>
    </message>
    <message>
        <source>In the file, only Table and Dim1Source to Dim3Source of these axes will change.</source>
        <translation>In der Datei ändern sich nur Table und Dim1Source bis Dim3Source dieser Achsen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportDialog</name>
    <message>
        <source>Export for Another Controller</source>
        <translation>Für eine andere Steuerung exportieren</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file for another controller. Nothing on the drive changes.</source>
        <translation>Schreibt die Tabelle &quot;%1&quot; in eine Datei für eine andere Steuerung. Am Antrieb ändert sich nichts.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Choose where to save the file</source>
        <translation>Den Speicherort der Datei wählen</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file of the drive or of another controller. Nothing on the drive changes.</source>
        <translation>Schreibt die Tabelle „%1“ in eine Datei des Antriebs oder einer anderen Steuerung. Auf dem Antrieb ändert sich nichts.</translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation>S&amp;peichern …</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FieldRow</name>
    <message>
        <source>Revert %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>changed, on the drive: %1</source>
        <translation>geändert, im Antrieb: %1</translation>
    </message>
    <message>
        <source>on the drive: %1</source>
        <translation>im Antrieb: %1</translation>
    </message>
    <message>
        <source>Revert to the drive&apos;s value: %1</source>
        <translation>Auf den Wert des Antriebs zurücksetzen: %1</translation>
    </message>
    <message>
        <source>&amp;Revert to the drive&apos;s value</source>
        <translation>Auf den Wert des Antriebs &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>as last read</source>
        <translation>wie zuletzt gelesen</translation>
    </message>
    <message>
        <source>proposed: %1</source>
        <translation>Vorschlag: %1</translation>
    </message>
    <message>
        <source>Use</source>
        <comment>what is proposed</comment>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Use what is proposed: %1</source>
        <translation>Den Vorschlag übernehmen: %1</translation>
    </message>
    <message>
        <source>Use what is proposed for %1</source>
        <translation>Den Vorschlag für %1 übernehmen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FiguresModel</name>
    <message>
        <source>Figure</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Without excluded</source>
        <translation>Ohne Ausgeschlossene</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>At target</source>
        <translation>An Zielposition</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>uncertainty not stated</source>
        <translation>Messunsicherheit nicht angegeben</translation>
    </message>
    <message>
        <source> and </source>
        <comment>two positions</comment>
        <translation> und </translation>
    </message>
    <message>
        <source>U largest</source>
        <translation>U größtes</translation>
    </message>
    <message>
        <source>U mean</source>
        <translation>U mittleres</translation>
    </message>
    <message>
        <source>Ps largest</source>
        <translation>Ps größtes</translation>
    </message>
    <message>
        <source>Ps mean</source>
        <translation>Ps mittleres</translation>
    </message>
    <message>
        <source>VDI/DGQ 3441 (assumption)</source>
        <translation>VDI/DGQ 3441 (Annahme)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileActions</name>
    <message>
        <source>Open Compensation Data</source>
        <translation>Kompensationsdaten öffnen</translation>
    </message>
    <message>
        <source>Save Example File</source>
        <translation>Beispieldatei speichern</translation>
    </message>
    <message>
        <source>Calibration files (*.csv)</source>
        <translation>Kalibrierdateien (*.csv)</translation>
    </message>
    <message>
        <source>Save Log</source>
        <translation>Logbuch speichern</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>Textdateien (*.txt)</translation>
    </message>
    <message>
        <source>Export for Another Controller</source>
        <translation>Für eine andere Steuerung exportieren</translation>
    </message>
    <message>
        <source>Import TAM Configuration</source>
        <translation>TAM-Konfiguration importieren</translation>
    </message>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>In TAM-Konfiguration exportieren</translation>
    </message>
    <message>
        <source>TAM configurations (*.TAMcfg)</source>
        <translation>TAM-Konfigurationen (*.TAMcfg)</translation>
    </message>
    <message>
        <source>Save TAM Configuration</source>
        <translation>TAM-Konfiguration speichern</translation>
    </message>
    <message>
        <source>Back Up Whole Drive</source>
        <translation>Ganzen Antrieb sichern</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>Sicherungen (*.json)</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>Ganzen Antrieb wiederherstellen</translation>
    </message>
    <message>
        <source>Add Measurement</source>
        <translation>Messung hinzufügen</translation>
    </message>
    <message>
        <source>Save as Runs</source>
        <translation>Als Durchläufe speichern</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>Durchläufe (*.csv)</translation>
    </message>
    <message>
        <source>Dead Path</source>
        <translation>Totstrecke</translation>
    </message>
    <message>
        <source>Dead path (*.json)</source>
        <translation>Totstrecke (*.json)</translation>
    </message>
    <message>
        <source>Table That Was Active</source>
        <translation>Tabelle, die aktiv war</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Tabelle speichern</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileChoices</name>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>nach ihrem Inhalt</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Werte</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie die Datei sagt</translation>
    </message>
    <message>
        <source>deviations from the target</source>
        <translation>Abweichungen von der Zielposition</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>Positionen der Referenz</translation>
    </message>
    <message>
        <source>&amp;Unit of targets</source>
        <translation>Einheit der &amp;Zielpositionen</translation>
    </message>
    <message>
        <source>Unit &amp;of values</source>
        <translation>Einhei&amp;t der Werte</translation>
    </message>
    <message>
        <source>Lines &amp;before the header</source>
        <translation>Zeilen vor der &amp;Kopfzeile</translation>
    </message>
    <message>
        <source>D&amp;irections by the order of targets</source>
        <translation>Richtungen aus der Reihenf&amp;olge</translation>
    </message>
    <message>
        <source>The reference counts the other &amp;way</source>
        <translation>Die Referenz zählt &amp;andersherum</translation>
    </message>
    <message>
        <source>The format of the file</source>
        <translation>Das Format der Datei</translation>
    </message>
    <message>
        <source>A deviation is the reference position minus the target</source>
        <translation>Eine Abweichung ist die Position der Referenz minus Zielposition</translation>
    </message>
    <message>
        <source>For a file that does not name it</source>
        <translation>Für eine Datei, die sie nicht nennt</translation>
    </message>
    <message>
        <source>Lines of a CSV file that come before the names of its columns</source>
        <translation>Zeilen einer CSV-Datei, die vor den Namen der Spalten stehen</translation>
    </message>
    <message>
        <source>For a file without directions: a run is up while its targets rise</source>
        <translation>Für eine Datei ohne Richtungen: aufwärts, solange die Zielpositionen steigen</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>Für ein Messgerät, das abwärts zählt, während die Achse aufwärts fährt</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileFacts</name>
    <message>
        <source>off: the drive added nothing</source>
        <translation>aus: Der Antrieb hat nichts addiert</translation>
    </message>
    <message>
        <source>on, with table %1</source>
        <translation>ein, mit Tabelle %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>the file does not say it</source>
        <translation>die Datei sagt es nicht</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 %4</source>
        <translation>%1 von %2 bis %3 %4</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Statement of the file</source>
        <translation>Angabe der Datei</translation>
    </message>
    <message>
        <source>What the file says</source>
        <translation>Was die Datei sagt</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Gelesen als</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Zielpositionen</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Messgerät</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Verweilzeit</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Expansion</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Corrected to 20 °C</source>
        <translation>Auf 20 °C korrigiert</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesModel</name>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesView</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1, line %2, column %3</source>
        <translation>%1, Zeile %2, Spalte %3</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>Datei wird gelesen…</translation>
    </message>
    <message>
        <source>These lines can no longer be read from the file.</source>
        <translation>Diese Zeilen können nicht mehr aus der Datei gelesen werden.</translation>
    </message>
    <message>
        <source>Lines %1 to %2</source>
        <translation>Zeilen %1 bis %2</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Voriger Fehler</translation>
    </message>
    <message>
        <source>Show the lines at the previous problem</source>
        <translation>Zeilen beim vorigen Fehler zeigen</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Nächster Fehler</translation>
    </message>
    <message>
        <source>Show the lines at the next problem</source>
        <translation>Zeilen beim nächsten Fehler zeigen</translation>
    </message>
    <message>
        <source>Table&apos;s values</source>
        <translation>Werte der Tabelle</translation>
    </message>
    <message>
        <source>Show the values of the selected table again</source>
        <translation>Wieder die Werte der gewählten Tabelle zeigen</translation>
    </message>
    <message>
        <source>Earlier lines</source>
        <translation>Frühere Zeilen</translation>
    </message>
    <message>
        <source>Show the lines before these</source>
        <translation>Die Zeilen davor zeigen</translation>
    </message>
    <message>
        <source>Later lines</source>
        <translation>Spätere Zeilen</translation>
    </message>
    <message>
        <source>Show the lines after these</source>
        <translation>Die Zeilen danach zeigen</translation>
    </message>
    <message>
        <source>The file&apos;s lines at the chosen problem</source>
        <translation>Zeilen der Datei beim gewählten Fehler</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileViews</name>
    <message>
        <source>What the file says</source>
        <translation>Was die Datei sagt</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Views of the file</source>
        <translation>Ansichten der Datei</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Probleme (%1)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FindDrivesDialog</name>
    <message>
        <source>Find Drives</source>
        <translation>Antriebe suchen</translation>
    </message>
    <message>
        <source>Asks every serial port of this computer for a drive; nothing else is sent. A port that is not listed can be entered as an address, such as serial:/dev/ttyUSB0?baud=921600.</source>
        <translation>Fragt jeden seriellen Anschluss dieses Rechners nach einem Antrieb; sonst wird nichts gesendet. Ein nicht aufgeführter Anschluss kann als Adresse eingegeben werden, etwa serial:/dev/ttyUSB0?baud=921600.</translation>
    </message>
    <message>
        <source>Try all common &amp;baud rates at every port</source>
        <translation>Alle üblichen &amp;Baudraten an jedem Anschluss versuchen</translation>
    </message>
    <message>
        <source>Takes a few seconds for each port without an answer</source>
        <translation>Dauert je Anschluss ohne Antwort einige Sekunden</translation>
    </message>
    <message>
        <source>&amp;Search Again</source>
        <translation>Noch einmal &amp;suchen</translation>
    </message>
    <message>
        <source>Search all ports again</source>
        <translation>Alle Anschlüsse erneut absuchen</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Suche läuft …</translation>
    </message>
    <message>
        <source>%1, serial number %2, axes: %3</source>
        <translation>%1, Seriennummer %2, Achsen: %3</translation>
    </message>
    <message>
        <source>All serial ports of this computer are already in the list.</source>
        <translation>Alle seriellen Anschlüsse dieses Rechners stehen bereits in der Liste.</translation>
    </message>
    <message>
        <source>Ports searched: %1; drives found: %2</source>
        <translation>Abgesuchte Anschlüsse: %1; gefundene Antriebe: %2</translation>
    </message>
    <message>
        <source>&amp;Add to the Connections</source>
        <translation>Zu den &amp;Verbindungen hinzufügen</translation>
    </message>
    <message>
        <source>No drive is chosen</source>
        <translation>Kein Antrieb ist gewählt</translation>
    </message>
    <message>
        <source>A network is asked only when you confirm its addresses: each of them gets one request.</source>
        <translation>Ein Netz wird nur gefragt, wenn Sie die Adressen bestätigen: jede davon erhält eine Anfrage.</translation>
    </message>
    <message>
        <source>&amp;Network:</source>
        <translation>&amp;Netz:</translation>
    </message>
    <message>
        <source>Addresses of a network</source>
        <translation>Adressen eines Netzes</translation>
    </message>
    <message>
        <source>Such as 192.168.1.0/24, 192.168.1.10-40 or one address, with :8080 behind it for another port than 80</source>
        <translation>Etwa 192.168.1.0/24, 192.168.1.10-40 oder eine Adresse, mit :8080 dahinter für einen anderen Port als 80</translation>
    </message>
    <message>
        <source>192.168.1.0/24</source>
        <comment>example of a range</comment>
        <translation>192.168.1.0/24</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Ask no more; what was found stays</source>
        <translation>Nicht weiter fragen; das Gefundene bleibt</translation>
    </message>
    <message>
        <source>Asked %1 of %2 addresses; drives found: %3</source>
        <translation>%1 von %2 Adressen gefragt; Antriebe gefunden: %3</translation>
    </message>
    <message>
        <source>Stopped. Addresses asked: %1; drives found: %2</source>
        <translation>Angehalten. Adressen gefragt: %1; Antriebe gefunden: %2</translation>
    </message>
    <message>
        <source>Addresses asked: %1; drives found: %2</source>
        <translation>Adressen gefragt: %1; Antriebe gefunden: %2</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses (%1)</source>
        <translation>A&amp;dressen fragen (%1)</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses</source>
        <translation>A&amp;dressen fragen</translation>
    </message>
    <message>
        <source>Each address gets one request over http, for the list of its files; what answers as a drive does is asked who it is</source>
        <translation>Jede Adresse erhält eine Anfrage über http, nach der Liste ihrer Dateien; was wie ein Antrieb antwortet, wird gefragt, wer es ist</translation>
    </message>
    <message>
        <source>Enter the addresses first</source>
        <translation>Erst die Adressen eingeben</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitForm</name>
    <message>
        <source>%1: a number is needed. %2</source>
        <translation>%1: eine Zahl fehlt. %2</translation>
    </message>
    <message>
        <source>The current axis has no source.</source>
        <translation>Die aktuelle Achse hat keine Quelle.</translation>
    </message>
    <message>
        <source>%1 of the current axis is no known position.</source>
        <translation>%1 der aktuellen Achse ist keine bekannte Position.</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position before the compensation.</source>
        <translation>%1 der aktuellen Achse ist eine Position vor der Kompensation.</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position after the compensation.</source>
        <translation>%1 der aktuellen Achse ist eine Position nach der Kompensation.</translation>
    </message>
    <message>
        <source>The raw positions are on file: it does not matter what was active.</source>
        <translation>Die Rohpositionen stehen in der Datei: was aktiv war, ist gleichgültig.</translation>
    </message>
    <message>
        <source>Measured with the compensation off, as the file says.</source>
        <translation>Mit Kompensation aus gemessen, wie die Datei sagt.</translation>
    </message>
    <message>
        <source>Measured with the table %1 active, as the file says.</source>
        <translation>Mit der Tabelle %1 aktiv gemessen, wie die Datei sagt.</translation>
    </message>
    <message>
        <source>Measured with the compensation on, as the file says.</source>
        <translation>Mit Kompensation an gemessen, wie die Datei sagt.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Lookup at</source>
        <translation>Nachschlagen bei</translation>
    </message>
    <message>
        <source>Where the drive looks its table up; it decides where the values belong</source>
        <translation>Wo der Antrieb in seiner Tabelle nachschlägt; das entscheidet, wohin die Werte gehören</translation>
    </message>
    <message>
        <source>as the source of the axis says</source>
        <translation>wie die Quelle der Achse sagt</translation>
    </message>
    <message>
        <source>encoder, uncompensated</source>
        <translation>Geber, unkompensiert</translation>
    </message>
    <message>
        <source>set position, compensated</source>
        <translation>Sollposition, kompensiert</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>Gemessen mit</translation>
    </message>
    <message>
        <source>What was active while it was measured, since the file does not say it</source>
        <translation>Was während der Messung aktiv war, da die Datei es nicht sagt</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht gesagt</translation>
    </message>
    <message>
        <source>compensation off</source>
        <translation>Kompensation aus</translation>
    </message>
    <message>
        <source>the table that is merged onto</source>
        <translation>der Tabelle, in die eingerechnet wird</translation>
    </message>
    <message>
        <source>the table of a file…</source>
        <translation>der Tabelle einer Datei …</translation>
    </message>
    <message>
        <source>Merge onto</source>
        <translation>Einrechnen in</translation>
    </message>
    <message>
        <source>The table to which residuals are added, that was active while they were measured</source>
        <translation>Die Tabelle, zu der Restabweichungen addiert werden und die bei ihrer Messung aktiv war</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>the table of the axis</source>
        <translation>der Tabelle der Achse</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Factor for the residuals: 1, or below it, such as 0.7, where the machine responds sluggishly; at most 2</source>
        <translation>Faktor für die Restabweichungen: 1, oder darunter, etwa 0,7, bei träger Maschine; höchstens 2</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>The curve through or near the means</source>
        <translation>Die Kurve durch die Mittelwerte oder nahe an ihnen</translation>
    </message>
    <message>
        <source>linear: straight lines</source>
        <translation>linear: gerade Linien</translation>
    </message>
    <message>
        <source>cubic: without overshoot</source>
        <translation>cubic: ohne Überschwingen</translation>
    </message>
    <message>
        <source>spline: natural cubic</source>
        <translation>spline: natürlich kubisch</translation>
    </message>
    <message>
        <source>smooth: near the values</source>
        <translation>smooth: nahe an den Werten</translation>
    </message>
    <message>
        <source>harmonic: of a turn</source>
        <translation>harmonic: einer Umdrehung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Which runs the table is made of</source>
        <translation>Aus welchen Durchläufen die Tabelle gemacht wird</translation>
    </message>
    <message>
        <source>mean of up and down</source>
        <translation>Mittel aus aufwärts und abwärts</translation>
    </message>
    <message>
        <source>up only</source>
        <translation>nur aufwärts</translation>
    </message>
    <message>
        <source>down only</source>
        <translation>nur abwärts</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Glätte</translation>
    </message>
    <message>
        <source>A number from 0 on; by cross-validation when the field is empty</source>
        <translation>Eine Zahl ab 0; durch Kreuzvalidierung, wenn das Feld leer ist</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>Known periods above 0, such as the lead of the screw: 10; 2.5</source>
        <translation>Bekannte Perioden über 0, etwa die Steigung der Spindel: 10; 2,5</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmonische</translation>
    </message>
    <message>
        <source>Of each period, or of the turn; 1 is the fundamental alone</source>
        <translation>Anzahl je Periode oder Umdrehung; 1 ist die Grundwelle allein</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Umdrehung</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>Länge einer Umdrehung einer Moduloachse, etwa 360: die Tabelle endet, wie sie beginnt</translation>
    </message>
    <message>
        <source>no modulo axis</source>
        <translation>keine Moduloachse</translation>
    </message>
    <message>
        <source>Grid of the table</source>
        <translation>Gitter der Tabelle</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>Stützstellen</translation>
    </message>
    <message>
        <source>Positions of the table, always evenly spaced</source>
        <translation>Positionen der Tabelle, immer in gleichen Abständen</translation>
    </message>
    <message>
        <source>those measured, where even</source>
        <translation>die gemessenen, wo gleichmäßig</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>so viele</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>in einem Abstand</translation>
    </message>
    <message>
        <source>the fewest points for a deviation</source>
        <translation>so wenige, wie eine Abweichung erlaubt</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Whole numbers from 2 on: one for all axes, or 41; 31</source>
        <translation>Ganze Zahlen ab 2: eine für alle Achsen, oder 41; 31</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions: one for all axes, or 10; 5</source>
        <translation>Über 0, in der Einheit der Positionen: einer für alle Achsen, oder 10; 5</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions</source>
        <translation>Über 0, in der Einheit der Positionen</translation>
    </message>
    <message>
        <source>Hold ends beyond the targets</source>
        <translation>Endwerte jenseits der Zielpositionen halten</translation>
    </message>
    <message>
        <source>The grid may go beyond the targets, where the end values are held</source>
        <translation>Das Gitter darf über die Zielpositionen hinausgehen, wo die Endwerte gehalten werden</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>Nullstelle, Steigung und Drift</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullstelle</translation>
    </message>
    <message>
        <source>Where the table is 0: the zero of the instrument is arbitrary</source>
        <translation>Wo die Tabelle 0 ist: die Null des Messgeräts ist willkürlich</translation>
    </message>
    <message>
        <source>home, else first target</source>
        <translation>Referenzpunkt, sonst erste Zielposition</translation>
    </message>
    <message>
        <source>at the home position</source>
        <translation>am Referenzpunkt</translation>
    </message>
    <message>
        <source>at the first target</source>
        <translation>an der ersten Zielposition</translation>
    </message>
    <message>
        <source>mean of the values</source>
        <translation>Mittel der Werte</translation>
    </message>
    <message>
        <source>at a position</source>
        <translation>an einer Position</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>wie gemessen</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>The position of the zero, one number for each axis</source>
        <translation>Die Position der Nullstelle, eine Zahl für jede Achse</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Referenzpunkt</translation>
    </message>
    <message>
        <source>The home position of the axis</source>
        <translation>Der Referenzpunkt der Achse</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>It is taken out of straightness alone: scale error is real</source>
        <translation>Sie wird nur aus Geradheit herausgenommen: ein Maßstabsfehler ist echt</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>taken out by least squares</source>
        <translation>herausgenommen, kleinste Quadrate</translation>
    </message>
    <message>
        <source>taken out by the ends</source>
        <translation>herausgenommen, durch die Enden</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>What is taken out of runs that lie beside each other before the table is made</source>
        <translation>Was aus nebeneinander liegenden Durchläufen herausgerechnet wird, bevor die Tabelle entsteht</translation>
    </message>
    <message>
        <source>offset of each run taken out</source>
        <translation>Versatz jedes Durchlaufs herausgenommen</translation>
    </message>
    <message>
        <source>trend taken out</source>
        <translation>Trend herausgenommen</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>alignment, lines along %1 level</source>
        <translation>Lage, Geraden entlang %1 ohne Steigung</translation>
    </message>
    <message>
        <source>alignment and scale</source>
        <translation>Lage und Maßstab</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>How the artefact lay is no error of the machine</source>
        <translation>Wie der Prüfkörper lag, ist kein Fehler der Maschine</translation>
    </message>
    <message>
        <source>Far points</source>
        <translation>Ferne Punkte</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one</source>
        <translation>Stützstellen, die weit von jedem gemessenen Punkt entfernt sind</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>filled smoothly</source>
        <translation>glatt gefüllt</translation>
    </message>
    <message>
        <source>filled with the nearest</source>
        <translation>mit dem nächsten gefüllt</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robust</translation>
    </message>
    <message>
        <source>Values that do not fit the others count less</source>
        <translation>Werte, die nicht zu den anderen passen, zählen weniger</translation>
    </message>
    <message>
        <source>The axis has another table since that was said: say it anew.</source>
        <translation>Die Achse hat seit dieser Angabe eine andere Tabelle: bitte neu angeben.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitOutcome</name>
    <message>
        <source>fit of %1</source>
        <translation>Anpassung von %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPage</name>
    <message>
        <source>Merge onto</source>
        <translation>Einrechnen in</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>Gemessen mit</translation>
    </message>
    <message>
        <source>An earlier table; a new one is being made …</source>
        <translation>Eine frühere Tabelle; eine neue wird gemacht …</translation>
    </message>
    <message>
        <source>The table is being made …</source>
        <translation>Die Tabelle wird gemacht …</translation>
    </message>
    <message>
        <source>Table and measurement</source>
        <translation>Tabelle und Messung</translation>
    </message>
    <message>
        <source>No table</source>
        <translation>Keine Tabelle</translation>
    </message>
    <message>
        <source>There is no table yet</source>
        <translation>Es gibt noch keine Tabelle</translation>
    </message>
    <message>
        <source>Take the table over to Write, as if it had been read from a file</source>
        <translation>Die Tabelle nach Schreiben übernehmen, als wäre sie aus einer Datei gelesen</translation>
    </message>
    <message>
        <source>As a file of the drive or of another controller</source>
        <translation>Als Datei des Antriebs oder einer anderen Steuerung</translation>
    </message>
    <message>
        <source>Add the files of a measurement on Measure; here a table is made of it.</source>
        <translation>Fügen Sie unter Messen die Dateien einer Messung hinzu; hier wird eine Tabelle daraus.</translation>
    </message>
    <message>
        <source>The files on Measure cannot be used.</source>
        <translation>Die Dateien unter Messen lassen sich nicht verwenden.</translation>
    </message>
    <message>
        <source>Choose where the drive looks its table up: it decides where the values belong.</source>
        <translation>Wählen Sie, wo der Antrieb in seiner Tabelle nachschlägt: das entscheidet, wohin die Werte gehören.</translation>
    </message>
    <message>
        <source>Read the warnings; then the table can be used: it is taken over to Write.</source>
        <translation>Lesen Sie die Warnungen; dann lässt sich die Tabelle verwenden: sie wird nach Schreiben übernommen.</translation>
    </message>
    <message>
        <source>The table can be used: it is taken over to Write, where nothing is written before you say so.</source>
        <translation>Die Tabelle lässt sich verwenden: sie wird nach Schreiben übernommen, wo nichts geschrieben wird, bevor Sie es sagen.</translation>
    </message>
    <message>
        <source>Use as Table</source>
        <translation>Als Tabelle verwenden</translation>
    </message>
    <message>
        <source>Save Table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Which column of the points is shown and used</source>
        <translation>Welche Spalte der Punkte gezeigt und verwendet wird</translation>
    </message>
    <message>
        <source>The table corrects axis %1, and the current axis is %2: it is refused there. Choose the axis that was measured.</source>
        <translation>Die Tabelle korrigiert Achse %1, und die aktuelle Achse ist %2: dort wird sie abgelehnt. Wählen Sie die Achse, die gemessen wurde.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPlot</name>
    <message>
        <source>compensation [%1]</source>
        <translation>Kompensation [%1]</translation>
    </message>
    <message>
        <source>remains [%1]</source>
        <translation>bleibt [%1]</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>measured, with its standard error</source>
        <translation>gemessen, mit Standardfehler</translation>
    </message>
    <message>
        <source>foretold without the target</source>
        <translation>ohne die Zielposition vorhergesagt</translation>
    </message>
    <message>
        <source>Picture of the fit</source>
        <translation>Bild der Anpassung</translation>
    </message>
    <message>
        <source>The table over what was measured, and what remains. Left and right go from point to point; the wheel and + and - zoom, Home shows all.</source>
        <translation>Die Tabelle über dem, was gemessen wurde, und was bleibt. Links und rechts gehen von Punkt zu Punkt; Rad und + und - zoomen, Pos1 zeigt alles.</translation>
    </message>
    <message>
        <source>%1: measured %2 ± %3, %4 remains</source>
        <translation>%1: gemessen %2 ± %3, es bleibt %4</translation>
    </message>
    <message>
        <source>%1: measured %2, %3 remains</source>
        <translation>%1: gemessen %2, es bleibt %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitResults</name>
    <message>
        <source>Largest correction: %1 at %2.</source>
        <translation>Größte Korrektur: %1 bei %2.</translation>
    </message>
    <message>
        <source>What remains, rms</source>
        <translation>Was bleibt, Effektivwert</translation>
    </message>
    <message>
        <source>What remains, largest</source>
        <translation>Was bleibt, höchstens</translation>
    </message>
    <message>
        <source>Figure [%1]</source>
        <translation>Kennwert [%1]</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>At the targets</source>
        <translation>An den Zielen</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>%1: foretold %2, tolerance %3: %4.</source>
        <translation>%1: vorhergesagt %2, Toleranz %3: %4.</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>Table %1: %2; CRC %3.</source>
        <translation>Tabelle %1: %2; CRC %3.</translation>
    </message>
    <message>
        <source>Looked up at the encoder&apos;s position, before the compensation.</source>
        <translation>Nachgeschlagen bei der Geberposition, vor der Kompensation.</translation>
    </message>
    <message>
        <source>Looked up at the set position, after the compensation.</source>
        <translation>Nachgeschlagen bei der Sollposition, nach der Kompensation.</translation>
    </message>
    <message>
        <source>Smoothness %1.</source>
        <translation>Glätte %1.</translation>
    </message>
    <message>
        <source>Points of the grid that were filled: %1 of %2.</source>
        <translation>Gefüllte Stützstellen: %1 von %2.</translation>
    </message>
    <message>
        <source>Held out: each target foretold without it, which is the one to believe between the targets.</source>
        <translation>Ausgelassen: jede Zielposition ohne sie selbst vorhergesagt; dem ist zwischen den Zielpositionen zu glauben.</translation>
    </message>
    <message>
        <source>Figures before and foretold</source>
        <translation>Kennwerte vorher und vorhergesagt</translation>
    </message>
    <message>
        <source>Before the table is used</source>
        <translation>Bevor die Tabelle verwendet wird</translation>
    </message>
    <message>
        <source>%1, held out %2</source>
        <translation>%1, ausgelassen %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ForeignChange</name>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive: the compensation is off. Home the axis and activate again.</source>
        <translation>Die Achse hat ihre Referenz verloren, wie nach einem Neustart des Antriebs: Die Kompensation ist aus. Referenzieren Sie die Achse und aktivieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive.</source>
        <translation>Die Achse hat ihre Referenz verloren, wie nach einem Neustart des Antriebs.</translation>
    </message>
    <message>
        <source>The compensation is off: something other than this window has switched it off.</source>
        <translation>Die Kompensation ist aus: Nicht dieses Fenster hat sie ausgeschaltet.</translation>
    </message>
    <message>
        <source>The compensation is on: something other than this window has switched it on.</source>
        <translation>Die Kompensation ist ein: Nicht dieses Fenster hat sie eingeschaltet.</translation>
    </message>
    <message>
        <source>The axis has no table any more.</source>
        <translation>Die Achse hat keine Tabelle mehr.</translation>
    </message>
    <message>
        <source>dimensionality</source>
        <translation>Dimensionalität</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>Quelle %1</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>persistency</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>Its volatile table is gone: write it again, as a persistent one if it has to outlast a restart.</source>
        <translation>Ihre flüchtige Tabelle ist weg: Schreiben Sie sie noch einmal, und zwar dauerhaft, wenn sie einen Neustart überstehen soll.</translation>
    </message>
    <message>
        <source>The settings of this axis on the drive have changed, and not by this window: %1.</source>
        <translation>Die Einstellungen dieser Achse auf dem Antrieb haben sich geändert, und zwar nicht durch dieses Fenster: %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>Benutzerhandbuch</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Benutzerhandbuch</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportConfigurationDialog</name>
    <message>
        <source>Import TAM Configuration</source>
        <translation>TAM-Konfiguration importieren</translation>
    </message>
    <message>
        <source>Writes the table and source parameters in %1 to the axes of %2, one after the other. The tables themselves must be on the drive. Each write makes a backup and is verified; no compensation is switched on.</source>
        <translation>Schreibt die Parameter für Tabellen und Quellen aus %1 nacheinander auf die Achsen von %2. Die Tabellen selbst müssen im Antrieb sein. Jeder Schreibvorgang legt eine Sicherung an und wird verifiziert; keine Kompensation wird eingeschaltet.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportDialog</name>
    <message>
        <source>Import Compensation Data</source>
        <translation>Kompensationsdaten importieren</translation>
    </message>
    <message>
        <source>Choose how to read %1. The result is the table that the drive adds to the encoder position, on an even grid.</source>
        <translation>Wie soll %1 gelesen werden? Das Ergebnis ist die Tabelle, die der Antrieb zur Geberposition addiert, auf einem gleichmäßigen Gitter.</translation>
    </message>
    <message>
        <source>I&amp;mport</source>
        <translation>I&amp;mportieren</translation>
    </message>
    <message>
        <source>Use the file with these choices; nothing is written to the drive yet</source>
        <translation>Die Datei mit diesen Angaben verwenden; in den Antrieb wird noch nichts geschrieben</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>Zeile %1: </translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgePage</name>
    <message>
        <source>Tolerances, and the uncertainty U (k = 2)</source>
        <translation>Toleranzen und die Messunsicherheit U (k = 2)</translation>
    </message>
    <message>
        <source>All &amp;values</source>
        <translation>Alle &amp;Werte</translation>
    </message>
    <message>
        <source>Show plot and targets as if nothing were excluded</source>
        <translation>Bild und Zielpositionen zeigen, als wäre nichts ausgeschlossen</translation>
    </message>
    <message>
        <source>&amp;Corrections…</source>
        <translation>&amp;Korrekturen…</translation>
    </message>
    <message>
        <source>Bring the values to 20 °C, or correct them for the dead path of an interferometer</source>
        <translation>Die Werte auf 20 °C bringen oder die Totstrecke eines Interferometers korrigieren</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Zielpositionen</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Drift in numbers</source>
        <translation>Drift in Zahlen</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Warnings (%1)</source>
        <translation>Warnungen (%1)</translation>
    </message>
    <message>
        <source>No corrections.</source>
        <translation>Keine Korrekturen.</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014</source>
        <translation>Kennwerte nach ISO 230-2:2014</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgeWarningsModel</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LimitFields</name>
    <message>
        <source>The largest value that is allowed, such as 10 µm; empty: no tolerance</source>
        <translation>Der größte erlaubte Wert, etwa 10 µm; leer: keine Toleranz</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2, such as 2.1 µm; empty: not stated</source>
        <translation>Messunsicherheit mit k = 2, etwa 2,1 µm; leer: nicht angegeben</translation>
    </message>
    <message>
        <source>Tolerance: %1</source>
        <translation>Toleranz: %1</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>Messunsicherheit U, k = 2</translation>
    </message>
    <message>
        <source>&amp;Accuracy A</source>
        <translation>Gen&amp;auigkeit A</translation>
    </message>
    <message>
        <source>Systematic &amp;E</source>
        <translation>Systematisch &amp;E</translation>
    </message>
    <message>
        <source>Range of means &amp;M</source>
        <translation>Spanne der Mittel &amp;M</translation>
    </message>
    <message>
        <source>Reversal &amp;B</source>
        <translation>Umkehrspanne &amp;B</translation>
    </message>
    <message>
        <source>Repeatab&amp;ility R</source>
        <translation>Wiederhol&amp;präzision R</translation>
    </message>
    <message>
        <source>&amp;Uncertainty U</source>
        <translation>Un&amp;sicherheit U</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LogView</name>
    <message>
        <source>Log</source>
        <translation>Logbuch</translation>
    </message>
    <message>
        <source>Copy the selected lines, or all of them</source>
        <translation>Gewählte Zeilen oder alle kopieren</translation>
    </message>
    <message>
        <source>Save the log to a file</source>
        <translation>Logbuch in eine Datei speichern</translation>
    </message>
    <message>
        <source>Hide the log</source>
        <translation>Logbuch ausblenden</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineActions</name>
    <message>
        <source>Open Machine File</source>
        <translation>Maschinendatei öffnen</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>Maschinendateien (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineApplication</name>
    <message>
        <source>All drives already had what %1 says; nothing was written.</source>
        <translation>Alle Antriebe hatten schon, was in %1 steht; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>%1 is applied.</source>
        <translation>%1 ist angewendet.</translation>
    </message>
    <message>
        <source>%1 is not applied as a whole: %2</source>
        <translation>%1 ist nicht ganz angewendet: %2</translation>
    </message>
    <message>
        <source>Failed: %1.</source>
        <translation>Fehlgeschlagen: %1.</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>Geschrieben und verifiziert: %1.</translation>
    </message>
    <message>
        <source>Not written: %1.</source>
        <translation>Nicht geschrieben: %1.</translation>
    </message>
    <message>
        <source>Applying it again does the rest.</source>
        <translation>Erneutes Anwenden erledigt den Rest.</translation>
    </message>
    <message>
        <source>%1: %2; it holds: %3.</source>
        <comment>axis, what became of it, and its table</comment>
        <translation>%1: %2; sie enthält: %3.</translation>
    </message>
    <message>
        <source>%1: %2; what it holds is not known.</source>
        <comment>axis, and what became of it</comment>
        <translation>%1: %2; was sie enthält, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Begin: applying the machine file %1.</source>
        <translation>Beginn: Anwenden der Maschinendatei %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Switched: %1.</source>
        <translation>Geschaltet: %1.</translation>
    </message>
    <message>
        <source>Not switched: %1.</source>
        <translation>Nicht geschaltet: %1.</translation>
    </message>
    <message>
        <source>Not proved: %1.</source>
        <translation>Nicht nachgewiesen: %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineController</name>
    <message>
        <source>No machine file is open.</source>
        <translation>Keine Maschinendatei ist geöffnet.</translation>
    </message>
    <message>
        <source>The machine file is being read.</source>
        <translation>Die Maschinendatei wird gelesen.</translation>
    </message>
    <message>
        <source>The machine file is being applied.</source>
        <translation>Die Maschinendatei wird angewendet.</translation>
    </message>
    <message>
        <source>Wait for the end of the current operation.</source>
        <translation>Warten Sie das Ende des laufenden Vorgangs ab.</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>Die Antriebe werden verglichen.</translation>
    </message>
    <message>
        <source>Not all drives of the file are among the connections.</source>
        <translation>Nicht alle Antriebe der Datei sind unter den Verbindungen.</translation>
    </message>
    <message>
        <source>Nothing is written while something stands in the way of a part of it.</source>
        <translation>Nichts wird geschrieben, solange einem Teil davon etwas im Weg steht.</translation>
    </message>
    <message>
        <source>All drives have what the file says.</source>
        <translation>Alle Antriebe haben, was in der Datei steht.</translation>
    </message>
    <message>
        <source>No drive of the file answers.</source>
        <translation>Kein Antrieb der Datei antwortet.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachinePane</name>
    <message>
        <source>&amp;Plan Again</source>
        <translation>Neu &amp;planen</translation>
    </message>
    <message>
        <source>Reads the machine file and its tables again and compares all drives with them</source>
        <translation>Liest die Maschinendatei und ihre Tabellen neu und vergleicht alle Antriebe damit</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>&amp;Anwenden…</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>Zeigen, was in alle Antriebe geschrieben würde, bevor etwas geschrieben wird</translation>
    </message>
    <message>
        <source>Close Machine &amp;File</source>
        <translation>Maschinendatei sch&amp;ließen</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>Die Antriebe bleiben verbunden; nichts wird geändert</translation>
    </message>
    <message>
        <source>Problems of the machine file</source>
        <translation>Probleme der Maschinendatei</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>as the file says: %1</source>
        <comment>number of axes</comment>
        <translation>wie in der Datei: %1</translation>
    </message>
    <message>
        <source>differ: %1</source>
        <comment>number of axes</comment>
        <translation>abweichend: %1</translation>
    </message>
    <message>
        <source>cannot be compared: %1</source>
        <comment>number of axes</comment>
        <translation>nicht vergleichbar: %1</translation>
    </message>
    <message>
        <source>not reachable: %1</source>
        <comment>number of axes</comment>
        <translation>nicht erreichbar: %1</translation>
    </message>
    <message>
        <source>not among the connections: %1</source>
        <comment>number of axes</comment>
        <translation>nicht unter den Verbindungen: %1</translation>
    </message>
    <message>
        <source>not compared yet: %1</source>
        <comment>number of axes</comment>
        <translation>noch nicht verglichen: %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>file and machine</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: axes %2.</source>
        <comment>machine file and numbers of axes</comment>
        <translation>%1: Achsen %2.</translation>
    </message>
    <message>
        <source>Compared at %1.</source>
        <translation>Verglichen um %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and what is wrong</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>Dieser Antrieb ist nicht mehr unter den Verbindungen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurePage</name>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>&amp;Save as Runs…</source>
        <translation>Als Durchläufe &amp;speichern…</translation>
    </message>
    <message>
        <source>All files as one CSV file, with what is excluded marked in it</source>
        <translation>Alle Dateien als eine CSV-Datei, in der Ausgeschlossenes gekennzeichnet ist</translation>
    </message>
    <message>
        <source>Files of the measurement</source>
        <translation>Dateien der Messung</translation>
    </message>
    <message>
        <source>Values of all files</source>
        <translation>Werte aller Dateien</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>Die Dateien werden gelesen …</translation>
    </message>
    <message>
        <source>Take the values of a plan while something else moves the axis</source>
        <translation>Die Werte eines Messplans nehmen, während etwas anderes die Achse bewegt</translation>
    </message>
    <message>
        <source>New &amp;Program…</source>
        <translation>Neues &amp;Programm…</translation>
    </message>
    <message>
        <source>Plan the targets of a measurement, and a program for the control of the machine</source>
        <translation>Die Zielpositionen einer Messung planen, und ein Programm für die Steuerung der Maschine</translation>
    </message>
    <message>
        <source>Cap&amp;ture…</source>
        <translation>&amp;Messwerte erfassen…</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Erfassung</translation>
    </message>
    <message>
        <source>Add the files of a measurement, take its values with Capture, or go on to Write with a table that is there.</source>
        <translation>Dateien einer Messung hinzufügen, ihre Werte mit Messwerte erfassen nehmen, oder mit einer vorhandenen Tabelle zu Schreiben weitergehen.</translation>
    </message>
    <message>
        <source>Saved as %1. Judge says what it is worth, and Fit makes a table of it.</source>
        <translation>Als %1 gespeichert. „Beurteilen“ sagt, was sie taugt, und „Anpassen“ macht eine Tabelle daraus.</translation>
    </message>
    <message>
        <source>Without targets there are no figures of ISO 230-2; Fit makes a table of it.</source>
        <translation>Ohne Zielpositionen gibt es keine Kennwerte nach ISO 230-2; Anpassen macht eine Tabelle daraus.</translation>
    </message>
    <message>
        <source>The measurement can be used. Go on to Judge and Fit.</source>
        <translation>Die Messung ist brauchbar. Weiter geht es mit „Beurteilen“ und „Anpassen“.</translation>
    </message>
    <message>
        <source>%1 was captured for the record that was open before, and is not added to this one.</source>
        <translation>%1 wurde für das vorher geöffnete Protokoll erfasst und wird diesem nicht hinzugefügt.</translation>
    </message>
    <message>
        <source>Saved as %1 with the values of the files: the corrections are not in it.</source>
        <translation>Als %1 mit den Werten der Dateien gespeichert: die Korrekturen sind nicht darin.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFiles</name>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Add files of a measurement; they can also be dropped here (Ctrl+O)</source>
        <translation>Dateien einer Messung hinzufügen; sie lassen sich auch hierher ziehen (Strg+O)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the selected file out of the measurement (Del)</source>
        <translation>Die gewählte Datei aus der Messung nehmen (Entf)</translation>
    </message>
    <message>
        <source>E&amp;xchange up and down in all files</source>
        <translation>A&amp;ufwärts und abwärts in allen Dateien tauschen</translation>
    </message>
    <message>
        <source>For files that name the directions the other way round</source>
        <translation>Für Dateien, die die Richtungen umgekehrt benennen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFilesModel</name>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>ein</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>nicht verwendbar</translation>
    </message>
    <message>
        <source>warnings: %1</source>
        <translation>Warnungen: %1</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>samples: %1</source>
        <translation>Abtastungen: %1</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>Punkte: %1</translation>
    </message>
    <message>
        <source>means</source>
        <translation>Mittelwerte</translation>
    </message>
    <message>
        <source>%1 up, %2 down</source>
        <translation>%1 aufwärts, %2 abwärts</translation>
    </message>
    <message>
        <source>being read …</source>
        <translation>wird gelesen …</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>%1, as the record holds it</source>
        <translation>%1, wie im Protokoll enthalten</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasuringActions</name>
    <message>
        <source>Values are being captured: stop that first</source>
        <translation>Es werden Messwerte erfasst: das zuerst beenden</translation>
    </message>
    <message>
        <source>Choose a drive and an axis first</source>
        <translation>Zuerst einen Antrieb und eine Achse wählen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessagePresenter</name>
    <message>
        <source>This is the built-in demo drive. Try everything; no real drive is affected.</source>
        <translation>Das ist der eingebaute Demo-Antrieb. Alles kann versucht werden; kein echter Antrieb ist betroffen.</translation>
    </message>
    <message>
        <source>Wor&amp;k with Real Drives…</source>
        <translation>Mit e&amp;chten Antrieben arbeiten…</translation>
    </message>
    <message>
        <source>%1 Your changes are kept; reconnecting …</source>
        <translation>%1 Die Änderungen bleiben erhalten; die Verbindung wird erneut versucht …</translation>
    </message>
    <message>
        <source>%1 Reconnecting …</source>
        <translation>%1 Die Verbindung wird erneut versucht …</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>%1 hat sich auf dem Datenträger geändert.</translation>
    </message>
    <message>
        <source>Read A&amp;gain</source>
        <translation>Neu &amp;einlesen</translation>
    </message>
    <message>
        <source>&amp;Finish Write</source>
        <translation>Vo&amp;llenden</translation>
    </message>
    <message>
        <source>Undo Wri&amp;te</source>
        <translation>Rückgä&amp;ngig machen</translation>
    </message>
    <message>
        <source>&amp;Keep for Later</source>
        <translation>S&amp;päter</translation>
    </message>
    <message>
        <source>S&amp;how Certificate…</source>
        <translation>Zertifikat &amp;zeigen…</translation>
    </message>
    <message>
        <source>%1 is being asked …</source>
        <translation>%1 wird gefragt …</translation>
    </message>
    <message>
        <source>%1 has no axis with compensation registers.</source>
        <translation>%1 hat keine Achse mit Kompensationsregistern.</translation>
    </message>
    <message>
        <source>%1 does not answer. %2</source>
        <comment>drive, reason</comment>
        <translation>%1 antwortet nicht. %2</translation>
    </message>
    <message>
        <source>Tr&amp;y Again</source>
        <translation>Erneut &amp;versuchen</translation>
    </message>
    <message>
        <source>%1 answers now.</source>
        <translation>%1 antwortet jetzt.</translation>
    </message>
    <message>
        <source>Displa&amp;y Drive</source>
        <translation>Diesen Antrieb &amp;verwenden</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessageStack</name>
    <message>
        <source>Close this message</source>
        <translation>Meldung schließen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisController</name>
    <message>
        <source>The writes have not been planned yet.</source>
        <translation>Die Schreibvorgänge sind noch nicht geplant.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisDialog</name>
    <message>
        <source>Write Several Axes</source>
        <translation>Mehrere Achsen schreiben</translation>
    </message>
    <message>
        <source>Writes columns of %1 to axes of %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified.</source>
        <translation>Schreibt Spalten von %1 nacheinander auf Achsen von %2. Alle Schreibvorgänge werden geprüft, bevor der erste beginnt; jeder legt eine Sicherung an und wird verifiziert.</translation>
    </message>
    <message>
        <source>&amp;Sources</source>
        <translation>&amp;Quellen</translation>
    </message>
    <message>
        <source>Each axis keeps its sources</source>
        <translation>Jede Achse behält ihre Quellen</translation>
    </message>
    <message>
        <source>The registers that supply the positions for the tables</source>
        <translation>Die Register, deren Werte die Stellen in den Tabellen bestimmen</translation>
    </message>
    <message>
        <source>The same for all, as on the page: %1</source>
        <translation>Für alle dieselben wie auf der Seite: %1</translation>
    </message>
    <message>
        <source>Persistent, as on the page: all tables are stored in flash.</source>
        <translation>Dauerhaft wie auf der Seite: alle Tabellen werden im Flash-Speicher abgelegt.</translation>
    </message>
    <message>
        <source>Volatile, as on the page: a reboot of the drive restores the stored state.</source>
        <translation>Flüchtig wie auf der Seite: ein Neustart des Antriebs stellt den gespeicherten Zustand wieder her.</translation>
    </message>
    <message>
        <source>Each axis its own position</source>
        <translation>Jede Achse ihre eigene Position</translation>
    </message>
    <message>
        <source>No register is known for the position of %1: select other sources.</source>
        <translation>Für die Position von %1 ist kein Register bekannt: Wählen Sie andere Quellen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisOutcome</name>
    <message>
        <source>The writes were stopped.</source>
        <translation>Die Schreibvorgänge wurden angehalten.</translation>
    </message>
    <message>
        <source>The writes were stopped at %1.</source>
        <translation>Die Schreibvorgänge wurden bei %1 angehalten.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and sentence</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No axis was changed.</source>
        <translation>Keine Achse wurde geändert.</translation>
    </message>
    <message>
        <source>New state: %1.</source>
        <translation>Neuer Zustand: %1.</translation>
    </message>
    <message>
        <source>Old state, complete: %1.</source>
        <translation>Alter Zustand, vollständig: %1.</translation>
    </message>
    <message>
        <source>%1 The tables that no axis uses are not all restored: %2</source>
        <translation>%1 Die Tabellen, die keine Achse verwendet, sind nicht alle wiederhergestellt: %2</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>Geschrieben und verifiziert: %1.</translation>
    </message>
    <message>
        <source>This is stored in flash.</source>
        <translation>Das ist im Flash-Speicher abgelegt.</translation>
    </message>
    <message>
        <source>This is volatile: a reboot of the drive restores the stored state.</source>
        <translation>Das ist flüchtig: ein Neustart des Antriebs stellt den gespeicherten Zustand wieder her.</translation>
    </message>
    <message>
        <source>Stored in flash: %1.</source>
        <translation>Im Flash-Speicher abgelegt: %1.</translation>
    </message>
    <message>
        <source>Volatile: %1; a reboot of the drive restores the stored state.</source>
        <translation>Flüchtig: %1; ein Neustart des Antriebs stellt den gespeicherten Zustand wieder her.</translation>
    </message>
    <message>
        <source>The axes already had all of this.</source>
        <translation>Die Achsen hatten das alles bereits.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisPlanView</name>
    <message>
        <source>persistent</source>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>%1D in %2, %3</source>
        <translation>%1D in %2, %3</translation>
    </message>
    <message>
        <source>nothing: the drive already has all of this</source>
        <translation>nichts: der Antrieb hat das alles bereits</translation>
    </message>
    <message>
        <source>%1 (empty)</source>
        <translation>%1 (leer)</translation>
    </message>
    <message>
        <source>%1 (held an earlier table of this axis)</source>
        <translation>%1 (enthielt eine frühere Tabelle dieser Achse)</translation>
    </message>
    <message>
        <source>%1 (will be overwritten)</source>
        <translation>%1 (wird überschrieben)</translation>
    </message>
    <message>
        <source>Dim%1: %2</source>
        <translation>Dim%1: %2</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Im Antrieb</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Tabellenplatz</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>Braucht keinen Flash-Vorgang.</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>Flash-Vorgänge insgesamt: %1.</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>Flash-Vorgänge: %1 verbraucht, gleich danach noch %2 übrig.</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>Diese großen Korrekturen sind &amp;richtig: ihre Einheit wurde geprüft</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberEdit</name>
    <message>
        <source>%1: &quot;%2&quot; cannot be taken. %3</source>
        <translation>%1: „%2“ geht nicht. %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OperationRunner</name>
    <message>
        <source>Begin: %1, %2.</source>
        <comment>task and drive</comment>
        <translation>Beginn: %1, %2.</translation>
    </message>
    <message>
        <source>Begin: %1 %2.</source>
        <translation>Beginn: %1 %2.</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>task, axis and step</comment>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: stopping</source>
        <translation>%1: wird gestoppt</translation>
    </message>
    <message>
        <source>The fields were changed while the write was planned: write again.</source>
        <translation>Während der Planung wurden Felder geändert: neu schreiben.</translation>
    </message>
    <message>
        <source>The drive or the fields have changed since the write was planned: write again.</source>
        <translation>Antrieb oder Felder haben sich seit der Planung geändert: neu schreiben.</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>Vom Benutzer abgebrochen.</translation>
    </message>
    <message>
        <source>Wrote %1: axes: %2, tables: %3.</source>
        <translation>%1 ist geschrieben: Achsen: %2, Tabellen: %3.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::Outcome</name>
    <message>
        <source>The drive holds the complete old state.</source>
        <translation>Der Antrieb hat vollständig den alten Zustand.</translation>
    </message>
    <message>
        <source>It is stored in flash.</source>
        <translation>Die Tabelle ist im Flash-Speicher abgelegt.</translation>
    </message>
    <message>
        <source>It is volatile: a reboot of the drive restores the stored state.</source>
        <translation>Die Tabelle ist flüchtig: ein Neustart des Antriebs stellt den gespeicherten Zustand wieder her.</translation>
    </message>
    <message>
        <source>Written and verified: the drive holds the new state. %1</source>
        <translation>Geschrieben und verifiziert: der Antrieb hat den neuen Zustand. %1</translation>
    </message>
    <message>
        <source>Nothing to write: the drive already has all of this.</source>
        <translation>Nichts zu schreiben: der Antrieb hat das alles bereits.</translation>
    </message>
    <message>
        <source>The write was stopped.</source>
        <translation>Das Schreiben wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The compensation is off.</source>
        <translation>Die Kompensation ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>Die Kompensation ist aktiv.</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>Die Kompensation wird nur ausgewertet: der Antrieb addiert nichts.</translation>
    </message>
    <message>
        <source>The proof was stopped.</source>
        <translation>Der Nachweis wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 But the proof failed: deactivate it unless you know why. %2</source>
        <translation>%1 Aber der Nachweis ist gescheitert: deaktivieren, wenn der Grund nicht bekannt ist. %2</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state from before the write of %1.</source>
        <translation>Wiederhergestellt: der Antrieb hat den Zustand vor dem Schreiben vom %1.</translation>
    </message>
    <message>
        <source>The drive holds the complete new state; nothing more to do.</source>
        <translation>Der Antrieb hat den vollständigen neuen Zustand; es ist nichts weiter zu tun.</translation>
    </message>
    <message>
        <source>The write of %1 was interrupted (last step: %2). %3</source>
        <translation>Der Schreibvorgang vom %1 wurde unterbrochen (letzter Schritt: %2). %3</translation>
    </message>
    <message>
        <source>%1 The write is still unfinished.</source>
        <translation>%1 Der Schreibvorgang ist weiterhin unterbrochen.</translation>
    </message>
    <message>
        <source>Finished and verified: the drive holds the complete new state.</source>
        <translation>Vollendet und verifiziert: der Antrieb hat den vollständigen neuen Zustand.</translation>
    </message>
    <message>
        <source>Undone and verified: the drive holds the complete old state.</source>
        <translation>Rückgängig gemacht und verifiziert: der Antrieb hat den vollständigen alten Zustand.</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved.</source>
        <translation>Der Antrieb hat den vollständigen neuen Zustand, seine Parameter sind vielleicht nicht gespeichert.</translation>
    </message>
    <message>
        <source>The drive holds neither the old nor the new state: finish or undo the write before activating the axis.</source>
        <translation>Der Antrieb hat weder den alten noch den neuen Zustand: den Schreibvorgang vollenden oder rückgängig machen, bevor die Achse aktiviert wird.</translation>
    </message>
    <message>
        <source>Not proved.</source>
        <translation>Nicht nachgewiesen.</translation>
    </message>
    <message>
        <source>The proof failed, and the drive evaluates again as before. %1</source>
        <translation>Der Nachweis ist gescheitert; der Antrieb wertet wieder aus wie zuvor. %1</translation>
    </message>
    <message>
        <source>The proof failed, and the compensation was switched off again. %1</source>
        <translation>Der Nachweis ist gescheitert; die Kompensation wurde wieder ausgeschaltet. %1</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Deleted and verified: %1 is empty, and the axis uses no table.</source>
        <translation>Gelöscht und geprüft: %1 ist leer, und die Achse verwendet keine Tabelle.</translation>
    </message>
    <message>
        <source>Proved over %1 of the table: largest difference %2.</source>
        <translation>Nachgewiesen über %1 der Tabelle: größte Abweichung %2.</translation>
    </message>
    <message>
        <source>Its table indices are right.</source>
        <translation>Die Tabellenindizes stimmen.</translation>
    </message>
    <message>
        <source>The compensation is active, but the drive contradicts its table. Stop the axis and deactivate. %1</source>
        <translation>Die Kompensation ist aktiv, aber der Antrieb widerspricht seiner Tabelle. Halten Sie die Achse an und deaktivieren Sie. %1</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1, made of the drive with the serial number %2.</source>
        <translation>Wiederhergestellt: der Antrieb hat den Zustand in der Sicherungsdatei vom %1; sie ist von dem Antrieb mit der Seriennummer %2.</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1.</source>
        <translation>Wiederhergestellt: der Antrieb hat den Zustand in der Sicherungsdatei vom %1.</translation>
    </message>
    <message>
        <source>The compensation may be on, and is not proved. Connect again to see what it does.</source>
        <translation>Die Kompensation ist möglicherweise eingeschaltet und nicht nachgewiesen. Neu verbinden, um zu sehen, was sie tut.</translation>
    </message>
    <message>
        <source>Which state the drive holds is not known, since the backup of the old one cannot be read: write again or restore another backup before activating the axis.</source>
        <translation>Welchen Zustand der Antrieb hat, ist nicht bekannt, denn die Sicherung des alten ist nicht lesbar: neu schreiben oder eine andere Sicherung wiederherstellen, bevor die Achse aktiviert wird.</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved, and the backup of the old state cannot be read: write again to save them, or restore another backup.</source>
        <translation>Der Antrieb hat den vollständigen neuen Zustand, seine Parameter sind vielleicht nicht gespeichert, und die Sicherung des alten Zustands ist nicht lesbar: erneut schreiben, damit sie gespeichert werden, oder eine andere Sicherung wiederherstellen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutlierList</name>
    <message>
        <source>&amp;Outliers by</source>
        <translation>A&amp;usreißer nach</translation>
    </message>
    <message>
        <source>pooled MAD, limit 4</source>
        <translation>MAD aller Werte, Grenze 4</translation>
    </message>
    <message>
        <source>Grubbs, 5 %</source>
        <translation>Grubbs, 5 %</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>keiner Regel</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>Regel für Ausreißer</translation>
    </message>
    <message>
        <source>How values that do not fit the others are found; a proposal, nothing is left out by it</source>
        <translation>Wie Werte gefunden werden, die nicht zu den anderen passen; ein Vorschlag, nichts wird dadurch weggelassen</translation>
    </message>
    <message>
        <source>Proposed for exclusion, and excluded</source>
        <translation>Zum Ausschließen vorgeschlagen, und ausgeschlossen</translation>
    </message>
    <message>
        <source>Exclude All &amp;Proposed</source>
        <translation>Alle Vor&amp;geschlagenen ausschließen</translation>
    </message>
    <message>
        <source>Leave out every value that the rule proposes</source>
        <translation>Jeden Wert weglassen, den die Regel vorschlägt</translation>
    </message>
    <message>
        <source>E&amp;xclude</source>
        <translation>Ausschließe&amp;n</translation>
    </message>
    <message>
        <source>Leave out the value, run or target that is selected in list, plot or table (Del)</source>
        <translation>Den Wert, den Durchlauf oder die Zielposition weglassen, die in Liste, Bild oder Tabelle ausgewählt ist (Entf)</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>Wie&amp;der verwenden</translation>
    </message>
    <message>
        <source>Use what is selected again</source>
        <translation>Was ausgewählt ist, wieder verwenden</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutliersModel</name>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewDialog</name>
    <message>
        <source>Overview of All Axes</source>
        <translation>Übersicht aller Achsen</translation>
    </message>
    <message>
        <source>All axes of all drives</source>
        <translation>Alle Achsen aller Antriebe</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all of them, with the headings for a spreadsheet</source>
        <translation>Die gewählten Zeilen, oder alle, mit den Überschriften für eine Tabellenkalkulation kopieren</translation>
    </message>
    <message>
        <source>&amp;Go to Axis</source>
        <translation>Zur &amp;Achse</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the overview</source>
        <translation>Die Übersicht schließen</translation>
    </message>
    <message>
        <source>No axis is chosen.</source>
        <translation>Es ist keine Achse gewählt.</translation>
    </message>
    <message>
        <source>This drive has not said yet which axes it has.</source>
        <translation>Dieser Antrieb hat noch nicht gesagt, welche Achsen er hat.</translation>
    </message>
    <message>
        <source>Wait for the current operation before choosing another axis.</source>
        <translation>Erst nach dem Ende des laufenden Vorgangs kann eine andere Achse gewählt werden.</translation>
    </message>
    <message>
        <source>Show this axis on the page</source>
        <translation>Diese Achse auf der Seite zeigen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewModel</name>
    <message>
        <source>since %1</source>
        <comment>date and time</comment>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and column</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>not limited</source>
        <comment>flash operations</comment>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>widerspricht der Tabelle</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>Flash left</source>
        <translation>Flash übrig</translation>
    </message>
    <message>
        <source>Last proof</source>
        <translation>Letzter Nachweis</translation>
    </message>
    <message>
        <source>Last write</source>
        <translation>Zuletzt geschrieben</translation>
    </message>
    <message>
        <source>The drive, and where it is</source>
        <translation>Der Antrieb, und wo er ist</translation>
    </message>
    <message>
        <source>The axis of this drive</source>
        <translation>Die Achse dieses Antriebs</translation>
    </message>
    <message>
        <source>What the compensation does now</source>
        <translation>Was die Kompensation jetzt tut</translation>
    </message>
    <message>
        <source>The table that the axis uses: its file and column where this window has written it, otherwise its place on the drive; and the checksum of its values</source>
        <translation>Die Tabelle, die die Achse verwendet: Datei und Spalte, wenn dieses Fenster sie geschrieben hat, sonst ihr Platz auf dem Antrieb; und die Prüfsumme ihrer Werte</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>Ob die Tabelle einen Neustart übersteht</translation>
    </message>
    <message>
        <source>How many flash operations the drive can do now</source>
        <translation>Wie viele Flash-Vorgänge der Antrieb jetzt ausführen kann</translation>
    </message>
    <message>
        <source>Over which part of the table this window has seen that the drive does what the table says, and when</source>
        <translation>Über welchen Teil der Tabelle dieses Fenster gesehen hat, dass der Antrieb tut, was die Tabelle sagt, und wann</translation>
    </message>
    <message>
        <source>When this computer last wrote to the axis</source>
        <translation>Wann dieser Rechner zuletzt auf die Achse geschrieben hat</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>verbindet …</translation>
    </message>
    <message>
        <source>no axes</source>
        <translation>keine Achsen</translation>
    </message>
    <message>
        <source>no compensation</source>
        <translation>keine Kompensation</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>is being read …</source>
        <translation>wird gelesen …</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <comment>address of a drive</comment>
        <translation>%1, Seriennummer %2</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>The accuracy of the axis with this table and before, as the records of this computer have it</source>
        <translation>Die Genauigkeit der Achse mit dieser Tabelle und davor, wie die Protokolle dieses Rechners sie haben</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>Maschinendatei</translation>
    </message>
    <message>
        <source>Whether the axis has what the machine file says, and when it was compared</source>
        <translation>Ob die Achse hat, was in der Maschinendatei steht, und wann das verglichen wurde</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;System Language</source>
        <translation>&amp;Systemsprache</translation>
    </message>
    <message>
        <source>Show &amp;Preview Before Volatile Writes</source>
        <translation>&amp;Vorschau vor flüchtigem Schreiben zeigen</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview</source>
        <translation>Vor dauerhaftem Schreiben erscheint die Vorschau immer</translation>
    </message>
    <message>
        <source>Save Lo&amp;g…</source>
        <translation>Lo&amp;gbuch speichern…</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>Ü&amp;ber</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>&lt;b&gt;Axis Compensation Wizard&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Assistent für Achskompensation&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>Writes error compensation tables to servo drives, activates them and proves that the drive applies them.

A compensation value is reference minus encoder; the drive adds it to the encoder position.

Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Schreibt Tabellen zur Fehlerkompensation in Servoantriebe, aktiviert sie und weist nach, dass der Antrieb sie anwendet.

Ein Kompensationswert ist Referenz minus Geber; der Antrieb addiert ihn zur Geberposition.

Freie Software unter der GNU General Public License, Version 3 oder später.</translation>
    </message>
    <message>
        <source>Save the selected table as a file for another controller</source>
        <translation>Die gewählte Tabelle als Datei für eine andere Steuerung speichern</translation>
    </message>
    <message>
        <source>No table is selected.</source>
        <translation>Es ist keine Tabelle gewählt.</translation>
    </message>
    <message>
        <source>&amp;Export for Another Controller…</source>
        <translation>Für eine andere Steuerung &amp;exportieren…</translation>
    </message>
    <message>
        <source>&amp;Write Several Axes…</source>
        <translation>&amp;Mehrere Achsen schreiben…</translation>
    </message>
    <message>
        <source>&amp;Import TAM Configuration…</source>
        <translation>TAM-Konfiguration &amp;importieren…</translation>
    </message>
    <message>
        <source>Export to &amp;TAM Configuration…</source>
        <translation>In &amp;TAM-Konfiguration exportieren…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Takes the last change of the fields back; the drive is not reached</source>
        <translation>Nimmt die letzte Änderung der Felder zurück; der Antrieb wird nicht erreicht</translation>
    </message>
    <message>
        <source>Makes the change that was undone again</source>
        <translation>Macht die zurückgenommene Änderung noch einmal</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>User &amp;Guide</source>
        <translation>Benutzer&amp;handbuch</translation>
    </message>
    <message>
        <source>Ba&amp;ck Up Whole Drive…</source>
        <translation>Ganzen Antrieb si&amp;chern…</translation>
    </message>
    <message>
        <source>Restore Whole &amp;Drive…</source>
        <translation>Ganzen &amp;Antrieb wiederherstellen…</translation>
    </message>
    <message>
        <source>&amp;Overview of All Axes…</source>
        <translation>Ü&amp;bersicht aller Achsen…</translation>
    </message>
    <message>
        <source>State and table of each axis of all connected drives</source>
        <translation>Zustand und Tabelle jeder Achse aller verbundenen Antriebe</translation>
    </message>
    <message>
        <source>No machine file is open.</source>
        <translation>Keine Maschinendatei ist geöffnet.</translation>
    </message>
    <message>
        <source>Read the machine file again and compare all drives with it</source>
        <translation>Die Maschinendatei neu lesen und alle Antriebe damit vergleichen</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>Die Antriebe werden verglichen.</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>Zeigen, was in alle Antriebe geschrieben würde, bevor etwas geschrieben wird</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>Die Antriebe bleiben verbunden; nichts wird geändert</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Maschine</translation>
    </message>
    <message>
        <source>&amp;Open Machine File…</source>
        <translation>Maschinendatei &amp;öffnen…</translation>
    </message>
    <message>
        <source>Compare all drives of a machine with the file that says which tables they have</source>
        <translation>Alle Antriebe einer Maschine mit der Datei vergleichen, die sagt, welche Tabellen sie haben</translation>
    </message>
    <message>
        <source>&amp;Plan Again</source>
        <translation>Neu &amp;planen</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>&amp;Anwenden…</translation>
    </message>
    <message>
        <source>&amp;Save Machine File…</source>
        <translation>Maschinendatei &amp;speichern…</translation>
    </message>
    <message>
        <source>Running drives as a machine file with all tables, in a folder of your choice</source>
        <translation>Laufende Antriebe als Maschinendatei mit allen Tabellen, in einem Ordner Ihrer Wahl</translation>
    </message>
    <message>
        <source>&amp;Close Machine File</source>
        <translation>Maschinendatei s&amp;chließen</translation>
    </message>
    <message>
        <source>Documentation in the &amp;Browser</source>
        <translation>Dokumentation im &amp;Browser</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Dokumentation</translation>
    </message>
    <message>
        <source>No browser could be opened. The documentation is in %1.</source>
        <translation>Es konnte kein Browser geöffnet werden. Die Dokumentation liegt in %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageTabs</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>The files of a measurement, and how they are read</source>
        <translation>Die Dateien einer Messung, und wie sie gelesen werden</translation>
    </message>
    <message>
        <source>Bring a table to the drive, and activate it</source>
        <translation>Eine Tabelle zum Antrieb bringen und aktivieren</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Parts of the work</source>
        <translation>Teile der Arbeit</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Page Up and Ctrl+Page Down change the tab)</source>
        <translation>%1 (Strg+Bild auf und Strg+Bild ab wechseln den Reiter)</translation>
    </message>
    <message>
        <source>Judge</source>
        <translation>Beurteilen</translation>
    </message>
    <message>
        <source>What the measurement says of the axis, against tolerances</source>
        <translation>Was die Messung über die Achse sagt, gegen Toleranzen</translation>
    </message>
    <message>
        <source>Prove</source>
        <translation>Nachweisen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Measure again with the table active, and see what it has brought</source>
        <translation>Mit aktiver Tabelle noch einmal messen und sehen, was sie gebracht hat</translation>
    </message>
    <message>
        <source>The table that is made of a measurement, and what it promises</source>
        <translation>Die Tabelle, die aus einer Messung gemacht wird, und was sie verspricht</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ParameterExport</name>
    <message>
        <source>Wrote %1: only compensation registers have changed.</source>
        <translation>%1 geschrieben: nur Register der Kompensation haben sich geändert.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanDialog</name>
    <message>
        <source>New Program</source>
        <translation>Neues Programm</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Mean spacing</source>
        <translation>Mittlerer Abstand</translation>
    </message>
    <message>
        <source>Cont&amp;rol</source>
        <translation>S&amp;teuerung</translation>
    </message>
    <message>
        <source>The control of the machine, which plays the program</source>
        <translation>Die Steuerung der Maschine, die das Programm abspielt</translation>
    </message>
    <message>
        <source>Save Pro&amp;gram…</source>
        <translation>Pro&amp;gramm speichern…</translation>
    </message>
    <message>
        <source>Save &amp;Plan…</source>
        <translation>&amp;Plan speichern…</translation>
    </message>
    <message>
        <source>Clo&amp;se</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>What was not saved is lost (Esc)</source>
        <translation>Was nicht gespeichert wurde, ist verloren (Esc)</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Zielpositionen</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;chse</translation>
    </message>
    <message>
        <source>As the drive or the control names it</source>
        <translation>Wie der Antrieb oder die Steuerung sie nennt</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>E&amp;inheit</translation>
    </message>
    <message>
        <source>Of all positions of the plan</source>
        <translation>Aller Positionen des Messplans</translation>
    </message>
    <message>
        <source>&amp;First target</source>
        <translation>&amp;Erste Zielposition</translation>
    </message>
    <message>
        <source>Measured in every run</source>
        <translation>In jedem Durchlauf gemessen</translation>
    </message>
    <message>
        <source>&amp;Last target</source>
        <translation>&amp;Letzte Zielposition</translation>
    </message>
    <message>
        <source>Measured in every run; above the first</source>
        <translation>In jedem Durchlauf gemessen; über der ersten</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>&amp;Zielpositionen</translation>
    </message>
    <message>
        <source>How many, or how far apart in the mean</source>
        <translation>Wie viele, oder wie weit im Mittel auseinander</translation>
    </message>
    <message>
        <source>&amp;Known period</source>
        <translation>&amp;Bekannte Periode</translation>
    </message>
    <message>
        <source>Of the axis&apos;s error, such as the lead of its screw: targets are spread over it</source>
        <translation>Des Fehlers der Achse, etwa die Steigung ihrer Spindel: Zielpositionen werden darüber verteilt</translation>
    </message>
    <message>
        <source>&amp;Cycles</source>
        <translation>Z&amp;yklen</translation>
    </message>
    <message>
        <source>Runs in each direction; the standard wants five</source>
        <translation>Durchläufe in jeder Richtung; die Norm will fünf</translation>
    </message>
    <message>
        <source>&amp;Overrun</source>
        <translation>Überla&amp;uf</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target</source>
        <translation>Wie weit die Achse vor der ersten Zielposition eines Durchlaufs in dessen Richtung fährt</translation>
    </message>
    <message>
        <source>F&amp;eed</source>
        <translation>&amp;Vorschub</translation>
    </message>
    <message>
        <source>Of the moves in the program</source>
        <translation>Der Bewegungen im Programm</translation>
    </message>
    <message>
        <source>D&amp;well</source>
        <translation>Ver&amp;weilzeit</translation>
    </message>
    <message>
        <source>How long the axis stands at each target, to be measured</source>
        <translation>Wie lange die Achse an jeder Zielposition steht, um gemessen zu werden</translation>
    </message>
    <message>
        <source>Ran&amp;dom seed</source>
        <translation>Zu&amp;fallszahl</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same</source>
        <translation>Eine andere Zahl gibt andere Zielpositionen, dieselbe dieselben</translation>
    </message>
    <message>
        <source>Given b&amp;y</source>
        <translation>&amp;Angabe</translation>
    </message>
    <message>
        <source>Whether targets are counted, or their distance is given</source>
        <translation>Ob Zielpositionen gezählt werden oder ihr Abstand gegeben ist</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>Anzahl der Zielpositionen</translation>
    </message>
    <message>
        <source>Mean spacing of targets</source>
        <translation>Mittlerer Abstand der Zielpositionen</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>keine bekannt</translation>
    </message>
    <message>
        <source>by the range</source>
        <translation>nach dem Bereich</translation>
    </message>
    <message>
        <source>%1. The axis moves from %2 to %3: check that this way is free.</source>
        <translation>%1. Die Achse fährt von %2 bis %3: prüfen, ob dieser Weg frei ist.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This program never moves an axis: the control of the machine plays the program, or a person moves from target to target.</source>
        <translation>Dieses Programm bewegt nie eine Achse: die Steuerung der Maschine spielt das Programm ab, oder ein Mensch fährt von Zielposition zu Zielposition.</translation>
    </message>
    <message>
        <source>For Capture, which takes the values by it</source>
        <translation>Für Messwerte erfassen, das die Werte danach nimmt</translation>
    </message>
    <message>
        <source>G-code for the control of the machine</source>
        <translation>G-Code für die Steuerung der Maschine</translation>
    </message>
    <message>
        <source>Save Program</source>
        <translation>Programm speichern</translation>
    </message>
    <message>
        <source>Save Plan</source>
        <translation>Messplan speichern</translation>
    </message>
    <message>
        <source>Programs (*%1);;All files (*)</source>
        <translation>Programme (*%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>Messpläne (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanStepsModel</name>
    <message>
        <source>step %1, %2, target %3</source>
        <translation>Schritt %1, %2, Zielposition %3</translation>
    </message>
    <message>
        <source>due</source>
        <translation>fällig</translation>
    </message>
    <message>
        <source>not taken yet</source>
        <translation>noch nicht genommen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>Kommt von</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanTargetsModel</name>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PreviewPanel</name>
    <message>
        <source>Save Exa&amp;mple…</source>
        <translation>&amp;Beispiel…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Save a small %1D calibration file as an example</source>
        <translation>Eine kleine %1D-Kalibrierdatei als Beispiel speichern</translation>
    </message>
    <message>
        <source>%1 bytes, more than any slot of the drive holds</source>
        <translation>%1 Byte, mehr als jeder Tabellenplatz des Antriebs fasst</translation>
    </message>
    <message>
        <source>%1 of %2 bytes of a table slot</source>
        <translation>%1 von %2 Byte eines Tabellenplatzes</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Fehler (%1)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>All slices</source>
        <translation>Alle Schnitte</translation>
    </message>
    <message>
        <source>Two axes</source>
        <translation>Zwei Achsen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemList</name>
    <message>
        <source>Problems of the file</source>
        <translation>Fehler der Datei</translation>
    </message>
    <message>
        <source>%1 cannot be used; the previous selection is kept.</source>
        <translation>%1 kann nicht verwendet werden; die vorige Auswahl bleibt.</translation>
    </message>
    <message>
        <source>%1 is used, with these warnings.</source>
        <translation>%1 wird verwendet, mit diesen Warnungen.</translation>
    </message>
    <message>
        <source>Further problems: %1.</source>
        <translation>Weitere Fehler: %1.</translation>
    </message>
    <message>
        <source>Click a problem, or press Enter, to see the file&apos;s line.</source>
        <translation>Ein Klick auf einen Fehler oder die Eingabetaste zeigt die Zeile der Datei.</translation>
    </message>
    <message>
        <source>&amp;Use %1D</source>
        <translation>%1D &amp;verwenden</translation>
    </message>
    <message>
        <source>Sets the dimensionality to %1D and reads the file again.</source>
        <translation>Setzt die Dimensionalität auf %1D und liest die Datei neu.</translation>
    </message>
    <message>
        <source>%1 cannot be used.</source>
        <translation>%1 kann nicht verwendet werden.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemModel</name>
    <message>
        <source>error, line %1</source>
        <translation>Fehler, Zeile %1</translation>
    </message>
    <message>
        <source>warning, line %1</source>
        <translation>Warnung, Zeile %1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProvePage</name>
    <message>
        <source>%1 %2 (tolerance %3)</source>
        <translation>%1 %2 (Toleranz %3)</translation>
    </message>
    <message>
        <source>%1 not defined (tolerance %2)</source>
        <translation>%1 nicht definiert (Toleranz %2)</translation>
    </message>
    <message>
        <source>Not within the tolerances: %1.</source>
        <translation>Nicht innerhalb der Toleranzen: %1.</translation>
    </message>
    <message>
        <source>Not judged by: %1.</source>
        <translation>Nicht zu beurteilen: %1.</translation>
    </message>
    <message>
        <source>Undecided, since the uncertainty is too large: %1.</source>
        <translation>Nicht entscheidbar, da die Messunsicherheit zu groß ist: %1.</translation>
    </message>
    <message>
        <source>The machine is not as good as was predicted.</source>
        <translation>Die Maschine ist nicht so gut wie vorhergesagt.</translation>
    </message>
    <message>
        <source>The machine is no better than before.</source>
        <translation>Die Maschine ist nicht besser als vorher.</translation>
    </message>
    <message>
        <source>The two are corrected differently for temperature or dead path, so that they cannot be compared.</source>
        <translation>Die beiden sind verschieden auf Temperatur oder Totstrecke korrigiert und lassen sich nicht vergleichen.</translation>
    </message>
    <message>
        <source>No tolerance is given, so there is no verdict.</source>
        <translation>Keine Toleranz ist angegeben, also gibt es kein Urteil.</translation>
    </message>
    <message>
        <source>Within the tolerances.</source>
        <translation>Innerhalb der Toleranzen.</translation>
    </message>
    <message>
        <source>Within the tolerances (uncertainty not stated).</source>
        <translation>Innerhalb der Toleranzen (Messunsicherheit nicht angegeben).</translation>
    </message>
    <message>
        <source>Second measurement</source>
        <translation>Zweite Messung</translation>
    </message>
    <message>
        <source>Files of the second measurement</source>
        <translation>Dateien der zweiten Messung</translation>
    </message>
    <message>
        <source>Kee&amp;p in the Record</source>
        <translation>Ins &amp;Protokoll übernehmen</translation>
    </message>
    <message>
        <source>The second measurement, what it says of the prediction, and the verdict</source>
        <translation>Die zweite Messung, was sie über die Vorhersage sagt, und das Urteil</translation>
    </message>
    <message>
        <source>For a file that does not say which table was active</source>
        <translation>Für eine Datei, die nicht sagt, welche Tabelle aktiv war</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Was bleibt</translation>
    </message>
    <message>
        <source>Figures before, predicted, held out and after</source>
        <translation>Kennwerte vorher, vorhergesagt, ausgelassen und nachher</translation>
    </message>
    <message>
        <source>What is left at the targets</source>
        <translation>Was an den Zielpositionen bleibt</translation>
    </message>
    <message>
        <source>The tabl&amp;e %1 was active</source>
        <translation>&amp;Die Tabelle %1 war aktiv</translation>
    </message>
    <message>
        <source>What to look at: %1</source>
        <translation>Worauf zu achten ist: %1</translation>
    </message>
    <message>
        <source>Nothing was predicted between the targets: before and after are compared alone.</source>
        <translation>Zwischen den Zielpositionen wurde nichts vorhergesagt: verglichen werden nur vorher und nachher.</translation>
    </message>
    <message>
        <source>No table of this record is in use: a second measurement is compared with that of Measure alone. Open a record with a table to prove that one.</source>
        <translation>Keine Tabelle dieses Protokolls ist in Gebrauch: eine zweite Messung wird nur mit der von Messen verglichen. Um eine Tabelle nachzuweisen, öffnen Sie ein Protokoll mit ihr.</translation>
    </message>
    <message>
        <source>Write the table and activate it, measure again, and add the files of that measurement here.</source>
        <translation>Schreiben und aktivieren Sie die Tabelle, messen Sie noch einmal, und fügen Sie die Dateien dieser Messung hier hinzu.</translation>
    </message>
    <message>
        <source>Measure again with the table active, and add the files of that measurement here.</source>
        <translation>Messen Sie mit aktiver Tabelle noch einmal, und fügen Sie die Dateien dieser Messung hier hinzu.</translation>
    </message>
    <message>
        <source>The measurement is in the record: save that, and write the report.</source>
        <translation>Die Messung ist im Protokoll: speichern Sie es, und schreiben Sie den Bericht.</translation>
    </message>
    <message>
        <source>Keep it in the record.</source>
        <translation>Übernehmen Sie sie ins Protokoll.</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>Die Dateien werden gelesen …</translation>
    </message>
    <message>
        <source>The second measurement does not say which table was active. If it was the table %1, say so above; otherwise measure again with it.</source>
        <translation>Die zweite Messung sagt nicht, welche Tabelle aktiv war. War es die Tabelle %1, geben Sie das oben an; sonst messen Sie mit ihr noch einmal.</translation>
    </message>
    <message>
        <source>The measurements are being compared …</source>
        <translation>Die Messungen werden verglichen …</translation>
    </message>
    <message>
        <source>There is no measurement to compare it with: add that one in Measure.</source>
        <translation>Es gibt keine Messung zum Vergleich: fügen Sie diese unter Messen hinzu.</translation>
    </message>
    <message>
        <source>The second measurement covers only part of the first one&apos;s travel.</source>
        <translation>Die zweite Messung deckt nur einen Teil des Verfahrwegs der ersten ab.</translation>
    </message>
    <message>
        <source>The measurement is in the record, and that is saved: write the report.</source>
        <translation>Die Messung ist im Protokoll, und das ist gespeichert: Schreiben Sie den Bericht.</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %1 is not defined after.</source>
        <translation>Ob es wie vorhergesagt ist, bleibt offen, da %1 nachher nicht definiert ist.</translation>
    </message>
    <message>
        <source>Not as predicted, since the machine is no better than before: %3 is %1 after and was %2 before.</source>
        <translation>Nicht wie vorhergesagt, da die Maschine nicht besser ist als vorher: %3 ist nachher %1 und war vorher %2.</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %3 is smaller than before by no more than what cannot be told: %3 is %1 after and was %2 before.</source>
        <translation>Ob es wie vorhergesagt ist, bleibt offen, da %3 um nicht mehr kleiner ist als vorher, als sich nicht sagen lässt: %3 ist nachher %1 und war vorher %2.</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since less of the axis was measured: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>Ob es wie vorhergesagt ist, bleibt offen, da weniger von der Achse gemessen wurde: %3 ist nachher %1, und bis %2 gilt als wie vorhergesagt.</translation>
    </message>
    <message>
        <source>As predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>Wie vorhergesagt: %3 ist nachher %1, und bis %2 gilt als wie vorhergesagt (das 1,2-Fache von %3 ausgelassen, und was sich nicht sagen lässt).</translation>
    </message>
    <message>
        <source>Not as predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>Nicht wie vorhergesagt: %3 ist nachher %1, und bis %2 gilt als wie vorhergesagt (das 1,2-Fache von %3 ausgelassen, und was sich nicht sagen lässt).</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since the targets are farther apart than before: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>Ob es wie vorhergesagt ist, bleibt offen, da die Zielpositionen weiter auseinander liegen als vorher: %3 ist nachher %1, und bis %2 gilt als wie vorhergesagt.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordActions</name>
    <message>
        <source>Re&amp;cord</source>
        <translation>Proto&amp;koll</translation>
    </message>
    <message>
        <source>&amp;New Record</source>
        <translation>&amp;Neues Protokoll</translation>
    </message>
    <message>
        <source>&amp;Open Record…</source>
        <translation>Protokoll ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Save Record</source>
        <translation>Protokoll &amp;speichern</translation>
    </message>
    <message>
        <source>Save Record &amp;As…</source>
        <translation>Protokoll speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Bericht…</translation>
    </message>
    <message>
        <source>Records (*.axcal)</source>
        <translation>Protokolle (*.axcal)</translation>
    </message>
    <message>
        <source>Open Record</source>
        <translation>Protokoll öffnen</translation>
    </message>
    <message>
        <source>Save Record</source>
        <translation>Protokoll speichern</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML (*.html *.htm)</source>
        <translation>HTML (*.html *.htm)</translation>
    </message>
    <message>
        <source>Save, &amp;Then Begin</source>
        <translation>S&amp;peichern, dann beginnen</translation>
    </message>
    <message>
        <source>Save, &amp;Then Open</source>
        <translation>S&amp;peichern, dann öffnen</translation>
    </message>
    <message>
        <source>Begin Without Savin&amp;g</source>
        <translation>Ohne Spei&amp;chern beginnen</translation>
    </message>
    <message>
        <source>Open Without Savin&amp;g</source>
        <translation>Ohne Spei&amp;chern öffnen</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>Bleibe&amp;n</translation>
    </message>
    <message>
        <source>The record has never been saved.</source>
        <translation>Das Protokoll wurde noch nie gespeichert.</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>%1 is there already, and is another file.</source>
        <translation>%1 gibt es schon, und es ist eine andere Datei.</translation>
    </message>
    <message>
        <source>%1 has been changed by another program since it was read here.</source>
        <translation>%1 wurde von einem anderen Programm geändert, seit es hier gelesen wurde.</translation>
    </message>
    <message>
        <source>Overwri&amp;te</source>
        <translation>Überschre&amp;iben</translation>
    </message>
    <message>
        <source>&amp;Keep Both…</source>
        <translation>&amp;Beide behalten…</translation>
    </message>
    <message>
        <source>The program did not end well. A record that was never saved was kept at %1.</source>
        <translation>Das Programm wurde nicht ordentlich beendet. Ein nie gespeichertes Protokoll wurde um %1 gesichert.</translation>
    </message>
    <message>
        <source>The program did not end well. Unsaved changes of %1 were kept at %2.</source>
        <translation>Das Programm wurde nicht ordentlich beendet. Nicht gespeicherte Änderungen von %1 wurden um %2 gesichert.</translation>
    </message>
    <message>
        <source>&amp;Take Them Up</source>
        <translation>&amp;Übernehmen</translation>
    </message>
    <message>
        <source>For&amp;get Them</source>
        <translation>Ver&amp;gessen</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Der Bericht steht in %1.</translation>
    </message>
    <message>
        <source>The drive has the table; only the record does not say so: %1</source>
        <translation>Der Antrieb hat die Tabelle; nur das Protokoll sagt es nicht: %1</translation>
    </message>
    <message>
        <source>%1 has changed on disk. What was left out is used again; corrections, and which table was active, are to be said anew. Ctrl+Z takes that back.</source>
        <translation>%1 hat sich auf dem Datenträger geändert. Ausgeschlossenes wird wieder verwendet; Korrekturen und welche Tabelle aktiv war sind neu anzugeben. Strg+Z macht das rückgängig.</translation>
    </message>
    <message>
        <source>%1 says what was written and measured of its table, and this record does not. Saving it under another name keeps both.</source>
        <translation>%1 sagt, was von der Tabelle darin geschrieben und gemessen wurde, und dieses Protokoll sagt es nicht. Unter einem anderen Namen bleibt beides erhalten.</translation>
    </message>
    <message>
        <source>&amp;Take It Up</source>
        <translation>&amp;Übernehmen</translation>
    </message>
    <message>
        <source>For&amp;get It</source>
        <translation>Ver&amp;gessen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordBar</name>
    <message>
        <source>Record:</source>
        <translation>Protokoll:</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open a record (.axcal); it can also be dropped on the window (Ctrl+Alt+O)</source>
        <translation>Ein Protokoll (.axcal) öffnen; es lässt sich auch auf das Fenster ziehen (Strg+Alt+O)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save measurement, table, what it promised and what came of it (Ctrl+S)</source>
        <translation>Messung, Tabelle, was sie versprach und was daraus wurde, speichern (Strg+S)</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>The report of the record as PDF or HTML (Ctrl+P)</source>
        <translation>Der Bericht des Protokolls als PDF oder HTML (Strg+P)</translation>
    </message>
    <message>
        <source>Open record</source>
        <translation>Protokoll öffnen</translation>
    </message>
    <message>
        <source>Save record</source>
        <translation>Protokoll speichern</translation>
    </message>
    <message>
        <source>Report of the record</source>
        <translation>Bericht des Protokolls</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>It has changes that are not saved.</source>
        <translation>Es hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>There are no unsaved changes.</source>
        <translation>Es gibt keine ungespeicherten Änderungen.</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>Protokoll %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordFile</name>
    <message>
        <source>not saved yet</source>
        <translation>neu</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordModel</name>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>How %1 is read</source>
        <translation>Wie %1 gelesen wird</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>Aufwärts und abwärts tauschen</translation>
    </message>
    <message>
        <source>Exclude (%1)</source>
        <translation>Ausschließen (%1)</translation>
    </message>
    <message>
        <source>Use again (%1)</source>
        <translation>Wieder verwenden (%1)</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>Regel für Ausreißer</translation>
    </message>
    <message>
        <source>Tolerance of %1</source>
        <translation>Toleranz von %1</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Messunsicherheit</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Table in use</source>
        <translation>Tabelle im Einsatz</translation>
    </message>
    <message>
        <source>Table active while measured</source>
        <translation>Aktive Tabelle während der Messung</translation>
    </message>
    <message>
        <source>Fit: %1</source>
        <translation>Anpassen: %1</translation>
    </message>
    <message>
        <source>%1 changed on disk</source>
        <translation>%1 auf dem Datenträger geändert</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualModel</name>
    <message>
        <source>at %1: %2, standard error %3</source>
        <translation>bei %1: %2, Standardfehler %3</translation>
    </message>
    <message>
        <source>at %1: %2, standard error not defined</source>
        <translation>bei %1: %2, Standardfehler nicht definiert</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Verbleibend</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Standardfehler</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualPlot</name>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after, with its standard error</source>
        <translation>nachher, mit Standardfehler</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>There is nothing to compare.</source>
        <translation>Es gibt nichts zu vergleichen.</translation>
    </message>
    <message>
        <source>What is left lies between %1 and %2.</source>
        <translation>Was bleibt, liegt zwischen %1 und %2.</translation>
    </message>
    <message>
        <source>Mean deviation before and after</source>
        <translation>Mittlere Abweichung vorher und nachher</translation>
    </message>
    <message>
        <source>Dashed, with squares: before. Full line, with dots: after; the band is the standard error of the mean.</source>
        <translation>Gestrichelt, mit Quadraten: vorher. Durchgezogen, mit Punkten: nachher; das Band ist der Standardfehler des Mittelwerts.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RestoreDriveDialog</name>
    <message>
        <source>The backup is being read.</source>
        <translation>Die Sicherung wird gelesen.</translation>
    </message>
    <message>
        <source>The backup is of another drive: confirm it first.</source>
        <translation>Die Sicherung ist von einem anderen Antrieb: Bestätigen Sie das zuerst.</translation>
    </message>
    <message>
        <source>Backup of %1, serial number %2; axes: %3</source>
        <translation>Sicherung von %1, Seriennummer %2; Achsen: %3</translation>
    </message>
    <message>
        <source>, of %1</source>
        <comment>time</comment>
        <translation>, vom %1</translation>
    </message>
    <message>
        <source>Tables that no axis uses, restored after the axes: %1</source>
        <translation>Tabellen, die keine Achse verwendet; sie werden nach den Achsen wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>Ganzen Antrieb wiederherstellen</translation>
    </message>
    <message>
        <source>Brings all axes of %1 back to the backup in %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified. No compensation is switched on.</source>
        <translation>Bringt alle Achsen von %1 nacheinander auf den Zustand der Sicherung in %2. Alle Schreibvorgänge werden geprüft, bevor der erste beginnt; jeder legt eine Sicherung an und wird verifiziert. Keine Kompensation wird eingeschaltet.</translation>
    </message>
    <message>
        <source>The backup is of &amp;another drive, which this one replaces</source>
        <translation>Die Sicherung ist von einem &amp;anderen Antrieb, den dieser ersetzt</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunDriftModel</name>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesModel</name>
    <message>
        <source>target %1 at %2</source>
        <translation>Zielposition %1 bei %2</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesView</name>
    <message>
        <source>Values of all files</source>
        <translation>Werte aller Dateien</translation>
    </message>
    <message>
        <source>&amp;Exclude</source>
        <translation>Ausschließe&amp;n</translation>
    </message>
    <message>
        <source>Leave the selected values out of every figure and table; in the first column, whole targets (Del)</source>
        <translation>Die ausgewählten Werte aus jedem Kennwert und jeder Tabelle weglassen; in der ersten Spalte ganze Zielpositionen (Entf)</translation>
    </message>
    <message>
        <source>Exclude W&amp;hole Run</source>
        <translation>&amp;Ganzen Durchlauf ausschließen</translation>
    </message>
    <message>
        <source>Leave out every value of the run of the current cell</source>
        <translation>Jeden Wert des Durchlaufs weglassen, in dem die aktuelle Zelle steht</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>Wie&amp;der verwenden</translation>
    </message>
    <message>
        <source>Use the selected values again</source>
        <translation>Die ausgewählten Werte wieder verwenden</translation>
    </message>
    <message>
        <source>Too many cells are selected: at most %1 in one step. A whole target is its cell in the first column; &quot;Exclude Whole Run&quot; takes a whole run.</source>
        <translation>Zu viele Zellen sind ausgewählt: höchstens %1 in einem Schritt. Für eine ganze Zielposition genügt ihre Zelle in der ersten Spalte, für einen ganzen Durchlauf „Ganzen Durchlauf ausschließen“.</translation>
    </message>
    <message>
        <source>Values: %1, excluded: %2 (✕). ↑ up, ↓ down.</source>
        <translation>Werte: %1, ausgeschlossen: %2 (✕). ↑ aufwärts, ↓ abwärts.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SaveMachineDialog</name>
    <message>
        <source>Save Machine File</source>
        <translation>Maschinendatei speichern</translation>
    </message>
    <message>
        <source>Writes machine.toml and the tables of all axes into a folder. The drives are only read.</source>
        <translation>Schreibt machine.toml und die Tabellen aller Achsen in einen Ordner. Die Antriebe werden nur gelesen.</translation>
    </message>
    <message>
        <source>&amp;Name of the machine (may be empty)</source>
        <translation>&amp;Name der Maschine (darf leer sein)</translation>
    </message>
    <message>
        <source>&amp;Drives</source>
        <translation>Antrie&amp;be</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>Drives of the machine</source>
        <translation>Antriebe der Maschine</translation>
    </message>
    <message>
        <source>&amp;Replace These Files</source>
        <translation>Diese Dateien e&amp;rsetzen</translation>
    </message>
    <message>
        <source>&amp;Save in Folder…</source>
        <translation>In Ordner &amp;speichern…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>Sch&amp;ließen</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>Zurück zur Seite (Esc)</translation>
    </message>
    <message>
        <source>%1 (does not answer)</source>
        <comment>drive</comment>
        <translation>%1 (antwortet nicht)</translation>
    </message>
    <message>
        <source>No drive is chosen.</source>
        <translation>Kein Antrieb ist gewählt.</translation>
    </message>
    <message>
        <source>%1 does not answer: a machine file without one of its drives would be another machine.</source>
        <translation>%1 antwortet nicht: eine Maschinendatei ohne einen ihrer Antriebe wäre eine andere Maschine.</translation>
    </message>
    <message>
        <source>Wait for the end of the write.</source>
        <translation>Warten Sie das Ende des Schreibens ab.</translation>
    </message>
    <message>
        <source>Files that are there are not replaced unasked</source>
        <translation>Vorhandene Dateien werden nicht ungefragt ersetzt</translation>
    </message>
    <message>
        <source>The folder has other files of these names, which would be replaced: %1.</source>
        <translation>Der Ordner hat andere Dateien dieser Namen, die ersetzt würden: %1.</translation>
    </message>
    <message>
        <source>Reading the drives …</source>
        <translation>Die Antriebe werden gelesen …</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Nothing is saved yet.</source>
        <translation>Noch ist nichts gespeichert.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Saved %1: drives: %2, tables: %3.</source>
        <translation>%1 gespeichert: Antriebe: %2, Tabellen: %3.</translation>
    </message>
    <message>
        <source>Folder for the Machine File</source>
        <translation>Ordner für die Maschinendatei</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SettingFields</name>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>default: %1</source>
        <translation>Vorgabe: %1</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>nötig</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie in der Datei</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SetupHistory</name>
    <message>
        <source>Dimensionality</source>
        <translation>Dimensionalität</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Dim%1-Quelle</translation>
    </message>
    <message>
        <source>Compensation data</source>
        <translation>Kompensationsdaten</translation>
    </message>
    <message>
        <source>Several fields</source>
        <translation>Mehrere Felder</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SetupPanel</name>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>Ac&amp;hse</translation>
    </message>
    <message>
        <source>The axis to compensate; lists all axes of all drives</source>
        <translation>Die zu kompensierende Achse; hier stehen alle Achsen aller Antriebe</translation>
    </message>
    <message>
        <source>The axis to compensate</source>
        <translation>Die zu kompensierende Achse</translation>
    </message>
    <message>
        <source>Dimen&amp;sionality</source>
        <translation>Dimensi&amp;onalität</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on: 1D one, 2D two, 3D three</source>
        <translation>Die Zahl der Positionen, von denen die Kompensation abhängt: 1D eine, 2D zwei, 3D drei</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on</source>
        <translation>Die Zahl der Positionen, von denen die Kompensation abhängt</translation>
    </message>
    <message>
        <source>Dim&amp;1 Source</source>
        <translation>Dim&amp;1-Quelle</translation>
    </message>
    <message>
        <source>Dim&amp;2 Source</source>
        <translation>Dim&amp;2-Quelle</translation>
    </message>
    <message>
        <source>Dim&amp;3 Source</source>
        <translation>Dim&amp;3-Quelle</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1: select one, or type a path, a tam:// URI or a hexadecimal address and press Enter</source>
        <translation>Das Register, das die Position für Dimension %1 liefert: eines wählen, oder einen Pfad, eine tam://-URI oder eine hexadezimale Adresse eingeben und die Eingabetaste drücken</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1</source>
        <translation>Das Register, das die Position für Dimension %1 liefert</translation>
    </message>
    <message>
        <source>Compensat&amp;ion data</source>
        <translation>Ko&amp;mpensationsdaten</translation>
    </message>
    <message>
        <source>A file of positions and compensation values; needed only for a new table</source>
        <translation>Eine Datei mit Positionen und Kompensationswerten; nur für eine neue Tabelle nötig</translation>
    </message>
    <message>
        <source>A file of compensation values; needed only for a new table</source>
        <translation>Eine Datei mit Kompensationswerten; nur für eine neue Tabelle nötig</translation>
    </message>
    <message>
        <source>Ta&amp;ble</source>
        <translation>&amp;Tabelle</translation>
    </message>
    <message>
        <source>The table for the axis: the one on the drive, or one from the file</source>
        <translation>Die Tabelle für die Achse: die im Antrieb oder eine aus der Datei</translation>
    </message>
    <message>
        <source>The table for the axis</source>
        <translation>Die Tabelle für die Achse</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Speicherung</translation>
    </message>
    <message>
        <source>Persistent: stored in the drive&apos;s flash and kept over a reboot. Volatile: lost on a reboot. Applies to the table on the drive as well</source>
        <translation>Dauerhaft: im Flash-Speicher des Antriebs, bleibt über einen Neustart erhalten. Flüchtig: geht beim Neustart verloren. Gilt auch für die Tabelle im Antrieb</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>Ob die Tabelle einen Neustart überdauert</translation>
    </message>
    <message>
        <source>Make &amp;persistent</source>
        <translation>Dauerhaft &amp;speichern</translation>
    </message>
    <message>
        <source>no axis</source>
        <translation>keine Achse</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>referenziert</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>nicht referenziert</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>homed, serial number</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, positions in %2, %3</source>
        <translation>%1, Positionen in %2, %3</translation>
    </message>
    <message>
        <source>select or type a register</source>
        <translation>ein Register wählen oder eingeben</translation>
    </message>
    <message>
        <source>now %1</source>
        <comment>value</comment>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>one source, one column of positions</source>
        <translation>eine Quelle, eine Spalte mit Positionen</translation>
    </message>
    <message>
        <source>two sources, two columns of positions</source>
        <translation>zwei Quellen, zwei Spalten mit Positionen</translation>
    </message>
    <message>
        <source>three sources, three columns of positions</source>
        <translation>drei Quellen, drei Spalten mit Positionen</translation>
    </message>
    <message>
        <source>On the drive: %1</source>
        <translation>Im Antrieb: %1</translation>
    </message>
    <message>
        <source>none on the drive</source>
        <translation>keine im Antrieb</translation>
    </message>
    <message>
        <source>Parsed: %1</source>
        <translation>Aus Datei: %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>aus %1</translation>
    </message>
    <message>
        <source>open a file to get a table</source>
        <translation>für eine Tabelle eine Datei öffnen</translation>
    </message>
    <message>
        <source>%1 is not used, problems: %2</source>
        <translation>%1 wird nicht verwendet, Probleme: %2</translation>
    </message>
    <message>
        <source>CSV; needed only for a new table</source>
        <translation>CSV; nur für eine neue Tabelle nötig</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>tables: %1, points: %2</source>
        <translation>Tabellen: %1, Stützstellen: %2</translation>
    </message>
    <message>
        <source>in flash</source>
        <translation>im Flash-Speicher</translation>
    </message>
    <message>
        <source>lost on a reboot</source>
        <translation>geht beim Neustart verloren</translation>
    </message>
    <message>
        <source>; %1 of %2 flash operations available now</source>
        <comment>of the flash</comment>
        <translation>; %1 von %2 Flash-Vorgängen jetzt verfügbar</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>unknown register %1</source>
        <translation>unbekanntes Register %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1, %2 points</source>
        <translation>%1, %2 Stützstellen</translation>
    </message>
    <message>
        <source>%1, empty</source>
        <comment>table slot</comment>
        <translation>%1, leer</translation>
    </message>
    <message>
        <source>; %1 of typically %2 flash cycles used</source>
        <comment>of the flash</comment>
        <translation>; %1 von üblicherweise %2 Flash-Zyklen verbraucht</translation>
    </message>
    <message>
        <source>; read as %1, converted</source>
        <translation>; gelesen als %1, umgerechnet</translation>
    </message>
    <message>
        <source>from %1; the drive has it already</source>
        <translation>aus %1; der Antrieb hat sie bereits</translation>
    </message>
    <message>
        <source>Fitted: %1</source>
        <translation>Angepasst: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SeveralWritesDialog</name>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Write All</source>
        <translation>Alle &amp;schreiben</translation>
    </message>
    <message>
        <source>Write these to the drive now</source>
        <translation>Diese jetzt in den Antrieb schreiben</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>Bestätigen Sie zuerst die großen Korrekturen</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Stops the writes; the current one is rolled back (Esc)</source>
        <translation>Hält die Schreibvorgänge an; der laufende wird rückgängig gemacht (Esc)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>Sch&amp;ließen</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>Zurück zur Seite (Esc)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>Nichts ändern und zurückgehen (Esc)</translation>
    </message>
    <message>
        <source>Asking the drive what would change …</source>
        <translation>Der Antrieb wird gefragt, was sich ändern würde …</translation>
    </message>
    <message>
        <source>The drive already has all of this.</source>
        <translation>Der Antrieb hat das alles bereits.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SignSentence</name>
    <message>
        <source>all values are 0: the drive will add nothing</source>
        <translation>alle Werte sind 0: der Antrieb addiert nichts</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the reference reads %2: the drive will add %3</source>
        <translation>wo der Geber %1 anzeigt, zeigt die Referenz %2: der Antrieb addiert %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>bei %1, %2</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 more than the encoder: the drive will add %3</source>
        <translation>bei %1 zeigt die Referenz %2 mehr als der Geber: der Antrieb addiert %3</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 less than the encoder: the drive will add %3</source>
        <translation>bei %1 zeigt die Referenz %2 weniger als der Geber: der Antrieb addiert %3</translation>
    </message>
    <message>
        <source>at the set position %1 the drive will add %2</source>
        <translation>an der Sollposition %1 wird der Antrieb %2 addieren</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the drive will add %2</source>
        <translation>wo der Geber %1 anzeigt, wird der Antrieb %2 addieren</translation>
    </message>
    <message>
        <source>at %1 the drive will add %2</source>
        <translation>bei %1 wird der Antrieb %2 addieren</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceGallery</name>
    <message>
        <source>Slices of the table</source>
        <translation>Schnitte der Tabelle</translation>
    </message>
    <message>
        <source>Enter shows the slice as a picture</source>
        <translation>Die Eingabetaste zeigt den Schnitt als Bild</translation>
    </message>
    <message>
        <source>colours from %1 to %2</source>
        <translation>Farben von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices · %3</source>
        <translation>%1 von %2 Schnitten · %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceRow</name>
    <message>
        <source>Slice at</source>
        <translation>Schnitt bei</translation>
    </message>
    <message>
        <source>The slice that is shown</source>
        <translation>Der gezeigte Schnitt</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>The dimension that is held constant; the other two are shown</source>
        <translation>Die festgehaltene Dimension; die beiden anderen werden gezeigt</translation>
    </message>
    <message>
        <source>Sliced dimension</source>
        <translation>Geschnittene Dimension</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SourceCheck</name>
    <message>
        <source>The drive is not connected: the source cannot be checked.</source>
        <translation>Der Antrieb ist nicht verbunden: die Quelle lässt sich nicht prüfen.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StateField</name>
    <message>
        <source>OFF</source>
        <translation>AUS</translation>
    </message>
    <message>
        <source>EVALUATING</source>
        <translation>AUSWERTUNG</translation>
    </message>
    <message>
        <source>RAMPING</source>
        <translation>RAMPE</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>AKTIV</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>FEHLER</translation>
    </message>
    <message>
        <source>Output %1 · Index %2</source>
        <translation>Ausgang %1 · Index %2</translation>
    </message>
    <message>
        <source>The state of the compensation of this axis</source>
        <translation>Der Zustand der Kompensation dieser Achse</translation>
    </message>
    <message>
        <source>Live values of the drive: the compensation output and the table index</source>
        <translation>Live-Werte des Antriebs: der Ausgang der Kompensation und der Tabellenindex</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>since before %1</source>
        <translation>schon vor %1</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>%1, CRC %2</source>
        <comment>table and checksum</comment>
        <translation>%1, CRC %2</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>NICHT VERBUNDEN</translation>
    </message>
    <message>
        <source>as read at %1</source>
        <translation>gelesen um %1</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>außerhalb der Tabelle: Endwert gehalten</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>widerspricht der Tabelle</translation>
    </message>
    <message>
        <source>not proved yet</source>
        <translation>noch nicht nachgewiesen</translation>
    </message>
    <message>
        <source>proved over %1 of the table</source>
        <translation>über %1 der Tabelle nachgewiesen</translation>
    </message>
    <message>
        <source>Compensation: %1</source>
        <comment>state</comment>
        <translation>Kompensation: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StationChoice</name>
    <message>
        <source>The file is being read.</source>
        <translation>Die Datei wird gelesen.</translation>
    </message>
    <message>
        <source>The file has no station.</source>
        <translation>Die Datei enthält keine Station.</translation>
    </message>
    <message>
        <source>Select the station that is this drive.</source>
        <translation>Die Station wählen, die dieser Antrieb ist.</translation>
    </message>
    <message>
        <source>Confirm first that the station is meant.</source>
        <translation>Zuerst bestätigen, dass diese Station gemeint ist.</translation>
    </message>
    <message>
        <source>%1 has the serial number %2, the drive %3 has %4.</source>
        <translation>%1 hat die Seriennummer %2, der Antrieb %3 hat %4.</translation>
    </message>
    <message>
        <source>Stat&amp;ion</source>
        <translation>Stat&amp;ion</translation>
    </message>
    <message>
        <source>not selected</source>
        <translation>nicht gewählt</translation>
    </message>
    <message>
        <source>The drive in the configuration whose parameters are meant</source>
        <translation>Der Antrieb in der Konfiguration, um dessen Parameter es geht</translation>
    </message>
    <message>
        <source>These &amp;parameters are for this drive although the serial numbers differ</source>
        <translation>Diese &amp;Parameter sind für diesen Antrieb, obwohl die Seriennummern verschieden sind</translation>
    </message>
    <message>
        <source>The &amp;parameters of this drive are for this station although the serial numbers differ</source>
        <translation>Die &amp;Parameter dieses Antriebs sind für diese Station, obwohl die Seriennummern verschieden sind</translation>
    </message>
    <message>
        <source>The wrong drive would get the compensation of another machine</source>
        <translation>Der falsche Antrieb bekäme die Kompensation einer anderen Maschine</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StatusStrip</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Stops the operation; a write is rolled back (Esc)</source>
        <translation>Hält den Vorgang an; ein Schreibvorgang wird rückgängig gemacht (Esc)</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>&amp;Logbuch</translation>
    </message>
    <message>
        <source>Show the log (Ctrl+L)</source>
        <translation>Das Logbuch zeigen (Strg+L)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SurfaceView</name>
    <message>
        <source>Heights</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>How many times too high the errors are drawn, compared with the axes (+ and -)</source>
        <translation>Wievielmal zu hoch die Fehler im Vergleich zu den Achsen gezeichnet werden (+ und -)</translation>
    </message>
    <message>
        <source>First view</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Surface of the table</source>
        <translation>Fläche der Tabelle</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>heights × %1</source>
        <translation>Überhöhung × %1</translation>
    </message>
    <message>
        <source>See the surface as at first (Home or a double click). Arrow keys and dragging turn it, the wheel, Page Up and Page Down zoom.</source>
        <translation>Die Fläche wie am Anfang sehen (Pos1 oder Doppelklick). Pfeiltasten und Ziehen drehen sie, Mausrad, Bild auf und Bild ab vergrößern und verkleinern.</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>Als PNG, SVG oder PDF speichern</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>Es gibt keine Tabelle zum Speichern.</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>The units of the table have no common scale; the heights are drawn as they fit</source>
        <translation>Die Einheiten der Tabelle haben keinen gemeinsamen Maßstab; die Höhen sind passend gezeichnet</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableContentCombo</name>
    <message>
        <source>Selected table</source>
        <translation>Gewählte Tabelle</translation>
    </message>
    <message>
        <source>Table on the drive</source>
        <translation>Tabelle im Antrieb</translation>
    </message>
    <message>
        <source>Selected - drive</source>
        <translation>Gewählte - Antrieb</translation>
    </message>
    <message>
        <source>Which values are shown</source>
        <translation>Welche Werte gezeigt werden</translation>
    </message>
    <message>
        <source>Values shown</source>
        <translation>Gezeigte Werte</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TablePlot</name>
    <message>
        <source>C&amp;ursors</source>
        <translation>C&amp;ursor</translation>
    </message>
    <message>
        <source>Two cursors and their difference. Arrow keys move the cursor, Space changes between A and B, a click sets it.</source>
        <translation>Zwei Cursor und ihre Differenz. Pfeiltasten bewegen den Cursor, die Leertaste wechselt zwischen A und B, ein Klick setzt ihn.</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>im Antrieb</translation>
    </message>
    <message>
        <source>Picture of the table</source>
        <translation>Bild der Tabelle</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>&amp;Ganze Ansicht</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>A: %1     B: %2
B - A: %3</source>
        <translation>A: %1     B: %2
B - A: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>What is drawn over the map</source>
        <translation>Was über die Karte gezeichnet wird</translation>
    </message>
    <message>
        <source>&amp;Grid points</source>
        <translation>Stütz&amp;stellen</translation>
    </message>
    <message>
        <source>The points of the table, where they are far enough apart</source>
        <translation>Die Stützstellen der Tabelle, wo sie weit genug auseinander liegen</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Höhenlinien</translation>
    </message>
    <message>
        <source>Lines of equal value</source>
        <translation>Linien gleichen Werts</translation>
    </message>
    <message>
        <source>Cross-&amp;sections</source>
        <translation>S&amp;chnitte</translation>
    </message>
    <message>
        <source>The values along both axes through the cross-hair or the cursor, or else through the position of the axis</source>
        <translation>Die Werte entlang beider Achsen durch das Fadenkreuz oder den Cursor, sonst durch die Position der Achse</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>außerhalb der Tabelle: Endwert gehalten</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg, .pdf or .csv.</source>
        <translation>Der Dateiname muss auf .png, .svg, .pdf oder .csv enden.</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>Es gibt keine Tabelle zum Speichern.</translation>
    </message>
    <message>
        <source>map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Show the whole table again (Home or a double click). The wheel and + and - zoom, Shift and drag zooms into a rectangle, dragging moves.</source>
        <translation>Wieder die ganze Tabelle zeigen (Pos1 oder Doppelklick). Mausrad, + und - vergrößern und verkleinern, Umschalt und Ziehen vergrößert ein Rechteck, Ziehen verschiebt.</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF, or the values shown as CSV</source>
        <translation>Als PNG, SVG oder PDF speichern, oder die gezeigten Werte als CSV</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Verfahrweg</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>end value held</source>
        <translation>Endwert gehalten</translation>
    </message>
    <message>
        <source>A difference is no table for a drive: it can be saved as a picture only.</source>
        <translation>Eine Differenz ist keine Tabelle für einen Antrieb: Sie lässt sich nur als Bild speichern.</translation>
    </message>
    <message>
        <source>These are values of another controller: Export for Another Controller writes its file.</source>
        <translation>Das sind Werte einer anderen Steuerung: „Für eine andere Steuerung exportieren“ schreibt deren Datei.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableSelection</name>
    <message>
        <source>%1 has been read: %2 points, tables: %3.</source>
        <translation>%1 wurde gelesen: %2 Stützstellen, Tabellen: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2 problems.</source>
        <translation>%1 ist nicht verwendbar, Anzahl der Fehler: %2.</translation>
    </message>
    <message>
        <source>%1 is used as the table: %2 points, tables: %3.</source>
        <translation>%1 wird als Tabelle verwendet: %2 Punkte, Tabellen: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be used as it is. %2</source>
        <translation>%1 ist so nicht verwendbar. %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableViewModel</name>
    <message>
        <source>No table</source>
        <translation>Keine Tabelle</translation>
    </message>
    <message>
        <source>%1, step %2 · min %3, max %4, rms %5</source>
        <translation>%1, Schritt %2 · min. %3, max. %4, RMS %5</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>Kompensation</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TargetFiguresModel</name>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielposition</translation>
    </message>
    <message>
        <source>Values ↑</source>
        <translation>Werte ↑</translation>
    </message>
    <message>
        <source>Mean ↑</source>
        <translation>Mittel ↑</translation>
    </message>
    <message>
        <source>Values ↓</source>
        <translation>Werte ↓</translation>
    </message>
    <message>
        <source>Mean ↓</source>
        <translation>Mittel ↓</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::UnsavedChangesGuard</name>
    <message>
        <source>Discard and Chan&amp;ge Axis</source>
        <translation>Verwerfen und Achse &amp;wechseln</translation>
    </message>
    <message>
        <source>Discard and Chan&amp;ge Connections</source>
        <translation>Verwerfen und Verbindungen &amp;wechseln</translation>
    </message>
    <message>
        <source>Close Without Writin&amp;g</source>
        <translation>Ohne Schreiben s&amp;chließen</translation>
    </message>
    <message>
        <source>A write is in progress. Stopping rolls it back first.</source>
        <translation>Es wird gerade geschrieben. Beim Anhalten wird zuerst der alte Zustand wiederhergestellt.</translation>
    </message>
    <message>
        <source>&amp;Stop and Close</source>
        <translation>&amp;Stoppen und schließen</translation>
    </message>
    <message>
        <source>Close When Don&amp;e</source>
        <translation>Danac&amp;h schließen</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>Bleibe&amp;n</translation>
    </message>
    <message>
        <source>%1 has changes that are not written to the drive.</source>
        <translation>%1 hat Änderungen, die nicht in den Antrieb geschrieben sind.</translation>
    </message>
    <message>
        <source>Save Record, &amp;Then Close</source>
        <translation>S&amp;peichern, dann schließen</translation>
    </message>
    <message>
        <source>Close Without Savin&amp;g</source>
        <translation>Ohne Speichern schlie&amp;ßen</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesModel</name>
    <message>
        <source>Index %1</source>
        <translation>Index %1</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>Kompensation</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>im Antrieb</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesView</name>
    <message>
        <source>Values of the table</source>
        <translation>Werte der Tabelle</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy With Positions</source>
        <translation>Mit Positionen kopieren</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Copy the selected values, or all of them, with their positions for a spreadsheet. Ctrl+C copies the selected values alone.</source>
        <translation>Gewählte Werte oder alle mit ihren Positionen für eine Tabellenkalkulation kopieren. Strg+C kopiert die gewählten Werte allein.</translation>
    </message>
    <message>
        <source>Copy values</source>
        <translation>Werte kopieren</translation>
    </message>
    <message>
        <source>%1 across, %2 down, %3</source>
        <translation>%1 nach rechts, %2 nach unten, %3</translation>
    </message>
    <message>
        <source>Copied cells: %1</source>
        <translation>Kopierte Zellen: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::VectorView</name>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>How many times too large errors are drawn (+ and -)</source>
        <translation>Wievielfach zu groß die Fehler gezeichnet sind (+ und -)</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>&amp;Ganze Ansicht</translation>
    </message>
    <message>
        <source>Show the whole grid again (Home or a double click). The wheel, Page Up and Page Down zoom, dragging and the arrow keys move.</source>
        <translation>Wieder das ganze Gitter zeigen (Pos1 oder Doppelklick). Mausrad, Bild auf und Bild ab vergrößern und verkleinern, Ziehen und Pfeiltasten verschieben.</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>Als PNG, SVG oder PDF speichern</translation>
    </message>
    <message>
        <source>Grid with the errors of two axes</source>
        <translation>Gitter mit den Fehlern zweier Achsen</translation>
    </message>
    <message>
        <source>The column with the errors along %1</source>
        <translation>Die Spalte mit den Fehlern in Richtung %1</translation>
    </message>
    <message>
        <source>Thin: the grid as the encoders read it. Bold: where the axes really are, errors × %1.</source>
        <translation>Dünn: das Gitter, wie es die Geber anzeigen. Dick: wo die Achsen wirklich stehen, Fehler × %1.</translation>
    </message>
    <message>
        <source>The file has no errors of both axes of this slice: cut another dimension.</source>
        <translation>Die Datei hat nicht die Fehler beider Achsen dieses Schnitts: eine andere Dimension schneiden.</translation>
    </message>
    <message>
        <source>%1 and %2, errors × %3</source>
        <translation>%1 und %2, Fehler × %3</translation>
    </message>
    <message>
        <source>errors of two axes</source>
        <translation>Fehler zweier Achsen</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WarningList</name>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardController</name>
    <message>
        <source>Wait for the current operation before selecting another axis.</source>
        <translation>Erst nach dem Ende des laufenden Vorgangs kann eine andere Achse gewählt werden.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardLog</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WritePreview</name>
    <message>
        <source>persistent</source>
        <translation>dauerhaft</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>Nothing on the drive has changed yet. The old table and settings are backed up first.</source>
        <translation>Am Antrieb ist noch nichts geändert. Die alte Tabelle und die alten Einstellungen werden zuerst gesichert.</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Im Antrieb</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Do not show this again &amp;for volatile writes</source>
        <translation>Vor flüchtigem Schreiben nicht m&amp;ehr zeigen</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview; the menu turns it back on for volatile ones</source>
        <translation>Vor dauerhaftem Schreiben erscheint die Vorschau immer; für flüchtiges schaltet das Menü sie wieder ein</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Jetzt schreiben</translation>
    </message>
    <message>
        <source>Write this to the drive now</source>
        <translation>Das jetzt in den Antrieb schreiben</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>Zurü&amp;ck</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>Nichts ändern und zurückgehen (Esc)</translation>
    </message>
    <message>
        <source>What will be written to %1</source>
        <comment>axis and drive</comment>
        <translation>Was in %1 geschrieben wird</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Largest change</source>
        <translation>Größte Änderung</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>Dimensionalität</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Dim%1-Quelle</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Speicherung</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>keine Tabelle</translation>
    </message>
    <message>
        <source>Uses no flash operation. Volatile: lost on a reboot.</source>
        <translation>Braucht keinen Flash-Vorgang. Flüchtig: geht beim Neustart verloren.</translation>
    </message>
    <message>
        <source>Uses no flash operation: the flash already holds it.</source>
        <translation>Braucht keinen Flash-Vorgang: der Flash-Speicher hat es bereits.</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>Flash-Vorgänge: %1 verbraucht, gleich danach noch %2 übrig.</translation>
    </message>
    <message>
        <source>%1 held an earlier table of this axis; the current one stays complete until the axis has switched to the new one.</source>
        <translation>%1 enthielt eine frühere Tabelle dieser Achse; die jetzige bleibt vollständig, bis die Achse auf die neue umgeschaltet ist.</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>possibly not saved</source>
        <translation>womöglich nicht gespeichert</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>Diese großen Korrekturen sind &amp;richtig: ihre Einheit wurde geprüft</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>Bestätigen Sie zuerst die großen Korrekturen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete this from the drive now</source>
        <translation>Dies jetzt vom Antrieb löschen</translation>
    </message>
    <message>
        <source>What will be deleted from %1</source>
        <comment>axis and drive</comment>
        <translation>Was auf %1 gelöscht wird</translation>
    </message>
    <message>
        <source>empty</source>
        <comment>slot</comment>
        <translation>leer</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>Braucht keinen Flash-Vorgang.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>What will be restored on %1</source>
        <comment>axis and drive</comment>
        <translation>Was auf %1 wiederhergestellt wird</translation>
    </message>
    <message>
        <source>This is what the axis had before the write of %1.</source>
        <translation>Das hatte die Achse vor dem Schreiben vom %1.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>This is the state in the backup file of %1.</source>
        <translation>Das ist der Zustand in der Sicherungsdatei vom %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberBox</name>
    <message>
        <source>%1: %2</source>
        <comment>field and problem</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlotStyle</name>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
</context>
</TS>
