<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>dgt::studio::DeviceBox</name>
    <message>
        <source>Tapes (*.tap *.txt);;All files (*)</source>
        <translation>Ленты (*.tap *.txt);;Все файлы (*)</translation>
    </message>
    <message>
        <source>Tape file</source>
        <translation>Файл ленты</translation>
    </message>
    <message>
        <source>&amp;File…</source>
        <translation>&amp;Файл…</translation>
    </message>
    <message>
        <source>A file in place of the device</source>
        <translation>Файл вместо устройства</translation>
    </message>
    <message>
        <source>The reader: a serial line, a character device, a tape file</source>
        <translation>Фотосчитыватель: последовательная линия, устройство, файл ленты</translation>
    </message>
    <message>
        <source>The punch: a serial line, a character device, a tape file</source>
        <translation>Перфоратор: последовательная линия, устройство, файл ленты</translation>
    </message>
</context>
<context>
    <name>dgt::studio::FormatBox</name>
    <message>
        <source>Leader:</source>
        <translation>Начальный ракорд:</translation>
    </message>
    <message>
        <source>Trailer:</source>
        <translation>Конечный ракорд:</translation>
    </message>
    <message>
        <source>Lettering:</source>
        <translation>Надпись:</translation>
    </message>
    <message>
        <source>Start:</source>
        <translation>Начало:</translation>
    </message>
    <message>
        <source>Line ends:</source>
        <translation>Концы строк:</translation>
    </message>
    <message>
        <source>Unknown characters:</source>
        <translation>Чужие знаки:</translation>
    </message>
    <message>
        <source>Checksum:</source>
        <translation>Контрольная сумма:</translation>
    </message>
    <message>
        <source>Before the start:</source>
        <translation>До начала:</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> мм</translation>
    </message>
    <message>
        <source>a line %</source>
        <translation>строка %</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>CR LF</source>
        <translation>CR LF</translation>
    </message>
    <message>
        <source>LF</source>
        <translation>LF</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>пропускаются</translation>
    </message>
    <message>
        <source>spelled in Latin letters</source>
        <translation>пишутся латиницей</translation>
    </message>
    <message>
        <source>a line before the %</source>
        <translation>строка до %</translation>
    </message>
    <message>
        <source>is checked</source>
        <translation>проверяется</translation>
    </message>
    <message>
        <source>may be anything</source>
        <translation>может быть что угодно</translation>
    </message>
    <message>
        <source>A text in holes before the %, for a person to read</source>
        <translation>Текст отверстиями до %, чтобы его прочёл человек</translation>
    </message>
</context>
<context>
    <name>dgt::studio::TapeDialog</name>
    <message>
        <source>Row %1, %2 mm, %3 s.</source>
        <translation>Строка %1, %2 мм, %3 с.</translation>
    </message>
    <message>
        <source>Row %1 of %2, %3 mm; %4 s left.</source>
        <translation>Строка %1 из %2, %3 мм; осталось %4 с.</translation>
    </message>
    <message>
        <source>Read a tape</source>
        <translation>Считка с перфоленты</translation>
    </message>
    <message>
        <source>Punch a tape</source>
        <translation>Запись на перфоленту</translation>
    </message>
    <message>
        <source>Copy a tape</source>
        <translation>Дублирование перфоленты</translation>
    </message>
    <message>
        <source>Rea&amp;der:</source>
        <translation>&amp;Фотосчитыватель:</translation>
    </message>
    <message>
        <source>P&amp;unch:</source>
        <translation>П&amp;ерфоратор:</translation>
    </message>
    <message>
        <source>F&amp;rom row:</source>
        <translation>С&amp;о строки:</translation>
    </message>
    <message>
        <source>Row 1 is the whole tape. A later row goes on with a tape that was not punched to its end, behind blank tape to be spliced.</source>
        <translation>Строка 1 — вся лента. С дальнейшей строки продолжают ленту, пробитую не до конца: после чистого куска для склейки.</translation>
    </message>
    <message>
        <source>Read &amp;twice and compare</source>
        <translation>Прочитать &amp;дважды и сравнить</translation>
    </message>
    <message>
        <source>&amp;Go on with what was read</source>
        <translation>Пр&amp;одолжить прочитанное</translation>
    </message>
    <message>
        <source>The tape begins anywhere before the place where the reading stopped.</source>
        <translation>Ленту начинают в любом месте до того, где чтение остановилось.</translation>
    </message>
    <message>
        <source>Layout of the tape</source>
        <translation>Вид ленты</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Лента</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Сообщения</translation>
    </message>
    <message>
        <source>&amp;Punch</source>
        <translation>&amp;Пробить</translation>
    </message>
    <message>
        <source>&amp;Punch the copy</source>
        <translation>&amp;Пробить копию</translation>
    </message>
    <message>
        <source>&amp;Read</source>
        <translation>С&amp;читать</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Стоп</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>&amp;Open with damaged rows marked</source>
        <translation>&amp;Открыть с отмеченными повреждениями</translation>
    </message>
    <message>
        <source>&amp;Open in the editor</source>
        <translation>&amp;Открыть в редакторе</translation>
    </message>
    <message>
        <source>Sa&amp;ve the tape…</source>
        <translation>Со&amp;хранить ленту…</translation>
    </message>
    <message>
        <source>As rows (.tap), as a picture in letters (.txt) or as a drawing (.svg, .png)</source>
        <translation>Строками (.tap), картинкой из букв (.txt) или рисунком (.svg, .png)</translation>
    </message>
    <message>
        <source>Lettering and checksum stand before the line %; the start has to be that line.</source>
        <translation>Надпись и контрольная сумма стоят до строки %; началом должна быть она.</translation>
    </message>
    <message>
        <source>%1 rows, %2 mm of tape.</source>
        <translation>Строк %1, %2 мм ленты.</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Идёт считка…</translation>
    </message>
    <message>
        <source>Punching…</source>
        <translation>Идёт запись…</translation>
    </message>
    <message>
        <source>Punched: %1 rows, %2 mm, on %3.</source>
        <translation>Записано: строк %1, %2 мм, %3.</translation>
    </message>
    <message>
        <source>Whole blocks are on the tape up to row %1, %2 mm (line %3 of the program). Cut it there; Punch goes on behind it.</source>
        <translation>Целые кадры на ленте до строки %1, %2 мм (строка программы %3). Отрежьте её там; «Пробить» продолжит дальше.</translation>
    </message>
    <message>
        <source>No whole block is on the tape; begin anew.</source>
        <translation>На ленте нет ни одного целого кадра; начните сначала.</translation>
    </message>
    <message>
        <source>What was read now does not hold the end of the reading before; begin the tape further ahead.</source>
        <translation>Прочитанное сейчас не содержит конца прошлого чтения; начните ленту раньше.</translation>
    </message>
    <message>
        <source>The end of the reading before fits in several places; begin the tape further ahead.</source>
        <translation>Конец прошлого чтения подходит в нескольких местах; начните ленту раньше.</translation>
    </message>
    <message>
        <source>This file holds no tape.</source>
        <translation>В этом файле нет ленты.</translation>
    </message>
    <message>
        <source>What was read so far is kept. Begin the tape anywhere before that place and read again.</source>
        <translation>Прочитанное сохранено. Начните ленту в любом месте до остановки и читайте снова.</translation>
    </message>
    <message>
        <source>Read: %1 rows. Put the tape in again and read it a second time.</source>
        <translation>Считано строк: %1. Заправьте ленту снова и считайте второй раз.</translation>
    </message>
    <message>
        <source>The second reading is not the first; nothing is taken.</source>
        <translation>Второе чтение не совпадает с первым; ничего не принято.</translation>
    </message>
    <message>
        <source>Read: %1 rows, %2 mm.</source>
        <translation>Считано: строк %1, %2 мм.</translation>
    </message>
    <message>
        <source>Now the copy can be punched.</source>
        <translation>Теперь можно пробить копию.</translation>
    </message>
    <message>
        <source>Save the tape</source>
        <translation>Сохранить ленту</translation>
    </message>
    <message>
        <source>Rows (*.tap);;Picture in letters (*.txt);;Drawing (*.svg);;Drawing (*.png)</source>
        <translation>Строки (*.tap);;Картинка из букв (*.txt);;Рисунок (*.svg);;Рисунок (*.png)</translation>
    </message>
    <message>
        <source>%1 rows are too many for one PNG; save SVG.</source>
        <translation>Строк %1 слишком много для одного PNG; сохраните SVG.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Сохранено: %1.</translation>
    </message>
    <message>
        <source>Damaged places: %1; the messages say where.</source>
        <translation>Повреждений: %1; где — в сообщениях.</translation>
    </message>
    <message>
        <source>This cannot be punched; the messages say why. Unknown characters can be left out, or spelled in Latin letters.</source>
        <translation>Это пробить нельзя; почему — в сообщениях. Чужие знаки можно пропустить или записать латиницей.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::TapeView</name>
    <message>
        <source>Row %1, %2 mm: %3
Holes in tracks: %4</source>
        <translation>Строка %1, %2 мм: %3
Отверстия на дорожках: %4</translation>
    </message>
    <message>
        <source>%1 · %2 mm</source>
        <translation>%1 · %2 мм</translation>
    </message>
</context>
</TS>
