package tompkins.io;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Finds the word that may have been meant. */
public final class Spelling {

    private static final int LONGEST = 60;

    /** Shorter words are parts of too many others. */
    private static final int SHORTEST_PART = 4;

    private Spelling() {}

    /**
     * The end of a message, {@code ; did you mean "..."?} with the most similar of the known words; empty if none is
     * similar.
     */
    public static String hint(String word, Collection<String> known) {
        String best = null;
        int fewest = Integer.MAX_VALUE;
        for (String candidate : known) {
            int changes = word.length() > LONGEST ? fewest : changes(plain(word), plain(candidate));
            // a word that would have to change all its letters is not similar
            boolean like = changes <= Math.max(1, candidate.length() / 3)
                    && changes < plain(candidate).length();
            if (like && changes < fewest) {
                best = candidate;
                fewest = changes;
            }
        }
        return Optional.ofNullable(best)
                .or(() -> onlyWordWith(word, known))
                .map(meant -> "; did you mean \"" + meant + "\"?")
                .orElse("");
    }

    /** The known word of which a word is a part, if there is exactly one. */
    private static Optional<String> onlyWordWith(String part, Collection<String> known) {
        List<String> whole = known.stream()
                .filter(candidate -> plain(part).length() >= SHORTEST_PART
                        && plain(candidate).contains(plain(part)))
                .toList();
        return whole.size() == 1 ? Optional.of(whole.get(0)) : Optional.empty();
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
