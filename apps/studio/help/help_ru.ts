<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>Help</name>
    <message>
        <source>Lines: L</source>
        <translation>Прямые: L</translation>
    </message>
    <message>
        <source>Circles: C</source>
        <translation>Окружности: C</translation>
    </message>
    <message>
        <source>Points: P</source>
        <translation>Точки: P</translation>
    </message>
    <message>
        <source>Coordinate systems</source>
        <translation>Системы координат</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>note</source>
        <translation>замечание</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Определения</translation>
    </message>
    <message>
        <source>Operands of unlike kinds may stand in any order, those of one kind in the order that says which is first. `X… Y…` may stand for any point. An element may be defined again; what is cut already stays. Green is what is defined.</source>
        <translation>Части разного рода стоят в любом порядке, части одного рода — в том, который говорит, что первое. Вместо любой точки можно написать `X… Y…`. Элемент можно задать снова; то, что уже вырезано, остаётся. Зелёное — то, что задаётся.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Сообщения</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>диалект</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>описание</translation>
    </message>
    <message>
        <source>and the program that uses it:</source>
        <translation>и программа, которая им пользуется:</translation>
    </message>
</context>
<context>
    <name>dgt::studio::HelpWindow</name>
    <message>
        <source>DGT Studio: help</source>
        <translation>DGT Studio: справка</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Поиск</translation>
    </message>
    <message>
        <source>A word, a form (L=PC), the code of a message (DGT0203); Ctrl+F</source>
        <translation>Слово, форма (L=PC), код сообщения (DGT0203); Ctrl+F</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Назад (Alt+влево)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Вперёд (Alt+вправо)</translation>
    </message>
</context>
</TS>
