package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.file.FileException;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;

/** Files as other programs write them. */
class ForeignPicturesTest {

    private static Path file(String name) {
        try {
            return Path.of(
                    ForeignPicturesTest.class.getResource("/pictures/" + name).toURI());
        } catch (URISyntaxException e) {
            throw new AssertionError(e);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "hdr-exposure.hdr, 0.25, 0.125, 0.0625",
        "hdr-flat.hdr, 1, 0.5, 0.25",
        "jpeg-linear-profile.jpg, 0.50196, 0.24706, 0.12157",
        "jpeg-no-profile.jpg, 0.50196, 0.24706, 0.12157",
        "png-linear-profile.png, 0.50196, 0.25098, 0.12549",
        "tiff-associated-alpha.tif, 0.78125, 0.39063, 0.19531",
        "tiff-grey-associated-alpha.tif, 0.78125, 0.78125, 0.78125"
    })
    void numbersAreThoseOfTheFile(String name, double red, double green, double blue) throws IOException {
        PixelPicture picture = PictureFile.read(file(name));
        for (double place : new double[] {0, 0.3, 0.6, 1}) {
            Colour colour = picture.colour(place, 1 - place);
            assertThat(new double[] {colour.red(), colour.green(), colour.blue()})
                    .containsExactly(new double[] {red, green, blue}, within(1e-5));
        }
    }

    @ParameterizedTest
    @CsvSource({"png-grey8-trns-level85.png, false", "silhouette-yellow.png, false", "silhouette-darkblue.png, true"})
    void aSilhouetteIsWhereItIsDarkAndOpaque(String name, boolean dark) throws IOException {
        assertThat(PictureFile.read(file(name)).isDark(0.5, 0.5)).isEqualTo(dark);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "png-grey2-trns-level1.png|has a transparent level of 2 bits; a PNG picture must have one of 8 or 16 bits;"
                        + " convert it, for example with ImageMagick or GIMP",
                "hdr-xyze.hdr|its colours are CIE XYZ (32-bit_rle_xyze), not red, green and blue (32-bit_rle_rgbe); save it as RGB",
                "bmp-no-blue-bits.bmp|is a BMP picture; allowed are PNG, JPEG, TIFF and Radiance HDR; convert it to PNG, for example with ImageMagick or GIMP",
                "tiff-12bit.tif|has unsigned samples of 12 bits; a TIFF picture must have unsigned ones of 8 or 16 bits, or of 1, 2, 4 or 8 for a palette or grey alone, or floating-point ones of 32 bits with 0 as black; convert it, for example with ImageMagick or GIMP",
                "tiff-12bit-rgb.tif|has unsigned samples of 12 bits; a TIFF picture must have unsigned ones of 8 or 16 bits, or of 1, 2, 4 or 8 for a palette or grey alone, or floating-point ones of 32 bits with 0 as black; convert it, for example with ImageMagick or GIMP",
                "tiff-14bit.tif|has unsigned samples of 14 bits; a TIFF picture must have unsigned ones of 8 or 16 bits, or of 1, 2, 4 or 8 for a palette or grey alone, or floating-point ones of 32 bits with 0 as black; convert it, for example with ImageMagick or GIMP",
                "tiff-palette-alpha.tif|has 2 samples a pixel for a palette; a TIFF picture must have one for each colour, and one more at most, for opacity, which a palette does not have; convert it, for example with ImageMagick or GIMP",
                "tiff-int8.tif|has signed samples of 8 bits; a TIFF picture must have unsigned ones of 8 or 16 bits, or of 1, 2, 4 or 8 for a palette or grey alone, or floating-point ones of 32 bits with 0 as black; convert it, for example with ImageMagick or GIMP",
                "tiff-float24.tif|has floating-point samples of 24 bits; a TIFF picture must have unsigned ones of 8 or 16 bits, or of 1, 2, 4 or 8 for a palette or grey alone, or floating-point ones of 32 bits with 0 as black; convert it, for example with ImageMagick or GIMP",
                "tiff-zstd.tif|has compression number 50000; a TIFF picture must have none (1), LZW (5), Deflate (8) or PackBits (32773); convert it, for example with ImageMagick or GIMP",
                "tiff-short-strip.tif|TIFF picture cannot be read: bytes are missing: strip 0 has 50, and needs 162",
                "tiff-sparse-tile.tif|TIFF picture cannot be read: bytes are missing: tile 5 has 0, and needs 256"
            })
    void whatIsNotReadIsRefusedForItsReason(String name, String reason) {
        assertThatThrownBy(() -> PictureFile.read(file(name)))
                .isInstanceOf(FileException.class)
                .hasMessage(name + ": " + reason);
    }

    /** Black above and white below as stored; the first row is the right column of the picture. */
    @Test
    void aPhotographHeldUprightIsUpright() throws IOException {
        byte[] stored = Files.readAllBytes(file("jpeg-exif6.jpg"));
        int upper = ImageProviders.image(PictureEncoding.JPEG, stored, "stored").getRGB(1, 1) & 0xff;
        assertThat(upper).isLessThan(16);

        PixelPicture picture = PictureFile.read(stored, "turned");

        for (double v : new double[] {0.1, 0.9}) {
            assertThat(picture.colour(0.9, v).green()).isLessThan(0.1);
            assertThat(picture.colour(0.1, v).green()).isGreaterThan(0.9);
        }
    }
}
