package tompkins.study;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Properties;

/** The words of studies, with their figures, from {@code studies.properties}. */
final class StudyText {

    private static final Properties TEXTS = read();

    private StudyText() {}

    private static Properties read() {
        Properties texts = new Properties();
        try (Reader file = new InputStreamReader(
                StudyText.class.getResourceAsStream("studies.properties"), StandardCharsets.UTF_8)) {
            texts.load(file);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
        return texts;
    }

    /** A text with its figures, put in as by {@link #format}. */
    static String of(String key, Object... figures) {
        return format(TEXTS.getProperty(key), figures);
    }

    /** A {@link String#format(String, Object...)} pattern with its figures, the same in all countries. */
    static String format(String pattern, Object... figures) {
        return String.format(Locale.ROOT, pattern, figures);
    }
}
