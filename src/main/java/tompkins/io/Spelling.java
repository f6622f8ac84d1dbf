package tompkins.io;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;

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
        if (word.length() > LONGEST) {
            return "";
        }
        String best = null;
        int fewest = Integer.MAX_VALUE;
        for (String candidate : known) {
            int changes = changes(plain(word), plain(candidate));
            // a word that would have to change all its letters is not similar
            boolean like = changes <= Math.max(1, candidate.length() / 3)
                    && changes < plain(candidate).length();
            if (like && changes < fewest) {
                best = candidate;
                fewest = changes;
            }
        }
        return Optional.ofNullable(best)
                .or(() -> only(known, candidate -> isPart(word, candidate)))
                .or(() -> only(known, candidate -> beginsLike(word, candidate)))
                .map(meant -> "; did you mean \"" + meant + "\"?")
                .orElse("");
    }

    /** The known word that is like a word in some way, if there is exactly one. */
    private static Optional<String> only(Collection<String> known, Predicate<String> isLike) {
        List<String> like = known.stream().filter(isLike).toList();
        return like.size() == 1 ? Optional.of(like.get(0)) : Optional.empty();
    }

    private static boolean isPart(String part, String candidate) {
        return plain(part).length() >= SHORTEST_PART && plain(candidate).contains(plain(part));
    }

    /** Whether the first of several words written together is the same, as in angularVelocity and angularSpeed. */
    private static boolean beginsLike(String word, String candidate) {
        String first = word.split("(?=\\p{Lu})|[-_ ]", 2)[0];
        return first.length() >= SHORTEST_PART && first.length() < word.length() && candidate.startsWith(first);
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
