package tompkins.ui.help;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * A page of the documents that come with the program.
 *
 * @param url where it lies, in Markdown or plain text
 */
public record HelpPage(URL url) {

    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), HeadingAnchorExtension.create());

    /**
     * One of the program's own pages.
     *
     * @param name its file in the folder of documents
     */
    public static HelpPage of(String name) {
        return new HelpPage(HelpPage.class.getResource("/docs/" + name));
    }

    /** The page in HTML, with an identifier for each heading. */
    String html() {
        String content;
        try (InputStream in = url.openStream()) {
            content = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
        // code stays as it is, line by line
        String markdown = url.getPath().endsWith(".md") ? content : content.indent(4);
        return HtmlRenderer.builder()
                .extensions(EXTENSIONS)
                .build()
                .render(Parser.builder().extensions(EXTENSIONS).build().parse(markdown))
                // Swing leaves out white space between pictures, and does not break a line there by itself
                .replace("/>\n<img", "/><br><img")
                .replace("/> <img", "/>&nbsp; <img");
    }
}
