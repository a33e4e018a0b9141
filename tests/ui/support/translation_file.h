// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QString>
#include <QStringList>
#include <QXmlStreamReader>

#include <vector>

namespace axiscomp::test {

/// One text of the sources and what a translation file has for it.
struct Message {
    QString context;
    QString source;
    QString comment;
    QStringList translations; ///< several for a text with a number (%n)
    bool isFinished = false;
    bool isCounted = false; ///< has forms for one and for several
    QString place; ///< "ui/page/drive_bar.cpp:89", where the file has places

    [[nodiscard]] QString id() const { return context + u'\n' + source + u'\n' + comment; }
    [[nodiscard]] QString described() const
    {
        return (place.isEmpty() ? QString() : place + QStringLiteral(": ")) + context
            + QStringLiteral(": \"") + source + u'"'
            + (comment.isEmpty() ? QString() : QStringLiteral(" (") + comment + u')');
    }
};

/// The <message> that the reader is in.
inline Message readMessage(QXmlStreamReader& xml, const QString& context)
{
    Message message;
    message.context = context;
    message.isCounted = xml.attributes().value(QStringLiteral("numerus")) == u"yes";
    while (xml.readNextStartElement()) {
        if (xml.name() == QStringLiteral("location")) {
            const auto attributes = xml.attributes();
            message.place = attributes.value(QStringLiteral("filename")).toString() + u':'
                + attributes.value(QStringLiteral("line")).toString();
            xml.skipCurrentElement();
        } else if (xml.name() == QStringLiteral("source")) {
            message.source = xml.readElementText();
        } else if (xml.name() == QStringLiteral("comment")) {
            message.comment = xml.readElementText();
        } else if (xml.name() == QStringLiteral("translation")) {
            message.isFinished = !xml.attributes().hasAttribute(QStringLiteral("type"));
            const auto add = [&message](const QString& text) {
                if (!text.trimmed().isEmpty())
                    message.translations += text.trimmed();
            };
            if (!message.isCounted)
                add(xml.readElementText());
            while (message.isCounted && xml.readNextStartElement())
                add(xml.readElementText());
        } else {
            xml.skipCurrentElement();
        }
    }
    return message;
}

/// The messages of a .ts file; none when it cannot be read.
inline std::vector<Message> readTranslationFile(const QString& path)
{
    std::vector<Message> messages;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return messages;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QStringLiteral("name"))
            context = xml.readElementText();
        else if (xml.name() == QStringLiteral("message"))
            messages.push_back(readMessage(xml, context));
    }
    return xml.hasError() ? std::vector<Message>() : messages;
}

} // namespace axiscomp::test
