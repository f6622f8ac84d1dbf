package tompkins.image;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class PanoramaTest {

    private static final String GPANO = "http://ns.google.com/photos/1.0/panorama/";

    @TempDir
    private Path folder;

    /** The sphere of a picture of 300 x 200 pixels; it lies in the middle of it. */
    @ParameterizedTest
    @CsvSource({"360, 180, 300, 200, 0, 0", "90, 60, 1200, 600, 450, 200", "180, 180, 600, 200, 150, 0"})
    void theTextSaysWhichPartOfTheSphereIsShown(
            double longitudes, double latitudes, int width, int height, int left, int top) throws Exception {
        Element text = parsed(new Panorama(longitudes, latitudes).xmp(300, 200));

        assertThat(text.getAttributeNS(GPANO, "ProjectionType")).isEqualTo("equirectangular");
        assertThat(number(text, "FullPanoWidthPixels")).isEqualTo(width);
        assertThat(number(text, "FullPanoHeightPixels")).isEqualTo(height);
        assertThat(number(text, "CroppedAreaLeftPixels")).isEqualTo(left);
        assertThat(number(text, "CroppedAreaTopPixels")).isEqualTo(top);
        assertThat(number(text, "CroppedAreaImageWidthPixels")).isEqualTo(300);
        assertThat(number(text, "CroppedAreaImageHeightPixels")).isEqualTo(200);
    }

    @Test
    void aPngHoldsItBesideTheScene() throws Exception {
        Path file = folder.resolve("sky.png");
        PhotographInfo info = new PhotographInfo("Sky", "", "{}", Optional.of(new Panorama(360, 180)), false, "");

        PhotographFile.write(file, Samples.random(40, 20, 1), PictureFormat.PNG, ToneCurve.SRGB, info, true);

        ImageReader reader = ImageProviders.reader(PictureEncoding.PNG);
        reader.setInput(new MemoryCacheImageInputStream(Files.newInputStream(file)));
        NodeList entries = ((IIOMetadataNode) reader.getImageMetadata(0).getAsTree("javax_imageio_png_1.0"))
                .getElementsByTagName("iTXtEntry");
        assertThat(entries.getLength()).isEqualTo(2);
        Element entry = (Element) entries.item(1);
        assertThat(entry.getAttribute("keyword")).isEqualTo("XML:com.adobe.xmp");
        assertThat(entry.getAttribute("compressionFlag")).isEqualTo("FALSE");
        assertThat(number(parsed(entry.getAttribute("text")), "FullPanoWidthPixels"))
                .isEqualTo(40);
        assertThat(PhotographFile.readScene(file)).contains("{}");
    }

    private static Element parsed(String xmp) throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        return (Element) factory.newDocumentBuilder()
                .parse(new ByteArrayInputStream(xmp.getBytes(UTF_8)))
                .getElementsByTagNameNS("http://www.w3.org/1999/02/22-rdf-syntax-ns#", "Description")
                .item(0);
    }

    private static int number(Element text, String name) {
        return Integer.parseInt(text.getAttributeNS(GPANO, name));
    }
}
