package tompkins.io;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Finds the word that may have been meant. */
public final class Spelling {

    private static final int LONGEST = 60;

    /** Shorter words are parts of too many others. */
    private static final int SHORTEST_PART = 4;

    private Spelling() {}

    /**
     * The end of a message, {@code ; did you mean "..."?} with the most similar known word, or else the only one of
     * which the word is a part; empty if there is none.
     */
    public static String hint(String word, Collection<String> known) {
        if (word.length() > LONGEST) {
            return "";
        }
        String wanted = plain(word);
        List<String> longer = known.stream()
                .filter(name -> wanted.length() >= SHORTEST_PART && plain(name).contains(wanted))
                .toList();
        return known.stream()
                .filter(name -> isSimilar(wanted, plain(name)))
                .min(Comparator.comparingInt(name -> changes(wanted, plain(name))))
                .or(() -> longer.stream().findFirst().filter(only -> longer.size() == 1))
                .map(Spelling::meant)
                .orElse("");
    }

    private static boolean isSimilar(String word, String name) {
        // a word that would have to change all its letters is not similar
        return changes(word, name) <= Math.min(Math.max(1, name.length() / 3), name.length() - 1);
    }

    /** The end of a message with what may have been meant. */
    static String meant(String name) {
        return "; did you mean \"" + name + "\"?";
    }

    private static String plain(String word) {
        return word.toLowerCase(Locale.ROOT).replaceAll("[-_ ]", "");
    }

    /** Letters to insert, delete, replace or swap with their neighbours (distance of Damerau and Levenshtein). */
    static int changes(String from, String to) {
        int[][] distance = new int[from.length() + 1][to.length() + 1];
        for (int i = 0; i <= from.length(); i++) {
            for (int j = 0; j <= to.length(); j++) {
                distance[i][j] = i == 0 || j == 0 ? i + j : step(distance, from, to, i, j);
            }
        }
        return distance[from.length()][to.length()];
    }

    private static int step(int[][] distance, String from, String to, int i, int j) {
        char a = from.charAt(i - 1);
        char b = to.charAt(j - 1);
        int replaced = distance[i - 1][j - 1] + (a == b ? 0 : 1);
        int least = Math.min(replaced, 1 + Math.min(distance[i - 1][j], distance[i][j - 1]));
        boolean swapped = i > 1 && j > 1 && a == to.charAt(j - 2) && b == from.charAt(i - 2);
        return swapped ? Math.min(least, distance[i - 2][j - 2] + 1) : least;
    }
}
