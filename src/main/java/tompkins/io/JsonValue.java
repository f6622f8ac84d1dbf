package tompkins.io;

import java.util.List;
import java.util.Map;

/** A value of a JSON text, with the place where it begins: line and column, from 1. */
sealed interface JsonValue {

    int line();

    int column();

    /** The value as a message shows it, in words if it is long. */
    String shown();

    /** A text. */
    record JsonText(int line, int column, String text) implements JsonValue {
        @Override
        public String shown() {
            return Problems.quoted(text);
        }
    }

    /** A number, as it is written; also {@code NaN} and the like. */
    record JsonNumber(int line, int column, String text) implements JsonValue {
        @Override
        public String shown() {
            return Problems.shortened(text);
        }
    }

    /** True or false. */
    record JsonFlag(int line, int column, boolean value) implements JsonValue {
        @Override
        public String shown() {
            return Boolean.toString(value);
        }
    }

    /** The value {@code null}. */
    record JsonNull(int line, int column) implements JsonValue {
        @Override
        public String shown() {
            return "null";
        }
    }

    /** A list in brackets. */
    record JsonList(int line, int column, List<JsonValue> values) implements JsonValue {
        @Override
        public String shown() {
            return "a list of " + values.size() + (values.size() == 1 ? " value" : " values");
        }
    }

    /** Keys with values, in braces; in the order of the file. */
    record JsonObject(int line, int column, Map<String, Member> members) implements JsonValue {
        @Override
        public String shown() {
            return "an object in braces";
        }
    }

    /** Other values for some parts of something that is there: what is not named stays as it is. */
    record JsonChange(JsonObject parts) implements JsonValue {
        @Override
        public int line() {
            return parts.line();
        }

        @Override
        public int column() {
            return parts.column();
        }

        @Override
        public String shown() {
            return "parts with names";
        }
    }

    /** A key of an object, its place, and its value. */
    record Member(int line, int column, JsonValue value) {}
}
