<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>ColumnRole</name>
    <message>
        <source>target</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>run</source>
        <translation>趟次</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>基准</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>use</source>
        <translation>采用</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>{now} is before the program was made, {made}</source>
        <translation>{now} 早于本程序的构建时间 {made}</translation>
    </message>
    <message>
        <source>set the clock (timedatectl says what it follows): flash operations are counted by it</source>
        <translation>请校准时钟（timedatectl 显示其同步来源）：闪存操作按该时钟计数</translation>
    </message>
    <message>
        <source>display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>unset it if the window does not appear</source>
        <translation>如果窗口不出现，请取消设置该变量</translation>
    </message>
    <message>
        <source>none; the window needs one</source>
        <translation>无；窗口程序需要显示</translation>
    </message>
    <message>
        <source>start the window on the desktop, or over ssh -X; the command line does without</source>
        <translation>请在桌面上或通过 ssh -X 启动窗口程序；命令行不需要显示</translation>
    </message>
    <message>
        <source>temporary folder</source>
        <translation>临时文件夹</translation>
    </message>
    <message>
        <source>{folder} is not there</source>
        <translation>{folder} 不存在</translation>
    </message>
    <message>
        <source>make it, or set {variable} to another folder</source>
        <translation>请创建它，或将 {variable} 设为其他文件夹</translation>
    </message>
    <message>
        <source>{folder}, {free} free</source>
        <translation>{folder}，可用 {free}</translation>
    </message>
    <message>
        <source>runtime folder</source>
        <translation>运行时文件夹</translation>
    </message>
    <message>
        <source>log in at the desktop or over ssh, and not by su or sudo, if the window does not appear</source>
        <translation>如果窗口不出现，请在桌面上或通过 ssh 登录，不要用 su 或 sudo</translation>
    </message>
    <message>
        <source>XDG_RUNTIME_DIR is not set</source>
        <translation>未设置 XDG_RUNTIME_DIR</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}</source>
        <translation>{folder} 属于 {owner}</translation>
    </message>
    <message>
        <source>proxies</source>
        <translation>代理</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>{variables}: drives are reached without a proxy all the same</source>
        <translation>{variables}：访问驱动器时仍不使用代理</translation>
    </message>
    <message>
        <source>no variable is set</source>
        <translation>未设置变量</translation>
    </message>
    <message>
        <source>locale</source>
        <translation>区域设置</translation>
    </message>
    <message>
        <source>{variables}: this locale is not installed</source>
        <translation>{variables}：该区域设置未安装</translation>
    </message>
    <message>
        <source>{variables}: its encoding {encoding} is not UTF-8, so that letters outside of ASCII may look wrong</source>
        <translation>{variables}：其编码 {encoding} 不是 UTF-8，ASCII 以外的字符可能显示有误</translation>
    </message>
    <message>
        <source>export LC_ALL=C.UTF-8, or the locale of your language with UTF-8</source>
        <translation>export LC_ALL=C.UTF-8，或所用语言的 UTF-8 区域设置</translation>
    </message>
    <message>
        <source>{variables}: {encoding}</source>
        <translation>{variables}：{encoding}</translation>
    </message>
    <message>
        <source>set {variable} to a folder of your own</source>
        <translation>请将 {variable} 设为自己的文件夹</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} is no folder</source>
        <translation>{folder} 无法使用：{nearest} 不是文件夹</translation>
    </message>
    <message>
        <source>{folder} cannot be used: you have no permission to look into {nearest}</source>
        <translation>{folder} 无法使用：没有查看 {nearest} 的权限</translation>
    </message>
    <message>
        <source>{folder} is on a file system that is read-only</source>
        <translation>{folder} 位于只读的文件系统上</translation>
    </message>
    <message>
        <source>{folder} cannot be used: {nearest} belongs to {owner}, and you have no permission to change it</source>
        <translation>{folder} 无法使用：{nearest} 属于 {owner}，没有更改它的权限</translation>
    </message>
    <message>
        <source>{folder} has only {free} free</source>
        <translation>{folder} 仅剩 {free} 可用空间</translation>
    </message>
    <message>
        <source>{folder} is on a file system that takes no more files, with {free} free</source>
        <translation>{folder} 所在的文件系统无法再创建文件，可用 {free}</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to a folder of another disk</source>
        <translation>请在该处腾出空间，或将 {variable} 设为其他磁盘上的文件夹</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>System</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>system</source>
        <translation>操作系统</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>内核</translation>
    </message>
    <message>
        <source>processor cores</source>
        <translation>处理器核心数</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>{all}, {free} free</source>
        <translation>{all}，可用 {free}</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>decimal sign</source>
        <translation>小数符号</translation>
    </message>
    <message>
        <source>&quot;{sign}&quot;; the command line writes and reads a point</source>
        <translation>“{sign}”；命令行读写时使用点号</translation>
    </message>
    <message>
        <source>translations</source>
        <translation>译文</translation>
    </message>
    <message>
        <source>window settings</source>
        <translation>窗口程序设置</translation>
    </message>
    <message>
        <source>none; the window was not used yet</source>
        <translation>无；窗口程序尚未使用过</translation>
    </message>
    <message>
        <source>{file} is not a file that you may read</source>
        <translation>{file} 不是可读取的文件</translation>
    </message>
    <message>
        <source>move it away; the window begins a new one</source>
        <translation>请将其移走；窗口程序会新建一个</translation>
    </message>
    <message>
        <source>{file} is damaged</source>
        <translation>{file} 已损坏</translation>
    </message>
    <message>
        <source>{file}, connections: {number}</source>
        <translation>{file}，连接：{number}</translation>
    </message>
    <message>
        <source>drive profile</source>
        <translation>驱动器描述文件</translation>
    </message>
    <message>
        <source>{profile}, built in</source>
        <translation>{profile}，内置</translation>
    </message>
    <message>
        <source>trusted certificates</source>
        <translation>受信任的证书</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>open {drive} in a browser of this computer; if it does not answer there either, look at power, cable and network</source>
        <translation>在本计算机的浏览器中打开 {drive}；若仍无应答，请检查电源、电缆和网络</translation>
    </message>
    <message>
        <source>look at power and cable; `axiscomp axes --find --any-baud` tries other speeds</source>
        <translation>请检查电源和电缆；`axiscomp axes --find --any-baud` 可尝试其他波特率</translation>
    </message>
    <message>
        <source>address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>{drive}, serial number {serial}, axes: {axes}, profile {profile}; answered after {milliseconds}</source>
        <translation>{drive}，序列号 {serial}，轴：{axes}，描述文件 {profile}；{milliseconds} 后应答</translation>
    </message>
    <message>
        <source>{drive}; then: {error}</source>
        <translation>{drive}；之后：{error}</translation>
    </message>
    <message>
        <source>{unit}, {homing}, compensation {state}</source>
        <translation>{unit}，{homing}，补偿 {state}</translation>
    </message>
    <message>
        <source>{state}, no table</source>
        <translation>{state}，无表</translation>
    </message>
    <message>
        <source>{state}, table {slot} with CRC {crc}</source>
        <translation>{state}，表 {slot}，CRC {crc}</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>轴 {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>轴 {axis}（{name}）</translation>
    </message>
    <message>
        <source>it has no compensation registers by this profile</source>
        <translation>按此描述文件，它没有补偿寄存器</translation>
    </message>
    <message>
        <source>drive error</source>
        <translation>驱动器错误</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>none is known</source>
        <translation>没有已知的驱动器</translation>
    </message>
    <message>
        <source>add a connection in the window, or give --drive ADDRESS</source>
        <translation>请在窗口程序中添加连接，或给出 --drive ADDRESS</translation>
    </message>
    <message>
        <source>{version}, built with {other}</source>
        <translation>{version}，构建时为 {other}</translation>
    </message>
    <message>
        <source>there is no TLS library: https drives cannot be reached</source>
        <translation>没有 TLS 库：无法访问 https 驱动器</translation>
    </message>
    <message>
        <source>install OpenSSL (sudo apt install libssl3)</source>
        <translation>请安装 OpenSSL（sudo apt install libssl3）</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口程序</translation>
    </message>
    <message>
        <source>not installed; the command line does without</source>
        <translation>未安装；命令行不需要它</translation>
    </message>
    <message>
        <source>reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>what draws PDF is not installed</source>
        <translation>未安装生成 PDF 的模块</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>a port without a name</source>
        <translation>无名称的端口</translation>
    </message>
    <message>
        <source>{hardware}, built in</source>
        <translation>{hardware}，内置</translation>
    </message>
    <message>
        <source>{hardware}, USB {id}</source>
        <translation>{hardware}，USB {id}</translation>
    </message>
    <message>
        <source>{hardware}: {problem}</source>
        <translation>{hardware}：{problem}</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>ports</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>this computer has none</source>
        <translation>本计算机没有</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>sudo chown -R $USER {folder}; run this program without sudo</source>
        <translation>sudo chown -R $USER {folder}；运行本程序时不要用 sudo</translation>
    </message>
    <message>
        <source>{folder} is yours, but its permissions keep you out</source>
        <translation>{folder} 属于当前用户，但其权限不允许访问</translation>
    </message>
    <message>
        <source>{folder} is not there yet; the first write makes it</source>
        <translation>{folder} 尚不存在；首次写入时创建</translation>
    </message>
    <message>
        <source>{folder} belongs to {owner}, and you are root: what is made there now belongs to root</source>
        <translation>{folder} 属于 {owner}，而当前用户是 root：现在在其中创建的内容将属于 root</translation>
    </message>
    <message>
        <source>run this program without sudo</source>
        <translation>运行本程序时不要用 sudo</translation>
    </message>
    <message>
        <source>{folder} can be changed by other users</source>
        <translation>{folder} 可被其他用户更改</translation>
    </message>
    <message>
        <source>file system</source>
        <translation>文件系统</translation>
    </message>
    <message>
        <source>on the network, where a database can be damaged: nothing is kept there, and no write begins</source>
        <translation>位于网络上，数据库可能在那里损坏：不在其中保存任何内容，也不开始写入</translation>
    </message>
    <message>
        <source>set {variable} to a folder on this computer</source>
        <translation>请将 {variable} 设为本计算机上的文件夹</translation>
    </message>
    <message>
        <source>in memory: backups and journal are gone after a restart</source>
        <translation>在内存中：备份和写入日志重启后丢失</translation>
    </message>
    <message>
        <source>set {variable} to a folder on a disk</source>
        <translation>请将 {variable} 设为磁盘上的文件夹</translation>
    </message>
    <message>
        <source>of this computer</source>
        <translation>位于本计算机</translation>
    </message>
    <message>
        <source>database</source>
        <translation>数据库</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>请将其移走</translation>
    </message>
    <message>
        <source>none yet; the first write makes it</source>
        <translation>尚无；首次写入时创建</translation>
    </message>
    <message>
        <source>of an older version, {size}; the next command that needs it brings it up to date</source>
        <translation>较旧版本，{size}；下一条用到它的命令会将其更新</translation>
    </message>
    <message>
        <source>a newer version of this program has written it</source>
        <translation>它由本程序的更新版本写成</translation>
    </message>
    <message>
        <source>use that version</source>
        <translation>请使用该版本</translation>
    </message>
    <message>
        <source>it is the database of another program</source>
        <translation>这是另一程序的数据库</translation>
    </message>
    <message>
        <source>it is damaged ({reason})</source>
        <translation>已损坏（{reason}）</translation>
    </message>
    <message>
        <source>the next command that needs it sets it aside and keeps what can be read; look what the drives hold, then `axiscomp status --reset-flash-count` for each</source>
        <translation>下一条用到它的命令会将其移开，并保留可读取的内容；请核对各驱动器的现状，然后对每台运行 `axiscomp status --reset-flash-count`</translation>
    </message>
    <message>
        <source>not checked, because programs write to it all the time</source>
        <translation>未检查，因为一直有程序在写入</translation>
    </message>
    <message>
        <source>try again when they have finished</source>
        <translation>请在它们完成后重试</translation>
    </message>
    <message>
        <source>you have no permission to change it</source>
        <translation>没有更改它的权限</translation>
    </message>
    <message>
        <source>let the user have it to whom the folder belongs (chown, chmod u+rw)</source>
        <translation>请将其交给文件夹的所有者（chown、chmod u+rw）</translation>
    </message>
    <message>
        <source>whole, {size}</source>
        <translation>完好，{size}</translation>
    </message>
    <message>
        <source>interrupted write</source>
        <translation>中断的写入</translation>
    </message>
    <message>
        <source>write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>a program is writing to axis {axis} of the drive with serial number {drive} now, since {time} ({step})</source>
        <translation>有程序正在写入序列号为 {drive} 的驱动器的轴 {axis}，始于 {time}（{step}）</translation>
    </message>
    <message>
        <source>a write to axis {axis} of the drive with serial number {drive} began at {time} and did not end (step {step})</source>
        <translation>对序列号为 {drive} 的驱动器的轴 {axis} 的写入始于 {time}，未结束（步骤 {step}）</translation>
    </message>
    <message>
        <source>`axiscomp recover --axis {axis}` with that drive says what it holds, and finishes the write or undoes it</source>
        <translation>对该驱动器运行 `axiscomp recover --axis {axis}`，可显示其现状，并完成或撤销该写入</translation>
    </message>
    <message>
        <source>interrupted writes</source>
        <translation>中断的写入</translation>
    </message>
    <message>
        <source>flash record</source>
        <translation>闪存操作记录</translation>
    </message>
    <message>
        <source>that of the drive with serial number {drive} was damaged: its flash operations count as used up</source>
        <translation>序列号为 {drive} 的驱动器的记录已损坏：其闪存操作视为全部用完</translation>
    </message>
    <message>
        <source>wait as long as the drive counts them, then `axiscomp status --reset-flash-count`</source>
        <translation>请等待驱动器统计闪存操作的那段时间，然后运行 `axiscomp status --reset-flash-count`</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>已移开</translation>
    </message>
    <message>
        <source>{file} is an earlier database that was damaged</source>
        <translation>{file} 是先前损坏的数据库</translation>
    </message>
    <message>
        <source>delete it when nothing is missed</source>
        <translation>确认没有缺失内容后，请将其删除</translation>
    </message>
    <message>
        <source>last change</source>
        <translation>最后更改</translation>
    </message>
    <message>
        <source>{time} is still to come: the clock was set back since</source>
        <translation>{time} 尚未到来：此后时钟曾被调回</translation>
    </message>
    <message>
        <source>look at the clock: flash operations are counted by it</source>
        <translation>请检查时钟：闪存操作按该时钟计数</translation>
    </message>
    <message>
        <source>backups</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>files: {backups}, drives: {drives}, {size}</source>
        <translation>文件：{backups}，驱动器：{drives}，{size}</translation>
    </message>
    <message>
        <source>State folder</source>
        <translation>状态文件夹</translation>
    </message>
    <message>
        <source>sudo apt install locales and sudo dpkg-reconfigure locales, or export LC_ALL=C.UTF-8</source>
        <translation>sudo apt install locales 和 sudo dpkg-reconfigure locales，或 export LC_ALL=C.UTF-8</translation>
    </message>
    <message>
        <source>if the drive has the same fingerprint: `axiscomp axes --drive {drive} --trust-certificate {fingerprint}` trusts it from then on</source>
        <translation>如果驱动器的指纹相同：`axiscomp axes --drive {drive} --trust-certificate {fingerprint}` 此后信任它</translation>
    </message>
    <message>
        <source>install the package {package}</source>
        <translation>请安装软件包 {package}</translation>
    </message>
    <message>
        <source>install the package {package}, or write the report as HTML and print that</source>
        <translation>请安装软件包 {package}，或将报告写为 HTML 后打印</translation>
    </message>
    <message>
        <source>not checked: {reason}</source>
        <translation>未检查：{reason}</translation>
    </message>
    <message>
        <source>make room there, or set {variable} to another folder</source>
        <translation>请在该处腾出空间，或将 {variable} 设为其他文件夹</translation>
    </message>
    <message>
        <source>not checked, because no copy could be made in the temporary folder</source>
        <translation>未检查，因为无法在临时文件夹中创建副本</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>{size} bytes</source>
        <translation>{size} 字节</translation>
    </message>
    <message>
        <source>at most {size} bytes</source>
        <translation>最多 {size} 字节</translation>
    </message>
    <message>
        <source>at most {count} columns</source>
        <translation>最多 {count} 列</translation>
    </message>
    <message>
        <source>a line with the names of the columns, not only comments</source>
        <translation>一行列名，而不只是注释</translation>
    </message>
    <message>
        <source>no data lines after the header</source>
        <translation>标题行之后没有数据行</translation>
    </message>
    <message>
        <source>at least 2 positions in each dimension, one line per grid point</source>
        <translation>每个维度至少 2 个位置，每个网格点一行</translation>
    </message>
    <message>
        <source>the names of the columns, not numbers</source>
        <translation>列名，而不是数字</translation>
    </message>
    <message>
        <source>at least {count} for dimensionality {dimensions}, {positions} of positions and 1 of values</source>
        <translation>维数为 {dimensions} 时至少 {count} 列，其中位置 {positions} 列、值 1 列</translation>
    </message>
    <message>
        <source>{expected} (or is the dimensionality {dimensions}?)</source>
        <translation>{expected}（或者维数是 {dimensions}？）</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ;</source>
        <translation>{expected}；列之间用 , 或 ; 分隔</translation>
    </message>
    <message>
        <source>{expected}; if the commas are decimal commas, separate the columns with ; in every line</source>
        <translation>{expected}；如果逗号是小数逗号，则每一行的列之间都用 ; 分隔</translation>
    </message>
    <message>
        <source>{expected}; the header separates its columns with {separator}, so every line must</source>
        <translation>{expected}；标题行的列用 {separator} 分隔，每一行都必须如此</translation>
    </message>
    <message>
        <source>{expected}; decimal commas need the separator ; in every line</source>
        <translation>{expected}；使用小数逗号时，每一行都必须用 ; 作分隔符</translation>
    </message>
    <message>
        <source>{count} as in the header (line {line})</source>
        <translation>{count}，与标题行相同（第 {line} 行）</translation>
    </message>
    <message>
        <source>a closing &quot; in the same line</source>
        <translation>同一行中的右引号 &quot;</translation>
    </message>
    <message>
        <source>a separator after the closing &quot;</source>
        <translation>右引号 &quot; 之后的分隔符</translation>
    </message>
    <message>
        <source>a separator or the end of the line after the closing &quot;</source>
        <translation>右引号 &quot; 之后的分隔符或行尾</translation>
    </message>
    <message>
        <source>a number such as {example}</source>
        <translation>数字，例如 {example}</translation>
    </message>
    <message>
        <source>a finite number such as {example}</source>
        <translation>有限的数字，例如 {example}</translation>
    </message>
    <message>
        <source>0 or a number that is not as close to it</source>
        <translation>0，或不这样接近 0 的数字</translation>
    </message>
    <message>
        <source>a value that fits float32 (below 3.4e38)</source>
        <translation>float32 可容纳的值（小于 3.4e38）</translation>
    </message>
    <message>
        <source>a decimal comma as in line {line}</source>
        <translation>小数逗号，与第 {line} 行相同</translation>
    </message>
    <message>
        <source>a decimal point as in line {line}</source>
        <translation>小数点，与第 {line} 行相同</translation>
    </message>
    <message>
        <source>no sign between the thousands</source>
        <translation>不带千位分隔符的数字</translation>
    </message>
    <message>
        <source>more than {rows} data lines of {columns} columns</source>
        <translation>超过 {rows} 行、每行 {columns} 列的数据</translation>
    </message>
    <message>
        <source>at most {cells} cells (lines x columns)</source>
        <translation>最多 {cells} 个单元格（行 x 列）</translation>
    </message>
    <message>
        <source>positions with a finite range</source>
        <translation>范围有限的位置</translation>
    </message>
    <message>
        <source>positions whose distance a double can hold</source>
        <translation>间距可用 double 表示的位置</translation>
    </message>
    <message>
        <source>{position} (steps of {distance})</source>
        <translation>{position}（间距 {distance}）</translation>
    </message>
    <message>
        <source>{position} next to {before}</source>
        <translation>{position}，与 {before} 相邻</translation>
    </message>
    <message>
        <source>{position} on an even line in steps of {distance}</source>
        <translation>{position}，按均匀间距 {distance}</translation>
    </message>
    <message>
        <source>only {position}</source>
        <translation>只有 {position}</translation>
    </message>
    <message>
        <source>at least 2 different positions</source>
        <translation>至少 2 个不同的位置</translation>
    </message>
    <message>
        <source>{point} in line {first} and again in line {second}</source>
        <translation>{point} 出现在第 {first} 行，又出现在第 {second} 行</translation>
    </message>
    <message>
        <source>every position once</source>
        <translation>每个位置一次</translation>
    </message>
    <message>
        <source>no line for {points} (missing: {missing} of {all} points)</source>
        <translation>{points} 没有对应的行（缺 {missing} 个点，共 {all} 个）</translation>
    </message>
    <message>
        <source>{value} at every point of {table}</source>
        <translation>{table} 的每个点都是 {value}</translation>
    </message>
    <message>
        <source>values that differ</source>
        <translation>各不相同的值</translation>
    </message>
    <message>
        <source>a change of {change}</source>
        <translation>变化 {change}</translation>
    </message>
    <message>
        <source>at most a millionth of the largest value, {value}</source>
        <translation>最多为最大值 {value} 的百万分之一</translation>
    </message>
    <message>
        <source>a step from {from} to {to} over {distance} in dimension {dimension}</source>
        <translation>维度 {dimension} 上在 {distance} 内由 {from} 跳变到 {to}</translation>
    </message>
    <message>
        <source>at most 0.01 per unit of position</source>
        <translation>每单位位置最多 0.01</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16 文本</translation>
    </message>
    <message>
        <source>a spreadsheet workbook or ZIP archive</source>
        <translation>电子表格工作簿或 ZIP 压缩包</translation>
    </message>
    <message>
        <source>an old Excel workbook</source>
        <translation>旧版 Excel 工作簿</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 文档</translation>
    </message>
    <message>
        <source>a compressed file (gzip)</source>
        <translation>压缩文件 (gzip)</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>a TAM table</source>
        <translation>TAM 表</translation>
    </message>
    <message>
        <source>a binary file</source>
        <translation>二进制文件</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>NUL 字节</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>文本文件</translation>
    </message>
    <message>
        <source>the byte 0x{byte} ({character})</source>
        <translation>字节 0x{byte} ({character})</translation>
    </message>
    <message>
        <source>file length</source>
        <translation>文件长度</translation>
    </message>
    <message>
        <source>element {number}</source>
        <translation>元素 {number}</translation>
    </message>
    <message>
        <source>{size} for the header and 4 for each of the {count} elements</source>
        <translation>文件头 {size}，另加 {count} 个元素各 4</translation>
    </message>
    <message>
        <source>at least the {size} bytes of the header</source>
        <translation>至少为文件头的 {size} 字节</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 或 1</translation>
    </message>
    <message>
        <source>1, 2 or 3</source>
        <translation>1、2 或 3</translation>
    </message>
    <message>
        <source>2 or more</source>
        <translation>2 或更大</translation>
    </message>
    <message>
        <source>1, because this dimension is not used</source>
        <translation>1，因为该维度未使用</translation>
    </message>
    <message>
        <source>{count}, the product of the sizes</source>
        <translation>{count}，即各维大小之积</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限的数字</translation>
    </message>
    <message>
        <source>a finite number above 0</source>
        <translation>大于 0 的有限数字</translation>
    </message>
    <message>
        <source>one that leads to a finite last position</source>
        <translation>能使末位置为有限值的数字</translation>
    </message>
    <message>
        <source>one that tells positions such as {position} apart</source>
        <translation>能区分 {position} 这类位置的数字</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the header before it</source>
        <translation>{crc}，即其前文件头的 CRC</translation>
    </message>
    <message>
        <source>{crc}, the CRC of the elements</source>
        <translation>{crc}，即各元素的 CRC</translation>
    </message>
    <message>
        <source>the size of dimension {dimension} is {value}, at least 2 is needed</source>
        <translation>维度 {dimension} 的大小为 {value}，至少应为 2</translation>
    </message>
    <message>
        <source>the start value of dimension {dimension} is {value}, a finite number is needed</source>
        <translation>维度 {dimension} 的起始值为 {value}，应为有限的数字</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, a finite number above 0 is needed</source>
        <translation>维度 {dimension} 的间距为 {value}，应为大于 0 的有限数字</translation>
    </message>
    <message>
        <source>the distance of dimension {dimension} is {value}, too little to tell positions such as {position} apart</source>
        <translation>维度 {dimension} 的间距为 {value}，太小，无法区分 {position} 这类位置</translation>
    </message>
    <message>
        <source>the last position of dimension {dimension} is too large to be a number</source>
        <translation>维度 {dimension} 的末位置太大，无法用数字表示</translation>
    </message>
    <message>
        <source>the table has {count} dimensions, 1 to 3 are possible</source>
        <translation>该表有 {count} 个维度，只能为 1 至 3 个</translation>
    </message>
    <message>
        <source>the table has {count} values, which is not the product of its sizes</source>
        <translation>该表有 {count} 个值，不等于各维大小之积</translation>
    </message>
    <message>
        <source>the table has more values than a file can count</source>
        <translation>该表的值数超出文件可计的范围</translation>
    </message>
    <message>
        <source>value {number} is {value}, a finite number is needed</source>
        <translation>第 {number} 个值为 {value}，应为有限的数字</translation>
    </message>
    <message>
        <source>the table cannot be kept in this drive&apos;s table file: {reason}</source>
        <translation>该表无法存入此驱动器的表文件：{reason}</translation>
    </message>
    <message>
        <source>{value} does not fit into the field {field}, which is of type {type}</source>
        <translation>{value} 放不进类型为 {type} 的字段 {field}</translation>
    </message>
    <message>
        <source>the grid of dimension {dimension}, start {start} and distance {distance}, cannot be held by fields of the types {first} and {second}</source>
        <translation>维度 {dimension} 的网格（起始 {start}，间距 {distance}）无法用类型为 {first} 和 {second} 的字段表示</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>已由用户停止</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}</source>
        <translation>无法读取 {file}：{reason}</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}</source>
        <translation>无法写入 {file}：{reason}</translation>
    </message>
    <message>
        <source>{file} has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>{file} 有 {size} 字节，超过此类文件的上限 {limit}</translation>
    </message>
    <message>
        <source>this is not a valid TAM table: {field} at offset {offset} is {found}, expected {expected}</source>
        <translation>这不是有效的 TAM 表：偏移 {offset} 处的 {field} 为 {found}，应为：{expected}</translation>
    </message>
    <message>
        <source>the drive profile {file} is wrong at {path}: {reason}</source>
        <translation>驱动器描述文件 {file} 在 {path} 处有误：{reason}</translation>
    </message>
    <message>
        <source>the TAM configuration {file} is wrong in line {line}: {reason}</source>
        <translation>TAM 配置 {file} 第 {line} 行有误：{reason}</translation>
    </message>
    <message>
        <source>{file} is not a valid backup: {reason}</source>
        <translation>{file} 不是有效的备份：{reason}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}</source>
        <translation>无法识别 {file} 的格式；请指定其一：{known}</translation>
    </message>
    <message>
        <source>the name {file} says no format that can be written; name one with --to: {known}</source>
        <translation>从名称 {file} 看不出可写入的格式；请用 --to 指定其一：{known}</translation>
    </message>
    <message>
        <source>the format of {file} is not known; name one of: {known}; of any other CSV file, say which column is what</source>
        <translation>无法识别 {file} 的格式；请指定其一：{known}；若是其他 CSV 文件，请说明各列的含义</translation>
    </message>
    <message>
        <source>there is no table {table} in the file; it has: {known}</source>
        <translation>文件中没有表 {table}；其中有：{known}</translation>
    </message>
    <message>
        <source>{endpoint} is not the address of a drive: {reason}</source>
        <translation>{endpoint} 不是驱动器地址：{reason}</translation>
    </message>
    <message>
        <source>no connection to {endpoint}: {reason}</source>
        <translation>未能连接 {endpoint}：{reason}</translation>
    </message>
    <message>
        <source>the connection to {endpoint} was lost: {reason}</source>
        <translation>与 {endpoint} 的连接已断开：{reason}</translation>
    </message>
    <message>
        <source>{endpoint} did not answer within {seconds} s</source>
        <translation>{endpoint} 在 {seconds} s 内没有应答</translation>
    </message>
    <message>
        <source>{endpoint} did not answer as a drive does: expected {expected}, got {quote}</source>
        <translation>{endpoint} 的应答不像驱动器：应为 {expected}，收到 {quote}</translation>
    </message>
    <message>
        <source>the drive refused: {reason}</source>
        <translation>驱动器拒绝：{reason}</translation>
    </message>
    <message>
        <source>the drive has no register {path}</source>
        <translation>驱动器没有寄存器 {path}</translation>
    </message>
    <message>
        <source>the drive has no file {path}</source>
        <translation>驱动器没有文件 {path}</translation>
    </message>
    <message>
        <source>the drive does not allow this now: {reason}</source>
        <translation>驱动器目前不允许此操作：{reason}</translation>
    </message>
    <message>
        <source>the table does not fit: {reason}</source>
        <translation>该表不适用：{reason}</translation>
    </message>
    <message>
        <source>the drive refused the table: {reason}</source>
        <translation>驱动器拒绝该表：{reason}</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s, or write volatile</source>
        <translation>短时间内闪存操作过多；等待 {seconds} s，或以易失方式写入</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is in error {error}: {hint}</source>
        <translation>轴 {axis} 的补偿出现错误 {error}：{hint}</translation>
    </message>
    <message>
        <source>the drive has no axis {axis}; it has: {known}</source>
        <translation>驱动器没有轴 {axis}；现有：{known}</translation>
    </message>
    <message>
        <source>several axes are named {axis}: give the index, one of {matches}</source>
        <translation>有多个轴名为 {axis}：请给出轴的索引，{matches} 之一</translation>
    </message>
    <message>
        <source>axis {axis} of this drive has no compensation registers</source>
        <translation>此驱动器的轴 {axis} 没有补偿寄存器</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} is missing</source>
        <translation>缺少维度 {dimension} 的源</translation>
    </message>
    <message>
        <source>the drive has no register {source}{nearest}</source>
        <translation>驱动器没有寄存器 {source}{nearest}</translation>
    </message>
    <message>
        <source>{source} is of type {type}; a dimension source must be one of {allowed}</source>
        <translation>{source} 的类型为 {type}；维度源的类型必须是：{allowed}</translation>
    </message>
    <message>
        <source>{source} is a register of the drive {other}; a source must be on the drive itself, {drive}</source>
        <translation>{source} 是驱动器 {other} 的寄存器；源必须位于驱动器 {drive} 本身</translation>
    </message>
    <message>
        <source>{source} is the source of both dimension {first} and dimension {second}</source>
        <translation>{source} 同时是维度 {first} 和维度 {second} 的源</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or correct the unit in the file</source>
        <translation>{doubt}请选择其他源或列，或更正文件中的单位</translation>
    </message>
    <message>
        <source>the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds {largest}</source>
        <translation>该表需要 {size} 字节，而可占用的最大表槽 {slot} 只能容纳 {largest}</translation>
    </message>
    <message>
        <source>the drive has no slot {slot}; it has: {known}</source>
        <translation>驱动器没有表槽 {slot}；现有：{known}</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}</source>
        <translation>表槽 {slot} 正由 {user} 使用</translation>
    </message>
    <message>
        <source>no slot is free for a table of {size} bytes: {slots}; name one to overwrite it</source>
        <translation>没有可容纳 {size} 字节表的空闲表槽：{slots}；如要覆盖，请指定一个</translation>
    </message>
    <message>
        <source>axis {axis} has no table on the drive; write one first</source>
        <translation>轴 {axis} 在驱动器上没有表；请先写入</translation>
    </message>
    <message>
        <source>axis {axis} already has all of this; there is nothing to write</source>
        <translation>轴 {axis} 已与此完全一致；无需写入</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is active; deactivate it first</source>
        <translation>轴 {axis} 的补偿已启用；请先停用</translation>
    </message>
    <message>
        <source>axis {axis} must be homed first</source>
        <translation>轴 {axis} 必须先回原点</translation>
    </message>
    <message>
        <source>this is another drive: expected serial number {expected}, found {found}</source>
        <translation>这是另一台驱动器：应为序列号 {expected}，实为 {found}</translation>
    </message>
    <message>
        <source>somebody else changed {what} from {before} to {now}; nothing was written, look again</source>
        <translation>{what}已在别处从 {before} 改为 {now}；未写入任何内容，请重新核对</translation>
    </message>
    <message>
        <source>{what} read back as {found}, but {expected} was written</source>
        <translation>{what}：回读为 {found}，写入的是 {expected}</translation>
    </message>
    <message>
        <source>the drive does not add what it should: {what} at {position} is {found}, expected {expected}</source>
        <translation>驱动器叠加的值不对：位置 {position} 处{what}为 {found}，应为 {expected}</translation>
    </message>
    <message>
        <source>{reason}. The drive holds the complete old or the complete new state; ask for the status when it answers again. The old state is kept in {backup}</source>
        <translation>{reason}。驱动器保持完整的旧状态或完整的新状态；待其重新应答后查询状态。旧状态保存在 {backup}</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis; restore it from {backup}</source>
        <translation>{reason}；恢复旧状态也失败（{rollback}）。不要启用该轴；请用 {backup} 还原</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>不存在</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation>磁盘配额已用完</translation>
    </message>
    <message>
        <source>the file system is read-only</source>
        <translation>文件系统为只读</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>这是一个文件夹</translation>
    </message>
    <message>
        <source>a part of the path is not a folder</source>
        <translation>路径的一部分不是文件夹</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>名称过长</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>符号链接形成循环</translation>
    </message>
    <message>
        <source>it would be larger than a file may be here</source>
        <translation>将超过此处允许的文件大小</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>磁盘报告错误</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>the folder {folder} does not exist</source>
        <translation>文件夹 {folder} 不存在</translation>
    </message>
    <message>
        <source>more than {size}</source>
        <translation>超过 {size}</translation>
    </message>
    <message>
        <source>another program is using it; try again when that one has finished</source>
        <translation>另一程序正在使用；待其结束后重试</translation>
    </message>
    <message>
        <source>it cannot be locked: {reason}</source>
        <translation>无法锁定：{reason}</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>这不是 JSON</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>line {line}, column {column}</source>
        <translation>第 {line} 行，第 {column} 列</translation>
    </message>
    <message>
        <source>{place}: {problem}</source>
        <translation>{place}：{problem}</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is there twice in one object</source>
        <translation>成员“{name}”在同一对象中出现两次</translation>
    </message>
    <message>
        <source>the member &quot;{name}&quot; is not known</source>
        <translation>无法识别成员“{name}”</translation>
    </message>
    <message>
        <source>it has more than {count} values</source>
        <translation>超过 {count} 个值</translation>
    </message>
    <message>
        <source>it is nested deeper than {count} levels</source>
        <translation>嵌套超过 {count} 层</translation>
    </message>
    <message>
        <source>it has {size} bytes, more than the {limit} that such a file can have</source>
        <translation>有 {size} 字节，超过此类文件的上限 {limit}</translation>
    </message>
    <message>
        <source>an object is expected, not {found}</source>
        <translation>应为对象，实为 {found}</translation>
    </message>
    <message>
        <source>a list is expected, not {found}</source>
        <translation>应为列表，实为 {found}</translation>
    </message>
    <message>
        <source>a text is expected, not {found}</source>
        <translation>应为文本，实为 {found}</translation>
    </message>
    <message>
        <source>true or false is expected, not {found}</source>
        <translation>应为 true 或 false，实为 {found}</translation>
    </message>
    <message>
        <source>a number is expected, not {found}</source>
        <translation>应为数字，实为 {found}</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most} is expected, not {found}</source>
        <translation>应为 {least} 至 {most} 的整数，实为 {found}</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>this is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>this is not base64</source>
        <translation>这不是 base64</translation>
    </message>
    <message>
        <source>this is too large for a Single</source>
        <translation>超出 Single 的范围</translation>
    </message>
    <message>
        <source>a number is expected, or NaN, Infinity, -Infinity as a text</source>
        <translation>应为数字，或文本 NaN、Infinity、-Infinity</translation>
    </message>
    <message>
        <source>the bytes have the CRC-32 {crc}, so they are damaged</source>
        <translation>这些字节的 CRC-32 为 {crc}，即已损坏</translation>
    </message>
    <message>
        <source>this file is there twice</source>
        <translation>该文件出现两次</translation>
    </message>
    <message>
        <source>this axis of the drive is there twice</source>
        <translation>驱动器的该轴出现两次</translation>
    </message>
    <message>
        <source>&quot;{format}&quot; is expected</source>
        <translation>应为“{format}”</translation>
    </message>
    <message>
        <source>only version {version} can be read; a newer version of this program may have written it</source>
        <translation>只能读取版本 {version}；该文件可能由本程序的更新版本写成</translation>
    </message>
    <message>
        <source>one of Boolean, Int32, UInt32, Single, Double, Enum is expected</source>
        <translation>应为 Boolean、Int32、UInt32、Single、Double、Enum 之一</translation>
    </message>
    <message>
        <source>a time such as 2026-11-21T08:02:23Z is expected</source>
        <translation>应为时间，例如 2026-11-21T08:02:23Z</translation>
    </message>
    <message>
        <source>a CRC-32 of eight hexadecimal digits such as 1c291ca3 is expected</source>
        <translation>应为八位十六进制的 CRC-32，例如 1c291ca3</translation>
    </message>
    <message>
        <source>it was closed before the reply was complete</source>
        <translation>应答尚未完整，连接就已关闭</translation>
    </message>
    <message>
        <source>nothing listens there; is the drive switched on, and is the address right?</source>
        <translation>该处没有应答；驱动器是否已上电，地址是否正确？</translation>
    </message>
    <message>
        <source>the network does not know the name {name}</source>
        <translation>网络中没有名称 {name}</translation>
    </message>
    <message>
        <source>there is no https; try http://, or another port</source>
        <translation>不支持 https；请改用 http:// 或其他端口</translation>
    </message>
    <message>
        <source>write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or demo:</source>
        <translation>写作 http://host[:port]、https://host[:port]、serial:/dev/ttyUSB0 或 demo:</translation>
    </message>
    <message>
        <source>the host is missing; write http://192.168.1.20 or http://host:8080</source>
        <translation>缺少主机；写作 http://192.168.1.20 或 http://host:8080</translation>
    </message>
    <message>
        <source>only host and port belong here, no path</source>
        <translation>此处只写主机和端口，不写路径</translation>
    </message>
    <message>
        <source>port 0 cannot be reached</source>
        <translation>端口 0 不可达</translation>
    </message>
    <message>
        <source>the device must be an absolute path such as serial:/dev/ttyUSB0</source>
        <translation>设备必须是绝对路径，例如 serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>the only option is baud, as in serial:/dev/ttyUSB0?baud=115200</source>
        <translation>唯一的选项是 baud，例如 serial:/dev/ttyUSB0?baud=115200</translation>
    </message>
    <message>
        <source>you have no permission to look into its folder</source>
        <translation>没有查看其文件夹的权限</translation>
    </message>
    <message>
        <source>the port cannot be used</source>
        <translation>该端口无法使用</translation>
    </message>
    <message>
        <source>the serial port is gone; was the cable or the adapter unplugged?</source>
        <translation>串口已消失；电缆或适配器是否被拔出？</translation>
    </message>
    <message>
        <source>another program is using the port; close it there</source>
        <translation>另一程序正在使用该端口；请在那里关闭</translation>
    </message>
    <message>
        <source>this is no serial port ({reason})</source>
        <translation>这不是串口（{reason}）</translation>
    </message>
    <message>
        <source>the port cannot do {speed} baud</source>
        <translation>该端口不支持 {speed} 波特</translation>
    </message>
    <message>
        <source>the reply of a drive at {speed} baud</source>
        <translation>驱动器以 {speed} 波特发出的应答</translation>
    </message>
    <message>
        <source>name, serial number, axes and profile</source>
        <translation>名称、序列号、轴和描述文件</translation>
    </message>
    <message>
        <source>the number of lines that follow</source>
        <translation>后续行数</translation>
    </message>
    <message>
        <source>the line garbles too much; check the cable, or try a lower baud rate</source>
        <translation>线路误码过多；请检查电缆，或改用较低的波特率</translation>
    </message>
    <message>
        <source>the drive began anew</source>
        <translation>驱动器已重新开始</translation>
    </message>
    <message>
        <source>a size of at most {most} and a CRC</source>
        <translation>不超过 {most} 的大小和 CRC</translation>
    </message>
    <message>
        <source>a type and a value</source>
        <translation>类型和值</translation>
    </message>
    <message>
        <source>an address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>how many registers there are</source>
        <translation>寄存器个数</translation>
    </message>
    <message>
        <source>path, address, type and value</source>
        <translation>路径、地址、类型和值</translation>
    </message>
    <message>
        <source>the rest of the registers</source>
        <translation>其余寄存器</translation>
    </message>
    <message>
        <source>the serial link writes 1 to {most} registers at one instant, not {count}</source>
        <translation>串行连接一次可同时写入 1 至 {most} 个寄存器，不能是 {count} 个</translation>
    </message>
    <message>
        <source>path, size and maximum size</source>
        <translation>路径、大小和大小上限</translation>
    </message>
    <message>
        <source>a redirect to {address}</source>
        <translation>重定向到 {address}</translation>
    </message>
    <message>
        <source>a redirect to {address}; give its address with https://</source>
        <translation>重定向到 {address}；请用 https:// 给出其地址</translation>
    </message>
    <message>
        <source>the answer itself</source>
        <translation>应答本身</translation>
    </message>
    <message>
        <source>success or a refusal</source>
        <translation>成功或拒绝</translation>
    </message>
    <message>
        <source>HTTP status {status}</source>
        <translation>HTTP 状态 {status}</translation>
    </message>
    <message>
        <source>HTTP status {status}, {text}</source>
        <translation>HTTP 状态 {status}，{text}</translation>
    </message>
    <message>
        <source>HTTP status {status} and {text}</source>
        <translation>HTTP 状态 {status} 和 {text}</translation>
    </message>
    <message>
        <source>an HTTP reply</source>
        <translation>HTTP 应答</translation>
    </message>
    <message>
        <source>the status line of an HTTP reply</source>
        <translation>HTTP 应答的状态行</translation>
    </message>
    <message>
        <source>a header field of an HTTP reply</source>
        <translation>HTTP 应答的头字段</translation>
    </message>
    <message>
        <source>a head of at most 64 KiB</source>
        <translation>不超过 64 KiB 的头部</translation>
    </message>
    <message>
        <source>one Content-Length</source>
        <translation>一个 Content-Length</translation>
    </message>
    <message>
        <source>no Transfer-Encoding but chunked</source>
        <translation>Transfer-Encoding 只能为 chunked</translation>
    </message>
    <message>
        <source>the size of a chunk</source>
        <translation>分块的大小</translation>
    </message>
    <message>
        <source>the end of a chunk</source>
        <translation>分块的结尾</translation>
    </message>
    <message>
        <source>at most {count} files</source>
        <translation>最多 {count} 个文件</translation>
    </message>
    <message>
        <source>file paths without blanks</source>
        <translation>不含空格的文件路径</translation>
    </message>
    <message>
        <source>an actual size of {path} up to its maximum size</source>
        <translation>{path} 的实际大小不超过其上限</translation>
    </message>
    <message>
        <source>the file {path} once</source>
        <translation>文件 {path} 一次</translation>
    </message>
    <message>
        <source>a file, its size and its maximum size in each row</source>
        <translation>每行一个文件及其大小和大小上限</translation>
    </message>
    <message>
        <source>sizes in bytes</source>
        <translation>以字节为单位的大小</translation>
    </message>
    <message>
        <source>a JSON array of files</source>
        <translation>文件的 JSON 数组</translation>
    </message>
    <message>
        <source>a file with path, size and maximumSize</source>
        <translation>带有 path、size 和 maximumSize 的文件</translation>
    </message>
    <message>
        <source>at least one file in the table</source>
        <translation>表中至少一个文件</translation>
    </message>
    <message>
        <source>a Directory page with a table of File, actual size and maximum size</source>
        <translation>Directory 页，含 File、actual size 和 maximum size 的表</translation>
    </message>
    <message>
        <source>a JSON array of registers</source>
        <translation>寄存器的 JSON 数组</translation>
    </message>
    <message>
        <source>a register with path, address, type and a value of that type</source>
        <translation>带有 path、address、type 和该类型值的寄存器</translation>
    </message>
    <message>
        <source>registers below {path}</source>
        <translation>{path} 下的寄存器</translation>
    </message>
    <message>
        <source>at most 1024 axes</source>
        <translation>最多 1024 个轴</translation>
    </message>
    <message>
        <source>more</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>status 204 without a body</source>
        <translation>无正文的状态 204</translation>
    </message>
    <message>
        <source>a file with its Content-Length</source>
        <translation>带有 Content-Length 的文件</translation>
    </message>
    <message>
        <source>the bytes of {path}</source>
        <translation>{path} 的字节</translation>
    </message>
    <message>
        <source>a reply</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>flipped bytes</source>
        <translation>错乱的字节</translation>
    </message>
    <message>
        <source>the connection was cut</source>
        <translation>连接被切断</translation>
    </message>
    <message>
        <source>the drive rebooted</source>
        <translation>驱动器已重启</translation>
    </message>
    <message>
        <source>a request reads at most {most} registers, not {count}</source>
        <translation>一次请求最多读取 {most} 个寄存器，不能是 {count} 个</translation>
    </message>
    <message>
        <source>a request writes 1 to {most} registers, not {count}</source>
        <translation>一次请求写入 1 至 {most} 个寄存器，不能是 {count} 个</translation>
    </message>
    <message>
        <source>{path} is written twice in one request</source>
        <translation>{path} 在一次请求中写了两次</translation>
    </message>
    <message>
        <source>{path} is read-only</source>
        <translation>{path} 为只读</translation>
    </message>
    <message>
        <source>{path} is of type {type}, and cannot be {value}</source>
        <translation>{path} 的类型为 {type}，不能是 {value}</translation>
    </message>
    <message>
        <source>{path} is of type {type}, one of {names}, and cannot be {value}</source>
        <translation>{path} 的类型为 {type}，即 {names} 之一，不能是 {value}</translation>
    </message>
    <message>
        <source>the compensation of {axis} is on, so {what} must stay; deactivate it</source>
        <translation>{axis} 的补偿已开启，{what}不能改变；请先停用</translation>
    </message>
    <message>
        <source>its homing</source>
        <translation>其回原点状态</translation>
    </message>
    <message>
        <source>the table in {slot}</source>
        <translation>{slot} 中的表</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be persistent</source>
        <translation>{slot} 中没有可设为持久的表</translation>
    </message>
    <message>
        <source>there is no table in {slot} that could be committed</source>
        <translation>{slot} 中没有可存入闪存的表</translation>
    </message>
    <message>
        <source>{path} can have {most} bytes, not {size}</source>
        <translation>{path} 可容纳 {most} 字节，不能是 {size}</translation>
    </message>
    <message>
        <source>the drive&apos;s flash failed: {reason}</source>
        <translation>驱动器闪存失败：{reason}</translation>
    </message>
    <message>
        <source>the axis must be homed first</source>
        <translation>轴必须先回原点</translation>
    </message>
    <message>
        <source>the axis has no table; write one first</source>
        <translation>该轴没有表；请先写入</translation>
    </message>
    <message>
        <source>the number of sources must equal the table&apos;s dimensions</source>
        <translation>源的个数必须等于表的维数</translation>
    </message>
    <message>
        <source>a source is not a Single or Double register of this drive</source>
        <translation>有一个源不是此驱动器的 Single 或 Double 寄存器</translation>
    </message>
    <message>
        <source>the drive cannot use the table; write it again</source>
        <translation>驱动器无法使用该表；请重新写入</translation>
    </message>
    <message>
        <source>see the drive&apos;s manual</source>
        <translation>参见驱动器手册</translation>
    </message>
    <message>
        <source>the drive has restarted, or somebody else has switched the compensation</source>
        <translation>驱动器已重启，或补偿已在别处被切换</translation>
    </message>
    <message>
        <source>it did not become {state} in time</source>
        <translation>未能及时变为 {state}</translation>
    </message>
    <message>
        <source>only an active or an evaluating compensation can be proved</source>
        <translation>只能验证已启用或试算中的补偿</translation>
    </message>
    <message>
        <source>No other slot is free: the table in {slot} is overwritten. A copy is kept in the backup.</source>
        <translation>没有其他空闲表槽：{slot} 中的表将被覆盖。备份中保留副本。</translation>
    </message>
    <message>
        <source>What {slot} holds now is overwritten. A copy is kept in the backup.</source>
        <translation>{slot} 现有的内容将被覆盖。备份中保留副本。</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved, but the table of {axis} in {slot} is volatile: after a reboot that axis has no table.</source>
        <translation>将保存所有轴的参数，但 {axis} 在 {slot} 中的表是易失的：重启后该轴没有表。</translation>
    </message>
    <message>
        <source>The new table is volatile and covers an older one that flash holds in {slot}: after a reboot the axis may have that one again, until the parameters are saved, which deletes it.</source>
        <translation>新表是易失的，并遮盖了闪存中 {slot} 的旧表：重启后该轴可能又使用旧表，直到保存参数时将其删除。</translation>
    </message>
    <message>
        <source>After a reboot the drive would look for another table in {slot}: the parameters are saved once before the new one goes into flash. When the write is interrupted then, the axis may have no table after a reboot.</source>
        <translation>重启后驱动器会在 {slot} 中查找另一个表：因此在新表存入闪存前先保存一次参数。如果写入在此时中断，该轴重启后可能没有表。</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: it is deleted before the parameters are saved.</source>
        <translation>闪存中 {slot} 可能有旧表：保存参数前将其删除。</translation>
    </message>
    <message>
        <source>the settings of {axis}</source>
        <translation>{axis} 的设置</translation>
    </message>
    <message>
        <source>axis {axis}</source>
        <translation>轴 {axis}</translation>
    </message>
    <message>
        <source>axis {axis} ({name})</source>
        <translation>轴 {axis}（{name}）</translation>
    </message>
    <message>
        <source>axis {axis} after a reboot</source>
        <translation>重启后的轴 {axis}</translation>
    </message>
    <message>
        <source>the cogging compensation of axis {axis}</source>
        <translation>轴 {axis} 的齿槽补偿</translation>
    </message>
    <message>
        <source>{slot} holds only {size} bytes</source>
        <translation>{slot} 只能容纳 {size} 字节</translation>
    </message>
    <message>
        <source>{slot} is used by {user}</source>
        <translation>{slot} 正由 {user} 使用</translation>
    </message>
    <message>
        <source>{slot} holds a table that is not this axis&apos;s</source>
        <translation>{slot} 中的表不属于该轴</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), persistent</source>
        <translation>{table} (CRC {crc})，持久</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), volatile</source>
        <translation>{table} (CRC {crc})，易失</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, persistent</source>
        <translation>{table} (CRC {crc})，{sources}，持久</translation>
    </message>
    <message>
        <source>{table} (CRC {crc}), {sources}, volatile</source>
        <translation>{table} (CRC {crc})，{sources}，易失</translation>
    </message>
    <message>
        <source>{path} at offset {offset}</source>
        <translation>{path}，偏移 {offset}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>the output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>the index of dimension {dimension}</source>
        <translation>维度 {dimension} 的索引</translation>
    </message>
    <message>
        <source>the dimensionality is 1, 2 or 3</source>
        <translation>维数为 1、2 或 3</translation>
    </message>
    <message>
        <source>; a URI is written tam://mc/&lt;drive&gt;/&lt;path&gt;</source>
        <translation>；URI 写作 tam://mc/&lt;驱动器&gt;/&lt;路径&gt;</translation>
    </message>
    <message>
        <source>; an address is written 0x and 1 to 8 hex digits</source>
        <translation>；地址写作 0x 加 1 至 8 位十六进制数字</translation>
    </message>
    <message>
        <source>: no register has this address</source>
        <translation>：没有寄存器使用该地址</translation>
    </message>
    <message>
        <source>; the nearest are {names}</source>
        <translation>；最接近的是 {names}</translation>
    </message>
    <message>
        <source>there is no backup that differs from what the axis has now</source>
        <translation>没有与该轴当前状态不同的备份</translation>
    </message>
    <message>
        <source>the program is ending</source>
        <translation>程序正在结束</translation>
    </message>
    <message>
        <source>the backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>axis {axis} has no Table register</source>
        <translation>轴 {axis} 没有 Table 寄存器</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with {separator} instead of tabs</source>
        <translation>{expected}；列之间用 {separator} 而不是制表符分隔</translation>
    </message>
    <message>
        <source>{expected}; separate the columns with , or ; instead of tabs</source>
        <translation>{expected}；列之间用 , 或 ; 而不是制表符分隔</translation>
    </message>
    <message>
        <source>{path} of type Int32</source>
        <translation>类型为 Int32 的 {path}</translation>
    </message>
    <message>
        <source>the settings of axis {axis}</source>
        <translation>轴 {axis} 的设置</translation>
    </message>
    <message>
        <source>the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is {fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has the same</source>
        <translation>无法信任 {endpoint} 的证书：{reason}。其 SHA-256 指纹为 {fingerprint}；如果驱动器的指纹与此相同，请在“连接”中或用 --trust-certificate 信任它</translation>
    </message>
    <message>
        <source>it has CHANGED and is not the one that was trusted</source>
        <translation>证书已改变，不是先前信任的那个</translation>
    </message>
    <message>
        <source>no write to axis {axis} is unfinished; there is nothing to finish or to undo</source>
        <translation>轴 {axis} 没有未完成的写入；没有可完成或可撤销的内容</translation>
    </message>
    <message>
        <source>the new table of the unfinished write to axis {axis} was not kept on this computer: write it again, or undo the write</source>
        <translation>轴 {axis} 未完成写入的新表没有保存在本计算机上：请重新写入，或撤销该写入</translation>
    </message>
    <message>
        <source>slot {slot}</source>
        <translation>表槽 {slot}</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent</source>
        <translation>{count} 个值 (CRC {crc})，持久</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile</source>
        <translation>{count} 个值 (CRC {crc})，易失</translation>
    </message>
    <message>
        <source>empty, used by {user}</source>
        <translation>空，由 {user} 使用</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), persistent, used by {user}</source>
        <translation>{count} 个值 (CRC {crc})，持久，由 {user} 使用</translation>
    </message>
    <message>
        <source>{count} values (CRC {crc}), volatile, used by {user}</source>
        <translation>{count} 个值 (CRC {crc})，易失，由 {user} 使用</translation>
    </message>
    <message>
        <source>the unfinished write to axis {axis}</source>
        <translation>轴 {axis} 未完成的写入</translation>
    </message>
    <message>
        <source>the name of a file beside the journal is expected</source>
        <translation>应为写入日志旁的文件名</translation>
    </message>
    <message>
        <source>it is not of axis {axis} of this drive</source>
        <translation>不属于此驱动器的轴 {axis}</translation>
    </message>
    <message>
        <source>{file} can be one of several formats: {candidates}; say which one it is</source>
        <translation>{file} 可能是多种格式之一：{candidates}；请指明是哪一种</translation>
    </message>
    <message>
        <source>the format {format} cannot hold this table: {reason}; {wayOut}</source>
        <translation>格式 {format} 无法容纳该表：{reason}；{wayOut}</translation>
    </message>
    <message>
        <source>the sign cannot be converted at {position}: {reason}</source>
        <translation>在 {position} 处无法换算符号：{reason}</translation>
    </message>
    <message>
        <source>the table cannot be resampled: {reason}</source>
        <translation>该表无法重采样：{reason}</translation>
    </message>
    <message>
        <source>the numbers of the file are taken as they are</source>
        <translation>文件中的数字按原样采用</translation>
    </message>
    <message>
        <source>sign: {from}; {example}</source>
        <translation>符号：{from}；{example}</translation>
    </message>
    <message>
        <source>{format} holds feedback values</source>
        <translation>{format} 存放反馈侧 (feedback) 的值</translation>
    </message>
    <message>
        <source>{format} holds command values</source>
        <translation>{format} 存放指令侧 (command) 的值</translation>
    </message>
    <message>
        <source>{format} holds feedback values, as you say</source>
        <translation>按您的说明，{format} 存放反馈侧 (feedback) 的值</translation>
    </message>
    <message>
        <source>{format} holds command values, as you say</source>
        <translation>按您的说明，{format} 存放指令侧 (command) 的值</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}</source>
        <translation>{example}：反馈侧文件中为 {value}</translation>
    </message>
    <message>
        <source>{example}: the command file says {value}</source>
        <translation>{example}：指令侧文件中为 {value}</translation>
    </message>
    <message>
        <source>{example}: the feedback file says {value}, the command file {other}</source>
        <translation>{example}：反馈侧文件中为 {value}，指令侧文件中为 {other}</translation>
    </message>
    <message>
        <source>all values are 0, in either sign</source>
        <translation>所有值均为 0，与符号无关</translation>
    </message>
    <message>
        <source>moving in positive direction, {example}</source>
        <translation>正方向运动时，{example}</translation>
    </message>
    <message>
        <source>moving in negative direction, {example}</source>
        <translation>负方向运动时，{example}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference says {moved}</source>
        <translation>编码器读数为 {place} 处，基准为 {moved}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} says {moved}</source>
        <translation>各编码器读数为 {place} 处，{axis} 的基准为 {moved}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>编码器读数为 {place} 处，{axis} 的基准比其编码器大 {offset}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>编码器读数为 {place} 处，{axis} 的基准比其编码器小 {offset}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} above its encoder</source>
        <translation>各编码器读数为 {place} 处，{axis} 的基准比其编码器大 {offset}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the reference of {axis} is {offset} below its encoder</source>
        <translation>各编码器读数为 {place} 处，{axis} 的基准比其编码器小 {offset}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}, where the reference says {reference}</source>
        <translation>指令位置为 {place} 时，控制器使编码器移到 {moved}，该处基准为 {reference}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}, where the reference says {reference}</source>
        <translation>指令位置为 {place} 时，控制器使 {axis} 的编码器移到 {moved}，该处基准为 {reference}</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} above its encoder, the controller moves {target} by {value}</source>
        <translation>指令位置为 {place} 时，{axis} 的基准比其编码器大 {offset}，控制器使 {target} 移动 {value}</translation>
    </message>
    <message>
        <source>commanded to {place}, where the reference of {axis} is {offset} below its encoder, the controller moves {target} by {value}</source>
        <translation>指令位置为 {place} 时，{axis} 的基准比其编码器小 {offset}，控制器使 {target} 移动 {value}</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>目标轴</translation>
    </message>
    <message>
        <source>{axis} = {position}</source>
        <translation>{axis} = {position}</translation>
    </message>
    <message>
        <source>resampled from {before} points to {after} points: at the positions of the source it is off by at most {largest}, {rms} rms</source>
        <translation>由 {before} 点重采样为 {after} 点：在原有位置上最多相差 {largest}，均方根 {rms}</translation>
    </message>
    <message>
        <source>the values of the file are rounded by up to {amount}</source>
        <translation>文件中的值因舍入最多相差 {amount}</translation>
    </message>
    <message>
        <source>the positions of the file are rounded by up to {amount}</source>
        <translation>文件中的位置因舍入最多相差 {amount}</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules: {difference}</source>
        <translation>在 {count} 个位置上比较，各按其控制器的规则：{difference}</translation>
    </message>
    <message>
        <source>compared at {count} positions, each by its controller&apos;s rules ({column}): {difference}</source>
        <translation>在 {count} 个位置上比较，各按其控制器的规则（{column}）：{difference}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}</source>
        <translation>最多相差 {largest}，在 {place}</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, where both have values by at most {inside}</source>
        <translation>最多相差 {largest}，在 {place}；两者都有值之处最多相差 {inside}</translation>
    </message>
    <message>
        <source>at the ends of the table the sign was converted with the end values held, where the controller of the source applies nothing</source>
        <translation>在表的两端，符号按保持端值换算，而源控制器在该处不作补偿</translation>
    </message>
    <message>
        <source>the {what} have no unit; they are taken to be {unit}</source>
        <translation>{what}没有单位；按 {unit} 处理</translation>
    </message>
    <message>
        <source>the positions are in {unit}</source>
        <translation>位置的单位：{unit}</translation>
    </message>
    <message>
        <source>the values are in {unit}</source>
        <translation>值的单位：{unit}</translation>
    </message>
    <message>
        <source>positions and values are in {unit}</source>
        <translation>位置和值的单位：{unit}</translation>
    </message>
    <message>
        <source>no known unit</source>
        <translation>未知单位</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} behind it</source>
        <translation>{range}：网格止于 {end}，超出 {distance}</translation>
    </message>
    <message>
        <source>{range}: the grid ends at {end}, {distance} before its end</source>
        <translation>{range}：网格止于 {end}，距其末端还有 {distance}</translation>
    </message>
    <message>
        <source>the range of {axis} from {from} to {to} is no whole multiple of {distance}</source>
        <translation>{axis} 从 {from} 到 {to} 的范围不是 {distance} 的整数倍</translation>
    </message>
    <message>
        <source>a number of points is a whole number, at least 2</source>
        <translation>点数应为不小于 2 的整数</translation>
    </message>
    <message>
        <source>the number for the even grid is missing</source>
        <translation>缺少均匀网格的数字</translation>
    </message>
    <message>
        <source>the even grid needs one number, or one for each of the {count} source axes</source>
        <translation>均匀网格需要一个数字，或为 {count} 个源轴各给一个</translation>
    </message>
    <message>
        <source>the format {format} can be written, not read</source>
        <translation>格式 {format} 只能写，不能读</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key} ({meaning})</source>
        <translation>格式 {format} 需要设置 {key}（{meaning}）</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected {expected} ({meaning})</source>
        <translation>设置 {key} 为“{value}”，应为：{expected}（{meaning}）</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>one of {choices}</source>
        <translation>{choices} 之一</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes 或 no</translation>
    </message>
    <message>
        <source>the positions of source {number} are not evenly spaced</source>
        <translation>源 {number} 的位置间距不均匀</translation>
    </message>
    <message>
        <source>resample it onto an even grid</source>
        <translation>将其重采样到均匀网格</translation>
    </message>
    <message>
        <source>resample it onto a coarser grid</source>
        <translation>将其重采样到较粗的网格</translation>
    </message>
    <message>
        <source>it takes one distance for all sources, and these are different</source>
        <translation>它对所有源只用一个间距，而这里各不相同</translation>
    </message>
    <message>
        <source>resample it with the same distance for each source</source>
        <translation>以各源相同的间距重采样</translation>
    </message>
    <message>
        <source>it has one value for both directions of motion</source>
        <translation>它对两个运动方向只有一个值</translation>
    </message>
    <message>
        <source>choose the mean, the positive or the negative direction</source>
        <translation>选择平均值、正方向或负方向</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>选择其他格式</translation>
    </message>
    <message>
        <source>{count} points are more than the {limit} that the controller takes</source>
        <translation>{count} 点超过控制器可接受的 {limit} 点</translation>
    </message>
    <message>
        <source>it has no modulo axes</source>
        <translation>它不支持模数轴</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap, in a machine file no-wrap = true) when it stays within one revolution</source>
        <translation>若该轴始终在一转之内，按直线轴处理 (--no-wrap，在机床文件中为 no-wrap = true)</translation>
    </message>
    <message>
        <source>its values are offsets of the command</source>
        <translation>其值是指令的偏移量</translation>
    </message>
    <message>
        <source>convert the sign</source>
        <translation>换算符号</translation>
    </message>
    <message>
        <source>a value is beyond what a float32 can be</source>
        <translation>有一个值超出 float32 的范围</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>检查值的单位</translation>
    </message>
    <message>
        <source>a grid along {axis} needs at least two points</source>
        <translation>沿 {axis} 的网格至少需要两点</translation>
    </message>
    <message>
        <source>the distance along {axis} must be a number above 0</source>
        <translation>沿 {axis} 的间距必须大于 0</translation>
    </message>
    <message>
        <source>the positions of {axis} are not evenly spaced; give a number of points or a distance</source>
        <translation>{axis} 的位置间距不均匀；请给出点数或间距</translation>
    </message>
    <message>
        <source>the full turn of {axis}, {turn}, is no whole multiple of {distance}; possible are {fewer} or {more}</source>
        <translation>{axis} 的一整转 {turn} 不是 {distance} 的整数倍；可用 {fewer} 或 {more}</translation>
    </message>
    <message>
        <source>a distance of {distance} is longer than the range of {axis} from {from} to {to}; take a shorter one, or let the end values be held</source>
        <translation>间距 {distance} 大于 {axis} 从 {from} 到 {to} 的范围；请取较小的间距，或允许保持端值</translation>
    </message>
    <message>
        <source>the grid would have more than {count} points; take fewer along an axis</source>
        <translation>网格将超过 {count} 点；请在某个轴上减少点数</translation>
    </message>
    <message>
        <source>calibration file: reference positions and compensation values</source>
        <translation>校准文件：基准位置和补偿值</translation>
    </message>
    <message>
        <source>table file of the drive, laid out as the drive profile says</source>
        <translation>驱动器的表文件，结构由驱动器描述文件规定</translation>
    </message>
    <message>
        <source>CSV file of positions and offsets</source>
        <translation>位置和偏移量的 CSV 文件</translation>
    </message>
    <message>
        <source>cross compensation in a compensation list (kw.crosscomp)</source>
        <translation>补偿列表中的交叉补偿 (kw.crosscomp)</translation>
    </message>
    <message>
        <source>plane compensation in a compensation list (kw.crosscomp2)</source>
        <translation>补偿列表中的平面补偿 (kw.crosscomp2)</translation>
    </message>
    <message>
        <source>leadscrew error compensation in a compensation list (kw.ssfk)</source>
        <translation>补偿列表中的丝杠螺距误差补偿 (kw.ssfk)</translation>
    </message>
    <message>
        <source>compensation file of a joint: nominal forward reverse</source>
        <translation>关节的补偿文件：名义位置 正向 反向</translation>
    </message>
    <message>
        <source>CSV file of this program with the table of a compensator</source>
        <translation>本程序的 CSV 文件，含一个补偿器的表</translation>
    </message>
    <message>
        <source>C++ header with the table of a compensator</source>
        <translation>C++ 头文件，含一个补偿器的表</translation>
    </message>
    <message>
        <source>sag and angularity compensation ($AN_CEC)</source>
        <translation>垂度与角度误差补偿 ($AN_CEC)</translation>
    </message>
    <message>
        <source>encoder and leadscrew error compensation ($AA_ENC_COMP)</source>
        <translation>编码器与丝杠螺距误差补偿 ($AA_ENC_COMP)</translation>
    </message>
    <message>
        <source>text table of positions and corrections</source>
        <translation>位置和修正量的文本表</translation>
    </message>
    <message>
        <source>MC-BASIC assignments to SourceData and TargetData</source>
        <translation>对 SourceData 和 TargetData 的 MC-BASIC 赋值</translation>
    </message>
    <message>
        <source>of a rotary axis: the range after which its position begins again, such as 360</source>
        <translation>对回转轴：位置重新开始的范围，例如 360</translation>
    </message>
    <message>
        <source>logical number of the axis whose position counts, for master_ax_nr</source>
        <translation>以其位置为准的轴的逻辑号，用于 master_ax_nr</translation>
    </message>
    <message>
        <source>cycles over which switching is smoothed, for n_cycles</source>
        <translation>平滑切换所用的周期数，用于 n_cycles</translation>
    </message>
    <message>
        <source>the master is a modulo axis: the first and the last point are one place</source>
        <translation>主动轴是模数轴：首点和末点是同一处</translation>
    </message>
    <message>
        <source>whether the master axis is linear (mm) or rotary (deg)</source>
        <translation>主动轴是直线轴 (mm) 还是回转轴 (deg)</translation>
    </message>
    <message>
        <source>whether the compensated axis is linear (mm) or rotary (deg)</source>
        <translation>被补偿的轴是直线轴 (mm) 还是回转轴 (deg)</translation>
    </message>
    <message>
        <source>whether the axis is linear (mm) or rotary (deg)</source>
        <translation>该轴是直线轴 (mm) 还是回转轴 (deg)</translation>
    </message>
    <message>
        <source>metric: 0.1 um and 0.0001 deg; increments: of the encoder</source>
        <translation>metric：0.1 um 和 0.0001 deg；increments：编码器增量</translation>
    </message>
    <message>
        <source>encoder increments for one mm or degree, of a list in increments</source>
        <translation>每 mm 或每度的编码器增量数，用于以增量为单位的列表</translation>
    </message>
    <message>
        <source>write numbers with decimals, which only newer kernels take</source>
        <translation>写入带小数的数字，仅较新的内核可读</translation>
    </message>
    <message>
        <source>logical number of the axis that is compensated, for kopf.achs_nr</source>
        <translation>被补偿轴的逻辑号，用于 kopf.achs_nr</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims; 0 is assumed</source>
        <translation>COMP_FILE_TYPE：0 为测得的位置，1 为修正量；默认按 0</translation>
    </message>
    <message>
        <source>COMP_FILE_TYPE: 0 for measured positions, 1 for trims</source>
        <translation>COMP_FILE_TYPE：0 为测得的位置，1 为修正量</translation>
    </message>
    <message>
        <source>raw counts of the output axis for one unit of the values</source>
        <translation>值的每单位对应输出轴的原始计数</translation>
    </message>
    <message>
        <source>the same, where the file does not say it</source>
        <translation>同上，用于文件未注明时</translation>
    </message>
    <message>
        <source>unit of the positions, the user unit of the input axes</source>
        <translation>位置的单位，即输入轴的用户单位</translation>
    </message>
    <message>
        <source>unit of the values, the user unit of the output axis; otherwise that of the positions</source>
        <translation>值的单位，即输出轴的用户单位；否则与位置的单位相同</translation>
    </message>
    <message>
        <source>namespace of the constants, a C++ name</source>
        <translation>常量的命名空间，C++ 名称</translation>
    </message>
    <message>
        <source>unit of the positions, where the file does not say it</source>
        <translation>位置的单位，用于文件未注明时</translation>
    </message>
    <message>
        <source>unit of the values, where the file does not say it</source>
        <translation>值的单位，用于文件未注明时</translation>
    </message>
    <message>
        <source>index of the first table that is written</source>
        <translation>写入的第一个表的编号</translation>
    </message>
    <message>
        <source>name of the axis whose position counts, instead of the table&apos;s name for it</source>
        <translation>以其位置为准的轴的名称，取代表中的名称</translation>
    </message>
    <message>
        <source>name of the axis that is compensated, instead of the table&apos;s name for it</source>
        <translation>被补偿轴的名称，取代表中的名称</translation>
    </message>
    <message>
        <source>name of the machine axis, such as X1, instead of the table&apos;s name for it</source>
        <translation>机床轴的名称，例如 X1，取代表中的名称</translation>
    </message>
    <message>
        <source>measuring system of the axis, instead of that of the program that was read, or 0</source>
        <translation>轴的测量系统，代替所读程序中的测量系统，没有则为 0</translation>
    </message>
    <message>
        <source>name of the compensation table in the MC-BASIC program</source>
        <translation>MC-BASIC 程序中补偿表的名称</translation>
    </message>
    <message>
        <source>the drive stores the table in its flash</source>
        <translation>驱动器将该表存入其闪存</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: they are the same</source>
        <translation>两个运动方向共用一个值，{choice}：两者相同</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: they are the same</source>
        <translation>两个运动方向共用一个值，{choice}，用于 {target}：两者相同</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}: half their difference is up to {loss}, at {place}</source>
        <translation>两个运动方向共用一个值，{choice}：两者之差的一半最大为 {loss}，在 {place}</translation>
    </message>
    <message>
        <source>one value for both directions of motion, {choice}, for {target}: half their difference is up to {loss}, at {place}</source>
        <translation>两个运动方向共用一个值，{choice}，用于 {target}：两者之差的一半最大为 {loss}，在 {place}</translation>
    </message>
    <message>
        <source>they do not differ</source>
        <translation>两者没有差别</translation>
    </message>
    <message>
        <source>they differ by at most {largest} at {place}, and not at all where both have values</source>
        <translation>最多相差 {largest}，在 {place}；两者都有值之处没有差别</translation>
    </message>
    <message>
        <source>number of the axis, from 1, instead of the table&apos;s name for it</source>
        <translation>轴号，从 1 起，取代表中的名称</translation>
    </message>
    <message>
        <source>calibration file of single axes (:START)</source>
        <translation>单轴校准文件 (:START)</translation>
    </message>
    <message>
        <source>calibration file of two axes (:START2D)</source>
        <translation>两轴校准文件 (:START2D)</translation>
    </message>
    <message>
        <source>numbers of the axes for which METRIC means degrees, such as 4,5; all others mm</source>
        <translation>METRIC 表示度的轴号，例如 4,5；其余均为 mm</translation>
    </message>
    <message>
        <source>what PRIMARY stands for, such as mm</source>
        <translation>PRIMARY 所代表的单位，例如 mm</translation>
    </message>
    <message>
        <source>METRIC (mm and degrees), or PRIMARY: the table&apos;s own units are those of the axes</source>
        <translation>METRIC（mm 和度）或 PRIMARY：表自身的单位即各轴的单位</translation>
    </message>
    <message>
        <source>[bed_mesh NAME] sections of printer.cfg: heights of the bed</source>
        <translation>printer.cfg 的 [bed_mesh NAME] 段：打印床高度</translation>
    </message>
    <message>
        <source>heightmap.csv, version 2: heights of the bed</source>
        <translation>heightmap.csv，版本 2：打印床高度</translation>
    </message>
    <message>
        <source>names of the axes in degrees, such as C,B; all others are in mm, and modulo axes in degrees anyway</source>
        <translation>以度为单位的轴名，例如 C,B；其余均为 mm，模数轴则总以度为单位</translation>
    </message>
    <message>
        <source>leadscrew compensation of one source (DEFINE COMP)</source>
        <translation>单源丝杠螺距误差补偿 (DEFINE COMP)</translation>
    </message>
    <message>
        <source>compensation of a motor by two others (DEFINE COMP)</source>
        <translation>以另外两个电机补偿一个电机 (DEFINE COMP)</translation>
    </message>
    <message>
        <source>encoder counts for one unit, of every motor without a setting of its own</source>
        <translation>每单位的编码器计数，用于所有没有单独设置的电机</translation>
    </message>
    <message>
        <source>encoder counts for one unit; without it tables are in counts</source>
        <translation>每单位的编码器计数；未给出时表以计数为单位</translation>
    </message>
    <message>
        <source>position of the sources that counts: desired (written with D) or actual</source>
        <translation>以源的哪个位置为准：desired（写作 D）或 actual</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the positions</source>
        <translation>位置的每单位编码器计数</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the values</source>
        <translation>值的每单位编码器计数</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the row motor</source>
        <translation>行电机的每单位编码器计数</translation>
    </message>
    <message>
        <source>encoder counts for one unit of the column motor</source>
        <translation>列电机的每单位编码器计数</translation>
    </message>
    <message>
        <source>number of the motor whose position counts, 1 to 32</source>
        <translation>以其位置为准的电机号，1 至 32</translation>
    </message>
    <message>
        <source>number of the motor that is compensated, 1 to 32</source>
        <translation>被补偿的电机号，1 至 32</translation>
    </message>
    <message>
        <source>number of the motor along a row of entries, 1 to 32</source>
        <translation>沿一行条目变化的电机号，1 至 32</translation>
    </message>
    <message>
        <source>number of the motor from row to row, 1 to 32</source>
        <translation>逐行变化的电机号，1 至 32</translation>
    </message>
    <message>
        <source>number of the axis that changes along a line, from 1</source>
        <translation>沿一行变化的轴号，从 1 起</translation>
    </message>
    <message>
        <source>number of the axis that changes from line to line, from 1</source>
        <translation>逐行变化的轴号，从 1 起</translation>
    </message>
    <message>
        <source>number of the axis of the first corrections, from 1</source>
        <translation>第一组修正量的轴号，从 1 起</translation>
    </message>
    <message>
        <source>number of the axis of the second corrections, from 1</source>
        <translation>第二组修正量的轴号，从 1 起</translation>
    </message>
    <message>
        <source>number of the axis of the third corrections, from 1</source>
        <translation>第三组修正量的轴号，从 1 起</translation>
    </message>
    <message>
        <source>axis {axis} is named twice</source>
        <translation>轴 {axis} 被指定两次</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s, or write volatile</source>
        <translation>剩余的闪存操作足以完成更改，但失败时不足以全部恢复；等待 {seconds} s，或以易失方式写入</translation>
    </message>
    <message>
        <source>{axis} has fewer than two positions</source>
        <translation>{axis} 的位置少于两个</translation>
    </message>
    <message>
        <source>the positions of {axis} do not increase strictly</source>
        <translation>{axis} 的位置不是严格递增</translation>
    </message>
    <message>
        <source>the period of {axis}, {period}, is shorter than the range of its positions, {range}</source>
        <translation>{axis} 的周期 {period} 小于其位置的范围 {range}</translation>
    </message>
    <message>
        <source>a table has 1 to 3 source axes, this has {count}</source>
        <translation>一个表有 1 至 3 个源轴，此表有 {count} 个</translation>
    </message>
    <message>
        <source>the table has no values</source>
        <translation>该表没有值</translation>
    </message>
    <message>
        <source>{number} values for {column}, for {points} points</source>
        <translation>{column} 有 {number} 个值，而点数为 {points}</translation>
    </message>
    <message>
        <source>a value for {column} is not a finite number</source>
        <translation>{column} 有一个值不是有限的数字</translation>
    </message>
    <message>
        <source>columns {first} and {second} both correct {axis} in the same direction; keep one of them</source>
        <translation>列 {first} 和列 {second} 都在同一方向修正 {axis}；请只保留其一</translation>
    </message>
    <message>
        <source>values for {column}</source>
        <translation>{column} 的值</translation>
    </message>
    <message>
        <source>{column}, positive</source>
        <translation>{column}，正方向</translation>
    </message>
    <message>
        <source>{column}, negative</source>
        <translation>{column}，负方向</translation>
    </message>
    <message>
        <source>table {number} of {count}:</source>
        <translation>表 {number}（共 {count} 个）：</translation>
    </message>
    <message>
        <source>the target without a name</source>
        <translation>未命名的目标轴</translation>
    </message>
    <message>
        <source>there are two columns for {target} in positive direction; keep one of them</source>
        <translation>{target} 在正方向有两列；请只保留其一</translation>
    </message>
    <message>
        <source>there are two columns for {target} in negative direction; keep one of them</source>
        <translation>{target} 在负方向有两列；请只保留其一</translation>
    </message>
    <message>
        <source>for {target} there are values for both directions and others for one; keep one of them</source>
        <translation>{target} 既有两个方向共用的值，又有单个方向的值；请只保留其一</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no mean; choose the positive direction</source>
        <translation>{target} 只有正方向的值，没有平均值；请选择正方向</translation>
    </message>
    <message>
        <source>{target} has values for the positive direction only, so that there is no negative one; choose the positive direction</source>
        <translation>{target} 只有正方向的值，没有负方向的值；请选择正方向</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no mean; choose the negative direction</source>
        <translation>{target} 只有负方向的值，没有平均值；请选择负方向</translation>
    </message>
    <message>
        <source>{target} has values for the negative direction only, so that there is no positive one; choose the negative direction</source>
        <translation>{target} 只有负方向的值，没有正方向的值；请选择负方向</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with the correction {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap, in a machine file no-wrap = true)</source>
        <translation>{axis} 的一整转以修正量 {begin} 开始，以 {end} 结束；使两者相同，或按直线轴处理 (--no-wrap，在机床文件中为 no-wrap = true)</translation>
    </message>
    <message>
        <source>the numbers are too large to be added to each other</source>
        <translation>数字太大，无法相加</translation>
    </message>
    <message>
        <source>from there to {place} the correction changes by {change}, so that positions would change their order; check the unit of the values</source>
        <translation>由此到 {place} 修正量变化 {change}，位置的先后次序会因此改变；检查值的单位</translation>
    </message>
    <message>
        <source>the correction of {axis} changes by {change} for each unit of the way, too much for several axes that are corrected together; check the unit of the values</source>
        <translation>{axis} 的修正量每单位行程变化 {change}，对几个一起修正的轴来说太大；检查值的单位</translation>
    </message>
    <message>
        <source>the corrections are so steep that {count} steps do not find the place that belongs to it; check the unit of the values</source>
        <translation>修正量太陡，{count} 步内找不到对应的位置；检查值的单位</translation>
    </message>
    <message>
        <source>the second table has no column for {column}</source>
        <translation>第二个表没有 {column} 列</translation>
    </message>
    <message>
        <source>a table of {count} source axes cannot be compared with one of {other}</source>
        <translation>{count} 个源轴的表不能与 {other} 个源轴的表比较</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more than {count} points along {axis}; with {most} it is {found}; allow more points or a larger deviation</source>
        <translation>要使偏差不超过 {deviation}，沿 {axis} 需要多于 {count} 点；用 {most} 点时为 {found}；请允许更多的点或更大的偏差</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; with {sizes} points it is {found}; allow more points or a larger deviation</source>
        <translation>要使偏差不超过 {deviation}，需要的点数超过允许值；用 {sizes} 点时为 {found}；请允许更多的点或更大的偏差</translation>
    </message>
    <message>
        <source>a deviation of {deviation} takes more points than allowed; it takes at least {sizes} points; allow more points or a larger deviation</source>
        <translation>要使偏差不超过 {deviation}，需要的点数超过允许值；至少需要 {sizes} 点；请允许更多的点或更大的偏差</translation>
    </message>
    <message>
        <source>the wanted deviation must be a number of 0 or more</source>
        <translation>所要求的偏差必须是不小于 0 的数字</translation>
    </message>
    <message>
        <source>limits for {count} axes are given, the table has {axes}</source>
        <translation>给出了 {count} 个轴的限值，而该表有 {axes} 个轴</translation>
    </message>
    <message>
        <source>a grid has at least two points along each axis; allow as many</source>
        <translation>网格沿每个轴至少有两点；请允许这么多点</translation>
    </message>
    <message>
        <source>a full turn of {axis} begins with {begin} and ends with {end}; make both the same, or treat the axis as linear (--no-wrap)</source>
        <translation>{axis} 的一整转以 {begin} 开始，以 {end} 结束；使两者相同，或按直线轴处理 (--no-wrap)</translation>
    </message>
    <message>
        <source>the values for {column} are too large to be interpolated</source>
        <translation>{column} 的值太大，无法插值</translation>
    </message>
    <message>
        <source>grids for {count} axes are given, the table has {axes}</source>
        <translation>给出了 {count} 个轴的网格，而该表有 {axes} 个轴</translation>
    </message>
    <message>
        <source>the points along {axis} would be so close that positions cannot tell them apart; take fewer</source>
        <translation>沿 {axis} 的点过密，位置无法区分；请减少点数</translation>
    </message>
    <message>
        <source>for {axis} both a number of points and a distance are given</source>
        <translation>对 {axis} 同时给出了点数和间距</translation>
    </message>
    <message>
        <source>the grid along {axis} must end above its start, not go from {from} to {to}</source>
        <translation>沿 {axis} 的网格末端必须大于起点，不能从 {from} 到 {to}</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than {most}</source>
        <translation>沿 {axis} 的 {count} 点超过 {most} 点</translation>
    </message>
    <message>
        <source>for a part of {axis} a number of points or a distance is needed</source>
        <translation>对 {axis} 的一部分，需要点数或间距</translation>
    </message>
    <message>
        <source>the grid along {axis} must be one full turn, from {from} to {to}</source>
        <translation>沿 {axis} 的网格必须是一整转，从 {from} 到 {to}</translation>
    </message>
    <message>
        <source>the grid along {axis} begins at {from}, before the data at {data}; stay within the data, or let the end values be held</source>
        <translation>沿 {axis} 的网格始于 {from}，早于数据起点 {data}；请限制在数据范围内，或允许保持端值</translation>
    </message>
    <message>
        <source>the grid along {axis} ends at {to}, behind the data at {data}; stay within the data, or let the end values be held</source>
        <translation>沿 {axis} 的网格止于 {to}，超出数据末端 {data}；请限制在数据范围内，或允许保持端值</translation>
    </message>
    <message>
        <source>a distance of {distance} along {axis} makes more than {count} points</source>
        <translation>沿 {axis} 的间距 {distance} 会产生多于 {count} 点</translation>
    </message>
    <message>
        <source>the position {position} is the same as the one before when it is rounded</source>
        <translation>位置 {position} 舍入后与前一个相同</translation>
    </message>
    <message>
        <source>the position {position} is beyond the 32 bits of its numbers</source>
        <translation>位置 {position} 超出其数字的 32 位范围</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 32 bits of its numbers</source>
        <translation>值 {value} 超出其数字的 32 位范围</translation>
    </message>
    <message>
        <source>master axis {number}</source>
        <translation>主动轴 {number}</translation>
    </message>
    <message>
        <source>ascending setpoints</source>
        <translation>递增的设定值</translation>
    </message>
    <message>
        <source>{number} at the end</source>
        <translation>末端为 {number}</translation>
    </message>
    <message>
        <source>{number}, as at the beginning</source>
        <translation>{number}，与起点相同</translation>
    </message>
    <message>
        <source>activate it in the axis list of axis {axis}: {parameter} 1</source>
        <translation>在轴 {axis} 的轴列表中启用：{parameter} 1</translation>
    </message>
    <message>
        <source>QUADRATIC or RECTANGULAR</source>
        <translation>QUADRATIC 或 RECTANGULAR</translation>
    </message>
    <message>
        <source>different values at both ends</source>
        <translation>两端的值不同</translation>
    </message>
    <message>
        <source>different values at both ends of master axis {number}</source>
        <translation>主动轴 {number} 两端的值不同</translation>
    </message>
    <message>
        <source>the same values: a modulo axis is at the same place there</source>
        <translation>相同的值：模数轴在该处是同一位置</translation>
    </message>
    <message>
        <source>the same values, since modulo is 1</source>
        <translation>相同的值，因为 modulo 为 1</translation>
    </message>
    <message>
        <source>the distance of {distance} along master {axis} is no whole number of {step}</source>
        <translation>沿主动轴 {axis} 的间距 {distance} 不是 {step} 的整数倍</translation>
    </message>
    <message>
        <source>resample it with such a distance</source>
        <translation>以这样的间距重采样</translation>
    </message>
    <message>
        <source>it takes one distance for both sources, and these are different</source>
        <translation>它对两个源只用一个间距，而这里各不相同</translation>
    </message>
    <message>
        <source>numbers of 0.1 um or 0.0001 deg</source>
        <translation>以 0.1 um 或 0.0001 deg 为单位的数字</translation>
    </message>
    <message>
        <source>increments for one mm or degree</source>
        <translation>每 mm 或每度的增量数</translation>
    </message>
    <message>
        <source>the setting {key}, linear or rotary; linear is assumed, so that it is mm</source>
        <translation>设置 {key}，linear 或 rotary；默认按 linear，即 mm</translation>
    </message>
    <message>
        <source>numbers in encoder increments</source>
        <translation>以编码器增量为单位的数字</translation>
    </message>
    <message>
        <source>the setting increments-per-unit, where millimetres or degrees matter</source>
        <translation>设置 increments-per-unit，用于需要毫米或度时</translation>
    </message>
    <message>
        <source>the setting increments-per-unit is not above 0</source>
        <translation>设置 increments-per-unit 不大于 0</translation>
    </message>
    <message>
        <source>numbers in mm or degrees become increments only with the setting increments-per-unit</source>
        <translation>以 mm 或度为单位的数字，要有设置 increments-per-unit 才能换成增量</translation>
    </message>
    <message>
        <source>an index from 0 such as [3], at most two of them</source>
        <translation>从 0 起的下标，例如 [3]，最多两个</translation>
    </message>
    <message>
        <source>nothing after End</source>
        <translation>End 之后无内容</translation>
    </message>
    <message>
        <source>a value behind the name and a blank</source>
        <translation>名称和空格之后的值</translation>
    </message>
    <message>
        <source>the entry {name}, which is missing</source>
        <translation>缺少的条目 {name}</translation>
    </message>
    <message>
        <source>a whole number, {range}</source>
        <translation>整数，{range}</translation>
    </message>
    <message>
        <source>no entry {name}</source>
        <translation>没有条目 {name}</translation>
    </message>
    <message>
        <source>0 or 1; 0 is assumed</source>
        <translation>0 或 1；默认按 0</translation>
    </message>
    <message>
        <source>0 or 1; 1 is assumed</source>
        <translation>0 或 1；默认按 1</translation>
    </message>
    <message>
        <source>the logical number of the axis, from 1</source>
        <translation>轴的逻辑号，从 1 起</translation>
    </message>
    <message>
        <source>at most {number}, which is {name}</source>
        <translation>最多 {number}，即 {name}</translation>
    </message>
    <message>
        <source>at most {number}, which is the standard value of {name}</source>
        <translation>最多 {number}，即 {name} 的标准值</translation>
    </message>
    <message>
        <source>indices within the size that the list says</source>
        <translation>下标不超出列表给出的大小</translation>
    </message>
    <message>
        <source>{number} of them; there are {number2}</source>
        <translation>{number} 个；现有 {number2} 个</translation>
    </message>
    <message>
        <source>0, or a distance above 0</source>
        <translation>0，或大于 0 的间距</translation>
    </message>
    <message>
        <source>{entry} and setpoints of each point</source>
        <translation>{entry} 和每个点的设定值</translation>
    </message>
    <message>
        <source>an interval of 0 with setpoints, or an interval without</source>
        <translation>间隔为 0 且有设定值，或有间隔而无设定值</translation>
    </message>
    <message>
        <source>values neg without bilateral 1</source>
        <translation>有 neg 值而 bilateral 不为 1</translation>
    </message>
    <message>
        <source>values pos only; neg is left out</source>
        <translation>只有 pos 值；neg 被略去</translation>
    </message>
    <message>
        <source>the index of a table, 0 to {number}</source>
        <translation>表的编号，0 至 {number}</translation>
    </message>
    <message>
        <source>each variable once</source>
        <translation>每个变量一次</translation>
    </message>
    <message>
        <source>each variable once; the first is in line {line}</source>
        <translation>每个变量一次；第一个在第 {line} 行</translation>
    </message>
    <message>
        <source>tables {name} besides {other}</source>
        <translation>表 {name} 与 {other} 并存</translation>
    </message>
    <message>
        <source>one index: [table]</source>
        <translation>一个下标：[表]</translation>
    </message>
    <message>
        <source>two indices: [table,point]</source>
        <translation>两个下标：[表,点]</translation>
    </message>
    <message>
        <source>two indices: [encoder,axis]</source>
        <translation>两个下标：[测量系统,轴]</translation>
    </message>
    <message>
        <source>three indices: [encoder,point,axis]</source>
        <translation>三个下标：[测量系统,点,轴]</translation>
    </message>
    <message>
        <source>0, 1 or -1</source>
        <translation>0、1 或 -1</translation>
    </message>
    <message>
        <source>{variable} of {curve}, which is missing</source>
        <translation>{curve} 的 {variable}，但缺失</translation>
    </message>
    <message>
        <source>a product with another table</source>
        <translation>与另一个表的乘积</translation>
    </message>
    <message>
        <source>a table by itself; the product is left out</source>
        <translation>单独的表；乘积被略去</translation>
    </message>
    <message>
        <source>variables {name}, of which there are none</source>
        <translation>变量 {name}，但一个也没有</translation>
    </message>
    <message>
        <source>there is no table {number}</source>
        <translation>没有表 {number}</translation>
    </message>
    <message>
        <source>choose fewer tables, or another first-table</source>
        <translation>减少表的个数，或选择其他 first-table</translation>
    </message>
    <message>
        <source>the measuring system, 0 or 1</source>
        <translation>测量系统，0 或 1</translation>
    </message>
    <message>
        <source>measuring system {number} of axis {axis}</source>
        <translation>轴 {axis} 的测量系统 {number}</translation>
    </message>
    <message>
        <source>0 or 1, and the name of an axis, at most {number} of them</source>
        <translation>0 或 1，以及轴名，最多 {number} 个</translation>
    </message>
    <message>
        <source>axis {axis}, encoder {number}</source>
        <translation>轴 {axis}，测量系统 {number}</translation>
    </message>
    <message>
        <source>its positions and values are not both lengths or both angles</source>
        <translation>其位置和值不同为长度或同为角度</translation>
    </message>
    <message>
        <source>axis {axis} needs $MA_MM_ENC_COMP_MAX_POINTS (MD38000) of at least {count}; load the file with $MA_ENC_COMP_ENABLE (MD32700) 0, then set it to 1</source>
        <translation>轴 {axis} 的 $MA_MM_ENC_COMP_MAX_POINTS (MD38000) 至少应为 {count}；装载文件时 $MA_ENC_COMP_ENABLE (MD32700) 设为 0，之后设为 1</translation>
    </message>
    <message>
        <source>an index in [ ] behind the name</source>
        <translation>名称之后 [ ] 中的下标</translation>
    </message>
    <message>
        <source>an index that ends in ]</source>
        <translation>以 ] 结尾的下标</translation>
    </message>
    <message>
        <source>= and a value behind the index</source>
        <translation>下标之后的 = 和值</translation>
    </message>
    <message>
        <source>a value behind =</source>
        <translation>= 之后的值</translation>
    </message>
    <message>
        <source>nothing behind the end of the program, M17</source>
        <translation>程序结束 M17 之后无内容</translation>
    </message>
    <message>
        <source>an assignment such as $NAME[0,1]=0.5, CHANDATA(1) or M17</source>
        <translation>赋值，例如 $NAME[0,1]=0.5、CHANDATA(1) 或 M17</translation>
    </message>
    <message>
        <source>{variable} of {curve} a second time</source>
        <translation>{curve} 的 {variable} 再次出现</translation>
    </message>
    <message>
        <source>the number of a point, from 0</source>
        <translation>点的编号，从 0 起</translation>
    </message>
    <message>
        <source>a compensation value</source>
        <translation>补偿值</translation>
    </message>
    <message>
        <source>MIN {min}, MAX {max} and STEP {step} of {curve}</source>
        <translation>{curve} 的 MIN {min}、MAX {max} 和 STEP {step}</translation>
    </message>
    <message>
        <source>a STEP above 0 and a MAX above MIN</source>
        <translation>STEP 大于 0，MAX 大于 MIN</translation>
    </message>
    <message>
        <source>a whole number of steps from MIN to MAX</source>
        <translation>从 MIN 到 MAX 为 STEP 的整数倍</translation>
    </message>
    <message>
        <source>point {number} of {curve}</source>
        <translation>{curve} 的点 {number}</translation>
    </message>
    <message>
        <source>point {number} of {curve} a second time</source>
        <translation>{curve} 的点 {number} 再次出现</translation>
    </message>
    <message>
        <source>points up to {number}, which MIN, MAX and STEP give</source>
        <translation>点号最多到 {number}，由 MIN、MAX 和 STEP 得出</translation>
    </message>
    <message>
        <source>no point {number} of {curve}</source>
        <translation>没有 {curve} 的点 {number}</translation>
    </message>
    <message>
        <source>{number} points, which MIN, MAX and STEP give; there are {number2}</source>
        <translation>{number} 点，由 MIN、MAX 和 STEP 得出；现有 {number2} 点</translation>
    </message>
    <message>
        <source>{number} at MAX of {curve}</source>
        <translation>{curve} 在 MAX 处为 {number}</translation>
    </message>
    <message>
        <source>{number}, as at MIN, which follows it</source>
        <translation>{number}，与其后的 MIN 处相同</translation>
    </message>
    <message>
        <source>&quot;{axis}&quot; is no axis name for the format {format}, such as X1; give the setting {key}</source>
        <translation>“{axis}”不是格式 {format} 的轴名（例如 X1）；请给出设置 {key}</translation>
    </message>
    <message>
        <source>three numbers: nominal forward reverse; the controller stops reading here without a message</source>
        <translation>三个数字：名义位置 正向 反向；控制器读到此处即停止，且不提示</translation>
    </message>
    <message>
        <source>{text} after three numbers</source>
        <translation>三个数字之后的 {text}</translation>
    </message>
    <message>
        <source>nothing; it is left out, as the controller does</source>
        <translation>无内容；按控制器的做法略去</translation>
    </message>
    <message>
        <source>at most 256; the controller leaves out the others</source>
        <translation>最多 256；控制器略去其余的</translation>
    </message>
    <message>
        <source>a measured position that does not increase</source>
        <translation>未递增的测得位置</translation>
    </message>
    <message>
        <source>increasing ones; if these are trims, the setting type=1</source>
        <translation>递增的位置；若这些是修正量，则设置 type=1</translation>
    </message>
    <message>
        <source>measured positions (COMP_FILE_TYPE 0)</source>
        <translation>测得的位置 (COMP_FILE_TYPE 0)</translation>
    </message>
    <message>
        <source>the setting type=0, or type=1 if these are trims</source>
        <translation>设置 type=0；若这些是修正量，则设置 type=1</translation>
    </message>
    <message>
        <source>increasing ones; perhaps these are trims (type=1)</source>
        <translation>递增的位置；这些也可能是修正量 (type=1)</translation>
    </message>
    <message>
        <source>trims that change by {change}</source>
        <translation>变化 {change} 的修正量</translation>
    </message>
    <message>
        <source>less than the positions do; perhaps these are measured positions (type=0)</source>
        <translation>小于位置的变化；这些也可能是测得的位置 (type=0)</translation>
    </message>
    <message>
        <source>a measured position at {position} is beyond what a number can be</source>
        <translation>{position} 处测得的位置超出数字的范围</translation>
    </message>
    <message>
        <source>check the unit of positions and values</source>
        <translation>检查位置和值的单位</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = {file} and COMP_FILE_TYPE = {type}</source>
        <translation>在 INI 文件的 [JOINT_n] 段中：COMP_FILE = {file} 且 COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>in the section [JOINT_n] of the INI file: COMP_FILE = the file and COMP_FILE_TYPE = {type}</source>
        <translation>在 INI 文件的 [JOINT_n] 段中：COMP_FILE = 该文件，且 COMP_FILE_TYPE = {type}</translation>
    </message>
    <message>
        <source>BACKLASH of the joint is not used any more</source>
        <translation>不再使用该关节的 BACKLASH</translation>
    </message>
    <message>
        <source>a second section for the profile {name}</source>
        <translation>配置 {name} 的第二个段</translation>
    </message>
    <message>
        <source>each profile once</source>
        <translation>每个配置一次</translation>
    </message>
    <message>
        <source>an entry such as min_x = 10</source>
        <translation>条目，例如 min_x = 10</translation>
    </message>
    <message>
        <source>each entry once in a section</source>
        <translation>每个条目在一段中一次</translation>
    </message>
    <message>
        <source>an entry {key} in this section</source>
        <translation>此段中的条目 {key}</translation>
    </message>
    <message>
        <source>version {version}</source>
        <translation>版本 {version}</translation>
    </message>
    <message>
        <source>1; the firmware does not use other versions</source>
        <translation>1；固件不使用其他版本</translation>
    </message>
    <message>
        <source>a height in mm</source>
        <translation>以 mm 为单位的高度</translation>
    </message>
    <message>
        <source>a position in mm</source>
        <translation>以 mm 为单位的位置</translation>
    </message>
    <message>
        <source>an offset in mm</source>
        <translation>以 mm 为单位的偏移量</translation>
    </message>
    <message>
        <source>a maximum above the minimum</source>
        <translation>大于最小值的最大值</translation>
    </message>
    <message>
        <source>a section [bed_mesh NAME] with the points of a mesh</source>
        <translation>含网格点的 [bed_mesh NAME] 段</translation>
    </message>
    <message>
        <source>{axis} from {number} to {number2} by {number3} in {number4} points</source>
        <translation>{axis} 从 {number} 到 {number2}，间距 {number3}，{number4} 点</translation>
    </message>
    <message>
        <source>at least 2 along each axis</source>
        <translation>沿每个轴至少 2 点</translation>
    </message>
    <message>
        <source>as many points as lie between minimum and maximum</source>
        <translation>与最小值到最大值之间的点数相同</translation>
    </message>
    <message>
        <source>the axes &quot;{first}&quot; and &quot;{second}&quot;</source>
        <translation>轴“{first}”和“{second}”</translation>
    </message>
    <message>
        <source>two different letters</source>
        <translation>两个不同的字母</translation>
    </message>
    <message>
        <source>a point that was not probed at {position}, {other}</source>
        <translation>{position}, {other} 处未探测的点</translation>
    </message>
    <message>
        <source>a further line after {number}</source>
        <translation>{number} 行之后还有一行</translation>
    </message>
    <message>
        <source>{number} lines of heights</source>
        <translation>{number} 行高度</translation>
    </message>
    <message>
        <source>the line {line}</source>
        <translation>行 {line}</translation>
    </message>
    <message>
        <source>the line {line}, or {other}</source>
        <translation>行 {line}，或 {other}</translation>
    </message>
    <message>
        <source>the number of one axis, from 1, behind :START</source>
        <translation>:START 之后的一个轴号，从 1 起</translation>
    </message>
    <message>
        <source>SAMPLEDIST= and the distance of the corrections, which is not 0</source>
        <translation>SAMPLEDIST= 和修正量的间距，不为 0</translation>
    </message>
    <message>
        <source>choose a table of an axis for itself</source>
        <translation>选择单独修正一个轴的表</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}, and the controller adds their corrections</source>
        <translation>轴 {axis} 有两个表，控制器会将其修正量相加</translation>
    </message>
    <message>
        <source>the number of an axis, from 1</source>
        <translation>轴号，从 1 起</translation>
    </message>
    <message>
        <source>7 numbers behind :START2D: row axis, column axis, two output axes, distance along rows, distance along columns, number of columns</source>
        <translation>:START2D 之后的 7 个数字：行轴、列轴、两个输出轴、行向间距、列向间距、列数</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>the number of columns</source>
        <translation>列数</translation>
    </message>
    <message>
        <source>a distance of 0</source>
        <translation>间距为 0</translation>
    </message>
    <message>
        <source>a distance that is not 0</source>
        <translation>不为 0 的间距</translation>
    </message>
    <message>
        <source>axis {number} for rows and columns</source>
        <translation>行和列均为轴 {number}</translation>
    </message>
    <message>
        <source>two axes</source>
        <translation>两个轴</translation>
    </message>
    <message>
        <source>{number} points of {number2} corrections each in a row</source>
        <translation>每行 {number} 点，每点 {number2} 个修正量</translation>
    </message>
    <message>
        <source>KEY=VALUE</source>
        <translation>键=值</translation>
    </message>
    <message>
        <source>:END of the table that begins in line {line}</source>
        <translation>始于第 {line} 行的表的 :END</translation>
    </message>
    <message>
        <source>{directive} before :END</source>
        <translation>:END 之前的 {directive}</translation>
    </message>
    <message>
        <source>a table that begins with {directive}</source>
        <translation>以 {directive} 开始的表</translation>
    </message>
    <message>
        <source>a table that begins with {directive} and ends with :END</source>
        <translation>以 {directive} 开始、以 :END 结束的表</translation>
    </message>
    <message>
        <source>{directive} or :END; tables of one and of two dimensions are in separate files</source>
        <translation>{directive} 或 :END；一维表和二维表分放在不同文件中</translation>
    </message>
    <message>
        <source>each option once</source>
        <translation>每个选项一次</translation>
    </message>
    <message>
        <source>{key}= and a number</source>
        <translation>{key}= 和数字</translation>
    </message>
    <message>
        <source>positions in the coordinates of the axis after homing; it is left out</source>
        <translation>轴回原点后坐标系中的位置；该选项被略去</translation>
    </message>
    <message>
        <source>a table without {key}</source>
        <translation>没有 {key} 的表</translation>
    </message>
    <message>
        <source>{key}=METRIC, ENGLISH, PRIMARY, SECONDARY or COUNTS, perhaps divided by a number as in METRIC/1000</source>
        <translation>{key}=METRIC、ENGLISH、PRIMARY、SECONDARY 或 COUNTS，可再除以一个数字，例如 METRIC/1000</translation>
    </message>
    <message>
        <source>a correction that is too large for its unit</source>
        <translation>对其单位而言过大的修正量</translation>
    </message>
    <message>
        <source>another CORUNIT</source>
        <translation>其他 CORUNIT</translation>
    </message>
    <message>
        <source>two numbers such as 0.25,0.001: position and offset</source>
        <translation>两个数字，例如 0.25,0.001：位置和偏移量</translation>
    </message>
    <message>
        <source>a position such as 0.25</source>
        <translation>位置，例如 0.25</translation>
    </message>
    <message>
        <source>an offset such as 0.001</source>
        <translation>偏移量，例如 0.001</translation>
    </message>
    <message>
        <source>lines of {expected}</source>
        <translation>由{expected}组成的行</translation>
    </message>
    <message>
        <source>&quot;{line}&quot;, which is taken to be a header</source>
        <translation>“{line}”，视为标题行</translation>
    </message>
    <message>
        <source>{expected}, if it is a point</source>
        <translation>{expected}，如果它是一个点</translation>
    </message>
    <message>
        <source>position + offset {number} after {number2}</source>
        <translation>位置 + 偏移量 {number}，在 {number2} 之后</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 点</translation>
    </message>
    <message>
        <source>strictly decreasing positions</source>
        <translation>严格递减的位置</translation>
    </message>
    <message>
        <source>strictly increasing positions</source>
        <translation>严格递增的位置</translation>
    </message>
    <message>
        <source>strictly decreasing values, as the positions are</source>
        <translation>严格递减的值，与位置一样</translation>
    </message>
    <message>
        <source>strictly increasing values, as the positions are</source>
        <translation>严格递增的值，与位置一样</translation>
    </message>
    <message>
        <source>positions from {first} to {last}</source>
        <translation>从 {first} 到 {last} 的位置</translation>
    </message>
    <message>
        <source>a span of exactly {range}, the wrap range</source>
        <translation>跨度正好为 {range}，即回绕范围</translation>
    </message>
    <message>
        <source>the offsets {first} and {last} at the ends</source>
        <translation>两端的偏移量 {first} 和 {last}</translation>
    </message>
    <message>
        <source>the same offset at both ends, which are one place</source>
        <translation>两端相同的偏移量，因为两端是同一处</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, expected more than 0</source>
        <translation>设置 wrap-range 为 {value}，应大于 0</translation>
    </message>
    <message>
        <source>the setting wrap-range is {value}, and the table repeats after {period}</source>
        <translation>设置 wrap-range 为 {value}，而该表每 {period} 重复一次</translation>
    </message>
    <message>
        <source>at {position} position + offset {sum} after {before} does not increase (error 4900 of the controller)</source>
        <translation>在 {position} 处，位置 + 偏移量没有递增：{before} 之后为 {sum}（控制器错误 4900）</translation>
    </message>
    <message>
        <source>check the unit of the values, or smooth them</source>
        <translation>检查值的单位，或将其平滑</translation>
    </message>
    <message>
        <source>of a rotary axis it wants {expected}, and this table has {found} (error 4902 of the controller)</source>
        <translation>对回转轴，要求 {expected}，而此表有 {found}（控制器错误 4902）</translation>
    </message>
    <message>
        <source>add the point that closes the revolution</source>
        <translation>补上使一转闭合的点</translation>
    </message>
    <message>
        <source>the controller looks for the file as {name}PosComp.CSV, unless axis.xml names another one</source>
        <translation>控制器按 {name}PosComp.CSV 查找文件，除非 axis.xml 中指定了其他文件</translation>
    </message>
    <message>
        <source>the controller looks for the file as the name of the axis and PosComp.CSV, unless axis.xml names another one</source>
        <translation>控制器按轴名加 PosComp.CSV 查找文件，除非 axis.xml 中指定了其他文件</translation>
    </message>
    <message>
        <source>motor {number}</source>
        <translation>电机 {number}</translation>
    </message>
    <message>
        <source>a number of entries</source>
        <translation>条目数</translation>
    </message>
    <message>
        <source>the number of a motor, #1 to #32, perhaps with a D</source>
        <translation>电机号，#1 至 #32，可带 D</translation>
    </message>
    <message>
        <source>DEFINE COMP entries,#source,#target,span</source>
        <translation>DEFINE COMP 条目数,#源,#目标,跨度</translation>
    </message>
    <message>
        <source>DEFINE COMP rows.columns,#row,#column,#target,span,span</source>
        <translation>DEFINE COMP 行数.列数,#行,#列,#目标,跨度,跨度</translation>
    </message>
    <message>
        <source>a span in counts</source>
        <translation>以计数为单位的跨度</translation>
    </message>
    <message>
        <source>a span of {span}</source>
        <translation>跨度 {span}</translation>
    </message>
    <message>
        <source>a span of {span} counts</source>
        <translation>跨度 {span} 计数</translation>
    </message>
    <message>
        <source>at least 1 count</source>
        <translation>至少 1 计数</translation>
    </message>
    <message>
        <source>motors that are not named</source>
        <translation>未指定的电机</translation>
    </message>
    <message>
        <source>the motor that is addressed when the file is loaded; name it with #</source>
        <translation>装载文件时被寻址的电机；请用 # 指定</translation>
    </message>
    <message>
        <source>a table of one dimension</source>
        <translation>一维表</translation>
    </message>
    <message>
        <source>a table of two dimensions</source>
        <translation>二维表</translation>
    </message>
    <message>
        <source>further entries: {entries}</source>
        <translation>其他条目：{entries}</translation>
    </message>
    <message>
        <source>DEFINE COMP in front of them</source>
        <translation>其前的 DEFINE COMP</translation>
    </message>
    <message>
        <source>a whole number of 1/16 count</source>
        <translation>1/16 计数的整数倍</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of one dimension</source>
        <translation>一维表的 DEFINE COMP</translation>
    </message>
    <message>
        <source>DEFINE COMP for a table of two dimensions</source>
        <translation>二维表的 DEFINE COMP</translation>
    </message>
    <message>
        <source>a table in counts</source>
        <translation>以计数为单位的表</translation>
    </message>
    <message>
        <source>different entries at 0 and at the span of motor {motor}</source>
        <translation>电机 {motor} 在 0 处和跨度末端的条目不同</translation>
    </message>
    <message>
        <source>the same: the table rolls over there</source>
        <translation>相同的条目：该表在此处循环</translation>
    </message>
    <message>
        <source>entries that are too large in these units</source>
        <translation>在这些单位下过大的条目</translation>
    </message>
    <message>
        <source>another counts-per-unit</source>
        <translation>其他 counts-per-unit</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected a number above 0</source>
        <translation>格式 {format} 的设置 {key} 为 {value}，应为大于 0 的数字</translation>
    </message>
    <message>
        <source>position 0, where its tables begin, is no point of source {number}</source>
        <translation>其表始于位置 0，而它不是源 {number} 的点</translation>
    </message>
    <message>
        <source>resample it with a point at 0</source>
        <translation>重采样，使 0 处有一点</translation>
    </message>
    <message>
        <source>its tables begin at position 0, which source {number} does not reach</source>
        <translation>其表始于位置 0，而源 {number} 未覆盖该处</translation>
    </message>
    <message>
        <source>add points to the table, as far as position 0</source>
        <translation>向表中添加点，直到位置 0</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the positions</source>
        <translation>检查 counts-per-unit 和位置的单位</translation>
    </message>
    <message>
        <source>the value {value} is beyond the 24 bits of an entry</source>
        <translation>值 {value} 超出条目的 24 位范围</translation>
    </message>
    <message>
        <source>check counts-per-unit and the unit of the values</source>
        <translation>检查 counts-per-unit 和值的单位</translation>
    </message>
    <message>
        <source>its value at position 0 is {value}, and the controller takes it to be 0 there</source>
        <translation>其在位置 0 处的值为 {value}，而控制器在该处按 0 处理</translation>
    </message>
    <message>
        <source>there is no motor {number}</source>
        <translation>没有电机 {number}</translation>
    </message>
    <message>
        <source>choose one from 1 to 32</source>
        <translation>从 1 至 32 中选择</translation>
    </message>
    <message>
        <source>switch the table on with I51=1; outside of its span it rolls over</source>
        <translation>用 I51=1 启用该表；超出跨度后循环</translation>
    </message>
    <message>
        <source>a line &quot;# {key} = NUMBER&quot; before the counts</source>
        <translation>计数之前的一行“# {key} = NUMBER”</translation>
    </message>
    <message>
        <source>{number} to {number2} by {number3}</source>
        <translation>{number} 至 {number2}，间距 {number3}</translation>
    </message>
    <message>
        <source>a maximum above the minimum, and a delta above 0</source>
        <translation>最大值大于最小值，且间距大于 0</translation>
    </message>
    <message>
        <source>a range that is an integer multiple of the delta</source>
        <translation>为间距整数倍的范围</translation>
    </message>
    <message>
        <source>the unit {unit}</source>
        <translation>单位 {unit}</translation>
    </message>
    <message>
        <source>values in counts</source>
        <translation>以计数为单位的值</translation>
    </message>
    <message>
        <source>a line &quot;# output.counts-per-unit = NUMBER&quot;, or the setting counts-per-unit</source>
        <translation>一行“# output.counts-per-unit = NUMBER”，或设置 counts-per-unit</translation>
    </message>
    <message>
        <source>a number of counts</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>{number} counts per unit</source>
        <translation>每单位 {number} 计数</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>不为 0 的数字</translation>
    </message>
    <message>
        <source>{number}, one for each position of the first axis</source>
        <translation>{number}，第一个轴的每个位置各一个</translation>
    </message>
    <message>
        <source>{number}, one for each position of the second axis</source>
        <translation>{number}，第二个轴的每个位置各一个</translation>
    </message>
    <message>
        <source>one line</source>
        <translation>一行</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected a C++ name: letters, digits and _</source>
        <translation>设置 name 为“{name}”，应为 C++ 名称：字母、数字和 _</translation>
    </message>
    <message>
        <source>the value {value} is {count} counts, and at most 2147483647 can be held</source>
        <translation>值 {value} 为 {count} 计数，而最多可存 2147483647</translation>
    </message>
    <message>
        <source>the setting counts-per-unit is 0, expected a number of counts</source>
        <translation>设置 counts-per-unit 为 0，应为计数</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 {unit}</source>
        <translation>counts-per-unit 按 {count} 计数对应 1 {unit} 理解</translation>
    </message>
    <message>
        <source>counts-per-unit is understood as {count} counts for 1 unit of the values</source>
        <translation>counts-per-unit 按 {count} 计数对应值的 1 单位理解</translation>
    </message>
    <message>
        <source>an input axis is the output axis: its command position must be the input, the actual position is not possible</source>
        <translation>有一个输入轴就是输出轴：输入必须是其指令位置，不能是实际位置</translation>
    </message>
    <message>
        <source>the inputs are other axes: their command or their actual positions can be the inputs</source>
        <translation>输入为其他轴：可用其指令位置或实际位置作输入</translation>
    </message>
    <message>
        <source>the number of source axes, 1 to 3</source>
        <translation>源轴的个数，1 至 3</translation>
    </message>
    <message>
        <source>{number}, one for each source axis</source>
        <translation>{number}，每个源轴各一个</translation>
    </message>
    <message>
        <source>the number of points of a source</source>
        <translation>一个源的点数</translation>
    </message>
    <message>
        <source>at least 2, and at most {number} rows in all</source>
        <translation>至少 2，且总行数最多 {number}</translation>
    </message>
    <message>
        <source>{number}, as in the first row</source>
        <translation>{number}，与第一行相同</translation>
    </message>
    <message>
        <source>a source position</source>
        <translation>源的位置</translation>
    </message>
    <message>
        <source>{number} for source {number2}</source>
        <translation>源 {number2} 为 {number}</translation>
    </message>
    <message>
        <source>{number}: the first source changes fastest</source>
        <translation>{number}：第一个源变化最快</translation>
    </message>
    <message>
        <source>positions of source {axis} from {first} to {last}</source>
        <translation>源 {axis} 从 {first} 到 {last} 的位置</translation>
    </message>
    <message>
        <source>equal distances</source>
        <translation>相等的间距</translation>
    </message>
    <message>
        <source>a header of {sizes} = {number} rows, and {number2} rows</source>
        <translation>标题行为 {sizes} = {number} 行，实有 {number2} 行</translation>
    </message>
    <message>
        <source>as many rows as the header says</source>
        <translation>与标题行所述相同的行数</translation>
    </message>
    <message>
        <source>the setting name is &quot;{name}&quot;, expected letters, digits and _, beginning with a letter</source>
        <translation>设置 name 为“{name}”，应为字母、数字和 _，以字母开头</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, and not be in use (CompActive = 0) while the lines run</source>
        <translation>表 {name} 必须已在程序中定义，点数为 {count}，且执行这些行时不得处于使用中 (CompActive = 0)</translation>
    </message>
    <message>
        <source>the table {name} must be defined in the program, with {count} points, the first source fastest, and not be in use (CompActive = 0) while the lines run</source>
        <translation>表 {name} 必须已在程序中定义，点数为 {count}，第一个源变化最快，且执行这些行时不得处于使用中 (CompActive = 0)</translation>
    </message>
    <message>
        <source>{number} after {number2}</source>
        <translation>{number2} 之后为 {number}</translation>
    </message>
    <message>
        <source>strictly increasing positions of {axis}</source>
        <translation>{axis} 的严格递增的位置</translation>
    </message>
    <message>
        <source>positions of {axis}</source>
        <translation>{axis} 的位置</translation>
    </message>
    <message>
        <source>positions of the axis</source>
        <translation>轴的位置</translation>
    </message>
    <message>
        <source>numbers that a computer can tell from each other; check their size</source>
        <translation>计算机可以区分的数字；检查其大小</translation>
    </message>
    <message>
        <source>values of {target}</source>
        <translation>{target} 的值</translation>
    </message>
    <message>
        <source>values of the table</source>
        <translation>表的值</translation>
    </message>
    <message>
        <source>numbers that a computer can hold; check their size</source>
        <translation>计算机可以表示的数字；检查其大小</translation>
    </message>
    <message>
        <source>axis {number}</source>
        <translation>轴 {number}</translation>
    </message>
    <message>
        <source>source {number}</source>
        <translation>源 {number}</translation>
    </message>
    <message>
        <source>table {number}</source>
        <translation>表 {number}</translation>
    </message>
    <message>
        <source>at least 2</source>
        <translation>至少 2</translation>
    </message>
    <message>
        <source>{number} to {number2}</source>
        <translation>{number} 至 {number2}</translation>
    </message>
    <message>
        <source>at most {number} points</source>
        <translation>最多 {number} 点</translation>
    </message>
    <message>
        <source>{number} lines</source>
        <translation>{number} 行</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>大于 0 的数字</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>a number for {key}</source>
        <translation>{key} 的数字</translation>
    </message>
    <message>
        <source>the number of {key}</source>
        <translation>{key} 的数字</translation>
    </message>
    <message>
        <source>a distance above 0</source>
        <translation>大于 0 的间距</translation>
    </message>
    <message>
        <source>a correction</source>
        <translation>修正量</translation>
    </message>
    <message>
        <source>{what} a second time</source>
        <translation>{what}再次出现</translation>
    </message>
    <message>
        <source>a second {key}</source>
        <translation>第二个 {key}</translation>
    </message>
    <message>
        <source>each entry once</source>
        <translation>每个条目一次</translation>
    </message>
    <message>
        <source>each entry once; the first is in line {line}</source>
        <translation>每个条目一次；第一个在第 {line} 行</translation>
    </message>
    <message>
        <source>each point once</source>
        <translation>每个点一次</translation>
    </message>
    <message>
        <source>{value}, as {key} says</source>
        <translation>{value}，与 {key} 一致</translation>
    </message>
    <message>
        <source>{value}, as the setting {key} says</source>
        <translation>{value}，与设置 {key} 一致</translation>
    </message>
    <message>
        <source>{number}, one for each position of {axis}</source>
        <translation>{number}，{axis} 的每个位置各一个</translation>
    </message>
    <message>
        <source>the format {format} to read it; it is left out here</source>
        <translation>用格式 {format} 读取；此处略去</translation>
    </message>
    <message>
        <source>the format {format} to read them; they are left out here</source>
        <translation>用格式 {format} 读取；此处略去</translation>
    </message>
    <message>
        <source>numbers in {from} cannot be given in {to}</source>
        <translation>以 {from} 为单位的数字无法用 {to} 表示</translation>
    </message>
    <message>
        <source>a unit that is not said</source>
        <translation>未注明的单位</translation>
    </message>
    <message>
        <source>positions without a unit</source>
        <translation>没有单位的位置</translation>
    </message>
    <message>
        <source>values without a unit</source>
        <translation>没有单位的值</translation>
    </message>
    <message>
        <source>numbers without a unit</source>
        <translation>没有单位的数字</translation>
    </message>
    <message>
        <source>the setting {key}, where a unit matters</source>
        <translation>设置 {key}，用于单位起作用时</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>not all units are said: the values are taken to be in the unit of the positions</source>
        <translation>单位未全部注明：值按位置的单位处理</translation>
    </message>
    <message>
        <source>the values were in {before} and are now in {unit}, the unit of the positions</source>
        <translation>值原以 {before} 为单位，现以位置的单位 {unit} 为单位</translation>
    </message>
    <message>
        <source>positions in {unit} and values in {other}</source>
        <translation>位置以 {unit} 为单位，值以 {other} 为单位</translation>
    </message>
    <message>
        <source>one unit, since the controller adds the values to the positions</source>
        <translation>同一单位，因为控制器将值加到位置上</translation>
    </message>
    <message>
        <source>{units}: the format {format} has one unit for both</source>
        <translation>{units}：格式 {format} 对两者只用一个单位</translation>
    </message>
    <message>
        <source>choose a format for cross compensation</source>
        <translation>选择用于交叉补偿的格式</translation>
    </message>
    <message>
        <source>check the unit of the table</source>
        <translation>检查表的单位</translation>
    </message>
    <message>
        <source>check the units of the table</source>
        <translation>检查表的各个单位</translation>
    </message>
    <message>
        <source>the {what} are in {from}, which cannot be given in {to}; correct the units</source>
        <translation>{what}以 {from} 为单位，无法换算成 {to}；请更正单位</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for writing; it has: {known}</source>
        <translation>格式 {format} 写入时没有设置 {key}；现有：{known}</translation>
    </message>
    <message>
        <source>the format {format} has no setting {key} for reading; it has: {known}</source>
        <translation>格式 {format} 读取时没有设置 {key}；现有：{known}</translation>
    </message>
    <message>
        <source>the format {format} can be read, not written</source>
        <translation>格式 {format} 只能读，不能写</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1; the setting {key} is {value}</source>
        <translation>格式 {format} 用从 1 起的编号表示轴；设置 {key} 为 {value}</translation>
    </message>
    <message>
        <source>the format {format} names its axes by numbers from 1 and there is no number in the axis name &quot;{name}&quot;; give the setting {key}</source>
        <translation>格式 {format} 用从 1 起的编号表示轴，而轴名“{name}”中没有编号；请给出设置 {key}</translation>
    </message>
    <message>
        <source>its positions of source {number} span {span}, and a modulo axis needs exactly one period of {period}</source>
        <translation>其源 {number} 的位置跨度为 {span}，而模数轴需要正好一个周期 {period}</translation>
    </message>
    <message>
        <source>resample it over one whole period</source>
        <translation>在一个完整周期上重采样</translation>
    </message>
    <message>
        <source>the values at both ends of the modulo axis, source {number}, differ by {difference}</source>
        <translation>模数轴（源 {number}）两端的值相差 {difference}</translation>
    </message>
    <message>
        <source>make both ends equal: they are the same place</source>
        <translation>使两端相同：它们是同一处</translation>
    </message>
    <message>
        <source>its modulo axis is not rotary</source>
        <translation>其模数轴不是回转轴</translation>
    </message>
    <message>
        <source>treat the axis as linear (--no-wrap)</source>
        <translation>按直线轴处理 (--no-wrap)</translation>
    </message>
    <message>
        <source>it takes a column for both directions of motion, or one for each direction of one axis</source>
        <translation>它接受两个运动方向共用的一列，或一个轴每个方向各一列</translation>
    </message>
    <message>
        <source>choose these columns</source>
        <translation>选择这些列</translation>
    </message>
    <message>
        <source>{count} columns are more than the {limit} of one table</source>
        <translation>{count} 列超过一个表的上限 {limit} 列</translation>
    </message>
    <message>
        <source>choose a column, and write the others to files of their own</source>
        <translation>选择一列，其余写入各自的文件</translation>
    </message>
    <message>
        <source>{count} tables are more than the {limit} of one file</source>
        <translation>{count} 个表超过一个文件的上限 {limit} 个</translation>
    </message>
    <message>
        <source>choose one, and write the others to files of their own</source>
        <translation>选择一个，其余写入各自的文件</translation>
    </message>
    <message>
        <source>choose one of them</source>
        <translation>选择其中之一</translation>
    </message>
    <message>
        <source>{size} bytes are more than the {limit} of a file</source>
        <translation>{size} 字节超过文件的上限 {limit}</translation>
    </message>
    <message>
        <source>write it as {format}</source>
        <translation>写为 {format}</translation>
    </message>
    <message>
        <source>there are two tables for axis {axis}</source>
        <translation>轴 {axis} 有两个表</translation>
    </message>
    <message>
        <source>a TAM table needs the table layout of a drive profile</source>
        <translation>TAM 表需要驱动器描述文件中的表布局</translation>
    </message>
    <message>
        <source>a calibration file needs the number of its dimensions: 1, 2 or 3</source>
        <translation>校准文件需要给出维数：1、2 或 3</translation>
    </message>
    <message>
        <source>a table kw.{name} besides kw.{other}</source>
        <translation>表 kw.{name} 与 kw.{other} 并存</translation>
    </message>
    <message>
        <source>a point kw.{point} with one index</source>
        <translation>一个下标的点 kw.{point}</translation>
    </message>
    <message>
        <source>a point kw.{point} with two indices</source>
        <translation>两个下标的点 kw.{point}</translation>
    </message>
    <message>
        <source>a table kw.{name}, of which there is no entry</source>
        <translation>表 kw.{name}，但没有任何条目</translation>
    </message>
    <message>
        <source>the setting {key}, such as mm, where a unit matters</source>
        <translation>设置 {key}，例如 mm，用于单位起作用时</translation>
    </message>
    <message>
        <source>byte {value}</source>
        <translation>字节 {value}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid calibration file: {count} problems</source>
        <comment>{file} is not a valid calibration file: one problem</comment>
        <translation>
            <numerusform>{file} 不是有效的校准文件：{count} 个问题</numerusform>
        </translation>
    </message>
    <message>
        <source>there is a source for dimension {dimension}, but the table is {dimensions}D</source>
        <translation>给出了维度 {dimension} 的源，但该表为 {dimensions}D</translation>
    </message>
    <message>
        <source>the table is {table}D, but {chosen}D is chosen</source>
        <translation>该表为 {table}D，但选择的是 {chosen}D</translation>
    </message>
    <message>
        <source>{time} ({step})</source>
        <translation>{time}（{step}）</translation>
    </message>
    <message>
        <source>sign: {from}, {to}; {example}</source>
        <translation>符号：{from}，{to}；{example}</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>负方向</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}；{next}</translation>
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
        <translation>“{text}”不是类型为 {type} 的值；应为：{expected}</translation>
    </message>
    <message>
        <source>a number such as 12.5, at most {most} in magnitude</source>
        <translation>数字，例如 12.5，绝对值不超过 {most}</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}, or an address such as 0x1234</source>
        <translation>{least} 至 {most} 的整数，或地址，例如 0x1234</translation>
    </message>
    <message>
        <source>the name of an enum value, without blanks</source>
        <translation>不含空格的枚举值名称</translation>
    </message>
    <message>
        <source>a whole number from {least} to {most}</source>
        <translation>{least} 至 {most} 的整数</translation>
    </message>
    <message numerus="yes">
        <source>{count} corrections</source>
        <comment>1 correction</comment>
        <translation>
            <numerusform>{count} 个修正量</numerusform>
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
            <numerusform>该行有 {count} 个修正量，共 {all} 个</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>it has {count} source axes, possible are {range}</source>
        <comment>it has 1 source axis, possible are {range}</comment>
        <translation>
            <numerusform>它有 {count} 个源轴，可为 {range} 个</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>{count} 个数字</numerusform>
        </translation>
    </message>
    <message>
        <source>logical number of master axis 1, for master1_ax_nr</source>
        <translation>主动轴 1 的逻辑号，用于 master1_ax_nr</translation>
    </message>
    <message>
        <source>logical number of master axis 2, for master2_ax_nr</source>
        <translation>主动轴 2 的逻辑号，用于 master2_ax_nr</translation>
    </message>
    <message>
        <source>whether master axis 1 is linear (mm) or rotary (deg)</source>
        <translation>主动轴 1 是直线轴 (mm) 还是回转轴 (deg)</translation>
    </message>
    <message>
        <source>whether master axis 2 is linear (mm) or rotary (deg)</source>
        <translation>主动轴 2 是直线轴 (mm) 还是回转轴 (deg)</translation>
    </message>
    <message>
        <source>master axis 1 is a modulo axis: its ends are one place</source>
        <translation>主动轴 1 是模数轴：两端是同一处</translation>
    </message>
    <message>
        <source>master axis 2 is a modulo axis: its ends are one place</source>
        <translation>主动轴 2 是模数轴：两端是同一处</translation>
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
        <translation>没有 {name}</translation>
    </message>
    <message numerus="yes">
        <source>{count} heights</source>
        <comment>1 height</comment>
        <translation>
            <numerusform>{count} 个高度</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of points</source>
        <comment>1 line of points</comment>
        <translation>
            <numerusform>{count} 行点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} entries</source>
        <comment>1 entry</comment>
        <translation>
            <numerusform>{count} 个条目</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values</source>
        <comment>1 value</comment>
        <translation>
            <numerusform>{count} 个值</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of counts</source>
        <comment>1 line of counts</comment>
        <translation>
            <numerusform>{count} 行计数</numerusform>
        </translation>
    </message>
    <message>
        <source>{number}: {names}</source>
        <translation>{number}：{names}</translation>
    </message>
    <message numerus="yes">
        <source>{count} lines of heights</source>
        <comment>1 line of heights</comment>
        <translation>
            <numerusform>{count} 行高度</numerusform>
        </translation>
    </message>
    <message>
        <source>table {index} needs $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) of at least {count}; switch it on with $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 and $MA_CEC_ENABLE (MD32710) 1 of axis {axis}</source>
        <translation>表 {index} 的 $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) 至少应为 {count}；用 $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 和轴 {axis} 的 $MA_CEC_ENABLE (MD32710) 1 启用</translation>
    </message>
    <message>
        <source>no {variable} of {curve}</source>
        <translation>{curve} 没有 {variable}</translation>
    </message>
    <message numerus="yes">
        <source>{count} source axes</source>
        <comment>1 source axis</comment>
        <translation>
            <numerusform>{count} 个源轴</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} sizes</source>
        <comment>1 size</comment>
        <translation>
            <numerusform>{count} 个大小</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions and at least one correction</source>
        <comment>1 position and at least one correction</comment>
        <translation>
            <numerusform>{count} 个位置和至少一个修正量</numerusform>
        </translation>
    </message>
    <message>
        <source>{axes}</source>
        <translation>{axes}</translation>
    </message>
    <message>
        <source>{axes} to {target}</source>
        <translation>{axes} 到 {target}</translation>
    </message>
    <message>
        <source>(table layout)</source>
        <translation>（表布局）</translation>
    </message>
    <message>
        <source>it cannot be of type {type}; expected {expected}</source>
        <translation>类型不能是 {type}；应为：{expected}</translation>
    </message>
    <message>
        <source>f32 or f64</source>
        <translation>f32 或 f64</translation>
    </message>
    <message>
        <source>u8, u16, u32 or i32</source>
        <translation>u8、u16、u32 或 i32</translation>
    </message>
    <message>
        <source>its count is {found}, expected the length of the magic text, {expected}, which is at least 1</source>
        <translation>其个数为 {found}，应为标识文本 (magic) 的长度 {expected}，且至少为 1</translation>
    </message>
    <message>
        <source>its count is 0, expected at least 1</source>
        <translation>其个数为 0，至少应为 1</translation>
    </message>
    <message>
        <source>its count is {found}, expected {expected}</source>
        <translation>其个数为 {found}，应为 {expected}</translation>
    </message>
    <message>
        <source>its type {type} cannot hold {value}</source>
        <translation>其类型 {type} 容纳不下 {value}</translation>
    </message>
    <message>
        <source>it ends at byte {end}, but the header has only {size} bytes</source>
        <translation>该字段止于字节 {end}，而文件头只有 {size} 字节</translation>
    </message>
    <message>
        <source>it covers the header bytes before it, and there are none</source>
        <translation>它对其前的文件头字节有效，而其前没有字节</translation>
    </message>
    <message>
        <source>it begins at byte {begin}, inside {field}, which ends at byte {end}</source>
        <translation>该字段始于字节 {begin}，位于止于字节 {end} 的 {field} 之内</translation>
    </message>
    <message>
        <source>it is {size}, expected 1 to {limit} bytes</source>
        <translation>大小为 {size}，应为 1 至 {limit} 字节</translation>
    </message>
    <message>
        <source>it is missing; a table cannot be read without it</source>
        <translation>缺少该字段；没有它就无法读取表</translation>
    </message>
    <message numerus="yes">
        <source>{count} positions</source>
        <comment>1 position</comment>
        <translation>
            <numerusform>{count} 个位置</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} positions of {axis}</source>
        <comment>1 position of {axis}</comment>
        <translation>
            <numerusform>{axis} 的 {count} 个位置</numerusform>
        </translation>
    </message>
    <message>
        <source>CRC {crc}</source>
        <translation>CRC {crc}</translation>
    </message>
    <message>
        <source>the body is not JSON</source>
        <translation>正文不是 JSON</translation>
    </message>
    <message>
        <source>the body must be an array, {example}</source>
        <translation>正文必须是数组，{example}</translation>
    </message>
    <message>
        <source>{place} must be an object, {example}</source>
        <translation>{place} 必须是对象，{example}</translation>
    </message>
    <message>
        <source>{place}.path must be a text</source>
        <translation>{place}.path 必须是文本</translation>
    </message>
    <message>
        <source>{place}.value must be a number, a text, true, false or null</source>
        <translation>{place}.value 必须是数字、文本、true、false 或 null</translation>
    </message>
    <message>
        <source>the body must be an object with &quot;value&quot;: a number, a text, true, false or null</source>
        <translation>正文必须是带 &quot;value&quot; 的对象：数字、文本、true、false 或 null</translation>
    </message>
    <message>
        <source>one of u8, u16, u32, i32, f32, f64 or char is expected, with a count in brackets where there are several: char[32]</source>
        <translation>应为 u8、u16、u32、i32、f32、f64 或 char 之一，多个时在方括号中给出个数：char[32]</translation>
    </message>
    <message>
        <source>the count is given twice, here and in the type</source>
        <translation>个数给出了两次，一次在此，一次在类型中</translation>
    </message>
    <message>
        <source>the number of characters is missing: char[32]</source>
        <translation>缺少字符数：char[32]</translation>
    </message>
    <message>
        <source>there is no field {name} to hold it</source>
        <translation>没有存放它的字段 {name}</translation>
    </message>
    <message>
        <source>&quot;little&quot; or &quot;big&quot; is expected</source>
        <translation>应为 &quot;little&quot; 或 &quot;big&quot;</translation>
    </message>
    <message>
        <source>&quot;first&quot; or &quot;last&quot; is expected</source>
        <translation>应为 &quot;first&quot; 或 &quot;last&quot;</translation>
    </message>
    <message>
        <source>a file path such as tables/small1.TAMtbl is expected</source>
        <translation>应为文件路径，例如 tables/small1.TAMtbl</translation>
    </message>
    <message>
        <source>a file path has a name between its slashes, none at its ends, and no &quot;.&quot; or &quot;..&quot;</source>
        <translation>文件路径的斜杠之间须有名称，首尾无斜杠，且不含 &quot;.&quot; 或 &quot;..&quot;</translation>
    </message>
    <message>
        <source>there are more than {most} slots</source>
        <translation>表槽超过 {most} 个</translation>
    </message>
    <message>
        <source>this is the value that stands for no table, enums.tableDisabled</source>
        <translation>这是表示无表的值 enums.tableDisabled</translation>
    </message>
    <message>
        <source>another slot has the name {name}</source>
        <translation>另一个表槽的名称也是 {name}</translation>
    </message>
    <message>
        <source>another slot has the file {file}</source>
        <translation>另一个表槽的文件也是 {file}</translation>
    </message>
    <message>
        <source>at least one slot is needed</source>
        <translation>至少需要一个表槽</translation>
    </message>
    <message>
        <source>the path of a web page is expected, such as /directory</source>
        <translation>应为网页路径，例如 /directory</translation>
    </message>
    <message>
        <source>a slash is needed at the end, because a file path follows</source>
        <translation>末尾需要斜杠，因为其后还有文件路径</translation>
    </message>
    <message>
        <source>there must be no slash at the end</source>
        <translation>末尾不能有斜杠</translation>
    </message>
    <message>
        <source>this is the same page as directory</source>
        <translation>这与 directory 是同一页面</translation>
    </message>
    <message>
        <source>this is the same page as directory or transfer</source>
        <translation>这与 directory 或 transfer 是同一页面</translation>
    </message>
    <message>
        <source>this is the same field as transferPathField</source>
        <translation>这与 transferPathField 是同一字段</translation>
    </message>
    <message>
        <source>it is empty; a register path is expected</source>
        <translation>为空；应为寄存器路径</translation>
    </message>
    <message>
        <source>it has {count} characters, at most {most} are possible</source>
        <translation>有 {count} 个字符，最多 {most} 个</translation>
    </message>
    <message>
        <source>a path has one slash between its parts and none at its ends</source>
        <translation>路径各部分之间用一个斜杠，首尾无斜杠</translation>
    </message>
    <message>
        <source>a path is made of letters, digits, &apos;_&apos;, &apos;-&apos;, &apos;/&apos;, &apos;[&apos; and &apos;]&apos;; the character at position {position} is none of them</source>
        <translation>路径由字母、数字、&apos;_&apos;、&apos;-&apos;、&apos;/&apos;、&apos;[&apos; 和 &apos;]&apos; 组成；第 {position} 个字符不在其中</translation>
    </message>
    <message>
        <source>the placeholder {name} is missing</source>
        <translation>缺少占位符 {name}</translation>
    </message>
    <message>
        <source>the placeholder {name} is there more than once</source>
        <translation>占位符 {name} 出现不止一次</translation>
    </message>
    <message>
        <source>the placeholder {name} has no meaning here</source>
        <translation>占位符 {name} 在此没有意义</translation>
    </message>
    <message>
        <source>in braces there can only be a placeholder, one of {known}</source>
        <translation>花括号中只能是占位符，{known} 之一</translation>
    </message>
    <message>
        <source>a range is written in brackets, such as [0..15]</source>
        <translation>范围写在方括号中，例如 [0..15]</translation>
    </message>
    <message>
        <source>a range goes from a whole number up to another one, such as [0..15]</source>
        <translation>范围从一个整数到更大的整数，例如 [0..15]</translation>
    </message>
    <message>
        <source>the register {path} is there twice</source>
        <translation>寄存器 {path} 出现两次</translation>
    </message>
    <message>
        <source>the shortlist has more than {most} registers</source>
        <translation>候选列表超过 {most} 个寄存器</translation>
    </message>
    <message>
        <source>a word of 1 to {most} letters, digits, &apos;_&apos; or &apos;-&apos; is expected</source>
        <translation>应为由 1 至 {most} 个字母、数字、&apos;_&apos; 或 &apos;-&apos; 组成的词</translation>
    </message>
    <message>
        <source>this is the same register as {name}</source>
        <translation>这与 {name} 是同一寄存器</translation>
    </message>
    <message>
        <source>this is the same value as {name}</source>
        <translation>这与 {name} 是同一个值</translation>
    </message>
    <message>
        <source>a numeric type is expected: Int32, UInt32, Single or Double</source>
        <translation>应为数值类型：Int32、UInt32、Single 或 Double</translation>
    </message>
    <message>
        <source>the type {type} is there twice</source>
        <translation>类型 {type} 出现两次</translation>
    </message>
    <message>
        <source>at least one type is needed</source>
        <translation>至少需要一种类型</translation>
    </message>
    <message numerus="yes">
        <source>{count} registers</source>
        <comment>one register</comment>
        <translation>
            <numerusform>{count} 个寄存器</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} addresses</source>
        <comment>one address</comment>
        <translation>
            <numerusform>{count} 个地址</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;{code}&quot; is not what a drive can answer; that is one of {known}</source>
        <translation>“{code}”不是驱动器会给出的应答；可为 {known} 之一</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a fault; known are {known}</source>
        <translation>“{text}”不是故障；已知的有 {known}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is not a whole number from 1 to {most}, as {name} needs</source>
        <translation>“{text}”不是 {name} 所需的 1 至 {most} 的整数</translation>
    </message>
    <message>
        <source>a fault was asked for</source>
        <translation>按要求产生的故障</translation>
    </message>
    <message>
        <source>it is the state of the drive with serial number {found}, not of {expected}</source>
        <translation>这是序列号为 {found} 的驱动器的状态，不是 {expected} 的</translation>
    </message>
    <message>
        <source>the profile {profile} has no slot {slot}</source>
        <translation>描述文件 {profile} 没有表槽 {slot}</translation>
    </message>
    <message>
        <source>the table in {slot} is larger than the slot</source>
        <translation>{slot} 中的表大于该表槽</translation>
    </message>
    <message>
        <source>the name of a file in the folder {folder}</source>
        <translation>文件夹 {folder} 中的文件名</translation>
    </message>
    <message>
        <source>{place} must be {expected}</source>
        <translation>{place} 必须是{expected}</translation>
    </message>
    <message>
        <source>a list of whole numbers, 0 or more</source>
        <translation>不小于 0 的整数列表</translation>
    </message>
    <message>
        <source>a boolean, a number or a text</source>
        <translation>布尔值、数字或文本</translation>
    </message>
    <message>
        <source>it is not the JSON of a virtual drive&apos;s state</source>
        <translation>这不是虚拟驱动器状态的 JSON</translation>
    </message>
    <message>
        <source>a virtual drive has at most {most} axes, not {count}</source>
        <translation>虚拟驱动器最多有 {most} 个轴，不能是 {count} 个</translation>
    </message>
    <message>
        <source>an axis needs a range with low below high, and a period above 0 s</source>
        <translation>轴需要下限小于上限的范围，以及大于 0 s 的周期</translation>
    </message>
    <message>
        <source>a parameter does not fit: {reason}</source>
        <translation>有一个参数不合适：{reason}</translation>
    </message>
    <message>
        <source>{request} is not a request; these are: {known}</source>
        <translation>{request} 不是请求；可用：{known}</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, not {count}</source>
        <translation>请指定 1 至 {most} 个寄存器，不能是 {count} 个</translation>
    </message>
    <message>
        <source>name 1 to {most} registers, each with its value</source>
        <translation>请指定 1 至 {most} 个寄存器，各带其值</translation>
    </message>
    <message>
        <source>write {request}; &quot;&quot; is everything</source>
        <translation>写作 {request}；&quot;&quot; 表示全部</translation>
    </message>
    <message>
        <source>write {request}, the CRC in hexadecimal digits</source>
        <translation>写作 {request}，CRC 用十六进制数字</translation>
    </message>
    <message>
        <source>write {request}</source>
        <translation>写作 {request}</translation>
    </message>
    <message>
        <source>a new pseudo-terminal</source>
        <translation>新的伪终端</translation>
    </message>
    <message>
        <source>no pseudo-terminal: {reason}</source>
        <translation>没有伪终端：{reason}</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another one</source>
        <translation>已有同名文件；请选择其他名称</translation>
    </message>
    <message>
        <source>the link cannot be made: {reason}</source>
        <translation>无法建立链接：{reason}</translation>
    </message>
    <message>
        <source>the line has more than {most} characters</source>
        <translation>该行超过 {most} 个字符</translation>
    </message>
    <message>
        <source>this is no request; a line is [#n ]words[ *XXXX]</source>
        <translation>这不是请求；一行的写法为 [#n ]词[ *XXXX]</translation>
    </message>
    <message>
        <source>&quot;{value}&quot; is too large for a Single</source>
        <translation>“{value}”超出 Single 的范围</translation>
    </message>
    <message>
        <source>the value is longer than any name of an enum</source>
        <translation>该值比任何枚举名称都长</translation>
    </message>
    <message>
        <source>a document type is not allowed</source>
        <translation>不允许文档类型声明</translation>
    </message>
    <message>
        <source>entities are not allowed</source>
        <translation>不允许实体</translation>
    </message>
    <message>
        <source>the root element is {name}, expected TamTopology</source>
        <translation>根元素为 {name}，应为 TamTopology</translation>
    </message>
    <message>
        <source>a RegisterComponent needs Address, Type and Value</source>
        <translation>RegisterComponent 需要 Address、Type 和 Value</translation>
    </message>
    <message>
        <source>the axis index must be from 0 to {most}</source>
        <translation>轴索引必须为 0 至 {most}</translation>
    </message>
    <message>
        <source>there are more than {most} registers</source>
        <translation>寄存器超过 {most} 个</translation>
    </message>
    <message>
        <source>there is no TamStation with registers of an axis in it</source>
        <translation>其中没有含轴寄存器的 TamStation</translation>
    </message>
    <message numerus="yes">
        <source>{path}, or one of {count} others asked for with it</source>
        <comment>{path}, or another one asked for with it</comment>
        <translation>
            <numerusform>{path}，或同时查询的另外 {count} 个之一</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers</source>
        <comment>a JSON array of one register</comment>
        <translation>
            <numerusform>含 {count} 个寄存器的 JSON 数组</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a JSON array of {count} registers, in the order asked for</source>
        <comment>a JSON array of the one register asked for</comment>
        <translation>
            <numerusform>含 {count} 个寄存器的 JSON 数组，按查询顺序排列</numerusform>
        </translation>
    </message>
    <message>
        <source>this is empty</source>
        <translation>为空</translation>
    </message>
    <message>
        <source>this is there twice</source>
        <translation>出现两次</translation>
    </message>
    <message>
        <source>it does not read back as it was written</source>
        <translation>回读与写入不一致</translation>
    </message>
    <message>
        <source>it is not the table that was kept there: its size or CRC differs</source>
        <translation>这不是保存在那里的表：大小或 CRC 不同</translation>
    </message>
    <message>
        <source>it was kept about a write that did not end, but is damaged ({reason}). Look at what the drive holds, then delete the file</source>
        <translation>它是为一次未结束的写入保存的，但已损坏（{reason}）。请核对驱动器的现状，然后删除该文件</translation>
    </message>
    <message>
        <source>it is about axis {axis} of drive {drive}</source>
        <translation>它属于驱动器 {drive} 的轴 {axis}</translation>
    </message>
    <message>
        <source>user name or password is missing or wrong</source>
        <translation>用户名或密码缺失或错误</translation>
    </message>
    <message>
        <source>the request has more bytes than the largest that the drive takes</source>
        <translation>请求的字节数超过驱动器可接受的上限</translation>
    </message>
    <message>
        <source>it is not stated which axis the values of {column} correct, and the numbers depend on it; state the target: {sources}</source>
        <translation>没有注明 {column} 的值修正哪个轴，而数字取决于此；请给出目标轴：{sources}</translation>
    </message>
    <message>
        <source>{table} is the name of table {named} and the number of table {numbered}; say name:{table} or #{table}</source>
        <translation>{table} 既是表 {named} 的名称，又是表 {numbered} 的编号；请写 name:{table} 或 #{table}</translation>
    </message>
    <message>
        <source>the table goes from {before}, and the file would say from {after}; correct the settings for its axes, or the target</source>
        <translation>该表为 {before}，而文件将表示为 {after}；请更正其各轴的设置，或更正目标轴</translation>
    </message>
    <message>
        <source>one axis for all columns or one for each: the name of an axis, #1 for the first source, or other</source>
        <translation>所有列共用一个轴，或每列各一个：轴名、#1 表示第一个源、或 other</translation>
    </message>
    <message>
        <source>the axis of dimension {number}</source>
        <translation>维度 {number} 的轴</translation>
    </message>
    <message>
        <source>the axis of dimension {number} ({axis})</source>
        <translation>维度 {number} 的轴（{axis}）</translation>
    </message>
    <message>
        <source>an axis that is no source</source>
        <translation>不是源的轴</translation>
    </message>
    <message>
        <source>dimension {number} is its own position</source>
        <translation>维度 {number} 是其自身的位置</translation>
    </message>
    <message>
        <source>all sources are positions of other axes</source>
        <translation>所有源都是其他轴的位置</translation>
    </message>
    <message>
        <source>it corrects an axis by its own position, and this table goes from {column}</source>
        <translation>它按轴自身的位置修正该轴，而此表为 {column}</translation>
    </message>
    <message>
        <source>{statement} (source {number})</source>
        <translation>{statement}（源 {number}）</translation>
    </message>
    <message>
        <source>{statement} ({axis})</source>
        <translation>{statement}（{axis}）</translation>
    </message>
    <message>
        <source>{statement} (an axis that is no source)</source>
        <translation>{statement}（不是源的轴）</translation>
    </message>
    <message>
        <source>{count} targets are stated for {columns} columns; state one for all or one for each</source>
        <translation>为 {columns} 列给出了 {count} 个目标轴；请给出一个共用，或每列一个</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>另一个轴</translation>
    </message>
    <message>
        <source>{placeholder} is expected in the path</source>
        <translation>路径中应有 {placeholder}</translation>
    </message>
    <message>
        <source>the {what} are in {unit}, which cannot be converted to {other}, the unit of the drive; correct the unit in the file, or state it</source>
        <translation>{what}以 {unit} 为单位，无法换算成驱动器的单位 {other}；请更正文件中的单位，或注明单位</translation>
    </message>
    <message>
        <source>positions of dimension {number}</source>
        <translation>维度 {number} 的位置</translation>
    </message>
    <message>
        <source>Neither the table nor the drive states a unit for the values. The largest correction is {largest}.</source>
        <translation>表和驱动器都没有注明值的单位。最大修正量为 {largest}。</translation>
    </message>
    <message>
        <source>The values are converted from {before} to {after}. The largest correction is {largest}.</source>
        <translation>值由 {before} 换算成 {after}。最大修正量为 {largest}。</translation>
    </message>
    <message>
        <source>The drive states no unit for the axis; the values are written in {before}. The largest correction is {largest}.</source>
        <translation>驱动器没有注明该轴的单位；值以 {before} 写入。最大修正量为 {largest}。</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {after}. The largest correction is {largest}.</source>
        <translation>该表没有注明值的单位；按 {after} 处理。最大修正量为 {largest}。</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are converted from {before} to {after}: {first} to {last}.</source>
        <translation>维度 {number} 的位置由 {before} 换算成 {after}：{first} 至 {last}。</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them in the preview, or with --accept-large</source>
        <translation>{reason}请检查值的单位；如果无误，请在预览中或用 --accept-large 确认</translation>
    </message>
    <message>
        <source>The largest correction, {largest}, is {percent} of the range of dimension {number}, {range}.</source>
        <translation>最大修正量 {largest} 达到维度 {number} 范围 {range} 的 {percent}。</translation>
    </message>
    <message>
        <source>The correction has a slope of {slope} along dimension {number}, between {first} and {last}.</source>
        <translation>修正量沿维度 {number} 在 {first} 与 {last} 之间的斜率为 {slope}。</translation>
    </message>
    <message>
        <source>The axis is outside of the table, where the values at its ends hold. Move the axis into the table and activate again.</source>
        <translation>轴位于表的范围之外，该处保持端值。请将轴移入表的范围，然后重新启用。</translation>
    </message>
    <message>
        <source>The table is 0, or too small to be seen, at every position that was looked at. Move the axis to where the table is larger and activate again.</source>
        <translation>在查看过的所有位置上，表的值为 0，或小到无法分辨。请将轴移到表值较大的位置，然后重新启用。</translation>
    </message>
    <message>
        <source>version 1 of the height map</source>
        <translation>高度图的版本 1</translation>
    </message>
    <message>
        <source>version 2, which newer firmware writes</source>
        <translation>版本 2，由较新的固件写出</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a file</source>
        <translation>这是管道或设备，不是文件</translation>
    </message>
    <message>
        <source>the values are multiplied by a number that is not 0, and shifted by a number</source>
        <translation>值乘以一个不为 0 的数，并平移一个数</translation>
    </message>
    <message>
        <source>an offset and a position at which the values are 0 contradict each other</source>
        <translation>偏移量与值为 0 的位置相互矛盾</translation>
    </message>
    <message>
        <source>the position at which the values are 0 needs a number for each of the {count} source axes</source>
        <translation>值为 0 的位置需要为 {count} 个源轴各给一个数字</translation>
    </message>
    <message>
        <source>{position} of source {number}, where the values shall be 0, is outside of the table, which goes from {first} to {last}</source>
        <translation>源 {number} 的 {position} 处值应为 0，但该处在表的范围 {first} 至 {last} 之外</translation>
    </message>
    <message>
        <source>the values are multiplied by {factor}</source>
        <translation>值乘以 {factor}</translation>
    </message>
    <message>
        <source>the values of {column} are shifted by {shift}</source>
        <translation>{column} 的值平移 {shift}</translation>
    </message>
    <message>
        <source>{source} is a position after the compensation: the table would be looked up where its own values have moved the axis.</source>
        <translation>{source} 是补偿后的位置：查表的位置将是该表自身的值使轴移动之后的位置。</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; write volatile, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>此驱动器的闪存操作记录已损坏，因此视为全部用完；请以易失方式写入，或用“axiscomp status --reset-flash-count”将计数复位</translation>
    </message>
    <message>
        <source>it is not an ordinary file; move it away</source>
        <translation>这不是普通文件；请将其移走</translation>
    </message>
    <message>
        <source>the SHA-256 of a certificate is expected</source>
        <translation>应为证书的 SHA-256</translation>
    </message>
    <message>
        <source>it cannot be renamed: {reason}</source>
        <translation>无法重命名：{reason}</translation>
    </message>
    <message>
        <source>it is on a network file system, where a database can be damaged; set XDG_STATE_HOME to a folder on this computer</source>
        <translation>它位于网络文件系统上，数据库可能在那里损坏；请将 XDG_STATE_HOME 设为本计算机上的文件夹</translation>
    </message>
    <message>
        <source>a newer version of this program has written it; use that version</source>
        <translation>它由本程序的更新版本写成；请使用该版本</translation>
    </message>
    <message>
        <source>it is the database of another program; move it away</source>
        <translation>这是另一程序的数据库；请将其移走</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>该文件为只读</translation>
    </message>
    <message>
        <source>this file system cannot share it between programs</source>
        <translation>该文件系统不支持多个程序共用此文件</translation>
    </message>
    <message>
        <source>the file or its folder is read-only</source>
        <translation>该文件或其文件夹为只读</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>its journal of an interrupted write is damaged ({reason}). Look at what the drive holds, then move the file away</source>
        <translation>其中断写入的写入日志已损坏（{reason}）。请核对驱动器的现状，然后将该文件移走</translation>
    </message>
    <message>
        <source>{axis} is taken for {first} to {last} in steps of {distance}; the largest shift is {shift}, at {position}</source>
        <translation>{axis} 视为 {first} 至 {last}、间距 {distance}；最大移动量为 {shift}，在 {position}</translation>
    </message>
    <message>
        <source>position {number}</source>
        <translation>位置 {number}</translation>
    </message>
    <message>
        <source>no 2 neighbouring points in every dimension with a value</source>
        <translation>并非每个维度都有 2 个有值的相邻点</translation>
    </message>
    <message>
        <source>a part of the grid that is complete; fill the points instead</source>
        <translation>网格中完整的部分；请改为填补这些点</translation>
    </message>
    <message>
        <source>{axis} from {first} to {last}</source>
        <translation>{axis} 从 {first} 到 {last}</translation>
    </message>
    <message>
        <source>{missing} of {all} points without a value; kept are {kept} points, {ranges}</source>
        <translation>{all} 点中 {missing} 点没有值；保留 {kept} 点，{ranges}</translation>
    </message>
    <message>
        <source>no value at all in {table}</source>
        <translation>{table} 中没有任何值</translation>
    </message>
    <message>
        <source>a column with values</source>
        <translation>有值的列</translation>
    </message>
    <message>
        <source>{count} points without a value</source>
        <translation>{count} 点没有值</translation>
    </message>
    <message>
        <source>at most {most} for a smooth filling; choose the nearest point or a plane</source>
        <translation>平滑填补最多 {most} 点；请选择最近点或平面</translation>
    </message>
    <message>
        <source>measured points of {table} on one line only</source>
        <translation>{table} 的测得点仅在一条直线上</translation>
    </message>
    <message>
        <source>points that determine a plane; choose the nearest point instead</source>
        <translation>能确定平面的点；请改选最近点</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} 至 {high}</translation>
    </message>
    <message>
        <source>{count} of {all} points of {table} without a value; they get {made}, the measured values are {measured}</source>
        <translation>{table} 的 {all} 点中 {count} 点没有值；填入 {made}，测得值为 {measured}</translation>
    </message>
    <message>
        <source>{expected}; a tolerance of {tolerance} takes them for an even grid (--snap, or Snap tolerance in the import)</source>
        <translation>{expected}；公差为 {tolerance} 时可视为均匀网格（--snap，或导入中的“吸附公差”）</translation>
    </message>
    <message>
        <source>every combination of the positions; missing points can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>位置的每种组合；缺失点可填补或略去（--fill、--crop，或导入中的“缺失点”）</translation>
    </message>
    <message>
        <source>{expected}; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>{expected}；没有值的点可填补或略去（--fill、--crop，或导入中的“缺失点”）</translation>
    </message>
    <message>
        <source>a height with decimals; points without a value can be filled or left out (--fill, --crop, or Missing points in the import)</source>
        <translation>带小数的高度；没有值的点可填补或略去（--fill、--crop，或导入中的“缺失点”）</translation>
    </message>
    <message>
        <source>every combination of the positions</source>
        <translation>位置的每种组合</translation>
    </message>
    <message>
        <source>parameter 1020 of the axis shows the commanded position with the compensation in it</source>
        <translation>轴的参数 1020 显示含补偿的指令位置</translation>
    </message>
    <message>
        <source>at most {most} for older kernels</source>
        <translation>较旧的内核最多 {most}</translation>
    </message>
    <message>
        <source>the table has {count} points; older kernels take at most {most}</source>
        <translation>该表有 {count} 点；较旧的内核最多接受 {most} 点</translation>
    </message>
    <message>
        <source>unit of the positions, in place of what the header says</source>
        <translation>位置的单位，取代标题行所注</translation>
    </message>
    <message>
        <source>unit of the values, in place of what the header says</source>
        <translation>值的单位，取代标题行所注</translation>
    </message>
    <message>
        <source>{number} ({name}, axes: {axes})</source>
        <translation>{number}（{name}，轴：{axes}）</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>{slot} is empty: there is nothing to delete</source>
        <translation>{slot} 为空：没有可删除的内容</translation>
    </message>
    <message>
        <source>axis {axis} uses no table: there is nothing to delete</source>
        <translation>轴 {axis} 不使用表：没有可删除的内容</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}: name another slot, or none, and a free one is chosen</source>
        <translation>表槽 {slot} 正由 {user} 使用：请指定另一个，或不指定，程序会选用空闲的表槽</translation>
    </message>
    <message>
        <source>the table in {slot} is not deleted, because {user} uses it; free it there first</source>
        <translation>{slot} 中的表未删除，因为 {user} 正在使用；请先在那里释放</translation>
    </message>
    <message>
        <source>Flash may hold an older table in {slot}: that one is deleted too.</source>
        <translation>闪存中 {slot} 可能有旧表：一并删除。</translation>
    </message>
    <message>
        <source>The parameters of all axes are saved before {slot} is emptied: otherwise {axis} could look for the deleted table after a reboot.</source>
        <translation>清空 {slot} 前先保存所有轴的参数：否则 {axis} 重启后可能查找已删除的表。</translation>
    </message>
    <message>
        <source>After a reboot {axis} uses the table in {slot} again, as its saved parameters say.</source>
        <translation>重启后 {axis} 按其已保存的参数重新使用 {slot} 中的表。</translation>
    </message>
    <message>
        <source>the configuration has {unit} for axis {axis}, but the axis of the drive has {other}</source>
        <translation>配置中轴 {axis} 的单位为 {unit}，而驱动器的该轴为 {other}</translation>
    </message>
    <message>
        <source>the profile has no slot {slot}</source>
        <translation>描述文件没有表槽 {slot}</translation>
    </message>
    <message>
        <source>the station {station} has no register {path}</source>
        <translation>站 {station} 没有寄存器 {path}</translation>
    </message>
    <message>
        <source>the unit is {unit}, but the axis that is written has {other}</source>
        <translation>单位为 {unit}，而要写入的轴为 {other}</translation>
    </message>
    <message>
        <source>which station of {file} is meant is not certain; name one of: {known}</source>
        <translation>无法确定指的是 {file} 中的哪个站；请指定其一：{known}</translation>
    </message>
    <message>
        <source>it is not a text in UTF-8</source>
        <translation>不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>it is not an XML document</source>
        <translation>不是 XML 文档</translation>
    </message>
    <message>
        <source>it ends before {name} ends</source>
        <translation>在 {name} 结束之前就已结束</translation>
    </message>
    <message>
        <source>a tag is not well-formed</source>
        <translation>有一个标签格式不正确</translation>
    </message>
    <message>
        <source>{name} ends where it has not begun</source>
        <translation>{name} 未开始就结束</translation>
    </message>
    <message>
        <source>it has changed since it was read; export again</source>
        <translation>读取之后已改变；请重新导出</translation>
    </message>
    <message numerus="yes">
        <source>{count} more comment lines</source>
        <comment>1 more comment line</comment>
        <translation>
            <numerusform>另有 {count} 行注释</numerusform>
        </translation>
    </message>
    <message>
        <source>at most 1 MiB of comments</source>
        <translation>最多 1 MiB 注释</translation>
    </message>
    <message>
        <source>The drive looks up where it should, but adds nothing while it evaluates. Activate to prove what it adds.</source>
        <translation>驱动器查表的位置正确，但试算时不叠加任何值。请启用，以验证其叠加的值。</translation>
    </message>
    <message>
        <source>it has nothing of axis {axis}</source>
        <translation>其中没有轴 {axis} 的内容</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: {percent} of the travel of axis {axis}, {low} to {high}. Beyond the table the drive holds the value of its end.</source>
        <translation>表的维度 {number} 从 {first} 到 {last}：为轴 {axis} 行程 {low} 至 {high} 的 {percent}。超出表的范围，驱动器保持端值。</translation>
    </message>
    <message>
        <source>Dimension {number} of the table reaches from {first} to {last}: outside the travel of axis {axis}, {low} to {high}. The drive holds the value of one end everywhere.</source>
        <translation>表的维度 {number} 从 {first} 到 {last}：在轴 {axis} 的行程 {low} 至 {high} 之外。驱动器处处保持一端的端值。</translation>
    </message>
    <message>
        <source>The backup is of another drive, the one with the serial number {number}.</source>
        <translation>该备份属于另一台驱动器，序列号为 {number}。</translation>
    </message>
    <message>
        <source>a full {dimensions}D grid of {points} points</source>
        <translation>{points} 点的完整 {dimensions}D 网格</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid measurement: {count} problems</source>
        <comment>{file} is not a valid measurement: one problem</comment>
        <translation>
            <numerusform>{file} 不是有效的测量：{count} 个问题</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} does not say its units; state them with --unit and --value-unit</source>
        <translation>{file} 没有注明单位；请用 --unit 和 --value-unit 给出</translation>
    </message>
    <message>
        <source>the positions in {file} do not follow one another one to one</source>
        <translation>{file} 中各位置之间不是一比一</translation>
    </message>
    <message>
        <source>{file} has no targets; the figures of the standard need a measurement of runs over targets</source>
        <translation>{file} 没有目标位置；标准规定的指标要求按目标位置的逐趟测量</translation>
    </message>
    <message>
        <source>an error in mm</source>
        <translation>以 mm 为单位的误差</translation>
    </message>
    <message>
        <source>a position without a bidirectional mean</source>
        <translation>没有双向平均值的位置</translation>
    </message>
    <message>
        <source>the same positions in both blocks</source>
        <translation>两个数据块中相同的位置</translation>
    </message>
    <message>
        <source>no block of a direction</source>
        <translation>没有单个方向的数据块</translation>
    </message>
    <message>
        <source>a block Forward Directional Avg Error; the mean of both directions alone says nothing of either</source>
        <translation>数据块 Forward Directional Avg Error；只有双向平均值，看不出任一方向</translation>
    </message>
    <message>
        <source>means of a linear measurement (.pos)</source>
        <translation>线性测量的平均值 (.pos)</translation>
    </message>
    <message>
        <source>TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= or KEY=</source>
        <translation>TGT_DATA[i]=、REF_DATA_FWD[i,j]=、REF_DATA_BWD[i,j]= 或 键=</translation>
    </message>
    <message>
        <source>the position of a target</source>
        <translation>目标位置的坐标</translation>
    </message>
    <message>
        <source>a second target {number}</source>
        <translation>第二个目标位置 {number}</translation>
    </message>
    <message>
        <source>each target once</source>
        <translation>每个目标位置一次</translation>
    </message>
    <message>
        <source>a position of the reference</source>
        <translation>基准的位置</translation>
    </message>
    <message>
        <source>{key}: {said}, but {found} are there</source>
        <translation>{key}：{said}，实有 {found}</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>整个文件</translation>
    </message>
    <message>
        <source>a length or an angle: mm, um, m, inch, deg, arcsec, mrad</source>
        <translation>长度或角度：mm、um、m、inch、deg、arcsec、mrad</translation>
    </message>
    <message>
        <source>the number of a target, TGT_DATA[{number}]=</source>
        <translation>目标位置的编号，TGT_DATA[{number}]=</translation>
    </message>
    <message>
        <source>data of an ISO 230-2 test</source>
        <translation>GB/T 17421.2 (ISO 230-2) 检验的数据</translation>
    </message>
    <message>
        <source>a head such as i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</source>
        <translation>表头，例如 i|tgt_pos(i) [mm]|ref_pos(i,1) [mm]|</translation>
    </message>
    <message>
        <source>a position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>{value}, as the head of the table has</source>
        <translation>{value}，与表头一致</translation>
    </message>
    <message>
        <source>a report by a program that is known to print forward and backward the other way round</source>
        <translation>由已知会将正向和反向互换输出的程序生成的报告</translation>
    </message>
    <message>
        <source>report of an ISO 230-2 test, with its results</source>
        <translation>GB/T 17421.2 (ISO 230-2) 检验报告，含结果</translation>
    </message>
    <message>
        <source>a line with the names of the columns, such as target [mm]</source>
        <translation>一行列名，例如 target [mm]</translation>
    </message>
    <message>
        <source>no column {column} for {role}</source>
        <translation>没有用作{role}的列 {column}</translation>
    </message>
    <message numerus="yes">
        <source>the name of a column, or its number from 1 to {count}</source>
        <comment>the name of the column, or 1</comment>
        <translation>
            <numerusform>列名，或列号 1 至 {count}</numerusform>
        </translation>
    </message>
    <message>
        <source>two columns for {role}</source>
        <translation>有两列用作{role}</translation>
    </message>
    <message>
        <source>one; name the columns with --columns</source>
        <translation>一列；请用 --columns 指定各列</translation>
    </message>
    <message>
        <source>a column for {role}</source>
        <translation>用作{role}的列</translation>
    </message>
    <message>
        <source>one of these words before the =: {known}</source>
        <translation>= 之前为以下词之一：{known}</translation>
    </message>
    <message>
        <source>a unit in brackets behind the name, such as {example}, or --unit and --value-unit</source>
        <translation>名称之后方括号中的单位，例如 {example}，或 --unit 和 --value-unit</translation>
    </message>
    <message>
        <source>column {column}</source>
        <translation>列 {column}</translation>
    </message>
    <message>
        <source>the unit {unit} of column {column}</source>
        <translation>列 {column} 的单位 {unit}</translation>
    </message>
    <message>
        <source>an angle as the targets are</source>
        <translation>角度，与目标位置一样</translation>
    </message>
    <message>
        <source>a length as the targets are</source>
        <translation>长度，与目标位置一样</translation>
    </message>
    <message>
        <source>corrected: none, or corrected: 20C</source>
        <translation>corrected: none，或 corrected: 20C</translation>
    </message>
    <message>
        <source>values: deviation, or values: reference</source>
        <translation>values: deviation，或 values: reference</translation>
    </message>
    <message>
        <source>sign: deviation (reference minus target), or sign: correction (its opposite)</source>
        <translation>sign: deviation（基准减目标位置），或 sign: correction（与之相反）</translation>
    </message>
    <message>
        <source>a temperature in deg C, such as 20.4</source>
        <translation>以 °C 为单位的温度，例如 20.4</translation>
    </message>
    <message>
        <source>a coefficient of expansion in 1/K, such as 11.5e-6</source>
        <translation>以 1/K 为单位的膨胀系数，例如 11.5e-6</translation>
    </message>
    <message>
        <source>compensation: off, on, or crc: with the checksum of the table, such as crc:1c291ca3</source>
        <translation>compensation: off、on，或 crc: 加表的校验和，例如 crc:1c291ca3</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names no columns; write target=1,direction=3,deviation=5, with numbers or names of columns</source>
        <translation>“{text}”没有指定任何列；写作 target=1,direction=3,deviation=5，用列号或列名</translation>
    </message>
    <message>
        <source>no columns X and Y</source>
        <translation>没有 X 列和 Y 列</translation>
    </message>
    <message>
        <source>columns X and Y, or X, Y and Z, with the positions</source>
        <translation>存放位置的 X、Y 列，或 X、Y、Z 列</translation>
    </message>
    <message>
        <source>no column of values</source>
        <translation>没有值的列</translation>
    </message>
    <message>
        <source>at least one behind the positions, such as dX [um]</source>
        <translation>位置之后至少一列，例如 dX [um]</translation>
    </message>
    <message>
        <source>a line for each point</source>
        <translation>每个点一行</translation>
    </message>
    <message>
        <source>CSV of values at positions of 2 or 3 axes</source>
        <translation>2 或 3 个轴各位置上值的 CSV</translation>
    </message>
    <message>
        <source>run, number of the target and deviation, such as 1 1 0.21</source>
        <translation>趟次、目标位置编号和偏差，例如 1 1 0.21</translation>
    </message>
    <message>
        <source>a deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>从 1 起的整数</translation>
    </message>
    <message numerus="yes">
        <source>a number from 1 to {count}, as there are targets</source>
        <comment>1, the only target</comment>
        <translation>
            <numerusform>1 至 {count} 的编号，与目标位置数一致</numerusform>
        </translation>
    </message>
    <message>
        <source>the whole file; save it again from the instrument&apos;s software</source>
        <translation>整个文件；请从仪器软件重新保存</translation>
    </message>
    <message>
        <source>File type: rtl or rta, which says the units</source>
        <translation>File type: rtl 或 rta，由此得出单位</translation>
    </message>
    <message>
        <source>sections TARGET DATA:: and DEVIATIONS:: with their numbers</source>
        <translation>TARGET DATA:: 段和 DEVIATIONS:: 段及其数字</translation>
    </message>
    <message numerus="yes">
        <source>{count} runs of a unidirectional file that are exactly 0 throughout</source>
        <comment>1 run of a unidirectional file that is exactly 0 throughout</comment>
        <translation>
            <numerusform>单向文件中有 {count} 趟的值全部正好为 0</numerusform>
        </translation>
    </message>
    <message>
        <source>a run whose target numbers rise or fall throughout</source>
        <translation>目标位置编号始终递增或始终递减的一趟</translation>
    </message>
    <message>
        <source>linear and angular measurements (.rtl, .rta)</source>
        <translation>线性和角度测量 (.rtl, .rta)</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times smaller, as um for mm</source>
        <translation>基准的单位小 1000 倍，例如应为 mm 却是 um</translation>
    </message>
    <message>
        <source>the reference has a unit that is 1000 times larger, as m for mm</source>
        <translation>基准的单位大 1000 倍，例如应为 mm 却是 m</translation>
    </message>
    <message>
        <source>the reference is in mm and the encoder in inch</source>
        <translation>基准以 mm 为单位，编码器以英寸为单位</translation>
    </message>
    <message>
        <source>the reference is in inch and the encoder in mm</source>
        <translation>基准以英寸为单位，编码器以 mm 为单位</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts half</source>
        <translation>干涉仪的系数不对：计数减半</translation>
    </message>
    <message>
        <source>the factor of the interferometer is wrong: it counts double</source>
        <translation>干涉仪的系数不对：计数加倍</translation>
    </message>
    <message>
        <source>the reference is in degrees and the encoder in radians</source>
        <translation>基准以度为单位，编码器以弧度为单位</translation>
    </message>
    <message>
        <source>the reference is in radians and the encoder in degrees</source>
        <translation>基准以弧度为单位，编码器以度为单位</translation>
    </message>
    <message>
        <source>the instrument counts the other way; if so, say it with --invert-reference</source>
        <translation>仪器的计数方向相反；如果是这样，请用 --invert-reference 注明</translation>
    </message>
    <message>
        <source>1; {meaning}: correct the file, or state the unit of the reference with --value-unit, and that of the other positions with --unit</source>
        <translation>1；{meaning}：请更正文件，或用 --value-unit 给出基准的单位，用 --unit 给出其他位置的单位</translation>
    </message>
    <message>
        <source>1 within 1 %; check which columns are reference and encoder, and their units</source>
        <translation>1，误差在 1 % 以内；请检查哪些列是基准和编码器，以及它们的单位</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets</source>
        <comment>1 target</comment>
        <translation>
            <numerusform>{count} 个目标位置</numerusform>
        </translation>
    </message>
    <message>
        <source>at least 2 different positions that the axis was sent to</source>
        <translation>轴曾移到的至少 2 个不同位置</translation>
    </message>
    <message>
        <source>target {target}, {direction}, run {run} in line {first} and in line {second}</source>
        <translation>目标位置 {target}、{direction}、第 {run} 趟出现在第 {first} 行和第 {second} 行</translation>
    </message>
    <message>
        <source>{up} up and {down} down</source>
        <translation>正向 {up}，负向 {down}</translation>
    </message>
    <message>
        <source>as many in each direction</source>
        <translation>每个方向相同的个数</translation>
    </message>
    <message numerus="yes">
        <source>no value for {places} ({count} are missing)</source>
        <comment>no value for {places}</comment>
        <translation>
            <numerusform>{places} 没有值（缺 {count} 个）</numerusform>
        </translation>
    </message>
    <message>
        <source>a value for every target in every run</source>
        <translation>每一趟中每个目标位置一个值</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the target</source>
        <translation>随目标位置以 {slope} 的斜率上升的值</translation>
    </message>
    <message>
        <source>deviations, which hardly follow it</source>
        <translation>几乎不随目标位置变化的偏差</translation>
    </message>
    <message>
        <source>a largest deviation of {value} over {travel}</source>
        <translation>在 {travel} 上最大偏差为 {value}</translation>
    </message>
    <message>
        <source>more than a billionth of the travel</source>
        <translation>大于行程的十亿分之一</translation>
    </message>
    <message>
        <source>at most 1 % of the travel</source>
        <translation>最多为行程的 1 %</translation>
    </message>
    <message>
        <source>the reference moves {slope} times as far as the axis</source>
        <translation>基准的移动量是轴的 {slope} 倍</translation>
    </message>
    <message>
        <source>no column target</source>
        <translation>没有 target 列</translation>
    </message>
    <message>
        <source>a column target, or which column it is: --columns &apos;target=1,direction=2,...&apos;</source>
        <translation>target 列，或指明是哪一列：--columns &apos;target=1,direction=2,...&apos;</translation>
    </message>
    <message>
        <source>no column direction</source>
        <translation>没有 direction 列</translation>
    </message>
    <message>
        <source>a column direction with + and -, or --direction-from order when the runs rise and fall</source>
        <translation>以 + 和 - 表示的 direction 列；各趟有升有降时也可用 --direction-from order</translation>
    </message>
    <message>
        <source>neither deviation nor reference</source>
        <translation>既没有 deviation 也没有 reference</translation>
    </message>
    <message>
        <source>both deviation and reference</source>
        <translation>同时有 deviation 和 reference</translation>
    </message>
    <message>
        <source>either a column deviation (reference minus target) or a column reference (position)</source>
        <translation>deviation 列（基准减目标位置）或 reference 列（位置），二者之一</translation>
    </message>
    <message>
        <source>+ or -, up or down, forward or backward</source>
        <translation>+ 或 -、up 或 down、forward 或 backward</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>第 {line} 行</translation>
    </message>
    <message>
        <source>at least two targets one after the other in each run, so that its direction shows</source>
        <translation>每一趟中至少连续两个目标位置，以便看出其方向</translation>
    </message>
    <message>
        <source>CSV with a line for each value</source>
        <translation>每个值一行的 CSV</translation>
    </message>
    <message>
        <source>no column encoder</source>
        <translation>没有 encoder 列</translation>
    </message>
    <message>
        <source>no column reference</source>
        <translation>没有 reference 列</translation>
    </message>
    <message>
        <source>columns encoder and reference</source>
        <translation>encoder 列和 reference 列</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples</source>
        <comment>1 sample</comment>
        <translation>
            <numerusform>{count} 个采样点</numerusform>
        </translation>
    </message>
    <message>
        <source>at least {count} samples of an axis that moves</source>
        <translation>轴运动中的至少 {count} 个采样点</translation>
    </message>
    <message numerus="yes">
        <source>{count} samples after turns, until the axis had moved {overrun}</source>
        <comment>1 sample after a turn, until the axis had moved {overrun}</comment>
        <translation>
            <numerusform>反向之后、轴移动 {overrun} 之前的 {count} 个采样点</numerusform>
        </translation>
    </message>
    <message>
        <source>CSV of encoder and reference positions without targets</source>
        <translation>不含目标位置的编码器和基准位置 CSV</translation>
    </message>
    <message>
        <source>columns of runs that are either deviations or positions</source>
        <translation>各趟的列，可能是偏差，也可能是位置</translation>
    </message>
    <message>
        <source>a column target before those of the runs</source>
        <translation>位于各趟列之前的 target 列</translation>
    </message>
    <message>
        <source>CSV with a line for each target</source>
        <translation>每个目标位置一行的 CSV</translation>
    </message>
    <message>
        <source>angles do not change with temperature or air: the correction is for lengths</source>
        <translation>角度不随温度或空气变化：该修正只用于长度</translation>
    </message>
    <message>
        <source>the file says that its values are corrected to 20 deg C already; correcting them again would make them wrong</source>
        <translation>文件注明其值已修正到 20 °C；再次修正会使其出错</translation>
    </message>
    <message>
        <source>a temperature is in deg C and a coefficient of expansion in 1/K, such as 22.5 and 11.5e-6</source>
        <translation>温度以 °C 为单位，膨胀系数以 1/K 为单位，例如 22.5 和 11.5e-6</translation>
    </message>
    <message>
        <source>a dead path is a length in mm between the interferometer and the reflector, at most 100 m</source>
        <translation>死程是干涉仪与反射镜之间以 mm 为单位的长度，最大 100 m</translation>
    </message>
    <message>
        <source>there is no such air on the dead path: pressure is in kPa (50 to 120), temperature in deg C (-40 to 60), humidity in percent (0 to 100)</source>
        <translation>死程上不可能有这样的空气：气压以 kPa 为单位（50 至 120），温度以 °C 为单位（-40 至 60），湿度以百分数表示（0 至 100）</translation>
    </message>
    <message>
        <source>{file} does not describe a dead path: {reason}</source>
        <translation>{file} 没有描述死程：{reason}</translation>
    </message>
    <message>
        <source>the air of run {run} {direction} is not known; the dead path needs pressure, temperature and humidity of every run</source>
        <translation>{direction}第 {run} 趟的空气参数未知；死程需要每一趟的气压、温度和湿度</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>非负的数字</translation>
    </message>
    <message>
        <source>the uncertainty budget is wrong: {reason}</source>
        <translation>不确定度评定有误：{reason}</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no angle; write a number that is not negative and its unit, such as 5arcsec</source>
        <translation>“{text}”不是角度；写出非负的数字及其单位，例如 5arcsec</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no length; write a number that is not negative and its unit, such as 10um</source>
        <translation>“{text}”不是长度；写出非负的数字及其单位，例如 10um</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; is no tolerance; write a figure and its limit, such as A=10um; the figures are A, A+, A-, R, R+, R-, E, E+, E-, B, Bm and M</source>
        <translation>“{text}”不是公差；写出指标及其限值，例如 A=10um；指标有 A、A+、A-、R、R+、R-、E、E+、E-、B、Bm 和 M</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; names nothing that can be excluded; write down:1:1 for a value (direction, target, run), run:up:3 or target:7</source>
        <translation>“{text}”没有指明可排除的内容；单个值写 down:1:1（方向、目标位置、趟次），也可写 run:up:3 或 target:7</translation>
    </message>
    <message>
        <source>there is no value {exclusion}: the measurement has {targets} targets, {up} runs up and {down} runs down</source>
        <translation>没有值 {exclusion}：该测量有 {targets} 个目标位置，正向 {up} 趟，负向 {down} 趟</translation>
    </message>
    <message>
        <source>only runs over targets can be joined; one file has {kind}</source>
        <translation>只能合并按目标位置的逐趟测量；有一个文件是{kind}</translation>
    </message>
    <message>
        <source>a measurement of lengths and one of angles cannot be joined</source>
        <translation>长度测量和角度测量不能合并</translation>
    </message>
    <message>
        <source>measurements with different tables, or with and without compensation, cannot be joined</source>
        <translation>使用不同表的测量，或有补偿与无补偿的测量，不能合并</translation>
    </message>
    <message>
        <source>these positions cannot tell an error with the period {period}: they lie in {filled} of {classes} equal parts of the period, and {fewest} are needed; measure at targets that are spread over the period (axiscomp targets --period), or leave the period out</source>
        <translation>在这些位置上无法辨别周期为 {period} 的误差：它们只落在周期 {classes} 等分中的 {filled} 份，至少需要 {fewest} 份；请在分布于整个周期的目标位置上测量（axiscomp targets --period），或不用该周期</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of the grid, at {region}, are more than {distances} distances away from any measured point; measure there, take a smaller grid, or let them be filled (--fill smooth or --fill nearest)</source>
        <comment>one point of the grid, at {region}, is more than {distances} distances away from any measured point; measure there, take a smaller grid, or let it be filled (--fill smooth or --fill nearest)</comment>
        <translation>
            <numerusform>{region} 处有 {count} 个网格点距任何测得点超过 {distances} 个间距；请在那里测量，或取较小的网格，或予以填补（--fill smooth 或 --fill nearest）</numerusform>
        </translation>
    </message>
    <message>
        <source>the computation did not come to an end: {reason}</source>
        <translation>计算未能完成：{reason}</translation>
    </message>
    <message>
        <source>each position must have one value and one weight</source>
        <translation>每个位置必须有一个值和一个权</translation>
    </message>
    <message>
        <source>positions, values and weights must be finite numbers</source>
        <translation>位置、值和权必须是有限的数字</translation>
    </message>
    <message>
        <source>weights must be larger than 0</source>
        <translation>权必须大于 0</translation>
    </message>
    <message>
        <source>the period of a modulo axis must be a number above 0</source>
        <translation>模数轴的周期必须大于 0</translation>
    </message>
    <message>
        <source>there are values at {count} positions; this method needs {fewest}, measure more of them or choose another method</source>
        <translation>只有 {count} 个位置有值；此方法需要 {fewest} 个，请测量更多位置或选择其他方法</translation>
    </message>
    <message>
        <source>the number of harmonics must be 1 to 1000</source>
        <translation>谐波数必须为 1 至 1000</translation>
    </message>
    <message>
        <source>a period has at least one harmonic</source>
        <translation>一个周期至少有一次谐波</translation>
    </message>
    <message>
        <source>a period must be a number above 0</source>
        <translation>周期必须大于 0</translation>
    </message>
    <message>
        <source>the period {period} is wanted twice, by itself or as a harmonic of another; give each once</source>
        <translation>周期 {period} 给出了两次，一次为其本身，一次为另一周期的谐波；每个只给一次</translation>
    </message>
    <message>
        <source>the period {period} does not divide the turn of {turn}; on a modulo axis it must</source>
        <translation>周期 {period} 不能整除一转 {turn}；对模数轴必须能整除</translation>
    </message>
    <message>
        <source>the smoothness must be a number above 0</source>
        <translation>平滑度必须大于 0</translation>
    </message>
    <message>
        <source>a smoothness of {smoothness} cannot be computed for these positions; take a smaller one</source>
        <translation>对这些位置无法以平滑度 {smoothness} 计算；请取较小的值</translation>
    </message>
    <message>
        <source>a grid has one to three dimensions, with two points and a distance above 0 in each</source>
        <translation>网格有一至三个维度，每个维度至少两点且间距大于 0</translation>
    </message>
    <message>
        <source>points need one finite number for each dimension, for their value and for their weight</source>
        <translation>每个点的各维坐标、值和权都必须是有限的数字</translation>
    </message>
    <message>
        <source>the smoothness must be a number of 0 or more</source>
        <translation>平滑度必须不小于 0</translation>
    </message>
    <message>
        <source>{axis} {from} to {to}</source>
        <translation>{axis} {from} 至 {to}</translation>
    </message>
    <message>
        <source>with a smoothness of 0 every point of the grid needs a measured one beside it, and {count} have none; take a larger smoothness or a coarser grid</source>
        <translation>平滑度为 0 时，每个网格点旁都必须有测得点，而有 {count} 个没有；请取较大的平滑度或较粗的网格</translation>
    </message>
    <message>
        <source>no point lies within the grid; check its start and end, and the unit of the positions</source>
        <translation>没有点落在网格内；请检查网格的起点和末端，以及位置的单位</translation>
    </message>
    <message>
        <source>the points do not determine every point of the grid; take a larger smoothness or a coarser grid</source>
        <translation>这些点不足以确定所有网格点；请取较大的平滑度或较粗的网格</translation>
    </message>
    <message>
        <source>the points lie too unevenly for so little smoothness; take a larger smoothness or a coarser grid</source>
        <translation>对这样小的平滑度，点的分布过于不均匀；请取较大的平滑度或较粗的网格</translation>
    </message>
    <message>
        <source>the table that was active has other sources than the table that is made</source>
        <translation>当时启用的表与所生成的表的源不同</translation>
    </message>
    <message>
        <source>a table has one to three dimensions</source>
        <translation>表有一至三个维度</translation>
    </message>
    <message>
        <source>the tables that were active move their axes too much for their raw position to be found; check the unit of their values</source>
        <translation>当时启用的表使各轴移动过大，无法求出其原始位置；请检查值的单位</translation>
    </message>
    <message>
        <source>Column {column} of the file has positions in {unit}, but its source {source} is a temperature.</source>
        <translation>文件的列 {column} 是以 {unit} 为单位的位置，而其源 {source} 是温度。</translation>
    </message>
    <message>
        <source>Column {column} of the file is named as an axis, but its source {source} is a temperature.</source>
        <translation>文件的列 {column} 以轴命名，而其源 {source} 是温度。</translation>
    </message>
    <message>
        <source>Column {column} of the file has temperatures, but its source {source} is a position.</source>
        <translation>文件的列 {column} 是温度，而其源 {source} 是位置。</translation>
    </message>
    <message>
        <source>Column {column} of the file is not named as axis {axis}, whose position its source {source} is.</source>
        <translation>文件的列 {column} 不是以轴 {axis} 命名的，而其源 {source} 是该轴的位置。</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up; keep the table persistent, or reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>从闪存移除表也是一次闪存操作，而此驱动器的闪存操作记录已损坏，因此视为全部用完；请让该表保持持久，或用“axiscomp status --reset-flash-count”将计数复位</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for removing the table from flash, but not for putting everything back if it fails; wait {seconds} s, or keep the table persistent</source>
        <translation>剩余的闪存操作足以从闪存移除该表，但失败时不足以全部恢复；等待 {seconds} s，或让该表保持持久</translation>
    </message>
    <message>
        <source>removing a table from flash is a flash operation too, and there were too many of them in a short time; wait {seconds} s, or keep the table persistent</source>
        <translation>从闪存移除表也是一次闪存操作，而短时间内此类操作过多；等待 {seconds} s，或让该表保持持久</translation>
    </message>
    <message>
        <source>The table is removed from flash, which is a flash operation too. After a reboot the axis has no table.</source>
        <translation>该表将从闪存移除，这也是一次闪存操作。重启后该轴没有表。</translation>
    </message>
    <message>
        <source>&quot;{range}&quot; is not a range of addresses: {reason}</source>
        <translation>“{range}”不是地址范围：{reason}</translation>
    </message>
    <message>
        <source>write it as {network}, {range} or {address}, with {port} behind it for another port</source>
        <translation>写作 {network}、{range} 或 {address}；使用其他端口时在其后加 {port}</translation>
    </message>
    <message>
        <source>a port is a number from 1 to 65535</source>
        <translation>端口为 1 至 65535 的数字</translation>
    </message>
    <message>
        <source>its last address is before the first</source>
        <translation>末地址在首地址之前</translation>
    </message>
    <message>
        <source>it has {count} addresses, and a search asks {limit} at most: name a part of it</source>
        <translation>其中有 {count} 个地址，而一次搜索最多查询 {limit} 个：请指定其中一部分</translation>
    </message>
    <message>
        <source>these are no addresses of computers</source>
        <translation>这些不是计算机的地址</translation>
    </message>
    <message>
        <source>the wanted distance must be a number above 0</source>
        <translation>所要求的距离必须大于 0</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes more than {count} points; with these it is {found}; allow more points or a larger distance</source>
        <translation>要使与曲线的距离不超过 {distance}，需要多于 {count} 点；用这么多点时为 {found}；请允许更多的点或更大的距离</translation>
    </message>
    <message>
        <source>each point needs a finite position and deviation in two or three dimensions</source>
        <translation>每个点都需要两维或三维的有限位置和偏差</translation>
    </message>
    <message>
        <source>the points lie on a line, or on a plane in space, and cannot tell how the artefact lay; measure points beside it</source>
        <translation>这些点位于一条直线上，或在空间中位于一个平面上，无法看出标准器的放置状态；请在其旁测量一些点</translation>
    </message>
    <message>
        <source>targets and deviations must be finite numbers</source>
        <translation>目标位置和偏差必须是有限的数字</translation>
    </message>
    <message>
        <source>there are values at {count} targets; a table needs two</source>
        <translation>有 {count} 个目标位置有值；一个表需要两个</translation>
    </message>
    <message>
        <source>the target {target} has no value of one direction; measure it, leave the target out, or make the table of the other direction (--direction)</source>
        <translation>目标位置 {target} 缺少一个方向的值；请补测、不用该目标位置，或由另一方向生成表 (--direction)</translation>
    </message>
    <message>
        <source>known periods are fitted by the method smooth only (--method smooth)</source>
        <translation>已知周期只能用 smooth 方法拟合 (--method smooth)</translation>
    </message>
    <message>
        <source>harmonics need the length of a turn, which is that of a modulo axis</source>
        <translation>谐波需要一转的长度，即模数轴的一转</translation>
    </message>
    <message>
        <source>there is no such method</source>
        <translation>没有这种方法</translation>
    </message>
    <message>
        <source>a modulo axis has no slope that could be removed: it ends where it begins</source>
        <translation>模数轴没有可去除的斜率：其终点即起点</translation>
    </message>
    <message>
        <source>there are values at {count} targets; four are needed to leave one out</source>
        <translation>有 {count} 个目标位置有值；要留出一个，需要四个</translation>
    </message>
    <message>
        <source>a gain is above 0 and at most 2; it is usually 1</source>
        <translation>增益大于 0 且不超过 2；通常为 1</translation>
    </message>
    <message>
        <source>{name} has no table whose target is that of the column {column}; state the targets of its tables, or measure without a table</source>
        <translation>{name} 中没有目标轴与列 {column} 相同的表；请注明其各表的目标轴，或不用表测量</translation>
    </message>
    <message>
        <source>all points have the same position along {axis}</source>
        <translation>所有点沿 {axis} 的位置都相同</translation>
    </message>
    <message>
        <source>a grid has at least 2 points along {axis}</source>
        <translation>网格沿 {axis} 至少有 2 点</translation>
    </message>
    <message>
        <source>the distance along {axis} is too small</source>
        <translation>沿 {axis} 的间距太小</translation>
    </message>
    <message>
        <source>the grid needs one number, or one for each of the {count} axes</source>
        <translation>网格需要一个数字，或为 {count} 个轴各给一个</translation>
    </message>
    <message>
        <source>points are fitted on the grid itself, as the drive interpolates it; leave out --method and --period</source>
        <translation>点直接在网格上拟合，与驱动器的插值方式相同；请去掉 --method 和 --period</translation>
    </message>
    <message>
        <source>a track is fitted on the grid itself, or by --method smooth, which known periods (--period) need; leave other methods out</source>
        <translation>轨迹直接在网格上拟合，或用 --method smooth 拟合，已知周期 (--period) 需要后者；请去掉其他方法</translation>
    </message>
    <message>
        <source>--robust is for a fit on the grid itself; leave out --robust or --method smooth</source>
        <translation>--robust 用于直接在网格上的拟合；请去掉 --robust 或 --method smooth</translation>
    </message>
    <message>
        <source>the figures of the standard need targets; leave --tolerance out</source>
        <translation>标准规定的指标需要目标位置；请去掉 --tolerance</translation>
    </message>
    <message>
        <source>a home position is that of one axis measured over targets; take --zero first, mean, keep or a position</source>
        <translation>原点位置用于按目标位置测量的单个轴；请用 --zero first、mean、keep 或一个位置</translation>
    </message>
    <message>
        <source>--remove is for points of two or three axes; a track has one</source>
        <translation>--remove 用于两个或三个轴的点；轨迹只有一个轴</translation>
    </message>
    <message>
        <source>points have no direction; leave --direction out</source>
        <translation>点没有方向；请去掉 --direction</translation>
    </message>
    <message>
        <source>the zero needs {count} numbers, one for each axis</source>
        <translation>零点需要 {count} 个数字，每个轴一个</translation>
    </message>
    <message>
        <source>--remove names an axis that the points do not have</source>
        <translation>--remove 指定了这些点所没有的轴</translation>
    </message>
    <message>
        <source>the position of the zero is outside the grid</source>
        <translation>零点的位置在网格之外</translation>
    </message>
    <message>
        <source>there are no values in this direction</source>
        <translation>该方向上没有值</translation>
    </message>
    <message>
        <source>--remove, --robust and --fill are for points of two or three axes and for tracks; this measurement has targets along one axis</source>
        <translation>--remove、--robust 和 --fill 用于两个或三个轴的点以及轨迹；此测量是沿一个轴的目标位置</translation>
    </message>
    <message>
        <source>the measurement is along one axis: give one number for its grid and zero</source>
        <translation>此测量沿一个轴：其网格和零点只给一个数字</translation>
    </message>
    <message>
        <source>a smoothness is for the method smooth (--method smooth); the others go through every mean</source>
        <translation>平滑度用于 smooth 方法 (--method smooth)；其他方法通过每个平均值</translation>
    </message>
    <message>
        <source>the position {position} of the zero is outside the targets, which go from {from} to {to}</source>
        <translation>零点的位置 {position} 在目标位置 {from} 至 {to} 之外</translation>
    </message>
    <message>
        <source>a program for {dialect} cannot move an axis &quot;{axis}&quot;; name one of X, Y, Z, A, B, C, U, V, W (--axis)</source>
        <translation>{dialect} 的程序无法移动轴“{axis}”；请指定 X、Y、Z、A、B、C、U、V、W 之一 (--axis)</translation>
    </message>
    <message>
        <source>a target must lie within {limit} of zero</source>
        <translation>目标位置距零不得超过 {limit}</translation>
    </message>
    <message>
        <source>{position} has more than the three decimals that a program prints; choose an end with fewer</source>
        <translation>{position} 的小数超过程序可输出的三位；请选择小数位较少的端点</translation>
    </message>
    <message>
        <source>the last target ({to}) must be above the first ({from}); exchange the two, or choose other ends</source>
        <translation>末目标位置 ({to}) 必须大于首目标位置 ({from})；请将两者对调，或选择其他端点</translation>
    </message>
    <message>
        <source>a period is above 0; leave it out if none is known</source>
        <translation>周期大于 0；如果未知则不给出</translation>
    </message>
    <message>
        <source>the overrun must be above 0: without it the first target of a run would not be approached in the direction of the run</source>
        <translation>越程必须大于 0：否则一趟的首目标位置不会按该趟的方向趋近</translation>
    </message>
    <message>
        <source>the overrun has more than three decimals; round it</source>
        <translation>越程的小数超过三位；请舍入</translation>
    </message>
    <message>
        <source>the feed must be above 0 and at most {most}</source>
        <translation>进给速度必须大于 0 且不超过 {most}</translation>
    </message>
    <message>
        <source>the dwell must be above 0 s and at most {most}: the axis stands still while it is measured</source>
        <translation>停留时间必须大于 0 s 且不超过 {most}：测量时轴静止</translation>
    </message>
    <message>
        <source>at least one cycle is needed</source>
        <translation>至少需要一个循环</translation>
    </message>
    <message>
        <source>give the number of targets or their spacing, one of the two</source>
        <translation>给出目标位置数或其间距，二者取一</translation>
    </message>
    <message>
        <source>the spacing must be above 0 and at most the distance of the ends, {range}</source>
        <translation>间距必须大于 0 且不超过两端的距离 {range}</translation>
    </message>
    <message>
        <source>a plan has 2 to {most} targets, not {count}</source>
        <translation>测量计划有 2 至 {most} 个目标位置，不能是 {count} 个</translation>
    </message>
    <message>
        <source>{count} targets would be closer than {least}, which three decimals cannot keep uneven; choose fewer</source>
        <translation>{count} 个目标位置的间距将小于 {least}，三位小数无法保持其不等距；请减少个数</translation>
    </message>
    <message>
        <source>the plan would have more than {most} steps; choose fewer targets or cycles</source>
        <translation>测量计划将超过 {most} 步；请减少目标位置或循环</translation>
    </message>
    <message>
        <source>there is no step in it</source>
        <translation>其中没有任何步</translation>
    </message>
    <message>
        <source>a plan as axiscomp targets writes it</source>
        <translation>由 axiscomp targets 写出的测量计划</translation>
    </message>
    <message>
        <source>{found}; expected: {expected}</source>
        <translation>{found}；应为：{expected}</translation>
    </message>
    <message>
        <source>line {line}: {found}; expected: {expected}</source>
        <translation>第 {line} 行：{found}；应为：{expected}</translation>
    </message>
    <message>
        <source>version 1; a newer version of this program may have written it</source>
        <translation>版本 1；它可能由本程序的更新版本写成</translation>
    </message>
    <message>
        <source>a number above 0 with its unit</source>
        <translation>大于 0 的数字及其单位</translation>
    </message>
    <message>
        <source>the header {header}</source>
        <translation>标题行 {header}</translation>
    </message>
    <message>
        <source>five cells, as the header has</source>
        <translation>五个单元格，与标题行一致</translation>
    </message>
    <message>
        <source>at most {count} steps</source>
        <translation>最多 {count} 步</translation>
    </message>
    <message>
        <source>step {step}</source>
        <translation>第 {step} 步</translation>
    </message>
    <message>
        <source>the number of a run, from 1</source>
        <translation>趟次编号，从 1 起</translation>
    </message>
    <message>
        <source>the direction + or -</source>
        <translation>方向 + 或 -</translation>
    </message>
    <message>
        <source>a position below the target, since the axis moves up</source>
        <translation>小于目标位置的位置，因为轴正向运动</translation>
    </message>
    <message>
        <source>a position above the target, since the axis moves down</source>
        <translation>大于目标位置的位置，因为轴负向运动</translation>
    </message>
    <message>
        <source>each target once in a run; it has this one already</source>
        <translation>每个目标位置在一趟中一次；此趟中已有该目标位置</translation>
    </message>
    <message>
        <source>the plan is for axis {axis}; the machine has: {known}</source>
        <translation>该测量计划用于轴 {axis}；机床有：{known}</translation>
    </message>
    <message>
        <source>the plan and axis {axis} of the machine differ: one is in mm, the other in deg</source>
        <translation>测量计划与机床的轴 {axis} 不一致：一个以 mm 为单位，另一个以 deg 为单位</translation>
    </message>
    <message>
        <source>the plan needs a feed and a dwell above 0: lines such as // feed: 1000 mm/min and // dwell: 5 s</source>
        <translation>测量计划需要大于 0 的进给速度和停留时间：例如 // feed: 1000 mm/min 和 // dwell: 5 s 这样的行</translation>
    </message>
    <message>
        <source>step {step} of the plan goes to {place}, more than a tenth beyond the travel of axis {axis}, {low} to {high}</source>
        <translation>测量计划的第 {step} 步移到 {place}，超出轴 {axis} 的行程 {low} 至 {high} 十分之一以上</translation>
    </message>
    <message>
        <source>a program needs a machine that plays it (--machine)</source>
        <translation>程序需要执行它的机床 (--machine)</translation>
    </message>
    <message>
        <source>a machine has at least one axis</source>
        <translation>机床至少有一个轴</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; is &quot;{nearest}&quot; meant?</source>
        <translation>此处无法识别“{name}”；是否指“{nearest}”？</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is not known here; there is: {known}</source>
        <translation>此处无法识别“{name}”；现有：{known}</translation>
    </message>
    <message>
        <source>a number from {least} to {most} is expected, not {found}</source>
        <translation>应为 {least} 至 {most} 的数字，实为 {found}</translation>
    </message>
    <message>
        <source>a number above 0, at most {most}, is expected, not {found}</source>
        <translation>应为大于 0 且不超过 {most} 的数字，实为 {found}</translation>
    </message>
    <message>
        <source>there are more than {most} waves</source>
        <translation>波形超过 {most} 个</translation>
    </message>
    <message>
        <source>the travel has more than {most} knots at this distance</source>
        <translation>按此间距，行程上的节点超过 {most} 个</translation>
    </message>
    <message>
        <source>two numbers are expected: the ends of the travel</source>
        <translation>应为两个数字：行程的两端</translation>
    </message>
    <message>
        <source>the first end must be below the second</source>
        <translation>第一个端点必须小于第二个</translation>
    </message>
    <message>
        <source>mm or deg is expected</source>
        <translation>应为 mm 或 deg</translation>
    </message>
    <message>
        <source>an object with 1 to {most} axes is expected</source>
        <translation>应为含 1 至 {most} 个轴的对象</translation>
    </message>
    <message>
        <source>the name of an axis has 1 to {most} characters</source>
        <translation>轴名有 1 至 {most} 个字符</translation>
    </message>
    <message>
        <source>there is no axis &quot;{name}&quot;; there is: {known}</source>
        <translation>没有轴“{name}”；现有：{known}</translation>
    </message>
    <message>
        <source>an axis&apos;s own terms stand with the axis; here are those of others</source>
        <translation>轴自身的误差项写在该轴下；此处为其他轴的误差项</translation>
    </message>
    <message>
        <source>one of these units is expected: {known}</source>
        <translation>应为以下单位之一：{known}</translation>
    </message>
    <message>
        <source>1 or -1 is expected</source>
        <translation>应为 1 或 -1</translation>
    </message>
    <message>
        <source>there are more than {most} gross errors</source>
        <translation>粗大误差超过 {most} 个</translation>
    </message>
    <message>
        <source>{file} is not a valid record: {reason}</source>
        <translation>{file} 不是有效的档案：{reason}</translation>
    </message>
    <message>
        <source>a distance of {distance} from the curve takes at least {sizes} points, more than allowed; allow more points or a larger distance</source>
        <translation>要使与曲线的距离不超过 {distance}，至少需要 {sizes} 点，超过允许值；请允许更多的点或更大的距离</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}, which at {speed} is a step of the velocity of {step}</source>
        <translation>沿 {axis}，{points} 点：与曲线最多相距 {distance}；在一点处斜率最多变化 {slope}，在 {speed} 时速度跳变 {step}</translation>
    </message>
    <message>
        <source>along {axis}, {points} points: at most {distance} from the curve; at a point its slope changes by up to {slope}</source>
        <translation>沿 {axis}，{points} 点：与曲线最多相距 {distance}；在一点处斜率最多变化 {slope}</translation>
    </message>
    <message>
        <source>smoothing needs at least {fewest} positions along {axis}, which has {count}; take the method spline or cubic</source>
        <translation>平滑至少需要沿 {axis} 的 {fewest} 个位置，现有 {count} 个；请用 spline 或 cubic 方法</translation>
    </message>
    <message>
        <source>a SHA-256 of 64 hexadecimal digits is expected</source>
        <translation>应为 64 位十六进制的 SHA-256</translation>
    </message>
    <message>
        <source>at least one file is expected</source>
        <translation>至少应有一个文件</translation>
    </message>
    <message>
        <source>what is left out is expected, such as down:1:1, run:up:3 or target:7</source>
        <translation>应为要排除的内容，例如 down:1:1、run:up:3 或 target:7</translation>
    </message>
    <message>
        <source>the record has version {found}, and this program reads version {known} at most; open it with a newer version of the program</source>
        <translation>该档案的版本为 {found}，本程序最多可读版本 {known}；请用本程序的更新版本打开</translation>
    </message>
    <message>
        <source>the second measurement was made with the compensation off; activate the table {crc} and measure again</source>
        <translation>第二次测量是在补偿关闭时进行的；请启用表 {crc} 并重新测量</translation>
    </message>
    <message>
        <source>the second measurement was made with the table {found} active, and the record has the table {crc}; activate that one and measure again, or take the record of {found}</source>
        <translation>第二次测量时启用的是表 {found}，而档案中为表 {crc}；请启用后者并重新测量，或采用 {found} 的档案</translation>
    </message>
    <message>
        <source>the second measurement does not say which table was active while it was made; if it was the table {crc}, say it with --measured-with on</source>
        <translation>第二次测量没有注明测量时启用了哪个表；如果是表 {crc}，请用 --measured-with on 注明</translation>
    </message>
    <message>
        <source>only measurements of runs over targets are compared</source>
        <translation>只能比较按目标位置的逐趟测量</translation>
    </message>
    <message>
        <source>one measurement is of lengths and the other of angles; they are not of the same axis</source>
        <translation>一次测量为长度，另一次为角度；它们不属于同一轴</translation>
    </message>
    <message>
        <source>this is no figure of ISO 230-2, such as A or EUp</source>
        <translation>这不是 GB/T 17421.2 的指标，例如 A 或 EUp</translation>
    </message>
    <message>
        <source>a distance above 0 is expected</source>
        <translation>应为大于 0 的间距</translation>
    </message>
    <message>
        <source>numbers of the table&apos;s points are expected, ascending from 0</source>
        <translation>应为表的点的编号，从 0 起递增</translation>
    </message>
    <message>
        <source>a table has 1 to 3 axes</source>
        <translation>表有 1 至 3 个轴</translation>
    </message>
    <message>
        <source>{count} values are here, and the grid has {expected} points</source>
        <translation>此处有 {count} 个值，而网格有 {expected} 点</translation>
    </message>
    <message>
        <source>this list has {count} elements, and the others have {expected}</source>
        <translation>此列表有 {count} 个元素，而其他列表有 {expected} 个</translation>
    </message>
    <message>
        <source>the values have the CRC-32 {found}: they were changed, or the file is damaged</source>
        <translation>这些值的 CRC-32 为 {found}：它们被改动过，或文件已损坏</translation>
    </message>
    <message>
        <source>whole numbers from {least} to {most} are expected, not {found}</source>
        <translation>应为 {least} 至 {most} 的整数，实为 {found}</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is neither up nor down</source>
        <translation>“{found}”既不是 up 也不是 down</translation>
    </message>
    <message>
        <source>there are values without targets</source>
        <translation>有些值没有目标位置</translation>
    </message>
    <message>
        <source>{count} lists are here, and there are {expected} names</source>
        <translation>此处有 {count} 个列表，而名称有 {expected} 个</translation>
    </message>
    <message>
        <source>points have 2 or 3 axes</source>
        <translation>点有 2 或 3 个轴</translation>
    </message>
    <message>
        <source>targets are expected to ascend</source>
        <translation>目标位置应递增</translation>
    </message>
    <message>
        <source>&quot;{found}&quot; is none of: {known}</source>
        <translation>“{found}”不属于：{known}</translation>
    </message>
    <message>
        <source>the compensation changed in mid-measurement, from {before} to {now}; what was taken belongs to {before}: begin a new file</source>
        <translation>测量中途补偿已改变，由“{before}”变为“{now}”；已采集的值属于“{before}”：请另起一个新文件</translation>
    </message>
    <message>
        <source>the axis stands at {position}; step {step} at {target} is due</source>
        <translation>轴停在 {position}；待测的是第 {step} 步，位置 {target}</translation>
    </message>
    <message>
        <source>{problem}; this is the target of step {other}: move the axis back</source>
        <translation>{problem}；这是第 {other} 步的目标位置：请将轴移回</translation>
    </message>
    <message>
        <source>how the axis came to step {step} is not known, as nothing could be read for {time}; go to {approach} and come back</source>
        <translation>由于有 {time} 无法读取，不知道轴是如何到达第 {step} 步的；请移到 {approach} 再返回</translation>
    </message>
    <message>
        <source>the axis came only {way} in the direction of step {step}, less than the overrun of {overrun}; go to {approach} and come back</source>
        <translation>轴沿第 {step} 步的方向只移动了 {way}，小于越程 {overrun}；请移到 {approach} 再返回</translation>
    </message>
    <message>
        <source>step {step} is approached upwards, and the axis did not come from below; go to {approach} and come back</source>
        <translation>第 {step} 步应正向趋近，而轴不是从负侧移来；请移到 {approach} 再返回</translation>
    </message>
    <message>
        <source>step {step} is approached downwards, and the axis did not come from above; go to {approach} and come back</source>
        <translation>第 {step} 步应负向趋近，而轴不是从正侧移来；请移到 {approach} 再返回</translation>
    </message>
    <message>
        <source>the instrument gives no position</source>
        <translation>仪器没有给出位置</translation>
    </message>
    <message>
        <source>the readings of the instrument differ by {spread}, more than the window of {window}; they are taken again</source>
        <translation>仪器各次读数相差 {spread}，大于窗口 {window}；将重新读取</translation>
    </message>
    <message>
        <source>it is not an ordinary file</source>
        <translation>这不是普通文件</translation>
    </message>
    <message>
        <source>another program is writing measured values to it</source>
        <translation>另一程序正在向其中写入测得值</translation>
    </message>
    <message>
        <source>it holds something else than captured values; name a new file</source>
        <translation>其内容不是采集的值；请指定新文件</translation>
    </message>
    <message>
        <source>line {line} has {found} where {expected} is expected; name a new file</source>
        <translation>第 {line} 行为 {found}，应为 {expected}；请指定新文件</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>结尾</translation>
    </message>
    <message>
        <source>step {step} of the plan, {begin}...</source>
        <translation>测量计划的第 {step} 步，{begin}...</translation>
    </message>
    <message>
        <source>there is no font to draw a PDF with: install one, such as fonts-dejavu-core, or write the report as HTML</source>
        <translation>没有可用于生成 PDF 的字体：请安装一种，例如 fonts-dejavu-core，或将报告写成 HTML</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid machine file: {count} problems</source>
        <comment>{file} is not a valid machine file: one problem</comment>
        <translation>
            <numerusform>{file} 不是有效的机床文件：{count} 个问题</numerusform>
        </translation>
    </message>
    <message>
        <source>the old state</source>
        <translation>旧状态</translation>
    </message>
    <message>
        <source>what it is writing at this moment</source>
        <translation>此刻正在写入的内容</translation>
    </message>
    <message>
        <source>values of the tolerance</source>
        <translation>公差的值</translation>
    </message>
    <message>
        <source>{file} has several tables; name one of them with column: {known}</source>
        <translation>{file} 有多个表；请用 column 指定其一：{known}</translation>
    </message>
    <message>
        <source>axis {index} of {drive} (serial number {serial})</source>
        <translation>{drive} 的轴 {index}（序列号 {serial}）</translation>
    </message>
    <message>
        <source>axis {index} ({name}) of {drive} (serial number {serial})</source>
        <translation>{drive} 的轴 {index}（{name}）（序列号 {serial}）</translation>
    </message>
    <message>
        <source>the record is of {recorded}, and this is {found}; begin a record for each axis</source>
        <translation>该档案属于 {recorded}，而此处为 {found}；每个轴请另建一个档案</translation>
    </message>
    <message>
        <source>the record does not say that its table was written: `axiscomp write --record` writes it and notes that</source>
        <translation>档案没有注明其表已写入：`axiscomp write --record` 可写入并记录</translation>
    </message>
    <message>
        <source>the axis has the table {found}, and that of the record is {recorded}: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>该轴的表为 {found}，而档案的表为 {recorded}：请重新写入档案的表（`axiscomp write --record`），或不用该档案</translation>
    </message>
    <message>
        <source>the register {path} is of type {type}, which is no position</source>
        <translation>寄存器 {path} 的类型为 {type}，不是位置</translation>
    </message>
    <message>
        <source>{path} follows the encoder of the axis itself: name the register of an instrument</source>
        <translation>{path} 跟随该轴自身的编码器：请指定仪器的寄存器</translation>
    </message>
    <message>
        <source>since the value before, the axis has moved by {way}, and the instrument says {measured}</source>
        <translation>自上一个值以来，轴移动了 {way}，而仪器显示 {measured}</translation>
    </message>
    <message>
        <source>the instrument says nothing: look whether it sends, and whether its lines end</source>
        <translation>仪器没有数据：请检查它是否在发送，其各行是否有行结束符</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder, and until now it was {seen} at most: type it once more if it is right, or another number</source>
        <translation>{position} 与编码器相差 {difference}，而此前最多相差 {seen}：如果无误请再输入一次，否则输入另一个数字</translation>
    </message>
    <message>
        <source>{position} is {difference} from the encoder: type it once more if it is right, or another number</source>
        <translation>{position} 与编码器相差 {difference}：如果无误请再输入一次，否则输入另一个数字</translation>
    </message>
    <message>
        <source>the position of the instrument is asked for</source>
        <translation>等待输入仪器的位置</translation>
    </message>
    <message>
        <source>it is one of the files of this measurement; choose another name</source>
        <translation>它是此测量的文件之一；请选择其他名称</translation>
    </message>
    <message>
        <source>the axis would move from {lowest} to {highest}, and its travel is {low} to {high}: choose other ends, or a smaller overrun</source>
        <translation>轴将从 {lowest} 移到 {highest}，而其行程为 {low} 至 {high}：请选择其他端点，或较小的越程</translation>
    </message>
    <message>
        <source>the plan is for axis {planned}, and this is axis {axis}: choose the other axis, or make a plan for this one</source>
        <translation>测量计划用于轴 {planned}，而这是轴 {axis}：请选择另一个轴，或为此轴制定计划</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is neither on nor off (the drive says {state}): activate or deactivate it first</source>
        <translation>轴 {axis} 的补偿既未开启也未关闭（驱动器报告 {state}）：请先启用或停用</translation>
    </message>
    <message>
        <source>the compensation of axis {axis} is on, and the drive does not say with which table: deactivate it first</source>
        <translation>轴 {axis} 的补偿已开启，而驱动器没有说明使用哪个表：请先停用</translation>
    </message>
    <message>
        <source>the instrument is in {unit}, which cannot be converted to {planned}, the unit of the plan: state the unit of the instrument</source>
        <translation>仪器以 {unit} 为单位，无法换算成测量计划的单位 {planned}：请给出仪器的单位</translation>
    </message>
    <message>
        <source>no position is asked for at the moment: wait until the axis stands at its target</source>
        <translation>目前不需要输入位置：请等到轴停在目标位置</translation>
    </message>
    <message>
        <source>{found}: it counts the other way; begin a new file with the reference inverted</source>
        <translation>{found}：计数方向相反；请将基准取反，另起一个新文件</translation>
    </message>
    <message>
        <source>{found}: its unit or factor is another one, or its zero was set anew, or its beam was interrupted; put that right, or begin a new file with the right unit</source>
        <translation>{found}：其单位或系数不同，或零点被重新设置，或光束曾中断；请予以纠正，或以正确的单位另起一个新文件</translation>
    </message>
    <message>
        <source>the instrument says {line}, where a number is expected; a pattern says where it is</source>
        <translation>仪器给出 {line}，而此处应为数字；请用匹配模式指明数字的位置</translation>
    </message>
    <message>
        <source>the instrument says {line}: its number has a comma; set it to a decimal point, or say what the number is with a pattern</source>
        <translation>仪器给出 {line}：其数字带有逗号；请将仪器设为小数点，或用匹配模式指明数字</translation>
    </message>
    <message>
        <source>the instrument says {line} without a unit: state the unit, such as mm</source>
        <translation>仪器给出 {line}，没有单位：请给出单位，例如 mm</translation>
    </message>
    <message>
        <source>the instrument says {line}, in another unit than {unit}: set the instrument, or begin a new file with the right unit</source>
        <translation>仪器给出 {line}，其单位不是 {unit}：请调整仪器，或以正确的单位另起一个新文件</translation>
    </message>
    <message>
        <source>the drive profile does not say which register is the encoder of the axis: name it</source>
        <translation>驱动器描述文件没有说明哪个寄存器是该轴的编码器：请指定</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position before the compensation, which is --lookup-at encoder</source>
        <translation>该轴在 {source} 处查表，即补偿前的位置，对应 --lookup-at encoder</translation>
    </message>
    <message>
        <source>the axis looks its table up at {source}, a position after the compensation, which is --lookup-at set</source>
        <translation>该轴在 {source} 处查表，即补偿后的位置，对应 --lookup-at set</translation>
    </message>
    <message>
        <source>there are values at {count} points of the grid&apos;s range; {fewest} are needed to choose the smoothness, so give it (--smoothness)</source>
        <translation>网格范围内有 {count} 点有值；选择平滑度需要 {fewest} 点，请直接给出平滑度 (--smoothness)</translation>
    </message>
    <message>
        <source>the measurement does not say whether a compensation was active while it was made: say that it was off, that it was on, or which table was active (--measured-with off, --measured-with on, or --measured-with and the file of the table)</source>
        <translation>该测量没有注明测量时补偿是否启用：请注明是关闭、开启，还是启用了哪个表（--measured-with off、--measured-with on，或 --measured-with 加该表的文件）</translation>
    </message>
    <message>
        <source>the measurement says that it was made with {recorded}, not with {stated}; say nothing else (--measured-with), or take the table that was active</source>
        <translation>该测量注明的是“{recorded}”，而不是“{stated}”；请勿另作说明 (--measured-with)，或采用当时启用的表</translation>
    </message>
    <message>
        <source>these are residuals of the table {crc}, which was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>这些是测量时启用的表 {crc} 的残差：请将其合并到该表，取自其文件或驱动器（--onto 加文件，或 --onto drive）</translation>
    </message>
    <message>
        <source>these are residuals of a table that was active while they were measured: merge them onto that table, from its file or from the drive (--onto and the file, or --onto drive)</source>
        <translation>这些是测量时启用的表的残差：请将其合并到该表，取自其文件或驱动器（--onto 加文件，或 --onto drive）</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, which is not {name} ({known}), nor any other table known; give its file (--measured-with), or merge onto it</source>
        <translation>测量时启用的是表 {crc}，既不是 {name}（{known}），也不是其他已知的表；请给出其文件 (--measured-with)，或合并到该表</translation>
    </message>
    <message>
        <source>it was measured with the compensation off: the values are the whole error, and must not be added to {name}; merge them onto nothing (leave out --onto), or measure with that table active</source>
        <translation>测量时补偿关闭：这些值是全部误差，不得加到 {name} 上；请不合并（去掉 --onto），或在启用该表时测量</translation>
    </message>
    <message>
        <source>at which position the drive looks the table up decides where its values belong: choose the encoder, for a position before the compensation, or the set position, for one after it (--lookup-at encoder or --lookup-at set)</source>
        <translation>驱动器在哪个位置查表，决定了这些值的归属：请选择编码器（补偿前的位置）或给定位置（补偿后的位置）（--lookup-at encoder 或 --lookup-at set）</translation>
    </message>
    <message>
        <source>how the artefact lay is found from the deviations along all of its axes, but there is no column for {axis}, such as d{axis}; take out nothing (--remove)</source>
        <translation>标准器的放置状态由其所有轴向的偏差求得，而 {axis} 没有对应的列，例如 d{axis}；请不要去除任何内容 (--remove)</translation>
    </message>
    <message>
        <source>the positions along {axis} are no even grid; say the grid of the table: its points, or their distance (--points or --distance)</source>
        <translation>沿 {axis} 的位置不是均匀网格；请给出表的网格：点数或间距（--points 或 --distance）</translation>
    </message>
    <message>
        <source>a table over temperature is made of runs with targets along one axis</source>
        <translation>随温度变化的表由沿一个轴按目标位置的逐趟测量生成</translation>
    </message>
    <message>
        <source>the home position of the axis is not known: give it (--home), or the position of the zero (--zero)</source>
        <translation>该轴的原点位置未知：请给出原点位置 (--home)，或零点的位置 (--zero)</translation>
    </message>
    <message>
        <source>the home position {home} is outside the targets, so that the error there is not known; take the first target for the zero or another position (--zero)</source>
        <translation>原点位置 {home} 在目标位置之外，该处的误差未知；请取首目标位置或其他位置作为零点 (--zero)</translation>
    </message>
    <message>
        <source>the targets are not evenly spaced; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>目标位置间距不均匀；请给出表的网格：点数、间距，或与曲线的允许偏差（--points、--distance 或 --within）</translation>
    </message>
    <message>
        <source>the thermal states span {span}, less than five times the {scatter} by which the temperature varies within them: let the machine settle before each run</source>
        <translation>各热状态跨度为 {span}，小于状态内温度波动 {scatter} 的五倍：请在每一趟前让机床稳定</translation>
    </message>
    <message>
        <source>at {temperature} it was measured from {from} to {to}, at {other} from {otherFrom} to {otherTo}: measure the same range in each thermal state</source>
        <translation>在 {temperature} 时测量了 {from} 至 {to}，在 {other} 时测量了 {otherFrom} 至 {otherTo}：请在每个热状态下测量相同的范围</translation>
    </message>
    <message numerus="yes">
        <source>{count} values have no temperature; a table over temperature needs that of each (the column temperature)</source>
        <comment>1 value has no temperature; a table over temperature needs that of each (the column temperature)</comment>
        <translation>
            <numerusform>有 {count} 个值没有温度；随温度变化的表需要每个值的温度（temperature 列）</numerusform>
        </translation>
    </message>
    <message>
        <source>residuals are not merged over temperature: measure with the compensation off</source>
        <translation>残差不能随温度合并：请在补偿关闭时测量</translation>
    </message>
    <message>
        <source>a table over temperature has two dimensions: give at most two numbers for its grid</source>
        <translation>随温度变化的表有两个维度：其网格最多给出两个数字</translation>
    </message>
    <message>
        <source>the targets differ from one thermal state to the other, so that they give no grid together; say the grid of the table with --points or --distance</source>
        <translation>各热状态的目标位置不同，不能共同构成网格；请用 --points 或 --distance 给出表的网格</translation>
    </message>
    <message>
        <source>the grid has {count} points, and a table holds {most}; take fewer</source>
        <translation>网格有 {count} 点，而一个表可容纳 {most} 点；请减少点数</translation>
    </message>
    <message>
        <source>name the axis as the drive or the control names it, such as X</source>
        <translation>请按驱动器或数控系统中的名称给出轴，例如 X</translation>
    </message>
    <message>
        <source>the pattern {pattern} is no regular expression: {problem} at character {place}</source>
        <translation>匹配模式 {pattern} 不是正则表达式：{problem}，在第 {place} 个字符处</translation>
    </message>
    <message>
        <source>the request {text}: behind a backslash r, n, t or another backslash is expected</source>
        <translation>请求 {text}：反斜杠之后应为 r、n、t 或另一个反斜杠</translation>
    </message>
    <message>
        <source>the connection was removed</source>
        <translation>连接已移除</translation>
    </message>
    <message>
        <source>its name is one of a program for a control, and a plan in it would mislead the control; choose a name that ends in .csv</source>
        <translation>其名称是数控系统程序的名称，写入测量计划会误导数控系统；请选择以 .csv 结尾的名称</translation>
    </message>
    <message>
        <source>choose the file of the table that was active</source>
        <translation>选择当时启用的表的文件</translation>
    </message>
    <message>
        <source>its content cannot be used</source>
        <translation>其内容无法使用</translation>
    </message>
    <message>
        <source>{file} cannot be used as the table: {reason}</source>
        <translation>{file} 不能用作该表：{reason}</translation>
    </message>
    <message>
        <source>there is no axis whose table the residuals could be merged onto; choose one, or take the file of the table</source>
        <translation>没有可将残差合并到其表的轴；请选择一个轴，或采用该表的文件</translation>
    </message>
    <message>
        <source>the table of the axis is still being read from the drive</source>
        <translation>仍在从驱动器读取该轴的表</translation>
    </message>
    <message>
        <source>a report is PDF or HTML; choose a name that ends in .pdf or .html</source>
        <translation>报告为 PDF 或 HTML；请选择以 .pdf 或 .html 结尾的名称</translation>
    </message>
    <message>
        <source>all runs were measured in one thermal state; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>各趟都在同一热状态下测得；随温度变化的表至少需要两个相隔 {least} 的热状态（相差在 {gap} 以内的各趟为同一状态）</translation>
    </message>
    <message>
        <source>the runs were measured in {count} thermal states that span {span}; a table over temperature needs at least two, {least} apart (runs within {gap} are one state)</source>
        <translation>各趟在 {count} 个热状态下测得，跨度为 {span}；随温度变化的表至少需要两个相隔 {least} 的热状态（相差在 {gap} 以内的各趟为同一状态）</translation>
    </message>
    <message>
        <source>a table for each direction is made of runs over targets; make those of a track one after the other (--direction positive, then --direction negative)</source>
        <translation>每个方向一个表须由按目标位置的逐趟测量生成；轨迹的表请逐个生成（先 --direction positive，再 --direction negative）</translation>
    </message>
    <message>
        <source>{name} has one value for both directions, and so has what is merged onto it: make the table of the mean (--direction mean)</source>
        <translation>{name} 对两个方向只有一个值，合并到其上的也是如此：请由平均值生成表 (--direction mean)</translation>
    </message>
    <message>
        <source>a table over position and temperature is for a drive, which has one value for both directions (--direction mean)</source>
        <translation>随位置和温度变化的表用于驱动器，而驱动器对两个方向只有一个值 (--direction mean)</translation>
    </message>
    <message>
        <source>--remove-slope, --turn, --home and --remove-drift are for runs over targets along one axis</source>
        <translation>--remove-slope、--turn、--home 和 --remove-drift 用于沿一个轴按目标位置的逐趟测量</translation>
    </message>
    <message>
        <source>the fewest points that leave no more than a deviation (--within) are counted on a curve, which runs have, and a track with --method smooth; say the points of the grid or their distance (--points or --distance)</source>
        <translation>偏差不超过给定值 (--within) 的最少点数是在曲线上计算的，逐趟测量和用 --method smooth 的轨迹才有曲线；请给出网格的点数或间距（--points 或 --distance）</translation>
    </message>
    <message>
        <source>the name on the drive is {name}</source>
        <translation>驱动器上的名称为 {name}</translation>
    </message>
    <message>
        <source>the first measurement is of axis {before} and the second of axis {after}; they are not of the same axis</source>
        <translation>第一次测量为轴 {before}，第二次为轴 {after}；它们不属于同一轴</translation>
    </message>
    <message>
        <source>measurements of axis {axis} and of axis {other} cannot be joined</source>
        <translation>轴 {axis} 的测量和轴 {other} 的测量不能合并</translation>
    </message>
    <message>
        <source>the position of the zero is missing</source>
        <translation>缺少零点的位置</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, lookup: encoder or lookup: set, says for which side of the compensation the table was made: correct that line, or leave it out</source>
        <translation>文件中为“{note}”，而此处应有一行注释 lookup: encoder 或 lookup: set，说明该表是为补偿的哪一侧生成的：请更正该行，或将其删去</translation>
    </message>
    <message>
        <source>these drives make no machine: {problem}</source>
        <translation>这些驱动器不能构成机床：{problem}</translation>
    </message>
    <message>
        <source>the connection was ended</source>
        <translation>连接已结束</translation>
    </message>
    <message>
        <source>number of the axis, from 0</source>
        <translation>轴号，从 0 起</translation>
    </message>
    <message>
        <source>number of the zone of the error map, from 0</source>
        <translation>误差映射表的区号，从 0 起</translation>
    </message>
    <message>
        <source>how the array is mapped: ERRORMAP1D, or CONNECT with MAP</source>
        <translation>数组的映射方式：ERRORMAP1D，或 CONNECT 加 MAP</translation>
    </message>
    <message>
        <source>ERRORMAP1D axis, zone, base, step, array</source>
        <translation>ERRORMAP1D 轴, 区, 起点, 步距, 数组</translation>
    </message>
    <message>
        <source>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), array, base, step)</source>
        <translation>CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), 数组, 起点, 步距)</translation>
    </message>
    <message>
        <source>a step of {step}</source>
        <translation>步距 {step}</translation>
    </message>
    <message>
        <source>a step above 0</source>
        <translation>大于 0 的步距</translation>
    </message>
    <message>
        <source>another map of axis {axis}, besides that of line {line}</source>
        <translation>轴 {axis} 除第 {line} 行的映射表外还有另一个</translation>
    </message>
    <message>
        <source>one map of an axis; both are read, and the program decides which one counts</source>
        <translation>每个轴一个映射表；两者都会读取，由程序决定以哪个为准</translation>
    </message>
    <message>
        <source>no ERRORMAPON {axis}, {zone}</source>
        <translation>没有 ERRORMAPON {axis}, {zone}</translation>
    </message>
    <message>
        <source>a statement that switches the map on, which may stand in another program</source>
        <translation>启用映射表的语句，可以在另一个程序中</translation>
    </message>
    <message>
        <source>a map over two axes (MAP2)</source>
        <translation>随两个轴变化的映射表 (MAP2)</translation>
    </message>
    <message>
        <source>the format {format} to read it</source>
        <translation>用格式 {format} 读取</translation>
    </message>
    <message>
        <source>a statement ERRORMAP1D, or CONNECT with MAP, of which there is none</source>
        <translation>ERRORMAP1D 语句，或 CONNECT 加 MAP 的语句，但一个也没有</translation>
    </message>
    <message>
        <source>the axis must be referenced; the connection replaces an error map of the axis</source>
        <translation>轴必须已回原点；该 CONNECT 取代轴的误差映射表</translation>
    </message>
    <message>
        <source>the axis must be referenced, and a map that is on switched off with ERRORMAPOFF before; ERRORUNMAP {axis}, {zone} removes the map</source>
        <translation>轴必须已回原点，且已启用的映射表要先用 ERRORMAPOFF 关闭；ERRORUNMAP {axis}, {zone} 移除映射表</translation>
    </message>
    <message>
        <source>program with the error map of an axis (ERRORMAP1D, or CONNECT with MAP)</source>
        <translation>含一个轴的误差映射表的程序（ERRORMAP1D，或 CONNECT 加 MAP）</translation>
    </message>
    <message>
        <source>number of the axis of the first source of the table, from 0</source>
        <translation>表的第一个源的轴号，从 0 起</translation>
    </message>
    <message>
        <source>number of the axis of the second source of the table, from 0</source>
        <translation>表的第二个源的轴号，从 0 起</translation>
    </message>
    <message>
        <source>number of the axis that is compensated, from 0; needed where it is none of the sources</source>
        <translation>被补偿轴的轴号，从 0 起；当它不是任何一个源时需要</translation>
    </message>
    <message>
        <source>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), array, base1, step1, base2, step2)</source>
        <translation>CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), 数组, 起点1, 步距1, 起点2, 步距2)</translation>
    </message>
    <message>
        <source>a map of one axis ({name})</source>
        <translation>一个轴的映射表 ({name})</translation>
    </message>
    <message>
        <source>a statement CONNECT with MAP2, of which there is none</source>
        <translation>CONNECT 加 MAP2 的语句，但一个也没有</translation>
    </message>
    <message>
        <source>both sources are axis {axis}: {key} and {other}</source>
        <translation>两个源都是轴 {axis}：{key} 和 {other}</translation>
    </message>
    <message>
        <source>the format {format} needs the setting {key}, since the table corrects none of its sources</source>
        <translation>格式 {format} 需要设置 {key}，因为该表不修正任何一个源</translation>
    </message>
    <message>
        <source>the table goes from {column}, which the settings {key}, {other} and {target} contradict</source>
        <translation>该表为 {column}，与设置 {key}、{other} 和 {target} 矛盾</translation>
    </message>
    <message>
        <source>the axes must be referenced; the connection replaces an error map of axis {axis}</source>
        <translation>各轴必须已回原点；该 CONNECT 取代轴 {axis} 的误差映射表</translation>
    </message>
    <message>
        <source>program with the map of an axis over two (MAP2)</source>
        <translation>含一个轴随两个轴变化的映射表的程序 (MAP2)</translation>
    </message>
    <message>
        <source>a number, or a name that got one before</source>
        <translation>数字，或此前已赋予数字的名称</translation>
    </message>
    <message>
        <source>one number; other buffers give it another one in line {line}</source>
        <translation>一个数字；其他缓冲区在第 {line} 行赋予了另一个</translation>
    </message>
    <message>
        <source>a name that got a number; in line {line} it gets something that is not computed here</source>
        <translation>已赋予数字的名称；第 {line} 行赋予它的内容此处不计算</translation>
    </message>
    <message>
        <source>a whole number, since it is declared INT; in line {line} it gets another one</source>
        <translation>整数，因为它声明为 INT；第 {line} 行赋予它的不是整数</translation>
    </message>
    <message>
        <source>a number with a decimal point, or a name that got one; expressions are not computed</source>
        <translation>带小数点的数字，或已赋予这种数字的名称；不计算表达式</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>从 0 起的整数</translation>
    </message>
    <message>
        <source>one index of {name}</source>
        <translation>{name} 的一个下标</translation>
    </message>
    <message>
        <source>two indices of {name}</source>
        <translation>{name} 的两个下标</translation>
    </message>
    <message>
        <source>an index of {name}: a whole number from 0</source>
        <translation>{name} 的下标：从 0 起的整数</translation>
    </message>
    <message>
        <source>a number with a decimal point; expressions are not computed</source>
        <translation>带小数点的数字；不计算表达式</translation>
    </message>
    <message>
        <source>a whole number, since {name} is declared INT</source>
        <translation>整数，因为 {name} 声明为 INT</translation>
    </message>
    <message>
        <source>an array whose elements are numbers in this program</source>
        <translation>其元素在此程序中为数字的数组</translation>
    </message>
    <message>
        <source>{name} with another number of indices</source>
        <translation>下标个数不同的 {name}</translation>
    </message>
    <message>
        <source>{sizes}, which its elements need</source>
        <translation>{sizes}，为其元素所需</translation>
    </message>
    <message>
        <source>{array} with elements for {sizes}</source>
        <translation>含 {sizes} 个元素的 {array}</translation>
    </message>
    <message>
        <source>a value for each element; the table has those that the program gives, and the controller may use the others as they are</source>
        <translation>每个元素一个值；表中为程序给出的值，其余的控制器可按原值使用</translation>
    </message>
    <message>
        <source>no {element}</source>
        <translation>没有 {element}</translation>
    </message>
    <message>
        <source>a number for each element up to the highest index</source>
        <translation>直到最大下标的每个元素一个数字</translation>
    </message>
    <message>
        <source>{element} a second time</source>
        <translation>{element} 再次出现</translation>
    </message>
    <message>
        <source>each element once; the last number counts</source>
        <translation>每个元素一次；以最后的数字为准</translation>
    </message>
    <message>
        <source>{name}, which is not supported</source>
        <translation>{name}，不支持</translation>
    </message>
    <message>
        <source>ERRORMAP1D, or CONNECT with MAP or MAP2</source>
        <translation>ERRORMAP1D，或 CONNECT 加 MAP 或 MAP2</translation>
    </message>
    <message>
        <source>name of the array: a letter, then letters, digits and underlines</source>
        <translation>数组名：先是一个字母，然后是字母、数字和下划线</translation>
    </message>
    <message>
        <source>the program declares the array; no where the controller has it already</source>
        <translation>由程序声明该数组；如控制器中已有，则为 no</translation>
    </message>
    <message>
        <source>&quot;{name}&quot; is no name for an array of the format {format}, such as {example}; change the setting {key}</source>
        <translation>“{name}”不是格式 {format} 的数组名（例如 {example}）；请更改设置 {key}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}; it is a number from 0</source>
        <translation>格式 {format} 的设置 {key} 为 {value}；应为从 0 起的数字</translation>
    </message>
    <message>
        <source>the controller must not have declared the array {name} before, since the program declares it; where it has, set declare=no</source>
        <translation>控制器此前不得已声明数组 {name}，因为由程序声明；如已声明，请设 declare=no</translation>
    </message>
    <message>
        <source>the controller must have declared the array {name}, with as many elements as the program gives it</source>
        <translation>控制器必须已声明数组 {name}，且元素数与程序给出的相同</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}, and the axis name is &quot;{name}&quot;; give the setting {key}</source>
        <translation>格式 {format} 用字母 {letters} 之一表示轴，而轴名为“{name}”；请给出设置 {key}</translation>
    </message>
    <message>
        <source>the format {format} names its axes by one of the letters {letters}; the setting {key} is {value}</source>
        <translation>格式 {format} 用字母 {letters} 之一表示轴；设置 {key} 为 {value}</translation>
    </message>
    <message>
        <source>the table is of axis &quot;{name}&quot;, and the setting {key} of the format {format} says {value}</source>
        <translation>该表属于轴“{name}”，而格式 {format} 的设置 {key} 为 {value}</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with the position in each line</source>
        <translation>每行带位置的补偿值表 (.COM)</translation>
    </message>
    <message>
        <source>also distances that are no power of two times 0.0001, for an iTNC 530</source>
        <translation>也接受不是 0.0001 乘以 2 的幂的间距，用于 iTNC 530</translation>
    </message>
    <message>
        <source>compensation-value table (.COM) with even positions</source>
        <translation>等间距位置的补偿值表 (.COM)</translation>
    </message>
    <message>
        <source>letter of the axis whose position counts, where its name is none or another one</source>
        <translation>以其位置为准的轴的字母，用于其名称不是字母或为其他字母时</translation>
    </message>
    <message>
        <source>letter of the axis that is compensated by the position of another one, where its name is none</source>
        <translation>按另一轴的位置补偿的轴的字母，用于其名称不是字母时</translation>
    </message>
    <message>
        <source>a number in mm or degrees behind {word}</source>
        <translation>{word} 之后以 mm 或度为单位的数字</translation>
    </message>
    <message>
        <source>the setting {key} {value}</source>
        <translation>设置 {key} {value}</translation>
    </message>
    <message>
        <source>one letter</source>
        <translation>一个字母</translation>
    </message>
    <message>
        <source>the moving axis, as in AXIS_Y; its letter as the setting {key} where the file has another name</source>
        <translation>运动轴，例如 AXIS_Y 中的；文件为其他名称时，用设置 {key} 给出其字母</translation>
    </message>
    <message>
        <source>axis {axis} in the name of the file</source>
        <translation>文件名中的轴 {axis}</translation>
    </message>
    <message>
        <source>axis {axis}, as the setting {key} says</source>
        <translation>轴 {axis}，与设置 {key} 一致</translation>
    </message>
    <message>
        <source>a first line without MM</source>
        <translation>没有 MM 的首行</translation>
    </message>
    <message>
        <source>MM or INCH; mm is assumed</source>
        <translation>MM 或 INCH；默认按 mm</translation>
    </message>
    <message>
        <source>a first line such as {example}</source>
        <translation>首行，例如 {example}</translation>
    </message>
    <message>
        <source>a distance of {distance}</source>
        <translation>间距 {distance}</translation>
    </message>
    <message>
        <source>a tab</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>blanks, since the columns are counted in characters</source>
        <translation>空格，因为各列按字符计数</translation>
    </message>
    <message>
        <source>each column once</source>
        <translation>每列一次</translation>
    </message>
    <message>
        <source>a line of headers such as {example}</source>
        <translation>一行标题，例如 {example}</translation>
    </message>
    <message>
        <source>a value below the header of an axis, and one in each column</source>
        <translation>轴标题下的值，每列一个</translation>
    </message>
    <message>
        <source>the number of a line</source>
        <translation>行的编号</translation>
    </message>
    <message>
        <source>ascending numbers from 0</source>
        <translation>从 0 起递增的编号</translation>
    </message>
    <message>
        <source>{position}, as DATUM and DISTANCE say for line {number}</source>
        <translation>{position}，由 DATUM 和 DISTANCE 对第 {number} 行得出</translation>
    </message>
    <message>
        <source>more than {count} lines</source>
        <translation>超过 {count} 行</translation>
    </message>
    <message>
        <source>at most {count} lines</source>
        <translation>最多 {count} 行</translation>
    </message>
    <message>
        <source>a line with its number and its position</source>
        <translation>含编号和位置的一行</translation>
    </message>
    <message>
        <source>nothing behind [END]</source>
        <translation>[END] 之后无内容</translation>
    </message>
    <message>
        <source>no line [END]</source>
        <translation>没有 [END] 行</translation>
    </message>
    <message>
        <source>that line at the end; the file may be cut off</source>
        <translation>末尾的该行；文件可能被截断</translation>
    </message>
    <message>
        <source>the position {position} of the rotary axis {axis}</source>
        <translation>回转轴 {axis} 的位置 {position}</translation>
    </message>
    <message>
        <source>0 to 360 deg; the control does not use others</source>
        <translation>0 至 360 deg；数控系统不使用其他位置</translation>
    </message>
    <message>
        <source>values of {axis} that change by {change}</source>
        <translation>{axis} 的值变化 {change}</translation>
    </message>
    <message>
        <source>at most {limit} from line to line, DISTANCE / 64, on older controls</source>
        <translation>在较旧的数控系统上，行与行之间最多 {limit}，即 DISTANCE / 64</translation>
    </message>
    <message>
        <source>values in a column, of which there are none</source>
        <translation>列中的值，但没有任何值</translation>
    </message>
    <message>
        <source>the column of {axis}</source>
        <translation>{axis} 的列</translation>
    </message>
    <message>
        <source>a line of headers behind the first line</source>
        <translation>首行之后的标题行</translation>
    </message>
    <message numerus="yes">
        <source>{count} values in the column BACKLASH</source>
        <comment>1 value in the column BACKLASH</comment>
        <translation>
            <numerusform>BACKLASH 列中有 {count} 个值</numerusform>
        </translation>
    </message>
    <message>
        <source>none: it is not published whether they are whole values or differences</source>
        <translation>无：未公布它们是总值还是差值</translation>
    </message>
    <message>
        <source>the table goes from {column}, and the settings for its axes say {axis} for both</source>
        <translation>该表为 {column}，而其各轴的设置均为 {axis}</translation>
    </message>
    <message>
        <source>there are two columns for axis {axis}</source>
        <translation>轴 {axis} 有两列</translation>
    </message>
    <message>
        <source>its numbers for axis {axis} are in {unit}; A, B and C are in degrees, other axes in mm</source>
        <translation>其轴 {axis} 的数字以 {unit} 为单位；A、B 和 C 以度为单位，其他轴以 mm 为单位</translation>
    </message>
    <message>
        <source>check the units and the axes of the table</source>
        <translation>检查表的单位和轴</translation>
    </message>
    <message>
        <source>its positions go from {first} to {last}, and of a rotary axis only 0 to 360 degrees count</source>
        <translation>其位置从 {first} 到 {last}，而回转轴只有 0 至 360 度有效</translation>
    </message>
    <message>
        <source>give them from 0 to 360 degrees in the file that is converted, -90 as 270</source>
        <translation>在待转换的文件中以 0 到 360 度给出，-90 写作 270</translation>
    </message>
    <message>
        <source>the numbers for axis {axis} have no unit; they are taken to be in {unit}</source>
        <translation>轴 {axis} 的数字没有单位；按 {unit} 处理</translation>
    </message>
    <message>
        <source>its distance is {distance}; the TNC 407 takes a power of two times {step}, and the next ones are {below} and {above}</source>
        <translation>其间距为 {distance}；TNC 407 接受 {step} 乘以 2 的幂，相邻的可用值为 {below} 和 {above}</translation>
    </message>
    <message>
        <source>resample it with one of these distances, or set any-distance=yes for an iTNC 530</source>
        <translation>以其中一个间距重采样，或对 iTNC 530 设置 any-distance=yes</translation>
    </message>
    <message>
        <source>its distance {distance} has more than {count} decimals</source>
        <translation>其间距 {distance} 的小数超过 {count} 位</translation>
    </message>
    <message>
        <source>resample it with a distance of fewer decimals</source>
        <translation>以小数位较少的间距重采样</translation>
    </message>
    <message>
        <source>the number {number} has more digits than a column holds</source>
        <translation>数字 {number} 的位数超过列宽</translation>
    </message>
    <message>
        <source>no text says the sign of a .COM table; it is written as the error, actual - commanded position. Check one point on the machine</source>
        <translation>没有资料说明 .COM 表的符号；按误差写出，即实际位置 - 指令位置。请在机床上检查一个点</translation>
    </message>
    <message>
        <source>name the file in a line of config.cma, in the column of axis {axis}, and mark the line with *; older controls also need the bit of the axis in MP730</source>
        <translation>在 config.cma 的一行中，于轴 {axis} 的列中填写该文件，并用 * 标记该行；较旧的数控系统还需要 MP730 中该轴的位</translation>
    </message>
    <message>
        <source>axis of the table, where the table names none of these</source>
        <translation>表的轴，用于表没有指定其中任何一个时</translation>
    </message>
    <message>
        <source>the unit &quot;{unit}&quot;</source>
        <translation>单位“{unit}”</translation>
    </message>
    <message>
        <source>mm, the only unit of this file</source>
        <translation>mm，此文件唯一的单位</translation>
    </message>
    <message>
        <source>the letter of an axis between brackets, such as [X]</source>
        <translation>方括号中的轴字母，例如 [X]</translation>
    </message>
    <message>
        <source>a section of axis {axis}</source>
        <translation>轴 {axis} 的段</translation>
    </message>
    <message>
        <source>X, Y or Z</source>
        <translation>X、Y 或 Z</translation>
    </message>
    <message>
        <source>a second section of axis {axis}</source>
        <translation>轴 {axis} 的第二个段</translation>
    </message>
    <message>
        <source>each axis once; the first is in line {line}</source>
        <translation>每个轴一次；第一个在第 {line} 行</translation>
    </message>
    <message>
        <source>a section such as [X] before the first numbers</source>
        <translation>首批数字之前的段，例如 [X]</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers between commas</source>
        <comment>1 number between commas</comment>
        <translation>
            <numerusform>逗号之间有 {count} 个数字</numerusform>
        </translation>
    </message>
    <message>
        <source>3, with decimal points: nominal position, forward error, backward error</source>
        <translation>3 个，用小数点：名义位置、正向误差、反向误差</translation>
    </message>
    <message>
        <source>a forward error in mm</source>
        <translation>以 mm 为单位的正向误差</translation>
    </message>
    <message>
        <source>a backward error in mm</source>
        <translation>以 mm 为单位的反向误差</translation>
    </message>
    <message>
        <source>a section such as [X], of which there is none</source>
        <translation>段，例如 [X]，但一个也没有</translation>
    </message>
    <message>
        <source>no line unit=mm</source>
        <translation>没有 unit=mm 行</translation>
    </message>
    <message>
        <source>that line; mm is the only unit</source>
        <translation>该行；mm 是唯一的单位</translation>
    </message>
    <message>
        <source>the file is axeserr.dat in the folder of the software (NK200: from a USB stick), read when the software starts</source>
        <translation>该文件为软件文件夹中的 axeserr.dat（NK200：来自 U 盘），在软件启动时读取</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2: both directions</source>
        <translation>将参数 Screw error compensation 设为 2：双向</translation>
    </message>
    <message>
        <source>set the parameter Screw error compensation to 2, or to 1 with the backlash as a parameter of its own</source>
        <translation>将参数 Screw error compensation 设为 2；或设为 1，反向间隙另用单独的参数</translation>
    </message>
    <message>
        <source>positions are machine coordinates from the reference point and must lie within the stroke, else the compensation is invalid</source>
        <translation>位置是以参考点为基准的机床坐标，必须在行程之内，否则补偿无效</translation>
    </message>
    <message>
        <source>axeserr.dat: screw errors forwards and backwards</source>
        <translation>axeserr.dat：正向和反向的丝杠螺距误差</translation>
    </message>
    <message>
        <source>nobody has published which sign files of the format {format} have; {sign} is an assumption. Check one point on the machine, and state feedback or command {statement}</source>
        <translation>没有公布格式 {format} 的文件采用哪种符号；{sign} 是一种假定。请在机床上检查一个点，并{statement}注明 feedback 或 command</translation>
    </message>
    <message>
        <source>holds the end values</source>
        <translation>保持端值</translation>
    </message>
    <message>
        <source>applies nothing</source>
        <translation>不作补偿</translation>
    </message>
    <message>
        <source>goes on as in the last cell</source>
        <translation>按最后一格延续</translation>
    </message>
    <message>
        <source>beyond the ends of the table the controller of {from} {before}, and that of {to} {after}: up to one cell beyond them, the corrections for {column} differ by at most {largest}, at {place}</source>
        <translation>超出表的两端时，{from} 的控制器{before}，{to} 的控制器{after}：在超出一格的范围内，{column} 的修正量最多相差 {largest}，在 {place}</translation>
    </message>
    <message>
        <source>in the field Sign, or with {option}</source>
        <translation>在“符号”栏中或用 {option}</translation>
    </message>
    <message>
        <source>in the field Sign, with {option}, or as {entry} in a machine file</source>
        <translation>在“符号”栏中、用 {option}，或在机床文件中以 {entry}</translation>
    </message>
    <message>
        <source>an entry such as {example}</source>
        <translation>条目，例如 {example}</translation>
    </message>
    <message>
        <source>each entry once; the last one counts</source>
        <translation>每个条目一次；以最后一个为准</translation>
    </message>
    <message>
        <source>a value in mm</source>
        <translation>以 mm 为单位的值</translation>
    </message>
    <message>
        <source>{key} and {key2} as the ends of {list}</source>
        <translation>{key} 和 {key2}，作为 {list} 的两端</translation>
    </message>
    <message>
        <source>{key} and {key2}, as later firmware writes them</source>
        <translation>{key} 和 {key2}，由较新的固件写出</translation>
    </message>
    <message>
        <source>entries {key} and {key2} for {list}</source>
        <translation>{list} 的条目 {key} 和 {key2}</translation>
    </message>
    <message>
        <source>an end above the start</source>
        <translation>大于起点的末端</translation>
    </message>
    <message>
        <source>a section [{section}] with {list} or {list2}</source>
        <translation>含 {list} 或 {list2} 的 [{section}] 段</translation>
    </message>
    <message>
        <source>[axis_twist_compensation] of printer.cfg: errors of the probe over X or Y</source>
        <translation>printer.cfg 的 [axis_twist_compensation]：探针沿 X 或 Y 的误差</translation>
    </message>
    <message>
        <source>unit of all numbers of the file; the controller takes them to be inches, and files in millimetres occur</source>
        <translation>文件中所有数字的单位；控制器按英寸处理，但也有以毫米为单位的文件</translation>
    </message>
    <message>
        <source>a missing number</source>
        <translation>缺少的数字</translation>
    </message>
    <message numerus="yes">
        <source>{count} numbers with commas between</source>
        <comment>1 number</comment>
        <translation>
            <numerusform>{count} 个以逗号分隔的数字</numerusform>
        </translation>
    </message>
    <message>
        <source>a comma directly behind the number &quot;{number}&quot;</source>
        <translation>紧接数字“{number}”之后的逗号</translation>
    </message>
    <message>
        <source>rows and columns, distances of X and Y, and X and Y of the first point</source>
        <translation>行数和列数、X 和 Y 的间距，以及首点的 X 和 Y</translation>
    </message>
    <message>
        <source>a number of rows or columns, {number} to {number2}</source>
        <translation>行数或列数，{number} 至 {number2}</translation>
    </message>
    <message>
        <source>a distance such as 0.5</source>
        <translation>间距，例如 0.5</translation>
    </message>
    <message>
        <source>another one: with 0 the controller corrects nothing</source>
        <translation>其他值：为 0 时控制器不作修正</translation>
    </message>
    <message>
        <source>a position of row 0 and column 0</source>
        <translation>第 0 行第 0 列的位置</translation>
    </message>
    <message>
        <source>the number of a row, 0 to {last}</source>
        <translation>行号，0 至 {last}</translation>
    </message>
    <message>
        <source>the number of a column, 0 to {last}</source>
        <translation>列号，0 至 {last}</translation>
    </message>
    <message>
        <source>row {row}, column {column}</source>
        <translation>行 {row}，列 {column}</translation>
    </message>
    <message>
        <source>each point once; the last line counts</source>
        <translation>每个点一次；以最后一行为准</translation>
    </message>
    <message numerus="yes">
        <source>no line for {count} points, the first of them {point}</source>
        <comment>no line for {point}</comment>
        <translation>
            <numerusform>有 {count} 个点没有对应的行，其中第一个是{point}</numerusform>
        </translation>
    </message>
    <message>
        <source>a line for each of the {rows} x {columns} points</source>
        <translation>{rows} x {columns} 个点每点一行</translation>
    </message>
    <message>
        <source>further numbers behind the last point</source>
        <translation>末点之后的其他数字</translation>
    </message>
    <message>
        <source>{number} points; the controller does not read more either</source>
        <translation>{number} 点；控制器也不会读取更多</translation>
    </message>
    <message>
        <source>numbers without a unit, taken to be {unit}</source>
        <translation>没有单位的数字，按 {unit} 处理</translation>
    </message>
    <message>
        <source>the setting {key}, {value} or {value2}</source>
        <translation>设置 {key}，{value} 或 {value2}</translation>
    </message>
    <message>
        <source>its source {number} is {axis}, and this one is {name}</source>
        <translation>其源 {number} 为 {axis}，而此处为 {name}</translation>
    </message>
    <message>
        <source>exchange the sources of the table</source>
        <translation>对调表的源</translation>
    </message>
    <message>
        <source>{count} points along {axis} are more than the {limit} that the controller takes</source>
        <translation>沿 {axis} 的 {count} 点超过控制器可接受的 {limit} 点</translation>
    </message>
    <message>
        <source>it corrects X, Y and Z, and this table goes from {column}</source>
        <translation>它修正 X、Y 和 Z，而此表为 {column}</translation>
    </message>
    <message>
        <source>state the target as Z, or as other, where it is Z</source>
        <translation>请将目标轴注明为 Z；若它本就是 Z，则注明为 other</translation>
    </message>
    <message>
        <source>two columns go from {column}</source>
        <translation>有两列均为 {column}</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>请只保留其一</translation>
    </message>
    <message>
        <source>the numbers of the file are in {unit}; the controller takes them to be inches</source>
        <translation>文件中的数字以 {unit} 为单位；控制器按英寸处理</translation>
    </message>
    <message>
        <source>name the file as Geo File in the tool setup of KMotionCNC; arcs are then broken into short lines, and Z is corrected for the plane Z = 0 only</source>
        <translation>在 KMotionCNC 的 Tool Setup 中将该文件填为 Geo File；此后圆弧会被分成短直线，且 Z 只按平面 Z = 0 修正</translation>
    </message>
    <message>
        <source>geometric correction of X, Y and Z over X and Y</source>
        <translation>X、Y 和 Z 随 X 和 Y 的几何修正</translation>
    </message>
    <message>
        <source>a line each for the number of positions, the size of a range and the first position</source>
        <translation>位置数、范围大小和首位置各占一行</translation>
    </message>
    <message>
        <source>a number of positions</source>
        <translation>位置数</translation>
    </message>
    <message>
        <source>the size of a range</source>
        <translation>范围大小</translation>
    </message>
    <message>
        <source>the first position</source>
        <translation>首位置</translation>
    </message>
    <message>
        <source>a range of {size}</source>
        <translation>范围 {size}</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>大于 0</translation>
    </message>
    <message>
        <source>index and position, or the position alone</source>
        <translation>编号和位置，或只有位置</translation>
    </message>
    <message>
        <source>an index from 0</source>
        <translation>从 0 起的编号</translation>
    </message>
    <message>
        <source>the index {number}</source>
        <translation>编号 {number}</translation>
    </message>
    <message>
        <source>{number}: indices count from 0 in the order of the lines</source>
        <translation>{number}：编号从 0 起按行的顺序</translation>
    </message>
    <message>
        <source>a position to command</source>
        <translation>应给出的指令位置</translation>
    </message>
    <message>
        <source>{value}, as the first line says</source>
        <translation>{value}，与首行一致</translation>
    </message>
    <message>
        <source>strictly increasing positions to command; a list of corrections is no such file</source>
        <translation>严格递增的指令位置；修正量列表不是这种文件</translation>
    </message>
    <message>
        <source>at {position} the position to command, {sum}, is not larger than the one before, {before}</source>
        <translation>在 {position} 处，应给出的指令位置 {sum} 不大于前一个 {before}</translation>
    </message>
    <message>
        <source>the file holds positions to command, not corrections; KMotionCNC applies them after the geometric correction</source>
        <translation>该文件存放应给出的指令位置，而不是修正量；KMotionCNC 在几何修正之后应用它们</translation>
    </message>
    <message>
        <source>linear table of one axis: positions to command</source>
        <translation>一个轴的线性表：应给出的指令位置</translation>
    </message>
    <message>
        <source>motor units for one unit of the positions</source>
        <translation>位置的每单位对应的电机单位</translation>
    </message>
    <message>
        <source>number of the table, from 0</source>
        <translation>表的编号，从 0 起</translation>
    </message>
    <message>
        <source>number of the motor whose position counts</source>
        <translation>以其位置为准的电机号</translation>
    </message>
    <message>
        <source>number of the motor that is compensated</source>
        <translation>被补偿的电机号</translation>
    </message>
    <message>
        <source>a value of the table</source>
        <translation>表的值</translation>
    </message>
    <message>
        <source>value {number} again</source>
        <translation>值 {number} 再次出现</translation>
    </message>
    <message>
        <source>each value once; the last one counts</source>
        <translation>每个值一次；以最后一个为准</translation>
    </message>
    <message>
        <source>an assignment such as {example}</source>
        <translation>赋值，例如 {example}</translation>
    </message>
    <message>
        <source>{element} of the table: {meaning}</source>
        <translation>表的 {element}：{meaning}</translation>
    </message>
    <message>
        <source>CompPos or CompPos2 of one motor, such as {example}</source>
        <translation>一个电机的 CompPos 或 CompPos2，例如 {example}</translation>
    </message>
    <message>
        <source>the motor that is compensated</source>
        <translation>被补偿的电机</translation>
    </message>
    <message>
        <source>the scale factor of the values</source>
        <translation>值的比例系数</translation>
    </message>
    <message>
        <source>a scale factor Sf[0] of {factor}</source>
        <translation>比例系数 Sf[0] 为 {factor}</translation>
    </message>
    <message>
        <source>1; it is taken to multiply the values</source>
        <translation>1；假定它与值相乘</translation>
    </message>
    <message>
        <source>{value}; what other bits do is not known</source>
        <translation>{value}；其他位的作用未知</translation>
    </message>
    <message>
        <source>no value {number}</source>
        <translation>没有值 {number}</translation>
    </message>
    <message>
        <source>a table of several sources</source>
        <translation>多个源的表</translation>
    </message>
    <message>
        <source>one source: in which order the values of several stand is not known</source>
        <translation>一个源：多个源时值的排列顺序未知</translation>
    </message>
    <message>
        <source>the number of segments, one less than values</source>
        <translation>段数，比值的个数少一</translation>
    </message>
    <message>
        <source>the whole span</source>
        <translation>整个跨度</translation>
    </message>
    <message>
        <source>the number of the source motor</source>
        <translation>源电机号</translation>
    </message>
    <message>
        <source>{count} segments over {span}</source>
        <translation>{span} 上的 {count} 段</translation>
    </message>
    <message>
        <source>1 to {most} segments over more than 0</source>
        <translation>1 至 {most} 段，跨度大于 0</translation>
    </message>
    <message>
        <source>assignments to {name}</source>
        <translation>对 {name} 的赋值</translation>
    </message>
    <message>
        <source>a table in motor units</source>
        <translation>以电机单位为单位的表</translation>
    </message>
    <message>
        <source>there is no number {number}</source>
        <translation>没有编号 {number}</translation>
    </message>
    <message>
        <source>choose one from 0 to {most}</source>
        <translation>从 0 至 {most} 中选择</translation>
    </message>
    <message>
        <source>Sys.CompEnable must be at least {number}, also for other tables</source>
        <translation>Sys.CompEnable 至少应为 {number}，其他表也计算在内</translation>
    </message>
    <message>
        <source>the sign of these tables and what Sf, Ctrl and OutCtrl do are assumptions: look at one point on the machine before the table is used</source>
        <translation>这种表的符号以及 Sf、Ctrl 和 OutCtrl 的作用都是假定：使用该表前，请在机床上检查一个点</translation>
    </message>
    <message>
        <source>compensation table of one source (CompTable)</source>
        <translation>单源补偿表 (CompTable)</translation>
    </message>
    <message>
        <source>what the variables are called: letters, digits and _, a letter first</source>
        <translation>变量的名称：字母、数字和 _，以字母开头</translation>
    </message>
    <message>
        <source>a variable of the type {type} in front of the elements</source>
        <translation>元素之前的 {type} 类型变量</translation>
    </message>
    <message>
        <source>TRUE or FALSE</source>
        <translation>TRUE 或 FALSE</translation>
    </message>
    <message>
        <source>{value}: what another direction means is not known here</source>
        <translation>{value}：其他方向的含义此处未知</translation>
    </message>
    <message>
        <source>a declaration without its end</source>
        <translation>没有结尾的声明</translation>
    </message>
    <message>
        <source>a semicolon behind it</source>
        <translation>其后的分号</translation>
    </message>
    <message>
        <source>the last position</source>
        <translation>末位置</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>元素的个数</translation>
    </message>
    <message numerus="yes">
        <source>{count} elements</source>
        <comment>1 element</comment>
        <translation>
            <numerusform>{count} 个元素</numerusform>
        </translation>
    </message>
    <message>
        <source>from {first} to {last}, as MinPosition and MaxPosition say</source>
        <translation>从 {first} 到 {last}，与 MinPosition 和 MaxPosition 一致</translation>
    </message>
    <message>
        <source>an element of one number</source>
        <translation>只含一个数字的元素</translation>
    </message>
    <message>
        <source>a position and a compensation</source>
        <translation>位置和补偿值</translation>
    </message>
    <message>
        <source>a compensation</source>
        <translation>补偿值</translation>
    </message>
    <message>
        <source>the values {first} and {last} at the ends</source>
        <translation>两端的值 {first} 和 {last}</translation>
    </message>
    <message>
        <source>the same value at both ends, which are one place</source>
        <translation>两端相同的值，因为两端是同一处</translation>
    </message>
    <message>
        <source>an array of {type} behind the parameters</source>
        <translation>参数之后的 {type} 数组</translation>
    </message>
    <message>
        <source>a variable of the type {type}</source>
        <translation>{type} 类型的变量</translation>
    </message>
    <message>
        <source>the setting name is &quot;{value}&quot;, expected letters, digits and _, a letter first</source>
        <translation>设置 name 为“{value}”，应为字母、数字和 _，以字母开头</translation>
    </message>
    <message>
        <source>the manual contradicts itself on whether the correction is added to the nominal or to the actual position: check one point on the machine</source>
        <translation>修正量加到名义位置还是实际位置，手册自相矛盾：请在机床上检查一个点</translation>
    </message>
    <message>
        <source>switch Position Correction of the axis on; Ramp limits the speed of the correction</source>
        <translation>启用该轴的 Position Correction；Ramp 限制修正的速度</translation>
    </message>
    <message>
        <source>structured text for MC_TableBasedPositionCompensation</source>
        <translation>用于 MC_TableBasedPositionCompensation 的结构化文本</translation>
    </message>
    <message>
        <source>a prediction needs a measurement of targets</source>
        <translation>预测需要目标位置的测量</translation>
    </message>
    <message>
        <source>a prediction needs a table of one dimension</source>
        <translation>预测需要一维的表</translation>
    </message>
    <message>
        <source>{reason} Check the unit of the values; if they are right, confirm them with accept-large = true for axis {machineAxis} in the machine file</source>
        <translation>{reason}请检查值的单位；如果无误，请在机床文件中对轴 {machineAxis} 用 accept-large = true 确认</translation>
    </message>
    <message>
        <source>the table is in counts already, and the format {format} would multiply it by the counts per unit once more: set them to 1, or read the source with its own</source>
        <translation>该表已以计数为单位，格式 {format} 会再乘一次每单位计数：请将其设为 1，或用源自身的每单位计数读取</translation>
    </message>
    <message>
        <source>a comma, a bracket or a semicolon behind the value &quot;{value}&quot;</source>
        <translation>值“{value}”之后的逗号、括号或分号</translation>
    </message>
    <message>
        <source>the table is {length} long, but a turn of the axis is {turn}: a prediction needs a table of one turn</source>
        <translation>该表长 {length}，而该轴的一转为 {turn}：预测需要一整转的表</translation>
    </message>
    <message>
        <source>nobody has published the sign of its format. Import it on Write, where you state the sign, export it from there as a calibration file, and choose that</source>
        <translation>该格式的符号没有公开资料。请在“写入”页导入该文件并指明符号，再从那里导出为校准文件，然后选择该文件</translation>
    </message>
    <message>
        <source>there is no font with the characters of this language to draw a PDF with: install one, such as fonts-noto-cjk, or write the report as HTML</source>
        <translation>没有包含该语言字符的字体，无法绘制 PDF：请安装一种字体（如 fonts-noto-cjk），或将报告写成 HTML</translation>
    </message>
    <message>
        <source>{file} is no record (.axcal), no machine file (.toml), no TAM configuration (.TAMcfg), and no table or measurement of a known format; a table whose format you can name is opened on the tab Write</source>
        <translation>{file} 不是档案 (.axcal)、机床文件 (.toml) 或 TAM 配置 (.TAMcfg)，也不是已知格式的表或测量；格式已知的表请在“写入”标签页中打开</translation>
    </message>
    <message>
        <source>the drive is only looked at</source>
        <translation>只读取驱动器</translation>
    </message>
    <message>
        <source>you have no permission to use the port, and no group has it</source>
        <translation>没有使用该端口的权限，也没有任何用户组拥有该权限</translation>
    </message>
    <message>
        <source>ask the administrator</source>
        <translation>请联系管理员</translation>
    </message>
    <message>
        <source>you have no permission to use the port, although you are in its group {group}</source>
        <translation>没有使用该端口的权限，尽管已在其用户组 {group} 中</translation>
    </message>
    <message>
        <source>you have no permission to use the port: you are in the group {group}, but this session is older than that</source>
        <translation>没有使用该端口的权限：已在用户组 {group} 中，但本次会话早于加入该组</translation>
    </message>
    <message>
        <source>log out and in again</source>
        <translation>请注销后重新登录</translation>
    </message>
    <message>
        <source>you have no permission to use the port</source>
        <translation>没有使用该端口的权限</translation>
    </message>
    <message>
        <source>join the group {group} (sudo usermod -aG {name} $USER) and log in again</source>
        <translation>请加入用户组 {group}（sudo usermod -aG {name} $USER），然后重新登录</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>没有该端口</translation>
    </message>
    <message>
        <source>is the cable or the adapter plugged in?</source>
        <translation>电缆或适配器是否已插好？</translation>
    </message>
    <message>
        <source>{found}; {wayOut}</source>
        <translation>{found}；{wayOut}</translation>
    </message>
    <message>
        <source>the instrument sends a line of more than {count} characters: check its settings and its speed</source>
        <translation>仪器发送的一行超过 {count} 个字符：请检查其设置和通信速率</translation>
    </message>
    <message>
        <source>number of the reference point, parameter 3620</source>
        <translation>参考点的编号，参数 3620</translation>
    </message>
    <message>
        <source>interval of the points, parameter 3624, in the unit of the positions</source>
        <translation>点的间隔，参数 3624，以位置的单位表示</translation>
    </message>
    <message>
        <source>detection unit of the axis, in the unit of the positions, such as 0.001</source>
        <translation>轴的检测单位，以位置的单位表示，例如 0.001</translation>
    </message>
    <message>
        <source>magnification of the values, parameter 3623</source>
        <translation>值的倍率，参数 3623</translation>
    </message>
    <message>
        <source>position of the reference point</source>
        <translation>参考点的位置</translation>
    </message>
    <message>
        <source>lowest number of the axis, parameter 3621, instead of the lowest one in the file</source>
        <translation>轴的最小编号，参数 3621，代替文件中的最小编号</translation>
    </message>
    <message>
        <source>highest number of the axis, parameter 3622, instead of the highest one in the file</source>
        <translation>轴的最大编号，参数 3622，代替文件中的最大编号</translation>
    </message>
    <message>
        <source>what N of a line is for number 0</source>
        <translation>编号 0 所在行的 N 值</translation>
    </message>
    <message>
        <source>largest value that the controller takes for a number</source>
        <translation>控制器对一个编号接受的最大值</translation>
    </message>
    <message>
        <source>stored pitch error data of an axis (N10033P2)</source>
        <translation>轴的存储型螺距误差补偿数据 (N10033P2)</translation>
    </message>
    <message>
        <source>a whole number of increments behind P</source>
        <translation>P 后的整数增量</translation>
    </message>
    <message>
        <source>at most {most}</source>
        <translation>最多 {most}</translation>
    </message>
    <message>
        <source>bit 0 of parameter 3605 is 1: values for each direction of motion</source>
        <translation>参数 3605 的位 0 为 1：每个运动方向各有值</translation>
    </message>
    <message>
        <source>one value for both directions; leave the line out if it is of another axis</source>
        <translation>两个方向共用一个值；若该行属于另一轴，请删去该行</translation>
    </message>
    <message>
        <source>line N{number}</source>
        <translation>行 N{number}</translation>
    </message>
    <message>
        <source>N{first} to N{last}, as the setting first-record says</source>
        <translation>N{first} 至 N{last}，与设置 first-record 一致</translation>
    </message>
    <message>
        <source>a line such as {example}</source>
        <translation>形如 {example} 的行</translation>
    </message>
    <message>
        <source>a line % in front of it</source>
        <translation>其前应有一行 %</translation>
    </message>
    <message>
        <source>lines without an end</source>
        <translation>没有结尾的行</translation>
    </message>
    <message>
        <source>a line % behind the last one</source>
        <translation>最后一行之后应有一行 %</translation>
    </message>
    <message>
        <source>lines such as {example} between two lines %</source>
        <translation>两行 % 之间形如 {example} 的行</translation>
    </message>
    <message>
        <source>no line from N{first} to N{last}</source>
        <translation>没有 N{first} 至 N{last} 的行</translation>
    </message>
    <message>
        <source>pitch error data; the setting first-record says where their numbers begin</source>
        <translation>螺距误差补偿数据；其编号的起点由设置 first-record 给出</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} for the axis</source>
        <translation>轴的编号 {first} 至 {last}</translation>
    </message>
    <message>
        <source>numbers round that of the reference point, {number}, as the setting {key} says</source>
        <translation>包含参考点编号 {number} 的编号，与设置 {key} 一致</translation>
    </message>
    <message>
        <source>the numbers {first} to {last} of one turn</source>
        <translation>一转的编号 {first} 至 {last}</translation>
    </message>
    <message>
        <source>each number from {first} to {last}; first-number and last-number choose those of one axis</source>
        <translation>{first} 至 {last} 的每个编号；用 first-number 和 last-number 选择一个轴的编号</translation>
    </message>
    <message>
        <source>at most {most} of an axis, as one source says</source>
        <translation>据某一资料，一个轴最多 {most} 个</translation>
    </message>
    <message>
        <source>the values {first} to {last}, which add up to {sum}</source>
        <translation>值 {first} 至 {last}，其和为 {sum}</translation>
    </message>
    <message>
        <source>0 over one turn</source>
        <translation>一转之和为 0</translation>
    </message>
    <message>
        <source>value {number}, of the reference point</source>
        <translation>参考点的值 {number}</translation>
    </message>
    <message>
        <source>the same as value {number}, which is the same section</source>
        <translation>与属于同一区段的值 {number} 相同</translation>
    </message>
    <message>
        <source>the setting wrap-range is {turn}, expected 1 to {most} times the interval of {interval}</source>
        <translation>设置 wrap-range 为 {turn}，应为间隔 {interval} 的 1 至 {most} 倍</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} is {value}, expected {least} to {most}</source>
        <translation>格式 {format} 的设置 {key} 为 {value}，应为 {least} 至 {most}</translation>
    </message>
    <message>
        <source>wrap-range says which numbers a rotary axis has; leave {key} and {key2} out</source>
        <translation>回转轴的编号由 wrap-range 决定；请不要给出 {key} 和 {key2}</translation>
    </message>
    <message>
        <source>the reference position {position} is no point of it; its points are from {first} to {last}, {distance} apart</source>
        <translation>参考位置 {position} 不是其中的点；其点为 {first} 至 {last}，间距 {distance}</translation>
    </message>
    <message>
        <source>resample it with a point there, or check reference-position</source>
        <translation>重采样，使该处有一点，或检查 reference-position</translation>
    </message>
    <message>
        <source>its points would get the numbers {first} to {last}</source>
        <translation>其点的编号将为 {first} 至 {last}</translation>
    </message>
    <message>
        <source>choose a reference-number so that they are from 0 to {most}</source>
        <translation>选择 reference-number，使编号在 0 至 {most} 之内</translation>
    </message>
    <message>
        <source>the value {value} is too large</source>
        <translation>值 {value} 过大</translation>
    </message>
    <message>
        <source>check detection-unit and the unit of the values</source>
        <translation>检查 detection-unit 和值的单位</translation>
    </message>
    <message>
        <source>its value at the reference position is {value}, and the controller takes it to be 0 there</source>
        <translation>其在参考位置处的值为 {value}，而控制器在该处按 0 处理</translation>
    </message>
    <message>
        <source>from {first} to {last} it changes by {count} increments of {increment}, and a value is at most {most}</source>
        <translation>从 {first} 到 {last} 变化 {count} 个增量（每个 {increment}），而值最多为 {most}</translation>
    </message>
    <message>
        <source>set magnification={number}, the smallest that fits, or largest-step if the controller takes more</source>
        <translation>设置 magnification={number}（能容纳的最小值），或在控制器接受更大的值时设置 largest-step</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}</source>
        <translation>设置轴的参数：3620 = {reference}，3621 = {first}，3622 = {last}，3623 = {magnification}，3624 = {interval}，3625 = {turn}</translation>
    </message>
    <message>
        <source>set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = {last}, 3623 = {magnification}, 3624 = {interval}</source>
        <translation>设置轴的参数：3620 = {reference}，3621 = {first}，3622 = {last}，3623 = {magnification}，3624 = {interval}</translation>
    </message>
    <message>
        <source>these are {count} points, and one source says that an axis has at most {most}</source>
        <translation>共 {count} 个点，而据某一资料，一个轴最多 {most} 个</translation>
    </message>
    <message>
        <source>the sign is an assumption: a value is put out to the axis as pulses. Check one point on the machine</source>
        <translation>符号是假定：值以脉冲形式输出到轴。请在机床上检查一个点</translation>
    </message>
    <message>
        <source>where within its section a value is put out is not known: the correction is taken to be linear, and its place is in doubt by half an interval</source>
        <translation>值在其区段内何处输出尚不清楚：修正量按线性处理，其位置有半个间隔的不确定性</translation>
    </message>
    <message>
        <source>after loading switch the power off and on and return to the reference point; alarm PW1102 says that the numbers do not fit</source>
        <translation>载入后断电再上电并返回参考点；报警 PW1102 表示编号不符</translation>
    </message>
    <message>
        <source>parameter {number}, which is {value} for no axis</source>
        <translation>参数 {number}，没有任何轴为 {value}</translation>
    </message>
    <message>
        <source>the reference point, numbers and magnification of one axis, as the settings say</source>
        <translation>与设置一致的单个轴的参考点、编号和倍率</translation>
    </message>
    <message>
        <source>parameters 3620 to 3623 of several axes, and numbers {first} to {last}</source>
        <translation>多个轴的参数 3620 至 3623，以及编号 {first} 至 {last}</translation>
    </message>
    <message>
        <source>the numbers of one axis; first-number and last-number choose them</source>
        <translation>一个轴的编号；用 first-number 和 last-number 选择</translation>
    </message>
    <message>
        <source>shift all values so that it is 0 there; convert does that with --zero</source>
        <translation>将所有值平移，使其在该处为 0；convert 用 --zero 完成</translation>
    </message>
    <message>
        <source>{number} to command, to reach {number2}</source>
        <translation>到达 {number2} 的指令值为 {number}</translation>
    </message>
    <message>
        <source>at most half a range away; a list of corrections is no such file</source>
        <translation>相差不超过半个区间；修正值列表不是这种文件</translation>
    </message>
    <message>
        <source>a comment without an end</source>
        <translation>没有结束的注释</translation>
    </message>
    <message>
        <source>{sign} behind it</source>
        <translation>其后为 {sign}</translation>
    </message>
    <message>
        <source>one position and one compensation in each pair of brackets</source>
        <translation>每对括号中一个位置和一个补偿值</translation>
    </message>
    <message>
        <source>the values for {column} have no unit; they are taken to be in {unit}, as the positions are</source>
        <translation>{column} 的值没有单位；按位置的单位 {unit} 处理</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to have no unit; state it in the header, as X [mm], or as the setting {key} of the file that is read</source>
        <translation>{column} 的值以 {unit} 为单位，而与之相加的位置没有单位；请在表头中注明，如 X [mm]，或用所读文件的设置 {key} 指定</translation>
    </message>
    <message>
        <source>The table states no unit for its values; they are taken to be in {before}, as its positions are, and converted to {after}. The largest correction is {largest}.</source>
        <translation>该表未注明值的单位；按其位置的单位 {before} 处理，并换算为 {after}。最大修正量为 {largest}。</translation>
    </message>
    <message>
        <source>{name} has several tables of axis {axis}; which of them was active has to be said by its CRC, in the file of the measurement (// compensation: crc:{crc})</source>
        <translation>{name} 有轴 {axis} 的多个表；须在测量文件中用 CRC 注明当时启用的是哪一个 (// compensation: crc:{crc})</translation>
    </message>
    <message>
        <source>{name} has several tables, none of which says its axis, so that it is not known which of them is meant: take a file with that table alone</source>
        <translation>{name} 有多个表，都没有注明所属的轴，因此不知道指的是哪一个：请采用只含该表的文件</translation>
    </message>
    <message>
        <source>{name} has several tables, and which of them is meant is not known: state the axis as it is called there (--target, or // axis: in the file of the measurement; there are: {axes}), or take a file with that table alone</source>
        <translation>{name} 有多个表，不知道指的是哪一个：请按其中的名称指定轴（--target，或测量文件中的 // axis:；有：{axes}），或采用只含该表的文件</translation>
    </message>
    <message>
        <source>the targets go from {from} to {to}, which is more than a turn of {turn}: give the length of the whole turn (--turn), or leave out what lies in a second one (--exclude)</source>
        <translation>目标位置从 {from} 到 {to}，超过一转 {turn}：请给出整转的长度（--turn），或排除位于第二转中的部分（--exclude）</translation>
    </message>
    <message>
        <source>positions with a decimal point and blanks between them; without a Target-count nobody can tell two positions from one with a decimal comma</source>
        <translation>使用小数点、以空格分隔的位置；没有 Target-count 就无法区分两个位置和一个带小数逗号的位置</translation>
    </message>
    <message>
        <source>{found} targets, but deviations of {used}</source>
        <translation>目标位置有 {found} 个，而有偏差的为 {used} 个</translation>
    </message>
    <message>
        <source>a deviation of every target, or a Target-count</source>
        <translation>每个目标位置都有偏差，或有 Target-count</translation>
    </message>
    <message>
        <source>positions of targets that rise or fall throughout, with a decimal point and blanks between them</source>
        <translation>始终递增或始终递减的目标位置，使用小数点、以空格分隔</translation>
    </message>
    <message>
        <source>every run goes {direction}, in a file of both directions (Flags: 0 0 2 0)</source>
        <translation>双向文件 (Flags: 0 0 2 0) 中每一趟的方向都是{direction}</translation>
    </message>
    <message>
        <source>the lines of each run in the order in which they were measured; sorted by target they all seem to rise</source>
        <translation>每一趟的行按测量的先后排列；按目标位置排序后，看上去都是递增</translation>
    </message>
    <message>
        <source>the file does not say whether its values are corrected to 20 deg C already; if they are not, that has to be stated (--not-corrected)</source>
        <translation>文件没有注明其值是否已修正到 20 °C；如果没有，须予以注明 (--not-corrected)</translation>
    </message>
    <message>
        <source>file {second} holds the same measurement as file {first}, value by value: give it once</source>
        <translation>第 {second} 个文件与第 {first} 个文件是同一次测量，各值完全相同：只需给出一次</translation>
    </message>
    <message>
        <source>some of the files say otherwise than the others, or do not say, whether their values are corrected to 20 deg C, so that no correction would be right for all; say it in each of them (// corrected: 20C, or // corrected: none), or take those alone that agree</source>
        <translation>各文件对其值是否已修正到 20 °C 的说明不一致或缺失，因此没有对所有文件都正确的修正；请在每个文件中注明（// corrected: 20C 或 // corrected: none），或只采用说明一致的文件</translation>
    </message>
    <message>
        <source>the drive is taken to look the table up before the compensation, at the position of the encoder; at the set position (lookup: set) its corrections would differ by up to {largest}</source>
        <translation>假定驱动器在补偿前按编码器位置查表；若按给定位置查表 (lookup: set)，补偿值最多相差 {largest}</translation>
    </message>
    <message>
        <source>where a table is looked up (--lookup-at) is said of a table of the drive, and neither {from} nor {to} is one</source>
        <translation>查表位置 (--lookup-at) 只适用于驱动器的表，而 {from} 和 {to} 都不是</translation>
    </message>
    <message>
        <source>the file does not say where the drive looks its table up: in a calibration file add the line // lookup: encoder or // lookup: set</source>
        <translation>文件没有说明驱动器在哪里查它的表：请在标定文件中添加一行 // lookup: encoder 或 // lookup: set</translation>
    </message>
    <message>
        <source>the table is made for a drive that looks it up after the compensation, at the set position (lookup: set)</source>
        <translation>该表是为在补偿后按给定位置查表的驱动器制作的 (lookup: set)</translation>
    </message>
    <message>
        <source>the values are converted from those that the drive looks up after the compensation, at the set position (lookup: set)</source>
        <translation>这些值由驱动器在补偿后按给定位置查表所用的值转换而来 (lookup: set)</translation>
    </message>
    <message>
        <source>the file of the table says lookup: {file}, and stated is {stated} (--lookup-at): correct the one that is wrong</source>
        <translation>表的文件中写的是 lookup: {file}，而指定的是 {stated} (--lookup-at)：请改正其中错误的一个</translation>
    </message>
    <message>
        <source>while {name} was active the sources of the axis were others, so that its values may belong to other positions: measure again with what the axis has now</source>
        <translation>{name} 有效时轴的源与现在不同，其值可能属于其他位置：请用轴现在的设置重新测量</translation>
    </message>
    <message>
        <source>The table stays, and its new source is on the other side of the compensation: its values belong to other positions. Write the table that was made for this source.</source>
        <translation>表保持不变，而它的新源位于补偿的另一侧：其值属于其他位置。请写入为该源制作的表。</translation>
    </message>
    <message>
        <source>the plan is in {planned}, and axis {axis} of the drive in {unit}: make a plan in {needed}, or choose another axis</source>
        <translation>测量计划以 {planned} 为单位，而驱动器的轴 {axis} 以 {unit} 为单位：请制定以 {needed} 为单位的计划，或选择另一个轴</translation>
    </message>
    <message>
        <source>The table that no axis used in {slot} is not restored: the table of this axis is there.</source>
        <translation>{slot} 中没有轴使用的表不会还原：该轴的表在那里。</translation>
    </message>
    <message>
        <source>the values for {column} are said to be in the unit of the drive, and the positions that they are added to are in {unit}; state the unit of the values, or that the positions are in that of the drive, too</source>
        <translation>{column} 的值被声明为驱动器的单位，而这些值所加到的位置以 {unit} 为单位；请说明值的单位，或说明位置也采用驱动器的单位</translation>
    </message>
    <message>
        <source>{name} = {value}, which multiplies the table on the control</source>
        <translation>{name} = {value}，控制器用它乘以该表</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply the values by the number (--scale)</source>
        <translation>1；删除该行，并将各值乘以该数（--scale）</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, which cannot be given in {other}, the unit of the positions that they are added to; correct the units</source>
        <translation>{column} 的值以 {unit} 为单位，无法换算成 {other}，即这些值所加到的位置的单位；请更正单位</translation>
    </message>
    <message>
        <source>{name} does not say the unit of its numbers, and its CRC-32 {crc} is the same in mm and in m, in degrees and in radians: take a calibration file in whose header the units stand, such as the one that reading the table from the drive writes</source>
        <translation>{name} 未注明其数值的单位，而其 CRC-32 {crc} 在 mm 与 m、度与弧度下都相同：请使用标题行中带单位的校准文件，例如从驱动器读取该表时写出的文件</translation>
    </message>
    <message>
        <source>the axis had other sources with {name}, so that its values may belong to other positions: merge onto nothing (leave out --onto), since with the raw positions on file the values are the whole error</source>
        <translation>使用 {name} 时轴的源与现在不同，其值可能属于其他位置：请不合并（去掉 --onto），因为文件中有原始位置，值就是全部误差</translation>
    </message>
    <message>
        <source>a gain is for residuals that are merged onto a table (--onto); here the values are the whole error</source>
        <translation>增益用于合并到表上的残差（--onto）；此处的值是全部误差</translation>
    </message>
    <message>
        <source>{name} is a table over {axes}, but what was measured is over {measured}: take a table over the same axes, in the same order</source>
        <translation>{name} 是关于 {axes} 的表，但测量是关于 {measured} 的：请使用相同轴、相同顺序的表</translation>
    </message>
    <message>
        <source>what was measured along one axis needs a table of one dimension; {name} has {dimensions}</source>
        <translation>沿一个轴的测量需要一维的表；{name} 为 {dimensions} 维</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} is of axis {axis}: take the table of the axis that was measured</source>
        <translation>测量的是轴 {measured}，但 {name} 属于轴 {axis}：请使用所测轴的表</translation>
    </message>
    <message>
        <source>axis {measured} was measured, but {name} corrects an axis that is no source: take the table of the axis that was measured, or state what the values correct (--target other)</source>
        <translation>测量的是轴 {measured}，但 {name} 补偿的轴不是源轴：请使用所测轴的表，或说明这些值补偿什么（--target other）</translation>
    </message>
    <message>
        <source>nothing is merged over temperature: leave out --onto, since with the raw positions on file the values are the whole error</source>
        <translation>不能随温度合并：请去掉 --onto，因为文件中有原始位置，值就是全部误差</translation>
    </message>
    <message>
        <source>a unit that is not stated</source>
        <translation>未注明的单位</translation>
    </message>
    <message>
        <source>a time in s, ms, min or h, in brackets behind the name; without a unit it is in s</source>
        <translation>时间，单位为 s、ms、min 或 h，写在名称后的方括号中；没有单位时为 s</translation>
    </message>
    <message>
        <source>a temperature in C, K or F, in brackets behind the name; without a unit it is in C</source>
        <translation>温度，单位为 C、K 或 F，写在名称后的方括号中；没有单位时为 C</translation>
    </message>
    <message>
        <source>an angle as the first axis has</source>
        <translation>角度，与第一个轴一样</translation>
    </message>
    <message>
        <source>a length as the first axis has</source>
        <translation>长度，与第一个轴一样</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>基准的位置</translation>
    </message>
    <message>
        <source>deviations</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>what --values says; leave it out, since the file says it</source>
        <translation>--values 所指明的内容；请省略它，因为文件已有说明</translation>
    </message>
    <message>
        <source>positions of the reference for --invert-reference; deviations with the opposite sign say it in the file (// sign: correction)</source>
        <translation>--invert-reference 需要基准的位置；符号相反的偏差须在文件中说明 (// sign: correction)</translation>
    </message>
    <message>
        <source>values that rise by {slope} with the position</source>
        <translation>随位置以 {slope} 的斜率上升的值</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for all of these changes, {together}, but not for putting everything back if one fails; wait {seconds} s, or make fewer changes at a time</source>
        <translation>剩余的闪存操作足以完成所有这些更改（{together} 次），但其中一项失败时不足以全部恢复；等待 {seconds} s，或一次少做些更改</translation>
    </message>
    <message>
        <source>together these changes cost {together} flash operations, more than are possible now; wait {seconds} s, or make fewer changes at a time</source>
        <translation>这些更改共需 {together} 次闪存操作，超过目前可用的次数；等待 {seconds} s，或一次少做些更改</translation>
    </message>
    <message>
        <source>{doubt} Choose another source or column, or, if it is right all the same, name the column after axis {axis} in the file</source>
        <translation>{doubt}请选择其他源或列；如果确实无误，请在文件中以轴 {axis} 命名该列</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the backup was made, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>创建备份时轴 {axis} 是 {target}，而驱动器上现在是 {name}；请恢复各轴原来的顺序或名称，或从文件写入该表</translation>
    </message>
    <message>
        <source>the {what} of the table on the drive are in {unit}, and the new source is in {other}; write the table from its file, together with the source</source>
        <translation>驱动器上该表的{what}以 {unit} 为单位，而新的源以 {other} 为单位；请从文件写入该表，并同时设置源</translation>
    </message>
    <message>
        <source>the {what} are in {unit} in the backup, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>{what}在备份中以 {unit} 为单位，而驱动器现在以 {other} 为单位，同样的数值含义会不同；请将驱动器的单位改回 {unit}，或从文件写入该表</translation>
    </message>
    <message>
        <source>The table states no unit for the positions of dimension {number}; they are taken to be in {after}: {first} to {last}.</source>
        <translation>该表没有说明维度 {number} 的位置的单位；按 {after} 处理：{first} 至 {last}。</translation>
    </message>
    <message>
        <source>values of axis {axis}</source>
        <translation>轴 {axis} 的值</translation>
    </message>
    <message>
        <source>positions of dimension {number} of axis {axis}</source>
        <translation>轴 {axis} 维度 {number} 的位置</translation>
    </message>
    <message>
        <source>Axis {axis} was called {before} when the backup was made, and is called {after} now: see that it is the same axis.</source>
        <translation>创建备份时轴 {axis} 名为 {before}，现在名为 {after}：请确认是同一根轴。</translation>
    </message>
    <message>
        <source>The backup does not say in which unit axis {axis} was; its table is taken to be in {unit}.</source>
        <translation>备份未注明轴 {axis} 的单位；其表按 {unit} 处理。</translation>
    </message>
    <message>
        <source>The positions of dimension {number} are written in {unit} as they stand: the profile does not say the unit of {source}.</source>
        <translation>维度 {number} 的位置按原样以 {unit} 写入：配置文件没有说明 {source} 的单位。</translation>
    </message>
    <message>
        <source>axis {axis}, which is written first</source>
        <translation>先写入的轴 {axis}</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the numbers of the file were read in {unit}; leave the statement out</source>
        <translation>已指定单位 {stated}，而文件中的数是以 {unit} 读取的；请去掉该指定</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: it is not activated. Finish that write with &apos;axiscomp recover --finish&apos;, undo it with &apos;axiscomp recover --undo&apos;, or write again. The old state is kept in {backup}</source>
        <translation>一次未完成的写入使轴 {axis} 既非旧状态也非新状态：不予启用。请用 &apos;axiscomp recover --finish&apos; 完成该写入，用 &apos;axiscomp recover --undo&apos; 撤销，或重新写入。旧状态保存在 {backup}</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as http://user:password@host</source>
        <translation>{endpoint} 要求用户名和密码；请按 http://用户名:密码@主机 给出</translation>
    </message>
    <message>
        <source>{text} has no unit and is taken as {amount}, {fine}</source>
        <translation>{text} 没有单位，按 {amount}（即 {fine}）处理</translation>
    </message>
    <message>
        <source>{endpoint} asks for a user name and a password; give them as https://user:password@host</source>
        <translation>{endpoint} 要求用户名和密码；请按 https://用户名:密码@主机 给出</translation>
    </message>
    <message>
        <source>{path} is no position of axis {axis} before its compensation: name the register of its encoder</source>
        <translation>{path} 不是轴 {axis} 补偿前的位置：请指定其编码器的寄存器</translation>
    </message>
    <message>
        <source>&quot;{name}&quot;, which is taken to be a name without a unit</source>
        <translation>“{name}”，被当作不带单位的名称</translation>
    </message>
    <message>
        <source>a unit such as mm, um, inch, deg or arcsec, if {unit} is meant as one</source>
        <translation>若 {unit} 表示单位，则用 mm、um、inch、deg 或 arcsec 等</translation>
    </message>
    <message>
        <source>decimal points, and blanks between the numbers; nobody can tell a decimal comma from one that separates two numbers</source>
        <translation>使用小数点，数字之间用空格分隔；无法区分小数逗号与分隔两个数字的逗号</translation>
    </message>
    <message>
        <source>{key} without a value, or no {key}</source>
        <translation>不带值的 {key}，或不写 {key}</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>使用小数点的数字</translation>
    </message>
    <message>
        <source>several tables of {axes}</source>
        <translation>{axes} 有多个表</translation>
    </message>
    <message>
        <source>their sum, since the controller adds them; a table that is converted alone is a part of it</source>
        <translation>它们的和，因为控制器将其相加；单独转换的一个表只是其中一部分</translation>
    </message>
    <message>
        <source>&quot;{statement}&quot;, which switches a table of the file off</source>
        <translation>“{statement}”，它停用了文件中的表</translation>
    </message>
    <message>
        <source>tables that are in use; this one does not act on the machine</source>
        <translation>启用的表；该表对机床不起作用</translation>
    </message>
    <message>
        <source>one unit for positions and offsets, which the controller adds; a calibration file is read with --from {format}</source>
        <translation>位置和偏移须用同一单位，因为控制器将二者相加；校准文件用 --from {format} 读取</translation>
    </message>
    <message>
        <source>{count} lines that are taken to be headers, the first of them &quot;{line}&quot;</source>
        <translation>{count} 行被当作表头，其中第一行为“{line}”</translation>
    </message>
    <message>
        <source>decimal points, and a comma with a blank between the values; nobody can tell a decimal comma from one that separates two values</source>
        <translation>使用小数点，数值之间用逗号加空格分隔；无法区分小数逗号与分隔两个数值的逗号</translation>
    </message>
    <message>
        <source>numbers in {unit}, as the file says</source>
        <translation>数值的单位为 {unit}，如文件所述</translation>
    </message>
    <message>
        <source>{unit}, as the setting says</source>
        <translation>{unit}，如设置所述</translation>
    </message>
    <message>
        <source>{name}, which is changed by a statement of the program</source>
        <translation>{name}，被程序中的语句修改</translation>
    </message>
    <message>
        <source>the declaration alone; the table is that of the declaration, since statements are not computed</source>
        <translation>仅有声明；表取自声明，因为不计算语句</translation>
    </message>
    <message>
        <source>axis {axis}, and axis {before} in line {line}</source>
        <translation>轴 {axis}，而第 {line} 行为轴 {before}</translation>
    </message>
    <message>
        <source>the measurement of one axis; make a file for each axis</source>
        <translation>单个轴的测量；请为每个轴单独建立文件</translation>
    </message>
    <message>
        <source>{second}, and {first} in line {line}</source>
        <translation>{second}，而第 {line} 行为 {first}</translation>
    </message>
    <message>
        <source>one statement of it</source>
        <translation>只有一个声明</translation>
    </message>
    <message>
        <source>this statement before the header, since it holds for every line</source>
        <translation>此声明应写在标题行之前，因为它对所有行都有效</translation>
    </message>
    <message>
        <source>further sections behind EOF::</source>
        <translation>EOF:: 之后的其他段</translation>
    </message>
    <message>
        <source>one measurement in a file; make a file of each</source>
        <translation>每个文件一次测量；请将各次测量分成单独的文件</translation>
    </message>
    <message>
        <source>which it is: // values: deviation or // values: reference before the header, or --values</source>
        <translation>属于哪一种：在标题行之前写 // values: deviation 或 // values: reference，或用 --values</translation>
    </message>
    <message>
        <source>axis {axis} of the machine file</source>
        <translation>机床文件中的轴 {axis}</translation>
    </message>
    <message>
        <source>a position and an error in mm, with decimal points and without separators of thousands</source>
        <translation>一个位置和一个误差（mm），使用小数点，不用千位分隔符</translation>
    </message>
    <message>
        <source>a position without a forward mean</source>
        <translation>没有正向平均值的位置</translation>
    </message>
    <message>
        <source>for a run its direction and number, such as up2 or down1</source>
        <translation>若是一趟测量，则为其方向和序号，例如 up2 或 down1</translation>
    </message>
    <message>
        <source>sign: feedback or sign: command; where the values are encoder minus reference, leave the line out, and turn them with --scale -1</source>
        <translation>sign: feedback 或 sign: command；如果值是编码器值减参考值，请将该行删去，并用 --scale -1 取反</translation>
    </message>
    <message>
        <source>the table states no unit for its values, and its positions are in {positions}; state the unit of the values, in the file or with --value-unit</source>
        <translation>该表未注明值的单位，而其位置以 {positions} 为单位；请在文件中注明值的单位，或用 --value-unit 指定</translation>
    </message>
    <message>
        <source>the values for {column} have no unit, and the positions are in {positions}; state it in the header, as Z [mm], or as the setting {key} of the file that is read</source>
        <translation>{column} 的值没有单位，而位置以 {positions} 为单位；请在表头中注明，如 Z [mm]，或用所读文件的设置 {key} 指定</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. The positions have different units, and it is not stated which one that is: convert to a .csv file first, and that one with --value-unit, such as --value-unit mm, or, if the values correct the axis of one of the positions, state the target, such as #1 for the first</source>
        <translation>.TAMtbl 没有单位，驱动器按所补偿轴的单位读取其值。各位置的单位不同，且未说明是其中哪一个：请先转换为 .csv 文件，再用 --value-unit（如 --value-unit mm）转换该文件；若值补偿的是某个位置的轴，请指定目标轴，如第一个为 #1</translation>
    </message>
    <message>
        <source>{number} in a column with {whole}</source>
        <translation>含有 {whole} 的列中出现 {number}</translation>
    </message>
    <message>
        <source>numbers that show whether the point stands between thousands: no point in {number}, or the same decimals in {whole}</source>
        <translation>能看出点是否为千位分隔符的数字：{number} 不写点，或 {whole} 写出同样的小数位</translation>
    </message>
    <message>
        <source>the axis is taken to count from {from} to {to}, and steps of {distance} do not lead from one end over the targets to the other; say the grid of the table: its points, their distance, or what it may be off the curve (--points, --distance or --within)</source>
        <translation>假定轴从 {from} 计数到 {to}，而以 {distance} 为步距不能从一端经过各目标位置到达另一端；请给出表格的网格：点数、间距或与曲线的允许偏差（--points、--distance 或 --within）</translation>
    </message>
    <message>
        <source>the table in {slot} stays in flash, because {user} uses it too; free it there first, with a persistent write into another slot</source>
        <translation>{slot} 中的表仍保留在闪存中，因为 {user} 也在使用；请先在那里持久写入另一个表槽以释放它</translation>
    </message>
    <message>
        <source>Flash keeps the table in {slot}: after a reboot {axis} uses it again. Delete the table first (&apos;axiscomp delete&apos;) if it must not come back.</source>
        <translation>闪存中保留 {slot} 中的表：重启后 {axis} 会重新使用它。如果不应恢复，请先删除该表（&apos;axiscomp delete&apos;）。</translation>
    </message>
    <message>
        <source>the axis has the values of the record&apos;s table, {crc}, over other positions: write the record&apos;s table again (`axiscomp write --record`), or leave the record out</source>
        <translation>该轴有档案的表的值 {crc}，但位于其他位置：请重新写入档案的表（`axiscomp write --record`），或不用该档案</translation>
    </message>
    <message>
        <source>The table stays, and {source} is a position of another axis: its values belong to positions of the axis itself. Write the table that was made for this source.</source>
        <translation>表保持不变，而 {source} 是另一轴的位置：其值属于该轴自身的位置。请写入为该源制作的表。</translation>
    </message>
    <message>
        <source>it was measured with the table {crc} active, and {first} and {second} have the same values over other positions: merge onto the file of the one that was active (--onto)</source>
        <translation>测量时启用的是表 {crc}，而 {first} 和 {second} 在不同位置上有相同的值：请合并到当时启用的那个表的文件 (--onto)</translation>
    </message>
    <message>
        <source>{axis} is the name of axis {named} and the index of axis {numbered}; say name:{axis} or {index}</source>
        <translation>{axis} 既是轴 {named} 的名称，又是轴 {numbered} 的索引；请写 name:{axis} 或 {index}</translation>
    </message>
    <message>
        <source>there is no name on the drive</source>
        <translation>驱动器上没有名称</translation>
    </message>
    <message>
        <source>the program must define the target axes of the table in the order of the corrections: {axes}</source>
        <translation>程序必须按补偿值的顺序定义该表的目标轴：{axes}</translation>
    </message>
    <message>
        <source>the setting {key} of the format {format} says {value}, and the table goes from {column}</source>
        <translation>格式 {format} 的设置 {key} 为 {value}，而该表为 {column}</translation>
    </message>
    <message>
        <source>positions with {all} combinations in the first {count} data lines</source>
        <translation>前 {count} 个数据行中的位置有 {all} 种组合</translation>
    </message>
    <message>
        <source>a line for every combination of the positions; fit makes a table of scattered points</source>
        <translation>每种位置组合各一行；散点可用 fit 生成表</translation>
    </message>
    <message>
        <source>the first measurement is corrected and the second is not, so that they cannot be compared: save the record and correct the second one with `axiscomp compare --record`, or state in its file that its values are at 20 °C (// corrected: 20C)</source>
        <translation>第一次测量已修正而第二次未修正，因此不能比较：请保存档案并用 `axiscomp compare --record` 修正第二次测量，或在其文件中注明其值为 20 °C 时的值 (// corrected: 20C)</translation>
    </message>
    <message>
        <source>&quot;{text}&quot; can be read in two ways; write thousands without a sign between them</source>
        <translation>“{text}”有两种读法；请勿使用千位分隔符</translation>
    </message>
    <message>
        <source>a .TAMtbl has no units, and a drive takes its values in the unit of the axis that they correct. These are in {unit} and the positions in {positions}, none of which is that of the axis for certain: convert to a .csv file first, and that one with --value-unit and the unit of the axis, such as --value-unit {example}</source>
        <translation>.TAMtbl 没有单位，驱动器按所修正轴的单位取其值。这些值的单位是 {unit}，位置的单位是 {positions}，其中没有一个可以确定是该轴的单位：先转换为 .csv 文件，再用 --value-unit 和该轴的单位（例如 --value-unit {example}）转换该文件</translation>
    </message>
    <message>
        <source>sign: correction, and positions of the reference</source>
        <translation>sign: correction，而值是参考位置</translation>
    </message>
    <message>
        <source>no sign with positions of the reference, which are what they are; or deviations with their sign</source>
        <translation>参考位置保持原值，不带符号说明；或者给出带符号说明的偏差</translation>
    </message>
    <message>
        <source>the two directions of the track have no part of the way in common: make the table of one of them (--direction positive or negative)</source>
        <translation>连续测量的两个方向没有共同的路段:请用其中一个方向生成表（--direction positive 或 negative）</translation>
    </message>
    <message>
        <source>the table is looked up at the desired position of its sources (D); with position=actual at the actual one</source>
        <translation>表按其源轴的指令位置 (D) 查找；使用 position=actual 时按实际位置查找</translation>
    </message>
    <message>
        <source>the table is looked up at the actual position of its sources; with position=desired at the desired one (D)</source>
        <translation>表按其源轴的实际位置查找；使用 position=desired 时按指令位置 (D) 查找</translation>
    </message>
    <message>
        <source>max_points {number} of the source is left out: the table has {count} points</source>
        <translation>源文件的 max_points {number} 被省略：表有 {count} 个点</translation>
    </message>
    <message>
        <source>the encoder moves {slope} times as far as the targets</source>
        <translation>编码器的移动是目标位置的 {slope} 倍</translation>
    </message>
    <message>
        <source>1 within 1 %; correct the column of the encoder, or take it out of the file</source>
        <translation>1（偏差不超过 1 %）；请更正编码器列，或从文件中删除它</translation>
    </message>
    <message>
        <source>columns separated by , or ; instead of tabs</source>
        <translation>以 , 或 ; 而不是制表符分隔的列</translation>
    </message>
    <message>
        <source>a write that did not end has left axis {axis} in neither its old nor its new state: what can be read of it is half of that write. Finish it with &apos;axiscomp recover --finish&apos;, or undo it with &apos;axiscomp recover --undo&apos;. The old state is kept in {backup}</source>
        <translation>一次未完成的写入使轴 {axis} 既非旧状态也非新状态：读到的只是写了一半的内容。请用 &apos;axiscomp recover --finish&apos; 完成该写入，或用 &apos;axiscomp recover --undo&apos; 撤销。旧状态保存在 {backup}</translation>
    </message>
    <message>
        <source>the name of the table, {table}, says that its values correct {target}, but for axis {axis} {role}; choose another table or axis, or, if it is right all the same, write the table to this axis from its file first, and state the target as {statement} there</source>
        <translation>表的名称 {table} 表明其值修正 {target}，但对轴 {axis} 而言{role}；请选择其他表或轴；如果确实无误，请先从文件将该表写入此轴，并在写入时将目标轴注明为 {statement}</translation>
    </message>
    <message>
        <source>mm, or both units stated: that of the positions (--unit) and that of the errors (--value-unit)</source>
        <translation>mm，或同时给出两个单位：位置的单位 (--unit) 和误差的单位 (--value-unit)</translation>
    </message>
    <message>
        <source>kind: runs, or kind: averages (means of runs)</source>
        <translation>kind: runs，或 kind: averages（各趟次的平均值）</translation>
    </message>
    <message>
        <source>one mean for each target and direction</source>
        <translation>每个目标位置和方向一个平均值</translation>
    </message>
    <message>
        <source>the second measurement is of the drive with the serial number {found}, and the first one or its table is of the one with {known}; measure that drive, or, where it was replaced since, correct the line // drive: in the file of the second</source>
        <translation>第二次测量属于序列号为 {found} 的驱动器，而第一次测量或其表属于序列号为 {known} 的驱动器；请测量该驱动器，若此后已更换，请更正第二次测量文件中的 // drive: 行</translation>
    </message>
    <message>
        <source>measurements of the drive with the serial number {drive} and of the one with {other} cannot be joined; take those of one drive, and where it was replaced in between, correct the line // drive: of the files</source>
        <translation>序列号为 {drive} 的驱动器的测量和序列号为 {other} 的驱动器的测量不能合并；请只用一台驱动器的测量，若其间已更换，请更正各文件中的 // drive: 行</translation>
    </message>
    <message>
        <source>the record was made of a measurement of the drive with the serial number {measured}, and this is {found}; connect the drive that was measured, or, where it was replaced since, correct the line // drive: of the measurement&apos;s file and begin a new record with it</source>
        <translation>该档案由序列号为 {measured} 的驱动器的测量建立，而此处为 {found}；请连接所测量的驱动器，若此后已更换，请更正测量文件中的 // drive: 行，并用它另建一个档案</translation>
    </message>
    <message>
        <source>axis {axis} used {slot}, and the file of this slot is missing</source>
        <translation>轴 {axis} 曾使用 {slot}，但缺少该表槽的文件</translation>
    </message>
    <message>
        <source>the deletion of {slot} for axis {axis} can only be finished: the saved parameters that would bring its table back after a reboot are not known; the backup has the table</source>
        <translation>轴 {axis} 的 {slot} 的删除只能继续完成：重启后会恢复其表的已保存参数未知；备份中有该表</translation>
    </message>
    <message>
        <source>the line // drive: of the file says that the drive with the serial number {expected} was measured, and this one has {found}: connect that drive, or, where it was replaced since, correct the line or remove it</source>
        <translation>文件中的 // drive: 行说明所测量的是序列号为 {expected} 的驱动器，而此驱动器为 {found}：请连接所测量的驱动器，若此后已更换，请更正该行或将其删去</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, and another of its comments the serial number {serial}: a table is made of the measurement of one drive, so correct the wrong line, or leave it out</source>
        <translation>文件中为“{note}”，而另一行注释为序列号 {serial}：一个表由一个驱动器的测量生成，因此请更正有误的行，或将其删去</translation>
    </message>
    <message>
        <source>the drive does not read the table in {slot} as the layout of the profile has it: of dimension {dimension} the drive shows {found} where the layout has {expected}. Compare {layout} in the profile with the drive&apos;s table file</source>
        <translation>驱动器对 {slot} 中表的读取与描述文件的布局不一致：维度 {dimension}，驱动器显示 {found}，而按布局为 {expected}。请将描述文件中的 {layout} 与驱动器的表文件进行比较</translation>
    </message>
    <message>
        <source>dimension {number} of the table on the drive is one of {before}, and {source} is something else: one of them is a position, the other a temperature; write the table from its file, together with the source</source>
        <translation>驱动器上该表的维度 {number} 属于 {before}，而 {source} 是另一种量：一个是位置，另一个是温度；请从文件写入该表，并同时设置源</translation>
    </message>
    <message>
        <source>The table stays, its dimension {number} has positions of an axis, and the profile does not say what {source} is. Write the table that was made for this source.</source>
        <translation>表保持不变，其维度 {number} 为某轴的位置，而描述文件未说明 {source} 是什么。请写入为该源制作的表。</translation>
    </message>
    <message>
        <source>The backup of axis {axis} does not say with which profile it was made; its table is read with the profile {profile}.</source>
        <translation>轴 {axis} 的备份未注明是用哪个描述文件制作的；其表按描述文件 {profile} 读取。</translation>
    </message>
    <message>
        <source>the backup was made with the profile {before}, which has another layout of table files than {profile}: restore it with that profile (--profile), or, on a drive that needs the other one, write the table from its file</source>
        <translation>该备份是用描述文件 {before} 制作的，其表文件布局与 {profile} 不同：请用该描述文件恢复 (--profile)，或者在需要另一描述文件的驱动器上，从文件写入该表</translation>
    </message>
    <message>
        <source>The layout of table files in the profile {profile} has been changed since the backup was made: see that the table is right.</source>
        <translation>自制作备份以来，描述文件 {profile} 中表文件的布局已更改：请确认该表正确。</translation>
    </message>
    <message>
        <source>the register {path} is in {name} too</source>
        <translation>寄存器 {path} 也在 {name} 中</translation>
    </message>
    <message>
        <source>slot {slot} is in use by {user}, and an import does not move a table from one axis to another: write the table to axis {imported} from its file, and name the slot that it gets there in the configuration</source>
        <translation>表槽 {slot} 正由 {user} 使用，而导入不会把表从一个轴移到另一个轴：请从文件将该表写入轴 {imported}，并在配置中指定它在那里得到的表槽</translation>
    </message>
    <message>
        <source>interval of a square grid, or interval1 and interval2 of a grid RECTANGULAR</source>
        <translation>方形网格的 interval，或 RECTANGULAR 网格的 interval1 和 interval2</translation>
    </message>
    <message>
        <source>parameter {number} of {value}</source>
        <translation>值为 {value} 的参数 {number}</translation>
    </message>
    <message>
        <source>a number with a decimal point, to compare it with the setting {key} of {value}; the file does not say what unit it is in without one</source>
        <translation>带小数点的数字，以便与设置 {key} 的值 {value} 比较；没有小数点时，文件未说明其单位</translation>
    </message>
    <message>
        <source>{name} = {value}, with which the lengths of the table are in inches</source>
        <translation>{name} = {value}，此时表中的长度以英寸为单位</translation>
    </message>
    <message>
        <source>1; take the line out, and multiply positions and values in inches by 25.4</source>
        <translation>1；删除该行，并将以英寸为单位的位置和值乘以 25.4</translation>
    </message>
    <message>
        <source>what SECONDARY stands for, such as inch</source>
        <translation>SECONDARY 所代表的单位，例如 inch</translation>
    </message>
    <message>
        <source>counts of each axis for one primary-unit; without it what is in COUNTS stays in counts</source>
        <translation>每个 primary-unit 对应的各轴计数；未给出时 COUNTS 的数字仍以计数为单位</translation>
    </message>
    <message>
        <source>{key} ENGLISH of the rotary axis {axis}</source>
        <translation>回转轴 {axis} 的 {key} ENGLISH</translation>
    </message>
    <message>
        <source>METRIC, which is degrees there; inches are lengths</source>
        <translation>METRIC，在该轴上表示度；英寸是长度单位</translation>
    </message>
    <message>
        <source>two kinds of units in one table</source>
        <translation>一个表中有两种单位</translation>
    </message>
    <message>
        <source>the settings {key} and {key2}</source>
        <translation>设置 {key} 和 {key2}</translation>
    </message>
    <message>
        <source>the instrument says {line}: another number follows its first one, as in degrees, minutes and seconds; set it to one decimal number, or say what the number is with a pattern</source>
        <translation>仪器给出 {line}：第一个数字后面还有另一个数字，如度、分、秒那样；请将仪器设为单个小数，或用匹配模式指明数字</translation>
    </message>
    <message>
        <source>the axis lost its homing in mid-measurement, as after a restart of the drive; its positions are others after it is homed again: begin a new file</source>
        <translation>测量中途该轴失去了原点，如同驱动器重启之后；重新回零后其位置会不同：请另起一个新文件</translation>
    </message>
    <message>
        <source>the file says sign: {file}, and stated is {stated}: correct the one that is wrong</source>
        <translation>文件中写的是 sign: {file}，而指定的是 {stated}：请改正其中错误的一个</translation>
    </message>
    <message>
        <source>{file} says sign: command, and a table that was active holds feedback values: convert the file first, and take what is written</source>
        <translation>{file} 中写的是 sign: command，而曾启用的表存放反馈侧 (feedback) 的值：请先转换该文件，再使用写出的结果</translation>
    </message>
    <message>
        <source>the table that is active lies over other positions or sources than at the beginning; what was taken belongs to the one before: begin a new file</source>
        <translation>当前启用的表所对应的位置或源与开始时不同；已采集的值属于之前的表：请另起一个新文件</translation>
    </message>
    <message>
        <source>the values for {column} are in {unit}, and the positions that they are added to in {other}; state how many counts are one unit, with the setting {key} of the file that is read</source>
        <translation>{column} 的值以 {unit} 为单位，而这些值所加到的位置以 {other} 为单位；请用所读文件的设置 {key} 给出一个单位对应多少计数</translation>
    </message>
    <message>
        <source>the setting {key} for numbers in counts</source>
        <translation>对以计数为单位的数字给出的设置 {key}</translation>
    </message>
    <message>
        <source>the setting {key}, which says how many of them are one unit</source>
        <translation>设置 {key}，说明多少计数为一个单位</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, which is for files of measurements: a table holds reference minus encoder (sign: feedback), or what is added to the command (sign: command). Correct that line; where the values are encoder minus reference, leave it out, and turn them with --scale -1</source>
        <translation>文件中为“{note}”，这只用于测量文件：表中的值是参考值减编码器值 (sign: feedback)，或加到指令上的值 (sign: command)。请更正该行；如果值是编码器值减参考值，请将该行删去，并用 --scale -1 取反</translation>
    </message>
    <message>
        <source>the file says &quot;{note}&quot;, where one comment, sign: feedback or sign: command, says what the values are: correct that line, or leave it out, which means feedback</source>
        <translation>文件中为“{note}”，而此处应有一行注释 sign: feedback 或 sign: command，说明这些值是什么：请更正该行，或将其删去，即表示 feedback</translation>
    </message>
    <message>
        <source>1; as it stands in the file it follows the axis: leave --invert-reference out</source>
        <translation>1；文件中的参考值本来就跟随该轴：请去掉 --invert-reference</translation>
    </message>
    <message>
        <source>the record of this drive&apos;s flash operations was damaged, so all of them count as used up; reset the count with &apos;axiscomp status --reset-flash-count&apos;</source>
        <translation>此驱动器的闪存操作记录已损坏，因此视为全部用完；请用“axiscomp status --reset-flash-count”将计数复位</translation>
    </message>
    <message>
        <source>the flash operations that are left would do for the change, but not for putting everything back if it fails; wait {seconds} s</source>
        <translation>剩余的闪存操作足以完成更改，但失败时不足以全部恢复；请等待 {seconds} s</translation>
    </message>
    <message>
        <source>too many flash operations in a short time; wait {seconds} s</source>
        <translation>短时间内闪存操作过多；请等待 {seconds} s</translation>
    </message>
    <message>
        <source>{stated}, stated as the axis that the values of {column} correct, may be one of the sources or not, since their names do not tell it, and the numbers depend on it; state the target: {sources}</source>
        <translation>作为 {column} 的值所修正的轴而给出的 {stated} 可能是也可能不是源之一，因为源的名称没有说明，而数字取决于此；请给出目标轴：{sources}</translation>
    </message>
    <message>
        <source>an answer of the drive itself and not one that a cache or proxy in between has kept; connect to the drive without it</source>
        <translation>驱动器本身的应答，而不是中间的缓存或代理所保留的应答；请不经过它连接驱动器</translation>
    </message>
    <message>
        <source>no Content-Encoding but identity</source>
        <translation>除 identity 外没有 Content-Encoding</translation>
    </message>
    <message>
        <source>nothing after the bytes that Content-Length announces</source>
        <translation>Content-Length 所声明的字节之后没有任何内容</translation>
    </message>
    <message>
        <source>a Directory page with its Content-Length, or up to &lt;/html&gt;</source>
        <translation>带有 Content-Length 或直到 &lt;/html&gt; 的 Directory 页面</translation>
    </message>
    <message>
        <source>the file in {slot} is no table that the profile can read: it is in the backup as it is, but cannot be restored as the table of an axis</source>
        <translation>{slot} 中的文件不是描述文件能读取的表：它原样保存在备份中，但不能作为轴的表恢复</translation>
    </message>
    <message>
        <source>the drive has taken the command that stores the table in {slot}, but has counted no flash cycle for it ({cycles} before and after): it is not known to be in flash, and may be gone after a reboot</source>
        <translation>驱动器接受了保存 {slot} 中表的命令，但没有为此计入闪存擦写次数（前后均为 {cycles} 次）：无法确认该表已在闪存中，重启后可能丢失</translation>
    </message>
    <message>
        <source>what a write that did not end has left of axis {axis} is not known: the backup of its old state, {backup}, cannot be read. Write again or restore another backup, which puts an end to it</source>
        <translation>一次未完成的写入使轴 {axis} 处于何种状态不得而知：其旧状态的备份 {backup} 无法读取。请重新写入，或还原另一个备份，即可结束该写入</translation>
    </message>
    <message>
        <source>the unit {stated} is stated, and the setting {key} says {unit}; leave one of them out</source>
        <translation>已指定单位 {stated}，而设置 {key} 为 {unit}；请去掉其中一个</translation>
    </message>
    <message>
        <source>the setting {key} is &quot;{value}&quot;, expected a unit; that numbers are in the unit of the drive is stated as {option} of {command}, or as {key} beside the settings of a machine file</source>
        <translation>设置 {key} 为“{value}”，应为单位；数值采用驱动器单位，应通过 {command} 的 {option} 或机床文件中设置之外的 {key} 指定</translation>
    </message>
    <message>
        <source>&quot;{note}&quot;, as another comment says; leave one of them out</source>
        <translation>另一条注释所说的“{note}”；请去掉其中一条</translation>
    </message>
    <message>
        <source>{axes} as the setting {key}</source>
        <translation>设置 {key} 为 {axes}</translation>
    </message>
    <message>
        <source>an axis of the file: {axes}</source>
        <translation>文件中的轴：{axes}</translation>
    </message>
    <message>
        <source>{ranges}: nothing of what was measured first is measured again; measure over the targets of the first measurement</source>
        <translation>{ranges}：第一次测量的范围没有被再次测量；请在第一次测量的目标位置上测量</translation>
    </message>
    <message>
        <source>1; some values are whole turns away, since the instrument begins again at 360 deg: let it count on, or write -0.0001 in place of 359.9999 in the file</source>
        <translation>1；由于仪器在 360° 处重新开始，部分值相差整圈：请让其继续计数，或在文件中将 359.9999 写为 -0.0001</translation>
    </message>
    <message>
        <source>no installed font has {characters}, so that empty boxes would stand in the PDF: install one that has them, such as fonts-noto-cjk for Chinese and Japanese, or write the report as HTML</source>
        <translation>已安装的字体都不包含 {characters}，PDF 中会出现空方框：请安装包含这些字符的字体（中文和日文可用 fonts-noto-cjk），或将报告写成 HTML</translation>
    </message>
    <message>
        <source>the values of {table} correct {target}, but for axis {axis} {role}; choose another column, axis or source, or, if it is right all the same, state the target as {statement} when the file is read</source>
        <translation>{table} 的值修正 {target}，但对轴 {axis} 而言{role}；请选择其他列、轴或源；如果确实无误，请在读取文件时将目标轴注明为 {statement}</translation>
    </message>
    <message>
        <source>the file does not say what the values of {table} correct. They were converted for {target}, but for axis {axis} {role}: read the file again with these sources, or state its target</source>
        <translation>文件未注明 {table} 的值修正哪个轴。这些值是按{target}换算的，但对轴 {axis} 而言{role}：请用这些源重新读取文件，或注明其目标轴</translation>
    </message>
    <message>
        <source>a source is no position of an axis</source>
        <translation>有的源不是轴的位置</translation>
    </message>
    <message>
        <source>the table was made for a position before the compensation, and {source} is one after it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at set)</source>
        <translation>该表是按补偿前的位置生成的，而 {source} 是补偿后的位置：请选择其他源，或根据其测量或原控制器的文件按此源重新生成表 (命令行用 --lookup-at set)</translation>
    </message>
    <message>
        <source>the table was made for a position after the compensation, and {source} is one before it: choose another source, or make the table anew for this one, from its measurement or the file of its controller (on the command line with --lookup-at encoder)</source>
        <translation>该表是按补偿后的位置生成的，而 {source} 是补偿前的位置：请选择其他源，或根据其测量或原控制器的文件按此源重新生成表 (命令行用 --lookup-at encoder)</translation>
    </message>
    <message>
        <source>the instrument says {line}: it is not clear where its number begins and ends; set it to one decimal number and its unit, or say what the number is with a pattern</source>
        <translation>仪器给出 {line}：不清楚其中的数字从哪里开始、到哪里结束；请将仪器设为单个小数及其单位，或用匹配模式指明数字</translation>
    </message>
    <message>
        <source>another program has replaced, changed or deleted it since it was opened; look which values it has before you go on with it</source>
        <translation>打开之后，另一个程序已替换、更改或删除了该文件；继续之前请检查其中有哪些值</translation>
    </message>
    <message>
        <source>column {column}, and values: {said}</source>
        <translation>列 {column}，以及 values: {said}</translation>
    </message>
    <message>
        <source>one of the two; a column value goes with both</source>
        <translation>两者之一；列名 value 两种都可用</translation>
    </message>
    <message>
        <source>the controller adds the tables for {axis}: the sign of each is converted, and each is compared, as if it were alone</source>
        <translation>控制器会将 {axis} 的各个表相加：每个表的符号转换和比较都按该表单独使用进行</translation>
    </message>
    <message>
        <source>a second table that belongs to the same motor</source>
        <translation>属于同一电机的第二个表</translation>
    </message>
    <message>
        <source>one for each motor; the last one counts</source>
        <translation>每个电机一个；以最后一个为准</translation>
    </message>
    <message>
        <source>begins again at the other end</source>
        <translation>从另一端循环</translation>
    </message>
    <message>
        <source>another axis than that of the first source</source>
        <translation>与第一个源不同的轴</translation>
    </message>
    <message>
        <source>one number; line {line} gives it another one for the next pass of the loop</source>
        <translation>一个数字；第 {line} 行为循环的下一轮赋予了另一个</translation>
    </message>
    <message>
        <source>one number; another part of the program gives it another one in line {line}</source>
        <translation>一个数字；程序的另一部分在第 {line} 行赋予了另一个</translation>
    </message>
    <message>
        <source>a name that got a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether that of line {line} counts</source>
        <translation>在 IF、ELSE、SWITCH、LOOP、WHILE 和 ON 之外赋予了数字的名称；第 {line} 行的数字是否有效只有控制器知道</translation>
    </message>
    <message>
        <source>a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only the controller knows whether this one counts</source>
        <translation>在 IF、ELSE、SWITCH、LOOP、WHILE 和 ON 之外的数字；此数字是否有效只有控制器知道</translation>
    </message>
    <message>
        <source>numbers for the elements of {name} alone; what else changes the array behind them is not computed</source>
        <translation>仅给 {name} 的元素赋数值；之后以其他方式对数组的修改不计算</translation>
    </message>
    <message>
        <source>The new table is volatile: after a reboot the axis has the old, persistent one again, or none where the parameters have been saved since then.</source>
        <translation>新表是易失的：重启后该轴将恢复原来的持久表；如果此后保存过参数，则没有表。</translation>
    </message>
    <message>
        <source>the setting {key} says {value} for tables of different axes, {axes}; choose one of the tables (--table), or leave the setting out</source>
        <translation>设置 {key} 为不同轴 {axes} 的表指定了 {value}；请选择其中一个表 (--table)，或去掉该设置</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the set position: use it with such sources only</source>
        <translation>新文件不会说明驱动器必须按给定位置查表：请只与这样的来源一起使用</translation>
    </message>
    <message>
        <source>the new file does not say that the drive has to look it up at the encoder position: use it with such sources only</source>
        <translation>新文件不会说明驱动器必须按编码器位置查表：请只与这样的来源一起使用</translation>
    </message>
    <message>
        <source>the new file does not say that the drive with the serial number {serial} was measured, as its source does: use it for that drive only</source>
        <translation>与源文件不同，新文件不会说明所测量的是序列号为 {serial} 的驱动器：请只用于该驱动器</translation>
    </message>
    <message>
        <source>several tables are called {table}; choose one by its number, such as #1: {alike}</source>
        <translation>有多个表名为 {table}；请按编号选择，例如 #1：{alike}</translation>
    </message>
    <message numerus="yes">
        <source>{file} is not a valid list of positions: {count} problems</source>
        <comment>{file} is not a valid list of positions: one problem</comment>
        <translation>
            <numerusform>{file} 不是有效的位置列表：{count} 个问题</numerusform>
        </translation>
    </message>
    <message>
        <source>{file} is UTF-16 text; save it as UTF-8 text</source>
        <translation>{file} 是 UTF-16 编码的文本；请保存为 UTF-8 编码的文本</translation>
    </message>
    <message>
        <source>one value for each target, direction and run, or a number for each run</source>
        <translation>每个目标位置、方向和趟次一个值，或每一趟一个编号</translation>
    </message>
    <message>
        <source>nobody has published that the numbers begin at line N{first} (first-record): compare with a file of this controller</source>
        <translation>编号从行 N{first} 开始（first-record）未经公开：请与该控制器的文件比较</translation>
    </message>
    <message>
        <source>nobody has published that a value is at most {most} (largest-step): compare with a file of this controller</source>
        <translation>值最多为 {most}（largest-step）未经公开：请与该控制器的文件比较</translation>
    </message>
    <message>
        <source>this counts only with {member}, which is missing</source>
        <translation>此项须与 {member} 一起才有效，但缺少后者</translation>
    </message>
    <message>
        <source>it states no term of the uncertainty</source>
        <translation>其中没有给出任何不确定度分量</translation>
    </message>
    <message>
        <source>the {what} were in {unit} when the write began, and the drive has them in {other} now, so that the same numbers would mean something else; set the unit on the drive to {unit} again, or write the table from its file</source>
        <translation>{what}在写入开始时以 {unit} 为单位，而驱动器现在以 {other} 为单位，同样的数值含义会不同；请将驱动器的单位改回 {unit}，或从文件写入该表</translation>
    </message>
    <message>
        <source>axis {axis} was {target} when the write began, and is {name} on the drive now; give the axes the order or the names that they had, or write the table from its file</source>
        <translation>写入开始时轴 {axis} 是 {target}，而驱动器上现在是 {name}；请恢复各轴原来的顺序或名称，或从文件写入该表</translation>
    </message>
    <message>
        <source>the {what} of the record&apos;s table were in {unit} when it was written, and the drive has them in {other} now, so that the same numbers mean something else; set the unit on the drive to {unit} again, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>档案的表的{what}在写入时以 {unit} 为单位，而驱动器现在以 {other} 为单位，同样的数值含义不同；请将驱动器的单位改回 {unit}，或重新写入档案的表（`axiscomp write --record`）</translation>
    </message>
    <message>
        <source>an unknown unit</source>
        <translation>未知单位</translation>
    </message>
    <message>
        <source>the record does not say in which unit the axis was when its table was written, and in {unit}, as the axis is now, none of its tables is the one on the drive: set the unit that the axis had, or write the record&apos;s table again (`axiscomp write --record`)</source>
        <translation>档案没有注明写入其表时轴的单位，而按轴现在的单位 {unit}，档案中没有一个表与驱动器上的表一致：请设回轴原来的单位，或重新写入档案的表（`axiscomp write --record`）</translation>
    </message>
    <message>
        <source>{example}: the file says {value}</source>
        <translation>{example}：文件中为 {value}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller takes the axis to be at {moved}</source>
        <translation>编码器读数为 {place} 处，控制器认为轴位于 {moved}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller takes {axis} to be at {moved}</source>
        <translation>各编码器读数为 {place} 处，控制器认为 {axis} 位于 {moved}</translation>
    </message>
    <message>
        <source>where the encoder reads {place} the controller adds {value} to the position of {axis}</source>
        <translation>编码器读数为 {place} 处，控制器给 {axis} 的位置加上 {value}</translation>
    </message>
    <message>
        <source>where the encoders read {place} the controller adds {value} to the position of {axis}</source>
        <translation>各编码器读数为 {place} 处，控制器给 {axis} 的位置加上 {value}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder to {moved}</source>
        <translation>指令位置为 {place} 时，控制器使编码器移到 {moved}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves the encoder of {axis} to {moved}</source>
        <translation>指令位置为 {place} 时，控制器使 {axis} 的编码器移到 {moved}</translation>
    </message>
    <message>
        <source>commanded to {place}, the controller moves {target} by {value}</source>
        <translation>指令位置为 {place} 时，控制器使 {target} 移动 {value}</translation>
    </message>
    <message>
        <source>the configuration names the table in {slot} for axis {axis}, but the drive has none there: write the table to the axis from its file and name the slot that it gets in the configuration, or write it into {slot} with &apos;axiscomp write --slot {slot}&apos;</source>
        <translation>配置为轴 {axis} 指定了 {slot} 中的表，但驱动器的该表槽中没有表：请从文件将该表写入该轴，并在配置中指定它得到的表槽，或用 &apos;axiscomp write --slot {slot}&apos; 将其写入 {slot}</translation>
    </message>
    <message>
        <source>{reason}; putting the old state back failed too ({rollback}). Do not activate the axis: &apos;axiscomp recover&apos; says how the write can be finished or undone. The old state is kept in {backup}</source>
        <translation>{reason}；恢复旧状态也失败（{rollback}）。不要启用该轴：&apos;axiscomp recover&apos; 会说明如何完成或撤销该写入。旧状态保存在 {backup}</translation>
    </message>
    <message>
        <source>{endpoint} refuses the user name or the password that was given; in an address %40 stands for @, %3A for :, %2F for /, %23 for # and %25 for %</source>
        <translation>{endpoint} 拒绝所给的用户名或密码；在地址中 @ 写作 %40，: 写作 %3A，/ 写作 %2F，# 写作 %23，% 写作 %25</translation>
    </message>
    <message>
        <source>write http://user:password@host[:port], and in user name and password %40 for @, %3A for :, %2F for /, %3F for ?, %23 for # and %25 for %</source>
        <translation>请写作 http://用户名:密码@主机[:端口]，用户名和密码中 @ 写作 %40，: 写作 %3A，/ 写作 %2F，? 写作 %3F，# 写作 %23，% 写作 %25</translation>
    </message>
    <message>
        <source>the source of dimension {dimension} of axis {ofAxis} is missing</source>
        <translation>缺少轴 {ofAxis} 的维度 {dimension} 的源</translation>
    </message>
    <message>
        <source>a machine cannot be called {name}: a name has no control characters</source>
        <translation>机床不能命名为 {name}：名称中不能有控制字符</translation>
    </message>
    <message>
        <source>the name of axis {axis}</source>
        <translation>轴 {axis} 的名称</translation>
    </message>
    <message>
        <source>the units of the table of {axis}</source>
        <translation>{axis} 的表的单位</translation>
    </message>
    <message>
        <source>{file} is a measurement, not a table; make a table of it with &apos;axiscomp fit&apos; or on the pages Measure and Fit; if it is a table all the same, name its format</source>
        <translation>{file} 是测量数据，不是表：用 &apos;axiscomp fit&apos;，或用“测量”和“拟合”选项卡由它生成表；如果它确实是表，请指明其格式</translation>
    </message>
    <message>
        <source>The open record will not note this write: {reason}.</source>
        <translation>打开的档案不会记下这次写入：{reason}。</translation>
    </message>
    <message>
        <source>nothing says for which measuring system of axis {axis} the table is: it is written for 0; the setting {key} states another one</source>
        <translation>未说明该表用于轴 {axis} 的哪个测量系统：按 0 写入；设置 {key} 可指定另一个</translation>
    </message>
    <message>
        <source>a table for {element} alone</source>
        <translation>仅用于 {element} 的表</translation>
    </message>
    <message>
        <source>CompPos and CompPos2 of the motor; the table is taken for both, and written for both</source>
        <translation>电机的 CompPos 和 CompPos2；该表视为用于两者，并按两者写入</translation>
    </message>
    <message>
        <source>axis {axis}, whose numbers are taken to be in mm</source>
        <translation>轴 {axis}，其数值按 mm 处理</translation>
    </message>
    <message>
        <source>the setting {key} where the axis is rotary</source>
        <translation>若为旋转轴，则给出设置 {key}</translation>
    </message>
</context>
<context>
    <name>FileFilter</name>
    <message>
        <source>Compensation data</source>
        <translation>补偿数据</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>测量</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Record of the compensation (axiscomp write --record), which notes the proof</source>
        <translation>记载验证结果的补偿档案 (axiscomp write --record)</translation>
    </message>
    <message>
        <source>List the axes of one or several drives</source>
        <translation>列出一台或多台驱动器的轴</translation>
    </message>
    <message>
        <source>Also try all serial ports of this computer; without --drive, the connections of the window too</source>
        <translation>同时尝试本计算机的所有串口；未给出 --drive 时，也尝试窗口程序中的连接</translation>
    </message>
    <message>
        <source>Try the usual baud rates at every serial port</source>
        <translation>在每个串口尝试常用波特率</translation>
    </message>
    <message>
        <source>Also ask these addresses over http: 192.168.1.0/24, 192.168.1.10-40 or one address, at most 1024, with :PORT for another port than 80</source>
        <translation>同时通过 http 询问以下地址：192.168.1.0/24、192.168.1.10-40 或单个地址，最多 1024 个，端口不是 80 时加 :PORT</translation>
    </message>
    <message>
        <source>Save everything that this program can change on a whole drive, all axes, to one file</source>
        <translation>将整台驱动器（所有轴）上本程序可更改的全部内容保存到一个文件</translation>
    </message>
    <message>
        <source>File to write; standard output without it, or with -</source>
        <translation>要写出的文件；未给出或为 - 时写到标准输出</translation>
    </message>
    <message>
        <source>Restore a whole drive from a backup file, with verified writes; all of them are planned first</source>
        <translation>由备份文件还原整台驱动器，写入均经校验；先为全部写入制定计划</translation>
    </message>
    <message>
        <source>File that `axiscomp backup` wrote; - for standard input</source>
        <translation>由 `axiscomp backup` 写出的文件；- 表示标准输入</translation>
    </message>
    <message>
        <source>Restore to a drive with another serial number, such as a replacement</source>
        <translation>还原到序列号不同的驱动器，例如更换后的驱动器</translation>
    </message>
    <message>
        <source>Show what would be written without writing it</source>
        <translation>只显示将写入的内容，不写入</translation>
    </message>
    <message>
        <source>Where the axis really is: a register of the drive, serial:/dev/ttyUSB1?baud=9600, - for lines on standard input, or typed</source>
        <translation>轴实际位置的来源：驱动器的寄存器、serial:/dev/ttyUSB1?baud=9600、-（标准输入的各行）或 typed（手动输入）</translation>
    </message>
    <message>
        <source>Unit of the instrument; of a register it is that of the axis, of lines the one behind the number unless given</source>
        <translation>仪器的单位；未给出时，寄存器用轴的单位，行用数字后面的单位</translation>
    </message>
    <message>
        <source>The instrument counts the other way</source>
        <translation>仪器的计数方向相反</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0 (0 unless given)</source>
        <translation>仪器示值为 0 时轴的位置（默认：0）</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line, its first group or all of it; the first number of the line unless given</source>
        <translation>用于匹配一行中数字的正则表达式，取其第一个分组，无分组则取全部匹配；未给出时取该行的第一个数字</translation>
    </message>
    <message>
        <source>Send this to the serial instrument before each reading, with \r and \n for line ends</source>
        <translation>每次读数前向串口仪器发送此内容，行尾用 \r 和 \n 表示</translation>
    </message>
    <message>
        <source>Register of the raw position; the profile&apos;s unless given</source>
        <translation>原始位置的寄存器；未给出时用描述文件中的寄存器</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within so many mm or deg, and readings may differ by as much (0.001 unless given)</source>
        <translation>编码器变动不超过此值（mm 或 deg）时视为轴已静止，读数之间也允许相差这么多（默认：0.001）</translation>
    </message>
    <message>
        <source>So many seconds, before anything is taken (1 unless given)</source>
        <translation>开始采集前轴须静止的秒数（默认：1）</translation>
    </message>
    <message>
        <source>Readings that make a value (10 unless given)</source>
        <translation>构成一个值的读数次数（默认：10）</translation>
    </message>
    <message>
        <source>Readings per second, 10 to 50 (20 unless given)</source>
        <translation>每秒读数次数，10 至 50（默认：20）</translation>
    </message>
    <message>
        <source>Take the values of a measuring plan while something else moves the axis</source>
        <translation>在由其他装置移动轴的同时，采集测量计划的值</translation>
    </message>
    <message>
        <source>Plan as axiscomp targets writes it</source>
        <translation>由 axiscomp targets 写出的测量计划</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>值的文件；已有的文件从其结尾处继续</translation>
    </message>
    <message>
        <source>axiscomp never moves an axis: the machine&apos;s control or a person does.</source>
        <translation>axiscomp 从不移动轴：轴由机床数控系统或人来移动。</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>示例：</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to a servo drive, activates them, and checks the drive&apos;s output against the table.</source>
        <translation>将测得的轴误差的补偿表写入伺服驱动器，启用补偿，并将驱动器的输出与表比较。</translation>
    </message>
    <message>
        <source>Show the version</source>
        <translation>显示版本</translation>
    </message>
    <message>
        <source>ENDPOINT is http://host[:port], https://host[:port], serial:DEVICE[?baud=N] or demo: (a virtual drive inside the program). AXISCOMP_DRIVE is the default of --drive. `axiscomp COMMAND --help` has more.</source>
        <translation>ENDPOINT 为 http://host[:port]、https://host[:port]、serial:DEVICE[?baud=N] 或 demo:（程序内部的虚拟驱动器）。--drive 的默认值取自 AXISCOMP_DRIVE。更多内容见 `axiscomp COMMAND --help`。</translation>
    </message>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>在标准输出上输出一个 JSON 文档</translation>
    </message>
    <message>
        <source>Files on this computer</source>
        <translation>本计算机上的文件</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Compare measurements before and after a compensation, and with what was promised</source>
        <translation>比较补偿前后的测量，并与预期效果对照</translation>
    </message>
    <message>
        <source>on: the second measurement was made with the table of the record active, where its file does not say it</source>
        <translation>on：第二次测量时档案中的表处于启用状态（文件未注明时）</translation>
    </message>
    <message>
        <source>Add the second measurement and the verdict to the record</source>
        <translation>将第二次测量和判定加入档案</translation>
    </message>
    <message>
        <source>Compensation parameters of a TAM configuration: show them, take them from a drive, or bring them to one</source>
        <translation>TAM 配置的补偿参数：显示、从驱动器获取或写入驱动器</translation>
    </message>
    <message>
        <source>show, export (to the file) or import (from it)</source>
        <translation>show（显示）、export（到文件）或 import（自文件）</translation>
    </message>
    <message>
        <source>TAM configuration (.TAMcfg)</source>
        <translation>TAM 配置 (.TAMcfg)</translation>
    </message>
    <message>
        <source>export: take the parameters from this configuration in place of a drive</source>
        <translation>export：从此配置而不是从驱动器获取参数</translation>
    </message>
    <message>
        <source>export: write this file instead, and leave the other one as it is</source>
        <translation>export：改为写出此文件，原文件保持不变</translation>
    </message>
    <message>
        <source>Name or serial number of the station in the file; without it the one with the drive&apos;s serial number</source>
        <translation>文件中站的名称或序列号；未给出时取与驱动器序列号相同的站</translation>
    </message>
    <message>
        <source>Accept a station with another serial number than the drive&apos;s</source>
        <translation>接受序列号与驱动器不同的站</translation>
    </message>
    <message>
        <source>Only the registers Table and Dim1Source to Dim3Source of the axes are read and written. Everything else in the file stays as it is, and tables stay on the drive. Importing never switches a compensation on.</source>
        <translation>只读写各轴的寄存器 Table 以及 Dim1Source 至 Dim3Source。文件中的其他内容保持不变，表保留在驱动器上。导入不会开启补偿。</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>示例：</translation>
    </message>
    <message>
        <source>Convert a table file to another format</source>
        <translation>将表文件转换为另一种格式</translation>
    </message>
    <message>
        <source>File to read; - for standard input</source>
        <translation>要读取的文件；- 表示标准输入</translation>
    </message>
    <message>
        <source>File to write, replaced if it exists; - for standard output</source>
        <translation>要写出的文件，已存在则替换；- 表示标准输出</translation>
    </message>
    <message>
        <source>Format of the output, if its name leaves it open</source>
        <translation>输出的格式（由文件名无法确定时）</translation>
    </message>
    <message>
        <source>Unit of the values in a .TAMtbl, which does not say it; by default that of the positions</source>
        <translation>.TAMtbl 中值的单位（文件中未注明）；默认与位置的单位相同</translation>
    </message>
    <message>
        <source>Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl</source>
        <translation>允许将超过范围 1 % 或斜率超过 0.1 的补偿值写入 .TAMtbl</translation>
    </message>
    <message>
        <source>Mark the table persistent: the drive stores it</source>
        <translation>将表标为持久：驱动器存储该表</translation>
    </message>
    <message>
        <source>Mark the table volatile (without either: as the input is)</source>
        <translation>将表标为易失（两者均未给出时与输入相同）</translation>
    </message>
    <message>
        <source>Name of the table</source>
        <translation>表的名称</translation>
    </message>
    <message>
        <source>Delete the table of an axis, or one that no axis uses, and free its slot</source>
        <translation>删除轴的表或没有轴使用的表，并释放其表槽</translation>
    </message>
    <message>
        <source>Delete the table in this slot, small1 to small8, large1 or large2, which no axis uses</source>
        <translation>删除此表槽（small1 至 small8、large1 或 large2）中没有轴使用的表</translation>
    </message>
    <message>
        <source>Show what would be deleted without deleting it</source>
        <translation>只显示将删除的内容，不删除</translation>
    </message>
    <message>
        <source>The compensation must be off. The axis then uses no table, also after a reboot; its sources stay. What is deleted is kept in a backup: `axiscomp restore` brings it back.</source>
        <translation>补偿必须已关闭。删除后该轴不使用表，重启后也是如此；其源保留。删除的内容保存在备份中：可用 `axiscomp restore` 恢复。</translation>
    </message>
    <message>
        <source>Write an example calibration file (CSV)</source>
        <translation>写出一个示例校准文件 (CSV)</translation>
    </message>
    <message>
        <source>Number of dimensions: 1, 2 or 3</source>
        <translation>维数：1、2 或 3</translation>
    </message>
    <message>
        <source>Number of tables (2 unless given)</source>
        <translation>表的个数（默认：2）</translation>
    </message>
    <message>
        <source>Table file to write, replaced if it exists; - for standard output. Without it nothing is written</source>
        <translation>要写出的表文件，已存在则替换；- 表示标准输出。未给出时不写出任何内容</translation>
    </message>
    <message>
        <source>Begin a record of the compensation (.axcal): measurement, table and what it promises, for compare and report</source>
        <translation>新建补偿档案 (.axcal)：测量、表及其预期效果，供 compare 和 report 使用</translation>
    </message>
    <message>
        <source>Write this column of points only, where the format holds one table</source>
        <translation>只写出点测量的这一列（格式只能容纳一个表时）</translation>
    </message>
    <message>
        <source>Curve and grid</source>
        <translation>曲线和网格</translation>
    </message>
    <message>
        <source>Curve through the means: linear (the default), cubic, spline, smooth or harmonic</source>
        <translation>通过各平均值的曲线：linear（默认）、cubic、spline、smooth 或 harmonic</translation>
    </message>
    <message>
        <source>Of the method smooth, and of points and tracks; by cross-validation unless given</source>
        <translation>方法 smooth 以及点和轨迹的平滑度；未给出时由交叉验证确定</translation>
    </message>
    <message>
        <source>Known periods, such as the lead of the screw, fitted by the method smooth</source>
        <translation>用方法 smooth 拟合的已知周期，例如丝杠导程</translation>
    </message>
    <message>
        <source>Harmonics of each period, and of the method harmonic, the fundamental counted (1 unless given)</source>
        <translation>每个周期以及 harmonic 的谐波数，含基波（默认：1）</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>模数轴一转的长度，例如 360：表的末端与起点相同</translation>
    </message>
    <message>
        <source>Which runs the table is made of: mean of both (the default), positive or negative; both makes a table for each, for controllers that keep two</source>
        <translation>由哪些趟生成表：mean（双向平均，默认）、positive 或 negative；both 为每个方向各生成一个表，用于保存两个表的控制器</translation>
    </message>
    <message>
        <source>temperature: a table over position and temperature, from runs in several thermal states; --points and --distance take a second number for it</source>
        <translation>temperature：由多个热状态下的各趟生成随位置和温度变化的表；--points 和 --distance 再取第二个数字用于温度</translation>
    </message>
    <message>
        <source>Even grid with N points, for each axis or for all; unless given, that of the targets, where they are even</source>
        <translation>N 点的均匀网格，用于各轴或所有轴；未给出时取目标位置的网格（若目标位置间隔均匀）</translation>
    </message>
    <message>
        <source>Even grid with spacing D, for each axis or for all</source>
        <translation>间距为 D 的均匀网格，用于各轴或所有轴</translation>
    </message>
    <message>
        <source>The fewest points that leave no more than this to the curve, in mm or deg</source>
        <translation>与曲线之差不超过此值（mm 或 deg）的最少点数</translation>
    </message>
    <message>
        <source>Let the grid extend beyond the targets, where the end values are held</source>
        <translation>允许网格超出目标位置，超出部分保持端值</translation>
    </message>
    <message>
        <source>Speed of the axis in mm/s or deg/s, for the steps of the velocity that are told</source>
        <translation>轴的速度，单位 mm/s 或 deg/s，用于计算所报告的速度跳变</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>零点、斜率和漂移</translation>
    </message>
    <message>
        <source>Where the table is 0: home, first (the first target), mean, keep, or a position; home where it is known and measured, else first, unless given</source>
        <translation>表在何处为 0：home（原点）、first（首目标位置）、mean（平均）、keep（保持不变）或一个位置；未给出时，原点已知且在测量范围内则用 home，否则用 first</translation>
    </message>
    <message>
        <source>Home position of the axis</source>
        <translation>轴的原点位置</translation>
    </message>
    <message>
        <source>Take the slope out, for straightness: lsq (least squares) or ends</source>
        <translation>去除斜率，用于直线度：lsq（最小二乘）或 ends（两端）</translation>
    </message>
    <message>
        <source>Take the drift of the runs out before they are averaged: offset or trend</source>
        <translation>求平均前先去除各趟的漂移：offset 或 trend</translation>
    </message>
    <message>
        <source>State of the drive</source>
        <translation>驱动器状态</translation>
    </message>
    <message>
        <source>Where the drive looks the table up: encoder (before the compensation) or set (after it); with --onto drive by its source</source>
        <translation>驱动器查表所用的位置：encoder（补偿前）或 set（补偿后）；--onto drive 时由其源决定</translation>
    </message>
    <message>
        <source>What was active while it was measured, where the file does not say it: off, on, or the file of the table</source>
        <translation>测量时启用的补偿（文件未注明时）：off、on 或表文件</translation>
    </message>
    <message>
        <source>Merge residuals onto the table that was active: its file, or drive for the one that the axis uses (--drive, --axis)</source>
        <translation>将残差合并到测量时启用的表：给出其文件，或用 drive 表示该轴使用的表（--drive、--axis）</translation>
    </message>
    <message>
        <source>Factor for the residuals before they are merged (1); below 1, such as 0.7, where the machine responds sluggishly</source>
        <translation>合并前残差所乘的增益（默认：1）；机床响应迟缓时小于 1，如 0.7</translation>
    </message>
    <message>
        <source>Points and tracks</source>
        <translation>点和轨迹</translation>
    </message>
    <message>
        <source>Remove the alignment of the artefact: rigid (position and rotation), rigid:X (rotated so that lines along X have no slope), or scale (its scale as well)</source>
        <translation>去除标准器放置状态的影响：rigid（位置和旋转）、rigid:X（旋转到沿 X 的直线没有斜率）或 scale（同时去除比例）</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one: smooth or nearest; refused unless given</source>
        <translation>远离所有测量点的网格点：smooth 或 nearest；未给出时拒绝</translation>
    </message>
    <message>
        <source>Give values that do not fit the others less weight</source>
        <translation>降低与其他值不符的值的权</translation>
    </message>
    <message>
        <source>Make a compensation table of a measurement, and foretell what it does</source>
        <translation>由测量生成补偿表，并预测其效果</translation>
    </message>
    <message>
        <source>List the table formats, or describe one: its limits, rules and settings</source>
        <translation>列出表的格式，或说明其中一种：限制、规则和设置</translation>
    </message>
    <message>
        <source>One format: its rules, limits and settings</source>
        <translation>一种格式：规则、限制和设置</translation>
    </message>
    <message>
        <source>All of them, as the page docs/formats.md</source>
        <translation>所有格式，输出为页面 docs/formats.md</translation>
    </message>
    <message>
        <source>The formats of measurements instead of those of tables</source>
        <translation>列出测量的格式，而不是表的格式</translation>
    </message>
    <message>
        <source>Check a file and report its format, grid, tables and problems</source>
        <translation>检查文件，报告其格式、网格、表和问题</translation>
    </message>
    <message>
        <source>Calibration file or table; - for standard input</source>
        <translation>校准文件或表；- 表示标准输入</translation>
    </message>
    <message>
        <source>Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances</source>
        <translation>判定一次测量：GB/T 17421.2 (ISO 230-2) 指标、漂移、离群值、公差</translation>
    </message>
    <message>
        <source>Rule that proposes outliers: mad (the default), grubbs or none</source>
        <translation>提出离群值的准则：mad（默认）、grubbs 或 none</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw, in mm or deg</source>
        <translation>轴的已知周期，例如丝杠导程，单位 mm 或 deg</translation>
    </message>
    <message>
        <source>Show the figures of VDI/DGQ 3441 as well</source>
        <translation>同时显示 VDI/DGQ 3441 的指标</translation>
    </message>
    <message>
        <source>Print the interpolated value at a position, as the drive or the controller of the file computes it</source>
        <translation>输出某一位置的插值，算法与驱动器或文件所属控制器相同</translation>
    </message>
    <message>
        <source>Calibration file or table</source>
        <translation>校准文件或表</translation>
    </message>
    <message>
        <source>X [Y [Z]], one number per dimension; may be negative</source>
        <translation>X [Y [Z]]，每维一个数字；可以为负</translation>
    </message>
    <message>
        <source>File with one position per line, - for standard input; prints one result per line</source>
        <translation>每行一个位置的文件，- 表示标准输入；每行输出一个结果</translation>
    </message>
    <message>
        <source>Value outside the table: hold (as the drive does; the default), zero, wrap, extrapolate or error</source>
        <translation>表范围之外的值：hold（与驱动器相同，默认）、zero、wrap、extrapolate 或 error</translation>
    </message>
    <message>
        <source>Print the value that the controller of this format would apply, after conversion</source>
        <translation>输出转换后此格式的控制器将施加的值</translation>
    </message>
    <message>
        <source>Machine file (.toml)</source>
        <translation>机床文件 (.toml)</translation>
    </message>
    <message>
        <source>Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may be given several times</source>
        <translation>只处理此轴，名称与文件中相同；SERIAL/AXIS 指定某一台驱动器的轴；可多次给出</translation>
    </message>
    <message>
        <source>Drives at the same time (16 unless given)</source>
        <translation>同时处理的驱动器台数（默认：16）</translation>
    </message>
    <message>
        <source>Leave drives out that do not answer, which is an error otherwise</source>
        <translation>略去没有应答的驱动器；未给出时视为错误</translation>
    </message>
    <message>
        <source>Compare the drives of a machine with its machine file, and change nothing</source>
        <translation>将机床的驱动器与其机床文件比较，不作任何更改</translation>
    </message>
    <message>
        <source>The exit code is 0 when all drives have what the file says, and 9 when something differs.</source>
        <translation>所有驱动器均与文件一致时退出码为 0，有差别时为 9。</translation>
    </message>
    <message>
        <source>Write what a machine file says to the drives of the machine, where they differ</source>
        <translation>将机床文件的内容写入机床的驱动器，只写有差别之处</translation>
    </message>
    <message>
        <source>Switch the compensation of axes on and off where the file says so (active), and prove it</source>
        <translation>按文件的规定 (active) 开启和关闭各轴的补偿，并进行验证</translation>
    </message>
    <message>
        <source>All drives are planned first, and nothing is written unless all of it is possible. Each write is safe as that of `axiscomp write`. A second apply finds nothing to do.</source>
        <translation>先为所有驱动器制定计划，只有全部可行才写入。每次写入都与 `axiscomp write` 同样安全。第二次应用时没有需要更改的内容。</translation>
    </message>
    <message>
        <source>Print output, indices and sources of an axis as CSV until stopped</source>
        <translation>以 CSV 输出轴的输出、索引和源，直到被停止</translation>
    </message>
    <message>
        <source>Lines per second, 1 to 100 (10 unless given)</source>
        <translation>每秒行数，1 至 100（默认：10）</translation>
    </message>
    <message>
        <source>Number of lines; without end unless given</source>
        <translation>行数；未给出时不限</translation>
    </message>
    <message>
        <source>Download the table that an axis uses</source>
        <translation>下载轴所使用的表</translation>
    </message>
    <message>
        <source>File to write, .csv, .TAMtbl or that of another controller; CSV on standard output without it</source>
        <translation>要写出的文件：.csv、.TAMtbl 或其他控制器的文件；未给出时在标准输出上输出 CSV</translation>
    </message>
    <message>
        <source>Finish or undo an interrupted write; without an option, say which is possible</source>
        <translation>完成或撤销中断的写入；未给出选项时，说明哪一种可行</translation>
    </message>
    <message>
        <source>Bring the complete new state about, from whatever there is now</source>
        <translation>无论当前状态如何，都达到完整的新状态</translation>
    </message>
    <message>
        <source>Bring back the complete state before the write</source>
        <translation>恢复写入之前的完整状态</translation>
    </message>
    <message>
        <source>Write the report of a record: by how much an axis became better, on one page</source>
        <translation>生成档案的报告：用一页说明轴改善了多少</translation>
    </message>
    <message>
        <source>Record of the compensation (.axcal)</source>
        <translation>补偿档案 (.axcal)</translation>
    </message>
    <message>
        <source>The report; its extension says whether it is PDF or HTML</source>
        <translation>报告文件；由扩展名决定是 PDF 还是 HTML</translation>
    </message>
    <message>
        <source>Language of the report: en, de, fr, ja or zh</source>
        <translation>报告的语言：en、de、fr、ja 或 zh</translation>
    </message>
    <message>
        <source>Add pages with every target and every value that is left out</source>
        <translation>增加列出每个目标位置和每个被排除值的页面</translation>
    </message>
    <message>
        <source>Show what is in measurement files, join them, and write them as one CSV</source>
        <translation>显示测量文件的内容，将其合并，并写成一个 CSV</translation>
    </message>
    <message>
        <source>CSV file to write, replaced if it exists; - for standard output</source>
        <translation>要写出的 CSV 文件，已存在则替换；- 表示标准输出</translation>
    </message>
    <message>
        <source>Write a machine file with all tables from running drives</source>
        <translation>由运行中的驱动器写出含所有表的机床文件</translation>
    </message>
    <message>
        <source>Folder for machine.toml and the tables; files of the same names are replaced</source>
        <translation>存放 machine.toml 和表的文件夹；同名文件将被替换</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>机床的名称</translation>
    </message>
    <message>
        <source>Applied to drives with the same serial numbers and without tables, the file gives the same state, and a snapshot of them the same bytes.</source>
        <translation>将该文件应用到序列号相同且没有表的驱动器，可得到相同的状态，其快照逐字节相同。</translation>
    </message>
    <message>
        <source>Print the states of drives as OpenMetrics text, for a collector</source>
        <translation>以 OpenMetrics 文本输出驱动器的状态，供采集程序使用</translation>
    </message>
    <message>
        <source>Machine file: its drives, and whether they differ from it</source>
        <translation>机床文件：其中的驱动器，以及它们与文件是否有差别</translation>
    </message>
    <message>
        <source>Compare the outputs of active compensations with their tables now</source>
        <translation>立即将已启用补偿的输出与其表比较</translation>
    </message>
    <message>
        <source>File to write, whole or not at all; standard output without it</source>
        <translation>要写出的文件，要么完整写出，要么不写；未给出时写到标准输出</translation>
    </message>
    <message>
        <source>Show the compensation of an axis, and the outcome of an interrupted write</source>
        <translation>显示轴的补偿，以及中断的写入的结果</translation>
    </message>
    <message>
        <source>Count the drive&apos;s flash operations again after their record was damaged; first wait as long as the drive counts them</source>
        <translation>计数记录损坏后，重新计数驱动器的闪存操作；请先等待驱动器统计闪存操作的那段时间</translation>
    </message>
    <message>
        <source>First target</source>
        <translation>首目标位置</translation>
    </message>
    <message>
        <source>Last target, above the first</source>
        <translation>末目标位置，大于首目标位置</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>目标位置数</translation>
    </message>
    <message>
        <source>Mean distance of targets, instead of --count</source>
        <translation>目标位置的平均间距，代替 --count</translation>
    </message>
    <message>
        <source>Known period of the axis, such as the lead of its screw: targets are spread over it</source>
        <translation>轴的已知周期，例如丝杠导程：使目标位置分布在周期内的不同处</translation>
    </message>
    <message>
        <source>Runs in each direction (5 unless given)</source>
        <translation>每个方向的趟数（默认：5）</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same (1 unless given)</source>
        <translation>数字不同则目标位置不同，数字相同则目标位置相同（默认：1）</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target (1 % of the range unless given, at most a third of the spacing)</source>
        <translation>轴在首目标位置之前沿该趟方向移动的距离（默认为范围的 1 %，最多为间距的三分之一）</translation>
    </message>
    <message>
        <source>Feed in mm or deg per minute (1000 unless given)</source>
        <translation>进给速度，mm/min 或 deg/min（默认：1000）</translation>
    </message>
    <message>
        <source>Seconds at each target (5 unless given): time to stand still and be measured</source>
        <translation>在每个目标位置停留的秒数（默认：5）：用于静止和测量</translation>
    </message>
    <message>
        <source>Choose the targets of a measurement: a plan, or a program for the machine&apos;s control</source>
        <translation>选择测量的目标位置：生成测量计划，或机床数控系统的程序</translation>
    </message>
    <message>
        <source>Name of the axis (X unless given)</source>
        <translation>轴的名称（默认：X）</translation>
    </message>
    <message>
        <source>Unit of all positions: mm (the default) or deg</source>
        <translation>所有位置的单位：mm（默认）或 deg</translation>
    </message>
    <message>
        <source>Write G-code for this control: linuxcnc, fanuc or siemens</source>
        <translation>写出用于此数控系统的 G 代码：linuxcnc、fanuc 或 siemens</translation>
    </message>
    <message>
        <source>List the table files of a drive</source>
        <translation>列出驱动器的表文件</translation>
    </message>
    <message>
        <source>Upload a file unchanged and verify it, for drive programs that use tables</source>
        <translation>原样上传文件并校验，用于使用表的驱动器程序</translation>
    </message>
    <message>
        <source>File on this computer</source>
        <translation>本计算机上的文件</translation>
    </message>
    <message>
        <source>Path in the drive, such as tables/small1.TAMtbl</source>
        <translation>驱动器中的路径，例如 tables/small1.TAMtbl</translation>
    </message>
    <message>
        <source>Download a file unchanged</source>
        <translation>原样下载文件</translation>
    </message>
    <message>
        <source>Register that supplies the position of dimension 1: path, tam:// URI or address (0x1234)</source>
        <translation>提供维度 1 位置的寄存器：路径、tam:// URI 或地址 (0x1234)</translation>
    </message>
    <message>
        <source>The same for dimension 2</source>
        <translation>同上，用于维度 2</translation>
    </message>
    <message>
        <source>The same for dimension 3</source>
        <translation>同上，用于维度 3</translation>
    </message>
    <message>
        <source>The source is the axis&apos;s own position, for tables of one dimension; with --map each axis&apos;s own</source>
        <translation>以轴自身的位置为源，用于一维的表；与 --map 同用时各轴采用自身的位置</translation>
    </message>
    <message>
        <source>Write a compensation table to an axis in the safe order, and verify it</source>
        <translation>按安全的顺序将补偿表写入轴，并校验</translation>
    </message>
    <message>
        <source>Calibration file (.csv), table (.TAMtbl), or file of another controller; without it the axis keeps its table</source>
        <translation>校准文件 (.csv)、表 (.TAMtbl) 或其他控制器的文件；未给出时轴保留其表</translation>
    </message>
    <message>
        <source>Record of a compensation in place of --data: its table is written, and it notes drive, slot and CRC</source>
        <translation>代替 --data 的补偿档案：写入其中的表，并在档案中记下驱动器、表槽和 CRC</translation>
    </message>
    <message>
        <source>Store the table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>将表存入驱动器的闪存，重启后保留</translation>
    </message>
    <message>
        <source>Keep the table in memory until the next reboot (the default for a new table)</source>
        <translation>将表保留在内存中直到下次重启（新表的默认方式）</translation>
    </message>
    <message>
        <source>Unit of the values in place of what the file says, such as um; drive for the drive&apos;s own</source>
        <translation>值的单位，例如 um，代替文件的规定；drive 表示驱动器自身的单位</translation>
    </message>
    <message>
        <source>The same for the positions</source>
        <translation>同上，用于位置</translation>
    </message>
    <message>
        <source>Slot to use, small1 to small8, large1 or large2; chosen unless given</source>
        <translation>使用的表槽：small1 至 small8、large1 或 large2；未给出时自动选择</translation>
    </message>
    <message>
        <source>Write this column of the file (name or number) to this axis; AXIS alone is the column that is named as the axis. May be given several times. Nothing is written unless all of the writes are possible</source>
        <translation>将文件的此列（名称或编号）写入此轴；只给出 AXIS 时取与轴同名的列。可多次给出。只有全部写入均可行才写入</translation>
    </message>
    <message>
        <source>Write corrections above 1 % of the range, or with a slope above 0.1, which without this are taken for a wrong unit</source>
        <translation>允许写入超过范围 1 % 或斜率超过 0.1 的补偿值；未给出时视为单位错误</translation>
    </message>
    <message>
        <source>Without --source1 the axis keeps its sources. The compensation stays off: `axiscomp activate` switches it on.</source>
        <translation>未给出 --source1 时轴保留其源。补偿保持关闭：用 `axiscomp activate` 开启。</translation>
    </message>
    <message>
        <source>Axis that the values correct, for each column or for all: its name, #1 for the first source, or other for an axis that is no source; by default as the file says</source>
        <translation>值所补偿的轴，用于各列或所有列：轴的名称、#1（第一个源）或 other（不是源的轴）；默认按文件的规定</translation>
    </message>
    <message>
        <source>Conversion</source>
        <translation>转换</translation>
    </message>
    <message>
        <source>Convention of the input: feedback (added to the encoder position) or command (added to the commanded position); by default that of its format, needed where that is assumed</source>
        <translation>输入的符号：feedback（加到编码器位置）或 command（加到指令位置）；默认按其格式，格式的符号只是假定时必须给出</translation>
    </message>
    <message>
        <source>Which values to use if the file has both directions of motion: mean, positive or negative</source>
        <translation>文件含有两个运动方向的值时使用哪些值：mean、positive 或 negative</translation>
    </message>
    <message>
        <source>Multiply the values by this number, before anything else</source>
        <translation>在其他处理之前，先将值乘以此数</translation>
    </message>
    <message>
        <source>Add this to the values, in their unit</source>
        <translation>将此数加到值上，以值的单位</translation>
    </message>
    <message>
        <source>Shift the values so that they are 0 at this position</source>
        <translation>平移各值，使其在此位置为 0</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a linear one</source>
        <translation>将模数轴按直线轴处理</translation>
    </message>
    <message>
        <source>Resample onto an even grid with N points, for each source or for all</source>
        <translation>重采样到 N 点的均匀网格，用于各源或所有源</translation>
    </message>
    <message>
        <source>Resample onto an even grid with spacing D, for each source or for all</source>
        <translation>重采样到间距为 D 的均匀网格，用于各源或所有源</translation>
    </message>
    <message>
        <source>Resample onto the coarsest even grid within this deviation, in the unit of the values</source>
        <translation>重采样到此偏差（值的单位）以内最粗的均匀网格</translation>
    </message>
    <message>
        <source>Between the points of the source: linear (the default), cubic (monotone), spline (natural cubic) or smooth (smoothing spline)</source>
        <translation>源的各点之间：linear（默认）、cubic（单调三次）、spline（自然三次样条）或 smooth（平滑样条）</translation>
    </message>
    <message>
        <source>Speed of the axis in positions per second: says the steps of the velocity that are left with spline and smooth</source>
        <translation>轴的速度，每秒的位置单位数：报告 spline 和 smooth 仍留有的速度跳变</translation>
    </message>
    <message>
        <source>Let the even grid extend beyond the data, where the end values are held</source>
        <translation>允许均匀网格超出数据，超出部分保持端值</translation>
    </message>
    <message>
        <source>Convention of the output: feedback or command; by default that of its format, needed where that is assumed</source>
        <translation>输出的符号：feedback 或 command；默认按其格式，格式的符号只是假定时必须给出</translation>
    </message>
    <message>
        <source>Setting that the output format needs; `axiscomp formats NAME` lists them</source>
        <translation>输出格式所需的设置；用 `axiscomp formats NAME` 列出</translation>
    </message>
    <message>
        <source>Corrections, made only when asked for</source>
        <translation>修正，仅在给出时进行</translation>
    </message>
    <message>
        <source>Temperature of the axis&apos;s scale in C</source>
        <translation>轴的标尺温度，单位 °C</translation>
    </message>
    <message>
        <source>Coefficient of expansion of the axis&apos;s scale in 1/K, such as 11.5e-6</source>
        <translation>轴的标尺膨胀系数，单位 1/K，例如 11.5e-6</translation>
    </message>
    <message>
        <source>Temperature of the reference in C</source>
        <translation>基准温度，单位 °C</translation>
    </message>
    <message>
        <source>Coefficient of the reference in 1/K; 0 for a laser with wavelength compensation</source>
        <translation>基准的膨胀系数，单位 1/K；对已作波长补偿的激光为 0</translation>
    </message>
    <message>
        <source>Position in mm that does not move with temperature; the first target unless given</source>
        <translation>不随温度移动的位置，单位 mm；未给出时取首目标位置</translation>
    </message>
    <message>
        <source>The values are not corrected to 20 C, where the file does not say it</source>
        <translation>值未修正到 20 °C（文件未注明时）</translation>
    </message>
    <message>
        <source>Dead path of the interferometer: a JSON file with its length and the air of each run</source>
        <translation>干涉仪的死程：含其长度和各趟空气状态的 JSON 文件</translation>
    </message>
    <message>
        <source>Limits, such as A=10um,R=4um; exit code 8 when one is not met</source>
        <translation>公差，例如 A=10um,R=4um；有一项不满足时退出码为 8</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms</source>
        <translation>k = 2 时的测量不确定度：U=2.1um，或含各分量的 JSON 文件</translation>
    </message>
    <message>
        <source>Measurement files, joined when there are several; - for standard input</source>
        <translation>测量文件，有多个时合并；- 表示标准输入</translation>
    </message>
    <message>
        <source>Format of the files, if their content leaves it open</source>
        <translation>文件的格式（由内容无法确定时）</translation>
    </message>
    <message>
        <source>Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>排除值：down:1:1（方向、目标位置、趟次）、run:up:3 或 target:7，之间用逗号分隔</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>对调正向和负向</translation>
    </message>
    <message>
        <source>What a file leaves open</source>
        <translation>文件未确定的内容</translation>
    </message>
    <message>
        <source>Which column of a CSV file is what, by number or name: &apos;target=1,direction=3,deviation=5&apos;</source>
        <translation>CSV 文件各列的含义，用列号或列名给出：&apos;target=1,direction=3,deviation=5&apos;</translation>
    </message>
    <message>
        <source>Lines before the header of a CSV file</source>
        <translation>CSV 文件标题行之前的行数</translation>
    </message>
    <message>
        <source>Unit of targets and encoder</source>
        <translation>目标位置和编码器的单位</translation>
    </message>
    <message>
        <source>Unit of deviations and reference</source>
        <translation>偏差和基准的单位</translation>
    </message>
    <message>
        <source>What the values are: deviation (reference minus target) or reference (positions)</source>
        <translation>值的种类：deviation（基准减目标位置）或 reference（位置）</translation>
    </message>
    <message>
        <source>order: the direction of a run follows from the order of its targets</source>
        <translation>order：由目标位置的顺序确定各趟的方向</translation>
    </message>
    <message>
        <source>How far a track moves after a turn before its samples count, in mm or deg; 1 % of the range unless given</source>
        <translation>轨迹反向后，移动多远采样点才计入，单位 mm 或 deg；未给出时为范围的 1 %</translation>
    </message>
    <message>
        <source>Number of dimensions of a CSV file: its first D columns are positions</source>
        <translation>CSV 文件的维数：前 D 列为位置</translation>
    </message>
    <message>
        <source>Format of the input, if content and name leave it open</source>
        <translation>输入的格式（由内容和文件名无法确定时）</translation>
    </message>
    <message>
        <source>Setting that the file leaves open; `axiscomp formats NAME` lists them</source>
        <translation>文件未确定的设置；用 `axiscomp formats NAME` 列出</translation>
    </message>
    <message>
        <source>Incomplete grids</source>
        <translation>不完整的网格</translation>
    </message>
    <message>
        <source>Give points without a value that of the nearest measured point (nearest), of the plane through all of them (plane), or the values that bend least (smooth)</source>
        <translation>填补没有值的点：用最近测量点的值 (nearest)、通过所有测量点的平面上的值 (plane) 或弯曲最小的值 (smooth)</translation>
    </message>
    <message>
        <source>Cut the grid to the largest part in which every point has a value</source>
        <translation>将网格裁剪为每点均有值的最大部分</translation>
    </message>
    <message>
        <source>Take positions of a calibration file that are this close to the grid for grid positions, in their unit</source>
        <translation>校准文件中与网格相差不超过此值（以位置的单位）的位置视为网格位置</translation>
    </message>
    <message>
        <source>Table of the file, by name or by number from 1 (name:TEXT, #N where that could be either); not needed if there is only one</source>
        <translation>文件中的表，用名称或从 1 开始的编号给出（两者可能混淆时用 name:TEXT、#N）；只有一个表时不需要</translation>
    </message>
    <message>
        <source>Drive profile (JSON) in place of the built-in one, generic</source>
        <translation>驱动器描述文件 (JSON)，代替内置的 generic</translation>
    </message>
    <message>
        <source>Address of the drive, may be given several times; $AXISCOMP_DRIVE unless given</source>
        <translation>驱动器的地址，可多次给出；未给出时用 $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Address of the drive; $AXISCOMP_DRIVE unless given</source>
        <translation>驱动器的地址；未给出时用 $AXISCOMP_DRIVE</translation>
    </message>
    <message>
        <source>Trust the https certificate with this fingerprint from now on; any other one is refused</source>
        <translation>今后信任具有此指纹的 https 证书；拒绝其他任何证书</translation>
    </message>
    <message>
        <source>Time limit for one exchange with the drive (5 unless given)</source>
        <translation>与驱动器一次通信的时限（默认：5）</translation>
    </message>
    <message>
        <source>Index or name of the axis; not needed if the drive has only one</source>
        <translation>轴的索引或名称；驱动器只有一个轴时不需要</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Show this help</source>
        <translation>显示此帮助</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMAND</translation>
    </message>
    <message>
        <source>usage</source>
        <translation>用法</translation>
    </message>
    <message>
        <source>Serve the drive&apos;s web pages here; port 0 picks a free one (127.0.0.1:0 unless this or --serial is given). Several drives take ports in a row</source>
        <translation>在此处提供驱动器的网页；端口 0 表示选用空闲端口（此选项和 --serial 均未给出时为 127.0.0.1:0）。多台驱动器依次使用相邻端口</translation>
    </message>
    <message>
        <source>Serve the serial link on a pseudo-terminal, and make LINK a symbolic link to it. Several drives take LINK, LINK-2, ...</source>
        <translation>在伪终端上提供串口连接，并使 LINK 成为指向它的符号链接。多台驱动器使用 LINK、LINK-2、...。</translation>
    </message>
    <message>
        <source>Make the serial link as slow as a line of this speed (as fast as it can unless given)</source>
        <translation>使串口连接与此速度的线路一样慢（未给出时尽可能快）</translation>
    </message>
    <message>
        <source>Name of the drive (Virtual-1 unless given)</source>
        <translation>驱动器的名称（默认：Virtual-1）</translation>
    </message>
    <message>
        <source>Number of axes, 1 to 16 (2 unless given)</source>
        <translation>轴数，1 至 16（默认：2）</translation>
    </message>
    <message>
        <source>Take names, axes and parameters from a TAM configuration; several drives in it are several virtual drives</source>
        <translation>从 TAM 配置取得名称、轴和参数；其中有多台驱动器时成为多台虚拟驱动器</translation>
    </message>
    <message>
        <source>Move the machine of this file (JSON): axes with errors that nobody knows, and an instrument that measures them</source>
        <translation>移动此文件 (JSON) 描述的机床：带有未知误差的轴，以及测量这些误差的仪器</translation>
    </message>
    <message>
        <source>Play this measuring plan (axiscomp targets) as the machine&apos;s control would, from 10 s after the start</source>
        <translation>像机床数控系统一样执行此测量计划 (axiscomp targets)，启动 10 s 后开始</translation>
    </message>
    <message>
        <source>Begin the program so many seconds after the start, whatever --speed is; unless given, after 10 s of the machine&apos;s time</source>
        <translation>启动后经过此秒数开始执行程序，与 --speed 无关；未给出时，在机床时间 10 s 后开始</translation>
    </message>
    <message>
        <source>Serve the instrument&apos;s lines on a pseudo-terminal, and make LINK a symbolic link to it</source>
        <translation>在伪终端上提供仪器的输出行，并使 LINK 成为指向它的符号链接</translation>
    </message>
    <message>
        <source>Keep flash and saved parameters here across runs, a folder per drive</source>
        <translation>将闪存内容和已保存的参数存放在此处，供下次运行使用，每台驱动器一个文件夹</translation>
    </message>
    <message>
        <source>Misbehave: drop-after=BYTES, no-reply=N, garble=N, stores-wrong=N, slow=MS, reboot-after=N or reject=CODE; may be given several times</source>
        <translation>模拟异常：drop-after=BYTES、no-reply=N、garble=N、stores-wrong=N、slow=MS、reboot-after=N 或 reject=CODE；可多次给出</translation>
    </message>
    <message>
        <source>Simulated seconds per second (1 unless given)</source>
        <translation>每秒模拟的秒数（默认：1）</translation>
    </message>
    <message>
        <source>Start with axes that are not homed</source>
        <translation>启动时各轴未回原点</translation>
    </message>
    <message>
        <source>Ask for this user name</source>
        <translation>要求此用户名</translation>
    </message>
    <message>
        <source>File whose first line is the password of --user</source>
        <translation>首行为 --user 密码的文件</translation>
    </message>
    <message>
        <source>Serve https with this certificate</source>
        <translation>使用此证书提供 https</translation>
    </message>
    <message>
        <source>Private key of --certificate</source>
        <translation>--certificate 的私钥</translation>
    </message>
    <message>
        <source>A servo drive in software, with the web pages, registers and behaviour of a real one.</source>
        <translation>软件实现的伺服驱动器，具有与真实驱动器相同的网页、寄存器和行为。</translation>
    </message>
    <message>
        <source>Prints a line `ready http=URL serial=DEVICE drive=NAME` for each drive, and runs until Ctrl-C.</source>
        <translation>为每台驱动器输出一行 `ready http=URL serial=DEVICE drive=NAME`，运行到按下 Ctrl-C 为止。</translation>
    </message>
    <message>
        <source>Use this drive in place of the remembered ones; may be given several times: http://[user:password@]host[:port], https://..., serial:/dev/ttyUSB0[?baud=N], demo:</source>
        <translation>使用此驱动器，代替已记住的驱动器；可多次给出：http://[user:password@]host[:port]、https://...、serial:/dev/ttyUSB0[?baud=N]、demo:</translation>
    </message>
    <message>
        <source>Open this file of compensation data</source>
        <translation>打开此补偿数据文件</translation>
    </message>
    <message>
        <source>How long one exchange with a drive may take (5 unless given)</source>
        <translation>与驱动器一次通信允许的时间（默认：5）</translation>
    </message>
    <message>
        <source>Writes compensation tables for measured axis errors to servo drives, in a window.</source>
        <translation>在窗口中将测得的轴误差的补偿表写入伺服驱动器。</translation>
    </message>
    <message>
        <source>Without --drive it uses the drives of the last time, or the built-in demo drive.</source>
        <translation>未给出 --drive 时，使用上次的驱动器，或内置的演示驱动器。</translation>
    </message>
    <message>
        <source>Let the drive look up the table without adding its values</source>
        <translation>让驱动器查表但不叠加其值</translation>
    </message>
    <message>
        <source>Activate the compensation, and compare the drive&apos;s output with the table</source>
        <translation>启用补偿，并将驱动器的输出与补偿表比较</translation>
    </message>
    <message>
        <source>Deactivate the compensation</source>
        <translation>停用补偿</translation>
    </message>
    <message>
        <source>Store the axis&apos;s table in the drive&apos;s flash, so that it survives a reboot</source>
        <translation>将轴的补偿表存入驱动器闪存，重启后仍然保留</translation>
    </message>
    <message>
        <source>Make the axis&apos;s table volatile, so that it is lost at the next reboot</source>
        <translation>将轴的补偿表设为易失，下次重启后丢失</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>本计算机</translation>
    </message>
    <message>
        <source>Show what this computer has and lacks, and what each known drive answers</source>
        <translation>显示本计算机具备和缺少的内容，以及每台已知驱动器的应答</translation>
    </message>
    <message>
        <source>Time limit for all that a drive is asked (5 unless given)</source>
        <translation>询问一台驱动器全部内容的时限（默认：5）</translation>
    </message>
    <message>
        <source>The connections of the window are asked too. Nothing is changed, on this computer or on a drive. What is printed has no passwords in it and is meant to be sent to whoever helps.</source>
        <translation>窗口中的连接也会被询问。不会更改本计算机或驱动器上的任何内容。输出中不含密码，供发送给提供帮助的人。</translation>
    </message>
    <message>
        <source>Open this file: a record (.axcal), a machine file (.toml), a TAM configuration (.TAMcfg), a table or a measurement</source>
        <translation>打开此文件：档案 (.axcal)、机床文件 (.toml)、TAM 配置 (.TAMcfg)、表或测量</translation>
    </message>
    <message>
        <source>Measurement before and measurement after; with a record, which has the first, the second alone is enough</source>
        <translation>补偿前的测量和补偿后的测量；有含前者的档案时，只给出后者即可</translation>
    </message>
    <message>
        <source>Leave values of the second measurement out: down:1:1 (direction, target, run), run:up:3 or target:7, with commas between them</source>
        <translation>排除第二次测量的值：down:1:1（方向、目标位置、趟次）、run:up:3 或 target:7，之间用逗号分隔</translation>
    </message>
    <message>
        <source>Record of the compensation: the first measurement with its exclusions and corrections, prediction, table and tolerances</source>
        <translation>补偿档案：第一次测量及其排除和修正、预测、表和公差</translation>
    </message>
    <message>
        <source>Where the drive looks its table up (the input or the output, whichever is the drive&apos;s): encoder (before the compensation) or set (after it); by default as the file says, or encoder</source>
        <translation>驱动器在哪里查自己的表（输入或输出中属于驱动器的那个）：encoder（补偿前）或 set（补偿后）；默认按文件所述，否则为 encoder</translation>
    </message>
</context>
<context>
    <name>JudgeOutlook</name>
    <message>
        <source>%1: not defined, so that the tolerance %2 cannot be met.</source>
        <translation>%1：无定义，因此无法满足公差 %2。</translation>
    </message>
    <message>
        <source>%1: %2, nearer to the tolerance %3 than the uncertainty. That is undecided.</source>
        <translation>%1：%2，与公差 %3 之差小于测量不确定度，无法判定。</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. Go on to Fit: a table may make it smaller.</source>
        <translation>%1：%2，超出公差 %3。请转到“拟合”：用表可能使其减小。</translation>
    </message>
    <message>
        <source>%1: %2, above the tolerance %3. No table makes it smaller: look at the mechanics.</source>
        <translation>%1：%2，超出公差 %3。任何表都不能使其减小：请检查机械部分。</translation>
    </message>
    <message>
        <source>Add the files of a measurement on the tab Measure.</source>
        <translation>请在“测量”页添加测量的文件。</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>正在读取文件…</translation>
    </message>
    <message>
        <source>A file cannot be used: the tab Measure says why.</source>
        <translation>有一个文件无法使用：原因见“测量”页。</translation>
    </message>
    <message>
        <source>This measurement has no targets, and so no figures of ISO 230-2. Go on to Fit, or measure at targets.</source>
        <translation>此测量没有目标位置，因此没有 GB/T 17421.2 的指标。请转到“拟合”，或按目标位置测量。</translation>
    </message>
    <message>
        <source>Enter the tolerances of the axis, or go on to Fit.</source>
        <translation>请输入该轴的公差，或转到“拟合”。</translation>
    </message>
    <message>
        <source>Every tolerance is met. A table can still make the axis better: go on to Fit.</source>
        <translation>所有公差均满足。用表还可以进一步改善该轴：请转到“拟合”。</translation>
    </message>
    <message>
        <source>The standard&apos;s condition “%1” is not met.</source>
        <translation>不满足标准的条件“%1”。</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>维数</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>Dim{n}Source</source>
        <translation>Dim{n} 源</translation>
    </message>
    <message>
        <source>problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>has all of this</source>
        <translation>已完全一致</translation>
    </message>
    <message>
        <source>unfinished write</source>
        <translation>未完成的写入</translation>
    </message>
    <message>
        <source>Activation</source>
        <translation>启用状态</translation>
    </message>
    <message>
        <source>differs: {fields}</source>
        <translation>不同：{fields}</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>written and switched</source>
        <translation>已写入并切换</translation>
    </message>
    <message>
        <source>written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>switched</source>
        <translation>已切换</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>无需操作</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>未写入</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>{slot}, empty</source>
        <translation>{slot}，空</translation>
    </message>
    <message>
        <source>{slot}, persistent, CRC {crc}</source>
        <translation>{slot}，持久，CRC {crc}</translation>
    </message>
    <message>
        <source>{slot}, volatile, CRC {crc}</source>
        <translation>{slot}，易失，CRC {crc}</translation>
    </message>
    <message>
        <source>switched, not written</source>
        <translation>已切换，未写入</translation>
    </message>
    <message>
        <source>written, not switched</source>
        <translation>已写入，未切换</translation>
    </message>
    <message>
        <source>not switched</source>
        <translation>未切换</translation>
    </message>
    <message>
        <source>{outcome}, proved</source>
        <translation>{outcome}，已验证</translation>
    </message>
    <message>
        <source>{outcome}, not proved</source>
        <translation>{outcome}，未验证</translation>
    </message>
</context>
<context>
    <name>Measurement</name>
    <message>
        <source>the file states the temperature</source>
        <translation>文件注明了温度</translation>
    </message>
    <message>
        <source>the file states the instrument</source>
        <translation>文件注明了仪器</translation>
    </message>
    <message>
        <source>the file states the feed</source>
        <translation>文件注明了进给速度</translation>
    </message>
    <message>
        <source>the file states the dwell</source>
        <translation>文件注明了停留时间</translation>
    </message>
    <message>
        <source>at least {due} targets over {range}: {count}</source>
        <translation>{range} 上至少 {due} 个目标位置：{count}</translation>
    </message>
    <message>
        <source>a target about every 250 mm on an axis above 2 m: {count} over {range}, at most {gap} apart</source>
        <translation>2 m 以上的轴约每 250 mm 一个目标位置：{range} 上 {count} 个，间距最大 {gap}</translation>
    </message>
    <message>
        <source>at least 5 targets, and 5 for each metre: {count} over {range}</source>
        <translation>至少 5 个目标位置，且每米 5 个：{range} 上 {count} 个</translation>
    </message>
    <message>
        <source>a run in each direction on an axis above 2 m, for E, B and M alone: {count}</source>
        <translation>2 m 以上的轴每个方向一趟，仅用于 E、B 和 M：{count}</translation>
    </message>
    <message>
        <source>5 runs in each direction: the file has means</source>
        <translation>每个方向 5 趟：文件中为平均值</translation>
    </message>
    <message>
        <source>5 runs in each direction: {count} at the target with the fewest</source>
        <translation>每个方向 5 趟：最少的目标位置为 {count}</translation>
    </message>
    <message>
        <source>every target is approached in both directions</source>
        <translation>每个目标位置均从两个方向趋近</translation>
    </message>
    <message>
        <source>the targets are not all at the same place of the period {period}</source>
        <translation>目标位置并非都在周期 {period} 的同一处</translation>
    </message>
    <message>
        <source>reversal value B</source>
        <translation>反向差值 B</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <translation>平均反向差值</translation>
    </message>
    <message>
        <source>range of the mean deviation M</source>
        <translation>平均双向位置偏差范围 M</translation>
    </message>
    <message>
        <source>systematic deviation E, up</source>
        <translation>定位系统偏差 E，正向</translation>
    </message>
    <message>
        <source>systematic deviation E, down</source>
        <translation>定位系统偏差 E，负向</translation>
    </message>
    <message>
        <source>systematic deviation E</source>
        <translation>定位系统偏差 E</translation>
    </message>
    <message>
        <source>repeatability R, up</source>
        <translation>重复定位精度 R，正向</translation>
    </message>
    <message>
        <source>repeatability R, down</source>
        <translation>重复定位精度 R，负向</translation>
    </message>
    <message>
        <source>repeatability R</source>
        <translation>重复定位精度 R</translation>
    </message>
    <message>
        <source>accuracy A, up</source>
        <translation>定位精度 A，正向</translation>
    </message>
    <message>
        <source>accuracy A, down</source>
        <translation>定位精度 A，负向</translation>
    </message>
    <message>
        <source>accuracy A</source>
        <translation>定位精度 A</translation>
    </message>
    <message>
        <source>the runs {direction} drift by {drift} from the first to the last, more than their spread explains</source>
        <translation>{direction}各趟从第一趟到最后一趟漂移 {drift}，超出其分散所能解释的范围</translation>
    </message>
    <message>
        <source>more than a fifth of the values {direction} do not fit the others: the measurement was disturbed, and nothing is proposed</source>
        <translation>{direction}有五分之一以上的值与其余的值不符：测量受到干扰，不给出建议</translation>
    </message>
    <message numerus="yes">
        <source>{count} values excluded, not an evaluation by ISO 230-2</source>
        <comment>1 value excluded, not an evaluation by ISO 230-2</comment>
        <translation>
            <numerusform>已排除 {count} 个值，不属于按 GB/T 17421.2 的评定</numerusform>
        </translation>
    </message>
    <message>
        <source>the file says {figure} = {published}</source>
        <translation>文件给出 {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}, which is less than its own {figure} = {published}</source>
        <translation>{statement}，小于同一文件中的 {figure} = {published}</translation>
    </message>
    <message>
        <source>{statement}; computed from its values: {computed}</source>
        <translation>{statement}；由其值计算得：{computed}</translation>
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
        <translation>无法判定</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>means of runs</source>
        <translation>各趟的平均值</translation>
    </message>
    <message>
        <source>a track without targets</source>
        <translation>无目标位置的轨迹</translation>
    </message>
    <message>
        <source>points of a plane or space</source>
        <translation>平面或空间的点</translation>
    </message>
    <message>
        <source>runs over targets</source>
        <translation>按目标位置的逐趟测量</translation>
    </message>
    <message>
        <source>up</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>down</source>
        <translation>负向</translation>
    </message>
    <message>
        <source>a slope of {slope} over {length} was taken out</source>
        <translation>已去除 {length} 上 {slope} 的斜率</translation>
    </message>
    <message>
        <source>the steepest part of {table} is between {from} and {to}: {step}, {slope} for each {one}</source>
        <translation>{table} 在 {from} 与 {to} 之间最陡：{step}，即每 {one} {slope}</translation>
    </message>
    <message>
        <source>a drive holds numbers with 24 bits, which changes a value of {table} by at most {rounding}</source>
        <translation>驱动器以 24 位存放数字，{table} 的值因此最多改变 {rounding}</translation>
    </message>
    <message numerus="yes">
        <source>{count} points of {table} have nothing measured beside them and were filled</source>
        <comment>1 point of {table} has nothing measured beside it and was filled</comment>
        <translation>
            <numerusform>{table} 有 {count} 点旁边没有测得点，已填补</numerusform>
        </translation>
    </message>
    <message>
        <source>merged onto {name} with gain {gain}: a value changes by at most {change}, at {place}</source>
        <translation>已合并到 {name}，增益 {gain}：值最多改变 {change}，在 {place}</translation>
    </message>
    <message>
        <source>the table improves little: {figure} from {before} to {after}, less than a fifth</source>
        <translation>该表改善甚微：{figure} 由 {before} 到 {after}，不足五分之一</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}; measure at more targets</source>
        <translation>目标位置之间的误差了解不足：逐个留出目标位置的预测，M 为 {heldOut}；请测量更多的目标位置</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, M is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>目标位置之间的误差了解不足：逐个留出目标位置的预测，M 为 {heldOut}，而补偿前为 {before}；请测量更多的目标位置</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: up to {reversal} remains in each direction</source>
        <translation>此误差主要是反向差值，任何表都不能消除：每个方向最多残留 {reversal}</translation>
    </message>
    <message>
        <source>the table is for both directions: up to {reversal} of the reversal remains in each</source>
        <translation>该表用于两个方向：每个方向最多残留反向差值中的 {reversal}</translation>
    </message>
    <message>
        <source>the table is for one direction: in the other up to {reversal} of reversal remains</source>
        <translation>该表用于一个方向：另一方向最多残留反向差值 {reversal}</translation>
    </message>
    <message>
        <source>{count} targets lie in {turns} periods of {period}</source>
        <translation>{count} 个目标位置落在周期 {period} 的 {turns} 个周期内</translation>
    </message>
    <message>
        <source>{table} adds {value} at the home position {home}</source>
        <translation>{table} 在原点位置 {home} 叠加 {value}</translation>
    </message>
    <message>
        <source>over a turn, from {from} to {to}, {table} ends {jump} above where it begins</source>
        <translation>在从 {from} 到 {to} 的一转上，{table} 的末端比起点高 {jump}</translation>
    </message>
    <message>
        <source>the compensation off</source>
        <translation>补偿关闭</translation>
    </message>
    <message>
        <source>the compensation on</source>
        <translation>补偿开启</translation>
    </message>
    <message>
        <source>the table {crc} active</source>
        <translation>启用表 {crc}</translation>
    </message>
    <message>
        <source>measured with the table {crc} of {name} active</source>
        <translation>测量时启用的是 {name} 的表 {crc}</translation>
    </message>
    <message>
        <source>measured with {name} active ({known})</source>
        <translation>测量时启用的是 {name}（{known}）</translation>
    </message>
    <message>
        <source>the measurement does not say which table was active; {name} ({known}) is taken to have been</source>
        <translation>该测量没有注明启用了哪个表；按 {name}（{known}）处理</translation>
    </message>
    <message>
        <source>the raw positions of the encoder are on file: the table is made of reference minus encoder, whatever compensation was active</source>
        <translation>文件中有编码器的原始位置：无论当时启用何种补偿，表均由基准减编码器得出</translation>
    </message>
    <message>
        <source>measured with the compensation off</source>
        <translation>测量时补偿关闭</translation>
    </message>
    <message>
        <source>{table} explains {share} % of the variance of {count} values; {rms} rms remains</source>
        <translation>{table} 可解释 {count} 个值的方差的 {share} %；残余均方根 {rms}</translation>
    </message>
    <message>
        <source>{table} explains little: values that were left out are foretold with {left} rms, and they are {values} rms themselves</source>
        <translation>{table} 的解释作用甚微：对留出值的预测误差均方根为 {left}，而这些值本身为 {values}</translation>
    </message>
    <message numerus="yes">
        <source>{count} values lie outside the grid and were left out</source>
        <comment>1 value lies outside the grid and was left out</comment>
        <translation>
            <numerusform>有 {count} 个值在网格之外，未采用</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is point {first}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: point {first}, {residual} off</comment>
        <translation>
            <numerusform>{table} 中有 {count} 个值与其余的值不符，权重降低；第一个是点 {first}，相差 {residual}</numerusform>
        </translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} less than 90 degrees</source>
        <translation>{first} 和 {second} 之间的夹角比 90 度小 {angle}</translation>
    </message>
    <message>
        <source>a scale of {scale} for each {length} was taken out; the mean scale error of the axes is in it, and stays in the machine</source>
        <translation>已去除每 {length} {scale} 的比例误差；其中含各轴的平均比例误差，它仍留在机床中</translation>
    </message>
    <message>
        <source>{axis} {position}</source>
        <translation>{axis} {position}</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; the drive will add {added}</source>
        <translation>在 {position} 处，{table} 中基准与编码器相差 {measured}；驱动器将叠加 {added}</translation>
    </message>
    <message>
        <source>how well the error between the targets is known cannot be told: {reason}</source>
        <translation>无法判断目标位置之间的误差了解到何种程度：{reason}</translation>
    </message>
    <message>
        <source>at {speed} the velocity jumps by at most {step} at a point of the table</source>
        <translation>在 {speed} 时，速度在表的一点处最多跳变 {step}</translation>
    </message>
    <message>
        <source>{count} points of {table} with straight lines between them are at most {distance} off the curve, at {place}</source>
        <translation>{table} 以直线连接的 {count} 点与曲线最多相距 {distance}，在 {place}</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; the drive will add {added}</comment>
        <translation>
            <numerusform>编码器读数为 {reading} 处，基准为 {reference}（{count} 个值的平均）；驱动器将叠加 {added}</numerusform>
        </translation>
    </message>
    <message>
        <source>the error is {factor} times what it was before: the table has the wrong sign</source>
        <translation>误差为补偿前的 {factor} 倍：该表的符号错误</translation>
    </message>
    <message>
        <source>the error is the same as before: the compensation was not active, or another axis was measured</source>
        <translation>误差与补偿前相同：补偿没有启用，或测量的是另一个轴</translation>
    </message>
    <message>
        <source>what is left is {factor} times the error before: the table adds {share} times what it should; look at the units of measurement and table</source>
        <translation>残余误差为补偿前误差的 {factor} 倍：该表叠加了应有值的 {share} 倍；请检查测量和表的单位</translation>
    </message>
    <message>
        <source>what is left resembles neither the error before nor its slope: the machine was in another state, such as another temperature or load, or it is another axis</source>
        <translation>残余误差既不像补偿前的误差，也不像其斜率：机床处于另一状态，例如温度或负载不同，或这是另一个轴</translation>
    </message>
    <message>
        <source>what is left follows the slope of the error before: the table is shifted by about {shift} against the axis; look at the home position and the source of the table</source>
        <translation>残余误差与补偿前误差的斜率一致：该表相对于轴偏移约 {shift}；请检查原点位置和表的源</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>met</source>
        <translation>满足</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不满足</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others: look at them, and exclude them or leave them in</source>
        <comment>1 value does not fit the others: look at it, and exclude it or leave it in</comment>
        <translation>
            <numerusform>有 {count} 个值与其余的值不符：请查看，并予以排除或保留</numerusform>
        </translation>
    </message>
    <message>
        <source>the backup {file}</source>
        <translation>备份 {file}</translation>
    </message>
    <message>
        <source>the table of axis {index}</source>
        <translation>轴 {index} 的表</translation>
    </message>
    <message>
        <source>the table of axis {index} ({axis})</source>
        <translation>轴 {index}（{axis}）的表</translation>
    </message>
    <message>
        <source>{temperature}</source>
        <translation>{temperature}</translation>
    </message>
    <message>
        <source>measured in {count} thermal states: {temperatures}; outside of them the drive holds the values of the ends</source>
        <translation>在 {count} 个热状态下测量：{temperatures}；超出其范围，驱动器保持端值</translation>
    </message>
    <message>
        <source>the table is straight over temperature, which leaves up to {largest} of what was measured in a state</source>
        <translation>该表随温度呈直线变化，某一状态下测得的误差因此最多残留 {largest}</translation>
    </message>
    <message>
        <source>the table has the movement of the zero from one thermal state to the other, as the instrument saw it: that is only right if its own zero was not set anew in between</source>
        <translation>该表包含仪器所见的零点从一个热状态到另一热状态的移动：只有仪器自身的零点在其间没有重新设置，这才是正确的</translation>
    </message>
    <message>
        <source>at {temperature}: {sentence}</source>
        <translation>在 {temperature}：{sentence}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {after} after</source>
        <translation>{figure} 补偿前 {before}，补偿后 {after}</translation>
    </message>
    <message>
        <source>{figure} {after}</source>
        <translation>{figure} {after}</translation>
    </message>
    <message>
        <source>{figure} {before} before, {predicted} predicted, not measured since</source>
        <translation>{figure} 补偿前 {before}，预测 {predicted}，此后未测量</translation>
    </message>
    <message>
        <source>{figure} {before} before, not measured since</source>
        <translation>{figure} 补偿前 {before}，此后未测量</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance})</source>
        <translation>{values}（公差 {tolerance}）</translation>
    </message>
    <message>
        <source>{values} (tolerance {tolerance}: {result})</source>
        <translation>{values}（公差 {tolerance}：{result}）</translation>
    </message>
    <message>
        <source>{first}; {next}</source>
        <translation>{first}；{next}</translation>
    </message>
    <message>
        <source>measured {date}: {figures}</source>
        <translation>测量于 {date}：{figures}</translation>
    </message>
    <message>
        <source>{figure} {before} before</source>
        <translation>{figure} 补偿前 {before}</translation>
    </message>
    <message>
        <source>{figure} {after}, {before} before</source>
        <translation>{figure} {after}，补偿前 {before}</translation>
    </message>
    <message>
        <source>there is a table for each direction, and the reversal of up to {reversal} is in them: switch off the controller&apos;s own backlash compensation</source>
        <translation>每个方向各有一个表，最大 {reversal} 的反向差值已包含在内：请关闭控制器自身的反向间隙补偿</translation>
    </message>
    <message>
        <source>approached upwards: {sentence}</source>
        <translation>正向趋近：{sentence}</translation>
    </message>
    <message>
        <source>approached downwards: {sentence}</source>
        <translation>负向趋近：{sentence}</translation>
    </message>
    <message>
        <source>the new table is coarser than {name}: up to {lost} of what that has between the new points is lost; take more points</source>
        <translation>新表比 {name} 粗：原表在新点之间的内容最多损失 {lost}；请取更多的点</translation>
    </message>
    <message numerus="yes">
        <source>{count} values do not fit the others and are in the table; judging names them, and they can be excluded</source>
        <comment>1 value does not fit the others and is in the table; judging names it, and it can be excluded</comment>
        <translation>
            <numerusform>有 {count} 个值与其余的值不符，但已计入该表；评定时会列出，可予以排除</numerusform>
        </translation>
    </message>
    <message>
        <source>the targets are not all at the same place of a period of the axis; no period is stated</source>
        <translation>目标位置并非都在轴的周期的同一处；没有给出周期</translation>
    </message>
    <message>
        <source>from {from} to {to} nothing was measured, {gap} of a turn of {turn}: there the table is guessed, and no figure knows of it; measure the whole turn</source>
        <translation>从 {from} 到 {to} 未作测量，占一转 {turn} 中的 {gap}：该处的表只是推测，任何指标都反映不出来；请测量整转</translation>
    </message>
    <message>
        <source>most of this error is reversal, which no table removes: the table is for one direction, and up to {reversal} remains in the other</source>
        <translation>此误差主要是反向差值，任何表都不能消除：该表用于一个方向，另一方向最多残留 {reversal}</translation>
    </message>
    <message>
        <source>each figure, before and foretold, is the largest of a thermal state and of all runs together</source>
        <translation>补偿前和预测的各项指标，均取各热状态以及全部各趟合计中的最大值</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of both tables for their zero</source>
        <translation>为了零点，已从两个表的所有值中去除 {constant}</translation>
    </message>
    <message>
        <source>{constant} was taken out of all values of {table} for its zero</source>
        <translation>为了零点，已从 {table} 的所有值中去除 {constant}</translation>
    </message>
    <message>
        <source>the new table is shorter than {name}: up to {lost} of what that has beyond the ends of the new one is lost; ask for no grid, which keeps that of {name}, or for one as long, or measure the whole of it</source>
        <translation>新表比 {name} 短：{name} 在新表两端之外的内容最多丢失 {lost}；不指定网格即可保留原网格，或指定同样长的网格，或测量整个行程</translation>
    </message>
    <message>
        <source>the rule grubbs is for 4 to 10 values of a target, and some of those {direction} were not tested</source>
        <translation>规则 grubbs 适用于每个目标位置 4 到 10 个值，{direction}的部分值未经检验</translation>
    </message>
    <message>
        <source>a value {direction} stands out that the rule mad does not propose: it keeps 3 values of each target, and needs others that differ</source>
        <translation>{direction}有一个突出的值，规则 mad 不予建议：它为每个目标位置保留 3 个值，并且需要其他值有差异</translation>
    </message>
    <message>
        <source>{table} goes from {from} to {to}, the targets from {first} to {last}: beyond its ends the drive holds their values; take the number of points, or a distance that divides the range of the targets</source>
        <translation>{table} 从 {from} 到 {to}，而目标位置从 {first} 到 {last}：两端以外驱动器保持端点值；请给出点数，或能整除目标位置范围的间距</translation>
    </message>
    <message>
        <source>the first target is {first}; the table is for an axis that counts from {from} to {to}: where it counts otherwise, the drive holds the values at the ends</source>
        <translation>第一个目标位置为 {first}；该表格适用于从 {from} 计数到 {to} 的轴：在其他计数处，驱动器保持端点值</translation>
    </message>
    <message>
        <source>{read} ({corrected} after corrections)</source>
        <translation>{read}（修正后 {corrected}）</translation>
    </message>
    <message>
        <source>first measurement: {remark}</source>
        <translation>第一次测量：{remark}</translation>
    </message>
    <message>
        <source>second measurement: {remark}</source>
        <translation>第二次测量：{remark}</translation>
    </message>
    <message>
        <source>of all values {figure} is {value} (tolerance {tolerance}: {result})</source>
        <translation>按所有值计算，{figure}为 {value}（公差 {tolerance}：{result}）</translation>
    </message>
    <message>
        <source>the first measurement is of the machine {before}, the second of {after}</source>
        <translation>第一次测量的机床为 {before}，第二次为 {after}</translation>
    </message>
    <message>
        <source>the first measurement has the serial number {before}, the second {after}</source>
        <translation>第一次测量的序列号为 {before}，第二次为 {after}</translation>
    </message>
    <message>
        <source>the angle between {first} and {second} is {angle} more than 90 degrees</source>
        <translation>{first} 和 {second} 之间的夹角比 90 度大 {angle}</translation>
    </message>
    <message numerus="yes">
        <source>{count} values of {table} do not fit the others and count little; the first is at {place}, {residual} off</source>
        <comment>1 value of {table} does not fit the others and counts little: at {place}, {residual} off</comment>
        <translation>
            <numerusform>{table} 中有 {count} 个值与其余的值不符，权重降低；第一个在 {place}，相差 {residual}</numerusform>
        </translation>
    </message>
    <message>
        <source>first measurement from {beforeFirst} to {beforeLast}, second one from {afterFirst} to {afterLast}</source>
        <translation>第一次测量从 {beforeFirst} 到 {beforeLast}，第二次从 {afterFirst} 到 {afterLast}</translation>
    </message>
    <message>
        <source>{ranges}: over a shorter travel the figures are smaller whatever the compensation does, and nothing is proved for the rest</source>
        <translation>{ranges}：行程较短时，无论补偿效果如何，指标都会变小，其余部分没有得到验证</translation>
    </message>
    <message>
        <source>{figures}, over part of the travel</source>
        <translation>{figures}（仅部分行程）</translation>
    </message>
    <message>
        <source>{removed} was taken out for the zero of the table</source>
        <translation>为表的零点去除了 {removed}</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope and the zero of the table</source>
        <translation>为表的斜率和零点去除了 {removed}</translation>
    </message>
    <message>
        <source>{removed} was taken out for the slope</source>
        <translation>为斜率去除了 {removed}</translation>
    </message>
    <message>
        <source>{removed} was taken out for how the artefact lay and for the zero of the table</source>
        <translation>为标准器的放置状态和表的零点去除了 {removed}</translation>
    </message>
    <message>
        <source>{evened} was taken out by gain, averaging, smoothing or grid</source>
        <translation>因系数、平均、平滑或网格去除了 {evened}</translation>
    </message>
    <message>
        <source>{removed}, and {evened} by gain, averaging, smoothing or grid</source>
        <translation>{removed}，并因系数、平均、平滑或网格去除了 {evened}</translation>
    </message>
    <message>
        <source>at {position} the reference was {measured} beside the encoder in {table}; {taken}, so the drive will add {added}</source>
        <translation>在 {position} 处，{table} 中基准与编码器相差 {measured}；{taken}，因此驱动器将叠加 {added}</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; {taken}, so the drive will add {added}</source>
        <translation>编码器读数为 {reading} 处，基准为 {reference}（双向平均，{count} 个值）；{taken}，因此驱动器将叠加 {added}</translation>
    </message>
    <message>
        <source>where the encoder reads {reading} the reference said {reference}, the mean of both directions with {count} values; the drive will add {added}</source>
        <translation>编码器读数为 {reading} 处，基准为 {reference}（双向平均，{count} 个值）；驱动器将叠加 {added}</translation>
    </message>
    <message numerus="yes">
        <source>where the encoder reads {reading} the reference said {reference} on average of {count} values; {taken}, so the drive will add {added}</source>
        <comment>where the encoder reads {reading} the reference said {reference}, measured once; {taken}, so the drive will add {added}</comment>
        <translation>
            <numerusform>编码器读数为 {reading} 处，基准为 {reference}（{count} 个值的平均）；{taken}，因此驱动器将叠加 {added}</numerusform>
        </translation>
    </message>
    <message>
        <source>the second measurement is of {date}, and the record has one of {last} with the same table, which decides</source>
        <translation>第二次测量的日期为 {date}，而档案中已有同一补偿表在 {last} 的测量，以后者为准</translation>
    </message>
    <message>
        <source>the targets of the second measurement are up to {second} apart, those of the first one up to {first}: what lies between them is not measured again</source>
        <translation>第二次测量的目标位置最大间距为 {second}，第一次为 {first}：其间未重新测量</translation>
    </message>
    <message>
        <source>between the targets the error is not known well enough: foretold without each target, E of the direction that was measured is {heldOut}, before it was {before}; measure at more targets</source>
        <translation>目标位置之间的误差了解不足：逐个留出目标位置的预测，所测方向的 E 为 {heldOut}，而补偿前为 {before}；请测量更多的目标位置</translation>
    </message>
    <message>
        <source>0 = mean at {position}</source>
        <translation>0 = {position} 处的均值</translation>
    </message>
    <message>
        <source>{said} (file {file})</source>
        <translation>{said}（文件 {file}）</translation>
    </message>
    <message>
        <source>the files are of different machines: {machines}</source>
        <translation>各文件的机床不同：{machines}</translation>
    </message>
    <message>
        <source>the files have different serial numbers: {numbers}</source>
        <translation>各文件的序列号不同：{numbers}</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg or .pdf.</source>
        <translation>文件名必须以 .png、.svg 或 .pdf 结尾。</translation>
    </message>
    <message>
        <source>Save picture or values</source>
        <translation>保存图片或值</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>图形 (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>文档 (*.pdf)</translation>
    </message>
    <message>
        <source>Values (*.csv)</source>
        <translation>值 (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
</context>
<context>
    <name>PlanText</name>
    <message>
        <source>Axis %1: %2 targets, %3 values</source>
        <translation>轴 %1：%2 个目标位置，%3 个值</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>the file holds no data</source>
        <translation>文件中没有数据</translation>
    </message>
    <message>
        <source>export it again, or choose another file</source>
        <translation>请重新导出，或选择其他文件</translation>
    </message>
    <message>
        <source>the header line with the names of the columns is missing</source>
        <translation>缺少含列名的标题行</translation>
    </message>
    <message>
        <source>add a first line such as X [mm],Table 1 [mm], or for a measurement target [mm],direction,run,deviation [um]</source>
        <translation>在首行添加例如 X [mm],Table 1 [mm]；对测量则为 target [mm],direction,run,deviation [um]</translation>
    </message>
    <message>
        <source>the header has too few columns</source>
        <translation>标题行的列太少</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has</source>
        <translation>选择文件的维数</translation>
    </message>
    <message>
        <source>this line does not have as many columns as the header</source>
        <translation>该行的列数与标题行不同</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>这不是数字</translation>
    </message>
    <message>
        <source>this number is not finite</source>
        <translation>该数字不是有限值</translation>
    </message>
    <message>
        <source>it is not clear which sign is the decimal one</source>
        <translation>不清楚哪个是小数点符号</translation>
    </message>
    <message>
        <source>use one decimal sign in all numbers, and none between thousands</source>
        <translation>所有数字使用同一个小数点，千位之间不加分隔符</translation>
    </message>
    <message>
        <source>a quotation mark is not closed as it should be</source>
        <translation>引号没有正确闭合</translation>
    </message>
    <message>
        <source>the same position occurs twice</source>
        <translation>同一位置出现两次</translation>
    </message>
    <message>
        <source>delete one of the two lines</source>
        <translation>删除两行之一</translation>
    </message>
    <message>
        <source>the grid is incomplete</source>
        <translation>网格不完整</translation>
    </message>
    <message>
        <source>the positions are not evenly spaced</source>
        <translation>位置间距不均匀</translation>
    </message>
    <message>
        <source>resample the data onto an even grid, which can be done here for a calibration file only</source>
        <translation>将数据重采样到均匀网格，此处仅可对校准文件进行</translation>
    </message>
    <message>
        <source>there are too few points</source>
        <translation>点太少</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>文件太大</translation>
    </message>
    <message>
        <source>choose a coarser grid, or split the file</source>
        <translation>选择较粗的网格，或拆分文件</translation>
    </message>
    <message>
        <source>this is not a text file</source>
        <translation>这不是文本文件</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>无法读取该文件</translation>
    </message>
    <message>
        <source>the file is not valid UTF-8 and is read as Windows-1252</source>
        <translation>文件不是有效的 UTF-8，按 Windows-1252 读取</translation>
    </message>
    <message>
        <source>the positions are even only within the printed precision</source>
        <translation>位置仅在输出精度内等间距</translation>
    </message>
    <message>
        <source>the even grid is used; print more decimals if that is not meant</source>
        <translation>采用均匀网格；如非本意，请输出更多小数位</translation>
    </message>
    <message>
        <source>a value loses precision when it is stored as float32</source>
        <translation>有一个值存为 float32 时损失精度</translation>
    </message>
    <message>
        <source>check the unit of the values</source>
        <translation>检查值的单位</translation>
    </message>
    <message>
        <source>the table is very steep, which is likely a unit mistake</source>
        <translation>该表很陡，可能是单位有误</translation>
    </message>
    <message>
        <source>all values of the table are equal</source>
        <translation>表的所有值都相等</translation>
    </message>
    <message>
        <source>check that this column is meant</source>
        <translation>检查是否应采用此列</translation>
    </message>
    <message>
        <source>found an empty cell</source>
        <translation>单元格为空</translation>
    </message>
    <message>
        <source>this is not written as the format demands</source>
        <translation>写法不符合格式要求</translation>
    </message>
    <message>
        <source>the positions do not go in one direction</source>
        <translation>位置不是单向变化</translation>
    </message>
    <message>
        <source>the table does not close after one revolution</source>
        <translation>该表在一转之后不闭合</translation>
    </message>
    <message>
        <source>the controller does not take as much</source>
        <translation>控制器不接受这么多</translation>
    </message>
    <message>
        <source>this entry is not known and is left out</source>
        <translation>无法识别该条目，已略去</translation>
    </message>
    <message>
        <source>the file does not say a unit</source>
        <translation>文件没有注明单位</translation>
    </message>
    <message>
        <source>the file can be understood in several ways</source>
        <translation>文件可作多种理解</translation>
    </message>
    <message>
        <source> (error %1 of the controller)</source>
        <translation> （控制器错误 %1）</translation>
    </message>
    <message>
        <source>found &quot;{found}&quot;</source>
        <translation>实为“{found}”</translation>
    </message>
    <message>
        <source>found {found}</source>
        <translation>实为 {found}</translation>
    </message>
    <message>
        <source>{problem}: {found}</source>
        <translation>{problem}：{found}</translation>
    </message>
    <message>
        <source>{problem}, expected {expected}</source>
        <translation>{problem}，应为：{expected}</translation>
    </message>
    <message>
        <source>{problem}; {wayOut}</source>
        <translation>{problem}；{wayOut}</translation>
    </message>
    <message>
        <source>the axis that the values correct cannot be told</source>
        <translation>无法判断值修正的是哪个轴</translation>
    </message>
    <message>
        <source>check the units of values and positions</source>
        <translation>检查值和位置的单位</translation>
    </message>
    <message>
        <source>points without a value are filled</source>
        <translation>没有值的点将被填补</translation>
    </message>
    <message>
        <source>the grid is cropped to the points that have a value</source>
        <translation>网格裁剪为有值的点</translation>
    </message>
    <message>
        <source>positions are snapped to the grid</source>
        <translation>位置吸附到网格</translation>
    </message>
    <message>
        <source>comments from here on are not kept with the table</source>
        <translation>此后的注释不随表保存</translation>
    </message>
    <message>
        <source>the file has another dimensionality than the one chosen</source>
        <translation>文件的维数与所选的不同</translation>
    </message>
    <message>
        <source>choose the dimensionality that the file has (--dims)</source>
        <translation>选择文件的维数 (--dims)</translation>
    </message>
    <message>
        <source>the columns do not say what was measured</source>
        <translation>各列没有说明测量了什么</translation>
    </message>
    <message>
        <source>the unit of a column is not known</source>
        <translation>无法识别某一列的单位</translation>
    </message>
    <message>
        <source>a length and an angle are mixed</source>
        <translation>混用了长度和角度</translation>
    </message>
    <message>
        <source>correct the unit in the file, or state it</source>
        <translation>更正文件中的单位，或注明单位</translation>
    </message>
    <message>
        <source>this is not a direction</source>
        <translation>这不是方向</translation>
    </message>
    <message>
        <source>this is not the number of a run</source>
        <translation>这不是趟次编号</translation>
    </message>
    <message>
        <source>the same value is there twice</source>
        <translation>同一个值出现两次</translation>
    </message>
    <message>
        <source>the file holds another number than it says</source>
        <translation>文件中的个数与其所述不符</translation>
    </message>
    <message>
        <source>there are too few targets</source>
        <translation>目标位置太少</translation>
    </message>
    <message>
        <source>there is no target of this number</source>
        <translation>没有此编号的目标位置</translation>
    </message>
    <message>
        <source>positions do not follow one another one to one</source>
        <translation>各位置之间不是一比一</translation>
    </message>
    <message>
        <source>values are missing</source>
        <translation>缺少值</translation>
    </message>
    <message>
        <source>the figures are made of the values that are there</source>
        <translation>指标由现有的值得出</translation>
    </message>
    <message>
        <source>the directions have different numbers of runs</source>
        <translation>两个方向的趟数不同</translation>
    </message>
    <message>
        <source>the values look like positions instead of deviations</source>
        <translation>这些值像是位置而不是偏差</translation>
    </message>
    <message>
        <source>if they are positions of the reference, say so: --values reference, or name the column reference</source>
        <translation>如果是基准的位置，请注明：--values reference，或将该列命名为 reference</translation>
    </message>
    <message>
        <source>the size of the values is unusual</source>
        <translation>值的大小异常</translation>
    </message>
    <message>
        <source>a result in the file is not what its values give</source>
        <translation>文件中有一个结果与其值不符</translation>
    </message>
    <message>
        <source>not everything in the file is used</source>
        <translation>文件的内容未全部采用</translation>
    </message>
    <message>
        <source>an entry {key}</source>
        <translation>条目 {key}</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>one of {known}</source>
        <translation>{known} 之一</translation>
    </message>
    <message>
        <source>sections that begin with [[{key}]]</source>
        <translation>以 [[{key}]] 开始的段</translation>
    </message>
    <message>
        <source>at most {count} of them</source>
        <translation>最多 {count} 个</translation>
    </message>
    <message>
        <source>a known key; the nearest is {key}</source>
        <translation>已知的键；最接近的是 {key}</translation>
    </message>
    <message>
        <source>valid TOML ({reason})</source>
        <translation>有效的 TOML（{reason}）</translation>
    </message>
    <message>
        <source>{number}, the version of this format</source>
        <translation>{number}，即此格式的版本</translation>
    </message>
    <message>
        <source>{name} is a drive in line {line} already</source>
        <translation>{name} 在第 {line} 行已是一台驱动器</translation>
    </message>
    <message>
        <source>serial number {name} is in line {line} already</source>
        <translation>序列号 {name} 已在第 {line} 行</translation>
    </message>
    <message>
        <source>a list of one to three registers</source>
        <translation>一至三个寄存器的列表</translation>
    </message>
    <message>
        <source>settings as {example}</source>
        <translation>设置，例如 {example}</translation>
    </message>
    <message>
        <source>a text, a number, true or false</source>
        <translation>文本、数字、true 或 false</translation>
    </message>
    <message>
        <source>an entry file, or no-table = true for an axis that shall have none</source>
        <translation>条目 file；若该轴不应有表，则为 no-table = true</translation>
    </message>
    <message>
        <source>{key} of an axis without a table</source>
        <translation>无表的轴的 {key}</translation>
    </message>
    <message>
        <source>no-table beside file</source>
        <translation>no-table 与 file 并存</translation>
    </message>
    <message>
        <source>an entry sources, with the register that looks the table up for each of its dimensions</source>
        <translation>条目 sources，为每个维度给出查表所用的寄存器</translation>
    </message>
    <message>
        <source>axis {name} of this drive is in line {line} already</source>
        <translation>此驱动器的轴 {name} 已在第 {line} 行</translation>
    </message>
    <message>
        <source>slot {name} is taken by the axis in line {line}</source>
        <translation>表槽 {name} 已被第 {line} 行的轴占用</translation>
    </message>
    <message>
        <source>save it as UTF-8 text</source>
        <translation>保存为 UTF-8 编码的文本</translation>
    </message>
    <message>
        <source>check the names and notes, or save it as UTF-8 text</source>
        <translation>检查名称和备注，或保存为 UTF-8 编码的文本</translation>
    </message>
    <message>
        <source>the directions of the runs are doubtful</source>
        <translation>各趟的方向可疑</translation>
    </message>
    <message>
        <source>compare them with the data, and exchange them if they are the other way round</source>
        <translation>与数据对照，如方向相反则对调</translation>
    </message>
    <message>
        <source>line {line}: {problem}</source>
        <translation>第 {line} 行：{problem}</translation>
    </message>
    <message>
        <source>two statements contradict each other</source>
        <translation>两处说明相互矛盾</translation>
    </message>
    <message>
        <source>the serial number of the drive, a whole number of at most 32 bits, without quotation marks</source>
        <translation>驱动器序列号：不超过 32 位（bit）的整数，不加引号</translation>
    </message>
    <message>
        <source>a text that is not empty and has no control characters</source>
        <translation>非空且不含控制字符的文本</translation>
    </message>
    <message>
        <source>a name, or a whole number that is not negative</source>
        <translation>名称，或非负整数</translation>
    </message>
    <message>
        <source>a number that is not negative and its unit, such as {example}</source>
        <translation>非负数及其单位，例如 {example}</translation>
    </message>
    <message>
        <source>UTF-8 text</source>
        <translation>UTF-8 文本</translation>
    </message>
    <message>
        <source>delete one of the two</source>
        <translation>删除两者之一</translation>
    </message>
    <message>
        <source>a text; write it in quotation marks</source>
        <translation>文本；请写在引号中</translation>
    </message>
    <message>
        <source>a text; write {source} for the first source, {name} for an axis of that name</source>
        <translation>文本；第一个源写 {source}，该名称的轴写 {name}</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Deviation in {unit}</source>
        <translation>偏差（{unit}）</translation>
    </message>
    <message>
        <source>Position in {unit}</source>
        <translation>位置（{unit}）</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions with bands of 2 s, the mean of both, single runs</source>
        <translation>偏差随位置的变化：两个方向的平均值及 2 s 带、双向平均值、各单趟</translation>
    </message>
    <message>
        <source>What lines and markers mean</source>
        <translation>线条和标记的含义</translation>
    </message>
    <message>
        <source>mean ↑</source>
        <translation>平均值 ↑</translation>
    </message>
    <message>
        <source>mean ↓</source>
        <translation>平均值 ↓</translation>
    </message>
    <message>
        <source>mean of both</source>
        <translation>双向平均值</translation>
    </message>
    <message>
        <source>mean ↑ ± 2 s</source>
        <translation>平均值 ↑ ± 2 s</translation>
    </message>
    <message>
        <source>mean ↓ ± 2 s</source>
        <translation>平均值 ↓ ± 2 s</translation>
    </message>
    <message>
        <source>single run</source>
        <translation>单趟</translation>
    </message>
    <message>
        <source>dead path of {length}: values changed by up to {largest}</source>
        <translation>死程 {length}：值最多改变 {largest}</translation>
    </message>
    <message>
        <source>drift taken out for the table, not for figures</source>
        <translation>仅为生成表去除了漂移，指标未去除</translation>
    </message>
    <message>
        <source>smooth grid of scattered points</source>
        <translation>由离散点得到的平滑网格</translation>
    </message>
    <message>
        <source>{method}, from the runs ↑</source>
        <translation>{method}，由 ↑ 各趟得出</translation>
    </message>
    <message>
        <source>{method}, from the runs ↓</source>
        <translation>{method}，由 ↓ 各趟得出</translation>
    </message>
    <message>
        <source>{method}, from the mean of both directions</source>
        <translation>{method}，由双向平均值得出</translation>
    </message>
    <message>
        <source>failed after {share} of the table</source>
        <translation>检查了表的 {share} 后失败</translation>
    </message>
    <message>
        <source>passed over {share} of the table</source>
        <translation>在表的 {share} 上通过</translation>
    </message>
    <message>
        <source>At the set position {position} the drive adds {added} to what the encoder reads.</source>
        <translation>在给定位置 {position} 处，驱动器在编码器读数上叠加 {added}。</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the drive adds {added}.</source>
        <translation>编码器读数为 {reading} 处，驱动器叠加 {added}。</translation>
    </message>
    <message>
        <source>Where the encoder reads {reading}, the reference said {reference}: the drive adds {added}.</source>
        <translation>编码器读数为 {reading} 处，基准为 {reference}：驱动器叠加 {added}。</translation>
    </message>
    <message>
        <source>Compensation of axis {axis}, machine {machine}</source>
        <translation>机床 {machine} 的轴 {axis} 的补偿</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>The accuracy A before is not defined.</source>
        <translation>补偿前的定位精度 A 无定义。</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Serial number of the drive</source>
        <translation>驱动器序列号</translation>
    </message>
    <message>
        <source>Firmware profile</source>
        <translation>固件描述文件</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>补偿后</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Feed, dwell</source>
        <translation>进给速度、停留时间</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>环境</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Targets and runs</source>
        <translation>目标位置和趟次</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>air {air}, material {material}, expansion {expansion}</source>
        <translation>空气 {air}，材料 {material}，膨胀系数 {expansion}</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>on, which table is not stated</source>
        <translation>开启，未注明哪个表</translation>
    </message>
    <message>
        <source>on, table {crc}</source>
        <translation>开启，表 {crc}</translation>
    </message>
    <message>
        <source>to 20 °C by the instrument</source>
        <translation>由仪器修正到 20 °C</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>none here, by the instrument not stated</source>
        <translation>此处未修正，仪器是否修正未注明</translation>
    </message>
    <message>
        <source>no targets: {kind}</source>
        <translation>无目标位置：{kind}</translation>
    </message>
    <message>
        <source>{direction} target {target} run {run}</source>
        <translation>{direction} 目标位置 {target} 第 {run} 趟</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>{count} values: not an evaluation by ISO 230-2</source>
        <translation>{count} 个值：不属于按 GB/T 17421.2 的评定</translation>
    </message>
    <message>
        <source>{values}: not an evaluation by ISO 230-2</source>
        <translation>{values}：不属于按 GB/T 17421.2 的评定</translation>
    </message>
    <message>
        <source>Deviation over position: before, after, to one scale</source>
        <translation>偏差随位置的变化：补偿前、补偿后，同一比例</translation>
    </message>
    <message>
        <source>Deviation over position, before</source>
        <translation>偏差随位置的变化，补偿前</translation>
    </message>
    <message>
        <source>Deviation over position, after</source>
        <translation>偏差随位置的变化，补偿后</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014 in {unit}</source>
        <translation>GB/T 17421.2 (ISO 230-2:2014) 指标（{unit}）</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>Verdict on the measurement after</source>
        <translation>补偿后测量的判定</translation>
    </message>
    <message>
        <source>Verdict on the measurement before</source>
        <translation>补偿前测量的判定</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>不确定度 U，k = 2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>uncertainty U, k = 2</source>
        <translation>不确定度 U，k = 2</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
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
        <translation>表槽</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>End-to-end proof</source>
        <translation>驱动器上的验证</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>{count} points from {from} to {to}</source>
        <translation>从 {from} 到 {to} 的 {count} 点</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>持久</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>易失</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>none on record</source>
        <translation>档案中无</translation>
    </message>
    <message numerus="yes">
        <source>and {count} more in the record</source>
        <comment>and 1 more in the record</comment>
        <translation>
            <numerusform>档案中另有 {count} 条</numerusform>
        </translation>
    </message>
    <message>
        <source>Input files</source>
        <translation>输入文件</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Made by Axis Compensation Wizard {version}. Figures that the values do not define are not defined; what is not on record is not stated.</source>
        <translation>由轴补偿向导 {version} 生成。由值不能得出的指标为无定义；档案中没有的内容为未注明。</translation>
    </message>
    <message>
        <source>Targets before, in {unit}</source>
        <translation>补偿前的目标位置（{unit}）</translation>
    </message>
    <message>
        <source>Targets after, in {unit}</source>
        <translation>补偿后的目标位置（{unit}）</translation>
    </message>
    <message>
        <source>target in {unit}</source>
        <translation>目标位置（{unit}）</translation>
    </message>
    <message>
        <source>values ↑</source>
        <translation>值 ↑</translation>
    </message>
    <message>
        <source>s ↑</source>
        <translation>s ↑</translation>
    </message>
    <message>
        <source>values ↓</source>
        <translation>值 ↓</translation>
    </message>
    <message>
        <source>s ↓</source>
        <translation>s ↓</translation>
    </message>
    <message>
        <source>Left out: {values}</source>
        <translation>已排除：{values}</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未注明</translation>
    </message>
    <message>
        <source>The accuracy A is not defined, before or after.</source>
        <translation>定位精度 A 在补偿前和补偿后均无定义。</translation>
    </message>
    <message>
        <source>{figure}: {before} before, {after} after.</source>
        <translation>{figure}：补偿前 {before}，补偿后 {after}。</translation>
    </message>
    <message>
        <source>{method}, over position and temperature</source>
        <translation>{method}，按位置和温度</translation>
    </message>
    <message>
        <source>Each figure is the largest of a thermal state and of all runs together.</source>
        <translation>各项指标均取各热状态以及全部各趟合计中的最大值。</translation>
    </message>
    <message>
        <source>air {air}, material {material}, values measured at {values}, expansion {expansion}</source>
        <translation>空气 {air}，材料 {material}，测量各值时 {values}，膨胀系数 {expansion}</translation>
    </message>
    <message>
        <source>{from} to {to}</source>
        <translation>{from} 至 {to}</translation>
    </message>
    <message>
        <source>Warning: {warning}.</source>
        <translation>警告：{warning}。</translation>
    </message>
    <message>
        <source>up and down exchanged</source>
        <translation>已对调正向和负向</translation>
    </message>
    <message>
        <source>reference taken with the opposite sign</source>
        <translation>基准以相反的符号使用</translation>
    </message>
    <message>
        <source>unit of {what} taken as {stated}, the file says {unit}</source>
        <translation>{what} 的单位按 {stated} 使用，文件中写的是 {unit}</translation>
    </message>
    <message>
        <source>slope taken out for the table, not for figures</source>
        <translation>仅为生成表去除了斜率，指标未去除</translation>
    </message>
    <message>
        <source>to {standard}, {conditions}: values changed by up to {largest}</source>
        <translation>修正到 {standard}，{conditions}：值最多改变 {largest}</translation>
    </message>
    <message>
        <source>scale at {temperature} with {expansion}</source>
        <translation>标尺 {temperature}，膨胀系数 {expansion}</translation>
    </message>
    <message>
        <source>reference at {temperature} with {expansion}</source>
        <translation>基准 {temperature}，膨胀系数 {expansion}</translation>
    </message>
    <message>
        <source>datum at {position}</source>
        <translation>固定点 {position}</translation>
    </message>
    <message numerus="yes">
        <source>{count} targets from {from} to {to}</source>
        <comment>1 target from {from} to {to}</comment>
        <translation>
            <numerusform>从 {from} 到 {to} 的 {count} 个目标位置</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} runs {direction}</source>
        <comment>1 run {direction}</comment>
        <translation>
            <numerusform>{direction} {count} 趟</numerusform>
        </translation>
    </message>
    <message>
        <source>means {direction}</source>
        <translation>平均值 {direction}</translation>
    </message>
    <message>
        <source>no means {direction}</source>
        <translation>无平均值 {direction}</translation>
    </message>
    <message>
        <source>Deviation over position: means of both directions, the mean of both</source>
        <translation>偏差随位置的变化：两个方向的平均值、双向平均值</translation>
    </message>
    <message>
        <source>on, table {crc}, as stated with the measurement</source>
        <translation>开启，表 {crc}（按测量时的说明）</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表</translation>
    </message>
    <message>
        <source>that of each table, below</source>
        <translation>各表的校验和见下</translation>
    </message>
    <message>
        <source>{name} for axis {axis}, CRC-32 {crc}</source>
        <translation>{name} 用于轴 {axis}，CRC-32 {crc}</translation>
    </message>
    <message>
        <source>Compensation of axis {target} over axis {axis}, machine {machine}</source>
        <translation>轴 {target} 随轴 {axis} 的补偿，机床 {machine}</translation>
    </message>
    <message>
        <source>At the set position {position} of axis {axis} the drive adds {added} to what the encoder of axis {target} reads.</source>
        <translation>在轴 {axis} 的设定位置 {position} 处，驱动器在轴 {target} 的编码器读数上加 {added}。</translation>
    </message>
    <message>
        <source>Where the encoder of axis {axis} reads {position}, the drive adds {added} to axis {target}.</source>
        <translation>当轴 {axis} 的编码器读数为 {position} 时，驱动器在轴 {target} 上加 {added}。</translation>
    </message>
    <message>
        <source>values taken as positions of the reference, the file says deviations</source>
        <translation>数值按参考位置读取，文件中写的是偏差</translation>
    </message>
    <message>
        <source>values taken as deviations, the file says positions of the reference</source>
        <translation>数值按偏差读取，文件中写的是参考位置</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before, {after} after.</source>
        <translation>定位精度 {figure}：补偿前 {before}，补偿后 {after}。</translation>
    </message>
    <message>
        <source>Accuracy {figure}: {before} before. There is no measurement afterwards on record.</source>
        <translation>定位精度 {figure}：补偿前 {before}。档案中没有补偿后的测量。</translation>
    </message>
    <message>
        <source>Held out: what is left at targets that the table was made without: {figure} {range}, rms {rms}, largest {largest}. Of the two predictions this is the one to believe.</source>
        <translation>留出：未用于生成表的目标位置上的残余误差：{figure} {range}，均方根 {rms}，最大 {largest}。两种预测中以此为准。</translation>
    </message>
    <message>
        <source>before, all values</source>
        <translation>补偿前，所有值</translation>
    </message>
    <message>
        <source>after, all values</source>
        <translation>补偿后，所有值</translation>
    </message>
    <message>
        <source>all values</source>
        <translation>所有值</translation>
    </message>
    <message>
        <source>verdict, all values</source>
        <translation>判定，所有值</translation>
    </message>
    <message>
        <source>Targets before, all values, in {unit}</source>
        <translation>补偿前的目标位置，所有值（{unit}）</translation>
    </message>
    <message>
        <source>Targets after, all values, in {unit}</source>
        <translation>补偿后的目标位置，所有值（{unit}）</translation>
    </message>
    <message>
        <source>{said} ({files})</source>
        <translation>{said}（{files}）</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before, {after} after.</source>
        <translation>按所有值（含已排除的值）计算的定位精度 {figure}：补偿前 {before}，补偿后 {after}。</translation>
    </message>
    <message>
        <source>Accuracy {figure} of all values, with those that are left out: {before} before.</source>
        <translation>按所有值（含已排除的值）计算的定位精度 {figure}：补偿前 {before}。</translation>
    </message>
</context>
<context>
    <name>RunValueText</name>
    <message>
        <source>%1, target %2, run %3, %4</source>
        <translation>%1，目标位置 %2，第 %3 趟，%4</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>建议排除</translation>
    </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>counts per unit</source>
        <translation>每单位计数</translation>
    </message>
    <message>
        <source>position unit</source>
        <translation>位置的单位</translation>
    </message>
    <message>
        <source>value unit</source>
        <translation>值的单位</translation>
    </message>
    <message>
        <source>wrap range</source>
        <translation>回绕范围</translation>
    </message>
    <message>
        <source>master axis</source>
        <translation>主动轴</translation>
    </message>
    <message>
        <source>master1 axis</source>
        <translation>主动轴 1</translation>
    </message>
    <message>
        <source>master2 axis</source>
        <translation>主动轴 2</translation>
    </message>
    <message>
        <source>n cycles</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>master kind</source>
        <translation>主动轴类型</translation>
    </message>
    <message>
        <source>master1 kind</source>
        <translation>主动轴 1 类型</translation>
    </message>
    <message>
        <source>master2 kind</source>
        <translation>主动轴 2 类型</translation>
    </message>
    <message>
        <source>axis kind</source>
        <translation>轴类型</translation>
    </message>
    <message>
        <source>modulo</source>
        <translation>模数</translation>
    </message>
    <message>
        <source>modulo1</source>
        <translation>模数 1</translation>
    </message>
    <message>
        <source>modulo2</source>
        <translation>模数 2</translation>
    </message>
    <message>
        <source>list unit</source>
        <translation>列表的单位</translation>
    </message>
    <message>
        <source>increments per unit</source>
        <translation>每单位增量数</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>小数</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>type</source>
        <translation>文件类型</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>first table</source>
        <translation>第一个表</translation>
    </message>
    <message>
        <source>input axis</source>
        <translation>输入轴</translation>
    </message>
    <message>
        <source>output axis</source>
        <translation>输出轴</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>测量系统</translation>
    </message>
    <message>
        <source>persistent</source>
        <translation>持久</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>公制</translation>
    </message>
    <message>
        <source>increments</source>
        <translation>增量</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>回转</translation>
    </message>
    <message>
        <source>rotary axes</source>
        <translation>回转轴</translation>
    </message>
    <message>
        <source>primary unit</source>
        <translation>PRIMARY 的单位</translation>
    </message>
    <message>
        <source>units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>primary</source>
        <translation>primary</translation>
    </message>
    <message>
        <source>column axis</source>
        <translation>列轴</translation>
    </message>
    <message>
        <source>row axis</source>
        <translation>行轴</translation>
    </message>
    <message>
        <source>output axis 1</source>
        <translation>输出轴 1</translation>
    </message>
    <message>
        <source>output axis 2</source>
        <translation>输出轴 2</translation>
    </message>
    <message>
        <source>output axis 3</source>
        <translation>输出轴 3</translation>
    </message>
    <message>
        <source>source counts per unit</source>
        <translation>源的每单位计数</translation>
    </message>
    <message>
        <source>target counts per unit</source>
        <translation>目标的每单位计数</translation>
    </message>
    <message>
        <source>column counts per unit</source>
        <translation>列的每单位计数</translation>
    </message>
    <message>
        <source>source motor</source>
        <translation>源电机</translation>
    </message>
    <message>
        <source>target motor</source>
        <translation>目标电机</translation>
    </message>
    <message>
        <source>row motor</source>
        <translation>行电机</translation>
    </message>
    <message>
        <source>column motor</source>
        <translation>列电机</translation>
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
        <translation>实际位置</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>source axis 1</source>
        <translation>源轴 1</translation>
    </message>
    <message>
        <source>source axis 2</source>
        <translation>源轴 2</translation>
    </message>
    <message>
        <source>zone</source>
        <translation>区</translation>
    </message>
    <message>
        <source>declare</source>
        <translation>声明</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形式</translation>
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
        <translation>任意间距</translation>
    </message>
    <message>
        <source>reference number</source>
        <translation>参考点编号</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>detection unit</source>
        <translation>检测单位</translation>
    </message>
    <message>
        <source>magnification</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>reference position</source>
        <translation>参考位置</translation>
    </message>
    <message>
        <source>first number</source>
        <translation>首个编号</translation>
    </message>
    <message>
        <source>last number</source>
        <translation>末个编号</translation>
    </message>
    <message>
        <source>first record</source>
        <translation>首行</translation>
    </message>
    <message>
        <source>largest step</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>secondary unit</source>
        <translation>SECONDARY 的单位</translation>
    </message>
    <message>
        <source>target axis</source>
        <translation>控制器的目标轴</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>planning</source>
        <translation>制定计划</translation>
    </message>
    <message>
        <source>backing up the old state</source>
        <translation>备份旧状态</translation>
    </message>
    <message>
        <source>checking for changes since the plan</source>
        <translation>检查制定计划后的变化</translation>
    </message>
    <message>
        <source>detaching the table from the axis</source>
        <translation>将表与轴分离</translation>
    </message>
    <message>
        <source>uploading the table</source>
        <translation>上传表</translation>
    </message>
    <message>
        <source>verifying the table</source>
        <translation>校验表</translation>
    </message>
    <message>
        <source>storing the table in flash</source>
        <translation>将表存入闪存</translation>
    </message>
    <message>
        <source>switching the axis over</source>
        <translation>切换轴</translation>
    </message>
    <message>
        <source>saving the parameters</source>
        <translation>保存参数</translation>
    </message>
    <message>
        <source>reading back</source>
        <translation>回读</translation>
    </message>
    <message>
        <source>rolling back</source>
        <translation>回滚</translation>
    </message>
    <message>
        <source>reading the table</source>
        <translation>读取表</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>删除表</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Axis %1</source>
        <translation>轴 %1</translation>
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
        <translation>[*]轴补偿向导</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionPanel</name>
    <message>
        <source>&amp;Write Compensation</source>
        <translation>写入补偿(&amp;W)</translation>
    </message>
    <message>
        <source>Re&amp;vert All</source>
        <translation>全部恢复原值(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Activate</source>
        <translation>启用(&amp;A)</translation>
    </message>
    <message>
        <source>More actions</source>
        <translation>更多操作</translation>
    </message>
    <message>
        <source>D&amp;eactivate</source>
        <translation>停用(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Evaluate (Adds Nothing)</source>
        <translation>试算（不叠加）(&amp;E)</translation>
    </message>
    <message>
        <source>Restore &amp;Previous Table…</source>
        <translation>还原上一个表(&amp;P)…</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Writes table and settings to the drive and verifies them (Ctrl+Return)</source>
        <translation>将表和设置写入驱动器并校验 (Ctrl+Enter)</translation>
    </message>
    <message>
        <source>Resets all fields to the drive&apos;s values (Ctrl+Shift+R)</source>
        <translation>将所有字段恢复为驱动器的值 (Ctrl+Shift+R)</translation>
    </message>
    <message>
        <source>Switches the compensation on, then compares the drive&apos;s output with the table</source>
        <translation>开启补偿，然后将驱动器的输出与表比较</translation>
    </message>
    <message>
        <source>Switches the compensation off</source>
        <translation>关闭补偿</translation>
    </message>
    <message>
        <source>The drive looks up the table and shows the indices, but adds nothing</source>
        <translation>驱动器查表并显示索引，但不叠加任何值</translation>
    </message>
    <message>
        <source>Writes back the table and settings from before the last write</source>
        <translation>写回上次写入之前的表和设置</translation>
    </message>
    <message>
        <source>Continue in the preview on the right</source>
        <translation>在右侧预览中继续</translation>
    </message>
    <message>
        <source>&amp;Delete Table…</source>
        <translation>删除表(&amp;D)…</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive and frees its slot</source>
        <translation>从驱动器删除该轴的表，并释放其表槽</translation>
    </message>
    <message>
        <source>Evaluate, restore a backup, or delete the table</source>
        <translation>试算、还原备份或删除表</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>还原备份(&amp;B)…</translation>
    </message>
    <message>
        <source>Shows the backups of this drive and restores the one you choose</source>
        <translation>显示此驱动器的备份，并还原所选的备份</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ActionRules</name>
    <message>
        <source>No drive is connected: add a connection first.</source>
        <translation>没有连接驱动器：请先添加连接。</translation>
    </message>
    <message>
        <source>Reading the axes of the drives.</source>
        <translation>正在读取各驱动器的轴。</translation>
    </message>
    <message>
        <source>Choose an axis first.</source>
        <translation>请先选择轴。</translation>
    </message>
    <message>
        <source>The drive is not connected.</source>
        <translation>驱动器未连接。</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>此轴没有补偿寄存器。</translation>
    </message>
    <message>
        <source>Please wait: %1.</source>
        <translation>请稍候：%1。</translation>
    </message>
    <message>
        <source>The axis is being read.</source>
        <translation>正在读取该轴。</translation>
    </message>
    <message>
        <source>The compensation is active: deactivate it first.</source>
        <translation>补偿已启用：请先停用。</translation>
    </message>
    <message>
        <source>No table is chosen: open compensation data.</source>
        <translation>没有选择表：请打开补偿数据。</translation>
    </message>
    <message>
        <source>The table has 1 dimension, but %1D is chosen.</source>
        <translation>该表为 1 维，但选择的是 %1D。</translation>
    </message>
    <message>
        <source>The table has %1 dimensions, but %2D is chosen.</source>
        <translation>该表为 %1 维，但选择的是 %2D。</translation>
    </message>
    <message>
        <source>A source is being checked.</source>
        <translation>正在检查一个源。</translation>
    </message>
    <message>
        <source>Dim%1 Source is missing.</source>
        <translation>缺少 Dim%1 源。</translation>
    </message>
    <message>
        <source>Dim%1 Source is the same as another source.</source>
        <translation>Dim%1 源与另一个源相同。</translation>
    </message>
    <message>
        <source>The table needs %1 bytes, but the largest slot has %2.</source>
        <translation>该表需要 %1 字节，而最大的表槽为 %2 字节。</translation>
    </message>
    <message>
        <source>To spare the flash, wait %1 or write volatile.</source>
        <translation>为保护闪存，请等待 %1，或以易失方式写入。</translation>
    </message>
    <message>
        <source>Nothing has changed.</source>
        <translation>没有任何更改。</translation>
    </message>
    <message>
        <source>The file is being read.</source>
        <translation>正在读取文件。</translation>
    </message>
    <message>
        <source>The parameters still have to be saved.</source>
        <translation>参数尚待保存。</translation>
    </message>
    <message>
        <source>The axis has no table on the drive: write one first.</source>
        <translation>该轴在驱动器上没有表：请先写入。</translation>
    </message>
    <message>
        <source>An earlier write left the axis in neither the old nor the new state: write again or restore the previous state.</source>
        <translation>先前的写入使该轴既不在旧状态也不在新状态：请重新写入，或还原先前的状态。</translation>
    </message>
    <message>
        <source>The compensation is already active.</source>
        <translation>补偿已处于启用状态。</translation>
    </message>
    <message>
        <source>The axis must be homed first.</source>
        <translation>轴必须先回原点。</translation>
    </message>
    <message>
        <source>The compensation is already being evaluated.</source>
        <translation>补偿已处于试算状态。</translation>
    </message>
    <message>
        <source>The compensation is not active.</source>
        <translation>补偿未启用。</translation>
    </message>
    <message>
        <source>This axis has no backup yet; every write makes one.</source>
        <translation>此轴尚无备份；每次写入都会生成备份。</translation>
    </message>
    <message>
        <source>Nothing is running.</source>
        <translation>没有正在进行的操作。</translation>
    </message>
    <message>
        <source>It is already being stopped.</source>
        <translation>正在停止。</translation>
    </message>
    <message>
        <source>Finishes an earlier write: saves the parameters of the drive.</source>
        <translation>完成先前的写入：保存驱动器的参数。</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash; uses %1 of the %2 flash operations available now.</source>
        <translation>写入驱动器并存入闪存；使用目前可用 %2 次闪存操作中的 %1 次。</translation>
    </message>
    <message>
        <source>Writes to the drive and stores in flash.</source>
        <translation>写入驱动器并存入闪存。</translation>
    </message>
    <message>
        <source>Writes to the drive and saves its parameters; the table in flash stays.</source>
        <translation>写入驱动器并保存其参数；闪存中的表保持不变。</translation>
    </message>
    <message>
        <source>Writes to the drive; a reboot of the drive restores the stored state.</source>
        <translation>写入驱动器；驱动器重启后恢复已存储的状态。</translation>
    </message>
    <message>
        <source>Adds the table to the encoder position and proves that the drive&apos;s output matches the table.</source>
        <translation>将表叠加到编码器位置，并验证驱动器的输出与表一致。</translation>
    </message>
    <message>
        <source>The drive looks up the table without adding anything.</source>
        <translation>驱动器查表，但不叠加任何值。</translation>
    </message>
    <message>
        <source>Switches the compensation off; table and settings stay on the drive.</source>
        <translation>关闭补偿；表和设置保留在驱动器上。</translation>
    </message>
    <message>
        <source>Resets the fields to the drive&apos;s values.</source>
        <translation>将各字段恢复为驱动器的值。</translation>
    </message>
    <message>
        <source>Writes back the previous table and sources.</source>
        <translation>写回先前的表和源。</translation>
    </message>
    <message>
        <source>Searches for drives and axes again and reads the axis.</source>
        <translation>重新搜索驱动器和轴，并读取该轴。</translation>
    </message>
    <message>
        <source>Opens a file of compensation data, .csv or .TAMtbl.</source>
        <translation>打开补偿数据文件，.csv 或 .TAMtbl。</translation>
    </message>
    <message>
        <source>Stops reading the file.</source>
        <translation>停止读取文件。</translation>
    </message>
    <message>
        <source>Stops the write and rolls back.</source>
        <translation>停止写入并回滚。</translation>
    </message>
    <message>
        <source>Stops what is running.</source>
        <translation>停止正在进行的操作。</translation>
    </message>
    <message>
        <source>%1 ...</source>
        <translation>%1...</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: its parameters may not be saved. Write to finish it.</source>
        <translation>先前的写入被中断：其参数可能未保存。再次写入即可完成。</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>补偿已启用。</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>补偿处于试算状态：驱动器不叠加任何值。</translation>
    </message>
    <message>
        <source>This axis has no unfinished write.</source>
        <translation>此轴没有未完成的写入。</translation>
    </message>
    <message>
        <source>Completes the interrupted write.</source>
        <translation>完成中断的写入。</translation>
    </message>
    <message>
        <source>Restores the state before the interrupted write.</source>
        <translation>恢复到中断的写入之前的状态。</translation>
    </message>
    <message>
        <source>Open a file with several columns of values first.</source>
        <translation>请先打开含多列值的文件。</translation>
    </message>
    <message>
        <source>The drive has no second axis with compensation registers.</source>
        <translation>驱动器没有第二个带补偿寄存器的轴。</translation>
    </message>
    <message>
        <source>Writes several columns of the open file, each to its own axis.</source>
        <translation>将已打开文件的多列各写入其轴。</translation>
    </message>
    <message>
        <source>planning</source>
        <translation>制定计划</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>writing several axes</source>
        <translation>多轴写入</translation>
    </message>
    <message>
        <source>activating</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>evaluating</source>
        <translation>试算</translation>
    </message>
    <message>
        <source>deactivating</source>
        <translation>停用</translation>
    </message>
    <message>
        <source>finishing the write</source>
        <translation>完成写入</translation>
    </message>
    <message>
        <source>undoing the write</source>
        <translation>撤销写入</translation>
    </message>
    <message>
        <source>restoring</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>The record of this drive&apos;s flash operations was damaged, so all of them count as used up. Write volatile, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>此驱动器的闪存操作记录已损坏，因此视为全部用完。请以易失方式写入，或运行“axiscomp status --reset-flash-count”。</translation>
    </message>
    <message>
        <source>The axis has no table on the drive.</source>
        <translation>该轴在驱动器上没有表。</translation>
    </message>
    <message>
        <source>Deletes the axis&apos;s table from the drive; a backup is kept.</source>
        <translation>从驱动器删除该轴的表；保留备份。</translation>
    </message>
    <message>
        <source>deleting the table</source>
        <translation>删除表</translation>
    </message>
    <message>
        <source>An earlier write was interrupted: finish or undo it first.</source>
        <translation>先前的写入被中断：请先完成或撤销。</translation>
    </message>
    <message>
        <source>Writes the table and source parameters of a TAM configuration to the drive.</source>
        <translation>将 TAM 配置中的表参数和源参数写入驱动器。</translation>
    </message>
    <message>
        <source>Puts the drive&apos;s table and source parameters into a TAM configuration.</source>
        <translation>将驱动器的表参数和源参数放入 TAM 配置。</translation>
    </message>
    <message>
        <source>importing parameters</source>
        <translation>导入参数</translation>
    </message>
    <message>
        <source>Writes back a backup that you choose.</source>
        <translation>写回所选的备份。</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too, and the record of this drive&apos;s flash operations was damaged, so all of them count as used up. Keep the table persistent, or run &quot;axiscomp status --reset-flash-count&quot;.</source>
        <translation>从闪存移除表也是一次闪存操作，而此驱动器的闪存操作记录已损坏，因此视为全部用完。请让该表保持持久，或运行“axiscomp status --reset-flash-count”。</translation>
    </message>
    <message>
        <source>Removing the table from flash is a flash operation too: wait %1, or keep the table persistent.</source>
        <translation>从闪存移除表也是一次闪存操作：请等待 %1，或让该表保持持久。</translation>
    </message>
    <message>
        <source>Removes the table from flash, which uses %1 of the %2 flash operations available now.</source>
        <translation>从闪存移除该表，使用目前可用 %2 次闪存操作中的 %1 次。</translation>
    </message>
    <message>
        <source>Writes to the drive and removes the table from flash.</source>
        <translation>写入驱动器，并从闪存移除该表。</translation>
    </message>
    <message>
        <source>Saves the tables and sources of all axes of the drive to a file.</source>
        <translation>将驱动器所有轴的表和源保存到文件。</translation>
    </message>
    <message>
        <source>Writes a backup of the whole drive back to it, axis by axis.</source>
        <translation>将整台驱动器的备份逐轴写回。</translation>
    </message>
    <message>
        <source>backing up the drive</source>
        <translation>备份驱动器</translation>
    </message>
    <message>
        <source>restoring the drive</source>
        <translation>还原驱动器</translation>
    </message>
    <message>
        <source>What an earlier write left is not known: write again or restore another backup.</source>
        <translation>先前的写入留下了什么状态不得而知：请重新写入，或还原另一个备份。</translation>
    </message>
    <message>
        <source>An earlier write was interrupted, and the backup of the state before it cannot be read: write again or restore another backup first.</source>
        <translation>先前的写入被中断，且写入前状态的备份无法读取：请先重新写入，或还原另一个备份。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ApplyMachineDialog</name>
    <message>
        <source>Apply Machine File</source>
        <translation>应用机床文件</translation>
    </message>
    <message>
        <source>What %1 says is written to all drives that differ from it, or to none. Each axis is backed up first, verified, and put back when its write fails.</source>
        <translation>%1 的内容将写入所有与其不同的驱动器，或者一台也不写。每个轴先备份，写入后校验，写入失败则恢复。</translation>
    </message>
    <message>
        <source>Also &amp;switch compensations on and off where the file says so</source>
        <translation>同时按文件开启和关闭补偿(&amp;S)</translation>
    </message>
    <message>
        <source>Leave &amp;out drives that do not answer</source>
        <translation>略过没有应答的驱动器(&amp;O)</translation>
    </message>
    <message>
        <source>Otherwise nothing is written while one does not answer</source>
        <translation>否则只要有一台没有应答，就不写入任何内容</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>驱动器上</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>机床文件中</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>将写入的内容</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>应用(&amp;A)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field and value</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and warning</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>此驱动器已不在连接之中。</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>It holds</source>
        <translation>现有内容</translation>
    </message>
    <message>
        <source>What has become of each axis</source>
        <translation>各轴的结果</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and problem</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>不使用闪存操作。</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>闪存操作合计：%1。</translation>
    </message>
    <message>
        <source>Stopping: each drive ends where it is safe …</source>
        <translation>正在停止：各驱动器在安全处结束…</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Write these to the drives now</source>
        <translation>现在将这些内容写入驱动器</translation>
    </message>
    <message>
        <source>Stops the writes; those under way are rolled back (Esc)</source>
        <translation>停止写入；正在进行的将回滚 (Esc)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and proof</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Tries to prove each axis that it switches on, and names those of which nothing is proved; without it the file&apos;s “active” is only compared</source>
        <translation>尝试验证由此开启的每个轴，并列出未能验证的轴；不选时，文件中的“active”只作比较</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisList</name>
    <message>
        <source>The drive %1 is not connected.</source>
        <translation>驱动器 %1 未连接。</translation>
    </message>
    <message>
        <source>This axis has no compensation registers.</source>
        <translation>此轴没有补偿寄存器。</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source> (no compensation)</source>
        <translation> （无补偿）</translation>
    </message>
    <message>
        <source> (demo)</source>
        <translation> （演示）</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::AxisState</name>
    <message>
        <source>Compensation: %1.</source>
        <translation>补偿：%1。</translation>
    </message>
    <message>
        <source>Homing: %1.</source>
        <translation>回原点：%1。</translation>
    </message>
    <message>
        <source>The compensation is in error: %1.</source>
        <translation>补偿出现错误：%1。</translation>
    </message>
    <message>
        <source>The drive is in error: %1.</source>
        <translation>驱动器出现错误：%1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::BackupDialog</name>
    <message>
        <source>damaged</source>
        <comment>backup</comment>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>last write</source>
        <comment>what was done after the backup</comment>
        <translation>上次写入</translation>
    </message>
    <message>
        <source>new table</source>
        <comment>what was done after the backup</comment>
        <translation>新表</translation>
    </message>
    <message>
        <source>table deleted</source>
        <comment>what was done after the backup</comment>
        <translation>删除表</translation>
    </message>
    <message>
        <source>settings changed</source>
        <comment>what was done after the backup</comment>
        <translation>更改设置</translation>
    </message>
    <message>
        <source>undone, or nothing changed</source>
        <comment>what was done after the backup</comment>
        <translation>已撤销，或没有改变</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>Restore Backup</source>
        <translation>还原备份</translation>
    </message>
    <message>
        <source>Before each write this computer keeps what the axis had. Choose what %1 shall have again; the preview shows what that changes before anything is written.</source>
        <translation>每次写入前，本计算机都会保存该轴原有的内容。请选择 %1 要恢复的内容；写入任何内容之前，预览会显示由此产生的变化。</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>其后的操作</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>备份，最新的在前</translation>
    </message>
    <message>
        <source>Restore the backup of an&amp;other drive to this one</source>
        <translation>将另一台驱动器的备份还原到此驱动器(&amp;O)</translation>
    </message>
    <message>
        <source>Open Backup &amp;File…</source>
        <translation>打开备份文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Choose from a file that is kept elsewhere, such as one of a drive that was replaced</source>
        <translation>从存放在别处的文件中选择，例如已更换的驱动器的备份</translation>
    </message>
    <message>
        <source>&amp;Restore…</source>
        <translation>还原(&amp;R)…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open Backup File</source>
        <translation>打开备份文件</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>备份 (*.json)</translation>
    </message>
    <message>
        <source>%1, drive %2</source>
        <comment>axis and serial number</comment>
        <translation>%1，驱动器 %2</translation>
    </message>
    <message>
        <source>This backup is damaged: %1</source>
        <translation>此备份已损坏：%1</translation>
    </message>
    <message>
        <source>This backup is of the drive with the serial number %1; this one is %2.</source>
        <translation>此备份属于序列号为 %1 的驱动器；当前驱动器为 %2。</translation>
    </message>
    <message>
        <source>Table of the backup</source>
        <translation>备份的表</translation>
    </message>
    <message>
        <source>There is no backup of this drive on this computer.</source>
        <translation>本计算机上没有此驱动器的备份。</translation>
    </message>
    <message>
        <source>The backups are being read.</source>
        <translation>正在读取备份。</translation>
    </message>
    <message>
        <source>A damaged backup cannot be restored.</source>
        <translation>已损坏的备份无法还原。</translation>
    </message>
    <message>
        <source>Confirm first that the backup of another drive is meant.</source>
        <translation>请先确认所指的是另一台驱动器的备份。</translation>
    </message>
    <message>
        <source>Show what restoring this backup would change</source>
        <translation>显示还原此备份将产生的变化</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CaptureDialog</name>
    <message>
        <source>Capture Values</source>
        <translation>采集测得值</translation>
    </message>
    <message>
        <source>a register of the drive</source>
        <translation>驱动器的寄存器</translation>
    </message>
    <message>
        <source>an instrument on a serial port</source>
        <translation>串口上的仪器</translation>
    </message>
    <message>
        <source>typed by hand</source>
        <translation>手动输入</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>开始(&amp;B)</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>取消(&amp;L)</translation>
    </message>
    <message>
        <source>Take nothing and go back (Esc)</source>
        <translation>不采集并返回 (Esc)</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>The current one; something else moves it</source>
        <translation>当前轴；由其他设备移动</translation>
    </message>
    <message>
        <source>Pla&amp;n</source>
        <translation>测量计划(&amp;N)</translation>
    </message>
    <message>
        <source>As New Program saves it</source>
        <translation>由“新建程序”保存</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>基准(&amp;R)</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>基准的来源</translation>
    </message>
    <message>
        <source>Re&amp;gister</source>
        <translation>寄存器(&amp;G)</translation>
    </message>
    <message>
        <source>Which says where the axis really is: chosen from the list, or a path, URI or address</source>
        <translation>给出轴的真实位置：从列表中选择，或输入路径、URI 或地址</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>Of the instrument, with its speed</source>
        <translation>仪器的端口及其波特率</translation>
    </message>
    <message>
        <source>Re&amp;quest</source>
        <translation>请求(&amp;Q)</translation>
    </message>
    <message>
        <source>Sent before each reading, with \r and \n for line ends; empty: the instrument sends by itself</source>
        <translation>每次读数前发送，行结束符写作 \r 和 \n；为空则由仪器自行发送</translation>
    </message>
    <message>
        <source>Pa&amp;ttern</source>
        <translation>匹配模式(&amp;T)</translation>
    </message>
    <message>
        <source>Regular expression for the number in a line; empty: the first number of the line</source>
        <translation>用于匹配一行中数字的正则表达式；为空则取该行的第一个数字</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>单位(&amp;U)</translation>
    </message>
    <message>
        <source>Of the numbers of the instrument</source>
        <translation>仪器所给数字的单位</translation>
    </message>
    <message>
        <source>&amp;Zero at</source>
        <translation>零点位于(&amp;Z)</translation>
    </message>
    <message>
        <source>Position of the axis where the instrument says 0</source>
        <translation>仪器示值为 0 时的轴位置</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>静止窗口(&amp;W)</translation>
    </message>
    <message>
        <source>The axis stands while its encoder stays within this, and readings may differ by as much</source>
        <translation>编码器保持在此范围内即视为轴静止，各次读数之差也不得超过此值</translation>
    </message>
    <message>
        <source>&amp;Dwell</source>
        <translation>停留时间(&amp;D)</translation>
    </message>
    <message>
        <source>So long the axis must have stood before its value is taken</source>
        <translation>取值前轴必须静止的时间</translation>
    </message>
    <message>
        <source>&amp;Average of</source>
        <translation>平均次数(&amp;A)</translation>
    </message>
    <message>
        <source>Readings that make a value</source>
        <translation>构成一个值的读数次数</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>值(&amp;V)</translation>
    </message>
    <message>
        <source>File of the values; one that is there goes on where it ends</source>
        <translation>值的文件；已有的文件从其结尾处继续</translation>
    </message>
    <message>
        <source>The instrument counts the &amp;other way</source>
        <translation>仪器的计数方向相反(&amp;O)</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>用于轴正向运动时计数减小的仪器</translation>
    </message>
    <message>
        <source>Choose the plan</source>
        <translation>选择测量计划</translation>
    </message>
    <message>
        <source>Choose the file of the values</source>
        <translation>选择值的文件</translation>
    </message>
    <message>
        <source> readings</source>
        <translation> 次读数</translation>
    </message>
    <message>
        <source>Choose Plan</source>
        <translation>选择测量计划</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>测量计划 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>File of the Values</source>
        <translation>值的文件</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>逐趟测量 (*.csv)</translation>
    </message>
    <message>
        <source>that of the axis</source>
        <translation>与轴相同</translation>
    </message>
    <message>
        <source>as the instrument says</source>
        <translation>由仪器给出</translation>
    </message>
    <message>
        <source>that of the plan</source>
        <translation>与测量计划相同</translation>
    </message>
    <message>
        <source>The drive does not answer.</source>
        <translation>驱动器没有应答。</translation>
    </message>
    <message>
        <source>Wait until the drive is free.</source>
        <translation>请等到驱动器空闲。</translation>
    </message>
    <message>
        <source>The plan is being read …</source>
        <translation>正在读取测量计划…</translation>
    </message>
    <message>
        <source>Choose a plan; New Program makes one.</source>
        <translation>请选择测量计划；可用“新建程序”生成。</translation>
    </message>
    <message>
        <source>Choose the register of the reference.</source>
        <translation>请选择基准的寄存器。</translation>
    </message>
    <message>
        <source>Name the port of the instrument, such as serial:/dev/ttyUSB1?baud=9600.</source>
        <translation>请给出仪器的端口，例如 serial:/dev/ttyUSB1?baud=9600。</translation>
    </message>
    <message>
        <source>Choose the file of the values.</source>
        <translation>请选择值的文件。</translation>
    </message>
    <message>
        <source>the plan just made (%1)</source>
        <translation>刚制定的测量计划 (%1)</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>正在读取驱动器…</translation>
    </message>
    <message>
        <source>Values are taken while the control of the machine, or a person, moves the axis. This program never moves it.</source>
        <translation>在机床数控系统或人员移动轴的同时采集测得值。本程序从不移动轴。</translation>
    </message>
    <message>
        <source>Read axis and instrument, and take values</source>
        <translation>读取轴和仪器，并采集测得值</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CapturePanel</name>
    <message>
        <source>Encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>基准</translation>
    </message>
    <message>
        <source>Reference - axis</source>
        <translation>基准 - 轴</translation>
    </message>
    <message>
        <source>The reference minus where the axis is: its encoder and what the drive adds</source>
        <translation>基准减去轴的位置，即其编码器加上驱动器叠加的值</translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation>测量计划的各步</translation>
    </message>
    <message>
        <source>Ta&amp;ke</source>
        <translation>取值(&amp;K)</translation>
    </message>
    <message>
        <source>Undo Las&amp;t</source>
        <translation>撤销上一个(&amp;T)</translation>
    </message>
    <message>
        <source>Stop Capturin&amp;g</source>
        <translation>停止采集(&amp;G)</translation>
    </message>
    <message>
        <source>%1: values to %2</source>
        <translation>%1：值存入 %2</translation>
    </message>
    <message>
        <source>T&amp;he instrument says [%1]</source>
        <translation>仪器读数 [%1](&amp;H)</translation>
    </message>
    <message>
        <source>What the instrument says, in %1</source>
        <translation>仪器读数，单位 %1</translation>
    </message>
    <message>
        <source>Nothing is being taken</source>
        <translation>未在采集</translation>
    </message>
    <message>
        <source>The drive does not answer</source>
        <translation>驱动器没有应答</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>继续(&amp;E)</translation>
    </message>
    <message>
        <source>Paus&amp;e</source>
        <translation>暂停(&amp;E)</translation>
    </message>
    <message>
        <source>Take what was typed for the step that is due (Enter or space bar)</source>
        <translation>采用为待测步输入的读数（Enter 键或空格键）</translation>
    </message>
    <message>
        <source>A position is asked for as soon as the axis stands at the target that is due</source>
        <translation>轴停在待测的目标位置后，即可输入位置</translation>
    </message>
    <message>
        <source>No value has been taken yet</source>
        <translation>尚未取值</translation>
    </message>
    <message>
        <source>Take the last value off the file; its step is due again</source>
        <translation>从文件中删去最后一个值；其所在的步重新变为待测</translation>
    </message>
    <message>
        <source>Go on; the axis has to come to its target once more</source>
        <translation>继续；轴必须再次移到其目标位置</translation>
    </message>
    <message>
        <source>Take nothing until Resume, such as while somebody works at the machine</source>
        <translation>在“继续”之前不取值，例如有人在机床旁作业时</translation>
    </message>
    <message>
        <source>End here; what was taken stays in the file, and Capture goes on behind it with the same plan</source>
        <translation>到此结束；已取的值保留在文件中，“采集”可用同一测量计划接着继续</translation>
    </message>
    <message>
        <source>The drive does not say the unit of the axis: it is taken to be that of the plan.</source>
        <translation>驱动器没有说明该轴的单位：按测量计划的单位处理。</translation>
    </message>
    <message>
        <source>The clock of this computer is behind the last value of the file: times go on from there.</source>
        <translation>本计算机的时钟早于文件中最后一个值：时间从该值继续。</translation>
    </message>
    <message>
        <source>The reference is a Single: at %1 its numbers are %2 apart.</source>
        <translation>基准为 Single：在 %1 处其相邻数字相差 %2。</translation>
    </message>
    <message>
        <source>The instrument is far from the axis, as if it said 0 at %1: if that is right, begin a new file with this as the zero.</source>
        <translation>仪器与轴相差很大，如同在 %1 处示值为 0：如果无误，请以此为零点另起一个新文件。</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, upwards from %3.</source>
        <translation>待测第 %1 步：%2，从 %3 正向趋近。</translation>
    </message>
    <message>
        <source>Step %1 is due: %2, downwards from %3.</source>
        <translation>待测第 %1 步：%2，从 %3 负向趋近。</translation>
    </message>
    <message>
        <source>The axis stands at step %1: %2 of %3 readings.</source>
        <translation>轴停在第 %1 步：第 %2 次读数，共 %3 次。</translation>
    </message>
    <message>
        <source>The axis stands; it is waited until it has come to rest.</source>
        <translation>轴已停住；正在等待其完全静止。</translation>
    </message>
    <message>
        <source>The axis stands at step %1: read the instrument, and type what it says.</source>
        <translation>轴停在第 %1 步：请读取仪器，并输入读数。</translation>
    </message>
    <message>
        <source>Taken. %1</source>
        <translation>已取值。%1</translation>
    </message>
    <message>
        <source>The axis moves. %1</source>
        <translation>轴正在移动。%1</translation>
    </message>
    <message>
        <source>%1 of %2 values are in %3.</source>
        <translation>%2 个值中已有 %1 个存入 %3。</translation>
    </message>
    <message>
        <source>Every step has its value: %1 values are in %2.</source>
        <translation>每一步都有值：%1 个值在 %2 中。</translation>
    </message>
    <message>
        <source>Stopped. %1 Capture goes on behind them with the same plan and file.</source>
        <translation>已停止。%1“采集”可用同一测量计划和文件接着继续。</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>正在读取驱动器…</translation>
    </message>
    <message>
        <source>Nothing is taken: %1 It goes on when the drive answers again.</source>
        <translation>未取值：%1驱动器重新应答后继续。</translation>
    </message>
    <message>
        <source>Nothing is taken while the window does something else on this drive.</source>
        <translation>窗口在此驱动器上进行其他操作期间不取值。</translation>
    </message>
    <message>
        <source>Paused: nothing is taken. %1</source>
        <translation>已暂停：不取值。%1</translation>
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
        <translation>正向</translation>
    </message>
    <message>
        <source>down</source>
        <translation>负向</translation>
    </message>
    <message>
        <source>Deviations that were taken</source>
        <translation>已采集的偏差</translation>
    </message>
    <message>
        <source>The same values are in the list of steps</source>
        <translation>步列表中有同样的值</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateButton</name>
    <message>
        <source>Forget Cert&amp;ificate</source>
        <translation>忘记证书(&amp;I)</translation>
    </message>
    <message>
        <source>Cert&amp;ificate …</source>
        <translation>证书(&amp;I)…</translation>
    </message>
    <message>
        <source>Stop trusting the certificate of the selected drive</source>
        <translation>不再信任所选驱动器的证书</translation>
    </message>
    <message>
        <source>Show the certificate of the selected drive and decide whether to trust it</source>
        <translation>显示所选驱动器的证书，并决定是否信任</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CertificateDialog</name>
    <message>
        <source>Drive Certificate</source>
        <translation>驱动器证书</translation>
    </message>
    <message>
        <source>The certificate of this drive has CHANGED since it was trusted. Either the drive has a new one, or another device answers at its address.</source>
        <translation>此驱动器的证书在被信任之后已经改变。可能是驱动器换了新证书，也可能是另一台设备在用其地址应答。</translation>
    </message>
    <message>
        <source>No authority known to this computer has signed this certificate, so the identity of the drive cannot be confirmed.</source>
        <translation>本计算机所知的机构均未签署此证书，因此无法确认驱动器的身份。</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>颁发给</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>颁发者</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>有效期</translation>
    </message>
    <message>
        <source>SHA-256 fingerprint</source>
        <translation>SHA-256 指纹</translation>
    </message>
    <message>
        <source>from %1 until %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
    <message>
        <source>Trust it only if the drive itself, or its administrator, shows the same fingerprint. From then on this address is accepted with this certificate only.</source>
        <translation>仅当驱动器本身或其管理员给出相同的指纹时才信任。此后该地址只接受此证书。</translation>
    </message>
    <message>
        <source>Do &amp;Not Trust</source>
        <translation>不信任(&amp;N)</translation>
    </message>
    <message>
        <source>Stay disconnected (Esc)</source>
        <translation>保持断开 (Esc)</translation>
    </message>
    <message>
        <source>&amp;Trust This Certificate</source>
        <translation>信任此证书(&amp;T)</translation>
    </message>
    <message>
        <source>Accept this certificate for this address from now on</source>
        <translation>今后对此地址接受此证书</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ChangePictures</name>
    <message>
        <source>On the drive</source>
        <translation>驱动器上</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新</translation>
    </message>
    <message>
        <source>Difference, new − old</source>
        <translation>差值，新 − 旧</translation>
    </message>
    <message>
        <source>largest %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>%1; shown: the middle slice, %2 %3</source>
        <comment>largest value, dimension, place</comment>
        <translation>%1；所示为中间切片，%2 %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>value at position</comment>
        <translation>%1，在 %2</translation>
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
        <translation>至少选择一个轴。</translation>
    </message>
    <message>
        <source>%1 is selected twice; an axis has only one table.</source>
        <translation>%1 被选择两次；一个轴只有一个表。</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>轴 %1</translation>
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
        <translation>文件的列</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Which column is for which axis</source>
        <translation>各列对应的轴</translation>
    </message>
    <message>
        <source>none</source>
        <comment>axis</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>Axis for %1</source>
        <translation>%1 的轴</translation>
    </message>
    <message>
        <source>The axis for column %1</source>
        <translation>列 %1 的轴</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnPreview</name>
    <message>
        <source>Columns of the file</source>
        <translation>文件的列</translation>
    </message>
    <message>
        <source>by its name</source>
        <translation>按其名称</translation>
    </message>
    <message>
        <source>What column %1 is</source>
        <translation>列 %1 的含义</translation>
    </message>
    <message>
        <source>What this column is. Once one is chosen, only chosen columns are read; until then the names of the columns say it.</source>
        <translation>此列的含义。一旦选择了某一列，就只读取所选的列；在此之前由列名决定。</translation>
    </message>
    <message>
        <source>%1 in column %2</source>
        <translation>列 %2：%1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ColumnProposal</name>
    <message>
        <source>Proposed, as you chose it for the last file with these columns: %1.</source>
        <translation>建议，与上一个具有这些列的文件的选择相同：%1。</translation>
    </message>
    <message>
        <source>Use T&amp;hese</source>
        <translation>采用(&amp;H)</translation>
    </message>
    <message>
        <source>Read the columns of this file in the same way</source>
        <translation>以同样方式读取此文件的列</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ComparisonFiguresModel</name>
    <message>
        <source>no tolerance</source>
        <translation>无公差</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>column and its value</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>figure and its values</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>After</source>
        <translation>补偿后</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>What is left at targets that the table was made without: the figure to believe</source>
        <translation>未用于生成表的目标位置上的残余误差：应以此值为准</translation>
    </message>
    <message>
        <source>Before, all values</source>
        <translation>补偿前，所有值</translation>
    </message>
    <message>
        <source>After, all values</source>
        <translation>补偿后，所有值</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CompensationWizard</name>
    <message>
        <source>Axis Compensation Wizard</source>
        <translation>轴补偿向导</translation>
    </message>
    <message>
        <source>%1 is opened as soon as that is possible. %2</source>
        <translation>%1 将在可能时立即打开。%2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConditionsModel</name>
    <message>
        <source>Condition of ISO 230-2</source>
        <translation>GB/T 17421.2 的条件</translation>
    </message>
    <message>
        <source>Met?</source>
        <translation>满足？</translation>
    </message>
    <message>
        <source>%1 (assumption)</source>
        <translation>%1（假定）</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConnectionsDialog</name>
    <message>
        <source>Use the drives of the list</source>
        <translation>采用列表中的驱动器</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>放弃更改 (Esc)</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>Change the address of the chosen connection</source>
        <translation>更改所选连接的地址</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Remove the chosen connection</source>
        <translation>移除所选的连接</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>测试(&amp;T)</translation>
    </message>
    <message>
        <source>Ask the drive at the selected address to identify itself</source>
        <translation>请所选地址处的驱动器标明其身份</translation>
    </message>
    <message>
        <source>De&amp;mo Drive</source>
        <translation>演示驱动器(&amp;M)</translation>
    </message>
    <message>
        <source>Add the built-in demo drive to try everything without hardware</source>
        <translation>添加内置的演示驱动器，无需硬件即可试用全部功能</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>地址(&amp;A)</translation>
    </message>
    <message>
        <source>%1 (demo)</source>
        <translation>%1（演示）</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>answers; serial number %1, axes: %2</source>
        <translation>有应答；序列号 %1，轴：%2</translation>
    </message>
    <message>
        <source>asking …</source>
        <translation>正在查询…</translation>
    </message>
    <message>
        <source>This address is already in the list.</source>
        <translation>此地址已在列表中。</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>正在查询 %1…</translation>
    </message>
    <message>
        <source>Added, but not answering yet: %1</source>
        <translation>已添加，但尚无应答：%1</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>添加(&amp;D)</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>更改(&amp;G)</translation>
    </message>
    <message>
        <source>Checks the address and adds it to the list</source>
        <translation>检查地址并添加到列表</translation>
    </message>
    <message>
        <source>Not possible while a drive is being written</source>
        <translation>正在写入驱动器时不可用</translation>
    </message>
    <message>
        <source>Drives are reached through their web server, such as http://192.168.1.20, or a serial line, such as serial:/dev/ttyUSB0. A web address may contain a user name and password (http://user:password@host); they are used until the program ends and never stored.</source>
        <translation>驱动器通过其网页服务器（例如 http://192.168.1.20）或串行线路（例如 serial:/dev/ttyUSB0）访问。网页地址可包含用户名和密码（http://用户名:密码@主机）；它们只在程序运行期间使用，不会保存。</translation>
    </message>
    <message>
        <source>&amp;Find …</source>
        <translation>查找(&amp;F)…</translation>
    </message>
    <message>
        <source>Search the serial ports of this computer for drives</source>
        <translation>在本计算机的串口上搜索驱动器</translation>
    </message>
    <message>
        <source>The address of a drive&apos;s web server, or a serial port</source>
        <translation>驱动器网页服务器的地址，或串口</translation>
    </message>
    <message>
        <source>The certificate of %1 is no longer trusted.</source>
        <translation>不再信任 %1 的证书。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ControllerCombo</name>
    <message>
        <source>As applied by %1</source>
        <translation>按 %1 的应用方式</translation>
    </message>
    <message>
        <source>The table as the drive applies it, or converted to another controller&apos;s convention: its sign, and its rules beyond the ends</source>
        <translation>按驱动器应用的方式显示表，或换算为其他控制器的约定：其符号，以及超出两端时的规则</translation>
    </message>
    <message>
        <source>Applied by</source>
        <translation>应用方</translation>
    </message>
    <message>
        <source>As on the drive</source>
        <translation>与驱动器上相同</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionDialog</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Change nothing (Esc)</source>
        <translation>不作任何更改 (Esc)</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>结果(&amp;R)</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>What the conversion does to the numbers, with an example</source>
        <translation>换算对数字的作用，附一个例子</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>正在计算…</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ConversionForm</name>
    <message>
        <source>Choose the format.</source>
        <translation>请选择格式。</translation>
    </message>
    <message>
        <source>Enter a number for the even grid.</source>
        <translation>请输入均匀网格的数字。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number, and no list such as 21; 31.</source>
        <translation>“%1”不是数字，也不是 21; 31 这样的列表。</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
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
        <translation>点之间(&amp;B)</translation>
    </message>
    <message>
        <source>Treat a modulo axis as a &amp;linear one</source>
        <translation>将模数轴按直线轴处理(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Hold the end values beyond the data</source>
        <translation>超出数据时保持端值(&amp;H)</translation>
    </message>
    <message>
        <source>The format that the file is read as</source>
        <translation>读取文件所用的格式</translation>
    </message>
    <message>
        <source>The format of the new file</source>
        <translation>新文件的格式</translation>
    </message>
    <message>
        <source>Whether the file&apos;s values are added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>文件的值加到编码器位置（反馈侧）还是指令位置（指令侧）</translation>
    </message>
    <message>
        <source>Whether the new file&apos;s values are to be added to the encoder position (feedback) or to the commanded position (command)</source>
        <translation>新文件的值应加到编码器位置（反馈侧）还是指令位置（指令侧）</translation>
    </message>
    <message>
        <source>The drive holds one value for both directions of motion; choose which one</source>
        <translation>驱动器对两个运动方向只有一个值；请选择用哪一个</translation>
    </message>
    <message>
        <source>For an axis that stays within one revolution: the table is used as it is</source>
        <translation>用于始终在一转之内的轴：表按原样使用</translation>
    </message>
    <message>
        <source>Brings the table onto evenly spaced positions</source>
        <translation>将表转到等间距的位置上</translation>
    </message>
    <message>
        <source>How the values between the positions of the table are made</source>
        <translation>表的各位置之间的值如何得出</translation>
    </message>
    <message>
        <source>The even grid may end beyond the last position</source>
        <translation>均匀网格可以超出末位置</translation>
    </message>
    <message>
        <source>choose the format</source>
        <translation>选择格式</translation>
    </message>
    <message>
        <source>as the format says</source>
        <translation>按格式规定</translation>
    </message>
    <message>
        <source>as the format says: feedback</source>
        <translation>按格式规定：反馈侧 (feedback)</translation>
    </message>
    <message>
        <source>as the format says: command</source>
        <translation>按格式规定：指令侧 (command)</translation>
    </message>
    <message>
        <source>feedback: added to the encoder position</source>
        <translation>反馈侧 (feedback)：加到编码器位置</translation>
    </message>
    <message>
        <source>command: added to the commanded position</source>
        <translation>指令侧 (command)：加到指令位置</translation>
    </message>
    <message>
        <source>choose one</source>
        <translation>请选择</translation>
    </message>
    <message>
        <source>the mean of both directions</source>
        <translation>两个方向的平均值</translation>
    </message>
    <message>
        <source>the values of the positive direction</source>
        <translation>正方向的值</translation>
    </message>
    <message>
        <source>the values of the negative direction</source>
        <translation>负方向的值</translation>
    </message>
    <message>
        <source>the positions of the table</source>
        <translation>表的位置</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>coarsest within a deviation</source>
        <translation>允许偏差内最粗</translation>
    </message>
    <message>
        <source>linear, as controllers do</source>
        <translation>线性，与控制器相同</translation>
    </message>
    <message>
        <source>smooth (monotone cubic)</source>
        <translation>平滑（单调三次）</translation>
    </message>
    <message>
        <source>&amp;Number of points</source>
        <translation>点数(&amp;N)</translation>
    </message>
    <message>
        <source>At least 2; one number for all sources, or one for each: 21; 31</source>
        <translation>至少 2；所有源共用一个数字，或每个源一个：21; 31</translation>
    </message>
    <message>
        <source>Dista&amp;nce</source>
        <translation>间距(&amp;N)</translation>
    </message>
    <message>
        <source>In the unit of the positions; one number for all sources, or one for each: 5; 10</source>
        <translation>以位置的单位；所有源共用一个数字，或每个源一个：5; 10</translation>
    </message>
    <message>
        <source>Deviatio&amp;n</source>
        <translation>偏差(&amp;N)</translation>
    </message>
    <message>
        <source>In the unit of the values; the coarsest grid within it is used</source>
        <translation>以值的单位；采用不超过此偏差的最粗网格</translation>
    </message>
    <message>
        <source>Target &amp;axis</source>
        <translation>目标轴(&amp;A)</translation>
    </message>
    <message>
        <source>The axis that the values correct: one of the sources, or another axis; the sign is converted accordingly</source>
        <translation>值所修正的轴：源之一，或另一个轴；符号据此换算</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>按文件注明</translation>
    </message>
    <message>
        <source>as the table says</source>
        <translation>按表注明</translation>
    </message>
    <message>
        <source>the first source</source>
        <translation>第一个源</translation>
    </message>
    <message>
        <source>the second source</source>
        <translation>第二个源</translation>
    </message>
    <message>
        <source>the third source</source>
        <translation>第三个源</translation>
    </message>
    <message>
        <source>another axis</source>
        <translation>另一个轴</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tolerance: enter a number above 0, or nothing.</source>
        <translation>“%1”不是公差：请输入大于 0 的数字，或留空。</translation>
    </message>
    <message>
        <source>Missin&amp;g points</source>
        <translation>缺失点(&amp;G)</translation>
    </message>
    <message>
        <source>Snap &amp;tolerance</source>
        <translation>吸附公差(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Even grid</source>
        <translation>均匀网格(&amp;E)</translation>
    </message>
    <message>
        <source>What becomes of points of the grid that have no value</source>
        <translation>如何处理没有值的网格点</translation>
    </message>
    <message>
        <source>Positions that are this close to an even grid are taken for its positions, in their unit; empty: as they stand in the file</source>
        <translation>与均匀网格相差在此值以内的位置视为网格的位置，以位置的单位；为空则采用文件中的位置</translation>
    </message>
    <message>
        <source>none may be missing</source>
        <translation>不允许缺失</translation>
    </message>
    <message>
        <source>filled with the nearest measured value</source>
        <translation>用最近的测得值填补</translation>
    </message>
    <message>
        <source>filled from the plane through all points</source>
        <translation>用通过所有点的平面填补</translation>
    </message>
    <message>
        <source>filled smoothly, with the least bending</source>
        <translation>平滑填补，弯曲最小</translation>
    </message>
    <message>
        <source>left out: the grid is cropped</source>
        <translation>略去：裁剪网格</translation>
    </message>
    <message>
        <source>spline (natural cubic)</source>
        <translation>样条（自然三次）</translation>
    </message>
    <message>
        <source>without noise (smoothing spline)</source>
        <translation>去除噪声（平滑样条）</translation>
    </message>
    <message>
        <source>choose one; feedback is assumed</source>
        <translation>请选择；默认按反馈侧 (feedback)</translation>
    </message>
    <message>
        <source>choose one; command is assumed</source>
        <translation>请选择；默认按指令侧 (command)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::CorrectionsDialog</name>
    <message>
        <source>%1 mm; runs with their air: %2</source>
        <translation>%1 mm；含空气参数的趟次：%2</translation>
    </message>
    <message>
        <source>not corrected for</source>
        <translation>不修正</translation>
    </message>
    <message>
        <source>Enter temperatures and coefficients as numbers; only the position that does not move may be left empty.</source>
        <translation>请以数字输入温度和系数；只有不动点的位置可以留空。</translation>
    </message>
    <message>
        <source>The file does not say whether its values are at 20 °C already. Only values that are not may be corrected.</source>
        <translation>文件没有注明其值是否已是 20 °C 下的值。只有不是的才可修正。</translation>
    </message>
    <message>
        <source>Corrections Before Judging</source>
        <translation>评定前的修正</translation>
    </message>
    <message>
        <source>&amp;Bring the values to 20 °C</source>
        <translation>将值修正到 20 °C(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Temperature of the scale [°C]</source>
        <translation>标尺温度 [°C](&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Expansion of the scale [%1]</source>
        <translation>标尺膨胀系数 [%1](&amp;E)</translation>
    </message>
    <message>
        <source>Temperature of the &amp;reference [°C]</source>
        <translation>基准温度 [°C](&amp;R)</translation>
    </message>
    <message>
        <source>E&amp;xpansion of the reference [%1]</source>
        <translation>基准膨胀系数 [%1](&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Position that does not move [mm]</source>
        <translation>不动点的位置 [mm](&amp;P)</translation>
    </message>
    <message>
        <source>Of the material that the axis is measured by</source>
        <translation>轴所用测量元件（标尺）的温度</translation>
    </message>
    <message>
        <source>Of the same material; steel has about 11.5</source>
        <translation>同一材料的系数；钢约为 11.5</translation>
    </message>
    <message>
        <source>Of the measuring instrument</source>
        <translation>测量仪器的温度</translation>
    </message>
    <message>
        <source>0 for a laser that is compensated for its wavelength</source>
        <translation>对已作波长补偿的激光为 0</translation>
    </message>
    <message>
        <source>Empty: the first target</source>
        <translation>为空：首目标位置</translation>
    </message>
    <message>
        <source>the first target</source>
        <translation>首目标位置</translation>
    </message>
    <message>
        <source>&amp;Steel</source>
        <translation>钢(&amp;S)</translation>
    </message>
    <message>
        <source>Enter the coefficient of steel, 11.5 µm/(m·K)</source>
        <translation>填入钢的系数，11.5 µm/(m·K)</translation>
    </message>
    <message>
        <source>The instrument has &amp;not corrected the values itself</source>
        <translation>仪器自身没有修正这些值(&amp;N)</translation>
    </message>
    <message>
        <source>Needed where the file does not say it</source>
        <translation>文件没有注明时需要</translation>
    </message>
    <message>
        <source>Dead path of the interferometer</source>
        <translation>干涉仪的死程</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>Do not correct for the dead path</source>
        <translation>不作死程修正</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>修正(&amp;C)</translation>
    </message>
    <message>
        <source>Judge the values with these corrections</source>
        <translation>按这些修正评定各值</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>取消(&amp;L)</translation>
    </message>
    <message>
        <source>Leave the corrections as they are (Esc)</source>
        <translation>保持现有修正 (Esc)</translation>
    </message>
    <message>
        <source>A JSON file with its length and the air of each run</source>
        <translation>含死程长度和每一趟空气参数的 JSON 文件</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DataFileField</name>
    <message>
        <source>No file is open</source>
        <translation>没有打开的文件</translation>
    </message>
    <message>
        <source>Open a file of compensation data, or drop it on the window (Ctrl+O)</source>
        <translation>打开补偿数据文件，或将其拖放到窗口 (Ctrl+O)</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>无文件</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>已打开的文件</translation>
    </message>
    <message>
        <source>The name of the open file of compensation data</source>
        <translation>已打开的补偿数据文件的名称</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>正在读取文件</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Opens a file of compensation data</source>
        <translation>打开补偿数据文件</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>停止(&amp;O)</translation>
    </message>
    <message>
        <source>Stop reading the file</source>
        <translation>停止读取文件</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>没有最近的文件</translation>
    </message>
    <message>
        <source>&amp;Read Again</source>
        <translation>重新读取(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Close File</source>
        <translation>关闭文件(&amp;C)</translation>
    </message>
    <message>
        <source>Import &amp;Options…</source>
        <translation>导入选项(&amp;O)…</translation>
    </message>
    <message>
        <source>Format, sign and grid of the open file</source>
        <translation>已打开文件的格式、符号和网格</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationCanvas</name>
    <message>
        <source>smallest and largest value</source>
        <translation>最小值和最大值</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>proposed for exclusion</source>
        <translation>建议排除</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标位置</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DeviationPlot</name>
    <message>
        <source>Deviation over position</source>
        <translation>偏差随位置的变化</translation>
    </message>
    <message>
        <source>A click selects a value; arrow keys go from value to value. The wheel and + and - zoom, dragging moves, Home or a double click shows everything.</source>
        <translation>单击可选择一个值；方向键可逐值移动。滚轮及 + 和 - 缩放，拖动平移，Home 键或双击显示全部。</translation>
    </message>
    <message>
        <source>run %1, %2</source>
        <translation>第 %1 趟，%2</translation>
    </message>
    <message>
        <source>target %1 %2, ↑ %3, ↓ %4 %5, B %6 %5</source>
        <translation>目标位置 %1 %2，↑ %3，↓ %4 %5，B %6 %5</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftDetails</name>
    <message>
        <source>Field</source>
        <translation>字段</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>驱动器上</translation>
    </message>
    <message>
        <source>In the machine file</source>
        <translation>机床文件中</translation>
    </message>
    <message>
        <source>How the axis differs from the machine file</source>
        <translation>该轴与机床文件的差别</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis, and how it stands to the machine file</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftModel</name>
    <message>
        <source>Drift of the runs</source>
        <translation>各趟的漂移</translation>
    </message>
    <message>
        <source>Runs ↑</source>
        <translation>各趟 ↑</translation>
    </message>
    <message>
        <source>Runs ↓</source>
        <translation>各趟 ↓</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>From the first to the last run</source>
        <translation>从第一趟到最后一趟</translation>
    </message>
    <message>
        <source>From run to run</source>
        <translation>逐趟</translation>
    </message>
    <message>
        <source>Per hour</source>
        <translation>每小时</translation>
    </message>
    <message>
        <source>Per kelvin</source>
        <translation>每开尔文</translation>
    </message>
    <message>
        <source>s without the offsets of the runs</source>
        <translation>去除各趟偏移后的 s</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>A without the offsets of the runs</source>
        <translation>去除各趟偏移后的 A</translation>
    </message>
    <message>
        <source>R without the offsets of the runs</source>
        <translation>去除各趟偏移后的 R</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>疑似</translation>
    </message>
    <message>
        <source>not suspected</source>
        <translation>未见</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftPlot</name>
    <message>
        <source>%1, run %2: offset %3</source>
        <translation>%1，第 %2 趟：偏移 %3</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>趟次</translation>
    </message>
    <message>
        <source>Offset of the run</source>
        <translation>该趟的偏移</translation>
    </message>
    <message>
        <source>runs ↑</source>
        <translation>各趟 ↑</translation>
    </message>
    <message>
        <source>runs ↓</source>
        <translation>各趟 ↓</translation>
    </message>
    <message>
        <source>Drift: offsets of the runs</source>
        <translation>漂移：各趟的偏移</translation>
    </message>
    <message>
        <source>How far each run lies beside the mean of its direction. A click or the arrow keys select a run.</source>
        <translation>每一趟偏离其方向平均值的程度。单击或用方向键选择一趟。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriftText</name>
    <message>
        <source>not in the file</source>
        <comment>axis</comment>
        <translation>不在文件中</translation>
    </message>
    <message>
        <source>not among the connections</source>
        <comment>drive</comment>
        <translation>不在连接之中</translation>
    </message>
    <message>
        <source>is being compared …</source>
        <translation>正在比较…</translation>
    </message>
    <message>
        <source>not reachable</source>
        <comment>drive</comment>
        <translation>无法访问</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>无法比较</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>与文件一致</translation>
    </message>
    <message>
        <source>%1 (compared at %2)</source>
        <comment>state and time</comment>
        <translation>%1（比较时间 %2）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>table and grid</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>持久</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>易失</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>未设置</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>开启</translation>
    </message>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Earlier write</source>
        <translation>先前的写入</translation>
    </message>
    <message>
        <source>did not end</source>
        <translation>未结束</translation>
    </message>
    <message>
        <source>is ended by the next write</source>
        <translation>由下次写入结束</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>%1 (serial number %2)</source>
        <comment>address of a drive</comment>
        <translation>%1（序列号 %2）</translation>
    </message>
    <message>
        <source>%1, axis %2</source>
        <comment>drive and axis</comment>
        <translation>%1，轴 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and problem</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <comment>file, line and problem</comment>
        <translation>%1，第 %2 行：%3</translation>
    </message>
    <message>
        <source>This cannot be written now: %1</source>
        <translation>目前无法写入：%1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveBar</name>
    <message>
        <source>%1 (demo)</source>
        <translation>%1（演示）</translation>
    </message>
    <message>
        <source>&amp;Drive</source>
        <translation>驱动器(&amp;D)</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>The drive of the chosen axis, and its address</source>
        <translation>所选轴的驱动器及其地址</translation>
    </message>
    <message>
        <source>The drive of the selected axis; lists all drives under Connections</source>
        <translation>所选轴的驱动器；列出“连接”中的所有驱动器</translation>
    </message>
    <message>
        <source>Co&amp;nnections…</source>
        <translation>连接(&amp;N)…</translation>
    </message>
    <message>
        <source>Add, test or remove drives</source>
        <translation>添加、测试或移除驱动器</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>刷新(&amp;R)</translation>
    </message>
    <message>
        <source>More: language, log, settings</source>
        <translation>更多：语言、日志、设置</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>no drive</source>
        <translation>无驱动器</translation>
    </message>
    <message>
        <source>no drive: add one under Connections</source>
        <translation>无驱动器：请在“连接”中添加</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>连接断开，正在重新连接</translation>
    </message>
    <message>
        <source>Search for axes again and read everything from the drives (F5)</source>
        <translation>重新搜索轴，并从驱动器读取全部内容 (F5)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DriveList</name>
    <message>
        <source>Connected to %1 (%2).</source>
        <translation>已连接到 %1（%2）。</translation>
    </message>
    <message>
        <source>A different drive now answers at %1: %2. Unwritten changes were discarded.</source>
        <translation>%1 处现在由另一台驱动器应答：%2。未写入的更改已放弃。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::DropFrame</name>
    <message>
        <source>Drop to open %1</source>
        <translation>松开即可打开 %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExaggerationCombo</name>
    <message>
        <source>Exaggeration</source>
        <translation>放大倍数</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportConfigurationDialog</name>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>导出到 TAM 配置</translation>
    </message>
    <message>
        <source>Puts the table and source parameters of %1 into %2. Everything else in the file stays as it is; nothing on the drive changes.</source>
        <translation>将 %1 的表参数和源参数放入 %2。文件中的其他内容保持不变；驱动器上不作任何更改。</translation>
    </message>
    <message>
        <source>What the drive has</source>
        <translation>驱动器的内容</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>表槽</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>源</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>另存为(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>不作任何更改并返回 (Esc)</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>The drive is being read …</source>
        <translation>正在读取驱动器…</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>正在比较…</translation>
    </message>
    <message>
        <source>The configuration has all of this already.</source>
        <translation>配置已与此完全一致。</translation>
    </message>
    <message>
        <source>Choose where to save the configuration</source>
        <translation>选择配置的保存位置</translation>
    </message>
    <message>
        <source>In the file, only Table and Dim1Source to Dim3Source of these axes will change.</source>
        <translation>文件中只更改这些轴的 Table 和 Dim1Source 至 Dim3Source。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ExportDialog</name>
    <message>
        <source>Export for Another Controller</source>
        <translation>导出到其他控制器</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file for another controller. Nothing on the drive changes.</source>
        <translation>将表“%1”写入其他控制器的文件。驱动器上不作任何更改。</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>Choose where to save the file</source>
        <translation>选择文件的保存位置</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>保存表</translation>
    </message>
    <message>
        <source>Writes the table &quot;%1&quot; to a file of the drive or of another controller. Nothing on the drive changes.</source>
        <translation>将表“%1”写入驱动器或其他控制器的文件。驱动器上不作任何更改。</translation>
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
        <translation>恢复 %1 的原值</translation>
    </message>
    <message>
        <source>changed, on the drive: %1</source>
        <translation>已更改，驱动器上：%1</translation>
    </message>
    <message>
        <source>on the drive: %1</source>
        <translation>驱动器上：%1</translation>
    </message>
    <message>
        <source>Revert to the drive&apos;s value: %1</source>
        <translation>恢复为驱动器的值：%1</translation>
    </message>
    <message>
        <source>&amp;Revert to the drive&apos;s value</source>
        <translation>恢复为驱动器的值(&amp;R)</translation>
    </message>
    <message>
        <source>as last read</source>
        <translation>上次读取的值</translation>
    </message>
    <message>
        <source>proposed: %1</source>
        <translation>建议：%1</translation>
    </message>
    <message>
        <source>Use</source>
        <comment>what is proposed</comment>
        <translation>采用</translation>
    </message>
    <message>
        <source>Use what is proposed: %1</source>
        <translation>采用建议：%1</translation>
    </message>
    <message>
        <source>Use what is proposed for %1</source>
        <translation>采用对 %1 的建议</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FiguresModel</name>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>Without excluded</source>
        <translation>除去已排除值</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>所有值</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>At target</source>
        <translation>所在目标位置</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>uncertainty not stated</source>
        <translation>未注明不确定度</translation>
    </message>
    <message>
        <source> and </source>
        <comment>two positions</comment>
        <translation> 和 </translation>
    </message>
    <message>
        <source>U largest</source>
        <translation>U 最大值</translation>
    </message>
    <message>
        <source>U mean</source>
        <translation>U 平均值</translation>
    </message>
    <message>
        <source>Ps largest</source>
        <translation>Ps 最大值</translation>
    </message>
    <message>
        <source>Ps mean</source>
        <translation>Ps 平均值</translation>
    </message>
    <message>
        <source>VDI/DGQ 3441 (assumption)</source>
        <translation>VDI/DGQ 3441（假定）</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileActions</name>
    <message>
        <source>Open Compensation Data</source>
        <translation>打开补偿数据</translation>
    </message>
    <message>
        <source>Save Example File</source>
        <translation>保存示例文件</translation>
    </message>
    <message>
        <source>Calibration files (*.csv)</source>
        <translation>校准文件 (*.csv)</translation>
    </message>
    <message>
        <source>Save Log</source>
        <translation>保存日志</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>文本文件 (*.txt)</translation>
    </message>
    <message>
        <source>Export for Another Controller</source>
        <translation>导出到其他控制器</translation>
    </message>
    <message>
        <source>Import TAM Configuration</source>
        <translation>导入 TAM 配置</translation>
    </message>
    <message>
        <source>Export to TAM Configuration</source>
        <translation>导出到 TAM 配置</translation>
    </message>
    <message>
        <source>TAM configurations (*.TAMcfg)</source>
        <translation>TAM 配置 (*.TAMcfg)</translation>
    </message>
    <message>
        <source>Save TAM Configuration</source>
        <translation>保存 TAM 配置</translation>
    </message>
    <message>
        <source>Back Up Whole Drive</source>
        <translation>备份整台驱动器</translation>
    </message>
    <message>
        <source>Backups (*.json)</source>
        <translation>备份 (*.json)</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>还原整台驱动器</translation>
    </message>
    <message>
        <source>Add Measurement</source>
        <translation>添加测量</translation>
    </message>
    <message>
        <source>Save as Runs</source>
        <translation>保存为逐趟测量</translation>
    </message>
    <message>
        <source>Runs (*.csv)</source>
        <translation>逐趟测量 (*.csv)</translation>
    </message>
    <message>
        <source>Dead Path</source>
        <translation>死程</translation>
    </message>
    <message>
        <source>Dead path (*.json)</source>
        <translation>死程 (*.json)</translation>
    </message>
    <message>
        <source>Table That Was Active</source>
        <translation>当时启用的表</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>保存表</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileChoices</name>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>按其内容</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>值(&amp;V)</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>按文件注明</translation>
    </message>
    <message>
        <source>deviations from the target</source>
        <translation>与目标位置的偏差</translation>
    </message>
    <message>
        <source>positions of the reference</source>
        <translation>基准的位置</translation>
    </message>
    <message>
        <source>&amp;Unit of targets</source>
        <translation>目标位置的单位(&amp;U)</translation>
    </message>
    <message>
        <source>Unit &amp;of values</source>
        <translation>值的单位(&amp;O)</translation>
    </message>
    <message>
        <source>Lines &amp;before the header</source>
        <translation>标题行之前的行数(&amp;B)</translation>
    </message>
    <message>
        <source>D&amp;irections by the order of targets</source>
        <translation>由目标位置的顺序得出方向(&amp;I)</translation>
    </message>
    <message>
        <source>The reference counts the other &amp;way</source>
        <translation>基准的计数方向相反(&amp;W)</translation>
    </message>
    <message>
        <source>The format of the file</source>
        <translation>文件的格式</translation>
    </message>
    <message>
        <source>A deviation is the reference position minus the target</source>
        <translation>偏差为基准位置减目标位置</translation>
    </message>
    <message>
        <source>For a file that does not name it</source>
        <translation>用于文件没有注明单位时</translation>
    </message>
    <message>
        <source>Lines of a CSV file that come before the names of its columns</source>
        <translation>CSV 文件中列名之前的行数</translation>
    </message>
    <message>
        <source>For a file without directions: a run is up while its targets rise</source>
        <translation>用于没有方向的文件：目标位置递增的一趟为正向</translation>
    </message>
    <message>
        <source>For an instrument that counts down while the axis moves up</source>
        <translation>用于轴正向运动时计数减小的仪器</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileFacts</name>
    <message>
        <source>off: the drive added nothing</source>
        <translation>关闭：驱动器未叠加任何值</translation>
    </message>
    <message>
        <source>on, with table %1</source>
        <translation>开启，使用表 %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开启</translation>
    </message>
    <message>
        <source>the file does not say it</source>
        <translation>文件没有注明</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 %4</source>
        <translation>%1 个，从 %2 到 %3 %4</translation>
    </message>
    <message>
        <source>What</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Statement of the file</source>
        <translation>文件中的说明</translation>
    </message>
    <message>
        <source>What the file says</source>
        <translation>文件说明</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>读取格式</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>趟次</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给速度</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>停留时间</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空气</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Expansion</source>
        <translation>膨胀系数</translation>
    </message>
    <message>
        <source>Corrected to 20 °C</source>
        <translation>修正到 20 °C</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileLinesModel</name>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>第 %1 行，第 %2 列：%3</translation>
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
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>%1, line %2, column %3</source>
        <translation>%1，第 %2 行，第 %3 列</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>正在读取文件…</translation>
    </message>
    <message>
        <source>These lines can no longer be read from the file.</source>
        <translation>已无法从文件中读取这些行。</translation>
    </message>
    <message>
        <source>Lines %1 to %2</source>
        <translation>第 %1 至 %2 行</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>上一个问题</translation>
    </message>
    <message>
        <source>Show the lines at the previous problem</source>
        <translation>显示上一个问题所在的行</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>下一个问题</translation>
    </message>
    <message>
        <source>Show the lines at the next problem</source>
        <translation>显示下一个问题所在的行</translation>
    </message>
    <message>
        <source>Table&apos;s values</source>
        <translation>表的值</translation>
    </message>
    <message>
        <source>Show the values of the selected table again</source>
        <translation>重新显示所选表的值</translation>
    </message>
    <message>
        <source>Earlier lines</source>
        <translation>前面的行</translation>
    </message>
    <message>
        <source>Show the lines before these</source>
        <translation>显示这些行之前的行</translation>
    </message>
    <message>
        <source>Later lines</source>
        <translation>后面的行</translation>
    </message>
    <message>
        <source>Show the lines after these</source>
        <translation>显示这些行之后的行</translation>
    </message>
    <message>
        <source>The file&apos;s lines at the chosen problem</source>
        <translation>所选问题在文件中的行</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FileViews</name>
    <message>
        <source>What the file says</source>
        <translation>文件说明</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Views of the file</source>
        <translation>文件视图</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>问题 (%1)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FindDrivesDialog</name>
    <message>
        <source>Find Drives</source>
        <translation>查找驱动器</translation>
    </message>
    <message>
        <source>Asks every serial port of this computer for a drive; nothing else is sent. A port that is not listed can be entered as an address, such as serial:/dev/ttyUSB0?baud=921600.</source>
        <translation>在本计算机的每个串口上查询驱动器；不发送其他内容。未列出的端口可作为地址输入，例如 serial:/dev/ttyUSB0?baud=921600。</translation>
    </message>
    <message>
        <source>Try all common &amp;baud rates at every port</source>
        <translation>在每个端口尝试所有常用波特率(&amp;B)</translation>
    </message>
    <message>
        <source>Takes a few seconds for each port without an answer</source>
        <translation>没有应答的端口每个需要几秒</translation>
    </message>
    <message>
        <source>&amp;Search Again</source>
        <translation>重新搜索(&amp;S)</translation>
    </message>
    <message>
        <source>Search all ports again</source>
        <translation>重新搜索所有端口</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>查找结果</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>正在搜索…</translation>
    </message>
    <message>
        <source>%1, serial number %2, axes: %3</source>
        <translation>%1，序列号 %2，轴：%3</translation>
    </message>
    <message>
        <source>All serial ports of this computer are already in the list.</source>
        <translation>本计算机的所有串口均已在列表中。</translation>
    </message>
    <message>
        <source>Ports searched: %1; drives found: %2</source>
        <translation>已搜索端口：%1；找到驱动器：%2</translation>
    </message>
    <message>
        <source>&amp;Add to the Connections</source>
        <translation>添加到连接(&amp;A)</translation>
    </message>
    <message>
        <source>No drive is chosen</source>
        <translation>没有选择驱动器</translation>
    </message>
    <message>
        <source>A network is asked only when you confirm its addresses: each of them gets one request.</source>
        <translation>只有在您确认地址后才会查询网络：每个地址收到一次请求。</translation>
    </message>
    <message>
        <source>&amp;Network:</source>
        <translation>网络(&amp;N)：</translation>
    </message>
    <message>
        <source>Addresses of a network</source>
        <translation>网络的地址</translation>
    </message>
    <message>
        <source>Such as 192.168.1.0/24, 192.168.1.10-40 or one address, with :8080 behind it for another port than 80</source>
        <translation>例如 192.168.1.0/24、192.168.1.10-40 或单个地址；端口不是 80 时在其后加 :8080 等</translation>
    </message>
    <message>
        <source>192.168.1.0/24</source>
        <comment>example of a range</comment>
        <translation>192.168.1.0/24</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Ask no more; what was found stays</source>
        <translation>不再查询；保留已找到的结果</translation>
    </message>
    <message>
        <source>Asked %1 of %2 addresses; drives found: %3</source>
        <translation>已查询 %2 个地址中的 %1 个；找到驱动器：%3</translation>
    </message>
    <message>
        <source>Stopped. Addresses asked: %1; drives found: %2</source>
        <translation>已停止。已查询地址：%1；找到驱动器：%2</translation>
    </message>
    <message>
        <source>Addresses asked: %1; drives found: %2</source>
        <translation>已查询地址：%1；找到驱动器：%2</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses (%1)</source>
        <translation>查询地址 (%1)(&amp;D)</translation>
    </message>
    <message>
        <source>Ask A&amp;ddresses</source>
        <translation>查询地址(&amp;D)</translation>
    </message>
    <message>
        <source>Each address gets one request over http, for the list of its files; what answers as a drive does is asked who it is</source>
        <translation>每个地址收到一次 http 请求，查询其文件列表；应答像驱动器的，再查询其身份</translation>
    </message>
    <message>
        <source>Enter the addresses first</source>
        <translation>请先输入地址</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitForm</name>
    <message>
        <source>%1: a number is needed. %2</source>
        <translation>%1：需要一个数字。%2</translation>
    </message>
    <message>
        <source>The current axis has no source.</source>
        <translation>当前轴没有源。</translation>
    </message>
    <message>
        <source>%1 of the current axis is no known position.</source>
        <translation>当前轴的 %1 不是已知的位置。</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position before the compensation.</source>
        <translation>当前轴的 %1 是补偿前的位置。</translation>
    </message>
    <message>
        <source>%1 of the current axis is a position after the compensation.</source>
        <translation>当前轴的 %1 是补偿后的位置。</translation>
    </message>
    <message>
        <source>The raw positions are on file: it does not matter what was active.</source>
        <translation>文件中有原始位置：当时启用何种补偿无关紧要。</translation>
    </message>
    <message>
        <source>Measured with the compensation off, as the file says.</source>
        <translation>测量时补偿关闭（据文件注明）。</translation>
    </message>
    <message>
        <source>Measured with the table %1 active, as the file says.</source>
        <translation>测量时启用表 %1（据文件注明）。</translation>
    </message>
    <message>
        <source>Measured with the compensation on, as the file says.</source>
        <translation>测量时补偿开启（据文件注明）。</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Lookup at</source>
        <translation>查表位置</translation>
    </message>
    <message>
        <source>Where the drive looks its table up; it decides where the values belong</source>
        <translation>驱动器在哪个位置查表；它决定各值的归属</translation>
    </message>
    <message>
        <source>as the source of the axis says</source>
        <translation>按轴的源确定</translation>
    </message>
    <message>
        <source>encoder, uncompensated</source>
        <translation>编码器，未补偿</translation>
    </message>
    <message>
        <source>set position, compensated</source>
        <translation>给定位置，已补偿</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>测量时启用</translation>
    </message>
    <message>
        <source>What was active while it was measured, since the file does not say it</source>
        <translation>测量时启用的补偿，用于文件没有注明时</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>未注明</translation>
    </message>
    <message>
        <source>compensation off</source>
        <translation>补偿关闭</translation>
    </message>
    <message>
        <source>the table that is merged onto</source>
        <translation>所合并到的表</translation>
    </message>
    <message>
        <source>the table of a file…</source>
        <translation>文件中的表…</translation>
    </message>
    <message>
        <source>Merge onto</source>
        <translation>合并到</translation>
    </message>
    <message>
        <source>The table to which residuals are added, that was active while they were measured</source>
        <translation>残差要加到的表，也是测量残差时启用的表</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>不合并</translation>
    </message>
    <message>
        <source>the table of the axis</source>
        <translation>该轴的表</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Factor for the residuals: 1, or below it, such as 0.7, where the machine responds sluggishly; at most 2</source>
        <translation>残差所乘的增益：1；机床响应迟缓时小于 1，如 0.7；最大 2</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>The curve through or near the means</source>
        <translation>通过或接近平均值的曲线</translation>
    </message>
    <message>
        <source>linear: straight lines</source>
        <translation>linear：直线</translation>
    </message>
    <message>
        <source>cubic: without overshoot</source>
        <translation>cubic：无过冲</translation>
    </message>
    <message>
        <source>spline: natural cubic</source>
        <translation>spline：自然三次</translation>
    </message>
    <message>
        <source>smooth: near the values</source>
        <translation>smooth：接近各值</translation>
    </message>
    <message>
        <source>harmonic: of a turn</source>
        <translation>harmonic：一转的谐波</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Which runs the table is made of</source>
        <translation>由哪些趟生成表</translation>
    </message>
    <message>
        <source>mean of up and down</source>
        <translation>正向和负向的平均值</translation>
    </message>
    <message>
        <source>up only</source>
        <translation>仅正向</translation>
    </message>
    <message>
        <source>down only</source>
        <translation>仅负向</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>平滑度</translation>
    </message>
    <message>
        <source>A number from 0 on; by cross-validation when the field is empty</source>
        <translation>不小于 0 的数字；为空则由交叉验证确定</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Known periods above 0, such as the lead of the screw: 10; 2.5</source>
        <translation>大于 0 的已知周期，例如丝杠导程：10; 2.5</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>谐波</translation>
    </message>
    <message>
        <source>Of each period, or of the turn; 1 is the fundamental alone</source>
        <translation>每个周期或一转的谐波数；1 表示仅基波</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>一转</translation>
    </message>
    <message>
        <source>Length of a turn of a modulo axis, such as 360: the table ends as it begins</source>
        <translation>模数轴一转的长度，例如 360：表的末端与起点相同</translation>
    </message>
    <message>
        <source>no modulo axis</source>
        <translation>非模数轴</translation>
    </message>
    <message>
        <source>Grid of the table</source>
        <translation>表的网格</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>点的位置</translation>
    </message>
    <message>
        <source>Positions of the table, always evenly spaced</source>
        <translation>表的位置，总是等间距</translation>
    </message>
    <message>
        <source>those measured, where even</source>
        <translation>测得的位置（等间距时）</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>a distance</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>the fewest points for a deviation</source>
        <translation>满足偏差的最少点数</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Whole numbers from 2 on: one for all axes, or 41; 31</source>
        <translation>不小于 2 的整数：所有轴共用一个，或 41; 31</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions: one for all axes, or 10; 5</source>
        <translation>大于 0，以位置的单位：所有轴共用一个，或 10; 5</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Above 0, in the unit of the positions</source>
        <translation>大于 0，以位置的单位</translation>
    </message>
    <message>
        <source>Hold ends beyond the targets</source>
        <translation>目标位置之外保持端值</translation>
    </message>
    <message>
        <source>The grid may go beyond the targets, where the end values are held</source>
        <translation>网格可以超出目标位置，超出部分保持端值</translation>
    </message>
    <message>
        <source>Zero, slope and drift</source>
        <translation>零点、斜率和漂移</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>零点</translation>
    </message>
    <message>
        <source>Where the table is 0: the zero of the instrument is arbitrary</source>
        <translation>表为 0 的位置：仪器的零点是任意的</translation>
    </message>
    <message>
        <source>home, else first target</source>
        <translation>原点，否则首目标位置</translation>
    </message>
    <message>
        <source>at the home position</source>
        <translation>在原点位置</translation>
    </message>
    <message>
        <source>at the first target</source>
        <translation>在首目标位置</translation>
    </message>
    <message>
        <source>mean of the values</source>
        <translation>各值的平均值</translation>
    </message>
    <message>
        <source>at a position</source>
        <translation>在指定位置</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>按测得值</translation>
    </message>
    <message>
        <source>At</source>
        <translation>位于</translation>
    </message>
    <message>
        <source>The position of the zero, one number for each axis</source>
        <translation>零点的位置，每个轴一个数字</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>The home position of the axis</source>
        <translation>轴的原点位置</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>It is taken out of straightness alone: scale error is real</source>
        <translation>只应从直线度中去除：比例误差是真实的误差</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>taken out by least squares</source>
        <translation>按最小二乘去除</translation>
    </message>
    <message>
        <source>taken out by the ends</source>
        <translation>按两端去除</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>What is taken out of runs that lie beside each other before the table is made</source>
        <translation>生成表之前，从彼此偏离的各趟中去除的内容</translation>
    </message>
    <message>
        <source>offset of each run taken out</source>
        <translation>去除每一趟的偏移</translation>
    </message>
    <message>
        <source>trend taken out</source>
        <translation>去除趋势</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>放置状态</translation>
    </message>
    <message>
        <source>alignment, lines along %1 level</source>
        <translation>放置状态，沿 %1 的直线无斜率</translation>
    </message>
    <message>
        <source>alignment and scale</source>
        <translation>放置状态和比例</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>去除</translation>
    </message>
    <message>
        <source>How the artefact lay is no error of the machine</source>
        <translation>标准器的放置状态不是机床的误差</translation>
    </message>
    <message>
        <source>Far points</source>
        <translation>远离的点</translation>
    </message>
    <message>
        <source>Points of the grid that are far from any measured one</source>
        <translation>远离任何测得点的网格点</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>filled smoothly</source>
        <translation>平滑填补</translation>
    </message>
    <message>
        <source>filled with the nearest</source>
        <translation>用最近的值填补</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>稳健</translation>
    </message>
    <message>
        <source>Values that do not fit the others count less</source>
        <translation>与其余的值不符的值权重较低</translation>
    </message>
    <message>
        <source>The axis has another table since that was said: say it anew.</source>
        <translation>指定之后该轴的表已改变：请重新指定。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitOutcome</name>
    <message>
        <source>fit of %1</source>
        <translation>%1 的拟合</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPage</name>
    <message>
        <source>Merge onto</source>
        <translation>合并到</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>测量时启用</translation>
    </message>
    <message>
        <source>An earlier table; a new one is being made …</source>
        <translation>先前的表；正在生成新表…</translation>
    </message>
    <message>
        <source>The table is being made …</source>
        <translation>正在生成表…</translation>
    </message>
    <message>
        <source>Table and measurement</source>
        <translation>表和测量</translation>
    </message>
    <message>
        <source>No table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>There is no table yet</source>
        <translation>尚无表</translation>
    </message>
    <message>
        <source>Take the table over to Write, as if it had been read from a file</source>
        <translation>将该表转入“写入”，如同从文件读取</translation>
    </message>
    <message>
        <source>As a file of the drive or of another controller</source>
        <translation>存为驱动器或其他控制器的文件</translation>
    </message>
    <message>
        <source>Add the files of a measurement on Measure; here a table is made of it.</source>
        <translation>请在“测量”中添加测量的文件；此处由其生成表。</translation>
    </message>
    <message>
        <source>The files on Measure cannot be used.</source>
        <translation>“测量”中的文件无法使用。</translation>
    </message>
    <message>
        <source>Choose where the drive looks its table up: it decides where the values belong.</source>
        <translation>请选择驱动器查表的位置：它决定各值的归属。</translation>
    </message>
    <message>
        <source>Read the warnings; then the table can be used: it is taken over to Write.</source>
        <translation>请阅读警告；然后即可使用该表：它将转入“写入”。</translation>
    </message>
    <message>
        <source>The table can be used: it is taken over to Write, where nothing is written before you say so.</source>
        <translation>该表可以使用：它将转入“写入”；在您确认之前不会写入任何内容。</translation>
    </message>
    <message>
        <source>Use as Table</source>
        <translation>用作表</translation>
    </message>
    <message>
        <source>Save Table…</source>
        <translation>保存表…</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Which column of the points is shown and used</source>
        <translation>显示和使用点的哪一列</translation>
    </message>
    <message>
        <source>The table corrects axis %1, and the current axis is %2: it is refused there. Choose the axis that was measured.</source>
        <translation>该表修正轴 %1，而当前轴为 %2：在该轴上会被拒绝。请选择所测量的轴。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitPlot</name>
    <message>
        <source>compensation [%1]</source>
        <translation>补偿 [%1]</translation>
    </message>
    <message>
        <source>remains [%1]</source>
        <translation>残余 [%1]</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>measured, with its standard error</source>
        <translation>测得值及其标准误差</translation>
    </message>
    <message>
        <source>foretold without the target</source>
        <translation>留出该目标位置的预测</translation>
    </message>
    <message>
        <source>Picture of the fit</source>
        <translation>拟合图</translation>
    </message>
    <message>
        <source>The table over what was measured, and what remains. Left and right go from point to point; the wheel and + and - zoom, Home shows all.</source>
        <translation>测得值上的表，以及残余误差。左、右方向键逐点移动；滚轮及 + 和 - 缩放，Home 键显示全部。</translation>
    </message>
    <message>
        <source>%1: measured %2 ± %3, %4 remains</source>
        <translation>%1：测得 %2 ± %3，残余 %4</translation>
    </message>
    <message>
        <source>%1: measured %2, %3 remains</source>
        <translation>%1：测得 %2，残余 %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::FitResults</name>
    <message>
        <source>Largest correction: %1 at %2.</source>
        <translation>最大修正量：%1，在 %2。</translation>
    </message>
    <message>
        <source>What remains, rms</source>
        <translation>残余，均方根</translation>
    </message>
    <message>
        <source>What remains, largest</source>
        <translation>残余，最大</translation>
    </message>
    <message>
        <source>Figure [%1]</source>
        <translation>指标 [%1]</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>At the targets</source>
        <translation>目标位置处</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>警告：%1</translation>
    </message>
    <message>
        <source>%1: foretold %2, tolerance %3: %4.</source>
        <translation>%1：预测 %2，公差 %3：%4。</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>Table %1: %2; CRC %3.</source>
        <translation>表 %1：%2；CRC %3。</translation>
    </message>
    <message>
        <source>Looked up at the encoder&apos;s position, before the compensation.</source>
        <translation>在编码器位置处查表，即补偿前。</translation>
    </message>
    <message>
        <source>Looked up at the set position, after the compensation.</source>
        <translation>在给定位置处查表，即补偿后。</translation>
    </message>
    <message>
        <source>Smoothness %1.</source>
        <translation>平滑度 %1。</translation>
    </message>
    <message>
        <source>Points of the grid that were filled: %1 of %2.</source>
        <translation>已填补的网格点：%2 个中的 %1 个。</translation>
    </message>
    <message>
        <source>Held out: each target foretold without it, which is the one to believe between the targets.</source>
        <translation>留出：每个目标位置在不使用它自身的情况下预测；目标位置之间应以此为准。</translation>
    </message>
    <message>
        <source>Figures before and foretold</source>
        <translation>补偿前和预测的指标</translation>
    </message>
    <message>
        <source>Before the table is used</source>
        <translation>使用该表之前</translation>
    </message>
    <message>
        <source>%1, held out %2</source>
        <translation>%1，留出 %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ForeignChange</name>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive: the compensation is off. Home the axis and activate again.</source>
        <translation>该轴已失去原点，如同驱动器重启之后：补偿已关闭。请使轴回原点，然后重新启用。</translation>
    </message>
    <message>
        <source>The axis has lost its homing, as after a restart of the drive.</source>
        <translation>该轴已失去原点，如同驱动器重启之后。</translation>
    </message>
    <message>
        <source>The compensation is off: something other than this window has switched it off.</source>
        <translation>补偿已关闭：不是由本窗口关闭的。</translation>
    </message>
    <message>
        <source>The compensation is on: something other than this window has switched it on.</source>
        <translation>补偿已开启：不是由本窗口开启的。</translation>
    </message>
    <message>
        <source>The axis has no table any more.</source>
        <translation>该轴已没有表。</translation>
    </message>
    <message>
        <source>dimensionality</source>
        <translation>维数</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>源 %1</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>Its volatile table is gone: write it again, as a persistent one if it has to outlast a restart.</source>
        <translation>其易失表已丢失：请重新写入；如需在重启后保留，请以持久方式写入。</translation>
    </message>
    <message>
        <source>The settings of this axis on the drive have changed, and not by this window: %1.</source>
        <translation>驱动器上此轴的设置已改变，且并非由此窗口更改：%1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>用户手册</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>用户手册</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportConfigurationDialog</name>
    <message>
        <source>Import TAM Configuration</source>
        <translation>导入 TAM 配置</translation>
    </message>
    <message>
        <source>Writes the table and source parameters in %1 to the axes of %2, one after the other. The tables themselves must be on the drive. Each write makes a backup and is verified; no compensation is switched on.</source>
        <translation>将 %1 中的表参数和源参数逐轴写入 %2 的各轴。表本身必须已在驱动器上。每次写入都会生成备份并经校验；不开启任何补偿。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ImportDialog</name>
    <message>
        <source>Import Compensation Data</source>
        <translation>导入补偿数据</translation>
    </message>
    <message>
        <source>Choose how to read %1. The result is the table that the drive adds to the encoder position, on an even grid.</source>
        <translation>请选择 %1 的读取方式。结果为驱动器叠加到编码器位置的、均匀网格上的表。</translation>
    </message>
    <message>
        <source>I&amp;mport</source>
        <translation>导入(&amp;M)</translation>
    </message>
    <message>
        <source>Use the file with these choices; nothing is written to the drive yet</source>
        <translation>按这些选择使用该文件；尚不向驱动器写入任何内容</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>第 %1 行： </translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::JudgePage</name>
    <message>
        <source>Tolerances, and the uncertainty U (k = 2)</source>
        <translation>公差，以及不确定度 U (k = 2)</translation>
    </message>
    <message>
        <source>All &amp;values</source>
        <translation>所有值(&amp;V)</translation>
    </message>
    <message>
        <source>Show plot and targets as if nothing were excluded</source>
        <translation>显示图和目标位置时如同没有排除任何值</translation>
    </message>
    <message>
        <source>&amp;Corrections…</source>
        <translation>修正(&amp;C)…</translation>
    </message>
    <message>
        <source>Bring the values to 20 °C, or correct them for the dead path of an interferometer</source>
        <translation>将值修正到 20 °C，或作干涉仪的死程修正</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>趟次</translation>
    </message>
    <message>
        <source>Drift in numbers</source>
        <translation>漂移数值</translation>
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
        <translation>无修正。</translation>
    </message>
    <message>
        <source>Figures of ISO 230-2:2014</source>
        <translation>GB/T 17421.2 (ISO 230-2:2014) 指标</translation>
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
        <translation>允许的最大值，例如 10 µm；为空：无公差</translation>
    </message>
    <message>
        <source>Uncertainty of the measurement with k = 2, such as 2.1 µm; empty: not stated</source>
        <translation>k = 2 时的测量不确定度，例如 2.1 µm；为空：未注明</translation>
    </message>
    <message>
        <source>Tolerance: %1</source>
        <translation>公差：%1</translation>
    </message>
    <message>
        <source>Uncertainty U, k = 2</source>
        <translation>不确定度 U，k = 2</translation>
    </message>
    <message>
        <source>&amp;Accuracy A</source>
        <translation>定位精度 A(&amp;A)</translation>
    </message>
    <message>
        <source>Systematic &amp;E</source>
        <translation>系统偏差 E(&amp;E)</translation>
    </message>
    <message>
        <source>Range of means &amp;M</source>
        <translation>平均偏差范围 M(&amp;M)</translation>
    </message>
    <message>
        <source>Reversal &amp;B</source>
        <translation>反向差值 B(&amp;B)</translation>
    </message>
    <message>
        <source>Repeatab&amp;ility R</source>
        <translation>重复定位精度 R(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Uncertainty U</source>
        <translation>不确定度 U(&amp;U)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::LogView</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Copy the selected lines, or all of them</source>
        <translation>复制所选的行或全部行</translation>
    </message>
    <message>
        <source>Save the log to a file</source>
        <translation>将日志保存到文件</translation>
    </message>
    <message>
        <source>Hide the log</source>
        <translation>隐藏日志</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineActions</name>
    <message>
        <source>Open Machine File</source>
        <translation>打开机床文件</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>机床文件 (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineApplication</name>
    <message>
        <source>All drives already had what %1 says; nothing was written.</source>
        <translation>所有驱动器已与 %1 一致；未写入任何内容。</translation>
    </message>
    <message>
        <source>%1 is applied.</source>
        <translation>已应用 %1。</translation>
    </message>
    <message>
        <source>%1 is not applied as a whole: %2</source>
        <translation>%1 没有全部应用：%2</translation>
    </message>
    <message>
        <source>Failed: %1.</source>
        <translation>失败：%1。</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>已写入并校验：%1。</translation>
    </message>
    <message>
        <source>Not written: %1.</source>
        <translation>未写入：%1。</translation>
    </message>
    <message>
        <source>Applying it again does the rest.</source>
        <translation>再次应用可完成其余部分。</translation>
    </message>
    <message>
        <source>%1: %2; it holds: %3.</source>
        <comment>axis, what became of it, and its table</comment>
        <translation>%1：%2；现有：%3。</translation>
    </message>
    <message>
        <source>%1: %2; what it holds is not known.</source>
        <comment>axis, and what became of it</comment>
        <translation>%1：%2；现有内容未知。</translation>
    </message>
    <message>
        <source>Begin: applying the machine file %1.</source>
        <translation>开始：应用机床文件 %1。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Switched: %1.</source>
        <translation>已切换：%1。</translation>
    </message>
    <message>
        <source>Not switched: %1.</source>
        <translation>未切换：%1。</translation>
    </message>
    <message>
        <source>Not proved: %1.</source>
        <translation>未验证：%1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachineController</name>
    <message>
        <source>No machine file is open.</source>
        <translation>没有打开的机床文件。</translation>
    </message>
    <message>
        <source>The machine file is being read.</source>
        <translation>正在读取机床文件。</translation>
    </message>
    <message>
        <source>The machine file is being applied.</source>
        <translation>正在应用机床文件。</translation>
    </message>
    <message>
        <source>Wait for the end of the current operation.</source>
        <translation>请等待当前操作结束。</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>正在比较驱动器。</translation>
    </message>
    <message>
        <source>Not all drives of the file are among the connections.</source>
        <translation>文件中的驱动器并非都在连接之中。</translation>
    </message>
    <message>
        <source>Nothing is written while something stands in the way of a part of it.</source>
        <translation>只要其中任一部分存在障碍，就不写入任何内容。</translation>
    </message>
    <message>
        <source>All drives have what the file says.</source>
        <translation>所有驱动器均与文件一致。</translation>
    </message>
    <message>
        <source>No drive of the file answers.</source>
        <translation>文件中没有驱动器应答。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MachinePane</name>
    <message>
        <source>&amp;Plan Again</source>
        <translation>重新制定计划(&amp;P)</translation>
    </message>
    <message>
        <source>Reads the machine file and its tables again and compares all drives with them</source>
        <translation>重新读取机床文件及其各表，并将所有驱动器与之比较</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>应用(&amp;A)…</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>在写入任何内容之前，显示将写入各驱动器的内容</translation>
    </message>
    <message>
        <source>Close Machine &amp;File</source>
        <translation>关闭机床文件(&amp;F)</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>驱动器保持连接；不作任何更改</translation>
    </message>
    <message>
        <source>Problems of the machine file</source>
        <translation>机床文件的问题</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>as the file says: %1</source>
        <comment>number of axes</comment>
        <translation>与文件一致：%1</translation>
    </message>
    <message>
        <source>differ: %1</source>
        <comment>number of axes</comment>
        <translation>不同：%1</translation>
    </message>
    <message>
        <source>cannot be compared: %1</source>
        <comment>number of axes</comment>
        <translation>无法比较：%1</translation>
    </message>
    <message>
        <source>not reachable: %1</source>
        <comment>number of axes</comment>
        <translation>无法访问：%1</translation>
    </message>
    <message>
        <source>not among the connections: %1</source>
        <comment>number of axes</comment>
        <translation>不在连接之中：%1</translation>
    </message>
    <message>
        <source>not compared yet: %1</source>
        <comment>number of axes</comment>
        <translation>尚未比较：%1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>file and machine</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1: axes %2.</source>
        <comment>machine file and numbers of axes</comment>
        <translation>%1：轴 %2。</translation>
    </message>
    <message>
        <source>Compared at %1.</source>
        <translation>比较时间：%1。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive or axis, and what is wrong</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>This drive is not among the connections any more.</source>
        <translation>此驱动器已不在连接之中。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurePage</name>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>&amp;Save as Runs…</source>
        <translation>保存为逐趟测量(&amp;S)…</translation>
    </message>
    <message>
        <source>All files as one CSV file, with what is excluded marked in it</source>
        <translation>所有文件存为一个 CSV 文件，其中标出已排除的内容</translation>
    </message>
    <message>
        <source>Files of the measurement</source>
        <translation>测量的文件</translation>
    </message>
    <message>
        <source>Values of all files</source>
        <translation>所有文件的值</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>正在读取文件…</translation>
    </message>
    <message>
        <source>Take the values of a plan while something else moves the axis</source>
        <translation>在其他设备移动轴的同时，按测量计划采集各值</translation>
    </message>
    <message>
        <source>New &amp;Program…</source>
        <translation>新建程序(&amp;P)…</translation>
    </message>
    <message>
        <source>Plan the targets of a measurement, and a program for the control of the machine</source>
        <translation>规划测量的目标位置，并生成机床数控系统的程序</translation>
    </message>
    <message>
        <source>Cap&amp;ture…</source>
        <translation>采集(&amp;T)…</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>Add the files of a measurement, take its values with Capture, or go on to Write with a table that is there.</source>
        <translation>请添加测量的文件，或用“采集”取得各值，或以现有的表转到“写入”。</translation>
    </message>
    <message>
        <source>Saved as %1. Judge says what it is worth, and Fit makes a table of it.</source>
        <translation>已保存为 %1。“评定”给出其结论，“拟合”由其生成表。</translation>
    </message>
    <message>
        <source>Without targets there are no figures of ISO 230-2; Fit makes a table of it.</source>
        <translation>没有目标位置就没有 GB/T 17421.2 的指标；“拟合”可由其生成表。</translation>
    </message>
    <message>
        <source>The measurement can be used. Go on to Judge and Fit.</source>
        <translation>该测量可以使用。请转到“评定”和“拟合”。</translation>
    </message>
    <message>
        <source>%1 was captured for the record that was open before, and is not added to this one.</source>
        <translation>%1 是为先前打开的档案采集的，不添加到当前档案。</translation>
    </message>
    <message>
        <source>Saved as %1 with the values of the files: the corrections are not in it.</source>
        <translation>已按文件中的值保存为 %1，其中不含修正。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFiles</name>
    <message>
        <source>&amp;Add…</source>
        <translation>添加(&amp;A)…</translation>
    </message>
    <message>
        <source>Add files of a measurement; they can also be dropped here (Ctrl+O)</source>
        <translation>添加测量的文件；也可以拖放到此处 (Ctrl+O)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>Take the selected file out of the measurement (Del)</source>
        <translation>从测量中移除所选的文件 (Del)</translation>
    </message>
    <message>
        <source>E&amp;xchange up and down in all files</source>
        <translation>在所有文件中对调正向和负向(&amp;X)</translation>
    </message>
    <message>
        <source>For files that name the directions the other way round</source>
        <translation>用于方向名称相反的文件</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasurementFilesModel</name>
    <message>
        <source>off</source>
        <comment>compensation</comment>
        <translation>关闭</translation>
    </message>
    <message>
        <source>on</source>
        <comment>compensation</comment>
        <translation>开启</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>未注明</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>无法使用</translation>
    </message>
    <message>
        <source>warnings: %1</source>
        <translation>警告：%1</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>samples: %1</source>
        <translation>采样点：%1</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>点：%1</translation>
    </message>
    <message>
        <source>means</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>%1 up, %2 down</source>
        <translation>正向 %1，负向 %2</translation>
    </message>
    <message>
        <source>being read …</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>%1, as the record holds it</source>
        <translation>%1，取自档案</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MeasuringActions</name>
    <message>
        <source>Values are being captured: stop that first</source>
        <translation>正在采集测得值：请先停止采集</translation>
    </message>
    <message>
        <source>Choose a drive and an axis first</source>
        <translation>请先选择驱动器和轴</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessagePresenter</name>
    <message>
        <source>This is the built-in demo drive. Try everything; no real drive is affected.</source>
        <translation>这是内置的演示驱动器。可以试用全部功能；不影响任何真实驱动器。</translation>
    </message>
    <message>
        <source>Wor&amp;k with Real Drives…</source>
        <translation>使用真实驱动器(&amp;K)…</translation>
    </message>
    <message>
        <source>%1 Your changes are kept; reconnecting …</source>
        <translation>%1您的更改已保留；正在重新连接…</translation>
    </message>
    <message>
        <source>%1 Reconnecting …</source>
        <translation>%1正在重新连接…</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>%1 在磁盘上已改变。</translation>
    </message>
    <message>
        <source>Read A&amp;gain</source>
        <translation>重新读取(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Finish Write</source>
        <translation>完成写入(&amp;F)</translation>
    </message>
    <message>
        <source>Undo Wri&amp;te</source>
        <translation>撤销写入(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keep for Later</source>
        <translation>以后再说(&amp;K)</translation>
    </message>
    <message>
        <source>S&amp;how Certificate…</source>
        <translation>显示证书(&amp;H)…</translation>
    </message>
    <message>
        <source>%1 is being asked …</source>
        <translation>正在查询 %1…</translation>
    </message>
    <message>
        <source>%1 has no axis with compensation registers.</source>
        <translation>%1 没有带补偿寄存器的轴。</translation>
    </message>
    <message>
        <source>%1 does not answer. %2</source>
        <comment>drive, reason</comment>
        <translation>%1 没有应答。%2</translation>
    </message>
    <message>
        <source>Tr&amp;y Again</source>
        <translation>重试(&amp;Y)</translation>
    </message>
    <message>
        <source>%1 answers now.</source>
        <translation>%1 现在有应答了。</translation>
    </message>
    <message>
        <source>Displa&amp;y Drive</source>
        <translation>显示驱动器(&amp;Y)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MessageStack</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisController</name>
    <message>
        <source>The writes have not been planned yet.</source>
        <translation>尚未制定写入计划。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisDialog</name>
    <message>
        <source>Write Several Axes</source>
        <translation>多轴写入</translation>
    </message>
    <message>
        <source>Writes columns of %1 to axes of %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified.</source>
        <translation>将 %1 的各列依次写入 %2 的各轴。第一个写入开始前先检查所有写入；每个写入都会生成备份并经校验。</translation>
    </message>
    <message>
        <source>&amp;Sources</source>
        <translation>源(&amp;S)</translation>
    </message>
    <message>
        <source>Each axis keeps its sources</source>
        <translation>各轴保留其源</translation>
    </message>
    <message>
        <source>The registers that supply the positions for the tables</source>
        <translation>为各表提供位置的寄存器</translation>
    </message>
    <message>
        <source>The same for all, as on the page: %1</source>
        <translation>所有轴相同，与页面一致：%1</translation>
    </message>
    <message>
        <source>Persistent, as on the page: all tables are stored in flash.</source>
        <translation>持久，与页面一致：所有表均存入闪存。</translation>
    </message>
    <message>
        <source>Volatile, as on the page: a reboot of the drive restores the stored state.</source>
        <translation>易失，与页面一致：驱动器重启后恢复已存储的状态。</translation>
    </message>
    <message>
        <source>Each axis its own position</source>
        <translation>各轴采用自身的位置</translation>
    </message>
    <message>
        <source>No register is known for the position of %1: select other sources.</source>
        <translation>%1 的位置没有已知的寄存器：请选择其他源。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisOutcome</name>
    <message>
        <source>The writes were stopped.</source>
        <translation>写入已停止。</translation>
    </message>
    <message>
        <source>The writes were stopped at %1.</source>
        <translation>写入停止在 %1。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and sentence</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>No axis was changed.</source>
        <translation>没有轴被更改。</translation>
    </message>
    <message>
        <source>New state: %1.</source>
        <translation>新状态：%1。</translation>
    </message>
    <message>
        <source>Old state, complete: %1.</source>
        <translation>旧状态，完整：%1。</translation>
    </message>
    <message>
        <source>%1 The tables that no axis uses are not all restored: %2</source>
        <translation>%1没有轴使用的表未全部还原：%2</translation>
    </message>
    <message>
        <source>Written and verified: %1.</source>
        <translation>已写入并校验：%1。</translation>
    </message>
    <message>
        <source>This is stored in flash.</source>
        <translation>已存入闪存。</translation>
    </message>
    <message>
        <source>This is volatile: a reboot of the drive restores the stored state.</source>
        <translation>该状态为易失：驱动器重启后恢复已存储的状态。</translation>
    </message>
    <message>
        <source>Stored in flash: %1.</source>
        <translation>已存入闪存：%1。</translation>
    </message>
    <message>
        <source>Volatile: %1; a reboot of the drive restores the stored state.</source>
        <translation>易失：%1；驱动器重启后恢复已存储的状态。</translation>
    </message>
    <message>
        <source>The axes already had all of this.</source>
        <translation>各轴此前已与此完全一致。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::MultiAxisPlanView</name>
    <message>
        <source>persistent</source>
        <translation>持久</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>易失</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>%1D in %2, %3</source>
        <translation>%1D，%2，%3</translation>
    </message>
    <message>
        <source>nothing: the drive already has all of this</source>
        <translation>无：驱动器已与此完全一致</translation>
    </message>
    <message>
        <source>%1 (empty)</source>
        <translation>%1（空）</translation>
    </message>
    <message>
        <source>%1 (held an earlier table of this axis)</source>
        <translation>%1（原为该轴先前的表）</translation>
    </message>
    <message>
        <source>%1 (will be overwritten)</source>
        <translation>%1（将被覆盖）</translation>
    </message>
    <message>
        <source>Dim%1: %2</source>
        <translation>Dim%1：%2</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>驱动器上</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>表槽</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>将写入的内容</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis and remark</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>不使用闪存操作。</translation>
    </message>
    <message>
        <source>Flash operations in total: %1.</source>
        <translation>闪存操作合计：%1。</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>闪存操作：使用 %1 次，随后剩余 %2 次。</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>这些较大的修正量无误：已核对其单位(&amp;R)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberEdit</name>
    <message>
        <source>%1: &quot;%2&quot; cannot be taken. %3</source>
        <translation>%1：无法采用“%2”。%3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OperationRunner</name>
    <message>
        <source>Begin: %1, %2.</source>
        <comment>task and drive</comment>
        <translation>开始：%1，%2。</translation>
    </message>
    <message>
        <source>Begin: %1 %2.</source>
        <translation>开始：%1 %2。</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>task, axis and step</comment>
        <translation>%1：%2，%3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: stopping</source>
        <translation>%1：正在停止</translation>
    </message>
    <message>
        <source>The fields were changed while the write was planned: write again.</source>
        <translation>制定写入计划期间字段有更改：请重新写入。</translation>
    </message>
    <message>
        <source>The drive or the fields have changed since the write was planned: write again.</source>
        <translation>制定写入计划之后驱动器或字段有变化：请重新写入。</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>已由用户停止。</translation>
    </message>
    <message>
        <source>Wrote %1: axes: %2, tables: %3.</source>
        <translation>已写出 %1：轴：%2，表：%3。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::Outcome</name>
    <message>
        <source>The drive holds the complete old state.</source>
        <translation>驱动器保持完整的旧状态。</translation>
    </message>
    <message>
        <source>It is stored in flash.</source>
        <translation>已存入闪存。</translation>
    </message>
    <message>
        <source>It is volatile: a reboot of the drive restores the stored state.</source>
        <translation>该状态为易失：驱动器重启后恢复已存储的状态。</translation>
    </message>
    <message>
        <source>Written and verified: the drive holds the new state. %1</source>
        <translation>已写入并校验：驱动器处于新状态。%1</translation>
    </message>
    <message>
        <source>Nothing to write: the drive already has all of this.</source>
        <translation>无需写入：驱动器已与此完全一致。</translation>
    </message>
    <message>
        <source>The write was stopped.</source>
        <translation>写入已停止。</translation>
    </message>
    <message>
        <source>The compensation is off.</source>
        <translation>补偿已关闭。</translation>
    </message>
    <message>
        <source>The compensation is active.</source>
        <translation>补偿已启用。</translation>
    </message>
    <message>
        <source>The compensation is being evaluated: the drive adds nothing.</source>
        <translation>补偿处于试算状态：驱动器不叠加任何值。</translation>
    </message>
    <message>
        <source>The proof was stopped.</source>
        <translation>验证已停止。</translation>
    </message>
    <message>
        <source>%1 But the proof failed: deactivate it unless you know why. %2</source>
        <translation>%1但验证失败：除非知道原因，否则请停用。%2</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state from before the write of %1.</source>
        <translation>已还原：驱动器处于 %1 那次写入之前的状态。</translation>
    </message>
    <message>
        <source>The drive holds the complete new state; nothing more to do.</source>
        <translation>驱动器处于完整的新状态；无需其他操作。</translation>
    </message>
    <message>
        <source>The write of %1 was interrupted (last step: %2). %3</source>
        <translation>%1 的写入被中断（最后一步：%2）。%3</translation>
    </message>
    <message>
        <source>%1 The write is still unfinished.</source>
        <translation>%1该写入仍未完成。</translation>
    </message>
    <message>
        <source>Finished and verified: the drive holds the complete new state.</source>
        <translation>已完成并校验：驱动器处于完整的新状态。</translation>
    </message>
    <message>
        <source>Undone and verified: the drive holds the complete old state.</source>
        <translation>已撤销并校验：驱动器处于完整的旧状态。</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved.</source>
        <translation>驱动器处于完整的新状态，但其参数可能未保存。</translation>
    </message>
    <message>
        <source>The drive holds neither the old nor the new state: finish or undo the write before activating the axis.</source>
        <translation>驱动器既不在旧状态也不在新状态：启用该轴之前，请完成或撤销该写入。</translation>
    </message>
    <message>
        <source>Not proved.</source>
        <translation>未验证。</translation>
    </message>
    <message>
        <source>The proof failed, and the drive evaluates again as before. %1</source>
        <translation>验证失败，驱动器恢复为先前的试算状态。%1</translation>
    </message>
    <message>
        <source>The proof failed, and the compensation was switched off again. %1</source>
        <translation>验证失败，补偿已重新关闭。%1</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>未写入任何内容。</translation>
    </message>
    <message>
        <source>Deleted and verified: %1 is empty, and the axis uses no table.</source>
        <translation>已删除并校验：%1 为空，该轴不使用表。</translation>
    </message>
    <message>
        <source>Proved over %1 of the table: largest difference %2.</source>
        <translation>已在表的 %1 上验证：最大差值 %2。</translation>
    </message>
    <message>
        <source>Its table indices are right.</source>
        <translation>其表索引正确。</translation>
    </message>
    <message>
        <source>The compensation is active, but the drive contradicts its table. Stop the axis and deactivate. %1</source>
        <translation>补偿已启用，但驱动器与其表矛盾。请停止该轴并停用补偿。%1</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1, made of the drive with the serial number %2.</source>
        <translation>已还原：驱动器处于 %1 的备份文件中的状态，该文件来自序列号为 %2 的驱动器。</translation>
    </message>
    <message>
        <source>Restored: the drive holds the state in the backup file of %1.</source>
        <translation>已还原：驱动器处于 %1 的备份文件中的状态。</translation>
    </message>
    <message>
        <source>The compensation may be on, and is not proved. Connect again to see what it does.</source>
        <translation>补偿可能已开启，且未经验证。请重新连接以查看其状态。</translation>
    </message>
    <message>
        <source>Which state the drive holds is not known, since the backup of the old one cannot be read: write again or restore another backup before activating the axis.</source>
        <translation>旧状态的备份无法读取，因此不知道驱动器处于哪个状态：启用该轴之前，请重新写入或还原另一个备份。</translation>
    </message>
    <message>
        <source>The drive holds the complete new state, but its parameters may not be saved, and the backup of the old state cannot be read: write again to save them, or restore another backup.</source>
        <translation>驱动器处于完整的新状态，但其参数可能未保存，且旧状态的备份无法读取：请重新写入以保存参数，或还原另一个备份。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OutlierList</name>
    <message>
        <source>&amp;Outliers by</source>
        <translation>离群值准则(&amp;O)</translation>
    </message>
    <message>
        <source>pooled MAD, limit 4</source>
        <translation>合并 MAD，限值 4</translation>
    </message>
    <message>
        <source>Grubbs, 5 %</source>
        <translation>格拉布斯 (Grubbs)，5 %</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>离群值准则</translation>
    </message>
    <message>
        <source>How values that do not fit the others are found; a proposal, nothing is left out by it</source>
        <translation>如何找出与其余不符的值；仅为建议，不会因此略去任何值</translation>
    </message>
    <message>
        <source>Proposed for exclusion, and excluded</source>
        <translation>建议排除的值和已排除的值</translation>
    </message>
    <message>
        <source>Exclude All &amp;Proposed</source>
        <translation>排除所有建议的值(&amp;P)</translation>
    </message>
    <message>
        <source>Leave out every value that the rule proposes</source>
        <translation>排除该准则建议的每个值</translation>
    </message>
    <message>
        <source>E&amp;xclude</source>
        <translation>排除(&amp;X)</translation>
    </message>
    <message>
        <source>Leave out the value, run or target that is selected in list, plot or table (Del)</source>
        <translation>排除列表、图或表格中所选的值、趟或目标位置 (Del)</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>重新采用(&amp;G)</translation>
    </message>
    <message>
        <source>Use what is selected again</source>
        <translation>重新采用所选内容</translation>
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
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>趟次</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>统计量</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewDialog</name>
    <message>
        <source>Overview of All Axes</source>
        <translation>所有轴概览</translation>
    </message>
    <message>
        <source>All axes of all drives</source>
        <translation>所有驱动器的所有轴</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all of them, with the headings for a spreadsheet</source>
        <translation>复制所选的行或全部行，含标题，用于电子表格</translation>
    </message>
    <message>
        <source>&amp;Go to Axis</source>
        <translation>转到该轴(&amp;G)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close the overview</source>
        <translation>关闭概览</translation>
    </message>
    <message>
        <source>No axis is chosen.</source>
        <translation>没有选择轴。</translation>
    </message>
    <message>
        <source>This drive has not said yet which axes it has.</source>
        <translation>此驱动器尚未报告有哪些轴。</translation>
    </message>
    <message>
        <source>Wait for the current operation before choosing another axis.</source>
        <translation>请等待当前操作结束，再选择其他轴。</translation>
    </message>
    <message>
        <source>Show this axis on the page</source>
        <translation>在页面上显示此轴</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::OverviewModel</name>
    <message>
        <source>since %1</source>
        <comment>date and time</comment>
        <translation>自 %1 起</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file and column</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>persistent</source>
        <comment>table</comment>
        <translation>持久</translation>
    </message>
    <message>
        <source>volatile</source>
        <comment>table</comment>
        <translation>易失</translation>
    </message>
    <message>
        <source>not limited</source>
        <comment>flash operations</comment>
        <translation>不限</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>与其表矛盾</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>Flash left</source>
        <translation>剩余闪存</translation>
    </message>
    <message>
        <source>Last proof</source>
        <translation>上次验证</translation>
    </message>
    <message>
        <source>Last write</source>
        <translation>上次写入</translation>
    </message>
    <message>
        <source>The drive, and where it is</source>
        <translation>驱动器及其所在位置</translation>
    </message>
    <message>
        <source>The axis of this drive</source>
        <translation>此驱动器的轴</translation>
    </message>
    <message>
        <source>What the compensation does now</source>
        <translation>补偿目前的状态</translation>
    </message>
    <message>
        <source>The table that the axis uses: its file and column where this window has written it, otherwise its place on the drive; and the checksum of its values</source>
        <translation>该轴使用的表：由本窗口写入时为其文件和列，否则为其在驱动器上的位置；以及其值的校验和</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>重启后表是否保留</translation>
    </message>
    <message>
        <source>How many flash operations the drive can do now</source>
        <translation>驱动器目前可进行的闪存操作次数</translation>
    </message>
    <message>
        <source>Over which part of the table this window has seen that the drive does what the table says, and when</source>
        <translation>本窗口何时、在表的哪一部分上确认驱动器与表一致</translation>
    </message>
    <message>
        <source>When this computer last wrote to the axis</source>
        <translation>本计算机上次写入该轴的时间</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>no axes</source>
        <translation>无轴</translation>
    </message>
    <message>
        <source>no compensation</source>
        <translation>无补偿</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>is being read …</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <comment>address of a drive</comment>
        <translation>%1，序列号 %2</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>The accuracy of the axis with this table and before, as the records of this computer have it</source>
        <translation>使用此表时及此前该轴的定位精度，取自本计算机的档案</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>机床文件</translation>
    </message>
    <message>
        <source>Whether the axis has what the machine file says, and when it was compared</source>
        <translation>该轴是否与机床文件一致，以及比较的时间</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;System Language</source>
        <translation>系统语言(&amp;S)</translation>
    </message>
    <message>
        <source>Show &amp;Preview Before Volatile Writes</source>
        <translation>易失写入前显示预览(&amp;P)</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview</source>
        <translation>持久写入总是显示预览</translation>
    </message>
    <message>
        <source>Save Lo&amp;g…</source>
        <translation>保存日志(&amp;G)…</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>关于(&amp;A)</translation>
    </message>
    <message>
        <source>About</source>
        <translation>关于</translation>
    </message>
    <message>
        <source>&lt;b&gt;Axis Compensation Wizard&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;轴补偿向导&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>Writes error compensation tables to servo drives, activates them and proves that the drive applies them.

A compensation value is reference minus encoder; the drive adds it to the encoder position.

Free software under the GNU General Public License, version 3 or later.</source>
        <translation>将误差补偿表写入伺服驱动器，启用补偿，并验证驱动器确实应用了补偿表。

补偿值为基准减编码器；驱动器将其叠加到编码器位置。

本软件为自由软件，采用 GNU 通用公共许可证第 3 版或更新版本。</translation>
    </message>
    <message>
        <source>Save the selected table as a file for another controller</source>
        <translation>将所选的表保存为其他控制器的文件</translation>
    </message>
    <message>
        <source>No table is selected.</source>
        <translation>没有选择表。</translation>
    </message>
    <message>
        <source>&amp;Export for Another Controller…</source>
        <translation>导出到其他控制器(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Write Several Axes…</source>
        <translation>多轴写入(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Import TAM Configuration…</source>
        <translation>导入 TAM 配置(&amp;I)…</translation>
    </message>
    <message>
        <source>Export to &amp;TAM Configuration…</source>
        <translation>导出到 TAM 配置(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销：%1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做：%1(&amp;R)</translation>
    </message>
    <message>
        <source>Takes the last change of the fields back; the drive is not reached</source>
        <translation>撤销字段的上一次更改；不涉及驱动器</translation>
    </message>
    <message>
        <source>Makes the change that was undone again</source>
        <translation>重新进行已撤销的更改</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>User &amp;Guide</source>
        <translation>用户手册(&amp;G)</translation>
    </message>
    <message>
        <source>Ba&amp;ck Up Whole Drive…</source>
        <translation>备份整台驱动器(&amp;C)…</translation>
    </message>
    <message>
        <source>Restore Whole &amp;Drive…</source>
        <translation>还原整台驱动器(&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;Overview of All Axes…</source>
        <translation>所有轴概览(&amp;O)…</translation>
    </message>
    <message>
        <source>State and table of each axis of all connected drives</source>
        <translation>所有已连接驱动器的各轴的状态和表</translation>
    </message>
    <message>
        <source>No machine file is open.</source>
        <translation>没有打开的机床文件。</translation>
    </message>
    <message>
        <source>Read the machine file again and compare all drives with it</source>
        <translation>重新读取机床文件，并将所有驱动器与之比较</translation>
    </message>
    <message>
        <source>The drives are being compared.</source>
        <translation>正在比较驱动器。</translation>
    </message>
    <message>
        <source>Show what would be written to all drives, before anything is written</source>
        <translation>在写入任何内容之前，显示将写入各驱动器的内容</translation>
    </message>
    <message>
        <source>The drives stay connected; nothing is changed</source>
        <translation>驱动器保持连接；不作任何更改</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>机床(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Open Machine File…</source>
        <translation>打开机床文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Compare all drives of a machine with the file that says which tables they have</source>
        <translation>将机床的所有驱动器与说明其所用各表的文件比较</translation>
    </message>
    <message>
        <source>&amp;Plan Again</source>
        <translation>重新制定计划(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>应用(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Save Machine File…</source>
        <translation>保存机床文件(&amp;S)…</translation>
    </message>
    <message>
        <source>Running drives as a machine file with all tables, in a folder of your choice</source>
        <translation>将运行中的驱动器存为机床文件，含所有表，存入您选择的文件夹</translation>
    </message>
    <message>
        <source>&amp;Close Machine File</source>
        <translation>关闭机床文件(&amp;C)</translation>
    </message>
    <message>
        <source>Documentation in the &amp;Browser</source>
        <translation>在浏览器中打开文档(&amp;B)</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>No browser could be opened. The documentation is in %1.</source>
        <translation>无法打开浏览器。文档位于 %1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PageTabs</name>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>The files of a measurement, and how they are read</source>
        <translation>测量的文件及其读取方式</translation>
    </message>
    <message>
        <source>Bring a table to the drive, and activate it</source>
        <translation>将表写入驱动器并启用</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
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
        <translation>工作步骤</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Page Up and Ctrl+Page Down change the tab)</source>
        <translation>%1（Ctrl+Page Up 和 Ctrl+Page Down 切换页面）</translation>
    </message>
    <message>
        <source>Judge</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>What the measurement says of the axis, against tolerances</source>
        <translation>对照公差，评定测量所反映的轴精度</translation>
    </message>
    <message>
        <source>Prove</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Measure again with the table active, and see what it has brought</source>
        <translation>启用该表重新测量，查看其效果</translation>
    </message>
    <message>
        <source>The table that is made of a measurement, and what it promises</source>
        <translation>由测量生成的表及其预期效果</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ParameterExport</name>
    <message>
        <source>Wrote %1: only compensation registers have changed.</source>
        <translation>已写出 %1：只有补偿寄存器改变。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanDialog</name>
    <message>
        <source>New Program</source>
        <translation>新建程序</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>个数</translation>
    </message>
    <message>
        <source>Mean spacing</source>
        <translation>平均间距</translation>
    </message>
    <message>
        <source>Cont&amp;rol</source>
        <translation>数控系统(&amp;R)</translation>
    </message>
    <message>
        <source>The control of the machine, which plays the program</source>
        <translation>执行程序的机床数控系统</translation>
    </message>
    <message>
        <source>Save Pro&amp;gram…</source>
        <translation>保存程序(&amp;G)…</translation>
    </message>
    <message>
        <source>Save &amp;Plan…</source>
        <translation>保存测量计划(&amp;P)…</translation>
    </message>
    <message>
        <source>Clo&amp;se</source>
        <translation>关闭(&amp;S)</translation>
    </message>
    <message>
        <source>What was not saved is lost (Esc)</source>
        <translation>未保存的内容将丢失 (Esc)</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>轴(&amp;X)</translation>
    </message>
    <message>
        <source>As the drive or the control names it</source>
        <translation>按驱动器或数控系统中的名称</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>单位(&amp;U)</translation>
    </message>
    <message>
        <source>Of all positions of the plan</source>
        <translation>测量计划中所有位置的单位</translation>
    </message>
    <message>
        <source>&amp;First target</source>
        <translation>首目标位置(&amp;F)</translation>
    </message>
    <message>
        <source>Measured in every run</source>
        <translation>每一趟都测量</translation>
    </message>
    <message>
        <source>&amp;Last target</source>
        <translation>末目标位置(&amp;L)</translation>
    </message>
    <message>
        <source>Measured in every run; above the first</source>
        <translation>每一趟都测量；大于首目标位置</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>目标位置(&amp;T)</translation>
    </message>
    <message>
        <source>How many, or how far apart in the mean</source>
        <translation>个数，或平均间距</translation>
    </message>
    <message>
        <source>&amp;Known period</source>
        <translation>已知周期(&amp;K)</translation>
    </message>
    <message>
        <source>Of the axis&apos;s error, such as the lead of its screw: targets are spread over it</source>
        <translation>轴误差的周期，例如丝杠导程：目标位置将分布在周期的各处</translation>
    </message>
    <message>
        <source>&amp;Cycles</source>
        <translation>循环(&amp;C)</translation>
    </message>
    <message>
        <source>Runs in each direction; the standard wants five</source>
        <translation>每个方向的趟数；标准要求五趟</translation>
    </message>
    <message>
        <source>&amp;Overrun</source>
        <translation>越程(&amp;O)</translation>
    </message>
    <message>
        <source>How far the axis moves in the direction of a run before its first target</source>
        <translation>轴在一趟的首目标位置之前沿该趟方向移动的距离</translation>
    </message>
    <message>
        <source>F&amp;eed</source>
        <translation>进给速度(&amp;E)</translation>
    </message>
    <message>
        <source>Of the moves in the program</source>
        <translation>程序中各移动的进给速度</translation>
    </message>
    <message>
        <source>D&amp;well</source>
        <translation>停留时间(&amp;W)</translation>
    </message>
    <message>
        <source>How long the axis stands at each target, to be measured</source>
        <translation>轴在每个目标位置停留以供测量的时间</translation>
    </message>
    <message>
        <source>Ran&amp;dom seed</source>
        <translation>随机种子(&amp;D)</translation>
    </message>
    <message>
        <source>Another number gives other targets, the same number the same</source>
        <translation>不同的数字得到不同的目标位置，相同的数字得到相同的</translation>
    </message>
    <message>
        <source>Given b&amp;y</source>
        <translation>给定方式(&amp;Y)</translation>
    </message>
    <message>
        <source>Whether targets are counted, or their distance is given</source>
        <translation>给出目标位置的个数，还是给出其间距</translation>
    </message>
    <message>
        <source>Number of targets</source>
        <translation>目标位置的个数</translation>
    </message>
    <message>
        <source>Mean spacing of targets</source>
        <translation>目标位置的平均间距</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>by the range</source>
        <translation>按范围</translation>
    </message>
    <message>
        <source>%1. The axis moves from %2 to %3: check that this way is free.</source>
        <translation>%1。轴将从 %2 移到 %3：请检查该路径上没有障碍。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>This program never moves an axis: the control of the machine plays the program, or a person moves from target to target.</source>
        <translation>本程序从不移动轴：由机床数控系统执行程序，或由人员逐个移到目标位置。</translation>
    </message>
    <message>
        <source>For Capture, which takes the values by it</source>
        <translation>供“采集”使用，按其采集各值</translation>
    </message>
    <message>
        <source>G-code for the control of the machine</source>
        <translation>机床数控系统的 G 代码</translation>
    </message>
    <message>
        <source>Save Program</source>
        <translation>保存程序</translation>
    </message>
    <message>
        <source>Save Plan</source>
        <translation>保存测量计划</translation>
    </message>
    <message>
        <source>Programs (*%1);;All files (*)</source>
        <translation>程序 (*%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Plans (*.csv);;All files (*)</source>
        <translation>测量计划 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>已保存为 %1。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PlanStepsModel</name>
    <message>
        <source>step %1, %2, target %3</source>
        <translation>第 %1 步，%2，目标位置 %3</translation>
    </message>
    <message>
        <source>due</source>
        <translation>待测</translation>
    </message>
    <message>
        <source>not taken yet</source>
        <translation>尚未取值</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>趟次</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>来自</translation>
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
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>间距</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::PreviewPanel</name>
    <message>
        <source>Save Exa&amp;mple…</source>
        <translation>保存示例(&amp;M)…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Save a small %1D calibration file as an example</source>
        <translation>将一个小的 %1D 校准文件保存为示例</translation>
    </message>
    <message>
        <source>%1 bytes, more than any slot of the drive holds</source>
        <translation>%1 字节，超过驱动器任何表槽的容量</translation>
    </message>
    <message>
        <source>%1 of %2 bytes of a table slot</source>
        <translation>%1 字节，表槽容量为 %2 字节</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>问题 (%1)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
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
        <translation>所有切片</translation>
    </message>
    <message>
        <source>Two axes</source>
        <translation>两轴</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemList</name>
    <message>
        <source>Problems of the file</source>
        <translation>文件的问题</translation>
    </message>
    <message>
        <source>%1 cannot be used; the previous selection is kept.</source>
        <translation>%1 无法使用；保留先前的选择。</translation>
    </message>
    <message>
        <source>%1 is used, with these warnings.</source>
        <translation>%1 已采用，但有以下警告。</translation>
    </message>
    <message>
        <source>Further problems: %1.</source>
        <translation>其他问题：%1。</translation>
    </message>
    <message>
        <source>Click a problem, or press Enter, to see the file&apos;s line.</source>
        <translation>单击一个问题或按 Enter 键，可查看文件中的该行。</translation>
    </message>
    <message>
        <source>&amp;Use %1D</source>
        <translation>采用 %1D(&amp;U)</translation>
    </message>
    <message>
        <source>Sets the dimensionality to %1D and reads the file again.</source>
        <translation>将维数设为 %1D，并重新读取文件。</translation>
    </message>
    <message>
        <source>%1 cannot be used.</source>
        <translation>%1 无法使用。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProblemModel</name>
    <message>
        <source>error, line %1</source>
        <translation>错误，第 %1 行</translation>
    </message>
    <message>
        <source>warning, line %1</source>
        <translation>警告，第 %1 行</translation>
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
        <translation>问题</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ProvePage</name>
    <message>
        <source>%1 %2 (tolerance %3)</source>
        <translation>%1 %2（公差 %3）</translation>
    </message>
    <message>
        <source>%1 not defined (tolerance %2)</source>
        <translation>%1 无定义（公差 %2）</translation>
    </message>
    <message>
        <source>Not within the tolerances: %1.</source>
        <translation>不在公差之内：%1。</translation>
    </message>
    <message>
        <source>Not judged by: %1.</source>
        <translation>无法评定：%1。</translation>
    </message>
    <message>
        <source>Undecided, since the uncertainty is too large: %1.</source>
        <translation>因不确定度过大而无法判定：%1。</translation>
    </message>
    <message>
        <source>The machine is not as good as was predicted.</source>
        <translation>机床没有达到预测的水平。</translation>
    </message>
    <message>
        <source>The machine is no better than before.</source>
        <translation>机床不比补偿前好。</translation>
    </message>
    <message>
        <source>The two are corrected differently for temperature or dead path, so that they cannot be compared.</source>
        <translation>两者的温度修正或死程修正不同，因此不能比较。</translation>
    </message>
    <message>
        <source>No tolerance is given, so there is no verdict.</source>
        <translation>没有给出公差，因此没有判定。</translation>
    </message>
    <message>
        <source>Within the tolerances.</source>
        <translation>在公差之内。</translation>
    </message>
    <message>
        <source>Within the tolerances (uncertainty not stated).</source>
        <translation>在公差之内（未注明不确定度）。</translation>
    </message>
    <message>
        <source>Second measurement</source>
        <translation>第二次测量</translation>
    </message>
    <message>
        <source>Files of the second measurement</source>
        <translation>第二次测量的文件</translation>
    </message>
    <message>
        <source>Kee&amp;p in the Record</source>
        <translation>记入档案(&amp;P)</translation>
    </message>
    <message>
        <source>The second measurement, what it says of the prediction, and the verdict</source>
        <translation>第二次测量、其与预测的对照，以及判定</translation>
    </message>
    <message>
        <source>For a file that does not say which table was active</source>
        <translation>用于文件没有注明启用了哪个表时</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>补偿前和补偿后</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>残余误差</translation>
    </message>
    <message>
        <source>Figures before, predicted, held out and after</source>
        <translation>补偿前、预测、留出和补偿后的指标</translation>
    </message>
    <message>
        <source>What is left at the targets</source>
        <translation>目标位置上的残余误差</translation>
    </message>
    <message>
        <source>The tabl&amp;e %1 was active</source>
        <translation>当时启用的是表 %1(&amp;E)</translation>
    </message>
    <message>
        <source>What to look at: %1</source>
        <translation>应检查：%1</translation>
    </message>
    <message>
        <source>Nothing was predicted between the targets: before and after are compared alone.</source>
        <translation>目标位置之间没有预测：只比较补偿前和补偿后。</translation>
    </message>
    <message>
        <source>No table of this record is in use: a second measurement is compared with that of Measure alone. Open a record with a table to prove that one.</source>
        <translation>此档案没有使用中的表：第二次测量只与“测量”中的测量比较。要验证一个表，请打开含该表的档案。</translation>
    </message>
    <message>
        <source>Write the table and activate it, measure again, and add the files of that measurement here.</source>
        <translation>请写入并启用该表，重新测量，然后在此处添加该测量的文件。</translation>
    </message>
    <message>
        <source>Measure again with the table active, and add the files of that measurement here.</source>
        <translation>请启用该表重新测量，然后在此处添加该测量的文件。</translation>
    </message>
    <message>
        <source>The measurement is in the record: save that, and write the report.</source>
        <translation>该测量已在档案中：请保存档案，并生成报告。</translation>
    </message>
    <message>
        <source>Keep it in the record.</source>
        <translation>请将其记入档案。</translation>
    </message>
    <message>
        <source>The files are being read …</source>
        <translation>正在读取文件…</translation>
    </message>
    <message>
        <source>The second measurement does not say which table was active. If it was the table %1, say so above; otherwise measure again with it.</source>
        <translation>第二次测量没有注明启用了哪个表。如果是表 %1，请在上方注明；否则请启用该表重新测量。</translation>
    </message>
    <message>
        <source>The measurements are being compared …</source>
        <translation>正在比较测量…</translation>
    </message>
    <message>
        <source>There is no measurement to compare it with: add that one in Measure.</source>
        <translation>没有可与之比较的测量：请在“测量”中添加。</translation>
    </message>
    <message>
        <source>The second measurement covers only part of the first one&apos;s travel.</source>
        <translation>第二次测量只覆盖第一次测量行程的一部分。</translation>
    </message>
    <message>
        <source>The measurement is in the record, and that is saved: write the report.</source>
        <translation>该测量已在档案中，档案已保存：请生成报告。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %1 is not defined after.</source>
        <translation>由于补偿后 %1 无定义，无法判断是否与预测相符。</translation>
    </message>
    <message>
        <source>Not as predicted, since the machine is no better than before: %3 is %1 after and was %2 before.</source>
        <translation>与预测不符，因为机床不比补偿前好：%3 补偿后为 %1，补偿前为 %2。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since %3 is smaller than before by no more than what cannot be told: %3 is %1 after and was %2 before.</source>
        <translation>由于 %3 的减小不超过无法分辨的部分，无法判断是否与预测相符：%3 补偿后为 %1，补偿前为 %2。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since less of the axis was measured: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>由于只测量了轴的一部分，无法判断是否与预测相符：补偿后 %3 为 %1，不超过 %2 即为相符。</translation>
    </message>
    <message>
        <source>As predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>与预测相符：补偿后 %3 为 %1，不超过 %2 即为相符（留出 %3 的 1.2 倍，加上无法分辨的部分）。</translation>
    </message>
    <message>
        <source>Not as predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 held out, and what cannot be told).</source>
        <translation>与预测不符：补偿后 %3 为 %1，不超过 %2 才为相符（留出 %3 的 1.2 倍，加上无法分辨的部分）。</translation>
    </message>
    <message>
        <source>Whether it is as predicted is open, since the targets are farther apart than before: %3 is %1 after, and up to %2 is as predicted.</source>
        <translation>由于目标位置的间距比补偿前大，无法判断是否与预测相符：补偿后 %3 为 %1，不超过 %2 即为相符。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordActions</name>
    <message>
        <source>Re&amp;cord</source>
        <translation>档案(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;New Record</source>
        <translation>新建档案(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open Record…</source>
        <translation>打开档案(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save Record</source>
        <translation>保存档案(&amp;S)</translation>
    </message>
    <message>
        <source>Save Record &amp;As…</source>
        <translation>档案另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>报告(&amp;R)…</translation>
    </message>
    <message>
        <source>Records (*.axcal)</source>
        <translation>档案 (*.axcal)</translation>
    </message>
    <message>
        <source>Open Record</source>
        <translation>打开档案</translation>
    </message>
    <message>
        <source>Save Record</source>
        <translation>保存档案</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
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
        <translation>保存后新建(&amp;T)</translation>
    </message>
    <message>
        <source>Save, &amp;Then Open</source>
        <translation>保存后打开(&amp;T)</translation>
    </message>
    <message>
        <source>Begin Without Savin&amp;g</source>
        <translation>不保存并新建(&amp;G)</translation>
    </message>
    <message>
        <source>Open Without Savin&amp;g</source>
        <translation>不保存并打开(&amp;G)</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>留在此处(&amp;Y)</translation>
    </message>
    <message>
        <source>The record has never been saved.</source>
        <translation>该档案从未保存过。</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 有未保存的更改。</translation>
    </message>
    <message>
        <source>%1 is there already, and is another file.</source>
        <translation>%1 已存在，且是另一个文件。</translation>
    </message>
    <message>
        <source>%1 has been changed by another program since it was read here.</source>
        <translation>%1 在此处读取之后已被另一程序更改。</translation>
    </message>
    <message>
        <source>Overwri&amp;te</source>
        <translation>覆盖(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keep Both…</source>
        <translation>保留两者(&amp;K)…</translation>
    </message>
    <message>
        <source>The program did not end well. A record that was never saved was kept at %1.</source>
        <translation>程序上次未正常结束。一个从未保存过的档案已于 %1 保留。</translation>
    </message>
    <message>
        <source>The program did not end well. Unsaved changes of %1 were kept at %2.</source>
        <translation>程序上次未正常结束。%1 的未保存更改已于 %2 保留。</translation>
    </message>
    <message>
        <source>&amp;Take Them Up</source>
        <translation>恢复更改(&amp;T)</translation>
    </message>
    <message>
        <source>For&amp;get Them</source>
        <translation>丢弃更改(&amp;G)</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>报告已写入 %1。</translation>
    </message>
    <message>
        <source>The drive has the table; only the record does not say so: %1</source>
        <translation>驱动器已有该表，只是档案没有记载：%1</translation>
    </message>
    <message>
        <source>%1 has changed on disk. What was left out is used again; corrections, and which table was active, are to be said anew. Ctrl+Z takes that back.</source>
        <translation>%1 在磁盘上已改变。已排除的值重新使用；修正以及当时激活的表需重新说明。按 Ctrl+Z 可撤销。</translation>
    </message>
    <message>
        <source>%1 says what was written and measured of its table, and this record does not. Saving it under another name keeps both.</source>
        <translation>%1 记载了其中的表的写入和测量，而此档案没有。以其他名称保存可保留两者。</translation>
    </message>
    <message>
        <source>&amp;Take It Up</source>
        <translation>恢复档案(&amp;T)</translation>
    </message>
    <message>
        <source>For&amp;get It</source>
        <translation>丢弃档案(&amp;G)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordBar</name>
    <message>
        <source>Record:</source>
        <translation>档案：</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open a record (.axcal); it can also be dropped on the window (Ctrl+Alt+O)</source>
        <translation>打开档案 (.axcal)；也可将其拖放到窗口 (Ctrl+Alt+O)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save measurement, table, what it promised and what came of it (Ctrl+S)</source>
        <translation>保存测量、表、其预期效果和实际结果 (Ctrl+S)</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>The report of the record as PDF or HTML (Ctrl+P)</source>
        <translation>将档案生成 PDF 或 HTML 报告 (Ctrl+P)</translation>
    </message>
    <message>
        <source>Open record</source>
        <translation>打开档案</translation>
    </message>
    <message>
        <source>Save record</source>
        <translation>保存档案</translation>
    </message>
    <message>
        <source>Report of the record</source>
        <translation>档案的报告</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>It has changes that are not saved.</source>
        <translation>有未保存的更改。</translation>
    </message>
    <message>
        <source>There are no unsaved changes.</source>
        <translation>没有未保存的更改。</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>档案 %1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordFile</name>
    <message>
        <source>not saved yet</source>
        <translation>尚未保存</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RecordModel</name>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>How %1 is read</source>
        <translation>%1 的读取方式</translation>
    </message>
    <message>
        <source>Exchange up and down</source>
        <translation>对调正向和负向</translation>
    </message>
    <message>
        <source>Exclude (%1)</source>
        <translation>排除（%1）</translation>
    </message>
    <message>
        <source>Use again (%1)</source>
        <translation>重新采用（%1）</translation>
    </message>
    <message>
        <source>Rule for outliers</source>
        <translation>离群值准则</translation>
    </message>
    <message>
        <source>Tolerance of %1</source>
        <translation>%1 的公差</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Table in use</source>
        <translation>使用中的表</translation>
    </message>
    <message>
        <source>Table active while measured</source>
        <translation>测量时启用的表</translation>
    </message>
    <message>
        <source>Fit: %1</source>
        <translation>拟合：%1</translation>
    </message>
    <message>
        <source>%1 changed on disk</source>
        <translation>%1 在磁盘上已改变</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualModel</name>
    <message>
        <source>at %1: %2, standard error %3</source>
        <translation>在 %1：%2，标准误差 %3</translation>
    </message>
    <message>
        <source>at %1: %2, standard error not defined</source>
        <translation>在 %1：%2，标准误差无定义</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>残余</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>标准误差</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ResidualPlot</name>
    <message>
        <source>before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>after, with its standard error</source>
        <translation>补偿后及其标准误差</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>There is nothing to compare.</source>
        <translation>没有可比较的内容。</translation>
    </message>
    <message>
        <source>What is left lies between %1 and %2.</source>
        <translation>残余误差在 %1 与 %2 之间。</translation>
    </message>
    <message>
        <source>Mean deviation before and after</source>
        <translation>补偿前和补偿后的平均偏差</translation>
    </message>
    <message>
        <source>Dashed, with squares: before. Full line, with dots: after; the band is the standard error of the mean.</source>
        <translation>虚线和方块：补偿前。实线和圆点：补偿后；带宽为平均值的标准误差。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RestoreDriveDialog</name>
    <message>
        <source>The backup is being read.</source>
        <translation>正在读取备份。</translation>
    </message>
    <message>
        <source>The backup is of another drive: confirm it first.</source>
        <translation>该备份属于另一台驱动器：请先确认。</translation>
    </message>
    <message>
        <source>Backup of %1, serial number %2; axes: %3</source>
        <translation>%1 的备份，序列号 %2；轴：%3</translation>
    </message>
    <message>
        <source>, of %1</source>
        <comment>time</comment>
        <translation>，时间 %1</translation>
    </message>
    <message>
        <source>Tables that no axis uses, restored after the axes: %1</source>
        <translation>没有轴使用的表，在各轴之后还原：%1</translation>
    </message>
    <message>
        <source>Restore Whole Drive</source>
        <translation>还原整台驱动器</translation>
    </message>
    <message>
        <source>Brings all axes of %1 back to the backup in %2, one after the other. All writes are checked before the first one begins; each one makes a backup and is verified. No compensation is switched on.</source>
        <translation>将 %1 的所有轴依次恢复为 %2 中的备份。第一个写入开始前先检查所有写入；每个写入都会生成备份并经校验。不开启任何补偿。</translation>
    </message>
    <message>
        <source>The backup is of &amp;another drive, which this one replaces</source>
        <translation>该备份属于另一台驱动器，由此驱动器替代(&amp;A)</translation>
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
        <translation>趟次</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>斜率</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesModel</name>
    <message>
        <source>target %1 at %2</source>
        <translation>目标位置 %1，位于 %2</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>无值</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标位置</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::RunValuesView</name>
    <message>
        <source>Values of all files</source>
        <translation>所有文件的值</translation>
    </message>
    <message>
        <source>&amp;Exclude</source>
        <translation>排除(&amp;E)</translation>
    </message>
    <message>
        <source>Leave the selected values out of every figure and table; in the first column, whole targets (Del)</source>
        <translation>将所选的值排除在所有指标和表之外；在第一列中则排除整个目标位置 (Del)</translation>
    </message>
    <message>
        <source>Exclude W&amp;hole Run</source>
        <translation>排除整趟(&amp;H)</translation>
    </message>
    <message>
        <source>Leave out every value of the run of the current cell</source>
        <translation>排除当前单元格所在趟的所有值</translation>
    </message>
    <message>
        <source>Use A&amp;gain</source>
        <translation>重新采用(&amp;G)</translation>
    </message>
    <message>
        <source>Use the selected values again</source>
        <translation>重新采用所选的值</translation>
    </message>
    <message>
        <source>Too many cells are selected: at most %1 in one step. A whole target is its cell in the first column; &quot;Exclude Whole Run&quot; takes a whole run.</source>
        <translation>选择的单元格过多：一次最多 %1 个。整个目标位置只需选第一列中的单元格；整趟请用“排除整趟”。</translation>
    </message>
    <message>
        <source>Values: %1, excluded: %2 (✕). ↑ up, ↓ down.</source>
        <translation>值：%1，已排除：%2 (✕)。↑ 正向，↓ 负向。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SaveMachineDialog</name>
    <message>
        <source>Save Machine File</source>
        <translation>保存机床文件</translation>
    </message>
    <message>
        <source>Writes machine.toml and the tables of all axes into a folder. The drives are only read.</source>
        <translation>将 machine.toml 和所有轴的表写入一个文件夹。只读取驱动器。</translation>
    </message>
    <message>
        <source>&amp;Name of the machine (may be empty)</source>
        <translation>机床名称（可为空）(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Drives</source>
        <translation>驱动器(&amp;D)</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>机床名称</translation>
    </message>
    <message>
        <source>Drives of the machine</source>
        <translation>机床的驱动器</translation>
    </message>
    <message>
        <source>&amp;Replace These Files</source>
        <translation>替换这些文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save in Folder…</source>
        <translation>保存到文件夹(&amp;S)…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>返回页面 (Esc)</translation>
    </message>
    <message>
        <source>%1 (does not answer)</source>
        <comment>drive</comment>
        <translation>%1（没有应答）</translation>
    </message>
    <message>
        <source>No drive is chosen.</source>
        <translation>没有选择驱动器。</translation>
    </message>
    <message>
        <source>%1 does not answer: a machine file without one of its drives would be another machine.</source>
        <translation>%1 没有应答：缺少其中一台驱动器的机床文件将是另一台机床。</translation>
    </message>
    <message>
        <source>Wait for the end of the write.</source>
        <translation>请等待写入结束。</translation>
    </message>
    <message>
        <source>Files that are there are not replaced unasked</source>
        <translation>已有的文件不会在未经询问时被替换</translation>
    </message>
    <message>
        <source>The folder has other files of these names, which would be replaced: %1.</source>
        <translation>文件夹中有同名的其他文件，将被替换：%1。</translation>
    </message>
    <message>
        <source>Reading the drives …</source>
        <translation>正在读取驱动器…</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>Nothing is saved yet.</source>
        <translation>尚未保存任何内容。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>drive and problem</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Saved %1: drives: %2, tables: %3.</source>
        <translation>已保存 %1：驱动器：%2，表：%3。</translation>
    </message>
    <message>
        <source>Folder for the Machine File</source>
        <translation>机床文件的文件夹</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SettingFields</name>
    <message>
        <source>not given</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>default: %1</source>
        <translation>默认：%1</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>必填</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>按文件注明</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SetupHistory</name>
    <message>
        <source>Dimensionality</source>
        <translation>维数</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Dim%1 源</translation>
    </message>
    <message>
        <source>Compensation data</source>
        <translation>补偿数据</translation>
    </message>
    <message>
        <source>Several fields</source>
        <translation>多个字段</translation>
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
        <translation>持久</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>易失</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>轴(&amp;X)</translation>
    </message>
    <message>
        <source>The axis to compensate; lists all axes of all drives</source>
        <translation>要补偿的轴；列出所有驱动器的所有轴</translation>
    </message>
    <message>
        <source>The axis to compensate</source>
        <translation>要补偿的轴</translation>
    </message>
    <message>
        <source>Dimen&amp;sionality</source>
        <translation>维数(&amp;S)</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on: 1D one, 2D two, 3D three</source>
        <translation>补偿所依据的位置的个数：1D 一个，2D 两个，3D 三个</translation>
    </message>
    <message>
        <source>The number of positions that the compensation depends on</source>
        <translation>补偿所依据的位置的个数</translation>
    </message>
    <message>
        <source>Dim&amp;1 Source</source>
        <translation>Dim1 源(&amp;1)</translation>
    </message>
    <message>
        <source>Dim&amp;2 Source</source>
        <translation>Dim2 源(&amp;2)</translation>
    </message>
    <message>
        <source>Dim&amp;3 Source</source>
        <translation>Dim3 源(&amp;3)</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1: select one, or type a path, a tam:// URI or a hexadecimal address and press Enter</source>
        <translation>为维度 %1 提供位置的寄存器：选择一个，或输入路径、tam:// URI 或十六进制地址并按 Enter 键</translation>
    </message>
    <message>
        <source>The register that supplies the position for dimension %1</source>
        <translation>为维度 %1 提供位置的寄存器</translation>
    </message>
    <message>
        <source>Compensat&amp;ion data</source>
        <translation>补偿数据(&amp;I)</translation>
    </message>
    <message>
        <source>A file of positions and compensation values; needed only for a new table</source>
        <translation>位置和补偿值的文件；仅在需要新表时使用</translation>
    </message>
    <message>
        <source>A file of compensation values; needed only for a new table</source>
        <translation>补偿值的文件；仅在需要新表时使用</translation>
    </message>
    <message>
        <source>Ta&amp;ble</source>
        <translation>表(&amp;B)</translation>
    </message>
    <message>
        <source>The table for the axis: the one on the drive, or one from the file</source>
        <translation>该轴的表：驱动器上的表，或文件中的表</translation>
    </message>
    <message>
        <source>The table for the axis</source>
        <translation>该轴的表</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>Persistent: stored in the drive&apos;s flash and kept over a reboot. Volatile: lost on a reboot. Applies to the table on the drive as well</source>
        <translation>持久：存入驱动器的闪存，重启后保留。易失：重启后丢失。对驱动器上的表同样适用</translation>
    </message>
    <message>
        <source>Whether the table survives a reboot</source>
        <translation>重启后表是否保留</translation>
    </message>
    <message>
        <source>Make &amp;persistent</source>
        <translation>设为持久(&amp;P)</translation>
    </message>
    <message>
        <source>no axis</source>
        <translation>无轴</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>已回原点</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>未回原点</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>序列号 %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>homed, serial number</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1, positions in %2, %3</source>
        <translation>%1，位置以 %2 为单位，%3</translation>
    </message>
    <message>
        <source>select or type a register</source>
        <translation>选择或输入寄存器</translation>
    </message>
    <message>
        <source>now %1</source>
        <comment>value</comment>
        <translation>现为 %1</translation>
    </message>
    <message>
        <source>one source, one column of positions</source>
        <translation>一个源，一列位置</translation>
    </message>
    <message>
        <source>two sources, two columns of positions</source>
        <translation>两个源，两列位置</translation>
    </message>
    <message>
        <source>three sources, three columns of positions</source>
        <translation>三个源，三列位置</translation>
    </message>
    <message>
        <source>On the drive: %1</source>
        <translation>驱动器上：%1</translation>
    </message>
    <message>
        <source>none on the drive</source>
        <translation>驱动器上没有表</translation>
    </message>
    <message>
        <source>Parsed: %1</source>
        <translation>取自文件：%1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>取自 %1</translation>
    </message>
    <message>
        <source>open a file to get a table</source>
        <translation>打开文件以取得表</translation>
    </message>
    <message>
        <source>%1 is not used, problems: %2</source>
        <translation>不采用 %1，问题：%2</translation>
    </message>
    <message>
        <source>CSV; needed only for a new table</source>
        <translation>CSV；仅在需要新表时使用</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>tables: %1, points: %2</source>
        <translation>表：%1，点：%2</translation>
    </message>
    <message>
        <source>in flash</source>
        <translation>在闪存中</translation>
    </message>
    <message>
        <source>lost on a reboot</source>
        <translation>重启后丢失</translation>
    </message>
    <message>
        <source>; %1 of %2 flash operations available now</source>
        <comment>of the flash</comment>
        <translation>；目前可用 %2 次闪存操作中的 %1 次</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>未设置</translation>
    </message>
    <message>
        <source>unknown register %1</source>
        <translation>未知的寄存器 %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>%1, %2 points</source>
        <translation>%1，%2 点</translation>
    </message>
    <message>
        <source>%1, empty</source>
        <comment>table slot</comment>
        <translation>%1，空</translation>
    </message>
    <message>
        <source>; %1 of typically %2 flash cycles used</source>
        <comment>of the flash</comment>
        <translation>；典型 %2 次闪存擦写中已用 %1 次</translation>
    </message>
    <message>
        <source>; read as %1, converted</source>
        <translation>；按 %1 读取，已换算</translation>
    </message>
    <message>
        <source>from %1; the drive has it already</source>
        <translation>取自 %1；驱动器已有该表</translation>
    </message>
    <message>
        <source>Fitted: %1</source>
        <translation>拟合：%1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SeveralWritesDialog</name>
    <message>
        <source>What will be written</source>
        <translation>将写入的内容</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>&amp;Write All</source>
        <translation>全部写入(&amp;W)</translation>
    </message>
    <message>
        <source>Write these to the drive now</source>
        <translation>现在将这些内容写入驱动器</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>请先确认较大的修正量</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Stops the writes; the current one is rolled back (Esc)</source>
        <translation>停止写入；当前写入将回滚 (Esc)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Go back to the page (Esc)</source>
        <translation>返回页面 (Esc)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>不作任何更改并返回 (Esc)</translation>
    </message>
    <message>
        <source>Asking the drive what would change …</source>
        <translation>正在查询驱动器上将产生的变化…</translation>
    </message>
    <message>
        <source>The drive already has all of this.</source>
        <translation>驱动器已与此完全一致。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SignSentence</name>
    <message>
        <source>all values are 0: the drive will add nothing</source>
        <translation>所有值均为 0：驱动器不叠加任何值</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the reference reads %2: the drive will add %3</source>
        <translation>编码器读数为 %1 处，基准读数为 %2：驱动器将叠加 %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>在 %1，%2</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 more than the encoder: the drive will add %3</source>
        <translation>在 %1，基准读数比编码器大 %2：驱动器将叠加 %3</translation>
    </message>
    <message>
        <source>at %1 the reference reads %2 less than the encoder: the drive will add %3</source>
        <translation>在 %1，基准读数比编码器小 %2：驱动器将叠加 %3</translation>
    </message>
    <message>
        <source>at the set position %1 the drive will add %2</source>
        <translation>在给定位置 %1 处，驱动器将叠加 %2</translation>
    </message>
    <message>
        <source>where the encoder reads %1, the drive will add %2</source>
        <translation>编码器读数为 %1 处，驱动器将叠加 %2</translation>
    </message>
    <message>
        <source>at %1 the drive will add %2</source>
        <translation>在 %1 处，驱动器将叠加 %2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceGallery</name>
    <message>
        <source>Slices of the table</source>
        <translation>表的切片</translation>
    </message>
    <message>
        <source>Enter shows the slice as a picture</source>
        <translation>按 Enter 键将切片显示为图</translation>
    </message>
    <message>
        <source>colours from %1 to %2</source>
        <translation>颜色从 %1 到 %2</translation>
    </message>
    <message>
        <source>%1 of %2 slices · %3</source>
        <translation>%2 个切片中的 %1 个 · %3</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SliceRow</name>
    <message>
        <source>Slice at</source>
        <translation>切片位于</translation>
    </message>
    <message>
        <source>The slice that is shown</source>
        <translation>所显示的切片</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>The dimension that is held constant; the other two are shown</source>
        <translation>保持不变的维度；显示另外两个维度</translation>
    </message>
    <message>
        <source>Sliced dimension</source>
        <translation>切片维度</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SourceCheck</name>
    <message>
        <source>The drive is not connected: the source cannot be checked.</source>
        <translation>驱动器未连接：无法检查该源。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StateField</name>
    <message>
        <source>OFF</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>EVALUATING</source>
        <translation>试算</translation>
    </message>
    <message>
        <source>RAMPING</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Output %1 · Index %2</source>
        <translation>输出 %1 · 索引 %2</translation>
    </message>
    <message>
        <source>The state of the compensation of this axis</source>
        <translation>此轴的补偿状态</translation>
    </message>
    <message>
        <source>Live values of the drive: the compensation output and the table index</source>
        <translation>驱动器的实时值：补偿输出和表索引</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>自 %1 起</translation>
    </message>
    <message>
        <source>since before %1</source>
        <translation>%1 之前已如此</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>%1, CRC %2</source>
        <comment>table and checksum</comment>
        <translation>%1，CRC %2</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>as read at %1</source>
        <translation>读取于 %1</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>在表外：保持端值</translation>
    </message>
    <message>
        <source>contradicts its table</source>
        <translation>与其表矛盾</translation>
    </message>
    <message>
        <source>not proved yet</source>
        <translation>尚未验证</translation>
    </message>
    <message>
        <source>proved over %1 of the table</source>
        <translation>已在表的 %1 上验证</translation>
    </message>
    <message>
        <source>Compensation: %1</source>
        <comment>state</comment>
        <translation>补偿：%1</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StationChoice</name>
    <message>
        <source>The file is being read.</source>
        <translation>正在读取文件。</translation>
    </message>
    <message>
        <source>The file has no station.</source>
        <translation>文件中没有站。</translation>
    </message>
    <message>
        <source>Select the station that is this drive.</source>
        <translation>请选择与此驱动器对应的站。</translation>
    </message>
    <message>
        <source>Confirm first that the station is meant.</source>
        <translation>请先确认所指的就是该站。</translation>
    </message>
    <message>
        <source>%1 has the serial number %2, the drive %3 has %4.</source>
        <translation>%1 的序列号为 %2，驱动器 %3 的序列号为 %4。</translation>
    </message>
    <message>
        <source>Stat&amp;ion</source>
        <translation>站(&amp;I)</translation>
    </message>
    <message>
        <source>not selected</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>The drive in the configuration whose parameters are meant</source>
        <translation>配置中所指参数所属的驱动器</translation>
    </message>
    <message>
        <source>These &amp;parameters are for this drive although the serial numbers differ</source>
        <translation>尽管序列号不同，这些参数确用于此驱动器(&amp;P)</translation>
    </message>
    <message>
        <source>The &amp;parameters of this drive are for this station although the serial numbers differ</source>
        <translation>尽管序列号不同，此驱动器的参数确用于该站(&amp;P)</translation>
    </message>
    <message>
        <source>The wrong drive would get the compensation of another machine</source>
        <translation>否则可能使驱动器得到另一台机床的补偿</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::StatusStrip</name>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Stops the operation; a write is rolled back (Esc)</source>
        <translation>停止操作；写入将回滚 (Esc)</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>日志(&amp;L)</translation>
    </message>
    <message>
        <source>Show the log (Ctrl+L)</source>
        <translation>显示日志 (Ctrl+L)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::SurfaceView</name>
    <message>
        <source>Heights</source>
        <translation>高度放大</translation>
    </message>
    <message>
        <source>How many times too high the errors are drawn, compared with the axes (+ and -)</source>
        <translation>与各轴相比，误差在图中放大的倍数（+ 和 -）</translation>
    </message>
    <message>
        <source>First view</source>
        <translation>初始视图</translation>
    </message>
    <message>
        <source>Surface of the table</source>
        <translation>表的曲面</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>heights × %1</source>
        <translation>高度放大 × %1</translation>
    </message>
    <message>
        <source>See the surface as at first (Home or a double click). Arrow keys and dragging turn it, the wheel, Page Up and Page Down zoom.</source>
        <translation>恢复曲面的初始视图（Home 键或双击）。方向键和拖动可旋转，滚轮、Page Up 和 Page Down 缩放。</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>保存为 PNG、SVG 或 PDF</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>没有可保存的表。</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>The units of the table have no common scale; the heights are drawn as they fit</source>
        <translation>表的各单位没有共同比例；高度按合适的大小绘制</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableContentCombo</name>
    <message>
        <source>Selected table</source>
        <translation>所选的表</translation>
    </message>
    <message>
        <source>Table on the drive</source>
        <translation>驱动器上的表</translation>
    </message>
    <message>
        <source>Selected - drive</source>
        <translation>所选 - 驱动器</translation>
    </message>
    <message>
        <source>Which values are shown</source>
        <translation>显示哪些值</translation>
    </message>
    <message>
        <source>Values shown</source>
        <translation>显示的值</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TablePlot</name>
    <message>
        <source>C&amp;ursors</source>
        <translation>光标(&amp;U)</translation>
    </message>
    <message>
        <source>Two cursors and their difference. Arrow keys move the cursor, Space changes between A and B, a click sets it.</source>
        <translation>两个光标及其差值。方向键移动光标，空格键在 A 和 B 之间切换，单击设定光标位置。</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>驱动器上</translation>
    </message>
    <message>
        <source>Picture of the table</source>
        <translation>表的图</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>全图(&amp;H)</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>A: %1     B: %2
B - A: %3</source>
        <translation>A: %1     B: %2
B - A: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>What is drawn over the map</source>
        <translation>在色图上绘制的内容</translation>
    </message>
    <message>
        <source>&amp;Grid points</source>
        <translation>网格点(&amp;G)</translation>
    </message>
    <message>
        <source>The points of the table, where they are far enough apart</source>
        <translation>表的各点，在间隔足够大时显示</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>等值线(&amp;C)</translation>
    </message>
    <message>
        <source>Lines of equal value</source>
        <translation>值相等的线</translation>
    </message>
    <message>
        <source>Cross-&amp;sections</source>
        <translation>剖面(&amp;S)</translation>
    </message>
    <message>
        <source>The values along both axes through the cross-hair or the cursor, or else through the position of the axis</source>
        <translation>沿两个轴的值，通过十字线或光标，否则通过轴的当前位置</translation>
    </message>
    <message>
        <source>outside the table: end value held</source>
        <translation>在表外：保持端值</translation>
    </message>
    <message>
        <source>The file name must end in .png, .svg, .pdf or .csv.</source>
        <translation>文件名必须以 .png、.svg、.pdf 或 .csv 结尾。</translation>
    </message>
    <message>
        <source>There is no table to save.</source>
        <translation>没有可保存的表。</translation>
    </message>
    <message>
        <source>map</source>
        <translation>色图</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Show the whole table again (Home or a double click). The wheel and + and - zoom, Shift and drag zooms into a rectangle, dragging moves.</source>
        <translation>重新显示整个表（Home 键或双击）。滚轮及 + 和 - 缩放，按住 Shift 拖动可放大一个矩形区域，拖动平移。</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF, or the values shown as CSV</source>
        <translation>保存为 PNG、SVG 或 PDF，或将显示的值保存为 CSV</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>end value held</source>
        <translation>保持端值</translation>
    </message>
    <message>
        <source>A difference is no table for a drive: it can be saved as a picture only.</source>
        <translation>差值不是驱动器的表：只能保存为图片。</translation>
    </message>
    <message>
        <source>These are values of another controller: Export for Another Controller writes its file.</source>
        <translation>这是其他控制器的值：请用“导出到其他控制器”写入其文件。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableSelection</name>
    <message>
        <source>%1 has been read: %2 points, tables: %3.</source>
        <translation>已读取 %1：%2 点，表：%3。</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2 problems.</source>
        <translation>%1 无法使用：%2 个问题。</translation>
    </message>
    <message>
        <source>%1 is used as the table: %2 points, tables: %3.</source>
        <translation>%1 已用作表：%2 点，表：%3。</translation>
    </message>
    <message>
        <source>%1 cannot be used as it is. %2</source>
        <translation>%1 无法直接使用。%2</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TableViewModel</name>
    <message>
        <source>No table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>%1, step %2 · min %3, max %4, rms %5</source>
        <translation>%1，间距 %2 · 最小 %3，最大 %4，均方根 %5</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>补偿</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::TargetFiguresModel</name>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Values ↑</source>
        <translation>值 ↑</translation>
    </message>
    <message>
        <source>Mean ↑</source>
        <translation>平均值 ↑</translation>
    </message>
    <message>
        <source>Values ↓</source>
        <translation>值 ↓</translation>
    </message>
    <message>
        <source>Mean ↓</source>
        <translation>平均值 ↓</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::UnsavedChangesGuard</name>
    <message>
        <source>Discard and Chan&amp;ge Axis</source>
        <translation>放弃更改并切换轴(&amp;G)</translation>
    </message>
    <message>
        <source>Discard and Chan&amp;ge Connections</source>
        <translation>放弃更改并切换连接(&amp;G)</translation>
    </message>
    <message>
        <source>Close Without Writin&amp;g</source>
        <translation>不写入并关闭(&amp;G)</translation>
    </message>
    <message>
        <source>A write is in progress. Stopping rolls it back first.</source>
        <translation>写入正在进行。停止时会先回滚。</translation>
    </message>
    <message>
        <source>&amp;Stop and Close</source>
        <translation>停止并关闭(&amp;S)</translation>
    </message>
    <message>
        <source>Close When Don&amp;e</source>
        <translation>完成后关闭(&amp;E)</translation>
    </message>
    <message>
        <source>Sta&amp;y</source>
        <translation>留在此处(&amp;Y)</translation>
    </message>
    <message>
        <source>%1 has changes that are not written to the drive.</source>
        <translation>%1 有未写入驱动器的更改。</translation>
    </message>
    <message>
        <source>Save Record, &amp;Then Close</source>
        <translation>保存档案后关闭(&amp;T)</translation>
    </message>
    <message>
        <source>Close Without Savin&amp;g</source>
        <translation>不保存并关闭(&amp;G)</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesModel</name>
    <message>
        <source>Index %1</source>
        <translation>索引 %1</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>compensation</source>
        <translation>补偿</translation>
    </message>
    <message>
        <source>on the drive</source>
        <translation>驱动器上</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::ValuesView</name>
    <message>
        <source>Values of the table</source>
        <translation>表的值</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy With Positions</source>
        <translation>连同位置复制</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Copy the selected values, or all of them, with their positions for a spreadsheet. Ctrl+C copies the selected values alone.</source>
        <translation>复制所选的值或全部值及其位置，用于电子表格。Ctrl+C 只复制所选的值。</translation>
    </message>
    <message>
        <source>Copy values</source>
        <translation>复制值</translation>
    </message>
    <message>
        <source>%1 across, %2 down, %3</source>
        <translation>横向 %1，纵向 %2，%3</translation>
    </message>
    <message>
        <source>Copied cells: %1</source>
        <translation>已复制单元格：%1</translation>
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
        <translation>误差放大</translation>
    </message>
    <message>
        <source>How many times too large errors are drawn (+ and -)</source>
        <translation>误差在图中放大的倍数（+ 和 -）</translation>
    </message>
    <message>
        <source>W&amp;hole view</source>
        <translation>全图(&amp;H)</translation>
    </message>
    <message>
        <source>Show the whole grid again (Home or a double click). The wheel, Page Up and Page Down zoom, dragging and the arrow keys move.</source>
        <translation>重新显示整个网格（Home 键或双击）。滚轮、Page Up 和 Page Down 缩放，拖动和方向键平移。</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Save as PNG, SVG or PDF</source>
        <translation>保存为 PNG、SVG 或 PDF</translation>
    </message>
    <message>
        <source>Grid with the errors of two axes</source>
        <translation>含两个轴误差的网格</translation>
    </message>
    <message>
        <source>The column with the errors along %1</source>
        <translation>沿 %1 方向误差所在的列</translation>
    </message>
    <message>
        <source>Thin: the grid as the encoders read it. Bold: where the axes really are, errors × %1.</source>
        <translation>细线：编码器所示的网格。粗线：各轴的真实位置，误差 × %1。</translation>
    </message>
    <message>
        <source>The file has no errors of both axes of this slice: cut another dimension.</source>
        <translation>文件中没有此切片两个轴的误差：请沿另一维度切片。</translation>
    </message>
    <message>
        <source>%1 and %2, errors × %3</source>
        <translation>%1 和 %2，误差 × %3</translation>
    </message>
    <message>
        <source>errors of two axes</source>
        <translation>两个轴的误差</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
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
        <translation>请等待当前操作结束，再选择其他轴。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WizardLog</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详细信息</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::WritePreview</name>
    <message>
        <source>persistent</source>
        <translation>持久</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>易失</translation>
    </message>
    <message>
        <source>Nothing on the drive has changed yet. The old table and settings are backed up first.</source>
        <translation>驱动器上尚未作任何更改。旧的表和设置会先备份。</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>字段</translation>
    </message>
    <message>
        <source>On the drive</source>
        <translation>驱动器上</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>将写入的内容</translation>
    </message>
    <message>
        <source>Do not show this again &amp;for volatile writes</source>
        <translation>易失写入时不再显示(&amp;F)</translation>
    </message>
    <message>
        <source>Persistent writes always show the preview; the menu turns it back on for volatile ones</source>
        <translation>持久写入总是显示预览；易失写入的预览可在菜单中重新打开</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>写入(&amp;W)</translation>
    </message>
    <message>
        <source>Write this to the drive now</source>
        <translation>现在将其写入驱动器</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>返回(&amp;K)</translation>
    </message>
    <message>
        <source>Change nothing and go back (Esc)</source>
        <translation>不作任何更改并返回 (Esc)</translation>
    </message>
    <message>
        <source>What will be written to %1</source>
        <comment>axis and drive</comment>
        <translation>将写入 %1 的内容</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Largest change</source>
        <translation>最大变化</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Dimensionality</source>
        <translation>维数</translation>
    </message>
    <message>
        <source>%1D</source>
        <translation>%1D</translation>
    </message>
    <message>
        <source>Dim%1 Source</source>
        <translation>Dim%1 源</translation>
    </message>
    <message>
        <source>Persistency</source>
        <translation>持久性</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无表</translation>
    </message>
    <message>
        <source>Uses no flash operation. Volatile: lost on a reboot.</source>
        <translation>不使用闪存操作。易失：重启后丢失。</translation>
    </message>
    <message>
        <source>Uses no flash operation: the flash already holds it.</source>
        <translation>不使用闪存操作：闪存中已有该表。</translation>
    </message>
    <message>
        <source>Flash operations: %1 used, %2 left right after.</source>
        <translation>闪存操作：使用 %1 次，随后剩余 %2 次。</translation>
    </message>
    <message>
        <source>%1 held an earlier table of this axis; the current one stays complete until the axis has switched to the new one.</source>
        <translation>%1 原为该轴先前的表；在轴切换到新表之前，当前的表保持完整。</translation>
    </message>
    <message>
        <source>not set</source>
        <comment>source</comment>
        <translation>未设置</translation>
    </message>
    <message>
        <source>none</source>
        <comment>table</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>possibly not saved</source>
        <translation>可能未保存</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>These large corrections are &amp;right: their unit has been checked</source>
        <translation>这些较大的修正量无误：已核对其单位(&amp;R)</translation>
    </message>
    <message>
        <source>Confirm the large corrections first</source>
        <translation>请先确认较大的修正量</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete this from the drive now</source>
        <translation>现在从驱动器删除</translation>
    </message>
    <message>
        <source>What will be deleted from %1</source>
        <comment>axis and drive</comment>
        <translation>将从 %1 删除的内容</translation>
    </message>
    <message>
        <source>empty</source>
        <comment>slot</comment>
        <translation>空</translation>
    </message>
    <message>
        <source>Uses no flash operation.</source>
        <translation>不使用闪存操作。</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>还原(&amp;R)</translation>
    </message>
    <message>
        <source>What will be restored on %1</source>
        <comment>axis and drive</comment>
        <translation>将在 %1 上还原的内容</translation>
    </message>
    <message>
        <source>This is what the axis had before the write of %1.</source>
        <translation>这是该轴在 %1 那次写入之前的内容。</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>This is the state in the backup file of %1.</source>
        <translation>这是 %1 的备份文件中的状态。</translation>
    </message>
</context>
<context>
    <name>axiscomp::ui::NumberBox</name>
    <message>
        <source>%1: %2</source>
        <comment>field and problem</comment>
        <translation>%1：%2</translation>
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
