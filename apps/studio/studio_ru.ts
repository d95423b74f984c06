<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>dgt::studio::Language</name>
    <message>
        <source>en</source>
        <translation>ru</translation>
    </message>
</context>
</TS>
