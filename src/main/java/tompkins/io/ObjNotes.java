package tompkins.io;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What a mesh and its materials say that is not shown: one sentence for each kind, however often it comes. */
final class ObjNotes {

    /** What is wrong in a file, or not read. */
    private record Kind(String file, String what) {}

    /** How often it comes, and the first time: its line and what stands there; 0 and nothing if it has no place. */
    private record First(int count, int line, String value) {

        First and(First more) {
            return new First(count + more.count, line, value);
        }
    }

    private final Map<Kind, First> kinds = new LinkedHashMap<>();

    /** Notes that something in a file is not shown. */
    void add(String file, String what) {
        add(file, 0, what, "");
    }

    /** Notes that a value in a line of a file, counted from 1, is not what it must be. */
    void add(String file, int line, String what, String value) {
        kinds.merge(new Kind(file, what), new First(1, line, value), First::and);
    }

    /** The sentences. */
    List<String> sentences() {
        return kinds.entrySet().stream()
                .map(entry -> sentence(entry.getKey(), entry.getValue()))
                .toList();
    }

    private static String sentence(Kind kind, First first) {
        String file = Problems.shortened(kind.file);
        boolean hasPlace = first.line > 0;
        String sentence = hasPlace
                ? file + ":" + first.line + ": " + kind.what + ", was " + Problems.quoted(first.value)
                : file + ": " + kind.what;
        String count = hasPlace ? " (first of " + first.count + ")" : " (" + first.count + " times)";
        return first.count == 1 ? sentence : sentence + count;
    }
}
