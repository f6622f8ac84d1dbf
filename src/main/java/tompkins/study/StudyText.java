package tompkins.study;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Properties;

/** The sentences of studies, from {@code studies.properties}. */
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

    /** A text with its figures, which are put in as by {@link Finding#text}. */
    static String of(String key, Object... figures) {
        return Finding.text(TEXTS.getProperty(key), figures);
    }
}
