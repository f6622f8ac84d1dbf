package tompkins.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import org.junit.jupiter.api.Test;

/** Where Java puts the fields of what is padded. */
class PaddedTest {

    /** The length of a cache line, in bytes. */
    private static final long LINE = 64;

    @Test
    void fieldsLieALineBehindTheStart() throws ReflectiveOperationException {
        // by reflection, since javac warns of each mention of the class
        Class<?> unsafe = Class.forName("sun.misc.Unsafe");
        Field instance = unsafe.getDeclaredField("theUnsafe");
        instance.setAccessible(true);
        Method offset = unsafe.getMethod("objectFieldOffset", Field.class);
        for (Field field : RayCounts.class.getDeclaredFields()) {
            if (!Modifier.isStatic(field.getModifiers())) {
                assertThat((long) offset.invoke(instance.get(null), field))
                        .as(field.getName())
                        .isGreaterThanOrEqualTo(LINE);
            }
        }
    }
}
