package tompkins.io;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What a mesh and its materials say that is not shown: one sentence for each kind, however often it comes. */
final class ObjNotes {

    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** Notes that something in a file is not shown. */
    void add(String file, String what) {
        counts.merge(Problems.shortened(file) + ": " + what, 1, Integer::sum);
    }

    /** The sentences. */
    List<String> sentences() {
        return counts.entrySet().stream()
                .map(note -> note.getKey() + (note.getValue() == 1 ? "" : " (" + note.getValue() + " times)"))
                .toList();
    }
}
