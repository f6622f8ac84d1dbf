package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.file.FileException;

class PictureFormatTest {

    @ParameterizedTest
    @CsvSource({"a.png, PNG", "a.b.PNG, PNG", "x/a.tif, TIFF", "a.Tiff, TIFF", "a.hdr, HDR", "a.pic, HDR"})
    void theEndingOfTheNameTellsTheFormat(String file, PictureFormat format) throws FileException {
        assertThat(PictureFormat.of(Path.of(file))).isEqualTo(format);
    }

    @ParameterizedTest
    @CsvSource({"a.jpg", "png", "a.png.txt", "a", "folder.png/a"})
    void otherNamesAreRefusedWithThoseThatAreAllowed(String file) {
        assertThatThrownBy(() -> PictureFormat.of(Path.of(file)))
                .isInstanceOf(FileException.class)
                .hasMessage(file + ": the name of a photograph must end in .png or .tif or .tiff or .hdr or .pic");
    }

    @ParameterizedTest
    @CsvSource({".png", ".TIFF", "folder/.hdr"})
    void anEndingAloneIsNoName(String file) {
        assertThatThrownBy(() -> PictureFormat.of(Path.of(file)))
                .isInstanceOf(FileException.class)
                .hasMessage(Path.of(file) + ": the name of a photograph is missing before the ending");
    }

    @Test
    void aNameMustFitTheChosenFormat() throws FileException {
        PictureFormat.PNG16.requireFor(Path.of("a.png"));
        PictureFormat.TIFF_FLOAT.requireFor(Path.of("a.TIFF"));
        assertThatThrownBy(() -> PictureFormat.TIFF_FLOAT.requireFor(Path.of("a.png")))
                .isInstanceOf(FileException.class)
                .hasMessage("a.png: the name of a floating-point TIFF picture must end in .tif or .tiff");
    }
}
