<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>ColumnRole</name>
    <message>
        <source>target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>run</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>エンコーダ</translation>
    </message>
    <message>
        <source>output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>use</source>
        <translation>使用</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>clock</source>
        <translation>時計</translation>
    </message>
    <message>
        <source>{now} is before the program was made, {made}</source>
        <translation>{now} はプログラムのビルド日時 {made} より前です</translation>
    </message>
    <message>
        <source>set the clock (timedatectl says what it follows): flash operations are counted by it</source>
        <translation>時計を合わせてください (同期元は timedatectl で確認できます)。フラッシュ操作はこの時計を基に数えます</translation>
    </message>
    <message>
        <source>display</source>
        <translation>ディスプレイ</translation>
    </message>
    <message>
        <source>unset it if the window does not appear</source>
        <translation>ウィンドウが表示されない場合は、この変数の設定を解除してください</translation>
    </message>
    <message>
        <source>none; the window needs one</source>
        <translation>なし。ウィンドウ版には必要です</translation>
    </message>
    <message>
        <source>start the window on the desktop, or over ssh -X; the command line does without</source>
        <translation>ウィンドウ版はデスクトップから、または ssh -X 経由で起動してください。コマンドラインには不要です</translation>
    </message>
    <message>
        <source>temporary folder</source>
        <translation>一時フォルダ</translation>
    </message>
    <message>
        <source>{folder} is not there</source>
        <translation>{folder} がありません</translation>
    </message>
    <message>
        <source>make it, or set {variable} to another folder</source>
        <translation>作成するか、{variable} に別のフォルダを設定してください</translation>
    </message>
    <message>
        <source>{folder}, {free} free</source>
        <translation>{folder}、空き {free}</translation>
    </message>
    <message>
        <source>runtime folder</source>
        <translation>ランタイムフォルダ</translation>
    </message>
    <message>
        <source>log in at the desktop or over ssh, and not by su or sudo, if the window does not appear</source>
        <translation>ウィンドウが表示されない場合は、su や sudo ではなく、デスクトップまたは ssh でログインしてください</translation>
    </message>
    <message>
        <source>XDG_RUNTIME_DIR is not set</source>
        <translation>XDG_RUNTIME_DIR が設定されていません</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}</source>
        <translation>{folder} の所有者は {owner} です</translation>
    </message>
    <message>
        <source>proxies</source>
        <translation>プロキシ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>{variables}: drives are reached without a proxy all the same</source>
        <translation>{variables}: 設定されていても、ドライブにはプロキシを使わずに接続します</translation>
    </message>
    <message>
        <source>no variable is set</source>
        <translation>変数の設定なし</translation>
    </message>
    <message>
        <source>locale</source>
        <translation>ロケール</translation>
    </message>
    <message>
        <source>{variables}: this locale is not installed</source>
        <translation>{variables}: このロケールはインストールされていません</translation>
    </message>
    <message>
        <source>{variables}: its encoding {encoding} is not UTF-8, so that letters outside of ASCII may look wrong</source>
        <translation>{variables}: エンコーディング {encoding} が UTF-8 ではないため、ASCII 以外の文字が正しく表示されないことがあります</translation>
    </message>
    <message>
        <source>export LC_ALL=C.UTF-8, or the locale of your language with UTF-8</source>
        <translation>export LC_ALL=C.UTF-8、または使用する言語の UTF-8 ロケール</translation>
    </message>
    <message>
        <source>{variables}: {encoding}</source>
        <translation>{variables}: {encoding}</translation>
    </message>
    <message>
        <source>set {variable} to a folder of your own</source>
        <translation>{variable} に自分のフォルダを設定してください</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} is no folder</source>
        <translation>{folder} を使用できません: {nearest} はフォルダではありません</translation>
    </message>
    <message>
        <source>{folder} cannot be used: you have no permission to look into {nearest}</source>
        <translation>{folder} を使用できません: {nearest} の中を見る権限がありません</translation>
    </message>
    <message>
        <source>{folder} is on a file system that is read-only</source>
        <translation>{folder} は読み取り専用のファイルシステム上にあります</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} belongs to {owner}, and you have no permission to change it</source>
        <translation>{folder} を使用できません: {nearest} の所有者は {owner} で、変更する権限がありません</translation>
    </message>
    <message>
        <source>{folder} has only {free} free</source>
        <translation>{folder} の空きは {free} しかありません</translation>
    </message>
    <message>
        <source>{folder} is on a file system that takes no more files, with {free} free</source>
        <translation>{folder} は、これ以上ファイルを作成できないファイルシステム上にあります (空き {free})</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to a folder of another disk</source>
        <translation>空きを増やすか、{variable} に別のディスクのフォルダを設定してください</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>System</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>system</source>
        <translation>OS</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>カーネル</translation>
    </message>
    <message>
        <source>processor cores</source>
        <translation>プロセッサのコア数</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>メモリ</translation>
    </message>
    <message>
        <source>{all}, {free} free</source>
        <translation>{all}、空き {free}</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>decimal sign</source>
        <translation>小数点</translation>
    </message>
    <message>
        <source>&quot;{sign}&quot;; the command line writes and reads a point</source>
        <translation>&quot;{sign}&quot;。コマンドラインではピリオドで読み書きします</translation>
    </message>
    <message>
        <source>translations</source>
        <translation>翻訳</translation>
    </message>
    <message>
        <source>window settings</source>
        <translation>ウィンドウ版の設定</translation>
    </message>
    <message>
        <source>none; the window was not used yet</source>
        <translation>なし。ウィンドウ版はまだ使用されていません</translation>
    </message>
    <message>
        <source>{file} is not a file that you may read</source>
        <translation>{file} は読み取りできるファイルではありません</translation>
    </message>
    <message>
        <source>move it away; the window begins a new one</source>
        <translation>別の場所に移してください。ウィンドウ版が新しく作成します</translation>
    </message>
    <message>
        <source>{file} is damaged</source>
        <translation>{file} は破損しています</translation>
    </message>
    <message>
        <source>{file}, connections: {number}</source>
        <translation>{file}、接続: {number}</translation>
    </message>
    <message>
        <source>drive profile</source>
        <translation>ドライブプロファイル</translation>
    </message>
    <message>
        <source>{profile}, built in</source>
        <translation>{profile}、組み込み</translation>
    </message>
    <message>
        <source>trusted certificates</source>
        <translation>信頼する証明書</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>構成</translation>
    </message>
    <message>
        <source>open {drive} in a browser of this computer; if it does not answer there either, look at power, cable and network</source>
        <translation>このコンピュータのブラウザで {drive} を開いてください。そこでも応答がなければ、電源、ケーブル、ネットワークを確認してください</translation>
    </message>
    <message>
        <source>look at power and cable; `axiscomp axes --find --any-baud` tries other speeds</source>
        <translation>電源とケーブルを確認してください。`axiscomp axes --find --any-baud` でほかのボーレートを試せます</translation>
    </message>
    <message>
        <source>address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>{drive}, serial number {serial}, axes: {axes}, profile {profile}; answered after {milliseconds}</source>
        <translation>{drive}、シリアル番号 {serial}、軸: {axes}、プロファイル {profile}。{milliseconds} で応答</translation>
    </message>
    <message>
        <source>{drive}; then: {error}</source>
        <translation>{drive}。その後: {error}</translation>
    </message>
    <message>
        <source>{unit}, {homing}, compensation {state}</source>
        <translation>{unit}、{homing}、補正 {state}</translation>
    </message>
    <message>
        <source>{state}, no table</source>
        <translation>{state}、テーブルなし</translation>
    </message>
    <message>
        <source>{state}, table {slot} with CRC {crc}</source>
        <translation>{state}、テーブル {slot}、CRC {crc}</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>軸 {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>軸 {axis} ({name})</translation>
    </message>
    <message>
        <source>it has no compensation registers by this profile</source>
        <translation>このプロファイルでは補正のレジスタがありません</translation>
    </message>
    <message>
        <source>drive error</source>
        <translation>ドライブのエラー</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>none is known</source>
        <translation>記憶しているドライブはありません</translation>
    </message>
    <message>
        <source>add a connection in the window, or give --drive ADDRESS</source>
        <translation>ウィンドウ版で接続を追加するか、--drive ADDRESS を指定してください</translation>
    </message>
    <message>
        <source>{version}, built with {other}</source>
        <translation>{version}、ビルド時 {other}</translation>
    </message>
    <message>
        <source>there is no TLS library: https drives cannot be reached</source>
        <translation>TLS ライブラリがないため、https のドライブには接続できません</translation>
    </message>
    <message>
        <source>install OpenSSL (sudo apt install libssl3)</source>
        <translation>OpenSSL をインストールしてください (sudo apt install libssl3)</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ウィンドウ版</translation>
    </message>
    <message>
        <source>not installed; the command line does without</source>
        <translation>インストールされていません。コマンドラインには不要です</translation>
    </message>
    <message>
        <source>reports</source>
        <translation>報告書</translation>
    </message>
    <message>
        <source>what draws PDF is not installed</source>
        <translation>PDF を作成するモジュールがインストールされていません</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>version</source>
        <translation>バージョン</translation>
    </message>
    <message>
        <source>program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>a port without a name</source>
        <translation>名前のないポート</translation>
    </message>
    <message>
        <source>{hardware}, built in</source>
        <translation>{hardware}、内蔵</translation>
    </message>
    <message>
        <source>{hardware}, USB {id}</source>
        <translation>{hardware}、USB {id}</translation>
    </message>
    <message>
        <source>{hardware}: {problem}</source>
        <translation>{hardware}: {problem}</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>シリアルポート</translation>
    </message>
    <message>
        <source>ports</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>this computer has none</source>
        <translation>このコンピュータにはありません</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>フォルダ</translation>
    </message>
    <message>
        <source>sudo chown -R $USER {folder}; run this program without sudo</source>
        <translation>sudo chown -R $USER {folder} を実行し、このプログラムは sudo なしで起動してください</translation>
    </message>
    <message>
        <source>{folder} is yours, but its permissions keep you out</source>
        <translation>{folder} の所有者は現在のユーザですが、フォルダの権限によりアクセスできません</translation>
    </message>
    <message>
        <source>{folder} is not there yet; the first write makes it</source>
        <translation>{folder} はまだありません。最初の書き込み時に作成されます</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}, and you are root: what is made there now belongs to root</source>
        <translation>{folder} の所有者は {owner} ですが、現在のユーザは root です。ここで新たに作成されるものの所有者は root になります</translation>
    </message>
    <message>
        <source>run this program without sudo</source>
        <translation>このプログラムは sudo なしで起動してください</translation>
    </message>
    <message>
        <source>{folder} can be changed by other users</source>
        <translation>{folder} はほかのユーザも変更できます</translation>
    </message>
    <message>
        <source>file system</source>
        <translation>ファイルシステム</translation>
    </message>
    <message>
        <source>on the network, where a database can be damaged: nothing is kept there, and no write begins</source>
        <translation>データベースが破損するおそれのあるネットワーク上です。何も保存せず、書き込みも開始しません</translation>
    </message>
    <message>
        <source>set {variable} to a folder on this computer</source>
        <translation>{variable} にこのコンピュータのフォルダを設定してください</translation>
    </message>
    <message>
        <source>in memory: backups and journal are gone after a restart</source>
        <translation>メモリ上です。バックアップとジャーナルは再起動で失われます</translation>
    </message>
    <message>
        <source>set {variable} to a folder on a disk</source>
        <translation>{variable} にディスク上のフォルダを設定してください</translation>
    </message>
    <message>
        <source>of this computer</source>
        <translation>このコンピュータ上</translation>
    </message>
    <message>
        <source>database</source>
        <translation>データベース</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>別の場所に移してください</translation>
    </message>
    <message>
        <source>none yet; the first write makes it</source>
        <translation>まだありません。最初の書き込み時に作成されます</translation>
    </message>
    <message>
        <source>of an older version, {size}; the next command that needs it brings it up to date</source>
        <translation>古いバージョン、{size}。次にデータベースを使うコマンドが更新します</translation>
    </message>
    <message>
        <source>a newer version of this program has written it</source>
        <translation>より新しいバージョンのプログラムで書かれています</translation>
    </message>
    <message>
        <source>use that version</source>
        <translation>そのバージョンを使ってください</translation>
    </message>
    <message>
        <source>it is the database of another program</source>
        <translation>別のプログラムのデータベースです</translation>
    </message>
    <message>
        <source>it is damaged ({reason})</source>
        <translation>破損しています ({reason})</translation>
    </message>
    <message>
        <source>the next command that needs it sets it aside and keeps what can be read; look what the drives hold, then `axiscomp status --reset-flash-count` for each</source>
        <translation>次にデータベースを使うコマンドがこれを退避し、読み取れる内容を残します。各ドライブの内容を確認してから、ドライブごとに `axiscomp status --reset-flash-count` を実行してください</translation>
    </message>
    <message>
        <source>not checked, because programs write to it all the time</source>
        <translation>プログラムが絶えず書き込んでいるため、検査していません</translation>
    </message>
    <message>
        <source>try again when they have finished</source>
        <translation>それらの終了後にもう一度試してください</translation>
    </message>
    <message>
        <source>you have no permission to change it</source>
        <translation>変更する権限がありません</translation>
    </message>
    <message>
        <source>let the user have it to whom the folder belongs (chown, chmod u+rw)</source>
        <translation>フォルダの所有者のものにしてください (chown、chmod u+rw)</translation>
    </message>
    <message>
        <source>whole, {size}</source>
        <translation>正常、{size}</translation>
    </message>
    <message>
        <source>interrupted write</source>
        <translation>中断された書き込み</translation>
    </message>
    <message>
        <source>write</source>
        <translation>書き込み</translation>
    </message>
    <message>
        <source>a program is writing to axis {axis} of the drive with serial number {drive} now, since {time} ({step})</source>
        <translation>プログラムがシリアル番号 {drive} のドライブの軸 {axis} に書き込み中です ({time} から、{step})</translation>
    </message>
    <message>
        <source>a write to axis {axis} of the drive with serial number {drive} began at {time} and did not end (step {step})</source>
        <translation>シリアル番号 {drive} のドライブの軸 {axis} への書き込みが {time} に始まり、終了していません (ステップ {step})</translation>
    </message>
    <message>
        <source>`axiscomp recover --axis {axis}` with that drive says what it holds, and finishes the write or undoes it</source>
        <translation>このドライブで `axiscomp recover --axis {axis}` を実行すると、ドライブの内容が表示され、書き込みを完了または取り消せます</translation>
    </message>
    <message>
        <source>interrupted writes</source>
        <translation>中断された書き込み</translation>
    </message>
    <message>
        <source>flash record</source>
        <translation>フラッシュ操作の履歴</translation>
    </message>
    <message>
        <source>that of the drive with serial number {drive} was damaged: its flash operations count as used up</source>
        <translation>シリアル番号 {drive} のドライブの履歴が破損していたため、フラッシュ操作をすべて使い切ったものとみなしています</translation>
    </message>
    <message>
        <source>wait as long as the drive counts them, then `axiscomp status --reset-flash-count`</source>
        <translation>ドライブがフラッシュ操作を数える期間だけ待ってから、`axiscomp status --reset-flash-count` を実行してください</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>退避済み</translation>
    </message>
    <message>
        <source>{file} is an earlier database that was damaged</source>
        <translation>{file} は破損していた以前のデータベースです</translation>
    </message>
    <message>
        <source>delete it when nothing is missed</source>
        <translation>不足するものがなければ削除してください</translation>
    </message>
    <message>
        <source>last change</source>
        <translation>最終変更</translation>
    </message>
    <message>
        <source>{time} is still to come: the clock was set back since</source>
        <translation>{time} は未来の日時です。その後に時計が戻されています</translation>
    </message>
    <message>
        <source>look at the clock: flash operations are counted by it</source>
        <translation>時計を確認してください。フラッシュ操作はこの時計を基に数えます</translation>
    </message>
    <message>
        <source>backups</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>files: {backups}, drives: {drives}, {size}</source>
        <translation>ファイル: {backups}、ドライブ: {drives}、{size}</translation>
    </message>
    <message>
        <source>State folder</source>
        <translation>状態フォルダ</translation>
    </message>
    <message>
        <source>sudo apt install locales and sudo dpkg-reconfigure locales, or export LC_ALL=C.UTF-8</source>
        <translation>sudo apt install locales と sudo dpkg-reconfigure locales、または export LC_ALL=C.UTF-8</translation>
    </message>
    <message>
        <source>if the drive has the same fingerprint: `axiscomp axes --drive {drive} --trust-certificate {fingerprint}` trusts it from then on</source>
        <translation>ドライブのフィンガープリントが同じであれば、`axiscomp axes --drive {drive} --trust-certificate {fingerprint}` で以後信頼されます</translation>
    </message>
    <message>
        <source>install the package {package}</source>
        <translation>パッケージ {package} をインストールしてください</translation>
    </message>
    <message>
        <source>install the package {package}, or write the report as HTML and print that</source>
        <translation>パッケージ {package} をインストールするか、レポートを HTML で保存して印刷してください</translation>
    </message>
    <message>
        <source>not checked: {reason}</source>
        <translation>検査していません: {reason}</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to another folder</source>
        <translation>そこに空きを作るか、{variable} に別のフォルダを設定してください</translation>
    </message>
    <message>
        <source>not checked, because no copy could be made in the temporary folder</source>
        <translation>一時フォルダにコピーを作成できなかったため、検査していません</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>{size} bytes</source>
        <translation>{size} バイト</translation>
    </message>
    <message>
        <source>at most {size} bytes</source>
        <translation>{size} バイト以下</translation>
    </message>
    <message>
        <source>at most {count} columns</source>
        <translation>{count} 列以下</translation>
    </message>
    <message>
        <source>a line with the names of the columns, not only comments</source>
        <translation>列名の行 (コメントだけでは不可)</translation>
    </message>
    <message>
        <source>no data lines after the header</source>
        <translation>ヘッダの後にデータ行がない</translation>
    </message>
    <message>
        <source>at least 2 positions in each dimension, one line per grid point</source>
        <translation>各次元に 2 つ以上の位置、格子点ごとに 1 行</translation>
    </message>
    <message>
        <source>the names of the columns, not numbers</source>
        <translation>数値ではなく列名</translation>
    </message>
    <message>
        <source>at least {count} for dimensionality {dimensions}, {positions} of positions and 1 of values</source>
        <translation>次元数 {dimensions} には {count} 列以上 (位置 {positions} 列、値 1 列)</translation>
    </message>
    <message>
        <source>{expected} (or is the dimensionality {dimensions}?)</source>
        <translation>{expected} (または次元数が {dimensions}?)</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ;</source>
        <translation>{expected}。列は , または ; で区切ってください</translation>
    </message>
    <message>
        <source>{expected}; if the commas are decimal commas, separate the columns with ; in every line</source>
        <translation>{expected}。カンマが小数点の場合は、すべての行で列を ; で区切ってください</translation>
    </message>
    <message>
        <source>{expected}; the header separates its columns with {separator}, so every line must</source>
        <translation>{expected}。ヘッダの列区切りは {separator} なので、全行で同じ区切りにしてください</translation>
    </message>
    <message>
        <source>{expected}; decimal commas need the separator ; in every line</source>
        <translation>{expected}。小数点にカンマを使う場合は、全行で区切り文字 ; が必要です</translation>
    </message>
    <message>
        <source>{count} as in the header (line {line})</source>
        <translation>ヘッダ (行 {line}) と同じ {count} 列</translation>
    </message>
    <message>
        <source>a closing &quot; in the same line</source>
        <translation>同じ行の閉じ引用符 &quot;</translation>
    </message>
    <message>
        <source>a separator after the closing &quot;</source>
        <translation>閉じ引用符 &quot; の後の区切り文字</translation>
    </message>
    <message>
        <source>a separator or the end of the line after the closing &quot;</source>
        <translation>閉じ引用符 &quot; の後の区切り文字または行末</translation>
    </message>
    <message>
        <source>a number such as {example}</source>
        <translation>{example} のような数値</translation>
    </message>
    <message>
        <source>a finite number such as {example}</source>
        <translation>{example} のような有限の数値</translation>
    </message>
    <message>
        <source>0 or a number that is not as close to it</source>
        <translation>0、またはこれほど 0 に近くない数値</translation>
    </message>
    <message>
        <source>a value that fits float32 (below 3.4e38)</source>
        <translation>float32 に収まる値 (3.4e38 未満)</translation>
    </message>
    <message>
        <source>a decimal comma as in line {line}</source>
        <translation>行 {line} と同じ小数点のカンマ</translation>
    </message>
    <message>
        <source>a decimal point as in line {line}</source>
        <translation>行 {line} と同じ小数点のピリオド</translation>
    </message>
    <message>
        <source>no sign between the thousands</source>
        <translation>桁区切り記号なし</translation>
    </message>
    <message>
        <source>more than {rows} data lines of {columns} columns</source>
        <translation>{columns} 列のデータが {rows} 行を超えている</translation>
    </message>
    <message>
        <source>at most {cells} cells (lines x columns)</source>
        <translation>{cells} セル以下 (行 x 列)</translation>
    </message>
    <message>
        <source>positions with a finite range</source>
        <translation>範囲が有限の位置</translation>
    </message>
    <message>
        <source>positions whose distance a double can hold</source>
        <translation>差を double で表せる位置</translation>
    </message>
    <message>
        <source>{position} (steps of {distance})</source>
        <translation>{position} (間隔 {distance})</translation>
    </message>
    <message>
        <source>{position} next to {before}</source>
        <translation>{before} に隣接する {position}</translation>
    </message>
    <message>
        <source>{position} on an even line in steps of {distance}</source>
        <translation>間隔 {distance} の等間隔線上の {position}</translation>
    </message>
    <message>
        <source>only {position}</source>
        <translation>{position} のみ</translation>
    </message>
    <message>
        <source>at least 2 different positions</source>
        <translation>異なる位置が 2 つ以上</translation>
    </message>
    <message>
        <source>{point} in line {first} and again in line {second}</source>
        <translation>{point} が行 {first} と行 {second} に重複</translation>
    </message>
    <message>
        <source>every position once</source>
        <translation>各位置は 1 回だけ</translation>
    </message>
    <message>
        <source>no line for {points} (missing: {missing} of {all} points)</source>
        <translation>{points} の行がない (全 {all} 点のうち {missing} 点が欠落)</translation>
    </message>
    <message>
        <source>{value} at every point of {table}</source>
        <translation>{table} の全点で {value}</translation>
    </message>
    <message>
        <source>values that differ</source>
        <translation>互いに異なる値</translation>
    </message>
    <message>
        <source>a change of {change}</source>
        <translation>{change} の変化</translation>
    </message>
    <message>
        <source>at most a millionth of the largest value, {value}</source>
        <translation>最大値 {value} の百万分の 1 以下</translation>
    </message>
    <message>
        <source>a step from {from} to {to} over {distance} in dimension {dimension}</source>
        <translation>次元 {dimension} で {distance} の間に {from} から {to} への段差</translation>
    </message>
    <message>
        <source>at most 0.01 per unit of position</source>
        <translation>位置 1 単位あたり 0.01 以下</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16 のテキスト</translation>
    </message>
    <message>
        <source>a spreadsheet workbook or ZIP archive</source>
        <translation>表計算のブックまたは ZIP アーカイブ</translation>
    </message>
    <message>
        <source>an old Excel workbook</source>
        <translation>旧形式の Excel ブック</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 文書</translation>
    </message>
    <message>
        <source>a compressed file (gzip)</source>
        <translation>圧縮ファイル (gzip)</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>a TAM table</source>
        <translation>TAM テーブル</translation>
    </message>
    <message>
        <source>a binary file</source>
        <translation>バイナリファイル</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>NUL バイト</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>テキストファイル</translation>
    </message>
    <message>
        <source>the byte 0x{byte} ({character})</source>
        <translation>バイト 0x{byte} ({character})</translation>
    </message>
    <message>
        <source>file length</source>
        <translation>ファイル長</translation>
    </message>
    <message>
        <source>element {number}</source>
        <translation>要素 {number}</translation>
    </message>
    <message>
        <source>{size} for the header and 4 for each of the {count} elements</source>
        <translation>ヘッダに {size}、{count} 個の要素に 4 ずつ</translation>
    </message>
    <message>
        <source>at least the {size} bytes of the header</source>
        <translation>ヘッダの {size} バイト以上</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 または 1</translation>
    </message>
    <message>
        <source>1, 2 or 3</source>
        <translation>1、2 または 3</translation>
    </message>
    <message>
        <source>2 or more</source>
        <translation>2 以上</translation>
    </message>
    <message>
        <source>1, because this dimension is not used</source>
        <translation>1 (この次元は使わないため)</translation>
    </message>
    <message>
        <source>{count}, the product of the sizes</source>
        <translation>{count} (各サイズの積)</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限の数値</translation>
    </message>
    <message>
        <source>a finite number above 0</source>
        <translation>0 より大きい有限の数値</translation>
    </message>
    <message>
        <source>one that leads to a finite last position</source>
        <translation>最終位置が有限になる値</translation>
    </message>
    <message>
        <source>one that tells positions such as {position} apart</source>
        <translation>{position} のような位置を区別できる値</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the header before it</source>
        <translation>{crc} (その前のヘッダの CRC)</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the elements</source>
        <translation>{crc} (要素の CRC)</translation>
    </message>
    <message>
        <source>the size of dimension {dimension} is {value}, at least 2 is needed</source>
        <translation>次元 {dimension} のサイズが {value} です。2 以上が必要です</translation>
    </message>
    <message>
        <source>the start value of dimension {dimension} is {value}, a finite number is needed</source>
        <translation>次元 {dimension} の開始値が {value} です。有限の数値が必要です</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, a finite number above 0 is needed</source>
        <translation>次元 {dimension} の間隔が {value} です。0 より大きい有限の数値が必要です</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, too little to tell positions such as {position} apart</source>
        <translation>次元 {dimension} の間隔が {value} です。小さすぎて {position} のような位置を区別できません</translation>
    </message>
    <message>
        <source>the last position of dimension {dimension} is too large to be a number</source>
        <translation>次元 {dimension} の最終位置が大きすぎて数値で表せません</translation>
    </message>
    <message>
        <source>the table has {count} dimensions, 1 to 3 are possible</source>
        <translation>テーブルの次元数が {count} です。1 から 3 までが可能です</translation>
    </message>
    <message>
        <source>the table has {count} values, which is not the product of its sizes</source>
        <translation>テーブルの値が {count} 個で、各サイズの積と一致しません</translation>
    </message>
    <message>
        <source>the table has more values than a file can count</source>
        <translation>テーブルの値が、ファイルで数えられる個数を超えています</translation>
    </message>
    <message>
        <source>value {number} is {value}, a finite number is needed</source>
        <translation>値 {number} が {value} です。有限の数値が必要です</translation>
    </message>
    <message>
        <source>the table cannot be kept in this drive&apos;s table file: {reason}</source>
        <translation>このテーブルは、このドライブのテーブルファイルに格納できません: {reason}</translation>
    </message>
    <message>
        <source>{value} does not fit into the field {field}, which is of type {type}</source>
        <translation>{value} は {type} 型のフィールド {field} に入りません</translation>
    </message>
    <message>
        <source>the grid of dimension {dimension}, start {start} and distance {distance}, cannot be held by fields of the types {first} and {second}</source>
        <translation>次元 {dimension} の格子 (開始 {start}、間隔 {distance}) は、{first} 型と {second} 型のフィールドでは表せません</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>ユーザが中止しました</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}</source>
        <translation>{file} を読み取れません: {reason}</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}</source>
        <translation>{file} に書き込めません: {reason}</translation>
    </message>
    <message>
        <source>{file} has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{file} は {size} バイトです。この種のファイルの上限は {limit} です</translation>
    </message>
    <message>
        <source>this is not a valid TAM table: {field} at offset {offset} is {found}, expected {expected}</source>
        <translation>有効な TAM テーブルではありません: オフセット {offset} の {field} が {found} です。必要: {expected}</translation>
    </message>
    <message>
        <source>the drive profile {file} is wrong at {path}: {reason}</source>
        <translation>ドライブプロファイル {file} の {path} に誤りがあります: {reason}</translation>
    </message>
    <message>
        <source>the TAM configuration {file} is wrong in line {line}: {reason}</source>
        <translation>TAM 構成 {file} の行 {line} に誤りがあります: {reason}</translation>
    </message>
    <message>
        <source>{file} is not a valid backup: {reason}</source>
        <translation>{file} は有効なバックアップではありません: {reason}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}</source>
        <translation>{file} の形式を判別できません。次のいずれかを指定してください: {known}</translation>
    </message>
    <message>
        <source>the name {file} says no format that can be written; name one with --to: {known}</source>
        <translation>{file} という名前からは書き込める形式を判別できません。--to で次のいずれかを指定してください: {known}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}; of any other CSV file, say which column is what</source>
        <translation>{file} の形式を判別できません。次のいずれかを指定してください: {known}。その他の CSV ファイルでは各列の内容を指定してください</translation>
    </message>
    <message>
        <source>there is no table {table} in the file; it has: {known}</source>
        <translation>ファイルにテーブル {table} はありません。含まれるテーブル: {known}</translation>
    </message>
    <message>
        <source>{endpoint} is not the address of a drive: {reason}</source>
        <translation>{endpoint} はドライブのアドレスではありません: {reason}</translation>
    </message>
    <message>
        <source>no connection to {endpoint}: {reason}</source>
        <translation>{endpoint} に接続できません: {reason}</translation>
    </message>
    <message>
        <source>the connection to {endpoint} was lost: {reason}</source>
        <translation>{endpoint} との接続が失われました: {reason}</translation>
    </message>
    <message>
        <source>{endpoint} did not answer within {seconds} s</source>
        <translation>{endpoint} は {seconds} s 以内に応答しませんでした</translation>
    </message>
    <message>
        <source>{endpoint} did not answer as a drive does: expected {expected}, got {quote}</source>
        <translation>{endpoint} の応答はドライブのものではありません。必要: {expected}、実際: {quote}</translation>
    </message>
    <message>
        <source>the drive refused: {reason}</source>
        <translation>ドライブが拒否しました: {reason}</translation>
    </message>
    <message>
        <source>the drive has no register {path}</source>
        <translation>ドライブにレジスタ {path} がありません</translation>
    </message>
    <message>
        <source>the drive has no file {path}</source>
        <translation>ドライブにファイル {path} がありません</translation>
    </message>
    <message>
        <source>the drive does not allow this now: {reason}</source>
        <translation>現在、ドライブはこの操作を許可していません: {reason}</translation>
    </message>
    <message>
        <source>the table does not fit: {reason}</source>
        <translation>テーブルが適合しません: {reason}</translation>
    </message>
    <message>
        <source>the drive refused the table: {reason}</source>
        <translation>ドライブがテーブルを拒否しました: {reason}</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s, or write volatile</source>
        <translation>短時間のフラッシュ操作が多すぎます。{seconds} s 待つか、揮発で書き込んでください</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is in error {error}: {hint}</source>
        <translation>軸 {axis} の補正がエラー {error} です: {hint}</translation>
    </message>
    <message>
        <source>the drive has no axis {axis}; it has: {known}</source>
        <translation>ドライブに軸 {axis} がありません。存在する軸: {known}</translation>
    </message>
    <message>
        <source>several axes are named {axis}: give the index, one of {matches}</source>
        <translation>{axis} という名前の軸が複数あります。{matches} のいずれかのインデックスで指定してください</translation>
    </message>
    <message>
        <source>axis {axis} of this drive has no compensation registers</source>
        <translation>このドライブの軸 {axis} には補正レジスタがありません</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} is missing</source>
        <translation>次元 {dimension} のソースがありません</translation>
    </message>
    <message>
        <source>the drive has no register {source}{nearest}</source>
        <translation>ドライブにレジスタ {source} がありません{nearest}</translation>
    </message>
    <message>
        <source>{source} is of type {type}; a dimension source must be one of {allowed}</source>
        <translation>{source} は {type} 型です。次元のソースは次のいずれかの型にしてください: {allowed}</translation>
    </message>
    <message>
        <source>{source} is a register of the drive {other}; a source must be on the drive itself, {drive}</source>
        <translation>{source} はドライブ {other} のレジスタです。ソースは、このドライブ {drive} のものにしてください</translation>
    </message>
    <message>
        <source>{source} is the source of both dimension {first} and dimension {second}</source>
        <translation>{source} が次元 {first} と次元 {second} の両方のソースになっています</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or correct the unit in the file</source>
        <translation>{doubt}別のソースまたは列を選ぶか、ファイルの単位を修正してください</translation>
    </message>
    <message>
        <source>the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds {largest}</source>
        <translation>テーブルには {size} バイト必要ですが、使用できる最大のスロット {slot} は {largest} です</translation>
    </message>
    <message>
        <source>the drive has no slot {slot}; it has: {known}</source>
        <translation>ドライブにスロット {slot} がありません。存在するスロット: {known}</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}</source>
        <translation>スロット {slot} は {user} が使用しています</translation>
    </message>
    <message>
        <source>no slot is free for a table of {size} bytes: {slots}; name one to overwrite it</source>
        <translation>{size} バイトのテーブルを入れる空きスロットがありません: {slots}。上書きするスロットを指定してください</translation>
    </message>
    <message>
        <source>axis {axis} has no table on the drive; write one first</source>
        <translation>ドライブに軸 {axis} のテーブルがありません。先に書き込んでください</translation>
    </message>
    <message>
        <source>axis {axis} already has all of this; there is nothing to write</source>
        <translation>軸 {axis} の内容はすでに同じです。書き込むものはありません</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is active; deactivate it first</source>
        <translation>軸 {axis} の補正が有効です。先に無効化してください</translation>
    </message>
    <message>
        <source>axis {axis} must be homed first</source>
        <translation>先に軸 {axis} を原点復帰させてください</translation>
    </message>
    <message>
        <source>this is another drive: expected serial number {expected}, found {found}</source>
        <translation>別のドライブです。必要なシリアル番号: {expected}、実際: {found}</translation>
    </message>
    <message>
        <source>somebody else changed {what} from {before} to {now}; nothing was written, look again</source>
        <translation>ほかから変更されました: {what} が {before} から {now} に。何も書き込んでいません。もう一度確認してください</translation>
    </message>
    <message>
        <source>{what} read back as {found}, but {expected} was written</source>
        <translation>{what}: 読み戻した値は {found} ですが、書き込んだ値は {expected} です</translation>
    </message>
    <message>
        <source>the drive does not add what it should: {what} at {position} is {found}, expected {expected}</source>
        <translation>ドライブの加算値が正しくありません: {position} での{what}が {found} です。期待値: {expected}</translation>
    </message>
    <message>
        <source>{reason}. The drive holds the complete old or the complete new state; ask for the status when it answers again. The old state is kept in {backup}</source>
        <translation>{reason}。ドライブは完全な旧状態か完全な新状態のどちらかです。応答が戻ったら状態を確認してください。旧状態は {backup} に保存されています</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis; restore it from {backup}</source>
        <translation>{reason}。旧状態への復帰も失敗しました ({rollback})。軸を有効化せず、{backup} から復元してください</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>存在しません</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>権限がありません</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>ディスクの空き容量がありません</translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation>ディスククォータを使い切っています</translation>
    </message>
    <message>
        <source>the file system is read-only</source>
        <translation>ファイルシステムが読み取り専用です</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>フォルダです</translation>
    </message>
    <message>
        <source>a part of the path is not a folder</source>
        <translation>パスの途中にフォルダでないものがあります</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>名前が長すぎます</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>シンボリックリンクが循環しています</translation>
    </message>
    <message>
        <source>it would be larger than a file may be here</source>
        <translation>ここで許されるファイルサイズを超えます</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>ディスクがエラーを報告しています</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>メモリが不足しています</translation>
    </message>
    <message>
        <source>the folder {folder} does not exist</source>
        <translation>フォルダ {folder} がありません</translation>
    </message>
    <message>
        <source>more than {size}</source>
        <translation>{size} を超える</translation>
    </message>
    <message>
        <source>another program is using it; try again when that one has finished</source>
        <translation>別のプログラムが使用中です。終了してからやり直してください</translation>
    </message>
    <message>
        <source>it cannot be locked: {reason}</source>
        <translation>ロックできません: {reason}</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>JSON ではありません</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>文書</translation>
    </message>
    <message>
        <source>line {line}, column {column}</source>
        <translation>行 {line}、列 {column}</translation>
    </message>
    <message>
        <source>{place}: {problem}</source>
        <translation>{place}: {problem}</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is there twice in one object</source>
        <translation>メンバ &quot;{name}&quot; が 1 つのオブジェクトに 2 回あります</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is not known</source>
        <translation>メンバ &quot;{name}&quot; は不明です</translation>
    </message>
    <message>
        <source>it has more than {count} values</source>
        <translation>値が {count} 個を超えています</translation>
    </message>
    <message>
        <source>it is nested deeper than {count} levels</source>
        <translation>入れ子が {count} 段を超えています</translation>
    </message>
    <message>
        <source>it has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{size} バイトです。この種のファイルの上限は {limit} です</translation>
    </message>
    <message>
        <source>an object is expected, not {found}</source>
        <translation>オブジェクトが必要ですが、{found} です</translation>
    </message>
    <message>
        <source>a list is expected, not {found}</source>
        <translation>リストが必要ですが、{found} です</translation>
    </message>
    <message>
        <source>a text is expected, not {found}</source>
        <translation>テキストが必要ですが、{found} です</translation>
    </message>
    <message>
        <source>true or false is expected, not {found}</source>
        <translation>true または false が必要ですが、{found} です</translation>
    </message>
    <message>
        <source>a number is expected, not {found}</source>
        <translation>数値が必要ですが、{found} です</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most} is expected, not {found}</source>
        <translation>{least} から {most} までの整数が必要ですが、{found} です</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>this is missing</source>
        <translation>欠落しています</translation>
    </message>
    <message>
        <source>this is not base64</source>
        <translation>base64 ではありません</translation>
    </message>
    <message>
        <source>this is too large for a Single</source>
        <translation>Single には大きすぎます</translation>
    </message>
    <message>
        <source>a number is expected, or NaN, Infinity, -Infinity as a text</source>
        <translation>数値、またはテキストの NaN、Infinity、-Infinity が必要です</translation>
    </message>
    <message>
        <source>the bytes have the CRC-32 {crc}, so they are damaged</source>
        <translation>バイト列の CRC-32 が {crc} で、破損しています</translation>
    </message>
    <message>
        <source>this file is there twice</source>
        <translation>このファイルが 2 回あります</translation>
    </message>
    <message>
        <source>this axis of the drive is there twice</source>
        <translation>ドライブのこの軸が 2 回あります</translation>
    </message>
    <message>
        <source>&quot;{format}&quot; is expected</source>
        <translation>&quot;{format}&quot; が必要です</translation>
    </message>
    <message>
        <source>only version {version} can be read; a newer version of this program may have written it</source>
        <translation>読み取れるのはバージョン {version} だけです。より新しいバージョンのプログラムで書かれた可能性があります</translation>
    </message>
    <message>
        <source>one of Boolean, Int32, UInt32, Single, Double, Enum is expected</source>
        <translation>Boolean、Int32、UInt32、Single、Double、Enum のいずれかが必要です</translation>
    </message>
    <message>
        <source>a time such as 2026-11-21T08:02:23Z is expected</source>
        <translation>2026-11-21T08:02:23Z のような日時が必要です</translation>
    </message>
    <message>
        <source>a CRC-32 of eight hexadecimal digits such as 1c291ca3 is expected</source>
        <translation>1c291ca3 のような 16 進 8 桁の CRC-32 が必要です</translation>
    </message>
    <message>
        <source>it was closed before the reply was complete</source>
        <translation>応答が完了する前に接続が閉じられました</translation>
    </message>
    <message>
        <source>nothing listens there; is the drive switched on, and is the address right?</source>
        <translation>そこでは何も応答しません。ドライブの電源は入っていて、アドレスは正しいですか？</translation>
    </message>
    <message>
        <source>the network does not know the name {name}</source>
        <translation>名前 {name} はネットワークにありません</translation>
    </message>
    <message>
        <source>there is no https; try http://, or another port</source>
        <translation>https がありません。http:// または別のポートを試してください</translation>
    </message>
    <message>
        <source>write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or demo:</source>
        <translation>http://host[:port]、https://host[:port]、serial:/dev/ttyUSB0 または demo: と入力してください</translation>
    </message>
    <message>
        <source>the host is missing; write http://192.168.1.20 or http://host:8080</source>
        <translation>ホストがありません。http://192.168.1.20 または http://host:8080 と入力してください</translation>
    </message>
    <message>
        <source>only host and port belong here, no path</source>
        <translation>ここに指定できるのはホストとポートだけです。パスは指定できません</translation>
    </message>
    <message>
        <source>port 0 cannot be reached</source>
        <translation>ポート 0 には接続できません</translation>
    </message>
    <message>
        <source>the device must be an absolute path such as serial:/dev/ttyUSB0</source>
        <translation>デバイスは serial:/dev/ttyUSB0 のような絶対パスで指定してください</translation>
    </message>
    <message>
        <source>the only option is baud, as in serial:/dev/ttyUSB0?baud=115200</source>
        <translation>指定できるオプションは serial:/dev/ttyUSB0?baud=115200 のような baud だけです</translation>
    </message>
    <message>
        <source>you have no permission to look into its folder</source>
        <translation>そのフォルダを見る権限がありません</translation>
    </message>
    <message>
        <source>the port cannot be used</source>
        <translation>ポートを使用できません</translation>
    </message>
    <message>
        <source>the serial port is gone; was the cable or the adapter unplugged?</source>
        <translation>シリアルポートがなくなりました。ケーブルまたはアダプタを抜きましたか？</translation>
    </message>
    <message>
        <source>another program is using the port; close it there</source>
        <translation>別のプログラムがポートを使用しています。そのプログラムでポートを閉じてください</translation>
    </message>
    <message>
        <source>this is no serial port ({reason})</source>
        <translation>シリアルポートではありません ({reason})</translation>
    </message>
    <message>
        <source>the port cannot do {speed} baud</source>
        <translation>ポートは {speed} ボーに対応していません</translation>
    </message>
    <message>
        <source>the reply of a drive at {speed} baud</source>
        <translation>{speed} ボーでのドライブの応答</translation>
    </message>
    <message>
        <source>name, serial number, axes and profile</source>
        <translation>名前、シリアル番号、軸、プロファイル</translation>
    </message>
    <message>
        <source>the number of lines that follow</source>
        <translation>後に続く行の数</translation>
    </message>
    <message>
        <source>the line garbles too much; check the cable, or try a lower baud rate</source>
        <translation>回線のデータ化けが多すぎます。ケーブルを確認するか、ボーレートを下げてください</translation>
    </message>
    <message>
        <source>the drive began anew</source>
        <translation>ドライブが最初からやり直しました</translation>
    </message>
    <message>
        <source>a size of at most {most} and a CRC</source>
        <translation>{most} 以下のサイズと CRC</translation>
    </message>
    <message>
        <source>a type and a value</source>
        <translation>型と値</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>how many registers there are</source>
        <translation>レジスタの数</translation>
    </message>
    <message>
        <source>path, address, type and value</source>
        <translation>パス、アドレス、型、値</translation>
    </message>
    <message>
        <source>the rest of the registers</source>
        <translation>残りのレジスタ</translation>
    </message>
    <message>
        <source>the serial link writes 1 to {most} registers at one instant, not {count}</source>
        <translation>シリアル接続で同時に書き込めるレジスタは 1 から {most} 個です。{count} 個は書き込めません</translation>
    </message>
    <message>
        <source>path, size and maximum size</source>
        <translation>パス、サイズ、最大サイズ</translation>
    </message>
    <message>
        <source>a redirect to {address}</source>
        <translation>{address} へのリダイレクト</translation>
    </message>
    <message>
        <source>a redirect to {address}; give its address with https://</source>
        <translation>{address} へのリダイレクト。https:// で始まるアドレスを指定してください</translation>
    </message>
    <message>
        <source>the answer itself</source>
        <translation>応答そのもの</translation>
    </message>
    <message>
        <source>success or a refusal</source>
        <translation>成功または拒否</translation>
    </message>
    <message>
        <source>HTTP status {status}</source>
        <translation>HTTP ステータス {status}</translation>
    </message>
    <message>
        <source>HTTP status {status}, {text}</source>
        <translation>HTTP ステータス {status}、{text}</translation>
    </message>
    <message>
        <source>HTTP status {status} and {text}</source>
        <translation>HTTP ステータス {status} と {text}</translation>
    </message>
    <message>
        <source>an HTTP reply</source>
        <translation>HTTP 応答</translation>
    </message>
    <message>
        <source>the status line of an HTTP reply</source>
        <translation>HTTP 応答のステータス行</translation>
    </message>
    <message>
        <source>a header field of an HTTP reply</source>
        <translation>HTTP 応答のヘッダフィールド</translation>
    </message>
    <message>
        <source>a head of at most 64 KiB</source>
        <translation>64 KiB 以下のヘッダ</translation>
    </message>
    <message>
        <source>one Content-Length</source>
        <translation>1 つの Content-Length</translation>
    </message>
    <message>
        <source>no Transfer-Encoding but chunked</source>
        <translation>Transfer-Encoding は chunked のみ</translation>
    </message>
    <message>
        <source>the size of a chunk</source>
        <translation>チャンクのサイズ</translation>
    </message>
    <message>
        <source>the end of a chunk</source>
        <translation>チャンクの終わり</translation>
    </message>
    <message>
        <source>at most {count} files</source>
        <translation>{count} 個以下のファイル</translation>
    </message>
    <message>
        <source>file paths without blanks</source>
        <translation>空白を含まないファイルパス</translation>
    </message>
    <message>
        <source>an actual size of {path} up to its maximum size</source>
        <translation>最大サイズ以下の {path} の実サイズ</translation>
    </message>
    <message>
        <source>the file {path} once</source>
        <translation>ファイル {path} は 1 回だけ</translation>
    </message>
    <message>
        <source>a file, its size and its maximum size in each row</source>
        <translation>各行にファイル、そのサイズ、最大サイズ</translation>
    </message>
    <message>
        <source>sizes in bytes</source>
        <translation>バイト単位のサイズ</translation>
    </message>
    <message>
        <source>a JSON array of files</source>
        <translation>ファイルの JSON 配列</translation>
    </message>
    <message>
        <source>a file with path, size and maximumSize</source>
        <translation>path、size、maximumSize をもつファイル</translation>
    </message>
    <message>
        <source>at least one file in the table</source>
        <translation>表に 1 つ以上のファイル</translation>
    </message>
    <message>
        <source>a Directory page with a table of File, actual size and maximum size</source>
        <translation>File、actual size、maximum size の表がある Directory ページ</translation>
    </message>
    <message>
        <source>a JSON array of registers</source>
        <translation>レジスタの JSON 配列</translation>
    </message>
    <message>
        <source>a register with path, address, type and a value of that type</source>
        <translation>path、address、type、その型の value をもつレジスタ</translation>
    </message>
    <message>
        <source>registers below {path}</source>
        <translation>{path} の下のレジスタ</translation>
    </message>
    <message>
        <source>at most 1024 axes</source>
        <translation>1024 軸以下</translation>
    </message>
    <message>
        <source>more</source>
        <translation>それ以上</translation>
    </message>
    <message>
        <source>status 204 without a body</source>
        <translation>本文なしのステータス 204</translation>
    </message>
    <message>
        <source>a file with its Content-Length</source>
        <translation>Content-Length 付きのファイル</translation>
    </message>
    <message>
        <source>the bytes of {path}</source>
        <translation>{path} のバイト列</translation>
    </message>
    <message>
        <source>a reply</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>flipped bytes</source>
        <translation>化けたバイト</translation>
    </message>
    <message>
        <source>the connection was cut</source>
        <translation>接続が切断されました</translation>
    </message>
    <message>
        <source>the drive rebooted</source>
        <translation>ドライブが再起動しました</translation>
    </message>
    <message>
        <source>a request reads at most {most} registers, not {count}</source>
        <translation>1 回の要求で読み取れるレジスタは {most} 個までです。{count} 個は読み取れません</translation>
    </message>
    <message>
        <source>a request writes 1 to {most} registers, not {count}</source>
        <translation>1 回の要求で書き込めるレジスタは 1 から {most} 個です。{count} 個は書き込めません</translation>
    </message>
    <message>
        <source>{path} is written twice in one request</source>
        <translation>1 回の要求で {path} に 2 回書き込んでいます</translation>
    </message>
    <message>
        <source>{path} is read-only</source>
        <translation>{path} は読み取り専用です</translation>
    </message>
    <message>
        <source>{path} is of type {type}, and cannot be {value}</source>
        <translation>{path} は {type} 型で、{value} にはできません</translation>
    </message>
    <message>
        <source>{path} is of type {type}, one of {names}, and cannot be {value}</source>
        <translation>{path} は {type} 型 ({names} のいずれか) で、{value} にはできません</translation>
    </message>
    <message>
        <source>the compensation of {axis} is on, so {what} must stay; deactivate it</source>
        <translation>{axis} の補正がオンのため変更できません: {what}。先に無効化してください</translation>
    </message>
    <message>
        <source>its homing</source>
        <translation>原点復帰の状態</translation>
    </message>
    <message>
        <source>the table in {slot}</source>
        <translation>{slot} のテーブル</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be persistent</source>
        <translation>{slot} には不揮発にできるテーブルがありません</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be committed</source>
        <translation>{slot} にはフラッシュに保存できるテーブルがありません</translation>
    </message>
    <message>
        <source>{path} can have {most} bytes, not {size}</source>
        <translation>{path} に入るのは {most} バイトまでです。{size} バイトは入りません</translation>
    </message>
    <message>
        <source>the drive&apos;s flash failed: {reason}</source>
        <translation>ドライブのフラッシュメモリで障害が発生しました: {reason}</translation>
    </message>
    <message>
        <source>the axis must be homed first</source>
        <translation>先に軸を原点復帰させてください</translation>
    </message>
    <message>
        <source>the axis has no table; write one first</source>
        <translation>軸にテーブルがありません。先に書き込んでください</translation>
    </message>
    <message>
        <source>the number of sources must equal the table&apos;s dimensions</source>
        <translation>ソースの数をテーブルの次元数と同じにしてください</translation>
    </message>
    <message>
        <source>a source is not a Single or Double register of this drive</source>
        <translation>ソースが、このドライブの Single または Double のレジスタではありません</translation>
    </message>
    <message>
        <source>the drive cannot use the table; write it again</source>
        <translation>ドライブがこのテーブルを使用できません。書き込み直してください</translation>
    </message>
    <message>
        <source>see the drive&apos;s manual</source>
        <translation>ドライブのマニュアルを参照してください</translation>
    </message>
    <message>
        <source>the drive has restarted, or somebody else has switched the compensation</source>
        <translation>ドライブが再起動したか、ほかから補正が切り替えられました</translation>
    </message>
    <message>
        <source>it did not become {state} in time</source>
        <translation>時間内に {state} になりませんでした</translation>
    </message>
    <message>
        <source>only an active or an evaluating compensation can be proved</source>
        <translation>検証できるのは、有効または試算中の補正だけです</translation>
    </message>
    <message>
        <source>No other slot is free: the table in {slot} is overwritten. A copy is kept in the backup.</source>
        <translation>ほかに空きスロットがありません。{slot} のテーブルを上書きします。コピーはバックアップに残ります。</translation>
    </message>
    <message>
        <source>What {slot} holds now is overwritten. A copy is kept in the backup.</source>
        <translation>{slot} の現在の内容を上書きします。コピーはバックアップに残ります。</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved, but the table of {axis} in {slot} is volatile: after a reboot that axis has no table.</source>
        <translation>全軸のパラメータを保存しますが、{slot} にある {axis} のテーブルは揮発です。再起動すると、その軸のテーブルはなくなります。</translation>
    </message>
    <message>
        <source>The new table is volatile and covers an older one that flash holds in {slot}: after a reboot the axis may have that one again, until the parameters are saved, which deletes it.</source>
        <translation>新しいテーブルは揮発で、{slot} のフラッシュにある以前のテーブルに重なります。パラメータを保存して以前のテーブルを削除するまでは、再起動すると軸がそのテーブルに戻ることがあります。</translation>
    </message>
    <message>
        <source>After a reboot the drive would look for another table in {slot}: the parameters are saved once before the new one goes into flash. When the write is interrupted then, the axis may have no table after a reboot.</source>
        <translation>再起動すると、ドライブは {slot} に別のテーブルを探します。そのため、新しいテーブルをフラッシュに書く前にパラメータを 1 回保存します。その時点で書き込みが中断すると、再起動後に軸のテーブルがなくなることがあります。</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: it is deleted before the parameters are saved.</source>
        <translation>{slot} のフラッシュに以前のテーブルが残っている可能性があります。パラメータを保存する前に削除します。</translation>
    </message>
    <message>
        <source>the settings of {axis}</source>
        <translation>{axis} の設定</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>軸 {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>軸 {axis} ({name})</translation>
    </message>
    <message>
        <source>axis {axis} after a reboot</source>
        <translation>再起動後の軸 {axis}</translation>
    </message>
    <message>
        <source>the cogging compensation of axis {axis}</source>
        <translation>軸 {axis} のコギング補正</translation>
    </message>
    <message>
        <source>{slot} holds only {size} bytes</source>
        <translation>{slot} の容量は {size} バイトしかありません</translation>
    </message>
    <message>
        <source>{slot} is used by {user}</source>
        <translation>{slot} は {user} が使用しています</translation>
    </message>
    <message>
        <source>{slot} holds a table that is not this axis&apos;s</source>
        <translation>{slot} にはこの軸のものでないテーブルがあります</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), persistent</source>
        <translation>{table} (CRC {crc})、不揮発</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), volatile</source>
        <translation>{table} (CRC {crc})、揮発</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, persistent</source>
        <translation>{table} (CRC {crc})、{sources}、不揮発</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, volatile</source>
        <translation>{table} (CRC {crc})、{sources}、揮発</translation>
    </message>
    <message>
        <source>{path} at offset {offset}</source>
        <translation>{path} のオフセット {offset}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>the output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>the index of dimension {dimension}</source>
        <translation>次元 {dimension} のインデックス</translation>
    </message>
    <message>
        <source>the dimensionality is 1, 2 or 3</source>
        <translation>次元数は 1、2、3 のいずれかです</translation>
    </message>
    <message>
        <source>; a URI is written tam://mc/&lt;drive&gt;/&lt;path&gt;</source>
        <translation>。URI は tam://mc/&lt;ドライブ&gt;/&lt;パス&gt; の形式です</translation>
    </message>
    <message>
        <source>; an address is written 0x and 1 to 8 hex digits</source>
        <translation>。アドレスは 0x に続く 1 から 8 桁の 16 進数です</translation>
    </message>
    <message>
        <source>: no register has this address</source>
        <translation>。このアドレスのレジスタはありません</translation>
    </message>
    <message>
        <source>; the nearest are {names}</source>
        <translation>。近い名前: {names}</translation>
    </message>
    <message>
        <source>there is no backup that differs from what the axis has now</source>
        <translation>軸の現在の状態と異なるバックアップがありません</translation>
    </message>
    <message>
        <source>the program is ending</source>
        <translation>プログラムを終了しています</translation>
    </message>
    <message>
        <source>the backup</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>axis {axis} has no Table register</source>
        <translation>軸 {axis} に Table レジスタがありません</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with {separator} instead of tabs</source>
        <translation>{expected}。列はタブではなく {separator} で区切ってください</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ; instead of tabs</source>
        <translation>{expected}。列はタブではなく , または ; で区切ってください</translation>
    </message>
    <message>
        <source>{path} of type Int32</source>
        <translation>Int32 型の {path}</translation>
    </message>
    <message>
        <source>the settings of axis {axis}</source>
        <translation>軸 {axis} の設定</translation>
    </message>
    <message>
        <source>the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is {fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has the same</source>
        <translation>{endpoint} の証明書を信頼できません: {reason}。SHA-256 フィンガープリントは {fingerprint} です。ドライブのものと同じなら、[接続] または --trust-certificate で信頼してください</translation>
    </message>
    <message>
        <source>it has CHANGED and is not the one that was trusted</source>
        <translation>変更されています。信頼した証明書ではありません</translation>
    </message>
    <message>
        <source>no write to axis {axis} is unfinished; there is nothing to finish or to undo</source>
        <translation>軸 {axis} に未完了の書き込みはありません。完了するものも取り消すものもありません</translation>
    </message>
    <message>
        <source>the new table of the unfinished write to axis {axis} was not kept on this computer: write it again, or undo the write</source>
        <translation>軸 {axis} の未完了の書き込みの新しいテーブルは、このコンピュータに残っていません。もう一度書き込むか、書き込みを取り消してください</translation>
    </message>
    <message>
        <source>slot {slot}</source>
        <translation>スロット {slot}</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent</source>
        <translation>{count} 値 (CRC {crc})、不揮発</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile</source>
        <translation>{count} 値 (CRC {crc})、揮発</translation>
    </message>
    <message>
        <source>empty, used by {user}</source>
        <translation>空、{user} が使用</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent, used by {user}</source>
        <translation>{count} 値 (CRC {crc})、不揮発、{user} が使用</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile, used by {user}</source>
        <translation>{count} 値 (CRC {crc})、揮発、{user} が使用</translation>
    </message>
    <message>
        <source>the unfinished write to axis {axis}</source>
        <translation>軸 {axis} の未完了の書き込み</translation>
    </message>
    <message>
        <source>the name of a file beside the journal is expected</source>
        <translation>ジャーナルと同じ場所にあるファイルの名前が必要です</translation>
    </message>
    <message>
        <source>it is not of axis {axis} of this drive</source>
        <translation>このドライブの軸 {axis} のものではありません</translation>
    </message>
    <message>
        <source>{file} can be one of several formats: {candidates}; say which one it is</source>
        <translation>{file} の形式の候補が複数あります: {candidates}。どれかを指定してください</translation>
    </message>
    <message>
        <source>the format {format} cannot hold this table: {reason}; {wayOut}</source>
        <translation>形式 {format} ではこのテーブルを保存できません: {reason}。{wayOut}</translation>
    </message>
    <message>
        <source>the sign cannot be converted at {position}: {reason}</source>
        <translation>{position} で符号を変換できません: {reason}</translation>
    </message>
    <message>
        <source>the table cannot be resampled: {reason}</source>
        <translation>テーブルを再サンプリングできません: {reason}</translation>
    </message>
    <message>
        <source>the numbers of the file are taken as they are</source>
        <translation>ファイルの数値をそのまま使います</translation>
    </message>
    <message>
        <source>sign: {from}; {example}</source>
        <translation>符号: {from}。{example}</translation>
    </message>
    <message>
        <source>{format} holds feedback values</source>
        <translation>{format} の値はフィードバック側 (feedback) です</translation>
    </message>
    <message>
        <source>{format} holds command values</source>
        <translation>{format} の値は指令側 (command) です</translation>
    </message>
    <message>
        <source>{format} holds feedback values, as you say</source>
        <translation>{format} の値は、指定によりフィードバック側 (feedback) です</translation>
    </message>
    <message>
        <source>{format} holds command values, as you say</source>
        <translation>{format} の値は、指定により指令側 (command) です</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}</source>
        <translation>{example}: feedback のファイルの値は {value}</translation>
    </message>
    <message>
        <source>{example}: the command file says {value}</source>
        <translation>{example}: command のファイルの値は {value}</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}, the command file {other}</source>
        <translation>{example}: feedback のファイルの値は {value}、command のファイルの値は {other}</translation>
    </message>
    <message>
        <source>all values are 0, in either sign</source>
        <translation>値はすべて 0 で、符号によらず同じです</translation>
    </message>
    <message>
        <source>moving in positive direction, {example}</source>
        <translation>正方向の運動では {example}</translation>
    </message>
    <message>
        <source>moving in negative direction, {example}</source>
        <translation>負方向の運動では {example}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference says {moved}</source>
        <translation>エンコーダが {place} のとき、基準は {moved}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} says {moved}</source>
        <translation>エンコーダが {place} のとき、{axis} の基準は {moved}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>エンコーダが {place} のとき、{axis} の基準はそのエンコーダより {offset} 大きい</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>エンコーダが {place} のとき、{axis} の基準はそのエンコーダより {offset} 小さい</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>各エンコーダが {place} のとき、{axis} の基準はそのエンコーダより {offset} 大きい</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>各エンコーダが {place} のとき、{axis} の基準はそのエンコーダより {offset} 小さい</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}, where the reference says {reference}</source>
        <translation>指令位置 {place} では、コントローラはエンコーダを {moved} へ動かし、そこで基準は {reference}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}, where the reference says {reference}</source>
        <translation>指令位置 {place} では、コントローラは {axis} のエンコーダを {moved} へ動かし、そこで基準は {reference}</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} above its encoder, the controller moves {target} by {value}</source>
        <translation>指令位置 {place} (そこで {axis} の基準はエンコーダより {offset} 大きい) では、コントローラは {target} を {value} 動かす</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} below its encoder, the controller moves {target} by {value}</source>
        <translation>指令位置 {place} (そこで {axis} の基準はエンコーダより {offset} 小さい) では、コントローラは {target} を {value} 動かす</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>対象軸</translation>
    </message>
    <message>
        <source>{axis} = {position}</source>
        <translation>{axis} = {position}</translation>
    </message>
    <message>
        <source>resampled from {before} points to {after} points: at the positions of the source it is off by at most {largest}, {rms} rms</source>
        <translation>{before} 点から {after} 点に再サンプリングしました。元の位置でのずれは最大 {largest}、rms {rms} です</translation>
    </message>
    <message>
        <source>the values of the file are rounded by up to {amount}</source>
        <translation>ファイルの値は最大 {amount} 丸められます</translation>
    </message>
    <message>
        <source>the positions of the file are rounded by up to {amount}</source>
        <translation>ファイルの位置は最大 {amount} 丸められます</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules: {difference}</source>
        <translation>{count} か所の位置で、それぞれのコントローラの規則により比較: {difference}</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules ({column}): {difference}</source>
        <translation>{count} か所の位置で、それぞれのコントローラの規則により比較 ({column}): {difference}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}</source>
        <translation>差は最大 {largest} ({place})</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, where both have values by at most {inside}</source>
        <translation>差は最大 {largest} ({place})、両方に値がある範囲では最大 {inside}</translation>
    </message>
    <message>
        <source>at the ends of the table the sign was converted with the end values held, where the controller of the source applies nothing</source>
        <translation>テーブルの両端では端点値を保持するものとして符号を変換しましたが、元のコントローラはそこでは補正しません</translation>
    </message>
    <message>
        <source>the {what} have no unit; they are taken to be {unit}</source>
        <translation>単位がありません: {what}。{unit} とみなします</translation>
    </message>
    <message>
        <source>the positions are in {unit}</source>
        <translation>位置の単位は {unit} です</translation>
    </message>
    <message>
        <source>the values are in {unit}</source>
        <translation>値の単位は {unit} です</translation>
    </message>
    <message>
        <source>positions and values are in {unit}</source>
        <translation>位置と値の単位は {unit} です</translation>
    </message>
    <message>
        <source>no known unit</source>
        <translation>不明な単位</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} behind it</source>
        <translation>{range}: 格子の終点は範囲を {distance} 越えた {end} です</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} before its end</source>
        <translation>{range}: 格子の終点は範囲の終わりの {distance} 手前の {end} です</translation>
    </message>
    <message>
        <source>the range of {axis} from {from} to {to} is no whole multiple of {distance}</source>
        <translation>{axis} の範囲 {from} から {to} は {distance} の整数倍ではありません</translation>
    </message>
    <message>
        <source>a number of points is a whole number, at least 2</source>
        <translation>点数は 2 以上の整数で指定してください</translation>
    </message>
    <message>
        <source>the number for the even grid is missing</source>
        <translation>等間隔格子の数値がありません</translation>
    </message>
    <message>
        <source>the even grid needs one number, or one for each of the {count} source axes</source>
        <translation>等間隔格子には数値を 1 つ、または {count} 本のソース軸それぞれに 1 つ指定してください</translation>
    </message>
    <message>
        <source>the format {format} can be written, not read</source>
        <translation>形式 {format} は書き込みだけで、読み取りはできません</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key} ({meaning})</source>
        <translation>形式 {format} には設定 {key} ({meaning}) が必要です</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected {expected} ({meaning})</source>
        <translation>設定 {key} が &quot;{value}&quot; です。必要: {expected} ({meaning})</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>one of {choices}</source>
        <translation>{choices} のいずれか</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes または no</translation>
    </message>
    <message>
        <source>the positions of source {number} are not evenly spaced</source>
        <translation>ソース {number} の位置が等間隔ではありません</translation>
    </message>
    <message>
        <source>resample it onto an even grid</source>
        <translation>等間隔格子に再サンプリングしてください</translation>
    </message>
    <message>
        <source>resample it onto a coarser grid</source>
        <translation>より粗い格子に再サンプリングしてください</translation>
    </message>
    <message>
        <source>it takes one distance for all sources, and these are different</source>
        <translation>全ソースで共通の間隔が必要ですが、間隔が異なります</translation>
    </message>
    <message>
        <source>resample it with the same distance for each source</source>
        <translation>各ソースを同じ間隔で再サンプリングしてください</translation>
    </message>
    <message>
        <source>it has one value for both directions of motion</source>
        <translation>両方の運動方向で共通の値しかもてません</translation>
    </message>
    <message>
        <source>choose the mean, the positive or the negative direction</source>
        <translation>平均、正方向、負方向のいずれかを選んでください</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>別の形式を選んでください</translation>
    </message>
    <message>
        <source>{count} points are more than the {limit} that the controller takes</source>
        <translation>{count} 点は、コントローラの上限 {limit} 点を超えています</translation>
    </message>
    <message>
        <source>it has no modulo axes</source>
        <translation>モジュロ軸に対応していません</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap, in a machine file no-wrap = true) when it stays within one revolution</source>
        <translation>軸が 1 回転以内で動く場合は、直進軸として扱ってください (--no-wrap、機械ファイルでは no-wrap = true)</translation>
    </message>
    <message>
        <source>its values are offsets of the command</source>
        <translation>値は指令位置に対するオフセットです</translation>
    </message>
    <message>
        <source>convert the sign</source>
        <translation>符号を変換してください</translation>
    </message>
    <message>
        <source>a value is beyond what a float32 can be</source>
        <translation>値が float32 の範囲を超えています</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>値の単位を確認してください</translation>
    </message>
    <message>
        <source>a grid along {axis} needs at least two points</source>
        <translation>{axis} の格子には 2 点以上必要です</translation>
    </message>
    <message>
        <source>the distance along {axis} must be a number above 0</source>
        <translation>{axis} の間隔は 0 より大きい数値にしてください</translation>
    </message>
    <message>
        <source>the positions of {axis} are not evenly spaced; give a number of points or a distance</source>
        <translation>{axis} の位置が等間隔ではありません。点数または間隔を指定してください</translation>
    </message>
    <message>
        <source>the full turn of {axis}, {turn}, is no whole multiple of {distance}; possible are {fewer} or {more}</source>
        <translation>{axis} の 1 回転 {turn} は {distance} の整数倍ではありません。可能な値は {fewer} または {more} です</translation>
    </message>
    <message>
        <source>a distance of {distance} is longer than the range of {axis} from {from} to {to}; take a shorter one, or let the end values be held</source>
        <translation>間隔 {distance} は {axis} の範囲 {from} から {to} より長くなっています。短くするか、端点値を保持する指定にしてください</translation>
    </message>
    <message>
        <source>the grid would have more than {count} points; take fewer along an axis</source>
        <translation>格子が {count} 点を超えます。軸の点数を減らしてください</translation>
    </message>
    <message>
        <source>calibration file: reference positions and compensation values</source>
        <translation>校正ファイル: 基準位置と補正値</translation>
    </message>
    <message>
        <source>table file of the drive, laid out as the drive profile says</source>
        <translation>ドライブのテーブルファイル (レイアウトはドライブプロファイルによる)</translation>
    </message>
    <message>
        <source>CSV file of positions and offsets</source>
        <translation>位置とオフセットの CSV ファイル</translation>
    </message>
    <message>
        <source>cross compensation in a compensation list (kw.crosscomp)</source>
        <translation>補正リストのクロス補正 (kw.crosscomp)</translation>
    </message>
    <message>
        <source>plane compensation in a compensation list (kw.crosscomp2)</source>
        <translation>補正リストの平面補正 (kw.crosscomp2)</translation>
    </message>
    <message>
        <source>leadscrew error compensation in a compensation list (kw.ssfk)</source>
        <translation>補正リストの送りねじピッチ誤差補正 (kw.ssfk)</translation>
    </message>
    <message>
        <source>compensation file of a joint: nominal forward reverse</source>
        <translation>ジョイントの補正ファイル: 呼び位置 往路 復路</translation>
    </message>
    <message>
        <source>CSV file of this program with the table of a compensator</source>
        <translation>補償器のテーブルを含む、このプログラムの CSV ファイル</translation>
    </message>
    <message>
        <source>C++ header with the table of a compensator</source>
        <translation>補償器のテーブルを含む C++ ヘッダ</translation>
    </message>
    <message>
        <source>sag and angularity compensation ($AN_CEC)</source>
        <translation>たわみ・角度誤差補正 ($AN_CEC)</translation>
    </message>
    <message>
        <source>encoder and leadscrew error compensation ($AA_ENC_COMP)</source>
        <translation>エンコーダ・送りねじ誤差補正 ($AA_ENC_COMP)</translation>
    </message>
    <message>
        <source>text table of positions and corrections</source>
        <translation>位置と補正量のテキスト表</translation>
    </message>
    <message>
        <source>MC-BASIC assignments to SourceData and TargetData</source>
        <translation>SourceData と TargetData への MC-BASIC の代入文</translation>
    </message>
    <message>
        <source>of a rotary axis: the range after which its position begins again, such as 360</source>
        <translation>回転軸の場合: 位置が最初に戻る範囲 (360 など)</translation>
    </message>
    <message>
        <source>logical number of the axis whose position counts, for master_ax_nr</source>
        <translation>位置を使う軸の論理番号 (master_ax_nr)</translation>
    </message>
    <message>
        <source>cycles over which switching is smoothed, for n_cycles</source>
        <translation>切り替えを滑らかにするサイクル数 (n_cycles)</translation>
    </message>
    <message>
        <source>the master is a modulo axis: the first and the last point are one place</source>
        <translation>マスタ軸がモジュロ軸で、最初と最後の点が同じ位置</translation>
    </message>
    <message>
        <source>whether the master axis is linear (mm) or rotary (deg)</source>
        <translation>マスタ軸が直進軸 (mm) か回転軸 (deg) か</translation>
    </message>
    <message>
        <source>whether the compensated axis is linear (mm) or rotary (deg)</source>
        <translation>補正する軸が直進軸 (mm) か回転軸 (deg) か</translation>
    </message>
    <message>
        <source>whether the axis is linear (mm) or rotary (deg)</source>
        <translation>軸が直進軸 (mm) か回転軸 (deg) か</translation>
    </message>
    <message>
        <source>metric: 0.1 um and 0.0001 deg; increments: of the encoder</source>
        <translation>metric: 0.1 um と 0.0001 deg、increments: エンコーダのインクリメント</translation>
    </message>
    <message>
        <source>encoder increments for one mm or degree, of a list in increments</source>
        <translation>1 mm または 1 度あたりのエンコーダのインクリメント数 (リストがインクリメント単位の場合)</translation>
    </message>
    <message>
        <source>write numbers with decimals, which only newer kernels take</source>
        <translation>数値を小数で書く (新しいカーネルだけが対応)</translation>
    </message>
    <message>
        <source>logical number of the axis that is compensated, for kopf.achs_nr</source>
        <translation>補正する軸の論理番号 (kopf.achs_nr)</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims; 0 is assumed</source>
        <translation>COMP_FILE_TYPE: 測定位置は 0、トリム値は 1。既定は 0</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims</source>
        <translation>COMP_FILE_TYPE: 測定位置は 0、トリム値は 1</translation>
    </message>
    <message>
        <source>raw counts of the output axis for one unit of the values</source>
        <translation>値 1 単位あたりの出力軸の生カウント数</translation>
    </message>
    <message>
        <source>the same, where the file does not say it</source>
        <translation>同上 (ファイルに記述がない場合)</translation>
    </message>
    <message>
        <source>unit of the positions, the user unit of the input axes</source>
        <translation>位置の単位 (入力軸のユーザ単位)</translation>
    </message>
    <message>
        <source>unit of the values, the user unit of the output axis; otherwise that of the positions</source>
        <translation>値の単位 (出力軸のユーザ単位)。省略時は位置の単位</translation>
    </message>
    <message>
        <source>namespace of the constants, a C++ name</source>
        <translation>定数の名前空間 (C++ の名前)</translation>
    </message>
    <message>
        <source>unit of the positions, where the file does not say it</source>
        <translation>位置の単位 (ファイルに記述がない場合)</translation>
    </message>
    <message>
        <source>unit of the values, where the file does not say it</source>
        <translation>値の単位 (ファイルに記述がない場合)</translation>
    </message>
    <message>
        <source>index of the first table that is written</source>
        <translation>最初に書くテーブルの番号</translation>
    </message>
    <message>
        <source>name of the axis whose position counts, instead of the table&apos;s name for it</source>
        <translation>位置を使う軸の名前 (テーブル内の名前の代わり)</translation>
    </message>
    <message>
        <source>name of the axis that is compensated, instead of the table&apos;s name for it</source>
        <translation>補正する軸の名前 (テーブル内の名前の代わり)</translation>
    </message>
    <message>
        <source>name of the machine axis, such as X1, instead of the table&apos;s name for it</source>
        <translation>X1 などの機械軸の名前 (テーブル内の名前の代わり)</translation>
    </message>
    <message>
        <source>measuring system of the axis, instead of that of the program that was read, or 0</source>
        <translation>軸の計測システム (読み込んだプログラムのものに代わる。なければ 0)</translation>
    </message>
    <message>
        <source>name of the compensation table in the MC-BASIC program</source>
        <translation>MC-BASIC プログラムでの補正テーブルの名前</translation>
    </message>
    <message>
        <source>the drive stores the table in its flash</source>
        <translation>ドライブがテーブルをフラッシュに保存</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: they are the same</source>
        <translation>両方の運動方向に共通の値 ({choice}): 両者は同じです</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: they are the same</source>
        <translation>{target} に、両方の運動方向で共通の値 ({choice}): 両者は同じです</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: half their difference is up to {loss}, at {place}</source>
        <translation>両方の運動方向に共通の値 ({choice}): 両者の差の半分は最大 {loss} ({place})</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: half their difference is up to {loss}, at {place}</source>
        <translation>{target} に、両方の運動方向で共通の値 ({choice}): 両者の差の半分は最大 {loss} ({place})</translation>
    </message>
    <message>
        <source>they do not differ</source>
        <translation>差はありません</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, and not at all where both have values</source>
        <translation>差は最大 {largest} ({place})、両方に値がある範囲では差なし</translation>
    </message>
    <message>
        <source>number of the axis, from 1, instead of the table&apos;s name for it</source>
        <translation>軸の番号 (1 から、テーブル内の名前の代わり)</translation>
    </message>
    <message>
        <source>calibration file of single axes (:START)</source>
        <translation>単軸の校正ファイル (:START)</translation>
    </message>
    <message>
        <source>calibration file of two axes (:START2D)</source>
        <translation>2 軸の校正ファイル (:START2D)</translation>
    </message>
    <message>
        <source>numbers of the axes for which METRIC means degrees, such as 4,5; all others mm</source>
        <translation>METRIC が度を表す軸の番号 (4,5 など)。ほかはすべて mm</translation>
    </message>
    <message>
        <source>what PRIMARY stands for, such as mm</source>
        <translation>PRIMARY が表す単位 (mm など)</translation>
    </message>
    <message>
        <source>METRIC (mm and degrees), or PRIMARY: the table&apos;s own units are those of the axes</source>
        <translation>METRIC (mm と度)、または PRIMARY: テーブル自身の単位を軸の単位とする</translation>
    </message>
    <message>
        <source>[bed_mesh NAME] sections of printer.cfg: heights of the bed</source>
        <translation>printer.cfg の [bed_mesh NAME] セクション: ベッドの高さ</translation>
    </message>
    <message>
        <source>heightmap.csv, version 2: heights of the bed</source>
        <translation>heightmap.csv、バージョン 2: ベッドの高さ</translation>
    </message>
    <message>
        <source>names of the axes in degrees, such as C,B; all others are in mm, and modulo axes in degrees anyway</source>
        <translation>度の軸の名前 (C,B など)。ほかはすべて mm、モジュロ軸は常に度</translation>
    </message>
    <message>
        <source>leadscrew compensation of one source (DEFINE COMP)</source>
        <translation>1 ソースの送りねじピッチ誤差補正 (DEFINE COMP)</translation>
    </message>
    <message>
        <source>compensation of a motor by two others (DEFINE COMP)</source>
        <translation>2 つのモータによる、別のモータの補正 (DEFINE COMP)</translation>
    </message>
    <message>
        <source>encoder counts for one unit, of every motor without a setting of its own</source>
        <translation>1 単位あたりのエンコーダカウント数 (個別の設定がないすべてのモータ)</translation>
    </message>
    <message>
        <source>encoder counts for one unit; without it tables are in counts</source>
        <translation>1 単位あたりのエンコーダカウント数。省略時、テーブルはカウント単位</translation>
    </message>
    <message>
        <source>position of the sources that counts: desired (written with D) or actual</source>
        <translation>使用するソースの位置: desired (指令位置、D 付きで記述) または actual (実位置)</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the positions</source>
        <translation>位置 1 単位あたりのエンコーダカウント数</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the values</source>
        <translation>値 1 単位あたりのエンコーダカウント数</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the row motor</source>
        <translation>行モータの 1 単位あたりのエンコーダカウント数</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the column motor</source>
        <translation>列モータの 1 単位あたりのエンコーダカウント数</translation>
    </message>
    <message>
        <source>number of the motor whose position counts, 1 to 32</source>
        <translation>位置を使うモータの番号 (1 から 32)</translation>
    </message>
    <message>
        <source>number of the motor that is compensated, 1 to 32</source>
        <translation>補正するモータの番号 (1 から 32)</translation>
    </message>
    <message>
        <source>number of the motor along a row of entries, 1 to 32</source>
        <translation>1 行の中のエントリに対応するモータの番号 (1 から 32)</translation>
    </message>
    <message>
        <source>number of the motor from row to row, 1 to 32</source>
        <translation>行の並びに対応するモータの番号 (1 から 32)</translation>
    </message>
    <message>
        <source>number of the axis that changes along a line, from 1</source>
        <translation>1 行の中で変わる軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>number of the axis that changes from line to line, from 1</source>
        <translation>行ごとに変わる軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>number of the axis of the first corrections, from 1</source>
        <translation>1 番目の補正量の軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>number of the axis of the second corrections, from 1</source>
        <translation>2 番目の補正量の軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>number of the axis of the third corrections, from 1</source>
        <translation>3 番目の補正量の軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>axis {axis} is named twice</source>
        <translation>軸 {axis} が 2 回指定されています</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s, or write volatile</source>
        <translation>残りのフラッシュ操作は変更には足りますが、失敗時にすべてを元に戻すには足りません。{seconds} s 待つか、揮発で書き込んでください</translation>
    </message>
    <message>
        <source>{axis} has fewer than two positions</source>
        <translation>{axis} の位置が 2 つ未満です</translation>
    </message>
    <message>
        <source>the positions of {axis} do not increase strictly</source>
        <translation>{axis} の位置が単調増加ではありません</translation>
    </message>
    <message>
        <source>the period of {axis}, {period}, is shorter than the range of its positions, {range}</source>
        <translation>{axis} の周期 {period} が、位置の範囲 {range} より短くなっています</translation>
    </message>
    <message>
        <source>a table has 1 to 3 source axes, this has {count}</source>
        <translation>テーブルのソース軸は 1 から 3 本ですが、{count} 本あります</translation>
    </message>
    <message>
        <source>the table has no values</source>
        <translation>テーブルに値がありません</translation>
    </message>
    <message>
        <source>{number} values for {column}, for {points} points</source>
        <translation>{column} の値が {number} 個、点数は {points} です</translation>
    </message>
    <message>
        <source>a value for {column} is not a finite number</source>
        <translation>{column} に有限でない数値があります</translation>
    </message>
    <message>
        <source>columns {first} and {second} both correct {axis} in the same direction; keep one of them</source>
        <translation>列 {first} と列 {second} が同じ方向で {axis} を補正します。どちらか一方を残してください</translation>
    </message>
    <message>
        <source>values for {column}</source>
        <translation>{column} の値</translation>
    </message>
    <message>
        <source>{column}, positive</source>
        <translation>{column}、正方向</translation>
    </message>
    <message>
        <source>{column}, negative</source>
        <translation>{column}、負方向</translation>
    </message>
    <message>
        <source>table {number} of {count}:</source>
        <translation>テーブル {number}/{count}:</translation>
    </message>
    <message>
        <source>the target without a name</source>
        <translation>名前のない対象軸</translation>
    </message>
    <message>
        <source>there are two columns for {target} in positive direction; keep one of them</source>
        <translation>{target} の正方向の列が 2 つあります。どちらか一方を残してください</translation>
    </message>
    <message>
        <source>there are two columns for {target} in negative direction; keep one of them</source>
        <translation>{target} の負方向の列が 2 つあります。どちらか一方を残してください</translation>
    </message>
    <message>
        <source>for {target} there are values for both directions and others for one; keep one of them</source>
        <translation>{target} に、両方向共通の値と片方向の値があります。どちらか一方を残してください</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no mean; choose the positive direction</source>
        <translation>{target} には正方向の値しかなく、平均を求められません。正方向を選んでください</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no negative one; choose the positive direction</source>
        <translation>{target} には正方向の値しかなく、負方向の値がありません。正方向を選んでください</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no mean; choose the negative direction</source>
        <translation>{target} には負方向の値しかなく、平均を求められません。負方向を選んでください</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no positive one; choose the negative direction</source>
        <translation>{target} には負方向の値しかなく、正方向の値がありません。負方向を選んでください</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with the correction {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap, in a machine file no-wrap = true)</source>
        <translation>{axis} の 1 回転の補正量が {begin} で始まり {end} で終わっています。両者を同じにするか、直進軸として扱ってください (--no-wrap、機械ファイルでは no-wrap = true)</translation>
    </message>
    <message>
        <source>the numbers are too large to be added to each other</source>
        <translation>数値が大きすぎて加算できません</translation>
    </message>
    <message>
        <source>from there to {place} the correction changes by {change}, so that positions would change their order; check the unit of the values</source>
        <translation>そこから {place} までに補正量が {change} 変化し、位置の順序が入れ替わります。値の単位を確認してください</translation>
    </message>
    <message>
        <source>the correction of {axis} changes by {change} for each unit of the way, too much for several axes that are corrected together; check the unit of the values</source>
        <translation>{axis} の補正量が移動 1 単位あたり {change} 変化します。同時に補正する複数の軸には大きすぎます。値の単位を確認してください</translation>
    </message>
    <message>
        <source>the corrections are so steep that {count} steps do not find the place that belongs to it; check the unit of the values</source>
        <translation>補正量が急すぎて、{count} 回の反復では対応する位置が求まりません。値の単位を確認してください</translation>
    </message>
    <message>
        <source>the second table has no column for {column}</source>
        <translation>2 番目のテーブルに {column} の列がありません</translation>
    </message>
    <message>
        <source>a table of {count} source axes cannot be compared with one of {other}</source>
        <translation>ソース軸 {count} 本のテーブルと {other} 本のテーブルは比較できません</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more than {count} points along {axis}; with {most} it is {found}; allow more points or a larger deviation</source>
        <translation>偏差 {deviation} には {axis} に {count} 点を超える点数が必要です。{most} 点での偏差は {found} です。点数または偏差の上限を大きくしてください</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; with {sizes} points it is {found}; allow more points or a larger deviation</source>
        <translation>偏差 {deviation} には許容を超える点数が必要です。{sizes} 点での偏差は {found} です。点数または偏差の上限を大きくしてください</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; it takes at least {sizes} points; allow more points or a larger deviation</source>
        <translation>偏差 {deviation} には許容を超える点数が必要です。少なくとも {sizes} 点必要です。点数または偏差の上限を大きくしてください</translation>
    </message>
    <message>
        <source>the wanted deviation must be a number of 0 or more</source>
        <translation>目標の偏差は 0 以上の数値にしてください</translation>
    </message>
    <message>
        <source>limits for {count} axes are given, the table has {axes}</source>
        <translation>上限が {count} 軸分指定されていますが、テーブルの軸は {axes} 本です</translation>
    </message>
    <message>
        <source>a grid has at least two points along each axis; allow as many</source>
        <translation>格子には各軸に 2 点以上必要です。上限をそれ以上にしてください</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap)</source>
        <translation>{axis} の 1 回転が {begin} で始まり {end} で終わっています。両者を同じにするか、直進軸として扱ってください (--no-wrap)</translation>
    </message>
    <message>
        <source>the values for {column} are too large to be interpolated</source>
        <translation>{column} の値が大きすぎて補間できません</translation>
    </message>
    <message>
        <source>grids for {count} axes are given, the table has {axes}</source>
        <translation>格子が {count} 軸分指定されていますが、テーブルの軸は {axes} 本です</translation>
    </message>
    <message>
        <source>the points along {axis} would be so close that positions cannot tell them apart; take fewer</source>
        <translation>{axis} の点が近すぎて、位置の数値で区別できません。点数を減らしてください</translation>
    </message>
    <message>
        <source>for {axis} both a number of points and a distance are given</source>
        <translation>{axis} に点数と間隔の両方が指定されています</translation>
    </message>
    <message>
        <source>the grid along {axis} must end above its start, not go from {from} to {to}</source>
        <translation>{axis} の格子の終点は始点より大きくしてください。{from} から {to} は指定できません</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than {most}</source>
        <translation>{axis} の {count} 点は、上限 {most} 点を超えています</translation>
    </message>
    <message>
        <source>for a part of {axis} a number of points or a distance is needed</source>
        <translation>{axis} の一部を使うには、点数または間隔が必要です</translation>
    </message>
    <message>
        <source>the grid along {axis} must be one full turn, from {from} to {to}</source>
        <translation>{axis} の格子は {from} から {to} までの 1 回転にしてください</translation>
    </message>
    <message>
        <source>the grid along {axis} begins at {from}, before the data at {data}; stay within the data, or let the end values be held</source>
        <translation>{axis} の格子が、データの始点 {data} より前の {from} から始まっています。データの範囲内にするか、端点値を保持する指定にしてください</translation>
    </message>
    <message>
        <source>the grid along {axis} ends at {to}, behind the data at {data}; stay within the data, or let the end values be held</source>
        <translation>{axis} の格子が、データの終点 {data} を越えた {to} で終わっています。データの範囲内にするか、端点値を保持する指定にしてください</translation>
    </message>
    <message>
        <source>a distance of {distance} along {axis} makes more than {count} points</source>
        <translation>{axis} の間隔 {distance} では {count} 点を超えます</translation>
    </message>
    <message>
        <source>the position {position} is the same as the one before when it is rounded</source>
        <translation>位置 {position} は、丸めると直前の位置と同じになります</translation>
    </message>
    <message>
        <source>the position {position} is beyond the 32 bits of its numbers</source>
        <translation>位置 {position} は 32 ビットの数値に収まりません</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 32 bits of its numbers</source>
        <translation>値 {value} は 32 ビットの数値に収まりません</translation>
    </message>
    <message>
        <source>master axis {number}</source>
        <translation>マスタ軸 {number}</translation>
    </message>
    <message>
        <source>ascending setpoints</source>
        <translation>昇順の設定位置</translation>
    </message>
    <message>
        <source>{number} at the end</source>
        <translation>終わりが {number}</translation>
    </message>
    <message>
        <source>{number}, as at the beginning</source>
        <translation>始めと同じ {number}</translation>
    </message>
    <message>
        <source>activate it in the axis list of axis {axis}: {parameter} 1</source>
        <translation>軸 {axis} の軸リストで有効化してください: {parameter} 1</translation>
    </message>
    <message>
        <source>QUADRATIC or RECTANGULAR</source>
        <translation>QUADRATIC または RECTANGULAR</translation>
    </message>
    <message>
        <source>different values at both ends</source>
        <translation>両端で異なる値</translation>
    </message>
    <message>
        <source>different values at both ends of master axis {number}</source>
        <translation>マスタ軸 {number} の両端で異なる値</translation>
    </message>
    <message>
        <source>the same values: a modulo axis is at the same place there</source>
        <translation>同じ値 (モジュロ軸では両端が同じ位置)</translation>
    </message>
    <message>
        <source>the same values, since modulo is 1</source>
        <translation>同じ値 (modulo が 1 のため)</translation>
    </message>
    <message>
        <source>the distance of {distance} along master {axis} is no whole number of {step}</source>
        <translation>マスタ軸 {axis} の間隔 {distance} は {step} の整数倍ではありません</translation>
    </message>
    <message>
        <source>resample it with such a distance</source>
        <translation>そのような間隔で再サンプリングしてください</translation>
    </message>
    <message>
        <source>it takes one distance for both sources, and these are different</source>
        <translation>両方のソースで共通の間隔が必要ですが、間隔が異なります</translation>
    </message>
    <message>
        <source>numbers of 0.1 um or 0.0001 deg</source>
        <translation>0.1 um または 0.0001 deg 単位の数値</translation>
    </message>
    <message>
        <source>increments for one mm or degree</source>
        <translation>1 mm または 1 度あたりのインクリメント数</translation>
    </message>
    <message>
        <source>the setting {key}, linear or rotary; linear is assumed, so that it is mm</source>
        <translation>設定 {key} (linear または rotary)。linear とみなし、mm とします</translation>
    </message>
    <message>
        <source>numbers in encoder increments</source>
        <translation>エンコーダのインクリメント単位の数値</translation>
    </message>
    <message>
        <source>the setting increments-per-unit, where millimetres or degrees matter</source>
        <translation>設定 increments-per-unit (mm または度が必要な場合)</translation>
    </message>
    <message>
        <source>the setting increments-per-unit is not above 0</source>
        <translation>設定 increments-per-unit が 0 以下です</translation>
    </message>
    <message>
        <source>numbers in mm or degrees become increments only with the setting increments-per-unit</source>
        <translation>mm または度の数値をインクリメントにするには、設定 increments-per-unit が必要です</translation>
    </message>
    <message>
        <source>an index from 0 such as [3], at most two of them</source>
        <translation>[3] のような 0 からのインデックス (2 つまで)</translation>
    </message>
    <message>
        <source>nothing after End</source>
        <translation>End の後には何もなし</translation>
    </message>
    <message>
        <source>a value behind the name and a blank</source>
        <translation>名前と空白の後に値</translation>
    </message>
    <message>
        <source>the entry {name}, which is missing</source>
        <translation>エントリ {name} (欠落)</translation>
    </message>
    <message>
        <source>a whole number, {range}</source>
        <translation>整数、{range}</translation>
    </message>
    <message>
        <source>no entry {name}</source>
        <translation>エントリ {name} なし</translation>
    </message>
    <message>
        <source>0 or 1; 0 is assumed</source>
        <translation>0 または 1。0 とみなします</translation>
    </message>
    <message>
        <source>0 or 1; 1 is assumed</source>
        <translation>0 または 1。1 とみなします</translation>
    </message>
    <message>
        <source>the logical number of the axis, from 1</source>
        <translation>軸の論理番号 (1 から)</translation>
    </message>
    <message>
        <source>at most {number}, which is {name}</source>
        <translation>{number} ({name}) 以下</translation>
    </message>
    <message>
        <source>at most {number}, which is the standard value of {name}</source>
        <translation>{number} ({name} の標準値) 以下</translation>
    </message>
    <message>
        <source>indices within the size that the list says</source>
        <translation>リストが示すサイズに収まるインデックス</translation>
    </message>
    <message>
        <source>{number} of them; there are {number2}</source>
        <translation>{number} 個 (実際は {number2} 個)</translation>
    </message>
    <message>
        <source>0, or a distance above 0</source>
        <translation>0、または 0 より大きい間隔</translation>
    </message>
    <message>
        <source>{entry} and setpoints of each point</source>
        <translation>{entry} と各点の設定位置</translation>
    </message>
    <message>
        <source>an interval of 0 with setpoints, or an interval without</source>
        <translation>設定位置があるのに間隔が 0、または設定位置がないのに間隔がある</translation>
    </message>
    <message>
        <source>values neg without bilateral 1</source>
        <translation>bilateral 1 でないのに neg の値</translation>
    </message>
    <message>
        <source>values pos only; neg is left out</source>
        <translation>pos の値のみ。neg は無視します</translation>
    </message>
    <message>
        <source>the index of a table, 0 to {number}</source>
        <translation>テーブルのインデックス (0 から {number})</translation>
    </message>
    <message>
        <source>each variable once</source>
        <translation>各変数は 1 回だけ</translation>
    </message>
    <message>
        <source>each variable once; the first is in line {line}</source>
        <translation>各変数は 1 回だけ。最初のものは行 {line} にあります</translation>
    </message>
    <message>
        <source>tables {name} besides {other}</source>
        <translation>{other} と並ぶテーブル {name}</translation>
    </message>
    <message>
        <source>one index: [table]</source>
        <translation>インデックス 1 つ: [テーブル]</translation>
    </message>
    <message>
        <source>two indices: [table,point]</source>
        <translation>インデックス 2 つ: [テーブル,点]</translation>
    </message>
    <message>
        <source>two indices: [encoder,axis]</source>
        <translation>インデックス 2 つ: [エンコーダ,軸]</translation>
    </message>
    <message>
        <source>three indices: [encoder,point,axis]</source>
        <translation>インデックス 3 つ: [エンコーダ,点,軸]</translation>
    </message>
    <message>
        <source>0, 1 or -1</source>
        <translation>0、1 または -1</translation>
    </message>
    <message>
        <source>{variable} of {curve}, which is missing</source>
        <translation>{curve} の {variable} (欠落)</translation>
    </message>
    <message>
        <source>a product with another table</source>
        <translation>別のテーブルとの積</translation>
    </message>
    <message>
        <source>a table by itself; the product is left out</source>
        <translation>単独のテーブル。積は無視します</translation>
    </message>
    <message>
        <source>variables {name}, of which there are none</source>
        <translation>変数 {name} (1 つもない)</translation>
    </message>
    <message>
        <source>there is no table {number}</source>
        <translation>テーブル {number} はありません</translation>
    </message>
    <message>
        <source>choose fewer tables, or another first-table</source>
        <translation>テーブルを減らすか、別の first-table を選んでください</translation>
    </message>
    <message>
        <source>the measuring system, 0 or 1</source>
        <translation>測定系 0 または 1</translation>
    </message>
    <message>
        <source>measuring system {number} of axis {axis}</source>
        <translation>軸 {axis} の測定系 {number}</translation>
    </message>
    <message>
        <source>0 or 1, and the name of an axis, at most {number} of them</source>
        <translation>0 または 1 と軸の名前 (テーブルは {number} 個以下)</translation>
    </message>
    <message>
        <source>axis {axis}, encoder {number}</source>
        <translation>軸 {axis}、エンコーダ {number}</translation>
    </message>
    <message>
        <source>its positions and values are not both lengths or both angles</source>
        <translation>位置と値が、両方とも長さまたは両方とも角度になっていません</translation>
    </message>
    <message>
        <source>axis {axis} needs $MA_MM_ENC_COMP_MAX_POINTS (MD38000) of at least {count}; load the file with $MA_ENC_COMP_ENABLE (MD32700) 0, then set it to 1</source>
        <translation>軸 {axis} の $MA_MM_ENC_COMP_MAX_POINTS (MD38000) は {count} 以上必要です。$MA_ENC_COMP_ENABLE (MD32700) を 0 にしてファイルを読み込み、その後 1 にしてください</translation>
    </message>
    <message>
        <source>an index in [ ] behind the name</source>
        <translation>名前の後の [ ] で囲んだインデックス</translation>
    </message>
    <message>
        <source>an index that ends in ]</source>
        <translation>] で終わるインデックス</translation>
    </message>
    <message>
        <source>= and a value behind the index</source>
        <translation>インデックスの後の = と値</translation>
    </message>
    <message>
        <source>a value behind =</source>
        <translation>= の後の値</translation>
    </message>
    <message>
        <source>nothing behind the end of the program, M17</source>
        <translation>プログラムの終わり M17 の後には何もなし</translation>
    </message>
    <message>
        <source>an assignment such as $NAME[0,1]=0.5, CHANDATA(1) or M17</source>
        <translation>$NAME[0,1]=0.5、CHANDATA(1)、M17 のような文</translation>
    </message>
    <message>
        <source>{variable} of {curve} a second time</source>
        <translation>{curve} の {variable} が 2 回目</translation>
    </message>
    <message>
        <source>the number of a point, from 0</source>
        <translation>点の番号 (0 から)</translation>
    </message>
    <message>
        <source>a compensation value</source>
        <translation>補正値</translation>
    </message>
    <message>
        <source>MIN {min}, MAX {max} and STEP {step} of {curve}</source>
        <translation>{curve} の MIN {min}、MAX {max}、STEP {step}</translation>
    </message>
    <message>
        <source>a STEP above 0 and a MAX above MIN</source>
        <translation>0 より大きい STEP と、MIN より大きい MAX</translation>
    </message>
    <message>
        <source>a whole number of steps from MIN to MAX</source>
        <translation>MIN から MAX までの整数ステップ</translation>
    </message>
    <message>
        <source>point {number} of {curve}</source>
        <translation>{curve} の点 {number}</translation>
    </message>
    <message>
        <source>point {number} of {curve} a second time</source>
        <translation>{curve} の点 {number} が 2 回目</translation>
    </message>
    <message>
        <source>points up to {number}, which MIN, MAX and STEP give</source>
        <translation>MIN、MAX、STEP で決まる {number} までの点</translation>
    </message>
    <message>
        <source>no point {number} of {curve}</source>
        <translation>{curve} の点 {number} なし</translation>
    </message>
    <message>
        <source>{number} points, which MIN, MAX and STEP give; there are {number2}</source>
        <translation>MIN、MAX、STEP で決まる {number} 点 (実際は {number2} 点)</translation>
    </message>
    <message>
        <source>{number} at MAX of {curve}</source>
        <translation>{curve} の MAX で {number}</translation>
    </message>
    <message>
        <source>{number}, as at MIN, which follows it</source>
        <translation>MIN (MAX の次の点) と同じ {number}</translation>
    </message>
    <message>
        <source>&quot;{axis}&quot; is no axis name for the format {format}, such as X1; give the setting {key}</source>
        <translation>&quot;{axis}&quot; は形式 {format} の軸名 (X1 など) ではありません。設定 {key} を指定してください</translation>
    </message>
    <message>
        <source>three numbers: nominal forward reverse; the controller stops reading here without a message</source>
        <translation>3 つの数値: nominal forward reverse。コントローラはメッセージを出さずにここで読み取りをやめます</translation>
    </message>
    <message>
        <source>{text} after three numbers</source>
        <translation>3 つの数値の後に {text}</translation>
    </message>
    <message>
        <source>nothing; it is left out, as the controller does</source>
        <translation>何もなし。コントローラと同様に無視します</translation>
    </message>
    <message>
        <source>at most 256; the controller leaves out the others</source>
        <translation>256 以下。コントローラはそれを超えるものを無視します</translation>
    </message>
    <message>
        <source>a measured position that does not increase</source>
        <translation>増加していない測定位置</translation>
    </message>
    <message>
        <source>increasing ones; if these are trims, the setting type=1</source>
        <translation>増加する位置。トリム値の場合は設定 type=1</translation>
    </message>
    <message>
        <source>measured positions (COMP_FILE_TYPE 0)</source>
        <translation>測定位置 (COMP_FILE_TYPE 0)</translation>
    </message>
    <message>
        <source>the setting type=0, or type=1 if these are trims</source>
        <translation>設定 type=0、またはトリム値の場合は type=1</translation>
    </message>
    <message>
        <source>increasing ones; perhaps these are trims (type=1)</source>
        <translation>増加する位置。トリム値かもしれません (type=1)</translation>
    </message>
    <message>
        <source>trims that change by {change}</source>
        <translation>{change} 変化するトリム値</translation>
    </message>
    <message>
        <source>less than the positions do; perhaps these are measured positions (type=0)</source>
        <translation>位置の変化より小さい変化。測定位置かもしれません (type=0)</translation>
    </message>
    <message>
        <source>a measured position at {position} is beyond what a number can be</source>
        <translation>{position} の測定位置が数値の範囲を超えています</translation>
    </message>
    <message>
        <source>check the unit of positions and values</source>
        <translation>位置と値の単位を確認してください</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = {file} and COMP_FILE_TYPE = {type}</source>
        <translation>INI ファイルの [JOINT_n] セクション: COMP_FILE = {file}、COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = the file and COMP_FILE_TYPE = {type}</source>
        <translation>INI ファイルの [JOINT_n] セクション: COMP_FILE = このファイル、COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>BACKLASH of the joint is not used any more</source>
        <translation>ジョイントの BACKLASH は使われなくなります</translation>
    </message>
    <message>
        <source>a second section for the profile {name}</source>
        <translation>プロファイル {name} の 2 つ目のセクション</translation>
    </message>
    <message>
        <source>each profile once</source>
        <translation>各プロファイルは 1 回だけ</translation>
    </message>
    <message>
        <source>an entry such as min_x = 10</source>
        <translation>min_x = 10 のようなエントリ</translation>
    </message>
    <message>
        <source>each entry once in a section</source>
        <translation>各エントリはセクション内で 1 回だけ</translation>
    </message>
    <message>
        <source>an entry {key} in this section</source>
        <translation>このセクションのエントリ {key}</translation>
    </message>
    <message>
        <source>version {version}</source>
        <translation>バージョン {version}</translation>
    </message>
    <message>
        <source>1; the firmware does not use other versions</source>
        <translation>1。ファームウェアはほかのバージョンを使いません</translation>
    </message>
    <message>
        <source>a height in mm</source>
        <translation>mm 単位の高さ</translation>
    </message>
    <message>
        <source>a position in mm</source>
        <translation>mm 単位の位置</translation>
    </message>
    <message>
        <source>an offset in mm</source>
        <translation>mm 単位のオフセット</translation>
    </message>
    <message>
        <source>a maximum above the minimum</source>
        <translation>最小値より大きい最大値</translation>
    </message>
    <message>
        <source>a section [bed_mesh NAME] with the points of a mesh</source>
        <translation>メッシュの点を含む [bed_mesh NAME] セクション</translation>
    </message>
    <message>
        <source>{axis} from {number} to {number2} by {number3} in {number4} points</source>
        <translation>{axis}: {number} から {number2} まで {number3} 間隔の {number4} 点</translation>
    </message>
    <message>
        <source>at least 2 along each axis</source>
        <translation>各軸に 2 以上</translation>
    </message>
    <message>
        <source>as many points as lie between minimum and maximum</source>
        <translation>最小値と最大値の間にある点の数</translation>
    </message>
    <message>
        <source>the axes &quot;{first}&quot; and &quot;{second}&quot;</source>
        <translation>軸 &quot;{first}&quot; と &quot;{second}&quot;</translation>
    </message>
    <message>
        <source>two different letters</source>
        <translation>異なる 2 文字</translation>
    </message>
    <message>
        <source>a point that was not probed at {position}, {other}</source>
        <translation>{position}、{other} に未測定の点</translation>
    </message>
    <message>
        <source>a further line after {number}</source>
        <translation>{number} の後の余分な行</translation>
    </message>
    <message>
        <source>{number} lines of heights</source>
        <translation>高さの {number} 行</translation>
    </message>
    <message>
        <source>the line {line}</source>
        <translation>行 {line}</translation>
    </message>
    <message>
        <source>the line {line}, or {other}</source>
        <translation>行 {line} または {other}</translation>
    </message>
    <message>
        <source>the number of one axis, from 1, behind :START</source>
        <translation>:START の後に 1 つの軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>SAMPLEDIST= and the distance of the corrections, which is not 0</source>
        <translation>SAMPLEDIST= と、0 以外の補正間隔</translation>
    </message>
    <message>
        <source>choose a table of an axis for itself</source>
        <translation>1 軸を単独で補正するテーブルを選んでください</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}, and the controller adds their corrections</source>
        <translation>軸 {axis} のテーブルが 2 つあり、コントローラは両方の補正量を加算します</translation>
    </message>
    <message>
        <source>the number of an axis, from 1</source>
        <translation>軸の番号 (1 から)</translation>
    </message>
    <message>
        <source>7 numbers behind :START2D: row axis, column axis, two output axes, distance along rows, distance along columns, number of columns</source>
        <translation>:START2D の後に 7 つの数値: 行軸、列軸、出力軸 2 つ、行の間隔、列の間隔、列数</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>the number of columns</source>
        <translation>列数</translation>
    </message>
    <message>
        <source>a distance of 0</source>
        <translation>間隔 0</translation>
    </message>
    <message>
        <source>a distance that is not 0</source>
        <translation>0 以外の間隔</translation>
    </message>
    <message>
        <source>axis {number} for rows and columns</source>
        <translation>行と列の両方に軸 {number}</translation>
    </message>
    <message>
        <source>two axes</source>
        <translation>2 つの軸</translation>
    </message>
    <message>
        <source>{number} points of {number2} corrections each in a row</source>
        <translation>1 行に、補正量 {number2} 個ずつの点が {number} 個</translation>
    </message>
    <message>
        <source>KEY=VALUE</source>
        <translation>キー=値</translation>
    </message>
    <message>
        <source>:END of the table that begins in line {line}</source>
        <translation>行 {line} で始まるテーブルの :END</translation>
    </message>
    <message>
        <source>{directive} before :END</source>
        <translation>:END の前の {directive}</translation>
    </message>
    <message>
        <source>a table that begins with {directive}</source>
        <translation>{directive} で始まるテーブル</translation>
    </message>
    <message>
        <source>a table that begins with {directive} and ends with :END</source>
        <translation>{directive} で始まり :END で終わるテーブル</translation>
    </message>
    <message>
        <source>{directive} or :END; tables of one and of two dimensions are in separate files</source>
        <translation>{directive} または :END。1 次元と 2 次元のテーブルは別のファイルにします</translation>
    </message>
    <message>
        <source>each option once</source>
        <translation>各オプションは 1 回だけ</translation>
    </message>
    <message>
        <source>{key}= and a number</source>
        <translation>{key}= と数値</translation>
    </message>
    <message>
        <source>positions in the coordinates of the axis after homing; it is left out</source>
        <translation>原点復帰後の軸座標での位置。このオプションは無視します</translation>
    </message>
    <message>
        <source>a table without {key}</source>
        <translation>{key} のないテーブル</translation>
    </message>
    <message>
        <source>{key}=METRIC, ENGLISH, PRIMARY, SECONDARY or COUNTS, perhaps divided by a number as in METRIC/1000</source>
        <translation>{key}=METRIC、ENGLISH、PRIMARY、SECONDARY または COUNTS。METRIC/1000 のように数値で割ることもできます</translation>
    </message>
    <message>
        <source>a correction that is too large for its unit</source>
        <translation>単位に対して大きすぎる補正量</translation>
    </message>
    <message>
        <source>another CORUNIT</source>
        <translation>別の CORUNIT</translation>
    </message>
    <message>
        <source>two numbers such as 0.25,0.001: position and offset</source>
        <translation>0.25,0.001 のような 2 つの数値: 位置とオフセット</translation>
    </message>
    <message>
        <source>a position such as 0.25</source>
        <translation>0.25 のような位置</translation>
    </message>
    <message>
        <source>an offset such as 0.001</source>
        <translation>0.001 のようなオフセット</translation>
    </message>
    <message>
        <source>lines of {expected}</source>
        <translation>{expected} の行</translation>
    </message>
    <message>
        <source>&quot;{line}&quot;, which is taken to be a header</source>
        <translation>&quot;{line}&quot; (ヘッダとみなします)</translation>
    </message>
    <message>
        <source>{expected}, if it is a point</source>
        <translation>点の場合は {expected}</translation>
    </message>
    <message>
        <source>position + offset {number} after {number2}</source>
        <translation>{number2} の後の位置 + オフセット {number}</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 点</translation>
    </message>
    <message>
        <source>strictly decreasing positions</source>
        <translation>単調減少する位置</translation>
    </message>
    <message>
        <source>strictly increasing positions</source>
        <translation>単調増加する位置</translation>
    </message>
    <message>
        <source>strictly decreasing values, as the positions are</source>
        <translation>位置と同じく単調減少する値</translation>
    </message>
    <message>
        <source>strictly increasing values, as the positions are</source>
        <translation>位置と同じく単調増加する値</translation>
    </message>
    <message>
        <source>positions from {first} to {last}</source>
        <translation>{first} から {last} までの位置</translation>
    </message>
    <message>
        <source>a span of exactly {range}, the wrap range</source>
        <translation>1 周の範囲と同じ、ちょうど {range} の幅</translation>
    </message>
    <message>
        <source>the offsets {first} and {last} at the ends</source>
        <translation>両端のオフセット {first} と {last}</translation>
    </message>
    <message>
        <source>the same offset at both ends, which are one place</source>
        <translation>両端で同じオフセット (両端は同じ位置)</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, expected more than 0</source>
        <translation>設定 wrap-range が {value} です。0 より大きい値が必要です</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, and the table repeats after {period}</source>
        <translation>設定 wrap-range が {value} ですが、テーブルは {period} で繰り返します</translation>
    </message>
    <message>
        <source>at {position} position + offset {sum} after {before} does not increase (error 4900 of the controller)</source>
        <translation>{position} で位置 + オフセットが増加していません: {before} の次が {sum} (コントローラのエラー 4900)</translation>
    </message>
    <message>
        <source>check the unit of the values, or smooth them</source>
        <translation>値の単位を確認するか、値を平滑化してください</translation>
    </message>
    <message>
        <source>of a rotary axis it wants {expected}, and this table has {found} (error 4902 of the controller)</source>
        <translation>回転軸では{expected}が必要ですが、このテーブルは{found}です (コントローラのエラー 4902)</translation>
    </message>
    <message>
        <source>add the point that closes the revolution</source>
        <translation>1 回転を閉じる点を追加してください</translation>
    </message>
    <message>
        <source>the controller looks for the file as {name}PosComp.CSV, unless axis.xml names another one</source>
        <translation>axis.xml で別のファイルを指定しない限り、コントローラは {name}PosComp.CSV を使います</translation>
    </message>
    <message>
        <source>the controller looks for the file as the name of the axis and PosComp.CSV, unless axis.xml names another one</source>
        <translation>axis.xml で別のファイルを指定しない限り、コントローラは軸名 + PosComp.CSV のファイルを使います</translation>
    </message>
    <message>
        <source>motor {number}</source>
        <translation>モータ {number}</translation>
    </message>
    <message>
        <source>a number of entries</source>
        <translation>エントリ数</translation>
    </message>
    <message>
        <source>the number of a motor, #1 to #32, perhaps with a D</source>
        <translation>モータの番号 #1 から #32 (D を付けてもよい)</translation>
    </message>
    <message>
        <source>DEFINE COMP entries,#source,#target,span</source>
        <translation>DEFINE COMP エントリ数,#ソース,#対象,スパン</translation>
    </message>
    <message>
        <source>DEFINE COMP rows.columns,#row,#column,#target,span,span</source>
        <translation>DEFINE COMP 行数.列数,#行,#列,#対象,スパン,スパン</translation>
    </message>
    <message>
        <source>a span in counts</source>
        <translation>カウント単位のスパン</translation>
    </message>
    <message>
        <source>a span of {span}</source>
        <translation>スパン {span}</translation>
    </message>
    <message>
        <source>a span of {span} counts</source>
        <translation>スパン {span} カウント</translation>
    </message>
    <message>
        <source>at least 1 count</source>
        <translation>1 カウント以上</translation>
    </message>
    <message>
        <source>motors that are not named</source>
        <translation>名前を指定していないモータ</translation>
    </message>
    <message>
        <source>the motor that is addressed when the file is loaded; name it with #</source>
        <translation>ファイルの読み込み時に指定されているモータ。# で指定してください</translation>
    </message>
    <message>
        <source>a table of one dimension</source>
        <translation>1 次元のテーブル</translation>
    </message>
    <message>
        <source>a table of two dimensions</source>
        <translation>2 次元のテーブル</translation>
    </message>
    <message>
        <source>further entries: {entries}</source>
        <translation>余分なエントリ: {entries}</translation>
    </message>
    <message>
        <source>DEFINE COMP in front of them</source>
        <translation>その前に DEFINE COMP</translation>
    </message>
    <message>
        <source>a whole number of 1/16 count</source>
        <translation>1/16 カウント単位の整数</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of one dimension</source>
        <translation>1 次元テーブルの DEFINE COMP</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of two dimensions</source>
        <translation>2 次元テーブルの DEFINE COMP</translation>
    </message>
    <message>
        <source>a table in counts</source>
        <translation>カウント単位のテーブル</translation>
    </message>
    <message>
        <source>different entries at 0 and at the span of motor {motor}</source>
        <translation>0 とモータ {motor} のスパンの終わりで異なるエントリ</translation>
    </message>
    <message>
        <source>the same: the table rolls over there</source>
        <translation>同じ値 (テーブルはそこで最初に戻ります)</translation>
    </message>
    <message>
        <source>entries that are too large in these units</source>
        <translation>この単位では大きすぎるエントリ</translation>
    </message>
    <message>
        <source>another counts-per-unit</source>
        <translation>別の counts-per-unit</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected a number above 0</source>
        <translation>形式 {format} の設定 {key} が {value} です。0 より大きい数値が必要です</translation>
    </message>
    <message>
        <source>position 0, where its tables begin, is no point of source {number}</source>
        <translation>テーブルの始点となる位置 0 が、ソース {number} の点にありません</translation>
    </message>
    <message>
        <source>resample it with a point at 0</source>
        <translation>0 を点に含めて再サンプリングしてください</translation>
    </message>
    <message>
        <source>its tables begin at position 0, which source {number} does not reach</source>
        <translation>テーブルは位置 0 から始まりますが、ソース {number} の範囲に 0 がありません</translation>
    </message>
    <message>
        <source>add points to the table, as far as position 0</source>
        <translation>位置 0 までの点をテーブルに追加してください</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the positions</source>
        <translation>counts-per-unit と位置の単位を確認してください</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 24 bits of an entry</source>
        <translation>値 {value} は 24 ビットのエントリに収まりません</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the values</source>
        <translation>counts-per-unit と値の単位を確認してください</translation>
    </message>
    <message>
        <source>its value at position 0 is {value}, and the controller takes it to be 0 there</source>
        <translation>位置 0 の値が {value} ですが、コントローラはそこを 0 とみなします</translation>
    </message>
    <message>
        <source>there is no motor {number}</source>
        <translation>モータ {number} はありません</translation>
    </message>
    <message>
        <source>choose one from 1 to 32</source>
        <translation>1 から 32 までの番号を選んでください</translation>
    </message>
    <message>
        <source>switch the table on with I51=1; outside of its span it rolls over</source>
        <translation>I51=1 でテーブルをオンにしてください。スパンの外では最初に戻って繰り返します</translation>
    </message>
    <message>
        <source>a line &quot;# {key} = NUMBER&quot; before the counts</source>
        <translation>カウントの前に &quot;# {key} = 数値&quot; の行</translation>
    </message>
    <message>
        <source>{number} to {number2} by {number3}</source>
        <translation>{number} から {number2} まで {number3} 間隔</translation>
    </message>
    <message>
        <source>a maximum above the minimum, and a delta above 0</source>
        <translation>最小値より大きい最大値と、0 より大きい delta</translation>
    </message>
    <message>
        <source>a range that is an integer multiple of the delta</source>
        <translation>delta の整数倍の範囲</translation>
    </message>
    <message>
        <source>the unit {unit}</source>
        <translation>単位 {unit}</translation>
    </message>
    <message>
        <source>values in counts</source>
        <translation>カウント単位の値</translation>
    </message>
    <message>
        <source>a line &quot;# output.counts-per-unit = NUMBER&quot;, or the setting counts-per-unit</source>
        <translation>&quot;# output.counts-per-unit = 数値&quot; の行、または設定 counts-per-unit</translation>
    </message>
    <message>
        <source>a number of counts</source>
        <translation>カウント数</translation>
    </message>
    <message>
        <source>{number} counts per unit</source>
        <translation>1 単位あたり {number} カウント</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>0 以外の数値</translation>
    </message>
    <message>
        <source>{number}, one for each position of the first axis</source>
        <translation>{number} 個 (第 1 軸の位置ごとに 1 個)</translation>
    </message>
    <message>
        <source>{number}, one for each position of the second axis</source>
        <translation>{number} 個 (第 2 軸の位置ごとに 1 個)</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>1 行</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected a C++ name: letters, digits and _</source>
        <translation>設定 name が &quot;{name}&quot; です。C++ の名前 (英字、数字、_) が必要です</translation>
    </message>
    <message>
        <source>the value {value} is {count} counts, and at most 2147483647 can be held</source>
        <translation>値 {value} は {count} カウントになり、上限 2147483647 を超えています</translation>
    </message>
    <message>
        <source>the setting counts-per-unit is 0, expected a number of counts</source>
        <translation>設定 counts-per-unit が 0 です。カウント数が必要です</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 {unit}</source>
        <translation>counts-per-unit を 1 {unit} あたり {count} カウントとみなします</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 unit of the values</source>
        <translation>counts-per-unit を値の 1 単位あたり {count} カウントとみなします</translation>
    </message>
    <message>
        <source>an input axis is the output axis: its command position must be the input, the actual position is not possible</source>
        <translation>入力軸が出力軸と同じです。入力には指令位置を使ってください。実位置は使えません</translation>
    </message>
    <message>
        <source>the inputs are other axes: their command or their actual positions can be the inputs</source>
        <translation>入力が別の軸です。入力には指令位置と実位置のどちらも使えます</translation>
    </message>
    <message>
        <source>the number of source axes, 1 to 3</source>
        <translation>ソース軸の数 (1 から 3)</translation>
    </message>
    <message>
        <source>{number}, one for each source axis</source>
        <translation>{number} 個 (ソース軸ごとに 1 個)</translation>
    </message>
    <message>
        <source>the number of points of a source</source>
        <translation>ソースの点数</translation>
    </message>
    <message>
        <source>at least 2, and at most {number} rows in all</source>
        <translation>2 以上、全体で {number} 行以下</translation>
    </message>
    <message>
        <source>{number}, as in the first row</source>
        <translation>先頭行と同じ {number}</translation>
    </message>
    <message>
        <source>a source position</source>
        <translation>ソースの位置</translation>
    </message>
    <message>
        <source>{number} for source {number2}</source>
        <translation>ソース {number2} に {number}</translation>
    </message>
    <message>
        <source>{number}: the first source changes fastest</source>
        <translation>{number}: 第 1 ソースが最も速く変化</translation>
    </message>
    <message>
        <source>positions of source {axis} from {first} to {last}</source>
        <translation>ソース {axis} の {first} から {last} までの位置</translation>
    </message>
    <message>
        <source>equal distances</source>
        <translation>等しい間隔</translation>
    </message>
    <message>
        <source>a header of {sizes} = {number} rows, and {number2} rows</source>
        <translation>ヘッダの {sizes} = {number} 行に対し、実際は {number2} 行</translation>
    </message>
    <message>
        <source>as many rows as the header says</source>
        <translation>ヘッダが示す行数</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected letters, digits and _, beginning with a letter</source>
        <translation>設定 name が &quot;{name}&quot; です。英字で始まり、英字、数字、_ からなる名前が必要です</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, and not be in use (CompActive = 0) while the lines run</source>
        <translation>プログラムで {count} 点のテーブル {name} を定義しておき、これらの行の実行中は使用しないでください (CompActive = 0)</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, the first source fastest, and not be in use (CompActive = 0) while the lines run</source>
        <translation>プログラムで {count} 点 (第 1 ソースが最も速く変化) のテーブル {name} を定義しておき、これらの行の実行中は使用しないでください (CompActive = 0)</translation>
    </message>
    <message>
        <source>{number} after {number2}</source>
        <translation>{number2} の後に {number}</translation>
    </message>
    <message>
        <source>strictly increasing positions of {axis}</source>
        <translation>{axis} の単調増加する位置</translation>
    </message>
    <message>
        <source>positions of {axis}</source>
        <translation>{axis} の位置</translation>
    </message>
    <message>
        <source>positions of the axis</source>
        <translation>軸の位置</translation>
    </message>
    <message>
        <source>numbers that a computer can tell from each other; check their size</source>
        <translation>コンピュータで区別できる数値。大きさを確認してください</translation>
    </message>
    <message>
        <source>values of {target}</source>
        <translation>{target} の値</translation>
    </message>
    <message>
        <source>values of the table</source>
        <translation>テーブルの値</translation>
    </message>
    <message>
        <source>numbers that a computer can hold; check their size</source>
        <translation>コンピュータで表せる数値。大きさを確認してください</translation>
    </message>
    <message>
        <source>axis {number}</source>
        <translation>軸 {number}</translation>
    </message>
    <message>
        <source>source {number}</source>
        <translation>ソース {number}</translation>
    </message>
    <message>
        <source>table {number}</source>
        <translation>テーブル {number}</translation>
    </message>
    <message>
        <source>at least 2</source>
        <translation>2 以上</translation>
    </message>
    <message>
        <source>{number} to {number2}</source>
        <translation>{number} から {number2}</translation>
    </message>
    <message>
        <source>at most {number} points</source>
        <translation>{number} 点以下</translation>
    </message>
    <message>
        <source>{number} lines</source>
        <translation>{number} 行</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>0 より大きい数値</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>a number for {key}</source>
        <translation>{key} の数値</translation>
    </message>
    <message>
        <source>the number of {key}</source>
        <translation>{key} の番号</translation>
    </message>
    <message>
        <source>a distance above 0</source>
        <translation>0 より大きい間隔</translation>
    </message>
    <message>
        <source>a correction</source>
        <translation>補正量</translation>
    </message>
    <message>
        <source>{what} a second time</source>
        <translation>{what} が 2 回目</translation>
    </message>
    <message>
        <source>a second {key}</source>
        <translation>2 つ目の {key}</translation>
    </message>
    <message>
        <source>each entry once</source>
        <translation>各エントリは 1 回だけ</translation>
    </message>
    <message>
        <source>each entry once; the first is in line {line}</source>
        <translation>各エントリは 1 回だけ。最初のものは行 {line} にあります</translation>
    </message>
    <message>
        <source>each point once</source>
        <translation>各点は 1 回だけ</translation>
    </message>
    <message>
        <source>{value}, as {key} says</source>
        <translation>{key} が示す {value}</translation>
    </message>
    <message>
        <source>{value}, as the setting {key} says</source>
        <translation>設定 {key} が示す {value}</translation>
    </message>
    <message>
        <source>{number}, one for each position of {axis}</source>
        <translation>{number} 個 ({axis} の位置ごとに 1 個)</translation>
    </message>
    <message>
        <source>the format {format} to read it; it is left out here</source>
        <translation>読み取るには形式 {format}。ここでは無視します</translation>
    </message>
    <message>
        <source>the format {format} to read them; they are left out here</source>
        <translation>読み取るには形式 {format}。ここでは無視します</translation>
    </message>
    <message>
        <source>numbers in {from} cannot be given in {to}</source>
        <translation>{from} の数値を {to} で表すことはできません</translation>
    </message>
    <message>
        <source>a unit that is not said</source>
        <translation>示されていない単位</translation>
    </message>
    <message>
        <source>positions without a unit</source>
        <translation>単位のない位置</translation>
    </message>
    <message>
        <source>values without a unit</source>
        <translation>単位のない値</translation>
    </message>
    <message>
        <source>numbers without a unit</source>
        <translation>単位のない数値</translation>
    </message>
    <message>
        <source>the setting {key}, where a unit matters</source>
        <translation>設定 {key} (単位が必要な場合)</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>not all units are said: the values are taken to be in the unit of the positions</source>
        <translation>一部の単位が示されていません。値の単位は位置と同じとみなします</translation>
    </message>
    <message>
        <source>the values were in {before} and are now in {unit}, the unit of the positions</source>
        <translation>値の単位を {before} から、位置の単位 {unit} に変えました</translation>
    </message>
    <message>
        <source>positions in {unit} and values in {other}</source>
        <translation>位置が {unit}、値が {other}</translation>
    </message>
    <message>
        <source>one unit, since the controller adds the values to the positions</source>
        <translation>同じ単位 (コントローラは値を位置に加算するため)</translation>
    </message>
    <message>
        <source>{units}: the format {format} has one unit for both</source>
        <translation>{units}: 形式 {format} は両方に同じ単位を使います</translation>
    </message>
    <message>
        <source>choose a format for cross compensation</source>
        <translation>クロス補正の形式を選んでください</translation>
    </message>
    <message>
        <source>check the unit of the table</source>
        <translation>テーブルの単位を確認してください</translation>
    </message>
    <message>
        <source>check the units of the table</source>
        <translation>テーブルの各単位を確認してください</translation>
    </message>
    <message>
        <source>the {what} are in {from}, which cannot be given in {to}; correct the units</source>
        <translation>{what}の単位 {from} を {to} で表すことはできません。単位を修正してください</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for writing; it has: {known}</source>
        <translation>形式 {format} の書き込みに設定 {key} はありません。使える設定: {known}</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for reading; it has: {known}</source>
        <translation>形式 {format} の読み取りに設定 {key} はありません。使える設定: {known}</translation>
    </message>
    <message>
        <source>the format {format} can be read, not written</source>
        <translation>形式 {format} は読み取りだけで、書き込みはできません</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1; the setting {key} is {value}</source>
        <translation>形式 {format} の軸は 1 からの番号で表します。設定 {key} が {value} です</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1 and there is no number in the axis name &quot;{name}&quot;; give the setting {key}</source>
        <translation>形式 {format} の軸は 1 からの番号で表しますが、軸名 &quot;{name}&quot; に番号がありません。設定 {key} を指定してください</translation>
    </message>
    <message>
        <source>its positions of source {number} span {span}, and a modulo axis needs exactly one period of {period}</source>
        <translation>ソース {number} の位置の幅が {span} ですが、モジュロ軸にはちょうど 1 周期 {period} が必要です</translation>
    </message>
    <message>
        <source>resample it over one whole period</source>
        <translation>ちょうど 1 周期で再サンプリングしてください</translation>
    </message>
    <message>
        <source>the values at both ends of the modulo axis, source {number}, differ by {difference}</source>
        <translation>モジュロ軸 (ソース {number}) の両端の値に {difference} の差があります</translation>
    </message>
    <message>
        <source>make both ends equal: they are the same place</source>
        <translation>両端は同じ位置なので、値を同じにしてください</translation>
    </message>
    <message>
        <source>its modulo axis is not rotary</source>
        <translation>モジュロ軸が回転軸ではありません</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap)</source>
        <translation>直進軸として扱ってください (--no-wrap)</translation>
    </message>
    <message>
        <source>it takes a column for both directions of motion, or one for each direction of one axis</source>
        <translation>両方の運動方向に共通の 1 列、または 1 つの軸の方向ごとに 1 列ずつしかもてません</translation>
    </message>
    <message>
        <source>choose these columns</source>
        <translation>それらの列を選んでください</translation>
    </message>
    <message>
        <source>{count} columns are more than the {limit} of one table</source>
        <translation>{count} 列は、1 テーブルの上限 {limit} 列を超えています</translation>
    </message>
    <message>
        <source>choose a column, and write the others to files of their own</source>
        <translation>1 列を選び、ほかの列は別のファイルに書いてください</translation>
    </message>
    <message>
        <source>{count} tables are more than the {limit} of one file</source>
        <translation>{count} テーブルは、1 ファイルの上限 {limit} テーブルを超えています</translation>
    </message>
    <message>
        <source>choose one, and write the others to files of their own</source>
        <translation>1 つを選び、ほかは別のファイルに書いてください</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>いずれか 1 つを選んでください</translation>
    </message>
    <message>
        <source>{size} bytes are more than the {limit} of a file</source>
        <translation>{size} バイトは、ファイルの上限 {limit} を超えています</translation>
    </message>
    <message>
        <source>write it as {format}</source>
        <translation>{format} で書いてください</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}</source>
        <translation>軸 {axis} のテーブルが 2 つあります</translation>
    </message>
    <message>
        <source>a TAM table needs the table layout of a drive profile</source>
        <translation>TAM テーブルには、ドライブプロファイルのテーブルレイアウトが必要です</translation>
    </message>
    <message>
        <source>a calibration file needs the number of its dimensions: 1, 2 or 3</source>
        <translation>校正ファイルには次元数が必要です: 1、2 または 3</translation>
    </message>
    <message>
        <source>a table kw.{name} besides kw.{other}</source>
        <translation>kw.{other} と並ぶテーブル kw.{name}</translation>
    </message>
    <message>
        <source>a point kw.{point} with one index</source>
        <translation>インデックス 1 つの点 kw.{point}</translation>
    </message>
    <message>
        <source>a point kw.{point} with two indices</source>
        <translation>インデックス 2 つの点 kw.{point}</translation>
    </message>
    <message>
        <source>a table kw.{name}, of which there is no entry</source>
        <translation>テーブル kw.{name} (エントリが 1 つもない)</translation>
    </message>
    <message>
        <source>the setting {key}, such as mm, where a unit matters</source>
        <translation>設定 {key} (mm など、単位が必要な場合)</translation>
    </message>
    <message>
        <source>byte {value}</source>
        <translation>バイト {value}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid calibration file: {count} problems</source>
        <comment>{file} is not a valid calibration file: one problem</comment>
        <translation>
            <numerusform>{file} は有効な校正ファイルではありません: 問題 {count} 件</numerusform>
        </translation>
    </message>
    <message>
        <source>there is a source for dimension {dimension}, but the table is {dimensions}D</source>
        <translation>次元 {dimension} のソースがありますが、テーブルは {dimensions}D です</translation>
    </message>
    <message>
        <source>the table is {table}D, but {chosen}D is chosen</source>
        <translation>テーブルは {table}D ですが、{chosen}D が選ばれています</translation>
    </message>
    <message>
        <source>{time} ({step})</source>
        <translation>{time} ({step})</translation>
    </message>
    <message>
        <source>sign: {from}, {to}; {example}</source>
        <translation>符号: {from}、{to}。{example}</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>負方向</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}; {next}</translation>
    </message>
    <message>
        <source>position {number} = {position}</source>
        <translation>位置 {number} = {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} columns</source>
        <comment>1 column</comment>
        <translation>
            <numerusform>{count} 列</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a value of type {type}; expected {expected}</source>
        <translation>&quot;{text}&quot; は {type} 型の値ではありません。必要: {expected}</translation>
    </message>
    <message>
        <source>a number such as 12.5, at most {most} in magnitude</source>
        <translation>12.5 のような数値 (絶対値は {most} 以下)</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true または false</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}, or an address such as 0x1234</source>
        <translation>{least} から {most} までの整数、または 0x1234 のようなアドレス</translation>
    </message>
    <message>
        <source>the name of an enum value, without blanks</source>
        <translation>空白を含まない列挙値の名前</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}</source>
        <translation>{least} から {most} までの整数</translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections</source>
        <comment>1 correction</comment>
        <translation>
            <numerusform>補正量 {count} 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} rows</source>
        <comment>1 row</comment>
        <translation>
            <numerusform>{count} 行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections in this line, {all} in all</source>
        <comment>1 correction in this line, {all} in all</comment>
        <translation>
            <numerusform>この行に補正量 {count} 個 (全体で {all} 個)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has {count} source axes, possible are {range}</source>
        <comment>it has 1 source axis, possible are {range}</comment>
        <translation>
            <numerusform>ソース軸が {count} 本ですが、可能なのは {range} 本です</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>数値 {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>logical number of master axis 1, for master1_ax_nr</source>
        <translation>マスタ軸 1 の論理番号 (master1_ax_nr)</translation>
    </message>
    <message>
        <source>logical number of master axis 2, for master2_ax_nr</source>
        <translation>マスタ軸 2 の論理番号 (master2_ax_nr)</translation>
    </message>
    <message>
        <source>whether master axis 1 is linear (mm) or rotary (deg)</source>
        <translation>マスタ軸 1 が直進軸 (mm) か回転軸 (deg) か</translation>
    </message>
    <message>
        <source>whether master axis 2 is linear (mm) or rotary (deg)</source>
        <translation>マスタ軸 2 が直進軸 (mm) か回転軸 (deg) か</translation>
    </message>
    <message>
        <source>master axis 1 is a modulo axis: its ends are one place</source>
        <translation>マスタ軸 1 がモジュロ軸で、両端が同じ位置</translation>
    </message>
    <message>
        <source>master axis 2 is a modulo axis: its ends are one place</source>
        <translation>マスタ軸 2 がモジュロ軸で、両端が同じ位置</translation>
    </message>
    <message numerus="yes">
        <source>{count} points</source>
        <comment>1 point</comment>
        <translation>
            <numerusform>{count} 点</numerusform>
        </translation>
    </message>
    <message>
        <source>no {name}</source>
        <translation>{name} なし</translation>
    </message>
    <message numerus="yes">
        <source>{count} heights</source>
        <comment>1 height</comment>
        <translation>
            <numerusform>高さ {count} 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of points</source>
        <comment>1 line of points</comment>
        <translation>
            <numerusform>点の {count} 行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} entries</source>
        <comment>1 entry</comment>
        <translation>
            <numerusform>エントリ {count} 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values</source>
        <comment>1 value</comment>
        <translation>
            <numerusform>{count} 値</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of counts</source>
        <comment>1 line of counts</comment>
        <translation>
            <numerusform>カウントの {count} 行</numerusform>
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
            <numerusform>高さの {count} 行</numerusform>
        </translation>
    </message>
    <message>
        <source>table {index} needs $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) of at least {count}; switch it on with $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 and $MA_CEC_ENABLE (MD32710) 1 of axis {axis}</source>
        <translation>テーブル {index} の $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) は {count} 以上必要です。$SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 と、軸 {axis} の $MA_CEC_ENABLE (MD32710) 1 でオンにしてください</translation>
    </message>
    <message>
        <source>no {variable} of {curve}</source>
        <translation>{curve} の {variable} なし</translation>
    </message>
    <message numerus="yes">
        <source>{count} source axes</source>
        <comment>1 source axis</comment>
        <translation>
            <numerusform>ソース軸 {count} 本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} sizes</source>
        <comment>1 size</comment>
        <translation>
            <numerusform>サイズ {count} 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions and at least one correction</source>
        <comment>1 position and at least one correction</comment>
        <translation>
            <numerusform>位置 {count} 個と、1 個以上の補正量</numerusform>
        </translation>
    </message>
    <message>
        <source>{axes}</source>
        <translation>{axes}</translation>
    </message>
    <message>
        <source>{axes} to {target}</source>
        <translation>{axes} から {target}</translation>
    </message>
    <message>
        <source>(table layout)</source>
        <translation>(テーブルレイアウト)</translation>
    </message>
    <message>
        <source>it cannot be of type {type}; expected {expected}</source>
        <translation>{type} 型にはできません。必要: {expected}</translation>
    </message>
    <message>
        <source>f32 or f64</source>
        <translation>f32 または f64</translation>
    </message>
    <message>
        <source>u8, u16, u32 or i32</source>
        <translation>u8、u16、u32 または i32</translation>
    </message>
    <message>
        <source>its count is {found}, expected the length of the magic text, {expected}, which is at least 1</source>
        <translation>個数が {found} です。必要: 識別文字列 (magic) の長さ {expected} (1 以上)</translation>
    </message>
    <message>
        <source>its count is 0, expected at least 1</source>
        <translation>個数が 0 です。1 以上が必要です</translation>
    </message>
    <message>
        <source>its count is {found}, expected {expected}</source>
        <translation>個数が {found} です。必要: {expected}</translation>
    </message>
    <message>
        <source>its type {type} cannot hold {value}</source>
        <translation>{type} 型では {value} を表せません</translation>
    </message>
    <message>
        <source>it ends at byte {end}, but the header has only {size} bytes</source>
        <translation>バイト {end} で終わりますが、ヘッダは {size} バイトしかありません</translation>
    </message>
    <message>
        <source>it covers the header bytes before it, and there are none</source>
        <translation>その前のヘッダのバイトが対象ですが、前に何もありません</translation>
    </message>
    <message>
        <source>it begins at byte {begin}, inside {field}, which ends at byte {end}</source>
        <translation>バイト {begin} で始まりますが、バイト {end} で終わる {field} の途中です</translation>
    </message>
    <message>
        <source>it is {size}, expected 1 to {limit} bytes</source>
        <translation>{size} です。1 から {limit} バイトが必要です</translation>
    </message>
    <message>
        <source>it is missing; a table cannot be read without it</source>
        <translation>欠落しています。これがないとテーブルを読み取れません</translation>
    </message>
    <message numerus="yes">
        <source>{count} positions</source>
        <comment>1 position</comment>
        <translation>
            <numerusform>位置 {count} 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions of {axis}</source>
        <comment>1 position of {axis}</comment>
        <translation>
            <numerusform>{axis} の位置 {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>CRC {crc}</source>
        <translation>CRC {crc}</translation>
    </message>
    <message>
        <source>the body is not JSON</source>
        <translation>本文が JSON ではありません</translation>
    </message>
    <message>
        <source>the body must be an array, {example}</source>
        <translation>本文は {example} のような配列にしてください</translation>
    </message>
    <message>
        <source>{place} must be an object, {example}</source>
        <translation>{place} は {example} のようなオブジェクトにしてください</translation>
    </message>
    <message>
        <source>{place}.path must be a text</source>
        <translation>{place}.path はテキストにしてください</translation>
    </message>
    <message>
        <source>{place}.value must be a number, a text, true, false or null</source>
        <translation>{place}.value は数値、テキスト、true、false または null にしてください</translation>
    </message>
    <message>
        <source>the body must be an object with &quot;value&quot;: a number, a text, true, false or null</source>
        <translation>本文は &quot;value&quot; (数値、テキスト、true、false または null) をもつオブジェクトにしてください</translation>
    </message>
    <message>
        <source>one of u8, u16, u32, i32, f32, f64 or char is expected, with a count in brackets where there are several: char[32]</source>
        <translation>u8、u16、u32、i32、f32、f64 または char のいずれかが必要です。複数の場合は char[32] のように角括弧で個数を示します</translation>
    </message>
    <message>
        <source>the count is given twice, here and in the type</source>
        <translation>個数が、ここと型の 2 か所に指定されています</translation>
    </message>
    <message>
        <source>the number of characters is missing: char[32]</source>
        <translation>文字数がありません (例: char[32])</translation>
    </message>
    <message>
        <source>there is no field {name} to hold it</source>
        <translation>それを格納するフィールド {name} がありません</translation>
    </message>
    <message>
        <source>&quot;little&quot; or &quot;big&quot; is expected</source>
        <translation>&quot;little&quot; または &quot;big&quot; が必要です</translation>
    </message>
    <message>
        <source>&quot;first&quot; or &quot;last&quot; is expected</source>
        <translation>&quot;first&quot; または &quot;last&quot; が必要です</translation>
    </message>
    <message>
        <source>a file path such as tables/small1.TAMtbl is expected</source>
        <translation>tables/small1.TAMtbl のようなファイルパスが必要です</translation>
    </message>
    <message>
        <source>a file path has a name between its slashes, none at its ends, and no &quot;.&quot; or &quot;..&quot;</source>
        <translation>ファイルパスでは、スラッシュの間に名前が必要です。先頭と末尾のスラッシュ、&quot;.&quot; と &quot;..&quot; は使えません</translation>
    </message>
    <message>
        <source>there are more than {most} slots</source>
        <translation>スロットが {most} 個を超えています</translation>
    </message>
    <message>
        <source>this is the value that stands for no table, enums.tableDisabled</source>
        <translation>これは、テーブルなしを表す値 enums.tableDisabled です</translation>
    </message>
    <message>
        <source>another slot has the name {name}</source>
        <translation>別のスロットが名前 {name} を使っています</translation>
    </message>
    <message>
        <source>another slot has the file {file}</source>
        <translation>別のスロットがファイル {file} を使っています</translation>
    </message>
    <message>
        <source>at least one slot is needed</source>
        <translation>1 つ以上のスロットが必要です</translation>
    </message>
    <message>
        <source>the path of a web page is expected, such as /directory</source>
        <translation>/directory のような Web ページのパスが必要です</translation>
    </message>
    <message>
        <source>a slash is needed at the end, because a file path follows</source>
        <translation>後にファイルパスが続くため、末尾にスラッシュが必要です</translation>
    </message>
    <message>
        <source>there must be no slash at the end</source>
        <translation>末尾にスラッシュは付けられません</translation>
    </message>
    <message>
        <source>this is the same page as directory</source>
        <translation>directory と同じページです</translation>
    </message>
    <message>
        <source>this is the same page as directory or transfer</source>
        <translation>directory または transfer と同じページです</translation>
    </message>
    <message>
        <source>this is the same field as transferPathField</source>
        <translation>transferPathField と同じフィールドです</translation>
    </message>
    <message>
        <source>it is empty; a register path is expected</source>
        <translation>空です。レジスタパスが必要です</translation>
    </message>
    <message>
        <source>it has {count} characters, at most {most} are possible</source>
        <translation>{count} 文字あります。上限は {most} 文字です</translation>
    </message>
    <message>
        <source>a path has one slash between its parts and none at its ends</source>
        <translation>パスの要素の間にはスラッシュを 1 つ置きます。先頭と末尾には付けられません</translation>
    </message>
    <message>
        <source>a path is made of letters, digits, &apos;_&apos;, &apos;-&apos;, &apos;/&apos;, &apos;[&apos; and &apos;]&apos;; the character at position {position} is none of them</source>
        <translation>パスに使えるのは英字、数字、&apos;_&apos;、&apos;-&apos;、&apos;/&apos;、&apos;[&apos;、&apos;]&apos; です。{position} 文字目は使えません</translation>
    </message>
    <message>
        <source>the placeholder {name} is missing</source>
        <translation>プレースホルダ {name} がありません</translation>
    </message>
    <message>
        <source>the placeholder {name} is there more than once</source>
        <translation>プレースホルダ {name} が 2 回以上あります</translation>
    </message>
    <message>
        <source>the placeholder {name} has no meaning here</source>
        <translation>プレースホルダ {name} はここでは意味をもちません</translation>
    </message>
    <message>
        <source>in braces there can only be a placeholder, one of {known}</source>
        <translation>波括弧の中に置けるのはプレースホルダだけです。使えるもの: {known}</translation>
    </message>
    <message>
        <source>a range is written in brackets, such as [0..15]</source>
        <translation>範囲は [0..15] のように角括弧で書きます</translation>
    </message>
    <message>
        <source>a range goes from a whole number up to another one, such as [0..15]</source>
        <translation>範囲は [0..15] のように、整数からより大きい整数までです</translation>
    </message>
    <message>
        <source>the register {path} is there twice</source>
        <translation>レジスタ {path} が 2 回あります</translation>
    </message>
    <message>
        <source>the shortlist has more than {most} registers</source>
        <translation>候補リストのレジスタが {most} 個を超えています</translation>
    </message>
    <message>
        <source>a word of 1 to {most} letters, digits, &apos;_&apos; or &apos;-&apos; is expected</source>
        <translation>1 から {most} 文字の英字、数字、&apos;_&apos;、&apos;-&apos; からなる語が必要です</translation>
    </message>
    <message>
        <source>this is the same register as {name}</source>
        <translation>{name} と同じレジスタです</translation>
    </message>
    <message>
        <source>this is the same value as {name}</source>
        <translation>{name} と同じ値です</translation>
    </message>
    <message>
        <source>a numeric type is expected: Int32, UInt32, Single or Double</source>
        <translation>数値型が必要です: Int32、UInt32、Single または Double</translation>
    </message>
    <message>
        <source>the type {type} is there twice</source>
        <translation>型 {type} が 2 回あります</translation>
    </message>
    <message>
        <source>at least one type is needed</source>
        <translation>1 つ以上の型が必要です</translation>
    </message>
    <message numerus="yes">
        <source>{count} registers</source>
        <comment>one register</comment>
        <translation>
            <numerusform>レジスタ {count} 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} addresses</source>
        <comment>one address</comment>
        <translation>
            <numerusform>アドレス {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{code}&quot; is not what a drive can answer; that is one of {known}</source>
        <translation>&quot;{code}&quot; はドライブの応答ではありません。可能なもの: {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a fault; known are {known}</source>
        <translation>&quot;{text}&quot; は故障の名前ではありません。使えるもの: {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a whole number from 1 to {most}, as {name} needs</source>
        <translation>&quot;{text}&quot; は、{name} に必要な 1 から {most} までの整数ではありません</translation>
    </message>
    <message>
        <source>a fault was asked for</source>
        <translation>故障が要求されました</translation>
    </message>
    <message>
        <source>it is the state of the drive with serial number {found}, not of {expected}</source>
        <translation>シリアル番号 {expected} ではなく、{found} のドライブの状態です</translation>
    </message>
    <message>
        <source>the profile {profile} has no slot {slot}</source>
        <translation>プロファイル {profile} にスロット {slot} がありません</translation>
    </message>
    <message>
        <source>the table in {slot} is larger than the slot</source>
        <translation>{slot} のテーブルがスロットより大きくなっています</translation>
    </message>
    <message>
        <source>the name of a file in the folder {folder}</source>
        <translation>フォルダ {folder} 内のファイル名</translation>
    </message>
    <message>
        <source>{place} must be {expected}</source>
        <translation>{place} は{expected}にしてください</translation>
    </message>
    <message>
        <source>a list of whole numbers, 0 or more</source>
        <translation>0 以上の整数のリスト</translation>
    </message>
    <message>
        <source>a boolean, a number or a text</source>
        <translation>真偽値、数値またはテキスト</translation>
    </message>
    <message>
        <source>it is not the JSON of a virtual drive&apos;s state</source>
        <translation>仮想ドライブの状態の JSON ではありません</translation>
    </message>
    <message>
        <source>a virtual drive has at most {most} axes, not {count}</source>
        <translation>仮想ドライブの軸は {most} 本までです。{count} 本は指定できません</translation>
    </message>
    <message>
        <source>an axis needs a range with low below high, and a period above 0 s</source>
        <translation>軸の範囲は下限より上限が大きく、周期は 0 s より大きくしてください</translation>
    </message>
    <message>
        <source>a parameter does not fit: {reason}</source>
        <translation>パラメータが適合しません: {reason}</translation>
    </message>
    <message>
        <source>{request} is not a request; these are: {known}</source>
        <translation>{request} は要求ではありません。使えるもの: {known}</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, not {count}</source>
        <translation>レジスタを 1 から {most} 個指定してください。{count} 個は指定できません</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, each with its value</source>
        <translation>1 から {most} 個のレジスタを、それぞれの値とともに指定してください</translation>
    </message>
    <message>
        <source>write {request}; &quot;&quot; is everything</source>
        <translation>{request} と入力してください。&quot;&quot; はすべてを表します</translation>
    </message>
    <message>
        <source>write {request}, the CRC in hexadecimal digits</source>
        <translation>{request} と入力してください。CRC は 16 進数です</translation>
    </message>
    <message>
        <source>write {request}</source>
        <translation>{request} と入力してください</translation>
    </message>
    <message>
        <source>a new pseudo-terminal</source>
        <translation>新しい疑似端末</translation>
    </message>
    <message>
        <source>no pseudo-terminal: {reason}</source>
        <translation>疑似端末を作成できません: {reason}</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another one</source>
        <translation>同名のファイルがあります。別の名前にしてください</translation>
    </message>
    <message>
        <source>the link cannot be made: {reason}</source>
        <translation>リンクを作成できません: {reason}</translation>
    </message>
    <message>
        <source>the line has more than {most} characters</source>
        <translation>行が {most} 文字を超えています</translation>
    </message>
    <message>
        <source>this is no request; a line is [#n ]words[ *XXXX]</source>
        <translation>要求ではありません。行の形式は [#n ]語[ *XXXX] です</translation>
    </message>
    <message>
        <source>&quot;{value}&quot; is too large for a Single</source>
        <translation>&quot;{value}&quot; は Single には大きすぎます</translation>
    </message>
    <message>
        <source>the value is longer than any name of an enum</source>
        <translation>値が、どの列挙値の名前よりも長くなっています</translation>
    </message>
    <message>
        <source>a document type is not allowed</source>
        <translation>文書型は使えません</translation>
    </message>
    <message>
        <source>entities are not allowed</source>
        <translation>エンティティは使えません</translation>
    </message>
    <message>
        <source>the root element is {name}, expected TamTopology</source>
        <translation>ルート要素が {name} です。TamTopology が必要です</translation>
    </message>
    <message>
        <source>a RegisterComponent needs Address, Type and Value</source>
        <translation>RegisterComponent には Address、Type、Value が必要です</translation>
    </message>
    <message>
        <source>the axis index must be from 0 to {most}</source>
        <translation>軸インデックスは 0 から {most} までです</translation>
    </message>
    <message>
        <source>there are more than {most} registers</source>
        <translation>レジスタが {most} 個を超えています</translation>
    </message>
    <message>
        <source>there is no TamStation with registers of an axis in it</source>
        <translation>軸のレジスタをもつ TamStation がありません</translation>
    </message>
    <message numerus="yes">
        <source>{path}, or one of {count} others asked for with it</source>
        <comment>{path}, or another one asked for with it</comment>
        <translation>
            <numerusform>{path}、または同時に要求した {count} 個のうちのいずれか</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers</source>
        <comment>a JSON array of one register</comment>
        <translation>
            <numerusform>レジスタ {count} 個の JSON 配列</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers, in the order asked for</source>
        <comment>a JSON array of the one register asked for</comment>
        <translation>
            <numerusform>要求した順のレジスタ {count} 個の JSON 配列</numerusform>
        </translation>
    </message>
    <message>
        <source>this is empty</source>
        <translation>空です</translation>
    </message>
    <message>
        <source>this is there twice</source>
        <translation>2 回あります</translation>
    </message>
    <message>
        <source>it does not read back as it was written</source>
        <translation>読み戻した内容が、書き込んだ内容と異なります</translation>
    </message>
    <message>
        <source>it is not the table that was kept there: its size or CRC differs</source>
        <translation>そこに保存したテーブルではありません。サイズまたは CRC が異なります</translation>
    </message>
    <message>
        <source>it was kept about a write that did not end, but is damaged ({reason}). Look at what the drive holds, then delete the file</source>
        <translation>完了していない書き込みのものですが、破損しています ({reason})。ドライブの内容を確認してから、このファイルを削除してください</translation>
    </message>
    <message>
        <source>it is about axis {axis} of drive {drive}</source>
        <translation>ドライブ {drive} の軸 {axis} のものです</translation>
    </message>
    <message>
        <source>user name or password is missing or wrong</source>
        <translation>ユーザ名またはパスワードがないか、間違っています</translation>
    </message>
    <message>
        <source>the request has more bytes than the largest that the drive takes</source>
        <translation>要求が、ドライブで扱える最大バイト数を超えています</translation>
    </message>
    <message>
        <source>it is not stated which axis the values of {column} correct, and the numbers depend on it; state the target: {sources}</source>
        <translation>{column} の値がどの軸を補正するのか示されていません。数値はこれによって変わるため、対象軸を指定してください: {sources}</translation>
    </message>
    <message>
        <source>{table} is the name of table {named} and the number of table {numbered}; say name:{table} or #{table}</source>
        <translation>{table} はテーブル {named} の名前でも、テーブル {numbered} の番号でもあります。name:{table} または #{table} と指定してください</translation>
    </message>
    <message>
        <source>the table goes from {before}, and the file would say from {after}; correct the settings for its axes, or the target</source>
        <translation>テーブルの対応は {before} ですが、ファイルでは {after} となります。軸の設定または対象軸を修正してください</translation>
    </message>
    <message>
        <source>one axis for all columns or one for each: the name of an axis, #1 for the first source, or other</source>
        <translation>全列で共通の軸、または列ごとの軸: 軸名、#1 (第 1 ソース)、または other</translation>
    </message>
    <message>
        <source>the axis of dimension {number}</source>
        <translation>次元 {number} の軸</translation>
    </message>
    <message>
        <source>the axis of dimension {number} ({axis})</source>
        <translation>次元 {number} の軸 ({axis})</translation>
    </message>
    <message>
        <source>an axis that is no source</source>
        <translation>ソースではない軸</translation>
    </message>
    <message>
        <source>dimension {number} is its own position</source>
        <translation>次元 {number} はこの軸自身の位置です</translation>
    </message>
    <message>
        <source>all sources are positions of other axes</source>
        <translation>すべてのソースがほかの軸の位置です</translation>
    </message>
    <message>
        <source>it corrects an axis by its own position, and this table goes from {column}</source>
        <translation>軸を自身の位置で補正する形式ですが、このテーブルの対応は {column} です</translation>
    </message>
    <message>
        <source>{statement} (source {number})</source>
        <translation>{statement} (ソース {number})</translation>
    </message>
    <message>
        <source>{statement} ({axis})</source>
        <translation>{statement} ({axis})</translation>
    </message>
    <message>
        <source>{statement} (an axis that is no source)</source>
        <translation>{statement} (ソースではない軸)</translation>
    </message>
    <message>
        <source>{count} targets are stated for {columns} columns; state one for all or one for each</source>
        <translation>{columns} 列に対して対象軸が {count} 本指定されています。全列に 1 本、または列ごとに 1 本指定してください</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>別の軸</translation>
    </message>
    <message>
        <source>{placeholder} is expected in the path</source>
        <translation>パスに {placeholder} が必要です</translation>
    </message>
    <message>
        <source>the {what} are in {unit}, which cannot be converted to {other}, the unit of the drive; correct the unit in the file, or state it</source>
        <translation>{what}の単位 {unit} は、ドライブの単位 {other} に変換できません。ファイルの単位を修正するか、単位を指定してください</translation>
    </message>
    <message>
        <source>positions of dimension {number}</source>
        <translation>次元 {number} の位置</translation>
    </message>
    <message>
        <source>Neither the table nor the drive states a unit for the values. The largest correction is {largest}.</source>
        <translation>値の単位がテーブルにもドライブにも示されていません。最大の補正量は {largest} です。</translation>
    </message>
    <message>
        <source>The values are converted from {before} to {after}. The largest correction is {largest}.</source>
        <translation>値を {before} から {after} に変換します。最大の補正量は {largest} です。</translation>
    </message>
    <message>
        <source>The drive states no unit for the axis; the values are written in {before}. The largest correction is {largest}.</source>
        <translation>ドライブに軸の単位が示されていません。値を {before} のまま書き込みます。最大の補正量は {largest} です。</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {after}. The largest correction is {largest}.</source>
        <translation>テーブルに値の単位が示されていません。{after} とみなします。最大の補正量は {largest} です。</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are converted from {before} to {after}: {first} to {last}.</source>
        <translation>次元 {number} の位置を {before} から {after} に変換します: {first} から {last}。</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them in the preview, or with --accept-large</source>
        <translation>{reason} 値の単位を確認してください。正しい場合は、プレビューまたは --accept-large で承認してください</translation>
    </message>
    <message>
        <source>The largest correction, {largest}, is {percent} of the range of dimension {number}, {range}.</source>
        <translation>最大の補正量 {largest} は、次元 {number} の範囲 {range} の {percent} に当たります。</translation>
    </message>
    <message>
        <source>The correction has a slope of {slope} along dimension {number}, between {first} and {last}.</source>
        <translation>補正の傾きが次元 {number} の {first} と {last} の間で {slope} です。</translation>
    </message>
    <message>
        <source>The axis is outside of the table, where the values at its ends hold. Move the axis into the table and activate again.</source>
        <translation>軸がテーブルの範囲外にあり、端点値が使われています。軸をテーブルの範囲内に動かしてから、もう一度有効化してください。</translation>
    </message>
    <message>
        <source>The table is 0, or too small to be seen, at every position that was looked at. Move the axis to where the table is larger and activate again.</source>
        <translation>調べたすべての位置でテーブルの値が 0 か、見分けられないほど小さい値です。テーブルの値がより大きい位置に軸を動かしてから、もう一度有効化してください。</translation>
    </message>
    <message>
        <source>version 1 of the height map</source>
        <translation>ハイトマップのバージョン 1</translation>
    </message>
    <message>
        <source>version 2, which newer firmware writes</source>
        <translation>バージョン 2 (新しいファームウェアの形式)</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a file</source>
        <translation>ファイルではなく、パイプまたはデバイスです</translation>
    </message>
    <message>
        <source>the values are multiplied by a number that is not 0, and shifted by a number</source>
        <translation>値に掛ける数値は 0 以外、値をずらす量は数値で指定してください</translation>
    </message>
    <message>
        <source>an offset and a position at which the values are 0 contradict each other</source>
        <translation>オフセットと、値を 0 にする位置の両方は指定できません</translation>
    </message>
    <message>
        <source>the position at which the values are 0 needs a number for each of the {count} source axes</source>
        <translation>値を 0 にする位置は、{count} 本のソース軸それぞれについて指定してください</translation>
    </message>
    <message>
        <source>{position} of source {number}, where the values shall be 0, is outside of the table, which goes from {first} to {last}</source>
        <translation>値を 0 にするソース {number} の {position} が、テーブルの範囲 {first} から {last} の外にあります</translation>
    </message>
    <message>
        <source>the values are multiplied by {factor}</source>
        <translation>値を {factor} 倍します</translation>
    </message>
    <message>
        <source>the values of {column} are shifted by {shift}</source>
        <translation>{column} の値を {shift} ずらします</translation>
    </message>
    <message>
        <source>{source} is a position after the compensation: the table would be looked up where its own values have moved the axis.</source>
        <translation>{source} は補正後の位置です。テーブル自身の値で軸が動いた位置でテーブルを参照することになります。</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; write volatile, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>このドライブのフラッシュ操作の履歴が破損していたため、すべて使い切ったものとみなしています。揮発で書き込むか、&apos;axiscomp status --reset-flash-count&apos; で回数をリセットしてください</translation>
    </message>
    <message>
        <source>it is not an ordinary file; move it away</source>
        <translation>通常のファイルではありません。別の場所に移してください</translation>
    </message>
    <message>
        <source>the SHA-256 of a certificate is expected</source>
        <translation>証明書の SHA-256 が必要です</translation>
    </message>
    <message>
        <source>it cannot be renamed: {reason}</source>
        <translation>名前を変更できません: {reason}</translation>
    </message>
    <message>
        <source>it is on a network file system, where a database can be damaged; set XDG_STATE_HOME to a folder on this computer</source>
        <translation>データベースが破損するおそれのあるネットワークファイルシステム上にあります。XDG_STATE_HOME にこのコンピュータのフォルダを設定してください</translation>
    </message>
    <message>
        <source>a newer version of this program has written it; use that version</source>
        <translation>より新しいバージョンのプログラムで書かれています。そのバージョンを使ってください</translation>
    </message>
    <message>
        <source>it is the database of another program; move it away</source>
        <translation>別のプログラムのデータベースです。別の場所に移してください</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>ファイルが読み取り専用です</translation>
    </message>
    <message>
        <source>this file system cannot share it between programs</source>
        <translation>このファイルシステムでは、複数のプログラムでファイルを共有できません</translation>
    </message>
    <message>
        <source>the file or its folder is read-only</source>
        <translation>ファイルまたはそのフォルダが読み取り専用です</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>破損しています</translation>
    </message>
    <message>
        <source>its journal of an interrupted write is damaged ({reason}). Look at what the drive holds, then move the file away</source>
        <translation>中断された書き込みのジャーナルが破損しています ({reason})。ドライブの内容を確認してから、このファイルを別の場所に移してください</translation>
    </message>
    <message>
        <source>{axis} is taken for {first} to {last} in steps of {distance}; the largest shift is {shift}, at {position}</source>
        <translation>{axis} を {first} から {last} まで {distance} 間隔とみなします。最大のずれは {position} の {shift} です</translation>
    </message>
    <message>
        <source>position {number}</source>
        <translation>位置 {number}</translation>
    </message>
    <message>
        <source>no 2 neighbouring points in every dimension with a value</source>
        <translation>すべての次元で値がそろった隣接 2 点がない</translation>
    </message>
    <message>
        <source>a part of the grid that is complete; fill the points instead</source>
        <translation>欠測のない格子の部分。代わりに点を補填してください</translation>
    </message>
    <message>
        <source>{axis} from {first} to {last}</source>
        <translation>{axis}: {first} から {last}</translation>
    </message>
    <message>
        <source>{missing} of {all} points without a value; kept are {kept} points, {ranges}</source>
        <translation>全 {all} 点のうち {missing} 点に値がありません。{kept} 点を残します: {ranges}</translation>
    </message>
    <message>
        <source>no value at all in {table}</source>
        <translation>{table} に値が 1 つもない</translation>
    </message>
    <message>
        <source>a column with values</source>
        <translation>値のある列</translation>
    </message>
    <message>
        <source>{count} points without a value</source>
        <translation>値のない点 {count} 個</translation>
    </message>
    <message>
        <source>at most {most} for a smooth filling; choose the nearest point or a plane</source>
        <translation>滑らかな補填は {most} 個以下。最近傍点または平面を選んでください</translation>
    </message>
    <message>
        <source>measured points of {table} on one line only</source>
        <translation>{table} の測定点が一直線上にしかない</translation>
    </message>
    <message>
        <source>points that determine a plane; choose the nearest point instead</source>
        <translation>平面が決まる点。代わりに最近傍点を選んでください</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} から {high}</translation>
    </message>
    <message>
        <source>{count} of {all} points of {table} without a value; they get {made}, the measured values are {measured}</source>
        <translation>{table} の全 {all} 点のうち {count} 点に値がありません。{made} を補填します。測定値は {measured} です</translation>
    </message>
    <message>
        <source>{expected}; a tolerance of {tolerance} takes them for an even grid (--snap, or Snap tolerance in the import)</source>
        <translation>{expected}。許容差 {tolerance} とすれば等間隔格子とみなせます (--snap、またはインポートの [スナップ許容差])</translation>
    </message>
    <message>
        <source>every combination of the positions; missing points can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>位置のすべての組み合わせ。欠測点は補填または除外できます (--fill、--crop、またはインポートの [欠測点])</translation>
    </message>
    <message>
        <source>{expected}; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>{expected}。値のない点は補填または除外できます (--fill、--crop、またはインポートの [欠測点])</translation>
    </message>
    <message>
        <source>a height with decimals; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>小数の高さ。値のない点は補填または除外できます (--fill、--crop、またはインポートの [欠測点])</translation>
    </message>
    <message>
        <source>every combination of the positions</source>
        <translation>位置のすべての組み合わせ</translation>
    </message>
    <message>
        <source>parameter 1020 of the axis shows the commanded position with the compensation in it</source>
        <translation>軸のパラメータ 1020 は、補正を含む指令位置を示します</translation>
    </message>
    <message>
        <source>at most {most} for older kernels</source>
        <translation>古いカーネルでは {most} 以下</translation>
    </message>
    <message>
        <source>the table has {count} points; older kernels take at most {most}</source>
        <translation>テーブルは {count} 点です。古いカーネルの上限は {most} 点です</translation>
    </message>
    <message>
        <source>unit of the positions, in place of what the header says</source>
        <translation>位置の単位 (ヘッダの記述より優先)</translation>
    </message>
    <message>
        <source>unit of the values, in place of what the header says</source>
        <translation>値の単位 (ヘッダの記述より優先)</translation>
    </message>
    <message>
        <source>{number} ({name}, axes: {axes})</source>
        <translation>{number} ({name}、軸: {axes})</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>{slot} is empty: there is nothing to delete</source>
        <translation>{slot} は空です。削除するものはありません</translation>
    </message>
    <message>
        <source>axis {axis} uses no table: there is nothing to delete</source>
        <translation>軸 {axis} はテーブルを使用していません。削除するものはありません</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}: name another slot, or none, and a free one is chosen</source>
        <translation>スロット {slot} は {user} が使用しています。別のスロットを指定するか、指定せずに空きスロットを選ばせてください</translation>
    </message>
    <message>
        <source>the table in {slot} is not deleted, because {user} uses it; free it there first</source>
        <translation>{slot} のテーブルは {user} が使用しているため削除しません。先にそちらで解放してください</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: that one is deleted too.</source>
        <translation>{slot} のフラッシュに以前のテーブルが残っている可能性があります。それも削除します。</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved before {slot} is emptied: otherwise {axis} could look for the deleted table after a reboot.</source>
        <translation>{slot} を空にする前に、全軸のパラメータを保存します。保存しないと、再起動後に {axis} が削除したテーブルを探すことがあります。</translation>
    </message>
    <message>
        <source>After a reboot {axis} uses the table in {slot} again, as its saved parameters say.</source>
        <translation>再起動すると、保存されたパラメータに従って {axis} は再び {slot} のテーブルを使用します。</translation>
    </message>
    <message>
        <source>the configuration has {unit} for axis {axis}, but the axis of the drive has {other}</source>
        <translation>構成では軸 {axis} の単位が {unit} ですが、ドライブの軸の単位は {other} です</translation>
    </message>
    <message>
        <source>the profile has no slot {slot}</source>
        <translation>プロファイルにスロット {slot} がありません</translation>
    </message>
    <message>
        <source>the station {station} has no register {path}</source>
        <translation>ステーション {station} にレジスタ {path} がありません</translation>
    </message>
    <message>
        <source>the unit is {unit}, but the axis that is written has {other}</source>
        <translation>単位が {unit} ですが、書き込み先の軸の単位は {other} です</translation>
    </message>
    <message>
        <source>which station of {file} is meant is not certain; name one of: {known}</source>
        <translation>{file} のどのステーションか判別できません。次のいずれかを指定してください: {known}</translation>
    </message>
    <message>
        <source>it is not a text in UTF-8</source>
        <translation>UTF-8 のテキストではありません</translation>
    </message>
    <message>
        <source>it is not an XML document</source>
        <translation>XML 文書ではありません</translation>
    </message>
    <message>
        <source>it ends before {name} ends</source>
        <translation>{name} が終わる前にファイルが終わっています</translation>
    </message>
    <message>
        <source>a tag is not well-formed</source>
        <translation>タグが整形式ではありません</translation>
    </message>
    <message>
        <source>{name} ends where it has not begun</source>
        <translation>{name} が、始まっていない所で終わっています</translation>
    </message>
    <message>
        <source>it has changed since it was read; export again</source>
        <translation>読み取り後に変更されました。もう一度エクスポートしてください</translation>
    </message>
    <message numerus="yes">
        <source>{count} more comment lines</source>
        <comment>1 more comment line</comment>
        <translation>
            <numerusform>ほかにコメント {count} 行</numerusform>
        </translation>
    </message>
    <message>
        <source>at most 1 MiB of comments</source>
        <translation>コメントは 1 MiB 以下</translation>
    </message>
    <message>
        <source>The drive looks up where it should, but adds nothing while it evaluates. Activate to prove what it adds.</source>
        <translation>ドライブの参照位置は正しいですが、試算中は何も加算しません。加算量を検証するには有効化してください。</translation>
    </message>
    <message>
        <source>it has nothing of axis {axis}</source>
        <translation>軸 {axis} の内容がありません</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: {percent} of the travel of axis {axis}, {low} to {high}. Beyond the table the drive holds the value of its end.</source>
        <translation>テーブルの次元 {number} の範囲は {first} から {last} で、軸 {axis} のストローク {low} から {high} の {percent} です。テーブルの外では、ドライブは端点値を保持します。</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: outside the travel of axis {axis}, {low} to {high}. The drive holds the value of one end everywhere.</source>
        <translation>テーブルの次元 {number} の範囲 {first} から {last} は、軸 {axis} のストローク {low} から {high} の外です。ドライブは常に一方の端点値を保持します。</translation>
    </message>
    <message>
        <source>The backup is of another drive, the one with the serial number {number}.</source>
        <translation>別のドライブ (シリアル番号 {number}) のバックアップです。</translation>
    </message>
    <message>
        <source>a full {dimensions}D grid of {points} points</source>
        <translation>{points} 点がそろった {dimensions}D 格子</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid measurement: {count} problems</source>
        <comment>{file} is not a valid measurement: one problem</comment>
        <translation>
            <numerusform>{file} は有効な測定ファイルではありません: 問題 {count} 件</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} does not say its units; state them with --unit and --value-unit</source>
        <translation>{file} に単位が示されていません。--unit と --value-unit で指定してください</translation>
    </message>
    <message>
        <source>the positions in {file} do not follow one another one to one</source>
        <translation>{file} の位置どうしが 1 対 1 で対応していません</translation>
    </message>
    <message>
        <source>{file} has no targets; the figures of the standard need a measurement of runs over targets</source>
        <translation>{file} には目標位置がありません。規格の特性値には、目標位置での走行の測定が必要です</translation>
    </message>
    <message>
        <source>an error in mm</source>
        <translation>mm 単位の誤差</translation>
    </message>
    <message>
        <source>a position without a bidirectional mean</source>
        <translation>両方向の平均がない位置</translation>
    </message>
    <message>
        <source>the same positions in both blocks</source>
        <translation>両ブロックに同じ位置</translation>
    </message>
    <message>
        <source>no block of a direction</source>
        <translation>方向別のブロックなし</translation>
    </message>
    <message>
        <source>a block Forward Directional Avg Error; the mean of both directions alone says nothing of either</source>
        <translation>Forward Directional Avg Error のブロック。両方向の平均だけでは、それぞれの方向は分かりません</translation>
    </message>
    <message>
        <source>means of a linear measurement (.pos)</source>
        <translation>長さの測定の平均値 (.pos)</translation>
    </message>
    <message>
        <source>TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= or KEY=</source>
        <translation>TGT_DATA[i]=、REF_DATA_FWD[i,j]=、REF_DATA_BWD[i,j]= またはキー=</translation>
    </message>
    <message>
        <source>the position of a target</source>
        <translation>目標位置の座標</translation>
    </message>
    <message>
        <source>a second target {number}</source>
        <translation>2 つ目の目標位置 {number}</translation>
    </message>
    <message>
        <source>each target once</source>
        <translation>各目標位置は 1 回だけ</translation>
    </message>
    <message>
        <source>a position of the reference</source>
        <translation>基準の位置</translation>
    </message>
    <message>
        <source>{key}: {said}, but {found} are there</source>
        <translation>{key} では {said}、実際は {found}</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>ファイル全体</translation>
    </message>
    <message>
        <source>a length or an angle: mm, um, m, inch, deg, arcsec, mrad</source>
        <translation>長さまたは角度: mm、um、m、inch、deg、arcsec、mrad</translation>
    </message>
    <message>
        <source>the number of a target, TGT_DATA[{number}]=</source>
        <translation>目標位置の番号 TGT_DATA[{number}]=</translation>
    </message>
    <message>
        <source>data of an ISO 230-2 test</source>
        <translation>ISO 230-2 試験のデータ</translation>
    </message>
    <message>
        <source>a head such as i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</source>
        <translation>i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]| のような見出し</translation>
    </message>
    <message>
        <source>a position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>{value}, as the head of the table has</source>
        <translation>表の見出しと同じ {value}</translation>
    </message>
    <message>
        <source>a report by a program that is known to print forward and backward the other way round</source>
        <translation>往路と復路を逆に出力することが知られているプログラムの報告書</translation>
    </message>
    <message>
        <source>report of an ISO 230-2 test, with its results</source>
        <translation>ISO 230-2 試験の報告書 (結果を含む)</translation>
    </message>
    <message>
        <source>a line with the names of the columns, such as target [mm]</source>
        <translation>target [mm] などの列名の行</translation>
    </message>
    <message>
        <source>no column {column} for {role}</source>
        <translation>{role}の列 {column} なし</translation>
    </message>
    <message numerus="yes">
        <source>the name of a column, or its number from 1 to {count}</source>
        <comment>the name of the column, or 1</comment>
        <translation>
            <numerusform>列名、または 1 から {count} までの列番号</numerusform>
        </translation>
    </message>
    <message>
        <source>two columns for {role}</source>
        <translation>{role}の列が 2 つ</translation>
    </message>
    <message>
        <source>one; name the columns with --columns</source>
        <translation>1 つ。--columns で列を指定してください</translation>
    </message>
    <message>
        <source>a column for {role}</source>
        <translation>{role}の列</translation>
    </message>
    <message>
        <source>one of these words before the =: {known}</source>
        <translation>= の前に次のいずれかの語: {known}</translation>
    </message>
    <message>
        <source>a unit in brackets behind the name, such as {example}, or --unit and --value-unit</source>
        <translation>{example} のように名前の後に括弧書きの単位、または --unit と --value-unit</translation>
    </message>
    <message>
        <source>column {column}</source>
        <translation>列 {column}</translation>
    </message>
    <message>
        <source>the unit {unit} of column {column}</source>
        <translation>列 {column} の単位 {unit}</translation>
    </message>
    <message>
        <source>an angle as the targets are</source>
        <translation>目標位置と同じく角度</translation>
    </message>
    <message>
        <source>a length as the targets are</source>
        <translation>目標位置と同じく長さ</translation>
    </message>
    <message>
        <source>corrected: none, or corrected: 20C</source>
        <translation>corrected: none または corrected: 20C</translation>
    </message>
    <message>
        <source>values: deviation, or values: reference</source>
        <translation>values: deviation または values: reference</translation>
    </message>
    <message>
        <source>sign: deviation (reference minus target), or sign: correction (its opposite)</source>
        <translation>sign: deviation (基準 − 目標位置) または sign: correction (その逆)</translation>
    </message>
    <message>
        <source>a temperature in deg C, such as 20.4</source>
        <translation>20.4 のような温度 (deg C)</translation>
    </message>
    <message>
        <source>a coefficient of expansion in 1/K, such as 11.5e-6</source>
        <translation>11.5e-6 のような膨張係数 (1/K)</translation>
    </message>
    <message>
        <source>compensation: off, on, or crc: with the checksum of the table, such as crc:1c291ca3</source>
        <translation>compensation: off、on、または crc:1c291ca3 のような crc: とテーブルのチェックサム</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names no columns; write target=1,direction=3,deviation=5, with numbers or names of columns</source>
        <translation>&quot;{text}&quot; は列の指定ではありません。target=1,direction=3,deviation=5 のように、列の番号または名前で指定してください</translation>
    </message>
    <message>
        <source>no columns X and Y</source>
        <translation>列 X と Y なし</translation>
    </message>
    <message>
        <source>columns X and Y, or X, Y and Z, with the positions</source>
        <translation>位置を示す列 X と Y、または X と Y と Z</translation>
    </message>
    <message>
        <source>no column of values</source>
        <translation>値の列なし</translation>
    </message>
    <message>
        <source>at least one behind the positions, such as dX [um]</source>
        <translation>位置の後に、dX [um] のような列が 1 つ以上</translation>
    </message>
    <message>
        <source>a line for each point</source>
        <translation>点ごとに 1 行</translation>
    </message>
    <message>
        <source>CSV of values at positions of 2 or 3 axes</source>
        <translation>2 軸または 3 軸の位置での値の CSV</translation>
    </message>
    <message>
        <source>run, number of the target and deviation, such as 1 1 0.21</source>
        <translation>1 1 0.21 のような走行、目標位置の番号、偏差</translation>
    </message>
    <message>
        <source>a deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>1 以上の整数</translation>
    </message>
    <message numerus="yes">
        <source>a number from 1 to {count}, as there are targets</source>
        <comment>1, the only target</comment>
        <translation>
            <numerusform>目標位置の数に合わせた 1 から {count} までの番号</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole file; save it again from the instrument&apos;s software</source>
        <translation>ファイル全体。測定器のソフトウェアから保存し直してください</translation>
    </message>
    <message>
        <source>File type: rtl or rta, which says the units</source>
        <translation>File type: rtl または rta (単位を示す)</translation>
    </message>
    <message>
        <source>sections TARGET DATA:: and DEVIATIONS:: with their numbers</source>
        <translation>数値を含むセクション TARGET DATA:: と DEVIATIONS::</translation>
    </message>
    <message numerus="yes">
        <source>{count} runs of a unidirectional file that are exactly 0 throughout</source>
        <comment>1 run of a unidirectional file that is exactly 0 throughout</comment>
        <translation>
            <numerusform>一方向のファイルで、値がすべてちょうど 0 の走行 {count} 回</numerusform>
        </translation>
    </message>
    <message>
        <source>a run whose target numbers rise or fall throughout</source>
        <translation>目標位置の番号が増え続ける、または減り続ける走行</translation>
    </message>
    <message>
        <source>linear and angular measurements (.rtl, .rta)</source>
        <translation>長さと角度の測定 (.rtl、.rta)</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times smaller, as um for mm</source>
        <translation>基準の単位が 1000 分の 1 です (mm に対する um など)</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times larger, as m for mm</source>
        <translation>基準の単位が 1000 倍です (mm に対する m など)</translation>
    </message>
    <message>
        <source>the reference is in mm and the encoder in inch</source>
        <translation>基準が mm で、エンコーダがインチです</translation>
    </message>
    <message>
        <source>the reference is in inch and the encoder in mm</source>
        <translation>基準がインチで、エンコーダが mm です</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts half</source>
        <translation>干渉計の係数が誤っています。半分に数えています</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts double</source>
        <translation>干渉計の係数が誤っています。2 倍に数えています</translation>
    </message>
    <message>
        <source>the reference is in degrees and the encoder in radians</source>
        <translation>基準が度で、エンコーダがラジアンです</translation>
    </message>
    <message>
        <source>the reference is in radians and the encoder in degrees</source>
        <translation>基準がラジアンで、エンコーダが度です</translation>
    </message>
    <message>
        <source>the instrument counts the other way; if so, say it with --invert-reference</source>
        <translation>測定器の計数方向が逆です。その場合は --invert-reference を指定してください</translation>
    </message>
    <message>
        <source>1; {meaning}: correct the file, or state the unit of the reference with --value-unit, and that of the other positions with --unit</source>
        <translation>1。{meaning}: ファイルを修正するか、基準の単位を --value-unit で、他の位置の単位を --unit で指定してください</translation>
    </message>
    <message>
        <source>1 within 1 %; check which columns are reference and encoder, and their units</source>
        <translation>1 (誤差 1 % 以内)。どの列が基準とエンコーダかと、それらの単位を確認してください</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets</source>
        <comment>1 target</comment>
        <translation>
            <numerusform>目標位置 {count} か所</numerusform>
        </translation>
    </message>
    <message>
        <source>at least 2 different positions that the axis was sent to</source>
        <translation>軸を位置決めした、2 つ以上の異なる位置</translation>
    </message>
    <message>
        <source>target {target}, {direction}, run {run} in line {first} and in line {second}</source>
        <translation>目標位置 {target}、{direction}、走行 {run} が行 {first} と行 {second} に重複</translation>
    </message>
    <message>
        <source>{up} up and {down} down</source>
        <translation>正方向 {up}、負方向 {down}</translation>
    </message>
    <message>
        <source>as many in each direction</source>
        <translation>各方向で同じ数</translation>
    </message>
    <message numerus="yes">
        <source>no value for {places} ({count} are missing)</source>
        <comment>no value for {places}</comment>
        <translation>
            <numerusform>{places} の値がない ({count} 個が欠落)</numerusform>
        </translation>
    </message>
    <message>
        <source>a value for every target in every run</source>
        <translation>すべての走行の全目標位置に値</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the target</source>
        <translation>目標位置に対して傾き {slope} で増える値</translation>
    </message>
    <message>
        <source>deviations, which hardly follow it</source>
        <translation>目標位置にほとんど依存しない偏差</translation>
    </message>
    <message>
        <source>a largest deviation of {value} over {travel}</source>
        <translation>{travel} に対して最大偏差 {value}</translation>
    </message>
    <message>
        <source>more than a billionth of the travel</source>
        <translation>移動量の 10 億分の 1 を超える値</translation>
    </message>
    <message>
        <source>at most 1 % of the travel</source>
        <translation>移動量の 1 % 以下</translation>
    </message>
    <message>
        <source>the reference moves {slope} times as far as the axis</source>
        <translation>基準の動きが軸の {slope} 倍です</translation>
    </message>
    <message>
        <source>no column target</source>
        <translation>列 target なし</translation>
    </message>
    <message>
        <source>a column target, or which column it is: --columns &apos;target=1,direction=2,...&apos;</source>
        <translation>列 target、または該当する列の指定: --columns &apos;target=1,direction=2,...&apos;</translation>
    </message>
    <message>
        <source>no column direction</source>
        <translation>列 direction なし</translation>
    </message>
    <message>
        <source>a column direction with + and -, or --direction-from order when the runs rise and fall</source>
        <translation>+ と - の列 direction、または走行が増減する場合は --direction-from order</translation>
    </message>
    <message>
        <source>neither deviation nor reference</source>
        <translation>deviation も reference もない</translation>
    </message>
    <message>
        <source>both deviation and reference</source>
        <translation>deviation と reference の両方</translation>
    </message>
    <message>
        <source>either a column deviation (reference minus target) or a column reference (position)</source>
        <translation>列 deviation (基準 − 目標位置) または列 reference (位置) のどちらか</translation>
    </message>
    <message>
        <source>+ or -, up or down, forward or backward</source>
        <translation>+ または -、up または down、forward または backward</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>行 {line}</translation>
    </message>
    <message>
        <source>at least two targets one after the other in each run, so that its direction shows</source>
        <translation>方向が分かるように、各走行に連続した 2 つ以上の目標位置</translation>
    </message>
    <message>
        <source>CSV with a line for each value</source>
        <translation>値ごとに 1 行の CSV</translation>
    </message>
    <message>
        <source>no column encoder</source>
        <translation>列 encoder なし</translation>
    </message>
    <message>
        <source>no column reference</source>
        <translation>列 reference なし</translation>
    </message>
    <message>
        <source>columns encoder and reference</source>
        <translation>列 encoder と列 reference</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples</source>
        <comment>1 sample</comment>
        <translation>
            <numerusform>サンプル {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>at least {count} samples of an axis that moves</source>
        <translation>動いている軸のサンプル {count} 個以上</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples after turns, until the axis had moved {overrun}</source>
        <comment>1 sample after a turn, until the axis had moved {overrun}</comment>
        <translation>
            <numerusform>反転後、軸が {overrun} 動くまでのサンプル {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>CSV of encoder and reference positions without targets</source>
        <translation>目標位置のないエンコーダと基準の位置の CSV</translation>
    </message>
    <message>
        <source>columns of runs that are either deviations or positions</source>
        <translation>偏差か位置かが分からない走行の列</translation>
    </message>
    <message>
        <source>a column target before those of the runs</source>
        <translation>走行の列の前に列 target</translation>
    </message>
    <message>
        <source>CSV with a line for each target</source>
        <translation>目標位置ごとに 1 行の CSV</translation>
    </message>
    <message>
        <source>angles do not change with temperature or air: the correction is for lengths</source>
        <translation>角度は温度や空気によって変わりません。この補正は長さのためのものです</translation>
    </message>
    <message>
        <source>the file says that its values are corrected to 20 deg C already; correcting them again would make them wrong</source>
        <translation>ファイルによると、値はすでに 20 deg C に補正済みです。再度補正すると誤った値になります</translation>
    </message>
    <message>
        <source>a temperature is in deg C and a coefficient of expansion in 1/K, such as 22.5 and 11.5e-6</source>
        <translation>温度は deg C、膨張係数は 1/K で指定してください (例: 22.5 と 11.5e-6)</translation>
    </message>
    <message>
        <source>a dead path is a length in mm between the interferometer and the reflector, at most 100 m</source>
        <translation>デッドパスは干渉計と反射鏡の間の長さ (mm) で、100 m 以下です</translation>
    </message>
    <message>
        <source>there is no such air on the dead path: pressure is in kPa (50 to 120), temperature in deg C (-40 to 60), humidity in percent (0 to 100)</source>
        <translation>デッドパスの空気の状態が範囲外です。気圧は kPa (50 から 120)、温度は deg C (-40 から 60)、湿度は % (0 から 100) です</translation>
    </message>
    <message>
        <source>{file} does not describe a dead path: {reason}</source>
        <translation>{file} はデッドパスの記述ではありません: {reason}</translation>
    </message>
    <message>
        <source>the air of run {run} {direction} is not known; the dead path needs pressure, temperature and humidity of every run</source>
        <translation>走行 {run} ({direction}) の空気の状態が不明です。デッドパスには全走行の気圧、温度、湿度が必要です</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>負でない数値</translation>
    </message>
    <message>
        <source>the uncertainty budget is wrong: {reason}</source>
        <translation>不確かさバジェットに誤りがあります: {reason}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no angle; write a number that is not negative and its unit, such as 5arcsec</source>
        <translation>&quot;{text}&quot; は角度ではありません。5arcsec のように、負でない数値と単位を入力してください</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no length; write a number that is not negative and its unit, such as 10um</source>
        <translation>&quot;{text}&quot; は長さではありません。10um のように、負でない数値と単位を入力してください</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no tolerance; write a figure and its limit, such as A=10um; the figures are A, A+, A-, R, R+, R-, E, E+, E-, B, Bm and M</source>
        <translation>&quot;{text}&quot; は許容値ではありません。A=10um のように、特性値とその上限を入力してください。特性値は A、A+、A-、R、R+、R-、E、E+、E-、B、Bm、M です</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names nothing that can be excluded; write down:1:1 for a value (direction, target, run), run:up:3 or target:7</source>
        <translation>&quot;{text}&quot; は除外の指定ではありません。値 (方向、目標位置、走行) は down:1:1、走行は run:up:3、目標位置は target:7 のように入力してください</translation>
    </message>
    <message>
        <source>there is no value {exclusion}: the measurement has {targets} targets, {up} runs up and {down} runs down</source>
        <translation>値 {exclusion} はありません。測定の目標位置は {targets} か所、正方向の走行は {up} 回、負方向の走行は {down} 回です</translation>
    </message>
    <message>
        <source>only runs over targets can be joined; one file has {kind}</source>
        <translation>結合できるのは目標位置での走行だけです。{kind}のファイルがあります</translation>
    </message>
    <message>
        <source>a measurement of lengths and one of angles cannot be joined</source>
        <translation>長さの測定と角度の測定は結合できません</translation>
    </message>
    <message>
        <source>measurements with different tables, or with and without compensation, cannot be joined</source>
        <translation>テーブルが異なる測定、または補正ありと補正なしの測定は結合できません</translation>
    </message>
    <message>
        <source>these positions cannot tell an error with the period {period}: they lie in {filled} of {classes} equal parts of the period, and {fewest} are needed; measure at targets that are spread over the period (axiscomp targets --period), or leave the period out</source>
        <translation>これらの位置では周期 {period} の誤差を検出できません。周期を {classes} 等分した区間のうち {filled} 区間にしか位置がなく、{fewest} 区間が必要です。周期全体に分散した目標位置 (axiscomp targets --period) で測定するか、周期を指定しないでください</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of the grid, at {region}, are more than {distances} distances away from any measured point; measure there, take a smaller grid, or let them be filled (--fill smooth or --fill nearest)</source>
        <comment>one point of the grid, at {region}, is more than {distances} distances away from any measured point; measure there, take a smaller grid, or let it be filled (--fill smooth or --fill nearest)</comment>
        <translation>
            <numerusform>{region} の格子点 {count} 個が、どの測定点からも格子間隔 {distances} 個分を超えて離れています。そこを測定するか、格子を小さくするか、補填を指定してください (--fill smooth または --fill nearest)</numerusform>
        </translation>
    </message>
    <message>
        <source>the computation did not come to an end: {reason}</source>
        <translation>計算が完了しませんでした: {reason}</translation>
    </message>
    <message>
        <source>each position must have one value and one weight</source>
        <translation>位置ごとに値と重みが 1 つずつ必要です</translation>
    </message>
    <message>
        <source>positions, values and weights must be finite numbers</source>
        <translation>位置、値、重みは有限の数値にしてください</translation>
    </message>
    <message>
        <source>weights must be larger than 0</source>
        <translation>重みは 0 より大きくしてください</translation>
    </message>
    <message>
        <source>the period of a modulo axis must be a number above 0</source>
        <translation>モジュロ軸の周期は 0 より大きい数値にしてください</translation>
    </message>
    <message>
        <source>there are values at {count} positions; this method needs {fewest}, measure more of them or choose another method</source>
        <translation>値のある位置が {count} か所です。この方法には {fewest} か所必要です。測定点を増やすか、別の方法を選んでください</translation>
    </message>
    <message>
        <source>the number of harmonics must be 1 to 1000</source>
        <translation>高調波の数は 1 から 1000 までです</translation>
    </message>
    <message>
        <source>a period has at least one harmonic</source>
        <translation>周期には 1 つ以上の高調波が必要です</translation>
    </message>
    <message>
        <source>a period must be a number above 0</source>
        <translation>周期は 0 より大きい数値にしてください</translation>
    </message>
    <message>
        <source>the period {period} is wanted twice, by itself or as a harmonic of another; give each once</source>
        <translation>周期 {period} が、それ自身またはほかの周期の高調波として 2 回指定されています。それぞれ 1 回だけ指定してください</translation>
    </message>
    <message>
        <source>the period {period} does not divide the turn of {turn}; on a modulo axis it must</source>
        <translation>周期 {period} では 1 回転 {turn} が割り切れません。モジュロ軸では割り切れる必要があります</translation>
    </message>
    <message>
        <source>the smoothness must be a number above 0</source>
        <translation>平滑度は 0 より大きい数値にしてください</translation>
    </message>
    <message>
        <source>a smoothness of {smoothness} cannot be computed for these positions; take a smaller one</source>
        <translation>これらの位置では平滑度 {smoothness} を計算できません。小さくしてください</translation>
    </message>
    <message>
        <source>a grid has one to three dimensions, with two points and a distance above 0 in each</source>
        <translation>格子は 1 から 3 次元で、各次元に 2 点以上と 0 より大きい間隔が必要です</translation>
    </message>
    <message>
        <source>points need one finite number for each dimension, for their value and for their weight</source>
        <translation>点には、各次元の座標、値、重みとして有限の数値が 1 つずつ必要です</translation>
    </message>
    <message>
        <source>the smoothness must be a number of 0 or more</source>
        <translation>平滑度は 0 以上の数値にしてください</translation>
    </message>
    <message>
        <source>{axis} {from} to {to}</source>
        <translation>{axis} {from} から {to}</translation>
    </message>
    <message>
        <source>with a smoothness of 0 every point of the grid needs a measured one beside it, and {count} have none; take a larger smoothness or a coarser grid</source>
        <translation>平滑度 0 では、すべての格子点の隣に測定点が必要ですが、{count} 点にはありません。平滑度を大きくするか、格子を粗くしてください</translation>
    </message>
    <message>
        <source>no point lies within the grid; check its start and end, and the unit of the positions</source>
        <translation>格子の中に点がありません。格子の始点と終点、位置の単位を確認してください</translation>
    </message>
    <message>
        <source>the points do not determine every point of the grid; take a larger smoothness or a coarser grid</source>
        <translation>これらの点だけでは決まらない格子点があります。平滑度を大きくするか、格子を粗くしてください</translation>
    </message>
    <message>
        <source>the points lie too unevenly for so little smoothness; take a larger smoothness or a coarser grid</source>
        <translation>この小さな平滑度に対して点の分布が不均一すぎます。平滑度を大きくするか、格子を粗くしてください</translation>
    </message>
    <message>
        <source>the table that was active has other sources than the table that is made</source>
        <translation>有効だったテーブルと作成するテーブルのソースが異なります</translation>
    </message>
    <message>
        <source>a table has one to three dimensions</source>
        <translation>テーブルは 1 から 3 次元です</translation>
    </message>
    <message>
        <source>the tables that were active move their axes too much for their raw position to be found; check the unit of their values</source>
        <translation>有効だったテーブルによる軸の動きが大きすぎて、補正前の位置が求まりません。値の単位を確認してください</translation>
    </message>
    <message>
        <source>Column {column} of the file has positions in {unit}, but its source {source} is a temperature.</source>
        <translation>ファイルの列 {column} は {unit} の位置ですが、そのソース {source} は温度です。</translation>
    </message>
    <message>
        <source>Column {column} of the file is named as an axis, but its source {source} is a temperature.</source>
        <translation>ファイルの列 {column} は軸の名前ですが、そのソース {source} は温度です。</translation>
    </message>
    <message>
        <source>Column {column} of the file has temperatures, but its source {source} is a position.</source>
        <translation>ファイルの列 {column} は温度ですが、そのソース {source} は位置です。</translation>
    </message>
    <message>
        <source>Column {column} of the file is not named as axis {axis}, whose position its source {source} is.</source>
        <translation>ファイルの列 {column} の名前が、そのソース {source} の軸 {axis} と一致しません。</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up; keep the table persistent, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>フラッシュからのテーブルの削除もフラッシュ操作です。このドライブのフラッシュ操作の履歴が破損していたため、すべて使い切ったものとみなしています。テーブルを不揮発のままにするか、&apos;axiscomp status --reset-flash-count&apos; で回数をリセットしてください</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for removing the table from flash, but not for putting everything back if it fails; wait {seconds} s, or keep the table persistent</source>
        <translation>残りのフラッシュ操作はフラッシュからのテーブルの削除には足りますが、失敗時にすべてを元に戻すには足りません。{seconds} s 待つか、テーブルを不揮発のままにしてください</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and there were too many of them in a short time; wait {seconds} s, or keep the table persistent</source>
        <translation>フラッシュからのテーブルの削除もフラッシュ操作で、短時間の操作が多すぎます。{seconds} s 待つか、テーブルを不揮発のままにしてください</translation>
    </message>
    <message>
        <source>The table is removed from flash, which is a flash operation too. After a reboot the axis has no table.</source>
        <translation>フラッシュからテーブルを削除します。これもフラッシュ操作です。再起動すると、軸のテーブルはなくなります。</translation>
    </message>
    <message>
        <source>&quot;{range}&quot; is not a range of addresses: {reason}</source>
        <translation>&quot;{range}&quot; はアドレス範囲ではありません: {reason}</translation>
    </message>
    <message>
        <source>write it as {network}, {range} or {address}, with {port} behind it for another port</source>
        <translation>{network}、{range} または {address} のように入力してください。別のポートは後に {port} を付けます</translation>
    </message>
    <message>
        <source>a port is a number from 1 to 65535</source>
        <translation>ポートは 1 から 65535 までの数値です</translation>
    </message>
    <message>
        <source>its last address is before the first</source>
        <translation>最後のアドレスが最初のアドレスより前です</translation>
    </message>
    <message>
        <source>it has {count} addresses, and a search asks {limit} at most: name a part of it</source>
        <translation>アドレスが {count} 個ありますが、1 回の検索は {limit} 個までです。その一部を指定してください</translation>
    </message>
    <message>
        <source>these are no addresses of computers</source>
        <translation>コンピュータのアドレスではありません</translation>
    </message>
    <message>
        <source>the wanted distance must be a number above 0</source>
        <translation>目標の距離は 0 より大きい数値にしてください</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes more than {count} points; with these it is {found}; allow more points or a larger distance</source>
        <translation>曲線からの距離 {distance} には {count} 点を超える点数が必要です。この点数での距離は {found} です。点数または距離の上限を大きくしてください</translation>
    </message>
    <message>
        <source>each point needs a finite position and deviation in two or three dimensions</source>
        <translation>各点には、2 次元または 3 次元の有限の位置と偏差が必要です</translation>
    </message>
    <message>
        <source>the points lie on a line, or on a plane in space, and cannot tell how the artefact lay; measure points beside it</source>
        <translation>点が一直線上、または空間内の一平面上にあり、標準器の置かれ方が求まりません。その外側の点も測定してください</translation>
    </message>
    <message>
        <source>targets and deviations must be finite numbers</source>
        <translation>目標位置と偏差は有限の数値にしてください</translation>
    </message>
    <message>
        <source>there are values at {count} targets; a table needs two</source>
        <translation>値のある目標位置が {count} か所です。テーブルには 2 か所必要です</translation>
    </message>
    <message>
        <source>the target {target} has no value of one direction; measure it, leave the target out, or make the table of the other direction (--direction)</source>
        <translation>目標位置 {target} に片方の方向の値がありません。測定するか、目標位置を除くか、もう一方の方向のテーブルを作成してください (--direction)</translation>
    </message>
    <message>
        <source>known periods are fitted by the method smooth only (--method smooth)</source>
        <translation>既知の周期をフィッティングできるのは smooth だけです (--method smooth)</translation>
    </message>
    <message>
        <source>harmonics need the length of a turn, which is that of a modulo axis</source>
        <translation>高調波にはモジュロ軸の 1 回転の長さが必要です</translation>
    </message>
    <message>
        <source>there is no such method</source>
        <translation>その方法はありません</translation>
    </message>
    <message>
        <source>a modulo axis has no slope that could be removed: it ends where it begins</source>
        <translation>モジュロ軸は始点と終点が同じなので、除去できる傾きはありません</translation>
    </message>
    <message>
        <source>there are values at {count} targets; four are needed to leave one out</source>
        <translation>値のある目標位置が {count} か所です。1 か所を除くには 4 か所必要です</translation>
    </message>
    <message>
        <source>a gain is above 0 and at most 2; it is usually 1</source>
        <translation>ゲインは 0 より大きく 2 以下です。通常は 1 です</translation>
    </message>
    <message>
        <source>{name} has no table whose target is that of the column {column}; state the targets of its tables, or measure without a table</source>
        <translation>{name} には、列 {column} と同じ対象軸のテーブルがありません。テーブルの対象軸を指定するか、テーブルなしで測定してください</translation>
    </message>
    <message>
        <source>all points have the same position along {axis}</source>
        <translation>{axis} の位置が全点で同じです</translation>
    </message>
    <message>
        <source>a grid has at least 2 points along {axis}</source>
        <translation>格子には {axis} に 2 点以上必要です</translation>
    </message>
    <message>
        <source>the distance along {axis} is too small</source>
        <translation>{axis} の間隔が小さすぎます</translation>
    </message>
    <message>
        <source>the grid needs one number, or one for each of the {count} axes</source>
        <translation>格子には数値を 1 つ、または {count} 軸それぞれに 1 つ指定してください</translation>
    </message>
    <message>
        <source>points are fitted on the grid itself, as the drive interpolates it; leave out --method and --period</source>
        <translation>点は、ドライブの補間と同じ格子上で直接フィッティングします。--method と --period は指定しないでください</translation>
    </message>
    <message>
        <source>a track is fitted on the grid itself, or by --method smooth, which known periods (--period) need; leave other methods out</source>
        <translation>連続測定は格子上で直接、または --method smooth でフィッティングします (既知の周期 --period には後者が必要)。ほかの方法は指定しないでください</translation>
    </message>
    <message>
        <source>--robust is for a fit on the grid itself; leave out --robust or --method smooth</source>
        <translation>--robust は格子上で直接フィッティングする場合のものです。--robust または --method smooth を外してください</translation>
    </message>
    <message>
        <source>the figures of the standard need targets; leave --tolerance out</source>
        <translation>規格の特性値には目標位置が必要です。--tolerance は指定しないでください</translation>
    </message>
    <message>
        <source>a home position is that of one axis measured over targets; take --zero first, mean, keep or a position</source>
        <translation>原点位置は、目標位置で測定した 1 軸の場合のものです。--zero first、mean、keep または位置を使ってください</translation>
    </message>
    <message>
        <source>--remove is for points of two or three axes; a track has one</source>
        <translation>--remove は 2 軸または 3 軸の点のためのものです。連続測定は 1 軸です</translation>
    </message>
    <message>
        <source>points have no direction; leave --direction out</source>
        <translation>点には方向がありません。--direction は指定しないでください</translation>
    </message>
    <message>
        <source>the zero needs {count} numbers, one for each axis</source>
        <translation>ゼロ点には {count} 個の数値 (軸ごとに 1 個) が必要です</translation>
    </message>
    <message>
        <source>--remove names an axis that the points do not have</source>
        <translation>--remove に、点にない軸が指定されています</translation>
    </message>
    <message>
        <source>the position of the zero is outside the grid</source>
        <translation>ゼロ点の位置が格子の外にあります</translation>
    </message>
    <message>
        <source>there are no values in this direction</source>
        <translation>この方向の値がありません</translation>
    </message>
    <message>
        <source>--remove, --robust and --fill are for points of two or three axes and for tracks; this measurement has targets along one axis</source>
        <translation>--remove、--robust、--fill は 2 軸または 3 軸の点と連続測定のためのものです。この測定は 1 軸の目標位置によるものです</translation>
    </message>
    <message>
        <source>the measurement is along one axis: give one number for its grid and zero</source>
        <translation>1 軸の測定です。格子とゼロ点には数値を 1 つ指定してください</translation>
    </message>
    <message>
        <source>a smoothness is for the method smooth (--method smooth); the others go through every mean</source>
        <translation>平滑度は smooth のためのものです (--method smooth)。ほかの方法はすべての平均値を通ります</translation>
    </message>
    <message>
        <source>the position {position} of the zero is outside the targets, which go from {from} to {to}</source>
        <translation>ゼロ点の位置 {position} が、目標位置の範囲 {from} から {to} の外にあります</translation>
    </message>
    <message>
        <source>a program for {dialect} cannot move an axis &quot;{axis}&quot;; name one of X, Y, Z, A, B, C, U, V, W (--axis)</source>
        <translation>{dialect} 用のプログラムでは軸 &quot;{axis}&quot; を動かせません。X、Y、Z、A、B、C、U、V、W のいずれかを指定してください (--axis)</translation>
    </message>
    <message>
        <source>a target must lie within {limit} of zero</source>
        <translation>目標位置は 0 から {limit} 以内にしてください</translation>
    </message>
    <message>
        <source>{position} has more than the three decimals that a program prints; choose an end with fewer</source>
        <translation>{position} の小数が、プログラムに出力できる 3 桁を超えています。桁数の少ない端点にしてください</translation>
    </message>
    <message>
        <source>the last target ({to}) must be above the first ({from}); exchange the two, or choose other ends</source>
        <translation>最後の目標位置 ({to}) は最初の目標位置 ({from}) より大きくしてください。両者を入れ替えるか、別の端点にしてください</translation>
    </message>
    <message>
        <source>a period is above 0; leave it out if none is known</source>
        <translation>周期は 0 より大きい値です。不明な場合は指定しないでください</translation>
    </message>
    <message>
        <source>the overrun must be above 0: without it the first target of a run would not be approached in the direction of the run</source>
        <translation>オーバーランは 0 より大きくしてください。0 では、走行の最初の目標位置に走行の方向から近づけません</translation>
    </message>
    <message>
        <source>the overrun has more than three decimals; round it</source>
        <translation>オーバーランの小数が 3 桁を超えています。丸めてください</translation>
    </message>
    <message>
        <source>the feed must be above 0 and at most {most}</source>
        <translation>送り速度は 0 より大きく {most} 以下にしてください</translation>
    </message>
    <message>
        <source>the dwell must be above 0 s and at most {most}: the axis stands still while it is measured</source>
        <translation>ドウェル時間は 0 s より大きく {most} 以下にしてください。その間、軸を停止させて測定します</translation>
    </message>
    <message>
        <source>at least one cycle is needed</source>
        <translation>1 サイクル以上必要です</translation>
    </message>
    <message>
        <source>give the number of targets or their spacing, one of the two</source>
        <translation>目標位置の数または間隔のどちらか一方を指定してください</translation>
    </message>
    <message>
        <source>the spacing must be above 0 and at most the distance of the ends, {range}</source>
        <translation>間隔は 0 より大きく、両端の距離 {range} 以下にしてください</translation>
    </message>
    <message>
        <source>a plan has 2 to {most} targets, not {count}</source>
        <translation>測定計画の目標位置は 2 から {most} か所です。{count} か所は指定できません</translation>
    </message>
    <message>
        <source>{count} targets would be closer than {least}, which three decimals cannot keep uneven; choose fewer</source>
        <translation>目標位置が {count} か所では間隔が {least} より狭く、小数 3 桁では不等間隔を保てません。数を減らしてください</translation>
    </message>
    <message>
        <source>the plan would have more than {most} steps; choose fewer targets or cycles</source>
        <translation>測定計画が {most} ステップを超えます。目標位置またはサイクルを減らしてください</translation>
    </message>
    <message>
        <source>there is no step in it</source>
        <translation>ステップがありません</translation>
    </message>
    <message>
        <source>a plan as axiscomp targets writes it</source>
        <translation>axiscomp targets で作成した測定計画</translation>
    </message>
    <message>
        <source>{found}; expected: {expected}</source>
        <translation>{found}。必要: {expected}</translation>
    </message>
    <message>
        <source>line {line}: {found}; expected: {expected}</source>
        <translation>行 {line}: {found}。必要: {expected}</translation>
    </message>
    <message>
        <source>version 1; a newer version of this program may have written it</source>
        <translation>バージョン 1。より新しいバージョンのプログラムで書かれた可能性があります</translation>
    </message>
    <message>
        <source>a number above 0 with its unit</source>
        <translation>0 より大きい数値と単位</translation>
    </message>
    <message>
        <source>the header {header}</source>
        <translation>ヘッダ {header}</translation>
    </message>
    <message>
        <source>five cells, as the header has</source>
        <translation>ヘッダと同じ 5 つのセル</translation>
    </message>
    <message>
        <source>at most {count} steps</source>
        <translation>{count} ステップ以下</translation>
    </message>
    <message>
        <source>step {step}</source>
        <translation>ステップ {step}</translation>
    </message>
    <message>
        <source>the number of a run, from 1</source>
        <translation>走行の番号 (1 から)</translation>
    </message>
    <message>
        <source>the direction + or -</source>
        <translation>方向 + または -</translation>
    </message>
    <message>
        <source>a position below the target, since the axis moves up</source>
        <translation>目標位置より小さい位置 (軸は正方向に動くため)</translation>
    </message>
    <message>
        <source>a position above the target, since the axis moves down</source>
        <translation>目標位置より大きい位置 (軸は負方向に動くため)</translation>
    </message>
    <message>
        <source>each target once in a run; it has this one already</source>
        <translation>1 回の走行で各目標位置は 1 回だけ。これはすでにあります</translation>
    </message>
    <message>
        <source>the plan is for axis {axis}; the machine has: {known}</source>
        <translation>測定計画は軸 {axis} のものですが、機械の軸は次のとおりです: {known}</translation>
    </message>
    <message>
        <source>the plan and axis {axis} of the machine differ: one is in mm, the other in deg</source>
        <translation>測定計画と機械の軸 {axis} の単位が異なります。一方は mm、もう一方は deg です</translation>
    </message>
    <message>
        <source>the plan needs a feed and a dwell above 0: lines such as // feed: 1000 mm/min and // dwell: 5 s</source>
        <translation>測定計画には 0 より大きい送り速度とドウェル時間が必要です (// feed: 1000 mm/min、// dwell: 5 s のような行)</translation>
    </message>
    <message>
        <source>step {step} of the plan goes to {place}, more than a tenth beyond the travel of axis {axis}, {low} to {high}</source>
        <translation>測定計画のステップ {step} の {place} が、軸 {axis} のストローク {low} から {high} の外に、その 10 分の 1 を超えて出ています</translation>
    </message>
    <message>
        <source>a program needs a machine that plays it (--machine)</source>
        <translation>プログラムには、それを実行する機械が必要です (--machine)</translation>
    </message>
    <message>
        <source>a machine has at least one axis</source>
        <translation>機械には 1 つ以上の軸が必要です</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; is &quot;{nearest}&quot; meant?</source>
        <translation>&quot;{name}&quot; はここでは使えません。&quot;{nearest}&quot; ではありませんか？</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; there is: {known}</source>
        <translation>&quot;{name}&quot; はここでは使えません。使えるもの: {known}</translation>
    </message>
    <message>
        <source>a number from {least} to {most} is expected, not {found}</source>
        <translation>{least} から {most} までの数値が必要ですが、{found} です</translation>
    </message>
    <message>
        <source>a number above 0, at most {most}, is expected, not {found}</source>
        <translation>0 より大きく {most} 以下の数値が必要ですが、{found} です</translation>
    </message>
    <message>
        <source>there are more than {most} waves</source>
        <translation>波が {most} 個を超えています</translation>
    </message>
    <message>
        <source>the travel has more than {most} knots at this distance</source>
        <translation>この間隔では、ストロークの節点が {most} 個を超えます</translation>
    </message>
    <message>
        <source>two numbers are expected: the ends of the travel</source>
        <translation>2 つの数値 (ストロークの両端) が必要です</translation>
    </message>
    <message>
        <source>the first end must be below the second</source>
        <translation>1 つ目の端は 2 つ目の端より小さくしてください</translation>
    </message>
    <message>
        <source>mm or deg is expected</source>
        <translation>mm または deg が必要です</translation>
    </message>
    <message>
        <source>an object with 1 to {most} axes is expected</source>
        <translation>1 から {most} 軸のオブジェクトが必要です</translation>
    </message>
    <message>
        <source>the name of an axis has 1 to {most} characters</source>
        <translation>軸の名前は 1 から {most} 文字です</translation>
    </message>
    <message>
        <source>there is no axis &quot;{name}&quot;; there is: {known}</source>
        <translation>軸 &quot;{name}&quot; はありません。存在する軸: {known}</translation>
    </message>
    <message>
        <source>an axis&apos;s own terms stand with the axis; here are those of others</source>
        <translation>軸自身の項はその軸の中に書きます。ここに書けるのはほかの軸による項です</translation>
    </message>
    <message>
        <source>one of these units is expected: {known}</source>
        <translation>次のいずれかの単位が必要です: {known}</translation>
    </message>
    <message>
        <source>1 or -1 is expected</source>
        <translation>1 または -1 が必要です</translation>
    </message>
    <message>
        <source>there are more than {most} gross errors</source>
        <translation>粗大誤差が {most} 個を超えています</translation>
    </message>
    <message>
        <source>{file} is not a valid record: {reason}</source>
        <translation>{file} は有効な記録ではありません: {reason}</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes at least {sizes} points, more than allowed; allow more points or a larger distance</source>
        <translation>曲線からの距離 {distance} には少なくとも {sizes} 点必要で、許容を超えています。点数または距離の上限を大きくしてください</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}, which at {speed} is a step of the velocity of {step}</source>
        <translation>{axis} に {points} 点: 曲線からの距離は最大 {distance}。点での傾きの変化は最大 {slope} で、{speed} では速度の段差が {step}</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}</source>
        <translation>{axis} に {points} 点: 曲線からの距離は最大 {distance}。点での傾きの変化は最大 {slope}</translation>
    </message>
    <message>
        <source>smoothing needs at least {fewest} positions along {axis}, which has {count}; take the method spline or cubic</source>
        <translation>平滑化には {axis} に {fewest} か所以上の位置が必要ですが、{count} か所です。spline または cubic を使ってください</translation>
    </message>
    <message>
        <source>a SHA-256 of 64 hexadecimal digits is expected</source>
        <translation>16 進 64 桁の SHA-256 が必要です</translation>
    </message>
    <message>
        <source>at least one file is expected</source>
        <translation>1 つ以上のファイルが必要です</translation>
    </message>
    <message>
        <source>what is left out is expected, such as down:1:1, run:up:3 or target:7</source>
        <translation>down:1:1、run:up:3、target:7 のような除外の指定が必要です</translation>
    </message>
    <message>
        <source>the record has version {found}, and this program reads version {known} at most; open it with a newer version of the program</source>
        <translation>記録のバージョンは {found} ですが、このプログラムで読み取れるのは {known} までです。新しいバージョンのプログラムで開いてください</translation>
    </message>
    <message>
        <source>the second measurement was made with the compensation off; activate the table {crc} and measure again</source>
        <translation>2 回目の測定は補正オフで行われています。テーブル {crc} を有効化して測定し直してください</translation>
    </message>
    <message>
        <source>the second measurement was made with the table {found} active, and the record has the table {crc}; activate that one and measure again, or take the record of {found}</source>
        <translation>2 回目の測定ではテーブル {found} が有効でしたが、記録のテーブルは {crc} です。それを有効化して測定し直すか、{found} の記録を使ってください</translation>
    </message>
    <message>
        <source>the second measurement does not say which table was active while it was made; if it was the table {crc}, say it with --measured-with on</source>
        <translation>2 回目の測定に、有効だったテーブルの記載がありません。テーブル {crc} だった場合は、--measured-with on を指定してください</translation>
    </message>
    <message>
        <source>only measurements of runs over targets are compared</source>
        <translation>比較できるのは目標位置での走行の測定だけです</translation>
    </message>
    <message>
        <source>one measurement is of lengths and the other of angles; they are not of the same axis</source>
        <translation>一方は長さ、もう一方は角度の測定で、同じ軸のものではありません</translation>
    </message>
    <message>
        <source>this is no figure of ISO 230-2, such as A or EUp</source>
        <translation>A、EUp のような ISO 230-2 の特性値ではありません</translation>
    </message>
    <message>
        <source>a distance above 0 is expected</source>
        <translation>0 より大きい距離が必要です</translation>
    </message>
    <message>
        <source>numbers of the table&apos;s points are expected, ascending from 0</source>
        <translation>0 以上の昇順のテーブルの点番号が必要です</translation>
    </message>
    <message>
        <source>a table has 1 to 3 axes</source>
        <translation>テーブルは 1 から 3 軸です</translation>
    </message>
    <message>
        <source>{count} values are here, and the grid has {expected} points</source>
        <translation>値が {count} 個ありますが、格子は {expected} 点です</translation>
    </message>
    <message>
        <source>this list has {count} elements, and the others have {expected}</source>
        <translation>このリストの要素は {count} 個ですが、ほかのリストは {expected} 個です</translation>
    </message>
    <message>
        <source>the values have the CRC-32 {found}: they were changed, or the file is damaged</source>
        <translation>値の CRC-32 が {found} です。値が変更されたか、ファイルが破損しています</translation>
    </message>
    <message>
        <source>whole numbers from {least} to {most} are expected, not {found}</source>
        <translation>{least} から {most} までの整数が必要ですが、{found} です</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is neither up nor down</source>
        <translation>&quot;{found}&quot; は up でも down でもありません</translation>
    </message>
    <message>
        <source>there are values without targets</source>
        <translation>目標位置のない値があります</translation>
    </message>
    <message>
        <source>{count} lists are here, and there are {expected} names</source>
        <translation>リストが {count} 個ありますが、名前は {expected} 個です</translation>
    </message>
    <message>
        <source>points have 2 or 3 axes</source>
        <translation>点は 2 軸または 3 軸です</translation>
    </message>
    <message>
        <source>targets are expected to ascend</source>
        <translation>目標位置は昇順にしてください</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is none of: {known}</source>
        <translation>&quot;{found}&quot; は次のいずれでもありません: {known}</translation>
    </message>
    <message>
        <source>the compensation changed in mid-measurement, from {before} to {now}; what was taken belongs to {before}: begin a new file</source>
        <translation>測定の途中で補正が {before} から {now} に変わりました。これまでの値は {before} のものです。新しいファイルで始めてください</translation>
    </message>
    <message>
        <source>the axis stands at {position}; step {step} at {target} is due</source>
        <translation>軸は {position} で停止していますが、次はステップ {step} ({target}) です</translation>
    </message>
    <message>
        <source>{problem}; this is the target of step {other}: move the axis back</source>
        <translation>{problem}。ここはステップ {other} の目標位置です。軸を戻してください</translation>
    </message>
    <message>
        <source>how the axis came to step {step} is not known, as nothing could be read for {time}; go to {approach} and come back</source>
        <translation>{time} の間何も読み取れなかったため、軸がステップ {step} へどう動いたか分かりません。{approach} まで動かしてから戻ってください</translation>
    </message>
    <message>
        <source>the axis came only {way} in the direction of step {step}, less than the overrun of {overrun}; go to {approach} and come back</source>
        <translation>ステップ {step} の方向への移動量が {way} しかなく、オーバーラン {overrun} に足りません。{approach} まで動かしてから戻ってください</translation>
    </message>
    <message>
        <source>step {step} is approached upwards, and the axis did not come from below; go to {approach} and come back</source>
        <translation>ステップ {step} には正方向に近づきますが、軸が小さい側から来ていません。{approach} まで動かしてから戻ってください</translation>
    </message>
    <message>
        <source>step {step} is approached downwards, and the axis did not come from above; go to {approach} and come back</source>
        <translation>ステップ {step} には負方向に近づきますが、軸が大きい側から来ていません。{approach} まで動かしてから戻ってください</translation>
    </message>
    <message>
        <source>the instrument gives no position</source>
        <translation>測定器から位置が得られません</translation>
    </message>
    <message>
        <source>the readings of the instrument differ by {spread}, more than the window of {window}; they are taken again</source>
        <translation>測定器の読み値の差が {spread} で、静止判定幅 {window} を超えています。読み取り直します</translation>
    </message>
    <message>
        <source>it is not an ordinary file</source>
        <translation>通常のファイルではありません</translation>
    </message>
    <message>
        <source>another program is writing measured values to it</source>
        <translation>別のプログラムが測定値を書き込んでいます</translation>
    </message>
    <message>
        <source>it holds something else than captured values; name a new file</source>
        <translation>取り込んだ測定値以外のものが入っています。新しいファイルを指定してください</translation>
    </message>
    <message>
        <source>line {line} has {found} where {expected} is expected; name a new file</source>
        <translation>行 {line} の {found} は {expected} でなければなりません。新しいファイルを指定してください</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>step {step} of the plan, {begin}...</source>
        <translation>測定計画のステップ {step}、{begin}...</translation>
    </message>
    <message>
        <source>there is no font to draw a PDF with: install one, such as fonts-dejavu-core, or write the report as HTML</source>
        <translation>PDF の描画に使うフォントがありません。fonts-dejavu-core などをインストールするか、報告書を HTML で書き出してください</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid machine file: {count} problems</source>
        <comment>{file} is not a valid machine file: one problem</comment>
        <translation>
            <numerusform>{file} は有効な機械ファイルではありません: 問題 {count} 件</numerusform>
        </translation>
    </message>
    <message>
        <source>the old state</source>
        <translation>旧状態</translation>
    </message>
    <message>
        <source>what it is writing at this moment</source>
        <translation>現在書き込み中の内容</translation>
    </message>
    <message>
        <source>values of the tolerance</source>
        <translation>許容差の値</translation>
    </message>
    <message>
        <source>{file} has several tables; name one of them with column: {known}</source>
        <translation>{file} に複数のテーブルがあります。column でいずれかを指定してください: {known}</translation>
    </message>
    <message>
        <source>axis {index} of {drive} (serial number {serial})</source>
        <translation>{drive} (シリアル番号 {serial}) の軸 {index}</translation>
    </message>
    <message>
        <source>axis {index} ({name}) of {drive} (serial number {serial})</source>
        <translation>{drive} (シリアル番号 {serial}) の軸 {index} ({name})</translation>
    </message>
    <message>
        <source>the record is of {recorded}, and this is {found}; begin a record for each axis</source>
        <translation>記録は {recorded} のものですが、これは {found} です。軸ごとに別の記録を作成してください</translation>
    </message>
    <message>
        <source>the record does not say that its table was written: `axiscomp write --record` writes it and notes that</source>
        <translation>記録に、テーブルを書き込んだという記載がありません。`axiscomp write --record` で書き込むと記載されます</translation>
    </message>
    <message>
        <source>the axis has the table {found}, and that of the record is {recorded}: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>軸のテーブルは {found} ですが、記録のテーブルは {recorded} です。記録のテーブルを書き込み直すか (`axiscomp write --record`)、記録を指定しないでください</translation>
    </message>
    <message>
        <source>the register {path} is of type {type}, which is no position</source>
        <translation>レジスタ {path} は {type} 型で、位置ではありません</translation>
    </message>
    <message>
        <source>{path} follows the encoder of the axis itself: name the register of an instrument</source>
        <translation>{path} は軸自身のエンコーダに追従しています。測定器のレジスタを指定してください</translation>
    </message>
    <message>
        <source>since the value before, the axis has moved by {way}, and the instrument says {measured}</source>
        <translation>前の値から軸は {way} 動きましたが、測定器では {measured} です</translation>
    </message>
    <message>
        <source>the instrument says nothing: look whether it sends, and whether its lines end</source>
        <translation>測定器から何も届きません。送信しているか、行末があるかを確認してください</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder, and until now it was {seen} at most: type it once more if it is right, or another number</source>
        <translation>{position} はエンコーダと {difference} 異なります。これまでの差は最大 {seen} でした。正しければもう一度、誤りなら別の数値を入力してください</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder: type it once more if it is right, or another number</source>
        <translation>{position} はエンコーダと {difference} 異なります。正しければもう一度、誤りなら別の数値を入力してください</translation>
    </message>
    <message>
        <source>the position of the instrument is asked for</source>
        <translation>測定器の位置を入力してください</translation>
    </message>
    <message>
        <source>it is one of the files of this measurement; choose another name</source>
        <translation>この測定のファイルの 1 つです。別の名前にしてください</translation>
    </message>
    <message>
        <source>the axis would move from {lowest} to {highest}, and its travel is {low} to {high}: choose other ends, or a smaller overrun</source>
        <translation>軸が {lowest} から {highest} まで動くことになりますが、ストロークは {low} から {high} です。両端を変更するか、オーバーランを小さくしてください</translation>
    </message>
    <message>
        <source>the plan is for axis {planned}, and this is axis {axis}: choose the other axis, or make a plan for this one</source>
        <translation>測定計画は軸 {planned} のものですが、これは軸 {axis} です。軸を選び直すか、この軸の測定計画を作成してください</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is neither on nor off (the drive says {state}): activate or deactivate it first</source>
        <translation>軸 {axis} の補正がオンでもオフでもありません (ドライブの状態: {state})。先に有効化または無効化してください</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is on, and the drive does not say with which table: deactivate it first</source>
        <translation>軸 {axis} の補正はオンですが、どのテーブルかをドライブが示しません。先に無効化してください</translation>
    </message>
    <message>
        <source>the instrument is in {unit}, which cannot be converted to {planned}, the unit of the plan: state the unit of the instrument</source>
        <translation>測定器の単位 {unit} は、測定計画の単位 {planned} に変換できません。測定器の単位を指定してください</translation>
    </message>
    <message>
        <source>no position is asked for at the moment: wait until the axis stands at its target</source>
        <translation>現在、位置の入力待ちではありません。軸が目標位置で停止するまで待ってください</translation>
    </message>
    <message>
        <source>{found}: it counts the other way; begin a new file with the reference inverted</source>
        <translation>{found}。計数方向が逆です。基準を反転する指定で、新しいファイルを始めてください</translation>
    </message>
    <message>
        <source>{found}: its unit or factor is another one, or its zero was set anew, or its beam was interrupted; put that right, or begin a new file with the right unit</source>
        <translation>{found}。単位または係数が違うか、ゼロ点が設定し直されたか、ビームが遮られました。これを直すか、正しい単位で新しいファイルを始めてください</translation>
    </message>
    <message>
        <source>the instrument says {line}, where a number is expected; a pattern says where it is</source>
        <translation>数値が必要ですが、測定器の出力は {line} です。数値の位置をパターンで指定してください</translation>
    </message>
    <message>
        <source>the instrument says {line}: its number has a comma; set it to a decimal point, or say what the number is with a pattern</source>
        <translation>測定器の出力 {line} の数値にカンマがあります。測定器の小数点をピリオドにするか、数値をパターンで指定してください</translation>
    </message>
    <message>
        <source>the instrument says {line} without a unit: state the unit, such as mm</source>
        <translation>測定器の出力 {line} に単位がありません。mm などの単位を指定してください</translation>
    </message>
    <message>
        <source>the instrument says {line}, in another unit than {unit}: set the instrument, or begin a new file with the right unit</source>
        <translation>測定器の出力 {line} の単位が {unit} ではありません。測定器の設定を変えるか、正しい単位で新しいファイルを始めてください</translation>
    </message>
    <message>
        <source>the drive profile does not say which register is the encoder of the axis: name it</source>
        <translation>ドライブプロファイルに、軸のエンコーダのレジスタが示されていません。指定してください</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position before the compensation, which is --lookup-at encoder</source>
        <translation>軸は補正前の位置 {source} でテーブルを参照します。これは --lookup-at encoder に当たります</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position after the compensation, which is --lookup-at set</source>
        <translation>軸は補正後の位置 {source} でテーブルを参照します。これは --lookup-at set に当たります</translation>
    </message>
    <message>
        <source>there are values at {count} points of the grid&apos;s range; {fewest} are needed to choose the smoothness, so give it (--smoothness)</source>
        <translation>格子の範囲で値のある点が {count} 点です。平滑度を自動で選ぶには {fewest} 点必要です。平滑度を指定してください (--smoothness)</translation>
    </message>
    <message>
        <source>the measurement does not say whether a compensation was active while it was made: say that it was off, that it was on, or which table was active (--measured-with off, --measured-with on, or --measured-with and the file of the table)</source>
        <translation>測定に、補正が有効だったかどうかの記載がありません。オフだったか、オンだったか、どのテーブルが有効だったかを指定してください (--measured-with off、--measured-with on、または --measured-with とテーブルのファイル)</translation>
    </message>
    <message>
        <source>the measurement says that it was made with {recorded}, not with {stated}; say nothing else (--measured-with), or take the table that was active</source>
        <translation>測定の記載は {recorded} で、{stated} ではありません。異なる指定 (--measured-with) をやめるか、有効だったテーブルを使ってください</translation>
    </message>
    <message>
        <source>these are residuals of the table {crc}, which was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>これは、測定時に有効だったテーブル {crc} の残差です。ファイルまたはドライブのそのテーブルに統合してください (--onto とファイル、または --onto drive)</translation>
    </message>
    <message>
        <source>these are residuals of a table that was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>これは、測定時に有効だったテーブルの残差です。ファイルまたはドライブのそのテーブルに統合してください (--onto とファイル、または --onto drive)</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, which is not {name} ({known}), nor any other table known; give its file (--measured-with), or merge onto it</source>
        <translation>測定時に有効だったテーブルは {crc} で、{name} ({known}) でも、ほかの既知のテーブルでもありません。そのファイルを指定するか (--measured-with)、そのテーブルに統合してください</translation>
    </message>
    <message>
        <source>it was measured with the compensation off: the values are the whole error, and must not be added to {name}; merge them onto nothing (leave out --onto), or measure with that table active</source>
        <translation>補正オフで測定されたため、値は誤差全体です。{name} に加算してはいけません。統合せずに作成するか (--onto を指定しない)、そのテーブルを有効にして測定してください</translation>
    </message>
    <message>
        <source>at which position the drive looks the table up decides where its values belong: choose the encoder, for a position before the compensation, or the set position, for one after it (--lookup-at encoder or --lookup-at set)</source>
        <translation>値をどの位置に割り当てるかは、ドライブがテーブルを参照する位置で決まります。補正前の位置ならエンコーダ、補正後の位置なら指令位置を選んでください (--lookup-at encoder または --lookup-at set)</translation>
    </message>
    <message>
        <source>how the artefact lay is found from the deviations along all of its axes, but there is no column for {axis}, such as d{axis}; take out nothing (--remove)</source>
        <translation>標準器の置かれ方は全軸の偏差から求めますが、{axis} に d{axis} のような列がありません。除去を指定しないでください (--remove)</translation>
    </message>
    <message>
        <source>the positions along {axis} are no even grid; say the grid of the table: its points, or their distance (--points or --distance)</source>
        <translation>{axis} の位置が等間隔格子になっていません。テーブルの格子を、点数または間隔で指定してください (--points または --distance)</translation>
    </message>
    <message>
        <source>a table over temperature is made of runs with targets along one axis</source>
        <translation>温度依存テーブルは、1 軸の目標位置での走行から作成します</translation>
    </message>
    <message>
        <source>the home position of the axis is not known: give it (--home), or the position of the zero (--zero)</source>
        <translation>軸の原点位置が不明です。原点位置 (--home) またはゼロ点の位置 (--zero) を指定してください</translation>
    </message>
    <message>
        <source>the home position {home} is outside the targets, so that the error there is not known; take the first target for the zero or another position (--zero)</source>
        <translation>原点位置 {home} が目標位置の範囲外で、そこでの誤差が不明です。ゼロ点を最初の目標位置または別の位置にしてください (--zero)</translation>
    </message>
    <message>
        <source>the targets are not evenly spaced; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>目標位置が等間隔ではありません。テーブルの格子を、点数、間隔、または曲線からの許容偏差で指定してください (--points、--distance または --within)</translation>
    </message>
    <message>
        <source>the thermal states span {span}, less than five times the {scatter} by which the temperature varies within them: let the machine settle before each run</source>
        <translation>熱状態の温度の幅が {span} で、各状態の中での変動 {scatter} の 5 倍未満です。走行の前に機械の温度を安定させてください</translation>
    </message>
    <message>
        <source>at {temperature} it was measured from {from} to {to}, at {other} from {otherFrom} to {otherTo}: measure the same range in each thermal state</source>
        <translation>{temperature} では {from} から {to} まで、{other} では {otherFrom} から {otherTo} まで測定されています。どの熱状態でも同じ範囲を測定してください</translation>
    </message>
    <message numerus="yes">
        <source>{count} values have no temperature; a table over temperature needs that of each (the column temperature)</source>
        <comment>1 value has no temperature; a table over temperature needs that of each (the column temperature)</comment>
        <translation>
            <numerusform>{count} 個の値に温度がありません。温度依存テーブルには、すべての値の温度 (列 temperature) が必要です</numerusform>
        </translation>
    </message>
    <message>
        <source>residuals are not merged over temperature: measure with the compensation off</source>
        <translation>温度依存テーブルでは残差を統合できません。補正オフで測定してください</translation>
    </message>
    <message>
        <source>a table over temperature has two dimensions: give at most two numbers for its grid</source>
        <translation>温度依存テーブルは 2 次元です。格子の数値は 2 つまでです</translation>
    </message>
    <message>
        <source>the targets differ from one thermal state to the other, so that they give no grid together; say the grid of the table with --points or --distance</source>
        <translation>目標位置が熱状態ごとに異なり、全体で格子になりません。テーブルの格子を --points または --distance で指定してください</translation>
    </message>
    <message>
        <source>the grid has {count} points, and a table holds {most}; take fewer</source>
        <translation>格子が {count} 点ですが、テーブルの上限は {most} 点です。減らしてください</translation>
    </message>
    <message>
        <source>name the axis as the drive or the control names it, such as X</source>
        <translation>ドライブまたは NC 装置での軸名 (X など) を指定してください</translation>
    </message>
    <message>
        <source>the pattern {pattern} is no regular expression: {problem} at character {place}</source>
        <translation>パターン {pattern} は正規表現ではありません: {place} 文字目の {problem}</translation>
    </message>
    <message>
        <source>the request {text}: behind a backslash r, n, t or another backslash is expected</source>
        <translation>要求 {text}: バックスラッシュの後には r、n、t またはバックスラッシュが必要です</translation>
    </message>
    <message>
        <source>the connection was removed</source>
        <translation>接続が削除されました</translation>
    </message>
    <message>
        <source>its name is one of a program for a control, and a plan in it would mislead the control; choose a name that ends in .csv</source>
        <translation>NC 装置のプログラムの名前です。中身が測定計画では NC 装置が誤認します。.csv で終わる名前にしてください</translation>
    </message>
    <message>
        <source>choose the file of the table that was active</source>
        <translation>有効だったテーブルのファイルを選んでください</translation>
    </message>
    <message>
        <source>its content cannot be used</source>
        <translation>内容を使用できません</translation>
    </message>
    <message>
        <source>{file} cannot be used as the table: {reason}</source>
        <translation>{file} はテーブルとして使用できません: {reason}</translation>
    </message>
    <message>
        <source>there is no axis whose table the residuals could be merged onto; choose one, or take the file of the table</source>
        <translation>残差の統合先となるテーブルをもつ軸がありません。軸を選ぶか、テーブルのファイルを指定してください</translation>
    </message>
    <message>
        <source>the table of the axis is still being read from the drive</source>
        <translation>軸のテーブルをドライブから読み取り中です</translation>
    </message>
    <message>
        <source>a report is PDF or HTML; choose a name that ends in .pdf or .html</source>
        <translation>報告書は PDF または HTML です。.pdf または .html で終わる名前にしてください</translation>
    </message>
    <message>
        <source>all runs were measured in one thermal state; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>すべての走行が 1 つの熱状態で測定されています。温度依存テーブルには、{least} 離れた 2 つ以上の熱状態が必要です ({gap} 以内の走行は同じ状態とみなします)</translation>
    </message>
    <message>
        <source>the runs were measured in {count} thermal states that span {span}; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>走行は {count} つの熱状態 (温度の幅 {span}) で測定されています。温度依存テーブルには、{least} 離れた 2 つ以上の熱状態が必要です ({gap} 以内の走行は同じ状態とみなします)</translation>
    </message>
    <message>
        <source>a table for each direction is made of runs over targets; make those of a track one after the other (--direction positive, then --direction negative)</source>
        <translation>方向別のテーブルは目標位置での走行から作成します。連続測定では 1 つずつ作成してください (--direction positive、続いて --direction negative)</translation>
    </message>
    <message>
        <source>{name} has one value for both directions, and so has what is merged onto it: make the table of the mean (--direction mean)</source>
        <translation>{name} は両方向共通の値なので、統合するものも同じです。平均のテーブルを作成してください (--direction mean)</translation>
    </message>
    <message>
        <source>a table over position and temperature is for a drive, which has one value for both directions (--direction mean)</source>
        <translation>位置と温度のテーブルはドライブ用で、ドライブの値は両方向共通です (--direction mean)</translation>
    </message>
    <message>
        <source>--remove-slope, --turn, --home and --remove-drift are for runs over targets along one axis</source>
        <translation>--remove-slope、--turn、--home、--remove-drift は、1 軸の目標位置での走行のためのものです</translation>
    </message>
    <message>
        <source>the fewest points that leave no more than a deviation (--within) are counted on a curve, which runs have, and a track with --method smooth; say the points of the grid or their distance (--points or --distance)</source>
        <translation>許容偏差以内で最少の点数 (--within) は曲線から求めます。曲線があるのは、走行と --method smooth の連続測定です。格子の点数または間隔を指定してください (--points または --distance)</translation>
    </message>
    <message>
        <source>the name on the drive is {name}</source>
        <translation>ドライブでの名前は {name} です</translation>
    </message>
    <message>
        <source>the first measurement is of axis {before} and the second of axis {after}; they are not of the same axis</source>
        <translation>1 回目の測定は軸 {before}、2 回目の測定は軸 {after} で、同じ軸のものではありません</translation>
    </message>
    <message>
        <source>measurements of axis {axis} and of axis {other} cannot be joined</source>
        <translation>軸 {axis} の測定と軸 {other} の測定は結合できません</translation>
    </message>
    <message>
        <source>the position of the zero is missing</source>
        <translation>ゼロ点の位置がありません</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, lookup: encoder or lookup: set, says for which side of the compensation the table was made: correct that line, or leave it out</source>
        <translation>ファイルに &quot;{note}&quot; とあります。ここでは、テーブルが補正のどちら側の位置用かを lookup: encoder または lookup: set のコメント 1 つで示します。この行を修正または削除してください</translation>
    </message>
    <message>
        <source>these drives make no machine: {problem}</source>
        <translation>これらのドライブから機械を構成できません: {problem}</translation>
    </message>
    <message>
        <source>the connection was ended</source>
        <translation>接続を終了しました</translation>
    </message>
    <message>
        <source>number of the axis, from 0</source>
        <translation>軸の番号 (0 から)</translation>
    </message>
    <message>
        <source>number of the zone of the error map, from 0</source>
        <translation>誤差マップのゾーン番号 (0 から)</translation>
    </message>
    <message>
        <source>how the array is mapped: ERRORMAP1D, or CONNECT with MAP</source>
        <translation>配列のマッピング方法: ERRORMAP1D、または CONNECT と MAP</translation>
    </message>
    <message>
        <source>ERRORMAP1D axis, zone, base, step, array</source>
        <translation>ERRORMAP1D 軸, ゾーン, 始点, 間隔, 配列</translation>
    </message>
    <message>
        <source>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), array, base, step)</source>
        <translation>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), 配列, 始点, 間隔)</translation>
    </message>
    <message>
        <source>a step of {step}</source>
        <translation>間隔 {step}</translation>
    </message>
    <message>
        <source>a step above 0</source>
        <translation>0 より大きい間隔</translation>
    </message>
    <message>
        <source>another map of axis {axis}, besides that of line {line}</source>
        <translation>行 {line} と別の、軸 {axis} のマップ</translation>
    </message>
    <message>
        <source>one map of an axis; both are read, and the program decides which one counts</source>
        <translation>1 軸にマップ 1 つ。両方を読み取ります。どちらを使うかはプログラムによります</translation>
    </message>
    <message>
        <source>no ERRORMAPON {axis}, {zone}</source>
        <translation>ERRORMAPON {axis}, {zone} なし</translation>
    </message>
    <message>
        <source>a statement that switches the map on, which may stand in another program</source>
        <translation>マップをオンにする文 (別のプログラムにあってもよい)</translation>
    </message>
    <message>
        <source>a map over two axes (MAP2)</source>
        <translation>2 軸のマップ (MAP2)</translation>
    </message>
    <message>
        <source>the format {format} to read it</source>
        <translation>読み取るには形式 {format}</translation>
    </message>
    <message>
        <source>a statement ERRORMAP1D, or CONNECT with MAP, of which there is none</source>
        <translation>ERRORMAP1D、または CONNECT と MAP の文 (1 つもない)</translation>
    </message>
    <message>
        <source>the axis must be referenced; the connection replaces an error map of the axis</source>
        <translation>軸は原点復帰済みである必要があります。CONNECT は軸の誤差マップに置き換わります</translation>
    </message>
    <message>
        <source>the axis must be referenced, and a map that is on switched off with ERRORMAPOFF before; ERRORUNMAP {axis}, {zone} removes the map</source>
        <translation>軸は原点復帰済みで、オンのマップは事前に ERRORMAPOFF でオフにする必要があります。ERRORUNMAP {axis}, {zone} でマップを削除できます</translation>
    </message>
    <message>
        <source>program with the error map of an axis (ERRORMAP1D, or CONNECT with MAP)</source>
        <translation>1 軸の誤差マップのプログラム (ERRORMAP1D、または CONNECT と MAP)</translation>
    </message>
    <message>
        <source>number of the axis of the first source of the table, from 0</source>
        <translation>テーブルの第 1 ソースの軸番号 (0 から)</translation>
    </message>
    <message>
        <source>number of the axis of the second source of the table, from 0</source>
        <translation>テーブルの第 2 ソースの軸番号 (0 から)</translation>
    </message>
    <message>
        <source>number of the axis that is compensated, from 0; needed where it is none of the sources</source>
        <translation>補正する軸の番号 (0 から)。ソースのどれでもない場合に必要</translation>
    </message>
    <message>
        <source>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), array, base1, step1, base2, step2)</source>
        <translation>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), 配列, 始点1, 間隔1, 始点2, 間隔2)</translation>
    </message>
    <message>
        <source>a map of one axis ({name})</source>
        <translation>1 軸のマップ ({name})</translation>
    </message>
    <message>
        <source>a statement CONNECT with MAP2, of which there is none</source>
        <translation>CONNECT と MAP2 の文 (1 つもない)</translation>
    </message>
    <message>
        <source>both sources are axis {axis}: {key} and {other}</source>
        <translation>両方のソースが軸 {axis} です: {key} と {other}</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key}, since the table corrects none of its sources</source>
        <translation>テーブルがどのソースも補正しないため、形式 {format} には設定 {key} が必要です</translation>
    </message>
    <message>
        <source>the table goes from {column}, which the settings {key}, {other} and {target} contradict</source>
        <translation>テーブルの対応 {column} が、設定 {key}、{other}、{target} と矛盾します</translation>
    </message>
    <message>
        <source>the axes must be referenced; the connection replaces an error map of axis {axis}</source>
        <translation>各軸は原点復帰済みである必要があります。CONNECT は軸 {axis} の誤差マップに置き換わります</translation>
    </message>
    <message>
        <source>program with the map of an axis over two (MAP2)</source>
        <translation>2 軸の位置による 1 軸のマップのプログラム (MAP2)</translation>
    </message>
    <message>
        <source>a number, or a name that got one before</source>
        <translation>数値、またはそれ以前に数値が代入された名前</translation>
    </message>
    <message>
        <source>one number; other buffers give it another one in line {line}</source>
        <translation>1 つの数値。行 {line} で別のバッファが別の数値を代入しています</translation>
    </message>
    <message>
        <source>a name that got a number; in line {line} it gets something that is not computed here</source>
        <translation>数値が代入された名前。行 {line} の代入はここでは計算しません</translation>
    </message>
    <message>
        <source>a whole number, since it is declared INT; in line {line} it gets another one</source>
        <translation>整数 (INT と宣言されているため)。行 {line} で別の値が代入されています</translation>
    </message>
    <message>
        <source>a number with a decimal point, or a name that got one; expressions are not computed</source>
        <translation>小数点付きの数値、またはそれが代入された名前。式は計算しません</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>0 以上の整数</translation>
    </message>
    <message>
        <source>one index of {name}</source>
        <translation>{name} のインデックス 1 つ</translation>
    </message>
    <message>
        <source>two indices of {name}</source>
        <translation>{name} のインデックス 2 つ</translation>
    </message>
    <message>
        <source>an index of {name}: a whole number from 0</source>
        <translation>{name} のインデックス: 0 以上の整数</translation>
    </message>
    <message>
        <source>a number with a decimal point; expressions are not computed</source>
        <translation>小数点付きの数値。式は計算しません</translation>
    </message>
    <message>
        <source>a whole number, since {name} is declared INT</source>
        <translation>整数 ({name} が INT と宣言されているため)</translation>
    </message>
    <message>
        <source>an array whose elements are numbers in this program</source>
        <translation>このプログラムで要素が数値の配列</translation>
    </message>
    <message>
        <source>{name} with another number of indices</source>
        <translation>インデックスの数が異なる {name}</translation>
    </message>
    <message>
        <source>{sizes}, which its elements need</source>
        <translation>要素に必要な {sizes}</translation>
    </message>
    <message>
        <source>{array} with elements for {sizes}</source>
        <translation>{sizes} の要素がある {array}</translation>
    </message>
    <message>
        <source>a value for each element; the table has those that the program gives, and the controller may use the others as they are</source>
        <translation>すべての要素の値。テーブルにはプログラム内の値だけが入り、残りはコントローラが現在の値のまま使うことがあります</translation>
    </message>
    <message>
        <source>no {element}</source>
        <translation>{element} なし</translation>
    </message>
    <message>
        <source>a number for each element up to the highest index</source>
        <translation>最大のインデックスまでの各要素の数値</translation>
    </message>
    <message>
        <source>{element} a second time</source>
        <translation>{element} が 2 回目</translation>
    </message>
    <message>
        <source>each element once; the last number counts</source>
        <translation>各要素は 1 回だけ。最後の数値を使います</translation>
    </message>
    <message>
        <source>{name}, which is not supported</source>
        <translation>未対応の {name}</translation>
    </message>
    <message>
        <source>ERRORMAP1D, or CONNECT with MAP or MAP2</source>
        <translation>ERRORMAP1D、または CONNECT と MAP または MAP2</translation>
    </message>
    <message>
        <source>name of the array: a letter, then letters, digits and underlines</source>
        <translation>配列の名前: 英字で始まる英字、数字、下線</translation>
    </message>
    <message>
        <source>the program declares the array; no where the controller has it already</source>
        <translation>プログラムで配列を宣言。コントローラで宣言済みの場合は no</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is no name for an array of the format {format}, such as {example}; change the setting {key}</source>
        <translation>&quot;{name}&quot; は形式 {format} の配列名 ({example} など) ではありません。設定 {key} を変更してください</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}; it is a number from 0</source>
        <translation>形式 {format} の設定 {key} が {value} です。0 以上の数値が必要です</translation>
    </message>
    <message>
        <source>the controller must not have declared the array {name} before, since the program declares it; where it has, set declare=no</source>
        <translation>配列 {name} はプログラムで宣言するため、コントローラで宣言しておかないでください。宣言済みの場合は declare=no にしてください</translation>
    </message>
    <message>
        <source>the controller must have declared the array {name}, with as many elements as the program gives it</source>
        <translation>コントローラで配列 {name} を、プログラムの値と同じ要素数で宣言しておく必要があります</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}, and the axis name is &quot;{name}&quot;; give the setting {key}</source>
        <translation>形式 {format} の軸は英字 {letters} のいずれかで表しますが、軸名が &quot;{name}&quot; です。設定 {key} を指定してください</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}; the setting {key} is {value}</source>
        <translation>形式 {format} の軸は英字 {letters} のいずれかで表します。設定 {key} が {value} です</translation>
    </message>
    <message>
        <source>the table is of axis &quot;{name}&quot;, and the setting {key} of the format {format} says {value}</source>
        <translation>テーブルは軸 &quot;{name}&quot; のものですが、形式 {format} の設定 {key} は {value} です</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with the position in each line</source>
        <translation>各行に位置がある補正値テーブル (.COM)</translation>
    </message>
    <message>
        <source>also distances that are no power of two times 0.0001, for an iTNC 530</source>
        <translation>0.0001 の 2 のべき乗倍でない間隔も許容 (iTNC 530 用)</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with even positions</source>
        <translation>等間隔位置の補正値テーブル (.COM)</translation>
    </message>
    <message>
        <source>letter of the axis whose position counts, where its name is none or another one</source>
        <translation>位置を使う軸の英字 (軸名が英字でないか、別の英字の場合)</translation>
    </message>
    <message>
        <source>letter of the axis that is compensated by the position of another one, where its name is none</source>
        <translation>別の軸の位置で補正する軸の英字 (軸名が英字でない場合)</translation>
    </message>
    <message>
        <source>a number in mm or degrees behind {word}</source>
        <translation>{word} の後に mm または度の数値</translation>
    </message>
    <message>
        <source>the setting {key} {value}</source>
        <translation>設定 {key} {value}</translation>
    </message>
    <message>
        <source>one letter</source>
        <translation>英字 1 文字</translation>
    </message>
    <message>
        <source>the moving axis, as in AXIS_Y; its letter as the setting {key} where the file has another name</source>
        <translation>AXIS_Y のような移動軸。ファイル名が異なる場合は、その英字を設定 {key} で指定</translation>
    </message>
    <message>
        <source>axis {axis} in the name of the file</source>
        <translation>ファイル名の軸 {axis}</translation>
    </message>
    <message>
        <source>axis {axis}, as the setting {key} says</source>
        <translation>設定 {key} が示す軸 {axis}</translation>
    </message>
    <message>
        <source>a first line without MM</source>
        <translation>MM のない先頭行</translation>
    </message>
    <message>
        <source>MM or INCH; mm is assumed</source>
        <translation>MM または INCH。mm とみなします</translation>
    </message>
    <message>
        <source>a first line such as {example}</source>
        <translation>{example} のような先頭行</translation>
    </message>
    <message>
        <source>a distance of {distance}</source>
        <translation>間隔 {distance}</translation>
    </message>
    <message>
        <source>a tab</source>
        <translation>タブ</translation>
    </message>
    <message>
        <source>blanks, since the columns are counted in characters</source>
        <translation>空白 (列は文字数で数えるため)</translation>
    </message>
    <message>
        <source>each column once</source>
        <translation>各列は 1 回だけ</translation>
    </message>
    <message>
        <source>a line of headers such as {example}</source>
        <translation>{example} のような見出し行</translation>
    </message>
    <message>
        <source>a value below the header of an axis, and one in each column</source>
        <translation>軸の見出しの下に値、各列に 1 つ</translation>
    </message>
    <message>
        <source>the number of a line</source>
        <translation>行の番号</translation>
    </message>
    <message>
        <source>ascending numbers from 0</source>
        <translation>0 からの昇順の番号</translation>
    </message>
    <message>
        <source>{position}, as DATUM and DISTANCE say for line {number}</source>
        <translation>行 {number} について DATUM と DISTANCE が示す {position}</translation>
    </message>
    <message>
        <source>more than {count} lines</source>
        <translation>{count} 行を超えている</translation>
    </message>
    <message>
        <source>at most {count} lines</source>
        <translation>{count} 行以下</translation>
    </message>
    <message>
        <source>a line with its number and its position</source>
        <translation>番号と位置のある行</translation>
    </message>
    <message>
        <source>nothing behind [END]</source>
        <translation>[END] の後には何もなし</translation>
    </message>
    <message>
        <source>no line [END]</source>
        <translation>[END] の行なし</translation>
    </message>
    <message>
        <source>that line at the end; the file may be cut off</source>
        <translation>最後にこの行。ファイルが途中で切れている可能性があります</translation>
    </message>
    <message>
        <source>the position {position} of the rotary axis {axis}</source>
        <translation>回転軸 {axis} の位置 {position}</translation>
    </message>
    <message>
        <source>0 to 360 deg; the control does not use others</source>
        <translation>0 から 360 deg。コントローラはほかの値を使いません</translation>
    </message>
    <message>
        <source>values of {axis} that change by {change}</source>
        <translation>{change} 変化する {axis} の値</translation>
    </message>
    <message>
        <source>at most {limit} from line to line, DISTANCE / 64, on older controls</source>
        <translation>行間の変化は {limit} (DISTANCE / 64) 以下 (古いコントローラの場合)</translation>
    </message>
    <message>
        <source>values in a column, of which there are none</source>
        <translation>列の値 (1 つもない)</translation>
    </message>
    <message>
        <source>the column of {axis}</source>
        <translation>{axis} の列</translation>
    </message>
    <message>
        <source>a line of headers behind the first line</source>
        <translation>先頭行の後に見出し行</translation>
    </message>
    <message numerus="yes">
        <source>{count} values in the column BACKLASH</source>
        <comment>1 value in the column BACKLASH</comment>
        <translation>
            <numerusform>列 BACKLASH に値が {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>none: it is not published whether they are whole values or differences</source>
        <translation>なし: それらが全体の値か差分かは公開されていません</translation>
    </message>
    <message>
        <source>the table goes from {column}, and the settings for its axes say {axis} for both</source>
        <translation>テーブルの対応は {column} ですが、軸の設定では両方が {axis} です</translation>
    </message>
    <message>
        <source>there are two columns for axis {axis}</source>
        <translation>軸 {axis} の列が 2 つあります</translation>
    </message>
    <message>
        <source>its numbers for axis {axis} are in {unit}; A, B and C are in degrees, other axes in mm</source>
        <translation>軸 {axis} の数値の単位が {unit} です。A、B、C は度、ほかの軸は mm です</translation>
    </message>
    <message>
        <source>check the units and the axes of the table</source>
        <translation>テーブルの単位と軸を確認してください</translation>
    </message>
    <message>
        <source>its positions go from {first} to {last}, and of a rotary axis only 0 to 360 degrees count</source>
        <translation>位置が {first} から {last} ですが、回転軸で有効なのは 0 から 360 度だけです</translation>
    </message>
    <message>
        <source>give them from 0 to 360 degrees in the file that is converted, -90 as 270</source>
        <translation>変換元のファイルで 0～360 度の値にしてください (-90 は 270)</translation>
    </message>
    <message>
        <source>the numbers for axis {axis} have no unit; they are taken to be in {unit}</source>
        <translation>軸 {axis} の数値に単位がありません。{unit} とみなします</translation>
    </message>
    <message>
        <source>its distance is {distance}; the TNC 407 takes a power of two times {step}, and the next ones are {below} and {above}</source>
        <translation>間隔が {distance} です。TNC 407 の間隔は {step} の 2 のべき乗倍で、最も近い値は {below} と {above} です</translation>
    </message>
    <message>
        <source>resample it with one of these distances, or set any-distance=yes for an iTNC 530</source>
        <translation>そのどちらかの間隔で再サンプリングするか、iTNC 530 の場合は any-distance=yes にしてください</translation>
    </message>
    <message>
        <source>its distance {distance} has more than {count} decimals</source>
        <translation>間隔 {distance} の小数が {count} 桁を超えています</translation>
    </message>
    <message>
        <source>resample it with a distance of fewer decimals</source>
        <translation>小数桁の少ない間隔で再サンプリングしてください</translation>
    </message>
    <message>
        <source>the number {number} has more digits than a column holds</source>
        <translation>数値 {number} の桁数が列に収まりません</translation>
    </message>
    <message>
        <source>no text says the sign of a .COM table; it is written as the error, actual - commanded position. Check one point on the machine</source>
        <translation>.COM テーブルの符号を示す資料がないため、誤差 (実位置 − 指令位置) として書きます。機械で 1 点を確認してください</translation>
    </message>
    <message>
        <source>name the file in a line of config.cma, in the column of axis {axis}, and mark the line with *; older controls also need the bit of the axis in MP730</source>
        <translation>config.cma の行の軸 {axis} の列にファイル名を記入し、その行に * を付けてください。古いコントローラでは MP730 の軸のビットも必要です</translation>
    </message>
    <message>
        <source>axis of the table, where the table names none of these</source>
        <translation>テーブルの軸 (テーブル内の名前がこれらのどれでもない場合)</translation>
    </message>
    <message>
        <source>the unit &quot;{unit}&quot;</source>
        <translation>単位 &quot;{unit}&quot;</translation>
    </message>
    <message>
        <source>mm, the only unit of this file</source>
        <translation>mm (このファイルの唯一の単位)</translation>
    </message>
    <message>
        <source>the letter of an axis between brackets, such as [X]</source>
        <translation>[X] のような角括弧内の軸の英字</translation>
    </message>
    <message>
        <source>a section of axis {axis}</source>
        <translation>軸 {axis} のセクション</translation>
    </message>
    <message>
        <source>X, Y or Z</source>
        <translation>X、Y または Z</translation>
    </message>
    <message>
        <source>a second section of axis {axis}</source>
        <translation>軸 {axis} の 2 つ目のセクション</translation>
    </message>
    <message>
        <source>each axis once; the first is in line {line}</source>
        <translation>各軸は 1 回だけ。最初のものは行 {line} にあります</translation>
    </message>
    <message>
        <source>a section such as [X] before the first numbers</source>
        <translation>最初の数値の前に [X] のようなセクション</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers between commas</source>
        <comment>1 number between commas</comment>
        <translation>
            <numerusform>カンマ区切りの数値 {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>3, with decimal points: nominal position, forward error, backward error</source>
        <translation>小数点付きの数値 3 個: 呼び位置、往路の誤差、復路の誤差</translation>
    </message>
    <message>
        <source>a forward error in mm</source>
        <translation>mm 単位の往路の誤差</translation>
    </message>
    <message>
        <source>a backward error in mm</source>
        <translation>mm 単位の復路の誤差</translation>
    </message>
    <message>
        <source>a section such as [X], of which there is none</source>
        <translation>[X] のようなセクション (1 つもない)</translation>
    </message>
    <message>
        <source>no line unit=mm</source>
        <translation>unit=mm の行なし</translation>
    </message>
    <message>
        <source>that line; mm is the only unit</source>
        <translation>この行。単位は mm だけです</translation>
    </message>
    <message>
        <source>the file is axeserr.dat in the folder of the software (NK200: from a USB stick), read when the software starts</source>
        <translation>ファイルはソフトウェアのフォルダの axeserr.dat (NK200 では USB メモリから) で、ソフトウェアの起動時に読み込まれます</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2: both directions</source>
        <translation>パラメータ Screw error compensation を 2 (両方向) にしてください</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2, or to 1 with the backlash as a parameter of its own</source>
        <translation>パラメータ Screw error compensation を 2 にするか、バックラッシを別のパラメータで設定して 1 にしてください</translation>
    </message>
    <message>
        <source>positions are machine coordinates from the reference point and must lie within the stroke, else the compensation is invalid</source>
        <translation>位置は原点からの機械座標で、ストローク内にある必要があります。外れていると補正は無効になります</translation>
    </message>
    <message>
        <source>axeserr.dat: screw errors forwards and backwards</source>
        <translation>axeserr.dat: 往路と復路の送りねじ誤差</translation>
    </message>
    <message>
        <source>nobody has published which sign files of the format {format} have; {sign} is an assumption. Check one point on the machine, and state feedback or command {statement}</source>
        <translation>形式 {format} のファイルの符号は公開されておらず、{sign} は推定です。機械で 1 点を確認し、feedback または command を指定してください ({statement})</translation>
    </message>
    <message>
        <source>holds the end values</source>
        <translation>端点値を保持します</translation>
    </message>
    <message>
        <source>applies nothing</source>
        <translation>補正しません</translation>
    </message>
    <message>
        <source>goes on as in the last cell</source>
        <translation>最後の区間を延長します</translation>
    </message>
    <message>
        <source>beyond the ends of the table the controller of {from} {before}, and that of {to} {after}: up to one cell beyond them, the corrections for {column} differ by at most {largest}, at {place}</source>
        <translation>テーブルの端より先では、{from} のコントローラは{before}が、{to} のコントローラは{after}。端から 1 区間先までで {column} の補正量の差は最大 {largest} ({place}) です</translation>
    </message>
    <message>
        <source>in the field Sign, or with {option}</source>
        <translation>[符号] の欄または {option}</translation>
    </message>
    <message>
        <source>in the field Sign, with {option}, or as {entry} in a machine file</source>
        <translation>[符号] の欄、{option}、または機械ファイルの {entry}</translation>
    </message>
    <message>
        <source>an entry such as {example}</source>
        <translation>{example} のようなエントリ</translation>
    </message>
    <message>
        <source>each entry once; the last one counts</source>
        <translation>各エントリは 1 回だけ。最後のものを使います</translation>
    </message>
    <message>
        <source>a value in mm</source>
        <translation>mm 単位の値</translation>
    </message>
    <message>
        <source>{key} and {key2} as the ends of {list}</source>
        <translation>{list} の両端としての {key} と {key2}</translation>
    </message>
    <message>
        <source>{key} and {key2}, as later firmware writes them</source>
        <translation>新しいファームウェアが書く {key} と {key2}</translation>
    </message>
    <message>
        <source>entries {key} and {key2} for {list}</source>
        <translation>{list} のエントリ {key} と {key2}</translation>
    </message>
    <message>
        <source>an end above the start</source>
        <translation>始点より大きい終点</translation>
    </message>
    <message>
        <source>a section [{section}] with {list} or {list2}</source>
        <translation>{list} または {list2} を含むセクション [{section}]</translation>
    </message>
    <message>
        <source>[axis_twist_compensation] of printer.cfg: errors of the probe over X or Y</source>
        <translation>printer.cfg の [axis_twist_compensation]: X または Y に対するプローブの誤差</translation>
    </message>
    <message>
        <source>unit of all numbers of the file; the controller takes them to be inches, and files in millimetres occur</source>
        <translation>ファイルの全数値の単位。コントローラはインチとみなしますが、ミリメートルのファイルもあります</translation>
    </message>
    <message>
        <source>a missing number</source>
        <translation>数値の欠落</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers with commas between</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>カンマ区切りの数値 {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>a comma directly behind the number &quot;{number}&quot;</source>
        <translation>数値 &quot;{number}&quot; の直後のカンマ</translation>
    </message>
    <message>
        <source>rows and columns, distances of X and Y, and X and Y of the first point</source>
        <translation>行数と列数、X と Y の間隔、最初の点の X と Y</translation>
    </message>
    <message>
        <source>a number of rows or columns, {number} to {number2}</source>
        <translation>行数または列数 ({number} から {number2})</translation>
    </message>
    <message>
        <source>a distance such as 0.5</source>
        <translation>0.5 のような間隔</translation>
    </message>
    <message>
        <source>another one: with 0 the controller corrects nothing</source>
        <translation>別の値: 0 ではコントローラは何も補正しません</translation>
    </message>
    <message>
        <source>a position of row 0 and column 0</source>
        <translation>行 0、列 0 の位置</translation>
    </message>
    <message>
        <source>the number of a row, 0 to {last}</source>
        <translation>行の番号 (0 から {last})</translation>
    </message>
    <message>
        <source>the number of a column, 0 to {last}</source>
        <translation>列の番号 (0 から {last})</translation>
    </message>
    <message>
        <source>row {row}, column {column}</source>
        <translation>行 {row}、列 {column}</translation>
    </message>
    <message>
        <source>each point once; the last line counts</source>
        <translation>各点は 1 回だけ。最後の行を使います</translation>
    </message>
    <message numerus="yes">
        <source>no line for {count} points, the first of them {point}</source>
        <comment>no line for {point}</comment>
        <translation>
            <numerusform>{count} 点の行がない (最初は {point})</numerusform>
        </translation>
    </message>
    <message>
        <source>a line for each of the {rows} x {columns} points</source>
        <translation>{rows} x {columns} 点それぞれの行</translation>
    </message>
    <message>
        <source>further numbers behind the last point</source>
        <translation>最後の点の後の余分な数値</translation>
    </message>
    <message>
        <source>{number} points; the controller does not read more either</source>
        <translation>{number} 点。コントローラもそれ以上は読み取りません</translation>
    </message>
    <message>
        <source>numbers without a unit, taken to be {unit}</source>
        <translation>単位のない数値 ({unit} とみなします)</translation>
    </message>
    <message>
        <source>the setting {key}, {value} or {value2}</source>
        <translation>設定 {key} ({value} または {value2})</translation>
    </message>
    <message>
        <source>its source {number} is {axis}, and this one is {name}</source>
        <translation>ソース {number} が {axis} ですが、これは {name} です</translation>
    </message>
    <message>
        <source>exchange the sources of the table</source>
        <translation>テーブルのソースを入れ替えてください</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than the {limit} that the controller takes</source>
        <translation>{axis} の {count} 点は、コントローラの上限 {limit} 点を超えています</translation>
    </message>
    <message>
        <source>it corrects X, Y and Z, and this table goes from {column}</source>
        <translation>X、Y、Z を補正する形式ですが、このテーブルの対応は {column} です</translation>
    </message>
    <message>
        <source>state the target as Z, or as other, where it is Z</source>
        <translation>対象軸が Z の場合は、Z または other と指定してください</translation>
    </message>
    <message>
        <source>two columns go from {column}</source>
        <translation>対応が {column} の列が 2 つあります</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>どちらか一方を残してください</translation>
    </message>
    <message>
        <source>the numbers of the file are in {unit}; the controller takes them to be inches</source>
        <translation>ファイルの数値の単位は {unit} ですが、コントローラはインチとみなします</translation>
    </message>
    <message>
        <source>name the file as Geo File in the tool setup of KMotionCNC; arcs are then broken into short lines, and Z is corrected for the plane Z = 0 only</source>
        <translation>KMotionCNC の Tool Setup で、このファイルを Geo File に指定してください。円弧は短い線分に分割され、Z は平面 Z = 0 でだけ補正されます</translation>
    </message>
    <message>
        <source>geometric correction of X, Y and Z over X and Y</source>
        <translation>X と Y の位置による X、Y、Z の幾何補正</translation>
    </message>
    <message>
        <source>a line each for the number of positions, the size of a range and the first position</source>
        <translation>位置の数、1 区間の大きさ、最初の位置を 1 行ずつ</translation>
    </message>
    <message>
        <source>a number of positions</source>
        <translation>位置の数</translation>
    </message>
    <message>
        <source>the size of a range</source>
        <translation>1 区間の大きさ</translation>
    </message>
    <message>
        <source>the first position</source>
        <translation>最初の位置</translation>
    </message>
    <message>
        <source>a range of {size}</source>
        <translation>区間 {size}</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>0 より大きい値</translation>
    </message>
    <message>
        <source>index and position, or the position alone</source>
        <translation>インデックスと位置、または位置だけ</translation>
    </message>
    <message>
        <source>an index from 0</source>
        <translation>0 以上のインデックス</translation>
    </message>
    <message>
        <source>the index {number}</source>
        <translation>インデックス {number}</translation>
    </message>
    <message>
        <source>{number}: indices count from 0 in the order of the lines</source>
        <translation>{number}: インデックスは行の順に 0 から始まります</translation>
    </message>
    <message>
        <source>a position to command</source>
        <translation>指令する位置</translation>
    </message>
    <message>
        <source>{value}, as the first line says</source>
        <translation>先頭行が示す {value}</translation>
    </message>
    <message>
        <source>strictly increasing positions to command; a list of corrections is no such file</source>
        <translation>単調増加する、指令する位置。補正量のリストはこの形式ではありません</translation>
    </message>
    <message>
        <source>at {position} the position to command, {sum}, is not larger than the one before, {before}</source>
        <translation>{position} で指令する位置 {sum} が、直前の {before} より大きくありません</translation>
    </message>
    <message>
        <source>the file holds positions to command, not corrections; KMotionCNC applies them after the geometric correction</source>
        <translation>ファイルの内容は補正量ではなく、指令する位置です。KMotionCNC は幾何補正の後に適用します</translation>
    </message>
    <message>
        <source>linear table of one axis: positions to command</source>
        <translation>1 軸の直線テーブル: 指令する位置</translation>
    </message>
    <message>
        <source>motor units for one unit of the positions</source>
        <translation>位置 1 単位あたりのモータ単位数</translation>
    </message>
    <message>
        <source>number of the table, from 0</source>
        <translation>テーブルの番号 (0 から)</translation>
    </message>
    <message>
        <source>number of the motor whose position counts</source>
        <translation>位置を使うモータの番号</translation>
    </message>
    <message>
        <source>number of the motor that is compensated</source>
        <translation>補正するモータの番号</translation>
    </message>
    <message>
        <source>a value of the table</source>
        <translation>テーブルの値</translation>
    </message>
    <message>
        <source>value {number} again</source>
        <translation>値 {number} が 2 回目</translation>
    </message>
    <message>
        <source>each value once; the last one counts</source>
        <translation>各値は 1 回だけ。最後のものを使います</translation>
    </message>
    <message>
        <source>an assignment such as {example}</source>
        <translation>{example} のような代入文</translation>
    </message>
    <message>
        <source>{element} of the table: {meaning}</source>
        <translation>テーブルの {element}: {meaning}</translation>
    </message>
    <message>
        <source>CompPos or CompPos2 of one motor, such as {example}</source>
        <translation>{example} のような、1 つのモータの CompPos または CompPos2</translation>
    </message>
    <message>
        <source>the motor that is compensated</source>
        <translation>補正するモータ</translation>
    </message>
    <message>
        <source>the scale factor of the values</source>
        <translation>値の倍率</translation>
    </message>
    <message>
        <source>a scale factor Sf[0] of {factor}</source>
        <translation>倍率 Sf[0] が {factor}</translation>
    </message>
    <message>
        <source>1; it is taken to multiply the values</source>
        <translation>1。値に掛けるものとみなします</translation>
    </message>
    <message>
        <source>{value}; what other bits do is not known</source>
        <translation>{value}。ほかのビットの働きは不明です</translation>
    </message>
    <message>
        <source>no value {number}</source>
        <translation>値 {number} なし</translation>
    </message>
    <message>
        <source>a table of several sources</source>
        <translation>ソースが複数のテーブル</translation>
    </message>
    <message>
        <source>one source: in which order the values of several stand is not known</source>
        <translation>1 つのソース。複数の場合の値の順序は不明です</translation>
    </message>
    <message>
        <source>the number of segments, one less than values</source>
        <translation>区間の数 (値の数より 1 少ない)</translation>
    </message>
    <message>
        <source>the whole span</source>
        <translation>全体のスパン</translation>
    </message>
    <message>
        <source>the number of the source motor</source>
        <translation>ソースモータの番号</translation>
    </message>
    <message>
        <source>{count} segments over {span}</source>
        <translation>スパン {span} に {count} 区間</translation>
    </message>
    <message>
        <source>1 to {most} segments over more than 0</source>
        <translation>0 より大きいスパンに 1 から {most} 区間</translation>
    </message>
    <message>
        <source>assignments to {name}</source>
        <translation>{name} への代入</translation>
    </message>
    <message>
        <source>a table in motor units</source>
        <translation>モータ単位のテーブル</translation>
    </message>
    <message>
        <source>there is no number {number}</source>
        <translation>番号 {number} はありません</translation>
    </message>
    <message>
        <source>choose one from 0 to {most}</source>
        <translation>0 から {most} までの番号を選んでください</translation>
    </message>
    <message>
        <source>Sys.CompEnable must be at least {number}, also for other tables</source>
        <translation>Sys.CompEnable は {number} 以上が必要です (ほかのテーブルの場合も同じ)</translation>
    </message>
    <message>
        <source>the sign of these tables and what Sf, Ctrl and OutCtrl do are assumptions: look at one point on the machine before the table is used</source>
        <translation>このテーブルの符号と、Sf、Ctrl、OutCtrl の働きは推定です。テーブルを使う前に、機械で 1 点を確認してください</translation>
    </message>
    <message>
        <source>compensation table of one source (CompTable)</source>
        <translation>1 ソースの補正テーブル (CompTable)</translation>
    </message>
    <message>
        <source>what the variables are called: letters, digits and _, a letter first</source>
        <translation>変数の名前: 英字で始まる英字、数字、_</translation>
    </message>
    <message>
        <source>a variable of the type {type} in front of the elements</source>
        <translation>要素の前に {type} 型の変数</translation>
    </message>
    <message>
        <source>TRUE or FALSE</source>
        <translation>TRUE または FALSE</translation>
    </message>
    <message>
        <source>{value}: what another direction means is not known here</source>
        <translation>{value}: ほかの方向の意味は不明です</translation>
    </message>
    <message>
        <source>a declaration without its end</source>
        <translation>終わりのない宣言</translation>
    </message>
    <message>
        <source>a semicolon behind it</source>
        <translation>その後のセミコロン</translation>
    </message>
    <message>
        <source>the last position</source>
        <translation>最後の位置</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>要素の数</translation>
    </message>
    <message numerus="yes">
        <source>{count} elements</source>
        <comment>1 element</comment>
        <translation>
            <numerusform>要素 {count} 個</numerusform>
        </translation>
    </message>
    <message>
        <source>from {first} to {last}, as MinPosition and MaxPosition say</source>
        <translation>MinPosition と MaxPosition が示す {first} から {last}</translation>
    </message>
    <message>
        <source>an element of one number</source>
        <translation>1 つの数値からなる要素</translation>
    </message>
    <message>
        <source>a position and a compensation</source>
        <translation>位置と補正量</translation>
    </message>
    <message>
        <source>a compensation</source>
        <translation>補正量</translation>
    </message>
    <message>
        <source>the values {first} and {last} at the ends</source>
        <translation>両端の値 {first} と {last}</translation>
    </message>
    <message>
        <source>the same value at both ends, which are one place</source>
        <translation>両端で同じ値 (両端は同じ位置)</translation>
    </message>
    <message>
        <source>an array of {type} behind the parameters</source>
        <translation>パラメータの後に {type} の配列</translation>
    </message>
    <message>
        <source>a variable of the type {type}</source>
        <translation>{type} 型の変数</translation>
    </message>
    <message>
        <source>the setting name is &quot;{value}&quot;, expected letters, digits and _, a letter first</source>
        <translation>設定 name が &quot;{value}&quot; です。英字で始まり、英字、数字、_ からなる名前が必要です</translation>
    </message>
    <message>
        <source>the manual contradicts itself on whether the correction is added to the nominal or to the actual position: check one point on the machine</source>
        <translation>補正量が加算されるのは指令位置か実位置かについて、マニュアルの記述が矛盾しています。機械で 1 点を確認してください</translation>
    </message>
    <message>
        <source>switch Position Correction of the axis on; Ramp limits the speed of the correction</source>
        <translation>軸の Position Correction をオンにしてください。Ramp は補正の速度を制限します</translation>
    </message>
    <message>
        <source>structured text for MC_TableBasedPositionCompensation</source>
        <translation>MC_TableBasedPositionCompensation 用のストラクチャードテキスト</translation>
    </message>
    <message>
        <source>a prediction needs a measurement of targets</source>
        <translation>予測には目標位置での測定が必要です</translation>
    </message>
    <message>
        <source>a prediction needs a table of one dimension</source>
        <translation>予測には 1 次元のテーブルが必要です</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them with accept-large = true for axis {machineAxis} in the machine file</source>
        <translation>{reason} 値の単位を確認してください。正しい場合は、機械ファイルの軸 {machineAxis} に accept-large = true と書いて承認してください</translation>
    </message>
    <message>
        <source>the table is in counts already, and the format {format} would multiply it by the counts per unit once more: set them to 1, or read the source with its own</source>
        <translation>テーブルはすでにカウント単位ですが、形式 {format} は単位あたりのカウント数をもう一度掛けます。それを 1 にするか、元のファイルをそのカウント数を指定して読み取ってください</translation>
    </message>
    <message>
        <source>a comma, a bracket or a semicolon behind the value &quot;{value}&quot;</source>
        <translation>値 &quot;{value}&quot; の後にカンマ、括弧またはセミコロン</translation>
    </message>
    <message>
        <source>the table is {length} long, but a turn of the axis is {turn}: a prediction needs a table of one turn</source>
        <translation>テーブルの長さが {length} ですが、軸の 1 回転は {turn} です。予測には 1 回転分のテーブルが必要です</translation>
    </message>
    <message>
        <source>nobody has published the sign of its format. Import it on Write, where you state the sign, export it from there as a calibration file, and choose that</source>
        <translation>この形式の符号は公表されていません。[書き込み] でインポートして符号を指定し、校正ファイルとしてエクスポートしたうえで、それを選択してください</translation>
    </message>
    <message>
        <source>there is no font with the characters of this language to draw a PDF with: install one, such as fonts-noto-cjk, or write the report as HTML</source>
        <translation>PDF を描くための、この言語の文字を含むフォントがありません。fonts-noto-cjk などをインストールするか、報告書を HTML で書き出してください</translation>
    </message>
    <message>
        <source>{file} is no record (.axcal), no machine file (.toml), no TAM configuration (.TAMcfg), and no table or measurement of a known format; a table whose format you can name is opened on the tab Write</source>
        <translation>{file} は記録 (.axcal)、機械ファイル (.toml)、TAM 構成 (.TAMcfg) のいずれでもなく、既知の形式のテーブルや測定でもありません。形式がわかるテーブルは「書き込み」タブで開いてください</translation>
    </message>
    <message>
        <source>the drive is only looked at</source>
        <translation>ドライブは読み取るだけです</translation>
    </message>
    <message>
        <source>you have no permission to use the port, and no group has it</source>
        <translation>ポートを使う権限がなく、権限を持つグループもありません</translation>
    </message>
    <message>
        <source>ask the administrator</source>
        <translation>管理者に問い合わせてください</translation>
    </message>
    <message>
        <source>you have no permission to use the port, although you are in its group {group}</source>
        <translation>ポートのグループ {group} に入っていますが、ポートを使う権限がありません</translation>
    </message>
    <message>
        <source>you have no permission to use the port: you are in the group {group}, but this session is older than that</source>
        <translation>ポートを使う権限がありません: グループ {group} に入っていますが、このセッションはその前に開始されています</translation>
    </message>
    <message>
        <source>log out and in again</source>
        <translation>いったんログアウトし、ログインし直してください</translation>
    </message>
    <message>
        <source>you have no permission to use the port</source>
        <translation>ポートを使う権限がありません</translation>
    </message>
    <message>
        <source>join the group {group} (sudo usermod -aG {name} $USER) and log in again</source>
        <translation>グループ {group} に入り (sudo usermod -aG {name} $USER)、ログインし直してください</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>そのポートはありません</translation>
    </message>
    <message>
        <source>is the cable or the adapter plugged in?</source>
        <translation>ケーブルまたはアダプタは接続されていますか？</translation>
    </message>
    <message>
        <source>{found}; {wayOut}</source>
        <translation>{found}。{wayOut}</translation>
    </message>
    <message>
        <source>the instrument sends a line of more than {count} characters: check its settings and its speed</source>
        <translation>測定器が {count} 文字を超える行を送信しています: 測定器の設定と通信速度を確認してください</translation>
    </message>
    <message>
        <source>number of the reference point, parameter 3620</source>
        <translation>原点の番号 (パラメータ 3620)</translation>
    </message>
    <message>
        <source>interval of the points, parameter 3624, in the unit of the positions</source>
        <translation>補正点の間隔 (パラメータ 3624)、位置の単位で</translation>
    </message>
    <message>
        <source>detection unit of the axis, in the unit of the positions, such as 0.001</source>
        <translation>軸の検出単位、位置の単位で (0.001 など)</translation>
    </message>
    <message>
        <source>magnification of the values, parameter 3623</source>
        <translation>値の倍率 (パラメータ 3623)</translation>
    </message>
    <message>
        <source>position of the reference point</source>
        <translation>原点の位置</translation>
    </message>
    <message>
        <source>lowest number of the axis, parameter 3621, instead of the lowest one in the file</source>
        <translation>ファイル内の最小の番号の代わりに使う、軸の最小の番号 (パラメータ 3621)</translation>
    </message>
    <message>
        <source>highest number of the axis, parameter 3622, instead of the highest one in the file</source>
        <translation>ファイル内の最大の番号の代わりに使う、軸の最大の番号 (パラメータ 3622)</translation>
    </message>
    <message>
        <source>what N of a line is for number 0</source>
        <translation>番号 0 の行の N の値</translation>
    </message>
    <message>
        <source>largest value that the controller takes for a number</source>
        <translation>コントローラが 1 つの番号に受け付ける最大の値</translation>
    </message>
    <message>
        <source>stored pitch error data of an axis (N10033P2)</source>
        <translation>軸の記憶形ピッチ誤差補正データ (N10033P2)</translation>
    </message>
    <message>
        <source>a whole number of increments behind P</source>
        <translation>P の後に整数の増分</translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation>{most} 以下</translation>
    </message>
    <message>
        <source>bit 0 of parameter 3605 is 1: values for each direction of motion</source>
        <translation>パラメータ 3605 のビット 0 が 1 (運動方向ごとの値)</translation>
    </message>
    <message>
        <source>one value for both directions; leave the line out if it is of another axis</source>
        <translation>両方向に 1 つの値。別の軸の行であれば、その行を除いてください</translation>
    </message>
    <message>
        <source>line N{number}</source>
        <translation>行 N{number}</translation>
    </message>
    <message>
        <source>N{first} to N{last}, as the setting first-record says</source>
        <translation>設定 first-record が示す N{first} ～ N{last}</translation>
    </message>
    <message>
        <source>a line such as {example}</source>
        <translation>{example} のような行</translation>
    </message>
    <message>
        <source>a line % in front of it</source>
        <translation>その前に % の行</translation>
    </message>
    <message>
        <source>lines without an end</source>
        <translation>終わりのない行</translation>
    </message>
    <message>
        <source>a line % behind the last one</source>
        <translation>最後の行の後に % の行</translation>
    </message>
    <message>
        <source>lines such as {example} between two lines %</source>
        <translation>2 つの % の行の間に {example} のような行</translation>
    </message>
    <message>
        <source>no line from N{first} to N{last}</source>
        <translation>N{first} ～ N{last} の行がありません</translation>
    </message>
    <message>
        <source>pitch error data; the setting first-record says where their numbers begin</source>
        <translation>ピッチ誤差補正データ。番号の始まりは設定 first-record で指定します</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} for the axis</source>
        <translation>軸の番号 {first} ～ {last}</translation>
    </message>
    <message>
        <source>numbers round that of the reference point, {number}, as the setting {key} says</source>
        <translation>設定 {key} が示す原点の番号 {number} を含む番号</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} of one turn</source>
        <translation>1 回転分の番号 {first} ～ {last}</translation>
    </message>
    <message>
        <source>each number from {first} to {last}; first-number and last-number choose those of one axis</source>
        <translation>{first} ～ {last} のすべての番号。1 つの軸の番号は first-number と last-number で選びます</translation>
    </message>
    <message>
        <source>at most {most} of an axis, as one source says</source>
        <translation>ある資料によれば 1 軸あたり {most} 以下</translation>
    </message>
    <message>
        <source>the values {first} to {last}, which add up to {sum}</source>
        <translation>合計が {sum} になる値 {first} ～ {last}</translation>
    </message>
    <message>
        <source>0 over one turn</source>
        <translation>1 回転で 0</translation>
    </message>
    <message>
        <source>value {number}, of the reference point</source>
        <translation>原点の値 {number}</translation>
    </message>
    <message>
        <source>the same as value {number}, which is the same section</source>
        <translation>同じ区間である値 {number} と同じ値</translation>
    </message>
    <message>
        <source>the setting wrap-range is {turn}, expected 1 to {most} times the interval of {interval}</source>
        <translation>設定 wrap-range が {turn} です。間隔 {interval} の 1 ～ {most} 倍が必要です</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected {least} to {most}</source>
        <translation>形式 {format} の設定 {key} が {value} です。{least} ～ {most} が必要です</translation>
    </message>
    <message>
        <source>wrap-range says which numbers a rotary axis has; leave {key} and {key2} out</source>
        <translation>回転軸の番号は wrap-range で決まります。{key} と {key2} を指定しないでください</translation>
    </message>
    <message>
        <source>the reference position {position} is no point of it; its points are from {first} to {last}, {distance} apart</source>
        <translation>原点位置 {position} がその点にありません。点は {first} ～ {last}、間隔 {distance} です</translation>
    </message>
    <message>
        <source>resample it with a point there, or check reference-position</source>
        <translation>そこを点に含めて再サンプリングするか、reference-position を確認してください</translation>
    </message>
    <message>
        <source>its points would get the numbers {first} to {last}</source>
        <translation>点の番号が {first} ～ {last} になります</translation>
    </message>
    <message>
        <source>choose a reference-number so that they are from 0 to {most}</source>
        <translation>0 ～ {most} に収まるように reference-number を選んでください</translation>
    </message>
    <message>
        <source>the value {value} is too large</source>
        <translation>値 {value} が大きすぎます</translation>
    </message>
    <message>
        <source>check detection-unit and the unit of the values</source>
        <translation>detection-unit と値の単位を確認してください</translation>
    </message>
    <message>
        <source>its value at the reference position is {value}, and the controller takes it to be 0 there</source>
        <translation>原点位置の値が {value} ですが、コントローラはそこを 0 とみなします</translation>
    </message>
    <message>
        <source>from {first} to {last} it changes by {count} increments of {increment}, and a value is at most {most}</source>
        <translation>{first} から {last} までの変化が {increment} の増分で {count} ですが、値は {most} 以下です</translation>
    </message>
    <message>
        <source>set magnification={number}, the smallest that fits, or largest-step if the controller takes more</source>
        <translation>収まる最小の magnification={number} を指定するか、コントローラがより大きい値を受け付ける場合は largest-step を指定してください</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}</source>
        <translation>軸のパラメータを設定してください: 3620 = {reference}、3621 = {first}、3622 = {last}、3623 = {magnification}、3624 = {interval}、3625 = {turn}</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}</source>
        <translation>軸のパラメータを設定してください: 3620 = {reference}、3621 = {first}、3622 = {last}、3623 = {magnification}、3624 = {interval}</translation>
    </message>
    <message>
        <source>these are {count} points, and one source says that an axis has at most {most}</source>
        <translation>{count} 点ありますが、ある資料によれば 1 軸は {most} 点以下です</translation>
    </message>
    <message>
        <source>the sign is an assumption: a value is put out to the axis as pulses. Check one point on the machine</source>
        <translation>符号は推定です。値はパルスとして軸に出力されるものとしています。機械で 1 点を確認してください</translation>
    </message>
    <message>
        <source>where within its section a value is put out is not known: the correction is taken to be linear, and its place is in doubt by half an interval</source>
        <translation>値が区間内のどこで出力されるかは分かっていません。補正量は直線とみなし、その位置には間隔の半分の不確かさがあります</translation>
    </message>
    <message>
        <source>after loading switch the power off and on and return to the reference point; alarm PW1102 says that the numbers do not fit</source>
        <translation>読み込み後、電源を入れ直して原点復帰を行ってください。アラーム PW1102 は番号が合わないことを示します</translation>
    </message>
    <message>
        <source>parameter {number}, which is {value} for no axis</source>
        <translation>パラメータ {number} (どの軸でも {value} ではない)</translation>
    </message>
    <message>
        <source>the reference point, numbers and magnification of one axis, as the settings say</source>
        <translation>設定どおりの 1 軸の基準点、番号、倍率</translation>
    </message>
    <message>
        <source>parameters 3620 to 3623 of several axes, and numbers {first} to {last}</source>
        <translation>複数軸のパラメータ 3620 から 3623 と、番号 {first} から {last}</translation>
    </message>
    <message>
        <source>the numbers of one axis; first-number and last-number choose them</source>
        <translation>1 軸の番号。first-number と last-number で選択</translation>
    </message>
    <message>
        <source>shift all values so that it is 0 there; convert does that with --zero</source>
        <translation>そこで 0 になるように全値をずらしてください (convert の --zero)</translation>
    </message>
    <message>
        <source>{number} to command, to reach {number2}</source>
        <translation>{number2} に達するための指令値が {number}</translation>
    </message>
    <message>
        <source>at most half a range away; a list of corrections is no such file</source>
        <translation>差は区間の半分まで。補正値の一覧はこの形式のファイルではありません</translation>
    </message>
    <message>
        <source>a comment without an end</source>
        <translation>終わりのないコメント</translation>
    </message>
    <message>
        <source>{sign} behind it</source>
        <translation>その後ろに {sign}</translation>
    </message>
    <message>
        <source>one position and one compensation in each pair of brackets</source>
        <translation>括弧ごとに位置と補正値を 1 つずつ</translation>
    </message>
    <message>
        <source>the values for {column} have no unit; they are taken to be in {unit}, as the positions are</source>
        <translation>{column} の値に単位がないため、位置と同じ {unit} とみなします</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to have no unit; state it in the header, as X [mm], or as the setting {key} of the file that is read</source>
        <translation>{column} の値の単位は {unit} ですが、加算先の位置に単位がありません。ヘッダーに X [mm] のように書くか、読み込むファイルの設定 {key} で指定してください</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {before}, as its positions are, and converted to {after}. The largest correction is {largest}.</source>
        <translation>テーブルに値の単位がないため、位置と同じ {before} とみなし、{after} に換算します。最大の補正量は {largest} です。</translation>
    </message>
    <message>
        <source>{name} has several tables of axis {axis}; which of them was active has to be said by its CRC, in the file of the measurement (// compensation: crc:{crc})</source>
        <translation>{name} には軸 {axis} のテーブルが複数あります。どれが有効だったかを、測定ファイルに CRC で記載してください (// compensation: crc:{crc})</translation>
    </message>
    <message>
        <source>{name} has several tables, none of which says its axis, so that it is not known which of them is meant: take a file with that table alone</source>
        <translation>{name} には複数のテーブルがあり、どれにも軸の記載がないため、どれを指すのか分かりません。そのテーブルだけのファイルを使ってください</translation>
    </message>
    <message>
        <source>{name} has several tables, and which of them is meant is not known: state the axis as it is called there (--target, or // axis: in the file of the measurement; there are: {axes}), or take a file with that table alone</source>
        <translation>{name} には複数のテーブルがあり、どれを指すのか分かりません。そこでの軸名を指定するか (--target、または測定ファイルの // axis:。候補: {axes})、そのテーブルだけのファイルを使ってください</translation>
    </message>
    <message>
        <source>the targets go from {from} to {to}, which is more than a turn of {turn}: give the length of the whole turn (--turn), or leave out what lies in a second one (--exclude)</source>
        <translation>目標位置は {from} から {to} までで、1 回転 {turn} を超えています。1 回転全体の長さを指定するか (--turn)、2 回転目にあるものを除外してください (--exclude)</translation>
    </message>
    <message>
        <source>positions with a decimal point and blanks between them; without a Target-count nobody can tell two positions from one with a decimal comma</source>
        <translation>小数点を使い空白で区切った位置。Target-count がないと、2 つの位置なのか小数コンマの 1 つの位置なのか区別できません</translation>
    </message>
    <message>
        <source>{found} targets, but deviations of {used}</source>
        <translation>目標位置は {found} 個、偏差があるのは {used} 個</translation>
    </message>
    <message>
        <source>a deviation of every target, or a Target-count</source>
        <translation>すべての目標位置の偏差、または Target-count</translation>
    </message>
    <message>
        <source>positions of targets that rise or fall throughout, with a decimal point and blanks between them</source>
        <translation>増え続ける、または減り続ける目標位置。小数点を使い空白で区切ります</translation>
    </message>
    <message>
        <source>every run goes {direction}, in a file of both directions (Flags: 0 0 2 0)</source>
        <translation>両方向のファイル (Flags: 0 0 2 0) なのに、すべての走行の方向が {direction} です</translation>
    </message>
    <message>
        <source>the lines of each run in the order in which they were measured; sorted by target they all seem to rise</source>
        <translation>各走行の行を測定した順に並べること。目標位置で並べ替えると、すべてが増加に見えます</translation>
    </message>
    <message>
        <source>the file does not say whether its values are corrected to 20 deg C already; if they are not, that has to be stated (--not-corrected)</source>
        <translation>値が 20 deg C に補正済みかどうか、ファイルに記載がありません。補正済みでない場合は、それを指定してください (--not-corrected)</translation>
    </message>
    <message>
        <source>file {second} holds the same measurement as file {first}, value by value: give it once</source>
        <translation>ファイル {second} の測定はファイル {first} とすべての値が同じです。1 回だけ指定してください</translation>
    </message>
    <message>
        <source>some of the files say otherwise than the others, or do not say, whether their values are corrected to 20 deg C, so that no correction would be right for all; say it in each of them (// corrected: 20C, or // corrected: none), or take those alone that agree</source>
        <translation>値が 20 °C に補正済みかどうかの記載がファイルによって異なるか欠けているため、すべてに正しい補正がありません。各ファイルに記載するか (// corrected: 20C または // corrected: none)、記載が一致するファイルだけを使ってください</translation>
    </message>
    <message>
        <source>the drive is taken to look the table up before the compensation, at the position of the encoder; at the set position (lookup: set) its corrections would differ by up to {largest}</source>
        <translation>ドライブは補正前のエンコーダの位置でテーブルを参照するものとしています。指令位置で参照する場合 (lookup: set)、補正値は最大 {largest} 異なります</translation>
    </message>
    <message>
        <source>where a table is looked up (--lookup-at) is said of a table of the drive, and neither {from} nor {to} is one</source>
        <translation>テーブルを参照する位置 (--lookup-at) はドライブのテーブルについて指定するものですが、{from} も {to} もドライブのテーブルではありません</translation>
    </message>
    <message>
        <source>the file does not say where the drive looks its table up: in a calibration file add the line // lookup: encoder or // lookup: set</source>
        <translation>ドライブがテーブルを参照する位置がファイルに書かれていません。校正ファイルに // lookup: encoder または // lookup: set の行を追加してください</translation>
    </message>
    <message>
        <source>the table is made for a drive that looks it up after the compensation, at the set position (lookup: set)</source>
        <translation>このテーブルは、補正後の指令位置で参照するドライブ用です (lookup: set)</translation>
    </message>
    <message>
        <source>the values are converted from those that the drive looks up after the compensation, at the set position (lookup: set)</source>
        <translation>値は、ドライブが補正後の指令位置で参照する値 (lookup: set) から変換したものです</translation>
    </message>
    <message>
        <source>the file of the table says lookup: {file}, and stated is {stated} (--lookup-at): correct the one that is wrong</source>
        <translation>テーブルのファイルでは lookup: {file}、指定は {stated} (--lookup-at) となっています。誤っている方を修正してください</translation>
    </message>
    <message>
        <source>while {name} was active the sources of the axis were others, so that its values may belong to other positions: measure again with what the axis has now</source>
        <translation>{name} が有効だったときは軸のソースが異なっていたため、値は別の位置のものかもしれません。現在の軸の設定で測定し直してください</translation>
    </message>
    <message>
        <source>The table stays, and its new source is on the other side of the compensation: its values belong to other positions. Write the table that was made for this source.</source>
        <translation>テーブルはそのまま残りますが、新しいソースは補正の反対側の位置です。値は別の位置のものになります。このソース用に作成したテーブルを書き込んでください。</translation>
    </message>
    <message>
        <source>the plan is in {planned}, and axis {axis} of the drive in {unit}: make a plan in {needed}, or choose another axis</source>
        <translation>測定計画の単位は {planned}、ドライブの軸 {axis} の単位は {unit} です。{needed} の測定計画を作成するか、別の軸を選んでください</translation>
    </message>
    <message>
        <source>The table that no axis used in {slot} is not restored: the table of this axis is there.</source>
        <translation>どの軸も使用していなかった {slot} のテーブルは復元されません。そこにはこの軸のテーブルがあります。</translation>
    </message>
    <message>
        <source>the values for {column} are said to be in the unit of the drive, and the positions that they are added to are in {unit}; state the unit of the values, or that the positions are in that of the drive, too</source>
        <translation>{column} の値はドライブの単位とされていますが、値が加算される位置の単位は {unit} です。値の単位を指定するか、位置もドライブの単位であると指定してください</translation>
    </message>
    <message>
        <source>{name} = {value}, which multiplies the table on the control</source>
        <translation>{name} = {value} (制御装置がテーブルに掛ける係数)</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply the values by the number (--scale)</source>
        <translation>1。この行を削除し、値にその数を掛けてください (--scale)</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, which cannot be given in {other}, the unit of the positions that they are added to; correct the units</source>
        <translation>{column} の値の単位 {unit} は、値が加算される位置の単位 {other} で表すことができません。単位を修正してください</translation>
    </message>
    <message>
        <source>{name} does not say the unit of its numbers, and its CRC-32 {crc} is the same in mm and in m, in degrees and in radians: take a calibration file in whose header the units stand, such as the one that reading the table from the drive writes</source>
        <translation>{name} には数値の単位がなく、CRC-32 {crc} は mm でも m でも、度でもラジアンでも同じです。ヘッダーに単位のある校正ファイル (ドライブからテーブルを読み出すと作成されるものなど) を使用してください</translation>
    </message>
    <message>
        <source>the axis had other sources with {name}, so that its values may belong to other positions: merge onto nothing (leave out --onto), since with the raw positions on file the values are the whole error</source>
        <translation>{name} のときは軸のソースが異なっていたため、その値は別の位置のものかもしれません。ファイルにエンコーダの補正前の位置があるため値は誤差全体です。統合しないでください (--onto を指定しない)</translation>
    </message>
    <message>
        <source>a gain is for residuals that are merged onto a table (--onto); here the values are the whole error</source>
        <translation>ゲインは、テーブルに統合する残差に使うものです (--onto)。ここでの値は誤差全体です</translation>
    </message>
    <message>
        <source>{name} is a table over {axes}, but what was measured is over {measured}: take a table over the same axes, in the same order</source>
        <translation>{name} は {axes} に対するテーブルですが、測定は {measured} に対するものです。同じ軸の、同じ順序のテーブルを使用してください</translation>
    </message>
    <message>
        <source>what was measured along one axis needs a table of one dimension; {name} has {dimensions}</source>
        <translation>1 軸に沿った測定には 1 次元のテーブルが必要です。{name} は {dimensions} 次元です</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} is of axis {axis}: take the table of the axis that was measured</source>
        <translation>測定されたのは軸 {measured} ですが、{name} は軸 {axis} のものです。測定した軸のテーブルを使用してください</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} corrects an axis that is no source: take the table of the axis that was measured, or state what the values correct (--target other)</source>
        <translation>測定されたのは軸 {measured} ですが、{name} はソースではない軸を補正します。測定した軸のテーブルを使用するか、値が何を補正するかを指定してください (--target other)</translation>
    </message>
    <message>
        <source>nothing is merged over temperature: leave out --onto, since with the raw positions on file the values are the whole error</source>
        <translation>温度依存テーブルでは統合できません。ファイルにエンコーダの補正前の位置があるため値は誤差全体です。--onto を指定しないでください</translation>
    </message>
    <message>
        <source>a unit that is not stated</source>
        <translation>(指定なし)</translation>
    </message>
    <message>
        <source>a time in s, ms, min or h, in brackets behind the name; without a unit it is in s</source>
        <translation>時間。単位は名前の後の角括弧に s、ms、min、h のいずれかで示す。単位がなければ s</translation>
    </message>
    <message>
        <source>a temperature in C, K or F, in brackets behind the name; without a unit it is in C</source>
        <translation>温度。単位は名前の後の角括弧に C、K、F のいずれかで示す。単位がなければ C</translation>
    </message>
    <message>
        <source>an angle as the first axis has</source>
        <translation>最初の軸と同じく角度</translation>
    </message>
    <message>
        <source>a length as the first axis has</source>
        <translation>最初の軸と同じく長さ</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>基準の位置</translation>
    </message>
    <message>
        <source>deviations</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>what --values says; leave it out, since the file says it</source>
        <translation>--values の指定と同じもの。ファイルからわかるので --values を省いてください</translation>
    </message>
    <message>
        <source>positions of the reference for --invert-reference; deviations with the opposite sign say it in the file (// sign: correction)</source>
        <translation>--invert-reference には基準の位置。符号が逆の偏差は、ファイルにその旨を書く (// sign: correction)</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the position</source>
        <translation>位置に対して傾き {slope} で増える値</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for all of these changes, {together}, but not for putting everything back if one fails; wait {seconds} s, or make fewer changes at a time</source>
        <translation>残りのフラッシュ操作はこれらすべての変更 ({together}) には足りますが、失敗時にすべてを元に戻すには足りません。{seconds} s 待つか、一度の変更を減らしてください</translation>
    </message>
    <message>
        <source>together these changes cost {together} flash operations, more than are possible now; wait {seconds} s, or make fewer changes at a time</source>
        <translation>これらの変更には合わせて {together} 回のフラッシュ操作が必要で、現在可能な回数を超えています。{seconds} s 待つか、一度の変更を減らしてください</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or, if it is right all the same, name the column after axis {axis} in the file</source>
        <translation>{doubt}別のソースまたは列を選んでください。それでも正しい場合は、ファイルの列に軸 {axis} の名前を付けてください</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the backup was made, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>バックアップの作成時に軸 {axis} は {target} でしたが、ドライブでは現在 {name} です。軸の順序または名前を元に戻すか、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>the {what} of the table on the drive are in {unit}, and the new source is in {other}; write the table from its file, together with the source</source>
        <translation>ドライブのテーブルの{what}の単位は {unit} ですが、新しいソースの単位は {other} です。ソースと一緒に、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>the {what} are in {unit} in the backup, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>{what}の単位はバックアップでは {unit} ですが、ドライブでは現在 {other} なので、同じ数値が別の意味になります。ドライブの単位を {unit} に戻すか、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>The table states no unit for the positions of dimension {number}; they are taken to be in {after}: {first} to {last}.</source>
        <translation>テーブルには次元 {number} の位置の単位がありません。{after} とみなします: {first} から {last}。</translation>
    </message>
    <message>
        <source>values of axis {axis}</source>
        <translation>軸 {axis} の値</translation>
    </message>
    <message>
        <source>positions of dimension {number} of axis {axis}</source>
        <translation>軸 {axis} の次元 {number} の位置</translation>
    </message>
    <message>
        <source>Axis {axis} was called {before} when the backup was made, and is called {after} now: see that it is the same axis.</source>
        <translation>軸 {axis} の名前は、バックアップの作成時は {before} でしたが、現在は {after} です。同じ軸であることを確認してください。</translation>
    </message>
    <message>
        <source>The backup does not say in which unit axis {axis} was; its table is taken to be in {unit}.</source>
        <translation>バックアップには軸 {axis} の単位がありません。テーブルの単位は {unit} とみなされます。</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are written in {unit} as they stand: the profile does not say the unit of {source}.</source>
        <translation>次元 {number} の位置は {unit} のまま書き込まれます。{source} の単位はプロファイルに示されていません。</translation>
    </message>
    <message>
        <source>axis {axis}, which is written first</source>
        <translation>先に書き込まれる軸 {axis}</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the numbers of the file were read in {unit}; leave the statement out</source>
        <translation>単位 {stated} が指定されましたが、ファイルの数値は {unit} で読み込まれています。指定を外してください</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: it is not activated. Finish that write with &apos;axiscomp recover --finish&apos;, undo it with &apos;axiscomp recover --undo&apos;, or write again. The old state is kept in {backup}</source>
        <translation>未完了の書き込みにより、軸 {axis} は旧状態でも新状態でもありません。有効化しません。&apos;axiscomp recover --finish&apos; で書き込みを完了するか、&apos;axiscomp recover --undo&apos; で取り消すか、もう一度書き込んでください。旧状態は {backup} に保存されています</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as http://user:password@host</source>
        <translation>{endpoint} にはユーザ名とパスワードが必要です。http://user:password@host の形で指定してください</translation>
    </message>
    <message>
        <source>{text} has no unit and is taken as {amount}, {fine}</source>
        <translation>{text} に単位がありません。{amount}（{fine}）とみなします</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as https://user:password@host</source>
        <translation>{endpoint} にはユーザ名とパスワードが必要です。https://user:password@host の形で指定してください</translation>
    </message>
    <message>
        <source>{path} is no position of axis {axis} before its compensation: name the register of its encoder</source>
        <translation>{path} は軸 {axis} の補正前の位置ではありません。エンコーダのレジスタを指定してください</translation>
    </message>
    <message>
        <source>&quot;{name}&quot;, which is taken to be a name without a unit</source>
        <translation>「{name}」は単位のない名前とみなした</translation>
    </message>
    <message>
        <source>a unit such as mm, um, inch, deg or arcsec, if {unit} is meant as one</source>
        <translation>{unit} が単位であれば mm、um、inch、deg、arcsec などの単位</translation>
    </message>
    <message>
        <source>decimal points, and blanks between the numbers; nobody can tell a decimal comma from one that separates two numbers</source>
        <translation>小数点にはピリオドを使い、数値の間は空白で区切ること。小数点のコンマと数値を区切るコンマは見分けられない</translation>
    </message>
    <message>
        <source>{key} without a value, or no {key}</source>
        <translation>値のない {key}、または {key} なし</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>小数点にピリオドを使った数値</translation>
    </message>
    <message>
        <source>several tables of {axes}</source>
        <translation>{axes} のテーブルが複数</translation>
    </message>
    <message>
        <source>their sum, since the controller adds them; a table that is converted alone is a part of it</source>
        <translation>制御装置が加算するので合計であること。単独で変換したテーブルはその一部にすぎない</translation>
    </message>
    <message>
        <source>&quot;{statement}&quot;, which switches a table of the file off</source>
        <translation>ファイルのテーブルを無効にする「{statement}」</translation>
    </message>
    <message>
        <source>tables that are in use; this one does not act on the machine</source>
        <translation>有効なテーブルであること。このテーブルは機械に作用しない</translation>
    </message>
    <message>
        <source>one unit for positions and offsets, which the controller adds; a calibration file is read with --from {format}</source>
        <translation>位置とオフセットは制御装置が加算するので同じ単位であること。校正ファイルは --from {format} で読み込む</translation>
    </message>
    <message>
        <source>{count} lines that are taken to be headers, the first of them &quot;{line}&quot;</source>
        <translation>見出しとみなした {count} 行（最初の行は「{line}」）</translation>
    </message>
    <message>
        <source>decimal points, and a comma with a blank between the values; nobody can tell a decimal comma from one that separates two values</source>
        <translation>小数点にはピリオドを使い、値の間はコンマと空白で区切ること。小数点のコンマと値を区切るコンマは見分けられない</translation>
    </message>
    <message>
        <source>numbers in {unit}, as the file says</source>
        <translation>ファイルの記載では数値は {unit}</translation>
    </message>
    <message>
        <source>{unit}, as the setting says</source>
        <translation>設定のとおり {unit}</translation>
    </message>
    <message>
        <source>{name}, which is changed by a statement of the program</source>
        <translation>プログラムの文で変更される {name}</translation>
    </message>
    <message>
        <source>the declaration alone; the table is that of the declaration, since statements are not computed</source>
        <translation>宣言のみであること。文は計算しないので、テーブルは宣言のもの</translation>
    </message>
    <message>
        <source>axis {axis}, and axis {before} in line {line}</source>
        <translation>軸 {axis} ({line} 行目では軸 {before})</translation>
    </message>
    <message>
        <source>the measurement of one axis; make a file for each axis</source>
        <translation>1 つの軸の測定。軸ごとにファイルを分けてください</translation>
    </message>
    <message>
        <source>{second}, and {first} in line {line}</source>
        <translation>{second}、{line} 行目は {first}</translation>
    </message>
    <message>
        <source>one statement of it</source>
        <translation>1 つの記述</translation>
    </message>
    <message>
        <source>this statement before the header, since it holds for every line</source>
        <translation>ヘッダーより前のこの指定 (すべての行に適用されるため)</translation>
    </message>
    <message>
        <source>further sections behind EOF::</source>
        <translation>EOF:: より後のセクション</translation>
    </message>
    <message>
        <source>one measurement in a file; make a file of each</source>
        <translation>1 ファイルに 1 つの測定。それぞれを別のファイルにしてください</translation>
    </message>
    <message>
        <source>which it is: // values: deviation or // values: reference before the header, or --values</source>
        <translation>どちらかの指定: ヘッダーより前の // values: deviation または // values: reference、もしくは --values</translation>
    </message>
    <message>
        <source>axis {axis} of the machine file</source>
        <translation>機械ファイルの軸 {axis}</translation>
    </message>
    <message>
        <source>a position and an error in mm, with decimal points and without separators of thousands</source>
        <translation>位置と誤差 (mm)。小数点を使用し、桁区切りは付けません</translation>
    </message>
    <message>
        <source>a position without a forward mean</source>
        <translation>往路の平均値がない位置</translation>
    </message>
    <message>
        <source>for a run its direction and number, such as up2 or down1</source>
        <translation>走行の列には up2 や down1 のような方向と番号</translation>
    </message>
    <message>
        <source>sign: feedback or sign: command; where the values are encoder minus reference, leave the line out, and turn them with --scale -1</source>
        <translation>sign: feedback または sign: command。値がエンコーダ値から基準値を引いたものである場合は、この行を削除し、--scale -1 で反転してください</translation>
    </message>
    <message>
        <source>the table states no unit for its values, and its positions are in {positions}; state the unit of the values, in the file or with --value-unit</source>
        <translation>テーブルに値の単位がなく、位置の単位は {positions} です。値の単位をファイルに書くか、--value-unit で指定してください</translation>
    </message>
    <message>
        <source>the values for {column} have no unit, and the positions are in {positions}; state it in the header, as Z [mm], or as the setting {key} of the file that is read</source>
        <translation>{column} の値に単位がなく、位置の単位は {positions} です。ヘッダーに Z [mm] のように書くか、読み込むファイルの設定 {key} で指定してください</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. The positions have different units, and it is not stated which one that is: convert to a .csv file first, and that one with --value-unit, such as --value-unit mm, or, if the values correct the axis of one of the positions, state the target, such as #1 for the first</source>
        <translation>.TAMtbl には単位がなく、ドライブは値を、補正する軸の単位として読み込みます。位置の単位が異なり、どれがその単位か指定されていません。まず .csv ファイルに変換してから、それを --value-unit mm のように --value-unit を付けて変換してください。値がいずれかの位置の軸を補正する場合は、対象軸を指定してください (1 番目なら #1)</translation>
    </message>
    <message>
        <source>{number} in a column with {whole}</source>
        <translation>{whole} のある列に {number}</translation>
    </message>
    <message>
        <source>numbers that show whether the point stands between thousands: no point in {number}, or the same decimals in {whole}</source>
        <translation>点が桁区切りかどうかが分かる数値：{number} を点なしで、または {whole} にも同じ小数桁</translation>
    </message>
    <message>
        <source>the axis is taken to count from {from} to {to}, and steps of {distance} do not lead from one end over the targets to the other; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>軸は {from} から {to} まで数えるとみなしますが、{distance} 刻みでは一方の端から目標位置を通って他方の端に達しません。テーブルの格子を指定してください：点数、間隔、または曲線からの許容差（--points、--distance または --within）</translation>
    </message>
    <message>
        <source>the table in {slot} stays in flash, because {user} uses it too; free it there first, with a persistent write into another slot</source>
        <translation>{slot} のテーブルは {user} も使用しているため、フラッシュに残します。先にそちらで別のスロットに不揮発で書き込み、解放してください</translation>
    </message>
    <message>
        <source>Flash keeps the table in {slot}: after a reboot {axis} uses it again. Delete the table first (&apos;axiscomp delete&apos;) if it must not come back.</source>
        <translation>{slot} のテーブルはフラッシュに残り、再起動すると {axis} は再びそのテーブルを使用します。元に戻らないようにするには、先にテーブルを削除してください (&apos;axiscomp delete&apos;)。</translation>
    </message>
    <message>
        <source>the axis has the values of the record&apos;s table, {crc}, over other positions: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>軸には記録のテーブルの値 {crc} がありますが、位置が異なります。記録のテーブルを書き込み直すか (`axiscomp write --record`)、記録を指定しないでください</translation>
    </message>
    <message>
        <source>The table stays, and {source} is a position of another axis: its values belong to positions of the axis itself. Write the table that was made for this source.</source>
        <translation>テーブルはそのまま残りますが、{source} は別の軸の位置です。値はその軸自身の位置のものです。このソース用に作成したテーブルを書き込んでください。</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, and {first} and {second} have the same values over other positions: merge onto the file of the one that was active (--onto)</source>
        <translation>測定時に有効だったテーブルは {crc} ですが、{first} と {second} は同じ値を異なる位置に持っています。有効だったほうのテーブルのファイルに統合してください (--onto)</translation>
    </message>
    <message>
        <source>{axis} is the name of axis {named} and the index of axis {numbered}; say name:{axis} or {index}</source>
        <translation>{axis} は軸 {named} の名前でも、軸 {numbered} のインデックスでもあります。name:{axis} または {index} と指定してください</translation>
    </message>
    <message>
        <source>there is no name on the drive</source>
        <translation>ドライブに名前がありません</translation>
    </message>
    <message>
        <source>the program must define the target axes of the table in the order of the corrections: {axes}</source>
        <translation>プログラムでテーブルの対象軸を補正値の順に定義してください: {axes}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} says {value}, and the table goes from {column}</source>
        <translation>形式 {format} の設定 {key} は {value} ですが、テーブルの対応は {column} です</translation>
    </message>
    <message>
        <source>positions with {all} combinations in the first {count} data lines</source>
        <translation>最初の {count} データ行で {all} 通りの組合せになる位置</translation>
    </message>
    <message>
        <source>a line for every combination of the positions; fit makes a table of scattered points</source>
        <translation>位置のすべての組合せに対する行。散在する点からは fit でテーブルを作成できます</translation>
    </message>
    <message>
        <source>the first measurement is corrected and the second is not, so that they cannot be compared: save the record and correct the second one with `axiscomp compare --record`, or state in its file that its values are at 20 °C (// corrected: 20C)</source>
        <translation>1 回目の測定は補正されていますが、2 回目は補正されていないため比較できません。記録を保存して `axiscomp compare --record` で 2 回目を補正するか、値が 20 °C のものであることをファイルに記載してください (// corrected: 20C)</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; can be read in two ways; write thousands without a sign between them</source>
        <translation>「{text}」は 2 通りに読めます。桁区切りなしで入力してください</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. These are in {unit} and the positions in {positions}, none of which is that of the axis for certain: convert to a .csv file first, and that one with --value-unit and the unit of the axis, such as --value-unit {example}</source>
        <translation>.TAMtbl には単位がなく、ドライブはその値を補正する軸の単位で扱います。この値は {unit}、位置は {positions} で、どれも軸の単位であるとは限りません。まず .csv ファイルに変換し、それを --value-unit と軸の単位 (--value-unit {example} など) で変換してください</translation>
    </message>
    <message>
        <source>sign: correction, and positions of the reference</source>
        <translation>sign: correction と基準の位置</translation>
    </message>
    <message>
        <source>no sign with positions of the reference, which are what they are; or deviations with their sign</source>
        <translation>基準の位置には符号を付けず、そのままの値とするか、符号を明記した偏差とする</translation>
    </message>
    <message>
        <source>the two directions of the track have no part of the way in common: make the table of one of them (--direction positive or negative)</source>
        <translation>連続測定の両方向に共通の区間がありません。一方の方向のテーブルを作成してください(--direction positive または negative)</translation>
    </message>
    <message>
        <source>the table is looked up at the desired position of its sources (D); with position=actual at the actual one</source>
        <translation>テーブルは元の軸の指令位置 (D) で参照されます。position=actual では実際の位置で参照されます</translation>
    </message>
    <message>
        <source>the table is looked up at the actual position of its sources; with position=desired at the desired one (D)</source>
        <translation>テーブルは元の軸の実際の位置で参照されます。position=desired では指令位置 (D) で参照されます</translation>
    </message>
    <message>
        <source>max_points {number} of the source is left out: the table has {count} points</source>
        <translation>元の max_points {number} は省かれます。テーブルは {count} 点あります</translation>
    </message>
    <message>
        <source>the encoder moves {slope} times as far as the targets</source>
        <translation>エンコーダの動きは目標位置の {slope} 倍です</translation>
    </message>
    <message>
        <source>1 within 1 %; correct the column of the encoder, or take it out of the file</source>
        <translation>1 (誤差 1 % 以内)。エンコーダの列を修正するか、ファイルから取り除いてください</translation>
    </message>
    <message>
        <source>columns separated by , or ; instead of tabs</source>
        <translation>タブではなく , または ; で区切られた列</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: what can be read of it is half of that write. Finish it with &apos;axiscomp recover --finish&apos;, or undo it with &apos;axiscomp recover --undo&apos;. The old state is kept in {backup}</source>
        <translation>未完了の書き込みにより、軸 {axis} は旧状態でも新状態でもありません。読み取れるのは途中までの書き込みです。&apos;axiscomp recover --finish&apos; で書き込みを完了するか、&apos;axiscomp recover --undo&apos; で取り消してください。旧状態は {backup} に保存されています</translation>
    </message>
    <message>
        <source>the name of the table, {table}, says that its values correct {target}, but for axis {axis} {role}; choose another table or axis, or, if it is right all the same, write the table to this axis from its file first, and state the target as {statement} there</source>
        <translation>テーブルの名前 {table} によると値は {target} を補正しますが、軸 {axis} では次のとおりです: {role}。テーブルまたは軸を選び直すか、それでも正しい場合は、先にファイルからこの軸へテーブルを書き込み、その際に対象軸を {statement} と指定してください</translation>
    </message>
    <message>
        <source>mm, or both units stated: that of the positions (--unit) and that of the errors (--value-unit)</source>
        <translation>mm、または両方の単位の指定: 位置の単位 (--unit) と誤差の単位 (--value-unit)</translation>
    </message>
    <message>
        <source>kind: runs, or kind: averages (means of runs)</source>
        <translation>kind: runs または kind: averages (走行の平均値)</translation>
    </message>
    <message>
        <source>one mean for each target and direction</source>
        <translation>目標位置と方向ごとに平均値は 1 つ</translation>
    </message>
    <message>
        <source>the second measurement is of the drive with the serial number {found}, and the first one or its table is of the one with {known}; measure that drive, or, where it was replaced since, correct the line // drive: in the file of the second</source>
        <translation>2 回目の測定はシリアル番号 {found} のドライブのものですが、1 回目の測定またはそのテーブルは {known} のドライブのものです。そのドライブを測定するか、その後交換した場合は 2 回目のファイルの行 // drive: を修正してください</translation>
    </message>
    <message>
        <source>measurements of the drive with the serial number {drive} and of the one with {other} cannot be joined; take those of one drive, and where it was replaced in between, correct the line // drive: of the files</source>
        <translation>シリアル番号 {drive} のドライブの測定と {other} のドライブの測定は結合できません。1 台のドライブのものだけを使用し、途中で交換した場合はファイルの行 // drive: を修正してください</translation>
    </message>
    <message>
        <source>the record was made of a measurement of the drive with the serial number {measured}, and this is {found}; connect the drive that was measured, or, where it was replaced since, correct the line // drive: of the measurement&apos;s file and begin a new record with it</source>
        <translation>記録はシリアル番号 {measured} のドライブの測定から作成されたものですが、これは {found} です。測定したドライブを接続するか、その後交換した場合は測定ファイルの行 // drive: を修正し、それで新しい記録を作成してください</translation>
    </message>
    <message>
        <source>axis {axis} used {slot}, and the file of this slot is missing</source>
        <translation>軸 {axis} は {slot} を使用していましたが、このスロットのファイルがありません</translation>
    </message>
    <message>
        <source>the deletion of {slot} for axis {axis} can only be finished: the saved parameters that would bring its table back after a reboot are not known; the backup has the table</source>
        <translation>軸 {axis} の {slot} の削除は完了させることしかできません: 再起動後にそのテーブルを復活させる保存済みパラメータが不明です。テーブルはバックアップにあります</translation>
    </message>
    <message>
        <source>the line // drive: of the file says that the drive with the serial number {expected} was measured, and this one has {found}: connect that drive, or, where it was replaced since, correct the line or remove it</source>
        <translation>ファイルの行 // drive: によると、測定されたのはシリアル番号 {expected} のドライブですが、このドライブは {found} です。測定したドライブを接続するか、その後交換した場合はこの行を修正または削除してください</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, and another of its comments the serial number {serial}: a table is made of the measurement of one drive, so correct the wrong line, or leave it out</source>
        <translation>ファイルに &quot;{note}&quot; とあり、別のコメントにはシリアル番号 {serial} とあります。テーブルは 1 台のドライブの測定から作成されるものなので、誤っている行を修正または削除してください</translation>
    </message>
    <message>
        <source>the drive does not read the table in {slot} as the layout of the profile has it: of dimension {dimension} the drive shows {found} where the layout has {expected}. Compare {layout} in the profile with the drive&apos;s table file</source>
        <translation>ドライブは {slot} のテーブルをプロファイルのレイアウトどおりに読んでいません。次元 {dimension} について、ドライブの表示は {found} ですが、レイアウトでは {expected} です。プロファイルの {layout} をドライブのテーブルファイルと比べてください</translation>
    </message>
    <message>
        <source>dimension {number} of the table on the drive is one of {before}, and {source} is something else: one of them is a position, the other a temperature; write the table from its file, together with the source</source>
        <translation>ドライブのテーブルの次元 {number} は {before} のもので、{source} は別の量です。一方は位置、他方は温度です。ソースと一緒に、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>The table stays, its dimension {number} has positions of an axis, and the profile does not say what {source} is. Write the table that was made for this source.</source>
        <translation>テーブルはそのまま残り、その次元 {number} は軸の位置ですが、{source} が何であるかはプロファイルにありません。このソース用に作成したテーブルを書き込んでください。</translation>
    </message>
    <message>
        <source>The backup of axis {axis} does not say with which profile it was made; its table is read with the profile {profile}.</source>
        <translation>軸 {axis} のバックアップには、作成に使ったプロファイルがありません。テーブルはプロファイル {profile} で読み取られます。</translation>
    </message>
    <message>
        <source>the backup was made with the profile {before}, which has another layout of table files than {profile}: restore it with that profile (--profile), or, on a drive that needs the other one, write the table from its file</source>
        <translation>バックアップはプロファイル {before} で作成されており、テーブルファイルのレイアウトが {profile} と異なります。そのプロファイルで復元する (--profile) か、もう一方のプロファイルが必要なドライブでは、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>The layout of table files in the profile {profile} has been changed since the backup was made: see that the table is right.</source>
        <translation>プロファイル {profile} のテーブルファイルのレイアウトは、バックアップの作成後に変更されています。テーブルが正しいことを確認してください。</translation>
    </message>
    <message>
        <source>the register {path} is in {name} too</source>
        <translation>レジスタ {path} は {name} にもあります</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}, and an import does not move a table from one axis to another: write the table to axis {imported} from its file, and name the slot that it gets there in the configuration</source>
        <translation>スロット {slot} は {user} が使用しており、インポートはテーブルをある軸から別の軸へ移しません。ファイルからテーブルを軸 {imported} に書き込み、そこで割り当てられたスロットを構成に指定してください</translation>
    </message>
    <message>
        <source>interval of a square grid, or interval1 and interval2 of a grid RECTANGULAR</source>
        <translation>正方格子の interval、または格子 RECTANGULAR の interval1 と interval2</translation>
    </message>
    <message>
        <source>parameter {number} of {value}</source>
        <translation>値 {value} のパラメータ {number}</translation>
    </message>
    <message>
        <source>a number with a decimal point, to compare it with the setting {key} of {value}; the file does not say what unit it is in without one</source>
        <translation>設定 {key} の値 {value} と比べられる、小数点付きの数値。小数点がないと、ファイルからは単位が分かりません</translation>
    </message>
    <message>
        <source>{name} = {value}, with which the lengths of the table are in inches</source>
        <translation>{name} = {value} (テーブルの長さはインチ)</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply positions and values in inches by 25.4</source>
        <translation>1。この行を削除し、インチの位置と値に 25.4 を掛けてください</translation>
    </message>
    <message>
        <source>what SECONDARY stands for, such as inch</source>
        <translation>SECONDARY が表す単位 (inch など)</translation>
    </message>
    <message>
        <source>counts of each axis for one primary-unit; without it what is in COUNTS stays in counts</source>
        <translation>1 primary-unit あたりの各軸のカウント数。省略時、COUNTS の数値はカウント単位のまま</translation>
    </message>
    <message>
        <source>{key} ENGLISH of the rotary axis {axis}</source>
        <translation>回転軸 {axis} の {key} ENGLISH</translation>
    </message>
    <message>
        <source>METRIC, which is degrees there; inches are lengths</source>
        <translation>METRIC (その軸では度)。インチは長さの単位です</translation>
    </message>
    <message>
        <source>two kinds of units in one table</source>
        <translation>1 つのテーブルに 2 種類の単位</translation>
    </message>
    <message>
        <source>the settings {key} and {key2}</source>
        <translation>設定 {key} と {key2}</translation>
    </message>
    <message>
        <source>the instrument says {line}: another number follows its first one, as in degrees, minutes and seconds; set it to one decimal number, or say what the number is with a pattern</source>
        <translation>測定器の出力 {line} では、度・分・秒のように最初の数値の後に別の数値が続いています。測定器を 1 つの小数の出力に設定するか、数値をパターンで指定してください</translation>
    </message>
    <message>
        <source>the axis lost its homing in mid-measurement, as after a restart of the drive; its positions are others after it is homed again: begin a new file</source>
        <translation>測定の途中で、ドライブの再起動などにより、軸の原点復帰状態が失われました。再び原点復帰すると位置が変わります。新しいファイルで始めてください</translation>
    </message>
    <message>
        <source>the file says sign: {file}, and stated is {stated}: correct the one that is wrong</source>
        <translation>ファイルでは sign: {file}、指定は {stated} となっています。誤っている方を修正してください</translation>
    </message>
    <message>
        <source>{file} says sign: command, and a table that was active holds feedback values: convert the file first, and take what is written</source>
        <translation>{file} には sign: command とありますが、有効だったテーブルの値はフィードバック側 (feedback) です。先にファイルを変換し、書き出されたものを使ってください</translation>
    </message>
    <message>
        <source>the table that is active lies over other positions or sources than at the beginning; what was taken belongs to the one before: begin a new file</source>
        <translation>有効なテーブルの位置またはソースが開始時と異なります。これまでの値は前のテーブルのものです。新しいファイルで始めてください</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to in {other}; state how many counts are one unit, with the setting {key} of the file that is read</source>
        <translation>{column} の値の単位は {unit}、値が加算される位置の単位は {other} です。1 単位が何カウントかを、読み取るファイルの設定 {key} で指定してください</translation>
    </message>
    <message>
        <source>the setting {key} for numbers in counts</source>
        <translation>カウント単位の数値に対する設定 {key}</translation>
    </message>
    <message>
        <source>the setting {key}, which says how many of them are one unit</source>
        <translation>1 単位が何カウントかを示す設定 {key}</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, which is for files of measurements: a table holds reference minus encoder (sign: feedback), or what is added to the command (sign: command). Correct that line; where the values are encoder minus reference, leave it out, and turn them with --scale -1</source>
        <translation>ファイルに &quot;{note}&quot; とありますが、これは測定ファイル用です。テーブルの値は、基準値からエンコーダ値を引いたもの (sign: feedback) か、指令に加算されるもの (sign: command) です。この行を修正してください。値がエンコーダ値から基準値を引いたものである場合は、この行を削除し、--scale -1 で反転してください</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, sign: feedback or sign: command, says what the values are: correct that line, or leave it out, which means feedback</source>
        <translation>ファイルに &quot;{note}&quot; とあります。ここでは、値が何であるかを sign: feedback または sign: command のコメント 1 つで示します。この行を修正するか、削除してください (削除すると feedback とみなします)</translation>
    </message>
    <message>
        <source>1; as it stands in the file it follows the axis: leave --invert-reference out</source>
        <translation>1。ファイルのままで軸に追従しています。--invert-reference を外してください</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>このドライブのフラッシュ操作の履歴が破損していたため、すべて使い切ったものとみなしています。&apos;axiscomp status --reset-flash-count&apos; で回数をリセットしてください</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s</source>
        <translation>残りのフラッシュ操作は変更には足りますが、失敗時にすべてを元に戻すには足りません。{seconds} s 待ってください</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s</source>
        <translation>短時間のフラッシュ操作が多すぎます。{seconds} s 待ってください</translation>
    </message>
    <message>
        <source>{stated}, stated as the axis that the values of {column} correct, may be one of the sources or not, since their names do not tell it, and the numbers depend on it; state the target: {sources}</source>
        <translation>{column} の値が補正する軸として指定された {stated} は、ソースの名前からはソースの 1 つかどうか分かりません。数値はこれによって変わるため、対象軸を指定してください: {sources}</translation>
    </message>
    <message>
        <source>an answer of the drive itself and not one that a cache or proxy in between has kept; connect to the drive without it</source>
        <translation>途中のキャッシュまたはプロキシが保存していた応答ではなく、ドライブ自身の応答 (それを経由せずにドライブに接続してください)</translation>
    </message>
    <message>
        <source>no Content-Encoding but identity</source>
        <translation>identity 以外の Content-Encoding がないこと</translation>
    </message>
    <message>
        <source>nothing after the bytes that Content-Length announces</source>
        <translation>Content-Length が示すバイトの後に何もないこと</translation>
    </message>
    <message>
        <source>a Directory page with its Content-Length, or up to &lt;/html&gt;</source>
        <translation>Content-Length があるか、&lt;/html&gt; まである Directory ページ</translation>
    </message>
    <message>
        <source>the file in {slot} is no table that the profile can read: it is in the backup as it is, but cannot be restored as the table of an axis</source>
        <translation>{slot} のファイルはプロファイルで読めるテーブルではありません。そのままバックアップに入っていますが、軸のテーブルとしては復元できません</translation>
    </message>
    <message>
        <source>the drive has taken the command that stores the table in {slot}, but has counted no flash cycle for it ({cycles} before and after): it is not known to be in flash, and may be gone after a reboot</source>
        <translation>ドライブは {slot} のテーブルを保存するコマンドを受け付けましたが、そのためのフラッシュ書き換えが数えられていません (前後とも {cycles} 回)。テーブルがフラッシュにあるとは確認できず、再起動すると失われるおそれがあります</translation>
    </message>
    <message>
        <source>what a write that did not end has left of axis {axis} is not known: the backup of its old state, {backup}, cannot be read. Write again or restore another backup, which puts an end to it</source>
        <translation>未完了の書き込みにより軸 {axis} がどの状態にあるかは不明です。旧状態のバックアップ {backup} を読み取れません。もう一度書き込むか、別のバックアップを復元すると、未完了の書き込みは終了します</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the setting {key} says {unit}; leave one of them out</source>
        <translation>単位 {stated} が指定されていますが、設定 {key} は {unit} です。どちらか一方を外してください</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected a unit; that numbers are in the unit of the drive is stated as {option} of {command}, or as {key} beside the settings of a machine file</source>
        <translation>設定 {key} は「{value}」ですが、単位が必要です。数値がドライブの単位であることは、{command} の {option}、またはマシンファイルの設定の外の {key} で指定します</translation>
    </message>
    <message>
        <source>&quot;{note}&quot;, as another comment says; leave one of them out</source>
        <translation>別のコメントにある「{note}」。どちらか一方を外してください</translation>
    </message>
    <message>
        <source>{axes} as the setting {key}</source>
        <translation>設定 {key} の {axes}</translation>
    </message>
    <message>
        <source>an axis of the file: {axes}</source>
        <translation>ファイルにある軸: {axes}</translation>
    </message>
    <message>
        <source>{ranges}: nothing of what was measured first is measured again; measure over the targets of the first measurement</source>
        <translation>{ranges}: 1 回目に測定した範囲が 2 回目の測定に含まれていません。1 回目の測定の目標位置で測定してください</translation>
    </message>
    <message>
        <source>1; some values are whole turns away, since the instrument begins again at 360 deg: let it count on, or write -0.0001 in place of 359.9999 in the file</source>
        <translation>1。測定器が 360° で最初に戻るため、一部の値が 1 回転の整数倍ずれています。続けて数えるように設定するか、ファイルの 359.9999 を -0.0001 と書いてください</translation>
    </message>
    <message>
        <source>no installed font has {characters}, so that empty boxes would stand in the PDF: install one that has them, such as fonts-noto-cjk for Chinese and Japanese, or write the report as HTML</source>
        <translation>{characters} を含むフォントがインストールされていないため、PDF では空白の四角になります。これらの文字を含むフォント (中国語・日本語なら fonts-noto-cjk など) をインストールするか、報告書を HTML で書き出してください</translation>
    </message>
    <message>
        <source>the values of {table} correct {target}, but for axis {axis} {role}; choose another column, axis or source, or, if it is right all the same, state the target as {statement} when the file is read</source>
        <translation>{table} の値は {target} を補正しますが、軸 {axis} では次のとおりです: {role}。列、軸またはソースを選び直すか、それでも正しい場合はファイルの読み込み時に対象軸を {statement} と指定してください</translation>
    </message>
    <message>
        <source>the file does not say what the values of {table} correct. They were converted for {target}, but for axis {axis} {role}: read the file again with these sources, or state its target</source>
        <translation>{table} の値がどの軸を補正するかはファイルに記載されていません。値は {target} 用に変換されましたが、軸 {axis} では次のとおりです: {role}。このソースでファイルを読み直すか、対象軸を指定してください</translation>
    </message>
    <message>
        <source>a source is no position of an axis</source>
        <translation>軸の位置ではないソースがあります</translation>
    </message>
    <message>
        <source>the table was made for a position before the compensation, and {source} is one after it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at set)</source>
        <translation>テーブルは補正前の位置用ですが、{source} は補正後の位置です。別のソースを選ぶか、測定または元のコントローラのファイルからこのソース用にテーブルを作り直してください (コマンドラインでは --lookup-at set)</translation>
    </message>
    <message>
        <source>the table was made for a position after the compensation, and {source} is one before it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at encoder)</source>
        <translation>テーブルは補正後の位置用ですが、{source} は補正前の位置です。別のソースを選ぶか、測定または元のコントローラのファイルからこのソース用にテーブルを作り直してください (コマンドラインでは --lookup-at encoder)</translation>
    </message>
    <message>
        <source>the instrument says {line}: it is not clear where its number begins and ends; set it to one decimal number and its unit, or say what the number is with a pattern</source>
        <translation>測定器の出力 {line} では、数値の始まりと終わりが分かりません。測定器を 1 つの小数とその単位の出力に設定するか、数値をパターンで指定してください</translation>
    </message>
    <message>
        <source>another program has replaced, changed or deleted it since it was opened; look which values it has before you go on with it</source>
        <translation>開いた後に別のプログラムがこのファイルを置き換えたか、変更または削除しました。続ける前に、ファイルに残っている値を確認してください</translation>
    </message>
    <message>
        <source>column {column}, and values: {said}</source>
        <translation>列 {column} と values: {said}</translation>
    </message>
    <message>
        <source>one of the two; a column value goes with both</source>
        <translation>どちらか一方。列名 value ならどちらとも使えます</translation>
    </message>
    <message>
        <source>the controller adds the tables for {axis}: the sign of each is converted, and each is compared, as if it were alone</source>
        <translation>コントローラは {axis} のテーブルを加算します。符号の変換と比較は、テーブルごとに単独のものとして行っています</translation>
    </message>
    <message>
        <source>a second table that belongs to the same motor</source>
        <translation>同じモータに属する 2 つ目のテーブル</translation>
    </message>
    <message>
        <source>one for each motor; the last one counts</source>
        <translation>モータごとに 1 つ。最後のものを使います</translation>
    </message>
    <message>
        <source>begins again at the other end</source>
        <translation>反対側の端に戻って繰り返します</translation>
    </message>
    <message>
        <source>another axis than that of the first source</source>
        <translation>1 番目のソースとは別の軸</translation>
    </message>
    <message>
        <source>one number; line {line} gives it another one for the next pass of the loop</source>
        <translation>1 つの数値。行 {line} で、ループの次の繰り返しのために別の数値を代入しています</translation>
    </message>
    <message>
        <source>one number; another part of the program gives it another one in line {line}</source>
        <translation>1 つの数値。行 {line} でプログラムの別の部分が別の数値を代入しています</translation>
    </message>
    <message>
        <source>a name that got a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether that of line {line} counts</source>
        <translation>IF、ELSE、SWITCH、LOOP、WHILE、ON の外で数値が代入された名前。行 {line} の数値が有効かどうかはコントローラにしか分かりません</translation>
    </message>
    <message>
        <source>a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether this one counts</source>
        <translation>IF、ELSE、SWITCH、LOOP、WHILE、ON の外の数値。この数値が有効かどうかはコントローラにしか分かりません</translation>
    </message>
    <message>
        <source>numbers for the elements of {name} alone; what else changes the array behind them is not computed</source>
        <translation>{name} の要素の数値のみであること。その後で配列をほかの方法で変更する文は計算しない</translation>
    </message>
    <message>
        <source>The new table is volatile: after a reboot the axis has the old, persistent one again, or none where the parameters have been saved since then.</source>
        <translation>新しいテーブルは揮発です。再起動すると、軸は以前の不揮発のテーブルに戻ります。それまでにパラメータを保存した場合は、テーブルなしになります。</translation>
    </message>
    <message>
        <source>the setting {key} says {value} for tables of different axes, {axes}; choose one of the tables (--table), or leave the setting out</source>
        <translation>設定 {key} は異なる軸 {axes} のテーブルに対して {value} を指定しています。テーブルを 1 つ選ぶか (--table)、設定を省いてください</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the set position: use it with such sources only</source>
        <translation>新しいファイルには、ドライブが指令位置で参照する必要があることが記されません。そのような入力源でのみ使用してください</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the encoder position: use it with such sources only</source>
        <translation>新しいファイルには、ドライブがエンコーダの位置で参照する必要があることが記されません。そのような入力源でのみ使用してください</translation>
    </message>
    <message>
        <source>the new file does not say that the drive with the serial number {serial} was measured, as its source does: use it for that drive only</source>
        <translation>元のファイルと違い、新しいファイルには、シリアル番号 {serial} のドライブが測定されたことが記されません。そのドライブにのみ使用してください</translation>
    </message>
    <message>
        <source>several tables are called {table}; choose one by its number, such as #1: {alike}</source>
        <translation>{table} という名前のテーブルが複数あります。#1 のように番号で選んでください: {alike}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid list of positions: {count} problems</source>
        <comment>{file} is not a valid list of positions: one problem</comment>
        <translation>
            <numerusform>{file} は有効な位置のリストではありません: 問題 {count} 件</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} is UTF-16 text; save it as UTF-8 text</source>
        <translation>{file} は UTF-16 のテキストです。UTF-8 のテキストで保存してください</translation>
    </message>
    <message>
        <source>one value for each target, direction and run, or a number for each run</source>
        <translation>目標位置、方向、走行ごとに値は 1 つ、または走行ごとの番号</translation>
    </message>
    <message>
        <source>nobody has published that the numbers begin at line N{first} (first-record): compare with a file of this controller</source>
        <translation>番号が行 N{first} から始まること (first-record) は公開されていません。このコントローラのファイルと比べてください</translation>
    </message>
    <message>
        <source>nobody has published that a value is at most {most} (largest-step): compare with a file of this controller</source>
        <translation>値が {most} 以下であること (largest-step) は公開されていません。このコントローラのファイルと比べてください</translation>
    </message>
    <message>
        <source>this counts only with {member}, which is missing</source>
        <translation>{member} とそろって初めて有効ですが、それが欠落しています</translation>
    </message>
    <message>
        <source>it states no term of the uncertainty</source>
        <translation>不確かさの成分が 1 つも記載されていません</translation>
    </message>
    <message>
        <source>the {what} were in {unit} when the write began, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>{what}の単位は書き込みの開始時には {unit} でしたが、ドライブでは現在 {other} なので、同じ数値が別の意味になります。ドライブの単位を {unit} に戻すか、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the write began, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>書き込みの開始時に軸 {axis} は {target} でしたが、ドライブでは現在 {name} です。軸の順序または名前を元に戻すか、ファイルからテーブルを書き込んでください</translation>
    </message>
    <message>
        <source>the {what} of the record&apos;s table were in {unit} when it was written, and the drive has them in {other} now, so that the same numbers mean something else; set the unit on the drive to {unit} again, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>記録のテーブルの{what}の単位は書き込み時には {unit} でしたが、ドライブでは現在 {other} なので、同じ数値が別の意味になります。ドライブの単位を {unit} に戻すか、記録のテーブルを書き込み直してください (`axiscomp write --record`)</translation>
    </message>
    <message>
        <source>an unknown unit</source>
        <translation>不明な単位</translation>
    </message>
    <message>
        <source>the record does not say in which unit the axis was when its table was written, and in {unit}, as the axis is now, none of its tables is the one on the drive: set the unit that the axis had, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>テーブルを書き込んだときの軸の単位が記録にありません。軸の現在の単位 {unit} では、記録のどのテーブルもドライブのテーブルと一致しません。軸の元の単位に戻すか、記録のテーブルを書き込み直してください (`axiscomp write --record`)</translation>
    </message>
    <message>
        <source>{example}: the file says {value}</source>
        <translation>{example}: ファイルの値は {value}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller takes the axis to be at {moved}</source>
        <translation>エンコーダが {place} のとき、コントローラは軸の位置を {moved} とみなす</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller takes {axis} to be at {moved}</source>
        <translation>各エンコーダが {place} のとき、コントローラは {axis} の位置を {moved} とみなす</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller adds {value} to the position of {axis}</source>
        <translation>エンコーダが {place} のとき、コントローラは {axis} の位置に {value} を加える</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller adds {value} to the position of {axis}</source>
        <translation>各エンコーダが {place} のとき、コントローラは {axis} の位置に {value} を加える</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}</source>
        <translation>指令位置 {place} では、コントローラはエンコーダを {moved} へ動かす</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}</source>
        <translation>指令位置 {place} では、コントローラは {axis} のエンコーダを {moved} へ動かす</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves {target} by {value}</source>
        <translation>指令位置 {place} では、コントローラは {target} を {value} 動かす</translation>
    </message>
    <message>
        <source>the configuration names the table in {slot} for axis {axis}, but the drive has none there: write the table to the axis from its file and name the slot that it gets in the configuration, or write it into {slot} with &apos;axiscomp write --slot {slot}&apos;</source>
        <translation>構成では軸 {axis} に {slot} のテーブルが指定されていますが、ドライブのそのスロットにテーブルがありません。ファイルからテーブルを軸に書き込み、割り当てられたスロットを構成に指定するか、&apos;axiscomp write --slot {slot}&apos; で {slot} に書き込んでください</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis: &apos;axiscomp recover&apos; says how the write can be finished or undone. The old state is kept in {backup}</source>
        <translation>{reason}。旧状態への復帰も失敗しました ({rollback})。軸を有効化しないでください。書き込みを完了または取り消す方法は &apos;axiscomp recover&apos; で確認できます。旧状態は {backup} に保存されています</translation>
    </message>
    <message>
        <source>{endpoint} refuses the user name or the password that was given; in an address %40 stands for @, %3A for :, %2F for /, %23 for # and %25 for %</source>
        <translation>{endpoint} は指定されたユーザ名またはパスワードを受け付けません。アドレスの中では @ を %40、: を %3A、/ を %2F、# を %23、% を %25 と書きます</translation>
    </message>
    <message>
        <source>write http://user:password@host[:port], and in user name and password %40 for @, %3A for :, %2F for /, %3F for ?, %23 for # and %25 for %</source>
        <translation>http://user:password@host[:port] と入力し、ユーザ名とパスワードの中では @ を %40、: を %3A、/ を %2F、? を %3F、# を %23、% を %25 と書いてください</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} of axis {ofAxis} is missing</source>
        <translation>軸 {ofAxis} の次元 {dimension} のソースがありません</translation>
    </message>
    <message>
        <source>a machine cannot be called {name}: a name has no control characters</source>
        <translation>機械の名前を {name} にすることはできません。名前に制御文字は使えません</translation>
    </message>
    <message>
        <source>the name of axis {axis}</source>
        <translation>軸 {axis} の名前</translation>
    </message>
    <message>
        <source>the units of the table of {axis}</source>
        <translation>{axis} のテーブルの単位</translation>
    </message>
    <message>
        <source>{file} is a measurement, not a table; make a table of it with &apos;axiscomp fit&apos; or on the pages Measure and Fit; if it is a table all the same, name its format</source>
        <translation>{file} は測定であり、テーブルではありません。&apos;axiscomp fit&apos;、またはタブ「測定」と「フィッティング」でテーブルを作れます。それでもテーブルである場合は、その形式を指定してください</translation>
    </message>
    <message>
        <source>The open record will not note this write: {reason}.</source>
        <translation>開いている記録には、この書き込みは記されません：{reason}。</translation>
    </message>
    <message>
        <source>nothing says for which measuring system of axis {axis} the table is: it is written for 0; the setting {key} states another one</source>
        <translation>テーブルが軸 {axis} のどの計測システムのものかどこにも書かれていません：0 として書き出します。設定 {key} で別の計測システムを指定できます</translation>
    </message>
    <message>
        <source>a table for {element} alone</source>
        <translation>{element} だけのテーブル</translation>
    </message>
    <message>
        <source>CompPos and CompPos2 of the motor; the table is taken for both, and written for both</source>
        <translation>モーターの CompPos と CompPos2。テーブルは両方のものとして扱われ、両方に書き出されます</translation>
    </message>
    <message>
        <source>axis {axis}, whose numbers are taken to be in mm</source>
        <translation>軸 {axis}（数値は mm とみなされます）</translation>
    </message>
    <message>
        <source>the setting {key} where the axis is rotary</source>
        <translation>回転軸であれば設定 {key}</translation>
    </message>
</context>
<context>
    <name>FileFilter</name>
    <message>
        <source>Compensation data</source>
        <translation>補正データ</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>測定</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Record of the compensation (axiscomp write --record), which notes the proof</source>
        <translation>検証の結果を記載する補正の記録 (axiscomp write --record)</translation>
    </message>
    <message>
        <source>List the axes of one or several drives</source>
        <translation>1 台または複数のドライブの軸を一覧表示します</translation>
    </message>
    <message>
        <source>Also try all serial ports of this computer; without --drive, the connections of the window too</source>
        <translation>このコンピュータのすべてのシリアルポートも試します。--drive がない場合は、ウィンドウ版の接続も試します</translation>
    </message>
    <message>
        <source>Try the usual baud rates at every serial port</source>
        <translation>各シリアルポートで一般的なボーレートを試します</translation>
    </message>
    <message>
        <source>Also ask these addresses over http: 192.168.1.0/24, 192.168.1.10-40 or one address, at most 1024, with :PORT for another port than 80</source>
        <translation>次のアドレスにも http で問い合わせます: 192.168.1.0/24、192.168.1.10-40、または 1 つのアドレス。最大 1024 個、80 以外のポートは :PORT で指定</translation>
    </message>
    <message>
        <source>Save everything that this program can change on a whole drive, all axes, to one file</source>
        <translation>ドライブ全体 (全軸) について、このプログラムで変更できるものをすべて 1 つのファイルに保存します</translation>
    </message>
    <message>
        <source>File to write; standard output without it, or with -</source>
        <translation>書き出すファイル。省略時または - の場合は標準出力</translation>
    </message>
    <message>
        <source>Restore a whole drive from a backup file, with verified writes; all of them are planned first</source>
        <translation>バックアップファイルからドライブ全体を復元し、書き込みを照合します。先に、すべての書き込みの計画を作成します</translation>
    </message>
    <message>
        <source>File that `axiscomp backup` wrote; - for standard input</source>
        <translation>`axiscomp backup` で作成したファイル。- は標準入力</translation>
    </message>
    <message>
        <source>Restore to a drive with another serial number, such as a replacement</source>
        <translation>シリアル番号の異なるドライブ (交換品など) に復元します</translation>
    </message>
    <message>
        <source>Show what would be written without writing it</source>
        <translation>書き込みを行わずに、書き込まれる内容を表示します</translation>
    </message>
    <message>
        <source>Where the axis really is: a register of the drive, serial:/dev/ttyUSB1?baud=9600, - for lines on standard input, or typed</source>
        <translation>軸の実際の位置の取得元: ドライブのレジスタ、serial:/dev/ttyUSB1?baud=9600、- (標準入力の行)、typed (手入力)</translation>
    </message>
    <message>
        <source>Unit of the instrument; of a register it is that of the axis, of lines the one behind the number unless given</source>
        <translation>測定器の単位。指定がない場合、レジスタでは軸の単位、行では数値の後に書かれた単位</translation>
    </message>
    <message>
        <source>The instrument counts the other way</source>
        <translation>測定器の計数方向が逆です</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0 (0 unless given)</source>
        <translation>測定器が 0 を示すときの軸の位置 (既定: 0)</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line, its first group or all of it; the first number of the line unless given</source>
        <translation>行の中の数値を示す正規表現。最初のグループ、グループがなければ一致した全体を使います。指定がない場合は行の最初の数値</translation>
    </message>
    <message>
        <source>Send this to the serial instrument before each reading, with \r and \n for line ends</source>
        <translation>読み取りのたびに、先にこの文字列をシリアル接続の測定器に送ります。行末は \r と \n で指定</translation>
    </message>
    <message>
        <source>Register of the raw position; the profile&apos;s unless given</source>
        <translation>補正前の位置のレジスタ。指定がない場合はプロファイルのレジスタ</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within so many mm or deg, and readings may differ by as much (0.001 unless given)</source>
        <translation>エンコーダの変動がこの値 (mm または deg) 以内のとき、軸が静止しているとみなします。読み値のばらつきの許容幅も同じ値です (既定: 0.001)</translation>
    </message>
    <message>
        <source>So many seconds, before anything is taken (1 unless given)</source>
        <translation>取り込みを始めるまでに軸が静止している秒数 (既定: 1)</translation>
    </message>
    <message>
        <source>Readings that make a value (10 unless given)</source>
        <translation>1 つの値を求める読み値の数 (既定: 10)</translation>
    </message>
    <message>
        <source>Readings per second, 10 to 50 (20 unless given)</source>
        <translation>1 秒あたりの読み取り回数、10 から 50 (既定: 20)</translation>
    </message>
    <message>
        <source>Take the values of a measuring plan while something else moves the axis</source>
        <translation>ほかの手段で軸を動かしながら、測定計画の値を取り込みます</translation>
    </message>
    <message>
        <source>Plan as axiscomp targets writes it</source>
        <translation>axiscomp targets で作成した測定計画</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>値のファイル。既存のファイルは続きから追記します</translation>
    </message>
    <message>
        <source>axiscomp never moves an axis: the machine&apos;s control or a person does.</source>
        <translation>axiscomp が軸を動かすことはありません。軸を動かすのは、機械の NC 装置または人です。</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>例:</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to a servo drive, activates them, and checks the drive&apos;s output against the table.</source>
        <translation>測定した軸の誤差の補正テーブルをサーボドライブに書き込み、有効化して、ドライブの出力をテーブルと比較します。</translation>
    </message>
    <message>
        <source>Show the version</source>
        <translation>バージョンを表示します</translation>
    </message>
    <message>
        <source>ENDPOINT is http://host[:port], https://host[:port], serial:DEVICE[?baud=N] or demo: (a virtual drive inside the program). AXISCOMP_DRIVE is the default of --drive. `axiscomp COMMAND --help` has more.</source>
        <translation>ENDPOINT は http://host[:port]、https://host[:port]、serial:DEVICE[?baud=N]、demo: (プログラム内蔵の仮想ドライブ) のいずれかです。--drive の既定値は AXISCOMP_DRIVE です。詳細は `axiscomp COMMAND --help` で表示されます。</translation>
    </message>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>1 つの JSON 文書を標準出力に出力します</translation>
    </message>
    <message>
        <source>Files on this computer</source>
        <translation>このコンピュータのファイル</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>Compare measurements before and after a compensation, and with what was promised</source>
        <translation>補正前後の測定を相互に、また予測と比較します</translation>
    </message>
    <message>
        <source>on: the second measurement was made with the table of the record active, where its file does not say it</source>
        <translation>on: 2 回目の測定は、記録のテーブルを有効にして行いました (測定ファイルに記載がない場合)</translation>
    </message>
    <message>
        <source>Add the second measurement and the verdict to the record</source>
        <translation>2 回目の測定と判定を記録に追加します</translation>
    </message>
    <message>
        <source>Compensation parameters of a TAM configuration: show them, take them from a drive, or bring them to one</source>
        <translation>TAM 構成の補正パラメータを表示します。ドライブからの取り込みと、ドライブへの書き込みもできます</translation>
    </message>
    <message>
        <source>show, export (to the file) or import (from it)</source>
        <translation>show (表示)、export (ファイルへ)、import (ファイルから)</translation>
    </message>
    <message>
        <source>TAM configuration (.TAMcfg)</source>
        <translation>TAM 構成 (.TAMcfg)</translation>
    </message>
    <message>
        <source>export: take the parameters from this configuration in place of a drive</source>
        <translation>export: ドライブの代わりに、この構成からパラメータを取得します</translation>
    </message>
    <message>
        <source>export: write this file instead, and leave the other one as it is</source>
        <translation>export: 代わりにこのファイルに書き出し、元のファイルは変更しません</translation>
    </message>
    <message>
        <source>Name or serial number of the station in the file; without it the one with the drive&apos;s serial number</source>
        <translation>ファイル内のステーションの名前またはシリアル番号。省略時は、ドライブとシリアル番号が同じステーション</translation>
    </message>
    <message>
        <source>Accept a station with another serial number than the drive&apos;s</source>
        <translation>ドライブとシリアル番号の異なるステーションを受け入れます</translation>
    </message>
    <message>
        <source>Only the registers Table and Dim1Source to Dim3Source of the axes are read and written. Everything else in the file stays as it is, and tables stay on the drive. Importing never switches a compensation on.</source>
        <translation>読み書きするのは、各軸のレジスタ Table と Dim1Source から Dim3Source だけです。ファイルのそのほかの内容は変更されず、テーブルはドライブに残ります。インポートで補正がオンになることはありません。</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>例:</translation>
    </message>
    <message>
        <source>Convert a table file to another format</source>
        <translation>テーブルファイルを別の形式に変換します</translation>
    </message>
    <message>
        <source>File to read; - for standard input</source>
        <translation>読み取るファイル。- は標準入力</translation>
    </message>
    <message>
        <source>File to write, replaced if it exists; - for standard output</source>
        <translation>書き出すファイル。既存のファイルは置き換えます。- は標準出力</translation>
    </message>
    <message>
        <source>Format of the output, if its name leaves it open</source>
        <translation>出力の形式 (ファイル名から決まらない場合)</translation>
    </message>
    <message>
        <source>Unit of the values in a .TAMtbl, which does not say it; by default that of the positions</source>
        <translation>.TAMtbl の値の単位 (ファイルには記載がありません)。既定は位置の単位</translation>
    </message>
    <message>
        <source>Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl</source>
        <translation>範囲の 1 % を超える補正量や、傾きが 0.1 を超える補正量も .TAMtbl に書き出します</translation>
    </message>
    <message>
        <source>Mark the table persistent: the drive stores it</source>
        <translation>テーブルを不揮発にします (ドライブが保存します)</translation>
    </message>
    <message>
        <source>Mark the table volatile (without either: as the input is)</source>
        <translation>テーブルを揮発にします (どちらも指定しない場合は入力のまま)</translation>
    </message>
    <message>
        <source>Name of the table</source>
        <translation>テーブルの名前</translation>
    </message>
    <message>
        <source>Delete the table of an axis, or one that no axis uses, and free its slot</source>
        <translation>軸のテーブル、またはどの軸も使用していないテーブルを削除し、スロットを解放します</translation>
    </message>
    <message>
        <source>Delete the table in this slot, small1 to small8, large1 or large2, which no axis uses</source>
        <translation>どの軸も使用していない、このスロット (small1 から small8、large1、large2) のテーブルを削除します</translation>
    </message>
    <message>
        <source>Show what would be deleted without deleting it</source>
        <translation>削除を行わずに、削除される内容を表示します</translation>
    </message>
    <message>
        <source>The compensation must be off. The axis then uses no table, also after a reboot; its sources stay. What is deleted is kept in a backup: `axiscomp restore` brings it back.</source>
        <translation>補正をオフにしておく必要があります。削除後、軸はテーブルを使用しません。再起動後も同じです。ソースは残ります。削除した内容はバックアップに保存され、`axiscomp restore` で元に戻せます。</translation>
    </message>
    <message>
        <source>Write an example calibration file (CSV)</source>
        <translation>校正ファイル (CSV) のサンプルを作成します</translation>
    </message>
    <message>
        <source>Number of dimensions: 1, 2 or 3</source>
        <translation>次元数: 1、2、3</translation>
    </message>
    <message>
        <source>Number of tables (2 unless given)</source>
        <translation>テーブルの数 (既定: 2)</translation>
    </message>
    <message>
        <source>Table file to write, replaced if it exists; - for standard output. Without it nothing is written</source>
        <translation>書き出すテーブルファイル。既存のファイルは置き換えます。- は標準出力。省略時は何も書き出しません</translation>
    </message>
    <message>
        <source>Begin a record of the compensation (.axcal): measurement, table and what it promises, for compare and report</source>
        <translation>補正の記録 (.axcal) を開始します。compare と report で使う測定、テーブル、予測を入れます</translation>
    </message>
    <message>
        <source>Write this column of points only, where the format holds one table</source>
        <translation>点の測定のうち、この列だけを書き出します (1 つのテーブルしか入らない形式の場合)</translation>
    </message>
    <message>
        <source>Curve and grid</source>
        <translation>曲線と格子</translation>
    </message>
    <message>
        <source>Curve through the means: linear (the default), cubic, spline, smooth or harmonic</source>
        <translation>平均値を通る曲線: linear (既定)、cubic、spline、smooth、harmonic</translation>
    </message>
    <message>
        <source>Of the method smooth, and of points and tracks; by cross-validation unless given</source>
        <translation>方法 smooth、点、連続測定の平滑度。指定がない場合は交差検証で決めます</translation>
    </message>
    <message>
        <source>Known periods, such as the lead of the screw, fitted by the method smooth</source>
        <translation>方法 smooth でフィッティングする既知の周期 (ねじのリードなど)</translation>
    </message>
    <message>
        <source>Harmonics of each period, and of the method harmonic, the fundamental counted (1 unless given)</source>
        <translation>各周期および harmonic の高調波の数。基本波を含みます (既定: 1)</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>モジュロ軸の 1 回転の長さ (360 など)。テーブルの始点と終点が同じ値になります</translation>
    </message>
    <message>
        <source>Which runs the table is made of: mean of both (the default), positive or negative; both makes a table for each, for controllers that keep two</source>
        <translation>テーブルの作成に使う走行: mean (両方向の平均、既定)、positive、negative。both では、テーブルを 2 つもつコントローラ用に方向ごとのテーブルを作成します</translation>
    </message>
    <message>
        <source>temperature: a table over position and temperature, from runs in several thermal states; --points and --distance take a second number for it</source>
        <translation>temperature: 複数の温度状態での走行から、位置と温度に対するテーブルを作成します。--points と --distance の 2 つ目の数値は温度用です</translation>
    </message>
    <message>
        <source>Even grid with N points, for each axis or for all; unless given, that of the targets, where they are even</source>
        <translation>N 点の等間隔格子。軸ごとまたは全軸に指定。指定がない場合は、等間隔であれば目標位置</translation>
    </message>
    <message>
        <source>Even grid with spacing D, for each axis or for all</source>
        <translation>間隔 D の等間隔格子。軸ごとまたは全軸に指定</translation>
    </message>
    <message>
        <source>The fewest points that leave no more than this to the curve, in mm or deg</source>
        <translation>曲線との差がこの値 (mm または deg) 以内になる最少の点数</translation>
    </message>
    <message>
        <source>Let the grid extend beyond the targets, where the end values are held</source>
        <translation>格子を目標位置の外まで広げることを許容します。そこでは端点値を保持します</translation>
    </message>
    <message>
        <source>Speed of the axis in mm/s or deg/s, for the steps of the velocity that are told</source>
        <translation>表示する速度の段差の計算に使う軸の速度 (mm/s または deg/s)</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>ゼロ点、傾き、ドリフト</translation>
    </message>
    <message>
        <source>Where the table is 0: home, first (the first target), mean, keep, or a position; home where it is known and measured, else first, unless given</source>
        <translation>テーブルが 0 になる位置: home (原点)、first (最初の目標位置)、mean (平均)、keep (そのまま)、または位置の値。指定がない場合は、原点が既知で測定範囲にあれば home、そうでなければ first</translation>
    </message>
    <message>
        <source>Home position of the axis</source>
        <translation>軸の原点位置</translation>
    </message>
    <message>
        <source>Take the slope out, for straightness: lsq (least squares) or ends</source>
        <translation>傾きを除去します (真直度用): lsq (最小二乗) または ends (両端)</translation>
    </message>
    <message>
        <source>Take the drift of the runs out before they are averaged: offset or trend</source>
        <translation>平均する前に、走行のドリフトを除去します: offset または trend</translation>
    </message>
    <message>
        <source>State of the drive</source>
        <translation>ドライブの状態</translation>
    </message>
    <message>
        <source>Where the drive looks the table up: encoder (before the compensation) or set (after it); with --onto drive by its source</source>
        <translation>ドライブがテーブルを参照する位置: encoder (補正前) または set (補正後)。--onto drive の場合はソースによる</translation>
    </message>
    <message>
        <source>What was active while it was measured, where the file does not say it: off, on, or the file of the table</source>
        <translation>測定時に有効だったもの (ファイルに記載がない場合): off、on、またはテーブルのファイル</translation>
    </message>
    <message>
        <source>Merge residuals onto the table that was active: its file, or drive for the one that the axis uses (--drive, --axis)</source>
        <translation>測定時に有効だったテーブルに残差を統合します。テーブルのファイル、または drive (軸が使用しているテーブル。--drive、--axis で指定)</translation>
    </message>
    <message>
        <source>Factor for the residuals before they are merged (1); below 1, such as 0.7, where the machine responds sluggishly</source>
        <translation>統合する前に残差に掛けるゲイン (既定: 1)。機械の応答が鈍い場合は 0.7 など 1 より小さくします</translation>
    </message>
    <message>
        <source>Points and tracks</source>
        <translation>点と連続測定</translation>
    </message>
    <message>
        <source>Remove the alignment of the artefact: rigid (position and rotation), rigid:X (rotated so that lines along X have no slope), or scale (its scale as well)</source>
        <translation>標準器の置き方の影響を除去します: rigid (位置と回転)、rigid:X (X に沿う線に傾きが残らないように回転)、scale (倍率も除去)</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one: smooth or nearest; refused unless given</source>
        <translation>どの測定点からも遠い格子点の値: smooth または nearest。指定がない場合はエラーになります</translation>
    </message>
    <message>
        <source>Give values that do not fit the others less weight</source>
        <translation>ほかと合わない値の重みを小さくします</translation>
    </message>
    <message>
        <source>Make a compensation table of a measurement, and foretell what it does</source>
        <translation>測定から補正テーブルを作成し、その効果を予測します</translation>
    </message>
    <message>
        <source>List the table formats, or describe one: its limits, rules and settings</source>
        <translation>テーブルの形式を一覧表示します。または 1 つの形式の制限、規則、設定を表示します</translation>
    </message>
    <message>
        <source>One format: its rules, limits and settings</source>
        <translation>1 つの形式。規則、制限、設定を表示します</translation>
    </message>
    <message>
        <source>All of them, as the page docs/formats.md</source>
        <translation>すべての形式を、docs/formats.md のページとして出力します</translation>
    </message>
    <message>
        <source>The formats of measurements instead of those of tables</source>
        <translation>テーブルの形式の代わりに、測定の形式を表示します</translation>
    </message>
    <message>
        <source>Check a file and report its format, grid, tables and problems</source>
        <translation>ファイルを検査し、形式、格子、テーブル、問題を報告します</translation>
    </message>
    <message>
        <source>Calibration file or table; - for standard input</source>
        <translation>校正ファイルまたはテーブル。- は標準入力</translation>
    </message>
    <message>
        <source>Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances</source>
        <translation>測定を判定します: ISO 230-2 の特性値、ドリフト、外れ値、許容値</translation>
    </message>
    <message>
        <source>Rule that proposes outliers: mad (the default), grubbs or none</source>
        <translation>外れ値の候補を示す判定規則: mad (既定)、grubbs、none</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw, in mm or deg</source>
        <translation>軸の既知の周期 (送りねじのリードなど)。単位は mm または deg</translation>
    </message>
    <message>
        <source>Show the figures of VDI/DGQ 3441 as well</source>
        <translation>VDI/DGQ 3441 の特性値も表示します</translation>
    </message>
    <message>
        <source>Print the interpolated value at a position, as the drive or the controller of the file computes it</source>
        <translation>ある位置での補間値を、ドライブまたはファイルのコントローラと同じ計算で出力します</translation>
    </message>
    <message>
        <source>Calibration file or table</source>
        <translation>校正ファイルまたはテーブル</translation>
    </message>
    <message>
        <source>X [Y [Z]], one number per dimension; may be negative</source>
        <translation>X [Y [Z]]。次元ごとに 1 つの数値、負の値も可</translation>
    </message>
    <message>
        <source>File with one position per line, - for standard input; prints one result per line</source>
        <translation>1 行に 1 つの位置を書いたファイル。- は標準入力。結果を 1 行に 1 つ出力します</translation>
    </message>
    <message>
        <source>Value outside the table: hold (as the drive does; the default), zero, wrap, extrapolate or error</source>
        <translation>テーブルの範囲外の値: hold (既定、ドライブと同じ)、zero、wrap、extrapolate、error</translation>
    </message>
    <message>
        <source>Print the value that the controller of this format would apply, after conversion</source>
        <translation>この形式のコントローラが適用する値を、変換後の形で出力します</translation>
    </message>
    <message>
        <source>Machine file (.toml)</source>
        <translation>機械ファイル (.toml)</translation>
    </message>
    <message>
        <source>Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may be given several times</source>
        <translation>ファイルに書かれたこの軸だけ。1 台のドライブの軸は SERIAL/AXIS で指定。複数回指定可</translation>
    </message>
    <message>
        <source>Drives at the same time (16 unless given)</source>
        <translation>同時に処理するドライブの数 (既定: 16)</translation>
    </message>
    <message>
        <source>Leave drives out that do not answer, which is an error otherwise</source>
        <translation>応答しないドライブを除外します。指定しない場合はエラーになります</translation>
    </message>
    <message>
        <source>Compare the drives of a machine with its machine file, and change nothing</source>
        <translation>機械のドライブを機械ファイルと比較します。何も変更しません</translation>
    </message>
    <message>
        <source>The exit code is 0 when all drives have what the file says, and 9 when something differs.</source>
        <translation>終了コードは、すべてのドライブがファイルと一致する場合は 0、相違がある場合は 9 です。</translation>
    </message>
    <message>
        <source>Write what a machine file says to the drives of the machine, where they differ</source>
        <translation>機械ファイルと異なる部分について、その内容を機械のドライブに書き込みます</translation>
    </message>
    <message>
        <source>Switch the compensation of axes on and off where the file says so (active), and prove it</source>
        <translation>ファイルの指定 (active) どおりに軸の補正をオン・オフし、検証します</translation>
    </message>
    <message>
        <source>All drives are planned first, and nothing is written unless all of it is possible. Each write is safe as that of `axiscomp write`. A second apply finds nothing to do.</source>
        <translation>先にすべてのドライブの計画を作成し、全体を実行できない場合は何も書き込みません。それぞれの書き込みは `axiscomp write` と同様に安全です。2 回目の適用では、変更するものはありません。</translation>
    </message>
    <message>
        <source>Print output, indices and sources of an axis as CSV until stopped</source>
        <translation>軸の出力、インデックス、ソースを、停止するまで CSV で出力します</translation>
    </message>
    <message>
        <source>Lines per second, 1 to 100 (10 unless given)</source>
        <translation>1 秒あたりの行数、1 から 100 (既定: 10)</translation>
    </message>
    <message>
        <source>Number of lines; without end unless given</source>
        <translation>行数。指定がない場合は停止するまで</translation>
    </message>
    <message>
        <source>Download the table that an axis uses</source>
        <translation>軸が使用しているテーブルをダウンロードします</translation>
    </message>
    <message>
        <source>File to write, .csv, .TAMtbl or that of another controller; CSV on standard output without it</source>
        <translation>書き出すファイル (.csv、.TAMtbl、または別のコントローラのファイル)。省略時は CSV を標準出力に出力します</translation>
    </message>
    <message>
        <source>Finish or undo an interrupted write; without an option, say which is possible</source>
        <translation>中断された書き込みを完了または取り消します。オプションがない場合は、どちらが可能かを表示します</translation>
    </message>
    <message>
        <source>Bring the complete new state about, from whatever there is now</source>
        <translation>現在の状態によらず、完全な新状態にします</translation>
    </message>
    <message>
        <source>Bring back the complete state before the write</source>
        <translation>書き込み前の完全な状態に戻します</translation>
    </message>
    <message>
        <source>Write the report of a record: by how much an axis became better, on one page</source>
        <translation>記録の報告書を作成します: 軸の改善の程度を 1 ページで示します</translation>
    </message>
    <message>
        <source>Record of the compensation (.axcal)</source>
        <translation>補正の記録 (.axcal)</translation>
    </message>
    <message>
        <source>The report; its extension says whether it is PDF or HTML</source>
        <translation>報告書のファイル。拡張子により PDF または HTML になります</translation>
    </message>
    <message>
        <source>Language of the report: en, de, fr, ja or zh</source>
        <translation>報告書の言語: en、de、fr、ja、zh</translation>
    </message>
    <message>
        <source>Add pages with every target and every value that is left out</source>
        <translation>すべての目標位置と、除外したすべての値のページを追加します</translation>
    </message>
    <message>
        <source>Show what is in measurement files, join them, and write them as one CSV</source>
        <translation>測定ファイルの内容を表示し、結合して 1 つの CSV に書き出します</translation>
    </message>
    <message>
        <source>CSV file to write, replaced if it exists; - for standard output</source>
        <translation>書き出す CSV ファイル。既存のファイルは置き換えます。- は標準出力</translation>
    </message>
    <message>
        <source>Write a machine file with all tables from running drives</source>
        <translation>稼働中のドライブから、すべてのテーブルを含む機械ファイルを作成します</translation>
    </message>
    <message>
        <source>Folder for machine.toml and the tables; files of the same names are replaced</source>
        <translation>machine.toml とテーブルのフォルダ。同名のファイルは置き換えます</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>機械の名前</translation>
    </message>
    <message>
        <source>Applied to drives with the same serial numbers and without tables, the file gives the same state, and a snapshot of them the same bytes.</source>
        <translation>このファイルを、シリアル番号が同じでテーブルのないドライブに適用すると同じ状態になり、そのスナップショットはバイト単位で一致します。</translation>
    </message>
    <message>
        <source>Print the states of drives as OpenMetrics text, for a collector</source>
        <translation>収集プログラム用に、ドライブの状態を OpenMetrics テキストで出力します</translation>
    </message>
    <message>
        <source>Machine file: its drives, and whether they differ from it</source>
        <translation>機械ファイル。記載されたドライブと、ファイルとの相違の有無を出力します</translation>
    </message>
    <message>
        <source>Compare the outputs of active compensations with their tables now</source>
        <translation>有効な補正の出力を、今テーブルと比較します</translation>
    </message>
    <message>
        <source>File to write, whole or not at all; standard output without it</source>
        <translation>書き出すファイル (全体を書くか、まったく書かないかのどちらか)。省略時は標準出力</translation>
    </message>
    <message>
        <source>Show the compensation of an axis, and the outcome of an interrupted write</source>
        <translation>軸の補正と、中断された書き込みの結果を表示します</translation>
    </message>
    <message>
        <source>Count the drive&apos;s flash operations again after their record was damaged; first wait as long as the drive counts them</source>
        <translation>回数の記録が破損した後、ドライブのフラッシュ操作を数え直します。先に、ドライブがフラッシュ操作を数える期間だけ待ってください</translation>
    </message>
    <message>
        <source>First target</source>
        <translation>最初の目標位置</translation>
    </message>
    <message>
        <source>Last target, above the first</source>
        <translation>最後の目標位置 (最初より大きい値)</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>目標位置の数</translation>
    </message>
    <message>
        <source>Mean distance of targets, instead of --count</source>
        <translation>目標位置の平均間隔 (--count の代わり)</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw: targets are spread over it</source>
        <translation>軸の既知の周期 (送りねじのリードなど)。目標位置を周期内に分散させます</translation>
    </message>
    <message>
        <source>Runs in each direction (5 unless given)</source>
        <translation>各方向の走行の数 (既定: 5)</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same (1 unless given)</source>
        <translation>数値を変えると目標位置が変わり、同じ数値では同じになります (既定: 1)</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target (1 % of the range unless given, at most a third of the spacing)</source>
        <translation>軸が最初の目標位置の手前で走行方向に動く距離 (既定は範囲の 1 %、ただし目標位置の間隔の 1/3 以下)</translation>
    </message>
    <message>
        <source>Feed in mm or deg per minute (1000 unless given)</source>
        <translation>送り速度 (mm/min または deg/min、既定: 1000)</translation>
    </message>
    <message>
        <source>Seconds at each target (5 unless given): time to stand still and be measured</source>
        <translation>各目標位置での秒数 (既定: 5): 静止して測定するための時間</translation>
    </message>
    <message>
        <source>Choose the targets of a measurement: a plan, or a program for the machine&apos;s control</source>
        <translation>測定の目標位置を選びます: 測定計画、または機械の NC 装置用のプログラムを作成します</translation>
    </message>
    <message>
        <source>Name of the axis (X unless given)</source>
        <translation>軸の名前 (既定: X)</translation>
    </message>
    <message>
        <source>Unit of all positions: mm (the default) or deg</source>
        <translation>すべての位置の単位: mm (既定) または deg</translation>
    </message>
    <message>
        <source>Write G-code for this control: linuxcnc, fanuc or siemens</source>
        <translation>この NC 装置用の G コードを書き出します: linuxcnc、fanuc、siemens</translation>
    </message>
    <message>
        <source>List the table files of a drive</source>
        <translation>ドライブのテーブルファイルを一覧表示します</translation>
    </message>
    <message>
        <source>Upload a file unchanged and verify it, for drive programs that use tables</source>
        <translation>ファイルをそのままアップロードして照合します (テーブルを使うドライブプログラム用)</translation>
    </message>
    <message>
        <source>File on this computer</source>
        <translation>このコンピュータのファイル</translation>
    </message>
    <message>
        <source>Path in the drive, such as tables/small1.TAMtbl</source>
        <translation>ドライブ内のパス (tables/small1.TAMtbl など)</translation>
    </message>
    <message>
        <source>Download a file unchanged</source>
        <translation>ファイルをそのままダウンロードします</translation>
    </message>
    <message>
        <source>Register that supplies the position of dimension 1: path, tam:// URI or address (0x1234)</source>
        <translation>次元 1 の位置を与えるレジスタ: パス、tam:// URI、またはアドレス (0x1234)</translation>
    </message>
    <message>
        <source>The same for dimension 2</source>
        <translation>次元 2 について同様</translation>
    </message>
    <message>
        <source>The same for dimension 3</source>
        <translation>次元 3 について同様</translation>
    </message>
    <message>
        <source>The source is the axis&apos;s own position, for tables of one dimension; with --map each axis&apos;s own</source>
        <translation>軸自身の位置をソースにします (1 次元のテーブル用)。--map では各軸自身の位置</translation>
    </message>
    <message>
        <source>Write a compensation table to an axis in the safe order, and verify it</source>
        <translation>補正テーブルを安全な順序で軸に書き込み、照合します</translation>
    </message>
    <message>
        <source>Calibration file (.csv), table (.TAMtbl), or file of another controller; without it the axis keeps its table</source>
        <translation>校正ファイル (.csv)、テーブル (.TAMtbl)、または別のコントローラのファイル。省略時、軸のテーブルは変わりません</translation>
    </message>
    <message>
        <source>Record of a compensation in place of --data: its table is written, and it notes drive, slot and CRC</source>
        <translation>--data の代わりに使う補正の記録。記録のテーブルを書き込み、ドライブ、スロット、CRC を記録に記載します</translation>
    </message>
    <message>
        <source>Store the table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>再起動後も残るように、テーブルをドライブのフラッシュに保存します</translation>
    </message>
    <message>
        <source>Keep the table in memory until the next reboot (the default for a new table)</source>
        <translation>テーブルを次の再起動までメモリに保持します (新しいテーブルの既定)</translation>
    </message>
    <message>
        <source>Unit of the values in place of what the file says, such as um; drive for the drive&apos;s own</source>
        <translation>ファイルの記載の代わりに使う値の単位 (um など)。drive はドライブ自身の単位</translation>
    </message>
    <message>
        <source>The same for the positions</source>
        <translation>位置について同様</translation>
    </message>
    <message>
        <source>Slot to use, small1 to small8, large1 or large2; chosen unless given</source>
        <translation>使用するスロット: small1 から small8、large1、large2。指定がない場合は自動で選びます</translation>
    </message>
    <message>
        <source>Write this column of the file (name or number) to this axis; AXIS alone is the column that is named as the axis. May be given several times. Nothing is written unless all of the writes are possible</source>
        <translation>ファイルのこの列 (名前または番号) をこの軸に書き込みます。AXIS だけの場合は、軸と同じ名前の列を使います。複数回指定できます。すべての書き込みが可能でない限り、何も書き込みません</translation>
    </message>
    <message>
        <source>Write corrections above 1 % of the range, or with a slope above 0.1, which without this are taken for a wrong unit</source>
        <translation>範囲の 1 % を超える補正量や、傾きが 0.1 を超える補正量も書き込みます。指定しない場合は単位の誤りとみなします</translation>
    </message>
    <message>
        <source>Without --source1 the axis keeps its sources. The compensation stays off: `axiscomp activate` switches it on.</source>
        <translation>--source1 がない場合、軸のソースは変わりません。補正はオフのままです。オンにするには `axiscomp activate` を使います。</translation>
    </message>
    <message>
        <source>Axis that the values correct, for each column or for all: its name, #1 for the first source, or other for an axis that is no source; by default as the file says</source>
        <translation>値で補正する軸。列ごとまたは全列に指定: 軸の名前、#1 (最初のソース)、other (ソースでない軸)。既定はファイルの記載</translation>
    </message>
    <message>
        <source>Conversion</source>
        <translation>変換</translation>
    </message>
    <message>
        <source>Convention of the input: feedback (added to the encoder position) or command (added to the commanded position); by default that of its format, needed where that is assumed</source>
        <translation>入力の符号: feedback (エンコーダ位置に加算) または command (指令位置に加算)。既定は形式の符号。それが仮定にすぎない場合は指定が必要</translation>
    </message>
    <message>
        <source>Which values to use if the file has both directions of motion: mean, positive or negative</source>
        <translation>ファイルに両方向の値がある場合に使う値: mean、positive、negative</translation>
    </message>
    <message>
        <source>Multiply the values by this number, before anything else</source>
        <translation>ほかの処理の前に、値にこの数を掛けます</translation>
    </message>
    <message>
        <source>Add this to the values, in their unit</source>
        <translation>この数を値に加算します (値の単位)</translation>
    </message>
    <message>
        <source>Shift the values so that they are 0 at this position</source>
        <translation>この位置で 0 になるように値をずらします</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a linear one</source>
        <translation>モジュロ軸を直進軸として扱います</translation>
    </message>
    <message>
        <source>Resample onto an even grid with N points, for each source or for all</source>
        <translation>N 点の等間隔格子に再サンプリングします。ソースごとまたは全ソースに指定</translation>
    </message>
    <message>
        <source>Resample onto an even grid with spacing D, for each source or for all</source>
        <translation>間隔 D の等間隔格子に再サンプリングします。ソースごとまたは全ソースに指定</translation>
    </message>
    <message>
        <source>Resample onto the coarsest even grid within this deviation, in the unit of the values</source>
        <translation>この偏差 (値の単位) 以内で最も粗い等間隔格子に再サンプリングします</translation>
    </message>
    <message>
        <source>Between the points of the source: linear (the default), cubic (monotone), spline (natural cubic) or smooth (smoothing spline)</source>
        <translation>ソースの点の間: linear (既定)、cubic (単調 3 次)、spline (自然 3 次スプライン)、smooth (平滑化スプライン)</translation>
    </message>
    <message>
        <source>Speed of the axis in positions per second: says the steps of the velocity that are left with spline and smooth</source>
        <translation>軸の速度 (1 秒あたりの位置の単位)。spline と smooth で残る速度の段差を表示します</translation>
    </message>
    <message>
        <source>Let the even grid extend beyond the data, where the end values are held</source>
        <translation>等間隔格子をデータの外まで広げることを許容します。そこでは端点値を保持します</translation>
    </message>
    <message>
        <source>Convention of the output: feedback or command; by default that of its format, needed where that is assumed</source>
        <translation>出力の符号: feedback または command。既定は形式の符号。それが仮定にすぎない場合は指定が必要</translation>
    </message>
    <message>
        <source>Setting that the output format needs; `axiscomp formats NAME` lists them</source>
        <translation>出力の形式に必要な設定。`axiscomp formats NAME` で一覧表示</translation>
    </message>
    <message>
        <source>Corrections, made only when asked for</source>
        <translation>測定値の補正 (指定した場合だけ行います)</translation>
    </message>
    <message>
        <source>Temperature of the axis&apos;s scale in C</source>
        <translation>軸のスケールの温度 (°C)</translation>
    </message>
    <message>
        <source>Coefficient of expansion of the axis&apos;s scale in 1/K, such as 11.5e-6</source>
        <translation>軸のスケールの膨張係数 (1/K)。例: 11.5e-6</translation>
    </message>
    <message>
        <source>Temperature of the reference in C</source>
        <translation>基準の温度 (°C)</translation>
    </message>
    <message>
        <source>Coefficient of the reference in 1/K; 0 for a laser with wavelength compensation</source>
        <translation>基準の膨張係数 (1/K)。波長補正済みのレーザは 0</translation>
    </message>
    <message>
        <source>Position in mm that does not move with temperature; the first target unless given</source>
        <translation>温度によって動かない位置 (mm)。指定がない場合は最初の目標位置</translation>
    </message>
    <message>
        <source>The values are not corrected to 20 C, where the file does not say it</source>
        <translation>値は 20 °C に換算されていません (ファイルに記載がない場合)</translation>
    </message>
    <message>
        <source>Dead path of the interferometer: a JSON file with its length and the air of each run</source>
        <translation>干渉計のデッドパス: その長さと各走行の空気の状態を記した JSON ファイル</translation>
    </message>
    <message>
        <source>Limits, such as A=10um,R=4um; exit code 8 when one is not met</source>
        <translation>許容値。例: A=10um,R=4um。満たさないものがあれば終了コード 8</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms</source>
        <translation>測定の不確かさ (k = 2): U=2.1um、または各成分を記した JSON ファイル</translation>
    </message>
    <message>
        <source>Measurement files, joined when there are several; - for standard input</source>
        <translation>測定ファイル。複数の場合は結合します。- は標準入力</translation>
    </message>
    <message>
        <source>Format of the files, if their content leaves it open</source>
        <translation>ファイルの形式 (内容から決まらない場合)</translation>
    </message>
    <message>
        <source>Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>値を除外します: down:1:1 (方向、目標位置、走行)、run:up:3、target:7。コンマで区切って指定</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>正方向と負方向を入れ替えます</translation>
    </message>
    <message>
        <source>What a file leaves open</source>
        <translation>ファイルから決まらない項目</translation>
    </message>
    <message>
        <source>Which column of a CSV file is what, by number or name: &apos;target=1,direction=3,deviation=5&apos;</source>
        <translation>CSV ファイルの各列の意味。番号または名前で指定: &apos;target=1,direction=3,deviation=5&apos;</translation>
    </message>
    <message>
        <source>Lines before the header of a CSV file</source>
        <translation>CSV ファイルのヘッダの前にある行数</translation>
    </message>
    <message>
        <source>Unit of targets and encoder</source>
        <translation>目標位置とエンコーダの単位</translation>
    </message>
    <message>
        <source>Unit of deviations and reference</source>
        <translation>偏差と基準の単位</translation>
    </message>
    <message>
        <source>What the values are: deviation (reference minus target) or reference (positions)</source>
        <translation>値の種類: deviation (基準から目標位置を引いた値) または reference (位置)</translation>
    </message>
    <message>
        <source>order: the direction of a run follows from the order of its targets</source>
        <translation>order: 走行の方向を目標位置の順序から決めます</translation>
    </message>
    <message>
        <source>How far a track moves after a turn before its samples count, in mm or deg; 1 % of the range unless given</source>
        <translation>連続測定で、反転後のサンプルを使い始めるまでの移動量 (mm または deg)。指定がない場合は範囲の 1 %</translation>
    </message>
    <message>
        <source>Number of dimensions of a CSV file: its first D columns are positions</source>
        <translation>CSV ファイルの次元数: 最初の D 列が位置です</translation>
    </message>
    <message>
        <source>Format of the input, if content and name leave it open</source>
        <translation>入力の形式 (内容とファイル名から決まらない場合)</translation>
    </message>
    <message>
        <source>Setting that the file leaves open; `axiscomp formats NAME` lists them</source>
        <translation>ファイルから決まらない設定。`axiscomp formats NAME` で一覧表示</translation>
    </message>
    <message>
        <source>Incomplete grids</source>
        <translation>欠けのある格子</translation>
    </message>
    <message>
        <source>Give points without a value that of the nearest measured point (nearest), of the plane through all of them (plane), or the values that bend least (smooth)</source>
        <translation>値のない点を補填します: 最近傍の測定点の値 (nearest)、全測定点を通る平面の値 (plane)、曲げが最小になる値 (smooth)</translation>
    </message>
    <message>
        <source>Cut the grid to the largest part in which every point has a value</source>
        <translation>すべての点に値がある最大の部分に格子を切り取ります</translation>
    </message>
    <message>
        <source>Take positions of a calibration file that are this close to the grid for grid positions, in their unit</source>
        <translation>校正ファイルの位置のうち、格子との差がこの値 (位置の単位) 以内のものを格子の位置とみなします</translation>
    </message>
    <message>
        <source>Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either); not needed if there is only one</source>
        <translation>ファイル内のテーブル。名前または 1 からの番号で指定 (どちらにも読める場合は name:TEXT、#N)。1 つしかない場合は不要</translation>
    </message>
    <message>
        <source>Drive profile (JSON) in place of the built-in one, generic</source>
        <translation>組み込みの generic の代わりに使うドライブプロファイル (JSON)</translation>
    </message>
    <message>
        <source>Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given</source>
        <translation>ドライブのアドレス。複数回指定可。指定がない場合は $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Address of the drive; $AXISCOMP_DRIVE unless given</source>
        <translation>ドライブのアドレス。指定がない場合は $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Trust the https certificate with this fingerprint from now on; any other one is refused</source>
        <translation>今後、このフィンガープリントの https 証明書を信頼します。それ以外の証明書は拒否します</translation>
    </message>
    <message>
        <source>Time limit for one exchange with the drive (5 unless given)</source>
        <translation>ドライブとの 1 回の通信の制限時間 (既定: 5)</translation>
    </message>
    <message>
        <source>Index or name of the axis; not needed if the drive has only one</source>
        <translation>軸のインデックスまたは名前。ドライブの軸が 1 本だけの場合は不要</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>オプション</translation>
    </message>
    <message>
        <source>Show this help</source>
        <translation>このヘルプを表示します</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>引数</translation>
    </message>
    <message>
        <source>options</source>
        <translation>オプション</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMAND</translation>
    </message>
    <message>
        <source>usage</source>
        <translation>使い方</translation>
    </message>
    <message>
        <source>Serve the drive&apos;s web pages here; port 0 picks a free one (127.0.0.1:0 unless this or --serial is given). Several drives take ports in a row</source>
        <translation>ドライブの Web ページをここで提供します。ポート 0 では空いているポートを選びます (これも --serial も指定しない場合は 127.0.0.1:0)。ドライブが複数の場合は連続したポートを使います</translation>
    </message>
    <message>
        <source>Serve the serial link on a pseudo-terminal, and make LINK a symbolic link to it. Several drives take LINK, LINK-2, ...</source>
        <translation>シリアル接続を疑似端末で提供し、LINK をそのシンボリックリンクにします。ドライブが複数の場合は順に LINK、LINK-2、...</translation>
    </message>
    <message>
        <source>Make the serial link as slow as a line of this speed (as fast as it can unless given)</source>
        <translation>シリアル接続を、この通信速度の回線と同じ遅さにします (指定がない場合は可能な限り高速)</translation>
    </message>
    <message>
        <source>Name of the drive (Virtual-1 unless given)</source>
        <translation>ドライブの名前 (既定: Virtual-1)</translation>
    </message>
    <message>
        <source>Number of axes, 1 to 16 (2 unless given)</source>
        <translation>軸数、1 から 16 (既定: 2)</translation>
    </message>
    <message>
        <source>Take names, axes and parameters from a TAM configuration; several drives in it are several virtual drives</source>
        <translation>名前、軸、パラメータを TAM 構成から取得します。構成に複数のドライブがあれば、複数の仮想ドライブになります</translation>
    </message>
    <message>
        <source>Move the machine of this file (JSON): axes with errors that nobody knows, and an instrument that measures them</source>
        <translation>このファイル (JSON) の機械を動かします: 未知の誤差をもつ軸と、それを測定する測定器</translation>
    </message>
    <message>
        <source>Play this measuring plan (axiscomp targets) as the machine&apos;s control would, from 10 s after the start</source>
        <translation>この測定計画 (axiscomp targets) を、機械の NC 装置と同様に、起動の 10 s 後から実行します</translation>
    </message>
    <message>
        <source>Begin the program so many seconds after the start, whatever --speed is; unless given, after 10 s of the machine&apos;s time</source>
        <translation>--speed の値によらず、起動からこの秒数の後にプログラムを開始します。指定がない場合は、機械の時間で 10 s 後</translation>
    </message>
    <message>
        <source>Serve the instrument&apos;s lines on a pseudo-terminal, and make LINK a symbolic link to it</source>
        <translation>測定器の出力行を疑似端末で提供し、LINK をそのシンボリックリンクにします</translation>
    </message>
    <message>
        <source>Keep flash and saved parameters here across runs, a folder per drive</source>
        <translation>フラッシュの内容と保存したパラメータをここに残し、次回の実行でも使います。ドライブごとに 1 つのフォルダ</translation>
    </message>
    <message>
        <source>Misbehave: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, reboot-after=N or reject=CODE; may be given several times</source>
        <translation>異常動作: drop-after=BYTES、no-reply=N、garble=N、stores-wrong=N、slow=MS、reboot-after=N、reject=CODE。複数回指定可</translation>
    </message>
    <message>
        <source>Simulated seconds per second (1 unless given)</source>
        <translation>1 秒あたりのシミュレーション秒数 (既定: 1)</translation>
    </message>
    <message>
        <source>Start with axes that are not homed</source>
        <translation>軸を原点復帰未了の状態で起動します</translation>
    </message>
    <message>
        <source>Ask for this user name</source>
        <translation>このユーザ名を要求します</translation>
    </message>
    <message>
        <source>File whose first line is the password of --user</source>
        <translation>1 行目が --user のパスワードであるファイル</translation>
    </message>
    <message>
        <source>Serve https with this certificate</source>
        <translation>この証明書を使って https で提供します</translation>
    </message>
    <message>
        <source>Private key of --certificate</source>
        <translation>--certificate の秘密鍵</translation>
    </message>
    <message>
        <source>A servo drive in software, with the web pages, registers and behaviour of a real one.</source>
        <translation>ソフトウェアによるサーボドライブです。実物と同じ Web ページ、レジスタ、動作をもちます。</translation>
    </message>
    <message>
        <source>Prints a line `ready http=URL serial=DEVICE drive=NAME` for each drive, and runs until Ctrl-C.</source>
        <translation>ドライブごとに `ready http=URL serial=DEVICE drive=NAME` の行を出力し、Ctrl-C まで動作します。</translation>
    </message>
    <message>
        <source>Use this drive in place of the remembered ones; may be given several times: http://[user:password@]host[:port], https://..., serial:/dev/ttyUSB0[?baud=N], demo:</source>
        <translation>記憶している接続の代わりに、このドライブを使います。複数回指定可: http://[user:password@]host[:port]、https://...、serial:/dev/ttyUSB0[?baud=N]、demo:</translation>
    </message>
    <message>
        <source>Open this file of compensation data</source>
        <translation>この補正データのファイルを開きます</translation>
    </message>
    <message>
        <source>How long one exchange with a drive may take (5 unless given)</source>
        <translation>ドライブとの 1 回の通信にかけられる時間 (既定: 5)</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to servo drives, in a window.</source>
        <translation>測定した軸の誤差の補正テーブルを、ウィンドウの操作でサーボドライブに書き込みます。</translation>
    </message>
    <message>
        <source>Without --drive it uses the drives of the last time, or the built-in demo drive.</source>
        <translation>--drive がない場合は、前回のドライブ、または内蔵のデモドライブを使います。</translation>
    </message>
    <message>
        <source>Let the drive look up the table without adding its values</source>
        <translation>値を加えずに、ドライブにテーブルを参照させます</translation>
    </message>
    <message>
        <source>Activate the compensation, and compare the drive&apos;s output with the table</source>
        <translation>補正を有効にし、ドライブの出力をテーブルと比較します</translation>
    </message>
    <message>
        <source>Deactivate the compensation</source>
        <translation>補正を無効にします</translation>
    </message>
    <message>
        <source>Store the axis&apos;s table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>軸のテーブルをドライブのフラッシュメモリに保存します。再起動後も残ります</translation>
    </message>
    <message>
        <source>Make the axis&apos;s table volatile, so that it is lost at the next reboot</source>
        <translation>軸のテーブルを揮発にします。次の再起動で失われます</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>このコンピュータ</translation>
    </message>
    <message>
        <source>Show what this computer has and lacks, and what each known drive answers</source>
        <translation>このコンピュータにあるものと足りないもの、既知の各ドライブの応答を表示する</translation>
    </message>
    <message>
        <source>Time limit for all that a drive is asked (5 unless given)</source>
        <translation>1 台のドライブへの問い合わせ全体の制限時間 (既定: 5)</translation>
    </message>
    <message>
        <source>The connections of the window are asked too. Nothing is changed, on this computer or on a drive. What is printed has no passwords in it and is meant to be sent to whoever helps.</source>
        <translation>ウィンドウの接続にも問い合わせます。このコンピュータでもドライブでも、何も変更しません。出力にパスワードは含まれず、サポートの担当者に送るためのものです。</translation>
    </message>
    <message>
        <source>Open this file: a record (.axcal), a machine file (.toml), a TAM configuration (.TAMcfg), a table or a measurement</source>
        <translation>このファイルを開く: 記録 (.axcal)、機械ファイル (.toml)、TAM 構成 (.TAMcfg)、テーブル、測定</translation>
    </message>
    <message>
        <source>Measurement before and measurement after; with a record, which has the first, the second alone is enough</source>
        <translation>補正前の測定と補正後の測定。最初の測定を含む記録があれば、2 つ目だけで十分です</translation>
    </message>
    <message>
        <source>Leave values of the second measurement out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>2 つ目の測定の値を除外します: down:1:1 (方向、目標位置、走行)、run:up:3、target:7。コンマで区切って指定</translation>
    </message>
    <message>
        <source>Record of the compensation: the first measurement with its exclusions and corrections, prediction, table and tolerances</source>
        <translation>補正の記録 (除外と補正を含む最初の測定、予測、テーブル、許容値)</translation>
    </message>
    <message>
        <source>Where the drive looks its table up (the input or the output, whichever is the drive&apos;s): encoder (before the compensation) or set (after it); by default as the file says, or encoder</source>
        <translation>ドライブが自身のテーブル (入力と出力のうちドライブのもの) を参照する位置: encoder (補正前) または set (補正後)。指定がなければファイルの記載、なければ encoder</translation>
    </message>
</context>
<context>
    <name>JudgeOutlook</name>
    <message>
        <source>%1: not defined, so that the tolerance %2 cannot be met.</source>
        <translation>%1: 未定義のため、許容値 %2 を満たせません。</translation>
    </message>
    <message>
        <source>%1: %2, nearer to the tolerance %3 than the uncertainty. That is undecided.</source>
        <translation>%1: %2。許容値 %3 との差が不確かさより小さく、判定できません。</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. Go on to Fit: a table may make it smaller.</source>
        <translation>%1: %2。許容値 %3 を超えています。[フィッティング] に進んでください。テーブルで小さくできる可能性があります。</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. No table makes it smaller: look at the mechanics.</source>
        <translation>%1: %2。許容値 %3 を超えています。テーブルでは小さくできません。機械の機構部を点検してください。</translation>
    </message>
    <message>
        <source>Add the files of a measurement on the tab Measure.</source>
        <translation>[測定] タブで測定ファイルを追加してください。</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>ファイルを読み取り中 …</translation>
    </message>
    <message>
        <source>A file cannot be used: the tab Measure says why.</source>
        <translation>使用できないファイルがあります。理由は [測定] タブで確認してください。</translation>
    </message>
    <message>
        <source>This measurement has no targets, and so no figures of ISO 230-2. Go on to Fit, or measure at targets.</source>
        <translation>この測定には目標位置がないため、ISO 230-2 の特性値がありません。[フィッティング] に進むか、目標位置で測定してください。</translation>
    </message>
    <message>
        <source>Enter the tolerances of the axis, or go on to Fit.</source>
        <translation>軸の許容値を入力するか、[フィッティング] に進んでください。</translation>
    </message>
    <message>
        <source>Every tolerance is met. A table can still make the axis better: go on to Fit.</source>
        <translation>すべての許容値を満たしています。テーブルで軸をさらに改善できます。[フィッティング] に進んでください。</translation>
    </message>
    <message>
        <source>The standard&apos;s condition “%1” is not met.</source>
        <translation>規格の条件「%1」を満たしていません。</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>次元数</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>Dim{n}Source</source>
        <translation>Dim{n} ソース</translation>
    </message>
    <message>
        <source>problem</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>has all of this</source>
        <translation>すでに同じ内容</translation>
    </message>
    <message>
        <source>unfinished write</source>
        <translation>未完了の書き込み</translation>
    </message>
    <message>
        <source>Activation</source>
        <translation>有効化</translation>
    </message>
    <message>
        <source>differs: {fields}</source>
        <translation>相違: {fields}</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>written and switched</source>
        <translation>書き込み・切り替え済み</translation>
    </message>
    <message>
        <source>written</source>
        <translation>書き込み済み</translation>
    </message>
    <message>
        <source>switched</source>
        <translation>切り替え済み</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>処理不要</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>書き込みなし</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>{slot}, empty</source>
        <translation>{slot}、空</translation>
    </message>
    <message>
        <source>{slot}, persistent, CRC {crc}</source>
        <translation>{slot}、不揮発、CRC {crc}</translation>
    </message>
    <message>
        <source>{slot}, volatile, CRC {crc}</source>
        <translation>{slot}、揮発、CRC {crc}</translation>
    </message>
    <message>
        <source>switched, not written</source>
        <translation>切り替え済み、書き込みなし</translation>
    </message>
    <message>
        <source>written, not switched</source>
        <translation>書き込み済み、切り替えなし</translation>
    </message>
    <message>
        <source>not switched</source>
        <translation>切り替えなし</translation>
    </message>
    <message>
        <source>{outcome}, proved</source>
        <translation>{outcome}、検証済み</translation>
    </message>
    <message>
        <source>{outcome}, not proved</source>
        <translation>{outcome}、未検証</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>the file states the temperature</source>
        <translation>ファイルに温度の記載がある</translation>
    </message>
    <message>
        <source>the file states the instrument</source>
        <translation>ファイルに測定器の記載がある</translation>
    </message>
    <message>
        <source>the file states the feed</source>
        <translation>ファイルに送り速度の記載がある</translation>
    </message>
    <message>
        <source>the file states the dwell</source>
        <translation>ファイルにドウェル時間の記載がある</translation>
    </message>
    <message>
        <source>at least {due} targets over {range}: {count}</source>
        <translation>{range} に目標位置が {due} か所以上: {count}</translation>
    </message>
    <message>
        <source>a target about every 250 mm on an axis above 2 m: {count} over {range}, at most {gap} apart</source>
        <translation>2 m を超える軸では約 250 mm ごとに目標位置: {range} に {count}、間隔は最大 {gap}</translation>
    </message>
    <message>
        <source>at least 5 targets, and 5 for each metre: {count} over {range}</source>
        <translation>目標位置が 5 か所以上、かつ 1 m あたり 5 か所: {range} に {count}</translation>
    </message>
    <message>
        <source>a run in each direction on an axis above 2 m, for E, B and M alone: {count}</source>
        <translation>2 m を超える軸では各方向 1 走行 (E、B、M だけの場合): {count}</translation>
    </message>
    <message>
        <source>5 runs in each direction: the file has means</source>
        <translation>各方向 5 走行: ファイルは平均値</translation>
    </message>
    <message>
        <source>5 runs in each direction: {count} at the target with the fewest</source>
        <translation>各方向 5 走行: 最も少ない目標位置で {count}</translation>
    </message>
    <message>
        <source>every target is approached in both directions</source>
        <translation>すべての目標位置を両方向から位置決めしている</translation>
    </message>
    <message>
        <source>the targets are not all at the same place of the period {period}</source>
        <translation>目標位置が周期 {period} の同じ位相に集中していない</translation>
    </message>
    <message>
        <source>reversal value B</source>
        <translation>反転値 B</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <translation>平均反転値</translation>
    </message>
    <message>
        <source>range of the mean deviation M</source>
        <translation>平均位置決め偏差の範囲 M</translation>
    </message>
    <message>
        <source>systematic deviation E, up</source>
        <translation>系統偏差 E (正方向)</translation>
    </message>
    <message>
        <source>systematic deviation E, down</source>
        <translation>系統偏差 E (負方向)</translation>
    </message>
    <message>
        <source>systematic deviation E</source>
        <translation>系統偏差 E</translation>
    </message>
    <message>
        <source>repeatability R, up</source>
        <translation>繰返し性 R (正方向)</translation>
    </message>
    <message>
        <source>repeatability R, down</source>
        <translation>繰返し性 R (負方向)</translation>
    </message>
    <message>
        <source>repeatability R</source>
        <translation>繰返し性 R</translation>
    </message>
    <message>
        <source>accuracy A, up</source>
        <translation>正確さ A (正方向)</translation>
    </message>
    <message>
        <source>accuracy A, down</source>
        <translation>正確さ A (負方向)</translation>
    </message>
    <message>
        <source>accuracy A</source>
        <translation>正確さ A</translation>
    </message>
    <message>
        <source>the runs {direction} drift by {drift} from the first to the last, more than their spread explains</source>
        <translation>{direction}の走行が最初から最後までに {drift} ドリフトしており、ばらつきでは説明できません</translation>
    </message>
    <message>
        <source>more than a fifth of the values {direction} do not fit the others: the measurement was disturbed, and nothing is proposed</source>
        <translation>{direction}の値の 5 分の 1 超がほかの値と合いません。測定に外乱があったため、除外の提案はしません</translation>
    </message>
    <message numerus="yes">
        <source>{count} values excluded, not an evaluation by ISO 230-2</source>
        <comment>1 value excluded, not an evaluation by ISO 230-2</comment>
        <translation>
            <numerusform>{count} 個の値を除外。ISO 230-2 による評価ではありません</numerusform>
        </translation>
    </message>
    <message>
        <source>the file says {figure} = {published}</source>
        <translation>ファイルの記載: {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}, which is less than its own {figure} = {published}</source>
        <translation>{statement}。同じファイルの {figure} = {published} より小さくなっています</translation>
    </message>
    <message>
        <source>{statement}; computed from its values: {computed}</source>
        <translation>{statement}。値からの計算結果: {computed}</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>判定不能</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>means of runs</source>
        <translation>走行の平均値</translation>
    </message>
    <message>
        <source>a track without targets</source>
        <translation>目標位置のない連続測定</translation>
    </message>
    <message>
        <source>points of a plane or space</source>
        <translation>平面または空間の点</translation>
    </message>
    <message>
        <source>runs over targets</source>
        <translation>目標位置での走行</translation>
    </message>
    <message>
        <source>up</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>down</source>
        <translation>負方向</translation>
    </message>
    <message>
        <source>a slope of {slope} over {length} was taken out</source>
        <translation>{length} で {slope} の傾きを除去しました</translation>
    </message>
    <message>
        <source>the steepest part of {table} is between {from} and {to}: {step}, {slope} for each {one}</source>
        <translation>{table} の最も急な部分は {from} と {to} の間の {step} ({one} あたり {slope}) です</translation>
    </message>
    <message>
        <source>a drive holds numbers with 24 bits, which changes a value of {table} by at most {rounding}</source>
        <translation>ドライブの数値は 24 ビットのため、{table} の値が最大 {rounding} 変わります</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of {table} have nothing measured beside them and were filled</source>
        <comment>1 point of {table} has nothing measured beside it and was filled</comment>
        <translation>
            <numerusform>近くに測定点のない {table} の {count} 点を補填しました</numerusform>
        </translation>
    </message>
    <message>
        <source>merged onto {name} with gain {gain}: a value changes by at most {change}, at {place}</source>
        <translation>{name} に統合、ゲイン {gain}: 値の変化は最大 {change} ({place})</translation>
    </message>
    <message>
        <source>the table improves little: {figure} from {before} to {after}, less than a fifth</source>
        <translation>テーブルによる改善がわずかです: {figure} が {before} から {after} へ、5 分の 1 未満の改善</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}; measure at more targets</source>
        <translation>目標位置の間の誤差が十分に把握できていません。各目標位置を使わずに予測した M は {heldOut} です。目標位置を増やして測定してください</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>目標位置の間の誤差が十分に把握できていません。各目標位置を使わずに予測した M は {heldOut} で、補正前は {before} です。目標位置を増やして測定してください</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: up to {reversal} remains in each direction</source>
        <translation>この誤差の大部分は反転値で、テーブルでは除去できません。各方向に最大 {reversal} 残ります</translation>
    </message>
    <message>
        <source>the table is for both directions: up to {reversal} of the reversal remains in each</source>
        <translation>テーブルは両方向共通のため、反転値のうち最大 {reversal} が各方向に残ります</translation>
    </message>
    <message>
        <source>the table is for one direction: in the other up to {reversal} of reversal remains</source>
        <translation>テーブルは片方向用のため、逆方向には反転値が最大 {reversal} 残ります</translation>
    </message>
    <message>
        <source>{count} targets lie in {turns} periods of {period}</source>
        <translation>{count} か所の目標位置が周期 {period} の {turns} 周期分にあります</translation>
    </message>
    <message>
        <source>{table} adds {value} at the home position {home}</source>
        <translation>{table} は原点位置 {home} で {value} を加算します</translation>
    </message>
    <message>
        <source>over a turn, from {from} to {to}, {table} ends {jump} above where it begins</source>
        <translation>{from} から {to} までの 1 回転で、{table} の終わりが始まりより {jump} 大きくなっています</translation>
    </message>
    <message>
        <source>the compensation off</source>
        <translation>補正オフ</translation>
    </message>
    <message>
        <source>the compensation on</source>
        <translation>補正オン</translation>
    </message>
    <message>
        <source>the table {crc} active</source>
        <translation>テーブル {crc} 有効</translation>
    </message>
    <message>
        <source>measured with the table {crc} of {name} active</source>
        <translation>{name} のテーブル {crc} を有効にして測定</translation>
    </message>
    <message>
        <source>measured with {name} active ({known})</source>
        <translation>{name} ({known}) を有効にして測定</translation>
    </message>
    <message>
        <source>the measurement does not say which table was active; {name} ({known}) is taken to have been</source>
        <translation>測定に、有効だったテーブルの記載がありません。{name} ({known}) とみなします</translation>
    </message>
    <message>
        <source>the raw positions of the encoder are on file: the table is made of reference minus encoder, whatever compensation was active</source>
        <translation>ファイルにエンコーダの補正前の位置があるため、有効だった補正によらず、テーブルは基準 − エンコーダから作成します</translation>
    </message>
    <message>
        <source>measured with the compensation off</source>
        <translation>補正オフで測定</translation>
    </message>
    <message>
        <source>{table} explains {share} % of the variance of {count} values; {rms} rms remains</source>
        <translation>{table} は {count} 個の値の分散の {share} % を説明します。残りは rms {rms} です</translation>
    </message>
    <message>
        <source>{table} explains little: values that were left out are foretold with {left} rms, and they are {values} rms themselves</source>
        <translation>{table} の説明力が低くなっています。使わなかった値の予測誤差は rms {left}、値自体は rms {values} です</translation>
    </message>
    <message numerus="yes">
        <source>{count} values lie outside the grid and were left out</source>
        <comment>1 value lies outside the grid and was left out</comment>
        <translation>
            <numerusform>格子の外にある {count} 個の値を除きました</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is point {first}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: point {first}, {residual} off</comment>
        <translation>
            <numerusform>{table} の {count} 個の値がほかの値と合わないため、重みを下げました。最初は点 {first} で、ずれは {residual} です</numerusform>
        </translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} less than 90 degrees</source>
        <translation>{first} と {second} のなす角は 90 度より {angle} 小さくなっています</translation>
    </message>
    <message>
        <source>a scale of {scale} for each {length} was taken out; the mean scale error of the axes is in it, and stays in the machine</source>
        <translation>{length} あたり {scale} の倍率誤差を除去しました。これには各軸の平均スケール誤差が含まれ、機械に残ります</translation>
    </message>
    <message>
        <source>{axis} {position}</source>
        <translation>{axis} {position}</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; the drive will add {added}</source>
        <translation>{position} で、{table} の基準とエンコーダの差は {measured} でした。ドライブは {added} を加算します</translation>
    </message>
    <message>
        <source>how well the error between the targets is known cannot be told: {reason}</source>
        <translation>目標位置の間の誤差をどの程度把握できているか評価できません: {reason}</translation>
    </message>
    <message>
        <source>at {speed} the velocity jumps by at most {step} at a point of the table</source>
        <translation>{speed} では、テーブルの点で速度が最大 {step} 段差状に変化します</translation>
    </message>
    <message>
        <source>{count} points of {table} with straight lines between them are at most {distance} off the curve, at {place}</source>
        <translation>{table} の {count} 点を直線で結んだ線と曲線の距離は最大 {distance} ({place}) です</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; the drive will add {added}</comment>
        <translation>
            <numerusform>エンコーダが {reading} のとき、基準は {count} 個の値の平均で {reference} でした。ドライブは {added} を加算します</numerusform>
        </translation>
    </message>
    <message>
        <source>the error is {factor} times what it was before: the table has the wrong sign</source>
        <translation>誤差が補正前の {factor} 倍です。テーブルの符号が逆です</translation>
    </message>
    <message>
        <source>the error is the same as before: the compensation was not active, or another axis was measured</source>
        <translation>誤差が補正前と同じです。補正が有効でなかったか、別の軸を測定しています</translation>
    </message>
    <message>
        <source>what is left is {factor} times the error before: the table adds {share} times what it should; look at the units of measurement and table</source>
        <translation>残りの誤差が補正前の {factor} 倍です。テーブルの加算量が本来の {share} 倍になっています。測定とテーブルの単位を確認してください</translation>
    </message>
    <message>
        <source>what is left resembles neither the error before nor its slope: the machine was in another state, such as another temperature or load, or it is another axis</source>
        <translation>残りの誤差が、補正前の誤差にもその傾きにも似ていません。機械の状態 (温度、負荷など) が異なるか、別の軸です</translation>
    </message>
    <message>
        <source>what is left follows the slope of the error before: the table is shifted by about {shift} against the axis; look at the home position and the source of the table</source>
        <translation>残りの誤差が補正前の誤差の傾きに対応しています。テーブルが軸に対して約 {shift} ずれています。原点位置とテーブルのソースを確認してください</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>met</source>
        <translation>適合</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不適合</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others: look at them, and exclude them or leave them in</source>
        <comment>1 value does not fit the others: look at it, and exclude it or leave it in</comment>
        <translation>
            <numerusform>{count} 個の値がほかの値と合いません。確認して、除外するかそのままにしてください</numerusform>
        </translation>
    </message>
    <message>
        <source>the backup {file}</source>
        <translation>バックアップ {file}</translation>
    </message>
    <message>
        <source>the table of axis {index}</source>
        <translation>軸 {index} のテーブル</translation>
    </message>
    <message>
        <source>the table of axis {index} ({axis})</source>
        <translation>軸 {index} ({axis}) のテーブル</translation>
    </message>
    <message>
        <source>{temperature}</source>
        <translation>{temperature}</translation>
    </message>
    <message>
        <source>measured in {count} thermal states: {temperatures}; outside of them the drive holds the values of the ends</source>
        <translation>{count} つの熱状態で測定: {temperatures}。その範囲外では、ドライブは端点値を保持します</translation>
    </message>
    <message>
        <source>the table is straight over temperature, which leaves up to {largest} of what was measured in a state</source>
        <translation>テーブルは温度に対して直線的なため、各熱状態で測定した値のうち最大 {largest} が残ります</translation>
    </message>
    <message>
        <source>the table has the movement of the zero from one thermal state to the other, as the instrument saw it: that is only right if its own zero was not set anew in between</source>
        <translation>テーブルには、測定器で見た熱状態間のゼロ点の移動が含まれています。これは、測定の間に測定器のゼロ点を設定し直していない場合にだけ正しい値です</translation>
    </message>
    <message>
        <source>at {temperature}: {sentence}</source>
        <translation>{temperature}: {sentence}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {after} after</source>
        <translation>{figure}: 補正前 {before}、補正後 {after}</translation>
    </message>
    <message>
        <source>{figure} {after}</source>
        <translation>{figure}: {after}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {predicted} predicted, not measured since</source>
        <translation>{figure}: 補正前 {before}、予測 {predicted}、補正後は未測定</translation>
    </message>
    <message>
        <source>{figure} {before} before, not measured since</source>
        <translation>{figure}: 補正前 {before}、補正後は未測定</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance})</source>
        <translation>{values} (許容値 {tolerance})</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance}: {result})</source>
        <translation>{values} (許容値 {tolerance}: {result})</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}; {next}</translation>
    </message>
    <message>
        <source>measured {date}: {figures}</source>
        <translation>{date} 測定: {figures}</translation>
    </message>
    <message>
        <source>{figure} {before} before</source>
        <translation>{figure}: 補正前 {before}</translation>
    </message>
    <message>
        <source>{figure} {after}, {before} before</source>
        <translation>{figure}: {after}、補正前 {before}</translation>
    </message>
    <message>
        <source>there is a table for each direction, and the reversal of up to {reversal} is in them: switch off the controller&apos;s own backlash compensation</source>
        <translation>方向別のテーブルがあり、最大 {reversal} の反転値が含まれています。コントローラ自身のバックラッシ補正をオフにしてください</translation>
    </message>
    <message>
        <source>approached upwards: {sentence}</source>
        <translation>正方向の位置決め: {sentence}</translation>
    </message>
    <message>
        <source>approached downwards: {sentence}</source>
        <translation>負方向の位置決め: {sentence}</translation>
    </message>
    <message>
        <source>the new table is coarser than {name}: up to {lost} of what that has between the new points is lost; take more points</source>
        <translation>新しいテーブルは {name} より粗く、新しい点の間にある情報が最大 {lost} 失われます。点数を増やしてください</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others and are in the table; judging names them, and they can be excluded</source>
        <comment>1 value does not fit the others and is in the table; judging names it, and it can be excluded</comment>
        <translation>
            <numerusform>ほかの値と合わない {count} 個の値がテーブルに含まれています。[判定] に表示され、除外できます</numerusform>
        </translation>
    </message>
    <message>
        <source>the targets are not all at the same place of a period of the axis; no period is stated</source>
        <translation>目標位置が軸の周期の同じ位相に集中していない (周期の指定なし)</translation>
    </message>
    <message>
        <source>from {from} to {to} nothing was measured, {gap} of a turn of {turn}: there the table is guessed, and no figure knows of it; measure the whole turn</source>
        <translation>{from} から {to} まで (1 回転 {turn} のうち {gap}) は測定されていません。そこではテーブルは推測であり、どの特性値にも現れません。1 回転全体を測定してください</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: the table is for one direction, and up to {reversal} remains in the other</source>
        <translation>この誤差の大部分は反転値で、テーブルでは除去できません。テーブルは片方向用のため、逆方向には最大 {reversal} 残ります</translation>
    </message>
    <message>
        <source>each figure, before and foretold, is the largest of a thermal state and of all runs together</source>
        <translation>補正前と予測の各特性値は、各熱状態と全走行一括のうち最大の値です</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of both tables for their zero</source>
        <translation>ゼロ点のため、両方のテーブルのすべての値から {constant} を引きました</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of {table} for its zero</source>
        <translation>ゼロ点のため、{table} のすべての値から {constant} を引きました</translation>
    </message>
    <message>
        <source>the new table is shorter than {name}: up to {lost} of what that has beyond the ends of the new one is lost; ask for no grid, which keeps that of {name}, or for one as long, or measure the whole of it</source>
        <translation>新しいテーブルは {name} より短く、その両端の外で {name} にあるもののうち最大 {lost} が失われます。格子を指定しなければ元の格子が残ります。同じ長さの格子を指定するか、全範囲を測定してください</translation>
    </message>
    <message>
        <source>the rule grubbs is for 4 to 10 values of a target, and some of those {direction} were not tested</source>
        <translation>規則 grubbs は目標位置ごとに 4～10 個の値に使えます。{direction}の一部は検定されていません</translation>
    </message>
    <message>
        <source>a value {direction} stands out that the rule mad does not propose: it keeps 3 values of each target, and needs others that differ</source>
        <translation>{direction}に目立つ値がありますが、規則 mad は提案しません。目標位置ごとに 3 個の値を残し、ばらつきのある他の値を必要とするためです</translation>
    </message>
    <message>
        <source>{table} goes from {from} to {to}, the targets from {first} to {last}: beyond its ends the drive holds their values; take the number of points, or a distance that divides the range of the targets</source>
        <translation>{table} は {from} から {to} まで、目標位置は {first} から {last} までです。端の外側ではドライブが端の値を保持します。点数、または目標位置の範囲を割り切る間隔を指定してください</translation>
    </message>
    <message>
        <source>the first target is {first}; the table is for an axis that counts from {from} to {to}: where it counts otherwise, the drive holds the values at the ends</source>
        <translation>最初の目標位置は {first} です。テーブルは {from} から {to} まで数える軸のものです。それ以外では、ドライブが端の値を保持します</translation>
    </message>
    <message>
        <source>{read} ({corrected} after corrections)</source>
        <translation>{read}（補正後 {corrected}）</translation>
    </message>
    <message>
        <source>first measurement: {remark}</source>
        <translation>1 回目の測定: {remark}</translation>
    </message>
    <message>
        <source>second measurement: {remark}</source>
        <translation>2 回目の測定: {remark}</translation>
    </message>
    <message>
        <source>of all values {figure} is {value} (tolerance {tolerance}: {result})</source>
        <translation>全データでは {figure} は {value} です (許容値 {tolerance}: {result})</translation>
    </message>
    <message>
        <source>the first measurement is of the machine {before}, the second of {after}</source>
        <translation>1 回目の測定は機械 {before}、2 回目の測定は {after} のものです</translation>
    </message>
    <message>
        <source>the first measurement has the serial number {before}, the second {after}</source>
        <translation>1 回目の測定のシリアル番号は {before}、2 回目は {after} です</translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} more than 90 degrees</source>
        <translation>{first} と {second} のなす角は 90 度より {angle} 大きくなっています</translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is at {place}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: at {place}, {residual} off</comment>
        <translation>
            <numerusform>{table} の {count} 個の値がほかの値と合わないため、重みを下げました。最初は {place} で、ずれは {residual} です</numerusform>
        </translation>
    </message>
    <message>
        <source>first measurement from {beforeFirst} to {beforeLast}, second one from {afterFirst} to {afterLast}</source>
        <translation>1 回目の測定は {beforeFirst} から {beforeLast}、2 回目は {afterFirst} から {afterLast}</translation>
    </message>
    <message>
        <source>{ranges}: over a shorter travel the figures are smaller whatever the compensation does, and nothing is proved for the rest</source>
        <translation>{ranges}: ストロークが短いと、補正の効果にかかわらず特性値は小さくなり、残りの範囲は検証されません</translation>
    </message>
    <message>
        <source>{figures}, over part of the travel</source>
        <translation>{figures} (ストロークの一部)</translation>
    </message>
    <message>
        <source>{removed} was taken out for the zero of the table</source>
        <translation>テーブルの零点のために {removed} を取り除いた</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope and the zero of the table</source>
        <translation>テーブルの傾きと零点のために {removed} を取り除いた</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope</source>
        <translation>傾きのために {removed} を取り除いた</translation>
    </message>
    <message>
        <source>{removed} was taken out for how the artefact lay and for the zero of the table</source>
        <translation>標準器の置かれ方とテーブルの零点のために {removed} を取り除いた</translation>
    </message>
    <message>
        <source>{evened} was taken out by gain, averaging, smoothing or grid</source>
        <translation>ゲイン、平均、平滑化または格子により {evened} が取り除かれた</translation>
    </message>
    <message>
        <source>{removed}, and {evened} by gain, averaging, smoothing or grid</source>
        <translation>{removed}うえに、ゲイン、平均、平滑化または格子により {evened} が取り除かれた</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; {taken}, so the drive will add {added}</source>
        <translation>{position} で、{table} の基準とエンコーダの差は {measured} でした。{taken}ので、ドライブは {added} を加算します</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; {taken}, so the drive will add {added}</source>
        <translation>エンコーダが {reading} のとき、基準は両方向の平均 ({count} 個の値) で {reference} でした。{taken}ので、ドライブは {added} を加算します</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; the drive will add {added}</source>
        <translation>エンコーダが {reading} のとき、基準は両方向の平均 ({count} 個の値) で {reference} でした。ドライブは {added} を加算します</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; {taken}, so the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; {taken}, so the drive will add {added}</comment>
        <translation>
            <numerusform>エンコーダが {reading} のとき、基準は {count} 個の値の平均で {reference} でした。{taken}ので、ドライブは {added} を加算します</numerusform>
        </translation>
    </message>
    <message>
        <source>the second measurement is of {date}, and the record has one of {last} with the same table, which decides</source>
        <translation>2 回目の測定は {date} のものですが、記録には同じテーブルでの {last} の測定があり、そちらが優先されます</translation>
    </message>
    <message>
        <source>the targets of the second measurement are up to {second} apart, those of the first one up to {first}: what lies between them is not measured again</source>
        <translation>2 回目の測定の目標位置の間隔は最大 {second}、1 回目は最大 {first} です。その間は再測定されていません</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, E of the direction that was measured is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>目標位置の間の誤差が十分に把握できていません。各目標位置を使わずに予測した、測定方向の E は {heldOut} で、補正前は {before} です。目標位置を増やして測定してください</translation>
    </message>
    <message>
        <source>0 = mean at {position}</source>
        <translation>0 = {position} での平均</translation>
    </message>
    <message>
        <source>{said} (file {file})</source>
        <translation>{said} (ファイル {file})</translation>
    </message>
    <message>
        <source>the files are of different machines: {machines}</source>
        <translation>ファイルの機械が異なります: {machines}</translation>
    </message>
    <message>
        <source>the files have different serial numbers: {numbers}</source>
        <translation>ファイルのシリアル番号が異なります: {numbers}</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>axis %1</source>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>図</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg or .pdf.</source>
        <translation>ファイル名は .png、.svg または .pdf で終わる必要があります。</translation>
    </message>
    <message>
        <source>Save picture or values</source>
        <translation>図または値の保存</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>図の保存</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>図面 (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>文書 (*.pdf)</translation>
    </message>
    <message>
        <source>Values (*.csv)</source>
        <translation>値 (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>%1 に保存しました</translation>
    </message>
</context>
<context>
    <name>PlanText</name>
    <message>
        <source>Axis %1: %2 targets, %3 values</source>
        <translation>軸 %1: 目標位置 %2 か所、値 %3 個</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>the file holds no data</source>
        <translation>ファイルにデータがありません</translation>
    </message>
    <message>
        <source>export it again, or choose another file</source>
        <translation>もう一度エクスポートするか、別のファイルを選んでください</translation>
    </message>
    <message>
        <source>the header line with the names of the columns is missing</source>
        <translation>列名のヘッダ行がありません</translation>
    </message>
    <message>
        <source>add a first line such as X [mm],Table 1 [mm], or for a measurement target [mm],direction,run,deviation [um]</source>
        <translation>先頭に X [mm],Table 1 [mm] のような行を追加してください。測定の場合は target [mm],direction,run,deviation [um] です</translation>
    </message>
    <message>
        <source>the header has too few columns</source>
        <translation>ヘッダの列が不足しています</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has</source>
        <translation>ファイルと同じ次元数を選んでください</translation>
    </message>
    <message>
        <source>this line does not have as many columns as the header</source>
        <translation>この行の列数がヘッダと異なります</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>数値ではありません</translation>
    </message>
    <message>
        <source>this number is not finite</source>
        <translation>有限の数値ではありません</translation>
    </message>
    <message>
        <source>it is not clear which sign is the decimal one</source>
        <translation>小数点の記号がどれか分かりません</translation>
    </message>
    <message>
        <source>use one decimal sign in all numbers, and none between thousands</source>
        <translation>すべての数値で同じ小数点を使い、桁区切りは入れないでください</translation>
    </message>
    <message>
        <source>a quotation mark is not closed as it should be</source>
        <translation>引用符が正しく閉じていません</translation>
    </message>
    <message>
        <source>the same position occurs twice</source>
        <translation>同じ位置が 2 回あります</translation>
    </message>
    <message>
        <source>delete one of the two lines</source>
        <translation>2 つの行のどちらかを削除してください</translation>
    </message>
    <message>
        <source>the grid is incomplete</source>
        <translation>格子に欠けがあります</translation>
    </message>
    <message>
        <source>the positions are not evenly spaced</source>
        <translation>位置が等間隔ではありません</translation>
    </message>
    <message>
        <source>resample the data onto an even grid, which can be done here for a calibration file only</source>
        <translation>データを等間隔格子に再サンプリングしてください (ここでできるのは校正ファイルのみです)</translation>
    </message>
    <message>
        <source>there are too few points</source>
        <translation>点数が不足しています</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>ファイルが大きすぎます</translation>
    </message>
    <message>
        <source>choose a coarser grid, or split the file</source>
        <translation>格子を粗くするか、ファイルを分割してください</translation>
    </message>
    <message>
        <source>this is not a text file</source>
        <translation>テキストファイルではありません</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>ファイルを読み取れません</translation>
    </message>
    <message>
        <source>the file is not valid UTF-8 and is read as Windows-1252</source>
        <translation>ファイルが有効な UTF-8 ではないため、Windows-1252 として読み取ります</translation>
    </message>
    <message>
        <source>the positions are even only within the printed precision</source>
        <translation>位置が等間隔になるのは、出力された桁数の範囲だけです</translation>
    </message>
    <message>
        <source>the even grid is used; print more decimals if that is not meant</source>
        <translation>等間隔格子とみなします。そうでない場合は、小数の桁数を増やしてください</translation>
    </message>
    <message>
        <source>a value loses precision when it is stored as float32</source>
        <translation>float32 で保存すると値の精度が落ちます</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>値の単位を確認してください</translation>
    </message>
    <message>
        <source>the table is very steep, which is likely a unit mistake</source>
        <translation>テーブルの傾きが非常に急です。単位の誤りと考えられます</translation>
    </message>
    <message>
        <source>all values of the table are equal</source>
        <translation>テーブルの値がすべて同じです</translation>
    </message>
    <message>
        <source>check that this column is meant</source>
        <translation>この列でよいか確認してください</translation>
    </message>
    <message>
        <source>found an empty cell</source>
        <translation>セルが空です</translation>
    </message>
    <message>
        <source>this is not written as the format demands</source>
        <translation>形式の規則に合っていません</translation>
    </message>
    <message>
        <source>the positions do not go in one direction</source>
        <translation>位置が一方向に並んでいません</translation>
    </message>
    <message>
        <source>the table does not close after one revolution</source>
        <translation>1 回転後にテーブルが閉じていません</translation>
    </message>
    <message>
        <source>the controller does not take as much</source>
        <translation>コントローラの上限を超えています</translation>
    </message>
    <message>
        <source>this entry is not known and is left out</source>
        <translation>不明なエントリのため無視します</translation>
    </message>
    <message>
        <source>the file does not say a unit</source>
        <translation>ファイルに単位の記載がありません</translation>
    </message>
    <message>
        <source>the file can be understood in several ways</source>
        <translation>ファイルを複数の意味に解釈できます</translation>
    </message>
    <message>
        <source> (error %1 of the controller)</source>
        <translation> (コントローラのエラー %1)</translation>
    </message>
    <message>
        <source>found &quot;{found}&quot;</source>
        <translation>実際: &quot;{found}&quot;</translation>
    </message>
    <message>
        <source>found {found}</source>
        <translation>実際: {found}</translation>
    </message>
    <message>
        <source>{problem}: {found}</source>
        <translation>{problem}: {found}</translation>
    </message>
    <message>
        <source>{problem}, expected {expected}</source>
        <translation>{problem}、必要: {expected}</translation>
    </message>
    <message>
        <source>{problem}; {wayOut}</source>
        <translation>{problem}。{wayOut}</translation>
    </message>
    <message>
        <source>the axis that the values correct cannot be told</source>
        <translation>値がどの軸を補正するのか判別できません</translation>
    </message>
    <message>
        <source>check the units of values and positions</source>
        <translation>値と位置の単位を確認してください</translation>
    </message>
    <message>
        <source>points without a value are filled</source>
        <translation>値のない点を補填します</translation>
    </message>
    <message>
        <source>the grid is cropped to the points that have a value</source>
        <translation>値のある点だけになるように格子を切り詰めます</translation>
    </message>
    <message>
        <source>positions are snapped to the grid</source>
        <translation>位置を格子にスナップします</translation>
    </message>
    <message>
        <source>comments from here on are not kept with the table</source>
        <translation>ここから後のコメントはテーブルに保存しません</translation>
    </message>
    <message>
        <source>the file has another dimensionality than the one chosen</source>
        <translation>ファイルの次元数が、選んだ次元数と異なります</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has (--dims)</source>
        <translation>ファイルと同じ次元数を選んでください (--dims)</translation>
    </message>
    <message>
        <source>the columns do not say what was measured</source>
        <translation>何を測定したのか、列から判別できません</translation>
    </message>
    <message>
        <source>the unit of a column is not known</source>
        <translation>列の単位が不明です</translation>
    </message>
    <message>
        <source>a length and an angle are mixed</source>
        <translation>長さと角度が混在しています</translation>
    </message>
    <message>
        <source>correct the unit in the file, or state it</source>
        <translation>ファイルの単位を修正するか、単位を指定してください</translation>
    </message>
    <message>
        <source>this is not a direction</source>
        <translation>方向ではありません</translation>
    </message>
    <message>
        <source>this is not the number of a run</source>
        <translation>走行の番号ではありません</translation>
    </message>
    <message>
        <source>the same value is there twice</source>
        <translation>同じ値が 2 回あります</translation>
    </message>
    <message>
        <source>the file holds another number than it says</source>
        <translation>ファイルにある個数が、その記載と異なります</translation>
    </message>
    <message>
        <source>there are too few targets</source>
        <translation>目標位置が不足しています</translation>
    </message>
    <message>
        <source>there is no target of this number</source>
        <translation>この番号の目標位置はありません</translation>
    </message>
    <message>
        <source>positions do not follow one another one to one</source>
        <translation>位置どうしが 1 対 1 で対応していません</translation>
    </message>
    <message>
        <source>values are missing</source>
        <translation>値が欠落しています</translation>
    </message>
    <message>
        <source>the figures are made of the values that are there</source>
        <translation>特性値は、存在する値から計算します</translation>
    </message>
    <message>
        <source>the directions have different numbers of runs</source>
        <translation>方向によって走行の回数が異なります</translation>
    </message>
    <message>
        <source>the values look like positions instead of deviations</source>
        <translation>値が偏差ではなく位置のようです</translation>
    </message>
    <message>
        <source>if they are positions of the reference, say so: --values reference, or name the column reference</source>
        <translation>基準の位置の場合は、--values reference を指定するか、列名を reference にしてください</translation>
    </message>
    <message>
        <source>the size of the values is unusual</source>
        <translation>値の大きさが通常と異なります</translation>
    </message>
    <message>
        <source>a result in the file is not what its values give</source>
        <translation>ファイル内の結果が、その値からの計算結果と一致しません</translation>
    </message>
    <message>
        <source>not everything in the file is used</source>
        <translation>ファイルの一部は使いません</translation>
    </message>
    <message>
        <source>an entry {key}</source>
        <translation>エントリ {key}</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true または false</translation>
    </message>
    <message>
        <source>one of {known}</source>
        <translation>{known} のいずれか</translation>
    </message>
    <message>
        <source>sections that begin with [[{key}]]</source>
        <translation>[[{key}]] で始まるセクション</translation>
    </message>
    <message>
        <source>at most {count} of them</source>
        <translation>{count} 個以下</translation>
    </message>
    <message>
        <source>a known key; the nearest is {key}</source>
        <translation>有効なキー。最も近いものは {key} です</translation>
    </message>
    <message>
        <source>valid TOML ({reason})</source>
        <translation>有効な TOML ({reason})</translation>
    </message>
    <message>
        <source>{number}, the version of this format</source>
        <translation>{number} (この形式のバージョン)</translation>
    </message>
    <message>
        <source>{name} is a drive in line {line} already</source>
        <translation>{name} は行 {line} ですでにドライブの名前です</translation>
    </message>
    <message>
        <source>serial number {name} is in line {line} already</source>
        <translation>シリアル番号 {name} はすでに行 {line} にあります</translation>
    </message>
    <message>
        <source>a list of one to three registers</source>
        <translation>1 から 3 個のレジスタのリスト</translation>
    </message>
    <message>
        <source>settings as {example}</source>
        <translation>{example} のような設定</translation>
    </message>
    <message>
        <source>a text, a number, true or false</source>
        <translation>テキスト、数値、true または false</translation>
    </message>
    <message>
        <source>an entry file, or no-table = true for an axis that shall have none</source>
        <translation>エントリ file、またはテーブルなしの軸では no-table = true</translation>
    </message>
    <message>
        <source>{key} of an axis without a table</source>
        <translation>テーブルのない軸の {key}</translation>
    </message>
    <message>
        <source>no-table beside file</source>
        <translation>file と no-table の両方</translation>
    </message>
    <message>
        <source>an entry sources, with the register that looks the table up for each of its dimensions</source>
        <translation>テーブルの次元ごとに参照用レジスタを示すエントリ sources</translation>
    </message>
    <message>
        <source>axis {name} of this drive is in line {line} already</source>
        <translation>このドライブの軸 {name} はすでに行 {line} にあります</translation>
    </message>
    <message>
        <source>slot {name} is taken by the axis in line {line}</source>
        <translation>スロット {name} はすでに行 {line} の軸が使っています</translation>
    </message>
    <message>
        <source>save it as UTF-8 text</source>
        <translation>UTF-8 のテキストで保存してください</translation>
    </message>
    <message>
        <source>check the names and notes, or save it as UTF-8 text</source>
        <translation>名前とメモを確認するか、UTF-8 のテキストで保存してください</translation>
    </message>
    <message>
        <source>the directions of the runs are doubtful</source>
        <translation>走行の方向が疑わしい</translation>
    </message>
    <message>
        <source>compare them with the data, and exchange them if they are the other way round</source>
        <translation>データと照合し、逆になっている場合は交換してください</translation>
    </message>
    <message>
        <source>line {line}: {problem}</source>
        <translation>行 {line}: {problem}</translation>
    </message>
    <message>
        <source>two statements contradict each other</source>
        <translation>2 つの記述が矛盾しています</translation>
    </message>
    <message>
        <source>the serial number of the drive, a whole number of at most 32 bits, without quotation marks</source>
        <translation>ドライブのシリアル番号 (32 ビット以内の整数、引用符なし)</translation>
    </message>
    <message>
        <source>a text that is not empty and has no control characters</source>
        <translation>空でなく、制御文字を含まないテキスト</translation>
    </message>
    <message>
        <source>a name, or a whole number that is not negative</source>
        <translation>名前、または 0 以上の整数</translation>
    </message>
    <message>
        <source>a number that is not negative and its unit, such as {example}</source>
        <translation>0 以上の数値とその単位 (例: {example})</translation>
    </message>
    <message>
        <source>UTF-8 text</source>
        <translation>UTF-8 のテキスト</translation>
    </message>
    <message>
        <source>delete one of the two</source>
        <translation>どちらか一方を削除してください</translation>
    </message>
    <message>
        <source>a text; write it in quotation marks</source>
        <translation>テキスト。引用符で囲んで書いてください</translation>
    </message>
    <message>
        <source>a text; write {source} for the first source, {name} for an axis of that name</source>
        <translation>テキスト。第 1 ソースなら {source}、その名前の軸なら {name} と書いてください</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Deviation in {unit}</source>
        <translation>偏差 ({unit})</translation>
    </message>
    <message>
        <source>Position in {unit}</source>
        <translation>位置 ({unit})</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions with bands of 2 s, the mean of both, single runs</source>
        <translation>位置に対する偏差: 各方向の平均と 2 s の帯、両方向の平均、個々の走行</translation>
    </message>
    <message>
        <source>What lines and markers mean</source>
        <translation>線と記号の意味</translation>
    </message>
    <message>
        <source>mean ↑</source>
        <translation>平均 ↑</translation>
    </message>
    <message>
        <source>mean ↓</source>
        <translation>平均 ↓</translation>
    </message>
    <message>
        <source>mean of both</source>
        <translation>両方向の平均</translation>
    </message>
    <message>
        <source>mean ↑ ± 2 s</source>
        <translation>平均 ↑ ± 2 s</translation>
    </message>
    <message>
        <source>mean ↓ ± 2 s</source>
        <translation>平均 ↓ ± 2 s</translation>
    </message>
    <message>
        <source>single run</source>
        <translation>個々の走行</translation>
    </message>
    <message>
        <source>dead path of {length}: values changed by up to {largest}</source>
        <translation>デッドパス {length}: 値の変化は最大 {largest}</translation>
    </message>
    <message>
        <source>drift taken out for the table, not for figures</source>
        <translation>テーブルではドリフトを除去、特性値では除去しない</translation>
    </message>
    <message>
        <source>smooth grid of scattered points</source>
        <translation>散在する点からの滑らかな格子</translation>
    </message>
    <message>
        <source>{method}, from the runs ↑</source>
        <translation>{method}、走行 ↑ から</translation>
    </message>
    <message>
        <source>{method}, from the runs ↓</source>
        <translation>{method}、走行 ↓ から</translation>
    </message>
    <message>
        <source>{method}, from the mean of both directions</source>
        <translation>{method}、両方向の平均から</translation>
    </message>
    <message>
        <source>failed after {share} of the table</source>
        <translation>テーブルの {share} まで検証した時点で不合格</translation>
    </message>
    <message>
        <source>passed over {share} of the table</source>
        <translation>テーブルの {share} で合格</translation>
    </message>
    <message>
        <source>At the set position {position} the drive adds {added} to what the encoder reads.</source>
        <translation>指令位置 {position} で、ドライブはエンコーダの読み値に {added} を加算します。</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the drive adds {added}.</source>
        <translation>エンコーダが {reading} のとき、ドライブは {added} を加算します。</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the reference said {reference}: the drive adds {added}.</source>
        <translation>エンコーダが {reading} のとき、基準は {reference} でした。ドライブは {added} を加算します。</translation>
    </message>
    <message>
        <source>Compensation of axis {axis}, machine {machine}</source>
        <translation>機械 {machine}、軸 {axis} の補正</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>The accuracy A before is not defined.</source>
        <translation>補正前の正確さ A は未定義です。</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>Serial number of the drive</source>
        <translation>ドライブのシリアル番号</translation>
    </message>
    <message>
        <source>Firmware profile</source>
        <translation>ファームウェアプロファイル</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>before</source>
        <translation>補正前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>補正後</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>測定者</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>測定器</translation>
    </message>
    <message>
        <source>Feed, dwell</source>
        <translation>送り速度、ドウェル時間</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>環境</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>補正</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>測定値の補正</translation>
    </message>
    <message>
        <source>Targets and runs</source>
        <translation>目標位置と走行</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>air {air}, material {material}, expansion {expansion}</source>
        <translation>空気 {air}、材料 {material}、膨張係数 {expansion}</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on, which table is not stated</source>
        <translation>オン、テーブルの記載なし</translation>
    </message>
    <message>
        <source>on, table {crc}</source>
        <translation>オン、テーブル {crc}</translation>
    </message>
    <message>
        <source>to 20 °C by the instrument</source>
        <translation>20 °C に換算 (測定器による)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>none here, by the instrument not stated</source>
        <translation>ここではなし、測定器については記載なし</translation>
    </message>
    <message>
        <source>no targets: {kind}</source>
        <translation>目標位置なし: {kind}</translation>
    </message>
    <message>
        <source>{direction} target {target} run {run}</source>
        <translation>{direction} 目標位置 {target} 走行 {run}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>{count} values: not an evaluation by ISO 230-2</source>
        <translation>値 {count} 個: ISO 230-2 による評価ではありません</translation>
    </message>
    <message>
        <source>{values}: not an evaluation by ISO 230-2</source>
        <translation>{values}: ISO 230-2 による評価ではありません</translation>
    </message>
    <message>
        <source>Deviation over position: before, after, to one scale</source>
        <translation>位置に対する偏差: 補正前と補正後 (同一目盛)</translation>
    </message>
    <message>
        <source>Deviation over position, before</source>
        <translation>位置に対する偏差 (補正前)</translation>
    </message>
    <message>
        <source>Deviation over position, after</source>
        <translation>位置に対する偏差 (補正後)</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014 in {unit}</source>
        <translation>ISO 230-2:2014 の特性値 ({unit})</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>未使用点</translation>
    </message>
    <message>
        <source>Verdict on the measurement after</source>
        <translation>補正後の測定の判定</translation>
    </message>
    <message>
        <source>Verdict on the measurement before</source>
        <translation>補正前の測定の判定</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>不確かさ U、k = 2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>uncertainty U, k = 2</source>
        <translation>不確かさ U、k = 2</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>CRC-32</source>
        <translation>CRC-32</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>スロット</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>End-to-end proof</source>
        <translation>ドライブでの検証</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>{count} points from {from} to {to}</source>
        <translation>{from} から {to} までの {count} 点</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>不揮発</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>揮発</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>none on record</source>
        <translation>記録なし</translation>
    </message>
    <message numerus="yes">
        <source>and {count} more in the record</source>
        <comment>and 1 more in the record</comment>
        <translation>
            <numerusform>ほか {count} 件は記録を参照</numerusform>
        </translation>
    </message>
    <message>
        <source>Input files</source>
        <translation>入力ファイル</translation>
    </message>
    <message>
        <source>file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Made by Axis Compensation Wizard {version}. Figures that the values do not define are not defined; what is not on record is not stated.</source>
        <translation>Axis Compensation Wizard {version} で作成。値から求められない特性値は「未定義」、記録にない事項は「記載なし」としています。</translation>
    </message>
    <message>
        <source>Targets before, in {unit}</source>
        <translation>補正前の目標位置 ({unit})</translation>
    </message>
    <message>
        <source>Targets after, in {unit}</source>
        <translation>補正後の目標位置 ({unit})</translation>
    </message>
    <message>
        <source>target in {unit}</source>
        <translation>目標位置 ({unit})</translation>
    </message>
    <message>
        <source>values ↑</source>
        <translation>値 ↑</translation>
    </message>
    <message>
        <source>s ↑</source>
        <translation>s ↑</translation>
    </message>
    <message>
        <source>values ↓</source>
        <translation>値 ↓</translation>
    </message>
    <message>
        <source>s ↓</source>
        <translation>s ↓</translation>
    </message>
    <message>
        <source>Left out: {values}</source>
        <translation>除外: {values}</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>記載なし</translation>
    </message>
    <message>
        <source>The accuracy A is not defined, before or after.</source>
        <translation>正確さ A は補正前も補正後も未定義です。</translation>
    </message>
    <message>
        <source>{figure}: {before} before, {after} after.</source>
        <translation>{figure}: 補正前 {before}、補正後 {after}。</translation>
    </message>
    <message>
        <source>{method}, over position and temperature</source>
        <translation>{method}、位置と温度に対して</translation>
    </message>
    <message>
        <source>Each figure is the largest of a thermal state and of all runs together.</source>
        <translation>各特性値は、各熱状態と全走行一括のうち最大の値です。</translation>
    </message>
    <message>
        <source>air {air}, material {material}, values measured at {values}, expansion {expansion}</source>
        <translation>空気 {air}、材料 {material}、値の測定時 {values}、膨張係数 {expansion}</translation>
    </message>
    <message>
        <source>{from} to {to}</source>
        <translation>{from}～{to}</translation>
    </message>
    <message>
        <source>Warning: {warning}.</source>
        <translation>警告: {warning}。</translation>
    </message>
    <message>
        <source>up and down exchanged</source>
        <translation>正方向と負方向を入れ替え</translation>
    </message>
    <message>
        <source>reference taken with the opposite sign</source>
        <translation>基準の符号を反転して使用</translation>
    </message>
    <message>
        <source>unit of {what} taken as {stated}, the file says {unit}</source>
        <translation>{what} の単位は {stated} として使用 (ファイルの記載は {unit})</translation>
    </message>
    <message>
        <source>slope taken out for the table, not for figures</source>
        <translation>テーブルでは傾きを除去、特性値では除去しない</translation>
    </message>
    <message>
        <source>to {standard}, {conditions}: values changed by up to {largest}</source>
        <translation>{standard} に換算、{conditions}: 値の変化は最大 {largest}</translation>
    </message>
    <message>
        <source>scale at {temperature} with {expansion}</source>
        <translation>スケール {temperature} ({expansion})</translation>
    </message>
    <message>
        <source>reference at {temperature} with {expansion}</source>
        <translation>基準 {temperature} ({expansion})</translation>
    </message>
    <message>
        <source>datum at {position}</source>
        <translation>不動点 {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets from {from} to {to}</source>
        <comment>1 target from {from} to {to}</comment>
        <translation>
            <numerusform>目標位置 {count} か所 ({from} から {to})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} runs {direction}</source>
        <comment>1 run {direction}</comment>
        <translation>
            <numerusform>走行 {direction} {count} 回</numerusform>
        </translation>
    </message>
    <message>
        <source>means {direction}</source>
        <translation>平均値 {direction}</translation>
    </message>
    <message>
        <source>no means {direction}</source>
        <translation>平均値 {direction} なし</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions, the mean of both</source>
        <translation>位置に対する偏差: 各方向の平均、両方向の平均</translation>
    </message>
    <message>
        <source>on, table {crc}, as stated with the measurement</source>
        <translation>オン、テーブル {crc} (測定時の指定による)</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>that of each table, below</source>
        <translation>各テーブルの値は下記</translation>
    </message>
    <message>
        <source>{name} for axis {axis}, CRC-32 {crc}</source>
        <translation>{name} (軸 {axis})、CRC-32 {crc}</translation>
    </message>
    <message>
        <source>Compensation of axis {target} over axis {axis}, machine {machine}</source>
        <translation>軸 {axis} の位置による軸 {target} の補正、機械 {machine}</translation>
    </message>
    <message>
        <source>At the set position {position} of axis {axis} the drive adds {added} to what the encoder of axis {target} reads.</source>
        <translation>軸 {axis} の指令位置 {position} で、ドライブは軸 {target} のエンコーダの読みに {added} を加えます。</translation>
    </message>
    <message>
        <source>Where the encoder of axis {axis} reads {position}, the drive adds {added} to axis {target}.</source>
        <translation>軸 {axis} のエンコーダが {position} のとき、ドライブは軸 {target} に {added} を加えます。</translation>
    </message>
    <message>
        <source>values taken as positions of the reference, the file says deviations</source>
        <translation>値を基準の位置として読み取り(ファイルには偏差とある)</translation>
    </message>
    <message>
        <source>values taken as deviations, the file says positions of the reference</source>
        <translation>値を偏差として読み取り(ファイルには基準の位置とある)</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before, {after} after.</source>
        <translation>正確さ {figure}: 補正前 {before}、補正後 {after}。</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before. There is no measurement afterwards on record.</source>
        <translation>正確さ {figure}: 補正前 {before}。記録に補正後の測定はありません。</translation>
    </message>
    <message>
        <source>Held out: what is left at targets that the table was made without: {figure} {range}, rms {rms}, largest {largest}. Of the two predictions this is the one to believe.</source>
        <translation>未使用点: テーブルの作成に使わなかった目標位置に残る誤差。{figure} {range}、rms {rms}、最大 {largest}。2 つの予測のうち、信頼できるのはこちらです。</translation>
    </message>
    <message>
        <source>before, all values</source>
        <translation>補正前、全データ</translation>
    </message>
    <message>
        <source>after, all values</source>
        <translation>補正後、全データ</translation>
    </message>
    <message>
        <source>all values</source>
        <translation>全データ</translation>
    </message>
    <message>
        <source>verdict, all values</source>
        <translation>判定、全データ</translation>
    </message>
    <message>
        <source>Targets before, all values, in {unit}</source>
        <translation>補正前の目標位置、全データ ({unit})</translation>
    </message>
    <message>
        <source>Targets after, all values, in {unit}</source>
        <translation>補正後の目標位置、全データ ({unit})</translation>
    </message>
    <message>
        <source>{said} ({files})</source>
        <translation>{said} ({files})</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before, {after} after.</source>
        <translation>除外したデータも含む全データの正確さ {figure}: 補正前 {before}、補正後 {after}。</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before.</source>
        <translation>除外したデータも含む全データの正確さ {figure}: 補正前 {before}。</translation>
    </message>
</context>
<context>
    <name>RunValueText</name>
    <message>
        <source>%1, target %2, run %3, %4</source>
        <translation>%1、目標位置 %2、走行 %3、%4</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>除外の提案</translation>
    </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>counts per unit</source>
        <translation>単位あたりのカウント数</translation>
    </message>
    <message>
        <source>position unit</source>
        <translation>位置の単位</translation>
    </message>
    <message>
        <source>value unit</source>
        <translation>値の単位</translation>
    </message>
    <message>
        <source>wrap range</source>
        <translation>1 周の範囲</translation>
    </message>
    <message>
        <source>master axis</source>
        <translation>マスタ軸</translation>
    </message>
    <message>
        <source>master1 axis</source>
        <translation>マスタ軸 1</translation>
    </message>
    <message>
        <source>master2 axis</source>
        <translation>マスタ軸 2</translation>
    </message>
    <message>
        <source>n cycles</source>
        <translation>サイクル数</translation>
    </message>
    <message>
        <source>master kind</source>
        <translation>マスタ軸の種類</translation>
    </message>
    <message>
        <source>master1 kind</source>
        <translation>マスタ軸 1 の種類</translation>
    </message>
    <message>
        <source>master2 kind</source>
        <translation>マスタ軸 2 の種類</translation>
    </message>
    <message>
        <source>axis kind</source>
        <translation>軸の種類</translation>
    </message>
    <message>
        <source>modulo</source>
        <translation>モジュロ</translation>
    </message>
    <message>
        <source>modulo1</source>
        <translation>モジュロ 1</translation>
    </message>
    <message>
        <source>modulo2</source>
        <translation>モジュロ 2</translation>
    </message>
    <message>
        <source>list unit</source>
        <translation>リストの単位</translation>
    </message>
    <message>
        <source>increments per unit</source>
        <translation>単位あたりのインクリメント数</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>小数</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>type</source>
        <translation>ファイルの種類</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>first table</source>
        <translation>最初のテーブル</translation>
    </message>
    <message>
        <source>input axis</source>
        <translation>入力軸</translation>
    </message>
    <message>
        <source>output axis</source>
        <translation>出力軸</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>測定系</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>不揮発</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>メートル系</translation>
    </message>
    <message>
        <source>increments</source>
        <translation>インクリメント</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>直進</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>rotary axes</source>
        <translation>回転軸</translation>
    </message>
    <message>
        <source>primary unit</source>
        <translation>PRIMARY の単位</translation>
    </message>
    <message>
        <source>units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>primary</source>
        <translation>primary</translation>
    </message>
    <message>
        <source>column axis</source>
        <translation>列軸</translation>
    </message>
    <message>
        <source>row axis</source>
        <translation>行軸</translation>
    </message>
    <message>
        <source>output axis 1</source>
        <translation>出力軸 1</translation>
    </message>
    <message>
        <source>output axis 2</source>
        <translation>出力軸 2</translation>
    </message>
    <message>
        <source>output axis 3</source>
        <translation>出力軸 3</translation>
    </message>
    <message>
        <source>source counts per unit</source>
        <translation>ソースの単位あたりのカウント数</translation>
    </message>
    <message>
        <source>target counts per unit</source>
        <translation>対象の単位あたりのカウント数</translation>
    </message>
    <message>
        <source>column counts per unit</source>
        <translation>列の単位あたりのカウント数</translation>
    </message>
    <message>
        <source>source motor</source>
        <translation>ソースモータ</translation>
    </message>
    <message>
        <source>target motor</source>
        <translation>対象モータ</translation>
    </message>
    <message>
        <source>row motor</source>
        <translation>行モータ</translation>
    </message>
    <message>
        <source>column motor</source>
        <translation>列モータ</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>指令位置</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>実位置</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>source axis 1</source>
        <translation>ソース軸 1</translation>
    </message>
    <message>
        <source>source axis 2</source>
        <translation>ソース軸 2</translation>
    </message>
    <message>
        <source>zone</source>
        <translation>ゾーン</translation>
    </message>
    <message>
        <source>declare</source>
        <translation>宣言</translation>
    </message>
    <message>
        <source>form</source>
        <translation>書式</translation>
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
        <translation>任意の間隔</translation>
    </message>
    <message>
        <source>reference number</source>
        <translation>原点の番号</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>detection unit</source>
        <translation>検出単位</translation>
    </message>
    <message>
        <source>magnification</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>reference position</source>
        <translation>原点の位置</translation>
    </message>
    <message>
        <source>first number</source>
        <translation>最初の番号</translation>
    </message>
    <message>
        <source>last number</source>
        <translation>最後の番号</translation>
    </message>
    <message>
        <source>first record</source>
        <translation>最初の行</translation>
    </message>
    <message>
        <source>largest step</source>
        <translation>最大の値</translation>
    </message>
    <message>
        <source>secondary unit</source>
        <translation>SECONDARY の単位</translation>
    </message>
    <message>
        <source>target axis</source>
        <translation>コントローラの対象軸</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>planning</source>
        <translation>計画作成</translation>
    </message>
    <message>
        <source>backing up the old state</source>
        <translation>旧状態のバックアップ</translation>
    </message>
    <message>
        <source>checking for changes since the plan</source>
        <translation>計画後の変更の確認</translation>
    </message>
    <message>
        <source>detaching the table from the axis</source>
        <translation>軸からのテーブルの切り離し</translation>
    </message>
    <message>
        <source>uploading the table</source>
        <translation>テーブルのアップロード</translation>
    </message>
    <message>
        <source>verifying the table</source>
        <translation>テーブルの照合</translation>
    </message>
    <message>
        <source>storing the table in flash</source>
        <translation>テーブルのフラッシュ保存</translation>
    </message>
    <message>
        <source>switching the axis over</source>
        <translation>軸の切り替え</translation>
    </message>
    <message>
        <source>saving the parameters</source>
        <translation>パラメータの保存</translation>
    </message>
    <message>
        <source>reading back</source>
        <translation>読み戻し</translation>
    </message>
    <message>
        <source>rolling back</source>
        <translation>ロールバック</translation>
    </message>
    <message>
        <source>reading the table</source>
        <translation>テーブルの読み取り</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>テーブルの削除</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Axis %1</source>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>Dim %1</source>
        <translation>Dim %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 点</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between items of a list</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>.</source>
        <comment>ends a sentence</comment>
        <translation>。</translation>
    </message>
</context>
<context>
    <name>axiscomp::app::WizardWindow</name>
    <message>
        <source>[*]Axis Compensation Wizard</source>
        <translation>[*]軸補正ウィザード</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionPanel</name>
    <message>
        <source>&amp;Write Compensation</source>
        <translation>補正の書き込み(&amp;W)</translation>
    </message>
    <message>
        <source>Re&amp;vert All</source>
        <translation>すべて戻す(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Activate</source>
        <translation>有効化(&amp;A)</translation>
    </message>
    <message>
        <source>More actions</source>
        <translation>その他の操作</translation>
    </message>
    <message>
        <source>D&amp;eactivate</source>
        <translation>無効化(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Evaluate (Adds Nothing)</source>
        <translation>試算 (加算なし)(&amp;E)</translation>
    </message>
    <message>
        <source>Restore &amp;Previous Table…</source>
        <translation>前のテーブルを復元(&amp;P)…</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>次の手順</translation>
    </message>
    <message>
        <source>Writes table and settings to the drive and verifies them (Ctrl+Return)</source>
        <translation>テーブルと設定をドライブに書き込み、照合します (Ctrl+Enter)</translation>
    </message>
    <message>
        <source>Resets all fields to the drive&apos;s values (Ctrl+Shift+R)</source>
        <translation>すべての欄をドライブの値に戻します (Ctrl+Shift+R)</translation>
    </message>
    <message>
        <source>Switches the compensation on, then compares the drive&apos;s output with the table</source>
        <translation>補正をオンにし、ドライブの出力をテーブルと比較します</translation>
    </message>
    <message>
        <source>Switches the compensation off</source>
        <translation>補正をオフにします</translation>
    </message>
    <message>
        <source>The drive looks up the table and shows the indices, but adds nothing</source>
        <translation>ドライブはテーブルを参照してインデックスを表示しますが、何も加算しません</translation>
    </message>
    <message>
        <source>Writes back the table and settings from before the last write</source>
        <translation>前回の書き込み前のテーブルと設定を書き戻します</translation>
    </message>
    <message>
        <source>Continue in the preview on the right</source>
        <translation>右のプレビューで続行してください</translation>
    </message>
    <message>
        <source>&amp;Delete Table…</source>
        <translation>テーブルを削除(&amp;D)…</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive and frees its slot</source>
        <translation>軸のテーブルをドライブから削除し、スロットを解放します</translation>
    </message>
    <message>
        <source>Evaluate, restore a backup, or delete the table</source>
        <translation>試算、バックアップの復元、テーブルの削除</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>バックアップを復元(&amp;B)…</translation>
    </message>
    <message>
        <source>Shows the backups of this drive and restores the one you choose</source>
        <translation>このドライブのバックアップを表示し、選んだものを復元します</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionRules</name>
    <message>
        <source>No drive is connected: add a connection first.</source>
        <translation>接続しているドライブがありません。先に接続を追加してください。</translation>
    </message>
    <message>
        <source>Reading the axes of the drives.</source>
        <translation>ドライブの軸を読み取り中です。</translation>
    </message>
    <message>
        <source>Choose an axis first.</source>
        <translation>先に軸を選んでください。</translation>
    </message>
    <message>
        <source>The drive is not connected.</source>
        <translation>ドライブが接続されていません。</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>この軸には補正レジスタがありません。</translation>
    </message>
    <message>
        <source>Please wait: %1.</source>
        <translation>お待ちください: %1。</translation>
    </message>
    <message>
        <source>The axis is being read.</source>
        <translation>軸を読み取り中です。</translation>
    </message>
    <message>
        <source>The compensation is active: deactivate it first.</source>
        <translation>補正が有効です。先に無効化してください。</translation>
    </message>
    <message>
        <source>No table is chosen: open compensation data.</source>
        <translation>テーブルが選ばれていません。補正データを開いてください。</translation>
    </message>
    <message>
        <source>The table has 1 dimension, but %1D is chosen.</source>
        <translation>テーブルは 1 次元ですが、%1D が選ばれています。</translation>
    </message>
    <message>
        <source>The table has %1 dimensions, but %2D is chosen.</source>
        <translation>テーブルは %1 次元ですが、%2D が選ばれています。</translation>
    </message>
    <message>
        <source>A source is being checked.</source>
        <translation>ソースを確認中です。</translation>
    </message>
    <message>
        <source>Dim%1 Source is missing.</source>
        <translation>Dim%1 ソースがありません。</translation>
    </message>
    <message>
        <source>Dim%1 Source is the same as another source.</source>
        <translation>Dim%1 ソースがほかのソースと同じです。</translation>
    </message>
    <message>
        <source>The table needs %1 bytes, but the largest slot has %2.</source>
        <translation>テーブルには %1 バイト必要ですが、最大のスロットは %2 です。</translation>
    </message>
    <message>
        <source>To spare the flash, wait %1 or write volatile.</source>
        <translation>フラッシュを保護するため、%1 待つか、揮発で書き込んでください。</translation>
    </message>
    <message>
        <source>Nothing has changed.</source>
        <translation>変更はありません。</translation>
    </message>
    <message>
        <source>The file is being read.</source>
        <translation>ファイルを読み取り中です。</translation>
    </message>
    <message>
        <source>The parameters still have to be saved.</source>
        <translation>まだパラメータを保存する必要があります。</translation>
    </message>
    <message>
        <source>The axis has no table on the drive: write one first.</source>
        <translation>ドライブに軸のテーブルがありません。先に書き込んでください。</translation>
    </message>
    <message>
        <source>An earlier write left the axis in neither the old nor the new state: write again or restore the previous state.</source>
        <translation>以前の書き込みで、軸が旧状態でも新状態でもない状態です。もう一度書き込むか、前の状態を復元してください。</translation>
    </message>
    <message>
        <source>The compensation is already active.</source>
        <translation>補正はすでに有効です。</translation>
    </message>
    <message>
        <source>The axis must be homed first.</source>
        <translation>先に軸を原点復帰させてください。</translation>
    </message>
    <message>
        <source>The compensation is already being evaluated.</source>
        <translation>補正はすでに試算中です。</translation>
    </message>
    <message>
        <source>The compensation is not active.</source>
        <translation>補正は有効ではありません。</translation>
    </message>
    <message>
        <source>This axis has no backup yet; every write makes one.</source>
        <translation>この軸のバックアップはまだありません。書き込みのたびに作成されます。</translation>
    </message>
    <message>
        <source>Nothing is running.</source>
        <translation>実行中の処理はありません。</translation>
    </message>
    <message>
        <source>It is already being stopped.</source>
        <translation>すでに停止処理中です。</translation>
    </message>
    <message>
        <source>Finishes an earlier write: saves the parameters of the drive.</source>
        <translation>以前の書き込みを完了します: ドライブのパラメータを保存します。</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash; uses %1 of the %2 flash operations available now.</source>
        <translation>ドライブに書き込み、フラッシュに保存します。現在可能なフラッシュ操作 %2 回のうち %1 回を使います。</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash.</source>
        <translation>ドライブに書き込み、フラッシュに保存します。</translation>
    </message>
    <message>
        <source>Writes to the drive and saves its parameters; the table in flash stays.</source>
        <translation>ドライブに書き込み、パラメータを保存します。フラッシュのテーブルは変わりません。</translation>
    </message>
    <message>
        <source>Writes to the drive; a reboot of the drive restores the stored state.</source>
        <translation>ドライブに書き込みます。ドライブを再起動すると、保存されている状態に戻ります。</translation>
    </message>
    <message>
        <source>Adds the table to the encoder position and proves that the drive&apos;s output matches the table.</source>
        <translation>テーブルをエンコーダ位置に加算し、ドライブの出力がテーブルと一致することを検証します。</translation>
    </message>
    <message>
        <source>The drive looks up the table without adding anything.</source>
        <translation>ドライブはテーブルを参照しますが、何も加算しません。</translation>
    </message>
    <message>
        <source>Switches the compensation off; table and settings stay on the drive.</source>
        <translation>補正をオフにします。テーブルと設定はドライブに残ります。</translation>
    </message>
    <message>
        <source>Resets the fields to the drive&apos;s values.</source>
        <translation>各欄をドライブの値に戻します。</translation>
    </message>
    <message>
        <source>Writes back the previous table and sources.</source>
        <translation>前のテーブルとソースを書き戻します。</translation>
    </message>
    <message>
        <source>Searches for drives and axes again and reads the axis.</source>
        <translation>ドライブと軸を検索し直し、軸を読み取ります。</translation>
    </message>
    <message>
        <source>Opens a file of compensation data, .csv or .TAMtbl.</source>
        <translation>補正データのファイル (.csv または .TAMtbl) を開きます。</translation>
    </message>
    <message>
        <source>Stops reading the file.</source>
        <translation>ファイルの読み取りを中止します。</translation>
    </message>
    <message>
        <source>Stops the write and rolls back.</source>
        <translation>書き込みを中止し、ロールバックします。</translation>
    </message>
    <message>
        <source>Stops what is running.</source>
        <translation>実行中の処理を中止します。</translation>
    </message>
    <message>
        <source>%1 ...</source>
        <translation>%1 ...</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: its parameters may not be saved. Write to finish it.</source>
        <translation>以前の書き込みが中断されています。パラメータが保存されていない可能性があります。書き込みを行うと完了します。</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>補正は有効です。</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>補正は試算中です。ドライブは何も加算しません。</translation>
    </message>
    <message>
        <source>This axis has no unfinished write.</source>
        <translation>この軸に未完了の書き込みはありません。</translation>
    </message>
    <message>
        <source>Completes the interrupted write.</source>
        <translation>中断された書き込みを完了します。</translation>
    </message>
    <message>
        <source>Restores the state before the interrupted write.</source>
        <translation>中断された書き込みの前の状態に戻します。</translation>
    </message>
    <message>
        <source>Open a file with several columns of values first.</source>
        <translation>先に、値の列が複数あるファイルを開いてください。</translation>
    </message>
    <message>
        <source>The drive has no second axis with compensation registers.</source>
        <translation>ドライブに、補正レジスタのある軸がほかにありません。</translation>
    </message>
    <message>
        <source>Writes several columns of the open file, each to its own axis.</source>
        <translation>開いているファイルの複数の列を、それぞれの軸に書き込みます。</translation>
    </message>
    <message>
        <source>planning</source>
        <translation>計画作成</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>書き込み</translation>
    </message>
    <message>
        <source>writing several axes</source>
        <translation>複数軸の書き込み</translation>
    </message>
    <message>
        <source>activating</source>
        <translation>有効化</translation>
    </message>
    <message>
        <source>evaluating</source>
        <translation>試算</translation>
    </message>
    <message>
        <source>deactivating</source>
        <translation>無効化</translation>
    </message>
    <message>
        <source>finishing the write</source>
        <translation>書き込みの完了</translation>
    </message>
    <message>
        <source>undoing the write</source>
        <translation>書き込みの取り消し</translation>
    </message>
    <message>
        <source>restoring</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>The record of this drive&apos;s flash operations was damaged, so all of them count as used up. Write volatile, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>このドライブのフラッシュ操作の履歴が破損していたため、すべて使い切ったものとみなしています。揮発で書き込むか、「axiscomp status --reset-flash-count」を実行してください。</translation>
    </message>
    <message>
        <source>The axis has no table on the drive.</source>
        <translation>ドライブに軸のテーブルがありません。</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive; a backup is kept.</source>
        <translation>軸のテーブルをドライブから削除します。バックアップは残ります。</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>テーブルの削除</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: finish or undo it first.</source>
        <translation>以前の書き込みが中断されています。先に完了するか、取り消してください。</translation>
    </message>
    <message>
        <source>Writes the table and source parameters of a TAM configuration to the drive.</source>
        <translation>TAM 構成のテーブルとソースのパラメータをドライブに書き込みます。</translation>
    </message>
    <message>
        <source>Puts the drive&apos;s table and source parameters into a TAM configuration.</source>
        <translation>ドライブのテーブルとソースのパラメータを TAM 構成に書き出します。</translation>
    </message>
    <message>
        <source>importing parameters</source>
        <translation>パラメータのインポート</translation>
    </message>
    <message>
        <source>Writes back a backup that you choose.</source>
        <translation>選んだバックアップを書き戻します。</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up. Keep the table persistent, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>フラッシュからのテーブルの削除もフラッシュ操作です。このドライブのフラッシュ操作の履歴が破損していたため、すべて使い切ったものとみなしています。テーブルを不揮発のままにするか、「axiscomp status --reset-flash-count」を実行してください。</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too: wait %1, or keep the table persistent.</source>
        <translation>フラッシュからのテーブルの削除もフラッシュ操作です。%1 待つか、テーブルを不揮発のままにしてください。</translation>
    </message>
    <message>
        <source>Removes the table from flash, which uses %1 of the %2 flash operations available now.</source>
        <translation>フラッシュからテーブルを削除します。現在可能なフラッシュ操作 %2 回のうち %1 回を使います。</translation>
    </message>
    <message>
        <source>Writes to the drive and removes the table from flash.</source>
        <translation>ドライブに書き込み、フラッシュからテーブルを削除します。</translation>
    </message>
    <message>
        <source>Saves the tables and sources of all axes of the drive to a file.</source>
        <translation>ドライブの全軸のテーブルとソースをファイルに保存します。</translation>
    </message>
    <message>
        <source>Writes a backup of the whole drive back to it, axis by axis.</source>
        <translation>ドライブ全体のバックアップを 1 軸ずつ書き戻します。</translation>
    </message>
    <message>
        <source>backing up the drive</source>
        <translation>ドライブのバックアップ</translation>
    </message>
    <message>
        <source>restoring the drive</source>
        <translation>ドライブの復元</translation>
    </message>
    <message>
        <source>What an earlier write left is not known: write again or restore another backup.</source>
        <translation>以前の書き込みで軸がどの状態になったかは不明です。もう一度書き込むか、別のバックアップを復元してください。</translation>
    </message>
    <message>
        <source>An earlier write was interrupted, and the backup of the state before it cannot be read: write again or restore another backup first.</source>
        <translation>以前の書き込みが中断されており、その前の状態のバックアップを読み取れません。先にもう一度書き込むか、別のバックアップを復元してください。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ApplyMachineDialog</name>
    <message>
        <source>Apply Machine File</source>
        <translation>機械ファイルの適用</translation>
    </message>
    <message>
        <source>What %1 says is written to all drives that differ from it, or to none. Each axis is backed up first, verified, and put back when its write fails.</source>
        <translation>%1 の内容を、それと異なるすべてのドライブに書き込みます。一部だけに書き込むことはありません。各軸はまずバックアップし、照合し、書き込みに失敗した場合は元に戻します。</translation>
    </message>
    <message>
        <source>Also &amp;switch compensations on and off where the file says so</source>
        <translation>ファイルの指定に従い、補正のオン/オフも切り替える(&amp;S)</translation>
    </message>
    <message>
        <source>Leave &amp;out drives that do not answer</source>
        <translation>応答しないドライブを除く(&amp;O)</translation>
    </message>
    <message>
        <source>Otherwise nothing is written while one does not answer</source>
        <translation>選択しない場合、応答しないドライブがある間は何も書き込みません</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>機械ファイル</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>書き込む内容</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>適用(&amp;A)</translation>
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
        <translation>このドライブは接続から外れています。</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>It holds</source>
        <translation>現在の内容</translation>
    </message>
    <message>
        <source>What has become of each axis</source>
        <translation>各軸の結果</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>待機中</translation>
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
        <translation>フラッシュ操作を使いません。</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>フラッシュ操作の合計: %1。</translation>
    </message>
    <message>
        <source>Stopping: each drive ends where it is safe …</source>
        <translation>停止処理中: 各ドライブは安全な所で停止します …</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>書き込み中 …</translation>
    </message>
    <message>
        <source>Write these to the drives now</source>
        <translation>これらを今すぐドライブに書き込みます</translation>
    </message>
    <message>
        <source>Stops the writes; those under way are rolled back (Esc)</source>
        <translation>書き込みを中止します。実行中のものはロールバックします (Esc)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and proof</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tries to prove each axis that it switches on, and names those of which nothing is proved; without it the file&apos;s “active” is only compared</source>
        <translation>オンにした各軸の検証を試み、検証できなかった軸を示します。選択しない場合、ファイルの「active」は比較するだけです</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisList</name>
    <message>
        <source>The drive %1 is not connected.</source>
        <translation>ドライブ %1 が接続されていません。</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>この軸には補正レジスタがありません。</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source> (no compensation)</source>
        <translation> (補正なし)</translation>
    </message>
    <message>
        <source> (demo)</source>
        <translation> (デモ)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisState</name>
    <message>
        <source>Compensation: %1.</source>
        <translation>補正: %1。</translation>
    </message>
    <message>
        <source>Homing: %1.</source>
        <translation>原点復帰: %1。</translation>
    </message>
    <message>
        <source>The compensation is in error: %1.</source>
        <translation>補正がエラー状態です: %1。</translation>
    </message>
    <message>
        <source>The drive is in error: %1.</source>
        <translation>ドライブがエラー状態です: %1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::BackupDialog</name>
    <message>
        <source>damaged</source>
        <comment>backup</comment>
        <translation>破損</translation>
    </message>
    <message>
        <source>last write</source>
        <comment>what was done after the backup</comment>
        <translation>最後の書き込み</translation>
    </message>
    <message>
        <source>new table</source>
        <comment>what was done after the backup</comment>
        <translation>新しいテーブル</translation>
    </message>
    <message>
        <source>table deleted</source>
        <comment>what was done after the backup</comment>
        <translation>テーブルの削除</translation>
    </message>
    <message>
        <source>settings changed</source>
        <comment>what was done after the backup</comment>
        <translation>設定の変更</translation>
    </message>
    <message>
        <source>undone, or nothing changed</source>
        <comment>what was done after the backup</comment>
        <translation>取り消し、または変更なし</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>なし</translation>
    </message>
    <message>
        <source>Restore Backup</source>
        <translation>バックアップの復元</translation>
    </message>
    <message>
        <source>Before each write this computer keeps what the axis had. Choose what %1 shall have again; the preview shows what that changes before anything is written.</source>
        <translation>このコンピュータは、書き込みのたびに軸の直前の状態を保存しています。%1 に復元する状態を選んでください。書き込む前に、変更内容をプレビューに表示します。</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>操作前</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>バックアップ (新しい順)</translation>
    </message>
    <message>
        <source>Restore the backup of an&amp;other drive to this one</source>
        <translation>別のドライブのバックアップをこのドライブに復元する(&amp;O)</translation>
    </message>
    <message>
        <source>Open Backup &amp;File…</source>
        <translation>バックアップファイルを開く(&amp;F)…</translation>
    </message>
    <message>
        <source>Choose from a file that is kept elsewhere, such as one of a drive that was replaced</source>
        <translation>別の場所にあるファイル (交換したドライブのものなど) から選びます</translation>
    </message>
    <message>
        <source>&amp;Restore…</source>
        <translation>復元(&amp;R)…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Open Backup File</source>
        <translation>バックアップファイルを開く</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>バックアップ (*.json)</translation>
    </message>
    <message>
        <source>%1, drive %2</source>
        <comment>axis and serial number</comment>
        <translation>%1、ドライブ %2</translation>
    </message>
    <message>
        <source>This backup is damaged: %1</source>
        <translation>このバックアップは破損しています: %1</translation>
    </message>
    <message>
        <source>This backup is of the drive with the serial number %1; this one is %2.</source>
        <translation>このバックアップはシリアル番号 %1 のドライブのものです。このドライブは %2 です。</translation>
    </message>
    <message>
        <source>Table of the backup</source>
        <translation>バックアップのテーブル</translation>
    </message>
    <message>
        <source>There is no backup of this drive on this computer.</source>
        <translation>このコンピュータに、このドライブのバックアップはありません。</translation>
    </message>
    <message>
        <source>The backups are being read.</source>
        <translation>バックアップを読み取り中です。</translation>
    </message>
    <message>
        <source>A damaged backup cannot be restored.</source>
        <translation>破損したバックアップは復元できません。</translation>
    </message>
    <message>
        <source>Confirm first that the backup of another drive is meant.</source>
        <translation>先に、別のドライブのバックアップでよいことを確認してください。</translation>
    </message>
    <message>
        <source>Show what restoring this backup would change</source>
        <translation>このバックアップの復元による変更内容を表示します</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CaptureDialog</name>
    <message>
        <source>Capture Values</source>
        <translation>測定値の取り込み</translation>
    </message>
    <message>
        <source>a register of the drive</source>
        <translation>ドライブのレジスタ</translation>
    </message>
    <message>
        <source>an instrument on a serial port</source>
        <translation>シリアルポートの測定器</translation>
    </message>
    <message>
        <source>typed by hand</source>
        <translation>手入力</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>選択(&amp;C)…</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>選択(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>開始(&amp;B)</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>キャンセル(&amp;L)</translation>
    </message>
    <message>
        <source>Take nothing and go back (Esc)</source>
        <translation>何も取り込まずに戻ります (Esc)</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>The current one; something else moves it</source>
        <translation>現在の軸。動かすのはこのプログラム以外です</translation>
    </message>
    <message>
        <source>Pla&amp;n</source>
        <translation>測定計画(&amp;N)</translation>
    </message>
    <message>
        <source>As New Program saves it</source>
        <translation>[新規プログラム] で保存したもの</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>基準(&amp;R)</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>基準の位置の取得元</translation>
    </message>
    <message>
        <source>Re&amp;gister</source>
        <translation>レジスタ(&amp;G)</translation>
    </message>
    <message>
        <source>Which says where the axis really is: chosen from the list, or a path, URI or address</source>
        <translation>軸の実際の位置を示すレジスタ。リストから選ぶか、パス、URI またはアドレスを入力します</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>ポート(&amp;P)</translation>
    </message>
    <message>
        <source>Of the instrument, with its speed</source>
        <translation>測定器のポートと通信速度</translation>
    </message>
    <message>
        <source>Re&amp;quest</source>
        <translation>要求(&amp;Q)</translation>
    </message>
    <message>
        <source>Sent before each reading, with \r and \n for line ends; empty: the instrument sends by itself</source>
        <translation>読み取りのたびに送信します。行末は \r と \n で表します。空欄: 測定器が自動的に送信</translation>
    </message>
    <message>
        <source>Pa&amp;ttern</source>
        <translation>パターン(&amp;T)</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line; empty: the first number of the line</source>
        <translation>行の中の数値を示す正規表現。空欄: 行の最初の数値</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>単位(&amp;U)</translation>
    </message>
    <message>
        <source>Of the numbers of the instrument</source>
        <translation>測定器の数値の単位</translation>
    </message>
    <message>
        <source>&amp;Zero at</source>
        <translation>ゼロ点(&amp;Z)</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0</source>
        <translation>測定器が 0 を示す軸の位置</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>静止判定幅(&amp;W)</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within this, and readings may differ by as much</source>
        <translation>エンコーダの変動がこの幅以内なら静止とみなします。読み値の差もこの幅まで許容します</translation>
    </message>
    <message>
        <source>&amp;Dwell</source>
        <translation>ドウェル時間(&amp;D)</translation>
    </message>
    <message>
        <source>So long the axis must have stood before its value is taken</source>
        <translation>値を取り込む前に、軸がこの時間静止している必要があります</translation>
    </message>
    <message>
        <source>&amp;Average of</source>
        <translation>平均回数(&amp;A)</translation>
    </message>
    <message>
        <source>Readings that make a value</source>
        <translation>1 つの値を求める読み値の数</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>値(&amp;V)</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>値のファイル。既存のファイルは続きから追記します</translation>
    </message>
    <message>
        <source>The instrument counts the &amp;other way</source>
        <translation>測定器の計数方向が逆(&amp;O)</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>軸が正方向に動くと値が減る測定器の場合</translation>
    </message>
    <message>
        <source>Choose the plan</source>
        <translation>測定計画を選びます</translation>
    </message>
    <message>
        <source>Choose the file of the values</source>
        <translation>値のファイルを選びます</translation>
    </message>
    <message>
        <source> readings</source>
        <translation> 回</translation>
    </message>
    <message>
        <source>Choose Plan</source>
        <translation>測定計画の選択</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>測定計画 (*.csv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>File of the Values</source>
        <translation>値のファイル</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>走行データ (*.csv)</translation>
    </message>
    <message>
        <source>that of the axis</source>
        <translation>軸の単位</translation>
    </message>
    <message>
        <source>as the instrument says</source>
        <translation>測定器の出力どおり</translation>
    </message>
    <message>
        <source>that of the plan</source>
        <translation>測定計画の単位</translation>
    </message>
    <message>
        <source>The drive does not answer.</source>
        <translation>ドライブが応答しません。</translation>
    </message>
    <message>
        <source>Wait until the drive is free.</source>
        <translation>ドライブの処理が終わるまで待ってください。</translation>
    </message>
    <message>
        <source>The plan is being read …</source>
        <translation>測定計画を読み取り中 …</translation>
    </message>
    <message>
        <source>Choose a plan; New Program makes one.</source>
        <translation>測定計画を選んでください。[新規プログラム] で作成できます。</translation>
    </message>
    <message>
        <source>Choose the register of the reference.</source>
        <translation>基準のレジスタを選んでください。</translation>
    </message>
    <message>
        <source>Name the port of the instrument, such as serial:/dev/ttyUSB1?baud=9600.</source>
        <translation>serial:/dev/ttyUSB1?baud=9600 のように、測定器のポートを入力してください。</translation>
    </message>
    <message>
        <source>Choose the file of the values.</source>
        <translation>値のファイルを選んでください。</translation>
    </message>
    <message>
        <source>the plan just made (%1)</source>
        <translation>今作成した測定計画 (%1)</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>ドライブを読み取り中 …</translation>
    </message>
    <message>
        <source>Values are taken while the control of the machine, or a person, moves the axis. This program never moves it.</source>
        <translation>NC 装置または人が軸を動かす間に値を取り込みます。このプログラムが軸を動かすことはありません。</translation>
    </message>
    <message>
        <source>Read axis and instrument, and take values</source>
        <translation>軸と測定器を読み取り、値を取り込みます</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CapturePanel</name>
    <message>
        <source>Encoder</source>
        <translation>エンコーダ</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Reference - axis</source>
        <translation>基準 − 軸</translation>
    </message>
    <message>
        <source>The reference minus where the axis is: its encoder and what the drive adds</source>
        <translation>基準から軸の位置 (エンコーダとドライブの加算量の和) を引いた値</translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation>測定計画のステップ</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>取り込む(&amp;K)</translation>
    </message>
    <message>
        <source>Undo Las&amp;t</source>
        <translation>直前を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Stop Capturin&amp;g</source>
        <translation>取り込みを終了(&amp;G)</translation>
    </message>
    <message>
        <source>%1: values to %2</source>
        <translation>%1: 値を %2 に保存</translation>
    </message>
    <message>
        <source>T&amp;he instrument says [%1]</source>
        <translation>測定器の読み値 [%1](&amp;H)</translation>
    </message>
    <message>
        <source>What the instrument says, in %1</source>
        <translation>測定器の読み値 (%1)</translation>
    </message>
    <message>
        <source>Nothing is being taken</source>
        <translation>取り込みを行っていません</translation>
    </message>
    <message>
        <source>The drive does not answer</source>
        <translation>ドライブが応答しません</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>再開(&amp;E)</translation>
    </message>
    <message>
        <source>Paus&amp;e</source>
        <translation>一時停止(&amp;E)</translation>
    </message>
    <message>
        <source>Take what was typed for the step that is due (Enter or space bar)</source>
        <translation>入力した値を次のステップの値として取り込みます (Enter またはスペース)</translation>
    </message>
    <message>
        <source>A position is asked for as soon as the axis stands at the target that is due</source>
        <translation>軸が次の目標位置で静止すると、位置の入力を求めます</translation>
    </message>
    <message>
        <source>No value has been taken yet</source>
        <translation>まだ値を取り込んでいません</translation>
    </message>
    <message>
        <source>Take the last value off the file; its step is due again</source>
        <translation>最後の値をファイルから取り除き、そのステップからやり直します</translation>
    </message>
    <message>
        <source>Go on; the axis has to come to its target once more</source>
        <translation>取り込みを続けます。軸をもう一度目標位置に動かす必要があります</translation>
    </message>
    <message>
        <source>Take nothing until Resume, such as while somebody works at the machine</source>
        <translation>[再開] まで何も取り込みません。機械で作業している間などに使います</translation>
    </message>
    <message>
        <source>End here; what was taken stays in the file, and Capture goes on behind it with the same plan</source>
        <translation>ここで終了します。取り込んだ値はファイルに残り、同じ測定計画で [測定値の取り込み] を行うと続きから再開します</translation>
    </message>
    <message>
        <source>The drive does not say the unit of the axis: it is taken to be that of the plan.</source>
        <translation>ドライブに軸の単位が示されていません。測定計画の単位とみなします。</translation>
    </message>
    <message>
        <source>The clock of this computer is behind the last value of the file: times go on from there.</source>
        <translation>このコンピュータの時計がファイルの最後の値より遅れています。時刻はその続きから進めます。</translation>
    </message>
    <message>
        <source>The reference is a Single: at %1 its numbers are %2 apart.</source>
        <translation>基準が Single です。%1 では数値の分解能が %2 になります。</translation>
    </message>
    <message>
        <source>The instrument is far from the axis, as if it said 0 at %1: if that is right, begin a new file with this as the zero.</source>
        <translation>測定器の値が軸から大きく離れていて、%1 で 0 を示すことになります。それで正しい場合は、これをゼロ点として新しいファイルを始めてください。</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, upwards from %3.</source>
        <translation>次はステップ %1: %2、%3 から正方向に近づきます。</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, downwards from %3.</source>
        <translation>次はステップ %1: %2、%3 から負方向に近づきます。</translation>
    </message>
    <message>
        <source>The axis stands at step %1: %2 of %3 readings.</source>
        <translation>軸はステップ %1 で静止しています: 読み値 %2/%3。</translation>
    </message>
    <message>
        <source>The axis stands; it is waited until it has come to rest.</source>
        <translation>軸は停止しています。完全に静止するまで待っています。</translation>
    </message>
    <message>
        <source>The axis stands at step %1: read the instrument, and type what it says.</source>
        <translation>軸はステップ %1 で静止しています。測定器を読み取り、その値を入力してください。</translation>
    </message>
    <message>
        <source>Taken. %1</source>
        <translation>取り込みました。%1</translation>
    </message>
    <message>
        <source>The axis moves. %1</source>
        <translation>軸が動いています。%1</translation>
    </message>
    <message>
        <source>%1 of %2 values are in %3.</source>
        <translation>%3 に %2 個中 %1 個の値があります。</translation>
    </message>
    <message>
        <source>Every step has its value: %1 values are in %2.</source>
        <translation>すべてのステップの値がそろいました。%2 に %1 個の値があります。</translation>
    </message>
    <message>
        <source>Stopped. %1 Capture goes on behind them with the same plan and file.</source>
        <translation>終了しました。%1 同じ測定計画とファイルで [測定値の取り込み] を行うと、続きから再開します。</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>ドライブを読み取り中 …</translation>
    </message>
    <message>
        <source>Nothing is taken: %1 It goes on when the drive answers again.</source>
        <translation>取り込みを行っていません: %1 ドライブの応答が戻ると再開します。</translation>
    </message>
    <message>
        <source>Nothing is taken while the window does something else on this drive.</source>
        <translation>このドライブでウィンドウが別の処理を行っている間は取り込みません。</translation>
    </message>
    <message>
        <source>Paused: nothing is taken. %1</source>
        <translation>一時停止中: 取り込みを行っていません。%1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CapturedPlot</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>up</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>down</source>
        <translation>負方向</translation>
    </message>
    <message>
        <source>Deviations that were taken</source>
        <translation>取り込んだ偏差</translation>
    </message>
    <message>
        <source>The same values are in the list of steps</source>
        <translation>同じ値がステップの一覧にあります</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateButton</name>
    <message>
        <source>Forget Cert&amp;ificate</source>
        <translation>証明書の信頼を解除(&amp;I)</translation>
    </message>
    <message>
        <source>Cert&amp;ificate …</source>
        <translation>証明書(&amp;I) …</translation>
    </message>
    <message>
        <source>Stop trusting the certificate of the selected drive</source>
        <translation>選択したドライブの証明書の信頼を解除します</translation>
    </message>
    <message>
        <source>Show the certificate of the selected drive and decide whether to trust it</source>
        <translation>選択したドライブの証明書を表示し、信頼するかどうかを決めます</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateDialog</name>
    <message>
        <source>Drive Certificate</source>
        <translation>ドライブの証明書</translation>
    </message>
    <message>
        <source>The certificate of this drive has CHANGED since it was trusted. Either the drive has a new one, or another device answers at its address.</source>
        <translation>このドライブの証明書が、信頼した後に変更されています。ドライブの証明書が新しくなったか、別の機器がこのアドレスで応答しています。</translation>
    </message>
    <message>
        <source>No authority known to this computer has signed this certificate, so the identity of the drive cannot be confirmed.</source>
        <translation>この証明書は、このコンピュータが認識している認証局によって署名されていないため、ドライブの正当性を確認できません。</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>発行先</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>発行者</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>有効期間</translation>
    </message>
    <message>
        <source>SHA-256 fingerprint</source>
        <translation>SHA-256 フィンガープリント</translation>
    </message>
    <message>
        <source>from %1 until %2</source>
        <translation>%1 から %2 まで</translation>
    </message>
    <message>
        <source>Trust it only if the drive itself, or its administrator, shows the same fingerprint. From then on this address is accepted with this certificate only.</source>
        <translation>ドライブ自体またはその管理者が示すフィンガープリントと同じ場合にだけ信頼してください。以後、このアドレスではこの証明書だけを受け入れます。</translation>
    </message>
    <message>
        <source>Do &amp;Not Trust</source>
        <translation>信頼しない(&amp;N)</translation>
    </message>
    <message>
        <source>Stay disconnected (Esc)</source>
        <translation>接続しないままにします (Esc)</translation>
    </message>
    <message>
        <source>&amp;Trust This Certificate</source>
        <translation>この証明書を信頼する(&amp;T)</translation>
    </message>
    <message>
        <source>Accept this certificate for this address from now on</source>
        <translation>今後、このアドレスでこの証明書を受け入れます</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ChangePictures</name>
    <message>
        <source>On the drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Difference, new − old</source>
        <translation>差 (新 − 旧)</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>%1; shown: the middle slice, %2 %3</source>
        <comment>largest value, dimension, place</comment>
        <translation>%1。表示: 中央の断面、%2 %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>value at position</comment>
        <translation>%2 で %1</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>最大 %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnMapping</name>
    <message>
        <source>Select at least one axis.</source>
        <translation>軸を 1 つ以上選択してください。</translation>
    </message>
    <message>
        <source>%1 is selected twice; an axis has only one table.</source>
        <translation>%1 が 2 回選択されています。1 つの軸のテーブルは 1 つだけです。</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>軸 %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnMappingTable</name>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>ファイルの列</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Which column is for which axis</source>
        <translation>列と軸の対応</translation>
    </message>
    <message>
        <source>none</source>
        <comment>axis</comment>
        <translation>なし</translation>
    </message>
    <message>
        <source>Axis for %1</source>
        <translation>%1 の軸</translation>
    </message>
    <message>
        <source>The axis for column %1</source>
        <translation>列 %1 の軸</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnPreview</name>
    <message>
        <source>Columns of the file</source>
        <translation>ファイルの列</translation>
    </message>
    <message>
        <source>by its name</source>
        <translation>列名による</translation>
    </message>
    <message>
        <source>What column %1 is</source>
        <translation>列 %1 の内容</translation>
    </message>
    <message>
        <source>What this column is. Once one is chosen, only chosen columns are read; until then the names of the columns say it.</source>
        <translation>この列の内容。1 つでも選ぶと、選んだ列だけを読み取ります。選ばない間は列名で判断します。</translation>
    </message>
    <message>
        <source>%1 in column %2</source>
        <translation>列 %2: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnProposal</name>
    <message>
        <source>Proposed, as you chose it for the last file with these columns: %1.</source>
        <translation>提案 (同じ列構成の前回のファイルでの選択): %1。</translation>
    </message>
    <message>
        <source>Use T&amp;hese</source>
        <translation>これを使う(&amp;H)</translation>
    </message>
    <message>
        <source>Read the columns of this file in the same way</source>
        <translation>このファイルの列を同じように読み取ります</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ComparisonFiguresModel</name>
    <message>
        <source>no tolerance</source>
        <translation>許容値なし</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>未定義</translation>
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
        <translation>特性値</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>補正前</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>未使用点</translation>
    </message>
    <message>
        <source>After</source>
        <translation>補正後</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>What is left at targets that the table was made without: the figure to believe</source>
        <translation>テーブルの作成に使わなかった目標位置に残る誤差。信頼すべき値です</translation>
    </message>
    <message>
        <source>Before, all values</source>
        <translation>補正前、全データ</translation>
    </message>
    <message>
        <source>After, all values</source>
        <translation>補正後、全データ</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CompensationWizard</name>
    <message>
        <source>Axis Compensation Wizard</source>
        <translation>軸補正ウィザード</translation>
    </message>
    <message>
        <source>%1 is opened as soon as that is possible. %2</source>
        <translation>%1 は可能になりしだい開きます。%2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConditionsModel</name>
    <message>
        <source>Condition of ISO 230-2</source>
        <translation>ISO 230-2 の条件</translation>
    </message>
    <message>
        <source>Met?</source>
        <translation>適合？</translation>
    </message>
    <message>
        <source>%1 (assumption)</source>
        <translation>%1 (推定)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConnectionsDialog</name>
    <message>
        <source>Use the drives of the list</source>
        <translation>リストのドライブを使います</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>変更を破棄します (Esc)</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>Change the address of the chosen connection</source>
        <translation>選択した接続のアドレスを変更します</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>削除(&amp;R)</translation>
    </message>
    <message>
        <source>Remove the chosen connection</source>
        <translation>選択した接続を削除します</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>テスト(&amp;T)</translation>
    </message>
    <message>
        <source>Ask the drive at the selected address to identify itself</source>
        <translation>選択したアドレスのドライブに識別情報を問い合わせます</translation>
    </message>
    <message>
        <source>De&amp;mo Drive</source>
        <translation>デモドライブ(&amp;M)</translation>
    </message>
    <message>
        <source>Add the built-in demo drive to try everything without hardware</source>
        <translation>内蔵のデモドライブを追加し、ハードウェアなしですべてを試せるようにします</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>アドレス(&amp;A)</translation>
    </message>
    <message>
        <source>%1 (demo)</source>
        <translation>%1 (デモ)</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>接続済み</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>接続中 …</translation>
    </message>
    <message>
        <source>answers; serial number %1, axes: %2</source>
        <translation>応答あり。シリアル番号 %1、軸: %2</translation>
    </message>
    <message>
        <source>asking …</source>
        <translation>問い合わせ中 …</translation>
    </message>
    <message>
        <source>This address is already in the list.</source>
        <translation>このアドレスはすでにリストにあります。</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>%1 に問い合わせ中 …</translation>
    </message>
    <message>
        <source>Added, but not answering yet: %1</source>
        <translation>追加しましたが、まだ応答がありません: %1</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>追加(&amp;D)</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>変更(&amp;G)</translation>
    </message>
    <message>
        <source>Checks the address and adds it to the list</source>
        <translation>アドレスを確認し、リストに追加します</translation>
    </message>
    <message>
        <source>Not possible while a drive is being written</source>
        <translation>ドライブへの書き込み中はできません</translation>
    </message>
    <message>
        <source>Drives are reached through their web server, such as http://192.168.1.20, or a serial line, such as serial:/dev/ttyUSB0. A web address may contain a user name and password (http://user:password@host); they are used until the program ends and never stored.</source>
        <translation>ドライブには Web サーバ (http://192.168.1.20 など) またはシリアル回線 (serial:/dev/ttyUSB0 など) で接続します。Web アドレスにはユーザ名とパスワードを含めることができます (http://user:password@host)。これらはプログラムの終了まで使用され、保存されません。</translation>
    </message>
    <message>
        <source>&amp;Find …</source>
        <translation>検索(&amp;F) …</translation>
    </message>
    <message>
        <source>Search the serial ports of this computer for drives</source>
        <translation>このコンピュータのシリアルポートでドライブを検索します</translation>
    </message>
    <message>
        <source>The address of a drive&apos;s web server, or a serial port</source>
        <translation>ドライブの Web サーバのアドレス、またはシリアルポート</translation>
    </message>
    <message>
        <source>The certificate of %1 is no longer trusted.</source>
        <translation>%1 の証明書の信頼を解除しました。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ControllerCombo</name>
    <message>
        <source>As applied by %1</source>
        <translation>%1 での適用結果</translation>
    </message>
    <message>
        <source>The table as the drive applies it, or converted to another controller&apos;s convention: its sign, and its rules beyond the ends</source>
        <translation>ドライブでの適用結果、または別のコントローラの規約 (符号と端より先の扱い) に変換した結果</translation>
    </message>
    <message>
        <source>Applied by</source>
        <translation>適用先</translation>
    </message>
    <message>
        <source>As on the drive</source>
        <translation>ドライブと同じ</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Change nothing (Esc)</source>
        <translation>何も変更しません (Esc)</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>結果(&amp;R)</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>What the conversion does to the numbers, with an example</source>
        <translation>変換による数値の変化とその例</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>計算中 …</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionForm</name>
    <message>
        <source>Choose the format.</source>
        <translation>形式を選んでください。</translation>
    </message>
    <message>
        <source>Enter a number for the even grid.</source>
        <translation>等間隔格子の数値を入力してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number, and no list such as 21; 31.</source>
        <translation>&quot;%1&quot; は数値でも、21; 31 のようなリストでもありません。</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>形式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Sign</source>
        <translation>符号(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>方向(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Between points</source>
        <translation>点間の補間(&amp;B)</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a &amp;linear one</source>
        <translation>モジュロ軸を直進軸として扱う(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Hold the end values beyond the data</source>
        <translation>データの範囲外で端点値を保持(&amp;H)</translation>
    </message>
    <message>
        <source>The format that the file is read as</source>
        <translation>ファイルを読み取る形式</translation>
    </message>
    <message>
        <source>The format of the new file</source>
        <translation>新しいファイルの形式</translation>
    </message>
    <message>
        <source>Whether the file&apos;s values are added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>ファイルの値をエンコーダ位置に加算する (feedback) か、指令位置に加算する (command) か</translation>
    </message>
    <message>
        <source>Whether the new file&apos;s values are to be added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>新しいファイルの値をエンコーダ位置に加算する (feedback) か、指令位置に加算する (command) か</translation>
    </message>
    <message>
        <source>The drive holds one value for both directions of motion; choose which one</source>
        <translation>ドライブの値は両方の運動方向に共通です。使う値を選びます</translation>
    </message>
    <message>
        <source>For an axis that stays within one revolution: the table is used as it is</source>
        <translation>1 回転以内で動く軸の場合: テーブルをそのまま使います</translation>
    </message>
    <message>
        <source>Brings the table onto evenly spaced positions</source>
        <translation>テーブルを等間隔の位置に変換します</translation>
    </message>
    <message>
        <source>How the values between the positions of the table are made</source>
        <translation>テーブルの位置の間の値の求め方</translation>
    </message>
    <message>
        <source>The even grid may end beyond the last position</source>
        <translation>等間隔格子の終点が最後の位置を越えることを許容します</translation>
    </message>
    <message>
        <source>choose the format</source>
        <translation>形式を選択</translation>
    </message>
    <message>
        <source>as the format says</source>
        <translation>形式による</translation>
    </message>
    <message>
        <source>as the format says: feedback</source>
        <translation>形式による: feedback</translation>
    </message>
    <message>
        <source>as the format says: command</source>
        <translation>形式による: command</translation>
    </message>
    <message>
        <source>feedback: added to the encoder position</source>
        <translation>feedback: エンコーダ位置に加算</translation>
    </message>
    <message>
        <source>command: added to the commanded position</source>
        <translation>command: 指令位置に加算</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>選択してください</translation>
    </message>
    <message>
        <source>the mean of both directions</source>
        <translation>両方向の平均</translation>
    </message>
    <message>
        <source>the values of the positive direction</source>
        <translation>正方向の値</translation>
    </message>
    <message>
        <source>the values of the negative direction</source>
        <translation>負方向の値</translation>
    </message>
    <message>
        <source>the positions of the table</source>
        <translation>テーブルの位置</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>点数で指定</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>間隔で指定</translation>
    </message>
    <message>
        <source>coarsest within a deviation</source>
        <translation>許容偏差以内で最も粗く</translation>
    </message>
    <message>
        <source>linear, as controllers do</source>
        <translation>直線 (コントローラと同じ)</translation>
    </message>
    <message>
        <source>smooth (monotone cubic)</source>
        <translation>滑らか (単調 3 次)</translation>
    </message>
    <message>
        <source>&amp;Number of points</source>
        <translation>点数(&amp;N)</translation>
    </message>
    <message>
        <source>At least 2; one number for all sources, or one for each: 21; 31</source>
        <translation>2 以上。全ソース共通の数値 1 つ、またはソースごとの数値 (例: 21; 31)</translation>
    </message>
    <message>
        <source>Dista&amp;nce</source>
        <translation>間隔(&amp;N)</translation>
    </message>
    <message>
        <source>In the unit of the positions; one number for all sources, or one for each: 5; 10</source>
        <translation>位置の単位。全ソース共通の数値 1 つ、またはソースごとの数値 (例: 5; 10)</translation>
    </message>
    <message>
        <source>Deviatio&amp;n</source>
        <translation>偏差(&amp;N)</translation>
    </message>
    <message>
        <source>In the unit of the values; the coarsest grid within it is used</source>
        <translation>値の単位。この範囲で最も粗い格子を使います</translation>
    </message>
    <message>
        <source>Target &amp;axis</source>
        <translation>対象軸(&amp;A)</translation>
    </message>
    <message>
        <source>The axis that the values correct: one of the sources, or another axis; the sign is converted accordingly</source>
        <translation>値が補正する軸。ソースのいずれか、または別の軸です。符号はこれに従って変換されます</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルの記載どおり</translation>
    </message>
    <message>
        <source>as the table says</source>
        <translation>テーブルの記載どおり</translation>
    </message>
    <message>
        <source>the first source</source>
        <translation>第 1 ソース</translation>
    </message>
    <message>
        <source>the second source</source>
        <translation>第 2 ソース</translation>
    </message>
    <message>
        <source>the third source</source>
        <translation>第 3 ソース</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>別の軸</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tolerance: enter a number above 0, or nothing.</source>
        <translation>&quot;%1&quot; は許容差ではありません。0 より大きい数値を入力するか、空欄にしてください。</translation>
    </message>
    <message>
        <source>Missin&amp;g points</source>
        <translation>欠測点(&amp;G)</translation>
    </message>
    <message>
        <source>Snap &amp;tolerance</source>
        <translation>スナップ許容差(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Even grid</source>
        <translation>等間隔格子(&amp;E)</translation>
    </message>
    <message>
        <source>What becomes of points of the grid that have no value</source>
        <translation>値のない格子点の扱い</translation>
    </message>
    <message>
        <source>Positions that are this close to an even grid are taken for its positions, in their unit; empty: as they stand in the file</source>
        <translation>等間隔格子との差がこれ以内の位置を格子の位置とみなします (位置の単位)。空欄: ファイルの値のまま</translation>
    </message>
    <message>
        <source>none may be missing</source>
        <translation>欠測不可</translation>
    </message>
    <message>
        <source>filled with the nearest measured value</source>
        <translation>最も近い測定値で補填</translation>
    </message>
    <message>
        <source>filled from the plane through all points</source>
        <translation>全点を通る平面から補填</translation>
    </message>
    <message>
        <source>filled smoothly, with the least bending</source>
        <translation>曲げが最小になるよう滑らかに補填</translation>
    </message>
    <message>
        <source>left out: the grid is cropped</source>
        <translation>除外: 格子を切り詰める</translation>
    </message>
    <message>
        <source>spline (natural cubic)</source>
        <translation>スプライン (自然 3 次)</translation>
    </message>
    <message>
        <source>without noise (smoothing spline)</source>
        <translation>ノイズ除去 (平滑化スプライン)</translation>
    </message>
    <message>
        <source>choose one; feedback is assumed</source>
        <translation>選択してください (feedback とみなします)</translation>
    </message>
    <message>
        <source>choose one; command is assumed</source>
        <translation>選択してください (command とみなします)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CorrectionsDialog</name>
    <message>
        <source>%1 mm; runs with their air: %2</source>
        <translation>%1 mm、空気の状態のある走行: %2</translation>
    </message>
    <message>
        <source>not corrected for</source>
        <translation>補正しない</translation>
    </message>
    <message>
        <source>Enter temperatures and coefficients as numbers; only the position that does not move may be left empty.</source>
        <translation>温度と係数には数値を入力してください。空欄にできるのは不動位置だけです。</translation>
    </message>
    <message>
        <source>The file does not say whether its values are at 20 °C already. Only values that are not may be corrected.</source>
        <translation>値がすでに 20 °C のものかどうか、ファイルに記載がありません。補正できるのは、20 °C のものでない値だけです。</translation>
    </message>
    <message>
        <source>Corrections Before Judging</source>
        <translation>判定前の測定値の補正</translation>
    </message>
    <message>
        <source>&amp;Bring the values to 20 °C</source>
        <translation>値を 20 °C に換算(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Temperature of the scale [°C]</source>
        <translation>スケールの温度 [°C](&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Expansion of the scale [%1]</source>
        <translation>スケールの膨張係数 [%1](&amp;E)</translation>
    </message>
    <message>
        <source>Temperature of the &amp;reference [°C]</source>
        <translation>基準の温度 [°C](&amp;R)</translation>
    </message>
    <message>
        <source>E&amp;xpansion of the reference [%1]</source>
        <translation>基準の膨張係数 [%1](&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Position that does not move [mm]</source>
        <translation>不動位置 [mm](&amp;P)</translation>
    </message>
    <message>
        <source>Of the material that the axis is measured by</source>
        <translation>軸の測長に使われている材料の値</translation>
    </message>
    <message>
        <source>Of the same material; steel has about 11.5</source>
        <translation>同じ材料の値。鋼は約 11.5</translation>
    </message>
    <message>
        <source>Of the measuring instrument</source>
        <translation>測定器の値</translation>
    </message>
    <message>
        <source>0 for a laser that is compensated for its wavelength</source>
        <translation>波長補正済みのレーザは 0</translation>
    </message>
    <message>
        <source>Empty: the first target</source>
        <translation>空欄: 最初の目標位置</translation>
    </message>
    <message>
        <source>the first target</source>
        <translation>最初の目標位置</translation>
    </message>
    <message>
        <source>&amp;Steel</source>
        <translation>鋼(&amp;S)</translation>
    </message>
    <message>
        <source>Enter the coefficient of steel, 11.5 µm/(m·K)</source>
        <translation>鋼の係数 11.5 µm/(m·K) を入力します</translation>
    </message>
    <message>
        <source>The instrument has &amp;not corrected the values itself</source>
        <translation>測定器自体では値を補正していない(&amp;N)</translation>
    </message>
    <message>
        <source>Needed where the file does not say it</source>
        <translation>ファイルに記載がない場合に必要</translation>
    </message>
    <message>
        <source>Dead path of the interferometer</source>
        <translation>干渉計のデッドパス</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>削除(&amp;M)</translation>
    </message>
    <message>
        <source>Do not correct for the dead path</source>
        <translation>デッドパスを補正しません</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>補正する(&amp;C)</translation>
    </message>
    <message>
        <source>Judge the values with these corrections</source>
        <translation>この補正を行った値で判定します</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>キャンセル(&amp;L)</translation>
    </message>
    <message>
        <source>Leave the corrections as they are (Esc)</source>
        <translation>補正の設定を変更しません (Esc)</translation>
    </message>
    <message>
        <source>A JSON file with its length and the air of each run</source>
        <translation>デッドパスの長さと各走行の空気の状態の JSON ファイル</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DataFileField</name>
    <message>
        <source>No file is open</source>
        <translation>開いているファイルはありません</translation>
    </message>
    <message>
        <source>Open a file of compensation data, or drop it on the window (Ctrl+O)</source>
        <translation>補正データのファイルを開きます。ウィンドウへのドロップもできます (Ctrl+O)</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>ファイルなし</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>開いているファイル</translation>
    </message>
    <message>
        <source>The name of the open file of compensation data</source>
        <translation>開いている補正データのファイル名</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>ファイルを読み取り中</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Opens a file of compensation data</source>
        <translation>補正データのファイルを開きます</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>中止(&amp;O)</translation>
    </message>
    <message>
        <source>Stop reading the file</source>
        <translation>ファイルの読み取りを中止します</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>最近使ったファイルなし</translation>
    </message>
    <message>
        <source>&amp;Read Again</source>
        <translation>再読み取り(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Close File</source>
        <translation>ファイルを閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Import &amp;Options…</source>
        <translation>インポートの設定(&amp;O)…</translation>
    </message>
    <message>
        <source>Format, sign and grid of the open file</source>
        <translation>開いているファイルの形式、符号、格子</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationCanvas</name>
    <message>
        <source>smallest and largest value</source>
        <translation>最小値と最大値</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>除外の提案</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationPlot</name>
    <message>
        <source>Deviation over position</source>
        <translation>位置に対する偏差</translation>
    </message>
    <message>
        <source>A click selects a value; arrow keys go from value to value. The wheel and + and - zoom, dragging moves, Home or a double click shows everything.</source>
        <translation>クリックで値を選択、矢印キーで値の間を移動します。ホイールと + / - で拡大縮小、ドラッグで移動、Home またはダブルクリックで全体表示です。</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>走行 %1、%2</translation>
    </message>
    <message>
        <source>target %1 %2, ↑ %3, ↓ %4 %5, B %6 %5</source>
        <translation>目標位置 %1 %2、↑ %3、↓ %4 %5、B %6 %5</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftDetails</name>
    <message>
        <source>Field</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>機械ファイル</translation>
    </message>
    <message>
        <source>How the axis differs from the machine file</source>
        <translation>軸と機械ファイルの相違</translation>
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
        <translation>走行のドリフト</translation>
    </message>
    <message>
        <source>Runs ↑</source>
        <translation>走行 ↑</translation>
    </message>
    <message>
        <source>Runs ↓</source>
        <translation>走行 ↓</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両方向</translation>
    </message>
    <message>
        <source>From the first to the last run</source>
        <translation>最初から最後の走行まで</translation>
    </message>
    <message>
        <source>From run to run</source>
        <translation>走行ごと</translation>
    </message>
    <message>
        <source>Per hour</source>
        <translation>1 時間あたり</translation>
    </message>
    <message>
        <source>Per kelvin</source>
        <translation>1 K あたり</translation>
    </message>
    <message>
        <source>s without the offsets of the runs</source>
        <translation>走行のオフセットを除いた s</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ドリフト</translation>
    </message>
    <message>
        <source>A without the offsets of the runs</source>
        <translation>走行のオフセットを除いた A</translation>
    </message>
    <message>
        <source>R without the offsets of the runs</source>
        <translation>走行のオフセットを除いた R</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>疑いあり</translation>
    </message>
    <message>
        <source>not suspected</source>
        <translation>疑いなし</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftPlot</name>
    <message>
        <source>%1, run %2: offset %3</source>
        <translation>%1、走行 %2: オフセット %3</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>Offset of the run</source>
        <translation>走行のオフセット</translation>
    </message>
    <message>
        <source>runs ↑</source>
        <translation>走行 ↑</translation>
    </message>
    <message>
        <source>runs ↓</source>
        <translation>走行 ↓</translation>
    </message>
    <message>
        <source>Drift: offsets of the runs</source>
        <translation>ドリフト: 走行のオフセット</translation>
    </message>
    <message>
        <source>How far each run lies beside the mean of its direction. A click or the arrow keys select a run.</source>
        <translation>各走行の、その方向の平均からのずれ。クリックまたは矢印キーで走行を選択します。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftText</name>
    <message>
        <source>not in the file</source>
        <comment>axis</comment>
        <translation>ファイルにない</translation>
    </message>
    <message>
        <source>not among the connections</source>
        <comment>drive</comment>
        <translation>接続にない</translation>
    </message>
    <message>
        <source>is being compared …</source>
        <translation>比較中 …</translation>
    </message>
    <message>
        <source>not reachable</source>
        <comment>drive</comment>
        <translation>接続できない</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>比較できない</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルと同じ</translation>
    </message>
    <message>
        <source>%1 (compared at %2)</source>
        <comment>state and time</comment>
        <translation>%1 (%2 に比較)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>table and grid</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>不揮発</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>揮発</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>未設定</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Earlier write</source>
        <translation>以前の書き込み</translation>
    </message>
    <message>
        <source>did not end</source>
        <translation>未完了</translation>
    </message>
    <message>
        <source>is ended by the next write</source>
        <translation>次の書き込みで完了</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>補正</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>%1 (serial number %2)</source>
        <comment>address of a drive</comment>
        <translation>%1 (シリアル番号 %2)</translation>
    </message>
    <message>
        <source>%1, axis %2</source>
        <comment>drive and axis</comment>
        <translation>%1、軸 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <comment>file, line and problem</comment>
        <translation>%1、行 %2: %3</translation>
    </message>
    <message>
        <source>This cannot be written now: %1</source>
        <translation>現在は書き込めません: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveBar</name>
    <message>
        <source>%1 (demo)</source>
        <translation>%1 (デモ)</translation>
    </message>
    <message>
        <source>&amp;Drive</source>
        <translation>ドライブ(&amp;D)</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>The drive of the chosen axis, and its address</source>
        <translation>選択した軸のドライブとそのアドレス</translation>
    </message>
    <message>
        <source>The drive of the selected axis; lists all drives under Connections</source>
        <translation>選択した軸のドライブ。[接続] のすべてのドライブを表示します</translation>
    </message>
    <message>
        <source>Co&amp;nnections…</source>
        <translation>接続(&amp;N)…</translation>
    </message>
    <message>
        <source>Add, test or remove drives</source>
        <translation>ドライブの追加、テスト、削除</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>更新(&amp;R)</translation>
    </message>
    <message>
        <source>More: language, log, settings</source>
        <translation>その他: 言語、ログ、設定</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>no drive</source>
        <translation>ドライブなし</translation>
    </message>
    <message>
        <source>no drive: add one under Connections</source>
        <translation>ドライブなし: [接続] で追加してください</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>接続中 …</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>接続済み</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>接続が切れました。再接続中</translation>
    </message>
    <message>
        <source>Search for axes again and read everything from the drives (F5)</source>
        <translation>軸を検索し直し、ドライブからすべてを読み取ります (F5)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveList</name>
    <message>
        <source>Connected to %1 (%2).</source>
        <translation>%1 (%2) に接続しました。</translation>
    </message>
    <message>
        <source>A different drive now answers at %1: %2. Unwritten changes were discarded.</source>
        <translation>%1 で別のドライブが応答しています: %2。書き込んでいない変更は破棄しました。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DropFrame</name>
    <message>
        <source>Drop to open %1</source>
        <translation>ドロップして %1 を開く</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExaggerationCombo</name>
    <message>
        <source>Exaggeration</source>
        <translation>誤差倍率</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>自動</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportConfigurationDialog</name>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>TAM 構成へのエクスポート</translation>
    </message>
    <message>
        <source>Puts the table and source parameters of %1 into %2. Everything else in the file stays as it is; nothing on the drive changes.</source>
        <translation>%1 のテーブルとソースのパラメータを %2 に書き出します。ファイルのほかの内容と、ドライブの内容は変わりません。</translation>
    </message>
    <message>
        <source>What the drive has</source>
        <translation>ドライブの内容</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>スロット</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>ソース</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>名前を付けて保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>何も変更せずに戻ります (Esc)</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>ドライブを読み取り中 …</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>比較中 …</translation>
    </message>
    <message>
        <source>The configuration has all of this already.</source>
        <translation>構成の内容はすでに同じです。</translation>
    </message>
    <message>
        <source>Choose where to save the configuration</source>
        <translation>構成の保存先を選びます</translation>
    </message>
    <message>
        <source>In the file, only Table and Dim1Source to Dim3Source of these axes will change.</source>
        <translation>ファイルで変わるのは、これらの軸の Table と Dim1Source から Dim3Source だけです。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportDialog</name>
    <message>
        <source>Export for Another Controller</source>
        <translation>別のコントローラ用のエクスポート</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file for another controller. Nothing on the drive changes.</source>
        <translation>テーブル「%1」を別のコントローラ用のファイルに書き出します。ドライブの内容は変わりません。</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>エクスポート(&amp;X)…</translation>
    </message>
    <message>
        <source>Choose where to save the file</source>
        <translation>ファイルの保存先を選びます</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>テーブルの保存</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file of the drive or of another controller. Nothing on the drive changes.</source>
        <translation>テーブル「%1」をドライブまたは別のコントローラのファイルに書き出します。ドライブの内容は変わりません。</translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation>保存(&amp;A)…</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FieldRow</name>
    <message>
        <source>Revert %1</source>
        <translation>%1 をドライブの値に戻す</translation>
    </message>
    <message>
        <source>changed, on the drive: %1</source>
        <translation>変更あり、ドライブ: %1</translation>
    </message>
    <message>
        <source>on the drive: %1</source>
        <translation>ドライブ: %1</translation>
    </message>
    <message>
        <source>Revert to the drive&apos;s value: %1</source>
        <translation>ドライブの値に戻す: %1</translation>
    </message>
    <message>
        <source>&amp;Revert to the drive&apos;s value</source>
        <translation>ドライブの値に戻す(&amp;R)</translation>
    </message>
    <message>
        <source>as last read</source>
        <translation>最後に読み取った値</translation>
    </message>
    <message>
        <source>proposed: %1</source>
        <translation>提案: %1</translation>
    </message>
    <message>
        <source>Use</source>
        <comment>what is proposed</comment>
        <translation>採用</translation>
    </message>
    <message>
        <source>Use what is proposed: %1</source>
        <translation>提案を採用: %1</translation>
    </message>
    <message>
        <source>Use what is proposed for %1</source>
        <translation>%1 の提案を採用</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FiguresModel</name>
    <message>
        <source>Figure</source>
        <translation>特性値</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>意味</translation>
    </message>
    <message>
        <source>Without excluded</source>
        <translation>除外後</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>全データ</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>At target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>uncertainty not stated</source>
        <translation>不確かさの記載なし</translation>
    </message>
    <message>
        <source> and </source>
        <comment>two positions</comment>
        <translation> と </translation>
    </message>
    <message>
        <source>U largest</source>
        <translation>U 最大</translation>
    </message>
    <message>
        <source>U mean</source>
        <translation>U 平均</translation>
    </message>
    <message>
        <source>Ps largest</source>
        <translation>Ps 最大</translation>
    </message>
    <message>
        <source>Ps mean</source>
        <translation>Ps 平均</translation>
    </message>
    <message>
        <source>VDI/DGQ 3441 (assumption)</source>
        <translation>VDI/DGQ 3441 (推定)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileActions</name>
    <message>
        <source>Open Compensation Data</source>
        <translation>補正データを開く</translation>
    </message>
    <message>
        <source>Save Example File</source>
        <translation>サンプルファイルの保存</translation>
    </message>
    <message>
        <source>Calibration files (*.csv)</source>
        <translation>校正ファイル (*.csv)</translation>
    </message>
    <message>
        <source>Save Log</source>
        <translation>ログの保存</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>テキストファイル (*.txt)</translation>
    </message>
    <message>
        <source>Export for Another Controller</source>
        <translation>別のコントローラ用のエクスポート</translation>
    </message>
    <message>
        <source>Import TAM Configuration</source>
        <translation>TAM 構成のインポート</translation>
    </message>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>TAM 構成へのエクスポート</translation>
    </message>
    <message>
        <source>TAM configurations (*.TAMcfg)</source>
        <translation>TAM 構成 (*.TAMcfg)</translation>
    </message>
    <message>
        <source>Save TAM Configuration</source>
        <translation>TAM 構成の保存</translation>
    </message>
    <message>
        <source>Back Up Whole Drive</source>
        <translation>ドライブ全体のバックアップ</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>バックアップ (*.json)</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>ドライブ全体の復元</translation>
    </message>
    <message>
        <source>Add Measurement</source>
        <translation>測定の追加</translation>
    </message>
    <message>
        <source>Save as Runs</source>
        <translation>走行データとして保存</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>走行データ (*.csv)</translation>
    </message>
    <message>
        <source>Dead Path</source>
        <translation>デッドパス</translation>
    </message>
    <message>
        <source>Dead path (*.json)</source>
        <translation>デッドパス (*.json)</translation>
    </message>
    <message>
        <source>Table That Was Active</source>
        <translation>有効だったテーブル</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>テーブルの保存</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileChoices</name>
    <message>
        <source>&amp;Format</source>
        <translation>形式(&amp;F)</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>内容から判別</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>値(&amp;V)</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルの記載どおり</translation>
    </message>
    <message>
        <source>deviations from the target</source>
        <translation>目標位置からの偏差</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>基準の位置</translation>
    </message>
    <message>
        <source>&amp;Unit of targets</source>
        <translation>目標位置の単位(&amp;U)</translation>
    </message>
    <message>
        <source>Unit &amp;of values</source>
        <translation>値の単位(&amp;O)</translation>
    </message>
    <message>
        <source>Lines &amp;before the header</source>
        <translation>ヘッダの前の行数(&amp;B)</translation>
    </message>
    <message>
        <source>D&amp;irections by the order of targets</source>
        <translation>目標位置の順で方向を判別(&amp;I)</translation>
    </message>
    <message>
        <source>The reference counts the other &amp;way</source>
        <translation>基準の計数方向が逆(&amp;W)</translation>
    </message>
    <message>
        <source>The format of the file</source>
        <translation>ファイルの形式</translation>
    </message>
    <message>
        <source>A deviation is the reference position minus the target</source>
        <translation>偏差は、基準の位置から目標位置を引いた値です</translation>
    </message>
    <message>
        <source>For a file that does not name it</source>
        <translation>ファイルに記載がない場合</translation>
    </message>
    <message>
        <source>Lines of a CSV file that come before the names of its columns</source>
        <translation>CSV ファイルの列名より前にある行の数</translation>
    </message>
    <message>
        <source>For a file without directions: a run is up while its targets rise</source>
        <translation>方向の記載がないファイルの場合: 目標位置が増える走行を正方向とします</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>軸が正方向に動くと値が減る測定器の場合</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileFacts</name>
    <message>
        <source>off: the drive added nothing</source>
        <translation>オフ: ドライブの加算なし</translation>
    </message>
    <message>
        <source>on, with table %1</source>
        <translation>オン、テーブル %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>the file does not say it</source>
        <translation>ファイルに記載なし</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 %4</source>
        <translation>%1、%2 から %3 %4</translation>
    </message>
    <message>
        <source>What</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>Statement of the file</source>
        <translation>ファイルの記載</translation>
    </message>
    <message>
        <source>What the file says</source>
        <translation>ファイルの記載内容</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>読み取り形式</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>補正</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>測定器</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>測定者</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>送り速度</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>ドウェル時間</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空気</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Expansion</source>
        <translation>膨張係数</translation>
    </message>
    <message>
        <source>Corrected to 20 °C</source>
        <translation>20 °C への換算</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesModel</name>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>行 %1、列 %2: %3</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesView</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1、行 %2</translation>
    </message>
    <message>
        <source>%1, line %2, column %3</source>
        <translation>%1、行 %2、列 %3</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>ファイルを読み取り中…</translation>
    </message>
    <message>
        <source>These lines can no longer be read from the file.</source>
        <translation>これらの行は、もうファイルから読み取れません。</translation>
    </message>
    <message>
        <source>Lines %1 to %2</source>
        <translation>行 %1 から %2</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>前の問題</translation>
    </message>
    <message>
        <source>Show the lines at the previous problem</source>
        <translation>前の問題がある行を表示します</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>次の問題</translation>
    </message>
    <message>
        <source>Show the lines at the next problem</source>
        <translation>次の問題がある行を表示します</translation>
    </message>
    <message>
        <source>Table&apos;s values</source>
        <translation>テーブルの値</translation>
    </message>
    <message>
        <source>Show the values of the selected table again</source>
        <translation>選択したテーブルの値の表示に戻ります</translation>
    </message>
    <message>
        <source>Earlier lines</source>
        <translation>前の行</translation>
    </message>
    <message>
        <source>Show the lines before these</source>
        <translation>これより前の行を表示します</translation>
    </message>
    <message>
        <source>Later lines</source>
        <translation>後の行</translation>
    </message>
    <message>
        <source>Show the lines after these</source>
        <translation>これより後の行を表示します</translation>
    </message>
    <message>
        <source>The file&apos;s lines at the chosen problem</source>
        <translation>選択した問題があるファイルの行</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileViews</name>
    <message>
        <source>What the file says</source>
        <translation>ファイルの記載内容</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Views of the file</source>
        <translation>ファイルの表示</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>問題 (%1)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FindDrivesDialog</name>
    <message>
        <source>Find Drives</source>
        <translation>ドライブの検索</translation>
    </message>
    <message>
        <source>Asks every serial port of this computer for a drive; nothing else is sent. A port that is not listed can be entered as an address, such as serial:/dev/ttyUSB0?baud=921600.</source>
        <translation>このコンピュータの各シリアルポートにドライブがあるかを問い合わせます。ほかのものは送信しません。一覧にないポートは serial:/dev/ttyUSB0?baud=921600 のようなアドレスで入力できます。</translation>
    </message>
    <message>
        <source>Try all common &amp;baud rates at every port</source>
        <translation>各ポートで一般的なボーレートをすべて試す(&amp;B)</translation>
    </message>
    <message>
        <source>Takes a few seconds for each port without an answer</source>
        <translation>応答のないポート 1 つにつき数秒かかります</translation>
    </message>
    <message>
        <source>&amp;Search Again</source>
        <translation>再検索(&amp;S)</translation>
    </message>
    <message>
        <source>Search all ports again</source>
        <translation>すべてのポートをもう一度検索します</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>検索結果</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>検索中 …</translation>
    </message>
    <message>
        <source>%1, serial number %2, axes: %3</source>
        <translation>%1、シリアル番号 %2、軸: %3</translation>
    </message>
    <message>
        <source>All serial ports of this computer are already in the list.</source>
        <translation>このコンピュータのシリアルポートは、すべてリストにあります。</translation>
    </message>
    <message>
        <source>Ports searched: %1; drives found: %2</source>
        <translation>検索したポート: %1、見つかったドライブ: %2</translation>
    </message>
    <message>
        <source>&amp;Add to the Connections</source>
        <translation>接続に追加(&amp;A)</translation>
    </message>
    <message>
        <source>No drive is chosen</source>
        <translation>ドライブが選ばれていません</translation>
    </message>
    <message>
        <source>A network is asked only when you confirm its addresses: each of them gets one request.</source>
        <translation>ネットワークへの問い合わせは、アドレスを確認した後にだけ行います。各アドレスに要求を 1 回送ります。</translation>
    </message>
    <message>
        <source>&amp;Network:</source>
        <translation>ネットワーク(&amp;N):</translation>
    </message>
    <message>
        <source>Addresses of a network</source>
        <translation>ネットワークのアドレス</translation>
    </message>
    <message>
        <source>Such as 192.168.1.0/24, 192.168.1.10-40 or one address, with :8080 behind it for another port than 80</source>
        <translation>例: 192.168.1.0/24、192.168.1.10-40、または 1 つのアドレス。80 以外のポートは後に :8080 のように付けます</translation>
    </message>
    <message>
        <source>192.168.1.0/24</source>
        <comment>example of a range</comment>
        <translation>192.168.1.0/24</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>中止(&amp;T)</translation>
    </message>
    <message>
        <source>Ask no more; what was found stays</source>
        <translation>問い合わせをやめます。見つかったものは残ります</translation>
    </message>
    <message>
        <source>Asked %1 of %2 addresses; drives found: %3</source>
        <translation>%2 個中 %1 個のアドレスに問い合わせ済み、見つかったドライブ: %3</translation>
    </message>
    <message>
        <source>Stopped. Addresses asked: %1; drives found: %2</source>
        <translation>中止しました。問い合わせたアドレス: %1、見つかったドライブ: %2</translation>
    </message>
    <message>
        <source>Addresses asked: %1; drives found: %2</source>
        <translation>問い合わせたアドレス: %1、見つかったドライブ: %2</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses (%1)</source>
        <translation>アドレスに問い合わせ (%1)(&amp;D)</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses</source>
        <translation>アドレスに問い合わせ(&amp;D)</translation>
    </message>
    <message>
        <source>Each address gets one request over http, for the list of its files; what answers as a drive does is asked who it is</source>
        <translation>各アドレスに、ファイルの一覧を求める http の要求を 1 回送ります。ドライブとして応答したものには識別情報を問い合わせます</translation>
    </message>
    <message>
        <source>Enter the addresses first</source>
        <translation>先にアドレスを入力してください</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitForm</name>
    <message>
        <source>%1: a number is needed. %2</source>
        <translation>%1: 数値が必要です。%2</translation>
    </message>
    <message>
        <source>The current axis has no source.</source>
        <translation>現在の軸にソースがありません。</translation>
    </message>
    <message>
        <source>%1 of the current axis is no known position.</source>
        <translation>現在の軸の %1 は既知の位置ではありません。</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position before the compensation.</source>
        <translation>現在の軸の %1 は補正前の位置です。</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position after the compensation.</source>
        <translation>現在の軸の %1 は補正後の位置です。</translation>
    </message>
    <message>
        <source>The raw positions are on file: it does not matter what was active.</source>
        <translation>ファイルに補正前の位置があります。何が有効だったかは影響しません。</translation>
    </message>
    <message>
        <source>Measured with the compensation off, as the file says.</source>
        <translation>補正オフで測定 (ファイルの記載による)。</translation>
    </message>
    <message>
        <source>Measured with the table %1 active, as the file says.</source>
        <translation>テーブル %1 を有効にして測定 (ファイルの記載による)。</translation>
    </message>
    <message>
        <source>Measured with the compensation on, as the file says.</source>
        <translation>補正オンで測定 (ファイルの記載による)。</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>Lookup at</source>
        <translation>参照位置</translation>
    </message>
    <message>
        <source>Where the drive looks its table up; it decides where the values belong</source>
        <translation>ドライブがテーブルを参照する位置。値をどの位置に割り当てるかが決まります</translation>
    </message>
    <message>
        <source>as the source of the axis says</source>
        <translation>軸のソースによる</translation>
    </message>
    <message>
        <source>encoder, uncompensated</source>
        <translation>エンコーダ (補正前)</translation>
    </message>
    <message>
        <source>set position, compensated</source>
        <translation>指令位置 (補正後)</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>測定時の補正</translation>
    </message>
    <message>
        <source>What was active while it was measured, since the file does not say it</source>
        <translation>測定時に有効だった補正 (ファイルに記載がない場合)</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>compensation off</source>
        <translation>補正オフ</translation>
    </message>
    <message>
        <source>the table that is merged onto</source>
        <translation>統合先のテーブル</translation>
    </message>
    <message>
        <source>the table of a file…</source>
        <translation>ファイルのテーブル…</translation>
    </message>
    <message>
        <source>Merge onto</source>
        <translation>統合先</translation>
    </message>
    <message>
        <source>The table to which residuals are added, that was active while they were measured</source>
        <translation>測定時に有効で、残差を加算するテーブル</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>the table of the axis</source>
        <translation>軸のテーブル</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>Factor for the residuals: 1, or below it, such as 0.7, where the machine responds sluggishly; at most 2</source>
        <translation>残差に掛けるゲイン。通常は 1、機械の応答が鈍い場合は 0.7 など 1 より小さい値。2 以下</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>The curve through or near the means</source>
        <translation>平均値を通る、または平均値に近い曲線</translation>
    </message>
    <message>
        <source>linear: straight lines</source>
        <translation>linear: 直線</translation>
    </message>
    <message>
        <source>cubic: without overshoot</source>
        <translation>cubic: オーバーシュートなし</translation>
    </message>
    <message>
        <source>spline: natural cubic</source>
        <translation>spline: 自然 3 次</translation>
    </message>
    <message>
        <source>smooth: near the values</source>
        <translation>smooth: 値に近い曲線</translation>
    </message>
    <message>
        <source>harmonic: of a turn</source>
        <translation>harmonic: 1 回転の高調波</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Which runs the table is made of</source>
        <translation>テーブルの作成に使う走行</translation>
    </message>
    <message>
        <source>mean of up and down</source>
        <translation>両方向の平均</translation>
    </message>
    <message>
        <source>up only</source>
        <translation>正方向のみ</translation>
    </message>
    <message>
        <source>down only</source>
        <translation>負方向のみ</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>平滑度</translation>
    </message>
    <message>
        <source>A number from 0 on; by cross-validation when the field is empty</source>
        <translation>0 以上の数値。空欄の場合は交差検証で決めます</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Known periods above 0, such as the lead of the screw: 10; 2.5</source>
        <translation>0 より大きい既知の周期 (ねじのリードなど)。例: 10; 2.5</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>高調波</translation>
    </message>
    <message>
        <source>Of each period, or of the turn; 1 is the fundamental alone</source>
        <translation>各周期または 1 回転の高調波の数。1 は基本波のみ</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>1 回転</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>モジュロ軸の 1 回転の長さ (360 など)。テーブルの始点と終点が同じ値になります</translation>
    </message>
    <message>
        <source>no modulo axis</source>
        <translation>モジュロ軸でない</translation>
    </message>
    <message>
        <source>Grid of the table</source>
        <translation>テーブルの格子</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>格子点</translation>
    </message>
    <message>
        <source>Positions of the table, always evenly spaced</source>
        <translation>テーブルの位置 (常に等間隔)</translation>
    </message>
    <message>
        <source>those measured, where even</source>
        <translation>測定位置 (等間隔の場合)</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>点数で指定</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>間隔で指定</translation>
    </message>
    <message>
        <source>the fewest points for a deviation</source>
        <translation>許容偏差以内で最少</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Whole numbers from 2 on: one for all axes, or 41; 31</source>
        <translation>2 以上の整数。全軸共通の数値 1 つ、または 41; 31 のように指定</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions: one for all axes, or 10; 5</source>
        <translation>0 より大きい数値 (位置の単位)。全軸共通の数値 1 つ、または 10; 5 のように指定</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions</source>
        <translation>0 より大きい数値 (位置の単位)</translation>
    </message>
    <message>
        <source>Hold ends beyond the targets</source>
        <translation>目標位置の外で端点値を保持</translation>
    </message>
    <message>
        <source>The grid may go beyond the targets, where the end values are held</source>
        <translation>格子を目標位置の外まで広げることを許容します。そこでは端点値を保持します</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>ゼロ点、傾き、ドリフト</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>ゼロ点</translation>
    </message>
    <message>
        <source>Where the table is 0: the zero of the instrument is arbitrary</source>
        <translation>テーブルが 0 になる位置。測定器のゼロ点は任意です</translation>
    </message>
    <message>
        <source>home, else first target</source>
        <translation>原点 (不明なら最初の目標位置)</translation>
    </message>
    <message>
        <source>at the home position</source>
        <translation>原点位置</translation>
    </message>
    <message>
        <source>at the first target</source>
        <translation>最初の目標位置</translation>
    </message>
    <message>
        <source>mean of the values</source>
        <translation>値の平均</translation>
    </message>
    <message>
        <source>at a position</source>
        <translation>位置を指定</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>測定値のまま</translation>
    </message>
    <message>
        <source>At</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>The position of the zero, one number for each axis</source>
        <translation>ゼロ点の位置 (軸ごとに数値 1 つ)</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>The home position of the axis</source>
        <translation>軸の原点位置</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>It is taken out of straightness alone: scale error is real</source>
        <translation>傾きを除去するのは真直度だけです。スケール誤差は実際の誤差です</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>除去しない</translation>
    </message>
    <message>
        <source>taken out by least squares</source>
        <translation>最小二乗で除去</translation>
    </message>
    <message>
        <source>taken out by the ends</source>
        <translation>両端で除去</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ドリフト</translation>
    </message>
    <message>
        <source>What is taken out of runs that lie beside each other before the table is made</source>
        <translation>テーブルを作成する前に、互いにずれた走行から除去するもの</translation>
    </message>
    <message>
        <source>offset of each run taken out</source>
        <translation>走行ごとのオフセットを除去</translation>
    </message>
    <message>
        <source>trend taken out</source>
        <translation>トレンドを除去</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>置き方</translation>
    </message>
    <message>
        <source>alignment, lines along %1 level</source>
        <translation>置き方 (%1 に沿う線の傾きを 0 に)</translation>
    </message>
    <message>
        <source>alignment and scale</source>
        <translation>置き方と倍率</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>除去</translation>
    </message>
    <message>
        <source>How the artefact lay is no error of the machine</source>
        <translation>標準器の置き方は機械の誤差ではありません</translation>
    </message>
    <message>
        <source>Far points</source>
        <translation>離れた点</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one</source>
        <translation>どの測定点からも離れた格子点</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>許容しない</translation>
    </message>
    <message>
        <source>filled smoothly</source>
        <translation>滑らかに補填</translation>
    </message>
    <message>
        <source>filled with the nearest</source>
        <translation>最近傍点で補填</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>ロバスト</translation>
    </message>
    <message>
        <source>Values that do not fit the others count less</source>
        <translation>ほかの値と合わない値の重みを下げます</translation>
    </message>
    <message>
        <source>The axis has another table since that was said: say it anew.</source>
        <translation>指定した後に軸のテーブルが変わりました。もう一度指定してください。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitOutcome</name>
    <message>
        <source>fit of %1</source>
        <translation>%1 のフィッティング</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPage</name>
    <message>
        <source>Merge onto</source>
        <translation>統合先</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>測定時の補正</translation>
    </message>
    <message>
        <source>An earlier table; a new one is being made …</source>
        <translation>以前のテーブルです。新しいテーブルを作成中 …</translation>
    </message>
    <message>
        <source>The table is being made …</source>
        <translation>テーブルを作成中 …</translation>
    </message>
    <message>
        <source>Table and measurement</source>
        <translation>テーブルと測定</translation>
    </message>
    <message>
        <source>No table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>There is no table yet</source>
        <translation>まだテーブルがありません</translation>
    </message>
    <message>
        <source>Take the table over to Write, as if it had been read from a file</source>
        <translation>ファイルから読み取ったテーブルと同様に、[書き込み] に引き継ぎます</translation>
    </message>
    <message>
        <source>As a file of the drive or of another controller</source>
        <translation>ドライブまたは別のコントローラのファイルとして保存します</translation>
    </message>
    <message>
        <source>Add the files of a measurement on Measure; here a table is made of it.</source>
        <translation>[測定] で測定ファイルを追加してください。ここでテーブルを作成します。</translation>
    </message>
    <message>
        <source>The files on Measure cannot be used.</source>
        <translation>[測定] のファイルは使用できません。</translation>
    </message>
    <message>
        <source>Choose where the drive looks its table up: it decides where the values belong.</source>
        <translation>ドライブがテーブルを参照する位置を選んでください。値をどの位置に割り当てるかが決まります。</translation>
    </message>
    <message>
        <source>Read the warnings; then the table can be used: it is taken over to Write.</source>
        <translation>警告を確認してください。その後テーブルを使用でき、[書き込み] に引き継がれます。</translation>
    </message>
    <message>
        <source>The table can be used: it is taken over to Write, where nothing is written before you say so.</source>
        <translation>テーブルを使用できます。[書き込み] に引き継がれますが、指示するまで何も書き込まれません。</translation>
    </message>
    <message>
        <source>Use as Table</source>
        <translation>テーブルとして使う</translation>
    </message>
    <message>
        <source>Save Table…</source>
        <translation>テーブルを保存…</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Which column of the points is shown and used</source>
        <translation>表示および使用する、点の列</translation>
    </message>
    <message>
        <source>The table corrects axis %1, and the current axis is %2: it is refused there. Choose the axis that was measured.</source>
        <translation>テーブルは軸 %1 を補正しますが、現在の軸は %2 のため、書き込みで拒否されます。測定した軸を選んでください。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPlot</name>
    <message>
        <source>compensation [%1]</source>
        <translation>補正値 [%1]</translation>
    </message>
    <message>
        <source>remains [%1]</source>
        <translation>残差 [%1]</translation>
    </message>
    <message>
        <source>table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>measured, with its standard error</source>
        <translation>測定値 (標準誤差付き)</translation>
    </message>
    <message>
        <source>foretold without the target</source>
        <translation>その目標位置を使わない予測</translation>
    </message>
    <message>
        <source>Picture of the fit</source>
        <translation>フィッティングの図</translation>
    </message>
    <message>
        <source>The table over what was measured, and what remains. Left and right go from point to point; the wheel and + and - zoom, Home shows all.</source>
        <translation>測定値に重ねたテーブルと残差。左右キーで点の間を移動、ホイールと + / - で拡大縮小、Home で全体表示です。</translation>
    </message>
    <message>
        <source>%1: measured %2 ± %3, %4 remains</source>
        <translation>%1: 測定値 %2 ± %3、残差 %4</translation>
    </message>
    <message>
        <source>%1: measured %2, %3 remains</source>
        <translation>%1: 測定値 %2、残差 %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitResults</name>
    <message>
        <source>Largest correction: %1 at %2.</source>
        <translation>最大の補正量: %2 で %1。</translation>
    </message>
    <message>
        <source>What remains, rms</source>
        <translation>残差の rms</translation>
    </message>
    <message>
        <source>What remains, largest</source>
        <translation>残差の最大値</translation>
    </message>
    <message>
        <source>Figure [%1]</source>
        <translation>特性値 [%1]</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>補正前</translation>
    </message>
    <message>
        <source>At the targets</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>未使用点</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>警告: %1</translation>
    </message>
    <message>
        <source>%1: foretold %2, tolerance %3: %4.</source>
        <translation>%1: 予測 %2、許容値 %3: %4。</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>Table %1: %2; CRC %3.</source>
        <translation>テーブル %1: %2、CRC %3。</translation>
    </message>
    <message>
        <source>Looked up at the encoder&apos;s position, before the compensation.</source>
        <translation>補正前のエンコーダ位置で参照。</translation>
    </message>
    <message>
        <source>Looked up at the set position, after the compensation.</source>
        <translation>補正後の指令位置で参照。</translation>
    </message>
    <message>
        <source>Smoothness %1.</source>
        <translation>平滑度 %1。</translation>
    </message>
    <message>
        <source>Points of the grid that were filled: %1 of %2.</source>
        <translation>補填した格子点: %2 点中 %1 点。</translation>
    </message>
    <message>
        <source>Held out: each target foretold without it, which is the one to believe between the targets.</source>
        <translation>未使用点: 各目標位置をそれ自身を使わずに予測した値。目標位置の間で信頼できるのはこの値です。</translation>
    </message>
    <message>
        <source>Figures before and foretold</source>
        <translation>補正前と予測の特性値</translation>
    </message>
    <message>
        <source>Before the table is used</source>
        <translation>テーブルを使う前の注意</translation>
    </message>
    <message>
        <source>%1, held out %2</source>
        <translation>%1 (未使用点 %2)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ForeignChange</name>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive: the compensation is off. Home the axis and activate again.</source>
        <translation>ドライブの再起動などにより軸の原点復帰状態が失われ、補正はオフです。軸を原点復帰させてから、もう一度有効化してください。</translation>
    </message>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive.</source>
        <translation>ドライブの再起動などにより、軸の原点復帰状態が失われました。</translation>
    </message>
    <message>
        <source>The compensation is off: something other than this window has switched it off.</source>
        <translation>補正がオフです。このウィンドウ以外からオフにされました。</translation>
    </message>
    <message>
        <source>The compensation is on: something other than this window has switched it on.</source>
        <translation>補正がオンです。このウィンドウ以外からオンにされました。</translation>
    </message>
    <message>
        <source>The axis has no table any more.</source>
        <translation>軸のテーブルがなくなりました。</translation>
    </message>
    <message>
        <source>dimensionality</source>
        <translation>次元数</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>ソース %1</translation>
    </message>
    <message>
        <source>table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>Its volatile table is gone: write it again, as a persistent one if it has to outlast a restart.</source>
        <translation>揮発のテーブルが失われました。もう一度書き込んでください。再起動後も残す必要がある場合は、不揮発で書き込んでください。</translation>
    </message>
    <message>
        <source>The settings of this axis on the drive have changed, and not by this window: %1.</source>
        <translation>ドライブのこの軸の設定が、このウィンドウ以外によって変わりました: %1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>ユーザガイド</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>ユーザガイド</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportConfigurationDialog</name>
    <message>
        <source>Import TAM Configuration</source>
        <translation>TAM 構成のインポート</translation>
    </message>
    <message>
        <source>Writes the table and source parameters in %1 to the axes of %2, one after the other. The tables themselves must be on the drive. Each write makes a backup and is verified; no compensation is switched on.</source>
        <translation>%1 のテーブルとソースのパラメータを、%2 の各軸に順に書き込みます。テーブル自体はドライブに必要です。書き込みごとにバックアップを作成し、照合します。補正をオンにすることはありません。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportDialog</name>
    <message>
        <source>Import Compensation Data</source>
        <translation>補正データのインポート</translation>
    </message>
    <message>
        <source>Choose how to read %1. The result is the table that the drive adds to the encoder position, on an even grid.</source>
        <translation>%1 の読み取り方法を選んでください。結果は、ドライブがエンコーダ位置に加算する等間隔格子のテーブルです。</translation>
    </message>
    <message>
        <source>I&amp;mport</source>
        <translation>インポート(&amp;M)</translation>
    </message>
    <message>
        <source>Use the file with these choices; nothing is written to the drive yet</source>
        <translation>この設定でファイルを使います。まだドライブには何も書き込みません</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>行 %1: </translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgePage</name>
    <message>
        <source>Tolerances, and the uncertainty U (k = 2)</source>
        <translation>許容値と不確かさ U (k = 2)</translation>
    </message>
    <message>
        <source>All &amp;values</source>
        <translation>全データ(&amp;V)</translation>
    </message>
    <message>
        <source>Show plot and targets as if nothing were excluded</source>
        <translation>除外がないものとして図と目標位置を表示します</translation>
    </message>
    <message>
        <source>&amp;Corrections…</source>
        <translation>測定値の補正(&amp;C)…</translation>
    </message>
    <message>
        <source>Bring the values to 20 °C, or correct them for the dead path of an interferometer</source>
        <translation>値の 20 °C への換算、または干渉計のデッドパスの補正を行います</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ドリフト</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>図</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>特性値</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>Drift in numbers</source>
        <translation>ドリフトの数値</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Warnings (%1)</source>
        <translation>警告 (%1)</translation>
    </message>
    <message>
        <source>No corrections.</source>
        <translation>測定値の補正はありません。</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014</source>
        <translation>ISO 230-2:2014 の特性値</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgeWarningsModel</name>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LimitFields</name>
    <message>
        <source>The largest value that is allowed, such as 10 µm; empty: no tolerance</source>
        <translation>許容する最大値 (例: 10 µm)。空欄: 許容値なし</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2, such as 2.1 µm; empty: not stated</source>
        <translation>測定の不確かさ (k = 2、例: 2.1 µm)。空欄: 記載なし</translation>
    </message>
    <message>
        <source>Tolerance: %1</source>
        <translation>許容値: %1</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>不確かさ U、k = 2</translation>
    </message>
    <message>
        <source>&amp;Accuracy A</source>
        <translation>正確さ A(&amp;A)</translation>
    </message>
    <message>
        <source>Systematic &amp;E</source>
        <translation>系統偏差 E(&amp;E)</translation>
    </message>
    <message>
        <source>Range of means &amp;M</source>
        <translation>平均偏差の範囲 M(&amp;M)</translation>
    </message>
    <message>
        <source>Reversal &amp;B</source>
        <translation>反転値 B(&amp;B)</translation>
    </message>
    <message>
        <source>Repeatab&amp;ility R</source>
        <translation>繰返し性 R(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Uncertainty U</source>
        <translation>不確かさ U(&amp;U)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LogView</name>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Copy the selected lines, or all of them</source>
        <translation>選択した行、またはすべての行をコピーします</translation>
    </message>
    <message>
        <source>Save the log to a file</source>
        <translation>ログをファイルに保存します</translation>
    </message>
    <message>
        <source>Hide the log</source>
        <translation>ログを隠します</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineActions</name>
    <message>
        <source>Open Machine File</source>
        <translation>機械ファイルを開く</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>機械ファイル (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineApplication</name>
    <message>
        <source>All drives already had what %1 says; nothing was written.</source>
        <translation>すべてのドライブがすでに %1 と同じ内容です。何も書き込んでいません。</translation>
    </message>
    <message>
        <source>%1 is applied.</source>
        <translation>%1 を適用しました。</translation>
    </message>
    <message>
        <source>%1 is not applied as a whole: %2</source>
        <translation>%1 の一部が適用されていません: %2</translation>
    </message>
    <message>
        <source>Failed: %1.</source>
        <translation>失敗: %1。</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>書き込み・照合済み: %1。</translation>
    </message>
    <message>
        <source>Not written: %1.</source>
        <translation>書き込みなし: %1。</translation>
    </message>
    <message>
        <source>Applying it again does the rest.</source>
        <translation>もう一度適用すると、残りが処理されます。</translation>
    </message>
    <message>
        <source>%1: %2; it holds: %3.</source>
        <comment>axis, what became of it, and its table</comment>
        <translation>%1: %2。現在の内容: %3。</translation>
    </message>
    <message>
        <source>%1: %2; what it holds is not known.</source>
        <comment>axis, and what became of it</comment>
        <translation>%1: %2。現在の内容は不明です。</translation>
    </message>
    <message>
        <source>Begin: applying the machine file %1.</source>
        <translation>開始: 機械ファイル %1 の適用。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Switched: %1.</source>
        <translation>切り替え済み: %1。</translation>
    </message>
    <message>
        <source>Not switched: %1.</source>
        <translation>切り替えなし: %1。</translation>
    </message>
    <message>
        <source>Not proved: %1.</source>
        <translation>未検証: %1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineController</name>
    <message>
        <source>No machine file is open.</source>
        <translation>機械ファイルが開かれていません。</translation>
    </message>
    <message>
        <source>The machine file is being read.</source>
        <translation>機械ファイルを読み取り中です。</translation>
    </message>
    <message>
        <source>The machine file is being applied.</source>
        <translation>機械ファイルを適用中です。</translation>
    </message>
    <message>
        <source>Wait for the end of the current operation.</source>
        <translation>現在の処理が終わるまで待ってください。</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>ドライブを比較中です。</translation>
    </message>
    <message>
        <source>Not all drives of the file are among the connections.</source>
        <translation>ファイルのドライブのうち、接続にないものがあります。</translation>
    </message>
    <message>
        <source>Nothing is written while something stands in the way of a part of it.</source>
        <translation>一部にでも支障がある間は、何も書き込みません。</translation>
    </message>
    <message>
        <source>All drives have what the file says.</source>
        <translation>すべてのドライブがファイルと同じ内容です。</translation>
    </message>
    <message>
        <source>No drive of the file answers.</source>
        <translation>ファイルのドライブはどれも応答しません。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachinePane</name>
    <message>
        <source>&amp;Plan Again</source>
        <translation>再計画(&amp;P)</translation>
    </message>
    <message>
        <source>Reads the machine file and its tables again and compares all drives with them</source>
        <translation>機械ファイルとそのテーブルを読み取り直し、すべてのドライブと比較します</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>適用(&amp;A)…</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>書き込む前に、すべてのドライブに書き込む内容を表示します</translation>
    </message>
    <message>
        <source>Close Machine &amp;File</source>
        <translation>機械ファイルを閉じる(&amp;F)</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>ドライブの接続は続き、何も変更されません</translation>
    </message>
    <message>
        <source>Problems of the machine file</source>
        <translation>機械ファイルの問題</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 を読み取り中 …</translation>
    </message>
    <message>
        <source>as the file says: %1</source>
        <comment>number of axes</comment>
        <translation>ファイルと同じ: %1</translation>
    </message>
    <message>
        <source>differ: %1</source>
        <comment>number of axes</comment>
        <translation>相違: %1</translation>
    </message>
    <message>
        <source>cannot be compared: %1</source>
        <comment>number of axes</comment>
        <translation>比較できない: %1</translation>
    </message>
    <message>
        <source>not reachable: %1</source>
        <comment>number of axes</comment>
        <translation>接続できない: %1</translation>
    </message>
    <message>
        <source>not among the connections: %1</source>
        <comment>number of axes</comment>
        <translation>接続にない: %1</translation>
    </message>
    <message>
        <source>not compared yet: %1</source>
        <comment>number of axes</comment>
        <translation>未比較: %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>file and machine</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: axes %2.</source>
        <comment>machine file and numbers of axes</comment>
        <translation>%1: 軸 %2。</translation>
    </message>
    <message>
        <source>Compared at %1.</source>
        <translation>%1 に比較。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and what is wrong</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>このドライブは接続から外れています。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurePage</name>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Save as Runs…</source>
        <translation>走行データとして保存(&amp;S)…</translation>
    </message>
    <message>
        <source>All files as one CSV file, with what is excluded marked in it</source>
        <translation>すべてのファイルを 1 つの CSV ファイルにします。除外には印が付きます</translation>
    </message>
    <message>
        <source>Files of the measurement</source>
        <translation>測定のファイル</translation>
    </message>
    <message>
        <source>Values of all files</source>
        <translation>全ファイルの値</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>ファイルを読み取り中 …</translation>
    </message>
    <message>
        <source>Take the values of a plan while something else moves the axis</source>
        <translation>このプログラム以外が軸を動かす間に、測定計画の値を取り込みます</translation>
    </message>
    <message>
        <source>New &amp;Program…</source>
        <translation>新規プログラム(&amp;P)…</translation>
    </message>
    <message>
        <source>Plan the targets of a measurement, and a program for the control of the machine</source>
        <translation>測定の目標位置を計画し、機械の NC 装置のプログラムを作成します</translation>
    </message>
    <message>
        <source>Cap&amp;ture…</source>
        <translation>測定値の取り込み(&amp;T)…</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>取り込み</translation>
    </message>
    <message>
        <source>Add the files of a measurement, take its values with Capture, or go on to Write with a table that is there.</source>
        <translation>測定ファイルを追加するか、[測定値の取り込み] で値を取り込んでください。既存のテーブルがある場合は [書き込み] に進んでください。</translation>
    </message>
    <message>
        <source>Saved as %1. Judge says what it is worth, and Fit makes a table of it.</source>
        <translation>%1 に保存しました。[判定] で測定を評価し、[フィッティング] でテーブルを作成します。</translation>
    </message>
    <message>
        <source>Without targets there are no figures of ISO 230-2; Fit makes a table of it.</source>
        <translation>目標位置がないと ISO 230-2 の特性値は求められません。[フィッティング] でテーブルを作成します。</translation>
    </message>
    <message>
        <source>The measurement can be used. Go on to Judge and Fit.</source>
        <translation>測定を使用できます。[判定] と [フィッティング] に進んでください。</translation>
    </message>
    <message>
        <source>%1 was captured for the record that was open before, and is not added to this one.</source>
        <translation>%1 は前に開いていた記録のために取り込んだもので、この記録には追加されません。</translation>
    </message>
    <message>
        <source>Saved as %1 with the values of the files: the corrections are not in it.</source>
        <translation>%1 にファイルの値のまま保存しました。測定値の補正は含まれていません。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFiles</name>
    <message>
        <source>&amp;Add…</source>
        <translation>追加(&amp;A)…</translation>
    </message>
    <message>
        <source>Add files of a measurement; they can also be dropped here (Ctrl+O)</source>
        <translation>測定ファイルを追加します。ここへのドロップもできます (Ctrl+O)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>削除(&amp;M)</translation>
    </message>
    <message>
        <source>Take the selected file out of the measurement (Del)</source>
        <translation>選択したファイルを測定から外します (Del)</translation>
    </message>
    <message>
        <source>E&amp;xchange up and down in all files</source>
        <translation>全ファイルで正方向と負方向を入れ替え(&amp;X)</translation>
    </message>
    <message>
        <source>For files that name the directions the other way round</source>
        <translation>方向の表記が逆のファイルの場合</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFilesModel</name>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>オン</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>記載なし</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>使用できません</translation>
    </message>
    <message>
        <source>warnings: %1</source>
        <translation>警告: %1</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>samples: %1</source>
        <translation>サンプル: %1</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>点: %1</translation>
    </message>
    <message>
        <source>means</source>
        <translation>平均値</translation>
    </message>
    <message>
        <source>%1 up, %2 down</source>
        <translation>正方向 %1、負方向 %2</translation>
    </message>
    <message>
        <source>being read …</source>
        <translation>読み取り中 …</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>補正</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>%1, as the record holds it</source>
        <translation>%1 (記録の内容)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasuringActions</name>
    <message>
        <source>Values are being captured: stop that first</source>
        <translation>測定値を取り込み中です。先に終了してください</translation>
    </message>
    <message>
        <source>Choose a drive and an axis first</source>
        <translation>先にドライブと軸を選んでください</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessagePresenter</name>
    <message>
        <source>This is the built-in demo drive. Try everything; no real drive is affected.</source>
        <translation>内蔵のデモドライブです。すべての操作を試せます。実際のドライブには影響しません。</translation>
    </message>
    <message>
        <source>Wor&amp;k with Real Drives…</source>
        <translation>実際のドライブを使う(&amp;K)…</translation>
    </message>
    <message>
        <source>%1 Your changes are kept; reconnecting …</source>
        <translation>%1 変更は保持されています。再接続中 …</translation>
    </message>
    <message>
        <source>%1 Reconnecting …</source>
        <translation>%1 再接続中 …</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>%1 がディスク上で変更されました。</translation>
    </message>
    <message>
        <source>Read A&amp;gain</source>
        <translation>再読み取り(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Finish Write</source>
        <translation>書き込みを完了(&amp;F)</translation>
    </message>
    <message>
        <source>Undo Wri&amp;te</source>
        <translation>書き込みを取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keep for Later</source>
        <translation>後で決める(&amp;K)</translation>
    </message>
    <message>
        <source>S&amp;how Certificate…</source>
        <translation>証明書を表示(&amp;H)…</translation>
    </message>
    <message>
        <source>%1 is being asked …</source>
        <translation>%1 に問い合わせ中 …</translation>
    </message>
    <message>
        <source>%1 has no axis with compensation registers.</source>
        <translation>%1 に補正レジスタのある軸がありません。</translation>
    </message>
    <message>
        <source>%1 does not answer. %2</source>
        <comment>drive, reason</comment>
        <translation>%1 が応答しません。%2</translation>
    </message>
    <message>
        <source>Tr&amp;y Again</source>
        <translation>再試行(&amp;Y)</translation>
    </message>
    <message>
        <source>%1 answers now.</source>
        <translation>%1 が応答しました。</translation>
    </message>
    <message>
        <source>Displa&amp;y Drive</source>
        <translation>ドライブを表示(&amp;Y)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessageStack</name>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じます</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisController</name>
    <message>
        <source>The writes have not been planned yet.</source>
        <translation>書き込みがまだ計画されていません。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisDialog</name>
    <message>
        <source>Write Several Axes</source>
        <translation>複数軸の書き込み</translation>
    </message>
    <message>
        <source>Writes columns of %1 to axes of %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified.</source>
        <translation>%1 の列を %2 の各軸に順に書き込みます。最初の書き込みの前に、すべての書き込みを確認します。書き込みごとにバックアップを作成し、照合します。</translation>
    </message>
    <message>
        <source>&amp;Sources</source>
        <translation>ソース(&amp;S)</translation>
    </message>
    <message>
        <source>Each axis keeps its sources</source>
        <translation>各軸の現在のソースを維持</translation>
    </message>
    <message>
        <source>The registers that supply the positions for the tables</source>
        <translation>テーブルの位置を供給するレジスタ</translation>
    </message>
    <message>
        <source>The same for all, as on the page: %1</source>
        <translation>全軸共通、ページの設定: %1</translation>
    </message>
    <message>
        <source>Persistent, as on the page: all tables are stored in flash.</source>
        <translation>不揮発 (ページの設定): すべてのテーブルをフラッシュに保存します。</translation>
    </message>
    <message>
        <source>Volatile, as on the page: a reboot of the drive restores the stored state.</source>
        <translation>揮発 (ページの設定): ドライブを再起動すると、保存されている状態に戻ります。</translation>
    </message>
    <message>
        <source>Each axis its own position</source>
        <translation>各軸自身の位置</translation>
    </message>
    <message>
        <source>No register is known for the position of %1: select other sources.</source>
        <translation>%1 の位置のレジスタが分かりません。ほかのソースを選んでください。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisOutcome</name>
    <message>
        <source>The writes were stopped.</source>
        <translation>書き込みを中止しました。</translation>
    </message>
    <message>
        <source>The writes were stopped at %1.</source>
        <translation>%1 で書き込みを中止しました。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and sentence</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No axis was changed.</source>
        <translation>変更された軸はありません。</translation>
    </message>
    <message>
        <source>New state: %1.</source>
        <translation>新状態: %1。</translation>
    </message>
    <message>
        <source>Old state, complete: %1.</source>
        <translation>完全な旧状態: %1。</translation>
    </message>
    <message>
        <source>%1 The tables that no axis uses are not all restored: %2</source>
        <translation>%1 どの軸も使用していないテーブルの一部が復元されていません: %2</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>書き込み・照合済み: %1。</translation>
    </message>
    <message>
        <source>This is stored in flash.</source>
        <translation>フラッシュに保存されています。</translation>
    </message>
    <message>
        <source>This is volatile: a reboot of the drive restores the stored state.</source>
        <translation>揮発です。ドライブを再起動すると、保存されている状態に戻ります。</translation>
    </message>
    <message>
        <source>Stored in flash: %1.</source>
        <translation>フラッシュに保存: %1。</translation>
    </message>
    <message>
        <source>Volatile: %1; a reboot of the drive restores the stored state.</source>
        <translation>揮発: %1。ドライブを再起動すると、保存されている状態に戻ります。</translation>
    </message>
    <message>
        <source>The axes already had all of this.</source>
        <translation>各軸の内容はすでに同じでした。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisPlanView</name>
    <message>
        <source>persistent</source>
        <translation>不揮発</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>揮発</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>%1D in %2, %3</source>
        <translation>%1D、%2、%3</translation>
    </message>
    <message>
        <source>nothing: the drive already has all of this</source>
        <translation>なし: ドライブの内容はすでに同じです</translation>
    </message>
    <message>
        <source>%1 (empty)</source>
        <translation>%1 (空)</translation>
    </message>
    <message>
        <source>%1 (held an earlier table of this axis)</source>
        <translation>%1 (この軸の以前のテーブル)</translation>
    </message>
    <message>
        <source>%1 (will be overwritten)</source>
        <translation>%1 (上書き)</translation>
    </message>
    <message>
        <source>Dim%1: %2</source>
        <translation>Dim%1: %2</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>スロット</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>書き込む内容</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>フラッシュ操作を使いません。</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>フラッシュ操作の合計: %1。</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>フラッシュ操作: %1 回使用、直後の残り %2 回。</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>大きな補正量は正しい: 単位を確認済み(&amp;R)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberEdit</name>
    <message>
        <source>%1: &quot;%2&quot; cannot be taken. %3</source>
        <translation>%1: &quot;%2&quot; は使えません。%3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OperationRunner</name>
    <message>
        <source>Begin: %1, %2.</source>
        <comment>task and drive</comment>
        <translation>開始: %1、%2。</translation>
    </message>
    <message>
        <source>Begin: %1 %2.</source>
        <translation>開始: %1 %2。</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>task, axis and step</comment>
        <translation>%1: %2、%3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: stopping</source>
        <translation>%1: 停止処理中</translation>
    </message>
    <message>
        <source>The fields were changed while the write was planned: write again.</source>
        <translation>書き込みの計画中に欄が変更されました。もう一度書き込んでください。</translation>
    </message>
    <message>
        <source>The drive or the fields have changed since the write was planned: write again.</source>
        <translation>書き込みの計画後にドライブまたは欄が変更されました。もう一度書き込んでください。</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>ユーザが中止しました。</translation>
    </message>
    <message>
        <source>Wrote %1: axes: %2, tables: %3.</source>
        <translation>%1 に書き出しました: 軸 %2、テーブル %3。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::Outcome</name>
    <message>
        <source>The drive holds the complete old state.</source>
        <translation>ドライブは完全な旧状態です。</translation>
    </message>
    <message>
        <source>It is stored in flash.</source>
        <translation>フラッシュに保存されています。</translation>
    </message>
    <message>
        <source>It is volatile: a reboot of the drive restores the stored state.</source>
        <translation>揮発です。ドライブを再起動すると、保存されている状態に戻ります。</translation>
    </message>
    <message>
        <source>Written and verified: the drive holds the new state. %1</source>
        <translation>書き込み・照合済み: ドライブは新状態です。%1</translation>
    </message>
    <message>
        <source>Nothing to write: the drive already has all of this.</source>
        <translation>書き込むものはありません。ドライブの内容はすでに同じです。</translation>
    </message>
    <message>
        <source>The write was stopped.</source>
        <translation>書き込みを中止しました。</translation>
    </message>
    <message>
        <source>The compensation is off.</source>
        <translation>補正はオフです。</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>補正は有効です。</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>補正は試算中です。ドライブは何も加算しません。</translation>
    </message>
    <message>
        <source>The proof was stopped.</source>
        <translation>検証を中止しました。</translation>
    </message>
    <message>
        <source>%1 But the proof failed: deactivate it unless you know why. %2</source>
        <translation>%1 ただし、検証は不合格です。原因が分からない場合は無効化してください。%2</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state from before the write of %1.</source>
        <translation>復元済み: ドライブは %1 の書き込み前の状態です。</translation>
    </message>
    <message>
        <source>The drive holds the complete new state; nothing more to do.</source>
        <translation>ドライブは完全な新状態です。ほかに必要な処理はありません。</translation>
    </message>
    <message>
        <source>The write of %1 was interrupted (last step: %2). %3</source>
        <translation>%1 の書き込みが中断されました (最後の手順: %2)。%3</translation>
    </message>
    <message>
        <source>%1 The write is still unfinished.</source>
        <translation>%1 書き込みはまだ未完了です。</translation>
    </message>
    <message>
        <source>Finished and verified: the drive holds the complete new state.</source>
        <translation>完了・照合済み: ドライブは完全な新状態です。</translation>
    </message>
    <message>
        <source>Undone and verified: the drive holds the complete old state.</source>
        <translation>取り消し・照合済み: ドライブは完全な旧状態です。</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved.</source>
        <translation>ドライブは完全な新状態ですが、パラメータが保存されていない可能性があります。</translation>
    </message>
    <message>
        <source>The drive holds neither the old nor the new state: finish or undo the write before activating the axis.</source>
        <translation>ドライブは旧状態でも新状態でもありません。軸を有効化する前に、書き込みを完了するか取り消してください。</translation>
    </message>
    <message>
        <source>Not proved.</source>
        <translation>未検証です。</translation>
    </message>
    <message>
        <source>The proof failed, and the drive evaluates again as before. %1</source>
        <translation>検証は不合格で、ドライブは試算に戻りました。%1</translation>
    </message>
    <message>
        <source>The proof failed, and the compensation was switched off again. %1</source>
        <translation>検証は不合格で、補正を再びオフにしました。%1</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>何も書き込んでいません。</translation>
    </message>
    <message>
        <source>Deleted and verified: %1 is empty, and the axis uses no table.</source>
        <translation>削除・照合済み: %1 は空で、軸はテーブルを使用していません。</translation>
    </message>
    <message>
        <source>Proved over %1 of the table: largest difference %2.</source>
        <translation>テーブルの %1 で検証済み: 最大差 %2。</translation>
    </message>
    <message>
        <source>Its table indices are right.</source>
        <translation>テーブルのインデックスは正しい値です。</translation>
    </message>
    <message>
        <source>The compensation is active, but the drive contradicts its table. Stop the axis and deactivate. %1</source>
        <translation>補正は有効ですが、ドライブの動作がテーブルと一致しません。軸を停止し、無効化してください。%1</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1, made of the drive with the serial number %2.</source>
        <translation>復元済み: ドライブは %1 のバックアップファイルの状態です。このファイルはシリアル番号 %2 のドライブのものです。</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1.</source>
        <translation>復元済み: ドライブは %1 のバックアップファイルの状態です。</translation>
    </message>
    <message>
        <source>The compensation may be on, and is not proved. Connect again to see what it does.</source>
        <translation>補正がオンになっている可能性があり、検証されていません。再接続して状態を確認してください。</translation>
    </message>
    <message>
        <source>Which state the drive holds is not known, since the backup of the old one cannot be read: write again or restore another backup before activating the axis.</source>
        <translation>旧状態のバックアップを読み取れないため、ドライブがどの状態かは不明です。軸を有効化する前に、もう一度書き込むか、別のバックアップを復元してください。</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved, and the backup of the old state cannot be read: write again to save them, or restore another backup.</source>
        <translation>ドライブは完全な新状態ですが、パラメータが保存されていない可能性があり、旧状態のバックアップを読み取れません。もう一度書き込んで保存するか、別のバックアップを復元してください。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutlierList</name>
    <message>
        <source>&amp;Outliers by</source>
        <translation>外れ値の判定(&amp;O)</translation>
    </message>
    <message>
        <source>pooled MAD, limit 4</source>
        <translation>プール MAD、限界 4</translation>
    </message>
    <message>
        <source>Grubbs, 5 %</source>
        <translation>Grubbs、5 %</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>判定なし</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>外れ値の判定規則</translation>
    </message>
    <message>
        <source>How values that do not fit the others are found; a proposal, nothing is left out by it</source>
        <translation>ほかの値と合わない値の見つけ方。提案だけで、自動的な除外はしません</translation>
    </message>
    <message>
        <source>Proposed for exclusion, and excluded</source>
        <translation>除外の提案と除外した値</translation>
    </message>
    <message>
        <source>Exclude All &amp;Proposed</source>
        <translation>提案をすべて除外(&amp;P)</translation>
    </message>
    <message>
        <source>Leave out every value that the rule proposes</source>
        <translation>規則が提案したすべての値を除外します</translation>
    </message>
    <message>
        <source>E&amp;xclude</source>
        <translation>除外(&amp;X)</translation>
    </message>
    <message>
        <source>Leave out the value, run or target that is selected in list, plot or table (Del)</source>
        <translation>一覧、図または表で選択した値、走行または目標位置を除外します (Del)</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>除外を解除(&amp;G)</translation>
    </message>
    <message>
        <source>Use what is selected again</source>
        <translation>選択したものの除外を解除します</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutliersModel</name>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>スコア</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>both</source>
        <translation>両方向</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>提案</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewDialog</name>
    <message>
        <source>Overview of All Axes</source>
        <translation>全軸の一覧</translation>
    </message>
    <message>
        <source>All axes of all drives</source>
        <translation>全ドライブの全軸</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all of them, with the headings for a spreadsheet</source>
        <translation>選択した行またはすべての行を、表計算用に見出し付きでコピーします</translation>
    </message>
    <message>
        <source>&amp;Go to Axis</source>
        <translation>軸に移動(&amp;G)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close the overview</source>
        <translation>一覧を閉じます</translation>
    </message>
    <message>
        <source>No axis is chosen.</source>
        <translation>軸が選ばれていません。</translation>
    </message>
    <message>
        <source>This drive has not said yet which axes it has.</source>
        <translation>このドライブの軸がまだ分かりません。</translation>
    </message>
    <message>
        <source>Wait for the current operation before choosing another axis.</source>
        <translation>別の軸を選ぶには、現在の処理が終わるまで待ってください。</translation>
    </message>
    <message>
        <source>Show this axis on the page</source>
        <translation>この軸をページに表示します</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewModel</name>
    <message>
        <source>since %1</source>
        <comment>date and time</comment>
        <translation>%1 から</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and column</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>不揮発</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>揮発</translation>
    </message>
    <message>
        <source>not limited</source>
        <comment>flash operations</comment>
        <translation>無制限</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>テーブルと不一致</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>Flash left</source>
        <translation>フラッシュ残り</translation>
    </message>
    <message>
        <source>Last proof</source>
        <translation>最後の検証</translation>
    </message>
    <message>
        <source>Last write</source>
        <translation>最後の書き込み</translation>
    </message>
    <message>
        <source>The drive, and where it is</source>
        <translation>ドライブとそのアドレス</translation>
    </message>
    <message>
        <source>The axis of this drive</source>
        <translation>このドライブの軸</translation>
    </message>
    <message>
        <source>What the compensation does now</source>
        <translation>補正の現在の状態</translation>
    </message>
    <message>
        <source>The table that the axis uses: its file and column where this window has written it, otherwise its place on the drive; and the checksum of its values</source>
        <translation>軸が使用しているテーブル: このウィンドウで書き込んだものはファイルと列、それ以外はドライブのスロット。および値のチェックサム</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>再起動後もテーブルが残るかどうか</translation>
    </message>
    <message>
        <source>How many flash operations the drive can do now</source>
        <translation>ドライブで現在可能なフラッシュ操作の回数</translation>
    </message>
    <message>
        <source>Over which part of the table this window has seen that the drive does what the table says, and when</source>
        <translation>ドライブの動作がテーブルと一致することをこのウィンドウで確認した、テーブルの範囲と日時</translation>
    </message>
    <message>
        <source>When this computer last wrote to the axis</source>
        <translation>このコンピュータが最後に軸に書き込んだ日時</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>接続中 …</translation>
    </message>
    <message>
        <source>no axes</source>
        <translation>軸なし</translation>
    </message>
    <message>
        <source>no compensation</source>
        <translation>補正なし</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>読み取れない</translation>
    </message>
    <message>
        <source>is being read …</source>
        <translation>読み取り中 …</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <comment>address of a drive</comment>
        <translation>%1、シリアル番号 %2</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測定結果</translation>
    </message>
    <message>
        <source>The accuracy of the axis with this table and before, as the records of this computer have it</source>
        <translation>このコンピュータの記録による、このテーブルでの軸の正確さと補正前の正確さ</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>機械ファイル</translation>
    </message>
    <message>
        <source>Whether the axis has what the machine file says, and when it was compared</source>
        <translation>軸が機械ファイルと同じ内容かどうかと、比較した日時</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;System Language</source>
        <translation>システムの言語(&amp;S)</translation>
    </message>
    <message>
        <source>Show &amp;Preview Before Volatile Writes</source>
        <translation>揮発の書き込み前にもプレビューを表示(&amp;P)</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview</source>
        <translation>不揮発の書き込み前には常にプレビューを表示します</translation>
    </message>
    <message>
        <source>Save Lo&amp;g…</source>
        <translation>ログを保存(&amp;G)…</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>バージョン情報(&amp;A)</translation>
    </message>
    <message>
        <source>About</source>
        <translation>バージョン情報</translation>
    </message>
    <message>
        <source>&lt;b&gt;Axis Compensation Wizard&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;軸補正ウィザード&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>Writes error compensation tables to servo drives, activates them and proves that the drive applies them.

A compensation value is reference minus encoder; the drive adds it to the encoder position.

Free software under the GNU General Public License, version 3 or later.</source>
        <translation>サーボドライブに誤差補正テーブルを書き込み、有効化し、ドライブがそれを適用していることを検証します。

補正値は「基準 − エンコーダ」で、ドライブはこれをエンコーダ位置に加算します。

GNU General Public License バージョン 3 以降によるフリーソフトウェアです。</translation>
    </message>
    <message>
        <source>Save the selected table as a file for another controller</source>
        <translation>選択したテーブルを別のコントローラ用のファイルとして保存します</translation>
    </message>
    <message>
        <source>No table is selected.</source>
        <translation>テーブルが選択されていません。</translation>
    </message>
    <message>
        <source>&amp;Export for Another Controller…</source>
        <translation>別のコントローラ用にエクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Write Several Axes…</source>
        <translation>複数軸の書き込み(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Import TAM Configuration…</source>
        <translation>TAM 構成のインポート(&amp;I)…</translation>
    </message>
    <message>
        <source>Export to &amp;TAM Configuration…</source>
        <translation>TAM 構成へのエクスポート(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>元に戻す(&amp;U): %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直し(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>やり直し(&amp;R): %1</translation>
    </message>
    <message>
        <source>Takes the last change of the fields back; the drive is not reached</source>
        <translation>欄の最後の変更を元に戻します。ドライブには影響しません</translation>
    </message>
    <message>
        <source>Makes the change that was undone again</source>
        <translation>元に戻した変更をもう一度行います</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>User &amp;Guide</source>
        <translation>ユーザガイド(&amp;G)</translation>
    </message>
    <message>
        <source>Ba&amp;ck Up Whole Drive…</source>
        <translation>ドライブ全体のバックアップ(&amp;C)…</translation>
    </message>
    <message>
        <source>Restore Whole &amp;Drive…</source>
        <translation>ドライブ全体の復元(&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;Overview of All Axes…</source>
        <translation>全軸の一覧(&amp;O)…</translation>
    </message>
    <message>
        <source>State and table of each axis of all connected drives</source>
        <translation>接続中の全ドライブの各軸の状態とテーブル</translation>
    </message>
    <message>
        <source>No machine file is open.</source>
        <translation>機械ファイルが開かれていません。</translation>
    </message>
    <message>
        <source>Read the machine file again and compare all drives with it</source>
        <translation>機械ファイルを読み取り直し、すべてのドライブと比較します</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>ドライブを比較中です。</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>書き込む前に、すべてのドライブに書き込む内容を表示します</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>ドライブの接続は続き、何も変更されません</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>機械(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Open Machine File…</source>
        <translation>機械ファイルを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Compare all drives of a machine with the file that says which tables they have</source>
        <translation>機械の全ドライブを、テーブルを定めたファイルと比較します</translation>
    </message>
    <message>
        <source>&amp;Plan Again</source>
        <translation>再計画(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>適用(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Save Machine File…</source>
        <translation>機械ファイルを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Running drives as a machine file with all tables, in a folder of your choice</source>
        <translation>稼働中のドライブを、全テーブルを含む機械ファイルとして任意のフォルダに保存します</translation>
    </message>
    <message>
        <source>&amp;Close Machine File</source>
        <translation>機械ファイルを閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Documentation in the &amp;Browser</source>
        <translation>ブラウザでドキュメントを開く(&amp;B)</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>ドキュメント</translation>
    </message>
    <message>
        <source>No browser could be opened. The documentation is in %1.</source>
        <translation>ブラウザを開けませんでした。ドキュメントは %1 にあります。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageTabs</name>
    <message>
        <source>Measure</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書き込み</translation>
    </message>
    <message>
        <source>The files of a measurement, and how they are read</source>
        <translation>測定ファイルとその読み取り方法</translation>
    </message>
    <message>
        <source>Bring a table to the drive, and activate it</source>
        <translation>テーブルをドライブに書き込み、有効化します</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>Parts of the work</source>
        <translation>作業の段階</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Page Up and Ctrl+Page Down change the tab)</source>
        <translation>%1 (Ctrl+Page Up と Ctrl+Page Down でタブを切り替え)</translation>
    </message>
    <message>
        <source>Judge</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>What the measurement says of the axis, against tolerances</source>
        <translation>許容値に対する軸の測定結果</translation>
    </message>
    <message>
        <source>Prove</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>フィッティング</translation>
    </message>
    <message>
        <source>Measure again with the table active, and see what it has brought</source>
        <translation>テーブルを有効にしてもう一度測定し、効果を確認します</translation>
    </message>
    <message>
        <source>The table that is made of a measurement, and what it promises</source>
        <translation>測定から作成したテーブルとその予測</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ParameterExport</name>
    <message>
        <source>Wrote %1: only compensation registers have changed.</source>
        <translation>%1 に書き出しました。変わったのは補正レジスタだけです。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanDialog</name>
    <message>
        <source>New Program</source>
        <translation>新規プログラム</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>個数</translation>
    </message>
    <message>
        <source>Mean spacing</source>
        <translation>平均間隔</translation>
    </message>
    <message>
        <source>Cont&amp;rol</source>
        <translation>NC 装置(&amp;R)</translation>
    </message>
    <message>
        <source>The control of the machine, which plays the program</source>
        <translation>プログラムを実行する機械の NC 装置</translation>
    </message>
    <message>
        <source>Save Pro&amp;gram…</source>
        <translation>プログラムを保存(&amp;G)…</translation>
    </message>
    <message>
        <source>Save &amp;Plan…</source>
        <translation>測定計画を保存(&amp;P)…</translation>
    </message>
    <message>
        <source>Clo&amp;se</source>
        <translation>閉じる(&amp;S)</translation>
    </message>
    <message>
        <source>What was not saved is lost (Esc)</source>
        <translation>保存していないものは失われます (Esc)</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>軸(&amp;X)</translation>
    </message>
    <message>
        <source>As the drive or the control names it</source>
        <translation>ドライブまたは NC 装置での名前</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>単位(&amp;U)</translation>
    </message>
    <message>
        <source>Of all positions of the plan</source>
        <translation>測定計画のすべての位置の単位</translation>
    </message>
    <message>
        <source>&amp;First target</source>
        <translation>最初の目標位置(&amp;F)</translation>
    </message>
    <message>
        <source>Measured in every run</source>
        <translation>毎回の走行で測定します</translation>
    </message>
    <message>
        <source>&amp;Last target</source>
        <translation>最後の目標位置(&amp;L)</translation>
    </message>
    <message>
        <source>Measured in every run; above the first</source>
        <translation>毎回の走行で測定します。最初の目標位置より大きい値</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>目標位置(&amp;T)</translation>
    </message>
    <message>
        <source>How many, or how far apart in the mean</source>
        <translation>個数または平均間隔</translation>
    </message>
    <message>
        <source>&amp;Known period</source>
        <translation>既知の周期(&amp;K)</translation>
    </message>
    <message>
        <source>Of the axis&apos;s error, such as the lead of its screw: targets are spread over it</source>
        <translation>軸の誤差の周期 (ねじのリードなど)。目標位置を周期内に分散させます</translation>
    </message>
    <message>
        <source>&amp;Cycles</source>
        <translation>サイクル(&amp;C)</translation>
    </message>
    <message>
        <source>Runs in each direction; the standard wants five</source>
        <translation>各方向の走行の回数。規格では 5 回</translation>
    </message>
    <message>
        <source>&amp;Overrun</source>
        <translation>オーバーラン(&amp;O)</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target</source>
        <translation>最初の目標位置の手前で、軸が走行の方向に動く距離</translation>
    </message>
    <message>
        <source>F&amp;eed</source>
        <translation>送り速度(&amp;E)</translation>
    </message>
    <message>
        <source>Of the moves in the program</source>
        <translation>プログラムでの移動の送り速度</translation>
    </message>
    <message>
        <source>D&amp;well</source>
        <translation>ドウェル時間(&amp;W)</translation>
    </message>
    <message>
        <source>How long the axis stands at each target, to be measured</source>
        <translation>測定のために各目標位置で軸が静止する時間</translation>
    </message>
    <message>
        <source>Ran&amp;dom seed</source>
        <translation>乱数シード(&amp;D)</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same</source>
        <translation>数値を変えると目標位置が変わり、同じ数値なら同じ目標位置になります</translation>
    </message>
    <message>
        <source>Given b&amp;y</source>
        <translation>指定方法(&amp;Y)</translation>
    </message>
    <message>
        <source>Whether targets are counted, or their distance is given</source>
        <translation>目標位置を個数で指定するか、間隔で指定するか</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>目標位置の個数</translation>
    </message>
    <message>
        <source>Mean spacing of targets</source>
        <translation>目標位置の平均間隔</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>by the range</source>
        <translation>範囲による</translation>
    </message>
    <message>
        <source>%1. The axis moves from %2 to %3: check that this way is free.</source>
        <translation>%1。軸は %2 から %3 まで動きます。この経路に障害物がないことを確認してください。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This program never moves an axis: the control of the machine plays the program, or a person moves from target to target.</source>
        <translation>このプログラムが軸を動かすことはありません。機械の NC 装置がプログラムを実行するか、人が目標位置に順に動かします。</translation>
    </message>
    <message>
        <source>For Capture, which takes the values by it</source>
        <translation>[測定値の取り込み] 用。これに従って値を取り込みます</translation>
    </message>
    <message>
        <source>G-code for the control of the machine</source>
        <translation>機械の NC 装置用の G コード</translation>
    </message>
    <message>
        <source>Save Program</source>
        <translation>プログラムの保存</translation>
    </message>
    <message>
        <source>Save Plan</source>
        <translation>測定計画の保存</translation>
    </message>
    <message>
        <source>Programs (*%1);;All files (*)</source>
        <translation>プログラム (*%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>測定計画 (*.csv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanStepsModel</name>
    <message>
        <source>step %1, %2, target %3</source>
        <translation>ステップ %1、%2、目標位置 %3</translation>
    </message>
    <message>
        <source>due</source>
        <translation>次</translation>
    </message>
    <message>
        <source>not taken yet</source>
        <translation>未取り込み</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanTargetsModel</name>
    <message>
        <source>No.</source>
        <translation>No.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>間隔</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PreviewPanel</name>
    <message>
        <source>Save Exa&amp;mple…</source>
        <translation>サンプルを保存(&amp;M)…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>図</translation>
    </message>
    <message>
        <source>Save a small %1D calibration file as an example</source>
        <translation>小さな %1D の校正ファイルをサンプルとして保存します</translation>
    </message>
    <message>
        <source>%1 bytes, more than any slot of the drive holds</source>
        <translation>%1 バイト。ドライブのどのスロットにも入りません</translation>
    </message>
    <message>
        <source>%1 of %2 bytes of a table slot</source>
        <translation>テーブルのスロット %2 バイト中 %1 バイト</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>問題 (%1)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Ctrl+%2)</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>All slices</source>
        <translation>全断面</translation>
    </message>
    <message>
        <source>Two axes</source>
        <translation>2 軸</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemList</name>
    <message>
        <source>Problems of the file</source>
        <translation>ファイルの問題</translation>
    </message>
    <message>
        <source>%1 cannot be used; the previous selection is kept.</source>
        <translation>%1 は使用できません。前の選択のままです。</translation>
    </message>
    <message>
        <source>%1 is used, with these warnings.</source>
        <translation>%1 を使用します。次の警告があります。</translation>
    </message>
    <message>
        <source>Further problems: %1.</source>
        <translation>ほかの問題: %1。</translation>
    </message>
    <message>
        <source>Click a problem, or press Enter, to see the file&apos;s line.</source>
        <translation>問題をクリックするか Enter を押すと、ファイルの該当行を表示します。</translation>
    </message>
    <message>
        <source>&amp;Use %1D</source>
        <translation>%1D を使う(&amp;U)</translation>
    </message>
    <message>
        <source>Sets the dimensionality to %1D and reads the file again.</source>
        <translation>次元数を %1D にし、ファイルを読み取り直します。</translation>
    </message>
    <message>
        <source>%1 cannot be used.</source>
        <translation>%1 は使用できません。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemModel</name>
    <message>
        <source>error, line %1</source>
        <translation>エラー、行 %1</translation>
    </message>
    <message>
        <source>warning, line %1</source>
        <translation>警告、行 %1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>問題</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProvePage</name>
    <message>
        <source>%1 %2 (tolerance %3)</source>
        <translation>%1 %2 (許容値 %3)</translation>
    </message>
    <message>
        <source>%1 not defined (tolerance %2)</source>
        <translation>%1 未定義 (許容値 %2)</translation>
    </message>
    <message>
        <source>Not within the tolerances: %1.</source>
        <translation>許容値を満たしていません: %1。</translation>
    </message>
    <message>
        <source>Not judged by: %1.</source>
        <translation>判定できない特性値: %1。</translation>
    </message>
    <message>
        <source>Undecided, since the uncertainty is too large: %1.</source>
        <translation>不確かさが大きすぎて判定できません: %1。</translation>
    </message>
    <message>
        <source>The machine is not as good as was predicted.</source>
        <translation>機械は予測したほど良くなっていません。</translation>
    </message>
    <message>
        <source>The machine is no better than before.</source>
        <translation>機械は補正前より良くなっていません。</translation>
    </message>
    <message>
        <source>The two are corrected differently for temperature or dead path, so that they cannot be compared.</source>
        <translation>2 つの測定は温度またはデッドパスの補正が異なるため、比較できません。</translation>
    </message>
    <message>
        <source>No tolerance is given, so there is no verdict.</source>
        <translation>許容値が指定されていないため、判定はありません。</translation>
    </message>
    <message>
        <source>Within the tolerances.</source>
        <translation>許容値を満たしています。</translation>
    </message>
    <message>
        <source>Within the tolerances (uncertainty not stated).</source>
        <translation>許容値を満たしています (不確かさの記載なし)。</translation>
    </message>
    <message>
        <source>Second measurement</source>
        <translation>2 回目の測定</translation>
    </message>
    <message>
        <source>Files of the second measurement</source>
        <translation>2 回目の測定のファイル</translation>
    </message>
    <message>
        <source>Kee&amp;p in the Record</source>
        <translation>記録に追加(&amp;P)</translation>
    </message>
    <message>
        <source>The second measurement, what it says of the prediction, and the verdict</source>
        <translation>2 回目の測定、予測との比較結果、判定</translation>
    </message>
    <message>
        <source>For a file that does not say which table was active</source>
        <translation>有効だったテーブルの記載がないファイルの場合</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>補正前と補正後</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Figures before, predicted, held out and after</source>
        <translation>補正前、予測、未使用点、補正後の特性値</translation>
    </message>
    <message>
        <source>What is left at the targets</source>
        <translation>目標位置での残差</translation>
    </message>
    <message>
        <source>The tabl&amp;e %1 was active</source>
        <translation>テーブル %1 が有効だった(&amp;E)</translation>
    </message>
    <message>
        <source>What to look at: %1</source>
        <translation>確認事項: %1</translation>
    </message>
    <message>
        <source>Nothing was predicted between the targets: before and after are compared alone.</source>
        <translation>目標位置の間の予測がありません。補正前と補正後だけを比較します。</translation>
    </message>
    <message>
        <source>No table of this record is in use: a second measurement is compared with that of Measure alone. Open a record with a table to prove that one.</source>
        <translation>この記録のテーブルは使われていません。2 回目の測定は [測定] の測定とだけ比較します。テーブルを検証するには、テーブルのある記録を開いてください。</translation>
    </message>
    <message>
        <source>Write the table and activate it, measure again, and add the files of that measurement here.</source>
        <translation>テーブルを書き込んで有効化し、もう一度測定して、その測定ファイルをここに追加してください。</translation>
    </message>
    <message>
        <source>Measure again with the table active, and add the files of that measurement here.</source>
        <translation>テーブルを有効にしてもう一度測定し、その測定ファイルをここに追加してください。</translation>
    </message>
    <message>
        <source>The measurement is in the record: save that, and write the report.</source>
        <translation>測定が記録に入りました。記録を保存し、報告書を作成してください。</translation>
    </message>
    <message>
        <source>Keep it in the record.</source>
        <translation>記録に追加してください。</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>ファイルを読み取り中 …</translation>
    </message>
    <message>
        <source>The second measurement does not say which table was active. If it was the table %1, say so above; otherwise measure again with it.</source>
        <translation>2 回目の測定に、有効だったテーブルの記載がありません。テーブル %1 だった場合は上で指定してください。そうでない場合は、それを有効にして測定し直してください。</translation>
    </message>
    <message>
        <source>The measurements are being compared …</source>
        <translation>測定を比較中 …</translation>
    </message>
    <message>
        <source>There is no measurement to compare it with: add that one in Measure.</source>
        <translation>比較する測定がありません。[測定] で追加してください。</translation>
    </message>
    <message>
        <source>The second measurement covers only part of the first one&apos;s travel.</source>
        <translation>2 回目の測定は、1 回目の測定のストロークの一部しか含んでいません。</translation>
    </message>
    <message>
        <source>The measurement is in the record, and that is saved: write the report.</source>
        <translation>測定は記録に入り、記録は保存されています。報告書を作成してください。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %1 is not defined after.</source>
        <translation>補正後の %1 が未定義のため、予測どおりかどうかは判断できません。</translation>
    </message>
    <message>
        <source>Not as predicted, since the machine is no better than before: %3 is %1 after and was %2 before.</source>
        <translation>予測と不一致: 機械は補正前より良くなっていません。%3 は補正後 %1、補正前 %2 です。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %3 is smaller than before by no more than what cannot be told: %3 is %1 after and was %2 before.</source>
        <translation>%3 の減少が判別できない範囲にとどまるため、予測どおりかどうかは判断できません。%3 は補正後 %1、補正前 %2 です。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since less of the axis was measured: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>軸の一部しか測定していないため、予測どおりかどうかは判断できません。補正後の %3 は %1 で、%2 以下なら予測どおりです。</translation>
    </message>
    <message>
        <source>As predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>予測どおり: 補正後の %3 は %1 で、%2 以下なら予測どおりです (未使用点の %3 の 1.2 倍に、判別できない分を加えた値)。</translation>
    </message>
    <message>
        <source>Not as predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>予測と不一致: 補正後の %3 は %1 で、%2 以下なら予測どおりです (未使用点の %3 の 1.2 倍に、判別できない分を加えた値)。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since the targets are farther apart than before: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>目標位置の間隔が補正前より広いため、予測どおりかどうかは判断できません。補正後の %3 は %1 で、%2 以下なら予測どおりです。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordActions</name>
    <message>
        <source>Re&amp;cord</source>
        <translation>記録(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;New Record</source>
        <translation>新しい記録(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open Record…</source>
        <translation>記録を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save Record</source>
        <translation>記録を保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save Record &amp;As…</source>
        <translation>名前を付けて記録を保存(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>報告書(&amp;R)…</translation>
    </message>
    <message>
        <source>Records (*.axcal)</source>
        <translation>記録 (*.axcal)</translation>
    </message>
    <message>
        <source>Open Record</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Save Record</source>
        <translation>記録の保存</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告書</translation>
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
        <translation>保存して新規作成(&amp;T)</translation>
    </message>
    <message>
        <source>Save, &amp;Then Open</source>
        <translation>保存して開く(&amp;T)</translation>
    </message>
    <message>
        <source>Begin Without Savin&amp;g</source>
        <translation>保存せずに新規作成(&amp;G)</translation>
    </message>
    <message>
        <source>Open Without Savin&amp;g</source>
        <translation>保存せずに開く(&amp;G)</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>このまま続ける(&amp;Y)</translation>
    </message>
    <message>
        <source>The record has never been saved.</source>
        <translation>記録は一度も保存されていません。</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 に保存していない変更があります。</translation>
    </message>
    <message>
        <source>%1 is there already, and is another file.</source>
        <translation>%1 はすでにあり、別のファイルです。</translation>
    </message>
    <message>
        <source>%1 has been changed by another program since it was read here.</source>
        <translation>%1 は、ここで読み取った後に別のプログラムが変更しています。</translation>
    </message>
    <message>
        <source>Overwri&amp;te</source>
        <translation>上書き(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keep Both…</source>
        <translation>両方残す(&amp;K)…</translation>
    </message>
    <message>
        <source>The program did not end well. A record that was never saved was kept at %1.</source>
        <translation>プログラムが正常に終了しませんでした。一度も保存されていない記録が %1 時点で残っています。</translation>
    </message>
    <message>
        <source>The program did not end well. Unsaved changes of %1 were kept at %2.</source>
        <translation>プログラムが正常に終了しませんでした。%1 の保存していない変更が %2 時点で残っています。</translation>
    </message>
    <message>
        <source>&amp;Take Them Up</source>
        <translation>引き継ぐ(&amp;T)</translation>
    </message>
    <message>
        <source>For&amp;get Them</source>
        <translation>破棄(&amp;G)</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>報告書を %1 に書き出しました。</translation>
    </message>
    <message>
        <source>The drive has the table; only the record does not say so: %1</source>
        <translation>ドライブにはテーブルがありますが、記録に記載できませんでした: %1</translation>
    </message>
    <message>
        <source>%1 has changed on disk. What was left out is used again; corrections, and which table was active, are to be said anew. Ctrl+Z takes that back.</source>
        <translation>%1 がディスク上で変更されました。除外した値は再び使用されます。測定値の補正と、どのテーブルが有効だったかを改めて指定してください。Ctrl+Z で元に戻せます。</translation>
    </message>
    <message>
        <source>%1 says what was written and measured of its table, and this record does not. Saving it under another name keeps both.</source>
        <translation>%1 には、そのテーブルの書き込みと測定の結果がありますが、この記録にはありません。別の名前で保存すると、両方が残ります。</translation>
    </message>
    <message>
        <source>&amp;Take It Up</source>
        <translation>引き継ぐ(&amp;T)</translation>
    </message>
    <message>
        <source>For&amp;get It</source>
        <translation>破棄(&amp;G)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordBar</name>
    <message>
        <source>Record:</source>
        <translation>記録:</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Open a record (.axcal); it can also be dropped on the window (Ctrl+Alt+O)</source>
        <translation>記録 (.axcal) を開きます。ウィンドウへのドロップもできます (Ctrl+Alt+O)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save measurement, table, what it promised and what came of it (Ctrl+S)</source>
        <translation>測定、テーブル、その予測と結果を保存します (Ctrl+S)</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>報告書…</translation>
    </message>
    <message>
        <source>The report of the record as PDF or HTML (Ctrl+P)</source>
        <translation>記録の報告書を PDF または HTML で作成します (Ctrl+P)</translation>
    </message>
    <message>
        <source>Open record</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Save record</source>
        <translation>記録を保存</translation>
    </message>
    <message>
        <source>Report of the record</source>
        <translation>記録の報告書</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>It has changes that are not saved.</source>
        <translation>保存していない変更があります。</translation>
    </message>
    <message>
        <source>There are no unsaved changes.</source>
        <translation>保存していない変更はありません。</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>記録 %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordFile</name>
    <message>
        <source>not saved yet</source>
        <translation>未保存</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordModel</name>
    <message>
        <source>Add %1</source>
        <translation>%1 の追加</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 の削除</translation>
    </message>
    <message>
        <source>How %1 is read</source>
        <translation>%1 の読み取り方法</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>正方向と負方向の入れ替え</translation>
    </message>
    <message>
        <source>Exclude (%1)</source>
        <translation>除外 (%1)</translation>
    </message>
    <message>
        <source>Use again (%1)</source>
        <translation>除外の解除 (%1)</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>外れ値の判定規則</translation>
    </message>
    <message>
        <source>Tolerance of %1</source>
        <translation>%1 の許容値</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不確かさ</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>測定値の補正</translation>
    </message>
    <message>
        <source>Table in use</source>
        <translation>使用するテーブル</translation>
    </message>
    <message>
        <source>Table active while measured</source>
        <translation>測定時に有効だったテーブル</translation>
    </message>
    <message>
        <source>Fit: %1</source>
        <translation>フィッティング: %1</translation>
    </message>
    <message>
        <source>%1 changed on disk</source>
        <translation>%1 がディスク上で変更されました</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualModel</name>
    <message>
        <source>at %1: %2, standard error %3</source>
        <translation>%1: %2、標準誤差 %3</translation>
    </message>
    <message>
        <source>at %1: %2, standard error not defined</source>
        <translation>%1: %2、標準誤差は未定義</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>標準誤差</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualPlot</name>
    <message>
        <source>before</source>
        <translation>補正前</translation>
    </message>
    <message>
        <source>after, with its standard error</source>
        <translation>補正後 (標準誤差付き)</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>There is nothing to compare.</source>
        <translation>比較するものがありません。</translation>
    </message>
    <message>
        <source>What is left lies between %1 and %2.</source>
        <translation>残差は %1 から %2 の間です。</translation>
    </message>
    <message>
        <source>Mean deviation before and after</source>
        <translation>補正前と補正後の平均偏差</translation>
    </message>
    <message>
        <source>Dashed, with squares: before. Full line, with dots: after; the band is the standard error of the mean.</source>
        <translation>破線と四角: 補正前。実線と点: 補正後。帯は平均の標準誤差。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RestoreDriveDialog</name>
    <message>
        <source>The backup is being read.</source>
        <translation>バックアップを読み取り中です。</translation>
    </message>
    <message>
        <source>The backup is of another drive: confirm it first.</source>
        <translation>別のドライブのバックアップです。先に確認してください。</translation>
    </message>
    <message>
        <source>Backup of %1, serial number %2; axes: %3</source>
        <translation>%1 (シリアル番号 %2) のバックアップ、軸: %3</translation>
    </message>
    <message>
        <source>, of %1</source>
        <comment>time</comment>
        <translation>、%1 作成</translation>
    </message>
    <message>
        <source>Tables that no axis uses, restored after the axes: %1</source>
        <translation>どの軸も使用していないテーブル (軸の後に復元): %1</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>ドライブ全体の復元</translation>
    </message>
    <message>
        <source>Brings all axes of %1 back to the backup in %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified. No compensation is switched on.</source>
        <translation>%1 の全軸を順に %2 のバックアップの状態に戻します。最初の書き込みの前に、すべての書き込みを確認します。書き込みごとにバックアップを作成し、照合します。補正をオンにすることはありません。</translation>
    </message>
    <message>
        <source>The backup is of &amp;another drive, which this one replaces</source>
        <translation>このドライブと交換した別のドライブのバックアップである(&amp;A)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunDriftModel</name>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>走行</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>オフセット</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>傾き</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesModel</name>
    <message>
        <source>target %1 at %2</source>
        <translation>目標位置 %1 (%2)</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>値なし</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesView</name>
    <message>
        <source>Values of all files</source>
        <translation>全ファイルの値</translation>
    </message>
    <message>
        <source>&amp;Exclude</source>
        <translation>除外(&amp;E)</translation>
    </message>
    <message>
        <source>Leave the selected values out of every figure and table; in the first column, whole targets (Del)</source>
        <translation>選択した値をすべての特性値とテーブルから除外します。最初の列では目標位置全体を除外します (Del)</translation>
    </message>
    <message>
        <source>Exclude W&amp;hole Run</source>
        <translation>走行全体を除外(&amp;H)</translation>
    </message>
    <message>
        <source>Leave out every value of the run of the current cell</source>
        <translation>現在のセルの走行の値をすべて除外します</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>除外を解除(&amp;G)</translation>
    </message>
    <message>
        <source>Use the selected values again</source>
        <translation>選択した値の除外を解除します</translation>
    </message>
    <message>
        <source>Too many cells are selected: at most %1 in one step. A whole target is its cell in the first column; &quot;Exclude Whole Run&quot; takes a whole run.</source>
        <translation>選択したセルが多すぎます。1 回に %1 個までです。目標位置全体は最初の列のセル、走行全体は [走行全体を除外] で除外できます。</translation>
    </message>
    <message>
        <source>Values: %1, excluded: %2 (✕). ↑ up, ↓ down.</source>
        <translation>値: %1、除外: %2 (✕)。↑ 正方向、↓ 負方向。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SaveMachineDialog</name>
    <message>
        <source>Save Machine File</source>
        <translation>機械ファイルの保存</translation>
    </message>
    <message>
        <source>Writes machine.toml and the tables of all axes into a folder. The drives are only read.</source>
        <translation>machine.toml と全軸のテーブルをフォルダに書き出します。ドライブは読み取るだけです。</translation>
    </message>
    <message>
        <source>&amp;Name of the machine (may be empty)</source>
        <translation>機械の名前 (空欄可)(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Drives</source>
        <translation>ドライブ(&amp;D)</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>機械の名前</translation>
    </message>
    <message>
        <source>Drives of the machine</source>
        <translation>機械のドライブ</translation>
    </message>
    <message>
        <source>&amp;Replace These Files</source>
        <translation>これらのファイルを置き換える(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save in Folder…</source>
        <translation>フォルダに保存(&amp;S)…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>閉じる(&amp;L)</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>ページに戻ります (Esc)</translation>
    </message>
    <message>
        <source>%1 (does not answer)</source>
        <comment>drive</comment>
        <translation>%1 (応答なし)</translation>
    </message>
    <message>
        <source>No drive is chosen.</source>
        <translation>ドライブが選ばれていません。</translation>
    </message>
    <message>
        <source>%1 does not answer: a machine file without one of its drives would be another machine.</source>
        <translation>%1 が応答しません。ドライブが 1 台でも欠けた機械ファイルは、別の機械のものになります。</translation>
    </message>
    <message>
        <source>Wait for the end of the write.</source>
        <translation>書き込みが終わるまで待ってください。</translation>
    </message>
    <message>
        <source>Files that are there are not replaced unasked</source>
        <translation>既存のファイルを確認なしで置き換えることはありません</translation>
    </message>
    <message>
        <source>The folder has other files of these names, which would be replaced: %1.</source>
        <translation>フォルダに同名の別のファイルがあり、置き換えられます: %1。</translation>
    </message>
    <message>
        <source>Reading the drives …</source>
        <translation>ドライブを読み取り中 …</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>保存中 …</translation>
    </message>
    <message>
        <source>Nothing is saved yet.</source>
        <translation>まだ何も保存していません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Saved %1: drives: %2, tables: %3.</source>
        <translation>%1 を保存しました: ドライブ %2、テーブル %3。</translation>
    </message>
    <message>
        <source>Folder for the Machine File</source>
        <translation>機械ファイルのフォルダ</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SettingFields</name>
    <message>
        <source>not given</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>default: %1</source>
        <translation>既定: %1</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>必須</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルの記載どおり</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SetupHistory</name>
    <message>
        <source>Dimensionality</source>
        <translation>次元数</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Dim%1 ソース</translation>
    </message>
    <message>
        <source>Compensation data</source>
        <translation>補正データ</translation>
    </message>
    <message>
        <source>Several fields</source>
        <translation>複数の欄</translation>
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
        <translation>不揮発</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>揮発</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>軸(&amp;X)</translation>
    </message>
    <message>
        <source>The axis to compensate; lists all axes of all drives</source>
        <translation>補正する軸。全ドライブの全軸を表示します</translation>
    </message>
    <message>
        <source>The axis to compensate</source>
        <translation>補正する軸</translation>
    </message>
    <message>
        <source>Dimen&amp;sionality</source>
        <translation>次元数(&amp;S)</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on: 1D one, 2D two, 3D three</source>
        <translation>補正が依存する位置の数: 1D は 1 つ、2D は 2 つ、3D は 3 つ</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on</source>
        <translation>補正が依存する位置の数</translation>
    </message>
    <message>
        <source>Dim&amp;1 Source</source>
        <translation>Dim1 ソース(&amp;1)</translation>
    </message>
    <message>
        <source>Dim&amp;2 Source</source>
        <translation>Dim2 ソース(&amp;2)</translation>
    </message>
    <message>
        <source>Dim&amp;3 Source</source>
        <translation>Dim3 ソース(&amp;3)</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1: select one, or type a path, a tam:// URI or a hexadecimal address and press Enter</source>
        <translation>次元 %1 の位置を供給するレジスタ。選択するか、パス、tam:// URI または 16 進アドレスを入力して Enter を押します</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1</source>
        <translation>次元 %1 の位置を供給するレジスタ</translation>
    </message>
    <message>
        <source>Compensat&amp;ion data</source>
        <translation>補正データ(&amp;I)</translation>
    </message>
    <message>
        <source>A file of positions and compensation values; needed only for a new table</source>
        <translation>位置と補正値のファイル。新しいテーブルの場合にだけ必要</translation>
    </message>
    <message>
        <source>A file of compensation values; needed only for a new table</source>
        <translation>補正値のファイル。新しいテーブルの場合にだけ必要</translation>
    </message>
    <message>
        <source>Ta&amp;ble</source>
        <translation>テーブル(&amp;B)</translation>
    </message>
    <message>
        <source>The table for the axis: the one on the drive, or one from the file</source>
        <translation>軸のテーブル: ドライブにあるもの、またはファイルのもの</translation>
    </message>
    <message>
        <source>The table for the axis</source>
        <translation>軸のテーブル</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>Persistent: stored in the drive&apos;s flash and kept over a reboot. Volatile: lost on a reboot. Applies to the table on the drive as well</source>
        <translation>不揮発: ドライブのフラッシュに保存され、再起動後も残ります。揮発: 再起動で失われます。ドライブにあるテーブルにも適用されます</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>再起動後もテーブルが残るかどうか</translation>
    </message>
    <message>
        <source>Make &amp;persistent</source>
        <translation>不揮発にする(&amp;P)</translation>
    </message>
    <message>
        <source>no axis</source>
        <translation>軸なし</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>原点復帰済み</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>原点復帰未了</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>シリアル番号 %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>homed, serial number</comment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1, positions in %2, %3</source>
        <translation>%1、位置の単位 %2、%3</translation>
    </message>
    <message>
        <source>select or type a register</source>
        <translation>レジスタを選択または入力</translation>
    </message>
    <message>
        <source>now %1</source>
        <comment>value</comment>
        <translation>現在 %1</translation>
    </message>
    <message>
        <source>one source, one column of positions</source>
        <translation>ソース 1 つ、位置 1 列</translation>
    </message>
    <message>
        <source>two sources, two columns of positions</source>
        <translation>ソース 2 つ、位置 2 列</translation>
    </message>
    <message>
        <source>three sources, three columns of positions</source>
        <translation>ソース 3 つ、位置 3 列</translation>
    </message>
    <message>
        <source>On the drive: %1</source>
        <translation>ドライブ: %1</translation>
    </message>
    <message>
        <source>none on the drive</source>
        <translation>ドライブになし</translation>
    </message>
    <message>
        <source>Parsed: %1</source>
        <translation>ファイル: %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>%1 から</translation>
    </message>
    <message>
        <source>open a file to get a table</source>
        <translation>テーブルを得るにはファイルを開く</translation>
    </message>
    <message>
        <source>%1 is not used, problems: %2</source>
        <translation>%1 は使いません。問題: %2</translation>
    </message>
    <message>
        <source>CSV; needed only for a new table</source>
        <translation>CSV。新しいテーブルの場合にだけ必要</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>%1 を読み取り中</translation>
    </message>
    <message>
        <source>tables: %1, points: %2</source>
        <translation>テーブル: %1、点: %2</translation>
    </message>
    <message>
        <source>in flash</source>
        <translation>フラッシュに保存</translation>
    </message>
    <message>
        <source>lost on a reboot</source>
        <translation>再起動で失われる</translation>
    </message>
    <message>
        <source>; %1 of %2 flash operations available now</source>
        <comment>of the flash</comment>
        <translation>、現在可能なフラッシュ操作 %1/%2 回</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>未設定</translation>
    </message>
    <message>
        <source>unknown register %1</source>
        <translation>不明なレジスタ %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1, %2 points</source>
        <translation>%1、%2 点</translation>
    </message>
    <message>
        <source>%1, empty</source>
        <comment>table slot</comment>
        <translation>%1、空</translation>
    </message>
    <message>
        <source>; %1 of typically %2 flash cycles used</source>
        <comment>of the flash</comment>
        <translation>、フラッシュ書き換え %1 回 (標準寿命 %2 回)</translation>
    </message>
    <message>
        <source>; read as %1, converted</source>
        <translation>、%1 として読み取り、変換済み</translation>
    </message>
    <message>
        <source>from %1; the drive has it already</source>
        <translation>%1 から。ドライブにすでにあります</translation>
    </message>
    <message>
        <source>Fitted: %1</source>
        <translation>フィッティング: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SeveralWritesDialog</name>
    <message>
        <source>What will be written</source>
        <translation>書き込む内容</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>&amp;Write All</source>
        <translation>すべて書き込む(&amp;W)</translation>
    </message>
    <message>
        <source>Write these to the drive now</source>
        <translation>これらを今すぐドライブに書き込みます</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>先に大きな補正量を承認してください</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>中止(&amp;T)</translation>
    </message>
    <message>
        <source>Stops the writes; the current one is rolled back (Esc)</source>
        <translation>書き込みを中止します。現在のものはロールバックします (Esc)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>閉じる(&amp;L)</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>ページに戻ります (Esc)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>何も変更せずに戻ります (Esc)</translation>
    </message>
    <message>
        <source>Asking the drive what would change …</source>
        <translation>ドライブに変更内容を問い合わせ中 …</translation>
    </message>
    <message>
        <source>The drive already has all of this.</source>
        <translation>ドライブの内容はすでに同じです。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SignSentence</name>
    <message>
        <source>all values are 0: the drive will add nothing</source>
        <translation>すべての値が 0 のため、ドライブは何も加算しません</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the reference reads %2: the drive will add %3</source>
        <translation>エンコーダが %1、基準が %2 のとき、ドライブは %3 を加算します</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>%1 で、%2</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 more than the encoder: the drive will add %3</source>
        <translation>%1 で基準がエンコーダより %2 大きいとき、ドライブは %3 を加算します</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 less than the encoder: the drive will add %3</source>
        <translation>%1 で基準がエンコーダより %2 小さいとき、ドライブは %3 を加算します</translation>
    </message>
    <message>
        <source>at the set position %1 the drive will add %2</source>
        <translation>指令位置 %1 で、ドライブは %2 を加算します</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the drive will add %2</source>
        <translation>エンコーダが %1 のとき、ドライブは %2 を加算します</translation>
    </message>
    <message>
        <source>at %1 the drive will add %2</source>
        <translation>%1 で、ドライブは %2 を加算します</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceGallery</name>
    <message>
        <source>Slices of the table</source>
        <translation>テーブルの断面</translation>
    </message>
    <message>
        <source>Enter shows the slice as a picture</source>
        <translation>Enter で断面を図として表示します</translation>
    </message>
    <message>
        <source>colours from %1 to %2</source>
        <translation>色は %1 から %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices · %3</source>
        <translation>断面 %1/%2 · %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceRow</name>
    <message>
        <source>Slice at</source>
        <translation>断面位置</translation>
    </message>
    <message>
        <source>The slice that is shown</source>
        <translation>表示する断面</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>The dimension that is held constant; the other two are shown</source>
        <translation>一定に保つ次元。ほかの 2 つの次元を表示します</translation>
    </message>
    <message>
        <source>Sliced dimension</source>
        <translation>断面の次元</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SourceCheck</name>
    <message>
        <source>The drive is not connected: the source cannot be checked.</source>
        <translation>ドライブが接続されていないため、ソースを確認できません。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StateField</name>
    <message>
        <source>OFF</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>EVALUATING</source>
        <translation>試算中</translation>
    </message>
    <message>
        <source>RAMPING</source>
        <translation>ランプ中</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>有効</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Output %1 · Index %2</source>
        <translation>出力 %1 · インデックス %2</translation>
    </message>
    <message>
        <source>The state of the compensation of this axis</source>
        <translation>この軸の補正の状態</translation>
    </message>
    <message>
        <source>Live values of the drive: the compensation output and the table index</source>
        <translation>ドライブの現在値: 補正の出力とテーブルのインデックス</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>%1 から</translation>
    </message>
    <message>
        <source>since before %1</source>
        <translation>%1 より前から</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>%1, CRC %2</source>
        <comment>table and checksum</comment>
        <translation>%1、CRC %2</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>as read at %1</source>
        <translation>%1 に読み取り</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>テーブル範囲外: 端点値を保持</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>テーブルと不一致</translation>
    </message>
    <message>
        <source>not proved yet</source>
        <translation>未検証</translation>
    </message>
    <message>
        <source>proved over %1 of the table</source>
        <translation>テーブルの %1 で検証済み</translation>
    </message>
    <message>
        <source>Compensation: %1</source>
        <comment>state</comment>
        <translation>補正: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StationChoice</name>
    <message>
        <source>The file is being read.</source>
        <translation>ファイルを読み取り中です。</translation>
    </message>
    <message>
        <source>The file has no station.</source>
        <translation>ファイルにステーションがありません。</translation>
    </message>
    <message>
        <source>Select the station that is this drive.</source>
        <translation>このドライブに当たるステーションを選択してください。</translation>
    </message>
    <message>
        <source>Confirm first that the station is meant.</source>
        <translation>先に、このステーションでよいことを確認してください。</translation>
    </message>
    <message>
        <source>%1 has the serial number %2, the drive %3 has %4.</source>
        <translation>%1 のシリアル番号は %2、ドライブ %3 のシリアル番号は %4 です。</translation>
    </message>
    <message>
        <source>Stat&amp;ion</source>
        <translation>ステーション(&amp;I)</translation>
    </message>
    <message>
        <source>not selected</source>
        <translation>未選択</translation>
    </message>
    <message>
        <source>The drive in the configuration whose parameters are meant</source>
        <translation>パラメータの対象となる、構成内のドライブ</translation>
    </message>
    <message>
        <source>These &amp;parameters are for this drive although the serial numbers differ</source>
        <translation>シリアル番号は異なるが、このドライブのパラメータである(&amp;P)</translation>
    </message>
    <message>
        <source>The &amp;parameters of this drive are for this station although the serial numbers differ</source>
        <translation>シリアル番号は異なるが、このステーションのパラメータである(&amp;P)</translation>
    </message>
    <message>
        <source>The wrong drive would get the compensation of another machine</source>
        <translation>誤ると、ドライブに別の機械の補正が入ります</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StatusStrip</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Stops the operation; a write is rolled back (Esc)</source>
        <translation>処理を中止します。書き込みはロールバックします (Esc)</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>ログ(&amp;L)</translation>
    </message>
    <message>
        <source>Show the log (Ctrl+L)</source>
        <translation>ログを表示します (Ctrl+L)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SurfaceView</name>
    <message>
        <source>Heights</source>
        <translation>高さ倍率</translation>
    </message>
    <message>
        <source>How many times too high the errors are drawn, compared with the axes (+ and -)</source>
        <translation>軸に対して誤差を何倍の高さで描くか (+ / -)</translation>
    </message>
    <message>
        <source>First view</source>
        <translation>初期表示</translation>
    </message>
    <message>
        <source>Surface of the table</source>
        <translation>テーブルの曲面</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>補正値</translation>
    </message>
    <message>
        <source>heights × %1</source>
        <translation>高さ × %1</translation>
    </message>
    <message>
        <source>See the surface as at first (Home or a double click). Arrow keys and dragging turn it, the wheel, Page Up and Page Down zoom.</source>
        <translation>曲面を初期表示に戻します (Home またはダブルクリック)。矢印キーとドラッグで回転、ホイールと Page Up / Page Down で拡大縮小します。</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>図を保存…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>PNG、SVG または PDF で保存します</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>保存するテーブルがありません。</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>図をコピー</translation>
    </message>
    <message>
        <source>The units of the table have no common scale; the heights are drawn as they fit</source>
        <translation>テーブルの単位に共通の尺度がないため、高さは見やすい大きさで描きます</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableContentCombo</name>
    <message>
        <source>Selected table</source>
        <translation>選択したテーブル</translation>
    </message>
    <message>
        <source>Table on the drive</source>
        <translation>ドライブのテーブル</translation>
    </message>
    <message>
        <source>Selected - drive</source>
        <translation>選択 − ドライブ</translation>
    </message>
    <message>
        <source>Which values are shown</source>
        <translation>表示する値</translation>
    </message>
    <message>
        <source>Values shown</source>
        <translation>表示中の値</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TablePlot</name>
    <message>
        <source>C&amp;ursors</source>
        <translation>カーソル(&amp;U)</translation>
    </message>
    <message>
        <source>Two cursors and their difference. Arrow keys move the cursor, Space changes between A and B, a click sets it.</source>
        <translation>2 つのカーソルとその差。矢印キーでカーソルを移動、スペースで A と B を切り替え、クリックで設定します。</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>Picture of the table</source>
        <translation>テーブルの図</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>補正値</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>全体表示(&amp;H)</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>図を保存…</translation>
    </message>
    <message>
        <source>A: %1     B: %2
B - A: %3</source>
        <translation>A: %1     B: %2
B - A: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>What is drawn over the map</source>
        <translation>マップに重ねて描くもの</translation>
    </message>
    <message>
        <source>&amp;Grid points</source>
        <translation>格子点(&amp;G)</translation>
    </message>
    <message>
        <source>The points of the table, where they are far enough apart</source>
        <translation>テーブルの点 (間隔が十分にある場合)</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>等高線(&amp;C)</translation>
    </message>
    <message>
        <source>Lines of equal value</source>
        <translation>等しい値の線</translation>
    </message>
    <message>
        <source>Cross-&amp;sections</source>
        <translation>断面曲線(&amp;S)</translation>
    </message>
    <message>
        <source>The values along both axes through the cross-hair or the cursor, or else through the position of the axis</source>
        <translation>十字線またはカーソル、なければ軸の位置を通る、両軸に沿った値</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>テーブル範囲外: 端点値を保持</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg, .pdf or .csv.</source>
        <translation>ファイル名は .png、.svg、.pdf または .csv で終わる必要があります。</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>保存するテーブルがありません。</translation>
    </message>
    <message>
        <source>map</source>
        <translation>マップ</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>図をコピー</translation>
    </message>
    <message>
        <source>Show the whole table again (Home or a double click). The wheel and + and - zoom, Shift and drag zooms into a rectangle, dragging moves.</source>
        <translation>テーブル全体の表示に戻します (Home またはダブルクリック)。ホイールと + / - で拡大縮小、Shift + ドラッグで矩形を拡大、ドラッグで移動します。</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF, or the values shown as CSV</source>
        <translation>PNG、SVG、PDF、または表示中の値を CSV で保存します</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>end value held</source>
        <translation>端点値を保持</translation>
    </message>
    <message>
        <source>A difference is no table for a drive: it can be saved as a picture only.</source>
        <translation>差分はドライブ用のテーブルではありません。画像としてのみ保存できます。</translation>
    </message>
    <message>
        <source>These are values of another controller: Export for Another Controller writes its file.</source>
        <translation>これは別のコントローラの値です。そのファイルは「別のコントローラ用のエクスポート」で作成できます。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableSelection</name>
    <message>
        <source>%1 has been read: %2 points, tables: %3.</source>
        <translation>%1 を読み取りました: %2 点、テーブル: %3。</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2 problems.</source>
        <translation>%1 は使用できません: 問題 %2 件。</translation>
    </message>
    <message>
        <source>%1 is used as the table: %2 points, tables: %3.</source>
        <translation>%1 をテーブルとして使用します: %2 点、テーブル: %3。</translation>
    </message>
    <message>
        <source>%1 cannot be used as it is. %2</source>
        <translation>%1 はこのままでは使用できません。%2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableViewModel</name>
    <message>
        <source>No table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>%1, step %2 · min %3, max %4, rms %5</source>
        <translation>%1、間隔 %2 · 最小 %3、最大 %4、rms %5</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>補正値</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TargetFiguresModel</name>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標位置</translation>
    </message>
    <message>
        <source>Values ↑</source>
        <translation>値 ↑</translation>
    </message>
    <message>
        <source>Mean ↑</source>
        <translation>平均 ↑</translation>
    </message>
    <message>
        <source>Values ↓</source>
        <translation>値 ↓</translation>
    </message>
    <message>
        <source>Mean ↓</source>
        <translation>平均 ↓</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::UnsavedChangesGuard</name>
    <message>
        <source>Discard and Chan&amp;ge Axis</source>
        <translation>破棄して軸を変更(&amp;G)</translation>
    </message>
    <message>
        <source>Discard and Chan&amp;ge Connections</source>
        <translation>破棄して接続を変更(&amp;G)</translation>
    </message>
    <message>
        <source>Close Without Writin&amp;g</source>
        <translation>書き込まずに閉じる(&amp;G)</translation>
    </message>
    <message>
        <source>A write is in progress. Stopping rolls it back first.</source>
        <translation>書き込み中です。中止すると、まずロールバックします。</translation>
    </message>
    <message>
        <source>&amp;Stop and Close</source>
        <translation>中止して閉じる(&amp;S)</translation>
    </message>
    <message>
        <source>Close When Don&amp;e</source>
        <translation>完了後に閉じる(&amp;E)</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>このまま続ける(&amp;Y)</translation>
    </message>
    <message>
        <source>%1 has changes that are not written to the drive.</source>
        <translation>%1 に、ドライブに書き込んでいない変更があります。</translation>
    </message>
    <message>
        <source>Save Record, &amp;Then Close</source>
        <translation>記録を保存して閉じる(&amp;T)</translation>
    </message>
    <message>
        <source>Close Without Savin&amp;g</source>
        <translation>保存せずに閉じる(&amp;G)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesModel</name>
    <message>
        <source>Index %1</source>
        <translation>インデックス %1</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>補正値</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>ドライブ</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesView</name>
    <message>
        <source>Values of the table</source>
        <translation>テーブルの値</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy With Positions</source>
        <translation>位置付きでコピー</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>すべて選択</translation>
    </message>
    <message>
        <source>Copy the selected values, or all of them, with their positions for a spreadsheet. Ctrl+C copies the selected values alone.</source>
        <translation>選択した値またはすべての値を、表計算用に位置付きでコピーします。Ctrl+C では選択した値だけをコピーします。</translation>
    </message>
    <message>
        <source>Copy values</source>
        <translation>値をコピー</translation>
    </message>
    <message>
        <source>%1 across, %2 down, %3</source>
        <translation>横 %1、縦 %2、%3</translation>
    </message>
    <message>
        <source>Copied cells: %1</source>
        <translation>コピーしたセル: %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::VectorView</name>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>誤差倍率</translation>
    </message>
    <message>
        <source>How many times too large errors are drawn (+ and -)</source>
        <translation>誤差を何倍に描くか (+ / -)</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>全体表示(&amp;H)</translation>
    </message>
    <message>
        <source>Show the whole grid again (Home or a double click). The wheel, Page Up and Page Down zoom, dragging and the arrow keys move.</source>
        <translation>格子全体の表示に戻します (Home またはダブルクリック)。ホイールと Page Up / Page Down で拡大縮小、ドラッグと矢印キーで移動します。</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>図を保存…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>PNG、SVG または PDF で保存します</translation>
    </message>
    <message>
        <source>Grid with the errors of two axes</source>
        <translation>2 軸の誤差の格子</translation>
    </message>
    <message>
        <source>The column with the errors along %1</source>
        <translation>%1 方向の誤差の列</translation>
    </message>
    <message>
        <source>Thin: the grid as the encoders read it. Bold: where the axes really are, errors × %1.</source>
        <translation>細線: エンコーダが示す格子。太線: 軸の実際の位置、誤差 × %1。</translation>
    </message>
    <message>
        <source>The file has no errors of both axes of this slice: cut another dimension.</source>
        <translation>ファイルに、この断面の 2 軸の誤差がそろっていません。別の次元の断面にしてください。</translation>
    </message>
    <message>
        <source>%1 and %2, errors × %3</source>
        <translation>%1 と %2、誤差 × %3</translation>
    </message>
    <message>
        <source>errors of two axes</source>
        <translation>2 軸の誤差</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>図をコピー</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WarningList</name>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardController</name>
    <message>
        <source>Wait for the current operation before selecting another axis.</source>
        <translation>別の軸を選ぶには、現在の処理が終わるまで待ってください。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardLog</name>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WritePreview</name>
    <message>
        <source>persistent</source>
        <translation>不揮発</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>揮発</translation>
    </message>
    <message>
        <source>Nothing on the drive has changed yet. The old table and settings are backed up first.</source>
        <translation>ドライブはまだ何も変更されていません。まず旧テーブルと旧設定をバックアップします。</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>書き込む内容</translation>
    </message>
    <message>
        <source>Do not show this again &amp;for volatile writes</source>
        <translation>揮発の書き込みでは今後表示しない(&amp;F)</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview; the menu turns it back on for volatile ones</source>
        <translation>不揮発の書き込みでは常にプレビューを表示します。揮発の場合の表示はメニューで再びオンにできます</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>書き込む(&amp;W)</translation>
    </message>
    <message>
        <source>Write this to the drive now</source>
        <translation>今すぐドライブに書き込みます</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>戻る(&amp;K)</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>何も変更せずに戻ります (Esc)</translation>
    </message>
    <message>
        <source>What will be written to %1</source>
        <comment>axis and drive</comment>
        <translation>%1 に書き込む内容</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>Largest change</source>
        <translation>最大の変化</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>計算中 …</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>次元数</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Dim%1 ソース</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>保存方式</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>Uses no flash operation. Volatile: lost on a reboot.</source>
        <translation>フラッシュ操作を使いません。揮発のため、再起動で失われます。</translation>
    </message>
    <message>
        <source>Uses no flash operation: the flash already holds it.</source>
        <translation>フラッシュ操作を使いません。フラッシュにはすでに同じ内容があります。</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>フラッシュ操作: %1 回使用、直後の残り %2 回。</translation>
    </message>
    <message>
        <source>%1 held an earlier table of this axis; the current one stays complete until the axis has switched to the new one.</source>
        <translation>%1 にはこの軸の以前のテーブルがありました。現在のテーブルは、軸が新しいテーブルに切り替わるまで完全に残ります。</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>未設定</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>なし</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>possibly not saved</source>
        <translation>未保存の可能性あり</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>保存済み</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>大きな補正量は正しい: 単位を確認済み(&amp;R)</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>先に大きな補正量を承認してください</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete this from the drive now</source>
        <translation>今すぐドライブから削除します</translation>
    </message>
    <message>
        <source>What will be deleted from %1</source>
        <comment>axis and drive</comment>
        <translation>%1 から削除する内容</translation>
    </message>
    <message>
        <source>empty</source>
        <comment>slot</comment>
        <translation>空</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>フラッシュ操作を使いません。</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>復元(&amp;R)</translation>
    </message>
    <message>
        <source>What will be restored on %1</source>
        <comment>axis and drive</comment>
        <translation>%1 に復元する内容</translation>
    </message>
    <message>
        <source>This is what the axis had before the write of %1.</source>
        <translation>これは、%1 の書き込み前の軸の状態です。</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>This is the state in the backup file of %1.</source>
        <translation>これは、%1 のバックアップファイルにある状態です。</translation>
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
        <translation>偏差</translation>
    </message>
</context>
</TS>
