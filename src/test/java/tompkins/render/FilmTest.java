package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;

class FilmTest {

    @Test
    void aPixelIsTheMeanOfItsSamplesTimesTheExposure() {
        Film film = new Film(3, 2, true);
        film.add(1, 1, new Colour(0.25, 0.5, 1));
        film.add(1, 1, new Colour(0.75, 0, 3));

        LinearImage image = film.image(4);

        assertThat(image.value(1, 1, 0)).isEqualTo(2f);
        assertThat(image.value(1, 1, 1)).isEqualTo(1f);
        assertThat(image.value(1, 1, 2)).isEqualTo(8f);
    }

    @Test
    void withoutSamplesAPixelIsBlack() {
        LinearImage image = new Film(2, 2, true).image(1);

        assertThat(image.value(1, 1, 0) + image.value(1, 0, 1) + image.value(0, 1, 2))
                .isZero();
    }

    @Test
    void aPixelWithoutSampleShowsTheNearestCoarseOne() {
        Film film = new Film(20, 20, true);
        film.add(0, 0, Colour.grey(1));
        film.add(8, 0, Colour.grey(2));
        film.add(8, 8, Colour.grey(3));
        film.add(12, 8, Colour.grey(4));

        LinearImage image = film.image(1);

        assertThat(image.value(7, 7, 0)).isEqualTo(1f);
        assertThat(image.value(15, 7, 0)).isEqualTo(2f);
        assertThat(image.value(11, 15, 0)).isEqualTo(3f);
        assertThat(image.value(13, 11, 0)).isEqualTo(4f);
    }
}
