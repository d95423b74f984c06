<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>MachineSentences</name>
    <message>
        <source>“%1” sets nothing; a setting is written key=value.</source>
        <translation>«%1» ничего не задаёт; настройка пишется ключ=значение.</translation>
    </message>
    <message>
        <source>There is no setting “%1”; the nearest is “%2”.</source>
        <translation>Нет настройки «%1»; ближайшая: «%2».</translation>
    </message>
    <message>
        <source>The setting “%1” cannot be “%2”; it takes %3.</source>
        <translation>Настройка «%1» не может быть «%2»; допустимо %3.</translation>
    </message>
    <message>
        <source>There is no dialect “%1”.</source>
        <translation>Нет диалекта «%1».</translation>
    </message>
</context>
<context>
    <name>dgt::studio::CertificatePage</name>
    <message>
        <source>Not verified yet.</source>
        <translation>Ещё не проверено.</translation>
    </message>
    <message>
        <source>The text was changed after this proof. Verify again.</source>
        <translation>После этой проверки текст изменён. Проверьте снова.</translation>
    </message>
    <message>
        <source>Proved: the program runs the exact path.</source>
        <translation>Доказано: программа проходит точную траекторию.</translation>
    </message>
    <message>
        <source>Not proved: the program does not run the exact path.</source>
        <translation>Не доказано: программа не проходит точную траекторию.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::DialectDialog</name>
    <message>
        <source>NC program for which control?</source>
        <translation>Для какого станка программа?</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Диалект</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Описание</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Записать</translation>
    </message>
    <message>
        <source>&amp;Own dialect file…</source>
        <translation>&amp;Свой файл диалекта…</translation>
    </message>
    <message>
        <source>A TOML file that says how a control wants its programs</source>
        <translation>Файл TOML, который говорит, какие программы принимает станок</translation>
    </message>
    <message>
        <source>Dialect file</source>
        <translation>Файл диалекта</translation>
    </message>
    <message>
        <source>Dialects (*.toml);;All files (*)</source>
        <translation>Диалекты (*.toml);;Все файлы (*)</translation>
    </message>
</context>
<context>
    <name>dgt::studio::NcBar</name>
    <message>
        <source>Choose the control…</source>
        <translation>Выбрать станок…</translation>
    </message>
    <message>
        <source>Write the program for another control (F8)</source>
        <translation>Записать программу для другого станка (F8)</translation>
    </message>
    <message>
        <source>Offset:</source>
        <translation>Смещение:</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>рассчитано</translation>
    </message>
    <message>
        <source>by the control</source>
        <translation>задаёт станок</translation>
    </message>
    <message>
        <source>Who offsets contours with W: the equidistant is written, or the contour with the words by which the control offsets it itself</source>
        <translation>Кто смещает контуры с W: записывается эквидистанта или сам контур со словами, по которым станок смещает его</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>Save the NC program as it stands (Ctrl+S)</source>
        <translation>Сохранить программу ЧПУ в том виде, как она есть (Ctrl+S)</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Save the NC program under another name</source>
        <translation>Сохранить программу ЧПУ под другим именем</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Копировать</translation>
    </message>
    <message>
        <source>Copy the whole NC program, or what is selected of it</source>
        <translation>Копировать всю программу ЧПУ или выделенное</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Печать…</translation>
    </message>
    <message>
        <source>Print the NC program</source>
        <translation>Напечатать программу ЧПУ</translation>
    </message>
    <message>
        <source>Punch…</source>
        <translation>Перфоратор…</translation>
    </message>
    <message>
        <source>Punch the NC program onto paper tape</source>
        <translation>Записать программу ЧПУ на перфоленту</translation>
    </message>
    <message>
        <source>Verifying…</source>
        <translation>Проверяется…</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Проверить</translation>
    </message>
    <message>
        <source>Prove that the text, as it stands, runs the exact path of the part: every block</source>
        <translation>Доказать, что текст в его нынешнем виде проходит точную траекторию детали: каждый кадр</translation>
    </message>
</context>
<context>
    <name>dgt::studio::NcPanel</name>
    <message>
        <source>There is no program yet.</source>
        <translation>Программы ещё нет.</translation>
    </message>
    <message>
        <source>The program has errors; there is no NC program.</source>
        <translation>В программе ошибки; программы ЧПУ нет.</translation>
    </message>
    <message>
        <source>Choose the control that the NC program is for (F8).</source>
        <translation>Выберите станок, для которого нужна программа ЧПУ (F8).</translation>
    </message>
    <message>
        <source>The NC text was changed by hand, and there is a new program to be written.</source>
        <translation>Текст ЧПУ изменён вручную, а программу пора записать заново.</translation>
    </message>
    <message>
        <source>Write anew, lose the changes</source>
        <translation>Записать заново, изменения пропадут</translation>
    </message>
    <message>
        <source>Keep the text</source>
        <translation>Оставить текст</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Ничего не записано.</translation>
    </message>
    <message>
        <source>The messages below say why.</source>
        <translation>Почему — в сообщениях ниже.</translation>
    </message>
    <message>
        <source>“%1” is no character that controls know; it is saved as UTF-8.</source>
        <translation>Знака «%1» станки не знают; он сохраняется в UTF-8.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Сообщения</translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation>Сообщения (%1)</translation>
    </message>
    <message>
        <source>The text has errors; it is no program that could be proved.</source>
        <translation>В тексте ошибки; такую программу доказать нельзя.</translation>
    </message>
    <message>
        <source>Save the NC program</source>
        <translation>Сохранить программу ЧПУ</translation>
    </message>
    <message>
        <source>NC programs (*.%1)</source>
        <translation>Программы ЧПУ (*.%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Все файлы (*)</translation>
    </message>
    <message>
        <source>The NC program was not saved: %1</source>
        <translation>Программа ЧПУ не сохранена: %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>&lt;b&gt;Edited by hand&lt;/b&gt;: nothing is certified any more. Verify proves the text as it stands.</source>
        <translation>&lt;b&gt;Изменено вручную&lt;/b&gt;: свидетельство больше не действует. «Проверить» докажет текст в его нынешнем виде.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Сохранено: %1.</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Свидетельство</translation>
    </message>
    <message>
        <source>%1: blocks: %2, at most %3 mm off the exact path (certified).</source>
        <translation>%1: кадров %2, отклонение от точной траектории не больше %3 мм (доказано).</translation>
    </message>
</context>
</TS>
