<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>Colours</name>
    <message>
        <source>Drawing: background</source>
        <translation>Чертёж: фон</translation>
    </message>
    <message>
        <source>Drawing: grid</source>
        <translation>Чертёж: сетка</translation>
    </message>
    <message>
        <source>Drawing: axes</source>
        <translation>Чертёж: оси</translation>
    </message>
    <message>
        <source>Programmed contour</source>
        <translation>Безэквидистантный контур</translation>
    </message>
    <message>
        <source>Equidistant</source>
        <translation>Эквидистанта</translation>
    </message>
    <message>
        <source>Rapid moves</source>
        <translation>Холостые ходы</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Инструмент</translation>
    </message>
    <message>
        <source>Moves of the current line</source>
        <translation>Ходы текущей строки</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>Контрольные точки</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Измерения</translation>
    </message>
    <message>
        <source>Text: background</source>
        <translation>Текст: фон</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <source>Elements L C P O</source>
        <translation>Элементы L C P O</translation>
    </message>
    <message>
        <source>Quantities and numbers</source>
        <translation>Величины и числа</translation>
    </message>
    <message>
        <source>Operators and commands</source>
        <translation>Операторы и команды</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Переменные</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Комментарии</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Ошибки</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Предупреждения</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Замечания</translation>
    </message>
    <message>
        <source>Line with the cursor</source>
        <translation>Строка с курсором</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>Найденные места</translation>
    </message>
    <message>
        <source>Line numbers</source>
        <translation>Номера строк</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>%1 is no file.</source>
        <translation>%1 — не файл.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB, too large to be edited. The command dgt takes files of any size.</source>
        <translation>%1 больше %2 МБ, это слишком много для редактора. Команда dgt принимает файлы любого размера.</translation>
    </message>
    <message>
        <source>%1 is saved as UTF-16 (“Unicode”). Save it as UTF-8 in the program it comes from.</source>
        <translation>%1 сохранён в UTF-16 («Юникод»). Сохраните его как UTF-8 в той программе, где он создан.</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>нет такого файла или папки</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>нет прав доступа</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>диск только для чтения</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>на диске нет места</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>это папка</translation>
    </message>
    <message>
        <source>the disk failed</source>
        <translation>ошибка диска</translation>
    </message>
    <message>
        <source>%1 has lines of more than %2 characters and is no program.</source>
        <translation>В %1 есть строки длиннее %2 знаков; это не программа.</translation>
    </message>
</context>
<context>
    <name>Print</name>
    <message>
        <source>page %1</source>
        <translation>стр. %1</translation>
    </message>
    <message>
        <source>Print %1</source>
        <translation>Печать %1</translation>
    </message>
</context>
<context>
    <name>dgt::studio::Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Новый</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Открыть…</translation>
    </message>
    <message>
        <source>&amp;Read from tape…</source>
        <translation>С&amp;читка с перфоленты…</translation>
    </message>
    <message>
        <source>&amp;Write to tape…</source>
        <translation>Запись на &amp;перфоленту…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Сохранить</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Сохранить &amp;как…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>П&amp;ечать…</translation>
    </message>
    <message>
        <source>Print the source, or save it as PDF</source>
        <translation>Напечатать исходный текст или сохранить его в PDF</translation>
    </message>
    <message>
        <source>Print &amp;drawing…</source>
        <translation>Печать чер&amp;тежа…</translation>
    </message>
    <message>
        <source>Print the drawing, or save it as PDF</source>
        <translation>Напечатать чертёж или сохранить его в PDF</translation>
    </message>
    <message>
        <source>&amp;Execute</source>
        <translation>&amp;Выполнить</translation>
    </message>
    <message>
        <source>Draw the program</source>
        <translation>Прорисовать программу</translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>Верну&amp;ть</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Вырезать</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Вст&amp;авить</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Выделить вс&amp;ё</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Найти…</translation>
    </message>
    <message>
        <source>&amp;Replace…</source>
        <translation>&amp;Заменить…</translation>
    </message>
    <message>
        <source>Find &amp;next</source>
        <translation>Найти &amp;следующее</translation>
    </message>
    <message>
        <source>Find &amp;previous</source>
        <translation>Найти &amp;предыдущее</translation>
    </message>
    <message>
        <source>&amp;Go to line…</source>
        <translation>Перейти к с&amp;троке…</translation>
    </message>
    <message>
        <source>&amp;Complete word</source>
        <translation>&amp;Дополнить слово</translation>
    </message>
    <message>
        <source>For&amp;mat</source>
        <translation>&amp;Форматировать</translation>
    </message>
    <message>
        <source>Fix &amp;error</source>
        <translation>&amp;Исправить ошибку</translation>
    </message>
    <message>
        <source>Put the proposed fix of the line in place</source>
        <translation>Внести предложенное исправление строки</translation>
    </message>
    <message>
        <source>Next me&amp;ssage</source>
        <translation>Следующее соо&amp;бщение</translation>
    </message>
    <message>
        <source>Previous mess&amp;age</source>
        <translation>Предыдущее сооб&amp;щение</translation>
    </message>
    <message>
        <source>C&amp;olours…</source>
        <translation>&amp;Цвета…</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Крупнее</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>&amp;Мельче</translation>
    </message>
    <message>
        <source>S&amp;tandard</source>
        <translation>&amp;Обычный</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Светлая</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Тёмная</translation>
    </message>
    <message>
        <source>&amp;Machine settings…</source>
        <translation>Параметры &amp;станка…</translation>
    </message>
    <message>
        <source>&amp;Internal form</source>
        <translation>&amp;Внутренний формат</translation>
    </message>
    <message>
        <source>The program in its internal form</source>
        <translation>Текст программы во внутреннем формате</translation>
    </message>
    <message>
        <source>Control &amp;points</source>
        <translation>Контрольные &amp;точки</translation>
    </message>
    <message>
        <source>The calculated control points</source>
        <translation>Рассчитанные контрольные точки</translation>
    </message>
    <message>
        <source>D&amp;raw</source>
        <translation>&amp;Прорисовка</translation>
    </message>
    <message>
        <source>Draw the path of the program</source>
        <translation>Прорисовать траекторию программы</translation>
    </message>
    <message>
        <source>&amp;NC program</source>
        <translation>Программа &amp;ЧПУ</translation>
    </message>
    <message>
        <source>The program for a control</source>
        <translation>Программа в формате системы ЧПУ</translation>
    </message>
    <message>
        <source>Draw the path with the contour as programmed</source>
        <translation>Прорисовать траекторию с безэквидистантным контуром</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Меню</translation>
    </message>
    <message>
        <source>&amp;Help on the word</source>
        <translation>&amp;Справка о слове</translation>
    </message>
    <message>
        <source>Explain the word at the cursor</source>
        <translation>Объяснить слово под курсором</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>Сп&amp;равочник</translation>
    </message>
    <message>
        <source>Hot &amp;keys</source>
        <translation>&amp;Горячие клавиши</translation>
    </message>
    <message>
        <source>&amp;About DGT Studio</source>
        <translation>&amp;О программе DGT Studio</translation>
    </message>
    <message>
        <source>Duplicate tape…</source>
        <translation>&amp;Дублирование перфоленты…</translation>
    </message>
    <message>
        <source>Draw while t&amp;yping</source>
        <translation>П&amp;рорисовка при вводе</translation>
    </message>
    <message>
        <source>Programmed &amp;contour</source>
        <translation>&amp;Безэквидистантный контур</translation>
    </message>
</context>
<context>
    <name>dgt::studio::ColoursDialog</name>
    <message>
        <source>Colours</source>
        <translation>Цвета</translation>
    </message>
    <message>
        <source>Standard colours</source>
        <translation>Обычные цвета</translation>
    </message>
</context>
<context>
    <name>dgt::studio::Documents</name>
    <message>
        <source>Unsaved text cannot be kept for recovery: %1</source>
        <translation>Несохранённый текст не удаётся сберечь для восстановления: %1</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>Новая программа</translation>
    </message>
    <message>
        <source>DGT Studio</source>
        <translation>DGT Studio</translation>
    </message>
    <message>
        <source>Programs (*.bgt *.dgt *.BGT *.DGT)</source>
        <translation>Программы (*.bgt *.dgt *.BGT *.DGT)</translation>
    </message>
    <message>
        <source>Macros (*.mac *.MAC)</source>
        <translation>Макросы (*.mac *.MAC)</translation>
    </message>
    <message>
        <source>NC programs (*.ess *.essi *.nc *.cnc *.gcode *.ngc *.tap *.3b)</source>
        <translation>Программы ЧПУ (*.ess *.essi *.nc *.cnc *.gcode *.ngc *.tap *.3b)</translation>
    </message>
    <message>
        <source>Polylines (*.poly)</source>
        <translation>Ломаные (*.poly)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Все файлы (*)</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved. Save them?</source>
        <translation>В %1 есть несохранённые изменения. Сохранить их?</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Открыть</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>ОК</translation>
    </message>
    <message>
        <source>The encoding of the file was guessed. If letters look wrong, choose another at the bottom of the window.</source>
        <translation>Кодировка файла выбрана предположительно. Если буквы выглядят неверно, выберите другую внизу окна.</translation>
    </message>
    <message>
        <source>Lines of the file end in different ways; saving makes them alike.</source>
        <translation>Строки файла оканчиваются по-разному; при сохранении концы станут одинаковыми.</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Сохранить как</translation>
    </message>
    <message>
        <source>The program was not saved. %1
Your text is still here; save it elsewhere.</source>
        <translation>Программа не сохранена. %1
Текст остался здесь; сохраните его в другом месте.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message>
        <source>%1 has been changed on disk by another program. Write over it?</source>
        <translation>Файл %1 на диске изменён другой программой. Записать поверх?</translation>
    </message>
    <message>
        <source>Write over</source>
        <translation>Записать поверх</translation>
    </message>
    <message>
        <source>The encoding %1 has no “%2”. Save the file as UTF-8?</source>
        <translation>В кодировке %1 нет «%2». Сохранить файл как UTF-8?</translation>
    </message>
    <message>
        <source>As UTF-8</source>
        <translation>Как UTF-8</translation>
    </message>
    <message>
        <source>With “?” instead</source>
        <translation>Со знаками «?»</translation>
    </message>
    <message>
        <source>%1 is no longer on disk. Your text is still here.</source>
        <translation>Файла %1 больше нет на диске. Текст остался здесь.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Оставить</translation>
    </message>
    <message>
        <source>%1 has been changed on disk, and here too.</source>
        <translation>Файл %1 изменён и на диске, и здесь.</translation>
    </message>
    <message>
        <source>%1 has been changed on disk.</source>
        <translation>Файл %1 изменён на диске.</translation>
    </message>
    <message>
        <source>Read it, give up mine</source>
        <translation>Прочитать, моё отбросить</translation>
    </message>
    <message>
        <source>Read it</source>
        <translation>Прочитать</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Оставить моё</translation>
    </message>
    <message>
        <source>The program ended without saving a new text of %1.</source>
        <translation>Программа завершилась, не сохранив новый текст от %1.</translation>
    </message>
    <message>
        <source>The program ended without saving %1, changed %2.</source>
        <translation>Программа завершилась, не сохранив %1, изменения от %2.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Восстановить</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Позже</translation>
    </message>
    <message>
        <source>Bytes of the file that are no text in this encoding: %1. Saving would lose them. Choose another encoding at the bottom of the window.</source>
        <translation>Байтов, которые не читаются в этой кодировке: %1. При сохранении они пропадут. Выберите другую кодировку внизу окна.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::MachineDialog</name>
    <message>
        <source>The setting %1 is wrong.</source>
        <translation>Параметр %1 задан неверно.</translation>
    </message>
    <message>
        <source>There is no dialect %1.</source>
        <translation>Нет диалекта %1.</translation>
    </message>
    <message>
        <source>The file has errors; it is not used.</source>
        <translation>В файле ошибки; он не применяется.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Строка %1: %2</translation>
    </message>
    <message>
        <source>Machine settings</source>
        <translation>Параметры станка</translation>
    </message>
    <message>
        <source>A machine file holds settings as TOML: the dialect, limits of the control, speeds, tape. Without one the standard settings hold.</source>
        <translation>Файл станка содержит параметры в формате TOML: диалект, пределы системы ЧПУ, скорости, перфоленту. Без него действуют обычные параметры.</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Выбрать…</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Нет</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>Файл станка</translation>
    </message>
    <message>
        <source>Machine files (*.toml)</source>
        <translation>Файлы станков (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Все файлы (*)</translation>
    </message>
</context>
<context>
    <name>dgt::studio::MainWindow</name>
    <message>
        <source>The compiler failed: %1</source>
        <translation>Сбой компилятора: %1</translation>
    </message>
    <message>
        <source>%1[*] – DGT Studio</source>
        <translation>%1[*] – DGT Studio</translation>
    </message>
    <message>
        <source>DGT Studio</source>
        <translation>DGT Studio</translation>
    </message>
    <message>
        <source>Exit DGT Studio?</source>
        <translation>Выйти из DGT Studio?</translation>
    </message>
    <message>
        <source>The program has errors; there is no NC program.</source>
        <translation>В программе ошибки; программы ЧПУ нет.</translation>
    </message>
    <message>
        <source>The machine file %1 is not used.</source>
        <translation>Файл станка %1 не применяется.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>ОК</translation>
    </message>
    <message>
        <source>Write “%1” instead of “%2”? This changes what is cut.</source>
        <translation>Записать «%1» вместо «%2»? Это изменит вырезаемый контур.</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Записать</translation>
    </message>
    <message>
        <source>The text has changed since.</source>
        <translation>Текст с тех пор изменился.</translation>
    </message>
    <message>
        <source>Only programs of DGT can be formatted.</source>
        <translation>Форматировать можно только программы на языке ДГТ.</translation>
    </message>
    <message>
        <source>Lines with errors cannot be formatted.</source>
        <translation>Строки с ошибками форматировать нельзя.</translation>
    </message>
    <message>
        <source>Go to line</source>
        <translation>Перейти к строке</translation>
    </message>
    <message>
        <source>Line:</source>
        <translation>Строка:</translation>
    </message>
    <message>
        <source>About DGT Studio</source>
        <translation>О программе DGT Studio</translation>
    </message>
    <message>
        <source>&lt;h3&gt;DGT Studio %1&lt;/h3&gt;&lt;p&gt;Exact contours for wire and plasma cutting.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;DGT Studio %1&lt;/h3&gt;&lt;p&gt;Точные контуры для проволочной и плазменной резки.&lt;/p&gt;&lt;p&gt;Свободная программа под Стандартной общественной лицензией GNU версии 3 или новее.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Nothing in this line has a fix.</source>
        <translation>В этой строке нечего исправить автоматически.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;Options</source>
        <translation>&amp;Опции</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Ок&amp;на</translation>
    </message>
    <message>
        <source>&amp;Font size</source>
        <translation>Ра&amp;змер шрифта</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Язык</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>Те&amp;ма</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Помощь</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Кнопки</translation>
    </message>
    <message>
        <source>Font size of the program</source>
        <translation>Размер шрифта программы</translation>
    </message>
    <message>
        <source>The NC program was changed by hand and is not saved. Save it?</source>
        <translation>Программа ЧПУ изменена вручную и не сохранена. Сохранить её?</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>Т&amp;екст</translation>
    </message>
</context>
<context>
    <name>dgt::studio::Panels</name>
    <message>
        <source>Drawing</source>
        <translation>Чертёж</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>Программа ЧПУ</translation>
    </message>
    <message>
        <source>Internal form</source>
        <translation>Внутренний формат</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>Контрольные точки</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Элементы</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Сообщения</translation>
    </message>
</context>
<context>
    <name>dgt::studio::StatusFields</name>
    <message>
        <source>Encoding of the file</source>
        <translation>Кодировка файла</translation>
    </message>
    <message>
        <source>Line ends of the file</source>
        <translation>Концы строк файла</translation>
    </message>
    <message>
        <source>What the compiler says</source>
        <translation>Что сообщает компилятор</translation>
    </message>
    <message>
        <source>&amp;Encoding</source>
        <translation>Код&amp;ировка</translation>
    </message>
    <message>
        <source>Read the file again as</source>
        <translation>Прочитать файл снова как</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Сохранить как</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>строка %1, столбец %2</translation>
    </message>
    <message>
        <source>no errors</source>
        <translation>ошибок нет</translation>
    </message>
    <message>
        <source>compiling…</source>
        <translation>компиляция…</translation>
    </message>
    <message>
        <source>errors: %1</source>
        <translation>ошибок: %1</translation>
    </message>
    <message>
        <source>warnings: %1</source>
        <translation>предупреждений: %1</translation>
    </message>
    <message>
        <source>Line end&amp;s</source>
        <translation>Концы строк (&amp;L)</translation>
    </message>
</context>
</TS>
