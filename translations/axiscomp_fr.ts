<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>ColumnRole</name>
    <message>
        <source>target</source>
        <translation>position cible</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>sens</translation>
    </message>
    <message>
        <source>run</source>
        <translation>passe</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>écart</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>codeur</translation>
    </message>
    <message>
        <source>output</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>température</translation>
    </message>
    <message>
        <source>use</source>
        <translation>utilisé</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>clock</source>
        <translation>horloge</translation>
    </message>
    <message>
        <source>{now} is before the program was made, {made}</source>
        <translation>{now} est antérieur à la compilation du programme, {made}</translation>
    </message>
    <message>
        <source>set the clock (timedatectl says what it follows): flash operations are counted by it</source>
        <translation>régler l&apos;horloge (timedatectl indique sa source)&#xa0;: les opérations flash sont comptées d&apos;après elle</translation>
    </message>
    <message>
        <source>display</source>
        <translation>affichage</translation>
    </message>
    <message>
        <source>unset it if the window does not appear</source>
        <translation>supprimer cette variable si la fenêtre n&apos;apparaît pas</translation>
    </message>
    <message>
        <source>none; the window needs one</source>
        <translation>aucun&#xa0;; la fenêtre en exige un</translation>
    </message>
    <message>
        <source>start the window on the desktop, or over ssh -X; the command line does without</source>
        <translation>lancer la fenêtre depuis le bureau ou par ssh -X&#xa0;; la ligne de commande s&apos;en passe</translation>
    </message>
    <message>
        <source>temporary folder</source>
        <translation>dossier temporaire</translation>
    </message>
    <message>
        <source>{folder} is not there</source>
        <translation>{folder} n&apos;existe pas</translation>
    </message>
    <message>
        <source>make it, or set {variable} to another folder</source>
        <translation>le créer, ou régler {variable} sur un autre dossier</translation>
    </message>
    <message>
        <source>{folder}, {free} free</source>
        <translation>{folder}, {free} libres</translation>
    </message>
    <message>
        <source>runtime folder</source>
        <translation>dossier d&apos;exécution</translation>
    </message>
    <message>
        <source>log in at the desktop or over ssh, and not by su or sudo, if the window does not appear</source>
        <translation>si la fenêtre n&apos;apparaît pas, ouvrir la session sur le bureau ou par ssh, et non par su ou sudo</translation>
    </message>
    <message>
        <source>XDG_RUNTIME_DIR is not set</source>
        <translation>XDG_RUNTIME_DIR n&apos;est pas définie</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}</source>
        <translation>{folder} appartient à {owner}</translation>
    </message>
    <message>
        <source>proxies</source>
        <translation>serveurs proxy</translation>
    </message>
    <message>
        <source>none</source>
        <translation>néant</translation>
    </message>
    <message>
        <source>{variables}: drives are reached without a proxy all the same</source>
        <translation>{variables}&#xa0;: les variateurs sont malgré tout joints sans proxy</translation>
    </message>
    <message>
        <source>no variable is set</source>
        <translation>aucune variable définie</translation>
    </message>
    <message>
        <source>locale</source>
        <translation>paramètres régionaux</translation>
    </message>
    <message>
        <source>{variables}: this locale is not installed</source>
        <translation>{variables}&#xa0;: ces paramètres régionaux ne sont pas installés</translation>
    </message>
    <message>
        <source>{variables}: its encoding {encoding} is not UTF-8, so that letters outside of ASCII may look wrong</source>
        <translation>{variables}&#xa0;: le codage {encoding} n&apos;est pas UTF-8&#xa0;; les lettres hors ASCII peuvent s&apos;afficher mal</translation>
    </message>
    <message>
        <source>export LC_ALL=C.UTF-8, or the locale of your language with UTF-8</source>
        <translation>export LC_ALL=C.UTF-8, ou les paramètres régionaux de la langue voulue en UTF-8</translation>
    </message>
    <message>
        <source>{variables}: {encoding}</source>
        <translation>{variables}&#xa0;: {encoding}</translation>
    </message>
    <message>
        <source>set {variable} to a folder of your own</source>
        <translation>régler {variable} sur un dossier personnel</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} is no folder</source>
        <translation>{folder} n&apos;est pas utilisable&#xa0;: {nearest} n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>{folder} cannot be used: you have no permission to look into {nearest}</source>
        <translation>{folder} n&apos;est pas utilisable&#xa0;: droits insuffisants pour accéder à {nearest}</translation>
    </message>
    <message>
        <source>{folder} is on a file system that is read-only</source>
        <translation>{folder} se trouve sur un système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} belongs to {owner}, and you have no permission to change it</source>
        <translation>{folder} n&apos;est pas utilisable&#xa0;: {nearest} appartient à {owner}, droits insuffisants pour le modifier</translation>
    </message>
    <message>
        <source>{folder} has only {free} free</source>
        <translation>{folder} n&apos;a plus que {free} libres</translation>
    </message>
    <message>
        <source>{folder} is on a file system that takes no more files, with {free} free</source>
        <translation>{folder} se trouve sur un système de fichiers qui n&apos;accepte plus de fichiers, avec {free} libres</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to a folder of another disk</source>
        <translation>y libérer de la place, ou régler {variable} sur un dossier d&apos;un autre disque</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>information non disponible</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>system</source>
        <translation>système</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>noyau</translation>
    </message>
    <message>
        <source>processor cores</source>
        <translation>cœurs du processeur</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>mémoire</translation>
    </message>
    <message>
        <source>{all}, {free} free</source>
        <translation>{all}, {free} libres</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>decimal sign</source>
        <translation>signe décimal</translation>
    </message>
    <message>
        <source>&quot;{sign}&quot;; the command line writes and reads a point</source>
        <translation>«&#xa0;{sign}&#xa0;»&#xa0;; la ligne de commande écrit et lit un point</translation>
    </message>
    <message>
        <source>translations</source>
        <translation>traductions</translation>
    </message>
    <message>
        <source>window settings</source>
        <translation>réglages de la fenêtre</translation>
    </message>
    <message>
        <source>none; the window was not used yet</source>
        <translation>aucun&#xa0;; la fenêtre n&apos;a pas encore été utilisée</translation>
    </message>
    <message>
        <source>{file} is not a file that you may read</source>
        <translation>{file} n&apos;est pas un fichier accessible en lecture</translation>
    </message>
    <message>
        <source>move it away; the window begins a new one</source>
        <translation>le déplacer ailleurs&#xa0;; la fenêtre en crée un nouveau</translation>
    </message>
    <message>
        <source>{file} is damaged</source>
        <translation>{file} est endommagé</translation>
    </message>
    <message>
        <source>{file}, connections: {number}</source>
        <translation>{file}, connexions&#xa0;: {number}</translation>
    </message>
    <message>
        <source>drive profile</source>
        <translation>profil de variateur</translation>
    </message>
    <message>
        <source>{profile}, built in</source>
        <translation>{profile}, intégré</translation>
    </message>
    <message>
        <source>trusted certificates</source>
        <translation>certificats acceptés</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>open {drive} in a browser of this computer; if it does not answer there either, look at power, cable and network</source>
        <translation>ouvrir {drive} dans un navigateur de cet ordinateur&#xa0;; s&apos;il n&apos;y répond pas non plus, vérifier alimentation, câble et réseau</translation>
    </message>
    <message>
        <source>look at power and cable; `axiscomp axes --find --any-baud` tries other speeds</source>
        <translation>vérifier alimentation et câble&#xa0;; `axiscomp axes --find --any-baud` essaie d&apos;autres débits</translation>
    </message>
    <message>
        <source>address</source>
        <translation>adresse</translation>
    </message>
    <message>
        <source>{drive}, serial number {serial}, axes: {axes}, profile {profile}; answered after {milliseconds}</source>
        <translation>{drive}, numéro de série {serial}, axes&#xa0;: {axes}, profil {profile}&#xa0;; a répondu en {milliseconds}</translation>
    </message>
    <message>
        <source>{drive}; then: {error}</source>
        <translation>{drive}&#xa0;; ensuite&#xa0;: {error}</translation>
    </message>
    <message>
        <source>{unit}, {homing}, compensation {state}</source>
        <translation>{unit}, {homing}, compensation {state}</translation>
    </message>
    <message>
        <source>{state}, no table</source>
        <translation>{state}, aucune table</translation>
    </message>
    <message>
        <source>{state}, table {slot} with CRC {crc}</source>
        <translation>{state}, table {slot}, CRC {crc}</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>axe {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>axe {axis} ({name})</translation>
    </message>
    <message>
        <source>it has no compensation registers by this profile</source>
        <translation>il n&apos;a pas de registres de compensation selon ce profil</translation>
    </message>
    <message>
        <source>drive error</source>
        <translation>erreur du variateur</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Variateurs</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>variateurs</translation>
    </message>
    <message>
        <source>none is known</source>
        <translation>aucun n&apos;est connu</translation>
    </message>
    <message>
        <source>add a connection in the window, or give --drive ADDRESS</source>
        <translation>ajouter une connexion dans la fenêtre, ou indiquer --drive ADRESSE</translation>
    </message>
    <message>
        <source>{version}, built with {other}</source>
        <translation>{version}, compilé avec {other}</translation>
    </message>
    <message>
        <source>there is no TLS library: https drives cannot be reached</source>
        <translation>aucune bibliothèque TLS&#xa0;: les variateurs en https ne sont pas accessibles</translation>
    </message>
    <message>
        <source>install OpenSSL (sudo apt install libssl3)</source>
        <translation>installer OpenSSL (sudo apt install libssl3)</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>not installed; the command line does without</source>
        <translation>non installée&#xa0;; la ligne de commande s&apos;en passe</translation>
    </message>
    <message>
        <source>reports</source>
        <translation>rapports</translation>
    </message>
    <message>
        <source>what draws PDF is not installed</source>
        <translation>le module qui produit les PDF n&apos;est pas installé</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>version</source>
        <translation>version</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programme</translation>
    </message>
    <message>
        <source>a port without a name</source>
        <translation>port sans nom</translation>
    </message>
    <message>
        <source>{hardware}, built in</source>
        <translation>{hardware}, intégré</translation>
    </message>
    <message>
        <source>{hardware}, USB {id}</source>
        <translation>{hardware}, USB {id}</translation>
    </message>
    <message>
        <source>{hardware}: {problem}</source>
        <translation>{hardware}&#xa0;: {problem}</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>Ports série</translation>
    </message>
    <message>
        <source>ports</source>
        <translation>ports</translation>
    </message>
    <message>
        <source>this computer has none</source>
        <translation>cet ordinateur n&apos;en a pas</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>dossier</translation>
    </message>
    <message>
        <source>sudo chown -R $USER {folder}; run this program without sudo</source>
        <translation>sudo chown -R $USER {folder}&#xa0;; lancer ce programme sans sudo</translation>
    </message>
    <message>
        <source>{folder} is yours, but its permissions keep you out</source>
        <translation>{folder} appartient à l&apos;utilisateur actuel, mais ses droits en interdisent l&apos;accès</translation>
    </message>
    <message>
        <source>{folder} is not there yet; the first write makes it</source>
        <translation>{folder} n&apos;existe pas encore&#xa0;; la première écriture le crée</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}, and you are root: what is made there now belongs to root</source>
        <translation>{folder} appartient à {owner}, et l&apos;utilisateur actuel est root&#xa0;: ce qui y est créé maintenant appartient à root</translation>
    </message>
    <message>
        <source>run this program without sudo</source>
        <translation>lancer ce programme sans sudo</translation>
    </message>
    <message>
        <source>{folder} can be changed by other users</source>
        <translation>{folder} est modifiable par d&apos;autres utilisateurs</translation>
    </message>
    <message>
        <source>file system</source>
        <translation>système de fichiers</translation>
    </message>
    <message>
        <source>on the network, where a database can be damaged: nothing is kept there, and no write begins</source>
        <translation>sur le réseau, où une base de données peut être endommagée&#xa0;: rien n&apos;y est conservé, et aucune écriture ne commence</translation>
    </message>
    <message>
        <source>set {variable} to a folder on this computer</source>
        <translation>régler {variable} sur un dossier de cet ordinateur</translation>
    </message>
    <message>
        <source>in memory: backups and journal are gone after a restart</source>
        <translation>en mémoire&#xa0;: les sauvegardes et le journal de reprise sont perdus au redémarrage</translation>
    </message>
    <message>
        <source>set {variable} to a folder on a disk</source>
        <translation>régler {variable} sur un dossier d&apos;un disque</translation>
    </message>
    <message>
        <source>of this computer</source>
        <translation>de cet ordinateur</translation>
    </message>
    <message>
        <source>database</source>
        <translation>base de données</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>la déplacer ailleurs</translation>
    </message>
    <message>
        <source>none yet; the first write makes it</source>
        <translation>aucune pour l&apos;instant&#xa0;; la première écriture la crée</translation>
    </message>
    <message>
        <source>of an older version, {size}; the next command that needs it brings it up to date</source>
        <translation>d&apos;une version plus ancienne, {size}&#xa0;; la prochaine commande qui en a besoin la met à jour</translation>
    </message>
    <message>
        <source>a newer version of this program has written it</source>
        <translation>écrite par une version plus récente de ce programme</translation>
    </message>
    <message>
        <source>use that version</source>
        <translation>utiliser cette version</translation>
    </message>
    <message>
        <source>it is the database of another program</source>
        <translation>c&apos;est la base de données d&apos;un autre programme</translation>
    </message>
    <message>
        <source>it is damaged ({reason})</source>
        <translation>endommagée ({reason})</translation>
    </message>
    <message>
        <source>the next command that needs it sets it aside and keeps what can be read; look what the drives hold, then `axiscomp status --reset-flash-count` for each</source>
        <translation>la prochaine commande qui en a besoin la met de côté et conserve ce qui est lisible&#xa0;; vérifier l&apos;état des variateurs, puis exécuter `axiscomp status --reset-flash-count` pour chacun</translation>
    </message>
    <message>
        <source>not checked, because programs write to it all the time</source>
        <translation>non vérifiée, car des programmes y écrivent sans cesse</translation>
    </message>
    <message>
        <source>try again when they have finished</source>
        <translation>réessayer quand ils auront terminé</translation>
    </message>
    <message>
        <source>you have no permission to change it</source>
        <translation>droits insuffisants pour la modifier</translation>
    </message>
    <message>
        <source>let the user have it to whom the folder belongs (chown, chmod u+rw)</source>
        <translation>l&apos;attribuer au propriétaire du dossier (chown, chmod u+rw)</translation>
    </message>
    <message>
        <source>whole, {size}</source>
        <translation>intacte, {size}</translation>
    </message>
    <message>
        <source>interrupted write</source>
        <translation>écriture interrompue</translation>
    </message>
    <message>
        <source>write</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>a program is writing to axis {axis} of the drive with serial number {drive} now, since {time} ({step})</source>
        <translation>un programme écrit actuellement l&apos;axe {axis} du variateur de numéro de série {drive}, depuis le {time} ({step})</translation>
    </message>
    <message>
        <source>a write to axis {axis} of the drive with serial number {drive} began at {time} and did not end (step {step})</source>
        <translation>une écriture de l&apos;axe {axis} du variateur de numéro de série {drive} a commencé le {time} et ne s&apos;est pas terminée (étape {step})</translation>
    </message>
    <message>
        <source>`axiscomp recover --axis {axis}` with that drive says what it holds, and finishes the write or undoes it</source>
        <translation>`axiscomp recover --axis {axis}` avec ce variateur indique son état, et achève l&apos;écriture ou l&apos;annule</translation>
    </message>
    <message>
        <source>interrupted writes</source>
        <translation>écritures interrompues</translation>
    </message>
    <message>
        <source>flash record</source>
        <translation>décompte flash</translation>
    </message>
    <message>
        <source>that of the drive with serial number {drive} was damaged: its flash operations count as used up</source>
        <translation>celui du variateur de numéro de série {drive} était endommagé&#xa0;: ses opérations flash sont toutes considérées comme utilisées</translation>
    </message>
    <message>
        <source>wait as long as the drive counts them, then `axiscomp status --reset-flash-count`</source>
        <translation>attendre aussi longtemps que le variateur les compte, puis exécuter `axiscomp status --reset-flash-count`</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>mise de côté</translation>
    </message>
    <message>
        <source>{file} is an earlier database that was damaged</source>
        <translation>{file} est une ancienne base de données qui était endommagée</translation>
    </message>
    <message>
        <source>delete it when nothing is missed</source>
        <translation>la supprimer si rien ne manque</translation>
    </message>
    <message>
        <source>last change</source>
        <translation>dernière modification</translation>
    </message>
    <message>
        <source>{time} is still to come: the clock was set back since</source>
        <translation>{time} est dans le futur&#xa0;: l&apos;horloge a été retardée depuis</translation>
    </message>
    <message>
        <source>look at the clock: flash operations are counted by it</source>
        <translation>vérifier l&apos;horloge&#xa0;: les opérations flash sont comptées d&apos;après elle</translation>
    </message>
    <message>
        <source>backups</source>
        <translation>sauvegardes</translation>
    </message>
    <message>
        <source>files: {backups}, drives: {drives}, {size}</source>
        <translation>fichiers&#xa0;: {backups}, variateurs&#xa0;: {drives}, {size}</translation>
    </message>
    <message>
        <source>State folder</source>
        <translation>Dossier d&apos;état</translation>
    </message>
    <message>
        <source>sudo apt install locales and sudo dpkg-reconfigure locales, or export LC_ALL=C.UTF-8</source>
        <translation>sudo apt install locales et sudo dpkg-reconfigure locales, ou export LC_ALL=C.UTF-8</translation>
    </message>
    <message>
        <source>if the drive has the same fingerprint: `axiscomp axes --drive {drive} --trust-certificate {fingerprint}` trusts it from then on</source>
        <translation>si le variateur a la même empreinte&#xa0;: `axiscomp axes --drive {drive} --trust-certificate {fingerprint}` lui fait confiance désormais</translation>
    </message>
    <message>
        <source>install the package {package}</source>
        <translation>installer le paquet {package}</translation>
    </message>
    <message>
        <source>install the package {package}, or write the report as HTML and print that</source>
        <translation>installer le paquet {package}, ou écrire le rapport en HTML et l&apos;imprimer</translation>
    </message>
    <message>
        <source>not checked: {reason}</source>
        <translation>non vérifié&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to another folder</source>
        <translation>y libérer de la place ou indiquer un autre dossier dans {variable}</translation>
    </message>
    <message>
        <source>not checked, because no copy could be made in the temporary folder</source>
        <translation>non vérifiée, car aucune copie n&apos;a pu être créée dans le dossier temporaire</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>{size} bytes</source>
        <translation>{size} octets</translation>
    </message>
    <message>
        <source>at most {size} bytes</source>
        <translation>au plus {size} octets</translation>
    </message>
    <message>
        <source>at most {count} columns</source>
        <translation>au plus {count} colonnes</translation>
    </message>
    <message>
        <source>a line with the names of the columns, not only comments</source>
        <translation>une ligne avec les noms des colonnes, pas seulement des commentaires</translation>
    </message>
    <message>
        <source>no data lines after the header</source>
        <translation>aucune ligne de données après l&apos;en-tête</translation>
    </message>
    <message>
        <source>at least 2 positions in each dimension, one line per grid point</source>
        <translation>au moins 2 positions dans chaque dimension, une ligne par point de grille</translation>
    </message>
    <message>
        <source>the names of the columns, not numbers</source>
        <translation>les noms des colonnes, pas des nombres</translation>
    </message>
    <message>
        <source>at least {count} for dimensionality {dimensions}, {positions} of positions and 1 of values</source>
        <translation>au moins {count} pour la dimensionnalité {dimensions}, dont {positions} de positions et 1 de valeurs</translation>
    </message>
    <message>
        <source>{expected} (or is the dimensionality {dimensions}?)</source>
        <translation>{expected} (ou la dimensionnalité est-elle {dimensions}&#xa0;?)</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ;</source>
        <translation>{expected}&#xa0;; séparer les colonnes par , ou&#xa0;;</translation>
    </message>
    <message>
        <source>{expected}; if the commas are decimal commas, separate the columns with ; in every line</source>
        <translation>{expected}&#xa0;; si les virgules sont des virgules décimales, séparer les colonnes par&#xa0;; dans chaque ligne</translation>
    </message>
    <message>
        <source>{expected}; the header separates its columns with {separator}, so every line must</source>
        <translation>{expected}&#xa0;; l&apos;en-tête sépare ses colonnes par {separator}, chaque ligne doit en faire autant</translation>
    </message>
    <message>
        <source>{expected}; decimal commas need the separator ; in every line</source>
        <translation>{expected}&#xa0;; les virgules décimales exigent le séparateur&#xa0;; dans chaque ligne</translation>
    </message>
    <message>
        <source>{count} as in the header (line {line})</source>
        <translation>{count} comme dans l&apos;en-tête (ligne {line})</translation>
    </message>
    <message>
        <source>a closing &quot; in the same line</source>
        <translation>un &quot; fermant dans la même ligne</translation>
    </message>
    <message>
        <source>a separator after the closing &quot;</source>
        <translation>un séparateur après le &quot; fermant</translation>
    </message>
    <message>
        <source>a separator or the end of the line after the closing &quot;</source>
        <translation>un séparateur ou la fin de la ligne après le &quot; fermant</translation>
    </message>
    <message>
        <source>a number such as {example}</source>
        <translation>un nombre tel que {example}</translation>
    </message>
    <message>
        <source>a finite number such as {example}</source>
        <translation>un nombre fini tel que {example}</translation>
    </message>
    <message>
        <source>0 or a number that is not as close to it</source>
        <translation>0 ou un nombre moins proche de 0</translation>
    </message>
    <message>
        <source>a value that fits float32 (below 3.4e38)</source>
        <translation>une valeur représentable en float32 (inférieure à 3.4e38)</translation>
    </message>
    <message>
        <source>a decimal comma as in line {line}</source>
        <translation>une virgule décimale comme à la ligne {line}</translation>
    </message>
    <message>
        <source>a decimal point as in line {line}</source>
        <translation>un point décimal comme à la ligne {line}</translation>
    </message>
    <message>
        <source>no sign between the thousands</source>
        <translation>aucun séparateur de milliers</translation>
    </message>
    <message>
        <source>more than {rows} data lines of {columns} columns</source>
        <translation>plus de {rows} lignes de données de {columns} colonnes</translation>
    </message>
    <message>
        <source>at most {cells} cells (lines x columns)</source>
        <translation>au plus {cells} cellules (lignes x colonnes)</translation>
    </message>
    <message>
        <source>positions with a finite range</source>
        <translation>des positions d&apos;étendue finie</translation>
    </message>
    <message>
        <source>positions whose distance a double can hold</source>
        <translation>des positions dont la distance est représentable en double</translation>
    </message>
    <message>
        <source>{position} (steps of {distance})</source>
        <translation>{position} (pas de {distance})</translation>
    </message>
    <message>
        <source>{position} next to {before}</source>
        <translation>{position} à côté de {before}</translation>
    </message>
    <message>
        <source>{position} on an even line in steps of {distance}</source>
        <translation>{position} à pas régulier de {distance}</translation>
    </message>
    <message>
        <source>only {position}</source>
        <translation>seulement {position}</translation>
    </message>
    <message>
        <source>at least 2 different positions</source>
        <translation>au moins 2 positions différentes</translation>
    </message>
    <message>
        <source>{point} in line {first} and again in line {second}</source>
        <translation>{point} à la ligne {first} et de nouveau à la ligne {second}</translation>
    </message>
    <message>
        <source>every position once</source>
        <translation>chaque position une seule fois</translation>
    </message>
    <message>
        <source>no line for {points} (missing: {missing} of {all} points)</source>
        <translation>aucune ligne pour {points} (il manque {missing} points sur {all})</translation>
    </message>
    <message>
        <source>{value} at every point of {table}</source>
        <translation>{value} à chaque point de {table}</translation>
    </message>
    <message>
        <source>values that differ</source>
        <translation>des valeurs différentes</translation>
    </message>
    <message>
        <source>a change of {change}</source>
        <translation>une variation de {change}</translation>
    </message>
    <message>
        <source>at most a millionth of the largest value, {value}</source>
        <translation>au plus un millionième de la plus grande valeur, {value}</translation>
    </message>
    <message>
        <source>a step from {from} to {to} over {distance} in dimension {dimension}</source>
        <translation>un saut de {from} à {to} sur {distance} dans la dimension {dimension}</translation>
    </message>
    <message>
        <source>at most 0.01 per unit of position</source>
        <translation>au plus 0,01 par unité de position</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>un texte en UTF-16</translation>
    </message>
    <message>
        <source>a spreadsheet workbook or ZIP archive</source>
        <translation>un classeur de tableur ou une archive ZIP</translation>
    </message>
    <message>
        <source>an old Excel workbook</source>
        <translation>un ancien classeur Excel</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>a compressed file (gzip)</source>
        <translation>un fichier compressé (gzip)</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>une image</translation>
    </message>
    <message>
        <source>a TAM table</source>
        <translation>une table TAM</translation>
    </message>
    <message>
        <source>a binary file</source>
        <translation>un fichier binaire</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>un octet NUL</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>un fichier texte</translation>
    </message>
    <message>
        <source>the byte 0x{byte} ({character})</source>
        <translation>l&apos;octet 0x{byte} ({character})</translation>
    </message>
    <message>
        <source>file length</source>
        <translation>longueur du fichier</translation>
    </message>
    <message>
        <source>element {number}</source>
        <translation>élément {number}</translation>
    </message>
    <message>
        <source>{size} for the header and 4 for each of the {count} elements</source>
        <translation>{size} pour l&apos;en-tête et 4 pour chacun des {count} éléments</translation>
    </message>
    <message>
        <source>at least the {size} bytes of the header</source>
        <translation>au moins les {size} octets de l&apos;en-tête</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 ou 1</translation>
    </message>
    <message>
        <source>1, 2 or 3</source>
        <translation>1, 2 ou 3</translation>
    </message>
    <message>
        <source>2 or more</source>
        <translation>2 ou plus</translation>
    </message>
    <message>
        <source>1, because this dimension is not used</source>
        <translation>1, car cette dimension n&apos;est pas utilisée</translation>
    </message>
    <message>
        <source>{count}, the product of the sizes</source>
        <translation>{count}, le produit des tailles</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un nombre fini</translation>
    </message>
    <message>
        <source>a finite number above 0</source>
        <translation>un nombre fini supérieur à 0</translation>
    </message>
    <message>
        <source>one that leads to a finite last position</source>
        <translation>une valeur qui donne une dernière position finie</translation>
    </message>
    <message>
        <source>one that tells positions such as {position} apart</source>
        <translation>une valeur qui permet de distinguer des positions telles que {position}</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the header before it</source>
        <translation>{crc}, le CRC de l&apos;en-tête qui précède</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the elements</source>
        <translation>{crc}, le CRC des éléments</translation>
    </message>
    <message>
        <source>the size of dimension {dimension} is {value}, at least 2 is needed</source>
        <translation>la taille de la dimension {dimension} est {value}, il faut au moins 2</translation>
    </message>
    <message>
        <source>the start value of dimension {dimension} is {value}, a finite number is needed</source>
        <translation>la valeur initiale de la dimension {dimension} est {value}, il faut un nombre fini</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, a finite number above 0 is needed</source>
        <translation>le pas de la dimension {dimension} est {value}, il faut un nombre fini supérieur à 0</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, too little to tell positions such as {position} apart</source>
        <translation>le pas de la dimension {dimension} est {value}, trop petit pour distinguer des positions telles que {position}</translation>
    </message>
    <message>
        <source>the last position of dimension {dimension} is too large to be a number</source>
        <translation>la dernière position de la dimension {dimension} est trop grande pour être un nombre</translation>
    </message>
    <message>
        <source>the table has {count} dimensions, 1 to 3 are possible</source>
        <translation>la table a {count} dimensions, 1 à 3 sont possibles</translation>
    </message>
    <message>
        <source>the table has {count} values, which is not the product of its sizes</source>
        <translation>la table a {count} valeurs, ce qui n&apos;est pas le produit de ses tailles</translation>
    </message>
    <message>
        <source>the table has more values than a file can count</source>
        <translation>la table a plus de valeurs qu&apos;un fichier ne peut en compter</translation>
    </message>
    <message>
        <source>value {number} is {value}, a finite number is needed</source>
        <translation>la valeur {number} est {value}, il faut un nombre fini</translation>
    </message>
    <message>
        <source>the table cannot be kept in this drive&apos;s table file: {reason}</source>
        <translation>la table ne peut pas être conservée dans le fichier de table de ce variateur&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{value} does not fit into the field {field}, which is of type {type}</source>
        <translation>{value} ne tient pas dans le champ {field}, de type {type}</translation>
    </message>
    <message>
        <source>the grid of dimension {dimension}, start {start} and distance {distance}, cannot be held by fields of the types {first} and {second}</source>
        <translation>la grille de la dimension {dimension}, de début {start} et de pas {distance}, n&apos;est pas représentable par des champs des types {first} et {second}</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>arrêté par l&apos;utilisateur</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}</source>
        <translation>lecture de {file} impossible&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}</source>
        <translation>écriture de {file} impossible&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{file} has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{file} fait {size} octets&#xa0;; un tel fichier peut en avoir {limit} au plus</translation>
    </message>
    <message>
        <source>this is not a valid TAM table: {field} at offset {offset} is {found}, expected {expected}</source>
        <translation>ce n&apos;est pas une table TAM valide&#xa0;: {field} à l&apos;octet {offset} est {found}, attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>the drive profile {file} is wrong at {path}: {reason}</source>
        <translation>erreur dans le profil de variateur {file}, à {path}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the TAM configuration {file} is wrong in line {line}: {reason}</source>
        <translation>erreur dans la configuration TAM {file}, ligne {line}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{file} is not a valid backup: {reason}</source>
        <translation>{file} n&apos;est pas une sauvegarde valide&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}</source>
        <translation>le format de {file} est inconnu&#xa0;; en indiquer un parmi&#xa0;: {known}</translation>
    </message>
    <message>
        <source>the name {file} says no format that can be written; name one with --to: {known}</source>
        <translation>le nom {file} n&apos;indique aucun format pouvant être écrit&#xa0;; en indiquer un avec --to&#xa0;: {known}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}; of any other CSV file, say which column is what</source>
        <translation>le format de {file} est inconnu&#xa0;; en indiquer un parmi&#xa0;: {known}&#xa0;; pour tout autre fichier CSV, indiquer le rôle des colonnes</translation>
    </message>
    <message>
        <source>there is no table {table} in the file; it has: {known}</source>
        <translation>le fichier ne contient pas de table {table}&#xa0;; tables présentes&#xa0;: {known}</translation>
    </message>
    <message>
        <source>{endpoint} is not the address of a drive: {reason}</source>
        <translation>{endpoint} n&apos;est pas l&apos;adresse d&apos;un variateur&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>no connection to {endpoint}: {reason}</source>
        <translation>pas de connexion à {endpoint}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the connection to {endpoint} was lost: {reason}</source>
        <translation>la connexion à {endpoint} a été perdue&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{endpoint} did not answer within {seconds} s</source>
        <translation>{endpoint} n&apos;a pas répondu en {seconds} s</translation>
    </message>
    <message>
        <source>{endpoint} did not answer as a drive does: expected {expected}, got {quote}</source>
        <translation>{endpoint} ne répond pas comme un variateur&#xa0;: attendu {expected}, reçu {quote}</translation>
    </message>
    <message>
        <source>the drive refused: {reason}</source>
        <translation>refusé par le variateur&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the drive has no register {path}</source>
        <translation>le variateur n&apos;a pas de registre {path}</translation>
    </message>
    <message>
        <source>the drive has no file {path}</source>
        <translation>le variateur n&apos;a pas de fichier {path}</translation>
    </message>
    <message>
        <source>the drive does not allow this now: {reason}</source>
        <translation>le variateur ne le permet pas actuellement&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the table does not fit: {reason}</source>
        <translation>la table ne convient pas&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the drive refused the table: {reason}</source>
        <translation>le variateur a refusé la table&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s, or write volatile</source>
        <translation>trop d&apos;opérations flash en peu de temps&#xa0;; attendre {seconds} s ou écrire en volatil</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is in error {error}: {hint}</source>
        <translation>la compensation de l&apos;axe {axis} est en erreur {error}&#xa0;: {hint}</translation>
    </message>
    <message>
        <source>the drive has no axis {axis}; it has: {known}</source>
        <translation>le variateur n&apos;a pas d&apos;axe {axis}&#xa0;; axes présents&#xa0;: {known}</translation>
    </message>
    <message>
        <source>several axes are named {axis}: give the index, one of {matches}</source>
        <translation>plusieurs axes s&apos;appellent {axis}&#xa0;: indiquer l&apos;indice, parmi {matches}</translation>
    </message>
    <message>
        <source>axis {axis} of this drive has no compensation registers</source>
        <translation>l&apos;axe {axis} de ce variateur n&apos;a pas de registres de compensation</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} is missing</source>
        <translation>la source de la dimension {dimension} manque</translation>
    </message>
    <message>
        <source>the drive has no register {source}{nearest}</source>
        <translation>le variateur n&apos;a pas de registre {source}{nearest}</translation>
    </message>
    <message>
        <source>{source} is of type {type}; a dimension source must be one of {allowed}</source>
        <translation>{source} est de type {type}&#xa0;; une source de dimension doit être de l&apos;un de ces types&#xa0;: {allowed}</translation>
    </message>
    <message>
        <source>{source} is a register of the drive {other}; a source must be on the drive itself, {drive}</source>
        <translation>{source} est un registre du variateur {other}&#xa0;; une source doit être sur le variateur lui-même, {drive}</translation>
    </message>
    <message>
        <source>{source} is the source of both dimension {first} and dimension {second}</source>
        <translation>{source} est la source à la fois de la dimension {first} et de la dimension {second}</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or correct the unit in the file</source>
        <translation>{doubt} Choisir une autre source ou colonne, ou corriger l&apos;unité dans le fichier</translation>
    </message>
    <message>
        <source>the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds {largest}</source>
        <translation>la table nécessite {size} octets, mais le plus grand emplacement disponible, {slot}, n&apos;en contient que {largest}</translation>
    </message>
    <message>
        <source>the drive has no slot {slot}; it has: {known}</source>
        <translation>le variateur n&apos;a pas d&apos;emplacement {slot}&#xa0;; emplacements présents&#xa0;: {known}</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}</source>
        <translation>l&apos;emplacement {slot} est déjà utilisé&#xa0;: {user}</translation>
    </message>
    <message>
        <source>no slot is free for a table of {size} bytes: {slots}; name one to overwrite it</source>
        <translation>aucun emplacement n&apos;est libre pour une table de {size} octets&#xa0;: {slots}&#xa0;; en indiquer un à écraser</translation>
    </message>
    <message>
        <source>axis {axis} has no table on the drive; write one first</source>
        <translation>l&apos;axe {axis} n&apos;a pas de table sur le variateur&#xa0;; en écrire d&apos;abord une</translation>
    </message>
    <message>
        <source>axis {axis} already has all of this; there is nothing to write</source>
        <translation>l&apos;axe {axis} a déjà tout cela&#xa0;; il n&apos;y a rien à écrire</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is active; deactivate it first</source>
        <translation>la compensation de l&apos;axe {axis} est active&#xa0;; la désactiver d&apos;abord</translation>
    </message>
    <message>
        <source>axis {axis} must be homed first</source>
        <translation>effectuer d&apos;abord la prise d&apos;origine de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>this is another drive: expected serial number {expected}, found {found}</source>
        <translation>c&apos;est un autre variateur&#xa0;: numéro de série attendu {expected}, trouvé {found}</translation>
    </message>
    <message>
        <source>somebody else changed {what} from {before} to {now}; nothing was written, look again</source>
        <translation>modifié entre-temps&#xa0;: {what}, avant {before}, maintenant {now}&#xa0;; rien n&apos;a été écrit, vérifier de nouveau</translation>
    </message>
    <message>
        <source>{what} read back as {found}, but {expected} was written</source>
        <translation>{what}&#xa0;: relu {found}, mais écrit {expected}</translation>
    </message>
    <message>
        <source>the drive does not add what it should: {what} at {position} is {found}, expected {expected}</source>
        <translation>le variateur n&apos;ajoute pas ce qu&apos;il devrait&#xa0;: {what} à {position} est {found}, attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>{reason}. The drive holds the complete old or the complete new state; ask for the status when it answers again. The old state is kept in {backup}</source>
        <translation>{reason}. Le variateur est entièrement dans l&apos;ancien ou entièrement dans le nouvel état&#xa0;; demander l&apos;état dès qu&apos;il répond de nouveau. L&apos;ancien état est conservé dans {backup}</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis; restore it from {backup}</source>
        <translation>{reason}&#xa0;; la restauration de l&apos;ancien état a échoué elle aussi ({rollback}). Ne pas activer l&apos;axe&#xa0;; le restaurer depuis {backup}</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>introuvable</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>droits insuffisants</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation>le quota de disque est épuisé</translation>
    </message>
    <message>
        <source>the file system is read-only</source>
        <translation>le système de fichiers est en lecture seule</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c&apos;est un dossier</translation>
    </message>
    <message>
        <source>a part of the path is not a folder</source>
        <translation>une partie du chemin n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>le nom est trop long</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>ses liens symboliques tournent en rond</translation>
    </message>
    <message>
        <source>it would be larger than a file may be here</source>
        <translation>le fichier dépasserait la taille permise ici</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>le disque signale une erreur</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>the folder {folder} does not exist</source>
        <translation>le dossier {folder} n&apos;existe pas</translation>
    </message>
    <message>
        <source>more than {size}</source>
        <translation>plus de {size}</translation>
    </message>
    <message>
        <source>another program is using it; try again when that one has finished</source>
        <translation>un autre programme l&apos;utilise&#xa0;; réessayer quand il aura terminé</translation>
    </message>
    <message>
        <source>it cannot be locked: {reason}</source>
        <translation>verrouillage impossible&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>ce n&apos;est pas du JSON</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>le document</translation>
    </message>
    <message>
        <source>line {line}, column {column}</source>
        <translation>ligne {line}, colonne {column}</translation>
    </message>
    <message>
        <source>{place}: {problem}</source>
        <translation>{place}&#xa0;: {problem}</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is there twice in one object</source>
        <translation>l&apos;élément «&#xa0;{name}&#xa0;» figure deux fois dans un objet</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is not known</source>
        <translation>l&apos;élément «&#xa0;{name}&#xa0;» est inconnu</translation>
    </message>
    <message>
        <source>it has more than {count} values</source>
        <translation>plus de {count} valeurs</translation>
    </message>
    <message>
        <source>it is nested deeper than {count} levels</source>
        <translation>imbrication sur plus de {count} niveaux</translation>
    </message>
    <message>
        <source>it has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{size} octets&#xa0;; un tel fichier peut en avoir {limit} au plus</translation>
    </message>
    <message>
        <source>an object is expected, not {found}</source>
        <translation>un objet est attendu, non {found}</translation>
    </message>
    <message>
        <source>a list is expected, not {found}</source>
        <translation>une liste est attendue, non {found}</translation>
    </message>
    <message>
        <source>a text is expected, not {found}</source>
        <translation>un texte est attendu, non {found}</translation>
    </message>
    <message>
        <source>true or false is expected, not {found}</source>
        <translation>true ou false est attendu, non {found}</translation>
    </message>
    <message>
        <source>a number is expected, not {found}</source>
        <translation>un nombre est attendu, non {found}</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most} is expected, not {found}</source>
        <translation>un nombre entier de {least} à {most} est attendu, non {found}</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>this is missing</source>
        <translation>élément manquant</translation>
    </message>
    <message>
        <source>this is not base64</source>
        <translation>ce n&apos;est pas du base64</translation>
    </message>
    <message>
        <source>this is too large for a Single</source>
        <translation>trop grand pour un Single</translation>
    </message>
    <message>
        <source>a number is expected, or NaN, Infinity, -Infinity as a text</source>
        <translation>un nombre est attendu, ou NaN, Infinity, -Infinity sous forme de texte</translation>
    </message>
    <message>
        <source>the bytes have the CRC-32 {crc}, so they are damaged</source>
        <translation>les octets ont le CRC-32 {crc}, ils sont donc endommagés</translation>
    </message>
    <message>
        <source>this file is there twice</source>
        <translation>ce fichier figure deux fois</translation>
    </message>
    <message>
        <source>this axis of the drive is there twice</source>
        <translation>cet axe du variateur figure deux fois</translation>
    </message>
    <message>
        <source>&quot;{format}&quot; is expected</source>
        <translation>attendu&#xa0;: «&#xa0;{format}&#xa0;»</translation>
    </message>
    <message>
        <source>only version {version} can be read; a newer version of this program may have written it</source>
        <translation>seule la version {version} est lisible&#xa0;; le fichier provient peut-être d&apos;une version plus récente de ce programme</translation>
    </message>
    <message>
        <source>one of Boolean, Int32, UInt32, Single, Double, Enum is expected</source>
        <translation>un type parmi Boolean, Int32, UInt32, Single, Double, Enum est attendu</translation>
    </message>
    <message>
        <source>a time such as 2026-11-21T08:02:23Z is expected</source>
        <translation>une date telle que 2026-11-21T08:02:23Z est attendue</translation>
    </message>
    <message>
        <source>a CRC-32 of eight hexadecimal digits such as 1c291ca3 is expected</source>
        <translation>un CRC-32 de huit chiffres hexadécimaux tel que 1c291ca3 est attendu</translation>
    </message>
    <message>
        <source>it was closed before the reply was complete</source>
        <translation>elle a été fermée avant la fin de la réponse</translation>
    </message>
    <message>
        <source>nothing listens there; is the drive switched on, and is the address right?</source>
        <translation>rien ne répond à cet endroit&#xa0;; le variateur est-il sous tension et l&apos;adresse est-elle correcte&#xa0;?</translation>
    </message>
    <message>
        <source>the network does not know the name {name}</source>
        <translation>le nom {name} est inconnu du réseau</translation>
    </message>
    <message>
        <source>there is no https; try http://, or another port</source>
        <translation>pas de https&#xa0;; essayer http:// ou un autre port</translation>
    </message>
    <message>
        <source>write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or demo:</source>
        <translation>écrire http://hôte[:port], https://hôte[:port], serial:/dev/ttyUSB0 ou demo:</translation>
    </message>
    <message>
        <source>the host is missing; write http://192.168.1.20 or http://host:8080</source>
        <translation>l&apos;hôte manque&#xa0;; écrire http://192.168.1.20 ou http://hôte:8080</translation>
    </message>
    <message>
        <source>only host and port belong here, no path</source>
        <translation>seuls l&apos;hôte et le port ont leur place ici, pas de chemin</translation>
    </message>
    <message>
        <source>port 0 cannot be reached</source>
        <translation>le port 0 n&apos;est pas accessible</translation>
    </message>
    <message>
        <source>the device must be an absolute path such as serial:/dev/ttyUSB0</source>
        <translation>le périphérique doit être un chemin absolu tel que serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>the only option is baud, as in serial:/dev/ttyUSB0?baud=115200</source>
        <translation>la seule option est baud, comme dans serial:/dev/ttyUSB0?baud=115200</translation>
    </message>
    <message>
        <source>you have no permission to look into its folder</source>
        <translation>droits insuffisants sur son dossier</translation>
    </message>
    <message>
        <source>the port cannot be used</source>
        <translation>le port n&apos;est pas utilisable</translation>
    </message>
    <message>
        <source>the serial port is gone; was the cable or the adapter unplugged?</source>
        <translation>le port série a disparu&#xa0;; le câble ou l&apos;adaptateur a-t-il été débranché&#xa0;?</translation>
    </message>
    <message>
        <source>another program is using the port; close it there</source>
        <translation>un autre programme utilise le port&#xa0;; le libérer dans ce programme</translation>
    </message>
    <message>
        <source>this is no serial port ({reason})</source>
        <translation>ce n&apos;est pas un port série ({reason})</translation>
    </message>
    <message>
        <source>the port cannot do {speed} baud</source>
        <translation>le port n&apos;admet pas {speed} bauds</translation>
    </message>
    <message>
        <source>the reply of a drive at {speed} baud</source>
        <translation>la réponse d&apos;un variateur à {speed} bauds</translation>
    </message>
    <message>
        <source>name, serial number, axes and profile</source>
        <translation>nom, numéro de série, axes et profil</translation>
    </message>
    <message>
        <source>the number of lines that follow</source>
        <translation>le nombre des lignes qui suivent</translation>
    </message>
    <message>
        <source>the line garbles too much; check the cable, or try a lower baud rate</source>
        <translation>la ligne perturbe trop les données&#xa0;; vérifier le câble ou essayer un débit plus faible</translation>
    </message>
    <message>
        <source>the drive began anew</source>
        <translation>le variateur a recommencé depuis le début</translation>
    </message>
    <message>
        <source>a size of at most {most} and a CRC</source>
        <translation>une taille d&apos;au plus {most} et un CRC</translation>
    </message>
    <message>
        <source>a type and a value</source>
        <translation>un type et une valeur</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>une adresse</translation>
    </message>
    <message>
        <source>how many registers there are</source>
        <translation>le nombre de registres</translation>
    </message>
    <message>
        <source>path, address, type and value</source>
        <translation>chemin, adresse, type et valeur</translation>
    </message>
    <message>
        <source>the rest of the registers</source>
        <translation>les autres registres</translation>
    </message>
    <message>
        <source>the serial link writes 1 to {most} registers at one instant, not {count}</source>
        <translation>la liaison série écrit de 1 à {most} registres à la fois, pas {count}</translation>
    </message>
    <message>
        <source>path, size and maximum size</source>
        <translation>chemin, taille et taille maximale</translation>
    </message>
    <message>
        <source>a redirect to {address}</source>
        <translation>une redirection vers {address}</translation>
    </message>
    <message>
        <source>a redirect to {address}; give its address with https://</source>
        <translation>une redirection vers {address}&#xa0;; indiquer l&apos;adresse avec https://</translation>
    </message>
    <message>
        <source>the answer itself</source>
        <translation>la réponse elle-même</translation>
    </message>
    <message>
        <source>success or a refusal</source>
        <translation>un succès ou un refus</translation>
    </message>
    <message>
        <source>HTTP status {status}</source>
        <translation>statut HTTP {status}</translation>
    </message>
    <message>
        <source>HTTP status {status}, {text}</source>
        <translation>statut HTTP {status}, {text}</translation>
    </message>
    <message>
        <source>HTTP status {status} and {text}</source>
        <translation>statut HTTP {status} et {text}</translation>
    </message>
    <message>
        <source>an HTTP reply</source>
        <translation>une réponse HTTP</translation>
    </message>
    <message>
        <source>the status line of an HTTP reply</source>
        <translation>la ligne de statut d&apos;une réponse HTTP</translation>
    </message>
    <message>
        <source>a header field of an HTTP reply</source>
        <translation>un champ d&apos;en-tête d&apos;une réponse HTTP</translation>
    </message>
    <message>
        <source>a head of at most 64 KiB</source>
        <translation>un en-tête d&apos;au plus 64 Kio</translation>
    </message>
    <message>
        <source>one Content-Length</source>
        <translation>un seul Content-Length</translation>
    </message>
    <message>
        <source>no Transfer-Encoding but chunked</source>
        <translation>aucun autre Transfer-Encoding que chunked</translation>
    </message>
    <message>
        <source>the size of a chunk</source>
        <translation>la taille d&apos;un bloc</translation>
    </message>
    <message>
        <source>the end of a chunk</source>
        <translation>la fin d&apos;un bloc</translation>
    </message>
    <message>
        <source>at most {count} files</source>
        <translation>au plus {count} fichiers</translation>
    </message>
    <message>
        <source>file paths without blanks</source>
        <translation>des chemins de fichier sans espaces</translation>
    </message>
    <message>
        <source>an actual size of {path} up to its maximum size</source>
        <translation>pour {path}, une taille réelle ne dépassant pas sa taille maximale</translation>
    </message>
    <message>
        <source>the file {path} once</source>
        <translation>le fichier {path} une seule fois</translation>
    </message>
    <message>
        <source>a file, its size and its maximum size in each row</source>
        <translation>un fichier, sa taille et sa taille maximale dans chaque ligne</translation>
    </message>
    <message>
        <source>sizes in bytes</source>
        <translation>des tailles en octets</translation>
    </message>
    <message>
        <source>a JSON array of files</source>
        <translation>un tableau JSON de fichiers</translation>
    </message>
    <message>
        <source>a file with path, size and maximumSize</source>
        <translation>un fichier avec path, size et maximumSize</translation>
    </message>
    <message>
        <source>at least one file in the table</source>
        <translation>au moins un fichier dans le tableau</translation>
    </message>
    <message>
        <source>a Directory page with a table of File, actual size and maximum size</source>
        <translation>une page Directory avec un tableau de File, actual size et maximum size</translation>
    </message>
    <message>
        <source>a JSON array of registers</source>
        <translation>un tableau JSON de registres</translation>
    </message>
    <message>
        <source>a register with path, address, type and a value of that type</source>
        <translation>un registre avec path, address, type et une valeur de ce type</translation>
    </message>
    <message>
        <source>registers below {path}</source>
        <translation>des registres sous {path}</translation>
    </message>
    <message>
        <source>at most 1024 axes</source>
        <translation>au plus 1024 axes</translation>
    </message>
    <message>
        <source>more</source>
        <translation>davantage</translation>
    </message>
    <message>
        <source>status 204 without a body</source>
        <translation>le statut 204 sans contenu</translation>
    </message>
    <message>
        <source>a file with its Content-Length</source>
        <translation>un fichier avec son Content-Length</translation>
    </message>
    <message>
        <source>the bytes of {path}</source>
        <translation>les octets de {path}</translation>
    </message>
    <message>
        <source>a reply</source>
        <translation>une réponse</translation>
    </message>
    <message>
        <source>flipped bytes</source>
        <translation>des octets altérés</translation>
    </message>
    <message>
        <source>the connection was cut</source>
        <translation>la connexion a été coupée</translation>
    </message>
    <message>
        <source>the drive rebooted</source>
        <translation>le variateur a redémarré</translation>
    </message>
    <message>
        <source>a request reads at most {most} registers, not {count}</source>
        <translation>une requête lit au plus {most} registres, pas {count}</translation>
    </message>
    <message>
        <source>a request writes 1 to {most} registers, not {count}</source>
        <translation>une requête écrit de 1 à {most} registres, pas {count}</translation>
    </message>
    <message>
        <source>{path} is written twice in one request</source>
        <translation>{path} est écrit deux fois dans une requête</translation>
    </message>
    <message>
        <source>{path} is read-only</source>
        <translation>{path} est en lecture seule</translation>
    </message>
    <message>
        <source>{path} is of type {type}, and cannot be {value}</source>
        <translation>{path} est de type {type} et ne peut pas valoir {value}</translation>
    </message>
    <message>
        <source>{path} is of type {type}, one of {names}, and cannot be {value}</source>
        <translation>{path} est de type {type}, l&apos;une des valeurs {names}, et ne peut pas valoir {value}</translation>
    </message>
    <message>
        <source>the compensation of {axis} is on, so {what} must stay; deactivate it</source>
        <translation>la compensation est activée ({axis}), donc non modifiable&#xa0;: {what}&#xa0;; la désactiver d&apos;abord</translation>
    </message>
    <message>
        <source>its homing</source>
        <translation>la prise d&apos;origine</translation>
    </message>
    <message>
        <source>the table in {slot}</source>
        <translation>la table dans {slot}</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be persistent</source>
        <translation>il n&apos;y a dans {slot} aucune table qui puisse devenir persistante</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be committed</source>
        <translation>il n&apos;y a dans {slot} aucune table à enregistrer en mémoire flash</translation>
    </message>
    <message>
        <source>{path} can have {most} bytes, not {size}</source>
        <translation>{path} peut contenir {most} octets, pas {size}</translation>
    </message>
    <message>
        <source>the drive&apos;s flash failed: {reason}</source>
        <translation>défaillance de la mémoire flash du variateur&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the axis must be homed first</source>
        <translation>effectuer d&apos;abord la prise d&apos;origine de l&apos;axe</translation>
    </message>
    <message>
        <source>the axis has no table; write one first</source>
        <translation>l&apos;axe n&apos;a pas de table&#xa0;; en écrire d&apos;abord une</translation>
    </message>
    <message>
        <source>the number of sources must equal the table&apos;s dimensions</source>
        <translation>le nombre de sources doit être celui des dimensions de la table</translation>
    </message>
    <message>
        <source>a source is not a Single or Double register of this drive</source>
        <translation>une source n&apos;est pas un registre Single ou Double de ce variateur</translation>
    </message>
    <message>
        <source>the drive cannot use the table; write it again</source>
        <translation>le variateur ne peut pas utiliser la table&#xa0;; l&apos;écrire de nouveau</translation>
    </message>
    <message>
        <source>see the drive&apos;s manual</source>
        <translation>voir le manuel du variateur</translation>
    </message>
    <message>
        <source>the drive has restarted, or somebody else has switched the compensation</source>
        <translation>le variateur a redémarré, ou quelqu&apos;un d&apos;autre a commuté la compensation</translation>
    </message>
    <message>
        <source>it did not become {state} in time</source>
        <translation>l&apos;état {state} n&apos;a pas été atteint à temps</translation>
    </message>
    <message>
        <source>only an active or an evaluating compensation can be proved</source>
        <translation>seule une compensation active ou en évaluation peut être validée</translation>
    </message>
    <message>
        <source>No other slot is free: the table in {slot} is overwritten. A copy is kept in the backup.</source>
        <translation>Aucun autre emplacement n&apos;est libre&#xa0;: la table dans {slot} sera écrasée. Une copie est conservée dans la sauvegarde.</translation>
    </message>
    <message>
        <source>What {slot} holds now is overwritten. A copy is kept in the backup.</source>
        <translation>Le contenu actuel de {slot} sera écrasé. Une copie est conservée dans la sauvegarde.</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved, but the table of {axis} in {slot} is volatile: after a reboot that axis has no table.</source>
        <translation>Les paramètres de tous les axes sont enregistrés, mais une table est volatile ({axis}, {slot})&#xa0;: après un redémarrage, cet axe n&apos;a plus de table.</translation>
    </message>
    <message>
        <source>The new table is volatile and covers an older one that flash holds in {slot}: after a reboot the axis may have that one again, until the parameters are saved, which deletes it.</source>
        <translation>La nouvelle table est volatile et masque une table plus ancienne en mémoire flash dans {slot}&#xa0;: après un redémarrage, l&apos;axe peut retrouver cette dernière, jusqu&apos;à l&apos;enregistrement des paramètres, qui la supprime.</translation>
    </message>
    <message>
        <source>After a reboot the drive would look for another table in {slot}: the parameters are saved once before the new one goes into flash. When the write is interrupted then, the axis may have no table after a reboot.</source>
        <translation>Après un redémarrage, le variateur chercherait une autre table dans {slot}&#xa0;: les paramètres sont enregistrés une fois avant que la nouvelle passe en mémoire flash. Si l&apos;écriture est interrompue à ce moment, l&apos;axe peut se trouver sans table après un redémarrage.</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: it is deleted before the parameters are saved.</source>
        <translation>La mémoire flash contient peut-être une table plus ancienne dans {slot}&#xa0;: elle est supprimée avant l&apos;enregistrement des paramètres.</translation>
    </message>
    <message>
        <source>the settings of {axis}</source>
        <translation>réglages de {axis}</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>axe {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>axe {axis} ({name})</translation>
    </message>
    <message>
        <source>axis {axis} after a reboot</source>
        <translation>axe {axis} après un redémarrage</translation>
    </message>
    <message>
        <source>the cogging compensation of axis {axis}</source>
        <translation>compensation du couple de détente de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>{slot} holds only {size} bytes</source>
        <translation>{slot} ne contient que {size} octets</translation>
    </message>
    <message>
        <source>{slot} is used by {user}</source>
        <translation>{slot} est utilisé ({user})</translation>
    </message>
    <message>
        <source>{slot} holds a table that is not this axis&apos;s</source>
        <translation>{slot} contient une table qui n&apos;est pas celle de cet axe</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>aucune table</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), persistent</source>
        <translation>{table} (CRC {crc}), persistante</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), volatile</source>
        <translation>{table} (CRC {crc}), volatile</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, persistent</source>
        <translation>{table} (CRC {crc}), {sources}, persistante</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, volatile</source>
        <translation>{table} (CRC {crc}), {sources}, volatile</translation>
    </message>
    <message>
        <source>{path} at offset {offset}</source>
        <translation>{path} à l&apos;octet {offset}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>the output</source>
        <translation>la sortie</translation>
    </message>
    <message>
        <source>the index of dimension {dimension}</source>
        <translation>l&apos;indice de la dimension {dimension}</translation>
    </message>
    <message>
        <source>the dimensionality is 1, 2 or 3</source>
        <translation>la dimensionnalité est 1, 2 ou 3</translation>
    </message>
    <message>
        <source>; a URI is written tam://mc/&lt;drive&gt;/&lt;path&gt;</source>
        <translation>&#xa0;; une URI s&apos;écrit tam://mc/&lt;variateur&gt;/&lt;chemin&gt;</translation>
    </message>
    <message>
        <source>; an address is written 0x and 1 to 8 hex digits</source>
        <translation>&#xa0;; une adresse s&apos;écrit 0x suivi de 1 à 8 chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>: no register has this address</source>
        <translation>&#xa0;: aucun registre n&apos;a cette adresse</translation>
    </message>
    <message>
        <source>; the nearest are {names}</source>
        <translation>&#xa0;; les plus proches sont {names}</translation>
    </message>
    <message>
        <source>there is no backup that differs from what the axis has now</source>
        <translation>aucune sauvegarde ne diffère de l&apos;état actuel de l&apos;axe</translation>
    </message>
    <message>
        <source>the program is ending</source>
        <translation>le programme se termine</translation>
    </message>
    <message>
        <source>the backup</source>
        <translation>la sauvegarde</translation>
    </message>
    <message>
        <source>axis {axis} has no Table register</source>
        <translation>l&apos;axe {axis} n&apos;a pas de registre Table</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with {separator} instead of tabs</source>
        <translation>{expected}&#xa0;; séparer les colonnes par {separator} et non par des tabulations</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ; instead of tabs</source>
        <translation>{expected}&#xa0;; séparer les colonnes par , ou&#xa0;; et non par des tabulations</translation>
    </message>
    <message>
        <source>{path} of type Int32</source>
        <translation>{path} de type Int32</translation>
    </message>
    <message>
        <source>the settings of axis {axis}</source>
        <translation>réglages de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is {fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has the same</source>
        <translation>le certificat de {endpoint} n&apos;est pas fiable&#xa0;: {reason}. Son empreinte SHA-256 est {fingerprint}&#xa0;; si le variateur a la même, l&apos;accepter dans Connexions ou avec --trust-certificate</translation>
    </message>
    <message>
        <source>it has CHANGED and is not the one that was trusted</source>
        <translation>il a CHANGÉ et n&apos;est plus celui qui avait été accepté</translation>
    </message>
    <message>
        <source>no write to axis {axis} is unfinished; there is nothing to finish or to undo</source>
        <translation>aucune écriture interrompue pour l&apos;axe {axis}&#xa0;; il n&apos;y a rien à achever ni à annuler</translation>
    </message>
    <message>
        <source>the new table of the unfinished write to axis {axis} was not kept on this computer: write it again, or undo the write</source>
        <translation>la nouvelle table de l&apos;axe {axis} n&apos;a pas été conservée sur cet ordinateur&#xa0;: l&apos;écrire de nouveau ou annuler l&apos;écriture</translation>
    </message>
    <message>
        <source>slot {slot}</source>
        <translation>emplacement {slot}</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent</source>
        <translation>{count} valeurs (CRC {crc}), persistantes</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile</source>
        <translation>{count} valeurs (CRC {crc}), volatiles</translation>
    </message>
    <message>
        <source>empty, used by {user}</source>
        <translation>vide, utilisé ({user})</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent, used by {user}</source>
        <translation>{count} valeurs (CRC {crc}), persistantes, utilisées ({user})</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile, used by {user}</source>
        <translation>{count} valeurs (CRC {crc}), volatiles, utilisées ({user})</translation>
    </message>
    <message>
        <source>the unfinished write to axis {axis}</source>
        <translation>écriture interrompue de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>the name of a file beside the journal is expected</source>
        <translation>le nom d&apos;un fichier placé à côté du journal de reprise est attendu</translation>
    </message>
    <message>
        <source>it is not of axis {axis} of this drive</source>
        <translation>elle ne concerne pas l&apos;axe {axis} de ce variateur</translation>
    </message>
    <message>
        <source>{file} can be one of several formats: {candidates}; say which one it is</source>
        <translation>{file} peut être de plusieurs formats&#xa0;: {candidates}&#xa0;; indiquer lequel</translation>
    </message>
    <message>
        <source>the format {format} cannot hold this table: {reason}; {wayOut}</source>
        <translation>le format {format} ne peut pas contenir cette table&#xa0;: {reason}&#xa0;; {wayOut}</translation>
    </message>
    <message>
        <source>the sign cannot be converted at {position}: {reason}</source>
        <translation>le signe ne peut pas être converti à {position}&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the table cannot be resampled: {reason}</source>
        <translation>la table ne peut pas être rééchantillonnée&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the numbers of the file are taken as they are</source>
        <translation>les nombres du fichier sont repris tels quels</translation>
    </message>
    <message>
        <source>sign: {from}; {example}</source>
        <translation>signe&#xa0;: {from}&#xa0;; {example}</translation>
    </message>
    <message>
        <source>{format} holds feedback values</source>
        <translation>{format} contient des valeurs côté codeur (feedback)</translation>
    </message>
    <message>
        <source>{format} holds command values</source>
        <translation>{format} contient des valeurs côté consigne (command)</translation>
    </message>
    <message>
        <source>{format} holds feedback values, as you say</source>
        <translation>{format} contient, comme indiqué, des valeurs côté codeur (feedback)</translation>
    </message>
    <message>
        <source>{format} holds command values, as you say</source>
        <translation>{format} contient, comme indiqué, des valeurs côté consigne (command)</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}</source>
        <translation>{example}&#xa0;: le fichier côté codeur indique {value}</translation>
    </message>
    <message>
        <source>{example}: the command file says {value}</source>
        <translation>{example}&#xa0;: le fichier côté consigne indique {value}</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}, the command file {other}</source>
        <translation>{example}&#xa0;: le fichier côté codeur indique {value}, le fichier côté consigne {other}</translation>
    </message>
    <message>
        <source>all values are 0, in either sign</source>
        <translation>toutes les valeurs sont 0, quel que soit le signe</translation>
    </message>
    <message>
        <source>moving in positive direction, {example}</source>
        <translation>en sens positif, {example}</translation>
    </message>
    <message>
        <source>moving in negative direction, {example}</source>
        <translation>en sens négatif, {example}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference says {moved}</source>
        <translation>là où le codeur indique {place}, la référence indique {moved}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} says {moved}</source>
        <translation>là où les codeurs indiquent {place}, la référence de {axis} indique {moved}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>là où le codeur indique {place}, la référence de {axis} est {offset} au-dessus de son codeur</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>là où le codeur indique {place}, la référence de {axis} est {offset} au-dessous de son codeur</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>là où les codeurs indiquent {place}, la référence de {axis} est {offset} au-dessus de son codeur</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>là où les codeurs indiquent {place}, la référence de {axis} est {offset} au-dessous de son codeur</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}, where the reference says {reference}</source>
        <translation>pour la consigne {place}, la commande amène le codeur à {moved}, où la référence indique {reference}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}, where the reference says {reference}</source>
        <translation>pour la consigne {place}, la commande amène le codeur de {axis} à {moved}, où la référence indique {reference}</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} above its encoder, the controller moves {target} by {value}</source>
        <translation>pour la consigne {place}, où la référence de {axis} est {offset} au-dessus de son codeur, la commande déplace {target} de {value}</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} below its encoder, the controller moves {target} by {value}</source>
        <translation>pour la consigne {place}, où la référence de {axis} est {offset} au-dessous de son codeur, la commande déplace {target} de {value}</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>l&apos;axe cible</translation>
    </message>
    <message>
        <source>{axis} = {position}</source>
        <translation>{axis} = {position}</translation>
    </message>
    <message>
        <source>resampled from {before} points to {after} points: at the positions of the source it is off by at most {largest}, {rms} rms</source>
        <translation>rééchantillonné de {before} à {after} points&#xa0;: aux positions de la source, l&apos;écart est d&apos;au plus {largest}, {rms} RMS</translation>
    </message>
    <message>
        <source>the values of the file are rounded by up to {amount}</source>
        <translation>les valeurs du fichier sont arrondies de {amount} au plus</translation>
    </message>
    <message>
        <source>the positions of the file are rounded by up to {amount}</source>
        <translation>les positions du fichier sont arrondies de {amount} au plus</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules: {difference}</source>
        <translation>comparé à {count} positions, chacune selon les règles de sa commande&#xa0;: {difference}</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules ({column}): {difference}</source>
        <translation>comparé à {count} positions, chacune selon les règles de sa commande ({column})&#xa0;: {difference}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}</source>
        <translation>la différence est d&apos;au plus {largest} à {place}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, where both have values by at most {inside}</source>
        <translation>la différence est d&apos;au plus {largest} à {place}, et d&apos;au plus {inside} là où les deux ont des valeurs</translation>
    </message>
    <message>
        <source>at the ends of the table the sign was converted with the end values held, where the controller of the source applies nothing</source>
        <translation>aux extrémités de la table, le signe a été converti avec maintien des valeurs d&apos;extrémité, alors que la commande de la source n&apos;y applique rien</translation>
    </message>
    <message>
        <source>the {what} have no unit; they are taken to be {unit}</source>
        <translation>unité manquante ({what})&#xa0;; {unit} est supposée</translation>
    </message>
    <message>
        <source>the positions are in {unit}</source>
        <translation>les positions sont en {unit}</translation>
    </message>
    <message>
        <source>the values are in {unit}</source>
        <translation>les valeurs sont en {unit}</translation>
    </message>
    <message>
        <source>positions and values are in {unit}</source>
        <translation>les positions et les valeurs sont en {unit}</translation>
    </message>
    <message>
        <source>no known unit</source>
        <translation>unité inconnue</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} behind it</source>
        <translation>{range}&#xa0;: la grille se termine à {end}, soit {distance} au-delà</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} before its end</source>
        <translation>{range}&#xa0;: la grille se termine à {end}, soit {distance} avant sa fin</translation>
    </message>
    <message>
        <source>the range of {axis} from {from} to {to} is no whole multiple of {distance}</source>
        <translation>l&apos;étendue de {axis} de {from} à {to} n&apos;est pas un multiple entier de {distance}</translation>
    </message>
    <message>
        <source>a number of points is a whole number, at least 2</source>
        <translation>un nombre de points est un entier, au moins 2</translation>
    </message>
    <message>
        <source>the number for the even grid is missing</source>
        <translation>le nombre pour la grille régulière manque</translation>
    </message>
    <message>
        <source>the even grid needs one number, or one for each of the {count} source axes</source>
        <translation>la grille régulière exige un nombre, ou un pour chacun des {count} axes sources</translation>
    </message>
    <message>
        <source>the format {format} can be written, not read</source>
        <translation>le format {format} peut être écrit, mais pas lu</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key} ({meaning})</source>
        <translation>le format {format} exige le réglage {key} ({meaning})</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected {expected} ({meaning})</source>
        <translation>le réglage {key} est «&#xa0;{value}&#xa0;», attendu&#xa0;: {expected} ({meaning})</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>one of {choices}</source>
        <translation>un choix parmi {choices}</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes ou no</translation>
    </message>
    <message>
        <source>the positions of source {number} are not evenly spaced</source>
        <translation>les positions de la source {number} ne sont pas équidistantes</translation>
    </message>
    <message>
        <source>resample it onto an even grid</source>
        <translation>la rééchantillonner sur une grille régulière</translation>
    </message>
    <message>
        <source>resample it onto a coarser grid</source>
        <translation>la rééchantillonner sur une grille moins fine</translation>
    </message>
    <message>
        <source>it takes one distance for all sources, and these are different</source>
        <translation>il admet un seul pas pour toutes les sources, et ceux-ci diffèrent</translation>
    </message>
    <message>
        <source>resample it with the same distance for each source</source>
        <translation>la rééchantillonner avec le même pas pour chaque source</translation>
    </message>
    <message>
        <source>it has one value for both directions of motion</source>
        <translation>il a une seule valeur pour les deux sens de déplacement</translation>
    </message>
    <message>
        <source>choose the mean, the positive or the negative direction</source>
        <translation>choisir la moyenne, le sens positif ou le sens négatif</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>choisir un autre format</translation>
    </message>
    <message>
        <source>{count} points are more than the {limit} that the controller takes</source>
        <translation>{count} points, la commande en accepte {limit} au plus</translation>
    </message>
    <message>
        <source>it has no modulo axes</source>
        <translation>il ne connaît pas d&apos;axes modulo</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap, in a machine file no-wrap = true) when it stays within one revolution</source>
        <translation>traiter l&apos;axe comme linéaire (--no-wrap, dans un fichier machine no-wrap = true) s&apos;il reste dans un seul tour</translation>
    </message>
    <message>
        <source>its values are offsets of the command</source>
        <translation>ses valeurs sont des décalages de la consigne</translation>
    </message>
    <message>
        <source>convert the sign</source>
        <translation>convertir le signe</translation>
    </message>
    <message>
        <source>a value is beyond what a float32 can be</source>
        <translation>une valeur dépasse ce qu&apos;un float32 peut représenter</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>vérifier l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>a grid along {axis} needs at least two points</source>
        <translation>une grille suivant {axis} exige au moins deux points</translation>
    </message>
    <message>
        <source>the distance along {axis} must be a number above 0</source>
        <translation>le pas suivant {axis} doit être un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>the positions of {axis} are not evenly spaced; give a number of points or a distance</source>
        <translation>les positions de {axis} ne sont pas équidistantes&#xa0;; indiquer un nombre de points ou un pas</translation>
    </message>
    <message>
        <source>the full turn of {axis}, {turn}, is no whole multiple of {distance}; possible are {fewer} or {more}</source>
        <translation>le tour complet de {axis}, {turn}, n&apos;est pas un multiple entier de {distance}&#xa0;; possibles&#xa0;: {fewer} ou {more}</translation>
    </message>
    <message>
        <source>a distance of {distance} is longer than the range of {axis} from {from} to {to}; take a shorter one, or let the end values be held</source>
        <translation>un pas de {distance} dépasse l&apos;étendue de {axis} de {from} à {to}&#xa0;; en choisir un plus court ou maintenir les valeurs d&apos;extrémité</translation>
    </message>
    <message>
        <source>the grid would have more than {count} points; take fewer along an axis</source>
        <translation>la grille aurait plus de {count} points&#xa0;; en prendre moins suivant un axe</translation>
    </message>
    <message>
        <source>calibration file: reference positions and compensation values</source>
        <translation>fichier d&apos;étalonnage&#xa0;: positions de référence et valeurs de compensation</translation>
    </message>
    <message>
        <source>table file of the drive, laid out as the drive profile says</source>
        <translation>fichier de table du variateur, organisé selon le profil du variateur</translation>
    </message>
    <message>
        <source>CSV file of positions and offsets</source>
        <translation>fichier CSV de positions et de décalages</translation>
    </message>
    <message>
        <source>cross compensation in a compensation list (kw.crosscomp)</source>
        <translation>compensation croisée dans une liste de compensation (kw.crosscomp)</translation>
    </message>
    <message>
        <source>plane compensation in a compensation list (kw.crosscomp2)</source>
        <translation>compensation de surface dans une liste de compensation (kw.crosscomp2)</translation>
    </message>
    <message>
        <source>leadscrew error compensation in a compensation list (kw.ssfk)</source>
        <translation>compensation d&apos;erreur de pas de vis dans une liste de compensation (kw.ssfk)</translation>
    </message>
    <message>
        <source>compensation file of a joint: nominal forward reverse</source>
        <translation>fichier de compensation d&apos;une articulation&#xa0;: consigne aller retour</translation>
    </message>
    <message>
        <source>CSV file of this program with the table of a compensator</source>
        <translation>fichier CSV de ce programme avec la table d&apos;un compensateur</translation>
    </message>
    <message>
        <source>C++ header with the table of a compensator</source>
        <translation>fichier d&apos;en-tête C++ avec la table d&apos;un compensateur</translation>
    </message>
    <message>
        <source>sag and angularity compensation ($AN_CEC)</source>
        <translation>compensation de flèche et d&apos;angularité ($AN_CEC)</translation>
    </message>
    <message>
        <source>encoder and leadscrew error compensation ($AA_ENC_COMP)</source>
        <translation>compensation du codeur et de l&apos;erreur de pas de vis ($AA_ENC_COMP)</translation>
    </message>
    <message>
        <source>text table of positions and corrections</source>
        <translation>table au format texte de positions et de corrections</translation>
    </message>
    <message>
        <source>MC-BASIC assignments to SourceData and TargetData</source>
        <translation>affectations MC-BASIC à SourceData et TargetData</translation>
    </message>
    <message>
        <source>of a rotary axis: the range after which its position begins again, such as 360</source>
        <translation>pour un axe rotatif&#xa0;: l&apos;étendue après laquelle sa position recommence, par exemple 360</translation>
    </message>
    <message>
        <source>logical number of the axis whose position counts, for master_ax_nr</source>
        <translation>numéro logique de l&apos;axe dont la position compte, pour master_ax_nr</translation>
    </message>
    <message>
        <source>cycles over which switching is smoothed, for n_cycles</source>
        <translation>cycles sur lesquels la commutation est lissée, pour n_cycles</translation>
    </message>
    <message>
        <source>the master is a modulo axis: the first and the last point are one place</source>
        <translation>l&apos;axe maître est un axe modulo&#xa0;: le premier et le dernier point sont le même endroit</translation>
    </message>
    <message>
        <source>whether the master axis is linear (mm) or rotary (deg)</source>
        <translation>si l&apos;axe maître est linéaire (mm) ou rotatif (degrés)</translation>
    </message>
    <message>
        <source>whether the compensated axis is linear (mm) or rotary (deg)</source>
        <translation>si l&apos;axe compensé est linéaire (mm) ou rotatif (degrés)</translation>
    </message>
    <message>
        <source>whether the axis is linear (mm) or rotary (deg)</source>
        <translation>si l&apos;axe est linéaire (mm) ou rotatif (degrés)</translation>
    </message>
    <message>
        <source>metric: 0.1 um and 0.0001 deg; increments: of the encoder</source>
        <translation>metric&#xa0;: 0,1 µm et 0,0001 degré&#xa0;; increments&#xa0;: incréments du codeur</translation>
    </message>
    <message>
        <source>encoder increments for one mm or degree, of a list in increments</source>
        <translation>incréments du codeur par mm ou degré, pour une liste en incréments</translation>
    </message>
    <message>
        <source>write numbers with decimals, which only newer kernels take</source>
        <translation>écrire les nombres avec décimales, que seuls les noyaux récents acceptent</translation>
    </message>
    <message>
        <source>logical number of the axis that is compensated, for kopf.achs_nr</source>
        <translation>numéro logique de l&apos;axe compensé, pour kopf.achs_nr</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims; 0 is assumed</source>
        <translation>COMP_FILE_TYPE&#xa0;: 0 pour des positions mesurées, 1 pour des corrections&#xa0;; 0 est supposé</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims</source>
        <translation>COMP_FILE_TYPE&#xa0;: 0 pour des positions mesurées, 1 pour des corrections</translation>
    </message>
    <message>
        <source>raw counts of the output axis for one unit of the values</source>
        <translation>incréments bruts de l&apos;axe de sortie par unité des valeurs</translation>
    </message>
    <message>
        <source>the same, where the file does not say it</source>
        <translation>incréments bruts par unité des valeurs, si le fichier ne les indique pas</translation>
    </message>
    <message>
        <source>unit of the positions, the user unit of the input axes</source>
        <translation>unité des positions, l&apos;unité utilisateur des axes d&apos;entrée</translation>
    </message>
    <message>
        <source>unit of the values, the user unit of the output axis; otherwise that of the positions</source>
        <translation>unité des valeurs, l&apos;unité utilisateur de l&apos;axe de sortie&#xa0;; sinon celle des positions</translation>
    </message>
    <message>
        <source>namespace of the constants, a C++ name</source>
        <translation>espace de noms des constantes, un nom C++</translation>
    </message>
    <message>
        <source>unit of the positions, where the file does not say it</source>
        <translation>unité des positions, si le fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>unit of the values, where the file does not say it</source>
        <translation>unité des valeurs, si le fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>index of the first table that is written</source>
        <translation>numéro de la première table écrite</translation>
    </message>
    <message>
        <source>name of the axis whose position counts, instead of the table&apos;s name for it</source>
        <translation>nom de l&apos;axe dont la position compte, à la place de celui de la table</translation>
    </message>
    <message>
        <source>name of the axis that is compensated, instead of the table&apos;s name for it</source>
        <translation>nom de l&apos;axe compensé, à la place de celui de la table</translation>
    </message>
    <message>
        <source>name of the machine axis, such as X1, instead of the table&apos;s name for it</source>
        <translation>nom de l&apos;axe machine, par exemple X1, à la place de celui de la table</translation>
    </message>
    <message>
        <source>measuring system of the axis, instead of that of the program that was read, or 0</source>
        <translation>système de mesure de l&apos;axe, au lieu de celui du programme lu, sinon 0</translation>
    </message>
    <message>
        <source>name of the compensation table in the MC-BASIC program</source>
        <translation>nom de la table de compensation dans le programme MC-BASIC</translation>
    </message>
    <message>
        <source>the drive stores the table in its flash</source>
        <translation>le variateur conserve la table dans sa mémoire flash</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: they are the same</source>
        <translation>une seule valeur pour les deux sens de déplacement, {choice}&#xa0;: elles sont identiques</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: they are the same</source>
        <translation>une seule valeur pour les deux sens de déplacement, {choice}, pour {target}&#xa0;: elles sont identiques</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: half their difference is up to {loss}, at {place}</source>
        <translation>une seule valeur pour les deux sens de déplacement, {choice}&#xa0;: leur demi-différence atteint {loss}, à {place}</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: half their difference is up to {loss}, at {place}</source>
        <translation>une seule valeur pour les deux sens de déplacement, {choice}, pour {target}&#xa0;: leur demi-différence atteint {loss}, à {place}</translation>
    </message>
    <message>
        <source>they do not differ</source>
        <translation>aucune différence</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, and not at all where both have values</source>
        <translation>la différence est d&apos;au plus {largest} à {place}, et nulle là où les deux ont des valeurs</translation>
    </message>
    <message>
        <source>number of the axis, from 1, instead of the table&apos;s name for it</source>
        <translation>numéro de l&apos;axe, à partir de 1, à la place du nom dans la table</translation>
    </message>
    <message>
        <source>calibration file of single axes (:START)</source>
        <translation>fichier d&apos;étalonnage d&apos;axes isolés (:START)</translation>
    </message>
    <message>
        <source>calibration file of two axes (:START2D)</source>
        <translation>fichier d&apos;étalonnage de deux axes (:START2D)</translation>
    </message>
    <message>
        <source>numbers of the axes for which METRIC means degrees, such as 4,5; all others mm</source>
        <translation>numéros des axes pour lesquels METRIC signifie degrés, par exemple 4,5&#xa0;; mm pour tous les autres</translation>
    </message>
    <message>
        <source>what PRIMARY stands for, such as mm</source>
        <translation>ce que représente PRIMARY, par exemple mm</translation>
    </message>
    <message>
        <source>METRIC (mm and degrees), or PRIMARY: the table&apos;s own units are those of the axes</source>
        <translation>METRIC (mm et degrés) ou PRIMARY&#xa0;: les unités de la table sont celles des axes</translation>
    </message>
    <message>
        <source>[bed_mesh NAME] sections of printer.cfg: heights of the bed</source>
        <translation>sections [bed_mesh NAME] de printer.cfg&#xa0;: hauteurs du plateau</translation>
    </message>
    <message>
        <source>heightmap.csv, version 2: heights of the bed</source>
        <translation>heightmap.csv, version 2&#xa0;: hauteurs du plateau</translation>
    </message>
    <message>
        <source>names of the axes in degrees, such as C,B; all others are in mm, and modulo axes in degrees anyway</source>
        <translation>noms des axes en degrés, par exemple C,B&#xa0;; tous les autres sont en mm, et les axes modulo toujours en degrés</translation>
    </message>
    <message>
        <source>leadscrew compensation of one source (DEFINE COMP)</source>
        <translation>compensation de vis à une source (DEFINE COMP)</translation>
    </message>
    <message>
        <source>compensation of a motor by two others (DEFINE COMP)</source>
        <translation>compensation d&apos;un moteur selon deux autres (DEFINE COMP)</translation>
    </message>
    <message>
        <source>encoder counts for one unit, of every motor without a setting of its own</source>
        <translation>incréments du codeur par unité, pour tout moteur sans réglage propre</translation>
    </message>
    <message>
        <source>encoder counts for one unit; without it tables are in counts</source>
        <translation>incréments du codeur par unité&#xa0;; à défaut, les tables sont en incréments</translation>
    </message>
    <message>
        <source>position of the sources that counts: desired (written with D) or actual</source>
        <translation>position des sources qui compte&#xa0;: consigne (desired, écrite avec D) ou réelle (actual)</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the positions</source>
        <translation>incréments du codeur par unité des positions</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the values</source>
        <translation>incréments du codeur par unité des valeurs</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the row motor</source>
        <translation>incréments du codeur par unité du moteur des lignes</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the column motor</source>
        <translation>incréments du codeur par unité du moteur des colonnes</translation>
    </message>
    <message>
        <source>number of the motor whose position counts, 1 to 32</source>
        <translation>numéro du moteur dont la position compte, de 1 à 32</translation>
    </message>
    <message>
        <source>number of the motor that is compensated, 1 to 32</source>
        <translation>numéro du moteur compensé, de 1 à 32</translation>
    </message>
    <message>
        <source>number of the motor along a row of entries, 1 to 32</source>
        <translation>numéro du moteur le long d&apos;une ligne d&apos;entrées, de 1 à 32</translation>
    </message>
    <message>
        <source>number of the motor from row to row, 1 to 32</source>
        <translation>numéro du moteur d&apos;une ligne à l&apos;autre, de 1 à 32</translation>
    </message>
    <message>
        <source>number of the axis that changes along a line, from 1</source>
        <translation>numéro de l&apos;axe qui varie le long d&apos;une ligne, à partir de 1</translation>
    </message>
    <message>
        <source>number of the axis that changes from line to line, from 1</source>
        <translation>numéro de l&apos;axe qui varie d&apos;une ligne à l&apos;autre, à partir de 1</translation>
    </message>
    <message>
        <source>number of the axis of the first corrections, from 1</source>
        <translation>numéro de l&apos;axe des premières corrections, à partir de 1</translation>
    </message>
    <message>
        <source>number of the axis of the second corrections, from 1</source>
        <translation>numéro de l&apos;axe des deuxièmes corrections, à partir de 1</translation>
    </message>
    <message>
        <source>number of the axis of the third corrections, from 1</source>
        <translation>numéro de l&apos;axe des troisièmes corrections, à partir de 1</translation>
    </message>
    <message>
        <source>axis {axis} is named twice</source>
        <translation>l&apos;axe {axis} est nommé deux fois</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s, or write volatile</source>
        <translation>les opérations flash restantes suffiraient à la modification, mais pas à tout remettre en état en cas d&apos;échec&#xa0;; attendre {seconds} s ou écrire en volatil</translation>
    </message>
    <message>
        <source>{axis} has fewer than two positions</source>
        <translation>{axis} a moins de deux positions</translation>
    </message>
    <message>
        <source>the positions of {axis} do not increase strictly</source>
        <translation>les positions de {axis} ne sont pas strictement croissantes</translation>
    </message>
    <message>
        <source>the period of {axis}, {period}, is shorter than the range of its positions, {range}</source>
        <translation>la période de {axis}, {period}, est inférieure à l&apos;étendue de ses positions, {range}</translation>
    </message>
    <message>
        <source>a table has 1 to 3 source axes, this has {count}</source>
        <translation>une table a de 1 à 3 axes sources, celle-ci en a {count}</translation>
    </message>
    <message>
        <source>the table has no values</source>
        <translation>la table n&apos;a pas de valeurs</translation>
    </message>
    <message>
        <source>{number} values for {column}, for {points} points</source>
        <translation>{number} valeurs pour {column}, pour {points} points</translation>
    </message>
    <message>
        <source>a value for {column} is not a finite number</source>
        <translation>une valeur pour {column} n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>columns {first} and {second} both correct {axis} in the same direction; keep one of them</source>
        <translation>les colonnes {first} et {second} corrigent toutes deux {axis} dans le même sens&#xa0;; n&apos;en garder qu&apos;une</translation>
    </message>
    <message>
        <source>values for {column}</source>
        <translation>valeurs pour {column}</translation>
    </message>
    <message>
        <source>{column}, positive</source>
        <translation>{column}, sens positif</translation>
    </message>
    <message>
        <source>{column}, negative</source>
        <translation>{column}, sens négatif</translation>
    </message>
    <message>
        <source>table {number} of {count}:</source>
        <translation>table {number} sur {count}&#xa0;:</translation>
    </message>
    <message>
        <source>the target without a name</source>
        <translation>l&apos;axe cible sans nom</translation>
    </message>
    <message>
        <source>there are two columns for {target} in positive direction; keep one of them</source>
        <translation>il y a deux colonnes pour {target} en sens positif&#xa0;; n&apos;en garder qu&apos;une</translation>
    </message>
    <message>
        <source>there are two columns for {target} in negative direction; keep one of them</source>
        <translation>il y a deux colonnes pour {target} en sens négatif&#xa0;; n&apos;en garder qu&apos;une</translation>
    </message>
    <message>
        <source>for {target} there are values for both directions and others for one; keep one of them</source>
        <translation>pour {target}, il y a des valeurs pour les deux sens et d&apos;autres pour un seul&#xa0;; n&apos;en garder qu&apos;une sorte</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no mean; choose the positive direction</source>
        <translation>{target} n&apos;a de valeurs que pour le sens positif, donc pas de moyenne&#xa0;; choisir le sens positif</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no negative one; choose the positive direction</source>
        <translation>{target} n&apos;a de valeurs que pour le sens positif, donc aucune pour le sens négatif&#xa0;; choisir le sens positif</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no mean; choose the negative direction</source>
        <translation>{target} n&apos;a de valeurs que pour le sens négatif, donc pas de moyenne&#xa0;; choisir le sens négatif</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no positive one; choose the negative direction</source>
        <translation>{target} n&apos;a de valeurs que pour le sens négatif, donc aucune pour le sens positif&#xa0;; choisir le sens négatif</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with the correction {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap, in a machine file no-wrap = true)</source>
        <translation>un tour complet de {axis} commence par la correction {begin} et finit par {end}&#xa0;; rendre les deux égales ou traiter l&apos;axe comme linéaire (--no-wrap, dans un fichier machine no-wrap = true)</translation>
    </message>
    <message>
        <source>the numbers are too large to be added to each other</source>
        <translation>les nombres sont trop grands pour être additionnés</translation>
    </message>
    <message>
        <source>from there to {place} the correction changes by {change}, so that positions would change their order; check the unit of the values</source>
        <translation>de là à {place}, la correction varie de {change}, si bien que l&apos;ordre des positions s&apos;inverserait&#xa0;; vérifier l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>the correction of {axis} changes by {change} for each unit of the way, too much for several axes that are corrected together; check the unit of the values</source>
        <translation>la correction de {axis} varie de {change} par unité de déplacement, trop pour plusieurs axes corrigés ensemble&#xa0;; vérifier l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>the corrections are so steep that {count} steps do not find the place that belongs to it; check the unit of the values</source>
        <translation>les corrections sont si raides que {count} itérations ne suffisent pas à trouver l&apos;endroit correspondant&#xa0;; vérifier l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>the second table has no column for {column}</source>
        <translation>la deuxième table n&apos;a pas de colonne pour {column}</translation>
    </message>
    <message>
        <source>a table of {count} source axes cannot be compared with one of {other}</source>
        <translation>une table à {count} axes sources ne peut pas être comparée à une table à {other}</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more than {count} points along {axis}; with {most} it is {found}; allow more points or a larger deviation</source>
        <translation>un écart de {deviation} nécessite plus de {count} points suivant {axis}&#xa0;; avec {most}, il est de {found}&#xa0;; autoriser plus de points ou un écart plus grand</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; with {sizes} points it is {found}; allow more points or a larger deviation</source>
        <translation>un écart de {deviation} nécessite plus de points que permis&#xa0;; avec {sizes} points, il est de {found}&#xa0;; autoriser plus de points ou un écart plus grand</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; it takes at least {sizes} points; allow more points or a larger deviation</source>
        <translation>un écart de {deviation} nécessite plus de points que permis, au moins {sizes}&#xa0;; autoriser plus de points ou un écart plus grand</translation>
    </message>
    <message>
        <source>the wanted deviation must be a number of 0 or more</source>
        <translation>l&apos;écart voulu doit être un nombre supérieur ou égal à 0</translation>
    </message>
    <message>
        <source>limits for {count} axes are given, the table has {axes}</source>
        <translation>des limites sont indiquées pour {count} axes, la table en a {axes}</translation>
    </message>
    <message>
        <source>a grid has at least two points along each axis; allow as many</source>
        <translation>une grille a au moins deux points suivant chaque axe&#xa0;; en autoriser autant</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap)</source>
        <translation>un tour complet de {axis} commence par {begin} et finit par {end}&#xa0;; rendre les deux égaux ou traiter l&apos;axe comme linéaire (--no-wrap)</translation>
    </message>
    <message>
        <source>the values for {column} are too large to be interpolated</source>
        <translation>les valeurs pour {column} sont trop grandes pour être interpolées</translation>
    </message>
    <message>
        <source>grids for {count} axes are given, the table has {axes}</source>
        <translation>des grilles sont indiquées pour {count} axes, la table en a {axes}</translation>
    </message>
    <message>
        <source>the points along {axis} would be so close that positions cannot tell them apart; take fewer</source>
        <translation>les points suivant {axis} seraient trop proches pour que leurs positions se distinguent&#xa0;; en prendre moins</translation>
    </message>
    <message>
        <source>for {axis} both a number of points and a distance are given</source>
        <translation>pour {axis}, un nombre de points et un pas sont indiqués tous les deux</translation>
    </message>
    <message>
        <source>the grid along {axis} must end above its start, not go from {from} to {to}</source>
        <translation>la grille suivant {axis} doit finir au-dessus de son début et non aller de {from} à {to}</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than {most}</source>
        <translation>{count} points suivant {axis}, c&apos;est plus que {most}</translation>
    </message>
    <message>
        <source>for a part of {axis} a number of points or a distance is needed</source>
        <translation>pour une partie de {axis}, il faut un nombre de points ou un pas</translation>
    </message>
    <message>
        <source>the grid along {axis} must be one full turn, from {from} to {to}</source>
        <translation>la grille suivant {axis} doit couvrir un tour complet, de {from} à {to}</translation>
    </message>
    <message>
        <source>the grid along {axis} begins at {from}, before the data at {data}; stay within the data, or let the end values be held</source>
        <translation>la grille suivant {axis} commence à {from}, avant les données à {data}&#xa0;; rester dans les données ou maintenir les valeurs d&apos;extrémité</translation>
    </message>
    <message>
        <source>the grid along {axis} ends at {to}, behind the data at {data}; stay within the data, or let the end values be held</source>
        <translation>la grille suivant {axis} finit à {to}, après les données à {data}&#xa0;; rester dans les données ou maintenir les valeurs d&apos;extrémité</translation>
    </message>
    <message>
        <source>a distance of {distance} along {axis} makes more than {count} points</source>
        <translation>un pas de {distance} suivant {axis} donne plus de {count} points</translation>
    </message>
    <message>
        <source>the position {position} is the same as the one before when it is rounded</source>
        <translation>la position {position}, une fois arrondie, est la même que la précédente</translation>
    </message>
    <message>
        <source>the position {position} is beyond the 32 bits of its numbers</source>
        <translation>la position {position} dépasse les 32 bits de ses nombres</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 32 bits of its numbers</source>
        <translation>la valeur {value} dépasse les 32 bits de ses nombres</translation>
    </message>
    <message>
        <source>master axis {number}</source>
        <translation>axe maître {number}</translation>
    </message>
    <message>
        <source>ascending setpoints</source>
        <translation>consignes croissantes</translation>
    </message>
    <message>
        <source>{number} at the end</source>
        <translation>{number} à la fin</translation>
    </message>
    <message>
        <source>{number}, as at the beginning</source>
        <translation>{number}, comme au début</translation>
    </message>
    <message>
        <source>activate it in the axis list of axis {axis}: {parameter} 1</source>
        <translation>l&apos;activer dans la liste de l&apos;axe {axis}&#xa0;: {parameter} 1</translation>
    </message>
    <message>
        <source>QUADRATIC or RECTANGULAR</source>
        <translation>QUADRATIC ou RECTANGULAR</translation>
    </message>
    <message>
        <source>different values at both ends</source>
        <translation>des valeurs différentes aux deux extrémités</translation>
    </message>
    <message>
        <source>different values at both ends of master axis {number}</source>
        <translation>des valeurs différentes aux deux extrémités de l&apos;axe maître {number}</translation>
    </message>
    <message>
        <source>the same values: a modulo axis is at the same place there</source>
        <translation>les mêmes valeurs&#xa0;: un axe modulo y est au même endroit</translation>
    </message>
    <message>
        <source>the same values, since modulo is 1</source>
        <translation>les mêmes valeurs, puisque modulo vaut 1</translation>
    </message>
    <message>
        <source>the distance of {distance} along master {axis} is no whole number of {step}</source>
        <translation>le pas de {distance} suivant l&apos;axe maître {axis} n&apos;est pas un multiple entier de {step}</translation>
    </message>
    <message>
        <source>resample it with such a distance</source>
        <translation>la rééchantillonner avec un tel pas</translation>
    </message>
    <message>
        <source>it takes one distance for both sources, and these are different</source>
        <translation>il admet un seul pas pour les deux sources, et ceux-ci diffèrent</translation>
    </message>
    <message>
        <source>numbers of 0.1 um or 0.0001 deg</source>
        <translation>des nombres de 0,1 µm ou 0,0001 degré</translation>
    </message>
    <message>
        <source>increments for one mm or degree</source>
        <translation>des incréments par mm ou degré</translation>
    </message>
    <message>
        <source>the setting {key}, linear or rotary; linear is assumed, so that it is mm</source>
        <translation>le réglage {key}, linear ou rotary&#xa0;; linear est supposé, donc mm</translation>
    </message>
    <message>
        <source>numbers in encoder increments</source>
        <translation>des nombres en incréments du codeur</translation>
    </message>
    <message>
        <source>the setting increments-per-unit, where millimetres or degrees matter</source>
        <translation>le réglage increments-per-unit, si des millimètres ou des degrés sont nécessaires</translation>
    </message>
    <message>
        <source>the setting increments-per-unit is not above 0</source>
        <translation>le réglage increments-per-unit n&apos;est pas supérieur à 0</translation>
    </message>
    <message>
        <source>numbers in mm or degrees become increments only with the setting increments-per-unit</source>
        <translation>des nombres en mm ou en degrés ne deviennent des incréments qu&apos;avec le réglage increments-per-unit</translation>
    </message>
    <message>
        <source>an index from 0 such as [3], at most two of them</source>
        <translation>un indice à partir de 0 tel que [3], deux au plus</translation>
    </message>
    <message>
        <source>nothing after End</source>
        <translation>rien après End</translation>
    </message>
    <message>
        <source>a value behind the name and a blank</source>
        <translation>une valeur après le nom et un espace</translation>
    </message>
    <message>
        <source>the entry {name}, which is missing</source>
        <translation>l&apos;élément {name}, qui manque</translation>
    </message>
    <message>
        <source>a whole number, {range}</source>
        <translation>un nombre entier, {range}</translation>
    </message>
    <message>
        <source>no entry {name}</source>
        <translation>aucun élément {name}</translation>
    </message>
    <message>
        <source>0 or 1; 0 is assumed</source>
        <translation>0 ou 1&#xa0;; 0 est supposé</translation>
    </message>
    <message>
        <source>0 or 1; 1 is assumed</source>
        <translation>0 ou 1&#xa0;; 1 est supposé</translation>
    </message>
    <message>
        <source>the logical number of the axis, from 1</source>
        <translation>le numéro logique de l&apos;axe, à partir de 1</translation>
    </message>
    <message>
        <source>at most {number}, which is {name}</source>
        <translation>au plus {number}, selon {name}</translation>
    </message>
    <message>
        <source>at most {number}, which is the standard value of {name}</source>
        <translation>au plus {number}, la valeur par défaut de {name}</translation>
    </message>
    <message>
        <source>indices within the size that the list says</source>
        <translation>des indices dans la taille indiquée par la liste</translation>
    </message>
    <message>
        <source>{number} of them; there are {number2}</source>
        <translation>{number}&#xa0;; il y en a {number2}</translation>
    </message>
    <message>
        <source>0, or a distance above 0</source>
        <translation>0, ou un pas supérieur à 0</translation>
    </message>
    <message>
        <source>{entry} and setpoints of each point</source>
        <translation>{entry} et les consignes de chaque point</translation>
    </message>
    <message>
        <source>an interval of 0 with setpoints, or an interval without</source>
        <translation>un intervalle de 0 avec consignes, ou un intervalle sans consignes</translation>
    </message>
    <message>
        <source>values neg without bilateral 1</source>
        <translation>des valeurs neg sans bilateral 1</translation>
    </message>
    <message>
        <source>values pos only; neg is left out</source>
        <translation>des valeurs pos seulement&#xa0;; neg est ignoré</translation>
    </message>
    <message>
        <source>the index of a table, 0 to {number}</source>
        <translation>l&apos;indice d&apos;une table, de 0 à {number}</translation>
    </message>
    <message>
        <source>each variable once</source>
        <translation>chaque variable une seule fois</translation>
    </message>
    <message>
        <source>each variable once; the first is in line {line}</source>
        <translation>chaque variable une seule fois&#xa0;; la première est à la ligne {line}</translation>
    </message>
    <message>
        <source>tables {name} besides {other}</source>
        <translation>des tables {name} à côté de {other}</translation>
    </message>
    <message>
        <source>one index: [table]</source>
        <translation>un indice&#xa0;: [table]</translation>
    </message>
    <message>
        <source>two indices: [table,point]</source>
        <translation>deux indices&#xa0;: [table,point]</translation>
    </message>
    <message>
        <source>two indices: [encoder,axis]</source>
        <translation>deux indices&#xa0;: [système de mesure,axe]</translation>
    </message>
    <message>
        <source>three indices: [encoder,point,axis]</source>
        <translation>trois indices&#xa0;: [système de mesure,point,axe]</translation>
    </message>
    <message>
        <source>0, 1 or -1</source>
        <translation>0, 1 ou -1</translation>
    </message>
    <message>
        <source>{variable} of {curve}, which is missing</source>
        <translation>{variable} ({curve}), qui manque</translation>
    </message>
    <message>
        <source>a product with another table</source>
        <translation>un produit avec une autre table</translation>
    </message>
    <message>
        <source>a table by itself; the product is left out</source>
        <translation>une table seule&#xa0;; le produit est ignoré</translation>
    </message>
    <message>
        <source>variables {name}, of which there are none</source>
        <translation>des variables {name}, il n&apos;y en a aucune</translation>
    </message>
    <message>
        <source>there is no table {number}</source>
        <translation>il n&apos;y a pas de table {number}</translation>
    </message>
    <message>
        <source>choose fewer tables, or another first-table</source>
        <translation>choisir moins de tables ou un autre first-table</translation>
    </message>
    <message>
        <source>the measuring system, 0 or 1</source>
        <translation>le système de mesure, 0 ou 1</translation>
    </message>
    <message>
        <source>measuring system {number} of axis {axis}</source>
        <translation>système de mesure {number} de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>0 or 1, and the name of an axis, at most {number} of them</source>
        <translation>0 ou 1 et le nom d&apos;un axe, {number} au plus</translation>
    </message>
    <message>
        <source>axis {axis}, encoder {number}</source>
        <translation>axe {axis}, système de mesure {number}</translation>
    </message>
    <message>
        <source>its positions and values are not both lengths or both angles</source>
        <translation>ses positions et ses valeurs ne sont pas toutes des longueurs ou toutes des angles</translation>
    </message>
    <message>
        <source>axis {axis} needs $MA_MM_ENC_COMP_MAX_POINTS (MD38000) of at least {count}; load the file with $MA_ENC_COMP_ENABLE (MD32700) 0, then set it to 1</source>
        <translation>l&apos;axe {axis} exige $MA_MM_ENC_COMP_MAX_POINTS (MD38000) d&apos;au moins {count}&#xa0;; charger le fichier avec $MA_ENC_COMP_ENABLE (MD32700) à 0, puis le mettre à 1</translation>
    </message>
    <message>
        <source>an index in [ ] behind the name</source>
        <translation>un indice entre [ ] après le nom</translation>
    </message>
    <message>
        <source>an index that ends in ]</source>
        <translation>un indice terminé par ]</translation>
    </message>
    <message>
        <source>= and a value behind the index</source>
        <translation>= et une valeur après l&apos;indice</translation>
    </message>
    <message>
        <source>a value behind =</source>
        <translation>une valeur après =</translation>
    </message>
    <message>
        <source>nothing behind the end of the program, M17</source>
        <translation>rien après la fin du programme, M17</translation>
    </message>
    <message>
        <source>an assignment such as $NAME[0,1]=0.5, CHANDATA(1) or M17</source>
        <translation>une affectation telle que $NAME[0,1]=0.5, CHANDATA(1) ou M17</translation>
    </message>
    <message>
        <source>{variable} of {curve} a second time</source>
        <translation>{variable} ({curve}) une deuxième fois</translation>
    </message>
    <message>
        <source>the number of a point, from 0</source>
        <translation>le numéro d&apos;un point, à partir de 0</translation>
    </message>
    <message>
        <source>a compensation value</source>
        <translation>une valeur de compensation</translation>
    </message>
    <message>
        <source>MIN {min}, MAX {max} and STEP {step} of {curve}</source>
        <translation>MIN {min}, MAX {max} et STEP {step} ({curve})</translation>
    </message>
    <message>
        <source>a STEP above 0 and a MAX above MIN</source>
        <translation>un STEP supérieur à 0 et un MAX supérieur à MIN</translation>
    </message>
    <message>
        <source>a whole number of steps from MIN to MAX</source>
        <translation>un nombre entier de pas de MIN à MAX</translation>
    </message>
    <message>
        <source>point {number} of {curve}</source>
        <translation>point {number} ({curve})</translation>
    </message>
    <message>
        <source>point {number} of {curve} a second time</source>
        <translation>point {number} ({curve}) une deuxième fois</translation>
    </message>
    <message>
        <source>points up to {number}, which MIN, MAX and STEP give</source>
        <translation>des points jusqu&apos;à {number}, d&apos;après MIN, MAX et STEP</translation>
    </message>
    <message>
        <source>no point {number} of {curve}</source>
        <translation>aucun point {number} ({curve})</translation>
    </message>
    <message>
        <source>{number} points, which MIN, MAX and STEP give; there are {number2}</source>
        <translation>{number} points, d&apos;après MIN, MAX et STEP&#xa0;; il y en a {number2}</translation>
    </message>
    <message>
        <source>{number} at MAX of {curve}</source>
        <translation>{number} à MAX ({curve})</translation>
    </message>
    <message>
        <source>{number}, as at MIN, which follows it</source>
        <translation>{number}, comme à MIN, qui le suit</translation>
    </message>
    <message>
        <source>&quot;{axis}&quot; is no axis name for the format {format}, such as X1; give the setting {key}</source>
        <translation>«&#xa0;{axis}&#xa0;» n&apos;est pas un nom d&apos;axe pour le format {format}, tel que X1&#xa0;; indiquer le réglage {key}</translation>
    </message>
    <message>
        <source>three numbers: nominal forward reverse; the controller stops reading here without a message</source>
        <translation>trois nombres&#xa0;: nominal forward reverse&#xa0;; la commande arrête ici la lecture sans message</translation>
    </message>
    <message>
        <source>{text} after three numbers</source>
        <translation>{text} après trois nombres</translation>
    </message>
    <message>
        <source>nothing; it is left out, as the controller does</source>
        <translation>rien&#xa0;; c&apos;est ignoré, comme par la commande</translation>
    </message>
    <message>
        <source>at most 256; the controller leaves out the others</source>
        <translation>au plus 256&#xa0;; la commande ignore les autres</translation>
    </message>
    <message>
        <source>a measured position that does not increase</source>
        <translation>une position mesurée qui ne croît pas</translation>
    </message>
    <message>
        <source>increasing ones; if these are trims, the setting type=1</source>
        <translation>des positions croissantes&#xa0;; s&apos;il s&apos;agit de corrections, le réglage type=1</translation>
    </message>
    <message>
        <source>measured positions (COMP_FILE_TYPE 0)</source>
        <translation>des positions mesurées (COMP_FILE_TYPE 0)</translation>
    </message>
    <message>
        <source>the setting type=0, or type=1 if these are trims</source>
        <translation>le réglage type=0, ou type=1 s&apos;il s&apos;agit de corrections</translation>
    </message>
    <message>
        <source>increasing ones; perhaps these are trims (type=1)</source>
        <translation>des positions croissantes&#xa0;; ce sont peut-être des corrections (type=1)</translation>
    </message>
    <message>
        <source>trims that change by {change}</source>
        <translation>des corrections qui varient de {change}</translation>
    </message>
    <message>
        <source>less than the positions do; perhaps these are measured positions (type=0)</source>
        <translation>moins que les positions&#xa0;; ce sont peut-être des positions mesurées (type=0)</translation>
    </message>
    <message>
        <source>a measured position at {position} is beyond what a number can be</source>
        <translation>une position mesurée à {position} dépasse ce qu&apos;un nombre peut représenter</translation>
    </message>
    <message>
        <source>check the unit of positions and values</source>
        <translation>vérifier l&apos;unité des positions et des valeurs</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = {file} and COMP_FILE_TYPE = {type}</source>
        <translation>dans la section [JOINT_n] du fichier INI&#xa0;: COMP_FILE = {file} et COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = the file and COMP_FILE_TYPE = {type}</source>
        <translation>dans la section [JOINT_n] du fichier INI&#xa0;: COMP_FILE = le fichier et COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>BACKLASH of the joint is not used any more</source>
        <translation>BACKLASH de l&apos;articulation (joint) n&apos;est plus utilisé</translation>
    </message>
    <message>
        <source>a second section for the profile {name}</source>
        <translation>une deuxième section pour le profil {name}</translation>
    </message>
    <message>
        <source>each profile once</source>
        <translation>chaque profil une seule fois</translation>
    </message>
    <message>
        <source>an entry such as min_x = 10</source>
        <translation>un élément tel que min_x = 10</translation>
    </message>
    <message>
        <source>each entry once in a section</source>
        <translation>chaque élément une seule fois par section</translation>
    </message>
    <message>
        <source>an entry {key} in this section</source>
        <translation>un élément {key} dans cette section</translation>
    </message>
    <message>
        <source>version {version}</source>
        <translation>version {version}</translation>
    </message>
    <message>
        <source>1; the firmware does not use other versions</source>
        <translation>1&#xa0;; le firmware n&apos;utilise pas d&apos;autre version</translation>
    </message>
    <message>
        <source>a height in mm</source>
        <translation>une hauteur en mm</translation>
    </message>
    <message>
        <source>a position in mm</source>
        <translation>une position en mm</translation>
    </message>
    <message>
        <source>an offset in mm</source>
        <translation>un décalage en mm</translation>
    </message>
    <message>
        <source>a maximum above the minimum</source>
        <translation>un maximum supérieur au minimum</translation>
    </message>
    <message>
        <source>a section [bed_mesh NAME] with the points of a mesh</source>
        <translation>une section [bed_mesh NAME] avec les points d&apos;un maillage</translation>
    </message>
    <message>
        <source>{axis} from {number} to {number2} by {number3} in {number4} points</source>
        <translation>{axis} de {number} à {number2} par pas de {number3} en {number4} points</translation>
    </message>
    <message>
        <source>at least 2 along each axis</source>
        <translation>au moins 2 suivant chaque axe</translation>
    </message>
    <message>
        <source>as many points as lie between minimum and maximum</source>
        <translation>autant de points qu&apos;il y en a entre minimum et maximum</translation>
    </message>
    <message>
        <source>the axes &quot;{first}&quot; and &quot;{second}&quot;</source>
        <translation>les axes «&#xa0;{first}&#xa0;» et «&#xa0;{second}&#xa0;»</translation>
    </message>
    <message>
        <source>two different letters</source>
        <translation>deux lettres différentes</translation>
    </message>
    <message>
        <source>a point that was not probed at {position}, {other}</source>
        <translation>un point non palpé à {position}, {other}</translation>
    </message>
    <message>
        <source>a further line after {number}</source>
        <translation>une ligne de plus après {number}</translation>
    </message>
    <message>
        <source>{number} lines of heights</source>
        <translation>{number} lignes de hauteurs</translation>
    </message>
    <message>
        <source>the line {line}</source>
        <translation>la ligne {line}</translation>
    </message>
    <message>
        <source>the line {line}, or {other}</source>
        <translation>la ligne {line}, ou {other}</translation>
    </message>
    <message>
        <source>the number of one axis, from 1, behind :START</source>
        <translation>le numéro d&apos;un axe, à partir de 1, après :START</translation>
    </message>
    <message>
        <source>SAMPLEDIST= and the distance of the corrections, which is not 0</source>
        <translation>SAMPLEDIST= et le pas des corrections, différent de 0</translation>
    </message>
    <message>
        <source>choose a table of an axis for itself</source>
        <translation>choisir une table d&apos;un axe pour lui-même</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}, and the controller adds their corrections</source>
        <translation>il y a deux tables pour l&apos;axe {axis}, et la commande additionne leurs corrections</translation>
    </message>
    <message>
        <source>the number of an axis, from 1</source>
        <translation>le numéro d&apos;un axe, à partir de 1</translation>
    </message>
    <message>
        <source>7 numbers behind :START2D: row axis, column axis, two output axes, distance along rows, distance along columns, number of columns</source>
        <translation>7 nombres après :START2D&#xa0;: axe des lignes, axe des colonnes, deux axes de sortie, pas le long des lignes, pas le long des colonnes, nombre de colonnes</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>un pas</translation>
    </message>
    <message>
        <source>the number of columns</source>
        <translation>le nombre de colonnes</translation>
    </message>
    <message>
        <source>a distance of 0</source>
        <translation>un pas de 0</translation>
    </message>
    <message>
        <source>a distance that is not 0</source>
        <translation>un pas différent de 0</translation>
    </message>
    <message>
        <source>axis {number} for rows and columns</source>
        <translation>l&apos;axe {number} pour les lignes et les colonnes</translation>
    </message>
    <message>
        <source>two axes</source>
        <translation>deux axes</translation>
    </message>
    <message>
        <source>{number} points of {number2} corrections each in a row</source>
        <translation>{number} points de {number2} corrections chacun dans une ligne</translation>
    </message>
    <message>
        <source>KEY=VALUE</source>
        <translation>CLÉ=VALEUR</translation>
    </message>
    <message>
        <source>:END of the table that begins in line {line}</source>
        <translation>:END de la table qui commence à la ligne {line}</translation>
    </message>
    <message>
        <source>{directive} before :END</source>
        <translation>{directive} avant :END</translation>
    </message>
    <message>
        <source>a table that begins with {directive}</source>
        <translation>une table qui commence par {directive}</translation>
    </message>
    <message>
        <source>a table that begins with {directive} and ends with :END</source>
        <translation>une table qui commence par {directive} et se termine par :END</translation>
    </message>
    <message>
        <source>{directive} or :END; tables of one and of two dimensions are in separate files</source>
        <translation>{directive} ou :END&#xa0;; les tables à une et à deux dimensions sont dans des fichiers séparés</translation>
    </message>
    <message>
        <source>each option once</source>
        <translation>chaque option une seule fois</translation>
    </message>
    <message>
        <source>{key}= and a number</source>
        <translation>{key}= et un nombre</translation>
    </message>
    <message>
        <source>positions in the coordinates of the axis after homing; it is left out</source>
        <translation>des positions dans les coordonnées de l&apos;axe après la prise d&apos;origine&#xa0;; l&apos;option est ignorée</translation>
    </message>
    <message>
        <source>a table without {key}</source>
        <translation>une table sans {key}</translation>
    </message>
    <message>
        <source>{key}=METRIC, ENGLISH, PRIMARY, SECONDARY or COUNTS, perhaps divided by a number as in METRIC/1000</source>
        <translation>{key}=METRIC, ENGLISH, PRIMARY, SECONDARY ou COUNTS, éventuellement divisé par un nombre comme METRIC/1000</translation>
    </message>
    <message>
        <source>a correction that is too large for its unit</source>
        <translation>une correction trop grande pour son unité</translation>
    </message>
    <message>
        <source>another CORUNIT</source>
        <translation>un autre CORUNIT</translation>
    </message>
    <message>
        <source>two numbers such as 0.25,0.001: position and offset</source>
        <translation>deux nombres tels que 0.25,0.001&#xa0;: position et décalage</translation>
    </message>
    <message>
        <source>a position such as 0.25</source>
        <translation>une position telle que 0.25</translation>
    </message>
    <message>
        <source>an offset such as 0.001</source>
        <translation>un décalage tel que 0.001</translation>
    </message>
    <message>
        <source>lines of {expected}</source>
        <translation>des lignes de {expected}</translation>
    </message>
    <message>
        <source>&quot;{line}&quot;, which is taken to be a header</source>
        <translation>«&#xa0;{line}&#xa0;», interprété comme un en-tête</translation>
    </message>
    <message>
        <source>{expected}, if it is a point</source>
        <translation>{expected}, si c&apos;est un point</translation>
    </message>
    <message>
        <source>position + offset {number} after {number2}</source>
        <translation>position + décalage {number} après {number2}</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>strictly decreasing positions</source>
        <translation>des positions strictement décroissantes</translation>
    </message>
    <message>
        <source>strictly increasing positions</source>
        <translation>des positions strictement croissantes</translation>
    </message>
    <message>
        <source>strictly decreasing values, as the positions are</source>
        <translation>des valeurs strictement décroissantes, comme les positions</translation>
    </message>
    <message>
        <source>strictly increasing values, as the positions are</source>
        <translation>des valeurs strictement croissantes, comme les positions</translation>
    </message>
    <message>
        <source>positions from {first} to {last}</source>
        <translation>des positions de {first} à {last}</translation>
    </message>
    <message>
        <source>a span of exactly {range}, the wrap range</source>
        <translation>une étendue d&apos;exactement {range}, l&apos;étendue d&apos;un tour</translation>
    </message>
    <message>
        <source>the offsets {first} and {last} at the ends</source>
        <translation>les décalages {first} et {last} aux extrémités</translation>
    </message>
    <message>
        <source>the same offset at both ends, which are one place</source>
        <translation>le même décalage aux deux extrémités, qui sont le même endroit</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, expected more than 0</source>
        <translation>le réglage wrap-range est {value}, attendu&#xa0;: plus de 0</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, and the table repeats after {period}</source>
        <translation>le réglage wrap-range est {value}, et la table se répète après {period}</translation>
    </message>
    <message>
        <source>at {position} position + offset {sum} after {before} does not increase (error 4900 of the controller)</source>
        <translation>à {position}, position + décalage ne croît pas&#xa0;: {sum} après {before} (erreur 4900 de la commande)</translation>
    </message>
    <message>
        <source>check the unit of the values, or smooth them</source>
        <translation>vérifier l&apos;unité des valeurs ou les lisser</translation>
    </message>
    <message>
        <source>of a rotary axis it wants {expected}, and this table has {found} (error 4902 of the controller)</source>
        <translation>pour un axe rotatif, il faut {expected}, et cette table a {found} (erreur 4902 de la commande)</translation>
    </message>
    <message>
        <source>add the point that closes the revolution</source>
        <translation>ajouter le point qui ferme le tour</translation>
    </message>
    <message>
        <source>the controller looks for the file as {name}PosComp.CSV, unless axis.xml names another one</source>
        <translation>la commande cherche le fichier sous le nom {name}PosComp.CSV, sauf si axis.xml en indique un autre</translation>
    </message>
    <message>
        <source>the controller looks for the file as the name of the axis and PosComp.CSV, unless axis.xml names another one</source>
        <translation>la commande cherche le fichier sous le nom de l&apos;axe suivi de PosComp.CSV, sauf si axis.xml en indique un autre</translation>
    </message>
    <message>
        <source>motor {number}</source>
        <translation>moteur {number}</translation>
    </message>
    <message>
        <source>a number of entries</source>
        <translation>un nombre d&apos;entrées</translation>
    </message>
    <message>
        <source>the number of a motor, #1 to #32, perhaps with a D</source>
        <translation>le numéro d&apos;un moteur, de #1 à #32, éventuellement avec un D</translation>
    </message>
    <message>
        <source>DEFINE COMP entries,#source,#target,span</source>
        <translation>DEFINE COMP entrées,#source,#cible,étendue</translation>
    </message>
    <message>
        <source>DEFINE COMP rows.columns,#row,#column,#target,span,span</source>
        <translation>DEFINE COMP lignes.colonnes,#ligne,#colonne,#cible,étendue,étendue</translation>
    </message>
    <message>
        <source>a span in counts</source>
        <translation>une étendue en incréments</translation>
    </message>
    <message>
        <source>a span of {span}</source>
        <translation>une étendue de {span}</translation>
    </message>
    <message>
        <source>a span of {span} counts</source>
        <translation>une étendue de {span} incréments</translation>
    </message>
    <message>
        <source>at least 1 count</source>
        <translation>au moins 1 incrément</translation>
    </message>
    <message>
        <source>motors that are not named</source>
        <translation>des moteurs qui ne sont pas nommés</translation>
    </message>
    <message>
        <source>the motor that is addressed when the file is loaded; name it with #</source>
        <translation>le moteur adressé au chargement du fichier&#xa0;; le nommer avec #</translation>
    </message>
    <message>
        <source>a table of one dimension</source>
        <translation>une table à une dimension</translation>
    </message>
    <message>
        <source>a table of two dimensions</source>
        <translation>une table à deux dimensions</translation>
    </message>
    <message>
        <source>further entries: {entries}</source>
        <translation>d&apos;autres entrées&#xa0;: {entries}</translation>
    </message>
    <message>
        <source>DEFINE COMP in front of them</source>
        <translation>DEFINE COMP devant celles-ci</translation>
    </message>
    <message>
        <source>a whole number of 1/16 count</source>
        <translation>un nombre entier de 1/16 d&apos;incrément</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of one dimension</source>
        <translation>DEFINE COMP pour une table à une dimension</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of two dimensions</source>
        <translation>DEFINE COMP pour une table à deux dimensions</translation>
    </message>
    <message>
        <source>a table in counts</source>
        <translation>une table en incréments</translation>
    </message>
    <message>
        <source>different entries at 0 and at the span of motor {motor}</source>
        <translation>des entrées différentes à 0 et à la fin de l&apos;étendue du moteur {motor}</translation>
    </message>
    <message>
        <source>the same: the table rolls over there</source>
        <translation>les mêmes&#xa0;: la table y recommence</translation>
    </message>
    <message>
        <source>entries that are too large in these units</source>
        <translation>des entrées trop grandes dans ces unités</translation>
    </message>
    <message>
        <source>another counts-per-unit</source>
        <translation>un autre counts-per-unit</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected a number above 0</source>
        <translation>le réglage {key} du format {format} est {value}, attendu&#xa0;: un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>position 0, where its tables begin, is no point of source {number}</source>
        <translation>la position 0, où commencent ses tables, n&apos;est pas un point de la source {number}</translation>
    </message>
    <message>
        <source>resample it with a point at 0</source>
        <translation>la rééchantillonner avec un point à 0</translation>
    </message>
    <message>
        <source>its tables begin at position 0, which source {number} does not reach</source>
        <translation>ses tables commencent à la position 0, que la source {number} n&apos;atteint pas</translation>
    </message>
    <message>
        <source>add points to the table, as far as position 0</source>
        <translation>ajouter des points à la table, jusqu&apos;à la position 0</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the positions</source>
        <translation>vérifier counts-per-unit et l&apos;unité des positions</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 24 bits of an entry</source>
        <translation>la valeur {value} dépasse les 24 bits d&apos;une entrée</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the values</source>
        <translation>vérifier counts-per-unit et l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>its value at position 0 is {value}, and the controller takes it to be 0 there</source>
        <translation>sa valeur à la position 0 est {value}, et la commande y suppose 0</translation>
    </message>
    <message>
        <source>there is no motor {number}</source>
        <translation>il n&apos;y a pas de moteur {number}</translation>
    </message>
    <message>
        <source>choose one from 1 to 32</source>
        <translation>en choisir un de 1 à 32</translation>
    </message>
    <message>
        <source>switch the table on with I51=1; outside of its span it rolls over</source>
        <translation>activer la table par I51=1&#xa0;; hors de son étendue, elle recommence</translation>
    </message>
    <message>
        <source>a line &quot;# {key} = NUMBER&quot; before the counts</source>
        <translation>une ligne «&#xa0;# {key} = NOMBRE&#xa0;» avant les incréments</translation>
    </message>
    <message>
        <source>{number} to {number2} by {number3}</source>
        <translation>{number} à {number2} par pas de {number3}</translation>
    </message>
    <message>
        <source>a maximum above the minimum, and a delta above 0</source>
        <translation>un maximum supérieur au minimum et un pas supérieur à 0</translation>
    </message>
    <message>
        <source>a range that is an integer multiple of the delta</source>
        <translation>une étendue multiple entier du pas</translation>
    </message>
    <message>
        <source>the unit {unit}</source>
        <translation>l&apos;unité {unit}</translation>
    </message>
    <message>
        <source>values in counts</source>
        <translation>des valeurs en incréments</translation>
    </message>
    <message>
        <source>a line &quot;# output.counts-per-unit = NUMBER&quot;, or the setting counts-per-unit</source>
        <translation>une ligne «&#xa0;# output.counts-per-unit = NOMBRE&#xa0;» ou le réglage counts-per-unit</translation>
    </message>
    <message>
        <source>a number of counts</source>
        <translation>un nombre d&apos;incréments</translation>
    </message>
    <message>
        <source>{number} counts per unit</source>
        <translation>{number} incréments par unité</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>un nombre différent de 0</translation>
    </message>
    <message>
        <source>{number}, one for each position of the first axis</source>
        <translation>{number}, un par position du premier axe</translation>
    </message>
    <message>
        <source>{number}, one for each position of the second axis</source>
        <translation>{number}, une par position du deuxième axe</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>une ligne</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected a C++ name: letters, digits and _</source>
        <translation>le réglage name est «&#xa0;{name}&#xa0;», attendu&#xa0;: un nom C++&#xa0;: lettres, chiffres et _</translation>
    </message>
    <message>
        <source>the value {value} is {count} counts, and at most 2147483647 can be held</source>
        <translation>la valeur {value} fait {count} incréments, et 2147483647 au plus sont possibles</translation>
    </message>
    <message>
        <source>the setting counts-per-unit is 0, expected a number of counts</source>
        <translation>le réglage counts-per-unit est 0, attendu&#xa0;: un nombre d&apos;incréments</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 {unit}</source>
        <translation>counts-per-unit est compris comme {count} incréments pour 1 {unit}</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 unit of the values</source>
        <translation>counts-per-unit est compris comme {count} incréments pour 1 unité des valeurs</translation>
    </message>
    <message>
        <source>an input axis is the output axis: its command position must be the input, the actual position is not possible</source>
        <translation>un axe d&apos;entrée est l&apos;axe de sortie&#xa0;: l&apos;entrée doit être sa position de consigne, sa position réelle n&apos;est pas possible</translation>
    </message>
    <message>
        <source>the inputs are other axes: their command or their actual positions can be the inputs</source>
        <translation>les entrées sont d&apos;autres axes&#xa0;: leurs positions de consigne ou réelles peuvent servir d&apos;entrées</translation>
    </message>
    <message>
        <source>the number of source axes, 1 to 3</source>
        <translation>le nombre d&apos;axes sources, de 1 à 3</translation>
    </message>
    <message>
        <source>{number}, one for each source axis</source>
        <translation>{number}, un par axe source</translation>
    </message>
    <message>
        <source>the number of points of a source</source>
        <translation>le nombre de points d&apos;une source</translation>
    </message>
    <message>
        <source>at least 2, and at most {number} rows in all</source>
        <translation>au moins 2, et au plus {number} lignes en tout</translation>
    </message>
    <message>
        <source>{number}, as in the first row</source>
        <translation>{number}, comme dans la première ligne</translation>
    </message>
    <message>
        <source>a source position</source>
        <translation>une position de la source</translation>
    </message>
    <message>
        <source>{number} for source {number2}</source>
        <translation>{number} pour la source {number2}</translation>
    </message>
    <message>
        <source>{number}: the first source changes fastest</source>
        <translation>{number}&#xa0;: la première source varie le plus vite</translation>
    </message>
    <message>
        <source>positions of source {axis} from {first} to {last}</source>
        <translation>les positions de la source {axis} de {first} à {last}</translation>
    </message>
    <message>
        <source>equal distances</source>
        <translation>des pas égaux</translation>
    </message>
    <message>
        <source>a header of {sizes} = {number} rows, and {number2} rows</source>
        <translation>un en-tête pour {sizes} = {number} lignes, et {number2} lignes</translation>
    </message>
    <message>
        <source>as many rows as the header says</source>
        <translation>autant de lignes que l&apos;en-tête l&apos;indique</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected letters, digits and _, beginning with a letter</source>
        <translation>le réglage name est «&#xa0;{name}&#xa0;», attendu&#xa0;: lettres, chiffres et _, en commençant par une lettre</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, and not be in use (CompActive = 0) while the lines run</source>
        <translation>la table {name} doit être définie dans le programme, avec {count} points, et ne pas être en service (CompActive = 0) pendant l&apos;exécution des lignes</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, the first source fastest, and not be in use (CompActive = 0) while the lines run</source>
        <translation>la table {name} doit être définie dans le programme, avec {count} points, la première source variant le plus vite, et ne pas être en service (CompActive = 0) pendant l&apos;exécution des lignes</translation>
    </message>
    <message>
        <source>{number} after {number2}</source>
        <translation>{number} après {number2}</translation>
    </message>
    <message>
        <source>strictly increasing positions of {axis}</source>
        <translation>des positions de {axis} strictement croissantes</translation>
    </message>
    <message>
        <source>positions of {axis}</source>
        <translation>les positions de {axis}</translation>
    </message>
    <message>
        <source>positions of the axis</source>
        <translation>les positions de l&apos;axe</translation>
    </message>
    <message>
        <source>numbers that a computer can tell from each other; check their size</source>
        <translation>des nombres qu&apos;un ordinateur peut distinguer entre eux&#xa0;; vérifier leur grandeur</translation>
    </message>
    <message>
        <source>values of {target}</source>
        <translation>les valeurs de {target}</translation>
    </message>
    <message>
        <source>values of the table</source>
        <translation>les valeurs de la table</translation>
    </message>
    <message>
        <source>numbers that a computer can hold; check their size</source>
        <translation>des nombres qu&apos;un ordinateur peut représenter&#xa0;; vérifier leur grandeur</translation>
    </message>
    <message>
        <source>axis {number}</source>
        <translation>axe {number}</translation>
    </message>
    <message>
        <source>source {number}</source>
        <translation>source {number}</translation>
    </message>
    <message>
        <source>table {number}</source>
        <translation>table {number}</translation>
    </message>
    <message>
        <source>at least 2</source>
        <translation>au moins 2</translation>
    </message>
    <message>
        <source>{number} to {number2}</source>
        <translation>{number} à {number2}</translation>
    </message>
    <message>
        <source>at most {number} points</source>
        <translation>au plus {number} points</translation>
    </message>
    <message>
        <source>{number} lines</source>
        <translation>{number} lignes</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>un nombre de points</translation>
    </message>
    <message>
        <source>a number for {key}</source>
        <translation>un nombre pour {key}</translation>
    </message>
    <message>
        <source>the number of {key}</source>
        <translation>le nombre pour {key}</translation>
    </message>
    <message>
        <source>a distance above 0</source>
        <translation>un pas supérieur à 0</translation>
    </message>
    <message>
        <source>a correction</source>
        <translation>une correction</translation>
    </message>
    <message>
        <source>{what} a second time</source>
        <translation>{what} une deuxième fois</translation>
    </message>
    <message>
        <source>a second {key}</source>
        <translation>{key} une deuxième fois</translation>
    </message>
    <message>
        <source>each entry once</source>
        <translation>chaque élément une seule fois</translation>
    </message>
    <message>
        <source>each entry once; the first is in line {line}</source>
        <translation>chaque élément une seule fois&#xa0;; le premier est à la ligne {line}</translation>
    </message>
    <message>
        <source>each point once</source>
        <translation>chaque point une seule fois</translation>
    </message>
    <message>
        <source>{value}, as {key} says</source>
        <translation>{value}, comme {key} l&apos;indique</translation>
    </message>
    <message>
        <source>{value}, as the setting {key} says</source>
        <translation>{value}, comme le réglage {key} l&apos;indique</translation>
    </message>
    <message>
        <source>{number}, one for each position of {axis}</source>
        <translation>{number}, une par position de {axis}</translation>
    </message>
    <message>
        <source>the format {format} to read it; it is left out here</source>
        <translation>le format {format} pour la lire&#xa0;; elle est ignorée ici</translation>
    </message>
    <message>
        <source>the format {format} to read them; they are left out here</source>
        <translation>le format {format} pour les lire&#xa0;; elles sont ignorées ici</translation>
    </message>
    <message>
        <source>numbers in {from} cannot be given in {to}</source>
        <translation>des nombres en {from} ne peuvent pas être exprimés en {to}</translation>
    </message>
    <message>
        <source>a unit that is not said</source>
        <translation>unité non indiquée</translation>
    </message>
    <message>
        <source>positions without a unit</source>
        <translation>des positions sans unité</translation>
    </message>
    <message>
        <source>values without a unit</source>
        <translation>des valeurs sans unité</translation>
    </message>
    <message>
        <source>numbers without a unit</source>
        <translation>des nombres sans unité</translation>
    </message>
    <message>
        <source>the setting {key}, where a unit matters</source>
        <translation>le réglage {key}, si une unité est nécessaire</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>positions</translation>
    </message>
    <message>
        <source>values</source>
        <translation>valeurs</translation>
    </message>
    <message>
        <source>not all units are said: the values are taken to be in the unit of the positions</source>
        <translation>toutes les unités ne sont pas indiquées&#xa0;: pour les valeurs, l&apos;unité des positions est supposée</translation>
    </message>
    <message>
        <source>the values were in {before} and are now in {unit}, the unit of the positions</source>
        <translation>les valeurs étaient en {before} et sont maintenant en {unit}, l&apos;unité des positions</translation>
    </message>
    <message>
        <source>positions in {unit} and values in {other}</source>
        <translation>des positions en {unit} et des valeurs en {other}</translation>
    </message>
    <message>
        <source>one unit, since the controller adds the values to the positions</source>
        <translation>une seule unité, car la commande ajoute les valeurs aux positions</translation>
    </message>
    <message>
        <source>{units}: the format {format} has one unit for both</source>
        <translation>{units}&#xa0;: le format {format} a une seule unité pour les deux</translation>
    </message>
    <message>
        <source>choose a format for cross compensation</source>
        <translation>choisir un format de compensation croisée</translation>
    </message>
    <message>
        <source>check the unit of the table</source>
        <translation>vérifier l&apos;unité de la table</translation>
    </message>
    <message>
        <source>check the units of the table</source>
        <translation>vérifier les unités de la table</translation>
    </message>
    <message>
        <source>the {what} are in {from}, which cannot be given in {to}; correct the units</source>
        <translation>l&apos;unité {from} ne peut pas être convertie en {to} ({what})&#xa0;; corriger les unités</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for writing; it has: {known}</source>
        <translation>le format {format} n&apos;a pas de réglage {key} à l&apos;écriture&#xa0;; réglages possibles&#xa0;: {known}</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for reading; it has: {known}</source>
        <translation>le format {format} n&apos;a pas de réglage {key} à la lecture&#xa0;; réglages possibles&#xa0;: {known}</translation>
    </message>
    <message>
        <source>the format {format} can be read, not written</source>
        <translation>le format {format} peut être lu, mais pas écrit</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1; the setting {key} is {value}</source>
        <translation>le format {format} désigne ses axes par des numéros à partir de 1&#xa0;; le réglage {key} est {value}</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1 and there is no number in the axis name &quot;{name}&quot;; give the setting {key}</source>
        <translation>le format {format} désigne ses axes par des numéros à partir de 1, et le nom d&apos;axe «&#xa0;{name}&#xa0;» n&apos;en contient pas&#xa0;; indiquer le réglage {key}</translation>
    </message>
    <message>
        <source>its positions of source {number} span {span}, and a modulo axis needs exactly one period of {period}</source>
        <translation>ses positions de la source {number} couvrent {span}, et un axe modulo exige exactement une période de {period}</translation>
    </message>
    <message>
        <source>resample it over one whole period</source>
        <translation>la rééchantillonner sur une période entière</translation>
    </message>
    <message>
        <source>the values at both ends of the modulo axis, source {number}, differ by {difference}</source>
        <translation>les valeurs aux deux extrémités de l&apos;axe modulo, source {number}, diffèrent de {difference}</translation>
    </message>
    <message>
        <source>make both ends equal: they are the same place</source>
        <translation>rendre les deux extrémités égales&#xa0;: elles sont le même endroit</translation>
    </message>
    <message>
        <source>its modulo axis is not rotary</source>
        <translation>son axe modulo n&apos;est pas rotatif</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap)</source>
        <translation>traiter l&apos;axe comme linéaire (--no-wrap)</translation>
    </message>
    <message>
        <source>it takes a column for both directions of motion, or one for each direction of one axis</source>
        <translation>il admet une colonne pour les deux sens de déplacement, ou une pour chaque sens d&apos;un même axe</translation>
    </message>
    <message>
        <source>choose these columns</source>
        <translation>choisir ces colonnes</translation>
    </message>
    <message>
        <source>{count} columns are more than the {limit} of one table</source>
        <translation>{count} colonnes, une table en a {limit} au plus</translation>
    </message>
    <message>
        <source>choose a column, and write the others to files of their own</source>
        <translation>choisir une colonne et écrire les autres dans leurs propres fichiers</translation>
    </message>
    <message>
        <source>{count} tables are more than the {limit} of one file</source>
        <translation>{count} tables, un fichier en a {limit} au plus</translation>
    </message>
    <message>
        <source>choose one, and write the others to files of their own</source>
        <translation>en choisir une et écrire les autres dans leurs propres fichiers</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>en choisir une</translation>
    </message>
    <message>
        <source>{size} bytes are more than the {limit} of a file</source>
        <translation>{size} octets, un fichier en a {limit} au plus</translation>
    </message>
    <message>
        <source>write it as {format}</source>
        <translation>l&apos;écrire en {format}</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}</source>
        <translation>il y a deux tables pour l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>a TAM table needs the table layout of a drive profile</source>
        <translation>une table TAM exige l&apos;organisation de table d&apos;un profil de variateur</translation>
    </message>
    <message>
        <source>a calibration file needs the number of its dimensions: 1, 2 or 3</source>
        <translation>un fichier d&apos;étalonnage exige le nombre de ses dimensions&#xa0;: 1, 2 ou 3</translation>
    </message>
    <message>
        <source>a table kw.{name} besides kw.{other}</source>
        <translation>une table kw.{name} à côté de kw.{other}</translation>
    </message>
    <message>
        <source>a point kw.{point} with one index</source>
        <translation>un point kw.{point} à un indice</translation>
    </message>
    <message>
        <source>a point kw.{point} with two indices</source>
        <translation>un point kw.{point} à deux indices</translation>
    </message>
    <message>
        <source>a table kw.{name}, of which there is no entry</source>
        <translation>une table kw.{name}, dont il n&apos;y a aucun élément</translation>
    </message>
    <message>
        <source>the setting {key}, such as mm, where a unit matters</source>
        <translation>le réglage {key}, par exemple mm, si une unité est nécessaire</translation>
    </message>
    <message>
        <source>byte {value}</source>
        <translation>octet {value}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid calibration file: {count} problems</source>
        <comment>{file} is not a valid calibration file: one problem</comment>
        <translation>
            <numerusform>{file} n&apos;est pas un fichier d&apos;étalonnage valide&#xa0;: {count} problème</numerusform>
            <numerusform>{file} n&apos;est pas un fichier d&apos;étalonnage valide&#xa0;: {count} problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>there is a source for dimension {dimension}, but the table is {dimensions}D</source>
        <translation>il y a une source pour la dimension {dimension}, mais la table est {dimensions}D</translation>
    </message>
    <message>
        <source>the table is {table}D, but {chosen}D is chosen</source>
        <translation>la table est {table}D, mais {chosen}D est choisi</translation>
    </message>
    <message>
        <source>{time} ({step})</source>
        <translation>{time} ({step})</translation>
    </message>
    <message>
        <source>sign: {from}, {to}; {example}</source>
        <translation>signe&#xa0;: {from}, {to}&#xa0;; {example}</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positif</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>négatif</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}&#xa0;; {next}</translation>
    </message>
    <message>
        <source>position {number} = {position}</source>
        <translation>position {number} = {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} columns</source>
        <comment>1 column</comment>
        <translation>
            <numerusform>{count} colonne</numerusform>
            <numerusform>{count} colonnes</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a value of type {type}; expected {expected}</source>
        <translation>«&#xa0;{text}&#xa0;» n&apos;est pas une valeur de type {type}&#xa0;; attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>a number such as 12.5, at most {most} in magnitude</source>
        <translation>un nombre tel que 12.5, au plus {most} en valeur absolue</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}, or an address such as 0x1234</source>
        <translation>un nombre entier de {least} à {most}, ou une adresse telle que 0x1234</translation>
    </message>
    <message>
        <source>the name of an enum value, without blanks</source>
        <translation>le nom d&apos;une valeur d&apos;énumération, sans espaces</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}</source>
        <translation>un nombre entier de {least} à {most}</translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections</source>
        <comment>1 correction</comment>
        <translation>
            <numerusform>{count} correction</numerusform>
            <numerusform>{count} corrections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} rows</source>
        <comment>1 row</comment>
        <translation>
            <numerusform>{count} ligne</numerusform>
            <numerusform>{count} lignes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections in this line, {all} in all</source>
        <comment>1 correction in this line, {all} in all</comment>
        <translation>
            <numerusform>{count} correction dans cette ligne, {all} en tout</numerusform>
            <numerusform>{count} corrections dans cette ligne, {all} en tout</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has {count} source axes, possible are {range}</source>
        <comment>it has 1 source axis, possible are {range}</comment>
        <translation>
            <numerusform>elle a {count} axe source, possible&#xa0;: {range}</numerusform>
            <numerusform>elle a {count} axes sources, possible&#xa0;: {range}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>{count} nombre</numerusform>
            <numerusform>{count} nombres</numerusform>
        </translation>
    </message>
    <message>
        <source>logical number of master axis 1, for master1_ax_nr</source>
        <translation>numéro logique de l&apos;axe maître 1, pour master1_ax_nr</translation>
    </message>
    <message>
        <source>logical number of master axis 2, for master2_ax_nr</source>
        <translation>numéro logique de l&apos;axe maître 2, pour master2_ax_nr</translation>
    </message>
    <message>
        <source>whether master axis 1 is linear (mm) or rotary (deg)</source>
        <translation>si l&apos;axe maître 1 est linéaire (mm) ou rotatif (degrés)</translation>
    </message>
    <message>
        <source>whether master axis 2 is linear (mm) or rotary (deg)</source>
        <translation>si l&apos;axe maître 2 est linéaire (mm) ou rotatif (degrés)</translation>
    </message>
    <message>
        <source>master axis 1 is a modulo axis: its ends are one place</source>
        <translation>l&apos;axe maître 1 est un axe modulo&#xa0;: ses extrémités sont le même endroit</translation>
    </message>
    <message>
        <source>master axis 2 is a modulo axis: its ends are one place</source>
        <translation>l&apos;axe maître 2 est un axe modulo&#xa0;: ses extrémités sont le même endroit</translation>
    </message>
    <message numerus="yes">
        <source>{count} points</source>
        <comment>1 point</comment>
        <translation>
            <numerusform>{count} point</numerusform>
            <numerusform>{count} points</numerusform>
        </translation>
    </message>
    <message>
        <source>no {name}</source>
        <translation>{name} manque</translation>
    </message>
    <message numerus="yes">
        <source>{count} heights</source>
        <comment>1 height</comment>
        <translation>
            <numerusform>{count} hauteur</numerusform>
            <numerusform>{count} hauteurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of points</source>
        <comment>1 line of points</comment>
        <translation>
            <numerusform>{count} ligne de points</numerusform>
            <numerusform>{count} lignes de points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} entries</source>
        <comment>1 entry</comment>
        <translation>
            <numerusform>{count} entrée</numerusform>
            <numerusform>{count} entrées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values</source>
        <comment>1 value</comment>
        <translation>
            <numerusform>{count} valeur</numerusform>
            <numerusform>{count} valeurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of counts</source>
        <comment>1 line of counts</comment>
        <translation>
            <numerusform>{count} ligne d&apos;incréments</numerusform>
            <numerusform>{count} lignes d&apos;incréments</numerusform>
        </translation>
    </message>
    <message>
        <source>{number}: {names}</source>
        <translation>{number}&#xa0;: {names}</translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of heights</source>
        <comment>1 line of heights</comment>
        <translation>
            <numerusform>{count} ligne de hauteurs</numerusform>
            <numerusform>{count} lignes de hauteurs</numerusform>
        </translation>
    </message>
    <message>
        <source>table {index} needs $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) of at least {count}; switch it on with $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 and $MA_CEC_ENABLE (MD32710) 1 of axis {axis}</source>
        <translation>la table {index} exige $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) d&apos;au moins {count}&#xa0;; l&apos;activer par $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 et $MA_CEC_ENABLE (MD32710) 1 de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>no {variable} of {curve}</source>
        <translation>{variable} manque pour {curve}</translation>
    </message>
    <message numerus="yes">
        <source>{count} source axes</source>
        <comment>1 source axis</comment>
        <translation>
            <numerusform>{count} axe source</numerusform>
            <numerusform>{count} axes sources</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} sizes</source>
        <comment>1 size</comment>
        <translation>
            <numerusform>{count} taille</numerusform>
            <numerusform>{count} tailles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions and at least one correction</source>
        <comment>1 position and at least one correction</comment>
        <translation>
            <numerusform>{count} position et au moins une correction</numerusform>
            <numerusform>{count} positions et au moins une correction</numerusform>
        </translation>
    </message>
    <message>
        <source>{axes}</source>
        <translation>{axes}</translation>
    </message>
    <message>
        <source>{axes} to {target}</source>
        <translation>{axes} vers {target}</translation>
    </message>
    <message>
        <source>(table layout)</source>
        <translation>(organisation de la table)</translation>
    </message>
    <message>
        <source>it cannot be of type {type}; expected {expected}</source>
        <translation>le type {type} n&apos;est pas possible&#xa0;; attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>f32 or f64</source>
        <translation>f32 ou f64</translation>
    </message>
    <message>
        <source>u8, u16, u32 or i32</source>
        <translation>u8, u16, u32 ou i32</translation>
    </message>
    <message>
        <source>its count is {found}, expected the length of the magic text, {expected}, which is at least 1</source>
        <translation>le nombre d&apos;éléments est {found}, attendu&#xa0;: la longueur du texte d&apos;identification (magic), {expected}, au moins 1</translation>
    </message>
    <message>
        <source>its count is 0, expected at least 1</source>
        <translation>le nombre d&apos;éléments est 0, attendu&#xa0;: au moins 1</translation>
    </message>
    <message>
        <source>its count is {found}, expected {expected}</source>
        <translation>le nombre d&apos;éléments est {found}, attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>its type {type} cannot hold {value}</source>
        <translation>son type {type} ne peut pas contenir {value}</translation>
    </message>
    <message>
        <source>it ends at byte {end}, but the header has only {size} bytes</source>
        <translation>il se termine à l&apos;octet {end}, mais l&apos;en-tête n&apos;a que {size} octets</translation>
    </message>
    <message>
        <source>it covers the header bytes before it, and there are none</source>
        <translation>il couvre les octets de l&apos;en-tête qui le précèdent, et il n&apos;y en a pas</translation>
    </message>
    <message>
        <source>it begins at byte {begin}, inside {field}, which ends at byte {end}</source>
        <translation>il commence à l&apos;octet {begin}, à l&apos;intérieur de {field}, qui se termine à l&apos;octet {end}</translation>
    </message>
    <message>
        <source>it is {size}, expected 1 to {limit} bytes</source>
        <translation>la taille est {size}, attendu&#xa0;: 1 à {limit} octets</translation>
    </message>
    <message>
        <source>it is missing; a table cannot be read without it</source>
        <translation>champ manquant&#xa0;; sans lui, aucune table n&apos;est lisible</translation>
    </message>
    <message numerus="yes">
        <source>{count} positions</source>
        <comment>1 position</comment>
        <translation>
            <numerusform>{count} position</numerusform>
            <numerusform>{count} positions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions of {axis}</source>
        <comment>1 position of {axis}</comment>
        <translation>
            <numerusform>{count} position de {axis}</numerusform>
            <numerusform>{count} positions de {axis}</numerusform>
        </translation>
    </message>
    <message>
        <source>CRC {crc}</source>
        <translation>CRC {crc}</translation>
    </message>
    <message>
        <source>the body is not JSON</source>
        <translation>le corps n&apos;est pas du JSON</translation>
    </message>
    <message>
        <source>the body must be an array, {example}</source>
        <translation>le corps doit être un tableau, {example}</translation>
    </message>
    <message>
        <source>{place} must be an object, {example}</source>
        <translation>{place} doit être un objet, {example}</translation>
    </message>
    <message>
        <source>{place}.path must be a text</source>
        <translation>{place}.path doit être un texte</translation>
    </message>
    <message>
        <source>{place}.value must be a number, a text, true, false or null</source>
        <translation>{place}.value doit être un nombre, un texte, true, false ou null</translation>
    </message>
    <message>
        <source>the body must be an object with &quot;value&quot;: a number, a text, true, false or null</source>
        <translation>le corps doit être un objet avec &quot;value&quot;&#xa0;: un nombre, un texte, true, false ou null</translation>
    </message>
    <message>
        <source>one of u8, u16, u32, i32, f32, f64 or char is expected, with a count in brackets where there are several: char[32]</source>
        <translation>un type parmi u8, u16, u32, i32, f32, f64 ou char est attendu, avec le nombre entre crochets s&apos;il y en a plusieurs&#xa0;: char[32]</translation>
    </message>
    <message>
        <source>the count is given twice, here and in the type</source>
        <translation>le nombre d&apos;éléments est indiqué deux fois, ici et dans le type</translation>
    </message>
    <message>
        <source>the number of characters is missing: char[32]</source>
        <translation>le nombre de caractères manque&#xa0;: char[32]</translation>
    </message>
    <message>
        <source>there is no field {name} to hold it</source>
        <translation>il n&apos;y a pas de champ {name} pour cela</translation>
    </message>
    <message>
        <source>&quot;little&quot; or &quot;big&quot; is expected</source>
        <translation>&quot;little&quot; ou &quot;big&quot; est attendu</translation>
    </message>
    <message>
        <source>&quot;first&quot; or &quot;last&quot; is expected</source>
        <translation>&quot;first&quot; ou &quot;last&quot; est attendu</translation>
    </message>
    <message>
        <source>a file path such as tables/small1.TAMtbl is expected</source>
        <translation>un chemin de fichier tel que tables/small1.TAMtbl est attendu</translation>
    </message>
    <message>
        <source>a file path has a name between its slashes, none at its ends, and no &quot;.&quot; or &quot;..&quot;</source>
        <translation>un chemin de fichier a un nom entre ses barres obliques, aucune barre à ses extrémités et ni &quot;.&quot; ni &quot;..&quot;</translation>
    </message>
    <message>
        <source>there are more than {most} slots</source>
        <translation>il y a plus de {most} emplacements</translation>
    </message>
    <message>
        <source>this is the value that stands for no table, enums.tableDisabled</source>
        <translation>c&apos;est la valeur qui signifie aucune table, enums.tableDisabled</translation>
    </message>
    <message>
        <source>another slot has the name {name}</source>
        <translation>un autre emplacement porte le nom {name}</translation>
    </message>
    <message>
        <source>another slot has the file {file}</source>
        <translation>un autre emplacement a le fichier {file}</translation>
    </message>
    <message>
        <source>at least one slot is needed</source>
        <translation>il faut au moins un emplacement</translation>
    </message>
    <message>
        <source>the path of a web page is expected, such as /directory</source>
        <translation>le chemin d&apos;une page web est attendu, tel que /directory</translation>
    </message>
    <message>
        <source>a slash is needed at the end, because a file path follows</source>
        <translation>il faut une barre oblique à la fin, car un chemin de fichier suit</translation>
    </message>
    <message>
        <source>there must be no slash at the end</source>
        <translation>aucune barre oblique n&apos;est permise à la fin</translation>
    </message>
    <message>
        <source>this is the same page as directory</source>
        <translation>c&apos;est la même page que directory</translation>
    </message>
    <message>
        <source>this is the same page as directory or transfer</source>
        <translation>c&apos;est la même page que directory ou transfer</translation>
    </message>
    <message>
        <source>this is the same field as transferPathField</source>
        <translation>c&apos;est le même champ que transferPathField</translation>
    </message>
    <message>
        <source>it is empty; a register path is expected</source>
        <translation>c&apos;est vide&#xa0;; un chemin de registre est attendu</translation>
    </message>
    <message>
        <source>it has {count} characters, at most {most} are possible</source>
        <translation>{count} caractères, {most} au plus sont possibles</translation>
    </message>
    <message>
        <source>a path has one slash between its parts and none at its ends</source>
        <translation>un chemin a une barre oblique entre ses parties et aucune à ses extrémités</translation>
    </message>
    <message>
        <source>a path is made of letters, digits, &apos;_&apos;, &apos;-&apos;, &apos;/&apos;, &apos;[&apos; and &apos;]&apos;; the character at position {position} is none of them</source>
        <translation>un chemin se compose de lettres, de chiffres, de &apos;_&apos;, &apos;-&apos;, &apos;/&apos;, &apos;[&apos; et &apos;]&apos;&#xa0;; le caractère en position {position} n&apos;en fait pas partie</translation>
    </message>
    <message>
        <source>the placeholder {name} is missing</source>
        <translation>le marqueur {name} manque</translation>
    </message>
    <message>
        <source>the placeholder {name} is there more than once</source>
        <translation>le marqueur {name} figure plusieurs fois</translation>
    </message>
    <message>
        <source>the placeholder {name} has no meaning here</source>
        <translation>le marqueur {name} n&apos;a pas de sens ici</translation>
    </message>
    <message>
        <source>in braces there can only be a placeholder, one of {known}</source>
        <translation>entre accolades, seul un marqueur est possible, parmi {known}</translation>
    </message>
    <message>
        <source>a range is written in brackets, such as [0..15]</source>
        <translation>une plage s&apos;écrit entre crochets, par exemple [0..15]</translation>
    </message>
    <message>
        <source>a range goes from a whole number up to another one, such as [0..15]</source>
        <translation>une plage va d&apos;un nombre entier à un autre plus grand, par exemple [0..15]</translation>
    </message>
    <message>
        <source>the register {path} is there twice</source>
        <translation>le registre {path} figure deux fois</translation>
    </message>
    <message>
        <source>the shortlist has more than {most} registers</source>
        <translation>la liste de choix a plus de {most} registres</translation>
    </message>
    <message>
        <source>a word of 1 to {most} letters, digits, &apos;_&apos; or &apos;-&apos; is expected</source>
        <translation>un mot de 1 à {most} lettres, chiffres, &apos;_&apos; ou &apos;-&apos; est attendu</translation>
    </message>
    <message>
        <source>this is the same register as {name}</source>
        <translation>c&apos;est le même registre que {name}</translation>
    </message>
    <message>
        <source>this is the same value as {name}</source>
        <translation>c&apos;est la même valeur que {name}</translation>
    </message>
    <message>
        <source>a numeric type is expected: Int32, UInt32, Single or Double</source>
        <translation>un type numérique est attendu&#xa0;: Int32, UInt32, Single ou Double</translation>
    </message>
    <message>
        <source>the type {type} is there twice</source>
        <translation>le type {type} figure deux fois</translation>
    </message>
    <message>
        <source>at least one type is needed</source>
        <translation>il faut au moins un type</translation>
    </message>
    <message numerus="yes">
        <source>{count} registers</source>
        <comment>one register</comment>
        <translation>
            <numerusform>{count} registre</numerusform>
            <numerusform>{count} registres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} addresses</source>
        <comment>one address</comment>
        <translation>
            <numerusform>{count} adresse</numerusform>
            <numerusform>{count} adresses</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{code}&quot; is not what a drive can answer; that is one of {known}</source>
        <translation>«&#xa0;{code}&#xa0;» n&apos;est pas une réponse possible d&apos;un variateur&#xa0;; possibles&#xa0;: {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a fault; known are {known}</source>
        <translation>«&#xa0;{text}&#xa0;» n&apos;est pas un défaut&#xa0;; sont connus {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a whole number from 1 to {most}, as {name} needs</source>
        <translation>«&#xa0;{text}&#xa0;» n&apos;est pas un nombre entier de 1 à {most}, comme {name} le demande</translation>
    </message>
    <message>
        <source>a fault was asked for</source>
        <translation>un défaut a été demandé</translation>
    </message>
    <message>
        <source>it is the state of the drive with serial number {found}, not of {expected}</source>
        <translation>c&apos;est l&apos;état du variateur de numéro de série {found}, non de {expected}</translation>
    </message>
    <message>
        <source>the profile {profile} has no slot {slot}</source>
        <translation>le profil {profile} n&apos;a pas d&apos;emplacement {slot}</translation>
    </message>
    <message>
        <source>the table in {slot} is larger than the slot</source>
        <translation>la table dans {slot} est plus grande que l&apos;emplacement</translation>
    </message>
    <message>
        <source>the name of a file in the folder {folder}</source>
        <translation>le nom d&apos;un fichier du dossier {folder}</translation>
    </message>
    <message>
        <source>{place} must be {expected}</source>
        <translation>{place} doit être {expected}</translation>
    </message>
    <message>
        <source>a list of whole numbers, 0 or more</source>
        <translation>une liste de nombres entiers, 0 ou plus</translation>
    </message>
    <message>
        <source>a boolean, a number or a text</source>
        <translation>un booléen, un nombre ou un texte</translation>
    </message>
    <message>
        <source>it is not the JSON of a virtual drive&apos;s state</source>
        <translation>ce n&apos;est pas le JSON de l&apos;état d&apos;un variateur virtuel</translation>
    </message>
    <message>
        <source>a virtual drive has at most {most} axes, not {count}</source>
        <translation>un variateur virtuel a au plus {most} axes, pas {count}</translation>
    </message>
    <message>
        <source>an axis needs a range with low below high, and a period above 0 s</source>
        <translation>un axe doit avoir une étendue dont le début est inférieur à la fin, et une période supérieure à 0 s</translation>
    </message>
    <message>
        <source>a parameter does not fit: {reason}</source>
        <translation>un paramètre ne convient pas&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>{request} is not a request; these are: {known}</source>
        <translation>{request} n&apos;est pas une requête&#xa0;; requêtes possibles&#xa0;: {known}</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, not {count}</source>
        <translation>nommer de 1 à {most} registres, pas {count}</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, each with its value</source>
        <translation>nommer de 1 à {most} registres, chacun avec sa valeur</translation>
    </message>
    <message>
        <source>write {request}; &quot;&quot; is everything</source>
        <translation>écrire {request}&#xa0;; &quot;&quot; signifie tout</translation>
    </message>
    <message>
        <source>write {request}, the CRC in hexadecimal digits</source>
        <translation>écrire {request}, le CRC en chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>write {request}</source>
        <translation>écrire {request}</translation>
    </message>
    <message>
        <source>a new pseudo-terminal</source>
        <translation>un nouveau pseudo-terminal</translation>
    </message>
    <message>
        <source>no pseudo-terminal: {reason}</source>
        <translation>pas de pseudo-terminal&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another one</source>
        <translation>il y a déjà un fichier de ce nom&#xa0;; en choisir un autre</translation>
    </message>
    <message>
        <source>the link cannot be made: {reason}</source>
        <translation>le lien ne peut pas être créé&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the line has more than {most} characters</source>
        <translation>la ligne a plus de {most} caractères</translation>
    </message>
    <message>
        <source>this is no request; a line is [#n ]words[ *XXXX]</source>
        <translation>ce n&apos;est pas une requête&#xa0;; une ligne s&apos;écrit [#n ]mots[ *XXXX]</translation>
    </message>
    <message>
        <source>&quot;{value}&quot; is too large for a Single</source>
        <translation>«&#xa0;{value}&#xa0;» est trop grand pour un Single</translation>
    </message>
    <message>
        <source>the value is longer than any name of an enum</source>
        <translation>la valeur est plus longue que tout nom d&apos;une énumération</translation>
    </message>
    <message>
        <source>a document type is not allowed</source>
        <translation>un type de document n&apos;est pas permis</translation>
    </message>
    <message>
        <source>entities are not allowed</source>
        <translation>les entités ne sont pas permises</translation>
    </message>
    <message>
        <source>the root element is {name}, expected TamTopology</source>
        <translation>l&apos;élément racine est {name}, attendu&#xa0;: TamTopology</translation>
    </message>
    <message>
        <source>a RegisterComponent needs Address, Type and Value</source>
        <translation>un RegisterComponent exige Address, Type et Value</translation>
    </message>
    <message>
        <source>the axis index must be from 0 to {most}</source>
        <translation>l&apos;indice de l&apos;axe doit être compris entre 0 et {most}</translation>
    </message>
    <message>
        <source>there are more than {most} registers</source>
        <translation>il y a plus de {most} registres</translation>
    </message>
    <message>
        <source>there is no TamStation with registers of an axis in it</source>
        <translation>il ne contient aucune TamStation avec des registres d&apos;un axe</translation>
    </message>
    <message numerus="yes">
        <source>{path}, or one of {count} others asked for with it</source>
        <comment>{path}, or another one asked for with it</comment>
        <translation>
            <numerusform>{path}, ou {count} autre demandé avec lui</numerusform>
            <numerusform>{path}, ou l&apos;un des {count} autres demandés avec lui</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers</source>
        <comment>a JSON array of one register</comment>
        <translation>
            <numerusform>un tableau JSON de {count} registre</numerusform>
            <numerusform>un tableau JSON de {count} registres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers, in the order asked for</source>
        <comment>a JSON array of the one register asked for</comment>
        <translation>
            <numerusform>un tableau JSON de {count} registre, dans l&apos;ordre demandé</numerusform>
            <numerusform>un tableau JSON de {count} registres, dans l&apos;ordre demandé</numerusform>
        </translation>
    </message>
    <message>
        <source>this is empty</source>
        <translation>c&apos;est vide</translation>
    </message>
    <message>
        <source>this is there twice</source>
        <translation>élément présent deux fois</translation>
    </message>
    <message>
        <source>it does not read back as it was written</source>
        <translation>la relecture ne donne pas ce qui a été écrit</translation>
    </message>
    <message>
        <source>it is not the table that was kept there: its size or CRC differs</source>
        <translation>ce n&apos;est pas la table qui y était conservée&#xa0;: taille ou CRC différents</translation>
    </message>
    <message>
        <source>it was kept about a write that did not end, but is damaged ({reason}). Look at what the drive holds, then delete the file</source>
        <translation>il concerne une écriture qui ne s&apos;est pas terminée, mais il est endommagé ({reason}). Vérifier l&apos;état du variateur, puis supprimer le fichier</translation>
    </message>
    <message>
        <source>it is about axis {axis} of drive {drive}</source>
        <translation>il concerne l&apos;axe {axis} du variateur {drive}</translation>
    </message>
    <message>
        <source>user name or password is missing or wrong</source>
        <translation>le nom d&apos;utilisateur ou le mot de passe manque ou est erroné</translation>
    </message>
    <message>
        <source>the request has more bytes than the largest that the drive takes</source>
        <translation>la requête a plus d&apos;octets que le variateur n&apos;en accepte</translation>
    </message>
    <message>
        <source>it is not stated which axis the values of {column} correct, and the numbers depend on it; state the target: {sources}</source>
        <translation>l&apos;axe que corrigent les valeurs de {column} n&apos;est pas indiqué, et les nombres en dépendent&#xa0;; indiquer l&apos;axe cible&#xa0;: {sources}</translation>
    </message>
    <message>
        <source>{table} is the name of table {named} and the number of table {numbered}; say name:{table} or #{table}</source>
        <translation>{table} est le nom de la table {named} et le numéro de la table {numbered}&#xa0;; indiquer name:{table} ou #{table}</translation>
    </message>
    <message>
        <source>the table goes from {before}, and the file would say from {after}; correct the settings for its axes, or the target</source>
        <translation>la table va de {before}, le fichier indiquerait&#xa0;: de {after}&#xa0;; corriger les réglages de ses axes ou l&apos;axe cible</translation>
    </message>
    <message>
        <source>one axis for all columns or one for each: the name of an axis, #1 for the first source, or other</source>
        <translation>un axe pour toutes les colonnes ou un pour chacune&#xa0;: le nom d&apos;un axe, #1 pour la première source, ou other</translation>
    </message>
    <message>
        <source>the axis of dimension {number}</source>
        <translation>l&apos;axe de la dimension {number}</translation>
    </message>
    <message>
        <source>the axis of dimension {number} ({axis})</source>
        <translation>l&apos;axe de la dimension {number} ({axis})</translation>
    </message>
    <message>
        <source>an axis that is no source</source>
        <translation>un axe qui n&apos;est pas une source</translation>
    </message>
    <message>
        <source>dimension {number} is its own position</source>
        <translation>la dimension {number} est sa propre position</translation>
    </message>
    <message>
        <source>all sources are positions of other axes</source>
        <translation>toutes les sources sont des positions d&apos;autres axes</translation>
    </message>
    <message>
        <source>it corrects an axis by its own position, and this table goes from {column}</source>
        <translation>il corrige un axe selon sa propre position, et cette table va de {column}</translation>
    </message>
    <message>
        <source>{statement} (source {number})</source>
        <translation>{statement} (source {number})</translation>
    </message>
    <message>
        <source>{statement} ({axis})</source>
        <translation>{statement} ({axis})</translation>
    </message>
    <message>
        <source>{statement} (an axis that is no source)</source>
        <translation>{statement} (un axe qui n&apos;est pas une source)</translation>
    </message>
    <message>
        <source>{count} targets are stated for {columns} columns; state one for all or one for each</source>
        <translation>{count} axes cibles sont indiqués pour {columns} colonnes&#xa0;; en indiquer un pour toutes ou un pour chacune</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>un autre axe</translation>
    </message>
    <message>
        <source>{placeholder} is expected in the path</source>
        <translation>{placeholder} est attendu dans le chemin</translation>
    </message>
    <message>
        <source>the {what} are in {unit}, which cannot be converted to {other}, the unit of the drive; correct the unit in the file, or state it</source>
        <translation>les {what} sont en {unit}, ce qui ne peut pas être converti en {other}, l&apos;unité du variateur&#xa0;; corriger l&apos;unité dans le fichier ou l&apos;indiquer</translation>
    </message>
    <message>
        <source>positions of dimension {number}</source>
        <translation>positions de la dimension {number}</translation>
    </message>
    <message>
        <source>Neither the table nor the drive states a unit for the values. The largest correction is {largest}.</source>
        <translation>Ni la table ni le variateur n&apos;indiquent d&apos;unité pour les valeurs. La plus grande correction est {largest}.</translation>
    </message>
    <message>
        <source>The values are converted from {before} to {after}. The largest correction is {largest}.</source>
        <translation>Les valeurs sont converties de {before} en {after}. La plus grande correction est {largest}.</translation>
    </message>
    <message>
        <source>The drive states no unit for the axis; the values are written in {before}. The largest correction is {largest}.</source>
        <translation>Le variateur n&apos;indique pas d&apos;unité pour l&apos;axe&#xa0;; les valeurs sont écrites en {before}. La plus grande correction est {largest}.</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {after}. The largest correction is {largest}.</source>
        <translation>La table n&apos;indique pas d&apos;unité pour ses valeurs&#xa0;; {after} est supposé. La plus grande correction est {largest}.</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are converted from {before} to {after}: {first} to {last}.</source>
        <translation>Les positions de la dimension {number} sont converties de {before} en {after}&#xa0;: {first} à {last}.</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them in the preview, or with --accept-large</source>
        <translation>{reason} Vérifier l&apos;unité des valeurs&#xa0;; si elles sont justes, les confirmer dans l&apos;aperçu ou avec --accept-large</translation>
    </message>
    <message>
        <source>The largest correction, {largest}, is {percent} of the range of dimension {number}, {range}.</source>
        <translation>La plus grande correction, {largest}, représente {percent} de l&apos;étendue de la dimension {number}, {range}.</translation>
    </message>
    <message>
        <source>The correction has a slope of {slope} along dimension {number}, between {first} and {last}.</source>
        <translation>La correction a une pente de {slope} suivant la dimension {number}, entre {first} et {last}.</translation>
    </message>
    <message>
        <source>The axis is outside of the table, where the values at its ends hold. Move the axis into the table and activate again.</source>
        <translation>L&apos;axe est hors de la table, là où s&apos;appliquent les valeurs de ses extrémités. Amener l&apos;axe dans la table et activer de nouveau.</translation>
    </message>
    <message>
        <source>The table is 0, or too small to be seen, at every position that was looked at. Move the axis to where the table is larger and activate again.</source>
        <translation>La table vaut 0, ou est trop petite pour être vue, à toutes les positions examinées. Amener l&apos;axe là où la table est plus grande et activer de nouveau.</translation>
    </message>
    <message>
        <source>version 1 of the height map</source>
        <translation>version 1 de la carte de hauteurs</translation>
    </message>
    <message>
        <source>version 2, which newer firmware writes</source>
        <translation>la version 2, écrite par un firmware plus récent</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a file</source>
        <translation>c&apos;est un tube ou un périphérique, non un fichier</translation>
    </message>
    <message>
        <source>the values are multiplied by a number that is not 0, and shifted by a number</source>
        <translation>les valeurs sont multipliées par un nombre différent de 0 et décalées d&apos;un nombre</translation>
    </message>
    <message>
        <source>an offset and a position at which the values are 0 contradict each other</source>
        <translation>un décalage et une position où les valeurs sont 0 se contredisent</translation>
    </message>
    <message>
        <source>the position at which the values are 0 needs a number for each of the {count} source axes</source>
        <translation>la position où les valeurs sont 0 exige un nombre pour chacun des {count} axes sources</translation>
    </message>
    <message>
        <source>{position} of source {number}, where the values shall be 0, is outside of the table, which goes from {first} to {last}</source>
        <translation>{position} de la source {number}, où les valeurs doivent être 0, est hors de la table, qui va de {first} à {last}</translation>
    </message>
    <message>
        <source>the values are multiplied by {factor}</source>
        <translation>les valeurs sont multipliées par {factor}</translation>
    </message>
    <message>
        <source>the values of {column} are shifted by {shift}</source>
        <translation>les valeurs de {column} sont décalées de {shift}</translation>
    </message>
    <message>
        <source>{source} is a position after the compensation: the table would be looked up where its own values have moved the axis.</source>
        <translation>{source} est une position après compensation&#xa0;: la table serait consultée là où ses propres valeurs ont amené l&apos;axe.</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; write volatile, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>le décompte des opérations flash de ce variateur était endommagé, toutes sont donc considérées comme utilisées&#xa0;; écrire en volatil ou remettre le décompte à zéro avec «&#xa0;axiscomp status --reset-flash-count&#xa0;»</translation>
    </message>
    <message>
        <source>it is not an ordinary file; move it away</source>
        <translation>ce n&apos;est pas un fichier ordinaire&#xa0;; le déplacer ailleurs</translation>
    </message>
    <message>
        <source>the SHA-256 of a certificate is expected</source>
        <translation>le SHA-256 d&apos;un certificat est attendu</translation>
    </message>
    <message>
        <source>it cannot be renamed: {reason}</source>
        <translation>impossible de le renommer&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>it is on a network file system, where a database can be damaged; set XDG_STATE_HOME to a folder on this computer</source>
        <translation>il est sur un système de fichiers réseau, où une base de données peut être endommagée&#xa0;; régler XDG_STATE_HOME sur un dossier de cet ordinateur</translation>
    </message>
    <message>
        <source>a newer version of this program has written it; use that version</source>
        <translation>écrit par une version plus récente de ce programme&#xa0;; utiliser cette version</translation>
    </message>
    <message>
        <source>it is the database of another program; move it away</source>
        <translation>c&apos;est la base de données d&apos;un autre programme&#xa0;; la déplacer ailleurs</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>le fichier est en lecture seule</translation>
    </message>
    <message>
        <source>this file system cannot share it between programs</source>
        <translation>ce système de fichiers ne permet pas de le partager entre programmes</translation>
    </message>
    <message>
        <source>the file or its folder is read-only</source>
        <translation>le fichier ou son dossier est en lecture seule</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>endommagé</translation>
    </message>
    <message>
        <source>its journal of an interrupted write is damaged ({reason}). Look at what the drive holds, then move the file away</source>
        <translation>son journal de reprise d&apos;une écriture interrompue est endommagé ({reason}). Vérifier l&apos;état du variateur, puis déplacer le fichier ailleurs</translation>
    </message>
    <message>
        <source>{axis} is taken for {first} to {last} in steps of {distance}; the largest shift is {shift}, at {position}</source>
        <translation>{axis} est considéré comme allant de {first} à {last} par pas de {distance}&#xa0;; le plus grand décalage est {shift}, à {position}</translation>
    </message>
    <message>
        <source>position {number}</source>
        <translation>position {number}</translation>
    </message>
    <message>
        <source>no 2 neighbouring points in every dimension with a value</source>
        <translation>pas même 2 points voisins avec valeur dans chaque dimension</translation>
    </message>
    <message>
        <source>a part of the grid that is complete; fill the points instead</source>
        <translation>une partie complète de la grille&#xa0;; remplir plutôt les points</translation>
    </message>
    <message>
        <source>{axis} from {first} to {last}</source>
        <translation>{axis} de {first} à {last}</translation>
    </message>
    <message>
        <source>{missing} of {all} points without a value; kept are {kept} points, {ranges}</source>
        <translation>{missing} points sur {all} sans valeur&#xa0;; {kept} points sont gardés, {ranges}</translation>
    </message>
    <message>
        <source>no value at all in {table}</source>
        <translation>aucune valeur dans {table}</translation>
    </message>
    <message>
        <source>a column with values</source>
        <translation>une colonne avec des valeurs</translation>
    </message>
    <message>
        <source>{count} points without a value</source>
        <translation>{count} points sans valeur</translation>
    </message>
    <message>
        <source>at most {most} for a smooth filling; choose the nearest point or a plane</source>
        <translation>au plus {most} pour un remplissage lisse&#xa0;; choisir le point le plus proche ou un plan</translation>
    </message>
    <message>
        <source>measured points of {table} on one line only</source>
        <translation>des points mesurés de {table} sur une seule droite</translation>
    </message>
    <message>
        <source>points that determine a plane; choose the nearest point instead</source>
        <translation>des points qui définissent un plan&#xa0;; choisir plutôt le point le plus proche</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} à {high}</translation>
    </message>
    <message>
        <source>{count} of {all} points of {table} without a value; they get {made}, the measured values are {measured}</source>
        <translation>{count} points sur {all} de {table} sans valeur&#xa0;; ils reçoivent {made}, les valeurs mesurées sont {measured}</translation>
    </message>
    <message>
        <source>{expected}; a tolerance of {tolerance} takes them for an even grid (--snap, or Snap tolerance in the import)</source>
        <translation>{expected}&#xa0;; avec une tolérance de {tolerance}, elles passent pour une grille régulière (--snap, ou Tolérance d&apos;accrochage à l&apos;importation)</translation>
    </message>
    <message>
        <source>every combination of the positions; missing points can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>chaque combinaison des positions&#xa0;; les points manquants peuvent être remplis ou omis (--fill, --crop, ou Points manquants à l&apos;importation)</translation>
    </message>
    <message>
        <source>{expected}; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>{expected}&#xa0;; les points sans valeur peuvent être remplis ou omis (--fill, --crop, ou Points manquants à l&apos;importation)</translation>
    </message>
    <message>
        <source>a height with decimals; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>une hauteur avec décimales&#xa0;; les points sans valeur peuvent être remplis ou omis (--fill, --crop, ou Points manquants à l&apos;importation)</translation>
    </message>
    <message>
        <source>every combination of the positions</source>
        <translation>chaque combinaison des positions</translation>
    </message>
    <message>
        <source>parameter 1020 of the axis shows the commanded position with the compensation in it</source>
        <translation>le paramètre 1020 de l&apos;axe indique la position de consigne, compensation comprise</translation>
    </message>
    <message>
        <source>at most {most} for older kernels</source>
        <translation>au plus {most} pour les anciens noyaux</translation>
    </message>
    <message>
        <source>the table has {count} points; older kernels take at most {most}</source>
        <translation>la table a {count} points&#xa0;; les anciens noyaux en acceptent {most} au plus</translation>
    </message>
    <message>
        <source>unit of the positions, in place of what the header says</source>
        <translation>unité des positions, à la place de celle de l&apos;en-tête</translation>
    </message>
    <message>
        <source>unit of the values, in place of what the header says</source>
        <translation>unité des valeurs, à la place de celle de l&apos;en-tête</translation>
    </message>
    <message>
        <source>{number} ({name}, axes: {axes})</source>
        <translation>{number} ({name}, axes&#xa0;: {axes})</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>une table</translation>
    </message>
    <message>
        <source>{slot} is empty: there is nothing to delete</source>
        <translation>{slot} est vide&#xa0;: il n&apos;y a rien à supprimer</translation>
    </message>
    <message>
        <source>axis {axis} uses no table: there is nothing to delete</source>
        <translation>l&apos;axe {axis} n&apos;utilise pas de table&#xa0;: il n&apos;y a rien à supprimer</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}: name another slot, or none, and a free one is chosen</source>
        <translation>l&apos;emplacement {slot} est déjà utilisé ({user})&#xa0;: en indiquer un autre, ou aucun, et un emplacement libre est choisi</translation>
    </message>
    <message>
        <source>the table in {slot} is not deleted, because {user} uses it; free it there first</source>
        <translation>la table dans {slot} n&apos;est pas supprimée, car elle est utilisée ({user})&#xa0;; l&apos;en détacher d&apos;abord</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: that one is deleted too.</source>
        <translation>La mémoire flash contient peut-être une table plus ancienne dans {slot}&#xa0;: elle est supprimée aussi.</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved before {slot} is emptied: otherwise {axis} could look for the deleted table after a reboot.</source>
        <translation>Les paramètres de tous les axes sont enregistrés avant que {slot} soit vidé&#xa0;: sinon, {axis} pourrait chercher la table supprimée après un redémarrage.</translation>
    </message>
    <message>
        <source>After a reboot {axis} uses the table in {slot} again, as its saved parameters say.</source>
        <translation>Après un redémarrage, {axis} utilise de nouveau la table dans {slot}, selon les paramètres enregistrés.</translation>
    </message>
    <message>
        <source>the configuration has {unit} for axis {axis}, but the axis of the drive has {other}</source>
        <translation>la configuration a l&apos;unité {unit} pour l&apos;axe {axis}, mais l&apos;axe du variateur a {other}</translation>
    </message>
    <message>
        <source>the profile has no slot {slot}</source>
        <translation>le profil n&apos;a pas d&apos;emplacement {slot}</translation>
    </message>
    <message>
        <source>the station {station} has no register {path}</source>
        <translation>la station {station} n&apos;a pas de registre {path}</translation>
    </message>
    <message>
        <source>the unit is {unit}, but the axis that is written has {other}</source>
        <translation>l&apos;unité est {unit}, mais l&apos;axe à écrire a {other}</translation>
    </message>
    <message>
        <source>which station of {file} is meant is not certain; name one of: {known}</source>
        <translation>la station voulue de {file} n&apos;est pas certaine&#xa0;; en indiquer une parmi&#xa0;: {known}</translation>
    </message>
    <message>
        <source>it is not a text in UTF-8</source>
        <translation>ce n&apos;est pas un texte en UTF-8</translation>
    </message>
    <message>
        <source>it is not an XML document</source>
        <translation>ce n&apos;est pas un document XML</translation>
    </message>
    <message>
        <source>it ends before {name} ends</source>
        <translation>le fichier se termine avant la fin de {name}</translation>
    </message>
    <message>
        <source>a tag is not well-formed</source>
        <translation>une balise est mal formée</translation>
    </message>
    <message>
        <source>{name} ends where it has not begun</source>
        <translation>{name} se termine sans avoir commencé</translation>
    </message>
    <message>
        <source>it has changed since it was read; export again</source>
        <translation>modifié depuis sa lecture&#xa0;; exporter de nouveau</translation>
    </message>
    <message numerus="yes">
        <source>{count} more comment lines</source>
        <comment>1 more comment line</comment>
        <translation>
            <numerusform>{count} ligne de commentaire de plus</numerusform>
            <numerusform>{count} lignes de commentaire de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>at most 1 MiB of comments</source>
        <translation>au plus 1 Mio de commentaires</translation>
    </message>
    <message>
        <source>The drive looks up where it should, but adds nothing while it evaluates. Activate to prove what it adds.</source>
        <translation>Le variateur consulte la table au bon endroit, mais n&apos;ajoute rien pendant l&apos;évaluation. Activer pour valider ce qu&apos;il ajoute.</translation>
    </message>
    <message>
        <source>it has nothing of axis {axis}</source>
        <translation>elle ne contient rien de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: {percent} of the travel of axis {axis}, {low} to {high}. Beyond the table the drive holds the value of its end.</source>
        <translation>La dimension {number} de la table va de {first} à {last}&#xa0;: {percent} de la course de l&apos;axe {axis}, {low} à {high}. Au-delà de la table, le variateur maintient la valeur d&apos;extrémité.</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: outside the travel of axis {axis}, {low} to {high}. The drive holds the value of one end everywhere.</source>
        <translation>La dimension {number} de la table va de {first} à {last}&#xa0;: hors de la course de l&apos;axe {axis}, {low} à {high}. Le variateur maintient partout la valeur d&apos;une extrémité.</translation>
    </message>
    <message>
        <source>The backup is of another drive, the one with the serial number {number}.</source>
        <translation>La sauvegarde est celle d&apos;un autre variateur, de numéro de série {number}.</translation>
    </message>
    <message>
        <source>a full {dimensions}D grid of {points} points</source>
        <translation>une grille {dimensions}D complète de {points} points</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid measurement: {count} problems</source>
        <comment>{file} is not a valid measurement: one problem</comment>
        <translation>
            <numerusform>{file} n&apos;est pas une mesure valide&#xa0;: {count} problème</numerusform>
            <numerusform>{file} n&apos;est pas une mesure valide&#xa0;: {count} problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} does not say its units; state them with --unit and --value-unit</source>
        <translation>{file} n&apos;indique pas ses unités&#xa0;; les indiquer avec --unit et --value-unit</translation>
    </message>
    <message>
        <source>the positions in {file} do not follow one another one to one</source>
        <translation>les positions dans {file} ne se suivent pas dans un rapport de 1 à 1</translation>
    </message>
    <message>
        <source>{file} has no targets; the figures of the standard need a measurement of runs over targets</source>
        <translation>{file} n&apos;a pas de positions cibles&#xa0;; les caractéristiques de la norme exigent une mesure en passes sur des positions cibles</translation>
    </message>
    <message>
        <source>an error in mm</source>
        <translation>une erreur en mm</translation>
    </message>
    <message>
        <source>a position without a bidirectional mean</source>
        <translation>une position sans moyenne bidirectionnelle</translation>
    </message>
    <message>
        <source>the same positions in both blocks</source>
        <translation>les mêmes positions dans les deux blocs</translation>
    </message>
    <message>
        <source>no block of a direction</source>
        <translation>aucun bloc d&apos;un sens</translation>
    </message>
    <message>
        <source>a block Forward Directional Avg Error; the mean of both directions alone says nothing of either</source>
        <translation>un bloc Forward Directional Avg Error&#xa0;; la moyenne des deux sens ne dit rien de chacun</translation>
    </message>
    <message>
        <source>means of a linear measurement (.pos)</source>
        <translation>moyennes d&apos;une mesure de longueur (.pos)</translation>
    </message>
    <message>
        <source>TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= or KEY=</source>
        <translation>TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= ou CLÉ=</translation>
    </message>
    <message>
        <source>the position of a target</source>
        <translation>la position d&apos;une cible</translation>
    </message>
    <message>
        <source>a second target {number}</source>
        <translation>une deuxième position cible {number}</translation>
    </message>
    <message>
        <source>each target once</source>
        <translation>chaque position cible une seule fois</translation>
    </message>
    <message>
        <source>a position of the reference</source>
        <translation>une position de la référence</translation>
    </message>
    <message>
        <source>{key}: {said}, but {found} are there</source>
        <translation>{key}&#xa0;: {said}, mais il y en a {found}</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>le fichier entier</translation>
    </message>
    <message>
        <source>a length or an angle: mm, um, m, inch, deg, arcsec, mrad</source>
        <translation>une longueur ou un angle&#xa0;: mm, um, m, inch, deg, arcsec, mrad</translation>
    </message>
    <message>
        <source>the number of a target, TGT_DATA[{number}]=</source>
        <translation>le numéro d&apos;une position cible, TGT_DATA[{number}]=</translation>
    </message>
    <message>
        <source>data of an ISO 230-2 test</source>
        <translation>données d&apos;un essai ISO 230-2</translation>
    </message>
    <message>
        <source>a head such as i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</source>
        <translation>un en-tête tel que i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</translation>
    </message>
    <message>
        <source>a position</source>
        <translation>une position</translation>
    </message>
    <message>
        <source>{value}, as the head of the table has</source>
        <translation>{value}, comme dans l&apos;en-tête du tableau</translation>
    </message>
    <message>
        <source>a report by a program that is known to print forward and backward the other way round</source>
        <translation>un rapport d&apos;un programme connu pour intervertir aller et retour</translation>
    </message>
    <message>
        <source>report of an ISO 230-2 test, with its results</source>
        <translation>rapport d&apos;un essai ISO 230-2, avec ses résultats</translation>
    </message>
    <message>
        <source>a line with the names of the columns, such as target [mm]</source>
        <translation>une ligne avec les noms des colonnes, par exemple target [mm]</translation>
    </message>
    <message>
        <source>no column {column} for {role}</source>
        <translation>aucune colonne {column} pour {role}</translation>
    </message>
    <message numerus="yes">
        <source>the name of a column, or its number from 1 to {count}</source>
        <comment>the name of the column, or 1</comment>
        <translation>
            <numerusform>le nom d&apos;une colonne ou son numéro, de 1 à {count}</numerusform>
            <numerusform>le nom d&apos;une colonne ou son numéro, de 1 à {count}</numerusform>
        </translation>
    </message>
    <message>
        <source>two columns for {role}</source>
        <translation>deux colonnes pour {role}</translation>
    </message>
    <message>
        <source>one; name the columns with --columns</source>
        <translation>une seule&#xa0;; désigner les colonnes avec --columns</translation>
    </message>
    <message>
        <source>a column for {role}</source>
        <translation>une colonne pour {role}</translation>
    </message>
    <message>
        <source>one of these words before the =: {known}</source>
        <translation>l&apos;un de ces mots avant le signe =&#xa0;: {known}</translation>
    </message>
    <message>
        <source>a unit in brackets behind the name, such as {example}, or --unit and --value-unit</source>
        <translation>une unité entre crochets après le nom, telle que {example}, ou --unit et --value-unit</translation>
    </message>
    <message>
        <source>column {column}</source>
        <translation>colonne {column}</translation>
    </message>
    <message>
        <source>the unit {unit} of column {column}</source>
        <translation>l&apos;unité {unit} de la colonne {column}</translation>
    </message>
    <message>
        <source>an angle as the targets are</source>
        <translation>un angle, comme les positions cibles</translation>
    </message>
    <message>
        <source>a length as the targets are</source>
        <translation>une longueur, comme les positions cibles</translation>
    </message>
    <message>
        <source>corrected: none, or corrected: 20C</source>
        <translation>corrected: none, ou corrected: 20C</translation>
    </message>
    <message>
        <source>values: deviation, or values: reference</source>
        <translation>values: deviation, ou values: reference</translation>
    </message>
    <message>
        <source>sign: deviation (reference minus target), or sign: correction (its opposite)</source>
        <translation>sign: deviation (référence moins position cible), ou sign: correction (l&apos;opposé)</translation>
    </message>
    <message>
        <source>a temperature in deg C, such as 20.4</source>
        <translation>une température en °C, par exemple 20.4</translation>
    </message>
    <message>
        <source>a coefficient of expansion in 1/K, such as 11.5e-6</source>
        <translation>un coefficient de dilatation en 1/K, par exemple 11.5e-6</translation>
    </message>
    <message>
        <source>compensation: off, on, or crc: with the checksum of the table, such as crc:1c291ca3</source>
        <translation>compensation: off, on, ou crc: avec la somme de contrôle de la table, par exemple crc:1c291ca3</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names no columns; write target=1,direction=3,deviation=5, with numbers or names of columns</source>
        <translation>«&#xa0;{text}&#xa0;» ne désigne pas de colonnes&#xa0;; écrire target=1,direction=3,deviation=5, avec numéros ou noms de colonnes</translation>
    </message>
    <message>
        <source>no columns X and Y</source>
        <translation>aucune colonne X ni Y</translation>
    </message>
    <message>
        <source>columns X and Y, or X, Y and Z, with the positions</source>
        <translation>des colonnes X et Y, ou X, Y et Z, avec les positions</translation>
    </message>
    <message>
        <source>no column of values</source>
        <translation>aucune colonne de valeurs</translation>
    </message>
    <message>
        <source>at least one behind the positions, such as dX [um]</source>
        <translation>au moins une après les positions, par exemple dX [um]</translation>
    </message>
    <message>
        <source>a line for each point</source>
        <translation>une ligne par point</translation>
    </message>
    <message>
        <source>CSV of values at positions of 2 or 3 axes</source>
        <translation>CSV de valeurs à des positions de 2 ou 3 axes</translation>
    </message>
    <message>
        <source>run, number of the target and deviation, such as 1 1 0.21</source>
        <translation>passe, numéro de la position cible et écart, par exemple 1 1 0.21</translation>
    </message>
    <message>
        <source>a deviation</source>
        <translation>un écart</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>un nombre entier à partir de 1</translation>
    </message>
    <message numerus="yes">
        <source>a number from 1 to {count}, as there are targets</source>
        <comment>1, the only target</comment>
        <translation>
            <numerusform>un nombre de 1 à {count}, le nombre de positions cibles</numerusform>
            <numerusform>un nombre de 1 à {count}, le nombre de positions cibles</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole file; save it again from the instrument&apos;s software</source>
        <translation>le fichier entier&#xa0;; l&apos;enregistrer de nouveau depuis le logiciel de l&apos;instrument</translation>
    </message>
    <message>
        <source>File type: rtl or rta, which says the units</source>
        <translation>File type: rtl ou rta, dont se déduisent les unités</translation>
    </message>
    <message>
        <source>sections TARGET DATA:: and DEVIATIONS:: with their numbers</source>
        <translation>les sections TARGET DATA:: et DEVIATIONS:: avec leurs nombres</translation>
    </message>
    <message numerus="yes">
        <source>{count} runs of a unidirectional file that are exactly 0 throughout</source>
        <comment>1 run of a unidirectional file that is exactly 0 throughout</comment>
        <translation>
            <numerusform>{count} passe d&apos;un fichier unidirectionnel qui vaut partout exactement 0</numerusform>
            <numerusform>{count} passes d&apos;un fichier unidirectionnel qui valent partout exactement 0</numerusform>
        </translation>
    </message>
    <message>
        <source>a run whose target numbers rise or fall throughout</source>
        <translation>une passe dont les numéros de position cible croissent ou décroissent d&apos;un bout à l&apos;autre</translation>
    </message>
    <message>
        <source>linear and angular measurements (.rtl, .rta)</source>
        <translation>mesures de longueur et d&apos;angle (.rtl, .rta)</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times smaller, as um for mm</source>
        <translation>la référence a une unité 1000 fois plus petite, par exemple um au lieu de mm</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times larger, as m for mm</source>
        <translation>la référence a une unité 1000 fois plus grande, par exemple m au lieu de mm</translation>
    </message>
    <message>
        <source>the reference is in mm and the encoder in inch</source>
        <translation>la référence est en mm et le codeur en pouces</translation>
    </message>
    <message>
        <source>the reference is in inch and the encoder in mm</source>
        <translation>la référence est en pouces et le codeur en mm</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts half</source>
        <translation>le facteur de l&apos;interféromètre est faux&#xa0;: il compte la moitié</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts double</source>
        <translation>le facteur de l&apos;interféromètre est faux&#xa0;: il compte le double</translation>
    </message>
    <message>
        <source>the reference is in degrees and the encoder in radians</source>
        <translation>la référence est en degrés et le codeur en radians</translation>
    </message>
    <message>
        <source>the reference is in radians and the encoder in degrees</source>
        <translation>la référence est en radians et le codeur en degrés</translation>
    </message>
    <message>
        <source>the instrument counts the other way; if so, say it with --invert-reference</source>
        <translation>l&apos;instrument compte en sens inverse&#xa0;; si c&apos;est le cas, l&apos;indiquer avec --invert-reference</translation>
    </message>
    <message>
        <source>1; {meaning}: correct the file, or state the unit of the reference with --value-unit, and that of the other positions with --unit</source>
        <translation>1&#xa0;; {meaning}&#xa0;: corriger le fichier ou indiquer l&apos;unité de la référence avec --value-unit et celle des autres positions avec --unit</translation>
    </message>
    <message>
        <source>1 within 1 %; check which columns are reference and encoder, and their units</source>
        <translation>1 à 1&#xa0;% près&#xa0;; vérifier quelles colonnes sont la référence et le codeur, et leurs unités</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets</source>
        <comment>1 target</comment>
        <translation>
            <numerusform>{count} position cible</numerusform>
            <numerusform>{count} positions cibles</numerusform>
        </translation>
    </message>
    <message>
        <source>at least 2 different positions that the axis was sent to</source>
        <translation>au moins 2 positions différentes où l&apos;axe a été amené</translation>
    </message>
    <message>
        <source>target {target}, {direction}, run {run} in line {first} and in line {second}</source>
        <translation>position cible {target}, {direction}, passe {run} à la ligne {first} et à la ligne {second}</translation>
    </message>
    <message>
        <source>{up} up and {down} down</source>
        <translation>{up} en sens positif et {down} en sens négatif</translation>
    </message>
    <message>
        <source>as many in each direction</source>
        <translation>autant dans chaque sens</translation>
    </message>
    <message numerus="yes">
        <source>no value for {places} ({count} are missing)</source>
        <comment>no value for {places}</comment>
        <translation>
            <numerusform>aucune valeur pour {places} (il en manque {count})</numerusform>
            <numerusform>aucune valeur pour {places} (il en manque {count})</numerusform>
        </translation>
    </message>
    <message>
        <source>a value for every target in every run</source>
        <translation>une valeur pour chaque position cible dans chaque passe</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the target</source>
        <translation>des valeurs qui croissent de {slope} avec la position cible</translation>
    </message>
    <message>
        <source>deviations, which hardly follow it</source>
        <translation>des écarts, qui la suivent à peine</translation>
    </message>
    <message>
        <source>a largest deviation of {value} over {travel}</source>
        <translation>un plus grand écart de {value} sur {travel}</translation>
    </message>
    <message>
        <source>more than a billionth of the travel</source>
        <translation>plus d&apos;un milliardième de la course</translation>
    </message>
    <message>
        <source>at most 1 % of the travel</source>
        <translation>au plus 1&#xa0;% de la course</translation>
    </message>
    <message>
        <source>the reference moves {slope} times as far as the axis</source>
        <translation>la référence se déplace {slope} fois autant que l&apos;axe</translation>
    </message>
    <message>
        <source>no column target</source>
        <translation>aucune colonne target</translation>
    </message>
    <message>
        <source>a column target, or which column it is: --columns &apos;target=1,direction=2,...&apos;</source>
        <translation>une colonne target, ou laquelle c&apos;est&#xa0;: --columns &apos;target=1,direction=2,...&apos;</translation>
    </message>
    <message>
        <source>no column direction</source>
        <translation>aucune colonne direction</translation>
    </message>
    <message>
        <source>a column direction with + and -, or --direction-from order when the runs rise and fall</source>
        <translation>une colonne direction avec + et -, ou --direction-from order quand les passes montent et descendent</translation>
    </message>
    <message>
        <source>neither deviation nor reference</source>
        <translation>ni deviation ni reference</translation>
    </message>
    <message>
        <source>both deviation and reference</source>
        <translation>à la fois deviation et reference</translation>
    </message>
    <message>
        <source>either a column deviation (reference minus target) or a column reference (position)</source>
        <translation>soit une colonne deviation (référence moins position cible), soit une colonne reference (position)</translation>
    </message>
    <message>
        <source>+ or -, up or down, forward or backward</source>
        <translation>+ ou -, up ou down, forward ou backward</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>ligne {line}</translation>
    </message>
    <message>
        <source>at least two targets one after the other in each run, so that its direction shows</source>
        <translation>au moins deux positions cibles successives dans chaque passe, pour que son sens apparaisse</translation>
    </message>
    <message>
        <source>CSV with a line for each value</source>
        <translation>CSV avec une ligne par valeur</translation>
    </message>
    <message>
        <source>no column encoder</source>
        <translation>aucune colonne encoder</translation>
    </message>
    <message>
        <source>no column reference</source>
        <translation>aucune colonne reference</translation>
    </message>
    <message>
        <source>columns encoder and reference</source>
        <translation>les colonnes encoder et reference</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples</source>
        <comment>1 sample</comment>
        <translation>
            <numerusform>{count} échantillon</numerusform>
            <numerusform>{count} échantillons</numerusform>
        </translation>
    </message>
    <message>
        <source>at least {count} samples of an axis that moves</source>
        <translation>au moins {count} échantillons d&apos;un axe en mouvement</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples after turns, until the axis had moved {overrun}</source>
        <comment>1 sample after a turn, until the axis had moved {overrun}</comment>
        <translation>
            <numerusform>{count} échantillon après une inversion, jusqu&apos;à ce que l&apos;axe ait parcouru {overrun}</numerusform>
            <numerusform>{count} échantillons après des inversions, jusqu&apos;à ce que l&apos;axe ait parcouru {overrun}</numerusform>
        </translation>
    </message>
    <message>
        <source>CSV of encoder and reference positions without targets</source>
        <translation>CSV de positions du codeur et de la référence sans positions cibles</translation>
    </message>
    <message>
        <source>columns of runs that are either deviations or positions</source>
        <translation>des colonnes de passes qui peuvent être des écarts ou des positions</translation>
    </message>
    <message>
        <source>a column target before those of the runs</source>
        <translation>une colonne target avant celles des passes</translation>
    </message>
    <message>
        <source>CSV with a line for each target</source>
        <translation>CSV avec une ligne par position cible</translation>
    </message>
    <message>
        <source>angles do not change with temperature or air: the correction is for lengths</source>
        <translation>les angles ne varient ni avec la température ni avec l&apos;air&#xa0;: la correction vaut pour les longueurs</translation>
    </message>
    <message>
        <source>the file says that its values are corrected to 20 deg C already; correcting them again would make them wrong</source>
        <translation>selon le fichier, ses valeurs sont déjà corrigées à 20 °C&#xa0;; les corriger encore les fausserait</translation>
    </message>
    <message>
        <source>a temperature is in deg C and a coefficient of expansion in 1/K, such as 22.5 and 11.5e-6</source>
        <translation>une température est en °C et un coefficient de dilatation en 1/K, par exemple 22.5 et 11.5e-6</translation>
    </message>
    <message>
        <source>a dead path is a length in mm between the interferometer and the reflector, at most 100 m</source>
        <translation>un trajet mort est une longueur en mm entre l&apos;interféromètre et le réflecteur, au plus 100 m</translation>
    </message>
    <message>
        <source>there is no such air on the dead path: pressure is in kPa (50 to 120), temperature in deg C (-40 to 60), humidity in percent (0 to 100)</source>
        <translation>un tel air n&apos;existe pas sur le trajet mort&#xa0;: la pression est en kPa (50 à 120), la température en °C (-40 à 60), l&apos;humidité en pour cent (0 à 100)</translation>
    </message>
    <message>
        <source>{file} does not describe a dead path: {reason}</source>
        <translation>{file} ne décrit pas un trajet mort&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>the air of run {run} {direction} is not known; the dead path needs pressure, temperature and humidity of every run</source>
        <translation>l&apos;air pendant la passe {run} ({direction}) n&apos;est pas connu&#xa0;; le trajet mort exige la pression, la température et l&apos;humidité de chaque passe</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>un nombre non négatif</translation>
    </message>
    <message>
        <source>the uncertainty budget is wrong: {reason}</source>
        <translation>le bilan d&apos;incertitude est erroné&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no angle; write a number that is not negative and its unit, such as 5arcsec</source>
        <translation>«&#xa0;{text}&#xa0;» n&apos;est pas un angle&#xa0;; écrire un nombre non négatif et son unité, par exemple 5arcsec</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no length; write a number that is not negative and its unit, such as 10um</source>
        <translation>«&#xa0;{text}&#xa0;» n&apos;est pas une longueur&#xa0;; écrire un nombre non négatif et son unité, par exemple 10um</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no tolerance; write a figure and its limit, such as A=10um; the figures are A, A+, A-, R, R+, R-, E, E+, E-, B, Bm and M</source>
        <translation>«&#xa0;{text}&#xa0;» n&apos;est pas une tolérance&#xa0;; écrire une caractéristique et sa limite, par exemple A=10um&#xa0;; les caractéristiques sont A, A+, A-, R, R+, R-, E, E+, E-, B, Bm et M</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names nothing that can be excluded; write down:1:1 for a value (direction, target, run), run:up:3 or target:7</source>
        <translation>«&#xa0;{text}&#xa0;» ne désigne rien qui puisse être exclu&#xa0;; écrire down:1:1 pour une valeur (sens, position cible, passe), run:up:3 ou target:7</translation>
    </message>
    <message>
        <source>there is no value {exclusion}: the measurement has {targets} targets, {up} runs up and {down} runs down</source>
        <translation>il n&apos;y a pas de valeur {exclusion}&#xa0;: la mesure a {targets} positions cibles, {up} passes en sens positif et {down} en sens négatif</translation>
    </message>
    <message>
        <source>only runs over targets can be joined; one file has {kind}</source>
        <translation>seules des passes sur des positions cibles peuvent être réunies&#xa0;; un fichier contient {kind}</translation>
    </message>
    <message>
        <source>a measurement of lengths and one of angles cannot be joined</source>
        <translation>une mesure de longueurs et une mesure d&apos;angles ne peuvent pas être réunies</translation>
    </message>
    <message>
        <source>measurements with different tables, or with and without compensation, cannot be joined</source>
        <translation>des mesures avec des tables différentes, ou avec et sans compensation, ne peuvent pas être réunies</translation>
    </message>
    <message>
        <source>these positions cannot tell an error with the period {period}: they lie in {filled} of {classes} equal parts of the period, and {fewest} are needed; measure at targets that are spread over the period (axiscomp targets --period), or leave the period out</source>
        <translation>ces positions ne permettent pas de déceler une erreur de période {period}&#xa0;: elles se trouvent dans {filled} des {classes} parties égales de la période, et il en faut {fewest}&#xa0;; mesurer à des positions cibles réparties sur la période (axiscomp targets --period), ou omettre la période</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of the grid, at {region}, are more than {distances} distances away from any measured point; measure there, take a smaller grid, or let them be filled (--fill smooth or --fill nearest)</source>
        <comment>one point of the grid, at {region}, is more than {distances} distances away from any measured point; measure there, take a smaller grid, or let it be filled (--fill smooth or --fill nearest)</comment>
        <translation>
            <numerusform>{count} point de la grille, à {region}, est à plus de {distances} pas de tout point mesuré&#xa0;; mesurer à cet endroit, réduire la grille ou faire remplir ce point (--fill smooth ou --fill nearest)</numerusform>
            <numerusform>{count} points de la grille, à {region}, sont à plus de {distances} pas de tout point mesuré&#xa0;; mesurer à cet endroit, réduire la grille ou faire remplir ces points (--fill smooth ou --fill nearest)</numerusform>
        </translation>
    </message>
    <message>
        <source>the computation did not come to an end: {reason}</source>
        <translation>le calcul n&apos;a pas abouti&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>each position must have one value and one weight</source>
        <translation>chaque position doit avoir une valeur et un poids</translation>
    </message>
    <message>
        <source>positions, values and weights must be finite numbers</source>
        <translation>les positions, les valeurs et les poids doivent être des nombres finis</translation>
    </message>
    <message>
        <source>weights must be larger than 0</source>
        <translation>les poids doivent être supérieurs à 0</translation>
    </message>
    <message>
        <source>the period of a modulo axis must be a number above 0</source>
        <translation>la période d&apos;un axe modulo doit être un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>there are values at {count} positions; this method needs {fewest}, measure more of them or choose another method</source>
        <translation>il y a des valeurs à {count} positions&#xa0;; cette méthode en exige {fewest}, mesurer à d&apos;autres positions ou choisir une autre méthode</translation>
    </message>
    <message>
        <source>the number of harmonics must be 1 to 1000</source>
        <translation>le nombre d&apos;harmoniques doit être compris entre 1 et 1000</translation>
    </message>
    <message>
        <source>a period has at least one harmonic</source>
        <translation>une période a au moins un harmonique</translation>
    </message>
    <message>
        <source>a period must be a number above 0</source>
        <translation>une période doit être un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>the period {period} is wanted twice, by itself or as a harmonic of another; give each once</source>
        <translation>la période {period} est demandée deux fois, par elle-même ou comme harmonique d&apos;une autre&#xa0;; n&apos;indiquer chacune qu&apos;une fois</translation>
    </message>
    <message>
        <source>the period {period} does not divide the turn of {turn}; on a modulo axis it must</source>
        <translation>la période {period} ne divise pas le tour de {turn}&#xa0;; c&apos;est nécessaire pour un axe modulo</translation>
    </message>
    <message>
        <source>the smoothness must be a number above 0</source>
        <translation>le lissage doit être un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>a smoothness of {smoothness} cannot be computed for these positions; take a smaller one</source>
        <translation>un lissage de {smoothness} n&apos;est pas calculable pour ces positions&#xa0;; en choisir un plus faible</translation>
    </message>
    <message>
        <source>a grid has one to three dimensions, with two points and a distance above 0 in each</source>
        <translation>une grille a de une à trois dimensions, chacune avec deux points et un pas supérieur à 0</translation>
    </message>
    <message>
        <source>points need one finite number for each dimension, for their value and for their weight</source>
        <translation>les points doivent avoir un nombre fini pour chaque dimension, pour leur valeur et pour leur poids</translation>
    </message>
    <message>
        <source>the smoothness must be a number of 0 or more</source>
        <translation>le lissage doit être un nombre supérieur ou égal à 0</translation>
    </message>
    <message>
        <source>{axis} {from} to {to}</source>
        <translation>{axis} {from} à {to}</translation>
    </message>
    <message>
        <source>with a smoothness of 0 every point of the grid needs a measured one beside it, and {count} have none; take a larger smoothness or a coarser grid</source>
        <translation>avec un lissage de 0, chaque point de la grille doit avoir un point mesuré voisin, et {count} n&apos;en ont pas&#xa0;; augmenter le lissage ou choisir une grille moins fine</translation>
    </message>
    <message>
        <source>no point lies within the grid; check its start and end, and the unit of the positions</source>
        <translation>aucun point n&apos;est dans la grille&#xa0;; vérifier son début et sa fin, et l&apos;unité des positions</translation>
    </message>
    <message>
        <source>the points do not determine every point of the grid; take a larger smoothness or a coarser grid</source>
        <translation>les points ne déterminent pas tous les points de la grille&#xa0;; augmenter le lissage ou choisir une grille moins fine</translation>
    </message>
    <message>
        <source>the points lie too unevenly for so little smoothness; take a larger smoothness or a coarser grid</source>
        <translation>les points sont trop irréguliers pour un lissage aussi faible&#xa0;; augmenter le lissage ou choisir une grille moins fine</translation>
    </message>
    <message>
        <source>the table that was active has other sources than the table that is made</source>
        <translation>la table qui était active a d&apos;autres sources que la table à établir</translation>
    </message>
    <message>
        <source>a table has one to three dimensions</source>
        <translation>une table a de une à trois dimensions</translation>
    </message>
    <message>
        <source>the tables that were active move their axes too much for their raw position to be found; check the unit of their values</source>
        <translation>les tables qui étaient actives déplacent trop leurs axes pour que leur position brute soit retrouvée&#xa0;; vérifier l&apos;unité de leurs valeurs</translation>
    </message>
    <message>
        <source>Column {column} of the file has positions in {unit}, but its source {source} is a temperature.</source>
        <translation>La colonne {column} du fichier a des positions en {unit}, mais sa source {source} est une température.</translation>
    </message>
    <message>
        <source>Column {column} of the file is named as an axis, but its source {source} is a temperature.</source>
        <translation>La colonne {column} du fichier porte le nom d&apos;un axe, mais sa source {source} est une température.</translation>
    </message>
    <message>
        <source>Column {column} of the file has temperatures, but its source {source} is a position.</source>
        <translation>La colonne {column} du fichier a des températures, mais sa source {source} est une position.</translation>
    </message>
    <message>
        <source>Column {column} of the file is not named as axis {axis}, whose position its source {source} is.</source>
        <translation>La colonne {column} du fichier ne porte pas le nom de l&apos;axe {axis}, dont sa source {source} est la position.</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up; keep the table persistent, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>retirer une table de la mémoire flash est aussi une opération flash, et le décompte des opérations flash de ce variateur était endommagé, toutes sont donc considérées comme utilisées&#xa0;; laisser la table persistante ou remettre le décompte à zéro avec «&#xa0;axiscomp status --reset-flash-count&#xa0;»</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for removing the table from flash, but not for putting everything back if it fails; wait {seconds} s, or keep the table persistent</source>
        <translation>les opérations flash restantes suffiraient à retirer la table de la mémoire flash, mais pas à tout remettre en état en cas d&apos;échec&#xa0;; attendre {seconds} s ou laisser la table persistante</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and there were too many of them in a short time; wait {seconds} s, or keep the table persistent</source>
        <translation>retirer une table de la mémoire flash est aussi une opération flash, et il y en a eu trop en peu de temps&#xa0;; attendre {seconds} s ou laisser la table persistante</translation>
    </message>
    <message>
        <source>The table is removed from flash, which is a flash operation too. After a reboot the axis has no table.</source>
        <translation>La table est retirée de la mémoire flash, ce qui est aussi une opération flash. Après un redémarrage, l&apos;axe n&apos;a plus de table.</translation>
    </message>
    <message>
        <source>&quot;{range}&quot; is not a range of addresses: {reason}</source>
        <translation>«&#xa0;{range}&#xa0;» n&apos;est pas une plage d&apos;adresses&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>write it as {network}, {range} or {address}, with {port} behind it for another port</source>
        <translation>écrire {network}, {range} ou {address}, suivi de {port} pour un autre port</translation>
    </message>
    <message>
        <source>a port is a number from 1 to 65535</source>
        <translation>un port est un nombre de 1 à 65535</translation>
    </message>
    <message>
        <source>its last address is before the first</source>
        <translation>sa dernière adresse précède la première</translation>
    </message>
    <message>
        <source>it has {count} addresses, and a search asks {limit} at most: name a part of it</source>
        <translation>elle compte {count} adresses, et une recherche en interroge {limit} au plus&#xa0;: en indiquer une partie</translation>
    </message>
    <message>
        <source>these are no addresses of computers</source>
        <translation>ce ne sont pas des adresses d&apos;ordinateurs</translation>
    </message>
    <message>
        <source>the wanted distance must be a number above 0</source>
        <translation>la distance voulue doit être un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes more than {count} points; with these it is {found}; allow more points or a larger distance</source>
        <translation>une distance de {distance} à la courbe nécessite plus de {count} points&#xa0;; avec ceux-ci, elle est de {found}&#xa0;; autoriser plus de points ou une distance plus grande</translation>
    </message>
    <message>
        <source>each point needs a finite position and deviation in two or three dimensions</source>
        <translation>chaque point doit avoir une position et un écart finis dans deux ou trois dimensions</translation>
    </message>
    <message>
        <source>the points lie on a line, or on a plane in space, and cannot tell how the artefact lay; measure points beside it</source>
        <translation>les points sont alignés, ou coplanaires dans l&apos;espace, et ne permettent pas de savoir comment l&apos;étalon était placé&#xa0;; mesurer des points à côté</translation>
    </message>
    <message>
        <source>targets and deviations must be finite numbers</source>
        <translation>les positions cibles et les écarts doivent être des nombres finis</translation>
    </message>
    <message>
        <source>there are values at {count} targets; a table needs two</source>
        <translation>il y a des valeurs à {count} positions cibles&#xa0;; une table en exige deux</translation>
    </message>
    <message>
        <source>the target {target} has no value of one direction; measure it, leave the target out, or make the table of the other direction (--direction)</source>
        <translation>à la position cible {target}, la valeur d&apos;un sens manque&#xa0;; la mesurer, omettre la position cible ou établir la table de l&apos;autre sens (--direction)</translation>
    </message>
    <message>
        <source>known periods are fitted by the method smooth only (--method smooth)</source>
        <translation>seule la méthode smooth (--method smooth) ajuste des périodes connues</translation>
    </message>
    <message>
        <source>harmonics need the length of a turn, which is that of a modulo axis</source>
        <translation>les harmoniques exigent la longueur d&apos;un tour, donc un axe modulo</translation>
    </message>
    <message>
        <source>there is no such method</source>
        <translation>cette méthode n&apos;existe pas</translation>
    </message>
    <message>
        <source>a modulo axis has no slope that could be removed: it ends where it begins</source>
        <translation>un axe modulo n&apos;a pas de pente à retirer&#xa0;: il finit là où il commence</translation>
    </message>
    <message>
        <source>there are values at {count} targets; four are needed to leave one out</source>
        <translation>il y a des valeurs à {count} positions cibles&#xa0;; il en faut quatre pour en omettre une</translation>
    </message>
    <message>
        <source>a gain is above 0 and at most 2; it is usually 1</source>
        <translation>un gain est supérieur à 0 et au plus 2&#xa0;; il vaut en général 1</translation>
    </message>
    <message>
        <source>{name} has no table whose target is that of the column {column}; state the targets of its tables, or measure without a table</source>
        <translation>{name} n&apos;a pas de table dont l&apos;axe cible soit celui de la colonne {column}&#xa0;; indiquer les axes cibles de ses tables ou mesurer sans table</translation>
    </message>
    <message>
        <source>all points have the same position along {axis}</source>
        <translation>tous les points ont la même position suivant {axis}</translation>
    </message>
    <message>
        <source>a grid has at least 2 points along {axis}</source>
        <translation>une grille a au moins 2 points suivant {axis}</translation>
    </message>
    <message>
        <source>the distance along {axis} is too small</source>
        <translation>le pas suivant {axis} est trop petit</translation>
    </message>
    <message>
        <source>the grid needs one number, or one for each of the {count} axes</source>
        <translation>la grille exige un nombre, ou un pour chacun des {count} axes</translation>
    </message>
    <message>
        <source>points are fitted on the grid itself, as the drive interpolates it; leave out --method and --period</source>
        <translation>les points sont ajustés sur la grille elle-même, telle que le variateur l&apos;interpole&#xa0;; omettre --method et --period</translation>
    </message>
    <message>
        <source>a track is fitted on the grid itself, or by --method smooth, which known periods (--period) need; leave other methods out</source>
        <translation>un relevé continu est ajusté sur la grille elle-même, ou par --method smooth, qu&apos;exigent les périodes connues (--period)&#xa0;; omettre les autres méthodes</translation>
    </message>
    <message>
        <source>--robust is for a fit on the grid itself; leave out --robust or --method smooth</source>
        <translation>--robust vaut pour un ajustement sur la grille elle-même&#xa0;; omettre --robust ou --method smooth</translation>
    </message>
    <message>
        <source>the figures of the standard need targets; leave --tolerance out</source>
        <translation>les caractéristiques de la norme exigent des positions cibles&#xa0;; omettre --tolerance</translation>
    </message>
    <message>
        <source>a home position is that of one axis measured over targets; take --zero first, mean, keep or a position</source>
        <translation>une position d&apos;origine est celle d&apos;un axe mesuré à des positions cibles&#xa0;; prendre --zero first, mean, keep ou une position</translation>
    </message>
    <message>
        <source>--remove is for points of two or three axes; a track has one</source>
        <translation>--remove vaut pour des points de deux ou trois axes&#xa0;; un relevé continu en a un</translation>
    </message>
    <message>
        <source>points have no direction; leave --direction out</source>
        <translation>des points n&apos;ont pas de sens de parcours&#xa0;; omettre --direction</translation>
    </message>
    <message>
        <source>the zero needs {count} numbers, one for each axis</source>
        <translation>le zéro exige {count} nombres, un par axe</translation>
    </message>
    <message>
        <source>--remove names an axis that the points do not have</source>
        <translation>--remove nomme un axe que les points n&apos;ont pas</translation>
    </message>
    <message>
        <source>the position of the zero is outside the grid</source>
        <translation>la position du zéro est hors de la grille</translation>
    </message>
    <message>
        <source>there are no values in this direction</source>
        <translation>il n&apos;y a pas de valeurs dans ce sens</translation>
    </message>
    <message>
        <source>--remove, --robust and --fill are for points of two or three axes and for tracks; this measurement has targets along one axis</source>
        <translation>--remove, --robust et --fill valent pour des points de deux ou trois axes et pour des relevés continus&#xa0;; cette mesure a des positions cibles suivant un axe</translation>
    </message>
    <message>
        <source>the measurement is along one axis: give one number for its grid and zero</source>
        <translation>la mesure suit un seul axe&#xa0;: indiquer un nombre pour sa grille et son zéro</translation>
    </message>
    <message>
        <source>a smoothness is for the method smooth (--method smooth); the others go through every mean</source>
        <translation>un lissage vaut pour la méthode smooth (--method smooth)&#xa0;; les autres passent par chaque moyenne</translation>
    </message>
    <message>
        <source>the position {position} of the zero is outside the targets, which go from {from} to {to}</source>
        <translation>la position {position} du zéro est hors des positions cibles, qui vont de {from} à {to}</translation>
    </message>
    <message>
        <source>a program for {dialect} cannot move an axis &quot;{axis}&quot;; name one of X, Y, Z, A, B, C, U, V, W (--axis)</source>
        <translation>un programme pour {dialect} ne peut pas déplacer un axe «&#xa0;{axis}&#xa0;»&#xa0;; nommer l&apos;un des axes X, Y, Z, A, B, C, U, V, W (--axis)</translation>
    </message>
    <message>
        <source>a target must lie within {limit} of zero</source>
        <translation>une position cible doit être à {limit} de zéro au plus</translation>
    </message>
    <message>
        <source>{position} has more than the three decimals that a program prints; choose an end with fewer</source>
        <translation>{position} a plus que les trois décimales qu&apos;écrit un programme&#xa0;; choisir une extrémité avec moins de décimales</translation>
    </message>
    <message>
        <source>the last target ({to}) must be above the first ({from}); exchange the two, or choose other ends</source>
        <translation>la dernière position cible ({to}) doit être supérieure à la première ({from})&#xa0;; permuter les deux ou choisir d&apos;autres extrémités</translation>
    </message>
    <message>
        <source>a period is above 0; leave it out if none is known</source>
        <translation>une période est supérieure à 0&#xa0;; l&apos;omettre si aucune n&apos;est connue</translation>
    </message>
    <message>
        <source>the overrun must be above 0: without it the first target of a run would not be approached in the direction of the run</source>
        <translation>le dépassement doit être supérieur à 0&#xa0;: sans lui, la première position cible d&apos;une passe ne serait pas abordée dans le sens de la passe</translation>
    </message>
    <message>
        <source>the overrun has more than three decimals; round it</source>
        <translation>le dépassement a plus de trois décimales&#xa0;; l&apos;arrondir</translation>
    </message>
    <message>
        <source>the feed must be above 0 and at most {most}</source>
        <translation>l&apos;avance doit être supérieure à 0 et d&apos;au plus {most}</translation>
    </message>
    <message>
        <source>the dwell must be above 0 s and at most {most}: the axis stands still while it is measured</source>
        <translation>la temporisation doit être supérieure à 0 s et d&apos;au plus {most}&#xa0;: l&apos;axe est immobile pendant la mesure</translation>
    </message>
    <message>
        <source>at least one cycle is needed</source>
        <translation>il faut au moins un cycle</translation>
    </message>
    <message>
        <source>give the number of targets or their spacing, one of the two</source>
        <translation>indiquer le nombre de positions cibles ou leur espacement, l&apos;un des deux</translation>
    </message>
    <message>
        <source>the spacing must be above 0 and at most the distance of the ends, {range}</source>
        <translation>l&apos;espacement doit être supérieur à 0 et d&apos;au plus la distance des extrémités, {range}</translation>
    </message>
    <message>
        <source>a plan has 2 to {most} targets, not {count}</source>
        <translation>un plan a de 2 à {most} positions cibles, pas {count}</translation>
    </message>
    <message>
        <source>{count} targets would be closer than {least}, which three decimals cannot keep uneven; choose fewer</source>
        <translation>{count} positions cibles seraient espacées de moins de {least}, trop peu pour rester irrégulières avec trois décimales&#xa0;; en choisir moins</translation>
    </message>
    <message>
        <source>the plan would have more than {most} steps; choose fewer targets or cycles</source>
        <translation>le plan aurait plus de {most} étapes&#xa0;; choisir moins de positions cibles ou de cycles</translation>
    </message>
    <message>
        <source>there is no step in it</source>
        <translation>il ne contient aucune étape</translation>
    </message>
    <message>
        <source>a plan as axiscomp targets writes it</source>
        <translation>un plan tel que l&apos;écrit axiscomp targets</translation>
    </message>
    <message>
        <source>{found}; expected: {expected}</source>
        <translation>{found}&#xa0;; attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>line {line}: {found}; expected: {expected}</source>
        <translation>ligne {line}&#xa0;: {found}&#xa0;; attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>version 1; a newer version of this program may have written it</source>
        <translation>la version 1&#xa0;; le fichier provient peut-être d&apos;une version plus récente de ce programme</translation>
    </message>
    <message>
        <source>a number above 0 with its unit</source>
        <translation>un nombre supérieur à 0 avec son unité</translation>
    </message>
    <message>
        <source>the header {header}</source>
        <translation>l&apos;en-tête {header}</translation>
    </message>
    <message>
        <source>five cells, as the header has</source>
        <translation>cinq cellules, comme dans l&apos;en-tête</translation>
    </message>
    <message>
        <source>at most {count} steps</source>
        <translation>au plus {count} étapes</translation>
    </message>
    <message>
        <source>step {step}</source>
        <translation>étape {step}</translation>
    </message>
    <message>
        <source>the number of a run, from 1</source>
        <translation>le numéro d&apos;une passe, à partir de 1</translation>
    </message>
    <message>
        <source>the direction + or -</source>
        <translation>le sens + ou -</translation>
    </message>
    <message>
        <source>a position below the target, since the axis moves up</source>
        <translation>une position inférieure à la position cible, puisque l&apos;axe va en sens positif</translation>
    </message>
    <message>
        <source>a position above the target, since the axis moves down</source>
        <translation>une position supérieure à la position cible, puisque l&apos;axe va en sens négatif</translation>
    </message>
    <message>
        <source>each target once in a run; it has this one already</source>
        <translation>chaque position cible une seule fois par passe&#xa0;; celle-ci y est déjà</translation>
    </message>
    <message>
        <source>the plan is for axis {axis}; the machine has: {known}</source>
        <translation>le plan est pour l&apos;axe {axis}&#xa0;; axes de la machine&#xa0;: {known}</translation>
    </message>
    <message>
        <source>the plan and axis {axis} of the machine differ: one is in mm, the other in deg</source>
        <translation>le plan et l&apos;axe {axis} de la machine diffèrent&#xa0;: l&apos;un est en mm, l&apos;autre en degrés</translation>
    </message>
    <message>
        <source>the plan needs a feed and a dwell above 0: lines such as // feed: 1000 mm/min and // dwell: 5 s</source>
        <translation>le plan exige une avance et une temporisation supérieures à 0&#xa0;: des lignes telles que // feed: 1000 mm/min et // dwell: 5 s</translation>
    </message>
    <message>
        <source>step {step} of the plan goes to {place}, more than a tenth beyond the travel of axis {axis}, {low} to {high}</source>
        <translation>l&apos;étape {step} du plan mène à {place}, plus d&apos;un dixième au-delà de la course de l&apos;axe {axis}, {low} à {high}</translation>
    </message>
    <message>
        <source>a program needs a machine that plays it (--machine)</source>
        <translation>un programme exige une machine qui l&apos;exécute (--machine)</translation>
    </message>
    <message>
        <source>a machine has at least one axis</source>
        <translation>une machine a au moins un axe</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; is &quot;{nearest}&quot; meant?</source>
        <translation>«&#xa0;{name}&#xa0;» n&apos;est pas connu ici&#xa0;; est-ce «&#xa0;{nearest}&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; there is: {known}</source>
        <translation>«&#xa0;{name}&#xa0;» n&apos;est pas connu ici&#xa0;; noms possibles&#xa0;: {known}</translation>
    </message>
    <message>
        <source>a number from {least} to {most} is expected, not {found}</source>
        <translation>un nombre de {least} à {most} est attendu, non {found}</translation>
    </message>
    <message>
        <source>a number above 0, at most {most}, is expected, not {found}</source>
        <translation>un nombre supérieur à 0, au plus {most}, est attendu, non {found}</translation>
    </message>
    <message>
        <source>there are more than {most} waves</source>
        <translation>il y a plus de {most} ondes</translation>
    </message>
    <message>
        <source>the travel has more than {most} knots at this distance</source>
        <translation>à ce pas, la course a plus de {most} nœuds</translation>
    </message>
    <message>
        <source>two numbers are expected: the ends of the travel</source>
        <translation>deux nombres sont attendus&#xa0;: les extrémités de la course</translation>
    </message>
    <message>
        <source>the first end must be below the second</source>
        <translation>la première extrémité doit être inférieure à la seconde</translation>
    </message>
    <message>
        <source>mm or deg is expected</source>
        <translation>mm ou deg est attendu</translation>
    </message>
    <message>
        <source>an object with 1 to {most} axes is expected</source>
        <translation>un objet de 1 à {most} axes est attendu</translation>
    </message>
    <message>
        <source>the name of an axis has 1 to {most} characters</source>
        <translation>le nom d&apos;un axe a de 1 à {most} caractères</translation>
    </message>
    <message>
        <source>there is no axis &quot;{name}&quot;; there is: {known}</source>
        <translation>il n&apos;y a pas d&apos;axe «&#xa0;{name}&#xa0;»&#xa0;; axes présents&#xa0;: {known}</translation>
    </message>
    <message>
        <source>an axis&apos;s own terms stand with the axis; here are those of others</source>
        <translation>les termes propres d&apos;un axe figurent avec l&apos;axe&#xa0;; ici figurent ceux des autres</translation>
    </message>
    <message>
        <source>one of these units is expected: {known}</source>
        <translation>l&apos;une de ces unités est attendue&#xa0;: {known}</translation>
    </message>
    <message>
        <source>1 or -1 is expected</source>
        <translation>1 ou -1 est attendu</translation>
    </message>
    <message>
        <source>there are more than {most} gross errors</source>
        <translation>il y a plus de {most} erreurs grossières</translation>
    </message>
    <message>
        <source>{file} is not a valid record: {reason}</source>
        <translation>{file} n&apos;est pas une fiche valide&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes at least {sizes} points, more than allowed; allow more points or a larger distance</source>
        <translation>une distance de {distance} à la courbe nécessite au moins {sizes} points, plus que permis&#xa0;; autoriser plus de points ou une distance plus grande</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}, which at {speed} is a step of the velocity of {step}</source>
        <translation>suivant {axis}, {points} points&#xa0;: au plus {distance} de la courbe&#xa0;; en un point, sa pente varie de {slope} au plus, ce qui à {speed} fait un saut de vitesse de {step}</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}</source>
        <translation>suivant {axis}, {points} points&#xa0;: au plus {distance} de la courbe&#xa0;; en un point, sa pente varie de {slope} au plus</translation>
    </message>
    <message>
        <source>smoothing needs at least {fewest} positions along {axis}, which has {count}; take the method spline or cubic</source>
        <translation>le lissage exige au moins {fewest} positions suivant {axis}, qui en a {count}&#xa0;; prendre la méthode spline ou cubic</translation>
    </message>
    <message>
        <source>a SHA-256 of 64 hexadecimal digits is expected</source>
        <translation>un SHA-256 de 64 chiffres hexadécimaux est attendu</translation>
    </message>
    <message>
        <source>at least one file is expected</source>
        <translation>au moins un fichier est attendu</translation>
    </message>
    <message>
        <source>what is left out is expected, such as down:1:1, run:up:3 or target:7</source>
        <translation>l&apos;élément omis est attendu, par exemple down:1:1, run:up:3 ou target:7</translation>
    </message>
    <message>
        <source>the record has version {found}, and this program reads version {known} at most; open it with a newer version of the program</source>
        <translation>la fiche est de version {found}, et ce programme lit au plus la version {known}&#xa0;; l&apos;ouvrir avec une version plus récente du programme</translation>
    </message>
    <message>
        <source>the second measurement was made with the compensation off; activate the table {crc} and measure again</source>
        <translation>la deuxième mesure a été faite avec la compensation désactivée&#xa0;; activer la table {crc} et mesurer de nouveau</translation>
    </message>
    <message>
        <source>the second measurement was made with the table {found} active, and the record has the table {crc}; activate that one and measure again, or take the record of {found}</source>
        <translation>la deuxième mesure a été faite avec la table {found} active, et la fiche a la table {crc}&#xa0;; activer cette dernière et mesurer de nouveau, ou prendre la fiche de {found}</translation>
    </message>
    <message>
        <source>the second measurement does not say which table was active while it was made; if it was the table {crc}, say it with --measured-with on</source>
        <translation>la deuxième mesure n&apos;indique pas quelle table était active&#xa0;; s&apos;il s&apos;agissait de la table {crc}, l&apos;indiquer avec --measured-with on</translation>
    </message>
    <message>
        <source>only measurements of runs over targets are compared</source>
        <translation>seules des mesures en passes sur des positions cibles sont comparées</translation>
    </message>
    <message>
        <source>one measurement is of lengths and the other of angles; they are not of the same axis</source>
        <translation>une mesure porte sur des longueurs et l&apos;autre sur des angles&#xa0;; elles ne sont pas du même axe</translation>
    </message>
    <message>
        <source>this is no figure of ISO 230-2, such as A or EUp</source>
        <translation>ce n&apos;est pas une caractéristique de l&apos;ISO 230-2, telle que A ou EUp</translation>
    </message>
    <message>
        <source>a distance above 0 is expected</source>
        <translation>un pas supérieur à 0 est attendu</translation>
    </message>
    <message>
        <source>numbers of the table&apos;s points are expected, ascending from 0</source>
        <translation>des numéros de points de la table sont attendus, croissants à partir de 0</translation>
    </message>
    <message>
        <source>a table has 1 to 3 axes</source>
        <translation>une table a de 1 à 3 axes</translation>
    </message>
    <message>
        <source>{count} values are here, and the grid has {expected} points</source>
        <translation>il y a {count} valeurs ici, et la grille a {expected} points</translation>
    </message>
    <message>
        <source>this list has {count} elements, and the others have {expected}</source>
        <translation>cette liste a {count} éléments, et les autres en ont {expected}</translation>
    </message>
    <message>
        <source>the values have the CRC-32 {found}: they were changed, or the file is damaged</source>
        <translation>les valeurs ont le CRC-32 {found}&#xa0;: elles ont été modifiées, ou le fichier est endommagé</translation>
    </message>
    <message>
        <source>whole numbers from {least} to {most} are expected, not {found}</source>
        <translation>des nombres entiers de {least} à {most} sont attendus, non {found}</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is neither up nor down</source>
        <translation>«&#xa0;{found}&#xa0;» n&apos;est ni up ni down</translation>
    </message>
    <message>
        <source>there are values without targets</source>
        <translation>il y a des valeurs sans positions cibles</translation>
    </message>
    <message>
        <source>{count} lists are here, and there are {expected} names</source>
        <translation>il y a {count} listes ici, et {expected} noms</translation>
    </message>
    <message>
        <source>points have 2 or 3 axes</source>
        <translation>des points ont 2 ou 3 axes</translation>
    </message>
    <message>
        <source>targets are expected to ascend</source>
        <translation>des positions cibles croissantes sont attendues</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is none of: {known}</source>
        <translation>«&#xa0;{found}&#xa0;» n&apos;est aucun de&#xa0;: {known}</translation>
    </message>
    <message>
        <source>the compensation changed in mid-measurement, from {before} to {now}; what was taken belongs to {before}: begin a new file</source>
        <translation>la compensation a changé en cours de mesure, de {before} à {now}&#xa0;; ce qui a été relevé appartient à {before}&#xa0;: commencer un nouveau fichier</translation>
    </message>
    <message>
        <source>the axis stands at {position}; step {step} at {target} is due</source>
        <translation>l&apos;axe est à {position}&#xa0;; l&apos;étape à mesurer est {step}, à {target}</translation>
    </message>
    <message>
        <source>{problem}; this is the target of step {other}: move the axis back</source>
        <translation>{problem}&#xa0;; c&apos;est la position cible de l&apos;étape {other}&#xa0;: ramener l&apos;axe</translation>
    </message>
    <message>
        <source>how the axis came to step {step} is not known, as nothing could be read for {time}; go to {approach} and come back</source>
        <translation>on ne sait pas comment l&apos;axe est venu à l&apos;étape {step}, car rien n&apos;a pu être lu pendant {time}&#xa0;; aller à {approach} et revenir</translation>
    </message>
    <message>
        <source>the axis came only {way} in the direction of step {step}, less than the overrun of {overrun}; go to {approach} and come back</source>
        <translation>l&apos;axe n&apos;est venu que de {way} dans le sens de l&apos;étape {step}, moins que le dépassement de {overrun}&#xa0;; aller à {approach} et revenir</translation>
    </message>
    <message>
        <source>step {step} is approached upwards, and the axis did not come from below; go to {approach} and come back</source>
        <translation>l&apos;étape {step} s&apos;aborde en sens positif, et l&apos;axe n&apos;est pas venu d&apos;en dessous&#xa0;; aller à {approach} et revenir</translation>
    </message>
    <message>
        <source>step {step} is approached downwards, and the axis did not come from above; go to {approach} and come back</source>
        <translation>l&apos;étape {step} s&apos;aborde en sens négatif, et l&apos;axe n&apos;est pas venu d&apos;au-dessus&#xa0;; aller à {approach} et revenir</translation>
    </message>
    <message>
        <source>the instrument gives no position</source>
        <translation>l&apos;instrument ne donne aucune position</translation>
    </message>
    <message>
        <source>the readings of the instrument differ by {spread}, more than the window of {window}; they are taken again</source>
        <translation>les lectures de l&apos;instrument diffèrent de {spread}, plus que la fenêtre de {window}&#xa0;; elles sont répétées</translation>
    </message>
    <message>
        <source>it is not an ordinary file</source>
        <translation>ce n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>another program is writing measured values to it</source>
        <translation>un autre programme y écrit des valeurs mesurées</translation>
    </message>
    <message>
        <source>it holds something else than captured values; name a new file</source>
        <translation>il contient autre chose que des valeurs acquises&#xa0;; indiquer un nouveau fichier</translation>
    </message>
    <message>
        <source>line {line} has {found} where {expected} is expected; name a new file</source>
        <translation>la ligne {line} contient {found}, attendu&#xa0;: {expected}&#xa0;; indiquer un nouveau fichier</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>la fin</translation>
    </message>
    <message>
        <source>step {step} of the plan, {begin}...</source>
        <translation>étape {step} du plan, {begin}...</translation>
    </message>
    <message>
        <source>there is no font to draw a PDF with: install one, such as fonts-dejavu-core, or write the report as HTML</source>
        <translation>il n&apos;y a pas de police pour dessiner un PDF&#xa0;: en installer une, par exemple fonts-dejavu-core, ou écrire le rapport en HTML</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid machine file: {count} problems</source>
        <comment>{file} is not a valid machine file: one problem</comment>
        <translation>
            <numerusform>{file} n&apos;est pas un fichier machine valide&#xa0;: {count} problème</numerusform>
            <numerusform>{file} n&apos;est pas un fichier machine valide&#xa0;: {count} problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>the old state</source>
        <translation>l&apos;ancien état</translation>
    </message>
    <message>
        <source>what it is writing at this moment</source>
        <translation>l&apos;écriture en cours</translation>
    </message>
    <message>
        <source>values of the tolerance</source>
        <translation>des valeurs de la tolérance</translation>
    </message>
    <message>
        <source>{file} has several tables; name one of them with column: {known}</source>
        <translation>{file} a plusieurs tables&#xa0;; en indiquer une avec column&#xa0;: {known}</translation>
    </message>
    <message>
        <source>axis {index} of {drive} (serial number {serial})</source>
        <translation>axe {index} de {drive} (numéro de série {serial})</translation>
    </message>
    <message>
        <source>axis {index} ({name}) of {drive} (serial number {serial})</source>
        <translation>axe {index} ({name}) de {drive} (numéro de série {serial})</translation>
    </message>
    <message>
        <source>the record is of {recorded}, and this is {found}; begin a record for each axis</source>
        <translation>la fiche concerne {recorded}, et ceci est {found}&#xa0;; commencer une fiche par axe</translation>
    </message>
    <message>
        <source>the record does not say that its table was written: `axiscomp write --record` writes it and notes that</source>
        <translation>la fiche n&apos;indique pas que sa table a été écrite&#xa0;: «&#xa0;axiscomp write --record&#xa0;» l&apos;écrit et le note</translation>
    </message>
    <message>
        <source>the axis has the table {found}, and that of the record is {recorded}: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>l&apos;axe a la table {found}, et celle de la fiche est {recorded}&#xa0;: écrire de nouveau la table de la fiche («&#xa0;axiscomp write --record&#xa0;») ou omettre la fiche</translation>
    </message>
    <message>
        <source>the register {path} is of type {type}, which is no position</source>
        <translation>le registre {path} est de type {type}, ce qui n&apos;est pas une position</translation>
    </message>
    <message>
        <source>{path} follows the encoder of the axis itself: name the register of an instrument</source>
        <translation>{path} suit le codeur de l&apos;axe lui-même&#xa0;: indiquer le registre d&apos;un instrument</translation>
    </message>
    <message>
        <source>since the value before, the axis has moved by {way}, and the instrument says {measured}</source>
        <translation>depuis la valeur précédente, l&apos;axe s&apos;est déplacé de {way}, et l&apos;instrument indique {measured}</translation>
    </message>
    <message>
        <source>the instrument says nothing: look whether it sends, and whether its lines end</source>
        <translation>l&apos;instrument n&apos;indique rien&#xa0;: vérifier s&apos;il émet et si ses lignes se terminent</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder, and until now it was {seen} at most: type it once more if it is right, or another number</source>
        <translation>{position} est à {difference} du codeur, contre {seen} au plus jusqu&apos;ici&#xa0;: saisir de nouveau la valeur si elle est juste, ou un autre nombre</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder: type it once more if it is right, or another number</source>
        <translation>{position} est à {difference} du codeur&#xa0;: saisir de nouveau la valeur si elle est juste, ou un autre nombre</translation>
    </message>
    <message>
        <source>the position of the instrument is asked for</source>
        <translation>la position de l&apos;instrument est demandée</translation>
    </message>
    <message>
        <source>it is one of the files of this measurement; choose another name</source>
        <translation>c&apos;est l&apos;un des fichiers de cette mesure&#xa0;; choisir un autre nom</translation>
    </message>
    <message>
        <source>the axis would move from {lowest} to {highest}, and its travel is {low} to {high}: choose other ends, or a smaller overrun</source>
        <translation>l&apos;axe irait de {lowest} à {highest}, et sa course va de {low} à {high}&#xa0;: choisir d&apos;autres extrémités ou un dépassement plus petit</translation>
    </message>
    <message>
        <source>the plan is for axis {planned}, and this is axis {axis}: choose the other axis, or make a plan for this one</source>
        <translation>le plan est pour l&apos;axe {planned}, et ceci est l&apos;axe {axis}&#xa0;: choisir l&apos;autre axe ou établir un plan pour celui-ci</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is neither on nor off (the drive says {state}): activate or deactivate it first</source>
        <translation>la compensation de l&apos;axe {axis} n&apos;est ni activée ni désactivée (le variateur indique {state})&#xa0;: l&apos;activer ou la désactiver d&apos;abord</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is on, and the drive does not say with which table: deactivate it first</source>
        <translation>la compensation de l&apos;axe {axis} est activée, et le variateur n&apos;indique pas avec quelle table&#xa0;: la désactiver d&apos;abord</translation>
    </message>
    <message>
        <source>the instrument is in {unit}, which cannot be converted to {planned}, the unit of the plan: state the unit of the instrument</source>
        <translation>l&apos;instrument est en {unit}, ce qui ne peut pas être converti en {planned}, l&apos;unité du plan&#xa0;: indiquer l&apos;unité de l&apos;instrument</translation>
    </message>
    <message>
        <source>no position is asked for at the moment: wait until the axis stands at its target</source>
        <translation>aucune position n&apos;est demandée pour le moment&#xa0;: attendre que l&apos;axe soit à sa position cible</translation>
    </message>
    <message>
        <source>{found}: it counts the other way; begin a new file with the reference inverted</source>
        <translation>{found}&#xa0;: il compte en sens inverse&#xa0;; commencer un nouveau fichier avec la référence inversée</translation>
    </message>
    <message>
        <source>{found}: its unit or factor is another one, or its zero was set anew, or its beam was interrupted; put that right, or begin a new file with the right unit</source>
        <translation>{found}&#xa0;: son unité ou son facteur est différent, son zéro a été refait ou son faisceau a été coupé&#xa0;; y remédier ou commencer un nouveau fichier avec la bonne unité</translation>
    </message>
    <message>
        <source>the instrument says {line}, where a number is expected; a pattern says where it is</source>
        <translation>l&apos;instrument indique {line}, où un nombre est attendu&#xa0;; un motif indique où il se trouve</translation>
    </message>
    <message>
        <source>the instrument says {line}: its number has a comma; set it to a decimal point, or say what the number is with a pattern</source>
        <translation>l&apos;instrument indique {line}&#xa0;: son nombre a une virgule&#xa0;; le régler sur le point décimal ou préciser par un motif ce qu&apos;est le nombre</translation>
    </message>
    <message>
        <source>the instrument says {line} without a unit: state the unit, such as mm</source>
        <translation>l&apos;instrument indique {line} sans unité&#xa0;: indiquer l&apos;unité, par exemple mm</translation>
    </message>
    <message>
        <source>the instrument says {line}, in another unit than {unit}: set the instrument, or begin a new file with the right unit</source>
        <translation>l&apos;instrument indique {line}, dans une autre unité que {unit}&#xa0;: régler l&apos;instrument ou commencer un nouveau fichier avec la bonne unité</translation>
    </message>
    <message>
        <source>the drive profile does not say which register is the encoder of the axis: name it</source>
        <translation>le profil du variateur n&apos;indique pas quel registre est le codeur de l&apos;axe&#xa0;: l&apos;indiquer</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position before the compensation, which is --lookup-at encoder</source>
        <translation>l&apos;axe consulte sa table à {source}, une position avant compensation, donc --lookup-at encoder</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position after the compensation, which is --lookup-at set</source>
        <translation>l&apos;axe consulte sa table à {source}, une position après compensation, donc --lookup-at set</translation>
    </message>
    <message>
        <source>there are values at {count} points of the grid&apos;s range; {fewest} are needed to choose the smoothness, so give it (--smoothness)</source>
        <translation>il y a des valeurs en {count} points de l&apos;étendue de la grille&#xa0;; il en faut {fewest} pour choisir le lissage, l&apos;indiquer donc (--smoothness)</translation>
    </message>
    <message>
        <source>the measurement does not say whether a compensation was active while it was made: say that it was off, that it was on, or which table was active (--measured-with off, --measured-with on, or --measured-with and the file of the table)</source>
        <translation>la mesure n&apos;indique pas si une compensation était active&#xa0;: indiquer qu&apos;elle était désactivée, qu&apos;elle était activée, ou quelle table était active (--measured-with off, --measured-with on, ou --measured-with et le fichier de la table)</translation>
    </message>
    <message>
        <source>the measurement says that it was made with {recorded}, not with {stated}; say nothing else (--measured-with), or take the table that was active</source>
        <translation>la mesure indique qu&apos;elle a été faite avec {recorded}, non avec {stated}&#xa0;; ne rien indiquer d&apos;autre (--measured-with) ou prendre la table qui était active</translation>
    </message>
    <message>
        <source>these are residuals of the table {crc}, which was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>ce sont des écarts résiduels de la table {crc}, active pendant la mesure&#xa0;: les fusionner avec cette table, depuis son fichier ou depuis le variateur (--onto et le fichier, ou --onto drive)</translation>
    </message>
    <message>
        <source>these are residuals of a table that was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>ce sont des écarts résiduels d&apos;une table active pendant la mesure&#xa0;: les fusionner avec cette table, depuis son fichier ou depuis le variateur (--onto et le fichier, ou --onto drive)</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, which is not {name} ({known}), nor any other table known; give its file (--measured-with), or merge onto it</source>
        <translation>mesuré avec la table {crc} active, qui n&apos;est ni {name} ({known}) ni une autre table connue&#xa0;; indiquer son fichier (--measured-with) ou fusionner avec elle</translation>
    </message>
    <message>
        <source>it was measured with the compensation off: the values are the whole error, and must not be added to {name}; merge them onto nothing (leave out --onto), or measure with that table active</source>
        <translation>mesuré avec la compensation désactivée&#xa0;: les valeurs sont l&apos;erreur entière et ne doivent pas être ajoutées à {name}&#xa0;; ne les fusionner avec rien (omettre --onto) ou mesurer avec cette table active</translation>
    </message>
    <message>
        <source>at which position the drive looks the table up decides where its values belong: choose the encoder, for a position before the compensation, or the set position, for one after it (--lookup-at encoder or --lookup-at set)</source>
        <translation>la position à laquelle le variateur consulte la table décide de la place de ses valeurs&#xa0;: choisir le codeur, pour une position avant compensation, ou la position de consigne, pour une position après (--lookup-at encoder ou --lookup-at set)</translation>
    </message>
    <message>
        <source>how the artefact lay is found from the deviations along all of its axes, but there is no column for {axis}, such as d{axis}; take out nothing (--remove)</source>
        <translation>le placement de l&apos;étalon se déduit des écarts suivant tous ses axes, mais il n&apos;y a pas de colonne pour {axis}, telle que d{axis}&#xa0;; ne rien retirer (--remove)</translation>
    </message>
    <message>
        <source>the positions along {axis} are no even grid; say the grid of the table: its points, or their distance (--points or --distance)</source>
        <translation>les positions suivant {axis} ne forment pas une grille régulière&#xa0;; indiquer la grille de la table&#xa0;: ses points ou leur pas (--points ou --distance)</translation>
    </message>
    <message>
        <source>a table over temperature is made of runs with targets along one axis</source>
        <translation>une table selon la température s&apos;établit à partir de passes sur des positions cibles suivant un axe</translation>
    </message>
    <message>
        <source>the home position of the axis is not known: give it (--home), or the position of the zero (--zero)</source>
        <translation>la position d&apos;origine de l&apos;axe n&apos;est pas connue&#xa0;: l&apos;indiquer (--home) ou indiquer la position du zéro (--zero)</translation>
    </message>
    <message>
        <source>the home position {home} is outside the targets, so that the error there is not known; take the first target for the zero or another position (--zero)</source>
        <translation>la position d&apos;origine {home} est hors des positions cibles, l&apos;erreur n&apos;y est donc pas connue&#xa0;; prendre pour zéro la première position cible ou une autre position (--zero)</translation>
    </message>
    <message>
        <source>the targets are not evenly spaced; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>les positions cibles ne sont pas équidistantes&#xa0;; indiquer la grille de la table&#xa0;: ses points, leur pas ou son éloignement admis de la courbe (--points, --distance ou --within)</translation>
    </message>
    <message>
        <source>the thermal states span {span}, less than five times the {scatter} by which the temperature varies within them: let the machine settle before each run</source>
        <translation>les états thermiques couvrent {span}, moins de cinq fois la variation de {scatter} de la température en leur sein&#xa0;: laisser la machine se stabiliser avant chaque passe</translation>
    </message>
    <message>
        <source>at {temperature} it was measured from {from} to {to}, at {other} from {otherFrom} to {otherTo}: measure the same range in each thermal state</source>
        <translation>à {temperature}, la mesure va de {from} à {to}, à {other}, de {otherFrom} à {otherTo}&#xa0;: mesurer la même étendue dans chaque état thermique</translation>
    </message>
    <message numerus="yes">
        <source>{count} values have no temperature; a table over temperature needs that of each (the column temperature)</source>
        <comment>1 value has no temperature; a table over temperature needs that of each (the column temperature)</comment>
        <translation>
            <numerusform>{count} valeur est sans température&#xa0;; une table selon la température exige celle de chaque valeur (la colonne temperature)</numerusform>
            <numerusform>{count} valeurs sont sans température&#xa0;; une table selon la température exige celle de chaque valeur (la colonne temperature)</numerusform>
        </translation>
    </message>
    <message>
        <source>residuals are not merged over temperature: measure with the compensation off</source>
        <translation>les écarts résiduels ne se fusionnent pas selon la température&#xa0;: mesurer avec la compensation désactivée</translation>
    </message>
    <message>
        <source>a table over temperature has two dimensions: give at most two numbers for its grid</source>
        <translation>une table selon la température a deux dimensions&#xa0;: indiquer au plus deux nombres pour sa grille</translation>
    </message>
    <message>
        <source>the targets differ from one thermal state to the other, so that they give no grid together; say the grid of the table with --points or --distance</source>
        <translation>les positions cibles diffèrent d&apos;un état thermique à l&apos;autre et ne forment donc pas une grille ensemble&#xa0;; indiquer la grille de la table avec --points ou --distance</translation>
    </message>
    <message>
        <source>the grid has {count} points, and a table holds {most}; take fewer</source>
        <translation>la grille a {count} points, et une table en contient {most} au plus&#xa0;; en prendre moins</translation>
    </message>
    <message>
        <source>name the axis as the drive or the control names it, such as X</source>
        <translation>nommer l&apos;axe comme le variateur ou la commande le nomme, par exemple X</translation>
    </message>
    <message>
        <source>the pattern {pattern} is no regular expression: {problem} at character {place}</source>
        <translation>le motif {pattern} n&apos;est pas une expression régulière&#xa0;: {problem} au caractère {place}</translation>
    </message>
    <message>
        <source>the request {text}: behind a backslash r, n, t or another backslash is expected</source>
        <translation>la requête {text}&#xa0;: après une barre oblique inverse, r, n, t ou une autre barre oblique inverse est attendu</translation>
    </message>
    <message>
        <source>the connection was removed</source>
        <translation>la connexion a été retirée</translation>
    </message>
    <message>
        <source>its name is one of a program for a control, and a plan in it would mislead the control; choose a name that ends in .csv</source>
        <translation>son nom est celui d&apos;un programme pour une commande, et un plan ainsi nommé tromperait la commande&#xa0;; choisir un nom en .csv</translation>
    </message>
    <message>
        <source>choose the file of the table that was active</source>
        <translation>choisir le fichier de la table qui était active</translation>
    </message>
    <message>
        <source>its content cannot be used</source>
        <translation>son contenu n&apos;est pas utilisable</translation>
    </message>
    <message>
        <source>{file} cannot be used as the table: {reason}</source>
        <translation>{file} n&apos;est pas utilisable comme table&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>there is no axis whose table the residuals could be merged onto; choose one, or take the file of the table</source>
        <translation>aucun axe n&apos;a de table avec laquelle fusionner les écarts résiduels&#xa0;; choisir un axe ou prendre le fichier de la table</translation>
    </message>
    <message>
        <source>the table of the axis is still being read from the drive</source>
        <translation>la table de l&apos;axe est encore en cours de lecture sur le variateur</translation>
    </message>
    <message>
        <source>a report is PDF or HTML; choose a name that ends in .pdf or .html</source>
        <translation>un rapport est en PDF ou HTML&#xa0;; choisir un nom en .pdf ou .html</translation>
    </message>
    <message>
        <source>all runs were measured in one thermal state; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>toutes les passes ont été mesurées dans un même état thermique&#xa0;; une table selon la température en exige au moins deux, distants de {least} (des passes à moins de {gap} forment un seul état)</translation>
    </message>
    <message>
        <source>the runs were measured in {count} thermal states that span {span}; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>les passes ont été mesurées dans {count} états thermiques couvrant {span}&#xa0;; une table selon la température en exige au moins deux, distants de {least} (des passes à moins de {gap} forment un seul état)</translation>
    </message>
    <message>
        <source>a table for each direction is made of runs over targets; make those of a track one after the other (--direction positive, then --direction negative)</source>
        <translation>une table par sens s&apos;établit à partir de passes sur des positions cibles&#xa0;; établir celles d&apos;un relevé continu l&apos;une après l&apos;autre (--direction positive, puis --direction negative)</translation>
    </message>
    <message>
        <source>{name} has one value for both directions, and so has what is merged onto it: make the table of the mean (--direction mean)</source>
        <translation>{name} a une valeur pour les deux sens, et donc aussi ce qui est fusionné avec&#xa0;: établir la table de la moyenne (--direction mean)</translation>
    </message>
    <message>
        <source>a table over position and temperature is for a drive, which has one value for both directions (--direction mean)</source>
        <translation>une table selon la position et la température est destinée à un variateur, qui a une valeur pour les deux sens (--direction mean)</translation>
    </message>
    <message>
        <source>--remove-slope, --turn, --home and --remove-drift are for runs over targets along one axis</source>
        <translation>--remove-slope, --turn, --home et --remove-drift valent pour des passes sur des positions cibles suivant un axe</translation>
    </message>
    <message>
        <source>the fewest points that leave no more than a deviation (--within) are counted on a curve, which runs have, and a track with --method smooth; say the points of the grid or their distance (--points or --distance)</source>
        <translation>le plus petit nombre de points pour un écart donné (--within) se compte sur une courbe, ce qu&apos;ont les passes, et un relevé continu avec --method smooth&#xa0;; sinon, indiquer les points de la grille ou leur pas (--points ou --distance)</translation>
    </message>
    <message>
        <source>the name on the drive is {name}</source>
        <translation>le nom sur le variateur est {name}</translation>
    </message>
    <message>
        <source>the first measurement is of axis {before} and the second of axis {after}; they are not of the same axis</source>
        <translation>la première mesure est de l&apos;axe {before} et la seconde de l&apos;axe {after}&#xa0;; elles ne sont pas du même axe</translation>
    </message>
    <message>
        <source>measurements of axis {axis} and of axis {other} cannot be joined</source>
        <translation>des mesures de l&apos;axe {axis} et de l&apos;axe {other} ne peuvent pas être réunies</translation>
    </message>
    <message>
        <source>the position of the zero is missing</source>
        <translation>la position du zéro manque</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, lookup: encoder or lookup: set, says for which side of the compensation the table was made: correct that line, or leave it out</source>
        <translation>le fichier indique «&#xa0;{note}&#xa0;», où un seul commentaire, lookup: encoder ou lookup: set, précise pour quel côté de la compensation la table a été établie&#xa0;: corriger ou supprimer cette ligne</translation>
    </message>
    <message>
        <source>these drives make no machine: {problem}</source>
        <translation>ces variateurs ne forment pas une machine&#xa0;: {problem}</translation>
    </message>
    <message>
        <source>the connection was ended</source>
        <translation>la connexion a pris fin</translation>
    </message>
    <message>
        <source>number of the axis, from 0</source>
        <translation>numéro de l&apos;axe, à partir de 0</translation>
    </message>
    <message>
        <source>number of the zone of the error map, from 0</source>
        <translation>numéro de la zone de la carte d&apos;erreurs, à partir de 0</translation>
    </message>
    <message>
        <source>how the array is mapped: ERRORMAP1D, or CONNECT with MAP</source>
        <translation>comment le tableau est associé&#xa0;: ERRORMAP1D, ou CONNECT avec MAP</translation>
    </message>
    <message>
        <source>ERRORMAP1D axis, zone, base, step, array</source>
        <translation>ERRORMAP1D axe, zone, début, pas, tableau</translation>
    </message>
    <message>
        <source>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), array, base, step)</source>
        <translation>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), tableau, début, pas)</translation>
    </message>
    <message>
        <source>a step of {step}</source>
        <translation>un pas de {step}</translation>
    </message>
    <message>
        <source>a step above 0</source>
        <translation>un pas supérieur à 0</translation>
    </message>
    <message>
        <source>another map of axis {axis}, besides that of line {line}</source>
        <translation>une autre carte de l&apos;axe {axis}, en plus de celle de la ligne {line}</translation>
    </message>
    <message>
        <source>one map of an axis; both are read, and the program decides which one counts</source>
        <translation>une carte par axe&#xa0;; les deux sont lues, et le programme décide laquelle compte</translation>
    </message>
    <message>
        <source>no ERRORMAPON {axis}, {zone}</source>
        <translation>aucun ERRORMAPON {axis}, {zone}</translation>
    </message>
    <message>
        <source>a statement that switches the map on, which may stand in another program</source>
        <translation>une instruction qui active la carte, et qui peut se trouver dans un autre programme</translation>
    </message>
    <message>
        <source>a map over two axes (MAP2)</source>
        <translation>une carte sur deux axes (MAP2)</translation>
    </message>
    <message>
        <source>the format {format} to read it</source>
        <translation>le format {format} pour la lire</translation>
    </message>
    <message>
        <source>a statement ERRORMAP1D, or CONNECT with MAP, of which there is none</source>
        <translation>une instruction ERRORMAP1D, ou CONNECT avec MAP, et il n&apos;y en a aucune</translation>
    </message>
    <message>
        <source>the axis must be referenced; the connection replaces an error map of the axis</source>
        <translation>l&apos;axe doit avoir son origine prise&#xa0;; la connexion remplace une carte d&apos;erreurs de l&apos;axe</translation>
    </message>
    <message>
        <source>the axis must be referenced, and a map that is on switched off with ERRORMAPOFF before; ERRORUNMAP {axis}, {zone} removes the map</source>
        <translation>l&apos;axe doit avoir son origine prise, et une carte activée doit d&apos;abord être désactivée par ERRORMAPOFF&#xa0;; ERRORUNMAP {axis}, {zone} retire la carte</translation>
    </message>
    <message>
        <source>program with the error map of an axis (ERRORMAP1D, or CONNECT with MAP)</source>
        <translation>programme avec la carte d&apos;erreurs d&apos;un axe (ERRORMAP1D, ou CONNECT avec MAP)</translation>
    </message>
    <message>
        <source>number of the axis of the first source of the table, from 0</source>
        <translation>numéro de l&apos;axe de la première source de la table, à partir de 0</translation>
    </message>
    <message>
        <source>number of the axis of the second source of the table, from 0</source>
        <translation>numéro de l&apos;axe de la deuxième source de la table, à partir de 0</translation>
    </message>
    <message>
        <source>number of the axis that is compensated, from 0; needed where it is none of the sources</source>
        <translation>numéro de l&apos;axe compensé, à partir de 0&#xa0;; nécessaire s&apos;il n&apos;est aucune des sources</translation>
    </message>
    <message>
        <source>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), array, base1, step1, base2, step2)</source>
        <translation>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), tableau, début1, pas1, début2, pas2)</translation>
    </message>
    <message>
        <source>a map of one axis ({name})</source>
        <translation>une carte d&apos;un axe ({name})</translation>
    </message>
    <message>
        <source>a statement CONNECT with MAP2, of which there is none</source>
        <translation>une instruction CONNECT avec MAP2, et il n&apos;y en a aucune</translation>
    </message>
    <message>
        <source>both sources are axis {axis}: {key} and {other}</source>
        <translation>les deux sources sont l&apos;axe {axis}&#xa0;: {key} et {other}</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key}, since the table corrects none of its sources</source>
        <translation>le format {format} exige le réglage {key}, puisque la table ne corrige aucune de ses sources</translation>
    </message>
    <message>
        <source>the table goes from {column}, which the settings {key}, {other} and {target} contradict</source>
        <translation>la table va de {column}, ce que contredisent les réglages {key}, {other} et {target}</translation>
    </message>
    <message>
        <source>the axes must be referenced; the connection replaces an error map of axis {axis}</source>
        <translation>les axes doivent avoir leur origine prise&#xa0;; la connexion remplace une carte d&apos;erreurs de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>program with the map of an axis over two (MAP2)</source>
        <translation>programme avec la carte d&apos;un axe sur deux axes (MAP2)</translation>
    </message>
    <message>
        <source>a number, or a name that got one before</source>
        <translation>un nombre, ou un nom qui en a reçu un auparavant</translation>
    </message>
    <message>
        <source>one number; other buffers give it another one in line {line}</source>
        <translation>un seul nombre&#xa0;; d&apos;autres tampons lui en donnent un autre à la ligne {line}</translation>
    </message>
    <message>
        <source>a name that got a number; in line {line} it gets something that is not computed here</source>
        <translation>un nom qui a reçu un nombre&#xa0;; à la ligne {line}, il reçoit une valeur qui n&apos;est pas calculée ici</translation>
    </message>
    <message>
        <source>a whole number, since it is declared INT; in line {line} it gets another one</source>
        <translation>un nombre entier, puisqu&apos;il est déclaré INT&#xa0;; à la ligne {line}, il en reçoit un autre</translation>
    </message>
    <message>
        <source>a number with a decimal point, or a name that got one; expressions are not computed</source>
        <translation>un nombre avec point décimal, ou un nom qui en a reçu un&#xa0;; les expressions ne sont pas calculées</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>un nombre entier à partir de 0</translation>
    </message>
    <message>
        <source>one index of {name}</source>
        <translation>un indice de {name}</translation>
    </message>
    <message>
        <source>two indices of {name}</source>
        <translation>deux indices de {name}</translation>
    </message>
    <message>
        <source>an index of {name}: a whole number from 0</source>
        <translation>un indice de {name}&#xa0;: un nombre entier à partir de 0</translation>
    </message>
    <message>
        <source>a number with a decimal point; expressions are not computed</source>
        <translation>un nombre avec point décimal&#xa0;; les expressions ne sont pas calculées</translation>
    </message>
    <message>
        <source>a whole number, since {name} is declared INT</source>
        <translation>un nombre entier, puisque {name} est déclaré INT</translation>
    </message>
    <message>
        <source>an array whose elements are numbers in this program</source>
        <translation>un tableau dont les éléments sont des nombres dans ce programme</translation>
    </message>
    <message>
        <source>{name} with another number of indices</source>
        <translation>{name} avec un autre nombre d&apos;indices</translation>
    </message>
    <message>
        <source>{sizes}, which its elements need</source>
        <translation>{sizes}, comme ses éléments l&apos;exigent</translation>
    </message>
    <message>
        <source>{array} with elements for {sizes}</source>
        <translation>{array} avec des éléments pour {sizes}</translation>
    </message>
    <message>
        <source>a value for each element; the table has those that the program gives, and the controller may use the others as they are</source>
        <translation>une valeur pour chaque élément&#xa0;; la table a celles que donne le programme, et la commande peut utiliser les autres telles quelles</translation>
    </message>
    <message>
        <source>no {element}</source>
        <translation>aucun {element}</translation>
    </message>
    <message>
        <source>a number for each element up to the highest index</source>
        <translation>un nombre pour chaque élément jusqu&apos;à l&apos;indice le plus grand</translation>
    </message>
    <message>
        <source>{element} a second time</source>
        <translation>{element} une deuxième fois</translation>
    </message>
    <message>
        <source>each element once; the last number counts</source>
        <translation>chaque élément une seule fois&#xa0;; le dernier nombre compte</translation>
    </message>
    <message>
        <source>{name}, which is not supported</source>
        <translation>{name}, qui n&apos;est pas pris en charge</translation>
    </message>
    <message>
        <source>ERRORMAP1D, or CONNECT with MAP or MAP2</source>
        <translation>ERRORMAP1D, ou CONNECT avec MAP ou MAP2</translation>
    </message>
    <message>
        <source>name of the array: a letter, then letters, digits and underlines</source>
        <translation>nom du tableau&#xa0;: une lettre, puis des lettres, des chiffres et des tirets bas</translation>
    </message>
    <message>
        <source>the program declares the array; no where the controller has it already</source>
        <translation>le programme déclare le tableau&#xa0;; no si la commande l&apos;a déjà</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is no name for an array of the format {format}, such as {example}; change the setting {key}</source>
        <translation>«&#xa0;{name}&#xa0;» n&apos;est pas un nom de tableau pour le format {format}, tel que {example}&#xa0;; modifier le réglage {key}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}; it is a number from 0</source>
        <translation>le réglage {key} du format {format} est {value}&#xa0;; c&apos;est un nombre à partir de 0</translation>
    </message>
    <message>
        <source>the controller must not have declared the array {name} before, since the program declares it; where it has, set declare=no</source>
        <translation>la commande ne doit pas avoir déjà déclaré le tableau {name}, puisque le programme le déclare&#xa0;; si c&apos;est le cas, régler declare=no</translation>
    </message>
    <message>
        <source>the controller must have declared the array {name}, with as many elements as the program gives it</source>
        <translation>la commande doit avoir déclaré le tableau {name}, avec autant d&apos;éléments que le programme lui en donne</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}, and the axis name is &quot;{name}&quot;; give the setting {key}</source>
        <translation>le format {format} désigne ses axes par l&apos;une des lettres {letters}, et le nom de l&apos;axe est «&#xa0;{name}&#xa0;»&#xa0;; indiquer le réglage {key}</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}; the setting {key} is {value}</source>
        <translation>le format {format} désigne ses axes par l&apos;une des lettres {letters}&#xa0;; le réglage {key} est {value}</translation>
    </message>
    <message>
        <source>the table is of axis &quot;{name}&quot;, and the setting {key} of the format {format} says {value}</source>
        <translation>la table est celle de l&apos;axe «&#xa0;{name}&#xa0;», et le réglage {key} du format {format} indique {value}</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with the position in each line</source>
        <translation>table de valeurs de compensation (.COM) avec la position dans chaque ligne</translation>
    </message>
    <message>
        <source>also distances that are no power of two times 0.0001, for an iTNC 530</source>
        <translation>aussi des pas qui ne sont pas une puissance de deux fois 0.0001, pour une iTNC 530</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with even positions</source>
        <translation>table de valeurs de compensation (.COM) à positions régulières</translation>
    </message>
    <message>
        <source>letter of the axis whose position counts, where its name is none or another one</source>
        <translation>lettre de l&apos;axe dont la position compte, si son nom n&apos;en est pas une ou en est une autre</translation>
    </message>
    <message>
        <source>letter of the axis that is compensated by the position of another one, where its name is none</source>
        <translation>lettre de l&apos;axe compensé selon la position d&apos;un autre, si son nom n&apos;en est pas une</translation>
    </message>
    <message>
        <source>a number in mm or degrees behind {word}</source>
        <translation>un nombre en mm ou en degrés après {word}</translation>
    </message>
    <message>
        <source>the setting {key} {value}</source>
        <translation>le réglage {key} {value}</translation>
    </message>
    <message>
        <source>one letter</source>
        <translation>une lettre</translation>
    </message>
    <message>
        <source>the moving axis, as in AXIS_Y; its letter as the setting {key} where the file has another name</source>
        <translation>l&apos;axe en mouvement, comme dans AXIS_Y&#xa0;; sa lettre par le réglage {key} si le fichier porte un autre nom</translation>
    </message>
    <message>
        <source>axis {axis} in the name of the file</source>
        <translation>l&apos;axe {axis} dans le nom du fichier</translation>
    </message>
    <message>
        <source>axis {axis}, as the setting {key} says</source>
        <translation>l&apos;axe {axis}, comme le réglage {key} l&apos;indique</translation>
    </message>
    <message>
        <source>a first line without MM</source>
        <translation>une première ligne sans MM</translation>
    </message>
    <message>
        <source>MM or INCH; mm is assumed</source>
        <translation>MM ou INCH&#xa0;; mm est supposé</translation>
    </message>
    <message>
        <source>a first line such as {example}</source>
        <translation>une première ligne telle que {example}</translation>
    </message>
    <message>
        <source>a distance of {distance}</source>
        <translation>un pas de {distance}</translation>
    </message>
    <message>
        <source>a tab</source>
        <translation>une tabulation</translation>
    </message>
    <message>
        <source>blanks, since the columns are counted in characters</source>
        <translation>des espaces, car les colonnes se comptent en caractères</translation>
    </message>
    <message>
        <source>each column once</source>
        <translation>chaque colonne une seule fois</translation>
    </message>
    <message>
        <source>a line of headers such as {example}</source>
        <translation>une ligne de titres telle que {example}</translation>
    </message>
    <message>
        <source>a value below the header of an axis, and one in each column</source>
        <translation>une valeur sous le titre d&apos;un axe, et une par colonne</translation>
    </message>
    <message>
        <source>the number of a line</source>
        <translation>le numéro d&apos;une ligne</translation>
    </message>
    <message>
        <source>ascending numbers from 0</source>
        <translation>des numéros croissants à partir de 0</translation>
    </message>
    <message>
        <source>{position}, as DATUM and DISTANCE say for line {number}</source>
        <translation>{position}, comme DATUM et DISTANCE l&apos;indiquent pour la ligne {number}</translation>
    </message>
    <message>
        <source>more than {count} lines</source>
        <translation>plus de {count} lignes</translation>
    </message>
    <message>
        <source>at most {count} lines</source>
        <translation>au plus {count} lignes</translation>
    </message>
    <message>
        <source>a line with its number and its position</source>
        <translation>une ligne avec son numéro et sa position</translation>
    </message>
    <message>
        <source>nothing behind [END]</source>
        <translation>rien après [END]</translation>
    </message>
    <message>
        <source>no line [END]</source>
        <translation>aucune ligne [END]</translation>
    </message>
    <message>
        <source>that line at the end; the file may be cut off</source>
        <translation>cette ligne à la fin&#xa0;; le fichier est peut-être tronqué</translation>
    </message>
    <message>
        <source>the position {position} of the rotary axis {axis}</source>
        <translation>la position {position} de l&apos;axe rotatif {axis}</translation>
    </message>
    <message>
        <source>0 to 360 deg; the control does not use others</source>
        <translation>0 à 360 deg&#xa0;; la commande n&apos;en utilise pas d&apos;autres</translation>
    </message>
    <message>
        <source>values of {axis} that change by {change}</source>
        <translation>des valeurs de {axis} qui varient de {change}</translation>
    </message>
    <message>
        <source>at most {limit} from line to line, DISTANCE / 64, on older controls</source>
        <translation>au plus {limit} d&apos;une ligne à l&apos;autre, DISTANCE / 64, sur les anciennes commandes</translation>
    </message>
    <message>
        <source>values in a column, of which there are none</source>
        <translation>des valeurs dans une colonne, et il n&apos;y en a aucune</translation>
    </message>
    <message>
        <source>the column of {axis}</source>
        <translation>la colonne de {axis}</translation>
    </message>
    <message>
        <source>a line of headers behind the first line</source>
        <translation>une ligne de titres après la première ligne</translation>
    </message>
    <message numerus="yes">
        <source>{count} values in the column BACKLASH</source>
        <comment>1 value in the column BACKLASH</comment>
        <translation>
            <numerusform>{count} valeur dans la colonne BACKLASH</numerusform>
            <numerusform>{count} valeurs dans la colonne BACKLASH</numerusform>
        </translation>
    </message>
    <message>
        <source>none: it is not published whether they are whole values or differences</source>
        <translation>aucune&#xa0;: rien n&apos;est publié sur leur nature, valeurs entières ou différences</translation>
    </message>
    <message>
        <source>the table goes from {column}, and the settings for its axes say {axis} for both</source>
        <translation>la table va de {column}, et les réglages de ses axes indiquent {axis} pour les deux</translation>
    </message>
    <message>
        <source>there are two columns for axis {axis}</source>
        <translation>il y a deux colonnes pour l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>its numbers for axis {axis} are in {unit}; A, B and C are in degrees, other axes in mm</source>
        <translation>ses nombres pour l&apos;axe {axis} sont en {unit}&#xa0;; A, B et C sont en degrés, les autres axes en mm</translation>
    </message>
    <message>
        <source>check the units and the axes of the table</source>
        <translation>vérifier les unités et les axes de la table</translation>
    </message>
    <message>
        <source>its positions go from {first} to {last}, and of a rotary axis only 0 to 360 degrees count</source>
        <translation>ses positions vont de {first} à {last}, et pour un axe rotatif, seuls 0 à 360 degrés comptent</translation>
    </message>
    <message>
        <source>give them from 0 to 360 degrees in the file that is converted, -90 as 270</source>
        <translation>les indiquer de 0 à 360 degrés dans le fichier à convertir, -90 comme 270</translation>
    </message>
    <message>
        <source>the numbers for axis {axis} have no unit; they are taken to be in {unit}</source>
        <translation>les nombres pour l&apos;axe {axis} n&apos;ont pas d&apos;unité&#xa0;; {unit} est supposé</translation>
    </message>
    <message>
        <source>its distance is {distance}; the TNC 407 takes a power of two times {step}, and the next ones are {below} and {above}</source>
        <translation>son pas est {distance}&#xa0;; la TNC 407 exige une puissance de deux fois {step}, et les plus proches sont {below} et {above}</translation>
    </message>
    <message>
        <source>resample it with one of these distances, or set any-distance=yes for an iTNC 530</source>
        <translation>la rééchantillonner avec l&apos;un de ces pas, ou régler any-distance=yes pour une iTNC 530</translation>
    </message>
    <message>
        <source>its distance {distance} has more than {count} decimals</source>
        <translation>son pas {distance} a plus de {count} décimales</translation>
    </message>
    <message>
        <source>resample it with a distance of fewer decimals</source>
        <translation>la rééchantillonner avec un pas ayant moins de décimales</translation>
    </message>
    <message>
        <source>the number {number} has more digits than a column holds</source>
        <translation>le nombre {number} a plus de chiffres qu&apos;une colonne n&apos;en contient</translation>
    </message>
    <message>
        <source>no text says the sign of a .COM table; it is written as the error, actual - commanded position. Check one point on the machine</source>
        <translation>aucun document n&apos;indique le signe d&apos;une table .COM&#xa0;; elle est écrite comme erreur, position réelle - position de consigne. Vérifier un point sur la machine</translation>
    </message>
    <message>
        <source>name the file in a line of config.cma, in the column of axis {axis}, and mark the line with *; older controls also need the bit of the axis in MP730</source>
        <translation>nommer le fichier dans une ligne de config.cma, dans la colonne de l&apos;axe {axis}, et marquer la ligne d&apos;un *&#xa0;; les anciennes commandes exigent aussi le bit de l&apos;axe dans MP730</translation>
    </message>
    <message>
        <source>axis of the table, where the table names none of these</source>
        <translation>axe de la table, si celle-ci n&apos;en nomme aucun de ceux-ci</translation>
    </message>
    <message>
        <source>the unit &quot;{unit}&quot;</source>
        <translation>l&apos;unité «&#xa0;{unit}&#xa0;»</translation>
    </message>
    <message>
        <source>mm, the only unit of this file</source>
        <translation>mm, la seule unité de ce fichier</translation>
    </message>
    <message>
        <source>the letter of an axis between brackets, such as [X]</source>
        <translation>la lettre d&apos;un axe entre crochets, par exemple [X]</translation>
    </message>
    <message>
        <source>a section of axis {axis}</source>
        <translation>une section de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>X, Y or Z</source>
        <translation>X, Y ou Z</translation>
    </message>
    <message>
        <source>a second section of axis {axis}</source>
        <translation>une deuxième section de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>each axis once; the first is in line {line}</source>
        <translation>chaque axe une seule fois&#xa0;; la première section est à la ligne {line}</translation>
    </message>
    <message>
        <source>a section such as [X] before the first numbers</source>
        <translation>une section telle que [X] avant les premiers nombres</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers between commas</source>
        <comment>1 number between commas</comment>
        <translation>
            <numerusform>{count} nombre entre virgules</numerusform>
            <numerusform>{count} nombres entre virgules</numerusform>
        </translation>
    </message>
    <message>
        <source>3, with decimal points: nominal position, forward error, backward error</source>
        <translation>3, avec points décimaux&#xa0;: position nominale, erreur aller, erreur retour</translation>
    </message>
    <message>
        <source>a forward error in mm</source>
        <translation>une erreur aller en mm</translation>
    </message>
    <message>
        <source>a backward error in mm</source>
        <translation>une erreur retour en mm</translation>
    </message>
    <message>
        <source>a section such as [X], of which there is none</source>
        <translation>une section telle que [X], et il n&apos;y en a aucune</translation>
    </message>
    <message>
        <source>no line unit=mm</source>
        <translation>aucune ligne unit=mm</translation>
    </message>
    <message>
        <source>that line; mm is the only unit</source>
        <translation>cette ligne&#xa0;; mm est la seule unité</translation>
    </message>
    <message>
        <source>the file is axeserr.dat in the folder of the software (NK200: from a USB stick), read when the software starts</source>
        <translation>le fichier est axeserr.dat dans le dossier du logiciel (NK200&#xa0;: depuis une clé USB), lu au démarrage du logiciel</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2: both directions</source>
        <translation>régler le paramètre Screw error compensation sur 2&#xa0;: les deux sens</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2, or to 1 with the backlash as a parameter of its own</source>
        <translation>régler le paramètre Screw error compensation sur 2, ou sur 1 avec le jeu comme paramètre propre</translation>
    </message>
    <message>
        <source>positions are machine coordinates from the reference point and must lie within the stroke, else the compensation is invalid</source>
        <translation>les positions sont des coordonnées machine depuis le point de référence et doivent être dans la course, sinon la compensation n&apos;est pas valide</translation>
    </message>
    <message>
        <source>axeserr.dat: screw errors forwards and backwards</source>
        <translation>axeserr.dat&#xa0;: erreurs de vis aller et retour</translation>
    </message>
    <message>
        <source>nobody has published which sign files of the format {format} have; {sign} is an assumption. Check one point on the machine, and state feedback or command {statement}</source>
        <translation>le signe des fichiers au format {format} n&apos;a jamais été publié&#xa0;; {sign} est une hypothèse. Vérifier un point sur la machine et indiquer feedback ou command, {statement}</translation>
    </message>
    <message>
        <source>holds the end values</source>
        <translation>maintient les valeurs d&apos;extrémité</translation>
    </message>
    <message>
        <source>applies nothing</source>
        <translation>n&apos;applique rien</translation>
    </message>
    <message>
        <source>goes on as in the last cell</source>
        <translation>continue comme dans la dernière cellule</translation>
    </message>
    <message>
        <source>beyond the ends of the table the controller of {from} {before}, and that of {to} {after}: up to one cell beyond them, the corrections for {column} differ by at most {largest}, at {place}</source>
        <translation>au-delà des extrémités de la table, la commande de {from} {before}, et celle de {to} {after}&#xa0;: jusqu&apos;à une cellule au-delà, les corrections pour {column} diffèrent d&apos;au plus {largest}, à {place}</translation>
    </message>
    <message>
        <source>in the field Sign, or with {option}</source>
        <translation>dans le champ Signe, ou avec {option}</translation>
    </message>
    <message>
        <source>in the field Sign, with {option}, or as {entry} in a machine file</source>
        <translation>dans le champ Signe, avec {option}, ou par {entry} dans un fichier machine</translation>
    </message>
    <message>
        <source>an entry such as {example}</source>
        <translation>un élément tel que {example}</translation>
    </message>
    <message>
        <source>each entry once; the last one counts</source>
        <translation>chaque élément une seule fois&#xa0;; le dernier compte</translation>
    </message>
    <message>
        <source>a value in mm</source>
        <translation>une valeur en mm</translation>
    </message>
    <message>
        <source>{key} and {key2} as the ends of {list}</source>
        <translation>{key} et {key2} comme extrémités de {list}</translation>
    </message>
    <message>
        <source>{key} and {key2}, as later firmware writes them</source>
        <translation>{key} et {key2}, comme les écrit un firmware plus récent</translation>
    </message>
    <message>
        <source>entries {key} and {key2} for {list}</source>
        <translation>les éléments {key} et {key2} pour {list}</translation>
    </message>
    <message>
        <source>an end above the start</source>
        <translation>une fin supérieure au début</translation>
    </message>
    <message>
        <source>a section [{section}] with {list} or {list2}</source>
        <translation>une section [{section}] avec {list} ou {list2}</translation>
    </message>
    <message>
        <source>[axis_twist_compensation] of printer.cfg: errors of the probe over X or Y</source>
        <translation>[axis_twist_compensation] de printer.cfg&#xa0;: erreurs du palpeur selon X ou Y</translation>
    </message>
    <message>
        <source>unit of all numbers of the file; the controller takes them to be inches, and files in millimetres occur</source>
        <translation>unité de tous les nombres du fichier&#xa0;; la commande les prend pour des pouces, et il existe des fichiers en millimètres</translation>
    </message>
    <message>
        <source>a missing number</source>
        <translation>un nombre manquant</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers with commas between</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>{count} nombre</numerusform>
            <numerusform>{count} nombres séparés par des virgules</numerusform>
        </translation>
    </message>
    <message>
        <source>a comma directly behind the number &quot;{number}&quot;</source>
        <translation>une virgule juste après le nombre «&#xa0;{number}&#xa0;»</translation>
    </message>
    <message>
        <source>rows and columns, distances of X and Y, and X and Y of the first point</source>
        <translation>lignes et colonnes, pas en X et Y, et X et Y du premier point</translation>
    </message>
    <message>
        <source>a number of rows or columns, {number} to {number2}</source>
        <translation>un nombre de lignes ou de colonnes, {number} à {number2}</translation>
    </message>
    <message>
        <source>a distance such as 0.5</source>
        <translation>un pas tel que 0.5</translation>
    </message>
    <message>
        <source>another one: with 0 the controller corrects nothing</source>
        <translation>un autre&#xa0;: avec 0, la commande ne corrige rien</translation>
    </message>
    <message>
        <source>a position of row 0 and column 0</source>
        <translation>une position de la ligne 0 et de la colonne 0</translation>
    </message>
    <message>
        <source>the number of a row, 0 to {last}</source>
        <translation>le numéro d&apos;une ligne, 0 à {last}</translation>
    </message>
    <message>
        <source>the number of a column, 0 to {last}</source>
        <translation>le numéro d&apos;une colonne, 0 à {last}</translation>
    </message>
    <message>
        <source>row {row}, column {column}</source>
        <translation>ligne {row}, colonne {column}</translation>
    </message>
    <message>
        <source>each point once; the last line counts</source>
        <translation>chaque point une seule fois&#xa0;; la dernière ligne compte</translation>
    </message>
    <message numerus="yes">
        <source>no line for {count} points, the first of them {point}</source>
        <comment>no line for {point}</comment>
        <translation>
            <numerusform>aucune ligne pour {count} point, {point}</numerusform>
            <numerusform>aucune ligne pour {count} points, le premier étant {point}</numerusform>
        </translation>
    </message>
    <message>
        <source>a line for each of the {rows} x {columns} points</source>
        <translation>une ligne pour chacun des {rows} x {columns} points</translation>
    </message>
    <message>
        <source>further numbers behind the last point</source>
        <translation>d&apos;autres nombres après le dernier point</translation>
    </message>
    <message>
        <source>{number} points; the controller does not read more either</source>
        <translation>{number} points&#xa0;; la commande n&apos;en lit pas davantage</translation>
    </message>
    <message>
        <source>numbers without a unit, taken to be {unit}</source>
        <translation>des nombres sans unité, {unit} est supposé</translation>
    </message>
    <message>
        <source>the setting {key}, {value} or {value2}</source>
        <translation>le réglage {key}, {value} ou {value2}</translation>
    </message>
    <message>
        <source>its source {number} is {axis}, and this one is {name}</source>
        <translation>sa source {number} est {axis}, et celle-ci est {name}</translation>
    </message>
    <message>
        <source>exchange the sources of the table</source>
        <translation>permuter les sources de la table</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than the {limit} that the controller takes</source>
        <translation>{count} points suivant {axis}, la commande en accepte {limit} au plus</translation>
    </message>
    <message>
        <source>it corrects X, Y and Z, and this table goes from {column}</source>
        <translation>il corrige X, Y et Z, et cette table va de {column}</translation>
    </message>
    <message>
        <source>state the target as Z, or as other, where it is Z</source>
        <translation>indiquer l&apos;axe cible par Z, ou par other si c&apos;est Z</translation>
    </message>
    <message>
        <source>two columns go from {column}</source>
        <translation>deux colonnes vont de {column}</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>n&apos;en garder qu&apos;une</translation>
    </message>
    <message>
        <source>the numbers of the file are in {unit}; the controller takes them to be inches</source>
        <translation>les nombres du fichier sont en {unit}&#xa0;; la commande les prend pour des pouces</translation>
    </message>
    <message>
        <source>name the file as Geo File in the tool setup of KMotionCNC; arcs are then broken into short lines, and Z is corrected for the plane Z = 0 only</source>
        <translation>indiquer le fichier comme Geo File dans le Tool Setup de KMotionCNC&#xa0;; les arcs sont alors divisés en courts segments, et Z n&apos;est corrigé que pour le plan Z = 0</translation>
    </message>
    <message>
        <source>geometric correction of X, Y and Z over X and Y</source>
        <translation>correction géométrique de X, Y et Z selon X et Y</translation>
    </message>
    <message>
        <source>a line each for the number of positions, the size of a range and the first position</source>
        <translation>une ligne chacun pour le nombre de positions, la taille d&apos;un intervalle et la première position</translation>
    </message>
    <message>
        <source>a number of positions</source>
        <translation>un nombre de positions</translation>
    </message>
    <message>
        <source>the size of a range</source>
        <translation>la taille d&apos;un intervalle</translation>
    </message>
    <message>
        <source>the first position</source>
        <translation>la première position</translation>
    </message>
    <message>
        <source>a range of {size}</source>
        <translation>un intervalle de {size}</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>plus de 0</translation>
    </message>
    <message>
        <source>index and position, or the position alone</source>
        <translation>l&apos;indice et la position, ou la position seule</translation>
    </message>
    <message>
        <source>an index from 0</source>
        <translation>un indice à partir de 0</translation>
    </message>
    <message>
        <source>the index {number}</source>
        <translation>l&apos;indice {number}</translation>
    </message>
    <message>
        <source>{number}: indices count from 0 in the order of the lines</source>
        <translation>{number}&#xa0;: les indices comptent à partir de 0 dans l&apos;ordre des lignes</translation>
    </message>
    <message>
        <source>a position to command</source>
        <translation>une position à commander</translation>
    </message>
    <message>
        <source>{value}, as the first line says</source>
        <translation>{value}, comme la première ligne l&apos;indique</translation>
    </message>
    <message>
        <source>strictly increasing positions to command; a list of corrections is no such file</source>
        <translation>des positions à commander strictement croissantes&#xa0;; une liste de corrections n&apos;est pas un tel fichier</translation>
    </message>
    <message>
        <source>at {position} the position to command, {sum}, is not larger than the one before, {before}</source>
        <translation>à {position}, la position à commander, {sum}, n&apos;est pas supérieure à la précédente, {before}</translation>
    </message>
    <message>
        <source>the file holds positions to command, not corrections; KMotionCNC applies them after the geometric correction</source>
        <translation>le fichier contient des positions à commander, non des corrections&#xa0;; KMotionCNC les applique après la correction géométrique</translation>
    </message>
    <message>
        <source>linear table of one axis: positions to command</source>
        <translation>table linéaire d&apos;un axe&#xa0;: positions à commander</translation>
    </message>
    <message>
        <source>motor units for one unit of the positions</source>
        <translation>unités moteur par unité des positions</translation>
    </message>
    <message>
        <source>number of the table, from 0</source>
        <translation>numéro de la table, à partir de 0</translation>
    </message>
    <message>
        <source>number of the motor whose position counts</source>
        <translation>numéro du moteur dont la position compte</translation>
    </message>
    <message>
        <source>number of the motor that is compensated</source>
        <translation>numéro du moteur compensé</translation>
    </message>
    <message>
        <source>a value of the table</source>
        <translation>une valeur de la table</translation>
    </message>
    <message>
        <source>value {number} again</source>
        <translation>la valeur {number} de nouveau</translation>
    </message>
    <message>
        <source>each value once; the last one counts</source>
        <translation>chaque valeur une seule fois&#xa0;; la dernière compte</translation>
    </message>
    <message>
        <source>an assignment such as {example}</source>
        <translation>une affectation telle que {example}</translation>
    </message>
    <message>
        <source>{element} of the table: {meaning}</source>
        <translation>{element} de la table&#xa0;: {meaning}</translation>
    </message>
    <message>
        <source>CompPos or CompPos2 of one motor, such as {example}</source>
        <translation>CompPos ou CompPos2 d&apos;un moteur, tel que {example}</translation>
    </message>
    <message>
        <source>the motor that is compensated</source>
        <translation>le moteur compensé</translation>
    </message>
    <message>
        <source>the scale factor of the values</source>
        <translation>le facteur d&apos;échelle des valeurs</translation>
    </message>
    <message>
        <source>a scale factor Sf[0] of {factor}</source>
        <translation>un facteur d&apos;échelle Sf[0] de {factor}</translation>
    </message>
    <message>
        <source>1; it is taken to multiply the values</source>
        <translation>1&#xa0;; il est supposé multiplier les valeurs</translation>
    </message>
    <message>
        <source>{value}; what other bits do is not known</source>
        <translation>{value}&#xa0;; l&apos;effet d&apos;autres bits n&apos;est pas connu</translation>
    </message>
    <message>
        <source>no value {number}</source>
        <translation>aucune valeur {number}</translation>
    </message>
    <message>
        <source>a table of several sources</source>
        <translation>une table à plusieurs sources</translation>
    </message>
    <message>
        <source>one source: in which order the values of several stand is not known</source>
        <translation>une source&#xa0;: l&apos;ordre des valeurs de plusieurs sources n&apos;est pas connu</translation>
    </message>
    <message>
        <source>the number of segments, one less than values</source>
        <translation>le nombre de segments, un de moins que de valeurs</translation>
    </message>
    <message>
        <source>the whole span</source>
        <translation>l&apos;étendue totale</translation>
    </message>
    <message>
        <source>the number of the source motor</source>
        <translation>le numéro du moteur source</translation>
    </message>
    <message>
        <source>{count} segments over {span}</source>
        <translation>{count} segments sur {span}</translation>
    </message>
    <message>
        <source>1 to {most} segments over more than 0</source>
        <translation>1 à {most} segments sur plus de 0</translation>
    </message>
    <message>
        <source>assignments to {name}</source>
        <translation>des affectations à {name}</translation>
    </message>
    <message>
        <source>a table in motor units</source>
        <translation>une table en unités moteur</translation>
    </message>
    <message>
        <source>there is no number {number}</source>
        <translation>il n&apos;y a pas de numéro {number}</translation>
    </message>
    <message>
        <source>choose one from 0 to {most}</source>
        <translation>en choisir un de 0 à {most}</translation>
    </message>
    <message>
        <source>Sys.CompEnable must be at least {number}, also for other tables</source>
        <translation>Sys.CompEnable doit valoir au moins {number}, aussi pour d&apos;autres tables</translation>
    </message>
    <message>
        <source>the sign of these tables and what Sf, Ctrl and OutCtrl do are assumptions: look at one point on the machine before the table is used</source>
        <translation>le signe de ces tables et l&apos;effet de Sf, Ctrl et OutCtrl sont des hypothèses&#xa0;: vérifier un point sur la machine avant d&apos;utiliser la table</translation>
    </message>
    <message>
        <source>compensation table of one source (CompTable)</source>
        <translation>table de compensation à une source (CompTable)</translation>
    </message>
    <message>
        <source>what the variables are called: letters, digits and _, a letter first</source>
        <translation>le nom des variables&#xa0;: lettres, chiffres et _, une lettre d&apos;abord</translation>
    </message>
    <message>
        <source>a variable of the type {type} in front of the elements</source>
        <translation>une variable du type {type} devant les éléments</translation>
    </message>
    <message>
        <source>TRUE or FALSE</source>
        <translation>TRUE ou FALSE</translation>
    </message>
    <message>
        <source>{value}: what another direction means is not known here</source>
        <translation>{value}&#xa0;: la signification d&apos;un autre sens n&apos;est pas connue ici</translation>
    </message>
    <message>
        <source>a declaration without its end</source>
        <translation>une déclaration sans sa fin</translation>
    </message>
    <message>
        <source>a semicolon behind it</source>
        <translation>un point-virgule à la suite</translation>
    </message>
    <message>
        <source>the last position</source>
        <translation>la dernière position</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>le nombre d&apos;éléments</translation>
    </message>
    <message numerus="yes">
        <source>{count} elements</source>
        <comment>1 element</comment>
        <translation>
            <numerusform>{count} élément</numerusform>
            <numerusform>{count} éléments</numerusform>
        </translation>
    </message>
    <message>
        <source>from {first} to {last}, as MinPosition and MaxPosition say</source>
        <translation>de {first} à {last}, comme MinPosition et MaxPosition l&apos;indiquent</translation>
    </message>
    <message>
        <source>an element of one number</source>
        <translation>un élément d&apos;un seul nombre</translation>
    </message>
    <message>
        <source>a position and a compensation</source>
        <translation>une position et une compensation</translation>
    </message>
    <message>
        <source>a compensation</source>
        <translation>une compensation</translation>
    </message>
    <message>
        <source>the values {first} and {last} at the ends</source>
        <translation>les valeurs {first} et {last} aux extrémités</translation>
    </message>
    <message>
        <source>the same value at both ends, which are one place</source>
        <translation>la même valeur aux deux extrémités, qui sont le même endroit</translation>
    </message>
    <message>
        <source>an array of {type} behind the parameters</source>
        <translation>un tableau de {type} après les paramètres</translation>
    </message>
    <message>
        <source>a variable of the type {type}</source>
        <translation>une variable du type {type}</translation>
    </message>
    <message>
        <source>the setting name is &quot;{value}&quot;, expected letters, digits and _, a letter first</source>
        <translation>le réglage name est «&#xa0;{value}&#xa0;», attendu&#xa0;: lettres, chiffres et _, une lettre d&apos;abord</translation>
    </message>
    <message>
        <source>the manual contradicts itself on whether the correction is added to the nominal or to the actual position: check one point on the machine</source>
        <translation>le manuel se contredit sur le point de savoir si la correction s&apos;ajoute à la position nominale ou à la position réelle&#xa0;: vérifier un point sur la machine</translation>
    </message>
    <message>
        <source>switch Position Correction of the axis on; Ramp limits the speed of the correction</source>
        <translation>activer Position Correction de l&apos;axe&#xa0;; Ramp limite la vitesse de la correction</translation>
    </message>
    <message>
        <source>structured text for MC_TableBasedPositionCompensation</source>
        <translation>texte structuré pour MC_TableBasedPositionCompensation</translation>
    </message>
    <message>
        <source>a prediction needs a measurement of targets</source>
        <translation>une prévision exige une mesure à des positions cibles</translation>
    </message>
    <message>
        <source>a prediction needs a table of one dimension</source>
        <translation>une prévision exige une table à une dimension</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them with accept-large = true for axis {machineAxis} in the machine file</source>
        <translation>{reason} Vérifier l&apos;unité des valeurs&#xa0;; si elles sont justes, les confirmer par accept-large = true pour l&apos;axe {machineAxis} dans le fichier machine</translation>
    </message>
    <message>
        <source>the table is in counts already, and the format {format} would multiply it by the counts per unit once more: set them to 1, or read the source with its own</source>
        <translation>la table est déjà en incréments, et le format {format} la multiplierait encore par les incréments par unité&#xa0;: les régler sur 1 ou lire la source avec les siens</translation>
    </message>
    <message>
        <source>a comma, a bracket or a semicolon behind the value &quot;{value}&quot;</source>
        <translation>une virgule, un crochet ou un point-virgule après la valeur «&#xa0;{value}&#xa0;»</translation>
    </message>
    <message>
        <source>the table is {length} long, but a turn of the axis is {turn}: a prediction needs a table of one turn</source>
        <translation>la table est longue de {length}, mais un tour de l&apos;axe fait {turn}&#xa0;: une prévision exige une table d&apos;un tour</translation>
    </message>
    <message>
        <source>nobody has published the sign of its format. Import it on Write, where you state the sign, export it from there as a calibration file, and choose that</source>
        <translation>personne n&apos;a publié le signe de son format. L&apos;importer sur « Écrire », y indiquer le signe, l&apos;exporter de là comme fichier d&apos;étalonnage et choisir celui-ci</translation>
    </message>
    <message>
        <source>there is no font with the characters of this language to draw a PDF with: install one, such as fonts-noto-cjk, or write the report as HTML</source>
        <translation>aucune police ne contient les caractères de cette langue pour dessiner un PDF&#xa0;: en installer une, par exemple fonts-noto-cjk, ou écrire le rapport en HTML</translation>
    </message>
    <message>
        <source>{file} is no record (.axcal), no machine file (.toml), no TAM configuration (.TAMcfg), and no table or measurement of a known format; a table whose format you can name is opened on the tab Write</source>
        <translation>{file} n&apos;est ni une fiche (.axcal), ni un fichier machine (.toml), ni une configuration TAM (.TAMcfg), ni une table ou une mesure d&apos;un format connu&#xa0;; une table dont le format peut être nommé s&apos;ouvre dans l&apos;onglet Écrire</translation>
    </message>
    <message>
        <source>the drive is only looked at</source>
        <translation>le variateur est seulement lu</translation>
    </message>
    <message>
        <source>you have no permission to use the port, and no group has it</source>
        <translation>droits insuffisants sur le port, qu&apos;aucun groupe ne possède</translation>
    </message>
    <message>
        <source>ask the administrator</source>
        <translation>s&apos;adresser à l&apos;administrateur</translation>
    </message>
    <message>
        <source>you have no permission to use the port, although you are in its group {group}</source>
        <translation>droits insuffisants sur le port, malgré l&apos;appartenance à son groupe {group}</translation>
    </message>
    <message>
        <source>you have no permission to use the port: you are in the group {group}, but this session is older than that</source>
        <translation>droits insuffisants sur le port&#xa0;: l&apos;utilisateur est dans le groupe {group}, mais cette session a été ouverte avant</translation>
    </message>
    <message>
        <source>log out and in again</source>
        <translation>fermer la session et la rouvrir</translation>
    </message>
    <message>
        <source>you have no permission to use the port</source>
        <translation>droits insuffisants sur le port</translation>
    </message>
    <message>
        <source>join the group {group} (sudo usermod -aG {name} $USER) and log in again</source>
        <translation>rejoindre le groupe {group} (sudo usermod -aG {name} $USER) et rouvrir la session</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>ce port n&apos;existe pas</translation>
    </message>
    <message>
        <source>is the cable or the adapter plugged in?</source>
        <translation>le câble ou l&apos;adaptateur est-il branché&#xa0;?</translation>
    </message>
    <message>
        <source>{found}; {wayOut}</source>
        <translation>{found}&#xa0;; {wayOut}</translation>
    </message>
    <message>
        <source>the instrument sends a line of more than {count} characters: check its settings and its speed</source>
        <translation>l&apos;instrument envoie une ligne de plus de {count} caractères&#xa0;: vérifier ses réglages et sa vitesse</translation>
    </message>
    <message>
        <source>number of the reference point, parameter 3620</source>
        <translation>numéro du point de référence, paramètre 3620</translation>
    </message>
    <message>
        <source>interval of the points, parameter 3624, in the unit of the positions</source>
        <translation>intervalle des points, paramètre 3624, dans l&apos;unité des positions</translation>
    </message>
    <message>
        <source>detection unit of the axis, in the unit of the positions, such as 0.001</source>
        <translation>unité de détection de l&apos;axe, dans l&apos;unité des positions, par exemple 0.001</translation>
    </message>
    <message>
        <source>magnification of the values, parameter 3623</source>
        <translation>facteur multiplicateur des valeurs, paramètre 3623</translation>
    </message>
    <message>
        <source>position of the reference point</source>
        <translation>position du point de référence</translation>
    </message>
    <message>
        <source>lowest number of the axis, parameter 3621, instead of the lowest one in the file</source>
        <translation>plus petit numéro de l&apos;axe, paramètre 3621, au lieu du plus petit du fichier</translation>
    </message>
    <message>
        <source>highest number of the axis, parameter 3622, instead of the highest one in the file</source>
        <translation>plus grand numéro de l&apos;axe, paramètre 3622, au lieu du plus grand du fichier</translation>
    </message>
    <message>
        <source>what N of a line is for number 0</source>
        <translation>ce que vaut N d&apos;une ligne pour le numéro 0</translation>
    </message>
    <message>
        <source>largest value that the controller takes for a number</source>
        <translation>plus grande valeur que la commande accepte pour un numéro</translation>
    </message>
    <message>
        <source>stored pitch error data of an axis (N10033P2)</source>
        <translation>données mémorisées d&apos;erreur de pas d&apos;un axe (N10033P2)</translation>
    </message>
    <message>
        <source>a whole number of increments behind P</source>
        <translation>un nombre entier d&apos;incréments après P</translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation>au plus {most}</translation>
    </message>
    <message>
        <source>bit 0 of parameter 3605 is 1: values for each direction of motion</source>
        <translation>le bit 0 du paramètre 3605 est à 1&#xa0;: des valeurs pour chaque sens de déplacement</translation>
    </message>
    <message>
        <source>one value for both directions; leave the line out if it is of another axis</source>
        <translation>une seule valeur pour les deux sens&#xa0;; omettre la ligne si elle concerne un autre axe</translation>
    </message>
    <message>
        <source>line N{number}</source>
        <translation>la ligne N{number}</translation>
    </message>
    <message>
        <source>N{first} to N{last}, as the setting first-record says</source>
        <translation>N{first} à N{last}, comme le réglage first-record l&apos;indique</translation>
    </message>
    <message>
        <source>a line such as {example}</source>
        <translation>une ligne telle que {example}</translation>
    </message>
    <message>
        <source>a line % in front of it</source>
        <translation>une ligne % avant elle</translation>
    </message>
    <message>
        <source>lines without an end</source>
        <translation>des lignes sans fin</translation>
    </message>
    <message>
        <source>a line % behind the last one</source>
        <translation>une ligne % après la dernière</translation>
    </message>
    <message>
        <source>lines such as {example} between two lines %</source>
        <translation>des lignes telles que {example} entre deux lignes %</translation>
    </message>
    <message>
        <source>no line from N{first} to N{last}</source>
        <translation>aucune ligne de N{first} à N{last}</translation>
    </message>
    <message>
        <source>pitch error data; the setting first-record says where their numbers begin</source>
        <translation>des données d&apos;erreur de pas&#xa0;; le réglage first-record indique où commencent leurs numéros</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} for the axis</source>
        <translation>les numéros {first} à {last} pour l&apos;axe</translation>
    </message>
    <message>
        <source>numbers round that of the reference point, {number}, as the setting {key} says</source>
        <translation>des numéros de part et d&apos;autre de celui du point de référence, {number}, comme le réglage {key} l&apos;indique</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} of one turn</source>
        <translation>les numéros {first} à {last} d&apos;un tour</translation>
    </message>
    <message>
        <source>each number from {first} to {last}; first-number and last-number choose those of one axis</source>
        <translation>chaque numéro de {first} à {last}&#xa0;; first-number et last-number choisissent ceux d&apos;un axe</translation>
    </message>
    <message>
        <source>at most {most} of an axis, as one source says</source>
        <translation>au plus {most} par axe, selon une source</translation>
    </message>
    <message>
        <source>the values {first} to {last}, which add up to {sum}</source>
        <translation>les valeurs {first} à {last}, dont la somme est {sum}</translation>
    </message>
    <message>
        <source>0 over one turn</source>
        <translation>0 sur un tour</translation>
    </message>
    <message>
        <source>value {number}, of the reference point</source>
        <translation>la valeur {number}, celle du point de référence</translation>
    </message>
    <message>
        <source>the same as value {number}, which is the same section</source>
        <translation>la même que la valeur {number}, qui est celle du même segment</translation>
    </message>
    <message>
        <source>the setting wrap-range is {turn}, expected 1 to {most} times the interval of {interval}</source>
        <translation>le réglage wrap-range est {turn}, attendu&#xa0;: 1 à {most} fois l&apos;intervalle de {interval}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected {least} to {most}</source>
        <translation>le réglage {key} du format {format} est {value}, attendu&#xa0;: {least} à {most}</translation>
    </message>
    <message>
        <source>wrap-range says which numbers a rotary axis has; leave {key} and {key2} out</source>
        <translation>wrap-range indique quels numéros a un axe rotatif&#xa0;; omettre {key} et {key2}</translation>
    </message>
    <message>
        <source>the reference position {position} is no point of it; its points are from {first} to {last}, {distance} apart</source>
        <translation>la position de référence {position} n&apos;est pas un de ses points&#xa0;; ils vont de {first} à {last}, espacés de {distance}</translation>
    </message>
    <message>
        <source>resample it with a point there, or check reference-position</source>
        <translation>la rééchantillonner avec un point à cet endroit ou vérifier reference-position</translation>
    </message>
    <message>
        <source>its points would get the numbers {first} to {last}</source>
        <translation>ses points recevraient les numéros {first} à {last}</translation>
    </message>
    <message>
        <source>choose a reference-number so that they are from 0 to {most}</source>
        <translation>choisir reference-number de sorte qu&apos;ils aillent de 0 à {most}</translation>
    </message>
    <message>
        <source>the value {value} is too large</source>
        <translation>la valeur {value} est trop grande</translation>
    </message>
    <message>
        <source>check detection-unit and the unit of the values</source>
        <translation>vérifier detection-unit et l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>its value at the reference position is {value}, and the controller takes it to be 0 there</source>
        <translation>sa valeur à la position de référence est {value}, et la commande y suppose 0</translation>
    </message>
    <message>
        <source>from {first} to {last} it changes by {count} increments of {increment}, and a value is at most {most}</source>
        <translation>de {first} à {last} elle change de {count} incréments de {increment}, et une valeur vaut au plus {most}</translation>
    </message>
    <message>
        <source>set magnification={number}, the smallest that fits, or largest-step if the controller takes more</source>
        <translation>régler magnification={number}, le plus petit qui convient, ou largest-step si la commande accepte davantage</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}</source>
        <translation>régler les paramètres de l&apos;axe&#xa0;: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}</source>
        <translation>régler les paramètres de l&apos;axe&#xa0;: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}</translation>
    </message>
    <message>
        <source>these are {count} points, and one source says that an axis has at most {most}</source>
        <translation>ce sont {count} points, et une source indique qu&apos;un axe en a au plus {most}</translation>
    </message>
    <message>
        <source>the sign is an assumption: a value is put out to the axis as pulses. Check one point on the machine</source>
        <translation>le signe est une hypothèse&#xa0;: une valeur est émise vers l&apos;axe sous forme d&apos;impulsions. Vérifier un point sur la machine</translation>
    </message>
    <message>
        <source>where within its section a value is put out is not known: the correction is taken to be linear, and its place is in doubt by half an interval</source>
        <translation>l&apos;endroit du segment où une valeur est émise n&apos;est pas connu&#xa0;: la correction est supposée linéaire, et son emplacement est incertain d&apos;un demi-intervalle</translation>
    </message>
    <message>
        <source>after loading switch the power off and on and return to the reference point; alarm PW1102 says that the numbers do not fit</source>
        <translation>après le chargement, couper et remettre l&apos;alimentation et revenir au point de référence&#xa0;; l&apos;alarme PW1102 indique que les numéros ne conviennent pas</translation>
    </message>
    <message>
        <source>parameter {number}, which is {value} for no axis</source>
        <translation>le paramètre {number}, qui ne vaut {value} pour aucun axe</translation>
    </message>
    <message>
        <source>the reference point, numbers and magnification of one axis, as the settings say</source>
        <translation>le point de référence, les numéros et le grossissement d&apos;un axe, selon les réglages</translation>
    </message>
    <message>
        <source>parameters 3620 to 3623 of several axes, and numbers {first} to {last}</source>
        <translation>les paramètres 3620 à 3623 de plusieurs axes, et les numéros {first} à {last}</translation>
    </message>
    <message>
        <source>the numbers of one axis; first-number and last-number choose them</source>
        <translation>les numéros d&apos;un axe&#xa0;; first-number et last-number les choisissent</translation>
    </message>
    <message>
        <source>shift all values so that it is 0 there; convert does that with --zero</source>
        <translation>décaler toutes les valeurs pour qu&apos;elle y soit nulle&#xa0;; convert le fait avec --zero</translation>
    </message>
    <message>
        <source>{number} to command, to reach {number2}</source>
        <translation>{number} à commander pour atteindre {number2}</translation>
    </message>
    <message>
        <source>at most half a range away; a list of corrections is no such file</source>
        <translation>un écart d&apos;au plus un demi-intervalle&#xa0;; une liste de corrections n&apos;est pas un tel fichier</translation>
    </message>
    <message>
        <source>a comment without an end</source>
        <translation>un commentaire sans fin</translation>
    </message>
    <message>
        <source>{sign} behind it</source>
        <translation>{sign} à sa suite</translation>
    </message>
    <message>
        <source>one position and one compensation in each pair of brackets</source>
        <translation>une position et une compensation dans chaque paire de parenthèses</translation>
    </message>
    <message>
        <source>the values for {column} have no unit; they are taken to be in {unit}, as the positions are</source>
        <translation>les valeurs pour {column} n&apos;ont pas d&apos;unité&#xa0;; l&apos;unité retenue est {unit}, celle des positions</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to have no unit; state it in the header, as X [mm], or as the setting {key} of the file that is read</source>
        <translation>les valeurs pour {column} sont en {unit}, et les positions auxquelles elles s&apos;ajoutent n&apos;ont pas d&apos;unité&#xa0;; l&apos;indiquer dans l&apos;en-tête, comme X [mm], ou par le réglage {key} du fichier lu</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {before}, as its positions are, and converted to {after}. The largest correction is {largest}.</source>
        <translation>La table n&apos;indique pas l&apos;unité de ses valeurs&#xa0;; l&apos;unité retenue est {before}, celle de ses positions, convertie en {after}. La plus grande correction est {largest}.</translation>
    </message>
    <message>
        <source>{name} has several tables of axis {axis}; which of them was active has to be said by its CRC, in the file of the measurement (// compensation: crc:{crc})</source>
        <translation>{name} a plusieurs tables de l&apos;axe {axis}&#xa0;; le CRC de celle qui était active doit figurer dans le fichier de la mesure (// compensation: crc:{crc})</translation>
    </message>
    <message>
        <source>{name} has several tables, none of which says its axis, so that it is not known which of them is meant: take a file with that table alone</source>
        <translation>{name} a plusieurs tables dont aucune n&apos;indique son axe, si bien que l&apos;on ne sait pas laquelle est visée&#xa0;: prendre un fichier qui ne contient que cette table</translation>
    </message>
    <message>
        <source>{name} has several tables, and which of them is meant is not known: state the axis as it is called there (--target, or // axis: in the file of the measurement; there are: {axes}), or take a file with that table alone</source>
        <translation>{name} a plusieurs tables, et l&apos;on ne sait pas laquelle est visée&#xa0;: indiquer l&apos;axe sous le nom qu&apos;il y porte (--target, ou // axis: dans le fichier de la mesure&#xa0;; il y a&#xa0;: {axes}), ou prendre un fichier qui ne contient que cette table</translation>
    </message>
    <message>
        <source>the targets go from {from} to {to}, which is more than a turn of {turn}: give the length of the whole turn (--turn), or leave out what lies in a second one (--exclude)</source>
        <translation>les positions cibles vont de {from} à {to}, soit plus d&apos;un tour de {turn}&#xa0;: indiquer la longueur du tour entier (--turn), ou laisser de côté ce qui se trouve dans un second tour (--exclude)</translation>
    </message>
    <message>
        <source>positions with a decimal point and blanks between them; without a Target-count nobody can tell two positions from one with a decimal comma</source>
        <translation>des positions avec un point décimal, séparées par des espaces&#xa0;; sans Target-count, rien ne distingue deux positions d&apos;une seule avec une virgule décimale</translation>
    </message>
    <message>
        <source>{found} targets, but deviations of {used}</source>
        <translation>{found} positions cibles, mais des écarts pour {used}</translation>
    </message>
    <message>
        <source>a deviation of every target, or a Target-count</source>
        <translation>un écart pour chaque position cible, ou un Target-count</translation>
    </message>
    <message>
        <source>positions of targets that rise or fall throughout, with a decimal point and blanks between them</source>
        <translation>des positions cibles qui croissent ou décroissent d&apos;un bout à l&apos;autre, avec un point décimal et séparées par des espaces</translation>
    </message>
    <message>
        <source>every run goes {direction}, in a file of both directions (Flags: 0 0 2 0)</source>
        <translation>chaque passe va {direction}, dans un fichier des deux sens (Flags: 0 0 2 0)</translation>
    </message>
    <message>
        <source>the lines of each run in the order in which they were measured; sorted by target they all seem to rise</source>
        <translation>les lignes de chaque passe dans l&apos;ordre où elles ont été mesurées&#xa0;; triées par position cible, toutes semblent croître</translation>
    </message>
    <message>
        <source>the file does not say whether its values are corrected to 20 deg C already; if they are not, that has to be stated (--not-corrected)</source>
        <translation>le fichier n&apos;indique pas si ses valeurs sont déjà corrigées à 20 °C&#xa0;; si elles ne le sont pas, il faut l&apos;indiquer (--not-corrected)</translation>
    </message>
    <message>
        <source>file {second} holds the same measurement as file {first}, value by value: give it once</source>
        <translation>le fichier {second} contient la même mesure que le fichier {first}, valeur par valeur&#xa0;: ne la donner qu&apos;une fois</translation>
    </message>
    <message>
        <source>some of the files say otherwise than the others, or do not say, whether their values are corrected to 20 deg C, so that no correction would be right for all; say it in each of them (// corrected: 20C, or // corrected: none), or take those alone that agree</source>
        <translation>les fichiers n&apos;indiquent pas tous, ou pas de la même façon, si leurs valeurs sont corrigées à 20 °C, si bien qu&apos;aucune correction ne conviendrait à tous&#xa0;; l&apos;indiquer dans chacun (// corrected: 20C, ou // corrected: none), ou ne prendre que ceux qui concordent</translation>
    </message>
    <message>
        <source>the drive is taken to look the table up before the compensation, at the position of the encoder; at the set position (lookup: set) its corrections would differ by up to {largest}</source>
        <translation>il est admis que le variateur consulte la table avant compensation, à la position du codeur&#xa0;; à la position de consigne (lookup: set), ses corrections différeraient de {largest} au plus</translation>
    </message>
    <message>
        <source>where a table is looked up (--lookup-at) is said of a table of the drive, and neither {from} nor {to} is one</source>
        <translation>la position de consultation (--lookup-at) se dit d&apos;une table du variateur, et ni {from} ni {to} n&apos;en est une</translation>
    </message>
    <message>
        <source>the file does not say where the drive looks its table up: in a calibration file add the line // lookup: encoder or // lookup: set</source>
        <translation>le fichier ne dit pas où le variateur consulte sa table&#xa0;: dans un fichier d&apos;étalonnage, ajouter la ligne // lookup: encoder ou // lookup: set</translation>
    </message>
    <message>
        <source>the table is made for a drive that looks it up after the compensation, at the set position (lookup: set)</source>
        <translation>la table est faite pour un variateur qui la consulte après compensation, à la position de consigne (lookup: set)</translation>
    </message>
    <message>
        <source>the values are converted from those that the drive looks up after the compensation, at the set position (lookup: set)</source>
        <translation>les valeurs sont converties depuis celles que le variateur consulte après compensation, à la position de consigne (lookup: set)</translation>
    </message>
    <message>
        <source>the file of the table says lookup: {file}, and stated is {stated} (--lookup-at): correct the one that is wrong</source>
        <translation>le fichier de la table dit lookup: {file}, et {stated} est indiqué (--lookup-at)&#xa0;: corriger celui qui est faux</translation>
    </message>
    <message>
        <source>while {name} was active the sources of the axis were others, so that its values may belong to other positions: measure again with what the axis has now</source>
        <translation>pendant que {name} était active, l&apos;axe avait d&apos;autres sources, si bien que ses valeurs peuvent appartenir à d&apos;autres positions&#xa0;: mesurer à nouveau avec ce que l&apos;axe a maintenant</translation>
    </message>
    <message>
        <source>The table stays, and its new source is on the other side of the compensation: its values belong to other positions. Write the table that was made for this source.</source>
        <translation>La table reste, et sa nouvelle source est de l&apos;autre côté de la compensation&#xa0;: ses valeurs appartiennent à d&apos;autres positions. Écrivez la table qui a été faite pour cette source.</translation>
    </message>
    <message>
        <source>the plan is in {planned}, and axis {axis} of the drive in {unit}: make a plan in {needed}, or choose another axis</source>
        <translation>le plan est en {planned}, et l&apos;axe {axis} du variateur en {unit}&#xa0;: établir un plan en {needed} ou choisir un autre axe</translation>
    </message>
    <message>
        <source>The table that no axis used in {slot} is not restored: the table of this axis is there.</source>
        <translation>La table de {slot} qu&apos;aucun axe n&apos;utilisait n&apos;est pas restaurée&#xa0;: la table de cet axe s&apos;y trouve.</translation>
    </message>
    <message>
        <source>the values for {column} are said to be in the unit of the drive, and the positions that they are added to are in {unit}; state the unit of the values, or that the positions are in that of the drive, too</source>
        <translation>les valeurs pour {column} sont déclarées dans l&apos;unité du variateur, et les positions auxquelles elles s&apos;ajoutent sont en {unit}&#xa0;; indiquer l&apos;unité des valeurs, ou que les positions sont aussi dans celle du variateur</translation>
    </message>
    <message>
        <source>{name} = {value}, which multiplies the table on the control</source>
        <translation>{name} = {value}, par quoi la commande multiplie la table</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply the values by the number (--scale)</source>
        <translation>1&#xa0;; supprimer la ligne et multiplier les valeurs par ce nombre (--scale)</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, which cannot be given in {other}, the unit of the positions that they are added to; correct the units</source>
        <translation>les valeurs pour {column} sont en {unit}, ce qui ne peut pas être converti en {other}, l&apos;unité des positions auxquelles elles s&apos;ajoutent&#xa0;; corriger les unités</translation>
    </message>
    <message>
        <source>{name} does not say the unit of its numbers, and its CRC-32 {crc} is the same in mm and in m, in degrees and in radians: take a calibration file in whose header the units stand, such as the one that reading the table from the drive writes</source>
        <translation>{name} ne dit pas l&apos;unité de ses nombres, et son CRC-32 {crc} est le même en mm et en m, en degrés et en radians&#xa0;: prendre un fichier d&apos;étalonnage dont l&apos;en-tête porte les unités, comme celui qu&apos;écrit la lecture de la table dans le variateur</translation>
    </message>
    <message>
        <source>the axis had other sources with {name}, so that its values may belong to other positions: merge onto nothing (leave out --onto), since with the raw positions on file the values are the whole error</source>
        <translation>avec {name}, l&apos;axe avait d&apos;autres sources, si bien que ses valeurs peuvent appartenir à d&apos;autres positions&#xa0;: ne fusionner avec rien (omettre --onto), car avec les positions brutes dans le fichier les valeurs sont l&apos;erreur entière</translation>
    </message>
    <message>
        <source>a gain is for residuals that are merged onto a table (--onto); here the values are the whole error</source>
        <translation>un gain s&apos;applique à des écarts résiduels fusionnés avec une table (--onto)&#xa0;; ici, les valeurs sont l&apos;erreur entière</translation>
    </message>
    <message>
        <source>{name} is a table over {axes}, but what was measured is over {measured}: take a table over the same axes, in the same order</source>
        <translation>{name} est une table sur {axes}, mais la mesure porte sur {measured}&#xa0;: prendre une table sur les mêmes axes, dans le même ordre</translation>
    </message>
    <message>
        <source>what was measured along one axis needs a table of one dimension; {name} has {dimensions}</source>
        <translation>ce qui a été mesuré suivant un axe demande une table à une dimension&#xa0;; {name} en a {dimensions}</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} is of axis {axis}: take the table of the axis that was measured</source>
        <translation>l&apos;axe {measured} a été mesuré, mais {name} est de l&apos;axe {axis}&#xa0;: prendre la table de l&apos;axe mesuré</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} corrects an axis that is no source: take the table of the axis that was measured, or state what the values correct (--target other)</source>
        <translation>l&apos;axe {measured} a été mesuré, mais {name} corrige un axe qui n&apos;est pas une source&#xa0;: prendre la table de l&apos;axe mesuré, ou indiquer ce que les valeurs corrigent (--target other)</translation>
    </message>
    <message>
        <source>nothing is merged over temperature: leave out --onto, since with the raw positions on file the values are the whole error</source>
        <translation>rien ne se fusionne selon la température&#xa0;: omettre --onto, car avec les positions brutes dans le fichier les valeurs sont l&apos;erreur entière</translation>
    </message>
    <message>
        <source>a unit that is not stated</source>
        <translation>unité non indiquée</translation>
    </message>
    <message>
        <source>a time in s, ms, min or h, in brackets behind the name; without a unit it is in s</source>
        <translation>un temps en s, ms, min ou h, entre crochets après le nom&#xa0;; sans unité, il est en s</translation>
    </message>
    <message>
        <source>a temperature in C, K or F, in brackets behind the name; without a unit it is in C</source>
        <translation>une température en C, K ou F, entre crochets après le nom&#xa0;; sans unité, elle est en C</translation>
    </message>
    <message>
        <source>an angle as the first axis has</source>
        <translation>un angle, comme pour le premier axe</translation>
    </message>
    <message>
        <source>a length as the first axis has</source>
        <translation>une longueur, comme pour le premier axe</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>positions de la référence</translation>
    </message>
    <message>
        <source>deviations</source>
        <translation>écarts</translation>
    </message>
    <message>
        <source>what --values says; leave it out, since the file says it</source>
        <translation>ce que dit --values&#xa0;; omettez-le, puisque le fichier le dit</translation>
    </message>
    <message>
        <source>positions of the reference for --invert-reference; deviations with the opposite sign say it in the file (// sign: correction)</source>
        <translation>des positions de la référence pour --invert-reference&#xa0;; des écarts de signe opposé l&apos;indiquent dans le fichier (// sign: correction)</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the position</source>
        <translation>des valeurs qui croissent de {slope} avec la position</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for all of these changes, {together}, but not for putting everything back if one fails; wait {seconds} s, or make fewer changes at a time</source>
        <translation>les opérations flash restantes suffiraient à toutes ces modifications, {together}, mais pas à tout remettre en état en cas d&apos;échec de l&apos;une d&apos;elles&#xa0;; attendre {seconds} s ou faire moins de modifications à la fois</translation>
    </message>
    <message>
        <source>together these changes cost {together} flash operations, more than are possible now; wait {seconds} s, or make fewer changes at a time</source>
        <translation>ces modifications coûtent ensemble {together} opérations flash, plus qu&apos;il n&apos;est possible maintenant&#xa0;; attendre {seconds} s ou faire moins de modifications à la fois</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or, if it is right all the same, name the column after axis {axis} in the file</source>
        <translation>{doubt} Choisir une autre source ou colonne ou, si c&apos;est juste malgré tout, donner à la colonne le nom de l&apos;axe {axis} dans le fichier</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the backup was made, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>l&apos;axe {axis} était {target} lors de la sauvegarde, et c&apos;est maintenant {name} sur le variateur&#xa0;; redonner aux axes l&apos;ordre ou les noms qu&apos;ils avaient, ou écrire la table depuis son fichier</translation>
    </message>
    <message>
        <source>the {what} of the table on the drive are in {unit}, and the new source is in {other}; write the table from its file, together with the source</source>
        <translation>les {what} de la table du variateur sont en {unit}, et la nouvelle source est en {other}&#xa0;; écrire la table depuis son fichier, avec la source</translation>
    </message>
    <message>
        <source>the {what} are in {unit} in the backup, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>les {what} sont en {unit} dans la sauvegarde, et le variateur les a maintenant en {other}&#xa0;: les mêmes nombres auraient un autre sens&#xa0;; remettre l&apos;unité du variateur à {unit} ou écrire la table depuis son fichier</translation>
    </message>
    <message>
        <source>The table states no unit for the positions of dimension {number}; they are taken to be in {after}: {first} to {last}.</source>
        <translation>La table n&apos;indique pas d&apos;unité pour les positions de la dimension {number}&#xa0;; elles sont supposées être en {after}&#xa0;: {first} à {last}.</translation>
    </message>
    <message>
        <source>values of axis {axis}</source>
        <translation>valeurs de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>positions of dimension {number} of axis {axis}</source>
        <translation>positions de la dimension {number} de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>Axis {axis} was called {before} when the backup was made, and is called {after} now: see that it is the same axis.</source>
        <translation>L&apos;axe {axis} s&apos;appelait {before} lors de la sauvegarde et s&apos;appelle maintenant {after}&#xa0;: vérifier que c&apos;est le même axe.</translation>
    </message>
    <message>
        <source>The backup does not say in which unit axis {axis} was; its table is taken to be in {unit}.</source>
        <translation>La sauvegarde n&apos;indique pas l&apos;unité de l&apos;axe {axis}&#xa0;; sa table est supposée être en {unit}.</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are written in {unit} as they stand: the profile does not say the unit of {source}.</source>
        <translation>Les positions de la dimension {number} sont écrites telles quelles en {unit}&#xa0;: le profil n&apos;indique pas l&apos;unité de {source}.</translation>
    </message>
    <message>
        <source>axis {axis}, which is written first</source>
        <translation>axe {axis}, qui est écrit avant</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the numbers of the file were read in {unit}; leave the statement out</source>
        <translation>l&apos;unité {stated} est indiquée, et les nombres du fichier ont été lus en {unit}&#xa0;; omettre cette indication</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: it is not activated. Finish that write with &apos;axiscomp recover --finish&apos;, undo it with &apos;axiscomp recover --undo&apos;, or write again. The old state is kept in {backup}</source>
        <translation>une écriture interrompue a laissé l&apos;axe {axis} ni dans son ancien ni dans son nouvel état&#xa0;: il n&apos;est pas activé. Achever cette écriture avec &apos;axiscomp recover --finish&apos;, l&apos;annuler avec &apos;axiscomp recover --undo&apos;, ou écrire à nouveau. L&apos;ancien état est conservé dans {backup}</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as http://user:password@host</source>
        <translation>{endpoint} demande un nom d&apos;utilisateur et un mot de passe&#xa0;; les indiquer sous la forme http://utilisateur:motdepasse@hôte</translation>
    </message>
    <message>
        <source>{text} has no unit and is taken as {amount}, {fine}</source>
        <translation>{text} n&apos;a pas d&apos;unité&#xa0;; pris pour {amount}, soit {fine}</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as https://user:password@host</source>
        <translation>{endpoint} demande un nom d&apos;utilisateur et un mot de passe&#xa0;; les indiquer sous la forme https://utilisateur:motdepasse@hôte</translation>
    </message>
    <message>
        <source>{path} is no position of axis {axis} before its compensation: name the register of its encoder</source>
        <translation>{path} n’est pas une position de l’axe {axis} avant sa compensation&#xa0;: indiquer le registre de son codeur</translation>
    </message>
    <message>
        <source>&quot;{name}&quot;, which is taken to be a name without a unit</source>
        <translation>« {name} », pris pour un nom sans unité</translation>
    </message>
    <message>
        <source>a unit such as mm, um, inch, deg or arcsec, if {unit} is meant as one</source>
        <translation>une unité comme mm, um, inch, deg ou arcsec, si {unit} doit en être une</translation>
    </message>
    <message>
        <source>decimal points, and blanks between the numbers; nobody can tell a decimal comma from one that separates two numbers</source>
        <translation>des points décimaux et des espaces entre les nombres&#xa0;; rien ne distingue une virgule décimale d&apos;une virgule entre deux nombres</translation>
    </message>
    <message>
        <source>{key} without a value, or no {key}</source>
        <translation>{key} sans valeur, ou pas de {key}</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>un nombre avec un point décimal</translation>
    </message>
    <message>
        <source>several tables of {axes}</source>
        <translation>plusieurs tables de {axes}</translation>
    </message>
    <message>
        <source>their sum, since the controller adds them; a table that is converted alone is a part of it</source>
        <translation>leur somme, puisque la commande les additionne&#xa0;; une table convertie seule n&apos;en est qu&apos;une partie</translation>
    </message>
    <message>
        <source>&quot;{statement}&quot;, which switches a table of the file off</source>
        <translation>« {statement} », qui désactive une table du fichier</translation>
    </message>
    <message>
        <source>tables that are in use; this one does not act on the machine</source>
        <translation>des tables en service&#xa0;; celle-ci n&apos;agit pas sur la machine</translation>
    </message>
    <message>
        <source>one unit for positions and offsets, which the controller adds; a calibration file is read with --from {format}</source>
        <translation>une seule unité pour les positions et les décalages, que la commande additionne&#xa0;; un fichier d&apos;étalonnage se lit avec --from {format}</translation>
    </message>
    <message>
        <source>{count} lines that are taken to be headers, the first of them &quot;{line}&quot;</source>
        <translation>{count} lignes, prises pour des en-têtes, dont la première est « {line} »</translation>
    </message>
    <message>
        <source>decimal points, and a comma with a blank between the values; nobody can tell a decimal comma from one that separates two values</source>
        <translation>des points décimaux, et une virgule suivie d&apos;une espace entre les valeurs&#xa0;; rien ne distingue une virgule décimale d&apos;une virgule entre deux valeurs</translation>
    </message>
    <message>
        <source>numbers in {unit}, as the file says</source>
        <translation>des nombres en {unit}, selon le fichier</translation>
    </message>
    <message>
        <source>{unit}, as the setting says</source>
        <translation>{unit}, selon le réglage</translation>
    </message>
    <message>
        <source>{name}, which is changed by a statement of the program</source>
        <translation>{name}, modifié par une instruction du programme</translation>
    </message>
    <message>
        <source>the declaration alone; the table is that of the declaration, since statements are not computed</source>
        <translation>la déclaration seule&#xa0;; la table est celle de la déclaration, les instructions ne sont pas calculées</translation>
    </message>
    <message>
        <source>axis {axis}, and axis {before} in line {line}</source>
        <translation>axe {axis}, et axe {before} à la ligne {line}</translation>
    </message>
    <message>
        <source>the measurement of one axis; make a file for each axis</source>
        <translation>la mesure d&apos;un seul axe&#xa0;; faire un fichier par axe</translation>
    </message>
    <message>
        <source>{second}, and {first} in line {line}</source>
        <translation>{second}, et {first} à la ligne {line}</translation>
    </message>
    <message>
        <source>one statement of it</source>
        <translation>une seule indication à ce sujet</translation>
    </message>
    <message>
        <source>this statement before the header, since it holds for every line</source>
        <translation>cette indication avant l&apos;en-tête, puisqu&apos;elle vaut pour toutes les lignes</translation>
    </message>
    <message>
        <source>further sections behind EOF::</source>
        <translation>d&apos;autres sections derrière EOF::</translation>
    </message>
    <message>
        <source>one measurement in a file; make a file of each</source>
        <translation>une seule mesure par fichier&#xa0;; faire un fichier de chacune</translation>
    </message>
    <message>
        <source>which it is: // values: deviation or // values: reference before the header, or --values</source>
        <translation>ce dont il s&apos;agit&#xa0;: // values: deviation ou // values: reference avant l&apos;en-tête, ou --values</translation>
    </message>
    <message>
        <source>axis {axis} of the machine file</source>
        <translation>axe {axis} du fichier machine</translation>
    </message>
    <message>
        <source>a position and an error in mm, with decimal points and without separators of thousands</source>
        <translation>une position et un écart en mm, avec des points décimaux et sans séparateurs de milliers</translation>
    </message>
    <message>
        <source>a position without a forward mean</source>
        <translation>une position sans moyenne en sens aller</translation>
    </message>
    <message>
        <source>for a run its direction and number, such as up2 or down1</source>
        <translation>pour une passe, son sens et son numéro, par exemple up2 ou down1</translation>
    </message>
    <message>
        <source>sign: feedback or sign: command; where the values are encoder minus reference, leave the line out, and turn them with --scale -1</source>
        <translation>sign: feedback ou sign: command&#xa0;; si les valeurs sont codeur moins référence, supprimer la ligne et les inverser avec --scale -1</translation>
    </message>
    <message>
        <source>the table states no unit for its values, and its positions are in {positions}; state the unit of the values, in the file or with --value-unit</source>
        <translation>la table n&apos;indique pas d&apos;unité pour ses valeurs, et ses positions sont en {positions}&#xa0;; indiquer l&apos;unité des valeurs, dans le fichier ou par --value-unit</translation>
    </message>
    <message>
        <source>the values for {column} have no unit, and the positions are in {positions}; state it in the header, as Z [mm], or as the setting {key} of the file that is read</source>
        <translation>les valeurs pour {column} n&apos;ont pas d&apos;unité, et les positions sont en {positions}&#xa0;; l&apos;indiquer dans l&apos;en-tête, comme Z [mm], ou par le réglage {key} du fichier lu</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. The positions have different units, and it is not stated which one that is: convert to a .csv file first, and that one with --value-unit, such as --value-unit mm, or, if the values correct the axis of one of the positions, state the target, such as #1 for the first</source>
        <translation>un .TAMtbl n&apos;a pas d&apos;unités, et un variateur prend ses valeurs dans l&apos;unité de l&apos;axe qu&apos;elles corrigent. Les positions ont des unités différentes, et il n&apos;est pas indiqué laquelle&#xa0;: convertir d&apos;abord en un fichier .csv, puis celui-ci avec --value-unit, comme --value-unit mm, ou, si les valeurs corrigent l&apos;axe d&apos;une des positions, indiquer l&apos;axe cible, comme #1 pour la première</translation>
    </message>
    <message>
        <source>{number} in a column with {whole}</source>
        <translation>{number} dans une colonne avec {whole}</translation>
    </message>
    <message>
        <source>numbers that show whether the point stands between thousands: no point in {number}, or the same decimals in {whole}</source>
        <translation>des nombres qui montrent si le point sépare les milliers&#xa0;: {number} sans point, ou les mêmes décimales dans {whole}</translation>
    </message>
    <message>
        <source>the axis is taken to count from {from} to {to}, and steps of {distance} do not lead from one end over the targets to the other; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>l&apos;axe est supposé compter de {from} à {to}, et des pas de {distance} ne mènent pas d&apos;une extrémité à l&apos;autre en passant par les positions cibles&#xa0;; indiquez la grille de la table&#xa0;: ses points, leur distance ou l&apos;écart permis à la courbe (--points, --distance ou --within)</translation>
    </message>
    <message>
        <source>the table in {slot} stays in flash, because {user} uses it too; free it there first, with a persistent write into another slot</source>
        <translation>la table dans {slot} reste dans la mémoire flash, car elle est aussi utilisée ailleurs ({user})&#xa0;; l&apos;en détacher d&apos;abord, par une écriture persistante dans un autre emplacement</translation>
    </message>
    <message>
        <source>Flash keeps the table in {slot}: after a reboot {axis} uses it again. Delete the table first (&apos;axiscomp delete&apos;) if it must not come back.</source>
        <translation>La table dans {slot} reste dans la mémoire flash&#xa0;: après un redémarrage, {axis} l&apos;utilise de nouveau. Si elle ne doit pas revenir, supprimer d&apos;abord la table (&apos;axiscomp delete&apos;).</translation>
    </message>
    <message>
        <source>the axis has the values of the record&apos;s table, {crc}, over other positions: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>l&apos;axe a les valeurs de la table de la fiche, {crc}, sur d&apos;autres positions&#xa0;: écrire de nouveau la table de la fiche («&#xa0;axiscomp write --record&#xa0;») ou omettre la fiche</translation>
    </message>
    <message>
        <source>The table stays, and {source} is a position of another axis: its values belong to positions of the axis itself. Write the table that was made for this source.</source>
        <translation>La table reste, et {source} est une position d&apos;un autre axe&#xa0;: ses valeurs appartiennent à des positions de l&apos;axe lui-même. Écrivez la table qui a été faite pour cette source.</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, and {first} and {second} have the same values over other positions: merge onto the file of the one that was active (--onto)</source>
        <translation>mesuré avec la table {crc} active, et {first} et {second} ont les mêmes valeurs sur des positions différentes&#xa0;: fusionner avec le fichier de celle qui était active (--onto)</translation>
    </message>
    <message>
        <source>{axis} is the name of axis {named} and the index of axis {numbered}; say name:{axis} or {index}</source>
        <translation>{axis} est le nom de l&apos;axe {named} et l&apos;indice de l&apos;axe {numbered}&#xa0;; indiquer name:{axis} ou {index}</translation>
    </message>
    <message>
        <source>there is no name on the drive</source>
        <translation>il n&apos;y a pas de nom sur le variateur</translation>
    </message>
    <message>
        <source>the program must define the target axes of the table in the order of the corrections: {axes}</source>
        <translation>le programme doit définir les axes cibles de la table dans l&apos;ordre des corrections&#xa0;: {axes}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} says {value}, and the table goes from {column}</source>
        <translation>le réglage {key} du format {format} indique {value}, et la table va de {column}</translation>
    </message>
    <message>
        <source>positions with {all} combinations in the first {count} data lines</source>
        <translation>des positions avec {all} combinaisons dans les {count} premières lignes de données</translation>
    </message>
    <message>
        <source>a line for every combination of the positions; fit makes a table of scattered points</source>
        <translation>une ligne pour chaque combinaison des positions&#xa0;; fit fait une table de points dispersés</translation>
    </message>
    <message>
        <source>the first measurement is corrected and the second is not, so that they cannot be compared: save the record and correct the second one with `axiscomp compare --record`, or state in its file that its values are at 20 °C (// corrected: 20C)</source>
        <translation>la première mesure est corrigée et la seconde ne l&apos;est pas, elles ne peuvent donc pas être comparées&#xa0;: enregistrez la fiche et corrigez la seconde avec « axiscomp compare --record », ou indiquez dans son fichier que ses valeurs sont à 20 °C (// corrected: 20C)</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; can be read in two ways; write thousands without a sign between them</source>
        <translation>« {text} » peut se lire de deux façons&#xa0;; écrire les milliers sans séparateur</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. These are in {unit} and the positions in {positions}, none of which is that of the axis for certain: convert to a .csv file first, and that one with --value-unit and the unit of the axis, such as --value-unit {example}</source>
        <translation>un fichier .TAMtbl n&apos;a pas d&apos;unités, et un variateur prend ses valeurs dans l&apos;unité de l&apos;axe qu&apos;elles corrigent. Celles-ci sont en {unit} et les positions en {positions}, dont aucune n&apos;est à coup sûr l&apos;unité de l&apos;axe&#xa0;: convertir d&apos;abord en fichier .csv, puis celui-ci avec --value-unit et l&apos;unité de l&apos;axe, par exemple --value-unit {example}</translation>
    </message>
    <message>
        <source>sign: correction, and positions of the reference</source>
        <translation>sign: correction, et des positions de la référence</translation>
    </message>
    <message>
        <source>no sign with positions of the reference, which are what they are; or deviations with their sign</source>
        <translation>pas de signe avec des positions de la référence, qui sont ce qu&apos;elles sont&#xa0;; ou des écarts avec leur signe</translation>
    </message>
    <message>
        <source>the two directions of the track have no part of the way in common: make the table of one of them (--direction positive or negative)</source>
        <translation>les deux sens du relevé continu n&apos;ont aucune partie du trajet en commun&#xa0;: faire la table de l&apos;un d&apos;eux (--direction positive ou negative)</translation>
    </message>
    <message>
        <source>the table is looked up at the desired position of its sources (D); with position=actual at the actual one</source>
        <translation>la table est lue à la position de consigne de ses axes sources (D)&#xa0;; avec position=actual, à leur position réelle</translation>
    </message>
    <message>
        <source>the table is looked up at the actual position of its sources; with position=desired at the desired one (D)</source>
        <translation>la table est lue à la position réelle de ses axes sources&#xa0;; avec position=desired, à leur position de consigne (D)</translation>
    </message>
    <message>
        <source>max_points {number} of the source is left out: the table has {count} points</source>
        <translation>max_points {number} de la source est omis&#xa0;: la table a {count} points</translation>
    </message>
    <message>
        <source>the encoder moves {slope} times as far as the targets</source>
        <translation>le codeur se déplace {slope} fois autant que les positions cibles</translation>
    </message>
    <message>
        <source>1 within 1 %; correct the column of the encoder, or take it out of the file</source>
        <translation>1 à 1 % près&#xa0;; corriger la colonne du codeur ou la retirer du fichier</translation>
    </message>
    <message>
        <source>columns separated by , or ; instead of tabs</source>
        <translation>des colonnes séparées par , ou&#xa0;; et non par des tabulations</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: what can be read of it is half of that write. Finish it with &apos;axiscomp recover --finish&apos;, or undo it with &apos;axiscomp recover --undo&apos;. The old state is kept in {backup}</source>
        <translation>une écriture interrompue a laissé l&apos;axe {axis} ni dans son ancien ni dans son nouvel état&#xa0;: ce qui peut en être lu n&apos;est que la moitié de cette écriture. L&apos;achever avec &apos;axiscomp recover --finish&apos;, ou l&apos;annuler avec &apos;axiscomp recover --undo&apos;. L&apos;ancien état est conservé dans {backup}</translation>
    </message>
    <message>
        <source>the name of the table, {table}, says that its values correct {target}, but for axis {axis} {role}; choose another table or axis, or, if it is right all the same, write the table to this axis from its file first, and state the target as {statement} there</source>
        <translation>selon son nom, {table}, les valeurs de la table corrigent {target}, mais pour l&apos;axe {axis}, {role}&#xa0;; choisir une autre table ou un autre axe, ou, si c&apos;est malgré tout exact, écrire d&apos;abord la table sur cet axe à partir de son fichier en indiquant l&apos;axe cible par {statement}</translation>
    </message>
    <message>
        <source>mm, or both units stated: that of the positions (--unit) and that of the errors (--value-unit)</source>
        <translation>mm, ou les deux unités indiquées&#xa0;: celle des positions (--unit) et celle des erreurs (--value-unit)</translation>
    </message>
    <message>
        <source>kind: runs, or kind: averages (means of runs)</source>
        <translation>kind: runs, ou kind: averages (moyennes de passes)</translation>
    </message>
    <message>
        <source>one mean for each target and direction</source>
        <translation>une moyenne par position cible et sens</translation>
    </message>
    <message>
        <source>the second measurement is of the drive with the serial number {found}, and the first one or its table is of the one with {known}; measure that drive, or, where it was replaced since, correct the line // drive: in the file of the second</source>
        <translation>la deuxième mesure est du variateur de numéro de série {found}, et la première ou sa table de celui de numéro {known}&#xa0;; mesurer ce variateur, ou, s&apos;il a été remplacé depuis, corriger la ligne // drive: dans le fichier de la deuxième</translation>
    </message>
    <message>
        <source>measurements of the drive with the serial number {drive} and of the one with {other} cannot be joined; take those of one drive, and where it was replaced in between, correct the line // drive: of the files</source>
        <translation>des mesures du variateur de numéro de série {drive} et de celui de numéro {other} ne peuvent pas être réunies&#xa0;; prendre celles d&apos;un seul variateur, et, s&apos;il a été remplacé entre-temps, corriger la ligne // drive: des fichiers</translation>
    </message>
    <message>
        <source>the record was made of a measurement of the drive with the serial number {measured}, and this is {found}; connect the drive that was measured, or, where it was replaced since, correct the line // drive: of the measurement&apos;s file and begin a new record with it</source>
        <translation>la fiche a été établie d&apos;après une mesure du variateur de numéro de série {measured}, et ceci est {found}&#xa0;; connecter le variateur mesuré, ou, s&apos;il a été remplacé depuis, corriger la ligne // drive: du fichier de la mesure et commencer une nouvelle fiche avec celui-ci</translation>
    </message>
    <message>
        <source>axis {axis} used {slot}, and the file of this slot is missing</source>
        <translation>l&apos;axe {axis} utilisait {slot}, et le fichier de cet emplacement manque</translation>
    </message>
    <message>
        <source>the deletion of {slot} for axis {axis} can only be finished: the saved parameters that would bring its table back after a reboot are not known; the backup has the table</source>
        <translation>la suppression de {slot} pour l&apos;axe {axis} ne peut être que terminée&#xa0;: les paramètres enregistrés qui rétabliraient sa table après un redémarrage ne sont pas connus&#xa0;; la sauvegarde contient la table</translation>
    </message>
    <message>
        <source>the line // drive: of the file says that the drive with the serial number {expected} was measured, and this one has {found}: connect that drive, or, where it was replaced since, correct the line or remove it</source>
        <translation>d&apos;après la ligne // drive: du fichier, le variateur de numéro de série {expected} a été mesuré, et celui-ci a le numéro {found}&#xa0;: connecter le variateur mesuré, ou, s&apos;il a été remplacé depuis, corriger la ligne ou la supprimer</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, and another of its comments the serial number {serial}: a table is made of the measurement of one drive, so correct the wrong line, or leave it out</source>
        <translation>le fichier indique «&#xa0;{note}&#xa0;», et un autre de ses commentaires le numéro de série {serial}&#xa0;: une table est établie d&apos;après la mesure d&apos;un seul variateur, donc corriger ou supprimer la ligne erronée</translation>
    </message>
    <message>
        <source>the drive does not read the table in {slot} as the layout of the profile has it: of dimension {dimension} the drive shows {found} where the layout has {expected}. Compare {layout} in the profile with the drive&apos;s table file</source>
        <translation>le variateur ne lit pas la table de {slot} comme l&apos;indique l&apos;organisation de table du profil&#xa0;: pour la dimension {dimension}, le variateur affiche {found} là où cette organisation donne {expected}. Comparer {layout} dans le profil avec le fichier de table du variateur</translation>
    </message>
    <message>
        <source>dimension {number} of the table on the drive is one of {before}, and {source} is something else: one of them is a position, the other a temperature; write the table from its file, together with the source</source>
        <translation>la dimension {number} de la table du variateur est celle de {before}, et {source} est autre chose&#xa0;: l&apos;une est une position, l&apos;autre une température&#xa0;; écrire la table depuis son fichier, avec la source</translation>
    </message>
    <message>
        <source>The table stays, its dimension {number} has positions of an axis, and the profile does not say what {source} is. Write the table that was made for this source.</source>
        <translation>La table reste, sa dimension {number} a des positions d&apos;un axe, et le profil n&apos;indique pas ce qu&apos;est {source}. Écrivez la table qui a été faite pour cette source.</translation>
    </message>
    <message>
        <source>The backup of axis {axis} does not say with which profile it was made; its table is read with the profile {profile}.</source>
        <translation>La sauvegarde de l&apos;axe {axis} n&apos;indique pas avec quel profil elle a été faite&#xa0;; sa table est lue avec le profil {profile}.</translation>
    </message>
    <message>
        <source>the backup was made with the profile {before}, which has another layout of table files than {profile}: restore it with that profile (--profile), or, on a drive that needs the other one, write the table from its file</source>
        <translation>la sauvegarde a été faite avec le profil {before}, dont l&apos;organisation des fichiers de table diffère de celle de {profile}&#xa0;: la restaurer avec ce profil (--profile) ou, sur un variateur qui a besoin de l&apos;autre, écrire la table depuis son fichier</translation>
    </message>
    <message>
        <source>The layout of table files in the profile {profile} has been changed since the backup was made: see that the table is right.</source>
        <translation>L&apos;organisation des fichiers de table du profil {profile} a été modifiée depuis la sauvegarde&#xa0;: vérifiez que la table est juste.</translation>
    </message>
    <message>
        <source>the register {path} is in {name} too</source>
        <translation>le registre {path} figure aussi dans {name}</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}, and an import does not move a table from one axis to another: write the table to axis {imported} from its file, and name the slot that it gets there in the configuration</source>
        <translation>l&apos;emplacement {slot} est déjà utilisé ({user}), et une importation ne déplace pas une table d&apos;un axe à un autre&#xa0;: écrire la table depuis son fichier sur l&apos;axe {imported}, et indiquer dans la configuration l&apos;emplacement qu&apos;elle y reçoit</translation>
    </message>
    <message>
        <source>interval of a square grid, or interval1 and interval2 of a grid RECTANGULAR</source>
        <translation>interval d&apos;une grille carrée, ou interval1 et interval2 d&apos;une grille RECTANGULAR</translation>
    </message>
    <message>
        <source>parameter {number} of {value}</source>
        <translation>le paramètre {number} de {value}</translation>
    </message>
    <message>
        <source>a number with a decimal point, to compare it with the setting {key} of {value}; the file does not say what unit it is in without one</source>
        <translation>un nombre avec un point décimal, pour le comparer au réglage {key} de {value}&#xa0;; sans lui, le fichier ne dit pas dans quelle unité il est</translation>
    </message>
    <message>
        <source>{name} = {value}, with which the lengths of the table are in inches</source>
        <translation>{name} = {value}, avec quoi les longueurs de la table sont en pouces</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply positions and values in inches by 25.4</source>
        <translation>1&#xa0;; supprimer la ligne et multiplier par 25,4 les positions et les valeurs en pouces</translation>
    </message>
    <message>
        <source>what SECONDARY stands for, such as inch</source>
        <translation>ce que représente SECONDARY, par exemple inch</translation>
    </message>
    <message>
        <source>counts of each axis for one primary-unit; without it what is in COUNTS stays in counts</source>
        <translation>incréments de chaque axe par primary-unit&#xa0;; à défaut, ce qui est en COUNTS reste en incréments</translation>
    </message>
    <message>
        <source>{key} ENGLISH of the rotary axis {axis}</source>
        <translation>{key} ENGLISH de l&apos;axe rotatif {axis}</translation>
    </message>
    <message>
        <source>METRIC, which is degrees there; inches are lengths</source>
        <translation>METRIC, qui y signifie degrés&#xa0;; les pouces sont des longueurs</translation>
    </message>
    <message>
        <source>two kinds of units in one table</source>
        <translation>deux sortes d&apos;unités dans une même table</translation>
    </message>
    <message>
        <source>the settings {key} and {key2}</source>
        <translation>les réglages {key} et {key2}</translation>
    </message>
    <message>
        <source>the instrument says {line}: another number follows its first one, as in degrees, minutes and seconds; set it to one decimal number, or say what the number is with a pattern</source>
        <translation>l&apos;instrument indique {line}&#xa0;: un autre nombre suit le premier, comme en degrés, minutes et secondes&#xa0;; le régler sur un seul nombre décimal ou préciser par un motif ce qu&apos;est le nombre</translation>
    </message>
    <message>
        <source>the axis lost its homing in mid-measurement, as after a restart of the drive; its positions are others after it is homed again: begin a new file</source>
        <translation>l&apos;axe a perdu son origine en cours de mesure, comme après un redémarrage du variateur&#xa0;; après une nouvelle prise d&apos;origine, ses positions sont différentes&#xa0;: commencer un nouveau fichier</translation>
    </message>
    <message>
        <source>the file says sign: {file}, and stated is {stated}: correct the one that is wrong</source>
        <translation>le fichier dit sign: {file}, et {stated} est indiqué&#xa0;: corriger celui qui est faux</translation>
    </message>
    <message>
        <source>{file} says sign: command, and a table that was active holds feedback values: convert the file first, and take what is written</source>
        <translation>{file} dit sign: command, et une table qui était active contient des valeurs côté codeur (feedback)&#xa0;: convertir d&apos;abord le fichier et prendre ce qui est écrit</translation>
    </message>
    <message>
        <source>the table that is active lies over other positions or sources than at the beginning; what was taken belongs to the one before: begin a new file</source>
        <translation>la table active porte sur d&apos;autres positions ou d&apos;autres sources qu&apos;au début&#xa0;; ce qui a été relevé appartient à la précédente&#xa0;: commencer un nouveau fichier</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to in {other}; state how many counts are one unit, with the setting {key} of the file that is read</source>
        <translation>les valeurs pour {column} sont en {unit}, et les positions auxquelles elles s&apos;ajoutent en {other}&#xa0;; indiquer combien d&apos;incréments font une unité, avec le réglage {key} du fichier lu</translation>
    </message>
    <message>
        <source>the setting {key} for numbers in counts</source>
        <translation>le réglage {key} pour des nombres en incréments</translation>
    </message>
    <message>
        <source>the setting {key}, which says how many of them are one unit</source>
        <translation>le réglage {key}, qui dit combien d&apos;entre eux font une unité</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, which is for files of measurements: a table holds reference minus encoder (sign: feedback), or what is added to the command (sign: command). Correct that line; where the values are encoder minus reference, leave it out, and turn them with --scale -1</source>
        <translation>le fichier indique « {note} », ce qui est réservé aux fichiers de mesure&#xa0;: une table contient référence moins codeur (sign: feedback) ou ce qui est ajouté à la consigne (sign: command). Corriger cette ligne&#xa0;; si les valeurs sont codeur moins référence, la supprimer et inverser les valeurs avec --scale -1</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, sign: feedback or sign: command, says what the values are: correct that line, or leave it out, which means feedback</source>
        <translation>le fichier indique « {note} », où un seul commentaire, sign: feedback ou sign: command, précise ce que sont les valeurs&#xa0;: corriger cette ligne ou la supprimer, ce qui signifie feedback</translation>
    </message>
    <message>
        <source>1; as it stands in the file it follows the axis: leave --invert-reference out</source>
        <translation>1&#xa0;; telle qu&apos;elle est dans le fichier, elle suit l&apos;axe&#xa0;: ne pas indiquer --invert-reference</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>le décompte des opérations flash de ce variateur était endommagé, toutes sont donc considérées comme utilisées&#xa0;; remettre le décompte à zéro avec « axiscomp status --reset-flash-count »</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s</source>
        <translation>les opérations flash restantes suffiraient à la modification, mais pas à tout remettre en état en cas d&apos;échec&#xa0;; attendre {seconds} s</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s</source>
        <translation>trop d&apos;opérations flash en peu de temps&#xa0;; attendre {seconds} s</translation>
    </message>
    <message>
        <source>{stated}, stated as the axis that the values of {column} correct, may be one of the sources or not, since their names do not tell it, and the numbers depend on it; state the target: {sources}</source>
        <translation>{stated}, indiqué comme l&apos;axe que corrigent les valeurs de {column}, peut être ou non l&apos;une des sources, dont les noms ne le disent pas, et les nombres en dépendent&#xa0;; indiquer l&apos;axe cible&#xa0;: {sources}</translation>
    </message>
    <message>
        <source>an answer of the drive itself and not one that a cache or proxy in between has kept; connect to the drive without it</source>
        <translation>une réponse du variateur lui-même et non une réponse qu&apos;un cache ou un serveur proxy intermédiaire a conservée&#xa0;; connectez-vous au variateur sans lui</translation>
    </message>
    <message>
        <source>no Content-Encoding but identity</source>
        <translation>aucun Content-Encoding autre que identity</translation>
    </message>
    <message>
        <source>nothing after the bytes that Content-Length announces</source>
        <translation>rien après les octets qu&apos;annonce Content-Length</translation>
    </message>
    <message>
        <source>a Directory page with its Content-Length, or up to &lt;/html&gt;</source>
        <translation>une page Directory avec son Content-Length, ou jusqu&apos;à &lt;/html&gt;</translation>
    </message>
    <message>
        <source>the file in {slot} is no table that the profile can read: it is in the backup as it is, but cannot be restored as the table of an axis</source>
        <translation>le fichier de {slot} n&apos;est pas une table que le profil peut lire&#xa0;: il est dans la sauvegarde tel quel, mais ne peut pas être restauré comme table d&apos;un axe</translation>
    </message>
    <message>
        <source>the drive has taken the command that stores the table in {slot}, but has counted no flash cycle for it ({cycles} before and after): it is not known to be in flash, and may be gone after a reboot</source>
        <translation>le variateur a accepté la commande qui enregistre la table de {slot}, mais n&apos;a compté aucun cycle flash pour elle ({cycles} avant et après)&#xa0;: rien ne dit qu&apos;elle est en mémoire flash, et elle peut être perdue après un redémarrage</translation>
    </message>
    <message>
        <source>what a write that did not end has left of axis {axis} is not known: the backup of its old state, {backup}, cannot be read. Write again or restore another backup, which puts an end to it</source>
        <translation>ce qu&apos;une écriture interrompue a laissé de l&apos;axe {axis} n&apos;est pas connu&#xa0;: la sauvegarde de son ancien état, {backup}, ne peut pas être lue. Écrire à nouveau ou restaurer une autre sauvegarde, ce qui y met fin</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the setting {key} says {unit}; leave one of them out</source>
        <translation>l&apos;unité {stated} est indiquée, et le réglage {key} dit {unit} ; en retirer un</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected a unit; that numbers are in the unit of the drive is stated as {option} of {command}, or as {key} beside the settings of a machine file</source>
        <translation>le réglage {key} vaut « {value} », une unité est attendue ; que les nombres sont dans l&apos;unité du variateur s&apos;indique par {option} de {command}, ou par {key} à côté des réglages d&apos;un fichier de machine</translation>
    </message>
    <message>
        <source>&quot;{note}&quot;, as another comment says; leave one of them out</source>
        <translation>« {note} », comme le dit un autre commentaire ; en retirer un</translation>
    </message>
    <message>
        <source>{axes} as the setting {key}</source>
        <translation>{axes} comme réglage {key}</translation>
    </message>
    <message>
        <source>an axis of the file: {axes}</source>
        <translation>un axe du fichier : {axes}</translation>
    </message>
    <message>
        <source>{ranges}: nothing of what was measured first is measured again; measure over the targets of the first measurement</source>
        <translation>{ranges}&#xa0;: rien de ce qui a été mesuré d&apos;abord n&apos;est mesuré de nouveau&#xa0;; mesurer sur les positions cibles de la première mesure</translation>
    </message>
    <message>
        <source>1; some values are whole turns away, since the instrument begins again at 360 deg: let it count on, or write -0.0001 in place of 359.9999 in the file</source>
        <translation>1&#xa0;; des valeurs sont décalées de tours entiers, car l&apos;instrument recommence à 360°&#xa0;: le laisser continuer à compter, ou écrire -0.0001 au lieu de 359.9999 dans le fichier</translation>
    </message>
    <message>
        <source>no installed font has {characters}, so that empty boxes would stand in the PDF: install one that has them, such as fonts-noto-cjk for Chinese and Japanese, or write the report as HTML</source>
        <translation>aucune police installée ne contient {characters}, le PDF aurait des cases vides à la place&#xa0;: installer une police qui les contient, par exemple fonts-noto-cjk pour le chinois et le japonais, ou écrire le rapport en HTML</translation>
    </message>
    <message>
        <source>the values of {table} correct {target}, but for axis {axis} {role}; choose another column, axis or source, or, if it is right all the same, state the target as {statement} when the file is read</source>
        <translation>les valeurs de {table} corrigent {target}, mais pour l&apos;axe {axis}, {role}&#xa0;; choisir une autre colonne, un autre axe ou une autre source, ou, si c&apos;est malgré tout exact, indiquer l&apos;axe cible par {statement} à la lecture du fichier</translation>
    </message>
    <message>
        <source>the file does not say what the values of {table} correct. They were converted for {target}, but for axis {axis} {role}: read the file again with these sources, or state its target</source>
        <translation>le fichier n&apos;indique pas quel axe les valeurs de {table} corrigent. Elles ont été converties pour {target}, mais pour l&apos;axe {axis}, {role}&#xa0;: relire le fichier avec ces sources, ou indiquer son axe cible</translation>
    </message>
    <message>
        <source>a source is no position of an axis</source>
        <translation>une source n&apos;est pas la position d&apos;un axe</translation>
    </message>
    <message>
        <source>the table was made for a position before the compensation, and {source} is one after it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at set)</source>
        <translation>la table a été établie pour une position avant compensation, et {source} en est une après&#xa0;: choisir une autre source ou refaire la table pour celle-ci, à partir de sa mesure ou du fichier de sa commande (en ligne de commande avec --lookup-at set)</translation>
    </message>
    <message>
        <source>the table was made for a position after the compensation, and {source} is one before it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at encoder)</source>
        <translation>la table a été établie pour une position après compensation, et {source} en est une avant&#xa0;: choisir une autre source ou refaire la table pour celle-ci, à partir de sa mesure ou du fichier de sa commande (en ligne de commande avec --lookup-at encoder)</translation>
    </message>
    <message>
        <source>the instrument says {line}: it is not clear where its number begins and ends; set it to one decimal number and its unit, or say what the number is with a pattern</source>
        <translation>l&apos;instrument indique {line} : on ne voit pas où son nombre commence et finit ; le régler sur un seul nombre décimal avec son unité ou préciser par un motif ce qu&apos;est le nombre</translation>
    </message>
    <message>
        <source>another program has replaced, changed or deleted it since it was opened; look which values it has before you go on with it</source>
        <translation>un autre programme l&apos;a remplacé, modifié ou supprimé depuis son ouverture ; vérifier quelles valeurs il contient avant de continuer avec lui</translation>
    </message>
    <message>
        <source>column {column}, and values: {said}</source>
        <translation>colonne {column}, et values: {said}</translation>
    </message>
    <message>
        <source>one of the two; a column value goes with both</source>
        <translation>l&apos;un des deux ; une colonne value convient aux deux</translation>
    </message>
    <message>
        <source>the controller adds the tables for {axis}: the sign of each is converted, and each is compared, as if it were alone</source>
        <translation>la commande additionne les tables pour {axis} : le signe de chacune est converti, et chacune est comparée, comme si elle était seule</translation>
    </message>
    <message>
        <source>a second table that belongs to the same motor</source>
        <translation>une deuxième table qui appartient au même moteur</translation>
    </message>
    <message>
        <source>one for each motor; the last one counts</source>
        <translation>une pour chaque moteur ; la dernière compte</translation>
    </message>
    <message>
        <source>begins again at the other end</source>
        <translation>recommence à l&apos;autre extrémité</translation>
    </message>
    <message>
        <source>another axis than that of the first source</source>
        <translation>un autre axe que celui de la première source</translation>
    </message>
    <message>
        <source>one number; line {line} gives it another one for the next pass of the loop</source>
        <translation>un seul nombre&#xa0;; la ligne {line} lui en donne un autre pour le passage suivant de la boucle</translation>
    </message>
    <message>
        <source>one number; another part of the program gives it another one in line {line}</source>
        <translation>un seul nombre&#xa0;; une autre partie du programme lui en donne un autre à la ligne {line}</translation>
    </message>
    <message>
        <source>a name that got a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether that of line {line} counts</source>
        <translation>un nom qui a reçu son nombre hors de IF, ELSE, SWITCH, LOOP, WHILE et ON&#xa0;; seule la commande sait si celui de la ligne {line} compte</translation>
    </message>
    <message>
        <source>a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether this one counts</source>
        <translation>un nombre hors de IF, ELSE, SWITCH, LOOP, WHILE et ON&#xa0;; seule la commande sait si celui-ci compte</translation>
    </message>
    <message>
        <source>numbers for the elements of {name} alone; what else changes the array behind them is not computed</source>
        <translation>seulement des nombres pour les éléments de {name}&#xa0;; ce qui modifie ensuite le tableau d&apos;une autre façon n&apos;est pas calculé</translation>
    </message>
    <message>
        <source>The new table is volatile: after a reboot the axis has the old, persistent one again, or none where the parameters have been saved since then.</source>
        <translation>La nouvelle table est volatile&#xa0;: après un redémarrage, l&apos;axe retrouve l&apos;ancienne table persistante, ou n&apos;en a aucune si les paramètres ont été enregistrés entre-temps.</translation>
    </message>
    <message>
        <source>the setting {key} says {value} for tables of different axes, {axes}; choose one of the tables (--table), or leave the setting out</source>
        <translation>le réglage {key} indique {value} pour des tables d&apos;axes différents, {axes}&#xa0;; choisir l&apos;une des tables (--table) ou omettre le réglage</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the set position: use it with such sources only</source>
        <translation>le nouveau fichier n&apos;indique pas que le variateur doit le consulter à la position de consigne&#xa0;: ne l&apos;utiliser qu&apos;avec de telles sources</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the encoder position: use it with such sources only</source>
        <translation>le nouveau fichier n&apos;indique pas que le variateur doit le consulter à la position du codeur&#xa0;: ne l&apos;utiliser qu&apos;avec de telles sources</translation>
    </message>
    <message>
        <source>the new file does not say that the drive with the serial number {serial} was measured, as its source does: use it for that drive only</source>
        <translation>contrairement à sa source, le nouveau fichier n&apos;indique pas que le variateur de numéro de série {serial} a été mesuré&#xa0;: ne l&apos;utiliser que pour ce variateur</translation>
    </message>
    <message>
        <source>several tables are called {table}; choose one by its number, such as #1: {alike}</source>
        <translation>plusieurs tables s&apos;appellent {table}&#xa0;; en choisir une par son numéro, par exemple #1&#xa0;: {alike}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid list of positions: {count} problems</source>
        <comment>{file} is not a valid list of positions: one problem</comment>
        <translation>
            <numerusform>{file} n&apos;est pas une liste de positions valide&#xa0;: {count} problème</numerusform>
            <numerusform>{file} n&apos;est pas une liste de positions valide&#xa0;: {count} problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} is UTF-16 text; save it as UTF-8 text</source>
        <translation>{file} est du texte UTF-16&#xa0;; l&apos;enregistrer en texte UTF-8</translation>
    </message>
    <message>
        <source>one value for each target, direction and run, or a number for each run</source>
        <translation>une valeur par position cible, sens et passe, ou un numéro par passe</translation>
    </message>
    <message>
        <source>nobody has published that the numbers begin at line N{first} (first-record): compare with a file of this controller</source>
        <translation>personne n&apos;a publié que les numéros commencent à la ligne N{first} (first-record)&#xa0;: comparer avec un fichier de cette commande</translation>
    </message>
    <message>
        <source>nobody has published that a value is at most {most} (largest-step): compare with a file of this controller</source>
        <translation>personne n&apos;a publié qu&apos;une valeur vaut au plus {most} (largest-step)&#xa0;: comparer avec un fichier de cette commande</translation>
    </message>
    <message>
        <source>this counts only with {member}, which is missing</source>
        <translation>ceci ne compte qu&apos;avec {member}, qui manque</translation>
    </message>
    <message>
        <source>it states no term of the uncertainty</source>
        <translation>il n&apos;indique aucune composante de l&apos;incertitude</translation>
    </message>
    <message>
        <source>the {what} were in {unit} when the write began, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>les {what} étaient en {unit} au début de l&apos;écriture, et le variateur les a maintenant en {other}&#xa0;: les mêmes nombres auraient un autre sens&#xa0;; remettre l&apos;unité du variateur à {unit} ou écrire la table depuis son fichier</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the write began, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>l&apos;axe {axis} était {target} au début de l&apos;écriture, et c&apos;est maintenant {name} sur le variateur&#xa0;; redonner aux axes l&apos;ordre ou les noms qu&apos;ils avaient, ou écrire la table depuis son fichier</translation>
    </message>
    <message>
        <source>the {what} of the record&apos;s table were in {unit} when it was written, and the drive has them in {other} now, so that the same numbers mean something else; set the unit on the drive to {unit} again, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>les {what} de la table de la fiche étaient en {unit} lors de son écriture, et le variateur les a maintenant en {other}&#xa0;: les mêmes nombres ont un autre sens&#xa0;; remettre l&apos;unité du variateur à {unit} ou écrire de nouveau la table de la fiche («&#xa0;axiscomp write --record&#xa0;»)</translation>
    </message>
    <message>
        <source>an unknown unit</source>
        <translation>une unité inconnue</translation>
    </message>
    <message>
        <source>the record does not say in which unit the axis was when its table was written, and in {unit}, as the axis is now, none of its tables is the one on the drive: set the unit that the axis had, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>la fiche n&apos;indique pas dans quelle unité était l&apos;axe lors de l&apos;écriture de sa table, et en {unit}, l&apos;unité actuelle de l&apos;axe, aucune de ses tables n&apos;est celle du variateur&#xa0;: remettre l&apos;unité que l&apos;axe avait, ou écrire de nouveau la table de la fiche («&#xa0;axiscomp write --record&#xa0;»)</translation>
    </message>
    <message>
        <source>{example}: the file says {value}</source>
        <translation>{example}&#xa0;: le fichier indique {value}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller takes the axis to be at {moved}</source>
        <translation>là où le codeur indique {place}, l&apos;axe est à {moved} pour la commande</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller takes {axis} to be at {moved}</source>
        <translation>là où les codeurs indiquent {place}, {axis} est à {moved} pour la commande</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller adds {value} to the position of {axis}</source>
        <translation>là où le codeur indique {place}, la commande ajoute {value} à la position de {axis}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller adds {value} to the position of {axis}</source>
        <translation>là où les codeurs indiquent {place}, la commande ajoute {value} à la position de {axis}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}</source>
        <translation>pour la consigne {place}, la commande amène le codeur à {moved}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}</source>
        <translation>pour la consigne {place}, la commande amène le codeur de {axis} à {moved}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves {target} by {value}</source>
        <translation>pour la consigne {place}, la commande déplace {target} de {value}</translation>
    </message>
    <message>
        <source>the configuration names the table in {slot} for axis {axis}, but the drive has none there: write the table to the axis from its file and name the slot that it gets in the configuration, or write it into {slot} with &apos;axiscomp write --slot {slot}&apos;</source>
        <translation>la configuration indique la table dans {slot} pour l&apos;axe {axis}, mais le variateur n&apos;y en a pas&#xa0;: écrire la table depuis son fichier sur l&apos;axe et indiquer dans la configuration l&apos;emplacement qu&apos;elle reçoit, ou l&apos;écrire dans {slot} avec &apos;axiscomp write --slot {slot}&apos;</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis: &apos;axiscomp recover&apos; says how the write can be finished or undone. The old state is kept in {backup}</source>
        <translation>{reason}&#xa0;; la restauration de l&apos;ancien état a échoué elle aussi ({rollback}). Ne pas activer l&apos;axe&#xa0;: &apos;axiscomp recover&apos; indique comment achever ou annuler l&apos;écriture. L&apos;ancien état est conservé dans {backup}</translation>
    </message>
    <message>
        <source>{endpoint} refuses the user name or the password that was given; in an address %40 stands for @, %3A for :, %2F for /, %23 for # and %25 for %</source>
        <translation>{endpoint} refuse le nom d&apos;utilisateur ou le mot de passe indiqué&#xa0;; dans une adresse, %40 tient lieu de @, %3A de :, %2F de /, %23 de # et %25 de %</translation>
    </message>
    <message>
        <source>write http://user:password@host[:port], and in user name and password %40 for @, %3A for :, %2F for /, %3F for ?, %23 for # and %25 for %</source>
        <translation>écrire http://utilisateur:motdepasse@hôte[:port], et dans le nom d&apos;utilisateur et le mot de passe %40 pour @, %3A pour :, %2F pour /, %3F pour ?, %23 pour # et %25 pour %</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} of axis {ofAxis} is missing</source>
        <translation>la source de la dimension {dimension} de l&apos;axe {ofAxis} manque</translation>
    </message>
    <message>
        <source>a machine cannot be called {name}: a name has no control characters</source>
        <translation>une machine ne peut pas s&apos;appeler {name}&#xa0;: un nom ne contient pas de caractères de contrôle</translation>
    </message>
    <message>
        <source>the name of axis {axis}</source>
        <translation>nom de l&apos;axe {axis}</translation>
    </message>
    <message>
        <source>the units of the table of {axis}</source>
        <translation>unités de la table de {axis}</translation>
    </message>
    <message>
        <source>{file} is a measurement, not a table; make a table of it with &apos;axiscomp fit&apos; or on the pages Measure and Fit; if it is a table all the same, name its format</source>
        <translation>{file} est une mesure et non une table&#xa0;; en faire une table avec «&#xa0;axiscomp fit&#xa0;» ou sur les pages Mesurer et Ajuster&#xa0;; si c&apos;est tout de même une table, nommer son format</translation>
    </message>
    <message>
        <source>The open record will not note this write: {reason}.</source>
        <translation>La fiche ouverte ne notera pas cette écriture&#xa0;: {reason}.</translation>
    </message>
    <message>
        <source>nothing says for which measuring system of axis {axis} the table is: it is written for 0; the setting {key} states another one</source>
        <translation>rien n&apos;indique pour quel système de mesure de l&apos;axe {axis} est la table&#xa0;: elle est écrite pour 0&#xa0;; le paramètre {key} en indique un autre</translation>
    </message>
    <message>
        <source>a table for {element} alone</source>
        <translation>une table pour {element} seulement</translation>
    </message>
    <message>
        <source>CompPos and CompPos2 of the motor; the table is taken for both, and written for both</source>
        <translation>CompPos et CompPos2 du moteur&#xa0;; la table est prise pour les deux, et écrite pour les deux</translation>
    </message>
    <message>
        <source>axis {axis}, whose numbers are taken to be in mm</source>
        <translation>axe {axis}, dont les nombres sont pris pour des mm</translation>
    </message>
    <message>
        <source>the setting {key} where the axis is rotary</source>
        <translation>le paramètre {key} si c&apos;est un axe rotatif</translation>
    </message>
</context>
<context>
    <name>FileFilter</name>
    <message>
        <source>Compensation data</source>
        <translation>Données de compensation</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Record of the compensation (axiscomp write --record), which notes the proof</source>
        <translation>Fiche de la compensation (axiscomp write --record), où la validation est notée</translation>
    </message>
    <message>
        <source>List the axes of one or several drives</source>
        <translation>Lister les axes d&apos;un ou de plusieurs variateurs</translation>
    </message>
    <message>
        <source>Also try all serial ports of this computer; without --drive, the connections of the window too</source>
        <translation>Essayer aussi tous les ports série de cet ordinateur&#xa0;; sans --drive, également les connexions de la fenêtre</translation>
    </message>
    <message>
        <source>Try the usual baud rates at every serial port</source>
        <translation>Essayer les débits courants sur chaque port série</translation>
    </message>
    <message>
        <source>Also ask these addresses over http: 192.168.1.0/24, 192.168.1.10-40 or one address, at most 1024, with :PORT for another port than 80</source>
        <translation>Interroger aussi ces adresses en http&#xa0;: 192.168.1.0/24, 192.168.1.10-40 ou une seule adresse, 1024 au plus, avec :PORT pour un autre port que 80</translation>
    </message>
    <message>
        <source>Save everything that this program can change on a whole drive, all axes, to one file</source>
        <translation>Sauvegarder dans un fichier tout ce que ce programme peut modifier sur un variateur entier, tous axes compris</translation>
    </message>
    <message>
        <source>File to write; standard output without it, or with -</source>
        <translation>Fichier à écrire&#xa0;; par défaut ou avec -, la sortie standard</translation>
    </message>
    <message>
        <source>Restore a whole drive from a backup file, with verified writes; all of them are planned first</source>
        <translation>Restaurer un variateur entier depuis un fichier de sauvegarde, par des écritures vérifiées&#xa0;; toutes sont d&apos;abord planifiées</translation>
    </message>
    <message>
        <source>File that `axiscomp backup` wrote; - for standard input</source>
        <translation>Fichier écrit par `axiscomp backup`&#xa0;; - pour l&apos;entrée standard</translation>
    </message>
    <message>
        <source>Restore to a drive with another serial number, such as a replacement</source>
        <translation>Restaurer sur un variateur d&apos;un autre numéro de série, par exemple un variateur de remplacement</translation>
    </message>
    <message>
        <source>Show what would be written without writing it</source>
        <translation>Montrer ce qui serait écrit, sans l&apos;écrire</translation>
    </message>
    <message>
        <source>Where the axis really is: a register of the drive, serial:/dev/ttyUSB1?baud=9600, - for lines on standard input, or typed</source>
        <translation>Où se trouve réellement l&apos;axe&#xa0;: un registre du variateur, serial:/dev/ttyUSB1?baud=9600, - pour des lignes de l&apos;entrée standard, ou typed pour la saisie manuelle</translation>
    </message>
    <message>
        <source>Unit of the instrument; of a register it is that of the axis, of lines the one behind the number unless given</source>
        <translation>Unité de l&apos;instrument&#xa0;; par défaut, pour un registre celle de l&apos;axe, pour des lignes celle qui suit le nombre</translation>
    </message>
    <message>
        <source>The instrument counts the other way</source>
        <translation>L&apos;instrument compte en sens inverse</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0 (0 unless given)</source>
        <translation>Position de l&apos;axe où l&apos;instrument indique 0 (0 par défaut)</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line, its first group or all of it; the first number of the line unless given</source>
        <translation>Expression régulière pour le nombre dans une ligne, son premier groupe ou le tout&#xa0;; par défaut, le premier nombre de la ligne</translation>
    </message>
    <message>
        <source>Send this to the serial instrument before each reading, with \r and \n for line ends</source>
        <translation>Envoyer ceci à l&apos;instrument série avant chaque lecture, avec \r et \n pour les fins de ligne</translation>
    </message>
    <message>
        <source>Register of the raw position; the profile&apos;s unless given</source>
        <translation>Registre de la position brute&#xa0;; par défaut, celui du profil</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within so many mm or deg, and readings may differ by as much (0.001 unless given)</source>
        <translation>L&apos;axe est à l&apos;arrêt tant que son codeur reste dans cette fenêtre en mm ou degrés, et les lectures peuvent différer d&apos;autant (0.001 par défaut)</translation>
    </message>
    <message>
        <source>So many seconds, before anything is taken (1 unless given)</source>
        <translation>Temporisation en secondes avant de relever une valeur (1 par défaut)</translation>
    </message>
    <message>
        <source>Readings that make a value (10 unless given)</source>
        <translation>Lectures qui forment une valeur (10 par défaut)</translation>
    </message>
    <message>
        <source>Readings per second, 10 to 50 (20 unless given)</source>
        <translation>Lectures par seconde, de 10 à 50 (20 par défaut)</translation>
    </message>
    <message>
        <source>Take the values of a measuring plan while something else moves the axis</source>
        <translation>Relever les valeurs d&apos;un plan de mesure pendant que l&apos;axe est déplacé par ailleurs</translation>
    </message>
    <message>
        <source>Plan as axiscomp targets writes it</source>
        <translation>Plan tel que l&apos;écrit axiscomp targets</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>Fichier des valeurs&#xa0;; un fichier existant est poursuivi là où il s&apos;arrête</translation>
    </message>
    <message>
        <source>axiscomp never moves an axis: the machine&apos;s control or a person does.</source>
        <translation>axiscomp ne déplace jamais un axe&#xa0;: c&apos;est le rôle de la commande de la machine ou d&apos;une personne.</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Exemples&#xa0;:</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to a servo drive, activates them, and checks the drive&apos;s output against the table.</source>
        <translation>Écrit des tables de compensation des erreurs d&apos;axe mesurées dans un servovariateur, les active et compare la sortie du variateur à la table.</translation>
    </message>
    <message>
        <source>Show the version</source>
        <translation>Afficher la version</translation>
    </message>
    <message>
        <source>ENDPOINT is http://host[:port], https://host[:port], serial:DEVICE[?baud=N] or demo: (a virtual drive inside the program). AXISCOMP_DRIVE is the default of --drive. `axiscomp COMMAND --help` has more.</source>
        <translation>ENDPOINT est http://hôte[:port], https://hôte[:port], serial:PÉRIPHÉRIQUE[?baud=N] ou demo: (un variateur virtuel intégré au programme). AXISCOMP_DRIVE est la valeur par défaut de --drive. Pour en savoir plus&#xa0;: `axiscomp COMMAND --help`.</translation>
    </message>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>Écrire un document JSON sur la sortie standard</translation>
    </message>
    <message>
        <source>Files on this computer</source>
        <translation>Fichiers sur cet ordinateur</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Variateurs</translation>
    </message>
    <message>
        <source>Compare measurements before and after a compensation, and with what was promised</source>
        <translation>Comparer les mesures avant et après une compensation, entre elles et à la prévision</translation>
    </message>
    <message>
        <source>on: the second measurement was made with the table of the record active, where its file does not say it</source>
        <translation>on&#xa0;: la deuxième mesure a été faite avec la table de la fiche active, si son fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>Add the second measurement and the verdict to the record</source>
        <translation>Ajouter la deuxième mesure et le verdict à la fiche</translation>
    </message>
    <message>
        <source>Compensation parameters of a TAM configuration: show them, take them from a drive, or bring them to one</source>
        <translation>Paramètres de compensation d&apos;une configuration TAM&#xa0;: les afficher, les reprendre d&apos;un variateur ou les écrire dans un variateur</translation>
    </message>
    <message>
        <source>show, export (to the file) or import (from it)</source>
        <translation>show (afficher), export (vers le fichier) ou import (depuis le fichier)</translation>
    </message>
    <message>
        <source>TAM configuration (.TAMcfg)</source>
        <translation>Configuration TAM (.TAMcfg)</translation>
    </message>
    <message>
        <source>export: take the parameters from this configuration in place of a drive</source>
        <translation>export&#xa0;: prendre les paramètres dans cette configuration au lieu d&apos;un variateur</translation>
    </message>
    <message>
        <source>export: write this file instead, and leave the other one as it is</source>
        <translation>export&#xa0;: écrire plutôt ce fichier et laisser l&apos;autre tel quel</translation>
    </message>
    <message>
        <source>Name or serial number of the station in the file; without it the one with the drive&apos;s serial number</source>
        <translation>Nom ou numéro de série de la station dans le fichier&#xa0;; par défaut, celle qui a le numéro de série du variateur</translation>
    </message>
    <message>
        <source>Accept a station with another serial number than the drive&apos;s</source>
        <translation>Accepter une station d&apos;un autre numéro de série que celui du variateur</translation>
    </message>
    <message>
        <source>Only the registers Table and Dim1Source to Dim3Source of the axes are read and written. Everything else in the file stays as it is, and tables stay on the drive. Importing never switches a compensation on.</source>
        <translation>Seuls les registres Table et Dim1Source à Dim3Source des axes sont lus et écrits. Tout le reste du fichier est conservé tel quel, et les tables restent sur le variateur. L&apos;importation n&apos;active jamais une compensation.</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>Exemple&#xa0;:</translation>
    </message>
    <message>
        <source>Convert a table file to another format</source>
        <translation>Convertir un fichier de table dans un autre format</translation>
    </message>
    <message>
        <source>File to read; - for standard input</source>
        <translation>Fichier à lire&#xa0;; - pour l&apos;entrée standard</translation>
    </message>
    <message>
        <source>File to write, replaced if it exists; - for standard output</source>
        <translation>Fichier à écrire, remplacé s&apos;il existe&#xa0;; - pour la sortie standard</translation>
    </message>
    <message>
        <source>Format of the output, if its name leaves it open</source>
        <translation>Format de la sortie, si son nom ne le détermine pas</translation>
    </message>
    <message>
        <source>Unit of the values in a .TAMtbl, which does not say it; by default that of the positions</source>
        <translation>Unité des valeurs dans un .TAMtbl, qui ne l&apos;indique pas&#xa0;; par défaut, celle des positions</translation>
    </message>
    <message>
        <source>Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl</source>
        <translation>Écrire aussi dans un .TAMtbl des corrections supérieures à 1&#xa0;% de l&apos;étendue ou de pente supérieure à 0,1</translation>
    </message>
    <message>
        <source>Mark the table persistent: the drive stores it</source>
        <translation>Marquer la table comme persistante&#xa0;: le variateur l&apos;enregistre</translation>
    </message>
    <message>
        <source>Mark the table volatile (without either: as the input is)</source>
        <translation>Marquer la table comme volatile (sans l&apos;une ni l&apos;autre option&#xa0;: comme l&apos;entrée)</translation>
    </message>
    <message>
        <source>Name of the table</source>
        <translation>Nom de la table</translation>
    </message>
    <message>
        <source>Delete the table of an axis, or one that no axis uses, and free its slot</source>
        <translation>Supprimer la table d&apos;un axe, ou une table qu&apos;aucun axe n&apos;utilise, et libérer son emplacement</translation>
    </message>
    <message>
        <source>Delete the table in this slot, small1 to small8, large1 or large2, which no axis uses</source>
        <translation>Supprimer la table de cet emplacement, small1 à small8, large1 ou large2&#xa0;; aucun axe ne doit l&apos;utiliser</translation>
    </message>
    <message>
        <source>Show what would be deleted without deleting it</source>
        <translation>Montrer ce qui serait supprimé, sans le supprimer</translation>
    </message>
    <message>
        <source>The compensation must be off. The axis then uses no table, also after a reboot; its sources stay. What is deleted is kept in a backup: `axiscomp restore` brings it back.</source>
        <translation>La compensation doit être désactivée. L&apos;axe n&apos;utilise ensuite aucune table, même après un redémarrage&#xa0;; ses sources restent. Ce qui est supprimé est conservé dans une sauvegarde&#xa0;: `axiscomp restore` le rétablit.</translation>
    </message>
    <message>
        <source>Write an example calibration file (CSV)</source>
        <translation>Écrire un exemple de fichier d&apos;étalonnage (CSV)</translation>
    </message>
    <message>
        <source>Number of dimensions: 1, 2 or 3</source>
        <translation>Nombre de dimensions&#xa0;: 1, 2 ou 3</translation>
    </message>
    <message>
        <source>Number of tables (2 unless given)</source>
        <translation>Nombre de tables (2 par défaut)</translation>
    </message>
    <message>
        <source>Table file to write, replaced if it exists; - for standard output. Without it nothing is written</source>
        <translation>Fichier de table à écrire, remplacé s&apos;il existe&#xa0;; - pour la sortie standard. Par défaut, rien n&apos;est écrit</translation>
    </message>
    <message>
        <source>Begin a record of the compensation (.axcal): measurement, table and what it promises, for compare and report</source>
        <translation>Commencer une fiche de la compensation (.axcal)&#xa0;: mesure, table et prévision, pour compare et report</translation>
    </message>
    <message>
        <source>Write this column of points only, where the format holds one table</source>
        <translation>N&apos;écrire que cette colonne de points, si le format ne contient qu&apos;une table</translation>
    </message>
    <message>
        <source>Curve and grid</source>
        <translation>Courbe et grille</translation>
    </message>
    <message>
        <source>Curve through the means: linear (the default), cubic, spline, smooth or harmonic</source>
        <translation>Courbe passant par les moyennes&#xa0;: linear (par défaut), cubic, spline, smooth ou harmonic</translation>
    </message>
    <message>
        <source>Of the method smooth, and of points and tracks; by cross-validation unless given</source>
        <translation>Lissage de la méthode smooth, ainsi que des points et des relevés continus&#xa0;; par défaut, par validation croisée</translation>
    </message>
    <message>
        <source>Known periods, such as the lead of the screw, fitted by the method smooth</source>
        <translation>Périodes connues, par exemple le pas de la vis, ajustées par la méthode smooth</translation>
    </message>
    <message>
        <source>Harmonics of each period, and of the method harmonic, the fundamental counted (1 unless given)</source>
        <translation>Nombre d&apos;harmoniques de chaque période et de harmonic, fondamental compris (1 par défaut)</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>Longueur d&apos;un tour d&apos;un axe modulo, par exemple 360&#xa0;: la table finit comme elle commence</translation>
    </message>
    <message>
        <source>Which runs the table is made of: mean of both (the default), positive or negative; both makes a table for each, for controllers that keep two</source>
        <translation>Passes dont la table est tirée&#xa0;: mean (moyenne des deux sens, par défaut), positive ou negative&#xa0;; both établit une table par sens, pour les commandes qui en ont deux</translation>
    </message>
    <message>
        <source>temperature: a table over position and temperature, from runs in several thermal states; --points and --distance take a second number for it</source>
        <translation>temperature&#xa0;: une table selon la position et la température, à partir de passes dans plusieurs états thermiques&#xa0;; --points et --distance prennent alors un deuxième nombre</translation>
    </message>
    <message>
        <source>Even grid with N points, for each axis or for all; unless given, that of the targets, where they are even</source>
        <translation>Grille régulière de N points, par axe ou pour tous&#xa0;; par défaut, celle des positions cibles si elles sont régulières</translation>
    </message>
    <message>
        <source>Even grid with spacing D, for each axis or for all</source>
        <translation>Grille régulière de pas D, par axe ou pour tous</translation>
    </message>
    <message>
        <source>The fewest points that leave no more than this to the curve, in mm or deg</source>
        <translation>Le minimum de points qui ne laisse pas plus que cet écart à la courbe, en mm ou degrés</translation>
    </message>
    <message>
        <source>Let the grid extend beyond the targets, where the end values are held</source>
        <translation>Laisser la grille s&apos;étendre au-delà des positions cibles, où les valeurs d&apos;extrémité sont maintenues</translation>
    </message>
    <message>
        <source>Speed of the axis in mm/s or deg/s, for the steps of the velocity that are told</source>
        <translation>Vitesse de l&apos;axe en mm/s ou degrés/s, pour les sauts de vitesse indiqués</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>Zéro, pente et dérive</translation>
    </message>
    <message>
        <source>Where the table is 0: home, first (the first target), mean, keep, or a position; home where it is known and measured, else first, unless given</source>
        <translation>Où la table vaut 0&#xa0;: home, first (la première position cible), mean, keep ou une position&#xa0;; par défaut, home si la position d&apos;origine est connue et mesurée, sinon first</translation>
    </message>
    <message>
        <source>Home position of the axis</source>
        <translation>Position d&apos;origine de l&apos;axe</translation>
    </message>
    <message>
        <source>Take the slope out, for straightness: lsq (least squares) or ends</source>
        <translation>Retirer la pente, pour la rectitude&#xa0;: lsq (moindres carrés) ou ends</translation>
    </message>
    <message>
        <source>Take the drift of the runs out before they are averaged: offset or trend</source>
        <translation>Retirer la dérive des passes avant d&apos;en faire la moyenne&#xa0;: offset ou trend</translation>
    </message>
    <message>
        <source>State of the drive</source>
        <translation>État du variateur</translation>
    </message>
    <message>
        <source>Where the drive looks the table up: encoder (before the compensation) or set (after it); with --onto drive by its source</source>
        <translation>Où le variateur consulte la table&#xa0;: encoder (avant compensation) ou set (après)&#xa0;; avec --onto drive, d&apos;après sa source</translation>
    </message>
    <message>
        <source>What was active while it was measured, where the file does not say it: off, on, or the file of the table</source>
        <translation>Ce qui était actif pendant la mesure, si le fichier ne l&apos;indique pas&#xa0;: off, on ou le fichier de la table</translation>
    </message>
    <message>
        <source>Merge residuals onto the table that was active: its file, or drive for the one that the axis uses (--drive, --axis)</source>
        <translation>Fusionner des écarts résiduels avec la table qui était active&#xa0;: son fichier, ou drive pour celle que l&apos;axe utilise (--drive, --axis)</translation>
    </message>
    <message>
        <source>Factor for the residuals before they are merged (1); below 1, such as 0.7, where the machine responds sluggishly</source>
        <translation>Facteur appliqué aux écarts résiduels avant leur fusion (1 par défaut)&#xa0;; inférieur à 1, par exemple 0.7, si la machine réagit lentement</translation>
    </message>
    <message>
        <source>Points and tracks</source>
        <translation>Points et relevés continus</translation>
    </message>
    <message>
        <source>Remove the alignment of the artefact: rigid (position and rotation), rigid:X (rotated so that lines along X have no slope), or scale (its scale as well)</source>
        <translation>Retirer le placement de l&apos;étalon&#xa0;: rigid (position et rotation), rigid:X (tourné de sorte que les lignes suivant X n&apos;aient aucune pente) ou scale (l&apos;échelle aussi)</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one: smooth or nearest; refused unless given</source>
        <translation>Points de la grille loin de tout point mesuré&#xa0;: smooth ou nearest&#xa0;; refusés par défaut</translation>
    </message>
    <message>
        <source>Give values that do not fit the others less weight</source>
        <translation>Donner moins de poids aux valeurs qui ne concordent pas avec les autres</translation>
    </message>
    <message>
        <source>Make a compensation table of a measurement, and foretell what it does</source>
        <translation>Établir une table de compensation à partir d&apos;une mesure et prévoir son effet</translation>
    </message>
    <message>
        <source>List the table formats, or describe one: its limits, rules and settings</source>
        <translation>Lister les formats de table, ou en décrire un&#xa0;: ses limites, ses règles et ses réglages</translation>
    </message>
    <message>
        <source>One format: its rules, limits and settings</source>
        <translation>Un format&#xa0;: ses règles, ses limites et ses réglages</translation>
    </message>
    <message>
        <source>All of them, as the page docs/formats.md</source>
        <translation>Tous, sous la forme de la page docs/formats.md</translation>
    </message>
    <message>
        <source>The formats of measurements instead of those of tables</source>
        <translation>Les formats de mesure au lieu de ceux de table</translation>
    </message>
    <message>
        <source>Check a file and report its format, grid, tables and problems</source>
        <translation>Vérifier un fichier et indiquer son format, sa grille, ses tables et ses problèmes</translation>
    </message>
    <message>
        <source>Calibration file or table; - for standard input</source>
        <translation>Fichier d&apos;étalonnage ou table&#xa0;; - pour l&apos;entrée standard</translation>
    </message>
    <message>
        <source>Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances</source>
        <translation>Analyser une mesure&#xa0;: caractéristiques de l&apos;ISO 230-2, dérive, valeurs aberrantes, tolérances</translation>
    </message>
    <message>
        <source>Rule that proposes outliers: mad (the default), grubbs or none</source>
        <translation>Règle qui propose les valeurs aberrantes&#xa0;: mad (par défaut), grubbs ou none</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw, in mm or deg</source>
        <translation>Période connue de l&apos;axe, par exemple le pas de sa vis, en mm ou degrés</translation>
    </message>
    <message>
        <source>Show the figures of VDI/DGQ 3441 as well</source>
        <translation>Afficher aussi les caractéristiques de la VDI/DGQ 3441</translation>
    </message>
    <message>
        <source>Print the interpolated value at a position, as the drive or the controller of the file computes it</source>
        <translation>Afficher la valeur interpolée à une position, telle que le variateur ou la commande du fichier la calcule</translation>
    </message>
    <message>
        <source>Calibration file or table</source>
        <translation>Fichier d&apos;étalonnage ou table</translation>
    </message>
    <message>
        <source>X [Y [Z]], one number per dimension; may be negative</source>
        <translation>X [Y [Z]], un nombre par dimension, éventuellement négatif</translation>
    </message>
    <message>
        <source>File with one position per line, - for standard input; prints one result per line</source>
        <translation>Fichier avec une position par ligne, - pour l&apos;entrée standard&#xa0;; affiche un résultat par ligne</translation>
    </message>
    <message>
        <source>Value outside the table: hold (as the drive does; the default), zero, wrap, extrapolate or error</source>
        <translation>Valeur hors de la table&#xa0;: hold (comme le variateur&#xa0;; par défaut), zero, wrap, extrapolate ou error</translation>
    </message>
    <message>
        <source>Print the value that the controller of this format would apply, after conversion</source>
        <translation>Afficher la valeur qu&apos;appliquerait la commande de ce format, après conversion</translation>
    </message>
    <message>
        <source>Machine file (.toml)</source>
        <translation>Fichier machine (.toml)</translation>
    </message>
    <message>
        <source>Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may be given several times</source>
        <translation>Cet axe seulement, tel que le fichier le nomme, ou SERIAL/AXIS pour celui d&apos;un seul variateur&#xa0;; répétable</translation>
    </message>
    <message>
        <source>Drives at the same time (16 unless given)</source>
        <translation>Variateurs traités en même temps (16 par défaut)</translation>
    </message>
    <message>
        <source>Leave drives out that do not answer, which is an error otherwise</source>
        <translation>Ignorer les variateurs qui ne répondent pas, ce qui est sinon une erreur</translation>
    </message>
    <message>
        <source>Compare the drives of a machine with its machine file, and change nothing</source>
        <translation>Comparer les variateurs d&apos;une machine à son fichier machine, sans rien modifier</translation>
    </message>
    <message>
        <source>The exit code is 0 when all drives have what the file says, and 9 when something differs.</source>
        <translation>Le code de retour est 0 si tous les variateurs ont ce qu&apos;indique le fichier, et 9 si quelque chose diffère.</translation>
    </message>
    <message>
        <source>Write what a machine file says to the drives of the machine, where they differ</source>
        <translation>Écrire le contenu d&apos;un fichier machine dans les variateurs de la machine, là où ils diffèrent</translation>
    </message>
    <message>
        <source>Switch the compensation of axes on and off where the file says so (active), and prove it</source>
        <translation>Activer et désactiver la compensation des axes si le fichier l&apos;indique (active), et la valider</translation>
    </message>
    <message>
        <source>All drives are planned first, and nothing is written unless all of it is possible. Each write is safe as that of `axiscomp write`. A second apply finds nothing to do.</source>
        <translation>Tous les variateurs sont d&apos;abord planifiés, et rien n&apos;est écrit si tout n&apos;est pas possible. Chaque écriture est aussi sûre que celle de `axiscomp write`. Un deuxième apply ne trouve plus rien à faire.</translation>
    </message>
    <message>
        <source>Print output, indices and sources of an axis as CSV until stopped</source>
        <translation>Afficher la sortie, les indices et les sources d&apos;un axe en CSV jusqu&apos;à l&apos;arrêt</translation>
    </message>
    <message>
        <source>Lines per second, 1 to 100 (10 unless given)</source>
        <translation>Lignes par seconde, de 1 à 100 (10 par défaut)</translation>
    </message>
    <message>
        <source>Number of lines; without end unless given</source>
        <translation>Nombre de lignes&#xa0;; sans fin par défaut</translation>
    </message>
    <message>
        <source>Download the table that an axis uses</source>
        <translation>Récupérer la table qu&apos;un axe utilise</translation>
    </message>
    <message>
        <source>File to write, .csv, .TAMtbl or that of another controller; CSV on standard output without it</source>
        <translation>Fichier à écrire, .csv, .TAMtbl ou celui d&apos;une autre commande&#xa0;; par défaut, CSV sur la sortie standard</translation>
    </message>
    <message>
        <source>Finish or undo an interrupted write; without an option, say which is possible</source>
        <translation>Achever ou annuler une écriture interrompue&#xa0;; sans option, indiquer ce qui est possible</translation>
    </message>
    <message>
        <source>Bring the complete new state about, from whatever there is now</source>
        <translation>Établir le nouvel état complet, quel que soit l&apos;état actuel</translation>
    </message>
    <message>
        <source>Bring back the complete state before the write</source>
        <translation>Rétablir l&apos;état complet d&apos;avant l&apos;écriture</translation>
    </message>
    <message>
        <source>Write the report of a record: by how much an axis became better, on one page</source>
        <translation>Écrire le rapport d&apos;une fiche&#xa0;: de combien un axe s&apos;est amélioré, sur une page</translation>
    </message>
    <message>
        <source>Record of the compensation (.axcal)</source>
        <translation>Fiche de la compensation (.axcal)</translation>
    </message>
    <message>
        <source>The report; its extension says whether it is PDF or HTML</source>
        <translation>Le rapport&#xa0;; son extension indique s&apos;il est en PDF ou HTML</translation>
    </message>
    <message>
        <source>Language of the report: en, de, fr, ja or zh</source>
        <translation>Langue du rapport&#xa0;: en, de, fr, ja ou zh</translation>
    </message>
    <message>
        <source>Add pages with every target and every value that is left out</source>
        <translation>Ajouter des pages avec chaque position cible et chaque valeur omise</translation>
    </message>
    <message>
        <source>Show what is in measurement files, join them, and write them as one CSV</source>
        <translation>Afficher le contenu de fichiers de mesure, les réunir et les écrire en un seul CSV</translation>
    </message>
    <message>
        <source>CSV file to write, replaced if it exists; - for standard output</source>
        <translation>Fichier CSV à écrire, remplacé s&apos;il existe&#xa0;; - pour la sortie standard</translation>
    </message>
    <message>
        <source>Write a machine file with all tables from running drives</source>
        <translation>Écrire un fichier machine avec toutes les tables de variateurs en service</translation>
    </message>
    <message>
        <source>Folder for machine.toml and the tables; files of the same names are replaced</source>
        <translation>Dossier pour machine.toml et les tables&#xa0;; les fichiers de mêmes noms sont remplacés</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nom de la machine</translation>
    </message>
    <message>
        <source>Applied to drives with the same serial numbers and without tables, the file gives the same state, and a snapshot of them the same bytes.</source>
        <translation>Appliqué à des variateurs de mêmes numéros de série et sans tables, le fichier donne le même état, et un snapshot de ceux-ci les mêmes octets.</translation>
    </message>
    <message>
        <source>Print the states of drives as OpenMetrics text, for a collector</source>
        <translation>Afficher l&apos;état de variateurs en texte OpenMetrics, pour un collecteur</translation>
    </message>
    <message>
        <source>Machine file: its drives, and whether they differ from it</source>
        <translation>Fichier machine&#xa0;: ses variateurs, et s&apos;ils en diffèrent</translation>
    </message>
    <message>
        <source>Compare the outputs of active compensations with their tables now</source>
        <translation>Comparer maintenant les sorties des compensations actives à leurs tables</translation>
    </message>
    <message>
        <source>File to write, whole or not at all; standard output without it</source>
        <translation>Fichier à écrire, en entier ou pas du tout&#xa0;; par défaut, la sortie standard</translation>
    </message>
    <message>
        <source>Show the compensation of an axis, and the outcome of an interrupted write</source>
        <translation>Afficher la compensation d&apos;un axe et l&apos;issue d&apos;une écriture interrompue</translation>
    </message>
    <message>
        <source>Count the drive&apos;s flash operations again after their record was damaged; first wait as long as the drive counts them</source>
        <translation>Compter de nouveau les opérations flash du variateur si leur décompte a été endommagé&#xa0;; attendre d&apos;abord aussi longtemps que le variateur les compte</translation>
    </message>
    <message>
        <source>First target</source>
        <translation>Première position cible</translation>
    </message>
    <message>
        <source>Last target, above the first</source>
        <translation>Dernière position cible, supérieure à la première</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>Nombre de positions cibles</translation>
    </message>
    <message>
        <source>Mean distance of targets, instead of --count</source>
        <translation>Espacement moyen des positions cibles, au lieu de --count</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw: targets are spread over it</source>
        <translation>Période connue de l&apos;axe, par exemple le pas de sa vis&#xa0;: les positions cibles y sont réparties</translation>
    </message>
    <message>
        <source>Runs in each direction (5 unless given)</source>
        <translation>Passes dans chaque sens (5 par défaut)</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same (1 unless given)</source>
        <translation>Un autre nombre donne d&apos;autres positions cibles, le même nombre les mêmes (1 par défaut)</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target (1 % of the range unless given, at most a third of the spacing)</source>
        <translation>Déplacement de l&apos;axe dans le sens d&apos;une passe avant sa première position cible (par défaut, 1&#xa0;% de l&apos;étendue, au plus un tiers de l&apos;espacement)</translation>
    </message>
    <message>
        <source>Feed in mm or deg per minute (1000 unless given)</source>
        <translation>Avance en mm ou degrés par minute (1000 par défaut)</translation>
    </message>
    <message>
        <source>Seconds at each target (5 unless given): time to stand still and be measured</source>
        <translation>Secondes à chaque position cible (5 par défaut)&#xa0;: temps d&apos;arrêt et de mesure</translation>
    </message>
    <message>
        <source>Choose the targets of a measurement: a plan, or a program for the machine&apos;s control</source>
        <translation>Choisir les positions cibles d&apos;une mesure&#xa0;: un plan, ou un programme pour la commande de la machine</translation>
    </message>
    <message>
        <source>Name of the axis (X unless given)</source>
        <translation>Nom de l&apos;axe (X par défaut)</translation>
    </message>
    <message>
        <source>Unit of all positions: mm (the default) or deg</source>
        <translation>Unité de toutes les positions&#xa0;: mm (par défaut) ou deg</translation>
    </message>
    <message>
        <source>Write G-code for this control: linuxcnc, fanuc or siemens</source>
        <translation>Écrire du code G pour cette commande&#xa0;: linuxcnc, fanuc ou siemens</translation>
    </message>
    <message>
        <source>List the table files of a drive</source>
        <translation>Lister les fichiers de table d&apos;un variateur</translation>
    </message>
    <message>
        <source>Upload a file unchanged and verify it, for drive programs that use tables</source>
        <translation>Envoyer un fichier tel quel et le vérifier, pour les programmes de variateur qui utilisent des tables</translation>
    </message>
    <message>
        <source>File on this computer</source>
        <translation>Fichier sur cet ordinateur</translation>
    </message>
    <message>
        <source>Path in the drive, such as tables/small1.TAMtbl</source>
        <translation>Chemin dans le variateur, par exemple tables/small1.TAMtbl</translation>
    </message>
    <message>
        <source>Download a file unchanged</source>
        <translation>Récupérer un fichier tel quel</translation>
    </message>
    <message>
        <source>Register that supplies the position of dimension 1: path, tam:// URI or address (0x1234)</source>
        <translation>Registre qui fournit la position de la dimension 1&#xa0;: chemin, URI tam:// ou adresse (0x1234)</translation>
    </message>
    <message>
        <source>The same for dimension 2</source>
        <translation>De même pour la dimension 2</translation>
    </message>
    <message>
        <source>The same for dimension 3</source>
        <translation>De même pour la dimension 3</translation>
    </message>
    <message>
        <source>The source is the axis&apos;s own position, for tables of one dimension; with --map each axis&apos;s own</source>
        <translation>La source est la position propre de l&apos;axe, pour les tables à une dimension&#xa0;; avec --map, celle de chaque axe</translation>
    </message>
    <message>
        <source>Write a compensation table to an axis in the safe order, and verify it</source>
        <translation>Écrire une table de compensation sur un axe dans l&apos;ordre sûr et la vérifier</translation>
    </message>
    <message>
        <source>Calibration file (.csv), table (.TAMtbl), or file of another controller; without it the axis keeps its table</source>
        <translation>Fichier d&apos;étalonnage (.csv), table (.TAMtbl) ou fichier d&apos;une autre commande&#xa0;; par défaut, l&apos;axe garde sa table</translation>
    </message>
    <message>
        <source>Record of a compensation in place of --data: its table is written, and it notes drive, slot and CRC</source>
        <translation>Fiche d&apos;une compensation au lieu de --data&#xa0;: sa table est écrite, et le variateur, l&apos;emplacement et le CRC y sont notés</translation>
    </message>
    <message>
        <source>Store the table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>Enregistrer la table en mémoire flash du variateur, pour qu&apos;elle survive à un redémarrage</translation>
    </message>
    <message>
        <source>Keep the table in memory until the next reboot (the default for a new table)</source>
        <translation>Garder la table en mémoire vive jusqu&apos;au prochain redémarrage (par défaut pour une nouvelle table)</translation>
    </message>
    <message>
        <source>Unit of the values in place of what the file says, such as um; drive for the drive&apos;s own</source>
        <translation>Unité des valeurs au lieu de celle du fichier, par exemple um&#xa0;; drive pour celle du variateur</translation>
    </message>
    <message>
        <source>The same for the positions</source>
        <translation>De même pour les positions</translation>
    </message>
    <message>
        <source>Slot to use, small1 to small8, large1 or large2; chosen unless given</source>
        <translation>Emplacement à utiliser, small1 à small8, large1 ou large2&#xa0;; choisi par défaut</translation>
    </message>
    <message>
        <source>Write this column of the file (name or number) to this axis; AXIS alone is the column that is named as the axis. May be given several times. Nothing is written unless all of the writes are possible</source>
        <translation>Écrire cette colonne du fichier (nom ou numéro) sur cet axe&#xa0;; AXIS seul désigne la colonne du même nom que l&apos;axe. Répétable. Rien n&apos;est écrit si toutes les écritures ne sont pas possibles</translation>
    </message>
    <message>
        <source>Write corrections above 1 % of the range, or with a slope above 0.1, which without this are taken for a wrong unit</source>
        <translation>Écrire aussi des corrections supérieures à 1&#xa0;% de l&apos;étendue ou de pente supérieure à 0,1, prises sans cette option pour une erreur d&apos;unité</translation>
    </message>
    <message>
        <source>Without --source1 the axis keeps its sources. The compensation stays off: `axiscomp activate` switches it on.</source>
        <translation>Sans --source1, l&apos;axe garde ses sources. La compensation reste désactivée&#xa0;: `axiscomp activate` l&apos;active.</translation>
    </message>
    <message>
        <source>Axis that the values correct, for each column or for all: its name, #1 for the first source, or other for an axis that is no source; by default as the file says</source>
        <translation>Axe que les valeurs corrigent, par colonne ou pour toutes&#xa0;: son nom, #1 pour la première source, ou other pour un axe qui n&apos;est pas une source&#xa0;; par défaut, selon le fichier</translation>
    </message>
    <message>
        <source>Conversion</source>
        <translation>Conversion</translation>
    </message>
    <message>
        <source>Convention of the input: feedback (added to the encoder position) or command (added to the commanded position); by default that of its format, needed where that is assumed</source>
        <translation>Convention de l&apos;entrée&#xa0;: feedback (valeurs ajoutées à la position du codeur) ou command (valeurs ajoutées à la position de consigne)&#xa0;; par défaut, celle de son format, à indiquer si elle n&apos;est que supposée</translation>
    </message>
    <message>
        <source>Which values to use if the file has both directions of motion: mean, positive or negative</source>
        <translation>Valeurs à utiliser si le fichier contient les deux sens de déplacement&#xa0;: mean, positive ou negative</translation>
    </message>
    <message>
        <source>Multiply the values by this number, before anything else</source>
        <translation>Multiplier les valeurs par ce nombre, avant toute autre opération</translation>
    </message>
    <message>
        <source>Add this to the values, in their unit</source>
        <translation>Ajouter ceci aux valeurs, dans leur unité</translation>
    </message>
    <message>
        <source>Shift the values so that they are 0 at this position</source>
        <translation>Décaler les valeurs pour qu&apos;elles vaillent 0 à cette position</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a linear one</source>
        <translation>Traiter un axe modulo comme linéaire</translation>
    </message>
    <message>
        <source>Resample onto an even grid with N points, for each source or for all</source>
        <translation>Rééchantillonner sur une grille régulière de N points, par source ou pour toutes</translation>
    </message>
    <message>
        <source>Resample onto an even grid with spacing D, for each source or for all</source>
        <translation>Rééchantillonner sur une grille régulière de pas D, par source ou pour toutes</translation>
    </message>
    <message>
        <source>Resample onto the coarsest even grid within this deviation, in the unit of the values</source>
        <translation>Rééchantillonner sur la grille régulière la moins fine dans cet écart, dans l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>Between the points of the source: linear (the default), cubic (monotone), spline (natural cubic) or smooth (smoothing spline)</source>
        <translation>Entre les points de la source&#xa0;: linear (par défaut), cubic (monotone), spline (cubique naturelle) ou smooth (spline de lissage)</translation>
    </message>
    <message>
        <source>Speed of the axis in positions per second: says the steps of the velocity that are left with spline and smooth</source>
        <translation>Vitesse de l&apos;axe en unités de position par seconde&#xa0;: indique les sauts de vitesse qui restent avec spline et smooth</translation>
    </message>
    <message>
        <source>Let the even grid extend beyond the data, where the end values are held</source>
        <translation>Laisser la grille régulière s&apos;étendre au-delà des données, où les valeurs d&apos;extrémité sont maintenues</translation>
    </message>
    <message>
        <source>Convention of the output: feedback or command; by default that of its format, needed where that is assumed</source>
        <translation>Convention de la sortie&#xa0;: feedback ou command&#xa0;; par défaut, celle de son format, à indiquer si elle n&apos;est que supposée</translation>
    </message>
    <message>
        <source>Setting that the output format needs; `axiscomp formats NAME` lists them</source>
        <translation>Réglage que demande le format de sortie&#xa0;; `axiscomp formats NAME` en donne la liste</translation>
    </message>
    <message>
        <source>Corrections, made only when asked for</source>
        <translation>Corrections, seulement sur demande</translation>
    </message>
    <message>
        <source>Temperature of the axis&apos;s scale in C</source>
        <translation>Température de la règle de l&apos;axe en °C</translation>
    </message>
    <message>
        <source>Coefficient of expansion of the axis&apos;s scale in 1/K, such as 11.5e-6</source>
        <translation>Coefficient de dilatation de la règle de l&apos;axe en 1/K, par exemple 11.5e-6</translation>
    </message>
    <message>
        <source>Temperature of the reference in C</source>
        <translation>Température de la référence en °C</translation>
    </message>
    <message>
        <source>Coefficient of the reference in 1/K; 0 for a laser with wavelength compensation</source>
        <translation>Coefficient de dilatation de la référence en 1/K&#xa0;; 0 pour un laser compensé en longueur d&apos;onde</translation>
    </message>
    <message>
        <source>Position in mm that does not move with temperature; the first target unless given</source>
        <translation>Position en mm que la température ne déplace pas&#xa0;; par défaut, la première position cible</translation>
    </message>
    <message>
        <source>The values are not corrected to 20 C, where the file does not say it</source>
        <translation>Les valeurs ne sont pas corrigées à 20 °C, si le fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>Dead path of the interferometer: a JSON file with its length and the air of each run</source>
        <translation>Trajet mort de l&apos;interféromètre&#xa0;: un fichier JSON avec sa longueur et l&apos;air de chaque passe</translation>
    </message>
    <message>
        <source>Limits, such as A=10um,R=4um; exit code 8 when one is not met</source>
        <translation>Limites, par exemple A=10um,R=4um&#xa0;; code de retour 8 si l&apos;une n&apos;est pas respectée</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms</source>
        <translation>Incertitude de mesure avec k = 2&#xa0;: U=2.1um, ou un fichier JSON avec ses composantes</translation>
    </message>
    <message>
        <source>Measurement files, joined when there are several; - for standard input</source>
        <translation>Fichiers de mesure, réunis s&apos;il y en a plusieurs&#xa0;; - pour l&apos;entrée standard</translation>
    </message>
    <message>
        <source>Format of the files, if their content leaves it open</source>
        <translation>Format des fichiers, si leur contenu ne le détermine pas</translation>
    </message>
    <message>
        <source>Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>Omettre des valeurs&#xa0;: down:1:1 (sens, position cible, passe), run:up:3 ou target:7, séparées par des virgules</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>Permuter les deux sens</translation>
    </message>
    <message>
        <source>What a file leaves open</source>
        <translation>Ce qu&apos;un fichier n&apos;indique pas</translation>
    </message>
    <message>
        <source>Which column of a CSV file is what, by number or name: &apos;target=1,direction=3,deviation=5&apos;</source>
        <translation>Rôle de chaque colonne d&apos;un fichier CSV, par numéro ou par nom&#xa0;: &apos;target=1,direction=3,deviation=5&apos;</translation>
    </message>
    <message>
        <source>Lines before the header of a CSV file</source>
        <translation>Lignes avant l&apos;en-tête d&apos;un fichier CSV</translation>
    </message>
    <message>
        <source>Unit of targets and encoder</source>
        <translation>Unité des positions cibles et du codeur</translation>
    </message>
    <message>
        <source>Unit of deviations and reference</source>
        <translation>Unité des écarts et de la référence</translation>
    </message>
    <message>
        <source>What the values are: deviation (reference minus target) or reference (positions)</source>
        <translation>Nature des valeurs&#xa0;: deviation (référence moins position cible) ou reference (positions)</translation>
    </message>
    <message>
        <source>order: the direction of a run follows from the order of its targets</source>
        <translation>order&#xa0;: le sens d&apos;une passe découle de l&apos;ordre de ses positions cibles</translation>
    </message>
    <message>
        <source>How far a track moves after a turn before its samples count, in mm or deg; 1 % of the range unless given</source>
        <translation>Déplacement d&apos;un relevé continu après une inversion avant que ses échantillons comptent, en mm ou degrés&#xa0;; par défaut, 1&#xa0;% de l&apos;étendue</translation>
    </message>
    <message>
        <source>Number of dimensions of a CSV file: its first D columns are positions</source>
        <translation>Nombre de dimensions d&apos;un fichier CSV&#xa0;: ses D premières colonnes sont des positions</translation>
    </message>
    <message>
        <source>Format of the input, if content and name leave it open</source>
        <translation>Format de l&apos;entrée, si son contenu et son nom ne le déterminent pas</translation>
    </message>
    <message>
        <source>Setting that the file leaves open; `axiscomp formats NAME` lists them</source>
        <translation>Réglage que le fichier n&apos;indique pas&#xa0;; `axiscomp formats NAME` en donne la liste</translation>
    </message>
    <message>
        <source>Incomplete grids</source>
        <translation>Grilles incomplètes</translation>
    </message>
    <message>
        <source>Give points without a value that of the nearest measured point (nearest), of the plane through all of them (plane), or the values that bend least (smooth)</source>
        <translation>Donner aux points sans valeur celle du point mesuré le plus proche (nearest), celle du plan passant par tous les points (plane) ou les valeurs de courbure minimale (smooth)</translation>
    </message>
    <message>
        <source>Cut the grid to the largest part in which every point has a value</source>
        <translation>Réduire la grille à la plus grande partie où chaque point a une valeur</translation>
    </message>
    <message>
        <source>Take positions of a calibration file that are this close to the grid for grid positions, in their unit</source>
        <translation>Accrocher à la grille les positions d&apos;un fichier d&apos;étalonnage qui en sont aussi proches, dans leur unité</translation>
    </message>
    <message>
        <source>Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either); not needed if there is only one</source>
        <translation>Table du fichier, par nom ou par numéro à partir de 1 (name:TEXT, #N en cas d&apos;ambiguïté)&#xa0;; inutile s&apos;il n&apos;y en a qu&apos;une</translation>
    </message>
    <message>
        <source>Drive profile (JSON) in place of the built-in one, generic</source>
        <translation>Profil de variateur (JSON) au lieu du profil intégré, generic</translation>
    </message>
    <message>
        <source>Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given</source>
        <translation>Adresse du variateur, répétable&#xa0;; par défaut, $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Address of the drive; $AXISCOMP_DRIVE unless given</source>
        <translation>Adresse du variateur&#xa0;; par défaut, $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Trust the https certificate with this fingerprint from now on; any other one is refused</source>
        <translation>Accepter désormais le certificat https de cette empreinte&#xa0;; tout autre est refusé</translation>
    </message>
    <message>
        <source>Time limit for one exchange with the drive (5 unless given)</source>
        <translation>Délai maximal d&apos;un échange avec le variateur (5 par défaut)</translation>
    </message>
    <message>
        <source>Index or name of the axis; not needed if the drive has only one</source>
        <translation>Indice ou nom de l&apos;axe&#xa0;; inutile si le variateur n&apos;en a qu&apos;un</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Options</translation>
    </message>
    <message>
        <source>Show this help</source>
        <translation>Afficher cette aide</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Arguments</translation>
    </message>
    <message>
        <source>options</source>
        <translation>options</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMAND</translation>
    </message>
    <message>
        <source>usage</source>
        <translation>utilisation</translation>
    </message>
    <message>
        <source>Serve the drive&apos;s web pages here; port 0 picks a free one (127.0.0.1:0 unless this or --serial is given). Several drives take ports in a row</source>
        <translation>Servir ici les pages web du variateur&#xa0;; le port 0 en choisit un libre (127.0.0.1:0, sauf si cette option ou --serial est indiquée). Plusieurs variateurs prennent des ports consécutifs</translation>
    </message>
    <message>
        <source>Serve the serial link on a pseudo-terminal, and make LINK a symbolic link to it. Several drives take LINK, LINK-2, ...</source>
        <translation>Servir la liaison série sur un pseudo-terminal et faire de LINK un lien symbolique vers lui. Plusieurs variateurs prennent LINK, LINK-2, ...</translation>
    </message>
    <message>
        <source>Make the serial link as slow as a line of this speed (as fast as it can unless given)</source>
        <translation>Rendre la liaison série aussi lente qu&apos;une ligne de ce débit (par défaut, aussi rapide que possible)</translation>
    </message>
    <message>
        <source>Name of the drive (Virtual-1 unless given)</source>
        <translation>Nom du variateur (Virtual-1 par défaut)</translation>
    </message>
    <message>
        <source>Number of axes, 1 to 16 (2 unless given)</source>
        <translation>Nombre d&apos;axes, de 1 à 16 (2 par défaut)</translation>
    </message>
    <message>
        <source>Take names, axes and parameters from a TAM configuration; several drives in it are several virtual drives</source>
        <translation>Prendre les noms, les axes et les paramètres d&apos;une configuration TAM&#xa0;; plusieurs variateurs y donnent plusieurs variateurs virtuels</translation>
    </message>
    <message>
        <source>Move the machine of this file (JSON): axes with errors that nobody knows, and an instrument that measures them</source>
        <translation>Déplacer la machine de ce fichier (JSON)&#xa0;: des axes avec des erreurs que personne ne connaît, et un instrument qui les mesure</translation>
    </message>
    <message>
        <source>Play this measuring plan (axiscomp targets) as the machine&apos;s control would, from 10 s after the start</source>
        <translation>Exécuter ce plan de mesure (axiscomp targets) comme le ferait la commande de la machine, à partir de 10 s après le démarrage</translation>
    </message>
    <message>
        <source>Begin the program so many seconds after the start, whatever --speed is; unless given, after 10 s of the machine&apos;s time</source>
        <translation>Commencer le programme tant de secondes après le démarrage, quel que soit --speed&#xa0;; par défaut, après 10 s du temps de la machine</translation>
    </message>
    <message>
        <source>Serve the instrument&apos;s lines on a pseudo-terminal, and make LINK a symbolic link to it</source>
        <translation>Servir les lignes de l&apos;instrument sur un pseudo-terminal et faire de LINK un lien symbolique vers lui</translation>
    </message>
    <message>
        <source>Keep flash and saved parameters here across runs, a folder per drive</source>
        <translation>Conserver ici la mémoire flash et les paramètres enregistrés d&apos;une exécution à l&apos;autre, un dossier par variateur</translation>
    </message>
    <message>
        <source>Misbehave: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, reboot-after=N or reject=CODE; may be given several times</source>
        <translation>Mal fonctionner&#xa0;: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, reboot-after=N ou reject=CODE&#xa0;; répétable</translation>
    </message>
    <message>
        <source>Simulated seconds per second (1 unless given)</source>
        <translation>Secondes simulées par seconde (1 par défaut)</translation>
    </message>
    <message>
        <source>Start with axes that are not homed</source>
        <translation>Démarrer avec des axes sans origine prise</translation>
    </message>
    <message>
        <source>Ask for this user name</source>
        <translation>Demander ce nom d&apos;utilisateur</translation>
    </message>
    <message>
        <source>File whose first line is the password of --user</source>
        <translation>Fichier dont la première ligne est le mot de passe de --user</translation>
    </message>
    <message>
        <source>Serve https with this certificate</source>
        <translation>Servir https avec ce certificat</translation>
    </message>
    <message>
        <source>Private key of --certificate</source>
        <translation>Clé privée de --certificate</translation>
    </message>
    <message>
        <source>A servo drive in software, with the web pages, registers and behaviour of a real one.</source>
        <translation>Un servovariateur logiciel, avec les pages web, les registres et le comportement d&apos;un variateur réel.</translation>
    </message>
    <message>
        <source>Prints a line `ready http=URL serial=DEVICE drive=NAME` for each drive, and runs until Ctrl-C.</source>
        <translation>Écrit une ligne `ready http=URL serial=DEVICE drive=NAME` par variateur et fonctionne jusqu&apos;à Ctrl-C.</translation>
    </message>
    <message>
        <source>Use this drive in place of the remembered ones; may be given several times: http://[user:password@]host[:port], https://..., serial:/dev/ttyUSB0[?baud=N], demo:</source>
        <translation>Utiliser ce variateur au lieu de ceux mémorisés&#xa0;; répétable&#xa0;: http://[utilisateur:motdepasse@]hôte[:port], https://..., serial:/dev/ttyUSB0[?baud=N], demo:</translation>
    </message>
    <message>
        <source>Open this file of compensation data</source>
        <translation>Ouvrir ce fichier de données de compensation</translation>
    </message>
    <message>
        <source>How long one exchange with a drive may take (5 unless given)</source>
        <translation>Durée maximale d&apos;un échange avec un variateur (5 par défaut)</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to servo drives, in a window.</source>
        <translation>Écrit des tables de compensation des erreurs d&apos;axe mesurées dans des servovariateurs, dans une fenêtre.</translation>
    </message>
    <message>
        <source>Without --drive it uses the drives of the last time, or the built-in demo drive.</source>
        <translation>Sans --drive, les variateurs de la dernière fois sont utilisés, ou le variateur de démonstration intégré.</translation>
    </message>
    <message>
        <source>Let the drive look up the table without adding its values</source>
        <translation>Laisser le variateur consulter la table sans ajouter ses valeurs</translation>
    </message>
    <message>
        <source>Activate the compensation, and compare the drive&apos;s output with the table</source>
        <translation>Activer la compensation et comparer la sortie du variateur à la table</translation>
    </message>
    <message>
        <source>Deactivate the compensation</source>
        <translation>Désactiver la compensation</translation>
    </message>
    <message>
        <source>Store the axis&apos;s table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>Enregistrer la table de l&apos;axe dans la mémoire flash du variateur&#xa0;: elle survit à un redémarrage</translation>
    </message>
    <message>
        <source>Make the axis&apos;s table volatile, so that it is lost at the next reboot</source>
        <translation>Rendre volatile la table de l&apos;axe&#xa0;: elle est perdue au prochain redémarrage</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Cet ordinateur</translation>
    </message>
    <message>
        <source>Show what this computer has and lacks, and what each known drive answers</source>
        <translation>Montrer ce que cet ordinateur a, ce qui lui manque, et ce que répond chaque variateur connu</translation>
    </message>
    <message>
        <source>Time limit for all that a drive is asked (5 unless given)</source>
        <translation>Délai maximal de toutes les questions posées à un variateur (5 par défaut)</translation>
    </message>
    <message>
        <source>The connections of the window are asked too. Nothing is changed, on this computer or on a drive. What is printed has no passwords in it and is meant to be sent to whoever helps.</source>
        <translation>Les connexions de la fenêtre sont interrogées aussi. Rien n&apos;est modifié, ni sur cet ordinateur ni sur un variateur. Ce qui est affiché ne contient aucun mot de passe et est destiné à la personne qui aide.</translation>
    </message>
    <message>
        <source>Open this file: a record (.axcal), a machine file (.toml), a TAM configuration (.TAMcfg), a table or a measurement</source>
        <translation>Ouvrir ce fichier&#xa0;: une fiche (.axcal), un fichier machine (.toml), une configuration TAM (.TAMcfg), une table ou une mesure</translation>
    </message>
    <message>
        <source>Measurement before and measurement after; with a record, which has the first, the second alone is enough</source>
        <translation>Mesure avant et mesure après&#xa0;; avec une fiche, qui contient la première, la seconde suffit</translation>
    </message>
    <message>
        <source>Leave values of the second measurement out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>Omettre des valeurs de la seconde mesure&#xa0;: down:1:1 (sens, position cible, passe), run:up:3 ou target:7, séparées par des virgules</translation>
    </message>
    <message>
        <source>Record of the compensation: the first measurement with its exclusions and corrections, prediction, table and tolerances</source>
        <translation>Fiche de la compensation&#xa0;: la première mesure avec ses exclusions et corrections, la prévision, la table et les tolérances</translation>
    </message>
    <message>
        <source>Where the drive looks its table up (the input or the output, whichever is the drive&apos;s): encoder (before the compensation) or set (after it); by default as the file says, or encoder</source>
        <translation>Où le variateur consulte sa table (l&apos;entrée ou la sortie, selon celle qui est au variateur)&#xa0;: encoder (avant compensation) ou set (après)&#xa0;; par défaut selon le fichier, sinon encoder</translation>
    </message>
</context>
<context>
    <name>JudgeOutlook</name>
    <message>
        <source>%1: not defined, so that the tolerance %2 cannot be met.</source>
        <translation>%1&#xa0;: non défini, la tolérance %2 ne peut donc pas être respectée.</translation>
    </message>
    <message>
        <source>%1: %2, nearer to the tolerance %3 than the uncertainty. That is undecided.</source>
        <translation>%1&#xa0;: %2, plus proche de la tolérance %3 que l&apos;incertitude de mesure. C&apos;est indéterminé.</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. Go on to Fit: a table may make it smaller.</source>
        <translation>%1&#xa0;: %2, au-dessus de la tolérance %3. Passer à Ajuster&#xa0;: une table peut améliorer cette valeur.</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. No table makes it smaller: look at the mechanics.</source>
        <translation>%1&#xa0;: %2, au-dessus de la tolérance %3. Aucune table n&apos;améliore cette valeur&#xa0;: examiner la mécanique.</translation>
    </message>
    <message>
        <source>Add the files of a measurement on the tab Measure.</source>
        <translation>Ajouter les fichiers d&apos;une mesure dans l&apos;onglet Mesurer.</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>Lecture des fichiers …</translation>
    </message>
    <message>
        <source>A file cannot be used: the tab Measure says why.</source>
        <translation>Un fichier n&apos;est pas utilisable&#xa0;: l&apos;onglet Mesurer en donne la raison.</translation>
    </message>
    <message>
        <source>This measurement has no targets, and so no figures of ISO 230-2. Go on to Fit, or measure at targets.</source>
        <translation>Cette mesure n&apos;a pas de positions cibles, donc pas de caractéristiques selon l&apos;ISO 230-2. Passer à Ajuster ou mesurer à des positions cibles.</translation>
    </message>
    <message>
        <source>Enter the tolerances of the axis, or go on to Fit.</source>
        <translation>Saisir les tolérances de l&apos;axe ou passer à Ajuster.</translation>
    </message>
    <message>
        <source>Every tolerance is met. A table can still make the axis better: go on to Fit.</source>
        <translation>Toutes les tolérances sont respectées. Une table peut encore améliorer l&apos;axe&#xa0;: passer à Ajuster.</translation>
    </message>
    <message>
        <source>The standard&apos;s condition “%1” is not met.</source>
        <translation>La condition «&#xa0;%1&#xa0;» de la norme n&apos;est pas remplie.</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>Dimensionnalité</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistance</translation>
    </message>
    <message>
        <source>Dim{n}Source</source>
        <translation>Source Dim{n}</translation>
    </message>
    <message>
        <source>problem</source>
        <translation>problème</translation>
    </message>
    <message>
        <source>has all of this</source>
        <translation>a tout cela</translation>
    </message>
    <message>
        <source>unfinished write</source>
        <translation>écriture interrompue</translation>
    </message>
    <message>
        <source>Activation</source>
        <translation>Activation</translation>
    </message>
    <message>
        <source>differs: {fields}</source>
        <translation>diffère&#xa0;: {fields}</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>written and switched</source>
        <translation>écrit et commuté</translation>
    </message>
    <message>
        <source>written</source>
        <translation>écrit</translation>
    </message>
    <message>
        <source>switched</source>
        <translation>commuté</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>rien à faire</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>non écrit</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>aucune table</translation>
    </message>
    <message>
        <source>{slot}, empty</source>
        <translation>{slot}, vide</translation>
    </message>
    <message>
        <source>{slot}, persistent, CRC {crc}</source>
        <translation>{slot}, persistante, CRC {crc}</translation>
    </message>
    <message>
        <source>{slot}, volatile, CRC {crc}</source>
        <translation>{slot}, volatile, CRC {crc}</translation>
    </message>
    <message>
        <source>switched, not written</source>
        <translation>commuté, non écrit</translation>
    </message>
    <message>
        <source>written, not switched</source>
        <translation>écrit, non commuté</translation>
    </message>
    <message>
        <source>not switched</source>
        <translation>non commuté</translation>
    </message>
    <message>
        <source>{outcome}, proved</source>
        <translation>{outcome}, validé</translation>
    </message>
    <message>
        <source>{outcome}, not proved</source>
        <translation>{outcome}, non validé</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>the file states the temperature</source>
        <translation>le fichier indique la température</translation>
    </message>
    <message>
        <source>the file states the instrument</source>
        <translation>le fichier indique l&apos;instrument</translation>
    </message>
    <message>
        <source>the file states the feed</source>
        <translation>le fichier indique l&apos;avance</translation>
    </message>
    <message>
        <source>the file states the dwell</source>
        <translation>le fichier indique la temporisation</translation>
    </message>
    <message>
        <source>at least {due} targets over {range}: {count}</source>
        <translation>au moins {due} positions cibles sur {range}&#xa0;: {count}</translation>
    </message>
    <message>
        <source>a target about every 250 mm on an axis above 2 m: {count} over {range}, at most {gap} apart</source>
        <translation>une position cible environ tous les 250 mm pour un axe de plus de 2 m&#xa0;: {count} sur {range}, espacées de {gap} au plus</translation>
    </message>
    <message>
        <source>at least 5 targets, and 5 for each metre: {count} over {range}</source>
        <translation>au moins 5 positions cibles, et 5 par mètre&#xa0;: {count} sur {range}</translation>
    </message>
    <message>
        <source>a run in each direction on an axis above 2 m, for E, B and M alone: {count}</source>
        <translation>une passe dans chaque sens pour un axe de plus de 2 m, pour E, B et M seulement&#xa0;: {count}</translation>
    </message>
    <message>
        <source>5 runs in each direction: the file has means</source>
        <translation>5 passes dans chaque sens&#xa0;: le fichier contient des moyennes</translation>
    </message>
    <message>
        <source>5 runs in each direction: {count} at the target with the fewest</source>
        <translation>5 passes dans chaque sens&#xa0;: {count} à la position cible qui en a le moins</translation>
    </message>
    <message>
        <source>every target is approached in both directions</source>
        <translation>chaque position cible est abordée dans les deux sens</translation>
    </message>
    <message>
        <source>the targets are not all at the same place of the period {period}</source>
        <translation>les positions cibles ne sont pas toutes au même endroit de la période {period}</translation>
    </message>
    <message>
        <source>reversal value B</source>
        <translation>valeur d&apos;inversion B</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <translation>valeur d&apos;inversion moyenne</translation>
    </message>
    <message>
        <source>range of the mean deviation M</source>
        <translation>étendue de l&apos;écart moyen M</translation>
    </message>
    <message>
        <source>systematic deviation E, up</source>
        <translation>écart systématique E, sens positif</translation>
    </message>
    <message>
        <source>systematic deviation E, down</source>
        <translation>écart systématique E, sens négatif</translation>
    </message>
    <message>
        <source>systematic deviation E</source>
        <translation>écart systématique E</translation>
    </message>
    <message>
        <source>repeatability R, up</source>
        <translation>répétabilité R, sens positif</translation>
    </message>
    <message>
        <source>repeatability R, down</source>
        <translation>répétabilité R, sens négatif</translation>
    </message>
    <message>
        <source>repeatability R</source>
        <translation>répétabilité R</translation>
    </message>
    <message>
        <source>accuracy A, up</source>
        <translation>exactitude A, sens positif</translation>
    </message>
    <message>
        <source>accuracy A, down</source>
        <translation>exactitude A, sens négatif</translation>
    </message>
    <message>
        <source>accuracy A</source>
        <translation>exactitude A</translation>
    </message>
    <message>
        <source>the runs {direction} drift by {drift} from the first to the last, more than their spread explains</source>
        <translation>les passes en {direction} dérivent de {drift} de la première à la dernière, plus que leur dispersion ne l&apos;explique</translation>
    </message>
    <message>
        <source>more than a fifth of the values {direction} do not fit the others: the measurement was disturbed, and nothing is proposed</source>
        <translation>plus d&apos;un cinquième des valeurs en {direction} ne concordent pas avec les autres&#xa0;: la mesure a été perturbée, et rien n&apos;est proposé</translation>
    </message>
    <message numerus="yes">
        <source>{count} values excluded, not an evaluation by ISO 230-2</source>
        <comment>1 value excluded, not an evaluation by ISO 230-2</comment>
        <translation>
            <numerusform>{count} valeur exclue, pas une évaluation selon l&apos;ISO 230-2</numerusform>
            <numerusform>{count} valeurs exclues, pas une évaluation selon l&apos;ISO 230-2</numerusform>
        </translation>
    </message>
    <message>
        <source>the file says {figure} = {published}</source>
        <translation>le fichier indique {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}, which is less than its own {figure} = {published}</source>
        <translation>{statement}, soit moins que son propre {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}; computed from its values: {computed}</source>
        <translation>{statement}&#xa0;; calculé à partir de ses valeurs&#xa0;: {computed}</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>conforme</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>non conforme</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>indéterminé</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>non défini</translation>
    </message>
    <message>
        <source>means of runs</source>
        <translation>des moyennes de passes</translation>
    </message>
    <message>
        <source>a track without targets</source>
        <translation>un relevé continu sans positions cibles</translation>
    </message>
    <message>
        <source>points of a plane or space</source>
        <translation>des points d&apos;un plan ou de l&apos;espace</translation>
    </message>
    <message>
        <source>runs over targets</source>
        <translation>des passes sur des positions cibles</translation>
    </message>
    <message>
        <source>up</source>
        <translation>sens positif</translation>
    </message>
    <message>
        <source>down</source>
        <translation>sens négatif</translation>
    </message>
    <message>
        <source>a slope of {slope} over {length} was taken out</source>
        <translation>une pente de {slope} sur {length} a été retirée</translation>
    </message>
    <message>
        <source>the steepest part of {table} is between {from} and {to}: {step}, {slope} for each {one}</source>
        <translation>{table} est le plus raide entre {from} et {to}&#xa0;: {step}, soit {slope} par {one}</translation>
    </message>
    <message>
        <source>a drive holds numbers with 24 bits, which changes a value of {table} by at most {rounding}</source>
        <translation>un variateur conserve les nombres sur 24 bits, ce qui modifie une valeur de {table} de {rounding} au plus</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of {table} have nothing measured beside them and were filled</source>
        <comment>1 point of {table} has nothing measured beside it and was filled</comment>
        <translation>
            <numerusform>{count} point de {table} n&apos;a aucune mesure à côté de lui et a été rempli</numerusform>
            <numerusform>{count} points de {table} n&apos;ont aucune mesure à côté d&apos;eux et ont été remplis</numerusform>
        </translation>
    </message>
    <message>
        <source>merged onto {name} with gain {gain}: a value changes by at most {change}, at {place}</source>
        <translation>fusion avec {name}, gain {gain}&#xa0;: une valeur varie de {change} au plus, à {place}</translation>
    </message>
    <message>
        <source>the table improves little: {figure} from {before} to {after}, less than a fifth</source>
        <translation>la table améliore peu&#xa0;: {figure} de {before} à {after}, moins d&apos;un cinquième</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}; measure at more targets</source>
        <translation>entre les positions cibles, l&apos;erreur n&apos;est pas assez bien connue&#xa0;: prévu sans chaque position cible, M vaut {heldOut}&#xa0;; mesurer à plus de positions cibles</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>entre les positions cibles, l&apos;erreur n&apos;est pas assez bien connue&#xa0;: prévu sans chaque position cible, M vaut {heldOut}, contre {before} avant&#xa0;; mesurer à plus de positions cibles</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: up to {reversal} remains in each direction</source>
        <translation>l&apos;essentiel de cette erreur est dû à l&apos;inversion, qu&apos;aucune table ne supprime&#xa0;: il reste jusqu&apos;à {reversal} dans chaque sens</translation>
    </message>
    <message>
        <source>the table is for both directions: up to {reversal} of the reversal remains in each</source>
        <translation>la table vaut pour les deux sens&#xa0;: il reste jusqu&apos;à {reversal} de l&apos;inversion dans chacun</translation>
    </message>
    <message>
        <source>the table is for one direction: in the other up to {reversal} of reversal remains</source>
        <translation>la table vaut pour un sens&#xa0;: dans l&apos;autre, il reste jusqu&apos;à {reversal} d&apos;inversion</translation>
    </message>
    <message>
        <source>{count} targets lie in {turns} periods of {period}</source>
        <translation>{count} positions cibles couvrent {turns} périodes de {period}</translation>
    </message>
    <message>
        <source>{table} adds {value} at the home position {home}</source>
        <translation>{table} ajoute {value} à la position d&apos;origine {home}</translation>
    </message>
    <message>
        <source>over a turn, from {from} to {to}, {table} ends {jump} above where it begins</source>
        <translation>sur un tour, de {from} à {to}, {table} finit {jump} au-dessus de son début</translation>
    </message>
    <message>
        <source>the compensation off</source>
        <translation>la compensation désactivée</translation>
    </message>
    <message>
        <source>the compensation on</source>
        <translation>la compensation activée</translation>
    </message>
    <message>
        <source>the table {crc} active</source>
        <translation>la table {crc} active</translation>
    </message>
    <message>
        <source>measured with the table {crc} of {name} active</source>
        <translation>mesuré avec la table {crc} de {name} active</translation>
    </message>
    <message>
        <source>measured with {name} active ({known})</source>
        <translation>mesuré avec {name} active ({known})</translation>
    </message>
    <message>
        <source>the measurement does not say which table was active; {name} ({known}) is taken to have been</source>
        <translation>la mesure n&apos;indique pas quelle table était active&#xa0;; {name} ({known}) est supposée l&apos;avoir été</translation>
    </message>
    <message>
        <source>the raw positions of the encoder are on file: the table is made of reference minus encoder, whatever compensation was active</source>
        <translation>les positions brutes du codeur sont dans le fichier&#xa0;: la table est établie par référence moins codeur, quelle que soit la compensation active</translation>
    </message>
    <message>
        <source>measured with the compensation off</source>
        <translation>mesuré avec la compensation désactivée</translation>
    </message>
    <message>
        <source>{table} explains {share} % of the variance of {count} values; {rms} rms remains</source>
        <translation>{table} explique {share}&#xa0;% de la variance de {count} valeurs&#xa0;; il reste {rms} RMS</translation>
    </message>
    <message>
        <source>{table} explains little: values that were left out are foretold with {left} rms, and they are {values} rms themselves</source>
        <translation>{table} explique peu&#xa0;: les valeurs omises sont prévues à {left} RMS près, alors qu&apos;elles valent elles-mêmes {values} RMS</translation>
    </message>
    <message numerus="yes">
        <source>{count} values lie outside the grid and were left out</source>
        <comment>1 value lies outside the grid and was left out</comment>
        <translation>
            <numerusform>{count} valeur est hors de la grille et a été omise</numerusform>
            <numerusform>{count} valeurs sont hors de la grille et ont été omises</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is point {first}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: point {first}, {residual} off</comment>
        <translation>
            <numerusform>{count} valeur de {table} ne concorde pas avec les autres et compte peu&#xa0;: point {first}, écart de {residual}</numerusform>
            <numerusform>{count} valeurs de {table} ne concordent pas avec les autres et comptent peu&#xa0;; la première est le point {first}, écart de {residual}</numerusform>
        </translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} less than 90 degrees</source>
        <translation>l&apos;angle entre {first} et {second} est inférieur de {angle} à 90 degrés</translation>
    </message>
    <message>
        <source>a scale of {scale} for each {length} was taken out; the mean scale error of the axes is in it, and stays in the machine</source>
        <translation>un facteur d&apos;échelle de {scale} par {length} a été retiré&#xa0;; il comprend l&apos;erreur d&apos;échelle moyenne des axes, qui reste dans la machine</translation>
    </message>
    <message>
        <source>{axis} {position}</source>
        <translation>{axis} {position}</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; the drive will add {added}</source>
        <translation>à {position}, la référence était à {measured} du codeur dans {table}&#xa0;; le variateur ajoutera {added}</translation>
    </message>
    <message>
        <source>how well the error between the targets is known cannot be told: {reason}</source>
        <translation>impossible de dire si l&apos;erreur entre les positions cibles est bien connue&#xa0;: {reason}</translation>
    </message>
    <message>
        <source>at {speed} the velocity jumps by at most {step} at a point of the table</source>
        <translation>à {speed}, la vitesse fait un saut de {step} au plus en un point de la table</translation>
    </message>
    <message>
        <source>{count} points of {table} with straight lines between them are at most {distance} off the curve, at {place}</source>
        <translation>{count} points de {table} reliés par des droites sont à {distance} au plus de la courbe, à {place}</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; the drive will add {added}</comment>
        <translation>
            <numerusform>là où le codeur indique {reading}, la référence indiquait {reference}, mesuré {count} fois&#xa0;; le variateur ajoutera {added}</numerusform>
            <numerusform>là où le codeur indique {reading}, la référence indiquait {reference} en moyenne de {count} valeurs&#xa0;; le variateur ajoutera {added}</numerusform>
        </translation>
    </message>
    <message>
        <source>the error is {factor} times what it was before: the table has the wrong sign</source>
        <translation>l&apos;erreur vaut {factor} fois celle d&apos;avant&#xa0;: la table a le mauvais signe</translation>
    </message>
    <message>
        <source>the error is the same as before: the compensation was not active, or another axis was measured</source>
        <translation>l&apos;erreur est la même qu&apos;avant&#xa0;: la compensation n&apos;était pas active, ou un autre axe a été mesuré</translation>
    </message>
    <message>
        <source>what is left is {factor} times the error before: the table adds {share} times what it should; look at the units of measurement and table</source>
        <translation>ce qui reste vaut {factor} fois l&apos;erreur d&apos;avant&#xa0;: la table ajoute {share} fois ce qu&apos;elle devrait&#xa0;; vérifier les unités de la mesure et de la table</translation>
    </message>
    <message>
        <source>what is left resembles neither the error before nor its slope: the machine was in another state, such as another temperature or load, or it is another axis</source>
        <translation>ce qui reste ne ressemble ni à l&apos;erreur d&apos;avant ni à sa pente&#xa0;: la machine était dans un autre état, par exemple de température ou de charge, ou c&apos;est un autre axe</translation>
    </message>
    <message>
        <source>what is left follows the slope of the error before: the table is shifted by about {shift} against the axis; look at the home position and the source of the table</source>
        <translation>ce qui reste suit la pente de l&apos;erreur d&apos;avant&#xa0;: la table est décalée d&apos;environ {shift} par rapport à l&apos;axe&#xa0;; vérifier la position d&apos;origine et la source de la table</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>met</source>
        <translation>remplie</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>non remplie</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others: look at them, and exclude them or leave them in</source>
        <comment>1 value does not fit the others: look at it, and exclude it or leave it in</comment>
        <translation>
            <numerusform>{count} valeur ne concorde pas avec les autres&#xa0;: l&apos;examiner, puis l&apos;exclure ou la garder</numerusform>
            <numerusform>{count} valeurs ne concordent pas avec les autres&#xa0;: les examiner, puis les exclure ou les garder</numerusform>
        </translation>
    </message>
    <message>
        <source>the backup {file}</source>
        <translation>la sauvegarde {file}</translation>
    </message>
    <message>
        <source>the table of axis {index}</source>
        <translation>la table de l&apos;axe {index}</translation>
    </message>
    <message>
        <source>the table of axis {index} ({axis})</source>
        <translation>la table de l&apos;axe {index} ({axis})</translation>
    </message>
    <message>
        <source>{temperature}</source>
        <translation>{temperature}</translation>
    </message>
    <message>
        <source>measured in {count} thermal states: {temperatures}; outside of them the drive holds the values of the ends</source>
        <translation>mesuré dans {count} états thermiques&#xa0;: {temperatures}&#xa0;; en dehors, le variateur maintient les valeurs d&apos;extrémité</translation>
    </message>
    <message>
        <source>the table is straight over temperature, which leaves up to {largest} of what was measured in a state</source>
        <translation>la table est linéaire selon la température, ce qui laisse jusqu&apos;à {largest} de ce qui a été mesuré dans un état</translation>
    </message>
    <message>
        <source>the table has the movement of the zero from one thermal state to the other, as the instrument saw it: that is only right if its own zero was not set anew in between</source>
        <translation>la table contient le déplacement du zéro d&apos;un état thermique à l&apos;autre, tel que l&apos;instrument l&apos;a vu&#xa0;: ce n&apos;est exact que si son propre zéro n&apos;a pas été refait entre-temps</translation>
    </message>
    <message>
        <source>at {temperature}: {sentence}</source>
        <translation>à {temperature}&#xa0;: {sentence}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {after} after</source>
        <translation>{figure} {before} avant, {after} après</translation>
    </message>
    <message>
        <source>{figure} {after}</source>
        <translation>{figure} {after}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {predicted} predicted, not measured since</source>
        <translation>{figure} {before} avant, {predicted} prévu, non mesuré depuis</translation>
    </message>
    <message>
        <source>{figure} {before} before, not measured since</source>
        <translation>{figure} {before} avant, non mesuré depuis</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance})</source>
        <translation>{values} (tolérance {tolerance})</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance}: {result})</source>
        <translation>{values} (tolérance {tolerance}&#xa0;: {result})</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}&#xa0;; {next}</translation>
    </message>
    <message>
        <source>measured {date}: {figures}</source>
        <translation>mesuré le {date}&#xa0;: {figures}</translation>
    </message>
    <message>
        <source>{figure} {before} before</source>
        <translation>{figure} {before} avant</translation>
    </message>
    <message>
        <source>{figure} {after}, {before} before</source>
        <translation>{figure} {after}, {before} avant</translation>
    </message>
    <message>
        <source>there is a table for each direction, and the reversal of up to {reversal} is in them: switch off the controller&apos;s own backlash compensation</source>
        <translation>il y a une table par sens, et l&apos;inversion de {reversal} au plus y est comprise&#xa0;: désactiver la compensation de jeu propre à la commande</translation>
    </message>
    <message>
        <source>approached upwards: {sentence}</source>
        <translation>abordé en sens positif&#xa0;: {sentence}</translation>
    </message>
    <message>
        <source>approached downwards: {sentence}</source>
        <translation>abordé en sens négatif&#xa0;: {sentence}</translation>
    </message>
    <message>
        <source>the new table is coarser than {name}: up to {lost} of what that has between the new points is lost; take more points</source>
        <translation>la nouvelle table est moins fine que {name}&#xa0;: jusqu&apos;à {lost} de ce que celle-ci contient entre les nouveaux points est perdu&#xa0;; prendre plus de points</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others and are in the table; judging names them, and they can be excluded</source>
        <comment>1 value does not fit the others and is in the table; judging names it, and it can be excluded</comment>
        <translation>
            <numerusform>{count} valeur ne concorde pas avec les autres et figure dans la table&#xa0;; l&apos;analyse la signale, et elle peut être exclue</numerusform>
            <numerusform>{count} valeurs ne concordent pas avec les autres et figurent dans la table&#xa0;; l&apos;analyse les signale, et elles peuvent être exclues</numerusform>
        </translation>
    </message>
    <message>
        <source>the targets are not all at the same place of a period of the axis; no period is stated</source>
        <translation>les positions cibles ne sont pas toutes au même endroit d&apos;une période de l&apos;axe&#xa0;; aucune période n&apos;est indiquée</translation>
    </message>
    <message>
        <source>from {from} to {to} nothing was measured, {gap} of a turn of {turn}: there the table is guessed, and no figure knows of it; measure the whole turn</source>
        <translation>de {from} à {to}, rien n&apos;a été mesuré, soit {gap} d&apos;un tour de {turn}&#xa0;: la table y est devinée, et aucune caractéristique n&apos;en tient compte&#xa0;; mesurer le tour entier</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: the table is for one direction, and up to {reversal} remains in the other</source>
        <translation>l&apos;essentiel de cette erreur est dû à l&apos;inversion, qu&apos;aucune table ne supprime&#xa0;: la table vaut pour un sens, et il reste jusqu&apos;à {reversal} dans l&apos;autre</translation>
    </message>
    <message>
        <source>each figure, before and foretold, is the largest of a thermal state and of all runs together</source>
        <translation>chaque caractéristique, avant et prévue, est la plus grande d&apos;un état thermique et de toutes les passes ensemble</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of both tables for their zero</source>
        <translation>{constant} a été retiré de toutes les valeurs des deux tables pour leur zéro</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of {table} for its zero</source>
        <translation>{constant} a été retiré de toutes les valeurs de {table} pour son zéro</translation>
    </message>
    <message>
        <source>the new table is shorter than {name}: up to {lost} of what that has beyond the ends of the new one is lost; ask for no grid, which keeps that of {name}, or for one as long, or measure the whole of it</source>
        <translation>la nouvelle table est plus courte que {name}&#xa0;: jusqu’à {lost} de ce que celle-ci contient au-delà des extrémités de la nouvelle est perdu&#xa0;; ne demandez aucune grille, ce qui garde celle de {name}, ou une grille aussi longue, ou mesurez toute la course</translation>
    </message>
    <message>
        <source>the rule grubbs is for 4 to 10 values of a target, and some of those {direction} were not tested</source>
        <translation>la règle grubbs vaut pour 4 à 10 valeurs par position, et certaines {direction} n&apos;ont pas été testées</translation>
    </message>
    <message>
        <source>a value {direction} stands out that the rule mad does not propose: it keeps 3 values of each target, and needs others that differ</source>
        <translation>une valeur {direction} se détache que la règle mad ne propose pas&#xa0;: elle garde 3 valeurs par position et a besoin d&apos;autres valeurs différentes</translation>
    </message>
    <message>
        <source>{table} goes from {from} to {to}, the targets from {first} to {last}: beyond its ends the drive holds their values; take the number of points, or a distance that divides the range of the targets</source>
        <translation>{table} va de {from} à {to}, les positions cibles de {first} à {last}&#xa0;: au-delà de ses extrémités le variateur maintient leurs valeurs&#xa0;; indiquez le nombre de points, ou une distance qui divise la plage des positions cibles</translation>
    </message>
    <message>
        <source>the first target is {first}; the table is for an axis that counts from {from} to {to}: where it counts otherwise, the drive holds the values at the ends</source>
        <translation>la première position cible est {first}&#xa0;; la table est pour un axe qui compte de {from} à {to}&#xa0;: là où il compte autrement, le variateur maintient les valeurs des extrémités</translation>
    </message>
    <message>
        <source>{read} ({corrected} after corrections)</source>
        <translation>{read} ({corrected} après corrections)</translation>
    </message>
    <message>
        <source>first measurement: {remark}</source>
        <translation>première mesure&#xa0;: {remark}</translation>
    </message>
    <message>
        <source>second measurement: {remark}</source>
        <translation>deuxième mesure&#xa0;: {remark}</translation>
    </message>
    <message>
        <source>of all values {figure} is {value} (tolerance {tolerance}: {result})</source>
        <translation>sur toutes les valeurs, {figure} est de {value} (tolérance {tolerance}&#xa0;: {result})</translation>
    </message>
    <message>
        <source>the first measurement is of the machine {before}, the second of {after}</source>
        <translation>la première mesure est de la machine {before}, la deuxième de {after}</translation>
    </message>
    <message>
        <source>the first measurement has the serial number {before}, the second {after}</source>
        <translation>la première mesure indique le numéro de série {before}, la deuxième {after}</translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} more than 90 degrees</source>
        <translation>l&apos;angle entre {first} et {second} est supérieur de {angle} à 90 degrés</translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is at {place}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: at {place}, {residual} off</comment>
        <translation>
            <numerusform>{count} valeur de {table} ne concorde pas avec les autres et compte peu&#xa0;: à {place}, écart de {residual}</numerusform>
            <numerusform>{count} valeurs de {table} ne concordent pas avec les autres et comptent peu&#xa0;; la première est à {place}, écart de {residual}</numerusform>
        </translation>
    </message>
    <message>
        <source>first measurement from {beforeFirst} to {beforeLast}, second one from {afterFirst} to {afterLast}</source>
        <translation>première mesure de {beforeFirst} à {beforeLast}, deuxième de {afterFirst} à {afterLast}</translation>
    </message>
    <message>
        <source>{ranges}: over a shorter travel the figures are smaller whatever the compensation does, and nothing is proved for the rest</source>
        <translation>{ranges}&#xa0;: sur une course plus courte, les caractéristiques sont plus petites quoi que fasse la compensation, et rien n&apos;est prouvé pour le reste</translation>
    </message>
    <message>
        <source>{figures}, over part of the travel</source>
        <translation>{figures}, sur une partie de la course</translation>
    </message>
    <message>
        <source>{removed} was taken out for the zero of the table</source>
        <translation>{removed} ont été retirés pour le zéro de la table</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope and the zero of the table</source>
        <translation>{removed} ont été retirés pour la pente et le zéro de la table</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope</source>
        <translation>{removed} ont été retirés pour la pente</translation>
    </message>
    <message>
        <source>{removed} was taken out for how the artefact lay and for the zero of the table</source>
        <translation>{removed} ont été retirés pour le placement de l&apos;étalon et le zéro de la table</translation>
    </message>
    <message>
        <source>{evened} was taken out by gain, averaging, smoothing or grid</source>
        <translation>{evened} ont été retirés par le gain, la moyenne, le lissage ou la grille</translation>
    </message>
    <message>
        <source>{removed}, and {evened} by gain, averaging, smoothing or grid</source>
        <translation>{removed}, et {evened} par le gain, la moyenne, le lissage ou la grille</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; {taken}, so the drive will add {added}</source>
        <translation>à {position}, la référence était à {measured} du codeur dans {table}&#xa0;; {taken}, le variateur ajoutera donc {added}</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; {taken}, so the drive will add {added}</source>
        <translation>là où le codeur indique {reading}, la référence indiquait {reference}, moyenne des deux sens avec {count} valeurs&#xa0;; {taken}, le variateur ajoutera donc {added}</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; the drive will add {added}</source>
        <translation>là où le codeur indique {reading}, la référence indiquait {reference}, moyenne des deux sens avec {count} valeurs&#xa0;; le variateur ajoutera {added}</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; {taken}, so the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; {taken}, so the drive will add {added}</comment>
        <translation>
            <numerusform>là où le codeur indique {reading}, la référence indiquait {reference}, mesuré {count} fois&#xa0;; {taken}, le variateur ajoutera donc {added}</numerusform>
            <numerusform>là où le codeur indique {reading}, la référence indiquait {reference} en moyenne de {count} valeurs&#xa0;; {taken}, le variateur ajoutera donc {added}</numerusform>
        </translation>
    </message>
    <message>
        <source>the second measurement is of {date}, and the record has one of {last} with the same table, which decides</source>
        <translation>la deuxième mesure est du {date}, et la fiche en contient une du {last} avec la même table, qui est déterminante</translation>
    </message>
    <message>
        <source>the targets of the second measurement are up to {second} apart, those of the first one up to {first}: what lies between them is not measured again</source>
        <translation>les positions cibles de la seconde mesure sont espacées de {second} au plus, celles de la première de {first} : ce qui se trouve entre elles n&apos;est pas remesuré</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, E of the direction that was measured is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>entre les positions cibles, l&apos;erreur n&apos;est pas assez bien connue&#xa0;: prévu sans chaque position cible, E du sens mesuré vaut {heldOut}, contre {before} avant&#xa0;; mesurer à plus de positions cibles</translation>
    </message>
    <message>
        <source>0 = mean at {position}</source>
        <translation>0 = moyenne à {position}</translation>
    </message>
    <message>
        <source>{said} (file {file})</source>
        <translation>{said} (fichier {file})</translation>
    </message>
    <message>
        <source>the files are of different machines: {machines}</source>
        <translation>les fichiers proviennent de machines différentes&#xa0;: {machines}</translation>
    </message>
    <message>
        <source>the files have different serial numbers: {numbers}</source>
        <translation>les fichiers indiquent des numéros de série différents&#xa0;: {numbers}</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>image</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg or .pdf.</source>
        <translation>Le nom du fichier doit se terminer par .png, .svg ou .pdf.</translation>
    </message>
    <message>
        <source>Save picture or values</source>
        <translation>Enregistrer l&apos;image ou les valeurs</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Image (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>Dessin (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>Document (*.pdf)</translation>
    </message>
    <message>
        <source>Values (*.csv)</source>
        <translation>Valeurs (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Enregistré sous %1</translation>
    </message>
</context>
<context>
    <name>PlanText</name>
    <message>
        <source>Axis %1: %2 targets, %3 values</source>
        <translation>Axe %1&#xa0;: %2 positions cibles, %3 valeurs</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>the file holds no data</source>
        <translation>le fichier ne contient pas de données</translation>
    </message>
    <message>
        <source>export it again, or choose another file</source>
        <translation>l&apos;exporter à nouveau ou choisir un autre fichier</translation>
    </message>
    <message>
        <source>the header line with the names of the columns is missing</source>
        <translation>la ligne d&apos;en-tête avec les noms des colonnes manque</translation>
    </message>
    <message>
        <source>add a first line such as X [mm],Table 1 [mm], or for a measurement target [mm],direction,run,deviation [um]</source>
        <translation>ajouter une première ligne telle que X [mm],Table 1 [mm], ou pour une mesure target [mm],direction,run,deviation [um]</translation>
    </message>
    <message>
        <source>the header has too few columns</source>
        <translation>l&apos;en-tête a trop peu de colonnes</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has</source>
        <translation>choisir la dimensionnalité du fichier</translation>
    </message>
    <message>
        <source>this line does not have as many columns as the header</source>
        <translation>cette ligne n&apos;a pas autant de colonnes que l&apos;en-tête</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>ce n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>this number is not finite</source>
        <translation>ce nombre n&apos;est pas fini</translation>
    </message>
    <message>
        <source>it is not clear which sign is the decimal one</source>
        <translation>on ne sait pas quel signe est le séparateur décimal</translation>
    </message>
    <message>
        <source>use one decimal sign in all numbers, and none between thousands</source>
        <translation>utilisez un seul séparateur décimal dans tous les nombres, et aucun entre les milliers</translation>
    </message>
    <message>
        <source>a quotation mark is not closed as it should be</source>
        <translation>un guillemet n&apos;est pas fermé comme il le devrait</translation>
    </message>
    <message>
        <source>the same position occurs twice</source>
        <translation>la même position figure deux fois</translation>
    </message>
    <message>
        <source>delete one of the two lines</source>
        <translation>supprimer l&apos;une des deux lignes</translation>
    </message>
    <message>
        <source>the grid is incomplete</source>
        <translation>la grille est incomplète</translation>
    </message>
    <message>
        <source>the positions are not evenly spaced</source>
        <translation>les positions ne sont pas équidistantes</translation>
    </message>
    <message>
        <source>resample the data onto an even grid, which can be done here for a calibration file only</source>
        <translation>rééchantillonner les données sur une grille régulière, ce qui n&apos;est possible ici que pour un fichier d&apos;étalonnage</translation>
    </message>
    <message>
        <source>there are too few points</source>
        <translation>il y a trop peu de points</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>le fichier est trop volumineux</translation>
    </message>
    <message>
        <source>choose a coarser grid, or split the file</source>
        <translation>choisir une grille moins fine ou diviser le fichier</translation>
    </message>
    <message>
        <source>this is not a text file</source>
        <translation>ce n&apos;est pas un fichier texte</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>le fichier n&apos;est pas lisible</translation>
    </message>
    <message>
        <source>the file is not valid UTF-8 and is read as Windows-1252</source>
        <translation>le fichier n&apos;est pas un UTF-8 valide et est lu en Windows-1252</translation>
    </message>
    <message>
        <source>the positions are even only within the printed precision</source>
        <translation>les positions ne sont régulières qu&apos;à la précision imprimée près</translation>
    </message>
    <message>
        <source>the even grid is used; print more decimals if that is not meant</source>
        <translation>la grille régulière est utilisée&#xa0;; si ce n&apos;est pas voulu, imprimer plus de décimales</translation>
    </message>
    <message>
        <source>a value loses precision when it is stored as float32</source>
        <translation>une valeur perd en précision une fois stockée en float32</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>vérifier l&apos;unité des valeurs</translation>
    </message>
    <message>
        <source>the table is very steep, which is likely a unit mistake</source>
        <translation>la table est très raide, il s&apos;agit sans doute d&apos;une erreur d&apos;unité</translation>
    </message>
    <message>
        <source>all values of the table are equal</source>
        <translation>toutes les valeurs de la table sont égales</translation>
    </message>
    <message>
        <source>check that this column is meant</source>
        <translation>vérifier que c&apos;est bien cette colonne</translation>
    </message>
    <message>
        <source>found an empty cell</source>
        <translation>une cellule est vide</translation>
    </message>
    <message>
        <source>this is not written as the format demands</source>
        <translation>ce n&apos;est pas écrit comme le format l&apos;exige</translation>
    </message>
    <message>
        <source>the positions do not go in one direction</source>
        <translation>les positions ne vont pas dans un seul sens</translation>
    </message>
    <message>
        <source>the table does not close after one revolution</source>
        <translation>la table ne se referme pas après un tour</translation>
    </message>
    <message>
        <source>the controller does not take as much</source>
        <translation>la commande n&apos;en accepte pas autant</translation>
    </message>
    <message>
        <source>this entry is not known and is left out</source>
        <translation>cet élément est inconnu et ignoré</translation>
    </message>
    <message>
        <source>the file does not say a unit</source>
        <translation>le fichier n&apos;indique pas d&apos;unité</translation>
    </message>
    <message>
        <source>the file can be understood in several ways</source>
        <translation>le fichier peut s&apos;interpréter de plusieurs façons</translation>
    </message>
    <message>
        <source> (error %1 of the controller)</source>
        <translation> (erreur %1 de la commande)</translation>
    </message>
    <message>
        <source>found &quot;{found}&quot;</source>
        <translation>trouvé «&#xa0;{found}&#xa0;»</translation>
    </message>
    <message>
        <source>found {found}</source>
        <translation>trouvé&#xa0;: {found}</translation>
    </message>
    <message>
        <source>{problem}: {found}</source>
        <translation>{problem}&#xa0;: {found}</translation>
    </message>
    <message>
        <source>{problem}, expected {expected}</source>
        <translation>{problem}, attendu&#xa0;: {expected}</translation>
    </message>
    <message>
        <source>{problem}; {wayOut}</source>
        <translation>{problem}&#xa0;; {wayOut}</translation>
    </message>
    <message>
        <source>the axis that the values correct cannot be told</source>
        <translation>l&apos;axe que corrigent les valeurs ne peut pas être déterminé</translation>
    </message>
    <message>
        <source>check the units of values and positions</source>
        <translation>vérifier les unités des valeurs et des positions</translation>
    </message>
    <message>
        <source>points without a value are filled</source>
        <translation>les points sans valeur sont remplis</translation>
    </message>
    <message>
        <source>the grid is cropped to the points that have a value</source>
        <translation>la grille est rognée aux points ayant une valeur</translation>
    </message>
    <message>
        <source>positions are snapped to the grid</source>
        <translation>les positions sont accrochées à la grille</translation>
    </message>
    <message>
        <source>comments from here on are not kept with the table</source>
        <translation>à partir d&apos;ici, les commentaires ne sont pas conservés avec la table</translation>
    </message>
    <message>
        <source>the file has another dimensionality than the one chosen</source>
        <translation>le fichier a une autre dimensionnalité que celle choisie</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has (--dims)</source>
        <translation>choisir la dimensionnalité du fichier (--dims)</translation>
    </message>
    <message>
        <source>the columns do not say what was measured</source>
        <translation>les colonnes n&apos;indiquent pas ce qui a été mesuré</translation>
    </message>
    <message>
        <source>the unit of a column is not known</source>
        <translation>l&apos;unité d&apos;une colonne n&apos;est pas connue</translation>
    </message>
    <message>
        <source>a length and an angle are mixed</source>
        <translation>une longueur et un angle sont mélangés</translation>
    </message>
    <message>
        <source>correct the unit in the file, or state it</source>
        <translation>corriger l&apos;unité dans le fichier ou l&apos;indiquer</translation>
    </message>
    <message>
        <source>this is not a direction</source>
        <translation>ce n&apos;est pas un sens</translation>
    </message>
    <message>
        <source>this is not the number of a run</source>
        <translation>ce n&apos;est pas le numéro d&apos;une passe</translation>
    </message>
    <message>
        <source>the same value is there twice</source>
        <translation>la même valeur figure deux fois</translation>
    </message>
    <message>
        <source>the file holds another number than it says</source>
        <translation>le fichier contient un autre nombre que celui indiqué</translation>
    </message>
    <message>
        <source>there are too few targets</source>
        <translation>il y a trop peu de positions cibles</translation>
    </message>
    <message>
        <source>there is no target of this number</source>
        <translation>il n&apos;y a pas de position cible de ce numéro</translation>
    </message>
    <message>
        <source>positions do not follow one another one to one</source>
        <translation>des positions ne se suivent pas dans un rapport de 1 à 1</translation>
    </message>
    <message>
        <source>values are missing</source>
        <translation>des valeurs manquent</translation>
    </message>
    <message>
        <source>the figures are made of the values that are there</source>
        <translation>les caractéristiques sont établies avec les valeurs présentes</translation>
    </message>
    <message>
        <source>the directions have different numbers of runs</source>
        <translation>les deux sens n&apos;ont pas le même nombre de passes</translation>
    </message>
    <message>
        <source>the values look like positions instead of deviations</source>
        <translation>les valeurs ressemblent à des positions et non à des écarts</translation>
    </message>
    <message>
        <source>if they are positions of the reference, say so: --values reference, or name the column reference</source>
        <translation>si ce sont des positions de la référence, l&apos;indiquer&#xa0;: --values reference, ou nommer la colonne reference</translation>
    </message>
    <message>
        <source>the size of the values is unusual</source>
        <translation>la grandeur des valeurs est inhabituelle</translation>
    </message>
    <message>
        <source>a result in the file is not what its values give</source>
        <translation>un résultat du fichier ne correspond pas à ses valeurs</translation>
    </message>
    <message>
        <source>not everything in the file is used</source>
        <translation>le fichier n&apos;est pas utilisé en entier</translation>
    </message>
    <message>
        <source>an entry {key}</source>
        <translation>un élément {key}</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>one of {known}</source>
        <translation>un choix parmi {known}</translation>
    </message>
    <message>
        <source>sections that begin with [[{key}]]</source>
        <translation>des sections qui commencent par [[{key}]]</translation>
    </message>
    <message>
        <source>at most {count} of them</source>
        <translation>{count} au plus</translation>
    </message>
    <message>
        <source>a known key; the nearest is {key}</source>
        <translation>une clé connue&#xa0;; la plus proche est {key}</translation>
    </message>
    <message>
        <source>valid TOML ({reason})</source>
        <translation>du TOML valide ({reason})</translation>
    </message>
    <message>
        <source>{number}, the version of this format</source>
        <translation>{number}, la version de ce format</translation>
    </message>
    <message>
        <source>{name} is a drive in line {line} already</source>
        <translation>{name} est déjà un variateur à la ligne {line}</translation>
    </message>
    <message>
        <source>serial number {name} is in line {line} already</source>
        <translation>le numéro de série {name} figure déjà à la ligne {line}</translation>
    </message>
    <message>
        <source>a list of one to three registers</source>
        <translation>une liste de un à trois registres</translation>
    </message>
    <message>
        <source>settings as {example}</source>
        <translation>des réglages tels que {example}</translation>
    </message>
    <message>
        <source>a text, a number, true or false</source>
        <translation>un texte, un nombre, true ou false</translation>
    </message>
    <message>
        <source>an entry file, or no-table = true for an axis that shall have none</source>
        <translation>un élément file, ou no-table = true pour un axe qui ne doit avoir aucune table</translation>
    </message>
    <message>
        <source>{key} of an axis without a table</source>
        <translation>{key} d&apos;un axe sans table</translation>
    </message>
    <message>
        <source>no-table beside file</source>
        <translation>no-table à côté de file</translation>
    </message>
    <message>
        <source>an entry sources, with the register that looks the table up for each of its dimensions</source>
        <translation>un élément sources, avec le registre qui sert à consulter la table pour chacune de ses dimensions</translation>
    </message>
    <message>
        <source>axis {name} of this drive is in line {line} already</source>
        <translation>l&apos;axe {name} de ce variateur figure déjà à la ligne {line}</translation>
    </message>
    <message>
        <source>slot {name} is taken by the axis in line {line}</source>
        <translation>l&apos;emplacement {name} est pris par l&apos;axe de la ligne {line}</translation>
    </message>
    <message>
        <source>save it as UTF-8 text</source>
        <translation>l&apos;enregistrer en texte UTF-8</translation>
    </message>
    <message>
        <source>check the names and notes, or save it as UTF-8 text</source>
        <translation>vérifier les noms et les remarques, ou l&apos;enregistrer en texte UTF-8</translation>
    </message>
    <message>
        <source>the directions of the runs are doubtful</source>
        <translation>les sens des passes sont douteux</translation>
    </message>
    <message>
        <source>compare them with the data, and exchange them if they are the other way round</source>
        <translation>les comparer avec les données et les permuter s&apos;ils sont inversés</translation>
    </message>
    <message>
        <source>line {line}: {problem}</source>
        <translation>ligne {line}&#xa0;: {problem}</translation>
    </message>
    <message>
        <source>two statements contradict each other</source>
        <translation>deux indications se contredisent</translation>
    </message>
    <message>
        <source>the serial number of the drive, a whole number of at most 32 bits, without quotation marks</source>
        <translation>le numéro de série du variateur, un nombre entier de 32 bits au plus, sans guillemets</translation>
    </message>
    <message>
        <source>a text that is not empty and has no control characters</source>
        <translation>un texte non vide et sans caractères de contrôle</translation>
    </message>
    <message>
        <source>a name, or a whole number that is not negative</source>
        <translation>un nom, ou un nombre entier non négatif</translation>
    </message>
    <message>
        <source>a number that is not negative and its unit, such as {example}</source>
        <translation>un nombre non négatif et son unité, par exemple {example}</translation>
    </message>
    <message>
        <source>UTF-8 text</source>
        <translation>du texte en UTF-8</translation>
    </message>
    <message>
        <source>delete one of the two</source>
        <translation>supprimer l&apos;un des deux</translation>
    </message>
    <message>
        <source>a text; write it in quotation marks</source>
        <translation>un texte&#xa0;; l&apos;écrire entre guillemets</translation>
    </message>
    <message>
        <source>a text; write {source} for the first source, {name} for an axis of that name</source>
        <translation>un texte&#xa0;; écrire {source} pour la première source, {name} pour un axe de ce nom</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Deviation in {unit}</source>
        <translation>Écart en {unit}</translation>
    </message>
    <message>
        <source>Position in {unit}</source>
        <translation>Position en {unit}</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions with bands of 2 s, the mean of both, single runs</source>
        <translation>Écart selon la position&#xa0;: moyennes des deux sens avec bandes de 2 s, moyenne des deux, passes individuelles</translation>
    </message>
    <message>
        <source>What lines and markers mean</source>
        <translation>Signification des lignes et des marques</translation>
    </message>
    <message>
        <source>mean ↑</source>
        <translation>moyenne ↑</translation>
    </message>
    <message>
        <source>mean ↓</source>
        <translation>moyenne ↓</translation>
    </message>
    <message>
        <source>mean of both</source>
        <translation>moyenne des deux</translation>
    </message>
    <message>
        <source>mean ↑ ± 2 s</source>
        <translation>moyenne ↑ ± 2 s</translation>
    </message>
    <message>
        <source>mean ↓ ± 2 s</source>
        <translation>moyenne ↓ ± 2 s</translation>
    </message>
    <message>
        <source>single run</source>
        <translation>passe individuelle</translation>
    </message>
    <message>
        <source>dead path of {length}: values changed by up to {largest}</source>
        <translation>trajet mort de {length}&#xa0;: valeurs modifiées de {largest} au plus</translation>
    </message>
    <message>
        <source>drift taken out for the table, not for figures</source>
        <translation>dérive retirée pour la table, non pour les caractéristiques</translation>
    </message>
    <message>
        <source>smooth grid of scattered points</source>
        <translation>grille lisse de points épars</translation>
    </message>
    <message>
        <source>{method}, from the runs ↑</source>
        <translation>{method}, à partir des passes ↑</translation>
    </message>
    <message>
        <source>{method}, from the runs ↓</source>
        <translation>{method}, à partir des passes ↓</translation>
    </message>
    <message>
        <source>{method}, from the mean of both directions</source>
        <translation>{method}, à partir de la moyenne des deux sens</translation>
    </message>
    <message>
        <source>failed after {share} of the table</source>
        <translation>échec après {share} de la table</translation>
    </message>
    <message>
        <source>passed over {share} of the table</source>
        <translation>réussie sur {share} de la table</translation>
    </message>
    <message>
        <source>At the set position {position} the drive adds {added} to what the encoder reads.</source>
        <translation>À la position de consigne {position}, le variateur ajoute {added} à ce qu&apos;indique le codeur.</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the drive adds {added}.</source>
        <translation>Là où le codeur indique {reading}, le variateur ajoute {added}.</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the reference said {reference}: the drive adds {added}.</source>
        <translation>Là où le codeur indique {reading}, la référence indiquait {reference}&#xa0;: le variateur ajoute {added}.</translation>
    </message>
    <message>
        <source>Compensation of axis {axis}, machine {machine}</source>
        <translation>Compensation de l&apos;axe {axis}, machine {machine}</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>non défini</translation>
    </message>
    <message>
        <source>The accuracy A before is not defined.</source>
        <translation>L&apos;exactitude A d&apos;avant n&apos;est pas définie.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Variateur</translation>
    </message>
    <message>
        <source>Serial number of the drive</source>
        <translation>Numéro de série du variateur</translation>
    </message>
    <message>
        <source>Firmware profile</source>
        <translation>Profil de firmware</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Feed, dwell</source>
        <translation>Avance, temporisation</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Environnement</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Compensation</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Corrections</translation>
    </message>
    <message>
        <source>Targets and runs</source>
        <translation>Positions cibles et passes</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Exclu</translation>
    </message>
    <message>
        <source>air {air}, material {material}, expansion {expansion}</source>
        <translation>air {air}, matériau {material}, dilatation {expansion}</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>on, which table is not stated</source>
        <translation>activée, table non indiquée</translation>
    </message>
    <message>
        <source>on, table {crc}</source>
        <translation>activée, table {crc}</translation>
    </message>
    <message>
        <source>to 20 °C by the instrument</source>
        <translation>à 20 °C par l&apos;instrument</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>none here, by the instrument not stated</source>
        <translation>aucune ici, par l&apos;instrument non indiqué</translation>
    </message>
    <message>
        <source>no targets: {kind}</source>
        <translation>pas de positions cibles&#xa0;: {kind}</translation>
    </message>
    <message>
        <source>{direction} target {target} run {run}</source>
        <translation>{direction} cible {target} passe {run}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>{count} values: not an evaluation by ISO 230-2</source>
        <translation>{count} valeurs&#xa0;: pas une évaluation selon l&apos;ISO 230-2</translation>
    </message>
    <message>
        <source>{values}: not an evaluation by ISO 230-2</source>
        <translation>{values}&#xa0;: pas une évaluation selon l&apos;ISO 230-2</translation>
    </message>
    <message>
        <source>Deviation over position: before, after, to one scale</source>
        <translation>Écart selon la position&#xa0;: avant, après, à la même échelle</translation>
    </message>
    <message>
        <source>Deviation over position, before</source>
        <translation>Écart selon la position, avant</translation>
    </message>
    <message>
        <source>Deviation over position, after</source>
        <translation>Écart selon la position, après</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014 in {unit}</source>
        <translation>Caractéristiques selon l&apos;ISO 230-2:2014 en {unit}</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prévu</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>hors ajustement</translation>
    </message>
    <message>
        <source>Verdict on the measurement after</source>
        <translation>Verdict sur la mesure après</translation>
    </message>
    <message>
        <source>Verdict on the measurement before</source>
        <translation>Verdict sur la mesure avant</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolérances</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>Incertitude U, k = 2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolérance</translation>
    </message>
    <message>
        <source>uncertainty U, k = 2</source>
        <translation>incertitude U, k = 2</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>verdict</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>CRC-32</source>
        <translation>CRC-32</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistance</translation>
    </message>
    <message>
        <source>End-to-end proof</source>
        <translation>Validation de bout en bout</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signe</translation>
    </message>
    <message>
        <source>{count} points from {from} to {to}</source>
        <translation>{count} points de {from} à {to}</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>persistante</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volatile</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>none on record</source>
        <translation>aucune dans la fiche</translation>
    </message>
    <message numerus="yes">
        <source>and {count} more in the record</source>
        <comment>and 1 more in the record</comment>
        <translation>
            <numerusform>et {count} autre dans la fiche</numerusform>
            <numerusform>et {count} autres dans la fiche</numerusform>
        </translation>
    </message>
    <message>
        <source>Input files</source>
        <translation>Fichiers d&apos;entrée</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>format</source>
        <translation>format</translation>
    </message>
    <message>
        <source>Made by Axis Compensation Wizard {version}. Figures that the values do not define are not defined; what is not on record is not stated.</source>
        <translation>Établi par Axis Compensation Wizard {version}. Les caractéristiques que les valeurs ne déterminent pas sont non définies&#xa0;; ce qui ne figure pas dans la fiche n&apos;est pas indiqué.</translation>
    </message>
    <message>
        <source>Targets before, in {unit}</source>
        <translation>Positions cibles avant, en {unit}</translation>
    </message>
    <message>
        <source>Targets after, in {unit}</source>
        <translation>Positions cibles après, en {unit}</translation>
    </message>
    <message>
        <source>target in {unit}</source>
        <translation>cible en {unit}</translation>
    </message>
    <message>
        <source>values ↑</source>
        <translation>valeurs ↑</translation>
    </message>
    <message>
        <source>s ↑</source>
        <translation>s ↑</translation>
    </message>
    <message>
        <source>values ↓</source>
        <translation>valeurs ↓</translation>
    </message>
    <message>
        <source>s ↓</source>
        <translation>s ↓</translation>
    </message>
    <message>
        <source>Left out: {values}</source>
        <translation>Exclu&#xa0;: {values}</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>The accuracy A is not defined, before or after.</source>
        <translation>L&apos;exactitude A n&apos;est définie ni avant ni après.</translation>
    </message>
    <message>
        <source>{figure}: {before} before, {after} after.</source>
        <translation>{figure}&#xa0;: {before} avant, {after} après.</translation>
    </message>
    <message>
        <source>{method}, over position and temperature</source>
        <translation>{method}, selon la position et la température</translation>
    </message>
    <message>
        <source>Each figure is the largest of a thermal state and of all runs together.</source>
        <translation>Chaque caractéristique est la plus grande d&apos;un état thermique et de toutes les passes ensemble.</translation>
    </message>
    <message>
        <source>air {air}, material {material}, values measured at {values}, expansion {expansion}</source>
        <translation>air {air}, matériau {material}, valeurs mesurées à {values}, dilatation {expansion}</translation>
    </message>
    <message>
        <source>{from} to {to}</source>
        <translation>{from} à {to}</translation>
    </message>
    <message>
        <source>Warning: {warning}.</source>
        <translation>Avertissement&#xa0;: {warning}.</translation>
    </message>
    <message>
        <source>up and down exchanged</source>
        <translation>les deux sens permutés</translation>
    </message>
    <message>
        <source>reference taken with the opposite sign</source>
        <translation>référence prise avec le signe opposé</translation>
    </message>
    <message>
        <source>unit of {what} taken as {stated}, the file says {unit}</source>
        <translation>unité de {what}&#xa0;: {stated} utilisée, le fichier indique {unit}</translation>
    </message>
    <message>
        <source>slope taken out for the table, not for figures</source>
        <translation>pente retirée pour la table, non pour les caractéristiques</translation>
    </message>
    <message>
        <source>to {standard}, {conditions}: values changed by up to {largest}</source>
        <translation>à {standard}, {conditions}&#xa0;: valeurs modifiées de {largest} au plus</translation>
    </message>
    <message>
        <source>scale at {temperature} with {expansion}</source>
        <translation>règle à {temperature} avec {expansion}</translation>
    </message>
    <message>
        <source>reference at {temperature} with {expansion}</source>
        <translation>référence à {temperature} avec {expansion}</translation>
    </message>
    <message>
        <source>datum at {position}</source>
        <translation>origine fixe à {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets from {from} to {to}</source>
        <comment>1 target from {from} to {to}</comment>
        <translation>
            <numerusform>{count} position cible de {from} à {to}</numerusform>
            <numerusform>{count} positions cibles de {from} à {to}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} runs {direction}</source>
        <comment>1 run {direction}</comment>
        <translation>
            <numerusform>{count} passe {direction}</numerusform>
            <numerusform>{count} passes {direction}</numerusform>
        </translation>
    </message>
    <message>
        <source>means {direction}</source>
        <translation>moyennes {direction}</translation>
    </message>
    <message>
        <source>no means {direction}</source>
        <translation>pas de moyennes {direction}</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions, the mean of both</source>
        <translation>Écart selon la position&#xa0;: moyennes des deux sens, moyenne des deux</translation>
    </message>
    <message>
        <source>on, table {crc}, as stated with the measurement</source>
        <translation>activée, table {crc}, comme indiqué avec la mesure</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tables</translation>
    </message>
    <message>
        <source>that of each table, below</source>
        <translation>celui de chaque table, ci-dessous</translation>
    </message>
    <message>
        <source>{name} for axis {axis}, CRC-32 {crc}</source>
        <translation>{name} pour l&apos;axe {axis}, CRC-32 {crc}</translation>
    </message>
    <message>
        <source>Compensation of axis {target} over axis {axis}, machine {machine}</source>
        <translation>Compensation de l&apos;axe {target} en fonction de l&apos;axe {axis}, machine {machine}</translation>
    </message>
    <message>
        <source>At the set position {position} of axis {axis} the drive adds {added} to what the encoder of axis {target} reads.</source>
        <translation>À la position de consigne {position} de l&apos;axe {axis}, le variateur ajoute {added} à ce qu&apos;indique le codeur de l&apos;axe {target}.</translation>
    </message>
    <message>
        <source>Where the encoder of axis {axis} reads {position}, the drive adds {added} to axis {target}.</source>
        <translation>Là où le codeur de l&apos;axe {axis} indique {position}, le variateur ajoute {added} à l&apos;axe {target}.</translation>
    </message>
    <message>
        <source>values taken as positions of the reference, the file says deviations</source>
        <translation>valeurs prises comme positions de la référence, le fichier dit écarts</translation>
    </message>
    <message>
        <source>values taken as deviations, the file says positions of the reference</source>
        <translation>valeurs prises comme écarts, le fichier dit positions de la référence</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before, {after} after.</source>
        <translation>Exactitude {figure}&#xa0;: {before} avant, {after} après.</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before. There is no measurement afterwards on record.</source>
        <translation>Exactitude {figure}&#xa0;: {before} avant. La fiche ne contient pas de mesure ultérieure.</translation>
    </message>
    <message>
        <source>Held out: what is left at targets that the table was made without: {figure} {range}, rms {rms}, largest {largest}. Of the two predictions this is the one to believe.</source>
        <translation>Hors ajustement&#xa0;: ce qui reste aux positions cibles sans lesquelles la table a été établie&#xa0;: {figure} {range}, RMS {rms}, maximum {largest}. Des deux prévisions, c&apos;est celle à laquelle se fier.</translation>
    </message>
    <message>
        <source>before, all values</source>
        <translation>avant, toutes les valeurs</translation>
    </message>
    <message>
        <source>after, all values</source>
        <translation>après, toutes les valeurs</translation>
    </message>
    <message>
        <source>all values</source>
        <translation>toutes les valeurs</translation>
    </message>
    <message>
        <source>verdict, all values</source>
        <translation>verdict, toutes les valeurs</translation>
    </message>
    <message>
        <source>Targets before, all values, in {unit}</source>
        <translation>Positions cibles avant, toutes les valeurs, en {unit}</translation>
    </message>
    <message>
        <source>Targets after, all values, in {unit}</source>
        <translation>Positions cibles après, toutes les valeurs, en {unit}</translation>
    </message>
    <message>
        <source>{said} ({files})</source>
        <translation>{said} ({files})</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before, {after} after.</source>
        <translation>Exactitude {figure} sur toutes les valeurs, y compris celles exclues&#xa0;: {before} avant, {after} après.</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before.</source>
        <translation>Exactitude {figure} sur toutes les valeurs, y compris celles exclues&#xa0;: {before} avant.</translation>
    </message>
</context>
<context>
    <name>RunValueText</name>
    <message>
        <source>%1, target %2, run %3, %4</source>
        <translation>%1, position cible %2, passe %3, %4</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>proposé pour exclusion</translation>
    </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>counts per unit</source>
        <translation>incréments par unité</translation>
    </message>
    <message>
        <source>position unit</source>
        <translation>unité des positions</translation>
    </message>
    <message>
        <source>value unit</source>
        <translation>unité des valeurs</translation>
    </message>
    <message>
        <source>wrap range</source>
        <translation>étendue d&apos;un tour</translation>
    </message>
    <message>
        <source>master axis</source>
        <translation>axe maître</translation>
    </message>
    <message>
        <source>master1 axis</source>
        <translation>axe maître 1</translation>
    </message>
    <message>
        <source>master2 axis</source>
        <translation>axe maître 2</translation>
    </message>
    <message>
        <source>n cycles</source>
        <translation>nombre de cycles</translation>
    </message>
    <message>
        <source>master kind</source>
        <translation>type d&apos;axe maître</translation>
    </message>
    <message>
        <source>master1 kind</source>
        <translation>type d&apos;axe maître 1</translation>
    </message>
    <message>
        <source>master2 kind</source>
        <translation>type d&apos;axe maître 2</translation>
    </message>
    <message>
        <source>axis kind</source>
        <translation>type d&apos;axe</translation>
    </message>
    <message>
        <source>modulo</source>
        <translation>modulo</translation>
    </message>
    <message>
        <source>modulo1</source>
        <translation>modulo 1</translation>
    </message>
    <message>
        <source>modulo2</source>
        <translation>modulo 2</translation>
    </message>
    <message>
        <source>list unit</source>
        <translation>unité de la liste</translation>
    </message>
    <message>
        <source>increments per unit</source>
        <translation>incréments par unité</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>décimales</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>axe</translation>
    </message>
    <message>
        <source>type</source>
        <translation>type</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>first table</source>
        <translation>première table</translation>
    </message>
    <message>
        <source>input axis</source>
        <translation>axe d&apos;entrée</translation>
    </message>
    <message>
        <source>output axis</source>
        <translation>axe de sortie</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>système de mesure</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>persistant</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>métrique</translation>
    </message>
    <message>
        <source>increments</source>
        <translation>incréments</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>rotatif</translation>
    </message>
    <message>
        <source>rotary axes</source>
        <translation>axes rotatifs</translation>
    </message>
    <message>
        <source>primary unit</source>
        <translation>unité de PRIMARY</translation>
    </message>
    <message>
        <source>units</source>
        <translation>unités</translation>
    </message>
    <message>
        <source>primary</source>
        <translation>primary</translation>
    </message>
    <message>
        <source>column axis</source>
        <translation>axe des colonnes</translation>
    </message>
    <message>
        <source>row axis</source>
        <translation>axe des lignes</translation>
    </message>
    <message>
        <source>output axis 1</source>
        <translation>axe de sortie 1</translation>
    </message>
    <message>
        <source>output axis 2</source>
        <translation>axe de sortie 2</translation>
    </message>
    <message>
        <source>output axis 3</source>
        <translation>axe de sortie 3</translation>
    </message>
    <message>
        <source>source counts per unit</source>
        <translation>incréments par unité de la source</translation>
    </message>
    <message>
        <source>target counts per unit</source>
        <translation>incréments par unité de la cible</translation>
    </message>
    <message>
        <source>column counts per unit</source>
        <translation>incréments par unité de la colonne</translation>
    </message>
    <message>
        <source>source motor</source>
        <translation>moteur source</translation>
    </message>
    <message>
        <source>target motor</source>
        <translation>moteur cible</translation>
    </message>
    <message>
        <source>row motor</source>
        <translation>moteur des lignes</translation>
    </message>
    <message>
        <source>column motor</source>
        <translation>moteur des colonnes</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>réelle</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>table</source>
        <translation>table</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>source axis 1</source>
        <translation>axe source 1</translation>
    </message>
    <message>
        <source>source axis 2</source>
        <translation>axe source 2</translation>
    </message>
    <message>
        <source>zone</source>
        <translation>zone</translation>
    </message>
    <message>
        <source>declare</source>
        <translation>déclaration</translation>
    </message>
    <message>
        <source>form</source>
        <translation>forme</translation>
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
        <translation>pas quelconque</translation>
    </message>
    <message>
        <source>reference number</source>
        <translation>numéro de référence</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>intervalle</translation>
    </message>
    <message>
        <source>detection unit</source>
        <translation>unité de détection</translation>
    </message>
    <message>
        <source>magnification</source>
        <translation>facteur multiplicateur</translation>
    </message>
    <message>
        <source>reference position</source>
        <translation>position de référence</translation>
    </message>
    <message>
        <source>first number</source>
        <translation>premier numéro</translation>
    </message>
    <message>
        <source>last number</source>
        <translation>dernier numéro</translation>
    </message>
    <message>
        <source>first record</source>
        <translation>première ligne</translation>
    </message>
    <message>
        <source>largest step</source>
        <translation>plus grande valeur</translation>
    </message>
    <message>
        <source>secondary unit</source>
        <translation>unité de SECONDARY</translation>
    </message>
    <message>
        <source>target axis</source>
        <translation>axe cible de la commande</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>planning</source>
        <translation>planification</translation>
    </message>
    <message>
        <source>backing up the old state</source>
        <translation>sauvegarde de l&apos;ancien état</translation>
    </message>
    <message>
        <source>checking for changes since the plan</source>
        <translation>recherche de modifications depuis la planification</translation>
    </message>
    <message>
        <source>detaching the table from the axis</source>
        <translation>détachement de la table de l&apos;axe</translation>
    </message>
    <message>
        <source>uploading the table</source>
        <translation>envoi de la table</translation>
    </message>
    <message>
        <source>verifying the table</source>
        <translation>vérification de la table</translation>
    </message>
    <message>
        <source>storing the table in flash</source>
        <translation>enregistrement de la table en mémoire flash</translation>
    </message>
    <message>
        <source>switching the axis over</source>
        <translation>basculement de l&apos;axe</translation>
    </message>
    <message>
        <source>saving the parameters</source>
        <translation>enregistrement des paramètres</translation>
    </message>
    <message>
        <source>reading back</source>
        <translation>relecture</translation>
    </message>
    <message>
        <source>rolling back</source>
        <translation>restauration de l&apos;ancien état</translation>
    </message>
    <message>
        <source>reading the table</source>
        <translation>lecture de la table</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>suppression de la table</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>Dim %1</source>
        <translation>Dim %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
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
        <translation>[*]Assistant de compensation d&apos;axes</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionPanel</name>
    <message>
        <source>&amp;Write Compensation</source>
        <translation>É&amp;crire la compensation</translation>
    </message>
    <message>
        <source>Re&amp;vert All</source>
        <translation>Tout rétab&amp;lir</translation>
    </message>
    <message>
        <source>&amp;Activate</source>
        <translation>&amp;Activer</translation>
    </message>
    <message>
        <source>More actions</source>
        <translation>Autres actions</translation>
    </message>
    <message>
        <source>D&amp;eactivate</source>
        <translation>&amp;Désactiver</translation>
    </message>
    <message>
        <source>&amp;Evaluate (Adds Nothing)</source>
        <translation>É&amp;valuer (sans ajout)</translation>
    </message>
    <message>
        <source>Restore &amp;Previous Table…</source>
        <translation>Restaurer la table &amp;précédente…</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>Writes table and settings to the drive and verifies them (Ctrl+Return)</source>
        <translation>Écrit la table et les réglages dans le variateur et les vérifie (Ctrl+Entrée)</translation>
    </message>
    <message>
        <source>Resets all fields to the drive&apos;s values (Ctrl+Shift+R)</source>
        <translation>Rétablit tous les champs aux valeurs du variateur (Ctrl+Maj+R)</translation>
    </message>
    <message>
        <source>Switches the compensation on, then compares the drive&apos;s output with the table</source>
        <translation>Active la compensation, puis compare la sortie du variateur avec la table</translation>
    </message>
    <message>
        <source>Switches the compensation off</source>
        <translation>Désactive la compensation</translation>
    </message>
    <message>
        <source>The drive looks up the table and shows the indices, but adds nothing</source>
        <translation>Le variateur consulte la table et affiche les indices, mais n&apos;ajoute rien</translation>
    </message>
    <message>
        <source>Writes back the table and settings from before the last write</source>
        <translation>Réécrit la table et les réglages d&apos;avant la dernière écriture</translation>
    </message>
    <message>
        <source>Continue in the preview on the right</source>
        <translation>Continuer dans l&apos;aperçu à droite</translation>
    </message>
    <message>
        <source>&amp;Delete Table…</source>
        <translation>S&amp;upprimer la table…</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive and frees its slot</source>
        <translation>Supprime la table de l&apos;axe du variateur et libère son emplacement</translation>
    </message>
    <message>
        <source>Evaluate, restore a backup, or delete the table</source>
        <translation>Évaluer, restaurer une sauvegarde ou supprimer la table</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>Restaurer une &amp;sauvegarde…</translation>
    </message>
    <message>
        <source>Shows the backups of this drive and restores the one you choose</source>
        <translation>Affiche les sauvegardes de ce variateur et restaure celle choisie</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionRules</name>
    <message>
        <source>No drive is connected: add a connection first.</source>
        <translation>Aucun variateur n&apos;est connecté&#xa0;: ajouter d&apos;abord une connexion.</translation>
    </message>
    <message>
        <source>Reading the axes of the drives.</source>
        <translation>Lecture des axes des variateurs.</translation>
    </message>
    <message>
        <source>Choose an axis first.</source>
        <translation>Choisir d&apos;abord un axe.</translation>
    </message>
    <message>
        <source>The drive is not connected.</source>
        <translation>Le variateur n&apos;est pas connecté.</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>Cet axe n&apos;a pas de registres de compensation.</translation>
    </message>
    <message>
        <source>Please wait: %1.</source>
        <translation>Patienter&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The axis is being read.</source>
        <translation>Lecture de l&apos;axe en cours.</translation>
    </message>
    <message>
        <source>The compensation is active: deactivate it first.</source>
        <translation>La compensation est active&#xa0;: la désactiver d&apos;abord.</translation>
    </message>
    <message>
        <source>No table is chosen: open compensation data.</source>
        <translation>Aucune table n&apos;est choisie&#xa0;: ouvrir des données de compensation.</translation>
    </message>
    <message>
        <source>The table has 1 dimension, but %1D is chosen.</source>
        <translation>La table a 1 dimension, mais %1D est choisi.</translation>
    </message>
    <message>
        <source>The table has %1 dimensions, but %2D is chosen.</source>
        <translation>La table a %1 dimensions, mais %2D est choisi.</translation>
    </message>
    <message>
        <source>A source is being checked.</source>
        <translation>Vérification d&apos;une source en cours.</translation>
    </message>
    <message>
        <source>Dim%1 Source is missing.</source>
        <translation>La source Dim%1 manque.</translation>
    </message>
    <message>
        <source>Dim%1 Source is the same as another source.</source>
        <translation>La source Dim%1 est la même qu&apos;une autre source.</translation>
    </message>
    <message>
        <source>The table needs %1 bytes, but the largest slot has %2.</source>
        <translation>La table nécessite %1 octets, mais le plus grand emplacement en a %2.</translation>
    </message>
    <message>
        <source>To spare the flash, wait %1 or write volatile.</source>
        <translation>Pour ménager la mémoire flash, attendre %1 ou écrire en volatil.</translation>
    </message>
    <message>
        <source>Nothing has changed.</source>
        <translation>Rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>The file is being read.</source>
        <translation>Lecture du fichier en cours.</translation>
    </message>
    <message>
        <source>The parameters still have to be saved.</source>
        <translation>Les paramètres restent à enregistrer.</translation>
    </message>
    <message>
        <source>The axis has no table on the drive: write one first.</source>
        <translation>L&apos;axe n&apos;a pas de table sur le variateur&#xa0;: en écrire d&apos;abord une.</translation>
    </message>
    <message>
        <source>An earlier write left the axis in neither the old nor the new state: write again or restore the previous state.</source>
        <translation>Une écriture précédente a laissé l&apos;axe dans un état qui n&apos;est ni l&apos;ancien ni le nouveau&#xa0;: écrire de nouveau ou restaurer l&apos;état précédent.</translation>
    </message>
    <message>
        <source>The compensation is already active.</source>
        <translation>La compensation est déjà active.</translation>
    </message>
    <message>
        <source>The axis must be homed first.</source>
        <translation>Effectuer d&apos;abord la prise d&apos;origine de l&apos;axe.</translation>
    </message>
    <message>
        <source>The compensation is already being evaluated.</source>
        <translation>La compensation est déjà en évaluation.</translation>
    </message>
    <message>
        <source>The compensation is not active.</source>
        <translation>La compensation n&apos;est pas active.</translation>
    </message>
    <message>
        <source>This axis has no backup yet; every write makes one.</source>
        <translation>Cet axe n&apos;a pas encore de sauvegarde&#xa0;; chaque écriture en crée une.</translation>
    </message>
    <message>
        <source>Nothing is running.</source>
        <translation>Aucune opération en cours.</translation>
    </message>
    <message>
        <source>It is already being stopped.</source>
        <translation>L&apos;arrêt est déjà en cours.</translation>
    </message>
    <message>
        <source>Finishes an earlier write: saves the parameters of the drive.</source>
        <translation>Achève une écriture précédente&#xa0;: enregistre les paramètres du variateur.</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash; uses %1 of the %2 flash operations available now.</source>
        <translation>Écrit dans le variateur et enregistre en mémoire flash&#xa0;; utilise %1 des %2 opérations flash disponibles actuellement.</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash.</source>
        <translation>Écrit dans le variateur et enregistre en mémoire flash.</translation>
    </message>
    <message>
        <source>Writes to the drive and saves its parameters; the table in flash stays.</source>
        <translation>Écrit dans le variateur et enregistre ses paramètres&#xa0;; la table en mémoire flash reste.</translation>
    </message>
    <message>
        <source>Writes to the drive; a reboot of the drive restores the stored state.</source>
        <translation>Écrit dans le variateur&#xa0;; un redémarrage du variateur rétablit l&apos;état enregistré.</translation>
    </message>
    <message>
        <source>Adds the table to the encoder position and proves that the drive&apos;s output matches the table.</source>
        <translation>Ajoute la table à la position du codeur et valide que la sortie du variateur correspond à la table.</translation>
    </message>
    <message>
        <source>The drive looks up the table without adding anything.</source>
        <translation>Le variateur consulte la table sans rien ajouter.</translation>
    </message>
    <message>
        <source>Switches the compensation off; table and settings stay on the drive.</source>
        <translation>Désactive la compensation&#xa0;; table et réglages restent sur le variateur.</translation>
    </message>
    <message>
        <source>Resets the fields to the drive&apos;s values.</source>
        <translation>Rétablit les champs aux valeurs du variateur.</translation>
    </message>
    <message>
        <source>Writes back the previous table and sources.</source>
        <translation>Réécrit la table et les sources précédentes.</translation>
    </message>
    <message>
        <source>Searches for drives and axes again and reads the axis.</source>
        <translation>Recherche de nouveau variateurs et axes, et lit l&apos;axe.</translation>
    </message>
    <message>
        <source>Opens a file of compensation data, .csv or .TAMtbl.</source>
        <translation>Ouvre un fichier de données de compensation, .csv ou .TAMtbl.</translation>
    </message>
    <message>
        <source>Stops reading the file.</source>
        <translation>Interrompt la lecture du fichier.</translation>
    </message>
    <message>
        <source>Stops the write and rolls back.</source>
        <translation>Arrête l&apos;écriture et restaure l&apos;ancien état.</translation>
    </message>
    <message>
        <source>Stops what is running.</source>
        <translation>Arrête l&apos;opération en cours.</translation>
    </message>
    <message>
        <source>%1 ...</source>
        <translation>%1 ...</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: its parameters may not be saved. Write to finish it.</source>
        <translation>Une écriture précédente a été interrompue&#xa0;: ses paramètres ne sont peut-être pas enregistrés. Écrire pour l&apos;achever.</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>La compensation est active.</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>La compensation est en évaluation&#xa0;: le variateur n&apos;ajoute rien.</translation>
    </message>
    <message>
        <source>This axis has no unfinished write.</source>
        <translation>Cet axe n&apos;a pas d&apos;écriture interrompue.</translation>
    </message>
    <message>
        <source>Completes the interrupted write.</source>
        <translation>Achève l&apos;écriture interrompue.</translation>
    </message>
    <message>
        <source>Restores the state before the interrupted write.</source>
        <translation>Restaure l&apos;état d&apos;avant l&apos;écriture interrompue.</translation>
    </message>
    <message>
        <source>Open a file with several columns of values first.</source>
        <translation>Ouvrir d&apos;abord un fichier avec plusieurs colonnes de valeurs.</translation>
    </message>
    <message>
        <source>The drive has no second axis with compensation registers.</source>
        <translation>Le variateur n&apos;a pas de deuxième axe avec des registres de compensation.</translation>
    </message>
    <message>
        <source>Writes several columns of the open file, each to its own axis.</source>
        <translation>Écrit plusieurs colonnes du fichier ouvert, chacune sur son axe.</translation>
    </message>
    <message>
        <source>planning</source>
        <translation>planification</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>writing several axes</source>
        <translation>écriture de plusieurs axes</translation>
    </message>
    <message>
        <source>activating</source>
        <translation>activation</translation>
    </message>
    <message>
        <source>evaluating</source>
        <translation>évaluation</translation>
    </message>
    <message>
        <source>deactivating</source>
        <translation>désactivation</translation>
    </message>
    <message>
        <source>finishing the write</source>
        <translation>achèvement de l&apos;écriture</translation>
    </message>
    <message>
        <source>undoing the write</source>
        <translation>annulation de l&apos;écriture</translation>
    </message>
    <message>
        <source>restoring</source>
        <translation>restauration</translation>
    </message>
    <message>
        <source>The record of this drive&apos;s flash operations was damaged, so all of them count as used up. Write volatile, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>Le décompte des opérations flash de ce variateur était endommagé, toutes sont donc considérées comme utilisées. Écrire en volatil ou exécuter «&#xa0;axiscomp status --reset-flash-count&#xa0;».</translation>
    </message>
    <message>
        <source>The axis has no table on the drive.</source>
        <translation>L&apos;axe n&apos;a pas de table sur le variateur.</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive; a backup is kept.</source>
        <translation>Supprime la table de l&apos;axe du variateur&#xa0;; une sauvegarde est conservée.</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>suppression de la table</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: finish or undo it first.</source>
        <translation>Une écriture précédente a été interrompue&#xa0;: l&apos;achever ou l&apos;annuler d&apos;abord.</translation>
    </message>
    <message>
        <source>Writes the table and source parameters of a TAM configuration to the drive.</source>
        <translation>Écrit dans le variateur les paramètres de tables et de sources d&apos;une configuration TAM.</translation>
    </message>
    <message>
        <source>Puts the drive&apos;s table and source parameters into a TAM configuration.</source>
        <translation>Reporte les paramètres de tables et de sources du variateur dans une configuration TAM.</translation>
    </message>
    <message>
        <source>importing parameters</source>
        <translation>importation des paramètres</translation>
    </message>
    <message>
        <source>Writes back a backup that you choose.</source>
        <translation>Restaure une sauvegarde au choix.</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up. Keep the table persistent, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>Retirer la table de la mémoire flash est aussi une opération flash, et le décompte des opérations flash de ce variateur était endommagé, toutes sont donc considérées comme utilisées. Laisser la table persistante ou exécuter «&#xa0;axiscomp status --reset-flash-count&#xa0;».</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too: wait %1, or keep the table persistent.</source>
        <translation>Retirer la table de la mémoire flash est aussi une opération flash&#xa0;: attendre %1 ou laisser la table persistante.</translation>
    </message>
    <message>
        <source>Removes the table from flash, which uses %1 of the %2 flash operations available now.</source>
        <translation>Retire la table de la mémoire flash, ce qui utilise %1 des %2 opérations flash disponibles actuellement.</translation>
    </message>
    <message>
        <source>Writes to the drive and removes the table from flash.</source>
        <translation>Écrit dans le variateur et retire la table de la mémoire flash.</translation>
    </message>
    <message>
        <source>Saves the tables and sources of all axes of the drive to a file.</source>
        <translation>Enregistre dans un fichier les tables et les sources de tous les axes du variateur.</translation>
    </message>
    <message>
        <source>Writes a backup of the whole drive back to it, axis by axis.</source>
        <translation>Réécrit une sauvegarde du variateur entier, axe par axe.</translation>
    </message>
    <message>
        <source>backing up the drive</source>
        <translation>sauvegarde du variateur</translation>
    </message>
    <message>
        <source>restoring the drive</source>
        <translation>restauration du variateur</translation>
    </message>
    <message>
        <source>What an earlier write left is not known: write again or restore another backup.</source>
        <translation>Ce qu&apos;une écriture précédente a laissé n&apos;est pas connu&#xa0;: écrire de nouveau ou restaurer une autre sauvegarde.</translation>
    </message>
    <message>
        <source>An earlier write was interrupted, and the backup of the state before it cannot be read: write again or restore another backup first.</source>
        <translation>Une écriture précédente a été interrompue, et la sauvegarde de l&apos;état qui la précédait ne peut pas être lue&#xa0;: écrire de nouveau ou restaurer une autre sauvegarde d&apos;abord.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ApplyMachineDialog</name>
    <message>
        <source>Apply Machine File</source>
        <translation>Appliquer le fichier machine</translation>
    </message>
    <message>
        <source>What %1 says is written to all drives that differ from it, or to none. Each axis is backed up first, verified, and put back when its write fails.</source>
        <translation>Le contenu de %1 est écrit dans tous les variateurs qui s&apos;en écartent, ou dans aucun. Chaque axe est d&apos;abord sauvegardé, vérifié, et remis en état si son écriture échoue.</translation>
    </message>
    <message>
        <source>Also &amp;switch compensations on and off where the file says so</source>
        <translation>Activer et désactiver aussi les &amp;compensations si le fichier l&apos;indique</translation>
    </message>
    <message>
        <source>Leave &amp;out drives that do not answer</source>
        <translation>&amp;Omettre les variateurs qui ne répondent pas</translation>
    </message>
    <message>
        <source>Otherwise nothing is written while one does not answer</source>
        <translation>Sinon, rien n&apos;est écrit tant que l&apos;un d&apos;eux ne répond pas</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Sur le variateur</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>Dans le fichier machine</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Ce qui sera écrit</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>Ap&amp;pliquer</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field and value</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and warning</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>Ce variateur ne fait plus partie des connexions.</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>It holds</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>What has become of each axis</source>
        <translation>Ce qu&apos;il est advenu de chaque axe</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and problem</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>N&apos;utilise aucune opération flash.</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>Opérations flash au total&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Stopping: each drive ends where it is safe …</source>
        <translation>Arrêt en cours&#xa0;: chaque variateur s&apos;arrête là où c&apos;est sûr …</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Écriture en cours …</translation>
    </message>
    <message>
        <source>Write these to the drives now</source>
        <translation>Écrire maintenant dans les variateurs</translation>
    </message>
    <message>
        <source>Stops the writes; those under way are rolled back (Esc)</source>
        <translation>Arrête les écritures&#xa0;; l&apos;ancien état est restauré pour celles en cours (Échap)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and proof</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Tries to prove each axis that it switches on, and names those of which nothing is proved; without it the file&apos;s “active” is only compared</source>
        <translation>Tente de valider chaque axe activé et nomme ceux pour lesquels rien n&apos;est validé&#xa0;; sans cette option, «&#xa0;active&#xa0;» du fichier est seulement comparé</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisList</name>
    <message>
        <source>The drive %1 is not connected.</source>
        <translation>Le variateur %1 n&apos;est pas connecté.</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>Cet axe n&apos;a pas de registres de compensation.</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source> (no compensation)</source>
        <translation> (sans compensation)</translation>
    </message>
    <message>
        <source> (demo)</source>
        <translation> (démo)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisState</name>
    <message>
        <source>Compensation: %1.</source>
        <translation>Compensation&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Homing: %1.</source>
        <translation>Prise d&apos;origine&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The compensation is in error: %1.</source>
        <translation>La compensation est en erreur&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The drive is in error: %1.</source>
        <translation>Le variateur est en erreur&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::BackupDialog</name>
    <message>
        <source>damaged</source>
        <comment>backup</comment>
        <translation>endommagée</translation>
    </message>
    <message>
        <source>last write</source>
        <comment>what was done after the backup</comment>
        <translation>dernière écriture</translation>
    </message>
    <message>
        <source>new table</source>
        <comment>what was done after the backup</comment>
        <translation>nouvelle table</translation>
    </message>
    <message>
        <source>table deleted</source>
        <comment>what was done after the backup</comment>
        <translation>table supprimée</translation>
    </message>
    <message>
        <source>settings changed</source>
        <comment>what was done after the backup</comment>
        <translation>réglages modifiés</translation>
    </message>
    <message>
        <source>undone, or nothing changed</source>
        <comment>what was done after the backup</comment>
        <translation>annulée, ou rien de modifié</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Restore Backup</source>
        <translation>Restaurer une sauvegarde</translation>
    </message>
    <message>
        <source>Before each write this computer keeps what the axis had. Choose what %1 shall have again; the preview shows what that changes before anything is written.</source>
        <translation>Avant chaque écriture, cet ordinateur conserve ce qu&apos;avait l&apos;axe. Choisir ce que %1 doit retrouver&#xa0;; l&apos;aperçu affiche ce qui change, avant toute écriture.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>Sauvegardes, la plus récente d&apos;abord</translation>
    </message>
    <message>
        <source>Restore the backup of an&amp;other drive to this one</source>
        <translation>Restaurer la sauvegarde d&apos;un a&amp;utre variateur sur celui-ci</translation>
    </message>
    <message>
        <source>Open Backup &amp;File…</source>
        <translation>Ouvrir un &amp;fichier de sauvegarde…</translation>
    </message>
    <message>
        <source>Choose from a file that is kept elsewhere, such as one of a drive that was replaced</source>
        <translation>Choisir dans un fichier conservé ailleurs, par exemple celui d&apos;un variateur remplacé</translation>
    </message>
    <message>
        <source>&amp;Restore…</source>
        <translation>&amp;Restaurer…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Open Backup File</source>
        <translation>Ouvrir un fichier de sauvegarde</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>Sauvegardes (*.json)</translation>
    </message>
    <message>
        <source>%1, drive %2</source>
        <comment>axis and serial number</comment>
        <translation>%1, variateur %2</translation>
    </message>
    <message>
        <source>This backup is damaged: %1</source>
        <translation>Cette sauvegarde est endommagée&#xa0;: %1</translation>
    </message>
    <message>
        <source>This backup is of the drive with the serial number %1; this one is %2.</source>
        <translation>Cette sauvegarde est celle du variateur de numéro de série %1&#xa0;; celui-ci a le numéro %2.</translation>
    </message>
    <message>
        <source>Table of the backup</source>
        <translation>Table de la sauvegarde</translation>
    </message>
    <message>
        <source>There is no backup of this drive on this computer.</source>
        <translation>Il n&apos;y a aucune sauvegarde de ce variateur sur cet ordinateur.</translation>
    </message>
    <message>
        <source>The backups are being read.</source>
        <translation>Lecture des sauvegardes en cours.</translation>
    </message>
    <message>
        <source>A damaged backup cannot be restored.</source>
        <translation>Une sauvegarde endommagée ne peut pas être restaurée.</translation>
    </message>
    <message>
        <source>Confirm first that the backup of another drive is meant.</source>
        <translation>Confirmer d&apos;abord qu&apos;il s&apos;agit bien de la sauvegarde d&apos;un autre variateur.</translation>
    </message>
    <message>
        <source>Show what restoring this backup would change</source>
        <translation>Afficher ce que changerait la restauration de cette sauvegarde</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CaptureDialog</name>
    <message>
        <source>Capture Values</source>
        <translation>Acquérir des valeurs</translation>
    </message>
    <message>
        <source>a register of the drive</source>
        <translation>un registre du variateur</translation>
    </message>
    <message>
        <source>an instrument on a serial port</source>
        <translation>un instrument sur un port série</translation>
    </message>
    <message>
        <source>typed by hand</source>
        <translation>saisie manuelle</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>Choi&amp;sir…</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>C&amp;hoisir…</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Commencer</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Take nothing and go back (Esc)</source>
        <translation>Ne rien relever et revenir (Échap)</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>The current one; something else moves it</source>
        <translation>L&apos;axe actuel&#xa0;; il est déplacé par ailleurs</translation>
    </message>
    <message>
        <source>Pla&amp;n</source>
        <translation>P&amp;lan</translation>
    </message>
    <message>
        <source>As New Program saves it</source>
        <translation>Tel que Nouveau programme l&apos;enregistre</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>&amp;Référence</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>D&apos;où elle provient</translation>
    </message>
    <message>
        <source>Re&amp;gister</source>
        <translation>Re&amp;gistre</translation>
    </message>
    <message>
        <source>Which says where the axis really is: chosen from the list, or a path, URI or address</source>
        <translation>Il indique où se trouve réellement l&apos;axe&#xa0;: choisi dans la liste, ou un chemin, une URI ou une adresse</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Of the instrument, with its speed</source>
        <translation>De l&apos;instrument, avec sa vitesse</translation>
    </message>
    <message>
        <source>Re&amp;quest</source>
        <translation>Re&amp;quête</translation>
    </message>
    <message>
        <source>Sent before each reading, with \r and \n for line ends; empty: the instrument sends by itself</source>
        <translation>Envoyée avant chaque lecture, avec \r et \n pour les fins de ligne&#xa0;; vide&#xa0;: l&apos;instrument émet de lui-même</translation>
    </message>
    <message>
        <source>Pa&amp;ttern</source>
        <translation>&amp;Motif</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line; empty: the first number of the line</source>
        <translation>Expression régulière pour le nombre dans une ligne&#xa0;; vide&#xa0;: le premier nombre de la ligne</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Unité</translation>
    </message>
    <message>
        <source>Of the numbers of the instrument</source>
        <translation>Des nombres de l&apos;instrument</translation>
    </message>
    <message>
        <source>&amp;Zero at</source>
        <translation>&amp;Zéro à</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0</source>
        <translation>Position de l&apos;axe où l&apos;instrument indique 0</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenêtre</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within this, and readings may differ by as much</source>
        <translation>L&apos;axe est à l&apos;arrêt tant que son codeur y reste, et les lectures peuvent différer d&apos;autant</translation>
    </message>
    <message>
        <source>&amp;Dwell</source>
        <translation>&amp;Temporisation</translation>
    </message>
    <message>
        <source>So long the axis must have stood before its value is taken</source>
        <translation>Temps d&apos;arrêt de l&apos;axe avant que sa valeur soit relevée</translation>
    </message>
    <message>
        <source>&amp;Average of</source>
        <translation>Mo&amp;yenne de</translation>
    </message>
    <message>
        <source>Readings that make a value</source>
        <translation>Lectures qui forment une valeur</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Valeurs</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>Fichier des valeurs&#xa0;; un fichier existant est poursuivi là où il s&apos;arrête</translation>
    </message>
    <message>
        <source>The instrument counts the &amp;other way</source>
        <translation>L&apos;instrument c&amp;ompte en sens inverse</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>Pour un instrument qui décompte quand l&apos;axe va en sens positif</translation>
    </message>
    <message>
        <source>Choose the plan</source>
        <translation>Choisir le plan</translation>
    </message>
    <message>
        <source>Choose the file of the values</source>
        <translation>Choisir le fichier des valeurs</translation>
    </message>
    <message>
        <source> readings</source>
        <translation> lectures</translation>
    </message>
    <message>
        <source>Choose Plan</source>
        <translation>Choisir un plan</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>Plans (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>File of the Values</source>
        <translation>Fichier des valeurs</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>Passes (*.csv)</translation>
    </message>
    <message>
        <source>that of the axis</source>
        <translation>celle de l&apos;axe</translation>
    </message>
    <message>
        <source>as the instrument says</source>
        <translation>comme l&apos;instrument l&apos;indique</translation>
    </message>
    <message>
        <source>that of the plan</source>
        <translation>celle du plan</translation>
    </message>
    <message>
        <source>The drive does not answer.</source>
        <translation>Le variateur ne répond pas.</translation>
    </message>
    <message>
        <source>Wait until the drive is free.</source>
        <translation>Attendre que le variateur soit libre.</translation>
    </message>
    <message>
        <source>The plan is being read …</source>
        <translation>Lecture du plan …</translation>
    </message>
    <message>
        <source>Choose a plan; New Program makes one.</source>
        <translation>Choisir un plan&#xa0;; Nouveau programme en établit un.</translation>
    </message>
    <message>
        <source>Choose the register of the reference.</source>
        <translation>Choisir le registre de la référence.</translation>
    </message>
    <message>
        <source>Name the port of the instrument, such as serial:/dev/ttyUSB1?baud=9600.</source>
        <translation>Indiquer le port de l&apos;instrument, par exemple serial:/dev/ttyUSB1?baud=9600.</translation>
    </message>
    <message>
        <source>Choose the file of the values.</source>
        <translation>Choisir le fichier des valeurs.</translation>
    </message>
    <message>
        <source>the plan just made (%1)</source>
        <translation>le plan qui vient d&apos;être établi (%1)</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>Lecture du variateur …</translation>
    </message>
    <message>
        <source>Values are taken while the control of the machine, or a person, moves the axis. This program never moves it.</source>
        <translation>Les valeurs sont relevées pendant que la commande de la machine, ou une personne, déplace l&apos;axe. Ce programme ne le déplace jamais.</translation>
    </message>
    <message>
        <source>Read axis and instrument, and take values</source>
        <translation>Lire l&apos;axe et l&apos;instrument, et relever les valeurs</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CapturePanel</name>
    <message>
        <source>Encoder</source>
        <translation>Codeur</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Reference - axis</source>
        <translation>Référence - axe</translation>
    </message>
    <message>
        <source>The reference minus where the axis is: its encoder and what the drive adds</source>
        <translation>La référence moins la position de l&apos;axe&#xa0;: son codeur et ce qu&apos;ajoute le variateur</translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation>Étapes du plan</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>R&amp;elever</translation>
    </message>
    <message>
        <source>Undo Las&amp;t</source>
        <translation>Annuler la &amp;dernière</translation>
    </message>
    <message>
        <source>Stop Capturin&amp;g</source>
        <translation>Arrêter l&apos;ac&amp;quisition</translation>
    </message>
    <message>
        <source>%1: values to %2</source>
        <translation>%1&#xa0;: valeurs dans %2</translation>
    </message>
    <message>
        <source>T&amp;he instrument says [%1]</source>
        <translation>&amp;Lecture [%1]</translation>
    </message>
    <message>
        <source>What the instrument says, in %1</source>
        <translation>Ce qu&apos;indique l&apos;instrument, en %1</translation>
    </message>
    <message>
        <source>Nothing is being taken</source>
        <translation>Aucune acquisition en cours</translation>
    </message>
    <message>
        <source>The drive does not answer</source>
        <translation>Le variateur ne répond pas</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>Re&amp;prendre</translation>
    </message>
    <message>
        <source>Paus&amp;e</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Take what was typed for the step that is due (Enter or space bar)</source>
        <translation>Relever ce qui a été saisi pour l&apos;étape à mesurer (Entrée ou barre d&apos;espace)</translation>
    </message>
    <message>
        <source>A position is asked for as soon as the axis stands at the target that is due</source>
        <translation>Une position est demandée dès que l&apos;axe est à l&apos;arrêt à la position cible à mesurer</translation>
    </message>
    <message>
        <source>No value has been taken yet</source>
        <translation>Aucune valeur n&apos;a encore été relevée</translation>
    </message>
    <message>
        <source>Take the last value off the file; its step is due again</source>
        <translation>Retirer la dernière valeur du fichier&#xa0;; son étape est de nouveau à mesurer</translation>
    </message>
    <message>
        <source>Go on; the axis has to come to its target once more</source>
        <translation>Continuer&#xa0;; l&apos;axe doit revenir à sa position cible</translation>
    </message>
    <message>
        <source>Take nothing until Resume, such as while somebody works at the machine</source>
        <translation>Ne rien relever jusqu&apos;à la reprise, par exemple pendant une intervention sur la machine</translation>
    </message>
    <message>
        <source>End here; what was taken stays in the file, and Capture goes on behind it with the same plan</source>
        <translation>Terminer ici&#xa0;; ce qui a été relevé reste dans le fichier, et Acquérir poursuit à la suite avec le même plan</translation>
    </message>
    <message>
        <source>The drive does not say the unit of the axis: it is taken to be that of the plan.</source>
        <translation>Le variateur n&apos;indique pas l&apos;unité de l&apos;axe&#xa0;: celle du plan est supposée.</translation>
    </message>
    <message>
        <source>The clock of this computer is behind the last value of the file: times go on from there.</source>
        <translation>L&apos;horloge de cet ordinateur est en retard sur la dernière valeur du fichier&#xa0;: les temps se poursuivent à partir de là.</translation>
    </message>
    <message>
        <source>The reference is a Single: at %1 its numbers are %2 apart.</source>
        <translation>La référence est un Single&#xa0;: à %1, ses nombres sont espacés de %2.</translation>
    </message>
    <message>
        <source>The instrument is far from the axis, as if it said 0 at %1: if that is right, begin a new file with this as the zero.</source>
        <translation>L&apos;instrument est loin de l&apos;axe, comme s&apos;il indiquait 0 à %1&#xa0;: si c&apos;est exact, commencer un nouveau fichier avec ce zéro.</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, upwards from %3.</source>
        <translation>Étape %1 à mesurer&#xa0;: %2, en sens positif depuis %3.</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, downwards from %3.</source>
        <translation>Étape %1 à mesurer&#xa0;: %2, en sens négatif depuis %3.</translation>
    </message>
    <message>
        <source>The axis stands at step %1: %2 of %3 readings.</source>
        <translation>L&apos;axe est à l&apos;arrêt à l&apos;étape %1&#xa0;: %2 lectures sur %3.</translation>
    </message>
    <message>
        <source>The axis stands; it is waited until it has come to rest.</source>
        <translation>L&apos;axe est à l&apos;arrêt&#xa0;; attente de sa stabilisation.</translation>
    </message>
    <message>
        <source>The axis stands at step %1: read the instrument, and type what it says.</source>
        <translation>L&apos;axe est à l&apos;arrêt à l&apos;étape %1&#xa0;: lire l&apos;instrument et saisir ce qu&apos;il indique.</translation>
    </message>
    <message>
        <source>Taken. %1</source>
        <translation>Relevé. %1</translation>
    </message>
    <message>
        <source>The axis moves. %1</source>
        <translation>L&apos;axe se déplace. %1</translation>
    </message>
    <message>
        <source>%1 of %2 values are in %3.</source>
        <translation>%1 valeurs sur %2 sont dans %3.</translation>
    </message>
    <message>
        <source>Every step has its value: %1 values are in %2.</source>
        <translation>Chaque étape a sa valeur&#xa0;: %1 valeurs sont dans %2.</translation>
    </message>
    <message>
        <source>Stopped. %1 Capture goes on behind them with the same plan and file.</source>
        <translation>Arrêté. %1 Acquérir poursuit à la suite avec le même plan et le même fichier.</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>Lecture du variateur …</translation>
    </message>
    <message>
        <source>Nothing is taken: %1 It goes on when the drive answers again.</source>
        <translation>Aucun relevé&#xa0;: %1 La suite reprend quand le variateur répond de nouveau.</translation>
    </message>
    <message>
        <source>Nothing is taken while the window does something else on this drive.</source>
        <translation>Aucun relevé pendant que la fenêtre effectue une autre opération sur ce variateur.</translation>
    </message>
    <message>
        <source>Paused: nothing is taken. %1</source>
        <translation>En pause&#xa0;: aucun relevé. %1</translation>
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
        <translation>sens positif</translation>
    </message>
    <message>
        <source>down</source>
        <translation>sens négatif</translation>
    </message>
    <message>
        <source>Deviations that were taken</source>
        <translation>Écarts relevés</translation>
    </message>
    <message>
        <source>The same values are in the list of steps</source>
        <translation>Les mêmes valeurs figurent dans la liste des étapes</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateButton</name>
    <message>
        <source>Forget Cert&amp;ificate</source>
        <translation>Oublier le cert&amp;ificat</translation>
    </message>
    <message>
        <source>Cert&amp;ificate …</source>
        <translation>Cert&amp;ificat …</translation>
    </message>
    <message>
        <source>Stop trusting the certificate of the selected drive</source>
        <translation>Ne plus accepter le certificat du variateur sélectionné</translation>
    </message>
    <message>
        <source>Show the certificate of the selected drive and decide whether to trust it</source>
        <translation>Afficher le certificat du variateur sélectionné et décider de l&apos;accepter ou non</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateDialog</name>
    <message>
        <source>Drive Certificate</source>
        <translation>Certificat du variateur</translation>
    </message>
    <message>
        <source>The certificate of this drive has CHANGED since it was trusted. Either the drive has a new one, or another device answers at its address.</source>
        <translation>Le certificat de ce variateur a CHANGÉ depuis qu&apos;il a été accepté. Soit le variateur en a un nouveau, soit un autre appareil répond à son adresse.</translation>
    </message>
    <message>
        <source>No authority known to this computer has signed this certificate, so the identity of the drive cannot be confirmed.</source>
        <translation>Aucune autorité connue de cet ordinateur n&apos;a signé ce certificat, l&apos;identité du variateur ne peut donc pas être confirmée.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Délivré à</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Délivré par</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Validité</translation>
    </message>
    <message>
        <source>SHA-256 fingerprint</source>
        <translation>Empreinte SHA-256</translation>
    </message>
    <message>
        <source>from %1 until %2</source>
        <translation>du %1 au %2</translation>
    </message>
    <message>
        <source>Trust it only if the drive itself, or its administrator, shows the same fingerprint. From then on this address is accepted with this certificate only.</source>
        <translation>Ne l&apos;accepter que si le variateur lui-même, ou son administrateur, affiche la même empreinte. Dès lors, cette adresse n&apos;est admise qu&apos;avec ce certificat.</translation>
    </message>
    <message>
        <source>Do &amp;Not Trust</source>
        <translation>&amp;Ne pas accepter</translation>
    </message>
    <message>
        <source>Stay disconnected (Esc)</source>
        <translation>Rester déconnecté (Échap)</translation>
    </message>
    <message>
        <source>&amp;Trust This Certificate</source>
        <translation>&amp;Accepter ce certificat</translation>
    </message>
    <message>
        <source>Accept this certificate for this address from now on</source>
        <translation>Accepter désormais ce certificat pour cette adresse</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ChangePictures</name>
    <message>
        <source>On the drive</source>
        <translation>Sur le variateur</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Difference, new − old</source>
        <translation>Différence, nouveau − ancien</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>maximum %1</translation>
    </message>
    <message>
        <source>%1; shown: the middle slice, %2 %3</source>
        <comment>largest value, dimension, place</comment>
        <translation>%1&#xa0;; affichée&#xa0;: la coupe du milieu, %2 %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>value at position</comment>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>jusqu&apos;à %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnMapping</name>
    <message>
        <source>Select at least one axis.</source>
        <translation>Sélectionner au moins un axe.</translation>
    </message>
    <message>
        <source>%1 is selected twice; an axis has only one table.</source>
        <translation>%1 est sélectionné deux fois&#xa0;; un axe n&apos;a qu&apos;une table.</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnMappingTable</name>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>Colonne du fichier</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Which column is for which axis</source>
        <translation>Quelle colonne est pour quel axe</translation>
    </message>
    <message>
        <source>none</source>
        <comment>axis</comment>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Axis for %1</source>
        <translation>Axe pour %1</translation>
    </message>
    <message>
        <source>The axis for column %1</source>
        <translation>L&apos;axe pour la colonne %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnPreview</name>
    <message>
        <source>Columns of the file</source>
        <translation>Colonnes du fichier</translation>
    </message>
    <message>
        <source>by its name</source>
        <translation>d&apos;après son nom</translation>
    </message>
    <message>
        <source>What column %1 is</source>
        <translation>Rôle de la colonne %1</translation>
    </message>
    <message>
        <source>What this column is. Once one is chosen, only chosen columns are read; until then the names of the columns say it.</source>
        <translation>Le rôle de cette colonne. Dès qu&apos;un rôle est choisi, seules les colonnes choisies sont lues&#xa0;; jusque-là, les noms des colonnes en décident.</translation>
    </message>
    <message>
        <source>%1 in column %2</source>
        <translation>%1 en colonne %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnProposal</name>
    <message>
        <source>Proposed, as you chose it for the last file with these columns: %1.</source>
        <translation>Proposé, selon le choix fait pour le dernier fichier ayant ces colonnes&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Use T&amp;hese</source>
        <translation>Utili&amp;ser ce choix</translation>
    </message>
    <message>
        <source>Read the columns of this file in the same way</source>
        <translation>Lire les colonnes de ce fichier de la même façon</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ComparisonFiguresModel</name>
    <message>
        <source>no tolerance</source>
        <translation>aucune tolérance</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>non défini</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>column and its value</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>figure and its values</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Caractéristique</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Prévu</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>Hors ajustement</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>What is left at targets that the table was made without: the figure to believe</source>
        <translation>Ce qui reste aux positions cibles sans lesquelles la table a été établie&#xa0;: la valeur à laquelle se fier</translation>
    </message>
    <message>
        <source>Before, all values</source>
        <translation>Avant, toutes les valeurs</translation>
    </message>
    <message>
        <source>After, all values</source>
        <translation>Après, toutes les valeurs</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CompensationWizard</name>
    <message>
        <source>Axis Compensation Wizard</source>
        <translation>Assistant de compensation d&apos;axes</translation>
    </message>
    <message>
        <source>%1 is opened as soon as that is possible. %2</source>
        <translation>%1 sera ouvert dès que possible. %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConditionsModel</name>
    <message>
        <source>Condition of ISO 230-2</source>
        <translation>Condition de l&apos;ISO 230-2</translation>
    </message>
    <message>
        <source>Met?</source>
        <translation>Remplie&#xa0;?</translation>
    </message>
    <message>
        <source>%1 (assumption)</source>
        <translation>%1 (hypothèse)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConnectionsDialog</name>
    <message>
        <source>Use the drives of the list</source>
        <translation>Utiliser les variateurs de la liste</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>Abandonner les modifications (Échap)</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Connexions</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Variateur</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifier</translation>
    </message>
    <message>
        <source>Change the address of the chosen connection</source>
        <translation>Modifier l&apos;adresse de la connexion choisie</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Remove the chosen connection</source>
        <translation>Retirer la connexion choisie</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Tester</translation>
    </message>
    <message>
        <source>Ask the drive at the selected address to identify itself</source>
        <translation>Demander au variateur à l&apos;adresse sélectionnée de s&apos;identifier</translation>
    </message>
    <message>
        <source>De&amp;mo Drive</source>
        <translation>Variateur de &amp;démo</translation>
    </message>
    <message>
        <source>Add the built-in demo drive to try everything without hardware</source>
        <translation>Ajouter le variateur de démonstration intégré, pour tout essayer sans matériel</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>Adr&amp;esse</translation>
    </message>
    <message>
        <source>%1 (demo)</source>
        <translation>%1 (démo)</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>connecté</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>connexion …</translation>
    </message>
    <message>
        <source>answers; serial number %1, axes: %2</source>
        <translation>répond&#xa0;; numéro de série %1, axes&#xa0;: %2</translation>
    </message>
    <message>
        <source>asking …</source>
        <translation>interrogation …</translation>
    </message>
    <message>
        <source>This address is already in the list.</source>
        <translation>Cette adresse est déjà dans la liste.</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>Interrogation de %1 …</translation>
    </message>
    <message>
        <source>Added, but not answering yet: %1</source>
        <translation>Ajouté, mais sans réponse pour l&apos;instant&#xa0;: %1</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>A&amp;jouter</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>Chan&amp;ger</translation>
    </message>
    <message>
        <source>Checks the address and adds it to the list</source>
        <translation>Vérifie l&apos;adresse et l&apos;ajoute à la liste</translation>
    </message>
    <message>
        <source>Not possible while a drive is being written</source>
        <translation>Impossible pendant une écriture dans un variateur</translation>
    </message>
    <message>
        <source>Drives are reached through their web server, such as http://192.168.1.20, or a serial line, such as serial:/dev/ttyUSB0. A web address may contain a user name and password (http://user:password@host); they are used until the program ends and never stored.</source>
        <translation>Les variateurs sont joints par leur serveur web, par exemple http://192.168.1.20, ou par une liaison série, par exemple serial:/dev/ttyUSB0. Une adresse web peut contenir un nom d&apos;utilisateur et un mot de passe (http://utilisateur:motdepasse@hôte)&#xa0;; ils servent jusqu&apos;à la fin du programme et ne sont jamais enregistrés.</translation>
    </message>
    <message>
        <source>&amp;Find …</source>
        <translation>Rec&amp;hercher …</translation>
    </message>
    <message>
        <source>Search the serial ports of this computer for drives</source>
        <translation>Rechercher des variateurs sur les ports série de cet ordinateur</translation>
    </message>
    <message>
        <source>The address of a drive&apos;s web server, or a serial port</source>
        <translation>L&apos;adresse du serveur web d&apos;un variateur, ou un port série</translation>
    </message>
    <message>
        <source>The certificate of %1 is no longer trusted.</source>
        <translation>Le certificat de %1 n&apos;est plus accepté.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ControllerCombo</name>
    <message>
        <source>As applied by %1</source>
        <translation>Appliquée par %1</translation>
    </message>
    <message>
        <source>The table as the drive applies it, or converted to another controller&apos;s convention: its sign, and its rules beyond the ends</source>
        <translation>La table telle que le variateur l&apos;applique, ou convertie selon la convention d&apos;une autre commande&#xa0;: son signe et ses règles au-delà des extrémités</translation>
    </message>
    <message>
        <source>Applied by</source>
        <translation>Appliquée par</translation>
    </message>
    <message>
        <source>As on the drive</source>
        <translation>Comme le variateur</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Change nothing (Esc)</source>
        <translation>Ne rien changer (Échap)</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>&amp;Résultat</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>What the conversion does to the numbers, with an example</source>
        <translation>Ce que la conversion fait aux nombres, avec un exemple</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Calcul en cours …</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionForm</name>
    <message>
        <source>Choose the format.</source>
        <translation>Choisir le format.</translation>
    </message>
    <message>
        <source>Enter a number for the even grid.</source>
        <translation>Saisir un nombre pour la grille régulière.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number, and no list such as 21; 31.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est ni un nombre ni une liste telle que 21; 31.</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Sign</source>
        <translation>&amp;Signe</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>Se&amp;ns</translation>
    </message>
    <message>
        <source>&amp;Between points</source>
        <translation>&amp;Entre les points</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a &amp;linear one</source>
        <translation>Traiter un axe modulo comme &amp;linéaire</translation>
    </message>
    <message>
        <source>&amp;Hold the end values beyond the data</source>
        <translation>Maintenir les &amp;valeurs d&apos;extrémité au-delà des données</translation>
    </message>
    <message>
        <source>The format that the file is read as</source>
        <translation>Le format selon lequel le fichier est lu</translation>
    </message>
    <message>
        <source>The format of the new file</source>
        <translation>Le format du nouveau fichier</translation>
    </message>
    <message>
        <source>Whether the file&apos;s values are added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>Si les valeurs du fichier s&apos;ajoutent à la position du codeur (côté codeur) ou à la position de consigne (côté consigne)</translation>
    </message>
    <message>
        <source>Whether the new file&apos;s values are to be added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>Si les valeurs du nouveau fichier doivent s&apos;ajouter à la position du codeur (côté codeur) ou à la position de consigne (côté consigne)</translation>
    </message>
    <message>
        <source>The drive holds one value for both directions of motion; choose which one</source>
        <translation>Le variateur a une seule valeur pour les deux sens de déplacement&#xa0;; choisir laquelle</translation>
    </message>
    <message>
        <source>For an axis that stays within one revolution: the table is used as it is</source>
        <translation>Pour un axe qui reste dans un seul tour&#xa0;: la table est utilisée telle quelle</translation>
    </message>
    <message>
        <source>Brings the table onto evenly spaced positions</source>
        <translation>Ramène la table à des positions équidistantes</translation>
    </message>
    <message>
        <source>How the values between the positions of the table are made</source>
        <translation>Comment sont établies les valeurs entre les positions de la table</translation>
    </message>
    <message>
        <source>The even grid may end beyond the last position</source>
        <translation>La grille régulière peut finir au-delà de la dernière position</translation>
    </message>
    <message>
        <source>choose the format</source>
        <translation>choisir le format</translation>
    </message>
    <message>
        <source>as the format says</source>
        <translation>selon le format</translation>
    </message>
    <message>
        <source>as the format says: feedback</source>
        <translation>selon le format&#xa0;: feedback</translation>
    </message>
    <message>
        <source>as the format says: command</source>
        <translation>selon le format&#xa0;: command</translation>
    </message>
    <message>
        <source>feedback: added to the encoder position</source>
        <translation>feedback&#xa0;: ajouté à la position du codeur</translation>
    </message>
    <message>
        <source>command: added to the commanded position</source>
        <translation>command&#xa0;: ajouté à la position de consigne</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>à choisir</translation>
    </message>
    <message>
        <source>the mean of both directions</source>
        <translation>la moyenne des deux sens</translation>
    </message>
    <message>
        <source>the values of the positive direction</source>
        <translation>les valeurs du sens positif</translation>
    </message>
    <message>
        <source>the values of the negative direction</source>
        <translation>les valeurs du sens négatif</translation>
    </message>
    <message>
        <source>the positions of the table</source>
        <translation>les positions de la table</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>un nombre de points</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>un pas</translation>
    </message>
    <message>
        <source>coarsest within a deviation</source>
        <translation>la moins fine dans un écart donné</translation>
    </message>
    <message>
        <source>linear, as controllers do</source>
        <translation>linéaire, comme les commandes</translation>
    </message>
    <message>
        <source>smooth (monotone cubic)</source>
        <translation>lisse (cubique monotone)</translation>
    </message>
    <message>
        <source>&amp;Number of points</source>
        <translation>Nombre de &amp;points</translation>
    </message>
    <message>
        <source>At least 2; one number for all sources, or one for each: 21; 31</source>
        <translation>Au moins 2&#xa0;; un nombre pour toutes les sources, ou un pour chacune&#xa0;: 21; 31</translation>
    </message>
    <message>
        <source>Dista&amp;nce</source>
        <translation>&amp;Pas</translation>
    </message>
    <message>
        <source>In the unit of the positions; one number for all sources, or one for each: 5; 10</source>
        <translation>Dans l&apos;unité des positions&#xa0;; un nombre pour toutes les sources, ou un pour chacune&#xa0;: 5; 10</translation>
    </message>
    <message>
        <source>Deviatio&amp;n</source>
        <translation>Écart a&amp;dmis</translation>
    </message>
    <message>
        <source>In the unit of the values; the coarsest grid within it is used</source>
        <translation>Dans l&apos;unité des valeurs&#xa0;; la grille la moins fine qui le respecte est utilisée</translation>
    </message>
    <message>
        <source>Target &amp;axis</source>
        <translation>Axe &amp;cible</translation>
    </message>
    <message>
        <source>The axis that the values correct: one of the sources, or another axis; the sign is converted accordingly</source>
        <translation>L&apos;axe que les valeurs corrigent&#xa0;: l&apos;une des sources ou un autre axe&#xa0;; le signe est converti en conséquence</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>selon le fichier</translation>
    </message>
    <message>
        <source>as the table says</source>
        <translation>selon la table</translation>
    </message>
    <message>
        <source>the first source</source>
        <translation>la première source</translation>
    </message>
    <message>
        <source>the second source</source>
        <translation>la deuxième source</translation>
    </message>
    <message>
        <source>the third source</source>
        <translation>la troisième source</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>un autre axe</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tolerance: enter a number above 0, or nothing.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une tolérance&#xa0;: saisir un nombre supérieur à 0, ou rien.</translation>
    </message>
    <message>
        <source>Missin&amp;g points</source>
        <translation>Points &amp;manquants</translation>
    </message>
    <message>
        <source>Snap &amp;tolerance</source>
        <translation>Tolérance d&apos;accroc&amp;hage</translation>
    </message>
    <message>
        <source>&amp;Even grid</source>
        <translation>&amp;Grille régulière</translation>
    </message>
    <message>
        <source>What becomes of points of the grid that have no value</source>
        <translation>Ce que deviennent les points de la grille sans valeur</translation>
    </message>
    <message>
        <source>Positions that are this close to an even grid are taken for its positions, in their unit; empty: as they stand in the file</source>
        <translation>Les positions aussi proches d&apos;une grille régulière sont prises pour les siennes, dans leur unité&#xa0;; vide&#xa0;: comme dans le fichier</translation>
    </message>
    <message>
        <source>none may be missing</source>
        <translation>aucun ne doit manquer</translation>
    </message>
    <message>
        <source>filled with the nearest measured value</source>
        <translation>remplis par la valeur mesurée la plus proche</translation>
    </message>
    <message>
        <source>filled from the plane through all points</source>
        <translation>remplis par le plan passant par tous les points</translation>
    </message>
    <message>
        <source>filled smoothly, with the least bending</source>
        <translation>remplis en lissant, courbure minimale</translation>
    </message>
    <message>
        <source>left out: the grid is cropped</source>
        <translation>omis&#xa0;: la grille est rognée</translation>
    </message>
    <message>
        <source>spline (natural cubic)</source>
        <translation>spline (cubique naturelle)</translation>
    </message>
    <message>
        <source>without noise (smoothing spline)</source>
        <translation>sans bruit (spline de lissage)</translation>
    </message>
    <message>
        <source>choose one; feedback is assumed</source>
        <translation>à choisir&#xa0;; feedback est supposé</translation>
    </message>
    <message>
        <source>choose one; command is assumed</source>
        <translation>à choisir&#xa0;; command est supposé</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CorrectionsDialog</name>
    <message>
        <source>%1 mm; runs with their air: %2</source>
        <translation>%1 mm&#xa0;; passes avec leur air&#xa0;: %2</translation>
    </message>
    <message>
        <source>not corrected for</source>
        <translation>non corrigé</translation>
    </message>
    <message>
        <source>Enter temperatures and coefficients as numbers; only the position that does not move may be left empty.</source>
        <translation>Saisir les températures et les coefficients sous forme de nombres&#xa0;; seule la position qui ne bouge pas peut rester vide.</translation>
    </message>
    <message>
        <source>The file does not say whether its values are at 20 °C already. Only values that are not may be corrected.</source>
        <translation>Le fichier n&apos;indique pas si ses valeurs sont déjà à 20 °C. Seules des valeurs qui ne le sont pas peuvent être corrigées.</translation>
    </message>
    <message>
        <source>Corrections Before Judging</source>
        <translation>Corrections avant l&apos;analyse</translation>
    </message>
    <message>
        <source>&amp;Bring the values to 20 °C</source>
        <translation>&amp;Ramener les valeurs à 20 °C</translation>
    </message>
    <message>
        <source>&amp;Temperature of the scale [°C]</source>
        <translation>&amp;Température de la règle [°C]</translation>
    </message>
    <message>
        <source>&amp;Expansion of the scale [%1]</source>
        <translation>&amp;Dilatation de la règle [%1]</translation>
    </message>
    <message>
        <source>Temperature of the &amp;reference [°C]</source>
        <translation>Te&amp;mpérature de la référence [°C]</translation>
    </message>
    <message>
        <source>E&amp;xpansion of the reference [%1]</source>
        <translation>Di&amp;latation de la référence [%1]</translation>
    </message>
    <message>
        <source>&amp;Position that does not move [mm]</source>
        <translation>&amp;Position qui ne bouge pas [mm]</translation>
    </message>
    <message>
        <source>Of the material that the axis is measured by</source>
        <translation>Du matériau selon lequel l&apos;axe est mesuré</translation>
    </message>
    <message>
        <source>Of the same material; steel has about 11.5</source>
        <translation>Du même matériau&#xa0;; l&apos;acier a environ 11,5</translation>
    </message>
    <message>
        <source>Of the measuring instrument</source>
        <translation>De l&apos;instrument de mesure</translation>
    </message>
    <message>
        <source>0 for a laser that is compensated for its wavelength</source>
        <translation>0 pour un laser compensé en longueur d&apos;onde</translation>
    </message>
    <message>
        <source>Empty: the first target</source>
        <translation>Vide&#xa0;: la première position cible</translation>
    </message>
    <message>
        <source>the first target</source>
        <translation>la première position cible</translation>
    </message>
    <message>
        <source>&amp;Steel</source>
        <translation>Ac&amp;ier</translation>
    </message>
    <message>
        <source>Enter the coefficient of steel, 11.5 µm/(m·K)</source>
        <translation>Saisir le coefficient de l&apos;acier, 11,5 µm/(m·K)</translation>
    </message>
    <message>
        <source>The instrument has &amp;not corrected the values itself</source>
        <translation>L&apos;instrument &amp;n&apos;a pas corrigé lui-même les valeurs</translation>
    </message>
    <message>
        <source>Needed where the file does not say it</source>
        <translation>Nécessaire si le fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>Dead path of the interferometer</source>
        <translation>Trajet mort de l&apos;interféromètre</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>R&amp;etirer</translation>
    </message>
    <message>
        <source>Do not correct for the dead path</source>
        <translation>Ne pas corriger le trajet mort</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>&amp;Corriger</translation>
    </message>
    <message>
        <source>Judge the values with these corrections</source>
        <translation>Analyser les valeurs avec ces corrections</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Leave the corrections as they are (Esc)</source>
        <translation>Laisser les corrections telles quelles (Échap)</translation>
    </message>
    <message>
        <source>A JSON file with its length and the air of each run</source>
        <translation>Un fichier JSON avec sa longueur et l&apos;air de chaque passe</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DataFileField</name>
    <message>
        <source>No file is open</source>
        <translation>Aucun fichier ouvert</translation>
    </message>
    <message>
        <source>Open a file of compensation data, or drop it on the window (Ctrl+O)</source>
        <translation>Ouvrir un fichier de données de compensation ou le déposer sur la fenêtre (Ctrl+O)</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>aucun fichier</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>Fichier ouvert</translation>
    </message>
    <message>
        <source>The name of the open file of compensation data</source>
        <translation>Le nom du fichier ouvert de données de compensation</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Lecture du fichier</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ouvr&amp;ir…</translation>
    </message>
    <message>
        <source>Opens a file of compensation data</source>
        <translation>Ouvre un fichier de données de compensation</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>Arrê&amp;ter</translation>
    </message>
    <message>
        <source>Stop reading the file</source>
        <translation>Interrompre la lecture du fichier</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Aucun fichier récent</translation>
    </message>
    <message>
        <source>&amp;Read Again</source>
        <translation>&amp;Relire</translation>
    </message>
    <message>
        <source>&amp;Close File</source>
        <translation>&amp;Fermer le fichier</translation>
    </message>
    <message>
        <source>Import &amp;Options…</source>
        <translation>&amp;Options d&apos;importation…</translation>
    </message>
    <message>
        <source>Format, sign and grid of the open file</source>
        <translation>Format, signe et grille du fichier ouvert</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationCanvas</name>
    <message>
        <source>smallest and largest value</source>
        <translation>plus petite et plus grande valeur</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>proposé pour exclusion</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationPlot</name>
    <message>
        <source>Deviation over position</source>
        <translation>Écart selon la position</translation>
    </message>
    <message>
        <source>A click selects a value; arrow keys go from value to value. The wheel and + and - zoom, dragging moves, Home or a double click shows everything.</source>
        <translation>Un clic sélectionne une valeur&#xa0;; les flèches vont de valeur en valeur. La molette ainsi que + et - zooment, un glissement déplace, Début ou un double-clic affiche tout.</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>passe %1, %2</translation>
    </message>
    <message>
        <source>target %1 %2, ↑ %3, ↓ %4 %5, B %6 %5</source>
        <translation>cible %1 %2, ↑ %3, ↓ %4 %5, B %6 %5</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftDetails</name>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Sur le variateur</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>Dans le fichier machine</translation>
    </message>
    <message>
        <source>How the axis differs from the machine file</source>
        <translation>En quoi l&apos;axe diffère du fichier machine</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis, and how it stands to the machine file</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftModel</name>
    <message>
        <source>Drift of the runs</source>
        <translation>Dérive des passes</translation>
    </message>
    <message>
        <source>Runs ↑</source>
        <translation>Passes ↑</translation>
    </message>
    <message>
        <source>Runs ↓</source>
        <translation>Passes ↓</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>From the first to the last run</source>
        <translation>De la première à la dernière passe</translation>
    </message>
    <message>
        <source>From run to run</source>
        <translation>D&apos;une passe à l&apos;autre</translation>
    </message>
    <message>
        <source>Per hour</source>
        <translation>Par heure</translation>
    </message>
    <message>
        <source>Per kelvin</source>
        <translation>Par kelvin</translation>
    </message>
    <message>
        <source>s without the offsets of the runs</source>
        <translation>s sans les décalages des passes</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>A without the offsets of the runs</source>
        <translation>A sans les décalages des passes</translation>
    </message>
    <message>
        <source>R without the offsets of the runs</source>
        <translation>R sans les décalages des passes</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>suspectée</translation>
    </message>
    <message>
        <source>not suspected</source>
        <translation>non suspectée</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftPlot</name>
    <message>
        <source>%1, run %2: offset %3</source>
        <translation>%1, passe %2&#xa0;: décalage %3</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Passe</translation>
    </message>
    <message>
        <source>Offset of the run</source>
        <translation>Décalage de la passe</translation>
    </message>
    <message>
        <source>runs ↑</source>
        <translation>passes ↑</translation>
    </message>
    <message>
        <source>runs ↓</source>
        <translation>passes ↓</translation>
    </message>
    <message>
        <source>Drift: offsets of the runs</source>
        <translation>Dérive&#xa0;: décalages des passes</translation>
    </message>
    <message>
        <source>How far each run lies beside the mean of its direction. A click or the arrow keys select a run.</source>
        <translation>À quelle distance chaque passe se trouve de la moyenne de son sens. Un clic ou les flèches sélectionnent une passe.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftText</name>
    <message>
        <source>not in the file</source>
        <comment>axis</comment>
        <translation>absent du fichier</translation>
    </message>
    <message>
        <source>not among the connections</source>
        <comment>drive</comment>
        <translation>absent des connexions</translation>
    </message>
    <message>
        <source>is being compared …</source>
        <translation>comparaison …</translation>
    </message>
    <message>
        <source>not reachable</source>
        <comment>drive</comment>
        <translation>injoignable</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>non comparable</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>conforme au fichier</translation>
    </message>
    <message>
        <source>%1 (compared at %2)</source>
        <comment>state and time</comment>
        <translation>%1 (comparé à %2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>table and grid</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>persistante</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>volatile</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>non définie</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>activée</translation>
    </message>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>Earlier write</source>
        <translation>Écriture précédente</translation>
    </message>
    <message>
        <source>did not end</source>
        <translation>non terminée</translation>
    </message>
    <message>
        <source>is ended by the next write</source>
        <translation>terminée par la prochaine écriture</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Compensation</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>%1 (serial number %2)</source>
        <comment>address of a drive</comment>
        <translation>%1 (numéro de série %2)</translation>
    </message>
    <message>
        <source>%1, axis %2</source>
        <comment>drive and axis</comment>
        <translation>%1, axe %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and problem</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <comment>file, line and problem</comment>
        <translation>%1, ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>This cannot be written now: %1</source>
        <translation>Écriture impossible actuellement&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveBar</name>
    <message>
        <source>%1 (demo)</source>
        <translation>%1 (démo)</translation>
    </message>
    <message>
        <source>&amp;Drive</source>
        <translation>&amp;Variateur</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Variateur</translation>
    </message>
    <message>
        <source>The drive of the chosen axis, and its address</source>
        <translation>Le variateur de l&apos;axe choisi et son adresse</translation>
    </message>
    <message>
        <source>The drive of the selected axis; lists all drives under Connections</source>
        <translation>Le variateur de l&apos;axe sélectionné&#xa0;; liste tous les variateurs des connexions</translation>
    </message>
    <message>
        <source>Co&amp;nnections…</source>
        <translation>Conne&amp;xions…</translation>
    </message>
    <message>
        <source>Add, test or remove drives</source>
        <translation>Ajouter, tester ou retirer des variateurs</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>Rafraîc&amp;hir</translation>
    </message>
    <message>
        <source>More: language, log, settings</source>
        <translation>Autres&#xa0;: langue, journal, réglages</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>no drive</source>
        <translation>aucun variateur</translation>
    </message>
    <message>
        <source>no drive: add one under Connections</source>
        <translation>aucun variateur&#xa0;: en ajouter un dans Connexions</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>connexion …</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>connecté</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>connexion perdue, reconnexion en cours</translation>
    </message>
    <message>
        <source>Search for axes again and read everything from the drives (F5)</source>
        <translation>Rechercher de nouveau les axes et tout relire sur les variateurs (F5)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveList</name>
    <message>
        <source>Connected to %1 (%2).</source>
        <translation>Connecté à %1 (%2).</translation>
    </message>
    <message>
        <source>A different drive now answers at %1: %2. Unwritten changes were discarded.</source>
        <translation>Un autre variateur répond maintenant à %1&#xa0;: %2. Les modifications non écrites ont été abandonnées.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DropFrame</name>
    <message>
        <source>Drop to open %1</source>
        <translation>Déposer pour ouvrir %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExaggerationCombo</name>
    <message>
        <source>Exaggeration</source>
        <translation>Amplification</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>adaptée</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportConfigurationDialog</name>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>Exporter vers une configuration TAM</translation>
    </message>
    <message>
        <source>Puts the table and source parameters of %1 into %2. Everything else in the file stays as it is; nothing on the drive changes.</source>
        <translation>Reporte les paramètres de tables et de sources de %1 dans %2. Le reste du fichier ne change pas&#xa0;; rien ne change sur le variateur.</translation>
    </message>
    <message>
        <source>What the drive has</source>
        <translation>Ce qu&apos;a le variateur</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Sources</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>&amp;Enregistrer sous…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>Ne rien changer et revenir (Échap)</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>aucune table</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>Lecture du variateur …</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Comparaison …</translation>
    </message>
    <message>
        <source>The configuration has all of this already.</source>
        <translation>La configuration a déjà tout cela.</translation>
    </message>
    <message>
        <source>Choose where to save the configuration</source>
        <translation>Choisir où enregistrer la configuration</translation>
    </message>
    <message>
        <source>In the file, only Table and Dim1Source to Dim3Source of these axes will change.</source>
        <translation>Dans le fichier, seuls changent Table et Dim1Source à Dim3Source de ces axes.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportDialog</name>
    <message>
        <source>Export for Another Controller</source>
        <translation>Exporter pour une autre commande</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file for another controller. Nothing on the drive changes.</source>
        <translation>Écrit la table «&#xa0;%1&#xa0;» dans un fichier pour une autre commande. Rien ne change sur le variateur.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Choose where to save the file</source>
        <translation>Choisir où enregistrer le fichier</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Enregistrer la table</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file of the drive or of another controller. Nothing on the drive changes.</source>
        <translation>Écrit la table «&#xa0;%1&#xa0;» dans un fichier du variateur ou d&apos;une autre commande. Rien ne change sur le variateur.</translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation>Enreg&amp;istrer…</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FieldRow</name>
    <message>
        <source>Revert %1</source>
        <translation>Rétablir %1</translation>
    </message>
    <message>
        <source>changed, on the drive: %1</source>
        <translation>modifié, sur le variateur&#xa0;: %1</translation>
    </message>
    <message>
        <source>on the drive: %1</source>
        <translation>sur le variateur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Revert to the drive&apos;s value: %1</source>
        <translation>Rétablir la valeur du variateur&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Revert to the drive&apos;s value</source>
        <translation>&amp;Rétablir la valeur du variateur</translation>
    </message>
    <message>
        <source>as last read</source>
        <translation>comme lu en dernier</translation>
    </message>
    <message>
        <source>proposed: %1</source>
        <translation>proposé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Use</source>
        <comment>what is proposed</comment>
        <translation>Adopter</translation>
    </message>
    <message>
        <source>Use what is proposed: %1</source>
        <translation>Adopter la proposition&#xa0;: %1</translation>
    </message>
    <message>
        <source>Use what is proposed for %1</source>
        <translation>Adopter la proposition pour %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FiguresModel</name>
    <message>
        <source>Figure</source>
        <translation>Caractéristique</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
    <message>
        <source>Without excluded</source>
        <translation>Sans les exclues</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>At target</source>
        <translation>À la position cible</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>non défini</translation>
    </message>
    <message>
        <source>uncertainty not stated</source>
        <translation>incertitude de mesure non indiquée</translation>
    </message>
    <message>
        <source> and </source>
        <comment>two positions</comment>
        <translation> et </translation>
    </message>
    <message>
        <source>U largest</source>
        <translation>U maximum</translation>
    </message>
    <message>
        <source>U mean</source>
        <translation>U moyen</translation>
    </message>
    <message>
        <source>Ps largest</source>
        <translation>Ps maximum</translation>
    </message>
    <message>
        <source>Ps mean</source>
        <translation>Ps moyen</translation>
    </message>
    <message>
        <source>VDI/DGQ 3441 (assumption)</source>
        <translation>VDI/DGQ 3441 (hypothèse)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileActions</name>
    <message>
        <source>Open Compensation Data</source>
        <translation>Ouvrir des données de compensation</translation>
    </message>
    <message>
        <source>Save Example File</source>
        <translation>Enregistrer un fichier d&apos;exemple</translation>
    </message>
    <message>
        <source>Calibration files (*.csv)</source>
        <translation>Fichiers d&apos;étalonnage (*.csv)</translation>
    </message>
    <message>
        <source>Save Log</source>
        <translation>Enregistrer le journal</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>Fichiers texte (*.txt)</translation>
    </message>
    <message>
        <source>Export for Another Controller</source>
        <translation>Exporter pour une autre commande</translation>
    </message>
    <message>
        <source>Import TAM Configuration</source>
        <translation>Importer une configuration TAM</translation>
    </message>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>Exporter vers une configuration TAM</translation>
    </message>
    <message>
        <source>TAM configurations (*.TAMcfg)</source>
        <translation>Configurations TAM (*.TAMcfg)</translation>
    </message>
    <message>
        <source>Save TAM Configuration</source>
        <translation>Enregistrer la configuration TAM</translation>
    </message>
    <message>
        <source>Back Up Whole Drive</source>
        <translation>Sauvegarder le variateur entier</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>Sauvegardes (*.json)</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>Restaurer le variateur entier</translation>
    </message>
    <message>
        <source>Add Measurement</source>
        <translation>Ajouter une mesure</translation>
    </message>
    <message>
        <source>Save as Runs</source>
        <translation>Enregistrer les passes</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>Passes (*.csv)</translation>
    </message>
    <message>
        <source>Dead Path</source>
        <translation>Trajet mort</translation>
    </message>
    <message>
        <source>Dead path (*.json)</source>
        <translation>Trajet mort (*.json)</translation>
    </message>
    <message>
        <source>Table That Was Active</source>
        <translation>Table qui était active</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Enregistrer la table</translation>
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
        <translation>d&apos;après son contenu</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>Va&amp;leurs</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>selon le fichier</translation>
    </message>
    <message>
        <source>deviations from the target</source>
        <translation>écarts par rapport à la position cible</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>positions de la référence</translation>
    </message>
    <message>
        <source>&amp;Unit of targets</source>
        <translation>&amp;Unité des positions</translation>
    </message>
    <message>
        <source>Unit &amp;of values</source>
        <translation>Unité &amp;des valeurs</translation>
    </message>
    <message>
        <source>Lines &amp;before the header</source>
        <translation>Lignes ava&amp;nt l&apos;en-tête</translation>
    </message>
    <message>
        <source>D&amp;irections by the order of targets</source>
        <translation>Sens d&apos;après l&apos;&amp;ordre des positions</translation>
    </message>
    <message>
        <source>The reference counts the other &amp;way</source>
        <translation>La référence co&amp;mpte en sens inverse</translation>
    </message>
    <message>
        <source>The format of the file</source>
        <translation>Le format du fichier</translation>
    </message>
    <message>
        <source>A deviation is the reference position minus the target</source>
        <translation>Un écart est la position de la référence moins la position cible</translation>
    </message>
    <message>
        <source>For a file that does not name it</source>
        <translation>Pour un fichier qui ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>Lines of a CSV file that come before the names of its columns</source>
        <translation>Lignes d&apos;un fichier CSV qui précèdent les noms de ses colonnes</translation>
    </message>
    <message>
        <source>For a file without directions: a run is up while its targets rise</source>
        <translation>Pour un fichier sans sens&#xa0;: une passe est en sens positif tant que ses positions cibles croissent</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>Pour un instrument qui décompte quand l&apos;axe va en sens positif</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileFacts</name>
    <message>
        <source>off: the drive added nothing</source>
        <translation>désactivée&#xa0;: le variateur n&apos;ajoutait rien</translation>
    </message>
    <message>
        <source>on, with table %1</source>
        <translation>activée, avec la table %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activée</translation>
    </message>
    <message>
        <source>the file does not say it</source>
        <translation>le fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 %4</source>
        <translation>%1 de %2 à %3 %4</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Élément</translation>
    </message>
    <message>
        <source>Statement of the file</source>
        <translation>Indication du fichier</translation>
    </message>
    <message>
        <source>What the file says</source>
        <translation>Ce qu&apos;indique le fichier</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Lu comme</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Positions cibles</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Compensation</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Temporisation</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Expansion</source>
        <translation>Dilatation</translation>
    </message>
    <message>
        <source>Corrected to 20 °C</source>
        <translation>Corrigé à 20 °C</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Variateur</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesModel</name>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>ligne %1, colonne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesView</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1, line %2, column %3</source>
        <translation>%1, ligne %2, colonne %3</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>Lecture du fichier…</translation>
    </message>
    <message>
        <source>These lines can no longer be read from the file.</source>
        <translation>Ces lignes ne peuvent plus être lues dans le fichier.</translation>
    </message>
    <message>
        <source>Lines %1 to %2</source>
        <translation>Lignes %1 à %2</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Problème précédent</translation>
    </message>
    <message>
        <source>Show the lines at the previous problem</source>
        <translation>Afficher les lignes du problème précédent</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Problème suivant</translation>
    </message>
    <message>
        <source>Show the lines at the next problem</source>
        <translation>Afficher les lignes du problème suivant</translation>
    </message>
    <message>
        <source>Table&apos;s values</source>
        <translation>Valeurs de la table</translation>
    </message>
    <message>
        <source>Show the values of the selected table again</source>
        <translation>Afficher de nouveau les valeurs de la table sélectionnée</translation>
    </message>
    <message>
        <source>Earlier lines</source>
        <translation>Lignes précédentes</translation>
    </message>
    <message>
        <source>Show the lines before these</source>
        <translation>Afficher les lignes qui précèdent</translation>
    </message>
    <message>
        <source>Later lines</source>
        <translation>Lignes suivantes</translation>
    </message>
    <message>
        <source>Show the lines after these</source>
        <translation>Afficher les lignes qui suivent</translation>
    </message>
    <message>
        <source>The file&apos;s lines at the chosen problem</source>
        <translation>Les lignes du fichier au problème choisi</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileViews</name>
    <message>
        <source>What the file says</source>
        <translation>Ce qu&apos;indique le fichier</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Views of the file</source>
        <translation>Vues du fichier</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Problèmes (%1)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FindDrivesDialog</name>
    <message>
        <source>Find Drives</source>
        <translation>Rechercher des variateurs</translation>
    </message>
    <message>
        <source>Asks every serial port of this computer for a drive; nothing else is sent. A port that is not listed can be entered as an address, such as serial:/dev/ttyUSB0?baud=921600.</source>
        <translation>Interroge chaque port série de cet ordinateur pour y trouver un variateur&#xa0;; rien d&apos;autre n&apos;est envoyé. Un port non listé peut être saisi comme adresse, par exemple serial:/dev/ttyUSB0?baud=921600.</translation>
    </message>
    <message>
        <source>Try all common &amp;baud rates at every port</source>
        <translation>Essayer tous les dé&amp;bits courants sur chaque port</translation>
    </message>
    <message>
        <source>Takes a few seconds for each port without an answer</source>
        <translation>Prend quelques secondes par port sans réponse</translation>
    </message>
    <message>
        <source>&amp;Search Again</source>
        <translation>Re&amp;lancer la recherche</translation>
    </message>
    <message>
        <source>Search all ports again</source>
        <translation>Rechercher de nouveau sur tous les ports</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Recherche …</translation>
    </message>
    <message>
        <source>%1, serial number %2, axes: %3</source>
        <translation>%1, numéro de série %2, axes&#xa0;: %3</translation>
    </message>
    <message>
        <source>All serial ports of this computer are already in the list.</source>
        <translation>Tous les ports série de cet ordinateur sont déjà dans la liste.</translation>
    </message>
    <message>
        <source>Ports searched: %1; drives found: %2</source>
        <translation>Ports interrogés&#xa0;: %1&#xa0;; variateurs trouvés&#xa0;: %2</translation>
    </message>
    <message>
        <source>&amp;Add to the Connections</source>
        <translation>A&amp;jouter aux connexions</translation>
    </message>
    <message>
        <source>No drive is chosen</source>
        <translation>Aucun variateur n&apos;est choisi</translation>
    </message>
    <message>
        <source>A network is asked only when you confirm its addresses: each of them gets one request.</source>
        <translation>Un réseau n&apos;est interrogé qu&apos;après confirmation de ses adresses&#xa0;: chacune reçoit une requête.</translation>
    </message>
    <message>
        <source>&amp;Network:</source>
        <translation>&amp;Réseau&#xa0;:</translation>
    </message>
    <message>
        <source>Addresses of a network</source>
        <translation>Adresses d&apos;un réseau</translation>
    </message>
    <message>
        <source>Such as 192.168.1.0/24, 192.168.1.10-40 or one address, with :8080 behind it for another port than 80</source>
        <translation>Par exemple 192.168.1.0/24, 192.168.1.10-40 ou une seule adresse, suivie de :8080 pour un autre port que 80</translation>
    </message>
    <message>
        <source>192.168.1.0/24</source>
        <comment>example of a range</comment>
        <translation>192.168.1.0/24</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Arrê&amp;ter</translation>
    </message>
    <message>
        <source>Ask no more; what was found stays</source>
        <translation>Ne plus interroger&#xa0;; ce qui a été trouvé est conservé</translation>
    </message>
    <message>
        <source>Asked %1 of %2 addresses; drives found: %3</source>
        <translation>%1 adresses interrogées sur %2&#xa0;; variateurs trouvés&#xa0;: %3</translation>
    </message>
    <message>
        <source>Stopped. Addresses asked: %1; drives found: %2</source>
        <translation>Arrêté. Adresses interrogées&#xa0;: %1&#xa0;; variateurs trouvés&#xa0;: %2</translation>
    </message>
    <message>
        <source>Addresses asked: %1; drives found: %2</source>
        <translation>Adresses interrogées&#xa0;: %1&#xa0;; variateurs trouvés&#xa0;: %2</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses (%1)</source>
        <translation>&amp;Interroger (%1)</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses</source>
        <translation>&amp;Interroger</translation>
    </message>
    <message>
        <source>Each address gets one request over http, for the list of its files; what answers as a drive does is asked who it is</source>
        <translation>Chaque adresse reçoit une requête http, demandant la liste de ses fichiers&#xa0;; si la réponse est celle d&apos;un variateur, celui-ci est invité à s&apos;identifier</translation>
    </message>
    <message>
        <source>Enter the addresses first</source>
        <translation>Saisir d&apos;abord les adresses</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitForm</name>
    <message>
        <source>%1: a number is needed. %2</source>
        <translation>%1&#xa0;: il faut un nombre. %2</translation>
    </message>
    <message>
        <source>The current axis has no source.</source>
        <translation>L&apos;axe actuel n&apos;a pas de source.</translation>
    </message>
    <message>
        <source>%1 of the current axis is no known position.</source>
        <translation>%1 de l&apos;axe actuel n&apos;est pas une position connue.</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position before the compensation.</source>
        <translation>%1 de l&apos;axe actuel est une position avant compensation.</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position after the compensation.</source>
        <translation>%1 de l&apos;axe actuel est une position après compensation.</translation>
    </message>
    <message>
        <source>The raw positions are on file: it does not matter what was active.</source>
        <translation>Les positions brutes sont dans le fichier&#xa0;: peu importe ce qui était actif.</translation>
    </message>
    <message>
        <source>Measured with the compensation off, as the file says.</source>
        <translation>Mesuré avec la compensation désactivée, selon le fichier.</translation>
    </message>
    <message>
        <source>Measured with the table %1 active, as the file says.</source>
        <translation>Mesuré avec la table %1 active, selon le fichier.</translation>
    </message>
    <message>
        <source>Measured with the compensation on, as the file says.</source>
        <translation>Mesuré avec la compensation activée, selon le fichier.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Variateur</translation>
    </message>
    <message>
        <source>Lookup at</source>
        <translation>Consultation à</translation>
    </message>
    <message>
        <source>Where the drive looks its table up; it decides where the values belong</source>
        <translation>Où le variateur consulte sa table&#xa0;; cela décide de la place des valeurs</translation>
    </message>
    <message>
        <source>as the source of the axis says</source>
        <translation>selon la source de l&apos;axe</translation>
    </message>
    <message>
        <source>encoder, uncompensated</source>
        <translation>codeur, non compensé</translation>
    </message>
    <message>
        <source>set position, compensated</source>
        <translation>consigne, compensée</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>Mesuré avec</translation>
    </message>
    <message>
        <source>What was active while it was measured, since the file does not say it</source>
        <translation>Ce qui était actif pendant la mesure, puisque le fichier ne l&apos;indique pas</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>compensation off</source>
        <translation>compensation désactivée</translation>
    </message>
    <message>
        <source>the table that is merged onto</source>
        <translation>la table à fusionner</translation>
    </message>
    <message>
        <source>the table of a file…</source>
        <translation>la table d&apos;un fichier…</translation>
    </message>
    <message>
        <source>Merge onto</source>
        <translation>Fusionner avec</translation>
    </message>
    <message>
        <source>The table to which residuals are added, that was active while they were measured</source>
        <translation>La table à laquelle s&apos;ajoutent les écarts résiduels, active pendant leur mesure</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>the table of the axis</source>
        <translation>la table de l&apos;axe</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Factor for the residuals: 1, or below it, such as 0.7, where the machine responds sluggishly; at most 2</source>
        <translation>Facteur des écarts résiduels&#xa0;: 1, ou moins, par exemple 0,7, si la machine réagit lentement&#xa0;; au plus 2</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>The curve through or near the means</source>
        <translation>La courbe passant par les moyennes ou près d&apos;elles</translation>
    </message>
    <message>
        <source>linear: straight lines</source>
        <translation>linear&#xa0;: lignes droites</translation>
    </message>
    <message>
        <source>cubic: without overshoot</source>
        <translation>cubic&#xa0;: sans dépassement</translation>
    </message>
    <message>
        <source>spline: natural cubic</source>
        <translation>spline&#xa0;: cubique naturelle</translation>
    </message>
    <message>
        <source>smooth: near the values</source>
        <translation>smooth&#xa0;: près des valeurs</translation>
    </message>
    <message>
        <source>harmonic: of a turn</source>
        <translation>harmonic&#xa0;: d&apos;un tour</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Which runs the table is made of</source>
        <translation>Les passes à partir desquelles la table est établie</translation>
    </message>
    <message>
        <source>mean of up and down</source>
        <translation>moyenne des deux sens</translation>
    </message>
    <message>
        <source>up only</source>
        <translation>sens positif seul</translation>
    </message>
    <message>
        <source>down only</source>
        <translation>sens négatif seul</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>A number from 0 on; by cross-validation when the field is empty</source>
        <translation>Un nombre à partir de 0&#xa0;; par validation croisée si le champ est vide</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Périodes</translation>
    </message>
    <message>
        <source>Known periods above 0, such as the lead of the screw: 10; 2.5</source>
        <translation>Périodes connues, supérieures à 0, par exemple le pas de la vis&#xa0;: 10; 2,5</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmoniques</translation>
    </message>
    <message>
        <source>Of each period, or of the turn; 1 is the fundamental alone</source>
        <translation>Nombre par période ou par tour&#xa0;; 1 est le fondamental seul</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>Longueur d&apos;un tour d&apos;un axe modulo, par exemple 360&#xa0;: la table finit comme elle commence</translation>
    </message>
    <message>
        <source>no modulo axis</source>
        <translation>pas d&apos;axe modulo</translation>
    </message>
    <message>
        <source>Grid of the table</source>
        <translation>Grille de la table</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>Points à</translation>
    </message>
    <message>
        <source>Positions of the table, always evenly spaced</source>
        <translation>Positions de la table, toujours équidistantes</translation>
    </message>
    <message>
        <source>those measured, where even</source>
        <translation>positions mesurées, si régulières</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>nombre de points</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>pas</translation>
    </message>
    <message>
        <source>the fewest points for a deviation</source>
        <translation>minimum de points pour un écart</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Whole numbers from 2 on: one for all axes, or 41; 31</source>
        <translation>Nombres entiers à partir de 2&#xa0;: un pour tous les axes, ou 41; 31</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions: one for all axes, or 10; 5</source>
        <translation>Supérieur à 0, dans l&apos;unité des positions&#xa0;: un pour tous les axes, ou 10; 5</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions</source>
        <translation>Supérieur à 0, dans l&apos;unité des positions</translation>
    </message>
    <message>
        <source>Hold ends beyond the targets</source>
        <translation>Maintenir les extrémités hors des positions cibles</translation>
    </message>
    <message>
        <source>The grid may go beyond the targets, where the end values are held</source>
        <translation>La grille peut s&apos;étendre au-delà des positions cibles, où les valeurs d&apos;extrémité sont maintenues</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>Zéro, pente et dérive</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zéro</translation>
    </message>
    <message>
        <source>Where the table is 0: the zero of the instrument is arbitrary</source>
        <translation>Où la table vaut 0&#xa0;: le zéro de l&apos;instrument est arbitraire</translation>
    </message>
    <message>
        <source>home, else first target</source>
        <translation>origine, sinon première cible</translation>
    </message>
    <message>
        <source>at the home position</source>
        <translation>à la position d&apos;origine</translation>
    </message>
    <message>
        <source>at the first target</source>
        <translation>à la première position cible</translation>
    </message>
    <message>
        <source>mean of the values</source>
        <translation>moyenne des valeurs</translation>
    </message>
    <message>
        <source>at a position</source>
        <translation>à une position</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>tel que mesuré</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>The position of the zero, one number for each axis</source>
        <translation>La position du zéro, un nombre par axe</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>The home position of the axis</source>
        <translation>La position d&apos;origine de l&apos;axe</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
    <message>
        <source>It is taken out of straightness alone: scale error is real</source>
        <translation>Elle n&apos;est retirée que de la rectitude&#xa0;: une erreur d&apos;échelle est réelle</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservée</translation>
    </message>
    <message>
        <source>taken out by least squares</source>
        <translation>retirée par moindres carrés</translation>
    </message>
    <message>
        <source>taken out by the ends</source>
        <translation>retirée par les extrémités</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>What is taken out of runs that lie beside each other before the table is made</source>
        <translation>Ce qui est retiré des passes décalées entre elles avant de créer la table</translation>
    </message>
    <message>
        <source>offset of each run taken out</source>
        <translation>décalage de chaque passe retiré</translation>
    </message>
    <message>
        <source>trend taken out</source>
        <translation>tendance retirée</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>placement</translation>
    </message>
    <message>
        <source>alignment, lines along %1 level</source>
        <translation>placement, lignes suivant %1 sans pente</translation>
    </message>
    <message>
        <source>alignment and scale</source>
        <translation>placement et échelle</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>How the artefact lay is no error of the machine</source>
        <translation>Le placement de l&apos;étalon n&apos;est pas une erreur de la machine</translation>
    </message>
    <message>
        <source>Far points</source>
        <translation>Points éloignés</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one</source>
        <translation>Points de la grille loin de tout point mesuré</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusés</translation>
    </message>
    <message>
        <source>filled smoothly</source>
        <translation>remplis en lissant</translation>
    </message>
    <message>
        <source>filled with the nearest</source>
        <translation>remplis par le plus proche</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robuste</translation>
    </message>
    <message>
        <source>Values that do not fit the others count less</source>
        <translation>Les valeurs qui ne concordent pas avec les autres comptent moins</translation>
    </message>
    <message>
        <source>The axis has another table since that was said: say it anew.</source>
        <translation>L&apos;axe a une autre table depuis cette indication&#xa0;: indiquez-le à nouveau.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitOutcome</name>
    <message>
        <source>fit of %1</source>
        <translation>ajustement de %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPage</name>
    <message>
        <source>Merge onto</source>
        <translation>Fusionner avec</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>Mesuré avec</translation>
    </message>
    <message>
        <source>An earlier table; a new one is being made …</source>
        <translation>Une table antérieure&#xa0;; calcul d&apos;une nouvelle …</translation>
    </message>
    <message>
        <source>The table is being made …</source>
        <translation>Calcul de la table …</translation>
    </message>
    <message>
        <source>Table and measurement</source>
        <translation>Table et mesure</translation>
    </message>
    <message>
        <source>No table</source>
        <translation>Aucune table</translation>
    </message>
    <message>
        <source>There is no table yet</source>
        <translation>Il n&apos;y a pas encore de table</translation>
    </message>
    <message>
        <source>Take the table over to Write, as if it had been read from a file</source>
        <translation>Reprendre la table dans Écrire, comme si elle avait été lue dans un fichier</translation>
    </message>
    <message>
        <source>As a file of the drive or of another controller</source>
        <translation>En fichier du variateur ou d&apos;une autre commande</translation>
    </message>
    <message>
        <source>Add the files of a measurement on Measure; here a table is made of it.</source>
        <translation>Ajouter les fichiers d&apos;une mesure dans Mesurer&#xa0;; une table en est établie ici.</translation>
    </message>
    <message>
        <source>The files on Measure cannot be used.</source>
        <translation>Les fichiers de Mesurer ne sont pas utilisables.</translation>
    </message>
    <message>
        <source>Choose where the drive looks its table up: it decides where the values belong.</source>
        <translation>Choisir où le variateur consulte sa table&#xa0;: cela décide de la place des valeurs.</translation>
    </message>
    <message>
        <source>Read the warnings; then the table can be used: it is taken over to Write.</source>
        <translation>Lire les avertissements&#xa0;; la table est ensuite utilisable&#xa0;: elle est reprise dans Écrire.</translation>
    </message>
    <message>
        <source>The table can be used: it is taken over to Write, where nothing is written before you say so.</source>
        <translation>La table est utilisable&#xa0;: elle est reprise dans Écrire, où rien n&apos;est écrit sans confirmation.</translation>
    </message>
    <message>
        <source>Use as Table</source>
        <translation>Utiliser comme table</translation>
    </message>
    <message>
        <source>Save Table…</source>
        <translation>Enregistrer la table…</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Which column of the points is shown and used</source>
        <translation>Colonne des points affichée et utilisée</translation>
    </message>
    <message>
        <source>The table corrects axis %1, and the current axis is %2: it is refused there. Choose the axis that was measured.</source>
        <translation>La table corrige l&apos;axe %1, et l&apos;axe actuel est %2&#xa0;: elle y est refusée. Choisir l&apos;axe qui a été mesuré.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPlot</name>
    <message>
        <source>compensation [%1]</source>
        <translation>compensation [%1]</translation>
    </message>
    <message>
        <source>remains [%1]</source>
        <translation>reste [%1]</translation>
    </message>
    <message>
        <source>table</source>
        <translation>table</translation>
    </message>
    <message>
        <source>measured, with its standard error</source>
        <translation>mesuré, avec son erreur type</translation>
    </message>
    <message>
        <source>foretold without the target</source>
        <translation>prévu sans la position cible</translation>
    </message>
    <message>
        <source>Picture of the fit</source>
        <translation>Image de l&apos;ajustement</translation>
    </message>
    <message>
        <source>The table over what was measured, and what remains. Left and right go from point to point; the wheel and + and - zoom, Home shows all.</source>
        <translation>La table superposée à la mesure, et ce qui reste. Gauche et droite vont de point en point&#xa0;; la molette ainsi que + et - zooment, Début affiche tout.</translation>
    </message>
    <message>
        <source>%1: measured %2 ± %3, %4 remains</source>
        <translation>%1&#xa0;: mesuré %2 ± %3, reste %4</translation>
    </message>
    <message>
        <source>%1: measured %2, %3 remains</source>
        <translation>%1&#xa0;: mesuré %2, reste %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitResults</name>
    <message>
        <source>Largest correction: %1 at %2.</source>
        <translation>Plus grande correction&#xa0;: %1 à %2.</translation>
    </message>
    <message>
        <source>What remains, rms</source>
        <translation>Ce qui reste, RMS</translation>
    </message>
    <message>
        <source>What remains, largest</source>
        <translation>Ce qui reste, maximum</translation>
    </message>
    <message>
        <source>Figure [%1]</source>
        <translation>Caractéristique [%1]</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>At the targets</source>
        <translation>Aux cibles</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>Hors ajustement</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Avertissement&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: foretold %2, tolerance %3: %4.</source>
        <translation>%1&#xa0;: prévu %2, tolérance %3&#xa0;: %4.</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>non défini</translation>
    </message>
    <message>
        <source>Table %1: %2; CRC %3.</source>
        <translation>Table %1&#xa0;: %2&#xa0;; CRC %3.</translation>
    </message>
    <message>
        <source>Looked up at the encoder&apos;s position, before the compensation.</source>
        <translation>Consultée à la position du codeur, avant compensation.</translation>
    </message>
    <message>
        <source>Looked up at the set position, after the compensation.</source>
        <translation>Consultée à la position de consigne, après compensation.</translation>
    </message>
    <message>
        <source>Smoothness %1.</source>
        <translation>Lissage %1.</translation>
    </message>
    <message>
        <source>Points of the grid that were filled: %1 of %2.</source>
        <translation>Points de la grille remplis&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>Held out: each target foretold without it, which is the one to believe between the targets.</source>
        <translation>Hors ajustement&#xa0;: chaque position cible prévue sans elle, la valeur à laquelle se fier entre les positions cibles.</translation>
    </message>
    <message>
        <source>Figures before and foretold</source>
        <translation>Caractéristiques avant et prévues</translation>
    </message>
    <message>
        <source>Before the table is used</source>
        <translation>Avant d&apos;utiliser la table</translation>
    </message>
    <message>
        <source>%1, held out %2</source>
        <translation>%1, hors ajustement %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ForeignChange</name>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive: the compensation is off. Home the axis and activate again.</source>
        <translation>L&apos;axe a perdu son origine, comme après un redémarrage du variateur&#xa0;: la compensation est désactivée. Effectuer la prise d&apos;origine de l&apos;axe et activer de nouveau.</translation>
    </message>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive.</source>
        <translation>L&apos;axe a perdu son origine, comme après un redémarrage du variateur.</translation>
    </message>
    <message>
        <source>The compensation is off: something other than this window has switched it off.</source>
        <translation>La compensation est désactivée&#xa0;: elle ne l&apos;a pas été depuis cette fenêtre.</translation>
    </message>
    <message>
        <source>The compensation is on: something other than this window has switched it on.</source>
        <translation>La compensation est activée&#xa0;: elle ne l&apos;a pas été depuis cette fenêtre.</translation>
    </message>
    <message>
        <source>The axis has no table any more.</source>
        <translation>L&apos;axe n&apos;a plus de table.</translation>
    </message>
    <message>
        <source>dimensionality</source>
        <translation>dimensionnalité</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>source %1</translation>
    </message>
    <message>
        <source>table</source>
        <translation>table</translation>
    </message>
    <message>
        <source>persistency</source>
        <translation>persistance</translation>
    </message>
    <message>
        <source>Its volatile table is gone: write it again, as a persistent one if it has to outlast a restart.</source>
        <translation>Sa table volatile a disparu&#xa0;: l&apos;écrire de nouveau, en persistante si elle doit survivre à un redémarrage.</translation>
    </message>
    <message>
        <source>The settings of this axis on the drive have changed, and not by this window: %1.</source>
        <translation>Les réglages de cet axe sur le variateur ont changé, et non par cette fenêtre&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>Guide de l&apos;utilisateur</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Guide de l&apos;utilisateur</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportConfigurationDialog</name>
    <message>
        <source>Import TAM Configuration</source>
        <translation>Importer une configuration TAM</translation>
    </message>
    <message>
        <source>Writes the table and source parameters in %1 to the axes of %2, one after the other. The tables themselves must be on the drive. Each write makes a backup and is verified; no compensation is switched on.</source>
        <translation>Écrit les paramètres de tables et de sources de %1 sur les axes de %2, l&apos;un après l&apos;autre. Les tables elles-mêmes doivent être sur le variateur. Chaque écriture crée une sauvegarde et est vérifiée&#xa0;; aucune compensation n&apos;est activée.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportDialog</name>
    <message>
        <source>Import Compensation Data</source>
        <translation>Importer des données de compensation</translation>
    </message>
    <message>
        <source>Choose how to read %1. The result is the table that the drive adds to the encoder position, on an even grid.</source>
        <translation>Choisir comment lire %1. Le résultat est la table que le variateur ajoute à la position du codeur, sur une grille régulière.</translation>
    </message>
    <message>
        <source>I&amp;mport</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>Use the file with these choices; nothing is written to the drive yet</source>
        <translation>Utiliser le fichier avec ces choix&#xa0;; rien n&apos;est encore écrit dans le variateur</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>Ligne %1&#xa0;: </translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgePage</name>
    <message>
        <source>Tolerances, and the uncertainty U (k = 2)</source>
        <translation>Tolérances et incertitude U (k = 2)</translation>
    </message>
    <message>
        <source>All &amp;values</source>
        <translation>T&amp;outes les valeurs</translation>
    </message>
    <message>
        <source>Show plot and targets as if nothing were excluded</source>
        <translation>Afficher le graphique et les positions cibles comme si rien n&apos;était exclu</translation>
    </message>
    <message>
        <source>&amp;Corrections…</source>
        <translation>&amp;Corrections…</translation>
    </message>
    <message>
        <source>Bring the values to 20 °C, or correct them for the dead path of an interferometer</source>
        <translation>Ramener les valeurs à 20 °C ou les corriger du trajet mort d&apos;un interféromètre</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tableaux</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Caractéristiques</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Positions cibles</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>Drift in numbers</source>
        <translation>Dérive en chiffres</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Warnings (%1)</source>
        <translation>Avertissements (%1)</translation>
    </message>
    <message>
        <source>No corrections.</source>
        <translation>Aucune correction.</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014</source>
        <translation>Caractéristiques selon l&apos;ISO 230-2:2014</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgeWarningsModel</name>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LimitFields</name>
    <message>
        <source>The largest value that is allowed, such as 10 µm; empty: no tolerance</source>
        <translation>La plus grande valeur admise, par exemple 10 µm&#xa0;; vide&#xa0;: aucune tolérance</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2, such as 2.1 µm; empty: not stated</source>
        <translation>Incertitude de mesure avec k = 2, par exemple 2,1 µm&#xa0;; vide&#xa0;: non indiquée</translation>
    </message>
    <message>
        <source>Tolerance: %1</source>
        <translation>Tolérance&#xa0;: %1</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>Incertitude de mesure U, k = 2</translation>
    </message>
    <message>
        <source>&amp;Accuracy A</source>
        <translation>Exactitude &amp;A</translation>
    </message>
    <message>
        <source>Systematic &amp;E</source>
        <translation>Systématique &amp;E</translation>
    </message>
    <message>
        <source>Range of means &amp;M</source>
        <translation>Étendue moyennes &amp;M</translation>
    </message>
    <message>
        <source>Reversal &amp;B</source>
        <translation>Inversion &amp;B</translation>
    </message>
    <message>
        <source>Repeatab&amp;ility R</source>
        <translation>Répétab&amp;ilité R</translation>
    </message>
    <message>
        <source>&amp;Uncertainty U</source>
        <translation>Incertitude &amp;U</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LogView</name>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Copy the selected lines, or all of them</source>
        <translation>Copier les lignes sélectionnées, ou toutes</translation>
    </message>
    <message>
        <source>Save the log to a file</source>
        <translation>Enregistrer le journal dans un fichier</translation>
    </message>
    <message>
        <source>Hide the log</source>
        <translation>Masquer le journal</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineActions</name>
    <message>
        <source>Open Machine File</source>
        <translation>Ouvrir un fichier machine</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>Fichiers machine (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineApplication</name>
    <message>
        <source>All drives already had what %1 says; nothing was written.</source>
        <translation>Tous les variateurs avaient déjà le contenu de %1&#xa0;; rien n&apos;a été écrit.</translation>
    </message>
    <message>
        <source>%1 is applied.</source>
        <translation>%1 est appliqué.</translation>
    </message>
    <message>
        <source>%1 is not applied as a whole: %2</source>
        <translation>%1 n&apos;est pas entièrement appliqué&#xa0;: %2</translation>
    </message>
    <message>
        <source>Failed: %1.</source>
        <translation>Échec&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>Écrit et vérifié&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not written: %1.</source>
        <translation>Non écrit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Applying it again does the rest.</source>
        <translation>L&apos;appliquer de nouveau complète le reste.</translation>
    </message>
    <message>
        <source>%1: %2; it holds: %3.</source>
        <comment>axis, what became of it, and its table</comment>
        <translation>%1&#xa0;: %2&#xa0;; contenu&#xa0;: %3.</translation>
    </message>
    <message>
        <source>%1: %2; what it holds is not known.</source>
        <comment>axis, and what became of it</comment>
        <translation>%1&#xa0;: %2&#xa0;; contenu inconnu.</translation>
    </message>
    <message>
        <source>Begin: applying the machine file %1.</source>
        <translation>Début&#xa0;: application du fichier machine %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Switched: %1.</source>
        <translation>Commuté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not switched: %1.</source>
        <translation>Non commuté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not proved: %1.</source>
        <translation>Non validé&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineController</name>
    <message>
        <source>No machine file is open.</source>
        <translation>Aucun fichier machine n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>The machine file is being read.</source>
        <translation>Lecture du fichier machine en cours.</translation>
    </message>
    <message>
        <source>The machine file is being applied.</source>
        <translation>Application du fichier machine en cours.</translation>
    </message>
    <message>
        <source>Wait for the end of the current operation.</source>
        <translation>Attendre la fin de l&apos;opération en cours.</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>Comparaison des variateurs en cours.</translation>
    </message>
    <message>
        <source>Not all drives of the file are among the connections.</source>
        <translation>Les variateurs du fichier ne font pas tous partie des connexions.</translation>
    </message>
    <message>
        <source>Nothing is written while something stands in the way of a part of it.</source>
        <translation>Rien n&apos;est écrit tant qu&apos;un obstacle empêche une partie de l&apos;écriture.</translation>
    </message>
    <message>
        <source>All drives have what the file says.</source>
        <translation>Tous les variateurs ont le contenu du fichier.</translation>
    </message>
    <message>
        <source>No drive of the file answers.</source>
        <translation>Aucun variateur du fichier ne répond.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachinePane</name>
    <message>
        <source>&amp;Plan Again</source>
        <translation>Re&amp;planifier</translation>
    </message>
    <message>
        <source>Reads the machine file and its tables again and compares all drives with them</source>
        <translation>Relit le fichier machine et ses tables, et leur compare tous les variateurs</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>&amp;Appliquer…</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>Afficher ce qui serait écrit dans tous les variateurs, avant toute écriture</translation>
    </message>
    <message>
        <source>Close Machine &amp;File</source>
        <translation>&amp;Fermer le fichier machine</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>Les variateurs restent connectés&#xa0;; rien ne change</translation>
    </message>
    <message>
        <source>Problems of the machine file</source>
        <translation>Problèmes du fichier machine</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lecture de %1 …</translation>
    </message>
    <message>
        <source>as the file says: %1</source>
        <comment>number of axes</comment>
        <translation>conformes au fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>differ: %1</source>
        <comment>number of axes</comment>
        <translation>différents&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be compared: %1</source>
        <comment>number of axes</comment>
        <translation>non comparables&#xa0;: %1</translation>
    </message>
    <message>
        <source>not reachable: %1</source>
        <comment>number of axes</comment>
        <translation>injoignables&#xa0;: %1</translation>
    </message>
    <message>
        <source>not among the connections: %1</source>
        <comment>number of axes</comment>
        <translation>absents des connexions&#xa0;: %1</translation>
    </message>
    <message>
        <source>not compared yet: %1</source>
        <comment>number of axes</comment>
        <translation>pas encore comparés&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>file and machine</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: axes %2.</source>
        <comment>machine file and numbers of axes</comment>
        <translation>%1&#xa0;: axes %2.</translation>
    </message>
    <message>
        <source>Compared at %1.</source>
        <translation>Comparé à %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and what is wrong</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>Ce variateur ne fait plus partie des connexions.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurePage</name>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>&amp;Save as Runs…</source>
        <translation>En&amp;registrer les passes…</translation>
    </message>
    <message>
        <source>All files as one CSV file, with what is excluded marked in it</source>
        <translation>Tous les fichiers en un seul fichier CSV, où ce qui est exclu est marqué</translation>
    </message>
    <message>
        <source>Files of the measurement</source>
        <translation>Fichiers de la mesure</translation>
    </message>
    <message>
        <source>Values of all files</source>
        <translation>Valeurs de tous les fichiers</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>Lecture des fichiers …</translation>
    </message>
    <message>
        <source>Take the values of a plan while something else moves the axis</source>
        <translation>Relever les valeurs d&apos;un plan de mesure pendant que l&apos;axe est déplacé par ailleurs</translation>
    </message>
    <message>
        <source>New &amp;Program…</source>
        <translation>Nouveau pro&amp;gramme…</translation>
    </message>
    <message>
        <source>Plan the targets of a measurement, and a program for the control of the machine</source>
        <translation>Planifier les positions cibles d&apos;une mesure, et un programme pour la commande de la machine</translation>
    </message>
    <message>
        <source>Cap&amp;ture…</source>
        <translation>Ac&amp;quérir…</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Acquisition</translation>
    </message>
    <message>
        <source>Add the files of a measurement, take its values with Capture, or go on to Write with a table that is there.</source>
        <translation>Ajouter les fichiers d&apos;une mesure, relever ses valeurs avec Acquérir, ou passer à Écrire avec une table existante.</translation>
    </message>
    <message>
        <source>Saved as %1. Judge says what it is worth, and Fit makes a table of it.</source>
        <translation>Enregistré sous %1. Analyser dit ce que vaut la mesure, et Ajuster en établit une table.</translation>
    </message>
    <message>
        <source>Without targets there are no figures of ISO 230-2; Fit makes a table of it.</source>
        <translation>Sans positions cibles, pas de caractéristiques selon l&apos;ISO 230-2&#xa0;; Ajuster en établit une table.</translation>
    </message>
    <message>
        <source>The measurement can be used. Go on to Judge and Fit.</source>
        <translation>La mesure est utilisable. Passer à Analyser et à Ajuster.</translation>
    </message>
    <message>
        <source>%1 was captured for the record that was open before, and is not added to this one.</source>
        <translation>%1 a été acquis pour la fiche ouverte auparavant et n&apos;est pas ajouté à celle-ci.</translation>
    </message>
    <message>
        <source>Saved as %1 with the values of the files: the corrections are not in it.</source>
        <translation>Enregistré sous %1 avec les valeurs des fichiers&#xa0;: les corrections n&apos;y sont pas.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFiles</name>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Ajouter…</translation>
    </message>
    <message>
        <source>Add files of a measurement; they can also be dropped here (Ctrl+O)</source>
        <translation>Ajouter des fichiers d&apos;une mesure&#xa0;; ils peuvent aussi être déposés ici (Ctrl+O)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>Ret&amp;irer</translation>
    </message>
    <message>
        <source>Take the selected file out of the measurement (Del)</source>
        <translation>Retirer de la mesure le fichier sélectionné (Suppr)</translation>
    </message>
    <message>
        <source>E&amp;xchange up and down in all files</source>
        <translation>&amp;Permuter les deux sens dans tous les fichiers</translation>
    </message>
    <message>
        <source>For files that name the directions the other way round</source>
        <translation>Pour des fichiers qui nomment les sens à l&apos;inverse</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFilesModel</name>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>activée</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>inutilisable</translation>
    </message>
    <message>
        <source>warnings: %1</source>
        <translation>avertissements&#xa0;: %1</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>samples: %1</source>
        <translation>échantillons&#xa0;: %1</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>points&#xa0;: %1</translation>
    </message>
    <message>
        <source>means</source>
        <translation>moyennes</translation>
    </message>
    <message>
        <source>%1 up, %2 down</source>
        <translation>%1 passes ↑, %2 passes ↓</translation>
    </message>
    <message>
        <source>being read …</source>
        <translation>lecture …</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Compensation</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>%1, as the record holds it</source>
        <translation>%1, tel que dans la fiche</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasuringActions</name>
    <message>
        <source>Values are being captured: stop that first</source>
        <translation>Acquisition de valeurs en cours&#xa0;: l&apos;arrêter d&apos;abord</translation>
    </message>
    <message>
        <source>Choose a drive and an axis first</source>
        <translation>Choisir d&apos;abord un variateur et un axe</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessagePresenter</name>
    <message>
        <source>This is the built-in demo drive. Try everything; no real drive is affected.</source>
        <translation>Ceci est le variateur de démonstration intégré. Tout peut être essayé&#xa0;; aucun variateur réel n&apos;est concerné.</translation>
    </message>
    <message>
        <source>Wor&amp;k with Real Drives…</source>
        <translation>Utili&amp;ser de vrais variateurs…</translation>
    </message>
    <message>
        <source>%1 Your changes are kept; reconnecting …</source>
        <translation>%1 Les modifications sont conservées&#xa0;; reconnexion …</translation>
    </message>
    <message>
        <source>%1 Reconnecting …</source>
        <translation>%1 Reconnexion …</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>%1 a changé sur le disque.</translation>
    </message>
    <message>
        <source>Read A&amp;gain</source>
        <translation>&amp;Relire</translation>
    </message>
    <message>
        <source>&amp;Finish Write</source>
        <translation>Acheve&amp;r</translation>
    </message>
    <message>
        <source>Undo Wri&amp;te</source>
        <translation>Annuler l&apos;écri&amp;ture</translation>
    </message>
    <message>
        <source>&amp;Keep for Later</source>
        <translation>Plu&amp;s tard</translation>
    </message>
    <message>
        <source>S&amp;how Certificate…</source>
        <translation>Afficher le cer&amp;tificat…</translation>
    </message>
    <message>
        <source>%1 is being asked …</source>
        <translation>Interrogation de %1 …</translation>
    </message>
    <message>
        <source>%1 has no axis with compensation registers.</source>
        <translation>%1 n&apos;a pas d&apos;axe avec des registres de compensation.</translation>
    </message>
    <message>
        <source>%1 does not answer. %2</source>
        <comment>drive, reason</comment>
        <translation>%1 ne répond pas. %2</translation>
    </message>
    <message>
        <source>Tr&amp;y Again</source>
        <translation>Réessa&amp;yer</translation>
    </message>
    <message>
        <source>%1 answers now.</source>
        <translation>%1 répond maintenant.</translation>
    </message>
    <message>
        <source>Displa&amp;y Drive</source>
        <translation>&amp;Y aller</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessageStack</name>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisController</name>
    <message>
        <source>The writes have not been planned yet.</source>
        <translation>Les écritures n&apos;ont pas encore été planifiées.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisDialog</name>
    <message>
        <source>Write Several Axes</source>
        <translation>Écrire plusieurs axes</translation>
    </message>
    <message>
        <source>Writes columns of %1 to axes of %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified.</source>
        <translation>Écrit des colonnes de %1 sur des axes de %2, l&apos;une après l&apos;autre. Toutes les écritures sont vérifiées avant que la première commence&#xa0;; chacune crée une sauvegarde et est vérifiée.</translation>
    </message>
    <message>
        <source>&amp;Sources</source>
        <translation>&amp;Sources</translation>
    </message>
    <message>
        <source>Each axis keeps its sources</source>
        <translation>Chaque axe garde ses sources</translation>
    </message>
    <message>
        <source>The registers that supply the positions for the tables</source>
        <translation>Les registres qui fournissent les positions pour les tables</translation>
    </message>
    <message>
        <source>The same for all, as on the page: %1</source>
        <translation>Les mêmes pour tous, comme sur la page&#xa0;: %1</translation>
    </message>
    <message>
        <source>Persistent, as on the page: all tables are stored in flash.</source>
        <translation>Persistant, comme sur la page&#xa0;: toutes les tables sont enregistrées en mémoire flash.</translation>
    </message>
    <message>
        <source>Volatile, as on the page: a reboot of the drive restores the stored state.</source>
        <translation>Volatil, comme sur la page&#xa0;: un redémarrage du variateur rétablit l&apos;état enregistré.</translation>
    </message>
    <message>
        <source>Each axis its own position</source>
        <translation>Chaque axe sa propre position</translation>
    </message>
    <message>
        <source>No register is known for the position of %1: select other sources.</source>
        <translation>Aucun registre connu pour la position de %1&#xa0;: choisir d&apos;autres sources.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisOutcome</name>
    <message>
        <source>The writes were stopped.</source>
        <translation>Les écritures ont été arrêtées.</translation>
    </message>
    <message>
        <source>The writes were stopped at %1.</source>
        <translation>Les écritures ont été arrêtées à %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and sentence</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>No axis was changed.</source>
        <translation>Aucun axe n&apos;a été modifié.</translation>
    </message>
    <message>
        <source>New state: %1.</source>
        <translation>Nouvel état&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Old state, complete: %1.</source>
        <translation>Ancien état, complet&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 The tables that no axis uses are not all restored: %2</source>
        <translation>%1 Les tables qu&apos;aucun axe n&apos;utilise ne sont pas toutes restaurées&#xa0;: %2</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>Écrit et vérifié&#xa0;: %1.</translation>
    </message>
    <message>
        <source>This is stored in flash.</source>
        <translation>Cela est enregistré en mémoire flash.</translation>
    </message>
    <message>
        <source>This is volatile: a reboot of the drive restores the stored state.</source>
        <translation>Cela est volatil&#xa0;: un redémarrage du variateur rétablit l&apos;état enregistré.</translation>
    </message>
    <message>
        <source>Stored in flash: %1.</source>
        <translation>Enregistré en mémoire flash&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Volatile: %1; a reboot of the drive restores the stored state.</source>
        <translation>Volatil&#xa0;: %1&#xa0;; un redémarrage du variateur rétablit l&apos;état enregistré.</translation>
    </message>
    <message>
        <source>The axes already had all of this.</source>
        <translation>Les axes avaient déjà tout cela.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisPlanView</name>
    <message>
        <source>persistent</source>
        <translation>persistante</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volatile</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>aucune table</translation>
    </message>
    <message>
        <source>%1D in %2, %3</source>
        <translation>%1D dans %2, %3</translation>
    </message>
    <message>
        <source>nothing: the drive already has all of this</source>
        <translation>rien&#xa0;: le variateur a déjà tout cela</translation>
    </message>
    <message>
        <source>%1 (empty)</source>
        <translation>%1 (vide)</translation>
    </message>
    <message>
        <source>%1 (held an earlier table of this axis)</source>
        <translation>%1 (contenait une table antérieure de cet axe)</translation>
    </message>
    <message>
        <source>%1 (will be overwritten)</source>
        <translation>%1 (sera écrasé)</translation>
    </message>
    <message>
        <source>Dim%1: %2</source>
        <translation>Dim%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Sur le variateur</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Ce qui sera écrit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>N&apos;utilise aucune opération flash.</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>Opérations flash au total&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>Opérations flash&#xa0;: %1 utilisées, %2 restantes juste après.</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>Ces &amp;grandes corrections sont justes&#xa0;: leur unité a été vérifiée</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberEdit</name>
    <message>
        <source>%1: &quot;%2&quot; cannot be taken. %3</source>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» n&apos;est pas accepté. %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OperationRunner</name>
    <message>
        <source>Begin: %1, %2.</source>
        <comment>task and drive</comment>
        <translation>Début&#xa0;: %1, %2.</translation>
    </message>
    <message>
        <source>Begin: %1 %2.</source>
        <translation>Début&#xa0;: %1 %2.</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>task, axis and step</comment>
        <translation>%1&#xa0;: %2, %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: stopping</source>
        <translation>%1&#xa0;: arrêt en cours</translation>
    </message>
    <message>
        <source>The fields were changed while the write was planned: write again.</source>
        <translation>Les champs ont été modifiés pendant la planification de l&apos;écriture&#xa0;: écrire de nouveau.</translation>
    </message>
    <message>
        <source>The drive or the fields have changed since the write was planned: write again.</source>
        <translation>Le variateur ou les champs ont changé depuis la planification de l&apos;écriture&#xa0;: écrire de nouveau.</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>Arrêté par l&apos;utilisateur.</translation>
    </message>
    <message>
        <source>Wrote %1: axes: %2, tables: %3.</source>
        <translation>%1 écrit&#xa0;: axes&#xa0;: %2, tables&#xa0;: %3.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::Outcome</name>
    <message>
        <source>The drive holds the complete old state.</source>
        <translation>Le variateur est entièrement dans l&apos;ancien état.</translation>
    </message>
    <message>
        <source>It is stored in flash.</source>
        <translation>Il est enregistré en mémoire flash.</translation>
    </message>
    <message>
        <source>It is volatile: a reboot of the drive restores the stored state.</source>
        <translation>Il est volatil&#xa0;: un redémarrage du variateur rétablit l&apos;état enregistré.</translation>
    </message>
    <message>
        <source>Written and verified: the drive holds the new state. %1</source>
        <translation>Écrit et vérifié&#xa0;: le variateur est dans le nouvel état. %1</translation>
    </message>
    <message>
        <source>Nothing to write: the drive already has all of this.</source>
        <translation>Rien à écrire&#xa0;: le variateur a déjà tout cela.</translation>
    </message>
    <message>
        <source>The write was stopped.</source>
        <translation>L&apos;écriture a été arrêtée.</translation>
    </message>
    <message>
        <source>The compensation is off.</source>
        <translation>La compensation est désactivée.</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>La compensation est active.</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>La compensation est en évaluation&#xa0;: le variateur n&apos;ajoute rien.</translation>
    </message>
    <message>
        <source>The proof was stopped.</source>
        <translation>La validation a été arrêtée.</translation>
    </message>
    <message>
        <source>%1 But the proof failed: deactivate it unless you know why. %2</source>
        <translation>%1 Mais la validation a échoué&#xa0;: désactiver, sauf si la raison est connue. %2</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state from before the write of %1.</source>
        <translation>Restauré&#xa0;: le variateur est dans l&apos;état d&apos;avant l&apos;écriture du %1.</translation>
    </message>
    <message>
        <source>The drive holds the complete new state; nothing more to do.</source>
        <translation>Le variateur est entièrement dans le nouvel état&#xa0;; il n&apos;y a plus rien à faire.</translation>
    </message>
    <message>
        <source>The write of %1 was interrupted (last step: %2). %3</source>
        <translation>L&apos;écriture du %1 a été interrompue (dernière étape&#xa0;: %2). %3</translation>
    </message>
    <message>
        <source>%1 The write is still unfinished.</source>
        <translation>%1 L&apos;écriture reste interrompue.</translation>
    </message>
    <message>
        <source>Finished and verified: the drive holds the complete new state.</source>
        <translation>Achevé et vérifié&#xa0;: le variateur est entièrement dans le nouvel état.</translation>
    </message>
    <message>
        <source>Undone and verified: the drive holds the complete old state.</source>
        <translation>Annulé et vérifié&#xa0;: le variateur est entièrement dans l&apos;ancien état.</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved.</source>
        <translation>Le variateur est entièrement dans le nouvel état, mais ses paramètres ne sont peut-être pas enregistrés.</translation>
    </message>
    <message>
        <source>The drive holds neither the old nor the new state: finish or undo the write before activating the axis.</source>
        <translation>Le variateur n&apos;est ni dans l&apos;ancien ni dans le nouvel état&#xa0;: achever ou annuler l&apos;écriture avant d&apos;activer l&apos;axe.</translation>
    </message>
    <message>
        <source>Not proved.</source>
        <translation>Non validé.</translation>
    </message>
    <message>
        <source>The proof failed, and the drive evaluates again as before. %1</source>
        <translation>La validation a échoué, et le variateur est de nouveau en évaluation. %1</translation>
    </message>
    <message>
        <source>The proof failed, and the compensation was switched off again. %1</source>
        <translation>La validation a échoué, et la compensation a été de nouveau désactivée. %1</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Rien n&apos;a été écrit.</translation>
    </message>
    <message>
        <source>Deleted and verified: %1 is empty, and the axis uses no table.</source>
        <translation>Supprimé et vérifié&#xa0;: %1 est vide, et l&apos;axe n&apos;utilise aucune table.</translation>
    </message>
    <message>
        <source>Proved over %1 of the table: largest difference %2.</source>
        <translation>Validé sur %1 de la table&#xa0;: plus grande différence %2.</translation>
    </message>
    <message>
        <source>Its table indices are right.</source>
        <translation>Ses indices de table sont justes.</translation>
    </message>
    <message>
        <source>The compensation is active, but the drive contradicts its table. Stop the axis and deactivate. %1</source>
        <translation>La compensation est active, mais le variateur contredit sa table. Arrêter l&apos;axe et désactiver. %1</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1, made of the drive with the serial number %2.</source>
        <translation>Restauré&#xa0;: le variateur est dans l&apos;état que contient le fichier de sauvegarde du %1, celle du variateur de numéro de série %2.</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1.</source>
        <translation>Restauré&#xa0;: le variateur est dans l&apos;état que contient le fichier de sauvegarde du %1.</translation>
    </message>
    <message>
        <source>The compensation may be on, and is not proved. Connect again to see what it does.</source>
        <translation>La compensation est peut-être active, et elle n&apos;est pas validée. Se reconnecter pour voir ce qu&apos;elle fait.</translation>
    </message>
    <message>
        <source>Which state the drive holds is not known, since the backup of the old one cannot be read: write again or restore another backup before activating the axis.</source>
        <translation>L&apos;état dans lequel se trouve le variateur n&apos;est pas connu, car la sauvegarde de l&apos;ancien état ne peut pas être lue&#xa0;: écrire à nouveau ou restaurer une autre sauvegarde avant d&apos;activer l&apos;axe.</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved, and the backup of the old state cannot be read: write again to save them, or restore another backup.</source>
        <translation>Le variateur est entièrement dans le nouvel état, mais ses paramètres ne sont peut-être pas enregistrés, et la sauvegarde de l&apos;ancien état ne peut pas être lue&#xa0;: écrire de nouveau pour les enregistrer, ou restaurer une autre sauvegarde.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutlierList</name>
    <message>
        <source>&amp;Outliers by</source>
        <translation>Valeurs aberra&amp;ntes</translation>
    </message>
    <message>
        <source>pooled MAD, limit 4</source>
        <translation>MAD groupée, limite 4</translation>
    </message>
    <message>
        <source>Grubbs, 5 %</source>
        <translation>Grubbs, 5&#xa0;%</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>aucune règle</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>Règle des valeurs aberrantes</translation>
    </message>
    <message>
        <source>How values that do not fit the others are found; a proposal, nothing is left out by it</source>
        <translation>Comment trouver les valeurs qui ne concordent pas avec les autres&#xa0;; une proposition, rien n&apos;est omis pour autant</translation>
    </message>
    <message>
        <source>Proposed for exclusion, and excluded</source>
        <translation>Proposées pour exclusion et exclues</translation>
    </message>
    <message>
        <source>Exclude All &amp;Proposed</source>
        <translation>Exclure les &amp;proposées</translation>
    </message>
    <message>
        <source>Leave out every value that the rule proposes</source>
        <translation>Omettre toutes les valeurs que la règle propose</translation>
    </message>
    <message>
        <source>E&amp;xclude</source>
        <translation>Exc&amp;lure</translation>
    </message>
    <message>
        <source>Leave out the value, run or target that is selected in list, plot or table (Del)</source>
        <translation>Omettre la valeur, la passe ou la position cible sélectionnée dans la liste, le graphique ou le tableau (Suppr)</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>Réin&amp;tégrer</translation>
    </message>
    <message>
        <source>Use what is selected again</source>
        <translation>Réintégrer la sélection</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutliersModel</name>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Passe</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>all</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposé</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewDialog</name>
    <message>
        <source>Overview of All Axes</source>
        <translation>Vue d&apos;ensemble des axes</translation>
    </message>
    <message>
        <source>All axes of all drives</source>
        <translation>Tous les axes de tous les variateurs</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all of them, with the headings for a spreadsheet</source>
        <translation>Copier les lignes sélectionnées, ou toutes, avec les en-têtes, pour un tableur</translation>
    </message>
    <message>
        <source>&amp;Go to Axis</source>
        <translation>Aller à l&apos;a&amp;xe</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close the overview</source>
        <translation>Fermer la vue d&apos;ensemble</translation>
    </message>
    <message>
        <source>No axis is chosen.</source>
        <translation>Aucun axe n&apos;est choisi.</translation>
    </message>
    <message>
        <source>This drive has not said yet which axes it has.</source>
        <translation>Ce variateur n&apos;a pas encore indiqué quels axes il a.</translation>
    </message>
    <message>
        <source>Wait for the current operation before choosing another axis.</source>
        <translation>Attendre la fin de l&apos;opération en cours avant de choisir un autre axe.</translation>
    </message>
    <message>
        <source>Show this axis on the page</source>
        <translation>Afficher cet axe sur la page</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewModel</name>
    <message>
        <source>since %1</source>
        <comment>date and time</comment>
        <translation>depuis le %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and column</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>persistante</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>volatile</translation>
    </message>
    <message>
        <source>not limited</source>
        <comment>flash operations</comment>
        <translation>illimité</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>contredit sa table</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Variateur</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistance</translation>
    </message>
    <message>
        <source>Flash left</source>
        <translation>Flash restant</translation>
    </message>
    <message>
        <source>Last proof</source>
        <translation>Dernière validation</translation>
    </message>
    <message>
        <source>Last write</source>
        <translation>Dernière écriture</translation>
    </message>
    <message>
        <source>The drive, and where it is</source>
        <translation>Le variateur et son adresse</translation>
    </message>
    <message>
        <source>The axis of this drive</source>
        <translation>L&apos;axe de ce variateur</translation>
    </message>
    <message>
        <source>What the compensation does now</source>
        <translation>Ce que fait actuellement la compensation</translation>
    </message>
    <message>
        <source>The table that the axis uses: its file and column where this window has written it, otherwise its place on the drive; and the checksum of its values</source>
        <translation>La table que l&apos;axe utilise&#xa0;: son fichier et sa colonne si elle a été écrite depuis cette fenêtre, sinon son emplacement sur le variateur&#xa0;; et la somme de contrôle de ses valeurs</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>Si la table survit à un redémarrage</translation>
    </message>
    <message>
        <source>How many flash operations the drive can do now</source>
        <translation>Nombre d&apos;opérations flash que le variateur peut effectuer actuellement</translation>
    </message>
    <message>
        <source>Over which part of the table this window has seen that the drive does what the table says, and when</source>
        <translation>Sur quelle partie de la table cette fenêtre a constaté que le variateur applique la table, et quand</translation>
    </message>
    <message>
        <source>When this computer last wrote to the axis</source>
        <translation>Date de la dernière écriture de cet ordinateur sur l&apos;axe</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>connexion …</translation>
    </message>
    <message>
        <source>no axes</source>
        <translation>aucun axe</translation>
    </message>
    <message>
        <source>no compensation</source>
        <translation>sans compensation</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>illisible</translation>
    </message>
    <message>
        <source>is being read …</source>
        <translation>lecture …</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <comment>address of a drive</comment>
        <translation>%1, numéro de série %2</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>The accuracy of the axis with this table and before, as the records of this computer have it</source>
        <translation>L&apos;exactitude de l&apos;axe avec cette table et avant, selon les fiches de cet ordinateur</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>Fichier machine</translation>
    </message>
    <message>
        <source>Whether the axis has what the machine file says, and when it was compared</source>
        <translation>Si l&apos;axe a le contenu du fichier machine, et quand la comparaison a eu lieu</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;System Language</source>
        <translation>Langue du &amp;système</translation>
    </message>
    <message>
        <source>Show &amp;Preview Before Volatile Writes</source>
        <translation>A&amp;perçu avant une écriture volatile</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview</source>
        <translation>Une écriture persistante affiche toujours l&apos;aperçu</translation>
    </message>
    <message>
        <source>Save Lo&amp;g…</source>
        <translation>Enregistrer le &amp;journal…</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>À &amp;propos</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
    <message>
        <source>&lt;b&gt;Axis Compensation Wizard&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Assistant de compensation d&apos;axes&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>Writes error compensation tables to servo drives, activates them and proves that the drive applies them.

A compensation value is reference minus encoder; the drive adds it to the encoder position.

Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Écrit des tables de compensation d&apos;erreurs dans des servovariateurs, les active et valide que le variateur les applique.

Une valeur de compensation est référence moins codeur&#xa0;; le variateur l&apos;ajoute à la position du codeur.

Logiciel libre sous licence GNU General Public License, version 3 ou ultérieure.</translation>
    </message>
    <message>
        <source>Save the selected table as a file for another controller</source>
        <translation>Enregistrer la table sélectionnée comme fichier pour une autre commande</translation>
    </message>
    <message>
        <source>No table is selected.</source>
        <translation>Aucune table n&apos;est sélectionnée.</translation>
    </message>
    <message>
        <source>&amp;Export for Another Controller…</source>
        <translation>E&amp;xporter pour une autre commande…</translation>
    </message>
    <message>
        <source>&amp;Write Several Axes…</source>
        <translation>Écri&amp;re plusieurs axes…</translation>
    </message>
    <message>
        <source>&amp;Import TAM Configuration…</source>
        <translation>&amp;Importer une configuration TAM…</translation>
    </message>
    <message>
        <source>Export to &amp;TAM Configuration…</source>
        <translation>Exporter vers une configuration &amp;TAM…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Re&amp;faire</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>Re&amp;faire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Takes the last change of the fields back; the drive is not reached</source>
        <translation>Annule la dernière modification des champs&#xa0;; sans effet sur le variateur</translation>
    </message>
    <message>
        <source>Makes the change that was undone again</source>
        <translation>Refait la modification annulée</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ai&amp;de</translation>
    </message>
    <message>
        <source>User &amp;Guide</source>
        <translation>&amp;Guide de l&apos;utilisateur</translation>
    </message>
    <message>
        <source>Ba&amp;ck Up Whole Drive…</source>
        <translation>&amp;Sauvegarder le variateur entier…</translation>
    </message>
    <message>
        <source>Restore Whole &amp;Drive…</source>
        <translation>Restaurer le variateur &amp;entier…</translation>
    </message>
    <message>
        <source>&amp;Overview of All Axes…</source>
        <translation>&amp;Vue d&apos;ensemble des axes…</translation>
    </message>
    <message>
        <source>State and table of each axis of all connected drives</source>
        <translation>État et table de chaque axe de tous les variateurs connectés</translation>
    </message>
    <message>
        <source>No machine file is open.</source>
        <translation>Aucun fichier machine n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>Read the machine file again and compare all drives with it</source>
        <translation>Relire le fichier machine et lui comparer tous les variateurs</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>Comparaison des variateurs en cours.</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>Afficher ce qui serait écrit dans tous les variateurs, avant toute écriture</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>Les variateurs restent connectés&#xa0;; rien ne change</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Machine</translation>
    </message>
    <message>
        <source>&amp;Open Machine File…</source>
        <translation>&amp;Ouvrir un fichier machine…</translation>
    </message>
    <message>
        <source>Compare all drives of a machine with the file that says which tables they have</source>
        <translation>Comparer tous les variateurs d&apos;une machine avec le fichier qui indique leurs tables</translation>
    </message>
    <message>
        <source>&amp;Plan Again</source>
        <translation>Re&amp;planifier</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>&amp;Appliquer…</translation>
    </message>
    <message>
        <source>&amp;Save Machine File…</source>
        <translation>&amp;Enregistrer un fichier machine…</translation>
    </message>
    <message>
        <source>Running drives as a machine file with all tables, in a folder of your choice</source>
        <translation>Variateurs en service sous forme de fichier machine avec toutes les tables, dans un dossier au choix</translation>
    </message>
    <message>
        <source>&amp;Close Machine File</source>
        <translation>&amp;Fermer le fichier machine</translation>
    </message>
    <message>
        <source>Documentation in the &amp;Browser</source>
        <translation>Documentation dans le &amp;navigateur</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Documentation</translation>
    </message>
    <message>
        <source>No browser could be opened. The documentation is in %1.</source>
        <translation>Aucun navigateur n&apos;a pu être ouvert. La documentation se trouve dans %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageTabs</name>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>The files of a measurement, and how they are read</source>
        <translation>Les fichiers d&apos;une mesure et la façon de les lire</translation>
    </message>
    <message>
        <source>Bring a table to the drive, and activate it</source>
        <translation>Transmettre une table au variateur et l&apos;activer</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
    <message>
        <source>Parts of the work</source>
        <translation>Parties du travail</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Page Up and Ctrl+Page Down change the tab)</source>
        <translation>%1 (Ctrl+Page préc. et Ctrl+Page suiv. changent d&apos;onglet)</translation>
    </message>
    <message>
        <source>Judge</source>
        <translation>Analyser</translation>
    </message>
    <message>
        <source>What the measurement says of the axis, against tolerances</source>
        <translation>Ce que la mesure dit de l&apos;axe, par rapport aux tolérances</translation>
    </message>
    <message>
        <source>Prove</source>
        <translation>Valider</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Measure again with the table active, and see what it has brought</source>
        <translation>Mesurer de nouveau avec la table active et voir ce qu&apos;elle a apporté</translation>
    </message>
    <message>
        <source>The table that is made of a measurement, and what it promises</source>
        <translation>La table établie à partir d&apos;une mesure, et ce qu&apos;elle promet</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ParameterExport</name>
    <message>
        <source>Wrote %1: only compensation registers have changed.</source>
        <translation>%1 écrit&#xa0;: seuls des registres de compensation ont changé.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanDialog</name>
    <message>
        <source>New Program</source>
        <translation>Nouveau programme</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Mean spacing</source>
        <translation>Espacement moyen</translation>
    </message>
    <message>
        <source>Cont&amp;rol</source>
        <translation>Co&amp;mmande</translation>
    </message>
    <message>
        <source>The control of the machine, which plays the program</source>
        <translation>La commande de la machine, qui exécute le programme</translation>
    </message>
    <message>
        <source>Save Pro&amp;gram…</source>
        <translation>Enregistrer le pro&amp;gramme…</translation>
    </message>
    <message>
        <source>Save &amp;Plan…</source>
        <translation>Enregistrer le pla&amp;n…</translation>
    </message>
    <message>
        <source>Clo&amp;se</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>What was not saved is lost (Esc)</source>
        <translation>Ce qui n&apos;a pas été enregistré est perdu (Échap)</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Positions cibles</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;xe</translation>
    </message>
    <message>
        <source>As the drive or the control names it</source>
        <translation>Comme le variateur ou la commande le nomme</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Unité</translation>
    </message>
    <message>
        <source>Of all positions of the plan</source>
        <translation>De toutes les positions du plan</translation>
    </message>
    <message>
        <source>&amp;First target</source>
        <translation>P&amp;remière position</translation>
    </message>
    <message>
        <source>Measured in every run</source>
        <translation>Mesurée dans chaque passe</translation>
    </message>
    <message>
        <source>&amp;Last target</source>
        <translation>&amp;Dernière position</translation>
    </message>
    <message>
        <source>Measured in every run; above the first</source>
        <translation>Mesurée dans chaque passe&#xa0;; supérieure à la première</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>P&amp;ositions cibles</translation>
    </message>
    <message>
        <source>How many, or how far apart in the mean</source>
        <translation>Leur nombre, ou leur espacement moyen</translation>
    </message>
    <message>
        <source>&amp;Known period</source>
        <translation>Période &amp;connue</translation>
    </message>
    <message>
        <source>Of the axis&apos;s error, such as the lead of its screw: targets are spread over it</source>
        <translation>De l&apos;erreur de l&apos;axe, par exemple le pas de sa vis&#xa0;: les positions cibles y sont réparties</translation>
    </message>
    <message>
        <source>&amp;Cycles</source>
        <translation>C&amp;ycles</translation>
    </message>
    <message>
        <source>Runs in each direction; the standard wants five</source>
        <translation>Passes dans chaque sens&#xa0;; la norme en demande cinq</translation>
    </message>
    <message>
        <source>&amp;Overrun</source>
        <translation>Dépa&amp;ssement</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target</source>
        <translation>Déplacement de l&apos;axe dans le sens d&apos;une passe avant sa première position cible</translation>
    </message>
    <message>
        <source>F&amp;eed</source>
        <translation>A&amp;vance</translation>
    </message>
    <message>
        <source>Of the moves in the program</source>
        <translation>Des déplacements du programme</translation>
    </message>
    <message>
        <source>D&amp;well</source>
        <translation>&amp;Temporisation</translation>
    </message>
    <message>
        <source>How long the axis stands at each target, to be measured</source>
        <translation>Durée d&apos;arrêt de l&apos;axe à chaque position cible, pour la mesure</translation>
    </message>
    <message>
        <source>Ran&amp;dom seed</source>
        <translation>Graine a&amp;léatoire</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same</source>
        <translation>Un autre nombre donne d&apos;autres positions cibles, le même nombre les mêmes</translation>
    </message>
    <message>
        <source>Given b&amp;y</source>
        <translation>Défini &amp;par</translation>
    </message>
    <message>
        <source>Whether targets are counted, or their distance is given</source>
        <translation>Si les positions cibles sont définies par leur nombre ou par leur espacement</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>Nombre de positions cibles</translation>
    </message>
    <message>
        <source>Mean spacing of targets</source>
        <translation>Espacement moyen des positions cibles</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>aucune connue</translation>
    </message>
    <message>
        <source>by the range</source>
        <translation>selon l&apos;étendue</translation>
    </message>
    <message>
        <source>%1. The axis moves from %2 to %3: check that this way is free.</source>
        <translation>%1. L&apos;axe se déplace de %2 à %3&#xa0;: vérifier que ce trajet est libre.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>This program never moves an axis: the control of the machine plays the program, or a person moves from target to target.</source>
        <translation>Ce programme ne déplace jamais un axe&#xa0;: la commande de la machine exécute le programme, ou une personne va d&apos;une position cible à l&apos;autre.</translation>
    </message>
    <message>
        <source>For Capture, which takes the values by it</source>
        <translation>Pour Acquérir, qui relève les valeurs d&apos;après lui</translation>
    </message>
    <message>
        <source>G-code for the control of the machine</source>
        <translation>Code G pour la commande de la machine</translation>
    </message>
    <message>
        <source>Save Program</source>
        <translation>Enregistrer le programme</translation>
    </message>
    <message>
        <source>Save Plan</source>
        <translation>Enregistrer le plan</translation>
    </message>
    <message>
        <source>Programs (*%1);;All files (*)</source>
        <translation>Programmes (*%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>Plans (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré sous %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanStepsModel</name>
    <message>
        <source>step %1, %2, target %3</source>
        <translation>étape %1, %2, position cible %3</translation>
    </message>
    <message>
        <source>due</source>
        <translation>à mesurer</translation>
    </message>
    <message>
        <source>not taken yet</source>
        <translation>pas encore relevé</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Passe</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>Venant de</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanTargetsModel</name>
    <message>
        <source>No.</source>
        <translation>Num.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Espacement</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PreviewPanel</name>
    <message>
        <source>Save Exa&amp;mple…</source>
        <translation>Exe&amp;mple…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Save a small %1D calibration file as an example</source>
        <translation>Enregistrer comme exemple un petit fichier d&apos;étalonnage %1D</translation>
    </message>
    <message>
        <source>%1 bytes, more than any slot of the drive holds</source>
        <translation>%1 octets, plus que n&apos;en contient aucun emplacement du variateur</translation>
    </message>
    <message>
        <source>%1 of %2 bytes of a table slot</source>
        <translation>%1 octets sur les %2 d&apos;un emplacement de table</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Problèmes (%1)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Ctrl+%2)</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>All slices</source>
        <translation>Toutes les coupes</translation>
    </message>
    <message>
        <source>Two axes</source>
        <translation>Deux axes</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemList</name>
    <message>
        <source>Problems of the file</source>
        <translation>Problèmes du fichier</translation>
    </message>
    <message>
        <source>%1 cannot be used; the previous selection is kept.</source>
        <translation>%1 n&apos;est pas utilisable&#xa0;; la sélection précédente est conservée.</translation>
    </message>
    <message>
        <source>%1 is used, with these warnings.</source>
        <translation>%1 est utilisé, avec ces avertissements.</translation>
    </message>
    <message>
        <source>Further problems: %1.</source>
        <translation>Autres problèmes&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Click a problem, or press Enter, to see the file&apos;s line.</source>
        <translation>Cliquer sur un problème ou appuyer sur Entrée pour voir la ligne du fichier.</translation>
    </message>
    <message>
        <source>&amp;Use %1D</source>
        <translation>U&amp;tiliser %1D</translation>
    </message>
    <message>
        <source>Sets the dimensionality to %1D and reads the file again.</source>
        <translation>Règle la dimensionnalité sur %1D et relit le fichier.</translation>
    </message>
    <message>
        <source>%1 cannot be used.</source>
        <translation>%1 n&apos;est pas utilisable.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemModel</name>
    <message>
        <source>error, line %1</source>
        <translation>erreur, ligne %1</translation>
    </message>
    <message>
        <source>warning, line %1</source>
        <translation>avertissement, ligne %1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProvePage</name>
    <message>
        <source>%1 %2 (tolerance %3)</source>
        <translation>%1 %2 (tolérance %3)</translation>
    </message>
    <message>
        <source>%1 not defined (tolerance %2)</source>
        <translation>%1 non défini (tolérance %2)</translation>
    </message>
    <message>
        <source>Not within the tolerances: %1.</source>
        <translation>Hors des tolérances&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not judged by: %1.</source>
        <translation>Sans verdict&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Undecided, since the uncertainty is too large: %1.</source>
        <translation>Indéterminé, car l&apos;incertitude de mesure est trop grande&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The machine is not as good as was predicted.</source>
        <translation>La machine n&apos;est pas aussi bonne que prévu.</translation>
    </message>
    <message>
        <source>The machine is no better than before.</source>
        <translation>La machine n&apos;est pas meilleure qu&apos;avant.</translation>
    </message>
    <message>
        <source>The two are corrected differently for temperature or dead path, so that they cannot be compared.</source>
        <translation>Les deux ne sont pas corrigées de la même façon pour la température ou le trajet mort, elles ne peuvent donc pas être comparées.</translation>
    </message>
    <message>
        <source>No tolerance is given, so there is no verdict.</source>
        <translation>Aucune tolérance n&apos;est indiquée, il n&apos;y a donc pas de verdict.</translation>
    </message>
    <message>
        <source>Within the tolerances.</source>
        <translation>Dans les tolérances.</translation>
    </message>
    <message>
        <source>Within the tolerances (uncertainty not stated).</source>
        <translation>Dans les tolérances (incertitude de mesure non indiquée).</translation>
    </message>
    <message>
        <source>Second measurement</source>
        <translation>Deuxième mesure</translation>
    </message>
    <message>
        <source>Files of the second measurement</source>
        <translation>Fichiers de la deuxième mesure</translation>
    </message>
    <message>
        <source>Kee&amp;p in the Record</source>
        <translation>&amp;Conserver dans la fiche</translation>
    </message>
    <message>
        <source>The second measurement, what it says of the prediction, and the verdict</source>
        <translation>La deuxième mesure, ce qu&apos;elle dit de la prévision, et le verdict</translation>
    </message>
    <message>
        <source>For a file that does not say which table was active</source>
        <translation>Pour un fichier qui n&apos;indique pas quelle table était active</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Avant et après</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Ce qui reste</translation>
    </message>
    <message>
        <source>Figures before, predicted, held out and after</source>
        <translation>Caractéristiques avant, prévues, hors ajustement et après</translation>
    </message>
    <message>
        <source>What is left at the targets</source>
        <translation>Ce qui reste aux positions cibles</translation>
    </message>
    <message>
        <source>The tabl&amp;e %1 was active</source>
        <translation>La ta&amp;ble %1 était active</translation>
    </message>
    <message>
        <source>What to look at: %1</source>
        <translation>À examiner&#xa0;: %1</translation>
    </message>
    <message>
        <source>Nothing was predicted between the targets: before and after are compared alone.</source>
        <translation>Rien n&apos;était prévu entre les positions cibles&#xa0;: seuls avant et après sont comparés.</translation>
    </message>
    <message>
        <source>No table of this record is in use: a second measurement is compared with that of Measure alone. Open a record with a table to prove that one.</source>
        <translation>Aucune table de cette fiche n&apos;est utilisée&#xa0;: une deuxième mesure n&apos;est comparée qu&apos;à celle de Mesurer. Ouvrir une fiche avec une table pour valider celle-ci.</translation>
    </message>
    <message>
        <source>Write the table and activate it, measure again, and add the files of that measurement here.</source>
        <translation>Écrire la table et l&apos;activer, mesurer de nouveau, et ajouter ici les fichiers de cette mesure.</translation>
    </message>
    <message>
        <source>Measure again with the table active, and add the files of that measurement here.</source>
        <translation>Mesurer de nouveau avec la table active, et ajouter ici les fichiers de cette mesure.</translation>
    </message>
    <message>
        <source>The measurement is in the record: save that, and write the report.</source>
        <translation>La mesure est dans la fiche&#xa0;: l&apos;enregistrer et écrire le rapport.</translation>
    </message>
    <message>
        <source>Keep it in the record.</source>
        <translation>La conserver dans la fiche.</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>Lecture des fichiers …</translation>
    </message>
    <message>
        <source>The second measurement does not say which table was active. If it was the table %1, say so above; otherwise measure again with it.</source>
        <translation>La deuxième mesure n&apos;indique pas quelle table était active. S&apos;il s&apos;agissait de la table %1, l&apos;indiquer ci-dessus&#xa0;; sinon, mesurer de nouveau avec elle.</translation>
    </message>
    <message>
        <source>The measurements are being compared …</source>
        <translation>Comparaison des mesures …</translation>
    </message>
    <message>
        <source>There is no measurement to compare it with: add that one in Measure.</source>
        <translation>Il n&apos;y a pas de mesure à laquelle la comparer&#xa0;: l&apos;ajouter dans Mesurer.</translation>
    </message>
    <message>
        <source>The second measurement covers only part of the first one&apos;s travel.</source>
        <translation>La deuxième mesure ne couvre qu&apos;une partie de la course de la première.</translation>
    </message>
    <message>
        <source>The measurement is in the record, and that is saved: write the report.</source>
        <translation>La mesure est dans la fiche, qui est enregistrée&#xa0;: écrire le rapport.</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %1 is not defined after.</source>
        <translation>La conformité à la prévision reste ouverte, car %1 n&apos;est pas défini après.</translation>
    </message>
    <message>
        <source>Not as predicted, since the machine is no better than before: %3 is %1 after and was %2 before.</source>
        <translation>Non conforme à la prévision, car la machine n&apos;est pas meilleure qu&apos;avant&#xa0;: %3 vaut %1 après et valait %2 avant.</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %3 is smaller than before by no more than what cannot be told: %3 is %1 after and was %2 before.</source>
        <translation>La conformité à la prévision reste ouverte, car %3 n&apos;a pas diminué de plus que ce qui ne peut être déterminé&#xa0;: %3 vaut %1 après et valait %2 avant.</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since less of the axis was measured: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>La conformité à la prévision reste ouverte, car une moindre partie de l&apos;axe a été mesurée&#xa0;: %3 vaut %1 après, et jusqu&apos;à %2 est conforme.</translation>
    </message>
    <message>
        <source>As predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>Conforme à la prévision&#xa0;: %3 vaut %1 après, et jusqu&apos;à %2 est conforme (1,2 fois %3 hors ajustement, et ce qui ne peut être déterminé).</translation>
    </message>
    <message>
        <source>Not as predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>Non conforme à la prévision&#xa0;: %3 vaut %1 après, et jusqu&apos;à %2 est conforme (1,2 fois %3 hors ajustement, et ce qui ne peut être déterminé).</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since the targets are farther apart than before: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>La conformité à la prévision reste ouverte, car les positions cibles sont plus espacées qu&apos;avant&#xa0;: %3 vaut %1 après, et jusqu&apos;à %2 est conforme.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordActions</name>
    <message>
        <source>Re&amp;cord</source>
        <translation>Fic&amp;he</translation>
    </message>
    <message>
        <source>&amp;New Record</source>
        <translation>&amp;Nouvelle fiche</translation>
    </message>
    <message>
        <source>&amp;Open Record…</source>
        <translation>&amp;Ouvrir une fiche…</translation>
    </message>
    <message>
        <source>&amp;Save Record</source>
        <translation>&amp;Enregistrer la fiche</translation>
    </message>
    <message>
        <source>Save Record &amp;As…</source>
        <translation>Enregistrer la fiche &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Rapport…</translation>
    </message>
    <message>
        <source>Records (*.axcal)</source>
        <translation>Fiches (*.axcal)</translation>
    </message>
    <message>
        <source>Open Record</source>
        <translation>Ouvrir une fiche</translation>
    </message>
    <message>
        <source>Save Record</source>
        <translation>Enregistrer la fiche</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
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
        <translation>Enre&amp;gistrer, puis commencer</translation>
    </message>
    <message>
        <source>Save, &amp;Then Open</source>
        <translation>Enre&amp;gistrer, puis ouvrir</translation>
    </message>
    <message>
        <source>Begin Without Savin&amp;g</source>
        <translation>Commencer &amp;sans enregistrer</translation>
    </message>
    <message>
        <source>Open Without Savin&amp;g</source>
        <translation>Ouvrir &amp;sans enregistrer</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>Res&amp;ter</translation>
    </message>
    <message>
        <source>The record has never been saved.</source>
        <translation>La fiche n&apos;a jamais été enregistrée.</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>%1 is there already, and is another file.</source>
        <translation>%1 existe déjà et est un autre fichier.</translation>
    </message>
    <message>
        <source>%1 has been changed by another program since it was read here.</source>
        <translation>%1 a été modifié par un autre programme depuis sa lecture ici.</translation>
    </message>
    <message>
        <source>Overwri&amp;te</source>
        <translation>Écra&amp;ser</translation>
    </message>
    <message>
        <source>&amp;Keep Both…</source>
        <translation>&amp;Garder les deux…</translation>
    </message>
    <message>
        <source>The program did not end well. A record that was never saved was kept at %1.</source>
        <translation>Le programme ne s&apos;est pas terminé correctement. Une fiche jamais enregistrée a été conservée à %1.</translation>
    </message>
    <message>
        <source>The program did not end well. Unsaved changes of %1 were kept at %2.</source>
        <translation>Le programme ne s&apos;est pas terminé correctement. Des modifications non enregistrées de %1 ont été conservées à %2.</translation>
    </message>
    <message>
        <source>&amp;Take Them Up</source>
        <translation>Le&amp;s récupérer</translation>
    </message>
    <message>
        <source>For&amp;get Them</source>
        <translation>Les reje&amp;ter</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Le rapport a été écrit dans %1.</translation>
    </message>
    <message>
        <source>The drive has the table; only the record does not say so: %1</source>
        <translation>Le variateur a la table&#xa0;; seule la fiche ne l&apos;indique pas&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 has changed on disk. What was left out is used again; corrections, and which table was active, are to be said anew. Ctrl+Z takes that back.</source>
        <translation>%1 a été modifié sur le disque. Ce qui était exclu est de nouveau utilisé&#xa0;; les corrections et la table qui était active sont à indiquer de nouveau. Ctrl+Z annule cela.</translation>
    </message>
    <message>
        <source>%1 says what was written and measured of its table, and this record does not. Saving it under another name keeps both.</source>
        <translation>%1 indique ce qui a été écrit et mesuré de sa table, ce que cette fiche ne fait pas. L&apos;enregistrement sous un autre nom conserve les deux.</translation>
    </message>
    <message>
        <source>&amp;Take It Up</source>
        <translation>La ré&amp;cupérer</translation>
    </message>
    <message>
        <source>For&amp;get It</source>
        <translation>La reje&amp;ter</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordBar</name>
    <message>
        <source>Record:</source>
        <translation>Fiche&#xa0;:</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open a record (.axcal); it can also be dropped on the window (Ctrl+Alt+O)</source>
        <translation>Ouvrir une fiche (.axcal)&#xa0;; elle peut aussi être déposée sur la fenêtre (Ctrl+Alt+O)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save measurement, table, what it promised and what came of it (Ctrl+S)</source>
        <translation>Enregistrer mesure, table, ce qu&apos;elle promettait et ce qu&apos;elle a donné (Ctrl+S)</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>The report of the record as PDF or HTML (Ctrl+P)</source>
        <translation>Le rapport de la fiche en PDF ou HTML (Ctrl+P)</translation>
    </message>
    <message>
        <source>Open record</source>
        <translation>Ouvrir une fiche</translation>
    </message>
    <message>
        <source>Save record</source>
        <translation>Enregistrer la fiche</translation>
    </message>
    <message>
        <source>Report of the record</source>
        <translation>Rapport de la fiche</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>It has changes that are not saved.</source>
        <translation>Elle a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>There are no unsaved changes.</source>
        <translation>Il n&apos;y a pas de modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>Fiche %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordFile</name>
    <message>
        <source>not saved yet</source>
        <translation>nouvelle</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordModel</name>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>How %1 is read</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>Permuter les deux sens</translation>
    </message>
    <message>
        <source>Exclude (%1)</source>
        <translation>Exclure (%1)</translation>
    </message>
    <message>
        <source>Use again (%1)</source>
        <translation>Réintégrer (%1)</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>Règle des valeurs aberrantes</translation>
    </message>
    <message>
        <source>Tolerance of %1</source>
        <translation>Tolérance de %1</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude de mesure</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Corrections</translation>
    </message>
    <message>
        <source>Table in use</source>
        <translation>Table utilisée</translation>
    </message>
    <message>
        <source>Table active while measured</source>
        <translation>Table active pendant la mesure</translation>
    </message>
    <message>
        <source>Fit: %1</source>
        <translation>Ajustement&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 changed on disk</source>
        <translation>%1 modifié sur le disque</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualModel</name>
    <message>
        <source>at %1: %2, standard error %3</source>
        <translation>à %1&#xa0;: %2, erreur type %3</translation>
    </message>
    <message>
        <source>at %1: %2, standard error not defined</source>
        <translation>à %1&#xa0;: %2, erreur type non définie</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Erreur type</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualPlot</name>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after, with its standard error</source>
        <translation>après, avec son erreur type</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>There is nothing to compare.</source>
        <translation>Il n&apos;y a rien à comparer.</translation>
    </message>
    <message>
        <source>What is left lies between %1 and %2.</source>
        <translation>Ce qui reste est compris entre %1 et %2.</translation>
    </message>
    <message>
        <source>Mean deviation before and after</source>
        <translation>Écart moyen avant et après</translation>
    </message>
    <message>
        <source>Dashed, with squares: before. Full line, with dots: after; the band is the standard error of the mean.</source>
        <translation>Tirets et carrés&#xa0;: avant. Trait plein et points&#xa0;: après&#xa0;; la bande est l&apos;erreur type de la moyenne.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RestoreDriveDialog</name>
    <message>
        <source>The backup is being read.</source>
        <translation>Lecture de la sauvegarde en cours.</translation>
    </message>
    <message>
        <source>The backup is of another drive: confirm it first.</source>
        <translation>La sauvegarde est celle d&apos;un autre variateur&#xa0;: à confirmer d&apos;abord.</translation>
    </message>
    <message>
        <source>Backup of %1, serial number %2; axes: %3</source>
        <translation>Sauvegarde de %1, numéro de série %2&#xa0;; axes&#xa0;: %3</translation>
    </message>
    <message>
        <source>, of %1</source>
        <comment>time</comment>
        <translation>, du %1</translation>
    </message>
    <message>
        <source>Tables that no axis uses, restored after the axes: %1</source>
        <translation>Tables qu&apos;aucun axe n&apos;utilise, restaurées après les axes&#xa0;: %1</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>Restaurer le variateur entier</translation>
    </message>
    <message>
        <source>Brings all axes of %1 back to the backup in %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified. No compensation is switched on.</source>
        <translation>Ramène tous les axes de %1 à la sauvegarde %2, l&apos;un après l&apos;autre. Toutes les écritures sont vérifiées avant que la première commence&#xa0;; chacune crée une sauvegarde et est vérifiée. Aucune compensation n&apos;est activée.</translation>
    </message>
    <message>
        <source>The backup is of &amp;another drive, which this one replaces</source>
        <translation>La sauvegarde est celle d&apos;un a&amp;utre variateur, que celui-ci remplace</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunDriftModel</name>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Passe</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesModel</name>
    <message>
        <source>target %1 at %2</source>
        <translation>position cible %1 à %2</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>aucune valeur</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesView</name>
    <message>
        <source>Values of all files</source>
        <translation>Valeurs de tous les fichiers</translation>
    </message>
    <message>
        <source>&amp;Exclude</source>
        <translation>&amp;Exclure</translation>
    </message>
    <message>
        <source>Leave the selected values out of every figure and table; in the first column, whole targets (Del)</source>
        <translation>Omettre les valeurs sélectionnées de toute caractéristique et de toute table&#xa0;; dans la première colonne, des positions cibles entières (Suppr)</translation>
    </message>
    <message>
        <source>Exclude W&amp;hole Run</source>
        <translation>Ex&amp;clure toute la passe</translation>
    </message>
    <message>
        <source>Leave out every value of the run of the current cell</source>
        <translation>Omettre toutes les valeurs de la passe de la cellule actuelle</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>Réin&amp;tégrer</translation>
    </message>
    <message>
        <source>Use the selected values again</source>
        <translation>Réintégrer les valeurs sélectionnées</translation>
    </message>
    <message>
        <source>Too many cells are selected: at most %1 in one step. A whole target is its cell in the first column; &quot;Exclude Whole Run&quot; takes a whole run.</source>
        <translation>Trop de cellules sont sélectionnées&#xa0;: au plus %1 à la fois. Pour une position cible entière, sa cellule de la première colonne suffit&#xa0;; pour une passe entière, utiliser «&#xa0;Exclure toute la passe&#xa0;».</translation>
    </message>
    <message>
        <source>Values: %1, excluded: %2 (✕). ↑ up, ↓ down.</source>
        <translation>Valeurs&#xa0;: %1, exclues&#xa0;: %2 (✕). ↑ sens positif, ↓ sens négatif.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SaveMachineDialog</name>
    <message>
        <source>Save Machine File</source>
        <translation>Enregistrer un fichier machine</translation>
    </message>
    <message>
        <source>Writes machine.toml and the tables of all axes into a folder. The drives are only read.</source>
        <translation>Écrit machine.toml et les tables de tous les axes dans un dossier. Les variateurs sont seulement lus.</translation>
    </message>
    <message>
        <source>&amp;Name of the machine (may be empty)</source>
        <translation>&amp;Nom de la machine (facultatif)</translation>
    </message>
    <message>
        <source>&amp;Drives</source>
        <translation>&amp;Variateurs</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nom de la machine</translation>
    </message>
    <message>
        <source>Drives of the machine</source>
        <translation>Variateurs de la machine</translation>
    </message>
    <message>
        <source>&amp;Replace These Files</source>
        <translation>&amp;Remplacer ces fichiers</translation>
    </message>
    <message>
        <source>&amp;Save in Folder…</source>
        <translation>&amp;Enregistrer dans un dossier…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>Revenir à la page (Échap)</translation>
    </message>
    <message>
        <source>%1 (does not answer)</source>
        <comment>drive</comment>
        <translation>%1 (ne répond pas)</translation>
    </message>
    <message>
        <source>No drive is chosen.</source>
        <translation>Aucun variateur n&apos;est choisi.</translation>
    </message>
    <message>
        <source>%1 does not answer: a machine file without one of its drives would be another machine.</source>
        <translation>%1 ne répond pas&#xa0;: un fichier machine sans l&apos;un de ses variateurs serait une autre machine.</translation>
    </message>
    <message>
        <source>Wait for the end of the write.</source>
        <translation>Attendre la fin de l&apos;écriture.</translation>
    </message>
    <message>
        <source>Files that are there are not replaced unasked</source>
        <translation>Les fichiers existants ne sont pas remplacés sans confirmation</translation>
    </message>
    <message>
        <source>The folder has other files of these names, which would be replaced: %1.</source>
        <translation>Le dossier contient d&apos;autres fichiers de ces noms, qui seraient remplacés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Reading the drives …</source>
        <translation>Lecture des variateurs …</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Enregistrement …</translation>
    </message>
    <message>
        <source>Nothing is saved yet.</source>
        <translation>Rien n&apos;est encore enregistré.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Saved %1: drives: %2, tables: %3.</source>
        <translation>%1 enregistré&#xa0;: variateurs&#xa0;: %2, tables&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Folder for the Machine File</source>
        <translation>Dossier du fichier machine</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SettingFields</name>
    <message>
        <source>not given</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>default: %1</source>
        <translation>par défaut&#xa0;: %1</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>requis</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>selon le fichier</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SetupHistory</name>
    <message>
        <source>Dimensionality</source>
        <translation>Dimensionnalité</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistance</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Source Dim%1</translation>
    </message>
    <message>
        <source>Compensation data</source>
        <translation>Données de compensation</translation>
    </message>
    <message>
        <source>Several fields</source>
        <translation>Plusieurs champs</translation>
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
        <translation>persistante</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volatile</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>Ax&amp;e</translation>
    </message>
    <message>
        <source>The axis to compensate; lists all axes of all drives</source>
        <translation>L&apos;axe à compenser&#xa0;; liste tous les axes de tous les variateurs</translation>
    </message>
    <message>
        <source>The axis to compensate</source>
        <translation>L&apos;axe à compenser</translation>
    </message>
    <message>
        <source>Dimen&amp;sionality</source>
        <translation>Dime&amp;nsionnalité</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on: 1D one, 2D two, 3D three</source>
        <translation>Le nombre de positions dont dépend la compensation&#xa0;: 1D une, 2D deux, 3D trois</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on</source>
        <translation>Le nombre de positions dont dépend la compensation</translation>
    </message>
    <message>
        <source>Dim&amp;1 Source</source>
        <translation>Source Dim&amp;1</translation>
    </message>
    <message>
        <source>Dim&amp;2 Source</source>
        <translation>Source Dim&amp;2</translation>
    </message>
    <message>
        <source>Dim&amp;3 Source</source>
        <translation>Source Dim&amp;3</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1: select one, or type a path, a tam:// URI or a hexadecimal address and press Enter</source>
        <translation>Le registre qui fournit la position de la dimension %1&#xa0;: en choisir un, ou saisir un chemin, une URI tam:// ou une adresse hexadécimale et appuyer sur Entrée</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1</source>
        <translation>Le registre qui fournit la position de la dimension %1</translation>
    </message>
    <message>
        <source>Compensat&amp;ion data</source>
        <translation>D&amp;onnées</translation>
    </message>
    <message>
        <source>A file of positions and compensation values; needed only for a new table</source>
        <translation>Un fichier de positions et de valeurs de compensation&#xa0;; nécessaire seulement pour une nouvelle table</translation>
    </message>
    <message>
        <source>A file of compensation values; needed only for a new table</source>
        <translation>Un fichier de valeurs de compensation&#xa0;; nécessaire seulement pour une nouvelle table</translation>
    </message>
    <message>
        <source>Ta&amp;ble</source>
        <translation>Ta&amp;ble</translation>
    </message>
    <message>
        <source>The table for the axis: the one on the drive, or one from the file</source>
        <translation>La table de l&apos;axe&#xa0;: celle du variateur ou l&apos;une de celles du fichier</translation>
    </message>
    <message>
        <source>The table for the axis</source>
        <translation>La table de l&apos;axe</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistance</translation>
    </message>
    <message>
        <source>Persistent: stored in the drive&apos;s flash and kept over a reboot. Volatile: lost on a reboot. Applies to the table on the drive as well</source>
        <translation>Persistant&#xa0;: enregistré dans la mémoire flash du variateur, conservé après un redémarrage. Volatil&#xa0;: perdu au redémarrage. Vaut aussi pour la table sur le variateur</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>Si la table survit à un redémarrage</translation>
    </message>
    <message>
        <source>Make &amp;persistent</source>
        <translation>Rendre &amp;persistante</translation>
    </message>
    <message>
        <source>no axis</source>
        <translation>aucun axe</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>origine prise</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>origine non prise</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>numéro de série %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>homed, serial number</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, positions in %2, %3</source>
        <translation>%1, positions en %2, %3</translation>
    </message>
    <message>
        <source>select or type a register</source>
        <translation>choisir ou saisir un registre</translation>
    </message>
    <message>
        <source>now %1</source>
        <comment>value</comment>
        <translation>actuel&#xa0;: %1</translation>
    </message>
    <message>
        <source>one source, one column of positions</source>
        <translation>une source, une colonne de positions</translation>
    </message>
    <message>
        <source>two sources, two columns of positions</source>
        <translation>deux sources, deux colonnes de positions</translation>
    </message>
    <message>
        <source>three sources, three columns of positions</source>
        <translation>trois sources, trois colonnes de positions</translation>
    </message>
    <message>
        <source>On the drive: %1</source>
        <translation>Sur le variateur&#xa0;: %1</translation>
    </message>
    <message>
        <source>none on the drive</source>
        <translation>aucune sur le variateur</translation>
    </message>
    <message>
        <source>Parsed: %1</source>
        <translation>Du fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>open a file to get a table</source>
        <translation>ouvrir un fichier pour obtenir une table</translation>
    </message>
    <message>
        <source>%1 is not used, problems: %2</source>
        <translation>%1 n&apos;est pas utilisé, problèmes&#xa0;: %2</translation>
    </message>
    <message>
        <source>CSV; needed only for a new table</source>
        <translation>CSV&#xa0;; nécessaire seulement pour une nouvelle table</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>lecture de %1</translation>
    </message>
    <message>
        <source>tables: %1, points: %2</source>
        <translation>tables&#xa0;: %1, points&#xa0;: %2</translation>
    </message>
    <message>
        <source>in flash</source>
        <translation>en mémoire flash</translation>
    </message>
    <message>
        <source>lost on a reboot</source>
        <translation>perdue au redémarrage</translation>
    </message>
    <message>
        <source>; %1 of %2 flash operations available now</source>
        <comment>of the flash</comment>
        <translation>&#xa0;; %1 opérations flash sur %2 disponibles actuellement</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>non définie</translation>
    </message>
    <message>
        <source>unknown register %1</source>
        <translation>registre inconnu %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1, %2 points</source>
        <translation>%1, %2 points</translation>
    </message>
    <message>
        <source>%1, empty</source>
        <comment>table slot</comment>
        <translation>%1, vide</translation>
    </message>
    <message>
        <source>; %1 of typically %2 flash cycles used</source>
        <comment>of the flash</comment>
        <translation>&#xa0;; cycles flash utilisés&#xa0;: %1 sur %2 typiques</translation>
    </message>
    <message>
        <source>; read as %1, converted</source>
        <translation>&#xa0;; lu comme %1, converti</translation>
    </message>
    <message>
        <source>from %1; the drive has it already</source>
        <translation>de %1&#xa0;; le variateur l&apos;a déjà</translation>
    </message>
    <message>
        <source>Fitted: %1</source>
        <translation>Ajustée&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SeveralWritesDialog</name>
    <message>
        <source>What will be written</source>
        <translation>Ce qui sera écrit</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>&amp;Write All</source>
        <translation>&amp;Tout écrire</translation>
    </message>
    <message>
        <source>Write these to the drive now</source>
        <translation>Écrire maintenant dans le variateur</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>Confirmer d&apos;abord les grandes corrections</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>A&amp;rrêter</translation>
    </message>
    <message>
        <source>Stops the writes; the current one is rolled back (Esc)</source>
        <translation>Arrête les écritures&#xa0;; l&apos;ancien état est restauré pour celle en cours (Échap)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>Revenir à la page (Échap)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>Ne rien changer et revenir (Échap)</translation>
    </message>
    <message>
        <source>Asking the drive what would change …</source>
        <translation>Recherche de ce qui changerait sur le variateur …</translation>
    </message>
    <message>
        <source>The drive already has all of this.</source>
        <translation>Le variateur a déjà tout cela.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SignSentence</name>
    <message>
        <source>all values are 0: the drive will add nothing</source>
        <translation>toutes les valeurs sont 0&#xa0;: le variateur n&apos;ajoutera rien</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the reference reads %2: the drive will add %3</source>
        <translation>là où le codeur indique %1, la référence indique %2&#xa0;: le variateur ajoutera %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>à %1, %2</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 more than the encoder: the drive will add %3</source>
        <translation>à %1, la référence indique %2 de plus que le codeur&#xa0;: le variateur ajoutera %3</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 less than the encoder: the drive will add %3</source>
        <translation>à %1, la référence indique %2 de moins que le codeur&#xa0;: le variateur ajoutera %3</translation>
    </message>
    <message>
        <source>at the set position %1 the drive will add %2</source>
        <translation>à la position de consigne %1, le variateur ajoutera %2</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the drive will add %2</source>
        <translation>là où le codeur indique %1, le variateur ajoutera %2</translation>
    </message>
    <message>
        <source>at %1 the drive will add %2</source>
        <translation>à %1, le variateur ajoutera %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceGallery</name>
    <message>
        <source>Slices of the table</source>
        <translation>Coupes de la table</translation>
    </message>
    <message>
        <source>Enter shows the slice as a picture</source>
        <translation>Entrée affiche la coupe en image</translation>
    </message>
    <message>
        <source>colours from %1 to %2</source>
        <translation>couleurs de %1 à %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices · %3</source>
        <translation>%1 coupes sur %2 · %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceRow</name>
    <message>
        <source>Slice at</source>
        <translation>Coupe à</translation>
    </message>
    <message>
        <source>The slice that is shown</source>
        <translation>La coupe affichée</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>The dimension that is held constant; the other two are shown</source>
        <translation>La dimension maintenue constante&#xa0;; les deux autres sont affichées</translation>
    </message>
    <message>
        <source>Sliced dimension</source>
        <translation>Dimension de coupe</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SourceCheck</name>
    <message>
        <source>The drive is not connected: the source cannot be checked.</source>
        <translation>Le variateur n&apos;est pas connecté&#xa0;: la source ne peut pas être vérifiée.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StateField</name>
    <message>
        <source>OFF</source>
        <translation>ARRÊT</translation>
    </message>
    <message>
        <source>EVALUATING</source>
        <translation>ÉVALUATION</translation>
    </message>
    <message>
        <source>RAMPING</source>
        <translation>RAMPE</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>ACTIVE</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>ERREUR</translation>
    </message>
    <message>
        <source>Output %1 · Index %2</source>
        <translation>Sortie %1 · Indice %2</translation>
    </message>
    <message>
        <source>The state of the compensation of this axis</source>
        <translation>L&apos;état de la compensation de cet axe</translation>
    </message>
    <message>
        <source>Live values of the drive: the compensation output and the table index</source>
        <translation>Valeurs du variateur en direct&#xa0;: la sortie de la compensation et l&apos;indice de table</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>depuis %1</translation>
    </message>
    <message>
        <source>since before %1</source>
        <translation>depuis avant %1</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>aucune table</translation>
    </message>
    <message>
        <source>%1, CRC %2</source>
        <comment>table and checksum</comment>
        <translation>%1, CRC %2</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>NON CONNECTÉ</translation>
    </message>
    <message>
        <source>as read at %1</source>
        <translation>lu à %1</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>hors de la table&#xa0;: valeur d&apos;extrémité maintenue</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>contredit sa table</translation>
    </message>
    <message>
        <source>not proved yet</source>
        <translation>pas encore validée</translation>
    </message>
    <message>
        <source>proved over %1 of the table</source>
        <translation>validée sur %1 de la table</translation>
    </message>
    <message>
        <source>Compensation: %1</source>
        <comment>state</comment>
        <translation>Compensation&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StationChoice</name>
    <message>
        <source>The file is being read.</source>
        <translation>Lecture du fichier en cours.</translation>
    </message>
    <message>
        <source>The file has no station.</source>
        <translation>Le fichier n&apos;a pas de station.</translation>
    </message>
    <message>
        <source>Select the station that is this drive.</source>
        <translation>Sélectionner la station qui est ce variateur.</translation>
    </message>
    <message>
        <source>Confirm first that the station is meant.</source>
        <translation>Confirmer d&apos;abord qu&apos;il s&apos;agit bien de cette station.</translation>
    </message>
    <message>
        <source>%1 has the serial number %2, the drive %3 has %4.</source>
        <translation>%1 a le numéro de série %2, le variateur %3 a %4.</translation>
    </message>
    <message>
        <source>Stat&amp;ion</source>
        <translation>Stat&amp;ion</translation>
    </message>
    <message>
        <source>not selected</source>
        <translation>non sélectionnée</translation>
    </message>
    <message>
        <source>The drive in the configuration whose parameters are meant</source>
        <translation>Le variateur de la configuration dont les paramètres sont concernés</translation>
    </message>
    <message>
        <source>These &amp;parameters are for this drive although the serial numbers differ</source>
        <translation>Ces &amp;paramètres sont pour ce variateur bien que les numéros de série diffèrent</translation>
    </message>
    <message>
        <source>The &amp;parameters of this drive are for this station although the serial numbers differ</source>
        <translation>Les &amp;paramètres de ce variateur sont pour cette station bien que les numéros de série diffèrent</translation>
    </message>
    <message>
        <source>The wrong drive would get the compensation of another machine</source>
        <translation>Sinon, le mauvais variateur recevrait la compensation d&apos;une autre machine</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StatusStrip</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>Annule&amp;r</translation>
    </message>
    <message>
        <source>Stops the operation; a write is rolled back (Esc)</source>
        <translation>Arrête l&apos;opération&#xa0;; pour une écriture, l&apos;ancien état est restauré (Échap)</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>&amp;Journal</translation>
    </message>
    <message>
        <source>Show the log (Ctrl+L)</source>
        <translation>Afficher le journal (Ctrl+L)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SurfaceView</name>
    <message>
        <source>Heights</source>
        <translation>Amplification</translation>
    </message>
    <message>
        <source>How many times too high the errors are drawn, compared with the axes (+ and -)</source>
        <translation>Nombre de fois dont les erreurs sont dessinées trop hautes par rapport aux axes (+ et -)</translation>
    </message>
    <message>
        <source>First view</source>
        <translation>Vue initiale</translation>
    </message>
    <message>
        <source>Surface of the table</source>
        <translation>Surface de la table</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>compensation</translation>
    </message>
    <message>
        <source>heights × %1</source>
        <translation>amplification × %1</translation>
    </message>
    <message>
        <source>See the surface as at first (Home or a double click). Arrow keys and dragging turn it, the wheel, Page Up and Page Down zoom.</source>
        <translation>Revoir la surface comme au début (Début ou double-clic). Les flèches et un glissement la tournent, la molette, Page préc. et Page suiv. zooment.</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>Enregistrer en PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>Il n&apos;y a pas de table à enregistrer.</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>surface</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l&apos;image</translation>
    </message>
    <message>
        <source>The units of the table have no common scale; the heights are drawn as they fit</source>
        <translation>Les unités de la table n&apos;ont pas d&apos;échelle commune&#xa0;; les hauteurs sont ajustées au dessin</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableContentCombo</name>
    <message>
        <source>Selected table</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Table on the drive</source>
        <translation>Table sur le variateur</translation>
    </message>
    <message>
        <source>Selected - drive</source>
        <translation>Écart au variateur</translation>
    </message>
    <message>
        <source>Which values are shown</source>
        <translation>Les valeurs à afficher</translation>
    </message>
    <message>
        <source>Values shown</source>
        <translation>Valeurs affichées</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TablePlot</name>
    <message>
        <source>C&amp;ursors</source>
        <translation>C&amp;urseurs</translation>
    </message>
    <message>
        <source>Two cursors and their difference. Arrow keys move the cursor, Space changes between A and B, a click sets it.</source>
        <translation>Deux curseurs et leur différence. Les flèches déplacent le curseur, la barre d&apos;espace passe de A à B, un clic le place.</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>sélectionnée</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>sur le variateur</translation>
    </message>
    <message>
        <source>Picture of the table</source>
        <translation>Image de la table</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>compensation</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>Tout a&amp;fficher</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>A: %1     B: %2
B - A: %3</source>
        <translation>A&#xa0;: %1     B&#xa0;: %2
B - A&#xa0;: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>What is drawn over the map</source>
        <translation>Ce qui est dessiné sur la carte</translation>
    </message>
    <message>
        <source>&amp;Grid points</source>
        <translation>&amp;Points de grille</translation>
    </message>
    <message>
        <source>The points of the table, where they are far enough apart</source>
        <translation>Les points de la table, s&apos;ils sont assez espacés</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Isolignes</translation>
    </message>
    <message>
        <source>Lines of equal value</source>
        <translation>Lignes d&apos;égale valeur</translation>
    </message>
    <message>
        <source>Cross-&amp;sections</source>
        <translation>C&amp;oupes</translation>
    </message>
    <message>
        <source>The values along both axes through the cross-hair or the cursor, or else through the position of the axis</source>
        <translation>Les valeurs suivant les deux axes par le réticule ou le curseur, sinon par la position de l&apos;axe</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>hors de la table&#xa0;: valeur d&apos;extrémité maintenue</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg, .pdf or .csv.</source>
        <translation>Le nom du fichier doit se terminer par .png, .svg, .pdf ou .csv.</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>Il n&apos;y a pas de table à enregistrer.</translation>
    </message>
    <message>
        <source>map</source>
        <translation>carte</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>courbe</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l&apos;image</translation>
    </message>
    <message>
        <source>Show the whole table again (Home or a double click). The wheel and + and - zoom, Shift and drag zooms into a rectangle, dragging moves.</source>
        <translation>Afficher de nouveau toute la table (Début ou double-clic). La molette ainsi que + et - zooment, Maj et glissement agrandit un rectangle, un glissement déplace.</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF, or the values shown as CSV</source>
        <translation>Enregistrer en PNG, SVG ou PDF, ou les valeurs affichées en CSV</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>course</translation>
    </message>
    <message>
        <source>table</source>
        <translation>table</translation>
    </message>
    <message>
        <source>end value held</source>
        <translation>extrémité maintenue</translation>
    </message>
    <message>
        <source>A difference is no table for a drive: it can be saved as a picture only.</source>
        <translation>Une différence n&apos;est pas une table pour un variateur&#xa0;: elle ne s&apos;enregistre que comme image.</translation>
    </message>
    <message>
        <source>These are values of another controller: Export for Another Controller writes its file.</source>
        <translation>Ce sont les valeurs d&apos;une autre commande&#xa0;: « Exporter pour une autre commande » écrit son fichier.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableSelection</name>
    <message>
        <source>%1 has been read: %2 points, tables: %3.</source>
        <translation>%1 a été lu&#xa0;: %2 points, tables&#xa0;: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2 problems.</source>
        <translation>%1 n&apos;est pas utilisable&#xa0;: %2 problèmes.</translation>
    </message>
    <message>
        <source>%1 is used as the table: %2 points, tables: %3.</source>
        <translation>%1 est utilisé comme table&#xa0;: %2 points, tables&#xa0;: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be used as it is. %2</source>
        <translation>%1 n&apos;est pas utilisable tel quel. %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableViewModel</name>
    <message>
        <source>No table</source>
        <translation>Aucune table</translation>
    </message>
    <message>
        <source>%1, step %2 · min %3, max %4, rms %5</source>
        <translation>%1, pas %2 · min %3, max %4, RMS %5</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>compensation</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TargetFiguresModel</name>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Position cible</translation>
    </message>
    <message>
        <source>Values ↑</source>
        <translation>Valeurs ↑</translation>
    </message>
    <message>
        <source>Mean ↑</source>
        <translation>Moyenne ↑</translation>
    </message>
    <message>
        <source>Values ↓</source>
        <translation>Valeurs ↓</translation>
    </message>
    <message>
        <source>Mean ↓</source>
        <translation>Moyenne ↓</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::UnsavedChangesGuard</name>
    <message>
        <source>Discard and Chan&amp;ge Axis</source>
        <translation>Abandonner et chan&amp;ger d&apos;axe</translation>
    </message>
    <message>
        <source>Discard and Chan&amp;ge Connections</source>
        <translation>Abandonner et chan&amp;ger de connexions</translation>
    </message>
    <message>
        <source>Close Without Writin&amp;g</source>
        <translation>Fermer &amp;sans écrire</translation>
    </message>
    <message>
        <source>A write is in progress. Stopping rolls it back first.</source>
        <translation>Une écriture est en cours. L&apos;arrêter restaure d&apos;abord l&apos;ancien état.</translation>
    </message>
    <message>
        <source>&amp;Stop and Close</source>
        <translation>&amp;Arrêter et fermer</translation>
    </message>
    <message>
        <source>Close When Don&amp;e</source>
        <translation>Fermer en&amp;suite</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>Res&amp;ter</translation>
    </message>
    <message>
        <source>%1 has changes that are not written to the drive.</source>
        <translation>%1 a des modifications non écrites dans le variateur.</translation>
    </message>
    <message>
        <source>Save Record, &amp;Then Close</source>
        <translation>Enre&amp;gistrer, puis fermer</translation>
    </message>
    <message>
        <source>Close Without Savin&amp;g</source>
        <translation>Fe&amp;rmer sans enregistrer</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesModel</name>
    <message>
        <source>Index %1</source>
        <translation>Indice %1</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>compensation</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>sur le variateur</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesView</name>
    <message>
        <source>Values of the table</source>
        <translation>Valeurs de la table</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy With Positions</source>
        <translation>Copier avec les positions</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Copy the selected values, or all of them, with their positions for a spreadsheet. Ctrl+C copies the selected values alone.</source>
        <translation>Copier les valeurs sélectionnées, ou toutes, avec leurs positions, pour un tableur. Ctrl+C copie les valeurs sélectionnées seules.</translation>
    </message>
    <message>
        <source>Copy values</source>
        <translation>Copier les valeurs</translation>
    </message>
    <message>
        <source>%1 across, %2 down, %3</source>
        <translation>%1 en largeur, %2 en hauteur, %3</translation>
    </message>
    <message>
        <source>Copied cells: %1</source>
        <translation>Cellules copiées&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::VectorView</name>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>How many times too large errors are drawn (+ and -)</source>
        <translation>Nombre de fois dont les erreurs sont dessinées trop grandes (+ et -)</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>Tout a&amp;fficher</translation>
    </message>
    <message>
        <source>Show the whole grid again (Home or a double click). The wheel, Page Up and Page Down zoom, dragging and the arrow keys move.</source>
        <translation>Afficher de nouveau toute la grille (Début ou double-clic). La molette, Page préc. et Page suiv. zooment, un glissement et les flèches déplacent.</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>Enregistrer en PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>Grid with the errors of two axes</source>
        <translation>Grille avec les erreurs de deux axes</translation>
    </message>
    <message>
        <source>The column with the errors along %1</source>
        <translation>La colonne des erreurs suivant %1</translation>
    </message>
    <message>
        <source>Thin: the grid as the encoders read it. Bold: where the axes really are, errors × %1.</source>
        <translation>Trait fin&#xa0;: la grille telle que l&apos;indiquent les codeurs. Trait épais&#xa0;: où sont réellement les axes, erreurs × %1.</translation>
    </message>
    <message>
        <source>The file has no errors of both axes of this slice: cut another dimension.</source>
        <translation>Le fichier n&apos;a pas les erreurs des deux axes de cette coupe&#xa0;: couper une autre dimension.</translation>
    </message>
    <message>
        <source>%1 and %2, errors × %3</source>
        <translation>%1 et %2, erreurs × %3</translation>
    </message>
    <message>
        <source>errors of two axes</source>
        <translation>erreurs de deux axes</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l&apos;image</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WarningList</name>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardController</name>
    <message>
        <source>Wait for the current operation before selecting another axis.</source>
        <translation>Attendre la fin de l&apos;opération en cours avant de sélectionner un autre axe.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardLog</name>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WritePreview</name>
    <message>
        <source>persistent</source>
        <translation>persistante</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volatile</translation>
    </message>
    <message>
        <source>Nothing on the drive has changed yet. The old table and settings are backed up first.</source>
        <translation>Rien n&apos;a encore changé sur le variateur. L&apos;ancienne table et les anciens réglages sont d&apos;abord sauvegardés.</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>Sur le variateur</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Ce qui sera écrit</translation>
    </message>
    <message>
        <source>Do not show this again &amp;for volatile writes</source>
        <translation>Ne plus a&amp;fficher pour les écritures volatiles</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview; the menu turns it back on for volatile ones</source>
        <translation>Une écriture persistante affiche toujours l&apos;aperçu&#xa0;; le menu le rétablit pour les écritures volatiles</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>Écrire &amp;maintenant</translation>
    </message>
    <message>
        <source>Write this to the drive now</source>
        <translation>Écrire ceci maintenant dans le variateur</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>Reto&amp;ur</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>Ne rien changer et revenir (Échap)</translation>
    </message>
    <message>
        <source>What will be written to %1</source>
        <comment>axis and drive</comment>
        <translation>Ce qui sera écrit dans %1</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Largest change</source>
        <translation>Plus grande variation</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcul …</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>Dimensionnalité</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Source Dim%1</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>Persistance</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>aucune table</translation>
    </message>
    <message>
        <source>Uses no flash operation. Volatile: lost on a reboot.</source>
        <translation>N&apos;utilise aucune opération flash. Volatil&#xa0;: perdu au redémarrage.</translation>
    </message>
    <message>
        <source>Uses no flash operation: the flash already holds it.</source>
        <translation>N&apos;utilise aucune opération flash&#xa0;: la mémoire flash la contient déjà.</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>Opérations flash&#xa0;: %1 utilisées, %2 restantes juste après.</translation>
    </message>
    <message>
        <source>%1 held an earlier table of this axis; the current one stays complete until the axis has switched to the new one.</source>
        <translation>%1 contenait une table antérieure de cet axe&#xa0;; l&apos;actuelle reste complète jusqu&apos;à ce que l&apos;axe ait basculé sur la nouvelle.</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>non définie</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>possibly not saved</source>
        <translation>peut-être non enregistrés</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>enregistrés</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>Ces &amp;grandes corrections sont justes&#xa0;: leur unité a été vérifiée</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>Confirmer d&apos;abord les grandes corrections</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Suppri&amp;mer</translation>
    </message>
    <message>
        <source>Delete this from the drive now</source>
        <translation>Supprimer maintenant du variateur</translation>
    </message>
    <message>
        <source>What will be deleted from %1</source>
        <comment>axis and drive</comment>
        <translation>Ce qui sera supprimé de %1</translation>
    </message>
    <message>
        <source>empty</source>
        <comment>slot</comment>
        <translation>vide</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>N&apos;utilise aucune opération flash.</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>Re&amp;staurer</translation>
    </message>
    <message>
        <source>What will be restored on %1</source>
        <comment>axis and drive</comment>
        <translation>Ce qui sera restauré sur %1</translation>
    </message>
    <message>
        <source>This is what the axis had before the write of %1.</source>
        <translation>C&apos;est ce qu&apos;avait l&apos;axe avant l&apos;écriture du %1.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>This is the state in the backup file of %1.</source>
        <translation>C&apos;est l&apos;état que contient le fichier de sauvegarde du %1.</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberBox</name>
    <message>
        <source>%1: %2</source>
        <comment>field and problem</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlotStyle</name>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
</context>
</TS>
