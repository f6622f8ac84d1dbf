package tompkins.ui;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import javax.swing.ImageIcon;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.Image;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * A page of the documents that come with the program.
 *
 * @param url where it lies, in Markdown or plain text
 */
record HelpPage(URL url) {

    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), HeadingAnchorExtension.create());

    /**
     * One of the program's own pages.
     *
     * @param name its file in the folder of documents
     */
    static HelpPage of(String name) {
        return new HelpPage(HelpPage.class.getResource("/docs/" + name));
    }

    /**
     * The page in HTML, with an identifier for each heading.
     *
     * @param widest the most pixels in a row of a picture; wider ones are made smaller
     */
    String html(int widest) {
        String content;
        try (InputStream in = url.openStream()) {
            content = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
        // figures stay as they are, line by line
        String markdown = url.getPath().endsWith(".md") ? content : content.indent(4);
        return HtmlRenderer.builder()
                .extensions(EXTENSIONS)
                .attributeProviderFactory(context -> (node, tag, attributes) -> {
                    if (node instanceof Image picture) {
                        attributes.putAll(size(picture, widest));
                    }
                })
                .build()
                .render(Parser.builder().extensions(EXTENSIONS).build().parse(markdown))
                // Swing does not break a line between pictures by itself
                .replace("/>\n<img", "/><br><img");
    }

    private Map<String, String> size(Image picture, int widest) {
        try {
            ImageIcon icon = new ImageIcon(new URL(url, picture.getDestination()));
            int width = Math.min(widest, icon.getIconWidth());
            int height = width * icon.getIconHeight() / icon.getIconWidth();
            return Map.of("width", Integer.toString(width), "height", Integer.toString(height));
        } catch (MalformedURLException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
