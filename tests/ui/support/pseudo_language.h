// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/brackets.h"
#include "tests/ui/support/source_messages.h"

#include <QEvent>
#include <QFile>
#include <QXmlStreamWriter>

namespace axiscomp::test {

namespace pseudo_language {

inline void writeMessage(QXmlStreamWriter& xml, const Message& message)
{
    xml.writeStartElement(QStringLiteral("message"));
    if (message.isCounted)
        xml.writeAttribute(QStringLiteral("numerus"), QStringLiteral("yes"));
    xml.writeTextElement(QStringLiteral("source"), message.source);
    if (!message.comment.isEmpty())
        xml.writeTextElement(QStringLiteral("comment"), message.comment);
    xml.writeStartElement(QStringLiteral("translation"));
    if (message.isCounted)
        for (int form = 0; form < 2; ++form)
            xml.writeTextElement(QStringLiteral("numerusform"), bracketed(message.source));
    else
        xml.writeCharacters(bracketed(message.source));
    xml.writeEndElement();
    xml.writeEndElement();
}

/// The translation file of a language in which every text of the sources stands in brackets.
inline bool writeFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    QXmlStreamWriter xml(&file);
    xml.writeStartDocument();
    xml.writeDTD(QStringLiteral("<!DOCTYPE TS>"));
    xml.writeStartElement(QStringLiteral("TS"));
    xml.writeAttribute(QStringLiteral("version"), QStringLiteral("2.1"));
    xml.writeAttribute(QStringLiteral("language"), QStringLiteral("de"));
    for (const Message& message : findSourceMessages().messages) {
        xml.writeStartElement(QStringLiteral("context"));
        xml.writeTextElement(QStringLiteral("name"), message.context);
        writeMessage(xml, message);
        xml.writeEndElement();
    }
    xml.writeEndDocument();
    return true;
}

} // namespace pseudo_language

/// A language that is nothing but a translation file, made from the sources: in it every text that
/// can be translated stands in brackets, but for names, numbers and what the placeholders hold.
class PseudoLanguage {
public:
    /// The language is spoken while this object is there. Ask isValid().
    PseudoLanguage()
    {
        const QString file = m_folder.filePath(QStringLiteral("pseudo.ts"));
        const QString compiled = m_folder.filePath(QStringLiteral("pseudo.qm"));
        m_isValid = pseudo_language::writeFile(file)
            && QProcess::execute(QStringLiteral(AXISCOMP_LRELEASE),
                   {QStringLiteral("-silent"), file, QStringLiteral("-qm"), compiled})
                == 0
            && m_translator.load(compiled) && QCoreApplication::installTranslator(&m_translator);
        tellEverybody();
    }
    ~PseudoLanguage()
    {
        QCoreApplication::removeTranslator(&m_translator);
        tellEverybody();
    }
    PseudoLanguage(const PseudoLanguage&) = delete;
    PseudoLanguage& operator=(const PseudoLanguage&) = delete;

    [[nodiscard]] bool isValid() const { return m_isValid; }

private:
    static void tellEverybody()
    {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LanguageChange);
    }

    const QTemporaryDir m_folder;
    QTranslator m_translator;
    bool m_isValid = false;
};

} // namespace axiscomp::test
