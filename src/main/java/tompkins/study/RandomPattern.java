package tompkins.study;

import java.util.SplittableRandom;

/** Random positions: anywhere, or one in each cell of a grid. */
final class RandomPattern {

    private RandomPattern() {}

    /** {@link SamplingMethod#RANDOM}. */
    static SamplePattern.Pixels independent(SampledSpace space) {
        return random -> (sample, at) -> {
            if (space.hasPixel()) {
                at.x = random.nextDouble();
                at.y = random.nextDouble();
            }
            if (space.hasTime()) {
                at.moment = random.nextDouble();
            }
            if (space.hasLens()) {
                do {
                    at.lensX = 2 * random.nextDouble() - 1;
                    at.lensY = 2 * random.nextDouble() - 1;
                } while (at.lensX * at.lensX + at.lensY * at.lensY > 1);
            }
        };
    }

    /** {@link SamplingMethod#JITTERED}; cells of the pixel, the lens and the time are paired at random. */
    static SamplePattern.Pixels jittered(int samples, SampledSpace space) {
        Grid grid = Grid.of(samples);
        return random -> {
            int[] cells = space.hasPixel() ? SamplePattern.shuffled(samples, random) : null;
            int[] moments = space.hasTime() ? SamplePattern.shuffled(samples, random) : null;
            return (sample, at) -> {
                if (space.hasLens()) {
                    at.goToLens(grid.x(sample, random), grid.y(sample, random));
                }
                if (moments != null) {
                    at.moment = (moments[sample] + random.nextDouble()) / samples;
                }
                if (cells != null) {
                    at.x = grid.x(cells[sample], random);
                    at.y = grid.y(cells[sample], random);
                }
            };
        };
    }

    /** Cells of the unit square. */
    private record Grid(int columns, int rows) {

        static Grid of(int cells) {
            int columns = (int) Math.ceil(Math.sqrt(cells));
            return new Grid(columns, (cells + columns - 1) / columns);
        }

        double x(int cell, SplittableRandom random) {
            return (cell % columns + random.nextDouble()) / columns;
        }

        double y(int cell, SplittableRandom random) {
            return (cell / columns + random.nextDouble()) / rows;
        }
    }
}
