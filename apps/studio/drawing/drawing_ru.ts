<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>Measuring</name>
    <message>
        <source>free place</source>
        <translation>свободное место</translation>
    </message>
    <message>
        <source>end</source>
        <translation>конец</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>середина</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>центр</translation>
    </message>
    <message>
        <source>tangent</source>
        <translation>касание</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>перпендикуляр</translation>
    </message>
    <message>
        <source>on the contour</source>
        <translation>на контуре</translation>
    </message>
    <message>
        <source>Distance %1 mm</source>
        <translation>Расстояние %1 мм</translation>
    </message>
    <message>
        <source>dX %1</source>
        <translation>dX %1</translation>
    </message>
    <message>
        <source>dY %1</source>
        <translation>dY %1</translation>
    </message>
    <message>
        <source>angle %1°</source>
        <translation>угол %1°</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>радиус %1</translation>
    </message>
</context>
<context>
    <name>dgt::studio::Canvas</name>
    <message>
        <source>rapid</source>
        <translation>холостой ход</translation>
    </message>
    <message>
        <source>arc of the contour</source>
        <translation>дуга контура</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>дуга</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 мм</translation>
    </message>
    <message>
        <source>R%1</source>
        <translation>R%1</translation>
    </message>
    <message>
        <source>Measuring: click two places. Esc ends it.</source>
        <translation>Измерение: укажите два места. Esc — закончить.</translation>
    </message>
    <message>
        <source>straight line of the contour</source>
        <translation>отрезок контура</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>отрезок</translation>
    </message>
    <message>
        <source>%1. Click: line %2. Ctrl+click: zoom in.</source>
        <translation>%1. Щелчок: строка %2. Ctrl+щелчок: крупнее.</translation>
    </message>
    <message>
        <source>Click: zoom in, right click: out. Drag: move. Space: step. Enter: run.</source>
        <translation>Щелчок: крупнее, правый: мельче. Тянуть: сдвиг. Пробел: шаг. Enter: пуск.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::DrawingPanel</name>
    <message>
        <source>The whole part</source>
        <translation>Вся деталь</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Крупнее</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Мельче</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Показать</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Что рисуется</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Измерить</translation>
    </message>
    <message>
        <source>Distance, angle and radius between ends, middles, centres, tangents</source>
        <translation>Расстояние, угол и радиус между концами, серединами, центрами, точками касания</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>&amp;Сохранить рисунок…</translation>
    </message>
    <message>
        <source>The drawing as PNG, SVG, PDF or DXF</source>
        <translation>Чертёж в PNG, SVG, PDF или DXF</translation>
    </message>
    <message>
        <source>Drawing of the part</source>
        <translation>Чертёж детали</translation>
    </message>
    <message>
        <source>Space steps the tool, Shift+Space steps back, Enter runs it, plus and minus zoom, the arrows move the drawing, 0 shows the whole part.</source>
        <translation>Пробел — шаг инструмента, Shift+Пробел — шаг назад, Enter — пуск, плюс и минус — масштаб, стрелки сдвигают чертёж, 0 — вся деталь.</translation>
    </message>
    <message>
        <source>&amp;Programmed contour</source>
        <translation>&amp;Безэквидистантный контур</translation>
    </message>
    <message>
        <source>&amp;Rapid moves</source>
        <translation>&amp;Холостые перемещения</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>&amp;Инструмент</translation>
    </message>
    <message>
        <source>&amp;Kerf</source>
        <translation>&amp;Прорез</translation>
    </message>
    <message>
        <source>&amp;Directions</source>
        <translation>&amp;Направления</translation>
    </message>
    <message>
        <source>&amp;Control points</source>
        <translation>&amp;Контрольные точки</translation>
    </message>
    <message>
        <source>&amp;Elements and their names</source>
        <translation>&amp;Элементы и их имена</translation>
    </message>
    <message>
        <source>&amp;Sizes of the part</source>
        <translation>&amp;Габариты детали</translation>
    </message>
    <message>
        <source>&amp;Grid and axes</source>
        <translation>&amp;Сетка и оси</translation>
    </message>
    <message>
        <source>The drawing is of an earlier text. %1</source>
        <translation>Чертёж прежнего текста. %1</translation>
    </message>
    <message>
        <source>There is no drawing. %1</source>
        <translation>Чертежа нет. %1</translation>
    </message>
    <message>
        <source>Save the drawing</source>
        <translation>Сохранение чертежа</translation>
    </message>
    <message>
        <source>Drawings (*.png *.svg *.pdf *.dxf)</source>
        <translation>Чертежи (*.png *.svg *.pdf *.dxf)</translation>
    </message>
    <message>
        <source>The name has to end in .png, .svg, .pdf or .dxf: it says what kind of drawing is written.</source>
        <translation>Имя должно кончаться на .png, .svg, .pdf или .dxf: так задаётся вид чертежа.</translation>
    </message>
    <message>
        <source>Digits &amp;behind the point</source>
        <translation>&amp;Знаков после точки</translation>
    </message>
    <message>
        <source>As the &amp;machine</source>
        <translation>&amp;Как у станка</translation>
    </message>
    <message>
        <source>The drawing is being prepared…</source>
        <translation>Чертёж готовится…</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Строка %1: %2</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, строка %2: %3</translation>
    </message>
</context>
<context>
    <name>dgt::studio::InternalForm</name>
    <message>
        <source>Save the internal form</source>
        <translation>Сохранение внутреннего формата</translation>
    </message>
    <message>
        <source>Texts (*.txt);;All files (*)</source>
        <translation>Тексты (*.txt);;Все файлы (*)</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Найти</translation>
    </message>
    <message>
        <source>Text to find</source>
        <translation>Искомый текст</translation>
    </message>
    <message>
        <source>Find next (F3)</source>
        <translation>Найти дальше (F3)</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Найти дальше</translation>
    </message>
    <message>
        <source>Find previous (Shift+F3)</source>
        <translation>Найти раньше (Shift+F3)</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>Найти раньше</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>The chosen lines, or all of them (Ctrl+C)</source>
        <translation>Выбранные строки или все (Ctrl+C)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Сохранить…</translation>
    </message>
    <message>
        <source>All of it as a file</source>
        <translation>Всё в файл</translation>
    </message>
    <message>
        <source>Internal form of the program</source>
        <translation>Программа во внутреннем формате</translation>
    </message>
    <message>
        <source>The program has errors: this is of an earlier text.</source>
        <translation>В программе есть ошибки: показан формат прежнего текста.</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>Не найдено.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::PointsModel</name>
    <message>
        <source>start</source>
        <translation>начало</translation>
    </message>
    <message>
        <source>line</source>
        <translation>отрезок</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>дуга</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>холостой ход</translation>
    </message>
    <message>
        <source>Negative: clockwise</source>
        <translation>Отрицательный — по часовой стрелке</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>№</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Ход</translation>
    </message>
    <message>
        <source>Centre X</source>
        <translation>Центр X</translation>
    </message>
    <message>
        <source>Centre Y</source>
        <translation>Центр Y</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Радиус</translation>
    </message>
</context>
<context>
    <name>dgt::studio::PointsPanel</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>The chosen points as text, or all of them (Ctrl+C)</source>
        <translation>Выбранные точки текстом или все (Ctrl+C)</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>Контрольные точки</translation>
    </message>
    <message>
        <source>Points: %1</source>
        <translation>Точек: %1</translation>
    </message>
    <message>
        <source>The program has errors: they are of an earlier text.</source>
        <translation>В программе есть ошибки: точки прежнего текста.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::Readout</name>
    <message>
        <source>&amp;Zoom by a click:</source>
        <translation>&amp;Масштаб щелчка:</translation>
    </message>
    <message>
        <source>Factor by which a click magnifies</source>
        <translation>Во сколько раз увеличивает щелчок</translation>
    </message>
    <message>
        <source>X of the pointer, mm</source>
        <translation>X курсора, мм</translation>
    </message>
    <message>
        <source>Y of the pointer, mm</source>
        <translation>Y курсора, мм</translation>
    </message>
    <message>
        <source>Contour: what is programmed (W = 0). Path: what the tool cuts. Approaches and departures are counted in both.</source>
        <translation>Контур: как запрограммирован (W = 0). Траектория: что режет инструмент. Подходы и отходы входят в обе длины.</translation>
    </message>
    <message>
        <source>Contour %1 mm</source>
        <translation>Контур %1 мм</translation>
    </message>
    <message>
        <source>Path %1 mm</source>
        <translation>Траектория %1 мм</translation>
    </message>
    <message>
        <source>Rapids %1 mm</source>
        <translation>Холостой ход %1 мм</translation>
    </message>
    <message>
        <source>Part %1 × %2 mm</source>
        <translation>Деталь %1 × %2 мм</translation>
    </message>
</context>
<context>
    <name>dgt::studio::TransportBar</name>
    <message>
        <source>pause %1 s</source>
        <translation>пауза %1 с</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>В начало</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>A step back</source>
        <translation>Шаг назад</translation>
    </message>
    <message>
        <source>Shift+Space</source>
        <translation>Shift+Пробел</translation>
    </message>
    <message>
        <source>A step</source>
        <translation>Шаг</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Пробел</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>В конец</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Пуск</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Place of the tool on its way</source>
        <translation>Место инструмента на траектории</translation>
    </message>
    <message>
        <source>Speed of the run</source>
        <translation>Скорость показа</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> мм/с</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Шаг %1 из %2</translation>
    </message>
</context>
</TS>
