<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>ContourExample</name>
    <message>
        <source>Plate</source>
        <translation>Пластина</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Отверстие</translation>
    </message>
    <message>
        <source>Rounded corners (R)</source>
        <translation>Скругления (R)</translation>
    </message>
    <message>
        <source>Chamfered corners (V)</source>
        <translation>Фаски (V)</translation>
    </message>
    <message>
        <source>Lines and circles</source>
        <translation>Прямые и окружности</translation>
    </message>
    <message>
        <source>Tangents of circles (V)</source>
        <translation>Касательные к окружностям (V)</translation>
    </message>
    <message>
        <source>Circles joined by radii</source>
        <translation>Сопряжение окружностей</translation>
    </message>
    <message>
        <source>Turned by A: a hexagon</source>
        <translation>Поворот A: шестигранник</translation>
    </message>
    <message>
        <source>Coordinate system (O)</source>
        <translation>Система координат (O)</translation>
    </message>
    <message>
        <source>Another equidistant on the way (U)</source>
        <translation>Смена эквидистанты (U)</translation>
    </message>
    <message>
        <source>Cam with a loop (1P, 2P)</source>
        <translation>Цикл: кулачок (1P, 2P)</translation>
    </message>
    <message>
        <source>Star with variables (4P)</source>
        <translation>Переменные: звезда (4P)</translation>
    </message>
    <message>
        <source>Row of holes with a loop</source>
        <translation>Цикл: ряд отверстий</translation>
    </message>
    <message>
        <source>One outline twice (B)</source>
        <translation>Один контур дважды (B)</translation>
    </message>
    <message>
        <source>Slots by a macro (MAC)</source>
        <translation>Макрос: пазы (MAC)</translation>
    </message>
</context>
<context>
    <name>DefinitionForm</name>
    <message>
        <source>Upright line through X</source>
        <translation>Вертикальная прямая через X</translation>
    </message>
    <message>
        <source>Level line through Y</source>
        <translation>Горизонтальная прямая через Y</translation>
    </message>
    <message>
        <source>Line through two places</source>
        <translation>Прямая через два места</translation>
    </message>
    <message>
        <source>Line through two points</source>
        <translation>Прямая через две точки</translation>
    </message>
    <message>
        <source>Line through a place, parallel to a line</source>
        <translation>Прямая через место, параллельная прямой</translation>
    </message>
    <message>
        <source>Line through a point, parallel to a line</source>
        <translation>Прямая через точку, параллельная прямой</translation>
    </message>
    <message>
        <source>Line parallel to a line at distance D; D &gt; 0 lies left of it</source>
        <translation>Прямая, параллельная прямой на расстоянии D; D &gt; 0 — слева от неё</translation>
    </message>
    <message>
        <source>Line from a place, tangent to a circle</source>
        <translation>Прямая из места, касательная к окружности</translation>
    </message>
    <message>
        <source>Line from a point, tangent to a circle</source>
        <translation>Прямая из точки, касательная к окружности</translation>
    </message>
    <message>
        <source>Line through a place at an angle to the X axis</source>
        <translation>Прямая через место под углом к оси X</translation>
    </message>
    <message>
        <source>Line through a point at an angle to the X axis</source>
        <translation>Прямая через точку под углом к оси X</translation>
    </message>
    <message>
        <source>Line tangent to a circle at an angle to the X axis</source>
        <translation>Прямая, касательная к окружности, под углом к оси X</translation>
    </message>
    <message>
        <source>Line tangent to two circles</source>
        <translation>Прямая, касательная к двум окружностям</translation>
    </message>
    <message>
        <source>Line through a point that crosses a line at an angle</source>
        <translation>Прямая через точку, пересекающая прямую под углом</translation>
    </message>
    <message>
        <source>Circle about a place; R &gt; 0 runs counter-clockwise, R &lt; 0 clockwise</source>
        <translation>Окружность вокруг места; R &gt; 0 — против часовой стрелки, R &lt; 0 — по часовой</translation>
    </message>
    <message>
        <source>Circle about a point; R &gt; 0 runs counter-clockwise, R &lt; 0 clockwise</source>
        <translation>Окружность вокруг точки; R &gt; 0 — против часовой стрелки, R &lt; 0 — по часовой</translation>
    </message>
    <message>
        <source>Circle through three places</source>
        <translation>Окружность через три места</translation>
    </message>
    <message>
        <source>Circle through three points</source>
        <translation>Окружность через три точки</translation>
    </message>
    <message>
        <source>Circle of radius R tangent to two lines</source>
        <translation>Окружность радиуса R, касательная к двум прямым</translation>
    </message>
    <message>
        <source>Circle of radius R tangent to a line and a circle</source>
        <translation>Окружность радиуса R, касательная к прямой и окружности</translation>
    </message>
    <message>
        <source>The other circle of radius R tangent to a line and a circle</source>
        <translation>Вторая окружность радиуса R, касательная к прямой и окружности</translation>
    </message>
    <message>
        <source>Circle of radius R tangent to two circles</source>
        <translation>Окружность радиуса R, касательная к двум окружностям</translation>
    </message>
    <message>
        <source>The other circle of radius R tangent to two circles</source>
        <translation>Вторая окружность радиуса R, касательная к двум окружностям</translation>
    </message>
    <message>
        <source>Circle of radius R at distance M from a point, in the direction of the angle</source>
        <translation>Окружность радиуса R на расстоянии M от точки в направлении угла</translation>
    </message>
    <message>
        <source>Point at a place</source>
        <translation>Точка по координатам</translation>
    </message>
    <message>
        <source>Centre of a circle</source>
        <translation>Центр окружности</translation>
    </message>
    <message>
        <source>Where two lines cross</source>
        <translation>Пересечение двух прямых</translation>
    </message>
    <message>
        <source>Where a line enters a circle</source>
        <translation>Где прямая входит в окружность</translation>
    </message>
    <message>
        <source>Where a line leaves a circle (I2)</source>
        <translation>Где прямая выходит из окружности (I2)</translation>
    </message>
    <message>
        <source>Where the first circle enters the second</source>
        <translation>Где первая окружность входит во вторую</translation>
    </message>
    <message>
        <source>Where the first circle leaves the second (I2)</source>
        <translation>Где первая окружность выходит из второй (I2)</translation>
    </message>
    <message>
        <source>Point at distance M from a point, in the direction of the angle</source>
        <translation>Точка на расстоянии M от точки в направлении угла</translation>
    </message>
    <message>
        <source>Coordinate system: its origin and how far it is turned</source>
        <translation>Система координат: её начало и угол поворота</translation>
    </message>
    <message>
        <source>Coordinate system at a point, turned by an angle</source>
        <translation>Система координат в точке, повёрнутая на угол</translation>
    </message>
</context>
<context>
    <name>dgt::studio::TemplateBar</name>
    <message>
        <source>This is no definition.</source>
        <translation>Это не определение.</translation>
    </message>
    <message>
        <source>%1%2 is not defined in the program yet.</source>
        <translation>%1%2 в программе ещё не задан.</translation>
    </message>
    <message>
        <source>Space: next value. Esc: done.</source>
        <translation>Пробел — дальше, Esc — конец.</translation>
    </message>
</context>
<context>
    <name>dgt::studio::WizardPanel</name>
    <message>
        <source>Lines</source>
        <translation>Прямые</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Окружности</translation>
    </message>
    <message>
        <source>Points and coordinate systems</source>
        <translation>Точки и системы координат</translation>
    </message>
    <message>
        <source>Examples of contours</source>
        <translation>Примеры контуров</translation>
    </message>
    <message>
        <source>&amp;Insert into the program</source>
        <translation>&amp;Вставить в программу</translation>
    </message>
    <message>
        <source>Numbers that the program has already are replaced by free ones.</source>
        <translation>Номера, которые в программе уже заняты, заменяются свободными.</translation>
    </message>
</context>
</TS>
